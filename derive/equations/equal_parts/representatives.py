"""Program of a scene of kinds: the functions of one tree and one pair of each, and the tables of all."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import Any

from hertzwerk.derive.declare.effects.effect import CONTACT, DISSIPATED
from hertzwerk.derive.equations.contact.contact_forces import PairKinematics
from hertzwerk.derive.equations.equal_parts.equal_declarations import Alike, Kind, Meeting, Tree
from hertzwerk.derive.equations.module import motion_functions, output_functions, scale_functions
from hertzwerk.derive.equations.module import pair_functions as pairs
from hertzwerk.derive.equations.module.contents import refuse_idle, with_constants
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.labelled_results import ports_of
from hertzwerk.derive.equations.module.landmarks import landmarks_of
from hertzwerk.derive.equations.module.module_tables import tables
from hertzwerk.derive.program.program import Function, Program, Repeated, Result


def program_of_kinds(grouping: Alike) -> Program | None:
    """Program of a scene whose trees and pairs are alike; None where one of them depends on others.

    A user's own kind of pair may read what it likes.
    """
    sample = System(grouping.sample, whole=grouping.scene)
    whole = _widened(sample, grouping)
    try:
        of_kinds = [*_of_trees(sample, grouping), *_of_pairs(sample, grouping)]
    except _CoupledError:
        return None
    refuse_idle(sample)
    functions = [
        motion_functions.start(whole),
        scale_functions.scales(whole),
        *of_kinds,
        *([motion_functions.ledger(whole)] if grouping.scene.ledger else []),
        *([scale_functions.speed_limits(whole)] if whole.limited else []),
        *([scale_functions.yield_forces(whole)] if whole.yielding else []),
        *([scale_functions.period(sample)] if sample.periodic is not None else []),
        _landmarks(whole, grouping),
    ]
    program = with_constants(whole, functions, tables(whole), "")
    trees, of_pairs = _rows_of(sample, whole, grouping, _latched(tables(sample)), _latched(program.tables))
    return replace(program, trees=trees, pairs=of_pairs)


class _CoupledError(Exception):
    """A part depends on others."""


class _Own:
    """Entries of the sample's vectors that are those of trees and of a pair, and their places in these."""

    def __init__(self, sample: System, trees: Sequence[Tree], names: Collection[str] = ()) -> None:
        joints = [joint.name for tree in trees for joint in tree.joints]

        def rows(labels: Sequence[str]) -> list[int]:
            return [i for joint in joints for i, label in enumerate(labels) if label.partition(".")[0] == joint]

        self.q = rows([port.name for port in sample.coordinates])
        self.u = rows([port.name for port in sample.speeds])
        self.z = [i for i, (entry, _) in enumerate(sample.memory) if entry.partition(".")[0] in names]
        latches = [*sample.latches.values()]
        self.m = [i for i, name in enumerate(sample.latches) if name in names]
        kin, read = sample.kin, [s for s, group in sample.tape.inputs.items() if group == "z"]
        forces = [s for s, group in sample.tape.inputs.items() if group == "f"]
        vectors = {
            "q": (kin.q, self.q),
            "u": (kin.u, self.u),
            "a": (kin.a, self.u),
            "m": (latches, self.m),
            "z": (read, self.z),
        }
        if forces:
            vectors["f"] = forces, self.u
        self.places = {
            symbols[i]: f"{sample.tape.own(group)}[{k}]"
            for group, (symbols, indices) in vectors.items()
            for k, i in enumerate(indices)
            if i < len(symbols)  # of z, bristles alone are read
        }

    def function(self, sample: System, name: str, summary: str, arguments: str, *results: Result) -> Function:
        """Function of the own entries; raises _CoupledError where it needs others."""
        function = sample.function(name, summary, arguments, *results)
        inputs = (
            symbol for symbol in function.reads if sample.tape.inputs.get(symbol) in ("q", "u", "a", "f", "z", "m")
        )
        if any(symbol not in self.places for symbol in inputs):
            raise _CoupledError
        return replace(function, places=self.places)


def _entries(result: Result, rows: Sequence[int]) -> Result:
    """Some entries of a result."""
    labels, units, values = (tuple(part[i] for i in rows) for part in (result.labels, result.units, result.expressions))
    return Result(result.name, labels, units, values)


def _only(result: Result, rows: Sequence[int]) -> Result:
    """Entries of a result that has no others; raises _CoupledError where it has."""
    if any(value != 0 for i, value in enumerate(result.expressions) if i not in rows):
        raise _CoupledError
    return _entries(result, rows)


