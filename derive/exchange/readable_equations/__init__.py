"""Equations of a scene for readers: symbols, numbered equations, effects; as Markdown, LaTeX, values."""
