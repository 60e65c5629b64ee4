"""Statics and small vibrations: equilibria, linearisation, modes."""
