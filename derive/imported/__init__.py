"""Mechanisms whose motion is given by expressions, such as those of SymPy's mechanics."""
