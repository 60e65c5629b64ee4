"""Contact of a pair, and its friction; their equations are in `contact`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.common.units import UnitError, split_quantity
from hertzwerk.derive.declare.effects.effect import CONTACT, Declared, Element, Event, Kinematics, PairEffect, State
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.parameter import POSITIVE, Parameter, Scalar, Slot
from hertzwerk.derive.laws.law import APPROACH_SPEED, BoundLaw, PlasticLaw, d, k_t
from hertzwerk.derive.laws.smoothing import LEAST_GROWTH, growths

APPROACH_FLOOR = Parameter(
    "approach_floor", "m/s", 1e-3, "least approach speed a damping law is given; h/v0 is unbounded otherwise"
)
GAP_CHANGE = "gap_change"
SMOOTH = "smoothing length of the contact's beginning"
STAGE, DEEPEST, DENT = "stage", "deepest", "dent"
ROUNDED = sp.Float(1e-12)
"""Part of the largest penetration beyond which it is exceeded again; at the turn itself it is reached."""


@dataclass(frozen=True)
class Contact(PairEffect):
    """Normal force of one pair: a stiffness law and optionally a damping law; named after its pair.

    `effective_mass` is for damping laws that depend on it, by default m1 m2/(m1 + m2) of the two bodies. `smooth` is a
    length, such as "1 um", over which the force begins twice continuously differentiable, as in `laws.smoothing`: for
    optimisation by second derivatives; by default it begins as the laws do.
    `unchecked=True` lets an inconsistent law run in SI values; module, solution and plots then say so.

    An elastic-plastic law leaves a dent. By default the surfaces meet elsewhere the next time: once they are as far apart as
    before the first contact, the dent is forgotten. With `same_spot=True` it is found again at every contact.
    """

    pair: str
    stiffness: BoundLaw
    damping: BoundLaw | None = None
    approach_floor: Scalar = APPROACH_FLOOR
    effective_mass: Scalar | None = None
    unchecked: bool = False
    smooth: Scalar | str | None = None
    same_spot: bool = False
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
        yield from self._plastic_faults(scene)

    @property
    def plastic(self) -> PlasticLaw | None:
        """Elastic-plastic law, if it has one."""
        law = self.stiffness.law
        return law if isinstance(law, PlasticLaw) else None

    def _plastic_faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of what does not go with an elastic-plastic law, and of a spot without one."""
        law, pair = self.plastic, scene.mechanism.pair_named.get(self.pair)
        if law is None:
            if self.same_spot:
                yield Fault(self.where, f"same_spot with {self.stiffness.law.name}, which leaves no dent", "an elastic-plastic law",
                            "laws.thornton, kogut_etsion and jackson_green leave one.")  # fmt: skip
            return
        if self.smooth is not None:
            yield Fault(self.where, f"smooth with {law.name}", "an elastic law",
                        "Its force has kinks at the largest penetration, which smoothing of the beginning leaves.")  # fmt: skip
        if pair is not None and pair.journal:
            yield Fault(self.where, f"law {law.name} at a {pair.kind} pair", "surfaces that are not conforming",
                        "Elastic-plastic laws are for spheres on spheres and planes.")  # fmt: skip
        if any(effect.kind == "wear" and self.pair in effect.pairs for effect in scene.effects):
            yield Fault(self.where, f"law {law.name} at a pair that wears", "an elastic law, or no wear",
                        "Both would change the gap, and no law states how together.")  # fmt: skip
        damping = None if self.damping is None else self.damping.law
        if damping is not None and (d in damping.quantities or k_t in damping.quantities):
            yield Fault(self.where, f"law {damping.name} beside {law.name}", "no damping, or one that is a factor of the elastic force",
                        "hunt_crossley and the other laws of hysteresis dissipate in addition to the dent.")  # fmt: skip

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the memory of an elastic-plastic law, and the change of a gap that drives alone move.

        By the latter a step notices how it moves. The stage counts the kinks of the loading force that are passed, and is
        negative while the law unloads; the largest penetration and the dent change where unloading begins.
        """
        if self.plastic is not None:
            yield State(STAGE, "1")
            yield State(DEEPEST, "m")
            yield State(DENT, "m")
        pair = scene.mechanism.pair_named.get(self.pair)
        if pair is not None and all(scene.follows_drives(place.body) for place in pair.places):
            yield State(GAP_CHANGE, "m")

    def element(self, kin: Kinematics) -> Element | None:
        """Rates and events of its states, if it has any; its forces act in contact alone."""
        names = [state.name for state in self.states(kin.scene)]
        rates = {GAP_CHANGE: kin.touch(self.pair).gap_rate} if GAP_CHANGE in names else {}
        events = () if self.plastic is None else tuple(self._turns(kin, self.plastic))
        return Element(rates=rates, events=events) if names else None

    def _turns(self, kin: Kinematics, law: PlasticLaw) -> Iterator[Event]:
        """Yield the events of an elastic-plastic law; a margin is 1 where its event is not due next."""
        touch, geometry = kin.touch(self.pair), kin.scene.geometry(self.pair)
        stage, deepest = (kin.state(f"{self.name}.{name}") for name in (STAGE, DEEPEST))
        values = self.stiffness.resolved(geometry, touch.let, {})
        depth, onset = touch.penetration, law.onset.xreplace(values)
        work = law.elastic.xreplace({**values, d: onset}) * onset
        mass = geometry.get("m_eff", 0)  # none between bodies that drives move, or without mass
        pace = touch.let(
            sp.sqrt(work / mass) if mass != 0 else kin.scene.scales.speed, "pace"
        )  # near that of first yield
        speed = kin.tape.rate(depth, f"{self.pair}_indentation_rate")
        values[d] = touch.let(Where(depth > onset, depth, onset), "yielded_depth")
        passing, unloads = sp.S.One, stage < 0
        for number, kink in reversed(list(enumerate(law.kinks, start=1))):
            passing = Where(stage < number + 1, kink.xreplace(values), passing)
        passing = Where(stage < 1, 1 - depth / onset, passing)
        reached = 1 + sp.Add(*(Where(kink.xreplace(values) < 0, 1, 0) for kink in law.kinks))
        yield Event("yields", Where(unloads, 1, passing), sp.S.One, {STAGE: Where(stage < reached, reached, stage + 1)})
        then = {STAGE: -stage, DEEPEST: depth, DENT: law.dent.xreplace(values)}
        yield Event("unloads", Where(stage > 0, speed / pace, 1), sp.S.One, then)
        ahead = (deepest * (1 + ROUNDED) - depth) / onset
        yield Event("reloads", Where(unloads, ahead, 1), sp.S.One, {STAGE: -stage})
        if not self.same_spot:
            forgotten = dict.fromkeys((STAGE, DEEPEST, DENT), sp.S.Zero)
            yield Event("parts", Where(unloads, depth / onset, 1), sp.S.One, forgotten)


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
    return [
        Fault(effect.where, f"pair {effect.pair!r} without a contact", one_of(contacts, "a pair with a Contact"),
              f"{effect.kind.replace('_', ' ').capitalize()} needs a normal force: leave it out too, or add the pair's Contact.")
    ]  # fmt: skip
