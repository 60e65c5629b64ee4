"""The commands, one file each: thin, they import what they run when called."""
