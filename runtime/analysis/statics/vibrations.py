"""Small vibrations: frequencies, damping and shapes of the linearised equations of motion.

These are reduced to what loops and sticking contacts leave free. A small deviation of the state keeps the loops closed, its
quaternions of unit norm, and what sticks at rest: it is T x with T a basis of the kernel of all these conditions, which the
linear motion does not leave. What drives integrate, and what only counts energy or whole turns, deviates not at all. x are
deviations of some of the states, so that x' = A x holds too where constraints turn with the motion, and T with them; A is
then another for other states.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, overload

import casadi as ca
import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown
from hertzwerk.runtime.analysis.statics.balance import RANK, UNDAMPED, kernel
from hertzwerk.runtime.analysis.statics.equilibrium import Equilibrium, dents_of, equilibrium, inputs_at
from hertzwerk.runtime.engine.inputs.input_values import Input
from hertzwerk.runtime.engine.integration.step.implicit_step import linearised
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.integration.step.redundant_constraints import relax_redundant
from hertzwerk.runtime.engine.integration.step.set_valued_friction import NO_PAIR, pair_grips, pairs_of, sticking
from hertzwerk.runtime.engine.model.binding import Value, whole_faults
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.run.continuation import parameters_of
from hertzwerk.runtime.engine.run.run_request import read_duration
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.start import start_values
from hertzwerk.runtime.loading import Target
from hertzwerk.runtime.output.tables.notebook import Printed
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame


ZERO = 1e-7  # over the largest eigenvalue: below it is rounding of a freedom that nothing holds, a double one
NO_DAMPING = 1e-12  # over the largest eigenvalue: smaller real parts are rounding
SMALL = 1e-9  # part of a shape that is not shown


@dataclass(frozen=True)
class Linearisation:
    """Linear equations x' = A x of deviations T x of the state; A (n, n) [1/s], T (ny, n) in SI.

    of: states (n) that x deviates from, each in its scale; turns: whether T changes with the motion.
    """

    A: Array
    T: Array
    of: Sequence[int]
    turns: bool


def linearise(
    model: EngineModel, bound: BoundParameters, t: float, q: Array, u: Array, z: Array, mode: Array, m: Array
) -> Linearisation:
    """Linearise at a state, with modes (k,) of the pairs and latches and slips m (nm,)."""
    live = model.without_redundancy(start_values.dependent(model, bound, q))
    c, scales = bound.c, model.evaluate("scales", bound.p)
    y = np.concatenate([q, u, z])
    unit = np.concatenate([np.where(np.isfinite(x) & (x > 0), x, 1.0) for x in scales[:3]])
    if live.dependent:
        c = np.array(_relaxed(live)(t, y, c, unit, scales[3])).ravel()
    J = np.array(_jacobian(live)(t, y, mode, m, c)[0])
    conditions = _conditions(model, bound, t, q, u, z, mode, m, J)
    rows = conditions * unit
    sizes = np.linalg.norm(rows, axis=1)
    rows[sizes > 0] /= sizes[sizes > 0, None]
    free = kernel(rows)
    of = _independent(free, np.split(np.arange(len(y)), [model.nq, model.nq + model.nu]))
    free = free @ np.linalg.inv(free[of])
    A = (J * unit / unit[:, None])[of] @ free
    turning = rows[model.nl : 2 * model.nl, : model.nq] @ free[: model.nq]  # of the loops' directions, by the motion
    return Linearisation(A, unit[:, None] * free, of, bool(np.any(np.abs(turning) > RANK)))


def _independent(free: Array, blocks: Sequence[NDArray[np.int64]]) -> list[int]:
    """Return n rows of a basis (ny, n) that determine a deviation, of the first blocks where possible."""
    chosen: list[int] = []
    for block in blocks:
        R, order = scipy.linalg.qr(free[block].T, mode="r", pivoting=True)
        picked = block[order[: np.count_nonzero(np.abs(np.diag(R)) > RANK)]]
        chosen += picked.tolist()
        free = free @ kernel(free[picked])
    return chosen


@per_model
def _jacobian(model: EngineModel) -> Callers:
    function = linearised(model)
    arguments = function.sx_in() if function.is_a("SXFunction") else function.mx_in()
    return Callers(ca.Function("jacobian", arguments, [ca.densify(function(*arguments)[0])]))


@per_model
def _relaxed(model: EngineModel) -> Any:
    """Return the function (t, y, c, scale, scales) -> c with redundant constraints relaxed."""
    t, y, c = model.symbols("t y c")
    scale, scales = ca.SX.sym("scale", y.numel()), ca.SX.sym("scales", 4)
    run = relax_redundant(model)({"t": t, "y": y}, {"c": c, "scale": scale, "scales": scales})
    return ca.Function("relaxed", [t, y, c, scale, scales], [run["c"]])


def _conditions(
    model: EngineModel, bound: BoundParameters, t: float, q: Array, u: Array, z: Array, mode: Array, m: Array, J: Array
) -> Array:
    """Return the linear conditions (any, ny) on deviations of the state."""
    nq, nu, ny = model.nq, model.nu, len(J)
    of_q, of_rates, sliding, moves = _derivatives(model)(t, q, u, z, m, bound.c)
    rows = [
        np.hstack([of_q.reshape(model.nl, nq), np.zeros((model.nl, ny - nq))]),
        np.hstack([of_rates.reshape(model.nl, nq + nu), np.zeros((model.nl, ny - nq - nu))]),
    ]
    for i in model.quaternions:
        rows.append(np.zeros((1, ny)))
        rows[-1][0, i : i + 4] = q[i : i + 4]
    moves = moves.reshape(nq, nu)
    counts = [f"{name}.near" for name, kind, _ in model.module.EFFECTS if kind == "counted_angle"]
    still = [
        i for i, name in enumerate(model.coordinates) if not np.any(moves[i]) or name in counts
    ]  # what drives integrate, what only counts
    idle = [nq + nu + i for i in range(model.nz) if not np.any(J[:, nq + nu + i])]  # what counts energy
    rows.append(np.eye(ny)[[*still, *idle]])
    at_rest, stuck = not np.any(u), sticking(model, m)
    for i, j in enumerate(pairs_of(model)):
        if (j == NO_PAIR or mode[j] == CONTACT) and stuck[i]:
            own = sliding.reshape(model.ns, nq + nu)[i]
            rows.append(np.concatenate([own, np.zeros(model.nz)])[None])
            if at_rest:  # what has not slid is where it was
                rows.append(np.concatenate([own[nq:] @ np.linalg.pinv(moves), np.zeros(ny - nq)])[None])
    return np.vstack(rows)


@per_model
def _derivatives(model: EngineModel) -> Callers:
    """Build (t, q, u, z, m, c) -> derivatives of constraints, their rates, slips and coordinate rates."""
    t, q, u, _, _, c = arguments = model.symbols("t q u z m c")
    none = ca.SX(0, 1)
    loops, rates = model.function("constraints")(t, q, u, c) if model.nl else (none, none)
    of_joints = (
        model.function("rubbing")(t, q, u, ca.SX.zeros(*model.symbols("reactions")[0].shape), c)[0]
        if model.rubbing
        else none
    )
    sliding = [
        of_joints if j == NO_PAIR else pair_grips(model, j, *arguments)[0] for j in dict.fromkeys(pairs_of(model))
    ]
    x, s = ca.vertcat(q, u), ca.vertcat(none, *sliding)
    moves = ca.jacobian(model.function("coordinate_rates")(t, q, u, c), u)
    results = [ca.jacobian(loops, q), ca.jacobian(rates, x), ca.jacobian(s, x), moves]
    return Callers(ca.Function("derivatives", arguments, [ca.densify(x) for x in ca.cse(results)]))


@dataclass(frozen=True)
class Mode:
    """Mode of small vibration or decay: a deviation exp(eigenvalue t) shape.

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
class Modes(Printed, Sequence[Mode]):
    """Modes of a model at a state, by rising frequency, those that do not vibrate first."""

    model: EngineModel = field(repr=False)
    bound: BoundParameters = field(repr=False)
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
        try:
            return self.modes[index]
        except (IndexError, TypeError):
            raise IndexError(f"no mode {shown(index)}; there are {len(self.modes)}, from 0 on") from None

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
        from hertzwerk.runtime.output.drawings.mode_shapes import of_shapes

        refuse(self.model.name, whole_faults(count=count))
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
        from hertzwerk.runtime.system.optional_packages import required

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
        listed = ", ".join(f"{x:.5g}" for x in self.frequencies[:4])
        more = ", ..." if len(self.frequencies) > 4 else ""
        return f"<Modes {self.model.name}: {listed or 'none that vibrates'}{more}{' Hz' if listed else ''}{'' if self.stable else ', unstable'}>"

    def __str__(self) -> str:
        lines, units = [], self.model.units
        for i, mode in enumerate(self.modes, 1):
            shape = (f"{name} {_phasor(x, units[name])}" for name, x in mode.shape.items() if abs(x) > SMALL)
            lines.append(f"{i}: {mode}; {', '.join(shape)}")
        return "\n".join([*lines, *self.notes])


