"""Study of effects: the cost of each effect of a scene, and the changes without it."""
