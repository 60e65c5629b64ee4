"""Equilibria: positions of rest, what holds them, and what they leave open.

They are those of a model in the joints' coordinates, with its drives held where they are at a time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, among, refuse, shown
from hertzwerk.runtime.analysis.statics.balance import (
    UNDAMPED,
    along_of,
    drifting,
    grip_names,
    grip_pairs,
    kernel,
    memory_of,
    sizes_of,
)
from hertzwerk.runtime.analysis.statics.relaxation import Rest, Search
from hertzwerk.runtime.engine.inputs.input_values import Input, with_input_values
from hertzwerk.runtime.engine.integration.step.set_valued_friction import turns
from hertzwerk.runtime.engine.model import build
from hertzwerk.runtime.engine.model.binding import Value, flag_faults
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.signal import constant
from hertzwerk.runtime.engine.run.run_request import input_faults, read_duration
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.start.assembly import closed_near, journals
from hertzwerk.runtime.engine.start.start_values import start_of, stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.output.tables.notebook import Printed
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from matplotlib.figure import Figure


FOLLOWED = 100  # steps in which a start is followed to a later time
TIME = "held_time"  # parameter: time at whose positions the drives are held

OPEN = 1e-12  # stiffness over the largest below which a freedom is indifferent
SHARED = 1e-6  # singular value, and part of a vector, below which it counts as zero
ROUNDING = 1e-15  # coordinate over its scale below which it is shown as 0
REPORTED = 1e-8  # part of the forces that counts as unbalanced


@per_model
def held(model: EngineModel) -> EngineModel:
    """Return a model for statics: itself, or its scene by the joints' coordinates with every drive held.

    A held drive stands where it would be at the parameter `held_time`, an elastic-plastic contact loads. Raises InputError for a model without its
    scene, as a saved run has it.
    """
    drives, dents = drives_of(model), dents_of(model)
    if not drives and not dents and model.joints is model:
        return model
    scene = model.declared_for("statics").scene()
    scene = build.held(scene) if drives else scene
    return engine_model(replace(build.loading(scene) if dents else scene, coordinates="tree"))


def drives_of(model: EngineModel) -> tuple[str, ...]:
    """Return the names of a model's drives."""
    return tuple(name for name, kind, _ in model.module.EFFECTS if kind == "drive")


def dents_of(model: EngineModel) -> tuple[str, ...]:
    """Return the pairs of a model whose law is elastic-plastic."""
    return tuple(pair for pair in model.pairs if f"{pair}.dent" in model.coordinates)


def parameters_at(model: EngineModel, held: EngineModel, parameters: Mapping[str, Value], t: float) -> dict[str, Value]:
    """Return parameters of a model as those of its held one at a time t [s]; raises InputError.

    A drive whose speed or acceleration is given is integrated: where it is at a later time is not known beforehand.
    """
    integrated = [name for name in model.coordinates if name not in held.coordinates] if t and held is not model else []
    if integrated:
        actual = f"t = {t:g} s, for which {', '.join(integrated)} would have to be integrated"
        raise InputError(model.name, [Fault("at", actual, "0 s, or drives whose position is given")])
    known = {
        name: value for name, value in parameters.items() if name in held.parameters or name not in model.parameters
    }
    return {**known, TIME: (t, "s")} if TIME in held.parameters else known


def start_at(
    model: EngineModel, held: EngineModel, parameters: Mapping[str, Value], initial: Mapping[str, Value], t: float
) -> tuple[BoundParameters, Array]:
    """Return the numbers at a time t [s], and a position q (nq,) to search from; raises InputError.

    The scene states its start at t = 0: closed loops and journals are followed from there, within a period, unless
    something is given for the time itself.
    """
    if held is model or not t or initial or not (held.nl or journals(held)):
        bound, q, _ = start_of(held, parameters, initial)
        return bound, q
    bound, q, _ = start_of(held, {**parameters, TIME: (0.0, "s")}, initial)
    period = model.period(model.bind({name: value for name, value in parameters.items() if name in model.parameters}))
    for part in np.linspace(0, 1, FOLLOWED + 1)[1:]:
        there = held.bind({**parameters, TIME: (part * (t % period if period else t), "s")})
        q = closed_near(held, there, q, t, centred=bool(journals(held)))
    return held.bind(parameters), q


