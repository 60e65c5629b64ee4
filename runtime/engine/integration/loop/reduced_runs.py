"""Runs of many pairs by those that are near: attempts of reduced models, in the states of the whole.

A pair is near where it may meet within the time in which the scene's speed covers its length some times, at the present rates. Where the
coordinates leave the box in which all others stay apart, it is made anew; where others are near as well, the next reduced model takes over,
or, of too many, the whole.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable
from functools import partial
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.loop.attempt import Integrator, integrator
from hertzwerk.runtime.engine.integration.loop.automatic_compilation import AutomaticCallers, Code
from hertzwerk.runtime.engine.integration.loop.chunk import chunk
from hertzwerk.runtime.engine.integration.loop.reduced_rows import Columns, ReducedRows
from hertzwerk.runtime.engine.integration.loop.tally import APPROACHES, tally
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import APART
from hertzwerk.runtime.engine.integration.many_pairs.reduced_model import lowest_gaps, reduced_model
from hertzwerk.runtime.engine.integration.step.contact_classes import class_of
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT, MANY, PAIR_PARTS, layouts
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS, SUNDIALS
from hertzwerk.runtime.engine.model.caller import Caller, Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

MOST = 4  # pairs of a reduced model: each further one costs in every step
MODELS = 3  # reduced models of a run: each is built in the time of some thousand attempts
AHEAD = 100  # times the scene's length over its speed
WAYS = [1e6 / 8.0**i for i in range(30)]  # m or rad: ways to the ends of a box, of which the longest is taken

Reduced = Callable[[tuple[int, ...]], Code]


def reduction(model: EngineModel, method: str) -> Reduced | None:
    """Return the function (pairs) -> code of their reduced model; None where there is none.

    A reduced model has few of many pairs, and the others nothing that depends on all.
    """
    others = model.ns, model.ne, model.loads, model.inputs, model.lists, model.module.FAMILIES
    if method in SUNDIALS or model.k <= MANY or any(map(bool, others)):
        return None
    return lambda pairs: _reduced_code(model, method, pairs)


def code_of(made: Integrator, method: str, callers: Callable[[Any], Callers] = Callers) -> Code:
    """Return the code of an integrator's chunks."""
    with_choice, name = made.with_choice, f"chunk_{method}"  # of which a program may have several
    chosen = None
    if with_choice is not None:
        chosen = lambda: Code(lambda: chunk(with_choice(), called=f"{name}_choosing"), callers=callers)  # noqa: E731
    return Code(lambda: chunk(made, called=name), chosen, callers=callers)


@per_model
def _reduced_code(model: EngineModel, method: str, pairs: tuple[int, ...]) -> Code:
    own = reduced_model(model, pairs)
    moving = model.nq + model.nu
    states = [*range(moving), *(moving + row for row in own.rows)]
    entries = {name: [*pairs] for name in ("mode", "speed_limits", *PAIR_PARTS, *APPROACHES)}
    entries |= {"y": states, "dy": states, "scale": states, "m": own.own_latches}
    columns = [
        Columns(mine, whole, entries)
        for mine, whole in (
            (layouts(own).state, layouts(model).state),
            (layouts(own).controls, layouts(model).controls),
            (tally(own).layout, tally(model).layout),
        )
    ]
    made = integrator(own, tuple(table() for table in METHODS[method]))
    return code_of(made, method, partial(Callers, make=partial(_ReducedCaller, columns=columns)))


class _ReducedCaller(Caller):
    """Caller of a reduced model's chunk with vectors of the whole, in which other pairs stay as they are.

    columns    of state, controls and tally
    """

    def __init__(self, function: Any, columns: list[Columns]) -> None:
        super().__init__(function)
        self._columns, self._own = columns, self.inputs
        self.inputs = [np.zeros((1, each.size)) for each in columns]

    def __call__(self) -> list[Any]:
        """Evaluate on `inputs`; the states returned are overwritten by the next call."""
        for columns, own, whole in zip(self._columns, self._own, self.inputs, strict=True):
            own[:] = whole[:, columns.places]
        self._evaluate()
        of_states, _, of_tally = self._columns
        (state,), _, tallied = self.inputs
        states, own_tally = self.results
        tallied = tallied.copy()
        tallied[:, of_tally.places] = own_tally
        return [ReducedRows(states, of_states, state.copy()), tallied]


