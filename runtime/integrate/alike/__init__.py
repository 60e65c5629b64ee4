"""Expressions that are equal but for their inputs."""
