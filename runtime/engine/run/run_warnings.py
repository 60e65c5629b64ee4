"""Warnings about a run that do not stop it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from operator import attrgetter

import numpy as np

from hertzwerk.runtime.engine.integration.loop.automatic_compilation import Code
from hertzwerk.runtime.engine.integration.step.layout import RELEASED
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.solution.contact_watch import Lasting
from hertzwerk.runtime.engine.solution.history import History, constraint_force

SMALL = 0.01  # share of a dissipation below which a number says no more
START = 1e-9  # share of a run within which a contact began at its start


def unchecked(model: EngineModel) -> tuple[str, ...]:
    """Return what a model runs on purpose: inconsistent effects, velocities against its positions."""
    return (
        *(
            f"{effect} is dimensionally inconsistent and runs unchecked: {why}"
            for effect, why in model.module.UNCHECKED
        ),
        *(
            f"{where} is taken as given, against the model's positions: {was_set}; it would be {follows}"
            for where, was_set, follows in model.module.CONTRADICTIONS
        ),
    )


def open_forces(model: EngineModel, bound: BoundParameters, q: np.ndarray) -> Iterator[str]:
    """Yield a warning of redundant constraints at a start, whose forces the motion leaves undetermined."""
    if not model.nl:
        return
    from hertzwerk.runtime.engine.start.assembly import undetermined  # a tree needs none

    names = [constraint_force(name) for name in undetermined(model, bound, q)]
    if names:
        yield f"redundant constraints leave these forces undetermined; those of least norm are reported: {', '.join(names)}"


def too_fast(model: EngineModel, limits: np.ndarray, tally: Mapping[str, np.ndarray]) -> Iterator[str]:
    """Yield one warning of contacts faster than the limits [m/s] of their laws (materials with a density)."""
    if not tally["over"].any():
        return
    parts = (part.tolist() for part in (limits, *(tally[name] for name in ("over", "begun", "fastest"))))
    limited = [each for each in zip(model.pairs, *parts, strict=True) if each[1] < math.inf]
    pairs, least, over = zip(*(each[:3] for each in limited if each[2]), strict=True)
    *_, begun, fastest = zip(*limited, strict=True)
    yield (
        f"{sum(over):.0f} of {sum(begun):.0f} impacts of {', '.join(pairs)} exceed the law's limit "
        f"v0 <= 1e-5*sqrt(E/rho) = {min(least):.3g} m/s (worst {max(fastest):.3g} m/s): surfaces may yield; fit the law to measured impacts"
    )


def lost_grip(model: EngineModel, bound: BoundParameters, history: History) -> Iterator[str]:
    """Yield a warning of surfaces that roll where they would slip or part, at the kept times."""
    if not (model.rolling and len(history.t)):
        return
    held = dict(zip(map(constraint_force, model.constraints), history.held().T, strict=True))
    limits = iter(model.evaluate("rolling_limits", bound.p)[0])
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


def released(model: EngineModel, first: History) -> Iterator[str]:
    """Yield a warning of surfaces that overlap at the start while they open, where their law would pull."""
    for pair in (pair for pair, mode in zip(model.pairs, first.part("mode")[0], strict=True) if mode == RELEASED):
        yield (
            f"{pair} starts {first[f'{pair}.penetration'][0]:.3g} m deep and opening, where its law would pull: no force acts until it closes "
            "again; start with a gap or at rest"
        )


def floored(count: int, floor: float) -> Iterator[str]:
    """Yield a warning of contacts slower than the least latched approach speed [m/s]."""
    if not count:
        return
    contacts = "one contact began" if count == 1 else f"{count} contacts began"
    yield f"{contacts} slower than approach_floor = {floor:g} m/s, which the damping law used as the approach speed"


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


def unsettled(count: int) -> Iterator[str]:
    """Yield a warning of instants at which sticking and slipping contacts were not determined."""
    if count:
        instants = "an instant" if count == 1 else f"{count} instants"
        yield f"at {instants} the search for sticking and slipping contacts did not converge: the run continued with its last state, perhaps wrongly"


def uncompiled(code: Code | None) -> Iterator[str]:
    """Yield a warning where C would have saved time but the compiler failed."""
    if code is not None and code.compiler_failure:
        yield f"not compiled; the run is slower, its results are the same: {code.compiler_failure}"
