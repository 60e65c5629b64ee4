"""Faults of flexible rods: each states what was found and the way out."""

import pytest
from drop import SCALES, refused

import hertzwerk.derive as hd
from hertzwerk.derive import GROUND, FlexibleRod, Parameter, X, Z
from hertzwerk.derive.laws import power, tsuji

LENGTH, MASS, STIFF = Parameter("rod_length", "m", 1), Parameter("rod_mass", "kg", 1), Parameter("stiff", "N m^2", 10)


def rod(length=LENGTH, mass=MASS, stiffness=STIFF, **options):
    return FlexibleRod("rod", length, mass, stiffness, **options)


def scene(*joints, pairs=(), effects=(), **options):
    return hd.Scene(hd.Mechanism("beam", joints, pairs), (*effects, hd.EnergyLedger()), SCALES, **options)


@pytest.mark.parametrize(
    ("options", "where", "expected"),
    [
        ({"modes": 0}, "modes", "from 1 to 12"), ({"modes": 13}, "modes", "from 1 to 12"),
        ({"ends": ("clamped", "held")}, "ends", "clamped, pinned or free"), ({"cubics": 1}, "cubics", "True or False"),
        ({"stations": (50, 50)}, "stations", "different whole percentages"), ({"stations": (0.5,)}, "stations", "different whole percentages"),
        ({"stiffness": "stiff"}, "stiffness", "a Parameter"), ({"section_modulus": "W"}, "section_modulus", "a Parameter"),
    ],
)  # fmt: skip
def test_a_rod_that_cannot_be_is_refused(options, where, expected):
    refused(lambda: rod(**options), where, repr(options[where]), expected)


@pytest.mark.parametrize(
    ("options", "where", "expected"),
    [
        ({"length": Parameter("none", "m", 0)}, "length", "(0, inf)"), ({"mass": Parameter("none", "kg", -1)}, "mass", "(0, inf)"),
        ({"stiffness": Parameter("none", "N m^2", 0)}, "stiffness", "(0, inf)"), ({"stiffness": Parameter("none", "N/m", 1)}, "stiffness", "N m^2"),
        ({"damping_ratio": Parameter("none", "1", -0.1)}, "damping ratio", "[0, inf)"),
        ({"section_modulus": Parameter("none", "m^2", 1)}, "section modulus", "m^3"),
    ],
)  # fmt: skip
def test_its_quantities_have_units_and_ranges(options, where, expected):
    beam = rod(**options)
    refused(lambda: scene(hd.Weld("clamp", GROUND, beam.start), beam), where, "", expected)


def test_its_ends_are_carried_in_order_and_take_forces():
    beam = rod()
    refused(lambda: scene(beam), "joint rod", "rod_start", "to the ground by a joint")
    end_first = hd.Weld("clamp", GROUND, beam.start), hd.Planar("base", GROUND, beam.end), beam
    refused(lambda: scene(*end_first), "joint rod", "whose end another joint carries", "Declare the rod before")
    joints = hd.Weld("clamp", GROUND, beam.start), beam
    spring = hd.JointSpring("spring", "rod.bending", Parameter("k", "N/m", 1))
    refused(lambda: scene(*joints, effects=(spring,)), "effect spring", "rod.bending", "a joint with one coordinate")
    where = FlexibleRod("other", LENGTH, MASS, STIFF).end.at(0, 0, 0)
    push = hd.PointForce("push", where, (Parameter("F", "N", 1), 0, 0))
    refused(lambda: scene(*joints, effects=(push,)), "effect push", "body other_end", "one of rod_start, rod_end")


def test_a_law_that_depends_on_masses_is_given_that_of_the_end():
    beam, slider = rod(), hd.Body("slider", Parameter("slider_mass", "kg", 1))
    joints = hd.Weld("clamp", GROUND, beam.start), beam, hd.Prismatic("guide", GROUND.at(LENGTH, 0, 0), slider, X)
    pin = hd.PinInBush(
        "pin", slider.at(0, 0, 0), beam.end.at(0, 0, 0), Z, bush_radius=Parameter("R", "mm", 10), clearance=Parameter("c", "mm", 1),
    )  # fmt: skip
    laws = power(Parameter("K", "N/m^1.5", 1e8), 1.5), tsuji(Parameter("xi", "1", 0.1))

    def touching(**options):
        return scene(*joints, pairs=(pin,), effects=(hd.Contact("pin", *laws, **options),))

    refused(touching, "effect pin", "without m_eff", "requires it")
    assert touching(effective_mass=Parameter("m", "kg", 0.2)).contacts


def test_it_starts_straight_unless_bent_by_its_start():
    beam = rod()
    bent = hd.Start(position={"rod.bend_1": Parameter("bent", "mm", 1)})
    made = scene(hd.Weld("clamp", GROUND, beam.start), beam, start=bent)
    (freedom,) = made.free
    assert made.start.coordinates(freedom)[1:] == [0]
    assert made.start.stated(freedom) == ["rod.bend_1", "rod.bend_2", "rod.bend_1_speed", "rod.bend_2_speed"]
