"""Scene: a mechanism, the effects it is simulated with, each with its law, and its start.

Effects that are not declared do not exist downstream.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any, Literal, TypeVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse, shown, unknown
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.common.identifiers import repeated
from hertzwerk.derive.common.markup import Markup, heading, joined, titled
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.drives import AnyDrive
from hertzwerk.derive.declare.effects.effect import Effect, PairEffect, State
from hertzwerk.derive.declare.effects.elasticity.rod_elasticity import RodElasticity
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.state_expression import Input, inputs_in
from hertzwerk.derive.declare.effects.tracking import AddedCount, Junctions, uncounted_angles
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import PairResistance
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame
from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.mechanism.outline import Outline
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.declare.scene.checks.check import faults_of
from hertzwerk.derive.declare.scene.scales import Scales
from hertzwerk.derive.declare.scene.start import Start
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import (
    POSITIVE,
    Parameter,
    Slot,
    default_value,
    dimensions_of,
    is_number,
    parameters_of,
)
from hertzwerk.derive.laws.catalogue import LAWS
from hertzwerk.derive.laws.law import BoundLaw, Law
from hertzwerk.derive.laws.law_call import bound_law, split_call, split_laws

E = TypeVar("E", bound=Effect)


@dataclass(frozen=True)
class Scene:
    """A mechanism with its effects. Raises InputError, listing every fault, for unsound declarations.

    coordinates  "tree": of the joints that carry a body; "absolute": of every body, all joints are constraints;
                 "auto": whichever takes fewer operations

    `without`, `replace`, `with_law`, `named` and `with_coordinates` give new scenes; nothing is mutated. An effect at a
    pair of several parts stands here once for each; its name as declared stands for all of them.
    """

    mechanism: Mechanism
    effects: tuple[Effect, ...]
    scales: Scales
    start: Start = field(default_factory=Start)
    name: str = ""
    summary: str = ""
    coordinates: Literal["tree", "absolute", "auto"] = "tree"

    def __post_init__(self) -> None:
        if isinstance(self.effects, list | tuple):
            declared = (effect for effect in self.effects if not isinstance(effect, AddedCount))
            object.__setattr__(self, "effects", tuple(declared))
        if isinstance(self.effects, tuple) and isinstance(self.mechanism, Mechanism) and self.mechanism.parts:
            object.__setattr__(self, "effects", tuple(self._at_parts()))
        if isinstance(self.effects, tuple) and isinstance(self.mechanism, Mechanism):
            object.__setattr__(self, "effects", (*self.effects, *self._junctions(), *self._rods()))
        if isinstance(self.name, str) and not self.name:
            object.__setattr__(self, "name", getattr(self.mechanism, "name", "scene"))
        faults = faults_of(self)
        refuse(f"scene {self.name}", faults)
        counts = tuple(uncounted_angles(self.mechanism, self.effects, self))
        if counts:
            object.__setattr__(self, "effects", (*self.effects, *counts))
            for name in self.__dict__.keys() - {entry.name for entry in fields(self)}:
                del self.__dict__[name]  # while there were no counts
            faults = tuple(repeated("effect", [effect.name for effect in self.effects]))
        refuse(f"scene {self.name}", faults)

    def _repr_html_(self) -> str:
        return scene_html(self)

    def _at_parts(self) -> Iterator[Any]:
        """Yield the effects, those at a pair of several parts at each that has none of its own."""
        parts = self.mechanism.parts
        own = {(effect.kind, effect.pair) for effect in self.effects if isinstance(effect, PairEffect)}
        for effect in self.effects:
            if isinstance(effect, PairEffect) and effect.pair in parts:
                yield from effect.at_parts([part for part in parts[effect.pair] if (effect.kind, part) not in own])
            else:
                yield effect

    def _junctions(self) -> Iterator[Junctions]:
        """Yield the events of tracks of several pieces, which steps do not pass over."""
        known = [effect.name for effect in self.effects if isinstance(effect, Effect)]
        for joint in self.mechanism.joints if isinstance(self.mechanism.joints, tuple) else ():
            for curve in joint.curves if isinstance(joint, Joint) else ():
                name = f"{joint.name}_junctions"
                if (
                    isinstance(curve, Outline)
                    and isinstance(curve.pieces, tuple)
                    and len(curve.pieces) > 1
                    and name not in known
                ):
                    yield Junctions(name, joint.name, len(curve.pieces), curve.closed)

    def _rods(self) -> Iterator[RodElasticity]:
        """Yield the elasticity of each flexible rod."""
        known = [effect.name for effect in self.effects if isinstance(effect, Effect)]
        for joint in self.mechanism.joints if isinstance(self.mechanism.joints, tuple) else ():
            name = f"{getattr(joint, 'name', '')}_elasticity"
            if isinstance(joint, FlexibleRod) and name not in known:
                yield RodElasticity(name, joint)

    # -- variations ------------------------------------------------------------------------------------------------

    def without(self, *names: str) -> Scene:
        """The scene without these effects; raises InputError for an unknown name."""
        self._must_exist(names)
        meant = [each for name in names for each in self.meant(name)]
        return replace(self, effects=tuple(effect for effect in self.effects if effect.name not in meant))

    def replace(self, **effects: Effect) -> Scene:
        """The scene with these effects replaced, by name."""
        self._must_exist(effects)
        firsts = {self.meant(name)[0]: effect for name, effect in effects.items()}
        others = [each for name in effects for each in self.meant(name)[1:]]
        left = (effect for effect in self.effects if effect.name not in others)
        return replace(self, effects=tuple(firsts.get(effect.name, effect) for effect in left))

    def named(self, name: str, summary: str = "") -> Scene:
        """The scene under another name."""
        return replace(self, name=name, summary=summary or self.summary)

    def with_coordinates(self, coordinates: str) -> Scene:
        """The scene in other coordinates; raises InputError for an unknown kind of coordinates."""
        return replace(self, coordinates=coordinates)  # type: ignore[arg-type]  # which the new scene checks

    def with_law(self, effect_name: str, law_name: str, known: Mapping[str, Law] = LAWS) -> Scene:
        """The scene with other laws of an effect, named as in `power(n=1.5) x flores`.

        Parameters shared by name keep their values; others are given with the law, as quantities or as names of
        parameters of the scene: `power_damping(chi=1e5 N s/m^2.5, m=1.5)`. `known` has the laws by name. Raises
        InputError with every fault.
        """
        self._must_exist((effect_name,))
        meant = self.meant(effect_name)
        effect = self.effect(meant[0])
        if not isinstance(law_name, str):
            raise InputError(
                f"scene {self.name}", [Fault(f"effect {effect_name}", f"law {law_name!r:.80}", "the name of a law")]
            )
        fields = {kind: name for name, kind in effect.takes.items()}
        replacements: dict[str, BoundLaw] = {}
        faults: list[Fault] = []
        for text in split_laws(law_name):
            with noted(faults):
                slot, law = self._law_for(effect_name, fields, text, known)
                if slot in replacements:
                    actual = f"{replacements[slot].law.name} and {law.law.name}"
                    faults.append(Fault(f"effect {effect_name}", actual, f"one {law.law.kind} law"))
                replacements[slot] = law
        refuse(f"scene {self.name}", faults)
        return self.replace(**{name: replace(self.effect(name), **replacements) for name in meant})

    def _law_for(
        self, effect_name: str, fields: Mapping[str, str], text: str, known: Mapping[str, Law]
    ) -> tuple[str, BoundLaw]:
        """Field of an effect and the law that a text puts there; raises InputError."""
        name, texts = split_call(text)
        law = known.get(name)
        if law is None or law.kind not in fields:
            offer = [offered for offered, other in known.items() if other.kind in fields]
            wanted = unknown(f"{' or '.join(fields) or 'fitting'} law", name, offer)
            expected = wanted.expected if offer else "an effect that has a law"
            raise InputError(name, [Fault(f"effect {effect_name}", f"law {name!r}", expected, wanted.remedy)])
        slot = fields[law.kind]
        bound: BoundLaw | None = getattr(self.effect(self.meant(effect_name)[0]), slot)
        shared = {symbol.name: value for symbol, value in bound.binding.items()} if bound is not None else {}
        other = bound_law(law, texts, shared, effect_name, self.parameters)
        materials = bound.materials if bound is not None else ()
        # their density limits the speed of impacts
        matching = tuple(m for m in materials if m.youngs_modulus in other.values)
        return slot, replace(other, materials=matching)

    def _must_exist(self, names: Any) -> None:
        known = [effect.name for effect in self.effects]
        refuse(
            f"scene {self.name}",
            [unknown("effect", name, known) for name in names if not (isinstance(name, str) and self.meant(name))],
        )

    def meant(self, name: str) -> list[str]:
        """Names of the effects of a name: the effect itself, or the effects at each part of a pair."""
        endings = {part: part.removeprefix(whole) for whole, parts in self.mechanism.parts.items() for part in parts}
        return [
            effect.name
            for effect in self.effects
            if effect.name == name
            or (
                isinstance(effect, PairEffect) and effect.pair in endings and effect.name == name + endings[effect.pair]
            )
        ]

    # -- looking things up -----------------------------------------------------------------------------------------

    def effect(self, name: str) -> Any:
        """The effect of this name."""
        return next(effect for effect in self.effects if effect.name == name)

    def all(self, kind: type[E]) -> list[E]:
        """Effects of one class, in declared order."""
        return [effect for effect in self.effects if isinstance(effect, kind)]

    @cached_property
    def ledger(self) -> EnergyLedger | None:
        """Whether the scene has an energy ledger."""
        return next(iter(self.all(EnergyLedger)), None)

    @cached_property
    def driven(self) -> dict[str, AnyDrive]:
        """Drives by the key of the freedom they drive."""
        return {effect.joint: effect for effect in self.all(AnyDrive)}

    @cached_property
    def scalars(self) -> dict[str, Freedom]:
        """Freedoms with one coordinate, by their keys: of the tree, and those of closing joints."""
        return {
            freedom.key: freedom
            for freedom in (*self.mechanism.freedoms, *self.mechanism.dependent_freedoms)
            if freedom.scalar
        }

    @property
    def uncounted(self) -> tuple[str, ...]:
        """Keys of speeds without a coordinate."""
        return self.mechanism.uncounted

    @cached_property
    def states(self) -> dict[str, State]:
        """States of the effects by their names, `motor.current`."""
        return {f"{effect.name}.{state.name}": state for effect in self._placed for state in effect.states(self)}

    def joint_of(self, key: str) -> Joint:
        """The joint as declared that has a freedom."""
        return next(joint for joint in self.mechanism.joints if key in [freedom.key for freedom in joint.freedoms])

    @cached_property
    def carrying(self) -> tuple[str, ...]:
        """Joints whose reaction can be read: those that carry their body along two directions or more."""
        return tuple(j.name for j in self.mechanism.joints if j.freedoms and len(j.sliding) < 2 and not j.bends)

    @cached_property
    def held(self) -> tuple[str, ...]:
        """Joints whose reaction an effect reads, in declared order."""
        names = {name for effect in self._placed for name in effect.reactions(self)}
        return tuple(joint.name for joint in self.mechanism.joints if joint.name in names)

    @cached_property
    def pressed(self) -> tuple[str, ...]:
        """Pairs with a contact."""
        return tuple(effect.pair for effect in self.all(Contact))

    @property
    def _placed(self) -> Iterator[Effect]:
        """Effects on joints that exist; others are a fault reported by the scene."""
        return (effect for effect in self.effects if all(key in self.scalars for key in effect.joints))

    @cached_property
    def free(self) -> tuple[Freedom, ...]:
        """Freedoms that are not driven."""
        return tuple(freedom for freedom in self.mechanism.freedoms if freedom.key not in self.driven)

    def follows_drives(self, body: Frame) -> bool:
        """Whether drives alone move a body, which then has a motion given by time; true of the ground."""
        if not self.driven:
            return body == GROUND
        bodies: list[Frame] = []
        while (joint := self.mechanism.joint_of(body)) is not None and body not in bodies:
            if any(freedom.key not in self.driven for freedom in joint.freedoms):
                return False
            bodies.append(body)
            body = joint.parent.body
        return True

    @property
    def prescribed(self) -> tuple[Freedom, ...]:
        """Driven freedoms of joints that close a loop; in joint coordinates there are none."""
        freedoms = (freedom for joint in self.mechanism.closures for freedom in joint.freedoms)
        return tuple(freedom for freedom in freedoms if freedom.key in self.driven)

    @cached_property
    def size(self) -> float:
        """Greatest length among the parameters at their defaults [m], or that of the scales."""
        metre = parse_unit("m").exponents
        lengths = [abs(p.si) for p in self.parameters.values() if p.parsed_unit.exponents == metre]
        return max(lengths) or abs(default_value(self.scales.length)) if lengths else default_value(self.scales.length)

    @cached_property
    def contacts(self) -> list[tuple[Pair, Contact, Friction | None]]:
        """Pairs with a contact, in the order of the mechanism's pairs, with their effects."""
        contacts = self._contact_at
        frictions = {effect.pair: effect for effect in self.all(Friction)}
        return [
            (pair, contacts[pair.name], frictions.get(pair.name))
            for pair in self.mechanism.pairs
            if pair.name in contacts
        ]

    @cached_property
    def _contact_at(self) -> dict[str, Contact]:
        """Contacts by pair; of two at one, which is a fault, the last."""
        return {effect.pair: effect for effect in self.all(Contact)}

    def resistances(self, pair_name: str) -> list[PairResistance]:
        """Resistances to rolling and drilling at a pair, in declared order."""
        return self._resistances.get(pair_name, [])

    @cached_property
    def _resistances(self) -> dict[str, list[PairResistance]]:
        return grouped((effect.pair, effect) for effect in self.all(PairResistance))

    def geometry(self, pair_name: str) -> dict[str, Any]:
        """Geometry of a pair by name (`R_eff`, `L`, ...) and effective mass `m_eff`; {} for an unknown pair."""
        return self._geometries.get(pair_name, {})

    @cached_property
    def _geometries(self) -> dict[str, dict[str, Any]]:
        return {pair.name: self._geometry(pair) for pair in self.mechanism.pairs}

    def _geometry(self, pair: Pair) -> dict[str, Any]:
        bodies = [place.body for place in pair.places if isinstance(place.body, Body)]
        slots = [*pair.slots(), *(slot for body in bodies for slot in body.slots())]
        if not all(is_number(slot.value) and sp.sympify(slot.value) is not sp.nan for slot in slots):
            return {}  # a fault reported by the scene
        own = self._contact_at[pair.name].effective_mass if pair.name in self._contact_at else None
        masses = [body.mass for body in bodies]
        if any(mass == 0 for mass in masses):  # the end of a flexible rod: of it no more is known
            masses = []
        both = masses[0] if len(masses) == 1 else masses[0] * masses[1] / (masses[0] + masses[1]) if masses else None
        mass = both if own is None else own
        return {**pair.geometry, **({} if mass is None else {"m_eff": mass})}

    def slots(self) -> Iterator[Slot]:
        """Yield every quantity that is used, in declared order.

        Geometry that a pair has for its laws alone is included only if a law depends on it.
        """
        return iter(self._used)

    @cached_property
    def _used(self) -> tuple[Slot, ...]:
        symbols = {
            f"{pair}.{quantity.name}"
            for effect in self.effects
            for pair in effect.pairs
            for bound in effect.laws
            for quantity in bound.law.geometry
        }
        return tuple(slot for slot in self.declarations() if not slot.law_symbol or slot.law_symbol in symbols)

    def declarations(self) -> Iterator[Slot]:
        """Yield every quantity of the scene, in declared order."""
        yield from self.mechanism.slots()
        for effect in self._placed:
            yield from effect.slots(self)
            for state in effect.states(self):
                yield Slot(f"{effect.where}, {state.name} at the start", state.start, state.unit)
                if state.size is not None:
                    yield Slot(f"{effect.where}, size of {state.name}", state.size, state.unit, POSITIVE)
        yield from self.start.slots(self.mechanism.freedoms)
        yield from self.scales.slots()

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        """Parameters in use by name, in declared order."""
        parameters: dict[str, Parameter] = {}
        for slot in self.slots():
            for parameter in parameters_of(slot.value):
                parameters.setdefault(parameter.name, parameter)
        return parameters

    @cached_property
    def dimensions(self) -> dict[sp.Symbol, Dimension]:
        """Dimension of every parameter."""
        return dimensions_of(self.parameters)

    @cached_property
    def inputs(self) -> dict[str, Input]:
        """Inputs in use by name, in declared order."""
        return {signal.name: signal for slot in self.slots() for signal in inputs_in(slot.value)}

    @cached_property
    def smooth_inputs(self) -> dict[str, tuple[int, Slot]]:
        """Inputs of which derivatives are taken: how many, and the slot that needs most."""
        inputs: dict[str, tuple[int, Slot]] = {}
        for slot in self.slots():
            derivatives = getattr(slot, "derivatives", 0)
            for signal in inputs_in(slot.value):
                if derivatives > inputs.get(signal.name, (0, slot))[0]:
                    inputs[signal.name] = derivatives, slot
        return inputs


