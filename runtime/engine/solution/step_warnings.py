"""Warnings found in the steps of a run, once they are read."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import attrgetter

import numpy as np

from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.contact_watch import Lasting
from hertzwerk.runtime.engine.solution.history import History, constraint_force

SMALL = 0.01  # share of a dissipation below which a number says no more
START = 1e-9  # share of a run within which a contact began at its start


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
            share = f" ({f'{part:.0%}' if part >= SMALL else f'less than {SMALL:.0%}'} of its dissipation)"
    of = f" of {', '.join(pairs)}"
    since = worst.since if worst.since > START * ends.t[-1] else 0.0
    which = f"{len(lasting)} contacts{of}, the worst" if len(lasting) > 1 else f"a contact{of},"
    yield (
        f"{which} since t = {since:.4g} s, exceeded the range of its damping law{share}: gap rates up to "
        f"{worst.ratio:.2g} times the approach speed v0; take a law without v0 (`hertzwerk laws`), or raise approach_floor, the lowest v0"
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
                yield f"{name}: its joints keep the surfaces in contact, so there is no normal force to compare friction with"
            continue
        worst = int(np.argmin(normal))
        if normal[worst] < 0:
            yield f"{name} holds its surfaces together with {-normal[worst]:.3g} N at {history.t[worst]:.4g} s: they would separate"
        needed = np.linalg.norm(along, axis=0) / np.where(normal > 0, normal, np.inf) if along else np.zeros(1)
        worst = int(np.argmax(needed))
        if needed[worst] > limit:
            yield (f"{name} needs a coefficient of friction of {needed[worst]:.3g} at {history.t[worst]:.4g} s, "
                   f"more than {limit:.3g}: it would slip")  # fmt: skip
