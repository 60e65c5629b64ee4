"""Parameters from statistics of long runs, and those of measured series."""
