"""Readings of a run beyond its states, derived when the first of them is asked for."""
