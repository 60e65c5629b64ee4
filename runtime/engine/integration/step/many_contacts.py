"""Gaps and contact forces of many pairs, by operations on vectors over those that are alike.

Forces are evaluated of the pairs in contact: their numbers are inputs, as many as a rung of a ladder has, and each pair's
leaves are looked up by them. Where more of a kind touch than its highest rung has, all of it is evaluated.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from typing import Any, TypeAlias

import casadi as ca

from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import LATCHES, NONE, NearModel, contacts_by_kind
from hertzwerk.runtime.engine.integration.many_pairs.selection import added, running_sum
from hertzwerk.runtime.engine.integration.many_pairs.vectorised import Alike, Kind, alike, entries, over_items
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

LADDER = (1, 4, 16, 64, 256, 1024)  # pairs of a kind that are evaluated, where no more are in contact
SPARSE = 16  # times a rung: pairs of a kind from which it is one: each adds 40 kB of C


@per_model
def of_pairs(model: EngineModel, name: str) -> Any:
    """Return a function of the module with results for each pair, by operations on vectors (MX)."""
    if isinstance(model, NearModel):
        return model.of_places(name)
    return over_items(model.function(name))


@per_model
def stored_energies(model: EngineModel) -> Any:
    """Return the function (t, q, u, c) -> elastic energies (k) [J] of the pairs (MX)."""
    if isinstance(model, NearModel):
        return model.of_places("stored")
    arguments = model.symbols("t q u c")
    return over_items(ca.Function("stored", arguments, [model.function("energy")(*arguments)[2]]))


@per_model
def energies_of_bodies(model: EngineModel) -> Any:
    """Return the function (t, q, u, c) -> kinetic and potential energy [J] without that of the pairs."""
    arguments = model.symbols("t q u c")
    return ca.Function("energies", arguments, model.function("energy").call(arguments)[:2])


@dataclass(frozen=True, eq=False)
class ContactForces:
    """Functions (MX) of the contacts of many pairs.

    touching   (mode) -> rung of the ladder, which is the first argument of the others, and the pairs in contact by kind
    pushes     (rung, t, y, mode, m, c, touching) -> generalised force and dz of all contacts
    contacts   the same, and of each pair (k) normal force and in_range; without contact 0 and 1
    rates      (rung, t, y, mode, m, c, touching, dy) -> rates (k) of the normal forces along dy/dt, 0 without contact
    depends    pattern of generalised force and dz by y
    reads_memory    whether they depend on z
    """

    touching: Any
    pushes: Any
    contacts: Any
    depends: Any
    reads_memory: bool
    rates: Any


@per_model
def contact_forces(model: EngineModel) -> ContactForces | None:
    """Build the functions of the contacts of many pairs; None where pairs are not alike."""
    if isinstance(model, NearModel):
        return _OfPlaces(model).functions()
    t, y, m, c = arguments = model.symbols("t y m c")
    q, u, z = model.parts(y)
    nf = model.function("applied").numel_out(0)
    items: list[Any] = []
    rows: list[tuple[int, ...]] = []
    for pair in model.pairs:
        f, dz, normal, _, valid, *_ = model.expressions(f"contact_{pair}", t, q, u, z, m, c)
        f, dz = ca.sparsify(f), ca.sparsify(dz)
        rows.append((*f.sparsity().row(), *(nf + row for row in dz.sparsity().row())))
        items.append(ca.vertcat(ca.SX(0, 1), *f.nonzeros(), *dz.nonzeros(), normal, valid))
    grouped = alike(arguments, items, share=False)
    return None if grouped is None else _Evaluation(model, grouped, rows).functions()


_Placed: TypeAlias = tuple[Kind, list[int], Any]
_Values: TypeAlias = tuple[list[Any], list[Any], Any]


class _Evaluation:
    """Contacts of a model by kind.

    rows: of each pair, the places of its forces among generalised force and dz
    """

    _sparse = SPARSE

    def __init__(self, model: EngineModel, grouped: Alike, rows: list[tuple[int, ...]]) -> None:
        self._model, self._alike, self._rows = model, grouped, rows
        self._nf = model.function("applied").numel_out(0)
        self._places = [places for _, places, _ in self._kinds(grouped)]
        self._ladder = [rung for rung in LADDER if self._sparse * rung <= max(map(len, self._places))]
        self._most = [
            max((rung for rung in self._ladder if self._sparse * rung <= len(of)), default=0) for of in self._places
        ]

    def functions(self) -> ContactForces:
        """Build all functions."""
        t, y, mode, m, c = self._model.symbols("t y mode m c", ca.MX)
        touching, dy = ca.MX.sym("touching", 1 + sum(self._most)), ca.MX.sym("dy", y.numel())
        arguments, forces = [t, y, mode, m, c, touching], [self._forces(kind.items[0]) for kind in self._alike.kinds]
        pushes = self._alike.with_results([[*range(n)] for n in forces])
        rates = self._alike.rates(forces, 1 + len(self._states()))
        at, moving = self._inputs(t, y, m, c, dy)
        return ContactForces(
            touching=ca.Function("touching", [mode], [self._touching(mode)]),
            pushes=self._by_rung("pushes", arguments, pushes, at, []),
            contacts=self._by_rung("contacts", arguments, self._alike, at, [0, 1]),
            rates=self._by_rung("force_rates", [*arguments, dy], rates, moving, [0]),
            depends=self._depends(pushes),
            reads_memory=any(place >= self._model.nq + self._model.nu for place in pushes.taken[1]),
        )

    def _forces(self, item: int) -> int:
        """Return how many entries of generalised force and dz a pair has."""
        return len(self._rows[item])

    def _states(self) -> list[int]:
        """Return the first row in y of the inputs that are states, which follow t."""
        return [0]

    def _inputs(self, t: Any, y: Any, m: Any, c: Any, dy: Any) -> tuple[list[Any], list[Any]]:
        """Return the inputs of the items, and those of their rates."""
        return [t, y, m, c], [t, y, m, c, ca.MX(1), dy]

    def _kinds(self, grouped: Alike) -> list[_Placed]:
        """Return each kind, the pairs of its places, and what else says which item is in which place."""
        return [(kind, kind.items, None) for kind in grouped.kinds]

    def _depends(self, pushes: Alike) -> Any:
        """Return the pattern (DM) of generalised force and dz by y."""
        known = [(part, entry) for part, entries in enumerate(pushes.taken) for entry in entries]
        starts = self._states()
        at: list[int] = []
        by: list[int] = []
        for kind in pushes.kinds:
            pattern = list(zip(*kind.one.jac_sparsity(0, 0).get_triplet(), strict=True))
            for item, leaves in zip(kind.items, kind.leaves, strict=True):
                for row, column in pattern:
                    part, entry = known[leaves[column]]
                    if 1 <= part <= len(starts) and row < len(self._rows[item]):
                        at.append(self._rows[item][row])
                        by.append(starts[part - 1] + entry)
        ny = self._model.nq + self._model.nu + self._model.nz
        return ca.DM(ca.Sparsity.triplet(self._nf + self._model.nz, ny, at, by), 1)

    def _touching(self, mode: Any) -> Any:
        """Return the rung, and of each kind the places of as many touching pairs as its highest rung has."""
        kinds = [(places, most) for places, most in zip(self._places, self._most, strict=True) if most]
        if not kinds:
            return ca.MX(0)
        sizes, slots = [len(places) for places, _ in kinds], [most for _, most in kinds]
        ends, first = [*accumulate(sizes, initial=0)], [*accumulate(slots, initial=0)]
        of = [i for i, size in enumerate(sizes) for _ in range(size)]
        active = mode[[place for places, _ in kinds for place in places]] == CONTACT
        rank = ca.vertcat(0, running_sum(active))
        before = rank[ends]
        counts, place = before[1:] - before[:-1], rank[1:] - before[of]
        fits = active * (place <= ca.DM([slots[i] for i in of]))
        place = ca.if_else(fits, place + ca.DM([first[i] for i in of]), 0) - 1
        none = ca.DM([size for size, most in zip(sizes, slots, strict=True) for _ in range(most)])
        own = ca.DM([i - size for size in sizes for i in range(size)])
        rung: Any = 0
        for most in self._ladder:
            rung = rung + ca.mmax(counts[[i for i, size in enumerate(slots) if size >= most]] > most)
        return ca.vertcat(rung, added(ca.MX(none), place, own))

    def _by_rung(
        self, name: str, arguments: list[Any], grouped: Alike, inputs: list[Any], otherwise: list[float]
    ) -> Any:
        """Build the function (rung, arguments) -> sums of forces, if `grouped` has any, and values."""
        *some, every = (
            ca.Function(f"{name}_{rung or 'all'}", arguments, self._case(grouped, arguments, inputs, otherwise, rung))
            for rung in (*self._ladder, None)
        )
        return ca.Function.conditional(name, some or [every], every)

    def _case(
        self, grouped: Alike, arguments: list[Any], inputs: list[Any], otherwise: list[float], rung: int | None
    ) -> list[Any]:
        """Return the results of as many pairs of each kind as a rung has, of all if its highest has fewer."""
        _, _, mode, _, _, touching, *_ = arguments
        known = grouped.known(inputs)
        start, k = 1, self._model.k
        at: list[Any] = [ca.MX(0, 1)]
        pushes: list[Any] = [ca.MX(0, 1)]
        of_pairs = [ca.MX(ca.DM([value] * k)) for value in otherwise]
        for kind, most in zip(self._kinds(grouped), self._most, strict=True):
            forces = kind[0].one.numel_out(0) - len(otherwise)
            if rung is not None and rung <= most:
                columns, rows, places = self._at(
                    grouped, kind, known, arguments, touching[start : start + rung], forces
                )
            else:
                active = mode[kind[1]] == CONTACT
                idle = [*[0.0] * forces, *otherwise]
                values, rows, places = self._of_all(grouped, kind, known, arguments, forces)
                columns = [ca.if_else(active, x, value) for x, value in zip(values, idle, strict=True)]
            start += most
            at += [row if isinstance(row, ca.MX) else ca.MX(ca.DM(row)) for row in rows]
            pushes += columns[:forces]
            of_pairs = [
                added(column, places, values - value)
                for column, values, value in zip(of_pairs, columns[forces:], otherwise, strict=True)
            ]
        if len(pushes) == 1:
            return of_pairs
        total = added(ca.MX(self._nf + self._model.nz, 1), ca.vertcat(*at), ca.vertcat(*pushes))
        return [total[: self._nf], total[self._nf :], *of_pairs]

    def _at(self, grouped: Alike, kind: _Placed, known: Any, arguments: list[Any], slots: Any, forces: int) -> _Values:
        """Return the results of a kind in some of its places (MX), the rows of its forces and the pairs."""
        of, items, _ = kind
        columns, (*rows, pairs) = of.results_at(known, slots, [*self._columns(items, forces), tuple(items)])
        return columns, rows, pairs

    def _of_all(self, grouped: Alike, kind: _Placed, known: Any, arguments: list[Any], forces: int) -> _Values:
        """Return the results of a kind in all of its places, the rows of its forces and the pairs."""
        of, items, _ = kind
        return of.results(known), self._columns(items, forces), items

    def _columns(self, items: list[int], forces: int) -> list[tuple[int, ...]]:
        """Return columns of rows with an entry for each item."""
        return [*zip(*(self._rows[item][:forces] for item in items), strict=True)]


class _OfPlaces(_Evaluation):
    """Contacts in the places of a list of near pairs.

    The number of each place among the constants says which pair it has.
    """

    _model: NearModel
    _sparse = 2  # all places are looked up as well

    def __init__(self, model: NearModel) -> None:
        grouped, forces, memory = contacts_by_kind(model.whole)
        self._memory = [len(rows) for rows in memory]
        super().__init__(model, grouped, [tuple(rows) for rows in forces])

    def _forces(self, item: int) -> int:
        return len(self._rows[item]) + self._memory[item]

    def _states(self) -> list[int]:
        return [0, self._model.nq]

    def _inputs(self, t: Any, y: Any, m: Any, c: Any, dy: Any) -> tuple[list[Any], list[Any]]:
        whole = self._model.whole
        (q, u, _), (dq, du, _) = map(self._model.parts, (y, dy))
        at = [t, q, u, ca.DM.ones(self._alike.shared.numel_in(LATCHES)), c[: whole.nc]]
        return at, [*at, ca.MX(1), dq, du]

    def _kinds(self, grouped: Alike) -> list[_Placed]:
        return self._model.by_places(grouped)

    def _at(self, grouped: Alike, kind: _Placed, known: Any, arguments: list[Any], slots: Any, forces: int) -> _Values:
        of, places, first = kind
        _, _, _, m, c, *_ = arguments
        near, *_ = self._model.lists_of(c)

        def chosen(column: Any, otherwise: float) -> Any:
            return column if slots is None else ca.vertcat(column, otherwise).get_nz(False, slots)

        number = near[places]
        item = chosen(ca.if_else(number > NONE, number - first, len(of.items)), len(of.items))
        inputs = [(part, entry) for part, entries in enumerate(grouped.taken) for entry in entries]
        latches = {
            i: chosen(m[[entry * self._model.k + place for place in places]], 1)
            for i, (part, entry) in enumerate(inputs)
            if part == LATCHES
        }
        pushed = min(forces, len(self._rows[of.items[0]]))
        columns, rows = of.results_at(known, item, self._columns(of.items, pushed), latches)
        of_place = [tuple(self._nf + self._model.rows[j][i] for j in places) for i in range(forces - pushed)]
        (*memory, pairs) = [*of_place, tuple(places)] if slots is None else entries([*of_place, tuple(places)], slots)
        return columns, [*rows, *memory], pairs

    def _of_all(self, grouped: Alike, kind: _Placed, known: Any, arguments: list[Any], forces: int) -> _Values:
        columns, rows, pairs = self._at(grouped, kind, known, arguments, None, forces)
        return columns, rows, list(pairs)
