"""Scenario files: a scene's numbers and its checks, read from TOML and validated as a whole.

scene = "soft_ball"
duration = "1 s"
[parameters]
drop_height = "0.5 m"
[[checks]]
quantity = "impacts.0.speed"
expected = "3.132092 m/s"
tolerance = 1e-6
source = "sqrt(2 g h)"
"""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from hertzwerk.derive.faults import Fault, InputError, shown, unknown
from hertzwerk.derive.files.tomlfile import read_toml
from hertzwerk.derive.units import UnitError, parse_quantity
from hertzwerk.runtime.integrate.tableaux.methods import METHODS
from hertzwerk.runtime.model.build import is_file
from hertzwerk.runtime.run.request import METHOD
from hertzwerk.runtime.validate import scenarios

IMPACT_FIELDS = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m", "duration": "s"}
FOUND_IN_HISTORIES = ("final", "max", "min", "largest")


def si(text: str) -> float:
    """Return the SI value of quantity text such as "24 ms"; raises UnitError."""
    value, unit = parse_quantity(text)
    return value * unit.factor


def _quantity_text(text: str) -> str:
    try:
        finite = math.isfinite(si(text))
    except UnitError as error:
        raise ValueError(str(error)) from error
    if not finite:
        raise ValueError(f"{text!r} is not finite")
    return text


def _method(name: str) -> str:
    if name not in METHODS:
        raise ValueError(f"{name!r} is no method; there are {', '.join(METHODS)}")
    return name


def _measurable(text: str) -> str:
    head, _, rest = text.partition(".")
    index, _, field = rest.partition(".")
    known = (
        text in ("energy_residual", "impacts")
        or (head == "impacts" and re.fullmatch("[0-9]{1,9}", index) and field in IMPACT_FIELDS)
        or (head in FOUND_IN_HISTORIES and rest)
    )
    if not known:
        raise ValueError(
            f"{text!r} is no quantity; write impacts (their number), impacts.N.FIELD with N from 0 and FIELD one of "
            f"{', '.join(IMPACT_FIELDS)}; final.NAME, max.NAME, min.NAME or largest.NAME (of either sign) of a state or a contact force; "
            "energy_residual"
        )
    return text


def _duration_text(text: str) -> str:
    value, unit = parse_quantity(_quantity_text(text))
    if not value > 0 or unit.exponents != parse_quantity("1 s")[1].exponents:
        raise ValueError(f"{text!r} is no duration; write a positive time with its unit, such as '24 ms'")
    return text


QuantityText = Annotated[str, AfterValidator(_quantity_text)]


class _Record(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class Check(_Record):
    """Check of one number: `expected` within the relative `tolerance`, or not above `at_most`."""

    quantity: Annotated[str, AfterValidator(_measurable)]
    expected: QuantityText | None = None
    tolerance: Annotated[float, Field(gt=0)] | None = None
    at_most: QuantityText | None = None
    source: Annotated[str, Field(min_length=1)]

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        within = self.expected is not None and self.tolerance is not None and self.at_most is None
        below = self.at_most is not None and self.expected is None and self.tolerance is None
        if not (within or below):
            raise ValueError("a check has either expected and tolerance, or at_most")
        if self.expected is not None and si(self.expected) == 0:
            raise ValueError("the tolerance is relative: for an expected zero write at_most")
        return self


class Scenario(_Record):
    """Scene with parameters, initial state, duration, accuracy, expected outcome and checks."""

    scene: str
    duration: Annotated[str, AfterValidator(_duration_text)]
    accuracy: Annotated[float, Field(ge=1e-12, le=1e-1)] = 1e-6
    method: Annotated[str, AfterValidator(_method)] = METHOD
    parameters: dict[str, QuantityText] = {}
    initial: dict[str, QuantityText] = {}
    outcome: Literal["finished", "beyond_horizon", "accuracy_unreachable"] = "finished"  # that must come out
    checks: tuple[Check, ...] = Field(default=(), strict=False)


def load_scenario(target: str | Path) -> Scenario:
    """Load a built-in scenario by name, or one from a TOML file.

    A scene file is named relative to the TOML file's folder. Raises InputError with every fault.
    """
    path = Path(target)
    if path.suffix != ".toml":
        if str(target) not in scenarios.names():
            raise InputError("scenario", [unknown("scenario", str(target), scenarios.names(), "or a TOML file")])
        return _validated(f"scenario {target}", scenarios.read(str(target)))
    scenario = _validated(str(path), read_toml(path, "scene, duration, parameters and checks"))
    named_from_here = {"scene": str(path.parent / scenario.scene)} if is_file(scenario.scene) else {}
    return scenario.model_copy(update=named_from_here)


def _validated(subject: str, content: dict[str, object]) -> Scenario:
    try:
        return Scenario.model_validate(content)
    except ValidationError as error:
        faults = [
            Fault(
                ".".join(map(str, fault["loc"])) or "scenario",
                shown(fault["input"]),
                fault["msg"].removeprefix("Value error, "),
            )
            for fault in error.errors(include_url=False)
        ]
        raise InputError(subject, faults) from error
