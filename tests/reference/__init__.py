"""Independent oracles: hand-derived equations, closed forms, cited digits. Nothing here imports hertzwerk."""
