"""The unit audit of scenes: what is refused and how it is said, what runs on purpose, and a second test without symbols."""

import inspect
from functools import cached_property, partialmethod

import numpy as np
import pytest
import sympy as sp
from derived import Derived

from hertzwerk.derive import Contact, Parameter, audit_scene, derive, generate
from hertzwerk.derive.audit.audit import InconsistentUnits, audit_program
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.effects.elasticity.rod_elasticity import RodElasticity
from hertzwerk.derive.equations.contact.pairs.on_plane import Face
from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import RoundTouch
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.contact.worn_surfaces import Worn, WornContour, WornTrack
from hertzwerk.derive.equations.derivation import derivation_of
from hertzwerk.derive.equations.flexible.rod_bending import RodBending
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.motion.equations_of_motion import Equations
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import dot, scale
from hertzwerk.derive.laws import LAWS, hunt_crossley, lankarani_nikravesh, power
from hertzwerk.derive.scenes import NAMES
from hertzwerk.derive.scenes.ball_between_walls import scene as walls
from hertzwerk.derive.scenes.bouncing_ball import scene as ball
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime.engine.model.build import scene_from

cylinders = LAWS["lankarani_nikravesh_cylinders"]
E_NU = slider_crank.effect("slider_pin").stiffness.values
E = Parameter("restitution", "1", 0.9)


def wrong(unchecked=False, n=1):
    """The slider-crank with the cylinder law at an exponent."""
    return slider_crank.replace(
        slider_pin=Contact("slider_pin", cylinders(*E_NU, n), lankarani_nikravesh(E), unchecked=unchecked)
    )


def refusal(scene):
    with pytest.raises(InconsistentUnits) as caught:
        derive(scene)
    return caught.value


# -- an inconsistent law is refused, and the message teaches -----------------------------------------------------------


def test_a_hertz_stiffness_with_exponent_one_is_refused_with_the_lesson():
    text = str(refusal(wrong()))
    head, first, *_ = text.split("\n\n")
    assert head.startswith("derive slider_crank: ")
    assert head.endswith("nothing written")
    assert first.startswith("slider_pin, normal force: Lankarani-Nikravesh law for cylinders (1994), n = 1\n")
    for piece in (
        "K*d**n", "K [N/m^1.5]", "(4/3)*E_eff*sqrt(R_eff)", "d [m]", "penetration", "found N/m^0.5, expected N\n",
        "K is N/m^1.5: K*d**n is a force only for n = 3/2", "Either keep n = 3/2", "Contact(..., unchecked=True)",
    ):  # fmt: skip
        assert piece in first, f"{piece!r} is not in\n{first}"


@pytest.mark.parametrize(
    ("unit", "n", "found", "right"),
    [("N/m^1.5", 1, "N/m^0.5", "3/2"), ("N/m", 1.5, "N m^0.5", "1"), ("Pa", 1, "N/m", "2"), ("N/m^1.2", 1.1, "N/m^0.1", "6/5")],
)  # fmt: skip
def test_the_message_solves_for_the_exponent(unit, n, found, right):
    error = refusal(slider_crank.replace(slider_pin=Contact("slider_pin", power(Parameter("K", unit, 1e9), n))))
    force = error.findings[0]
    assert (force.effect, force.quantity, force.law, force.verdict) == (
        "slider_pin", "normal force", "power", "inconsistent",
    )  # fmt: skip
    assert (force.found, force.expected, force.consistent_exponent) == (found, "N", right)


def test_a_symbolic_exponent_passes_if_the_unit_names_it_and_not_if_it_names_another():
    K, n, other = Parameter("K", "N/m^bend", 1e9), Parameter("bend", "1", 1.5), Parameter("other", "1", 1.5)
    good = slider_crank.replace(slider_pin=Contact("slider_pin", power(K, n)))
    assert all(finding.verdict == "consistent" for finding in audit_scene(good))
    both = walls.replace(left_wall=Contact("left_wall", power(K, n)), right_wall=Contact("right_wall", power(K, other)))
    force = refusal(both).findings[0]
    assert force.effect == "right_wall"
    assert force.quantity == "normal force"
    assert "bend" in force.found
    assert "other" in force.found


def test_all_inconsistent_laws_of_a_scene_are_listed():
    K = walls.parameters["stiffness"]
    scene = walls.replace(
        left_wall=Contact("left_wall", power(K, 1.5), hunt_crossley(0.9)), right_wall=Contact("right_wall", power(K, 2))
    )
    error = refusal(scene)
    assert [(f.effect, f.quantity) for f in error.findings] == [
        (wall, "normal force") for wall in ("left_wall", "right_wall")
    ]
    assert len(error.faults) == 2
    assert str(error).startswith("derive ball_between_walls: 2 unit errors, nothing written")
    assert all(f"{wall}, normal force: Power law" in str(error) for wall in ("left_wall", "right_wall"))


