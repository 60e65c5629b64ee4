"""Histories that follow from a motion: reactions, forces on bodies, momenta, energies."""