def modes(
    target: Target | Equilibrium | EngineSolution,
    *,
    at: str | float | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
) -> Modes:
    """Compute the small vibrations of a scene about its equilibrium, or along a run.

    target   a scene or a Model, whose equilibrium is found with `parameters`, from `initial`, at the time `at`, as
             `equilibrium` does; or an equilibrium; or a run, whose equations are frozen at the time `at`
    at       time [s] or text such as "2 ms"
    inputs   values of the inputs, as `equilibrium` takes them; a run has its own

    The equations are reduced to the motions that loops and sticking contacts leave free. Damping that is proportional to an
    approach speed vanishes at rest. Constraints of closed loops and absolute coordinates turn along a run; the frequencies then
    depend on the coordinates, which a note names. Raises InputError for invalid input, and where there is no equilibrium.
    """
    if isinstance(target, EngineSolution):
        if any(argument is not None for argument in (parameters, initial, inputs)):
            raise InputError("modes", [Fault("parameters, initial", "values beside a run", "none: it has its own")])
        return _of_run(target, at)
    if isinstance(target, Equilibrium):
        if any(argument is not None for argument in (at, parameters, initial, inputs)):
            raise InputError("modes", [Fault("at", "values beside an equilibrium", "none: it has its own")])
        return of_equilibrium(target)
    rest = equilibrium(target, parameters=parameters, initial=initial, inputs=inputs, at=0.0 if at is None else at)
    return of_equilibrium(rest)


