"""Declarations: every bad one gives one clear error that lists all faults; variations of a scene are new scenes."""

import math
from dataclasses import replace

import pytest
import sympy as sp
from drop import BALL, BOUNCE, FALL, FLOOR, GRAVITY, RADIUS, SCALES, STIFFNESS, drop, heavy, refused
from each import each

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, hunt_crossley, lankarani_nikravesh, power, smooth_coulomb
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank

STRANGER = hd.Body("stranger", mass=hd.Parameter("stranger_mass", "kg", 1.0), inertia=hd.Parameter("J", "kg m^2", 1.0))


def turning(inertia, centre=(0, 0, 0)):
    """A scene whose body turns about z."""
    body = hd.Body("wheel", hd.Parameter("mass", "kg", 1.0), inertia, centre)
    return drop(joints=(hd.Revolute("axle", hd.GROUND, body, axis=hd.Z),), pairs=(), effects=(GRAVITY,))


def journal(clearance, bush=10):
    """A pin in a bush [mm]."""
    pair = hd.PinInBush(
        "pin", BALL.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Z, hd.Parameter("bush", "mm", bush), hd.Parameter("clearance", "mm", clearance),
    )  # fmt: skip
    return drop(pairs=(pair,), effects=(hd.Contact("pin", STIFFNESS),))  # fmt: skip


def stiff(K, n):
    return drop(effects=(hd.Contact("floor", power(K, n)),))


def bouncing(damping):
    return drop(effects=(hd.Contact("floor", STIFFNESS, damping),))


def parameter(name="mass", unit="kg", default=1.0):
    return hd.Parameter(name, unit, default)


