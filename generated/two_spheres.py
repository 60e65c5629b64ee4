"""two_spheres: a sphere meets an equal one at rest. Generated from derive/scenes/two_spheres.py.

Do not edit; regenerate with `hertzwerk derive two_spheres`.
Effects:
    spheres: hertz_point x flores
    energy_ledger: work put in, energy dissipated per effect
Units: 36 assignments and 104 outputs checked, all consistent
Operations: flight 19 (equations of motion and gaps); in contact also contact_spheres 22
"""

import casadi as ca

NAME = "two_spheres"
SOURCE = "derive/scenes/two_spheres.py"
SUMMARY = "a sphere meets an equal one at rest"
FORMAT = "hertzwerk module 1"
DIGEST = "d50db52aa01c44fdbe09e07bf0077a6d"

EFFECTS = (("spheres", "contact", "hertz_point x flores"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"))

PARAMETERS = (
    ("mass", "kg", 0.092, "of each sphere"),
    ("radius", "m", 0.02, "of each sphere"),
    ("youngs_modulus", "GPa", 207, "effect spheres, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "1", 0.3, "effect spheres, Poisson's ratio of the first body of hertz_point"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.7, "effect spheres, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("speed", "m/s", 0.3, "of the striker at the start"),
    ("gap", "m", 0.01, "between the spheres at the start"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body striker, mass"),
    ("radius", "defined", 0, None, True, False, "pair spheres, first radius"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect spheres, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect spheres, Poisson's ratio of the first body of hertz_point"),
    ("density", "defined", 0, None, True, False, "effect spheres, density"),
    ("restitution", "defined", 0, 1, True, False, "effect spheres, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect spheres, approach floor"),
    ("speed", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("striker_path.travel", "m"), ("target_path.travel", "m"))

SPEEDS = (("striker_path.speed", "m/s"), ("target_path.speed", "m/s"))

MEMORY = (("spheres.dissipated", "J"),)

LATCHES = (("spheres.approach_speed", "m/s", 0),)

PAIRS = (("spheres", "sphere_on_sphere"),)

RELEASES = ("force",)

DISSIPATED = (0,)

OUTPUTS = (("spheres.gap", "m"),)

SPEED_LIMITED = ("spheres",)

BODIES = ("striker", "target")

LANDMARKS = (
    ("striker_path", "prismatic", "parent", "ground", ("axis",)), ("striker_path", "prismatic", "child", "striker", ("axis",)),
    ("target_path", "prismatic", "parent", "ground", ("axis",)), ("target_path", "prismatic", "child", "target", ("axis",)),
    ("spheres", "sphere_on_sphere", "first", "striker", ("radius",)), ("spheres", "sphere_on_sphere", "second", "target", ("radius",)),
    ("striker", "body", "centre", "striker", ()), ("target", "body", "centre", "target", ()),
)

CONSTANTS = (
    ("radius", "m"), ("spheres_reach", "m"), ("minus_spheres_reach_squared", "m^2"), ("half_inverse_spheres_reach", "1/m"),
    ("spheres_K", "N/m^1.5"), ("two_fifths_of_spheres_K", "N/m^1.5"), ("spheres_hysteresis_factor", "1"), ("inverse_mass", "1/kg"),
    ("half_mass", "kg"),
)

OPERATIONS = (
    ("constants", 22), ("start", 2), ("scales", 39), ("coordinate_rates", 0), ("gaps", 8), ("gap_accelerations", 9),
    ("contact_spheres", 22), ("applied", 0), ("accelerations", 2), ("ledger", 0), ("energy", 15), ("poses", 0), ("outputs", 5),
    ("speed_limits", 3), ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = ()
SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (9,): radius, spheres_reach, minus_spheres_reach_squared, half_inverse_spheres_reach, spheres_K, two_fifths_of_spheres_K,
            spheres_hysteresis_factor, inverse_mass, half_mass
    """
    mass, radius, youngs_modulus, poissons_ratio, restitution = p[0], p[1], p[2], p[3], p[5]
    spheres_reach = 2*radius
    minus_spheres_reach_squared = -spheres_reach*spheres_reach
    half_inverse_spheres_reach = 1/(2*spheres_reach)
    spheres_R_eff = radius/2
    spheres_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    spheres_K = 4*spheres_E_eff*ca.sqrt(spheres_R_eff)/3
    two_fifths_of_spheres_K = 2*spheres_K/5
    spheres_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_mass = 1/mass
    half_mass = mass/2
    return ca.vertcat(radius, spheres_reach, minus_spheres_reach_squared, half_inverse_spheres_reach, spheres_K, two_fifths_of_spheres_K,
        spheres_hysteresis_factor, inverse_mass, half_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    radius, speed, gap = p[1], p[7], p[8]
    return ca.vertcat(0, 2*radius + gap), ca.vertcat(speed, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, radius, youngs_modulus, poissons_ratio, speed = p[0], p[1], p[2], p[3], p[7]
    total_mass = 2*mass
    energy_scale = total_mass*speed*speed/2
    inverse_sqrt_radius = 1/ca.sqrt(radius)
    poissons_ratio_squared = poissons_ratio*poissons_ratio
    minus_twice_poissons_ratio_squared = -2*poissons_ratio_squared
    x4 = 2 + minus_twice_poissons_ratio_squared
    x5 = inverse_sqrt_radius*x4*mass/youngs_modulus
    x6 = ca.fabs(speed)
    force_scale = 2*energy_scale*2**(4/5)*15**(3/5)/(15*x5**(2/5)*x6**(4/5))
    x7 = 2**(1/5)
    x8 = 15**(2/5)
    x9 = x5**(2/5)
    x10 = x6**(4/5)
    x11 = x10*x7*x8*x9/4
    return ca.vertcat(x11, x11), ca.vertcat(speed, speed), ca.vertcat(energy_scale), ca.vertcat(x11, speed, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (2,): COORDINATES [m/s]
    """
    striker_path_speed, target_path_speed = u[0], u[1]
    return ca.vertcat(striker_path_speed, target_path_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    minus_spheres_reach_squared, half_inverse_spheres_reach = c[2], c[3]
    striker_path_travel, target_path_travel = q[0], q[1]
    striker_path_speed, target_path_speed = u[0], u[1]
    spheres_apart_x = striker_path_travel - target_path_travel
    spheres_apart_rate_x = striker_path_speed - target_path_speed
    spheres_apart_squared = spheres_apart_x*spheres_apart_x
    spheres_gap = half_inverse_spheres_reach*(minus_spheres_reach_squared + spheres_apart_squared)
    spheres_apart_squared_rate = 2*spheres_apart_rate_x*spheres_apart_x
    spheres_gap_rate = half_inverse_spheres_reach*spheres_apart_squared_rate
    return ca.vertcat(spheres_gap), ca.vertcat(spheres_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    half_inverse_spheres_reach = c[3]
    striker_path_travel, target_path_travel = q[0], q[1]
    striker_path_speed, target_path_speed = u[0], u[1]
    striker_path_acceleration, target_path_acceleration = a[0], a[1]
    spheres_apart_x = striker_path_travel - target_path_travel
    spheres_apart_rate_x = striker_path_speed - target_path_speed
    spheres_apart_acceleration_x = striker_path_acceleration - target_path_acceleration
    spheres_apart_squared_rate_rate = 2*spheres_apart_rate_x*spheres_apart_rate_x + 2*spheres_apart_acceleration_x*spheres_apart_x
    spheres_gap_rate_rate = half_inverse_spheres_reach*spheres_apart_squared_rate_rate
    return ca.vertcat(spheres_gap_rate_rate)


def contact_spheres(t, q, u, z, m, c):
    """Forces of spheres: hertz_point x flores. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): striker_path [N], target_path [N]
        dz (1,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    radius, spheres_reach, spheres_K, spheres_hysteresis_factor = c[0], c[1], c[4], c[6]
    striker_path_travel, target_path_travel = q[0], q[1]
    striker_path_speed, target_path_speed = u[0], u[1]
    spheres_approach_speed = m[0]
    spheres_apart_x = striker_path_travel - target_path_travel
    spheres_apart_rate_x = striker_path_speed - target_path_speed
    spheres_apart_squared = spheres_apart_x*spheres_apart_x
    spheres_distance = ca.sqrt(spheres_apart_squared)
    spheres_penetration = spheres_reach - spheres_distance
    spheres_elastic_force = ca.if_else(spheres_penetration > 0, spheres_K*spheres_penetration*ca.sqrt(spheres_penetration), 0)
    spheres_normal_x = spheres_apart_x/spheres_distance
    spheres_penetration_rate = -spheres_apart_rate_x*spheres_normal_x
    spheres_resistance = spheres_elastic_force*spheres_hysteresis_factor*spheres_penetration_rate/spheres_approach_speed
    spheres_normal_force = spheres_elastic_force + spheres_resistance
    spheres_normal_power = spheres_penetration_rate*spheres_resistance
    spheres_push_x = spheres_normal_force*spheres_normal_x
    spheres_in_range = ca.if_else(radius >= spheres_penetration, 1, 0)
    return (ca.vertcat(spheres_push_x, -spheres_push_x), ca.vertcat(spheres_normal_power), ca.vertcat(spheres_normal_force), ca.vertcat(),
        ca.vertcat(spheres_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): striker_path [N], target_path [N]
    """
    return ca.vertcat(0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): striker_path.acceleration [m/s^2], target_path.acceleration [m/s^2]
        reactions (0,): empty
    """
    inverse_mass = c[7]
    striker_path_force, target_path_force = f[0], f[1]
    striker_path_acc = inverse_mass*striker_path_force
    target_path_acc = inverse_mass*target_path_force
    return ca.vertcat(striker_path_acc, target_path_acc), ca.vertcat()


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
    spheres_reach, two_fifths_of_spheres_K, half_mass = c[1], c[5], c[8]
    striker_path_travel, target_path_travel = q[0], q[1]
    striker_path_speed, target_path_speed = u[0], u[1]
    spheres_apart_x = striker_path_travel - target_path_travel
    spheres_apart_squared = spheres_apart_x*spheres_apart_x
    spheres_distance = ca.sqrt(spheres_apart_squared)
    spheres_penetration = spheres_reach - spheres_distance
    spheres_stored_energy = ca.if_else(spheres_penetration > 0, two_fifths_of_spheres_K*spheres_penetration*spheres_penetration*ca.sqrt(spheres_penetration), 0)
    kinetic = half_mass*striker_path_speed*striker_path_speed + half_mass*target_path_speed*target_path_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(spheres_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): striker.x [m], striker.y [m], striker.z [m], target.x [m], target.y [m], target.z [m]
        rotations (18,): striker.R_xx [1], striker.R_xy [1], striker.R_xz [1], striker.R_yx [1], striker.R_yy [1], striker.R_yz [1],
            striker.R_zx [1], striker.R_zy [1], striker.R_zz [1], target.R_xx [1], target.R_xy [1], target.R_xz [1], target.R_yx [1],
            target.R_yy [1], target.R_yz [1], target.R_zx [1], target.R_zy [1], target.R_zz [1]
    """
    striker_path_travel, target_path_travel = q[0], q[1]
    return ca.vertcat(striker_path_travel, 0, 0, target_path_travel, 0, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (1,): OUTPUTS
    """
    spheres_reach = c[1]
    striker_path_travel, target_path_travel = q[0], q[1]
    spheres_apart_x = striker_path_travel - target_path_travel
    spheres_apart_squared = spheres_apart_x*spheres_apart_x
    spheres_distance = ca.sqrt(spheres_apart_squared)
    spheres_penetration = spheres_reach - spheres_distance
    return ca.vertcat(-spheres_penetration)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (1,): PAIRS [m/s]
    """
    youngs_modulus, density = p[2], p[4]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        striker_path.parent, striker_path.child, target_path.parent, target_path.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1],
            axis_z [1]
        spheres.first, spheres.second (4,): x [m], y [m], z [m], radius [m]
        striker.centre, target.centre (3,): x [m], y [m], z [m]
    """
    radius = p[1]
    return (ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0))
