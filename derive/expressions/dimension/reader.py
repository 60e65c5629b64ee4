"""Reader of expression text: Python syntax parsed into a small tree through a whitelist.

`read("K*d**n")` parses with Python's own grammar (`ast`), keeps known nodes and refuses everything else with
`TextError`: the position, what was found, what was expected, the remedy. Length, nesting and powers are bounded, and
so is every number: one beyond the range of a double (`9**9**9`, `1/0`, `sqrt(-1)`) is refused, which bounds time and
memory of later operations on the tree.

The tree keeps operations (`d**1`, `m - m + s`, the literal 0) and positions as written, so that an audit quotes the
text itself.
"""

from __future__ import annotations

import ast
import difflib
import keyword
import math
import operator
import re
import unicodedata
import warnings
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from mpmath import lambertw  # SymPy brings it

from hertzwerk.derive.expressions.dimension.expression import Expression, TextError
from hertzwerk.derive.expressions.dimension.tree import Node

MAX_TEXT = 2000  # characters
MAX_DEPTH = 40  # nested operations; the terms of a sum and the factors of a product count once
MAX_POWER = 100  # size of an exponent that is a number; of exponents of exponents, their product
MAX_ARGUMENTS = 8  # of min and max
MAX_BRANCHES = 32  # arguments of all min and max in an expression: SymPy compares each with each
MAX_ORDER = 4  # of a derivative
MAX_SIDE = 12  # rows or columns of a matrix


# name -> (fewest, most arguments)
FUNCTIONS: dict[str, tuple[int, int]] = {
    **dict.fromkeys(("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan"), (1, 1)),
    **dict.fromkeys(("sinh", "cosh", "tanh", "abs", "sign", "gamma"), (1, 1)),
    "LambertW": (1, 2),
    **dict.fromkeys(("min", "max"), (2, MAX_ARGUMENTS)),
    "atan2": (2, 2),
    "where": (3, 3),
    "diff": (2, 2 + 2 * MAX_ORDER),
    "integrate": (2, 4),
    **dict.fromkeys(("transpose", "inv", "det", "trace"), (1, 1)),
}
MATRIX_FUNCTIONS = ("transpose", "inv", "det", "trace")
NAMES_TOO = ("gamma", "LambertW")
"""Functions whose names may be those of quantities as well: before a parenthesis they are the function."""
RESERVED = ("pi", "inf", *(name for name in FUNCTIONS if name not in NAMES_TOO))
"""Words that stand for themselves and name no quantity."""

_ALIASES = {
    "ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2", "tg": "tan", "fabs": "abs", "sgn": "sign",
    "derivative": "diff", "integral": "integrate", "inverse": "inv", "determinant": "det", "lambert_w": "LambertW", "lambert": "LambertW",
    "tgamma": "gamma", "if_else": "where", "fmax": "max", "fmin": "min", "absolute": "abs",
}  # fmt: skip
_SIGNS: dict[type, str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
}  # fmt: skip
_COMPARE: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq, "!=": operator.ne,
}  # fmt: skip
_SYNTAX = "numbers, names, + - * / **, comparisons, ( ), [ ] and the functions"
_NUMERAL = re.compile(r"(?:[0-9][0-9_]*\.?[0-9_]*|\.[0-9][0-9_]*)(?:[eE][-+]?[0-9_]+)?")


def read(text: str) -> Expression:
    """Parse the text of an expression to its tree. Raises TextError."""
    if not isinstance(text, str):
        raise TextError(repr(text)[:60], 0, f"a {type(text).__name__}", "text such as 'K*d**n'")
    source = re.sub(r"[\n\r]", " ", text.strip())
    if not source:
        raise TextError(text[:60], 0, "no expression", "one such as K*d**n")
    if len(source) > MAX_TEXT:
        raise TextError(source, MAX_TEXT, f"{len(source)} characters", f"at most {MAX_TEXT}")
    for sign, remedy in (("#", "leave comments out"), ("\\", "leave it out"), ("^", "a power is written d**n")):
        if sign in source:
            raise TextError(source, source.index(sign), repr(sign), _SYNTAX, remedy)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Python's advice on odd literals, such as 1if
            tree = ast.parse(source, mode="eval")
    except SyntaxError as error:
        raise _syntax_error(source, error) from None
    except (ValueError, MemoryError, RecursionError) as error:
        actual = "nesting that Python cannot parse" if isinstance(error, (MemoryError, RecursionError)) else str(error)
        raise TextError(source, 0, actual, _SYNTAX) from None
    root = _Reader(source).node(tree.body)
    return Expression(source, root)


