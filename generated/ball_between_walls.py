"""ball_between_walls: ball between two walls. Generated from derive/scenes/ball_between_walls.py.

Do not edit; regenerate with `hertzwerk derive ball_between_walls`.
Effects:
    left_wall, right_wall: power x hunt_crossley
    energy_ledger: work put in, energy dissipated per effect
Units: 24 assignments and 92 outputs checked, all consistent
Operations: flight 8 (equations of motion and gaps); in contact also contact_left_wall 14, contact_right_wall 14
"""

import casadi as ca

NAME = "ball_between_walls"
SOURCE = "derive/scenes/ball_between_walls.py"
SUMMARY = "ball between two walls"
FORMAT = "hertzwerk module 1"
DIGEST = "069579cb6e7e6488148d56b23a2aa04a"

EFFECTS = (
    ("left_wall", "contact", "power x hunt_crossley"), ("right_wall", "contact", "power x hunt_crossley"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 1.6, "body ball, mass"),
    ("radius", "m", 0.1, "pair left_wall, radius"),
    ("gap", "m", 0.4, "from the ball in the middle to either wall"),
    ("stiffness", "N/m", 1000000.0, "effect left_wall, stiffness of power"),
    ("restitution", "1", 0.9, "effect left_wall, coefficient of restitution of hunt_crossley"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("speed", "m/s", 10, "at the start, towards the right wall"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body ball, mass"),
    ("radius", "defined", 0, None, True, False, "pair left_wall, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect left_wall, stiffness of power"),
    ("restitution", "defined", 0, 1, False, False, "effect left_wall, coefficient of restitution of hunt_crossley"),
    ("restitution", "recommended", 0.8, 1, False, False, "effect left_wall, coefficient of restitution of hunt_crossley"),
    ("approach_floor", "defined", 0, None, True, False, "effect left_wall, approach floor"),
    ("speed", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("track.travel", "m"),)

SPEEDS = (("track.speed", "m/s"),)

MEMORY = (("left_wall.dissipated", "J"), ("right_wall.dissipated", "J"))

LATCHES = (("left_wall.approach_speed", "m/s", 0), ("right_wall.approach_speed", "m/s", 1))

PAIRS = (("left_wall", "sphere_on_plane"), ("right_wall", "sphere_on_plane"))

RELEASES = ("force", "force")

DISSIPATED = (0, 1)

OUTPUTS = (("left_wall.gap", "m"), ("right_wall.gap", "m"))

BODIES = ("ball",)

LANDMARKS = (
    ("track", "prismatic", "parent", "ground", ("axis",)), ("track", "prismatic", "child", "ball", ("axis",)),
    ("left_wall", "sphere_on_plane", "sphere", "ball", ("radius",)), ("left_wall", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("right_wall", "sphere_on_plane", "sphere", "ball", ("radius",)), ("right_wall", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball", "body", "centre", "ball", ()),
)

CONSTANTS = (
    ("radius", "m"), ("stiffness", "N/m"), ("left_wall_second_arm_x", "m"), ("right_wall_second_arm_x", "m"), ("half_stiffness", "N/m"),
    ("left_wall_hysteresis_factor", "1"), ("inverse_mass", "1/kg"), ("half_mass", "kg"),
)

OPERATIONS = (
    ("constants", 10), ("start", 0), ("scales", 9), ("coordinate_rates", 0), ("gaps", 6), ("gap_accelerations", 1),
    ("contact_left_wall", 14), ("contact_right_wall", 14), ("applied", 0), ("accelerations", 1), ("ledger", 0), ("energy", 17),
    ("poses", 0), ("outputs", 5), ("landmarks", 3),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = ()
SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (8,): radius, stiffness, left_wall_second_arm_x, right_wall_second_arm_x, half_stiffness, left_wall_hysteresis_factor,
            inverse_mass, half_mass
    """
    mass, radius, gap, stiffness, restitution = p[0], p[1], p[2], p[3], p[4]
    left_wall_second_arm_x = -gap - radius
    right_wall_second_arm_x = gap + radius
    half_stiffness = stiffness/2
    left_wall_hysteresis_factor = 3/2 - 3*restitution/2
    inverse_mass = 1/mass
    half_mass = mass/2
    return ca.vertcat(radius, stiffness, left_wall_second_arm_x, right_wall_second_arm_x, half_stiffness, left_wall_hysteresis_factor,
        inverse_mass, half_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    speed = p[6]
    return ca.vertcat(0), ca.vertcat(speed)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, stiffness, speed = p[0], p[3], p[6]
    energy_scale = speed*speed*mass/2
    mass_over_stiffness = mass/stiffness
    force_scale = energy_scale/(ca.sqrt(mass_over_stiffness)*speed)
    x2 = ca.sqrt(mass_over_stiffness)
    x3 = x2*speed
    return ca.vertcat(x3), ca.vertcat(speed), ca.vertcat(energy_scale, energy_scale), ca.vertcat(x3, speed, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [m/s]
    """
    track_speed = u[0]
    return ca.vertcat(track_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (2,): PAIRS [m]
        dG (2,): PAIRS [m/s]
    """
    radius, left_wall_second_arm_x, right_wall_second_arm_x = c[0], c[2], c[3]
    track_travel = q[0]
    track_speed = u[0]
    left_wall_apart_x = track_travel - left_wall_second_arm_x
    right_wall_apart_x = track_travel - right_wall_second_arm_x
    left_wall_gap = left_wall_apart_x - radius
    right_wall_gap = -right_wall_apart_x - radius
    return ca.vertcat(left_wall_gap, right_wall_gap), ca.vertcat(track_speed, -track_speed)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (2,): PAIRS [m/s^2]
    """
    track_acceleration = a[0]
    return ca.vertcat(track_acceleration, -track_acceleration)


def contact_left_wall(t, q, u, z, m, c):
    """Forces of left_wall: power x hunt_crossley. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): track [N]
        dz (2,): MEMORY [W]
        normal_force (1,): left_wall [N]
        sliding_velocity (0,): empty
        in_range (1,): left_wall [1]
    """
    radius, stiffness, left_wall_second_arm_x, left_wall_hysteresis_factor = c[0], c[1], c[2], c[5]
    track_travel = q[0]
    track_speed = u[0]
    left_wall_approach_speed = m[0]
    left_wall_apart_x = track_travel - left_wall_second_arm_x
    left_wall_gap = left_wall_apart_x - radius
    left_wall_elastic_force = ca.if_else(-left_wall_gap > 0, -left_wall_gap*stiffness, 0)
    left_wall_resistance = -left_wall_elastic_force*left_wall_hysteresis_factor*track_speed/left_wall_approach_speed
    left_wall_normal_force = left_wall_elastic_force + left_wall_resistance
    left_wall_normal_power = -left_wall_resistance*track_speed
    return (ca.vertcat(left_wall_normal_force), ca.vertcat(left_wall_normal_power, 0), ca.vertcat(left_wall_normal_force), ca.vertcat(),
        ca.vertcat(1))


def contact_right_wall(t, q, u, z, m, c):
    """Forces of right_wall: power x hunt_crossley; arguments and returns as of contact_left_wall."""
    radius, stiffness, right_wall_second_arm_x, left_wall_hysteresis_factor = c[0], c[1], c[3], c[5]
    track_travel = q[0]
    track_speed = u[0]
    right_wall_approach_speed = m[1]
    right_wall_apart_x = track_travel - right_wall_second_arm_x
    right_wall_gap = -right_wall_apart_x - radius
    right_wall_elastic_force = ca.if_else(-right_wall_gap > 0, -right_wall_gap*stiffness, 0)
    right_wall_resistance = left_wall_hysteresis_factor*right_wall_elastic_force*track_speed/right_wall_approach_speed
    right_wall_normal_force = right_wall_elastic_force + right_wall_resistance
    right_wall_normal_power = right_wall_resistance*track_speed
    return (ca.vertcat(-right_wall_normal_force), ca.vertcat(0, right_wall_normal_power), ca.vertcat(right_wall_normal_force), ca.vertcat(),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): track [N]
    """
    return ca.vertcat(0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): track.acceleration [m/s^2]
        reactions (0,): empty
    """
    inverse_mass = c[6]
    track_force = f[0]
    track_acc = inverse_mass*track_force
    return ca.vertcat(track_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    return ca.vertcat(0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (2,): PAIRS [J]
    """
    radius, left_wall_second_arm_x, right_wall_second_arm_x, half_stiffness, half_mass = c[0], c[2], c[3], c[4], c[7]
    track_travel = q[0]
    track_speed = u[0]
    left_wall_apart_x = track_travel - left_wall_second_arm_x
    right_wall_apart_x = track_travel - right_wall_second_arm_x
    left_wall_gap = left_wall_apart_x - radius
    right_wall_gap = -right_wall_apart_x - radius
    left_wall_stored_energy = ca.if_else(-left_wall_gap > 0, half_stiffness*left_wall_gap*left_wall_gap, 0)
    right_wall_stored_energy = ca.if_else(-right_wall_gap > 0, half_stiffness*right_wall_gap*right_wall_gap, 0)
    kinetic = half_mass*track_speed*track_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(left_wall_stored_energy, right_wall_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball.x [m], ball.y [m], ball.z [m]
        rotations (9,): ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy
            [1], ball.R_zz [1]
    """
    track_travel = q[0]
    return ca.vertcat(track_travel, 0, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): OUTPUTS
    """
    radius, left_wall_second_arm_x, right_wall_second_arm_x = c[0], c[2], c[3]
    track_travel = q[0]
    left_wall_apart_x = track_travel - left_wall_second_arm_x
    right_wall_apart_x = track_travel - right_wall_second_arm_x
    left_wall_gap = left_wall_apart_x - radius
    right_wall_gap = -right_wall_apart_x - radius
    return ca.vertcat(left_wall_gap, right_wall_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        track.parent, track.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        left_wall.sphere (4,): x [m], y [m], z [m], radius [m]
        left_wall.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        right_wall.sphere (4,): x [m], y [m], z [m], radius [m]
        right_wall.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball.centre (3,): x [m], y [m], z [m]
    """
    radius, gap = p[1], p[2]
    return (ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, radius), ca.vertcat(-gap - radius, 0, 0, 1, 0,
            0),
        ca.vertcat(0, 0, 0, radius), ca.vertcat(gap + radius, 0, 0, -1, 0, 0), ca.vertcat(0, 0, 0))
