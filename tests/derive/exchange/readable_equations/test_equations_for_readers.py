"""The equations people read say what the generated module computes, each effect where it acts; and they can be typeset."""

import math
import re

import numpy as np
import pytest
import sympy as sp
from derived import Derived

import hertzwerk.derive as hd
from hertzwerk.derive.declare.effects.state_expression import T as TIME
from hertzwerk.derive.exchange.readable_equations.equations_for_readers import equations_of
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.laws import LAWS, flores, power, smooth_coulomb
from hertzwerk.runtime.engine.model.build import built_in_scenes, scene_from
from reference.scenes import guarded_crank

BUILT_IN = built_in_scenes()


def spatial_arm():
    """Axes that are not parallel: nothing merges, and the results are long."""
    a, g = hd.Parameter("arm", "m", 0.3), hd.Parameter("gravity", "m/s^2", 9.81)
    m, j = hd.Parameter("mass", "kg", 2), hd.Parameter("inertia", "kg m^2", 0.01)
    links = [hd.Body(f"link_{i}", m, (j, 2 * j, 3 * j), centre=(a, a / 2, 0)) for i in range(3)]
    joints = (
        hd.Revolute("yaw", hd.GROUND, links[0], axis=hd.Z),
        hd.Revolute("pitch", links[0].at(a, 0, 0), links[1], axis=hd.Y),
        hd.Revolute("roll", links[1].at(0, a, a), links[2], axis=hd.X),
    )
    floor = hd.SphereOnPlane(
        "floor", links[2].at(a, 0, 0), hd.Parameter("radius", "m", 0.1), hd.GROUND.at(0, 0, -a), normal=hd.Z
    )
    effects = (
        hd.Gravity("gravity", g, -hd.Z),
        hd.Contact("floor", power(hd.Parameter("stiffness", "N/m^1.5", 1e6), 1.5), flores(hd.Parameter("restitution", "1", 0.8))),
        hd.Friction("grip", "floor", smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("v_s", "m/s", 0.1))), hd.EnergyLedger(),
    )  # fmt: skip
    return hd.Scene(
        hd.Mechanism("spatial_arm", joints, (floor,)), effects, hd.Scales(a, hd.Parameter("speed", "m/s", 1), arm=a)
    )


def tumbling():
    """A body on a quaternion above a floor, its mass centre off the point it is held at, with a pendulum on a ball joint."""
    a, m, g = hd.Parameter("arm", "m", 0.3), hd.Parameter("mass", "kg", 2), hd.Parameter("gravity", "m/s^2", 9.81)
    j = tuple(hd.Parameter(f"inertia_{k}", "kg m^2", value) for k, value in zip("xyz", (0.01, 0.02, 0.03), strict=True))
    body, bob = hd.Body("body", m, j, centre=(a, 0, 0)), hd.Body("bob", m, j, centre=(0, 0, -a))
    floor = hd.SphereOnPlane(
        "floor", body.at(0, 0, a), hd.Parameter("radius", "m", 0.1), hd.GROUND.at(0, 0, 0), normal=hd.Z
    )
    return hd.Scene(
        hd.Mechanism("tumbling", (hd.Free("float", hd.GROUND, body), hd.Spherical("ball", body.at(a, a, 0), bob)), (floor,)),
        (hd.Gravity("gravity", g, -hd.Z), hd.Contact("floor", power(hd.Parameter("stiffness", "N/m^1.5", 1e6), 1.5)), hd.EnergyLedger()),
        hd.Scales(a, hd.Parameter("speed", "m/s", 1), arm=a),
    )  # fmt: skip


