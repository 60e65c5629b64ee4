"""A point in a track along a curve: the tautochrone, a track that turns, a slot for a hinge; what is refused."""

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

R, G = hd.Parameter("r", "m", 0.5), hd.Parameter("g", "m/s^2", 9.81)
BEAD = hd.Body("bead", hd.Parameter("m", "kg", 0.3), hd.Parameter("J", "kg m^2", 1e-4))
DISC = hd.Body("disc", hd.Parameter("M", "kg", 1), hd.Parameter("J_disc", "kg m^2", 0.1))
SCALES = hd.Scales(length=R, speed=hd.Parameter("pace", "m/s", 1), arm=R)
CYCLOID = hd.Curve("cycloid", R * (hd.S + sp.sin(hd.S)), R * (1 - sp.cos(hd.S)), -3, 3, closed=False)
WIRE = hd.PointInTrack("wire", hd.GROUND, BEAD, CYCLOID)
PLANE = hd.Planar("plane", hd.GROUND, BEAD)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("amplitude", [0.3, 2.5])
def test_the_period_on_a_cycloid_does_not_depend_on_the_amplitude(coordinates, amplitude):
    """Huygens: 4 pi sqrt(r/g)."""
    A = hd.Parameter("A", "rad", amplitude)
    start = hd.Start(position={"plane.x": R * (A + sp.sin(A))}, near={"plane.y": R * (1 - sp.cos(A))})
    effects = (hd.Gravity("gravity", G, direction=-hd.Y), hd.EnergyLedger())
    scene = hd.Scene(hd.Mechanism("tautochrone", (PLANE, WIRE)), effects, SCALES, start, coordinates=coordinates)
    run = simulate(load(scene), duration=f"{4 * np.pi * np.sqrt(0.5 / 9.81)} s", accuracy=1e-8, max_steps=1000)
    assert run.outcome.name == "finished"
    assert run["plane.x"][-1] == pytest.approx(run["plane.x"][0], rel=1e-7)
    assert run["wire.parameter"][[0, -1]] == pytest.approx([amplitude] * 2, abs=1e-7)
    assert np.max(np.abs(run["wire.off_track"])) < 1e-12


def test_on_a_straight_track_that_turns_a_bead_flies_outwards():
    """r'' = w^2 r from rest: r cosh(w t), pressed by the Coriolis force 2 m w r' = 2 m w^2 r sinh(w t)."""
    w = hd.Parameter("w", "rad/s", 3)
    track = hd.PointInTrack("slot", DISC, BEAD, hd.Curve("line", R * hd.S, 0, -1, 40, closed=False))
    joints = hd.Revolute("shaft", hd.GROUND, DISC, axis=hd.Z), PLANE, track
    effects = hd.ConstantSpeed("motor", "shaft", w), hd.EnergyLedger()
    start = hd.Start(position={"plane.x": R / 5, "plane.y": 0}, speed={"plane.y": w * R / 5, "plane.x": 0})
    sling = hd.Scene(hd.Mechanism("sling", joints), effects, SCALES, start)
    run = simulate(load(sling), duration="1 s", accuracy=1e-8, max_steps=1000)
    assert np.hypot(run["plane.x"], run["plane.y"])[-1] == pytest.approx(0.1 * np.cosh(3), rel=1e-7)
    assert abs(run["slot.force_track"][-1]) == pytest.approx(2 * 0.3 * 9 * 0.1 * np.sinh(3), rel=1e-6)


def test_a_track_carries_no_body_and_lies_in_the_plane_of_motion():
    with pytest.raises(hd.InputError, match="bead, which no joint before carries") as error:
        hd.Scene(hd.Mechanism("faulty", (hd.PointInTrack("wire", hd.GROUND, BEAD, "R*cos(S)"),)), (), SCALES)
    assert "joint wire, curve: found \"'R*cos(S)'\"" in str(error.value) or "found 'R*cos(S)'" in str(error.value)
    ground = hd.GROUND.at(0, 0, 0).turned(hd.X, hd.Parameter("tilt", "rad", 0.3))
    tilted = hd.PointInTrack("wire", ground, BEAD, CYCLOID)
    with pytest.raises(hd.InputError, match="motion out of the curve's plane"):
        load(hd.Scene(hd.Mechanism("tilted", (PLANE, tilted)), (), SCALES))
