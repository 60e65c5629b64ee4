"""Pictures of studies: accuracy against time, effects, laws, the band of a reconstruction."""
