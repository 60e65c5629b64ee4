"""Changes of a run's states from step to step, as one chain of links in the graph.

X = (S, M, T) are the changes (n, P) of the state (ny), of the memory (nm), and a shift of time. A link is one step, X -> X',
or a linear map, X -> E X + G: the jump at an event, or a step whose variational equation is solved apart (`transitions`).

S are changes at a fixed time since the last event, which comes later by T. At a fixed time of the run they are S - f T.
Impacts in S do not move in time, so S does not grow and shrink with the accelerations in them. T is 0 where equations may
jump at a time of their own (`moves_with_events`).

Over a step S' = f_y S + f_m M + f_t T + f_c dc is solved with the state, from where the run was, by a method of the kind that it
took: `dopri5`, else `dop853`; behind implicit steps `esdirk`, at whose stages systems with their own Jacobian are solved for
all columns. Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.6 and I.14 (internal differentiation;
Bock 1981).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.loop.automatic_compilation import Code
from hertzwerk.runtime.engine.integration.step.contact_classes import IN_FLIGHT, Contacts, contact_classes
from hertzwerk.runtime.engine.integration.step.explicit_step import written_flow
from hertzwerk.runtime.engine.integration.step.implicit_step import linearised, solves
from hertzwerk.runtime.engine.integration.step.linear_systems import solver_of_calls
from hertzwerk.runtime.engine.integration.step.redundant_constraints import relax_redundant
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta, dop853, dopri5
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import ITERATIONS, esdirk54
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.sensitivity.tangent import moves_with_events

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
    from hertzwerk.runtime.engine.sensitivity.tangent import Directions
    from hertzwerk.runtime.engine.solution.history import History

SIZES = (16, 32)  # links per call, nested: calls of a function, links in it
WIDTH = 16  # most columns at once: they share the motion, but code grows with them
PARTS = ("t", "y", "mode", "m", "pieces")  # of a row: all that a step of it needs
PASSES = 4  # over some links, at most: steps found too coarse are solved apart in the next one
COARSE, LEAST = (
    1e3,
    1e-7,
)  # of tolerances, or of one: a step's estimated error, of a derivative, beyond which it is too coarse
BESIDE, ROUGH = (
    0.9,
    1e3,
)  # steps so uneven begin or end at a surface, where an error may be so many times dop853's estimate; of implicit steps anywhere
SURE, UNSURE = 0.1, 10.0  # the same of dopri5, whose estimate here is of order 3, and of its steps at a surface
TOGETHER = 10.0  # times COARSE tolerances, to which the errors of a call's steps may add up: thousands of a stiff run are alike
NOISE = 1e-9  # of a state's scale over a parameter: derivatives so small are none
SHORT = 4500  # instructions up to which a step is written out: longer ones are faster by calls of their stages
SMALL = 1000  # instructions of rates up to which their Jacobians are tried: of more these take long to build
IDLE = 0  # kind of a link that does nothing; those of steps follow, the last one is linear


Columns: TypeAlias = tuple[tuple[int, ...], ...]
"""Of each column the constants that it changes, mostly a few: code is made for these, half as long as for all."""


def columns_of(dc: np.ndarray) -> Columns:
    """Return the constants that columns of dc (nc, P) change."""
    return tuple(tuple(map(int, np.flatnonzero(column))) for column in dc.T)


def changes_of(dc: np.ndarray) -> np.ndarray:
    """Return the changes (nd,) of constants, column after column, without those that are zero."""
    changes: np.ndarray = dc.T[dc.T != 0]
    return changes


@dataclass(frozen=True)
class Link:
    """Function of a link of any kind.

    function    (kind, X (n, P), row, map (n, n + P), controls, dc (nd,)) -> X', squares (P, 2)
    linear      the kind of linear maps; below it the classes of steps by each method
    """

    function: Any
    linear: int


@per_model
def link(_: EngineModel, integrator: Integrator, methods: tuple[int, ...], columns: Columns) -> Link:
    """Return the link of an integrator's steps by these of its methods with these columns."""
    steps = [
        _explicit(integrator, table, contacts, columns)
        if isinstance(table, RungeKutta)
        else _implicit(integrator, contacts, columns)
        for table in (integrator.tables[method] for method in methods)
        for contacts in contact_classes(integrator.model)
    ]
    arguments = _arguments(integrator, columns)
    x, linear = arguments[0], arguments[2]
    n = x.size1()
    still = ca.MX.zeros(len(columns), 2)
    idle = ca.Function("idle", arguments, [x, still])
    mapped = ca.Function("mapped", arguments, [ca.mtimes(linear[:, :n], x) + linear[:, n:], still])
    return Link(ca.Function.conditional("link", [idle, *steps], mapped), 1 + len(steps))


