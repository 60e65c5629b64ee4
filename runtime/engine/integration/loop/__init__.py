"""Attempts, many in one call, and the choice of method and compilation during a run."""