def forced():
    """Two carts: one shaken, one on springs of equal stiffness, with a damper, a rubbing joint and a force in time."""
    m, k, w = hd.Parameter("mass", "kg", 2), hd.Parameter("stiffness", "N/m", 300), hd.Parameter("pace", "rad/s", 3)
    carts = [hd.Body(f"cart_{i}", m) for i in range(3)]
    joints = (
        hd.Prismatic("shaken", hd.GROUND, carts[0], axis=hd.X),
        hd.Prismatic("second", carts[0], carts[1], axis=hd.X),
        hd.Prismatic("third", carts[1], carts[2], axis=hd.X),
    )
    size, push = hd.Parameter("size", "m", 0.2), hd.Parameter("push", "N", 4)
    rub = smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("v_s", "m/s", 0.1))
    effects = (
        hd.Harmonic("shaker", "shaken", size, w), hd.JointSpring("near", "second", k), hd.JointSpring("far", "third", k),
        hd.JointDamper("damper", "second", hd.Parameter("damping", "N s/m", 5)),
        hd.JointFriction("rubbing", "third", rub, hd.Parameter("load", "N", 7)), hd.JointForce("pulling", "third", push * sp.sin(w * TIME)),
        hd.EnergyLedger(),
    )  # fmt: skip
    return hd.Scene(hd.Mechanism("forced", joints), effects, hd.Scales(size, hd.Parameter("speed", "m/s", 1)))


def with_friction(law):
    """The slider-crank with another law of friction, its parameters named as the law names them."""
    scene = scene_from("slider_crank")
    bound = LAWS[law](**{q.name: hd.Parameter(q.name, q.unit, 0.1) for q in LAWS[law].parameters})
    return scene.replace(slider_pin_friction=hd.Friction("slider_pin_friction", "slider_pin", bound)).named(law)


IN_CI = (
    "bouncing_ball", "slider_crank", "journal_lubricated", "ball_in_socket", "spatial_slider_crank", "coulomb",
    "lugre",
)  # fmt: skip


def in_ci(names):
    """Scenes that others resemble are shown by hand."""
    return [name if name in IN_CI else pytest.param(name, marks=pytest.mark.exhaustive) for name in names]


SCENES = {name: (lambda name=name: scene_from(name)) for name in BUILT_IN} | {
    "spatial_arm": spatial_arm, "two_pairs": lambda: guarded_crank(1), "tumbling": tumbling, "forced": forced,
    "coulomb": lambda: with_friction("coulomb"), "lugre": lambda: with_friction("lugre"),
}  # fmt: skip


@pytest.fixture(scope="module")
def read():
    made = {}

    def of(name):
        if name not in made:
            scene = SCENES[name]()
            made[name] = (equations_of(scene), Derived(scene))
        return made[name]

    return of


def number(expression, values):
    """Value of a SymPy expression by the names of its symbols; a choice takes its branch."""
    given = {symbol: sp.Float(values[symbol.name], 30) for symbol in expression.free_symbols}
    chosen = sp.sympify(expression).xreplace(given)
    while chosen.has(Where):
        chosen = chosen.replace(Where, lambda condition, a, b: a if bool(condition) else b)
    value = complex(sp.N(chosen, 25))
    assert value.imag == 0
    return value.real


def evaluated(shown, values):
    """Values of all symbols: what is given, and what the equations define from it."""
    values, waiting = dict(values), [e for e in shown.equations if not e.terms and e.expression is not None]
    while waiting:
        ready = [e for e in waiting if all(s.name in values for s in e.expression.free_symbols)]
        assert ready, [e.name for e in waiting]
        for equation in ready:
            values[equation.name] = number(equation.expression, values)
        waiting = [e for e in waiting if e not in ready]
    return values


def state(scene, derived, name, pair=None):
    """Random inputs by name, and the arguments of the module; in contact at `pair`."""
    rng = np.random.default_rng(sum(map(ord, name)))
    t, q, u = 0.003, rng.uniform(-1, 1, len(derived.COORDINATES)), rng.uniform(-2, 2, derived.nu)
    q0, _ = derived.start()
    q = q0 + 0.05 * q if derived.k else q
    if derived.k:
        q = derived.with_gap(t, q, pair or 0, 1e-5 if pair is None else -1e-5)
    m = np.full(len(derived.LATCHES), 0.7)
    return {"t": t, "q": q, "u": u, "m": m, "z": rng.uniform(-1e-5, 1e-5, len(derived.MEMORY))}


