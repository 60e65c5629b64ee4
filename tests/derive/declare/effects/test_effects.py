"""Declarations of drives and force elements: every bad one is a fault that names the cause; an effect left out leaves no trace."""

import math
import re
from dataclasses import replace

import pytest
import sympy as sp
from derived import Derived
from drop import refused
from each import each

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, lugre, smooth_coulomb

p = hd.Parameter
MASS, INERTIA, SIZE = p("mass", "kg", 1.0), p("inertia", "kg m^2", 1.0), p("size", "m", 1.0)
ROTOR, BLOCK = hd.Body("rotor", MASS, INERTIA), hd.Body("block", MASS)
MECHANISM = hd.Mechanism(
    "bench",
    (hd.Revolute("axle", hd.GROUND, ROTOR, axis=hd.Z), hd.Prismatic("slide", hd.GROUND, BLOCK, axis=hd.X), hd.Revolute("arm", ROTOR,
    hd.Body("tip", MASS, INERTIA), axis=hd.Z))
)  # fmt: skip
SCALES = hd.Scales(length=SIZE, speed=hd.Parameter("pace", "m/s", 1.0), arm=SIZE)
STRANGER = hd.Body("stranger", MASS)

ANGLE, SPIN = p("angle", "rad", 1.0), p("spin", "rpm", 60)
RATE, RISE, REST = p("rate", "rad/s", 2.0), p("rise", "s", 1.0), p("rest", "m", 0.5)
STIFFNESS, DAMPING = p("stiffness", "N/m", 5.0), p("damping", "N s/m", 0.5)
TORSION, TORQUE, FORCE = p("torsion", "N m/rad", 5.0), p("torque", "N m", 2.0), p("force", "N", 3.0)
LAW = smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 0.1))
WAVE = hd.Table("wave", (0, 1, 2), (0, 5, 0), ("s", "deg"))
ENDS = (ROTOR.at(SIZE, 0, 0), BLOCK.at(0, 0, 0))

SOUND = (
    hd.ConstantSpeed("drive", "axle", SPIN), hd.Ramp("drive", "axle", SPIN, RISE), hd.Harmonic("drive", "axle", ANGLE, RATE),
    hd.Drive("drive", "axle", position=ANGLE * sp.cos(RATE * hd.T)), hd.Drive("drive", "axle", position=WAVE(hd.T)),
    hd.Drive("drive", "axle", speed=SPIN, start=ANGLE), hd.Drive("drive", "axle", acceleration=SPIN * RATE, start_speed=SPIN),
    hd.JointForce("motor", "slide", FORCE - DAMPING * hd.speed_of("slide")),
    hd.PointForce("push", ENDS[0], (FORCE, 0, STIFFNESS * hd.coordinate_of("slide")), axes=ROTOR),
    hd.BodyTorque("twist", ROTOR, (0, 0, TORQUE * sp.sin(RATE * hd.T))), hd.Potential("well", STIFFNESS * hd.coordinate_of("slide") ** 2),
    hd.JointSpring("spring", "axle", TORSION, ANGLE), hd.JointDamper("damper", "slide", DAMPING), hd.PointSpring("band", *ENDS, STIFFNESS, REST),
    hd.PointDamper("strut", *ENDS, DAMPING), hd.JointFriction("friction", "axle", LAW, FORCE, REST),
)  # fmt: skip


def bench(*effects, scales=SCALES, start=None):
    return hd.Scene(MECHANISM, (*effects, hd.EnergyLedger()), scales, start or hd.Start())


def table(**changed):
    """A drive by a table of which something is changed."""
    options = {"name": "wave", "arguments": (0, 1, 2), "values": (0, 5, 0), "units": ("s", "deg"), **changed}
    return bench(hd.Drive("drive", "axle", position=hd.Table(**options)(hd.T)))


def driven(**law):
    return bench(hd.Drive("drive", "axle", **law))


