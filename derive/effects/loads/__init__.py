"""Loads by reactions, poses and belts: one kind, or kinds that share a base, in a file."""
