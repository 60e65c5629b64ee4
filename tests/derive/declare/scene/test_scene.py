"""Declarations: every bad one gives one clear error that lists all faults; variations of a scene are new scenes."""

import math
from dataclasses import replace

import pytest
import sympy as sp
from drop import BALL, BOUNCE, FALL, FLOOR, GRAVITY, RADIUS, SCALES, STIFFNESS, drop, refused
from each import each

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    InputError,
    Mechanism,
    Parameter,
    PinInBush,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    SphereOnSphere,
    Start,
    X,
    Y,
    Z,
    generate,
)
from hertzwerk.derive.laws import flores, hunt_crossley, lankarani_nikravesh, power, smooth_coulomb
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank

STRANGER = Body("stranger", mass=Parameter("stranger_mass", "kg", 1.0), inertia=Parameter("J", "kg m^2", 1.0))


def heavy(mass, **body):
    """The scene with another mass, or another body altogether."""
    ball = Body("ball", mass=mass, **body)
    floor = SphereOnPlane("floor", ball.at(0, 0, 0), RADIUS, GROUND.at(0, 0, 0), normal=Y)
    return drop(joints=(Prismatic("fall", GROUND, ball, axis=Y),), pairs=(floor,))


def turning(inertia, centre=(0, 0, 0)):
    """A scene whose body turns about z."""
    body = Body("wheel", Parameter("mass", "kg", 1.0), inertia, centre)
    return drop(joints=(Revolute("axle", GROUND, body, axis=Z),), pairs=(), effects=(GRAVITY,))


def journal(clearance, bush=10):
    """A pin in a bush [mm]."""
    pair = PinInBush(
        "pin",
        BALL.at(0, 0, 0),
        GROUND.at(0, 0, 0),
        Z,
        Parameter("bush", "mm", bush),
        Parameter("clearance", "mm", clearance),
    )
    return drop(pairs=(pair,), effects=(Contact("pin", STIFFNESS),))  # fmt: skip


def stiff(K, n):
    return drop(effects=(Contact("floor", power(K, n)),))


def bouncing(damping):
    return drop(effects=(Contact("floor", STIFFNESS, damping),))


