"""Loading: from a built-in scene's name, a Python file or a Scene to a model that runs and draws."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, among, faults_if, refuse, shown, unknown
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH
from hertzwerk.runtime.engine.model.binding import Port, Value
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.engine.model.model import BoundParameters, Declaration, EngineModel

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.derive.declare.scene.scene import Scene
    from hertzwerk.derive.exchange.readable_equations.readable_record import Readable
    from hertzwerk.runtime.output.tables.history_meanings import Histories


MODELS = 8  # of built-in scenes, kept with the functions built for them: some MB each
OF_FLOW, OF_LOOP = ("rates", "ends", "holding"), ("begin", "step", "attempt")  # functions beside the module's


class Model:
    """Model of a scene that can be simulated, studied and drawn, as `load` returns it.

    Raises InputError for what `load` refuses.
    """

    def __init__(self, target: Target) -> None:
        self._engine = engine_model(target)

    @property
    def engine(self) -> EngineModel:
        """Engine's record of the model: sizes, rows, and functions by the parts of the state."""
        return self._engine

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self.engine.name

    @property
    def summary(self) -> str:
        """Description of the scene in one line."""
        return str(self.engine.module.SUMMARY)

    @property
    def text(self) -> str:
        """Text of the generated module; empty for a saved run, which has none."""
        return text_of(self.engine.module)

    @property
    def parameters(self) -> Mapping[str, Port]:
        """Parameters by name: unit, default in that unit, meaning."""
        return self.engine.parameters

    @property
    def states(self) -> Mapping[str, str]:
        """SI units of the integrated states by name: coordinates, speeds, memory."""
        return self.engine.units

    @property
    def inputs(self) -> Mapping[str, tuple[str, str]]:
        """Unit and meaning of the inputs by name."""
        return self.engine.inputs

    @property
    def effects(self) -> Mapping[str, tuple[str, str]]:
        """Kind and description of the effects by name, which `without` leaves out."""
        return {name: (kind, text) for name, kind, text in self.engine.module.EFFECTS}

    @property
    def pairs(self) -> tuple[str, ...]:
        """Names of the contact pairs."""
        return self.engine.pairs

    @property
    def histories(self) -> Histories:
        """All histories of a run by name, unit and meaning, shown as a table; readings are derived here."""
        from hertzwerk.runtime.output.tables.history_meanings import entries

        return entries(self.engine)

    def bind(self, parameters: Mapping[str, Value] | None = None) -> BoundParameters:
        """Return the defaults overridden by `parameters`, in SI; raises InputError with every fault."""
        return self.engine.bind(parameters)

    def function(self, name: str, method: str = "dop853") -> Any:
        """Return a CasADi function of the module, the right-hand side, or the time loop; raises InputError.

        "rates", "ends", "holding" of (t, y, mode, m, c): dy/dt, all that a step's end has, forces that hold
        "begin", "step", "attempt" of a method in the graph: first state, trial of a step, next state
        others are the module's, which documents their arguments; "contact_<pair>" is a pair's
        """
        if among(name, *OF_FLOW):
            return getattr(flow(self.engine), name)
        if not among(name, *OF_LOOP):
            return self.engine.function(name, beside=(*OF_FLOW, *OF_LOOP))
        if not among(method, *IN_GRAPH):
            raise InputError(self.name, [unknown("method", method, IN_GRAPH)])
        made = integrator(self.engine, tuple(table() for table in IN_GRAPH[method]))
        return made.step() if name == "step" else getattr(made, name)

    def evaluate(self, name: str, *arguments: float | np.ndarray) -> list[np.ndarray]:
        """Evaluate one of the module's functions on numbers and vectors, in SI; its results as vectors.

        Raises InputError for an unknown function, and for arguments of another number or size.
        """
        try:
            return self.engine.evaluate(name, *arguments)
        except (TypeError, ValueError) as error:
            expected = "numbers and vectors as the module documents them"
            raise InputError(self.name, [Fault(f"arguments of {name}", str(error), expected)]) from None

    def equations(self) -> Readable:
        """Return the equations of the model for people, derived anew from its scene.

        Markdown with LaTeX, typeset in a notebook. Raises InputError for a model without its scene, as a saved run
        has it.
        """
        return self.engine.equations()

    def draw(
        self, *, parameters: Mapping[str, Value] | None = None, initial: Mapping[str, Value] | None = None
    ) -> Figure:
        """Draw the mechanism at its start, clearances enlarged; raises InputError.

        `Solution.draw` shows how it moves.
        """
        from hertzwerk.runtime.output.drawings import picture

        return picture.of_start(self.engine, parameters, initial)

    def __repr__(self) -> str:
        return repr(self.engine)

    def _repr_html_(self) -> str:
        from hertzwerk.runtime.output.tables.notebook import of_model

        return of_model(self.engine, self.draw())


