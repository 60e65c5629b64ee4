"""Exchange with people and other programs: law files, URDF, SymPy, equations and laws to read."""
