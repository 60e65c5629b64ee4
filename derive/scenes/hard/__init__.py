"""Scenes of the hard cases that no built-in scene has."""
