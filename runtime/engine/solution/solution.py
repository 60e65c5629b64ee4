"""Result of a run: outcome, histories by name, impacts, statistics, energy ledger; to CSV and npz."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Self

import numpy as np

from hertzwerk.derive.common.faults import as_path
from hertzwerk.derive.common.module_format import EMPTY
from hertzwerk.derive.common.units import time_text
from hertzwerk.runtime.engine.accuracy.error_estimate import ErrorEstimate
from hertzwerk.runtime.engine.model.binding import Value, si_of_all
from hertzwerk.runtime.engine.model.derived_histories import readings_of
from hertzwerk.runtime.engine.model.generated_text import with_tables
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution import saved_run
from hertzwerk.runtime.engine.solution.averages import Average, Run, averages
from hertzwerk.runtime.engine.solution.checkpoint import Checkpoint
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.solution.hertz_validity import Validity, beyond_theory, validity
from hertzwerk.runtime.engine.solution.history import Histories, History
from hertzwerk.runtime.engine.solution.impacts import Impact
from hertzwerk.runtime.engine.solution.interval_sums import Sums
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.solution.step_observers import Choice, Findings, Needs
from hertzwerk.runtime.engine.solution.step_warnings import bent_rods, headline, left_law, lost_grip, wide_sectors
from hertzwerk.runtime.system.atomic_files import write_atomically
from hertzwerk.runtime.system.lazy import cached_property

CHECKPOINT = "checkpoint"  # name in a file, beside the histories
RATES = "rates"  # likewise, of a run with its steps
SAMPLE = 1000  # rows from which the size of a CSV is estimated

__all__ = ["EngineSolution", "ErrorEstimate", "History", "Impact", "Statistics"]


@dataclass(frozen=True)
class Statistics:
    """Cost of a run.

    Accepted steps, steps rejected for their error, steps retaken to land on an event, evaluations of the right-hand
    side, contacts begun (events). wall_s: the integration; build_s: reading input and building functions; compile_s:
    compilation during the run [s].
    """

    steps: int
    rejected: int
    retaken: int
    rhs_evaluations: int
    events: int
    wall_s: float
    build_s: float
    compile_s: float = 0.0


@dataclass(frozen=True)
class RunSettings:
    """Settings of a run: duration requested [s], accuracy or tolerance, method, parameters.

    accuracy: requested of the whole run, None for a run at a tolerance; tolerance: local, of this run
    parameters: value and unit of every parameter by name.
    """

    duration: float
    accuracy: float | None
    tolerance: float
    method: str
    compiled: bool
    parameters: Mapping[str, tuple[float, str]] = field(repr=False)


@dataclass(frozen=True, eq=False)
class EngineRun:
    """Run as the engine has it: rows of its states, what was found in its steps, scales of its errors.

    ends: rows of which the first and the last are the run's; checkpoint: state that a longer run continues from; known_warnings: those that need
    not be found in the steps; derivatives: the `Sensitivities` requested with the run.
    """

    history: History
    ends: History
    findings: Findings
    scales: Scales
    checkpoint: Checkpoint | None = None
    known_warnings: tuple[str, ...] = ()
    derivatives: Any = None

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """Warnings found in the steps, now that they are read, and known ones."""
        left = left_law(self.model, self.findings.lasting, self.ends)
        of_rows = [warning for of in (bent_rods, lost_grip, wide_sectors) for warning in of(self.model, self.history)]
        return (*beyond_theory(self.validity), *left, *of_rows, *self.known_warnings)

    @cached_property
    def validity(self) -> tuple[Validity, ...]:
        """Checks of the limits of Hertz's theory, over all contacts whose law is Hertz's.

        Empty where impacts were not needed, and for a saved run, which has its warnings.
        """
        known = self.history.p if Needs.IMPACTS in self.findings.needs else None
        return validity(self.model, known, lambda: self.findings.impacts)

    def with_warning(self, text: str) -> EngineRun:
        """Return the run with one more warning."""
        return replace(self, known_warnings=(*self.known_warnings, text))

    @cached_property
    def shared_results(self) -> dict[type, object]:
        """Results that pictures share, by their type; they are neither saved nor pickled."""
        return {}

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "shared_results"}

    @property
    def model(self) -> EngineModel:
        """The model that was run."""
        return self.history.model

    @property
    def t_start(self) -> float:
        """Time [s] at which the run began: 0, or where it was continued."""
        return float(self.ends.t[0])

    @property
    def t_end(self) -> float:
        """Time [s] that the run reached."""
        return float(self.ends.t[-1])

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the integrated states: coordinates, speeds, memory."""
        return (*self.model.coordinates, *self.model.speeds, *self.model.memory)

    @property
    def initial(self) -> dict[str, float]:
        """Every state at the start, SI."""
        return {name: float(self.ends[name][0]) for name in self.states}

    @property
    def final(self) -> dict[str, float]:
        """Every state at the end, SI."""
        return {name: float(self.ends[name][-1]) for name in self.states}

    @property
    def advice(self) -> tuple[str, ...]:
        """Reservations about the scene's laws, such as a point contact law for a line contact."""
        return tuple(self.model.module.ADVICE)

    @property
    def choices(self) -> tuple[Choice, ...]:
        """Choices of `method="auto"`: the first method and every change, with reasons; else empty."""
        return self.findings.choices

    def with_model(self, model: EngineModel) -> EngineRun:
        """Return a saved run with the functions of its model, by which pictures show the ideal mechanism too."""
        return replace(self, history=self.history.with_model(model))


