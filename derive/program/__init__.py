"""The straight-line program that a module's functions are slices of."""
