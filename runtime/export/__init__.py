"""Export of a scene for other programs: a C library, a functional mock-up unit."""
