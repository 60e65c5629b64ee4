"""Stage of a film: the mechanism, its clearances enlarged, contact forces and their histories, time."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.output.drawings import force_symbols, insets
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.drawing_primitives import INK, Paper
from hertzwerk.runtime.output.drawings.parts import Parts
from hertzwerk.runtime.output.drawings.picture import notes_on, spread
from hertzwerk.runtime.output.drawings.places import Landmark, Places
from hertzwerk.runtime.output.films.film_clock import Clock
from hertzwerk.runtime.output.films.moving_paper import MovingPaper
from hertzwerk.runtime.output.plots.curves import Curves
from hertzwerk.runtime.output.plots.plot_panel import lines
from hertzwerk.runtime.output.plots.plot_style import GREY, STYLE, VERMILLION, plain
from hertzwerk.runtime.output.plots.title import differences, title_height, title_of, write_title
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.engine.solution.solution import EngineSolution

SLIDING = 1e-9  # of the fastest: slower surfaces have no direction

PANEL = (6.0, 4.0)  # largest size of the mechanism, inches
DPI = 100
RUBBING = 1.0  # width of the arrow of friction, points
LONGEST, LEAST = 60.0, 7.0  # length of the arrow of the largest force, and of the shortest, points
STRIP, BELOW = 0.95, 0.42  # inches of the histories of forces, and of their time axis
NAMES, PATCH, LETTER, ROOM = 0.24, 0.36, 0.08, 1.1  # inches: of the names of bodies, a patch, a letter; of the time
MANY = 6  # pairs: of more the largest force is drawn alone
LINE, LETTERS = 0.165, 15  # inches of a line below; characters on an inch of it


def friction_of(curves: Curves, pair: str) -> Array:
    """Return the size of the friction force of a pair over the curves' times [N].

    That of a set-valued law is a history, also while it sticks. Of others by the power that friction takes, over the
    sliding velocity; 0 where it does not slide, in a scene without a ledger, and in a run of which there are rows alone.
    """
    model, nothing = curves.run.engine.model, np.zeros(len(curves.t))
    if not curves.run.engine.history.units.lists(f"{pair}.sliding_velocity") or not isinstance(curves.sampled, History):
        return nothing
    if is_set_valued(curves, pair):
        return np.abs(curves[f"{pair}.friction_force"])
    velocity = np.abs(curves[f"{pair}.sliding_velocity"])
    slides = velocity > SLIDING * np.max(velocity)
    entries = [
        f"{name}.dissipated"
        for name, kind, text in model.module.EFFECTS
        if kind == "friction" and text.endswith(f" at {pair}")
    ]
    rows = [model.memory.index(entry) for entry in entries if entry in model.memory]
    if not rows:
        return nothing
    powers = curves.sampled.map(f"contact_{pair}", "t q u z m")[1][:, rows].sum(axis=1)
    size: Array = np.divide(powers, velocity, out=nothing, where=slides)
    return np.maximum(size, 0.0)


def is_set_valued(curves: Curves, pair: str) -> bool:
    """Return whether the friction force of a pair, along its tangent, is a history of the run."""
    return curves.run.engine.history.units.lists(f"{pair}.friction_force")


def tangent_of(parts: Parts, marks: Sequence[Landmark], normal: Array) -> Array | None:
    """Return the tangent (3,) along which friction in plane motion counts; None in space."""
    for k in (2, 1, 0):
        if normal[k] == 0 and all(np.ptp(parts.positions[id(mark)][:, k]) == 0 for mark in marks[:2]):
            return np.cross(np.eye(3)[k], normal)
    return None


def slip_of(places: Places, marks: Sequence[Landmark], at: Array, j: int) -> Array:
    """Return the slip (3,) [m/s] of a pair at a point (3,): velocity of the first body less the second.

    At a row, by differences between the rows beside it.
    """
    before, after = max(j - 1, 0), min(j + 1, len(places.t) - 1)
    velocities = []
    for mark in marks[:2]:
        body = places.bodies.index(mark.body)
        within = places.rotations[j, body].T @ (at - places.origins[j, body])
        ends = [places.origins[k, body] + places.rotations[k, body] @ within for k in (before, after)]
        velocities.append((ends[1] - ends[0]) / max(places.t[after] - places.t[before], 1e-300))
    change: Array = velocities[0] - velocities[1]
    return change


Contact = tuple[Array, Array]
"""Contact point (3,) [m], and the unit direction (3,) of the normal force on the first body."""


def contact_of(parts: Parts, kind: str, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return point and direction of a pair's force at an instant; None where landmarks lack it."""
    find = CONTACTS.get(kind)
    return None if find is None else find(parts, marks, i)


