"""One run: what is asked for, the engine, its accepted steps."""
