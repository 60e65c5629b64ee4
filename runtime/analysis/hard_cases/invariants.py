"""Invariants of hard cases: numbers with a limit, each of which can fail.

Energies are those of the run's own rows. Initial energy: kinetic, stored in contacts, and potential above its least
of the run. Total work: the largest that drives have put in, and of every contact the most it has stored, which is
what it takes from the bodies and gives back. None of it depends on the zero of the potential energy.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np
from scipy.optimize import brentq

from hertzwerk.runtime.analysis.hard_cases.case import EXTRA, MARGIN, HardCase, Known
from hertzwerk.runtime.analysis.hard_cases.tried_steps import TRIES
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, PAIR_PARTS, RELEASED
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from hertzwerk.runtime.engine.solution.solution import EngineSolution
    from hertzwerk.runtime.system.arrays import Array


ENERGY_LIMIT = 10.0  # of an energy, in tolerance x (initial energy + work)
DOUBLINGS = 60
FINITE, ENERGY, RISING, DEPTH, STEPS = "not finite", "energy", "energy rising", "depth/bound", "steps tried"


@dataclass(frozen=True)
class Measured:
    """Measured invariant of one run: its value must not exceed the limit; `note` explains it."""

    name: str
    value: float
    limit: float
    unit: str
    note: str

    @property
    def holds(self) -> bool:
        """Return whether the value is within the limit; false for NaN."""
        return self.value <= self.limit


def measure(case: HardCase, method: str, run: EngineSolution) -> tuple[Measured, ...]:
    """Return every invariant of the case on a run of it."""
    broken = sum(int(np.sum(~np.isfinite(run.engine.history.part(part)))) for part in ("y", "dy", *PAIR_PARTS))
    measured = [
        Measured(FINITE, broken, 0, "1", "entries of states, rates and contacts that are infinite or undefined")
    ]
    energies = Energies(run)
    tolerance, parts = (
        ENERGY_LIMIT * case.tolerance,
        f"initial energy {energies.initial:.3g} J, total work {energies.work:.3g} J",
    )
    note = f"largest |energy + dissipated - input - initial| over the sum of {parts}"
    measured.append(Measured(ENERGY, energies.residual / energies.scale, tolerance, "1", note))
    if not energies.driven:
        note = f"largest rise of the energy, which nothing drives, over the sum of {parts}"
        measured.append(Measured(RISING, energies.rise / energies.scale, tolerance, "1", note))
    if run.engine.model.k:
        measured.append(_depth(energies, tolerance))
    tries = run.statistics.steps + run.statistics.rejected + run.statistics.retaken
    measured += [_known(known, run) for known in case.known]
    bound = "theory" if method in case.theory else f"{MARGIN:g} times what was measured, + {EXTRA}"
    note = f"accepted {run.statistics.steps:,}, rejected {run.statistics.rejected:,}, retaken {run.statistics.retaken:,}; bound: {bound}"
    most = case.theory.get(method) or int(MARGIN * TRIES[case.name][method]) + EXTRA
    measured.append(Measured(STEPS, tries, most, "1", note))
    return tuple(measured)


class Energies:
    """Energies of a run [J], shape (rows,) each."""

    def __init__(self, run: EngineSolution) -> None:
        self.run, history = run, run.engine.history
        self.mode, self.stored = history.part("mode"), np.zeros((len(run.t), run.engine.model.k))
        kinetic, potential, stored = history.map("energy", "t q u")
        self.kinetic, self.potential = kinetic[:, 0], potential[:, 0]
        if run.engine.model.k:
            self.stored = stored
        self.dissipated, self.input = (
            np.sum([run[name] - run[name][0] for name in run.engine.model.memory if name.endswith(end)], axis=0)
            + np.zeros(len(run.t))
            for end in (".dissipated", ".input")
        )

    @property
    def driven(self) -> bool:
        """Return whether anything puts energy in."""
        return any(name.endswith(".input") for name in self.run.engine.model.memory)

    @cached_property
    def total(self) -> Array:
        """Kinetic and potential energy, and that stored by contacts."""
        total: Array = self.kinetic + self.potential + np.sum(np.where(self.mode == CONTACT, self.stored, 0), axis=1)
        return total

    @property
    def initial(self) -> float:
        """Energy at the start."""
        return float(self.total[0] - np.min(self.potential))

    @cached_property
    def work(self) -> float:
        """Total work, of drives and contacts."""
        done = float(np.max(np.abs(self.input)))
        for j in range(self.run.engine.model.k):
            begins = self.begins(j)
            stored = np.where(self.mode[:, j] == CONTACT, self.stored[:, j], 0)
            done += float(np.sum(np.maximum.reduceat(stored, np.flatnonzero(begins)))) if np.any(begins) else 0.0
        return done

    @property
    def scale(self) -> float:
        """Initial energy and total work."""
        return self.initial + self.work

    def begins(self, j: int) -> NDArray[np.bool_]:
        """Return a mask of the rows at which a contact of pair j begins, or exists from the start."""
        inside = self.mode[:, j] == CONTACT
        first: NDArray[np.bool_] = inside & ~np.concatenate([[False], inside[:-1]])
        return first

    @property
    def residual(self) -> float:
        """Largest |energy + dissipated - input - initial|."""
        return float(np.max(np.abs(self.total - self.total[0] + self.dissipated - self.input)))

    @property
    def rise(self) -> float:
        """Largest rise of the energy."""
        return float(np.max(self.total - np.minimum.accumulate(self.total)))


# -- penetration -------------------------------------------------------------------------------------------------------


def _depth(energies: Energies, tolerance: float) -> Measured:
    """Return the penetration over its bound by energy, at the row where the ratio is largest.

    The bound is the depth at which the stored-energy law takes all available energy: that of the bodies when the
    contact began, the work put in since, and the tolerance of the energy. An overlap without a contact counts from
    its own row: nothing may go through a surface.
    """
    run, mode = energies.run, energies.mode
    slack = tolerance * energies.scale
    worst, place = -1.0, (0, 0, 0.0)
    for j in range(run.engine.model.k):
        rows = np.arange(len(run.t))
        inside = mode[:, j] == CONTACT
        onset = np.where(inside, np.maximum.accumulate(np.where(energies.begins(j), rows, 0)), rows)
        there = energies.total[onset] + np.maximum(energies.input - energies.input[onset], 0) + slack
        part = energies.stored[:, j] / (there - energies.potential)
        part[mode[:, j] == RELEASED] = 0
        row = int(np.argmax(part)) if np.all(np.isfinite(part)) else int(np.argmax(~np.isfinite(part)))
        if not part[row] <= worst:
            worst, place = float(part[row]), (row, j, float(there[row]))
    row, j, there_then = place
    if worst <= 0:
        return Measured(DEPTH, 0, 1, "1", "nothing is stored in any contact")
    pair = run.engine.model.pairs[j]
    depth, bound = float(max(-run[f"{pair}.gap"][row], 0.0)), _depth_that_stores(run, row, j, there_then)
    return Measured(DEPTH, depth / bound, 1, "1", f"{depth:.4g} m of {bound:.4g} m at {pair}")


def _depth_that_stores(run: EngineSolution, row: int, j: int, energy: float) -> float:
    """Return the penetration of pair j [m] at which stored and potential energy together are `energy`.

    Reached from a row along the gap's gradient.
    """
    model = run.engine.model
    c, y, t = run.engine.history.controls[: model.nc], run.engine.history.part("y")[row], float(run.t[row])
    q0, u = y[: model.nq], y[model.nq : model.nq + model.nu]
    gradient = np.array(_gap_gradients(model)(t, q0, u, c))[j]
    direction = -gradient / float(gradient @ gradient)  # penetration grows by 1 per unit, to first order

    def excess(depth: float) -> float:
        _, potential, stored = model.function("energy")(t, q0 + depth * direction, u, c)
        return float(potential) + float(np.array(stored).ravel()[j]) - energy

    step = max(abs(float(run.engine.history.part("gap")[row, j])), 1e-15)
    low = 0.0
    for _ in range(DOUBLINGS):  # to a bracket; false for NaN
        if excess(low) <= 0 <= excess(step):
            break
        low, step = (low if excess(low) <= 0 else 2 * low - step), (step if excess(step) >= 0 else 2 * step)
    else:
        return math.nan
    further = float(brentq(excess, low, step, xtol=1e-300, rtol=1e-14))
    moved = run.engine.history.rows[[row]].copy()
    if run.engine.history.integrator is None:
        return math.nan
    layout = run.engine.history.integrator.layouts.state
    q = q0 + further * direction
    moved[0, layout["y"]][: model.nq] = q
    moved[0, layout["gap"]] = np.array(model.function("gaps")(t, q, u, c)[0]).ravel()
    there = History(model, moved, run.engine.history.controls, run.engine.history.integrator)
    return -float(there[f"{model.pairs[j]}.gap"][0])


@per_model
def _gap_gradients(model: EngineModel) -> Any:
    """Return the CasADi function (t, q, u, c) -> dG/dq (k, nq)."""
    t, q, u, c = (ca.SX.sym(name, size) for name, size in zip("tquc", (1, model.nq, model.nu, model.nc), strict=True))
    return ca.Function(
        "gap_gradients", [t, q, u, c], [ca.densify(ca.jacobian(model.function("gaps")(t, q, u, c)[0], q))]
    )


# -- what is known -----------------------------------------------------------------------------------------------------


def _known(known: Known, run: EngineSolution) -> Measured:
    try:
        value = known.of(run)
    except ValueError:  # a time that the run did not reach
        value = math.nan
    unit = "" if known.unit == "1" else f" {known.unit}"
    note = f"{value:.12g}{unit}, expected {known.expected:.12g}{unit}: {known.source}"
    return Measured(known.quantity, abs(value - known.expected), known.within, known.unit, note)
