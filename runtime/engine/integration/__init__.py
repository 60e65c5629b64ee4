"""Explicit and implicit methods, step control and event location as CasADi functions."""
