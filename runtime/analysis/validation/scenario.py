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

import contextlib
import math
import re
from collections.abc import Mapping
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse, unknown
from hertzwerk.derive.common.file_schema import MisfitError, form_faults
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.derive.common.units import parse_quantity, parse_unit, rate_remedy
from hertzwerk.runtime.analysis.validation import scenarios
from hertzwerk.runtime.engine.inputs.input_values import INPUTS, located, with_input_values
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.model.build import located_target
from hertzwerk.runtime.engine.run.run_request import METHOD, Settings, check
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.loading import engine_model

IMPACT_FIELDS = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m", "duration": "s"}
HISTORY_REDUCTIONS = ("final", "max", "min", "largest")


def si(text: str) -> float:
    """Return the SI value of quantity text such as "24 ms"; raises UnitError."""
    value, unit = parse_quantity(text)
    return value * unit.factor


QUANTITY = 'text with a unit, such as "0.3 m/s"'
DURATION = 'a positive time or revolutions, such as "24 ms" or "200 rev"'


def _quantity_text(text: str) -> str:
    if not math.isfinite(si(text)):
        raise MisfitError("a finite number with its unit")
    return text


def _method(name: str) -> str:
    if name not in METHODS:
        raise MisfitError(f"one of {', '.join(METHODS)}")
    return name


def _measurable(text: str) -> str:
    head, _, rest = text.partition(".")
    index, _, field = rest.partition(".")
    known = (
        text in ("energy_residual", "impacts")
        or (head == "impacts" and re.fullmatch("[0-9]{1,9}", index) and field in IMPACT_FIELDS)
        or (head in HISTORY_REDUCTIONS and rest)
    )
    if not known:
        raise MisfitError(
            f"impacts (their number), impacts.N.FIELD with N from 0 and FIELD one of {', '.join(IMPACT_FIELDS)}; final.NAME, "
            "max.NAME, min.NAME or largest.NAME (of either sign) of a state or a contact force; energy_residual"
        )
    return text


def _duration_text(text: str) -> str:
    value, unit = parse_quantity(_quantity_text(text))
    turns = unit.dimensionless and unit.angle == 1
    if not value > 0 or not (turns or unit.exponents == parse_quantity("1 s")[1].exponents):
        raise MisfitError(DURATION)
    return text


QuantityText = Annotated[str, AfterValidator(_quantity_text), Field(description=QUANTITY)]


