"""Hydrodynamic lubrication of a pin in its bush or before a sphere, with transition to dry contact.

The film is a force of its own, in flight as in contact. While it is thicker than two boundary layers (the height of
the asperities) it is that of its law. Closer, the eccentricity passed to the law is limited, so that the film never
gets thinner than one layer and its force stays finite. From contact on it fades, and vanishes at a penetration of one
layer, where only the contact law acts: the transition of Flores, Lankarani, Ambrosio, Claro, Proc. IMechE K 218
(2004) 183, whose dry force needs no weight here because it begins at zero by itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.declare.effects.effect import Declared, Element, Event, Kinematics, PairEffect, State, together
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, cross, dot, scale, sub
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import POSITIVE, Interval, Scalar, Slot, is_number
from hertzwerk.derive.laws.law import BoundLaw, eps_c, eps_w, h

QUANTITIES = {
    "axis": ("a", "", "axis of the bush"),
    "squeeze": ("w", "", "velocity of the pin against the bush, midway between their centres, across the axis"),
    "squeeze_speed": ("w", "", "its size; where it is 0, the speed accuracy is measured by"),
    "across": ("w", r"\perp", "the same a quarter turn on about the axis"),
    "spin": (r"\Omega", "", "spin of the pin in the bush"),
    "epsilon": (
        r"\varepsilon",
        "",
        "eccentricity over clearance, or what leaves a film of two boundary layers if that is more",
    ),
    "nearness": ("x", "0", "0 up to a film of two boundary layers, rising as it thins"),
    "lost": ("x", r"\mathrm{lost}", "share of two boundary layers that the film has lost of its thickness"),
    "thinning": ("x", "", "0 up to a film of two boundary layers, 1 from contact on"),
    "limited": (r"\varepsilon", r"\mathrm{lim}", "the same, never less than a film of one boundary layer"),
    "sinking": ("y", "", "0 up to contact, 1 at a penetration of one boundary layer"),
    "per_e": (
        r"\kappa",
        "",
        "what the eccentricity is multiplied by: the reciprocal of the clearance, less where the film is thin",
    ),
    "share": (r"\chi", "", "share of the film that is left in contact"),
    "epsilon_w": (r"\varepsilon", "w", ""),
    "epsilon_c": (r"\varepsilon", r"\perp", ""),
    "drag_along": ("D", "w", "drag of the film along the squeeze velocity"),
    "drag_across": ("D", r"\perp", "drag of the film across the squeeze velocity"),
    "drag_spin": ("D", r"\Omega", "drag of the film against the spin"),
    "drag": ("D", "", "drag of the film against the approach"),
    "load": ("F", r"\mathrm{film}", "force of the film along the normal"),
    "thickness": ("h", "", "thickness of the film, no less than a boundary layer"),
    "force": ("F", r"\mathrm{film}", "force of the film on the first body"),
    "couple": ("T", r"\mathrm{film}", "couple of the film on the pin"),
}
SOUGHT = (
    "nearness",
    "lost",
    "squeeze",
    "spin",
    "epsilon",
    "thinning",
    "limited",
    "sinking",
    "per_e",
    "share",
    "drag_along",
    "drag_across",
    "drag",
    "load",
    "thickness",
    "force",
    "couple",
)


REST = sp.Float("1e-6")
"""Of the scene's speed: a film ruptures or fills where it opens or closes faster, which moves a reversal by the square of that."""
TRANSITIONS = {"smooth": (-2, 1), "linear": (-1, 1), "abrupt": (-1, 0)}
"""Of each transition the penetrations at which its law has a seam, in boundary layers, beside the onset of contact."""


