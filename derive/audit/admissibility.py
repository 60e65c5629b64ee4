"""Physical admissibility of contact laws: over their stated ranges, and in a scene at its values.

A law is tested up to its reach, or else the pair's smaller radius. A fault names the point where the law fails.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from mpmath import mp, mpf

from hertzwerk.derive.audit.audit import audit_law, verdict
from hertzwerk.derive.audit.behaviour import DIGITS, Trial, Values, faults_of, with_definitions
from hertzwerk.derive.audit.numeric import lattice
from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import default_value
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import (
    BoundLaw,
    DampingLaw,
    Law,
    R_min,
    StiffnessLaw,
)

SETS = 3  # parameter sets over the ranges of a law, out of the eleven of the lattice
DEFAULT_DEPTH = mpf("1e-3")  # m, where neither law nor pair limits the penetration
ADDED_STIFFNESS = mpf("1e9")  # N/m^1.5, of the elastic force added to a damping law that is tested without a scene


@lru_cache(maxsize=256)
def law_faults(law: Law) -> tuple[Fault, ...]:
    """Faults of a law over its stated ranges, at the first of its parameter sets that has any."""
    with mp.workdps(DIGITS):
        for trial in _over_range(law):
            if faults := faults_of(trial):
                return faults
    return ()


def faults_if_consistent(law: Law) -> tuple[Fault, ...]:
    """Faults of a law that is not inconsistent in its units; () for others.

    Numerical tests of an inconsistent law mean nothing, and its unit audit has the cause.
    """
    return () if verdict(audit_law(law)) == "inconsistent" else law_faults(law)


def scene_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of the scene's laws at its values, and of user-defined laws over their ranges.

    Laws that run unchecked are skipped.
    """
    for effect in scene.effects:
        if effect.unchecked:
            continue
        for bound in effect.laws:
            if LAWS.get(bound.law.name) is not bound.law:  # laws of the catalogue are covered by the test suite
                yield from law_faults(bound.law)
        geometry = next((scene.geometry(pair) for pair in effect.pairs), {})
        elastic: Trial | None = None
        with mp.workdps(DIGITS):
            for bound in effect.laws:
                trial = _in_scene(bound, geometry, elastic)
                if trial is not None:
                    yield from faults_of(trial)
                    elastic = trial if isinstance(bound.law, StiffnessLaw) else elastic


def refuse_misbehaving(scene: Scene) -> None:
    """Raise InputError if a law of the scene is not physically admissible."""
    refuse(f"scene {scene.name}", tuple(dict.fromkeys(scene_faults(scene))))


def _over_range(law: Law) -> Iterator[Trial]:
    names = {symbol.name: symbol for symbol in law.parameters if symbol.unit == "1"}
    dimensions = {symbol: Dimension.from_unit(parse_unit(symbol.unit), names) for symbol in law.symbols()}
    defaults = {q: mpf(repr(p.si)) for q, p in law.defaults if not law.fitted_in and not _bounded(q)}
    states = tuple(lattice(law, dimensions))
    for state in states[:: len(states) // SETS]:
        values = with_definitions(law, state | defaults)
        elastic = None
        if isinstance(law, DampingLaw):
            hertz = LAWS["power"]
            K, n = hertz.parameters
            elastic = Trial(hertz, {K: ADDED_STIFFNESS, n: mpf("1.5")}, DEFAULT_DEPTH)
        yield Trial(law, values, state[R_min], elastic)


def _bounded(q: Any) -> bool:
    return q.limit is not None and None not in (q.limit.lower, q.limit.upper)


def _in_scene(bound: BoundLaw, geometry: dict[str, Any], elastic: Trial | None) -> Trial | None:
    """Trial at the defaults of the scene's parameters; None where one has no finite value.

    Missing values are reported elsewhere.
    """
    law = bound.law
    bindings = {**dict(bound.binding), **{q: geometry.get(q.name) for q in (*law.geometry, R_min)}}
    values: Values = {q: mpf(repr(default_value(x))) for q, x in bindings.items() if x is not None}
    if not all(mp.isfinite(x) for x in values.values()) or any(q not in values for q in law.geometry):
        return None
    return Trial(law, with_definitions(law, values), values.get(R_min, DEFAULT_DEPTH), elastic)
