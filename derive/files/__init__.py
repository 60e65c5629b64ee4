"""Files of the user's: laws in TOML, scenes in Python, and their audit."""