@dataclass(frozen=True)
class Lubrication(PairEffect):
    """Film of one pair; `boundary_layer` [m] is the thickness at which the asperities meet.

    In a bush it is less than half the clearance. `cavitation` is of spheres alone: the film ruptures while it opens, and has
    no force, by Gümbel's condition as by Reynolds'; without it the film pulls. A law of pin and bush has its own.

    `transition` to dry contact: "smooth", from two layers to a penetration of one; "linear", where the film is never thinner than a
    layer and its share falls in proportion to the penetration (hybrid law of Flores et al. 2006, grade C); "abrupt", where it ends
    with the onset of contact (Ravn et al. 2000, grade C).
    """

    name: str
    pair: str
    law: BoundLaw
    boundary_layer: Scalar
    unchecked: bool = False
    cavitation: bool = False
    transition: str = "smooth"
    kind: ClassVar[str] = "lubrication"
    takes: ClassVar[Mapping[str, str]] = {"law": "film"}
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = QUANTITIES
    sought: ClassVar[tuple[str, ...]] = SOUGHT
    measures: ClassVar[Mapping[str, Slot]] = {"boundary_layer": Slot.of("m", POSITIVE)}

    @property
    def text(self) -> str:
        """Description for people."""
        ruptures = ", none while it opens," if self.cavitation else ""
        return f"{self.law.law.name} film{ruptures} at {self.pair}" + (", UNCHECKED" if self.unchecked else "")

    @property
    def section(self) -> str:
        """Title of the film's own section."""
        return f"Film {self.name}"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the parameters of the law, the boundary layer, and its ratio to the clearance."""
        yield from super().slots(scene)
        geometry = scene.geometry(self.pair)
        if "dR" in geometry and is_number(self.boundary_layer):
            yield Slot(
                f"{self.where}, boundary layer over clearance", self.boundary_layer / geometry["dR"], "1",
                Interval(0, 0.5, open_left=True, open_right=True),
            )  # fmt: skip

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair that is missing or not the law's, and of a journal's cavitation."""
        yield from super().faults(scene)
        if self.cavitation and self.law.law.forms != ("point",):
            yield Fault(f"{self.where}, cavitation", f"cavitation=True with {self.law.law.name}", "a law of spheres, such as sphere_film",
                        "The laws of pin and bush have a cavitation of their own: leave it out.")  # fmt: skip
        if self.transition not in TRANSITIONS:
            yield Fault(f"{self.where}, transition", repr(self.transition), one_of(TRANSITIONS, ""))

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the number of seams of the law that are passed; the first step finds it."""
        yield State("seams", "1", size=sp.S.One)
        if self.cavitation:
            yield State("ruptured", "1", size=sp.S.One)

    def element(self, kin: Kinematics) -> Element:
        """Element of the film; outputs: size of its force [N], least thickness [m].

        The thickness is at least a boundary layer.
        """
        return (_Squeeze if self.law.law.forms == ("point",) else _Journal)(self, kin).element()


class _Film:
    """Film on the tape."""

    def __init__(self, effect: Lubrication, kin: Kinematics) -> None:
        self.effect, self.kin = effect, kin

    def let(self, expression: Any, label: str, stated: str = "") -> Any:
        """Name a result on the tape; with an unchecked law it has the stated unit."""
        dimension = Dimension.from_unit(stated) if stated and self.effect.unchecked else None
        return self.kin.tape.let(expression, f"{self.effect.name}_{label}", dimension)

    def named(self, vector: Vector, label: str) -> Vector:
        """Name a vector on the tape."""
        return self.kin.tape.vector(vector, f"{self.effect.name}_{label}")

    def resistances(self, state: dict[sp.Symbol, Any]) -> list[Any]:
        """Resistances by the law in a state of the film."""
        bound = self.effect.law
        geometry = self.kin.scene.geometry(self.effect.pair)
        values = state | bound.binding | {quantity: geometry[quantity.name] for quantity in bound.law.geometry}
        for symbol, expression in bound.law.definitions:
            values[symbol] = self.let(expression.xreplace(values), symbol.name, symbol.unit)
        names = ("drag_along", "drag_across", "drag_spin") if len(bound.law.forces) > 1 else ("drag",)
        return [
            self.let(expression.xreplace(values), name, unit)
            for name, (_, expression, unit) in zip(names, bound.law.expressions(), strict=True)
        ]

    def limited(self, thinning: Any) -> Any:
        """Share of two layers that a film has lost below this thickness: from 0 to 1/2.

        It begins with slope 1 and ends with 0, smoothly with no curvature at either.
        """
        if self.effect.transition != "smooth":
            return self.let(Where(thinning < sp.Rational(1, 2), thinning, sp.Rational(1, 2)), "lost")
        return thinning * (1 - thinning**2 * (1 - thinning / 2))

    @property
    def passed(self) -> Any:
        """Number of seams of the law that are passed."""
        return self.kin.state(f"{self.effect.name}.seams")

    def seam(self, penetration: Any, places: Iterable[Any]) -> Event:
        """Return the event at the seams of the law, where steps end; lengths in boundary layers."""
        past = [self.let(penetration - place, f"past_{number}") for number, place in enumerate(places)]
        margin = sp.Mul(*(Where(self.passed > number, way, -way) for number, way in enumerate(past)))
        return Event("seam", margin, sp.S.One, {"seams": sp.Add(*(Where(way >= 0, 1, 0) for way in past))})

    def share(self, within: Any, sinking: Any) -> Any:
        """Share of the film that is left in contact: none beyond a penetration of one layer."""
        if self.effect.transition == "abrupt":  # by its event: at the onset rounding would decide
            return self.let(Where(self.passed > 1, 0, 1), "share")
        left = 1 - sinking if self.effect.transition == "linear" else 1 - sinking**2 * (3 - 2 * sinking)
        return self.let(Where(within, left, 0), "share")


class _Squeeze(_Film):
    """Film before a sphere: force along the normal, at the sphere's centre, and dissipated power."""

    def element(self) -> Element:
        """Forces, dissipated power, outputs."""
        touch, layer = self.kin.touch(self.effect.pair), sp.sympify(self.effect.boundary_layer)
        depth, approach = touch.penetration, touch.penetration_rate
        nearness = self.let(Where(-depth < 2 * layer, 1 + depth / (2 * layer), 0), "nearness")
        thinning = self.let(Where(depth < 0, nearness, 1), "thinning")
        lost = 2 * layer * (1 - self.limited(thinning))
        thickness = self.let(Where(-depth < 2 * layer, lost, -depth), "thickness")
        sinking = self.let(Where(depth > 0, depth / layer, 0), "sinking")
        (drag,) = self.resistances({h: thickness})
        load = self.share(depth < layer, sinking) * drag * approach
        events = [self.seam(depth / layer, TRANSITIONS[self.effect.transition])]
        if self.effect.cavitation:  # its force has a kink where it ruptures: a step ends there, but not at rest
            ruptured = self.kin.state(f"{self.effect.name}.ruptured")
            load = Where(ruptured > 0, 0, load)
            pace = sp.sympify(self.kin.scene.scales.speed)
            margin = self.let(Where(ruptured > 0, -approach, approach) + REST * pace, "reversal")
            events.append(Event("rupture", margin, pace, {"ruptured": 1 - ruptured}))
        load = self.let(load, "load")
        force = self.named(scale(load, touch.normal), "force")
        forces = self.kin.generalised(force, touch.position, touch.first.body, touch.second.body, self.effect.name)
        outputs = (f"{self.effect.name}.force", "N", sp.Abs(load)), (f"{self.effect.name}.thickness", "m", thickness)
        return Element(forces, dissipated=self.let(load * approach, "power"), outputs=outputs, events=tuple(events))


