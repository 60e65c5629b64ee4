"""Parameters from measurements: least squares with exact Jacobians, intervals, what data cannot tell."""