def parameter(name="mass", unit="kg", default=1.0):
    return Parameter(name, unit, default)


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
        lambda: drop(effects=(Contact("floor", power(1e6, 1.5)),)), "floor, stiffness", "bare number 1000000", "N/m^n",
    ),
    "negative mass": (lambda: heavy(parameter(default=-1.0)), "body ball, mass", "-1 kg", "(0, inf)"),
    "negative expression": (lambda: heavy(parameter() - 3 * parameter()), "body ball, mass", "-2 kg", "(0, inf)"),
    "mass zero": (lambda: heavy(0), "body ball, mass", "0 kg", "(0, inf)"),
    "negative radius": (lambda: drop(pairs=(replace(FLOOR, radius=-RADIUS),)), "pair floor, radius", "-0.1 m", "(0, inf)"),
    "negative stiffness": (
        lambda: drop(effects=(Contact("floor", power(Parameter("K", "N/m^1.5", -1.0), 1.5)),)), "floor, stiffness", "-1", "(0, inf)",
    ),
    "negative inertia": (lambda: turning(Parameter("J", "kg m^2", -1.0)), "body wheel, inertia", "-1 kg m^2", "[0, inf)"),
    "no inertia of a rotating body": (lambda: turning(0), "body wheel", "inertia 0", "positive"),
    "inertia that is zero at its default": (lambda: turning(Parameter("J", "kg m^2", 0)), "body wheel", "inertia 0", "positive"),
    "inertia that is an expression of value zero": (
        lambda: turning(Parameter("J", "kg m^2", 1) * Parameter("nothing", "1", 0)), "body wheel", "inertia 0", "positive",
    ),
    "point mass on the axis it is turned about": (
        lambda: turning(0, (0, 0, parameter("l", "m"))), "body wheel", "inertia 0", "positive",
    ),
    "inertia triple of zeros": (lambda: turning((0, 0, 0)), "body wheel", "inertia 0", "positive"),
    "zero inertia of a body on a turning one": (
        lambda: drop(
            joints=(Revolute("axle", GROUND, STRANGER, axis=Z), Prismatic("slot", STRANGER, BALL, axis=X)), pairs=(), effects=(GRAVITY,)
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
        lambda: stiff(Parameter("K", "N/m^0.5", 1.0), 0.5),
        "exponent", "0.5", "[1, 10]",
    ),
    "exponent with a unit": (
        lambda: drop(effects=(Contact("floor", power(Parameter("K", "N/m^n", 1.0), Parameter("n", "m", 1.5))),)), "exponent", "n [m]", "1",
    ),
    "unit with an exponent that is no parameter": (
        lambda: drop(effects=(Contact("floor", power(Parameter("K", "N/m^bend", 1e6), 1.5)),)), "parameter K", "bend", "Parameter('bend', '1'",
    ),
    "default not a number": (lambda: heavy(parameter(default=math.nan)), "parameter mass", "nan", "finite"),
    "default infinite": (lambda: heavy(parameter(default=math.inf)), "parameter mass", "inf", "finite"),
    "default a truth value": (lambda: heavy(parameter(default=True)), "parameter mass", "True", "number"),
    "default a text": (lambda: heavy(parameter(default="1")), "parameter mass", "'1'", "number"),
    "name of a parameter": (lambda: heavy(parameter("my mass")), "parameter my mass", "'my mass'", "identifier"),
    "name of a parameter a keyword": (lambda: heavy(parameter("lambda")), "parameter lambda", "'lambda'", "keyword"),
    "a quantity as text": (lambda: heavy("1 kg"), "body ball, mass", "'1 kg'", "Parameter"),
    "name of a mechanism": (lambda: drop(name="my drop"), "mechanism", "'my drop'", "identifier"),
    "name of a joint": (lambda: drop(joints=(Prismatic("my joint", GROUND, BALL, axis=Y),)), "joint", "'my joint'", "identifier"),
    "body connected to nothing": (
        lambda: drop(pairs=(replace(FLOOR, sphere=STRANGER.at(0, 0, 0)),)), "pair floor", "stranger", "joint connects",
    ),
    "joint naming a body not in the mechanism": (
        lambda: drop(joints=(FALL, Prismatic("more", STRANGER, Body("b", mass=parameter("m_b")), axis=X))),
        "joint more", "stranger, which is not in the mechanism", "Connect stranger to the ground",
    ),
    "joints out of order": (
        lambda: drop(joints=(Prismatic("fall", STRANGER, BALL, axis=Y), Prismatic("base", GROUND, STRANGER, axis=X))),
        "joint fall", "stranger, declared later", "from the ground outwards",
    ),
    "joint on itself": (
        lambda: drop(joints=(Prismatic("fall", BALL, BALL, axis=Y),)),
        "joint fall", "ball as parent and child", "two different bodies",
    ),
    "joints in a ring": (
        lambda: drop(joints=(Prismatic("fall", STRANGER, BALL, axis=Y), Revolute("back", BALL, STRANGER, axis=Z))),
        "joint fall", "stranger", "earlier joint",
    ),
    "ground as child": (lambda: drop(joints=(FALL, Prismatic("down", BALL, GROUND, axis=Y))), "joint down", "ground as child", "a body"),
    "pair within one body": (
        lambda: drop(pairs=(SphereOnSphere("floor", BALL.at(0, 0, 0), BALL.at(RADIUS, 0, 0), RADIUS, RADIUS),)),
        "pair floor", "ball", "two different bodies",
    ),
    "two parameters of one name": (lambda: heavy(parameter("g", "kg", 1.0)), "parameter g", "two different", "unique"),
    "two defaults of one name": (
        lambda: drop(scales=replace(SCALES, length=Parameter("radius", "m", 0.2))), "parameter radius", "two different", "unique",
    ),
    "two bodies of one name": (
        lambda: drop(joints=(FALL, Prismatic("side", BALL, Body("ball", mass=parameter("other")), axis=X))),
        "joint side", "second body named ball", "unique",
    ),
    "two joints of one name": (lambda: drop(joints=(FALL, Prismatic("fall", BALL, STRANGER, axis=X))), "joint fall", "2 of this name", "unique"),
    "two pairs of one name": (lambda: drop(pairs=(FLOOR, FLOOR)), "pair floor", "2 of this name", "unique"),
    "two effects of one name": (
        lambda: drop(effects=(GRAVITY, ConstantSpeed("gravity", "fall", Parameter("w", "m/s", 1.0)))), "effect gravity", "2 of this name", "unique",
    ),
    "two contacts of one pair": (lambda: drop(effects=(BOUNCE, BOUNCE)), "effect floor", "2 of this name", "unique"),
    "two ledgers": (lambda: drop(effects=(EnergyLedger("one"), EnergyLedger("two"))), "ledger of the scene", "2", "one"),
    "two gravities": (lambda: drop(effects=(GRAVITY, replace(GRAVITY, name="more"))), "gravity of the scene", "2", "one"),
    "two drives of one joint": (
        lambda: drop(
            joints=(FALL, Prismatic("side", BALL, STRANGER, axis=X)),
            effects=tuple(ConstantSpeed(name, "fall", Parameter("w", "m/s", 1.0)) for name in ("one", "two")),
        ),
        "drive of joint fall", "2", "one",
    ),
    "contact of a pair that is not there": (lambda: drop(effects=(Contact("flor", STIFFNESS),)), "effect flor", "'flor'", "floor"),
    "drive of a joint that is not there": (
        lambda: drop(effects=(ConstantSpeed("drive", "fal", Parameter("w", "m/s", 1.0)),)), "effect drive", "'fal'", "fall",
    ),
    "drive of the wrong dimension": (
        lambda: drop(
            joints=(FALL, Prismatic("side", BALL, STRANGER, axis=X)), effects=(ConstantSpeed("drive", "side", Parameter("w", "rpm", 1.0)),)
        ),
        "effect drive, speed", "w [", "m/s",
    ),
    "drives everywhere": (
        lambda: drop(effects=(ConstantSpeed("drive", "fall", Parameter("w", "m/s", 1.0)),)), "effects", "every joint", "free",
    ),
    "friction without a contact": (
        lambda: drop(effects=(Friction("rub", "floor", smooth_coulomb(0.1, Parameter("v_s", "m/s", 1.0))),)), "effect rub", "floor", "normal force",
    ),
    "negative friction": (
        lambda: drop(effects=(BOUNCE, Friction("rub", "floor", smooth_coulomb(-0.1, Parameter("v_s", "m/s", 1.0))))),
        "effect rub, coefficient of friction", "-0.1", "[0, inf)",
    ),
    "approach floor zero": (
        lambda: drop(effects=(replace(BOUNCE, approach_floor=Parameter("least", "m/s", 0.0)),)), "floor, approach floor", "0 m/s", "(0, inf)",
    ),
    "start of an unknown joint": (lambda: drop(start=Start(position={"fal": RADIUS})), "start", "'fal'", "fall"),
    "start of the wrong dimension": (lambda: drop(start=Start(speed={"fall": RADIUS})), "start, speed of fall", "radius [m]", "m/s"),
    "start of a driven joint": (
        lambda: replace(slider_crank, start=Start(position={"main_bearing": 1})), "start", "main_bearing", "crank_pin",
    ),
    "angles without an arm": (
        lambda: replace(slider_crank, scales=replace(slider_crank.scales, arm=None)), "scales", "no arm", "arm",
    ),
    "exponent parameter not a number": (
        lambda: stiff(Parameter("K", "N/m^bend", 1.0), Parameter("bend", "1", math.nan)), "parameter bend", "nan", "finite",
    ),
    "exponent parameter with a unit": (
        lambda: stiff(Parameter("K", "N/m^mass", 1.0), 1.5), "parameter K", "mass", "1",
    ),
    "a symbol that is no parameter": (lambda: stiff(sp.Symbol("K"), 1.5), "floor, stiffness", "K", ""),
    "complex at the defaults": (
        lambda: drop(scales=replace(SCALES, length=RADIUS * sp.sqrt(Parameter("ratio", "1", 0.5) - 2))), "scales, length", "", "finite",
    ),
    "infinite at the defaults": (lambda: drop(scales=replace(SCALES, length=RADIUS / Parameter("none", "1", 0))), "scales, length", "", "finite"),
    "a mass centre of two numbers": (lambda: heavy(parameter(), centre=(0, 0)), "body ball", "(0, 0)", "three"),
    "a law that is not called": (
        lambda: drop(effects=(Contact("floor", power),)),
        "floor, stiffness", "power without its parameters", "power(K, n)",
    ),
    "a damping law as stiffness": (lambda: drop(effects=(Contact("floor", flores(0.8)),)), "floor", "flores", "stiffness"),
}  # fmt: skip