BAD = {
    # what is declared: (how, where, found, expected)
    "unknown unit": (lambda: heavy(parameter(unit="kgg")), "mass", "'kgg'", "unit"),
    "unit that is ambiguous": (lambda: heavy(parameter(unit="Hz")), "mass", "'Hz'", "rad/s"),
    "unit of the wrong dimension": (lambda: heavy(parameter(unit="N")), "body ball, mass", "mass [N]", "kg"),
    "expression of the wrong dimension": (lambda: heavy(parameter() * RADIUS), "body ball, mass", "[kg m]", "kg"),
    "sum of two dimensions": (lambda: heavy(parameter() + RADIUS), "body ball, mass", "m", "kg"),
    "bare number": (lambda: heavy(1.5), "body ball, mass", "bare number 1.5", "Parameter('...', 'kg', 1.5)"),
    "bare number in a point": (
        lambda: drop(pairs=(replace(FLOOR, sphere=BALL.at(0, 0.2, 0)),)), "point of ball", "bare number 0.2", "m",
    ),
    "bare number in a scale": (lambda: drop(scales=replace(SCALES, length=0.1)), "scales, length", "bare number 0.1", "m"),
    "bare number for a stiffness": (
        lambda: drop(effects=(hd.Contact("floor", power(1e6, 1.5)),)), "floor, stiffness", "bare number 1000000", "N/m^n",
    ),
    "negative mass": (lambda: heavy(parameter(default=-1.0)), "body ball, mass", "-1 kg", "(0, inf)"),
    "negative expression": (lambda: heavy(parameter() - 3 * parameter()), "body ball, mass", "-2 kg", "(0, inf)"),
    "mass zero": (lambda: heavy(0), "body ball, mass", "0 kg", "(0, inf)"),
    "negative radius": (lambda: drop(pairs=(replace(FLOOR, radius=-RADIUS),)), "pair floor, radius", "-0.1 m", "(0, inf)"),
    "negative stiffness": (
        lambda: drop(effects=(hd.Contact("floor", power(hd.Parameter("K", "N/m^1.5", -1.0), 1.5)),)), "floor, stiffness", "-1", "(0, inf)",
    ),
    "negative inertia": (lambda: turning(hd.Parameter("J", "kg m^2", -1.0)), "body wheel, inertia", "-1 kg m^2", "[0, inf)"),
    "no inertia of a rotating body": (lambda: turning(0), "body wheel", "inertia 0", "positive"),
    "inertia that is zero at its default": (lambda: turning(hd.Parameter("J", "kg m^2", 0)), "body wheel", "inertia 0", "positive"),
    "inertia that is an expression of value zero": (
        lambda: turning(hd.Parameter("J", "kg m^2", 1) * hd.Parameter("nothing", "1", 0)), "body wheel", "inertia 0", "positive",
    ),
    "point mass on the axis it is turned about": (
        lambda: turning(0, (0, 0, parameter("l", "m"))), "body wheel", "inertia 0", "positive",
    ),
    "inertia triple of zeros": (lambda: turning((0, 0, 0)), "body wheel", "inertia 0", "positive"),
    "zero inertia of a body on a turning one": (
        lambda: drop(
            joints=(hd.Revolute("axle", hd.GROUND, STRANGER, axis=hd.Z), hd.Prismatic("slot", STRANGER, BALL, axis=hd.X)), pairs=(),
            effects=(GRAVITY,)
        ),
        "body ball", "inertia 0", "rotates",
    ),
    "clearance zero": (lambda: journal(0), "pair pin, clearance", "0 m", "(0, inf)"),
    "clearance negative": (lambda: journal(-0.1), "pair pin, clearance", "-0.0001 m", "(0, inf)"),
    "clearance above the bush's radius": (lambda: journal(12), "pair pin", "-0.002", "(0, inf)"),
    "restitution above one": (lambda: bouncing(flores(parameter("e", "1", 1.2))), "floor, coefficient of restitution", "1.2", "(0, 1]"),
    "restitution zero where the law divides by it": (lambda: bouncing(flores(0)), "floor, coefficient of restitution", "0", "(0, 1]"),
    "restitution negative": (lambda: bouncing(hunt_crossley(-0.1)), "floor, coefficient of restitution", "-0.1", "[0, 1]"),
    "restitution not a number": (lambda: bouncing(flores(math.nan)), "floor, coefficient of restitution", "nan", "finite"),
    "exponent below the law's range": (
        lambda: stiff(hd.Parameter("K", "N/m^0.5", 1.0), 0.5),
        "exponent", "0.5", "[1, 10]",
    ),
    "exponent with a unit": (
        lambda: drop(effects=(hd.Contact("floor", power(hd.Parameter("K", "N/m^n", 1.0), hd.Parameter("n", "m", 1.5))),)), "exponent", "n [m]", "1",
    ),
    "unit with an exponent that is no parameter": (
        lambda: drop(effects=(hd.Contact("floor", power(hd.Parameter("K", "N/m^bend", 1e6), 1.5)),)), "parameter K", "bend", "Parameter('bend', '1'",
    ),
    "default not a number": (lambda: heavy(parameter(default=math.nan)), "parameter mass", "nan", "finite"),
    "default infinite": (lambda: heavy(parameter(default=math.inf)), "parameter mass", "inf", "finite"),
    "default a truth value": (lambda: heavy(parameter(default=True)), "parameter mass", "True", "number"),
    "default a text": (lambda: heavy(parameter(default="1")), "parameter mass", "'1'", "number"),
    "name of a parameter": (lambda: heavy(parameter("my mass")), "parameter my mass", "'my mass'", "identifier"),
    "name of a parameter a keyword": (lambda: heavy(parameter("lambda")), "parameter lambda", "'lambda'", "keyword"),
    "a quantity as text": (lambda: heavy("1 kg"), "body ball, mass", "'1 kg'", "Parameter"),
    "name of a mechanism": (lambda: drop(name="my drop"), "mechanism", "'my drop'", "identifier"),
    "name of a joint": (lambda: drop(joints=(hd.Prismatic("my joint", hd.GROUND, BALL, axis=hd.Y),)), "joint", "'my joint'", "identifier"),
    "body connected to nothing": (
        lambda: drop(pairs=(replace(FLOOR, sphere=STRANGER.at(0, 0, 0)),)), "pair floor", "stranger", "joint connects",
    ),
    "joint naming a body not in the mechanism": (
        lambda: drop(joints=(FALL, hd.Prismatic("more", STRANGER, hd.Body("b", mass=parameter("m_b")), axis=hd.X))),
        "joint more", "stranger, which is not in the mechanism", "Connect stranger to the ground",
    ),
    "joints out of order": (
        lambda: drop(joints=(hd.Prismatic("fall", STRANGER, BALL, axis=hd.Y), hd.Prismatic("base", hd.GROUND, STRANGER, axis=hd.X))),
        "joint fall", "stranger, declared later", "from the ground outwards",
    ),
    "joint on itself": (
        lambda: drop(joints=(hd.Prismatic("fall", BALL, BALL, axis=hd.Y),)),
        "joint fall", "ball as parent and child", "two different bodies",
    ),
    "joints in a ring": (
        lambda: drop(joints=(hd.Prismatic("fall", STRANGER, BALL, axis=hd.Y), hd.Revolute("back", BALL, STRANGER, axis=hd.Z))),
        "joint fall", "stranger", "earlier joint",
    ),
    "ground as child": (lambda: drop(joints=(FALL, hd.Prismatic("down", BALL, hd.GROUND, axis=hd.Y))), "joint down", "ground as child", "a body"),
    "pair within one body": (
        lambda: drop(pairs=(hd.SphereOnSphere("floor", BALL.at(0, 0, 0), BALL.at(RADIUS, 0, 0), RADIUS, RADIUS),)),
        "pair floor", "ball", "two different bodies",
    ),
    "two parameters of one name": (lambda: heavy(parameter("g", "kg", 1.0)), "parameter g", "two different", "unique"),
    "two defaults of one name": (
        lambda: drop(scales=replace(SCALES, length=hd.Parameter("radius", "m", 0.2))), "parameter radius", "two different", "unique",
    ),
    "two bodies of one name": (
        lambda: drop(joints=(FALL, hd.Prismatic("side", BALL, hd.Body("ball", mass=parameter("other")), axis=hd.X))),
        "joint side", "second body named ball", "unique",
    ),
    "two joints of one name": (lambda: drop(joints=(FALL, hd.Prismatic("fall", BALL, STRANGER, axis=hd.X))), "joint fall",
    "2 of this name", "unique"),
    "two pairs of one name": (lambda: drop(pairs=(FLOOR, FLOOR)), "pair floor", "2 of this name", "unique"),
    "two effects of one name": (
        lambda: drop(effects=(GRAVITY, hd.ConstantSpeed("gravity", "fall", hd.Parameter("w", "m/s", 1.0)))), "effect gravity",
        "2 of this name", "unique",
    ),
    "two contacts of one pair": (lambda: drop(effects=(BOUNCE, BOUNCE)), "effect floor", "2 of this name", "unique"),
    "two ledgers": (lambda: drop(effects=(hd.EnergyLedger("one"), hd.EnergyLedger("two"))), "ledger of the scene", "2", "one"),
    "two gravities": (lambda: drop(effects=(GRAVITY, replace(GRAVITY, name="more"))), "gravity of the scene", "2", "one"),
    "two drives of one joint": (
        lambda: drop(
            joints=(FALL, hd.Prismatic("side", BALL, STRANGER, axis=hd.X)),
            effects=tuple(hd.ConstantSpeed(name, "fall", hd.Parameter("w", "m/s", 1.0)) for name in ("one", "two")),
        ),
        "drive of joint fall", "2", "one",
    ),
    "contact of a pair that is not there": (lambda: drop(effects=(hd.Contact("flor", STIFFNESS),)), "effect flor", "'flor'", "floor"),
    "drive of a joint that is not there": (
        lambda: drop(effects=(hd.ConstantSpeed("drive", "fal", hd.Parameter("w", "m/s", 1.0)),)), "effect drive", "'fal'", "fall",
    ),
    "drive of the wrong dimension": (
        lambda: drop(
            joints=(FALL, hd.Prismatic("side", BALL, STRANGER, axis=hd.X)), effects=(hd.ConstantSpeed("drive", "side", hd.Parameter("w",
            "rpm", 1.0)),)
        ),
        "effect drive, speed", "w [", "m/s",
    ),
    "drives everywhere": (
        lambda: drop(effects=(hd.ConstantSpeed("drive", "fall", hd.Parameter("w", "m/s", 1.0)),)), "effects", "every joint", "free",
    ),
    "friction without a contact": (
        lambda: drop(effects=(hd.Friction("rub", "floor", smooth_coulomb(0.1, hd.Parameter("v_s", "m/s", 1.0))),)), "effect rub",
        "floor", "normal force",
    ),
    "negative friction": (
        lambda: drop(effects=(BOUNCE, hd.Friction("rub", "floor", smooth_coulomb(-0.1, hd.Parameter("v_s", "m/s", 1.0))))),
        "effect rub, coefficient of friction", "-0.1", "[0, inf)",
    ),
    "approach floor zero": (
        lambda: drop(effects=(replace(BOUNCE, approach_floor=hd.Parameter("least", "m/s", 0.0)),)), "floor, approach floor", "0 m/s", "(0, inf)",
    ),
    "start of an unknown joint": (lambda: drop(start=hd.Start(position={"fal": RADIUS})), "start", "'fal'", "fall"),
    "start of the wrong dimension": (lambda: drop(start=hd.Start(speed={"fall": RADIUS})), "start, speed of fall", "radius [m]", "m/s"),
    "start of a driven joint": (
        lambda: replace(slider_crank, start=hd.Start(position={"main_bearing": 1})), "start", "main_bearing", "crank_pin",
    ),
    "angles without an arm": (
        lambda: replace(slider_crank, scales=replace(slider_crank.scales, arm=None)), "scales", "no arm", "arm",
    ),
    "exponent parameter not a number": (
        lambda: stiff(hd.Parameter("K", "N/m^bend", 1.0), hd.Parameter("bend", "1", math.nan)), "parameter bend", "nan", "finite",
    ),
    "exponent parameter with a unit": (
        lambda: stiff(hd.Parameter("K", "N/m^mass", 1.0), 1.5), "parameter K", "mass", "1",
    ),
    "a symbol that is no parameter": (lambda: stiff(sp.Symbol("K"), 1.5), "floor, stiffness", "K", ""),
    "complex at the defaults": (
        lambda: drop(scales=replace(SCALES, length=RADIUS * sp.sqrt(hd.Parameter("ratio", "1", 0.5) - 2))), "scales, length", "", "finite",
    ),
    "infinite at the defaults": (lambda: drop(scales=replace(SCALES, length=RADIUS / hd.Parameter("none", "1", 0))), "scales, length", "", "finite"),
    "a mass centre of two numbers": (lambda: heavy(parameter(), centre=(0, 0)), "body ball", "(0, 0)", "three"),
    "a law that is not called": (
        lambda: drop(effects=(hd.Contact("floor", power),)),
        "floor, stiffness", "power without its parameters", "power(K, n)",
    ),
    "a damping law as stiffness": (lambda: drop(effects=(hd.Contact("floor", flores(0.8)),)), "floor", "flores", "stiffness"),
}  # fmt: skip


