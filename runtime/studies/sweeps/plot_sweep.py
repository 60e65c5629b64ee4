"""Picture of a sweep: bifurcation diagram of a section, curves over one parameter, maps over two."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError, refuse, unknown
from hertzwerk.runtime.engine.solution.outcome import REACHED_END
from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, empty_panel, legend
from hertzwerk.runtime.output.plots.plot_style import BLUE, CYCLE, GREY, STYLE, VERMILLION, plain
from hertzwerk.runtime.output.plots.title import titled_page
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep

SECTION, HALF_WIDTH, FAILED = "section", ".half_width", "failed"
NO_OUTPUT = ("outcome", "message", "warnings", "wall_s")
WIDE, HIGH = 5.6, 3.4  # inches of a panel
DIAGRAM = (9.6, 3.6)  # inches of a panel of a bifurcation diagram
MOST_PANELS, MOST_CURVES = 8, 8
MARGIN = 0.03  # of the range of a parameter, beside it
FEW_POINTS = 40  # of a line, up to which each is marked
FEW_DOTS = 3000  # of a diagram, up to which they are drawn as vectors
SMALLEST, LARGEST, ALL_DOTS = 0.8, 3.2, 60.0  # points: of a dot, and what is shared by the root of their number
TURN = 2 * np.pi


def figure(table: Sweep, names: Sequence[str] = ()) -> Figure:
    """Draw the section of a sweep, or else its outputs, or those named; raises InputError."""
    diagram = SECTION in table.arrays and all(name in table.arrays[SECTION] for name in names)
    there = [name for name in table.arrays[SECTION] if name != "t"] if diagram else _outputs(table)
    known = dict.fromkeys([*(table.arrays.get(SECTION, {})), *_outputs(table)])
    wrong = [name for name in names if name not in there]
    refuse(f"plot of {table.scene}", [unknown("output or array of this sweep", name, known) for name in wrong])
    if not table.rows or not there:
        raise InputError(
            f"plot of {table.scene}", [Fault("rows", "none with numbers", "a sweep with rows and outputs")]
        )
    wanted = list(names) or there
    with mpl.rc_context(STYLE):
        beside = [each for name in wanted[:MOST_PANELS] for each in (name, name + HALF_WIDTH)]
        outputs = [name for name in beside if name in table.columns and not diagram]
        stated = {name: _stated_number(name) for name in table.stated_units if name in table.varied}
        plain_ones = [name for name in table.varied if name not in stated]
        columns = table.read(*outputs, *plain_ones, **stated, **{FAILED: lambda row: row.outcome not in REACHED_END})
        axes = [_varied(table, name, columns[name]) for name in table.varied]
        axes = [axis for axis in axes if len(axis.distinct) > 1] or axes[:1]
        draw = _diagram if diagram else _lines if _along_one(table, axes) else _maps
        return draw(Drawn(table, columns, columns[FAILED] == 1), axes, wanted[:MOST_PANELS], len(wanted))


@dataclass(frozen=True)
class Drawn:
    """Table that is drawn, its columns as they were read, and which rows failed (rows,)."""

    table: Sweep
    columns: Mapping[str, np.ndarray]
    failed: Any


def _stated_number(name: str) -> Callable[[Any], float]:
    """Return what reads the number that was given for a name."""
    return lambda row: float(row.stated[name][0])


def _varied(table: Sweep, name: str, column: np.ndarray) -> Varied:
    """Return the values of a name in the unit they were given in, else in one that fits.

    column    numbers as they were given, where they have one unit, else in SI, or labels
    """
    if column.dtype.kind == "U":
        labels = tuple(dict.fromkeys(column.tolist()))
        return Varied(name, "", np.array([float(labels.index(label)) for label in column]), log=False, labels=labels)
    unit, values = table.stated_units.get(name), column
    if unit is None:
        scale = shown_in(table.columns[name], column)
        unit, values = scale.unit, scale(column)
    return Varied(name, unit, values, has_equal_ratios(values))


def _outputs(table: Sweep) -> list[str]:
    """Return the columns of numbers that came out."""
    return [
        name
        for name in table.columns
        if name not in (*NO_OUTPUT, *table.varied)
        and not name.endswith(HALF_WIDTH)
        and table.summary.spreads[name].count
    ]


def _along_one(table: Sweep, axes: Sequence[Varied]) -> bool:
    """Return whether outputs are curves over one parameter, a few of them where there are others."""
    return len(axes) == 1 or (len(axes) > 2 and table.gridded and _curves(axes[1:]) <= MOST_CURVES)


def _curves(axes: Sequence[Varied]) -> int:
    return int(np.prod([len(axis.distinct) for axis in axes]))


def _page(
    drawn: Drawn, size: tuple[float, float], count: int, shape: tuple[int, int], subtitle: str
) -> tuple[Figure, list[Axes]]:
    """Return a figure with its title and panels."""
    rows, columns = shape
    page = titled_page(size[0] * columns, size[1] * rows, drawn.table.scene, _below(drawn, subtitle))
    return page, [page.add_subplot(rows, columns, i + 1) for i in range(count)]


def _below(drawn: Drawn, subtitle: str) -> str:
    """Return what is said below the title: what is the same for all rows, and how many of them failed."""
    table = drawn.table
    fixed = {name: value for name, value in table.rows[0].stated.items() if name not in table.varied}
    values = [
        f"{name} = {value[0]:.6g} {value[1]}".removesuffix(" 1")
        for name, value in fixed.items()
        if isinstance(value, tuple)
    ]
    failed = int(drawn.failed.sum())
    ends = f"{failed:,} of {len(drawn.failed):,} rows failed: marked by x" if failed else ""
    return "; ".join(filter(None, (subtitle, ", ".join(values), ends)))


def _mark_failures(axis: Axes, positions: Array) -> None:
    """Mark along the lower edge of a panel where rows failed."""
    if not len(positions):
        return
    positions = positions[some(positions, PLACES)]
    axis.plot(
        positions, np.full(len(positions), 0.015), "x", transform=axis.get_xaxis_transform(), color=VERMILLION,
        markersize=4.5, clip_on=False, zorder=3,
    )  # fmt: skip


def _labelled(axis: Axes, name: str, unit: str) -> None:
    """Set title and y label of a panel with values of an output."""
    axis.set(title=plain(name), ylabel=_label(name, unit))
    axis.ticklabel_format(axis="y", useOffset=False)


def _label(name: str, unit: str) -> str:
    """Return the label of an output below its own name: without the part it is of."""
    return plain(labelled((name.partition(".")[2] or name).replace(".", " ").replace("_", " "), unit))


def _scaled(axis: Axes, x: Varied) -> None:
    low, high = x.distinct[[0, -1]] if len(x.distinct) else np.array([0.0, 1.0])
    reach = MARGIN * (np.log(high / low) if x.log else high - low)
    if x.log:
        axis.set_xscale("log")
        axis.set_xlim(low / np.exp(reach), high * np.exp(reach))
    elif reach > 0:
        axis.set_xlim(low - reach, high + reach)
    axis.set_xlabel(plain(x.label))
    _ticked(axis.xaxis, x)


def _ticked(axis: Any, along: Varied) -> None:
    """Write the labels of an input along an axis."""
    if along.labels:
        axis.set_ticks(range(len(along.labels)), [plain(label) for label in along.labels])


def _shape(count: int) -> tuple[int, int]:
    columns = min(count, 2)
    return -(-count // columns), columns


# -- one parameter -----------------------------------------------------------------------------------------------------


def _lines(drawn: Drawn, axes: Sequence[Varied], names: Sequence[str], count: int) -> Figure:
    x, *others = axes
    table, columns, good = drawn.table, drawn.columns, ~drawn.failed
    groups = list(_groups(others, len(good)))
    subtitle = [_listed(names, count)]
    if any(mask.sum() > 2 * PLACES for _, mask in groups):
        subtitle.append(f"{len(good):,} rows, of which the minimum and the maximum at {PLACES:,} places are drawn")
    page, panels = _page(drawn, (WIDE, HIGH), len(names), _shape(len(names)), "; ".join(filter(None, subtitle)))
    for panel, name in zip(panels, names, strict=True):
        scale = shown_in(table.columns[name], columns[name])
        for (label, mask), colour in zip(groups, _colours(others), strict=True):
            order = np.flatnonzero(mask)[np.argsort(x.values[mask], kind="stable")]
            values = np.where(good, scale(columns[name]), np.nan)[order]
            places = extremes(values, PLACES)
            order, values = order[places], values[places]
            marker = "o" if len(order) <= FEW_POINTS else ""
            panel.plot(x.values[order], values, color=colour, marker=marker, markersize=3.2, label=plain(label) or None)
            if name + HALF_WIDTH in table.columns:
                half = scale(columns[name + HALF_WIDTH])[order]
                panel.fill_between(x.values[order], values - half, values + half, color=colour, alpha=0.18, linewidth=0)
        _mark_failures(panel, x.values[~good])
        _labelled(panel, name, scale.unit)
        if np.array_equal(values := columns[name][good], np.round(values)):
            panel.yaxis.set_major_locator(MaxNLocator(integer=True))
        _scaled(panel, x)
        if others:
            panel.set_title(plain(name), pad=LEGEND_ROOM)
            legend(panel)
        elif name + HALF_WIDTH in table.columns:
            panel.text(1, 1.02, "band: 95 % interval", transform=panel.transAxes, ha="right", color=GREY, fontsize=8.5)
    return page


def _listed(names: Sequence[str], count: int) -> str:
    return f"the first {len(names)} of {count} outputs" if count > len(names) else ""


def _groups(others: Sequence[Varied], size: int) -> Iterator[tuple[str, Any]]:
    """Yield a label and the rows of every combination of the other parameters."""
    if not others:
        yield "", np.full(size, True)
        return
    table = np.column_stack([axis.values for axis in others])
    for combination in np.unique(table, axis=0):
        label = ", ".join(axis.text(value) for axis, value in zip(others, combination, strict=True))
        yield label, np.all(table == combination, axis=1)


def _combinations(others: Sequence[Varied]) -> int:
    return len(np.unique(np.column_stack([axis.values for axis in others]), axis=0)) if others else 1


def _colours(others: Sequence[Varied]) -> list[Any]:
    """Return a colour for every combination of the other parameters."""
    count = _combinations(others)
    if count <= len(CYCLE):
        return list(CYCLE[:count])
    return [mpl.colormaps["viridis"](i / count) for i in range(count)]


# -- two parameters ----------------------------------------------------------------------------------------------------


def _maps(drawn: Drawn, axes: Sequence[Varied], names: Sequence[str], count: int) -> Figure:
    x, y, *others = axes
    table, good = drawn.table, ~drawn.failed
    gridded = table.gridded and not others
    subtitle = [_listed(names, count)]
    subtitle += [f"{', '.join(axis.name for axis in others)} varied too, from dot to dot"] if others else []
    subtitle += [_of_many(x, y, len(good), gridded=gridded)]
    page, panels = _page(drawn, (WIDE, HIGH + 0.4), len(names), _shape(len(names)), "; ".join(filter(None, subtitle)))
    for panel, name in zip(panels, names, strict=True):
        scale = shown_in(table.columns[name], drawn.columns[name])
        values = np.where(good, scale(drawn.columns[name]), np.nan)
        if not np.isfinite(values).any():
            empty_panel(panel, f"{name}: no row has one")
            continue
        if gridded:
            edges = [coarse_edges(_edges(axis), CELLS) for axis in (x, y)]
            cells = coarse(_placed(x, y, values), CELLS)
            dots: Any = panel.pcolormesh(*edges, cells, cmap="viridis", rasterized=True)
            panel.grid(visible=False)
            failed = _failed_cells(x, y, drawn.failed, cells)
        else:
            places = some(values, DOTS)
            dots = panel.scatter(
                x.values[places],
                y.values[places],
                c=values[places],
                cmap="viridis",
                s=16,
                rasterized=len(places) > FEW_DOTS,
            )
            failed = x.values[~good], y.values[~good]
        marked = some(failed[0], PLACES)
        panel.plot(failed[0][marked], failed[1][marked], "x", color=VERMILLION, markersize=5)
        bar = page.colorbar(dots, ax=panel, pad=0.02)
        bar.set_label(_label(name, scale.unit))
        bar.outline.set_visible(False)
        panel.set(title=plain(name), xlabel=plain(x.label), ylabel=plain(y.label))
        _ticked(panel.xaxis, x)
        _ticked(panel.yaxis, y)
        if x.log:
            panel.set_xscale("log")
        if y.log:
            panel.set_yscale("log")
    return page


def _of_many(x: Varied, y: Varied, count: int, *, gridded: bool) -> str:
    """Return what is said of a map that does not show all rows."""
    if not gridded:
        return f"{DOTS:,} of {count:,} rows are drawn, the minimum and the maximum among them" if count > DOTS else ""
    sides = [len(coarse_edges(_edges(axis), CELLS)) - 1 for axis in (x, y)]
    if sides == [len(axis.distinct) for axis in (x, y)]:
        return ""
    return f"{count:,} rows in {sides[0]} x {sides[1]} cells, each with the value farthest from the median"


def _failed_cells(x: Varied, y: Varied, failed: Any, cells: Array) -> tuple[Array, Array]:
    """Return the places of failed rows in whose cell of a map no row has a value."""
    rows = np.flatnonzero(failed)
    across, down = (np.searchsorted(axis.distinct, axis.values[rows]) for axis in (x, y))
    steps = [-(-len(axis.distinct) // CELLS) for axis in (x, y)]
    empty = rows[np.isnan(cells[down // steps[1], across // steps[0]])]
    return x.values[empty], y.values[empty]


def _edges(axis: Varied) -> Array:
    """Return the edges of cells around the values of an axis, half way between them."""
    values = np.log(axis.distinct) if axis.log else axis.distinct
    middle = (values[1:] + values[:-1]) / 2
    edges = np.concatenate([[2 * values[0] - middle[0]], middle, [2 * values[-1] - middle[-1]]])
    return np.exp(edges) if axis.log else edges


def _placed(x: Varied, y: Varied, values: Array) -> Array:
    """Return values as (y, x); nan where there is no row."""
    grid = np.full((len(y.distinct), len(x.distinct)), np.nan)
    grid[np.searchsorted(y.distinct, y.values), np.searchsorted(x.distinct, x.values)] = values
    return grid


# -- section -----------------------------------------------------------------------------------------------------------


def _diagram(drawn: Drawn, axes: Sequence[Varied], names: Sequence[str], count: int) -> Figure:
    """Draw the points of the section over the parameter with the most values."""
    table = drawn.table
    x = max(axes, key=lambda axis: len(axis.distinct))
    others = [axis for axis in axes if axis is not x]
    arrays, section, step = table.arrays[SECTION], _section(table, names), -(-len(table.rows) // PLACES)
    many = f"every {step}th of {len(table.rows):,} rows is drawn, and the extremes" if step > 1 else ""
    subtitle = "; ".join(filter(None, (table.place, _listed(names, count), many)))
    page, panels = _page(drawn, DIAGRAM, len(names), (len(names), 1), subtitle)
    failed = drawn.failed
    for panel, name in zip(panels, names, strict=True):
        of_row = np.array([i for i, _ in section[name]], dtype=int)
        points, folded = _within_a_turn([each for _, each in section[name]], arrays[name])
        dots = sum(map(len, points))
        scale = shown_in(arrays[name], np.concatenate(points)) if dots else shown_in(arrays[name], np.zeros(1))
        few = _combinations(others) <= MOST_CURVES
        shown = list(_groups(others, len(failed))) if few else [(_span(others), np.full(len(failed), True))]
        size = np.clip(ALL_DOTS / np.sqrt(max(dots, 1)), SMALLEST, LARGEST)
        for (label, mask), colour in zip(shown, _colours(others) if len(shown) > 1 else [BLUE], strict=True):
            places = np.flatnonzero((mask & np.isfinite(x.values))[of_row])
            at = np.concatenate([np.zeros(0), *(np.full(len(points[k]), x.values[of_row[k]]) for k in places)])
            values = np.concatenate([np.zeros(0), *(scale(points[k]) for k in places)])
            panel.plot(
                at, values, linestyle="none", marker="o", markersize=size, color=colour,
                markeredgewidth=0, rasterized=dots > FEW_DOTS,
            )  # fmt: skip
            panel.plot([], [], "o", color=colour, markersize=4, label=plain(label) or None)
        _mark_failures(panel, x.values[failed])
        _labelled(panel, name, f"{scale.unit}, modulo a turn" if folded else scale.unit)
        _scaled(panel, x)
        if panel is not panels[-1]:
            panel.set_xlabel("")
        if len(shown) > 1:
            panel.set_title(plain(name), pad=LEGEND_ROOM)
            legend(panel)
    return page


def _section(table: Sweep, names: Sequence[str]) -> dict[str, list[tuple[int, Array]]]:
    """Return rows with points of theirs: all, or where rows are many those of every nth row, and extremes.

    The extremes are the least and the largest point of the rows between.
    """
    step = -(-len(table.rows) // PLACES)
    by_name: dict[str, list[tuple[int, Array]]] = {name: [] for name in names}
    ends: dict[str, dict[int, tuple[int, Array]]] = {name: {} for name in names}  # by sign
    for i, points in enumerate(table.arrays_of(SECTION)):
        for name in names:
            values = points[name]
            if i % step == 0:
                by_name[name] += [*ends[name].values(), (i, values)]
                ends[name].clear()
                continue
            for sign in (-1, 1) if len(values) else ():
                end = values[[(sign * values).argmax()]]
                if sign not in ends[name] or sign * end[0] > sign * ends[name][sign][1][0]:
                    ends[name][sign] = i, end
    return {name: [*by_name[name], *ends[name].values()] for name in names}


def _within_a_turn(points: list[Array], unit: str) -> tuple[list[Array], bool]:
    """Return an angle's points, less whole turns where they span more than one, and whether they do."""
    every = np.concatenate([np.zeros(0), *points])
    if unit != "rad" or not len(every) or np.ptp(every) <= TURN:
        return points, False
    middle = np.angle(np.exp(1j * every).mean())  # no cluster is cut in two
    return [middle + np.mod(values - middle + np.pi, TURN) - np.pi for values in points], True


