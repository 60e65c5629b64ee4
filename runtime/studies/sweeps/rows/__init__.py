"""Rows of a sweep: their job, processes and workers, outputs, arrays."""