class ReducingCallers(AutomaticCallers):
    """Callers of a run's chunks, of the whole model or of a reduced one.

    whole    code of the whole model; reduced: pairs -> code of the model that has them
    """

    def __init__(self, model: EngineModel, whole: Code, reduced: Reduced, *, compiled: bool, changes: bool) -> None:
        self._model, self._whole, self._reduced = model, whole, reduced
        self._pairs: tuple[int, ...] | None = None  # of the reduced model in use
        self._used: set[tuple[int, ...]] = set()
        self._choosing = self._entered = False
        super().__init__(whole, compiled=compiled, changes=changes)

    def begin(self) -> None:
        """Start a run, or go on with its explicit steps."""
        self._choosing = False
        if self._entered:
            super().begin()

    def use_choice(self, poll: Callable[[], object]) -> None:
        """Change `callers` to those that choose between methods."""
        self._choosing = True
        super().use_choice(poll)

    def enter(self, state: np.ndarray, controls: np.ndarray, poll: Callable[[], object], *, first: bool) -> np.ndarray:
        """Return the state to go on with, by the pairs that are near then; the controls have a new box."""
        if first:
            self._pairs, self._used, self._entered = None, set(), True
        before, self._pairs = self._pairs, self._chosen(state, controls)
        self.watches = self._pairs is None  # the whole model runs, which a reduced one may replace
        if self._pairs != before:
            state = self._of_whole(state, controls)
        if self._pairs is not None:
            state = _of_pairs(self._model, self._pairs)(state, controls)[0]
        if first or self._pairs != before:
            self._first = self._whole if self._pairs is None else self._reduced(self._pairs)
            self._used |= {self._pairs or ()}
            self.use_choice(poll) if self._choosing and not first else self._take(self._first, poll)
        return state

    def _chosen(self, state: np.ndarray, controls: np.ndarray) -> tuple[int, ...] | None:
        """Return the pairs that are not apart, with those that were not, and set their box; None of too many."""
        model, vectors = self._model, layouts(self._model)
        t, y, dy, mode = (state[vectors.state[name]] for name in ("t", "y", "dy", "mode"))
        t_end, c, scale, (length, speed, *_) = (
            controls[vectors.controls[name]] for name in ("t_end", "c", "scale", "scales")
        )
        q, u, z = np.split(y, [model.nq, model.nq + model.nu])
        room = AHEAD * length / speed * np.abs(dy[: model.nq]) + scale[: model.nq]
        lowest = lowest_gaps(model).take()  # for 15 boxes or so, in as much time as 300 attempts as C
        for place, value in zip(lowest.inputs, (t, q, u, c, t_end, q, u, c), strict=True):
            place[:] = value

        def apart(low: np.ndarray, high: np.ndarray) -> np.ndarray:
            lowest.inputs[1][:], lowest.inputs[5][:] = low, high
            return np.ravel(lowest()[0]) > 0

        near = {*np.flatnonzero(~apart(q - room, q + room) | (mode != FLIGHT)).tolist()}
        chosen = None
        for pairs in (tuple(sorted(near.union(self._pairs or ()))), tuple(sorted(near))):
            few = len(pairs) <= MOST and (pairs in self._used or len(self._used) < MODELS)
            if few and not np.any(np.delete(z, reduced_model(model, pairs).rows)):
                far = np.array([j not in pairs for j in range(model.k)])
                box = _widened(q, room, lambda *ends, far=far: bool(apart(*ends)[far].all()))
                controls[vectors.controls["box"]], chosen = box, pairs
                break
        lowest_gaps(model).give_back(lowest)
        return chosen

    def _of_whole(self, state: np.ndarray, controls: np.ndarray) -> np.ndarray:
        """Return a state with all pairs, where it was one of a reduced model."""
        apart = np.any(state[layouts(self._model).state["gap"]] == APART)
        return _evaluated(self._model)(state, controls)[0] if apart else state


def _widened(q: np.ndarray, room: np.ndarray, apart: Callable[[np.ndarray, np.ndarray], bool]) -> np.ndarray:
    """Return the ends (2 n) of a box of coordinates around q +- room, each as far as pairs stay apart."""
    n, ways = len(q), np.concatenate([room, room])

    def reaches(ends: slice, way: float) -> bool:
        trial = ways.copy()
        trial[ends] = np.maximum(trial[ends], way)
        if fits := apart(q - trial[:n], q + trial[n:]):
            ways[:] = trial
        return fits

    def widen(first: int, last: int) -> None:
        ends, middle = slice(first, last), (first + last) // 2
        if reaches(ends, WAYS[0]):
            return
        if middle == first:  # a smaller box has no lower bound: what a way does not reach, no longer one does
            bisect_left(WAYS[1:], True, key=lambda way: reaches(ends, way))
            return
        widen(first, middle)
        widen(middle, last)

    widen(0, 2 * n)
    return np.concatenate([q - ways[:n], q + ways[n:]])


@per_model
def _of_pairs(model: EngineModel, pairs: tuple[int, ...]) -> Callers:
    """Return the function (state, controls) -> state in which all other pairs are apart.

    It has the reduced model's class, and a step that keeps to the box.
    """
    vectors, own, far = layouts(model), reduced_model(model, pairs), np.setdiff1d(np.arange(model.k), pairs).tolist()
    (state, controls), (old, run) = vectors.symbols("state controls", ca.MX)
    new = {name: ca.MX(old[name]) for name in PAIR_PARTS}
    for name, of_pairs in new.items():
        of_pairs[far] = APART if name == "gap" else 0.0
    new["class"] = class_of(own, old["mode"][[*pairs]])
    new["h"] = ca.fmin(old["h"], own.longest(run, old))
    return Callers(ca.Function("of_pairs", [state, controls], [vectors.state.join({**old, **new})]))


@per_model
def _evaluated(model: EngineModel) -> Callers:
    """Return the function (state, controls) -> state with all pairs evaluated anew."""
    vectors = layouts(model)
    (state, controls), (old, run) = vectors.symbols("state controls", ca.MX)
    end = flow(model).at(old["t"], old["y"], old["mode"], old["m"], run["c"])
    end.pop("in_range")
    new = {**old, **end, "class": class_of(model, old["mode"])}
    return Callers(ca.Function("evaluated", [state, controls], [vectors.state.join(new)]))
