"""Outputs to compare between scenes, each one number of a whole run.

The automatic ones follow from the scene: with contacts the peak of the normal forces, the rate of impacts and the
path length of each pin in its bush, always the peak acceleration, and without contacts the amplitudes. Any history
has four more: `max.NAME`, `min.NAME`, `mean.NAME`, `amplitude.NAME`. The averages of a run (`averages`) are outputs
by their names: their intervals are of the blocks of one long run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.dense_output import REDUCERS, Samples
from hertzwerk.runtime.engine.solution.history import History, acceleration_of, unknown_histories

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.averages import Average
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

WAY_SAMPLES = 10_000  # for the length of a path, which has cusps
PAST_HORIZON = ("mean_peak_force",)  # more useful beyond the horizon than the largest of all
AMPLITUDES = 4  # most that are chosen by default


@dataclass(frozen=True)
class Output:
    """One number of a run: `of` gives it in SI, None where it does not exist.

    of_histories: histories without which a run has none.

    half_width    95 % interval of a mean over time or impacts, from the run itself; None where the run is too short for one
    """

    name: str
    unit: str
    meaning: str
    of: Callable[[Samples], float | None]
    of_histories: tuple[str, ...] = ()
    half_width: Callable[[EngineSolution], float | None] | None = None

    def missing(self, run: EngineSolution) -> str:
        """Return the histories a run lacks for this output; empty if none."""
        return ", ".join(name for name in self.of_histories if name not in run.engine.history.units)


def automatic(run: EngineSolution) -> tuple[Output, ...]:
    """Return the default outputs of a scene; those in PAST_HORIZON are for runs that part."""
    model = run.engine.model
    chosen = list(named(run))
    if not model.k:
        chosen += [_of_history(run, "amplitude", name) for name in _coordinates(model)[:AMPLITUDES]]
    return tuple(chosen)


def named(run: EngineSolution) -> tuple[Output, ...]:
    """Return the outputs with a name of their own that apply to a scene."""
    model, units = run.engine.model, run.engine.history.units
    speeds = _of_one_kind(model, model.speeds, "m/s")
    accelerations = tuple(acceleration_of(speed) for speed in speeds)
    outputs = [
        Output("peak_acceleration", units[accelerations[0]], f"peak |acceleration| of {', '.join(speeds)}",
               lambda samples: samples.highest(lambda history: _largest(history, accelerations)), accelerations),
    ]  # fmt: skip
    if model.k:
        outputs = [
            Output(
                "peak_force",
                "N",
                "peak normal force of all pairs",
                lambda samples: max((impact.peak_force for impact in samples.run.impacts), default=0.0),
            ),
            *outputs,
            Output(
                "impact_rate",
                "1/s",
                "contacts begun per time",
                lambda samples: len(samples.run.impacts) / samples.run.engine.t_end,
            ),
            Output("mean_peak_force", "N", "mean of the peak normal force of each contact", _mean_peak_force),
        ]
    journals = [tuple(model.outputs[i] for i in rows) for rows in model.journals.values()]
    if journals:
        parts = tuple(part for journal in journals for part in journal)
        meaning = "path length of the pin or ball within its bearing" + (", all of them" if len(journals) > 1 else "")
        outputs.append(Output("journal_path", "m", meaning, lambda samples: _way(samples, journals), parts))
    return tuple(outputs)


def averaged(run: EngineSolution) -> tuple[Output, ...]:
    """Return the averages of a run as outputs, each with the interval of its own blocks."""
    return tuple(_average(average) for average in run.averages())


def _average(average: Average) -> Output:
    def computed(run: EngineSolution) -> Average | None:
        return next((other for other in run.averages() if other.name == average.name), None)

    def mean(samples: Samples) -> float | None:
        there = computed(samples.run)
        return None if there is None else there.mean

    def half_width(run: EngineSolution) -> float | None:
        there = computed(run)
        return None if there is None else there.half_width

    return Output(average.name, average.unit, "mean after the transient", mean, half_width=half_width)


def chosen(run: EngineSolution, texts: Sequence[str]) -> tuple[tuple[Output, ...], list[Fault]]:
    """Return the outputs of these names, and faults for unknown ones."""
    own = {output.name: output for output in (*named(run), *averaged(run))}
    outputs: dict[str, Output] = {}
    faults = []
    for text in texts:
        kind, _, name = text.partition(".")
        if text in own:
            outputs[text] = own[text]
        elif kind not in _KINDS or not name:
            expected = f"one of {', '.join(own)}, or {', '.join(f'{kind}.NAME' for kind in _KINDS)} with a history"
            faults.append(Fault("--output", repr(text), expected))
        else:
            outputs[text] = _of_history(run, kind, name)
    return tuple(outputs.values()), faults


def unknown_outputs(model: EngineModel, texts: Sequence[str]) -> list[Fault]:
    """Return the faults of outputs that need histories no run of the model has."""
    parts = (text.partition(".") for text in texts)
    return unknown_histories(model, [name for kind, _, name in parts if kind in _KINDS and name])


def _of_history(run: EngineSolution, kind: str, name: str) -> Output:
    meaning, of = _KINDS[kind]
    return Output(f"{kind}.{name}", run.engine.history.units[name], f"{meaning} {name}", lambda s: of(s, name), (name,))


_KINDS: dict[str, tuple[str, Callable[[Samples, str], float]]] = {
    "max": ("maximum of", REDUCERS["max"]),
    "min": ("minimum of", REDUCERS["min"]),
    "mean": ("mean over time of", REDUCERS["mean"]),
    "amplitude": ("half the range of", lambda samples, name: REDUCERS["peak_to_peak"](samples, name) / 2),
}


# -- what they are -----------------------------------------------------------------------------------------------------


def _mean_peak_force(samples: Samples) -> float | None:
    peaks = [impact.peak_force for impact in samples.run.impacts]
    return float(np.mean(peaks)) if peaks else None


def _largest(history: History, names: Sequence[str]) -> np.ndarray:
    largest: np.ndarray = np.max(np.abs([history[name] for name in names]), axis=0)
    return largest


def _way(samples: Samples, journals: Sequence[Sequence[str]]) -> float:
    """Return the length of the paths of the eccentricities: the integral of their speeds."""
    model = samples.run.engine.model
    fine = Samples(samples.run, WAY_SAMPLES)

    def speeds(history: History) -> np.ndarray:
        rates = history.output_rates()
        columns = ([model.outputs.index(part) for part in parts] for parts in journals)
        total: np.ndarray = np.sum([np.sqrt(np.sum(rates[:, of] ** 2, axis=1)) for of in columns], axis=0)
        return total

    return fine.integral(speeds)


def _coordinates(model: EngineModel) -> list[str]:
    """Return the coordinates that travel, else those that turn, else the quaternions' vector parts.

    Only those with a speed of their own.
    """
    free = [name for i, name in enumerate(model.coordinates) if i not in model.quaternions]
    free = [name for name, _ in zip(free, model.speeds, strict=False)]  # then, what drives integrate
    return _of_one_kind(model, free, "m")


def _of_one_kind(model: EngineModel, names: Sequence[str], wanted: str) -> list[str]:
    return [name for name in names if model.units[name] == wanted] or list(names)
