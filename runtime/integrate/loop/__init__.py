"""Attempts, many in one call, and the choice of method and compiler on the way."""
