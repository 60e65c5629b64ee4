"""Coefficients of the methods, as records that refuse to exist if an order condition fails."""
