"""Design of a sweep: ranges and lists of values, and the points of their grid, pairs or samples.

"0.05..0.5 mm:10"        a range, see engine/model/ranges
"0.1, 0.2, 0.4 mm"       these; one unit for all, or one each

A design is known by its ranges: a point is made when it is looked at, so that a million of them take no memory.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown, unknown
from hertzwerk.derive.common.units import UnitError
from hertzwerk.runtime.engine.inputs.inputs_by_row import Labels
from hertzwerk.runtime.engine.model.binding import Value, flag_faults, read, whole_faults
from hertzwerk.runtime.engine.model.ranges import EXPECTED, MOST, NUMBER, Range, RangeValues, ValueWithUnit, read_range
from hertzwerk.runtime.system.lazy import cached_property

Varied: TypeAlias = str | Value | Sequence[Value]

SAMPLERS = ("latin", "sobol")

Listed: TypeAlias = tuple[ValueWithUnit, ...] | RangeValues | Labels
Axis: TypeAlias = Listed | Range
"""Values of one parameter, labels of an input's, or a range to be sampled."""


@dataclass(frozen=True)
class Design:
    """Axes of a sweep by name, and how its points follow from them; raises nothing: `read_design` checks.

    `design[i]` has the values of a point by name; of a grid the last name varies fastest.

    zip    points pair the values of the axes, first with first; otherwise they are all combinations
    sample    number of points drawn from the axes by `sampler` with `seed`; None where all values are taken
    fixed    values that all points have
    """

    axes: Mapping[str, Axis]
    zip: bool = False
    sample: int | None = None
    sampler: str = "latin"
    seed: int = 0
    fixed: Mapping[str, Value] = field(default_factory=dict)

    def __len__(self) -> int:
        return self._count

    @cached_property
    def _count(self) -> int:
        if self.sample is not None:
            return self.sample
        counts = [len(axis) for axis in self._listed.values()]
        return min(counts, default=0) if self.zip else math.prod(counts)

    def __getitem__(self, i: int) -> dict[str, Value]:
        if not 0 <= i < self._count:
            raise IndexError(i)
        if self.sample is not None:
            parts = self._parts[i].tolist()
            drawn = {name: _drawn(axis, part) for (name, axis), part in zip(self.axes.items(), parts, strict=True)}
            return {**self.fixed, **drawn}
        places = dict.fromkeys(self._listed, i)
        if not self.zip:
            for name, axis in reversed(self._listed.items()):
                i, places[name] = divmod(i, len(axis))
        return {**self.fixed, **{name: axis[places[name]] for name, axis in self._listed.items()}}

    def __iter__(self) -> Iterator[dict[str, Value]]:
        return map(self.__getitem__, range(len(self)))

    @property
    def grid(self) -> dict[str, Listed]:
        """Values of every axis where the points are all their combinations; else empty."""
        return {} if self.zip or self.sample is not None else self._listed

    @property
    def units(self) -> dict[str, str]:
        """Unit that each axis is given in, of those that have one unit."""
        by_axis: dict[str, str] = {}
        for name, axis in self.axes.items():
            whole = axis.range if isinstance(axis, RangeValues) else axis
            if not isinstance(whole, Labels):
                units = {whole.unit} if isinstance(whole, Range) else {unit for _, unit in whole}
                if len(units) == 1:
                    (by_axis[name],) = units
        return by_axis

    @cached_property
    def _listed(self) -> dict[str, Listed]:
        return {name: axis for name, axis in self.axes.items() if not isinstance(axis, Range)}

    @cached_property
    def _parts(self) -> np.ndarray:
        """Places (points, axes) of samples, each a part 0..1 of its axis."""
        from scipy.stats import qmc  # slow to import

        sampler = {"latin": qmc.LatinHypercube, "sobol": qmc.Sobol}[self.sampler]
        parts: np.ndarray = sampler(len(self.axes), rng=self.seed).random(self.sample)
        return parts