# -- scenes as notebooks show them: bodies and joints, pairs, effects with their laws, parameters ----------------------


def scene_html(scene: Scene) -> Markup:
    """Everything that a scene declares, as tables."""
    mechanism, effects = scene.mechanism, scene.effects
    sizes = {"body": mechanism.bodies, "joint": mechanism.joints, "pair": mechanism.pairs, "effect": effects}
    plural = {"body": "bodies"}
    counts = ", ".join(
        f"{len(parts)} {kind if len(parts) == 1 else plural.get(kind, f'{kind}s')}" for kind, parts in sizes.items()
    )
    joints = [
        (joint.name, type(joint).__name__, f"{joint.parent.body.name} → {joint.child.body.name}",
         ", ".join(port.name for freedom in joint.freedoms for port in freedom.coordinates))
        for joint in mechanism.joints
    ]  # fmt: skip
    pairs = [
        (pair.name, type(pair).__name__, " and ".join(place.body.name for place in pair.places))
        for pair in mechanism.pairs
    ]
    rows = [(effect.name, effect.kind, effect.text) for effect in effects]
    values = [(p.name, f"{p.default:.6g}", p.unit, p.meaning) for p in scene.parameters.values()]
    return joined([
        heading(scene.name, scene.summary, f" ({counts})", good=True),
        titled("Joints", ("joint", "kind", "from, to", "coordinates"), joints),
        titled("Pairs", ("pair", "kind", "between"), pairs),
        titled("Effects", ("effect", "kind", "what it is"), rows),
        titled("Parameters", ("parameter", "value", "unit", "meaning"), values),
    ])  # fmt: skip


def require_scene(scene: object) -> None:
    """Raise InputError for what is no scene."""
    if not isinstance(scene, Scene):
        raise InputError("scene", [Fault("scene", shown(scene), "a Scene")])
