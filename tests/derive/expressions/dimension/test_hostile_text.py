"""No text of a declaration becomes code: a module differs from the plain one in its strings, or the text is refused and said why."""

import ast
from typing import Any

import casadi as ca
import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power, smooth_coulomb
from hertzwerk.derive.laws.law import DampingLaw, Quantity, v
from hertzwerk.derive.program.emit.module_text import emit

TEXTS = [
    'b""";open("...","w");"""', '"""', "'''", '"', "'", "\\", "\\\\", 'a\\"', '\\"""', "\\N{x}", "\\N{DIGIT ONE}", "\\x", "\\u12", "\\\n", "a\nb",
    "a\r\nb", "tab\there", "{x}", "%s", "$", "a $x^{$ b", "\\frac{a", "<script>alert(1)</script>", "&amp;", "</td>|", "#", "\u202eabc", "a\u2028b",
    "\x00", "\x07", "\x1b[31m", "\x7f", "\ud800", "\udfff\ud800", "\ufeff", "é", "😀", "日本", "", " ", "x" * 90, "x" * 5000, "\\" * 115, '\\" ' * 60,
    ("\\" * 57 + " ") * 9, "ﬁ", "__debug__", "_", "None", "class", "match",
]  # fmt: skip

PLAIN = {
    kind: f"{kind}_name"
    for kind in ("scene", "mechanism", "body", "joint", "pair", "effect", "parameter", "table", "symbol", "law")
}


def scene(name: dict[str, str] | None = None, text: str = "plain") -> hd.Scene:
    """A scene with every kind of name and text."""
    n = PLAIN | (name or {})
    own = Quantity(n["symbol"], "N s/m", text)
    law = DampingLaw(n["law"], text, (own,), text, "C", note=text, repair=text, term=own * v)
    radius, clearance = hd.Parameter("bush", "mm", 10, text), hd.Parameter(n["parameter"], "mm", 0.5, text)
    wheel = hd.Body("wheel", hd.Parameter("wheel_mass", "kg", 1, text), hd.Parameter("J", "kg m^2", 1e-3))
    body = hd.Body(n["body"], hd.Parameter("mass", "kg", 2, text))
    length = hd.Parameter("length", "m", 0.1, text)
    table = hd.Table(n["table"], (0, 1, 2), (0, 3, 1), ("s", "N"))
    mechanism = hd.Mechanism(
        n["mechanism"],
        (hd.Revolute(n["joint"], hd.GROUND, wheel, axis=hd.Z), hd.Prismatic("slide", hd.GROUND, body, axis=hd.Y)),
        (hd.PinInBush(n["pair"], wheel.at(length, 0, 0), body.at(0, 0, 0), hd.Z, radius, clearance),),
    )
    effects = (
        hd.Gravity("weight", hd.Parameter("g", "m/s^2", 9.81), -hd.Y),
        hd.JointSpring(n["effect"], n["joint"], hd.Parameter("spring", "N m/rad", 10)),
        hd.JointForce("push", "slide", table(hd.T)),
        hd.Contact(n["pair"], power(hd.Parameter("K", "N/m^1.5", 1e9, text), 1.5), law(hd.Parameter("damping", "N s/m", 5))),
        hd.Friction("rub", n["pair"], smooth_coulomb(hd.Parameter("mu", "1", 0.1), hd.Parameter("v_s", "m/s", 0.1))),
        hd.EnergyLedger(),
    )  # fmt: skip
    scales = hd.Scales(length=clearance, speed=hd.Parameter("pace", "m/s", 1), arm=length)
    return hd.Scene(mechanism, effects, scales, hd.Start({"slide": length}), name=n["scene"], summary=text)


