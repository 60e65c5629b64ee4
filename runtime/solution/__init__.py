"""What a run returns: histories, impacts, averages, outcome."""
