"""Tables of a law file as pydantic models: each key, text and number by itself.

Relations between entries are checked in `lawfile`. Imported only where a file of laws is read: importing pydantic
takes a good part of a second.
"""

from __future__ import annotations

import difflib
import re
import sys
from typing import Annotated, Any, Literal, Self

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    TypeAdapter,
    ValidationError,
    model_validator,
)

from hertzwerk.derive.dimension.expression import Expression, TextError
from hertzwerk.derive.dimension.reader import read
from hertzwerk.derive.faults import Fault, shown
from hertzwerk.derive.identifiers import name_faults
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import FORMS, GRADES
from hertzwerk.derive.units import parse_unit

__all__ = ["LawTable", "SymbolTable", "validated"]

_NOT_IN_LAWS = ("diff", "integrate", "matrix", "@", "transpose", "inv", "det", "trace", "and", "or", "not", "==", "!=")


class _WrongError(ValueError):
    """An invalid value: found, expected, and remedy."""

    def __init__(self, found: str, expected: str, remedy: str = "") -> None:
        super().__init__(found)
        self.found, self.expected, self.remedy = found, expected, remedy


# --- texts and numbers ------------------------------------------------------------------------------------------------


def _printable(text: str) -> str:
    if len(text) > 2000 or not text.isprintable():
        raise ValueError
    return text


def _source(text: str) -> str:
    if not _printable(text).strip():
        raise _WrongError("none", "where the law comes from")
    return text


def _name(name: str) -> str:
    if not name.isascii() or any(name_faults("", name)):
        raise ValueError
    if name in LAWS:
        raise _WrongError(f"{name!r}, the name of a built-in law", "a name of its own")
    return name


def _grade(letter: str) -> str:
    if letter not in GRADES:
        raise ValueError
    return letter


def _unit(text: str) -> str:
    parse_unit(text)
    return text


def _interval(text: Any) -> tuple[str, ...]:
    """Parse an interval to bracket, bound, bound, bracket."""
    written = re.fullmatch(r"\s*([\[(])([^,]*),([^,]*)([\])])\s*", text) if isinstance(text, str) else None
    if written is None:
        raise ValueError
    return tuple(part.strip() for part in written.groups())


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) <= sys.float_info.max:
        raise ValueError
    return value if abs(value) < 2**53 else float(value)


def _forms(given: Any) -> tuple[str, ...]:
    words = given if isinstance(given, list) else [given]
    if words == ["any"]:
        return FORMS
    if not words or not all(word in FORMS for word in words):
        raise ValueError
    return tuple(words)


def _expression(text: Any) -> Expression:
    """Parse an expression of a law; raises TextError."""
    expression = read(repr(text) if isinstance(text, (int, float)) and not isinstance(text, bool) else text)
    for node in expression.root.walk():
        written = expression.quote(node)[:40]
        if node.op in _NOT_IN_LAWS:
            expected = "operations on scalars, and comparisons < <= > >="
            raise TextError(expression.source, node.start, f"{node.op!r} in {written!r}", expected)
        if node.op == "LambertW" and len(node.args) == 1:
            raise TextError(expression.source, node.start, repr(written), "the lower branch, LambertW(x, -1)")
    if expression.root.condition:
        raise TextError(expression.source, 0, f"the comparison {expression.source[:40]!r}", "a quantity")
    return expression


Text = Annotated[str, AfterValidator(_printable), Field(description="printable text")]
Name = Annotated[str, AfterValidator(_name), Field(description="a name of letters, digits and _, a letter first")]
Source = Annotated[str, AfterValidator(_source), Field(description="where the law comes from")]
UnitText = Annotated[str, AfterValidator(_unit), Field(description="a unit such as 'N/m^1.5', '1' for a number")]
Bounds = Annotated[Any, PlainValidator(_interval), Field(description="an interval such as '(0, 1]' or '[0, inf)'")]
Number = Annotated[Any, PlainValidator(_number), Field(description="a finite number, in the unit of the symbol")]
Written = Annotated[Any, PlainValidator(_expression), Field(description="an expression")]
Forms = Annotated[
    Any,
    PlainValidator(_forms),
    Field(
        description=f"the form of contact it is for: one of {', '.join(FORMS)}, a list of them, or any, as for a power law whose stiffness is given"
    ),
]


# --- tables -----------------------------------------------------------------------------------------------------------


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class SymbolTable(_Table):
    """A symbol: its unit and meaning, limits of its value, a default of the law's own."""

    unit: UnitText
    meaning: Text = ""
    limits: Bounds = None
    default: Number = None


class DefinitionTable(_Table):
    """An intermediate result: symbol, unit, meaning and expression."""

    symbol: Annotated[str, Field(description="a name")]
    unit: UnitText
    meaning: Text = ""
    expression: Written


class RangeTable(_Table):
    """Ranges of a symbol: defined (outside is an error) or recommended (outside is a warning)."""

    defined: Bounds = None
    recommended: Bounds = None


