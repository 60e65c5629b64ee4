"""Dimensions: rules, audit of expressions and of their text, and culprits of wrong units."""