def test_unvaried_declarations_are_sound():
    assert drop().name == "drop"
    assert heavy(parameter()).parameters["mass"].default == 1.0
    assert turning(Parameter("J", "kg m^2", 1.0)).free[0].key == "axle"
    assert journal(0.1).parameters["clearance"].si == pytest.approx(1e-4)
    assert bouncing(lankarani_nikravesh(0.9)).contacts[0][0] is FLOOR


@each("label", BAD)
def test_a_bad_declaration_is_one_fault_that_says_where_what_and_the_way_out(label):
    refused(*BAD[label])


def test_all_faults_of_a_scene_come_at_once():
    ball = Body("ball", mass=parameter(default=-1.0))
    wheel = Body("wheel", mass=2.0, centre=(Parameter("off", "mmm", 1.0), 0, 0))
    pin = PinInBush(
        "pin", wheel.at(0, 0, 0), ball.at(0, 0, 0), Z, Parameter("bush", "kg", 1.0), Parameter("clearance", "mm", 0)
    )
    with pytest.raises(InputError) as caught:
        Scene(
            Mechanism("many", (FALL.__class__("fall", GROUND, ball, axis=Y), Revolute("axle", STRANGER, wheel, axis=Z)), (pin, pin)),
            (
                Gravity("gravity", Parameter("g", "m/s^2", math.inf), -Y),
                Contact("pin", power(Parameter("stiff", "N/m^bend", 1.0), 1.5), flores(1.5)),
                Contact("nowhere", STIFFNESS),
                EnergyLedger(),
                EnergyLedger(),
            ),
            Scales(length=Parameter("size", "m", 1.0), speed=3.0),
            Start(position={"nothing": 0}),
        )  # fmt: skip
    text = str(caught.value)
    for piece in (
        "body ball, mass: found -1 kg",
        "the bare number 2.0",
        "'mmm'",
        "bush [kg]",
        "pair pin, clearance: found 0 m",
        "parent stranger",
        "pair pin, effect energy_ledger: found 2 of this name",
        "found default inf",
        "exponent bend",
        "coefficient of restitution of flores: found 1.5",
        "pair 'nowhere'",
        "effect energy_ledger: found 2",
        "the bare number 3.0",
        "joint 'nothing'",
        "no arm",
    ):
        assert piece in text, f"{piece!r} is not in\n{text}"
    assert "16 faults" in text  # that of the pair and the ledger, 2 of a name, is told once
    assert len(set(caught.value.faults)) == len(caught.value.faults)