def _type_faults(target: Any, without: Any, laws: Any, coordinates: Any) -> list[Fault]:
    """Return the faults of arguments of a wrong type."""
    objects = isinstance(target, str | Path | ModuleType | Model | EngineModel) or hasattr(target, "mechanism")
    names = isinstance(without, list | tuple) and all(isinstance(name, str) for name in without)
    pairs = () if laws is None else laws.items() if isinstance(laws, Mapping) else ((laws, None),)
    by_effect = all(isinstance(name, str) and isinstance(law, str) for name, law in pairs)
    built_in = "the name of a built-in scene, a Python file, a Scene, a Model or a generated module"
    by_name = 'laws by the names of effects, such as {"floor": "flores"}'
    return faults_if(
        (not objects, Fault("target", shown(target), built_in)),
        (not names, Fault("without", shown(without), "a list of names of effects")),
        (not by_effect, Fault("laws", shown(laws), by_name)),
        (not isinstance(coordinates, str | None), Fault("coordinates", shown(coordinates), '"tree", "absolute" or "auto"')),
    )  # fmt: skip


Target: TypeAlias = "str | Path | Scene | ModuleType | Model | EngineModel"
"""Target of every function: a built-in scene by name, FILE.py, FILE.py:NAME, package.module:NAME, or the object itself.

A file holds a scene or is a generated module.
"""


def load(
    target: Target,
    *,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    coordinates: str | None = None,
) -> Model:
    """Return the model of a scene, of a generated module, or of another Model.

    A target is the name of a built-in scene, a Python file that defines `scene` or is a generated module, "FILE.py:NAME"
    where a file has several scenes, "package.module:NAME", or the object. A built-in scene without variation, and a
    generated module, never import SymPy. `without` names effects to omit. `laws` replaces the law of an effect, by
    name. `coordinates`, "tree", "absolute" or "auto", replace the scene's own. Raises InputError.
    """
    return Model(engine_model(target, without=without, laws=laws, coordinates=coordinates))


def engine_model(
    target: Target,
    *,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    coordinates: str | None = None,
) -> EngineModel:
    """Return the engine's model of any target, varied as `load` varies it; raises InputError."""
    if isinstance(target, Model):
        target = target.engine
    plain = isinstance(without, tuple) and not without and laws is None and coordinates is None
    if plain and isinstance(target, EngineModel):  # as of every run
        return target
    refuse("load", _type_faults(target, without, laws, coordinates))
    varied = bool(without or laws or coordinates is not None)
    if isinstance(target, EngineModel) and not varied:
        return target
    name = target if isinstance(target, str) and target.isidentifier() else ""
    if name and not varied and importlib.util.find_spec(f"hertzwerk.generated.{name}") is not None:
        return _built_in(name)
    from hertzwerk.runtime.engine.model import build

    laws = {effect: build.located_laws(law, Path.cwd()) for effect, law in (laws or {}).items()}
    how = tuple(without), tuple(laws.items()), coordinates
    if isinstance(target, str) and not build.in_python(target):
        return EngineModel(build.build_built_in(target, without, laws, coordinates), Declaration(target, *how))
    source = build.source_of(target) if isinstance(target, str | Path) else "a scene"
    scene = build.scene_or_module(target) if isinstance(target, str | Path) else target
    if isinstance(scene, ModuleType | EngineModel):
        model = EngineModel(scene) if isinstance(scene, ModuleType) else scene
        return _varied(model, without, laws, coordinates) if varied else model
    return EngineModel(build.build(build.vary(scene, without, laws, coordinates), source), Declaration(scene, *how))


@lru_cache(maxsize=MODELS)
def _built_in(name: str) -> EngineModel:
    """Return the model of a built-in scene, with what earlier runs built of it."""
    return EngineModel(importlib.import_module(f"hertzwerk.generated.{name}"), Declaration(name))


def _varied(
    model: EngineModel, without: Sequence[str], laws: Mapping[str, str], coordinates: str | None
) -> EngineModel:
    """Return the model of a variation of a model's scene, its inputs with their values; raises InputError."""
    of = model.declared_for("without, laws or coordinates")
    gone, changed = (*of.without, *without), {**dict(of.laws), **laws}
    other = engine_model(of.target, without=gone, laws=changed, coordinates=coordinates or of.coordinates)
    return other.with_signals({name: signal for name, signal in model.signals.items() if name in other.inputs})
