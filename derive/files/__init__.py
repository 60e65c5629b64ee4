"""User files: laws in TOML, scenes in Python, and their audit."""
