"""Pairs of many spheres: the same module as pairs by hand, one law for all, its exceptions, and what is refused."""

from itertools import combinations

import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power, smooth_coulomb

M, J, R = hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1e-3), hd.Parameter("radius", "m", 0.05)
K, PACE = hd.Parameter("stiffness", "N/m^1.5", 1e7), hd.Parameter("pace", "m/s", 1)
LAW = power(K, n=1.5)
RUB = smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("creep", "m/s", 1e-3))


def bodies(n, centre=(0, 0, 0)):
    return [hd.Body(f"ball_{i}", M, J, centre=centre) for i in range(1, n + 1)]


def scene(balls, pairs, effects):
    joints = tuple(hd.Planar(f"free_{i}", hd.GROUND, ball) for i, ball in enumerate(balls))
    start = hd.Start(position={f"free_{i}.x": hd.Parameter(f"x_{i}", "m", 0.2 * i) for i in range(len(balls))})
    return hd.Scene(hd.Mechanism("many", joints, pairs), effects, hd.Scales(length=R, arm=R, speed=PACE), start)


def test_the_module_is_that_of_pairs_by_hand():
    balls = bodies(4, centre=(0, R / 2, 0))
    names = [f"balls_{i}_{j}" for i, j in combinations(range(1, 5), 2)]
    by_hand = tuple(
        hd.SphereOnSphere(name, one.at(0, R / 2, 0), two.at(0, R / 2, 0), R, R)
        for name, (one, two) in zip(names, combinations(balls, 2), strict=True)
    )
    effects = (
        *(hd.Contact(name, LAW) for name in names),
        *(hd.Friction(f"rub{name[5:]}", name, RUB) for name in names),
    )
    many = scene(balls, hd.every_pair("balls", balls, R), (hd.Contact("balls", LAW), hd.Friction("rub", "balls", RUB)))
    assert hd.generate(many) == hd.generate(scene(balls, by_hand, effects))


def test_one_name_stands_for_all_and_an_own_law_for_one():
    balls = bodies(3)
    own = power(hd.Parameter("soft", "N/m", 1e5), n=1)
    many = scene(balls, hd.every_pair("balls", balls, R), (hd.Contact("balls", LAW), hd.Contact("balls_1_3", own)))
    assert {effect.pair: effect.stiffness for effect in many.all(hd.Contact)} == {
        "balls_1_2": LAW, "balls_1_3": own, "balls_2_3": LAW,
    }  # fmt: skip
    assert not many.without("balls").all(hd.Contact)


def test_every_fault_is_listed_and_points_of_one_body_make_no_pair():
    dumb_bell, ball = bodies(2)
    pairs = hd.every_pair("balls", [dumb_bell.at(-R, 0, 0), dumb_bell.at(R, 0, 0), ball], R)
    assert [pair.name for pair in pairs] == ["balls_1_3", "balls_2_3"]
    one, two = bodies(2)
    with pytest.raises(hd.InputError) as caught:
        hd.every_pair("a ball", [one, "two", two, one.at(0, 0, 0)], "5 mm")
    places = [(fault.where, fault.found) for fault in caught.value.faults]
    assert places == [
        ("pairs", "the name 'a ball'"), ("pairs a ball, radius", "'5 mm'"), ("pairs a ball, sphere 2", "'two'"),
        ("pairs a ball, sphere 4", "the place of sphere 1"),
    ]  # fmt: skip


@pytest.mark.parametrize("few", [7, [], bodies(1), hd.GROUND.at(0, 0, 0)])
def test_spheres_that_make_no_pair_are_refused(few):
    with pytest.raises(hd.InputError, match="spheres"):
        hd.every_pair("balls", few, R)