BAD = {
    # label: (how, where, found, expected or remedy)
    "spring of an unknown joint": (lambda: bench(hd.JointSpring("spring", "axl", TORSION)), "effect spring", "'axl'", "axle, slide"),
    "ramp of an unknown joint": (lambda: bench(hd.Ramp("drive", "axl", SPIN, RISE)), "effect drive", "'axl'", "axle, slide"),
    "joint that is no name": (lambda: bench(hd.JointSpring("spring", MECHANISM.joints[0], TORSION)), "effect spring", "Revolute", "name of a joint"),
    "two drives of one joint": (lambda: bench(SOUND[1], replace(SOUND[2], name="more")), "drive of joint axle", "2", "one"),
    "force on an unknown body": (lambda: bench(hd.PointForce("push", STRANGER.at(0, 0, 0), (FORCE, 0, 0))), "effect push", "stranger",
    "rotor, block"),
    "torque on an unknown body": (lambda: bench(hd.BodyTorque("twist", STRANGER, (0, 0, TORQUE))), "effect twist", "stranger", "rotor, block"),
    "axes of an unknown body": (lambda: bench(hd.BodyTorque("twist", ROTOR, (0, 0, TORQUE), axes=STRANGER)), "effect twist", "stranger", "rotor"),
    "axes that are a word": (lambda: bench(hd.BodyTorque("twist", ROTOR, (0, 0, TORQUE), axes="rotor")), "twist, axes", "'rotor'", "GROUND"),
    "force on the ground": (lambda: bench(hd.PointForce("push", hd.GROUND.at(0, 0, 0), (FORCE, 0, 0))), "effect push", "on the ground", "a body"),
    "force on a body without a point": (lambda: bench(hd.PointForce("push", ROTOR, (FORCE, 0, 0))), "effect push", "Body", "body.at"),
    "force of two components": (lambda: bench(hd.PointForce("push", ENDS[0], (FORCE, 0))), "push, force", "", "three values"),
    "spring with both ends on one body": (lambda: bench(hd.PointSpring("band", ENDS[0], ROTOR.at(0, 0, 0), STIFFNESS)), "effect band", "rotor",
                                          "two different"),
    "spring to an unknown body": (lambda: bench(hd.PointSpring("band", ENDS[0], STRANGER.at(0, 0, 0), STIFFNESS)), "effect band",
    "stranger", "ground"),
    "rest length zero": (
        lambda: bench(hd.PointSpring("band", *ENDS, STIFFNESS, hd.Parameter("rest", "m", 0.0))), "band, rest length", "0 m", "(0, inf)",
    ),
    "rest length literally zero": (lambda: bench(hd.PointSpring("band", *ENDS, STIFFNESS, 0)), "band, rest length", "0 m", "(0, inf)"),
    "negative stiffness": (lambda: bench(hd.JointSpring("s", "slide", hd.Parameter("k_s", "N/m", -1.0))), "s, stiffness", "-1", "[0, inf)"),
    "negative damping": (lambda: bench(hd.PointDamper("s", *ENDS, hd.Parameter("c_s", "N s/m", -1.0))), "s, damping", "-1", "[0, inf)"),
    "linear stiffness on a turning joint": (lambda: bench(hd.JointSpring("s", "axle", STIFFNESS)), "s, stiffness", "stiffness [N/m]", "J"),
    "torsional stiffness on a slide": (lambda: bench(hd.JointSpring("s", "slide", TORSION)), "s, stiffness", "torsion [J]", "N/m"),
    "rise zero": (lambda: bench(hd.Ramp("drive", "axle", SPIN, 0)), "drive, rise", "0 s", "(0, inf)"),
    "smoothness that is none": (lambda: bench(hd.Ramp("drive", "axle", SPIN, RISE, 7)), "drive, smoothness", "7", "0 to 4"),
    "a drive of nothing": (lambda: driven(), "effect drive", "none", "one of position"),
    "a drive of two laws": (lambda: driven(position=ANGLE, speed=SPIN), "effect drive", "position and speed", "follow"),
    "a start beside a position": (lambda: driven(position=ANGLE * sp.cos(RATE * hd.T), start=ANGLE), "effect drive", "start", "where it begins"),
    "a start speed beside a speed": (lambda: driven(speed=SPIN, start_speed=SPIN), "effect drive", "start_speed", "where it begins"),
    "a drive that depends on a coordinate": (
        lambda: driven(position=ANGLE * hd.coordinate_of("arm")), "drive, position", "arm.coordinate", "an expression of time",
    ),
    "a potential that depends on a speed": (
        lambda: bench(hd.Potential("well", MASS * hd.speed_of("slide") ** 2)), "well, energy", "slide.speed", "an expression of coordinate",
    ),
    "a drive that jumps": (lambda: driven(position=ANGLE * sp.sign(RATE * hd.T - 1)), "drive, position", "first derivative", "smooth"),
    "a drive with a kink": (lambda: driven(position=ANGLE * sp.Abs(RATE * hd.T - 1)), "drive, position", "second derivative", "smooth"),
    "a speed whose rate jumps to infinity": (lambda: driven(speed=SPIN * sp.Heaviside(RATE * hd.T - 1)), "drive, speed", "Heaviside", "Where"),
    "a choice without an otherwise": (
        lambda: driven(speed=sp.Piecewise((SPIN, hd.T < RISE))), "drive, speed", "Piecewise", "known functions",
    ),
    "a force that SymPy takes as complex": (
        lambda: bench(hd.JointForce("m", "slide", FORCE * sp.Abs(sp.exp((hd.coordinate_of("slide") / REST) ** hd.Parameter("n", "1", 2))))),
        "m, force", "re((slide.coordinate/rest)**n)", "omit the Abs",
    ),
    "a coordinate of an unknown joint": (
        lambda: bench(hd.JointForce("m", "slide", STIFFNESS * hd.coordinate_of("slid"))), "m, force", "'slid'", "axle, slide",
    ),
    "a symbol that is no parameter": (lambda: bench(hd.JointForce("m", "slide", FORCE * sp.Symbol("t") * hd.T)), "m, force", "t", "Parameters, T"),
    "a force as text": (lambda: bench(hd.JointForce("m", "slide", "force*t")), "m, force", "'force*t'", "Parameter"),
    "a bare number": (lambda: bench(hd.JointForce("m", "slide", 3)), "m, force", "bare number 3", "Parameter('...', 'N', 3)"),
    "friction of a journal without a radius": (lambda: bench(hd.JointFriction("f", "axle", LAW, FORCE)), "effect f", "no radius", "journal"),
    "friction of a slide with a radius": (lambda: bench(hd.JointFriction("f", "slide", LAW, FORCE, REST)), "effect f", "radius", "slides"),
    "friction by a law with memory": (
        lambda: bench(hd.JointFriction("f", "slide", lugre(0.1, 0.2, hd.Parameter("v_S", "m/s", 0.1), hd.Parameter("s_0", "1/m", 1e5), 0, 0), FORCE)),
        "effect f", "lugre, which needs", "smooth_coulomb",
    ),
    "friction by a law of damping": (lambda: bench(hd.JointFriction("f", "slide", flores(0.8), FORCE)), "f, friction", "flores", "friction law"),
    "negative normal force": (
        lambda: bench(hd.JointFriction("f", "slide", LAW, hd.Parameter("load", "N", -1.0))), "f, normal force", "-1 N", "[0, inf)",
    ),
    "a start of a driven joint": (lambda: bench(SOUND[3], start=hd.Start(position={"axle": ANGLE})), "start", "axle", "arm"),
    "an integrated angle without an arm": (
        lambda: hd.Scene(
            hd.Mechanism("turntable", MECHANISM.joints[:2]), (SOUND[5],), hd.Scales(length=SIZE, speed=hd.Parameter("pace", "m/s", 1.0))
        ),
        "scales", "no arm", "arm",
    ),
    # tables
    "table not increasing": (lambda: table(arguments=(0, 2, 2)), "table wave", "argument 2 after 2 in place 3", "increase"),
    "table with a NaN": (lambda: table(values=(0, math.nan, 0)), "table wave", "value nan in place 2", "finite"),
    "table with an infinite argument": (lambda: table(arguments=(0, 1, math.inf)), "table wave", "argument inf", "finite"),
    "table of a text": (lambda: table(values=(0, "5", 0)), "table wave", "'5'", "finite number"),
    "table of unequal lengths": (lambda: table(values=(0, 1)), "table wave", "3 arguments and 2 values", "as many"),
    "table of one point": (lambda: table(arguments=(0,), values=(0,)), "table wave", "1 arguments", "two"),
    "table of an unknown unit": (lambda: table(units=("s", "degg")), "table wave", "degg", "unit"),
    "table of one unit": (lambda: table(units=("s",)), "table wave", "('s',)", "two"),
    "table of three slopes": (lambda: table(slopes=(0, 0, 0)), "table wave", "3 slopes", "two"),
    "table of another argument": (lambda: table(units=("m", "deg")), "drive, position", "wave(t)", "m"),
    "table of another value": (lambda: table(units=("s", "mm")), "drive, position", "wave(t) [m]", "a quantity in 1"),
    "table of a name that is none": (lambda: table(name="my table"), "table", "'my table'", "identifier"),
    "two tables of one name": (
        lambda: bench(SOUND[4], hd.JointForce("m", "slide", hd.Table("wave", (0, 1), (0, 1), ("s", "N"))(hd.T))), "table wave",
        "two different", "unique",
    ),
}  # fmt: skip


