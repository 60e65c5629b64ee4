"""Many pairs: those of a kind in one vector, and those that are near."""
