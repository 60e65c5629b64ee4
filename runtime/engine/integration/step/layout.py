"""Layouts of an integration's vectors: state of an attempt, controls of a run, result of a step.

CasADi functions pass plain vectors; these records name their parts, in the graph (SX) and in the recorded rows
(NumPy).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel


@dataclass(frozen=True, eq=False)
class Layout:
    """Names and sizes of the consecutive parts of a vector."""

    sizes: Mapping[str, int]

    @cached_property
    def size(self) -> int:
        """Length of the whole vector."""
        return sum(self.sizes.values())

    @cached_property
    def _slices(self) -> dict[str, slice]:
        ends = accumulate(self.sizes.values())
        return {name: slice(end - size, end) for (name, size), end in zip(self.sizes.items(), ends, strict=True)}

    @cached_property
    def places(self) -> dict[str, int]:
        """Place of every part's first entry."""
        return {name: part.start for name, part in self._slices.items()}

    def __getitem__(self, name: str) -> slice:
        return self._slices[name]

    def symbol(self, name: str, kind: Any = ca.SX) -> Any:
        """Return a symbolic vector of this layout."""
        return kind.sym(name, self.size)

    def split(self, vector: Any) -> dict[str, Any]:
        """Return the parts of a vector by name, each a column."""
        return {name: vector[part] for name, part in self._slices.items()}

    def fill(self, vector: np.ndarray, parts: Mapping[str, Any]) -> None:
        """Set parts of a vector, by numbers or arrays."""
        for name, value in parts.items():
            vector[self._slices[name]] = value

    def join(self, parts: Mapping[str, Any]) -> Any:
        """Join exactly these parts to the vector.

        Raises ValueError if a part is missing, unknown or of another size.
        """
        columns = {name: ca.DM(part) if isinstance(part, int | float) else part for name, part in parts.items()}
        sizes = {name: column.numel() for name, column in columns.items()}
        if sizes != dict(self.sizes):
            raise ValueError(f"found parts {sizes}, expected {dict(self.sizes)}")
        return ca.vertcat(*(ca.densify(columns[name]) for name in self.sizes))


@dataclass(frozen=True)
class Layouts:
    """Layouts of the vectors of a model's integration; k pairs, ny = nq + nu + nz.

    state     passed from one attempt to the next; the recorded row
    controls  the numbers of one run, constant over its attempts
    trial     result of one step
    verdict   classification of a step: its kind, the error norm, whether each law is in its range
    kind      CasADi type of the symbols in which what handles a step is written
    """

    state: Layout
    controls: Layout
    trial: Layout
    verdict: Layout
    kind: Any = ca.SX

    @cached_property
    def shared(self) -> tuple[str, ...]:
        """Names of the parts that both a state and the result of a step have."""
        return tuple(name for name in self.trial.sizes if name in self.state.sizes)

    def symbols(self, names: str, kind: Any = None) -> tuple[list[Any], list[dict[str, Any]]]:
        """Return symbols of vectors, as of "state controls next", and their parts; by default of this `kind`.

        next, before and after are states.
        """
        layouts = [self.state if name in ("next", "before", "after") else getattr(self, name) for name in names.split()]
        vectors = [layout.symbol(name, kind or self.kind) for layout, name in zip(layouts, names.split(), strict=True)]
        parts = [layout.split(vector) for layout, vector in zip(layouts, vectors, strict=True)]
        states = [part for layout, part in zip(layouts, parts, strict=True) if layout is self.state]
        return vectors, [
            self.within(part, states[-1]) if layout is self.controls and states else part  # a step changes no piece
            for layout, part in zip(layouts, parts, strict=True)
        ]

    def within(self, run: dict[str, Any], state: Mapping[str, Any]) -> dict[str, Any]:
        """Return the controls of a run in a state: its pieces of the inputs in c, t_end where they end."""
        pieces = self.state.sizes["pieces"]
        if not pieces:
            return run
        own = self.controls.sizes["c"] - pieces
        stop = state["stop"] if self.state.sizes["stop"] else run["t_end"]
        return {**run, "c": ca.vertcat(run["c"][:own], state["pieces"]), "t_end": stop}


