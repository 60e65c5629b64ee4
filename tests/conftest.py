"""Settings of all tests."""

from hypothesis import settings

settings.register_profile("hertzwerk", deadline=None)  # a deadline would measure the machine's load
settings.load_profile("hertzwerk")
