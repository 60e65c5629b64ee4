"""Functions of a model as C99: what CasADi generates, without what a library of its own needs."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.derive.faults import Fault, InputError, unknown
from hertzwerk.runtime.integrate.events.modes import enter
from hertzwerk.runtime.integrate.loop.compiled import c_text
from hertzwerk.runtime.integrate.loop.tally import tally
from hertzwerk.runtime.integrate.step.explicit import flow
from hertzwerk.runtime.integrate.step.layout import CONTACT
from hertzwerk.runtime.sensitivity.readout import Expressions
from hertzwerk.runtime.start.assembly import residuals

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.model import Model

ALL = (
    *("begin", "attempt", "attempt_choosing", "enter", "constants", "start", "scales_of", "joint_scales", "placed"),
    *("loops", "tallied", "tally", "least_margin", "observed"),
)
"""Functions that the driver calls; one that a model has not is left empty."""


@dataclass(frozen=True)
class Functions:
    """Functions of the driver as C, and the sizes of the work that they need.

    work    by the names of CasADi: arg, res, iw, w
    """

    text: str
    work: Mapping[str, int]
    names: tuple[str, ...]


def functions(model: Model, made: Integrator, outputs: Sequence[str], name: str) -> Functions:
    """Generate the functions of a model's export; raises InputError for an output that none can give."""
    counting, joints = tally(model), model.joints
    engine = made.model  # without what its constraints repeat
    found = {
        "begin": made.begin,
        "attempt": made.attempt,
        "enter": made.enter or enter(engine, made.layouts, flow(engine)),
        "constants": model.function("constants"),
        "start": joints.function("start"),
        "scales_of": model.function("scales"),
        "joint_scales": joints.function("scales"),
        "observed": observed(model, made, outputs),
    }
    if made.with_choice is not None:
        found["attempt_choosing"] = made.with_choice().attempt
    if joints is not model:
        found["placed"] = model.function("placed")
    if hasattr(model.module, "GIVEN"):
        found["loops"] = residuals(joints, model)
    if counting.layout.size:
        found |= {"tallied": counting.first.function, "tally": counting.add}
    if model.nr > model.k:
        found["least_margin"] = _least_margin(engine, made)
    listed = [_named(each, function) for each, function in found.items()]
    work = {part: max(getattr(f, f"sz_{part}")() for f in listed) for part in ("arg", "res", "iw", "w")}
    absent = [f"static int {each}({_ARGUMENTS}) {{ {_UNUSED} return 1; }}" for each in ALL if each not in found]
    return Functions("\n".join([_alone(c_text(listed, name)), *absent]), work, tuple(found))


def observed(model: Model, made: Integrator, outputs: Sequence[str]) -> Any:
    """Build the function (state, controls, p) -> values of histories; raises InputError."""
    given, (at, run) = made.layouts.symbols("state controls")
    (p,) = model.symbols("p")
    expressions = Expressions(model, [at["t"], at["y"], at["mode"], at["m"], run["c"], p])
    if not model.inputs:  # as the last step left them; inputs may have changed since
        expressions.ends |= {part: at[part] for part in expressions.ends if part in at}
    values, faults = [], []
    for name in outputs:
        pair, _, part = name.rpartition(".")
        try:
            value = at["mode"][model.pairs.index(pair)] if part == "mode" else ca.SX(expressions[name])
        except KeyError:
            faults.append(unknown("output", name, ()))
            continue
        if name in (f"{each}.sliding_velocity" for each in model.pairs) and value.numel() > 1:
            square = ca.sumsqr(value)
            value = ca.sqrt(ca.if_else(at["mode"][model.pairs.index(pair)] == CONTACT, square, 0))
        if value.numel() == 1:
            values.append(ca.densify(value))
        else:
            faults.append(Fault(f"output {name}", f"{value.numel()} values", "one", "name its parts"))
    if faults:
        raise InputError(model.name, faults)
    return ca.Function("observed", [*given, p], [ca.cse(ca.vertcat(ca.SX(0, 1), *values))])


def _least_margin(model: Model, made: Integrator) -> Any:
    """Build the function (state, controls) -> least margin of the reactions that loads depend on."""
    given, (at, run) = made.layouts.symbols("state controls")
    margins = flow(model).settling.call([at["t"], at["y"], at["mode"], at["m"], run["c"]])[0]  # type: ignore[union-attr]
    return ca.Function("least_margin", given, [ca.mmin(margins)])


def _named(name: str, function: Any) -> Any:
    """Return a function under another name."""
    if function.name() == name:
        return function
    given = function.mx_in()
    return ca.Function(name, given, function.call(given, True, False))


_ARGUMENTS = "const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem"
_UNUSED = "(void)arg; (void)res; (void)iw; (void)w; (void)mem;"
_EXPORTED = re.compile(r"^CASADI_SYMBOL_EXPORT ([^\n]*\}\n|.*?^\}\n)", re.MULTILINE | re.DOTALL)
_SPARSITY = re.compile(r"^static const casadi_int (casadi_s\d+)\[\d+\] = .*\n", re.MULTILINE)


def _alone(text: str) -> str:
    """Return what CasADi generated as static functions, without those that tell of sizes."""
    text = re.sub(rf"\({re.escape(_ARGUMENTS)}\) ?\{{", f"({_ARGUMENTS}) {{\n  {_UNUSED}", text)

    def kept(found: re.Match[str]) -> str:
        return f"static {found[1]}" if found[1].split("{")[0].strip().endswith(f"({_ARGUMENTS})") else ""

    text = _EXPORTED.sub(kept, text)
    text = re.sub(r"^(casadi_real|casadi_int|void) (casadi_\w+\()", r"static \1 \2", text, flags=re.MULTILINE)
    text = re.sub(r"^#ifdef __cplusplus\n.*?^#endif\n", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(
        r"^/\* Symbol visibility in DLLs \*/\n#ifndef.*?^#endif\n\n", "", text, flags=re.MULTILINE | re.DOTALL
    )
    return _SPARSITY.sub(lambda found: found[0] if len(re.findall(rf"\b{found[1]}\b", text)) > 2 else "", text)
