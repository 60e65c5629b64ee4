"""Changes of a run's states from step to step, as one chain of links in the graph.

X = (S, M) are the changes (n, P) of the state (ny) and of the memory (nm). A link is one step, X -> X', or a linear map,
X -> E X + G: the jump at an event, or a step whose variational equation is solved apart (`transitions`).

Over a step S' = f_y S + f_m M + f_c dc is solved by the step's own explicit method, at its own stages. So each step is the
exact derivative of the map that the run took, and its estimate of error is the method's. Hairer, Norsett, Wanner,
Solving Ordinary Differential Equations I, II.6 and I.14 (internal differentiation; Bock 1981).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.loop.automatic import Code
from hertzwerk.runtime.integrate.step.classes import contact_classes
from hertzwerk.runtime.integrate.step.explicit import flow
from hertzwerk.runtime.integrate.step.redundant import relax_redundant
from hertzwerk.runtime.integrate.tableaux.explicit_tableaux import RungeKutta, dop853
from hertzwerk.runtime.model.caller import Rowwise
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.integrate.step.classes import Contacts
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

SIZES = (8, 16)  # links per call, nested: calls of a function, links in it
WIDTH = 16  # most columns at once: code grows with them
PARTS = ("t", "y", "mode", "m", "pieces")  # of a row: all that a step of it needs
IDLE = 0  # kind of a link that does nothing; those of steps follow, the last one is linear


@dataclass(frozen=True)
class Link:
    """Function of a link of any kind.

    function    (kind, X (n, P), row, map (n, n + P), controls, dc (nc, P)) -> X', error (ny, P)
    linear      the kind of linear maps; below it the classes of steps
    """

    function: Any
    linear: int


@per_model
def link(_: Model, integrator: Integrator, count: int) -> Link:
    """Return the link of an integrator's steps with this many columns."""
    steps = [_step(integrator, contacts, count) for contacts in contact_classes(integrator.model)]
    given = _arguments(integrator, count)
    x, linear = given[0], given[2]
    ny, n = integrator.layouts.state.sizes["y"], x.size1()
    still = ca.MX.zeros(ny, count)
    idle = ca.Function("idle", given, [x, still])
    mapped = ca.Function("mapped", given, [ca.mtimes(linear[:, :n], x) + linear[:, n:], still])
    return Link(ca.Function.conditional("link", [idle, *steps], mapped), 1 + len(steps))


def _arguments(integrator: Integrator, count: int) -> list[Any]:
    sizes = integrator.layouts.state.sizes
    n = sizes["y"] + sizes["m"]
    row, nc = 2 + sum(sizes[part] for part in PARTS), integrator.layouts.controls.sizes["c"]
    shapes = [(n, count), (row, 1), (n, n + count), (integrator.layouts.controls.size, 1), (nc, count)]
    names = ("x", "row", "linear", "controls", "dc")
    return [ca.MX.sym(name, *shape) for name, shape in zip(names, shapes, strict=True)]


def _step(integrator: Integrator, contacts: Contacts, count: int) -> Any:
    """Build the function of one step with these contacts."""
    layouts, model, table = integrator.layouts, integrator.model, dop853()
    x, row, _, controls, dc = given = _arguments(integrator, count)
    sizes = [1, 1, *(layouts.state.sizes[part] for part in PARTS)]
    h, pace, *parts = ca.vertsplit(row, [0, *np.cumsum(sizes).tolist()])
    start = dict(zip(PARTS, parts, strict=True))
    run = layouts.within(layouts.controls.split(controls), {**start, "stop": 0})
    c, t, ny = relax_redundant(model)(start, run)["c"], start["t"], start["y"].numel()
    stage, begin = _stage(model, contacts, count), ca.horzcat(start["y"], x[:ny, :])
    slopes: list[Any] = []

    def combined(weights: Sequence[float]) -> Any:
        terms = [weight * slope for weight, slope in zip(weights, slopes, strict=False) if weight]
        return h * sum(terms[1:], terms[0]) if terms else ca.MX.zeros(ny, count + 1)

    def slope(node: float, at: Any) -> Any:
        if contacts == ():  # it has no roots: its time is even
            return stage(t + h * node, at, start["mode"], start["m"], c, x[ny:, :], dc)
        time = t + h * (pace * node + (1 - pace) * node**2)
        return (pace + 2 * (1 - pace) * node) * stage(time, at, start["mode"], start["m"], c, x[ny:, :], dc)

    for weights, node in zip(table.A, table.c, strict=True):
        slopes.append(slope(node, begin + combined(weights) if slopes else begin))
    end = begin + combined(table.b)
    first, second = (combined(estimate.weights)[:, 1:] for estimate in table.errors)  # joined as in `explicit`
    error = first * first / ca.sqrt(first * first + 0.01 * second * second + 1e-300)
    return ca.Function("step", given, [ca.vertcat(end[:, 1:], x[ny:, :]), error])


