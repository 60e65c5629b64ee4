"""Report of a scene: its mechanism, parameters, effects, equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hertzwerk.derive.common.markup import joined
from hertzwerk.runtime.output.reports import scene_sections
from hertzwerk.runtime.output.reports.html_page import (
    Origin,
    Section,
    bullets,
    facts,
    number_text,
    page,
    table,
    unit_markup,
)
from hertzwerk.runtime.system.versions import versions

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel


def model_page(model: EngineModel, origin: Origin | None = None) -> str:
    """Return the page of a scene at its own parameters; nothing is simulated."""
    from hertzwerk.runtime.output.drawings import picture

    readable, why = scene_sections.readable_of(model)
    advice = tuple(model.module.ADVICE)
    own = {name: (port.default, port.unit) for name, port in model.parameters.items()}
    states = table(("state", "unit"), [[name, unit_markup(unit)] for name, unit in model.units.items()])
    shown = scene_sections.drawn(
        lambda: picture.of_start(model, None, None), "mechanism", f"The mechanism {model.name} at its start"
    )
    sections = [
        *([Section("Advice", bullets(advice))] if advice else []),
        Section("Picture", shown),
        scene_sections.parameters(model, own, readable),
        scene_sections.effects(model, readable),
        Section("States", states),
        scene_sections.equations(readable, why),
    ]
    sizes = {"coordinates": model.nq, "speeds": model.nu, "contact pairs": model.k, "loop constraints": model.nl}
    top = joined([facts({name: number_text(size) for name, size in sizes.items()})])
    made = origin or Origin(f"hertzwerk report {model.name}", versions())
    return page("scene", model.name, model.module.SUMMARY, top, sections, made)
