"""Friction of a circular patch that slides and spins at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.contacts import Friction
from hertzwerk.derive.declare.effects.effect import Declared, Turning, together
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import (
    DrillingResistance,
    Grip,
    Moment,
    PairResistance,
)
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, dot, scale, sub
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot

MEANS = 7  # arithmetic-geometric means: they converge quadratically, from a ratio of 1e-12
ALIKE = sp.Rational(1, 10**24)  # of 1: difference of the squared speeds of sliding and of the rim that counts as none


@dataclass(frozen=True)
class PatchFriction(PairResistance):
    """Coulomb friction of a circular patch under a uniform pressure; sliding and spin share it.

    As of a flat disc. Every point of the patch slides with v + w x r and is opposed by `coefficient` mu times the pressure there. The force
    on the first body is mu N if it slides alone, the moment about the normal 2/3 mu N R if it spins alone, on the patch's
    `radius` R; each is less beside the other, and both end together: a disc comes to rest with v = 0.653 R w. The
    integrals are complete elliptic ones, evaluated by arithmetic-geometric means to rounding. It is set-valued: at rest
    it holds any force and moment within their limit surface, and beyond it sets off along its normal. Or it is smoothed,
    by a `speed` [m/s] added to the faster of sliding and rim under a root: what stands on a slope then creeps.

    It is in place of the pair's `Friction` and `DrillingResistance`. Source: Farkas, Bartels, Unger, Wolf, Phys. Rev. Lett. 90
    (2003) 248302; Leine, Glocker, European Journal of Mechanics A/Solids 22 (2003) 193, after Contensou.
    """

    name: str
    pair: str
    coefficient: Scalar
    radius: Scalar
    speed: Scalar | None = None
    holds: ClassVar[str] = "N"
    mode: ClassVar[str] = "slip"
    kind: ClassVar[str] = "patch_friction"
    sought: ClassVar[tuple[str, ...]] = ("slip", "spin", "faster", "force", "moment")
    measures: ClassVar[Mapping[str, Slot]] = {
        "coefficient": Slot.of("1", NOT_NEGATIVE),
        "radius": Slot.of("m", POSITIVE),
        "speed": Slot.of("m/s", POSITIVE),
    }
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = {
        "rate": ("w", r"\mathrm{t}", "velocity of the first body against the second at the patch"),
        "along_rate": ("w", r"\mathrm{n}", "its part along the normal"),
        "slip": ("s", "", "sliding velocity of the patch's middle, vector"),
        "slip_squared": ("s^{2}", "", "its square"),
        "spin": (r"\omega", r"\mathrm{d}", "angular velocity about the normal, of the first body against the second"),
        "rim_squared": ("v^{2}", r"\mathrm{d}", "squared speed of the patch's rim by spin alone"),
        "more": ("v^{2}", r"\mathrm{max}", "the larger of both squares"),
        "share": ("m", "", "the smaller over the larger"),
        "mean": ("a", "", "arithmetic mean"),
        "root": ("b", "", "geometric mean"),
        "half": ("c", "", "half of their difference, by the share"),
        "sum": (r"\Sigma", "", "sum of the squared differences, by the squared share"),
        "period": ("K", "", "complete elliptic integral of the first kind"),
        "faster": ("v", r"\mathrm{max}", "speed of sliding or of the rim, the faster, smoothed"),
        "per_speed": ("c", r"\mathrm{t}", "force per sliding velocity"),
        "per_spin": ("c", r"\mathrm{d}", "moment per angular velocity"),
        "force": ("F", r"\mathrm{t}", "friction force on the first body"),
        "moment": ("M", r"\mathrm{d}", "friction moment on the first body"),
        "power": ("P", r"\mathrm{d}", "power dissipated by the patch"),
        "limit": ("F", r"\mathrm{h}", "the most that the patch holds with, without a moment"),
        "friction_force_1": (
            "F",
            r"\mathrm{t1}",
            "friction force of the patch along the first tangent, by its sliding and spin",
        ),
        "friction_force_2": (
            "F",
            r"\mathrm{t2}",
            "friction force of the patch along the second tangent, by its sliding and spin",
        ),
        "friction_force_3": (
            "F",
            r"\mathrm{d}",
            "friction moment of the patch over its radius, of its sliding and spin",
        ),
    }

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair without a contact, and of what it is in place of."""
        yield from super().faults(scene)
        for other in scene.effects:
            if isinstance(other, (Friction, DrillingResistance)) and other.pair == self.pair:
                yield Fault(self.where, f"{other.kind.replace('_', ' ')} {other.name} at {self.pair} too", "the friction of a patch alone",
                            "It is the patch's sliding and spin at once: leave the other out.")  # fmt: skip

    def axes(self, touch: Any) -> tuple[Vector, ...]:
        """Tangents of the surfaces, then their normal."""
        return (*touch.tangents, touch.normal)

    def grip(self, kin: Turning, touch: Any, pressing: Any) -> Grip:
        """Grip of the patch: forces along the tangents, and the moment about the normal over the radius."""
        bodies, tape = (touch.first.body, touch.second.body), kin.tape
        *tangents, normal = axes = self.axes(touch)
        radius = sp.sympify(self.radius)
        rate = tape.vector(touch.rate_at(touch.contact_point), f"{self.name}_rate")
        spin = dot(sub(*map(kin.angular_velocity, bodies)), normal)
        velocity = *(dot(rate, tangent) for tangent in tangents), radius * spin
        limit = tape.let(sp.sympify(self.coefficient) * pressing, f"{self.name}_limit")
        on = touch.contact_point, *bodies, f"{self.name}_grip"
        along = (
            *(kin.generalised(tangent, *on) for tangent in tangents),
            kin.generalised_moment(scale(radius, normal), *on[1:]),
        )
        return Grip(axes, along, tuple(tape.let(part, f"{self.name}_velocity") for part in velocity), limit, limit)

    def held(self, grip: Grip, components: Sequence[Any]) -> tuple[Vector, Vector]:
        """Force and moment of the patch."""
        *forces, moment = (scale(part, axis) for part, axis in zip(components, grip.tangents, strict=True))
        return add(*forces), scale(sp.sympify(self.radius), moment)

    def moment(self, kin: Turning, touch: Any, pressing: Any) -> Moment:
        """Moment at a contact geometry (a `Touch`), under the force that presses [N].

        Its generalised forces are those of the friction force too.
        """
        bodies, tape, normal = (touch.first.body, touch.second.body), kin.tape, touch.normal

        def let(expression: Any, name: str) -> Any:
            return tape.let(expression, f"{self.name}_{name}")

        rate = tape.vector(touch.rate_at(touch.contact_point), f"{self.name}_rate")
        slip = tape.vector(sub(rate, scale(let(dot(rate, normal), "along_rate"), normal)), f"{self.name}_slip")
        spin = let(dot(sub(*map(kin.angular_velocity, bodies)), normal), "spin")
        radius, speed = sp.sympify(self.radius), sp.sympify(self.speed)
        slides, turns = let(dot(slip, slip), "slip_squared"), let((radius * spin) ** 2, "rim_squared")
        more = let(Where(slides > turns, slides, turns), "more")
        share = let(Where(slides > turns, turns, slides) / Where(more > 0, more, speed**2), "share")
        period, total = _integrals(let, share)
        faster = let(sp.sqrt(more + speed**2), "faster")
        pull = let(sp.sympify(self.coefficient) * pressing * period / faster, "per_speed")
        half = sp.Rational(1, 2) + share * total  # (1 - E/K)/share
        force_share = 4 / (3 * sp.pi) * (2 - (1 + share) * half)
        of_spin = 3 - share - (4 - 2 * share) * share * half
        moment_share = 4 / (9 * sp.pi) * Where(slides > turns, 1 + 2 * total * (1 - 2 * share), of_spin)
        per_speed, per_spin = let(pull * force_share, "per_speed"), let(radius**2 * pull * moment_share, "per_spin")
        force = tape.vector(scale(-per_speed, slip), f"{self.name}_force")
        vector = tape.vector(scale(-per_spin * spin, normal), f"{self.name}_moment")
        generalised = together(
            kin.generalised(force, touch.contact_point, *bodies, f"{self.name}_force"),
            kin.generalised_moment(vector, *bodies, f"{self.name}_moment"),
        )
        return Moment(vector, generalised, let(per_speed * slides + per_spin * spin**2, "power"))


def _integrals(let: Any, m: Any) -> tuple[Any, Any]:
    """Return K(m) and (1 - E/K - m/2)/m^2 of the complete elliptic integrals, both without cancellation.

    By the means of a and b from 1 and sqrt(1 - m), with c' = c^2/(4 a'): 1 - E/K is the sum of 2^(n-1) c_n^2. Abramowitz,
    Stegun, Handbook of Mathematical Functions, 17.6.
    """
    left = 1 - m
    a, b, c, total = sp.S.One, let(sp.sqrt(Where(left > ALIKE, left, ALIKE)), "root"), None, sp.S.Zero
    for n in range(MEANS):
        mean = let((a + b) / 2, "mean")
        c = let(1 / (4 * mean) if c is None else m * c**2 / (4 * mean), "half")
        a, b, total = mean, let(sp.sqrt(a * b), "root"), total + 2**n * c**2
    return let(sp.pi / (2 * a), "period"), let(total, "sum")
