"""Results as notebooks show them: a model with a picture, a run with impacts, others as printed."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from hertzwerk.derive.common.markup import OTHER, Markup, embedded, heading, joined, table, tag, titled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.engine.solution.solution import EngineSolution


class Printed:
    """Result that a notebook shows as `print` does."""

    def _repr_html_(self) -> str:
        return tag("pre", str(self))


class Sentences(Printed, ABC):
    """Result in sentences, each with a label."""

    @abstractmethod
    def lines(self) -> Iterator[tuple[str, str]]:
        """Yield what was found, as labels and sentences."""

    def __str__(self) -> str:
        return "\n".join(f"{label}: {text}" for label, text in self.lines())


def of_model(model: EngineModel, picture: Figure) -> Markup:
    """Return a model with the picture of its start."""
    from hertzwerk.runtime.output.plots.save_figure import png_of

    sizes = f"{model.nq} coordinates, {model.k} contact pair{'s' if model.k != 1 else ''}, {len(model.units)} states"
    parameters = [(name, f"{p.default:.6g}", p.unit, p.meaning) for name, p in model.parameters.items()]
    return joined([
        heading(model.name, model.module.SUMMARY, f" ({sizes}; every history: model.histories)", good=True),
        embedded(png_of(picture, dpi=80), f"The mechanism {model.name} at its start"),
        titled("Effects", ("effect", "kind", "what it is"), model.module.EFFECTS),
        titled("Parameters", ("parameter", "value", "unit", "meaning"), parameters),
    ])  # fmt: skip


SHOWN = 8  # impacts of a run


def of_run(run: EngineSolution, parameters: Mapping[str, tuple[float, str]]) -> Markup:
    """Return outcome, warnings, given parameters, and the first impacts of a run."""
    first, *rest = str(run).split("\n")
    name = run.outcome.name
    parts = [heading(run.engine.model.name, name, first.removeprefix(name), good=name == "finished")]
    parts += [tag("p", note, style=f"color:{OTHER}") for note in (*rest, *run.warnings)]
    if parameters:
        parts.append(
            table(("parameter", "value"), [(name, f"{x:.6g} {unit}") for name, (x, unit) in parameters.items()])
        )
    if run.impacts:
        header = ("impact", "t [s]", "speed [m/s]", "peak force [N]", "duration [s]")
        parts.append(table(header, [
            (i.contact, f"{i.t:.6g}", f"{i.speed:.4g}", f"{i.peak_force:.4g}", "" if i.duration is None else f"{i.duration:.4g}")
            for i in run.impacts[:SHOWN]
        ]))  # fmt: skip
    more = len(run.impacts) - SHOWN
    parts += [tag("p", f"and {more:,} more impacts")] if more > 0 else []
    return joined(parts)