def by_name(scene, derived, at, **more):
    names = {"t": at["t"]}
    for table, key in (("COORDINATES", "q"), ("SPEEDS", "u"), ("LATCHES", "m"), ("MEMORY", "z")):
        names |= {row[0].replace(".", "_"): value for row, value in zip(getattr(derived, table), at[key], strict=True)}
    names |= {f"{row[0]}_sticking_force": math.nan for row in derived.PAIRS}  # nothing sticks here
    names |= {row[0]: value for row, value in zip(derived.PARAMETERS, derived.p, strict=True)}
    return names | more


def friction_added(f, value):
    """What friction with modes adds while it slides, to the forces and to the rates of memory."""
    if len(value) > 5:
        _, _, _, (speed,), _, along, rates_along, (sliding,), _ = value
        f -= sliding * np.sign(speed) * along
        yield -sliding * np.sign(speed) * rates_along


def cases():
    for name in SCENES:
        pairs = 2 if name == "ball_between_walls" else 0 if name == "double_pendulum" else 1
        yield name, None
        yield from ((name, pair) for pair in range(pairs))


@pytest.mark.by_turns(6)
@pytest.mark.parametrize(
    ("name", "pair"),
    [pytest.param(*case, marks=[] if case[0] in IN_CI else pytest.mark.exhaustive) for case in cases()],
)
def test_shown_equations_are_those_the_module_computes(read, name, pair):
    shown, derived = read(name)
    at = state(derived.scene, derived, name, pair)
    f = derived.call("applied", **at).copy()
    contacts = {row[0]: derived.results(f"contact_{row[0]}", at) for row in derived.PAIRS}
    contacts = {key: [np.array(v.full()).ravel() for v in value] for key, value in contacts.items()}
    f += sum(value[0] for value in contacts.values())  # none where the gap is open
    contacts = {key: [*value[:2], *friction_added(f, value)] for key, value in contacts.items()}
    a, reactions, *held = derived.call("accelerations", f=f, **at)
    held = {
        f"{row[0]}_multiplier".replace(".", "_"): v
        for row, v in zip(getattr(derived, "CONSTRAINTS", ()), *held, strict=True)
    }
    speeds = [row[0].replace(".", "_").replace("speed", "acceleration") for row in derived.SPEEDS]
    accelerations = dict(zip(speeds, a, strict=True))
    driven = [label.split(" ")[1] for label in (e.name for e in shown.equations if e.name.startswith("row "))][len(a) :]
    options = {f"{joint.replace('.', '_')}_reaction_in": value for joint, value in zip(driven, reactions, strict=True)}
    values = evaluated(shown, by_name(derived.scene, derived, at, **accelerations, **options, **held))

    gap, gap_rate = derived.call("gaps", **at) if derived.k else ([], [])
    for i, (key, _) in enumerate(derived.PAIRS):
        assert values[f"{key}_gap"] == pytest.approx(gap[i], rel=1e-9, abs=1e-15)
        assert values[f"{key}_gap_rate"] == pytest.approx(gap_rate[i], rel=1e-9, abs=1e-15)
    if derived.k:
        assert (values[f"{derived.PAIRS[pair or 0][0]}_normal_force"] == 0) is (pair is None)
    rounding = np.finfo(float).eps * np.abs(f).max()  # of other contacts' forces, in the rows of bodies in flight
    for row in (e for e in shown.equations if e.terms):
        sides = [[number(t.expression, values) for t in row.terms if t.left is left] for left in (True, False)]
        size = sum(map(abs, sides[0] + sides[1]))
        assert math.fsum(sides[0]) == pytest.approx(math.fsum(sides[1]), abs=1e-9 * size + rounding), row.name
    if hasattr(derived, "energy"):
        kinetic, potential, stored = derived.call("energy", **at)
        assert values["kinetic"] == pytest.approx(kinetic[0], rel=1e-12)
        assert values["potential"] == pytest.approx(potential[0], rel=1e-12, abs=1e-15)
        for (key, _), energy in zip(derived.PAIRS, stored, strict=True):
            assert values[f"{key}_stored_energy"] == pytest.approx(energy, rel=1e-7)
    if "constraints" in derived.names:
        for result, numbers in zip(("phi", "dphi"), derived.call("constraints", **at), strict=True):
            for (label, _), value in zip(derived.CONSTRAINTS, numbers, strict=True):
                assert values[f"{result} {label}"] == pytest.approx(value, rel=1e-9, abs=1e-14)
    if derived.MEMORY:
        rates = dict.fromkeys((row[0] for row in derived.MEMORY), 0.0)
        for result in (
            *(rate for c in contacts.values() for rate in c[1:]),
            derived.call("ledger", reactions=reactions, **at),
        ):
            for row, value in zip(derived.MEMORY, result, strict=True):
                rates[row[0]] += value
        for key, rate in rates.items():
            assert values.get(f"d/dt {key}", 0) == pytest.approx(rate, rel=1e-6, abs=1e-12), key


