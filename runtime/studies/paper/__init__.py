"""Comparisons as one command each, the paper's and users': question, figures, verdicts."""
