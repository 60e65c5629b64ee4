"""Studies of many runs: sweeps, uncertainty, minimisation, measured data, the paper's studies."""
