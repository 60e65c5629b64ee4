"""Pictures of solutions and studies: every use of Matplotlib."""
