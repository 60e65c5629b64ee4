"""Declaration of a mechanism: parameters, bodies, joints, contact pairs."""
