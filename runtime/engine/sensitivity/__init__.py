"""Exact first derivatives of a run with respect to parameters and starts, through impacts."""
