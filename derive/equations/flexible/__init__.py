"""Bodies that bend: their motion and inertia along their own axes."""
