"""Assembly: close every loop and centre every journal at the start, keeping the given values.

The other coordinates begin at the scene's value, or zero, and are moved as little as closing takes (Gauss-Newton in
the scene's scales, rank by singular values). A start that is closed as it stands is unchanged. Loops must close; a
pin in its bush, or a ball in its socket, is closed as a joint as far as the given values allow: at the start the
mechanism moves as the ideal one, without clearance.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.start.intrusion import intrusions
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import BoundParameters, Dependent, EngineModel
    from hertzwerk.runtime.system.arrays import Array


CLOSED = 1e-11  # residual that counts as closed, relative to the sizes in a loop
ITERATIONS, HALVINGS = 60, 30
STALLED = 1e-3  # relative reduction of the residual below which iteration stops
UNDER = "under-determined"
TRIES = 20  # other starting points
RANK = 1e-9  # singular values below this part of the largest count as zero
AWAY = 1e-6  # the same away from singular positions
AROUND = 8  # positions near the start that are tried
NEAR = 0.3  # rad, or relative to the size: their largest distance
TOGETHER = 40  # most constraints in a dependent group: with more, choosing among them costs more than the steps


def assemble(
    model: EngineModel, bound: BoundParameters, q: Array, u: Array, fixed: Collection[str]
) -> tuple[Array, Array, tuple[Fault, ...]]:
    """Return coordinates (nq,), speeds (nu,) of the joints with loops and journals closed, and faults.

    Those named in `fixed` are kept. Where a journal cannot be centred it may be anywhere in its bush: the other
    coordinates then stay as passed, or, where that is outside, go where the journals are nearest to their middles.
    """
    loops, ideal = _Loops(model.joints, bound), _Loops(model.joints, bound, whole=model)
    stated = q
    q, faults = _position(loops, stated, fixed)
    if journals(model) and (faults or not ideal.closed(q)):
        centred, unclosed = _position(ideal, stated, fixed)
        if not unclosed:
            q, faults = centred, ()
        elif not faults and not ideal.inside(q):
            if _under(unclosed):
                return q, u, (*unclosed, *_under(_speed(ideal, centred, u, fixed)[1]))
            nearest = _nearest(ideal, stated, fixed)
            if nearest is None:
                return q, u, _with_closing_change(ideal, stated, fixed, unclosed)
            q = nearest
    if faults:
        return q, u, (*faults, *(_under(_speed(loops, q, u, fixed)[1]) if _under(faults) else ()))
    if not journals(model):
        return q, *_speed(loops, q, u, fixed)
    moving, unclosed = _speed(ideal, q, u, fixed)
    if unclosed and loops.rows:  # the journals move in their bushes, the loops stay closed
        return q, *_speed(loops, q, u, fixed)
    return q, moving, _under(unclosed)


def _under(faults: tuple[Fault, ...]) -> tuple[Fault, ...]:
    return tuple(fault for fault in faults if fault.found.startswith(UNDER))


def assemble_at(
    model: EngineModel, bound: BoundParameters, q: Array, u: Array, fixed: Collection[str], seats: Array
) -> tuple[Array, Array, tuple[Fault, ...]]:
    """Return coordinates, speeds and faults with journals at rest at the eccentricities `seats` [m].

    Those named in `fixed` are kept; faults where they prevent closing.
    """
    loops = _Loops(model.joints, bound, whole=model, seats=seats)
    unknown = [i for i, name in enumerate(loops.model.coordinates) if name not in fixed]
    q = _closed(loops, q, unknown, loops.at(q).size)
    q, faults = _position(loops, q, fixed)
    u, more = _speed(loops, q, u, fixed)
    return q, u, tuple(fault for fault in faults or more if not fault.found.startswith(UNDER))


def closed_near(model: EngineModel, bound: BoundParameters, q: Array, t: float, *, centred: bool = False) -> Array:
    """Return the position at a time t [s] with closed loops that Gauss-Newton steps from q (nq,) lead to.

    centred: also with the journals in the middle of their bushes.
    """
    loops = _Loops(model, bound, t, whole=model if centred else None)
    if not loops.rows:
        return q
    return _closed(loops, q, list(range(model.nq)), loops.at(q).size)


def journals(model: EngineModel) -> list[int]:
    """Return the rows of the outputs that vanish in closed clearances: all eccentricities."""
    return [row for rows in model.journals.values() for row in rows]


@per_model
def eccentricities(model: EngineModel) -> Any:
    """Return the CasADi function (t, q, u, c) -> eccentricities of all journals, and their rates."""
    t, q, *_ = at = model.symbols("t q u c")
    e = model.function("outputs")(*at)[journals(model)]
    rates = ca.vertcat(1, model.function("coordinate_rates")(*at))
    return ca.Function("eccentricities", at, [e, ca.jtimes(e, ca.vertcat(t, q), rates)])


def _nearest(ideal: _Loops, q: Array, fixed: Collection[str]) -> Array | None:
    """Return the position with closed loops whose journals are nearest to the middles of their bushes.

    None if there is none.
    """
    unknown = [i for i, name in enumerate(ideal.model.coordinates) if name not in fixed]
    loops, tries = replace(ideal, whole=None), _tries(ideal, q, unknown, ideal.at(q).size)
    return next((place for place in tries if loops.closed(place) and ideal.inside(place)), None)


def _with_closing_change(
    ideal: _Loops, q: Array, fixed: Collection[str], faults: tuple[Fault, ...]
) -> tuple[Fault, ...]:
    """Add to faults of an over-determined start the least change of one given coordinate that closes it."""
    ways = []
    for i, name in enumerate(ideal.model.coordinates):
        if name in fixed and ideal.model.units[name] != "1":
            closed, unclosed = _position(ideal, q, [other for other in fixed if other != name])
            if not unclosed:
                ways.append((abs(closed[i] - q[i]) / ideal.scales[0][i], i, closed[i]))
    if not ways:
        return faults
    _, i, there = min(ways)
    name, unit = ideal.model.coordinates[i], ideal.model.units[ideal.model.coordinates[i]]
    way = f"{name} at {there:.6g} {unit} in place of {q[i]:.6g} {unit} closes it, a change of {there - q[i]:.3g} {unit}"
    return tuple(replace(fault, remedy=f"{way}; {fault.remedy}") for fault in faults)


def moved_by_loops(model: EngineModel, bound: BoundParameters, q: Array) -> Array:
    """Return whether each coordinate (nq,) enters a constraint at a position."""
    moved: Array = np.any(_Loops(model, bound).at(q).by_q != 0, axis=0)
    return moved


def undetermined(model: EngineModel, bound: BoundParameters, q: Array) -> tuple[str, ...]:
    """Return the redundant constraints at a position, whose forces the motion leaves undetermined."""
    unclosed = np.max(np.abs(_implied(_Loops(model, bound), q)), axis=0, initial=0.0) > RANK**0.5
    return tuple(name for name, is_open in zip(model.constraints, unclosed, strict=True) if is_open)


@np.errstate(all="ignore")
def dependent(model: EngineModel, bound: BoundParameters, q: Array) -> tuple[Dependent, ...]:
    """Return groups of constraints that are dependent at all positions within reach, not just at q.

    Nearby positions are tried: at a singular one, such as a change point, constraints are dependent that are not
    elsewhere.
    """
    if not model.nl or not len(_implied(_Loops(model, bound), q)):
        return ()
    ways = [_implied(_Loops(model, bound, time), place, AWAY) for time, place in _nearby(model, bound, q)]
    least = min(map(len, ways), default=0)
    if not least:
        return ()
    shares = [way.T @ way for way in ways if len(way) == least]
    tied = np.max(np.abs(shares), axis=0) > RANK**0.5
    groups, rest = [], {int(i) for i in np.flatnonzero(np.diag(tied))}
    while rest:
        group, fresh = set(), {min(rest)}
        while fresh:
            group |= fresh
            fresh = {int(j) for i in fresh for j in np.flatnonzero(tied[i])} - group
        rest -= group
        members = tuple(sorted(group))
        implied = round(float(np.trace(shares[0][np.ix_(members, members)])))
        if len(members) <= TOGETHER:
            groups.append((members, len(members) - implied))
    return tuple(groups)


def _nearby(model: EngineModel, bound: BoundParameters, q: Array) -> Iterator[tuple[float, Array]]:
    """Yield times and positions around a start that the mechanism can reach."""
    _, _, jacobian, _, size, _ = _Loops(model, bound).at(q)
    reach = _reach(model, jacobian)
    _, values, vectors = np.linalg.svd(jacobian * reach / size[:, None])
    free = vectors[int(np.sum(values > RANK * values[0])) :]
    *_, scene = model.evaluate("scales", bound.p)
    rng, every = np.random.default_rng(0), list(range(model.nq))
    for _ in range(AROUND):
        later = _Loops(model, bound, float(NEAR * rng.uniform(0.5, 1) * scene[0] / scene[1]))
        way = free.T @ rng.uniform(-1, 1, len(free))
        way *= NEAR / max(float(np.max(np.abs(way), initial=0.0)), NEAR)
        furthest = int(np.argmax(np.abs(way)))  # stays, or closing the loops would lead back to a singular position
        for unknown in ([i for i in every if i != furthest], every):
            place = _closed(later, q + reach * way, unknown, size)
            away = np.max(np.abs(place - q) / reach) > NEAR / 10
            if away and np.all(np.abs(later.at(place).phi) <= size):
                yield later.t, place
                break


def _implied(loops: _Loops, q: Array, rank: float = RANK) -> Array:
    """Return the linear combinations of constraints that vanish at a position; orthonormal rows (n, nl).

    Constraints are scaled by the largest of their unit.
    """
    matrix = loops.at(q).by_u * loops.scales[1]
    norms, lengths = np.linalg.norm(matrix, axis=1), np.array(loops.model.is_length)
    sizes = np.where(lengths, *(np.max(norms, where=which, initial=1e-300) for which in (lengths, ~lengths)))
    scaled = matrix / sizes[:, None]
    values = np.linalg.svd(scaled, compute_uv=False)
    count = int(np.sum(values > rank * values[0]))
    if count == len(scaled):  # as nearly always; vectors take ten times as long
        return np.zeros((0, count))
    return np.linalg.svd(scaled)[0][:, count:].T


class At(NamedTuple):
    """Constraints at a position and speed.

    phi, rate    (nl,)
    by_q, by_u    their derivatives (nl, nq) by q, (nl, nu) by u
    size, rate_size    residuals of each that count as closed (nl,)
    """

    phi: Array
    rate: Array
    by_q: Array
    by_u: Array
    size: Array
    rate_size: Array


@dataclass(frozen=True)
class _Loops:
    """Constraints of a model by its joints' coordinates at the start, evaluated as numbers.

    Those of closed clearances are included for a `whole` model; their eccentricities are `seats` [m], None for zero.
    """

    model: EngineModel
    bound: BoundParameters
    t: float = 0.0
    whole: EngineModel | None = None
    seats: Array | None = None

    @cached_property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Name and unit of every constraint."""
        return _rows(self.model, self.whole)

    @property
    def wanted(self) -> str:
        """Goal of the assembly, in words."""
        held = ", ".join(["closed loops", *(["couplings that hold"] if self.couplings else [])])
        if self.seats is not None:
            return f"{held}, journals that rest in their bushes"
        return held if self.whole is None else f"{held}, pins in their bushes and balls in their sockets"

    def closed(self, q: Array) -> bool:
        """Return whether a position is closed as it stands."""
        at = self.at(q)
        return bool((np.abs(at.phi) <= at.size).all())

    def inside(self, q: Array) -> bool:
        """Return whether every journal of the whole model is in its bush, but for a plausible penetration."""
        if self.whole is None:
            return True
        q, u = self.whole.placed(self.bound, q, np.zeros(self.model.nu))
        return not any(overlap.too_deep for overlap in intrusions(self.whole, self.bound, q, u))

    @cached_property
    def scales(self) -> tuple[Array, Array]:
        """Scales of coordinates and speeds."""
        sq, su, *_ = self.model.evaluate("scales", self.bound.p)
        return sq, su

    @property
    def drives(self) -> list[str]:
        """Names of the drives, which fix coordinates."""
        return self._effects("drive")

    @property
    def couplings(self) -> list[str]:
        """Names of the couplings."""
        return self._effects("coupling")

    def _effects(self, wanted: str) -> list[str]:
        return [name for name, kind, _ in self.model.module.EFFECTS if kind == wanted]

    def at(self, q: Array, u: Array | float = 0.0) -> At:
        """Return the constraints at a position (nq,) and speed (nu,)."""
        phi, rate, by_q, by_u, *sizes = judged(self.model, self.whole)(self.t, q, u, self.bound.c, self.scales[1])
        if self.seats is not None:
            phi[len(phi) - len(self.seats) :] -= self.seats
        return At(phi, rate, by_q.reshape(len(phi), self.model.nq), by_u.reshape(len(phi), self.model.nu), *sizes)

    def unclosed(self, residual: Array, size: Array) -> list[str]:
        """Describe what is open, by joint: the worst of each."""
        worst: dict[str, tuple[float, str]] = {}
        for (name, unit), value, least in zip(self.rows, np.abs(residual), size, strict=True):
            whose, _, kind = name.rpartition(".")
            if not value <= least and value >= worst.get(whose, (0.0, ""))[0]:
                couples = kind in ("off", "turned")  # a joint's have an axis
                worst[whose] = (value, f"{whose} {'off' if couples else 'open'} by {value:.3g}"
                                f"{f' {unit}' if unit != '1' else ' rad' if couples else ''}")  # fmt: skip
        return [text for _, text in worst.values()]