class _Journal(_Film):
    """Film between pin and bush: force midway between the centres, couple, and dissipated power."""

    def __init__(self, effect: Lubrication, kin: Kinematics) -> None:
        super().__init__(effect, kin)
        self.touch = kin.journal(effect.pair)
        self.clearance = sp.sympify(self.touch.pair.clearance)
        self.layer = sp.sympify(effect.boundary_layer) / self.clearance

    def element(self) -> Element:
        """Forces, dissipated power, outputs."""
        touch, kin = self.touch, self.kin
        axis = self.named(kin.direction(touch.second, touch.pair.axis), "axis")
        middle = add(touch.base, scale(sp.Rational(1, 2), touch.apart))
        rate = self.named(touch.rate_at(middle), "squeeze")
        squeeze = self.named(sub(rate, scale(self.let(dot(rate, axis), "along"), axis)), "squeeze")
        across = self.named(cross(axis, squeeze), "across")
        bodies = touch.first.body, touch.second.body
        turning = sub(*map(kin.angular_velocity, bodies))
        spin = self.let(dot(axis, turning), "spin")

        near, faded = self._closeness()
        along_drag, across_drag, spin_drag = self._drags(squeeze, across, near)
        force = self.named(scale(-faded, add(scale(along_drag, squeeze), scale(across_drag, across))), "force")
        couple = self.let(-faded * spin_drag * spin, "couple")

        forces = together(
            kin.generalised(force, middle, *bodies, self.effect.name),
            kin.generalised_moment(scale(couple, axis), *bodies, f"{self.effect.name}_couple"),
        )
        power = self.let(-dot(force, squeeze) - couple * spin, "power")
        thickness = self.let(self.clearance * (1 - near * self.let(sp.sqrt(self._squared), "e_size")), "thickness")
        size = self.let(sp.sqrt(dot(force, force)), "force_size")
        outputs = (f"{self.effect.name}.force", "N", size), (f"{self.effect.name}.thickness", "m", thickness)
        # of the squared eccentricity, which is smooth at the centre
        places = ((place + place**2 * self.layer / 2) for place in TRANSITIONS[self.effect.transition])
        seam = self.seam(
            (self.let(self._squared / self.clearance**2, "epsilon_squared") - 1) / (2 * self.layer), places
        )
        return Element(forces, dissipated=power, outputs=outputs, events=(seam,))

    @property
    def _squared(self) -> Any:
        """Squared eccentricity [m^2]."""
        return self.let(dot(self.touch.eccentricity, self.touch.eccentricity), "e_squared")

    def _closeness(self) -> tuple[Any, Any]:
        """Factor from eccentricity to its ratio [1/m], and the share of the film that remains in contact.

        The factor is 1/clearance up to a film of two boundary layers, and less beyond, so that the film is never
        thinner than one.
        """
        layer, clearance = self.layer, self.clearance
        free = self.let(1 - 2 * layer, "free")
        squared = self.let(self._squared / clearance**2, "epsilon_squared")
        # not of the centre, where a root has no derivative
        ratio = self.let(sp.sqrt(Where(squared > free**2, squared, free**2)), "epsilon")
        thinning = self.let(Where(squared < 1, (ratio - free) / (2 * layer), 1), "thinning")
        limited = self.let(free + 2 * layer * self.limited(thinning), "limited")
        sinking = self.let(Where(squared > 1, (ratio - 1) / layer, 0), "sinking")
        per_e = self.let(limited / (ratio * clearance), "per_e")
        return per_e, self.share(squared < (1 + layer) ** 2, sinking)

    def _drags(self, squeeze: Vector, across: Vector, near: Any) -> list[Any]:
        """Drags by the law at the position of the pin: along, across, against the spin."""
        e = self.touch.eccentricity
        squared = self.let(dot(squeeze, squeeze), "squeeze_squared")
        pace = sp.sympify(self.kin.scene.scales.speed)
        nonzero = self.let(sp.sqrt(Where(squared > 0, squared, pace**2)), "squeeze_speed")
        along, beside = (near * dot(e, direction) / nonzero for direction in (squeeze, across))
        return self.resistances({eps_w: self.let(along, "epsilon_w"), eps_c: self.let(beside, "epsilon_c")})
