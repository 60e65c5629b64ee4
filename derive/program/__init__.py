"""The straight-line program, of which the functions of a module are slices."""
