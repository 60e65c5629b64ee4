"""Study `restitution`: e out of every damping law in one free impact, simulated and in closed form.

One free impact of two bodies beside K d^n, without gravity, from gap 0. Restitution out does not depend on mass,
stiffness or speed, except for laws that take a parameter of their own in place of e: for those it depends on that
parameter times or over the time (m v0^(1-n)/K)^(1/(n+1)).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.model.build import build, impact_trials
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.studies.paper.study_page import (
    Axis,
    Chart,
    Curve,
    Page,
    Panel,
    Progress,
    Study,
    Table,
    Verdict,
)
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps, until_stopped
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.free_impact import Trial

GRID: Array = np.array([*np.arange(0.05, 0.96, 0.05).round(2), 0.99])
OWN_GRID: Array = np.array([0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3])
QUICK = 6  # one in so many values
TOLERANCE = 1e-12
LASTING = 1000  # length of a run in elastic contacts: outlasts the slowest rebound
MAX_STEPS = 5000
AGREEMENT = 1e-9  # of simulated and closed form
SCALE = 0.12  # common limit of the panels; the panel of all laws shows whole what goes beyond
TOP = 1.03  # of a panel of restitutions
_OWN = {"1/s": "{}*(m^2/(K^2 v0))^(1/5)", "s": "{}/(m^2/(K^2 v0))^(1/5)", "N s/m^2.5": "{}*v0/K"}


@dataclass(frozen=True)
class Impact:
    """Free impact: mass [kg], approach speed [m/s], and K of K d^n [SI]."""

    mass: float = 1.0
    speed: float = 1.0
    stiffness: float = 1e8


@dataclass(frozen=True)
class Returned:
    """Restitution out of one law over `prescribed`, shape (k,): e, or the law's dimensionless `parameter`.

    `simulated` (k,), nan where the bodies do not part; `closed` (k,), or None where no closed form is known.
    `recommended`: range of e, None where the law has none. `limits`: e out as e -> 1 and e -> 0, None where unknown.
    """

    law: str
    grade: str
    parameter: str
    prescribed: Array
    simulated: Array
    closed: Array | None
    recommended: tuple[float, float] | None
    recommended_text: str
    limits: tuple[float | None, float | None]

    @property
    def deviation(self) -> Array:
        """Restitution out minus restitution in."""
        return self.simulated - self.prescribed

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Mask of `prescribed` in the recommended range."""
        low, high = self.recommended or (-math.inf, math.inf)
        return (self.prescribed >= low) & (self.prescribed <= high)

    def worst(self, *, inside: bool) -> tuple[float, float]:
        """Return (e, e_out - e) of the largest deviation, in the recommended range or everywhere."""
        deviation = np.where(self.inside | (not inside), self.deviation, 0.0)
        at = int(np.argmax(np.abs(deviation)))
        return float(self.prescribed[at]), float(deviation[at])


def run(quick: bool, progress: Progress, _: Sweeps) -> Page:
    """Simulate every damping law of the catalogue."""
    every = QUICK if quick else 1
    laws, missing = until_stopped(impact_trials(), lambda trial: returned(trial, every), progress)
    return page_of(laws, missing)


def returned(trial: Trial, every: int = 1) -> Returned:
    """Simulate one law over its grid, or one in `every` values of it."""
    takes_e = trial.recommended is not None
    impact, grid = Impact(), (GRID if takes_e else OWN_GRID)[::every]
    unit = 1.0 if takes_e else own_unit(trial, impact)
    model = EngineModel(build(trial.scene))
    closed = [trial.closed(float(e)) for e in grid] if takes_e else [None]
    return Returned(
        law=trial.law.name,
        grade=trial.law.grade,
        parameter="e" if takes_e else _OWN[trial.unit].format(trial.parameter),
        prescribed=grid,
        simulated=np.array([simulated(model, trial, float(x) * unit, impact) for x in grid]),
        closed=None if None in closed else np.array(closed, dtype=float),
        recommended=trial.recommended,
        recommended_text=trial.recommended_text,
        limits=trial.limits,
    )


def simulated(model: EngineModel, trial: Trial, value: float, impact: Impact) -> float:
    """Return the simulated restitution out of one impact; nan where the bodies do not part.

    value: of the law's parameter, in SI.
    """
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


# -- page --------------------------------------------------------------------------------------------------------------


