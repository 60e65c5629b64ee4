"""Neighbour lists: models of many bodies in which far pairs cost nothing.

A list holds the pairs that are evaluated. Between bodies whose centres have moved no further than half its skin since it
was made, no other pair can touch (Verlet, Phys. Rev. 159 (1967) 98): the distance of two spheres, or of a sphere and a plane at
rest, changes by no more than their centres move. Kinds of pairs without that bound are always in the list.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from types import SimpleNamespace
from typing import Any

import casadi as ca

from hertzwerk.runtime.integrate.alike.kinds import Alike, Kind, alike
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.model.per_model import per_model

# Places of a kind of pairs for each of n bodies: of n spheres fewer than 7.47 n pairs can touch (Kuperberg, Schramm, Math. Res. Lett. 1 (1994) 339).
PLACES = 8
WORTH = 2.0  # pairs over places from which a list pays
NONE = -1.0  # number of no pair
OWN = 2  # place of a pair's latches among the inputs of `contact_items`
APART = 1e30  # m, gap in a place without a pair
WITHIN = 2 / 5, 1 / 20  # of h |v| and h^2 |a| at the ends of a step: how far a quintic goes beyond both ends


@dataclass(frozen=True, eq=False)
class Family:
    """Pairs whose functions all have equal operations, and their places.

    pairs   their numbers in the whole model
    bodies  of each the two whose centres it depends on, -1 for the ground; none where all are always near
    first   the first of its places; the numbers of its pairs in the list begin there as well, `count` places
    """

    pairs: list[int]
    bodies: list[tuple[int, int]]
    first: int
    number: int
    count: int


class NearModel(Model):
    """Model whose pairs are places for the near ones of a whole model.

    The numbers of the pairs in its places are among its constants.
    """

    def __init__(self, whole: Model, families: Sequence[Family], gaps: Alike) -> None:
        self.whole, self.families, self.gaps = whole, families, gaps
        self.numbers = [pair for family in families for pair in family.pairs]
        """Pairs of the whole model by their number in a list."""
        places = [family for family in families for _ in range(family.count)]
        module, rows = whole.module, _memory_rows(whole)
        self.memory_rows = rows
        """Rows of the whole model's memory that are of each pair."""
        self.others = sorted({*range(whole.nz)} - {row for of in rows for row in of})
        """Rows of the whole model's memory that are of no pair."""
        ends = [*accumulate((len(rows[family.pairs[0]]) for family in places), initial=len(self.others))]
        self.rows = [[*range(first, last)] for first, last in pairwise(ends)]
        """Rows of memory of each place."""
        self.summed = [[whole.memory[row].rpartition(".")[2] for row in rows[family.pairs[0]]] for family in places]
        """What the rows of memory of each place sum."""
        self.whole_latches = latch_rows(whole)
        names = [name for of in self.summed for name in of]
        self.departed = {ending: ends[-1] + i for i, ending in enumerate(dict.fromkeys(names))}
        """Rows of memory of pairs that left the list, by what is summed."""
        latches = _latches(whole)
        own = [row for row in module.MEMORY if row[0] in {whole.memory[i] for i in self.others}]
        self.bodies = sorted({body for family in families for of in family.bodies for body in of} - {-1})
        """Bodies whose centres are watched."""
        lists = len(places), 3 * len(self.bodies), 1
        super().__init__(
            SimpleNamespace(
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
                LATCHES=tuple(
                    (f"near_{i}.{name}", "", i) for name in latches[self.numbers[0]] for i in range(len(places))
                ),
                PAIRS=tuple((f"near_{i}", "") for i in range(len(places))),
                OUTPUTS=(),
                CONSTANTS=(*module.CONSTANTS, *[("near", "1")] * sum(lists)),
                LISTS=lists,
                RELEASES=tuple(_release(whole, family.pairs[0]) for family in places),
                DISSIPATED=tuple(
                    of[rows[family.pairs[0]].index(module.DISSIPATED[family.pairs[0]])]
                    for family, of in zip(places, self.rows, strict=True)
                )
                if whole.has_ledger
                else (),
                coordinate_rates=module.coordinate_rates,
                applied=module.applied,
                accelerations=module.accelerations,
                energy=lambda *given: module.energy(*given)[:2],
                **({"ledger": self._ledger} if whole.has_ledger else {}),
            )
        )

    def _ledger(self, *given: Any) -> Any:
        found = ca.SX(ca.vec(ca.SX(self.whole.module.ledger(*given))))
        return ca.vertcat(found[self.others], ca.SX.zeros(self.nz - len(self.others)))

    def lists_of(self, c: Any) -> list[Any]:
        """Return the list among the constants: numbers of pairs by place, centres (3 n) when made, skin [m]."""
        ends = [self.whole.nc, *accumulate(self.lists, initial=self.whole.nc)][1:]
        return [c[first:last] for first, last in pairwise(ends)]

    @per_model
    def of_places(self, name: str) -> Any:
        """Return a function of the module with results for each pair, for the places of the list (MX)."""
        return self.at_places(name, *_ITEMS[name](self.whole))

    def at_places(self, name: str, found: Alike, otherwise: tuple[float, ...]) -> Any:
        """Return a function with the results of all pairs for the places of the list.

        otherwise    results in a place without a pair
        """
        arguments = "t q u a c" if name == "gap_accelerations" else "t q u c"
        symbols = self.symbols(arguments, ca.MX)
        known = found.known([*symbols[:-1], symbols[-1][: self.whole.nc]])
        near, *_ = self.lists_of(symbols[-1])
        columns: list[list[Any]] = [[] for _ in otherwise]
        order: list[int] = []
        for kind, places, shift in self.by_places(found):
            own = near[places]
            there = own > NONE
            results, _ = kind.results_at(known, ca.if_else(there, own - shift, 0), [])
            order += places
            for column, value, without in zip(columns, results, otherwise, strict=True):
                column.append(ca.if_else(there, value, without))
        back = sorted(range(len(order)), key=order.__getitem__)
        return ca.Function(name, symbols, [ca.vertcat(*column)[back] for column in columns])

    def by_places(self, found: Alike) -> list[tuple[Kind, list[int], Any]]:
        """Return each kind with items in the order of their numbers, its places, and numbers less items there."""
        by_kind: list[tuple[Kind, list[int], Any]] = []
        for kind in found.kinds:
            leaves = dict(zip(kind.items, kind.leaves, strict=True))
            families = [family for family in self.families if family.pairs[0] in leaves]
            items = [pair for family in families for pair in family.pairs]
            places = [family.first + i for family in families for i in range(family.count)]
            starts = accumulate((len(family.pairs) for family in families), initial=0)
            shift = [
                family.number - start
                for family, start in zip(families, starts, strict=False)
                for _ in range(family.count)
            ]
            by_kind.append((Kind(items, [leaves[item] for item in items], kind.one), places, ca.DM(shift)))
        return by_kind

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
        given = [t, y, dy, ca.SX.sym("constants", self.nc)]
        found = now(t, y[: self.nq], y[self.nq : self.nq + self.nu], dy, given[3][: whole.nc])
        return ca.Function("centres", given, [*found], ["t", "y", "dy", "c"], ["r", "v", "a"])

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
            beyond = ca.fmax(beyond, WITHIN[0] * h * self.lengths(v) + WITHIN[1] * h * h * self.lengths(a))
        return 2 * ca.mmax(way + beyond) / skin

    def time_left(self, run: Mapping[str, Any], at: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the longest step [s] that keeps to the list, and whether bodies have moved since it was made."""
        _, made, skin = self.lists_of(run["c"])
        r, v, a = self.centres()(at["t"], at["y"], at["dy"], run["c"])
        way, speed, rate = self.lengths(r - made), self.lengths(v), self.lengths(a)
        left = ca.fmax(KEPT * skin / 2 - way, 0)
        # of s + 2/5 ... the larger share is what a step adds at its end
        time = 2 * left / (speed + ca.sqrt(speed * speed + 2 * rate * left) + 1 / APART)
        return ca.mmin(time), ca.mmax(way) > 0


KEPT = 0.5  # of half the skin: the way to the end of a step foreseen; within it a curve may go further


def _release(model: Model, pair: int) -> str:
    return str(getattr(model.module, "RELEASES", ("force",) * model.k)[pair])


@per_model
def _latches(model: Model) -> list[list[str]]:
    """Return what is latched for each pair."""
    found: list[list[str]] = [[] for _ in model.pairs]
    for name, _, pair in model.module.LATCHES:
        found[pair].append(name.rpartition(".")[2])
    return found


@per_model
def latch_rows(model: Model) -> list[list[int]]:
    """Return the rows of the latches of each pair."""
    found: list[list[int]] = [[] for _ in model.pairs]
    for row, (_, _, pair) in enumerate(model.module.LATCHES):
        found[pair].append(row)
    return found


@per_model
def contact_items(model: Model) -> tuple[Alike | None, list[list[int]], list[list[int]]]:
    """Return the contacts of all pairs by kind; of each the rows of its forces and of its memory.

    An item's results are its forces, rates of memory, normal force and range; inputs t, (q, u), own latches, c, z.
    """
    t, q, u, z, c = model.symbols("t q u z c")
    latches = latch_rows(model)
    own = ca.SX.sym("own", max(map(len, latches)))
    m = ca.SX.zeros(model.nm)
    for rows in latches:
        m[rows] = own[: len(rows)]
    items, forces, memory = [], [], []
    for pair in model.pairs:
        f, dz, normal, _, valid, *_ = model.expressions(f"contact_{pair}", t, q, u, z, m, c)
        f, dz = ca.sparsify(f), ca.sparsify(dz)
        forces.append(list(f.sparsity().row()))
        memory.append(list(dz.sparsity().row()))
        items.append(ca.vertcat(ca.SX(0, 1), *f.nonzeros(), *dz.nonzeros(), normal, valid))
    return alike([t, ca.vertcat(q, u), own, c, z], items, share=False), forces, memory


def _memory_rows(model: Model) -> list[list[int]]:
    return contact_items(model)[2]


@per_model
def _gap_items(model: Model) -> Alike | None:
    """Return gaps and their rates of all pairs by kind; None where pairs are not alike."""
    given = model.symbols("t q u c")
    return alike(given, [ca.vertcat(*x) for x in zip(*map(ca.vertsplit, model.function("gaps")(*given)), strict=True)])


@per_model
def _acceleration_items(model: Model) -> Alike | None:
    given = model.symbols("t q u a c")
    return alike(given, ca.vertsplit(model.function("gap_accelerations")(*given)))


@per_model
def _energy_items(model: Model) -> Alike | None:
    given = model.symbols("t q u c")
    return alike(given, ca.vertsplit(model.function("energy").call(given)[2]))


@per_model
def _distance_items(model: Model) -> Alike | None:
    """Return the distances of the surfaces: outputs, or gaps where there is none."""
    given = model.symbols("t q u c")
    outputs, gaps = model.function("outputs")(*given), model.function("gaps").call(given)[0]
    place = {name: i for i, name in enumerate(model.outputs)}
    names = [f"{pair}.gap" for pair in model.pairs]
    return alike(given, [outputs[place[name]] if name in place else gaps[j] for j, name in enumerate(names)])


_ITEMS: dict[str, Any] = {
    "gaps": lambda model: (_gap_items(model), (APART, 0)),
    "gap_accelerations": lambda model: (_acceleration_items(model), (0,)),
    "stored": lambda model: (_energy_items(model), (0,)),
    "distances": lambda model: (_distance_items(model), (APART,)),
}


@per_model
def distances(model: Model) -> Any:
    """Return the function (t, q, u, c) -> distances (k) of the surfaces of all pairs (MX)."""
    given = model.symbols("t q u c", ca.MX)
    found = _distance_items(model)
    if found is None:
        raise ValueError("distances that are not alike")
    return ca.Function("distances", given, found.results(given))


@per_model
def near_model(model: Model) -> NearModel | None:
    """Return the model with places for near pairs; None where it would not pay, or is not possible."""
    bodies = _bodies(model)
    most = PLACES * len({body for of in bodies if of for body in of if body >= 0})
    if model.k < max(WORTH * (bodies.count(None) + most), 1) or not _possible(model):
        return None
    gaps = _gap_items(model)
    functions = [_acceleration_items, _distance_items, *([_energy_items] if model.has_ledger else [])]
    items = [contact_items(model)[0], gaps, *(of(model) for of in functions)]
    keys: list[list[Any]] = [[] for _ in model.pairs]
    for found in items:
        if found is None:
            return None
        for number, kind in enumerate(found.kinds):
            for item in kind.items:
                keys[item].append(number)
    (_, _, memory), latches = contact_items(model), _latches(model)
    for j, key in enumerate(keys):
        booked = memory[j].index(model.module.DISSIPATED[j]) if model.has_ledger else None
        key += [_release(model, j), len(memory[j]), booked, tuple(latches[j]), bodies[j] is None]
    groups: dict[tuple[Any, ...], list[int]] = {}
    for j, key in enumerate(keys):
        groups.setdefault(tuple(key), []).append(j)
    families: list[Family] = []
    place = number = 0
    for pairs in groups.values():
        watched = [of for of in (bodies[j] for j in pairs) if of is not None]
        count = min(len(pairs), most) if watched else len(pairs)
        families.append(Family(pairs, watched, place, number, count))
        place, number = place + count, number + len(pairs)
    return NearModel(model, families, gaps) if gaps is not None and model.k >= WORTH * place else None


def _possible(model: Model) -> bool:
    """Return whether the model has nothing of which no more than places for pairs are known."""
    others = (
        model.ns,
        model.ne,
        model.nl,
        model.loads,
        model.inputs,
        model.journals,
        model.speed_limited,
        model.dependent,
    )
    if any(map(bool, (*others, getattr(model.module, "BRISTLES", None)))):
        return False
    reads = contact_items(model)[0]
    if reads is None or len({tuple(of) for of in _latches(model)}) > 1:
        return False
    return not reads.taken[-1]  # no contact reads memory


def _bodies(model: Model) -> list[tuple[int, int] | None]:
    """Return the two bodies of each pair whose centres bound its distance.

    -1 stands for the ground; None where the motion of centres is no bound.
    """
    place = {name: i for i, name in enumerate(getattr(model.module, "BODIES", ()))} | {"ground": -1}
    (p,) = model.symbols("p")
    rows: dict[str, list[tuple[str, str, str, bool]]] = {}
    landmarks = getattr(model.module, "LANDMARKS", ())
    for (pair, kind, role, body, *_), value in zip(
        landmarks, model.module.landmarks(p) if landmarks else (), strict=True
    ):
        centred = ca.SX(value)[:3].is_zero()
        rows.setdefault(pair, []).append((kind, role, body, centred))
    found: list[tuple[int, int] | None] = []
    for pair in model.pairs:
        spheres = [place[body] for _, role, body, centred in rows.get(pair, ()) if centred and role != "plane"]
        kinds = {(kind, role) for kind, role, *_ in rows.get(pair, ())}
        grounded = all(body == "ground" for _, role, body, _ in rows.get(pair, ()) if role == "plane")
        if kinds == {("sphere_on_sphere", "first"), ("sphere_on_sphere", "second")} and len(spheres) == 2:
            found.append((spheres[0], spheres[1]))
        elif kinds == {("sphere_on_plane", "sphere"), ("sphere_on_plane", "plane")} and len(spheres) == 1 and grounded:
            found.append((spheres[0], -1))
        else:
            found.append(None)
    return found
