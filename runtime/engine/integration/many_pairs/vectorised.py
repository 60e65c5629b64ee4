"""Expressions that are equal but for their inputs, such as forces of many pairs, as vectors.

Derivation and CasADi's SX write every pair out. Here they are found again, by their operations: what several items
share is computed once, beforehand; the rest of each is a function of its leaves, which are inputs or shared values.
Items of equal operations are one kind: evaluated over all of them by operations on vectors, the C text of which is
that of one, or block by block where most of them are not wanted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import casadi as ca

FEW = 4  # items of a kind from which operations on vectors cost less than each item's own


Node: TypeAlias = tuple[int, tuple[int, ...], Any]  # operation, arguments, constant or place of an input


@dataclass(frozen=True, eq=False)
class Kind:
    """Items of equal operations.

    items    their numbers
    leaves   of each item the places of its leaves among inputs and shared values
    one      (leaves) -> results of an item
    """

    items: list[int]
    leaves: list[list[int]]
    one: Any

    def with_results(self, results: list[int]) -> Kind:
        """Return the kind with some of its results, and the leaves of these alone."""
        leaves = ca.SX.sym("leaves", self.one.numel_in(0))
        one = ca.Function("one", [leaves], [self.one(leaves)[results]])
        used = sorted({places[1] for operation, places, *_ in _instructions(one) if operation == ca.OP_INPUT})
        own, whole = ca.SX.sym("leaves", len(used)), ca.SX.zeros(leaves.numel())
        whole[used] = own
        return Kind(self.items, [[of[i] for i in used] for of in self.leaves], ca.Function("one", [own], [one(whole)]))

    def results(self, known: Any) -> list[Any]:
        """Return each result of all items, as vectors (MX), from inputs and shared values."""
        if len(self.items) < FEW:
            columns = ca.horzcat(*(self.one(known[places]) for places in self.leaves))
            return [columns[i, :].T for i in range(self.one.numel_out(0))]
        columns = zip(*self.leaves, strict=True)
        gathered = [known[of[0]] if len(set(of)) == 1 else known[list(of)] for of in columns]
        return self._over(gathered, len(self.items))

    def results_at(
        self, known: Any, slots: Any, places: list[tuple[int, ...]], own: Mapping[int, Any] | None = None
    ) -> tuple[list[Any], list[Any]]:
        """Return each result of the items in `slots` alone, and their entries in columns of places.

        slots    their places among `items` (MX)
        places    columns with an entry for each item. A slot that no item has, the number of items, has results that mean
                  nothing, and negative places
        own    columns, with an entry for each slot, that stand for some of the known values
        """
        n, own = slots.numel(), own or {}
        columns = list(zip(*self.leaves, strict=True))
        varying = [i for i, of in enumerate(columns) if len(set(of)) > 1]
        selected = entries([columns[i] for i in varying] + places, slots)
        leaves = known.get_nz(False, ca.vertcat(ca.MX(0, 1), *selected[: len(varying)]))
        gathered = [own[of[0]] if of[0] in own else known[of[0]] for of in columns]
        for i, column in zip(varying, ca.vertsplit(leaves, n) if varying else [], strict=True):
            gathered[i] = column
        if n > 1:
            return self._over(gathered, n), selected[len(varying) :]
        return ca.vertsplit(self.one(ca.vertcat(*gathered))), selected[len(varying) :]

    def _over(self, gathered: list[Any], n: int) -> list[Any]:
        """Return each result of n items, as vectors (MX), from columns of their leaves."""
        work: dict[int, Any] = {}
        values: list[Any] = [None] * self.one.numel_out(0)
        for operation, places, target, constant in _instructions(self.one):
            if operation == ca.OP_INPUT:
                work[target] = gathered[places[1]]
            elif operation == ca.OP_OUTPUT:
                value = work[places[0]]
                values[target[1]] = value if value.numel() == n else ca.repmat(value, n, 1)
            elif operation == ca.OP_CONST:
                work[target] = ca.MX(constant)
            else:
                work[target] = _apply(ca.MX, operation, [work[place] for place in places])
        return values


@dataclass(frozen=True, eq=False)
class Alike:
    """Items by kind.

    taken    places of each input that are leaves
    shared   (inputs) -> values that several items need
    """

    taken: list[list[int]]
    shared: Any
    kinds: list[Kind]

    def known(self, inputs: list[Any]) -> Any:
        """Return leaves among the inputs, and shared values, in one vector: kinds take theirs from it."""
        parts = [
            part if places == [*range(part.numel())] else part[places]
            for part, places in zip(inputs, self.taken, strict=True)
            if places
        ]
        return ca.vertcat(*parts, self.shared(*inputs))

    def with_results(self, results: list[list[int]]) -> Alike:
        """Return the items with some of their results, by kind.

        Inputs that these do not need may be anything.
        """
        some = [kind.with_results(of) for kind, of in zip(self.kinds, results, strict=True)]
        used = sorted({place for kind in some for leaves in kind.leaves for place in leaves})
        known = [(part, entry) for part, entries in enumerate(self.taken) for entry in entries]
        place = {old: new for new, old in enumerate(used)}
        taken = [
            [entry for i, (part, entry) in enumerate(known) if part == k and i in place] for k in range(len(self.taken))
        ]
        arguments = self.shared.sx_in()
        column = self.shared(*arguments)[[old - len(known) for old in used if old >= len(known)]]
        kinds = [Kind(kind.items, [[place[i] for i in of] for of in kind.leaves], kind.one) for kind in some]
        return Alike(taken, ca.Function("shared", arguments, [column]), kinds)

    def rates(self, results: list[int], moving: int) -> Alike:
        """Return the items with the rate of one of their results, by kind; nothing may be shared.

        The first `moving` inputs have rates, which are further inputs.
        """
        known = [(part, entry) for part, entries in enumerate(self.taken) for entry in entries]
        rate = {
            place: len(known) + i for i, place in enumerate(i for i, (part, _) in enumerate(known) if part < moving)
        }
        kinds = []
        for kind, result in zip(self.kinds, results, strict=True):
            leaves = ca.SX.sym("leaves", kind.one.numel_in(0))
            moved = [i for i, place in enumerate(kind.leaves[0]) if place in rate]
            own, along = ca.SX.sym("rates", len(moved)), ca.SX(leaves.numel(), 1)
            along[moved] = own
            one = ca.densify(ca.jtimes(kind.one(leaves)[result], leaves, along))
            both = ca.vertcat(leaves, own)
            places = [[*of, *(rate[of[i]] for i in moved)] for of in kind.leaves]
            kinds.append(Kind(kind.items, places, ca.Function("one", [both], [ca.cse(one)])))
        arguments = self.shared.sx_in()
        arguments += [ca.SX.sym("rate", part.numel()) for part in arguments[:moving]]
        shared = ca.Function("shared", arguments, [ca.SX(0, 1)])
        return Alike([*self.taken, *self.taken[:moving]], shared, kinds).with_results([[0]] * len(kinds))

    def results(self, inputs: list[Any]) -> list[Any]:
        """Return each result of all items in their order (MX); the items must have equally many."""
        known = self.known(inputs)
        by_kind = [kind.results(known) for kind in self.kinds]
        return [ca.vertcat(*column)[self.order] for column in zip(*by_kind, strict=True)]

    @property
    def order(self) -> list[int]:
        """Place of every item in a column of all kinds."""
        items = [item for kind in self.kinds for item in kind.items]
        return sorted(range(len(items)), key=items.__getitem__)


def alike(symbols: list[Any], items: list[Any], *, share: bool = True) -> Alike | None:
    """Find the kinds of items, SX columns of results; None where one calls a function.

    Functions that are embedded, such as a search for the nearest point of a curve, are not operations on vectors.

    share    what several items need is computed once, for all of them; else by each item for itself
    """
    whole = ca.Function("items", symbols, items)
    nodes: list[Node] = []
    roots: list[list[int]] = [[-1] * item.numel() for item in items]
    work: dict[int, int] = {}
    for operation, places, target, constant in _instructions(whole):
        if operation == ca.OP_CALL:
            return None
        if operation == ca.OP_OUTPUT:
            roots[target[0]][target[1]] = work[places[0]]
            continue
        is_leaf = operation in (ca.OP_INPUT, ca.OP_CONST)
        arguments = () if is_leaf else tuple(work[i] for i in places)
        nodes.append((operation, arguments, tuple(places) if operation == ca.OP_INPUT else constant))
        work[target] = len(nodes) - 1
    is_shared = _shared(nodes, roots) if share else [False] * len(nodes)
    shared: dict[int, int] = {}
    forms: dict[tuple[Any, ...], tuple[list[int], list[list[int]]]] = {}
    for item, of_item in enumerate(roots):
        form, leaves = _form(nodes, of_item, is_shared)
        numbers, of_items = forms.setdefault(form, ([], []))
        numbers.append(item)
        of_items.append(leaves)
        for leaf in leaves:
            if nodes[leaf][0] != ca.OP_INPUT:
                shared.setdefault(leaf, len(shared))
    used = {leaf for _, of_items in forms.values() for of in of_items for leaf in of}
    inputs = sorted(used - shared.keys(), key=lambda leaf: nodes[leaf][2])
    place = {leaf: i for i, leaf in enumerate([*inputs, *shared])}
    taken = [[nodes[leaf][2][1] for leaf in inputs if nodes[leaf][2][0] == i] for i in range(len(symbols))]
    kinds = [
        Kind(numbers, [[place[leaf] for leaf in of] for of in of_items], _function(form, len(of_items[0])))
        for form, (numbers, of_items) in forms.items()
    ]
    return Alike(taken, ca.Function("shared", symbols, [_values(symbols, nodes, [*shared])]), kinds)


def _values(symbols: list[Any], nodes: list[Node], wanted: list[int]) -> Any:
    """Return the values of some nodes (SX)."""
    values: list[Any] = []
    for operation, arguments, constant in nodes if wanted else ():
        if operation == ca.OP_INPUT:
            values.append(symbols[constant[0]].nz[constant[1]])
        else:
            values.append(
                ca.SX(constant) if not arguments else _apply(ca.SX, operation, [values[j] for j in arguments])
            )
    return ca.vertcat(ca.SX(0, 1), *(values[node] for node in wanted))


def _shared(nodes: list[Node], roots: list[list[int]]) -> list[bool]:
    """Return which operations several items need."""
    nobody, several = -1, -2
    user = [nobody] * len(nodes)

    def needs(node: int, item: int) -> None:
        if user[node] != item:
            user[node] = item if user[node] == nobody else several

    for item, of_item in enumerate(roots):
        for node in of_item:
            needs(node, item)
    for node in range(len(nodes) - 1, -1, -1):
        for argument in nodes[node][1] if user[node] != nobody else ():
            needs(argument, user[node])
    return [bool(arguments) and of == several for of, (_, arguments, _) in zip(user, nodes, strict=True)]


def over_items(function: Any) -> Any:
    """Return an SX function of columns with an entry for each item by operations on vectors (MX).

    The function itself where another is embedded.
    """
    arguments, symbols = function.sx_in(), function.mx_in()
    columns = map(ca.vertsplit, function.call(arguments))
    grouped = alike(arguments, [ca.vertcat(*entries) for entries in zip(*columns, strict=True)])
    if grouped is None:
        return function
    return ca.Function(function.name(), symbols, grouped.results(symbols))


def _form(nodes: list[Node], roots: list[int], is_shared: list[bool]) -> tuple[tuple[Any, ...], list[int]]:
    """Return an item's operations, numbered from its leaves up, and its leaves in the order met."""
    number: dict[int, int] = {}
    lines: list[tuple[Any, ...]] = []
    leaves: list[int] = []
    stack = [*reversed(roots)]
    while stack:
        node = stack[-1]
        if node in number:
            stack.pop()
            continue
        operation, arguments, constant = nodes[node]
        if is_shared[node] or operation == ca.OP_INPUT:
            lines.append(("leaf", len(leaves), None if arguments else constant[0]))
            leaves.append(node)
        elif not arguments:
            lines.append(("constant", constant))
        elif missing := [argument for argument in arguments if argument not in number]:
            stack += reversed(missing)
            continue
        else:
            lines.append((operation, *(number[argument] for argument in arguments)))
        number[node] = len(lines) - 1
        stack.pop()
    return (*lines, ("results", *(number[root] for root in roots))), leaves


