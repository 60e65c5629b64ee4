"""Faults of names, texts and units: invalid names, text that cannot be printed or is no unit."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Any

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.units import UnitError, parse_unit

MAX_BYTES = 120
"""Longest name in UTF-8: names become file names too, with a suffix."""

_EXPECTED = "an identifier: letters, digits and _, a letter first, no keyword of Python"


def name_faults(where: str, name: Any) -> Iterator[Fault]:
    """Faults of a name that is used in generated code, in file names and on the command line."""
    if not isinstance(name, str):
        yield Fault(where, f"the name {name!r:.80}", _EXPECTED)
    elif len(name.encode(errors="replace")) > MAX_BYTES:
        yield Fault(where, f"a name of {len(name)} characters, {name[:20]!r}...", f"at most {MAX_BYTES} bytes")
    elif not name.isidentifier() or keyword.iskeyword(name) or name.startswith("_"):
        yield Fault(where, f"the name {name!r}", _EXPECTED)
    elif (plain := unicodedata.normalize("NFKC", name)) != name:
        yield Fault(where, f"the name {name!r}, typed in another way than Python reads it", f"{plain!r}",
                    "Characters such as ligatures are taken apart in code, where two names would become one.")  # fmt: skip


def text_faults(where: str, text: Any) -> Iterator[Fault]:
    """Faults of a text that is shown: no string, or with characters that do not print."""
    if not isinstance(text, str):
        yield Fault(where, f"{text!r:.80}", "text")
        return
    strange = next((c for c in re.sub(r"[ \t\r\n]", "", text) if not c.isprintable()), None)
    if strange is not None:
        yield Fault(
            where, f"the character U+{ord(strange):04X} in place {text.index(strange) + 1}", "text that can be printed"
        )


def repeated(kind: str, names: Iterable[str]) -> Iterator[Fault]:
    """Faults of names that are invalid or not unique."""
    for name, count in Counter(names).items():
        yield from name_faults(kind, name)
        if count > 1:
            yield Fault(f"{kind} {name}", f"{count} of this name", "names that are unique", "Rename one of them.")


def unit_faults(where: str, unit: Any, expected: str = "a unit", *, constant: bool = False) -> Iterator[Fault]:
    """Yield the fault of a text that is no unit or, where it must be `constant`, has a symbolic exponent."""
    try:
        if parse_unit(unit).free_names and constant:
            yield Fault(where, f"unit {shown(unit)}", f"{expected} without a symbolic exponent")
    except UnitError as error:
        yield Fault(where, f"unit {shown(unit)}", expected, str(error))
