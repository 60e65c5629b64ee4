"""What is wrong with a scene, before anything is derived from it."""
