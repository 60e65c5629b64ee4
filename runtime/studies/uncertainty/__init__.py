"""Uncertainty of a run's numbers, from distributions of parameters and starts."""