def _syntax_error(source: str, error: SyntaxError) -> TextError:
    start = min(error.offset - 1, len(source)) if error.offset else len(source)  # 0: at the end
    match = re.match(r"\w+|\S", source[start:])
    word = next((w for w in re.findall(r"[^\W\d]\w*", source) if keyword.iskeyword(w) and w not in _WORDS), None)
    remedy = f"{word!r} is a word of Python: choose another name" if word else f"Python says: {error.msg}"
    return TextError(source, start, repr(match[0]) if match else "the end", _SYNTAX, remedy)


_WORDS = ("and", "or", "not", "if", "else", "is", "in", "True", "False", "None")


class _Reader:
    """Converter of Python's tree to ours: one method per kind of node; refuses all others."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.encoded = source.encode("utf-8", "surrogatepass")  # Python counts bytes
        self.depth = 0

    # -- places and refusals ------------------------------------------------------------------------------------------

    def place(self, node: ast.expr) -> tuple[int, int]:
        start, end = node.col_offset, node.end_col_offset or node.col_offset
        if self.source.isascii():
            return start, end
        return len(self.encoded[:start].decode("utf-8", "replace")), len(self.encoded[:end].decode("utf-8", "replace"))

    def refuse(self, node: ast.expr | Node, expected: str, remedy: str = "", found: str = "") -> TextError:
        start, end = (node.start, node.end) if isinstance(node, Node) else self.place(node)
        written = self.source[start:end]
        shown = written if len(written) <= 40 else written[:37] + "..."
        return TextError(self.source, start, found or repr(shown), expected, remedy)

    # -- nodes --------------------------------------------------------------------------------------------------------

    def node(self, node: ast.expr) -> Node:
        """Convert a node; its value is bounded."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.refuse(node, f"at most {MAX_DEPTH}", found=f"more than {MAX_DEPTH} nested operations")
        method = getattr(self, f"read_{type(node).__name__}", None)
        if method is None:
            actual, remedy = _REFUSED.get(type(node), (f"Python's {type(node).__name__}", ""))
            raise self.refuse(node, _SYNTAX, remedy, found=actual)
        result: Node = method(node)
        self.depth -= 1
        return result

    def quantity(self, node: ast.expr, scalar: bool = False) -> Node:
        """Convert a node that must be no condition, and no matrix where a scalar is required."""
        result = self.node(node)
        if result.condition:
            raise self.refuse(result, "a quantity", "a choice is written where(condition, a, b)")
        if scalar and result.shape is not None:
            raise self.refuse(result, "a scalar", found=f"a matrix of {result.shape[0]} x {result.shape[1]}")
        return result

    def made(self, op: str, node: ast.expr, args: tuple[Node, ...], **more: Any) -> Node:
        """Make a node, with its value if all its arguments are numbers."""
        start, end = self.place(node)
        more.setdefault("power", max((arg.power for arg in args), default=1.0))
        more["nested"] = max((arg.nested for arg in args), default=0) + (op in FUNCTIONS)
        more["branches"] = sum(arg.branches for arg in args) + (len(args) if op in ("min", "max") else 0)
        result = Node(op, start, end, args, **more)
        if more["branches"] > MAX_BRANCHES:
            raise self.refuse(result, f"at most {MAX_BRANCHES}", found=f"{more['branches']} arguments of min and max")
        if args and all(arg.number is not None for arg in args) and op in _FOLD:
            try:
                number = float(_FOLD[op](*(float(arg.number or 0.0) for arg in args)))
            except (ArithmeticError, ValueError, TypeError):  # TypeError: a complex result
                number = math.nan
            if not math.isfinite(number):
                zero = any(arg.op == "inverse" and arg.number == 0 for arg in args) or (op == "inverse")
                remedy = "it divides by zero" if zero else ""
                raise self.refuse(result, "a finite real number within the range of a double", remedy)
            result = Node(op, start, end, args, number=number, **more)
        return result

    def read_Constant(self, node: ast.Constant) -> Node:
        start, end = self.place(node)
        written = self.source[start:end]
        if isinstance(node.value, (bool, complex)) or not isinstance(node.value, (int, float)):
            raise self.refuse(node, "a real number or a name")
        if not _NUMERAL.fullmatch(written):
            raise self.refuse(node, "a decimal number such as 1.5 or 2e-3")
        digits = re.split("[eE]", written)[0]
        try:
            number = float(node.value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number) or (number == 0 and re.search("[1-9]", digits)):
            raise self.refuse(node, "a number within the range of a double")
        return Node("number", start, end, number=number)

    def read_Name(self, node: ast.Name) -> Node:
        start, end = self.place(node)
        if node.id == "pi":
            return Node("pi", start, end, number=math.pi)
        if node.id == "inf":
            raise self.refuse(node, "a finite quantity", "inf is a bound of integrate, as in integrate(f, x, 0, inf)")
        if node.id in RESERVED:
            raise self.refuse(node, f"the function with its argument, {node.id}(...)", "or another name")
        return Node("name", start, end, name=node.id)

    def read_UnaryOp(self, node: ast.UnaryOp) -> Node:
        if isinstance(node.op, ast.Not):
            return self.made("not", node, (self.truth(node.operand),))
        if isinstance(node.op, ast.Invert):
            raise self.refuse(node, _SYNTAX)
        operand = self.quantity(node.operand)
        return operand if isinstance(node.op, ast.UAdd) else self.made("neg", node, (operand,), shape=operand.shape)

    def truth(self, node: ast.expr) -> Node:
        result = self.node(node)
        if not result.condition:
            raise self.refuse(result, "a comparison such as d > 0")
        return result

    def read_BoolOp(self, node: ast.BoolOp) -> Node:
        op = "and" if isinstance(node.op, ast.And) else "or"
        return self.made(op, node, tuple(self.truth(value) for value in node.values))

    def read_Compare(self, node: ast.Compare) -> Node:
        operands = [self.quantity(operand, scalar=True) for operand in (node.left, *node.comparators)]
        for sign in node.ops:
            if type(sign) not in _SIGNS:
                raise self.refuse(node, "< <= > >= == or !=")
        signs = [_SIGNS[type(sign)] for sign in node.ops]
        pairs = [self.made(sign, node, (a, b)) for sign, a, b in zip(signs, operands[:-1], operands[1:], strict=True)]
        return pairs[0] if len(pairs) == 1 else self.made("and", node, tuple(pairs))

    def read_BinOp(self, node: ast.BinOp) -> Node:
        if isinstance(node.op, (ast.Add, ast.Sub)):
            return self.chain(node, (ast.Add, ast.Sub), self.sum)
        if isinstance(node.op, (ast.Mult, ast.Div)):
            return self.chain(node, (ast.Mult, ast.Div), self.product)
        if isinstance(node.op, ast.Pow):
            return self.raised(node)
        if isinstance(node.op, ast.MatMult):
            return self.matrix_product(node)
        raise self.refuse(node, "the operations + - * / **")

    def chain(self, node: ast.BinOp, signs: tuple[type, ...], make: Callable[[ast.BinOp, list[Node]], Node]) -> Node:
        """Convert `a + b - c` to one node, with the positions of its operands, parentheses included."""
        spine, here = [node], node
        while (
            isinstance(here.left, ast.BinOp)
            and isinstance(here.left.op, signs)
            and here.left.col_offset == here.col_offset  # no parenthesis opens between them
        ):
            here = here.left
            spine.append(here)
        spine.reverse()
        first = self.quantity(spine[0].left)
        operands = [first]
        for link in spine:
            operand = self.quantity(link.right)
            if isinstance(link.op, (ast.Sub, ast.Div)):
                op = "neg" if isinstance(link.op, ast.Sub) else "inverse"
                operand = self.made(op, link.right, (operand,), shape=operand.shape)
            operands.append(operand)
        return make(node, operands)

    def spans(self, node: ast.BinOp, operands: list[Node]) -> tuple[tuple[int, int], ...]:
        """Positions of the operands of a chain, each from after its sign to the end of its link."""
        ends: list[int] = []
        here: ast.expr = node
        for _ in operands[1:]:
            if not isinstance(here, ast.BinOp):
                raise TypeError("an operand that is no operation has no left side")
            ends.append(self.place(here)[1])
            here = here.left
        start = self.place(node)[0]
        sign = next(k for k in range(operands[0].end, len(self.source)) if self.source[k] in "+-*/")
        ends.append(len(self.source[:sign].rstrip()))
        ends.reverse()
        spans = [(start, ends[0])]
        for begin, end in pairwise(ends):
            gap = re.match(r"\s*[-+*/]\s*", self.source[begin:])
            spans.append((begin + (gap.end() if gap else 0), end))
        return tuple(spans)

    def sum(self, node: ast.BinOp, terms: list[Node]) -> Node:
        for term in terms[1:]:
            if term.shape != terms[0].shape:
                raise self.refuse(term, f"{_shape(terms[0])}, like the term before", found=_shape(term))
        return self.made("sum", node, tuple(terms), shape=terms[0].shape, spans=self.spans(node, terms))

    def product(self, node: ast.BinOp, factors: list[Node]) -> Node:
        shapes = [factor.shape for factor in factors if factor.shape is not None]
        if len(shapes) > 1:
            raise self.refuse(node, "one matrix in a product", "a product of matrices is written A @ B")
        for factor in factors:
            if factor.op == "inverse" and factor.shape is not None:
                raise self.refuse(factor, "a scalar divisor", "to solve with a matrix, write inv(A) @ b")
        shape = shapes[0] if shapes else None
        return self.made("product", node, tuple(factors), shape=shape, spans=self.spans(node, factors))

    def matrix_product(self, node: ast.BinOp) -> Node:
        left, right = self.quantity(node.left), self.quantity(node.right)
        for side in (left, right):
            if side.shape is None:
                raise self.refuse(side, "a matrix beside @", "a scalar multiplies with *")
        if left.shape is None or right.shape is None:
            raise TypeError("a product of matrices of a factor that is none")
        if left.shape[1] != right.shape[0]:
            raise self.refuse(node, "as many rows on the right as columns on the left", found=f"{_shape(left)} @ {_shape(right)}")  # fmt: skip
        return self.made("@", node, (left, right), shape=(left.shape[0], right.shape[1]))

    def raised(self, node: ast.BinOp) -> Node:
        base = self.quantity(node.left, scalar=True)
        exponent = self.quantity(node.right, scalar=True)
        power = base.power * max(1.0, abs(exponent.number or 0.0))
        if power > MAX_POWER:
            written = f"the exponent {self.source[exponent.start : exponent.end]}"
            raise self.refuse(exponent, f"powers of at most {MAX_POWER} in all", found=written)
        return self.made("**", node, (base, exponent), power=max(power, exponent.power))

    def read_Call(self, node: ast.Call) -> Node:
        if not isinstance(node.func, ast.Name):
            bare = node.func.attr if isinstance(node.func, ast.Attribute) else ""
            raise self.refuse(
                node.func, "a function by its bare name", f"write {bare}(...)" if bare in FUNCTIONS else ""
            )
        name = node.func.id
        if name not in FUNCTIONS:
            raise self.refuse(node.func, "a known function", _offer(name))
        if node.keywords:
            raise self.refuse(node.keywords[0].value, "arguments by their order", found="an argument by name")
        if name == "integrate" and len(node.args) == 2 and isinstance(node.args[1], ast.Tuple):
            node.args = [node.args[0], *node.args[1].elts]
        fewest, most = FUNCTIONS[name]
        count = len(node.args)
        if not fewest <= count <= most or (name == "integrate" and count == 3):
            expected = {"integrate": "integrate(f, x) or integrate(f, x, lower, upper)", "diff": "diff(f, x)"}.get(
                name, f"{fewest}" if fewest == most else f"{fewest} to {most}"
            )
            raise self.refuse(node, expected, found=f"{count} arguments of {name}")
        if name == "diff":
            return self.derivative(node)
        if name == "integrate":
            return self.integral(node)
        if name == "where":
            condition, *branches = self.truth(node.args[0]), *(self.quantity(arg, scalar=True) for arg in node.args[1:])
            return self.made("where", node, (condition, *branches))
        if name in MATRIX_FUNCTIONS:
            return self.of_matrix(name, node)
        if name == "LambertW" and count == 2 and self.quantity(node.args[1]).number not in (0, -1):
            raise self.refuse(
                node.args[1], "the branch, 0 or -1", "LambertW(x) is the upper branch, LambertW(x, -1) the lower one"
            )
        return self.made(name, node, tuple(self.quantity(arg, scalar=True) for arg in node.args))

    def variable(self, node: ast.expr) -> Node:
        result = self.quantity(node)
        if result.op != "name":
            raise self.refuse(result, "a name to differentiate or integrate by")
        return result

    def derivative(self, node: ast.Call) -> Node:
        function, variables = self.quantity(node.args[0]), [self.variable(node.args[1])]
        for arg in node.args[2:]:
            if isinstance(arg, ast.Constant) and type(arg.value) is int and 1 <= arg.value <= MAX_ORDER:
                variables += [variables[-1]] * (arg.value - 1)
            else:
                variables.append(self.variable(arg))
        if len(variables) > MAX_ORDER:
            raise self.refuse(node, f"at most {MAX_ORDER}", found=f"a derivative of order {len(variables)}")
        return self.made("diff", node, (function, *variables), shape=function.shape)

    def integral(self, node: ast.Call) -> Node:
        function, variable = self.quantity(node.args[0]), self.variable(node.args[1])
        bounds = tuple(self.bound(arg) for arg in node.args[2:])
        return self.made("integrate", node, (function, variable, *bounds), shape=function.shape)

    def bound(self, node: ast.expr) -> Node:
        sign = node.operand if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub) else node
        if isinstance(sign, ast.Name) and sign.id == "inf":
            start, end = self.place(node)
            return Node("inf", start, end, name="-" if sign is not node else "")
        return self.quantity(node, scalar=True)

    def read_List(self, node: ast.List) -> Node:
        rows = [item.elts if isinstance(item, ast.List) else [item] for item in node.elts]
        width = len(rows[0]) if rows else 0
        if not 0 < len(rows) <= MAX_SIDE or not 0 < width <= MAX_SIDE or any(len(row) != width for row in rows):
            raise self.refuse(node, f"rows of one length, 1 to {MAX_SIDE}, as in [[a, b], [c, d]]")
        entries = tuple(self.quantity(entry, scalar=True) for row in rows for entry in row)
        return self.made("matrix", node, entries, shape=(len(rows), width))

    def of_matrix(self, name: str, node: ast.Call) -> Node:
        matrix = self.quantity(node.args[0])
        if matrix.shape is None:
            raise self.refuse(matrix, "a matrix such as [[a, b], [c, d]]")
        rows, columns = matrix.shape
        if name != "transpose" and rows != columns:
            raise self.refuse(matrix, "a square matrix", found=_shape(matrix))
        shape = {"transpose": (columns, rows), "inv": matrix.shape}.get(name)
        return self.made(name, node, (matrix,), shape=shape)


