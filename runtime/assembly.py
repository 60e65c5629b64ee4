"""Assembly: a start in which every loop is closed, from the coordinates and speeds that are given; what is not given follows.

What is given stays. The rest begins at the scene's value, or zero, and is moved as little as closing the loops takes (Gauss-Newton in the scene's
scales, rank by singular values). A start that is closed as it stands is taken as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import Fault

if TYPE_CHECKING:
    from hertzwerk.runtime.model import Bound, Dependent, Model

Array = NDArray[np.float64]

CLOSED = 1e-11  # open by no more than this part of the sizes that meet in a loop
ITERATIONS, HALVINGS = 60, 30
TRIES = 20  # other places to begin at
RANK = 1e-9  # singular values below this part of the largest count as zero
AWAY = 1e-6  # and away from a singular position, which nothing there is near to
AROUND = 8  # positions near the start that are looked at
NEAR = 0.3  # rad, or of the size: how far off they are at most
TOGETHER = 40  # constraints that imply each other, at most: with more, choosing among them at every step costs more than the steps


def assemble(
    model: Model, bound: Bound, q: Array, u: Array, given: Collection[str]
) -> tuple[Array, Array, tuple[Fault, ...]]:
    """Coordinates (nq,) and speeds (nu,) with closed loops, near the ones passed; those named in `given` are kept. Faults where there are none."""
    loops = _Loops(model, bound)
    q, faults = _position(loops, q, given)
    if faults:
        return q, u, faults
    return q, *_speed(loops, q, u, given)


def undetermined(model: Model, bound: Bound, q: Array) -> tuple[str, ...]:
    """Constraints whose forces the motion leaves open at a position, because others say the same; none where all are independent."""
    open_ones = np.max(np.abs(_implied(_Loops(model, bound), q)), axis=0, initial=0.0) > RANK**0.5
    return tuple(name for name, is_open in zip(model.constraints, open_ones, strict=True) if is_open)


def dependent(model: Model, bound: Bound, q: Array) -> tuple[Dependent, ...]:
    """Groups of constraints of which some follow from the others wherever the mechanism goes from a position, not just there.

    Where it can go is tried: at a singular position, such as a change point, constraints are alike that are not elsewhere.
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


def _nearby(model: Model, bound: Bound, q: Array) -> Iterator[tuple[float, Array]]:
    """Times and positions around a start to which the mechanism can go."""
    loops = _Loops(model, bound)
    still = np.zeros(model.nu)
    _, _, jacobian, _ = loops.at(q, still)
    size, reach = _sizes(model, jacobian, q), _reach(model, jacobian)
    _, values, vectors = np.linalg.svd(jacobian * reach / size[:, None])
    free = vectors[int(np.sum(values > RANK * values[0])) :]
    *_, scene = (np.array(x).ravel() for x in model.function("scales")(bound.p))
    rng, every = np.random.default_rng(0), list(range(model.nq))
    for _ in range(AROUND):
        later = _Loops(model, bound, float(NEAR * rng.uniform(0.5, 1) * scene[0] / scene[1]))
        way = free.T @ rng.uniform(-1, 1, len(free))
        way *= NEAR / max(float(np.max(np.abs(way), initial=0.0)), NEAR)
        furthest = int(np.argmax(np.abs(way)))  # stays, or closing the loops would lead back to a singular position
        for unknown in ([i for i in every if i != furthest], every):
            place = _closed(later, q + reach * way, unknown, size)
            away = np.max(np.abs(place - q) / reach) > NEAR / 10
            if away and np.all(np.abs(later.at(place, still)[0]) <= size):
                yield later.t, place
                break


def _implied(loops: _Loops, q: Array, rank: float = RANK) -> Array:
    """Ways to add up constraints, each unit in the size of its largest, so that they forbid nothing at a position; orthonormal rows (n, nl)."""
    _, _, _, jacobian = loops.at(q, np.zeros(loops.model.nu))
    matrix = jacobian * loops.scales[1]
    norms, lengths = np.linalg.norm(matrix, axis=1), np.array(loops.model.is_length)
    sizes = np.where(lengths, *(np.max(norms, where=which, initial=1e-300) for which in (lengths, ~lengths)))
    left, values, _ = np.linalg.svd(matrix / sizes[:, None])
    ways: Array = left[:, int(np.sum(values > rank * values[0])) :].T
    return ways


