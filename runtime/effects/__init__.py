"""What each effect of a scene costs, and what it changes: found by leaving out each in turn."""
