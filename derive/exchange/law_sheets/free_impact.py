"""Free impact of two bodies with a damping law: its scene, and its restitution in closed form.

Two bodies of effective mass m meet at v0 with no other force. With h, any elastic law f(d) (1 + h v/v0) returns the
root e_out of

    h (1 + e_out) = ln((1 + h)/(1 - h e_out)),  y = 1 - h e_out:  y exp(-y) = (1 + h) exp(-1 - h),  so  y = -W_0(-(1 + h) exp(-1 - h)).

K d^n + b sqrt(m K d^(n-1)) v is the linear oscillator v dv/dw = -omega^2 w - 2 zeta omega v in w = d^((n+1)/2), zeta
= b/sqrt(2 (n + 1)): it returns exp(-pi zeta/s), s = sqrt(1 - zeta^2), where it ends at d = 0, and exp(-zeta
acos(zeta)/s) where it is damped while approaching only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp
from mpmath import mp, mpf

from hertzwerk.derive.audit.numeric import evaluate
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.effects.contacts import Contact
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Y
from hertzwerk.derive.declare.mechanism.joints.axial import Prismatic
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.equations.contact.pairs.on_plane import SphereOnPlane
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.formulas.stiffness import power
from hertzwerk.derive.laws.law import DampingLaw, F, Quantity, d, m_eff, v

DIGITS = 30
POINT_CONTACT = sp.Rational(3, 2)

_MASS = Parameter("mass", "kg", 1)
_RADIUS = Parameter("radius", "m", 0.1)
_SPEED = Parameter("approach", "m/s", 1, "approach speed")
_EXPONENT = Parameter("exponent", "1", 1.5, "n of K d^n")
_STIFFNESS = Parameter("stiffness", "N/m^exponent", 1e8, "K of K d^n")


@dataclass(frozen=True)
class Trial:
    """A damping law with the scene of its free impact.

    `parameter` of the scene, in `unit`, is the law's first parameter: e, or one of its own. `exponent` is the n of
    the elastic force K d^n; `recommended` the range of e as numbers and as text, None for a law without e.
    """

    law: DampingLaw
    scene: Scene
    parameter: str
    unit: str
    exponent: float
    recommended: tuple[float, float] | None
    recommended_text: str

    def closed(self, e: float) -> float | None:
        """Restitution in closed form; None where there is none."""
        return restitution_out(self.law, e)

    @property
    def limits(self) -> tuple[float | None, float | None]:
        """Restitution in closed form as e -> 1 and as e -> 0."""
        return restitution_limits(self.law)


def trials() -> Iterator[Trial]:
    """Yield a trial of every damping law of the catalogue."""
    for law in LAWS.values():
        if isinstance(law, DampingLaw):
            e, range_of_e = restitution_symbol(law), law.recommended
            bounds = (
                None
                if range_of_e is None or e is None
                else (float(range_of_e.lower or 0), float(range_of_e.upper or 1))
            )
            taken, *_ = law.parameters
            text = "" if bounds is None else str(range_of_e)
            yield Trial(
                law, impact_scene(law), taken.name, _unit_of(law, taken), float(published_exponent(law)), bounds, text
            )


def impact_scene(law: DampingLaw) -> Scene:
    """Scene of a ball that meets a wall at t = 0, with elastic force K d^n and without gravity.

    Each parameter of the law is a parameter of the scene, of the same name. A free exponent of the penetration is
    that of Hertz's point contact.
    """
    ball = Body("ball", mass=_MASS)
    wall = GROUND.at(0, -_RADIUS, 0)  # so that the gap is the coordinate itself, without rounding
    size = ((_EXPONENT + 1) * _MASS * _SPEED**2 / (2 * _STIFFNESS)) ** (1 / (_EXPONENT + 1))
    values = {
        q.name: POINT_CONTACT if q == law.exponent else Parameter(q.name, _unit_of(law, q), 0.5, q.meaning)
        for q in law.parameters
    }
    return Scene(
        Mechanism(
            "free_impact",
            joints=(Prismatic("ball", GROUND, ball, axis=Y),),
            pairs=(SphereOnPlane("wall", sphere=ball.at(0, 0, 0), radius=_RADIUS, plane=wall, normal=Y),),
        ),
        effects=(Contact("wall", power(_STIFFNESS, _EXPONENT), law(**values)),),
        start=Start(speed={"ball": -_SPEED}),
        scales=Scales(length=size, speed=_SPEED),
        summary="one impact of a free ball",
    )


def _unit_of(law: DampingLaw, symbol: Quantity) -> str:
    """Unit of a parameter, with a free exponent of the penetration as in Hertz's point contact."""
    if law.exponent not in law.parameters or law.exponent == symbol:
        return str(symbol.unit)
    return str(Dimension.from_unit(parse_unit(symbol.unit), {str(law.exponent): POINT_CONTACT}))


