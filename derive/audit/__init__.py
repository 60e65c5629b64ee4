"""The audit of laws, scenes and programs: units, and the physics that every law owes."""