def methods_of(history: History) -> tuple[int, ...]:
    """Return the numbers of the methods that a run's steps took."""
    return tuple(map(int, np.flatnonzero(np.bincount(history.part("method")[:-1, 0].astype(int)))))


def _arguments(integrator: Integrator, columns: Columns) -> list[Any]:
    sizes, count, changed = integrator.layouts.state.sizes, len(columns), sum(map(len, columns))
    n = sizes["y"] + sizes["m"] + 1
    row = 2 + sum(sizes[part] for part in PARTS)
    shapes = [(n, count), (row, 1), (n, n + count), (integrator.layouts.controls.size, 1), (changed, 1)]
    names = ("x", "row", "linear", "controls", "dc")
    return [ca.MX.sym(name, *shape) for name, shape in zip(names, shapes, strict=True)]


@dataclass(frozen=True)
class _Begin:
    """A link's arguments, and what a step from there is taken of.

    h, even: as in `links_after`; start: parts of the row; run: numbers of the run; c: constants of the step; S, M, dc: changes,
    M with the shift of time
    """

    arguments: Sequence[Any]
    h: Any
    even: Any
    start: Mapping[str, Any]
    run: Mapping[str, Any]
    c: Any
    S: Any
    M: Any
    dc: Any

    def within(self, node: float) -> tuple[Any, Any]:
        """Return the time at a node of a step, and its rate by s."""
        share, pace = quadratic(self.even, node)
        return self.start["t"] + self.h * share, self.h * pace

    @property
    def weights(self) -> Any:
        """Weights (1, ny) of squares, in the states' scales."""
        return (1 / self.run["scale"]).T ** 2

    def results(self, error: Any, end: Any) -> list[Any]:
        """Return the changes at the end, and squares (P, 2) of errors, given as such, and of changes."""
        return [ca.vertcat(end, self.M), ca.vertcat(error, ca.mtimes(self.weights, end**2)).T]


def _begin(integrator: Integrator, columns: Columns) -> _Begin:
    layouts = integrator.layouts
    x, row, _, controls, dc = arguments = _arguments(integrator, columns)
    sizes = [1, 1, *(layouts.state.sizes[part] for part in PARTS)]
    h, even, *parts = ca.vertsplit(row, [0, *np.cumsum(sizes).tolist()])
    start = dict(zip(PARTS, parts, strict=True))
    run = layouts.within(layouts.controls.split(controls), {**start, "stop": 0})
    c, ny = relax_redundant(integrator.model)(start, run)["c"], start["y"].numel()
    return _Begin(arguments, h, even, start, run, c, x[:ny, :], x[ny:, :], dc)


def _combined(weights: Sequence[float], slopes: list[Any]) -> Any:
    terms = [weight * slope for weight, slope in zip(weights, slopes, strict=False) if weight]
    return sum(terms[1:], terms[0])


def _explicit(integrator: Integrator, taken: RungeKutta, contacts: Contacts, columns: Columns) -> Any:
    """Build the function of an explicit step with these contacts."""
    at, table = _begin(integrator, columns), dopri5() if taken == dopri5() else dop853()
    start, stage = at.start, _stage(integrator.model, contacts, columns)
    begin = ca.horzcat(start["y"], at.S)
    slopes: list[Any] = []
    for weights, node in zip(table.A, table.c, strict=True):
        time, pace = at.within(node)
        state = begin + _combined(weights, slopes) if slopes else begin
        slopes.append(stage(time, state, start["mode"], start["m"], at.c, at.M, at.dc, pace))
    end = begin + _combined(table.b, slopes)
    first, *second = (
        # the slope at the end is taken to be that of the last stage, which is there too
        ca.mtimes(at.weights, _combined((*estimate.weights[:-2], sum(estimate.weights[-2:])), slopes)[:, 1:] ** 2)
        for estimate in table.errors
    )
    error = (
        first * first / (first + 0.01 * second[0] + 1e-300) if second else first
    )  # the square of that in `explicit_step`
    step = ca.Function("step", at.arguments, at.results(error, end[:, 1:]))
    return step.expand() if len(table.b) * stage.n_instructions() <= SHORT else step


