"""Common ground of both sides: units, faults of inputs, names, TOML files, HTML; no SymPy."""
