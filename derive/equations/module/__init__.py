"""Functions and tables of a generated module, by topic."""