class LawTable(_Table):
    """Fields of every [[law]] table, without the expressions of its kind."""

    kind: str
    name: Name
    title: Text = ""
    source: Source
    grade: Annotated[str, AfterValidator(_grade), Field(description=f"one of {', '.join(GRADES)}")] = "C"
    verdict: Literal["consistent", "inconsistent", "outside_si"] = "consistent"
    fitted_in: Text = ""
    repair: Text = ""
    note: Text = ""
    form: Forms = None
    symbols: Annotated[dict[str, SymbolTable], Field(description="a table of symbols, each with unit and meaning")] = {}
    definitions: Annotated[
        list[DefinitionTable], Field(description="a list of tables with symbol, unit, meaning and expression")
    ] = []
    ranges: Annotated[
        dict[str, RangeTable], Field(description="a table of symbols, each with defined or recommended")
    ] = {}

    @model_validator(mode="after")
    def _fit(self) -> Self:
        if (self.verdict == "outside_si") != bool(self.fitted_in):
            found = f"verdict {self.verdict} and fitted_in {self.fitted_in!r}"
            raise _WrongError(found, "the units of the fit, fitted_in, with verdict outside_si alone")
        return self


class _Stiffness(LawTable):
    kind: Literal["stiffness"]
    form: Forms
    force: Annotated[Written, Field(description="the force")]
    relation: Written = None
    stored: Written = None
    reach: Written = None
    exponent: Written = None


class _Damping(LawTable):
    kind: Literal["damping"]
    factor: Written = None
    term: Written = None
    exponent: Written = None
    release: Annotated[
        Literal["force", "gap"],
        Field(
            description="force or gap: force ends the contact where the normal force falls to zero, gap where it opens"
        ),
    ] = "force"

    @model_validator(mode="after")
    def _one_force(self) -> Self:
        if (self.factor is None) == (self.term is None):
            found = "no factor or term" if self.factor is None else "factor and term"
            raise _WrongError(found, "the factor or the term")
        return self


class _Friction(LawTable):
    kind: Literal["friction"]
    force: Annotated[Written, Field(description="the force")]
    slope: Written = None


class _Film(LawTable):
    kind: Literal["film"]
    along: Annotated[Written, Field(description="the drag along the squeeze velocity")]
    across: Annotated[Written, Field(description="the drag across the squeeze velocity")]
    couple: Annotated[Written, Field(description="the drag against the spin")]


_KINDS: dict[str, type[LawTable]] = {"stiffness": _Stiffness, "damping": _Damping, "friction": _Friction, "film": _Film}
_INSIDE: dict[Any, type[_Table]] = {"symbols": SymbolTable, "definitions": DefinitionTable, "ranges": RangeTable}
_ADAPTER: TypeAdapter[LawTable] = TypeAdapter(
    Annotated[_Stiffness | _Damping | _Friction | _Film, Field(discriminator="kind")]
)


def validated(where: str, table: Any) -> tuple[LawTable | None, list[Fault]]:
    """Validated table of one law, or None and all its faults."""
    try:
        return _ADAPTER.validate_python(table), []
    except ValidationError as error:
        return None, [_fault(where, row) for row in error.errors(include_url=False)]


def _fault(where: str, row: Any) -> Fault:
    """Convert one error of pydantic to a fault."""
    kind, *path = row["loc"] or ("",)
    if kind == "":
        found = (
            "none" if row["type"] == "union_tag_not_found" else shown(row.get("ctx", {}).get("tag", row["input"]), 60)
        )
        return Fault(f"{where}, kind", found, f"one of {', '.join(_KINDS)}")
    inner = next((_INSIDE[key] for key in path[:1] if key in _INSIDE and len(path) == 3), None)
    model = inner or _KINDS[kind]
    key = path[-1] if path else ""
    place = f"{where}, {'.'.join(map(str, path))}" if path else where
    if row["type"] == "extra_forbidden":
        place = f"{where}, {'.'.join(map(str, path[:-1]))}" if path[1:] else where
        return Fault(
            place, f"the key {key!r}", f"one of {', '.join(sorted(model.model_fields))}", _remedy(str(key), model)
        )
    cause = row.get("ctx", {}).get("error")
    if isinstance(cause, TextError):
        return Fault(f"{place}, character {cause.position}", cause.found, cause.expected, cause.remedy)
    if isinstance(cause, _WrongError):
        return Fault(place, cause.found, cause.expected, cause.remedy)
    field = model.model_fields.get(str(key)) if len(path) != 2 else None
    found = "none" if row["type"] == "missing" else shown(row["input"], 60)
    literal = str(row.get("ctx", {}).get("expected", "")).replace("'", "").replace(" or ", ", ")
    described = (field.description if field is not None else None) or (f"one of {literal}" if literal else "")
    return Fault(
        place, found, described or f"a table with {', '.join(_INSIDE[path[0]].model_fields)}", str(cause or "")
    )


def _remedy(key: str, model: type[BaseModel]) -> str:
    if model not in _KINDS.values():
        return model.__doc__ or ""
    elsewhere = [kind for kind, other in _KINDS.items() if key in other.model_fields]
    close = difflib.get_close_matches(key, sorted(model.model_fields), n=1)
    return f"it belongs to a {elsewhere[0]} law" if elsewhere else f"did you mean {close[0]}?" if close else ""
