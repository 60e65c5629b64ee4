"""System of a scene: kinematics, equations, pairs and force elements, and rows of its vectors.

The functions of a module are made from it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.declare.effects.effect import CONTACT, DISSIPATED, NOWHERE, Event, Rubbing, state_faults
from hertzwerk.derive.declare.effects.tribology.wear import Wear
from hertzwerk.derive.declare.scene.periods import period
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.contact.contact_forces import PairKinematics
from hertzwerk.derive.equations.module.effect_kinematics import Surroundings
from hertzwerk.derive.equations.module.labelled_results import ports_of, vector
from hertzwerk.derive.equations.module.landmarks import Landmark, landmarks_of
from hertzwerk.derive.equations.motion.absolute_coordinates import Absolute
from hertzwerk.derive.equations.motion.constraints import constraints_of
from hertzwerk.derive.equations.motion.equations_of_motion import equations_of
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.equations.motion.massless_motions import resistance_faults
from hertzwerk.derive.equations.motion.reaction_loads import Carried
from hertzwerk.derive.equations.motion.spanning_tree import Row
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.laws.elastic_limits import onset_of_yield, speed_limit
from hertzwerk.derive.program.program import Function, Result, Tape


class Joints:
    """Kinematics of the declared scene in joint coordinates, on the tape of the absolute one."""

    def __init__(self, tape: Tape, absolute: Absolute) -> None:
        self.absolute = absolute
        self.scene = absolute.declared
        self.kin = Kinematics(tape, self.scene, ("joints", "joint_speeds", "joint_accelerations"))
        self.coordinates, self.speeds = ports_of(self.scene, self.kin)

    @cached_property
    def loops(self) -> tuple[Constraint, ...]:
        """Constraints of the declared scene: of loops and couplings."""
        return constraints_of(self.kin)


class System:
    """One scene on one tape, from which the functions of a module are made."""

    def __init__(self, scene: Scene, kinematics: type[Surroundings] = Surroundings, whole: Scene | None = None) -> None:
        self.scene = scene
        self.tape = Tape()
        for parameter, dimension in (
            whole or scene
        ).dimensions.items():  # of the scene that it is a part of, if it is one
            self.tape.input(parameter.name, "p", dimension, symbol=parameter)
        self.kin = kinematics(self.tape, scene)
        self.coordinates, self.speeds = ports_of(scene, self.kin)
        self.equations = equations_of(self.kin, scene)
        self.contacts = [
            (PairKinematics(self.kin, pair, scene.geometry(pair.name)), contact, friction)
            for pair, contact, friction in scene.contacts
        ]
        self.driven = [*self.equations.driven, *self.equations.prescribed] if scene.ledger else []
        self.supplied = [
            self.tape.input(f"{row.key.replace('.', '_')}_reaction_in", "reactions", Dimension.from_unit(row.unit))
            for row in self.driven
        ]
        elements = {effect: effect.element(self.kin) for effect in scene.effects}
        self.elements = {effect: e for effect, e in elements.items() if e is not None}
        rows = list(self.equations.free)
        if scene.ledger:
            rows += self.equations.driven
        rows += self.equations.held
        self.pressed = {
            symbol: Row(f"{pair}.normal_force", "N", sp.S.Zero, sp.S.Zero, False)
            for pair, symbol in self.kin.normal_forces.items()
        }
        for effect, (coefficient, holding) in self.kin.rubbing.items():
            self.pressed[coefficient] = Row(f"{effect}.coefficient", "1", sp.S.Zero, sp.S.Zero, False)
            self.pressed[holding] = Row(f"{effect}.holding", "N", sp.S.Zero, sp.S.Zero, False)
        units = {"m": "m/s", "N m": "W"}
        self.worn = [
            Row(name, units[state.unit], sp.S.Zero, sp.S.Zero, False)
            for name, state in scene.states.items()
            if isinstance(scene.effect(name.split(".")[0]), Wear)
        ]
        self.rows = [*rows, *self.pressed.values(), *self.worn]
        self.row_units = tuple(row.unit for row in self.rows)
        self.loops = self.equations.constraints
        faults = [fault for pair, _, friction in self.contacts for fault in pair.faults(friction, scene.size)]
        faults += resistance_faults(scene)
        faults += self._sticking_faults()
        faults += [fault for effect, e in self.elements.items() for fault in state_faults(effect, e, scene)]
        refuse(f"scene {scene.name}", faults)
        self.bristles = {
            friction.name: {
                name: self.tape.input(name.replace(".", "_"), "z", Dimension.from_unit("m"))
                for name in (f"{friction.name}.bristle{axis and '_'}{axis}" for axis in pair.bristle_axes)
            }
            for pair, _, friction in self.contacts
            if friction is not None and friction.law.law.memory
        }
        self.memory = self._memory()
        self.latches = {
            contact.name: self.tape.input(f"{contact.name}_approach_speed", "m", Dimension.from_unit("m/s"))
            for _, contact, _ in self.contacts
            if contact.latches
        }
        # effects with a term in an equation of motion, noted by `enter`; drives and ledgers need none
        self.entered = {effect.name for effect in scene.effects if effect.enters == NOWHERE}
        self.joints = Joints(self.tape, scene) if isinstance(scene, Absolute) else None

    def _sticking_faults(self) -> Iterator[Fault]:
        """Faults of contacts that stick in several directions beside loads by reactions.

        They are solved together: friction changes its own accelerations through the loads. In one direction for each, what a run computes has a
        certificate that nothing else agrees (runtime.engine.integration.step.fed_friction); for discs of forces there is none.
        """
        if not self.feeds:
            return
        beside = "set-valued, in several directions beside loads by reactions"
        for pair, _, friction in self.contacts:
            if friction is not None and friction.law.law.modes and pair.slides_along > 1:
                yield Fault(f"effect {friction.name}", f"law {friction.law.law.name}, {beside}",
                            "a law of the sliding velocity", "smooth_coulomb is one; or declare the loads otherwise.")  # fmt: skip
            for effect in self.scene.resistances(pair.pair.name):
                if effect.has_modes and len(effect.axes(pair.touch)) > 1:
                    yield Fault(f"effect {effect.name}", f"{effect.text}, {beside}",
                                "a smoothed one", "Give it a speed; or declare the loads otherwise.")  # fmt: skip

    @property
    def feeds(self) -> bool:
        """Whether set-valued friction is a joint's, or stands beside loads by reactions, which it changes."""
        sticks = any(friction is not None and friction.law.law.modes for _, _, friction in self.contacts) or any(
            effect.has_modes for pair, *_ in self.contacts for effect in self.scene.resistances(pair.pair.name)
        )
        return bool(self.kin.rubbing or (sticks and self.kin.carried))

    @property
    def rubbing(self) -> list[tuple[str, Rubbing]]:
        """Set-valued frictions of joints, by effect."""
        return [(effect.name, e.rubbing) for effect, e in self.elements.items() if e.rubbing is not None]

    def _memory(self) -> list[tuple[str, str]]:
        """Entries of z as (name, unit); those that functions read come first, in the order of the inputs."""
        bristles = [(name, "m") for entries in self.bristles.values() for name in entries]
        ledger = self.scene.ledger
        if ledger is None:
            return bristles
        drives = [(f"{ledger.name}.input", "J")] if self.driven else []
        rows = {effect: e.powers for effect, e in self.elements.items()}
        rows |= {effect: {DISSIPATED: None} for effect in self.scene.effects if effect.enters == CONTACT}
        booked = [(f"{e.name}.{quantity}", "J") for e in self.scene.effects for quantity in rows.get(e, ())]
        return bristles + drives + booked

    @cached_property
    def carried(self) -> Carried | None:
        """Loads by reactions and normal forces, if any; raises InputError for one that is not linear."""
        if not self.kin.loaded:
            return None
        carried = Carried(
            self.kin,
            self.equations,
            {row.key: load for row in self.rows if (load := self.force(row.key, carried=True)) != 0},
        )
        carried.require_linear()
        return carried

    def force(self, key: str, *, carried: bool) -> Any:
        """Generalised force of effects in a row: carried by reactions and contacts, or by others."""
        forces = (sp.sympify(e.forces.get(key, 0)) for e in self.elements.values())
        return sp.Add(*(force for force in forces if self.tape.depends_on(force, "reactions") == carried))

    @cached_property
    def events(self) -> list[tuple[str, Event]]:
        """Events of the effects, with the effects' names."""
        return [(effect.name, event) for effect, e in self.elements.items() for event in e.events]

    @cached_property
    def limited(self) -> dict[str, Any]:
        """Pair -> approach speed up to which its law holds, where a density is known."""
        elastic = (contact for _, contact, _ in self.contacts if contact.plastic is None)
        limits = {contact.name: speed_limit(contact.laws) for contact in elastic}
        return {name: limit for name, limit in limits.items() if limit is not None}

    @cached_property
    def yielding(self) -> dict[str, Any]:
        """Pair -> normal force at which it begins to yield, 0 where that is not known; empty where none is."""
        forces = {c.name: onset_of_yield(c.stiffness, self.scene.geometry(c.name)) for _, c, _ in self.contacts}
        if all(force is None for force in forces.values()):
            return {}
        return {name: sp.S.Zero if force is None else force for name, force in forces.items()}

    @cached_property
    def periodic(self) -> Any | None:
        """Common period of everything that depends on time [s], else None."""
        return period(self.scene)

    @cached_property
    def landmarks(self) -> tuple[Landmark, ...]:
        """Landmarks of the scene as declared, without joints that only absolute coordinates add."""
        return tuple(landmarks_of(self.scene if self.joints is None else self.joints.scene))

    def enter(self, effect: str, forces: Mapping[str, Any], driven: bool = False) -> None:
        """Note an effect that has a generalised force in some row, or also on what is driven."""
        rows = forces if driven else [row.key for row in self.rows]
        if any(forces.get(key, 0) != 0 for key in rows):
            self.entered.add(effect)

    # -- functions and their results --------------------------------------------------------------------------------

    def function(self, name: str, summary: str, arguments: str, *results: Result) -> Function:
        """Slice of the tape for the results; `arguments` are groups separated by blanks."""
        return self.tape.function(name, summary, tuple(arguments.split()), results)

    def of_coordinates(self, name: str, values: list[Any]) -> Result:
        """Result with one entry per coordinate."""
        return vector(name, self.coordinates, values)

    def of_speeds(self, name: str, values: list[Any]) -> Result:
        """Result with one entry per speed."""
        return vector(name, self.speeds, values)

    def of_rows(self, name: str, values: list[Any]) -> Result:
        """Result with one generalised force per row of the equations of motion."""
        return Result(name, tuple(row.key for row in self.rows), self.row_units, tuple(values))

    def of_pairs(self, name: str, unit: str, values: list[Any]) -> Result:
        """Result with one entry per pair, all of one unit."""
        names = tuple(pair.pair.name for pair, _, _ in self.contacts)
        return Result(name, names, (unit,) * len(names), tuple(values))

    def memory_rates(self, values: list[Any]) -> Result:
        """Rates of the entries of z."""
        units = {"J": "W", "m": "m/s"}
        names, rates = tuple(n for n, _ in self.memory), tuple(units[unit] for _, unit in self.memory)
        return Result("dz", names, rates, tuple(values))
