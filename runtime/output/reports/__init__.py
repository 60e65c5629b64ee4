"""Reports: one self-contained HTML page of a run, a model, a study; fragments for notebooks."""
