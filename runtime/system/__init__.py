"""Host system: files, cache, processes, signals."""
