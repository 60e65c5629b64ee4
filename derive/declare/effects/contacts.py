"""Contact of a pair, and its friction; their equations are in `contact`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.common.units import UnitError, split_quantity
from hertzwerk.derive.declare.effects.effect import CONTACT, Declared, Element, Kinematics, PairEffect, State
from hertzwerk.derive.expressions.parameter import POSITIVE, Parameter, Scalar, Slot
from hertzwerk.derive.laws.law import APPROACH_SPEED, BoundLaw
from hertzwerk.derive.laws.smoothing import LEAST_GROWTH, growths

APPROACH_FLOOR = Parameter(
    "approach_floor", "m/s", 1e-3, "least approach speed a damping law is given; h/v0 is unbounded otherwise"
)
GAP_CHANGE = "gap_change"
SMOOTH = "smoothing length of the contact's beginning"


@dataclass(frozen=True)
class Contact(PairEffect):
    """Normal force of one pair: a stiffness law and optionally a damping law; named after its pair.

    `effective_mass` is for damping laws that depend on it, by default m1 m2/(m1 + m2) of the two bodies. `smooth` is a
    length, such as "1 um", over which the force begins twice continuously differentiable, as in `laws.smoothing`: for
    optimisation by second derivatives; by default it begins as the laws do.
    `unchecked=True` lets an inconsistent law run in SI values; module, solution and plots then say so.
    """

    pair: str
    stiffness: BoundLaw
    damping: BoundLaw | None = None
    approach_floor: Scalar = APPROACH_FLOOR
    effective_mass: Scalar | None = None
    unchecked: bool = False
    smooth: Scalar | str | None = None
    kind: ClassVar[str] = "contact"
    takes: ClassVar[Mapping[str, str]] = {"stiffness": "stiffness", "damping": "damping"}
    enters: ClassVar[str] = CONTACT
    measures: ClassVar[Mapping[str, Slot]] = {
        "effective_mass": Slot.of("kg", POSITIVE),
        "approach_floor": Slot.of("m/s", POSITIVE),
        "smooth": Slot.of("m", POSITIVE),
    }

    def __post_init__(self) -> None:
        """Declare a smoothing length given as text as a parameter, `<pair>_smooth`."""
        if isinstance(self.smooth, str):
            try:
                value, unit = split_quantity(self.smooth)
            except UnitError:
                return  # told with the scene's other faults
            object.__setattr__(self, "smooth", Parameter(f"{self.pair}_smooth", unit, value, SMOOTH))

    @property
    def name(self) -> str:  # type: ignore[override]  # read-only, as the field of a frozen dataclass
        """Name of the pair."""
        return self.pair

    @property
    def length(self) -> Any:
        """Smoothing length [m], an expression of parameters; None for laws that begin as they are."""
        return self.smooth

    @property
    def latches(self) -> bool:
        """Whether the approach speed is latched."""
        return self.damping is not None and APPROACH_SPEED in self.damping.law.memory

    @property
    def text(self) -> str:
        """Description for people."""
        rebuilt = [bound.law.name for bound in self.laws if bound.law.grade == "R"]
        label = f", {' and '.join(rebuilt)} a reconstruction (grade R)" if rebuilt else ""
        smooth = "" if self.smooth is None else ", smooth"
        return (
            " x ".join(bound.law.name for bound in self.laws)
            + smooth
            + label
            + (", UNCHECKED" if self.unchecked else "")
        )

    @property
    def used(self) -> Mapping[str, Slot]:
        """Its `measures`; without a law that latches the approach speed its floor is unused."""
        return {name: slot for name, slot in self.measures.items() if self.latches or name != "approach_floor"}

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a smoothing length with a law that begins too steeply for it."""
        yield from super().faults(scene)
        if self.smooth is not None:
            yield from (
                Fault(self.where, f"smooth with {law.name}, which begins like d^{growth:.3g}", "a force that begins like d^n, n > 2/3",
                      "Damping that is a factor of the elastic force, as of hunt_crossley or flores, begins as that does.")
                for law, growth in growths(self.stiffness, self.damping)
                if not growth > LEAST_GROWTH
            )  # fmt: skip

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the change of a gap that drives alone move, by which a step notices how it moves."""
        pair = scene.mechanism.pair_named.get(self.pair)
        if pair is not None and all(scene.follows_drives(place.body) for place in pair.places):
            yield State(GAP_CHANGE, "m")

    def element(self, kin: Kinematics) -> Element | None:
        """The rate of its state, if it has one; its forces act in contact alone."""
        states = list(self.states(kin.scene))
        return Element(rates={GAP_CHANGE: kin.touch(self.pair).gap_rate}) if states else None


@dataclass(frozen=True)
class Friction(PairEffect):
    """Friction of one pair, in addition to its normal force."""

    name: str
    pair: str
    law: BoundLaw
    unchecked: bool = False
    kind: ClassVar[str] = "friction"
    takes: ClassVar[Mapping[str, str]] = {"law": "friction"}
    enters: ClassVar[str] = CONTACT

    @property
    def text(self) -> str:
        """Description for people."""
        return f"{self.law.law.name} at {self.pair}" + (", UNCHECKED" if self.unchecked else "")

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair without a contact."""
        yield from contact_faults(self, scene) or super().faults(scene)


def contact_faults(effect: PairEffect, scene: Declared) -> list[Fault]:
    """Fault of an effect that needs a normal force, at a pair without a contact."""
    contacts = [other.pair for other in scene.effects if isinstance(other, Contact)]
    if effect.pair in contacts:
        return []
    way_out = f"{effect.kind.replace('_', ' ').capitalize()} needs a normal force: leave it out too, or add the pair's Contact."
    return [
        Fault(
            effect.where,
            f"pair {effect.pair!r} without a contact",
            one_of(contacts, "a pair with a Contact"),
            way_out,
        )
    ]