def test_unvaried_declarations_are_sound():
    assert drop().name == "drop"
    assert heavy(parameter()).parameters["mass"].default == 1.0
    assert turning(hd.Parameter("J", "kg m^2", 1.0)).free[0].key == "axle"
    assert journal(0.1).parameters["clearance"].si == pytest.approx(1e-4)
    assert bouncing(lankarani_nikravesh(0.9)).contacts[0][0] is FLOOR


@each("label", BAD)
def test_a_bad_declaration_is_one_fault_that_says_where_what_and_the_way_out(label):
    refused(*BAD[label])


def test_all_faults_of_a_scene_come_at_once():
    ball = hd.Body("ball", mass=parameter(default=-1.0))
    wheel = hd.Body("wheel", mass=2.0, centre=(hd.Parameter("off", "mmm", 1.0), 0, 0))
    pin = hd.PinInBush(
        "pin", wheel.at(0, 0, 0), ball.at(0, 0, 0), hd.Z, hd.Parameter("bush", "kg", 1.0), hd.Parameter("clearance", "mm", 0),
    )  # fmt: skip
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("many", (FALL.__class__("fall", hd.GROUND, ball, axis=hd.Y), hd.Revolute("axle", STRANGER, wheel, axis=hd.Z)), (pin, pin)),
            (
                hd.Gravity("gravity", hd.Parameter("g", "m/s^2", math.inf), -hd.Y),
                hd.Contact("pin", power(hd.Parameter("stiff", "N/m^bend", 1.0), 1.5), flores(1.5)),
                hd.Contact("nowhere", STIFFNESS),
                hd.EnergyLedger(),
                hd.EnergyLedger(),
            ),
            hd.Scales(length=hd.Parameter("size", "m", 1.0), speed=3.0),
            hd.Start(position={"nothing": 0}),
        )  # fmt: skip
    text = str(caught.value)
    for piece in (
        "body ball, mass: found -1 kg", "the bare number 2.0", "'mmm'", "bush [kg]", "pair pin, clearance: found 0 m",
        "parent stranger", "pair pin, effect energy_ledger: found 2 of this name", "found default inf",
        "exponent bend", "coefficient of restitution of flores: found 1.5", "pair 'nowhere'",
        "effect energy_ledger: found 2", "the bare number 3.0", "joint 'nothing'", "no arm",
    ):  # fmt: skip
        assert piece in text, f"{piece!r} is not in\n{text}"
    assert "16 faults" in text  # that of the pair and the ledger, 2 of a name, is told once
    assert len(set(caught.value.faults)) == len(caught.value.faults)


