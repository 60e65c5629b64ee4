"""LaTeX of the equations for people, as MathML that browsers typeset by themselves.

The subset is the one that the printers of `derive` write; anything else raises ValueError. A line is several `math`
elements, broken before equals, plus and minus signs, so that long equations go on in the next line.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Literal, TypeAlias
from unicodedata import lookup

from hertzwerk.derive.common.markup import Markup, joined, tag

LONG = 45  # tokens from which a bracket or a numerator is taken apart

WIDE = 30  # letters and signs from which a line may also break before a factor

CELL = 45  # and from which a case goes on in the next line

ROW = 65  # and from which a line breaks before a root or bracket, and a condition stands below its value

Role: TypeAlias = Literal["", "sign", "opens", "factor", "comma"]

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\S", re.DOTALL)
_SYMBOLS = {
    **{"varphi": "φ", "phi": "ϕ", "varepsilon": "ε", "epsilon": "ϵ", "vartheta": "ϑ", "lambda": "λ", "Lambda": "Λ"},
    **{"infty": "∞", "ell": "ℓ", "partial": "∂"},
}
_SIGNS = {
    "cdot": "·", "times": "×", "leq": "≤", "geq": "≥", "neq": "≠", "ne": "≠", "perp": "⟂", "in": "∈", "int": "∫",
    "wedge": "∧", "vee": "∨", "neg": "¬", "to": "→", "pm": "±", "langle": "⟨", "rangle": "⟩", "lVert": "‖",
    "rVert": "‖", "lvert": "|", "rvert": "|", "lfloor": "⌊", "rfloor": "⌋", "mid": "|",
}  # fmt: skip
_FUNCTIONS = (
    "sin",
    "cos",
    "tan",
    "sinh",
    "cosh",
    "tanh",
    "arcsin",
    "arccos",
    "arctan",
    "log",
    "ln",
    "exp",
    "max",
    "min",
)
_SPACES = {",": "0.17em", ";": "0.28em", "!": "-0.17em", "quad": "1em", "qquad": "2em", " ": "0.3em"}
_ACCENTS = {"dot": "˙", "ddot": "¨", "hat": "^", "bar": "¯", "vec": "→", "tilde": "~"}
_BREAKS = tuple(tag("mo", sign) for sign in ("=", "+", "−", "≤", "≥", "≠"))


def lines_of(latex: str) -> list[tuple[Markup, str]]:
    """Return the lines of an equation, each with the remark that stands beside it; raises ValueError."""
    body = re.fullmatch(r"\s*\\begin\{aligned\}(.*)\\end\{aligned\}\s*", latex, re.DOTALL)
    if body is None:
        return [(_line(latex), "")]
    lines = []
    for row in body[1].split(r"\\"):
        left, right, *remark = (cell.strip() for cell in [*row.split("&"), ""][:4])
        text = re.fullmatch(r"\\text\{(.*)\}", "".join(remark).strip())
        if any(remark) and text is None:
            raise ValueError(f"found {row!r}, expected a text beside the equation")
        lines.append((_line(f"{left} {right}"), _plain(text[1]) if text else ""))
    return lines


def inline(latex: str) -> Markup:
    """Return a short formula as one `math` element; raises ValueError."""
    return tag("math", joined(node for node, _ in _Reader(latex).all()))


def _line(latex: str) -> Markup:
    """Return a line as `math` elements that a browser may put on several lines."""
    # display style by attribute: the elements stay inline
    pieces = _pieces(_Reader(latex).all())
    return joined((tag("math", tag("mrow", *piece), displaystyle="true") for piece in pieces), " ")


def _pieces(nodes: Iterable[tuple[Markup, Role]]) -> list[list[Markup]]:
    """Divide nodes where a line may break."""
    pieces: list[list[Markup]] = [[]]
    before: Role = "opens"
    for node, role in nodes:
        wide = _letters(joined(pieces[-1])) > WIDE or _letters(joined((*pieces[-1], node))) > ROW
        here = role == "sign" or (wide and (role in ("opens", "factor") or before == "comma"))
        breaks = here and before not in ("sign", "opens")
        if breaks:
            pieces.append([])
        # a plus or minus at the start of a piece is none of a number's
        pieces[-1].append(Markup(node.replace("<mo>", '<mo form="infix">')) if breaks and role == "sign" else node)
        before = role
    return pieces


class _Reader:
    """Recursive descent over the tokens of a formula."""

    def __init__(self, latex: str) -> None:
        self._latex = latex
        self._tokens = list(_TOKEN.finditer(latex))
        self._at = 0

    def all(self) -> list[tuple[Markup, Role]]:
        """Return all nodes with their roles; long brackets and fractions are taken apart."""
        nodes = list(self._row((), apart=True))
        if self._at < len(self._tokens):
            raise self._unexpected(self._token)
        return nodes

    @property
    def _token(self) -> str:
        return self._tokens[self._at][0] if self._at < len(self._tokens) else ""

    def _next(self) -> str:
        token = self._token
        if not token:
            raise ValueError(f"{self._latex!r} ends too early")
        self._at += 1
        return token

    def _fenced_next(self) -> bool:
        """Return whether a bracket comes next, alone or as the first of a group."""
        at = self._at + (self._token == "{")
        return at < len(self._tokens) and self._tokens[at][0] in (r"\left", "(")

    def _expect(self, wanted: str) -> None:
        if (token := self._next()) != wanted:
            raise self._unexpected(token, wanted)

    def _unexpected(self, token: str, wanted: str = "what the printers write") -> ValueError:
        return ValueError(f"found {token!r} in {self._latex!r}, expected {wanted}")

    def _row(self, ends: tuple[str, ...], *, apart: bool = False) -> Iterator[tuple[Markup, Role]]:
        before, word = "opens", False
        while self._token and self._token not in (*ends, "}", r"\right", r"\end", "&", r"\\"):
            if apart and (parts := self._taken_apart()) is not None:
                yield from parts
                before, word = "", False
                continue
            spaced, word = word, self._token == r"\mathrm" and self._closing(self._at + 1) > self._at + 3
            node, role = self._scripted()
            if (spaced or word) and before not in ("sign", "opens", "comma") and role not in ("sign", "opens", "comma"):
                node = joined((_space(_SPACES[","]), node))  # between factors of which one is a word
            yield node, role
            before = role

    def _taken_apart(self) -> Iterator[tuple[Markup, Role]] | None:
        """Return the pieces of a long group, bracket or fraction, if one comes next."""
        at = self._at + (self._token == r"\frac")
        last = self._closing(at)
        if self._token == r"\frac":
            below = self._closing(last + 1)
            grouped = [token[0] for token in (*self._tokens[at : at + 1], *self._tokens[last + 1 : last + 2])] == [
                "{",
                "{",
            ]
            one = last == at + 2 and below - last <= LONG  # over what stays whole: nothing to take apart
            return self._fraction(last, below) if grouped and below - at > LONG and not one else None
        if last - at <= LONG:
            return None
        if self._token == "{":
            scripted = self._tokens[last + 1][0] in ("_", "^") if last + 1 < len(self._tokens) else False
            return None if scripted else self._inside(last)
        return self._bracket() if self._token == r"\left" else None

    def _inside(self, last: int) -> Iterator[tuple[Markup, Role]]:
        """Yield what stands in a group, piece by piece."""
        self._next()
        yield from self._row((), apart=True)
        if self._at != last:
            raise self._unexpected(self._token)
        self._next()

    def _closing(self, at: int) -> int:
        """Return the place of the token that closes the group or bracket which opens at a place."""
        depth = 0
        for place in range(at, len(self._tokens)):
            depth += {"{": 1, r"\left": 1, "}": -1, r"\right": -1}.get(self._tokens[place][0], 0)
            if not depth:
                return place
        return at  # it is refused where it is read

    def _bracket(self) -> Iterator[tuple[Markup, Role]]:
        """Yield a long bracket piece by piece, so that lines break in it."""
        self._next()
        yield self._fence(stretchy=False) or Markup(""), "opens"
        yield from self._row((), apart=True)
        self._expect(r"\right")
        yield self._with_scripts(self._fence(stretchy=False) or Markup("")), ""

    def _fraction(self, last: int, below: int) -> Iterator[tuple[Markup, Role]]:
        """Yield a long fraction in one line: a factor and a bracket, or a stroke where it divides by much."""
        opened, closed = tag("mo", "(", stretchy="false"), tag("mo", ")", stretchy="false")
        first, much = self._at + 1, below - last > LONG
        if not much:
            self._at = last + 1
            yield tag("mfrac", tag("mn", "1"), self._argument()), ""
        self._at = first
        yield opened, "opens"
        yield from self._inside(last)
        yield closed, ""
        if much:
            yield tag("mo", "/"), "sign"
            yield opened, "opens"
            yield from self._inside(below)
            yield closed, ""
        self._at = below + 1

    def _nodes(self, *ends: str) -> Markup:
        return tag("mrow", *(node for node, _ in self._row(ends)))

    def _with_scripts(self, base: Markup) -> Markup:
        scripts = {}
        while self._token in ("_", "^"):
            key = self._next()
            scripts[key] = self._argument()
        name = f"m{'sub' if '_' in scripts else ''}{'sup' if '^' in scripts else ''}"
        return tag(name, base, *(scripts[key] for key in "_^" if key in scripts)) if scripts else base

    def _scripted(self) -> tuple[Markup, Role]:
        first = self._token
        base = self._atom()
        node = self._with_scripts(base)
        if first.removeprefix("\\") in _FUNCTIONS or first == r"\operatorname":
            around = _space(_SPACES[","])
            node = joined([around, node, None if self._fenced_next() else around])
            return node, "opens"
        factor = first in (r"\left", r"\begin", r"\sqrt")
        return node, "sign" if base in _BREAKS else "factor" if factor else "comma" if first == "," else ""

    def _argument(self) -> Markup:
        """Return a group, or the one node that stands for it."""
        if self._token == "{":
            self._next()
            nodes = self._nodes("}")
            self._expect("}")
            return nodes
        return self._atom()

    def _atom(self) -> Markup:
        token = self._token
        if token == "{":
            return self._argument()
        self._next()
        name = token[1:]
        if not token.startswith("\\"):
            return self._character(token)
        if letter := _letter(name):
            return tag("mi", letter)
        if name in _SIGNS:
            return tag("mo", _SIGNS[name])
        if name in _FUNCTIONS:
            return tag("mi", name)
        if name in _SPACES:
            return _space(_SPACES[name])
        if name in _ACCENTS:
            return tag("mover", self._argument(), tag("mo", _ACCENTS[name], stretchy="false"), accent="true")
        if name == "frac":
            return tag("mfrac", self._argument(), self._argument())
        if name == "sqrt":
            return self._root()
        if name == "left":
            return self._fenced()
        if name == "begin":
            return self._cases()
        if name in ("mathrm", "operatorname", "text"):
            text = _plain(self._raw())
            kind = "mtext" if name == "text" else "mi"
            return tag(kind, text, mathvariant="normal" if kind == "mi" and len(text) == 1 else None)
        if name in ("{", "}", "|", "%", "_", "#", "&"):
            return tag("mo", {"|": "‖"}.get(name, name))
        raise self._unexpected(token)

    def _character(self, token: str) -> Markup:
        if token[0].isdigit():
            return tag("mn", token)
        if token.isalpha():
            return tag("mi", token)
        if token in "+-=<>()[]|,.;:/!*'":
            return tag(
                "mo", {"-": "−", "*": "∗", "'": "′"}.get(token, token), stretchy="false" if token in "()[]|" else None
            )
        raise self._unexpected(token)

    def _raw(self) -> str:
        """Return the text of a group as it stands, spaces kept."""
        self._expect("{")
        start, depth = self._tokens[self._at - 1].end(), 1
        while depth:
            depth += {"{": 1, "}": -1}.get(self._next(), 0)
        return self._latex[start : self._tokens[self._at - 1].start()]

    def _root(self) -> Markup:
        if self._token != "[":
            return tag("msqrt", self._argument())
        self._next()
        index = self._nodes("]")
        self._expect("]")
        return tag("mroot", self._argument(), index)

    def _fenced(self) -> Markup:
        opened, inside = self._fence(), self._nodes()
        self._expect(r"\right")
        return tag("mrow", opened, inside, self._fence())

    def _fence(self, *, stretchy: bool = True) -> Markup | None:
        token = self._next()
        sign = _SIGNS.get(token[1:], token.removeprefix("\\"))
        return None if sign == "." else tag("mo", sign, fence="true", stretchy=str(stretchy).lower())

    def _cases(self) -> Markup:
        if (name := self._raw()) != "cases":
            raise self._unexpected(name, "cases")
        rows: list[list[Markup]] = [[]]
        while True:
            rows[-1].append(self._cell())
            if (token := self._next()) == r"\\":
                rows.append([])
            elif token == r"\end":
                self._raw()
                break
            elif token != "&":
                raise self._unexpected(token)
        table = tag("mtable", *(tag("mtr", *cells) for row in rows for cells in _case(row)))
        return tag("mrow", tag("mo", "{", fence="true", stretchy="true"), table)

    def _cell(self) -> Markup:
        """Return a value or condition of cases; a long one as lines below each other."""
        start, whole = self._at, self._nodes()
        if _letters(whole) <= CELL:
            return whole
        self._at = start
        lines: list[list[Markup]] = [[]]
        for piece in _pieces(self._row((), apart=True)):
            if lines[-1] and _letters(joined((*lines[-1], *piece))) > CELL:
                lines.append([_space(_SPACES["quad"])])
            lines[-1] += piece
        return tag("mtable", *(tag("mtr", tag("mtd", *line, style="text-align: left; padding: 0")) for line in lines))


def _case(row: Sequence[Markup]) -> Iterator[list[Markup]]:
    """Yield the cells of a value and its condition; a long condition stands below its value."""
    if _letters(joined(row)) <= ROW:
        yield [tag("mtd", cell, style="text-align: left") for cell in row]
        return
    for cell, before in zip(row, (None, _space(_SPACES["qquad"])), strict=False):
        yield [tag("mtd", before, cell, style="text-align: left", columnspan="2")]


def _letter(name: str) -> str:
    """Return the letter of a command, Greek or other; nothing for what is none."""
    try:
        return _SYMBOLS.get(name) or lookup(f"GREEK {'CAPITAL' if name[0].isupper() else 'SMALL'} LETTER {name}")
    except KeyError:
        return ""


def _letters(node: Markup) -> int:
    """Count the letters and signs of a formula."""
    return len(re.sub("<[^>]*>", "", node))


def _space(width: str) -> Markup:
    return tag("mspace", width=width)


def _plain(text: str) -> str:
    """Return the text of a group without LaTeX's escapes."""
    text = re.sub(r"\\([_#%&{}$])", r"\1", text.replace(r"\,", "\N{THIN SPACE}"))
    if "\\" in text:
        raise ValueError(f"found {text!r}, expected a text without commands")
    return text.replace(" ", "\N{NO-BREAK SPACE}") if text != text.strip() else text
