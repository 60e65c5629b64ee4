"""Rigid limit of a scene, and compliant runs beside it with ever stiffer contacts."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, among, shown, unknown
from hertzwerk.runtime.analysis.rigid_limit.rigid_equations import Equations, distance_of, refused, rows_of
from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import RigidImpact, read_impacts
from hertzwerk.runtime.analysis.rigid_limit.rigid_run import (
    LEAST_STEPS,
    ROUNDING,
    Accumulation,
    Motion,
    RigidImpulse,
    RigidRun,
)
from hertzwerk.runtime.engine.model.binding import Value, times_within
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_request import Settings, is_real, progress_faults, read
from hertzwerk.runtime.engine.solution.history import Histories
from hertzwerk.runtime.engine.solution.outcome import REACHED_END, Outcome
from hertzwerk.runtime.engine.start.start_values import stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.output.tables.notebook import Printed
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.analysis.rigid_limit.rigid_derivatives import RigidDerivatives

TOGETHER, IN_TURN = "together", "in turn"
SHOWN = 8  # impacts of a table
TIGHTEST = 1e-13  # tolerance of a run that others are compared with


@dataclass(frozen=True)
class StifferRun:
    """Compliant run with a stiffness times a factor.

    apart    difference [s] of each impact's onset from the rigid one's, as long as the impacts are those of the same pairs
    """

    factor: float
    run: Solution
    apart: Array


@dataclass(frozen=True, eq=False)
class RigidLimit(Printed, Histories):
    """Rigid limit of a scene: a mapping from coordinates and speeds to their values at `t`, in SI.

    impulses, accumulations    impacts, and the ends of sequences of ever shorter flights
    t (n,) [s], energy (n,) [J]    at the ends of steps, and before and after each impact; energy is nan without an `EnergyLedger`
    rubbed    energy that friction dissipates between impacts [J]
    initial, again    initial states that were given; the run once more, with a hundredth of the tolerance
    stiffer    compliant runs of the scene, by growing stiffness
    """

    model: EngineModel
    run: RigidRun = field(repr=False)
    outcome: Outcome
    law: Mapping[str, RigidImpact]
    initial: Mapping[str, Value]
    again: Callable[[], RigidRun] = field(repr=False)
    stiffness: str
    stiffer: tuple[StifferRun, ...] = ()

    def __getitem__(self, name: str) -> Array:
        return self.t if among(name, "t") else np.array(self.motion.y)[:, self._place(name)]

    def _place(self, name: str) -> int:
        names = [*self]
        if name not in names:
            raise KeyError(str(unknown("coordinate or speed", name, names)))
        return names.index(name)

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit text of "t", the coordinates and the speeds."""
        return {"t": "s"} | {name: self.model.units[name] for name in (*self.model.coordinates, *self.model.speeds)}

    @property
    def motion(self) -> Motion:
        """Motion of the run, as it was integrated."""
        return self.run.motion

    @property
    def t(self) -> Array:
        """Times [s] (n,)."""
        return np.array(self.motion.t)

    @cached_property
    def energy(self) -> Array:
        """Kinetic and potential energy [J] (n,)."""
        model = self.model
        if not model.has_function("energy"):
            return np.full(len(self.motion.t), math.nan)
        c, states = self.run.equations.bound.c, zip(self.motion.t, self.motion.y, strict=True)
        parts = (model.evaluate("energy", t, y[: model.nq], y[model.nq :], c)[:2] for t, y in states)
        return np.array([sum(np.sum(part) for part in of) for of in parts])

    @property
    def impulses(self) -> tuple[RigidImpulse, ...]:
        """Impacts, in the order of their times."""
        return tuple(self.motion.impulses)

    @property
    def accumulations(self) -> tuple[Accumulation, ...]:
        """Ends of sequences of impacts, at which a contact comes to rest."""
        return tuple(self.motion.accumulations)

    @property
    def rubbed(self) -> float:
        """Energy that friction dissipates between impacts [J]."""
        return self.motion.rubbed

    @property
    def lost(self) -> float:
        """Energy that impacts take up [J]."""
        return math.fsum(impulse.lost for impulse in self.impulses)

    @property
    def balance(self) -> float:
        """Energy [J] by which the motion misses its balance; the work of drives and effects is booked."""
        return float(self.energy[-1] - self.energy[0]) + self.lost + self.rubbed - self.motion.work

    @cached_property
    def differences(self) -> tuple[float, float]:
        """Estimates of the error, by a finer run: of times of impacts [s], and of the end state in its scales.

        It has a hundredth of the tolerance and shorter steps, so its own error is far smaller. The times are those of the first
        impacts, as long as the same contacts collide.
        """
        finer, sizes = self.again().motion, self.run.sizes
        apart = np.max(np.abs(_apart(self.motion, finer.impulses)), initial=0.0)
        return float(apart), float(np.max(np.abs(self.motion.y[-1] - finer.y[-1]) / sizes))

    def at(self, name: str, times: Value | Sequence[float] | Array) -> Array:
        """Return a coordinate or speed (n,) at one or more times of the run [s].

        At an impact it is that just after it. Raises InputError for what is no time of the run.
        """
        return self._states(times)[1][:, self._place(name)]

    def derivatives(self, *names: str) -> RigidDerivatives:
        """Return the derivatives of the run by parameters and initial states, between and through its events.

        `limit.derivatives("restitution").impulses("t", "restitution")` are those of the times of impacts. Where the motion is not smooth
        they end, and `reason` states why. Raises InputError for names that are neither.
        """
        from hertzwerk.runtime.analysis.rigid_limit.rigid_derivatives import (
            RigidDerivatives,
        )  # most limits need none of it

        return RigidDerivatives(self.run, self.law, self.initial, names, self.again)

    def gaps(self, times: Value | Sequence[float] | Array) -> Array:
        """Return the gaps [m] (n, k) of all pairs at times (n,), as `at` takes them."""
        read, states = self._states(times)
        distance = distance_of(self.model)
        return np.array(
            [distance(t, y[: self.model.nq], self.run.equations.bound.c)[0] for t, y in zip(read, states, strict=True)]
        )

    def _states(self, times: Any) -> tuple[Array, Array]:
        read = times_within(times, self.motion.t[0], self.motion.t[-1])
        return read, self.motion.at(read)

    @property
    def orders(self) -> list[float]:
        """Observed orders of convergence by impact, nan where unknown.

        The onsets differ by the stiffness to the power -order, between the two stiffest runs.
        """
        if len(self.stiffer) < 2:
            return []
        soft, stiff = self.stiffer[-2:]
        with np.errstate(divide="ignore", invalid="ignore"):
            count = min(len(soft.apart), len(stiff.apart))
            ratio = np.log(np.abs(soft.apart[:count] / stiff.apart[:count])) / math.log(stiff.factor / soft.factor)
        moved = np.abs(soft.apart[:count]) > ROUNDING * self.t[-1]
        orders: list[float] = np.where(moved, ratio, math.nan).tolist()
        return orders

    @property
    def lines(self) -> list[str]:
        """Outcome, energies and ends of sequences of impacts, a sentence each."""
        count = len(self.impulses)
        lines = [
            f"{self.model.name}, rigid limit: {self.outcome.name}, {self.outcome.message}",
            f"{count} impact{'' if count == 1 else 's'}, which take up {self.lost:.6g} J; friction between them {self.rubbed:.6g} J",
        ]
        by_pair = groupby(sorted(self.accumulations, key=lambda x: x.contact), key=lambda x: x.contact)
        for name, ends in by_pair:
            times = [end.t for end in ends]
            more = "" if len(times) == 1 else f", and {len(times) - 1} more"
            lines.append(f"{name}: impacts accumulate at t = {times[0]:.9g} s{more}, and the contact lasts from there")
        if self.stiffer:
            lines.append(
                f"compliant runs have multiples of {self.stiffness}; each onset is later than the rigid one, by it to the power -order"
            )
        return lines if self.outcome.finished else [*lines, self.outcome.remedy]

    @property
    def rows(self) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
        """Heading and rows of a table: the first impacts, and how much later the compliant ones begin."""
        head = ("contact", "t [s]", "approach [m/s]", "separation [m/s]",
                *(f"x{each.factor:g}, later by" for each in self.stiffer), *(["order"] if self.orders else []))  # fmt: skip
        rows = []
        for i, impulse in enumerate(self.impulses[:SHOWN]):
            apart = (
                f"{0 if abs(each.apart[i]) < ROUNDING * self.t[-1] else each.apart[i]:.3g} s"
                if i < len(each.apart)
                else ""
                for each in self.stiffer
            )
            known = i < len(self.orders) and not math.isnan(self.orders[i])
            order = [f"{self.orders[i]:.3f}" if known else ""] if self.orders else []
            speeds = f"{impulse.speed:.6g}", f"{abs(impulse.separation):.6g}"
            rows.append((impulse.contact, f"{impulse.t:.9g}", *speeds, *apart, *order))
        return head, rows

    def __str__(self) -> str:
        head, rows = self.rows
        widths = [max(len(row[i]) for row in (head, *rows)) for i in range(len(head))]
        lines = ["  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)) for row in (head, *rows)]
        return "\n".join([*self.lines, *(lines if rows else [])])

    def plot(self) -> Figure:
        """Draw gap, energy and, with stiffer runs, the convergence of the impacts' onsets."""
        from hertzwerk.runtime.analysis.rigid_limit import plot_rigid_limit

        return plot_rigid_limit.figure(self)

    def record(self) -> dict[str, Any]:
        """Return everything but the histories as plain data."""
        return {
            "scene": self.model.name,
            "outcome": vars(self.outcome),
            "law": {pair: vars(law) for pair, law in self.law.items()},
            "impacts": [impulse._asdict() for impulse in self.impulses],
            "accumulations": [end._asdict() for end in self.accumulations],
            "energy": [float(self.energy[0]), float(self.energy[-1])],
            "differences": self.differences if self.outcome.finished else None,
            "lost": self.lost,
            "rubbed": self.rubbed,
            "stiffness": self.stiffness,
            "stiffer": [
                {"factor": each.factor, "outcome": each.run.outcome.name, "apart": each.apart.tolist()}
                for each in self.stiffer
            ],
            "orders": [None if math.isnan(order) else order for order in self.orders],
        }


def rigid_limit(
    target: Target,
    law: RigidImpact | Mapping[str, RigidImpact],
    *,
    duration: str | float | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    impacts: str = TOGETHER,
    stiffness: str = "",
    factors: Sequence[float] = (1, 10, 100),
    tolerance: float = 1e-10,
    accuracy: float = 1e-6,
    progress: Callable[[float], object] | None = None,
) -> RigidLimit:
    """Run a scene with rigid contacts: impacts at an instant, and constraints while contacts last.

    target      a scene or a Model, as `simulate` takes it; its contact forces are left out, all else acts
    law         a `RigidImpact` for all contact pairs, or one for each by name
    duration, parameters, initial    as `simulate` takes them
    impacts     of contacts that touch at one time: "together", all impulses at once, or "in turn", one by one, the fastest first
    stiffness   a parameter: compliant runs with its value times each of `factors` stand beside the rigid one
    tolerance   local tolerance of the rigid run; `differences` estimate its error by a tighter run
    accuracy    of the compliant runs
    progress    a function that is called now and then with the fraction done

    Sequences of impacts with ever shorter flights end at their limit, and the contact lasts from there, until its force would pull. The
    outcome is "no_rigid_solution" where friction and restitution admit no impulses or forces, as in Painleve's paradox. Scenes with
    inputs, events of effects, or forces that depend on reactions are refused. Raises InputError with every fault.
    """
    model: EngineModel = engine_model(target)
    faults = [*refused(model), *progress_faults(progress)]
    values, wanted = stated_values(model, parameters, initial, faults)
    if not among(impacts, TOGETHER, IN_TURN):
        faults.append(Fault("impacts", shown(impacts), f'"{TOGETHER}" or "{IN_TURN}"'))
    if stiffness and stiffness not in model.parameters:
        faults.append(unknown("parameter", stiffness, model.parameters))
    sound = isinstance(factors, list | tuple) and all(is_real(factor) and factor > 0 for factor in factors)
    if not sound or list(factors) != sorted(set(factors)):
        faults.append(Fault("factors", shown(factors), "numbers above zero that grow, such as (1, 10, 100)"))
    settings = Settings(duration, accuracy, None)
    faults += settings.faults()
    of_pairs = law if isinstance(law, Mapping) else dict.fromkeys(model.pairs, law)
    contacts = read_impacts(model, of_pairs, rows_of(model), model.check(values)[0], faults)
    request, _ = read(model, Settings(duration, None, tolerance), values, wanted, faults)
    report = progress or (lambda _: None)
    share = 1 / (1 + len(factors)) if stiffness else 1.0
    sizes = request.scales.state[: model.nq + model.nu]

    def run_at(tolerance: float, steps: int = LEAST_STEPS) -> RigidRun:
        run = RigidRun(
            Equations(model, request.bound), contacts, impacts == TOGETHER, request.scales.scene[:3],
            sizes, tolerance, request.seconds, steps, lambda part: report(share * part),
        )  # fmt: skip
        run.run(np.concatenate([request.q, request.u]))
        return run

    run = run_at(tolerance)
    stiffer = []
    for i, factor in enumerate(factors if stiffness else ()):
        value = request.bound.values[stiffness]
        softer = {**values, stiffness: (value[0] * factor, value[1])}
        compliant = simulate(model, duration=duration, parameters=softer, initial=wanted, accuracy=accuracy)
        stiffer.append(StifferRun(float(factor), compliant, _apart(run.motion, compliant.impacts)))
        report(share * (i + 2))
    outcome = run.motion.outcome
    early = [each for each in stiffer if each.run.outcome.name not in REACHED_END]
    if outcome.finished and early:
        first = early[0].run.outcome
        outcome = Outcome(
            first.name, f"the run with {stiffness} times {early[0].factor:g}: {first.message}", first.remedy
        )
    again = partial(run_at, max(tolerance / 100, TIGHTEST), 2 * LEAST_STEPS + 1)
    return RigidLimit(model, run, outcome, of_pairs, wanted, again, stiffness, tuple(stiffer))


def _apart(motion: Motion, impacts: Sequence[Any]) -> Array:
    """Return the differences [s] of other impacts from the rigid ones, as long as the same pairs collide.

    Contacts that are closed at the start count as impacts without an approach in compliant runs, and are none here.
    """
    apart = []
    for impact, impulse in zip((one for one in impacts if one.speed > 0), motion.impulses, strict=False):
        if impact.contact != impulse.contact:
            break
        apart.append(impact.t - impulse.t)
    return np.array(apart)
