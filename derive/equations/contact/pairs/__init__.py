"""Kinds of contact pairs, one file per family: what a pair declares, and how its surfaces touch."""
