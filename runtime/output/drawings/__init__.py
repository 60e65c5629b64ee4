"""Pictures of mechanisms, from the landmarks of their generated modules."""
