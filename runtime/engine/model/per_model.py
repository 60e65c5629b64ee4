"""Cache of results computed once per model, such as its CasADi functions."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, Protocol, TypeVar, TypeVarTuple


class Caching(Protocol):
    """Model with a place for results: function and further arguments -> result."""

    known: dict[Hashable, Any]


AnyModel = TypeVar("AnyModel", bound=Caching)
Others = TypeVarTuple("Others")
Result = TypeVar("Result")


def per_model(function: Callable[[AnyModel, *Others], Result]) -> Callable[[AnyModel, *Others], Result]:
    """Cache a function's results in its model, by function and further arguments.

    They are freed with the model: a weak table beside it would keep it alive, because results refer to it. There is
    no lock, which a forked process could inherit while another thread holds it: two threads may compute the same, and
    one result stays.
    """

    @wraps(function)
    def once(model: AnyModel, *others: *Others) -> Result:
        known, key = model.known, (function, others)
        if key not in known:
            known[key] = function(model, *others)
        return known[key]  # type: ignore[no-any-return]

    return once
