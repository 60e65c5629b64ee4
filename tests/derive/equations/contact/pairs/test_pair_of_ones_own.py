"""A pair of one's own, in one file: declaration and geometry of touching, run against the built-in pair that it equals."""

import numpy as np
import pytest
from derived import Derived

import hertzwerk.derive as hd
from hertzwerk.derive.common.execute_file import names_defined_by
from hertzwerk.derive.laws import flores, hertz_point, power, smooth_coulomb
from hertzwerk.runtime import load, simulate

FILE = '''
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from hertzwerk.derive import Direction, Pair, Point, Slot, Touch
from hertzwerk.derive.expressions.algebra.vectors import dot


@dataclass(frozen=True)
class Dome(Pair):
    """The lower half of a ball of `radius` on a plane."""

    middle: Point
    plane: Point
    up: Direction
    radius: object
    kind: ClassVar[str] = "dome"
    measures: ClassVar = {"radius": Slot.of("m")}

    @property
    def first_radius(self):
        return self.radius

    @property
    def geometry(self):
        return {"R_eff": self.radius, "R_min": self.radius}

    def touch(self, kinematics):
        return OnPlane(self, kinematics)


class OnPlane(Touch):
    """The height of the middle, less the radius."""

    SIZE = 1

    @cached_property
    def normal(self):
        return self.named(self.kin.direction(self.second, self.pair.up), "up")

    @cached_property
    def gap(self):
        return self.let(self.SIZE * dot(self.normal, self.apart) - self.pair.radius, "gap")


@dataclass(frozen=True)
class Steep(Dome):
    """A dome whose gap is twice the distance."""

    def touch(self, kinematics):
        return TooSteep(self, kinematics)


class TooSteep(OnPlane):
    SIZE = 2


@dataclass(frozen=True)
class Sleeve(Dome):
    """A dome that claims to replace a joint."""

    journal: ClassVar[bool] = True


@dataclass(frozen=True)
class Mute(Pair):
    """A pair that says nothing of how it touches."""

    middle: Point
    plane: Point
'''
RADIUS, MASS = hd.Parameter("radius", "m", 0.05), hd.Parameter("mass", "kg", 0.4)
BALL = hd.Body("ball", MASS, (hd.Parameter("J", "kg m^2", 4e-4),) * 3)
PLACES = BALL.at(0, 0, 0), hd.GROUND.at(0, 0, 0)
LAWS = (
    hd.Contact("touch", power(hd.Parameter("K", "N/m", 4e4), 1), flores(hd.Parameter("restitution", "1", 0.8))),
    hd.Friction("rub", "touch", smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("v_s", "m/s", 0.01))),
)


@pytest.fixture(scope="module")
def kinds(tmp_path_factory):
    file = tmp_path_factory.mktemp("own") / "dome.py"
    file.write_text(FILE)
    return names_defined_by(file)


def scene(pair, *effects):
    start = hd.Start({"fly.y": hd.Parameter("height", "m", 0.08)}, {"fly.x_speed": hd.Parameter("push", "m/s", 0.5)})
    effects = (*(effects or LAWS), hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger())
    mechanism = hd.Mechanism("dome", (hd.Free("fly", hd.GROUND, BALL),), (pair,))
    return hd.Scene(mechanism, effects, hd.Scales(RADIUS, hd.Parameter("pace", "m/s", 1.0), RADIUS), start)


def path(declared):
    run = simulate(load(declared), duration=0.3, tolerance=1e-10)
    assert run.outcome.name == "finished"
    assert len(run.impacts) > 1
    history = run.at(np.linspace(0, 0.3, 7))
    return np.array([history[f"fly.{name}"] for name in ("x", "y", "angular_speed_z")])


def test_a_pair_of_ones_own_touches_as_a_built_in_one_and_offers_its_geometry(kinds):
    wanted = path(scene(hd.SphereOnPlane("touch", PLACES[0], RADIUS, PLACES[1], hd.Y)))
    assert np.ptp(wanted[2]) > 1  # it is rubbed
    assert np.max(np.abs(path(scene(kinds["Dome"]("touch", *PLACES, hd.Y, RADIUS))) - wanted)) < 1e-8
    # K = 4/3 E* sqrt(R_eff), with the radius of the dome.
    names, values, units = ("E_1", "nu_1", "E_2", "nu_2"), (1e9, 0.3, 2e9, 0.3), ("Pa", "1", "Pa", "1")
    given = zip(names, units, values, strict=True)
    steel = {name: hd.Parameter(name, unit, value) for name, unit, value in given}
    derived = Derived(scene(kinds["Dome"]("touch", *PLACES, hd.Y, RADIUS), hd.Contact("touch", hertz_point(**steel))))
    constants = dict(zip((name for name, _ in derived.CONSTANTS), derived.c, strict=True))
    E_eff = 1 / ((1 - 0.3**2) / 1e9 + (1 - 0.3**2) / 2e9)
    assert constants["touch_K"] == pytest.approx(4 / 3 * E_eff * RADIUS.si**0.5, rel=1e-12)


def test_pairs_of_ones_own_that_do_not_fit_are_refused(kinds):
    with pytest.raises(hd.InputError, match=r"pair touch, gap: found a rate of .* where the bodies approach at"):
        hd.generate(scene(kinds["Steep"]("touch", *PLACES, hd.Y, RADIUS)))
    with pytest.raises(hd.InputError, match="pair touch: found a journal without an eccentricity"):
        hd.generate(scene(kinds["Sleeve"]("touch", *PLACES, hd.Y, RADIUS)))
    with pytest.raises(hd.InputError, match="pair touch, up: found 3"):
        scene(kinds["Dome"]("touch", *PLACES, 3, RADIUS))
    with pytest.raises(hd.InputError, match="pair touch: found Mute, a kind of pair without equations"):
        hd.generate(scene(kinds["Mute"]("touch", *PLACES)))
    assert kinds["Mute"]("touch", *PLACES).form == "point"
