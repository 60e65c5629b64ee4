"""Gaps and contact forces of pairs on numbers: of pairs that are alike by one function, row by row."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel

INPUTS = {"gaps": "t q u c", "gap_accelerations": "t q u a c", "contact": "t q u z m c"}


def pair_values(model: EngineModel, name: str, pairs: Sequence[int], state: Mapping[str, Any]) -> list[np.ndarray]:
    """Return results of "gaps" or "gap_accelerations" for some pairs (n,), by rising numbers.

    given    inputs of the whole model by name
    """
    results = [values for _, _, values in values_by_kind(model, name, pairs, state)]
    return [np.concatenate(column)[:, 0] for column in zip(*results, strict=True)]


def values_by_kind(
    model: EngineModel, name: str, pairs: Sequence[int], state: Mapping[str, Any]
) -> Iterator[tuple[list[int], np.ndarray, list[np.ndarray]]]:
    """Yield the pairs of a kind, the rows of u that each works on, and tables of results (n, size)."""
    inputs = INPUTS[name].split()
    members = model.members
    if not members:
        groups = [[pair] for pair in pairs] if name == "contact" else [list(pairs)]
        for of in groups:
            whole = f"contact_{model.pairs[of[0]]}" if name == "contact" else name
            results = model.evaluate(whole, *(state[part] for part in inputs))
            yield (
                of,
                np.arange(len(results[0]))[None],
                [x[None] if name == "contact" else x[of][:, None] for x in results],
            )
        return
    kinds = grouped((members[pair][0], pair) for pair in pairs)
    for kind, of in kinds.items():
        rows = [np.array([members[pair][i] for pair in of]) for i in range(1, 5)]
        places = dict(zip("quzma", [*rows, rows[1]], strict=True))
        tables = [state[x][places[x]] if x in places else np.full((len(of), 1), state[x]) for x in inputs[:-1]]
        yield of, rows[1], _of_kind(model, name, kind)(state["c"], *tables)


@per_model
def _of_kind(model: EngineModel, name: str, kind: str) -> Rowwise:
    """Return a function (c, own entries) -> results of one pair of a kind."""
    row = next(members[1:] for members in model.members if members[0] == kind)
    sizes = dict(zip("quzma", map(len, [*row, row[1]]), strict=True)) | {"t": 1, "c": model.nc}
    symbols = [ca.SX.sym(part, sizes[part]) for part in INPUTS[name].split()]
    results = getattr(model.module, f"{name}_of_{kind}")(*symbols)
    columns = results if isinstance(results, tuple) else (results,)
    one = ca.Function(name, [symbols[-1], *symbols[:-1]], ca.cse([ca.densify(ca.vec(ca.SX(x))) for x in columns]))
    return Rowwise(one, constant=0)
