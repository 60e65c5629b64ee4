"""Small vibrations: frequencies, damping and shapes of a linearised model."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, overload

import numpy as np
import scipy.linalg

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.derive.html.plain_table import heading, table
from hertzwerk.runtime.inputs.given import Input
from hertzwerk.runtime.integrate.step.layout import CONTACT
from hertzwerk.runtime.model import model as plain
from hertzwerk.runtime.run.request import read_duration
from hertzwerk.runtime.solution.solution import Solution
from hertzwerk.runtime.statics.balance import UNDAMPED, Array
from hertzwerk.runtime.statics.equilibrium import Equilibrium, equilibrium, inputs_at
from hertzwerk.runtime.statics.linearisation import linearise

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame

    from hertzwerk.runtime.model.binding import Value
    from hertzwerk.runtime.model.model import Bound, Model

ZERO = 1e-7  # over the largest eigenvalue: below it is rounding of a freedom that nothing holds, a double one
NO_DAMPING = 1e-12  # over the largest eigenvalue: smaller real parts are rounding
SMALL = 1e-9  # part of a shape that is not shown


@dataclass(frozen=True)
class Mode:
    """Vibration, or decay without vibrating: a small deviation exp(eigenvalue t) shape.

    eigenvalue [1/s]; shape: complex deviation of every coordinate, in its unit, its largest in the scene's scales 1.
    """

    eigenvalue: complex
    shape: Mapping[str, complex] = field(repr=False)

    @property
    def frequency(self) -> float:
        """Damped frequency [Hz]; 0 where it does not vibrate."""
        return abs(self.eigenvalue.imag) / (2 * math.pi)

    @property
    def natural_frequency(self) -> float:
        """Modulus of the eigenvalue, as a frequency [Hz]."""
        return abs(self.eigenvalue) / (2 * math.pi)

    @property
    def damping_ratio(self) -> float:
        """Minus the real part over the modulus; 1 decays without vibrating, below 0 grows, nan at rest."""
        return -self.eigenvalue.real / abs(self.eigenvalue) + 0.0 if self.eigenvalue else math.nan

    @property
    def grows(self) -> bool:
        """Return whether the deviation grows."""
        return self.eigenvalue.real > 0

    @property
    def vibrates(self) -> bool:
        """Return whether it is a vibration."""
        return self.eigenvalue.imag != 0

    @property
    def title(self) -> str:
        """Short description, for a picture."""
        if not self.vibrates:
            return f"{'grows' if self.grows else 'decays'} by e in {1 / abs(self.eigenvalue.real):.3g} s"
        ratio = self.damping_ratio
        return f"{self.frequency:.4g} Hz" + (f", {100 * ratio:.3g} % damped" if abs(ratio) > SMALL else "")

    def __str__(self) -> str:
        if not self.eigenvalue:
            return "free: nothing holds it"
        if not self.vibrates:
            return f"{'grows' if self.grows else 'decays'} by e in {1 / abs(self.eigenvalue.real):.6g} s"
        return f"{self.frequency:.9g} Hz, damping ratio {self.damping_ratio:.4g}{', grows' if self.grows else ''}"


@dataclass(frozen=True)
class Modes(Sequence[Mode]):
    """Modes of a model at a state, by rising frequency, those that do not vibrate first."""

    model: Model = field(repr=False)
    bound: Bound = field(repr=False)
    t: float
    q: Array = field(repr=False)
    modes: tuple[Mode, ...]
    matrix: Array = field(repr=False)
    """A of x' = A x, the reduced linear equations, in the scene's scales [1/s]."""
    notes: tuple[str, ...] = ()

    @overload
    def __getitem__(self, index: int) -> Mode: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Mode, ...]: ...
    def __getitem__(self, index: int | slice) -> Mode | tuple[Mode, ...]:
        return self.modes[index]

    def __len__(self) -> int:
        return len(self.modes)

    def __iter__(self) -> Iterator[Mode]:
        return iter(self.modes)

    def __hash__(self) -> int:
        return id(self)

    @property
    def stable(self) -> bool:
        """Return whether no small deviation grows."""
        return not any(mode.grows for mode in self.modes)

    @property
    def frequencies(self) -> Array:
        """Damped frequencies [Hz] of the modes that vibrate, rising."""
        return np.array([mode.frequency for mode in self.modes if mode.vibrates])

    @property
    def damping_ratios(self) -> Array:
        """Damping ratios of the modes that vibrate, in the order of `frequencies`."""
        return np.array([mode.damping_ratio for mode in self.modes if mode.vibrates])

    def plot(self, count: int = 6) -> Figure:
        """Draw the mechanism in the extreme positions of its first modes that vibrate, or change.

        Raises InputError where there is none.
        """
        from hertzwerk.runtime.pictures.draw.mode_shapes import of_shapes

        shown = [(i, mode) for i, mode in enumerate(self.modes, 1) if mode.eigenvalue][:count]
        if not shown:
            raise InputError(self.model.name, [Fault("plot", "no mode that vibrates or changes", "one at least")])
        names = self.model.coordinates
        shapes = {f"{i}: {mode.title}": np.array([mode.shape[name] for name in names]) for i, mode in shown}
        return of_shapes(self.model, self.bound, self.t, self.q, shapes)

    def to_pandas(self) -> DataFrame:
        """Return a line for each mode: eigenvalue, frequency [Hz], damping ratio, shape by coordinate.

        Raises InputError without the extra [data].
        """
        from hertzwerk.runtime.host.extras import required

        rows = [
            {
                "eigenvalue": mode.eigenvalue,
                "frequency": mode.frequency,
                "damping_ratio": mode.damping_ratio,
                **mode.shape,
            }
            for mode in self.modes
        ]
        frame: DataFrame = required("pandas", "data").DataFrame(rows)
        frame.attrs["units"] = {"eigenvalue": "1/s", "frequency": "Hz", "damping_ratio": "1",
                                **{name: self.model.units[name] for name in self.model.coordinates}}  # fmt: skip
        return frame

    def __repr__(self) -> str:
        found = ", ".join(f"{x:.5g}" for x in self.frequencies[:4])
        more = ", ..." if len(self.frequencies) > 4 else ""
        return f"<Modes {self.model.name}: {found or 'none that vibrates'}{more}{' Hz' if found else ''}{'' if self.stable else ', unstable'}>"

    def __str__(self) -> str:
        lines, units = [], self.model.units
        for i, mode in enumerate(self.modes, 1):
            shape = (f"{name} {_phasor(x, units[name])}" for name, x in mode.shape.items() if abs(x) > SMALL)
            lines.append(f"{i}: {mode}; {', '.join(shape)}")
        return "\n".join([*lines, *self.notes])

    def _repr_html_(self) -> str:
        head = heading(
            self.model.name, "stable" if self.stable else "unstable", f": {len(self)} modes", good=self.stable
        )
        names = [name for name in self.model.coordinates if any(abs(mode.shape[name]) > SMALL for mode in self.modes)]
        rows = (
            (str(i), str(mode), *(_phasor(mode.shape[name]) for name in names)) for i, mode in enumerate(self.modes, 1)
        )
        header = ("mode", "", *(f"{name} [{self.model.units[name]}]" for name in names))
        return head + "".join(f"<p>{note}</p>" for note in self.notes) + table(header, rows)


def modes(
    model: Model | Equilibrium | Solution,
    *,
    at: str | float | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
) -> Modes:
    """Return the small vibrations of a model about its equilibrium, or along a run.

    model    a model, whose equilibrium is found with `parameters`, from `initial`, at the time `at`, as `equilibrium`
             does; or an equilibrium; or a run, at the time `at` in which the equations are frozen as they are
    at       time [s] or text such as "2 ms"
    inputs   values of the inputs, as `equilibrium` takes them; a run has its own

    Loops and sticking contacts are reduced; damping in proportion to an approach speed has none at rest. Frozen
    equations of a run whose constraints turn, as those of closed loops and absolute coordinates do, have frequencies
    that depend on the coordinates: a note names them. Raises InputError for bad input, and where there is no
    equilibrium.
    """
    if isinstance(model, Solution):
        if any(given is not None for given in (parameters, initial, inputs)):
            raise InputError("modes", [Fault("parameters, initial", "values beside a run", "none: it has its own")])
        return _of_run(model, at)
    if isinstance(model, Equilibrium):
        if any(given is not None for given in (at, parameters, initial, inputs)):
            raise InputError("modes", [Fault("at", "values beside an equilibrium", "none: it has its own")])
        return of_equilibrium(model)
    if not isinstance(model, plain.Model):
        expected = "a model that `load` returned, an equilibrium, or a run"
        raise InputError("modes", [Fault("model", shown(model), expected)])
    rest = equilibrium(model, parameters=parameters, initial=initial, inputs=inputs, at=0.0 if at is None else at)
    return of_equilibrium(rest)


def of_equilibrium(rest: Equilibrium) -> Modes:
    """Return the small vibrations about an equilibrium; raises InputError where there is none."""
    if not rest.found:
        fault = Fault("modes", f"no equilibrium: {rest.outcome.message}", "a position of rest", rest.outcome.remedy)
        raise InputError(rest.model.name, [fault])
    model = rest.model
    m = np.concatenate([np.full(model.nm - model.ns, UNDAMPED), np.zeros(model.ns)])
    mode = np.where(rest.closed > 0, CONTACT, 0.0)
    latched = [name for name in model.latches if rest.contacts[name.rpartition(".")[0]]]
    notes = [f"undamped: {', '.join(latched)} is not defined at rest"] if latched else []
    still = np.zeros(model.nu)
    return _modes(model, rest.bound, rest.t, rest.q, still, rest.memory, mode, m, (*rest.notes, *notes))


def _of_run(run: Solution, at: str | float | None) -> Modes:
    """Return the modes of the equations frozen at a time of a run; raises InputError."""
    model, faults = run.model, list[Fault]()
    if run.history.integrator is None:
        raise InputError(model.name, [Fault("modes", "a saved run", "a run that `simulate` returned")])
    t = run.t_end if at is None else 0.0 if at == 0 else read_duration(model, {}, at, faults)
    if faults or not run.t_start <= t <= run.t_end:
        raise InputError(model.name, [Fault("at", shown(at), f"a time from {run.t_start:g} to {run.t_end:g} s")])
    seen = run.at([t])
    q, u, z = (np.array([seen[name][0] for name in names]) for names in (model.coordinates, model.speeds, model.memory))
    mode = np.array([seen[f"{pair}.mode"][0] for pair in model.pairs])
    slips = [seen[name][0] for name, *_ in model.slips]
    m = np.array([*(seen[name][0] for name in model.latches), *slips])
    defaults = {name: (port.default, port.unit) for name, port in model.parameters.items()}
    given = {name: value for name, value in run.parameters.items() if value != defaults[name]}
    note = f"the equations are frozen at t = {t:g} s, where the motion is not at rest" if np.any(u) else ""
    model = inputs_at(model, None, t)
    return _modes(model, model.bind(given), t, q, u, z, mode, m, (note,) if note else ())


def _modes(
    model: Model, bound: Bound, t: float, q: Array, u: Array, z: Array, mode: Array, m: Array, notes: Sequence[str]
) -> Modes:
    linear = linearise(model, bound, t, q, u, z, mode, m)
    values, vectors = scipy.linalg.eig(linear.A) if len(linear.A) else (np.zeros(0), np.zeros((0, 0)))
    most = float(np.max(np.abs(values), initial=0.0))
    values = np.where(np.abs(values.real) <= NO_DAMPING * most, 1j * values.imag, values)
    values = np.where(np.abs(values) <= ZERO * most, 0.0, values)
    sizes = np.where(model.evaluate("scales", bound.p)[0] > 0, model.evaluate("scales", bound.p)[0], 1.0)
    found, loose = [], np.zeros((0, model.nq))  # shapes that nothing holds: each has a place and a speed
    for value, vector in zip(values, vectors.T, strict=True):
        shape = (linear.T @ vector)[: model.nq]
        largest = int(np.argmax(np.abs(shape) / sizes)) if len(shape) else 0
        shape = shape / shape[largest] if len(shape) and shape[largest] else shape
        if not value:
            known, loose = len(loose), np.vstack([loose, shape / sizes])
            if np.linalg.matrix_rank(loose, tol=ZERO) == known:
                loose = loose[:-1]
                continue
        if value.imag >= 0:
            found.append(Mode(complex(value), dict(zip(model.coordinates, map(complex, shape), strict=True))))
    found.sort(key=lambda mode: (abs(mode.eigenvalue.imag), abs(mode.eigenvalue)))
    if linear.turns and np.any(u):
        of = ", ".join(model.coordinates[i] for i in linear.of if i < model.nq)
        notes = [*notes, f"its constraints turn: frequencies are those of {of}, and others by other coordinates"]
    return Modes(model, bound, t, q, tuple(found), linear.A, tuple(notes))


def _phasor(x: complex, unit: str = "1") -> str:
    """Return a deviation with its unit, and its phase where that is neither 0 nor 180 deg."""
    behind = "" if unit == "1" else f" {unit}"
    if abs(x.imag) <= 1e-6 * abs(x):
        return f"{x.real:.4g}{behind}"
    return f"{abs(x):.4g}{behind} at {math.degrees(cmath.phase(x)):.1f} deg"
