"""Study `bouncing`: spheres and cylinders dropped on each other, with every damping factor."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.runtime.output.plots.curves import impact_curves
from hertzwerk.runtime.simulation import simulate
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

LAWS = (
    *(
        "exact",
        "hunt_crossley",
        "herbert_mcwhannell",
        "lee_wang",
        "lankarani_nikravesh",
        "gonthier",
        "zhiying_qishao",
        "flores",
    ),
    *("gharib_hurmuzlu", "hu_guo", "carvalho_martins", "safaeifar_farshidianfar", "kelvin_voigt", "tsuji", "jankowski"),
)
"""The twelve hysteresis factors, then the laws of another form."""
QUICK = ("exact", "hunt_crossley", "lankarani_nikravesh", "flores", "kelvin_voigt", "tsuji")
RESTITUTIONS, FEW = (0.95, 0.9, 0.7, 0.5, 0.3, 0.1), (0.9, 0.5)
DRAWN = 0.9
MASS, RADIUS, LENGTH, HEIGHT, GRAVITY = 1.0, 0.05, 0.05, 0.1, 9.81  # kg, m, m, m, m/s^2
E_EFF = 207e9 / (2 * (1 - 0.3**2))
LASTING = 0.75  # s: three bounces and more
TOLERANCE, CLOSED, NEAR = 1e-10, 1e-3, 0.02


@dataclass(frozen=True)
class Form:
    """Elastic impact of K d^n in closed form, without the weight: Hertz's for spheres."""

    name: str
    stiffness: float
    exponent: float
    share: float  # duration over depth/speed, 2 sqrt(pi) Gamma(1 + 1/(n + 1))/Gamma(1/2 + 1/(n + 1))
    source: str

    @property
    def speed(self) -> float:
        """Speed at the end of the fall [m/s]."""
        return math.sqrt(2 * GRAVITY * HEIGHT)

    @property
    def depth(self) -> float:
        """Largest penetration [m]."""
        n = self.exponent
        return float(((n + 1) * MASS * self.speed**2 / (2 * self.stiffness)) ** (1 / (n + 1)))

    @property
    def force(self) -> float:
        """Largest force [N]."""
        return float(self.stiffness * self.depth**self.exponent)

    @property
    def duration(self) -> float:
        """Duration of the contact [s]."""
        return self.share * self.depth / self.speed


FORMS = (
    Form("spheres", 4 / 3 * E_EFF * math.sqrt(RADIUS / 2), 1.5, 2.9432751843, "Hertz: 2.943 dmax/v0"),
    Form("cylinders", math.pi / 4 * E_EFF * LENGTH, 1.0, math.pi, "linear contact: pi sqrt(m/K)"),
)


@dataclass(frozen=True)
class Bounce:
    """First impact of a drop: restitution requested, returned, and in closed form; the run's curves.

    peak_force [N], depth [m], duration [s] of the contact; `lost`: energy dissipated over the energy before.
    """

    form: Form
    law: str
    e_in: float
    out: float
    closed: float | None
    peak_force: float
    depth: float
    duration: float
    lost: float
    bounces: int
    steps: int
    t: Array
    height: Array
    loop: tuple[Any, Any, Any]

    @property
    def weight(self) -> float:
        """Share of the weight in the momentum of the impact."""
        return GRAVITY * self.duration / self.form.speed