@per_model
def _stage(model: Model, contacts: Contacts, count: int) -> Any:
    """Build the function (t, (y, S), mode, m, c, M, dc) -> rates of (y, S)."""
    t, y, mode, m, c = given = model.symbols("t y mode m c")
    ny, np_ = y.numel(), model.npieces if model.inputs else 0
    seeds = [ca.SX.sym(name, part.numel(), count) for name, part in (("S", y), ("M", m), ("dc", c))]
    of_constants = ca.vertcat(seeds[2][: model.nc - np_, :], ca.SX(np_, count))  # inputs are given, and do not change
    rates = flow(model, contacts).rates(*given)
    changes = ca.jtimes(rates, ca.vertcat(y, m, c), ca.vertcat(*seeds[:2], of_constants))
    both = ca.SX.sym("both", ny, 1 + count)
    results = [ca.densify(ca.horzcat(rates, changes))]
    made = ca.Function("both", [t, y, mode, m, c, *seeds], ca.cse(results))
    return ca.Function(
        "slopes", [t, both, mode, m, c, *seeds[1:]], made.call([t, both[:, 0], mode, m, c, both[:, 1:], *seeds[1:]])
    )


def _chain(link: Link) -> Any:
    """Build the function of many links in a row -> X and error after each."""
    kind, *given = link.function.mx_in()
    x, row, linear, controls, dc = given
    many = ca.Function("link", [x, ca.vertcat(kind, row), linear, controls, dc], link.function.call([kind, *given]))
    for i, size in enumerate(SIZES):
        x, rows, maps, controls, dc = (
            ca.MX.sym(name, part.size1(), part.size2() * (size if name in ("rows", "linear") else 1))
            for name, part in zip(("x", "rows", "linear", "controls", "dc"), many.mx_in(), strict=True)
        )
        given, found = [x, rows, maps, controls, dc], []
        width = x.size2()
        for row, linear in zip(
            ca.horzsplit(rows, rows.size2() // size), ca.horzsplit(maps, maps.size2() // size), strict=True
        ):
            found.append(many.call([x, row, linear, controls, dc], False, True))
            x = found[-1][0][:, -width:]
        many = ca.Function(f"links_{i}", given, [ca.horzcat(*part) for part in zip(*found, strict=True)])
    return many


def along(maps: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Return the changes (..., P) that maps (..., n + P) make of those before them (..., n, P)."""
    n = before.shape[-2]
    found: np.ndarray = maps[..., :n] @ before + maps[..., n:]
    return found


@per_model
def code(model: Model, integrator: Integrator, count: int) -> Code:
    """Return the chain's function, to be called as it is or compiled."""
    return Code(_chain(link(model, integrator, count)))


@dataclass(frozen=True)
class Changes:
    """Changes along a run, by its n rows.

    before, after (rows, n, P): just before and after the event of a row, the same where there is none
    errors (rows - 1, ny, P): estimates of the steps' errors, 0 of those by maps
    """

    before: np.ndarray
    after: np.ndarray
    errors: np.ndarray


def chained(
    history: History,
    begin: np.ndarray,
    maps: np.ndarray,
    over: np.ndarray,
    at: np.ndarray,
    dc: np.ndarray,
    *,
    switched: np.ndarray,
    compiled: bool,
) -> Changes:
    """Return the changes along a run from those at its begin (n, P).

    maps (j, n, n + P)    linear maps
    over (rows - 1,)      number of the map over each step, -1 where the graph takes it
    at (rows,)            number of the jump at each row, -1 where there is none
    switched (rows,)      whether a row follows an event
    """
    (n, count), ny = begin.shape, history.engine.layouts.state.sizes["y"]
    jumps = at[1:] >= 0
    last = np.cumsum(1 + jumps) - 1  # link before each row
    step = last - jumps
    number = np.empty(len(over) + jumps.sum(), dtype=int)
    number[step], number[last[jumps]] = over, at[1:][jumps]
    rows = np.zeros((len(number), len(_COLUMNS) + sum(history.engine.layouts.state.sizes[part] for part in PARTS)))
    rows[step] = links_after(history, np.arange(len(over)), np.diff(history.t), switched)
    before, after = (np.empty((len(at), n, count)) for _ in range(2))
    before[0] = after[0] = begin
    errors = np.empty((len(over), ny, count))
    for first in range(0, count, WIDTH):
        some = slice(first, min(first + WIDTH, count))
        here = np.concatenate([maps[:, :, :n], maps[:, :, n:][:, :, some]], axis=2)
        x, erred = _linked(history, begin[:, some], rows, number, here, dc[:, some], compiled=compiled)
        before[1:, :, some], after[1:, :, some], errors[:, :, some] = x[step], x[last], erred[step]
    return Changes(before, after, errors)


_COLUMNS = ("kind", "h", "pace")


def links_after(history: History, index: np.ndarray, h: np.ndarray, switched: np.ndarray) -> np.ndarray:
    """Return kind and row of the links over times h (n,) [s] after the rows `index` (n,).

    switched (rows,): whether a row follows an event

    The time within a step is t + h (a s + (1 - a) s^2), 0 <= s <= 1, with its pace a such that it is the square of a
    linear function from the nearer event: forces like d^1.5 are smooth functions of s up to the surface.
    """
    rows, layout, t = history.rows[index], history.engine.layouts.state, history.t
    kinds = rows[:, layout["class"]]
    events = t[switched]
    place = np.searchsorted(events, t[index], side="right")
    before, after = t[index] - events[place - 1], np.append(events, np.inf)[place] - t[index]
    first, last = np.where(before < after - h, (before, before + h), (after, after - h))
    root, other = np.sqrt(first), np.sqrt(np.maximum(last, 0))
    paces = np.where(np.isfinite(first) & (root + other > 0), 2 * root / np.where(root + other > 0, root + other, 1), 1)
    return np.column_stack([kinds, h, paces, *(rows[:, layout[part]] for part in PARTS)])


def _linked(
    history: History,
    begin: np.ndarray,
    rows: np.ndarray,
    number: np.ndarray,
    maps: np.ndarray,
    dc: np.ndarray,
    *,
    compiled: bool,
) -> tuple[np.ndarray, np.ndarray]:
    """Return changes (links, n, P) and errors (links, ny, P) after each link."""
    (n, count), room = begin.shape, SIZES[0] * SIZES[1]
    chain, linear = code(history.model, history.engine, count), link(history.model, history.engine, count).linear
    callers = chain.compile() if compiled else chain.machine
    call = callers.take()
    x, table, mapped, controls, changes = call.inputs
    x[:], controls[:], changes[:] = begin.T, history.controls, dc.T
    found = [np.empty((len(number), count, size)) for size in (n, history.engine.layouts.state.sizes["y"])]
    for first in range(0, len(number), room):
        some = slice(first, first + room)
        which = number[some]
        by_map = np.flatnonzero(which >= 0)
        table[: len(which)] = rows[some]
        table[by_map, 0], table[len(which) :, 0] = linear, IDLE
        mapped.reshape(room, n + count, n)[by_map] = maps[which[by_map]].swapaxes(1, 2)
        for kept, values in zip(found, call(), strict=True):
            kept[some] = values.reshape(room, count, -1)[: len(which)]
        x[:] = found[0][first + len(which) - 1]
    callers.give_back(call)
    return found[0].swapaxes(1, 2), found[1].swapaxes(1, 2)


def by_graph(history: History) -> np.ndarray:
    """Return whether the step after each row (rows,) is the graph's: where the run took an explicit one."""
    explicit = [isinstance(table, RungeKutta) for table in history.engine.tables]
    found: np.ndarray = np.array(explicit)[history.part("method")[:, 0].astype(int)]
    return found


def later(
    history: History, index: np.ndarray, h: np.ndarray, before: np.ndarray, dc: np.ndarray, switched: np.ndarray
) -> np.ndarray:
    """Return the changes (j, n, P) times h (j,) [s] after rows, by steps of the graph.

    index (j,): the rows; before (j, n, P): changes at them
    """
    found = np.empty_like(before)
    rows = links_after(history, index, h, switched)
    for first in range(0, before.shape[2], WIDTH):
        some = slice(first, first + WIDTH)
        columns = before[:, :, some].swapaxes(1, 2)
        constant = np.concatenate([history.controls, dc[:, some].T.ravel()])
        one = _rowwise(history.model, history.engine, columns.shape[1])
        (x,) = one(constant, columns.reshape(len(index), -1), rows)
        found[:, :, some] = x.reshape(columns.shape).swapaxes(1, 2)
    return found


@per_model
def _rowwise(model: Model, integrator: Integrator, count: int) -> Rowwise:
    x, row, linear, controls, dc = _arguments(integrator, count)
    row = ca.MX.sym("row", 1 + row.numel())  # its kind first
    both, column = ca.MX.sym("both", controls.numel() + dc.numel()), ca.MX.sym("x", x.numel())
    c, changes = ca.vertsplit(both, [0, controls.numel(), both.numel()])
    given = [ca.reshape(column, *x.shape), row[1:], ca.MX.zeros(*linear.shape), c, ca.reshape(changes, *dc.shape)]
    after, _ = link(model, integrator, count).function.call([row[0], *given])
    return Rowwise(ca.Function("later", [both, column, row], [ca.vec(after)]), constant=0)
