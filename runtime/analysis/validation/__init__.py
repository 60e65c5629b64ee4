"""Scenarios, their checks, and the restitution study."""
