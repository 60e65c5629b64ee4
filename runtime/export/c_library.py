"""C99 library of a scene: its functions, and a driver that does what the loop of a run does."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault, refuse, unknown
from hertzwerk.runtime.engine.accuracy.error_estimate import LEAST
from hertzwerk.runtime.engine.integration.events.mode_changes import enter
from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
from hertzwerk.runtime.engine.integration.loop.c_compilation import c_text
from hertzwerk.runtime.engine.integration.loop.method_choice import PATIENCE
from hertzwerk.runtime.engine.integration.loop.tally import tally
from hertzwerk.runtime.engine.integration.step import layout
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.signal import WIDTH
from hertzwerk.runtime.engine.run.single_run import CLOSE, LEAST_STEPS
from hertzwerk.runtime.engine.sensitivity.readout import Expressions
from hertzwerk.runtime.engine.solution.outcome import FRICTION_LOCKS, said_of
from hertzwerk.runtime.engine.start.assembly import CLOSED, ITERATIONS, RANK, residuals
from hertzwerk.runtime.export.export_contents import Contents, ExportRequest, Row, contents, name_faults
from hertzwerk.runtime.system.result_folder import new_folder
from hertzwerk.runtime.system.versions import versions

ALL = (
    *("begin", "attempt", "attempt_choosing", "enter", "constants", "start", "scales_of", "joint_scales", "placed"),
    *("loops", "tallied", "tally", "least_margin", "observed"),
)
"""Functions that the driver calls; one that a model has not is left empty."""

TEMPLATES = resources.files(__package__) / "c"
STATUSES = (
    *("FLIGHT", "CONTACT", "RELEASED", "CALM", "SUSPECT", "RUNNING", "FINISHED", "STEP_TOO_SMALL", "NOT_FINITE"),
    *("CONSTRAINT_LOST", "OUTSIDE_LAW_RANGE", "EVENT_LIMIT", "TOO_MANY_STEPS"),
)
IN_STATE = (
    *("t", "y", "mode", "gap", "gap_rate", "force", "pieces", "stop", "h", "status", "pressure", "events", "steps"),
    *("rejected", "retaken", "evaluations"),
)
IN_CONTROLS = ("scale", "speed_limits", "tolerance", "t_end", "h_max", "floor", "max_events", "max_steps")
MAX_STEPS, MAX_EVENTS = 1_000_000, 100_000  # where none is set: a library recognises no stall by its progress
LARGE = 1_500_000  # characters of C from which more than -O1 takes minutes
DEEP = 10.0  # of the scene's length: overlap of surfaces at a start of one's own that is refused


@dataclass(frozen=True)
class Functions:
    """Functions of the driver as C, and the sizes of the work that they need.

    work    by the names of CasADi: arg, res, iw, w
    """

    text: str
    work: Mapping[str, int]
    names: tuple[str, ...]


def functions(model: EngineModel, made: Integrator, outputs: Sequence[str], name: str) -> Functions:
    """Generate the functions of a model's export; raises InputError for an output that none can give."""
    counting, joints = tally(model), model.joints
    engine = made.model  # without what its constraints repeat
    by_name = {
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
        by_name["attempt_choosing"] = made.with_choice().attempt
    if joints is not model:
        by_name["placed"] = model.function("placed")
    if model.module.GIVEN is not None:
        by_name["loops"] = residuals(joints, model)
    if counting.layout.size:
        by_name |= {"tallied": counting.first.function, "tally": counting.add}
    if model.nr > model.k:
        by_name["least_margin"] = _least_margin(engine, made)
    listed = [_named(each, function) for each, function in by_name.items()]
    work = {part: max(getattr(f, f"sz_{part}")() for f in listed) for part in ("arg", "res", "iw", "w")}
    absent = [f"static int {each}({_ARGUMENTS}) {{ {_UNUSED} return 1; }}" for each in ALL if each not in by_name]
    return Functions("\n".join([_alone(c_text(listed, name)), *absent]), work, tuple(by_name))


def observed(model: EngineModel, made: Integrator, outputs: Sequence[str]) -> Any:
    """Build the function (state, controls, p) -> values of histories; raises InputError."""
    arguments, (at, run) = made.layouts.symbols("state controls")
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
    refuse(model.name, faults)
    return ca.Function("observed", [*arguments, p], [ca.cse(ca.vertcat(ca.SX(0, 1), *values))])


def _least_margin(model: EngineModel, made: Integrator) -> Any:
    """Build the function (state, controls) -> least margin of the reactions that loads depend on."""
    arguments, (at, run) = made.layouts.symbols("state controls")
    margins = flow(model).settling.call([at["t"], at["y"], at["mode"], at["m"], run["c"]])[0]  # type: ignore[union-attr]
    return ca.Function("least_margin", arguments, [ca.mmin(margins)])


def _named(name: str, function: Any) -> Any:
    """Return a function under another name."""
    if function.name() == name:
        return function
    arguments = function.mx_in()
    return ca.Function(name, arguments, function.call(arguments, True, False))


_ARGUMENTS = "const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem"
_UNUSED = "(void)arg; (void)res; (void)iw; (void)w; (void)mem;"
_EXPORTED = re.compile(r"^CASADI_SYMBOL_EXPORT ([^\n]*\}\n|.*?^\}\n)", re.MULTILINE | re.DOTALL)
_SPARSITY = re.compile(r"^static const casadi_int (casadi_s\d+)\[\d+\] = .*\n", re.MULTILINE)


def _alone(text: str) -> str:
    """Return what CasADi generated as static functions, without those that describe sizes."""
    text = re.sub(rf"\({re.escape(_ARGUMENTS)}\) ?\{{", f"({_ARGUMENTS}) {{\n  {_UNUSED}", text)

    def static(match: re.Match[str]) -> str:
        return f"static {match[1]}" if match[1].split("{")[0].strip().endswith(f"({_ARGUMENTS})") else ""

    text = _EXPORTED.sub(static, text)
    text = re.sub(r"^(casadi_real|casadi_int|void) (casadi_\w+\()", r"static \1 \2", text, flags=re.MULTILINE)
    text = re.sub(r"^#ifdef __cplusplus\n.*?^#endif\n", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(
        r"^/\* Symbol visibility in DLLs \*/\n#ifndef.*?^#endif\n\n", "", text, flags=re.MULTILINE | re.DOTALL
    )
    return _SPARSITY.sub(lambda match: match[0] if len(re.findall(rf"\b{match[1]}\b", text)) > 2 else "", text)


def write(request: ExportRequest, folder: Path) -> str:
    """Write the library of a scene into a new folder; return its files. Raises InputError."""
    refuse("export", name_faults("scene", request.model.name))
    texts = library(contents(request), request.model.name)

    def fill(place: Path) -> list[str]:
        for name, text in texts.items():
            (place / name).write_text(text, encoding="utf-8")
        return [*texts]

    _, files = new_folder(request.model.name, folder, fill)
    return f"{folder}/ ({', '.join(files)})"


def level(text: str) -> str:
    """Return the compiler's level of optimisation for a C text."""
    return "-O1" if len(text) > LARGE else "-O2"


def library(export: Contents, name: str) -> dict[str, str]:
    """Return the files of a library by name; `name` begins its functions."""
    made = functions(export.model, export.made, [row.name for row in export.outputs], f"{name}_")
    words = {**_words(export, name), "level": level(made.text)}
    constants = _constants(export, made.work)
    driver = template("driver.c", words)
    include = f'#include <math.h>\n#include <string.h>\n\n#include "{name}.h"\n'
    tables = _tables(export, name)
    head = f"/* {name}: written by `hertzwerk export`. Functions that CasADi generated, tables, and a driver. */\n"
    return {
        f"{name}.h": template("library.h", words),
        f"{name}.c": "\n".join([head + include, made.text, constants, tables, driver]),
        "main.c": template("main.c", words),
        "CMakeLists.txt": template("CMakeLists.txt", words),
    }


def template(file: str, words: Mapping[str, str]) -> str:
    """Return a text of the folder `c` with @word@ replaced."""
    text = (TEMPLATES / file).read_text(encoding="utf-8")
    for word, value in words.items():
        text = text.replace(f"@{word}@", value)
    return text


def quoted(text: str) -> str:
    """Return a text as a string of C."""
    return json.dumps(text).replace("??", '?""?')


def number(value: float) -> str:
    """Return a number as C reads the same bits of."""
    if not np.isfinite(value):
        return "HUGE_VAL" if value > 0 else "-HUGE_VAL"
    return repr(float(value))


def _words(export: Contents, name: str) -> dict[str, str]:
    upper = name.upper()
    counts = {
        "PARAMETERS": export.parameters,
        "STARTS": export.starts,
        "STATES": export.states,
        "OUTPUTS": export.outputs,
        "INPUTS": export.inputs,
        "PAIRS": export.pairs,
    }
    outcomes = {
        "STEP_TOO_SMALL": layout.STEP_TOO_SMALL,
        "NOT_FINITE": layout.NOT_FINITE,
        "CONSTRAINT_LOST": layout.CONSTRAINT_LOST,
        "OUTSIDE_LAW_RANGE": layout.OUTSIDE_LAW_RANGE,
        "EVENT_LIMIT": layout.EVENT_LIMIT,
        "TOO_MANY_STEPS": layout.TOO_MANY_STEPS,
        "FRICTION_LOCKS": FRICTION_LOCKS,
    }
    return {
        "n": name,
        "N": upper,
        "name": name,
        "summary": comment(export.model.module.SUMMARY),
        "origin": f" of hertzwerk {versions()['hertzwerk']}",
        "parameter": export.parameters[0].name if export.parameters else "",
        "duration": number(export.seconds),
        "part": f"{export.seconds / 100:.3g}",
        "method": export.method,
        "tolerance": number(export.tolerance),
        "counts": "\n".join(f"    {upper}_{each} = {len(rows)}," for each, rows in counts.items()).rstrip(","),
        "listing": "\n".join(line for each, rows in counts.items() for line in _listed(each.lower(), rows)),
        "texts": "\n".join(
            f"    case {upper}_{each}: return {quoted(said_of(status))};" for each, status in outcomes.items()
        ),
    }


def comment(text: str) -> str:
    """Return a text that may stand in a comment of C."""
    return text.replace("*/", "* /").replace("/*", "/ *").replace("\n", " ")


def _listed(title: str, rows: tuple[Row, ...]) -> list[str]:
    if not rows:
        return [f" * {title}: none"]
    wide = max(len(row.name) for row in rows)
    return [
        f" * {title}",
        *(
            f" *   {i:3d}  {row.name:{wide}}  {row.unit:12}  {row.value!r:<23}  {comment(row.meaning)}".rstrip()
            for i, row in enumerate(rows)
        ),
        " *",
    ]


def _constants(export: Contents, work: Mapping[str, int]) -> str:
    model, layouts = export.model, export.made.layouts
    joints, counting = model.joints, tally(model).layout
    quaternions = len(joints.quaternions)
    rows, unknowns = len(export.loops) + quaternions, max(joints.nq, joints.nu)
    limited = "speed_limits" if model.speed_limited else ""
    floor = list(model.parameters).index("approach_floor") if "approach_floor" in model.parameters else -1
    integers = {
        **{"N_PARAMETERS": len(export.parameters), "N_STARTS": len(export.starts), "N_OUTPUTS": len(export.outputs)},
        **{"N_INPUTS": len(export.inputs), "N_PAIRS": len(export.pairs), "N_PIECES": model.npieces, "WIDTH": WIDTH},
        **{"N_STATE": layouts.state.size, "N_CONTROLS": layouts.controls.size, "N_TALLY": counting.size},
        **{"N_Y": len(export.states), "N_C": model.nc, "N_Q_ALL": model.nq, "N_U_ALL": model.nu},
        **{"N_Q": joints.nq, "N_U": joints.nu, "N_QUATERNIONS": quaternions, "N_LOOPS": len(export.loops)},
        **{"N_CLOSED": joints.nl if export.loops else 0, "N_ROWS": rows, "N_UNKNOWNS": unknowns},
        **{"N_LATCHES": len(model.latches), "N_LIMITS": len(_limits(model))},
        **{"N_SPEED_LIMITS": model.k if limited else 0, "IS_PLACED": int(joints is not model)},
        **{"CAN_ASSEMBLE": int(export.follows), "HAS_MARGINS": int(model.nr > model.k), "FLOOR_PARAMETER": floor},
        **{f"SIZE_{part.upper()}": max(size, 5 if part in ("arg", "res") else 0) for part, size in work.items()},
        **{f"AT_{name.upper()}": layouts.state.places[name] for name in IN_STATE},
        **{f"AT_{name.upper()}": layouts.controls.places[name] for name in IN_CONTROLS},
        **{f"AT_{name.upper()}": counting.places.get(name, -1) for name in ("error", "moved", "size")},
        **{"AT_SCENE": layouts.controls.places["scales"], "ITERATIONS": ITERATIONS, "LEAST_STEPS": LEAST_STEPS},
        **{name: int(getattr(layout, name)) for name in STATUSES},
    }
    numbers = {
        **{"TOLERANCE": export.tolerance, "LEAST_TOLERANCE": LEAST, "MAX_STEPS": MAX_STEPS, "MAX_EVENTS": MAX_EVENTS},
        **{"PATIENCE": PATIENCE, "CLOSE": CLOSE, "CLOSED": CLOSED, "RANK": RANK, "DEEP": DEEP},
        "APPROACH_FLOOR": export.floor,
    }
    lines = ["#define ROOM(n) ((n) > 0 ? (n) : 1) /* C has no array of no length */", "", "enum {"]
    lines += [f"    {name} = {value}," for name, value in integers.items()]
    lines[-1] = lines[-1].rstrip(",")
    lines += ["};", "", *(f"#define {name} {number(value)}" for name, value in numbers.items())]
    return "\n".join(["", *lines])


def _limits(model: EngineModel) -> list[tuple[str, float, float, int]]:
    """Return (parameter, lower, upper, which are open) of the limits within which a model is defined."""
    return [
        (name, -np.inf if low is None else low, np.inf if high is None else high, left + 2 * right)
        for name, kind, low, high, left, right, _ in model.module.LIMITS
        if kind == "defined"
    ]


def _tables(export: Contents, name: str) -> str:
    tables = {
        "parameter_rows": export.parameters,
        "start_rows": export.starts,
        "state_rows": export.states,
        "output_rows": export.outputs,
        "input_rows": export.inputs,
        "pair_rows": export.pairs,
    }
    lines = ["", "typedef struct { const char *name, *unit; double value; const char *meaning; } row;"]
    for table, rows in tables.items():
        cells = [
            f"    {{{quoted(row.name)}, {quoted(row.unit)}, {number(row.value)}, {quoted(row.meaning)}}}"
            for row in rows
        ]
        lines += ["", f"static const row {table}[] = {{", ",\n".join(cells) or "    {0, 0, 0, 0}", "};"]
    listed = ", ".join(f"{{{len(rows)}, {table}}}" for table, rows in tables.items())
    lines += ["", f"static const struct {{ int count; const row *rows; }} tables[] = {{{listed}}};"]
    parameters = [row.name for row in export.parameters]
    limits = [
        f"    {{{parameters.index(limited)}, {number(low)}, {number(high)}, {kind}}}"
        for limited, low, high, kind in _limits(export.model)
    ]
    lines += [
        "",
        "/* is_open: 1 where the lower limit, 2 where the upper one is excluded */",
        "static const struct { int parameter; double lower, upper; int is_open; } limits[] = {",
        ",\n".join(limits) or "    {0, 0, 0, 0}",
        "};",
        _array("double", "fallback_scales", [number(value) for value in export.scales]),
        _array("int", "is_stated", [str(int(value)) for value in export.stated]),
        _array("int", "was_given", [str(int(value)) for value in export.requested]),
        _array("int", "loop_is_length", [str(int(unit != "1")) for unit in export.loops]),
        _array("int", "quaternions", [str(i) for i in export.model.joints.quaternions]),
    ]
    return "\n".join(lines)


def _array(kind: str, name: str, values: list[str]) -> str:
    return f"static const {kind} {name}[] = {{{', '.join(values) or '0'}}};"
