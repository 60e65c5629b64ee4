"""Output of runs: pictures, films, tables, pages."""
