"""Runs of many pairs by those that are near: attempts of reduced models, in the states of the whole.

A pair is near where it may meet within the time in which the scene's speed covers its length some times, at the present rates. Where the
coordinates leave the box in which all others stay apart, it is made anew; where others are near as well, the next reduced model takes over,
or, of too many, the whole.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.loop.attempt import Integrator, integrator
from hertzwerk.runtime.engine.integration.loop.automatic_compilation import AutomaticCallers, Code
from hertzwerk.runtime.engine.integration.loop.chunk import chunk
from hertzwerk.runtime.engine.integration.loop.tally import APPROACHES, tally
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import APART
from hertzwerk.runtime.engine.integration.many_pairs.reduced_model import lowest_gaps, reduced_model
from hertzwerk.runtime.engine.integration.step.contact_classes import class_of
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT, MANY, PAIR_PARTS, Layout, layouts
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS, SUNDIALS
from hertzwerk.runtime.engine.model.caller import Caller, Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

MOST = 4  # pairs of a reduced model: each further one costs in every step
MODELS = 3  # reduced models of a run: each is built in the time of some thousand attempts
AHEAD = 100  # times the scene's length over its speed
WIDEST, NARROWER = 1e6, 8.0  # m or rad: ends of a box that are tried first, and by how much less the next

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
        _Columns(mine, whole, entries)
        for mine, whole in (
            (layouts(own).state, layouts(model).state),
            (layouts(own).controls, layouts(model).controls),
            (tally(own).layout, tally(model).layout),
        )
    ]
    made = integrator(own, tuple(table() for table in METHODS[method]))
    return code_of(made, method, partial(Callers, make=partial(_ReducedCaller, columns=columns)))


class _Columns:
    """Places of the entries of a vector of a reduced model in that of the whole, as slices of both."""

    def __init__(self, own: Layout, whole: Layout, entries: dict[str, list[int]]) -> None:
        places = [
            whole.places[name] + i for name, size in own.sizes.items() for i in [*entries.get(name, range(size))][:size]
        ]
        self.size, self.others = whole.size, np.setdiff1d(np.arange(whole.size), places)
        breaks = [0, *(np.flatnonzero(np.diff(places) != 1) + 1).tolist(), len(places)]
        self._slices = [
            (slice(first, last), slice(places[first], places[first] + last - first))
            for first, last in pairwise(breaks)
            if last > first
        ]

    def gather(self, whole: np.ndarray, own: np.ndarray) -> None:
        """Take the entries of whole vectors (.., n)."""
        for one, other in self._slices:
            own[..., one] = whole[..., other]

    def scatter(self, own: np.ndarray, whole: np.ndarray) -> None:
        """Put the entries into whole vectors (.., n)."""
        for one, other in self._slices:
            whole[..., other] = own[..., one]


class _ReducedCaller(Caller):
    """Caller of a reduced model's chunk with vectors of the whole, in which other pairs stay as they are.

    columns    of state, controls and tally
    """

    def __init__(self, function: Any, columns: list[_Columns]) -> None:
        super().__init__(function)
        self._columns, self._own = columns, (self.inputs, self.results)
        self.inputs = [np.zeros((1, each.size)) for each in columns]
        self.results = [np.zeros((len(own), each.size)) for own, each in zip(self.results, columns[::2], strict=True)]

    def __call__(self) -> list[np.ndarray]:
        """Evaluate on `inputs`; the arrays returned are overwritten by the next call."""
        own_inputs, own_results = self._own
        for columns, own, whole in zip(self._columns, own_inputs, self.inputs, strict=True):
            columns.gather(whole, own)
        self._evaluate()
        for columns, own, whole, start in zip(
            self._columns[::2], own_results, self.results, self.inputs[::2], strict=True
        ):
            if not np.array_equal(whole[0, columns.others], start[0, columns.others]):
                whole[:] = start
            columns.scatter(own, whole)
        return self.results


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
            state = self._of_pairs(state, controls, self._pairs)
        if first or self._pairs != before:
            self._first = self._whole if self._pairs is None else self._reduced(self._pairs)
            self._used |= {self._pairs or ()}
            self.use_choice(poll) if self._choosing and not first else self._take(self._first, poll)
        return state

    def _chosen(self, state: np.ndarray, controls: np.ndarray) -> tuple[int, ...] | None:
        """Return the pairs that are not apart, with those that were not, and set their box; None of too many."""
        model, vectors = self._model, layouts(self._model)
        at, run = (
            {name: vector[layout[name]] for name in layout.sizes}
            for vector, layout in ((state, vectors.state), (controls, vectors.controls))
        )
        q, u, z = np.split(at["y"], [model.nq, model.nq + model.nu])
        (length, speed), rates = run["scales"][:2], np.abs(at["dy"][: model.nq])
        room = AHEAD * length / speed * rates + run["scale"][: model.nq]
        others = u, run["c"]

        def apart(low: np.ndarray, high: np.ndarray) -> np.ndarray:
            gaps = lowest_gaps(model)(at["t"], low, *others, run["t_end"], high, *others)[0]
            are_apart: np.ndarray = gaps > 0
            return are_apart

        near = {*np.flatnonzero(~apart(q - room, q + room) | (at["mode"] != FLIGHT)).tolist()}
        for pairs in (tuple(sorted(near.union(self._pairs or ()))), tuple(sorted(near))):
            few = len(pairs) <= MOST and (pairs in self._used or len(self._used) < MODELS)
            if few and not np.any(np.delete(z, reduced_model(model, pairs).rows)):
                far = np.setdiff1d(np.arange(model.k), pairs)
                box = _widened(q, room, lambda *ends, far=far: bool(apart(*ends)[far].all()))
                controls[vectors.controls["box"]] = box
                return pairs
        return None

    def _of_pairs(self, state: np.ndarray, controls: np.ndarray, pairs: tuple[int, ...]) -> np.ndarray:
        """Return a state in which all other pairs are apart.

        It has the reduced model's class, and a step that keeps to the box.
        """
        vectors, far = layouts(self._model), np.setdiff1d(np.arange(self._model.k), pairs)
        layout, own, state = vectors.state, reduced_model(self._model, pairs), state.copy()
        for name in PAIR_PARTS:
            state[layout.places[name] + far] = APART if name == "gap" else 0.0
        state[layout["class"]] = float(class_of(own, ca.DM(state[layout["mode"]][[*pairs]])))
        at = {name: ca.DM(state[layout[name]]) for name in ("h", "y", "dy")}
        state[layout["h"]] = min(
            float(at["h"]), float(own.longest({"box": ca.DM(controls[vectors.controls["box"]])}, at))
        )
        return state

    def _of_whole(self, state: np.ndarray, controls: np.ndarray) -> np.ndarray:
        """Return a state with all pairs, where it was one of a reduced model."""
        apart = np.any(state[layouts(self._model).state["gap"]] == APART)
        return _evaluated(self._model)(state, controls)[0] if apart else state


def _widened(q: np.ndarray, room: np.ndarray, apart: Callable[[np.ndarray, np.ndarray], bool]) -> np.ndarray:
    """Return the ends (2 n) of a box of coordinates around q +- room, each as far as pairs stay apart."""
    ends = [q - room, q + room]
    for end, sign in zip(ends, (-1, 1), strict=True):
        for i, least in enumerate(room):
            inner, move = end[i], WIDEST
            while move > least:
                end[i] = q[i] + sign * move
                if apart(*ends):
                    break
                end[i], move = inner, move / NARROWER
    return np.concatenate(ends)


@per_model
def _evaluated(model: EngineModel) -> Callers:
    """Return the function (state, controls) -> state with all pairs evaluated anew."""
    vectors = layouts(model)
    (state, controls), (old, run) = vectors.symbols("state controls", ca.MX)
    end = flow(model).at(old["t"], old["y"], old["mode"], old["m"], run["c"])
    end.pop("in_range")
    new = {**old, **end, "class": class_of(model, old["mode"])}
    return Callers(ca.Function("evaluated", [state, controls], [vectors.state.join(new)]))
