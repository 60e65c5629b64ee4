"""n_four_bar: 2 four-bar windows, through singular positions. Generated from derive/scenes/n_four_bar.py.

Do not edit; regenerate with `hertzwerk derive n_four_bar`.
Effects:
    gravity: uniform gravity
    energy_ledger: work put in, energy dissipated per effect
Units: 258 assignments and 243 outputs checked, all consistent
Operations: flight 552 (equations of motion and gaps)
"""

import casadi as ca

NAME = "n_four_bar"
SOURCE = "derive/scenes/n_four_bar.py"
SUMMARY = "2 four-bar windows, through singular positions"
FORMAT = "hertzwerk module 1"
DIGEST = "da3b1811af09de33149a21ef958406c0"

EFFECTS = (("gravity", "gravity", "uniform gravity"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"))

PARAMETERS = (
    ("mass", "kg", 1.0, "of each rod"),
    ("length", "m", 1.0, "of each rod"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("speed", "m/s", 1.0, "of the upper hinges at the start"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body post_0, mass"),
    ("length", "defined", 0, None, True, False, "scales, length"),
    ("speed", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("foot_0.angle", "rad"), ("foot_1.angle", "rad"), ("foot_2.angle", "rad"), ("left_0.angle", "rad"), ("left_1.angle", "rad"))

SPEEDS = (
    ("foot_0.speed", "rad/s"), ("foot_1.speed", "rad/s"), ("foot_2.speed", "rad/s"), ("left_0.speed", "rad/s"), ("left_1.speed", "rad/s"),
)

CONSTRAINTS = (("right_0.apart_x", "m"), ("right_0.apart_y", "m"), ("right_1.apart_x", "m"), ("right_1.apart_y", "m"))

GIVEN = ("foot_0.speed",)

BODIES = ("post_0", "post_1", "post_2", "beam_0", "beam_1")

LANDMARKS = (
    ("foot_0", "revolute", "parent", "ground", ("axis",)), ("foot_0", "revolute", "child", "post_0", ("axis",)),
    ("foot_1", "revolute", "parent", "ground", ("axis",)), ("foot_1", "revolute", "child", "post_1", ("axis",)),
    ("foot_2", "revolute", "parent", "ground", ("axis",)), ("foot_2", "revolute", "child", "post_2", ("axis",)),
    ("left_0", "revolute", "parent", "post_0", ("axis",)), ("left_0", "revolute", "child", "beam_0", ("axis",)),
    ("left_1", "revolute", "parent", "post_1", ("axis",)), ("left_1", "revolute", "child", "beam_1", ("axis",)),
    ("right_0", "revolute", "parent", "post_1", ("axis",)), ("right_0", "revolute", "child", "beam_0", ("axis",)),
    ("right_1", "revolute", "parent", "post_2", ("axis",)), ("right_1", "revolute", "child", "beam_1", ("axis",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("post_0", "body", "centre", "post_0", ()),
    ("post_1", "body", "centre", "post_1", ()), ("post_2", "body", "centre", "post_2", ()), ("beam_0", "body", "centre", "beam_0", ()),
    ("beam_1", "body", "centre", "beam_1", ()),
)

CONSTANTS = (
    ("length", "m"), ("gravity", "m/s^2"), ("post_2_arm_x", "m"), ("beam_0_h_x", "kg m"), ("post_0_h_y", "kg m"),
    ("beam_0_I_z_z", "kg m^2"), ("beam_0_I_z_z_plus_post_0_I_z_z", "kg m^2"), ("inverse_beam_0_I_z_z", "1/(kg m^2)"),
    ("half_beam_0_I_z_z", "kg m^2"), ("half_mass", "kg"), ("half_length", "m"), ("gravity_times_mass", "N"),
    ("right_0_apart_x_softness", "1"), ("right_0_apart_y_softness", "1"), ("right_1_apart_x_softness", "1"),
    ("right_1_apart_y_softness", "1"),
)

OPERATIONS = (
    ("constants", 18), ("start", 2), ("scales", 6), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 27),
    ("accelerations", 525), ("constraints", 61), ("projection", 311), ("ledger", 0), ("energy", 81), ("poses", 24), ("outputs", 0),
    ("landmarks", 2),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (16,): length, gravity, post_2_arm_x, beam_0_h_x, post_0_h_y, beam_0_I_z_z, beam_0_I_z_z_plus_post_0_I_z_z, inverse_beam_0_I_z_z,
            half_beam_0_I_z_z, half_mass, half_length, gravity_times_mass, right_0_apart_x_softness, right_0_apart_y_softness,
            right_1_apart_x_softness, right_1_apart_y_softness
    """
    mass, length, gravity = p[0], p[1], p[2]
    post_2_arm_x = 2*length
    beam_0_h_x = length*mass/2
    post_0_h_y = 3*length*mass/2
    length_squared = length*length
    post_0_I_z_z = 4*length_squared*mass/3
    beam_0_I_z_z = length_squared*mass/3
    beam_0_I_z_z_plus_post_0_I_z_z = beam_0_I_z_z + post_0_I_z_z
    inverse_beam_0_I_z_z = 1/beam_0_I_z_z
    half_beam_0_I_z_z = beam_0_I_z_z/2
    half_mass = mass/2
    half_length = length/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(length, gravity, post_2_arm_x, beam_0_h_x, post_0_h_y, beam_0_I_z_z, beam_0_I_z_z_plus_post_0_I_z_z,
        inverse_beam_0_I_z_z, half_beam_0_I_z_z, half_mass, half_length, gravity_times_mass, 3e-09, 3e-09, 3e-09, 3e-09)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (5,): COORDINATES
        u (5,): SPEEDS
    """
    length, speed = p[1], p[3]
    return ca.vertcat(*[0]*5), ca.vertcat(-speed/length, 0, 0, 0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (5,): COORDINATES
        su (5,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, length, speed = p[0], p[1], p[3]
    total_mass = 5*mass
    energy_scale = total_mass*speed*speed/2
    force_scale = energy_scale/length
    speed_over_length = speed/length
    return ca.vertcat(*[1]*5), ca.vertcat(*[speed_over_length]*5), ca.vertcat(), ca.vertcat(length, speed, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (5,): COORDINATES [rad/s]
    """
    foot_0_speed, foot_1_speed, foot_2_speed, left_0_speed, left_1_speed = u[0], u[1], u[2], u[3], u[4]
    return ca.vertcat(foot_0_speed, foot_1_speed, foot_2_speed, left_0_speed, left_1_speed)


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
        f (5,): foot_0 [N m], foot_1 [N m], foot_2 [N m], left_0 [N m], left_1 [N m]
    """
    gravity, beam_0_h_x, post_0_h_y = c[1], c[3], c[4]
    foot_0_angle, foot_1_angle, foot_2_angle, left_0_angle, left_1_angle = q[0], q[1], q[2], q[3], q[4]
    sin_post_0 = ca.sin(foot_0_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    sin_post_2 = ca.sin(foot_2_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    beam_0_moment_x = beam_0_h_x*cos_beam_0
    post_0_moment_x = -post_0_h_y*sin_post_0
    post_0_total_moment_x = beam_0_moment_x + post_0_moment_x
    beam_1_moment_x = beam_0_h_x*cos_beam_1
    post_1_moment_x = -post_0_h_y*sin_post_1
    post_1_total_moment_x = beam_1_moment_x + post_1_moment_x
    post_2_moment_x = -beam_0_h_x*sin_post_2
    return ca.vertcat(-post_0_total_moment_x*gravity, -post_1_total_moment_x*gravity, -post_2_moment_x*gravity, -beam_0_moment_x*gravity,
        -beam_1_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): foot_0.acceleration [rad/s^2], foot_1.acceleration [rad/s^2], foot_2.acceleration [rad/s^2], left_0.acceleration [rad/s^2],
            left_1.acceleration [rad/s^2]
        reactions (0,): empty
        multipliers (4,): CONSTRAINTS [N]
    """
    length, post_2_arm_x, beam_0_h_x, beam_0_I_z_z, beam_0_I_z_z_plus_post_0_I_z_z = c[0], c[2], c[3], c[5], c[6]
    inverse_beam_0_I_z_z, right_0_apart_x_softness, right_0_apart_y_softness, right_1_apart_x_softness = c[7], c[12], c[13], c[14]
    right_1_apart_y_softness = c[15]
    foot_0_angle, foot_1_angle, foot_2_angle, left_0_angle, left_1_angle = q[0], q[1], q[2], q[3], q[4]
    foot_0_speed, foot_1_speed, foot_2_speed, left_0_speed, left_1_speed = u[0], u[1], u[2], u[3], u[4]
    foot_0_force, foot_1_force, foot_2_force, left_0_force, left_1_force = f[0], f[1], f[2], f[3], f[4]
    cos_post_0 = ca.cos(foot_0_angle)
    sin_post_0 = ca.sin(foot_0_angle)
    cos_post_1 = ca.cos(foot_1_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    cos_post_2 = ca.cos(foot_2_angle)
    sin_post_2 = ca.sin(foot_2_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    sin_beam_0 = ca.sin(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    sin_beam_1 = ca.sin(beam_1_angle)
    beam_0_arm_x = -sin_post_0*length
    beam_0_arm_y = cos_post_0*length
    beam_0_arm_rate_x = -beam_0_arm_y*foot_0_speed
    beam_0_arm_rate_y = beam_0_arm_x*foot_0_speed
    beam_0_rate_z = foot_0_speed + left_0_speed
    beam_0_bias_x = -beam_0_arm_rate_y*foot_0_speed
    beam_0_bias_y = beam_0_arm_rate_x*foot_0_speed
    right_0_child_arm_x = cos_beam_0*length
    right_0_child_arm_y = sin_beam_0*length
    right_0_child_arm_rate_x = -beam_0_rate_z*right_0_child_arm_y
    right_0_child_arm_rate_y = beam_0_rate_z*right_0_child_arm_x
    right_0_parent_arm_x = -sin_post_1*length
    right_0_parent_arm_y = cos_post_1*length
    right_0_parent_arm_rate_x = -foot_1_speed*right_0_parent_arm_y
    right_0_parent_arm_rate_y = foot_1_speed*right_0_parent_arm_x
    right_0_apart_bias_x = beam_0_bias_x + foot_1_speed*right_0_parent_arm_rate_y - beam_0_rate_z*right_0_child_arm_rate_y
    right_0_apart_bias_y = beam_0_bias_y + beam_0_rate_z*right_0_child_arm_rate_x - foot_1_speed*right_0_parent_arm_rate_x
    right_0_x_on_foot_0 = -beam_0_arm_y - right_0_child_arm_y
    right_0_x_on_foot_1 = beam_0_arm_y + right_0_child_arm_y
    right_0_y_on_foot_0 = beam_0_arm_x + right_0_child_arm_x
    right_0_y_on_foot_1 = length - beam_0_arm_x - right_0_child_arm_x
    beam_1_rate_z = foot_1_speed + left_1_speed
    beam_1_x = right_0_parent_arm_x + length
    beam_1_bias_x = -foot_1_speed*right_0_parent_arm_rate_y
    beam_1_bias_y = foot_1_speed*right_0_parent_arm_rate_x
    right_1_child_arm_x = cos_beam_1*length
    right_1_child_arm_y = sin_beam_1*length
    right_1_child_arm_rate_x = -beam_1_rate_z*right_1_child_arm_y
    right_1_child_arm_rate_y = beam_1_rate_z*right_1_child_arm_x
    right_1_parent_arm_x = -sin_post_2*length
    right_1_parent_arm_y = cos_post_2*length
    right_1_parent_arm_rate_x = -foot_2_speed*right_1_parent_arm_y
    right_1_parent_arm_rate_y = foot_2_speed*right_1_parent_arm_x
    right_1_apart_bias_x = beam_1_bias_x + foot_2_speed*right_1_parent_arm_rate_y - beam_1_rate_z*right_1_child_arm_rate_y
    right_1_apart_bias_y = beam_1_bias_y + beam_1_rate_z*right_1_child_arm_rate_x - foot_2_speed*right_1_parent_arm_rate_x
    right_1_x_on_foot_1 = -right_0_parent_arm_y - right_1_child_arm_y
    right_1_x_on_foot_2 = right_0_parent_arm_y + right_1_child_arm_y
    right_1_y_on_foot_1 = beam_1_x + right_1_child_arm_x - length
    right_1_y_on_foot_2 = post_2_arm_x - beam_1_x - right_1_child_arm_x
    beam_0_moment_x = beam_0_h_x*cos_beam_0
    beam_0_moment_y = beam_0_h_x*sin_beam_0
    beam_1_moment_x = beam_0_h_x*cos_beam_1
    beam_1_moment_y = beam_0_h_x*sin_beam_1
    post_0_rate_zz = foot_0_speed*foot_0_speed
    beam_0_rate_zz = beam_0_rate_z*beam_0_rate_z
    beam_0_force_x = -beam_0_moment_x*beam_0_rate_zz
    beam_0_force_y = -beam_0_moment_y*beam_0_rate_zz
    beam_0_bias_x_2 = -beam_0_arm_x*post_0_rate_zz
    beam_0_bias_y_2 = -beam_0_arm_y*post_0_rate_zz
    beam_0_torque_z = beam_0_bias_y_2*beam_0_moment_x - beam_0_bias_x_2*beam_0_moment_y
    post_0_torque_z = beam_0_torque_z + beam_0_arm_x*beam_0_force_y - beam_0_arm_y*beam_0_force_x
    foot_0_net = foot_0_force - post_0_torque_z
    post_1_rate_zz = foot_1_speed*foot_1_speed
    beam_1_rate_zz = beam_1_rate_z*beam_1_rate_z
    beam_1_force_x = -beam_1_moment_x*beam_1_rate_zz
    beam_1_force_y = -beam_1_moment_y*beam_1_rate_zz
    beam_1_bias_x_2 = -post_1_rate_zz*right_0_parent_arm_x
    beam_1_bias_y_2 = -post_1_rate_zz*right_0_parent_arm_y
    beam_1_torque_z = beam_1_bias_y_2*beam_1_moment_x - beam_1_bias_x_2*beam_1_moment_y
    post_1_torque_z = beam_1_torque_z + beam_1_force_y*right_0_parent_arm_x - beam_1_force_x*right_0_parent_arm_y
    foot_1_net = foot_1_force - post_1_torque_z
    left_0_net = left_0_force - beam_0_torque_z
    left_1_net = left_1_force - beam_1_torque_z
    post_0_total_J_z_z = beam_0_I_z_z_plus_post_0_I_z_z + 2*beam_0_arm_x*beam_0_moment_x + 2*beam_0_arm_y*beam_0_moment_y
    post_1_total_J_z_z = beam_0_I_z_z_plus_post_0_I_z_z + 2*beam_1_moment_x*right_0_parent_arm_x + 2*beam_1_moment_y*right_0_parent_arm_y
    left_0_beam_0_torque_z = beam_0_I_z_z + beam_0_arm_x*beam_0_moment_x + beam_0_arm_y*beam_0_moment_y
    left_1_beam_1_torque_z = beam_0_I_z_z + beam_1_moment_x*right_0_parent_arm_x + beam_1_moment_y*right_0_parent_arm_y
    l_foot_1_left_1 = inverse_beam_0_I_z_z*left_1_beam_1_torque_z
    D_foot_1 = post_1_total_J_z_z - l_foot_1_left_1*left_1_beam_1_torque_z
    l_foot_0_left_0 = inverse_beam_0_I_z_z*left_0_beam_0_torque_z
    D_foot_0 = post_0_total_J_z_z - l_foot_0_left_0*left_0_beam_0_torque_z
    y_foot_1 = foot_1_net - l_foot_1_left_1*left_1_net
    y_foot_0 = foot_0_net - l_foot_0_left_0*left_0_net
    foot_0_acc = y_foot_0/D_foot_0
    foot_1_acc = y_foot_1/D_foot_1
    foot_2_acc = foot_2_force*inverse_beam_0_I_z_z
    left_0_acc = inverse_beam_0_I_z_z*left_0_net - foot_0_acc*l_foot_0_left_0
    left_1_acc = inverse_beam_0_I_z_z*left_1_net - foot_1_acc*l_foot_1_left_1
    y_foot_2 = right_0_x_on_foot_0 + l_foot_0_left_0*right_0_child_arm_y
    foot_0_by_right_0_apart_x = y_foot_2/D_foot_0
    foot_1_by_right_0_apart_x = right_0_x_on_foot_1/D_foot_1
    left_0_by_right_0_apart_x = -foot_0_by_right_0_apart_x*l_foot_0_left_0 - inverse_beam_0_I_z_z*right_0_child_arm_y
    left_1_by_right_0_apart_x = -foot_1_by_right_0_apart_x*l_foot_1_left_1
    y_foot_3 = right_0_y_on_foot_0 - l_foot_0_left_0*right_0_child_arm_x
    foot_0_by_right_0_apart_y = y_foot_3/D_foot_0
    foot_1_by_right_0_apart_y = right_0_y_on_foot_1/D_foot_1
    left_0_by_right_0_apart_y = inverse_beam_0_I_z_z*right_0_child_arm_x - foot_0_by_right_0_apart_y*l_foot_0_left_0
    left_1_by_right_0_apart_y = -foot_1_by_right_0_apart_y*l_foot_1_left_1
    y_foot_4 = right_1_x_on_foot_1 + l_foot_1_left_1*right_1_child_arm_y
    foot_1_by_right_1_apart_x = y_foot_4/D_foot_1
    foot_2_by_right_1_apart_x = inverse_beam_0_I_z_z*right_1_x_on_foot_2
    left_1_by_right_1_apart_x = -foot_1_by_right_1_apart_x*l_foot_1_left_1 - inverse_beam_0_I_z_z*right_1_child_arm_y
    y_foot_5 = right_1_y_on_foot_1 - l_foot_1_left_1*right_1_child_arm_x
    foot_1_by_right_1_apart_y = y_foot_5/D_foot_1
    foot_2_by_right_1_apart_y = inverse_beam_0_I_z_z*right_1_y_on_foot_2
    left_1_by_right_1_apart_y = inverse_beam_0_I_z_z*right_1_child_arm_x - foot_1_by_right_1_apart_y*l_foot_1_left_1
    W_right_0_apart_x_right_0_apart_x = foot_0_by_right_0_apart_x*right_0_x_on_foot_0 + foot_1_by_right_0_apart_x*right_0_x_on_foot_1 - left_0_by_right_0_apart_x*right_0_child_arm_y
    W_right_0_apart_y_right_0_apart_x = foot_0_by_right_0_apart_x*right_0_y_on_foot_0 + foot_1_by_right_0_apart_x*right_0_y_on_foot_1 + left_0_by_right_0_apart_x*right_0_child_arm_x
    W_right_0_apart_y_right_0_apart_y = foot_0_by_right_0_apart_y*right_0_y_on_foot_0 + foot_1_by_right_0_apart_y*right_0_y_on_foot_1 + left_0_by_right_0_apart_y*right_0_child_arm_x
    W_right_1_apart_x_right_0_apart_x = foot_1_by_right_0_apart_x*right_1_x_on_foot_1 - left_1_by_right_0_apart_x*right_1_child_arm_y
    W_right_1_apart_x_right_0_apart_y = foot_1_by_right_0_apart_y*right_1_x_on_foot_1 - left_1_by_right_0_apart_y*right_1_child_arm_y
    W_right_1_apart_x_right_1_apart_x = foot_1_by_right_1_apart_x*right_1_x_on_foot_1 + foot_2_by_right_1_apart_x*right_1_x_on_foot_2 - left_1_by_right_1_apart_x*right_1_child_arm_y
    W_right_1_apart_y_right_0_apart_x = foot_1_by_right_0_apart_x*right_1_y_on_foot_1 + left_1_by_right_0_apart_x*right_1_child_arm_x
    W_right_1_apart_y_right_0_apart_y = foot_1_by_right_0_apart_y*right_1_y_on_foot_1 + left_1_by_right_0_apart_y*right_1_child_arm_x
    W_right_1_apart_y_right_1_apart_x = foot_1_by_right_1_apart_x*right_1_y_on_foot_1 + foot_2_by_right_1_apart_x*right_1_y_on_foot_2 + left_1_by_right_1_apart_x*right_1_child_arm_x
    W_right_1_apart_y_right_1_apart_y = foot_1_by_right_1_apart_y*right_1_y_on_foot_1 + foot_2_by_right_1_apart_y*right_1_y_on_foot_2 + left_1_by_right_1_apart_y*right_1_child_arm_x
    right_0_apart_size = W_right_0_apart_x_right_0_apart_x + W_right_0_apart_y_right_0_apart_y
    W_right_0_apart_x_raised = W_right_0_apart_x_right_0_apart_x + right_0_apart_size*right_0_apart_x_softness
    W_right_0_apart_y_raised = W_right_0_apart_y_right_0_apart_y + right_0_apart_size*right_0_apart_y_softness
    right_1_apart_size = W_right_1_apart_x_right_1_apart_x + W_right_1_apart_y_right_1_apart_y
    W_right_1_apart_x_raised = W_right_1_apart_x_right_1_apart_x + right_1_apart_size*right_1_apart_x_softness
    W_right_1_apart_y_raised = W_right_1_apart_y_right_1_apart_y + right_1_apart_size*right_1_apart_y_softness
    l_right_0_apart_y_right_0_apart_x = W_right_0_apart_y_right_0_apart_x/W_right_0_apart_x_raised
    D_right_0_apart_y = W_right_0_apart_y_raised - W_right_0_apart_y_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_x_right_0_apart_x = W_right_1_apart_x_right_0_apart_x/W_right_0_apart_x_raised
    L_right_1_apart_x_right_0_apart_y = W_right_1_apart_x_right_0_apart_y - W_right_1_apart_x_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_x_right_0_apart_y = L_right_1_apart_x_right_0_apart_y/D_right_0_apart_y
    D_right_1_apart_x = W_right_1_apart_x_raised - L_right_1_apart_x_right_0_apart_y*l_right_1_apart_x_right_0_apart_y - W_right_1_apart_x_right_0_apart_x*l_right_1_apart_x_right_0_apart_x
    l_right_1_apart_y_right_0_apart_x = W_right_1_apart_y_right_0_apart_x/W_right_0_apart_x_raised
    L_right_1_apart_y_right_0_apart_y = W_right_1_apart_y_right_0_apart_y - W_right_1_apart_y_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_y_right_0_apart_y = L_right_1_apart_y_right_0_apart_y/D_right_0_apart_y
    L_right_1_apart_y_right_1_apart_x = W_right_1_apart_y_right_1_apart_x - L_right_1_apart_y_right_0_apart_y*l_right_1_apart_x_right_0_apart_y - W_right_1_apart_y_right_0_apart_x*l_right_1_apart_x_right_0_apart_x
    l_right_1_apart_y_right_1_apart_x = L_right_1_apart_y_right_1_apart_x/D_right_1_apart_x
    D_right_1_apart_y = W_right_1_apart_y_raised - L_right_1_apart_y_right_0_apart_y*l_right_1_apart_y_right_0_apart_y - L_right_1_apart_y_right_1_apart_x*l_right_1_apart_y_right_1_apart_x - W_right_1_apart_y_right_0_apart_x*l_right_1_apart_y_right_0_apart_x
    right_0_apart_x_left = left_0_acc*right_0_child_arm_y - right_0_apart_bias_x - foot_0_acc*right_0_x_on_foot_0 - foot_1_acc*right_0_x_on_foot_1
    right_0_apart_y_left = -right_0_apart_bias_y - foot_0_acc*right_0_y_on_foot_0 - foot_1_acc*right_0_y_on_foot_1 - left_0_acc*right_0_child_arm_x
    right_1_apart_x_left = left_1_acc*right_1_child_arm_y - right_1_apart_bias_x - foot_1_acc*right_1_x_on_foot_1 - foot_2_acc*right_1_x_on_foot_2
    right_1_apart_y_left = -right_1_apart_bias_y - foot_1_acc*right_1_y_on_foot_1 - foot_2_acc*right_1_y_on_foot_2 - left_1_acc*right_1_child_arm_x
    y_right_0_apart_y = right_0_apart_y_left - l_right_0_apart_y_right_0_apart_x*right_0_apart_x_left
    y_right_1_apart_x = right_1_apart_x_left - l_right_1_apart_x_right_0_apart_x*right_0_apart_x_left - l_right_1_apart_x_right_0_apart_y*y_right_0_apart_y
    y_right_1_apart_y = right_1_apart_y_left - l_right_1_apart_y_right_0_apart_x*right_0_apart_x_left - l_right_1_apart_y_right_0_apart_y*y_right_0_apart_y - l_right_1_apart_y_right_1_apart_x*y_right_1_apart_x
    right_1_apart_y_acc = y_right_1_apart_y/D_right_1_apart_y
    right_1_apart_x_acc = y_right_1_apart_x/D_right_1_apart_x - l_right_1_apart_y_right_1_apart_x*right_1_apart_y_acc
    right_0_apart_y_acc = y_right_0_apart_y/D_right_0_apart_y - l_right_1_apart_x_right_0_apart_y*right_1_apart_x_acc - l_right_1_apart_y_right_0_apart_y*right_1_apart_y_acc
    right_0_apart_x_acc = right_0_apart_x_left/W_right_0_apart_x_raised - l_right_0_apart_y_right_0_apart_x*right_0_apart_y_acc - l_right_1_apart_x_right_0_apart_x*right_1_apart_x_acc - l_right_1_apart_y_right_0_apart_x*right_1_apart_y_acc
    foot_0_acc_2 = foot_0_acc + foot_0_by_right_0_apart_x*right_0_apart_x_acc + foot_0_by_right_0_apart_y*right_0_apart_y_acc
    foot_1_acc_2 = foot_1_acc + foot_1_by_right_0_apart_x*right_0_apart_x_acc + foot_1_by_right_0_apart_y*right_0_apart_y_acc + foot_1_by_right_1_apart_x*right_1_apart_x_acc + foot_1_by_right_1_apart_y*right_1_apart_y_acc
    foot_2_acc_2 = foot_2_acc + foot_2_by_right_1_apart_x*right_1_apart_x_acc + foot_2_by_right_1_apart_y*right_1_apart_y_acc
    left_0_acc_2 = left_0_acc + left_0_by_right_0_apart_x*right_0_apart_x_acc + left_0_by_right_0_apart_y*right_0_apart_y_acc
    left_1_acc_2 = left_1_acc + left_1_by_right_0_apart_x*right_0_apart_x_acc + left_1_by_right_0_apart_y*right_0_apart_y_acc + left_1_by_right_1_apart_x*right_1_apart_x_acc + left_1_by_right_1_apart_y*right_1_apart_y_acc
    right_0_apart_x_left_2 = left_0_acc_2*right_0_child_arm_y - right_0_apart_bias_x - foot_0_acc_2*right_0_x_on_foot_0 - foot_1_acc_2*right_0_x_on_foot_1
    right_0_apart_y_left_2 = -right_0_apart_bias_y - foot_0_acc_2*right_0_y_on_foot_0 - foot_1_acc_2*right_0_y_on_foot_1 - left_0_acc_2*right_0_child_arm_x
    right_1_apart_x_left_2 = left_1_acc_2*right_1_child_arm_y - right_1_apart_bias_x - foot_1_acc_2*right_1_x_on_foot_1 - foot_2_acc_2*right_1_x_on_foot_2
    right_1_apart_y_left_2 = -right_1_apart_bias_y - foot_1_acc_2*right_1_y_on_foot_1 - foot_2_acc_2*right_1_y_on_foot_2 - left_1_acc_2*right_1_child_arm_x
    y_right_0_apart_y_2 = right_0_apart_y_left_2 - l_right_0_apart_y_right_0_apart_x*right_0_apart_x_left_2
    y_right_1_apart_x_2 = right_1_apart_x_left_2 - l_right_1_apart_x_right_0_apart_x*right_0_apart_x_left_2 - l_right_1_apart_x_right_0_apart_y*y_right_0_apart_y_2
    y_right_1_apart_y_2 = right_1_apart_y_left_2 - l_right_1_apart_y_right_0_apart_x*right_0_apart_x_left_2 - l_right_1_apart_y_right_0_apart_y*y_right_0_apart_y_2 - l_right_1_apart_y_right_1_apart_x*y_right_1_apart_x_2
    right_1_apart_y_acc_2 = y_right_1_apart_y_2/D_right_1_apart_y
    right_1_apart_x_acc_2 = y_right_1_apart_x_2/D_right_1_apart_x - l_right_1_apart_y_right_1_apart_x*right_1_apart_y_acc_2
    right_0_apart_y_acc_2 = y_right_0_apart_y_2/D_right_0_apart_y - l_right_1_apart_x_right_0_apart_y*right_1_apart_x_acc_2 - l_right_1_apart_y_right_0_apart_y*right_1_apart_y_acc_2
    right_0_apart_x_acc_2 = right_0_apart_x_left_2/W_right_0_apart_x_raised - l_right_0_apart_y_right_0_apart_x*right_0_apart_y_acc_2 - l_right_1_apart_x_right_0_apart_x*right_1_apart_x_acc_2 - l_right_1_apart_y_right_0_apart_x*right_1_apart_y_acc_2
    right_0_apart_x_acc_3 = right_0_apart_x_acc + right_0_apart_x_acc_2
    right_0_apart_y_acc_3 = right_0_apart_y_acc + right_0_apart_y_acc_2
    right_1_apart_x_acc_3 = right_1_apart_x_acc + right_1_apart_x_acc_2
    right_1_apart_y_acc_3 = right_1_apart_y_acc + right_1_apart_y_acc_2
    foot_0_acc_3 = foot_0_acc_2 + foot_0_by_right_0_apart_x*right_0_apart_x_acc_2 + foot_0_by_right_0_apart_y*right_0_apart_y_acc_2
    foot_1_acc_3 = foot_1_acc_2 + foot_1_by_right_0_apart_x*right_0_apart_x_acc_2 + foot_1_by_right_0_apart_y*right_0_apart_y_acc_2 + foot_1_by_right_1_apart_x*right_1_apart_x_acc_2 + foot_1_by_right_1_apart_y*right_1_apart_y_acc_2
    foot_2_acc_3 = foot_2_acc_2 + foot_2_by_right_1_apart_x*right_1_apart_x_acc_2 + foot_2_by_right_1_apart_y*right_1_apart_y_acc_2
    left_0_acc_3 = left_0_acc_2 + left_0_by_right_0_apart_x*right_0_apart_x_acc_2 + left_0_by_right_0_apart_y*right_0_apart_y_acc_2
    left_1_acc_3 = left_1_acc_2 + left_1_by_right_0_apart_x*right_0_apart_x_acc_2 + left_1_by_right_0_apart_y*right_0_apart_y_acc_2 + left_1_by_right_1_apart_x*right_1_apart_x_acc_2 + left_1_by_right_1_apart_y*right_1_apart_y_acc_2
    right_0_apart_x_left_3 = left_0_acc_3*right_0_child_arm_y - right_0_apart_bias_x - foot_0_acc_3*right_0_x_on_foot_0 - foot_1_acc_3*right_0_x_on_foot_1
    right_0_apart_y_left_3 = -right_0_apart_bias_y - foot_0_acc_3*right_0_y_on_foot_0 - foot_1_acc_3*right_0_y_on_foot_1 - left_0_acc_3*right_0_child_arm_x
    right_1_apart_x_left_3 = left_1_acc_3*right_1_child_arm_y - right_1_apart_bias_x - foot_1_acc_3*right_1_x_on_foot_1 - foot_2_acc_3*right_1_x_on_foot_2
    right_1_apart_y_left_3 = -right_1_apart_bias_y - foot_1_acc_3*right_1_y_on_foot_1 - foot_2_acc_3*right_1_y_on_foot_2 - left_1_acc_3*right_1_child_arm_x
    y_right_0_apart_y_3 = right_0_apart_y_left_3 - l_right_0_apart_y_right_0_apart_x*right_0_apart_x_left_3
    y_right_1_apart_x_3 = right_1_apart_x_left_3 - l_right_1_apart_x_right_0_apart_x*right_0_apart_x_left_3 - l_right_1_apart_x_right_0_apart_y*y_right_0_apart_y_3
    y_right_1_apart_y_3 = right_1_apart_y_left_3 - l_right_1_apart_y_right_0_apart_x*right_0_apart_x_left_3 - l_right_1_apart_y_right_0_apart_y*y_right_0_apart_y_3 - l_right_1_apart_y_right_1_apart_x*y_right_1_apart_x_3
    right_1_apart_y_acc_4 = y_right_1_apart_y_3/D_right_1_apart_y
    right_1_apart_x_acc_4 = y_right_1_apart_x_3/D_right_1_apart_x - l_right_1_apart_y_right_1_apart_x*right_1_apart_y_acc_4
    right_0_apart_y_acc_4 = y_right_0_apart_y_3/D_right_0_apart_y - l_right_1_apart_x_right_0_apart_y*right_1_apart_x_acc_4 - l_right_1_apart_y_right_0_apart_y*right_1_apart_y_acc_4
    right_0_apart_x_acc_4 = right_0_apart_x_left_3/W_right_0_apart_x_raised - l_right_0_apart_y_right_0_apart_x*right_0_apart_y_acc_4 - l_right_1_apart_x_right_0_apart_x*right_1_apart_x_acc_4 - l_right_1_apart_y_right_0_apart_x*right_1_apart_y_acc_4
    right_0_apart_x_acc_5 = right_0_apart_x_acc_3 + right_0_apart_x_acc_4
    right_0_apart_y_acc_5 = right_0_apart_y_acc_3 + right_0_apart_y_acc_4
    right_1_apart_x_acc_5 = right_1_apart_x_acc_3 + right_1_apart_x_acc_4
    right_1_apart_y_acc_5 = right_1_apart_y_acc_3 + right_1_apart_y_acc_4
    foot_0_acc_4 = foot_0_acc_3 + foot_0_by_right_0_apart_x*right_0_apart_x_acc_4 + foot_0_by_right_0_apart_y*right_0_apart_y_acc_4
    foot_1_acc_4 = foot_1_acc_3 + foot_1_by_right_0_apart_x*right_0_apart_x_acc_4 + foot_1_by_right_0_apart_y*right_0_apart_y_acc_4 + foot_1_by_right_1_apart_x*right_1_apart_x_acc_4 + foot_1_by_right_1_apart_y*right_1_apart_y_acc_4
    foot_2_acc_4 = foot_2_acc_3 + foot_2_by_right_1_apart_x*right_1_apart_x_acc_4 + foot_2_by_right_1_apart_y*right_1_apart_y_acc_4
    left_0_acc_4 = left_0_acc_3 + left_0_by_right_0_apart_x*right_0_apart_x_acc_4 + left_0_by_right_0_apart_y*right_0_apart_y_acc_4
    left_1_acc_4 = left_1_acc_3 + left_1_by_right_0_apart_x*right_0_apart_x_acc_4 + left_1_by_right_0_apart_y*right_0_apart_y_acc_4 + left_1_by_right_1_apart_x*right_1_apart_x_acc_4 + left_1_by_right_1_apart_y*right_1_apart_y_acc_4
    return (ca.vertcat(foot_0_acc_4, foot_1_acc_4, foot_2_acc_4, left_0_acc_4, left_1_acc_4), ca.vertcat(),
        ca.vertcat(right_0_apart_x_acc_5, right_0_apart_y_acc_5, right_1_apart_x_acc_5, right_1_apart_y_acc_5))


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (4,): CONSTRAINTS
        dphi (4,): CONSTRAINTS [m/s]
    """
    length, post_2_arm_x = c[0], c[2]
    foot_0_angle, foot_1_angle, foot_2_angle, left_0_angle, left_1_angle = q[0], q[1], q[2], q[3], q[4]
    foot_0_speed, foot_1_speed, foot_2_speed, left_0_speed, left_1_speed = u[0], u[1], u[2], u[3], u[4]
    cos_post_0 = ca.cos(foot_0_angle)
    sin_post_0 = ca.sin(foot_0_angle)
    cos_post_1 = ca.cos(foot_1_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    cos_post_2 = ca.cos(foot_2_angle)
    sin_post_2 = ca.sin(foot_2_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    sin_beam_0 = ca.sin(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    sin_beam_1 = ca.sin(beam_1_angle)
    beam_0_arm_x = -sin_post_0*length
    beam_0_arm_y = cos_post_0*length
    beam_0_arm_rate_x = -beam_0_arm_y*foot_0_speed
    beam_0_arm_rate_y = beam_0_arm_x*foot_0_speed
    beam_0_rate_z = foot_0_speed + left_0_speed
    right_0_child_arm_x = cos_beam_0*length
    right_0_child_arm_y = sin_beam_0*length
    right_0_child_arm_rate_x = -beam_0_rate_z*right_0_child_arm_y
    right_0_child_arm_rate_y = beam_0_rate_z*right_0_child_arm_x
    right_0_parent_arm_x = -sin_post_1*length
    right_0_parent_arm_y = cos_post_1*length
    right_0_parent_arm_rate_x = -foot_1_speed*right_0_parent_arm_y
    right_0_parent_arm_rate_y = foot_1_speed*right_0_parent_arm_x
    right_0_apart_x = beam_0_arm_x + right_0_child_arm_x - right_0_parent_arm_x - length
    right_0_apart_y = beam_0_arm_y + right_0_child_arm_y - right_0_parent_arm_y
    right_0_apart_rate_x = beam_0_arm_rate_x + right_0_child_arm_rate_x - right_0_parent_arm_rate_x
    right_0_apart_rate_y = beam_0_arm_rate_y + right_0_child_arm_rate_y - right_0_parent_arm_rate_y
    beam_1_rate_z = foot_1_speed + left_1_speed
    beam_1_x = right_0_parent_arm_x + length
    right_1_child_arm_x = cos_beam_1*length
    right_1_child_arm_y = sin_beam_1*length
    right_1_child_arm_rate_x = -beam_1_rate_z*right_1_child_arm_y
    right_1_child_arm_rate_y = beam_1_rate_z*right_1_child_arm_x
    right_1_parent_arm_x = -sin_post_2*length
    right_1_parent_arm_y = cos_post_2*length
    right_1_parent_arm_rate_x = -foot_2_speed*right_1_parent_arm_y
    right_1_parent_arm_rate_y = foot_2_speed*right_1_parent_arm_x
    right_1_apart_x = beam_1_x + right_1_child_arm_x - post_2_arm_x - right_1_parent_arm_x
    right_1_apart_y = right_0_parent_arm_y + right_1_child_arm_y - right_1_parent_arm_y
    right_1_apart_rate_x = right_0_parent_arm_rate_x + right_1_child_arm_rate_x - right_1_parent_arm_rate_x
    right_1_apart_rate_y = right_0_parent_arm_rate_y + right_1_child_arm_rate_y - right_1_parent_arm_rate_y
    return (ca.vertcat(right_0_apart_x, right_0_apart_y, right_1_apart_x, right_1_apart_y),
        ca.vertcat(right_0_apart_rate_x, right_0_apart_rate_y, right_1_apart_rate_x, right_1_apart_rate_y))


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (5,): SPEEDS
        independence (4,): CONSTRAINTS [1]
    """
    length, post_2_arm_x, beam_0_h_x, beam_0_I_z_z, beam_0_I_z_z_plus_post_0_I_z_z = c[0], c[2], c[3], c[5], c[6]
    inverse_beam_0_I_z_z, right_0_apart_x_softness, right_0_apart_y_softness, right_1_apart_x_softness = c[7], c[12], c[13], c[14]
    right_1_apart_y_softness = c[15]
    foot_0_angle, foot_1_angle, left_0_angle, left_1_angle = q[0], q[1], q[3], q[4]
    right_0_apart_x_wanted_rate, right_0_apart_y_wanted_rate, right_1_apart_x_wanted_rate = wanted[0], wanted[1], wanted[2]
    right_1_apart_y_wanted_rate = wanted[3]
    cos_post_0 = ca.cos(foot_0_angle)
    sin_post_0 = ca.sin(foot_0_angle)
    cos_post_1 = ca.cos(foot_1_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    sin_beam_0 = ca.sin(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    sin_beam_1 = ca.sin(beam_1_angle)
    beam_0_arm_x = -sin_post_0*length
    beam_0_arm_y = cos_post_0*length
    right_0_child_arm_x = cos_beam_0*length
    right_0_child_arm_y = sin_beam_0*length
    right_0_parent_arm_x = -sin_post_1*length
    right_0_parent_arm_y = cos_post_1*length
    right_0_x_on_foot_0 = -beam_0_arm_y - right_0_child_arm_y
    right_0_x_on_foot_1 = beam_0_arm_y + right_0_child_arm_y
    right_0_y_on_foot_0 = beam_0_arm_x + right_0_child_arm_x
    right_0_y_on_foot_1 = length - beam_0_arm_x - right_0_child_arm_x
    beam_1_x = right_0_parent_arm_x + length
    right_1_child_arm_x = cos_beam_1*length
    right_1_child_arm_y = sin_beam_1*length
    right_1_x_on_foot_1 = -right_0_parent_arm_y - right_1_child_arm_y
    right_1_x_on_foot_2 = right_0_parent_arm_y + right_1_child_arm_y
    right_1_y_on_foot_1 = beam_1_x + right_1_child_arm_x - length
    right_1_y_on_foot_2 = post_2_arm_x - beam_1_x - right_1_child_arm_x
    beam_0_moment_x = beam_0_h_x*cos_beam_0
    beam_0_moment_y = beam_0_h_x*sin_beam_0
    beam_1_moment_x = beam_0_h_x*cos_beam_1
    beam_1_moment_y = beam_0_h_x*sin_beam_1
    post_0_total_J_z_z = beam_0_I_z_z_plus_post_0_I_z_z + 2*beam_0_arm_x*beam_0_moment_x + 2*beam_0_arm_y*beam_0_moment_y
    post_1_total_J_z_z = beam_0_I_z_z_plus_post_0_I_z_z + 2*beam_1_moment_x*right_0_parent_arm_x + 2*beam_1_moment_y*right_0_parent_arm_y
    left_0_beam_0_torque_z = beam_0_I_z_z + beam_0_arm_x*beam_0_moment_x + beam_0_arm_y*beam_0_moment_y
    left_1_beam_1_torque_z = beam_0_I_z_z + beam_1_moment_x*right_0_parent_arm_x + beam_1_moment_y*right_0_parent_arm_y
    l_foot_1_left_1 = inverse_beam_0_I_z_z*left_1_beam_1_torque_z
    D_foot_1 = post_1_total_J_z_z - l_foot_1_left_1*left_1_beam_1_torque_z
    l_foot_0_left_0 = inverse_beam_0_I_z_z*left_0_beam_0_torque_z
    D_foot_0 = post_0_total_J_z_z - l_foot_0_left_0*left_0_beam_0_torque_z
    y_foot_2 = right_0_x_on_foot_0 + l_foot_0_left_0*right_0_child_arm_y
    foot_0_by_right_0_apart_x = y_foot_2/D_foot_0
    foot_1_by_right_0_apart_x = right_0_x_on_foot_1/D_foot_1
    left_0_by_right_0_apart_x = -foot_0_by_right_0_apart_x*l_foot_0_left_0 - inverse_beam_0_I_z_z*right_0_child_arm_y
    left_1_by_right_0_apart_x = -foot_1_by_right_0_apart_x*l_foot_1_left_1
    y_foot_3 = right_0_y_on_foot_0 - l_foot_0_left_0*right_0_child_arm_x
    foot_0_by_right_0_apart_y = y_foot_3/D_foot_0
    foot_1_by_right_0_apart_y = right_0_y_on_foot_1/D_foot_1
    left_0_by_right_0_apart_y = inverse_beam_0_I_z_z*right_0_child_arm_x - foot_0_by_right_0_apart_y*l_foot_0_left_0
    left_1_by_right_0_apart_y = -foot_1_by_right_0_apart_y*l_foot_1_left_1
    y_foot_4 = right_1_x_on_foot_1 + l_foot_1_left_1*right_1_child_arm_y
    foot_1_by_right_1_apart_x = y_foot_4/D_foot_1
    foot_2_by_right_1_apart_x = inverse_beam_0_I_z_z*right_1_x_on_foot_2
    left_1_by_right_1_apart_x = -foot_1_by_right_1_apart_x*l_foot_1_left_1 - inverse_beam_0_I_z_z*right_1_child_arm_y
    y_foot_5 = right_1_y_on_foot_1 - l_foot_1_left_1*right_1_child_arm_x
    foot_1_by_right_1_apart_y = y_foot_5/D_foot_1
    foot_2_by_right_1_apart_y = inverse_beam_0_I_z_z*right_1_y_on_foot_2
    left_1_by_right_1_apart_y = inverse_beam_0_I_z_z*right_1_child_arm_x - foot_1_by_right_1_apart_y*l_foot_1_left_1
    W_right_0_apart_x_right_0_apart_x = foot_0_by_right_0_apart_x*right_0_x_on_foot_0 + foot_1_by_right_0_apart_x*right_0_x_on_foot_1 - left_0_by_right_0_apart_x*right_0_child_arm_y
    W_right_0_apart_y_right_0_apart_x = foot_0_by_right_0_apart_x*right_0_y_on_foot_0 + foot_1_by_right_0_apart_x*right_0_y_on_foot_1 + left_0_by_right_0_apart_x*right_0_child_arm_x
    W_right_0_apart_y_right_0_apart_y = foot_0_by_right_0_apart_y*right_0_y_on_foot_0 + foot_1_by_right_0_apart_y*right_0_y_on_foot_1 + left_0_by_right_0_apart_y*right_0_child_arm_x
    W_right_1_apart_x_right_0_apart_x = foot_1_by_right_0_apart_x*right_1_x_on_foot_1 - left_1_by_right_0_apart_x*right_1_child_arm_y
    W_right_1_apart_x_right_0_apart_y = foot_1_by_right_0_apart_y*right_1_x_on_foot_1 - left_1_by_right_0_apart_y*right_1_child_arm_y
    W_right_1_apart_x_right_1_apart_x = foot_1_by_right_1_apart_x*right_1_x_on_foot_1 + foot_2_by_right_1_apart_x*right_1_x_on_foot_2 - left_1_by_right_1_apart_x*right_1_child_arm_y
    W_right_1_apart_y_right_0_apart_x = foot_1_by_right_0_apart_x*right_1_y_on_foot_1 + left_1_by_right_0_apart_x*right_1_child_arm_x
    W_right_1_apart_y_right_0_apart_y = foot_1_by_right_0_apart_y*right_1_y_on_foot_1 + left_1_by_right_0_apart_y*right_1_child_arm_x
    W_right_1_apart_y_right_1_apart_x = foot_1_by_right_1_apart_x*right_1_y_on_foot_1 + foot_2_by_right_1_apart_x*right_1_y_on_foot_2 + left_1_by_right_1_apart_x*right_1_child_arm_x
    W_right_1_apart_y_right_1_apart_y = foot_1_by_right_1_apart_y*right_1_y_on_foot_1 + foot_2_by_right_1_apart_y*right_1_y_on_foot_2 + left_1_by_right_1_apart_y*right_1_child_arm_x
    right_0_apart_size = W_right_0_apart_x_right_0_apart_x + W_right_0_apart_y_right_0_apart_y
    W_right_0_apart_x_raised = W_right_0_apart_x_right_0_apart_x + right_0_apart_size*right_0_apart_x_softness
    W_right_0_apart_y_raised = W_right_0_apart_y_right_0_apart_y + right_0_apart_size*right_0_apart_y_softness
    right_1_apart_size = W_right_1_apart_x_right_1_apart_x + W_right_1_apart_y_right_1_apart_y
    W_right_1_apart_x_raised = W_right_1_apart_x_right_1_apart_x + right_1_apart_size*right_1_apart_x_softness
    W_right_1_apart_y_raised = W_right_1_apart_y_right_1_apart_y + right_1_apart_size*right_1_apart_y_softness
    l_right_0_apart_y_right_0_apart_x = W_right_0_apart_y_right_0_apart_x/W_right_0_apart_x_raised
    D_right_0_apart_y = W_right_0_apart_y_raised - W_right_0_apart_y_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_x_right_0_apart_x = W_right_1_apart_x_right_0_apart_x/W_right_0_apart_x_raised
    L_right_1_apart_x_right_0_apart_y = W_right_1_apart_x_right_0_apart_y - W_right_1_apart_x_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_x_right_0_apart_y = L_right_1_apart_x_right_0_apart_y/D_right_0_apart_y
    D_right_1_apart_x = W_right_1_apart_x_raised - L_right_1_apart_x_right_0_apart_y*l_right_1_apart_x_right_0_apart_y - W_right_1_apart_x_right_0_apart_x*l_right_1_apart_x_right_0_apart_x
    l_right_1_apart_y_right_0_apart_x = W_right_1_apart_y_right_0_apart_x/W_right_0_apart_x_raised
    L_right_1_apart_y_right_0_apart_y = W_right_1_apart_y_right_0_apart_y - W_right_1_apart_y_right_0_apart_x*l_right_0_apart_y_right_0_apart_x
    l_right_1_apart_y_right_0_apart_y = L_right_1_apart_y_right_0_apart_y/D_right_0_apart_y
    L_right_1_apart_y_right_1_apart_x = W_right_1_apart_y_right_1_apart_x - L_right_1_apart_y_right_0_apart_y*l_right_1_apart_x_right_0_apart_y - W_right_1_apart_y_right_0_apart_x*l_right_1_apart_x_right_0_apart_x
    l_right_1_apart_y_right_1_apart_x = L_right_1_apart_y_right_1_apart_x/D_right_1_apart_x
    D_right_1_apart_y = W_right_1_apart_y_raised - L_right_1_apart_y_right_0_apart_y*l_right_1_apart_y_right_0_apart_y - L_right_1_apart_y_right_1_apart_x*l_right_1_apart_y_right_1_apart_x - W_right_1_apart_y_right_0_apart_x*l_right_1_apart_y_right_0_apart_x
    y_right_0_apart_y_4 = right_0_apart_y_wanted_rate - l_right_0_apart_y_right_0_apart_x*right_0_apart_x_wanted_rate
    y_right_1_apart_x_4 = right_1_apart_x_wanted_rate - l_right_1_apart_x_right_0_apart_x*right_0_apart_x_wanted_rate - l_right_1_apart_x_right_0_apart_y*y_right_0_apart_y_4
    y_right_1_apart_y_4 = right_1_apart_y_wanted_rate - l_right_1_apart_y_right_0_apart_x*right_0_apart_x_wanted_rate - l_right_1_apart_y_right_0_apart_y*y_right_0_apart_y_4 - l_right_1_apart_y_right_1_apart_x*y_right_1_apart_x_4
    right_1_apart_y_push = y_right_1_apart_y_4/D_right_1_apart_y
    right_1_apart_x_push = y_right_1_apart_x_4/D_right_1_apart_x - l_right_1_apart_y_right_1_apart_x*right_1_apart_y_push
    right_0_apart_y_push = y_right_0_apart_y_4/D_right_0_apart_y - l_right_1_apart_x_right_0_apart_y*right_1_apart_x_push - l_right_1_apart_y_right_0_apart_y*right_1_apart_y_push
    right_0_apart_x_push = right_0_apart_x_wanted_rate/W_right_0_apart_x_raised - l_right_0_apart_y_right_0_apart_x*right_0_apart_y_push - l_right_1_apart_x_right_0_apart_x*right_1_apart_x_push - l_right_1_apart_y_right_0_apart_x*right_1_apart_y_push
    left_1_push = left_1_by_right_0_apart_x*right_0_apart_x_push + left_1_by_right_0_apart_y*right_0_apart_y_push + left_1_by_right_1_apart_x*right_1_apart_x_push + left_1_by_right_1_apart_y*right_1_apart_y_push
    left_0_push = left_0_by_right_0_apart_x*right_0_apart_x_push + left_0_by_right_0_apart_y*right_0_apart_y_push
    foot_2_push = foot_2_by_right_1_apart_x*right_1_apart_x_push + foot_2_by_right_1_apart_y*right_1_apart_y_push
    foot_1_push = foot_1_by_right_0_apart_x*right_0_apart_x_push + foot_1_by_right_0_apart_y*right_0_apart_y_push + foot_1_by_right_1_apart_x*right_1_apart_x_push + foot_1_by_right_1_apart_y*right_1_apart_y_push
    foot_0_push = foot_0_by_right_0_apart_x*right_0_apart_x_push + foot_0_by_right_0_apart_y*right_0_apart_y_push
    right_0_apart_x_left_4 = right_0_apart_x_wanted_rate + left_0_push*right_0_child_arm_y - foot_0_push*right_0_x_on_foot_0 - foot_1_push*right_0_x_on_foot_1
    right_0_apart_y_left_4 = right_0_apart_y_wanted_rate - foot_0_push*right_0_y_on_foot_0 - foot_1_push*right_0_y_on_foot_1 - left_0_push*right_0_child_arm_x
    right_1_apart_x_left_4 = right_1_apart_x_wanted_rate + left_1_push*right_1_child_arm_y - foot_1_push*right_1_x_on_foot_1 - foot_2_push*right_1_x_on_foot_2
    right_1_apart_y_left_4 = right_1_apart_y_wanted_rate - foot_1_push*right_1_y_on_foot_1 - foot_2_push*right_1_y_on_foot_2 - left_1_push*right_1_child_arm_x
    y_right_0_apart_y_5 = right_0_apart_y_left_4 - l_right_0_apart_y_right_0_apart_x*right_0_apart_x_left_4
    y_right_1_apart_x_5 = right_1_apart_x_left_4 - l_right_1_apart_x_right_0_apart_x*right_0_apart_x_left_4 - l_right_1_apart_x_right_0_apart_y*y_right_0_apart_y_5
    y_right_1_apart_y_5 = right_1_apart_y_left_4 - l_right_1_apart_y_right_0_apart_x*right_0_apart_x_left_4 - l_right_1_apart_y_right_0_apart_y*y_right_0_apart_y_5 - l_right_1_apart_y_right_1_apart_x*y_right_1_apart_x_5
    right_1_apart_y_push_2 = y_right_1_apart_y_5/D_right_1_apart_y
    right_1_apart_x_push_2 = y_right_1_apart_x_5/D_right_1_apart_x - l_right_1_apart_y_right_1_apart_x*right_1_apart_y_push_2
    right_0_apart_y_push_2 = y_right_0_apart_y_5/D_right_0_apart_y - l_right_1_apart_x_right_0_apart_y*right_1_apart_x_push_2 - l_right_1_apart_y_right_0_apart_y*right_1_apart_y_push_2
    right_0_apart_x_push_2 = right_0_apart_x_left_4/W_right_0_apart_x_raised - l_right_0_apart_y_right_0_apart_x*right_0_apart_y_push_2 - l_right_1_apart_x_right_0_apart_x*right_1_apart_x_push_2 - l_right_1_apart_y_right_0_apart_x*right_1_apart_y_push_2
    left_1_push_2 = left_1_push + left_1_by_right_0_apart_x*right_0_apart_x_push_2 + left_1_by_right_0_apart_y*right_0_apart_y_push_2 + left_1_by_right_1_apart_x*right_1_apart_x_push_2 + left_1_by_right_1_apart_y*right_1_apart_y_push_2
    left_0_push_2 = left_0_push + left_0_by_right_0_apart_x*right_0_apart_x_push_2 + left_0_by_right_0_apart_y*right_0_apart_y_push_2
    foot_2_push_2 = foot_2_push + foot_2_by_right_1_apart_x*right_1_apart_x_push_2 + foot_2_by_right_1_apart_y*right_1_apart_y_push_2
    foot_1_push_2 = foot_1_push + foot_1_by_right_0_apart_x*right_0_apart_x_push_2 + foot_1_by_right_0_apart_y*right_0_apart_y_push_2 + foot_1_by_right_1_apart_x*right_1_apart_x_push_2 + foot_1_by_right_1_apart_y*right_1_apart_y_push_2
    foot_0_push_2 = foot_0_push + foot_0_by_right_0_apart_x*right_0_apart_x_push_2 + foot_0_by_right_0_apart_y*right_0_apart_y_push_2
    right_0_apart_x_independence = W_right_0_apart_x_raised/right_0_apart_size
    right_0_apart_y_independence = D_right_0_apart_y/right_0_apart_size
    right_1_apart_x_independence = D_right_1_apart_x/right_1_apart_size
    right_1_apart_y_independence = D_right_1_apart_y/right_1_apart_size
    return (ca.vertcat(foot_0_push_2, foot_1_push_2, foot_2_push_2, left_0_push_2, left_1_push_2),
        ca.vertcat(right_0_apart_x_independence, right_0_apart_y_independence, right_1_apart_x_independence, right_1_apart_y_independence))


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
    length, beam_0_h_x, half_beam_0_I_z_z, half_mass, half_length, gravity_times_mass = c[0], c[3], c[8], c[9], c[10], c[11]
    foot_0_angle, foot_1_angle, foot_2_angle, left_0_angle, left_1_angle = q[0], q[1], q[2], q[3], q[4]
    foot_0_speed, foot_1_speed, foot_2_speed, left_0_speed, left_1_speed = u[0], u[1], u[2], u[3], u[4]
    cos_post_0 = ca.cos(foot_0_angle)
    sin_post_0 = ca.sin(foot_0_angle)
    cos_post_1 = ca.cos(foot_1_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    cos_post_2 = ca.cos(foot_2_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    sin_beam_0 = ca.sin(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    sin_beam_1 = ca.sin(beam_1_angle)
    beam_0_arm_x = -sin_post_0*length
    beam_0_arm_y = cos_post_0*length
    beam_0_arm_rate_x = -beam_0_arm_y*foot_0_speed
    beam_0_arm_rate_y = beam_0_arm_x*foot_0_speed
    beam_0_rate_z = foot_0_speed + left_0_speed
    right_0_parent_arm_x = -sin_post_1*length
    right_0_parent_arm_y = cos_post_1*length
    right_0_parent_arm_rate_x = -foot_1_speed*right_0_parent_arm_y
    right_0_parent_arm_rate_y = foot_1_speed*right_0_parent_arm_x
    beam_1_rate_z = foot_1_speed + left_1_speed
    beam_0_moment_x = beam_0_h_x*cos_beam_0
    beam_0_moment_y = beam_0_h_x*sin_beam_0
    beam_1_moment_x = beam_0_h_x*cos_beam_1
    beam_1_moment_y = beam_0_h_x*sin_beam_1
    kinetic = half_beam_0_I_z_z*beam_0_rate_z*beam_0_rate_z + half_beam_0_I_z_z*beam_1_rate_z*beam_1_rate_z + half_beam_0_I_z_z*foot_0_speed*foot_0_speed + half_beam_0_I_z_z*foot_1_speed*foot_1_speed + half_beam_0_I_z_z*foot_2_speed*foot_2_speed + half_mass*(beam_0_arm_rate_x*beam_0_arm_rate_x + beam_0_arm_rate_y*beam_0_arm_rate_y) + half_mass*(right_0_parent_arm_rate_x*right_0_parent_arm_rate_x + right_0_parent_arm_rate_y*right_0_parent_arm_rate_y) + beam_0_arm_rate_y*beam_0_moment_x*beam_0_rate_z + beam_1_moment_x*beam_1_rate_z*right_0_parent_arm_rate_y - beam_0_arm_rate_x*beam_0_moment_y*beam_0_rate_z - beam_1_moment_y*beam_1_rate_z*right_0_parent_arm_rate_x
    post_0_centre_arm_y = cos_post_0*half_length
    post_1_centre_arm_y = cos_post_1*half_length
    post_2_centre_arm_y = cos_post_2*half_length
    beam_0_centre_arm_y = half_length*sin_beam_0
    beam_1_centre_arm_y = half_length*sin_beam_1
    potential = gravity_times_mass*post_0_centre_arm_y + gravity_times_mass*post_1_centre_arm_y + gravity_times_mass*post_2_centre_arm_y + gravity_times_mass*(beam_0_arm_y + beam_0_centre_arm_y) + gravity_times_mass*(beam_1_centre_arm_y + right_0_parent_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (15,): post_0.x [m], post_0.y [m], post_0.z [m], post_1.x [m], post_1.y [m], post_1.z [m], post_2.x [m], post_2.y [m],
            post_2.z [m], beam_0.x [m], beam_0.y [m], beam_0.z [m], beam_1.x [m], beam_1.y [m], beam_1.z [m]
        rotations (45,): post_0.R_xx [1], post_0.R_xy [1], post_0.R_xz [1], post_0.R_yx [1], post_0.R_yy [1], post_0.R_yz [1], post_0.R_zx
            [1], post_0.R_zy [1], post_0.R_zz [1], post_1.R_xx [1], post_1.R_xy [1], post_1.R_xz [1], post_1.R_yx [1], post_1.R_yy [1],
            post_1.R_yz [1], post_1.R_zx [1], post_1.R_zy [1], post_1.R_zz [1], post_2.R_xx [1], post_2.R_xy [1], post_2.R_xz [1],
            post_2.R_yx [1], post_2.R_yy [1], post_2.R_yz [1], post_2.R_zx [1], post_2.R_zy [1], post_2.R_zz [1], beam_0.R_xx [1],
            beam_0.R_xy [1], beam_0.R_xz [1], beam_0.R_yx [1], beam_0.R_yy [1], beam_0.R_yz [1], beam_0.R_zx [1], beam_0.R_zy [1],
            beam_0.R_zz [1], beam_1.R_xx [1], beam_1.R_xy [1], beam_1.R_xz [1], beam_1.R_yx [1], beam_1.R_yy [1], beam_1.R_yz [1],
            beam_1.R_zx [1], beam_1.R_zy [1], beam_1.R_zz [1]
    """
    length, post_2_arm_x = c[0], c[2]
    foot_0_angle, foot_1_angle, foot_2_angle, left_0_angle, left_1_angle = q[0], q[1], q[2], q[3], q[4]
    cos_post_0 = ca.cos(foot_0_angle)
    sin_post_0 = ca.sin(foot_0_angle)
    cos_post_1 = ca.cos(foot_1_angle)
    sin_post_1 = ca.sin(foot_1_angle)
    cos_post_2 = ca.cos(foot_2_angle)
    sin_post_2 = ca.sin(foot_2_angle)
    beam_0_angle = foot_0_angle + left_0_angle
    cos_beam_0 = ca.cos(beam_0_angle)
    sin_beam_0 = ca.sin(beam_0_angle)
    beam_1_angle = foot_1_angle + left_1_angle
    cos_beam_1 = ca.cos(beam_1_angle)
    sin_beam_1 = ca.sin(beam_1_angle)
    beam_0_arm_x = -sin_post_0*length
    beam_0_arm_y = cos_post_0*length
    right_0_parent_arm_x = -sin_post_1*length
    right_0_parent_arm_y = cos_post_1*length
    beam_1_x = right_0_parent_arm_x + length
    return (ca.vertcat(0, 0, 0, length, 0, 0, post_2_arm_x, 0, 0, beam_0_arm_x, beam_0_arm_y, 0, beam_1_x, right_0_parent_arm_y, 0),
        ca.vertcat(cos_post_0, -sin_post_0, 0, sin_post_0, cos_post_0, 0, 0, 0, 1, cos_post_1, -sin_post_1, 0, sin_post_1, cos_post_1, 0, 0,
            0, 1, cos_post_2, -sin_post_2, 0, sin_post_2, cos_post_2, 0, 0, 0, 1, cos_beam_0, -sin_beam_0, 0, sin_beam_0, cos_beam_0, 0, 0,
            0, 1, cos_beam_1, -sin_beam_1, 0, sin_beam_1, cos_beam_1, 0, 0, 0, 1))


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
        foot_0.parent to gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        post_0.centre to beam_1.centre (3,): x [m], y [m], z [m]
    """
    length = p[1]
    x1 = length/2
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(2*length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(length, 0, 0, 0, 0, 1),
        ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(length, 0, 0, 0, 0, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, x1, 0),
        ca.vertcat(0, x1, 0), ca.vertcat(0, x1, 0), ca.vertcat(x1, 0, 0), ca.vertcat(x1, 0, 0))
