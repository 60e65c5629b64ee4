"""The hard cases: a named table of runs that are hard to keep stable, and the invariants that each must keep with every method, in both paths."""
