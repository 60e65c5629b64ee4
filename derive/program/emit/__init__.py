"""Text of a generated module from a program."""
