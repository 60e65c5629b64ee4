"""Points of a sweep: their design, its definition as plain data, and the keys of rows."""
