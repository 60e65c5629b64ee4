"""Expressions that are equal but for their inputs, such as forces of many pairs, as vectors.

Derivation and CasADi's SX write every pair out. Here they are found again, by their operations: what several items
share is computed once, beforehand; the rest of each is a function of its leaves, which are inputs or shared values.
Items of equal operations are one kind: evaluated over all of them by operations on vectors, the C text of which is
that of one, or block by block where most of them are not wanted.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import Any

import casadi as ca

FEW = 4  # items of a kind from which operations on vectors cost less than each item's own


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

    def results(self, known: Any) -> list[Any]:
        """Return each result of all items, as vectors (MX), from inputs and shared values."""
        n = len(self.items)
        if n < FEW:
            columns = ca.horzcat(*(self.one(known[places]) for places in self.leaves))
            return [columns[i, :].T for i in range(self.one.numel_out(0))]
        gathered = []
        for places in zip(*self.leaves, strict=True):
            same = len(set(places)) == 1
            gathered.append(known[places[0]] if same else known[list(places)])
        work: dict[int, Any] = {}
        found: list[Any] = [None] * self.one.numel_out(0)
        for operation, places, target, constant in _instructions(self.one):
            if operation == ca.OP_INPUT:
                work[target] = gathered[places[1]]
            elif operation == ca.OP_OUTPUT:
                value = work[places[0]]
                found[target[1]] = value if value.numel() == n else ca.repmat(value, n, 1)
            elif operation == ca.OP_CONST:
                work[target] = ca.MX(constant)
            else:
                work[target] = _apply(ca.MX, operation, [work[place] for place in places])
        return found


@dataclass(frozen=True, eq=False)
class Alike:
    """Items by kind. `shared`: (inputs, one vector) -> values that several items need."""

    shared: Any
    kinds: list[Kind]

    def known(self, inputs: Any) -> Any:
        """Return inputs and shared values in one vector, of which kinds take their leaves."""
        return ca.vertcat(inputs, self.shared(inputs))

    def results(self, inputs: Any) -> list[Any]:
        """Return each result of all items in their order (MX); the items must have equally many."""
        known = self.known(inputs)
        by_kind = [kind.results(known) for kind in self.kinds]
        return [ca.vertcat(*column)[self.order] for column in zip(*by_kind, strict=True)]

    @property
    def order(self) -> list[int]:
        """Place of every item in a column of all kinds."""
        items = [item for kind in self.kinds for item in kind.items]
        return sorted(range(len(items)), key=items.__getitem__)


def alike(given: list[Any], items: list[Any]) -> Alike | None:
    """Find the kinds of items, SX columns of results; None where one calls a function.

    Functions that are embedded, such as a search for the nearest point of a curve, are not operations on vectors.
    """
    inputs = ca.SX.sym("inputs", sum(part.numel() for part in given))
    ends = list(accumulate((part.numel() for part in given), initial=0))
    parts = [inputs[start:end] for start, end in pairwise(ends)]
    whole = ca.Function("items", [inputs], ca.Function("parts", given, items).call(parts))
    nodes: list[tuple[int, tuple[int, ...], Any]] = []  # operation, arguments, constant or place of an input
    roots: list[list[int]] = [[-1] * item.numel() for item in items]
    work: dict[int, int] = {}
    for operation, places, target, constant in _instructions(whole):
        if operation == ca.OP_CALL:
            return None
        if operation == ca.OP_OUTPUT:
            roots[target[0]][target[1]] = work[places[0]]
            continue
        leaf = operation in (ca.OP_INPUT, ca.OP_CONST)
        nodes.append(
            (
                operation,
                () if leaf else tuple(work[i] for i in places),
                places[1] if operation == ca.OP_INPUT else constant,
            )
        )
        work[target] = len(nodes) - 1
    users = [0] * len(nodes)  # bits: the items that need a node
    for item, of_item in enumerate(roots):
        for node in of_item:
            users[node] |= 1 << item
    for node in range(len(nodes) - 1, -1, -1):
        for argument in nodes[node][1]:
            users[argument] |= users[node]
    is_shared = [
        bool(arguments) and user & (user - 1) != 0 for user, (_, arguments, _) in zip(users, nodes, strict=True)
    ]
    shared: dict[int, int] = {}
    found: dict[tuple[Any, ...], tuple[list[int], list[list[int]]]] = {}
    for item, of_item in enumerate(roots):
        form, leaves = _form(nodes, of_item, is_shared)
        numbers, of_items = found.setdefault(form, ([], []))
        numbers.append(item)
        of_items.append([
            nodes[leaf][2] if nodes[leaf][0] == ca.OP_INPUT
            else inputs.numel() + shared.setdefault(leaf, len(shared)) for leaf in leaves
        ])  # fmt: skip
    values = [ca.SX(0)] * len(nodes)
    for i, (operation, arguments, constant) in enumerate(nodes):
        if operation == ca.OP_INPUT:
            values[i] = inputs[constant]
        else:
            values[i] = ca.SX(constant) if not arguments else _apply(ca.SX, operation, [values[j] for j in arguments])
    column = ca.vertcat(ca.SX(0, 1), *(values[node] for node in shared))
    kinds = [Kind(numbers, leaves, _function(form, len(leaves[0]))) for form, (numbers, leaves) in found.items()]
    return Alike(ca.Function("shared", [inputs], [column]), kinds)


def over_items(function: Any) -> Any:
    """Return an SX function of columns with an entry for each item by operations on vectors (MX).

    The function itself where another is embedded.
    """
    given, symbols = function.sx_in(), function.mx_in()
    columns = map(ca.vertsplit, function.call(given))
    found = alike(given, [ca.vertcat(*entries) for entries in zip(*columns, strict=True)])
    if found is None:
        return function
    return ca.Function(function.name(), symbols, found.results(ca.vertcat(*symbols)))


def _form(
    nodes: list[tuple[int, tuple[int, ...], Any]], roots: list[int], is_shared: list[bool]
) -> tuple[tuple[Any, ...], list[int]]:
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
            lines.append(("leaf", len(leaves)))
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
    return ca.Function("one", [leaves], [ca.densify(ca.vertcat(*(values[i] for i in results)))])


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
