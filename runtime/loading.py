"""Loading: from a built-in scene's name, a Python file or a Scene to a model that runs and draws."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeAlias

from hertzwerk.derive.common.faults import Fault, InputError, shown, unknown
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH
from hertzwerk.runtime.engine.model import model as plain

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.derive.declare.scene.scene import Scene
    from hertzwerk.runtime.engine.model.binding import Value
    from hertzwerk.runtime.engine.model.signal import Signal
    from hertzwerk.runtime.output.tables.history_meanings import Histories


OF_FLOW, OF_LOOP = ("rates", "ends", "holding"), ("begin", "step", "attempt")  # functions beside the module's


class Model(plain.EngineModel):
    """Model of a scene that can be simulated and drawn, as `load` returns it.

    `module` is any target of `load`; `declaration` is its origin, where it is a generated module that has one.
    """

    def __init__(
        self,
        module: Target | SimpleNamespace,
        declaration: plain.Declaration | None = None,
        dependent: tuple[plain.Dependent, ...] = (),
        signals: Mapping[str, Signal] | None = None,
    ) -> None:
        if not isinstance(module, ModuleType | SimpleNamespace):
            loaded = load(module)
            module, declaration = loaded.module, loaded.declaration
        super().__init__(module, declaration, dependent, signals)

    @property
    def histories(self) -> Histories:
        """All histories of a run by name, unit and meaning, shown as a table; readings are derived here."""
        from hertzwerk.runtime.output.tables.history_meanings import entries

        return entries(self)

    def function(self, name: str, method: str = "dop853") -> Any:
        """Return a CasADi function of the module, the right-hand side, or the time loop; raises InputError.

        "rates", "ends", "holding" of (t, y, mode, m, c): dy/dt, all that a step's end has, forces that hold
        "begin", "step", "attempt" of a method in the graph: first state, trial of a step, next state
        others are the module's, which documents their arguments; "contact_<pair>" is a pair's
        """
        if name in OF_FLOW:
            return getattr(flow(self), name)
        if name not in OF_LOOP:
            try:
                return super().function(name)
            except InputError as error:
                (fault,) = error.faults
                more = ", ".join((*OF_FLOW, *OF_LOOP))
                raise InputError(self.name, [replace(fault, expected=f"{fault.expected}, {more}")]) from None
        if method not in IN_GRAPH:
            raise InputError(self.name, [unknown("method", method, IN_GRAPH)])
        made = integrator(self, tuple(table() for table in IN_GRAPH[method]))
        return made.step() if name == "step" else getattr(made, name)

    def _repr_html_(self) -> str:
        from hertzwerk.runtime.output.tables.notebook import of_model

        return of_model(self, self.draw())

    def draw(
        self, *, parameters: Mapping[str, Value] | None = None, initial: Mapping[str, Value] | None = None
    ) -> Figure:
        """Draw the mechanism at its start, clearances enlarged; raises InputError.

        `Solution.draw` shows how it moves.
        """
        from hertzwerk.runtime.output.drawings import picture

        return picture.of_start(self, parameters, initial)


def _type_faults(target: Any, without: Any, laws: Any, coordinates: Any) -> list[Fault]:
    """Return the faults of arguments of a wrong type."""
    faults: list[Fault] = []
    if not isinstance(target, str | Path | ModuleType | plain.EngineModel) and not hasattr(target, "mechanism"):
        expected = "the name of a built-in scene, a Python file, a Scene, a Model or a generated module"
        faults.append(Fault("target", shown(target), expected))
    if not isinstance(without, list | tuple) or not all(isinstance(name, str) for name in without):
        faults.append(Fault("without", shown(without), "a list of names of effects"))
    pairs = () if laws is None else laws.items() if isinstance(laws, Mapping) else ((laws, None),)
    if not all(isinstance(name, str) and isinstance(law, str) for name, law in pairs):
        faults.append(Fault("laws", shown(laws), 'laws by the names of effects, such as {"floor": "flores"}'))
    if not isinstance(coordinates, str | None):
        faults.append(Fault("coordinates", shown(coordinates), '"tree", "absolute" or "auto"'))
    return faults


Target: TypeAlias = "str | Path | Scene | ModuleType | plain.EngineModel"
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
    """Return the model of a scene, of a generated module, or a Model itself.

    A target is the name of a built-in scene, a Python file that defines `scene` or is a generated module, "FILE.py:NAME"
    where a file has several scenes, "package.module:NAME", or the object. A built-in scene without variation, and a
    generated module, never import SymPy. `without` names effects to leave out, `laws` gives an effect another law by
    name, `coordinates` are "tree", "absolute" or "auto" in place of the scene's own. Raises InputError.
    """
    faults = _type_faults(target, without, laws, coordinates)
    if faults:
        raise InputError("load", faults)
    varied = bool(without or laws or coordinates is not None)
    if isinstance(target, plain.EngineModel):
        return _varied(target, without, laws or {}, coordinates) if varied else _public(target)
    if isinstance(target, str) and not varied and target.isidentifier():
        name = f"hertzwerk.generated.{target}"
        if importlib.util.find_spec(name) is not None:
            return Model(importlib.import_module(name), plain.Declaration(target))
    from hertzwerk.runtime.engine.model import build

    laws = {effect: build.located_laws(law, Path.cwd()) for effect, law in (laws or {}).items()}
    how = tuple(without), tuple(laws.items()), coordinates
    if isinstance(target, str) and not build.in_python(target):
        return Model(build.build_built_in(target, without, laws, coordinates), plain.Declaration(target, *how))
    source = build.source_of(target) if isinstance(target, str | Path) else "a scene"
    scene = build.scene_or_module(target) if isinstance(target, str | Path) else target
    if isinstance(scene, ModuleType):
        return load(Model(scene), without=without, laws=laws, coordinates=coordinates)
    return Model(build.build(build.vary(scene, without, laws, coordinates), source), plain.Declaration(scene, *how))


def _varied(
    model: plain.EngineModel, without: Sequence[str], laws: Mapping[str, str], coordinates: str | None
) -> Model:
    """Return the model of a variation of a model's scene, its inputs with their values; raises InputError."""
    of = model.declared_for("without, laws or coordinates")
    gone, changed = (*of.without, *without), {**dict(of.laws), **laws}
    varied = load(of.target, without=gone, laws=changed, coordinates=coordinates or of.coordinates)
    return varied.with_signals({name: signal for name, signal in model.signals.items() if name in varied.inputs})


def _public(model: plain.EngineModel) -> Model:
    """Return a model with histories and pictures, which shares everything that is built."""
    if isinstance(model, Model):
        return model
    public = Model(model.module, model.declaration, model.dependent, model.signals)
    public.known = model.known
    return public
