"""Many runs of one model, and their table."""
