"""The committed modules are what the scenes derive to, the same everywhere; and nothing for nothing."""

import ast
import re
from functools import cache
from importlib import import_module
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from derived import Derived
from each import each

from hertzwerk.derive import Friction, generate
from hertzwerk.derive.program.emit.cost import OF_CURVES, operations
from hertzwerk.derive.program.emit.helpers import HELPERS
from hertzwerk.derive.program.emit.sector_helpers import SECTOR_HELPERS
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime.engine.model.build import scene_from

GENERATED = Path(__file__).parents[4] / "generated"


@cache
def committed(name):
    return (GENERATED / f"{name}.py").read_text(encoding="utf-8")


@cache
def regenerated(name):
    return generate(scene_from(name), f"derive/scenes/{name}.py")


# -- golden ------------------------------------------------------------------------------------------------------------


def test_every_built_in_scene_has_its_module_and_nothing_else_is_there():
    assert {file.stem for file in GENERATED.glob("*.py")} - {"__init__"} == set(NAMES)
    assert [scene_from(name).name for name in NAMES] == list(NAMES)


# calls by which a module of kinds finds the function of a kind and places its rows
OF_KINDS = {
    *("enumerate", "len", "range", "sum", "tuple", "type", "zip", "globals", "globals().update"),
    *("type(x)", "u.numel", "x.numel", "z.numel", "found[5].numel"),
    *(f"globals()[f'{name}']" for name in ("{name}_of_{kind}", "{name}_of_{family}", "contact_of_{family}")),
}


# -- form --------------------------------------------------------------------------------------------------------------


@each("name", NAMES)
def test_modules_import_casadi_alone_and_say_where_they_come_from(name):
    tree = ast.parse(committed(name))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]
    assert [ast.unparse(node) for node in imports] == ["import casadi as ca"]
    tree.body = [node for node in tree.body if not (isinstance(node, ast.FunctionDef) and node.name in HELPERS)]
    calls = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    own = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    allowed = HELPERS.keys() | own | (OF_KINDS if "\nFAMILIES = " in committed(name) else set())
    assert {call for call in calls if not call.startswith("ca.")} <= allowed
    assert not any(isinstance(node, ast.For | ast.While | ast.Lambda | ast.Global) for node in ast.walk(tree))
    text = committed(name)
    assert not re.search(r"(?<![\w.])/(home|root|tmp|usr|work|Users|private|var)/|[A-Z]:\\\\", text)
    assert not re.search(r"\b20\d\d-\d\d-\d\d|\b\d\d:\d\d:\d\d\b", text)
    assert not re.search(r"0x[0-9a-f]{6,}", text)
    assert text.endswith("\n")
    assert not re.search(r"[ \t]+$", text, re.M)
    text = ast.get_docstring(ast.parse(committed(name)))
    assert f"Generated from derive/scenes/{name}.py" in text
    assert f"`hertzwerk derive {name}`" in text
    assert re.search(r"Units: \d+ assignments and \d+ outputs checked, all consistent", text)
    listed = " ".join(text.partition("Effects:\n")[2].partition("\nUnits:")[0].split())
    effects = [effect.name for effect in scene_from(name).effects]
    for first, last, count in re.findall(r"(\w+) to (\w+), (\d+): ", listed):
        between = effects[effects.index(first) : effects.index(last) + 1]
        assert len(between) == int(count)
        effects = [effect for effect in effects if effect not in between]
    for effect in effects:
        assert re.search(rf"\b{effect}\b[\w, ]*: ", listed)


class Counted:
    """A number that counts the operations it goes through."""

    count = 0

    def _operation(self, *_):
        Counted.count += 1
        return Counted()

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _operation
    __pow__ = __rpow__ = __neg__ = __gt__ = __lt__ = __ge__ = __le__ = _operation


class Column(list):
    """A column of numbers, which is indexed by a number or by a list of them."""

    def __getitem__(self, rows):
        return Column(self[row] for row in rows) if isinstance(rows, list) else super().__getitem__(rows)


