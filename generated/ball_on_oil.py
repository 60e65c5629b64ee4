"""ball_on_oil: ball through an oil film onto a plane. Generated from derive/scenes/ball_on_oil.py.

Do not edit; regenerate with `hertzwerk derive ball_on_oil`.
Effects:
    wall: power x flores
    oil: sphere_film film, none while it opens, at wall
    energy_ledger: work put in, energy dissipated per effect
Units: 30 assignments and 89 outputs checked, all consistent
Operations: flight 40 (equations of motion and gaps); in contact also contact_wall 16
"""

import casadi as ca

NAME = "ball_on_oil"
SOURCE = "derive/scenes/ball_on_oil.py"
SUMMARY = "ball through an oil film onto a plane"
FORMAT = "hertzwerk module 1"
DIGEST = "b96a62bbef6e52dfdb3aff92a34812bd"

EFFECTS = (
    ("wall", "contact", "power x flores"), ("oil", "lubrication", "sphere_film film, none while it opens, at wall"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 0.0327, "body ball, mass"),
    ("radius", "mm", 10, "pair wall, radius"),
    ("stiffness", "N/m^1.5", 15000000000.0, "effect wall, stiffness of power"),
    ("restitution", "1", 0.9, "effect wall, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("viscosity", "Pa s", 0.2, "effect oil, dynamic viscosity of sphere_film"),
    ("boundary_layer", "um", 1, "effect oil, boundary layer"),
    ("film_height", "mm", 0.5, "gap at the start"),
    ("speed", "m/s", 0.3, "of the ball in the oil, towards the plane"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body ball, mass"),
    ("radius", "defined", 0, None, True, False, "pair wall, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect wall, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect wall, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect wall, approach floor"),
    ("viscosity", "defined", 0, None, True, False, "effect oil, dynamic viscosity of sphere_film"),
    ("boundary_layer", "defined", 0, None, True, False, "effect oil, boundary layer"),
    ("film_height", "defined", 0, None, True, False, "scales, length"),
    ("speed", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("path.travel", "m"), ("oil.seams", "1"), ("oil.ruptured", "1"))

SPEEDS = (("path.speed", "m/s"),)

MEMORY = (("wall.dissipated", "J"), ("oil.dissipated", "J"))

LATCHES = (("wall.approach_speed", "m/s", 0),)

PAIRS = (("wall", "sphere_on_plane"),)

EVENTS = (("oil.seam", (1,)), ("oil.rupture", (2,)))

RELEASES = ("force",)

DISSIPATED = (0,)

OUTPUTS = (("wall.gap", "m"), ("oil.force", "N"), ("oil.thickness", "m"))

BODIES = ("ball",)

LANDMARKS = (
    ("path", "prismatic", "parent", "ground", ("axis",)), ("path", "prismatic", "child", "ball", ("axis",)),
    ("wall", "sphere_on_plane", "sphere", "ball", ("radius",)), ("wall", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball", "body", "centre", "ball", ()),
)

CONSTANTS = (
    ("radius", "m"), ("stiffness", "N/m^1.5"), ("boundary_layer", "m"), ("speed", "m/s"), ("half_inverse_boundary_layer", "1/m"),
    ("twice_boundary_layer", "m"), ("inverse_boundary_layer", "1/m"), ("k4", "N s"), ("k5", "m/s"), ("two_fifths_of_stiffness", "N/m^1.5"),
    ("wall_hysteresis_factor", "1"), ("inverse_mass", "1/kg"), ("half_mass", "kg"),
)

OPERATIONS = (
    ("constants", 17), ("start", 2), ("scales", 4), ("coordinate_rates", 0), ("gaps", 1), ("gap_accelerations", 0), ("contact_wall", 16),
    ("applied", 38), ("accelerations", 1), ("margins", 17), ("jumps", 11), ("ledger", 40), ("energy", 12), ("poses", 0), ("outputs", 39),
    ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (13,): radius, stiffness, boundary_layer, speed, half_inverse_boundary_layer, twice_boundary_layer, inverse_boundary_layer, k4,
            k5, two_fifths_of_stiffness, wall_hysteresis_factor, inverse_mass, half_mass
    """
    mass, radius, stiffness, restitution, viscosity, boundary_layer, speed = p[0], p[1], p[2], p[3], p[5], p[6], p[8]
    half_inverse_boundary_layer = 1/(2*boundary_layer)
    twice_boundary_layer = 2*boundary_layer
    inverse_boundary_layer = 1/boundary_layer
    k4 = 6*3.141592653589793*radius*radius*viscosity
    k5 = 1e-06*speed
    two_fifths_of_stiffness = 2*stiffness/5
    wall_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_mass = 1/mass
    half_mass = mass/2
    return ca.vertcat(radius, stiffness, boundary_layer, speed, half_inverse_boundary_layer, twice_boundary_layer, inverse_boundary_layer,
        k4, k5, two_fifths_of_stiffness, wall_hysteresis_factor, inverse_mass, half_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (1,): SPEEDS
    """
    radius, film_height, speed = p[1], p[7], p[8]
    return ca.vertcat(film_height + radius, 0, 0), ca.vertcat(-speed)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (1,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, film_height, speed = p[0], p[7], p[8]
    energy_scale = speed*speed*mass/2
    force_scale = energy_scale/film_height
    return (ca.vertcat(film_height, 1, 1), ca.vertcat(speed), ca.vertcat(energy_scale, energy_scale),
        ca.vertcat(film_height, speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): path.travel [m/s], oil.seams [1/s], oil.ruptured [1/s]
    """
    path_speed = u[0]
    return ca.vertcat(path_speed, 0, 0)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    radius = c[0]
    path_travel = q[0]
    path_speed = u[0]
    wall_gap = path_travel - radius
    return ca.vertcat(wall_gap), ca.vertcat(path_speed)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    path_acceleration = a[0]
    return ca.vertcat(path_acceleration)


def contact_wall(t, q, u, z, m, c):
    """Forces of wall: power x flores. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): path [N]
        dz (2,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    radius, stiffness, wall_hysteresis_factor = c[0], c[1], c[10]
    path_travel = q[0]
    path_speed = u[0]
    wall_approach_speed = m[0]
    wall_gap = path_travel - radius
    wall_elastic_force = ca.if_else(-wall_gap > 0, -wall_gap*ca.sqrt(-wall_gap)*stiffness, 0)
    wall_resistance = -path_speed*wall_elastic_force*wall_hysteresis_factor/wall_approach_speed
    wall_normal_force = wall_elastic_force + wall_resistance
    wall_normal_power = -path_speed*wall_resistance
    return ca.vertcat(wall_normal_force), ca.vertcat(wall_normal_power, 0), ca.vertcat(wall_normal_force), ca.vertcat(), ca.vertcat(1)


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): path [N]
    """
    radius, boundary_layer, half_inverse_boundary_layer, twice_boundary_layer, inverse_boundary_layer = c[0], c[2], c[4], c[5], c[6]
    k4 = c[7]
    path_travel = q[0]
    path_speed = u[0]
    oil_ruptured = q[2]
    wall_gap = path_travel - radius
    x1 = 2*boundary_layer
    oil_nearness = ca.if_else(wall_gap < x1, 1 - half_inverse_boundary_layer*wall_gap, 0)
    oil_thinning = ca.if_else(-wall_gap < 0, oil_nearness, 1)
    oil_thickness = ca.if_else(wall_gap < x1, twice_boundary_layer*(1 - oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))), wall_gap)
    oil_sinking = ca.if_else(-wall_gap > 0, -inverse_boundary_layer*wall_gap, 0)
    oil_drag = k4/oil_thickness
    oil_share = ca.if_else(-wall_gap < boundary_layer, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_load = ca.if_else(oil_ruptured > 0, 0, -oil_drag*oil_share*path_speed)
    return ca.vertcat(oil_load)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): path.acceleration [m/s^2]
        reactions (0,): empty
    """
    inverse_mass = c[11]
    path_force = f[0]
    path_acc = inverse_mass*path_force
    return ca.vertcat(path_acc), ca.vertcat()


def margins(t, q, u, c):
    """Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        margin (2,): oil.seam [1], oil.rupture [1]
    """
    radius, speed, inverse_boundary_layer, k5 = c[0], c[3], c[6], c[8]
    path_travel = q[0]
    path_speed = u[0]
    oil_seams, oil_ruptured = q[1], q[2]
    wall_gap = path_travel - radius
    x1 = -inverse_boundary_layer*wall_gap
    oil_past_0 = 2 + x1
    oil_past_1 = x1 - 1
    oil_reversal = k5 + ca.if_else(oil_ruptured > 0, path_speed, -path_speed)
    return ca.vertcat(ca.if_else(oil_seams > 0, oil_past_0, -oil_past_0)*ca.if_else(oil_seams > 1, oil_past_1, -oil_past_1),
        oil_reversal/speed)


def jumps(t, q, u, c):
    """Values of the states that each event changes, event by event, by the values before it.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        then (2,): oil.seams [1], oil.ruptured [1]
    """
    radius, inverse_boundary_layer = c[0], c[6]
    path_travel, oil_ruptured = q[0], q[2]
    wall_gap = path_travel - radius
    x1 = -inverse_boundary_layer*wall_gap
    oil_past_0 = 2 + x1
    oil_past_1 = x1 - 1
    return ca.vertcat(ca.if_else(oil_past_0 >= 0, 1, 0) + ca.if_else(oil_past_1 >= 0, 1, 0), 1 - oil_ruptured)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    radius, boundary_layer, half_inverse_boundary_layer, twice_boundary_layer, inverse_boundary_layer = c[0], c[2], c[4], c[5], c[6]
    k4 = c[7]
    path_travel = q[0]
    path_speed = u[0]
    oil_ruptured = q[2]
    wall_gap = path_travel - radius
    x1 = 2*boundary_layer
    oil_nearness = ca.if_else(wall_gap < x1, 1 - half_inverse_boundary_layer*wall_gap, 0)
    oil_thinning = ca.if_else(-wall_gap < 0, oil_nearness, 1)
    oil_thickness = ca.if_else(wall_gap < x1, twice_boundary_layer*(1 - oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))), wall_gap)
    oil_sinking = ca.if_else(-wall_gap > 0, -inverse_boundary_layer*wall_gap, 0)
    oil_drag = k4/oil_thickness
    oil_share = ca.if_else(-wall_gap < boundary_layer, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_load = ca.if_else(oil_ruptured > 0, 0, -oil_drag*oil_share*path_speed)
    oil_power = -oil_load*path_speed
    return ca.vertcat(0, oil_power)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    radius, two_fifths_of_stiffness, half_mass = c[0], c[9], c[12]
    path_travel = q[0]
    path_speed = u[0]
    wall_gap = path_travel - radius
    wall_stored_energy = ca.if_else(-wall_gap > 0, two_fifths_of_stiffness*(-wall_gap)**2*ca.sqrt(-wall_gap), 0)
    kinetic = half_mass*path_speed*path_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(wall_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball.x [m], ball.y [m], ball.z [m]
        rotations (9,): ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy
            [1], ball.R_zz [1]
    """
    path_travel = q[0]
    return ca.vertcat(path_travel, 0, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (3,): OUTPUTS
    """
    radius, boundary_layer, half_inverse_boundary_layer, twice_boundary_layer, inverse_boundary_layer = c[0], c[2], c[4], c[5], c[6]
    k4 = c[7]
    path_travel = q[0]
    path_speed = u[0]
    oil_ruptured = q[2]
    wall_gap = path_travel - radius
    x1 = 2*boundary_layer
    oil_nearness = ca.if_else(wall_gap < x1, 1 - half_inverse_boundary_layer*wall_gap, 0)
    oil_thinning = ca.if_else(-wall_gap < 0, oil_nearness, 1)
    oil_thickness = ca.if_else(wall_gap < x1, twice_boundary_layer*(1 - oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))), wall_gap)
    oil_sinking = ca.if_else(-wall_gap > 0, -inverse_boundary_layer*wall_gap, 0)
    oil_drag = k4/oil_thickness
    oil_share = ca.if_else(-wall_gap < boundary_layer, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_load = ca.if_else(oil_ruptured > 0, 0, -oil_drag*oil_share*path_speed)
    return ca.vertcat(wall_gap, ca.fabs(oil_load), oil_thickness)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        path.parent, path.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        wall.sphere (4,): x [m], y [m], z [m], radius [m]
        wall.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball.centre (3,): x [m], y [m], z [m]
    """
    radius = p[1]
    return (ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0))