def _drawn(axis: Axis, part: float) -> ValueWithUnit | str:
    """Return the value of an axis at a part 0..1 of it."""
    return axis.at(Fraction(part)) if isinstance(axis, Range) else axis[min(int(part * len(axis)), len(axis) - 1)]


def read_design(
    over: object,
    *,
    zip: bool = False,
    sample: object = None,
    sampler: object = "latin",
    seed: object = 0,
    faults: list[Fault],
) -> Design:
    """Read what is varied; bad input is appended to `faults`."""
    axes: dict[str, Axis] = {}
    if not isinstance(over, Mapping) or not over:
        faults.append(Fault("over", shown(over), 'values by name, such as {"clearance": "0.05..0.5 mm:10"}'))
    else:
        for name, values in over.items():
            where, sampled = f"over[{name!r}]", sample is not None
            axis = values if isinstance(values, Labels) else _axis(where, values, sampled, faults)
            if axis is not None:
                axes[name] = axis
    if sample is not None and not (_whole(sample) and 0 < sample <= MOST):  # type: ignore[operator]
        faults.append(Fault("sample", shown(sample), f"a number of points, 1 to {MOST:,}"))
        sample = None
    if not isinstance(sampler, str) or sampler not in SAMPLERS:
        faults.append(unknown("sampler", sampler, SAMPLERS))
    elif sampler == "sobol" and isinstance(sample, int) and sample & (sample - 1):
        below = 1 << (sample.bit_length() - 1)
        faults.append(
            Fault("sample", str(sample), f"a power of two, as Sobol points are balanced: {below} or {2 * below}")
        )
    faults += [*whole_faults(seed=seed), *flag_faults(zip=zip)]
    if zip is True and sample is not None:
        faults.append(Fault("zip", "beside sample", "one of the two", "samples already take one value of each"))
    counts = {name: len(axis) for name, axis in axes.items() if not isinstance(axis, Range)}
    if zip is True and len(set(counts.values())) > 1:
        actual = ", ".join(f"{count} of {name}" for name, count in counts.items())
        faults.append(Fault("zip", actual, "equally many values of each"))
    if zip is False and sample is None and math.prod(counts.values()) > MOST:
        faults.append(Fault("over", f"{math.prod(counts.values()):,} points", f"at most {MOST:,}", "sample them"))
    if faults:
        return Design({})
    return Design(axes, zip, sample, str(sampler), seed)  # type: ignore[arg-type]


def _whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _axis(where: str, values: object, sampled: bool, faults: list[Fault]) -> Axis | None:
    """Read the values of one name; bad input is appended to `faults`."""
    if isinstance(values, str):
        if ".." in values:
            return read_range(where, values, sampled, faults)
        return _listed(where, _with_shared_unit(values.replace("−", "-").split(",")), faults)
    if isinstance(values, tuple) and len(values) == 2 and isinstance(values[1], str) and _is_number(values[0]):
        return _listed(where, [values], faults)
    if isinstance(values, Sequence | np.ndarray):
        return _listed(where, list(values), faults)
    return _listed(where, [values], faults)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)


def _with_shared_unit(parts: list[str]) -> list[str]:
    """Return the parts of a list, each with the unit of the last one where no other has any."""
    *others, last = parts
    unit = re.fullmatch(rf"\s*{NUMBER}(.*)", last)
    if unit is not None and all(re.fullmatch(rf"\s*{NUMBER}\s*", part) for part in others):
        return [*(f"{part} {unit[1]}" for part in others), last]
    return parts


def _listed(where: str, values: Sequence[object], faults: list[Fault]) -> tuple[ValueWithUnit, ...] | None:
    """Read values of a list."""
    pairs: list[ValueWithUnit] = []
    wrong = []
    for value in values:
        try:
            number, _, unit = read(value)  # type: ignore[arg-type]
        except UnitError as error:
            wrong.append(Fault(where, shown(value), EXPECTED, str(error)))
        else:
            pairs.append((number, unit))
    if not values:
        wrong.append(Fault(where, "no value", EXPECTED))
    faults += wrong
    return None if wrong else tuple(pairs)
