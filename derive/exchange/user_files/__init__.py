"""Files of users: laws in TOML, scenes in Python, robots in URDF; their audit."""