class _Record(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class Check(_Record):
    """Check of one number: `expected` within the relative `tolerance`, or not above `at_most`."""

    quantity: Annotated[
        str, AfterValidator(_measurable), Field(description='what is measured, such as "impacts.0.speed"')
    ]
    expected: QuantityText | None = None
    tolerance: Annotated[float, Field(gt=0, description="a number above zero, relative to what is expected")] | None = (
        None
    )
    at_most: QuantityText | None = None
    source: Annotated[str, Field(min_length=1, description="text that says where the number comes from")]

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        within = self.expected is not None and self.tolerance is not None and self.at_most is None
        below = self.at_most is not None and self.expected is None and self.tolerance is None
        if not (within or below):
            raise MisfitError("either expected and tolerance, or at_most")
        if self.expected is not None and si(self.expected) == 0:
            raise MisfitError("at_most for an expected zero", "the tolerance is relative")
        return self


class Scenario(_Record):
    """Scene with parameters, initial state, duration, accuracy, expected outcome and checks."""

    scene: Annotated[str, Field(description="the name of a scene, or its file")]
    duration: Annotated[str, AfterValidator(_duration_text), Field(description=DURATION)]
    accuracy: Annotated[float, Field(ge=1e-12, le=1e-1, description="a number in 1e-12..1e-1")] = 1e-6
    method: Annotated[str, AfterValidator(_method)] = METHOD
    parameters: dict[str, QuantityText] = Field({}, description="quantities by name")
    initial: dict[str, QuantityText] = Field({}, description="quantities by name")
    inputs: dict[str, str] = Field({}, description=INPUTS)
    outcome: Literal["finished", "beyond_horizon", "accuracy_unreachable"] = "finished"  # that must come out
    checks: tuple[Check, ...] = Field(
        (),
        strict=False,
        description="tables [[checks]] of quantity, source, and expected with tolerance, or at_most",
    )


def load_scenario(target: str | Path) -> Scenario:
    """Load a built-in scenario by name, or one from a TOML file.

    A scene file is named relative to the TOML file's folder. Raises InputError with every fault.
    """
    path = Path(target)
    if path.suffix != ".toml":
        if str(target) not in scenarios.names():
            raise InputError("scenario", [unknown("scenario", str(target), scenarios.names(), "or a TOML file")])
        return _validated(f"scenario {target}", scenarios.read(str(target)))
    content = read_toml(path, "scene, duration, parameters and checks")
    scene = content.get("scene")
    if isinstance(scene, str):
        content["scene"] = located_target(scene, path.parent)
    inputs = content.get("inputs")
    if isinstance(inputs, dict):
        content["inputs"] = {k: located(v, path.parent) if isinstance(v, str) else v for k, v in inputs.items()}
    return _validated(str(path), content, meant=True)


def _validated(subject: str, content: dict[str, Any], *, meant: bool = False) -> Scenario:
    """Return a scenario; raises InputError with the faults of its form.

    meant    also those of what is meant by the rest
    """
    faults: list[Fault] = []
    try:
        scenario = Scenario.model_validate(content)
    except ValidationError as error:
        faults = form_faults(error, Scenario)
    if meant:
        faults += _meaning_faults(content, {fault.where for fault in faults})
    refuse(subject, faults)
    return scenario


def _meaning_faults(content: dict[str, Any], faulty: set[str]) -> list[Fault]:
    """Return the faults of entries whose form is right: scene, names and units of values, checks."""
    if not isinstance(content.get("scene"), str):
        return []
    try:
        model = engine_model(content["scene"])
    except InputError as error:
        return list(error.faults)
    faults: list[Fault] = []
    parameters, initial = (
        {name: value for name, value in table.items() if f"{key}.{name}" not in faulty}
        for key in ("parameters", "initial")
        for table in [content.get(key, {}) if key not in faulty else {}]
    )
    duration = content.get("duration") if "duration" not in faulty else "1 s"
    inputs = content.get("inputs", {})
    texts = {k: v for k, v in inputs.items() if isinstance(v, str)} if isinstance(inputs, dict) else {}
    model, wrong = with_input_values(model, texts, duration, parameters)
    with noted(faults):
        check(model, Settings(duration, None, None), parameters, initial, wrong)
    checks, units = content.get("checks", ()), units_of(model, None)
    for i, entry in enumerate(checks if isinstance(checks, list) else ()):
        with contextlib.suppress(ValidationError):
            fault = misfit(Check.model_validate(entry), units)
            faults += [] if fault is None else [replace(fault, where=f"checks.{i}.{fault.where}")]
    return faults


def misfit(check: Check, units: Mapping[str, str]) -> Fault | None:
    """Return the fault of a check with an unknown name or a unit that does not fit; else None."""
    head, _, name = check.quantity.partition(".")
    if head in HISTORY_REDUCTIONS:
        if name not in units:
            near = get_close_matches(name, units, n=1)
            known = f"such as {near[0]}" if near else f"one of {', '.join(units)}"
            return Fault(check.quantity, f"no history {name!r}", f"a history of the solution, {known}")
        unit = units[name]
    else:
        unit = IMPACT_FIELDS[name.partition(".")[2]] if name else "1"
    text = check.expected if check.expected is not None else check.at_most or ""
    value, stated = parse_quantity(text)
    if stated.exponents != parse_unit(unit).exponents or stated.mistaken_for(parse_unit(unit)):
        remedy = rate_remedy(stated, value) if stated.mistaken_for(parse_unit(unit)) else ""
        return Fault(check.quantity, repr(text), f"a quantity in {unit}", remedy)
    return None
