"""Study `stiffness`: laws of the literature compared, in one contact and in the slider-crank."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.analysis.effect_study.output_errors import Measurement
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.output.plots.curves import Curves
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.studies.paper.crank_runs import (
    CLEARANCE,
    PENETRATION,
    PIN,
    TURN,
    cells,
    crank_with,
    header,
    measure,
)
from hertzwerk.runtime.studies.paper.study_page import (
    Axis,
    Cell,
    Chart,
    Curve,
    Page,
    Panel,
    Progress,
    Study,
    Table,
    Verdict,
)
from hertzwerk.runtime.studies.paper.study_page import compared as compare
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps, until_stopped, whole
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.law_comparison import ForceCurve

FITTED = "lankarani_nikravesh_cylinders"
LAWS = (
    *(
        "johnson",
        "radzimovsky",
        "dubowsky_freudenstein",
        "esdu_78035",
        "goldsmith_m3",
        "palmgren_si",
        "pereira_internal_si",
    ),
    *(
        "hertz_point",
        "liu_with_length",
        "bai_zhao_repaired",
        "persson",
        "popov_line",
        "hertz_half_width",
        "wang_liu_internal",
    ),
    *("goldsmith", "pereira_internal", FITTED, "liu", "bai_zhao"),
)
"""Laws for a pin in its bush; the last ones are inconsistent as published."""
FEW = ("johnson", "liu_with_length", "wang_liu_internal", "bai_zhao")
DRAWN = ("johnson", "hertz_point", "liu_with_length", "wang_liu_internal")
REFERENCE = "johnson"

DEPTHS, DEPTH = np.geomspace(1e-8, 1e-4, 33), 1e-5
CLEARANCES = np.geomspace(5e-6, 1e-3, 24)
E_EFF, LENGTH, BUSH = 207e9 / (2 * (1 - 0.3**2)), 0.015, 0.010  # Pa, m, m: the slider-crank's
PLAIN = 10.0  # times more or less than Johnson's force: beyond it a value is called abnormal
SAME = 1e-9


@dataclass(frozen=True)
class Law:
    """Law with its forces over DEPTHS, and at DEPTH over CLEARANCES."""

    name: str
    curve: ForceCurve
    over_depth: Array
    over_clearance: Array

    @property
    def label(self) -> str:
        """Name with the grade of a reconstruction, and a mark where units are inconsistent."""
        return f"{self.name}{' (R)' if self.curve.grade == 'R' else ''}{'' if self.consistent else ' *'}"

    @property
    def consistent(self) -> bool:
        """Whether the formula is a force, whatever the units its values are put in."""
        return self.curve.verdict == "consistent"

    @property
    def same_in_mm(self) -> bool:
        """Whether the numbers say so: the forces in mm, N, MPa are those in SI."""
        pairs = zip(self.curve.forces, self.curve.in_mm, strict=True)
        return all((math.isnan(a) and math.isnan(b)) or abs(b - a) <= SAME * abs(a) for a, b in pairs)

    def at(self, depth: float) -> float:
        """Return the force [N] at one of DEPTHS, nan where there is none."""
        return float(self.over_depth[int(np.argmin(np.abs(np.log(DEPTHS / depth))))])

    def exponent(self) -> float:
        """Return the local exponent dlnF/dlnd about DEPTH."""
        i = int(np.argmin(np.abs(np.log(DEPTHS / DEPTH))))
        force = self.over_depth[[i - 1, i + 1]]
        return float(np.log(force[1] / force[0]) / np.log(DEPTHS[i + 1] / DEPTHS[i - 1]))


@dataclass(frozen=True)
class Ride:
    """Law in the slider-crank: numbers with errors, or why there are none, and the steps of one run."""

    law: Law
    measurement: Measurement | None
    steps: int | None
    outcome: str


def run(quick: bool, progress: Progress, _: Sweeps) -> Page:
    """Compare the laws in one contact, then in the slider-crank."""
    laws, n = _laws()
    progress(0.1)
    ridden = [law for law in laws if law.name in (FEW if quick else LAWS)]
    drawn: dict[str, EngineSolution] = {}

    def row(law: Law) -> Ride:
        ride, solution = _ride(law, f"{FITTED}(n={n:.4g})" if law.name == FITTED else law.name)
        if solution is not None and law.name in DRAWN:
            drawn[law.label] = solution
        return ride

    rides, missing = until_stopped(ridden, row, lambda done: progress(0.1 + 0.9 * done))
    return Page(
        title="Stiffness laws of a pin in its bush, side by side",
        paragraphs=(
            "Steel (207 GPa, 0.3), bush radius 10 mm, length 15 mm; clearance 0.5 mm unless it is varied. Every formula is evaluated with SI "
            "values as it is printed; those whose units do not hold (marked *) once more with mm, N, MPa, where another force comes out.",
            f"{FITTED}, marked * too, keeps Hertz's K of a point contact and takes the exponent n = {n:.4f}, fitted to Johnson's force from "
            "0.1 to 10 µm.",
            f"A force is abnormal if it has no real value, or is more than {PLAIN:g} times off Johnson's force, the law of elastic line "
            f"contact, at {DEPTH * 1e6:g} µm. Then one revolution of the slider-crank at 5000 rpm, friction 0.1; inconsistent laws run unchecked.",
        ),
        tables=(_law_table(laws), *((_crank_table(rides),) if rides else ())),
        charts=(_force_chart(laws), *(_crank_charts(rides, drawn) if rides else ())),
        verdicts=(*_law_verdicts(laws), *(_crank_verdicts(rides) if rides else ())),
        missing=missing,
        lacking=(
            "The stiffness expressions of Wang and Liu (2020) are not accessible here: wang_liu_internal is a reconstruction (grade R), one of "
            "several candidates (`hertzwerk laws wang_liu_internal`).",
        ),
    )


def _laws() -> tuple[list[Law], float]:
    """Return all laws, and the exponent fitted to Johnson's force."""
    from hertzwerk.runtime.engine.model.build import force_curve

    depths = np.concatenate([DEPTHS, np.full(len(CLEARANCES), DEPTH)])
    clearances = np.concatenate([np.full(len(DEPTHS), CLEARANCE), CLEARANCES])
    laws: list[Law] = []
    for name in LAWS:
        exponent = fitted_exponent(laws[0].over_depth) if name == FITTED else None
        curve = force_curve(name, depths.tolist(), clearances.tolist(), exponent)
        forces = np.array(curve.forces)
        laws.append(Law(name, curve, forces[: len(DEPTHS)], forces[len(DEPTHS) :]))
    return laws, fitted_exponent(laws[0].over_depth)