def _implicit(integrator: Integrator, contacts: Contacts, columns: Columns) -> Any:
    """Build the function of an implicit step with these contacts.

    The states at its stages are found by simplified Newton iterations, changes there by elimination.
    """
    at, table, model = _begin(integrator, columns), esdirk54(), integrator.model
    rates, linear, change = (
        written_flow(model, contacts).rates,
        linearised(model, contacts),
        _changes(model, contacts, columns),
    )
    t, y, *conditions = (at.start[part] for part in PARTS[:4])
    conditions.append(at.c)
    time, pace = at.within(table.c[0])
    J = linear(t, y, *conditions)[0]
    slopes, changes = [pace * rates(t, y, *conditions)], [pace * change(t, y, *conditions, at.S, at.M, at.dc)]
    solved: Any = 1
    last: Any = 0  # largest square of the last changes by Newton's method, in tolerances
    for row, node, predictor in zip(table.A[1:], table.c[1:], table.predictors[1:], strict=True):
        time, pace = at.within(node)
        step = table.gamma * pace
        solve = solver_of_calls(J, step, model.nq)
        known = y + _combined(row[:-1], slopes)
        w = table.gamma * _combined(predictor, slopes)
        for _ in range(ITERATIONS):
            by = solve(step * rates(time, known + w, *conditions) - w)
            w += by
        last = ca.fmax(last, ca.mmax((by / (at.run["tolerance"] * at.run["scale"])) ** 2))
        state, S = known + w, at.S + _combined(row[:-1], changes)
        own, sources = linear(time, state, *conditions)[0], step * change(time, state, *conditions, S, at.M, at.dc)
        solution = ca.horzcat(*map(solver_of_calls(own, step, model.nq), ca.horzsplit(sources)))
        solved *= solves(own, step, solution, sources)
        slopes.append(w / table.gamma)
        changes.append(solution / table.gamma)
    error = ca.mtimes(at.weights, _combined(table.error.weights, changes) ** 2)
    results = at.results(ca.if_else(ca.logic_and(solved, last <= 1), error, np.inf), S + solution)
    return ca.Function("implicit_step", at.arguments, results)


@per_model
def _stage(model: EngineModel, contacts: Contacts, columns: Columns) -> Any:
    """Build the function (t, (y, S), mode, m, c, M, dc, pace) -> rates of (y, S), by the pace."""
    t, y, mode, m, c = model.symbols("t y mode m c")
    made = _changes(model, contacts, columns)
    S, M, dc = made.sx_in()[5:]
    both, pace = ca.SX.sym("both", y.numel(), 1 + len(columns)), ca.SX.sym("pace")
    y, S = both[:, 0], both[:, 1:]
    slopes = ca.horzcat(written_flow(model, contacts).rates(t, y, mode, m, c), made(t, y, mode, m, c, S, M, dc))
    return ca.Function("slopes", [t, both, mode, m, c, M, dc, pace], [ca.cse(pace * slopes)])


@per_model
def _changes(model: EngineModel, contacts: Contacts, columns: Columns) -> Any:
    """Build the function (t, y, mode, m, c, S, M with T, dc) -> rates of S: of two ways the shorter.

    Forward along the columns costs each of them some times the rates; by Jacobians it is little but their nonzeros.
    """
    t, y, _, m, c = arguments = model.symbols("t y mode m c")
    fixed, count = model.npieces if model.inputs else 0, len(columns)  # inputs are given, and do not change
    S, M = (ca.SX.sym(name, part.numel(), count) for name, part in (("S", y), ("M", ca.vertcat(m, t))))
    known = slice(None) if moves_with_events(model) else slice(m.numel())  # without T
    rows, of = [row for rows in columns for row in rows], [k for k, rows in enumerate(columns) for _ in rows]
    dc = ca.SX.sym("dc", len(rows))
    of_constants = ca.SX(ca.Sparsity.triplet(model.nc, count, rows, of), dc)
    of_constants = ca.vertcat(of_constants[: model.nc - fixed, :], ca.SX(fixed, count))
    rates, by, along = (
        written_flow(model, contacts).rates(*arguments),
        ca.vertcat(y, ca.vertcat(m, t)[known, :], c),
        ca.vertcat(S, M[known, :], of_constants),
    )
    ways = [ca.jtimes(rates, by, along)]
    if count > 1 and written_flow(model, contacts).rates.n_instructions() <= SMALL:
        ways.append(ca.mtimes(ca.jacobian(rates, by), along))
    functions = [ca.Function("changes", [*arguments, S, M, dc], [ca.cse(ca.densify(way))]) for way in ways]
    return min(functions, key=lambda function: function.n_instructions())


