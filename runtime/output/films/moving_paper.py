"""Paper whose shapes are moved from frame to frame, not drawn anew."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, TypeVar

from matplotlib.artist import Artist
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon

from hertzwerk.runtime.output.drawings.drawing_primitives import Paper
from hertzwerk.runtime.system.arrays import Array

Shape = TypeVar("Shape", bound=Artist)


@dataclass
class MovingPaper(Paper):
    """Paper on which every frame is drawn with the shapes of the frame before, moved.

    A shape of the same look is taken again. Shapes that a frame does not need are hidden; a shape is made only where none of its look is left.
    """

    made: int = 0
    _shapes: dict[Hashable, list[Artist]] = field(default_factory=dict)
    _used: dict[Hashable, int] = field(default_factory=dict)

    @contextmanager
    def frame(self) -> Iterator[None]:
        """Enter a context in which one frame is drawn."""
        self._used = dict.fromkeys(self._used, 0)
        yield
        for key, shapes in self._shapes.items():
            for shape in shapes[self._used[key] :]:
                shape.set_visible(False)

    def polygon(self, outline: Array, **look: Any) -> None:
        """Move or make a filled outline (n, 2)."""
        self._next(Polygon, lambda: Polygon(outline, **look), look).set_xy(outline)

    def stroke(self, points: Array, **look: Any) -> None:
        """Move or make a line through points (n, 2)."""
        self._next(Line2D, lambda: Line2D(*points.T, **look), look).set_data(*points.T)

    def strokes(self, lines: Array, **look: Any) -> None:
        """Move or make separate lines (k, 2, 2)."""
        self._next(LineCollection, lambda: LineCollection(list(lines), **look), look).set_segments(list(lines))

    def _next(self, kind: type[Shape], make: Callable[[], Shape], look: dict[str, Any]) -> Shape:
        """Return the next shape of a look, made where there is none."""
        key = (kind, *sorted((name, value) for name, value in look.items() if name != "zorder"))
        shapes, used = self._shapes.setdefault(key, []), self._used.get(key, 0)
        if used == len(shapes):
            shapes.append(make())
            self.axis.add_artist(shapes[-1])
            self.made += 1
        self._used[key] = used + 1
        shape = shapes[used]
        assert isinstance(shape, kind)
        shape.set_visible(True)
        shape.set_zorder(look["zorder"])
        return shape

    def _mark(self, points: Array) -> None:
        """Leave no ink: there are no names that would keep away from it."""
