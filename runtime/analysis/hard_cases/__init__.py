"""Hard cases: runs that are hard to keep stable, and the invariants that each must keep.

Each is run with every method that claims it, in CasADi's virtual machine and as C.
"""