@per_model
def residuals(model: EngineModel, whole: EngineModel | None) -> Any:
    """Build the function (t, q, u, c) -> constraints of the joints' `model`, rates, derivatives: see `At`.

    Those of closed clearances are included for a `whole` model.
    """
    t, q, u, c = model.symbols("t q u c")
    sides = [model.function("constraints")(t, q, u, c)] if model.nl else []
    if whole is not None and journals(whole):
        joints = (q, u) if whole.joints is whole else whole.function("placed")(t, q, u, c)
        sides.append(eccentricities(whole)(t, *joints, c))
    phi, rate = (ca.vertcat(*(side[k] for side in sides)) for k in (0, 1))
    results = (phi, rate, ca.jacobian(phi, q), ca.jacobian(rate, u))
    return ca.Function("loops", [t, q, u, c], [ca.densify(x) for x in results])


@per_model
def judged(model: EngineModel, whole: EngineModel | None) -> Callers:
    """Build the function (t, q, u, c, scales of u) -> residuals, and how large they may be: see `At`."""
    arguments, scale, units = (
        model.symbols("t q u c"),
        ca.SX.sym("scale", model.nu),
        [row[1] for row in _rows(model, whole)],
    )
    _, q, u, _ = arguments
    values = residuals(model, whole)(*arguments)
    sizes = _sizes(values[2], q, units), _sizes(values[3], ca.fmax(ca.fabs(u), scale), units)
    return Callers(ca.Function("judged", [*arguments, scale], [*values, *sizes]))


