"""Sheets of laws: formulas, symbols, restitution and cost, for people and for JSON."""
