"""Commands on single runs, one file each: thin, they import what they run when called."""
