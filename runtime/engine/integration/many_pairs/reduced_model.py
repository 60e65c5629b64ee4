"""Reduced models: those of the pairs that are near, where all others provably stay apart.

The gaps of the other pairs have lower bounds over a box of coordinates (`interval_arithmetic`). While the coordinates stay in a box
where these are positive, attempts of the reduced model are those of the whole, and the other pairs cost nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.many_pairs.interval_arithmetic import interval_extension
from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

BEYOND = 0.5  # of a step times a rate at its ends: a cubic goes less far beyond both
FAR = 1e30  # s, of a step that nothing limits, times one metre
STEPS = 2.0  # at the present rates, for which there has to be room


class ReducedModel(WatchedModel):
    """Model of some pairs of a whole one, in a box of coordinates among the controls of its runs.

    numbers, rows, own_latches    of its pairs, their memory and latches in the whole
    """

    def __init__(self, whole: EngineModel, pairs: tuple[int, ...]) -> None:
        module, far = whole.module, {*range(whole.k)} - {*pairs}
        self.whole, self.numbers = whole, pairs
        memory = memory_of_pairs(whole)
        dropped = {row for pair in far for row in memory[pair]}
        self.rows = [row for row in range(whole.nz) if row not in dropped]
        self.own_latches = [row for row, (_, _, pair) in enumerate(module.LATCHES) if pair in pairs]
        number = {pair: i for i, pair in enumerate(pairs)}
        place = {row: i for i, row in enumerate(self.rows)}

        def contact(function: str) -> Any:
            def reduced(t: Any, q: Any, u: Any, z: Any, m: Any, c: Any) -> Any:
                memory, latches = ca.SX.zeros(whole.nz), ca.SX.ones(whole.nm)
                memory[self.rows], latches[self.own_latches] = z, m
                f, dz, *others = getattr(module, function)(t, q, u, memory, latches, c)
                return f, ca.SX(dz)[self.rows], *others

            return reduced

        def energy(*arguments: Any) -> Any:
            kinetic, potential, stored = module.energy(*arguments)
            return kinetic, potential, ca.SX(stored)[[*pairs]]

        content = {name: x for name, x in vars(module).items() if not name.startswith("__")}
        content |= {
            "MEMORY": tuple(module.MEMORY[row] for row in self.rows),
            "LATCHES": tuple((*row[:2], number[row[2]]) for row in module.LATCHES if row[2] in number),
            "BRISTLES": tuple((place[row], number[pair]) for row, pair in module.BRISTLES if pair in number),
            **{name: tuple(getattr(module, name)[i] for i in pairs) for name in ("PAIRS", "RELEASES")},
            "DISSIPATED": tuple(place[module.DISSIPATED[pair]] for pair in pairs) if module.DISSIPATED else (),
            "SPEED_LIMITED": tuple(pair for pair in module.SPEED_LIMITED if whole.pairs.index(pair) in number),
            "FAMILIES": (),
            "gaps": lambda *arguments: tuple(ca.SX(x)[[*pairs]] for x in module.gaps(*arguments)),
            "gap_accelerations": lambda *arguments: ca.SX(module.gap_accelerations(*arguments))[[*pairs]],
            **{f"contact_{whole.pairs[pair]}": contact(f"contact_{whole.pairs[pair]}") for pair in pairs},
        }
        if whole.has_ledger:
            content["energy"] = energy
            content["ledger"] = lambda *arguments: ca.SX(module.ledger(*arguments))[self.rows]
        super().__init__(SimpleNamespace(**content), dependent=whole.dependent)

    def used(self, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
        """Return 2 for a step that may leave the box, else 0."""
        inside = [ca.mmin(self._room(run, at, BEYOND * start["h"])) > 0 for at in (start, end)]
        return 2 * (1 - inside[0] * inside[1])

    def time_left(self, run: Mapping[str, Any], at: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the longest step [s] that keeps to the box, and 1: there may be a wider one."""
        return self.longest(run, at), 1

    def longest(self, run: Mapping[str, Any], at: Mapping[str, Any]) -> Any:
        """Return the longest step [s]: at the present rates STEPS of them stay in the box."""
        ways = STEPS * ca.fabs(at["dy"][: self.nq]) + 1 / FAR
        return ca.mmin(self._room(run, at, 0) / ca.repmat(ways, 2, 1))

    def _room(self, run: Mapping[str, Any], at: Mapping[str, Any], h: Any) -> Any:
        """Return how far the ways in a time h (2 nq) are from the ends of the box."""
        q, way = at["y"][: self.nq], h * ca.fabs(at["dy"][: self.nq])
        low, high = ca.vertsplit(run["box"], self.nq)
        return ca.vertcat(q - way - low, high - q - way)


@per_model
def memory_of_pairs(model: EngineModel) -> list[list[int]]:
    """Return the rows of memory that each pair changes."""
    arguments = model.symbols("t q u z m c")
    return [ca.sparsify(model.expressions(f"contact_{pair}", *arguments)[1]).sparsity().row() for pair in model.pairs]


@per_model
def reduced_model(model: EngineModel, pairs: tuple[int, ...]) -> ReducedModel:
    """Return the reduced model of some pairs."""
    return ReducedModel(model, pairs)


@per_model
def lowest_gaps(model: EngineModel) -> Callers:
    """Return the function (t, q, u, c at lower bounds, at upper) -> lower bounds of the gaps (k)."""
    return Callers(interval_extension(model.function("gaps")))
