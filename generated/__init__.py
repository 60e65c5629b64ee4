"""One module per built-in scene, written by `hertzwerk derive`."""
