"""Restitution study: e out of every damping law, simulated and in closed form.

One free impact of two bodies beside K d^n, without gravity, from gap 0. Restitution out does not depend on mass,
stiffness or speed, except for laws that take a parameter of their own in place of e: for those it depends on that
parameter times or over the time (m v0^(1-n)/K)^(1/(n+1)).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.free_impact import Trial
    from hertzwerk.runtime.engine.model.model import EngineModel


GRID: Array = np.array([*np.arange(0.05, 0.96, 0.05).round(2), 0.99])
OWN_GRID: Array = np.array([0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3])
TOLERANCE = 1e-12
LASTING = 1000  # length of a run in elastic contacts: outlasts the slowest rebound
MAX_STEPS = 5000
AGREEMENT = 1e-9  # of simulated and closed form


@dataclass(frozen=True)
class Impact:
    """Free impact: mass [kg], approach speed [m/s], and K of K d^n [SI]."""

    mass: float = 1.0
    speed: float = 1.0
    stiffness: float = 1e8


@dataclass(frozen=True)
class Curve:
    """Restitution out of one law over `prescribed`, shape (k,): e, or the law's dimensionless `parameter`.

    `simulated` (k,); `closed` (k,), or None where no closed form is known. `recommended`: range of e, None where the
    law has none.
    """

    law: str
    title: str
    grade: str
    parameter: str
    prescribed: Array
    simulated: Array
    closed: Array | None
    recommended: tuple[float, float] | None
    recommended_text: str
    coefficient_limits: tuple[str, str]
    out_at_one: float | None
    out_at_zero: float | None

    @property
    def takes_restitution(self) -> bool:
        """Return whether `prescribed` is the restitution in."""
        return self.recommended is not None

    @property
    def deviation(self) -> Array:
        """Restitution out minus restitution in."""
        return self.simulated - self.prescribed

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Mask of `prescribed` in the recommended range."""
        low, high = self.recommended or (-math.inf, math.inf)
        return (self.prescribed >= low) & (self.prescribed <= high)

    @property
    def difference(self) -> float | None:
        """Largest |simulated - closed|; None without a closed form."""
        return None if self.closed is None else float(np.max(np.abs(self.simulated - self.closed)))

    def worst(self, *, inside: bool) -> tuple[float, float]:
        """Return (e, e_out - e) of the largest deviation, in the recommended range or everywhere."""
        deviation = np.where(
            self.inside if inside else np.full(len(self.prescribed), fill_value=True), self.deviation, 0.0
        )
        at = int(np.argmax(np.abs(deviation)))
        return float(self.prescribed[at]), float(deviation[at])

    def record(self) -> dict[str, Any]:
        """Return the curve as JSON."""
        worst, everywhere = self.worst(inside=True), self.worst(inside=False)
        about = {
            "law": self.law,
            "title": self.title,
            "grade": self.grade,
            "parameter": self.parameter,
            "prescribed": self.prescribed.tolist(),
            "simulated": self.simulated.tolist(),
            "closed": None if self.closed is None else self.closed.tolist(),
            "largest_difference": self.difference,
        }
        if not self.takes_restitution:
            return about
        return about | {
            "recommended": self.recommended_text,
            "worst_recommended": {"e": worst[0], "deviation": worst[1]},
            "worst": {"e": everywhere[0], "deviation": everywhere[1]},
            "coefficient_at_one": self.coefficient_limits[0],
            "coefficient_at_zero": self.coefficient_limits[1],
            "out_at_one": self.out_at_one,
            "out_at_zero": self.out_at_zero,
        }


