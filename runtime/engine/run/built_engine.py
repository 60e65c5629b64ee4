"""Engine: the functions that run one model by one method, built once and compiled on request."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator, integrator
from hertzwerk.runtime.engine.integration.loop.automatic_compilation import (
    AutomaticCallers,
    Code,
    compiled_together,
    use_compiled,
)
from hertzwerk.runtime.engine.integration.loop.chunk import Ending, march
from hertzwerk.runtime.engine.integration.loop.near_list import listing
from hertzwerk.runtime.engine.integration.loop.reduced_runs import ReducingCallers, code_of, reduction
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS, SUNDIALS
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.run.run_request import Compiled
from hertzwerk.runtime.engine.solution.step_observers import Needs, finders
from hertzwerk.runtime.engine.start.start_values import dependent, read_start

COUNTERS = ("steps", "rejected", "retaken", "evaluations", "events", "floored", "unsettled")  # parts of a state


@dataclass(frozen=True)
class Engine:
    """Functions of one model and method: chunks, or a loop of its own (SUNDIALS).

    counters    rows of the state
    code        of the chunk
    march       ([gear, integrator where there is code,] state, controls, keep, *, deadline, progress)
    reduced     pairs -> code of the reduced model that has them; None for a model that is not reduced
    """

    integrator: Integrator
    begin: Callers
    counters: Mapping[str, int]
    code: Code | None
    march: Callable[..., Ending]
    reduced: Callable[[tuple[int, ...]], Code] | None = None


def engine_for(
    model: EngineModel, method: str, compiled: Compiled, poll: Callable[[], object] = lambda: None
) -> Engine:
    """Return the engine of a model and method, compiled if requested.

    poll: called meanwhile. Raises InputError without a compiler, and what `poll` raises.
    """
    engine = _engine(model, method)
    if compiled is True and engine.code is not None and (engine.reduced or engine.code.native is None):
        from hertzwerk.runtime.engine.integration.loop.c_compilation import NoCompilerError, require_compiler

        try:
            require_compiler() if engine.reduced else engine.code.compile(poll)
        except NoCompilerError as error:
            way_out = "compiled=False runs the same functions, slower"
            raise InputError(model.name, [Fault("compiled", str(error), "a working C compiler", way_out)]) from error
    return engine


@per_model
def _engine(model: EngineModel, method: str) -> Engine:
    tables = tuple(table() for table in METHODS[method])
    near = listing(model, tables)
    made = integrator(model, tables) if near is None else integrator(near, tables[:1])
    rows = made.layouts.state
    counters = {name: rows[name].start for name in COUNTERS}
    if method in SUNDIALS:  # never in the graph
        from hertzwerk.runtime.engine.integration import sundials

        reference = sundials.reference(model, made.layouts, method)
        return Engine(made, Callers(made.begin), counters, None, partial(sundials.march, reference))
    return Engine(made, Callers(made.begin), counters, code_of(made, method), march, reduction(model, method))


def provider_of(engine: Engine, model: EngineModel, compiled: Compiled) -> AutomaticCallers | None:
    """Return the callers of an engine's chunks; None where it has a loop of its own."""
    options = {"compiled": compiled is True, "changes": compiled == "auto"}
    if engine.code is None or engine.reduced is None:
        return None if engine.code is None else AutomaticCallers(engine.code, **options)
    return ReducingCallers(model, engine.code, engine.reduced, **options)


def compile_together(models: Iterable[tuple[EngineModel, str]]) -> None:
    """Compile what runs of models by methods have built as one program, in which methods share functions.

    A model is without redundant constraints, as the one of `History.engine`. What fails to compile stays as it is.
    """
    engines = (_engine(model, method) for model, method in models)
    codes = [
        code for engine in engines if engine.code is not None and engine.reduced is None for code in engine.code.built
    ]
    for code, native in zip(codes, compiled_together([code.function for code in codes]), strict=False):
        code.native = code.callers(native)


def prepare(
    model: EngineModel,
    method: str,
    compiled: Compiled,
    ahead: float = 0.0,
    needs: Needs = Needs.ENDS,
    *,
    compared: bool = False,
) -> bool:
    """Build what runs of a model need before they are made side by side; return whether to compile.

    As `compiled` says, or with "auto" if it saves time for runs that take `ahead` [s] uncompiled. What finds what is
    needed of the runs is compiled as well, and what compares them for an accuracy. Raises InputError without a compiler.
    """
    bound, _ = model.check({})
    q, _ = read_start(model, bound, {}, [])
    typical = model if bound is None else model.without_redundancy(dependent(model, bound, q))
    engine = engine_for(typical, method, compiled)
    code = engine.code
    if (
        code is None
        or engine.reduced is not None
        or not (code.compiled_if_faster(math.inf, ahead) if compiled == "auto" else compiled)
    ):
        return False
    use_compiled(finders(model, engine.integrator, needs, compared=compared))
    return True