_REFUSED: dict[type, tuple[str, str]] = {
    ast.IfExp: ("'a if condition else b'", "write where(condition, a, b)"),
    ast.Tuple: ("a comma", "a decimal point is written 1.5, a matrix [[a, b], [c, d]]"),
    ast.Attribute: ("a dot between names", "functions stand by their bare names, as in sqrt(x)"),
    ast.Subscript: ("an index", "give the entry a name"),
    ast.Lambda: ("'lambda', a word of Python", "choose another name"),
    ast.NamedExpr: ("':='", ""),
    ast.JoinedStr: ("quoted text", "write names without quotes"),
}


def _shape(node: Node) -> str:
    return "a scalar" if node.shape is None else f"a matrix of {node.shape[0]} x {node.shape[1]}"


_INSTEAD = {
    "piecewise": "a choice is written where(condition, a, b), of three cases where(condition, a, where(other, b, c))",
    "heaviside": "a step is written where(x > 0, 1, 0)",
    "log10": "write log(x)/log(10)",
    "log2": "write log(x)/log(2)",
    "cbrt": "write x**(1/3)",
    "square": "write x**2",
    "pow": "write x**n",
    "norm": "write sqrt(x**2 + y**2)",
    "hypot": "write sqrt(x**2 + y**2)",
}
"""Spellings of functions of other systems, in whatever case."""


