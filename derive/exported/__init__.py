"""Equations of a scene for SymPy."""