def _rows(model: EngineModel, whole: EngineModel | None) -> tuple[tuple[str, str], ...]:
    """Return name and unit of every constraint; of a `whole` model those of closed clearances too."""
    closed = () if whole is None else tuple(whole.module.OUTPUTS[i] for i in journals(whole))
    return (*model.module.CONSTRAINTS, *closed)


def _sizes(jacobian: Any, values: Any, units: Sequence[str]) -> Any:
    """Return the residual of each constraint that counts as closed.

    CLOSED times the largest motion by a coordinate, an angle counting as 1 at least; the largest among all
    constraints of its unit, because one row alone may vanish where a mechanism is stretched out.
    """
    motions = ca.fabs(jacobian) * ca.repmat(ca.fmax(ca.fabs(values), 1).T, jacobian.size1())
    rows = {unit: [i for i, one in enumerate(units) if one == unit] for unit in units}
    largest = {unit: ca.mmax(ca.vertcat(1e-9, ca.vec(motions[alike, :]))) for unit, alike in rows.items()}
    return ca.vertcat(*(CLOSED * largest[unit] for unit in units))


def _position(loops: _Loops, q: Array, fixed: Collection[str]) -> tuple[Array, tuple[Fault, ...]]:
    model = loops.model
    if not loops.rows:
        return q, ()
    names = model.coordinates
    unknown = [i for i, name in enumerate(names) if name not in fixed]
    phi, _, jacobian, _, size, _ = loops.at(q)
    if (np.abs(phi) <= size).all():
        return q, ()
    position, *others = _tries(loops, q, unknown, size)
    if others:
        reach = _reach(model, jacobian)
        closed = [x for x in others if np.all(np.abs(loops.at(x).phi) <= size)]
        position = min(closed, key=lambda x: float(np.linalg.norm((x - q) / reach)), default=position)
    phi, _, jacobian, *_ = loops.at(position)
    unclosed = loops.unclosed(phi, size)
    closing = jacobian * loops.scales[0] / size[:, None]
    closing = np.vstack([closing, np.max(np.abs(closing)) * _norms(model, position)])
    free = _undetermined(closing[:, unknown], [names[i] for i in unknown])
    if unclosed:
        remedy = _remedies(
            [name for name in names if name in fixed],
            loops.drives if not free[0] else [],
            f"no position that was tried closes it: check {'its couplings and ' if loops.couplings else ''}the lengths between its joints, "
            "or state positions closer to an assembly in the scene's Start",
        )
        fault = Fault(
            "start, positions", f"over-determined or out of reach: {', '.join(unclosed)}", loops.wanted, remedy
        )
        return q, (fault,)
    return position, _under_determined("positions", *free)