def fitted_exponent(forces: Array) -> float:
    """Return the exponent n that fits K d^n best, in the logarithm, to forces over 0.1 to 10 µm."""
    chosen = (DEPTHS > 0.99e-7) & (DEPTHS < 1.01e-5)
    return round(float(np.polyfit(np.log(DEPTHS[chosen]), np.log(forces[chosen]), 1)[0]), 4)


def _ride(law: Law, text: str) -> tuple[Ride, EngineSolution | None]:
    try:
        model = crank_with(text)
        measurement = measure(model, {})
        solution = whole(simulate(model, duration=TURN, tolerance=1e-9, max_steps=200_000))
    except InputError as error:
        return Ride(law, None, None, f"refused: {error.faults[0].found}"), None
    return Ride(
        law, measurement, solution.statistics.steps, measurement.outcome.name
    ), solution if measurement.outcome.finished else None


# -- tables and charts -------------------------------------------------------------------------------------------------


def _abnormal(law: Law, laws: Sequence[Law]) -> str:
    """Return what is abnormal about the force of a law at DEPTH; empty if nothing is."""
    force, ratio = law.at(DEPTH), _ratio(law, laws)
    if math.isnan(force):
        return "no real value"
    return "" if 1 / PLAIN <= ratio <= PLAIN else f"{ratio:.3g} times Johnson's"


def _ratio(law: Law, laws: Sequence[Law]) -> float:
    reference = next(other for other in laws if other.name == REFERENCE)
    return law.at(DEPTH) / reference.at(DEPTH)


def _law_table(laws: Sequence[Law]) -> Table:
    columns = (
        *(
            ("law", ""),
            ("grade", ""),
            ("unit", ""),
            ("units hold", ""),
            ("force at 0.1 µm", "N"),
            ("at 1 µm", "N"),
            ("at 10 µm", "N"),
        ),
        *(
            ("force/Johnson's", ""),
            ("force in mm/in SI", ""),
            ("dlnF/dlnd", ""),
            ("reach at 0.5 mm", "mm"),
            ("reach at 5 µm", "mm"),
        ),
        *(("stated range", ""), ("abnormal", ""), ("source", "")),
    )
    rows: list[tuple[Cell, ...]] = []
    for law in laws:
        curve, i = law.curve, int(np.argmin(np.abs(np.log(DEPTHS / DEPTH))))
        reach = [None if math.isinf(r) else r * 1e3 for r in (curve.reach[0], curve.reach[len(DEPTHS)])]
        in_mm = curve.in_mm[i] / curve.forces[i]
        rows.append((
            law.name, curve.grade, curve.unit, "yes" if law.consistent else "no", *(law.at(x) for x in (1e-7, 1e-6, 1e-5)),
            _ratio(law, laws), in_mm, law.exponent(), *reach, curve.ranges, _abnormal(law, laws), curve.source,
        ))  # fmt: skip
    return Table("laws", "The laws in one contact", columns, tuple(rows))


