"""Warnings found in the steps of a run: limits of laws, grips, rods and wear."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import attrgetter

import numpy as np

from hertzwerk.derive.common.grouping import some
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.contact_watch import Lasting
from hertzwerk.runtime.engine.solution.history import History, constraint_force

STRAIGHT = 0.02  # deflection of a rod over its length: from there on its truncated mass matrix may lose definiteness
SECTORS = 5  # of a wear, times the half-width of the contact over the radius: their shares spread it about as Hertz's pressure does
ROUNDS = 12  # iterations of that half-width, each of which leaves a third of its error
SMALL = 0.01  # share of a dissipation below which a number says no more
START = 1e-9  # share of a run within which a contact began at its start


def headline(finding: str) -> str:
    """Return the first sentence of a warning or an advice: it states the way out, others the details."""
    return finding.partition(". ")[0]


def left_law(model: EngineModel, lasting: Sequence[Lasting], ends: History) -> Iterator[str]:
    """Yield one warning of contacts that left their damping law, with their share of what it dissipates."""
    if not lasting:
        return
    worst, pairs = max(lasting, key=attrgetter("ratio")), list(dict.fromkeys([each.pair for each in lasting]))
    share = ""
    if model.has_ledger:
        booked = [model.nq + model.nu + model.module.DISSIPATED[model.pairs.index(pair)] for pair in pairs]
        spent = float((ends.part("y")[-1, booked] - ends.part("y")[0, booked]).sum())
        part = sum([each.dissipated for each in lasting]) / spent if spent > 0 else 0.0
        if spent > 0:
            share = f", {f'{part:.0%}' if part >= SMALL else f'less than {SMALL:.0%}'} of its dissipation"
    since = worst.since if worst.since > START * ends.t[-1] else 0.0
    count = f"{len(lasting)} contacts" if len(lasting) > 1 else "one contact"
    yield (
        f"{some(pairs)}: gap rates exceed the damping law; take one without v0. At {', '.join(pairs)} they are up to {worst.ratio:.2g} times "
        f"the approach speed v0 since t = {since:.4g} s ({count}{share}); `hertzwerk laws` shows which laws refer to v0, and a larger "
        "approach_floor raises the least v0"
    )


def bent_rods(model: EngineModel, history: History) -> Iterator[str]:
    """Yield a warning of each rod that bends further than its equations hold, at the kept times."""
    marks = [row for row in model.module.LANDMARKS if row[1] == "flexible_rod"]
    if history.p is None or not (marks and len(history.t)):
        return
    ends = [
        {row[0]: model.module.BODIES.index(row[3]) for row in marks if row[2] == end} for end in ("parent", "child")
    ]
    t, y = history.t[0], history.part("y")[0]
    (c,) = model.evaluate("constants", history.p)
    places = model.evaluate("poses", t, y[: model.nq], c)[0].reshape(-1, 3)
    for rod, first in ends[0].items():
        length = float(np.linalg.norm(places[ends[1][rod]] - places[first]))
        outputs = [name for name in model.outputs if name.startswith((f"{rod}.deflection_", f"{rod}.sag_"))]
        most = max((float(np.max(np.abs(history[name]))) for name in outputs), default=0.0) / length
        if most > STRAIGHT:
            yield (
                f"rod {rod} bends by {most:.2g} of its length: take two rods in a row, which share it. Its equations, of second order in that, "
                f"hold up to about {STRAIGHT}"
            )


def wide_sectors(model: EngineModel, history: History) -> Iterator[str]:
    """Yield a warning of each wear whose sectors are wider than its arc of contact, at the kept times.

    That is a mean by the force integrated over the sliding distance; its half-width follows from the penetration as in `validity`.
    """
    if history.p is None:
        return
    for pair, wear in model.effects_at_pairs("wear").items():
        states = (f"{wear}.pin_", f"{wear}.bush_")
        count = max([int(name.rpartition("_")[2]) for name in model.coordinates if name.startswith(states)], default=0)
        touching = history[f"{pair}.penetration"][1:] > 0 if count else np.zeros(0, bool)
        if not touching.any():
            continue
        inner, outer = model.radii(history.p)[pair]
        depth, weights = history[f"{pair}.penetration"][1:][touching], np.diff(history[f"{wear}.load_path"])[touching]
        product = inner * outer  # relative curvature times the difference of the radii
        square = np.full(len(depth), inner**2)
        for _ in range(ROUNDS):
            square = np.minimum(4 * depth * product / (outer - inner) / (np.log(16 * product / square) - 1), inner**2)
        arc = float(np.sqrt(square) @ weights / weights.sum()) / outer if weights.any() else math.pi
        if arc < math.pi / count:
            yield (
                f"wear {wear} is spread further than its contact: take sectors={2 ** round(math.log2(SECTORS / arc))}. The arc of contact is "
                f"{2 * arc:.2g} rad on average, and each of {count} sectors {2 * math.pi / count:.2g} rad wide"
            )


def lost_grip(model: EngineModel, history: History) -> Iterator[str]:
    """Yield a warning of surfaces that roll where they would slip or part, at the kept times."""
    if history.p is None or not (model.rolling and len(history.t)):  # saved runs keep the warnings they had
        return
    held = dict(zip(map(constraint_force, model.constraints), history.held().T, strict=True))
    limits = iter(model.evaluate("rolling_limits", history.p)[0])
    for name, limited in model.rolling:
        limit = next(limits) if limited else math.inf
        normal = held.get(f"{name}.normal_force")
        along = [force for of, force in held.items() if of.startswith(f"{name}.friction_force")]
        if normal is None:
            if limited:
                yield f"{name}: friction is not compared with a normal force. Its joints keep the surfaces in contact, so there is none"
            continue
        worst = int(np.argmin(normal))
        if normal[worst] < 0:
            yield f"{name} holds its surfaces together with {-normal[worst]:.3g} N at {history.t[worst]:.4g} s: they would separate"
        needed = np.linalg.norm(along, axis=0) / np.where(normal > 0, normal, np.inf) if along else np.zeros(1)
        worst = int(np.argmax(needed))
        if needed[worst] > limit:
            yield (f"{name} needs a coefficient of friction of {needed[worst]:.3g} at {history.t[worst]:.4g} s, "
                   f"more than {limit:.3g}: it would slip")  # fmt: skip
