"""Limits of friction forces, and when those that feed on themselves are unique."""
