"""Declarations of every wrong kind, in every place: one InputError that says what was expected, never the exception of what met it first."""

import warnings
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
import sympy as sp
from each import each

import hertzwerk.derive as hd
from hertzwerk.derive.laws import hertz_point, power, smooth_coulomb

BAD = [
    None, "text", (1, 2), [1, 2, 3], float("nan"), sp.Symbol("stranger"), np.eye(3), hd.Parameter("other", "kg^2", 1), ((1, 2, 3),) * 3, object(),
]  # fmt: skip
SIZE, SPEED, PUSH = hd.Parameter("size", "m", 0.1), hd.Parameter("speed", "m/s", 1), hd.Parameter("push", "N", 1)
RATE, MASS, TIME = hd.Parameter("rate", "rad/s", 3), hd.Parameter("mass", "kg", 1), hd.Parameter("rise", "s", 1)
INERTIA, MU = hd.Parameter("inertia", "kg m^2", 1e-3), hd.Parameter("mu", "1", 0.1)
GRAVITY = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y)
LAW = power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5)
BLOCK = hd.Body("block", MASS, INERTIA)
HERE, THERE = BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0)


def scene(joint=None, pair=None, *effects, **more):
    joint = hd.Planar("plane", hd.GROUND, BLOCK) if joint is None else joint
    contact = () if pair is None else (hd.Contact(getattr(pair, "name", "touch"), LAW),)
    mechanism = hd.Mechanism("trial", joints=(joint,), pairs=() if pair is None else (pair,))
    return hd.Scene(
        mechanism, effects=(GRAVITY, *contact, *effects), **({"scales": hd.Scales(SIZE, SPEED, SIZE)} | more)
    )


def touching(*effects):
    mechanism = hd.Mechanism(
        "trial", (hd.Planar("plane", hd.GROUND, BLOCK),), (hd.SphereOnPlane("floor", HERE, SIZE, THERE, hd.Y),)
    )
    return hd.Scene(mechanism, effects=(GRAVITY, *effects), scales=hd.Scales(SIZE, SPEED, SIZE))


def joint(record):
    return scene(joint=record)


def pair(record):
    return scene(None, record)


def effect(record):
    return scene(None, None, record)


DECLARED = {
    "body": (BLOCK, lambda body: scene(hd.Planar("plane", hd.GROUND, body))),
    "point": (HERE, lambda place: pair(hd.SphereOnPlane("floor", place, SIZE, THERE, hd.Y))),
    "direction": (hd.X, lambda axis: joint(hd.Prismatic("slide", hd.GROUND, BLOCK, axis=axis))),
    "revolute": (hd.Revolute("pin", hd.GROUND, BLOCK, axis=hd.Z), joint),
    "spherical": (hd.Spherical("ball", hd.GROUND, hd.Body("block", MASS, (INERTIA,) * 3)), joint),
    "sphere": (hd.SphereOnPlane("touch", HERE, SIZE, THERE, hd.Y), pair),
    "spheres": (hd.SphereOnSphere("touch", HERE, THERE, SIZE, SIZE), pair),
    "pin": (hd.PinInBush("touch", HERE, THERE, hd.Z, SIZE, hd.Parameter("gap", "mm", 1)), pair),
    "socket": (hd.BallInSocket("touch", HERE, THERE, SIZE, hd.Parameter("gap", "mm", 1)), pair),
    "cylinder": (hd.CylinderOnPlane("touch", HERE, hd.Z, SIZE, SIZE, THERE, hd.Y), pair),
    "corner": (hd.CornerOnFace("touch", HERE, THERE, hd.Y, hd.X, SIZE), pair),
    "custom": (hd.CustomPair("touch", HERE, THERE, hd.APART[1] - SIZE, (0, 1, 0), (hd.APART[0], 0, hd.APART[2])), pair),
    "gravity": (GRAVITY, lambda record: scene().replace(gravity=record)),
    "contact": (hd.Contact("floor", LAW), touching),
    "friction": (hd.Friction("rub", "floor", smooth_coulomb(MU, SPEED)), lambda record: touching(hd.Contact("floor", LAW), record)),
    "material": (hd.Material(hd.Parameter("E", "GPa", 207), hd.Parameter("nu", "1", 0.3)),
                 lambda record: touching(hd.Contact("floor", hertz_point(record, record)))),
    "constant speed": (hd.ConstantSpeed("drive", "plane.angle", RATE), effect),
    "ramp": (hd.Ramp("drive", "plane.angle", RATE, TIME), effect),
    "harmonic": (hd.Harmonic("drive", "plane.angle", MU, RATE), effect),
    "drive": (hd.Drive("drive", "plane.angle", position=RATE * hd.T), effect),
    "force": (hd.JointForce("push", "plane.x", PUSH), effect),
    "spring": (hd.JointSpring("spring", "plane.x", hd.Parameter("k", "N/m", 1)), effect),
    "damper": (hd.JointDamper("damper", "plane.x", hd.Parameter("d", "N s/m", 1)), effect),
    "point force": (hd.PointForce("push", HERE, (0, PUSH, 0)), effect),
    "scales": (hd.Scales(SIZE, SPEED, SIZE), lambda scales: scene(scales=scales)),
    "start": (hd.Start({"plane.x": SIZE}, {"plane.x_speed": SPEED}), lambda start: scene(start=start)),
    "mechanism": (scene().mechanism, lambda mechanism: hd.Scene(mechanism, (GRAVITY,), hd.Scales(SIZE, SPEED, SIZE))),
    "scene": (scene(), lambda whole: whole),
}  # fmt: skip


