"""Dimensional audit of one expression: its dimension, or the smallest sub-expression without one.

The rules of `rules.SIGNATURES` are applied from the leaves upwards to the tree of a text or of a SymPy expression;
nothing is simplified, and only exponents are evaluated.

    dimension_of(expr, table, constants) -> Dimension            raises DimensionError, which carries the fault
    check(expr, table, expected, constants) -> DimensionFault | None
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.dimension.dimension import (
    ONE,
    ZERO,
    Dimension,
    DimensionError,
    DimensionFault,
    canonical,
)
from hertzwerk.derive.expressions.dimension.expression import Expression
from hertzwerk.derive.expressions.dimension.repair import repair
from hertzwerk.derive.expressions.dimension.rules import NOUNS, SIGNATURES, Signature
from hertzwerk.derive.expressions.dimension.symbolic import Symbolic, as_immutable, symbolic
from hertzwerk.derive.expressions.dimension.tree import Node

_WHOLE = Signature("alike", "same")
_COMPLEX = dict.fromkeys(
    ("re", "im"),
    "SymPy's Abs of a power whose base may be negative; omit the Abs of what is positive, or take Where(x > 0, ..)",
)


class Walker:
    """Walk over trees; the first node without a dimension raises DimensionError."""

    def __init__(self, tree: Expression | Symbolic, table: Mapping[Any, Dimension], constants: Collection[Any]) -> None:
        self.tree = tree
        self.table = table
        self.constants = constants
        self.memo: dict[Node, Dimension] = {}

    def result(self, root: Node, expected: Dimension | None) -> Dimension:
        """Dimension of a whole tree; raises DimensionError if it is not the expected one."""
        if expected is not None:  # of two unlike terms the one without the expected dimension is at fault
            self.expect(root, expected)
        return self(root)

    def __call__(self, node: Node) -> Dimension:
        """Dimension of a node; raises DimensionError."""
        dimension = self.table.get(node.name) if node.op == "name" else self.memo.get(node)
        if dimension is None:
            dimension = self.memo[node] = self.tree.bounded(node, self.rule(node))
        return dimension

    def rule(self, node: Node) -> Dimension:
        """Dimension by the rule of the operation."""
        rule = SIGNATURES.get(node.op)
        if rule is None:
            known = ("a declared unit", "its unit is not declared")
            if node.op != "name":
                known = ("a known operation", _COMPLEX.get(node.op, f"the audit has no rule for {node.op}"))
            raise self.fault(node, "unknown", *known)
        if not isinstance(rule, Signature):
            return rule(self, node)
        if rule.arguments == "alike":
            common = self.alike(node, node.args)
            return common if rule.result == "same" else ONE
        for arg in node.args:
            if not self(arg).dimensionless and rule.arguments == "pure":
                raise self.pure(node, arg, f"{node.op} takes a dimensionless argument")
        return ONE

    def dimensions(self, node: Node, args: Sequence[Node]) -> list[Dimension]:
        """Dimension of each argument.

        In a sum, logarithms that together are one of a number, log(a) - log(b) = log(a/b), have the dimension of
        their factors.
        """
        logarithms = [self.logarithm_in(arg) for arg in args] if node.op == "sum" else []
        if not any(logarithms):
            return [self(arg) for arg in args]
        keys = [None if log is None else tuple(sorted(map(self.tree.quote, log[0]))) for log in logarithms]
        inside: dict[Any, Dimension] = {}
        for key, log in zip(keys, logarithms, strict=True):
            if log is not None:
                inside[key] = inside.get(key, ONE) * self(log[2]) ** log[1]
        dimensions = []
        for arg, key, log in zip(args, keys, logarithms, strict=True):
            total = ONE
            for factor in (arg,) if log is None or not inside[key].dimensionless else log[0]:
                total = total * self(factor)
            dimensions.append(total)
        return dimensions

    def logarithm_in(self, node: Node) -> tuple[tuple[Node, ...], Any, Node] | None:
        """Factors, rational coefficient and argument of a product with one logarithm, else None.

        2*x*log(a) -> ((x,), 2, a).
        """
        if node.op == "neg":
            logarithm = self.logarithm_in(node.args[0])
            return None if logarithm is None else (logarithm[0], -logarithm[1], logarithm[2])
        factors = node.args if node.op == "product" else (node,)
        logarithms = [factor for factor in factors if factor.op == "log"]
        if len(logarithms) != 1:
            return None
        share = sp.Mul(*(canonical(factor.number) for factor in factors if factor.number is not None))
        others = tuple(factor for factor in factors if factor is not logarithms[0] and factor.number is None)
        return None if share == 0 else (others, share, logarithms[0].args[0])

    def alike(self, node: Node, args: Sequence[Node], expected: Dimension | None = None) -> Dimension:
        """Common dimension of all arguments; raises DimensionError if they differ.

        The most frequent one is expected, in a tie not that of a number, which may hide a unit; but the 1 of 1 + h*v is
        right.
        """
        dimensions = self.dimensions(node, args)
        if dimensions and all(dimension is dimensions[0] for dimension in dimensions):
            return dimensions[0]
        counts = {dimension: dimensions.count(dimension) for dimension in dimensions if not dimension.every}
        if len(counts) <= 1:
            return next(iter(counts), ZERO)
        others = [arg for arg in args if not (arg.op == "number" and arg.number == 1)]
        one = node.op == "sum" and len(others) < len(args) and all(arg.op != "name" for arg in others)
        expected = expected or max(counts, key=lambda dimension: (counts[dimension], (dimension == ONE) == one))
        odd, actual = next(pair for pair in zip(args, dimensions, strict=True) if not pair[1].matches(expected))
        other = next((d for d in dimensions if d == expected), next(d for d in counts if d != actual))
        if node.op == "sum":  # up to the first term that does not fit
            node = self.tree.part(node, range(max(dimensions.index(actual), dimensions.index(other)) + 1))
        noun = NOUNS.get(node.op, node.op)
        reason = f"{self.tree.quote(odd)} is {actual} beside {other}, and {noun} takes operands of one unit"
        raise self.fault(node, actual, expected, f"in {self.tree.quote(node)}, {reason}", odd, args)

    def pure(self, node: Node, arg: Node, rule: str) -> DimensionError:
        """Fault of an argument that should be dimensionless."""
        dimension = self(arg)
        reason = f"in {self.tree.quote(node)}, {self.tree.quote(arg)} is {dimension}, and {rule}"
        return self.fault(node, dimension, ONE, reason, arg, (arg,))

    def fault(
        self,
        node: Node,
        found: Dimension | str,
        expected: Dimension | str,
        reason: str,
        culprit: Node | None = None,
        operands: Sequence[Node] = (),
    ) -> DimensionError:
        """Fault at a node, with a repair of its culprit."""
        exponent, way_out, missing = None, None, None
        if culprit is not None and isinstance(found, Dimension) and isinstance(expected, Dimension):
            exponent, way_out = repair(self, culprit, found, expected)
            missing = expected / found
        texts = tuple(dict.fromkeys((self.tree.quote(operand), str(self(operand))) for operand in operands))
        quoted = self.tree.quote(node)
        return DimensionError(
            DimensionFault(quoted, texts, str(found), str(expected), reason, exponent, way_out, missing)
        )

    def expect(self, node: Node, expected: Dimension) -> None:
        """Raise DimensionError unless the node has the dimension.

        The fault is at the wrong term of a sum or branch, where only some are wrong.
        """
        if node.op == "neg":
            return self.expect(node.args[0], expected)
        terms = _branches(node)
        dimensions = self.dimensions(node, terms)
        wrong = [not dimension.matches(expected) for dimension in dimensions]
        if any(wrong) and not (all(wrong) and len(set(dimensions)) == 1):
            term = terms[wrong.index(True)]
            if (
                not term.args or self.logarithm_in(term) is not None
            ):  # a symbol by itself is never wrong: quote the sum or branch
                self.alike(node, terms, expected)
            self.expect(term, expected)
        if node.op == "product":
            self.expect_sum(node, expected)
        actual = self(node)
        if actual.matches(expected):
            return None
        if (
            node.op == "product"
        ):  # a dimensionless sum as factor, (1 + h*v/v0), cannot be at fault and would only obscure it
            suspects = [k for k, factor in enumerate(node.args) if not self.never_at_fault(factor)]
            node = self.tree.part(node, suspects) if suspects else node
        factors = node.args if node.op == "product" else (node,)
        bases = [factor.args[0] if factor.op in ("inverse", "**") else factor for factor in factors]
        reason = f"{self.tree.quote(node)} is {actual}, expected {expected}"
        raise self.fault(
            node, actual, expected, reason, node, [base for base in bases if base.op not in ("number", "pi")]
        )

    def expect_sum(self, product: Node, expected: Dimension) -> None:
        """Raise DimensionError at the term of a sum that is not what the other factors leave to it.

        In K*d**n*(1 + h*v/t), a force, the 1 is right.
        """
        unlike = []
        rest = expected
        for factor in product.args:
            try:
                rest = rest / self(factor)
            except DimensionError:
                unlike.append(factor)
        if len(unlike) != 1:
            return
        (factor,) = unlike
        if factor.op == "inverse":
            factor, rest = factor.args[0], ONE / rest
        if factor.op == "sum" and any(dimension == rest for dimension in self.dimensions(factor, factor.args)):
            self.expect(factor, rest)

    def never_at_fault(self, factor: Node) -> bool:
        """Whether a factor is a dimensionless sum, or a power of one."""
        inner = factor.args[0] if factor.op in ("inverse", "**") else factor
        return inner.op == "sum" and self(inner).dimensionless


def _branches(node: Node) -> Sequence[Node]:
    """Operands that must each have the dimension of the whole."""
    if node.op == "where":
        return [arg for arg in node.args if not arg.condition]
    return node.args if SIGNATURES.get(node.op) == _WHOLE else ()


# --- audit of SymPy expressions ---------------------------------------------------------------------------------------


def dimension_of(expr: Any, table: Mapping[Any, Dimension], constants: Collection[Any] = ()) -> Dimension:
    """Dimension of a SymPy expression; `table` declares its symbols, `constants` those in exponents.

    Raises DimensionError, whose `fault` names the smallest sub-expression without a dimension.
    """
    return Walker(Symbolic(), table, constants)(symbolic(as_immutable(expr)))


def check(
    expr: Any, table: Mapping[Any, Dimension], expected: Dimension | None, constants: Collection[Any] = ()
) -> DimensionFault | None:
    """Fault of a SymPy expression that has not the expected dimension, or none at all; else None."""
    try:
        Walker(Symbolic(), table, constants).result(symbolic(as_immutable(expr)), expected)
    except DimensionError as error:
        return error.fault
    return None
