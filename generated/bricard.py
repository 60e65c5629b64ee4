"""bricard: five rods, six hinges, one redundant constraint. Generated from derive/scenes/bricard.py.

Do not edit; regenerate with `hertzwerk derive bricard`.
Effects:
    gravity: uniform gravity
    energy_ledger: work put in, energy dissipated per effect
Units: 576 assignments and 243 outputs checked, all consistent
Operations: flight 1818 (equations of motion and gaps)
"""

import casadi as ca

NAME = "bricard"
SOURCE = "derive/scenes/bricard.py"
SUMMARY = "five rods, six hinges, one redundant constraint"
FORMAT = "hertzwerk module 1"
DIGEST = "9f6e96c70fdb413e1de4485ab41e2ee4"

EFFECTS = (("gravity", "gravity", "uniform gravity"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"))

PARAMETERS = (
    ("mass", "kg", 1.0, "of each rod"),
    ("length", "m", 1.0, "of each rod"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("speed_scale", "m/s", 1.0, "scales, speed"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body rod_a, mass"),
    ("length", "defined", 0, None, True, False, "scales, length"),
    ("speed_scale", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (
    ("hinge_a.angle", "rad"), ("hinge_b.angle", "rad"), ("hinge_c.angle", "rad"), ("hinge_d.angle", "rad"), ("hinge_e.angle", "rad"),
)

SPEEDS = (
    ("hinge_a.speed", "rad/s"), ("hinge_b.speed", "rad/s"), ("hinge_c.speed", "rad/s"), ("hinge_d.speed", "rad/s"),
    ("hinge_e.speed", "rad/s"),
)

CONSTRAINTS = (
    ("hinge_f.apart_x", "m"), ("hinge_f.apart_y", "m"), ("hinge_f.apart_z", "m"), ("hinge_f.turned_y", "1"), ("hinge_f.turned_z", "1"),
)

BODIES = ("rod_a", "rod_b", "rod_c", "rod_d", "rod_e")

LANDMARKS = (
    ("hinge_a", "revolute", "parent", "ground", ("axis",)), ("hinge_a", "revolute", "child", "rod_a", ("axis",)),
    ("hinge_b", "revolute", "parent", "rod_a", ("axis",)), ("hinge_b", "revolute", "child", "rod_b", ("axis",)),
    ("hinge_c", "revolute", "parent", "rod_b", ("axis",)), ("hinge_c", "revolute", "child", "rod_c", ("axis",)),
    ("hinge_d", "revolute", "parent", "rod_c", ("axis",)), ("hinge_d", "revolute", "child", "rod_d", ("axis",)),
    ("hinge_e", "revolute", "parent", "rod_d", ("axis",)), ("hinge_e", "revolute", "child", "rod_e", ("axis",)),
    ("hinge_f", "revolute", "parent", "ground", ("axis",)), ("hinge_f", "revolute", "child", "rod_e", ("axis",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("rod_a", "body", "centre", "rod_a", ()),
    ("rod_b", "body", "centre", "rod_b", ()), ("rod_c", "body", "centre", "rod_c", ()), ("rod_d", "body", "centre", "rod_d", ()),
    ("rod_e", "body", "centre", "rod_e", ()),
)

CONSTANTS = (
    ("length", "m"), ("gravity", "m/s^2"), ("rod_e_h_y", "kg m"), ("rod_d_h_x", "kg m"), ("rod_c_h_z", "kg m"), ("rod_b_h_y", "kg m"),
    ("rod_b_I_x_x", "kg m^2"), ("rod_c_I_x_x", "kg m^2"), ("rod_d_I_z_z", "kg m^2"), ("rod_e_I_x_x", "kg m^2"),
    ("twice_rod_b_I_x_x", "kg m^2"), ("twice_length", "m"), ("rod_d_I_z_z_plus_rod_e_I_x_x", "kg m^2"), ("rod_a_I_y_y", "kg m^2"),
    ("inverse_rod_e_I_x_x", "1/(kg m^2)"), ("half_rod_e_I_x_x", "kg m^2"), ("half_mass", "kg"), ("half_length", "m"),
    ("gravity_times_mass", "N"), ("hinge_f_apart_x_softness", "1"), ("hinge_f_apart_y_softness", "1"), ("hinge_f_apart_z_softness", "1"),
    ("hinge_f_turned_y_softness", "1"), ("hinge_f_turned_z_softness", "1"),
)

OPERATIONS = (
    ("constants", 35), ("start", 0), ("scales", 6), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 44),
    ("accelerations", 1774), ("constraints", 176), ("projection", 1049), ("ledger", 0), ("energy", 188), ("poses", 94), ("outputs", 0),
    ("landmarks", 5),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = GIVEN = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (24,): length, gravity, rod_e_h_y, rod_d_h_x, rod_c_h_z, rod_b_h_y, rod_b_I_x_x, rod_c_I_x_x, rod_d_I_z_z, rod_e_I_x_x,
            twice_rod_b_I_x_x, twice_length, rod_d_I_z_z_plus_rod_e_I_x_x, rod_a_I_y_y, inverse_rod_e_I_x_x, half_rod_e_I_x_x, half_mass,
            half_length, gravity_times_mass, hinge_f_apart_x_softness, hinge_f_apart_y_softness, hinge_f_apart_z_softness,
            hinge_f_turned_y_softness, hinge_f_turned_z_softness
    """
    mass, length, gravity = p[0], p[1], p[2]
    rod_e_h_y = length*mass/2
    rod_d_h_x = -3*length*mass/2
    rod_d_total_mass = 2*mass
    rod_c_h_z = rod_e_h_y + rod_d_total_mass*length
    rod_c_total_mass = rod_d_total_mass + mass
    rod_b_h_y = -rod_c_total_mass*length - length*mass/2
    rod_b_total_mass = rod_c_total_mass + mass
    length_squared = length*length
    rod_e_I_x_x = length_squared*mass/3
    rod_b_I_x_x = rod_e_I_x_x + rod_c_total_mass*length_squared
    rod_c_I_x_x = rod_e_I_x_x + rod_d_total_mass*length_squared
    rod_d_I_z_z = 4*length_squared*mass/3
    twice_rod_b_I_x_x = 2*rod_b_I_x_x
    twice_length = 2*length
    rod_d_I_z_z_plus_rod_e_I_x_x = rod_d_I_z_z + rod_e_I_x_x
    rod_a_I_y_y = rod_e_I_x_x + rod_b_total_mass*length_squared
    inverse_rod_e_I_x_x = 1/rod_e_I_x_x
    half_rod_e_I_x_x = rod_e_I_x_x/2
    half_mass = mass/2
    half_length = length/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(length, gravity, rod_e_h_y, rod_d_h_x, rod_c_h_z, rod_b_h_y, rod_b_I_x_x, rod_c_I_x_x, rod_d_I_z_z, rod_e_I_x_x,
        twice_rod_b_I_x_x, twice_length, rod_d_I_z_z_plus_rod_e_I_x_x, rod_a_I_y_y, inverse_rod_e_I_x_x, half_rod_e_I_x_x, half_mass,
        half_length, gravity_times_mass, *[3e-09]*5)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (5,): COORDINATES
        u (5,): SPEEDS
    """
    return ca.vertcat(*[0]*5), ca.vertcat(*[0]*5)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (5,): COORDINATES
        su (5,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, length, speed_scale = p[0], p[1], p[3]
    total_mass = 5*mass
    energy_scale = total_mass*speed_scale*speed_scale/2
    force_scale = energy_scale/length
    speed_scale_over_length = speed_scale/length
    return (ca.vertcat(*[1]*5), ca.vertcat(*[speed_scale_over_length]*5), ca.vertcat(),
        ca.vertcat(length, speed_scale, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (5,): COORDINATES [rad/s]
    """
    hinge_a_speed, hinge_b_speed, hinge_c_speed, hinge_d_speed, hinge_e_speed = u[0], u[1], u[2], u[3], u[4]
    return ca.vertcat(hinge_a_speed, hinge_b_speed, hinge_c_speed, hinge_d_speed, hinge_e_speed)


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
        f (5,): hinge_a [N m], hinge_b [N m], hinge_c [N m], hinge_d [N m], hinge_e [N m]
    """
    gravity, rod_e_h_y, rod_d_h_x, rod_c_h_z, rod_b_h_y = c[1], c[2], c[3], c[4], c[5]
    hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[1], q[2], q[3], q[4]
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_d_total_moment_x = rod_d_h_x - rod_e_h_y*sin_rod_e
    rod_d_total_moment_y = cos_rod_e*rod_e_h_y
    rod_c_total_moment_x = cos_rod_d*rod_d_total_moment_x
    rod_c_total_moment_z = rod_c_h_z - rod_d_total_moment_x*sin_rod_d
    rod_b_total_moment_y = rod_b_h_y + cos_rod_c*rod_d_total_moment_y - rod_c_total_moment_z*sin_rod_c
    rod_b_gravity_x = -sin_rod_b*gravity
    rod_b_gravity_y = -cos_rod_b*gravity
    rod_c_gravity_y = cos_rod_c*rod_b_gravity_y
    rod_c_gravity_z = -rod_b_gravity_y*sin_rod_c
    rod_d_gravity_x = cos_rod_d*rod_b_gravity_x - rod_c_gravity_z*sin_rod_d
    rod_d_gravity_z = cos_rod_d*rod_c_gravity_z + rod_b_gravity_x*sin_rod_d
    rod_e_gravity_x = cos_rod_e*rod_d_gravity_x + rod_c_gravity_y*sin_rod_e
    return ca.vertcat(0, rod_b_gravity_y*rod_c_total_moment_x - rod_b_gravity_x*rod_b_total_moment_y, rod_c_gravity_z*rod_d_total_moment_y -
        rod_c_gravity_y*rod_c_total_moment_z, -rod_d_gravity_z*rod_d_total_moment_x, -rod_e_gravity_x*rod_e_h_y)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): hinge_a.acceleration [rad/s^2], hinge_b.acceleration [rad/s^2], hinge_c.acceleration [rad/s^2], hinge_d.acceleration
            [rad/s^2], hinge_e.acceleration [rad/s^2]
        reactions (0,): empty
        multipliers (5,): hinge_f.apart_x [N], hinge_f.apart_y [N], hinge_f.apart_z [N], hinge_f.turned_y [N m], hinge_f.turned_z [N m]
    """
    length, rod_e_h_y, rod_d_h_x, rod_c_h_z, rod_b_h_y, rod_b_I_x_x, rod_c_I_x_x = c[0], c[2], c[3], c[4], c[5], c[6], c[7]
    rod_d_I_z_z, rod_e_I_x_x, twice_rod_b_I_x_x, twice_length, rod_d_I_z_z_plus_rod_e_I_x_x = c[8], c[9], c[10], c[11], c[12]
    rod_a_I_y_y, inverse_rod_e_I_x_x, hinge_f_apart_x_softness, hinge_f_apart_y_softness = c[13], c[14], c[19], c[20]
    hinge_f_apart_z_softness, hinge_f_turned_y_softness, hinge_f_turned_z_softness = c[21], c[22], c[23]
    hinge_a_angle, hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[0], q[1], q[2], q[3], q[4]
    hinge_a_speed, hinge_b_speed, hinge_c_speed, hinge_d_speed, hinge_e_speed = u[0], u[1], u[2], u[3], u[4]
    hinge_a_force, hinge_b_force, hinge_c_force, hinge_d_force, hinge_e_force = f[0], f[1], f[2], f[3], f[4]
    cos_rod_a = ca.cos(hinge_a_angle)
    sin_rod_a = ca.sin(hinge_a_angle)
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_b_arm_x = cos_rod_a*length
    rod_b_arm_z = -sin_rod_a*length
    rod_b_arm_rate_x = hinge_a_speed*rod_b_arm_z
    rod_b_arm_rate_z = -hinge_a_speed*rod_b_arm_x
    rod_b_turning_x = hinge_b_speed*sin_rod_a
    rod_b_turning_z = cos_rod_a*hinge_b_speed
    rod_b_R_x_x = cos_rod_a*cos_rod_b
    rod_b_R_x_y = -cos_rod_a*sin_rod_b
    rod_b_R_z_x = -cos_rod_b*sin_rod_a
    rod_b_R_z_y = sin_rod_a*sin_rod_b
    rod_c_arm_x = -rod_b_R_x_y*length
    rod_c_arm_y = -cos_rod_b*length
    rod_c_arm_z = -rod_b_R_z_y*length
    rod_c_arm_rate_x = hinge_a_speed*rod_c_arm_z - rod_b_turning_z*rod_c_arm_y
    rod_c_arm_rate_y = rod_b_turning_z*rod_c_arm_x - rod_b_turning_x*rod_c_arm_z
    rod_c_arm_rate_z = rod_b_turning_x*rod_c_arm_y - hinge_a_speed*rod_c_arm_x
    rod_c_turning_x = hinge_c_speed*rod_b_R_x_x
    rod_c_turning_y = hinge_c_speed*sin_rod_b
    rod_c_turning_z = hinge_c_speed*rod_b_R_z_x
    rod_c_rate_x = rod_b_turning_x + rod_c_turning_x
    rod_c_rate_y = hinge_a_speed + rod_c_turning_y
    rod_c_rate_z = rod_b_turning_z + rod_c_turning_z
    rod_c_x = rod_b_arm_x + rod_c_arm_x
    rod_c_z = rod_b_arm_z + rod_c_arm_z
    rod_c_R_x_y = cos_rod_c*rod_b_R_x_y + sin_rod_a*sin_rod_c
    rod_c_R_x_z = cos_rod_c*sin_rod_a - rod_b_R_x_y*sin_rod_c
    rod_c_R_y_y = cos_rod_b*cos_rod_c
    rod_c_R_y_z = -cos_rod_b*sin_rod_c
    rod_c_R_z_y = cos_rod_a*sin_rod_c + cos_rod_c*rod_b_R_z_y
    rod_c_R_z_z = cos_rod_a*cos_rod_c - rod_b_R_z_y*sin_rod_c
    rod_d_arm_x = rod_c_R_x_z*length
    rod_d_arm_y = rod_c_R_y_z*length
    rod_d_arm_z = rod_c_R_z_z*length
    rod_d_arm_rate_x = rod_c_rate_y*rod_d_arm_z - rod_c_rate_z*rod_d_arm_y
    rod_d_arm_rate_y = rod_c_rate_z*rod_d_arm_x - rod_c_rate_x*rod_d_arm_z
    rod_d_arm_rate_z = rod_c_rate_x*rod_d_arm_y - rod_c_rate_y*rod_d_arm_x
    rod_d_turning_x = hinge_d_speed*rod_c_R_x_y
    rod_d_turning_y = hinge_d_speed*rod_c_R_y_y
    rod_d_turning_z = hinge_d_speed*rod_c_R_z_y
    rod_d_rate_x = rod_c_rate_x + rod_d_turning_x
    rod_d_rate_y = rod_c_rate_y + rod_d_turning_y
    rod_d_rate_z = rod_c_rate_z + rod_d_turning_z
    rod_d_x = rod_c_x + rod_d_arm_x
    rod_d_y = rod_c_arm_y + rod_d_arm_y
    rod_d_z = rod_c_z + rod_d_arm_z
    rod_d_R_x_x = cos_rod_d*rod_b_R_x_x - rod_c_R_x_z*sin_rod_d
    rod_d_R_x_z = cos_rod_d*rod_c_R_x_z + rod_b_R_x_x*sin_rod_d
    rod_d_R_y_x = cos_rod_d*sin_rod_b - rod_c_R_y_z*sin_rod_d
    rod_d_R_y_z = cos_rod_d*rod_c_R_y_z + sin_rod_b*sin_rod_d
    rod_d_R_z_x = cos_rod_d*rod_b_R_z_x - rod_c_R_z_z*sin_rod_d
    rod_d_R_z_z = cos_rod_d*rod_c_R_z_z + rod_b_R_z_x*sin_rod_d
    rod_e_arm_x = -rod_d_R_x_x*length
    rod_e_arm_y = -rod_d_R_y_x*length
    rod_e_arm_z = -rod_d_R_z_x*length
    rod_e_arm_rate_x = rod_d_rate_y*rod_e_arm_z - rod_d_rate_z*rod_e_arm_y
    rod_e_arm_rate_y = rod_d_rate_z*rod_e_arm_x - rod_d_rate_x*rod_e_arm_z
    rod_e_arm_rate_z = rod_d_rate_x*rod_e_arm_y - rod_d_rate_y*rod_e_arm_x
    rod_e_turning_x = hinge_e_speed*rod_d_R_x_z
    rod_e_turning_y = hinge_e_speed*rod_d_R_y_z
    rod_e_turning_z = hinge_e_speed*rod_d_R_z_z
    rod_e_rate_x = rod_d_rate_x + rod_e_turning_x
    rod_e_rate_y = rod_d_rate_y + rod_e_turning_y
    rod_e_rate_z = rod_d_rate_z + rod_e_turning_z
    rod_e_x = rod_d_x + rod_e_arm_x
    rod_e_y = rod_d_y + rod_e_arm_y
    rod_e_z = rod_d_z + rod_e_arm_z
    rod_e_R_x_x = cos_rod_e*rod_d_R_x_x + rod_c_R_x_y*sin_rod_e
    rod_e_R_x_y = cos_rod_e*rod_c_R_x_y - rod_d_R_x_x*sin_rod_e
    rod_e_R_y_x = cos_rod_e*rod_d_R_y_x + rod_c_R_y_y*sin_rod_e
    rod_e_R_y_y = cos_rod_e*rod_c_R_y_y - rod_d_R_y_x*sin_rod_e
    rod_e_R_z_x = cos_rod_e*rod_d_R_z_x + rod_c_R_z_y*sin_rod_e
    rod_e_R_z_y = cos_rod_e*rod_c_R_z_y - rod_d_R_z_x*sin_rod_e
    rod_b_angular_bias_x = hinge_a_speed*rod_b_turning_z
    rod_b_angular_bias_z = -hinge_a_speed*rod_b_turning_x
    rod_b_bias_x = hinge_a_speed*rod_b_arm_rate_z
    rod_b_bias_z = -hinge_a_speed*rod_b_arm_rate_x
    rod_c_angular_bias_x = rod_b_angular_bias_x + hinge_a_speed*rod_c_turning_z - rod_b_turning_z*rod_c_turning_y
    rod_c_angular_bias_y = rod_b_turning_z*rod_c_turning_x - rod_b_turning_x*rod_c_turning_z
    rod_c_angular_bias_z = rod_b_angular_bias_z + rod_b_turning_x*rod_c_turning_y - hinge_a_speed*rod_c_turning_x
    rod_c_bias_x = rod_b_bias_x + hinge_a_speed*rod_c_arm_rate_z - rod_b_angular_bias_z*rod_c_arm_y - rod_b_turning_z*rod_c_arm_rate_y
    rod_c_bias_y = rod_b_angular_bias_z*rod_c_arm_x + rod_b_turning_z*rod_c_arm_rate_x - rod_b_angular_bias_x*rod_c_arm_z - rod_b_turning_x*rod_c_arm_rate_z
    rod_c_bias_z = rod_b_bias_z + rod_b_angular_bias_x*rod_c_arm_y + rod_b_turning_x*rod_c_arm_rate_y - hinge_a_speed*rod_c_arm_rate_x
    rod_d_angular_bias_x = rod_c_angular_bias_x + rod_c_rate_y*rod_d_turning_z - rod_c_rate_z*rod_d_turning_y
    rod_d_angular_bias_y = rod_c_angular_bias_y + rod_c_rate_z*rod_d_turning_x - rod_c_rate_x*rod_d_turning_z
    rod_d_angular_bias_z = rod_c_angular_bias_z + rod_c_rate_x*rod_d_turning_y - rod_c_rate_y*rod_d_turning_x
    rod_d_bias_x = rod_c_bias_x + rod_c_angular_bias_y*rod_d_arm_z + rod_c_rate_y*rod_d_arm_rate_z - rod_c_angular_bias_z*rod_d_arm_y - rod_c_rate_z*rod_d_arm_rate_y
    rod_d_bias_y = rod_c_bias_y + rod_c_angular_bias_z*rod_d_arm_x + rod_c_rate_z*rod_d_arm_rate_x - rod_c_angular_bias_x*rod_d_arm_z - rod_c_rate_x*rod_d_arm_rate_z
    rod_d_bias_z = rod_c_bias_z + rod_c_angular_bias_x*rod_d_arm_y + rod_c_rate_x*rod_d_arm_rate_y - rod_c_angular_bias_y*rod_d_arm_x - rod_c_rate_y*rod_d_arm_rate_x
    rod_e_angular_bias_x = rod_d_angular_bias_x + rod_d_rate_y*rod_e_turning_z - rod_d_rate_z*rod_e_turning_y
    rod_e_angular_bias_y = rod_d_angular_bias_y + rod_d_rate_z*rod_e_turning_x - rod_d_rate_x*rod_e_turning_z
    rod_e_angular_bias_z = rod_d_angular_bias_z + rod_d_rate_x*rod_e_turning_y - rod_d_rate_y*rod_e_turning_x
    rod_e_bias_x = rod_d_bias_x + rod_d_angular_bias_y*rod_e_arm_z + rod_d_rate_y*rod_e_arm_rate_z - rod_d_angular_bias_z*rod_e_arm_y - rod_d_rate_z*rod_e_arm_rate_y
    rod_e_bias_y = rod_d_bias_y + rod_d_angular_bias_z*rod_e_arm_x + rod_d_rate_z*rod_e_arm_rate_x - rod_d_angular_bias_x*rod_e_arm_z - rod_d_rate_x*rod_e_arm_rate_z
    rod_e_bias_z = rod_d_bias_z + rod_d_angular_bias_x*rod_e_arm_y + rod_d_rate_x*rod_e_arm_rate_y - rod_d_angular_bias_y*rod_e_arm_x - rod_d_rate_y*rod_e_arm_rate_x
    hinge_f_child_arm_x = rod_e_R_x_y*length
    hinge_f_child_arm_y = rod_e_R_y_y*length
    hinge_f_child_arm_z = rod_e_R_z_y*length
    hinge_f_child_arm_rate_x = hinge_f_child_arm_z*rod_e_rate_y - hinge_f_child_arm_y*rod_e_rate_z
    hinge_f_child_arm_rate_y = hinge_f_child_arm_x*rod_e_rate_z - hinge_f_child_arm_z*rod_e_rate_x
    hinge_f_child_arm_rate_z = hinge_f_child_arm_y*rod_e_rate_x - hinge_f_child_arm_x*rod_e_rate_y
    hinge_f_apart_x = hinge_f_child_arm_x + rod_e_x
    hinge_f_apart_bias_x = rod_e_bias_x + hinge_f_child_arm_rate_z*rod_e_rate_y + hinge_f_child_arm_z*rod_e_angular_bias_y - hinge_f_child_arm_rate_y*rod_e_rate_z - hinge_f_child_arm_y*rod_e_angular_bias_z
    hinge_f_apart_bias_y = rod_e_bias_y + hinge_f_child_arm_rate_x*rod_e_rate_z + hinge_f_child_arm_x*rod_e_angular_bias_z - hinge_f_child_arm_rate_z*rod_e_rate_x - hinge_f_child_arm_z*rod_e_angular_bias_x
    hinge_f_apart_bias_z = rod_e_bias_z + hinge_f_child_arm_rate_y*rod_e_rate_x + hinge_f_child_arm_y*rod_e_angular_bias_x - hinge_f_child_arm_rate_x*rod_e_rate_y - hinge_f_child_arm_x*rod_e_angular_bias_y
    hinge_f_x_on_hinge_a = hinge_f_child_arm_z + rod_e_z
    hinge_f_child_arm_y_plus_rod_e_y = hinge_f_child_arm_y + rod_e_y
    hinge_f_x_on_hinge_b = -cos_rod_a*hinge_f_child_arm_y_plus_rod_e_y
    hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z = hinge_f_child_arm_z + rod_e_z - rod_c_z
    x3 = hinge_f_child_arm_y + rod_e_y - rod_c_arm_y
    hinge_f_x_on_hinge_c = sin_rod_b*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z - rod_b_R_z_x*x3
    hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z = hinge_f_child_arm_z + rod_e_z - rod_d_z
    hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y = hinge_f_child_arm_y + rod_e_y - rod_d_y
    hinge_f_x_on_hinge_d = rod_c_R_y_y*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z - rod_c_R_z_y*hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y
    hinge_f_x_on_hinge_e = hinge_f_child_arm_z*rod_d_R_y_z - hinge_f_child_arm_y*rod_d_R_z_z
    hinge_f_y_on_hinge_b = cos_rod_a*(hinge_f_child_arm_x + rod_e_x - rod_b_arm_x) - sin_rod_a*(hinge_f_child_arm_z + rod_e_z - rod_b_arm_z)
    hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x = hinge_f_child_arm_x + rod_e_x - rod_c_x
    hinge_f_y_on_hinge_c = rod_b_R_z_x*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x - rod_b_R_x_x*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z
    hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x = hinge_f_child_arm_x + rod_e_x - rod_d_x
    hinge_f_y_on_hinge_d = rod_c_R_z_y*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x - rod_c_R_x_y*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z
    hinge_f_y_on_hinge_e = hinge_f_child_arm_x*rod_d_R_z_z - hinge_f_child_arm_z*rod_d_R_x_z
    hinge_f_z_on_hinge_b = sin_rod_a*hinge_f_child_arm_y_plus_rod_e_y
    hinge_f_z_on_hinge_c = rod_b_R_x_x*x3 - sin_rod_b*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x
    hinge_f_z_on_hinge_d = rod_c_R_x_y*hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y - rod_c_R_y_y*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x
    hinge_f_z_on_hinge_e = hinge_f_child_arm_y*rod_d_R_x_z - hinge_f_child_arm_x*rod_d_R_y_z
    hinge_f_turned_y_bias = rod_e_R_x_x*rod_e_angular_bias_z + rod_e_rate_x*(rod_e_R_x_x*rod_e_rate_y - rod_e_R_y_x*rod_e_rate_x) + rod_e_rate_z*(rod_e_R_z_x*rod_e_rate_y - rod_e_R_y_x*rod_e_rate_z) - rod_e_R_z_x*rod_e_angular_bias_x
    hinge_f_turned_y_on_hinge_b = cos_rod_a*rod_e_R_x_x - rod_e_R_z_x*sin_rod_a
    hinge_f_turned_y_on_hinge_c = rod_b_R_z_x*rod_e_R_x_x - rod_b_R_x_x*rod_e_R_z_x
    hinge_f_turned_y_on_hinge_d = rod_c_R_z_y*rod_e_R_x_x - rod_c_R_x_y*rod_e_R_z_x
    hinge_f_turned_y_on_hinge_e = rod_d_R_z_z*rod_e_R_x_x - rod_d_R_x_z*rod_e_R_z_x
    hinge_f_turned_z_bias = rod_e_R_y_x*rod_e_angular_bias_x + rod_e_rate_x*(rod_e_R_x_x*rod_e_rate_z - rod_e_R_z_x*rod_e_rate_x) + rod_e_rate_y*(rod_e_R_y_x*rod_e_rate_z - rod_e_R_z_x*rod_e_rate_y) - rod_e_R_x_x*rod_e_angular_bias_y
    hinge_f_turned_z_on_hinge_b = rod_e_R_y_x*sin_rod_a
    hinge_f_turned_z_on_hinge_c = rod_b_R_x_x*rod_e_R_y_x - rod_e_R_x_x*sin_rod_b
    hinge_f_turned_z_on_hinge_d = rod_c_R_x_y*rod_e_R_y_x - rod_c_R_y_y*rod_e_R_x_x
    hinge_f_turned_z_on_hinge_e = rod_d_R_x_z*rod_e_R_y_x - rod_d_R_y_z*rod_e_R_x_x
    rod_e_turned_moment_x = -rod_e_h_y*sin_rod_e
    rod_d_total_moment_x = rod_d_h_x + rod_e_turned_moment_x
    rod_d_total_moment_y = cos_rod_e*rod_e_h_y
    rod_c_total_moment_x = cos_rod_d*rod_d_total_moment_x
    rod_d_turned_moment_z = -rod_d_total_moment_x*sin_rod_d
    rod_c_total_moment_z = rod_c_h_z + rod_d_turned_moment_z
    cos_rod_c_times_rod_d_total_moment_y = cos_rod_c*rod_d_total_moment_y
    minus_rod_c_total_moment_z_times_sin_rod_c = -rod_c_total_moment_z*sin_rod_c
    rod_b_total_moment_y = rod_b_h_y + cos_rod_c_times_rod_d_total_moment_y + minus_rod_c_total_moment_z_times_sin_rod_c
    rod_b_total_moment_z = cos_rod_c*rod_c_total_moment_z + rod_d_total_moment_y*sin_rod_c
    rod_a_rate_yy = hinge_a_speed*hinge_a_speed
    rod_b_w_x = hinge_a_speed*sin_rod_b
    rod_b_w_y = cos_rod_b*hinge_a_speed
    rod_b_angular_bias_x_2 = hinge_b_speed*rod_b_w_y
    rod_b_angular_bias_y = -hinge_b_speed*rod_b_w_x
    rod_c_w_y = cos_rod_c*rod_b_w_y + hinge_b_speed*sin_rod_c
    rod_c_w_z = cos_rod_c*hinge_b_speed - rod_b_w_y*sin_rod_c
    rod_c_b_y = cos_rod_c*rod_b_angular_bias_y
    rod_c_b_z = -rod_b_angular_bias_y*sin_rod_c
    rod_c_rate_x_2 = hinge_c_speed + rod_b_w_x
    rod_c_angular_bias_y_2 = rod_c_b_y + hinge_c_speed*rod_c_w_z
    rod_c_angular_bias_z_2 = rod_c_b_z - hinge_c_speed*rod_c_w_y
    rod_d_w_x = cos_rod_d*rod_c_rate_x_2 - rod_c_w_z*sin_rod_d
    rod_d_w_z = cos_rod_d*rod_c_w_z + rod_c_rate_x_2*sin_rod_d
    rod_d_b_x = cos_rod_d*rod_b_angular_bias_x_2 - rod_c_angular_bias_z_2*sin_rod_d
    rod_d_b_z = cos_rod_d*rod_c_angular_bias_z_2 + rod_b_angular_bias_x_2*sin_rod_d
    rod_d_rate_y_2 = hinge_d_speed + rod_c_w_y
    rod_d_angular_bias_x_2 = rod_d_b_x - hinge_d_speed*rod_d_w_z
    rod_d_angular_bias_z_2 = rod_d_b_z + hinge_d_speed*rod_d_w_x
    rod_e_w_x = cos_rod_e*rod_d_w_x + rod_d_rate_y_2*sin_rod_e
    rod_e_w_y = cos_rod_e*rod_d_rate_y_2 - rod_d_w_x*sin_rod_e
    rod_e_b_x = cos_rod_e*rod_d_angular_bias_x_2 + rod_c_angular_bias_y_2*sin_rod_e
    rod_e_rate_z_2 = hinge_e_speed + rod_d_w_z
    rod_e_angular_bias_x_2 = rod_e_b_x + hinge_e_speed*rod_e_w_y
    rod_e_rate_xy = rod_e_w_x*rod_e_w_y
    rod_e_U_x_y = rod_e_rate_xy - rod_d_angular_bias_z_2
    rod_e_rate_xx = rod_e_w_x*rod_e_w_x
    rod_e_rate_zz = rod_e_rate_z_2*rod_e_rate_z_2
    rod_e_U_y_y = -rod_e_rate_xx - rod_e_rate_zz
    rod_e_rate_zy = rod_e_rate_z_2*rod_e_w_y
    rod_e_U_z_y = rod_e_angular_bias_x_2 + rod_e_rate_zy
    rod_e_force_x = rod_e_U_x_y*rod_e_h_y
    rod_e_force_y = rod_e_U_y_y*rod_e_h_y
    rod_e_force_z = rod_e_U_z_y*rod_e_h_y
    rod_d_rate_yy = rod_d_rate_y_2*rod_d_rate_y_2
    rod_d_rate_zz = rod_d_w_z*rod_d_w_z
    rod_d_U_x_x = -rod_d_rate_yy - rod_d_rate_zz
    rod_d_rate_yx = rod_d_rate_y_2*rod_d_w_x
    rod_d_U_y_x = rod_d_angular_bias_z_2 + rod_d_rate_yx
    rod_d_rate_zx = rod_d_w_x*rod_d_w_z
    rod_d_U_z_x = rod_d_rate_zx - rod_c_angular_bias_y_2
    rod_d_force_x = cos_rod_e*rod_e_force_x + rod_d_U_x_x*rod_d_h_x - rod_e_force_y*sin_rod_e
    cos_rod_e_times_rod_e_force_y = cos_rod_e*rod_e_force_y
    rod_e_force_x_times_sin_rod_e = rod_e_force_x*sin_rod_e
    rod_d_force_y = cos_rod_e_times_rod_e_force_y + rod_e_force_x_times_sin_rod_e + rod_d_U_y_x*rod_d_h_x
    rod_d_force_z = rod_e_force_z + rod_d_U_z_x*rod_d_h_x
    rod_c_rate_xz = rod_c_rate_x_2*rod_c_w_z
    rod_c_U_x_z = rod_c_angular_bias_y_2 + rod_c_rate_xz
    rod_c_rate_yz = rod_c_w_y*rod_c_w_z
    rod_c_U_y_z = rod_c_rate_yz - rod_b_angular_bias_x_2
    rod_c_rate_xx = rod_c_rate_x_2*rod_c_rate_x_2
    rod_c_rate_yy = rod_c_w_y*rod_c_w_y
    rod_c_U_z_z = -rod_c_rate_xx - rod_c_rate_yy
    cos_rod_d_times_rod_d_force_x = cos_rod_d*rod_d_force_x
    rod_d_force_z_times_sin_rod_d = rod_d_force_z*sin_rod_d
    rod_c_force_x = cos_rod_d_times_rod_d_force_x + rod_d_force_z_times_sin_rod_d + rod_c_U_x_z*rod_c_h_z
    rod_c_force_y = rod_d_force_y + rod_c_U_y_z*rod_c_h_z
    rod_c_force_z = cos_rod_d*rod_d_force_z + rod_c_U_z_z*rod_c_h_z - rod_d_force_x*sin_rod_d
    rod_b_rate_xy = rod_b_w_x*rod_b_w_y
    rod_b_rate_xx = rod_b_w_x*rod_b_w_x
    rod_b_rate_zz = hinge_b_speed*hinge_b_speed
    rod_b_U_y_y = -rod_b_rate_xx - rod_b_rate_zz
    rod_b_U_z_y = 2*rod_b_angular_bias_x_2
    rod_b_force_x = rod_c_force_x + rod_b_h_y*rod_b_rate_xy
    rod_b_force_y = cos_rod_c*rod_c_force_y + rod_b_U_y_y*rod_b_h_y - rod_c_force_z*sin_rod_c
    cos_rod_c_times_rod_c_force_z = cos_rod_c*rod_c_force_z
    rod_c_force_y_times_sin_rod_c = rod_c_force_y*sin_rod_c
    rod_b_force_z = cos_rod_c_times_rod_c_force_z + rod_c_force_y_times_sin_rod_c + rod_b_U_z_y*rod_b_h_y
    cos_rod_b_times_rod_b_force_x = cos_rod_b*rod_b_force_x
    minus_rod_b_force_y_times_sin_rod_b = -rod_b_force_y*sin_rod_b
    x20 = cos_rod_b_times_rod_b_force_x + minus_rod_b_force_y_times_sin_rod_b
    rod_b_turned_force_x = cos_rod_a*x20 + rod_b_force_z*sin_rod_a
    rod_b_turned_force_z = cos_rod_a*rod_b_force_z - sin_rod_a*x20
    rod_a_rate_yy_times_rod_b_arm_z_times_sin_rod_a = rod_a_rate_yy*rod_b_arm_z*sin_rod_a
    x22 = -cos_rod_a*rod_a_rate_yy*rod_b_arm_x
    x23 = rod_a_rate_yy_times_rod_b_arm_z_times_sin_rod_a + x22
    rod_b_bias_x_2 = cos_rod_b*x23
    rod_b_bias_y = -sin_rod_b*x23
    rod_b_bias_z_2 = -cos_rod_a*rod_a_rate_yy*rod_b_arm_z - rod_a_rate_yy*rod_b_arm_x*sin_rod_a
    rod_c_turned_force_z = cos_rod_c_times_rod_c_force_z + rod_c_force_y_times_sin_rod_c
    rod_c_bias_x_2 = rod_b_bias_x_2 - rod_b_rate_xy*length
    minus_rod_b_U_y_y_times_length = -rod_b_U_y_y*length
    x25 = rod_b_bias_y + minus_rod_b_U_y_y_times_length
    minus_rod_b_U_z_y_times_length = -rod_b_U_z_y*length
    x27 = rod_b_bias_z_2 + minus_rod_b_U_z_y_times_length
    rod_c_bias_y_2 = cos_rod_c*x25 + sin_rod_c*x27
    rod_c_bias_z_2 = cos_rod_c*x27 - sin_rod_c*x25
    rod_d_turned_force_x = cos_rod_d_times_rod_d_force_x + rod_d_force_z_times_sin_rod_d
    rod_c_U_x_z_times_length = rod_c_U_x_z*length
    x29 = rod_c_bias_x_2 + rod_c_U_x_z_times_length
    rod_c_U_z_z_times_length = rod_c_U_z_z*length
    x31 = rod_c_bias_z_2 + rod_c_U_z_z_times_length
    rod_d_bias_x_2 = cos_rod_d*x29 - sin_rod_d*x31
    rod_d_bias_y_2 = rod_c_bias_y_2 + rod_c_U_y_z*length
    rod_d_bias_z_2 = cos_rod_d*x31 + sin_rod_d*x29
    rod_e_turned_force_y = cos_rod_e_times_rod_e_force_y + rod_e_force_x_times_sin_rod_e
    rod_e_bias_x_2 = cos_rod_e*(rod_d_bias_x_2 - rod_d_U_x_x*length) + sin_rod_e*(rod_d_bias_y_2 - rod_d_U_y_x*length)
    rod_e_bias_z_2 = rod_d_bias_z_2 - rod_d_U_z_x*length
    rod_e_torque_x = rod_e_I_x_x*rod_e_angular_bias_x_2 + rod_e_I_x_x*rod_e_rate_zy + rod_e_bias_z_2*rod_e_h_y
    rod_e_torque_z = rod_d_angular_bias_z_2*rod_e_I_x_x - rod_e_I_x_x*rod_e_rate_xy - rod_e_bias_x_2*rod_e_h_y
    rod_d_torque_x = cos_rod_e*rod_e_torque_x
    rod_d_torque_y = rod_c_angular_bias_y_2*rod_d_I_z_z + rod_e_force_z*length + rod_e_torque_x*sin_rod_e - rod_d_I_z_z*rod_d_rate_zx - rod_d_bias_z_2*rod_d_h_x
    rod_d_torque_z = rod_e_torque_z + rod_d_I_z_z*rod_d_angular_bias_z_2 + rod_d_I_z_z*rod_d_rate_yx + rod_d_bias_y_2*rod_d_h_x - rod_e_turned_force_y*length
    rod_c_torque_x = cos_rod_d*rod_d_torque_x + rod_b_angular_bias_x_2*rod_c_I_x_x + rod_d_torque_z*sin_rod_d - rod_c_I_x_x*rod_c_rate_yz - rod_c_bias_y_2*rod_c_h_z - rod_d_force_y*length
    rod_c_torque_y = rod_d_torque_y + rod_c_I_x_x*rod_c_angular_bias_y_2 + rod_c_I_x_x*rod_c_rate_xz + rod_c_bias_x_2*rod_c_h_z + rod_d_turned_force_x*length
    rod_c_torque_z = cos_rod_d*rod_d_torque_z - rod_d_torque_x*sin_rod_d
    rod_b_torque_x = rod_c_torque_x + twice_rod_b_I_x_x*rod_b_angular_bias_x_2 + rod_b_bias_z_2*rod_b_h_y - rod_c_turned_force_z*length
    rod_b_torque_y = cos_rod_c*rod_c_torque_y - rod_c_torque_z*sin_rod_c
    rod_b_torque_z = cos_rod_c*rod_c_torque_z + rod_c_force_x*length + rod_c_torque_y*sin_rod_c - rod_b_I_x_x*rod_b_rate_xy - rod_b_bias_x_2*rod_b_h_y
    rod_a_torque_y = cos_rod_b*rod_b_torque_y + rod_b_arm_z*rod_b_turned_force_x + rod_b_torque_x*sin_rod_b - rod_b_arm_x*rod_b_turned_force_z
    hinge_a_net = hinge_a_force - rod_a_torque_y
    hinge_b_net = hinge_b_force - rod_b_torque_z
    hinge_c_net = hinge_c_force - rod_c_torque_x
    hinge_d_net = hinge_d_force - rod_d_torque_y
    hinge_e_net = hinge_e_force - rod_e_torque_z
    rod_c_turned_moment_y = cos_rod_c_times_rod_d_total_moment_y + minus_rod_c_total_moment_z_times_sin_rod_c
    cos_rod_b_times_rod_c_total_moment_x = cos_rod_b*rod_c_total_moment_x
    minus_rod_b_total_moment_y_times_sin_rod_b = -rod_b_total_moment_y*sin_rod_b
    x34 = cos_rod_b_times_rod_c_total_moment_x + minus_rod_b_total_moment_y_times_sin_rod_b
    rod_b_turned_moment_x = cos_rod_a*x34 + rod_b_total_moment_z*sin_rod_a
    rod_b_turned_moment_z = cos_rod_a*rod_b_total_moment_z - sin_rod_a*x34
    rod_e_turned_J_swing = -rod_e_I_x_x*sin_rod_e
    rod_e_turned_J_x_y = -cos_rod_e*rod_e_turned_J_swing
    rod_d_total_J_x_y = rod_e_turned_J_x_y + rod_d_total_moment_y*length
    rod_d_turned_J_x_y = cos_rod_d*rod_d_total_J_x_y
    rod_e_turned_J_x_x = rod_e_I_x_x + rod_e_turned_J_swing*sin_rod_e
    x35 = -twice_length*rod_e_turned_moment_x
    rod_d_total_J_z_z = rod_d_I_z_z_plus_rod_e_I_x_x + x35
    rod_d_turned_J_swing = sin_rod_d*(rod_e_turned_J_x_x - rod_d_total_J_z_z)
    rod_d_turned_J_x_z = -cos_rod_d*rod_d_turned_J_swing
    rod_c_total_J_x_z = rod_d_turned_J_x_z - rod_c_total_moment_x*length
    rod_c_turned_J_x_y = cos_rod_c*rod_d_turned_J_x_y - rod_c_total_J_x_z*sin_rod_c
    rod_b_total_J_x_y = rod_c_turned_J_x_y + rod_c_total_moment_x*length
    rod_e_turned_J_y_y = -rod_e_turned_J_swing*sin_rod_e
    rod_d_total_J_y_y = rod_d_I_z_z + rod_e_turned_J_y_y + x35
    x36 = twice_length*rod_d_turned_moment_z
    rod_c_total_J_y_y = rod_c_I_x_x + rod_d_total_J_y_y + x36
    rod_d_turned_J_y_z = -rod_d_total_J_x_y*sin_rod_d
    rod_c_total_J_y_z = rod_d_turned_J_y_z - rod_d_total_moment_y*length
    rod_d_turned_J_z_z = rod_d_total_J_z_z + rod_d_turned_J_swing*sin_rod_d
    rod_c_turned_J_swing = sin_rod_c*(rod_d_turned_J_z_z - rod_c_total_J_y_y) - 2*cos_rod_c*rod_c_total_J_y_z
    rod_c_turned_J_y_y = rod_c_total_J_y_y + rod_c_turned_J_swing*sin_rod_c
    rod_d_turned_J_x_x = rod_e_turned_J_x_x - rod_d_turned_J_swing*sin_rod_d
    rod_c_total_J_x_x = rod_c_I_x_x + rod_d_turned_J_x_x + x36
    x37 = -twice_length*rod_c_turned_moment_y
    rod_b_total_J_x_x = rod_b_I_x_x + rod_c_total_J_x_x + x37
    rod_b_turned_J_swing = sin_rod_b*(rod_c_turned_J_y_y - rod_b_total_J_x_x) - 2*cos_rod_b*rod_b_total_J_x_y
    rod_c_turned_J_x_z = cos_rod_c*rod_c_total_J_x_z + rod_d_turned_J_x_y*sin_rod_c
    rod_c_turned_J_y_z = -rod_c_total_J_y_z - cos_rod_c*rod_c_turned_J_swing
    rod_b_total_J_y_z = rod_c_turned_J_y_z + rod_b_total_moment_z*length
    rod_b_turned_J_y_y = rod_c_turned_J_y_y - rod_b_turned_J_swing*sin_rod_b
    rod_a_total_J_y_y = rod_a_I_y_y + rod_b_turned_J_y_y + 2*rod_b_arm_x*rod_b_turned_moment_x + 2*rod_b_arm_z*rod_b_turned_moment_z
    rod_c_turned_J_z_z = rod_d_turned_J_z_z - rod_c_turned_J_swing*sin_rod_c
    rod_b_total_J_z_z = rod_b_I_x_x + rod_c_turned_J_z_z + x37
    minus_cos_rod_b_times_rod_b_total_moment_y = -cos_rod_b*rod_b_total_moment_y
    minus_rod_c_total_moment_x_times_sin_rod_b = -rod_c_total_moment_x*sin_rod_b
    x40 = minus_cos_rod_b_times_rod_b_total_moment_y + minus_rod_c_total_moment_x_times_sin_rod_b
    hinge_b_rod_b_force_x = cos_rod_a*x40
    hinge_b_rod_b_force_z = -sin_rod_a*x40
    hinge_b_rod_b_torque_y = cos_rod_b*rod_b_total_J_y_z + hinge_b_rod_b_force_x*rod_b_arm_z + rod_c_turned_J_x_z*sin_rod_b - hinge_b_rod_b_force_z*rod_b_arm_x
    hinge_c_rod_c_torque_x = rod_c_total_J_x_x - rod_c_turned_moment_y*length
    hinge_c_rod_b_force_x = rod_c_turned_moment_y*sin_rod_a + cos_rod_a*rod_b_total_moment_z*sin_rod_b
    hinge_c_rod_b_force_z = cos_rod_a*rod_c_turned_moment_y - rod_b_total_moment_z*sin_rod_a*sin_rod_b
    hinge_c_rod_b_torque_y = cos_rod_b*rod_c_turned_J_x_y + hinge_c_rod_b_force_x*rod_b_arm_z + hinge_c_rod_c_torque_x*sin_rod_b - hinge_c_rod_b_force_z*rod_b_arm_x
    rod_d_turned_moment_z_times_length = rod_d_turned_moment_z*length
    hinge_d_rod_d_torque_y = rod_d_total_J_y_y + rod_d_turned_moment_z_times_length
    hinge_d_rod_c_force_y = rod_c_total_moment_x*sin_rod_c
    hinge_d_rod_c_force_z = -cos_rod_c*rod_c_total_moment_x
    hinge_d_rod_c_torque_x = rod_d_turned_J_x_y - hinge_d_rod_c_force_z*length
    hinge_d_rod_c_torque_y = cos_rod_c*hinge_d_rod_d_torque_y - rod_d_turned_J_y_z*sin_rod_c
    hinge_d_rod_c_torque_z = rod_d_turned_moment_z_times_length + cos_rod_c*rod_d_turned_J_y_z + hinge_d_rod_d_torque_y*sin_rod_c
    cos_rod_b_times_rod_d_turned_moment_z = cos_rod_b*rod_d_turned_moment_z
    minus_hinge_d_rod_c_force_y_times_sin_rod_b = -hinge_d_rod_c_force_y*sin_rod_b
    x44 = cos_rod_b_times_rod_d_turned_moment_z + minus_hinge_d_rod_c_force_y_times_sin_rod_b
    hinge_d_rod_b_force_x = cos_rod_a*x44 + hinge_d_rod_c_force_z*sin_rod_a
    hinge_d_rod_b_force_z = cos_rod_a*hinge_d_rod_c_force_z - sin_rod_a*x44
    hinge_d_rod_b_torque_y = cos_rod_b*hinge_d_rod_c_torque_y + hinge_d_rod_b_force_x*rod_b_arm_z + hinge_d_rod_c_torque_x*sin_rod_b - hinge_d_rod_b_force_z*rod_b_arm_x
    minus_rod_e_turned_moment_x_times_length = -rod_e_turned_moment_x*length
    hinge_e_rod_e_torque_z = rod_e_I_x_x + minus_rod_e_turned_moment_x_times_length
    hinge_e_rod_d_force_x = -cos_rod_d*rod_d_total_moment_y
    hinge_e_rod_d_force_z = rod_d_total_moment_y*sin_rod_d
    hinge_e_rod_d_torque_x = minus_rod_e_turned_moment_x_times_length + hinge_e_rod_e_torque_z*sin_rod_d
    hinge_e_rod_d_torque_y = hinge_e_rod_d_force_x*length
    hinge_e_rod_d_torque_z = cos_rod_d*hinge_e_rod_e_torque_z
    hinge_e_rod_c_force_y = cos_rod_c*rod_e_turned_moment_x - hinge_e_rod_d_force_z*sin_rod_c
    hinge_e_rod_c_force_z = cos_rod_c*hinge_e_rod_d_force_z + sin_rod_c*rod_e_turned_moment_x
    hinge_e_rod_c_torque_x = hinge_e_rod_d_torque_x - hinge_e_rod_c_force_z*length
    hinge_e_rod_c_torque_y = cos_rod_c*hinge_e_rod_d_torque_y - hinge_e_rod_d_torque_z*sin_rod_c
    hinge_e_rod_c_torque_z = hinge_e_rod_d_torque_y + cos_rod_c*hinge_e_rod_d_torque_z + hinge_e_rod_d_torque_y*sin_rod_c
    cos_rod_b_times_hinge_e_rod_d_force_x = cos_rod_b*hinge_e_rod_d_force_x
    minus_hinge_e_rod_c_force_y_times_sin_rod_b = -hinge_e_rod_c_force_y*sin_rod_b
    x48 = cos_rod_b_times_hinge_e_rod_d_force_x + minus_hinge_e_rod_c_force_y_times_sin_rod_b
    hinge_e_rod_b_force_x = cos_rod_a*x48 + hinge_e_rod_c_force_z*sin_rod_a
    hinge_e_rod_b_force_z = cos_rod_a*hinge_e_rod_c_force_z - sin_rod_a*x48
    hinge_e_rod_b_torque_y = cos_rod_b*hinge_e_rod_c_torque_y + hinge_e_rod_b_force_x*rod_b_arm_z + hinge_e_rod_c_torque_x*sin_rod_b - hinge_e_rod_b_force_z*rod_b_arm_x
    l_hinge_c_hinge_e = hinge_e_rod_d_torque_x*inverse_rod_e_I_x_x
    l_hinge_c_hinge_d = rod_d_turned_J_x_y/rod_d_total_J_y_y
    D_hinge_c = rod_c_total_J_x_x - hinge_e_rod_d_torque_x*l_hinge_c_hinge_e - l_hinge_c_hinge_d*rod_d_turned_J_x_y
    l_hinge_b_hinge_e = hinge_e_rod_c_torque_z*inverse_rod_e_I_x_x
    l_hinge_b_hinge_d = hinge_d_rod_c_torque_z/rod_d_total_J_y_y
    L_hinge_b_hinge_c = rod_c_turned_J_x_z - hinge_d_rod_c_torque_z*l_hinge_c_hinge_d - hinge_e_rod_c_torque_z*l_hinge_c_hinge_e
    l_hinge_b_hinge_c = L_hinge_b_hinge_c/D_hinge_c
    D_hinge_b = rod_b_total_J_z_z - L_hinge_b_hinge_c*l_hinge_b_hinge_c - hinge_d_rod_c_torque_z*l_hinge_b_hinge_d - hinge_e_rod_c_torque_z*l_hinge_b_hinge_e
    l_hinge_a_hinge_e = hinge_e_rod_b_torque_y*inverse_rod_e_I_x_x
    l_hinge_a_hinge_d = hinge_d_rod_b_torque_y/rod_d_total_J_y_y
    L_hinge_a_hinge_c = hinge_c_rod_b_torque_y - hinge_d_rod_b_torque_y*l_hinge_c_hinge_d - hinge_e_rod_b_torque_y*l_hinge_c_hinge_e
    l_hinge_a_hinge_c = L_hinge_a_hinge_c/D_hinge_c
    L_hinge_a_hinge_b = hinge_b_rod_b_torque_y - L_hinge_a_hinge_c*l_hinge_b_hinge_c - hinge_d_rod_b_torque_y*l_hinge_b_hinge_d - hinge_e_rod_b_torque_y*l_hinge_b_hinge_e
    l_hinge_a_hinge_b = L_hinge_a_hinge_b/D_hinge_b
    D_hinge_a = rod_a_total_J_y_y - L_hinge_a_hinge_b*l_hinge_a_hinge_b - L_hinge_a_hinge_c*l_hinge_a_hinge_c - hinge_d_rod_b_torque_y*l_hinge_a_hinge_d - hinge_e_rod_b_torque_y*l_hinge_a_hinge_e
    y_hinge_c = hinge_c_net - hinge_d_net*l_hinge_c_hinge_d - hinge_e_net*l_hinge_c_hinge_e
    y_hinge_b = hinge_b_net - hinge_d_net*l_hinge_b_hinge_d - hinge_e_net*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c
    y_hinge_a = hinge_a_net - hinge_d_net*l_hinge_a_hinge_d - hinge_e_net*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b - l_hinge_a_hinge_c*y_hinge_c
    hinge_a_acc = y_hinge_a/D_hinge_a
    hinge_b_acc = y_hinge_b/D_hinge_b - hinge_a_acc*l_hinge_a_hinge_b
    hinge_c_acc = y_hinge_c/D_hinge_c - hinge_a_acc*l_hinge_a_hinge_c - hinge_b_acc*l_hinge_b_hinge_c
    hinge_d_acc = hinge_d_net/rod_d_total_J_y_y - hinge_a_acc*l_hinge_a_hinge_d - hinge_b_acc*l_hinge_b_hinge_d - hinge_c_acc*l_hinge_c_hinge_d
    hinge_e_acc = hinge_e_net*inverse_rod_e_I_x_x - hinge_a_acc*l_hinge_a_hinge_e - hinge_b_acc*l_hinge_b_hinge_e - hinge_c_acc*l_hinge_c_hinge_e
    y_hinge_c_2 = hinge_f_x_on_hinge_c - hinge_f_x_on_hinge_d*l_hinge_c_hinge_d - hinge_f_x_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_2 = hinge_f_x_on_hinge_b - hinge_f_x_on_hinge_d*l_hinge_b_hinge_d - hinge_f_x_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_2
    y_hinge_a_2 = hinge_f_x_on_hinge_a - hinge_f_x_on_hinge_d*l_hinge_a_hinge_d - hinge_f_x_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_2 - l_hinge_a_hinge_c*y_hinge_c_2
    hinge_a_by_hinge_f_apart_x = y_hinge_a_2/D_hinge_a
    hinge_b_by_hinge_f_apart_x = y_hinge_b_2/D_hinge_b - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_x = y_hinge_c_2/D_hinge_c - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_x = hinge_f_x_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_x*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_x = hinge_f_x_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_x*l_hinge_c_hinge_e
    y_hinge_c_3 = hinge_f_y_on_hinge_c - hinge_f_y_on_hinge_d*l_hinge_c_hinge_d - hinge_f_y_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_3 = hinge_f_y_on_hinge_b - hinge_f_y_on_hinge_d*l_hinge_b_hinge_d - hinge_f_y_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_3
    y_hinge_a_3 = -hinge_f_y_on_hinge_d*l_hinge_a_hinge_d - hinge_f_y_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_3 - l_hinge_a_hinge_c*y_hinge_c_3
    hinge_a_by_hinge_f_apart_y = y_hinge_a_3/D_hinge_a
    hinge_b_by_hinge_f_apart_y = y_hinge_b_3/D_hinge_b - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_y = y_hinge_c_3/D_hinge_c - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_y = hinge_f_y_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_y*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_y = hinge_f_y_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_y*l_hinge_c_hinge_e
    y_hinge_c_4 = hinge_f_z_on_hinge_c - hinge_f_z_on_hinge_d*l_hinge_c_hinge_d - hinge_f_z_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_4 = hinge_f_z_on_hinge_b - hinge_f_z_on_hinge_d*l_hinge_b_hinge_d - hinge_f_z_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_4
    y_hinge_a_4 = -hinge_f_apart_x - hinge_f_z_on_hinge_d*l_hinge_a_hinge_d - hinge_f_z_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_4 - l_hinge_a_hinge_c*y_hinge_c_4
    hinge_a_by_hinge_f_apart_z = y_hinge_a_4/D_hinge_a
    hinge_b_by_hinge_f_apart_z = y_hinge_b_4/D_hinge_b - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_z = y_hinge_c_4/D_hinge_c - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_z = hinge_f_z_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_z*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_z = hinge_f_z_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_z*l_hinge_c_hinge_e
    y_hinge_c_5 = hinge_f_turned_y_on_hinge_c - hinge_f_turned_y_on_hinge_d*l_hinge_c_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_5 = hinge_f_turned_y_on_hinge_b - hinge_f_turned_y_on_hinge_d*l_hinge_b_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_5
    y_hinge_a_5 = -hinge_f_turned_y_on_hinge_d*l_hinge_a_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_5 - l_hinge_a_hinge_c*y_hinge_c_5
    hinge_a_by_hinge_f_turned_y = y_hinge_a_5/D_hinge_a
    hinge_b_by_hinge_f_turned_y = y_hinge_b_5/D_hinge_b - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_turned_y = y_hinge_c_5/D_hinge_c - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_c - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_turned_y = hinge_f_turned_y_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_d - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_d - hinge_c_by_hinge_f_turned_y*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_turned_y = hinge_f_turned_y_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_e - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_e - hinge_c_by_hinge_f_turned_y*l_hinge_c_hinge_e
    y_hinge_c_6 = hinge_f_turned_z_on_hinge_c - hinge_f_turned_z_on_hinge_d*l_hinge_c_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_6 = hinge_f_turned_z_on_hinge_b - hinge_f_turned_z_on_hinge_d*l_hinge_b_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_6
    y_hinge_a_6 = -rod_e_R_x_x - hinge_f_turned_z_on_hinge_d*l_hinge_a_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_6 - l_hinge_a_hinge_c*y_hinge_c_6
    hinge_a_by_hinge_f_turned_z = y_hinge_a_6/D_hinge_a
    hinge_b_by_hinge_f_turned_z = y_hinge_b_6/D_hinge_b - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_turned_z = y_hinge_c_6/D_hinge_c - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_c - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_turned_z = hinge_f_turned_z_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_d - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_d - hinge_c_by_hinge_f_turned_z*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_turned_z = hinge_f_turned_z_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_e - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_e - hinge_c_by_hinge_f_turned_z*l_hinge_c_hinge_e
    W_hinge_f_apart_x_hinge_f_apart_x = hinge_a_by_hinge_f_apart_x*hinge_f_x_on_hinge_a + hinge_b_by_hinge_f_apart_x*hinge_f_x_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_x_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_x_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_x_on_hinge_e
    W_hinge_f_apart_y_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_y_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_y_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_y_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_y_on_hinge_e
    W_hinge_f_apart_y_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_y_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_y_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_y_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_y_on_hinge_e
    W_hinge_f_apart_z_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_x*hinge_f_apart_x
    W_hinge_f_apart_z_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_y*hinge_f_apart_x
    W_hinge_f_apart_z_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_z*hinge_f_apart_x
    W_hinge_f_turned_y_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_turned_y = hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_z_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_x*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_y*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_z*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_turned_y = hinge_b_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_turned_y*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_turned_z = hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_turned_z*rod_e_R_x_x
    hinge_f_apart_size = W_hinge_f_apart_x_hinge_f_apart_x + W_hinge_f_apart_y_hinge_f_apart_y + W_hinge_f_apart_z_hinge_f_apart_z
    W_hinge_f_apart_x_raised = W_hinge_f_apart_x_hinge_f_apart_x + hinge_f_apart_size*hinge_f_apart_x_softness
    W_hinge_f_apart_y_raised = W_hinge_f_apart_y_hinge_f_apart_y + hinge_f_apart_size*hinge_f_apart_y_softness
    W_hinge_f_apart_z_raised = W_hinge_f_apart_z_hinge_f_apart_z + hinge_f_apart_size*hinge_f_apart_z_softness
    hinge_f_turned_size = W_hinge_f_turned_y_hinge_f_turned_y + W_hinge_f_turned_z_hinge_f_turned_z
    W_hinge_f_turned_y_raised = W_hinge_f_turned_y_hinge_f_turned_y + hinge_f_turned_size*hinge_f_turned_y_softness
    W_hinge_f_turned_z_raised = W_hinge_f_turned_z_hinge_f_turned_z + hinge_f_turned_size*hinge_f_turned_z_softness
    l_hinge_f_apart_y_hinge_f_apart_x = W_hinge_f_apart_y_hinge_f_apart_x/W_hinge_f_apart_x_raised
    D_hinge_f_apart_y = W_hinge_f_apart_y_raised - W_hinge_f_apart_y_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_apart_z_hinge_f_apart_x = W_hinge_f_apart_z_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_apart_z_hinge_f_apart_y = W_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_apart_z_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_apart_z_hinge_f_apart_y = L_hinge_f_apart_z_hinge_f_apart_y/D_hinge_f_apart_y
    D_hinge_f_apart_z = W_hinge_f_apart_z_raised - L_hinge_f_apart_z_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_apart_z_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_x = W_hinge_f_turned_y_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_turned_y_hinge_f_apart_y = W_hinge_f_turned_y_hinge_f_apart_y - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_y = L_hinge_f_turned_y_hinge_f_apart_y/D_hinge_f_apart_y
    L_hinge_f_turned_y_hinge_f_apart_z = W_hinge_f_turned_y_hinge_f_apart_z - L_hinge_f_turned_y_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_z = L_hinge_f_turned_y_hinge_f_apart_z/D_hinge_f_apart_z
    D_hinge_f_turned_y = W_hinge_f_turned_y_raised - L_hinge_f_turned_y_hinge_f_apart_y*l_hinge_f_turned_y_hinge_f_apart_y - L_hinge_f_turned_y_hinge_f_apart_z*l_hinge_f_turned_y_hinge_f_apart_z - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_turned_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_x = W_hinge_f_turned_z_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_turned_z_hinge_f_apart_y = W_hinge_f_turned_z_hinge_f_apart_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_y = L_hinge_f_turned_z_hinge_f_apart_y/D_hinge_f_apart_y
    L_hinge_f_turned_z_hinge_f_apart_z = W_hinge_f_turned_z_hinge_f_apart_z - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_z = L_hinge_f_turned_z_hinge_f_apart_z/D_hinge_f_apart_z
    L_hinge_f_turned_z_hinge_f_turned_y = W_hinge_f_turned_z_hinge_f_turned_y - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_turned_y_hinge_f_apart_y - L_hinge_f_turned_z_hinge_f_apart_z*l_hinge_f_turned_y_hinge_f_apart_z - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_turned_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_turned_y = L_hinge_f_turned_z_hinge_f_turned_y/D_hinge_f_turned_y
    D_hinge_f_turned_z = W_hinge_f_turned_z_raised - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_turned_z_hinge_f_apart_y - L_hinge_f_turned_z_hinge_f_apart_z*l_hinge_f_turned_z_hinge_f_apart_z - L_hinge_f_turned_z_hinge_f_turned_y*l_hinge_f_turned_z_hinge_f_turned_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_f_apart_x_left = -hinge_f_apart_bias_x - hinge_a_acc*hinge_f_x_on_hinge_a - hinge_b_acc*hinge_f_x_on_hinge_b - hinge_c_acc*hinge_f_x_on_hinge_c - hinge_d_acc*hinge_f_x_on_hinge_d - hinge_e_acc*hinge_f_x_on_hinge_e
    hinge_f_apart_y_left = -hinge_f_apart_bias_y - hinge_b_acc*hinge_f_y_on_hinge_b - hinge_c_acc*hinge_f_y_on_hinge_c - hinge_d_acc*hinge_f_y_on_hinge_d - hinge_e_acc*hinge_f_y_on_hinge_e
    hinge_f_apart_z_left = hinge_a_acc*hinge_f_apart_x - hinge_f_apart_bias_z - hinge_b_acc*hinge_f_z_on_hinge_b - hinge_c_acc*hinge_f_z_on_hinge_c - hinge_d_acc*hinge_f_z_on_hinge_d - hinge_e_acc*hinge_f_z_on_hinge_e
    hinge_f_turned_y_left = -hinge_f_turned_y_bias - hinge_b_acc*hinge_f_turned_y_on_hinge_b - hinge_c_acc*hinge_f_turned_y_on_hinge_c - hinge_d_acc*hinge_f_turned_y_on_hinge_d - hinge_e_acc*hinge_f_turned_y_on_hinge_e
    hinge_f_turned_z_left = hinge_a_acc*rod_e_R_x_x - hinge_f_turned_z_bias - hinge_b_acc*hinge_f_turned_z_on_hinge_b - hinge_c_acc*hinge_f_turned_z_on_hinge_c - hinge_d_acc*hinge_f_turned_z_on_hinge_d - hinge_e_acc*hinge_f_turned_z_on_hinge_e
    y_hinge_f_apart_y = hinge_f_apart_y_left - hinge_f_apart_x_left*l_hinge_f_apart_y_hinge_f_apart_x
    y_hinge_f_apart_z = hinge_f_apart_z_left - hinge_f_apart_x_left*l_hinge_f_apart_z_hinge_f_apart_x - l_hinge_f_apart_z_hinge_f_apart_y*y_hinge_f_apart_y
    y_hinge_f_turned_y = hinge_f_turned_y_left - hinge_f_apart_x_left*l_hinge_f_turned_y_hinge_f_apart_x - l_hinge_f_turned_y_hinge_f_apart_y*y_hinge_f_apart_y - l_hinge_f_turned_y_hinge_f_apart_z*y_hinge_f_apart_z
    y_hinge_f_turned_z = hinge_f_turned_z_left - hinge_f_apart_x_left*l_hinge_f_turned_z_hinge_f_apart_x - l_hinge_f_turned_z_hinge_f_apart_y*y_hinge_f_apart_y - l_hinge_f_turned_z_hinge_f_apart_z*y_hinge_f_apart_z - l_hinge_f_turned_z_hinge_f_turned_y*y_hinge_f_turned_y
    hinge_f_turned_z_acc = y_hinge_f_turned_z/D_hinge_f_turned_z
    hinge_f_turned_y_acc = y_hinge_f_turned_y/D_hinge_f_turned_y - hinge_f_turned_z_acc*l_hinge_f_turned_z_hinge_f_turned_y
    hinge_f_apart_z_acc = y_hinge_f_apart_z/D_hinge_f_apart_z - hinge_f_turned_y_acc*l_hinge_f_turned_y_hinge_f_apart_z - hinge_f_turned_z_acc*l_hinge_f_turned_z_hinge_f_apart_z
    hinge_f_apart_y_acc = y_hinge_f_apart_y/D_hinge_f_apart_y - hinge_f_apart_z_acc*l_hinge_f_apart_z_hinge_f_apart_y - hinge_f_turned_y_acc*l_hinge_f_turned_y_hinge_f_apart_y - hinge_f_turned_z_acc*l_hinge_f_turned_z_hinge_f_apart_y
    hinge_f_apart_x_acc = hinge_f_apart_x_left/W_hinge_f_apart_x_raised - hinge_f_apart_y_acc*l_hinge_f_apart_y_hinge_f_apart_x - hinge_f_apart_z_acc*l_hinge_f_apart_z_hinge_f_apart_x - hinge_f_turned_y_acc*l_hinge_f_turned_y_hinge_f_apart_x - hinge_f_turned_z_acc*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_a_acc_2 = hinge_a_acc + hinge_a_by_hinge_f_apart_x*hinge_f_apart_x_acc + hinge_a_by_hinge_f_apart_y*hinge_f_apart_y_acc + hinge_a_by_hinge_f_apart_z*hinge_f_apart_z_acc + hinge_a_by_hinge_f_turned_y*hinge_f_turned_y_acc + hinge_a_by_hinge_f_turned_z*hinge_f_turned_z_acc
    hinge_b_acc_2 = hinge_b_acc + hinge_b_by_hinge_f_apart_x*hinge_f_apart_x_acc + hinge_b_by_hinge_f_apart_y*hinge_f_apart_y_acc + hinge_b_by_hinge_f_apart_z*hinge_f_apart_z_acc + hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_acc + hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_acc
    hinge_c_acc_2 = hinge_c_acc + hinge_c_by_hinge_f_apart_x*hinge_f_apart_x_acc + hinge_c_by_hinge_f_apart_y*hinge_f_apart_y_acc + hinge_c_by_hinge_f_apart_z*hinge_f_apart_z_acc + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_acc + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_acc
    hinge_d_acc_2 = hinge_d_acc + hinge_d_by_hinge_f_apart_x*hinge_f_apart_x_acc + hinge_d_by_hinge_f_apart_y*hinge_f_apart_y_acc + hinge_d_by_hinge_f_apart_z*hinge_f_apart_z_acc + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_acc + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_acc
    hinge_e_acc_2 = hinge_e_acc + hinge_e_by_hinge_f_apart_x*hinge_f_apart_x_acc + hinge_e_by_hinge_f_apart_y*hinge_f_apart_y_acc + hinge_e_by_hinge_f_apart_z*hinge_f_apart_z_acc + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_acc + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_acc
    hinge_f_apart_x_left_2 = -hinge_f_apart_bias_x - hinge_a_acc_2*hinge_f_x_on_hinge_a - hinge_b_acc_2*hinge_f_x_on_hinge_b - hinge_c_acc_2*hinge_f_x_on_hinge_c - hinge_d_acc_2*hinge_f_x_on_hinge_d - hinge_e_acc_2*hinge_f_x_on_hinge_e
    hinge_f_apart_y_left_2 = -hinge_f_apart_bias_y - hinge_b_acc_2*hinge_f_y_on_hinge_b - hinge_c_acc_2*hinge_f_y_on_hinge_c - hinge_d_acc_2*hinge_f_y_on_hinge_d - hinge_e_acc_2*hinge_f_y_on_hinge_e
    hinge_f_apart_z_left_2 = hinge_a_acc_2*hinge_f_apart_x - hinge_f_apart_bias_z - hinge_b_acc_2*hinge_f_z_on_hinge_b - hinge_c_acc_2*hinge_f_z_on_hinge_c - hinge_d_acc_2*hinge_f_z_on_hinge_d - hinge_e_acc_2*hinge_f_z_on_hinge_e
    hinge_f_turned_y_left_2 = -hinge_f_turned_y_bias - hinge_b_acc_2*hinge_f_turned_y_on_hinge_b - hinge_c_acc_2*hinge_f_turned_y_on_hinge_c - hinge_d_acc_2*hinge_f_turned_y_on_hinge_d - hinge_e_acc_2*hinge_f_turned_y_on_hinge_e
    hinge_f_turned_z_left_2 = hinge_a_acc_2*rod_e_R_x_x - hinge_f_turned_z_bias - hinge_b_acc_2*hinge_f_turned_z_on_hinge_b - hinge_c_acc_2*hinge_f_turned_z_on_hinge_c - hinge_d_acc_2*hinge_f_turned_z_on_hinge_d - hinge_e_acc_2*hinge_f_turned_z_on_hinge_e
    y_hinge_f_apart_y_2 = hinge_f_apart_y_left_2 - hinge_f_apart_x_left_2*l_hinge_f_apart_y_hinge_f_apart_x
    y_hinge_f_apart_z_2 = hinge_f_apart_z_left_2 - hinge_f_apart_x_left_2*l_hinge_f_apart_z_hinge_f_apart_x - l_hinge_f_apart_z_hinge_f_apart_y*y_hinge_f_apart_y_2
    y_hinge_f_turned_y_2 = hinge_f_turned_y_left_2 - hinge_f_apart_x_left_2*l_hinge_f_turned_y_hinge_f_apart_x - l_hinge_f_turned_y_hinge_f_apart_y*y_hinge_f_apart_y_2 - l_hinge_f_turned_y_hinge_f_apart_z*y_hinge_f_apart_z_2
    y_hinge_f_turned_z_2 = hinge_f_turned_z_left_2 - hinge_f_apart_x_left_2*l_hinge_f_turned_z_hinge_f_apart_x - l_hinge_f_turned_z_hinge_f_apart_y*y_hinge_f_apart_y_2 - l_hinge_f_turned_z_hinge_f_apart_z*y_hinge_f_apart_z_2 - l_hinge_f_turned_z_hinge_f_turned_y*y_hinge_f_turned_y_2
    hinge_f_turned_z_acc_2 = y_hinge_f_turned_z_2/D_hinge_f_turned_z
    hinge_f_turned_y_acc_2 = y_hinge_f_turned_y_2/D_hinge_f_turned_y - hinge_f_turned_z_acc_2*l_hinge_f_turned_z_hinge_f_turned_y
    hinge_f_apart_z_acc_2 = y_hinge_f_apart_z_2/D_hinge_f_apart_z - hinge_f_turned_y_acc_2*l_hinge_f_turned_y_hinge_f_apart_z - hinge_f_turned_z_acc_2*l_hinge_f_turned_z_hinge_f_apart_z
    hinge_f_apart_y_acc_2 = y_hinge_f_apart_y_2/D_hinge_f_apart_y - hinge_f_apart_z_acc_2*l_hinge_f_apart_z_hinge_f_apart_y - hinge_f_turned_y_acc_2*l_hinge_f_turned_y_hinge_f_apart_y - hinge_f_turned_z_acc_2*l_hinge_f_turned_z_hinge_f_apart_y
    hinge_f_apart_x_acc_2 = hinge_f_apart_x_left_2/W_hinge_f_apart_x_raised - hinge_f_apart_y_acc_2*l_hinge_f_apart_y_hinge_f_apart_x - hinge_f_apart_z_acc_2*l_hinge_f_apart_z_hinge_f_apart_x - hinge_f_turned_y_acc_2*l_hinge_f_turned_y_hinge_f_apart_x - hinge_f_turned_z_acc_2*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_f_apart_x_acc_3 = hinge_f_apart_x_acc + hinge_f_apart_x_acc_2
    hinge_f_apart_y_acc_3 = hinge_f_apart_y_acc + hinge_f_apart_y_acc_2
    hinge_f_apart_z_acc_3 = hinge_f_apart_z_acc + hinge_f_apart_z_acc_2
    hinge_f_turned_y_acc_3 = hinge_f_turned_y_acc + hinge_f_turned_y_acc_2
    hinge_f_turned_z_acc_3 = hinge_f_turned_z_acc + hinge_f_turned_z_acc_2
    hinge_a_acc_3 = hinge_a_acc_2 + hinge_a_by_hinge_f_apart_x*hinge_f_apart_x_acc_2 + hinge_a_by_hinge_f_apart_y*hinge_f_apart_y_acc_2 + hinge_a_by_hinge_f_apart_z*hinge_f_apart_z_acc_2 + hinge_a_by_hinge_f_turned_y*hinge_f_turned_y_acc_2 + hinge_a_by_hinge_f_turned_z*hinge_f_turned_z_acc_2
    hinge_b_acc_3 = hinge_b_acc_2 + hinge_b_by_hinge_f_apart_x*hinge_f_apart_x_acc_2 + hinge_b_by_hinge_f_apart_y*hinge_f_apart_y_acc_2 + hinge_b_by_hinge_f_apart_z*hinge_f_apart_z_acc_2 + hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_acc_2 + hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_acc_2
    hinge_c_acc_3 = hinge_c_acc_2 + hinge_c_by_hinge_f_apart_x*hinge_f_apart_x_acc_2 + hinge_c_by_hinge_f_apart_y*hinge_f_apart_y_acc_2 + hinge_c_by_hinge_f_apart_z*hinge_f_apart_z_acc_2 + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_acc_2 + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_acc_2
    hinge_d_acc_3 = hinge_d_acc_2 + hinge_d_by_hinge_f_apart_x*hinge_f_apart_x_acc_2 + hinge_d_by_hinge_f_apart_y*hinge_f_apart_y_acc_2 + hinge_d_by_hinge_f_apart_z*hinge_f_apart_z_acc_2 + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_acc_2 + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_acc_2
    hinge_e_acc_3 = hinge_e_acc_2 + hinge_e_by_hinge_f_apart_x*hinge_f_apart_x_acc_2 + hinge_e_by_hinge_f_apart_y*hinge_f_apart_y_acc_2 + hinge_e_by_hinge_f_apart_z*hinge_f_apart_z_acc_2 + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_acc_2 + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_acc_2
    hinge_f_apart_x_left_3 = -hinge_f_apart_bias_x - hinge_a_acc_3*hinge_f_x_on_hinge_a - hinge_b_acc_3*hinge_f_x_on_hinge_b - hinge_c_acc_3*hinge_f_x_on_hinge_c - hinge_d_acc_3*hinge_f_x_on_hinge_d - hinge_e_acc_3*hinge_f_x_on_hinge_e
    hinge_f_apart_y_left_3 = -hinge_f_apart_bias_y - hinge_b_acc_3*hinge_f_y_on_hinge_b - hinge_c_acc_3*hinge_f_y_on_hinge_c - hinge_d_acc_3*hinge_f_y_on_hinge_d - hinge_e_acc_3*hinge_f_y_on_hinge_e
    hinge_f_apart_z_left_3 = hinge_a_acc_3*hinge_f_apart_x - hinge_f_apart_bias_z - hinge_b_acc_3*hinge_f_z_on_hinge_b - hinge_c_acc_3*hinge_f_z_on_hinge_c - hinge_d_acc_3*hinge_f_z_on_hinge_d - hinge_e_acc_3*hinge_f_z_on_hinge_e
    hinge_f_turned_y_left_3 = -hinge_f_turned_y_bias - hinge_b_acc_3*hinge_f_turned_y_on_hinge_b - hinge_c_acc_3*hinge_f_turned_y_on_hinge_c - hinge_d_acc_3*hinge_f_turned_y_on_hinge_d - hinge_e_acc_3*hinge_f_turned_y_on_hinge_e
    hinge_f_turned_z_left_3 = hinge_a_acc_3*rod_e_R_x_x - hinge_f_turned_z_bias - hinge_b_acc_3*hinge_f_turned_z_on_hinge_b - hinge_c_acc_3*hinge_f_turned_z_on_hinge_c - hinge_d_acc_3*hinge_f_turned_z_on_hinge_d - hinge_e_acc_3*hinge_f_turned_z_on_hinge_e
    y_hinge_f_apart_y_3 = hinge_f_apart_y_left_3 - hinge_f_apart_x_left_3*l_hinge_f_apart_y_hinge_f_apart_x
    y_hinge_f_apart_z_3 = hinge_f_apart_z_left_3 - hinge_f_apart_x_left_3*l_hinge_f_apart_z_hinge_f_apart_x - l_hinge_f_apart_z_hinge_f_apart_y*y_hinge_f_apart_y_3
    y_hinge_f_turned_y_3 = hinge_f_turned_y_left_3 - hinge_f_apart_x_left_3*l_hinge_f_turned_y_hinge_f_apart_x - l_hinge_f_turned_y_hinge_f_apart_y*y_hinge_f_apart_y_3 - l_hinge_f_turned_y_hinge_f_apart_z*y_hinge_f_apart_z_3
    y_hinge_f_turned_z_3 = hinge_f_turned_z_left_3 - hinge_f_apart_x_left_3*l_hinge_f_turned_z_hinge_f_apart_x - l_hinge_f_turned_z_hinge_f_apart_y*y_hinge_f_apart_y_3 - l_hinge_f_turned_z_hinge_f_apart_z*y_hinge_f_apart_z_3 - l_hinge_f_turned_z_hinge_f_turned_y*y_hinge_f_turned_y_3
    hinge_f_turned_z_acc_4 = y_hinge_f_turned_z_3/D_hinge_f_turned_z
    hinge_f_turned_y_acc_4 = y_hinge_f_turned_y_3/D_hinge_f_turned_y - hinge_f_turned_z_acc_4*l_hinge_f_turned_z_hinge_f_turned_y
    hinge_f_apart_z_acc_4 = y_hinge_f_apart_z_3/D_hinge_f_apart_z - hinge_f_turned_y_acc_4*l_hinge_f_turned_y_hinge_f_apart_z - hinge_f_turned_z_acc_4*l_hinge_f_turned_z_hinge_f_apart_z
    hinge_f_apart_y_acc_4 = y_hinge_f_apart_y_3/D_hinge_f_apart_y - hinge_f_apart_z_acc_4*l_hinge_f_apart_z_hinge_f_apart_y - hinge_f_turned_y_acc_4*l_hinge_f_turned_y_hinge_f_apart_y - hinge_f_turned_z_acc_4*l_hinge_f_turned_z_hinge_f_apart_y
    hinge_f_apart_x_acc_4 = hinge_f_apart_x_left_3/W_hinge_f_apart_x_raised - hinge_f_apart_y_acc_4*l_hinge_f_apart_y_hinge_f_apart_x - hinge_f_apart_z_acc_4*l_hinge_f_apart_z_hinge_f_apart_x - hinge_f_turned_y_acc_4*l_hinge_f_turned_y_hinge_f_apart_x - hinge_f_turned_z_acc_4*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_f_apart_x_acc_5 = hinge_f_apart_x_acc_3 + hinge_f_apart_x_acc_4
    hinge_f_apart_y_acc_5 = hinge_f_apart_y_acc_3 + hinge_f_apart_y_acc_4
    hinge_f_apart_z_acc_5 = hinge_f_apart_z_acc_3 + hinge_f_apart_z_acc_4
    hinge_f_turned_y_acc_5 = hinge_f_turned_y_acc_3 + hinge_f_turned_y_acc_4
    hinge_f_turned_z_acc_5 = hinge_f_turned_z_acc_3 + hinge_f_turned_z_acc_4
    hinge_a_acc_4 = hinge_a_acc_3 + hinge_a_by_hinge_f_apart_x*hinge_f_apart_x_acc_4 + hinge_a_by_hinge_f_apart_y*hinge_f_apart_y_acc_4 + hinge_a_by_hinge_f_apart_z*hinge_f_apart_z_acc_4 + hinge_a_by_hinge_f_turned_y*hinge_f_turned_y_acc_4 + hinge_a_by_hinge_f_turned_z*hinge_f_turned_z_acc_4
    hinge_b_acc_4 = hinge_b_acc_3 + hinge_b_by_hinge_f_apart_x*hinge_f_apart_x_acc_4 + hinge_b_by_hinge_f_apart_y*hinge_f_apart_y_acc_4 + hinge_b_by_hinge_f_apart_z*hinge_f_apart_z_acc_4 + hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_acc_4 + hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_acc_4
    hinge_c_acc_4 = hinge_c_acc_3 + hinge_c_by_hinge_f_apart_x*hinge_f_apart_x_acc_4 + hinge_c_by_hinge_f_apart_y*hinge_f_apart_y_acc_4 + hinge_c_by_hinge_f_apart_z*hinge_f_apart_z_acc_4 + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_acc_4 + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_acc_4
    hinge_d_acc_4 = hinge_d_acc_3 + hinge_d_by_hinge_f_apart_x*hinge_f_apart_x_acc_4 + hinge_d_by_hinge_f_apart_y*hinge_f_apart_y_acc_4 + hinge_d_by_hinge_f_apart_z*hinge_f_apart_z_acc_4 + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_acc_4 + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_acc_4
    hinge_e_acc_4 = hinge_e_acc_3 + hinge_e_by_hinge_f_apart_x*hinge_f_apart_x_acc_4 + hinge_e_by_hinge_f_apart_y*hinge_f_apart_y_acc_4 + hinge_e_by_hinge_f_apart_z*hinge_f_apart_z_acc_4 + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_acc_4 + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_acc_4
    return (ca.vertcat(hinge_a_acc_4, hinge_b_acc_4, hinge_c_acc_4, hinge_d_acc_4, hinge_e_acc_4), ca.vertcat(),
        ca.vertcat(hinge_f_apart_x_acc_5, hinge_f_apart_y_acc_5, hinge_f_apart_z_acc_5, hinge_f_turned_y_acc_5, hinge_f_turned_z_acc_5))


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (5,): CONSTRAINTS
        dphi (5,): hinge_f.apart_x [m/s], hinge_f.apart_y [m/s], hinge_f.apart_z [m/s], hinge_f.turned_y [1/s], hinge_f.turned_z [1/s]
    """
    length = c[0]
    hinge_a_angle, hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[0], q[1], q[2], q[3], q[4]
    hinge_a_speed, hinge_b_speed, hinge_c_speed, hinge_d_speed, hinge_e_speed = u[0], u[1], u[2], u[3], u[4]
    cos_rod_a = ca.cos(hinge_a_angle)
    sin_rod_a = ca.sin(hinge_a_angle)
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_b_arm_x = cos_rod_a*length
    rod_b_arm_z = -sin_rod_a*length
    rod_b_arm_rate_x = hinge_a_speed*rod_b_arm_z
    rod_b_arm_rate_z = -hinge_a_speed*rod_b_arm_x
    rod_b_turning_x = hinge_b_speed*sin_rod_a
    rod_b_turning_z = cos_rod_a*hinge_b_speed
    rod_b_R_x_x = cos_rod_a*cos_rod_b
    rod_b_R_x_y = -cos_rod_a*sin_rod_b
    rod_b_R_z_x = -cos_rod_b*sin_rod_a
    rod_b_R_z_y = sin_rod_a*sin_rod_b
    rod_c_arm_x = -rod_b_R_x_y*length
    rod_c_arm_y = -cos_rod_b*length
    rod_c_arm_z = -rod_b_R_z_y*length
    rod_c_arm_rate_x = hinge_a_speed*rod_c_arm_z - rod_b_turning_z*rod_c_arm_y
    rod_c_arm_rate_y = rod_b_turning_z*rod_c_arm_x - rod_b_turning_x*rod_c_arm_z
    rod_c_arm_rate_z = rod_b_turning_x*rod_c_arm_y - hinge_a_speed*rod_c_arm_x
    rod_c_turning_x = hinge_c_speed*rod_b_R_x_x
    rod_c_turning_y = hinge_c_speed*sin_rod_b
    rod_c_turning_z = hinge_c_speed*rod_b_R_z_x
    rod_c_rate_x = rod_b_turning_x + rod_c_turning_x
    rod_c_rate_y = hinge_a_speed + rod_c_turning_y
    rod_c_rate_z = rod_b_turning_z + rod_c_turning_z
    rod_c_x = rod_b_arm_x + rod_c_arm_x
    rod_c_z = rod_b_arm_z + rod_c_arm_z
    rod_c_velocity_x = rod_b_arm_rate_x + rod_c_arm_rate_x
    rod_c_velocity_z = rod_b_arm_rate_z + rod_c_arm_rate_z
    rod_c_R_x_y = cos_rod_c*rod_b_R_x_y + sin_rod_a*sin_rod_c
    rod_c_R_x_z = cos_rod_c*sin_rod_a - rod_b_R_x_y*sin_rod_c
    rod_c_R_y_y = cos_rod_b*cos_rod_c
    rod_c_R_y_z = -cos_rod_b*sin_rod_c
    rod_c_R_z_y = cos_rod_a*sin_rod_c + cos_rod_c*rod_b_R_z_y
    rod_c_R_z_z = cos_rod_a*cos_rod_c - rod_b_R_z_y*sin_rod_c
    rod_d_arm_x = rod_c_R_x_z*length
    rod_d_arm_y = rod_c_R_y_z*length
    rod_d_arm_z = rod_c_R_z_z*length
    rod_d_arm_rate_x = rod_c_rate_y*rod_d_arm_z - rod_c_rate_z*rod_d_arm_y
    rod_d_arm_rate_y = rod_c_rate_z*rod_d_arm_x - rod_c_rate_x*rod_d_arm_z
    rod_d_arm_rate_z = rod_c_rate_x*rod_d_arm_y - rod_c_rate_y*rod_d_arm_x
    rod_d_turning_x = hinge_d_speed*rod_c_R_x_y
    rod_d_turning_y = hinge_d_speed*rod_c_R_y_y
    rod_d_turning_z = hinge_d_speed*rod_c_R_z_y
    rod_d_rate_x = rod_c_rate_x + rod_d_turning_x
    rod_d_rate_y = rod_c_rate_y + rod_d_turning_y
    rod_d_rate_z = rod_c_rate_z + rod_d_turning_z
    rod_d_x = rod_c_x + rod_d_arm_x
    rod_d_y = rod_c_arm_y + rod_d_arm_y
    rod_d_z = rod_c_z + rod_d_arm_z
    rod_d_velocity_x = rod_c_velocity_x + rod_d_arm_rate_x
    rod_d_velocity_y = rod_c_arm_rate_y + rod_d_arm_rate_y
    rod_d_velocity_z = rod_c_velocity_z + rod_d_arm_rate_z
    rod_d_R_x_x = cos_rod_d*rod_b_R_x_x - rod_c_R_x_z*sin_rod_d
    rod_d_R_x_z = cos_rod_d*rod_c_R_x_z + rod_b_R_x_x*sin_rod_d
    rod_d_R_y_x = cos_rod_d*sin_rod_b - rod_c_R_y_z*sin_rod_d
    rod_d_R_y_z = cos_rod_d*rod_c_R_y_z + sin_rod_b*sin_rod_d
    rod_d_R_z_x = cos_rod_d*rod_b_R_z_x - rod_c_R_z_z*sin_rod_d
    rod_d_R_z_z = cos_rod_d*rod_c_R_z_z + rod_b_R_z_x*sin_rod_d
    rod_e_arm_x = -rod_d_R_x_x*length
    rod_e_arm_y = -rod_d_R_y_x*length
    rod_e_arm_z = -rod_d_R_z_x*length
    rod_e_arm_rate_x = rod_d_rate_y*rod_e_arm_z - rod_d_rate_z*rod_e_arm_y
    rod_e_arm_rate_y = rod_d_rate_z*rod_e_arm_x - rod_d_rate_x*rod_e_arm_z
    rod_e_arm_rate_z = rod_d_rate_x*rod_e_arm_y - rod_d_rate_y*rod_e_arm_x
    rod_e_turning_x = hinge_e_speed*rod_d_R_x_z
    rod_e_turning_y = hinge_e_speed*rod_d_R_y_z
    rod_e_turning_z = hinge_e_speed*rod_d_R_z_z
    rod_e_rate_x = rod_d_rate_x + rod_e_turning_x
    rod_e_rate_y = rod_d_rate_y + rod_e_turning_y
    rod_e_rate_z = rod_d_rate_z + rod_e_turning_z
    rod_e_x = rod_d_x + rod_e_arm_x
    rod_e_y = rod_d_y + rod_e_arm_y
    rod_e_z = rod_d_z + rod_e_arm_z
    rod_e_velocity_x = rod_d_velocity_x + rod_e_arm_rate_x
    rod_e_velocity_y = rod_d_velocity_y + rod_e_arm_rate_y
    rod_e_velocity_z = rod_d_velocity_z + rod_e_arm_rate_z
    rod_e_R_x_x = cos_rod_e*rod_d_R_x_x + rod_c_R_x_y*sin_rod_e
    rod_e_R_x_y = cos_rod_e*rod_c_R_x_y - rod_d_R_x_x*sin_rod_e
    rod_e_R_y_x = cos_rod_e*rod_d_R_y_x + rod_c_R_y_y*sin_rod_e
    rod_e_R_y_y = cos_rod_e*rod_c_R_y_y - rod_d_R_y_x*sin_rod_e
    rod_e_R_z_x = cos_rod_e*rod_d_R_z_x + rod_c_R_z_y*sin_rod_e
    rod_e_R_z_y = cos_rod_e*rod_c_R_z_y - rod_d_R_z_x*sin_rod_e
    hinge_f_child_arm_x = rod_e_R_x_y*length
    hinge_f_child_arm_y = rod_e_R_y_y*length
    hinge_f_child_arm_z = rod_e_R_z_y*length
    hinge_f_child_arm_rate_x = hinge_f_child_arm_z*rod_e_rate_y - hinge_f_child_arm_y*rod_e_rate_z
    hinge_f_child_arm_rate_y = hinge_f_child_arm_x*rod_e_rate_z - hinge_f_child_arm_z*rod_e_rate_x
    hinge_f_child_arm_rate_z = hinge_f_child_arm_y*rod_e_rate_x - hinge_f_child_arm_x*rod_e_rate_y
    hinge_f_apart_x = hinge_f_child_arm_x + rod_e_x
    hinge_f_apart_y = hinge_f_child_arm_y + rod_e_y
    hinge_f_apart_z = hinge_f_child_arm_z + rod_e_z - length
    hinge_f_apart_rate_x = hinge_f_child_arm_rate_x + rod_e_velocity_x
    hinge_f_apart_rate_y = hinge_f_child_arm_rate_y + rod_e_velocity_y
    hinge_f_apart_rate_z = hinge_f_child_arm_rate_z + rod_e_velocity_z
    hinge_f_turned_y_rate = rod_e_R_x_x*rod_e_rate_z - rod_e_R_z_x*rod_e_rate_x
    hinge_f_turned_z_rate = rod_e_R_y_x*rod_e_rate_x - rod_e_R_x_x*rod_e_rate_y
    return (ca.vertcat(hinge_f_apart_x, hinge_f_apart_y, hinge_f_apart_z, rod_e_R_y_x, rod_e_R_z_x),
        ca.vertcat(hinge_f_apart_rate_x, hinge_f_apart_rate_y, hinge_f_apart_rate_z, hinge_f_turned_y_rate, hinge_f_turned_z_rate))


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (5,): SPEEDS
        independence (5,): CONSTRAINTS [1]
    """
    length, rod_e_h_y, rod_d_h_x, rod_c_h_z, rod_b_h_y, rod_b_I_x_x, rod_c_I_x_x = c[0], c[2], c[3], c[4], c[5], c[6], c[7]
    rod_d_I_z_z, rod_e_I_x_x, twice_length, rod_d_I_z_z_plus_rod_e_I_x_x, rod_a_I_y_y = c[8], c[9], c[11], c[12], c[13]
    inverse_rod_e_I_x_x, hinge_f_apart_x_softness, hinge_f_apart_y_softness, hinge_f_apart_z_softness = c[14], c[19], c[20], c[21]
    hinge_f_turned_y_softness, hinge_f_turned_z_softness = c[22], c[23]
    hinge_a_angle, hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[0], q[1], q[2], q[3], q[4]
    hinge_f_apart_x_wanted_rate, hinge_f_apart_y_wanted_rate, hinge_f_apart_z_wanted_rate = wanted[0], wanted[1], wanted[2]
    hinge_f_turned_y_wanted_rate, hinge_f_turned_z_wanted_rate = wanted[3], wanted[4]
    cos_rod_a = ca.cos(hinge_a_angle)
    sin_rod_a = ca.sin(hinge_a_angle)
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_b_arm_x = cos_rod_a*length
    rod_b_arm_z = -sin_rod_a*length
    rod_b_R_x_x = cos_rod_a*cos_rod_b
    rod_b_R_x_y = -cos_rod_a*sin_rod_b
    rod_b_R_z_x = -cos_rod_b*sin_rod_a
    rod_b_R_z_y = sin_rod_a*sin_rod_b
    rod_c_arm_x = -rod_b_R_x_y*length
    rod_c_arm_y = -cos_rod_b*length
    rod_c_arm_z = -rod_b_R_z_y*length
    rod_c_x = rod_b_arm_x + rod_c_arm_x
    rod_c_z = rod_b_arm_z + rod_c_arm_z
    rod_c_R_x_y = cos_rod_c*rod_b_R_x_y + sin_rod_a*sin_rod_c
    rod_c_R_x_z = cos_rod_c*sin_rod_a - rod_b_R_x_y*sin_rod_c
    rod_c_R_y_y = cos_rod_b*cos_rod_c
    rod_c_R_y_z = -cos_rod_b*sin_rod_c
    rod_c_R_z_y = cos_rod_a*sin_rod_c + cos_rod_c*rod_b_R_z_y
    rod_c_R_z_z = cos_rod_a*cos_rod_c - rod_b_R_z_y*sin_rod_c
    rod_d_arm_x = rod_c_R_x_z*length
    rod_d_arm_y = rod_c_R_y_z*length
    rod_d_arm_z = rod_c_R_z_z*length
    rod_d_x = rod_c_x + rod_d_arm_x
    rod_d_y = rod_c_arm_y + rod_d_arm_y
    rod_d_z = rod_c_z + rod_d_arm_z
    rod_d_R_x_x = cos_rod_d*rod_b_R_x_x - rod_c_R_x_z*sin_rod_d
    rod_d_R_x_z = cos_rod_d*rod_c_R_x_z + rod_b_R_x_x*sin_rod_d
    rod_d_R_y_x = cos_rod_d*sin_rod_b - rod_c_R_y_z*sin_rod_d
    rod_d_R_y_z = cos_rod_d*rod_c_R_y_z + sin_rod_b*sin_rod_d
    rod_d_R_z_x = cos_rod_d*rod_b_R_z_x - rod_c_R_z_z*sin_rod_d
    rod_d_R_z_z = cos_rod_d*rod_c_R_z_z + rod_b_R_z_x*sin_rod_d
    rod_e_arm_x = -rod_d_R_x_x*length
    rod_e_arm_y = -rod_d_R_y_x*length
    rod_e_arm_z = -rod_d_R_z_x*length
    rod_e_x = rod_d_x + rod_e_arm_x
    rod_e_y = rod_d_y + rod_e_arm_y
    rod_e_z = rod_d_z + rod_e_arm_z
    rod_e_R_x_x = cos_rod_e*rod_d_R_x_x + rod_c_R_x_y*sin_rod_e
    rod_e_R_x_y = cos_rod_e*rod_c_R_x_y - rod_d_R_x_x*sin_rod_e
    rod_e_R_y_x = cos_rod_e*rod_d_R_y_x + rod_c_R_y_y*sin_rod_e
    rod_e_R_y_y = cos_rod_e*rod_c_R_y_y - rod_d_R_y_x*sin_rod_e
    rod_e_R_z_x = cos_rod_e*rod_d_R_z_x + rod_c_R_z_y*sin_rod_e
    rod_e_R_z_y = cos_rod_e*rod_c_R_z_y - rod_d_R_z_x*sin_rod_e
    hinge_f_child_arm_x = rod_e_R_x_y*length
    hinge_f_child_arm_y = rod_e_R_y_y*length
    hinge_f_child_arm_z = rod_e_R_z_y*length
    hinge_f_apart_x = hinge_f_child_arm_x + rod_e_x
    hinge_f_x_on_hinge_a = hinge_f_child_arm_z + rod_e_z
    hinge_f_child_arm_y_plus_rod_e_y = hinge_f_child_arm_y + rod_e_y
    hinge_f_x_on_hinge_b = -cos_rod_a*hinge_f_child_arm_y_plus_rod_e_y
    hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z = hinge_f_child_arm_z + rod_e_z - rod_c_z
    x3 = hinge_f_child_arm_y + rod_e_y - rod_c_arm_y
    hinge_f_x_on_hinge_c = sin_rod_b*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z - rod_b_R_z_x*x3
    hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z = hinge_f_child_arm_z + rod_e_z - rod_d_z
    hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y = hinge_f_child_arm_y + rod_e_y - rod_d_y
    hinge_f_x_on_hinge_d = rod_c_R_y_y*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z - rod_c_R_z_y*hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y
    hinge_f_x_on_hinge_e = hinge_f_child_arm_z*rod_d_R_y_z - hinge_f_child_arm_y*rod_d_R_z_z
    hinge_f_y_on_hinge_b = cos_rod_a*(hinge_f_child_arm_x + rod_e_x - rod_b_arm_x) - sin_rod_a*(hinge_f_child_arm_z + rod_e_z - rod_b_arm_z)
    hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x = hinge_f_child_arm_x + rod_e_x - rod_c_x
    hinge_f_y_on_hinge_c = rod_b_R_z_x*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x - rod_b_R_x_x*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_c_z
    hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x = hinge_f_child_arm_x + rod_e_x - rod_d_x
    hinge_f_y_on_hinge_d = rod_c_R_z_y*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x - rod_c_R_x_y*hinge_f_child_arm_z_plus_rod_e_z_minus_rod_d_z
    hinge_f_y_on_hinge_e = hinge_f_child_arm_x*rod_d_R_z_z - hinge_f_child_arm_z*rod_d_R_x_z
    hinge_f_z_on_hinge_b = sin_rod_a*hinge_f_child_arm_y_plus_rod_e_y
    hinge_f_z_on_hinge_c = rod_b_R_x_x*x3 - sin_rod_b*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_c_x
    hinge_f_z_on_hinge_d = rod_c_R_x_y*hinge_f_child_arm_y_plus_rod_e_y_minus_rod_d_y - rod_c_R_y_y*hinge_f_child_arm_x_plus_rod_e_x_minus_rod_d_x
    hinge_f_z_on_hinge_e = hinge_f_child_arm_y*rod_d_R_x_z - hinge_f_child_arm_x*rod_d_R_y_z
    hinge_f_turned_y_on_hinge_b = cos_rod_a*rod_e_R_x_x - rod_e_R_z_x*sin_rod_a
    hinge_f_turned_y_on_hinge_c = rod_b_R_z_x*rod_e_R_x_x - rod_b_R_x_x*rod_e_R_z_x
    hinge_f_turned_y_on_hinge_d = rod_c_R_z_y*rod_e_R_x_x - rod_c_R_x_y*rod_e_R_z_x
    hinge_f_turned_y_on_hinge_e = rod_d_R_z_z*rod_e_R_x_x - rod_d_R_x_z*rod_e_R_z_x
    hinge_f_turned_z_on_hinge_b = rod_e_R_y_x*sin_rod_a
    hinge_f_turned_z_on_hinge_c = rod_b_R_x_x*rod_e_R_y_x - rod_e_R_x_x*sin_rod_b
    hinge_f_turned_z_on_hinge_d = rod_c_R_x_y*rod_e_R_y_x - rod_c_R_y_y*rod_e_R_x_x
    hinge_f_turned_z_on_hinge_e = rod_d_R_x_z*rod_e_R_y_x - rod_d_R_y_z*rod_e_R_x_x
    rod_e_turned_moment_x = -rod_e_h_y*sin_rod_e
    rod_d_total_moment_x = rod_d_h_x + rod_e_turned_moment_x
    rod_d_total_moment_y = cos_rod_e*rod_e_h_y
    rod_c_total_moment_x = cos_rod_d*rod_d_total_moment_x
    rod_d_turned_moment_z = -rod_d_total_moment_x*sin_rod_d
    rod_c_total_moment_z = rod_c_h_z + rod_d_turned_moment_z
    cos_rod_c_times_rod_d_total_moment_y = cos_rod_c*rod_d_total_moment_y
    minus_rod_c_total_moment_z_times_sin_rod_c = -rod_c_total_moment_z*sin_rod_c
    rod_b_total_moment_y = rod_b_h_y + cos_rod_c_times_rod_d_total_moment_y + minus_rod_c_total_moment_z_times_sin_rod_c
    rod_b_total_moment_z = cos_rod_c*rod_c_total_moment_z + rod_d_total_moment_y*sin_rod_c
    rod_c_turned_moment_y = cos_rod_c_times_rod_d_total_moment_y + minus_rod_c_total_moment_z_times_sin_rod_c
    cos_rod_b_times_rod_c_total_moment_x = cos_rod_b*rod_c_total_moment_x
    minus_rod_b_total_moment_y_times_sin_rod_b = -rod_b_total_moment_y*sin_rod_b
    x14 = cos_rod_b_times_rod_c_total_moment_x + minus_rod_b_total_moment_y_times_sin_rod_b
    rod_b_turned_moment_x = cos_rod_a*x14 + rod_b_total_moment_z*sin_rod_a
    rod_b_turned_moment_z = cos_rod_a*rod_b_total_moment_z - sin_rod_a*x14
    rod_e_turned_J_swing = -rod_e_I_x_x*sin_rod_e
    rod_e_turned_J_x_y = -cos_rod_e*rod_e_turned_J_swing
    rod_d_total_J_x_y = rod_e_turned_J_x_y + rod_d_total_moment_y*length
    rod_d_turned_J_x_y = cos_rod_d*rod_d_total_J_x_y
    rod_e_turned_J_x_x = rod_e_I_x_x + rod_e_turned_J_swing*sin_rod_e
    x15 = -twice_length*rod_e_turned_moment_x
    rod_d_total_J_z_z = rod_d_I_z_z_plus_rod_e_I_x_x + x15
    rod_d_turned_J_swing = sin_rod_d*(rod_e_turned_J_x_x - rod_d_total_J_z_z)
    rod_d_turned_J_x_z = -cos_rod_d*rod_d_turned_J_swing
    rod_c_total_J_x_z = rod_d_turned_J_x_z - rod_c_total_moment_x*length
    rod_c_turned_J_x_y = cos_rod_c*rod_d_turned_J_x_y - rod_c_total_J_x_z*sin_rod_c
    rod_b_total_J_x_y = rod_c_turned_J_x_y + rod_c_total_moment_x*length
    rod_e_turned_J_y_y = -rod_e_turned_J_swing*sin_rod_e
    rod_d_total_J_y_y = rod_d_I_z_z + rod_e_turned_J_y_y + x15
    x16 = twice_length*rod_d_turned_moment_z
    rod_c_total_J_y_y = rod_c_I_x_x + rod_d_total_J_y_y + x16
    rod_d_turned_J_y_z = -rod_d_total_J_x_y*sin_rod_d
    rod_c_total_J_y_z = rod_d_turned_J_y_z - rod_d_total_moment_y*length
    rod_d_turned_J_z_z = rod_d_total_J_z_z + rod_d_turned_J_swing*sin_rod_d
    rod_c_turned_J_swing = sin_rod_c*(rod_d_turned_J_z_z - rod_c_total_J_y_y) - 2*cos_rod_c*rod_c_total_J_y_z
    rod_c_turned_J_y_y = rod_c_total_J_y_y + rod_c_turned_J_swing*sin_rod_c
    rod_d_turned_J_x_x = rod_e_turned_J_x_x - rod_d_turned_J_swing*sin_rod_d
    rod_c_total_J_x_x = rod_c_I_x_x + rod_d_turned_J_x_x + x16
    x17 = -twice_length*rod_c_turned_moment_y
    rod_b_total_J_x_x = rod_b_I_x_x + rod_c_total_J_x_x + x17
    rod_b_turned_J_swing = sin_rod_b*(rod_c_turned_J_y_y - rod_b_total_J_x_x) - 2*cos_rod_b*rod_b_total_J_x_y
    rod_c_turned_J_x_z = cos_rod_c*rod_c_total_J_x_z + rod_d_turned_J_x_y*sin_rod_c
    rod_c_turned_J_y_z = -rod_c_total_J_y_z - cos_rod_c*rod_c_turned_J_swing
    rod_b_total_J_y_z = rod_c_turned_J_y_z + rod_b_total_moment_z*length
    rod_b_turned_J_y_y = rod_c_turned_J_y_y - rod_b_turned_J_swing*sin_rod_b
    rod_a_total_J_y_y = rod_a_I_y_y + rod_b_turned_J_y_y + 2*rod_b_arm_x*rod_b_turned_moment_x + 2*rod_b_arm_z*rod_b_turned_moment_z
    rod_c_turned_J_z_z = rod_d_turned_J_z_z - rod_c_turned_J_swing*sin_rod_c
    rod_b_total_J_z_z = rod_b_I_x_x + rod_c_turned_J_z_z + x17
    minus_cos_rod_b_times_rod_b_total_moment_y = -cos_rod_b*rod_b_total_moment_y
    minus_rod_c_total_moment_x_times_sin_rod_b = -rod_c_total_moment_x*sin_rod_b
    x20 = minus_cos_rod_b_times_rod_b_total_moment_y + minus_rod_c_total_moment_x_times_sin_rod_b
    hinge_b_rod_b_force_x = cos_rod_a*x20
    hinge_b_rod_b_force_z = -sin_rod_a*x20
    hinge_b_rod_b_torque_y = cos_rod_b*rod_b_total_J_y_z + hinge_b_rod_b_force_x*rod_b_arm_z + rod_c_turned_J_x_z*sin_rod_b - hinge_b_rod_b_force_z*rod_b_arm_x
    hinge_c_rod_c_torque_x = rod_c_total_J_x_x - rod_c_turned_moment_y*length
    hinge_c_rod_b_force_x = rod_c_turned_moment_y*sin_rod_a + cos_rod_a*rod_b_total_moment_z*sin_rod_b
    hinge_c_rod_b_force_z = cos_rod_a*rod_c_turned_moment_y - rod_b_total_moment_z*sin_rod_a*sin_rod_b
    hinge_c_rod_b_torque_y = cos_rod_b*rod_c_turned_J_x_y + hinge_c_rod_b_force_x*rod_b_arm_z + hinge_c_rod_c_torque_x*sin_rod_b - hinge_c_rod_b_force_z*rod_b_arm_x
    rod_d_turned_moment_z_times_length = rod_d_turned_moment_z*length
    hinge_d_rod_d_torque_y = rod_d_total_J_y_y + rod_d_turned_moment_z_times_length
    hinge_d_rod_c_force_y = rod_c_total_moment_x*sin_rod_c
    hinge_d_rod_c_force_z = -cos_rod_c*rod_c_total_moment_x
    hinge_d_rod_c_torque_x = rod_d_turned_J_x_y - hinge_d_rod_c_force_z*length
    hinge_d_rod_c_torque_y = cos_rod_c*hinge_d_rod_d_torque_y - rod_d_turned_J_y_z*sin_rod_c
    hinge_d_rod_c_torque_z = rod_d_turned_moment_z_times_length + cos_rod_c*rod_d_turned_J_y_z + hinge_d_rod_d_torque_y*sin_rod_c
    cos_rod_b_times_rod_d_turned_moment_z = cos_rod_b*rod_d_turned_moment_z
    minus_hinge_d_rod_c_force_y_times_sin_rod_b = -hinge_d_rod_c_force_y*sin_rod_b
    x24 = cos_rod_b_times_rod_d_turned_moment_z + minus_hinge_d_rod_c_force_y_times_sin_rod_b
    hinge_d_rod_b_force_x = cos_rod_a*x24 + hinge_d_rod_c_force_z*sin_rod_a
    hinge_d_rod_b_force_z = cos_rod_a*hinge_d_rod_c_force_z - sin_rod_a*x24
    hinge_d_rod_b_torque_y = cos_rod_b*hinge_d_rod_c_torque_y + hinge_d_rod_b_force_x*rod_b_arm_z + hinge_d_rod_c_torque_x*sin_rod_b - hinge_d_rod_b_force_z*rod_b_arm_x
    minus_rod_e_turned_moment_x_times_length = -rod_e_turned_moment_x*length
    hinge_e_rod_e_torque_z = rod_e_I_x_x + minus_rod_e_turned_moment_x_times_length
    hinge_e_rod_d_force_x = -cos_rod_d*rod_d_total_moment_y
    hinge_e_rod_d_force_z = rod_d_total_moment_y*sin_rod_d
    hinge_e_rod_d_torque_x = minus_rod_e_turned_moment_x_times_length + hinge_e_rod_e_torque_z*sin_rod_d
    hinge_e_rod_d_torque_y = hinge_e_rod_d_force_x*length
    hinge_e_rod_d_torque_z = cos_rod_d*hinge_e_rod_e_torque_z
    hinge_e_rod_c_force_y = cos_rod_c*rod_e_turned_moment_x - hinge_e_rod_d_force_z*sin_rod_c
    hinge_e_rod_c_force_z = cos_rod_c*hinge_e_rod_d_force_z + sin_rod_c*rod_e_turned_moment_x
    hinge_e_rod_c_torque_x = hinge_e_rod_d_torque_x - hinge_e_rod_c_force_z*length
    hinge_e_rod_c_torque_y = cos_rod_c*hinge_e_rod_d_torque_y - hinge_e_rod_d_torque_z*sin_rod_c
    hinge_e_rod_c_torque_z = hinge_e_rod_d_torque_y + cos_rod_c*hinge_e_rod_d_torque_z + hinge_e_rod_d_torque_y*sin_rod_c
    cos_rod_b_times_hinge_e_rod_d_force_x = cos_rod_b*hinge_e_rod_d_force_x
    minus_hinge_e_rod_c_force_y_times_sin_rod_b = -hinge_e_rod_c_force_y*sin_rod_b
    x28 = cos_rod_b_times_hinge_e_rod_d_force_x + minus_hinge_e_rod_c_force_y_times_sin_rod_b
    hinge_e_rod_b_force_x = cos_rod_a*x28 + hinge_e_rod_c_force_z*sin_rod_a
    hinge_e_rod_b_force_z = cos_rod_a*hinge_e_rod_c_force_z - sin_rod_a*x28
    hinge_e_rod_b_torque_y = cos_rod_b*hinge_e_rod_c_torque_y + hinge_e_rod_b_force_x*rod_b_arm_z + hinge_e_rod_c_torque_x*sin_rod_b - hinge_e_rod_b_force_z*rod_b_arm_x
    l_hinge_c_hinge_e = hinge_e_rod_d_torque_x*inverse_rod_e_I_x_x
    l_hinge_c_hinge_d = rod_d_turned_J_x_y/rod_d_total_J_y_y
    D_hinge_c = rod_c_total_J_x_x - hinge_e_rod_d_torque_x*l_hinge_c_hinge_e - l_hinge_c_hinge_d*rod_d_turned_J_x_y
    l_hinge_b_hinge_e = hinge_e_rod_c_torque_z*inverse_rod_e_I_x_x
    l_hinge_b_hinge_d = hinge_d_rod_c_torque_z/rod_d_total_J_y_y
    L_hinge_b_hinge_c = rod_c_turned_J_x_z - hinge_d_rod_c_torque_z*l_hinge_c_hinge_d - hinge_e_rod_c_torque_z*l_hinge_c_hinge_e
    l_hinge_b_hinge_c = L_hinge_b_hinge_c/D_hinge_c
    D_hinge_b = rod_b_total_J_z_z - L_hinge_b_hinge_c*l_hinge_b_hinge_c - hinge_d_rod_c_torque_z*l_hinge_b_hinge_d - hinge_e_rod_c_torque_z*l_hinge_b_hinge_e
    l_hinge_a_hinge_e = hinge_e_rod_b_torque_y*inverse_rod_e_I_x_x
    l_hinge_a_hinge_d = hinge_d_rod_b_torque_y/rod_d_total_J_y_y
    L_hinge_a_hinge_c = hinge_c_rod_b_torque_y - hinge_d_rod_b_torque_y*l_hinge_c_hinge_d - hinge_e_rod_b_torque_y*l_hinge_c_hinge_e
    l_hinge_a_hinge_c = L_hinge_a_hinge_c/D_hinge_c
    L_hinge_a_hinge_b = hinge_b_rod_b_torque_y - L_hinge_a_hinge_c*l_hinge_b_hinge_c - hinge_d_rod_b_torque_y*l_hinge_b_hinge_d - hinge_e_rod_b_torque_y*l_hinge_b_hinge_e
    l_hinge_a_hinge_b = L_hinge_a_hinge_b/D_hinge_b
    D_hinge_a = rod_a_total_J_y_y - L_hinge_a_hinge_b*l_hinge_a_hinge_b - L_hinge_a_hinge_c*l_hinge_a_hinge_c - hinge_d_rod_b_torque_y*l_hinge_a_hinge_d - hinge_e_rod_b_torque_y*l_hinge_a_hinge_e
    y_hinge_c_2 = hinge_f_x_on_hinge_c - hinge_f_x_on_hinge_d*l_hinge_c_hinge_d - hinge_f_x_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_2 = hinge_f_x_on_hinge_b - hinge_f_x_on_hinge_d*l_hinge_b_hinge_d - hinge_f_x_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_2
    y_hinge_a_2 = hinge_f_x_on_hinge_a - hinge_f_x_on_hinge_d*l_hinge_a_hinge_d - hinge_f_x_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_2 - l_hinge_a_hinge_c*y_hinge_c_2
    hinge_a_by_hinge_f_apart_x = y_hinge_a_2/D_hinge_a
    hinge_b_by_hinge_f_apart_x = y_hinge_b_2/D_hinge_b - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_x = y_hinge_c_2/D_hinge_c - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_x = hinge_f_x_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_x*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_x = hinge_f_x_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_x*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_x*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_x*l_hinge_c_hinge_e
    y_hinge_c_3 = hinge_f_y_on_hinge_c - hinge_f_y_on_hinge_d*l_hinge_c_hinge_d - hinge_f_y_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_3 = hinge_f_y_on_hinge_b - hinge_f_y_on_hinge_d*l_hinge_b_hinge_d - hinge_f_y_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_3
    y_hinge_a_3 = -hinge_f_y_on_hinge_d*l_hinge_a_hinge_d - hinge_f_y_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_3 - l_hinge_a_hinge_c*y_hinge_c_3
    hinge_a_by_hinge_f_apart_y = y_hinge_a_3/D_hinge_a
    hinge_b_by_hinge_f_apart_y = y_hinge_b_3/D_hinge_b - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_y = y_hinge_c_3/D_hinge_c - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_y = hinge_f_y_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_y*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_y = hinge_f_y_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_y*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_y*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_y*l_hinge_c_hinge_e
    y_hinge_c_4 = hinge_f_z_on_hinge_c - hinge_f_z_on_hinge_d*l_hinge_c_hinge_d - hinge_f_z_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_4 = hinge_f_z_on_hinge_b - hinge_f_z_on_hinge_d*l_hinge_b_hinge_d - hinge_f_z_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_4
    y_hinge_a_4 = -hinge_f_apart_x - hinge_f_z_on_hinge_d*l_hinge_a_hinge_d - hinge_f_z_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_4 - l_hinge_a_hinge_c*y_hinge_c_4
    hinge_a_by_hinge_f_apart_z = y_hinge_a_4/D_hinge_a
    hinge_b_by_hinge_f_apart_z = y_hinge_b_4/D_hinge_b - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_apart_z = y_hinge_c_4/D_hinge_c - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_c - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_apart_z = hinge_f_z_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_d - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_d - hinge_c_by_hinge_f_apart_z*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_apart_z = hinge_f_z_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_apart_z*l_hinge_a_hinge_e - hinge_b_by_hinge_f_apart_z*l_hinge_b_hinge_e - hinge_c_by_hinge_f_apart_z*l_hinge_c_hinge_e
    y_hinge_c_5 = hinge_f_turned_y_on_hinge_c - hinge_f_turned_y_on_hinge_d*l_hinge_c_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_5 = hinge_f_turned_y_on_hinge_b - hinge_f_turned_y_on_hinge_d*l_hinge_b_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_5
    y_hinge_a_5 = -hinge_f_turned_y_on_hinge_d*l_hinge_a_hinge_d - hinge_f_turned_y_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_5 - l_hinge_a_hinge_c*y_hinge_c_5
    hinge_a_by_hinge_f_turned_y = y_hinge_a_5/D_hinge_a
    hinge_b_by_hinge_f_turned_y = y_hinge_b_5/D_hinge_b - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_turned_y = y_hinge_c_5/D_hinge_c - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_c - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_turned_y = hinge_f_turned_y_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_d - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_d - hinge_c_by_hinge_f_turned_y*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_turned_y = hinge_f_turned_y_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_turned_y*l_hinge_a_hinge_e - hinge_b_by_hinge_f_turned_y*l_hinge_b_hinge_e - hinge_c_by_hinge_f_turned_y*l_hinge_c_hinge_e
    y_hinge_c_6 = hinge_f_turned_z_on_hinge_c - hinge_f_turned_z_on_hinge_d*l_hinge_c_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_c_hinge_e
    y_hinge_b_6 = hinge_f_turned_z_on_hinge_b - hinge_f_turned_z_on_hinge_d*l_hinge_b_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_b_hinge_e - l_hinge_b_hinge_c*y_hinge_c_6
    y_hinge_a_6 = -rod_e_R_x_x - hinge_f_turned_z_on_hinge_d*l_hinge_a_hinge_d - hinge_f_turned_z_on_hinge_e*l_hinge_a_hinge_e - l_hinge_a_hinge_b*y_hinge_b_6 - l_hinge_a_hinge_c*y_hinge_c_6
    hinge_a_by_hinge_f_turned_z = y_hinge_a_6/D_hinge_a
    hinge_b_by_hinge_f_turned_z = y_hinge_b_6/D_hinge_b - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_b
    hinge_c_by_hinge_f_turned_z = y_hinge_c_6/D_hinge_c - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_c - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_c
    hinge_d_by_hinge_f_turned_z = hinge_f_turned_z_on_hinge_d/rod_d_total_J_y_y - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_d - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_d - hinge_c_by_hinge_f_turned_z*l_hinge_c_hinge_d
    hinge_e_by_hinge_f_turned_z = hinge_f_turned_z_on_hinge_e*inverse_rod_e_I_x_x - hinge_a_by_hinge_f_turned_z*l_hinge_a_hinge_e - hinge_b_by_hinge_f_turned_z*l_hinge_b_hinge_e - hinge_c_by_hinge_f_turned_z*l_hinge_c_hinge_e
    W_hinge_f_apart_x_hinge_f_apart_x = hinge_a_by_hinge_f_apart_x*hinge_f_x_on_hinge_a + hinge_b_by_hinge_f_apart_x*hinge_f_x_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_x_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_x_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_x_on_hinge_e
    W_hinge_f_apart_y_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_y_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_y_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_y_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_y_on_hinge_e
    W_hinge_f_apart_y_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_y_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_y_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_y_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_y_on_hinge_e
    W_hinge_f_apart_z_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_x*hinge_f_apart_x
    W_hinge_f_apart_z_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_y*hinge_f_apart_x
    W_hinge_f_apart_z_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_z_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_z_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_z_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_z_on_hinge_e - hinge_a_by_hinge_f_apart_z*hinge_f_apart_x
    W_hinge_f_turned_y_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_y_hinge_f_turned_y = hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_b + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_c + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_d + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_on_hinge_e
    W_hinge_f_turned_z_hinge_f_apart_x = hinge_b_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_x*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_x*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_apart_y = hinge_b_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_y*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_y*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_apart_z = hinge_b_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_apart_z*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_apart_z*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_turned_y = hinge_b_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_turned_y*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_turned_y*rod_e_R_x_x
    W_hinge_f_turned_z_hinge_f_turned_z = hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_b + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_c + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_d + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_on_hinge_e - hinge_a_by_hinge_f_turned_z*rod_e_R_x_x
    hinge_f_apart_size = W_hinge_f_apart_x_hinge_f_apart_x + W_hinge_f_apart_y_hinge_f_apart_y + W_hinge_f_apart_z_hinge_f_apart_z
    W_hinge_f_apart_x_raised = W_hinge_f_apart_x_hinge_f_apart_x + hinge_f_apart_size*hinge_f_apart_x_softness
    W_hinge_f_apart_y_raised = W_hinge_f_apart_y_hinge_f_apart_y + hinge_f_apart_size*hinge_f_apart_y_softness
    W_hinge_f_apart_z_raised = W_hinge_f_apart_z_hinge_f_apart_z + hinge_f_apart_size*hinge_f_apart_z_softness
    hinge_f_turned_size = W_hinge_f_turned_y_hinge_f_turned_y + W_hinge_f_turned_z_hinge_f_turned_z
    W_hinge_f_turned_y_raised = W_hinge_f_turned_y_hinge_f_turned_y + hinge_f_turned_size*hinge_f_turned_y_softness
    W_hinge_f_turned_z_raised = W_hinge_f_turned_z_hinge_f_turned_z + hinge_f_turned_size*hinge_f_turned_z_softness
    l_hinge_f_apart_y_hinge_f_apart_x = W_hinge_f_apart_y_hinge_f_apart_x/W_hinge_f_apart_x_raised
    D_hinge_f_apart_y = W_hinge_f_apart_y_raised - W_hinge_f_apart_y_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_apart_z_hinge_f_apart_x = W_hinge_f_apart_z_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_apart_z_hinge_f_apart_y = W_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_apart_z_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_apart_z_hinge_f_apart_y = L_hinge_f_apart_z_hinge_f_apart_y/D_hinge_f_apart_y
    D_hinge_f_apart_z = W_hinge_f_apart_z_raised - L_hinge_f_apart_z_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_apart_z_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_x = W_hinge_f_turned_y_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_turned_y_hinge_f_apart_y = W_hinge_f_turned_y_hinge_f_apart_y - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_y = L_hinge_f_turned_y_hinge_f_apart_y/D_hinge_f_apart_y
    L_hinge_f_turned_y_hinge_f_apart_z = W_hinge_f_turned_y_hinge_f_apart_z - L_hinge_f_turned_y_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_y_hinge_f_apart_z = L_hinge_f_turned_y_hinge_f_apart_z/D_hinge_f_apart_z
    D_hinge_f_turned_y = W_hinge_f_turned_y_raised - L_hinge_f_turned_y_hinge_f_apart_y*l_hinge_f_turned_y_hinge_f_apart_y - L_hinge_f_turned_y_hinge_f_apart_z*l_hinge_f_turned_y_hinge_f_apart_z - W_hinge_f_turned_y_hinge_f_apart_x*l_hinge_f_turned_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_x = W_hinge_f_turned_z_hinge_f_apart_x/W_hinge_f_apart_x_raised
    L_hinge_f_turned_z_hinge_f_apart_y = W_hinge_f_turned_z_hinge_f_apart_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_apart_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_y = L_hinge_f_turned_z_hinge_f_apart_y/D_hinge_f_apart_y
    L_hinge_f_turned_z_hinge_f_apart_z = W_hinge_f_turned_z_hinge_f_apart_z - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_apart_z_hinge_f_apart_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_apart_z_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_apart_z = L_hinge_f_turned_z_hinge_f_apart_z/D_hinge_f_apart_z
    L_hinge_f_turned_z_hinge_f_turned_y = W_hinge_f_turned_z_hinge_f_turned_y - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_turned_y_hinge_f_apart_y - L_hinge_f_turned_z_hinge_f_apart_z*l_hinge_f_turned_y_hinge_f_apart_z - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_turned_y_hinge_f_apart_x
    l_hinge_f_turned_z_hinge_f_turned_y = L_hinge_f_turned_z_hinge_f_turned_y/D_hinge_f_turned_y
    D_hinge_f_turned_z = W_hinge_f_turned_z_raised - L_hinge_f_turned_z_hinge_f_apart_y*l_hinge_f_turned_z_hinge_f_apart_y - L_hinge_f_turned_z_hinge_f_apart_z*l_hinge_f_turned_z_hinge_f_apart_z - L_hinge_f_turned_z_hinge_f_turned_y*l_hinge_f_turned_z_hinge_f_turned_y - W_hinge_f_turned_z_hinge_f_apart_x*l_hinge_f_turned_z_hinge_f_apart_x
    y_hinge_f_apart_y_4 = hinge_f_apart_y_wanted_rate - hinge_f_apart_x_wanted_rate*l_hinge_f_apart_y_hinge_f_apart_x
    y_hinge_f_apart_z_4 = hinge_f_apart_z_wanted_rate - hinge_f_apart_x_wanted_rate*l_hinge_f_apart_z_hinge_f_apart_x - l_hinge_f_apart_z_hinge_f_apart_y*y_hinge_f_apart_y_4
    y_hinge_f_turned_y_4 = hinge_f_turned_y_wanted_rate - hinge_f_apart_x_wanted_rate*l_hinge_f_turned_y_hinge_f_apart_x - l_hinge_f_turned_y_hinge_f_apart_y*y_hinge_f_apart_y_4 - l_hinge_f_turned_y_hinge_f_apart_z*y_hinge_f_apart_z_4
    y_hinge_f_turned_z_4 = hinge_f_turned_z_wanted_rate - hinge_f_apart_x_wanted_rate*l_hinge_f_turned_z_hinge_f_apart_x - l_hinge_f_turned_z_hinge_f_apart_y*y_hinge_f_apart_y_4 - l_hinge_f_turned_z_hinge_f_apart_z*y_hinge_f_apart_z_4 - l_hinge_f_turned_z_hinge_f_turned_y*y_hinge_f_turned_y_4
    hinge_f_turned_z_push = y_hinge_f_turned_z_4/D_hinge_f_turned_z
    hinge_f_turned_y_push = y_hinge_f_turned_y_4/D_hinge_f_turned_y - hinge_f_turned_z_push*l_hinge_f_turned_z_hinge_f_turned_y
    hinge_f_apart_z_push = y_hinge_f_apart_z_4/D_hinge_f_apart_z - hinge_f_turned_y_push*l_hinge_f_turned_y_hinge_f_apart_z - hinge_f_turned_z_push*l_hinge_f_turned_z_hinge_f_apart_z
    hinge_f_apart_y_push = y_hinge_f_apart_y_4/D_hinge_f_apart_y - hinge_f_apart_z_push*l_hinge_f_apart_z_hinge_f_apart_y - hinge_f_turned_y_push*l_hinge_f_turned_y_hinge_f_apart_y - hinge_f_turned_z_push*l_hinge_f_turned_z_hinge_f_apart_y
    hinge_f_apart_x_push = hinge_f_apart_x_wanted_rate/W_hinge_f_apart_x_raised - hinge_f_apart_y_push*l_hinge_f_apart_y_hinge_f_apart_x - hinge_f_apart_z_push*l_hinge_f_apart_z_hinge_f_apart_x - hinge_f_turned_y_push*l_hinge_f_turned_y_hinge_f_apart_x - hinge_f_turned_z_push*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_e_push = hinge_e_by_hinge_f_apart_x*hinge_f_apart_x_push + hinge_e_by_hinge_f_apart_y*hinge_f_apart_y_push + hinge_e_by_hinge_f_apart_z*hinge_f_apart_z_push + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_push + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_push
    hinge_d_push = hinge_d_by_hinge_f_apart_x*hinge_f_apart_x_push + hinge_d_by_hinge_f_apart_y*hinge_f_apart_y_push + hinge_d_by_hinge_f_apart_z*hinge_f_apart_z_push + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_push + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_push
    hinge_c_push = hinge_c_by_hinge_f_apart_x*hinge_f_apart_x_push + hinge_c_by_hinge_f_apart_y*hinge_f_apart_y_push + hinge_c_by_hinge_f_apart_z*hinge_f_apart_z_push + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_push + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_push
    hinge_b_push = hinge_b_by_hinge_f_apart_x*hinge_f_apart_x_push + hinge_b_by_hinge_f_apart_y*hinge_f_apart_y_push + hinge_b_by_hinge_f_apart_z*hinge_f_apart_z_push + hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_push + hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_push
    hinge_a_push = hinge_a_by_hinge_f_apart_x*hinge_f_apart_x_push + hinge_a_by_hinge_f_apart_y*hinge_f_apart_y_push + hinge_a_by_hinge_f_apart_z*hinge_f_apart_z_push + hinge_a_by_hinge_f_turned_y*hinge_f_turned_y_push + hinge_a_by_hinge_f_turned_z*hinge_f_turned_z_push
    hinge_f_apart_x_left_4 = hinge_f_apart_x_wanted_rate - hinge_a_push*hinge_f_x_on_hinge_a - hinge_b_push*hinge_f_x_on_hinge_b - hinge_c_push*hinge_f_x_on_hinge_c - hinge_d_push*hinge_f_x_on_hinge_d - hinge_e_push*hinge_f_x_on_hinge_e
    hinge_f_apart_y_left_4 = hinge_f_apart_y_wanted_rate - hinge_b_push*hinge_f_y_on_hinge_b - hinge_c_push*hinge_f_y_on_hinge_c - hinge_d_push*hinge_f_y_on_hinge_d - hinge_e_push*hinge_f_y_on_hinge_e
    hinge_f_apart_z_left_4 = hinge_f_apart_z_wanted_rate + hinge_a_push*hinge_f_apart_x - hinge_b_push*hinge_f_z_on_hinge_b - hinge_c_push*hinge_f_z_on_hinge_c - hinge_d_push*hinge_f_z_on_hinge_d - hinge_e_push*hinge_f_z_on_hinge_e
    hinge_f_turned_y_left_4 = hinge_f_turned_y_wanted_rate - hinge_b_push*hinge_f_turned_y_on_hinge_b - hinge_c_push*hinge_f_turned_y_on_hinge_c - hinge_d_push*hinge_f_turned_y_on_hinge_d - hinge_e_push*hinge_f_turned_y_on_hinge_e
    hinge_f_turned_z_left_4 = hinge_f_turned_z_wanted_rate + hinge_a_push*rod_e_R_x_x - hinge_b_push*hinge_f_turned_z_on_hinge_b - hinge_c_push*hinge_f_turned_z_on_hinge_c - hinge_d_push*hinge_f_turned_z_on_hinge_d - hinge_e_push*hinge_f_turned_z_on_hinge_e
    y_hinge_f_apart_y_5 = hinge_f_apart_y_left_4 - hinge_f_apart_x_left_4*l_hinge_f_apart_y_hinge_f_apart_x
    y_hinge_f_apart_z_5 = hinge_f_apart_z_left_4 - hinge_f_apart_x_left_4*l_hinge_f_apart_z_hinge_f_apart_x - l_hinge_f_apart_z_hinge_f_apart_y*y_hinge_f_apart_y_5
    y_hinge_f_turned_y_5 = hinge_f_turned_y_left_4 - hinge_f_apart_x_left_4*l_hinge_f_turned_y_hinge_f_apart_x - l_hinge_f_turned_y_hinge_f_apart_y*y_hinge_f_apart_y_5 - l_hinge_f_turned_y_hinge_f_apart_z*y_hinge_f_apart_z_5
    y_hinge_f_turned_z_5 = hinge_f_turned_z_left_4 - hinge_f_apart_x_left_4*l_hinge_f_turned_z_hinge_f_apart_x - l_hinge_f_turned_z_hinge_f_apart_y*y_hinge_f_apart_y_5 - l_hinge_f_turned_z_hinge_f_apart_z*y_hinge_f_apart_z_5 - l_hinge_f_turned_z_hinge_f_turned_y*y_hinge_f_turned_y_5
    hinge_f_turned_z_push_2 = y_hinge_f_turned_z_5/D_hinge_f_turned_z
    hinge_f_turned_y_push_2 = y_hinge_f_turned_y_5/D_hinge_f_turned_y - hinge_f_turned_z_push_2*l_hinge_f_turned_z_hinge_f_turned_y
    hinge_f_apart_z_push_2 = y_hinge_f_apart_z_5/D_hinge_f_apart_z - hinge_f_turned_y_push_2*l_hinge_f_turned_y_hinge_f_apart_z - hinge_f_turned_z_push_2*l_hinge_f_turned_z_hinge_f_apart_z
    hinge_f_apart_y_push_2 = y_hinge_f_apart_y_5/D_hinge_f_apart_y - hinge_f_apart_z_push_2*l_hinge_f_apart_z_hinge_f_apart_y - hinge_f_turned_y_push_2*l_hinge_f_turned_y_hinge_f_apart_y - hinge_f_turned_z_push_2*l_hinge_f_turned_z_hinge_f_apart_y
    hinge_f_apart_x_push_2 = hinge_f_apart_x_left_4/W_hinge_f_apart_x_raised - hinge_f_apart_y_push_2*l_hinge_f_apart_y_hinge_f_apart_x - hinge_f_apart_z_push_2*l_hinge_f_apart_z_hinge_f_apart_x - hinge_f_turned_y_push_2*l_hinge_f_turned_y_hinge_f_apart_x - hinge_f_turned_z_push_2*l_hinge_f_turned_z_hinge_f_apart_x
    hinge_e_push_2 = hinge_e_push + hinge_e_by_hinge_f_apart_x*hinge_f_apart_x_push_2 + hinge_e_by_hinge_f_apart_y*hinge_f_apart_y_push_2 + hinge_e_by_hinge_f_apart_z*hinge_f_apart_z_push_2 + hinge_e_by_hinge_f_turned_y*hinge_f_turned_y_push_2 + hinge_e_by_hinge_f_turned_z*hinge_f_turned_z_push_2
    hinge_d_push_2 = hinge_d_push + hinge_d_by_hinge_f_apart_x*hinge_f_apart_x_push_2 + hinge_d_by_hinge_f_apart_y*hinge_f_apart_y_push_2 + hinge_d_by_hinge_f_apart_z*hinge_f_apart_z_push_2 + hinge_d_by_hinge_f_turned_y*hinge_f_turned_y_push_2 + hinge_d_by_hinge_f_turned_z*hinge_f_turned_z_push_2
    hinge_c_push_2 = hinge_c_push + hinge_c_by_hinge_f_apart_x*hinge_f_apart_x_push_2 + hinge_c_by_hinge_f_apart_y*hinge_f_apart_y_push_2 + hinge_c_by_hinge_f_apart_z*hinge_f_apart_z_push_2 + hinge_c_by_hinge_f_turned_y*hinge_f_turned_y_push_2 + hinge_c_by_hinge_f_turned_z*hinge_f_turned_z_push_2
    hinge_b_push_2 = hinge_b_push + hinge_b_by_hinge_f_apart_x*hinge_f_apart_x_push_2 + hinge_b_by_hinge_f_apart_y*hinge_f_apart_y_push_2 + hinge_b_by_hinge_f_apart_z*hinge_f_apart_z_push_2 + hinge_b_by_hinge_f_turned_y*hinge_f_turned_y_push_2 + hinge_b_by_hinge_f_turned_z*hinge_f_turned_z_push_2
    hinge_a_push_2 = hinge_a_push + hinge_a_by_hinge_f_apart_x*hinge_f_apart_x_push_2 + hinge_a_by_hinge_f_apart_y*hinge_f_apart_y_push_2 + hinge_a_by_hinge_f_apart_z*hinge_f_apart_z_push_2 + hinge_a_by_hinge_f_turned_y*hinge_f_turned_y_push_2 + hinge_a_by_hinge_f_turned_z*hinge_f_turned_z_push_2
    hinge_f_apart_x_independence = W_hinge_f_apart_x_raised/hinge_f_apart_size
    hinge_f_apart_y_independence = D_hinge_f_apart_y/hinge_f_apart_size
    hinge_f_apart_z_independence = D_hinge_f_apart_z/hinge_f_apart_size
    hinge_f_turned_y_independence = D_hinge_f_turned_y/hinge_f_turned_size
    hinge_f_turned_z_independence = D_hinge_f_turned_z/hinge_f_turned_size
    return (ca.vertcat(hinge_a_push_2, hinge_b_push_2, hinge_c_push_2, hinge_d_push_2, hinge_e_push_2),
        ca.vertcat(hinge_f_apart_x_independence, hinge_f_apart_y_independence, hinge_f_apart_z_independence, hinge_f_turned_y_independence,
            hinge_f_turned_z_independence))


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
    length, rod_e_h_y, half_rod_e_I_x_x, half_mass, half_length, gravity_times_mass = c[0], c[2], c[15], c[16], c[17], c[18]
    hinge_a_angle, hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[0], q[1], q[2], q[3], q[4]
    hinge_a_speed, hinge_b_speed, hinge_c_speed, hinge_d_speed, hinge_e_speed = u[0], u[1], u[2], u[3], u[4]
    cos_rod_a = ca.cos(hinge_a_angle)
    sin_rod_a = ca.sin(hinge_a_angle)
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_b_arm_x = cos_rod_a*length
    rod_b_arm_z = -sin_rod_a*length
    rod_c_arm_y = -cos_rod_b*length
    rod_c_R_y_y = cos_rod_b*cos_rod_c
    rod_c_R_y_z = -cos_rod_b*sin_rod_c
    rod_d_arm_y = rod_c_R_y_z*length
    rod_d_y = rod_c_arm_y + rod_d_arm_y
    rod_d_R_y_x = cos_rod_d*sin_rod_b - rod_c_R_y_z*sin_rod_d
    rod_e_arm_y = -rod_d_R_y_x*length
    rod_e_y = rod_d_y + rod_e_arm_y
    rod_e_R_y_y = cos_rod_e*rod_c_R_y_y - rod_d_R_y_x*sin_rod_e
    rod_b_w_x = hinge_a_speed*sin_rod_b
    rod_b_w_y = cos_rod_b*hinge_a_speed
    rod_c_w_y = cos_rod_c*rod_b_w_y + hinge_b_speed*sin_rod_c
    rod_c_w_z = cos_rod_c*hinge_b_speed - rod_b_w_y*sin_rod_c
    rod_c_rate_x_2 = hinge_c_speed + rod_b_w_x
    rod_d_w_x = cos_rod_d*rod_c_rate_x_2 - rod_c_w_z*sin_rod_d
    rod_d_w_z = cos_rod_d*rod_c_w_z + rod_c_rate_x_2*sin_rod_d
    rod_d_rate_y_2 = hinge_d_speed + rod_c_w_y
    rod_e_w_x = cos_rod_e*rod_d_w_x + rod_d_rate_y_2*sin_rod_e
    rod_e_rate_z_2 = hinge_e_speed + rod_d_w_z
    cos_rod_a_times_hinge_a_speed_times_rod_b_arm_z = cos_rod_a*hinge_a_speed*rod_b_arm_z
    hinge_a_speed_times_rod_b_arm_x_times_sin_rod_a = hinge_a_speed*rod_b_arm_x*sin_rod_a
    x3 = cos_rod_a_times_hinge_a_speed_times_rod_b_arm_z + hinge_a_speed_times_rod_b_arm_x_times_sin_rod_a
    rod_b_velocity_x = cos_rod_b*x3
    rod_b_velocity_y = -sin_rod_b*x3
    rod_b_velocity_z = hinge_a_speed*rod_b_arm_z*sin_rod_a - cos_rod_a*hinge_a_speed*rod_b_arm_x
    rod_c_velocity_x_2 = rod_b_velocity_x + hinge_b_speed*length
    minus_rod_b_w_x_times_length = -rod_b_w_x*length
    x5 = rod_b_velocity_z + minus_rod_b_w_x_times_length
    rod_c_velocity_y = cos_rod_c*rod_b_velocity_y + sin_rod_c*x5
    rod_c_velocity_z_2 = cos_rod_c*x5 - rod_b_velocity_y*sin_rod_c
    rod_c_w_y_times_length = rod_c_w_y*length
    x7 = rod_c_velocity_x_2 + rod_c_w_y_times_length
    rod_d_velocity_x_2 = cos_rod_d*x7 - rod_c_velocity_z_2*sin_rod_d
    rod_d_velocity_y_2 = rod_c_velocity_y - rod_c_rate_x_2*length
    rod_d_velocity_z_2 = cos_rod_d*rod_c_velocity_z_2 + sin_rod_d*x7
    minus_rod_d_w_z_times_length = -rod_d_w_z*length
    x9 = rod_d_velocity_y_2 + minus_rod_d_w_z_times_length
    rod_e_velocity_x_2 = cos_rod_e*rod_d_velocity_x_2 + sin_rod_e*x9
    rod_e_velocity_y_2 = cos_rod_e*x9 - rod_d_velocity_x_2*sin_rod_e
    rod_e_velocity_z_2 = rod_d_velocity_z_2 + rod_d_rate_y_2*length
    kinetic = half_rod_e_I_x_x*hinge_a_speed*hinge_a_speed + half_rod_e_I_x_x*hinge_b_speed*hinge_b_speed + half_rod_e_I_x_x*rod_b_w_x*rod_b_w_x + half_rod_e_I_x_x*rod_c_rate_x_2*rod_c_rate_x_2 + half_rod_e_I_x_x*rod_c_w_y*rod_c_w_y + half_rod_e_I_x_x*rod_d_rate_y_2*rod_d_rate_y_2 + half_rod_e_I_x_x*rod_d_w_z*rod_d_w_z + half_rod_e_I_x_x*rod_e_rate_z_2*rod_e_rate_z_2 + half_rod_e_I_x_x*rod_e_w_x*rod_e_w_x + half_mass*(rod_b_velocity_x*rod_b_velocity_x + rod_b_velocity_y*rod_b_velocity_y + rod_b_velocity_z*rod_b_velocity_z) + half_mass*(rod_c_velocity_x_2*rod_c_velocity_x_2 + rod_c_velocity_y*rod_c_velocity_y + rod_c_velocity_z_2*rod_c_velocity_z_2) + half_mass*(rod_d_velocity_x_2*rod_d_velocity_x_2 + rod_d_velocity_y_2*rod_d_velocity_y_2 + rod_d_velocity_z_2*rod_d_velocity_z_2) + half_mass*(rod_e_velocity_x_2*rod_e_velocity_x_2 + rod_e_velocity_y_2*rod_e_velocity_y_2 + rod_e_velocity_z_2*rod_e_velocity_z_2) + hinge_b_speed*rod_b_velocity_x*rod_e_h_y + rod_c_velocity_x_2*rod_c_w_y*rod_e_h_y + rod_d_rate_y_2*rod_d_velocity_z_2*rod_e_h_y + rod_e_h_y*rod_e_velocity_z_2*rod_e_w_x - rod_b_velocity_z*rod_b_w_x*rod_e_h_y - rod_c_rate_x_2*rod_c_velocity_y*rod_e_h_y - rod_d_velocity_y_2*rod_d_w_z*rod_e_h_y - rod_e_h_y*rod_e_rate_z_2*rod_e_velocity_x_2
    rod_b_centre_arm_y = -cos_rod_b*half_length
    rod_c_centre_arm_y = half_length*rod_c_R_y_z
    rod_d_centre_arm_y = -half_length*rod_d_R_y_x
    rod_e_centre_arm_y = half_length*rod_e_R_y_y
    potential = gravity_times_mass*rod_b_centre_arm_y + gravity_times_mass*(rod_c_arm_y + rod_c_centre_arm_y) + gravity_times_mass*(rod_d_centre_arm_y + rod_d_y) + gravity_times_mass*(rod_e_centre_arm_y + rod_e_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (15,): rod_a.x [m], rod_a.y [m], rod_a.z [m], rod_b.x [m], rod_b.y [m], rod_b.z [m], rod_c.x [m], rod_c.y [m], rod_c.z
            [m], rod_d.x [m], rod_d.y [m], rod_d.z [m], rod_e.x [m], rod_e.y [m], rod_e.z [m]
        rotations (45,): rod_a.R_xx [1], rod_a.R_xy [1], rod_a.R_xz [1], rod_a.R_yx [1], rod_a.R_yy [1], rod_a.R_yz [1], rod_a.R_zx [1],
            rod_a.R_zy [1], rod_a.R_zz [1], rod_b.R_xx [1], rod_b.R_xy [1], rod_b.R_xz [1], rod_b.R_yx [1], rod_b.R_yy [1], rod_b.R_yz [1],
            rod_b.R_zx [1], rod_b.R_zy [1], rod_b.R_zz [1], rod_c.R_xx [1], rod_c.R_xy [1], rod_c.R_xz [1], rod_c.R_yx [1], rod_c.R_yy [1],
            rod_c.R_yz [1], rod_c.R_zx [1], rod_c.R_zy [1], rod_c.R_zz [1], rod_d.R_xx [1], rod_d.R_xy [1], rod_d.R_xz [1], rod_d.R_yx [1],
            rod_d.R_yy [1], rod_d.R_yz [1], rod_d.R_zx [1], rod_d.R_zy [1], rod_d.R_zz [1], rod_e.R_xx [1], rod_e.R_xy [1], rod_e.R_xz [1],
            rod_e.R_yx [1], rod_e.R_yy [1], rod_e.R_yz [1], rod_e.R_zx [1], rod_e.R_zy [1], rod_e.R_zz [1]
    """
    length = c[0]
    hinge_a_angle, hinge_b_angle, hinge_c_angle, hinge_d_angle, hinge_e_angle = q[0], q[1], q[2], q[3], q[4]
    cos_rod_a = ca.cos(hinge_a_angle)
    sin_rod_a = ca.sin(hinge_a_angle)
    cos_rod_b = ca.cos(hinge_b_angle)
    sin_rod_b = ca.sin(hinge_b_angle)
    cos_rod_c = ca.cos(hinge_c_angle)
    sin_rod_c = ca.sin(hinge_c_angle)
    cos_rod_d = ca.cos(hinge_d_angle)
    sin_rod_d = ca.sin(hinge_d_angle)
    cos_rod_e = ca.cos(hinge_e_angle)
    sin_rod_e = ca.sin(hinge_e_angle)
    rod_b_arm_x = cos_rod_a*length
    rod_b_arm_z = -sin_rod_a*length
    rod_b_R_x_x = cos_rod_a*cos_rod_b
    rod_b_R_x_y = -cos_rod_a*sin_rod_b
    rod_b_R_z_x = -cos_rod_b*sin_rod_a
    rod_b_R_z_y = sin_rod_a*sin_rod_b
    rod_c_arm_x = -rod_b_R_x_y*length
    rod_c_arm_y = -cos_rod_b*length
    rod_c_arm_z = -rod_b_R_z_y*length
    rod_c_x = rod_b_arm_x + rod_c_arm_x
    rod_c_z = rod_b_arm_z + rod_c_arm_z
    rod_c_R_x_y = cos_rod_c*rod_b_R_x_y + sin_rod_a*sin_rod_c
    rod_c_R_x_z = cos_rod_c*sin_rod_a - rod_b_R_x_y*sin_rod_c
    rod_c_R_y_y = cos_rod_b*cos_rod_c
    rod_c_R_y_z = -cos_rod_b*sin_rod_c
    rod_c_R_z_y = cos_rod_a*sin_rod_c + cos_rod_c*rod_b_R_z_y
    rod_c_R_z_z = cos_rod_a*cos_rod_c - rod_b_R_z_y*sin_rod_c
    rod_d_arm_x = rod_c_R_x_z*length
    rod_d_arm_y = rod_c_R_y_z*length
    rod_d_arm_z = rod_c_R_z_z*length
    rod_d_x = rod_c_x + rod_d_arm_x
    rod_d_y = rod_c_arm_y + rod_d_arm_y
    rod_d_z = rod_c_z + rod_d_arm_z
    rod_d_R_x_x = cos_rod_d*rod_b_R_x_x - rod_c_R_x_z*sin_rod_d
    rod_d_R_x_z = cos_rod_d*rod_c_R_x_z + rod_b_R_x_x*sin_rod_d
    rod_d_R_y_x = cos_rod_d*sin_rod_b - rod_c_R_y_z*sin_rod_d
    rod_d_R_y_z = cos_rod_d*rod_c_R_y_z + sin_rod_b*sin_rod_d
    rod_d_R_z_x = cos_rod_d*rod_b_R_z_x - rod_c_R_z_z*sin_rod_d
    rod_d_R_z_z = cos_rod_d*rod_c_R_z_z + rod_b_R_z_x*sin_rod_d
    rod_e_arm_x = -rod_d_R_x_x*length
    rod_e_arm_y = -rod_d_R_y_x*length
    rod_e_arm_z = -rod_d_R_z_x*length
    rod_e_x = rod_d_x + rod_e_arm_x
    rod_e_y = rod_d_y + rod_e_arm_y
    rod_e_z = rod_d_z + rod_e_arm_z
    rod_e_R_x_x = cos_rod_e*rod_d_R_x_x + rod_c_R_x_y*sin_rod_e
    rod_e_R_x_y = cos_rod_e*rod_c_R_x_y - rod_d_R_x_x*sin_rod_e
    rod_e_R_y_x = cos_rod_e*rod_d_R_y_x + rod_c_R_y_y*sin_rod_e
    rod_e_R_y_y = cos_rod_e*rod_c_R_y_y - rod_d_R_y_x*sin_rod_e
    rod_e_R_z_x = cos_rod_e*rod_d_R_z_x + rod_c_R_z_y*sin_rod_e
    rod_e_R_z_y = cos_rod_e*rod_c_R_z_y - rod_d_R_z_x*sin_rod_e
    return (ca.vertcat(0, 0, 0, rod_b_arm_x, 0, rod_b_arm_z, rod_c_x, rod_c_arm_y, rod_c_z, rod_d_x, rod_d_y, rod_d_z, rod_e_x, rod_e_y,
            rod_e_z),
        ca.vertcat(cos_rod_a, 0, sin_rod_a, 0, 1, 0, -sin_rod_a, 0, cos_rod_a, rod_b_R_x_x, rod_b_R_x_y, sin_rod_a, sin_rod_b, cos_rod_b, 0,
            rod_b_R_z_x, rod_b_R_z_y, cos_rod_a, rod_b_R_x_x, rod_c_R_x_y, rod_c_R_x_z, sin_rod_b, rod_c_R_y_y, rod_c_R_y_z, rod_b_R_z_x,
            rod_c_R_z_y, rod_c_R_z_z, rod_d_R_x_x, rod_c_R_x_y, rod_d_R_x_z, rod_d_R_y_x, rod_c_R_y_y, rod_d_R_y_z, rod_d_R_z_x,
            rod_c_R_z_y, rod_d_R_z_z, rod_e_R_x_x, rod_e_R_x_y, rod_d_R_x_z, rod_e_R_y_x, rod_e_R_y_y, rod_d_R_y_z, rod_e_R_z_x,
            rod_e_R_z_y, rod_d_R_z_z))


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
        hinge_a.parent to gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        rod_a.centre to rod_e.centre (3,): x [m], y [m], z [m]
    """
    length = p[1]
    x1 = length/2
    minus_half_length = -length/2
    return (ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, -length, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, length, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(-length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, length, 1, 0, 0), ca.vertcat(0, length, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(x1, 0, 0), ca.vertcat(0, minus_half_length, 0), ca.vertcat(0, 0, x1),
        ca.vertcat(minus_half_length, 0, 0), ca.vertcat(0, x1, 0))
