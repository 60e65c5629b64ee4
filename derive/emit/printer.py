"""A program as the text of a generated module: plain Python over CasADi, the same text for every hash seed.

SymPy is left here, through one rule per node type; a node without a rule is an error. Powers are strength-reduced
(`d**(3/2)` -> `d*sqrt(d)`), names are those of the derivation.
"""

from __future__ import annotations

import json
import operator
import re
import textwrap
from collections.abc import Callable
from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.splines import Spline
from hertzwerk.derive.audit.audit import checked
from hertzwerk.derive.faults import visible
from hertzwerk.derive.mechanism.parameter import TABLE
from hertzwerk.derive.program.program import Function, Program, Result, shared

_WIDTH = 116  # columns of the text
FLIGHT = ("applied", "accelerations", "gaps", "gap_accelerations")  # what a right-hand side costs where nothing touches
STAGES = 12  # of the default method
PER_STEP = {  # calls of a step: by its stages; for events; to close loops, with two corrections of the place and one of the speeds
    **dict.fromkeys(("coordinate_rates", "applied", "accelerations", "ledger"), STAGES),
    **dict.fromkeys(("gaps", "gap_accelerations"), 1),
    **{"constraints": 4, "projection": 3},
}
_SUM, _PRODUCT, _UNARY, _POWER, _ATOM = range(1, 6)


class EmitError(TypeError):
    """A SymPy node the emitter has no rule for."""


# -- expressions -------------------------------------------------------------------------------------------------------


def expression_text(expression: Any) -> str:
    """Python text of a SymPy expression, over CasADi. Raises EmitError for a node without a rule."""
    return _text(sp.sympify(expression))[0]


def _text(node: Any) -> tuple[str, int]:
    rule = _RULES.get(type(node)) or next((_RULES[kind] for kind in type(node).__mro__ if kind in _RULES), None)
    if rule is None:
        raise EmitError(f"no rule to emit {type(node).__name__}: {node}")
    return rule(node)


def _wrapped(node: Any, least: int) -> str:
    text, strength = _text(node)
    return text if strength >= least else f"({text})"


def _number(node: Any) -> tuple[str, int]:
    if not node.is_finite:
        raise EmitError(f"no rule to emit {node}: it is no finite number")
    if node.is_Rational and not node.is_Integer:
        text = f"{abs(node.p)}/{node.q}"
        return (f"-{text}", _SUM) if node.p < 0 else (text, _PRODUCT)
    text = repr(float(node)) if node.is_Float or node.is_NumberSymbol else str(int(node))
    return text, (_SUM if text.startswith("-") else _ATOM)


def _sum(node: Any) -> tuple[str, int]:
    # Positive terms first, so that a sum does not begin with a sign.
    terms = sorted(((_is_negative(term), term) for term in node.args), key=operator.itemgetter(0))
    text = _wrapped(terms[0][1], _SUM)
    for negative, term in terms[1:]:
        text += f" - {_wrapped(-term, _PRODUCT)}" if negative else f" + {_wrapped(term, _SUM)}"
    return text, _SUM


def _is_negative(node: Any) -> bool:
    """Whether it is written with a sign in front; of a product SymPy would make the opposite to find out."""
    if node.is_Mul:
        return bool(node.args[0].is_Number and node.args[0].is_extended_negative)
    return not node.is_Symbol and bool(node.could_extract_minus_sign())


def _product(node: Any) -> tuple[str, int]:
    if _is_negative(node):
        return f"-{_wrapped(-node, _PRODUCT)}", _SUM
    above: list[Any] = []
    below: list[Any] = []
    for factor in node.args:
        if factor.is_Pow and factor.exp.is_number and factor.exp.is_negative:
            below.append(sp.Pow(factor.base, -factor.exp, evaluate=False) if factor.exp != -1 else factor.base)
        elif factor.is_Rational and factor.q != 1:
            above.extend([sp.Integer(factor.p)] if factor.p != 1 else [])
            below.append(sp.Integer(factor.q))
        else:
            above.append(factor)
    text = "*".join(_wrapped(factor, _PRODUCT) for factor in above) or "1"
    if below:
        quotient = "*".join(_wrapped(factor, _UNARY if len(below) == 1 else _PRODUCT) for factor in below)
        text += (
            f"/({quotient})" if len(below) > 1 or ("*" in quotient and not quotient.endswith(")")) else f"/{quotient}"
        )
    return text, _PRODUCT