def _span(others: Sequence[Varied]) -> str:
    return ", ".join(
        f"{axis.name} {axis.distinct[0]:.6g} to {axis.distinct[-1]:.6g} {axis.unit}".rstrip() for axis in others
    )


# -- axes that vary ------------------------------------------------------------------------------------------------------

SAME_RATIO = 1e-6  # relative: values of such equal ratios are on a logarithmic scale
LEAST_SPAN = 4.0  # largest over smallest value, from which they are
PLACES, CELLS, DOTS = (
    2000,
    350,
    20_000,
)  # that are distinguished along a curve, along a side of a map, and of scattered dots


@dataclass(frozen=True)
class Varied:
    """Values (rows,) of one name in the unit they are shown in; `log`: they have equal ratios.

    labels    of an input whose rows choose by label: `values` are places among them
    """

    name: str
    unit: str
    values: Array
    log: bool
    labels: tuple[str, ...] = ()

    @property
    def distinct(self) -> Array:
        """Values without repetition, in order."""
        return np.unique(self.values[np.isfinite(self.values)])

    @property
    def label(self) -> str:
        """Text beside an axis."""
        return labelled(self.name, self.unit)

    def text(self, value: float) -> str:
        """Return one value with its unit."""
        if self.labels:
            return f"{self.name} = {self.labels[int(value)]}"
        return f"{self.name} = {value:.6g} {self.unit}".rstrip()


