"""Measured data beside a run: reading, instrument, alignment, errors, statistics."""
