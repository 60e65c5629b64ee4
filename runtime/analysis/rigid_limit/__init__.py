"""Rigid limit of a scene: impacts at an instant, closed contacts as constraints."""
