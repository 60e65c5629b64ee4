"""Comparisons as one command each: a sweep, its pictures and its verdicts."""
