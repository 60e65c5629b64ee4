"""The derivation in stages: scene -> checked scene -> system -> program -> audited program -> text.

`generate` and `derive` are its stages one after another; the rest gives intermediate results. A `Scene` raises
InputError for unsound declarations when it is made.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from hertzwerk.derive.audit.admissibility import refuse_misbehaving
from hertzwerk.derive.audit.audit import (
    Finding,
    Findings,
    advice_findings,
    audit_laws,
    audit_program,
    refuse_inconsistent,
)
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.declare.scene.scene import Scene, require_scene
from hertzwerk.derive.equations.equal_parts.equal_declarations import Alike, alike
from hertzwerk.derive.equations.equal_parts.representatives import program_of_kinds
from hertzwerk.derive.equations.inverse_dynamics.derived_histories import Readings
from hertzwerk.derive.equations.module.contents import program_of
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.motion_functions import motion
from hertzwerk.derive.equations.motion.absolute_coordinates import absolute
from hertzwerk.derive.program.emit.cost import operations_per_step
from hertzwerk.derive.program.emit.module_text import emit
from hertzwerk.derive.program.program import Program


def generate(scene: Scene, source: str = "", coordinates: str | None = None) -> str:
    """Text of the generated CasADi module of a scene; raises InputError as `derive` does.

    source         the file of the scene, as the header states it
    coordinates    those of `scene`, where the file's scene has others
    """
    require_scene(scene)
    grouping = alike(scene)
    program = (grouping and _derive_alike(grouping)) or derive(scene)  # 1 to 4
    return emit(program, source, coordinates)  # 5. text


def derive(scene: Scene) -> Program:
    """Derived equations of a scene, as a program of assignments with units.

    Raises InputError, listing every fault, unless each assignment and output has consistent units and its laws are
    physically admissible (`behaviour`).
    """
    # 1. checked scene: units of its laws, then their physical admissibility
    refuse_inconsistent(scene, audit_laws(scene))
    refuse_misbehaving(scene)
    # 2. system: kinematics, equations, pairs and effects; 3. program: the functions and tables of a module
    program = derivation_of(scene)
    # 4. audited program: units of every assignment and output
    units, findings = audit_program(program)
    refuse_inconsistent(scene, findings)
    return replace(program, units=units)


def _derive_alike(grouping: Alike) -> Program | None:
    """Program of a scene of kinds, each derived and audited once; None where one depends on others."""
    refuse_inconsistent(grouping.sample, audit_laws(grouping.sample))
    refuse_misbehaving(grouping.sample)
    program = program_of_kinds(grouping)
    if program is None:
        return None
    units, findings = audit_program(program)
    refuse_inconsistent(grouping.sample, findings)
    return replace(program, units=units)


def generate_readings(scene: Scene, source: str = "") -> str:
    """Text of the module of a scene's readings, in joint coordinates or absolute ones; raises InputError."""
    program = Readings(absolute(scene) if scene.coordinates == "absolute" else scene).program()
    units, findings = audit_program(program)
    refuse_inconsistent(scene, findings)
    return emit(replace(program, units=units), source)


def audit_scene(scene: Scene) -> Findings:
    """Audit every law of the scene, then, if all hold, every assignment and output of its program.

    Includes advice on the laws. Raises InputError where units are consistent, and a law is not physically admissible
    (`behaviour`).
    """
    laws = Findings((*audit_laws(scene), *_contradictions(scene), *advice_findings(scene)))
    if any(finding.verdict == "inconsistent" for finding in laws):
        return laws
    refuse_misbehaving(scene)
    return Findings((*laws, *audit_program(derivation_of(scene))[1]))


def _contradictions(scene: Scene) -> Iterator[Finding]:
    """Yield findings of velocities that are taken as given, against the model's positions."""
    for where, was_set, follows in scene.mechanism.contradictions:
        yield Finding(
            scene.name, where, "", "kinematics, as given", "", "unchecked", where, found=was_set, expected=follows,
            reason="It is taken as it was set", kind="kinematics",
        )  # fmt: skip


def derivation_of(scene: Scene) -> Program:
    """Program in the scene's coordinates, not yet audited."""
    return _choose_coordinates(scene)[1]


def program_with_motion(scene: Scene) -> Program:
    """Program with the additional function `motion`, the equations of motion before they are solved.

    It is not audited.
    """
    system, program = _choose_coordinates(scene)
    return replace(program, functions=(*program.functions, motion(system)))


def _choose_coordinates(scene: Scene) -> tuple[System, Program]:
    """System and program in the scene's coordinates.

    "auto" takes those with fewer operations per step, joint coordinates in case of a tie.
    """
    if scene.coordinates == "absolute":
        return _with_program(System(absolute(scene)))
    by_joints, tree = _with_program(System(scene))
    if scene.coordinates == "tree":
        return by_joints, tree
    try:
        by_bodies, other = _with_program(System(absolute(scene)))
    except InputError as error:
        return by_joints, replace(tree, note=f"of the joints; the bodies' own cannot be had: {error.faults[0].where}")
    here, there = operations_per_step(tree), operations_per_step(other)
    both = f"{here} operations a step by those of the joints, {there} by the bodies' own"
    if there < here:
        return by_bodies, replace(other, note=f"absolute, as the cheaper: {both}")
    return by_joints, replace(tree, note=f"of the joints, as the cheaper: {both}")


def _with_program(system: System) -> tuple[System, Program]:
    return system, program_of(system)
