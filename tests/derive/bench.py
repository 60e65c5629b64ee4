"""A law on the bench: its expressions as numbers, by mpmath or as fast floats, and the free impact of two bodies under it.

Nothing here comes from the derivation or the engine: law expressions in, numbers out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import casadi as ca
import sympy as sp
from mpmath import mp, mpf
from scipy.integrate import solve_ivp
from scipy.special import lambertw

from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import F, StiffnessLaw, d, k_t, m_eff, v, v0
from hertzwerk.derive.program.emit.helpers import HELPERS
from hertzwerk.derive.program.expression_text import expression_text
from reference.laws import STEEL

DIGITS = 40

TYPICAL = {
    "n": "1.5", "K": "2.4e9", "k": "2", "C": "50",
    "e": "0.7", "gamma": "1e4", "chi": "1e9", "m": "1.5", "A": "2e-6", "m_eff": "0.2", "v0": "1",
    "mu": "0.2", "mu_k": "0.15", "mu_s": "0.25", "v_s": "1e-3", "v_S": "0.05", "v_a": "1e-3", "v_b": "1e-2", "v_r": "0.02", "c_v": "3",
    "N_t": "10", "xi": "20",
    "sigma_y": "1e9", "d_m": "8e-5", "d_r": "5e-5", "h_m": "3e-5", "F_m": "900", "s_0": "1e5", "s_1": "3", "z": "1e-6", "N": "700",
}  # fmt: skip
STIFFNESS = {name: law for name, law in LAWS.items() if isinstance(law, StiffnessLaw)}


def numbers(law: Any, pair: Mapping[str, str] = STEEL, **given: Any) -> dict[sp.Symbol, Any]:
    """Values of every symbol of a law, SI: the bodies of `pair`, typical parameters, what is `given` by name; then its definitions."""
    with mp.workdps(DIGITS):
        known: dict[str, Any] = {name: mpf(value) for name, value in (TYPICAL | dict(pair)).items()}
        known |= {name: mpf(value) for name, value in given.items()}
        known |= {"E_1": known["E"], "E_2": known["E"], "nu_1": known["nu"], "nu_2": known["nu"]}
        known["dR"] = known["R_1"] - known["R_2"]
        known |= {"R_eff": known["R_1"] * known["R_2"] / known["dR"], "R_min": known["R_2"]}
        defaults = {symbol.name: mpf(repr(parameter.si)) for symbol, parameter in law.defaults}
        values = {
            symbol: (defaults | known)[symbol.name] for symbol in law.symbols() if symbol.name in defaults | known
        }
        for symbol, expression in law.definitions:
            values[symbol] = evaluate(expression, values)
        return values


def evaluate(expression: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """By mpmath at 40 digits."""
    with mp.workdps(DIGITS):
        symbols, function = _compiled(sp.sympify(expression))
        return function(*(values[symbol] for symbol in symbols))


@lru_cache(maxsize=1024)
def _compiled(expression: Any) -> tuple[list[Any], Callable[..., Any]]:
    symbols = sorted(expression.free_symbols, key=str)
    return symbols, sp.lambdify(symbols, expression, [{"Where": _where}, "mpmath"])


def fast(expression: Any, values: Mapping[sp.Symbol, Any], *free: sp.Symbol) -> Callable[..., float]:
    """As a function of floats of the `free` symbols."""
    bound = expression.xreplace({s: sp.Float(x, DIGITS) for s, x in values.items() if s not in free})
    lower = {"Where": _where, "LambertW": lambda x, k: lambertw(x, k).real}
    return sp.lambdify(free, bound, [lower, "math"])  # type: ignore[no-any-return]


def emitted(expression: Any, values: Mapping[sp.Symbol, Any], free: sp.Symbol) -> Callable[[float], float]:
    """As a CasADi function of one symbol, from the text that is generated; the rest are doubles."""
    names = {s.name: ca.SX(float(x)) for s, x in values.items() if s != free}
    scope: dict[str, Any] = {"ca": ca, **names, free.name: ca.SX.sym(free.name)}
    for helper in HELPERS.values():
        exec(helper, scope)
    function = ca.Function("f", [scope[free.name]], [eval(expression_text(expression), scope)])
    return lambda x: float(function(x))


def _where(condition: Any, a: Any, b: Any) -> Any:
    return a if condition else b


class Impact:
    """Two bodies of effective mass m meet at v0 under one stiffness and one damping law, nothing else acting.

    Integrated by an 8th-order method. `restitution` is what the law's own release rule leaves, `depth` the largest penetration [m].
    """

    def __init__(
        self, stiffness: Any, damping: Any | None, mass: float = 0.2, speed: float = 0.5, **given: Any
    ) -> None:
        values = numbers(stiffness, **given)
        elastic = fast(stiffness.force, values, d)
        tangent = fast(sp.diff(stiffness.force, d), values, d)
        resist = None
        if damping is not None:
            both = numbers(damping, **{"m_eff": mass, "v0": speed, **given}) | {m_eff: mpf(mass), v0: mpf(speed)}
            resist = fast(damping.resistance, both, F, k_t, d, v)
        ends_at_gap = damping is not None and damping.release == "gap"
        needs_tangent = damping is not None and damping.resistance.has(k_t)

        def total(depth: float, rate: float) -> float:
            if depth <= 0:
                return 0.0
            f = elastic(depth)
            return f + (resist(f, tangent(depth) if needs_tangent else 0.0, depth, rate) if resist else 0.0)

        # Scaled by the elastic impact, whose penetration is about speed * time: found by trying.
        time = 1e-9
        while elastic(speed * time) * time < mass * speed:
            time *= 1.3
        length = speed * time
        start = 1e-11  # of the length: what has happened until then is lost in rounding

        def rates(_: float, y: Any) -> list[float]:
            return [y[1], -total(y[0] * length, y[1] * speed) * time / (mass * speed)]

        def turn(_: float, y: Any) -> float:
            return float(y[1])

        def end(_: float, y: Any) -> float:
            pull = total(y[0] * length, y[1] * speed) * time / (mass * speed)
            return 1.0 if y[1] > 0 else float(y[0]) if ends_at_gap else float(min(y[0], pull))

        end.terminal, end.direction = True, -1  # type: ignore[attr-defined]
        run = solve_ivp(
            rates, (0, 500), [start, 1.0], "DOP853", events=(turn, end), rtol=1e-13, atol=1e-16, max_step=0.05
        )
        if run.t_events[1].size != 1:
            raise AssertionError(f"the contact does not end: {run.message}")
        self.depth = float(run.y_events[0][0][0]) * length
        self.restitution = -float(run.y_events[1][0][1])
        self.mass, self.speed = mass, speed
        self.elastic = elastic


class near:  # noqa: N801  # reads like pytest.approx, which adds an absolute tolerance and cannot print mpmath's numbers
    """Equal to a number to a relative tolerance."""

    def __init__(self, expected: Any, rel: float) -> None:
        self.expected, self.rel = expected, rel

    def __eq__(self, found: object) -> bool:
        with mp.workdps(DIGITS):
            return bool(abs(mpf(found) - self.expected) <= self.rel * abs(self.expected))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"{mp.nstr(mpf(self.expected), 17)} to {self.rel:g}"
