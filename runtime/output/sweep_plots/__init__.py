"""Plots of sweeps, of a propagation and of a minimisation."""
