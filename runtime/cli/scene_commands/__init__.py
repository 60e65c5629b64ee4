"""Commands on scenes and laws, one file each: thin, they import what they run when called."""