def page_of(laws: Sequence[Returned], missing: str = "") -> Page:
    """Return the page of restitutions; raises KeyboardInterrupt where there are none."""
    taking = sorted(
        (law for law in laws if law.recommended is not None), key=lambda law: round(abs(law.worst(inside=False)[1]), 9)
    )
    others = [law for law in laws if law.recommended is None]
    if not taking:
        raise KeyboardInterrupt
    return Page(
        title="Restitution of one free impact with every damping law",
        paragraphs=(
            "Two bodies meet beside K d^n, without any other force. What is returned does not depend on mass, stiffness or speed; of laws that take "
            "a number of their own in place of e it depends on that number in the units of the impact.",
            "Laws are in the order of their largest deviation, the least first. Panels are cut at "
            f"{SCALE:g}; dotted lines are the ends of the range that is recommended for a law.",
        ),
        tables=(_limits(taking), _values([*taking, *others])),
        charts=(_deviations(taking), _together(taking), *([_own(others)] if others else [])),
        verdicts=tuple(_verdicts(laws, taking)),
        missing=missing,
    )


def _verdicts(laws: Sequence[Returned], taking: Sequence[Returned]) -> Iterator[Verdict]:
    known = [(law, law.closed) for law in laws if law.closed is not None]
    off = float(np.max([np.max(np.abs(law.simulated - closed)) for law, closed in known]))
    yield Verdict(
        f"simulated and closed form of {len(known)} laws differ by at most {off:.1e} (limit {AGREEMENT:.0e})",
        "h (1 + e) = ln((1 + h)/(1 - h e)); exp(-pi zeta/sqrt(1 - zeta^2))",
        off <= AGREEMENT,
    )
    held = [law.law for law in laws if not np.isfinite(law.simulated).all()]
    yield Verdict(f"the bodies part in every impact{f', but with {held}' if held else ''}", "simulated", not held)
    law = max(taking, key=lambda law: abs(law.worst(inside=True)[1]))
    e, deviation = law.worst(inside=True)
    text = f"the largest deviation in a recommended range is {deviation:+.3f}, of {law.law} at e = {e:g}"
    yield Verdict(text, "simulated, table")


def _limits(taking: Sequence[Returned]) -> Table:
    header = ("law", "grade", "recommended", "worst there at e", "e out - e in there", "e out as e -> 1", "as e -> 0")
    rows = ((law.law, law.grade, law.recommended_text, *law.worst(inside=True), *law.limits) for law in taking)
    return Table("laws", "Laws that take e", tuple((name, "") for name in header), tuple(rows))


def _values(laws: Sequence[Returned]) -> Table:
    header = ("law", "parameter", "given", "simulated", "closed form")
    rows = (
        (law.law, law.parameter, *values)
        for law in laws
        for values in zip(
            law.prescribed.tolist(),
            law.simulated.tolist(),
            [None] * len(law.prescribed) if law.closed is None else law.closed.tolist(),
            strict=True,
        )
    )
    return Table("impacts", "Every impact", tuple((name, "") for name in header), tuple(rows))


def _deviations(taking: Sequence[Returned]) -> Chart:
    """Return a panel for each law: restitution out less restitution in."""
    panels = []
    for law in taking:
        curves = [Curve("simulated", law.prescribed, law.deviation, look="dots")]
        if law.closed is not None:
            curves.insert(0, Curve("closed form", law.prescribed, law.closed - law.prescribed, look="reference"))
        ends = zip(("from", "to"), law.recommended or (), strict=False)
        marks = tuple((end, f"recommended {side} {end:g}") for side, end in ends if 0 < end < 1)
        title, limits = f"{law.law} ({law.grade})", (-SCALE, SCALE)
        panels.append(Panel(title, Axis("e in"), Axis("e out - e in"), tuple(curves), marks, y_limits=limits))
    return Chart("deviations", "Restitution out minus restitution in", tuple(panels), columns=3)


def _together(taking: Sequence[Returned]) -> Chart:
    diagonal = Curve("e out = e in", np.array([0, 1]), np.array([0, 1]), look="reference")
    curves = (diagonal, *(Curve(law.law, law.prescribed, law.simulated) for law in taking))
    panel = Panel("Laws that take e", Axis("e in"), Axis("e out"), curves, y_limits=(0, TOP))
    return Chart("together", "Restitution returned, all laws at once", (panel,))


def _own(others: Sequence[Returned]) -> Chart:
    curves = tuple(
        Curve(f"{law.law}, over {law.parameter}", law.prescribed, law.simulated, look="both") for law in others
    )
    axis = Axis("number of its own, dimensionless", log=True)
    panel = Panel("Laws that take no e", axis, Axis("e out"), curves, y_limits=(0, TOP))
    return Chart("own", "Restitution returned over a number of the law's own", (panel,))


STUDY = Study("restitution", "Which restitution does each damping law return in one free impact?", run)
