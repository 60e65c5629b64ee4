"""Parameter sweep: a run for every point of a design, and outputs by name.

1. model     a scene or a variation of it                       loading
2. design    values of every point                              studies/sweeps/points/design_points
3. outputs   numbers of a run, by name or by own functions      studies/sweeps/rows/row_outputs
4. rows      a run each, on all cores                           studies/sweeps/batch
             stored once done, where a folder is named          studies/sweeps/points/sweep_definition, studies/sweeps/sweep_store
5. table     sorted by point                                    studies/sweeps/sweep_table
"""

from __future__ import annotations

import hashlib
import sqlite3
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, InputError, among, as_path, noted, refuse, shown, unknown
from hertzwerk.runtime.engine.inputs.input_values import Input, input_text, with_input_values
from hertzwerk.runtime.engine.inputs.inputs_by_row import NO_CHOICES, Choices, read_choices, units_of_inputs
from hertzwerk.runtime.engine.model import model as plain
from hertzwerk.runtime.engine.model.binding import Value, flag_faults
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.engine.model.si_values import si_units
from hertzwerk.runtime.engine.model.signal import digest_of
from hertzwerk.runtime.engine.run.run_request import (
    METHOD,
    Accuracy,
    Compiled,
    Settings,
    check,
    duration_follows,
    progress_faults,
    read_duration,
)
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.start.start_values import split_values, stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.studies.sweeps.batch import Batch, engine_lost, engine_of, in_memory, worker_faults
from hertzwerk.runtime.studies.sweeps.continued_rows import Chains, InMemory, key_after, read_chains, state_units
from hertzwerk.runtime.studies.sweeps.points.design_points import Design, Varied, read_design
from hertzwerk.runtime.studies.sweeps.points.own_functions import digest
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import (
    Keys,
    as_text,
    axes_of,
    number_and_unit,
    target_of,
    versions,
)
from hertzwerk.runtime.studies.sweeps.rows.row import TEXTS, Packed, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import RowArrays, place_of, read_row_arrays
from hertzwerk.runtime.studies.sweeps.rows.row_job import EngineLostError
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Output, chosen, derived_by, finals, own, text_behind
from hertzwerk.runtime.studies.sweeps.stored_rows import HELD, ROWS, DamagedError, StoredRows
from hertzwerk.runtime.studies.sweeps.sweep_store import TABLE, Store, opened
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep, columns_of, memory_faults

if TYPE_CHECKING:
    from distributed import Client


BATCH = 256  # points whose keys are made together