ENTERS = {
    "bouncing_ball": {
        "gravity": {"row vertical", "potential"},
        "floor": {"row vertical", "floor_gap", "floor_normal_force", "floor_elastic_force", "d/dt floor.dissipated"},
        "energy_ledger": {"d/dt floor.dissipated", "kinetic", "potential"},
    },
    "slider_crank": {
        "crank_drive": {"crank_angle", "row crank_pin", "row main_bearing", "d/dt energy_ledger.input"},
        "gravity": {"row crank_pin", "row main_bearing", "potential"},
        "slider_pin": {"row crank_pin", "row guide", "row main_bearing", "slider_pin_gap", "slider_pin_K", "slider_pin_normal_force"},
        "slider_pin_friction": {"row crank_pin", "row guide", "slider_pin_friction_force", "slider_pin_sliding_velocity"},
        "energy_ledger": {"d/dt energy_ledger.input", "d/dt slider_pin.dissipated", "d/dt slider_pin_friction.dissipated"},
    },
}  # fmt: skip
FOREIGN = {
    "gravity": {"row guide", "slider_pin_gap"},
    "slider_pin_friction": {"slider_pin_normal_force", "slider_pin_K", "slider_pin_gap"},
}


@pytest.mark.parametrize("name", in_ci(BUILT_IN))
def test_every_effect_is_listed_with_the_equations_it_enters(read, name):
    shown, derived = read(name)
    assert [effect.name for effect in shown.effects] == [row[0] for row in derived.EFFECTS]
    for effect in shown.effects:
        entered = {shown[number].name for number in effect.enters}
        assert entered
        assert ENTERS.get(name, {}).get(effect.name, set()) <= entered
        assert not FOREIGN.get(effect.name, set()) & entered or name != "slider_crank"
        assert entered == {e.name for e in shown.equations if effect.name in e.effects}
    numbers = [equation.number for equation in shown.equations]
    assert numbers == list(range(1, len(numbers) + 1))


def test_effects_that_share_a_parameter_are_distinguished(read):
    """Both walls have the same stiffness and restitution."""
    shown, _ = read("ball_between_walls")
    assert "left_wall" not in shown["right_wall_elastic_force"].effects
    assert "right_wall" not in shown["d/dt left_wall.dissipated"].effects
    assert [term.effect for term in shown["row track"].terms if not term.left] == ["left_wall", "right_wall"]


def across(direction):
    """A ball on a plane track, pulled along `direction`."""
    scene = scene_from("bouncing_ball")
    return scene.replace(gravity=hd.Gravity("gravity", scene.effect("gravity").acceleration, direction=direction))


