"""Coefficients of the methods, checked against their order conditions on construction."""