@dataclass(frozen=True)
class _Loops:
    """The constraints of a model at its start, as numbers."""

    model: Model
    bound: Bound
    t: float = 0.0

    @property
    def scales(self) -> tuple[Array, Array]:
        """Of coordinates and speeds."""
        sq, su, *_ = (np.array(x).ravel() for x in self.model.function("scales")(self.bound.p))
        return sq, su

    @property
    def drives(self) -> list[str]:
        """Names of the drives, which fix coordinates."""
        return [name for name, kind, _ in self.model.module.EFFECTS if kind == "drive"]

    def at(self, q: Array, u: Array) -> tuple[Array, Array, Array, Array]:
        """Constraints (nl,), their rates (nl,), and the derivatives by coordinates (nl, nq) and of the rates by speeds (nl, nu)."""
        model = self.model
        return tuple(  # type: ignore[return-value]
            np.array(x).reshape(shape)
            for x, shape in zip(
                model.once("loops at the start", self._function)(self.t, q, u, self.bound.c),
                ((model.nl,), (model.nl,), (model.nl, model.nq), (model.nl, model.nu)),
                strict=True,
            )
        )

    def _function(self) -> Any:
        model = self.model
        t, q, u, c = ca.SX.sym("t"), ca.SX.sym("q", model.nq), ca.SX.sym("u", model.nu), ca.SX.sym("c", model.nc)
        phi, rate = model.function("constraints")(t, q, u, c)
        return ca.Function("loops", [t, q, u, c], [phi, rate, ca.jacobian(phi, q), ca.jacobian(rate, u)])

    def open_ones(self, residual: Array, size: Array) -> list[str]:
        """What is open, in words, by joint: the worst of each."""
        worst: dict[str, tuple[float, str]] = {}
        for (name, unit), value, least in zip(self.model.module.CONSTRAINTS, np.abs(residual), size, strict=True):
            joint = name.rsplit(".", 1)[0]
            if not value <= least and value >= worst.get(joint, (0.0, ""))[0]:
                worst[joint] = (value, f"{joint} open by {value:.3g}{'' if unit == '1' else f' {unit}'}")
        return [text for _, text in worst.values()]


def _position(loops: _Loops, q: Array, given: Collection[str]) -> tuple[Array, tuple[Fault, ...]]:
    model = loops.model
    names = model.coordinates
    unknown = [i for i, name in enumerate(names) if name not in given]
    still = np.zeros(model.nu)
    phi, _, jacobian, _ = loops.at(q, still)
    size = _sizes(model, jacobian, q)
    if np.all(np.abs(phi) <= size):
        return q, ()
    found = _closed(loops, q, unknown, size)
    if np.any(np.abs(loops.at(found, still)[0]) > size):  # stretched out, or on the way to nowhere: from places around
        reach = _reach(model, jacobian)
        around = np.random.default_rng(0).uniform(-0.7, 0.7, (TRIES, len(q))) * reach
        tries = (
            _closed(loops, q + np.where(np.isin(np.arange(len(q)), unknown), shift, 0.0), unknown, size)
            for shift in around
        )
        closed = [x for x in tries if np.all(np.abs(loops.at(x, still)[0]) <= size)]
        found = min(closed, key=lambda x: float(np.linalg.norm((x - q) / reach)), default=found)
    phi, _, jacobian, _ = loops.at(found, still)
    open_ones = loops.open_ones(phi, size)
    closing = jacobian * loops.scales[0] / size[:, None]
    closing = np.vstack([closing, np.max(np.abs(closing)) * _norms(model, found)])
    free = _undetermined(closing[:, unknown], [names[i] for i in unknown])
    if open_ones:
        remedy = _ways_out(
            [name for name in names if name in given],
            loops.drives if not free[0] else [],
            "no place that was tried closes it: check the lengths between its joints, or state positions nearer to one in the scene's Start",
        )
        fault = Fault(
            "start, positions", f"over-determined or out of reach: {', '.join(open_ones)}", "closed loops", remedy
        )
        return q, (fault,)
    return found, _under("positions", *free)