def test_zero_has_every_unit_and_angles_may_be_bare():
    scene = replace(slider_crank, start=Start(position={"crank_pin": sp.pi / 6, "guide": 0}, speed={"crank_pin": 0}))
    assert scene.start.position["crank_pin"] == sp.pi / 6


def test_a_point_mass_beside_the_axis_needs_no_inertia():
    assert turning(0, (parameter("l", "m"), 0, 0))


def test_a_value_outside_the_recommended_range_is_no_fault():
    """Lankarani and Nikravesh's law is recommended for restitutions near one; outside is the run's warning, not an error."""
    law = lankarani_nikravesh(Parameter("restitution", "1", 0.1))
    assert law.law.recommended.lower == 0.8
    text = generate(drop(effects=(Contact("floor", STIFFNESS, law),)))
    assert '("restitution", "recommended", 0.8, 1, True, False,' in text
    assert '("restitution", "defined", 0, 1, False, False,' in text


def test_limits_at_their_ends():
    """Closed ends hold, open ones do not."""
    assert bouncing(flores(1)).name == "drop"
    assert bouncing(hunt_crossley(0)).name == "drop"
    assert drop(effects=(Contact("floor", power(Parameter("K", "N/m", 1.0), 1)),)).name == "drop"


# -- parameters and laws -----------------------------------------------------------------------------------------------


def test_parameters_are_symbols_that_differ_by_everything_declared():
    assert Parameter("r", "mm", 5) == Parameter("r", "mm", 5)
    others = (
        Parameter("r", "m", 5),
        Parameter("r", "mm", 6),
        Parameter("r", "mm", 5, "of the pin"),
        Parameter("R", "mm", 5),
    )
    assert len({Parameter("r", "mm", 5), *others}) == 5
    assert Parameter("r", "mm", 5).si == pytest.approx(0.005)
    assert sp.diff(Parameter("r", "mm", 5) ** 2, Parameter("r", "mm", 5)) == 2 * Parameter("r", "mm", 5)


@pytest.mark.parametrize("values", [(), (1, 2), (Parameter("e", "1", 0.5), 1)])
def test_a_law_is_bound_to_all_its_parameters(values):
    with pytest.raises(TypeError, match="law flores takes"):
        flores(*values)


def test_a_law_is_bound_by_name_or_by_place():
    K, n = Parameter("K", "N/m^1.5", 1.0), sp.Rational(3, 2)
    assert power(K, n) == power(K, n=1.5) == power(n=1.5, K=K)
    with pytest.raises(TypeError, match="not expected"):
        power(K, n, m=1)


# -- variations --------------------------------------------------------------------------------------------------------