# -- unchecked ---------------------------------------------------------------------------------------------------------


def test_an_unchecked_law_runs_and_says_so_everywhere():
    scene = wrong(unchecked=True)
    text = generate(scene)
    header = text.split('"""')[1]
    assert "UNCHECKED" in header
    assert "slider_pin" in header[header.index("Units: ") :]
    assert "all consistent" not in header
    derived = Derived(text=text)
    assert [effect for effect, _ in derived.UNCHECKED] == ["slider_pin"]
    at = {"t": 1e-4, "q": derived.with_gap(1e-4, derived.start()[0], 0, -1e-5), "u": derived.start()[1], "m": [1.0]}
    force = derived.call("contact_slider_pin", **at)[2]
    e = derived.call("outputs", **at)
    K = 4 / 3 * 207e9 / (2 * 0.91) * np.sqrt(0.01 * 0.0095 / 0.0005)
    elastic = K * (np.hypot(*e) - 0.0005)  # in SI values: K d
    assert 0.5 * elastic < force[0] < 1.5 * elastic
    assert {finding.verdict for finding in audit_scene(scene)} == {"consistent", "unchecked"}


def test_unchecked_excuses_its_own_law_alone():
    K = walls.parameters["stiffness"]
    scene = walls.replace(
        left_wall=Contact("left_wall", power(K, 1.5), unchecked=True), right_wall=Contact("right_wall", power(K, 2))
    )
    assert {finding.effect for finding in refusal(scene).findings} == {"right_wall"}


# -- seeded faults in the derivation -----------------------------------------------------------------------------------


def seed(monkeypatch, owner, name, fault):
    """Exchange one step of the derivation for `fault(original, self, ...)`."""
    original = inspect.getattr_static(owner, name)
    function = getattr(original, "func", original)
    patched = partialmethod(lambda self, *args, **named: fault(function, self, *args, **named))
    if hasattr(original, "func"):
        patched = cached_property(lambda self: fault(function, self))
        patched.__set_name__(owner, name)
    monkeypatch.setattr(owner, name, patched)


def no_arm(gravity, self, row):
    link = self.link_of[row]
    return dot(link.axis, scale(self.recursion.mass(link), self._gravity_vector())) + 1


SEEDED = {
    # step: (owner, name, fault, what the first finding names)
    "penetration instead of its rate": (Touch, "penetration_rate", lambda f, self: self.penetration, "slider_pin_normal_force"),
    "a gap in millimetres": (RoundTouch, "gap", lambda f, self: self.let(1000 * f(self) + 1, "gap"), "slider_pin_gap"),
    "a gap squared": (RoundTouch, "gap", lambda f, self: self.let(f(self) ** 2, "gap"), "output gaps.G[slider_pin]"),
    "gravity without its arm": (Equations, "gravity", no_arm, "output applied.f[crank_pin]"),
    "no inertia in the bias": (Equations, "bias", lambda f, self, row: row.speed**2, "crank_pin_net"),
    "kinetic energy with a speed once": (
        Equations, "kinetic", lambda f, self: sp.Add(*(b.mass * self.kin.motion(b).velocity[0] for b in self.scene.mechanism.bodies)),
        "output energy.kinetic[kinetic]",
    ),
    "a velocity as an acceleration": (
        Kinematics, "point", lambda f, self, *a: (*f(self, *a)[:2], f(self, *a)[1]), "slider_pin",
    ),
    "an arm added to a force": (
        Touch, "contact_point", lambda f, self: tuple(a + n for a, n in zip(self.position, self.normal, strict=True)),
        "slider_pin_drag_on",
    ),
    "a result under the wrong unit": (
        System, "of_pairs", lambda f, self, name, unit, values: f(self, name, {"m/s": "rad/s"}.get(unit, unit), values),
        "output gaps.dG[slider_pin]",
    ),
}  # fmt: skip


@pytest.mark.parametrize("label", SEEDED)
def test_a_wrong_step_of_the_derivation_is_refused_by_name(label, monkeypatch):
    owner, name, fault, named = SEEDED[label]
    seed(monkeypatch, owner, name, fault)
    error = refusal(slider_crank)
    assert any(named in finding.quantity for finding in error.findings), str(error)
    assert "nothing written" in str(error)