def test_an_effect_that_enters_nothing_is_refused_but_a_locked_joint_is_none():
    assert equations_of(across(-hd.Y))
    with pytest.raises(hd.InputError, match="effect gravity: found no equation that it enters"):
        equations_of(across(hd.Z))
    one = hd.Body("one", hd.Parameter("m_1", "kg", 1))
    two = hd.Body("two", hd.Parameter("m_2", "kg", 1))
    joints = (hd.Prismatic("a", hd.GROUND, one, axis=hd.X), hd.Prismatic("b", one, two, axis=hd.X))
    effects = (hd.ConstantSpeed("lock", "b", 0), hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.X))
    scales = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("v", "m/s", 1))
    shown = equations_of(hd.Scene(hd.Mechanism("locked", joints), effects, scales))
    assert shown[1].name == "row a"


def test_an_inconsistent_scene_is_refused_in_its_own_words_unless_unchecked():
    scene = scene_from("bouncing_ball")
    wrong = hd.Contact("floor", power(hd.Parameter("wrong_stiffness", "N/m", 1e6), 1.7))
    with pytest.raises(hd.InputError) as raised:
        equations_of(scene.replace(floor=wrong))
    assert "consistent" in str(raised.value)
    assert "mark_" not in str(raised.value)
    scene = scene_from("soft_ball")
    wrong = hd.Contact("floor", power(hd.Parameter("wrong_stiffness", "N/m", 1e6), 1.7), unchecked=True)
    assert "UNCHECKED" in equations_of(scene.replace(floor=wrong)).markdown()


LONG = 400  # characters of a formula that mathtext takes too long for

# -- typeset -----------------------------------------------------------------------------------------------------------


def pieces(latex):
    """What mathtext can typeset of it: the lines of an alignment and of a choice, one by one."""
    for line in re.split(r"\\\\\n", re.sub(r"\\(begin|end)\{aligned\}\n?", "", latex)):
        line = re.sub(r"\\begin\{cases\}(.*)\\end\{cases\}", lambda m: m[1].replace("\\\\", r"\quad "), line)
        yield line.replace("&", " ").strip()


def shape(latex):
    """A formula up to the names in its indices and its digits."""
    return re.sub(r"\d+", "1", re.sub(r"\\mathrm\{[^{}]*\}", "i", latex))


TYPESET = set()  # shapes; of two scenes that share a mechanism most are the same


@pytest.mark.by_turns(9)
@pytest.mark.parametrize("name", in_ci(SCENES))
def test_every_formula_can_be_typeset(read, name):
    """One of each shape; the symbols themselves all."""
    from matplotlib.mathtext import MathTextParser

    shown, _ = read(name)
    parser = MathTextParser("path")
    for symbol in (*shown.states, *shown.parameters):
        parser.parse(f"${symbol.latex}$")
    for latex in [*(e.latex for e in shown.equations), *(s.latex for s in (*shown.states, *shown.parameters))]:
        assert latex.count("{") == latex.count("}")
        assert latex.count(r"\left") == latex.count(r"\right")
        assert "mark" not in latex
        for piece in pieces(latex) if len(latex) < LONG else ():
            if shape(piece) not in TYPESET:
                parser.parse(f"${piece}$")
                TYPESET.add(shape(piece))
    with pytest.raises(ValueError, match="Expected"):
        parser.parse(r"$\frac{1}{$")


@pytest.mark.parametrize("name", in_ci(SCENES))
def test_no_two_symbols_look_the_same(read, name):
    shown, _ = read(name)
    latex = [s.latex for s in (*shown.states, *shown.parameters)]
    latex += [e.latex.split(" ")[0] for e in shown.equations if e.name.isidentifier()]
    assert len(set(latex)) == len(latex)


def test_markdown_and_notebook(read):
    shown, _ = read("slider_crank")
    assert shown._repr_markdown_() == shown.markdown() == str(shown)
    assert shown.markdown().count("$$") == 2 * len(shown.equations)
    gap = shown["slider_pin_gap"]
    assert gap._repr_latex_() == r"$\displaystyle G = \frac{c^{2} - d_{x}^{2} - d_{y}^{2}}{2 c}$"
    assert shown[gap.number] is gap
    assert (gap.unit, gap.meaning) == ("m", "gap, positive while open")
    with pytest.raises(KeyError):
        shown["nothing"]
