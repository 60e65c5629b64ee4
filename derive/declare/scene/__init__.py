"""Declaration of a scene, and its checks."""
