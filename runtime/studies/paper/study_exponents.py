"""Study `exponents`: Hertz's stiffness with another exponent n, the number of K kept.

The central mistake that Wang and Liu (2020) point out: K of a point contact is N/m^1.5, so that K d^n is a force for n
= 3/2 only.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.analysis.effect_study.output_errors import Measurement
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.output.plots.curves import Curves, impact_curves
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.studies.paper.crank_runs import (
    CLEARANCE,
    OUTPUTS,
    PENETRATION,
    PIN,
    TURN,
    cells,
    crank_with,
    header,
    measure,
)
from hertzwerk.runtime.studies.paper.study_page import Axis, Chart, Curve, Page, Panel, Progress, Study, Table, Verdict
from hertzwerk.runtime.studies.paper.study_page import compared as compare
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps, until_stopped, whole

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.law_comparison import ExponentUnit

EXPONENTS = (1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0)
FEW = (1.0, 1.5, 2.0)
DRAWN = (1.0, 1.5, 2.0)
STIFFNESS = 4 / 3 * 207e9 / (2 * (1 - 0.3**2)) * math.sqrt(0.010 * 0.0095 / 0.0005)  # N/m^1.5, the pin in its bush
MASS, SPEED, RESTITUTION = 0.21 * 0.14 / (0.21 + 0.14), 1.0, 0.9  # kg of rod and slider, m/s
DAMPING = 3 / 4 * (1 - RESTITUTION**2)  # h of Lankarani and Nikravesh
UNNOTICED, SUNK = 0.02, 0.5  # of the clearance: penetrations that no picture shows; that are no small deformation
TOLERANCE, AGREEMENT, SAME = 1e-11, 1e-6, 1e-12
PAPER = "Wang, Liu, Mech. Mach. Theory 153 (2020) 103986"
RELATION = "free impact in closed form: K dmax^(n+1)/(n+1) = m v0^2 (h - ln(1 + h))/h^2"


@dataclass(frozen=True)
class Impact:
    """One free impact: largest penetration [m] and force [N], duration [s], restitution, loop."""

    unit: ExponentUnit
    depth: float
    force: float
    duration: float
    restitution: float
    steps: int
    loop: tuple[Any, Any, Any]

    @property
    def closed_depth(self) -> float:
        """Largest penetration in closed form [m]."""
        return closed_depth(self.unit.exponent)


def closed_depth(n: float) -> float:
    """Return the largest penetration [m] of the free impact in closed form."""
    work = MASS * SPEED**2 * (DAMPING - math.log1p(DAMPING)) / DAMPING**2
    return float(((n + 1) * work / STIFFNESS) ** (1 / (n + 1)))


def run(quick: bool, progress: Progress, _: Sweeps) -> Page:
    """Compare exponents in one impact, then in the slider-crank."""
    exponents = FEW if quick else EXPONENTS
    impacts = _impacts(exponents)
    progress(0.1)
    drawn: dict[float, EngineSolution] = {}
    model = crank_with(None)

    def row(n: float) -> tuple[float, Measurement, int]:
        measurement = measure(model, {"exponent": n})
        turn = whole(simulate(model, duration=TURN, tolerance=1e-9, parameters={"exponent": n}))
        if n in DRAWN:
            drawn[n] = turn
        return n, measurement, turn.statistics.steps

    rows, missing = until_stopped(exponents, row, lambda done: progress(0.1 + 0.85 * done))
    return replace(_page(impacts, rows, drawn), missing=missing)


def _impacts(exponents: tuple[float, ...]) -> list[Impact]:
    from hertzwerk.runtime.engine.model.build import build, exponent_unit, impact_trials
    from hertzwerk.runtime.engine.model.model import EngineModel

    trial = next(trial for trial in impact_trials() if trial.law.name == "lankarani_nikravesh")
    model, impacts = EngineModel(build(trial.scene)), []
    for n in exponents:
        values: dict[str, Value] = {
            "mass": f"{MASS!r} kg",
            "approach": f"{SPEED!r} m/s",
            "e": RESTITUTION,
            "exponent": n,
        }
        values["stiffness"] = f"{STIFFNESS!r} N/m^{n:g}"  # the number kept, under the unit that makes it run
        lasting = 5 * closed_depth(n) / SPEED
        run = simulate(model, duration=lasting, tolerance=TOLERANCE, parameters=values)
        (impact,) = run.impacts
        impacts.append(
            Impact(
                exponent_unit(n), impact.peak_penetration, impact.peak_force, impact.duration or math.nan,
                run.engine.final["ball.speed"] / SPEED, run.statistics.steps, impact_curves(run, impact),
            )
        )  # fmt: skip
    return impacts


def _page(
    impacts: list[Impact], rows: list[tuple[float, Measurement, int]], drawn: Mapping[float, EngineSolution]
) -> Page:
    return Page(
        title="Hertz's stiffness with n from 1 to 2, its number kept",
        paragraphs=(
            f"K = {STIFFNESS:.4g} N/m^1.5 is that of the steel pin (9.5 mm) in its bush (10 mm) as a point contact. Its number is kept while n "
            "goes from 1 to 2, as the literature does: that is another law in other units, not another exponent of the same law.",
            f"One impact: the reduced mass {MASS:.3g} kg of rod and slider meets the wall at {SPEED:g} m/s, restitution {RESTITUTION:g} by "
            "Lankarani and Nikravesh. Then one revolution of the slider-crank at 5000 rpm, clearance 0.5 mm, friction 0.1, K d^n run unchecked.",
            f"Penetrations below {100 * UNNOTICED:g} % of the clearance count as unnoticed: no picture of the mechanism shows them, and the joint "
            f"looks ideal. Above {100 * SUNK:g} % the pin has sunk into its bush, and deformations are no longer small.",
        ),
        tables=(_impact_table(impacts), *((_crank_table(rows),) if rows else ())),
        charts=(_impact_chart(impacts), *((_crank_chart(rows, drawn),) if rows else ())),
        verdicts=(*_impact_verdicts(impacts), *(_crank_verdicts(rows) if rows else ())),
        lacking=("The numbers of the paper's own study of n are not accessible here; data of the mechanism: grade C.",),
    )


def _impact_table(impacts: list[Impact]) -> Table:
    header = (
        *(
            ("n", ""),
            ("K d^n is", ""),
            ("verdict", ""),
            ("force read in mm", ""),
            ("penetration", "µm"),
            ("closed form", "µm"),
        ),
        *(("peak force", "kN"), ("duration", "µs"), ("restitution", ""), ("steps", "")),
    )
    return Table("impact", "One impact", header, tuple(
        (
            i.unit.exponent, i.unit.unit, "consistent" if i.unit.consistent else "inconsistent", i.unit.in_mm, i.depth * 1e6,
            i.closed_depth * 1e6, i.force * 1e-3, i.duration * 1e6, i.restitution, i.steps,
        )
        for i in impacts
    ))  # fmt: skip


def _crank_table(rows: list[tuple[float, Measurement, int]]) -> Table:
    columns = (("n", ""), ("outcome", ""), *header(), ("penetration/clearance", ""), ("deformation", ""), ("steps", ""))
    table = (
        (n, measurement.outcome.name, *cells(measurement), _share(measurement), _called(_share(measurement)), steps)
        for n, measurement, steps in rows
    )
    return Table("slider_crank", "One revolution of the slider-crank", columns, tuple(table))


def _share(measurement: Measurement) -> float | None:
    """Return the largest penetration over the clearance; None where the run failed."""
    number = measurement.numbers.get(PENETRATION)
    return None if number is None else float(number.value / CLEARANCE)


def _called(share: float | None) -> str:
    if share is None:
        return "diverged"
    return "unnoticed" if share < UNNOTICED else "sunk" if share > SUNK else "noticed"


def _impact_chart(impacts: list[Impact]) -> Chart:
    n = np.array([i.unit.exponent for i in impacts])
    shown = [i for i in impacts if i.unit.exponent in DRAWN]
    depth, force = Axis("penetration", "µm", log=True), Axis("normal force", "kN", log=True)
    loops = tuple(Curve(f"n = {i.unit.exponent:g}", i.loop[2][1:-1] * 1e6, i.loop[1][1:-1] * 1e-3) for i in shown)
    scaled = tuple(Curve(f"n = {i.unit.exponent:g}", i.loop[2] / i.depth, i.loop[1] / i.force) for i in shown)
    fine = np.linspace(n[0], n[-1], 101)
    return Chart(
        "impact",
        "One impact: K d^n, the number of K kept",
        (
            Panel("Hysteresis loops", depth, force, loops),
            Panel("Hysteresis loops, each scaled by its peak values", Axis("penetration/peak"), Axis("force/peak"), scaled),
            Panel("Peak penetration", Axis("exponent n"), Axis("penetration", "µm", log=True), (
                Curve("closed form", fine, np.array([closed_depth(x) for x in fine]) * 1e6, look="reference"),
                Curve("simulated", n, np.array([i.depth for i in impacts]) * 1e6, look="dots"),
            )),
            Panel("The same numbers read in mm: factor on the force", Axis("exponent n"), Axis("force in mm over force in m", log=True), (
                Curve("1000^(n - 3/2), of a force", fine, 1000 ** (fine - 1.5), look="reference"),
                Curve("by numbers alone", n, np.array([i.unit.in_mm for i in impacts]), look="dots"),
            )),
        ),
        note="A force does not depend on the unit of length: that factor is 1 at n = 3/2 alone.",
    )  # fmt: skip


def _crank_chart(rows: list[tuple[float, Measurement, int]], drawn: Mapping[float, EngineSolution]) -> Chart:
    done = [(n, measurement) for n, measurement, _ in rows if len(measurement.numbers) == len(OUTPUTS)]
    n, exponent = np.array([row[0] for row in done]), Axis("exponent n")
    parted = [f"{x:g}" for x, measurement in done if measurement.past_horizon]

    def over_n(output: str, factor: float) -> Curve:
        numbers = [measurement.numbers[output] for _, measurement in done]
        values, errors = (np.array([getattr(x, part) for x in numbers]) / factor for part in ("value", "error"))
        return Curve("slider-crank", n, values, errors, "both")

    curves = {x: Curves.of(solution) for x, solution in sorted(drawn.items())}
    ideal = next((c.ideal for c in curves.values() if c.ideal is not None), None)
    time, first = Axis("time", "ms", history="t"), next(iter(curves.values()))
    reference = () if ideal is None else (
        Curve("ideal mechanism", first.t * 1e3, ideal.acceleration_of("guide.speed") * 1e-3, look="reference"),
    )  # fmt: skip
    ends = n[[-1, 0]]
    return Chart(
        "slider_crank",
        "Slider-crank, 5000 rpm, clearance 0.5 mm: K d^n, the number of K kept",
        (
            Panel("Largest contact force", exponent, Axis("peak force", "kN", log=True), (over_n("peak_force", 1e3),)),
            Panel("Peak penetration", exponent, Axis("penetration/clearance", log=True), (
                over_n(PENETRATION, CLEARANCE),
                Curve(f"unnoticed below {UNNOTICED:g}", ends[::-1], np.full(2, UNNOTICED), look="dashed"),
                Curve(f"sunk above {SUNK:g}", ends, np.full(2, SUNK), look="dashed"),
            )),
            Panel("Contact force, cut", time, Axis("force", "kN", log=True, history=f"{PIN}.normal_force"), tuple(
                Curve(f"n = {x:g}", c.t * 1e3, c[f"{PIN}.normal_force"] * 1e-3) for x, c in curves.items()
            ), y_limits=(0.05, 600)),
            Panel("Acceleration of the slider, cut", time, Axis("acceleration", "km/s²", history="guide.acceleration"), (
                *reference, *(Curve(f"n = {x:g}", c.t * 1e3, c["guide.acceleration"] * 1e-3) for x, c in curves.items()),
            ), y_limits=(-60, 60)),
        ),
        note=f"One revolution, {f'past the horizon of n = {chr(44).join(parted)}' if parted else 'within the horizon of every run'}; where no "
        "band is seen, errors of the upper panels are smaller than their points.",
    )  # fmt: skip


def _impact_verdicts(impacts: list[Impact]) -> tuple[Verdict, ...]:
    sound = [i.unit.exponent for i in impacts if i.unit.consistent]
    exact = [i.unit.exponent for i in impacts if abs(i.unit.in_mm - 1) < SAME]
    extremes = [f(i.unit.in_mm for i in impacts) for f in (min, max)]
    worst = max(impacts, key=lambda i: abs(i.depth / i.closed_depth - 1))
    spread = max(i.restitution for i in impacts) - min(i.restitution for i in impacts)
    first, last = impacts[0], impacts[-1]
    return (
        Verdict(
            f"of {len(impacts)} exponents K d^n is newton for n = {', '.join(f'{n:g}' for n in sound) or 'none'}",
            f"audit of units; {PAPER}",
            sound == [1.5],
        ),
        Verdict(
            f"read in millimetres the same law gives the same force for n = {', '.join(f'{n:g}' for n in exact) or 'none'}; for the others "
            "{:.3g} to {:.3g} times".format(*extremes),
            "numbers alone, no symbols", exact == [1.5],
        ),
        compare(f"peak penetration at n = {worst.unit.exponent:g} [m]", worst.depth, worst.closed_depth, AGREEMENT, RELATION),
        Verdict(
            f"restitution does not see the exponent: it differs by {spread:.0e} over all n, while the force falls from "
            f"{first.force * 1e-3:.3g} to {last.force * 1e-3:.3g} kN and the impact lasts {last.duration / first.duration:.0f} times as long",
            "h (1 + e) = ln((1 + h)/(1 - h e)), whatever the elastic force", spread < AGREEMENT,
        ),
    )  # fmt: skip


def _crank_verdicts(rows: list[tuple[float, Measurement, int]]) -> tuple[Verdict, ...]:
    called = grouped((_called(_share(measurement)), f"{n:g}") for n, measurement, _ in rows)
    forces = {n: measurement.numbers["peak_force"] for n, measurement, _ in rows if "peak_force" in measurement.numbers}
    steps = {n: count for n, _, count in rows}
    least, most = min(steps, key=lambda n: steps[n]), max(steps, key=lambda n: steps[n])
    source = "simulated; each number with its error in the table"
    texts = [
        f"no deformation is noticed (below {100 * UNNOTICED:g} % of the clearance) for n = {', '.join(called['unnoticed'])}: the joint looks ideal"
        if "unnoticed" in called else "at every n the deformation is noticed",
        f"the pin sinks into its bush by more than half the clearance for n = {', '.join(called['sunk'])}"
        if "sunk" in called else "at no n the pin sinks by more than half the clearance",
        f"runs that do not finish: n = {', '.join(called['diverged'])}" if "diverged" in called else "every run finishes: nothing stops a "
        "simulation with inconsistent units",
        f"steps of one revolution: from {steps[least]} (n = {least:g}) to {steps[most]} (n = {most:g})",
    ]  # fmt: skip
    if {1.0, 1.5, 2.0} <= forces.keys():
        ratios = (forces[n].value / forces[1.5].value for n in (1.0, 2.0))
        texts.insert(
            0, "peak force of the mechanism: {:.3g} times Hertz's at n = 1, {:.3g} times at n = 2".format(*ratios)
        )
    return tuple(Verdict(text, source) for text in texts)


STUDY = Study(
    "exponents",
    "May the exponent of Hertz's law change while its stiffness keeps its number?",
    run,
    {f"{PIN}.normal_force": "N", "guide.acceleration": "m/s^2"},
)