def refused(make):
    """The InputError of a declaration, or None where it stands; any other exception, and any warning, is raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            make()
        except hd.InputError as error:
            return error
    return None


@each("name", DECLARED)
def test_every_field_takes_what_it_takes_or_says_so(name):
    record, use = DECLARED[name]
    use(record)
    assert is_dataclass(record)
    reported = 0
    for entry in fields(record):
        for value in BAD:
            error = refused(lambda: use(replace(record, **{entry.name: value})))  # noqa: B023 -- called here
            if error is not None:
                reported += 1
                assert all(len(fault.expected) > 3 and not fault.expected.endswith("one of ") for fault in error.faults)
    assert reported >= 4 * len(fields(record))


@each("value", [None, 5, [1], object()])
@each(
    "make",
    [
        lambda value: hd.Parameter(value, "kg", 1), lambda value: hd.Parameter("mass", value, 1), lambda value: hd.coordinate_of(value),
        lambda value: hd.speed_of(value), lambda value: HERE.turned(value, 0),
        lambda value: touching(hd.Contact("floor", LAW)).with_law("floor", value), lambda value: touching(hd.Contact("floor", LAW)).without(value),
    ],
)  # fmt: skip
def test_functions_refuse_what_is_no_name(make, value):
    assert refused(lambda: make(value)) is not None


def test_a_table_is_no_surface():
    """The second rate of a distance to it would be a third derivative, which a spline does not have."""
    bump = hd.Table("bump", (0, 0.1, 0.2), (0, 0.01, 0), ("m", "m"))
    with pytest.raises(
        hd.InputError, match="found the table bump; expected an expression of APART, TURN and Parameters without"
    ):
        pair(
            hd.CustomPair(
                "touch", HERE, THERE, hd.APART[1] - bump(hd.APART[0]), (0, 1, 0), (hd.APART[0], 0, hd.APART[2])
            )
        )


def test_a_matrix_of_inertia_is_refused_with_the_accepted_forms():
    for matrix in ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], np.eye(3)):
        with pytest.raises(hd.InputError, match=r"body block, inertia[\s\S]*three principal ones"):
            joint(hd.Revolute("pin", hd.GROUND, hd.Body("block", MASS, matrix), axis=hd.Z))


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (lambda: effect(hd.Contact("floor", LAW)), "a pair of the mechanism, which has none"),
        (lambda: joint(hd.Spherical("ball", hd.GROUND, hd.Body("block", MASS, (INERTIA,) * 3))).replace(gravity=hd.JointForce("push", "x", PUSH)),
         "a joint with one coordinate, of which the mechanism has none"),
    ],
)  # fmt: skip
def test_a_list_of_nothing_is_said_in_words(make, expected):
    error = refused(make)
    assert error is not None
    assert expected in str(error)
