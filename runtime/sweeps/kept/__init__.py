"""Arrays that rows of a sweep keep: sections and histories."""
