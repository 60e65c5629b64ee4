"""soft_ball: soft elastic ball dropped on a plane. Generated from derive/scenes/soft_ball.py.

Do not edit; regenerate with `hertzwerk derive soft_ball`.
Effects:
    gravity: uniform gravity
    floor: power
    energy_ledger: work put in, energy dissipated per effect
Units: 12 assignments and 75 outputs checked, all consistent
Operations: flight 4 (equations of motion and gaps); in contact also contact_floor 9
"""

import casadi as ca

NAME = "soft_ball"
SOURCE = "derive/scenes/soft_ball.py"
SUMMARY = "soft elastic ball dropped on a plane"
FORMAT = "hertzwerk module 1"
DIGEST = "8b996a0518be5c4e25fdf0f8b73431df"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("floor", "contact", "power"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 1, "body ball, mass"),
    ("radius", "m", 0.1, "pair floor, radius"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^1.5", 140000000.0, "effect floor, stiffness of power"),
    ("drop_height", "m", 1, "gap at the start"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body ball, mass"),
    ("radius", "defined", 0, None, True, False, "pair floor, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect floor, stiffness of power"),
)

COORDINATES = (("vertical.travel", "m"),)

SPEEDS = (("vertical.speed", "m/s"),)

MEMORY = (("floor.dissipated", "J"),)

PAIRS = (("floor", "sphere_on_plane"),)

RELEASES = ("force",)

DISSIPATED = (0,)

OUTPUTS = (("floor.gap", "m"),)

BODIES = ("ball",)

LANDMARKS = (
    ("vertical", "prismatic", "parent", "ground", ("axis",)), ("vertical", "prismatic", "child", "ball", ("axis",)),
    ("floor", "sphere_on_plane", "sphere", "ball", ("radius",)), ("floor", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("ball", "body", "centre", "ball", ()),
)

CONSTANTS = (
    ("mass", "kg"), ("radius", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m^1.5"), ("two_fifths_of_stiffness", "N/m^1.5"),
    ("inverse_mass", "1/kg"), ("half_mass", "kg"), ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 5), ("start", 1), ("scales", 28), ("coordinate_rates", 0), ("gaps", 1), ("gap_accelerations", 0), ("contact_floor", 9),
    ("applied", 2), ("accelerations", 1), ("ledger", 0), ("energy", 13), ("poses", 0), ("outputs", 1), ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = EVENTS = LOADS = FED = RUBBING = ()
GUIDES = SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (8,): mass, radius, gravity, stiffness, two_fifths_of_stiffness, inverse_mass, half_mass, gravity_times_mass
    """
    mass, radius, gravity, stiffness = p[0], p[1], p[2], p[3]
    two_fifths_of_stiffness = 2*stiffness/5
    inverse_mass = 1/mass
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(mass, radius, gravity, stiffness, two_fifths_of_stiffness, inverse_mass, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    radius, drop_height = p[1], p[4]
    return ca.vertcat(drop_height + radius), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, gravity, stiffness, drop_height = p[0], p[2], p[3], p[4]
    energy_scale = drop_height*gravity*mass
    x1 = drop_height*gravity*mass/stiffness
    force_scale = energy_scale*2**(2/5)*5**(3/5)/(5*x1**(2/5))
    x2 = 2**(3/5)
    x3 = 5**(2/5)
    x4 = x1**(2/5)
    x5 = x2*x3*x4/2
    sqrt_2 = ca.sqrt(2)
    drop_height_times_gravity = drop_height*gravity
    x8 = ca.sqrt(drop_height_times_gravity)
    x9 = sqrt_2*x8
    return ca.vertcat(x5), ca.vertcat(x9), ca.vertcat(energy_scale), ca.vertcat(x5, x9, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [m/s]
    """
    vertical_speed = u[0]
    return ca.vertcat(vertical_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    radius = c[1]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_gap = vertical_travel - radius
    return ca.vertcat(floor_gap), ca.vertcat(vertical_speed)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    vertical_acceleration = a[0]
    return ca.vertcat(vertical_acceleration)


def contact_floor(t, q, u, z, m, c):
    """Forces of floor: power. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): vertical [N]
        dz (1,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    radius, stiffness = c[1], c[3]
    vertical_travel = q[0]
    floor_gap = vertical_travel - radius
    floor_elastic_force = ca.if_else(-floor_gap > 0, -floor_gap*ca.sqrt(-floor_gap)*stiffness, 0)
    return ca.vertcat(floor_elastic_force), ca.vertcat(0), ca.vertcat(floor_elastic_force), ca.vertcat(), ca.vertcat(1)


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): vertical [N]
    """
    mass, gravity = c[0], c[2]
    return ca.vertcat(-gravity*mass)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): vertical.acceleration [m/s^2]
        reactions (0,): empty
    """
    inverse_mass = c[5]
    vertical_force = f[0]
    vertical_acc = inverse_mass*vertical_force
    return ca.vertcat(vertical_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (1,): MEMORY [W]
    """
    return ca.vertcat(0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    radius, two_fifths_of_stiffness, half_mass, gravity_times_mass = c[1], c[4], c[6], c[7]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_gap = vertical_travel - radius
    floor_stored_energy = ca.if_else(-floor_gap > 0, two_fifths_of_stiffness*(-floor_gap)**2*ca.sqrt(-floor_gap), 0)
    kinetic = half_mass*vertical_speed*vertical_speed
    potential = gravity_times_mass*vertical_travel
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(floor_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball.x [m], ball.y [m], ball.z [m]
        rotations (9,): ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy
            [1], ball.R_zz [1]
    """
    vertical_travel = q[0]
    return ca.vertcat(0, vertical_travel, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (1,): OUTPUTS
    """
    radius = c[1]
    vertical_travel = q[0]
    floor_gap = vertical_travel - radius
    return ca.vertcat(floor_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        vertical.parent, vertical.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        floor.sphere (4,): x [m], y [m], z [m], radius [m]
        floor.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball.centre (3,): x [m], y [m], z [m]
    """
    radius = p[1]
    return (ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0))
