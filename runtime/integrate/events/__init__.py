"""Events: where they are in a step, and what follows."""
