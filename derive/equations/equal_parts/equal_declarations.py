"""Trees of joints, and pairs between them, of equal declarations up to names: one stands for all.

What is derived of a part follows from its declaration, and from those of the bodies it is on: where these are equal, so are the
operations. A scene is taken apart where its trees off the ground meet in contacts alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, Generic, TypeVar

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.effect import PairEffect
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.gravity import Gravity
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import PairResistance
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.declare.scene.start import Start

REPEATED = 4
"""Members of a kind of pairs, on the average, from which on one of them is derived for all."""


@dataclass(frozen=True)
class Tree:
    """Joints that carry bodies, one after another from the ground outwards."""

    joints: tuple[Joint, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its joints, then of its bodies."""
        return (*(joint.name for joint in self.joints), *(joint.child.body.name for joint in self.joints))


@dataclass(frozen=True)
class Meeting:
    """A pair with its effects, in declared order, and the places of the trees it is on."""

    pair: Pair
    effects: tuple[PairEffect, ...]
    trees: tuple[int, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the pair and of its effects."""
        return (self.pair.name, *(effect.name for effect in self.effects))


T = TypeVar("T", Tree, Meeting)


@dataclass(frozen=True)
class Kind(Generic[T]):
    """Members of equal declarations, of which the first stands for all, under a name of their own."""

    name: str
    members: tuple[T, ...]


@dataclass(frozen=True)
class Alike:
    """Kinds of trees and of pairs of a scene, and the scene of those that stand for all."""

    scene: Scene
    trees: tuple[Kind[Tree], ...]
    pairs: tuple[Kind[Meeting], ...]
    sample: Scene


def alike(scene: Scene) -> Alike | None:
    """Take a scene apart into kinds; None where little repeats, or trees of a kind do not stand together.

    Its pairs do, which for a scene of another order is one of the same parts.
    """
    mechanism = scene.mechanism
    if not _meets_in_contacts(scene):
        return None
    trees = _trees(mechanism)
    shared: dict[Any, Any] = {}
    forms = [_Form({joint.child.body.name: (0, k) for k, joint in enumerate(tree.joints)}, shared) for tree in trees]
    of_trees = _grouped(trees, [form.of(tree.joints) for form, tree in zip(forms, trees, strict=True)])
    kind_of = {id(tree): k for k, kind in enumerate(of_trees) for tree in kind}
    places = {
        joint.child.body.name: (i, kind_of[id(tree)], k)
        for i, tree in enumerate(trees)
        for k, joint in enumerate(tree.joints)
    }
    effects: dict[str, list[PairEffect]] = {pair.name: [] for pair in mechanism.pairs}
    for effect in scene.effects:
        if isinstance(effect, PairEffect):
            effects[effect.pair].append(effect)
    meetings, keys = [], []
    for pair in mechanism.pairs:
        form = _Form(places, shared)
        keys.append(form.of((pair, *effects[pair.name])))
        meetings.append(Meeting(pair, tuple(effects[pair.name]), tuple(form.trees)))
    of_pairs = _grouped(meetings, keys)
    if len(meetings) < REPEATED * len(of_pairs):
        return None
    if [joint for kind in of_trees for tree in kind for joint in tree.joints] != [*mechanism.joints]:
        return None
    pairs = tuple(meeting.pair for kind in of_pairs for meeting in kind)
    if pairs != mechanism.pairs:  # an exception among them: the same scene, but for their order
        return (
            None
            if any(_bends(effect) for effect in scene.effects)
            else alike(replace(scene, mechanism=replace(mechanism, pairs=pairs)))
        )
    taken: set[str] = set()
    return Alike(
        scene,
        tuple(Kind(_name([tree.joints[-1].child.body.name for tree in kind], taken), tuple(kind)) for kind in of_trees),
        tuple(Kind(_name([meeting.pair.name for meeting in kind], taken), tuple(kind)) for kind in of_pairs),
        _sample(scene, trees, [kind[0] for kind in of_trees], [kind[0] for kind in of_pairs]),
    )


def _meets_in_contacts(scene: Scene) -> bool:
    """Whether nothing but contacts acts between the trees, and gravity alone on them."""
    plain = type(scene.mechanism) is Mechanism and type(scene) is Scene and scene.coordinates == "tree"
    if not plain or len(scene.mechanism.pairs) < REPEATED or scene.mechanism.closures or scene.start.seated:
        return False
    return {pair.name for pair in scene.mechanism.pairs} == {*scene.pressed} and all(map(_plain, scene.effects))


def _plain(effect: Any) -> bool:
    """Whether an effect acts at one pair, or on all bodies alike."""
    if isinstance(effect, Gravity):
        return not effect.varies
    return isinstance(effect, Contact | Friction | PairResistance | EnergyLedger)


def _bends(effect: Any) -> bool:
    """Whether an effect has a bristle, a state in the order of the pairs."""
    return isinstance(effect, Friction) and bool(effect.law.law.memory)


def _trees(mechanism: Mechanism) -> list[Tree]:
    carried = {joint.child.body.name: joint for joint in mechanism.joints}
    groups: dict[str, list[Joint]] = {}
    for joint in mechanism.joints:
        root = joint
        while root.parent.body != GROUND:
            root = carried[root.parent.body.name]
        groups.setdefault(root.name, []).append(joint)
    return [Tree(tuple(joints)) for joints in groups.values()]


class _Form:
    """Declarations without names: bodies by their places, shared records by number."""

    def __init__(self, places: Mapping[str, tuple[int, ...]], shared: dict[Any, Any]) -> None:
        self.places = places
        self.shared = shared
        self.trees: list[int] = []
        """Trees of the bodies in it, in order of appearance."""
        self._bodies = 0

    def of(self, value: Any) -> Any:
        """Return a value that is equal for equal declarations, and can be hashed."""
        if isinstance(value, tuple):
            return (tuple, *map(self.of, value))
        if isinstance(value, Body):
            self._bodies += 1
            tree, *place = self.places[value.name]
            if tree not in self.trees:
                self.trees.append(tree)
            own = () if len(place) > 1 else self._fields(value)  # of a tree: what the body is
            return (Body, self.trees.index(tree), *place, *own)
        if not is_dataclass(value):
            return _plain_value(value)
        if id(value) not in self.shared:  # which the scene keeps alive
            before = self._bodies
            form = (type(value), *self._fields(value))
            if self._bodies > before:
                return form
            self.shared[id(value)] = self.shared.setdefault(form, len(self.shared))
        return self.shared[id(value)]

    def _fields(self, value: Any) -> tuple[Any, ...]:
        named = ("name", "pair") if isinstance(value, PairEffect) else ("name",)
        return tuple(self.of(getattr(value, field.name)) for field in fields(value) if field.name not in named)


def _plain_value(value: Any) -> Any:
    """A value with its type, as 1 is not 1.0; by its identity where it cannot be hashed."""
    try:
        hash(value)
    except TypeError:
        return type(value), id(value)
    return type(value), value


def _grouped(members: list[T], keys: Iterable[Any]) -> list[list[T]]:
    return list(grouped(zip(keys, members, strict=True)).values())


def _name(names: list[str], taken: set[str]) -> str:
    """Common beginning of names, without their numbers; unique, in capitals too."""
    low, high = min(names), max(names)
    end = next((k for k, letter in enumerate(low) if not high.startswith(letter, k)), len(low))
    common = (
        low if low == high else low[:end].rstrip("0123456789" if not low[:end].endswith("_") else "").rstrip("_") or low
    )
    name, count = common, 1
    while name.lower() in taken:
        count += 1
        name = f"{common}_{count}"
    taken.add(name.lower())
    return name


def _sample(scene: Scene, trees: list[Tree], firsts: list[Tree], meetings: list[Meeting]) -> Scene:
    """Scene of the trees and pairs that stand for all."""
    chosen = {id(tree) for tree in firsts} | {id(trees[i]) for meeting in meetings for i in meeting.trees}
    joints = tuple(joint for tree in trees if id(tree) in chosen for joint in tree.joints)
    names, pairs = {joint.name for joint in joints}, tuple(meeting.pair for meeting in meetings)
    touching = {pair.name for pair in pairs}
    position, speed, near = (
        {name: value for name, value in values.items() if name.partition(".")[0] in names}
        for values in (scene.start.position, scene.start.speed, scene.start.near)
    )
    return Scene(
        Mechanism(scene.mechanism.name, joints, pairs),
        tuple(effect for effect in scene.effects if not isinstance(effect, PairEffect) or effect.pair in touching),
        scene.scales,
        Start(position, speed, near),
        scene.name,
        scene.summary,
    )
