"""Declaration of mechanisms, of the effects that act in them, and of scenes."""
