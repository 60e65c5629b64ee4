"""Parameters, and expressions of them: algebra and dimensions."""