def test_zeros_bare_angles_and_closed_limits_are_sound():
    scene = replace(slider_crank, start=hd.Start(position={"crank_pin": sp.pi / 6, "guide": 0}, speed={"crank_pin": 0}))
    assert scene.start.position["crank_pin"] == sp.pi / 6
    assert turning(0, (parameter("l", "m"), 0, 0))
    # Closed ends hold, open ones do not.
    assert bouncing(flores(1)).name == "drop"
    assert bouncing(hunt_crossley(0)).name == "drop"
    assert drop(effects=(hd.Contact("floor", power(hd.Parameter("K", "N/m", 1.0), 1)),)).name == "drop"


def test_a_value_outside_the_recommended_range_is_no_fault():
    """Lankarani and Nikravesh's law is recommended for restitutions near one; outside is the run's warning, not an error."""
    law = lankarani_nikravesh(hd.Parameter("restitution", "1", 0.1))
    assert law.law.recommended.lower == 0.8
    text = hd.generate(drop(effects=(hd.Contact("floor", STIFFNESS, law),)))
    assert '("restitution", "recommended", 0.8, 1, True, False,' in text
    assert '("restitution", "defined", 0, 1, False, False,' in text


# -- parameters and laws -----------------------------------------------------------------------------------------------


def test_parameters_differ_by_everything_declared_and_laws_are_bound_by_name_or_by_place():
    assert hd.Parameter("r", "mm", 5) == hd.Parameter("r", "mm", 5)
    others = (
        hd.Parameter("r", "m", 5), hd.Parameter("r", "mm", 6), hd.Parameter("r", "mm", 5, "of the pin"), hd.Parameter("R", "mm", 5),
    )  # fmt: skip
    assert len({hd.Parameter("r", "mm", 5), *others}) == 5
    assert hd.Parameter("r", "mm", 5).si == pytest.approx(0.005)
    assert sp.diff(hd.Parameter("r", "mm", 5) ** 2, hd.Parameter("r", "mm", 5)) == 2 * hd.Parameter("r", "mm", 5)
    K, n = hd.Parameter("K", "N/m^1.5", 1.0), sp.Rational(3, 2)
    assert power(K, n) == power(K, n=1.5) == power(n=1.5, K=K)
    with pytest.raises(TypeError, match="not expected"):
        power(K, n, m=1)


