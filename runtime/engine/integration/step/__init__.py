"""One step: right-hand side, methods, friction, closed loops, step control."""
