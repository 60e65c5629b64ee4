"""Program of a system: the list of a generated module's functions and tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.declare.effects.nonholonomic import RollingWithoutSlip
from hertzwerk.derive.equations.module import (
    motion_functions,
    output_functions,
    pair_functions,
    scale_functions,
)
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.module_tables import tables
from hertzwerk.derive.equations.motion.multipliers import SOFTNESS
from hertzwerk.derive.program.naming import names_in_words
from hertzwerk.derive.program.program import CONSTANT, Function, Program, Result


def program_of(system: System) -> Program:
    """Every function of the module, and its tables; raises InputError if an effect changes no motion."""
    functions = [
        motion_functions.start(system),
        *_placement(system),
        scale_functions.scales(system),
        motion_functions.coordinate_rates(system),
        pair_functions.gaps(system),
        pair_functions.gap_accelerations(system),
        *(pair_functions.contact(system, *entry) for entry in system.contacts),
        motion_functions.applied(system),
        *motion_functions.accelerations(system),
        *(
            [motion_functions.balance(system)]
            if system.loops and system.joints is not None and not (system.driven or system.carried)
            else []
        ),
        *([motion_functions.constraints(system), motion_functions.projection(system)] if system.loops else []),
        *([motion_functions.margins(system), motion_functions.jumps(system)] if system.events else []),
        *([motion_functions.ledger(system), motion_functions.energy(system)] if system.scene.ledger else []),
        output_functions.poses(system),
        output_functions.outputs(system),
        *([scale_functions.speed_limits(system)] if system.limited else []),
        *([scale_functions.yield_forces(system)] if system.yielding else []),
        *([scale_functions.rolling_limits(system)] if system.scene.all(RollingWithoutSlip) else []),
        *([scale_functions.period(system)] if system.periodic is not None else []),
        output_functions.landmarks(system),
    ]
    refuse_idle(system)
    note = "" if system.joints is None else "absolute"
    return with_constants(system, functions, tables(system), note)


def refuse_idle(system: System) -> None:
    """Raise InputError if an effect changes no motion, once all functions are made."""
    faults = []
    for effect in (effect for effect in system.scene.effects if effect.name not in system.entered):
        driven = any(key in system.scene.driven for key in effect.joints)
        why = "its joint is driven, whatever acts on it" if driven else "what it acts on cannot move that way"
        faults.append(Fault(f"effect {effect.name}", "no equation that it enters", f"an effect that changes the motion; {why}",
                            f"Turn it, or leave it out: scene.without({effect.name!r})."))  # fmt: skip
    refuse(f"scene {system.scene.name}", faults)


def with_constants(system: System, functions: list[Function], tables: Mapping[str, Any], note: str) -> Program:
    """Program of functions, with the function of the constants that they read."""
    constants = system.tape.constants(functions)
    pieces = [symbol for piece in system.tape.pieces.values() for symbol in piece]
    softness = [symbol for symbol, group in system.tape.inputs.items() if group == CONSTANT and symbol not in pieces]
    values = (*constants, *(sp.Float(SOFTNESS) for _ in softness), *(sp.S.Zero for _ in pieces))
    constants = [*constants, *softness, *pieces]
    words = names_in_words(((s, system.tape.assignments[s]) for s in system.tape.numbered), {}, system.tape.names)
    names = tuple(words.get(symbol.name, symbol.name) for symbol in constants)
    result = Result("c", names, ("",) * len(names), values)  # mixed units: see CONSTANTS; a vector is one entry here
    summary = "Quantities that depend on the parameters alone, once per run."
    if pieces:
        summary += " The pieces of INPUTS, the last entries, are those of the run: here 0."
    first = system.function("constants", summary, "p", result)
    return Program(system.scene, system.tape, (first, *functions), tuple(constants), tables, note, words)


def _placement(system: System) -> list[Function]:
    """Functions from joint coordinates to body coordinates, where the module has the latter."""
    joints = system.joints
    if joints is None:
        return []
    functions = [motion_functions.joint_scales(system, joints), motion_functions.placed_bodies(system, joints)]
    return [*functions, motion_functions.joint_constraints(system, joints)] if joints.loops else functions
