"""Dimensions: their rules, the audit of expressions and of their text, and the culprit of a wrong unit."""
