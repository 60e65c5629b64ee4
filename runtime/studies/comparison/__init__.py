"""Measured data beside a run: instrument, alignment, errors, statistics."""
