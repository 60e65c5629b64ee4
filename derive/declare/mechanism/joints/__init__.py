"""Kinds of joints, one file per kind or family."""
