"""Parts of a scene that are alike: which they are, and the program of one of each kind."""
