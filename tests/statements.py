"""Statements of a syntax tree without its expressions, of which there are thirty times as many."""

import ast
from collections.abc import Iterator

BLOCKS = ("body", "orelse", "finalbody", "handlers", "cases")


def statements(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield a tree and every statement in it, at any depth, with handlers and cases."""
    pending = [tree]
    while pending:
        node = pending.pop()
        yield node
        for block in BLOCKS:
            pending += getattr(node, block, ())
