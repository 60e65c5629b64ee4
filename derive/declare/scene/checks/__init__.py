"""Checks of a scene's declarations, before anything is derived from it."""
