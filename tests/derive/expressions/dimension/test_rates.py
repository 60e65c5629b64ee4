"""An angular speed and a frequency are of one dimension and two things: where one stands for the other, the error offers both readings."""

import math

import pytest
import sympy as sp
from each import each

import hertzwerk.derive as hd
from hertzwerk.derive.common.units import parse_unit, rate_remedy
from hertzwerk.derive.exchange.user_files.law_file import read_laws
from hertzwerk.runtime import load, simulate

ANGULAR = ("rad/s", "rpm", "deg/s", "rev/min", "krad/s", "mrad/ms", "1/s*rad", "rad s^-1", "°/s", "(rad)/(s)")
PLAIN = ("1/s", "1/min", "1/ms", "s^-1", "1/h", "m/(m s)", "N/(N s)", "rad/(deg s)", "%/s")


@each("one", ANGULAR + PLAIN)
@each("other", ANGULAR + PLAIN)
def test_of_two_rates_one_is_mistaken_where_it_alone_counts_an_angle(one, other):
    assert parse_unit(one).exponents == parse_unit(other).exponents
    assert parse_unit(one).mistaken_for(parse_unit(other)) == ((one in ANGULAR) != (other in ANGULAR))


@each(
    ("one", "other"),
    [
        ("1", "rad"), ("N m", "N m/rad"), ("N m s", "N m s/rad"), ("m/s", "m rad/s"), ("deg", "%"), ("s", "s/rad"),
        ("1/s", "1/s^2"),
    ],
)  # fmt: skip
def test_an_angle_counts_in_rates_alone(one, other):
    assert not parse_unit(one).mistaken_for(parse_unit(other))
    assert not parse_unit(other).mistaken_for(parse_unit(one))


def test_accelerations_of_angles_are_rates_too():
    assert parse_unit("1/s^2").mistaken_for(parse_unit("rad/s^2"))
    assert "rev/s^2" in rate_remedy(parse_unit("1/s^2"))


@pytest.fixture(scope="module")
def crank():
    return load("slider_crank")


@each("text", ["5000 1/min", "83.333333333333333 1/s", "0.083333333333333333 1/ms"])
def test_a_frequency_for_the_speed_of_a_crank_offers_both_readings(crank, text):
    """5000 turns a minute are 5000 rpm; 5000 radians a minute, as the number was read before, 83.3 rad/s."""
    with pytest.raises(hd.InputError) as caught:
        crank.bind({"crank_speed": text})
    (fault,) = caught.value.faults
    assert fault.where == "crank_speed"
    assert fault.found.endswith(", a frequency")
    assert '"5000 rpm" where it counts turns, "83.3333 rad/s" where it counts radians' in fault.remedy


@each("text", ["5000 rpm", "30000 deg/s", f"{5000 * math.pi / 30!r} rad/s", "83.333333333333333 rev/s"])
def test_angular_speeds_are_taken(crank, text):
    assert crank.bind({"crank_speed": text})["crank_speed"] == pytest.approx(5000 * math.pi / 30, rel=1e-15)


def test_initial_speeds_and_hertz_say_what_to_write(crank):
    with pytest.raises(hd.InputError, match=r'write "300 rpm" where it counts turns, "5 rad/s"'):
        simulate(crank, duration="1 ms", initial={"crank_pin.speed": "5 1/s"})
    with pytest.raises(hd.InputError, match=r"rpm \(1 Hz of turns is 60 rpm\) or rad/s"):
        crank.bind({"crank_speed": "83 Hz"})


def wheel(speed, **more):
    """A wheel that is driven, and a block that slides."""
    body, block, size = (
        hd.Body("wheel", hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1)),
        hd.Body("block", mass=hd.Parameter("b", "kg", 1)),
        hd.Parameter("size", "m", 1),
    )
    return hd.Scene(
        hd.Mechanism("wheel", (hd.Revolute("axle", hd.GROUND, body, hd.Z), hd.Prismatic("way", hd.GROUND, block, hd.X))), (speed,),
        hd.Scales(length=size, speed=hd.Parameter("pace", "m/s", 1), arm=size), **more,
    )  # fmt: skip


def test_declarations_are_held_to_it():
    for frequency in (hd.Parameter("freq", "1/min", 5000), -hd.Parameter("freq", "1/min", 5000)):
        with pytest.raises(hd.InputError, match=r"freq \[1/min\], a frequency.*\n.*rpm or rad/s"):
            wheel(hd.ConstantSpeed("motor", "axle", frequency))
    assert wheel(
        hd.ConstantSpeed("motor", "axle", 2 * sp.pi * hd.Parameter("freq", "1/min", 5000))
    )  # turns made radians
    with pytest.raises(hd.InputError, match=r"g \[1/s\], a frequency"):
        wheel(hd.Harmonic("motor", "axle", hd.Parameter("swing", "rad", 1), hd.Parameter("g", "1/s", 3)))
    table = hd.Table("ramp", (0, 1), (0, 50), ("s", "1/s"))
    with pytest.raises(hd.InputError, match=r"\[1/s\], a frequency"):
        wheel(hd.Drive("motor", "axle", speed=table(hd.T)))
    with pytest.raises(hd.InputError, match=r"s_0 \[1/s\], a frequency"):
        wheel(
            hd.ConstantSpeed("motor", "way", hd.Parameter("w", "m/s", 1)),
            start=hd.Start(speed={"axle": hd.Parameter("s_0", "1/s", 1)}),
        )


DECAY = """
[[law]]
name = "tired"
kind = "damping"
source = "measured"
term = "c*d*v"
symbols.c = { unit = "N s/m^2", meaning = "damping" }
symbols.r = { unit = "1/s", meaning = "rate of decay", limits = "[0, LIMIT]" }
"""


def test_a_decay_rate_takes_1_per_s_and_no_angular_speed(tmp_path):
    file = tmp_path / "laws.toml"
    file.write_text(DECAY.replace("LIMIT", "60 1/min"))
    assert read_laws(file)[0].law.parameters[1].limit.upper == 1
    file.write_text(DECAY.replace("LIMIT", "60 rpm"))
    with pytest.raises(hd.InputError, match=r'a decay is given in 1/s: "1 1/s" of turns, "6.28319 1/s" of radians'):
        read_laws(file)
