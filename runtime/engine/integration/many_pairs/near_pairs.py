"""Neighbour lists: models of many bodies in which far pairs cost nothing.

A list holds the pairs that are evaluated. Between bodies whose centres have moved no further than half its skin since it
was made, no other pair can touch (Verlet, Phys. Rev. 159 (1967) 98): the distance of two spheres, or of a sphere and a plane at
rest, changes by no more than their centres move. Kinds of pairs without that bound are always in the list.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.many_pairs.vectorised import Alike, Kind
from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.model.generated_text import with_tables
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

# Places of a kind of pairs for each of n bodies: of n spheres fewer than 7.47 n pairs can touch (Kuperberg, Schramm, Math. Res. Lett. 1 (1994) 339).
PLACES = 8
WORTH = 2.0  # pairs over places from which a list pays
NONE = -1.0  # number of no pair
LATCHES = 3  # place of a pair's latches among the inputs of `contacts_by_kind`
APART = 1e30  # m, gap in a place without a pair
BEYOND = 2 / 5, 1 / 20  # of h |v| and h^2 |a| at the ends of a step: how far a quintic goes beyond both ends


@dataclass(frozen=True, eq=False)
class Family:
    """Pairs of one kind, and their places.

    name, rows   as in the module's FAMILIES
    number  of its first pair in the model; first: of its first place, of which there are `count`
    bodies  of each the two whose centres it depends on, -1 for the ground; empty where all are always near
    """

    name: str
    rows: tuple[tuple[Any, ...], ...]
    number: int
    first: int
    count: int
    bodies: list[tuple[int, int]]

    @property
    def pairs(self) -> range:
        """Numbers of its pairs in the model."""
        return range(self.number, self.number + len(self.rows))


class NearModel(WatchedModel):
    """Model whose pairs are places for the near ones of a whole model.

    The numbers of the pairs in its places are among its constants.
    """

    def __init__(self, whole: EngineModel, families: Sequence[Family]) -> None:
        self.whole, self.families = whole, families
        places = [family for family in families for _ in range(family.count)]
        module, (_, _, rows) = whole.module, contacts_by_kind(whole)
        self.memory_rows = rows
        """Rows of the whole model's memory that are of each pair."""
        self.others = sorted({*range(whole.nz)} - {row for of in rows for row in of})
        """Rows of the whole model's memory that are of no pair."""
        ends = [*accumulate((len(rows[family.pairs[0]]) for family in places), initial=len(self.others))]
        self.rows = [[*range(first, last)] for first, last in pairwise(ends)]
        """Rows of memory of each place."""
        self.summed = [[whole.memory[row].rpartition(".")[2] for row in rows[family.pairs[0]]] for family in places]
        """Sums of the rows of memory of each place."""
        self.whole_latches = latch_rows(whole)
        names = [name for of in self.summed for name in of]
        self.departed = {ending: ends[-1] + i for i, ending in enumerate(dict.fromkeys(names))}
        """Rows of memory of pairs that left the list, by what is summed."""
        latches = _latches(whole)
        own = [row for row in module.MEMORY if row[0] in {whole.memory[i] for i in self.others}]
        self.bodies = sorted({body for family in families for of in family.bodies for body in of} - {-1})
        """Bodies whose centres are watched."""
        self.lists = len(places), 3 * len(self.bodies), 1
        super().__init__(
            with_tables(
                NAME=f"{whole.name}_near",
                PARAMETERS=module.PARAMETERS,
                COORDINATES=module.COORDINATES,
                SPEEDS=module.SPEEDS,
                QUATERNIONS=whole.quaternions,
                MEMORY=(
                    *own,
                    *((f"near_{i}.{name}", "J") for i, name in enumerate(names)),
                    *((f"departed.{name}", "J") for name in self.departed),
                ),
                LATCHES=tuple((f"near_{i}.{name}", "", i) for name in latches[0] for i in range(len(places))),
                PAIRS=tuple((f"near_{i}", "") for i in range(len(places))),
                CONSTANTS=(*module.CONSTANTS, *[("near", "1")] * sum(self.lists)),
                RELEASES=tuple(module.RELEASES[family.pairs[0]] for family in places),
                DISSIPATED=tuple(
                    of[rows[family.pairs[0]].index(module.DISSIPATED[family.pairs[0]])]
                    for family, of in zip(places, self.rows, strict=True)
                )
                if whole.has_ledger
                else (),
                coordinate_rates=module.coordinate_rates,
                applied=module.applied,
                accelerations=module.accelerations,
                energy=lambda *arguments: module.energy(*arguments)[:2],
                **({"ledger": self._ledger} if whole.has_ledger else {}),
            )
        )

    def _ledger(self, *arguments: Any) -> Any:
        rates = ca.SX(ca.vec(ca.SX(self.whole.module.ledger(*arguments))))
        return ca.vertcat(rates[self.others], ca.SX.zeros(self.nz - len(self.others)))

    def lists_of(self, c: Any) -> list[Any]:
        """Return the list among the constants: numbers of pairs by place, centres (3 n) when made, skin [m]."""
        ends = [self.whole.nc, *accumulate(self.lists, initial=self.whole.nc)][1:]
        return [c[first:last] for first, last in pairwise(ends)]

    @per_model
    def of_places(self, name: str) -> Any:
        """Return a function of the module with results for each pair, for the places of the list (MX)."""
        made, otherwise = _FUNCTIONS[name]
        return self.at_places(name, made(self.whole), otherwise)

    def at_places(self, name: str, grouped: Alike, otherwise: tuple[float, ...]) -> Any:
        """Return a function with the results of all pairs for the places of the list.

        otherwise    results in a place without a pair
        """
        symbols = self.symbols("t q u a c" if name == "gap_accelerations" else "t q u c", ca.MX)
        known = grouped.known([*symbols[:-1], symbols[-1][: self.whole.nc]])
        near, *_ = self.lists_of(symbols[-1])
        columns: list[list[Any]] = [[] for _ in otherwise]
        for kind, places, number in self.by_places(grouped):
            own = near[places]
            there = own > NONE
            results, _ = kind.results_at(known, ca.if_else(there, own - number, 0), [])
            for column, value, without in zip(columns, results, otherwise, strict=True):
                column.append(ca.if_else(there, value, without))
        return ca.Function(name, symbols, [ca.vertcat(*column) for column in columns])

    def by_places(self, grouped: Alike) -> list[tuple[Kind, list[int], int]]:
        """Return each kind with its places and the number of its first pair."""
        return [
            (kind, [*range(family.first, family.first + family.count)], family.number)
            for kind, family in zip(grouped.kinds, self.families, strict=True)
        ]

    @per_model
    def centres(self) -> Any:
        """Return the function (t, y, dy, c) -> positions, velocities, accelerations (3 n) of watched centres."""
        whole = self.whole
        t, q, u, c = whole.symbols("t q u c")
        y, dy = (ca.SX.sym(name, self.nq + self.nu + self.nz) for name in ("y", "dy"))
        places = [3 * body + i for body in self.bodies for i in range(3)]
        r = whole.expressions("poses", t, q, c)[0][places]
        v = ca.jtimes(r, ca.vertcat(t, q), ca.vertcat(1, whole.expressions("coordinate_rates", t, q, u, c)[0]))
        a = ca.jtimes(v, ca.vertcat(t, q, u), ca.vertcat(1, dy[: self.nq + self.nu]))
        now = ca.Function("now", [t, q, u, dy, c], [*map(ca.densify, ca.cse([r, v, a]))])
        arguments = [t, y, dy, ca.SX.sym("constants", self.nc)]
        motion = now(t, y[: self.nq], y[self.nq : self.nq + self.nu], dy, arguments[3][: whole.nc])
        return ca.Function("centres", arguments, [*motion], ["t", "y", "dy", "c"], ["r", "v", "a"])

    def lengths(self, vectors: Any) -> Any:
        """Return the lengths (n) of vectors (3 n), as a row."""
        return ca.sqrt(ca.sum1(ca.reshape(vectors, 3, len(self.bodies)) ** 2))

    def used(self, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
        """Return which part of the skin is used up within a step at most; above 1 a far pair might touch."""
        _, made, skin = self.lists_of(run["c"])
        way: Any = 0
        beyond: Any = 0
        for side in (start, end):
            r, v, a = self.centres()(side["t"], side["y"], side["dy"], run["c"])
            way = ca.fmax(way, self.lengths(r - made))
            h = start["h"]
            beyond = ca.fmax(beyond, BEYOND[0] * h * self.lengths(v) + BEYOND[1] * h * h * self.lengths(a))
        return 2 * ca.mmax(way + beyond) / skin

    def time_left(self, run: Mapping[str, Any], at: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the longest step [s] that keeps to the list, and whether bodies have moved since it was made."""
        _, made, skin = self.lists_of(run["c"])
        r, v, a = self.centres()(at["t"], at["y"], at["dy"], run["c"])
        way, speed, rate = self.lengths(r - made), self.lengths(v), self.lengths(a)
        left = ca.fmax(FORESEEN * skin / 2 - way, 0)
        # of s + 2/5 ... the larger share is what a step adds at its end
        time = 2 * left / (speed + ca.sqrt(speed * speed + 2 * rate * left) + 1 / APART)
        return ca.mmin(time), ca.mmax(way) > 0


FORESEEN = 0.5  # of half the skin: the way to the end of a step foreseen; within it a curve may go further


@per_model
def _latches(model: EngineModel) -> list[list[str]]:
    """Return what is latched for each pair."""
    latches = model.module.LATCHES
    return [[latches[row][0].rpartition(".")[2] for row in rows] for rows in latch_rows(model)]


@per_model
def latch_rows(model: EngineModel) -> list[list[int]]:
    """Return the rows of the latches of each pair."""
    rows: list[list[int]] = [[] for _ in model.pairs]
    for row, (_, _, pair) in enumerate(model.module.LATCHES):
        rows[pair].append(row)
    return rows


def _by_kind(model: EngineModel, inputs: str, results: Callable[..., Any]) -> Alike:
    """Return results of all pairs by the kinds of the module's FAMILIES.

    results    (family, own entries of the inputs, as SX) -> results of a pair
    """
    sizes = {"t": 1, "q": model.nq, "u": model.nu, "a": model.nu, "latches": len(_latches(model)[0]), "c": model.nc}
    parts = inputs.split()
    starts = dict(zip(parts, accumulate((sizes[part] for part in parts), initial=0), strict=False))
    kinds, number = [], 0
    for family, members in model.module.FAMILIES:
        own = {"q": [row[1] for row in members], "u": [row[2] for row in members], "a": [row[2] for row in members]}
        own |= {part: [[*range(sizes[part])]] * len(members) for part in ("t", "latches", "c")}
        symbols = [ca.SX.sym(part, len(own[part][0])) for part in parts]
        leaves = [[starts[part] + i for part in parts for i in own[part][k]] for k in range(len(members))]
        values = ca.cse([ca.densify(results(family, *symbols))])
        one = ca.Function("one", [ca.vertcat(*symbols)], values)
        kinds.append(Kind([*range(number, number + len(members))], leaves, one))
        number += len(members)
    arguments = [ca.SX.sym(part, sizes[part]) for part in parts]
    alike = Alike(
        [[*range(part.numel())] for part in arguments], ca.Function("shared", arguments, [ca.SX(0, 1)]), kinds
    )
    return alike.with_results([[*range(kind.one.numel_out(0))] for kind in kinds])


def _of(model: EngineModel, function: str, family: str) -> Any:
    return getattr(model.module, f"{function}_of_{family}")


@per_model
def contacts_by_kind(model: EngineModel) -> tuple[Alike, list[list[int]], list[list[int]]]:
    """Return the contacts of all pairs by kind; of each the rows of its forces and of its memory.

    A pair's results are its forces, rates of memory, normal force and range; inputs t, q, u, own latches, c.
    """
    patterns: dict[str, tuple[list[int], list[int]]] = {}

    def contact(family: str, t: Any, q: Any, u: Any, latches: Any, c: Any) -> Any:
        z = ca.SX.zeros(len(members[family][0][3]))
        f, dz, normal, _, valid, *_ = _of(model, "contact", family)(t, q, u, z, latches, c)
        f, dz = ca.sparsify(ca.SX(f)), ca.sparsify(ca.SX(dz))
        patterns[family] = f.sparsity().row(), dz.sparsity().row()
        entries: list[Any] = [*f.nonzeros(), *dz.nonzeros(), normal, valid]
        return ca.vertcat(*entries)

    members = dict(model.module.FAMILIES)
    contacts = _by_kind(model, "t q u latches c", contact)
    forces = [[u[i] for i in patterns[family][0]] for family, _, u, *_ in model.members]
    memory = [[z[i] for i in patterns[family][1]] for family, _, _, z, _ in model.members]
    return contacts, forces, memory


@per_model
def gaps_by_kind(model: EngineModel) -> Alike:
    """Return gaps and their rates of all pairs by kind."""

    def both(family: str, *arguments: Any) -> Any:
        gap, rate = _of(model, "gaps", family)(*arguments)
        return ca.vertcat(ca.SX(gap), ca.SX(rate))

    return _by_kind(model, "t q u c", both)


@per_model
def _accelerations(model: EngineModel) -> Alike:
    return _by_kind(
        model, "t q u a c", lambda family, *arguments: ca.SX(_of(model, "gap_accelerations", family)(*arguments))
    )


@per_model
def _energies(model: EngineModel) -> Alike:
    return _by_kind(model, "t q u c", lambda family, *arguments: ca.SX(_of(model, "stored_energy", family)(*arguments)))


@per_model
def distances_by_kind(model: EngineModel) -> Alike:
    """Return the distances of the surfaces of all pairs by kind: outputs, or gaps where there is none."""
    first = {family: members[0][0] for family, members in model.module.FAMILIES}

    def distance(family: str, *arguments: Any) -> Any:
        own = [name for name in model.outputs if name.startswith(f"{first[family]}.")]
        if f"{first[family]}.gap" in own:
            return ca.SX(_of(model, "outputs", family)(*arguments))[own.index(f"{first[family]}.gap")]
        return ca.SX(_of(model, "gaps", family)(*arguments)[0])

    return _by_kind(model, "t q u c", distance)


_FUNCTIONS: dict[str, tuple[Callable[[EngineModel], Alike], tuple[float, ...]]] = {
    "gaps": (gaps_by_kind, (APART, 0)),
    "gap_accelerations": (_accelerations, (0,)),
    "stored": (_energies, (0,)),
    "distances": (distances_by_kind, (APART,)),
}


@per_model
def distances(model: EngineModel) -> Any:
    """Return the function (t, q, u, c) -> distances (k) of the surfaces of all pairs (MX)."""
    arguments = model.symbols("t q u c", ca.MX)
    return ca.Function("distances", arguments, distances_by_kind(model).results(arguments))


@per_model
def near_model(model: EngineModel) -> NearModel | None:
    """Return the model with places for near pairs; None where it would not pay, or is not possible."""
    if not _possible(model):
        return None
    bodies = _bodies(model)
    most = PLACES * len({body for of in bodies if of for body in of if body >= 0})
    families: list[Family] = []
    place = number = 0
    for name, rows in model.module.FAMILIES:
        watched = [of for of in bodies[number : number + len(rows)] if of is not None]
        watched = watched if len(watched) == len(rows) else []
        count = min(len(rows), most) if watched else len(rows)
        families.append(Family(name, rows, number, place, count, watched))
        place, number = place + count, number + len(rows)
    return NearModel(model, families) if model.k >= WORTH * place else None


def _possible(model: EngineModel) -> bool:
    """Return whether the model has nothing of which no more than places for pairs are known."""
    others = (
        *(
            model.ns,
            model.ne,
            model.nl,
            model.loads,
            model.inputs,
            model.journals,
            model.speed_limited,
            model.dependent,
        ),
        model.module.BRISTLES,
    )
    if any(map(bool, others)) or not model.module.FAMILIES:
        return False
    return len({tuple(of) for of in _latches(model)}) == 1


def _bodies(model: EngineModel) -> list[tuple[int, int] | None]:
    """Return the two bodies of each pair whose centres bound its distance.

    -1 stands for the ground; None where the motion of centres is no bound.
    """
    place = {name: i for i, name in enumerate(model.module.BODIES)} | {"ground": -1}
    (p,) = model.symbols("p")
    rows: dict[str, list[tuple[str, str, str, bool]]] = {}
    landmarks = model.module.LANDMARKS
    for (pair, kind, role, body, *_), value in zip(
        landmarks, model.module.landmarks(p) if landmarks else (), strict=True
    ):
        centred = ca.SX(value)[:3].is_zero()
        rows.setdefault(pair, []).append((kind, role, body, centred))
    bodies: list[tuple[int, int] | None] = []
    for pair in model.pairs:
        spheres = [place[body] for _, role, body, centred in rows.get(pair, ()) if centred and role != "plane"]
        kinds = {(kind, role) for kind, role, *_ in rows.get(pair, ())}
        grounded = all(body == "ground" for _, role, body, _ in rows.get(pair, ()) if role == "plane")
        if kinds == {("sphere_on_sphere", "first"), ("sphere_on_sphere", "second")} and len(spheres) == 2:
            bodies.append((spheres[0], spheres[1]))
        elif kinds == {("sphere_on_plane", "sphere"), ("sphere_on_plane", "plane")} and len(spheres) == 1 and grounded:
            bodies.append((spheres[0], -1))
        else:
            bodies.append(None)
    return bodies
