"""The list of a model's histories is a table that people read."""

import re
from functools import cache

import hertzwerk.derive as hd
from hertzwerk.runtime import load
from hertzwerk.runtime.output.tables.history_meanings import Entry, Histories

RADIUS = hd.Parameter("radius", "mm", 20)
BALL = hd.Body("ball", hd.Parameter("mass", "kg", 0.1), (hd.Parameter("J", "kg m^2", 1e-5),) * 3)


@cache
def shown(name):
    return repr(load(name).histories)


def test_histories_are_shown_as_a_table_of_entries():
    lines = shown("bouncing_ball").splitlines()
    assert lines[0] == "in every run:" and "derived on request:" in lines
    row = next(line for line in lines if line.startswith("floor.normal_force "))
    assert re.fullmatch(r"floor\.normal_force +N +normal force, of floor", row)
    at = row.index("N")
    assert all(line[at - 1] == " " and line[at] != " " for line in lines if not line.endswith(":"))
    assert load("bouncing_ball").histories._repr_html_().count("<tr>") == len(load("bouncing_ball").histories) + 1
    actual = load("bouncing_ball").histories
    assert actual[0] == Entry("t", "s", "time", derived=False) and isinstance(actual[1:2], tuple)
    assert repr(Histories()) == ""


def test_two_directions_of_sliding_are_distinguished_from_a_mode():
    floor = hd.SphereOnPlane("floor", BALL.at(0, 0, 0), RADIUS, hd.GROUND.at(0, 0, 0), normal=hd.Z)
    contact = hd.Contact("floor", hd.laws.power(hd.Parameter("K", "N/m^1.5", 1e6), 1.5))
    rubbing = hd.Friction(
        "rubbing", "floor", hd.laws.coulomb(mu_k=hd.Parameter("mu", "1", 0.2), mu_s=hd.Parameter("mu_s", "1", 0.2))
    )
    scales = hd.Scales(RADIUS, hd.Parameter("pace", "m/s", 1), arm=RADIUS)
    model = load(
        hd.Scene(hd.Mechanism("ball", (hd.Free("flight", hd.GROUND, BALL),), (floor,)), (contact, rubbing), scales)
    )
    reported = {entry.name: entry.meaning for entry in model.histories}
    assert reported["floor.slip_1"] == "direction of sliding, zero while it sticks, of floor, along its tangent 1"
    assert reported["floor.friction_force_2"] == "friction force of floor, along its tangent 2"
    assert reported["floor.slip"].startswith("mode of set-valued friction: ")
