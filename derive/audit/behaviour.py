"""What every contact law owes beyond its units, tried with numbers: no energy from nothing, no pull, nothing undefined.

An elastic force is zero at zero and rises with the penetration, and the stored energy is its integral; a damping force and friction take energy
and give none; friction is odd; every derivative is finite. A law is tried over the ranges it states (`law_faults`), and in a scene at the scene's
numbers, up to the law's reach or else the pair's smaller radius (`scene_faults`). A law that fails names the point where.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from mpmath import mp, mpf

from hertzwerk.derive.audit.audit import audit_law, verdict
from hertzwerk.derive.audit.owed import Trial, Values, completed, faults_of
from hertzwerk.derive.audit.rescaling import lattice
from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import BoundLaw, DampingLaw, Law, R_min, StiffnessLaw
from hertzwerk.derive.mechanism.parameter import default_value
from hertzwerk.derive.units import parse_unit

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene import Scene

DIGITS = 30
SETS = 3  # of parameters over the ranges of a law, of the eleven that the rescaling audit takes
DEEPEST = mpf("1e-3")  # m, where neither law nor pair says how deep
PARTNER = mpf("1e9")  # N/m^1.5, of the elastic force that a damping law is tried beside by itself


@lru_cache(maxsize=256)
def law_faults(law: Law) -> tuple[Fault, ...]:
    """Of a law by itself, over the ranges it states: those at the first of its parameters that has any."""
    with mp.workdps(DIGITS):
        for trial in _over_range(law):
            faults = tuple(faults_of(trial))
            if faults:
                return faults
    return ()


def faults_if_consistent(law: Law) -> tuple[Fault, ...]:
    """The same, where the law's units hold or are those of a fit: of others numbers say nothing, and their audit has the cause."""
    return () if verdict(audit_law(law)) == "inconsistent" else law_faults(law)


def scene_faults(scene: Scene) -> Iterator[Fault]:
    """Of the laws of a scene at its numbers, and of laws of one's own over their ranges. What runs unchecked is not tried."""
    for effect in scene.effects:
        if getattr(effect, "unchecked", False):
            continue
        bounds: tuple[BoundLaw, ...] = getattr(effect, "laws", ())
        for bound in bounds:
            if LAWS.get(bound.law.name) is not bound.law:  # those of the catalogue are tried by the tests
                yield from law_faults(bound.law)
        geometry = scene.geometry(effect.pair) if bounds and hasattr(effect, "pair") else {}
        elastic: Trial | None = None
        with mp.workdps(DIGITS):
            for bound in bounds:
                trial = _in_scene(bound, geometry, elastic)
                if trial is not None:
                    yield from faults_of(trial)
                    elastic = trial if isinstance(bound.law, StiffnessLaw) else elastic


def refuse_misbehaving(scene: Scene) -> None:
    """Raise InputError if a law of the scene does not do what every law owes."""
    faults = tuple(dict.fromkeys(scene_faults(scene)))
    if faults:
        raise InputError(f"scene {scene.name}", faults)


# -- numbers for a law -------------------------------------------------------------------------------------------------


def _over_range(law: Law) -> Iterator[Trial]:
    names = {symbol.name: symbol for symbol in law.parameters if symbol.unit == "1"}
    dimensions = {symbol: Dimension.from_unit(parse_unit(symbol.unit), names) for symbol in law.symbols()}
    defaults = {q: mpf(repr(p.si)) for q, p in law.defaults if not law.fitted_in and not _bounded(q)}
    states = tuple(lattice(law, dimensions))
    for state in states[:: len(states) // SETS]:
        values = completed(law, state | defaults)
        beside = None
        if isinstance(law, DampingLaw):
            hertz = LAWS["power"]
            K, n = hertz.parameters
            beside = Trial(hertz, {K: PARTNER, n: mpf("1.5")}, DEEPEST)
        yield Trial(law, values, state[R_min], beside)


def _bounded(q: Any) -> bool:
    return q.limit is not None and None not in (q.limit.lower, q.limit.upper)


def _in_scene(bound: BoundLaw, geometry: dict[str, Any], beside: Trial | None) -> Trial | None:
    """At the defaults of the scene's parameters; None where one has no number there, which is told elsewhere."""
    law = bound.law
    given = {**dict(bound.binding), **{q: geometry.get(q.name) for q in (*law.geometry(), R_min)}}
    values: Values = {q: mpf(repr(default_value(x))) for q, x in given.items() if x is not None}
    if not all(mp.isfinite(x) for x in values.values()) or any(q not in values for q in law.geometry()):
        return None
    return Trial(law, completed(law, values), values.get(R_min, DEEPEST), beside)
