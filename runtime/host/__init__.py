"""What the computer gives: files, cache, processes, signals."""
