"""Study `slider_crank`: clearance between rod and slider, laws side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_request import progress_of
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.plots.curves import Curves
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.paper.crank_runs import PIN, SCENE
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
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps
from hertzwerk.runtime.system.arrays import Array

CRANK, ROD = 0.05, 0.12  # m, of the scene
FRICTION = f"{PIN}_friction"
OUTPUTS = {  # of a row: name, unit, SI of the unit
    f"{PIN}.impact_rate": ("impacts", "1/s", 1.0),
    f"{PIN}.mean_peak_force": ("mean peak force", "N", 1.0),
    f"{PIN}.mean_largest_force": ("peak force of a turn", "N", 1.0),
    f"{PIN}.mean_force": ("mean force", "N", 1.0),
    f"{PIN}.dissipated_power": ("power lost in contact", "W", 1.0),
}
RATE, SEVERITY = f"{PIN}.impact_rate", f"{PIN}.mean_largest_force"


@dataclass(frozen=True)
class Plan:
    """Extent of the study: laws, clearances [mm], speeds [rpm], turns for averages, for sections."""

    laws: tuple[str, ...]
    clearances: tuple[float, ...]
    speeds: tuple[float, ...]
    turns: int
    returns: int


WHOLE = Plan(
    ("hertz_point", "johnson", "liu_with_length", "pereira_internal_si", "wang_liu_internal"),
    (0.05, 0.1, 0.2, 0.3, 0.5), (100, 500, 1000, 2000, 5000), 30, 200,
)  # fmt: skip
QUICK = Plan(("hertz_point", "wang_liu_internal"), (0.1, 0.5), (5000,), 10, 10)
DRAWN_SPEED, DRAWN_CLEARANCE, DRAWN_TURNS = 5000.0, 0.5, 3  # of the trajectories and sections
ACCURACY, TOLERANCE, TRANSIENT = 1e-5, 1e-7, 0.2
CLOSED = 1e-5  # of the energy moved
PAPER = "Data of Ravn, Schwab and Flores (grade C), friction 0.1, restitution 0.9 by Lankarani and Nikravesh"


@dataclass(frozen=True)
class Case:
    """Long run of a law at a clearance [mm] and a speed [rpm].

    `residual`: of its energy balance. `numbers`: averages and half the widths of their intervals, SI; nan is none.
    """

    law: str
    friction: bool
    clearance: float
    speed: float
    outcome: str
    residual: float
    numbers: Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class Trajectory:
    """Turns of one law from the start, with their error; returns of the crank, shape (n, 4)."""

    law: str
    friction: bool
    curves: Curves
    returns: Array

    @property
    def label(self) -> str:
        """Law, and whether without friction."""
        return _label(self.law) if self.friction else f"{_label(self.law)}, no friction"

    @property
    def run(self) -> Solution:
        """The run."""
        return self.curves.run  # type: ignore[return-value]

    @property
    def horizon(self) -> float:
        """Time up to which the trajectory is valid [s]."""
        error = self.run.error
        return self.run.engine.t_end if error is None or error.horizon is None else error.horizon


def run(quick: bool, progress: Progress, sweeps: Sweeps) -> Page:
    """Run the laws side by side: trajectories, sections, averages."""
    plan = QUICK if quick else WHOLE
    cases = list(_cases(plan, sweeps, lambda done: progress(0.8 * done)))  # first, as they are kept
    trajectories = []
    pairs = [(law, friction) for friction in (True, False) for law in plan.laws]
    for i, (law, friction) in enumerate(pairs):
        trajectories.append(_trajectory(law, plan.returns, friction=friction))
        progress(0.8 + 0.2 * (i + 1) / len(pairs))
    return Page(
        title="Slider-crank with clearance between rod and slider, laws side by side",
        paragraphs=(
            f"{PAPER}. Trajectories: {DRAWN_TURNS} revolutions at {DRAWN_SPEED:g} rpm, clearance {DRAWN_CLEARANCE:g} mm, each "
            f"with the estimate of its error; they are the true ones up to the horizon, where the error reaches 1 % of the clearance.",
            f"Beyond it only averages are: over {plan.turns} revolutions less a tenth, with 95 % intervals from the means of blocks of whole "
            "revolutions (±, half the width). An empty ± says that the blocks are too few or still correlated.",
            f"Poincare sections: states at the returns of the crank to angle 0, {plan.returns} revolutions less {100 * TRANSIENT:g} %. Where they "
            "fill an area the motion has no period, and single points mean nothing: their distribution does.",
        ),
        tables=(_trajectory_table(trajectories), _case_table(cases)),
        charts=(
            _trajectory_chart(trajectories), _path_chart(trajectories), _section_chart(trajectories),
            *(_impact_chart(name, cases, plan) for name, over in (("over_speed", plan.speeds), ("over_clearance", plan.clearances)) if len(over) > 1),
        ),
        verdicts=(*_trajectory_verdicts(trajectories), *_case_verdicts(cases, plan)),
        lacking=(
            "Neither the paper's expressions of K nor its measurement were available: wang_liu_internal is a reconstruction (grade R), and no "
            "measured data are shown unless `--measured FILE` lays them over the figures. The mechanism's data are not the paper's.",
        ),
    )  # fmt: skip


def _model(law: str, *, friction: bool) -> EngineModel:
    return engine_model(SCENE, laws={PIN: law}, without=() if friction else (FRICTION,))


def _at(clearance: float, speed: float) -> dict[str, Value]:
    return {"clearance": f"{clearance!r} mm", "crank_speed": f"{speed!r} rpm"}


def _trajectory(law: str, returns: int, *, friction: bool) -> Trajectory:
    model, turn, values = _model(law, friction=friction), 60 / DRAWN_SPEED, _at(DRAWN_CLEARANCE, DRAWN_SPEED)
    whole = simulate(model, duration=DRAWN_TURNS * turn, accuracy=ACCURACY, parameters=values)
    times = turn * np.arange(returns + 1)
    section = simulate(model, duration=float(times[-1]), tolerance=TOLERANCE, parameters=values, grid=times)
    names = (f"{PIN}.eccentricity_x", f"{PIN}.eccentricity_y", "guide.travel", "guide.speed")
    return Trajectory(law, friction, Curves.of(whole), np.array([section[name] for name in names]).T)


def _cases(plan: Plan, sweeps: Sweeps, progress: Progress) -> Iterator[Case]:
    models = [(law, friction) for law in plan.laws for friction in (True, False)]
    for i, (law, friction) in enumerate(models):
        table = sweeps(
            f"{law}-{'friction' if friction else 'frictionless'}", _model(law, friction=friction),
            over={"crank_speed": [f"{n!r} rpm" for n in plan.speeds], "clearance": [f"{c!r} mm" for c in plan.clearances]},
            outputs=[*OUTPUTS, "energy_residual"], duration=f"{plan.turns} rev", tolerance=TOLERANCE,
            progress=progress_of(progress, i, len(models)),
        )  # fmt: skip
        for row, (speed, clearance) in zip(table.rows, product(plan.speeds, plan.clearances), strict=True):
            numbers = {n: (float(row[n]), float(row[f"{n}.half_width"])) for n in OUTPUTS}
            yield Case(law, friction, clearance, speed, row.outcome, float(row["energy_residual"]), numbers)


# -- tables and charts -------------------------------------------------------------------------------------------------


def _trajectory_table(trajectories: Sequence[Trajectory]) -> Table:
    columns = (
        *(("law", ""), ("friction", ""), ("outcome", ""), ("horizon", "ms"), ("largest error", ""), ("error growth", "1/s")),
        *(("impacts", ""), ("peak force", "kN"), ("position off ideal", "mm"), ("steps", "")),
    )  # fmt: skip
    title = f"Trajectories: {DRAWN_TURNS} revolutions, {DRAWN_SPEED:g} rpm, {DRAWN_CLEARANCE:g} mm; error in parts of the clearance"
    return Table("trajectories", title, columns, tuple(tuple(_trajectory_cells(x)) for x in trajectories))


def _trajectory_cells(x: Trajectory) -> Iterator[Cell]:
    yield from (x.law, "yes" if x.friction else "no", x.run.outcome.name, x.horizon * 1e3)
    yield from (None, None) if x.run.error is None else (x.run.error.worst, x.run.error.growth)
    yield from (len(x.run.impacts), max(impact.peak_force for impact in x.run.impacts) * 1e-3)
    ideal = x.curves.ideal
    yield None if ideal is None else float(np.max(np.abs(x.curves["guide.travel"] - ideal["guide.travel"]))) * 1e3
    yield x.run.statistics.steps


def _case_table(cases: Sequence[Case]) -> Table:
    named = [column for name, unit, _ in OUTPUTS.values() for column in ((name, unit), (f"{name} ±", unit))]
    columns = (("law", ""), ("friction", ""), ("clearance", "mm"), ("speed", "rpm"), ("outcome", ""), *named)
    rows: list[tuple[Cell, ...]] = []
    for case in cases:
        values = [x / factor for n, (_, _, factor) in OUTPUTS.items() for x in case.numbers[n]]
        rows.append((case.law, "yes" if case.friction else "no", case.clearance, case.speed, case.outcome, *values))
    return Table("averages", "Averages beyond the horizon, with 95 % intervals", columns, tuple(rows))


def _label(law: str) -> str:
    return f"{law} (R)" if law.startswith("wang_liu") else law


def _trajectory_chart(trajectories: Sequence[Trajectory]) -> Chart:
    time, shown = Axis("time", "ms", history="t"), [x for x in trajectories if x.friction]
    first, ideal = trajectories[0].curves, trajectories[0].curves.ideal
    path, speed, rate = (None,) * 3 if ideal is None else (
        ideal["guide.travel"], ideal["guide.speed"], ideal.acceleration_of("guide.speed")
    )  # fmt: skip

    def panel(
        title: str,
        name: str,
        axis: Axis,
        factor: float,
        of_ideal: Array | None,
        limits: tuple[float, float] | None = None,
    ) -> Panel:
        reference = (
            () if of_ideal is None else (Curve("ideal mechanism", first.t * 1e3, of_ideal / factor, look="reference"),)
        )
        curves = (Curve(x.label, x.curves.t * 1e3, x.curves[name] / factor) for x in shown)
        return Panel(title, time, axis, (*reference, *curves), y_limits=limits)

    ends = np.array([first.t[-1] * 1e3, 0])  # a name stands at the last: there errors are small
    errors = ((x.label, x.run.error) for x in trajectories if x.run.error is not None)
    return Chart(
        "trajectories",
        f"{DRAWN_TURNS} revolutions at {DRAWN_SPEED:g} rpm, clearance {DRAWN_CLEARANCE:g} mm, with friction",
        (
            panel("Slider position", "guide.travel", Axis("position", "mm", history="guide.travel"), 1e-3, path),
            Panel("Position less that of the ideal mechanism", time, Axis("deviation", "mm"), tuple(
                Curve(x.label, x.curves.t * 1e3, (x.curves["guide.travel"] - x.curves.ideal["guide.travel"]) * 1e3)
                for x in shown if x.curves.ideal is not None
            )),
            panel("Slider velocity", "guide.speed", Axis("velocity", "m/s", history="guide.speed"), 1.0, speed),
            panel("Slider acceleration, cut", "guide.acceleration", Axis("acceleration", "km/s²", history="guide.acceleration"), 1e3,
                  rate, (-60, 60)),
            panel("Contact force", f"{PIN}.normal_force", Axis("force", "kN", history=f"{PIN}.normal_force"), 1e3, None),
            Panel("Error of the trajectory", time, Axis("error/clearance", log=True), (
                *(Curve(label, e.times * 1e3, np.maximum(e.values, 1e-12)) for label, e in errors),
                Curve("1 %: the horizon", ends, np.full(2, 0.01), look="dashed"),
            )),
        ),
        note="(R): a reconstruction, as the paper's own expression was not available.",
    )  # fmt: skip


def _circle() -> Curve:
    angle = np.linspace(0, 2 * math.pi, 181)
    return Curve("clearance circle", np.cos(angle), np.sin(angle), look="reference")


def _path_chart(trajectories: Sequence[Trajectory]) -> Chart:
    x, y = Axis("eccentricity x/clearance"), Axis("eccentricity y/clearance")
    c = DRAWN_CLEARANCE * 1e-3
    panels = tuple(
        Panel(t.label, x, y, (
            _circle(), Curve("pin's centre", t.curves[f"{PIN}.eccentricity_x"] / c, t.curves[f"{PIN}.eccentricity_y"] / c),
        ), equal=True)
        for t in trajectories if t.friction
    )  # fmt: skip
    title = f"Path of the pin's centre in its bush, {DRAWN_TURNS} revolutions with friction"
    return Chart("journal_paths", title, panels, columns=3)


def _section_chart(trajectories: Sequence[Trajectory]) -> Chart:
    x, y = Axis("slider position less the ideal one/clearance"), Axis("slider velocity", "m/s")
    panels = []
    for law in dict.fromkeys(t.law for t in trajectories):
        curves = []
        for t in sorted((t for t in trajectories if t.law == law), key=lambda t: t.friction):  # the wider cloud first
            steady = t.returns[math.ceil(TRANSIENT * len(t.returns)) :]
            off = (steady[:, 2] - (CRANK + ROD)) / (DRAWN_CLEARANCE * 1e-3)
            curves.append(Curve("with friction" if t.friction else "without friction", off, steady[:, 3], look="dots"))
        panels.append(Panel(_label(law), x, y, tuple(curves)))
    return Chart(
        "poincare", f"Poincare sections: states whenever the crank is at angle 0; {DRAWN_SPEED:g} rpm, {DRAWN_CLEARANCE:g} mm", tuple(panels),
        columns=3, note="The ideal slider then rests at its far dead centre: 0, 0. Few points: a period; a cloud: none.",
    )  # fmt: skip


def _impact_chart(name: str, cases: Sequence[Case], plan: Plan) -> Chart:
    """Draw rate and severity of the impacts over speed or over clearance.

    At the widest clearance, or at the highest speed.
    """
    speeds = name == "over_speed"
    fixed = max(plan.clearances) if speeds else max(plan.speeds)
    axis = Axis("crank speed", "rpm", log=True) if speeds else Axis("clearance", "mm", log=True)

    def curves(output: str, friction: bool, *, each_turn: bool = False) -> tuple[Curve, ...]:
        lines = []
        for law in plan.laws:
            chosen = [
                c for c in cases if (c.law, c.friction) == (law, friction) and (c.clearance if speeds else c.speed) == fixed
            ]  # fmt: skip
            x = np.array([c.speed if speeds else c.clearance for c in chosen])
            factor = np.array([60 / c.speed if each_turn else 1e-3 for c in chosen])
            mean, half = np.array([c.numbers[output] for c in chosen]).T * factor
            lines.append(Curve(_label(law), x, mean, np.nan_to_num(half), "both"))
        return tuple(lines)

    where = f"clearance {fixed:g} mm" if speeds else f"{fixed:g} rpm"
    panels = []
    for friction in (True, False):
        said = "with friction" if friction else "without friction"
        panels.append(
            Panel(
                f"Impacts, {said}",
                axis,
                Axis("impacts per revolution", least=0),
                curves(RATE, friction, each_turn=True),
            )
        )
        panels.append(
            Panel(
                f"Severity, {said}",
                axis,
                Axis("peak force of a turn, mean", "kN", log=True),
                curves(SEVERITY, friction),
            )
        )
    return Chart(
        name, f"Rate and severity of the impacts, {where}", tuple(panels),
        note="Bands: 95 % intervals of the means. (R): a reconstruction, as the paper's own expression was not available.",
    )  # fmt: skip


# -- verdicts ----------------------------------------------------------------------------------------------------------


def _trajectory_verdicts(trajectories: Sequence[Trajectory]) -> Iterator[Verdict]:
    curves = trajectories[0].curves
    if curves.ideal is not None:
        w = DRAWN_SPEED * 2 * math.pi / 60
        acceleration = abs(float(curves.ideal.acceleration_of("guide.speed")[0]))
        yield compare(
            "acceleration of the ideal slider at its dead centre [m/s^2]",
            acceleration,
            w**2 * CRANK * (1 + CRANK / ROD),
            1e-9,
            "w^2 r (1 + r/l)",
        )
    shortest = min(trajectories, key=lambda x: x.horizon)
    yield Verdict(
        f"trajectories are valid for {shortest.horizon * 1e3:.3g} ms and more ({shortest.label}) of {shortest.run.engine.t_end * 1e3:.3g} ms",
        "comparison with tighter runs",
    )  # fmt: skip
    peaks = {x.label: max(i.peak_force for i in x.run.impacts) for x in trajectories}
    weak, strong = (f(peaks, key=lambda law: peaks[law]) for f in (min, max))
    yield Verdict(
        f"peak force: {peaks[weak] * 1e-3:.3g} kN ({weak}) to {peaks[strong] * 1e-3:.3g} kN ({strong})",
        "the same trajectories",
    )


def _case_verdicts(cases: Sequence[Case], plan: Plan) -> Iterator[Verdict]:
    failed = [f"{c.law} {c.clearance:g} mm {c.speed:g} rpm: {c.outcome}" for c in cases if c.outcome != "finished"]
    yield Verdict(
        f"{len(cases)} long runs, {f'{len(failed)} do not finish: ' + '; '.join(failed[:5]) if failed else 'all finish'}",
        "outcomes",
        not failed,
    )
    worst = max(cases, key=lambda c: c.residual if math.isfinite(c.residual) else math.inf)
    yield Verdict(
        f"energy put in is that moved and dissipated: every run's ledger closes to {worst.residual:.1e} of the energy moved (limit {CLOSED:.0e})",
        "conservation of energy", worst.residual <= CLOSED,
    )  # fmt: skip
    yield from _apart(cases, "laws", lambda c: (c.friction, c.clearance, c.speed))
    yield from _apart(cases, "with and without friction", lambda c: (c.law, c.clearance, c.speed))
    for law in plan.laws:
        chosen = [c for c in cases if c.law == law and c.friction and c.clearance == max(plan.clearances)]
        values = np.array([(c.speed, c.numbers[SEVERITY][0]) for c in chosen if c.numbers[SEVERITY][0] > 0])
        if len(values) > 1:
            speeds, forces = np.log(values).T
            apart = speeds - np.mean(speeds)
            slope = float(apart @ forces / (apart @ apart))
            yield Verdict(
                f"{law}: the peak force of a revolution grows as speed^{slope:.2g} at {max(plan.clearances):g} mm, with friction",
                "fit to the averages",
            )


def _apart(cases: Sequence[Case], subject: str, group: Callable[[Case], tuple[object, ...]]) -> Iterator[Verdict]:
    """Yield how often severities of a group of cases differ beyond their intervals, and by how much."""
    groups: dict[tuple[object, ...], list[tuple[float, float]]] = {}
    for case in cases:
        mean, half = case.numbers[SEVERITY]
        if math.isfinite(mean) and math.isfinite(half):
            groups.setdefault(group(case), []).append((mean, half))
    pairs = [(min(severities), max(severities)) for severities in groups.values() if len(severities) > 1]
    if not pairs:
        return
    ratios = [high[0] / low[0] for low, high in pairs if high[0] - low[0] > high[1] + low[1]]
    most = f", by up to {max(ratios):.3g} times" if ratios else ""
    yield Verdict(
        f"peak force of a revolution: {subject} differ by more than their intervals in {len(ratios)} of {len(pairs)} comparisons{most}",
        "averages, table",
    )


STUDY = Study(
    "slider_crank",
    "How do the laws compare in a slider-crank with clearance, and how certain is each number?",
    run,
    {"guide.travel": "m", "guide.speed": "m/s", "guide.acceleration": "m/s^2", f"{PIN}.normal_force": "N"},
)