# -- variations --------------------------------------------------------------------------------------------------------


def names(scene):
    return [effect.name for effect in scene.effects]


def test_without_gives_a_new_scene_or_says_what_needs_the_effect():
    before = names(slider_crank)
    lean = slider_crank.without("slider_pin_friction", "gravity")
    assert names(lean) == ["crank_drive", "slider_pin", "energy_ledger"]
    assert names(slider_crank) == before
    assert "gravity" not in lean.parameters
    assert "friction_speed" not in lean.parameters
    assert lean.mechanism is slider_crank.mechanism
    with pytest.raises(hd.InputError) as caught:
        slider_crank.without("nope", "gravity", "neither")
    assert [fault.where for fault in caught.value.faults] == ["nope", "neither"]
    assert all("crank_drive" in fault.expected for fault in caught.value.faults)
    with pytest.raises(hd.InputError, match="Friction needs a normal force"):
        slider_crank.without("slider_pin")
    assert "slider_pin" not in names(slider_crank.without("slider_pin", "slider_pin_friction"))
    assert [freedom.key for freedom in slider_crank.free] == ["crank_pin", "guide"]
    assert [freedom.key for freedom in slider_crank.without("crank_drive").free] == [
        "main_bearing", "crank_pin", "guide",
    ]  # fmt: skip


