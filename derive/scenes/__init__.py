"""Built-in scenes, one module each."""

from importlib import resources

_FILES = (entry.name for entry in resources.files(__name__).iterdir())
NAMES = tuple(sorted(name[:-3] for name in _FILES if name.endswith(".py") and not name.startswith("_")))
