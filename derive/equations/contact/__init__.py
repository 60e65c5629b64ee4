"""Contact geometry of the pairs, and contact forces."""
