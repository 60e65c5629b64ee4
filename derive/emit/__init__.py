"""A program as the text of a generated module."""