def entries(columns: list[tuple[int, ...]], slots: Any) -> list[Any]:
    """Return the entries of columns of numbers at places (MX); a negative number where there are none.

    Columns that differ by a number are looked up once.
    """
    base: dict[tuple[int, ...], int] = {}
    of = [base.setdefault(tuple(x - column[0] for x in column), len(base)) for column in columns]
    if not columns:
        return []
    count, n = len(base), slots.numel()
    table = [x for row in zip(*base, strict=True) for x in row] + [-(2**30)] * count
    rows = ca.MX(ca.DM(table)).get_nz(False, ca.vec(ca.repmat(count * slots.T, count, 1) + ca.DM(range(count))))
    entries = ca.vec(rows[[count * slot + i for i in of for slot in range(n)]])  # of one row CasADi makes a row
    return ca.vertsplit(entries + ca.DM([column[0] for column in columns for _ in range(n)]), n)


def _function(form: tuple[Any, ...], size: int) -> Any:
    """Build the SX function (leaves) -> results of an item's operations."""
    leaves, values = ca.SX.sym("leaves", size), []
    *lines, (_, *results) = form
    for operation, *arguments in lines:
        if operation == "leaf":
            values.append(leaves[arguments[0]])
        elif operation == "constant":
            values.append(ca.SX(arguments[0]))
        else:
            values.append(_apply(ca.SX, operation, [values[i] for i in arguments]))
    return ca.Function("one", [leaves], ca.cse([ca.densify(ca.vertcat(*(values[i] for i in results)))]))


def _apply(kind: Any, operation: int, arguments: list[Any]) -> Any:
    return (kind.unary if len(arguments) == 1 else kind.binary)(operation, *arguments)


def _instructions(function: Any) -> Iterator[tuple[int, Any, Any, Any]]:
    """Yield operation, places of its arguments and of its result, and constant.

    The place of a result of the function is its number and its entry.
    """
    for k in range(function.n_instructions()):
        operation, places, target = (
            function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        )  # fmt: skip
        constant = function.instruction_constant(k) if operation == ca.OP_CONST else None
        yield operation, places, tuple(target) if operation == ca.OP_OUTPUT else target[0], constant
