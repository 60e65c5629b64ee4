"""Symbols with attributes: parameters, quantities of laws, states, inputs, poses."""

from __future__ import annotations

from typing import Any, ClassVar, Self

import sympy as sp

from hertzwerk.derive.common.faults import Fault, refuse


class Tagged(sp.Symbol):  # type: ignore[misc]  # SymPy is untyped
    """Real symbol with attributes, `tags`; symbols that differ in one are different.

    It never comes from SymPy's cache.
    """

    __slots__ = ()
    tags: ClassVar[tuple[str, ...]]
    """Names of the attributes, in the order in which the class is called with them."""

    def __new__(cls, name: str, *values: Any) -> Self:
        """Make a new symbol."""
        self = sp.Symbol.__xnew__(cls, name, real=True)
        for tag, value in zip(cls.tags, values, strict=True):
            setattr(self, tag, value)
        return self  # type: ignore[no-any-return]

    @classmethod
    def must_be_text(cls, kind: str, name: object, **texts: object) -> None:
        """Raise InputError, listing every fault, for what is no text."""
        entries = {"name": name, **texts}
        refuse(
            f"{kind} {name!r:.40}",
            [Fault(f"{kind}, {label}", repr(x), "text") for label, x in entries.items() if not isinstance(x, str)],
        )

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, *(repr(getattr(self, tag)) for tag in self.tags))

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name, *(getattr(self, tag) for tag in self.tags)), {}