def drive_units(held: EngineModel) -> dict[str, str]:
    """Return the unit of what every drive of a held model supplies, in the order of the model's reactions."""
    if not drives_of(held) or held.declaration is None:
        return {}
    scene: Any = held.declaration.scene()
    closing = scene.prescribed
    freedoms = [*(freedom for freedom in scene.mechanism.freedoms if freedom not in closing), *closing]
    force = {"rad": "N m", "m": "N"}
    driven = scene.driven
    return {driven[freedom.key].name: force[freedom.units[0]] for freedom in freedoms if freedom.key in driven}


@dataclass(frozen=True)
class Equilibrium(Printed, Mapping[str, Value]):
    """Position of rest of a model at a time; as a mapping, the `initial` of a run.

    outcome     "found"; "not_unique" where freedoms are indifferent; "no_equilibrium"
    stable      whether every small displacement is pushed back (indifferent ones are not pushed at all)
    contacts    normal force of every pair [N], 0 where it is open; penetrations [m] of the closed ones
    drives      force [N] or moment [N m] of every drive, held where it is
    sticking    friction of pairs that stick: force along the tangent [N], its size where there are two, or deflection of the
                bristle [m]; moment of resistances to rolling and drilling [N m]
    indifferent coordinates that no force holds; indeterminate: constraints and contacts whose forces do not follow from
                balance: those of contacts from their stiffness, those of redundant constraints from nothing
    """

    model: EngineModel
    bound: BoundParameters = field(repr=False)
    t: float
    q: Array = field(repr=False)
    memory: Array = field(repr=False)
    closed: Array = field(repr=False)
    outcome: Outcome
    stable: bool
    contacts: Mapping[str, float]
    penetrations: Mapping[str, float]
    drives: Mapping[str, float]
    sticking: Mapping[str, float]
    indifferent: tuple[str, ...]
    indeterminate: tuple[str, ...]
    residual: float
    of: EngineModel = field(repr=False)  # whose equilibrium was asked for

    def __getitem__(self, name: str) -> Value:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __hash__(self) -> int:
        return id(self)

    @cached_property
    def _values(self) -> dict[str, Value]:
        model = self.model
        own = {name: (float(value), model.units[name]) for name, value in zip(model.coordinates, self.q, strict=True)}
        still = {} if self.drives else {name: (0.0, model.units[name]) for name in model.speeds}
        return {**own, **still}

    @property
    def converged(self) -> bool:
        """Return whether the position is one of rest."""
        return self.outcome.name != "no_equilibrium"

    def plot(self) -> Figure:
        """Draw the mechanism at rest, with its forces named; raises InputError where there is no equilibrium."""
        from hertzwerk.runtime.output.drawings.mode_shapes import at_rest

        if not self.converged:
            fault = Fault("plot", f"no equilibrium: {self.outcome.message}", "a position of rest", self.outcome.remedy)
            raise InputError(self.model.name, [fault])
        wanted = ("normal force", "drive")
        forces = [f"{name} {value:.4g} {unit}" for kind, name, value, unit in self.rows if kind in wanted]
        caption = f"At rest{': ' if forces else ''}{', '.join(forces)}."
        return at_rest(self.model, self.bound, self.t, self.q, caption, self.notes)

    @property
    def rows(self) -> tuple[tuple[str, str, float, str], ...]:
        """Every number as (kind, name, value, unit); none without an equilibrium."""
        model = self.model
        if not self.converged:
            return ()
        units, sizes = drive_units(model), model.evaluate("scales", self.bound.p)[0]
        grips = dict.fromkeys(grip_names(model), "m")
        grips |= {slip.rpartition(".")[0]: "N m" if turns(slip) else "N" for slip, *_ in model.slips}
        rows = [
            ("coordinate", name, float(x) if abs(x) > ROUNDING * size else 0.0, model.units[name])
            for name, x, size in zip(model.coordinates, self.q, sizes, strict=False)
        ]
        rows += [("normal force", name, x, "N") for name, x in self.contacts.items()]
        rows += [("penetration", name, x, "m") for name, x in self.penetrations.items()]
        rows += [("drive", name, x + 0.0, units[name]) for name, x in self.drives.items()]  # -0 is 0
        rows += [("sticks", name, x, grips[name]) for name, x in self.sticking.items()]
        return tuple(rows)

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks: instability, one equilibrium of several, forces that statics does not determine."""
        remarks = [] if self.stable or not self.converged else ["unstable: some displacement grows"]
        if self.indifferent:
            remarks.append(f"indifferent: {', '.join(self.indifferent)} may have other values; no force holds them")
        if self.sticking and self.converged:
            remarks.append(f"one of many: {', '.join(self.sticking)} sticks, and holds within a range of positions")
        if self.indeterminate:
            remarks.append(
                f"statically indeterminate: balance alone does not determine the forces of {', '.join(self.indeterminate)}"
            )
        return tuple(remarks)

    def __repr__(self) -> str:
        return f"<Equilibrium {self.model.name}: {self.outcome.name}>"

    def __str__(self) -> str:
        lines = [
            f"{self.outcome.name}: {self.outcome.message}",
            *([self.outcome.remedy] if self.outcome.remedy else []),
        ]
        lines += [f"{kind:<13} {name} = {_shown(value, unit)}" for kind, name, value, unit in self.rows]
        return "\n".join([*lines, *self.notes])


def equilibrium(
    target: Target,
    *,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    at: str | float = 0.0,
    nearest: bool = False,
) -> Equilibrium:
    """Compute an equilibrium of a scene, with its drives held at a time.

    target     a scene or a Model, as `simulate` takes it
    parameters, initial    values that replace the scene's, with units; the search begins at that start
    inputs     values of the scene's inputs, as `simulate` takes them
    at         time [s] or text such as "2 ms": of drives, inputs, and loads that depend on time
    nearest    take the equilibrium that Newton's method finds from the start, stable or not. By default a strongly damped
               motion from the start is followed until it rests: contacts close on the way, and unstable positions are left

    Loads, springs and the elastic forces of closed contacts act. Dampers, smoothed friction and drives whose force depends on
    the speed alone hold nothing at rest. Set-valued friction and bristles hold up to their limit. The result is
    an `initial` of `simulate`. Invalid input alone raises InputError; `Equilibrium.outcome` states whether there is an equilibrium.
    """
    model: EngineModel = engine_model(target)
    if model.rubbing:
        names = ", ".join(name for name, *_ in model.rubbing)
        why = "set-valued friction of joints, which holds them at rest wherever they stop"
        raise InputError("equilibrium", [Fault(names, why, "friction of contacts, or by a smooth law",
                                               "simulate: a run ends where they rest.")])  # fmt: skip
    faults: list[Fault] = []
    values, wanted = stated_values(model, parameters, initial, faults)
    refuse(model.name, [*faults, *flag_faults(nearest=nearest)])
    t = _time(model, at)
    model = inputs_at(model, inputs, t)
    still = held(model)
    still = model if still.module is model.module else still.with_signals(model.signals)
    at_time = parameters_at(model, still, values, t)
    if still is not model:  # what moves is held: its speeds are 0
        speeds = {*model.joints.speeds, *model.latches}
        wanted = {name: value for name, value in wanted.items() if name not in speeds}
    bound, q = start_at(model, still, at_time, wanted, t)
    search = Search(still, bound, t)
    with np.errstate(all="ignore"):  # what is not finite is no equilibrium
        rest = search.nearest(q) if nearest else search.relaxed(q)
        return _result(model, still, bound, t, search, rest)


def inputs_at(model: EngineModel, inputs: Mapping[str, Input] | None, t: float) -> EngineModel:
    """Return a model whose inputs keep the values that they have at a time [s]; raises InputError."""
    if not model.inputs and inputs is None:
        return model
    model, faults = with_input_values(model, inputs, t or 1.0, {})
    faults += input_faults(model, t, faults)
    refuse(model.name, faults)
    at = {name: float(signal(np.array([t]))[0]) for name, signal in model.signals.items()}
    return model.with_signals({name: constant(value, f"{value:g}") for name, value in at.items()})


def _time(model: EngineModel, at: str | float) -> float:
    if among(at, 0, "0"):
        return 0.0
    faults: list[Fault] = []
    t = read_duration(model, {}, at, faults)
    if faults:
        raise InputError(model.name, [Fault("at", shown(at), 'a time from 0 s on, such as "2 ms"')])
    return t


def _result(
    of: EngineModel, model: EngineModel, bound: BoundParameters, t: float, search: Search, rest: Rest
) -> Equilibrium:
    at, grips = rest.balance, grip_names(model)
    touching = [j for j in range(model.k) if rest.closed[j]]
    held = np.where([grips.count(name) > 1 for name in grips], sizes_of(model, rest.mu), rest.mu)
    sticking = {name: float(held[i]) for i, name in enumerate(grips) if rest.closed[grip_pairs(model)[i]]}
    least, indifferent = _least_stiffness(model, search, rest) if rest.converged else (0.0, ())
    return Equilibrium(
        model=model,
        bound=bound,
        t=t,
        q=rest.q,
        memory=memory_of(model, rest.mu),
        closed=rest.closed,
        outcome=_outcome(model, rest, indifferent, drifting(model, bound, t, rest.q)),
        stable=rest.converged and least >= 0,
        contacts={pair: float(at.normal[j]) for j, pair in enumerate(model.pairs)},
        penetrations={model.pairs[j]: float(-at.gap[j]) for j in touching},
        drives=_drives(model, bound, t, rest),
        sticking=sticking,
        indifferent=indifferent if rest.converged else (),
        indeterminate=_indeterminate(model, search, rest) if rest.converged else (),
        residual=float(np.max(np.abs(rest.unbalanced), initial=0.0)),
        of=of,
    )


def _shown(value: float, unit: str) -> str:
    return f"{value:.9g}" if unit == "1" else f"{value:.9g} {unit}"


def _outcome(model: EngineModel, rest: Rest, indifferent: tuple[str, ...], drifting: Mapping[str, float]) -> Outcome:
    if rest.converged and indifferent:
        return Outcome("not_unique", f"at rest, with {', '.join(indifferent)} indifferent", "state them in `initial`")
    if rest.converged:
        return Outcome("found", "at rest", "")
    if drifting:
        units = model.units
        remarks = ", ".join(f"{name} by {rate:.3g} ({units[name]})/s" for name, rate in drifting.items())
        remedy = "a motion that keeps its speed has no position of rest: `modes(run, at=...)` is about its motion"
        return Outcome("no_equilibrium", f"states change although nothing moves: {remarks}", remedy)
    loose = [
        f"{name} by {abs(part):.2g}"
        for name, part in zip(model.speeds, rest.unbalanced, strict=True)
        if abs(part) > REPORTED
    ]
    if not loose:
        remedy = "start nearer to a position of rest; one in which a loop is singular, its links along one line, is not found"
        return Outcome("no_equilibrium", "forces balance where the search ended, but loops stay open there", remedy)
    outside = [pair for pair, good in zip(model.pairs, rest.balance.in_range, strict=True) if good < 0.5]
    why = (
        f"the laws of {', '.join(outside)} are not defined at the loads"
        if outside
        else "nothing holds the mechanism at rest"
    )
    slides = [pair for j, pair in enumerate(model.pairs) if rest.closed[j] and j not in grip_pairs(model)]
    smooth = any(kind == "friction" for _, kind, _ in model.module.EFFECTS) and slides
    remedy = "look for a load without a support, or start nearer to a position of rest"
    if smooth:
        remedy += "; smoothed friction holds nothing at rest; the laws coulomb and lugre do"
    return Outcome("no_equilibrium", f"{why}; unbalanced, of the forces: {', '.join(loose)}", remedy)


def _least_stiffness(model: EngineModel, search: Search, rest: Rest) -> tuple[float, tuple[str, ...]]:
    """Return the sign of the least stiffness of what can move, and the coordinates without any."""
    free = kernel(np.vstack([rest.balance.G, rest.balance.S[_sticks(model, rest)]]) * search.scale)
    stiffness = free.T @ (search.scale[:, None] * rest.balance.stiffness * search.scale) @ free
    if not stiffness.size:
        return 0.0, ()
    _, sizes, ways = np.linalg.svd(stiffness)
    open_ = sizes <= OPEN * max(float(sizes[0]), 1e-300)
    least = float(np.linalg.eigvalsh((stiffness + stiffness.T) / 2)[0])
    moved = np.abs(free @ ways[open_].T) * search.scale[:, None]
    names = _coordinates_of(model, rest.balance.moves)
    loose = [names[i] for i in range(model.nu) if np.max(moved[i] / search.scale[i], initial=0.0) > SHARED**0.5]
    return (0.0 if least >= -OPEN * float(sizes[0]) else -1.0), tuple(dict.fromkeys(loose))


def _indeterminate(model: EngineModel, search: Search, rest: Rest) -> tuple[str, ...]:
    """Return constraints and closed contacts whose forces can be in balance among themselves."""
    at, sticks = rest.balance, _sticks(model, rest)
    touching = [j for j in range(model.k) if rest.closed[j]]
    columns = np.vstack([at.G, at.W[touching], at.S[sticks]]) * search.scale
    names = [*model.constraints, *(model.pairs[j] for j in touching), *(f"{grip_names(model)[i]}" for i in sticks)]
    if not len(columns):
        return ()
    sizes = np.maximum(np.linalg.norm(columns, axis=1), 1e-300)
    ways = kernel((columns / sizes[:, None]).T)
    return tuple(
        dict.fromkeys(name for name, row in zip(names, ways, strict=True) if np.max(np.abs(row), initial=0.0) > SHARED)
    )


def _sticks(model: EngineModel, rest: Rest) -> list[int]:
    return [i for i, j in enumerate(grip_pairs(model)) if rest.closed[j]]


def _coordinates_of(model: EngineModel, moves: Array) -> list[str]:
    """Return the coordinate that each speed moves, or the orientation that it turns."""
    coordinates, turned = [], {i + k for i in model.quaternions for k in range(4)}
    for column in moves.T:
        row = int(np.argmax(np.abs(column)))
        name = model.coordinates[row]
        coordinates.append(f"{name.rpartition('.')[0]}.orientation" if row in turned else name)
    return coordinates


def _drives(model: EngineModel, bound: BoundParameters, t: float, rest: Rest) -> dict[str, float]:
    """Return what every drive supplies to hold its joint [N or N m]."""
    names = drive_units(model)
    if not names:
        return {}
    still, z = np.zeros(model.nu), memory_of(model, rest.mu)
    m = np.concatenate([np.full(model.nm - model.ns, UNDAMPED), np.zeros(model.ns)])
    forces = model.evaluate("applied", t, rest.q, still, bound.c)[0].copy()
    for j, pair in enumerate(model.pairs):
        if rest.closed[j]:
            f, *others = model.evaluate(f"contact_{pair}", t, rest.q, still, z, m, bound.c)
            forces += f
            mine = [i for i, own in enumerate(grip_pairs(model)[: model.ns]) if own == j]
            if mine:
                forces += along_of(model, others[4]) @ rest.mu[mine]
    _, reactions, *_ = model.evaluate("accelerations", t, rest.q, still, forces, bound.c)
    return {drive: float(value) for drive, value in zip(names, reactions, strict=False)}  # then those that loads read
