"""Tables with units and meanings, of runs and sweeps: as pandas and xarray objects, and as files."""