class ToDo:
    """Rows that are to be computed and stored, each key once.

    Of a point that is not under way it knows one byte: whether its row is there.

    progress    called with the fraction of points whose rows are there
    """

    def __init__(
        self, design: Design, keys: Keys, store: Store, progress: Callable[[float], object] | None = None
    ) -> None:
        self._design, self._keys, self._store, self._progress = design, keys, store, progress
        self._done = store.done(len(design))
        self._there = self._done.count(1)
        self._key: dict[int, str] = {}  # of rows under way
        self._points: dict[str, list[int]] = {}  # that wait for a row under way, by its key

    @property
    def left(self) -> int:
        """Number of points whose rows are not known to be there."""
        return len(self._done) - self._there

    def missing(self) -> Iterator[int]:
        """Yield the rows to compute, in the order of the design."""
        place = 0
        while (place := self._done.find(0, place)) >= 0:
            batch = range(place, min(place + BATCH, len(self._done)))
            yield from self.wanted({i: self._keys.of(self._design[i]) for i in batch if not self._done[i]})
            place += BATCH

    def died(self) -> Iterator[int]:
        """Yield the rows whose process died in an earlier call."""
        for number, key in self._store.died().items():
            self._key[number], self._points[key] = key, [number]
            yield number

    def keys(self, after: Mapping[int, str]) -> dict[int, str]:
        """Return the key of every row, given that of the row before it."""
        known = self._store.keys(after)
        return {i: known.get(i) or key_after(self._keys.of(self._design[i]), key) for i, key in after.items()}

    def wanted(self, keys: Mapping[int, str]) -> list[int]:
        """Return the rows that are neither there nor under way, of rows by their keys."""
        there, wanted = self._store.present(keys.values()), []
        known = {i: key for i, key in keys.items() if key in there and not self._done[i]}
        if known:
            self._store.add({}, known)
            self._mark(known)
        for i, key in keys.items():
            if key not in there:
                if key not in self._points:
                    self._key[i] = key
                    wanted.append(i)
                self._points.setdefault(key, []).append(i)
        return wanted

    def store(self, rows: Iterable[Row]) -> None:
        """Store rows that were under way; raises sqlite3.Error."""
        done = {self._key.pop(row.index): row for row in rows}
        points = {i: key for key in done for i in self._points.pop(key)}
        self._store.add(done, points)
        self._mark(points)

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is there, None where it got to no end."""
        return self._store.end_of(key)

    def _mark(self, points: Iterable[int]) -> None:
        for i in points:
            self._there += not self._done[i]
            self._done[i] = 1
        self.report()

    def report(self) -> None:
        """Report the progress."""
        if self._progress is not None:
            self._progress(self._there / max(len(self._done), 1))


NOT_STORED = "not_stored"  # outcome of a sweep
LOOKED_AT = 1000  # rows, of which one at least can run
LARGEST_CSV = 50e6  # bytes, about, of arrays that are written as CSV unasked


def sweep(
    target: Target,
    over: Mapping[str, Varied | Mapping[str, Input] | Sequence[Input]],
    *,
    zip: bool = False,
    sample: int | None = None,
    sampler: str = "latin",
    seed: int = 0,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    coordinates: str | None = None,
    outputs: Sequence[str] = (),
    section: str | None = None,
    after: str | float | None = None,
    grid: str | int | None = None,
    histories: Sequence[str] = (),
    continued: str | None = None,
    functions: Mapping[str, Callable[[EngineSolution], float]] | None = None,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    workers: int | None = None,
    client: Client | None = None,
    out: str | Path | None = None,
    widen: bool = False,
    progress: Callable[[float], object] | None = None,
) -> Sweep:
    """Run a model at every point of a design, on all cores; return the table of its outputs.

    target    a scene or a Model, as `simulate` takes it; without, laws, coordinates    a variation, as `load` takes it
    over    parameters and initial states to vary: "0.05..0.5 mm:10" (ten values), "1e6..1e9 N/m:7 log",
            "0.1, 0.2, 0.4 mm", or a list of values. All combinations are run, and the last name varies fastest. Inputs take constants in the same
            way, files "calm.csv:load, gusty.csv:load", a list, or a dictionary by labels; `torque.scale` is a factor
    zip    combine the first values of all names, then the second, and so on
    sample    number of points in place of combinations, spread by a "latin" hypercube or a "sobol" sequence (sampler) with a seed over
              ranges "0.05..0.5 mm", "1e6..1e9 N/m log", and lists
    parameters, initial    values that replace the scene's, as `simulate` takes them, the same for all points
    inputs    values of the inputs that do not vary, as `simulate` takes them
    outputs    names such as "final.guide.travel", "slider_pin.peak_force", "slider_pin.impact_rate" (with half the
               width of its 95 % interval in a further column), "guide.travel.max"; by default every final state. Derivatives of outputs by
               parameters and initial states are "d(slider_pin.peak_force)/d(restitution)"
    section    condition at which each row keeps points: "main_bearing.angle = 0" (every return of the drive), "phase = 90 deg" (of the
            period of everything that depends on time), "floor.gap = 0 m falling" (a history crosses a value; rising, falling or both)
    grid    number of points, or spacing ("0.1 ms"), of the histories that each row keeps
    after    transient that both omit, such as "100 rev"; histories: names that both keep, by default coordinates
            and speeds. `table.section["guide.travel"]` and `table.histories[...]` have an array for each row
    continued    "up" or "down": each value of the first parameter in `over` starts from the final state of the one before,
            for a duration of whole periods; branches of other varied values or starts are independent
    functions    further outputs, functions of the Solution: {"stroke": lambda run: np.ptp(run["guide.travel"])}
    workers    number of processes, by default one per core
    client    a Dask cluster in their place, by a connected `distributed.Client`
    out    folder in which every finished row is stored; missing rows of the same sweep are computed. Required beyond 100,000 rows. A folder of
            another definition is refused; with `widen` equal rows are kept, and the others are computed
    progress    a function that is called now and then with the fraction of rows done

    The other arguments are those of `simulate`. The outcome of a row states that it cannot run, does not finish, or that an output raises.
    Ctrl-C and a cluster that has stopped return the finished rows, a full disk the stored ones. Raises InputError
    with every fault that concerns all rows.
    """
    began = time.perf_counter()
    # 1. model
    model = engine_model(target, without=without, laws=laws, coordinates=coordinates)
    settings: dict[str, Any] = {
        **{"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method},
        **{"max_steps": max_steps, "max_events": max_events, "wall_time": wall_time},
    }
    # 2. design
    faults: list[Fault] = []
    spread: dict[str, Any] = {"zip": zip, "sample": sample, "sampler": sampler, "seed": seed}
    choices = NO_CHOICES
    if isinstance(over, Mapping):
        over, choices = read_choices(model, over, read_duration(model, {}, duration, []), faults)
    design = read_design(over, **spread, faults=faults)
    faults += memory_faults(len(design)) if out is None else []
    own, states = stated_values(model, parameters, initial, faults)
    fixed = {name: number_and_unit(value) for name, value in {**own, **states}.items()}
    model, wrong = with_input_values(model, inputs, duration, {})
    faults += [*wrong, *progress_faults(progress), *flag_faults(widen=widen)]
    varied = {**_varied(model, over, fixed, faults), **dict.fromkeys(choices.signals, "")}
    design = replace(design, fixed=fixed)
    chains = read_chains(model, design, varied, continued, faults)
    # 3. outputs
    wanted = outputs_of(model, outputs, functions, varied, faults)
    array_options = {"section": section, "after": after, "grid": grid, "histories": histories}
    end = () if continued is None else tuple(state_units(model))
    row_arrays = read_row_arrays(model, **array_options, duration=duration, end=end, faults=faults)
    faults += worker_faults(workers, client)
    with noted(faults):
        Settings(**settings, compiled=compiled, sensitivities=derived_by(wanted)).check(model)
    if not faults and duration_follows(model, derived_by(wanted), duration):
        actual = f"{duration}, which changes with what derivatives are taken by"
        faults.append(Fault("duration", actual, 'a time, such as "24 ms"'))
    refuse(f"sweep of {model.name}", faults)
    plan = Plan(model, design, varied, wanted, settings, row_arrays, chains, choices)
    plan.check()
    # 4. rows, 5. table
    later = 0 if chains is None else len(design) - len(chains.rows)
    batch = Batch(model, design, settings, wanted, compiled, engine_of(workers, client), row_arrays, later, choices)
    table = plan.table("" if row_arrays is None else place_of(row_arrays.section, grid, after), batch.workers)
    if out is None:
        table = _in_memory(plan, batch, table, progress)
    else:
        array_options["continued"] = continued
        spread["inputs"] = {name: input_text(value) for name, value in (inputs or {}).items()}
        definition, keys = _definition(plan, target, spread, array_options, functions or {})
        with opened(as_path("out", out)) as store:
            store.define(definition, text_of(model.module), widen=widen)
            table = _stored(table, plan, store, lambda: _filled(plan, batch, store, keys, progress))
    return replace(table, compiled=batch.compiled, wall_s=time.perf_counter() - began)


def refused_by_sweep(arguments: Mapping[str, Any], workers: Any = None) -> list[Fault]:
    """Return the faults that `sweep` finds in its arguments but `over`; nothing is computed."""
    nobody = 0 if workers is None or (isinstance(workers, int) and workers > 0) else workers
    try:
        sweep(over={}, workers=nobody, **arguments)
    except InputError as error:
        ours = {"over", "workers"} if among(nobody, 0) else {"over"}
        return [fault for fault in error.faults if fault.where not in ours]
    raise AssertionError("a sweep without workers was computed")


def _in_memory(plan: Plan, batch: Batch, table: Sweep, progress: Callable[[float], object] | None) -> Sweep:
    """Return the table with every row that could be computed."""
    count, ledger = len(plan.design), InMemory()
    done = batch.rows(range(count)) if plan.chains is None else ledger.noted(plan.chains.computed(batch, ledger))
    rows, outcome = in_memory(done, count, progress)
    return replace(table, rows=rows, outcome=outcome)


def _definition(
    plan: Plan,
    target: object,
    spread: Mapping[str, Any],
    array_options: Mapping[str, Any],
    functions: Mapping[str, Callable[[EngineSolution], float]],
) -> tuple[dict[str, Any], Keys]:
    """Return what is computed as plain data, and the keys of its rows; raises InputError."""
    model, row_arrays, text = plan.model, plan.row_arrays, text_of(plan.model.module)
    if not text:
        fault = Fault("out", "a model whose generated text is not known", "a model that `load` returned")
        raise InputError(model.name, [fault])
    same = {
        "outputs": [output.name for output in plan.outputs if output.name not in functions],
        "functions": {name: digest(name, function) for name, function in functions.items()},
        **{
            **array_options,
            "section": row_arrays and row_arrays.section and str(row_arrays.section),
            "histories": list(array_options["histories"]),
        },
        "signals": digest_of(model.signals),
        "text": _hash(text),
        "readings": _hash(text_behind(model, plan.outputs, [] if row_arrays is None else row_arrays.read)),
        "versions": versions(),
    }
    definition = {
        **{"scene": model.name, **target_of(target, model), "over": axes_of(plan.design, plan.choices), **spread},
        **{"parameters": {name: as_text(value) for name, value in plan.design.fixed.items()}, **plan.settings, **same},
        **{"columns": plan.columns, "varied": list(plan.varied)},
        "arrays": {} if row_arrays is None else row_arrays.columns,
        "choices": plan.choices.digests(),
        "points": len(plan.design),
    }
    return definition, Keys(model, plan.settings, same, plan.choices)


def _written(table: Sweep, folder: Path) -> Sweep:
    """Write a table and its arrays as CSV beside the store; return it with the outcome of that."""
    if table.outcome.name == NOT_STORED:
        return table
    try:
        table.to_csv(folder / TABLE, overwrite=True)
        for name in table.arrays:
            arrays = table.arrays_of(name)
            if arrays.csv_size() <= LARGEST_CSV:
                arrays.to_csv(folder / f"{name}.csv", overwrite=True)
    except DamagedError:
        raise
    except OSError as error:
        return replace(table, outcome=_not_stored(error))
    return table


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _stored(table: Sweep, plan: Plan, store: Store, fill: Callable[[], Outcome]) -> Sweep:
    """Fill a store, write its table, and return that; what is found damaged on the way is computed again.

    fill    computes what is missing, and returns how it ended
    """
    outcome = fill()

    def there() -> StoredRows:
        return StoredRows(store.folder / ROWS, store.plan, plan.design)

    for last in (False, False, True):
        damage = "" if store.damage is None else str(store.damage)
        try:
            rows = tuple(stored) if len(stored := there()) <= HELD else stored
            return _written(replace(table, rows=rows, outcome=outcome, damage=damage), store.folder)
        except DamagedError:
            if last:  # a disk that keeps nothing
                raise
            store.mend()
            outcome = fill() if outcome.finished else outcome
        except KeyboardInterrupt:
            return replace(table, rows=there(), outcome=_interrupted(store), damage=damage)
    raise AssertionError("the last attempt neither returned nor raised")


def _filled(plan: Plan, batch: Batch, store: Store, keys: Keys, progress: Callable[[float], object] | None) -> Outcome:
    """Compute and store the rows that are missing or lost, each once; return how it ended.

    A lost row of a chain stays: those after it started from the row before it.
    """
    try:
        to_do, chains = ToDo(plan.design, keys, store, progress), plan.chains
        to_do.report()
        if chains is None:
            rows = batch.rows(to_do.missing(), to_do.died(), count=to_do.left)
        elif to_do.left:
            rows = chains.computed(batch, to_do)
        else:
            return COMPLETE
        with closing(rows) as done:
            for some in done:
                to_do.store(some)
    except KeyboardInterrupt:
        return _interrupted(store)
    except EngineLostError as error:
        return engine_lost(error, f"the rows that were done are stored; {store.go_on}")
    except sqlite3.Error as error:
        return _not_stored(error)
    return COMPLETE


def _interrupted(store: Store) -> Outcome:
    return Outcome("interrupted", "stopped by the user", f"the rows that were done are stored; {store.go_on}")


def _not_stored(error: Exception) -> Outcome:
    remedy = "free space, then start it again: stored rows are kept, and the others are computed"
    return Outcome(NOT_STORED, f"a computed row could not be stored: {error}", remedy)


@dataclass(frozen=True)
class Plan:
    """Everything a sweep computes: design, what is the same for all, outputs, settings of the runs.

    row_arrays, chains    arrays that each row keeps; points that follow each other
    choices    what rows choose their inputs among
    """

    model: plain.EngineModel
    design: Design
    varied: Mapping[str, str]
    outputs: Sequence[Output]
    settings: Mapping[str, Any]
    row_arrays: RowArrays | None
    chains: Chains | None
    choices: Choices

    @property
    def columns(self) -> dict[str, str]:
        """Columns of the table with their units."""
        return columns_of(self.varied, {name: unit for output in self.outputs for name, unit in output.columns.items()})

    def table(self, place: str, workers: int) -> Sweep:
        """Return the table without a row; place: phrase, where arrays are kept."""
        return Sweep(
            scene=self.model.name,
            rows=(),
            columns=self.columns,
            varied=tuple(self.varied),
            outcome=COMPLETE,
            design=self.design,
            arrays={} if self.row_arrays is None else self.row_arrays.columns,
            place=place,
            workers=workers,
        )

    def check(self) -> None:
        """Raise InputError where not one row can run, of the first LOOKED_AT, with the faults of the first."""
        first: InputError | None = None
        for values in islice(self.design, LOOKED_AT):
            faults: list[Fault] = []
            try:
                model, rest = self.choices.of(self.model, values)
                parameters, initial = split_values(model, rest)
                with noted(faults):
                    if self.row_arrays is not None:
                        self.row_arrays.times(model, parameters)
                check(model, Settings(**self.settings), parameters, initial, faults)
                return
            except InputError as error:
                first = first or error
        if first is not None and len(self.design) <= LOOKED_AT:
            raise first


def _varied(model: plain.EngineModel, over: object, fixed: Mapping[str, Value], faults: list[Fault]) -> dict[str, str]:
    """Return the units of the names that are varied; bad input is appended to `faults`."""
    units = {name: unit for name, unit in si_units(model).items() if name not in model.memory} | units_of_inputs(model)
    names = list(over) if isinstance(over, Mapping) else []
    faults += [
        unknown("parameter or state", name, units)
        for name in (*names, *fixed)
        if not isinstance(name, str) or name not in units
    ]
    faults += [Fault(name, "among parameters and over", "one of the two") for name in names if name in fixed]
    return {name: units[name] for name in names if name in units}


def outputs_of(
    model: plain.EngineModel, names: Sequence[str], functions: object, varied: Mapping[str, str], faults: list[Fault]
) -> list[Output]:
    """Return the requested outputs; bad input is appended to `faults`."""
    if functions is not None and not isinstance(functions, Mapping):
        faults.append(Fault("functions", shown(functions), "a dictionary of functions of the Solution"))
        functions = None
    none = isinstance(names, Sequence) and not names and not functions
    outputs = finals(model) if none else chosen(model, names, faults)
    taken = {*varied, *TEXTS, *(name for output in outputs for name in output.columns)}
    for name, function in (functions or {}).items():
        if not (isinstance(name, str) and name and callable(function)):
            faults.append(Fault(f"functions[{name!r}]", shown(function), "a name, and a function of the Solution"))
        elif name in taken:
            faults.append(Fault(f"functions[{name!r}]", "the name of another column", "a name of its own"))
        else:
            outputs.append(own(name, function))
    return outputs
