"""What accuracy costs: runs timed fairly against a reference."""
