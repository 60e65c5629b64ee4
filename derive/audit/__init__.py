"""Audit of laws, scenes and programs: units, and physical admissibility of the laws."""
