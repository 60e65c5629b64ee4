"""A mechanism's declaration: parameters, bodies, joints, contact pairs."""