def test_replace_and_with_law_exchange_one_effect():
    contact = hd.Contact("slider_pin", STIFFNESS, flores(hd.Parameter("restitution", "1", 0.9)))
    scene = slider_crank.replace(slider_pin=contact)
    assert scene.effect("slider_pin") is contact
    assert names(scene) == names(slider_crank)
    assert slider_crank.effect("slider_pin") is not contact
    with pytest.raises(hd.InputError, match="nope: found no effect of this name"):
        slider_crank.replace(nope=contact)
    scene = slider_crank.with_law("slider_pin", "flores")
    old, new = slider_crank.effect("slider_pin"), scene.effect("slider_pin")
    assert new.damping.law is flores
    assert new.damping.values == old.damping.values
    assert new.stiffness == old.stiffness
    assert list(scene.parameters) == list(slider_crank.parameters)


@pytest.mark.parametrize(
    ("effect", "law", "message"),
    [
        ("slider_pin", "hertz", "hertz_point"), ("slider_pin", "smooth_coulomb", "name of a stiffness or damping law"),
        ("slider_pin_friction", "flores", "smooth_coulomb"), ("gravity", "flores", "an effect that has a law"),
        ("slider_pin", "power", r"K \[N/m\^n\]"), ("nope", "flores", "nope: found no effect of this name"),
    ],
)  # fmt: skip
def test_a_law_that_does_not_fit_is_refused(effect, law, message):
    with pytest.raises(hd.InputError, match=message):
        slider_crank.with_law(effect, law)


def test_named_changes_name_and_summary_alone():
    scene = slider_crank.named("other", "another one")
    assert (scene.name, scene.summary) == ("other", "another one")
    assert slider_crank.named("other").summary == slider_crank.summary
    assert scene.effects == slider_crank.effects
    with pytest.raises(hd.InputError, match="'not a name'"):
        slider_crank.named("not a name")


@pytest.mark.parametrize("kind", ["spheres", "pin"])
def test_text_as_a_radius_or_a_mass_of_a_pair_is_a_fault_and_never_evaluated(kind, tmp_path):
    """What the pair's geometry is computed from: text there is reported with everything else, and not handed to SymPy."""
    mark = tmp_path / "executed"
    one, two = hd.Body("one", mass=f"__import__('pathlib').Path({str(mark)!r}).touch()"), hd.Body("two", mass="1 kg")
    places = (one.at(0, 0, 0), two.at(0, 0, 0))
    pair = (
        hd.SphereOnSphere("pair", *places, "1 m", "2 m")
        if kind == "spheres"
        else hd.PinInBush("pair", *places, hd.Z, "2 m", "1 m")
    )
    K = hd.Parameter("stiffness", "N/m^1.5", 1e6)
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("two", (hd.Prismatic("a", hd.GROUND, one, hd.X), hd.Prismatic("b", hd.GROUND, two, hd.X)), (pair,)),
            (hd.Contact("pair", power(K, 1.5)),), hd.Scales(length=hd.Parameter("size", "m", 1), speed=hd.Parameter("pace", "m/s", 1)),
        )  # fmt: skip
    assert {fault.found for fault in caught.value.faults} >= {"'1 kg'", "'1 m'", "'2 m'"}
    assert not mark.exists()
