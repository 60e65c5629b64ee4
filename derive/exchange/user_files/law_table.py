"""Tables of a law file as pydantic models: each key, text and number by itself.

Relations between entries are checked in `lawfile`. Imported only where a file of laws is read: importing pydantic
takes a good part of a second.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    ValidationError,
    model_validator,
)

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.file_schema import MisfitError, form_faults
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.dimension.expression import Expression, TextError
from hertzwerk.derive.expressions.dimension.reader import read
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import FORMS, GRADES

_NOT_IN_LAWS = ("diff", "integrate", "matrix", "@", "transpose", "inv", "det", "trace", "and", "or", "not", "==", "!=")


# --- texts and numbers ------------------------------------------------------------------------------------------------


def _printable(text: str) -> str:
    if len(text) > 2000 or not text.isprintable():
        raise ValueError
    return text


def _source(text: str) -> str:
    if not _printable(text).strip():
        raise MisfitError("where the law comes from", found="none")
    return text


def _name(name: str) -> str:
    if not name.isascii() or any(name_faults("", name)):
        raise ValueError
    if name in LAWS:
        raise MisfitError("a name of its own", found=f"{name!r}, the name of a built-in law")
    return name


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


def _forms(forms: Any) -> tuple[str, ...]:
    words = forms if isinstance(forms, list) else [forms]
    if words == ["any"]:
        return FORMS
    if not words or not all(word in FORMS for word in words):
        raise ValueError
    return tuple(words)


def _expression(text: Any) -> Expression:
    """Parse an expression of a law."""
    try:
        return _scalar(text)
    except TextError as error:
        raise MisfitError(error.expected, error.remedy, error.found, f"character {error.position}") from error


def _scalar(text: Any) -> Expression:
    """Parse a scalar expression without what laws do not have; raises TextError."""
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
    grade: Annotated[str, Field(pattern=f"^[{''.join(GRADES)}]$", description=f"one of {', '.join(GRADES)}")] = "C"
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
            actual = f"verdict {self.verdict} and fitted_in {self.fitted_in!r}"
            raise MisfitError("the units of the fit, fitted_in, with verdict outside_si alone", found=actual)
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
            actual = "no factor or term" if self.factor is None else "factor and term"
            raise MisfitError("the factor or the term", found=actual)
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


def schemas() -> dict[str, dict[str, Any]]:
    """JSON schema of the table of a law, by its kind."""
    return {kind: model.model_json_schema() for kind, model in _KINDS.items()}


def validated(where: str, table: Mapping[str, Any]) -> tuple[LawTable | None, list[Fault]]:
    """Validated table of one law, or None and all its faults."""
    kind = table.get("kind")
    model = _KINDS.get(kind) if isinstance(kind, str) else None
    if model is None:
        actual = "none" if kind is None else shown(kind, 60)
        return None, [Fault(f"{where}, kind", actual, f"one of {', '.join(_KINDS)}")]
    try:
        return model.model_validate(table), []
    except ValidationError as error:
        return None, form_faults(error, model, where, {f"{name} law": other for name, other in _KINDS.items()})
