"""Parameters from measurements: least squares with exact Jacobians, intervals, identifiability."""
