"""Andrews' squeezing mechanism: seven bodies in three loops through one point, driven by a torque.

No contact: the equations of closed loops alone, against the digits of the reference solution that every solver of
constrained motion is tried with. Names are those of the source: body K1 turns by beta, K2 against it by Theta, K3 by
gamma, K5 by delta, K4 against it by Phi, K7 by epsilon, K6 against it by Omega (grade A).

Source: Schiehlen (ed.), Multibody Systems Handbook (Springer 1990), 10; Hairer, Wanner, Solving Ordinary Differential
Equations II (Springer 1996), VII.7; Mazzia, Magherini, Test Set for Initial Value Problem Solvers (Bari 2008), II-11.
"""

from hertzwerk.derive import (
    GROUND,
    Body,
    EnergyLedger,
    JointForce,
    Mechanism,
    Parameter,
    PointSpring,
    Revolute,
    Scales,
    Scene,
    Start,
    Z,
)


def _m(name: str, value: float, meaning: str = "") -> Parameter:
    return Parameter(name, "m", value, meaning)


masses = (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498)
inertias = (2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5)
rr, ra = _m("rr", 7e-3, "length of K1"), _m("ra", 0.92e-3)
d, da = _m("d", 28e-3, "length of K2"), _m("da", 11.5e-3)
ss, sa, sb = _m("ss", 35e-3, "length of K3"), _m("sa", 18.74e-3), _m("sb", 10.43e-3)
sc, sd = _m("sc", 18e-3), _m("sd", 20e-3)
e, ea = _m("e", 20e-3, "length of K4"), _m("ea", 14.21e-3)
zt, ta, tb = _m("zt", 40e-3, "length of K5"), _m("ta", 23.08e-3), _m("tb", 9.16e-3)
zf, fa = _m("zf", 20e-3, "length of K6"), _m("fa", 14.21e-3)
u, ua, ub = _m("u", 40e-3, "length of K7"), _m("ua", 12.28e-3), _m("ub", 4.49e-3)
A = GROUND.at(_m("xa", -69.34e-3), _m("ya", -2.27e-3), 0)
B = GROUND.at(_m("xb", -36.35e-3), _m("yb", 32.73e-3), 0)
C = GROUND.at(_m("xc", 14e-3), _m("yc", 72e-3), 0)

# In the frame of each body its mass centre, and the end that joins the others.
centres = ((ra, 0), (-da, 0), (sb, -sa), (0, ea - e), (ta, tb), (zf - fa, 0), (ua, -ub))
K1, K2, K3, K4, K5, K6, K7 = (
    Body(f"K{i}", Parameter(f"m{i}", "kg", mass), Parameter(f"i{i}", "kg m^2", inertia), centre=(x, y, 0))
    for i, mass, inertia, (x, y) in zip(range(1, 8), masses, inertias, centres, strict=True)
)
end = K2.at(-d, 0, 0)

mechanism = Mechanism(
    "andrews_squeezer",
    joints=(
        Revolute("beta", GROUND, K1, axis=Z),
        Revolute("Theta", K1.at(rr, 0, 0), K2, axis=Z),
        Revolute("gamma", B, K3, axis=Z),
        Revolute("delta", A, K5, axis=Z),
        Revolute("Phi", K5.at(zt, 0, 0), K4, axis=Z),
        Revolute("epsilon", A, K7, axis=Z),
        Revolute("Omega", K7.at(0, -u, 0), K6, axis=Z),
        Revolute("knee_3", end, K3.at(0, -ss, 0), axis=Z),
        Revolute("knee_4", end, K4.at(0, -e, 0), axis=Z),
        Revolute("knee_6", end, K6.at(zf, 0, 0), axis=Z),
    ),
)

near = {"Theta": 0.0, "gamma": 0.45, "Phi": 0.22, "delta": 0.49, "Omega": -0.22, "epsilon": 1.23}

scene = Scene(
    mechanism,
    effects=(
        JointForce("motor", "beta", Parameter("mom", "N m", 33e-3, "torque of the motor")),
        PointSpring("spring", K3.at(sd, -sc, 0), C, Parameter("c0", "N/m", 4530), rest_length=_m("l0", 77.85e-3)),
        EnergyLedger(),
    ),
    start=Start(
        position={"beta": Parameter("beta_0", "rad", -0.0617138900142764496358948458001)},
        near={name: Parameter(f"{name}_near", "rad", value) for name, value in near.items()},
    ),
    scales=Scales(length=rr, speed=Parameter("speed_scale", "m/s", 7), arm=rr),
    summary="seven bodies in three loops, a solver benchmark",
)