def of_equilibrium(rest: Equilibrium) -> Modes:
    """Return the small vibrations about an equilibrium; raises InputError where there is none."""
    if not rest.converged:
        fault = Fault("modes", f"no equilibrium: {rest.outcome.message}", "a position of rest", rest.outcome.remedy)
        raise InputError(rest.model.name, [fault])
    model = rest.model
    m = np.concatenate([np.full(model.nm - model.ns, UNDAMPED), np.zeros(model.ns)])
    mode = np.where(rest.closed > 0, CONTACT, 0.0)
    latched = [name for name in model.latches if rest.contacts[name.rpartition(".")[0]]]
    verb = "is" if len(latched) == 1 else "are"
    notes = [f"undamped: {', '.join(latched)} {verb} not defined at rest"] if latched else []
    if dented := [pair for pair in dents_of(rest.of) if rest.contacts[pair]]:
        notes.append(
            f"{', '.join(dented)}: loads; beyond first yield modes(run) of a run at rest has the stiffness of unloading"
        )
    still = np.zeros(model.nu)
    return _modes(model, rest.bound, rest.t, rest.q, still, rest.memory, mode, m, (*rest.notes, *notes))


def _of_run(run: EngineSolution, at: str | float | None) -> Modes:
    """Return the modes of the equations frozen at a time of a run; raises InputError."""
    model, faults = run.engine.model, list[Fault]()
    if run.engine.history.integrator is None:
        raise InputError(model.name, [Fault("modes", "a saved run", "a run that `simulate` returned")])
    t = run.engine.t_end if at is None else 0.0 if at == 0 else read_duration(model, {}, at, faults)
    if faults or not run.engine.t_start <= t <= run.engine.t_end:
        raise InputError(
            model.name, [Fault("at", shown(at), f"a time from {run.engine.t_start:g} to {run.engine.t_end:g} s")]
        )
    state = run.at([t])
    q, u, z = (
        np.array([state[name][0] for name in names]) for names in (model.coordinates, model.speeds, model.memory)
    )
    mode = np.array([state[f"{pair}.mode"][0] for pair in model.pairs])
    slips = [state[name][0] for name, *_ in model.slips]
    m = np.array([*(state[name][0] for name in model.latches), *slips])
    parameters = parameters_of(run, model)
    note = f"the equations are frozen at t = {t:g} s, where the motion is not at rest" if np.any(u) else ""
    model = inputs_at(model, None, t)
    return _modes(model, model.bind(parameters), t, q, u, z, mode, m, (note,) if note else ())


def _modes(
    model: EngineModel,
    bound: BoundParameters,
    t: float,
    q: Array,
    u: Array,
    z: Array,
    mode: Array,
    m: Array,
    notes: Sequence[str],
) -> Modes:
    linear = linearise(model, bound, t, q, u, z, mode, m)
    values, vectors = scipy.linalg.eig(linear.A) if len(linear.A) else (np.zeros(0), np.zeros((0, 0)))
    most = float(np.max(np.abs(values), initial=0.0))
    values = np.where(np.abs(values.real) <= NO_DAMPING * most, 1j * values.imag, values)
    values = np.where(np.abs(values) <= ZERO * most, 0.0, values)
    sizes = np.where(model.evaluate("scales", bound.p)[0] > 0, model.evaluate("scales", bound.p)[0], 1.0)
    vibrations, loose = [], np.zeros((0, model.nq))  # shapes that nothing holds: each has a place and a speed
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
            vibrations.append(Mode(complex(value), dict(zip(model.coordinates, map(complex, shape), strict=True))))
    vibrations.sort(key=lambda mode: (abs(mode.eigenvalue.imag), abs(mode.eigenvalue)))
    if linear.turns and np.any(u):
        of = ", ".join(model.coordinates[i] for i in linear.of if i < model.nq)
        notes = [*notes, f"its constraints turn: frequencies are those of {of}, and others by other coordinates"]
    return Modes(model, bound, t, q, tuple(vibrations), linear.A, tuple(notes))


def _phasor(x: complex, unit: str) -> str:
    """Return a deviation with its unit, and its phase where that is neither 0 nor 180 deg."""
    behind = "" if unit == "1" else f" {unit}"
    if abs(x.imag) <= 1e-6 * abs(x):
        return f"{x.real:.4g}{behind}"
    return f"{abs(x):.4g}{behind} at {math.degrees(cmath.phase(x)):.1f} deg"