def _of_trees(sample: System, grouping: Alike) -> Iterator[Function]:
    """Yield the functions of a tree of each kind."""
    dq, f = (part(sample).results[0] for part in (motion_functions.coordinate_rates, motion_functions.applied))
    a = motion_functions.accelerations(sample)[0].results[0]
    places = output_functions.poses(sample)
    bodies = [body.name for body in sample.scene.mechanism.bodies]
    for kind in grouping.trees:
        tree, phrase = kind.members[0], f"of one tree of {kind.name}, by the names of the first"
        own = _Own(sample, [tree])
        joints = [joint.name for joint in tree.joints]
        on = [bodies.index(joint.child.body.name) for joint in tree.joints]
        for name, summary, arguments, result, rows in (
            ("coordinate_rates", "Rates of the coordinates", "t q u c", dq, own.q),
            ("applied", "Generalised forces other than contact forces", "t q u c", f, own.u),
            ("accelerations", "Generalised accelerations", "t q u f c", a, own.u),
        ):
            yield own.function(
                sample, f"{name}_of_{kind.name}", f"{summary} {phrase}.", arguments, _entries(result, rows)
            )
        if sample.scene.ledger:
            links = [link for link in sample.kin.tree.links if link.joint is not None and link.joint.name in joints]
            kinetic = sample.equations.kinetic_of(links)
            potential = sample.equations.potential_of([sample.scene.mechanism.bodies[i] for i in on])
            yield own.function(
                sample, f"energy_of_{kind.name}", f"Kinetic and potential energy {phrase}.", "t q u c",
                Result("kinetic", ("kinetic",), ("J",), (kinetic,)), Result("potential", ("potential",), ("J",), (potential,)),
            )  # fmt: skip
        results = (
            _entries(result, [width * i + k for i in on for k in range(width)])
            for width, result in zip((3, 9), places.results, strict=True)
        )
        yield own.function(
            sample, f"poses_of_{kind.name}", f"Origins and rotations of the bodies {phrase}.", "t q c", *results
        )


