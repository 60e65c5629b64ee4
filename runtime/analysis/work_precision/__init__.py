"""Work and precision: runs timed fairly, their errors measured against a reference."""
