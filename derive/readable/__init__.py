"""The equations of a scene as people read them: symbols, numbered equations, effects; Markdown, LaTeX, plain values."""
