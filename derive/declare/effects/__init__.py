"""Effects: drives, forces, springs, dampers, friction, films, gravity, contact; one file per kind."""