def _tries(loops: _Loops, q: Array, unknown: list[int], size: Array) -> Iterator[Array]:
    """Yield the results of Gauss-Newton iterations from q and, if that one stays open, from places around."""
    position = _closed(loops, q, unknown, size)
    yield position
    if np.all(np.abs(loops.at(position).phi) <= size):
        return
    reach = _reach(loops.model, loops.at(q).by_q)
    for shift in np.random.default_rng(0).uniform(-0.7, 0.7, (TRIES, len(q))) * reach:
        yield _closed(loops, q + np.where(np.isin(np.arange(len(q)), unknown), shift, 0.0), unknown, size)


def _norms(model: EngineModel, q: Array) -> Array:
    """Return the gradients (n, nq) of the quaternions' norms."""
    rows = np.zeros((len(model.quaternions), model.nq))
    for row, i in zip(rows, model.quaternions, strict=True):
        row[i : i + 4] = q[i : i + 4]
    return rows


def _remedies(fixed: list[str], drives: list[str], otherwise: str) -> str:
    """Suggest what to leave out of a start whose loops stay open."""
    ways = [f"stated: {', '.join(fixed)}; omit some, which are then solved for"] if fixed else []
    if drives:
        ways.append(
            f"driven by {', '.join(drives)}: more drives than the loop has degrees of freedom, or beyond its range; omit one"
        )
    return "; or ".join(ways) or otherwise