TWINS = {
    # law: (scene, owner, name, twin); those of the catalogue have theirs in test_catalogue.py
    "wear by force times the square of the speed": ("worn_track", Worn, "progress", lambda f, self, force, v: f(self, force, v**2)),
    "wear by force alone": ("worn_track", Worn, "progress", lambda f, self, force, v: f(self, force, 1)),
    "a track as long as it is broad, squared": ("worn_track", WornTrack, "area", lambda f, self, label: f(self, label) ** 2),
    "a sector without its length": ("worn_slider_crank", WornContour, "area", lambda f, self, label: f(self, label) / self.touch.pair.length),
    "a rod by E I over the square of its length": (
        "flexible_slider_crank", RodElasticity, "_named", lambda f, self, kin, unit, *rest: f(self, kin, unit * self.rod.length, *rest),
    ),
    "a rod's kinetic energy times its length": ("flexible_slider_crank", RodBending, "kinetic", lambda f, self: f(self) * self.rod.length),
}  # fmt: skip


@pytest.mark.parametrize("label", TWINS)
def test_a_wrong_twin_of_a_law_is_refused(label, monkeypatch):
    name, owner, method, twin = TWINS[label]
    seed(monkeypatch, owner, method, twin)
    assert "nothing written" in str(refusal(scene_from(name)))


@pytest.mark.parametrize("name", ["bouncing_ball", "two_spheres"])
def test_no_assignment_can_be_wrong_unnoticed(name):
    """Every assignment of a program in turn times a length: the audit must find it, there or where it ends up."""
    program = derivation_of(scene_from(name))
    length = program.scene.parameters["radius"]
    tape = program.tape.assignments
    for symbol, expression in list(program.assignments()):
        if symbol in program.tape.declared:
            continue
        tape[symbol] = expression * length
        assert audit_program(program)[1], f"{symbol} = {expression}*{length} passes"
        tape[symbol] = expression
    assert audit_program(program)[1] == ()


def test_one_wrong_assignment_is_one_finding_not_a_flood():
    program = derivation_of(slider_crank)
    symbol = next(s for s in program.tape.assignments if s.name == "rod_arm_x")
    program.tape.assignments[symbol] = program.tape.assignments[symbol] + 1  # a number beside a length
    _, findings = audit_program(program)
    assert [finding.quantity for finding in findings] == ["assignment rod_arm_x"]


# -- the second test, without symbols: other units of mass, length and time ---------------------------------------------


class Rescaled:
    """A scene's functions, in SI and in units in which mass, length and time measure `factors` times as much."""

    def __init__(self, scene):
        self.program = derive(scene)
        self.derived = Derived(scene)
        self.defaults = {name: default for name, _, default, _ in self.derived.PARAMETERS}

    def factor(self, unit, factors):
        """How much the number of a quantity of this unit grows."""
        total = 1.0
        for exponent, factor in zip(parse_unit(unit).exponents, factors, strict=False):
            power = float(exponent.constant) + sum(float(c) * self.defaults[name] for name, c in exponent.terms)
            total *= factor**power
        return total

    def units(self, group):
        """Units of the entries of one argument."""
        table = {"q": "COORDINATES", "u": "SPEEDS", "z": "MEMORY", "m": "LATCHES", "p": "PARAMETERS"}.get(group)
        if table:
            return [row[1] for row in getattr(self.derived, table)]
        if group == "t":
            return ["s"]
        if group == "a":
            return [f"{unit}^2" if unit == "1/s" else f"({unit})/s" for unit in self.units("u")]
        if group == "wanted" and all(f.name != "constraints" for f in self.program.functions):
            return []
        function, result = {"f": ("applied", 0), "reactions": ("accelerations", 1), "wanted": ("constraints", 1)}[group]
        return list(self.results(function)[result].units)

    def results(self, function):
        return next(f.results for f in self.program.functions if f.name == function)

    def scaled(self, group, values, factors):
        return np.atleast_1d(values) * [self.factor(unit, factors) for unit in self.units(group)]

    def pairs(self):
        """Places of the pairs that have a function each: the first of those that share one, as the balls of a box."""
        alike = {name for _, members in self.derived.names.get("FAMILIES", ()) for name, *_ in members[1:]}
        return [k for k, (name, *_) in enumerate(self.derived.PAIRS) if name not in alike]

    def states(self, seed=1):
        """Arguments at random states: each kind of contact in contact and just open, and four times wherever the state falls."""
        rng = np.random.default_rng(seed)
        derived = self.derived
        sq, su, sz, s = derived.call("scales", p=derived.p)
        q0, u0 = derived.start()
        targets = [(pair, sign * 0.3 * s[0]) for pair in self.pairs() for sign in (-1, 1)]
        for pair, target in [*targets, *[(None, 0)] * 4]:
            t = rng.uniform(0, 10) * s[0] / s[1]
            q = q0 + rng.normal(size=q0.size) * sq
            if pair is not None:
                t, q = self.with_gap(rng, t, q, pair, target)
            yield {
                "t": t, "q": q, "u": u0 + rng.normal(size=u0.size) * su, "z": rng.normal(size=sz.size) * s[3],
                "m": rng.uniform(0.5, 2, len(derived.LATCHES)) * s[1], "a": rng.normal(size=u0.size) * s[1],
                "f": rng.normal(size=len(self.units("f"))) * s[2], "reactions": rng.normal(size=len(self.units("reactions"))) * s[2],
                "wanted": rng.normal(size=len(self.units("wanted"))) * s[1],
            }  # fmt: skip

    def with_gap(self, rng, t, q, pair, target):
        """Time and coordinates at which a pair has a gap: later and later, where a drive has to bring it near first."""
        for _ in range(20):
            try:
                return t, self.derived.with_gap(t, q, pair, target)
            except AssertionError:
                t *= rng.uniform(1, 2)
        raise AssertionError(f"no time found at which pair {pair} has a gap of {target}")

    def disagreement(self, factors):
        """Largest relative difference over all functions and states between the rescaled run and the rescaled results, and where."""
        other = Derived(text=self.derived.text)
        p = self.scaled("p", self.derived.p, factors)
        c = other.call("constants", p=p)
        worst = (0.0, "")
        for state in self.states():
            there = {"p": p, "c": c, **{group: self.scaled(group, values, factors) for group, values in state.items()}}
            for function in self.program.functions:
                if function.name == "constants":
                    continue
                here = self.derived.results(function.name, state)
                moved = other.results(function.name, there)
                for result, a, b in zip(function.results, here, moved, strict=True):
                    a, b = (np.array(value.full()).reshape(-1) for value in (a, b))
                    drawn = ["m"] * (a.size - len(result.units) + 1)  # points of a curve, many in one entry
                    units = [unit for entry in result.units for unit in ([entry] if entry else drawn)]
                    expected = a * [self.factor(unit, factors) for unit in units]
                    for unit in set(units):  # rounding is relative to the largest entry of the same unit
                        rows = [k for k, other_unit in enumerate(units) if other_unit == unit]
                        off = np.max(np.abs(b[rows] - expected[rows])) / (np.max(np.abs(expected[rows])) or 1.0)
                        worst = max(worst, (float(off), f"{function.name}.{result.name} [{unit}]"))
        return worst


