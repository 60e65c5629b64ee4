"""Formulas of outputs, parameters, quantities: text that is read, never executed, of proven unit."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.derive.common.units import UnitError, parse_quantity, unit_text
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.derive.expressions.dimension.tree import Node

NAME = re.compile(r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*")
CALLED = re.compile(r"\s*\(")
ALIAS = "output_"  # and a number: an output's name where text has no dots
QUANTITY = "quantity__"  # and a number: a quantity where text has no units
_WORD = r"[A-Za-zµΩ]+(?:\^-?[0-9.]+)?"
_QUANTITY = re.compile(rf"(?<![\w.])((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?) +({_WORD}(?:[/* ]{_WORD})*)")
_FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: getattr(ca, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan")},
    **{"sinh": ca.sinh, "cosh": ca.cosh, "tanh": ca.tanh, "abs": ca.fabs, "atan2": ca.atan2},
    **{"neg": lambda x: -x, "inverse": lambda x: 1 / x, "**": ca.power},
    "sum": lambda *parts: sum(parts),
    "product": lambda first, *others: ca.SX(first) if not others else first * _FUNCTIONS["product"](*others),
    "max": lambda first, *others: first if not others else ca.fmax(first, _FUNCTIONS["max"](*others)),
    "min": lambda first, *others: first if not others else ca.fmin(first, _FUNCTIONS["min"](*others)),
}


@dataclass(frozen=True)
class Formula:
    """Expression of outputs and parameters: `names` are those it has, `unit` is its SI unit text.

    quantities    SI values that it states
    """

    text: str
    names: tuple[str, ...]
    unit: str
    root: Node | None
    quantities: tuple[float, ...] = ()

    def __call__(self, values: Mapping[str, float]) -> float:
        """Return the value where its names have these values, SI."""
        return float(self._functions[0]([values[name] for name in self.names]))

    def gradient(self, values: Mapping[str, float]) -> np.ndarray:
        """Return the derivatives (names,) with respect to its names."""
        return np.array(self._functions[1]([values[name] for name in self.names])).ravel()

    @property
    def switches(self) -> bool:
        """Whether it has a maximum, a minimum or a magnitude, whose derivative jumps where another takes over."""
        return self.root is not None and any(node.op in ("max", "min", "abs") for node in self.root.walk())

    @cached_property
    def _functions(self) -> tuple[Any, Any]:
        x = ca.SX.sym("x", len(self.names))
        known = {f"{QUANTITY}{i}": ca.SX(value) for i, value in enumerate(self.quantities)}
        known |= {f"{ALIAS}{i}": x[i] for i in range(len(self.names))}
        value = x[0] if self.root is None else _evaluated(self.root, known)
        value, gradient = (ca.densify(of) for of in (ca.SX(value), ca.jacobian(value, x)))
        return ca.Function("formula", [x], [value]), ca.Function("gradient", [x], [gradient])


def names_in(text: object) -> list[str]:
    """Return the names of outputs and parameters in a formula's text, each once."""
    if not isinstance(text, str):
        return []
    written, _ = _without_quantities(text)
    words = (match[0] for match in NAME.finditer(written) if not _function(match, written))
    return list(dict.fromkeys(word for word in words if not word.startswith(QUANTITY)))


def _without_quantities(text: str) -> tuple[str, list[str]]:
    """Return a text with names in place of its quantities, numbers followed by a unit, and these."""
    quantities: list[str] = []

    def named(match: re.Match[str]) -> str:
        pieces = re.split(r"([/* ])", match[2])
        for k in range(len(pieces), 0, -2):  # the longest unit: what follows may be a factor
            quantity = f"{match[1]} {''.join(pieces[:k])}"
            try:
                parse_quantity(quantity)
            except UnitError:
                continue
            quantities.append(quantity)
            return f"{QUANTITY}{len(quantities) - 1}{''.join(pieces[k:])}"
        return match[0]

    return _QUANTITY.sub(named, text), quantities


def read_formula(where: str, text: object, units: Mapping[str, str], faults: list[Fault]) -> Formula | None:
    """Read a formula of names with SI unit texts; None with faults appended, or where a name has no unit."""
    names = names_in(text)
    if not isinstance(text, str) or not text.strip():
        faults.append(Fault(where, shown(text), 'an output or a formula, such as "guide.acceleration.rms**2"'))
        return None
    if any(name not in units for name in names):
        return None
    if not names:
        faults.append(Fault(where, shown(text), "the name of an output in it", "a constant has no minimum"))
        return None
    if text.strip() == names[0]:
        return Formula(text.strip(), (names[0],), units[names[0]], None)
    aliases = {name: f"{ALIAS}{i}" for i, name in enumerate(names)}
    plain, quantities = _without_quantities(text)
    written = NAME.sub(
        lambda match: match[0] if _function(match, plain) or match[0] not in aliases else aliases[match[0]], plain
    )
    values = [parse_quantity(quantity) for quantity in quantities]
    from hertzwerk.runtime.engine.model import build

    def restored(message: str) -> str:
        message = re.sub(rf"{QUANTITY}(\d+)", lambda match: quantities[int(match[1])], message)
        return re.sub(rf"{ALIAS}(\d+)", lambda match: names[int(match[1])], message)

    try:
        of_names = {aliases[name]: units[name] or "1" for name in names}
        of_values = {f"{QUANTITY}{i}": unit_text(unit.exponents) for i, (_, unit) in enumerate(values)}
        root, finding = build.read_expression(written, of_names | of_values)
    except InputError as error:
        faults += [Fault(where, restored(f.found), restored(f.expected), restored(f.remedy)) for f in error.faults]
        return None
    if finding.verdict != "consistent":
        actual = f"{restored(finding.subexpression)}: {restored(finding.found)}"
        faults.append(Fault(where, actual, finding.expected or "one unit", restored(finding.repair or finding.reason)))
        return None
    others = {node.op for node in root.walk()} - {*_FUNCTIONS, "number", "name", "pi"}
    if others:
        faults.append(Fault(where, ", ".join(sorted(others)), f"formulas with {', '.join(sorted(_FUNCTIONS))}"))
        return None
    return Formula(text.strip(), tuple(names), "" if finding.found == "1" else finding.found, root,
                   tuple(unit.to_si(value) for value, unit in values))  # fmt: skip


def _function(match: re.Match[str], text: str) -> bool:
    """Return whether a word of a text is a function's name, pi, or part of a number such as 1e3."""
    if match[0] == "pi" or CALLED.match(text, match.end()):
        return True
    before = text[match.start() - 1] if match.start() else ""
    return before.isdigit() or before == "."


def _evaluated(node: Node, known: Mapping[str, Any]) -> Any:
    """Return a tree's CasADi expression in those of its names."""
    if node.op == "name":
        return known[node.name]
    if node.op in ("number", "pi"):
        return ca.SX(float(node.number) if node.op == "number" else np.pi)
    return _FUNCTIONS[node.op](*(_evaluated(part, known) for part in node.args))
