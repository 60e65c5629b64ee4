"""bouncing_ball: ball dropped on a plane. Generated from derive/scenes/bouncing_ball.py.

Do not edit; regenerate with `hertzwerk derive bouncing_ball`.
Effects:
    gravity: uniform gravity
    floor: power x flores
    energy_ledger: work put in, energy dissipated per effect
Units: 16 assignments and 77 outputs checked, all consistent
Operations: flight 4 (equations of motion and gaps); in contact also contact_floor 14
"""

import casadi as ca

NAME = "bouncing_ball"
SOURCE = "derive/scenes/bouncing_ball.py"
SUMMARY = "ball dropped on a plane"
FORMAT = "hertzwerk module 1"
DIGEST = "ff76323c22e831d0b54efb3d08fa4f43"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("floor", "contact", "power x flores"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 1, "body ball, mass"),
    ("radius", "m", 0.1, "pair floor, radius"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^exponent", 24000000000.0, "effect floor, stiffness of power"),
    ("exponent", "1", 1.5, "exponent of the force law"),
    ("restitution", "1", 0.9, "effect floor, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("drop_height", "m", 1, "gap at the start"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body ball, mass"),
    ("radius", "defined", 0, None, True, False, "pair floor, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect floor, stiffness of power"),
    ("exponent", "defined", 1, 10, False, False, "effect floor, exponent of power"),
    ("restitution", "defined", 0, 1, True, False, "effect floor, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect floor, approach floor"),
)

COORDINATES = (("vertical.travel", "m"),)

SPEEDS = (("vertical.speed", "m/s"),)

MEMORY = (("floor.dissipated", "J"),)

LATCHES = (("floor.approach_speed", "m/s", 0),)

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
    ("mass", "kg"), ("radius", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m^exponent"), ("exponent", "1"), ("k1", "N/m^exponent"),
    ("floor_hysteresis_factor", "1"), ("inverse_mass", "1/kg"), ("half_mass", "kg"), ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 9), ("start", 1), ("scales", 16), ("coordinate_rates", 0), ("gaps", 1), ("gap_accelerations", 0), ("contact_floor", 14),
    ("applied", 2), ("accelerations", 1), ("ledger", 0), ("energy", 11), ("poses", 0), ("outputs", 1), ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = ()
SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (10,): mass, radius, gravity, stiffness, exponent, k1, floor_hysteresis_factor, inverse_mass, half_mass, gravity_times_mass
    """
    mass, radius, gravity, stiffness, exponent, restitution = p[0], p[1], p[2], p[3], p[4], p[5]
    k1 = stiffness/(1 + exponent)
    floor_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_mass = 1/mass
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(mass, radius, gravity, stiffness, exponent, k1, floor_hysteresis_factor, inverse_mass, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    radius, drop_height = p[1], p[7]
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
    mass, gravity, stiffness, exponent, drop_height = p[0], p[2], p[3], p[4], p[7]
    energy_scale = drop_height*gravity*mass
    one_plus_exponent = 1 + exponent
    x2 = one_plus_exponent*drop_height*gravity*mass/stiffness
    force_scale = energy_scale*x2**(-1/one_plus_exponent)
    x3 = x2**(1/one_plus_exponent)
    sqrt_2 = ca.sqrt(2)
    drop_height_times_gravity = drop_height*gravity
    x6 = ca.sqrt(drop_height_times_gravity)
    x7 = sqrt_2*x6
    return ca.vertcat(x3), ca.vertcat(x7), ca.vertcat(energy_scale), ca.vertcat(x3, x7, force_scale, energy_scale)


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
    """Forces of floor: power x flores. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): vertical [N]
        dz (1,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    radius, stiffness, exponent, floor_hysteresis_factor = c[1], c[3], c[4], c[6]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_approach_speed = m[0]
    floor_gap = vertical_travel - radius
    floor_elastic_force = ca.if_else(-floor_gap > 0, (-floor_gap)**exponent*stiffness, 0)
    floor_resistance = -floor_elastic_force*floor_hysteresis_factor*vertical_speed/floor_approach_speed
    floor_normal_force = floor_elastic_force + floor_resistance
    floor_normal_power = -floor_resistance*vertical_speed
    return ca.vertcat(floor_normal_force), ca.vertcat(floor_normal_power), ca.vertcat(floor_normal_force), ca.vertcat(), ca.vertcat(1)


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
    inverse_mass = c[7]
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
    radius, exponent, k1, half_mass, gravity_times_mass = c[1], c[4], c[5], c[8], c[9]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_gap = vertical_travel - radius
    floor_stored_energy = ca.if_else(-floor_gap > 0, k1*(-floor_gap)**(1 + exponent), 0)
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
