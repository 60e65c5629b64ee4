"""Analyses of one scene: statics, effects, accuracy against time, validation, hard cases."""
