"""Contacts of curves in the plane of motion: a cam that turns and a plate that moves freely, their gaps, and what every force owes its energy."""

import casadi as ca
import numpy as np
import sympy as sp
from derived import Derived

import hertzwerk.derive as hd

R, E, L = (hd.Parameter(name, "mm", value) for name, value in (("R", 30), ("e", 5), ("L", 40)))
A, B, HALF = (hd.Parameter(name, "mm", value) for name, value in (("a", 40), ("b", 15), ("half_height", 15)))
CAM, PLATE = (
    hd.Body("cam", hd.Parameter("M", "kg", 1), hd.Parameter("J", "kg m^2", 1e-3)),
    hd.Body("plate", hd.Parameter("m", "kg", 0.2), hd.Parameter("J_p", "kg m^2", 1e-4)),
)
SHAFT, FREE = hd.Revolute("shaft", hd.GROUND, CAM, axis=hd.Z), hd.Planar("free", hd.GROUND, PLATE)
ECCENTRIC = hd.Curve("rim", E + R * sp.cos(hd.S), R * sp.sin(hd.S))
OVAL = hd.Curve("oval", A * sp.cos(hd.S), B * sp.sin(hd.S))
LOBED = hd.Curve("lobed", R * (1 + sp.cos(5 * hd.S) / 5) * sp.cos(hd.S), R * (1 + sp.cos(5 * hd.S) / 5) * sp.sin(hd.S))
# below a line, to the right a half circle, above a round hollow, to the left a notch
BLOCK = hd.Outline(
    "block",
    (0, -HALF),
    [
        hd.Line((L, -HALF)), hd.Arc((L, HALF), (L, 0)), hd.Line(((L + HALF) / 2, HALF)),
        hd.Arc(((L - HALF) / 2, HALF), (L / 2, HALF), clockwise=True), hd.Line((0, HALF)), hd.Line((HALF / 2, 0)), hd.Line((0, -HALF)),
    ],
)  # fmt: skip


def scene(pair, joints=(SHAFT, FREE), **given):
    effects = hd.Contact(pair.name, hd.laws.power(hd.Parameter("K", "N/m", 1e6), 1)), hd.EnergyLedger()
    scales = hd.Scales(length=E, speed=hd.Parameter("pace", "m/s", 1), arm=R)
    return hd.Scene(hd.Mechanism("cam_and_plate", joints, (pair,)), effects, scales, **given)


def gaps(derived, q, u=(0, 0, 0, 0), a=(0, 0, 0, 0)):
    """Gap, its rate and its second derivative."""
    q, u, a = (np.array(x, float) for x in (q, u, a))
    G, dG = derived.call("gaps", q=q, u=u)
    return float(G[0]), float(dG[0]), float(derived.call("gap_accelerations", q=q, u=u, a=a)[0])


def check_shapes(derived, states, h=1e-6, shaped=True):
    """Derivatives of gaps, their rates and the curves' parameters by what shapes the curves, and by places, are differences."""
    derived = Derived(text=derived.text)
    derived.names["_SHAPED"] = shaped
    constants, u = (lambda p: derived.call("constants", p=p)), np.array([0.2, -0.3, 0.4, 0.5])
    a = np.array([0.6, 0.1, -0.2, 0.3])
    steps = [h * at * unit for at, unit in zip(derived.p, np.eye(len(derived.p)), strict=True)]
    moved = {"c": [(constants(derived.p + step), constants(derived.p - step)) for step in steps]}
    for q in map(np.array, states):
        moved["q"] = [(q + h * unit, q - h * unit) for unit in np.eye(4)]
        for which, pairs in moved.items():
            for function, result in (("gaps", 0), ("gaps", 1), ("gap_accelerations", 0), ("outputs", 0)):
                given = {"q": q, "u": u, "a": a, "c": derived.c}

                def value(x, name=which, function=function, result=result, given=given):
                    return np.atleast_2d(derived.call(function, **{**given, name: x}))[result]

                slopes = derived.jacobian(function, which, result, **given)
                for one, other in pairs:
                    expected = value(one) - value(other)
                    size = h * np.abs(value(given[which])).max()
                    assert np.allclose(slopes @ (one - other), expected, rtol=1e-5, atol=1e-5 * size), (
                        function,
                        result,
                    )


def check_gradient(derived, states, h=1e-6, rtol=1e-6, atol=1e-3):
    """Forces are minus the gradient of the stored energy, and their derivatives by CasADi, as implicit methods take them, are differences."""
    check_shapes(derived, states)
    x = ca.SX.sym("x", 4)
    known = {
        "q": x, "u": ca.SX.zeros(4), "z": ca.SX.zeros(len(derived.MEMORY)), "m": ca.SX(0, 1), "c": ca.SX(derived.c), "t": ca.SX(0),
    }  # fmt: skip
    force = derived.names["contact_touch"](*(known[name] for name in derived.arguments("contact_touch")))[0]
    value, slope = ca.Function("force", [x], [force]), ca.Function("slope", [x], [ca.jacobian(force, x)])

    def energy(q):
        return float(derived.call("energy", q=q, u=np.zeros(4))[2][0])

    for q in map(np.array, states):
        assert energy(q) > 0
        moved = [(q + h * e, q - h * e) for e in np.eye(4)]
        down = [(energy(b) - energy(a)) / (2 * h) for a, b in moved]
        assert np.allclose(np.array(value(q)).ravel(), down, rtol=rtol, atol=atol)
        slopes = np.hstack([(np.array(value(a)) - np.array(value(b))) / (2 * h) for a, b in moved])
        assert np.allclose(np.array(slope(q)), slopes, rtol=rtol, atol=100 * atol)
