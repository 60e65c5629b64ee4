"""Mechanisms in motion: frames of a run, written as GIF, MP4 or HTML."""
