"""Laws written as text with values: `power(K=1e9 N/m^1.3, n=1.3) x flores`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import UnitError, parse_unit, split_quantity
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws.law import BoundLaw, Law

_CALL = re.compile(r"\s*([^()=]+?)\s*\((.*)\)\s*", re.DOTALL)
_BETWEEN = re.compile(r"\s+x\s+(?![^()]*\))")  # as in the list of effects, and not within parentheses


def split_laws(text: str) -> list[str]:
    """Split laws of one effect that are joined by ` x `."""
    return _BETWEEN.split(text.strip())


def split_call(text: str) -> tuple[str, dict[str, str]]:
    """Split into the law's name and its values as text by symbol. Raises InputError with every fault."""
    written = _CALL.fullmatch(text)
    if written is None:
        return text.strip(), {}
    where = f"law {written[1]}"
    values: dict[str, str] = {}
    faults = []
    for part in filter(str.strip, written[2].split(",")):
        symbol, equals, value = (piece.strip() for piece in part.partition("="))
        if not (symbol and equals and value) or symbol in values:
            faults.append(Fault(where, repr(part.strip()), "SYMBOL=VALUE, each symbol once"))
        values[symbol] = value
    refuse(where, faults)
    return written[1], values


def bound_law(
    law: Law, texts: Mapping[str, str], shared: Mapping[str, Any], effect: str, parameters: Mapping[str, Parameter]
) -> BoundLaw:
    """Bind a law to the values in `texts`, for other symbols to those `shared` by name or defaults.

    A quantity becomes a parameter `<effect>_<symbol>` of the scene, a number without a unit a constant, and the name
    of one of the scene's `parameters` stands for it. Raises InputError with every fault: values that cannot be read,
    symbols without a value.
    """
    symbols = {symbol.name: symbol for symbol in law.parameters}
    faults, bindings = [], {symbol.name: value for symbol, value in law.defaults} | dict(shared)
    for name, text in texts.items():
        where = f"effect {effect}, {name} of {law.name}"
        if name not in symbols:
            expected = f"some of {', '.join(symbols) or 'none'}"
            faults.append(Fault(where, "a symbol that the law does not take", expected))
        elif text in parameters:
            bindings[name] = parameters[text]
        else:
            try:
                number, unit = split_quantity(text)
                parse_unit(unit)
            except UnitError as error:
                expected = f"a quantity in {symbols[name].unit}, or the name of a parameter of the scene"
                faults.append(Fault(where, repr(text), expected, str(error)))
                bindings[name] = None
                continue
            bindings[name] = (
                number if unit == "1" else Parameter(f"{effect}_{name}", unit, number, symbols[name].meaning)
            )
    missing = [symbol for symbol in law.parameters if symbol.name not in bindings]
    if missing:
        values = ", ".join(f"{symbol.name} [{symbol.unit}], {symbol.meaning}" for symbol in missing)
        faults.append(Fault(f"effect {effect}", f"no value for {values}", f"all parameters of {law.name}",
                            f"Give them with the law, {law.name}({', '.join(f'{s.name}=...' for s in missing)}): a quantity, "
                            "or the name of a parameter of the scene."))  # fmt: skip
    refuse(f"law {law.name}", faults)
    return law(**{symbol.name: bindings[symbol.name] for symbol in law.parameters})