def shape(text: str) -> str:
    """A module's syntax tree without what its strings say."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            node.value = ""
    return ast.dump(tree)


def executed(text: str) -> dict[str, Any]:
    module: dict[str, Any] = {}
    exec(compile(text, "module", "exec"), module)
    return module


def numbers(text: str) -> list[float]:
    """What every function of a module gives at one point, as it is built and evaluated by CasADi."""
    module = executed(text)
    p = ca.DM([0.7 + 0.013 * k for k in range(len(module["PARAMETERS"]))])
    sizes = {"q": "COORDINATES", "u": "SPEEDS", "z": "MEMORY", "m": "LATCHES"}
    known: dict[str, Any] = {"t": ca.DM(0.3), "p": p, "c": module["constants"](p)}
    known |= {name: ca.DM([0.1 + 0.07 * k for k in range(len(module[table]))]) for name, table in sizes.items()}
    known |= {"a": known["u"], "f": ca.DM([1.0, 2.0]), "reactions": ca.DM([])}
    found: list[float] = []
    for name, value in module.items():
        if (
            callable(value) and name in dict(module["OPERATIONS"]) and name != "constants"
        ):  # whose entries are its own affair
            arguments = value.__code__.co_varnames[: value.__code__.co_argcount]
            results = value(*(known[argument] for argument in arguments))
            for result in results if isinstance(results, tuple) else (results,):
                found.extend(np.array(ca.DM(result)).ravel())
    return found


@pytest.fixture(scope="module")
def plain() -> str:
    return hd.generate(scene())


def printable(text: str) -> bool:
    return all(c.isprintable() or c in " \t\r\n" for c in text)


SAMPLE = (TEXTS[0], "\\\n", "a $x^{$ b", "\\N{x}", "\u202eabc", "\x00", "\ud800", "😀", "", ("\\" * 57 + " ") * 9)
ALL_TEXTS = pytest.mark.parametrize(
    "texts", [SAMPLE, pytest.param(TEXTS, marks=pytest.mark.exhaustive)], ids=["sample", "all"]
)


@ALL_TEXTS
def test_text_of_a_declaration_changes_strings_alone(plain, texts):
    """A body's name, written into a docstring as it came, was executed with the module."""
    for text in texts:
        if not printable(text):
            with pytest.raises(hd.InputError) as caught:
                scene(text=text)
            assert len({fault.where for fault in caught.value.faults}) >= 12, ascii(text)
            str(caught.value).encode()
            continue
        made = hd.generate(scene(text=text))
        assert shape(made) == shape(plain), ascii(text)
        module = executed(made)
        assert module["SUMMARY"] == text
        meanings = {row[0]: row[3] for row in module["PARAMETERS"]}
        assert meanings["bush"] == (text or "pair pair_name, bush radius")


@ALL_TEXTS
def test_the_name_of_a_file_changes_strings_alone(plain, texts):
    program = hd.derive(scene())
    for text in texts:
        made = emit(program, text)
        assert shape(made) == shape(plain), ascii(text)
        assert executed(made)["SOURCE"] == text
        made.encode()


def refused(name: str) -> bool:
    """Whether a declaration says what is wrong with a name, by a rule of its own here: what Python would not keep as it is."""
    try:
        tree = ast.parse(f"{name} = 1\nassert {name}")
    except (SyntaxError, ValueError, UnicodeEncodeError):
        return True
    first = tree.body[0]
    same = isinstance(first, ast.Assign) and isinstance(first.targets[0], ast.Name) and first.targets[0].id == name
    return not same or len(tree.body) != 2 or name.startswith("_") or len(name.encode()) > 120


def check_name(kinds: tuple[str, ...], name: str, expected: list[float]) -> None:
    """Either the declaration refuses a name, or the module does what the plain one does."""
    if refused(name):
        with pytest.raises(hd.InputError) as caught:
            scene(dict.fromkeys(kinds, name))
        str(caught.value).encode()
        return
    try:
        declared = scene(dict.fromkeys(kinds, name))
    except hd.InputError as error:
        taken = {"bush", "mass", "length", "damping", "g", "E", "mu", "spring", "J"}  # what the scene has of the kind
        reserved = {
            "ca", "t", "p", "q", "u", "a", "f", "z", "m", "c", "wanted", "reactions", "joints", "joint_speeds",
            "push_TABLE", "PUSH_TABLE",
        }  # fmt: skip
        assert name in taken | reserved | {"ground"}, error
        return
    made = hd.generate(declared)
    np.testing.assert_allclose(numbers(made), expected, rtol=1e-12, atol=1e-14, err_msg=name)


ALL = tuple(kind for kind in PLAIN if kind != "effect")  # a contact is an effect of its pair's name


FEW = (
    "x1", "k1", "constants", "PARAMETERS", "länge", "stiﬀness", "n" * 90, "_gamma", "PUSH_TABLE", "ca", "nan", "casadi", "float",
    "inverse_mass", "fall_travel", TEXTS[0],
)  # fmt: skip


@pytest.mark.parametrize("name", FEW, ids=ascii)
def test_a_name_is_refused_or_changes_no_number(name, plain):
    check_name(ALL, name, numbers(plain))


def test_parameters_that_python_reads_as_one_are_refused():
    """One typed with a ligature, one without: the module took the second for both, and the force was sixteen times too large."""
    with pytest.raises(hd.InputError, match=r"'stiﬀness'.*expected 'stiffness'"):
        scene({"parameter": "stiﬀness"})