def restitution_symbol(law: DampingLaw) -> Quantity | None:
    """Coefficient of restitution among the law's parameters; None for a law without."""
    return next((symbol for symbol in law.parameters if symbol.name == "e"), None)


def coefficient_at(law: DampingLaw, e: float) -> float:
    """Factor h, or the coefficient in its place, at a restitution."""
    with mp.workdps(DIGITS):
        return float(_coefficient(law, e))


def restitution_out(law: DampingLaw, e: float) -> float | None:
    """Restitution of an impact for given e, with K d^n, n = `published_exponent`; None if not closed."""
    with mp.workdps(DIGITS):
        return None if restitution_symbol(law) is None else _restitution_for(law, _coefficient(law, e))


def restitution_limits(law: DampingLaw) -> tuple[float | None, float | None]:
    """Restitution of an impact in the limits e -> 1 and e -> 0."""
    with mp.workdps(DIGITS):
        at_one, at_zero = (
            None if limit is None else _restitution_for(law, mp.inf if limit is sp.oo else evaluate(limit, {}))
            for limit in (law.at_one, law.at_zero)
        )
        return at_one, at_zero


def published_exponent(law: DampingLaw) -> Any:
    """Exponent n of the stiffness law that a damping law was published with.

    It follows from m = (n - 1)/2 where the damping is proportional to the root of the secant F/d, and is 3/2
    otherwise.
    """
    return POINT_CONTACT if _secant_root_factor(law) is None or law.exponent is None else 2 * law.exponent + 1


def _coefficient(law: DampingLaw, e: float) -> Any:
    state: dict[sp.Symbol, Any] = {restitution_symbol(law): mpf(repr(float(e)))}
    for symbol, expression in law.definitions:
        state[symbol] = evaluate(expression, state)
    return evaluate(law.factor, state) if law.factor is not None else state[law.definitions[-1][0]]


def _restitution_for(law: DampingLaw, coefficient: Any) -> float | None:
    """Restitution of an impact for a value of the coefficient."""
    if law.factor is not None:
        return float(_hysteresis_restitution(coefficient))
    share = _secant_root_factor(law)
    if share is None:
        return None
    multiple, approaching_only = share
    zeta = coefficient * evaluate(multiple / sp.sqrt(2 * (published_exponent(law) + 1)), {})
    if approaching_only:
        return float(_approach_damped_restitution(zeta))
    return float(mp.exp(-mp.pi * zeta / mp.sqrt(1 - zeta**2))) if zeta < 1 else 0.0


def _hysteresis_restitution(h: Any) -> Any:
    if h == 0 or mp.isinf(h):
        return mpf(h == 0)
    with mp.extradps(DIGITS):  # 1 - y cancels like h
        return (1 + mp.lambertw(-(1 + h) * mp.exp(-1 - h)).real) / h


def _approach_damped_restitution(zeta: Any) -> Any:
    if mp.isinf(zeta):
        return mpf(0)
    if zeta == 1:
        return mp.exp(-1)
    angle = mp.acos(zeta) / mp.sqrt(1 - zeta**2) if zeta < 1 else mp.acosh(zeta) / mp.sqrt(zeta**2 - 1)
    return mp.exp(-zeta * angle)


def _secant_root_factor(law: DampingLaw) -> tuple[sp.Expr, bool] | None:
    """Write the damping force as b sqrt(m F/d) v: (b/xi, whether while approaching only), else None.

    xi is the law's last definition.
    """
    resistance, approaching_only = law.resistance, False
    if isinstance(resistance, Where) and resistance.args[0] == (v > 0) and resistance.args[2] == 0:
        resistance, approaching_only = resistance.args[1], True
    b = resistance / (sp.sqrt(F / d * m_eff) * v)
    multiple = b / law.definitions[-1][0] if law.definitions else b
    known = multiple.is_number and (approaching_only or law.release == "gap")
    return (multiple, approaching_only) if known else None
