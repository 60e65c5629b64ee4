"""Limits of Hertz's theory in a run: each contact of a law that is Hertz's is compared with them.

Hertz's is a theory of elastic half-spaces, at rest but for the contact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from hertzwerk.derive.common.grouping import grouped, some
from hertzwerk.derive.common.hertzian_laws import LINE, POINT
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.impacts import Impact

WIDE = 0.3  # contact radius over radius from which on Hertz's force is 1 % too large (Sneddon 1965), in a bush 3.5 % (Persson 1964)
CROSSINGS = 15  # of the body by a wave within an impact: of a sphere that lasts so long, waves take 1 % of the energy (Hunter 1957)
PER_LIMIT = 1e5  # speed sqrt(E/rho) of a wave over the limit of approach speeds
PLANES = ("sphere_on_plane", "cylinder_on_plane")
OUTSIDE = (*PLANES, "sphere_on_sphere", "parallel_cylinders")
INSIDE = ("pin_in_bush", "ball_in_socket")


class Validity(NamedTuple):
    """Check of the contacts of a run against a limit of Hertz's theory.

    check       "yield" by force, "width" and "conformity" by penetration, "waves" by duration
    contacts    pairs that were checked; unchecked: those whose data for it are not known
    exceeded    number of contacts beyond the limit, of so many
    worst       most that a contact is beyond its limit, a ratio; limit [SI]: of that contact
    """

    check: str
    contacts: tuple[str, ...]
    unchecked: tuple[str, ...]
    exceeded: int
    of: int
    worst: float
    limit: float

    def __str__(self) -> str:
        words = WORDS[self.check]
        why = [f"{', '.join(self.unchecked)} not checked: {words.missing}"] if self.unchecked else []
        if not self.contacts:
            return f"{self.check} of {why[0]}"
        count = f"{self.exceeded} of {self.of} contacts of {', '.join(self.contacts)}"
        text = f"{count} {words.limited}, {self.limit:.3g} {words.unit} (worst {self.worst:.3g} times)"
        return "; ".join([f"{text}: {words.remedy}" if self.exceeded else text, *why])


class Words(NamedTuple):
    """Texts of a check: excess, unit of its limit, way out, both in a word, what it may lack.

    excess    how far a contact is beyond its limit, a ratio
    """

    excess: Callable[[Impact, float], float]
    limited: str
    unit: str
    remedy: str
    brief: str
    advice: str
    missing: str = ""


def _deep(impact: Impact, limit: float) -> float:
    return impact.peak_penetration / limit


WORDS = {
    "yield": Words(lambda impact, limit: impact.peak_force / limit, "exceed the force at the onset of yield", "N",
                   "surfaces dent; take an elastic-plastic law (`hertzwerk laws`)", "yield", "take an elastic-plastic law", "no yield strength"),
    "width": Words(_deep, f"exceed the depth at which they are {WIDE} of the radius wide", "m",
                   "fit the law `power` to finite elements or measured impacts", "are wide", "fit `power` to measured impacts"),
    "conformity": Words(_deep, f"exceed the depth at which they enclose {WIDE} rad to each side", "m",
                        "surfaces conform; take `persson`, or `power` fitted to finite elements", "conform", "take `persson`"),
    "waves": Words(lambda impact, limit: limit / (impact.duration or math.inf), f"end before a wave has crossed the body {CROSSINGS} times", "s",
                   "waves keep energy; fit the restitution to measured impacts", "are short for waves", "measure the restitution", "no density"),
}  # fmt: skip


def validity(model: EngineModel, p: np.ndarray | None, impacts: Callable[[], Sequence[Impact]]) -> tuple[Validity, ...]:
    """Return the checks of every contact of a run whose law is Hertz's.

    p    parameters in SI, None of a saved run; impacts: called where there are such pairs
    """
    names = {
        pair: text.split(" x ")[0].partition(",")[0] for pair, kind, text in model.module.EFFECTS if kind == "contact"
    }
    kinds = dict(model.module.PAIRS)
    known_laws = (*POINT, *LINE)
    hertzian = [pair for pair in model.pairs if names.get(pair) in known_laws and kinds[pair] in OUTSIDE + INSIDE]
    if not hertzian or p is None:
        return ()
    compared = [impact for impact in impacts() if impact.contact in hertzian]
    checks = []
    for check, known in _limits(model, p, {pair: names[pair] in LINE for pair in hertzian}).items():
        of = [
            (WORDS[check].excess(impact, known[impact.contact]), known[impact.contact])
            for impact in compared
            if impact.contact in known
        ]
        unchecked = [pair for pair in hertzian if pair not in known] if WORDS[check].missing else []
        if of or unchecked:
            exceeded, (worst, limit) = sum([ratio > 1 for ratio, _ in of]), max(of, default=(math.nan, math.nan))
            checks.append(
                Validity(check, tuple(known) if of else (), tuple(unchecked), exceeded, len(of), worst, limit)
            )
    return tuple(checks)


def _limits(model: EngineModel, p: np.ndarray, lines: Mapping[str, bool]) -> dict[str, dict[str, float]]:
    """Return the known limits of each check by pair: force [N], penetration [m], duration [s]."""
    kinds, radii = dict(model.module.PAIRS), model.radii(p)
    marks = list(zip(model.module.LANDMARKS, model.landmarks(p), strict=True))
    bodies = grouped((row[0], row[3]) for row, _ in marks if row[0] in lines)
    sizes = grouped((row[3], _longest(row[4], at)) for row, at in marks if row[1].startswith("solid_"))
    limits: dict[str, dict[str, float]] = {check: {} for check in WORDS}
    for pair, line in lines.items():
        (first, *second), inside = radii[pair], kinds[pair] in INSIDE
        apart = second[0] - first if inside else first + sum(second)
        curvature = first * second[0] / apart if second else first
        width = WIDE * (first if inside else curvature)
        depth = width**2 / curvature
        if line:  # the approach of the axes, Johnson (1985), section 5.6
            depth *= (math.log(16 * curvature * apart / width**2) - 1) / 4
        limits["conformity" if inside else "width"][pair] = depth
        across = 2 * min(first, *second) if kinds[pair] in OUTSIDE and second else 2 * first
        limits["waves"][pair] = max(across, *(size for body in bodies[pair] for size in sizes.get(body, ())), 0.0)
    if model.has_function("yield_forces"):
        forces = dict(zip(model.pairs, model.evaluate("yield_forces", p)[0].tolist(), strict=True))
        limits["yield"] = {pair: forces[pair] for pair in lines if forces[pair] > 0}
    stated = model.evaluate("speed_limits", p)[0].tolist() if model.speed_limited else []
    speeds = {pair: PER_LIMIT * limit for pair, limit in zip(model.speed_limited, stated, strict=True)}
    limits["waves"] = {pair: CROSSINGS * limits["waves"][pair] / speeds[pair] for pair in lines if pair in speeds}
    return limits


def _longest(names: Sequence[str], mark: np.ndarray) -> float:
    """Return the largest size [m] of a solid, from the names and numbers of its landmark."""
    first, own = (6, names[1:]) if names[0] == "axis" else (3, names)
    across = 2 * mark[first + own.index("radius")] if "radius" in own else 0.0
    return float(max(across, mark[first:].max()))


def beyond_theory(checks: Sequence[Validity]) -> Iterator[str]:
    """Yield one warning of all checks that contacts exceed."""
    exceeded = [check for check in checks if check.exceeded]
    if exceeded:
        pairs = list(dict.fromkeys(pair for check in exceeded for pair in check.contacts))
        worst = WORDS[max(exceeded, key=lambda check: check.worst).check]
        counts = "; ".join(
            f"{check.exceeded} of {check.of} {WORDS[check.check].brief} (worst {check.worst:.2g} times): {WORDS[check.check].advice}"
            for check in exceeded
        )
        yield f"{some(pairs)}: contacts exceed Hertz's theory; {worst.advice}. Of contacts of {', '.join(pairs)} {counts}"