FACTORS = {"mass": (2, 1, 1), "length": (1, 3, 1), "time": (1, 1, 5), "together": (2, 3, 5), "the other way": (7, 5, 3)}


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=[pytest.mark.exhaustive] * (name == "ball_bearing")) for name in NAMES],
)
def rescaled(request):
    return Rescaled(scene_from(request.param))


@pytest.mark.by_turns(12)
@pytest.mark.parametrize(
    "factors", [pytest.param(factors, id=name, marks=[] if name == "together" else pytest.mark.exhaustive) for name, factors in FACTORS.items()],
)  # fmt: skip
def test_consistent_scenes_do_not_depend_on_the_units(rescaled, factors):
    """Penetrations of 1e-4 m are differences of 0.1 m: rounding leaves 1e-12 of them, and forces go with their power.

    At states where redundant constraints contradict each other rounding is divided by what their equations are raised by, 3e-9.
    """
    off, where = rescaled.disagreement(factors)
    assert off < (1e-5 if rescaled.derived.NAME == "flyball_governor" else 1e-10), where


def test_an_inconsistent_law_does_depend_on_the_units():
    """The unchecked cylinder law with n = 1: its force is K d in SI values, something else in other units."""
    bad = Rescaled(wrong(unchecked=True))
    off, where = bad.disagreement(FACTORS["length"])
    assert off > 0.1
    assert "contact_slider_pin" in where or "energy.stored" in where
    assert bad.disagreement(FACTORS["mass"])[0] < 1e-10  # K is right in mass and time
    right = Rescaled(wrong(unchecked=True, n=sp.Rational(3, 2)))
    assert right.disagreement(FACTORS["length"])[0] < 1e-10


def test_a_hidden_length_is_found_by_both_tests(monkeypatch):
    """A number that stands for a metre, and whose sum the audit refuses, also breaks the rescaled run."""
    text = Derived(ball).text.replace(
        "floor_gap = vertical_travel - radius", "floor_gap = vertical_travel - radius - 0.001"
    )
    bad = Rescaled(ball)
    bad.derived = Derived(text=text)
    assert bad.disagreement(FACTORS["length"])[0] > 1e-3
    seed(monkeypatch, Face, "gap", lambda f, self: self.let(f(self) - sp.Float(0.001), "gap"))
    assert any("floor_gap" in finding.quantity for finding in refusal(ball).findings)