class Counting:
    """In place of CasADi: every function is one operation, and columns cost none."""

    @staticmethod
    def vertcat(*entries):
        return entries

    def __getattr__(self, name):
        return lambda *arguments: Counted()._operation()


def search(*_):
    """A search along a curve: one call."""
    Counted.count += 1
    return [Counted()] * 10


def shares(n, *_):
    """Shares of a direction among sectors: the operations of its text."""
    Counted.count += operations(SECTOR_HELPERS["_shares"])
    return Column([Counted()] * n)


@each("name", NAMES)
def test_the_operations_of_every_mode_are_those_that_its_functions_do(name):
    """Counted as they are done: those of a flight together, and what each pair adds while it touches."""
    names = {}
    exec(compile(committed(name).replace("import casadi as ca\n", ""), name, "exec"), names)
    names["ca"], done = Counting(), {}
    names |= dict.fromkeys(OF_CURVES, search) | {"_shares": shares}
    names["sum"] = lambda energies: energies[0]  # adding up those of the bodies is not counted
    families = {f"contact_of_{family}": len(members) for family, members in names.get("FAMILIES", ())}
    for function, _ in names["OPERATIONS"]:
        arguments = names[function].__code__.co_varnames[: names[function].__code__.co_argcount]
        Counted.count = 0
        names[function](*(Counted() if argument == "t" else Column([Counted()] * 500) for argument in arguments))
        done[function] = Counted.count * families.get(function, 1)
        if "c" in arguments:
            assert dict(names["OPERATIONS"])[function] == done[function], function
    flight = sum(done[f] for f in ("applied", "accelerations", "gaps", "gap_accelerations"))
    touching = families or [f"contact_{pair}" for pair, _ in names["PAIRS"]]
    contacts = ", ".join(f"{contact} {done[contact]}" for contact in touching)
    in_contact = f"; in contact also {contacts}" if contacts else ""
    (line,) = re.findall(r"^Operations: .*$", committed(name), re.M)
    assert line == f"Operations: flight {flight} (equations of motion and gaps){in_contact}"


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", NAMES)
def test_functions_return_what_the_tables_say(name):
    """Sizes by the tables, at the start, on numbers and on both kinds of CasADi symbols."""
    derived = Derived(text=committed(name))
    nq, nu, nz, nm, k = (
        len(getattr(derived, table)) for table in ("COORDINATES", "SPEEDS", "MEMORY", "LATCHES", "PAIRS")
    )
    nb, ny = len(derived.BODIES), len(derived.OUTPUTS)
    nr = sum(kind == "drive" for _, kind, _ in derived.EFFECTS) if nz else 0
    nf = nu + nr + len(getattr(derived, "WORN", ()))
    sizes = {
        "constants": [len(derived.CONSTANTS)], "start": [nq, nu], "scales": [nq, nu, nz, 4], "coordinate_rates": [nq], "gaps": [k, k],
        "gap_accelerations": [k], "applied": [nf], "accelerations": [nu, nr], "ledger": [nz], "energy": [1, 1, k], "poses": [3 * nb, 9 * nb],
        "outputs": [ny],
    }  # fmt: skip
    nl = len(derived.CONSTRAINTS)
    if nl:
        sizes |= {"accelerations": [nu, nr, nl], "constraints": [nl, nl], "projection": [nu, nl]}
    q, u = derived.start()
    options = {
        "q": q, "u": u, "a": np.ones(nu), "f": np.ones(nf), "reactions": np.ones(nr), "z": np.zeros(nz), "m": np.ones(nm), "t": 1e-3,
        "p": derived.p, "c": derived.c, "wanted": np.ones(nl),
    }  # fmt: skip
    for function, expected in sizes.items():
        numbers = derived.results(function, options)
        assert [value.shape for value in numbers] == [(size, 1) for size in expected], function
        for kind in (ca.SX, ca.MX):
            symbols = [kind.sym(n, np.size(options[n])) for n in derived.arguments(function)]
            out = derived.names[function](*symbols)
            compiled = ca.Function("f", symbols, [kind(value) for value in (out if isinstance(out, tuple) else (out,))])
            values = compiled.call([ca.DM(options[n]) for n in derived.arguments(function)])
            for a, b in zip(numbers, values, strict=True):
                assert a.full().reshape(-1) == pytest.approx(b.full().reshape(-1), rel=2e-14, abs=0)
    for pair, _ in derived.PAIRS:
        friction = any(kind == "friction" for _, kind, _ in derived.EFFECTS)
        shapes = [value.size for value in derived.call(f"contact_{pair}", **options)]
        assert shapes[:5] == [nf, nz, 1, int(friction), 1]  # set-valued friction has four more
    assert [derived.MEMORY[i][0] for i in derived.DISSIPATED] == [f"{pair}.dissipated" for pair, _ in derived.PAIRS]
    assert all(derived.PAIRS[pair][0] == latch.split(".")[0] for latch, _, pair in derived.LATCHES)
    assert np.all(derived.call("scales", p=derived.p)[0] > 0)


