"""What SymPy lacks for the equations of mechanisms: branches, vectors, splines, notation."""