def names(scene):
    return [effect.name for effect in scene.effects]


def test_without_gives_a_new_scene_and_leaves_the_old_one():
    before = names(slider_crank)
    lean = slider_crank.without("slider_pin_friction", "gravity")
    assert names(lean) == ["crank_drive", "slider_pin", "energy_ledger"]
    assert names(slider_crank) == before
    assert "gravity" not in lean.parameters
    assert "friction_speed" not in lean.parameters
    assert lean.mechanism is slider_crank.mechanism


def test_without_an_unknown_effect_lists_every_unknown_name():
    with pytest.raises(InputError) as caught:
        slider_crank.without("nope", "gravity", "neither")
    assert [fault.where for fault in caught.value.faults] == ["nope", "neither"]
    assert all("crank_drive" in fault.expected for fault in caught.value.faults)


def test_without_what_another_effect_needs_is_refused():
    with pytest.raises(InputError, match="Friction needs a normal force"):
        slider_crank.without("slider_pin")
    assert "slider_pin" not in names(slider_crank.without("slider_pin", "slider_pin_friction"))


def test_without_the_drive_the_joint_gets_its_coordinate_back():
    assert [freedom.key for freedom in slider_crank.free] == ["crank_pin", "guide"]
    assert [freedom.key for freedom in slider_crank.without("crank_drive").free] == [
        "main_bearing",
        "crank_pin",
        "guide",
    ]


def test_replace_exchanges_one_effect():
    contact = Contact("slider_pin", STIFFNESS, flores(Parameter("restitution", "1", 0.9)))
    scene = slider_crank.replace(slider_pin=contact)
    assert scene.effect("slider_pin") is contact
    assert names(scene) == names(slider_crank)
    assert slider_crank.effect("slider_pin") is not contact
    with pytest.raises(InputError, match="nope: found no effect of this name"):
        slider_crank.replace(nope=contact)


def test_with_law_keeps_the_parameters():
    scene = slider_crank.with_law("slider_pin", "flores")
    old, new = slider_crank.effect("slider_pin"), scene.effect("slider_pin")
    assert new.damping.law is flores
    assert new.damping.values == old.damping.values
    assert new.stiffness == old.stiffness
    assert list(scene.parameters) == list(slider_crank.parameters)


@pytest.mark.parametrize(
    ("effect", "law", "message"),
    [
        ("slider_pin", "hertz", "hertz_point"),
        ("slider_pin", "smooth_coulomb", "name of a stiffness or damping law"),
        ("slider_pin_friction", "flores", "smooth_coulomb"),
        ("gravity", "flores", "an effect that has a law"),
        ("slider_pin", "power", r"K \[N/m\^n\]"),
        ("nope", "flores", "nope: found no effect of this name"),
    ],
)
def test_a_law_that_does_not_fit_is_refused(effect, law, message):
    with pytest.raises(InputError, match=message):
        slider_crank.with_law(effect, law)


def test_named_changes_name_and_summary_alone():
    scene = slider_crank.named("other", "another one")
    assert (scene.name, scene.summary) == ("other", "another one")
    assert slider_crank.named("other").summary == slider_crank.summary
    assert scene.effects == slider_crank.effects
    with pytest.raises(InputError, match="'not a name'"):
        slider_crank.named("not a name")


@pytest.mark.parametrize("kind", ["spheres", "pin"])
def test_text_as_a_radius_or_a_mass_of_a_pair_is_a_fault_and_never_evaluated(kind, tmp_path):
    """What the pair's geometry is computed from: text there is reported with everything else, and not handed to SymPy."""
    mark = tmp_path / "executed"
    one, two = Body("one", mass=f"__import__('pathlib').Path({str(mark)!r}).touch()"), Body("two", mass="1 kg")
    places = (one.at(0, 0, 0), two.at(0, 0, 0))
    pair = (
        SphereOnSphere("pair", *places, "1 m", "2 m")
        if kind == "spheres"
        else PinInBush("pair", *places, Z, "2 m", "1 m")
    )
    K = Parameter("stiffness", "N/m^1.5", 1e6)
    with pytest.raises(InputError) as caught:
        Scene(
            Mechanism("two", (Prismatic("a", GROUND, one, X), Prismatic("b", GROUND, two, X)), (pair,)),
            (Contact("pair", power(K, 1.5)),),
            Scales(length=Parameter("size", "m", 1), speed=Parameter("pace", "m/s", 1)),
        )
    assert {fault.found for fault in caught.value.faults} >= {"'1 kg'", "'1 m'", "'2 m'"}
    assert not mark.exists()
