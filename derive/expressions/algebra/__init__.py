"""Extensions of SymPy for equations of mechanisms: branches, vectors, splines, notation."""
