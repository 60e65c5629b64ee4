"""Faults of a file's form: errors of pydantic's models, in terms of the descriptions of their fields.

Imported only where such a file is read: importing pydantic takes a good part of a second.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import NoneType, UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from hertzwerk.derive.common.faults import Fault, shown, unknown


class MisfitError(ValueError):
    """An entry that is not as `expected`, with a remedy.

    found   what it is, where the entry itself does not show it
    at      place within the entry, such as "character 4"
    """

    def __init__(self, expected: str, remedy: str = "", found: str = "", at: str = "") -> None:
        super().__init__(expected)
        self.expected, self.remedy, self.found, self.at = expected, remedy, found, at


def form_faults(
    error: ValidationError, model: type[BaseModel], where: str = "", others: Mapping[str, type[BaseModel]] | None = None
) -> list[Fault]:
    """One fault for each place of a record that is not as its model describes it.

    where    place of the record in the file
    others   models by the names of records in which an unknown key may belong
    """
    faults: dict[str, Fault] = {}
    for row in error.errors(include_url=False):
        fault = _fault(row, model, where, others or {})
        faults.setdefault(fault.where, fault)  # of a union every member has its say about one place
    return [*faults.values()]


def _fault(row: Any, model: type[BaseModel], where: str, others: Mapping[str, type[BaseModel]]) -> Fault:
    path, owner, annotation, expected = [], model, model, ""
    for part in row["loc"]:
        if _is_model(annotation):
            owner, expected = annotation, ""
        inner = _within(annotation, part)
        if inner is None:  # an unknown key, one of a few numbers, or pydantic's own word for a member of a union
            break
        path.append(str(part))
        annotation, description = _unwrapped(inner)
        expected = description or expected
    key, kind = str(row["loc"][-1]) if row["loc"] else "", row["type"]
    place = ", ".join(filter(None, (where, ".".join([*path, key] if kind == "extra_forbidden" else path)))) or "file"
    cause = row.get("ctx", {}).get("error")
    if kind == "extra_forbidden":
        home = next((f"it belongs to a {name}" for name, other in others.items() if key in other.model_fields), "")
        fault = unknown("key", key, owner.model_fields)
        return replace(fault, where=place, remedy=home or fault.remedy)
    if isinstance(cause, MisfitError):
        actual = cause.found or shown(row["input"], 60)
        return Fault(f"{place}, {cause.at}" if cause.at else place, actual, cause.expected, cause.remedy)
    if not expected and _is_model(annotation):
        text = (annotation.__doc__ or "").rstrip(".")
        expected = text[:1].lower() + text[1:]
    choice = str(row.get("ctx", {}).get("expected", "")).replace("'", "")
    actual = "none" if kind == "missing" else shown(row["input"], 60)
    return Fault(place, actual, expected or choice or row["msg"].removeprefix("Input should be "), str(cause or ""))


def _is_model(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, BaseModel)


def _within(annotation: Any, part: str | int) -> Any:
    """Annotation of an entry of a record, table or list; None where there is none."""
    origin, args = get_origin(annotation), get_args(annotation)
    if _is_model(annotation):
        field = annotation.model_fields.get(part)
        return None if field is None else Annotated[field.annotation, field]
    if origin is dict:
        return args[1]
    return args[0] if origin is list or (origin is tuple and Ellipsis in args) else None


def _unwrapped(annotation: Any) -> tuple[Any, str]:
    """An annotation without what it is wrapped in, and the description found there."""
    origin, args = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        inner, text = _unwrapped(args[0])
        own = [extra.description for extra in args[1:] if isinstance(extra, FieldInfo) and extra.description]
        return inner, own[-1] if own else text
    some = [arg for arg in args if arg is not NoneType]
    return _unwrapped(some[0]) if origin in (Union, UnionType) and len(some) == 1 else (annotation, "")
