"""Plots of solutions, and what all plots share."""