@each("effect", SOUND)
def test_unvaried_declarations_are_sound(effect):
    assert effect.text in hd.generate(bench(effect))


@each("label", BAD)
def test_a_bad_declaration_is_one_fault_that_says_where_what_and_the_way_out(label):
    refused(*BAD[label])


# -- units: the smallest faulty sub-expression ---------------------------------------------------------------------------

HIDDEN = hd.Parameter("hidden", "mm", 3.0)
WRONG = {  # effect with an expression of a wrong unit, where, the sub-expression at fault, its unit
    "sine of a time": (hd.JointForce("m", "slide", FORCE * sp.sin(hd.T)), "m, force", "sin(t)", "s"),
    "sum within a product": (hd.JointForce("m", "slide", FORCE * sp.cos(RATE * hd.T + REST)), "m, force", "rate*t + rest", "1"),
    "torque for a force": (hd.JointForce("m", "slide", TORQUE * sp.sin(RATE * hd.T)), "m, force", "torque*sin(rate*t)", "J"),
    "one term of a sum": (
        hd.JointForce("m", "axle", TORQUE - DAMPING * hd.speed_of("axle")), "m, force", "-damping*axle.speed", "N/m",
    ),
    "a component of a force": (hd.PointForce("p", ENDS[0], (0, FORCE, STIFFNESS * hd.T)), "p, force along z", "stiffness*t", "N s/m"),
    "a component of a torque": (hd.BodyTorque("p", ROTOR, (0, FORCE * hd.T, 0)), "p, torque about y", "force*t", "N s"),
    "an energy": (hd.Potential("p", STIFFNESS * hd.coordinate_of("slide")), "p, energy", "stiffness*slide.coordinate", "N"),
    "a position": (hd.Drive("d", "axle", position=SPIN * hd.T**2), "d, position", "spin*t**2", "s"),
    "a speed": (hd.Drive("d", "axle", speed=SPIN * hd.T), "d, speed", "spin*t", "1"),
    "an acceleration": (hd.Drive("d", "slide", acceleration=HIDDEN * hd.T), "d, acceleration", "hidden*t", "m s"),
    "an amplitude": (hd.Harmonic("d", "axle", REST, RATE), "d, amplitude", "rest", "m"),
    "a frequency": (hd.Harmonic("d", "axle", ANGLE, RISE), "d, frequency", "rise", "s"),
    "a phase": (hd.Harmonic("d", "axle", ANGLE, RATE, REST), "d, phase", "rest", "m"),
    "a rise": (hd.Ramp("d", "axle", SPIN, RATE), "d, rise", "rate", "1/s"),
    "a start": (hd.Drive("d", "axle", speed=SPIN, start=REST), "d, start", "rest", "m"),
    "a start speed": (hd.Drive("d", "axle", acceleration=SPIN * RATE, start_speed=ANGLE), "d, start speed", "angle", "1"),
    "a rest": (hd.JointSpring("s", "slide", STIFFNESS, ANGLE), "s, rest", "angle", "1"),
    "a rest length": (hd.PointSpring("s", *ENDS, STIFFNESS, RISE), "s, rest length", "rise", "s"),
    "a damping": (hd.JointDamper("s", "axle", DAMPING), "s, damping", "damping", "N s/m"),
    "a damping between points": (hd.PointDamper("s", *ENDS, STIFFNESS), "s, damping", "stiffness", "N/m"),
    "a normal force": (hd.JointFriction("f", "slide", LAW, STIFFNESS * hd.T), "f, normal force", "stiffness*t", "N s/m"),
    "a radius": (hd.JointFriction("f", "axle", LAW, FORCE, ANGLE), "f, radius", "angle", "1"),
    "a choice": (hd.JointForce("m", "slide", hd.Where(hd.T < RISE, FORCE, TORQUE)), "m, force", "Where(t < rise, force, torque)", "J"),
    "a comparison": (hd.JointForce("m", "slide", hd.Where(hd.T < REST, FORCE, 0)), "m, force", "t < rest", ""),
}  # fmt: skip


