"""Result of a run: histories, impacts, averages, outcome."""
