"""Generated modules as models: built, loaded, bound to numbers, called."""