@dataclass(frozen=True, eq=False)
class EngineSolution(Histories):
    """Result of a run, a mapping from names to histories over `run.t`, in SI.

    `run["guide.travel"]` is one, `run["guide.travel", "mm"]` in a unit of one's own, `list(run)` has the names,
    `run.units[name]` the SI unit.

    engine    what the engine has of the run, for programs of one's own
    outcome    how it ended, with a message and a remedy
    settings    duration, accuracy or tolerance, method, compiled, parameters
    statistics    its cost: steps, evaluations, times
    energy_residual    largest error of the energy balance over the largest energy that the run moves. The error is |energy - initial energy +
        dissipated - input| of all accepted steps; the energy moved is kinetic, dissipated, put in, or change of potential, or a millionth of the
        scene's energy scale where that is more. None without a ledger, and where a failed run holds an energy that is not finite
    error    estimate for an accuracy; None for a run at a tolerance, and where nothing could be compared
    """

    engine: EngineRun = field(repr=False)
    outcome: Outcome
    settings: RunSettings
    statistics: Statistics
    energy_residual: float | None = None
    error: ErrorEstimate | None = field(default=None, repr=False)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the run: what to heed."""
        return self.engine.warnings

    @property
    def t(self) -> np.ndarray:
        """Times of the accepted steps, or of the requested grid [s], shape (rows,)."""
        return self.engine.history.t

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit text of every history by name."""
        return self.engine.history.units

    def __getitem__(self, name: str | tuple[str, str]) -> np.ndarray:
        return self.engine.history[name]

    def with_histories(self, *names: str) -> Self:
        """Return the run with readings listed among its histories, so that tables and files have them too.

        `model.histories` has all of them. Raises KeyError for an unknown name.
        """
        return replace(self, engine=replace(self.engine, history=self.engine.history.with_names(names)))

    def at(self, times: Value | Sequence[float] | np.ndarray) -> History:
        """Return histories at one or more times of the run [s]; one time may have a unit, "2 ms".

        Interpolated by the method's own step and order, under the modes of the step that covers each time. Raises InputError for what is
        no time of the run, ValueError between the rows of a run that kept a grid or was saved.
        """
        return self.engine.history.at(si_of_all("times", "s", times))

    @property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        return self.engine.findings.impacts

    def averages(self, *, interval: str | float | None = None, skip: str | float | None = None) -> tuple[Average, ...]:
        """Return averages of the run with 95 % confidence: impact rates, forces, powers.

        See `hertzwerk.runtime.engine.solution.averages.averages`.
        """
        run = Run(
            self.engine.model,
            self.engine.findings,
            self.engine.scales,
            self.settings.tolerance,
            self.engine.t_start,
            self.engine.t_end,
        )
        return averages(run, interval=interval, skip=skip)

    def __repr__(self) -> str:
        return f"<Solution {self.engine.model.name}: {str(self).partition(chr(10))[0]}>"

    def __str__(self) -> str:
        statistics, count = self.statistics, len(self.impacts)
        parts = [
            f"{time_text(self.engine.t_end)} in {statistics.steps:,} steps",
            f"{count:,} impact{'s' if count != 1 else ''}",
        ]
        if self.error is not None:
            parts.append(f"error {self.error}")
        if self.energy_residual is not None:
            parts.append(f"energy closed to {self.energy_residual:.1g}")
        text = f"{self.outcome.name}: {', '.join([*parts, time_text(statistics.wall_s, 3)])}"
        reason = [] if self.outcome.finished else [f"{self.outcome.message}; {self.outcome.remedy}"]
        return "\n".join([text, *reason, *(f"warning: {headline(warning)}" for warning in self.warnings)])

    def save(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write the whole run as npz, to be read by `Solution.load` or NumPy; raises FileExistsError."""
        module = self.engine.model.module
        about = {
            "scene": {name: getattr(module, name) for name in SAVED} | {"BESIDE": self._beside()},
            "ledger": self.engine.model.has_ledger,
            "outcome": asdict(self.outcome),
            "statistics": asdict(self.statistics),
            "warnings": self.warnings,
            **asdict(self.settings),
            "energy_residual": self.energy_residual,
            "scales": {"state": self.engine.scales.state.tolist(), "scene": self.engine.scales.scene.tolist()},
            "error": self.error and self.error.numbers,
            "impacts": [impact._asdict() for impact in self.impacts],
            "choices": [asdict(choice) for choice in self.engine.choices],
            "sums": self.engine.findings.sums().about(),
            "period": self.engine.findings.period,
            "checkpoint": self.engine.checkpoint and self.engine.checkpoint.about(),
            "ends": {name: self.engine.ends[name][[0, -1]].tolist() for name in ("t", *self.engine.states)},
        }
        histories: dict[str, Any] = {name: self[name] for name in ("t", *self)}
        if self.engine.checkpoint is not None:
            histories[CHECKPOINT] = self.engine.checkpoint.resume.state
        content = b""
        if self.engine.history.steps:
            with suppress(MemoryError):  # then without them: they serve pictures alone
                content = saved_run.packed(about, {**histories, RATES: saved_run.rates(self.engine.history)})
        return write(path, content or saved_run.packed(about, histories), overwrite=overwrite)

    def _beside(self) -> list[tuple[str, str, str]]:
        """Return the table of the readings that are saved with a run: name, unit, meaning."""
        if not self.engine.history.beside:
            return []
        known = readings_of(self.engine.model).rows
        return [(name, known[name].unit, known[name].meaning) for name in self.engine.history.beside]

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a saved run: its histories, impacts and numbers, without functions.

        Raises InputError for a file that is not as `save` wrote it.
        """
        return saved_run.unpacked(as_path("path", path), cls._of)

    @classmethod
    def _of(cls, about: dict[str, Any], histories: dict[str, np.ndarray]) -> Self:
        state, rates = histories.pop(CHECKPOINT, None), histories.pop(RATES, None)
        tables = {name: _tuples(about["scene"][name]) for name in (*SAVED, "BESIDE")}
        module = with_tables(**tables, **({"ledger": None} if about["ledger"] else {}))
        model = EngineModel(module)
        parameters = {name: (value, unit) for name, (value, unit) in about["parameters"].items()}
        engine = EngineRun(
            history=History.stored(model, histories, saved_run.rates_by_name(rates, model, histories)),
            ends=History.stored(model, {name: np.array(values) for name, values in about["ends"].items()}),
            findings=Findings.saved(
                model,
                [Impact(**impact) for impact in about["impacts"]],
                [Choice(**choice) for choice in about["choices"]],
                Sums.saved(about["sums"], model),
                about["period"],
            ),
            scales=Scales(**{name: np.array(values) for name, values in about["scales"].items()}),
            checkpoint=None if state is None else Checkpoint.saved(about["checkpoint"], state),
            known_warnings=tuple(about["warnings"]),
        )
        return cls(
            engine=engine,
            outcome=Outcome(**about["outcome"]),
            settings=RunSettings(
                **{each.name: about[each.name] for each in fields(RunSettings)} | {"parameters": parameters}
            ),
            statistics=Statistics(**about["statistics"]),
            energy_residual=about["energy_residual"],
            error=about["error"] and ErrorEstimate.from_numbers(about["error"]),
        )


def csv_of(run: EngineSolution, rows: slice = slice(None)) -> bytes:
    """Return every history as CSV, in SI: columns headed `name [unit]`, all rows or some."""
    table = np.column_stack([run.t[rows], *(run[name][rows] for name in run)])
    text = io.StringIO()
    text.write(",".join(f"{name} [{run.units[name]}]" for name in ("t", *run)) + "\n")
    np.savetxt(text, table, delimiter=",", fmt="%.17g")
    return text.getvalue().encode()


def csv_size(run: EngineSolution) -> float:
    """Estimate the size [bytes] of the file of `csv_of`."""
    some = slice(None, None, max(len(run.t) // SAMPLE, 1))
    return len(csv_of(run, some)) * len(run.t) / len(run.t[some])


_OF_FUNCTIONS = ("LANDMARKS", "FAMILIES", "GIVEN", "SEATED", *(name for name in EMPTY if name.startswith("JOINT_")))
SAVED = ("NAME", "SOURCE", "SUMMARY", "FORMAT", *(name for name in EMPTY if name not in _OF_FUNCTIONS))


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def write(path: str | Path, content: bytes | Iterable[bytes], *, overwrite: bool) -> Path:
    """Write a file whole; raises FileExistsError if it exists and `overwrite` is not set."""
    path = as_path("path", path)
    if path.exists() and not overwrite:
        raise FileExistsError(f"{path} exists; name another file, or pass overwrite=True")
    write_atomically(path, content)
    return path
