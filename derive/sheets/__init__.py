"""The sheets of laws: formulas, symbols, restitution, cost, for people and for JSON."""