def run(quick: bool, progress: Progress, _: Sweeps) -> Page:
    """Drop both forms with every law and restitution."""
    by_law = [
        ("lankarani_nikravesh", (1.0,)),
        *((law, FEW if quick else RESTITUTIONS) for law in (QUICK if quick else LAWS)),
    ]
    cases = [(form, law, restitutions) for form in FORMS for law, restitutions in by_law]
    done, missing = until_stopped(cases, lambda case: list(_bounces(*case)), progress)
    elastic = [bounce for of_case in done for bounce in of_case if bounce.e_in == 1]
    bounces = [bounce for of_case in done for bounce in of_case if bounce.e_in < 1]
    if not bounces:
        raise KeyboardInterrupt
    shown = [form for form in FORMS if any(bounce.form is form for bounce in bounces)]
    return Page(
        title="Spheres and cylinders dropped on each other, with every damping law",
        paragraphs=(
            f"A steel body of {MASS:g} kg and {RADIUS * 1e3:g} mm radius falls {HEIGHT:g} m on an equal one that is fixed: spheres with Hertz's "
            f"stiffness, n = 3/2; cylinders {LENGTH * 1e3:g} mm long with K = (pi/4) E* L, n = 1, which stands for the external model of "
            "Wang and Liu (2020).",
            "The laws are the twelve factors h(e) of F (1 + h v/v0), and three of another form that take a restitution too (a quick run has six); "
            "laws with a parameter of their own are in `hertzwerk study restitution`.",
            "The closed form of the restitution knows no weight: its share in the momentum is the limit of the comparison. Energy lost is "
            "that of the ledger over the kinetic energy at the onset.",
        ),
        tables=(_table(bounces),),
        charts=tuple(_chart(form, [b for b in bounces if b.form is form]) for form in shown),
        verdicts=(*_elastic_verdicts(elastic), *_verdicts(bounces)),
        missing=missing,
        lacking=(
            "The paper's expression of K for external contact is not accessible here: wang_liu_external is a reconstruction (grade R), one of "
            "several candidates (`hertzwerk laws wang_liu_external`).",
        ),
    )


def _bounces(form: Form, law: str, restitutions: Sequence[float]) -> Iterator[Bounce]:
    from hertzwerk.runtime.engine.model.build import build_dropped, restitution_out
    from hertzwerk.runtime.engine.model.model import EngineModel

    model = EngineModel(build_dropped(form.name, law))
    for e in restitutions:
        run = whole(simulate(model, duration=LASTING, tolerance=TOLERANCE, parameters={"restitution": e}))
        first = run.impacts[0]
        duration = first.duration or math.nan
        ends = run.at([first.t, first.t + duration])
        speed, lost = ends["height.speed"], ends["contact.dissipated"]
        t = np.unique(np.concatenate([np.linspace(0, run.engine.t_end, 600), [i.t for i in run.impacts]]))
        yield Bounce(
            form, law, e, float(-speed[1] / speed[0]), restitution_out(law, e, form.exponent), first.peak_force,
            first.peak_penetration, duration, float(lost[1] / (MASS * speed[0] ** 2 / 2)), len(run.impacts),
            run.statistics.steps, t, run.at(t)["height.travel"], impact_curves(run, first),
        )  # fmt: skip


def _table(bounces: Sequence[Bounce]) -> Table:
    columns = (
        *(
            ("form", ""),
            ("law", ""),
            ("e in", ""),
            ("e out", ""),
            ("closed form", ""),
            ("limit of their difference", ""),
            ("rebound", "mm"),
        ),
        *(
            ("peak force", "kN"),
            ("force/elastic", ""),
            ("penetration", "µm"),
            ("duration", "µs"),
            ("duration/elastic", ""),
        ),
        *(("energy lost", ""), ("impacts", ""), ("steps", "")),
    )
    rows: list[tuple[Cell, ...]] = [
        (
            b.form.name, b.law, b.e_in, b.out, b.closed, b.weight, b.out**2 * HEIGHT * 1e3, b.peak_force * 1e-3,
            b.peak_force / b.form.force, b.depth * 1e6, b.duration * 1e6, b.duration / b.form.duration, b.lost, b.bounces, b.steps,
        )
        for b in bounces
    ]  # fmt: skip
    return Table("bounces", "The first impact of every drop", columns, tuple(rows))


