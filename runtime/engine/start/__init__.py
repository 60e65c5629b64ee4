"""Initial state: given values, closed loops, seated journals, the ideal mechanism."""