def _closed(loops: _Loops, q: Array, unknown: list[int], size: Array) -> Array:
    """Return coordinates that close the loops as far as damped Gauss-Newton steps from q get."""
    q, scale = q.copy(), loops.scales[0]
    phi, _, jacobian, *_ = loops.at(q)
    for _ in range(ITERATIONS):
        norms = _norms(loops.model, q)
        across = jacobian - jacobian @ norms.T @ norms  # what a quaternion grew by would be taken back
        weighted = across[:, unknown] * scale[unknown] / size[:, None]
        step = scale[unknown] * np.linalg.lstsq(weighted, -phi / size, rcond=RANK)[0]
        before, start = np.linalg.norm(phi / size), q.copy()
        for halving in range(HALVINGS):
            q[unknown] = start[unknown] + step / 2**halving
            for i in loops.model.quaternions:
                q[i : i + 4] /= np.linalg.norm(q[i : i + 4])
            phi, _, jacobian, *_ = loops.at(q)
            after = np.linalg.norm(phi / size)
            if after < before:
                break
        else:
            return start
        if after > (1 - STALLED) * before:
            return q
    return q


def _speed(loops: _Loops, q: Array, u: Array, fixed: Collection[str]) -> tuple[Array, tuple[Fault, ...]]:
    model = loops.model
    if not loops.rows:
        return u, ()
    unknown = [i for i, name in enumerate(model.speeds) if name not in fixed]
    scale = loops.scales[1]
    _, rate, _, jacobian, _, size = loops.at(q, u)
    if (np.abs(rate) <= size).all():
        return u, ()
    weighted = jacobian[:, unknown] * scale[unknown] / size[:, None]
    u = u.copy()
    u[unknown] += scale[unknown] * np.linalg.lstsq(weighted, -rate / size, rcond=RANK)[0]
    unclosed = loops.unclosed(loops.at(q, u).rate, size)
    held = [name for name in model.speeds if name in fixed]
    if unclosed:
        remedy = _remedies(held, loops.drives, "the mechanism is locked here")
        return u, (
            Fault(
                "start, speeds",
                f"over-determined: {', '.join(f'{f}/s' for f in unclosed)}",
                "speeds at which the loops stay closed",
                remedy,
            ),
        )
    free = _undetermined(weighted, [model.speeds[i] for i in unknown])
    return u, _under_determined("speeds", *free)