def _crank_table(rides: Sequence[Ride]) -> Table:
    columns = (("law", ""), ("units hold", ""), ("outcome", ""), *header(), ("steps", ""))
    rows: list[tuple[Cell, ...]] = []
    for ride in rides:
        numbers = [None] * (len(columns) - 4) if ride.measurement is None else cells(ride.measurement)
        rows.append((ride.law.name, "yes" if ride.law.consistent else "no", ride.outcome, *numbers, ride.steps))
    return Table("slider_crank", "One revolution of the slider-crank", columns, tuple(rows))


def _force_chart(laws: Sequence[Law]) -> Chart:
    reference = next(law for law in laws if law.name == REFERENCE)
    groups = {"units hold": [law for law in laws if law.consistent and law is not reference],
              "units do not hold *": [law for law in laws if not law.consistent]}  # fmt: skip
    depth, clearance = Axis("penetration", "µm", log=True), Axis("clearance", "mm", log=True)
    force, ratio = Axis("force", "N", log=True), Axis("force/Johnson's", log=True)
    kinds: tuple[tuple[str, Axis, Axis, Array, Callable[[Law], Array]], ...] = (
        ("Force over penetration", depth, force, DEPTHS * 1e6, lambda law: law.over_depth),
        ("Over Johnson's", depth, ratio, DEPTHS * 1e6, lambda law: law.over_depth / reference.over_depth),
        (f"At {DEPTH * 1e6:g} µm over clearance", clearance, force, CLEARANCES * 1e3, lambda law: law.over_clearance),
    )
    panels = [
        Panel(f"{kind}: {title}", x, y, (
            Curve(reference.label, at, values(reference), look="reference"),
            *(Curve(law.label, at, values(law)) for law in group),
        ))
        for kind, x, y, at, values in kinds
        for title, group in groups.items()
    ]  # fmt: skip
    return Chart(
        "forces", "Stiffness laws of a steel pin in its bush, SI values put in", tuple(panels),
        note="A curve ends where its law does. (R): a reconstruction, as the paper's own could not be had. *: units do not hold as published.",
    )  # fmt: skip


def _crank_charts(rides: Sequence[Ride], drawn: Mapping[str, EngineSolution]) -> tuple[Chart, ...]:
    """Draw peak force and penetration by law, and the force of some laws over time."""
    done = [(ride.law, ride.measurement) for ride in rides if ride.measurement is not None and ride.measurement.numbers]
    done.sort(key=lambda pair: pair[1].numbers["peak_force"].value)
    names = Axis("", labels=tuple(law.label for law, _ in done))
    panels = []
    for output, axis, factor in (
        ("peak_force", Axis("peak force", "kN", log=True), 1e3),
        (PENETRATION, Axis("peak penetration", "µm", log=True), 1e-6),
    ):
        curves = []
        for title, wanted in (("units hold", True), ("units do not hold", False)):
            chosen = [(i, measurement) for i, (law, measurement) in enumerate(done) if law.consistent is wanted]
            values, errors = (
                np.array([getattr(f.numbers[output], p) / factor for _, f in chosen]) for p in ("value", "error")
            )
            curves.append(Curve(title, values, np.array([i for i, _ in chosen], dtype=float), errors, "dots"))
        panels.append(Panel(axis.name.capitalize(), axis, names, tuple(curves)))
    bars = Chart("slider_crank", "One revolution of the slider-crank, 5000 rpm, clearance 0.5 mm", tuple(panels))
    time, force = Axis("time", "ms", history="t"), Axis("force", "kN", history=f"{PIN}.normal_force")
    traces = {label: Curves.of(solution) for label, solution in drawn.items()}
    window = min((c.run.impacts[1].t + 1e-4 for c in traces.values() if len(c.run.impacts) > 1), default=math.inf)
    ends = max(window * 1.5, 6e-4)
    shown = tuple(
        Curve(label, c.t[c.t < ends] * 1e3, c[f"{PIN}.normal_force"][c.t < ends] * 1e-3) for label, c in traces.items()
    )
    first = Panel("Contact force of the first impacts", time, force, shown)
    whole = Panel("Of the whole revolution, cut", time, force, tuple(
        Curve(label, c.t * 1e3, c[f"{PIN}.normal_force"] * 1e-3) for label, c in traces.items()
    ), y_limits=(0, 30))  # fmt: skip
    return (bars, Chart("force", "Slider-crank: the contact force under some of the laws", (first, whole)))


