"""Contact laws (stiffness, damping, friction, film) and the catalogue `LAWS` of all of them by name.

Type checkers and editors read `__init__.pyi` beside this file, with the parameters of every law; `hertzwerk laws
--stub` writes it.
"""

from hertzwerk.derive.laws.catalogue import LAWS
from hertzwerk.derive.laws.law import Law

__all__ = ["LAWS", *sorted(LAWS)]  # the names of laws are text


def __getattr__(name: str) -> Law:
    """Return a law by name."""
    if name not in LAWS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}; `hertzwerk laws` lists the laws")
    return LAWS[name]


def __dir__() -> list[str]:
    """Return the names of all laws."""
    return __all__