# Pairs beyond which what handles a step is in operations on vectors (MX): loops in C, not an operation for each pair.
MANY = 15
SEVERAL = 5  # likewise of what begins a run and handles events, seldom: ball_bearing's C is 22 % smaller
FLIGHT, CONTACT, RELEASED = 0.0, 1.0, 2.0  # modes of a pair
# status
RUNNING, FINISHED, STEP_TOO_SMALL, NOT_FINITE = range(4)
CONSTRAINT_LOST, OUTSIDE_LAW_RANGE, EVENT_LIMIT, TOO_MANY_STEPS = range(4, 8)
STALE = -3.0  # status where far pairs may come near before the next step ends: the list of near ones is made anew
CALM = -2.0  # status of steps that choose where nothing is stiff: the run goes on with explicit steps alone
SUSPECT = -1.0  # status of explicit steps that look stiff, of implicit ones near a singular position: the run goes on with steps that choose
# kind of a step: nothing speaks against it; a pair that was not asked may be near; something may happen in it; it failed
PLAIN, NEAR, SPECIAL, REJECTED = range(4)
PAIR_PARTS = ("gap", "gap_rate", "gap_acceleration", "force", "force_rate")  # in the state and in the trial
GRIP_PARTS = ("friction", "margin", "margin_rate", "grip_force")  # likewise, of the pairs with set-valued friction
EVENT_PARTS = (
    "event",
    "event_rate",
    "event_rounding",
)  # likewise, of the effects' events: margins beside their sizes [1], rates [1/s], and bounds of their rounding [1]
ENERGY_PARTS = ("kinetic", "potential")  # likewise, where a ledger is booked [J]
END_PARTS = (
    *PAIR_PARTS,
    *GRIP_PARTS,
    *EVENT_PARTS,
    *ENERGY_PARTS,
    "ahead",
)  # all that a step's end has beside t, y, dy


@per_model
def layouts(model: EngineModel) -> Layouts:
    """Return the layouts for a model.

    State: t [s]; y = q, u, z; dy = dy/dt under the modes; mode and m (latches, slips); gap, gap_rate,
    gap_acceleration and force, force_rate of each pair, friction, margin, margin_rate and grip_force of those with
    set-valued friction (see `set_valued_friction`) [SI]; event, event_rate and event_rounding of each event of an effect (see
    `effect_events`); kinetic and potential energy [J] where a ledger is booked; ahead [s], the time to a singular position,
    where loops are closed (see `singular_positions`); pieces of the inputs, and stop [s], where they end;
    h [s] the step to try next; h_flight, h_contact, h_onset [s] remembered; class (see `contact_classes`), status;
    method, pressure, wary, stiffness (see `method_choice`); accepted, fresh_contact (a contact has just begun),
    after_rejection; then counters.
    """
    ny, k, nm = model.nq + model.nu + model.nz, model.k, model.nm
    pairs = dict.fromkeys(PAIR_PARTS, k) | dict.fromkeys(GRIP_PARTS, model.ns)
    pairs |= dict.fromkeys(EVENT_PARTS, model.ne) | dict.fromkeys(ENERGY_PARTS, int(model.has_ledger))
    pairs["ahead"] = min(model.nl, 1)
    inputs = {"pieces": model.npieces, "stop": len(model.inputs) and 1}
    steps = ("h", "h_flight", "h_contact", "h_onset", "class", "status")
    choice = ("method", "pressure", "wary", "stiffness")
    flags = ("accepted", "fresh_contact", "after_rejection")
    counters = ("retakes", "steps", "rejected", "retaken", "evaluations", "events", "floored", "unsettled")
    limits = ("tolerance", "t_end", "h_max", "floor", "max_events", "max_steps")
    return Layouts(
        state=Layout(
            {"t": 1, "y": ny, "dy": ny, "mode": k, "m": nm}
            | pairs
            | inputs
            | dict.fromkeys((*steps, *choice, *flags, *counters), 1)
        ),
        controls=Layout(
            {"c": model.nc, "scale": ny, "scales": 4, "speed_limits": len(model.speed_limited) and k}
            | dict.fromkeys(limits, 1)
            | {"box": 2 * model.nq if k > MANY or isinstance(model, WatchedModel) else 0}
        ),
        trial=Layout({"t": 1, "y": ny, "dy": ny} | pairs | {"in_range": model.nr, "error": 1}),
        verdict=Layout({"kind": 1, "error": 1, "in_range": model.nr}),
        kind=ca.MX if model.lists or (k > MANY and not model.ns) else ca.SX,
    )


@per_model
def event_layouts(model: EngineModel) -> Layouts:
    """Return the layouts for what begins a run and completes steps with events."""
    vectors = layouts(model)
    return replace(vectors, kind=ca.MX) if model.k > SEVERAL and not model.ns else vectors
