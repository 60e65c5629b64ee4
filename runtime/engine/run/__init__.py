"""One run: its settings, the engine, its accepted steps."""
