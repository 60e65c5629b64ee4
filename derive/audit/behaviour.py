"""Behaviour of a contact law at numbers: passivity, sign, smoothness, by its kind.

An elastic force is zero at zero and rises with the penetration, and the stored energy is its integral; a damping
force and friction dissipate energy; friction is odd; every derivative is finite. A fault names the point where the
law fails.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.laws.law import (
    STATE,
    DampingLaw,
    F,
    FilmLaw,
    FrictionLaw,
    Law,
    N,
    StiffnessLaw,
    d,
    eps_c,
    eps_w,
    h,
    k_t,
    s,
    v,
    v0,
)

DIGITS = 30


AGREEMENT = mpf("1e-9")  # relative tolerance of an expression against a finite difference
DIFFERENCE = mpf("1e-12")  # relative step, far below the distance of the last point from a turning point
LEFT_AT_ONSET = mpf("1e-6")  # greatest force in the limit of no penetration, relative to that at the end of the range
ONSET = mpf("1e-60")  # that limit, relative to the range
# penetrations relative to the range
FRACTIONS = tuple(map(mpf, ("1e-9", "1e-6", "1e-4", "1e-2", *(f"{k / 8}" for k in range(1, 8)), ".999999")))
SPEEDS = tuple(mpf(10) ** p for p in (-12, -6, -4, -3, -2, -1, 0, 1))  # m/s
SLOWEST = mpf("1e-15")  # m/s, finite difference for the slope at rest
CURVATURE = mpf("1e-6")  # relative tolerance there, for the curvature of friction
LOADS = (mpf(1), mpf(10_000))  # N

Values = dict[Any, Any]


@dataclass(frozen=True)
class Trial:
    """A law with values by symbol, in the units it is stated in, tested up to `max_penetration`.

    `stiffness` is the stiffness law, with its values, to which a damping law is added.
    """

    law: Any
    values: Values
    max_penetration: Any
    stiffness: Trial | None = None

    def __hash__(self) -> int:
        return hash((self.law, frozenset(self.values.items()), self.max_penetration, self.stiffness))

    def at(self, state: Mapping[Any, Any]) -> str:
        """Describe a point: the state, then the parameters."""
        shown = [*state.items(), *((q, self.values[q]) for q in self.law.parameters if q in self.values)]
        if self.law.fitted_in:
            return ", ".join(f"{q.name} = {mp.nstr(x, 4)}" for q, x in shown) + f", in {self.law.fitted_in}"
        return ", ".join(f"{q.name} = {_with_unit(x, q.unit)}" for q, x in shown)

    def fault(self, quantity: str, state: Mapping[Any, Any], found: str, expected: str, remedy: str) -> Fault:
        """Make the fault at a point."""
        return Fault(f"law {self.law.name}, {quantity} at {self.at(state)}", found, expected, remedy)


def with_definitions(law: Law, values: Values) -> Values:
    """Add the definitions that can be evaluated from the values."""
    for symbol, expression in law.definitions:
        if all(q in values for q in expression.free_symbols):
            value = number(expression, values)
            values[symbol] = mp.nan if value is None else value
    return values


def number(expression: Any, values: Mapping[Any, Any]) -> Any:
    """Value of an expression if it is real and finite, else None."""
    try:
        value = evaluate(sp.sympify(expression), values)
    except (ZeroDivisionError, ValueError, OverflowError, TypeError):
        return None
    value = mp.mpmathify(value)
    if isinstance(value, mp.mpc):
        value = value.real if abs(value.imag) <= AGREEMENT * abs(value.real) else mp.nan
    return value if mp.isfinite(value) else None


@lru_cache(maxsize=512)
def _derivative(expression: Any, symbol: Any) -> Any:
    """Derivative away from jumps and kinks, where the branches of generated code are differentiated."""
    slope = sp.diff(expression, symbol).replace(sp.DiracDelta, lambda *_: sp.S.Zero)
    return slope.replace(sp.Heaviside, lambda x, *_: Where(x > 0, 1, 0))


def _with_unit(value: Any, unit: str) -> str:
    number = mp.nstr(value / mpf(repr(parse_unit(unit).factor)), 4)
    return number if unit == "1" else f"{number} {unit}"


# -- tests of each kind ------------------------------------------------------------------------------------------------


@lru_cache(maxsize=256)
def faults_of(trial: Trial) -> tuple[Fault, ...]:
    """Return the faults of a law; raises TypeError for an unknown kind of law."""
    for kind, test in _TESTS.items():
        if isinstance(trial.law, kind):
            return tuple(test(trial))
    raise TypeError(f"{type(trial.law).__name__} is no kind of law that is known")


def _shown(value: Any, unit: str, digits: int = 4) -> str:
    return "no finite real number" if value is None else f"{mp.nstr(value, digits)} {unit}"


def _undefined(trial: Trial, quantity: str, state: Mapping[Any, Any]) -> Fault:
    return trial.fault(quantity, state, "no finite real number", "one everywhere in the law's range",
                       "State the range it holds in: a `reach`, or limits of the symbols.")  # fmt: skip


def _elastic(trial: Trial) -> list[Fault]:
    law, slope = trial.law, _derivative(trial.law.force, d)
    if not law.force.has(d):
        return [trial.fault("force", {}, f"{law.force}, without d", "a force that rises with the penetration d",
                          "A contact begins without a force: the penetration is the name d.")]  # fmt: skip
    limit = trial.max_penetration if law.reach is None else number(law.reach, trial.values)
    if limit is None or limit <= 0:
        return [trial.fault("reach", {}, "no length above 0" if limit is None else f"{mp.nstr(limit, 4)} m", "a penetration above 0",
                          "The reach is the penetration up to which the law is defined.")]  # fmt: skip
    points = [(depth, trial.values | {d: depth}) for depth in (limit * part for part in FRACTIONS)]
    forces = [number(law.force, values) for _, values in points]
    undefined = [k for k, (_, values) in enumerate(points) if forces[k] is None or number(slope, values) is None]
    if undefined:
        quantity = "force" if forces[undefined[0]] is None else "slope of the force"
        return [_undefined(trial, quantity, {d: points[undefined[0]][0]})]
    at_onset = number(law.force, trial.values | {d: limit * ONSET})
    if at_onset is None or abs(at_onset) > LEFT_AT_ONSET * abs(forces[-1]):
        return [trial.fault("force", {d: mpf(0)}, _shown(at_onset, "N"), "0 N, and no jump at the onset",
                          "A contact begins without a force: omit terms that do not vanish with d.")]  # fmt: skip
    falling = _end_of_rise(law.force, slope, trial.values, [mpf(0), *(depth for depth, _ in points)], [mpf(0), *forces])
    if falling is not None:
        force = number(law.force, trial.values | {d: falling})
        actual = f"{mp.nstr(force, 4)} N, no longer rising with the penetration"
        return [trial.fault("force", {d: falling}, actual, "a force above 0 that rises with the penetration",
                          f"A sign is wrong, or the law ends there: state a `reach` below {mp.nstr(falling, 3)} m.")]  # fmt: skip
    return [*_stored(trial, points, forces, limit), *_relation(trial, points, forces)]


def _relation(trial: Trial, points: list[tuple[Any, Values]], forces: list[Any]) -> list[Fault]:
    """Test the published relation d(F), if the law has one, against its inverse, the force."""
    relation = trial.law.relation
    if relation is None:
        return []
    for (depth, values), force in zip(points, forces, strict=True):
        back = number(relation, values | {F: force})
        if back is None or abs(back - depth) > AGREEMENT * depth:
            expected = f"{mp.nstr(depth, 6)} m, of which `force` is the force"
            return [trial.fault("relation", {d: depth, F: force}, _shown(back, "m", 6), expected,
                                "`relation` is d(F) as published, `force` its inverse: one of them is not.")]  # fmt: skip
    return []


def _end_of_rise(force: Any, slope: Any, values: Mapping[Any, Any], depths: list[Any], forces: list[Any]) -> Any:
    """Least penetration where the force stops rising, bisected to four digits; None if it rises."""
    for k in range(1, len(depths)):
        steep = number(slope, {**values, d: depths[k]})
        if forces[k] > forces[k - 1] and steep is not None and steep > 0:
            continue
        low, high = depths[k - 1], depths[k]
        for _ in range(20):
            middle = (low + high) / 2
            rising = number(slope, {**values, d: middle})
            value = number(force, {**values, d: middle})
            fine = None not in (rising, value) and rising > 0 and value > 0
            low, high = (middle, high) if fine else (low, middle)
        return high
    return None


def _stored(trial: Trial, points: list[tuple[Any, Values]], forces: list[Any], limit: Any) -> list[Fault]:
    """Test the stored energy against the force: its derivative by differences, its value at the onset."""
    stored = trial.law.stored
    if stored is None:
        return []
    remedy = "Leave `stored` out: it is then the integral, by Gauss's rule."
    at_onset = number(stored, trial.values | {d: limit * ONSET})
    if at_onset is None or abs(at_onset) > LEFT_AT_ONSET * forces[-1] * limit:
        return [
            trial.fault(
                "stored energy", {d: mpf(0)}, _shown(at_onset, "J"), "0 J before anything is pressed in", remedy
            )
        ]
    ratios = []
    for (depth, values), force in zip(points, forces, strict=True):
        step = depth * DIFFERENCE
        above, below = (number(stored, {**values, d: depth + sign * step}) for sign in (1, -1))
        if above is None or below is None:
            return [_undefined(trial, "stored energy", {d: depth})]
        ratios.append((above - below) / (2 * step) / force)
    worst = max(range(len(points)), key=lambda k: abs(ratios[k] - 1))
    if abs(ratios[worst] - 1) > AGREEMENT:
        alike = all(abs(ratio - ratios[0]) <= AGREEMENT * abs(ratios[0]) for ratio in ratios)
        everywhere = f", as everywhere: {mp.nstr(ratios[0], 6)} of it, so a factor is wrong" if alike else ""
        actual = f"a derivative of {mp.nstr(ratios[worst] * forces[worst], 6)} N{everywhere}"
        expected = f"the force, {mp.nstr(forces[worst], 6)} N"
        return [trial.fault("stored energy", {d: points[worst][0]}, actual, expected, remedy)]
    return []


def _damping(trial: Trial) -> list[Fault]:
    """Test that the damping force opposes the penetration rate."""
    law, partner = trial.law, trial.stiffness
    if partner is None:
        return []
    limit = partner.max_penetration if partner.law.reach is None else number(partner.law.reach, partner.values)
    slopes = [_derivative(law.resistance, q) for q in (v, d, F) if law.resistance.has(q)]
    tangent = _derivative(partner.law.force, d)
    for part in (FRACTIONS[2], FRACTIONS[3], FRACTIONS[7]):
        depth = (limit or partner.max_penetration) * part
        inside = {**partner.values, d: depth}
        pressed = {d: depth, F: number(partner.law.force, inside), k_t: number(tangent, inside)}
        if None in pressed.values():
            return []  # a fault of the stiffness law, reported there
        for onset in (SPEEDS[3], SPEEDS[6]):
            for rate in (sign * speed for speed in SPEEDS for sign in (1, -1)):
                state = {v: rate, d: depth} | ({v0: onset} if law.resistance.has(v0) else {})
                values = {**trial.values, **pressed, v0: onset, v: rate}
                resistance = number(law.resistance, values)
                if resistance is None or any(number(slope, values) is None for slope in slopes):
                    quantity = "damping force" if resistance is None else "slope of the damping force"
                    return [_undefined(trial, quantity, state)]
                if resistance * rate < 0:
                    return [_energy_gain(trial, "damping force", state, resistance, rate)]
    return []


def _energy_gain(trial: Trial, quantity: str, state: Mapping[Any, Any], force: Any, speed: Any) -> Fault:
    actual = f"{mp.nstr(force, 4)} N at {mp.nstr(speed, 4)} m/s, a power of {mp.nstr(-force * speed, 4)} W put into the motion"
    return trial.fault(quantity, state, actual, "a force of the sign of the speed: it takes energy, and gives none",
                       "A sign is wrong, or a function that is even in the speed stands where an odd one does: tanh, not cos.")  # fmt: skip


def _friction(trial: Trial) -> list[Fault]:
    law = trial.law
    if law.memory:
        return _bristle(trial)
    for load in LOADS:
        pressed = {**trial.values, N: load}
        rest = number(law.force, pressed | {s: mpf(0)})
        if rest is None or rest != 0:
            return [trial.fault("friction force", {s: mpf(0), N: load}, _shown(rest, "N"), "0 N at rest",
                                "Friction is odd in s, tanh(s/v_s) for instance: it changes its sign with the direction of sliding.")]  # fmt: skip
        for speed in SPEEDS:
            state = {s: speed, N: load}
            there, back = (number(law.force, pressed | {s: at}) for at in (speed, -speed))
            if number(_derivative(law.force, s), pressed | {s: speed}) is None:
                return [_undefined(trial, "slope of the friction force", state)]
            if faults := _against_sliding(trial, "friction force", state, there, back):
                return faults
    held = {N: LOADS[0]}
    holding = mpf(0) if law.holding is None else number(law.holding, trial.values | held)
    faults = [] if law.modes else [fault for load in LOADS for fault in _slope_at_rest(trial, load)]
    if holding is None or holding < 0:
        faults.append(
            trial.fault("force held at rest", held, _shown(holding, "N"), "a force, not below 0", "A sign is wrong.")
        )
    return faults


def _against_sliding(trial: Trial, quantity: str, state: Mapping[Any, Any], there: Any, back: Any) -> list[Fault]:
    """Test that a force opposes sliding, and is `back`, its negative, in the reversed state."""
    if there is None or back is None:
        return [_undefined(trial, quantity, state)]
    if there * state[s] < 0:
        return [_energy_gain(trial, quantity, state, there, state[s])]
    if abs(there + back) > AGREEMENT * abs(there):
        return [trial.fault(quantity, state, f"{mp.nstr(there, 6)} N, and {mp.nstr(back, 6)} N at -s",
                            "an odd function of s: the same against either direction",
                            "Use s or sign(s) times a function of abs(s).")]  # fmt: skip
    return []


def _slope_at_rest(trial: Trial, load: Any) -> list[Fault]:
    law, pressed = trial.law, {**trial.values, N: load}
    stated, there = (
        number(expression, pressed | {s: at}) for expression, at in ((law.slope, mpf(0)), (law.force, SLOWEST))
    )
    if stated is not None and there is not None and abs(there / SLOWEST - stated) <= CURVATURE * abs(there / SLOWEST):
        return []
    expected = "its derivative there" + ("" if there is None else f", {mp.nstr(there / SLOWEST, 6)} N s/m")
    return [trial.fault("slope of the friction force", {s: mpf(0), N: load}, _shown(stated, "N s/m", 6), expected,
                        "Correct `slope`, or leave it out.")]  # fmt: skip


def _bristle(trial: Trial) -> list[Fault]:
    """Test friction with memory: odd in speed and memory together, dissipative in steady sliding."""
    law = trial.law
    ((symbol, rate, size),) = law.memory
    scale = number(size, trial.values)
    for load, speed in product(LOADS, SPEEDS):
        state = {s: speed, N: load}
        at = trial.values | state
        ends: list[Any] = [number(rate, at | {symbol: deflected}) for deflected in (mpf(0), scale)] if scale else [None]
        if None in ends or ends[0] == ends[-1]:
            return [_undefined(trial, f"rate of {symbol.name}", state)]
        settled = scale * ends[0] / (ends[0] - ends[1])  # rates of bristles are linear in the deflection
        there = number(law.force, at | {symbol: settled})
        back = number(law.force, at | {s: -speed, symbol: -settled})
        if faults := _against_sliding(trial, "friction force of steady sliding", state, there, back):
            return faults
    return []


def _film(trial: Trial) -> list[Fault]:
    law = trial.law
    for along, across in ((0, 0), (0.3, 0.2), (-0.6, 0.4), (0.1, -0.85), (0.85, 0)):
        state = {eps_w: mpf(along), eps_c: mpf(across), h: (1 - mpf(along)) / 10**4}
        values = with_definitions(law, {q: x for q, x in trial.values.items() if q not in STATE} | state)
        for component, expression in (("along", law.along), ("across", law.across), ("couple", law.couple)):
            value = number(expression, values)
            if value is None:
                return [_undefined(trial, component, state)]
            if value < 0 and component != "across":  # a force across the velocity does no work
                expected = "a drag not below 0: a film takes energy, and gives none"
                return [trial.fault(component, state, mp.nstr(value, 4), expected, "A sign is wrong.")]
    return []


_TESTS: dict[type[Any], Callable[[Trial], list[Fault]]] = {
    StiffnessLaw: _elastic,
    DampingLaw: _damping,
    FrictionLaw: _friction,
    FilmLaw: _film,
}
