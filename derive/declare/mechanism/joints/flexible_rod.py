"""Slender elastic rod between two bodies: its ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, faults_if, refuse
from hertzwerk.derive.declare.mechanism.bodies import AXES, Body, Point, Z
from hertzwerk.derive.declare.mechanism.joints.conditions import Condition
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint, Port
from hertzwerk.derive.expressions.algebra.bending_shapes import ENDS, MOST, BendingShapes, bending_shapes
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot, is_number

SECTIONS = (25, 50, 75)
"""Percentages of the length of the sections in a picture."""


@dataclass(frozen=True, init=False)
class FlexibleRod(Joint):
    """Slender elastic rod (Euler and Bernoulli) along X of its body `start`, bent by small deflections.

    Other joints, effects and pairs act on its two bodies, `start` and `end`, each the section at an end of the rod. The rod is a
    joint between them and stands in the mechanism behind the joint that carries its start. The deflection is seen from
    the tangent at the start, as a sum of shapes whose amplitudes are the coordinates `bend_1`.. [m]; bending
    shortens the distance of the ends, by which axial forces and spin stiffen it.

    length            [m], with `mass` [kg], uniform
    stiffness         E I of bending in Y, about Z [N m^2]
    stiffness_z       E I of bending in Z, coordinates `bend_z_1`..; without it the rod bends in Y alone
    modes             number of eigenfunctions in each direction, of a uniform rod with these
    ends              conditions of start and end: "clamped", "pinned" or "free"
    cubics            whether two cubics come before them: forces and moments at the end then bend it exactly
    damping_ratio     of each eigenfunction at its frequency, with cubics of each mode of the rod clamped at its start [1]
    section_modulus   I/c [m^3], by which the bending stress is c M/I
    stations          percentages of the length at which deflection, moment and stress are histories
    twist_inertia     inertia about its own axis [kg m^2]; it does not twist
    """

    length: Scalar
    mass: Scalar
    stiffness: Scalar
    stiffness_z: Scalar | None
    modes: int
    ends: tuple[str, str]
    cubics: bool
    damping_ratio: Scalar
    section_modulus: Scalar | None
    stations: tuple[int, ...]
    bends: ClassVar[bool] = True
    symbol: ClassVar[str] = "flexible_rod"

    def __init__(
        self, name: str, length: Scalar, mass: Scalar, stiffness: Scalar, *, stiffness_z: Scalar | None = None, modes: int = 2,
        ends: tuple[str, str] = ("clamped", "free"), cubics: bool = False, damping_ratio: Scalar = 0,
        section_modulus: Scalar | None = None, stations: tuple[int, ...] = (0, 50, 100), twist_inertia: Scalar = 0,
    ) -> None:  # fmt: skip
        quantities = {
            "length": length,
            "mass": mass,
            "stiffness": stiffness,
            "damping_ratio": damping_ratio,
            "twist_inertia": twist_inertia,
        }
        optional = {"stiffness_z": stiffness_z, "section_modulus": section_modulus}
        quantities |= {label: value for label, value in optional.items() if value is not None}
        faults = [
            Fault(label, repr(value), "a Parameter, or an expression of them")
            for label, value in quantities.items()
            if not is_number(value)
        ]
        refuse(f"joint {name}", [*faults, *_shape_faults(modes, ends, cubics, stations)])
        across = sp.sympify(mass) * sp.sympify(length) ** 2 / 12
        start = Body(f"{name}_start", mass, (twist_inertia, across, across), (sp.sympify(length) / 2, 0, 0))
        super().__init__(
            name, start, Body(f"{name}_end", 0), length=length, mass=mass, stiffness=stiffness, stiffness_z=stiffness_z,
            modes=modes, ends=ends, cubics=cubics, damping_ratio=damping_ratio, section_modulus=section_modulus, stations=stations,
        )  # fmt: skip

    @property
    def start(self) -> Body:
        """Section at x = 0, in whose frame the undeformed rod lies along X."""
        return self.parent.body  # type: ignore[return-value]

    @property
    def end(self) -> Body:
        """Section at x = length, whose frame is parallel to that of the start while the rod is straight."""
        return self.child.body  # type: ignore[return-value]

    @property
    def shapes(self) -> BendingShapes:
        """Shapes, the same in both directions."""
        return bending_shapes(self.ends, self.modes, self.cubics)

    @property
    def stiffnesses(self) -> tuple[Any, ...]:
        """Bending stiffness of each direction: Y, then Z [N m^2]."""
        return tuple(sp.sympify(value) for value in (self.stiffness, self.stiffness_z) if value is not None)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """One with a coordinate for each shape, in Y and then in Z."""
        count = self.modes + 2 * self.cubics
        names = [f"{self.name}.bend_{z}{i}" for z in ("", "z_")[: len(self.stiffnesses)] for i in range(1, count + 1)]
        ports = [
            tuple(Port(f"{name}{end}", unit) for name in names)
            for end, unit in (("", "m"), ("_speed", "m/s"), ("", "N"))
        ]
        return (Freedom("bend", f"{self.name}.bending", Z if self.stiffness_z is None else None, *ports),)

    def slots(self) -> Iterator[Slot]:
        """Yield its quantities; the mass is that of its start."""
        where = f"joint {self.name}"
        yield Slot(f"{where}, length", self.length, "m", POSITIVE)
        for label, value in zip(("stiffness", "stiffness z"), self.stiffnesses, strict=False):
            yield Slot(f"{where}, {label}", value, "N m^2", POSITIVE)
        yield Slot(f"{where}, damping ratio", self.damping_ratio, "1", NOT_NEGATIVE)
        if self.section_modulus is not None:
            yield Slot(f"{where}, section modulus", self.section_modulus, "m^3", POSITIVE)

    def constraints(self) -> tuple[Condition, ...]:
        """None: it carries its end; raises InputError where it would close a loop."""
        fault = Fault(f"joint {self.name}", "a flexible rod whose end another joint carries", "a rod that carries its end",
                      "Declare the rod before the joint at its end; that joint then closes the loop.")  # fmt: skip
        raise InputError(f"joint {self.name}", [fault])

    def measures(self, freedom: Freedom) -> bool:
        """Return False: bodies do not determine the shapes."""
        return False

    def faults(self) -> Iterator[Fault]:
        """Yield no fault: the constructor has refused them."""
        return iter(())

    @property
    def sections(self) -> tuple[tuple[int, Body], ...]:
        """Percentages of the length, and names of frames there, by which a picture shows the bent rod."""
        return tuple((at, Body(f"{self.name}_{at}", 0)) for at in SECTIONS)

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield both ends and the sections between with the direction of the rod."""
        for place, body in (
            ("parent", self.start),
            *((f"at_{at}", body) for at, body in self.sections),
            ("child", self.end),
        ):
            yield place, Point(body), {"along": AXES[0].unit}


def _shape_faults(modes: Any, ends: Any, cubics: Any, stations: Any) -> Iterator[Fault]:
    """Faults of the number and kind of shapes, and of stations."""
    least = 0 if cubics is True else 1
    whole = isinstance(stations, tuple) and all(isinstance(at, int) and 0 <= at <= 100 for at in stations)
    counted = isinstance(modes, int) and not isinstance(modes, bool) and least <= modes <= MOST
    known = isinstance(ends, tuple) and len(ends) == 2 and all(end in ENDS for end in ends)
    yield from faults_if(
        (not isinstance(cubics, bool), Fault("cubics", repr(cubics), "True or False")),
        (not counted, Fault("modes", repr(modes), f"a number of modes from {least} to {MOST}")),
        (not known, Fault("ends", repr(ends), f"conditions of both ends, each {', '.join(ENDS[:-1])} or {ENDS[-1]}",
                          'Such as ("clamped", "free").')),
        (not whole or len({*stations}) < len(stations),
         Fault("stations", repr(stations), "different whole percentages of the length, from 0 to 100", "Such as (0, 50, 100).")),
    )  # fmt: skip
