"""Faults of parameters and quantities: names, units, ranges."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.units import parse_unit, rate_remedy, unit_text
from hertzwerk.derive.declare.effects.state_expression import as_choice, smoothness_faults, tables_in
from hertzwerk.derive.declare.mechanism.pose import Posed, PoseSymbol
from hertzwerk.derive.expressions.algebra.splines import Spline
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.walker import check
from hertzwerk.derive.expressions.parameter import Parameter, Slot, default_value, is_number, parameters_of

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


def declared(scene: Scene) -> tuple[dict[str, Parameter], list[Fault]]:
    """Parameters by name, and the faults of their declarations."""
    parameters: dict[str, Parameter] = {}
    faults: list[Fault] = []
    for parameter in (p for slot in scene.declarations() for p in parameters_of(slot.value)):
        where = f"parameter {parameter.name}"
        if parameters.setdefault(parameter.name, parameter) != parameter:
            faults.append(Fault(where, "two different parameters of this name", "names that are unique",
                               "Share one Parameter object, or rename one."))  # fmt: skip
        faults.extend(parameter.faults())
    readable = [p for p in parameters.values() if not any(fault.where == f"parameter {p.name}" for fault in faults)]
    for parameter in readable:
        faults.extend(_exponent_faults(parameter, parameters))
    return parameters, faults


def _exponent_faults(parameter: Parameter, parameters: dict[str, Parameter]) -> Iterator[Fault]:
    for name in parameter.parsed_unit.free_names:
        where, actual = f"parameter {parameter.name}", f"unit {parameter.unit} with the exponent {name}"
        if name not in parameters:
            yield Fault(where, actual, "a parameter of the scene as exponent",
                        f"Declare Parameter({name!r}, '1', ...) and use it.")  # fmt: skip
        elif parameters[name].unit != "1":
            yield Fault(where, f"{actual}, which is in {parameters[name].unit}", "an exponent whose unit is 1")


def sound_of(parameters: dict[str, Parameter], broken: list[Fault]) -> dict[str, Parameter]:
    """Parameters without a fault in their own declaration or that of an exponent in their unit."""
    wrong = {fault.where for fault in broken}
    good = {name: p for name, p in parameters.items() if f"parameter {name}" not in wrong}
    return {name: p for name, p in good.items() if all(other in good for other in p.parsed_unit.free_names)}


def quantity_faults(slot: Slot, table: dict[sp.Symbol, Dimension]) -> Iterator[Fault]:
    """Yield faults of the type, unit and range of a quantity's value."""
    if not is_number(slot.value):
        yield Fault(slot.where, repr(slot.value), "a Parameter, an expression of parameters, or a number",
                    "A quantity with a unit is declared: Parameter(name, unit, value).")  # fmt: skip
        return
    value, unit = sp.sympify(slot.value), parse_unit(slot.unit)
    strangers = [
        str(node) for node in sp.preorder_traversal(value) if node.is_Symbol and not isinstance(node, Parameter)
    ]
    if strangers:
        yield Fault(slot.where, f"the symbol {strangers[0]}", "an expression of Parameters alone")
        return
    if value.is_number and value != 0 and not unit.dimensionless:
        yield Fault(slot.where, f"the bare number {slot.value}", f"a quantity in {slot.unit}",
                    f"Give it a name and a unit: Parameter('...', {slot.unit!r}, {slot.value}).")  # fmt: skip
        return
    if not value.is_number and not unit.free_names:
        fault = check(value, table, Dimension.from_unit(unit, {}), list(table))
        if fault is not None:
            yield Fault(slot.where, f"{fault.subexpression} [{fault.found}]", f"a quantity in {unit_text(unit.exponents)}",
                        fault.repair or fault.reason)  # fmt: skip
            return
    number = default_value(value)
    if not math.isfinite(number):
        yield Fault(slot.where, f"{value}, which at the defaults is no finite real number", "a finite number")
    elif slot.limit is not None and not slot.limit.holds(number):
        shown = f"{number:g}" if unit.dimensionless else f"{number:g} {unit_text(unit.exponents)}"
        yield Fault(slot.where, shown, f"a value in {slot.limit}")


def rate_faults(slot: Slot) -> Iterator[Fault]:
    """Yield faults of a frequency in place of an angular speed, or the reverse.

    For a parameter, or the values of a table, alone or as a term of a sum.
    """
    declared = parse_unit(slot.unit)
    for term in sp.Add.make_args(sp.sympify(slot.value)) if is_number(slot.value) else ():
        node = -term if term.could_extract_minus_sign() else term
        if isinstance(node, Parameter):
            name, text = node.name, node.unit
        elif isinstance(node, Spline) and node.args[2] == 0 and not any(node.args[0].faults()):
            name, text = str(node.args[0]), node.args[0].units[1]
        else:
            continue
        unit = parse_unit(text)
        if unit.mistaken_for(declared):
            kind = "an angular speed" if unit.angle else "a frequency"
            yield Fault(slot.where, f"{name} [{text}], {kind}", f"a quantity in {slot.unit}", rate_remedy(unit))


def posed_faults(slot: Posed, table: dict[sp.Symbol, Dimension]) -> Iterator[Fault]:
    """Yield faults of an expression of the pose in a user's pair, or of a curve's parameter."""
    if not is_number(slot.value):
        yield Fault(slot.where, repr(slot.value), f"a number, or an expression of {slot.words} and parameters")
        return
    value = as_choice(slot.value)
    splines = tables_in(value)
    if splines and not slot.tables:
        yield Fault(slot.where, f"the table {splines[0].name}", "an expression of APART, TURN and Parameters without tables",
                    "A gap that is a distance has the slope of its surface in it, whose second rate is a third derivative: a spline has two. "
                    "Give the surface as a Curve.")  # fmt: skip
        return
    if any(fault for spline in splines for fault in spline.faults()):
        return  # which `table_faults` reports
    pose = {
        node: Dimension.from_unit(node.unit) for node in sp.preorder_traversal(value) if isinstance(node, PoseSymbol)
    }
    if not pose and not splines:
        yield from quantity_faults(slot, table)
        return
    strangers = sorted(str(s) for s in value.free_symbols if not isinstance(s, Parameter) and s not in slot.symbols)
    if strangers:
        yield Fault(
            slot.where, f"the symbol {', '.join(strangers)}", f"an expression of {slot.words} and Parameters alone"
        )
        return
    unit = parse_unit(slot.unit)
    fault = check(value, {**table, **pose}, Dimension.from_unit(unit, {}), list(table))
    if fault is not None:
        yield Fault(
            slot.where,
            f"{fault.subexpression} [{fault.found}]",
            f"a quantity in {slot.unit}",
            fault.repair or fault.reason,
        )
        return
    yield from smoothness_faults(slot, value)