def _chain(link: Link) -> Any:
    """Build the function of many links in a row -> X and error after each."""
    kind, *arguments = link.function.mx_in()
    x, row, linear, controls, dc = arguments
    many = ca.Function("link", [x, ca.vertcat(kind, row), linear, controls, dc], link.function.call([kind, *arguments]))
    for i, size in enumerate(SIZES):
        x, rows, maps, controls, dc = (
            ca.MX.sym(name, part.size1(), part.size2() * (size if name in ("rows", "linear") else 1))
            for name, part in zip(("x", "rows", "linear", "controls", "dc"), many.mx_in(), strict=True)
        )
        arguments, results = [x, rows, maps, controls, dc], []
        width = x.size2()
        for row, linear in zip(
            ca.horzsplit(rows, rows.size2() // size), ca.horzsplit(maps, maps.size2() // size), strict=True
        ):
            results.append(many.call([x, row, linear, controls, dc], False, True))
            x = results[-1][0][:, -width:]
        many = ca.Function(f"links_{i}", arguments, [ca.horzcat(*part) for part in zip(*results, strict=True)])
    return many


def along(maps: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Return the changes (..., P) that maps (..., n + P) make of those before them (..., n, P)."""
    n = before.shape[-2]
    after: np.ndarray = maps[..., :n] @ before + maps[..., n:]
    return after


@per_model
def code(model: EngineModel, integrator: Integrator, methods: tuple[int, ...], columns: Columns) -> Code:
    """Return the chain's function, to be called as it is or compiled."""
    return Code(lambda: _chain(link(model, integrator, methods, columns)), bitwise=False)


@dataclass(frozen=True)
class Changes:
    """Changes along a run.

    after (rows, n, P)     at its rows; at those that follow an event, after it
    before (j, n, P)       before the events
    apart (rows - 1,)      whether a step was solved apart
    """

    after: np.ndarray
    before: np.ndarray
    apart: np.ndarray


def chained(
    history: History,
    begin: np.ndarray,
    jumps: np.ndarray,
    events: np.ndarray,
    solve: Callable[[np.ndarray], np.ndarray],
    directions: Directions,
    *,
    switched: np.ndarray,
    compiled: bool,
    renew: Callable[[np.ndarray, np.ndarray], np.ndarray] | None = None,
    most: int | None = None,
) -> Changes:
    """Return the changes along a run from those at its begin (n, P).

    jumps (j, n, n + P)    maps at the events
    events (j,)            rows that follow them
    solve                  returns the maps over steps after rows that are too coarse
    switched (rows,)       whether a row follows an event
    renew                  takes rows (l,) and the changes (l, P, n) at them, at most WIDTH columns, and returns those to
                           go on with (P, n), after at most so many links
    """
    (n, count), rows = begin.shape, len(history.rows)
    after_event = np.zeros(rows, dtype=int)
    after_event[events] = 1
    step = np.arange(rows - 1) + np.cumsum(after_event)[:-1]  # links over steps; after some of them is a jump
    row = np.repeat(np.arange(1, rows), 1 + after_event[1:])  # after each link
    leads = np.full(len(row), -1)  # event after each link
    leads[step[events - 1]] = np.arange(len(events))
    number = np.full(len(row), -1)  # of each link's map
    number[step[events - 1] + 1] = np.arange(len(events))
    last = np.append(row[1:] != row[:-1], True)  # to its row
    stepping = number < 0
    steps = np.concatenate([[0], np.cumsum(stepping)])  # before each link
    maps = jumps
    table = links_after(history, slice(0, rows - 1), np.diff(history.t), switched)
    uneven = np.abs(table[:, _COLUMNS.index("even")] - 1) > BESIDE
    rough = _roughness(history, uneven)[row - 1, None] ** 2
    after, before = np.empty((rows, count, n)), np.empty((len(events), count, n))
    after[0] = begin.T
    together = TOGETHER * COARSE * history.controls[history.engine.layouts.controls["tolerance"]][0]
    bound = max(together / TOGETHER, LEAST)
    for first in range(0, count, WIDTH):
        some = slice(first, min(first + WIDTH, count))
        columns = np.r_[:n, n + some.start : n + some.stop]
        call = _Call(history, begin[:, some], directions.dc[:, some], compiled=compiled)
        size = NOISE / directions.sizes[some]
        room = min(most or call.room, call.room)
        for start in range(0, len(row), room):
            links = slice(start, min(start + room, len(row)))
            taken = table[steps[links.start] : steps[links.stop]]
            for _ in range(PASSES):
                by_map = np.flatnonzero(number[links] >= 0)
                x, errors, sizes = call(taken, stepping[links], by_map, maps[number[links][by_map]][:, :, columns])
                larger = np.maximum(size, np.sqrt(np.fmax.reduce(sizes)))
                parts = np.sqrt(errors * rough[links] / larger**2).max(axis=1)
                alike = parts / np.sqrt(np.maximum(rough[links, 0], 1))  # estimates at fault by much are so for a few
                fine = (parts <= bound) & (alike <= _largest_within(alike, together))
                if fine.all():
                    break
                coarse = ~fine & (number[links] < 0)
                coarse &= np.cumsum(~np.isfinite(sizes).all(axis=1)) <= 1  # after it there are no numbers
                if not coarse.any():
                    break
                again = start + np.flatnonzero(coarse)
                number[again] = len(maps) + np.arange(len(again))
                maps = np.concatenate([maps, solve(row[again] - 1)])
            here = row[links][last[links]]
            if len(here):
                after[here[0] : here[-1] + 1, some] = x if len(here) == len(x) else x[last[links]]
            leading = np.flatnonzero(leads[links] >= 0)
            before[leads[links][leading], some] = x[leading]
            size = size if renew else larger
            call.go_on(renew(row[links], x) if renew else x[-1])
        call.end()
    return Changes(after.swapaxes(1, 2), before.swapaxes(1, 2), number[step] >= 0)


def _largest_within(parts: np.ndarray, most: float) -> float:
    """Return the level below which parts (n,) add up to no more than `most`; infinity if all do."""
    if parts.sum() <= most:
        return np.inf
    ordered = np.sort(parts)
    within = np.flatnonzero(np.cumsum(ordered) <= most)
    return float(ordered[within[-1]]) if len(within) else 0.0


def _roughness(history: History, uneven: np.ndarray) -> np.ndarray:
    """Return how many times its estimate the error over each step (rows - 1,) may be."""
    methods, tables = history.part("method")[:-1, 0].astype(int), history.engine.tables
    own = np.array([table == dopri5() for table in tables])[methods]
    implicit = ~np.array([isinstance(table, RungeKutta) for table in tables])[methods]
    return np.where(own, np.where(uneven, UNSURE, SURE), np.where(implicit | uneven, ROUGH, 1.0))


_COLUMNS = ("kind", "h", "even")


def links_after(history: History, index: np.ndarray | slice, h: np.ndarray, switched: np.ndarray) -> np.ndarray:
    """Return kind and row of the links over times h (n,) [s] after the rows `index` (n,).

    switched (rows,): whether a row follows an event

    The time within a step is t + h (a s + (1 - a) s^2), 0 <= s <= 1. In contact, a is such that it is the square of a linear
    function from the nearer event: forces like d^1.5 are smooth functions of s up to the surface. In flight a is 1.
    """
    layout = history.engine.layouts.state
    kinds, method, *parts = (history.rows[:, layout[part]][index] for part in ("class", "method", *PARTS))
    methods = methods_of(history)
    if len(methods) > 1:
        kinds = kinds + len(contact_classes(history.model)) * np.searchsorted(methods, method) * (kinds > IDLE)
    (even,) = evenness(history, index, h, switched, powers=(0.5,))
    return np.column_stack([kinds, h, even, *parts])


def evenness(
    history: History, index: np.ndarray | slice, h: np.ndarray, switched: np.ndarray, powers: tuple[float, ...]
) -> list[np.ndarray]:
    """Return a (n,) of `quadratic` for powers: that of the time from the nearer event is linear in s."""
    t = history.t
    events = t[switched]
    place = np.searchsorted(events, t[index], side="right")
    before, after = t[index] - events[place - 1], np.append(events, np.inf)[place] - t[index]
    nearer = before < after - h
    first, last = np.where(nearer, before, after), np.where(nearer, before + h, np.maximum(after - h, 0))
    curved = (history.part("class")[index, 0] > IN_FLIGHT) & np.isfinite(first) & (first + last > 0)
    first, last = np.where(curved, first, 1), np.where(curved, last, 1)
    return [2 * first**power / (first**power + last**power) for power in powers]


def quadratic(even: Any, s: Any) -> tuple[Any, Any]:
    """Return the share a s + (1 - a) s^2 of a step's time at s, 0 <= s <= 1, and its rate by s."""
    return even * s + (1 - even) * s**2, even + 2 * (1 - even) * s


class _Call:
    """Calls of a chain, each of at most `room` links from the changes where the last one ended."""

    def __init__(self, history: History, begin: np.ndarray, dc: np.ndarray, *, compiled: bool) -> None:
        (n, count), self.room = begin.shape, SIZES[0] * SIZES[1]
        made = history.model, history.engine, methods_of(history), columns_of(dc)
        chain, self._linear = code(*made), link(*made).linear
        self._callers = chain.compile() if compiled else chain.machine
        self._call = self._callers.take()
        self._begin, self._rows, maps, controls, changes = self._call.inputs
        self._maps = maps.reshape(self.room, n + count, n)
        controls[:], changes[:] = history.controls, changes_of(dc)
        self.go_on(begin.T)

    def __call__(
        self, table: np.ndarray, stepping: np.ndarray, by_map: np.ndarray, maps: np.ndarray
    ) -> tuple[np.ndarray, ...]:
        """Return changes (links, P, n), squares of estimated errors and of sizes (links, P) after links.

        table: of those over steps (`stepping`), as `links_after` has them; by_map: those that are maps (l, n, n + P)
        """
        count = len(stepping)
        steps = slice(count) if len(table) == count else np.flatnonzero(stepping)
        self._rows[steps], self._rows[count:, 0] = table, IDLE
        self._rows[by_map, 0], self._maps[by_map] = self._linear, maps.swapaxes(1, 2)
        x, squares = self._call()
        errors, sizes = squares.reshape(self.room, 2, -1)[:count].swapaxes(0, 1)
        return x.reshape(self.room, *self._begin.shape)[:count], errors, sizes

    def go_on(self, begin: np.ndarray) -> None:
        """Begin the next call with these changes (P, n)."""
        self._begin[:] = begin

    def end(self) -> None:
        """End the calls."""
        self._callers.give_back(self._call)


def later(
    history: History, index: np.ndarray, h: np.ndarray, before: np.ndarray, dc: np.ndarray, switched: np.ndarray
) -> np.ndarray:
    """Return the changes (j, n, P) times h (j,) [s] after rows, by steps of the graph.

    index (j,): the rows; before (j, n, P): changes at them
    """
    after = np.empty_like(before)
    rows = links_after(history, index, h, switched)
    for first in range(0, before.shape[2], WIDTH):
        some = slice(first, first + WIDTH)
        columns, changes = before[:, :, some].swapaxes(1, 2), dc[:, some]
        constant = np.concatenate([history.controls, changes_of(changes)])
        one = _rowwise(history.model, history.engine, methods_of(history), columns_of(changes))
        (x,) = one(constant, columns.reshape(len(index), -1), rows)
        after[:, :, some] = x.reshape(columns.shape).swapaxes(1, 2)
    return after


@per_model
def _rowwise(model: EngineModel, integrator: Integrator, methods: tuple[int, ...], columns: Columns) -> Rowwise:
    x, row, linear, controls, dc = _arguments(integrator, columns)
    row = ca.MX.sym("row", 1 + row.numel())  # its kind first
    both, column = ca.MX.sym("both", controls.numel() + dc.numel()), ca.MX.sym("x", x.numel())
    c, changes = ca.vertsplit(both, [0, controls.numel(), both.numel()])
    arguments = [ca.reshape(column, *x.shape), row[1:], ca.MX.zeros(*linear.shape), c, changes]
    after, _ = link(model, integrator, methods, columns).function.call([row[0], *arguments])
    return Rowwise(ca.Function("later", [both, column, row], [ca.vec(after)]), constant=0)
