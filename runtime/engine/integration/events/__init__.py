"""Events: their location within a step, and the mode changes that follow."""
