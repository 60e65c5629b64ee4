"""Parts of equal declarations: which they are, and the program of one of each kind."""
