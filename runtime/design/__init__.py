"""Uncertainty of a run's numbers, and the best parameters for one."""
