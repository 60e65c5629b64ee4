"""Elasticity of bodies that bend."""
