"""The declaration of a scene, and everything that can be wrong with it."""