@dataclass(frozen=True)
class Study:
    """Curves of the laws that take e, the best over all e first, and of the others."""

    curves: tuple[Curve, ...]
    others: tuple[Curve, ...]

    @property
    def difference(self) -> float:
        """Largest |simulated - closed| of all."""
        return max(curve.difference for curve in self.curves if curve.difference is not None)

    @property
    def agrees(self) -> bool:
        """Return whether every impact ended and agrees with its closed form."""
        ended = all(np.all(np.isfinite(curve.simulated)) for curve in (*self.curves, *self.others))
        return ended and self.difference <= AGREEMENT

    def record(self) -> dict[str, Any]:
        """Return the study as JSON."""
        return {
            "tolerance": TOLERANCE,
            "largest_difference": self.difference,
            "laws": [curve.record() for curve in self.curves],
            "laws_without_restitution": [curve.record() for curve in self.others],
        }

    def csv(self) -> str:
        """Return one row per law and value: law, parameter, given, simulated, closed (may be empty)."""
        lines = ["law,parameter,given,simulated,closed"]
        for curve in (*self.curves, *self.others):
            closed: Sequence[Any] = (
                [""] * len(curve.prescribed) if curve.closed is None else [f"{c:.17g}" for c in curve.closed]
            )
            rows = zip(curve.prescribed, curve.simulated, closed, strict=True)
            lines += [
                f'{curve.law},"{curve.parameter}",{prescribed:.17g},{out:.17g},{exact}'
                for prescribed, out, exact in rows
            ]
        return "\n".join(lines) + "\n"


def study(progress: Callable[[float], object] | None = None) -> Study:
    """Simulate every damping law of the catalogue."""
    from hertzwerk.runtime.engine.model.build import impact_trials

    trials = impact_trials()
    curves = []
    for i, trial in enumerate(trials):
        if progress is not None:
            progress(i / len(trials))
        curves.append(curve(trial))
    own = [c for c in curves if not c.takes_restitution]
    taken = sorted((c for c in curves if c.takes_restitution), key=lambda c: round(abs(c.worst(inside=False)[1]), 9))
    return Study(tuple(taken), tuple(own))


def curve(trial: Trial, grid: Array | None = None, impact: Impact | None = None) -> Curve:
    """Simulate one law over its grid, or over `grid`."""
    from hertzwerk.runtime.engine.model.build import build
    from hertzwerk.runtime.engine.model.model import EngineModel

    impact = impact or Impact()
    takes_e = trial.recommended is not None
    if grid is None:
        grid = GRID if takes_e else OWN_GRID
    unit = 1.0 if takes_e else own_unit(trial, impact)
    model = EngineModel(build(trial.scene))
    closed = [trial.closed(float(e)) for e in grid] if takes_e else []
    at_one, at_zero = trial.limits
    law = trial.law
    return Curve(
        law=law.name,
        title=law.title,
        grade=law.grade,
        parameter="e" if takes_e else _OWN[trial.unit].format(trial.parameter),
        prescribed=grid,
        simulated=np.array([simulated(model, trial, float(x) * unit, impact) for x in grid]),
        closed=None if not closed or None in closed else np.array(closed, dtype=float),
        recommended=trial.recommended,
        recommended_text=trial.recommended_text,
        coefficient_limits=(str(law.at_one), str(law.at_zero)),
        out_at_one=at_one,
        out_at_zero=at_zero,
    )


def simulated(model: EngineModel, trial: Trial, value: float, impact: Impact) -> float:
    """Return the simulated restitution out of one impact; nan where the bodies do not part.

    value: of the law's parameter, in SI.
    """
    from hertzwerk.runtime.simulation import simulate

    n = trial.exponent
    depth = ((n + 1) * impact.mass * impact.speed**2 / (2 * impact.stiffness)) ** (1 / (n + 1))
    run = simulate(
        model,
        duration=LASTING * depth / impact.speed,
        tolerance=TOLERANCE,
        max_steps=MAX_STEPS,
        parameters={
            "mass": f"{impact.mass!r} kg",
            "approach": f"{impact.speed!r} m/s",
            "exponent": n,
            "stiffness": f"{impact.stiffness!r} N/m^{n:g}",
            trial.parameter: (value, trial.unit),
        },
    )
    apart = run.outcome.finished and run["wall.gap"][-1] > 0
    return run.engine.final["ball.speed"] / impact.speed if apart else math.nan


def own_unit(trial: Trial, impact: Impact) -> float:
    """Return the unit [SI] of a law's own parameter in powers of the impact's mass, length and time."""
    n = trial.exponent
    time = (impact.mass * impact.speed ** (1 - n) / impact.stiffness) ** (1 / (n + 1))
    mass, length, seconds, *_ = (float(exponent.constant) for exponent in parse_unit(trial.unit).exponents)
    return float(impact.mass**mass * (impact.speed * time) ** length * time**seconds)


_OWN = {"1/s": "{}*(m^2/(K^2 v0))^(1/5)", "s": "{}/(m^2/(K^2 v0))^(1/5)", "N s/m^2.5": "{}*v0/K"}
