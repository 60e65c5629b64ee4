"""pendulum: pendulum let go horizontal. Generated from derive/scenes/pendulum.py.

Do not edit; regenerate with `hertzwerk derive pendulum`.
Effects:
    gravity: uniform gravity
    energy_ledger: work put in, energy dissipated per effect
Units: 14 assignments and 52 outputs checked, all consistent
Operations: flight 6 (equations of motion and gaps)
"""

import casadi as ca

NAME = "pendulum"
SOURCE = "derive/scenes/pendulum.py"
SUMMARY = "pendulum let go horizontal"
FORMAT = "hertzwerk module 1"
DIGEST = "b4434f280408973a7501e80205df8be3"

EFFECTS = (("gravity", "gravity", "uniform gravity"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"))

PARAMETERS = (
    ("mass", "kg", 1.0, "body bob, mass"),
    ("length", "m", 1.0, "of the rod"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("start_angle", "deg", -90, "from hanging"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body bob, mass"),
    ("length", "defined", 0, None, True, False, "scales, length"),
)

COORDINATES = (("hinge.angle", "rad"),)

SPEEDS = (("hinge.speed", "rad/s"),)

BODIES = ("bob",)

LANDMARKS = (
    ("hinge", "revolute", "parent", "ground", ("axis",)), ("hinge", "revolute", "child", "bob", ("axis",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("bob", "body", "centre", "bob", ()),
)

CONSTANTS = (
    ("length", "m"), ("gravity", "m/s^2"), ("bob_h_y", "kg m"), ("inverse_bob_I_z_z", "1/(kg m^2)"), ("half_bob_I_z_z", "kg m^2"),
    ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 7), ("start", 0), ("scales", 7), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 5),
    ("accelerations", 1), ("ledger", 0), ("energy", 7), ("poses", 3), ("outputs", 0), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = CONSTRAINTS = ROLLING = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (6,): length, gravity, bob_h_y, inverse_bob_I_z_z, half_bob_I_z_z, gravity_times_mass
    """
    mass, length, gravity = p[0], p[1], p[2]
    bob_h_y = -length*mass
    bob_I_z_z = length*length*mass
    inverse_bob_I_z_z = 1/bob_I_z_z
    half_bob_I_z_z = bob_I_z_z/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(length, gravity, bob_h_y, inverse_bob_I_z_z, half_bob_I_z_z, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    start_angle = p[3]
    return ca.vertcat(start_angle), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, length, gravity = p[0], p[1], p[2]
    energy_scale = gravity*length*mass/2
    force_scale = energy_scale/length
    gravity_times_length = gravity*length
    x2 = ca.sqrt(gravity_times_length)
    return ca.vertcat(1), ca.vertcat(x2/length), ca.vertcat(), ca.vertcat(length, x2, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [rad/s]
    """
    hinge_speed = u[0]
    return ca.vertcat(hinge_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G, dG (0,): empty
    """
    return ca.vertcat(), ca.vertcat()


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (0,): empty
    """
    return ca.vertcat()


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): hinge [N m]
    """
    gravity, bob_h_y = c[1], c[2]
    hinge_angle = q[0]
    sin_bob = ca.sin(hinge_angle)
    bob_moment_x = -bob_h_y*sin_bob
    return ca.vertcat(-bob_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): hinge.acceleration [rad/s^2]
        reactions (0,): empty
    """
    inverse_bob_I_z_z = c[3]
    hinge_force = f[0]
    hinge_acc = hinge_force*inverse_bob_I_z_z
    return ca.vertcat(hinge_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (0,): empty
    """
    return ca.vertcat()


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (0,): empty
    """
    length, half_bob_I_z_z, gravity_times_mass = c[0], c[4], c[5]
    hinge_angle = q[0]
    hinge_speed = u[0]
    cos_bob = ca.cos(hinge_angle)
    kinetic = half_bob_I_z_z*hinge_speed*hinge_speed
    bob_centre_arm_y = -cos_bob*length
    potential = gravity_times_mass*(bob_centre_arm_y + length)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): bob.x [m], bob.y [m], bob.z [m]
        rotations (9,): bob.R_xx [1], bob.R_xy [1], bob.R_xz [1], bob.R_yx [1], bob.R_yy [1], bob.R_yz [1], bob.R_zx [1], bob.R_zy [1],
            bob.R_zz [1]
    """
    length = c[0]
    hinge_angle = q[0]
    cos_bob = ca.cos(hinge_angle)
    sin_bob = ca.sin(hinge_angle)
    return ca.vertcat(0, length, 0), ca.vertcat(cos_bob, -sin_bob, 0, sin_bob, cos_bob, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (0,): empty
    """
    return ca.vertcat()


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        hinge.parent, hinge.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        bob.centre (3,): x [m], y [m], z [m]
    """
    length = p[1]
    return ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, -length, 0)
