"""flyball_governor: centrifugal governor, two loops on a spindle. Generated from derive/scenes/flyball_governor.py.

Do not edit; regenerate with `hertzwerk derive flyball_governor`.
Effects:
    gravity: uniform gravity
    spring: linear spring of guide
    energy_ledger: work put in, energy dissipated per effect
Units: 567 assignments and 317 outputs checked, all consistent
Operations: flight 1519 (equations of motion and gaps)
"""

import casadi as ca

NAME = "flyball_governor"
SOURCE = "derive/scenes/flyball_governor.py"
SUMMARY = "centrifugal governor, two loops on a spindle"
FORMAT = "hertzwerk module 1"
DIGEST = "99e9e7bbb75431f29dda8b1f2a610ab5"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("spring", "spring", "linear spring of guide"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("spindle_mass", "kg", 3.0, "body spindle, mass"),
    ("spindle_inertia", "kg m^2", 0.05, "about the spindle's axis"),
    ("ball_mass", "kg", 2.0, "body right_arm, mass"),
    ("ball_radius", "m", 0.04, ""),
    ("arm_length", "m", 0.3, "hinge to ball"),
    ("rod_mass", "kg", 0.2, "body right_rod, mass"),
    ("rod_length", "m", 0.2, "hinge to hinge"),
    ("collar_mass", "kg", 1.5, "body collar, mass"),
    ("collar_inertia", "kg m^2", 0.003, "body collar, inertia"),
    ("offset", "m", 0.03, "of the hinges from the spindle's axis"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("spring_stiffness", "N/m", 400, "effect spring, stiffness"),
    ("spring_rest", "m", 0.35, "of the collar below the arms' hinges"),
    ("start_speed", "rpm", 160, "of the spindle"),
    ("start_angle", "deg", 30, "of the arms from the spindle"),
)

LIMITS = (
    ("spindle_mass", "defined", 0, None, True, False, "body spindle, mass"),
    ("spindle_inertia", "defined", 0, None, False, False, "body spindle, inertia"),
    ("ball_mass", "defined", 0, None, True, False, "body right_arm, mass"),
    ("rod_mass", "defined", 0, None, True, False, "body right_rod, mass"),
    ("collar_mass", "defined", 0, None, True, False, "body collar, mass"),
    ("collar_inertia", "defined", 0, None, False, False, "body collar, inertia"),
    ("spring_stiffness", "defined", 0, None, False, False, "effect spring, stiffness"),
    ("arm_length", "defined", 0, None, True, False, "scales, length"),
)

COORDINATES = (
    ("spindle.angle", "rad"), ("right_hinge.angle", "rad"), ("right_knee.angle", "rad"), ("left_hinge.angle", "rad"),
    ("left_knee.angle", "rad"), ("guide.travel", "m"),
)

SPEEDS = (
    ("spindle.speed", "rad/s"), ("right_hinge.speed", "rad/s"), ("right_knee.speed", "rad/s"), ("left_hinge.speed", "rad/s"),
    ("left_knee.speed", "rad/s"), ("guide.speed", "m/s"),
)

CONSTRAINTS = (
    ("right_foot.apart_x", "m"), ("right_foot.apart_y", "m"), ("right_foot.apart_z", "m"), ("left_foot.apart_x", "m"),
    ("left_foot.apart_y", "m"), ("left_foot.apart_z", "m"),
)

GIVEN = ("spindle.speed", "right_hinge.angle", "right_knee.angle", "left_hinge.angle", "left_knee.angle", "guide.travel")

BODIES = ("spindle", "right_arm", "right_rod", "left_arm", "left_rod", "collar")

LANDMARKS = (
    ("spindle", "revolute", "parent", "ground", ("axis",)), ("spindle", "revolute", "child", "spindle", ("axis",)),
    ("right_hinge", "revolute", "parent", "spindle", ("axis",)), ("right_hinge", "revolute", "child", "right_arm", ("axis",)),
    ("right_knee", "revolute", "parent", "right_arm", ("axis",)), ("right_knee", "revolute", "child", "right_rod", ("axis",)),
    ("left_hinge", "revolute", "parent", "spindle", ("axis",)), ("left_hinge", "revolute", "child", "left_arm", ("axis",)),
    ("left_knee", "revolute", "parent", "left_arm", ("axis",)), ("left_knee", "revolute", "child", "left_rod", ("axis",)),
    ("guide", "prismatic", "parent", "spindle", ("axis",)), ("guide", "prismatic", "child", "collar", ("axis",)),
    ("right_foot", "revolute", "parent", "collar", ("axis",)), ("right_foot", "revolute", "child", "right_rod", ("axis",)),
    ("left_foot", "revolute", "parent", "collar", ("axis",)), ("left_foot", "revolute", "child", "left_rod", ("axis",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("spring", "slide_spring", "parent", "spindle", ("axis",)),
    ("spring", "slide_spring", "child", "collar", ()), ("spindle", "body", "centre", "spindle", ()),
    ("right_arm", "body", "centre", "right_arm", ()), ("right_rod", "body", "centre", "right_rod", ()),
    ("left_arm", "body", "centre", "left_arm", ()), ("left_rod", "body", "centre", "left_rod", ()),
    ("collar", "body", "centre", "collar", ()),
)

CONSTANTS = (
    ("arm_length", "m"), ("rod_length", "m"), ("collar_mass", "kg"), ("offset", "m"), ("gravity", "m/s^2"), ("spring_stiffness", "N/m"),
    ("spring_rest", "m"), ("half_arm_length", "m"), ("right_rod_h_y", "kg m"), ("right_arm_h_y", "kg m"), ("right_arm_I_x_x", "kg m^2"),
    ("right_arm_I_y_y", "kg m^2"), ("right_rod_I_x_x", "kg m^2"), ("right_arm_I_x_x_minus_right_arm_I_y_y", "kg m^2"), ("k3", "m"),
    ("spindle_I_y_y_plus_collar_inertia", "kg m^2"), ("right_arm_I_x_x_plus_right_rod_I_x_x", "kg m^2"),
    ("inverse_right_rod_I_x_x", "1/(kg m^2)"), ("inverse_collar_mass", "1/kg"), ("right_arm_h_y_2", "kg m"),
    ("half_right_arm_I_x_x_2", "kg m^2"), ("half_right_arm_I_y_y", "kg m^2"), ("half_right_rod_I_x_x", "kg m^2"),
    ("half_collar_mass", "kg"), ("half_collar_inertia", "kg m^2"), ("half_spindle_inertia", "kg m^2"), ("half_ball_mass", "kg"),
    ("half_rod_mass", "kg"), ("half_rod_length", "m"), ("collar_mass_times_gravity", "N"), ("ball_mass_times_gravity", "N"),
    ("gravity_times_rod_mass", "N"), ("right_foot_apart_x_softness", "1"), ("right_foot_apart_y_softness", "1"),
    ("right_foot_apart_z_softness", "1"), ("left_foot_apart_x_softness", "1"), ("left_foot_apart_y_softness", "1"),
    ("left_foot_apart_z_softness", "1"),
)

OPERATIONS = (
    ("constants", 46), ("start", 21), ("scales", 12), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 42),
    ("accelerations", 1477), ("constraints", 141), ("projection", 822), ("ledger", 0), ("energy", 224), ("poses", 61), ("outputs", 0),
    ("landmarks", 10),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def revolute_apart_apart(W_apart_x_apart_x, y, W_apart_z_apart_x, W_apart_x_raised):
    """Return apart_x_apart_x [1], apart_y_apart [1], apart_z_apart [1]."""
    apart_x_apart_x = W_apart_x_apart_x/W_apart_x_raised
    apart_y_apart = y/W_apart_x_raised
    apart_z_apart = W_apart_z_apart_x/W_apart_x_raised
    return apart_x_apart_x, apart_y_apart, apart_z_apart


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (38,): arm_length, rod_length, collar_mass, offset, gravity, spring_stiffness, spring_rest, half_arm_length, right_rod_h_y,
            right_arm_h_y, right_arm_I_x_x, right_arm_I_y_y, right_rod_I_x_x, right_arm_I_x_x_minus_right_arm_I_y_y, k3,
            spindle_I_y_y_plus_collar_inertia, right_arm_I_x_x_plus_right_rod_I_x_x, inverse_right_rod_I_x_x, inverse_collar_mass,
            right_arm_h_y_2, half_right_arm_I_x_x_2, half_right_arm_I_y_y, half_right_rod_I_x_x, half_collar_mass, half_collar_inertia,
            half_spindle_inertia, half_ball_mass, half_rod_mass, half_rod_length, collar_mass_times_gravity, ball_mass_times_gravity,
            gravity_times_rod_mass, right_foot_apart_x_softness, right_foot_apart_y_softness, right_foot_apart_z_softness,
            left_foot_apart_x_softness, left_foot_apart_y_softness, left_foot_apart_z_softness
    """
    spindle_inertia, ball_mass, ball_radius, arm_length, rod_mass, rod_length, collar_mass = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    collar_inertia, offset, gravity, spring_stiffness, spring_rest = p[8], p[9], p[10], p[11], p[12]
    half_arm_length = arm_length/2
    right_rod_h_y = -rod_length*rod_mass/2
    right_arm_h_y_2 = -arm_length*ball_mass
    right_arm_h_y = right_arm_h_y_2 - arm_length*rod_mass/2
    right_arm_total_mass = ball_mass + rod_mass
    arm_length_squared = arm_length*arm_length
    arm_length_squared_times_ball_mass = arm_length_squared*ball_mass
    ball_radius_squared = ball_radius*ball_radius
    right_arm_I_y_y = 2*ball_radius_squared*ball_mass/5
    right_arm_I_x_x = arm_length_squared_times_ball_mass + right_arm_I_y_y + arm_length_squared*rod_mass/4
    right_rod_I_x_x = rod_length*rod_length*rod_mass/3
    right_arm_I_x_x_minus_right_arm_I_y_y = right_arm_I_x_x - right_arm_I_y_y
    k3 = 2*half_arm_length
    spindle_I_y_y = 2*right_arm_total_mass*offset*offset + spindle_inertia
    spindle_I_y_y_plus_collar_inertia = spindle_I_y_y + collar_inertia
    right_arm_I_x_x_plus_right_rod_I_x_x = right_arm_I_x_x + right_rod_I_x_x
    inverse_right_rod_I_x_x = 1/right_rod_I_x_x
    inverse_collar_mass = 1/collar_mass
    right_arm_I_x_x_2 = arm_length_squared_times_ball_mass + right_arm_I_y_y
    half_right_arm_I_x_x_2 = right_arm_I_x_x_2/2
    half_right_arm_I_y_y = right_arm_I_y_y/2
    half_right_rod_I_x_x = right_rod_I_x_x/2
    half_collar_mass = collar_mass/2
    half_collar_inertia = collar_inertia/2
    half_spindle_inertia = spindle_inertia/2
    half_ball_mass = ball_mass/2
    half_rod_mass = rod_mass/2
    half_rod_length = rod_length/2
    collar_mass_times_gravity = collar_mass*gravity
    ball_mass_times_gravity = ball_mass*gravity
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(arm_length, rod_length, collar_mass, offset, gravity, spring_stiffness, spring_rest, half_arm_length, right_rod_h_y,
        right_arm_h_y, right_arm_I_x_x, right_arm_I_y_y, right_rod_I_x_x, right_arm_I_x_x_minus_right_arm_I_y_y, k3,
        spindle_I_y_y_plus_collar_inertia, right_arm_I_x_x_plus_right_rod_I_x_x, inverse_right_rod_I_x_x, inverse_collar_mass,
        right_arm_h_y_2, half_right_arm_I_x_x_2, half_right_arm_I_y_y, half_right_rod_I_x_x, half_collar_mass, half_collar_inertia,
        half_spindle_inertia, half_ball_mass, half_rod_mass, half_rod_length, collar_mass_times_gravity, ball_mass_times_gravity,
        gravity_times_rod_mass, *[3e-09]*6)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (6,): COORDINATES
        u (6,): SPEEDS
    """
    arm_length, rod_length, start_speed, start_angle = p[4], p[6], p[13], p[14]
    sin_start_angle = ca.sin(start_angle)
    x2 = sin_start_angle*arm_length/(2*rod_length)
    x3 = ca.asin(x2)
    x4 = -x3
    x5 = x4 - start_angle
    return (ca.vertcat(0, start_angle, x5, start_angle, x5, -ca.sqrt(1 -
            sin_start_angle*sin_start_angle*arm_length*arm_length/(4*rod_length*rod_length))*rod_length - arm_length*ca.cos(start_angle)/2),
        ca.vertcat(start_speed, *[0]*5))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (6,): COORDINATES
        su (6,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    spindle_mass, ball_mass, arm_length, rod_mass, collar_mass, start_speed = p[0], p[2], p[4], p[5], p[7], p[13]
    total_mass = 2*ball_mass + 2*rod_mass + collar_mass + spindle_mass
    energy_scale = total_mass*arm_length*arm_length*start_speed*start_speed/2
    force_scale = energy_scale/arm_length
    arm_length_times_start_speed = arm_length*start_speed
    return (ca.vertcat(*[1]*5, arm_length), ca.vertcat(*[start_speed]*5, arm_length_times_start_speed), ca.vertcat(),
        ca.vertcat(arm_length, arm_length_times_start_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (6,): spindle.angle [rad/s], right_hinge.angle [rad/s], right_knee.angle [rad/s], left_hinge.angle [rad/s], left_knee.angle
            [rad/s], guide.travel [m/s]
    """
    spindle_speed, right_hinge_speed, right_knee_speed, left_hinge_speed, left_knee_speed, guide_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    return ca.vertcat(spindle_speed, right_hinge_speed, right_knee_speed, left_hinge_speed, left_knee_speed, guide_speed)


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
        f (6,): spindle [N m], right_hinge [N m], right_knee [N m], left_hinge [N m], left_knee [N m], guide [N]
    """
    collar_mass, gravity, spring_stiffness, spring_rest, right_rod_h_y, right_arm_h_y = c[2], c[4], c[5], c[6], c[8], c[9]
    right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle, guide_travel = q[1], q[2], q[3], q[4], q[5]
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    right_rod_turn = right_rod_angle - right_hinge_angle
    cos_right_rod_turn = ca.cos(right_rod_turn)
    sin_right_rod_turn = ca.sin(right_rod_turn)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    left_rod_turn = left_rod_angle - left_hinge_angle
    cos_left_rod_turn = ca.cos(left_rod_turn)
    sin_left_rod_turn = ca.sin(left_rod_turn)
    spring_stretch = guide_travel + spring_rest
    spring_force = -spring_stretch*spring_stiffness
    right_rod_moment_x = -right_rod_h_y*sin_right_rod_turn
    right_rod_moment_y = cos_right_rod_turn*right_rod_h_y
    right_arm_total_moment_y = right_arm_h_y + right_rod_moment_y
    left_rod_moment_x = right_rod_h_y*sin_left_rod_turn
    left_rod_moment_y = cos_left_rod_turn*right_rod_h_y
    left_arm_total_moment_y = left_rod_moment_y + right_arm_h_y
    right_arm_gravity_x = -sin_right_arm*gravity
    right_arm_gravity_y = -cos_right_arm*gravity
    left_arm_gravity_x = sin_left_arm*gravity
    left_arm_gravity_y = -cos_left_arm*gravity
    right_arm_gravity_y_times_right_rod_moment_x = right_arm_gravity_y*right_rod_moment_x
    minus_left_arm_gravity_y_times_left_rod_moment_x = -left_arm_gravity_y*left_rod_moment_x
    return ca.vertcat(0, right_arm_gravity_y_times_right_rod_moment_x - right_arm_gravity_x*right_arm_total_moment_y,
        right_arm_gravity_y_times_right_rod_moment_x - right_arm_gravity_x*right_rod_moment_y,
        minus_left_arm_gravity_y_times_left_rod_moment_x + left_arm_gravity_x*left_arm_total_moment_y,
        minus_left_arm_gravity_y_times_left_rod_moment_x + left_arm_gravity_x*left_rod_moment_y, spring_force - collar_mass*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (6,): spindle.acceleration [rad/s^2], right_hinge.acceleration [rad/s^2], right_knee.acceleration [rad/s^2],
            left_hinge.acceleration [rad/s^2], left_knee.acceleration [rad/s^2], guide.acceleration [m/s^2]
        reactions (0,): empty
        multipliers (6,): CONSTRAINTS [N]
    """
    rod_length, offset, half_arm_length, right_rod_h_y, right_arm_h_y, right_arm_I_x_x = c[1], c[3], c[7], c[8], c[9], c[10]
    right_arm_I_y_y, right_rod_I_x_x, right_arm_I_x_x_minus_right_arm_I_y_y, k3 = c[11], c[12], c[13], c[14]
    spindle_I_y_y_plus_collar_inertia, right_arm_I_x_x_plus_right_rod_I_x_x, inverse_right_rod_I_x_x = c[15], c[16], c[17]
    inverse_collar_mass, right_foot_apart_x_softness, right_foot_apart_y_softness, right_foot_apart_z_softness = c[18], c[32], c[33], c[34]
    left_foot_apart_x_softness, left_foot_apart_y_softness, left_foot_apart_z_softness = c[35], c[36], c[37]
    spindle_angle, right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle = q[0], q[1], q[2], q[3], q[4]
    spindle_speed, right_hinge_speed, right_knee_speed, left_hinge_speed, left_knee_speed = u[0], u[1], u[2], u[3], u[4]
    spindle_force, right_hinge_force, right_knee_force, left_hinge_force, left_knee_force, guide_force = f[0], f[1], f[2], f[3], f[4], f[5]
    cos_spindle = ca.cos(spindle_angle)
    sin_spindle = ca.sin(spindle_angle)
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    cos_right_rod = ca.cos(right_rod_angle)
    sin_right_rod = ca.sin(right_rod_angle)
    right_rod_turn = right_rod_angle - right_hinge_angle
    cos_right_rod_turn = ca.cos(right_rod_turn)
    sin_right_rod_turn = ca.sin(right_rod_turn)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    cos_left_rod = ca.cos(left_rod_angle)
    sin_left_rod = ca.sin(left_rod_angle)
    left_rod_turn = left_rod_angle - left_hinge_angle
    cos_left_rod_turn = ca.cos(left_rod_turn)
    sin_left_rod_turn = ca.sin(left_rod_turn)
    right_arm_arm_x = cos_spindle*offset
    right_arm_arm_z = -sin_spindle*offset
    right_arm_arm_rate_x = right_arm_arm_z*spindle_speed
    right_arm_arm_rate_z = -right_arm_arm_x*spindle_speed
    right_arm_turning_x = right_hinge_speed*sin_spindle
    right_arm_turning_z = cos_spindle*right_hinge_speed
    right_arm_R_x_y = -cos_spindle*sin_right_arm
    right_arm_R_z_y = sin_right_arm*sin_spindle
    right_rod_arm_x = -half_arm_length*right_arm_R_x_y
    right_rod_arm_y = -cos_right_arm*half_arm_length
    right_rod_arm_z = -half_arm_length*right_arm_R_z_y
    right_rod_arm_rate_x = right_rod_arm_z*spindle_speed - right_arm_turning_z*right_rod_arm_y
    right_rod_arm_rate_y = right_arm_turning_z*right_rod_arm_x - right_arm_turning_x*right_rod_arm_z
    right_rod_arm_rate_z = right_arm_turning_x*right_rod_arm_y - right_rod_arm_x*spindle_speed
    right_rod_turning_x = right_knee_speed*sin_spindle
    right_rod_turning_z = cos_spindle*right_knee_speed
    right_rod_rate_x = right_arm_turning_x + right_rod_turning_x
    right_rod_rate_z = right_arm_turning_z + right_rod_turning_z
    right_rod_x = right_arm_arm_x + right_rod_arm_x
    right_rod_z = right_arm_arm_z + right_rod_arm_z
    right_rod_R_x_y = -cos_spindle*sin_right_rod
    right_rod_R_z_y = sin_right_rod*sin_spindle
    right_arm_angular_bias_x = right_arm_turning_z*spindle_speed
    right_arm_angular_bias_z = -right_arm_turning_x*spindle_speed
    right_arm_bias_x = right_arm_arm_rate_z*spindle_speed
    right_arm_bias_z = -right_arm_arm_rate_x*spindle_speed
    right_rod_angular_bias_x = right_arm_angular_bias_x + right_rod_turning_z*spindle_speed
    right_rod_angular_bias_y = right_arm_turning_z*right_rod_turning_x - right_arm_turning_x*right_rod_turning_z
    right_rod_angular_bias_z = right_arm_angular_bias_z - right_rod_turning_x*spindle_speed
    right_rod_bias_x = right_arm_bias_x + right_rod_arm_rate_z*spindle_speed - right_arm_angular_bias_z*right_rod_arm_y - right_arm_turning_z*right_rod_arm_rate_y
    right_rod_bias_y = right_arm_angular_bias_z*right_rod_arm_x + right_arm_turning_z*right_rod_arm_rate_x - right_arm_angular_bias_x*right_rod_arm_z - right_arm_turning_x*right_rod_arm_rate_z
    right_rod_bias_z = right_arm_bias_z + right_arm_angular_bias_x*right_rod_arm_y + right_arm_turning_x*right_rod_arm_rate_y - right_rod_arm_rate_x*spindle_speed
    right_foot_child_arm_x = -right_rod_R_x_y*rod_length
    right_foot_child_arm_y = -cos_right_rod*rod_length
    right_foot_child_arm_z = -right_rod_R_z_y*rod_length
    right_foot_child_arm_rate_x = right_foot_child_arm_z*spindle_speed - right_foot_child_arm_y*right_rod_rate_z
    right_foot_child_arm_rate_y = right_foot_child_arm_x*right_rod_rate_z - right_foot_child_arm_z*right_rod_rate_x
    right_foot_child_arm_rate_z = right_foot_child_arm_y*right_rod_rate_x - right_foot_child_arm_x*spindle_speed
    right_foot_apart_bias_x = right_rod_bias_x + right_foot_child_arm_rate_z*spindle_speed + right_foot_child_arm_z*right_rod_angular_bias_y - right_arm_arm_rate_z*spindle_speed - right_foot_child_arm_rate_y*right_rod_rate_z - right_foot_child_arm_y*right_rod_angular_bias_z
    right_foot_apart_bias_y = right_rod_bias_y + right_foot_child_arm_rate_x*right_rod_rate_z + right_foot_child_arm_x*right_rod_angular_bias_z - right_foot_child_arm_rate_z*right_rod_rate_x - right_foot_child_arm_z*right_rod_angular_bias_x
    right_foot_apart_bias_z = right_rod_bias_z + right_arm_arm_rate_x*spindle_speed + right_foot_child_arm_rate_y*right_rod_rate_x + right_foot_child_arm_y*right_rod_angular_bias_x - right_foot_child_arm_rate_x*spindle_speed - right_foot_child_arm_x*right_rod_angular_bias_y
    right_foot_child_arm_y_plus_right_rod_arm_y = right_foot_child_arm_y + right_rod_arm_y
    right_foot_x_on_right_hinge = -cos_spindle*right_foot_child_arm_y_plus_right_rod_arm_y
    right_foot_x_on_right_knee = -cos_spindle*right_foot_child_arm_y
    right_foot_y_on_right_hinge = cos_spindle*(right_foot_child_arm_x + right_rod_x - right_arm_arm_x) - sin_spindle*(right_foot_child_arm_z + right_rod_z - right_arm_arm_z)
    right_foot_y_on_right_knee = cos_spindle*right_foot_child_arm_x - right_foot_child_arm_z*sin_spindle
    right_foot_z_on_right_hinge = sin_spindle*right_foot_child_arm_y_plus_right_rod_arm_y
    right_foot_z_on_right_knee = right_foot_child_arm_y*sin_spindle
    left_arm_arm_z = sin_spindle*offset
    left_arm_arm_rate_x = left_arm_arm_z*spindle_speed
    left_arm_arm_rate_z = right_arm_arm_x*spindle_speed
    left_arm_turning_x = -left_hinge_speed*sin_spindle
    left_arm_turning_z = -cos_spindle*left_hinge_speed
    left_arm_R_x_y = cos_spindle*sin_left_arm
    left_arm_R_z_y = -sin_left_arm*sin_spindle
    left_rod_arm_x = -half_arm_length*left_arm_R_x_y
    left_rod_arm_y = -cos_left_arm*half_arm_length
    left_rod_arm_z = -half_arm_length*left_arm_R_z_y
    left_rod_arm_rate_x = left_rod_arm_z*spindle_speed - left_arm_turning_z*left_rod_arm_y
    left_rod_arm_rate_y = left_arm_turning_z*left_rod_arm_x - left_arm_turning_x*left_rod_arm_z
    left_rod_arm_rate_z = left_arm_turning_x*left_rod_arm_y - left_rod_arm_x*spindle_speed
    left_rod_turning_x = -left_knee_speed*sin_spindle
    left_rod_turning_z = -cos_spindle*left_knee_speed
    left_rod_rate_x = left_arm_turning_x + left_rod_turning_x
    left_rod_rate_z = left_arm_turning_z + left_rod_turning_z
    left_rod_x = left_rod_arm_x - right_arm_arm_x
    left_rod_z = left_arm_arm_z + left_rod_arm_z
    left_rod_R_x_y = cos_spindle*sin_left_rod
    left_rod_R_z_y = -sin_left_rod*sin_spindle
    left_arm_angular_bias_x = left_arm_turning_z*spindle_speed
    left_arm_angular_bias_z = -left_arm_turning_x*spindle_speed
    left_arm_bias_x = left_arm_arm_rate_z*spindle_speed
    left_arm_bias_z = -left_arm_arm_rate_x*spindle_speed
    left_rod_angular_bias_x = left_arm_angular_bias_x + left_rod_turning_z*spindle_speed
    left_rod_angular_bias_y = left_arm_turning_z*left_rod_turning_x - left_arm_turning_x*left_rod_turning_z
    left_rod_angular_bias_z = left_arm_angular_bias_z - left_rod_turning_x*spindle_speed
    left_rod_bias_x = left_arm_bias_x + left_rod_arm_rate_z*spindle_speed - left_arm_angular_bias_z*left_rod_arm_y - left_arm_turning_z*left_rod_arm_rate_y
    left_rod_bias_y = left_arm_angular_bias_z*left_rod_arm_x + left_arm_turning_z*left_rod_arm_rate_x - left_arm_angular_bias_x*left_rod_arm_z - left_arm_turning_x*left_rod_arm_rate_z
    left_rod_bias_z = left_arm_bias_z + left_arm_angular_bias_x*left_rod_arm_y + left_arm_turning_x*left_rod_arm_rate_y - left_rod_arm_rate_x*spindle_speed
    left_foot_child_arm_x = -left_rod_R_x_y*rod_length
    left_foot_child_arm_y = -cos_left_rod*rod_length
    left_foot_child_arm_z = -left_rod_R_z_y*rod_length
    left_foot_child_arm_rate_x = left_foot_child_arm_z*spindle_speed - left_foot_child_arm_y*left_rod_rate_z
    left_foot_child_arm_rate_y = left_foot_child_arm_x*left_rod_rate_z - left_foot_child_arm_z*left_rod_rate_x
    left_foot_child_arm_rate_z = left_foot_child_arm_y*left_rod_rate_x - left_foot_child_arm_x*spindle_speed
    left_foot_apart_bias_x = left_rod_bias_x + left_foot_child_arm_rate_z*spindle_speed + left_foot_child_arm_z*left_rod_angular_bias_y - left_arm_arm_rate_z*spindle_speed - left_foot_child_arm_rate_y*left_rod_rate_z - left_foot_child_arm_y*left_rod_angular_bias_z
    left_foot_apart_bias_y = left_rod_bias_y + left_foot_child_arm_rate_x*left_rod_rate_z + left_foot_child_arm_x*left_rod_angular_bias_z - left_foot_child_arm_rate_z*left_rod_rate_x - left_foot_child_arm_z*left_rod_angular_bias_x
    left_foot_apart_bias_z = left_rod_bias_z + left_arm_arm_rate_x*spindle_speed + left_foot_child_arm_rate_y*left_rod_rate_x + left_foot_child_arm_y*left_rod_angular_bias_x - left_foot_child_arm_rate_x*spindle_speed - left_foot_child_arm_x*left_rod_angular_bias_y
    left_foot_child_arm_y_plus_left_rod_arm_y = left_foot_child_arm_y + left_rod_arm_y
    left_foot_x_on_left_hinge = cos_spindle*left_foot_child_arm_y_plus_left_rod_arm_y
    left_foot_x_on_left_knee = cos_spindle*left_foot_child_arm_y
    left_foot_y_on_left_hinge = sin_spindle*(left_foot_child_arm_z + left_rod_z - left_arm_arm_z) - cos_spindle*(left_foot_child_arm_x + left_rod_x + right_arm_arm_x)
    left_foot_y_on_left_knee = left_foot_child_arm_z*sin_spindle - cos_spindle*left_foot_child_arm_x
    left_foot_z_on_left_hinge = -sin_spindle*left_foot_child_arm_y_plus_left_rod_arm_y
    left_foot_z_on_left_knee = -left_foot_child_arm_y*sin_spindle
    right_rod_moment_x = -right_rod_h_y*sin_right_rod_turn
    right_rod_moment_y = cos_right_rod_turn*right_rod_h_y
    right_arm_total_moment_y = right_arm_h_y + right_rod_moment_y
    left_rod_moment_x = right_rod_h_y*sin_left_rod_turn
    left_rod_moment_y = cos_left_rod_turn*right_rod_h_y
    left_arm_total_moment_y = left_rod_moment_y + right_arm_h_y
    spindle_rate_yy = spindle_speed*spindle_speed
    right_arm_w_x = sin_right_arm*spindle_speed
    right_arm_w_y = cos_right_arm*spindle_speed
    right_arm_angular_bias_x_2 = right_arm_w_y*right_hinge_speed
    right_arm_angular_bias_y = -right_arm_w_x*right_hinge_speed
    right_rod_rate_z_2 = right_hinge_speed + right_knee_speed
    right_rod_angular_bias_x_2 = right_arm_angular_bias_x_2 + right_arm_w_y*right_knee_speed
    right_rod_angular_bias_y_2 = right_arm_angular_bias_y - right_arm_w_x*right_knee_speed
    right_rod_rate_yy = right_arm_w_y*right_arm_w_y
    right_rod_rate_zz = right_rod_rate_z_2*right_rod_rate_z_2
    right_rod_U_x_x = -right_rod_rate_yy - right_rod_rate_zz
    right_rod_rate_xy = right_arm_w_x*right_arm_w_y
    right_rod_rate_xx = right_arm_w_x*right_arm_w_x
    right_rod_U_y_y = -right_rod_rate_xx - right_rod_rate_zz
    right_rod_rate_zx = right_arm_w_x*right_rod_rate_z_2
    right_rod_U_z_x = right_rod_rate_zx - right_rod_angular_bias_y_2
    right_rod_rate_zy = right_arm_w_y*right_rod_rate_z_2
    right_rod_U_z_y = right_rod_angular_bias_x_2 + right_rod_rate_zy
    right_rod_force_x = right_rod_U_x_x*right_rod_moment_x + right_rod_moment_y*right_rod_rate_xy
    right_rod_force_y = right_rod_U_y_y*right_rod_moment_y + right_rod_moment_x*right_rod_rate_xy
    right_rod_force_z = right_rod_U_z_x*right_rod_moment_x + right_rod_U_z_y*right_rod_moment_y
    right_arm_rate_zz = right_hinge_speed*right_hinge_speed
    right_arm_U_y_y = -right_arm_rate_zz - right_rod_rate_xx
    right_arm_U_z_y = 2*right_arm_angular_bias_x_2
    right_arm_force_x = right_rod_force_x + right_arm_h_y*right_rod_rate_xy
    right_arm_force_y = right_rod_force_y + right_arm_U_y_y*right_arm_h_y
    right_arm_force_z = right_rod_force_z + right_arm_U_z_y*right_arm_h_y
    cos_right_arm_times_right_arm_force_x = cos_right_arm*right_arm_force_x
    minus_right_arm_force_y_times_sin_right_arm = -right_arm_force_y*sin_right_arm
    x5 = cos_right_arm_times_right_arm_force_x + minus_right_arm_force_y_times_sin_right_arm
    right_arm_turned_force_x = cos_spindle*x5 + right_arm_force_z*sin_spindle
    right_arm_turned_force_z = cos_spindle*right_arm_force_z - sin_spindle*x5
    x6 = -cos_spindle*right_arm_arm_x*spindle_rate_yy
    x7 = -left_arm_arm_z*sin_spindle*spindle_rate_yy
    x8 = x6 + x7
    right_arm_bias_x_2 = cos_right_arm*x8
    right_arm_bias_y = -sin_right_arm*x8
    right_arm_bias_z_2 = cos_spindle*left_arm_arm_z*spindle_rate_yy - right_arm_arm_x*sin_spindle*spindle_rate_yy
    right_rod_J_swing = -right_rod_I_x_x*sin_right_rod_turn
    right_rod_J_x_x = right_rod_I_x_x + right_rod_J_swing*sin_right_rod_turn
    right_rod_J_y_y = -right_rod_J_swing*sin_right_rod_turn
    right_rod_J_x_y = -cos_right_rod_turn*right_rod_J_swing
    right_rod_bias_x_2 = right_arm_bias_x_2 - half_arm_length*right_rod_rate_xy
    right_rod_bias_y_2 = right_arm_bias_y - half_arm_length*right_arm_U_y_y
    right_rod_bias_z_2 = right_arm_bias_z_2 - half_arm_length*right_arm_U_z_y
    right_rod_torque_x = right_rod_J_x_x*right_rod_angular_bias_x_2 + right_rod_J_x_y*(right_rod_angular_bias_y_2 - right_rod_rate_zx) + right_rod_bias_z_2*right_rod_moment_y + right_rod_rate_zy*(right_rod_I_x_x - right_rod_J_y_y)
    right_rod_torque_y = right_rod_J_x_y*right_rod_U_z_y + right_rod_J_y_y*right_rod_angular_bias_y_2 + right_rod_rate_zx*(right_rod_J_x_x - right_rod_I_x_x) - right_rod_bias_z_2*right_rod_moment_x
    right_rod_torque_z = right_rod_J_x_y*(right_rod_rate_xx - right_rod_rate_yy) + right_rod_bias_y_2*right_rod_moment_x + right_rod_rate_xy*(right_rod_J_y_y - right_rod_J_x_x) - right_rod_bias_x_2*right_rod_moment_y
    right_arm_torque_x = right_rod_torque_x + right_arm_I_x_x_minus_right_arm_I_y_y*right_arm_angular_bias_x_2 + right_arm_I_x_x*right_arm_angular_bias_x_2 + right_arm_bias_z_2*right_arm_h_y - half_arm_length*right_rod_force_z
    right_arm_torque_y = right_rod_torque_y + right_arm_I_y_y*right_arm_angular_bias_y
    right_arm_torque_z = right_rod_torque_z + half_arm_length*right_rod_force_x - right_arm_I_x_x_minus_right_arm_I_y_y*right_rod_rate_xy - right_arm_bias_x_2*right_arm_h_y
    left_arm_w_x = -sin_left_arm*spindle_speed
    left_arm_w_y = cos_left_arm*spindle_speed
    left_arm_angular_bias_x_2 = -left_arm_w_y*left_hinge_speed
    left_arm_angular_bias_y = left_arm_w_x*left_hinge_speed
    left_rod_rate_z_2 = -left_hinge_speed - left_knee_speed
    left_rod_angular_bias_x_2 = left_arm_angular_bias_x_2 - left_arm_w_y*left_knee_speed
    left_rod_angular_bias_y_2 = left_arm_angular_bias_y + left_arm_w_x*left_knee_speed
    left_rod_rate_yy = left_arm_w_y*left_arm_w_y
    left_rod_rate_zz = left_rod_rate_z_2*left_rod_rate_z_2
    left_rod_U_x_x = -left_rod_rate_yy - left_rod_rate_zz
    left_rod_rate_xy = left_arm_w_x*left_arm_w_y
    left_rod_rate_xx = left_arm_w_x*left_arm_w_x
    left_rod_U_y_y = -left_rod_rate_xx - left_rod_rate_zz
    left_rod_rate_zx = left_arm_w_x*left_rod_rate_z_2
    left_rod_U_z_x = left_rod_rate_zx - left_rod_angular_bias_y_2
    left_rod_rate_zy = left_arm_w_y*left_rod_rate_z_2
    left_rod_U_z_y = left_rod_angular_bias_x_2 + left_rod_rate_zy
    left_rod_force_x = left_rod_U_x_x*left_rod_moment_x + left_rod_moment_y*left_rod_rate_xy
    left_rod_force_y = left_rod_U_y_y*left_rod_moment_y + left_rod_moment_x*left_rod_rate_xy
    left_rod_force_z = left_rod_U_z_x*left_rod_moment_x + left_rod_U_z_y*left_rod_moment_y
    left_arm_rate_zz = left_hinge_speed*left_hinge_speed
    left_arm_U_y_y = -left_arm_rate_zz - left_rod_rate_xx
    left_arm_U_z_y = 2*left_arm_angular_bias_x_2
    left_arm_force_x = left_rod_force_x + left_rod_rate_xy*right_arm_h_y
    left_arm_force_y = left_rod_force_y + left_arm_U_y_y*right_arm_h_y
    left_arm_force_z = left_rod_force_z + left_arm_U_z_y*right_arm_h_y
    cos_left_arm_times_left_arm_force_x = cos_left_arm*left_arm_force_x
    left_arm_force_y_times_sin_left_arm = left_arm_force_y*sin_left_arm
    x11 = left_arm_force_y_times_sin_left_arm + cos_left_arm_times_left_arm_force_x
    left_arm_turned_force_x = cos_spindle*x11 + left_arm_force_z*sin_spindle
    left_arm_turned_force_z = cos_spindle*left_arm_force_z - sin_spindle*x11
    x12 = cos_spindle*right_arm_arm_x*spindle_rate_yy
    x13 = left_arm_arm_z*sin_spindle*spindle_rate_yy
    x14 = x12 + x13
    left_arm_bias_x_2 = cos_left_arm*x14
    left_arm_bias_y = sin_left_arm*x14
    left_rod_J_swing = right_rod_I_x_x*sin_left_rod_turn
    left_rod_J_x_x = right_rod_I_x_x - left_rod_J_swing*sin_left_rod_turn
    left_rod_J_y_y = left_rod_J_swing*sin_left_rod_turn
    left_rod_J_x_y = -cos_left_rod_turn*left_rod_J_swing
    left_rod_bias_x_2 = left_arm_bias_x_2 - half_arm_length*left_rod_rate_xy
    left_rod_bias_y_2 = left_arm_bias_y - half_arm_length*left_arm_U_y_y
    left_rod_bias_z_2 = -right_arm_bias_z_2 - half_arm_length*left_arm_U_z_y
    left_rod_torque_x = left_rod_J_x_x*left_rod_angular_bias_x_2 + left_rod_J_x_y*(left_rod_angular_bias_y_2 - left_rod_rate_zx) + left_rod_bias_z_2*left_rod_moment_y + left_rod_rate_zy*(right_rod_I_x_x - left_rod_J_y_y)
    left_rod_torque_y = left_rod_J_x_y*left_rod_U_z_y + left_rod_J_y_y*left_rod_angular_bias_y_2 + left_rod_rate_zx*(left_rod_J_x_x - right_rod_I_x_x) - left_rod_bias_z_2*left_rod_moment_x
    left_rod_torque_z = left_rod_J_x_y*(left_rod_rate_xx - left_rod_rate_yy) + left_rod_bias_y_2*left_rod_moment_x + left_rod_rate_xy*(left_rod_J_y_y - left_rod_J_x_x) - left_rod_bias_x_2*left_rod_moment_y
    left_arm_torque_x = left_rod_torque_x + right_arm_I_x_x_minus_right_arm_I_y_y*left_arm_angular_bias_x_2 + left_arm_angular_bias_x_2*right_arm_I_x_x - half_arm_length*left_rod_force_z - right_arm_bias_z_2*right_arm_h_y
    left_arm_torque_y = left_rod_torque_y + left_arm_angular_bias_y*right_arm_I_y_y
    left_arm_torque_z = left_rod_torque_z + half_arm_length*left_rod_force_x - right_arm_I_x_x_minus_right_arm_I_y_y*left_rod_rate_xy - left_arm_bias_x_2*right_arm_h_y
    spindle_torque_y = cos_left_arm*left_arm_torque_y + cos_right_arm*right_arm_torque_y + left_arm_arm_z*left_arm_turned_force_x + left_arm_turned_force_z*right_arm_arm_x + right_arm_torque_x*sin_right_arm - left_arm_arm_z*right_arm_turned_force_x - left_arm_torque_x*sin_left_arm - right_arm_arm_x*right_arm_turned_force_z
    spindle_net = spindle_force - spindle_torque_y
    right_hinge_net = right_hinge_force - right_arm_torque_z
    right_knee_net = right_knee_force - right_rod_torque_z
    left_hinge_net = left_arm_torque_z + left_hinge_force
    left_knee_net = left_knee_force + left_rod_torque_z
    cos_right_arm_times_right_rod_moment_x = cos_right_arm*right_rod_moment_x
    x16 = -right_arm_total_moment_y*sin_right_arm
    x17 = cos_right_arm_times_right_rod_moment_x + x16
    right_arm_turned_moment_x = cos_spindle*x17
    right_arm_turned_moment_z = -sin_spindle*x17
    cos_left_arm_times_left_rod_moment_x = cos_left_arm*left_rod_moment_x
    left_arm_total_moment_y_times_sin_left_arm = left_arm_total_moment_y*sin_left_arm
    x20 = cos_left_arm_times_left_rod_moment_x + left_arm_total_moment_y_times_sin_left_arm
    left_arm_turned_moment_x = cos_spindle*x20
    left_arm_turned_moment_z = -sin_spindle*x20
    right_arm_total_J_x_y = right_rod_J_x_y + half_arm_length*right_rod_moment_x
    right_arm_total_J_y_y = right_arm_I_y_y + right_rod_J_y_y
    x21 = -k3*right_rod_moment_y
    right_arm_total_J_x_x = right_arm_I_x_x + right_rod_J_x_x + x21
    right_arm_turned_J_swing = sin_right_arm*(right_arm_total_J_y_y - right_arm_total_J_x_x) - 2*cos_right_arm*right_arm_total_J_x_y
    left_arm_total_J_x_y = left_rod_J_x_y + half_arm_length*left_rod_moment_x
    left_arm_total_J_y_y = left_rod_J_y_y + right_arm_I_y_y
    x22 = -k3*left_rod_moment_y
    left_arm_total_J_x_x = left_rod_J_x_x + right_arm_I_x_x + x22
    left_arm_turned_J_swing = -sin_left_arm*(left_arm_total_J_y_y - left_arm_total_J_x_x) - 2*cos_left_arm*left_arm_total_J_x_y
    right_arm_turned_J_y_y = right_arm_total_J_y_y - right_arm_turned_J_swing*sin_right_arm
    left_arm_turned_J_y_y = left_arm_total_J_y_y + left_arm_turned_J_swing*sin_left_arm
    spindle_total_J_y_y = spindle_I_y_y_plus_collar_inertia + left_arm_turned_J_y_y + right_arm_turned_J_y_y + 2*left_arm_arm_z*left_arm_turned_moment_z + 2*right_arm_arm_x*right_arm_turned_moment_x - 2*left_arm_arm_z*right_arm_turned_moment_z - 2*left_arm_turned_moment_x*right_arm_arm_x
    right_arm_total_J_z_z = right_arm_I_x_x_plus_right_rod_I_x_x + x21
    x23 = -cos_right_arm*right_arm_total_moment_y
    minus_right_rod_moment_x_times_sin_right_arm = -right_rod_moment_x*sin_right_arm
    x25 = x23 + minus_right_rod_moment_x_times_sin_right_arm
    right_hinge_right_arm_force_x = cos_spindle*x25
    right_hinge_right_arm_force_z = -sin_spindle*x25
    right_hinge_right_arm_torque_y = -left_arm_arm_z*right_hinge_right_arm_force_x - right_arm_arm_x*right_hinge_right_arm_force_z
    right_knee_right_rod_torque_z = right_rod_I_x_x - half_arm_length*right_rod_moment_y
    minus_cos_right_arm_times_right_rod_moment_y = -cos_right_arm*right_rod_moment_y
    x27 = minus_right_rod_moment_x_times_sin_right_arm + minus_cos_right_arm_times_right_rod_moment_y
    right_knee_right_arm_force_x = cos_spindle*x27
    right_knee_right_arm_force_z = -sin_spindle*x27
    right_knee_right_arm_torque_y = -left_arm_arm_z*right_knee_right_arm_force_x - right_arm_arm_x*right_knee_right_arm_force_z
    left_arm_total_J_z_z = right_arm_I_x_x_plus_right_rod_I_x_x + x22
    cos_left_arm_times_left_arm_total_moment_y = cos_left_arm*left_arm_total_moment_y
    minus_left_rod_moment_x_times_sin_left_arm = -left_rod_moment_x*sin_left_arm
    x30 = cos_left_arm_times_left_arm_total_moment_y + minus_left_rod_moment_x_times_sin_left_arm
    left_hinge_left_arm_force_x = cos_spindle*x30
    left_hinge_left_arm_force_z = -sin_spindle*x30
    left_hinge_left_arm_torque_y = left_arm_arm_z*left_hinge_left_arm_force_x + left_hinge_left_arm_force_z*right_arm_arm_x
    left_knee_left_rod_torque_z = half_arm_length*left_rod_moment_y - right_rod_I_x_x
    cos_left_arm_times_left_rod_moment_y = cos_left_arm*left_rod_moment_y
    x32 = minus_left_rod_moment_x_times_sin_left_arm + cos_left_arm_times_left_rod_moment_y
    left_knee_left_arm_force_x = cos_spindle*x32
    left_knee_left_arm_force_z = -sin_spindle*x32
    left_knee_left_arm_torque_y = left_arm_arm_z*left_knee_left_arm_force_x + left_knee_left_arm_force_z*right_arm_arm_x
    l_left_hinge_left_knee = -inverse_right_rod_I_x_x*left_knee_left_rod_torque_z
    D_left_hinge = left_arm_total_J_z_z + l_left_hinge_left_knee*left_knee_left_rod_torque_z
    l_right_hinge_right_knee = inverse_right_rod_I_x_x*right_knee_right_rod_torque_z
    D_right_hinge = right_arm_total_J_z_z - l_right_hinge_right_knee*right_knee_right_rod_torque_z
    l_spindle_left_knee = inverse_right_rod_I_x_x*left_knee_left_arm_torque_y
    L_spindle_left_hinge = left_hinge_left_arm_torque_y - l_left_hinge_left_knee*left_knee_left_arm_torque_y
    l_spindle_left_hinge = L_spindle_left_hinge/D_left_hinge
    l_spindle_right_knee = inverse_right_rod_I_x_x*right_knee_right_arm_torque_y
    L_spindle_right_hinge = right_hinge_right_arm_torque_y - l_right_hinge_right_knee*right_knee_right_arm_torque_y
    l_spindle_right_hinge = L_spindle_right_hinge/D_right_hinge
    D_spindle = spindle_total_J_y_y - L_spindle_left_hinge*l_spindle_left_hinge - L_spindle_right_hinge*l_spindle_right_hinge - l_spindle_left_knee*left_knee_left_arm_torque_y - l_spindle_right_knee*right_knee_right_arm_torque_y
    y_left_hinge = left_hinge_net - l_left_hinge_left_knee*left_knee_net
    y_right_hinge = right_hinge_net - l_right_hinge_right_knee*right_knee_net
    y_spindle = spindle_net - l_spindle_left_hinge*y_left_hinge - l_spindle_left_knee*left_knee_net - l_spindle_right_hinge*y_right_hinge - l_spindle_right_knee*right_knee_net
    spindle_acc = y_spindle/D_spindle
    right_hinge_acc = y_right_hinge/D_right_hinge - l_spindle_right_hinge*spindle_acc
    right_knee_acc = inverse_right_rod_I_x_x*right_knee_net - l_right_hinge_right_knee*right_hinge_acc - l_spindle_right_knee*spindle_acc
    left_hinge_acc = y_left_hinge/D_left_hinge - l_spindle_left_hinge*spindle_acc
    left_knee_acc = inverse_right_rod_I_x_x*left_knee_net - l_left_hinge_left_knee*left_hinge_acc - l_spindle_left_knee*spindle_acc
    guide_acc = guide_force*inverse_collar_mass
    y_right_hinge_2 = right_foot_x_on_right_hinge - l_right_hinge_right_knee*right_foot_x_on_right_knee
    y_spindle_2 = -l_spindle_right_hinge*y_right_hinge_2 - l_spindle_right_knee*right_foot_x_on_right_knee
    spindle_by_right_foot_apart_x = y_spindle_2/D_spindle
    right_hinge_by_right_foot_apart_x = y_right_hinge_2/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_x
    right_knee_by_right_foot_apart_x = inverse_right_rod_I_x_x*right_foot_x_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_x - l_spindle_right_knee*spindle_by_right_foot_apart_x
    left_hinge_by_right_foot_apart_x = -l_spindle_left_hinge*spindle_by_right_foot_apart_x
    left_knee_by_right_foot_apart_x = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_x - l_spindle_left_knee*spindle_by_right_foot_apart_x
    y_right_hinge_3 = right_foot_y_on_right_hinge - l_right_hinge_right_knee*right_foot_y_on_right_knee
    y_spindle_3 = -l_spindle_right_hinge*y_right_hinge_3 - l_spindle_right_knee*right_foot_y_on_right_knee
    spindle_by_right_foot_apart_y = y_spindle_3/D_spindle
    right_hinge_by_right_foot_apart_y = y_right_hinge_3/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_y
    right_knee_by_right_foot_apart_y = inverse_right_rod_I_x_x*right_foot_y_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_y - l_spindle_right_knee*spindle_by_right_foot_apart_y
    left_hinge_by_right_foot_apart_y = -l_spindle_left_hinge*spindle_by_right_foot_apart_y
    left_knee_by_right_foot_apart_y = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_y - l_spindle_left_knee*spindle_by_right_foot_apart_y
    y_right_hinge_4 = right_foot_z_on_right_hinge - l_right_hinge_right_knee*right_foot_z_on_right_knee
    y_spindle_4 = -l_spindle_right_hinge*y_right_hinge_4 - l_spindle_right_knee*right_foot_z_on_right_knee
    spindle_by_right_foot_apart_z = y_spindle_4/D_spindle
    right_hinge_by_right_foot_apart_z = y_right_hinge_4/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_z
    right_knee_by_right_foot_apart_z = inverse_right_rod_I_x_x*right_foot_z_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_z - l_spindle_right_knee*spindle_by_right_foot_apart_z
    left_hinge_by_right_foot_apart_z = -l_spindle_left_hinge*spindle_by_right_foot_apart_z
    left_knee_by_right_foot_apart_z = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_z - l_spindle_left_knee*spindle_by_right_foot_apart_z
    y_left_hinge_2 = left_foot_x_on_left_hinge - l_left_hinge_left_knee*left_foot_x_on_left_knee
    y_spindle_5 = -l_spindle_left_hinge*y_left_hinge_2 - l_spindle_left_knee*left_foot_x_on_left_knee
    spindle_by_left_foot_apart_x = y_spindle_5/D_spindle
    right_hinge_by_left_foot_apart_x = -l_spindle_right_hinge*spindle_by_left_foot_apart_x
    right_knee_by_left_foot_apart_x = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_x - l_spindle_right_knee*spindle_by_left_foot_apart_x
    left_hinge_by_left_foot_apart_x = y_left_hinge_2/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_x
    left_knee_by_left_foot_apart_x = inverse_right_rod_I_x_x*left_foot_x_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_x - l_spindle_left_knee*spindle_by_left_foot_apart_x
    y_left_hinge_3 = left_foot_y_on_left_hinge - l_left_hinge_left_knee*left_foot_y_on_left_knee
    y_spindle_6 = -l_spindle_left_hinge*y_left_hinge_3 - l_spindle_left_knee*left_foot_y_on_left_knee
    spindle_by_left_foot_apart_y = y_spindle_6/D_spindle
    right_hinge_by_left_foot_apart_y = -l_spindle_right_hinge*spindle_by_left_foot_apart_y
    right_knee_by_left_foot_apart_y = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_y - l_spindle_right_knee*spindle_by_left_foot_apart_y
    left_hinge_by_left_foot_apart_y = y_left_hinge_3/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_y
    left_knee_by_left_foot_apart_y = inverse_right_rod_I_x_x*left_foot_y_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_y - l_spindle_left_knee*spindle_by_left_foot_apart_y
    y_left_hinge_4 = left_foot_z_on_left_hinge - l_left_hinge_left_knee*left_foot_z_on_left_knee
    y_spindle_7 = -l_spindle_left_hinge*y_left_hinge_4 - l_spindle_left_knee*left_foot_z_on_left_knee
    spindle_by_left_foot_apart_z = y_spindle_7/D_spindle
    right_hinge_by_left_foot_apart_z = -l_spindle_right_hinge*spindle_by_left_foot_apart_z
    right_knee_by_left_foot_apart_z = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_z - l_spindle_right_knee*spindle_by_left_foot_apart_z
    left_hinge_by_left_foot_apart_z = y_left_hinge_4/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_z
    left_knee_by_left_foot_apart_z = inverse_right_rod_I_x_x*left_foot_z_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_z - l_spindle_left_knee*spindle_by_left_foot_apart_z
    W_right_foot_apart_x_right_foot_apart_x = right_foot_x_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_x_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_y_right_foot_apart_x = right_foot_y_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_y_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_y_right_foot_apart_y = inverse_collar_mass + right_foot_y_on_right_hinge*right_hinge_by_right_foot_apart_y + right_foot_y_on_right_knee*right_knee_by_right_foot_apart_y
    W_right_foot_apart_z_right_foot_apart_x = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_z_right_foot_apart_y = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_y + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_y
    W_right_foot_apart_z_right_foot_apart_z = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_z + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_z
    W_left_foot_apart_x_right_foot_apart_x = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_x_right_foot_apart_y = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_x_right_foot_apart_z = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_x_left_foot_apart_x = left_foot_x_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_x_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_y_right_foot_apart_x = left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_y_right_foot_apart_y = inverse_collar_mass + left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_y_right_foot_apart_z = left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_y_left_foot_apart_x = left_foot_y_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_y_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_y_left_foot_apart_y = inverse_collar_mass + left_foot_y_on_left_hinge*left_hinge_by_left_foot_apart_y + left_foot_y_on_left_knee*left_knee_by_left_foot_apart_y
    W_left_foot_apart_z_right_foot_apart_x = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_z_right_foot_apart_y = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_z_right_foot_apart_z = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_z_left_foot_apart_x = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_z_left_foot_apart_y = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_y + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_y
    W_left_foot_apart_z_left_foot_apart_z = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_z + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_z
    right_foot_apart_size = W_right_foot_apart_x_right_foot_apart_x + W_right_foot_apart_y_right_foot_apart_y + W_right_foot_apart_z_right_foot_apart_z
    W_right_foot_apart_x_raised = W_right_foot_apart_x_right_foot_apart_x + right_foot_apart_size*right_foot_apart_x_softness
    W_right_foot_apart_y_raised = W_right_foot_apart_y_right_foot_apart_y + right_foot_apart_size*right_foot_apart_y_softness
    W_right_foot_apart_z_raised = W_right_foot_apart_z_right_foot_apart_z + right_foot_apart_size*right_foot_apart_z_softness
    left_foot_apart_size = W_left_foot_apart_x_left_foot_apart_x + W_left_foot_apart_y_left_foot_apart_y + W_left_foot_apart_z_left_foot_apart_z
    W_left_foot_apart_x_raised = W_left_foot_apart_x_left_foot_apart_x + left_foot_apart_size*left_foot_apart_x_softness
    W_left_foot_apart_y_raised = W_left_foot_apart_y_left_foot_apart_y + left_foot_apart_size*left_foot_apart_y_softness
    W_left_foot_apart_z_raised = W_left_foot_apart_z_left_foot_apart_z + left_foot_apart_size*left_foot_apart_z_softness
    l_right_foot_apart_y_right_foot_apart_x = W_right_foot_apart_y_right_foot_apart_x/W_right_foot_apart_x_raised
    D_right_foot_apart_y = W_right_foot_apart_y_raised - W_right_foot_apart_y_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_right_foot_apart_z_right_foot_apart_x = W_right_foot_apart_z_right_foot_apart_x/W_right_foot_apart_x_raised
    L_right_foot_apart_z_right_foot_apart_y = W_right_foot_apart_z_right_foot_apart_y - W_right_foot_apart_z_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_right_foot_apart_z_right_foot_apart_y = L_right_foot_apart_z_right_foot_apart_y/D_right_foot_apart_y
    D_right_foot_apart_z = W_right_foot_apart_z_raised - L_right_foot_apart_z_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_right_foot_apart_z_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    L_left_foot_apart_x_right_foot_apart_y = W_left_foot_apart_x_right_foot_apart_y - W_left_foot_apart_x_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    L_left_foot_apart_x_right_foot_apart_z = W_left_foot_apart_x_right_foot_apart_z - L_left_foot_apart_x_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_x_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_x_right_foot_apart_x, l_left_foot_apart_y_right_foot_apart_x, l_left_foot_apart_z_right_foot_apart_x = revolute_apart_apart(W_left_foot_apart_x_right_foot_apart_x, W_left_foot_apart_y_right_foot_apart_x, W_left_foot_apart_z_right_foot_apart_x, W_right_foot_apart_x_raised)
    L_left_foot_apart_z_right_foot_apart_y = W_left_foot_apart_z_right_foot_apart_y - W_left_foot_apart_z_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    L_left_foot_apart_z_right_foot_apart_z = W_left_foot_apart_z_right_foot_apart_z - L_left_foot_apart_z_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_z_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    L_left_foot_apart_y_right_foot_apart_y = W_left_foot_apart_y_right_foot_apart_y - W_left_foot_apart_y_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    L_left_foot_apart_y_right_foot_apart_z = W_left_foot_apart_y_right_foot_apart_z - L_left_foot_apart_y_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_y_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_x_right_foot_apart_z, l_left_foot_apart_y_right_foot_apart_z, l_left_foot_apart_z_right_foot_apart_z = revolute_apart_apart(L_left_foot_apart_x_right_foot_apart_z, L_left_foot_apart_y_right_foot_apart_z, L_left_foot_apart_z_right_foot_apart_z, D_right_foot_apart_z)
    l_left_foot_apart_x_right_foot_apart_y, l_left_foot_apart_y_right_foot_apart_y, l_left_foot_apart_z_right_foot_apart_y = revolute_apart_apart(L_left_foot_apart_x_right_foot_apart_y, L_left_foot_apart_y_right_foot_apart_y, L_left_foot_apart_z_right_foot_apart_y, D_right_foot_apart_y)
    D_left_foot_apart_x = W_left_foot_apart_x_raised - L_left_foot_apart_x_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_x_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_x_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    L_left_foot_apart_y_left_foot_apart_x = W_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_y_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_y_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_y_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    l_left_foot_apart_y_left_foot_apart_x = L_left_foot_apart_y_left_foot_apart_x/D_left_foot_apart_x
    D_left_foot_apart_y = W_left_foot_apart_y_raised - L_left_foot_apart_y_left_foot_apart_x*l_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_y_right_foot_apart_y*l_left_foot_apart_y_right_foot_apart_y - L_left_foot_apart_y_right_foot_apart_z*l_left_foot_apart_y_right_foot_apart_z - W_left_foot_apart_y_right_foot_apart_x*l_left_foot_apart_y_right_foot_apart_x
    L_left_foot_apart_z_left_foot_apart_x = W_left_foot_apart_z_left_foot_apart_x - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    l_left_foot_apart_z_left_foot_apart_x = L_left_foot_apart_z_left_foot_apart_x/D_left_foot_apart_x
    L_left_foot_apart_z_left_foot_apart_y = W_left_foot_apart_z_left_foot_apart_y - L_left_foot_apart_z_left_foot_apart_x*l_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_y_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_y_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_z_left_foot_apart_y = L_left_foot_apart_z_left_foot_apart_y/D_left_foot_apart_y
    D_left_foot_apart_z = W_left_foot_apart_z_raised - L_left_foot_apart_z_left_foot_apart_x*l_left_foot_apart_z_left_foot_apart_x - L_left_foot_apart_z_left_foot_apart_y*l_left_foot_apart_z_left_foot_apart_y - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_z_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_z_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_z_right_foot_apart_x
    right_foot_apart_x_left = -right_foot_apart_bias_x - right_foot_x_on_right_hinge*right_hinge_acc - right_foot_x_on_right_knee*right_knee_acc
    right_foot_apart_y_left = guide_acc - right_foot_apart_bias_y - right_foot_y_on_right_hinge*right_hinge_acc - right_foot_y_on_right_knee*right_knee_acc
    right_foot_apart_z_left = -right_foot_apart_bias_z - right_foot_z_on_right_hinge*right_hinge_acc - right_foot_z_on_right_knee*right_knee_acc
    left_foot_apart_x_left = -left_foot_apart_bias_x - left_foot_x_on_left_hinge*left_hinge_acc - left_foot_x_on_left_knee*left_knee_acc
    left_foot_apart_y_left = guide_acc - left_foot_apart_bias_y - left_foot_y_on_left_hinge*left_hinge_acc - left_foot_y_on_left_knee*left_knee_acc
    left_foot_apart_z_left = -left_foot_apart_bias_z - left_foot_z_on_left_hinge*left_hinge_acc - left_foot_z_on_left_knee*left_knee_acc
    y_right_foot_apart_y = right_foot_apart_y_left - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left
    y_right_foot_apart_z = right_foot_apart_z_left - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left - l_right_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y
    y_left_foot_apart_x = left_foot_apart_x_left - l_left_foot_apart_x_right_foot_apart_x*right_foot_apart_x_left - l_left_foot_apart_x_right_foot_apart_y*y_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_z*y_right_foot_apart_z
    y_left_foot_apart_y = left_foot_apart_y_left - l_left_foot_apart_y_left_foot_apart_x*y_left_foot_apart_x - l_left_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left - l_left_foot_apart_y_right_foot_apart_y*y_right_foot_apart_y - l_left_foot_apart_y_right_foot_apart_z*y_right_foot_apart_z
    y_left_foot_apart_z = left_foot_apart_z_left - l_left_foot_apart_z_left_foot_apart_x*y_left_foot_apart_x - l_left_foot_apart_z_left_foot_apart_y*y_left_foot_apart_y - l_left_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left - l_left_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y - l_left_foot_apart_z_right_foot_apart_z*y_right_foot_apart_z
    left_foot_apart_z_acc = y_left_foot_apart_z/D_left_foot_apart_z
    left_foot_apart_y_acc = y_left_foot_apart_y/D_left_foot_apart_y - l_left_foot_apart_z_left_foot_apart_y*left_foot_apart_z_acc
    left_foot_apart_x_acc = y_left_foot_apart_x/D_left_foot_apart_x - l_left_foot_apart_y_left_foot_apart_x*left_foot_apart_y_acc - l_left_foot_apart_z_left_foot_apart_x*left_foot_apart_z_acc
    right_foot_apart_z_acc = y_right_foot_apart_z/D_right_foot_apart_z - l_left_foot_apart_x_right_foot_apart_z*left_foot_apart_x_acc - l_left_foot_apart_y_right_foot_apart_z*left_foot_apart_y_acc - l_left_foot_apart_z_right_foot_apart_z*left_foot_apart_z_acc
    right_foot_apart_y_acc = y_right_foot_apart_y/D_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_y*left_foot_apart_x_acc - l_left_foot_apart_y_right_foot_apart_y*left_foot_apart_y_acc - l_left_foot_apart_z_right_foot_apart_y*left_foot_apart_z_acc - l_right_foot_apart_z_right_foot_apart_y*right_foot_apart_z_acc
    right_foot_apart_x_acc = right_foot_apart_x_left/W_right_foot_apart_x_raised - l_left_foot_apart_x_right_foot_apart_x*left_foot_apart_x_acc - l_left_foot_apart_y_right_foot_apart_x*left_foot_apart_y_acc - l_left_foot_apart_z_right_foot_apart_x*left_foot_apart_z_acc - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_y_acc - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_z_acc
    spindle_acc_2 = spindle_acc + left_foot_apart_x_acc*spindle_by_left_foot_apart_x + left_foot_apart_y_acc*spindle_by_left_foot_apart_y + left_foot_apart_z_acc*spindle_by_left_foot_apart_z + right_foot_apart_x_acc*spindle_by_right_foot_apart_x + right_foot_apart_y_acc*spindle_by_right_foot_apart_y + right_foot_apart_z_acc*spindle_by_right_foot_apart_z
    right_hinge_acc_2 = right_hinge_acc + left_foot_apart_x_acc*right_hinge_by_left_foot_apart_x + left_foot_apart_y_acc*right_hinge_by_left_foot_apart_y + left_foot_apart_z_acc*right_hinge_by_left_foot_apart_z + right_foot_apart_x_acc*right_hinge_by_right_foot_apart_x + right_foot_apart_y_acc*right_hinge_by_right_foot_apart_y + right_foot_apart_z_acc*right_hinge_by_right_foot_apart_z
    right_knee_acc_2 = right_knee_acc + left_foot_apart_x_acc*right_knee_by_left_foot_apart_x + left_foot_apart_y_acc*right_knee_by_left_foot_apart_y + left_foot_apart_z_acc*right_knee_by_left_foot_apart_z + right_foot_apart_x_acc*right_knee_by_right_foot_apart_x + right_foot_apart_y_acc*right_knee_by_right_foot_apart_y + right_foot_apart_z_acc*right_knee_by_right_foot_apart_z
    left_hinge_acc_2 = left_hinge_acc + left_foot_apart_x_acc*left_hinge_by_left_foot_apart_x + left_foot_apart_y_acc*left_hinge_by_left_foot_apart_y + left_foot_apart_z_acc*left_hinge_by_left_foot_apart_z + left_hinge_by_right_foot_apart_x*right_foot_apart_x_acc + left_hinge_by_right_foot_apart_y*right_foot_apart_y_acc + left_hinge_by_right_foot_apart_z*right_foot_apart_z_acc
    left_knee_acc_2 = left_knee_acc + left_foot_apart_x_acc*left_knee_by_left_foot_apart_x + left_foot_apart_y_acc*left_knee_by_left_foot_apart_y + left_foot_apart_z_acc*left_knee_by_left_foot_apart_z + left_knee_by_right_foot_apart_x*right_foot_apart_x_acc + left_knee_by_right_foot_apart_y*right_foot_apart_y_acc + left_knee_by_right_foot_apart_z*right_foot_apart_z_acc
    guide_acc_2 = guide_acc - inverse_collar_mass*left_foot_apart_y_acc - inverse_collar_mass*right_foot_apart_y_acc
    right_foot_apart_x_left_2 = -right_foot_apart_bias_x - right_foot_x_on_right_hinge*right_hinge_acc_2 - right_foot_x_on_right_knee*right_knee_acc_2
    right_foot_apart_y_left_2 = guide_acc_2 - right_foot_apart_bias_y - right_foot_y_on_right_hinge*right_hinge_acc_2 - right_foot_y_on_right_knee*right_knee_acc_2
    right_foot_apart_z_left_2 = -right_foot_apart_bias_z - right_foot_z_on_right_hinge*right_hinge_acc_2 - right_foot_z_on_right_knee*right_knee_acc_2
    left_foot_apart_x_left_2 = -left_foot_apart_bias_x - left_foot_x_on_left_hinge*left_hinge_acc_2 - left_foot_x_on_left_knee*left_knee_acc_2
    left_foot_apart_y_left_2 = guide_acc_2 - left_foot_apart_bias_y - left_foot_y_on_left_hinge*left_hinge_acc_2 - left_foot_y_on_left_knee*left_knee_acc_2
    left_foot_apart_z_left_2 = -left_foot_apart_bias_z - left_foot_z_on_left_hinge*left_hinge_acc_2 - left_foot_z_on_left_knee*left_knee_acc_2
    y_right_foot_apart_y_2 = right_foot_apart_y_left_2 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_2
    y_right_foot_apart_z_2 = right_foot_apart_z_left_2 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_2 - l_right_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_2
    y_left_foot_apart_x_2 = left_foot_apart_x_left_2 - l_left_foot_apart_x_right_foot_apart_x*right_foot_apart_x_left_2 - l_left_foot_apart_x_right_foot_apart_y*y_right_foot_apart_y_2 - l_left_foot_apart_x_right_foot_apart_z*y_right_foot_apart_z_2
    y_left_foot_apart_y_2 = left_foot_apart_y_left_2 - l_left_foot_apart_y_left_foot_apart_x*y_left_foot_apart_x_2 - l_left_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_2 - l_left_foot_apart_y_right_foot_apart_y*y_right_foot_apart_y_2 - l_left_foot_apart_y_right_foot_apart_z*y_right_foot_apart_z_2
    y_left_foot_apart_z_2 = left_foot_apart_z_left_2 - l_left_foot_apart_z_left_foot_apart_x*y_left_foot_apart_x_2 - l_left_foot_apart_z_left_foot_apart_y*y_left_foot_apart_y_2 - l_left_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_2 - l_left_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_2 - l_left_foot_apart_z_right_foot_apart_z*y_right_foot_apart_z_2
    left_foot_apart_z_acc_2 = y_left_foot_apart_z_2/D_left_foot_apart_z
    left_foot_apart_y_acc_2 = y_left_foot_apart_y_2/D_left_foot_apart_y - l_left_foot_apart_z_left_foot_apart_y*left_foot_apart_z_acc_2
    left_foot_apart_x_acc_2 = y_left_foot_apart_x_2/D_left_foot_apart_x - l_left_foot_apart_y_left_foot_apart_x*left_foot_apart_y_acc_2 - l_left_foot_apart_z_left_foot_apart_x*left_foot_apart_z_acc_2
    right_foot_apart_z_acc_2 = y_right_foot_apart_z_2/D_right_foot_apart_z - l_left_foot_apart_x_right_foot_apart_z*left_foot_apart_x_acc_2 - l_left_foot_apart_y_right_foot_apart_z*left_foot_apart_y_acc_2 - l_left_foot_apart_z_right_foot_apart_z*left_foot_apart_z_acc_2
    right_foot_apart_y_acc_2 = y_right_foot_apart_y_2/D_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_y*left_foot_apart_x_acc_2 - l_left_foot_apart_y_right_foot_apart_y*left_foot_apart_y_acc_2 - l_left_foot_apart_z_right_foot_apart_y*left_foot_apart_z_acc_2 - l_right_foot_apart_z_right_foot_apart_y*right_foot_apart_z_acc_2
    right_foot_apart_x_acc_2 = right_foot_apart_x_left_2/W_right_foot_apart_x_raised - l_left_foot_apart_x_right_foot_apart_x*left_foot_apart_x_acc_2 - l_left_foot_apart_y_right_foot_apart_x*left_foot_apart_y_acc_2 - l_left_foot_apart_z_right_foot_apart_x*left_foot_apart_z_acc_2 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_y_acc_2 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_z_acc_2
    right_foot_apart_x_acc_3 = right_foot_apart_x_acc + right_foot_apart_x_acc_2
    right_foot_apart_y_acc_3 = right_foot_apart_y_acc + right_foot_apart_y_acc_2
    right_foot_apart_z_acc_3 = right_foot_apart_z_acc + right_foot_apart_z_acc_2
    left_foot_apart_x_acc_3 = left_foot_apart_x_acc + left_foot_apart_x_acc_2
    left_foot_apart_y_acc_3 = left_foot_apart_y_acc + left_foot_apart_y_acc_2
    left_foot_apart_z_acc_3 = left_foot_apart_z_acc + left_foot_apart_z_acc_2
    spindle_acc_3 = spindle_acc_2 + left_foot_apart_x_acc_2*spindle_by_left_foot_apart_x + left_foot_apart_y_acc_2*spindle_by_left_foot_apart_y + left_foot_apart_z_acc_2*spindle_by_left_foot_apart_z + right_foot_apart_x_acc_2*spindle_by_right_foot_apart_x + right_foot_apart_y_acc_2*spindle_by_right_foot_apart_y + right_foot_apart_z_acc_2*spindle_by_right_foot_apart_z
    right_hinge_acc_3 = right_hinge_acc_2 + left_foot_apart_x_acc_2*right_hinge_by_left_foot_apart_x + left_foot_apart_y_acc_2*right_hinge_by_left_foot_apart_y + left_foot_apart_z_acc_2*right_hinge_by_left_foot_apart_z + right_foot_apart_x_acc_2*right_hinge_by_right_foot_apart_x + right_foot_apart_y_acc_2*right_hinge_by_right_foot_apart_y + right_foot_apart_z_acc_2*right_hinge_by_right_foot_apart_z
    right_knee_acc_3 = right_knee_acc_2 + left_foot_apart_x_acc_2*right_knee_by_left_foot_apart_x + left_foot_apart_y_acc_2*right_knee_by_left_foot_apart_y + left_foot_apart_z_acc_2*right_knee_by_left_foot_apart_z + right_foot_apart_x_acc_2*right_knee_by_right_foot_apart_x + right_foot_apart_y_acc_2*right_knee_by_right_foot_apart_y + right_foot_apart_z_acc_2*right_knee_by_right_foot_apart_z
    left_hinge_acc_3 = left_hinge_acc_2 + left_foot_apart_x_acc_2*left_hinge_by_left_foot_apart_x + left_foot_apart_y_acc_2*left_hinge_by_left_foot_apart_y + left_foot_apart_z_acc_2*left_hinge_by_left_foot_apart_z + left_hinge_by_right_foot_apart_x*right_foot_apart_x_acc_2 + left_hinge_by_right_foot_apart_y*right_foot_apart_y_acc_2 + left_hinge_by_right_foot_apart_z*right_foot_apart_z_acc_2
    left_knee_acc_3 = left_knee_acc_2 + left_foot_apart_x_acc_2*left_knee_by_left_foot_apart_x + left_foot_apart_y_acc_2*left_knee_by_left_foot_apart_y + left_foot_apart_z_acc_2*left_knee_by_left_foot_apart_z + left_knee_by_right_foot_apart_x*right_foot_apart_x_acc_2 + left_knee_by_right_foot_apart_y*right_foot_apart_y_acc_2 + left_knee_by_right_foot_apart_z*right_foot_apart_z_acc_2
    guide_acc_3 = guide_acc_2 - inverse_collar_mass*left_foot_apart_y_acc_2 - inverse_collar_mass*right_foot_apart_y_acc_2
    right_foot_apart_x_left_3 = -right_foot_apart_bias_x - right_foot_x_on_right_hinge*right_hinge_acc_3 - right_foot_x_on_right_knee*right_knee_acc_3
    right_foot_apart_y_left_3 = guide_acc_3 - right_foot_apart_bias_y - right_foot_y_on_right_hinge*right_hinge_acc_3 - right_foot_y_on_right_knee*right_knee_acc_3
    right_foot_apart_z_left_3 = -right_foot_apart_bias_z - right_foot_z_on_right_hinge*right_hinge_acc_3 - right_foot_z_on_right_knee*right_knee_acc_3
    left_foot_apart_x_left_3 = -left_foot_apart_bias_x - left_foot_x_on_left_hinge*left_hinge_acc_3 - left_foot_x_on_left_knee*left_knee_acc_3
    left_foot_apart_y_left_3 = guide_acc_3 - left_foot_apart_bias_y - left_foot_y_on_left_hinge*left_hinge_acc_3 - left_foot_y_on_left_knee*left_knee_acc_3
    left_foot_apart_z_left_3 = -left_foot_apart_bias_z - left_foot_z_on_left_hinge*left_hinge_acc_3 - left_foot_z_on_left_knee*left_knee_acc_3
    y_right_foot_apart_y_3 = right_foot_apart_y_left_3 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_3
    y_right_foot_apart_z_3 = right_foot_apart_z_left_3 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_3 - l_right_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_3
    y_left_foot_apart_x_3 = left_foot_apart_x_left_3 - l_left_foot_apart_x_right_foot_apart_x*right_foot_apart_x_left_3 - l_left_foot_apart_x_right_foot_apart_y*y_right_foot_apart_y_3 - l_left_foot_apart_x_right_foot_apart_z*y_right_foot_apart_z_3
    y_left_foot_apart_y_3 = left_foot_apart_y_left_3 - l_left_foot_apart_y_left_foot_apart_x*y_left_foot_apart_x_3 - l_left_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_3 - l_left_foot_apart_y_right_foot_apart_y*y_right_foot_apart_y_3 - l_left_foot_apart_y_right_foot_apart_z*y_right_foot_apart_z_3
    y_left_foot_apart_z_3 = left_foot_apart_z_left_3 - l_left_foot_apart_z_left_foot_apart_x*y_left_foot_apart_x_3 - l_left_foot_apart_z_left_foot_apart_y*y_left_foot_apart_y_3 - l_left_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_3 - l_left_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_3 - l_left_foot_apart_z_right_foot_apart_z*y_right_foot_apart_z_3
    left_foot_apart_z_acc_4 = y_left_foot_apart_z_3/D_left_foot_apart_z
    left_foot_apart_y_acc_4 = y_left_foot_apart_y_3/D_left_foot_apart_y - l_left_foot_apart_z_left_foot_apart_y*left_foot_apart_z_acc_4
    left_foot_apart_x_acc_4 = y_left_foot_apart_x_3/D_left_foot_apart_x - l_left_foot_apart_y_left_foot_apart_x*left_foot_apart_y_acc_4 - l_left_foot_apart_z_left_foot_apart_x*left_foot_apart_z_acc_4
    right_foot_apart_z_acc_4 = y_right_foot_apart_z_3/D_right_foot_apart_z - l_left_foot_apart_x_right_foot_apart_z*left_foot_apart_x_acc_4 - l_left_foot_apart_y_right_foot_apart_z*left_foot_apart_y_acc_4 - l_left_foot_apart_z_right_foot_apart_z*left_foot_apart_z_acc_4
    right_foot_apart_y_acc_4 = y_right_foot_apart_y_3/D_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_y*left_foot_apart_x_acc_4 - l_left_foot_apart_y_right_foot_apart_y*left_foot_apart_y_acc_4 - l_left_foot_apart_z_right_foot_apart_y*left_foot_apart_z_acc_4 - l_right_foot_apart_z_right_foot_apart_y*right_foot_apart_z_acc_4
    right_foot_apart_x_acc_4 = right_foot_apart_x_left_3/W_right_foot_apart_x_raised - l_left_foot_apart_x_right_foot_apart_x*left_foot_apart_x_acc_4 - l_left_foot_apart_y_right_foot_apart_x*left_foot_apart_y_acc_4 - l_left_foot_apart_z_right_foot_apart_x*left_foot_apart_z_acc_4 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_y_acc_4 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_z_acc_4
    right_foot_apart_x_acc_5 = right_foot_apart_x_acc_3 + right_foot_apart_x_acc_4
    right_foot_apart_y_acc_5 = right_foot_apart_y_acc_3 + right_foot_apart_y_acc_4
    right_foot_apart_z_acc_5 = right_foot_apart_z_acc_3 + right_foot_apart_z_acc_4
    left_foot_apart_x_acc_5 = left_foot_apart_x_acc_3 + left_foot_apart_x_acc_4
    left_foot_apart_y_acc_5 = left_foot_apart_y_acc_3 + left_foot_apart_y_acc_4
    left_foot_apart_z_acc_5 = left_foot_apart_z_acc_3 + left_foot_apart_z_acc_4
    spindle_acc_4 = spindle_acc_3 + left_foot_apart_x_acc_4*spindle_by_left_foot_apart_x + left_foot_apart_y_acc_4*spindle_by_left_foot_apart_y + left_foot_apart_z_acc_4*spindle_by_left_foot_apart_z + right_foot_apart_x_acc_4*spindle_by_right_foot_apart_x + right_foot_apart_y_acc_4*spindle_by_right_foot_apart_y + right_foot_apart_z_acc_4*spindle_by_right_foot_apart_z
    right_hinge_acc_4 = right_hinge_acc_3 + left_foot_apart_x_acc_4*right_hinge_by_left_foot_apart_x + left_foot_apart_y_acc_4*right_hinge_by_left_foot_apart_y + left_foot_apart_z_acc_4*right_hinge_by_left_foot_apart_z + right_foot_apart_x_acc_4*right_hinge_by_right_foot_apart_x + right_foot_apart_y_acc_4*right_hinge_by_right_foot_apart_y + right_foot_apart_z_acc_4*right_hinge_by_right_foot_apart_z
    right_knee_acc_4 = right_knee_acc_3 + left_foot_apart_x_acc_4*right_knee_by_left_foot_apart_x + left_foot_apart_y_acc_4*right_knee_by_left_foot_apart_y + left_foot_apart_z_acc_4*right_knee_by_left_foot_apart_z + right_foot_apart_x_acc_4*right_knee_by_right_foot_apart_x + right_foot_apart_y_acc_4*right_knee_by_right_foot_apart_y + right_foot_apart_z_acc_4*right_knee_by_right_foot_apart_z
    left_hinge_acc_4 = left_hinge_acc_3 + left_foot_apart_x_acc_4*left_hinge_by_left_foot_apart_x + left_foot_apart_y_acc_4*left_hinge_by_left_foot_apart_y + left_foot_apart_z_acc_4*left_hinge_by_left_foot_apart_z + left_hinge_by_right_foot_apart_x*right_foot_apart_x_acc_4 + left_hinge_by_right_foot_apart_y*right_foot_apart_y_acc_4 + left_hinge_by_right_foot_apart_z*right_foot_apart_z_acc_4
    left_knee_acc_4 = left_knee_acc_3 + left_foot_apart_x_acc_4*left_knee_by_left_foot_apart_x + left_foot_apart_y_acc_4*left_knee_by_left_foot_apart_y + left_foot_apart_z_acc_4*left_knee_by_left_foot_apart_z + left_knee_by_right_foot_apart_x*right_foot_apart_x_acc_4 + left_knee_by_right_foot_apart_y*right_foot_apart_y_acc_4 + left_knee_by_right_foot_apart_z*right_foot_apart_z_acc_4
    guide_acc_4 = guide_acc_3 - inverse_collar_mass*left_foot_apart_y_acc_4 - inverse_collar_mass*right_foot_apart_y_acc_4
    return (ca.vertcat(spindle_acc_4, right_hinge_acc_4, right_knee_acc_4, left_hinge_acc_4, left_knee_acc_4, guide_acc_4), ca.vertcat(),
        ca.vertcat(right_foot_apart_x_acc_5, right_foot_apart_y_acc_5, right_foot_apart_z_acc_5, left_foot_apart_x_acc_5,
            left_foot_apart_y_acc_5, left_foot_apart_z_acc_5))


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (6,): CONSTRAINTS
        dphi (6,): CONSTRAINTS [m/s]
    """
    rod_length, offset, half_arm_length = c[1], c[3], c[7]
    spindle_angle, right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle, guide_travel = q[0], q[1], q[2], q[3], q[4], q[5]
    spindle_speed, right_hinge_speed, right_knee_speed, left_hinge_speed, left_knee_speed, guide_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    cos_spindle = ca.cos(spindle_angle)
    sin_spindle = ca.sin(spindle_angle)
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    cos_right_rod = ca.cos(right_rod_angle)
    sin_right_rod = ca.sin(right_rod_angle)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    cos_left_rod = ca.cos(left_rod_angle)
    sin_left_rod = ca.sin(left_rod_angle)
    right_arm_arm_x = cos_spindle*offset
    right_arm_arm_z = -sin_spindle*offset
    right_arm_arm_rate_x = right_arm_arm_z*spindle_speed
    right_arm_arm_rate_z = -right_arm_arm_x*spindle_speed
    right_arm_turning_x = right_hinge_speed*sin_spindle
    right_arm_turning_z = cos_spindle*right_hinge_speed
    right_arm_R_x_y = -cos_spindle*sin_right_arm
    right_arm_R_z_y = sin_right_arm*sin_spindle
    right_rod_arm_x = -half_arm_length*right_arm_R_x_y
    right_rod_arm_y = -cos_right_arm*half_arm_length
    right_rod_arm_z = -half_arm_length*right_arm_R_z_y
    right_rod_arm_rate_x = right_rod_arm_z*spindle_speed - right_arm_turning_z*right_rod_arm_y
    right_rod_arm_rate_y = right_arm_turning_z*right_rod_arm_x - right_arm_turning_x*right_rod_arm_z
    right_rod_arm_rate_z = right_arm_turning_x*right_rod_arm_y - right_rod_arm_x*spindle_speed
    right_rod_turning_x = right_knee_speed*sin_spindle
    right_rod_turning_z = cos_spindle*right_knee_speed
    right_rod_rate_x = right_arm_turning_x + right_rod_turning_x
    right_rod_rate_z = right_arm_turning_z + right_rod_turning_z
    right_rod_x = right_arm_arm_x + right_rod_arm_x
    right_rod_z = right_arm_arm_z + right_rod_arm_z
    right_rod_velocity_x = right_arm_arm_rate_x + right_rod_arm_rate_x
    right_rod_velocity_z = right_arm_arm_rate_z + right_rod_arm_rate_z
    right_rod_R_x_y = -cos_spindle*sin_right_rod
    right_rod_R_z_y = sin_right_rod*sin_spindle
    right_foot_child_arm_x = -right_rod_R_x_y*rod_length
    right_foot_child_arm_y = -cos_right_rod*rod_length
    right_foot_child_arm_z = -right_rod_R_z_y*rod_length
    right_foot_child_arm_rate_x = right_foot_child_arm_z*spindle_speed - right_foot_child_arm_y*right_rod_rate_z
    right_foot_child_arm_rate_y = right_foot_child_arm_x*right_rod_rate_z - right_foot_child_arm_z*right_rod_rate_x
    right_foot_child_arm_rate_z = right_foot_child_arm_y*right_rod_rate_x - right_foot_child_arm_x*spindle_speed
    right_foot_apart_x = right_foot_child_arm_x + right_rod_x - right_arm_arm_x
    right_foot_apart_y = right_foot_child_arm_y + right_rod_arm_y - guide_travel
    right_foot_apart_z = right_foot_child_arm_z + right_rod_z - right_arm_arm_z
    right_foot_apart_rate_x = right_foot_child_arm_rate_x + right_rod_velocity_x - right_arm_arm_rate_x
    right_foot_apart_rate_y = right_foot_child_arm_rate_y + right_rod_arm_rate_y - guide_speed
    right_foot_apart_rate_z = right_foot_child_arm_rate_z + right_rod_velocity_z - right_arm_arm_rate_z
    left_arm_arm_z = sin_spindle*offset
    left_arm_arm_rate_x = left_arm_arm_z*spindle_speed
    left_arm_arm_rate_z = right_arm_arm_x*spindle_speed
    left_arm_turning_x = -left_hinge_speed*sin_spindle
    left_arm_turning_z = -cos_spindle*left_hinge_speed
    left_arm_R_x_y = cos_spindle*sin_left_arm
    left_arm_R_z_y = -sin_left_arm*sin_spindle
    left_rod_arm_x = -half_arm_length*left_arm_R_x_y
    left_rod_arm_y = -cos_left_arm*half_arm_length
    left_rod_arm_z = -half_arm_length*left_arm_R_z_y
    left_rod_arm_rate_x = left_rod_arm_z*spindle_speed - left_arm_turning_z*left_rod_arm_y
    left_rod_arm_rate_y = left_arm_turning_z*left_rod_arm_x - left_arm_turning_x*left_rod_arm_z
    left_rod_arm_rate_z = left_arm_turning_x*left_rod_arm_y - left_rod_arm_x*spindle_speed
    left_rod_turning_x = -left_knee_speed*sin_spindle
    left_rod_turning_z = -cos_spindle*left_knee_speed
    left_rod_rate_x = left_arm_turning_x + left_rod_turning_x
    left_rod_rate_z = left_arm_turning_z + left_rod_turning_z
    left_rod_x = left_rod_arm_x - right_arm_arm_x
    left_rod_z = left_arm_arm_z + left_rod_arm_z
    left_rod_velocity_x = left_arm_arm_rate_x + left_rod_arm_rate_x
    left_rod_velocity_z = left_arm_arm_rate_z + left_rod_arm_rate_z
    left_rod_R_x_y = cos_spindle*sin_left_rod
    left_rod_R_z_y = -sin_left_rod*sin_spindle
    left_foot_child_arm_x = -left_rod_R_x_y*rod_length
    left_foot_child_arm_y = -cos_left_rod*rod_length
    left_foot_child_arm_z = -left_rod_R_z_y*rod_length
    left_foot_child_arm_rate_x = left_foot_child_arm_z*spindle_speed - left_foot_child_arm_y*left_rod_rate_z
    left_foot_child_arm_rate_y = left_foot_child_arm_x*left_rod_rate_z - left_foot_child_arm_z*left_rod_rate_x
    left_foot_child_arm_rate_z = left_foot_child_arm_y*left_rod_rate_x - left_foot_child_arm_x*spindle_speed
    left_foot_apart_x = left_foot_child_arm_x + left_rod_x + right_arm_arm_x
    left_foot_apart_y = left_foot_child_arm_y + left_rod_arm_y - guide_travel
    left_foot_apart_z = left_foot_child_arm_z + left_rod_z - left_arm_arm_z
    left_foot_apart_rate_x = left_foot_child_arm_rate_x + left_rod_velocity_x - left_arm_arm_rate_x
    left_foot_apart_rate_y = left_foot_child_arm_rate_y + left_rod_arm_rate_y - guide_speed
    left_foot_apart_rate_z = left_foot_child_arm_rate_z + left_rod_velocity_z - left_arm_arm_rate_z
    return (ca.vertcat(right_foot_apart_x, right_foot_apart_y, right_foot_apart_z, left_foot_apart_x, left_foot_apart_y, left_foot_apart_z),
        ca.vertcat(right_foot_apart_rate_x, right_foot_apart_rate_y, right_foot_apart_rate_z, left_foot_apart_rate_x,
            left_foot_apart_rate_y, left_foot_apart_rate_z))


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (6,): SPEEDS
        independence (6,): CONSTRAINTS [1]
    """
    rod_length, offset, half_arm_length, right_rod_h_y, right_arm_h_y, right_arm_I_x_x = c[1], c[3], c[7], c[8], c[9], c[10]
    right_arm_I_y_y, right_rod_I_x_x, k3, spindle_I_y_y_plus_collar_inertia = c[11], c[12], c[14], c[15]
    right_arm_I_x_x_plus_right_rod_I_x_x, inverse_right_rod_I_x_x, inverse_collar_mass = c[16], c[17], c[18]
    right_foot_apart_x_softness, right_foot_apart_y_softness, right_foot_apart_z_softness = c[32], c[33], c[34]
    left_foot_apart_x_softness, left_foot_apart_y_softness, left_foot_apart_z_softness = c[35], c[36], c[37]
    spindle_angle, right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle = q[0], q[1], q[2], q[3], q[4]
    right_foot_apart_x_wanted_rate, right_foot_apart_y_wanted_rate, right_foot_apart_z_wanted_rate = wanted[0], wanted[1], wanted[2]
    left_foot_apart_x_wanted_rate, left_foot_apart_y_wanted_rate, left_foot_apart_z_wanted_rate = wanted[3], wanted[4], wanted[5]
    cos_spindle = ca.cos(spindle_angle)
    sin_spindle = ca.sin(spindle_angle)
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    cos_right_rod = ca.cos(right_rod_angle)
    sin_right_rod = ca.sin(right_rod_angle)
    right_rod_turn = right_rod_angle - right_hinge_angle
    cos_right_rod_turn = ca.cos(right_rod_turn)
    sin_right_rod_turn = ca.sin(right_rod_turn)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    cos_left_rod = ca.cos(left_rod_angle)
    sin_left_rod = ca.sin(left_rod_angle)
    left_rod_turn = left_rod_angle - left_hinge_angle
    cos_left_rod_turn = ca.cos(left_rod_turn)
    sin_left_rod_turn = ca.sin(left_rod_turn)
    right_arm_arm_x = cos_spindle*offset
    right_arm_arm_z = -sin_spindle*offset
    right_arm_R_x_y = -cos_spindle*sin_right_arm
    right_arm_R_z_y = sin_right_arm*sin_spindle
    right_rod_arm_x = -half_arm_length*right_arm_R_x_y
    right_rod_arm_y = -cos_right_arm*half_arm_length
    right_rod_arm_z = -half_arm_length*right_arm_R_z_y
    right_rod_x = right_arm_arm_x + right_rod_arm_x
    right_rod_z = right_arm_arm_z + right_rod_arm_z
    right_rod_R_x_y = -cos_spindle*sin_right_rod
    right_rod_R_z_y = sin_right_rod*sin_spindle
    right_foot_child_arm_x = -right_rod_R_x_y*rod_length
    right_foot_child_arm_y = -cos_right_rod*rod_length
    right_foot_child_arm_z = -right_rod_R_z_y*rod_length
    right_foot_child_arm_y_plus_right_rod_arm_y = right_foot_child_arm_y + right_rod_arm_y
    right_foot_x_on_right_hinge = -cos_spindle*right_foot_child_arm_y_plus_right_rod_arm_y
    right_foot_x_on_right_knee = -cos_spindle*right_foot_child_arm_y
    right_foot_y_on_right_hinge = cos_spindle*(right_foot_child_arm_x + right_rod_x - right_arm_arm_x) - sin_spindle*(right_foot_child_arm_z + right_rod_z - right_arm_arm_z)
    right_foot_y_on_right_knee = cos_spindle*right_foot_child_arm_x - right_foot_child_arm_z*sin_spindle
    right_foot_z_on_right_hinge = sin_spindle*right_foot_child_arm_y_plus_right_rod_arm_y
    right_foot_z_on_right_knee = right_foot_child_arm_y*sin_spindle
    left_arm_arm_z = sin_spindle*offset
    left_arm_R_x_y = cos_spindle*sin_left_arm
    left_arm_R_z_y = -sin_left_arm*sin_spindle
    left_rod_arm_x = -half_arm_length*left_arm_R_x_y
    left_rod_arm_y = -cos_left_arm*half_arm_length
    left_rod_arm_z = -half_arm_length*left_arm_R_z_y
    left_rod_x = left_rod_arm_x - right_arm_arm_x
    left_rod_z = left_arm_arm_z + left_rod_arm_z
    left_rod_R_x_y = cos_spindle*sin_left_rod
    left_rod_R_z_y = -sin_left_rod*sin_spindle
    left_foot_child_arm_x = -left_rod_R_x_y*rod_length
    left_foot_child_arm_y = -cos_left_rod*rod_length
    left_foot_child_arm_z = -left_rod_R_z_y*rod_length
    left_foot_child_arm_y_plus_left_rod_arm_y = left_foot_child_arm_y + left_rod_arm_y
    left_foot_x_on_left_hinge = cos_spindle*left_foot_child_arm_y_plus_left_rod_arm_y
    left_foot_x_on_left_knee = cos_spindle*left_foot_child_arm_y
    left_foot_y_on_left_hinge = sin_spindle*(left_foot_child_arm_z + left_rod_z - left_arm_arm_z) - cos_spindle*(left_foot_child_arm_x + left_rod_x + right_arm_arm_x)
    left_foot_y_on_left_knee = left_foot_child_arm_z*sin_spindle - cos_spindle*left_foot_child_arm_x
    left_foot_z_on_left_hinge = -sin_spindle*left_foot_child_arm_y_plus_left_rod_arm_y
    left_foot_z_on_left_knee = -left_foot_child_arm_y*sin_spindle
    right_rod_moment_x = -right_rod_h_y*sin_right_rod_turn
    right_rod_moment_y = cos_right_rod_turn*right_rod_h_y
    right_arm_total_moment_y = right_arm_h_y + right_rod_moment_y
    left_rod_moment_x = right_rod_h_y*sin_left_rod_turn
    left_rod_moment_y = cos_left_rod_turn*right_rod_h_y
    left_arm_total_moment_y = left_rod_moment_y + right_arm_h_y
    right_rod_J_swing = -right_rod_I_x_x*sin_right_rod_turn
    right_rod_J_x_x = right_rod_I_x_x + right_rod_J_swing*sin_right_rod_turn
    right_rod_J_y_y = -right_rod_J_swing*sin_right_rod_turn
    right_rod_J_x_y = -cos_right_rod_turn*right_rod_J_swing
    left_rod_J_swing = right_rod_I_x_x*sin_left_rod_turn
    left_rod_J_x_x = right_rod_I_x_x - left_rod_J_swing*sin_left_rod_turn
    left_rod_J_y_y = left_rod_J_swing*sin_left_rod_turn
    left_rod_J_x_y = -cos_left_rod_turn*left_rod_J_swing
    cos_right_arm_times_right_rod_moment_x = cos_right_arm*right_rod_moment_x
    x4 = -right_arm_total_moment_y*sin_right_arm
    x5 = cos_right_arm_times_right_rod_moment_x + x4
    right_arm_turned_moment_x = cos_spindle*x5
    right_arm_turned_moment_z = -sin_spindle*x5
    cos_left_arm_times_left_rod_moment_x = cos_left_arm*left_rod_moment_x
    left_arm_total_moment_y_times_sin_left_arm = left_arm_total_moment_y*sin_left_arm
    x8 = cos_left_arm_times_left_rod_moment_x + left_arm_total_moment_y_times_sin_left_arm
    left_arm_turned_moment_x = cos_spindle*x8
    left_arm_turned_moment_z = -sin_spindle*x8
    right_arm_total_J_x_y = right_rod_J_x_y + half_arm_length*right_rod_moment_x
    right_arm_total_J_y_y = right_arm_I_y_y + right_rod_J_y_y
    x9 = -k3*right_rod_moment_y
    right_arm_total_J_x_x = right_arm_I_x_x + right_rod_J_x_x + x9
    right_arm_turned_J_swing = sin_right_arm*(right_arm_total_J_y_y - right_arm_total_J_x_x) - 2*cos_right_arm*right_arm_total_J_x_y
    left_arm_total_J_x_y = left_rod_J_x_y + half_arm_length*left_rod_moment_x
    left_arm_total_J_y_y = left_rod_J_y_y + right_arm_I_y_y
    x10 = -k3*left_rod_moment_y
    left_arm_total_J_x_x = left_rod_J_x_x + right_arm_I_x_x + x10
    left_arm_turned_J_swing = -sin_left_arm*(left_arm_total_J_y_y - left_arm_total_J_x_x) - 2*cos_left_arm*left_arm_total_J_x_y
    right_arm_turned_J_y_y = right_arm_total_J_y_y - right_arm_turned_J_swing*sin_right_arm
    left_arm_turned_J_y_y = left_arm_total_J_y_y + left_arm_turned_J_swing*sin_left_arm
    spindle_total_J_y_y = spindle_I_y_y_plus_collar_inertia + left_arm_turned_J_y_y + right_arm_turned_J_y_y + 2*left_arm_arm_z*left_arm_turned_moment_z + 2*right_arm_arm_x*right_arm_turned_moment_x - 2*left_arm_arm_z*right_arm_turned_moment_z - 2*left_arm_turned_moment_x*right_arm_arm_x
    right_arm_total_J_z_z = right_arm_I_x_x_plus_right_rod_I_x_x + x9
    x11 = -cos_right_arm*right_arm_total_moment_y
    minus_right_rod_moment_x_times_sin_right_arm = -right_rod_moment_x*sin_right_arm
    x13 = x11 + minus_right_rod_moment_x_times_sin_right_arm
    right_hinge_right_arm_force_x = cos_spindle*x13
    right_hinge_right_arm_force_z = -sin_spindle*x13
    right_hinge_right_arm_torque_y = -left_arm_arm_z*right_hinge_right_arm_force_x - right_arm_arm_x*right_hinge_right_arm_force_z
    right_knee_right_rod_torque_z = right_rod_I_x_x - half_arm_length*right_rod_moment_y
    minus_cos_right_arm_times_right_rod_moment_y = -cos_right_arm*right_rod_moment_y
    x15 = minus_right_rod_moment_x_times_sin_right_arm + minus_cos_right_arm_times_right_rod_moment_y
    right_knee_right_arm_force_x = cos_spindle*x15
    right_knee_right_arm_force_z = -sin_spindle*x15
    right_knee_right_arm_torque_y = -left_arm_arm_z*right_knee_right_arm_force_x - right_arm_arm_x*right_knee_right_arm_force_z
    left_arm_total_J_z_z = right_arm_I_x_x_plus_right_rod_I_x_x + x10
    cos_left_arm_times_left_arm_total_moment_y = cos_left_arm*left_arm_total_moment_y
    minus_left_rod_moment_x_times_sin_left_arm = -left_rod_moment_x*sin_left_arm
    x18 = cos_left_arm_times_left_arm_total_moment_y + minus_left_rod_moment_x_times_sin_left_arm
    left_hinge_left_arm_force_x = cos_spindle*x18
    left_hinge_left_arm_force_z = -sin_spindle*x18
    left_hinge_left_arm_torque_y = left_arm_arm_z*left_hinge_left_arm_force_x + left_hinge_left_arm_force_z*right_arm_arm_x
    left_knee_left_rod_torque_z = half_arm_length*left_rod_moment_y - right_rod_I_x_x
    cos_left_arm_times_left_rod_moment_y = cos_left_arm*left_rod_moment_y
    x20 = minus_left_rod_moment_x_times_sin_left_arm + cos_left_arm_times_left_rod_moment_y
    left_knee_left_arm_force_x = cos_spindle*x20
    left_knee_left_arm_force_z = -sin_spindle*x20
    left_knee_left_arm_torque_y = left_arm_arm_z*left_knee_left_arm_force_x + left_knee_left_arm_force_z*right_arm_arm_x
    l_left_hinge_left_knee = -inverse_right_rod_I_x_x*left_knee_left_rod_torque_z
    D_left_hinge = left_arm_total_J_z_z + l_left_hinge_left_knee*left_knee_left_rod_torque_z
    l_right_hinge_right_knee = inverse_right_rod_I_x_x*right_knee_right_rod_torque_z
    D_right_hinge = right_arm_total_J_z_z - l_right_hinge_right_knee*right_knee_right_rod_torque_z
    l_spindle_left_knee = inverse_right_rod_I_x_x*left_knee_left_arm_torque_y
    L_spindle_left_hinge = left_hinge_left_arm_torque_y - l_left_hinge_left_knee*left_knee_left_arm_torque_y
    l_spindle_left_hinge = L_spindle_left_hinge/D_left_hinge
    l_spindle_right_knee = inverse_right_rod_I_x_x*right_knee_right_arm_torque_y
    L_spindle_right_hinge = right_hinge_right_arm_torque_y - l_right_hinge_right_knee*right_knee_right_arm_torque_y
    l_spindle_right_hinge = L_spindle_right_hinge/D_right_hinge
    D_spindle = spindle_total_J_y_y - L_spindle_left_hinge*l_spindle_left_hinge - L_spindle_right_hinge*l_spindle_right_hinge - l_spindle_left_knee*left_knee_left_arm_torque_y - l_spindle_right_knee*right_knee_right_arm_torque_y
    y_right_hinge_2 = right_foot_x_on_right_hinge - l_right_hinge_right_knee*right_foot_x_on_right_knee
    y_spindle_2 = -l_spindle_right_hinge*y_right_hinge_2 - l_spindle_right_knee*right_foot_x_on_right_knee
    y_right_hinge_4 = right_foot_z_on_right_hinge - l_right_hinge_right_knee*right_foot_z_on_right_knee
    y_spindle_4 = -l_spindle_right_hinge*y_right_hinge_4 - l_spindle_right_knee*right_foot_z_on_right_knee
    y_right_hinge_3 = right_foot_y_on_right_hinge - l_right_hinge_right_knee*right_foot_y_on_right_knee
    y_spindle_3 = -l_spindle_right_hinge*y_right_hinge_3 - l_spindle_right_knee*right_foot_y_on_right_knee
    spindle_by_right_foot_apart_x, spindle_by_right_foot_apart_y, spindle_by_right_foot_apart_z = revolute_apart_apart(y_spindle_2, y_spindle_3, y_spindle_4, D_spindle)
    right_hinge_by_right_foot_apart_x = y_right_hinge_2/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_x
    right_knee_by_right_foot_apart_x = inverse_right_rod_I_x_x*right_foot_x_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_x - l_spindle_right_knee*spindle_by_right_foot_apart_x
    left_hinge_by_right_foot_apart_x = -l_spindle_left_hinge*spindle_by_right_foot_apart_x
    left_knee_by_right_foot_apart_x = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_x - l_spindle_left_knee*spindle_by_right_foot_apart_x
    right_hinge_by_right_foot_apart_y = y_right_hinge_3/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_y
    right_knee_by_right_foot_apart_y = inverse_right_rod_I_x_x*right_foot_y_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_y - l_spindle_right_knee*spindle_by_right_foot_apart_y
    left_hinge_by_right_foot_apart_y = -l_spindle_left_hinge*spindle_by_right_foot_apart_y
    left_knee_by_right_foot_apart_y = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_y - l_spindle_left_knee*spindle_by_right_foot_apart_y
    right_hinge_by_right_foot_apart_z = y_right_hinge_4/D_right_hinge - l_spindle_right_hinge*spindle_by_right_foot_apart_z
    right_knee_by_right_foot_apart_z = inverse_right_rod_I_x_x*right_foot_z_on_right_knee - l_right_hinge_right_knee*right_hinge_by_right_foot_apart_z - l_spindle_right_knee*spindle_by_right_foot_apart_z
    left_hinge_by_right_foot_apart_z = -l_spindle_left_hinge*spindle_by_right_foot_apart_z
    left_knee_by_right_foot_apart_z = -l_left_hinge_left_knee*left_hinge_by_right_foot_apart_z - l_spindle_left_knee*spindle_by_right_foot_apart_z
    y_left_hinge_2 = left_foot_x_on_left_hinge - l_left_hinge_left_knee*left_foot_x_on_left_knee
    y_spindle_5 = -l_spindle_left_hinge*y_left_hinge_2 - l_spindle_left_knee*left_foot_x_on_left_knee
    y_left_hinge_4 = left_foot_z_on_left_hinge - l_left_hinge_left_knee*left_foot_z_on_left_knee
    y_spindle_7 = -l_spindle_left_hinge*y_left_hinge_4 - l_spindle_left_knee*left_foot_z_on_left_knee
    y_left_hinge_3 = left_foot_y_on_left_hinge - l_left_hinge_left_knee*left_foot_y_on_left_knee
    y_spindle_6 = -l_spindle_left_hinge*y_left_hinge_3 - l_spindle_left_knee*left_foot_y_on_left_knee
    spindle_by_left_foot_apart_x, spindle_by_left_foot_apart_y, spindle_by_left_foot_apart_z = revolute_apart_apart(y_spindle_5, y_spindle_6, y_spindle_7, D_spindle)
    right_hinge_by_left_foot_apart_x = -l_spindle_right_hinge*spindle_by_left_foot_apart_x
    right_knee_by_left_foot_apart_x = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_x - l_spindle_right_knee*spindle_by_left_foot_apart_x
    left_hinge_by_left_foot_apart_x = y_left_hinge_2/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_x
    left_knee_by_left_foot_apart_x = inverse_right_rod_I_x_x*left_foot_x_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_x - l_spindle_left_knee*spindle_by_left_foot_apart_x
    right_hinge_by_left_foot_apart_y = -l_spindle_right_hinge*spindle_by_left_foot_apart_y
    right_knee_by_left_foot_apart_y = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_y - l_spindle_right_knee*spindle_by_left_foot_apart_y
    left_hinge_by_left_foot_apart_y = y_left_hinge_3/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_y
    left_knee_by_left_foot_apart_y = inverse_right_rod_I_x_x*left_foot_y_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_y - l_spindle_left_knee*spindle_by_left_foot_apart_y
    right_hinge_by_left_foot_apart_z = -l_spindle_right_hinge*spindle_by_left_foot_apart_z
    right_knee_by_left_foot_apart_z = -l_right_hinge_right_knee*right_hinge_by_left_foot_apart_z - l_spindle_right_knee*spindle_by_left_foot_apart_z
    left_hinge_by_left_foot_apart_z = y_left_hinge_4/D_left_hinge - l_spindle_left_hinge*spindle_by_left_foot_apart_z
    left_knee_by_left_foot_apart_z = inverse_right_rod_I_x_x*left_foot_z_on_left_knee - l_left_hinge_left_knee*left_hinge_by_left_foot_apart_z - l_spindle_left_knee*spindle_by_left_foot_apart_z
    W_right_foot_apart_x_right_foot_apart_x = right_foot_x_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_x_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_y_right_foot_apart_x = right_foot_y_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_y_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_y_right_foot_apart_y = inverse_collar_mass + right_foot_y_on_right_hinge*right_hinge_by_right_foot_apart_y + right_foot_y_on_right_knee*right_knee_by_right_foot_apart_y
    W_right_foot_apart_z_right_foot_apart_x = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_x + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_x
    W_right_foot_apart_z_right_foot_apart_y = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_y + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_y
    W_right_foot_apart_z_right_foot_apart_z = right_foot_z_on_right_hinge*right_hinge_by_right_foot_apart_z + right_foot_z_on_right_knee*right_knee_by_right_foot_apart_z
    W_left_foot_apart_x_right_foot_apart_x = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_x_right_foot_apart_y = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_x_right_foot_apart_z = left_foot_x_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_x_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_x_left_foot_apart_x = left_foot_x_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_x_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_y_right_foot_apart_x = left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_y_right_foot_apart_y = inverse_collar_mass + left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_y_right_foot_apart_z = left_foot_y_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_y_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_y_left_foot_apart_x = left_foot_y_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_y_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_y_left_foot_apart_y = inverse_collar_mass + left_foot_y_on_left_hinge*left_hinge_by_left_foot_apart_y + left_foot_y_on_left_knee*left_knee_by_left_foot_apart_y
    W_left_foot_apart_z_right_foot_apart_x = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_x + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_x
    W_left_foot_apart_z_right_foot_apart_y = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_y + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_y
    W_left_foot_apart_z_right_foot_apart_z = left_foot_z_on_left_hinge*left_hinge_by_right_foot_apart_z + left_foot_z_on_left_knee*left_knee_by_right_foot_apart_z
    W_left_foot_apart_z_left_foot_apart_x = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_x + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_x
    W_left_foot_apart_z_left_foot_apart_y = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_y + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_y
    W_left_foot_apart_z_left_foot_apart_z = left_foot_z_on_left_hinge*left_hinge_by_left_foot_apart_z + left_foot_z_on_left_knee*left_knee_by_left_foot_apart_z
    right_foot_apart_size = W_right_foot_apart_x_right_foot_apart_x + W_right_foot_apart_y_right_foot_apart_y + W_right_foot_apart_z_right_foot_apart_z
    W_right_foot_apart_x_raised = W_right_foot_apart_x_right_foot_apart_x + right_foot_apart_size*right_foot_apart_x_softness
    W_right_foot_apart_y_raised = W_right_foot_apart_y_right_foot_apart_y + right_foot_apart_size*right_foot_apart_y_softness
    W_right_foot_apart_z_raised = W_right_foot_apart_z_right_foot_apart_z + right_foot_apart_size*right_foot_apart_z_softness
    left_foot_apart_size = W_left_foot_apart_x_left_foot_apart_x + W_left_foot_apart_y_left_foot_apart_y + W_left_foot_apart_z_left_foot_apart_z
    W_left_foot_apart_x_raised = W_left_foot_apart_x_left_foot_apart_x + left_foot_apart_size*left_foot_apart_x_softness
    W_left_foot_apart_y_raised = W_left_foot_apart_y_left_foot_apart_y + left_foot_apart_size*left_foot_apart_y_softness
    W_left_foot_apart_z_raised = W_left_foot_apart_z_left_foot_apart_z + left_foot_apart_size*left_foot_apart_z_softness
    l_right_foot_apart_y_right_foot_apart_x = W_right_foot_apart_y_right_foot_apart_x/W_right_foot_apart_x_raised
    D_right_foot_apart_y = W_right_foot_apart_y_raised - W_right_foot_apart_y_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_right_foot_apart_z_right_foot_apart_x = W_right_foot_apart_z_right_foot_apart_x/W_right_foot_apart_x_raised
    L_right_foot_apart_z_right_foot_apart_y = W_right_foot_apart_z_right_foot_apart_y - W_right_foot_apart_z_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_right_foot_apart_z_right_foot_apart_y = L_right_foot_apart_z_right_foot_apart_y/D_right_foot_apart_y
    D_right_foot_apart_z = W_right_foot_apart_z_raised - L_right_foot_apart_z_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_right_foot_apart_z_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_x_right_foot_apart_x = W_left_foot_apart_x_right_foot_apart_x/W_right_foot_apart_x_raised
    L_left_foot_apart_x_right_foot_apart_y = W_left_foot_apart_x_right_foot_apart_y - W_left_foot_apart_x_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_x_right_foot_apart_y = L_left_foot_apart_x_right_foot_apart_y/D_right_foot_apart_y
    L_left_foot_apart_x_right_foot_apart_z = W_left_foot_apart_x_right_foot_apart_z - L_left_foot_apart_x_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_x_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_x_right_foot_apart_z = L_left_foot_apart_x_right_foot_apart_z/D_right_foot_apart_z
    D_left_foot_apart_x = W_left_foot_apart_x_raised - L_left_foot_apart_x_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_x_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_x_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    l_left_foot_apart_y_right_foot_apart_x = W_left_foot_apart_y_right_foot_apart_x/W_right_foot_apart_x_raised
    L_left_foot_apart_y_right_foot_apart_y = W_left_foot_apart_y_right_foot_apart_y - W_left_foot_apart_y_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_y_right_foot_apart_y = L_left_foot_apart_y_right_foot_apart_y/D_right_foot_apart_y
    L_left_foot_apart_y_right_foot_apart_z = W_left_foot_apart_y_right_foot_apart_z - L_left_foot_apart_y_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_y_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_y_right_foot_apart_z = L_left_foot_apart_y_right_foot_apart_z/D_right_foot_apart_z
    L_left_foot_apart_y_left_foot_apart_x = W_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_y_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_y_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_y_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    l_left_foot_apart_y_left_foot_apart_x = L_left_foot_apart_y_left_foot_apart_x/D_left_foot_apart_x
    D_left_foot_apart_y = W_left_foot_apart_y_raised - L_left_foot_apart_y_left_foot_apart_x*l_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_y_right_foot_apart_y*l_left_foot_apart_y_right_foot_apart_y - L_left_foot_apart_y_right_foot_apart_z*l_left_foot_apart_y_right_foot_apart_z - W_left_foot_apart_y_right_foot_apart_x*l_left_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_z_right_foot_apart_x = W_left_foot_apart_z_right_foot_apart_x/W_right_foot_apart_x_raised
    L_left_foot_apart_z_right_foot_apart_y = W_left_foot_apart_z_right_foot_apart_y - W_left_foot_apart_z_right_foot_apart_x*l_right_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_z_right_foot_apart_y = L_left_foot_apart_z_right_foot_apart_y/D_right_foot_apart_y
    L_left_foot_apart_z_right_foot_apart_z = W_left_foot_apart_z_right_foot_apart_z - L_left_foot_apart_z_right_foot_apart_y*l_right_foot_apart_z_right_foot_apart_y - W_left_foot_apart_z_right_foot_apart_x*l_right_foot_apart_z_right_foot_apart_x
    l_left_foot_apart_z_right_foot_apart_z = L_left_foot_apart_z_right_foot_apart_z/D_right_foot_apart_z
    L_left_foot_apart_z_left_foot_apart_x = W_left_foot_apart_z_left_foot_apart_x - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_x_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_x_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_x_right_foot_apart_x
    l_left_foot_apart_z_left_foot_apart_x = L_left_foot_apart_z_left_foot_apart_x/D_left_foot_apart_x
    L_left_foot_apart_z_left_foot_apart_y = W_left_foot_apart_z_left_foot_apart_y - L_left_foot_apart_z_left_foot_apart_x*l_left_foot_apart_y_left_foot_apart_x - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_y_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_y_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_y_right_foot_apart_x
    l_left_foot_apart_z_left_foot_apart_y = L_left_foot_apart_z_left_foot_apart_y/D_left_foot_apart_y
    D_left_foot_apart_z = W_left_foot_apart_z_raised - L_left_foot_apart_z_left_foot_apart_x*l_left_foot_apart_z_left_foot_apart_x - L_left_foot_apart_z_left_foot_apart_y*l_left_foot_apart_z_left_foot_apart_y - L_left_foot_apart_z_right_foot_apart_y*l_left_foot_apart_z_right_foot_apart_y - L_left_foot_apart_z_right_foot_apart_z*l_left_foot_apart_z_right_foot_apart_z - W_left_foot_apart_z_right_foot_apart_x*l_left_foot_apart_z_right_foot_apart_x
    y_right_foot_apart_y_4 = right_foot_apart_y_wanted_rate - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_x_wanted_rate
    y_right_foot_apart_z_4 = right_foot_apart_z_wanted_rate - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_x_wanted_rate - l_right_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_4
    y_left_foot_apart_x_4 = left_foot_apart_x_wanted_rate - l_left_foot_apart_x_right_foot_apart_x*right_foot_apart_x_wanted_rate - l_left_foot_apart_x_right_foot_apart_y*y_right_foot_apart_y_4 - l_left_foot_apart_x_right_foot_apart_z*y_right_foot_apart_z_4
    y_left_foot_apart_y_4 = left_foot_apart_y_wanted_rate - l_left_foot_apart_y_left_foot_apart_x*y_left_foot_apart_x_4 - l_left_foot_apart_y_right_foot_apart_x*right_foot_apart_x_wanted_rate - l_left_foot_apart_y_right_foot_apart_y*y_right_foot_apart_y_4 - l_left_foot_apart_y_right_foot_apart_z*y_right_foot_apart_z_4
    y_left_foot_apart_z_4 = left_foot_apart_z_wanted_rate - l_left_foot_apart_z_left_foot_apart_x*y_left_foot_apart_x_4 - l_left_foot_apart_z_left_foot_apart_y*y_left_foot_apart_y_4 - l_left_foot_apart_z_right_foot_apart_x*right_foot_apart_x_wanted_rate - l_left_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_4 - l_left_foot_apart_z_right_foot_apart_z*y_right_foot_apart_z_4
    left_foot_apart_z_push = y_left_foot_apart_z_4/D_left_foot_apart_z
    left_foot_apart_y_push = y_left_foot_apart_y_4/D_left_foot_apart_y - l_left_foot_apart_z_left_foot_apart_y*left_foot_apart_z_push
    left_foot_apart_x_push = y_left_foot_apart_x_4/D_left_foot_apart_x - l_left_foot_apart_y_left_foot_apart_x*left_foot_apart_y_push - l_left_foot_apart_z_left_foot_apart_x*left_foot_apart_z_push
    right_foot_apart_z_push = y_right_foot_apart_z_4/D_right_foot_apart_z - l_left_foot_apart_x_right_foot_apart_z*left_foot_apart_x_push - l_left_foot_apart_y_right_foot_apart_z*left_foot_apart_y_push - l_left_foot_apart_z_right_foot_apart_z*left_foot_apart_z_push
    right_foot_apart_y_push = y_right_foot_apart_y_4/D_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_y*left_foot_apart_x_push - l_left_foot_apart_y_right_foot_apart_y*left_foot_apart_y_push - l_left_foot_apart_z_right_foot_apart_y*left_foot_apart_z_push - l_right_foot_apart_z_right_foot_apart_y*right_foot_apart_z_push
    right_foot_apart_x_push = right_foot_apart_x_wanted_rate/W_right_foot_apart_x_raised - l_left_foot_apart_x_right_foot_apart_x*left_foot_apart_x_push - l_left_foot_apart_y_right_foot_apart_x*left_foot_apart_y_push - l_left_foot_apart_z_right_foot_apart_x*left_foot_apart_z_push - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_y_push - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_z_push
    guide_push = -inverse_collar_mass*left_foot_apart_y_push - inverse_collar_mass*right_foot_apart_y_push
    left_knee_push = left_foot_apart_x_push*left_knee_by_left_foot_apart_x + left_foot_apart_y_push*left_knee_by_left_foot_apart_y + left_foot_apart_z_push*left_knee_by_left_foot_apart_z + left_knee_by_right_foot_apart_x*right_foot_apart_x_push + left_knee_by_right_foot_apart_y*right_foot_apart_y_push + left_knee_by_right_foot_apart_z*right_foot_apart_z_push
    left_hinge_push = left_foot_apart_x_push*left_hinge_by_left_foot_apart_x + left_foot_apart_y_push*left_hinge_by_left_foot_apart_y + left_foot_apart_z_push*left_hinge_by_left_foot_apart_z + left_hinge_by_right_foot_apart_x*right_foot_apart_x_push + left_hinge_by_right_foot_apart_y*right_foot_apart_y_push + left_hinge_by_right_foot_apart_z*right_foot_apart_z_push
    right_knee_push = left_foot_apart_x_push*right_knee_by_left_foot_apart_x + left_foot_apart_y_push*right_knee_by_left_foot_apart_y + left_foot_apart_z_push*right_knee_by_left_foot_apart_z + right_foot_apart_x_push*right_knee_by_right_foot_apart_x + right_foot_apart_y_push*right_knee_by_right_foot_apart_y + right_foot_apart_z_push*right_knee_by_right_foot_apart_z
    right_hinge_push = left_foot_apart_x_push*right_hinge_by_left_foot_apart_x + left_foot_apart_y_push*right_hinge_by_left_foot_apart_y + left_foot_apart_z_push*right_hinge_by_left_foot_apart_z + right_foot_apart_x_push*right_hinge_by_right_foot_apart_x + right_foot_apart_y_push*right_hinge_by_right_foot_apart_y + right_foot_apart_z_push*right_hinge_by_right_foot_apart_z
    spindle_push = left_foot_apart_x_push*spindle_by_left_foot_apart_x + left_foot_apart_y_push*spindle_by_left_foot_apart_y + left_foot_apart_z_push*spindle_by_left_foot_apart_z + right_foot_apart_x_push*spindle_by_right_foot_apart_x + right_foot_apart_y_push*spindle_by_right_foot_apart_y + right_foot_apart_z_push*spindle_by_right_foot_apart_z
    right_foot_apart_x_left_4 = right_foot_apart_x_wanted_rate - right_foot_x_on_right_hinge*right_hinge_push - right_foot_x_on_right_knee*right_knee_push
    right_foot_apart_y_left_4 = guide_push + right_foot_apart_y_wanted_rate - right_foot_y_on_right_hinge*right_hinge_push - right_foot_y_on_right_knee*right_knee_push
    right_foot_apart_z_left_4 = right_foot_apart_z_wanted_rate - right_foot_z_on_right_hinge*right_hinge_push - right_foot_z_on_right_knee*right_knee_push
    left_foot_apart_x_left_4 = left_foot_apart_x_wanted_rate - left_foot_x_on_left_hinge*left_hinge_push - left_foot_x_on_left_knee*left_knee_push
    left_foot_apart_y_left_4 = guide_push + left_foot_apart_y_wanted_rate - left_foot_y_on_left_hinge*left_hinge_push - left_foot_y_on_left_knee*left_knee_push
    left_foot_apart_z_left_4 = left_foot_apart_z_wanted_rate - left_foot_z_on_left_hinge*left_hinge_push - left_foot_z_on_left_knee*left_knee_push
    y_right_foot_apart_y_5 = right_foot_apart_y_left_4 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_4
    y_right_foot_apart_z_5 = right_foot_apart_z_left_4 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_4 - l_right_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_5
    y_left_foot_apart_x_5 = left_foot_apart_x_left_4 - l_left_foot_apart_x_right_foot_apart_x*right_foot_apart_x_left_4 - l_left_foot_apart_x_right_foot_apart_y*y_right_foot_apart_y_5 - l_left_foot_apart_x_right_foot_apart_z*y_right_foot_apart_z_5
    y_left_foot_apart_y_5 = left_foot_apart_y_left_4 - l_left_foot_apart_y_left_foot_apart_x*y_left_foot_apart_x_5 - l_left_foot_apart_y_right_foot_apart_x*right_foot_apart_x_left_4 - l_left_foot_apart_y_right_foot_apart_y*y_right_foot_apart_y_5 - l_left_foot_apart_y_right_foot_apart_z*y_right_foot_apart_z_5
    y_left_foot_apart_z_5 = left_foot_apart_z_left_4 - l_left_foot_apart_z_left_foot_apart_x*y_left_foot_apart_x_5 - l_left_foot_apart_z_left_foot_apart_y*y_left_foot_apart_y_5 - l_left_foot_apart_z_right_foot_apart_x*right_foot_apart_x_left_4 - l_left_foot_apart_z_right_foot_apart_y*y_right_foot_apart_y_5 - l_left_foot_apart_z_right_foot_apart_z*y_right_foot_apart_z_5
    left_foot_apart_z_push_2 = y_left_foot_apart_z_5/D_left_foot_apart_z
    left_foot_apart_y_push_2 = y_left_foot_apart_y_5/D_left_foot_apart_y - l_left_foot_apart_z_left_foot_apart_y*left_foot_apart_z_push_2
    left_foot_apart_x_push_2 = y_left_foot_apart_x_5/D_left_foot_apart_x - l_left_foot_apart_y_left_foot_apart_x*left_foot_apart_y_push_2 - l_left_foot_apart_z_left_foot_apart_x*left_foot_apart_z_push_2
    right_foot_apart_z_push_2 = y_right_foot_apart_z_5/D_right_foot_apart_z - l_left_foot_apart_x_right_foot_apart_z*left_foot_apart_x_push_2 - l_left_foot_apart_y_right_foot_apart_z*left_foot_apart_y_push_2 - l_left_foot_apart_z_right_foot_apart_z*left_foot_apart_z_push_2
    right_foot_apart_y_push_2 = y_right_foot_apart_y_5/D_right_foot_apart_y - l_left_foot_apart_x_right_foot_apart_y*left_foot_apart_x_push_2 - l_left_foot_apart_y_right_foot_apart_y*left_foot_apart_y_push_2 - l_left_foot_apart_z_right_foot_apart_y*left_foot_apart_z_push_2 - l_right_foot_apart_z_right_foot_apart_y*right_foot_apart_z_push_2
    right_foot_apart_x_push_2 = right_foot_apart_x_left_4/W_right_foot_apart_x_raised - l_left_foot_apart_x_right_foot_apart_x*left_foot_apart_x_push_2 - l_left_foot_apart_y_right_foot_apart_x*left_foot_apart_y_push_2 - l_left_foot_apart_z_right_foot_apart_x*left_foot_apart_z_push_2 - l_right_foot_apart_y_right_foot_apart_x*right_foot_apart_y_push_2 - l_right_foot_apart_z_right_foot_apart_x*right_foot_apart_z_push_2
    guide_push_2 = guide_push - inverse_collar_mass*left_foot_apart_y_push_2 - inverse_collar_mass*right_foot_apart_y_push_2
    left_knee_push_2 = left_knee_push + left_foot_apart_x_push_2*left_knee_by_left_foot_apart_x + left_foot_apart_y_push_2*left_knee_by_left_foot_apart_y + left_foot_apart_z_push_2*left_knee_by_left_foot_apart_z + left_knee_by_right_foot_apart_x*right_foot_apart_x_push_2 + left_knee_by_right_foot_apart_y*right_foot_apart_y_push_2 + left_knee_by_right_foot_apart_z*right_foot_apart_z_push_2
    left_hinge_push_2 = left_hinge_push + left_foot_apart_x_push_2*left_hinge_by_left_foot_apart_x + left_foot_apart_y_push_2*left_hinge_by_left_foot_apart_y + left_foot_apart_z_push_2*left_hinge_by_left_foot_apart_z + left_hinge_by_right_foot_apart_x*right_foot_apart_x_push_2 + left_hinge_by_right_foot_apart_y*right_foot_apart_y_push_2 + left_hinge_by_right_foot_apart_z*right_foot_apart_z_push_2
    right_knee_push_2 = right_knee_push + left_foot_apart_x_push_2*right_knee_by_left_foot_apart_x + left_foot_apart_y_push_2*right_knee_by_left_foot_apart_y + left_foot_apart_z_push_2*right_knee_by_left_foot_apart_z + right_foot_apart_x_push_2*right_knee_by_right_foot_apart_x + right_foot_apart_y_push_2*right_knee_by_right_foot_apart_y + right_foot_apart_z_push_2*right_knee_by_right_foot_apart_z
    right_hinge_push_2 = right_hinge_push + left_foot_apart_x_push_2*right_hinge_by_left_foot_apart_x + left_foot_apart_y_push_2*right_hinge_by_left_foot_apart_y + left_foot_apart_z_push_2*right_hinge_by_left_foot_apart_z + right_foot_apart_x_push_2*right_hinge_by_right_foot_apart_x + right_foot_apart_y_push_2*right_hinge_by_right_foot_apart_y + right_foot_apart_z_push_2*right_hinge_by_right_foot_apart_z
    spindle_push_2 = spindle_push + left_foot_apart_x_push_2*spindle_by_left_foot_apart_x + left_foot_apart_y_push_2*spindle_by_left_foot_apart_y + left_foot_apart_z_push_2*spindle_by_left_foot_apart_z + right_foot_apart_x_push_2*spindle_by_right_foot_apart_x + right_foot_apart_y_push_2*spindle_by_right_foot_apart_y + right_foot_apart_z_push_2*spindle_by_right_foot_apart_z
    right_foot_apart_x_independence, right_foot_apart_y_independence, right_foot_apart_z_independence = revolute_apart_apart(W_right_foot_apart_x_raised, D_right_foot_apart_y, D_right_foot_apart_z, right_foot_apart_size)
    left_foot_apart_x_independence, left_foot_apart_y_independence, left_foot_apart_z_independence = revolute_apart_apart(D_left_foot_apart_x, D_left_foot_apart_y, D_left_foot_apart_z, left_foot_apart_size)
    return (ca.vertcat(spindle_push_2, right_hinge_push_2, right_knee_push_2, left_hinge_push_2, left_knee_push_2, guide_push_2),
        ca.vertcat(right_foot_apart_x_independence, right_foot_apart_y_independence, right_foot_apart_z_independence,
            left_foot_apart_x_independence, left_foot_apart_y_independence, left_foot_apart_z_independence))


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
    arm_length, offset, spring_stiffness, spring_rest, half_arm_length, right_rod_h_y = c[0], c[3], c[5], c[6], c[7], c[8]
    right_rod_I_x_x, right_arm_h_y_2, half_right_arm_I_x_x_2, half_right_arm_I_y_y, half_right_rod_I_x_x = c[12], c[19], c[20], c[21], c[22]
    half_collar_mass, half_collar_inertia, half_spindle_inertia, half_ball_mass, half_rod_mass = c[23], c[24], c[25], c[26], c[27]
    half_rod_length, collar_mass_times_gravity, ball_mass_times_gravity, gravity_times_rod_mass = c[28], c[29], c[30], c[31]
    spindle_angle, right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle, guide_travel = q[0], q[1], q[2], q[3], q[4], q[5]
    spindle_speed, right_hinge_speed, right_knee_speed, left_hinge_speed, left_knee_speed, guide_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    cos_spindle = ca.cos(spindle_angle)
    sin_spindle = ca.sin(spindle_angle)
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    cos_right_rod = ca.cos(right_rod_angle)
    right_rod_turn = right_rod_angle - right_hinge_angle
    cos_right_rod_turn = ca.cos(right_rod_turn)
    sin_right_rod_turn = ca.sin(right_rod_turn)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    cos_left_rod = ca.cos(left_rod_angle)
    left_rod_turn = left_rod_angle - left_hinge_angle
    cos_left_rod_turn = ca.cos(left_rod_turn)
    sin_left_rod_turn = ca.sin(left_rod_turn)
    right_arm_arm_x = cos_spindle*offset
    right_rod_arm_y = -cos_right_arm*half_arm_length
    left_arm_arm_z = sin_spindle*offset
    left_rod_arm_y = -cos_left_arm*half_arm_length
    spring_stretch = guide_travel + spring_rest
    right_rod_moment_x = -right_rod_h_y*sin_right_rod_turn
    right_rod_moment_y = cos_right_rod_turn*right_rod_h_y
    left_rod_moment_x = right_rod_h_y*sin_left_rod_turn
    left_rod_moment_y = cos_left_rod_turn*right_rod_h_y
    right_arm_w_x = sin_right_arm*spindle_speed
    right_arm_w_y = cos_right_arm*spindle_speed
    right_rod_rate_z_2 = right_hinge_speed + right_knee_speed
    right_rod_J_swing = -right_rod_I_x_x*sin_right_rod_turn
    right_rod_J_x_x = right_rod_I_x_x + right_rod_J_swing*sin_right_rod_turn
    right_rod_J_y_y = -right_rod_J_swing*sin_right_rod_turn
    right_rod_J_x_y = -cos_right_rod_turn*right_rod_J_swing
    left_arm_w_x = -sin_left_arm*spindle_speed
    left_arm_w_y = cos_left_arm*spindle_speed
    left_rod_rate_z_2 = -left_hinge_speed - left_knee_speed
    left_rod_J_swing = right_rod_I_x_x*sin_left_rod_turn
    left_rod_J_x_x = right_rod_I_x_x - left_rod_J_swing*sin_left_rod_turn
    left_rod_J_y_y = left_rod_J_swing*sin_left_rod_turn
    left_rod_J_x_y = -cos_left_rod_turn*left_rod_J_swing
    x1 = right_arm_arm_x*sin_spindle*spindle_speed
    x2 = -cos_spindle*left_arm_arm_z*spindle_speed
    x3 = x1 + x2
    right_arm_velocity_x = cos_right_arm*x3
    right_arm_velocity_y = -sin_right_arm*x3
    right_arm_velocity_z = -cos_spindle*right_arm_arm_x*spindle_speed - left_arm_arm_z*sin_spindle*spindle_speed
    right_rod_velocity_x_2 = right_arm_velocity_x + half_arm_length*right_hinge_speed
    right_rod_velocity_z_2 = right_arm_velocity_z - half_arm_length*right_arm_w_x
    x4 = cos_spindle*left_arm_arm_z*spindle_speed
    x5 = -right_arm_arm_x*sin_spindle*spindle_speed
    x6 = x4 + x5
    left_arm_velocity_x = cos_left_arm*x6
    left_arm_velocity_y = sin_left_arm*x6
    left_arm_velocity_z = cos_spindle*right_arm_arm_x*spindle_speed + left_arm_arm_z*sin_spindle*spindle_speed
    left_rod_velocity_x_2 = left_arm_velocity_x - half_arm_length*left_hinge_speed
    left_rod_velocity_z_2 = left_arm_velocity_z - half_arm_length*left_arm_w_x
    spindle_speed_squared = spindle_speed*spindle_speed
    left_arm_velocity_y_squared = left_arm_velocity_y*left_arm_velocity_y
    right_arm_velocity_y_squared = right_arm_velocity_y*right_arm_velocity_y
    kinetic = half_right_rod_I_x_x*left_rod_rate_z_2*left_rod_rate_z_2 + half_right_rod_I_x_x*right_rod_rate_z_2*right_rod_rate_z_2 + half_collar_mass*guide_speed*guide_speed + half_collar_inertia*spindle_speed_squared + half_spindle_inertia*spindle_speed_squared + half_ball_mass*(left_arm_velocity_y_squared + left_arm_velocity_x*left_arm_velocity_x + left_arm_velocity_z*left_arm_velocity_z) + half_ball_mass*(right_arm_velocity_y_squared + right_arm_velocity_x*right_arm_velocity_x + right_arm_velocity_z*right_arm_velocity_z) + half_rod_mass*(left_arm_velocity_y_squared + left_rod_velocity_x_2*left_rod_velocity_x_2 + left_rod_velocity_z_2*left_rod_velocity_z_2) + half_rod_mass*(right_arm_velocity_y_squared + right_rod_velocity_x_2*right_rod_velocity_x_2 + right_rod_velocity_z_2*right_rod_velocity_z_2) + half_right_arm_I_x_x_2*left_arm_w_x*left_arm_w_x + half_right_arm_I_x_x_2*left_hinge_speed*left_hinge_speed + half_right_arm_I_x_x_2*right_arm_w_x*right_arm_w_x + half_right_arm_I_x_x_2*right_hinge_speed*right_hinge_speed + half_right_arm_I_y_y*left_arm_w_y*left_arm_w_y + half_right_arm_I_y_y*right_arm_w_y*right_arm_w_y + left_rod_velocity_z_2*(left_arm_w_x*left_rod_moment_y - left_arm_w_y*left_rod_moment_x) + right_rod_velocity_z_2*(right_arm_w_x*right_rod_moment_y - right_arm_w_y*right_rod_moment_x) + left_arm_w_x*(left_arm_w_x*left_rod_J_x_x + left_arm_w_y*left_rod_J_x_y)/2 + left_arm_w_y*(left_arm_w_x*left_rod_J_x_y + left_arm_w_y*left_rod_J_y_y)/2 + right_arm_w_x*(right_arm_w_x*right_rod_J_x_x + right_arm_w_y*right_rod_J_x_y)/2 + right_arm_w_y*(right_arm_w_x*right_rod_J_x_y + right_arm_w_y*right_rod_J_y_y)/2 + left_arm_velocity_x*left_hinge_speed*right_arm_h_y_2 + left_arm_velocity_y*left_rod_moment_x*left_rod_rate_z_2 + left_arm_velocity_z*left_arm_w_x*right_arm_h_y_2 + right_arm_h_y_2*right_arm_velocity_z*right_arm_w_x + right_arm_velocity_y*right_rod_moment_x*right_rod_rate_z_2 - left_rod_moment_y*left_rod_rate_z_2*left_rod_velocity_x_2 - right_arm_h_y_2*right_arm_velocity_x*right_hinge_speed - right_rod_moment_y*right_rod_rate_z_2*right_rod_velocity_x_2
    right_arm_centre_arm_y = -cos_right_arm*arm_length
    right_rod_centre_arm_y = -cos_right_rod*half_rod_length
    left_arm_centre_arm_y = -cos_left_arm*arm_length
    left_rod_centre_arm_y = -cos_left_rod*half_rod_length
    potential = guide_travel*collar_mass_times_gravity + ball_mass_times_gravity*left_arm_centre_arm_y + ball_mass_times_gravity*right_arm_centre_arm_y + gravity_times_rod_mass*(left_rod_arm_y + left_rod_centre_arm_y) + gravity_times_rod_mass*(right_rod_arm_y + right_rod_centre_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential + spring_stretch*spring_stretch*spring_stiffness/2), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (18,): spindle.x [m], spindle.y [m], spindle.z [m], right_arm.x [m], right_arm.y [m], right_arm.z [m], right_rod.x [m],
            right_rod.y [m], right_rod.z [m], left_arm.x [m], left_arm.y [m], left_arm.z [m], left_rod.x [m], left_rod.y [m], left_rod.z
            [m], collar.x [m], collar.y [m], collar.z [m]
        rotations (54,): spindle.R_xx [1], spindle.R_xy [1], spindle.R_xz [1], spindle.R_yx [1], spindle.R_yy [1], spindle.R_yz [1],
            spindle.R_zx [1], spindle.R_zy [1], spindle.R_zz [1], right_arm.R_xx [1], right_arm.R_xy [1], right_arm.R_xz [1], right_arm.R_yx
            [1], right_arm.R_yy [1], right_arm.R_yz [1], right_arm.R_zx [1], right_arm.R_zy [1], right_arm.R_zz [1], right_rod.R_xx [1],
            right_rod.R_xy [1], right_rod.R_xz [1], right_rod.R_yx [1], right_rod.R_yy [1], right_rod.R_yz [1], right_rod.R_zx [1],
            right_rod.R_zy [1], right_rod.R_zz [1], left_arm.R_xx [1], left_arm.R_xy [1], left_arm.R_xz [1], left_arm.R_yx [1],
            left_arm.R_yy [1], left_arm.R_yz [1], left_arm.R_zx [1], left_arm.R_zy [1], left_arm.R_zz [1], left_rod.R_xx [1], left_rod.R_xy
            [1], left_rod.R_xz [1], left_rod.R_yx [1], left_rod.R_yy [1], left_rod.R_yz [1], left_rod.R_zx [1], left_rod.R_zy [1],
            left_rod.R_zz [1], collar.R_xx [1], collar.R_xy [1], collar.R_xz [1], collar.R_yx [1], collar.R_yy [1], collar.R_yz [1],
            collar.R_zx [1], collar.R_zy [1], collar.R_zz [1]
    """
    offset, half_arm_length = c[3], c[7]
    spindle_angle, right_hinge_angle, right_knee_angle, left_hinge_angle, left_knee_angle, guide_travel = q[0], q[1], q[2], q[3], q[4], q[5]
    cos_spindle = ca.cos(spindle_angle)
    sin_spindle = ca.sin(spindle_angle)
    cos_right_arm = ca.cos(right_hinge_angle)
    sin_right_arm = ca.sin(right_hinge_angle)
    right_rod_angle = right_hinge_angle + right_knee_angle
    cos_right_rod = ca.cos(right_rod_angle)
    sin_right_rod = ca.sin(right_rod_angle)
    cos_left_arm = ca.cos(left_hinge_angle)
    sin_left_arm = ca.sin(left_hinge_angle)
    left_rod_angle = left_hinge_angle + left_knee_angle
    cos_left_rod = ca.cos(left_rod_angle)
    sin_left_rod = ca.sin(left_rod_angle)
    right_arm_arm_x = cos_spindle*offset
    right_arm_arm_z = -sin_spindle*offset
    right_arm_R_x_x = cos_right_arm*cos_spindle
    right_arm_R_x_y = -cos_spindle*sin_right_arm
    right_arm_R_z_x = -cos_right_arm*sin_spindle
    right_arm_R_z_y = sin_right_arm*sin_spindle
    right_rod_arm_x = -half_arm_length*right_arm_R_x_y
    right_rod_arm_y = -cos_right_arm*half_arm_length
    right_rod_arm_z = -half_arm_length*right_arm_R_z_y
    right_rod_x = right_arm_arm_x + right_rod_arm_x
    right_rod_z = right_arm_arm_z + right_rod_arm_z
    right_rod_R_x_x = cos_right_rod*cos_spindle
    right_rod_R_x_y = -cos_spindle*sin_right_rod
    right_rod_R_z_x = -cos_right_rod*sin_spindle
    right_rod_R_z_y = sin_right_rod*sin_spindle
    left_arm_arm_z = sin_spindle*offset
    left_arm_R_x_x = cos_left_arm*cos_spindle
    left_arm_R_x_y = cos_spindle*sin_left_arm
    left_arm_R_z_x = -cos_left_arm*sin_spindle
    left_arm_R_z_y = -sin_left_arm*sin_spindle
    left_rod_arm_x = -half_arm_length*left_arm_R_x_y
    left_rod_arm_y = -cos_left_arm*half_arm_length
    left_rod_arm_z = -half_arm_length*left_arm_R_z_y
    left_rod_x = left_rod_arm_x - right_arm_arm_x
    left_rod_z = left_arm_arm_z + left_rod_arm_z
    left_rod_R_x_x = cos_left_rod*cos_spindle
    left_rod_R_x_y = cos_spindle*sin_left_rod
    left_rod_R_z_x = -cos_left_rod*sin_spindle
    left_rod_R_z_y = -sin_left_rod*sin_spindle
    return (ca.vertcat(0, 0, 0, right_arm_arm_x, 0, right_arm_arm_z, right_rod_x, right_rod_arm_y, right_rod_z, -right_arm_arm_x, 0,
            left_arm_arm_z, left_rod_x, left_rod_arm_y, left_rod_z, 0, guide_travel, 0),
        ca.vertcat(cos_spindle, 0, sin_spindle, 0, 1, 0, -sin_spindle, 0, cos_spindle, right_arm_R_x_x, right_arm_R_x_y, sin_spindle,
            sin_right_arm, cos_right_arm, 0, right_arm_R_z_x, right_arm_R_z_y, cos_spindle, right_rod_R_x_x, right_rod_R_x_y, sin_spindle,
            sin_right_rod, cos_right_rod, 0, right_rod_R_z_x, right_rod_R_z_y, cos_spindle, left_arm_R_x_x, left_arm_R_x_y, sin_spindle,
            -sin_left_arm, cos_left_arm, 0, left_arm_R_z_x, left_arm_R_z_y, cos_spindle, left_rod_R_x_x, left_rod_R_x_y, sin_spindle,
            -sin_left_rod, cos_left_rod, 0, left_rod_R_z_x, left_rod_R_z_y, cos_spindle, cos_spindle, 0, sin_spindle, 0, 1, 0, -sin_spindle,
            0, cos_spindle))


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
        spindle.parent to spring.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        spring.child to collar.centre (3,): x [m], y [m], z [m]
    """
    arm_length, rod_length, offset = p[4], p[6], p[9]
    minus_half_arm_length = -arm_length/2
    minus_half_rod_length = -rod_length/2
    return (ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(offset, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, minus_half_arm_length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(-offset, 0, 0, 0, 0, -1),
        ca.vertcat(*[0]*5, -1), ca.vertcat(0, minus_half_arm_length, 0, 0, 0, -1), ca.vertcat(*[0]*5, -1), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(offset, 0, 0, 0, 0, 1), ca.vertcat(0, -rod_length, 0, 0, 0, 1),
        ca.vertcat(-offset, 0, 0, 0, 0, -1), ca.vertcat(0, -rod_length, 0, 0, 0, -1), ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, -arm_length, 0),
        ca.vertcat(0, minus_half_rod_length, 0), ca.vertcat(0, -arm_length, 0), ca.vertcat(0, minus_half_rod_length, 0),
        ca.vertcat(0, 0, 0))