def _offer(name: str) -> str:
    """Suggestion for an unknown function."""
    if (instead := _INSTEAD.get(name.lower())) is not None:
        return instead
    same = next((known for known in FUNCTIONS if known.lower() == name.lower()), None)
    if same is not None:
        arguments = ", ".join("abc"[: FUNCTIONS[same][0]]) if FUNCTIONS[same][0] > 1 else "x"
        return f"write {same}({arguments}): names are case-sensitive"
    known = _ALIASES.get(name.lower())
    close = [known] if known else difflib.get_close_matches(name.lower(), FUNCTIONS, n=3, cutoff=0.6)
    if close:
        return f"did you mean {' or '.join(close)}?"
    return f"known are {' '.join(FUNCTIONS)}; a product is written with *"


_FOLD: dict[str, Callable[..., Any]] = {
    "sum": lambda *terms: sum(terms),
    "product": lambda *factors: math.prod(factors),
    "neg": operator.neg,
    "inverse": lambda x: 1 / x,
    "**": operator.pow,
    **{name: getattr(math, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan")},
    **{name: getattr(math, name) for name in ("sinh", "cosh", "tanh", "atan2")},
    "abs": abs,
    "gamma": math.gamma,
    "LambertW": lambda x, branch=0.0: float(lambertw(x, int(branch))),
    "sign": lambda x: (x > 0) - (x < 0),
    "min": min,
    "max": max,
    "where": lambda condition, a, b: a if condition else b,
    **_COMPARE,
    "and": lambda *terms: all(terms),
    "or": lambda *terms: any(terms),
    "not": operator.not_,
}


def plain_name(name: str) -> str:
    """Normalised form of a name as in Python's grammar: both micro signs are one name."""
    return unicodedata.normalize("NFKC", name)
