"""The error of a run: a ladder of tolerances, and the horizon of prediction."""