# -- verdicts ----------------------------------------------------------------------------------------------------------


def johnson_penetration(force: float) -> float:
    """Return the penetration [m] that Johnson's law as printed, d(F), has at a force [N]."""
    load = force / (math.pi * E_EFF * LENGTH)
    return load * (math.log(4 * CLEARANCE / load) - 1)


def _law_verdicts(laws: Sequence[Law]) -> tuple[Verdict, ...]:
    named = {law.name: law for law in laws}
    wrong = [law for law in laws if not law.consistent]
    changed = [law for law in laws if not law.same_in_mm]
    abnormal = {law.label: remark for law in laws if (remark := _abnormal(law, laws))}
    sly = [law.label for law in wrong if law.label not in abnormal]
    point = 4 / 3 * E_EFF * math.sqrt(BUSH * (BUSH - CLEARANCE) / CLEARANCE) * DEPTH**1.5
    least, most = (f(_ratio(law, laws) for law in laws if law.consistent) for f in (min, max))
    short = min((law for law in laws if law.consistent), key=lambda law: law.curve.reach[0])
    return (
        compare("Hertz's point contact at 10 µm [N]", named["hertz_point"].at(DEPTH), point, SAME, "(4/3) E* sqrt(R) d^(3/2)"),
        compare(
            "Johnson's force at 10 µm put into d(F) [m]", johnson_penetration(named["johnson"].at(DEPTH)), DEPTH, SAME,
            "Johnson, Contact Mechanics (1985), implicit as printed",
        ),
        Verdict(
            f"{len(wrong)} of {len(laws)} laws are no force as published: {', '.join(f'{law.name} ({law.curve.unit})' for law in wrong)}; "
            f"put in in mm, N, MPa, {len(changed)} give another force",
            "audit of units, and numbers in other units, which must agree", wrong == changed,
        ),
        Verdict(
            "abnormal: " + (", ".join(f"{label} {remark}" for label, remark in abnormal.items()) or "none")
            + f"; inconsistent, but not detected by its values: {', '.join(sly) or 'none'}",
            f"forces at {DEPTH * 1e6:g} µm, clearance 0.5 mm",
        ),
        Verdict(
            f"laws whose units hold lie within {least:.3g} to {most:.3g} times Johnson's force: consistent units do not make a law correct",
            f"forces at {DEPTH * 1e6:g} µm, clearance 0.5 mm",
        ),
        Verdict(
            f"shortest reach: {short.name}, {short.curve.reach[0] * 1e3:.3g} mm at a clearance of 0.5 mm and "
            f"{short.curve.reach[len(DEPTHS)] * 1e6:.3g} µm at {CLEARANCES[0] * 1e6:.3g} µm",
            "turning point dd/dF = 0 of the logarithmic laws, or the smaller radius",
        ),
    )  # fmt: skip


def _crank_verdicts(rides: Sequence[Ride]) -> tuple[Verdict, ...]:
    sound = {
        r.law.name: r.measurement.numbers
        for r in rides
        if r.law.consistent and r.measurement is not None and r.measurement.numbers
    }
    failed = [f"{ride.law.name} ({ride.outcome})" for ride in rides if ride.outcome != "finished"]
    steps = {ride.law.name: ride.steps for ride in rides if ride.steps and ride.outcome == "finished"}
    source = "simulated; each number with its error in the table"
    weak, strong = (f(sound, key=lambda name: sound[name]["peak_force"].value) for f in (min, max))
    ratio = sound[strong]["peak_force"].value / sound[weak]["peak_force"].value
    few, many = (f(steps, key=lambda name: steps[name]) for f in (min, max))
    return (
        Verdict(f"peak force of laws whose units hold: a factor of {ratio:.3g}, from {weak} to {strong}", source),
        Verdict(f"runs that do not finish: {', '.join(failed) or 'none'}", source),
        Verdict(f"steps of one revolution: {steps[few]} ({few}) to {steps[many]} ({many})", source),
    )


STUDY = Study(
    "stiffness", "Do the improved stiffness laws of the literature have consistent units, and where do they agree?", run
)
