"""Scenes of the hard cases that are no built-in scenes."""
