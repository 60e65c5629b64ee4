"""Error of a run, by a ladder of tolerances, and its horizon of prediction."""