@each("label", WRONG)
def test_a_wrong_unit_is_found_in_the_smallest_sub_expression(label):
    effect, where, culprit, unit = WRONG[label]
    with pytest.raises(hd.InputError) as caught:
        bench(effect)
    (fault,) = [fault for fault in caught.value.faults if where in fault.where]
    assert fault.found.startswith(f"{culprit} ["), str(fault)
    assert unit in fault.found


# -- nothing for nothing -----------------------------------------------------------------------------------------------


def below_header(text):
    lines = text.split("\n")
    return "\n".join(line for line in lines if not re.match(r'^(""".*Generated from|NAME = |DIGEST = )', line))


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("effect", SOUND, ids=lambda e: f"{type(e).__name__} {e.text}"[:60])
def test_an_effect_left_out_leaves_no_trace(effect):
    """Beside all of the rest the module is, to the letter, that of a scene which never had it; its parameters are gone with it."""
    others = [e for e in SOUND if e.name not in (effect.name, "drive")]
    if effect.kind != "drive":
        others.insert(0, SOUND[0])
    scene = bench(effect, *others)
    lean = hd.generate(scene.without(effect.name))
    assert below_header(lean) == below_header(hd.generate(bench(*others)))
    before, after = Derived(text=hd.generate(scene)), Derived(text=lean)
    assert not re.search(rf"\b{effect.name}(_|\.)", after.text)
    assert {name for name, *_ in before.PARAMETERS} >= {name for name, *_ in after.PARAMETERS}
    assert [row for row in before.MEMORY if row[0].startswith(f"{effect.name}.")] == [
        (f"{effect.name}.{booked}", "J")
        for booked in {"force": ["input"], "damper": ["dissipated"], "joint_friction": ["dissipated"]}.get(
            effect.kind, []
        )
    ]
    assert "WAVE_TABLE" not in after.text
    assert ("_spline" in before.text) == ("wave" in effect.text)


def test_without_a_ledger_nothing_is_booked_and_the_forces_stay():
    scene = bench(*SOUND[7:])
    lean = Derived(hd.Scene(MECHANISM, SOUND[7:], SCALES))
    assert lean.MEMORY == ()
    assert not {"energy", "ledger"} & set(lean.names)
    assert sum(count for _, count in lean.OPERATIONS) < sum(count for _, count in Derived(scene).OPERATIONS)
    assert dict(lean.OPERATIONS)["applied"] == dict(Derived(scene).OPERATIONS)["applied"]
