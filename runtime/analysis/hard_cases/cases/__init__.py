"""Hard cases by theme."""
