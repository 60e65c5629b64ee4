"""Multiple shooting: measured runs in segments."""
