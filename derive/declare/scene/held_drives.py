"""Scenes for statics: drives held where they are at a time, no start in motion, contacts that load."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from hertzwerk.derive.declare.effects.contacts import Contact
from hertzwerk.derive.declare.effects.drives import Drive
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.state_expression import T
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.expressions.parameter import Parameter

HELD_TIME = "held_time"  # parameter: time at whose positions the drives are held


def with_loading_laws(scene: Scene) -> Scene:
    """Return the scene with the force of loading of elastic-plastic contacts as an elastic law."""
    dents = {contact.name: contact for contact in scene.all(Contact) if contact.plastic is not None}
    laws = {name: replace(of.stiffness, law=of.stiffness.law.loading) for name, of in dents.items()}
    loading = {name: replace(of, stiffness=laws[name], same_spot=False) for name, of in dents.items()}
    return scene.replace(**loading)


def with_drives_held(scene: Scene) -> Scene:
    """Return the scene with the time of its drives replaced by the parameter `held_time` [s].

    A drive whose speed or acceleration is given is held where it starts. A ledger is added where there is none, as it
    has the reactions of drives; the start is at rest.
    """
    time, held = Parameter(HELD_TIME, "s", 0.0, "time at whose positions the drives are held"), {}
    for drive in scene.driven.values():
        motion = drive.motion
        position = sp.sympify(motion.start[0] if motion.order else motion.law).subs(T, time)
        held[drive.name] = Drive(drive.name, drive.joint, position=position)
    ledger = () if scene.ledger else (EnergyLedger(),)
    start = replace(scene.start, speed={}, seated=False)
    return replace(scene.replace(**held), effects=(*scene.replace(**held).effects, *ledger), start=start)
