"""Parser of laws written with values on the command line: `power_damping(chi=1e5 N s/m^2.5, m=1.5)`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.laws.law import Law
from hertzwerk.derive.mechanism.parameter import Parameter
from hertzwerk.derive.units import UnitError, parse_unit, split_quantity

_CALL = re.compile(r"\s*(\w+)\s*\((.*)\)\s*")


def split_call(text: str) -> tuple[str, dict[str, str]]:
    """Split into the law's name and its values as text by symbol. Raises InputError."""
    written = _CALL.fullmatch(text)
    if written is None:
        return text, {}
    values: dict[str, str] = {}
    for part in filter(str.strip, written[2].split(",")):
        symbol, equals, value = (piece.strip() for piece in part.partition("="))
        if not (symbol and equals and value) or symbol in values:
            raise InputError(
                f"law {written[1]}", [Fault(f"law {written[1]}", repr(part.strip()), "SYMBOL=VALUE, each symbol once")]
            )
        values[symbol] = value
    return written[1], values


def values_of(law: Law, texts: Mapping[str, str], effect: str) -> dict[str, Any]:
    """Convert the values of a law from text. Raises InputError.

    A quantity becomes a parameter `<effect>_<symbol>` of the scene, a number without a unit a constant.
    """
    symbols = {symbol.name: symbol for symbol in law.parameters}
    faults, found = [], {}
    for name, text in texts.items():
        where = f"effect {effect}, {name} of {law.name}"
        if name not in symbols:
            faults.append(
                Fault(where, "a symbol that the law does not take", f"some of {', '.join(symbols) or 'none'}")
            )
            continue
        try:
            number, unit = split_quantity(text)
            parse_unit(unit)
        except UnitError as error:
            faults.append(Fault(where, repr(text), f"a quantity in {symbols[name].unit}", str(error)))
            continue
        bare = unit == "1"
        found[name] = number if bare else Parameter(f"{effect}_{name}", unit, number, symbols[name].meaning)
    if faults:
        raise InputError(f"law {law.name}", faults)
    return found