def _of_pairs(sample: System, grouping: Alike) -> Iterator[Function]:
    """Yield the functions of a pair of each kind."""
    contacts = {pair.pair.name: (pair, contact, friction) for pair, contact, friction in sample.contacts}
    for kind in grouping.pairs:
        meeting, phrase = kind.members[0], f"of one pair of {kind.name}, by the names of the first"
        trees = _trees(grouping, meeting)
        own, name = _Own(sample, trees, meeting.names), meeting.pair.name
        pair, contact, friction = contacts[name]
        touch = pair.touch
        yield own.function(
            sample, f"gaps_of_{kind.name}", f"Gap and its rate {phrase}.", "t q u c",
            Result("G", (name,), ("m",), (touch.gap,)), Result("dG", (name,), ("m/s",), (touch.gap_rate,)),
        )  # fmt: skip
        yield own.function(
            sample, f"gap_accelerations_of_{kind.name}", f"Second derivative of the gap {phrase}.", "t q u a c",
            Result("ddG", (name,), ("m/s^2",), (touch.gap_acceleration,)),
        )  # fmt: skip
        whole = pairs.contact(sample, pair, contact, friction)
        f, dz, *others = whole.results
        if friction_modes := others[3:5]:
            f_rows, z_rows = len(f.labels), len(dz.labels)
            along, power = friction_modes
            times = range(len(along.labels) // f_rows)
            others[3:5] = (
                _only(along, [k * f_rows + i for k in times for i in own.u]),
                _only(power, [k * z_rows + i for k in times for i in own.z]),
            )
        summary = f"Forces {phrase}: {whole.summary.partition(': ')[2]}"
        yield own.function(
            sample, f"contact_of_{kind.name}", summary, "t q u z m c", _only(f, own.u), _only(dz, own.z), *others
        )
        if sample.scene.ledger:
            yield own.function(
                sample, f"stored_energy_of_{kind.name}", f"Energy stored by the stiffness {phrase}.", "t q u c",
                Result("stored", (name,), ("J",), (pair.elastic(contact)[1],)),
            )  # fmt: skip
        labels, units, values = zip(*touch.outputs(), strict=True)
        yield own.function(
            sample,
            f"outputs_of_{kind.name}",
            f"Named quantities {phrase}.",
            "t q u c",
            Result("y", labels, units, values),
        )


def _trees(grouping: Alike, meeting: Meeting) -> list[Tree]:
    """Trees of a pair, in its own order."""
    trees = [tree for kind in grouping.trees for tree in kind.members]
    return [trees[i] for i in meeting.trees]


def _renamed(kind: Kind[Meeting], member: Meeting, name: str) -> str:
    """Name of a member's entry, by that of the one that stands for all."""
    owner, dot, rest = name.partition(".")
    return member.names[kind.members[0].names.index(owner)] + dot + rest


def _widened(sample: System, grouping: Alike) -> System:
    """System of the whole scene, for its tables and its functions of parameters alone."""
    whole, scene = copy(sample), grouping.scene
    whole.scene = scene
    coordinates, speeds = ports_of(scene, sample.kin)
    parts = {"coordinates": coordinates, "speeds": speeds, "landmarks": tuple(landmarks_of(scene))}
    whole.__dict__.update(parts)  # in place of those of the sample
    derived = {pair.pair.name: pair for pair, _, _ in sample.contacts}
    declared = iter(scene.contacts)
    whole.contacts, whole.latches, whole.bristles, whole.limited = [], {}, {}, {}
    for kind in grouping.pairs:
        first = kind.members[0]
        pair, limit = derived[first.pair.name], sample.limited.get(first.pair.name)
        pair.touch.outputs()  # whose parts are those of each
        for member, (_, contact, friction) in zip(kind.members, declared, strict=False):
            named: PairKinematics = copy(pair)
            named.pair, named.touch = member.pair, copy(pair.touch)
            named.touch.pair = member.pair
            whole.contacts.append((named, contact, friction))
            if first.pair.name in sample.latches:
                whole.latches[member.pair.name] = sample.latches[first.pair.name]
            if limit is not None:
                whole.limited[member.pair.name] = limit
            for effect, entries in sample.bristles.items():
                if effect in first.names:
                    bent = {_renamed(kind, member, entry): symbol for entry, symbol in entries.items()}
                    whole.bristles[_renamed(kind, member, effect)] = bent
    booking = [effect for effect in scene.effects if effect.enters == CONTACT] if scene.ledger else []
    booked = [f"{effect.name}.{DISSIPATED}" for effect in booking]
    whole.memory = [
        *((name, "m") for entries in whole.bristles.values() for name in entries),
        *((name, "J") for name in booked),
    ]
    return whole


def _latched(known: Mapping[str, tuple[Any, ...]]) -> list[str]:
    """Names of the entries of m."""
    return [name for name, *_ in (*known["LATCHES"], *known.get("SLIPS", ()))]


def _rows_of(
    sample: System, whole: System, grouping: Alike, held: list[str], all_held: list[str]
) -> tuple[tuple[Repeated, ...], tuple[Repeated, ...]]:
    """Rows of the members of each kind in the whole vectors.

    Of trees and of pairs; `held` are entries of m, of the sample and of all.
    """
    index = [
        {label: i for i, label in enumerate(labels)} for labels in ([entry for entry, _ in whole.memory], all_held)
    ]
    trees: list[Repeated] = []
    place, ends = 0, {"q": 0, "u": 0}
    for of_trees in grouping.trees:
        own, count = _Own(sample, of_trees.members[:1]), len(of_trees.members)
        rows = {}
        for part, size in (("q", len(own.q)), ("u", len(own.u))):
            rows[part] = tuple(tuple(range(ends[part] + k, ends[part] + size * count, size)) for k in range(size))
            ends[part] += size * count
        names = [tree.joints[-1].child.body.name for tree in of_trees.members]
        trees.append(Repeated(of_trees.name, tuple(zip(names, range(place, place + count), strict=True)), rows))
        place += count
    pairs: list[Repeated] = []
    for kind in grouping.pairs:
        first = kind.members[0].names
        entries = [entry for entry, _ in sample.memory if entry.partition(".")[0] in first]
        latches = [name for name in held if name.partition(".")[0] in first]
        rows = {
            part: tuple(tuple(known[_renamed(kind, member, name)] for member in kind.members) for name in own_names)
            for part, known, own_names in zip("zm", index, (entries, latches), strict=True)
        }
        pairs.append(Repeated(kind.name, tuple((member.pair.name, *member.trees) for member in kind.members), rows))
    return tuple(trees), tuple(pairs)


def _landmarks(whole: System, grouping: Alike) -> Function:
    """Points, directions and sizes for pictures: those of a kind are equal."""
    stands_for: dict[str, str] = {}
    kinds: tuple[Kind[Any], ...] = (*grouping.trees, *grouping.pairs)
    for kind in kinds:
        for member in kind.members:
            stands_for |= dict(zip(member.names, kind.members[0].names, strict=True))
    known: dict[tuple[str, ...], Result] = {}
    results = []
    for mark in whole.landmarks:
        key = stands_for.get(mark.part, mark.part), mark.kind, mark.place
        if key not in known:
            known[key] = mark.result
        results.append(replace(known[key], name=f"{mark.part}.{mark.place}"))
    summary = "Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies."
    return whole.function("landmarks", summary, "p", *results)
