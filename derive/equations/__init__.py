"""Equations of a scene: from its declaration to the audited program of a module."""