def extremes(values: Array, places: int) -> NDArray[np.intp]:
    """Return where a curve (n,) is drawn: everywhere, or at the extremes of each of so many parts."""
    if len(values) <= 2 * places:
        return np.arange(len(values))
    size = -(-len(values) // places)
    parts = np.pad(values, (0, -len(values) % size), constant_values=np.nan).reshape(-1, size)
    begin = size * np.arange(len(parts))
    least = begin + np.where(np.isnan(parts), np.inf, parts).argmin(axis=1)
    largest = begin + np.where(np.isnan(parts), -np.inf, parts).argmax(axis=1)
    return np.unique([least, largest])


def some(values: Array, count: int) -> NDArray[np.intp]:
    """Return where so many of the values (n,) are, spread evenly, the least and the largest among them."""
    if len(values) <= count:
        return np.arange(len(values))
    known = np.flatnonzero(np.isfinite(values))
    ends = known[[values[known].argmin(), values[known].argmax()]] if len(known) else known
    return np.unique([*np.linspace(0, len(values) - 1, count).astype(int), *ends])


def coarse(values: Array, cells: int) -> Array:
    """Return a map (n, m) with so many cells a side at most, each with its value farthest from the median."""
    (down, across) = (-(-n // cells) for n in values.shape)
    if down == across == 1:
        return values
    padded = np.pad(
        values, [(0, -n % k) for n, k in zip(values.shape, (down, across), strict=True)], constant_values=np.nan
    )
    parts = (
        padded.reshape(len(padded) // down, down, -1, across)
        .swapaxes(1, 2)
        .reshape(len(padded) // down, -1, down * across)
    )
    apart = np.abs(parts - np.nanmedian(values))
    place = np.where(np.isnan(apart), -1.0, apart).argmax(axis=2)
    return np.take_along_axis(parts, place[:, :, None], axis=2)[:, :, 0]


def coarse_edges(edges: Array, cells: int) -> Array:
    """Return the edges of the cells of such a map along one side, of those of all of its values."""
    step = -(-(len(edges) - 1) // cells)
    return np.append(edges[:-1:step], edges[-1])


def has_equal_ratios(values: Array) -> bool:
    """Return whether values span LEAST_SPAN in equal ratios."""
    distinct = np.unique(values[np.isfinite(values)])
    if len(distinct) < 3 or distinct[0] <= 0 or distinct[-1] < LEAST_SPAN * distinct[0]:
        return False
    steps = np.diff(np.log(distinct))
    return bool(np.ptp(steps) <= SAME_RATIO * steps.max())


def shown_in(unit: str, values: Array) -> Scale:
    """Return the unit to show values in; 1 for numbers."""
    finite = np.asarray(values, dtype=float)
    finite = finite[np.isfinite(finite)]
    return scale_of(unit, finite if len(finite) else np.zeros(1))


def labelled(name: str, unit: str) -> str:
    """Return a name with its unit."""
    return f"{name} [{unit}]" if unit else name