def _inside(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a pin in a bush, or a ball in a socket: where the eccentricity points to."""
    inner, outer = marks
    way = _unit(_across(parts, marks, i, parts.positions[id(inner)][i] - parts.positions[id(outer)][i]))
    return None if way is None else (parts.positions[id(inner)][i] + inner.size("radius") * way, -way)


def _outside(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of two spheres, or parallel cylinders, beside each other."""
    first, second = marks
    way = _unit(_across(parts, marks, i, parts.positions[id(first)][i] - parts.positions[id(second)][i]))
    return None if way is None else (parts.positions[id(second)][i] + second.size("radius") * way, way)


def _on_plane(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a sphere, a cylinder or a corner on a plane."""
    first, second = marks
    normal = parts.places.direction(second, "normal")[i]
    radius = first.size("radius") if "radius" in first.beside else 0.0
    return parts.positions[id(first)][i] - radius * normal, normal


def _rim(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a disc's lowest point on a plane."""
    first, second = marks
    normal, axis = parts.places.direction(second, "normal")[i], parts.places.direction(first, "axis")[i]
    up = _unit(normal - (normal @ axis) * axis)
    return None if up is None else (parts.positions[id(first)][i] - first.size("radius") * up, normal)


def _across(parts: Parts, marks: Sequence[Landmark], i: int, vector: Array) -> Array:
    """Return the part of a vector across the axis of a pair, if it has one."""
    axis = parts.axis_of(marks, i)
    return vector if axis is None else vector - (vector @ axis) * axis


def _unit(vector: Array) -> Array | None:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0 else None


CONTACTS: dict[str, Callable[[Parts, Sequence[Landmark], int], Contact | None]] = {
    "pin_in_bush": _inside,
    "ball_in_socket": _inside,
    "sphere_on_sphere": _outside,
    "parallel_cylinders": _outside,
    "sphere_on_plane": _on_plane,
    "cylinder_on_plane": _on_plane,
    "corner_on_face": _on_plane,
    "rim_on_plane": _rim,
}


@dataclass(frozen=True)
class Layout:
    """Page with everything that is still, the places on it, and where the time stands."""

    page: Figure
    main: Axes
    windows: list[Axes]
    insets: list[insets.Inset]
    strip: Axes | None
    time: tuple[float, float]


@dataclass
class Stage:
    """A figure whose shapes `show` moves to the instant of a frame."""

    run: EngineSolution
    clock: Clock
    curves: Curves
    drawing: Drawing
    at: NDArray[np.intp]  # of each frame: its row in the places
    papers: list[MovingPaper] = field(default_factory=list)

    @classmethod
    def of(cls, run: EngineSolution, clock: Clock) -> Stage:
        """Set the stage of a run that has its functions; raises InputError for a saved one."""
        curves = Curves.of(run)
        times = clock.times
        if curves.run.engine.history.steps:
            places = Places.over(curves.run, also=np.union1d(times, curves.t))
        else:
            places = Places.over(curves.run)
            nearest = np.clip(np.searchsorted(places.t, times), 1, len(places.t) - 1)
            times = places.t[nearest - (times - places.t[nearest - 1] < places.t[nearest] - times)]
        return cls(run, clock, curves, Drawing.of(places, PANEL), np.searchsorted(places.t, times))

    @property
    def made(self) -> int:
        """Number of shapes that frames have made so far."""
        return sum(paper.made for paper in self.papers)

    @cached_property
    def figure(self) -> Figure:
        """The figure of the film: an image of everything that is still, and axes over it for what moves."""
        layout = self._layout
        canvas: Any = FigureCanvasAgg(layout.page)
        canvas.draw()
        width, height = layout.page.get_size_inches()
        film = Figure(figsize=(width, height), dpi=DPI)
        film.figimage(np.array(canvas.buffer_rgba()), zorder=-1)
        main, *windows = (_over(film, axis) for axis in (layout.main, *layout.windows))
        self._main = MovingPaper(main, self.drawing.symbol)
        self._details = [MovingPaper(window, inset.point) for window, inset in zip(windows, layout.insets, strict=True)]
        self.papers[:] = [self._main, *self._details]
        self._links = [
            inset.link(film, window, main, below=len(layout.insets) > 1)
            for window, inset in zip(windows, layout.insets, strict=True)
        ]
        if layout.strip is not None:
            self._cursor = _over(film, layout.strip).axvline(0.0, color=INK, linewidth=1.0)
        self._time = film.text(*layout.time, "", ha="right", va="bottom", fontsize=11)
        return film

    def show(self, k: int) -> None:
        """Move everything to frame k."""
        i, parts, _ = int(self.at[k]), self.drawing.parts, self.figure
        with self._main.frame():
            parts.draw(self._main, i)
            force_symbols.draw(parts, self._main, i)
            for mark, way in self.drawing.paths:
                self._main.path(way[: i + 1], parts.colours[mark.body])
            for name, force in self._acting(k):
                self._arrow(self._main, name, force, k, i)
                self._rub(self._main, name, k, i)
        for inset, paper, link in zip(self._layout.insets, self._details, self._links, strict=True):
            inset.look_at(paper.axis, i)
            link.follow(inset, i)
            with paper.frame():
                inset.draw(paper, i, i + 1)
                for name, force in self._acting(k):
                    if name == inset.name:
                        self._arrow_in(inset, paper, force, i)
                        self._rub(paper, name, k, i, inset)
        self._time.set_text(self.clock.shown(k))
        if self._layout.strip is not None:
            self._cursor.set_xdata([self.curves.time(self.clock.times[k])] * 2)

    # -- forces --------------------------------------------------------------------------------------------------------

    @cached_property
    def forces(self) -> dict[str, Array]:
        """Normal forces of the pairs over the curves' times [N]; empty where none acts and there is no film."""
        forces = {name: self.curves[f"{name}.normal_force"] for name in self.run.engine.model.pairs}
        oils = self.run.engine.model.effects_at_pairs("lubrication")
        return forces if oils or any(np.any(force) for force in forces.values()) else {}

    @property
    def _rubs(self) -> bool:
        return any(np.any(size) for size in self.frictions.values())

    @cached_property
    def peak(self) -> float:
        """Largest of all normal forces [N]."""
        return max((float(np.max(force)) for force in self.forces.values()), default=0.0)

    @cached_property
    def _largest(self) -> dict[str, Array]:
        """Largest force of each pair since the frame before, by frame [N]."""
        ends = np.searchsorted(self.curves.t, self.clock.times, side="right")
        begins = np.concatenate([[0], ends[:-1]])
        return {
            name: np.array([np.max(force[begin:end], initial=0.0) for begin, end in zip(begins, ends, strict=True)])
            for name, force in self.forces.items()
        }

    def _acting(self, k: int) -> list[tuple[str, float]]:
        """Return the pairs that have touched since the frame before, and their largest forces [N]."""
        return [(name, float(forces[k])) for name, forces in self._largest.items() if forces[k] > 0]

    def _friction(self, name: str, k: int, i: int) -> tuple[Array, float] | None:
        """Return direction (3,) and size [N] of friction on the first body, when its pair's force was largest.

        Along the tangent at row i; None where there is none.
        """
        m = self._largest_at(name, k)
        size = float(self.frictions[name][m])
        places, parts = self.drawing.parts.places, self.drawing.parts
        kind, marks = self._pairs[name]
        j = int(np.searchsorted(places.t, self.curves.t[m]))
        then, now = (contact_of(parts, kind, marks, row) for row in (min(j, len(places.t) - 1), i))
        if size <= 0 or then is None or now is None:
            return None
        if is_set_valued(self.curves, name):
            tangent = tangent_of(parts, marks, now[1])
            sign = np.sign(self.curves[f"{name}.friction_force"][m])
            if tangent is not None:
                return sign * tangent, size
            if not self.run.engine.model.reads:
                return None
            force = np.array([self.curves[f"{name}.friction_force_{axis}"][m] for axis in "xyz"])
            return force / size, size
        slip = slip_of(places, marks, then[0], j)
        along = slip - (slip @ now[1]) * now[1]
        speed = float(np.linalg.norm(along))
        return (-along / speed, size) if speed > 0 else None

    @cached_property
    def frictions(self) -> dict[str, Array]:
        """Sizes of the friction forces of the pairs over the curves' times [N]."""
        return {name: friction_of(self.curves, name) for name in self.forces}

    @cached_property
    def _pairs(self) -> dict[str, tuple[str, list[Landmark]]]:
        """Kind and landmarks of every pair."""
        return {
            part: (kind, marks)
            for (part, kind), marks in self.drawing.parts.of.items()
            if part in self.run.engine.model.pairs
        }

    def _rub(self, paper: MovingPaper, name: str, k: int, i: int, inset: insets.Inset | None = None) -> None:
        """Draw the friction force of a pair from where it acts, thinner than the normal force."""
        parts = self.drawing.parts
        friction, contact = self._friction(name, k, i), contact_of(parts, *self._pairs[name], i)
        if friction is None or contact is None:
            return
        way = parts.view(friction[0])
        projected = float(np.linalg.norm(way))
        if projected <= 0.05:
            return
        at, longest = parts.flat(contact[0]), LONGEST
        if inset is not None:
            away = inset.path[i] if inset.exaggerated or inset.way else np.zeros(2)
            distance = float(np.linalg.norm(away))
            if distance == 0:
                return
            at, longest = inset.centre + away + inset.pin_radius * away / distance, insets.WIDTH * 72 / 3
        _push(
            paper, at, way / projected, max(longest * friction[1] / self.peak, LEAST) * paper.point * projected, RUBBING
        )

    def _contact(self, name: str, k: int, i: int) -> Contact | None:
        """Return where a pair's force acts and its direction: by landmarks, or as it was when it was largest."""
        kind, marks = self._pairs[name]
        if kind in CONTACTS or not self.run.engine.model.reads:
            return contact_of(self.drawing.parts, kind, marks, i)
        m = self._largest_at(name, k)
        point, force = (self._vector(f"{name}.{quantity}", m) for quantity in ("point", "force"))
        size = float(np.linalg.norm(force))
        return (point, force / size) if size > 0 and np.all(np.isfinite(point)) else None

    def _vector(self, name: str, m: int) -> Array:
        """Return a vector (3,) that can be read of the run, at a row of the curves."""
        parts = (f"{name}_{axis}" for axis in "xyz")
        return np.array([self.curves[part][m] if part in self.run.engine.history.units else 0.0 for part in parts])

    def _largest_at(self, name: str, k: int) -> int:
        """Return the curves' row since the frame before at which a pair's normal force was largest."""
        begin, end = np.searchsorted(self.curves.t, self.clock.times[[max(k - 1, 0), k]], side="right")
        return int(begin + np.argmax(self.forces[name][begin:end])) if end > begin else int(end - 1)

    def _arrow(self, paper: MovingPaper, name: str, force: float, k: int, i: int) -> None:
        contact = self._contact(name, k, i)
        if contact is None:
            return
        view, flat = self.drawing.parts.view, self.drawing.parts.flat
        way = view(contact[1])
        projected = float(np.linalg.norm(way))
        length = max(LONGEST * force / self.peak, LEAST) * self.drawing.point * projected
        if projected > 0.05:
            _push(paper, flat(contact[0]), way / projected, length)

    def _arrow_in(self, inset: insets.Inset, paper: MovingPaper, force: float, i: int) -> None:
        """Draw a force in the window of a joint, from where the enlarged pin touches."""
        away = inset.path[i] if inset.exaggerated or inset.way else np.zeros(2)
        distance = float(np.linalg.norm(away))
        if distance > 0:
            way = away / distance
            length = max(force / self.peak * insets.WIDTH * 72 / 3, LEAST) * paper.point
            _push(paper, inset.centre + away + inset.pin_radius * way, -way, length)

    # -- still parts ---------------------------------------------------------------------------------------------------

    @cached_property
    def _layout(self) -> Layout:
        """The page with everything that is still."""
        drawing, run = self.drawing, self.run
        shown, strip = list(insets.clearances(drawing.parts, drawing.point)), bool(self.forces)
        row, plane = len(shown) > 1, drawing.parts.view.names is not None
        (width, height), left, under = drawing.size, 0.75 if plane else 0.15, 0.52 if plane else 0.1
        across = _even(left + width + (insets.WIDTH + 0.4 if len(shown) == 1 else 0.2))
        notes, cautions = (
            [line for text in texts for line in textwrap.wrap(text, int(LETTERS * across))]
            for texts in (self.notes(), notes_on(run))
        )
        title, differs = title_of(run.engine.model, run.engine.model.module.SUMMARY), differences(run)
        foot = 0.1 + LINE * (len(notes) + len(cautions))
        low = foot + (STRIP + BELOW + 0.25 if strip else 0.0)
        main = low + under + (insets.HEIGHT if row else 0.0)
        top = max(main + height, main + insets.HEIGHT) + 0.1
        tall = _even(top + title_height(across, title, differs) + NAMES)

        def fraction(x: float, y: float, w: float, h: float) -> tuple[float, float, float, float]:
            return x / across, y / tall, w / across, h / tall

        with mpl.rc_context({**STYLE, "axes.grid": False}):
            page = Figure(figsize=(across, tall), dpi=DPI)
            write_title(page, title, differs)
            axis = page.add_axes(fraction(left, main, width, height))
            drawing.prepare(axis)
            self._name_bodies(page, top / tall, across - ROOM)
            spots = [(left + width + 0.3, main + height - insets.HEIGHT)]
            if row:
                wanted = [
                    left + (inset.centre[0] - drawing.frame[0]) / drawing.point / 72 - insets.WIDTH / 2
                    for inset in shown
                ]
                spots = [(x, low + 0.4) for x in spread(np.array(wanted), left, left + width - insets.WIDTH)]
            windows = [
                inset.window(page, fraction(x, y, insets.WIDTH, insets.WIDTH), drawing.point, row)
                for (x, y), inset in zip(spots, shown, strict=False)
            ]
            histories = page.add_axes(fraction(0.75, foot + BELOW, across - 0.95, STRIP)) if strip else None
            if histories is not None:
                self._draw_histories(histories)
            for texts, y, colour in ((notes, 0.06 + LINE * len(cautions), GREY), (cautions, 0.06, VERMILLION)):
                page.text(0.1 / across, y / tall, plain("\n".join(texts)), va="bottom", fontsize=8.5, color=colour)
        time = 1 - 0.1 / across, (top + 0.04) / tall
        return Layout(page, axis, windows, shown, histories, time)

    def notes(self) -> Iterator[str]:
        """Yield remarks that stand below the film."""
        pace = f"{self.clock.pace()}, {self.clock.fps:g} frames a second."
        if self.peak > 0:
            scale = scale_of("N", self.peak)
            pace += (
                f" Arrows: contact force on the first body of a pair, the largest since the frame before; "
                f"{'thinner its friction at that instant; ' if self._rubs else ''}the longest is {self.peak / scale.factor:.3g} {scale.unit}."
            )
            kinds = dict(self.run.engine.model.module.PAIRS)
            others = dict.fromkeys(_whole(name) for name in self.forces if kinds[name] not in CONTACTS)
            if others:
                lead = "With friction in one" if self.run.engine.model.reads else "Without an arrow"
                pace += f" {lead}: {', '.join(others)}."
        yield pace
        yield from self.curves.notes[: 0 if self.curves.run.engine.history.steps else 1]

    def _name_bodies(self, page: Figure, y: float, room: float) -> None:
        """Write the names of the bodies in their colours, where there is room [inch] for them."""
        bodies, colours = self.drawing.parts.places.bodies[1:], self.drawing.parts.colours
        if not bodies or sum(PATCH + LETTER * len(body) for body in bodies) > room:
            return
        patches = [Patch(color=colours[body], label=body) for body in bodies]
        look: dict[str, Any] = {"handlelength": 0.8, "handleheight": 0.8, "columnspacing": 1.0, "borderaxespad": 0.2}
        page.legend(handles=patches, loc="lower left", bbox_to_anchor=(0.0, y), ncols=len(bodies), **look)

    def _draw_histories(self, axis: Axes) -> None:
        """Draw the histories of the forces."""
        oils = self.run.engine.model.effects_at_pairs("lubrication")
        shown = {name: force for name, force in self.forces.items() if np.any(force)}
        shown |= {f"film, {oil}": self.curves[f"{oil}.force"] for oil in oils.values()}
        if len(shown) > MANY:
            shown = {f"largest of {len(shown)}": np.max(list(shown.values()), axis=0)}
        scale = lines(axis, self.curves, "N", shown)
        axis.set_ylim(bottom=0)
        axis.set_xlim(*self.curves.time(self.curves.t[[0, -1]]))
        axis.tick_params(labelsize=8)
        axis.set_xlabel(f"time [{self.curves.time.unit}]", fontsize=8.5, labelpad=1)
        axis.set_ylabel(f"[{scale.unit}]", fontsize=8.5)
        label = ", ".join(shown) if len(shown) == 1 else ""
        axis.set_title(f"force{f': {label}' if label else ''}", fontsize=8.5, fontweight="normal", pad=3)
        if len(shown) > 1:
            axis.legend(loc="lower right", bbox_to_anchor=(1.0, 0.97), ncols=len(shown), fontsize=8, handlelength=1.2)


def _even(length: float) -> float:
    """Round a length [inch] up to an even number of pixels, which video needs."""
    return float(np.ceil(length * DPI / 2) * 2 / DPI)


def _over(film: Figure, axis: Axes) -> Axes:
    """Return an empty axis of the film over one of the page."""
    over = film.add_axes(axis.get_position().bounds, xlim=axis.get_xlim(), ylim=axis.get_ylim())
    over.set_axis_off()
    return over


def _whole(name: str) -> str:
    """Return the name of a part of a pair as that of all its parts."""
    head, _, number = name.rpartition("_")
    return f"{head}_.." if head and number.isdigit() else name


def _push(paper: Paper, at: Array, way: Array, length: float, width: float = 1.6) -> None:
    """Draw a force from its point on."""
    head = min(6.0, 0.7 * length / paper.point)
    paper.arrow(np.array([at, at + length * way]), VERMILLION, width, 8.0, head)
