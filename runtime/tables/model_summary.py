"""Models as notebooks show them: a picture of the start, parameters, effects."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from hertzwerk.derive.html.markup import Markup, embedded, joined
from hertzwerk.derive.html.plain_table import heading, titled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.model.model import Model


def of_model(model: Model, picture: Figure) -> Markup:
    """Return a model with the picture of its start."""
    image = io.BytesIO()
    picture.savefig(image, format="png", dpi=80)
    sizes = f"{model.nq} coordinates, {model.k} contact pair{'s' if model.k != 1 else ''}, {len(model.units)} states"
    parameters = [(name, f"{p.default:.6g}", p.unit, p.meaning) for name, p in model.parameters.items()]
    return joined([
        heading(model.name, model.module.SUMMARY, f" ({sizes}; every history: model.histories)", good=True),
        embedded(image.getvalue(), f"The mechanism {model.name} at its start"),
        titled("Effects", ("effect", "kind", "what it is"), model.module.EFFECTS),
        titled("Parameters", ("parameter", "value", "unit", "meaning"), parameters),
    ])  # fmt: skip
