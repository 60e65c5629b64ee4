"""Published contact laws, a file for each kind."""