def _chart(form: Form, bounces: Sequence[Bounce]) -> Chart:
    shown = [b for b in bounces if b.e_in == DRAWN]
    axis = Axis("requested restitution, e")
    by_law = {law: [b for b in bounces if b.law == law] for law in dict.fromkeys(b.law for b in bounces)}

    def over_e(of: Any) -> tuple[Curve, ...]:
        return tuple(
            Curve(law, np.array([b.e_in for b in of_law]), np.array([of(b) for b in of_law]), look="both")
            for law, of_law in by_law.items()
        )

    model = "Hertz, n = 3/2" if form.name == "spheres" else "wang_liu_external, n = 1: a reconstruction (grade R)"
    return Chart(
        form.name,
        f"Dropped {form.name} ({model})",
        (
            Panel(f"Height of the drop, e = {DRAWN:g}", Axis("time", "s"), Axis("height", "mm"),
                  tuple(Curve(b.law, b.t, b.height * 1e3) for b in shown)),
            Panel(f"Hysteresis loop of the first impact, e = {DRAWN:g}", Axis("penetration", "µm"), Axis("force", "kN"),
                  tuple(Curve(b.law, b.loop[2] * 1e6, b.loop[1] * 1e-3) for b in shown)),
            Panel("Restitution out minus restitution in", axis, Axis("e out - e in"), over_e(lambda b: b.out - b.e_in), y_limits=(-0.4, 0.65)),
            Panel("Energy lost in the first impact", axis, Axis("share of the energy"), (
                Curve("1 - e²", np.linspace(0.05, 1, 50), 1 - np.linspace(0.05, 1, 50) ** 2, look="reference"), *over_e(lambda b: b.lost))),
            Panel("Duration over that of the elastic impact", axis, Axis("duration/elastic"), over_e(lambda b: b.duration / form.duration)),
            Panel("Peak force over that of the elastic impact", axis, Axis("peak force/elastic", log=True),
                  over_e(lambda b: b.peak_force / form.force)),
        ),
    )  # fmt: skip


# -- verdicts ----------------------------------------------------------------------------------------------------------


def _elastic_verdicts(elastic: Sequence[Bounce]) -> Iterator[Verdict]:
    """Yield verdicts on the elastic impacts, against the closed forms without the weight."""
    for b in elastic:
        subject, form = f"{b.form.name}, e = 1", b.form
        yield compare(f"{subject}: duration [µs]", b.duration * 1e6, form.duration * 1e6, CLOSED, form.source)
        yield compare(
            f"{subject}: peak force [kN]",
            b.peak_force * 1e-3,
            form.force * 1e-3,
            CLOSED,
            "K dmax^(n+1)/(n+1) = m v0^2/2",
        )


def _verdicts(bounces: Sequence[Bounce]) -> Iterator[Verdict]:
    shown = [form for form in FORMS if any(b.form is form for b in bounces)]
    known = [b for b in bounces if b.closed is not None]
    worst = max(known, key=lambda b: abs(b.out - (b.closed or 0.0)) / b.weight)
    off = abs(worst.out - (worst.closed or 0.0))
    yield Verdict(
        f"restitution of {len(known)} impacts is that of the closed form; the worst, {worst.law} of {worst.form.name} at e = {worst.e_in:g}, "
        f"is off by {off:.1e} (limit {2 * worst.weight:.1e}: twice the share of the weight)",
        "h (1 + e) = ln((1 + h)/(1 - h e)); exp(-pi zeta/sqrt(1 - zeta^2))",
        off <= 2 * worst.weight,
    )
    open_by = max(abs(b.lost - (1 - b.out**2)) for b in bounces)
    yield Verdict(
        f"energy lost is 1 - e_out^2 of that before, in every impact to {open_by:.1e}", "kinetic energy before and after, at one height",
        open_by <= 1e-6,
    )  # fmt: skip
    for form in shown:
        for e in sorted({b.e_in for b in bounces} & {0.9, 0.5, 0.1}, reverse=True):
            good = [b.law for b in bounces if b.form is form and b.e_in == e and abs(b.out - e) <= NEAR]
            yield Verdict(
                f"{form.name}, e = {e:g}: within {NEAR:g} of the requested restitution are {', '.join(good) or 'none'}",
                "simulated, table",
            )
    for form in shown:
        least = min((b for b in bounces if b.form is form), key=lambda b: b.out)
        most = max((b for b in bounces if b.form is form), key=lambda b: b.peak_force / form.force)
        yield Verdict(
            f"{form.name}: the lowest restitution returned is {least.out:.3g} ({least.law}, e = {least.e_in:g}); the highest peak force is "
            f"{most.peak_force / form.force:.3g} times the elastic one ({most.law}, e = {most.e_in:g})",
            "simulated, table",
        )


STUDY = Study("bouncing", "Which restitution do the damping laws return when spheres or cylinders bounce?", run)