# -- nothing for nothing -----------------------------------------------------------------------------------------------
SCENES = Path(import_module("hertzwerk.derive.scenes").__file__).parent
QUICK = ("bouncing_ball", "two_spheres", "ball_between_walls", "slider_crank", "journal_in_bearing", "ball_in_socket")


def never_had(name, *effects):
    """A scene whose file never names these effects: run anew, with its list of effects cut before a scene is made of it."""
    if name == "slider_crank_frictionless":
        frictionless = never_had("slider_crank", "slider_pin_friction", *effects)
        return frictionless.named(name, scene_from(name).summary)
    tree = ast.parse((SCENES / f"{name}.py").read_text(encoding="utf-8"))
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and ast.unparse(node.func) == "Scene"]
    (given,) = [keyword for call in calls for keyword in call.keywords if keyword.arg == "effects"]
    left = f"tuple(effect for effect in {ast.unparse(given.value)} if effect.name not in {effects!r})"
    given.value = ast.parse(left, mode="eval").body
    names = {"__name__": f"{name} cut"}
    exec(compile(ast.fix_missing_locations(tree), name, "exec"), names)
    return names["scene"]


@pytest.mark.parametrize(
    "name", [*QUICK, *(pytest.param(n, marks=pytest.mark.exhaustive) for n in NAMES if n not in QUICK)]
)
def test_a_scene_without_an_effect_has_the_module_of_one_that_never_had_it(name):
    """Byte for byte, though the scene with it was derived before."""
    assert regenerated(name) == committed(name)
    scene = scene_from(name)
    for effect in scene.effects:
        with_it = [e.name for e in scene.all(Friction) if e.pair == effect.name]
        texts = [
            generate(s, f"derive/scenes/{name}.py")
            for s in (without(scene, effect.name), never_had(name, effect.name, *with_it))
        ]
        assert texts[0] == texts[1] != committed(name)


def without(scene, effect):
    """A scene without an effect and, where that is a contact, its friction."""
    return scene.without(effect, *(e.name for e in scene.all(Friction) if e.pair == effect))


# -- planar ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["slider_crank", "slider_crank_frictionless"])
def test_a_plane_mechanism_has_plane_equations(name):
    """Across the plane there are rates of turn, moments and inertias; no place, velocity or force."""
    across = set(re.findall(r"^    (\w+_z) = ", committed(name), re.M))
    assert across
    assert {n for n in across if not re.fullmatch(r"\w+(_torque|_I_z|_J_z)_z|(crank|rod|slider)_rate_z", n)} == set()
    along = set(re.findall(r"^    (\w+)_[xy] = ", committed(name), re.M))
    assert not {n for n in along if re.fullmatch(r"(crank|rod|slider)_(rate|spin)|\w+_torque", n)}
