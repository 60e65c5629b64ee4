"""Engine: a model, one run of it, its error, its solution and its derivatives."""