def _power(node: Any) -> tuple[str, int]:
    base, exponent = node.base, node.exp
    if exponent.is_Rational and exponent.is_negative:
        return f"1/{_wrapped(sp.Pow(base, -exponent, evaluate=False) if exponent != -1 else base, _UNARY)}", _PRODUCT
    if exponent.is_Rational and exponent.q == 2:
        root, whole = f"ca.sqrt({_text(base)[0]})", exponent.p // 2
        if whole == 0:
            return root, _ATOM
        return f"{_whole_power(base, whole)[0]}*{root}", _PRODUCT
    if exponent.is_Integer:
        return _whole_power(base, int(exponent))
    return f"{_wrapped(base, _ATOM)}**{_wrapped(exponent, _ATOM)}", _POWER


def _whole_power(base: Any, exponent: int) -> tuple[str, int]:
    text = _wrapped(base, _ATOM)
    if exponent <= 3 and base.is_Symbol:
        return "*".join([text] * exponent), (_ATOM if exponent == 1 else _PRODUCT)
    return f"{text}**{exponent}", _POWER


def _call(name: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        return f"{name}({', '.join(_text(arg)[0] for arg in node.args)})", _ATOM

    return rule


def _nested(name: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        text = _text(node.args[-1])[0]
        for arg in reversed(node.args[:-1]):
            text = f"{name}({_text(arg)[0]}, {text})"
        return text, _ATOM

    return rule


def _relation(sign: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        return f"{_wrapped(node.lhs, _SUM)} {sign} {_wrapped(node.rhs, _SUM)}", 0

    return rule


def _lambert_w(node: Any) -> tuple[str, int]:
    if len(node.args) != 2 or node.args[1] != -1:
        raise EmitError(f"no rule to emit the branch of {node}; the lower one is LambertW(x, -1)")
    return f"_lambert_w_lower({_text(node.args[0])[0]})", _ATOM


def _spline(node: Any) -> tuple[str, int]:
    table, argument, order = node.args
    return f"_spline({table_name(table)}, {_text(argument)[0]})[{order}]", _ATOM


def table_name(table: Any) -> str:
    """Name of a table's polynomials in the module."""
    return f"{table.name.upper()}{TABLE}"


_RULES: dict[type, Callable[[Any], tuple[str, int]]] = {
    sp.Symbol: lambda node: (node.name, _ATOM),
    sp.Number: _number,
    sp.NumberSymbol: _number,
    sp.Add: _sum,
    sp.Mul: _product,
    sp.Pow: _power,
    sp.Abs: _call("ca.fabs"),
    sp.sign: _call("ca.sign"),
    sp.sin: _call("ca.sin"),
    sp.cos: _call("ca.cos"),
    sp.tan: _call("ca.tan"),
    sp.asin: _call("ca.asin"),
    sp.acos: _call("ca.acos"),
    sp.atan: _call("ca.atan"),
    sp.atan2: _call("ca.atan2"),
    sp.sinh: _call("ca.sinh"),
    sp.cosh: _call("ca.cosh"),
    sp.tanh: _call("ca.tanh"),
    sp.exp: _call("ca.exp"),
    sp.log: _call("ca.log"),
    sp.Min: _nested("ca.fmin"),
    sp.Max: _nested("ca.fmax"),
    Where: _call("ca.if_else"),
    Spline: _spline,
    sp.LambertW: _lambert_w,
    sp.gamma: _call("_gamma"),
    sp.StrictGreaterThan: _relation(">"),
    sp.StrictLessThan: _relation("<"),
    sp.GreaterThan: _relation(">="),
    sp.LessThan: _relation("<="),
}


# -- functions ---------------------------------------------------------------------------------------------------------

_HELPERS = {
    "_lambert_w_lower": '''def _lambert_w_lower(x):
    """Lower branch of Lambert's W on [-1/e, 0): series at the branch point or at 0, then three steps of 4th order; -1 below.

    Corless, Gonnet, Hare, Jeffrey, Knuth, Adv. Comput. Math. 5 (1996) 329, eqs. 4.19, 4.22; Fritsch, Shafer, Crowley, CACM 16 (1973) 123.
    """
    x = ca.fmax(x, -0.36787944117144233)
    root = ca.sqrt(ca.fmax(2*(1 + 2.718281828459045*x), 0))
    near = -1 - root*(1 + root*(1/3 + root*(11/72 + root*43/540)))
    first = ca.log(-x)
    second = ca.log(-first)
    w = ca.fmin(ca.if_else(x < -0.2, near, first - second + second/first), -1 - 1e-9)
    for _ in range(3):
        z = ca.log(x/w) - w
        y = 1 + w
        q = 2*y*(y + 2*z/3)
        w = ca.fmin(w*(1 + z/y*(q - z)/(q - 2*z)), -1 - 1e-9)
    return w''',
    "_gamma": '''def _gamma(x):
    """Gamma function for x > 0, to about 1e-15: Lanczos's approximation with nine terms.

    Lanczos, J. SIAM Numer. Anal. Ser. B 1 (1964) 86; coefficients by Godfrey (2001).
    """
    series = 0.9999999999998099 + 676.5203681218851/x - 1259.1392167224028/(x + 1) + 771.3234287776531/(x + 2)
    series = series - 176.6150291621406/(x + 3) + 12.507343278686905/(x + 4) - 0.13857109526572012/(x + 5)
    series = series + 9.984369578019572e-6/(x + 6) + 1.5056327351493116e-7/(x + 7)
    return 2.5066282746310002*(x + 6.5)**(x - 0.5)*ca.exp(-x - 6.5)*series''',
    "_spline": '''def _spline(rows, x):
    """Value, slope and curvature of piecewise polynomials, rows (x, c0, ..., c5), at x; beyond their ends, of the tangent there.

    A function of its own, one per table, which is called: it looks its interval up, and an unrolled expression could not.
    """
    if rows not in _SPLINES:
        at = ca.MX.sym("at")
        knots, polynomials = ca.DM([row[0] for row in rows]), ca.DM([row[1:] for row in rows])
        inside = ca.fmin(ca.fmax(at, knots[0]), knots[-1])
        interval = ca.low(knots, inside, {"lookup_mode": "binary"})
        s = inside - ca.MX(knots)[interval]
        c = ca.horzsplit(ca.MX(polynomials)[interval, :])
        slope = c[1] + s*(2*c[2] + s*(3*c[3] + s*(4*c[4] + s*5*c[5])))
        value = c[0] + s*(c[1] + s*(c[2] + s*(c[3] + s*(c[4] + s*c[5])))) + slope*(at - inside)
        curvature = 2*c[2] + s*(6*c[3] + s*(12*c[4] + s*20*c[5]))
        results = [ca.vertcat(value, slope, curvature)]
        _SPLINES[rows] = ca.Function("spline", [at], results, {"never_inline": True})
    return _SPLINES[rows](x)


_SPLINES = {}''',
}

_ARGUMENTS = {
    "t": "t [s]",
    "p": "p: PARAMETERS, in SI",
    "q": "q: COORDINATES",
    "u": "u: SPEEDS",
    "a": "a: rates of the speeds",
    "z": "z: MEMORY",
    "m": "m: LATCHES",
    "c": "c: CONSTANTS",
    "f": "f: generalised forces",
    "reactions": "reactions of the drives",
    "wanted": "wanted: rates of CONSTRAINTS",
    "multipliers": "multipliers: forces that hold CONSTRAINTS",
    "joints": "joints: JOINT_COORDINATES",
    "joint_speeds": "joint_speeds: JOINT_SPEEDS",
}


def function_text(program: Program, function: Function) -> str:
    """Text of one builder."""
    unpacked = _unpacked(program, function)
    function = shared(function)
    lines = [f"def {function.name}({', '.join(function.arguments)}):", *_docstring(function)]
    lines += [f"    {line}" for line in unpacked]
    lines += [f"    {symbol.name} = {expression_text(expression)}" for symbol, expression in function.body]
    return "\n".join([*lines, *_return(function)])


def _return(function: Function) -> list[str]:
    """The return statement; where it is long one result, and where that is long some entries, per line."""
    columns = [_column(result) for result in function.results]
    line = f"    return {', '.join(columns)}"
    if len(line) <= _WIDTH:
        return [line]
    if len(columns) == 1:
        return _wrapped_lines(columns[0], "    return ", " " * 8)
    lines = [line for column in columns for line in _wrapped_lines(f"{column},", " " * 8, " " * 12)]
    return ["    return (", *lines, "    )"]


def _wrapped_lines(code: str, first: str, then: str) -> list[str]:
    """Code over CasADi's brackets, broken at blanks where it is too long, however long its names are."""
    return textwrap.wrap(
        code,
        _WIDTH,
        initial_indent=first,
        subsequent_indent=then,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _docstring(function: Function) -> list[str]:
    arguments = "; ".join(_ARGUMENTS[name] for name in function.arguments)
    lines = _prose_lines(function.summary, '    """', " " * 4)
    lines += ["", f"    Arguments: {arguments}.", "    Returns, each a column vector:"]
    for result in function.results:
        entries = ", ".join(
            f"{label} [{unit}]" if unit else label for label, unit in zip(result.labels, result.units, strict=True)
        )
        entry = f"{result.name} ({len(result.labels)},): {entries or 'empty'}"
        lines += _prose_lines(entry, " " * 8, " " * 12)
    return [*lines, '    """']


def _prose_lines(text: str, first: str, then: str) -> list[str]:
    """Text wrapped for a docstring, then made safe: the other way round a break could tear an escape apart."""
    lines = textwrap.wrap(text, _WIDTH, initial_indent=" " * len(first), subsequent_indent=then)
    return [indent + _prose(line) for indent, line in zip((first, *[then] * len(lines)), lines, strict=False)]


def _unpacked(program: Program, function: Function) -> list[str]:
    """One line per entry the function reads."""
    positions: dict[Any, str] = {}
    if "c" in function.arguments:
        positions.update((symbol, f"c[{k}]") for k, symbol in enumerate(program.constants))
    else:
        parameters = [symbol for symbol, group in program.tape.inputs.items() if group == "p"]
        positions.update((symbol, f"p[{k}]") for k, symbol in enumerate(parameters))
    count: dict[str, int] = {}
    for symbol, group in program.tape.inputs.items():
        if group not in ("p", "t", "c"):
            positions[symbol] = f"{group}[{count.get(group, 0)}]"
            count[group] = count.get(group, 0) + 1
    wanted = set(function.reads)
    return [f"{symbol.name} = {place}" for symbol, place in positions.items() if symbol in wanted]


def _column(result: Result) -> str:
    return f"ca.vertcat({', '.join(expression_text(expression) for expression in result.expressions)})"


# A sign stands close to what it is of, which is no number here; minus has blanks around it.
_SIGN = re.compile(r"-(?=[A-Za-z_(]|[\d.]+\*\*)")
_CALL = re.compile(r"\w\(")


def operations(text: str) -> int:
    """Arithmetic operations and function calls in the text of a builder; packing and unpacking cost nothing, nor does the sign of a number.

    Counted in the text as it is written here: to have Python parse it takes longer than to write it.
    """
    code = " ".join("".join(text.split('"""')[::2]).split())
    if code.startswith("def "):
        code = code.partition(":")[2]
    spaced = sum(code.count(f" {sign} ") for sign in ("+", "-", "<", ">", "<=", ">="))
    products = code.count("*") - code.count("**") + code.count("/")
    calls = len(_CALL.findall(code)) - code.count("ca.vertcat(")
    helpers = sum(code.count(f"{name}(") * (_helper_operations(name) - 1) for name in _HELPERS if f"{name}(" in code)
    return spaced + products + len(_SIGN.findall(code)) + calls + helpers


def of_a_step(program: Program) -> int:
    """Operations of one step of a run, as `auto` compares coordinates by: see PER_STEP; and the force of one pair in half of the stages.

    With one pair in contact for half of a run: impacts are short, but steps in them are too, and seldom do two pairs touch at a time.
    """
    counts = {function.name: operations(function_text(program, function)) for function in program.functions}
    contacts = [count for name, count in counts.items() if name.startswith("contact_")]
    touching = STAGES // 2 * sum(contacts) // max(len(contacts), 1)
    return touching + sum(times * counts.get(name, 0) for name, times in PER_STEP.items())


def _helper_operations(name: str) -> int:
    """Of a helper, the three steps of a loop counted."""
    text = _HELPERS[name]
    if "    for _" not in text:
        return operations(text)
    loop = text.index("    for _")
    body = "\n".join(line[4:] for line in text[loop:].splitlines()[1:-1])
    return operations("\n".join(text[:loop].splitlines()[:-1])) + 3 * operations(textwrap.dedent(body))


# -- module ------------------------------------------------------------------------------------------------------------


def emit(program: Program, source: str) -> str:
    """Text of the generated module of a program that has passed the audit; `source` names the scene's file."""
    scene = program.scene
    functions = {function.name: function_text(program, function) for function in program.functions}
    counts = {name: operations(text) for name, text in functions.items()}
    tables = dict(program.tables)
    tables["CONSTANTS"] = tuple((symbol.name, program.units[symbol]) for symbol in program.constants)
    tables["OPERATIONS"] = tuple(counts.items())
    parts = [
        _header(program, source, counts),
        "import casadi as ca",
        "\n".join(f"{name} = {_literal(text)}" for name, text in
                  (("NAME", scene.name), ("SOURCE", source), ("SUMMARY", scene.summary))),
        *(_table(name, rows) for name, rows in tables.items()),
    ]  # fmt: skip
    texts = list(functions.values())
    helpers = [text for name, text in _HELPERS.items() if any(f"{name}(" in other for other in texts)]
    return "\n\n".join(parts) + "\n\n\n" + "\n\n\n".join((*helpers, *texts)) + "\n"


def _header(program: Program, source: str, counts: dict[str, int]) -> str:
    scene = program.scene
    assignments, outputs = checked(program)
    contacts = ", ".join(f"{name} {count}" for name, count in counts.items() if name.startswith("contact_"))
    unchecked = [effect for effect, _ in program.tables["UNCHECKED"]]
    verdict = (
        f"UNCHECKED, INCONSISTENT LAWS RUN ON PURPOSE IN SI VALUES: {', '.join(unchecked)}"
        if unchecked
        else f"{assignments} assignments and {outputs} outputs checked, all consistent"
    )
    name = scene.name if source.startswith("derive/") else source or "FILE"
    contact = f"; in contact also {contacts}" if contacts else ""
    return "\n".join(
        (
            f'"""{scene.name}: {_prose(scene.summary)}. Generated from {_prose(source) or "a scene"}.',
            "",
            f"Do not edit; regenerate with `hertzwerk derive {_prose(name)}`.",
            "Effects:",
            *(f"    {effect.name}: {_prose(effect.text)}" for effect in scene.effects),
            f"Units: {verdict}",
            *([f"Coordinates: {_prose(program.note)}"] if program.note else []),
            f"Operations: flight {sum(counts[name] for name in FLIGHT)} (equations of motion and gaps){contact}",
            '"""',
        )
    )


def _table(name: str, rows: tuple[Any, ...]) -> str:
    if not rows:
        return f"{name} = ()"
    return "\n".join([f"{name} = (", *(f"    {_literal(row)}," for row in rows), ")"])


def _literal(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({', '.join(map(_literal, value))}{',' if len(value) == 1 else ''})"
    if isinstance(value, str):
        return visible(json.dumps(value, ensure_ascii=False))  # whose escapes are Python's
    return repr(float(value)) if isinstance(value, float) else repr(value)  # a NumPy float prints otherwise


def _prose(text: str) -> str:
    """Text of a scene on one line, made safe for a docstring: nothing in it ends the string or is an escape."""
    return visible(" ".join(text.split())).replace("\\", "\\\\").replace('"', "'")


__all__ = ["FLIGHT", "EmitError", "emit", "expression_text", "function_text", "of_a_step", "operations"]
