"""Best parameters for a number of a run."""