def _reach(model: EngineModel, jacobian: Array) -> Array:
    """Return how far coordinates move in a mechanism: a radian, or the displacement by one."""
    return np.array([1.0 if model.units[name] == "rad" else np.max(np.abs(jacobian)) for name in model.coordinates])


def _undetermined(matrix: Array, names: list[str]) -> tuple[int, list[str]]:
    """Return the number of freedoms that constraints leave the unknowns, and the names that share them."""
    reached = np.linalg.norm(matrix, axis=0)
    bound_up = [i for i, length in enumerate(reached) if length > RANK * np.max(reached)]  # what no loop moves is free
    matrix, names = matrix[:, bound_up], [names[i] for i in bound_up]
    if not names:
        return 0, []
    _, values, vectors = np.linalg.svd(matrix)
    rank = int(np.sum(values > RANK * values[0])) if len(values) else 0
    moves = np.max(np.abs(vectors[rank:]), axis=0, initial=0.0)
    return len(names) - rank, [name for name, part in zip(names, moves, strict=True) if part > np.sqrt(RANK)]


def _under_determined(quantity: str, count: int, names: list[str]) -> tuple[Fault, ...]:
    if not count:
        return ()
    more = f"{count} more value{'s' if count > 1 else ''} among them"
    return (Fault(f"start, {quantity}", f"{UNDER}: {', '.join(names)}", more, "in the scene's Start, or `initial`"),)
