"""Contact laws (stiffness, damping, friction, film) and the catalogue `LAWS` of all of them by name.

Type checkers and editors read `__init__.pyi` beside this file, with the parameters of every law; `hertzwerk laws
--stub` writes it.
"""

from hertzwerk.derive.laws.catalogue import LAWS

globals().update(LAWS)

__all__ = ["LAWS", *sorted(LAWS)]  # the names of laws are text
