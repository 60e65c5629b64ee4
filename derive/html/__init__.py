"""HTML by construction, formulas as MathML, and plain tables: what notebooks and reports show."""
