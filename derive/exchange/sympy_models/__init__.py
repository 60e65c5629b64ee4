"""Scenes from models of SymPy's mechanics, and equations of a scene for SymPy."""