def _norms(model: Model, q: Array) -> Array:
    """What quaternions must not do, their lengths being 1: one row each (n, nq)."""
    rows = np.zeros((len(model.quaternions), model.nq))
    for row, i in zip(rows, model.quaternions, strict=True):
        row[i : i + 4] = q[i : i + 4]
    return rows


def _ways_out(given: list[str], drives: list[str], otherwise: str) -> str:
    """Of loops that stay open: what fixes coordinates and could be left out."""
    ways = [f"given: {', '.join(given)}; leave some of it to be found"] if given else []
    if drives:
        ways.append(
            f"driven by {', '.join(drives)}: more than the loop has freedoms for, or past where it can go; leave one out"
        )
    return "; or ".join(ways) or otherwise


def _closed(loops: _Loops, q: Array, unknown: list[int], size: Array) -> Array:
    """Coordinates that close the loops as far as Gauss-Newton steps, halved until they help, get from q."""
    q, scale, still = q.copy(), loops.scales[0], np.zeros(loops.model.nu)
    phi, _, jacobian, _ = loops.at(q, still)
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
            phi, _, jacobian, _ = loops.at(q, still)
            if np.linalg.norm(phi / size) < before:
                break
        else:
            return start
    return q


def _speed(loops: _Loops, q: Array, u: Array, given: Collection[str]) -> tuple[Array, tuple[Fault, ...]]:
    model = loops.model
    unknown = [i for i, name in enumerate(model.speeds) if name not in given]
    scale = loops.scales[1]
    _, rate, _, jacobian = loops.at(q, u)
    size = _sizes(model, jacobian, np.maximum(np.abs(u), scale))
    if np.all(np.abs(rate) <= size):
        return u, ()
    weighted = jacobian[:, unknown] * scale[unknown] / size[:, None]
    u = u.copy()
    u[unknown] += scale[unknown] * np.linalg.lstsq(weighted, -rate / size, rcond=RANK)[0]
    found = loops.open_ones(loops.at(q, u)[1], size)
    kept = [name for name in model.speeds if name in given]
    if found:
        remedy = _ways_out(kept, loops.drives, "the mechanism is locked here")
        return u, (
            Fault(
                "start, speeds",
                f"over-determined: {', '.join(f'{f}/s' for f in found)}",
                "speeds at which the loops stay closed",
                remedy,
            ),
        )
    free = _undetermined(weighted, [model.speeds[i] for i in unknown])
    return u, _under("speeds", *free)


def _sizes(model: Model, jacobian: Array, values: Array) -> Array:
    """Of each constraint, how far open counts as closed: CLOSED times what a coordinate moves at most, an angle counting as 1 at least.

    The most among all constraints of its unit: one row alone may vanish where a mechanism is stretched out.
    """
    units = np.array([unit for _, unit in model.module.CONSTRAINTS])
    reach = np.max(np.abs(jacobian) * np.maximum(np.abs(values), 1.0), axis=1, initial=1e-9)
    size: Array = CLOSED * np.array([np.max(reach[units == unit]) for unit in units])
    return size


def _reach(model: Model, jacobian: Array) -> Array:
    """How far coordinates go in a mechanism: a radian, or what a radian moves."""
    return np.array([1.0 if model.units[name] == "rad" else np.max(np.abs(jacobian)) for name in model.coordinates])


def _undetermined(matrix: Array, names: list[str]) -> tuple[int, list[str]]:
    """How many freedoms the constraints leave the unknowns, and which of them share in one."""
    if not names:
        return 0, []
    _, values, vectors = np.linalg.svd(matrix)
    rank = int(np.sum(values > RANK * values[0])) if len(values) else 0
    moves = np.max(np.abs(vectors[rank:]), axis=0, initial=0.0)
    return len(names) - rank, [name for name, part in zip(names, moves, strict=True) if part > np.sqrt(RANK)]


def _under(what: str, count: int, names: list[str]) -> tuple[Fault, ...]:
    if not count:
        return ()
    more = f"{count} more value{'s' if count > 1 else ''} among them"
    return (
        Fault(f"start, {what}", f"under-determined: {', '.join(names)}", more, "in the scene's Start, or `initial`"),
    )
