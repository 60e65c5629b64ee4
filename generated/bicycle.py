"""bicycle: self-stable bicycle on wheels without slip. Generated from derive/scenes/bicycle.py.

Do not edit; regenerate with `hertzwerk derive bicycle`.
Effects:
    gravity: uniform gravity
    rear_grip: rolling without slip at rear_tyre
    front_grip: rolling without slip at front_tyre
    energy_ledger: work put in, energy dissipated per effect
Units: 904 assignments and 409 outputs checked, all consistent
Operations: flight 3140 (equations of motion and gaps)
"""

import casadi as ca

NAME = "bicycle"
SOURCE = "derive/scenes/bicycle.py"
SUMMARY = "self-stable bicycle on wheels without slip"
FORMAT = "hertzwerk module 1"
DIGEST = "ff496441302a5bd2e05ffa9f74d5dd95"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("rear_grip", "rolling_without_slip", "rolling without slip at rear_tyre"),
    ("front_grip", "rolling_without_slip", "rolling without slip at front_tyre"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("frame_mass", "kg", 85, "body frame, mass"),
    ("frame_xx", "kg m^2", 9.2, "body frame, inertia"),
    ("frame_yy", "kg m^2", 11, "body frame, inertia"),
    ("frame_zz", "kg m^2", 2.8, "body frame, inertia"),
    ("frame_xz", "kg m^2", -2.4, "body frame, inertia J_xz"),
    ("frame_x", "m", 0.3, "body frame, mass centre"),
    ("frame_z", "m", 0.9, "body frame, mass centre"),
    ("rear_wheel_mass", "kg", 2, "body rear_wheel, mass"),
    ("rear_wheel_xx", "kg m^2", 0.0603, "body rear_wheel, inertia"),
    ("rear_wheel_yy", "kg m^2", 0.12, "body rear_wheel, inertia"),
    ("rear_wheel_zz", "kg m^2", 0.0603, "body rear_wheel, inertia"),
    ("fork_mass", "kg", 4, "body fork, mass"),
    ("fork_xx", "kg m^2", 0.05892, "body fork, inertia"),
    ("fork_yy", "kg m^2", 0.06, "body fork, inertia"),
    ("fork_zz", "kg m^2", 0.00708, "body fork, inertia"),
    ("fork_xz", "kg m^2", 0.00756, "body fork, inertia J_xz"),
    ("fork_x", "m", 0.9, "body fork, mass centre"),
    ("fork_z", "m", 0.7, "body fork, mass centre"),
    ("front_wheel_mass", "kg", 3, "body front_wheel, mass"),
    ("front_wheel_xx", "kg m^2", 0.1405, "body front_wheel, inertia"),
    ("front_wheel_yy", "kg m^2", 0.28, "body front_wheel, inertia"),
    ("front_wheel_zz", "kg m^2", 0.1405, "body front_wheel, inertia"),
    ("rear_radius", "m", 0.3, "point of leaning"),
    ("trail", "m", 0.08, ""),
    ("wheel_base", "m", 1.02, "point of fork"),
    ("steer_axis_tilt", "rad", 0.3141592653589793, ""),
    ("front_radius", "m", 0.35, "point of fork"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("origin", "m", 0, "start, position of path.x"),
    ("upright", "rad", 0, "start, position of path.angle"),
    ("push", "rad/s", 0.5, "speed of leaning at the start"),
    ("speed", "m/s", 5, ""),
    ("steering", "rad/s", 0, "start, speed of steer"),
    ("pace", "m/s", 5, "scales, speed"),
)

LIMITS = (
    ("frame_mass", "defined", 0, None, True, False, "body frame, mass"),
    ("frame_xx", "defined", 0, None, False, False, "body frame, inertia"),
    ("frame_yy", "defined", 0, None, False, False, "body frame, inertia"),
    ("frame_zz", "defined", 0, None, False, False, "body frame, inertia"),
    ("rear_wheel_mass", "defined", 0, None, True, False, "body rear_wheel, mass"),
    ("rear_wheel_xx", "defined", 0, None, False, False, "body rear_wheel, inertia"),
    ("rear_wheel_yy", "defined", 0, None, False, False, "body rear_wheel, inertia"),
    ("rear_wheel_zz", "defined", 0, None, False, False, "body rear_wheel, inertia"),
    ("fork_mass", "defined", 0, None, True, False, "body fork, mass"),
    ("fork_xx", "defined", 0, None, False, False, "body fork, inertia"),
    ("fork_yy", "defined", 0, None, False, False, "body fork, inertia"),
    ("fork_zz", "defined", 0, None, False, False, "body fork, inertia"),
    ("front_wheel_mass", "defined", 0, None, True, False, "body front_wheel, mass"),
    ("front_wheel_xx", "defined", 0, None, False, False, "body front_wheel, inertia"),
    ("front_wheel_yy", "defined", 0, None, False, False, "body front_wheel, inertia"),
    ("front_wheel_zz", "defined", 0, None, False, False, "body front_wheel, inertia"),
    ("rear_radius", "defined", 0, None, True, False, "pair rear_tyre, radius"),
    ("front_radius", "defined", 0, None, True, False, "pair front_tyre, radius"),
    ("pace", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (
    ("path.x", "m"), ("path.y", "m"), ("path.angle", "rad"), ("height.travel", "m"), ("lean.angle", "rad"), ("pitch.angle", "rad"),
    ("rear_hub.angle", "rad"), ("steer.angle", "rad"), ("front_hub.angle", "rad"),
)

SPEEDS = (
    ("path.x_speed", "m/s"), ("path.y_speed", "m/s"), ("path.angle_speed", "rad/s"), ("height.speed", "m/s"), ("lean.speed", "rad/s"),
    ("pitch.speed", "rad/s"), ("rear_hub.speed", "rad/s"), ("steer.speed", "rad/s"), ("front_hub.speed", "rad/s"),
)

CONSTRAINTS = (
    ("rear_grip.gap", "m"), ("rear_grip.sliding_velocity_1", "m/s"), ("rear_grip.sliding_velocity_2", "m/s"), ("front_grip.gap", "m"),
    ("front_grip.sliding_velocity_1", "m/s"), ("front_grip.sliding_velocity_2", "m/s"),
)

ROLLING = (("rear_grip", False), ("front_grip", False))

GIVEN = (
    "path.x", "path.y", "path.angle", "lean.angle", "lean.speed", "rear_hub.angle", "rear_hub.speed", "steer.angle", "steer.speed",
    "front_hub.angle",
)

BODIES = ("heading", "lifted", "leaning", "frame", "rear_wheel", "fork", "front_wheel")

LANDMARKS = (
    ("path", "planar", "parent", "ground", ("normal",)), ("path", "planar", "child", "heading", ("normal",)),
    ("height", "prismatic", "parent", "heading", ("axis",)), ("height", "prismatic", "child", "lifted", ("axis",)),
    ("lean", "revolute", "parent", "lifted", ("axis",)), ("lean", "revolute", "child", "leaning", ("axis",)),
    ("pitch", "revolute", "parent", "leaning", ("axis",)), ("pitch", "revolute", "child", "frame", ("axis",)),
    ("rear_hub", "revolute", "parent", "frame", ("axis",)), ("rear_hub", "revolute", "child", "rear_wheel", ("axis",)),
    ("steer", "revolute", "parent", "frame", ("axis",)), ("steer", "revolute", "child", "fork", ("axis",)),
    ("front_hub", "revolute", "parent", "fork", ("axis",)), ("front_hub", "revolute", "child", "front_wheel", ("axis",)),
    ("rear_tyre", "rim_on_plane", "disc", "rear_wheel", ("radius", "axis")), ("rear_tyre", "rim_on_plane", "plane", "ground", ("normal",)),
    ("front_tyre", "rim_on_plane", "disc", "front_wheel", ("radius", "axis")),
    ("front_tyre", "rim_on_plane", "plane", "ground", ("normal",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("frame", "body", "centre", "frame", ()), ("rear_wheel", "body", "centre", "rear_wheel", ()), ("fork", "body", "centre", "fork", ()),
    ("front_wheel", "body", "centre", "front_wheel", ()),
)

CONSTANTS = (
    ("frame_x", "m"), ("rear_wheel_xx", "kg m^2"), ("rear_wheel_yy", "kg m^2"), ("rear_wheel_zz", "kg m^2"), ("front_wheel_xx", "kg m^2"),
    ("front_wheel_yy", "kg m^2"), ("front_wheel_zz", "kg m^2"), ("rear_radius", "m"), ("front_radius", "m"), ("gravity", "m/s^2"),
    ("fork_lined_up_x_x", "1"), ("fork_lined_up_x_z", "1"), ("fork_lined_up_y_y", "1"), ("fork_lined_up_z_x", "1"),
    ("fork_lined_up_z_z", "1"), ("trail_plus_wheel_base", "m"), ("k2", "m"), ("k3", "m"), ("frame_total_mass", "kg"), ("fork_h_x", "kg m"),
    ("fork_h_z", "kg m"), ("frame_h_x", "kg m"), ("frame_h_z", "kg m"), ("fork_h_x_times_fork_lined_up_x_x", "kg m"), ("k5", "kg m"),
    ("fork_h_x_times_fork_lined_up_y_y", "kg m"), ("fork_h_x_times_fork_lined_up_z_x", "kg m"), ("k8", "kg m"), ("leaning_h_z", "kg m"),
    ("leaning_I_y_y", "kg m^2"), ("frame_I_x_x", "kg m^2"), ("frame_I_z_z", "kg m^2"), ("frame_I_y_y", "kg m^2"), ("frame_I_x_z", "kg m^2"),
    ("rear_wheel_xx_minus_rear_wheel_zz", "kg m^2"), ("fork_I_x_x", "kg m^2"), ("fork_I_z_z", "kg m^2"), ("fork_I_y_y", "kg m^2"),
    ("fork_I_x_z", "kg m^2"), ("front_wheel_yy_minus_front_wheel_zz", "kg m^2"), ("front_wheel_xx_minus_front_wheel_zz", "kg m^2"),
    ("front_wheel_xx_minus_front_wheel_yy", "kg m^2"), ("fork_I_y_y_minus_fork_I_z_z", "kg m^2"), ("fork_I_x_x_minus_fork_I_z_z", "kg m^2"),
    ("fork_I_x_x_minus_fork_I_y_y", "kg m^2"), ("frame_I_y_y_minus_frame_I_z_z", "kg m^2"), ("frame_I_x_x_minus_frame_I_z_z", "kg m^2"),
    ("frame_I_x_x_minus_frame_I_y_y", "kg m^2"), ("twice_leaning_I_y_y", "kg m^2"), ("front_wheel_turned_J_y_y", "kg m^2"),
    ("fork_total_J_y_y", "kg m^2"), ("fork_h_z_times_fork_lined_up_x_z", "kg m"), ("fork_h_z_times_fork_lined_up_z_z", "kg m"),
    ("twice_rear_radius", "m"), ("k23", "m"), ("frame_I_y_y_plus_rear_wheel_yy", "kg m^2"), ("k25", "kg m^2"), ("k26", "kg m^2"),
    ("inverse_front_wheel_yy", "1/(kg m^2)"), ("inverse_rear_wheel_yy", "1/(kg m^2)"), ("frame_h_x_2", "kg m"), ("frame_h_z_2", "kg m"),
    ("frame_I_x_x_2", "kg m^2"), ("frame_I_x_z_2", "kg m^2"), ("frame_I_z_z_2", "kg m^2"), ("fork_h_x_2", "kg m"), ("fork_h_z_2", "kg m"),
    ("fork_I_x_x_2", "kg m^2"), ("fork_I_x_z_2", "kg m^2"), ("fork_I_z_z_2", "kg m^2"), ("half_fork_I_y_y_2", "kg m^2"),
    ("half_frame_I_y_y_2", "kg m^2"), ("half_front_wheel_yy", "kg m^2"), ("half_front_wheel_xx", "kg m^2"),
    ("half_front_wheel_zz", "kg m^2"), ("half_rear_wheel_yy", "kg m^2"), ("half_fork_mass", "kg"), ("half_frame_mass", "kg"),
    ("half_rear_wheel_mass", "kg"), ("half_front_wheel_mass", "kg"), ("frame_z_minus_rear_radius", "m"), ("k40", "m"), ("k41", "m"),
    ("gravity_times_rear_wheel_mass", "N"), ("front_wheel_mass_times_gravity", "N"), ("fork_mass_times_gravity", "N"),
    ("frame_mass_times_gravity", "N"), ("k46", "m"), ("k47", "m"), ("rear_grip_gap_softness", "1"),
    ("rear_grip_sliding_velocity_1_softness", "1"), ("rear_grip_sliding_velocity_2_softness", "1"), ("front_grip_gap_softness", "1"),
    ("front_grip_sliding_velocity_1_softness", "1"), ("front_grip_sliding_velocity_2_softness", "1"),
)

OPERATIONS = (
    ("constants", 191), ("start", 1), ("scales", 8), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 38),
    ("accelerations", 3102), ("constraints", 220), ("projection", 1872), ("ledger", 0), ("energy", 265), ("poses", 183), ("outputs", 0),
    ("rolling_limits", 0), ("landmarks", 11),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def rim_on_plane_gap(first_rate_x, first_rate_y, first_rate_z, x, y, axis_z, z, velocity_x, velocity_y, velocity_z, speed, radius):
    """Return gap [m], gap_velocity_x [m/s], gap_velocity_y [m/s], gap_velocity_z [m/s]."""
    turning_x = speed*x
    turning_y = speed*y
    turning_z = speed*axis_z
    second_rate_x = first_rate_x + turning_x
    second_rate_y = first_rate_y + turning_y
    second_rate_z = first_rate_z + turning_z
    up_x = -x*axis_z
    up_y = -y*axis_z
    up_z = 1 - axis_z*axis_z
    rise = ca.sqrt(up_z)
    rim_x = -up_x*radius/rise
    rim_y = -up_y*radius/rise
    rim_z = -up_z*radius/rise
    gap = z - radius*rise
    gap_velocity_x = velocity_x + second_rate_y*rim_z - second_rate_z*rim_y
    gap_velocity_y = velocity_y + second_rate_z*rim_x - second_rate_x*rim_z
    gap_velocity_z = velocity_z + second_rate_x*rim_y - second_rate_y*rim_x
    return gap, gap_velocity_x, gap_velocity_y, gap_velocity_z


def revolute_constants_terms(axis_tilt):
    """Return cos, sin."""
    cos = ca.cos(axis_tilt)
    sin = ca.sin(axis_tilt)
    return cos, sin


def rolling_without_slip_l_gap_gap(W_gap_gap, W_sliding_velocity_1_gap, W_sliding_velocity_2_gap, W_gap_raised):
    """Return l_gap_gap [1], l_sliding_velocity_1_gap [1], l_sliding_velocity_2_gap [1]."""
    l_gap_gap = W_gap_gap/W_gap_raised
    l_sliding_velocity_1_gap = W_sliding_velocity_1_gap/W_gap_raised
    l_sliding_velocity_2_gap = W_sliding_velocity_2_gap/W_gap_raised
    return l_gap_gap, l_sliding_velocity_1_gap, l_sliding_velocity_2_gap


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (95,): frame_x, rear_wheel_xx, rear_wheel_yy, rear_wheel_zz, front_wheel_xx, front_wheel_yy, front_wheel_zz, rear_radius,
            front_radius, gravity, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y, fork_lined_up_z_x, fork_lined_up_z_z,
            trail_plus_wheel_base, k2, k3, frame_total_mass, fork_h_x, fork_h_z, frame_h_x, frame_h_z, fork_h_x_times_fork_lined_up_x_x, k5,
            fork_h_x_times_fork_lined_up_y_y, fork_h_x_times_fork_lined_up_z_x, k8, leaning_h_z, leaning_I_y_y, frame_I_x_x, frame_I_z_z,
            frame_I_y_y, frame_I_x_z, rear_wheel_xx_minus_rear_wheel_zz, fork_I_x_x, fork_I_z_z, fork_I_y_y, fork_I_x_z,
            front_wheel_yy_minus_front_wheel_zz, front_wheel_xx_minus_front_wheel_zz, front_wheel_xx_minus_front_wheel_yy,
            fork_I_y_y_minus_fork_I_z_z, fork_I_x_x_minus_fork_I_z_z, fork_I_x_x_minus_fork_I_y_y, frame_I_y_y_minus_frame_I_z_z,
            frame_I_x_x_minus_frame_I_z_z, frame_I_x_x_minus_frame_I_y_y, twice_leaning_I_y_y, front_wheel_turned_J_y_y, fork_total_J_y_y,
            fork_h_z_times_fork_lined_up_x_z, fork_h_z_times_fork_lined_up_z_z, twice_rear_radius, k23, frame_I_y_y_plus_rear_wheel_yy, k25,
            k26, inverse_front_wheel_yy, inverse_rear_wheel_yy, frame_h_x_2, frame_h_z_2, frame_I_x_x_2, frame_I_x_z_2, frame_I_z_z_2,
            fork_h_x_2, fork_h_z_2, fork_I_x_x_2, fork_I_x_z_2, fork_I_z_z_2, half_fork_I_y_y_2, half_frame_I_y_y_2, half_front_wheel_yy,
            half_front_wheel_xx, half_front_wheel_zz, half_rear_wheel_yy, half_fork_mass, half_frame_mass, half_rear_wheel_mass,
            half_front_wheel_mass, frame_z_minus_rear_radius, k40, k41, gravity_times_rear_wheel_mass, front_wheel_mass_times_gravity,
            fork_mass_times_gravity, frame_mass_times_gravity, k46, k47, rear_grip_gap_softness, rear_grip_sliding_velocity_1_softness,
            rear_grip_sliding_velocity_2_softness, front_grip_gap_softness, front_grip_sliding_velocity_1_softness,
            front_grip_sliding_velocity_2_softness
    """
    frame_mass, frame_xx, frame_yy, frame_zz, frame_xz, frame_x, frame_z, rear_wheel_mass = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    rear_wheel_xx, rear_wheel_yy, rear_wheel_zz, fork_mass, fork_xx, fork_yy, fork_zz = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    fork_xz, fork_x, fork_z, front_wheel_mass, front_wheel_xx, front_wheel_yy = p[15], p[16], p[17], p[18], p[19], p[20]
    front_wheel_zz, rear_radius, trail, wheel_base, front_radius, gravity = p[21], p[22], p[23], p[24], p[26], p[27]
    cos, sin = revolute_constants_terms(p[25])
    cos_steer_axis_tilt_squared = cos*cos
    sin_steer_axis_tilt_squared = sin*sin
    x5 = cos_steer_axis_tilt_squared + sin_steer_axis_tilt_squared
    x6 = 1/ca.sqrt(x5)
    x7 = cos_steer_axis_tilt_squared/x5
    x8 = sin_steer_axis_tilt_squared/x5
    x9 = x7 + x8
    x10 = 1/ca.sqrt(x9)
    fork_lined_up_x_x = cos*x10*x6
    fork_lined_up_x_z = -sin*x6
    fork_lined_up_y_y = x10*cos_steer_axis_tilt_squared/x5 + x10*sin_steer_axis_tilt_squared/x5
    fork_lined_up_z_x = x10*sin*x6
    fork_lined_up_z_z = cos*x6
    trail_plus_wheel_base = trail + wheel_base
    fork_lined_up_x_x_times_wheel_base = fork_lined_up_x_x*wheel_base
    fork_lined_up_z_x_times_front_radius = fork_lined_up_z_x*front_radius
    x13 = -fork_lined_up_x_x*trail_plus_wheel_base
    k2 = fork_lined_up_x_x_times_wheel_base + fork_lined_up_z_x_times_front_radius + x13
    fork_lined_up_x_z_times_wheel_base = fork_lined_up_x_z*wheel_base
    fork_lined_up_z_z_times_front_radius = fork_lined_up_z_z*front_radius
    x16 = -fork_lined_up_x_z*trail_plus_wheel_base
    k3 = fork_lined_up_x_z_times_wheel_base + fork_lined_up_z_z_times_front_radius + x16
    fork_total_mass = fork_mass + front_wheel_mass
    frame_total_mass = fork_total_mass + frame_mass + rear_wheel_mass
    fork_lined_up_x_x_times_fork_x = fork_lined_up_x_x*fork_x
    fork_lined_up_z_x_times_fork_z = fork_lined_up_z_x*fork_z
    k40 = x13 + fork_lined_up_x_x_times_fork_x + fork_lined_up_z_x_times_fork_z
    fork_h_x_2 = k40*fork_mass
    fork_h_x = fork_h_x_2 + k2*front_wheel_mass
    fork_lined_up_x_z_times_fork_x = fork_lined_up_x_z*fork_x
    fork_lined_up_z_z_times_fork_z = fork_lined_up_z_z*fork_z
    k41 = x16 + fork_lined_up_x_z_times_fork_x + fork_lined_up_z_z_times_fork_z
    fork_h_z_2 = k41*fork_mass
    fork_h_z = fork_h_z_2 + k3*front_wheel_mass
    frame_h_x_2 = frame_mass*frame_x
    frame_h_x = frame_h_x_2 + fork_total_mass*trail_plus_wheel_base
    frame_z_minus_rear_radius = frame_z - rear_radius
    frame_h_z_2 = frame_z_minus_rear_radius*frame_mass
    frame_h_z = frame_h_z_2 - fork_total_mass*rear_radius
    fork_h_x_times_fork_lined_up_x_x = fork_h_x*fork_lined_up_x_x
    fork_h_z_times_fork_lined_up_x_z = fork_h_z*fork_lined_up_x_z
    k5 = frame_h_x + fork_h_z_times_fork_lined_up_x_z
    fork_h_x_times_fork_lined_up_y_y = fork_h_x*fork_lined_up_y_y
    fork_h_x_times_fork_lined_up_z_x = fork_h_x*fork_lined_up_z_x
    fork_h_z_times_fork_lined_up_z_z = fork_h_z*fork_lined_up_z_z
    k8 = frame_h_z + fork_h_z_times_fork_lined_up_z_z
    leaning_h_z = frame_total_mass*rear_radius
    rear_radius_squared = rear_radius*rear_radius
    leaning_I_y_y = frame_total_mass*rear_radius_squared
    x31 = frame_z_minus_rear_radius*frame_z_minus_rear_radius
    x32 = x31*frame_mass
    frame_I_x_x = x32 + fork_total_mass*rear_radius_squared + frame_xx
    x33 = trail_plus_wheel_base*trail_plus_wheel_base
    frame_x_squared = frame_x*frame_x
    frame_x_squared_times_frame_mass = frame_x_squared*frame_mass
    frame_I_z_z = frame_x_squared_times_frame_mass + fork_total_mass*x33 + frame_zz
    x36 = x31 + frame_x_squared
    x37 = x36*frame_mass
    frame_I_y_y = x37 + fork_total_mass*(rear_radius_squared + x33) + frame_yy
    x38 = -frame_z_minus_rear_radius*frame_mass*frame_x
    frame_I_x_z = x38 + fork_total_mass*trail_plus_wheel_base*rear_radius + frame_xz
    rear_wheel_xx_minus_rear_wheel_zz = rear_wheel_xx - rear_wheel_zz
    fork_lined_up_x_x_times_fork_xx = fork_lined_up_x_x*fork_xx
    fork_lined_up_z_x_times_fork_xz = fork_lined_up_z_x*fork_xz
    x41 = fork_lined_up_x_x_times_fork_xx + fork_lined_up_z_x_times_fork_xz
    x42 = fork_lined_up_x_x*x41
    fork_lined_up_x_x_times_fork_xz = fork_lined_up_x_x*fork_xz
    fork_lined_up_z_x_times_fork_zz = fork_lined_up_z_x*fork_zz
    x45 = fork_lined_up_x_x_times_fork_xz + fork_lined_up_z_x_times_fork_zz
    x46 = fork_lined_up_z_x*x45
    k41_squared = k41*k41
    k41_squared_times_fork_mass = k41_squared*fork_mass
    x49 = k3*k3
    fork_I_x_x = x42 + x46 + k41_squared_times_fork_mass + x49*front_wheel_mass
    fork_lined_up_x_z_times_fork_xx = fork_lined_up_x_z*fork_xx
    fork_lined_up_z_z_times_fork_xz = fork_lined_up_z_z*fork_xz
    x52 = fork_lined_up_x_z_times_fork_xx + fork_lined_up_z_z_times_fork_xz
    x53 = fork_lined_up_x_z*x52
    fork_lined_up_x_z_times_fork_xz = fork_lined_up_x_z*fork_xz
    fork_lined_up_z_z_times_fork_zz = fork_lined_up_z_z*fork_zz
    x56 = fork_lined_up_x_z_times_fork_xz + fork_lined_up_z_z_times_fork_zz
    x57 = fork_lined_up_z_z*x56
    k40_squared = k40*k40
    k40_squared_times_fork_mass = k40_squared*fork_mass
    x60 = k2*k2
    fork_I_z_z = x53 + x57 + k40_squared_times_fork_mass + x60*front_wheel_mass
    fork_lined_up_y_y_squared = fork_lined_up_y_y*fork_lined_up_y_y
    fork_lined_up_y_y_squared_times_fork_yy = fork_lined_up_y_y_squared*fork_yy
    k41_squared_plus_k40_squared = k41_squared + k40_squared
    x64 = k41_squared_plus_k40_squared*fork_mass
    fork_I_y_y = fork_lined_up_y_y_squared_times_fork_yy + x64 + (x49 + x60)*front_wheel_mass
    x65 = fork_lined_up_x_z*x41
    x66 = fork_lined_up_z_z*x45
    minus_k40_times_k41_times_fork_mass = -k40*k41*fork_mass
    fork_I_x_z = x65 + x66 + minus_k40_times_k41_times_fork_mass - k2*k3*front_wheel_mass
    front_wheel_yy_minus_front_wheel_zz = front_wheel_yy - front_wheel_zz
    front_wheel_xx_minus_front_wheel_zz = front_wheel_xx - front_wheel_zz
    front_wheel_xx_minus_front_wheel_yy = front_wheel_xx - front_wheel_yy
    fork_I_y_y_minus_fork_I_z_z = fork_I_y_y - fork_I_z_z
    fork_I_x_x_minus_fork_I_z_z = fork_I_x_x - fork_I_z_z
    fork_I_x_x_minus_fork_I_y_y = fork_I_x_x - fork_I_y_y
    frame_I_y_y_minus_frame_I_z_z = frame_I_y_y - frame_I_z_z
    frame_I_x_x_minus_frame_I_z_z = frame_I_x_x - frame_I_z_z
    frame_I_x_x_minus_frame_I_y_y = frame_I_x_x - frame_I_y_y
    twice_leaning_I_y_y = 2*leaning_I_y_y
    front_wheel_turned_J_half_y_y = fork_lined_up_y_y*front_wheel_yy
    front_wheel_turned_J_y_y = fork_lined_up_y_y*front_wheel_turned_J_half_y_y
    fork_total_J_y_y = fork_I_y_y + front_wheel_turned_J_y_y
    twice_rear_radius = 2*rear_radius
    k23 = 2*trail_plus_wheel_base
    frame_I_y_y_plus_rear_wheel_yy = frame_I_y_y + rear_wheel_yy
    k25 = fork_lined_up_x_x*front_wheel_turned_J_half_y_y
    k26 = fork_lined_up_z_x*front_wheel_turned_J_half_y_y
    inverse_front_wheel_yy = 1/front_wheel_yy
    inverse_rear_wheel_yy = 1/rear_wheel_yy
    frame_I_x_x_2 = x32 + frame_xx
    frame_I_x_z_2 = x38 + frame_xz
    frame_I_y_y_2 = x37 + frame_yy
    frame_I_z_z_2 = frame_x_squared_times_frame_mass + frame_zz
    fork_I_x_x_2 = x42 + x46 + k41_squared_times_fork_mass
    fork_I_x_z_2 = x65 + x66 + minus_k40_times_k41_times_fork_mass
    fork_I_y_y_2 = fork_lined_up_y_y_squared_times_fork_yy + x64
    fork_I_z_z_2 = x53 + x57 + k40_squared_times_fork_mass
    half_fork_I_y_y_2 = fork_I_y_y_2/2
    half_frame_I_y_y_2 = frame_I_y_y_2/2
    half_front_wheel_yy = front_wheel_yy/2
    half_front_wheel_xx = front_wheel_xx/2
    half_front_wheel_zz = front_wheel_zz/2
    half_rear_wheel_yy = rear_wheel_yy/2
    half_fork_mass = fork_mass/2
    half_frame_mass = frame_mass/2
    half_rear_wheel_mass = rear_wheel_mass/2
    half_front_wheel_mass = front_wheel_mass/2
    gravity_times_rear_wheel_mass = gravity*rear_wheel_mass
    front_wheel_mass_times_gravity = front_wheel_mass*gravity
    fork_mass_times_gravity = fork_mass*gravity
    frame_mass_times_gravity = frame_mass*gravity
    k46 = fork_lined_up_x_x*trail_plus_wheel_base
    k47 = fork_lined_up_x_z*trail_plus_wheel_base
    return ca.vertcat(frame_x, rear_wheel_xx, rear_wheel_yy, rear_wheel_zz, front_wheel_xx, front_wheel_yy, front_wheel_zz, rear_radius,
        front_radius, gravity, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y, fork_lined_up_z_x, fork_lined_up_z_z,
        trail_plus_wheel_base, k2, k3, frame_total_mass, fork_h_x, fork_h_z, frame_h_x, frame_h_z, fork_h_x_times_fork_lined_up_x_x, k5,
        fork_h_x_times_fork_lined_up_y_y, fork_h_x_times_fork_lined_up_z_x, k8, leaning_h_z, leaning_I_y_y, frame_I_x_x, frame_I_z_z,
        frame_I_y_y, frame_I_x_z, rear_wheel_xx_minus_rear_wheel_zz, fork_I_x_x, fork_I_z_z, fork_I_y_y, fork_I_x_z,
        front_wheel_yy_minus_front_wheel_zz, front_wheel_xx_minus_front_wheel_zz, front_wheel_xx_minus_front_wheel_yy,
        fork_I_y_y_minus_fork_I_z_z, fork_I_x_x_minus_fork_I_z_z, fork_I_x_x_minus_fork_I_y_y, frame_I_y_y_minus_frame_I_z_z,
        frame_I_x_x_minus_frame_I_z_z, frame_I_x_x_minus_frame_I_y_y, twice_leaning_I_y_y, front_wheel_turned_J_y_y, fork_total_J_y_y,
        fork_h_z_times_fork_lined_up_x_z, fork_h_z_times_fork_lined_up_z_z, twice_rear_radius, k23, frame_I_y_y_plus_rear_wheel_yy, k25,
        k26, inverse_front_wheel_yy, inverse_rear_wheel_yy, frame_h_x_2, frame_h_z_2, frame_I_x_x_2, frame_I_x_z_2, frame_I_z_z_2,
        fork_h_x_2, fork_h_z_2, fork_I_x_x_2, fork_I_x_z_2, fork_I_z_z_2, half_fork_I_y_y_2, half_frame_I_y_y_2, half_front_wheel_yy,
        half_front_wheel_xx, half_front_wheel_zz, half_rear_wheel_yy, half_fork_mass, half_frame_mass, half_rear_wheel_mass,
        half_front_wheel_mass, frame_z_minus_rear_radius, k40, k41, gravity_times_rear_wheel_mass, front_wheel_mass_times_gravity,
        fork_mass_times_gravity, frame_mass_times_gravity, k46, k47, *[3e-09]*6)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (9,): COORDINATES
        u (9,): SPEEDS
    """
    rear_radius, origin, upright, push, speed, steering = p[22], p[28], p[29], p[30], p[31], p[32]
    return (ca.vertcat(origin, origin, upright, 0, upright, 0, upright, upright, upright),
        ca.vertcat(0, 0, 0, 0, push, 0, speed/rear_radius, steering, 0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (9,): COORDINATES
        su (9,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    frame_mass, rear_wheel_mass, fork_mass, front_wheel_mass, rear_radius, pace = p[0], p[7], p[11], p[18], p[22], p[33]
    total_mass = fork_mass + frame_mass + front_wheel_mass + rear_wheel_mass
    energy_scale = total_mass*pace*pace/2
    force_scale = energy_scale/rear_radius
    pace_over_rear_radius = pace/rear_radius
    return (ca.vertcat(rear_radius, rear_radius, 1, rear_radius, *[1]*5),
        ca.vertcat(pace, pace, pace_over_rear_radius, pace, *[pace_over_rear_radius]*5), ca.vertcat(),
        ca.vertcat(rear_radius, pace, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (9,): path.x [m/s], path.y [m/s], path.angle [rad/s], height.travel [m/s], lean.angle [rad/s], pitch.angle [rad/s],
            rear_hub.angle [rad/s], steer.angle [rad/s], front_hub.angle [rad/s]
    """
    path_x_speed, path_y_speed, path_angle_speed, height_speed, lean_speed, pitch_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    rear_hub_speed, steer_speed, front_hub_speed = u[6], u[7], u[8]
    return ca.vertcat(path_x_speed, path_y_speed, path_angle_speed, height_speed, lean_speed, pitch_speed, rear_hub_speed, steer_speed,
        front_hub_speed)


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
        f (9,): path.x [N], path.y [N], path.angle [N m], height [N], lean [N m], pitch [N m], rear_hub [N m], steer [N m], front_hub [N m]
    """
    gravity, fork_lined_up_x_x, fork_lined_up_y_y, fork_lined_up_z_x, frame_total_mass, fork_h_x = c[9], c[10], c[12], c[13], c[18], c[19]
    fork_h_x_times_fork_lined_up_x_x, k5, fork_h_x_times_fork_lined_up_y_y, fork_h_x_times_fork_lined_up_z_x = c[23], c[24], c[25], c[26]
    k8, leaning_h_z = c[27], c[28]
    lean_angle, steer_angle = q[4], q[7]
    cos_leaning = ca.cos(lean_angle)
    sin_leaning = ca.sin(lean_angle)
    cos, sin = revolute_constants_terms(q[5])
    cos_fork = ca.cos(steer_angle)
    sin_fork = ca.sin(steer_angle)
    frame_total_moment_x = k5 + cos_fork*fork_h_x_times_fork_lined_up_x_x
    frame_total_moment_y = fork_h_x_times_fork_lined_up_y_y*sin_fork
    frame_total_moment_z = k8 + cos_fork*fork_h_x_times_fork_lined_up_z_x
    leaning_total_moment_z = leaning_h_z + cos*frame_total_moment_z - frame_total_moment_x*sin
    leaning_gravity_y = -sin_leaning*gravity
    leaning_gravity_z = -cos_leaning*gravity
    frame_gravity_x = -leaning_gravity_z*sin
    frame_gravity_z = cos*leaning_gravity_z
    fork_gravity_y = cos_fork*fork_lined_up_y_y*leaning_gravity_y - sin_fork*(fork_lined_up_x_x*frame_gravity_x + fork_lined_up_z_x*frame_gravity_z)
    return ca.vertcat(0, 0, 0, -frame_total_mass*gravity, frame_total_moment_y*leaning_gravity_z - leaning_gravity_y*leaning_total_moment_z,
        frame_gravity_x*frame_total_moment_z - frame_gravity_z*frame_total_moment_x, 0, fork_gravity_y*fork_h_x, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (9,): path.x_acceleration [m/s^2], path.y_acceleration [m/s^2], path.angle_acceleration [rad/s^2], height.acceleration [m/s^2],
            lean.acceleration [rad/s^2], pitch.acceleration [rad/s^2], rear_hub.acceleration [rad/s^2], steer.acceleration [rad/s^2],
            front_hub.acceleration [rad/s^2]
        reactions (0,): empty
        multipliers (6,): CONSTRAINTS [N]
    """
    rear_wheel_xx, rear_wheel_yy, rear_wheel_zz, front_wheel_xx, front_wheel_yy, front_wheel_zz = c[1], c[2], c[3], c[4], c[5], c[6]
    rear_radius, front_radius, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y = c[7], c[8], c[10], c[11], c[12]
    fork_lined_up_z_x, fork_lined_up_z_z, trail_plus_wheel_base, k2, k3, frame_total_mass = c[13], c[14], c[15], c[16], c[17], c[18]
    fork_h_x, fork_h_z, frame_h_x, frame_h_z, fork_h_x_times_fork_lined_up_x_x, k5 = c[19], c[20], c[21], c[22], c[23], c[24]
    fork_h_x_times_fork_lined_up_y_y, fork_h_x_times_fork_lined_up_z_x, k8, leaning_h_z, leaning_I_y_y = c[25], c[26], c[27], c[28], c[29]
    frame_I_x_x, frame_I_z_z, frame_I_y_y, frame_I_x_z, rear_wheel_xx_minus_rear_wheel_zz = c[30], c[31], c[32], c[33], c[34]
    fork_I_x_x, fork_I_z_z, fork_I_y_y, fork_I_x_z, front_wheel_yy_minus_front_wheel_zz = c[35], c[36], c[37], c[38], c[39]
    front_wheel_xx_minus_front_wheel_zz, front_wheel_xx_minus_front_wheel_yy, fork_I_y_y_minus_fork_I_z_z = c[40], c[41], c[42]
    fork_I_x_x_minus_fork_I_z_z, fork_I_x_x_minus_fork_I_y_y, frame_I_y_y_minus_frame_I_z_z = c[43], c[44], c[45]
    frame_I_x_x_minus_frame_I_z_z, frame_I_x_x_minus_frame_I_y_y, twice_leaning_I_y_y, front_wheel_turned_J_y_y = c[46], c[47], c[48], c[49]
    fork_total_J_y_y, fork_h_z_times_fork_lined_up_x_z, fork_h_z_times_fork_lined_up_z_z, twice_rear_radius = c[50], c[51], c[52], c[53]
    k23, frame_I_y_y_plus_rear_wheel_yy, k25, k26, inverse_front_wheel_yy, inverse_rear_wheel_yy = c[54], c[55], c[56], c[57], c[58], c[59]
    rear_grip_gap_softness, rear_grip_sliding_velocity_1_softness, rear_grip_sliding_velocity_2_softness = c[89], c[90], c[91]
    front_grip_gap_softness, front_grip_sliding_velocity_1_softness, front_grip_sliding_velocity_2_softness = c[92], c[93], c[94]
    path_x, path_y, path_angle, height_travel, lean_angle, pitch_angle, rear_hub_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    steer_angle, front_hub_angle = q[7], q[8]
    path_x_speed, path_y_speed, path_angle_speed, height_speed, lean_speed, pitch_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    rear_hub_speed, steer_speed, front_hub_speed = u[6], u[7], u[8]
    path_x_force, path_y_force, path_angle_force, height_force, lean_force, pitch_force = f[0], f[1], f[2], f[3], f[4], f[5]
    rear_hub_force, steer_force, front_hub_force = f[6], f[7], f[8]
    cos_heading = ca.cos(path_angle)
    sin_heading = ca.sin(path_angle)
    cos_leaning = ca.cos(lean_angle)
    sin_leaning = ca.sin(lean_angle)
    cos_frame = ca.cos(pitch_angle)
    sin_frame = ca.sin(pitch_angle)
    rear_wheel_angle = pitch_angle + rear_hub_angle
    rear_wheel_turn = rear_wheel_angle - pitch_angle
    cos_rear_wheel_turn = ca.cos(rear_wheel_turn)
    sin_rear_wheel_turn = ca.sin(rear_wheel_turn)
    cos_fork = ca.cos(steer_angle)
    sin_fork = ca.sin(steer_angle)
    cos_front_wheel = ca.cos(front_hub_angle)
    sin_front_wheel = ca.sin(front_hub_angle)
    leaning_turning_x = cos_heading*lean_speed
    leaning_turning_y = lean_speed*sin_heading
    leaning_R_x_y = -cos_leaning*sin_heading
    leaning_R_x_z = sin_heading*sin_leaning
    leaning_R_y_y = cos_heading*cos_leaning
    leaning_R_y_z = -cos_heading*sin_leaning
    frame_arm_x = leaning_R_x_z*rear_radius
    frame_arm_y = leaning_R_y_z*rear_radius
    frame_arm_z = cos_leaning*rear_radius
    frame_arm_rate_x = frame_arm_z*leaning_turning_y - frame_arm_y*path_angle_speed
    frame_arm_rate_y = frame_arm_x*path_angle_speed - frame_arm_z*leaning_turning_x
    frame_arm_rate_z = frame_arm_y*leaning_turning_x - frame_arm_x*leaning_turning_y
    frame_turning_x = leaning_R_x_y*pitch_speed
    frame_turning_y = leaning_R_y_y*pitch_speed
    frame_turning_z = pitch_speed*sin_leaning
    frame_rate_x = frame_turning_x + leaning_turning_x
    frame_rate_y = frame_turning_y + leaning_turning_y
    frame_rate_z = frame_turning_z + path_angle_speed
    frame_x_2 = frame_arm_x + path_x
    frame_y = frame_arm_y + path_y
    frame_z_2 = frame_arm_z + height_travel
    frame_velocity_x = frame_arm_rate_x + path_x_speed
    frame_velocity_y = frame_arm_rate_y + path_y_speed
    frame_velocity_z = frame_arm_rate_z + height_speed
    frame_R_x_x = cos_frame*cos_heading - leaning_R_x_z*sin_frame
    frame_R_x_z = cos_frame*leaning_R_x_z + cos_heading*sin_frame
    frame_R_y_x = cos_frame*sin_heading - leaning_R_y_z*sin_frame
    frame_R_y_z = cos_frame*leaning_R_y_z + sin_frame*sin_heading
    frame_R_z_x = -cos_leaning*sin_frame
    frame_R_z_z = cos_frame*cos_leaning
    rear_wheel_turning_x = leaning_R_x_y*rear_hub_speed
    rear_wheel_turning_y = leaning_R_y_y*rear_hub_speed
    rear_wheel_turning_z = rear_hub_speed*sin_leaning
    rear_wheel_rate_x = frame_rate_x + rear_wheel_turning_x
    rear_wheel_rate_y = frame_rate_y + rear_wheel_turning_y
    rear_wheel_rate_z = frame_rate_z + rear_wheel_turning_z
    rear_tyre_up_x = -leaning_R_x_y*sin_leaning
    rear_tyre_up_y = -leaning_R_y_y*sin_leaning
    rear_tyre_up_z = 1 - sin_leaning*sin_leaning
    rear_tyre_rise = ca.sqrt(rear_tyre_up_z)
    rear_tyre_rim_x = -rear_tyre_up_x*rear_radius/rear_tyre_rise
    rear_tyre_rim_y = -rear_tyre_up_y*rear_radius/rear_tyre_rise
    rear_tyre_rim_z = -rear_tyre_up_z*rear_radius/rear_tyre_rise
    cos_leaning_rate = -lean_speed*sin_leaning
    sin_heading_rate = cos_heading*path_angle_speed
    leaning_R_x_y_rate = -cos_leaning*sin_heading_rate - cos_leaning_rate*sin_heading
    sin_leaning_rate = cos_leaning*lean_speed
    rear_tyre_up_x_rate = -leaning_R_x_y*sin_leaning_rate - leaning_R_x_y_rate*sin_leaning
    rear_tyre_up_z_rate = -2*sin_leaning*sin_leaning_rate
    rear_tyre_rise_rate = rear_tyre_up_z_rate/(2*ca.sqrt(rear_tyre_up_z))
    inverse_rear_tyre_rise_squared = 1/(rear_tyre_rise*rear_tyre_rise)
    rear_tyre_rim_x_rate = rear_tyre_rise_rate*rear_tyre_up_x*inverse_rear_tyre_rise_squared*rear_radius - rear_tyre_up_x_rate*rear_radius/rear_tyre_rise
    rear_grip_gap_place_rate_x = frame_velocity_x + rear_tyre_rim_x_rate
    cos_heading_rate = -path_angle_speed*sin_heading
    leaning_R_y_y_rate = cos_heading*cos_leaning_rate + cos_heading_rate*cos_leaning
    rear_tyre_up_y_rate = -leaning_R_y_y*sin_leaning_rate - leaning_R_y_y_rate*sin_leaning
    rear_tyre_rim_y_rate = rear_tyre_rise_rate*rear_tyre_up_y*inverse_rear_tyre_rise_squared*rear_radius - rear_tyre_up_y_rate*rear_radius/rear_tyre_rise
    rear_grip_gap_place_rate_y = frame_velocity_y + rear_tyre_rim_y_rate
    rear_tyre_rim_z_rate = rear_tyre_rise_rate*rear_tyre_up_z*inverse_rear_tyre_rise_squared*rear_radius - rear_tyre_up_z_rate*rear_radius/rear_tyre_rise
    rear_grip_gap_place_rate_z = frame_velocity_z + rear_tyre_rim_z_rate
    leaning_angular_bias_x = -leaning_turning_y*path_angle_speed
    leaning_angular_bias_y = leaning_turning_x*path_angle_speed
    frame_angular_bias_x = leaning_angular_bias_x + frame_turning_z*leaning_turning_y - frame_turning_y*path_angle_speed
    frame_angular_bias_y = leaning_angular_bias_y + frame_turning_x*path_angle_speed - frame_turning_z*leaning_turning_x
    frame_angular_bias_z = frame_turning_y*leaning_turning_x - frame_turning_x*leaning_turning_y
    frame_bias_x = frame_arm_rate_z*leaning_turning_y + frame_arm_z*leaning_angular_bias_y - frame_arm_rate_y*path_angle_speed
    frame_bias_y = frame_arm_rate_x*path_angle_speed - frame_arm_rate_z*leaning_turning_x - frame_arm_z*leaning_angular_bias_x
    frame_bias_z = frame_arm_rate_y*leaning_turning_x + frame_arm_y*leaning_angular_bias_x - frame_arm_rate_x*leaning_turning_y - frame_arm_x*leaning_angular_bias_y
    rear_wheel_angular_bias_x = frame_angular_bias_x + frame_rate_y*rear_wheel_turning_z - frame_rate_z*rear_wheel_turning_y
    rear_wheel_angular_bias_y = frame_angular_bias_y + frame_rate_z*rear_wheel_turning_x - frame_rate_x*rear_wheel_turning_z
    rear_wheel_angular_bias_z = frame_angular_bias_z + frame_rate_x*rear_wheel_turning_y - frame_rate_y*rear_wheel_turning_x
    x2 = rear_grip_gap_place_rate_z - frame_velocity_z
    x3 = rear_grip_gap_place_rate_y - frame_velocity_y
    rear_grip_gap_apart_bias_x = frame_bias_x + rear_tyre_rim_z*rear_wheel_angular_bias_y + rear_wheel_rate_y*x2 - rear_tyre_rim_y*rear_wheel_angular_bias_z - rear_wheel_rate_z*x3
    x4 = rear_grip_gap_place_rate_x - frame_velocity_x
    rear_grip_gap_apart_bias_y = frame_bias_y + rear_tyre_rim_x*rear_wheel_angular_bias_z + rear_wheel_rate_z*x4 - rear_tyre_rim_z*rear_wheel_angular_bias_x - rear_wheel_rate_x*x2
    rear_grip_gap_apart_bias_z = frame_bias_z + rear_tyre_rim_y*rear_wheel_angular_bias_x + rear_wheel_rate_x*x3 - rear_tyre_rim_x*rear_wheel_angular_bias_y - rear_wheel_rate_y*x4
    rear_grip_sliding_velocity_1_on_path_angle = frame_x_2 + rear_tyre_rim_x - path_x
    rear_grip_gap_on_lean = cos_heading*(frame_y + rear_tyre_rim_y - path_y) - sin_heading*rear_grip_sliding_velocity_1_on_path_angle
    rear_grip_gap_on_pitch = leaning_R_x_y*rear_tyre_rim_y - leaning_R_y_y*rear_tyre_rim_x
    x6 = frame_z_2 + rear_tyre_rim_z - height_travel
    rear_grip_sliding_velocity_1_on_lean = -cos_heading*x6
    rear_grip_sliding_velocity_1_on_pitch = rear_tyre_rim_x*sin_leaning - leaning_R_x_y*rear_tyre_rim_z
    rear_grip_sliding_velocity_2_on_path_angle = path_y - frame_y - rear_tyre_rim_y
    rear_grip_sliding_velocity_2_on_lean = sin_heading*x6
    rear_grip_sliding_velocity_2_on_pitch = leaning_R_y_y*rear_tyre_rim_z - rear_tyre_rim_y*sin_leaning
    fork_arm_x = frame_R_x_x*trail_plus_wheel_base - frame_R_x_z*rear_radius
    fork_arm_y = frame_R_y_x*trail_plus_wheel_base - frame_R_y_z*rear_radius
    fork_arm_z = frame_R_z_x*trail_plus_wheel_base - frame_R_z_z*rear_radius
    fork_arm_rate_x = fork_arm_z*frame_rate_y - fork_arm_y*frame_rate_z
    fork_arm_rate_y = fork_arm_x*frame_rate_z - fork_arm_z*frame_rate_x
    fork_arm_rate_z = fork_arm_y*frame_rate_x - fork_arm_x*frame_rate_y
    steer_axis_x = fork_lined_up_x_z*frame_R_x_x + fork_lined_up_z_z*frame_R_x_z
    steer_axis_y = fork_lined_up_x_z*frame_R_y_x + fork_lined_up_z_z*frame_R_y_z
    steer_axis_z = fork_lined_up_x_z*frame_R_z_x + fork_lined_up_z_z*frame_R_z_z
    fork_turning_x = steer_axis_x*steer_speed
    fork_turning_y = steer_axis_y*steer_speed
    fork_turning_z = steer_axis_z*steer_speed
    fork_rate_x = fork_turning_x + frame_rate_x
    fork_rate_y = fork_turning_y + frame_rate_y
    fork_rate_z = fork_turning_z + frame_rate_z
    fork_x_2 = fork_arm_x + frame_x_2
    fork_y = fork_arm_y + frame_y
    fork_z_2 = fork_arm_z + frame_z_2
    fork_velocity_x = fork_arm_rate_x + frame_velocity_x
    fork_velocity_y = fork_arm_rate_y + frame_velocity_y
    fork_velocity_z = fork_arm_rate_z + frame_velocity_z
    fork_lined_up_x_x_times_frame_R_x_x = fork_lined_up_x_x*frame_R_x_x
    fork_lined_up_z_x_times_frame_R_x_z = fork_lined_up_z_x*frame_R_x_z
    x9 = fork_lined_up_x_x_times_frame_R_x_x + fork_lined_up_z_x_times_frame_R_x_z
    fork_R_x_x = cos_fork*x9 + fork_lined_up_y_y*leaning_R_x_y*sin_fork
    fork_R_x_y = cos_fork*fork_lined_up_y_y*leaning_R_x_y - sin_fork*x9
    fork_lined_up_x_x_times_frame_R_y_x = fork_lined_up_x_x*frame_R_y_x
    fork_lined_up_z_x_times_frame_R_y_z = fork_lined_up_z_x*frame_R_y_z
    x12 = fork_lined_up_x_x_times_frame_R_y_x + fork_lined_up_z_x_times_frame_R_y_z
    fork_R_y_x = cos_fork*x12 + fork_lined_up_y_y*leaning_R_y_y*sin_fork
    fork_R_y_y = cos_fork*fork_lined_up_y_y*leaning_R_y_y - sin_fork*x12
    fork_lined_up_x_x_times_frame_R_z_x = fork_lined_up_x_x*frame_R_z_x
    fork_lined_up_z_x_times_frame_R_z_z = fork_lined_up_z_x*frame_R_z_z
    x15 = fork_lined_up_x_x_times_frame_R_z_x + fork_lined_up_z_x_times_frame_R_z_z
    fork_R_z_x = cos_fork*x15 + fork_lined_up_y_y*sin_fork*sin_leaning
    fork_R_z_y = cos_fork*fork_lined_up_y_y*sin_leaning - sin_fork*x15
    front_wheel_arm_x = fork_R_x_x*k2 + k3*steer_axis_x
    front_wheel_arm_y = fork_R_y_x*k2 + k3*steer_axis_y
    front_wheel_arm_z = fork_R_z_x*k2 + k3*steer_axis_z
    front_wheel_arm_rate_x = fork_rate_y*front_wheel_arm_z - fork_rate_z*front_wheel_arm_y
    front_wheel_arm_rate_y = fork_rate_z*front_wheel_arm_x - fork_rate_x*front_wheel_arm_z
    front_wheel_arm_rate_z = fork_rate_x*front_wheel_arm_y - fork_rate_y*front_wheel_arm_x
    front_hub_axis_x = fork_R_x_y*fork_lined_up_y_y
    front_hub_axis_y = fork_R_y_y*fork_lined_up_y_y
    front_hub_axis_z = fork_R_z_y*fork_lined_up_y_y
    front_wheel_turning_x = front_hub_axis_x*front_hub_speed
    front_wheel_turning_y = front_hub_axis_y*front_hub_speed
    front_wheel_turning_z = front_hub_axis_z*front_hub_speed
    front_wheel_rate_x = fork_rate_x + front_wheel_turning_x
    front_wheel_rate_y = fork_rate_y + front_wheel_turning_y
    front_wheel_rate_z = fork_rate_z + front_wheel_turning_z
    front_wheel_x = fork_x_2 + front_wheel_arm_x
    front_wheel_y = fork_y + front_wheel_arm_y
    front_wheel_z = fork_z_2 + front_wheel_arm_z
    front_wheel_velocity_x = fork_velocity_x + front_wheel_arm_rate_x
    front_wheel_velocity_y = fork_velocity_y + front_wheel_arm_rate_y
    front_wheel_velocity_z = fork_velocity_z + front_wheel_arm_rate_z
    front_tyre_up_x = -front_hub_axis_x*front_hub_axis_z
    front_tyre_up_y = -front_hub_axis_y*front_hub_axis_z
    front_tyre_up_z = 1 - front_hub_axis_z*front_hub_axis_z
    front_tyre_rise = ca.sqrt(front_tyre_up_z)
    front_tyre_rim_x = -front_tyre_up_x*front_radius/front_tyre_rise
    front_tyre_rim_y = -front_tyre_up_y*front_radius/front_tyre_rise
    front_tyre_rim_z = -front_tyre_up_z*front_radius/front_tyre_rise
    sin_fork_rate = cos_fork*steer_speed
    cos_frame_rate = -pitch_speed*sin_frame
    leaning_R_x_z_rate = sin_heading*sin_leaning_rate + sin_heading_rate*sin_leaning
    sin_frame_rate = cos_frame*pitch_speed
    frame_R_x_x_rate = cos_frame*cos_heading_rate + cos_frame_rate*cos_heading - leaning_R_x_z*sin_frame_rate - leaning_R_x_z_rate*sin_frame
    frame_R_x_z_rate = cos_frame*leaning_R_x_z_rate + cos_frame_rate*leaning_R_x_z + cos_heading*sin_frame_rate + cos_heading_rate*sin_frame
    cos_fork_rate = -sin_fork*steer_speed
    fork_R_x_y_rate = sin_fork_rate*(-fork_lined_up_x_x*frame_R_x_x - fork_lined_up_z_x*frame_R_x_z) + cos_fork*fork_lined_up_y_y*leaning_R_x_y_rate + cos_fork_rate*fork_lined_up_y_y*leaning_R_x_y - fork_lined_up_x_x*frame_R_x_x_rate*sin_fork - fork_lined_up_z_x*frame_R_x_z_rate*sin_fork
    front_hub_axis_x_rate = fork_R_x_y_rate*fork_lined_up_y_y
    frame_R_z_x_rate = -cos_leaning*sin_frame_rate - cos_leaning_rate*sin_frame
    frame_R_z_z_rate = cos_frame*cos_leaning_rate + cos_frame_rate*cos_leaning
    fork_R_z_y_rate = sin_fork_rate*(-fork_lined_up_x_x*frame_R_z_x - fork_lined_up_z_x*frame_R_z_z) + cos_fork*fork_lined_up_y_y*sin_leaning_rate + cos_fork_rate*fork_lined_up_y_y*sin_leaning - fork_lined_up_x_x*frame_R_z_x_rate*sin_fork - fork_lined_up_z_x*frame_R_z_z_rate*sin_fork
    front_hub_axis_z_rate = fork_R_z_y_rate*fork_lined_up_y_y
    front_tyre_up_x_rate = -front_hub_axis_x*front_hub_axis_z_rate - front_hub_axis_x_rate*front_hub_axis_z
    front_tyre_up_z_rate = -2*front_hub_axis_z*front_hub_axis_z_rate
    front_tyre_rise_rate = front_tyre_up_z_rate/(2*ca.sqrt(front_tyre_up_z))
    inverse_front_tyre_rise_squared = 1/(front_tyre_rise*front_tyre_rise)
    front_tyre_rim_x_rate = front_tyre_rise_rate*front_tyre_up_x*inverse_front_tyre_rise_squared*front_radius - front_tyre_up_x_rate*front_radius/front_tyre_rise
    front_grip_gap_place_rate_x = front_tyre_rim_x_rate + front_wheel_velocity_x
    leaning_R_y_z_rate = -cos_heading*sin_leaning_rate - cos_heading_rate*sin_leaning
    frame_R_y_x_rate = cos_frame*sin_heading_rate + cos_frame_rate*sin_heading - leaning_R_y_z*sin_frame_rate - leaning_R_y_z_rate*sin_frame
    frame_R_y_z_rate = cos_frame*leaning_R_y_z_rate + cos_frame_rate*leaning_R_y_z + sin_frame*sin_heading_rate + sin_frame_rate*sin_heading
    fork_R_y_y_rate = sin_fork_rate*(-fork_lined_up_x_x*frame_R_y_x - fork_lined_up_z_x*frame_R_y_z) + cos_fork*fork_lined_up_y_y*leaning_R_y_y_rate + cos_fork_rate*fork_lined_up_y_y*leaning_R_y_y - fork_lined_up_x_x*frame_R_y_x_rate*sin_fork - fork_lined_up_z_x*frame_R_y_z_rate*sin_fork
    front_hub_axis_y_rate = fork_R_y_y_rate*fork_lined_up_y_y
    front_tyre_up_y_rate = -front_hub_axis_y*front_hub_axis_z_rate - front_hub_axis_y_rate*front_hub_axis_z
    front_tyre_rim_y_rate = front_tyre_rise_rate*front_tyre_up_y*inverse_front_tyre_rise_squared*front_radius - front_tyre_up_y_rate*front_radius/front_tyre_rise
    front_grip_gap_place_rate_y = front_tyre_rim_y_rate + front_wheel_velocity_y
    front_tyre_rim_z_rate = front_tyre_rise_rate*front_tyre_up_z*inverse_front_tyre_rise_squared*front_radius - front_tyre_up_z_rate*front_radius/front_tyre_rise
    front_grip_gap_place_rate_z = front_tyre_rim_z_rate + front_wheel_velocity_z
    fork_angular_bias_x = frame_angular_bias_x + fork_turning_z*frame_rate_y - fork_turning_y*frame_rate_z
    fork_angular_bias_y = frame_angular_bias_y + fork_turning_x*frame_rate_z - fork_turning_z*frame_rate_x
    fork_angular_bias_z = frame_angular_bias_z + fork_turning_y*frame_rate_x - fork_turning_x*frame_rate_y
    fork_bias_x = frame_bias_x + fork_arm_rate_z*frame_rate_y + fork_arm_z*frame_angular_bias_y - fork_arm_rate_y*frame_rate_z - fork_arm_y*frame_angular_bias_z
    fork_bias_y = frame_bias_y + fork_arm_rate_x*frame_rate_z + fork_arm_x*frame_angular_bias_z - fork_arm_rate_z*frame_rate_x - fork_arm_z*frame_angular_bias_x
    fork_bias_z = frame_bias_z + fork_arm_rate_y*frame_rate_x + fork_arm_y*frame_angular_bias_x - fork_arm_rate_x*frame_rate_y - fork_arm_x*frame_angular_bias_y
    front_wheel_angular_bias_x = fork_angular_bias_x + fork_rate_y*front_wheel_turning_z - fork_rate_z*front_wheel_turning_y
    front_wheel_angular_bias_y = fork_angular_bias_y + fork_rate_z*front_wheel_turning_x - fork_rate_x*front_wheel_turning_z
    front_wheel_angular_bias_z = fork_angular_bias_z + fork_rate_x*front_wheel_turning_y - fork_rate_y*front_wheel_turning_x
    front_wheel_bias_x = fork_bias_x + fork_angular_bias_y*front_wheel_arm_z + fork_rate_y*front_wheel_arm_rate_z - fork_angular_bias_z*front_wheel_arm_y - fork_rate_z*front_wheel_arm_rate_y
    front_wheel_bias_y = fork_bias_y + fork_angular_bias_z*front_wheel_arm_x + fork_rate_z*front_wheel_arm_rate_x - fork_angular_bias_x*front_wheel_arm_z - fork_rate_x*front_wheel_arm_rate_z
    front_wheel_bias_z = fork_bias_z + fork_angular_bias_x*front_wheel_arm_y + fork_rate_x*front_wheel_arm_rate_y - fork_angular_bias_y*front_wheel_arm_x - fork_rate_y*front_wheel_arm_rate_x
    x17 = front_grip_gap_place_rate_z - front_wheel_velocity_z
    x18 = front_grip_gap_place_rate_y - front_wheel_velocity_y
    front_grip_gap_apart_bias_x = front_wheel_bias_x + front_tyre_rim_z*front_wheel_angular_bias_y + front_wheel_rate_y*x17 - front_tyre_rim_y*front_wheel_angular_bias_z - front_wheel_rate_z*x18
    x19 = front_grip_gap_place_rate_x - front_wheel_velocity_x
    front_grip_gap_apart_bias_y = front_wheel_bias_y + front_tyre_rim_x*front_wheel_angular_bias_z + front_wheel_rate_z*x19 - front_tyre_rim_z*front_wheel_angular_bias_x - front_wheel_rate_x*x17
    front_grip_gap_apart_bias_z = front_wheel_bias_z + front_tyre_rim_y*front_wheel_angular_bias_x + front_wheel_rate_x*x18 - front_tyre_rim_x*front_wheel_angular_bias_y - front_wheel_rate_y*x19
    front_grip_sliding_velocity_1_on_path_angle = front_tyre_rim_x + front_wheel_x - path_x
    front_grip_gap_on_lean = cos_heading*(front_tyre_rim_y + front_wheel_y - path_y) - sin_heading*front_grip_sliding_velocity_1_on_path_angle
    x21 = front_tyre_rim_y + front_wheel_y - frame_y
    x22 = front_tyre_rim_x + front_wheel_x - frame_x_2
    front_grip_gap_on_pitch = leaning_R_x_y*x21 - leaning_R_y_y*x22
    front_tyre_rim_y_plus_front_wheel_y_minus_fork_y = front_tyre_rim_y + front_wheel_y - fork_y
    x24 = front_tyre_rim_x + front_wheel_x - fork_x_2
    front_grip_gap_on_steer = steer_axis_x*front_tyre_rim_y_plus_front_wheel_y_minus_fork_y - steer_axis_y*x24
    front_grip_gap_on_front_hub = front_hub_axis_x*front_tyre_rim_y - front_hub_axis_y*front_tyre_rim_x
    x25 = front_tyre_rim_z + front_wheel_z - height_travel
    front_grip_sliding_velocity_1_on_lean = -cos_heading*x25
    x26 = front_tyre_rim_z + front_wheel_z - frame_z_2
    front_grip_sliding_velocity_1_on_pitch = sin_leaning*x22 - leaning_R_x_y*x26
    x27 = front_tyre_rim_z + front_wheel_z - fork_z_2
    front_grip_sliding_velocity_1_on_steer = steer_axis_z*x24 - steer_axis_x*x27
    front_grip_sliding_velocity_1_on_front_hub = front_hub_axis_z*front_tyre_rim_x - front_hub_axis_x*front_tyre_rim_z
    front_grip_sliding_velocity_2_on_path_angle = path_y - front_tyre_rim_y - front_wheel_y
    front_grip_sliding_velocity_2_on_lean = sin_heading*x25
    front_grip_sliding_velocity_2_on_pitch = leaning_R_y_y*x26 - sin_leaning*x21
    front_grip_sliding_velocity_2_on_steer = steer_axis_y*x27 - steer_axis_z*front_tyre_rim_y_plus_front_wheel_y_minus_fork_y
    front_grip_sliding_velocity_2_on_front_hub = front_hub_axis_y*front_tyre_rim_z - front_hub_axis_z*front_tyre_rim_y
    x28 = cos_fork*fork_h_x_times_fork_lined_up_x_x
    frame_total_moment_x = k5 + x28
    frame_total_moment_y = fork_h_x_times_fork_lined_up_y_y*sin_fork
    x29 = cos_fork*fork_h_x_times_fork_lined_up_z_x
    frame_total_moment_z = k8 + x29
    leaning_total_moment_x = cos_frame*frame_total_moment_x + frame_total_moment_z*sin_frame
    cos_frame_times_frame_total_moment_z = cos_frame*frame_total_moment_z
    minus_frame_total_moment_x_times_sin_frame = -frame_total_moment_x*sin_frame
    leaning_total_moment_z = leaning_h_z + cos_frame_times_frame_total_moment_z + minus_frame_total_moment_x_times_sin_frame
    cos_leaning_times_frame_total_moment_y = cos_leaning*frame_total_moment_y
    minus_leaning_total_moment_z_times_sin_leaning = -leaning_total_moment_z*sin_leaning
    lean_leaning_force_z = cos_leaning_times_frame_total_moment_y + minus_leaning_total_moment_z_times_sin_leaning
    lifted_total_moment_x = cos_heading*leaning_total_moment_x - sin_heading*lean_leaning_force_z
    lifted_total_moment_y = cos_heading*lean_leaning_force_z + leaning_total_moment_x*sin_heading
    leaning_w_y = path_angle_speed*sin_leaning
    leaning_w_z = cos_leaning*path_angle_speed
    leaning_angular_bias_y_2 = lean_speed*leaning_w_z
    leaning_angular_bias_z = -lean_speed*leaning_w_y
    frame_w_x = cos_frame*lean_speed - leaning_w_z*sin_frame
    frame_w_z = cos_frame*leaning_w_z + lean_speed*sin_frame
    frame_b_x = -leaning_angular_bias_z*sin_frame
    frame_b_z = cos_frame*leaning_angular_bias_z
    frame_rate_y_2 = leaning_w_y + pitch_speed
    frame_angular_bias_x_2 = frame_b_x - frame_w_z*pitch_speed
    frame_angular_bias_z_2 = frame_b_z + frame_w_x*pitch_speed
    rear_wheel_rate_y_2 = frame_rate_y_2 + rear_hub_speed
    rear_wheel_angular_bias_x_2 = frame_angular_bias_x_2 - frame_w_z*rear_hub_speed
    rear_wheel_angular_bias_z_2 = frame_angular_bias_z_2 + frame_w_x*rear_hub_speed
    fork_lined_up_x_x_times_frame_w_x = fork_lined_up_x_x*frame_w_x
    fork_lined_up_z_x_times_frame_w_z = fork_lined_up_z_x*frame_w_z
    x37 = fork_lined_up_x_x_times_frame_w_x + fork_lined_up_z_x_times_frame_w_z
    fork_w_x = cos_fork*x37 + fork_lined_up_y_y*frame_rate_y_2*sin_fork
    fork_w_y = cos_fork*fork_lined_up_y_y*frame_rate_y_2 - sin_fork*x37
    fork_w_z = fork_lined_up_x_z*frame_w_x + fork_lined_up_z_z*frame_w_z
    fork_lined_up_x_x_times_frame_angular_bias_x_2 = fork_lined_up_x_x*frame_angular_bias_x_2
    fork_lined_up_z_x_times_frame_angular_bias_z_2 = fork_lined_up_z_x*frame_angular_bias_z_2
    x40 = fork_lined_up_x_x_times_frame_angular_bias_x_2 + fork_lined_up_z_x_times_frame_angular_bias_z_2
    fork_b_x = cos_fork*x40 + fork_lined_up_y_y*leaning_angular_bias_y_2*sin_fork
    fork_b_y = cos_fork*fork_lined_up_y_y*leaning_angular_bias_y_2 - sin_fork*x40
    fork_b_z = fork_lined_up_x_z*frame_angular_bias_x_2 + fork_lined_up_z_z*frame_angular_bias_z_2
    fork_rate_z_2 = fork_w_z + steer_speed
    fork_angular_bias_x_2 = fork_b_x + fork_w_y*steer_speed
    fork_angular_bias_y_2 = fork_b_y - fork_w_x*steer_speed
    fork_lined_up_x_x_times_fork_w_x = fork_lined_up_x_x*fork_w_x
    fork_lined_up_x_z_times_fork_rate_z_2 = fork_lined_up_x_z*fork_rate_z_2
    x43 = fork_lined_up_x_x_times_fork_w_x + fork_lined_up_x_z_times_fork_rate_z_2
    fork_lined_up_z_x_times_fork_w_x = fork_lined_up_z_x*fork_w_x
    fork_lined_up_z_z_times_fork_rate_z_2 = fork_lined_up_z_z*fork_rate_z_2
    x46 = fork_lined_up_z_x_times_fork_w_x + fork_lined_up_z_z_times_fork_rate_z_2
    front_wheel_w_x = cos_front_wheel*x43 - sin_front_wheel*x46
    front_wheel_w_y = fork_lined_up_y_y*fork_w_y
    front_wheel_w_z = cos_front_wheel*x46 + sin_front_wheel*x43
    fork_angular_bias_x_2_times_fork_lined_up_x_x = fork_angular_bias_x_2*fork_lined_up_x_x
    fork_b_z_times_fork_lined_up_x_z = fork_b_z*fork_lined_up_x_z
    x49 = fork_angular_bias_x_2_times_fork_lined_up_x_x + fork_b_z_times_fork_lined_up_x_z
    fork_angular_bias_x_2_times_fork_lined_up_z_x = fork_angular_bias_x_2*fork_lined_up_z_x
    fork_b_z_times_fork_lined_up_z_z = fork_b_z*fork_lined_up_z_z
    x52 = fork_angular_bias_x_2_times_fork_lined_up_z_x + fork_b_z_times_fork_lined_up_z_z
    front_wheel_b_x = cos_front_wheel*x49 - sin_front_wheel*x52
    front_wheel_b_y = fork_angular_bias_y_2*fork_lined_up_y_y
    front_wheel_b_z = cos_front_wheel*x52 + sin_front_wheel*x49
    front_wheel_rate_y_2 = front_hub_speed + front_wheel_w_y
    front_wheel_angular_bias_x_2 = front_wheel_b_x - front_hub_speed*front_wheel_w_z
    front_wheel_angular_bias_z_2 = front_wheel_b_z + front_hub_speed*front_wheel_w_x
    fork_rate_yy = fork_w_y*fork_w_y
    fork_rate_zz = fork_rate_z_2*fork_rate_z_2
    fork_U_x_x = -fork_rate_yy - fork_rate_zz
    fork_rate_xz = fork_w_x*fork_w_z
    fork_U_x_z = fork_b_y + fork_rate_xz
    fork_rate_yx = fork_w_x*fork_w_y
    fork_U_y_x = fork_b_z + fork_rate_yx
    fork_rate_yz = fork_w_y*fork_w_z
    fork_U_y_z = fork_rate_yz - fork_b_x
    fork_rate_zx = fork_rate_z_2*fork_w_x
    fork_U_z_x = fork_rate_zx - fork_angular_bias_y_2
    fork_rate_xx = fork_w_x*fork_w_x
    fork_U_z_z = -fork_rate_xx - fork_rate_yy
    fork_force_x = fork_U_x_x*fork_h_x + fork_U_x_z*fork_h_z
    fork_force_y = fork_U_y_x*fork_h_x + fork_U_y_z*fork_h_z
    fork_force_z = fork_U_z_x*fork_h_x + fork_U_z_z*fork_h_z
    frame_rate_yy = frame_rate_y_2*frame_rate_y_2
    frame_rate_zz = frame_w_z*frame_w_z
    frame_U_x_x = -frame_rate_yy - frame_rate_zz
    frame_rate_xz = frame_w_x*frame_w_z
    frame_U_x_z = frame_rate_xz + leaning_angular_bias_y_2
    frame_rate_yx = frame_rate_y_2*frame_w_x
    frame_U_y_x = frame_angular_bias_z_2 + frame_rate_yx
    frame_rate_yz = frame_rate_y_2*frame_w_z
    frame_U_y_z = frame_rate_yz - frame_angular_bias_x_2
    frame_U_z_x = frame_rate_xz - leaning_angular_bias_y_2
    frame_rate_xx = frame_w_x*frame_w_x
    frame_U_z_z = -frame_rate_xx - frame_rate_yy
    fork_force_z_times_fork_lined_up_x_z = fork_force_z*fork_lined_up_x_z
    cos_fork_times_fork_force_x = cos_fork*fork_force_x
    minus_fork_force_y_times_sin_fork = -fork_force_y*sin_fork
    x56 = cos_fork_times_fork_force_x + minus_fork_force_y_times_sin_fork
    x57 = fork_lined_up_x_x*x56
    frame_force_x = fork_force_z_times_fork_lined_up_x_z + x57 + frame_U_x_x*frame_h_x + frame_U_x_z*frame_h_z
    cos_fork_times_fork_force_y = cos_fork*fork_force_y
    fork_force_x_times_sin_fork = fork_force_x*sin_fork
    x60 = cos_fork_times_fork_force_y + fork_force_x_times_sin_fork
    fork_turned_force_y = fork_lined_up_y_y*x60
    frame_force_y = fork_turned_force_y + frame_U_y_x*frame_h_x + frame_U_y_z*frame_h_z
    fork_force_z_times_fork_lined_up_z_z = fork_force_z*fork_lined_up_z_z
    x63 = fork_lined_up_z_x*x56
    frame_force_z = fork_force_z_times_fork_lined_up_z_z + x63 + frame_U_z_x*frame_h_x + frame_U_z_z*frame_h_z
    leaning_U_x_z = 2*leaning_angular_bias_y_2
    leaning_rate_yz = leaning_w_y*leaning_w_z
    leaning_rate_xx = lean_speed*lean_speed
    leaning_rate_yy = leaning_w_y*leaning_w_y
    leaning_U_z_z = -leaning_rate_xx - leaning_rate_yy
    cos_frame_times_frame_force_x = cos_frame*frame_force_x
    frame_force_z_times_sin_frame = frame_force_z*sin_frame
    leaning_force_x = cos_frame_times_frame_force_x + frame_force_z_times_sin_frame + leaning_U_x_z*leaning_h_z
    leaning_force_y = frame_force_y + leaning_h_z*leaning_rate_yz
    leaning_force_z = cos_frame*frame_force_z + leaning_U_z_z*leaning_h_z - frame_force_x*sin_frame
    cos_leaning_times_leaning_force_y = cos_leaning*leaning_force_y
    minus_leaning_force_z_times_sin_leaning = -leaning_force_z*sin_leaning
    x68 = cos_leaning_times_leaning_force_y + minus_leaning_force_z_times_sin_leaning
    lifted_force_x = cos_heading*leaning_force_x - sin_heading*x68
    lifted_force_y = cos_heading*x68 + leaning_force_x*sin_heading
    lifted_force_z = cos_leaning*leaning_force_z + leaning_force_y*sin_leaning
    path_x_net = path_x_force - lifted_force_x
    path_y_net = path_y_force - lifted_force_y
    frame_turned_force_x = cos_frame_times_frame_force_x + frame_force_z_times_sin_frame
    frame_bias_x_2 = cos_frame*leaning_U_x_z*rear_radius - leaning_U_z_z*sin_frame*rear_radius
    frame_bias_y_2 = leaning_rate_yz*rear_radius
    frame_bias_z_2 = cos_frame*leaning_U_z_z*rear_radius + leaning_U_x_z*sin_frame*rear_radius
    rear_wheel_J_swing = rear_wheel_xx_minus_rear_wheel_zz*sin_rear_wheel_turn
    rear_wheel_J_x_x = rear_wheel_xx - rear_wheel_J_swing*sin_rear_wheel_turn
    rear_wheel_J_z_z = rear_wheel_J_swing*sin_rear_wheel_turn + rear_wheel_zz
    rear_wheel_rate_yz = frame_w_z*rear_wheel_rate_y_2
    rear_wheel_rate_xy = frame_w_x*rear_wheel_rate_y_2
    rear_wheel_J_x_z = -cos_rear_wheel_turn*rear_wheel_J_swing
    rear_wheel_torque_x = rear_wheel_J_x_x*rear_wheel_angular_bias_x_2 + rear_wheel_J_x_z*(rear_wheel_angular_bias_z_2 + rear_wheel_rate_xy) + rear_wheel_rate_yz*(rear_wheel_J_z_z - rear_wheel_yy)
    frame_rate_zz_minus_frame_rate_xx = frame_rate_zz - frame_rate_xx
    rear_wheel_torque_y = frame_rate_xz*(rear_wheel_J_x_x - rear_wheel_J_z_z) + leaning_angular_bias_y_2*rear_wheel_yy + rear_wheel_J_x_z*frame_rate_zz_minus_frame_rate_xx
    rear_wheel_torque_z = rear_wheel_J_x_z*(rear_wheel_angular_bias_x_2 - rear_wheel_rate_yz) + rear_wheel_J_z_z*rear_wheel_angular_bias_z_2 + rear_wheel_rate_xy*(rear_wheel_yy - rear_wheel_J_x_x)
    fork_turned_force_x = fork_force_z_times_fork_lined_up_x_z + x57
    fork_turned_force_z = fork_force_z_times_fork_lined_up_z_z + x63
    fork_rate_yz_2 = fork_rate_z_2*fork_w_y
    x70 = frame_U_x_x*trail_plus_wheel_base
    minus_frame_U_x_z_times_rear_radius = -frame_U_x_z*rear_radius
    x72 = frame_bias_x_2 + x70 + minus_frame_U_x_z_times_rear_radius
    x73 = fork_lined_up_x_x*x72
    x74 = frame_U_z_x*trail_plus_wheel_base
    minus_frame_U_z_z_times_rear_radius = -frame_U_z_z*rear_radius
    x76 = frame_bias_z_2 + x74 + minus_frame_U_z_z_times_rear_radius
    x77 = fork_lined_up_z_x*x76
    x78 = x73 + x77
    x79 = frame_U_y_x*trail_plus_wheel_base
    minus_frame_U_y_z_times_rear_radius = -frame_U_y_z*rear_radius
    x81 = frame_bias_y_2 + x79 + minus_frame_U_y_z_times_rear_radius
    fork_bias_x_2 = cos_fork*x78 + fork_lined_up_y_y*sin_fork*x81
    fork_bias_y_2 = cos_fork*fork_lined_up_y_y*x81 - sin_fork*x78
    fork_bias_z_2 = fork_lined_up_x_z*x72 + fork_lined_up_z_z*x76
    front_wheel_rate_yz = front_wheel_rate_y_2*front_wheel_w_z
    front_wheel_rate_xz = front_wheel_w_x*front_wheel_w_z
    front_wheel_rate_xy = front_wheel_rate_y_2*front_wheel_w_x
    front_wheel_torque_x = front_wheel_angular_bias_x_2*front_wheel_xx - front_wheel_rate_yz*front_wheel_yy_minus_front_wheel_zz
    front_wheel_torque_y = front_wheel_b_y*front_wheel_yy + front_wheel_rate_xz*front_wheel_xx_minus_front_wheel_zz
    front_wheel_torque_z = front_wheel_angular_bias_z_2*front_wheel_zz - front_wheel_rate_xy*front_wheel_xx_minus_front_wheel_yy
    cos_front_wheel_times_front_wheel_torque_x = cos_front_wheel*front_wheel_torque_x
    front_wheel_torque_z_times_sin_front_wheel = front_wheel_torque_z*sin_front_wheel
    x84 = cos_front_wheel_times_front_wheel_torque_x + front_wheel_torque_z_times_sin_front_wheel
    cos_front_wheel_times_front_wheel_torque_z = cos_front_wheel*front_wheel_torque_z
    minus_front_wheel_torque_x_times_sin_front_wheel = -front_wheel_torque_x*sin_front_wheel
    x87 = cos_front_wheel_times_front_wheel_torque_z + minus_front_wheel_torque_x_times_sin_front_wheel
    fork_torque_x = fork_I_x_x*fork_angular_bias_x_2 + fork_I_x_z*fork_U_y_x + fork_lined_up_x_x*x84 + fork_lined_up_z_x*x87 - fork_bias_y_2*fork_h_z - fork_rate_yz_2*fork_I_y_y_minus_fork_I_z_z
    fork_torque_y = fork_I_x_z*(fork_rate_zz - fork_rate_xx) + fork_I_y_y*fork_angular_bias_y_2 + fork_bias_x_2*fork_h_z + fork_lined_up_y_y*front_wheel_torque_y + fork_rate_zx*fork_I_x_x_minus_fork_I_z_z - fork_bias_z_2*fork_h_x
    fork_torque_z = fork_I_x_z*(fork_angular_bias_x_2 - fork_rate_yz_2) + fork_I_z_z*fork_b_z + fork_bias_y_2*fork_h_x + fork_lined_up_x_z*x84 + fork_lined_up_z_z*x87 - fork_rate_yx*fork_I_x_x_minus_fork_I_y_y
    cos_fork_times_fork_torque_x = cos_fork*fork_torque_x
    minus_fork_torque_y_times_sin_fork = -fork_torque_y*sin_fork
    x90 = cos_fork_times_fork_torque_x + minus_fork_torque_y_times_sin_fork
    frame_torque_x = rear_wheel_torque_x + fork_lined_up_x_x*x90 + fork_lined_up_x_z*fork_torque_z + frame_I_x_x*frame_angular_bias_x_2 + frame_I_x_z*frame_U_y_x + fork_turned_force_y*rear_radius - frame_bias_y_2*frame_h_z - frame_rate_yz*frame_I_y_y_minus_frame_I_z_z
    frame_torque_y = rear_wheel_torque_y + fork_lined_up_y_y*(cos_fork*fork_torque_y + fork_torque_x*sin_fork) + frame_I_x_z*frame_rate_zz_minus_frame_rate_xx + frame_I_y_y*leaning_angular_bias_y_2 + frame_bias_x_2*frame_h_z + frame_rate_xz*frame_I_x_x_minus_frame_I_z_z - fork_turned_force_x*rear_radius - fork_turned_force_z*trail_plus_wheel_base - frame_bias_z_2*frame_h_x
    frame_torque_z = rear_wheel_torque_z + fork_lined_up_z_x*x90 + fork_lined_up_z_z*fork_torque_z + frame_I_x_z*(frame_angular_bias_x_2 - frame_rate_yz) + frame_I_z_z*frame_angular_bias_z_2 + frame_bias_y_2*frame_h_x + trail_plus_wheel_base*fork_turned_force_y - frame_rate_yx*frame_I_x_x_minus_frame_I_y_y
    leaning_torque_x = cos_frame*frame_torque_x + frame_torque_z*sin_frame - frame_force_y*rear_radius - leaning_I_y_y*leaning_rate_yz
    leaning_torque_y = frame_torque_y + frame_turned_force_x*rear_radius + twice_leaning_I_y_y*leaning_angular_bias_y_2
    leaning_torque_z = cos_frame*frame_torque_z - frame_torque_x*sin_frame
    lifted_torque_z = cos_leaning*leaning_torque_z + leaning_torque_y*sin_leaning
    path_angle_net = path_angle_force - lifted_torque_z
    height_net = height_force - lifted_force_z
    lean_net = lean_force - leaning_torque_x
    pitch_net = pitch_force - frame_torque_y
    rear_hub_net = rear_hub_force - rear_wheel_torque_y
    steer_net = steer_force - fork_torque_z
    front_hub_net = front_hub_force - front_wheel_torque_y
    front_wheel_turned_J_swing = front_wheel_xx_minus_front_wheel_zz*sin_front_wheel
    front_wheel_turned_J_x_x = front_wheel_xx - front_wheel_turned_J_swing*sin_front_wheel
    front_wheel_turned_J_x_z = -cos_front_wheel*front_wheel_turned_J_swing
    front_wheel_turned_J_z_z = front_wheel_turned_J_swing*sin_front_wheel + front_wheel_zz
    front_wheel_turned_J_half_x_x = fork_lined_up_x_x*front_wheel_turned_J_x_x + fork_lined_up_z_x*front_wheel_turned_J_x_z
    front_wheel_turned_J_half_x_z = fork_lined_up_x_x*front_wheel_turned_J_x_z + fork_lined_up_z_x*front_wheel_turned_J_z_z
    front_wheel_turned_J_half_z_x = fork_lined_up_x_z*front_wheel_turned_J_x_x + fork_lined_up_z_z*front_wheel_turned_J_x_z
    front_wheel_turned_J_half_z_z = fork_lined_up_x_z*front_wheel_turned_J_x_z + fork_lined_up_z_z*front_wheel_turned_J_z_z
    front_wheel_turned_J_x_x_2 = fork_lined_up_x_x*front_wheel_turned_J_half_x_x + fork_lined_up_z_x*front_wheel_turned_J_half_x_z
    fork_total_J_x_x = fork_I_x_x + front_wheel_turned_J_x_x_2
    fork_turned_J_swing = sin_fork*(fork_total_J_y_y - fork_total_J_x_x)
    fork_turned_J_x_x = fork_total_J_x_x + fork_turned_J_swing*sin_fork
    front_wheel_turned_J_x_z_2 = fork_lined_up_x_z*front_wheel_turned_J_half_x_x + fork_lined_up_z_z*front_wheel_turned_J_half_x_z
    fork_total_J_x_z = fork_I_x_z + front_wheel_turned_J_x_z_2
    fork_turned_J_x_z = cos_fork*fork_total_J_x_z
    fork_turned_J_x_y = -cos_fork*fork_turned_J_swing
    fork_turned_J_y_z = fork_total_J_x_z*sin_fork
    front_wheel_turned_J_z_z_2 = fork_lined_up_x_z*front_wheel_turned_J_half_z_x + fork_lined_up_z_z*front_wheel_turned_J_half_z_z
    fork_total_J_z_z = fork_I_z_z + front_wheel_turned_J_z_z_2
    fork_turned_J_half_x_x = fork_lined_up_x_x*fork_turned_J_x_x + fork_lined_up_x_z*fork_turned_J_x_z
    fork_turned_J_half_x_y = fork_lined_up_x_x*fork_turned_J_x_y + fork_lined_up_x_z*fork_turned_J_y_z
    fork_lined_up_x_z_times_fork_total_J_z_z = fork_lined_up_x_z*fork_total_J_z_z
    fork_turned_J_half_x_z = fork_lined_up_x_z_times_fork_total_J_z_z + fork_lined_up_x_x*fork_turned_J_x_z
    fork_turned_J_y_y = fork_total_J_y_y - fork_turned_J_swing*sin_fork
    fork_turned_J_half_y_x = fork_lined_up_y_y*fork_turned_J_x_y
    fork_turned_J_half_y_y = fork_lined_up_y_y*fork_turned_J_y_y
    fork_turned_J_half_y_z = fork_lined_up_y_y*fork_turned_J_y_z
    fork_turned_J_half_z_x = fork_lined_up_z_x*fork_turned_J_x_x + fork_lined_up_z_z*fork_turned_J_x_z
    fork_lined_up_z_z_times_fork_total_J_z_z = fork_lined_up_z_z*fork_total_J_z_z
    fork_turned_J_half_z_z = fork_lined_up_z_z_times_fork_total_J_z_z + fork_lined_up_z_x*fork_turned_J_x_z
    fork_turned_moment_x = fork_h_z_times_fork_lined_up_x_z + x28
    fork_turned_moment_z = fork_h_z_times_fork_lined_up_z_z + x29
    frame_turned_moment_z = cos_frame_times_frame_total_moment_z + minus_frame_total_moment_x_times_sin_frame
    fork_turned_J_x_y_2 = fork_lined_up_y_y*fork_turned_J_half_x_y
    frame_total_J_x_y = fork_turned_J_x_y_2 - frame_total_moment_y*trail_plus_wheel_base
    fork_turned_J_y_z_2 = fork_lined_up_z_x*fork_turned_J_half_y_x + fork_lined_up_z_z*fork_turned_J_half_y_z
    frame_total_J_y_z = fork_turned_J_y_z_2 + frame_total_moment_y*rear_radius
    frame_turned_J_x_y = cos_frame*frame_total_J_x_y + frame_total_J_y_z*sin_frame
    fork_turned_J_x_z_2 = fork_lined_up_z_x*fork_turned_J_half_x_x + fork_lined_up_z_z*fork_turned_J_half_x_z
    frame_total_J_x_z = fork_turned_J_x_z_2 + frame_I_x_z + rear_wheel_J_x_z + fork_turned_moment_x*rear_radius - fork_turned_moment_z*trail_plus_wheel_base
    fork_turned_J_x_x_2 = fork_lined_up_x_x*fork_turned_J_half_x_x + fork_lined_up_x_z*fork_turned_J_half_x_z
    x93 = -fork_turned_moment_z*twice_rear_radius
    frame_total_J_x_x = fork_turned_J_x_x_2 + frame_I_x_x + rear_wheel_J_x_x + x93
    fork_turned_J_z_z = fork_lined_up_z_x*fork_turned_J_half_z_x + fork_lined_up_z_z*fork_turned_J_half_z_z
    x94 = fork_turned_moment_x*k23
    frame_total_J_z_z = fork_turned_J_z_z + frame_I_z_z + rear_wheel_J_z_z + x94
    frame_turned_J_swing = sin_frame*(frame_total_J_x_x - frame_total_J_z_z) - 2*cos_frame*frame_total_J_x_z
    frame_turned_J_x_z = -frame_total_J_x_z - cos_frame*frame_turned_J_swing
    leaning_total_J_x_z = frame_turned_J_x_z - leaning_total_moment_x*rear_radius
    leaning_turned_J_x_z = cos_leaning*leaning_total_J_x_z + frame_turned_J_x_y*sin_leaning
    frame_turned_J_y_z = cos_frame*frame_total_J_y_z - frame_total_J_x_y*sin_frame
    leaning_total_J_y_z = frame_turned_J_y_z - frame_total_moment_y*rear_radius
    frame_turned_J_z_z = frame_total_J_z_z + frame_turned_J_swing*sin_frame
    fork_turned_J_y_y_2 = fork_lined_up_y_y*fork_turned_J_half_y_y
    frame_total_J_y_y = fork_turned_J_y_y_2 + frame_I_y_y_plus_rear_wheel_yy + x93 + x94
    x95 = frame_turned_moment_z*twice_rear_radius
    leaning_total_J_y_y = frame_total_J_y_y + leaning_I_y_y + x95
    leaning_turned_J_swing = sin_leaning*(frame_turned_J_z_z - leaning_total_J_y_y) - 2*cos_leaning*leaning_total_J_y_z
    leaning_turned_J_z_z = frame_turned_J_z_z - leaning_turned_J_swing*sin_leaning
    frame_turned_J_x_x = frame_total_J_x_x - frame_turned_J_swing*sin_frame
    leaning_total_J_x_x = frame_turned_J_x_x + leaning_I_y_y + x95
    minus_cos_leaning_times_leaning_total_moment_z = -cos_leaning*leaning_total_moment_z
    minus_frame_total_moment_y_times_sin_leaning = -frame_total_moment_y*sin_leaning
    x98 = minus_cos_leaning_times_leaning_total_moment_z + minus_frame_total_moment_y_times_sin_leaning
    lean_leaning_force_x = -sin_heading*x98
    lean_leaning_force_y = cos_heading*x98
    pitch_frame_torque_y = frame_total_J_y_y + frame_turned_moment_z*rear_radius
    pitch_leaning_force_x = cos_heading*frame_turned_moment_z - leaning_total_moment_x*sin_heading*sin_leaning
    pitch_leaning_force_y = frame_turned_moment_z*sin_heading + cos_heading*leaning_total_moment_x*sin_leaning
    pitch_leaning_force_z = -cos_leaning*leaning_total_moment_x
    pitch_leaning_torque_z = cos_leaning*frame_turned_J_y_z + pitch_frame_torque_y*sin_leaning
    rear_hub_leaning_torque_z = sin_leaning*rear_wheel_yy
    steer_fork_force_x = -fork_h_x_times_fork_lined_up_x_x*sin_fork
    steer_fork_force_y = cos_fork*fork_h_x_times_fork_lined_up_y_y
    steer_fork_force_z = -fork_h_x_times_fork_lined_up_z_x*sin_fork
    steer_fork_torque_x = fork_lined_up_x_z_times_fork_total_J_z_z + steer_fork_force_y*rear_radius + cos_fork*fork_lined_up_x_x*fork_total_J_x_z
    steer_fork_torque_y = fork_lined_up_y_y*fork_total_J_x_z*sin_fork - trail_plus_wheel_base*steer_fork_force_z - steer_fork_force_x*rear_radius
    steer_fork_torque_z = fork_lined_up_z_z_times_fork_total_J_z_z + trail_plus_wheel_base*steer_fork_force_y + cos_fork*fork_lined_up_z_x*fork_total_J_x_z
    steer_frame_force_x = cos_frame*steer_fork_force_x + sin_frame*steer_fork_force_z
    steer_frame_force_z = cos_frame*steer_fork_force_z - sin_frame*steer_fork_force_x
    steer_frame_torque_x = cos_frame*steer_fork_torque_x + sin_frame*steer_fork_torque_z - steer_fork_force_y*rear_radius
    steer_frame_torque_y = steer_fork_torque_y + steer_frame_force_x*rear_radius
    steer_frame_torque_z = cos_frame*steer_fork_torque_z - sin_frame*steer_fork_torque_x
    cos_leaning_times_steer_fork_force_y = cos_leaning*steer_fork_force_y
    minus_sin_leaning_times_steer_frame_force_z = -sin_leaning*steer_frame_force_z
    x101 = minus_sin_leaning_times_steer_frame_force_z + cos_leaning_times_steer_fork_force_y
    steer_leaning_force_x = cos_heading*steer_frame_force_x - sin_heading*x101
    steer_leaning_force_y = cos_heading*x101 + sin_heading*steer_frame_force_x
    steer_leaning_force_z = cos_leaning*steer_frame_force_z + sin_leaning*steer_fork_force_y
    steer_leaning_torque_z = cos_leaning*steer_frame_torque_z + sin_leaning*steer_frame_torque_y
    front_hub_fork_torque_x = -k25*sin_fork
    front_hub_fork_torque_y = cos_fork*front_wheel_turned_J_y_y
    front_hub_fork_torque_z = -k26*sin_fork
    front_hub_frame_torque_x = cos_frame*front_hub_fork_torque_x + front_hub_fork_torque_z*sin_frame
    front_hub_frame_torque_z = cos_frame*front_hub_fork_torque_z - front_hub_fork_torque_x*sin_frame
    front_hub_leaning_torque_z = cos_leaning*front_hub_frame_torque_z + front_hub_fork_torque_y*sin_leaning
    l_pitch_front_hub = front_hub_fork_torque_y*inverse_front_wheel_yy
    l_pitch_steer = steer_fork_torque_y/fork_total_J_z_z
    D_pitch = frame_total_J_y_y - rear_wheel_yy - front_hub_fork_torque_y*l_pitch_front_hub - l_pitch_steer*steer_fork_torque_y
    l_lean_front_hub = front_hub_frame_torque_x*inverse_front_wheel_yy
    l_lean_steer = steer_frame_torque_x/fork_total_J_z_z
    L_lean_pitch = frame_turned_J_x_y - front_hub_frame_torque_x*l_pitch_front_hub - l_pitch_steer*steer_frame_torque_x
    l_lean_pitch = L_lean_pitch/D_pitch
    D_lean = leaning_total_J_x_x - L_lean_pitch*l_lean_pitch - front_hub_frame_torque_x*l_lean_front_hub - l_lean_steer*steer_frame_torque_x
    l_height_steer = steer_leaning_force_z/fork_total_J_z_z
    L_height_pitch = pitch_leaning_force_z - l_pitch_steer*steer_leaning_force_z
    l_height_pitch = L_height_pitch/D_pitch
    L_height_lean = lean_leaning_force_z - L_height_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_z
    l_height_lean = L_height_lean/D_lean
    D_height = frame_total_mass - L_height_lean*l_height_lean - L_height_pitch*l_height_pitch - l_height_steer*steer_leaning_force_z
    l_path_angle_front_hub = front_hub_leaning_torque_z*inverse_front_wheel_yy
    l_path_angle_steer = steer_leaning_torque_z/fork_total_J_z_z
    l_path_angle_rear_hub = inverse_rear_wheel_yy*rear_hub_leaning_torque_z
    L_path_angle_pitch = pitch_leaning_torque_z - rear_hub_leaning_torque_z - front_hub_leaning_torque_z*l_pitch_front_hub - l_pitch_steer*steer_leaning_torque_z
    l_path_angle_pitch = L_path_angle_pitch/D_pitch
    L_path_angle_lean = leaning_turned_J_x_z - L_path_angle_pitch*l_lean_pitch - front_hub_leaning_torque_z*l_lean_front_hub - l_lean_steer*steer_leaning_torque_z
    l_path_angle_lean = L_path_angle_lean/D_lean
    L_path_angle_height = -L_path_angle_lean*l_height_lean - L_path_angle_pitch*l_height_pitch - l_height_steer*steer_leaning_torque_z
    l_path_angle_height = L_path_angle_height/D_height
    D_path_angle = leaning_turned_J_z_z - L_path_angle_height*l_path_angle_height - L_path_angle_lean*l_path_angle_lean - L_path_angle_pitch*l_path_angle_pitch - front_hub_leaning_torque_z*l_path_angle_front_hub - l_path_angle_rear_hub*rear_hub_leaning_torque_z - l_path_angle_steer*steer_leaning_torque_z
    l_path_y_steer = steer_leaning_force_y/fork_total_J_z_z
    L_path_y_pitch = pitch_leaning_force_y - l_pitch_steer*steer_leaning_force_y
    l_path_y_pitch = L_path_y_pitch/D_pitch
    L_path_y_lean = lean_leaning_force_y - L_path_y_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_y
    l_path_y_lean = L_path_y_lean/D_lean
    L_path_y_height = -L_path_y_lean*l_height_lean - L_path_y_pitch*l_height_pitch - l_height_steer*steer_leaning_force_y
    l_path_y_height = L_path_y_height/D_height
    L_path_y_path_angle = lifted_total_moment_x - L_path_y_height*l_path_angle_height - L_path_y_lean*l_path_angle_lean - L_path_y_pitch*l_path_angle_pitch - l_path_angle_steer*steer_leaning_force_y
    l_path_y_path_angle = L_path_y_path_angle/D_path_angle
    D_path_y = frame_total_mass - L_path_y_height*l_path_y_height - L_path_y_lean*l_path_y_lean - L_path_y_path_angle*l_path_y_path_angle - L_path_y_pitch*l_path_y_pitch - l_path_y_steer*steer_leaning_force_y
    l_path_x_steer = steer_leaning_force_x/fork_total_J_z_z
    L_path_x_pitch = pitch_leaning_force_x - l_pitch_steer*steer_leaning_force_x
    l_path_x_pitch = L_path_x_pitch/D_pitch
    L_path_x_lean = lean_leaning_force_x - L_path_x_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_x
    l_path_x_lean = L_path_x_lean/D_lean
    L_path_x_height = -L_path_x_lean*l_height_lean - L_path_x_pitch*l_height_pitch - l_height_steer*steer_leaning_force_x
    l_path_x_height = L_path_x_height/D_height
    L_path_x_path_angle = -lifted_total_moment_y - L_path_x_height*l_path_angle_height - L_path_x_lean*l_path_angle_lean - L_path_x_pitch*l_path_angle_pitch - l_path_angle_steer*steer_leaning_force_x
    l_path_x_path_angle = L_path_x_path_angle/D_path_angle
    L_path_x_path_y = -L_path_x_height*l_path_y_height - L_path_x_lean*l_path_y_lean - L_path_x_path_angle*l_path_y_path_angle - L_path_x_pitch*l_path_y_pitch - l_path_y_steer*steer_leaning_force_x
    l_path_x_path_y = L_path_x_path_y/D_path_y
    D_path_x = frame_total_mass - L_path_x_height*l_path_x_height - L_path_x_lean*l_path_x_lean - L_path_x_path_angle*l_path_x_path_angle - L_path_x_path_y*l_path_x_path_y - L_path_x_pitch*l_path_x_pitch - l_path_x_steer*steer_leaning_force_x
    y_pitch = pitch_net - rear_hub_net - front_hub_net*l_pitch_front_hub - l_pitch_steer*steer_net
    y_lean = lean_net - front_hub_net*l_lean_front_hub - l_lean_pitch*y_pitch - l_lean_steer*steer_net
    y_height = height_net - l_height_lean*y_lean - l_height_pitch*y_pitch - l_height_steer*steer_net
    y_path_angle = path_angle_net - front_hub_net*l_path_angle_front_hub - l_path_angle_height*y_height - l_path_angle_lean*y_lean - l_path_angle_pitch*y_pitch - l_path_angle_rear_hub*rear_hub_net - l_path_angle_steer*steer_net
    y_path_y = path_y_net - l_path_y_height*y_height - l_path_y_lean*y_lean - l_path_y_path_angle*y_path_angle - l_path_y_pitch*y_pitch - l_path_y_steer*steer_net
    y_path_x = path_x_net - l_path_x_height*y_height - l_path_x_lean*y_lean - l_path_x_path_angle*y_path_angle - l_path_x_path_y*y_path_y - l_path_x_pitch*y_pitch - l_path_x_steer*steer_net
    path_x_acc = y_path_x/D_path_x
    path_y_acc = y_path_y/D_path_y - l_path_x_path_y*path_x_acc
    path_angle_acc = y_path_angle/D_path_angle - l_path_x_path_angle*path_x_acc - l_path_y_path_angle*path_y_acc
    height_acc = y_height/D_height - l_path_angle_height*path_angle_acc - l_path_x_height*path_x_acc - l_path_y_height*path_y_acc
    lean_acc = y_lean/D_lean - height_acc*l_height_lean - l_path_angle_lean*path_angle_acc - l_path_x_lean*path_x_acc - l_path_y_lean*path_y_acc
    pitch_acc = y_pitch/D_pitch - height_acc*l_height_pitch - l_lean_pitch*lean_acc - l_path_angle_pitch*path_angle_acc - l_path_x_pitch*path_x_acc - l_path_y_pitch*path_y_acc
    rear_hub_acc = inverse_rear_wheel_yy*rear_hub_net - pitch_acc - l_path_angle_rear_hub*path_angle_acc
    steer_acc = steer_net/fork_total_J_z_z - height_acc*l_height_steer - l_lean_steer*lean_acc - l_path_angle_steer*path_angle_acc - l_path_x_steer*path_x_acc - l_path_y_steer*path_y_acc - l_pitch_steer*pitch_acc
    front_hub_acc = front_hub_net*inverse_front_wheel_yy - l_lean_front_hub*lean_acc - l_path_angle_front_hub*path_angle_acc - l_pitch_front_hub*pitch_acc
    y_height_2 = 1 - l_height_lean*rear_grip_gap_on_lean
    y_path_angle_2 = -l_path_angle_height*y_height_2 - l_path_angle_lean*rear_grip_gap_on_lean - l_path_angle_rear_hub*rear_grip_gap_on_pitch
    y_path_y_2 = -l_path_y_height*y_height_2 - l_path_y_lean*rear_grip_gap_on_lean - l_path_y_path_angle*y_path_angle_2
    y_path_x_2 = -l_path_x_height*y_height_2 - l_path_x_lean*rear_grip_gap_on_lean - l_path_x_path_angle*y_path_angle_2 - l_path_x_path_y*y_path_y_2
    path_x_by_rear_grip_gap = y_path_x_2/D_path_x
    path_y_by_rear_grip_gap = y_path_y_2/D_path_y - l_path_x_path_y*path_x_by_rear_grip_gap
    path_angle_by_rear_grip_gap = y_path_angle_2/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_gap - l_path_y_path_angle*path_y_by_rear_grip_gap
    height_by_rear_grip_gap = y_height_2/D_height - l_path_angle_height*path_angle_by_rear_grip_gap - l_path_x_height*path_x_by_rear_grip_gap - l_path_y_height*path_y_by_rear_grip_gap
    lean_by_rear_grip_gap = rear_grip_gap_on_lean/D_lean - height_by_rear_grip_gap*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_gap - l_path_x_lean*path_x_by_rear_grip_gap - l_path_y_lean*path_y_by_rear_grip_gap
    pitch_by_rear_grip_gap = -height_by_rear_grip_gap*l_height_pitch - l_lean_pitch*lean_by_rear_grip_gap - l_path_angle_pitch*path_angle_by_rear_grip_gap - l_path_x_pitch*path_x_by_rear_grip_gap - l_path_y_pitch*path_y_by_rear_grip_gap
    rear_hub_by_rear_grip_gap = inverse_rear_wheel_yy*rear_grip_gap_on_pitch - pitch_by_rear_grip_gap - l_path_angle_rear_hub*path_angle_by_rear_grip_gap
    steer_by_rear_grip_gap = -height_by_rear_grip_gap*l_height_steer - l_lean_steer*lean_by_rear_grip_gap - l_path_angle_steer*path_angle_by_rear_grip_gap - l_path_x_steer*path_x_by_rear_grip_gap - l_path_y_steer*path_y_by_rear_grip_gap - l_pitch_steer*pitch_by_rear_grip_gap
    front_hub_by_rear_grip_gap = -l_lean_front_hub*lean_by_rear_grip_gap - l_path_angle_front_hub*path_angle_by_rear_grip_gap - l_pitch_front_hub*pitch_by_rear_grip_gap
    y_height_3 = -l_height_lean*rear_grip_sliding_velocity_1_on_lean
    y_path_angle_3 = rear_grip_sliding_velocity_1_on_path_angle - l_path_angle_height*y_height_3 - l_path_angle_lean*rear_grip_sliding_velocity_1_on_lean - l_path_angle_rear_hub*rear_grip_sliding_velocity_1_on_pitch
    y_path_y_3 = 1 - l_path_y_height*y_height_3 - l_path_y_lean*rear_grip_sliding_velocity_1_on_lean - l_path_y_path_angle*y_path_angle_3
    y_path_x_3 = -l_path_x_height*y_height_3 - l_path_x_lean*rear_grip_sliding_velocity_1_on_lean - l_path_x_path_angle*y_path_angle_3 - l_path_x_path_y*y_path_y_3
    path_x_by_rear_grip_sliding_velocity_1 = y_path_x_3/D_path_x
    path_y_by_rear_grip_sliding_velocity_1 = y_path_y_3/D_path_y - l_path_x_path_y*path_x_by_rear_grip_sliding_velocity_1
    path_angle_by_rear_grip_sliding_velocity_1 = y_path_angle_3/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_path_angle*path_y_by_rear_grip_sliding_velocity_1
    height_by_rear_grip_sliding_velocity_1 = y_height_3/D_height - l_path_angle_height*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_height*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_height*path_y_by_rear_grip_sliding_velocity_1
    lean_by_rear_grip_sliding_velocity_1 = rear_grip_sliding_velocity_1_on_lean/D_lean - height_by_rear_grip_sliding_velocity_1*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_lean*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_lean*path_y_by_rear_grip_sliding_velocity_1
    pitch_by_rear_grip_sliding_velocity_1 = -height_by_rear_grip_sliding_velocity_1*l_height_pitch - l_lean_pitch*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_pitch*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_pitch*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_pitch*path_y_by_rear_grip_sliding_velocity_1
    rear_hub_by_rear_grip_sliding_velocity_1 = inverse_rear_wheel_yy*rear_grip_sliding_velocity_1_on_pitch - pitch_by_rear_grip_sliding_velocity_1 - l_path_angle_rear_hub*path_angle_by_rear_grip_sliding_velocity_1
    steer_by_rear_grip_sliding_velocity_1 = -height_by_rear_grip_sliding_velocity_1*l_height_steer - l_lean_steer*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_steer*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_steer*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_steer*path_y_by_rear_grip_sliding_velocity_1 - l_pitch_steer*pitch_by_rear_grip_sliding_velocity_1
    front_hub_by_rear_grip_sliding_velocity_1 = -l_lean_front_hub*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_front_hub*path_angle_by_rear_grip_sliding_velocity_1 - l_pitch_front_hub*pitch_by_rear_grip_sliding_velocity_1
    y_height_4 = -l_height_lean*rear_grip_sliding_velocity_2_on_lean
    y_path_angle_4 = rear_grip_sliding_velocity_2_on_path_angle - l_path_angle_height*y_height_4 - l_path_angle_lean*rear_grip_sliding_velocity_2_on_lean - l_path_angle_rear_hub*rear_grip_sliding_velocity_2_on_pitch
    y_path_y_4 = -l_path_y_height*y_height_4 - l_path_y_lean*rear_grip_sliding_velocity_2_on_lean - l_path_y_path_angle*y_path_angle_4
    y_path_x_4 = 1 - l_path_x_height*y_height_4 - l_path_x_lean*rear_grip_sliding_velocity_2_on_lean - l_path_x_path_angle*y_path_angle_4 - l_path_x_path_y*y_path_y_4
    path_x_by_rear_grip_sliding_velocity_2 = y_path_x_4/D_path_x
    path_y_by_rear_grip_sliding_velocity_2 = y_path_y_4/D_path_y - l_path_x_path_y*path_x_by_rear_grip_sliding_velocity_2
    path_angle_by_rear_grip_sliding_velocity_2 = y_path_angle_4/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_path_angle*path_y_by_rear_grip_sliding_velocity_2
    height_by_rear_grip_sliding_velocity_2 = y_height_4/D_height - l_path_angle_height*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_height*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_height*path_y_by_rear_grip_sliding_velocity_2
    lean_by_rear_grip_sliding_velocity_2 = rear_grip_sliding_velocity_2_on_lean/D_lean - height_by_rear_grip_sliding_velocity_2*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_lean*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_lean*path_y_by_rear_grip_sliding_velocity_2
    pitch_by_rear_grip_sliding_velocity_2 = -height_by_rear_grip_sliding_velocity_2*l_height_pitch - l_lean_pitch*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_pitch*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_pitch*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_pitch*path_y_by_rear_grip_sliding_velocity_2
    rear_hub_by_rear_grip_sliding_velocity_2 = inverse_rear_wheel_yy*rear_grip_sliding_velocity_2_on_pitch - pitch_by_rear_grip_sliding_velocity_2 - l_path_angle_rear_hub*path_angle_by_rear_grip_sliding_velocity_2
    steer_by_rear_grip_sliding_velocity_2 = -height_by_rear_grip_sliding_velocity_2*l_height_steer - l_lean_steer*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_steer*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_steer*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_steer*path_y_by_rear_grip_sliding_velocity_2 - l_pitch_steer*pitch_by_rear_grip_sliding_velocity_2
    front_hub_by_rear_grip_sliding_velocity_2 = -l_lean_front_hub*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_front_hub*path_angle_by_rear_grip_sliding_velocity_2 - l_pitch_front_hub*pitch_by_rear_grip_sliding_velocity_2
    y_pitch_2 = front_grip_gap_on_pitch - front_grip_gap_on_front_hub*l_pitch_front_hub - front_grip_gap_on_steer*l_pitch_steer
    y_lean_2 = front_grip_gap_on_lean - front_grip_gap_on_front_hub*l_lean_front_hub - front_grip_gap_on_steer*l_lean_steer - l_lean_pitch*y_pitch_2
    y_height_5 = 1 - front_grip_gap_on_steer*l_height_steer - l_height_lean*y_lean_2 - l_height_pitch*y_pitch_2
    y_path_angle_5 = -front_grip_gap_on_front_hub*l_path_angle_front_hub - front_grip_gap_on_steer*l_path_angle_steer - l_path_angle_height*y_height_5 - l_path_angle_lean*y_lean_2 - l_path_angle_pitch*y_pitch_2
    y_path_y_5 = -front_grip_gap_on_steer*l_path_y_steer - l_path_y_height*y_height_5 - l_path_y_lean*y_lean_2 - l_path_y_path_angle*y_path_angle_5 - l_path_y_pitch*y_pitch_2
    y_path_x_5 = -front_grip_gap_on_steer*l_path_x_steer - l_path_x_height*y_height_5 - l_path_x_lean*y_lean_2 - l_path_x_path_angle*y_path_angle_5 - l_path_x_path_y*y_path_y_5 - l_path_x_pitch*y_pitch_2
    path_x_by_front_grip_gap = y_path_x_5/D_path_x
    path_y_by_front_grip_gap = y_path_y_5/D_path_y - l_path_x_path_y*path_x_by_front_grip_gap
    path_angle_by_front_grip_gap = y_path_angle_5/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_gap - l_path_y_path_angle*path_y_by_front_grip_gap
    height_by_front_grip_gap = y_height_5/D_height - l_path_angle_height*path_angle_by_front_grip_gap - l_path_x_height*path_x_by_front_grip_gap - l_path_y_height*path_y_by_front_grip_gap
    lean_by_front_grip_gap = y_lean_2/D_lean - height_by_front_grip_gap*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_gap - l_path_x_lean*path_x_by_front_grip_gap - l_path_y_lean*path_y_by_front_grip_gap
    pitch_by_front_grip_gap = y_pitch_2/D_pitch - height_by_front_grip_gap*l_height_pitch - l_lean_pitch*lean_by_front_grip_gap - l_path_angle_pitch*path_angle_by_front_grip_gap - l_path_x_pitch*path_x_by_front_grip_gap - l_path_y_pitch*path_y_by_front_grip_gap
    rear_hub_by_front_grip_gap = -pitch_by_front_grip_gap - l_path_angle_rear_hub*path_angle_by_front_grip_gap
    steer_by_front_grip_gap = front_grip_gap_on_steer/fork_total_J_z_z - height_by_front_grip_gap*l_height_steer - l_lean_steer*lean_by_front_grip_gap - l_path_angle_steer*path_angle_by_front_grip_gap - l_path_x_steer*path_x_by_front_grip_gap - l_path_y_steer*path_y_by_front_grip_gap - l_pitch_steer*pitch_by_front_grip_gap
    front_hub_by_front_grip_gap = front_grip_gap_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_gap - l_path_angle_front_hub*path_angle_by_front_grip_gap - l_pitch_front_hub*pitch_by_front_grip_gap
    y_pitch_3 = front_grip_sliding_velocity_1_on_pitch - front_grip_sliding_velocity_1_on_front_hub*l_pitch_front_hub - front_grip_sliding_velocity_1_on_steer*l_pitch_steer
    y_lean_3 = front_grip_sliding_velocity_1_on_lean - front_grip_sliding_velocity_1_on_front_hub*l_lean_front_hub - front_grip_sliding_velocity_1_on_steer*l_lean_steer - l_lean_pitch*y_pitch_3
    y_height_6 = -front_grip_sliding_velocity_1_on_steer*l_height_steer - l_height_lean*y_lean_3 - l_height_pitch*y_pitch_3
    y_path_angle_6 = front_grip_sliding_velocity_1_on_path_angle - front_grip_sliding_velocity_1_on_front_hub*l_path_angle_front_hub - front_grip_sliding_velocity_1_on_steer*l_path_angle_steer - l_path_angle_height*y_height_6 - l_path_angle_lean*y_lean_3 - l_path_angle_pitch*y_pitch_3
    y_path_y_6 = 1 - front_grip_sliding_velocity_1_on_steer*l_path_y_steer - l_path_y_height*y_height_6 - l_path_y_lean*y_lean_3 - l_path_y_path_angle*y_path_angle_6 - l_path_y_pitch*y_pitch_3
    y_path_x_6 = -front_grip_sliding_velocity_1_on_steer*l_path_x_steer - l_path_x_height*y_height_6 - l_path_x_lean*y_lean_3 - l_path_x_path_angle*y_path_angle_6 - l_path_x_path_y*y_path_y_6 - l_path_x_pitch*y_pitch_3
    path_x_by_front_grip_sliding_velocity_1 = y_path_x_6/D_path_x
    path_y_by_front_grip_sliding_velocity_1 = y_path_y_6/D_path_y - l_path_x_path_y*path_x_by_front_grip_sliding_velocity_1
    path_angle_by_front_grip_sliding_velocity_1 = y_path_angle_6/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_sliding_velocity_1 - l_path_y_path_angle*path_y_by_front_grip_sliding_velocity_1
    height_by_front_grip_sliding_velocity_1 = y_height_6/D_height - l_path_angle_height*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_height*path_x_by_front_grip_sliding_velocity_1 - l_path_y_height*path_y_by_front_grip_sliding_velocity_1
    lean_by_front_grip_sliding_velocity_1 = y_lean_3/D_lean - height_by_front_grip_sliding_velocity_1*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_lean*path_x_by_front_grip_sliding_velocity_1 - l_path_y_lean*path_y_by_front_grip_sliding_velocity_1
    pitch_by_front_grip_sliding_velocity_1 = y_pitch_3/D_pitch - height_by_front_grip_sliding_velocity_1*l_height_pitch - l_lean_pitch*lean_by_front_grip_sliding_velocity_1 - l_path_angle_pitch*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_pitch*path_x_by_front_grip_sliding_velocity_1 - l_path_y_pitch*path_y_by_front_grip_sliding_velocity_1
    rear_hub_by_front_grip_sliding_velocity_1 = -pitch_by_front_grip_sliding_velocity_1 - l_path_angle_rear_hub*path_angle_by_front_grip_sliding_velocity_1
    steer_by_front_grip_sliding_velocity_1 = front_grip_sliding_velocity_1_on_steer/fork_total_J_z_z - height_by_front_grip_sliding_velocity_1*l_height_steer - l_lean_steer*lean_by_front_grip_sliding_velocity_1 - l_path_angle_steer*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_steer*path_x_by_front_grip_sliding_velocity_1 - l_path_y_steer*path_y_by_front_grip_sliding_velocity_1 - l_pitch_steer*pitch_by_front_grip_sliding_velocity_1
    front_hub_by_front_grip_sliding_velocity_1 = front_grip_sliding_velocity_1_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_sliding_velocity_1 - l_path_angle_front_hub*path_angle_by_front_grip_sliding_velocity_1 - l_pitch_front_hub*pitch_by_front_grip_sliding_velocity_1
    y_pitch_4 = front_grip_sliding_velocity_2_on_pitch - front_grip_sliding_velocity_2_on_front_hub*l_pitch_front_hub - front_grip_sliding_velocity_2_on_steer*l_pitch_steer
    y_lean_4 = front_grip_sliding_velocity_2_on_lean - front_grip_sliding_velocity_2_on_front_hub*l_lean_front_hub - front_grip_sliding_velocity_2_on_steer*l_lean_steer - l_lean_pitch*y_pitch_4
    y_height_7 = -front_grip_sliding_velocity_2_on_steer*l_height_steer - l_height_lean*y_lean_4 - l_height_pitch*y_pitch_4
    y_path_angle_7 = front_grip_sliding_velocity_2_on_path_angle - front_grip_sliding_velocity_2_on_front_hub*l_path_angle_front_hub - front_grip_sliding_velocity_2_on_steer*l_path_angle_steer - l_path_angle_height*y_height_7 - l_path_angle_lean*y_lean_4 - l_path_angle_pitch*y_pitch_4
    y_path_y_7 = -front_grip_sliding_velocity_2_on_steer*l_path_y_steer - l_path_y_height*y_height_7 - l_path_y_lean*y_lean_4 - l_path_y_path_angle*y_path_angle_7 - l_path_y_pitch*y_pitch_4
    y_path_x_7 = 1 - front_grip_sliding_velocity_2_on_steer*l_path_x_steer - l_path_x_height*y_height_7 - l_path_x_lean*y_lean_4 - l_path_x_path_angle*y_path_angle_7 - l_path_x_path_y*y_path_y_7 - l_path_x_pitch*y_pitch_4
    path_x_by_front_grip_sliding_velocity_2 = y_path_x_7/D_path_x
    path_y_by_front_grip_sliding_velocity_2 = y_path_y_7/D_path_y - l_path_x_path_y*path_x_by_front_grip_sliding_velocity_2
    path_angle_by_front_grip_sliding_velocity_2 = y_path_angle_7/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_sliding_velocity_2 - l_path_y_path_angle*path_y_by_front_grip_sliding_velocity_2
    height_by_front_grip_sliding_velocity_2 = y_height_7/D_height - l_path_angle_height*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_height*path_x_by_front_grip_sliding_velocity_2 - l_path_y_height*path_y_by_front_grip_sliding_velocity_2
    lean_by_front_grip_sliding_velocity_2 = y_lean_4/D_lean - height_by_front_grip_sliding_velocity_2*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_lean*path_x_by_front_grip_sliding_velocity_2 - l_path_y_lean*path_y_by_front_grip_sliding_velocity_2
    pitch_by_front_grip_sliding_velocity_2 = y_pitch_4/D_pitch - height_by_front_grip_sliding_velocity_2*l_height_pitch - l_lean_pitch*lean_by_front_grip_sliding_velocity_2 - l_path_angle_pitch*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_pitch*path_x_by_front_grip_sliding_velocity_2 - l_path_y_pitch*path_y_by_front_grip_sliding_velocity_2
    rear_hub_by_front_grip_sliding_velocity_2 = -pitch_by_front_grip_sliding_velocity_2 - l_path_angle_rear_hub*path_angle_by_front_grip_sliding_velocity_2
    steer_by_front_grip_sliding_velocity_2 = front_grip_sliding_velocity_2_on_steer/fork_total_J_z_z - height_by_front_grip_sliding_velocity_2*l_height_steer - l_lean_steer*lean_by_front_grip_sliding_velocity_2 - l_path_angle_steer*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_steer*path_x_by_front_grip_sliding_velocity_2 - l_path_y_steer*path_y_by_front_grip_sliding_velocity_2 - l_pitch_steer*pitch_by_front_grip_sliding_velocity_2
    front_hub_by_front_grip_sliding_velocity_2 = front_grip_sliding_velocity_2_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_sliding_velocity_2 - l_path_angle_front_hub*path_angle_by_front_grip_sliding_velocity_2 - l_pitch_front_hub*pitch_by_front_grip_sliding_velocity_2
    W_rear_grip_gap_rear_grip_gap = height_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_gap_on_lean + pitch_by_rear_grip_gap*rear_grip_gap_on_pitch + rear_grip_gap_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_1_rear_grip_gap = path_y_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_lean + path_angle_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_path_angle + pitch_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_pitch + rear_grip_sliding_velocity_1_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = path_y_by_rear_grip_sliding_velocity_1 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_lean + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_path_angle + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_pitch + rear_grip_sliding_velocity_1_on_pitch*rear_hub_by_rear_grip_sliding_velocity_1
    W_rear_grip_sliding_velocity_2_rear_grip_gap = path_x_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = path_x_by_rear_grip_sliding_velocity_1 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_sliding_velocity_1
    W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = path_x_by_rear_grip_sliding_velocity_2 + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_sliding_velocity_2
    W_front_grip_gap_rear_grip_gap = height_by_rear_grip_gap + front_grip_gap_on_front_hub*front_hub_by_rear_grip_gap + front_grip_gap_on_lean*lean_by_rear_grip_gap + front_grip_gap_on_pitch*pitch_by_rear_grip_gap + front_grip_gap_on_steer*steer_by_rear_grip_gap
    W_front_grip_gap_rear_grip_sliding_velocity_1 = height_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_steer*steer_by_rear_grip_sliding_velocity_1
    W_front_grip_gap_rear_grip_sliding_velocity_2 = height_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_steer*steer_by_rear_grip_sliding_velocity_2
    W_front_grip_gap_front_grip_gap = height_by_front_grip_gap + front_grip_gap_on_front_hub*front_hub_by_front_grip_gap + front_grip_gap_on_lean*lean_by_front_grip_gap + front_grip_gap_on_pitch*pitch_by_front_grip_gap + front_grip_gap_on_steer*steer_by_front_grip_gap
    W_front_grip_sliding_velocity_1_rear_grip_gap = path_y_by_rear_grip_gap + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_gap + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_gap + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_gap + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_gap + path_angle_by_rear_grip_gap*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = path_y_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_sliding_velocity_1 + path_angle_by_rear_grip_sliding_velocity_1*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 = path_y_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_sliding_velocity_2 + path_angle_by_rear_grip_sliding_velocity_2*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_front_grip_gap = path_y_by_front_grip_gap + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_on_lean*lean_by_front_grip_gap + front_grip_sliding_velocity_1_on_pitch*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_on_steer*steer_by_front_grip_gap + path_angle_by_front_grip_gap*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1 = path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_lean*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_pitch*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_steer*steer_by_front_grip_sliding_velocity_1 + path_angle_by_front_grip_sliding_velocity_1*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_2_rear_grip_gap = path_x_by_rear_grip_gap + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_gap + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_gap + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_gap + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_gap + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_gap
    W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = path_x_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_sliding_velocity_1
    W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = path_x_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_sliding_velocity_2
    W_front_grip_sliding_velocity_2_front_grip_gap = path_x_by_front_grip_gap + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_gap + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_gap + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_gap + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_gap + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_gap
    W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_sliding_velocity_1
    W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2 = path_x_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_sliding_velocity_2
    W_rear_grip_gap_raised = W_rear_grip_gap_rear_grip_gap + W_rear_grip_gap_rear_grip_gap*rear_grip_gap_softness
    W_rear_grip_sliding_velocity_1_raised = W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 + W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_softness
    W_rear_grip_sliding_velocity_2_raised = W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 + W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_softness
    W_front_grip_gap_raised = W_front_grip_gap_front_grip_gap + W_front_grip_gap_front_grip_gap*front_grip_gap_softness
    W_front_grip_sliding_velocity_1_raised = W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1 + W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1*front_grip_sliding_velocity_1_softness
    W_front_grip_sliding_velocity_2_raised = W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2 + W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2*front_grip_sliding_velocity_2_softness
    l_rear_grip_sliding_velocity_1_rear_grip_gap = W_rear_grip_sliding_velocity_1_rear_grip_gap/W_rear_grip_gap_raised
    D_rear_grip_sliding_velocity_1 = W_rear_grip_sliding_velocity_1_raised - W_rear_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_rear_grip_sliding_velocity_2_rear_grip_gap = W_rear_grip_sliding_velocity_2_rear_grip_gap/W_rear_grip_gap_raised
    L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_rear_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1
    D_rear_grip_sliding_velocity_2 = W_rear_grip_sliding_velocity_2_raised - L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_rear_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    L_front_grip_gap_rear_grip_sliding_velocity_1 = W_front_grip_gap_rear_grip_sliding_velocity_1 - W_front_grip_gap_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    L_front_grip_gap_rear_grip_sliding_velocity_2 = W_front_grip_gap_rear_grip_sliding_velocity_2 - L_front_grip_gap_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_gap_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_gap_rear_grip_gap, l_front_grip_sliding_velocity_1_rear_grip_gap, l_front_grip_sliding_velocity_2_rear_grip_gap = rolling_without_slip_l_gap_gap(W_front_grip_gap_rear_grip_gap, W_front_grip_sliding_velocity_1_rear_grip_gap, W_front_grip_sliding_velocity_2_rear_grip_gap, W_rear_grip_gap_raised)
    L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_gap_rear_grip_sliding_velocity_2, l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2, l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = rolling_without_slip_l_gap_gap(L_front_grip_gap_rear_grip_sliding_velocity_2, L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2, L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2, D_rear_grip_sliding_velocity_2)
    l_front_grip_gap_rear_grip_sliding_velocity_1, l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1, l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = rolling_without_slip_l_gap_gap(L_front_grip_gap_rear_grip_sliding_velocity_1, L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1, L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1, D_rear_grip_sliding_velocity_1)
    D_front_grip_gap = W_front_grip_gap_raised - L_front_grip_gap_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_gap_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_gap_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    L_front_grip_sliding_velocity_1_front_grip_gap = W_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    l_front_grip_sliding_velocity_1_front_grip_gap = L_front_grip_sliding_velocity_1_front_grip_gap/D_front_grip_gap
    D_front_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_1_raised - L_front_grip_sliding_velocity_1_front_grip_gap*l_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_front_grip_sliding_velocity_1_rear_grip_gap
    L_front_grip_sliding_velocity_2_front_grip_gap = W_front_grip_sliding_velocity_2_front_grip_gap - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    l_front_grip_sliding_velocity_2_front_grip_gap = L_front_grip_sliding_velocity_2_front_grip_gap/D_front_grip_gap
    L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_front_grip_gap*l_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1/D_front_grip_sliding_velocity_1
    D_front_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_2_raised - L_front_grip_sliding_velocity_2_front_grip_gap*l_front_grip_sliding_velocity_2_front_grip_gap - L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_sliding_velocity_2_rear_grip_gap
    rear_grip_gap_left = -height_acc - rear_grip_gap_apart_bias_z - lean_acc*rear_grip_gap_on_lean - pitch_acc*rear_grip_gap_on_pitch - rear_grip_gap_on_pitch*rear_hub_acc
    rear_grip_sliding_velocity_1_left = -path_y_acc - rear_grip_gap_apart_bias_y - lean_acc*rear_grip_sliding_velocity_1_on_lean - path_angle_acc*rear_grip_sliding_velocity_1_on_path_angle - pitch_acc*rear_grip_sliding_velocity_1_on_pitch - rear_grip_sliding_velocity_1_on_pitch*rear_hub_acc
    rear_grip_sliding_velocity_2_left = -path_x_acc - rear_grip_gap_apart_bias_x - lean_acc*rear_grip_sliding_velocity_2_on_lean - path_angle_acc*rear_grip_sliding_velocity_2_on_path_angle - pitch_acc*rear_grip_sliding_velocity_2_on_pitch - rear_grip_sliding_velocity_2_on_pitch*rear_hub_acc
    front_grip_gap_left = -front_grip_gap_apart_bias_z - height_acc - front_grip_gap_on_front_hub*front_hub_acc - front_grip_gap_on_lean*lean_acc - front_grip_gap_on_pitch*pitch_acc - front_grip_gap_on_steer*steer_acc
    front_grip_sliding_velocity_1_left = -front_grip_gap_apart_bias_y - path_y_acc - front_grip_sliding_velocity_1_on_front_hub*front_hub_acc - front_grip_sliding_velocity_1_on_lean*lean_acc - front_grip_sliding_velocity_1_on_pitch*pitch_acc - front_grip_sliding_velocity_1_on_steer*steer_acc - path_angle_acc*front_grip_sliding_velocity_1_on_path_angle
    front_grip_sliding_velocity_2_left = -front_grip_gap_apart_bias_x - path_x_acc - front_grip_sliding_velocity_2_on_front_hub*front_hub_acc - front_grip_sliding_velocity_2_on_lean*lean_acc - front_grip_sliding_velocity_2_on_path_angle*path_angle_acc - front_grip_sliding_velocity_2_on_pitch*pitch_acc - front_grip_sliding_velocity_2_on_steer*steer_acc
    y_rear_grip_sliding_velocity_1 = rear_grip_sliding_velocity_1_left - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left
    y_rear_grip_sliding_velocity_2 = rear_grip_sliding_velocity_2_left - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_1
    y_front_grip_gap = front_grip_gap_left - l_front_grip_gap_rear_grip_gap*rear_grip_gap_left - l_front_grip_gap_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_1 - l_front_grip_gap_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_2
    y_front_grip_sliding_velocity_1 = front_grip_sliding_velocity_1_left - l_front_grip_sliding_velocity_1_front_grip_gap*y_front_grip_gap - l_front_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_1 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_2
    y_front_grip_sliding_velocity_2 = front_grip_sliding_velocity_2_left - l_front_grip_sliding_velocity_2_front_grip_gap*y_front_grip_gap - l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*y_front_grip_sliding_velocity_1 - l_front_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_1 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_2
    front_grip_sliding_velocity_2_acc = y_front_grip_sliding_velocity_2/D_front_grip_sliding_velocity_2
    front_grip_sliding_velocity_1_acc = y_front_grip_sliding_velocity_1/D_front_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1
    front_grip_gap_acc = y_front_grip_gap/D_front_grip_gap - front_grip_sliding_velocity_1_acc*l_front_grip_sliding_velocity_1_front_grip_gap - front_grip_sliding_velocity_2_acc*l_front_grip_sliding_velocity_2_front_grip_gap
    rear_grip_sliding_velocity_2_acc = y_rear_grip_sliding_velocity_2/D_rear_grip_sliding_velocity_2 - front_grip_gap_acc*l_front_grip_gap_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_1_acc*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_2_acc*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    rear_grip_sliding_velocity_1_acc = y_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1 - front_grip_gap_acc*l_front_grip_gap_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_1_acc*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_acc
    rear_grip_gap_acc = rear_grip_gap_left/W_rear_grip_gap_raised - front_grip_gap_acc*l_front_grip_gap_rear_grip_gap - front_grip_sliding_velocity_1_acc*l_front_grip_sliding_velocity_1_rear_grip_gap - front_grip_sliding_velocity_2_acc*l_front_grip_sliding_velocity_2_rear_grip_gap - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_sliding_velocity_1_acc - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_sliding_velocity_2_acc
    path_x_acc_2 = path_x_acc + front_grip_gap_acc*path_x_by_front_grip_gap + front_grip_sliding_velocity_1_acc*path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*path_x_by_front_grip_sliding_velocity_2 + path_x_by_rear_grip_gap*rear_grip_gap_acc + path_x_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + path_x_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    path_y_acc_2 = path_y_acc + front_grip_gap_acc*path_y_by_front_grip_gap + front_grip_sliding_velocity_1_acc*path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*path_y_by_front_grip_sliding_velocity_2 + path_y_by_rear_grip_gap*rear_grip_gap_acc + path_y_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + path_y_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    path_angle_acc_2 = path_angle_acc + front_grip_gap_acc*path_angle_by_front_grip_gap + front_grip_sliding_velocity_1_acc*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*path_angle_by_front_grip_sliding_velocity_2 + path_angle_by_rear_grip_gap*rear_grip_gap_acc + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    height_acc_2 = height_acc + front_grip_gap_acc*height_by_front_grip_gap + front_grip_sliding_velocity_1_acc*height_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*height_by_front_grip_sliding_velocity_2 + height_by_rear_grip_gap*rear_grip_gap_acc + height_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + height_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    lean_acc_2 = lean_acc + front_grip_gap_acc*lean_by_front_grip_gap + front_grip_sliding_velocity_1_acc*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*lean_by_front_grip_sliding_velocity_2 + lean_by_rear_grip_gap*rear_grip_gap_acc + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    pitch_acc_2 = pitch_acc + front_grip_gap_acc*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_acc*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*pitch_by_front_grip_sliding_velocity_2 + pitch_by_rear_grip_gap*rear_grip_gap_acc + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    rear_hub_acc_2 = rear_hub_acc + front_grip_gap_acc*rear_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc*rear_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*rear_hub_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc*rear_hub_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc*rear_hub_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc*rear_hub_by_rear_grip_sliding_velocity_2
    steer_acc_2 = steer_acc + front_grip_gap_acc*steer_by_front_grip_gap + front_grip_sliding_velocity_1_acc*steer_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*steer_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc*steer_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc*steer_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc*steer_by_rear_grip_sliding_velocity_2
    front_hub_acc_2 = front_hub_acc + front_grip_gap_acc*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc*front_hub_by_front_grip_sliding_velocity_2 + front_hub_by_rear_grip_gap*rear_grip_gap_acc + front_hub_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc + front_hub_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc
    rear_grip_gap_left_2 = -height_acc_2 - rear_grip_gap_apart_bias_z - lean_acc_2*rear_grip_gap_on_lean - pitch_acc_2*rear_grip_gap_on_pitch - rear_grip_gap_on_pitch*rear_hub_acc_2
    rear_grip_sliding_velocity_1_left_2 = -path_y_acc_2 - rear_grip_gap_apart_bias_y - lean_acc_2*rear_grip_sliding_velocity_1_on_lean - path_angle_acc_2*rear_grip_sliding_velocity_1_on_path_angle - pitch_acc_2*rear_grip_sliding_velocity_1_on_pitch - rear_grip_sliding_velocity_1_on_pitch*rear_hub_acc_2
    rear_grip_sliding_velocity_2_left_2 = -path_x_acc_2 - rear_grip_gap_apart_bias_x - lean_acc_2*rear_grip_sliding_velocity_2_on_lean - path_angle_acc_2*rear_grip_sliding_velocity_2_on_path_angle - pitch_acc_2*rear_grip_sliding_velocity_2_on_pitch - rear_grip_sliding_velocity_2_on_pitch*rear_hub_acc_2
    front_grip_gap_left_2 = -front_grip_gap_apart_bias_z - height_acc_2 - front_grip_gap_on_front_hub*front_hub_acc_2 - front_grip_gap_on_lean*lean_acc_2 - front_grip_gap_on_pitch*pitch_acc_2 - front_grip_gap_on_steer*steer_acc_2
    front_grip_sliding_velocity_1_left_2 = -front_grip_gap_apart_bias_y - path_y_acc_2 - front_grip_sliding_velocity_1_on_front_hub*front_hub_acc_2 - front_grip_sliding_velocity_1_on_lean*lean_acc_2 - front_grip_sliding_velocity_1_on_pitch*pitch_acc_2 - front_grip_sliding_velocity_1_on_steer*steer_acc_2 - path_angle_acc_2*front_grip_sliding_velocity_1_on_path_angle
    front_grip_sliding_velocity_2_left_2 = -front_grip_gap_apart_bias_x - path_x_acc_2 - front_grip_sliding_velocity_2_on_front_hub*front_hub_acc_2 - front_grip_sliding_velocity_2_on_lean*lean_acc_2 - front_grip_sliding_velocity_2_on_path_angle*path_angle_acc_2 - front_grip_sliding_velocity_2_on_pitch*pitch_acc_2 - front_grip_sliding_velocity_2_on_steer*steer_acc_2
    y_rear_grip_sliding_velocity_3 = rear_grip_sliding_velocity_1_left_2 - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_2
    y_rear_grip_sliding_velocity_4 = rear_grip_sliding_velocity_2_left_2 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_2 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_3
    y_front_grip_gap_2 = front_grip_gap_left_2 - l_front_grip_gap_rear_grip_gap*rear_grip_gap_left_2 - l_front_grip_gap_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_3 - l_front_grip_gap_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_4
    y_front_grip_sliding_velocity_3 = front_grip_sliding_velocity_1_left_2 - l_front_grip_sliding_velocity_1_front_grip_gap*y_front_grip_gap_2 - l_front_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_2 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_3 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_4
    y_front_grip_sliding_velocity_4 = front_grip_sliding_velocity_2_left_2 - l_front_grip_sliding_velocity_2_front_grip_gap*y_front_grip_gap_2 - l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*y_front_grip_sliding_velocity_3 - l_front_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_2 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_3 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_4
    front_grip_sliding_velocity_2_acc_2 = y_front_grip_sliding_velocity_4/D_front_grip_sliding_velocity_2
    front_grip_sliding_velocity_1_acc_2 = y_front_grip_sliding_velocity_3/D_front_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc_2*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1
    front_grip_gap_acc_2 = y_front_grip_gap_2/D_front_grip_gap - front_grip_sliding_velocity_1_acc_2*l_front_grip_sliding_velocity_1_front_grip_gap - front_grip_sliding_velocity_2_acc_2*l_front_grip_sliding_velocity_2_front_grip_gap
    rear_grip_sliding_velocity_2_acc_2 = y_rear_grip_sliding_velocity_4/D_rear_grip_sliding_velocity_2 - front_grip_gap_acc_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_1_acc_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_2_acc_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    rear_grip_sliding_velocity_1_acc_2 = y_rear_grip_sliding_velocity_3/D_rear_grip_sliding_velocity_1 - front_grip_gap_acc_2*l_front_grip_gap_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_1_acc_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_acc_2
    rear_grip_gap_acc_2 = rear_grip_gap_left_2/W_rear_grip_gap_raised - front_grip_gap_acc_2*l_front_grip_gap_rear_grip_gap - front_grip_sliding_velocity_1_acc_2*l_front_grip_sliding_velocity_1_rear_grip_gap - front_grip_sliding_velocity_2_acc_2*l_front_grip_sliding_velocity_2_rear_grip_gap - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_sliding_velocity_1_acc_2 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_sliding_velocity_2_acc_2
    rear_grip_gap_acc_3 = rear_grip_gap_acc + rear_grip_gap_acc_2
    rear_grip_sliding_velocity_1_acc_3 = rear_grip_sliding_velocity_1_acc + rear_grip_sliding_velocity_1_acc_2
    rear_grip_sliding_velocity_2_acc_3 = rear_grip_sliding_velocity_2_acc + rear_grip_sliding_velocity_2_acc_2
    front_grip_gap_acc_3 = front_grip_gap_acc + front_grip_gap_acc_2
    front_grip_sliding_velocity_1_acc_3 = front_grip_sliding_velocity_1_acc + front_grip_sliding_velocity_1_acc_2
    front_grip_sliding_velocity_2_acc_3 = front_grip_sliding_velocity_2_acc + front_grip_sliding_velocity_2_acc_2
    path_x_acc_3 = path_x_acc_2 + front_grip_gap_acc_2*path_x_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*path_x_by_front_grip_sliding_velocity_2 + path_x_by_rear_grip_gap*rear_grip_gap_acc_2 + path_x_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + path_x_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    path_y_acc_3 = path_y_acc_2 + front_grip_gap_acc_2*path_y_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*path_y_by_front_grip_sliding_velocity_2 + path_y_by_rear_grip_gap*rear_grip_gap_acc_2 + path_y_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + path_y_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    path_angle_acc_3 = path_angle_acc_2 + front_grip_gap_acc_2*path_angle_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*path_angle_by_front_grip_sliding_velocity_2 + path_angle_by_rear_grip_gap*rear_grip_gap_acc_2 + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    height_acc_3 = height_acc_2 + front_grip_gap_acc_2*height_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*height_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*height_by_front_grip_sliding_velocity_2 + height_by_rear_grip_gap*rear_grip_gap_acc_2 + height_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + height_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    lean_acc_3 = lean_acc_2 + front_grip_gap_acc_2*lean_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*lean_by_front_grip_sliding_velocity_2 + lean_by_rear_grip_gap*rear_grip_gap_acc_2 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    pitch_acc_3 = pitch_acc_2 + front_grip_gap_acc_2*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*pitch_by_front_grip_sliding_velocity_2 + pitch_by_rear_grip_gap*rear_grip_gap_acc_2 + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    rear_hub_acc_3 = rear_hub_acc_2 + front_grip_gap_acc_2*rear_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*rear_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*rear_hub_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc_2*rear_hub_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc_2*rear_hub_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc_2*rear_hub_by_rear_grip_sliding_velocity_2
    steer_acc_3 = steer_acc_2 + front_grip_gap_acc_2*steer_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*steer_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*steer_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc_2*steer_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc_2*steer_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc_2*steer_by_rear_grip_sliding_velocity_2
    front_hub_acc_3 = front_hub_acc_2 + front_grip_gap_acc_2*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc_2*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_2*front_hub_by_front_grip_sliding_velocity_2 + front_hub_by_rear_grip_gap*rear_grip_gap_acc_2 + front_hub_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_2 + front_hub_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_2
    rear_grip_gap_left_3 = -height_acc_3 - rear_grip_gap_apart_bias_z - lean_acc_3*rear_grip_gap_on_lean - pitch_acc_3*rear_grip_gap_on_pitch - rear_grip_gap_on_pitch*rear_hub_acc_3
    rear_grip_sliding_velocity_1_left_3 = -path_y_acc_3 - rear_grip_gap_apart_bias_y - lean_acc_3*rear_grip_sliding_velocity_1_on_lean - path_angle_acc_3*rear_grip_sliding_velocity_1_on_path_angle - pitch_acc_3*rear_grip_sliding_velocity_1_on_pitch - rear_grip_sliding_velocity_1_on_pitch*rear_hub_acc_3
    rear_grip_sliding_velocity_2_left_3 = -path_x_acc_3 - rear_grip_gap_apart_bias_x - lean_acc_3*rear_grip_sliding_velocity_2_on_lean - path_angle_acc_3*rear_grip_sliding_velocity_2_on_path_angle - pitch_acc_3*rear_grip_sliding_velocity_2_on_pitch - rear_grip_sliding_velocity_2_on_pitch*rear_hub_acc_3
    front_grip_gap_left_3 = -front_grip_gap_apart_bias_z - height_acc_3 - front_grip_gap_on_front_hub*front_hub_acc_3 - front_grip_gap_on_lean*lean_acc_3 - front_grip_gap_on_pitch*pitch_acc_3 - front_grip_gap_on_steer*steer_acc_3
    front_grip_sliding_velocity_1_left_3 = -front_grip_gap_apart_bias_y - path_y_acc_3 - front_grip_sliding_velocity_1_on_front_hub*front_hub_acc_3 - front_grip_sliding_velocity_1_on_lean*lean_acc_3 - front_grip_sliding_velocity_1_on_pitch*pitch_acc_3 - front_grip_sliding_velocity_1_on_steer*steer_acc_3 - path_angle_acc_3*front_grip_sliding_velocity_1_on_path_angle
    front_grip_sliding_velocity_2_left_3 = -front_grip_gap_apart_bias_x - path_x_acc_3 - front_grip_sliding_velocity_2_on_front_hub*front_hub_acc_3 - front_grip_sliding_velocity_2_on_lean*lean_acc_3 - front_grip_sliding_velocity_2_on_path_angle*path_angle_acc_3 - front_grip_sliding_velocity_2_on_pitch*pitch_acc_3 - front_grip_sliding_velocity_2_on_steer*steer_acc_3
    y_rear_grip_sliding_velocity_5 = rear_grip_sliding_velocity_1_left_3 - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_3
    y_rear_grip_sliding_velocity_6 = rear_grip_sliding_velocity_2_left_3 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_3 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_5
    y_front_grip_gap_3 = front_grip_gap_left_3 - l_front_grip_gap_rear_grip_gap*rear_grip_gap_left_3 - l_front_grip_gap_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_5 - l_front_grip_gap_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_6
    y_front_grip_sliding_velocity_5 = front_grip_sliding_velocity_1_left_3 - l_front_grip_sliding_velocity_1_front_grip_gap*y_front_grip_gap_3 - l_front_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_3 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_5 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_6
    y_front_grip_sliding_velocity_6 = front_grip_sliding_velocity_2_left_3 - l_front_grip_sliding_velocity_2_front_grip_gap*y_front_grip_gap_3 - l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*y_front_grip_sliding_velocity_5 - l_front_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_3 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_5 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_6
    front_grip_sliding_velocity_2_acc_4 = y_front_grip_sliding_velocity_6/D_front_grip_sliding_velocity_2
    front_grip_sliding_velocity_1_acc_4 = y_front_grip_sliding_velocity_5/D_front_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc_4*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1
    front_grip_gap_acc_4 = y_front_grip_gap_3/D_front_grip_gap - front_grip_sliding_velocity_1_acc_4*l_front_grip_sliding_velocity_1_front_grip_gap - front_grip_sliding_velocity_2_acc_4*l_front_grip_sliding_velocity_2_front_grip_gap
    rear_grip_sliding_velocity_2_acc_4 = y_rear_grip_sliding_velocity_6/D_rear_grip_sliding_velocity_2 - front_grip_gap_acc_4*l_front_grip_gap_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_1_acc_4*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_2_acc_4*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    rear_grip_sliding_velocity_1_acc_4 = y_rear_grip_sliding_velocity_5/D_rear_grip_sliding_velocity_1 - front_grip_gap_acc_4*l_front_grip_gap_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_1_acc_4*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_acc_4*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_acc_4
    rear_grip_gap_acc_4 = rear_grip_gap_left_3/W_rear_grip_gap_raised - front_grip_gap_acc_4*l_front_grip_gap_rear_grip_gap - front_grip_sliding_velocity_1_acc_4*l_front_grip_sliding_velocity_1_rear_grip_gap - front_grip_sliding_velocity_2_acc_4*l_front_grip_sliding_velocity_2_rear_grip_gap - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_sliding_velocity_1_acc_4 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_sliding_velocity_2_acc_4
    rear_grip_gap_acc_5 = rear_grip_gap_acc_3 + rear_grip_gap_acc_4
    rear_grip_sliding_velocity_1_acc_5 = rear_grip_sliding_velocity_1_acc_3 + rear_grip_sliding_velocity_1_acc_4
    rear_grip_sliding_velocity_2_acc_5 = rear_grip_sliding_velocity_2_acc_3 + rear_grip_sliding_velocity_2_acc_4
    front_grip_gap_acc_5 = front_grip_gap_acc_3 + front_grip_gap_acc_4
    front_grip_sliding_velocity_1_acc_5 = front_grip_sliding_velocity_1_acc_3 + front_grip_sliding_velocity_1_acc_4
    front_grip_sliding_velocity_2_acc_5 = front_grip_sliding_velocity_2_acc_3 + front_grip_sliding_velocity_2_acc_4
    path_x_acc_4 = path_x_acc_3 + front_grip_gap_acc_4*path_x_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*path_x_by_front_grip_sliding_velocity_2 + path_x_by_rear_grip_gap*rear_grip_gap_acc_4 + path_x_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + path_x_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    path_y_acc_4 = path_y_acc_3 + front_grip_gap_acc_4*path_y_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*path_y_by_front_grip_sliding_velocity_2 + path_y_by_rear_grip_gap*rear_grip_gap_acc_4 + path_y_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + path_y_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    path_angle_acc_4 = path_angle_acc_3 + front_grip_gap_acc_4*path_angle_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*path_angle_by_front_grip_sliding_velocity_2 + path_angle_by_rear_grip_gap*rear_grip_gap_acc_4 + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    height_acc_4 = height_acc_3 + front_grip_gap_acc_4*height_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*height_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*height_by_front_grip_sliding_velocity_2 + height_by_rear_grip_gap*rear_grip_gap_acc_4 + height_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + height_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    lean_acc_4 = lean_acc_3 + front_grip_gap_acc_4*lean_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*lean_by_front_grip_sliding_velocity_2 + lean_by_rear_grip_gap*rear_grip_gap_acc_4 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    pitch_acc_4 = pitch_acc_3 + front_grip_gap_acc_4*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*pitch_by_front_grip_sliding_velocity_2 + pitch_by_rear_grip_gap*rear_grip_gap_acc_4 + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    rear_hub_acc_4 = rear_hub_acc_3 + front_grip_gap_acc_4*rear_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*rear_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*rear_hub_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc_4*rear_hub_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc_4*rear_hub_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc_4*rear_hub_by_rear_grip_sliding_velocity_2
    steer_acc_4 = steer_acc_3 + front_grip_gap_acc_4*steer_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*steer_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*steer_by_front_grip_sliding_velocity_2 + rear_grip_gap_acc_4*steer_by_rear_grip_gap + rear_grip_sliding_velocity_1_acc_4*steer_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_acc_4*steer_by_rear_grip_sliding_velocity_2
    front_hub_acc_4 = front_hub_acc_3 + front_grip_gap_acc_4*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_acc_4*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_acc_4*front_hub_by_front_grip_sliding_velocity_2 + front_hub_by_rear_grip_gap*rear_grip_gap_acc_4 + front_hub_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_acc_4 + front_hub_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_acc_4
    return (ca.vertcat(path_x_acc_4, path_y_acc_4, path_angle_acc_4, height_acc_4, lean_acc_4, pitch_acc_4, rear_hub_acc_4, steer_acc_4,
            front_hub_acc_4),
        ca.vertcat(),
        ca.vertcat(rear_grip_gap_acc_5, rear_grip_sliding_velocity_1_acc_5, rear_grip_sliding_velocity_2_acc_5, front_grip_gap_acc_5,
            front_grip_sliding_velocity_1_acc_5, front_grip_sliding_velocity_2_acc_5))


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (6,): CONSTRAINTS [m]
        dphi (6,): CONSTRAINTS [m/s]
    """
    rear_radius, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y, fork_lined_up_z_x = c[7], c[10], c[11], c[12], c[13]
    fork_lined_up_z_z, trail_plus_wheel_base, k2, k3 = c[14], c[15], c[16], c[17]
    height_travel, pitch_angle, steer_angle = q[3], q[5], q[7]
    path_x_speed, path_y_speed, path_angle_speed, height_speed, lean_speed, pitch_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    steer_speed = u[7]
    cos_heading, sin_heading = revolute_constants_terms(q[2])
    cos_leaning, sin_leaning = revolute_constants_terms(q[4])
    cos_frame = ca.cos(pitch_angle)
    sin_frame = ca.sin(pitch_angle)
    cos_fork = ca.cos(steer_angle)
    sin_fork = ca.sin(steer_angle)
    leaning_turning_x = cos_heading*lean_speed
    leaning_turning_y = lean_speed*sin_heading
    leaning_R_x_y = -cos_leaning*sin_heading
    leaning_R_x_z = sin_heading*sin_leaning
    leaning_R_y_y = cos_heading*cos_leaning
    leaning_R_y_z = -cos_heading*sin_leaning
    frame_arm_x = leaning_R_x_z*rear_radius
    frame_arm_y = leaning_R_y_z*rear_radius
    frame_arm_z = cos_leaning*rear_radius
    frame_arm_rate_x = frame_arm_z*leaning_turning_y - frame_arm_y*path_angle_speed
    frame_arm_rate_y = frame_arm_x*path_angle_speed - frame_arm_z*leaning_turning_x
    frame_arm_rate_z = frame_arm_y*leaning_turning_x - frame_arm_x*leaning_turning_y
    frame_turning_x = leaning_R_x_y*pitch_speed
    frame_turning_y = leaning_R_y_y*pitch_speed
    frame_turning_z = pitch_speed*sin_leaning
    frame_rate_x = frame_turning_x + leaning_turning_x
    frame_rate_y = frame_turning_y + leaning_turning_y
    frame_rate_z = frame_turning_z + path_angle_speed
    frame_z_2 = frame_arm_z + height_travel
    frame_velocity_x = frame_arm_rate_x + path_x_speed
    frame_velocity_y = frame_arm_rate_y + path_y_speed
    frame_velocity_z = frame_arm_rate_z + height_speed
    frame_R_x_x = cos_frame*cos_heading - leaning_R_x_z*sin_frame
    frame_R_x_z = cos_frame*leaning_R_x_z + cos_heading*sin_frame
    frame_R_y_x = cos_frame*sin_heading - leaning_R_y_z*sin_frame
    frame_R_y_z = cos_frame*leaning_R_y_z + sin_frame*sin_heading
    frame_R_z_x = -cos_leaning*sin_frame
    frame_R_z_z = cos_frame*cos_leaning
    rear_tyre_gap, rear_grip_gap_velocity_x, rear_grip_gap_velocity_y, rear_grip_gap_velocity_z = rim_on_plane_gap(frame_rate_x, frame_rate_y, frame_rate_z, leaning_R_x_y, leaning_R_y_y, sin_leaning, frame_z_2, frame_velocity_x, frame_velocity_y, frame_velocity_z, u[6], rear_radius)
    fork_arm_x = frame_R_x_x*trail_plus_wheel_base - frame_R_x_z*rear_radius
    fork_arm_y = frame_R_y_x*trail_plus_wheel_base - frame_R_y_z*rear_radius
    fork_arm_z = frame_R_z_x*trail_plus_wheel_base - frame_R_z_z*rear_radius
    fork_arm_rate_x = fork_arm_z*frame_rate_y - fork_arm_y*frame_rate_z
    fork_arm_rate_y = fork_arm_x*frame_rate_z - fork_arm_z*frame_rate_x
    fork_arm_rate_z = fork_arm_y*frame_rate_x - fork_arm_x*frame_rate_y
    steer_axis_x = fork_lined_up_x_z*frame_R_x_x + fork_lined_up_z_z*frame_R_x_z
    steer_axis_y = fork_lined_up_x_z*frame_R_y_x + fork_lined_up_z_z*frame_R_y_z
    steer_axis_z = fork_lined_up_x_z*frame_R_z_x + fork_lined_up_z_z*frame_R_z_z
    fork_turning_x = steer_axis_x*steer_speed
    fork_turning_y = steer_axis_y*steer_speed
    fork_turning_z = steer_axis_z*steer_speed
    fork_rate_x = fork_turning_x + frame_rate_x
    fork_rate_y = fork_turning_y + frame_rate_y
    fork_rate_z = fork_turning_z + frame_rate_z
    fork_z_2 = fork_arm_z + frame_z_2
    fork_velocity_x = fork_arm_rate_x + frame_velocity_x
    fork_velocity_y = fork_arm_rate_y + frame_velocity_y
    fork_velocity_z = fork_arm_rate_z + frame_velocity_z
    fork_lined_up_x_x_times_frame_R_x_x = fork_lined_up_x_x*frame_R_x_x
    fork_lined_up_z_x_times_frame_R_x_z = fork_lined_up_z_x*frame_R_x_z
    x3 = fork_lined_up_x_x_times_frame_R_x_x + fork_lined_up_z_x_times_frame_R_x_z
    fork_R_x_x = cos_fork*x3 + fork_lined_up_y_y*leaning_R_x_y*sin_fork
    fork_R_x_y = cos_fork*fork_lined_up_y_y*leaning_R_x_y - sin_fork*x3
    fork_lined_up_x_x_times_frame_R_y_x = fork_lined_up_x_x*frame_R_y_x
    fork_lined_up_z_x_times_frame_R_y_z = fork_lined_up_z_x*frame_R_y_z
    x6 = fork_lined_up_x_x_times_frame_R_y_x + fork_lined_up_z_x_times_frame_R_y_z
    fork_R_y_x = cos_fork*x6 + fork_lined_up_y_y*leaning_R_y_y*sin_fork
    fork_R_y_y = cos_fork*fork_lined_up_y_y*leaning_R_y_y - sin_fork*x6
    fork_lined_up_x_x_times_frame_R_z_x = fork_lined_up_x_x*frame_R_z_x
    fork_lined_up_z_x_times_frame_R_z_z = fork_lined_up_z_x*frame_R_z_z
    x9 = fork_lined_up_x_x_times_frame_R_z_x + fork_lined_up_z_x_times_frame_R_z_z
    fork_R_z_x = cos_fork*x9 + fork_lined_up_y_y*sin_fork*sin_leaning
    fork_R_z_y = cos_fork*fork_lined_up_y_y*sin_leaning - sin_fork*x9
    front_wheel_arm_x = fork_R_x_x*k2 + k3*steer_axis_x
    front_wheel_arm_y = fork_R_y_x*k2 + k3*steer_axis_y
    front_wheel_arm_z = fork_R_z_x*k2 + k3*steer_axis_z
    front_wheel_arm_rate_x = fork_rate_y*front_wheel_arm_z - fork_rate_z*front_wheel_arm_y
    front_wheel_arm_rate_y = fork_rate_z*front_wheel_arm_x - fork_rate_x*front_wheel_arm_z
    front_wheel_arm_rate_z = fork_rate_x*front_wheel_arm_y - fork_rate_y*front_wheel_arm_x
    front_hub_axis_x = fork_R_x_y*fork_lined_up_y_y
    front_hub_axis_y = fork_R_y_y*fork_lined_up_y_y
    front_hub_axis_z = fork_R_z_y*fork_lined_up_y_y
    front_wheel_z = fork_z_2 + front_wheel_arm_z
    front_wheel_velocity_x = fork_velocity_x + front_wheel_arm_rate_x
    front_wheel_velocity_y = fork_velocity_y + front_wheel_arm_rate_y
    front_wheel_velocity_z = fork_velocity_z + front_wheel_arm_rate_z
    front_tyre_gap, front_grip_gap_velocity_x, front_grip_gap_velocity_y, front_grip_gap_velocity_z = rim_on_plane_gap(fork_rate_x, fork_rate_y, fork_rate_z, front_hub_axis_x, front_hub_axis_y, front_hub_axis_z, front_wheel_z, front_wheel_velocity_x, front_wheel_velocity_y, front_wheel_velocity_z, u[8], c[8])
    return (ca.vertcat(rear_tyre_gap, 0, 0, front_tyre_gap, 0, 0),
        ca.vertcat(rear_grip_gap_velocity_z, rear_grip_gap_velocity_y, rear_grip_gap_velocity_x, front_grip_gap_velocity_z,
            front_grip_gap_velocity_y, front_grip_gap_velocity_x))


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (9,): SPEEDS
        independence (6,): CONSTRAINTS [1]
    """
    rear_wheel_xx, rear_wheel_yy, rear_wheel_zz, front_wheel_xx, front_wheel_zz, rear_radius = c[1], c[2], c[3], c[4], c[6], c[7]
    front_radius, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y, fork_lined_up_z_x = c[8], c[10], c[11], c[12], c[13]
    fork_lined_up_z_z, trail_plus_wheel_base, k2, k3, frame_total_mass = c[14], c[15], c[16], c[17], c[18]
    fork_h_x_times_fork_lined_up_x_x, k5, fork_h_x_times_fork_lined_up_y_y, fork_h_x_times_fork_lined_up_z_x = c[23], c[24], c[25], c[26]
    k8, leaning_h_z, leaning_I_y_y, frame_I_x_x, frame_I_z_z, frame_I_x_z = c[27], c[28], c[29], c[30], c[31], c[33]
    rear_wheel_xx_minus_rear_wheel_zz, fork_I_x_x, fork_I_z_z, fork_I_x_z = c[34], c[35], c[36], c[38]
    front_wheel_xx_minus_front_wheel_zz, front_wheel_turned_J_y_y, fork_total_J_y_y = c[40], c[49], c[50]
    fork_h_z_times_fork_lined_up_x_z, fork_h_z_times_fork_lined_up_z_z, twice_rear_radius, k23 = c[51], c[52], c[53], c[54]
    frame_I_y_y_plus_rear_wheel_yy, k25, k26, inverse_front_wheel_yy, inverse_rear_wheel_yy = c[55], c[56], c[57], c[58], c[59]
    rear_grip_gap_softness, rear_grip_sliding_velocity_1_softness, rear_grip_sliding_velocity_2_softness = c[89], c[90], c[91]
    front_grip_gap_softness, front_grip_sliding_velocity_1_softness, front_grip_sliding_velocity_2_softness = c[92], c[93], c[94]
    path_x, path_y, height_travel, pitch_angle, rear_hub_angle, steer_angle, front_hub_angle = q[0], q[1], q[3], q[5], q[6], q[7], q[8]
    rear_grip_gap_wanted_rate, rear_grip_sliding_velocity_1_wanted_rate = wanted[0], wanted[1]
    rear_grip_sliding_velocity_2_wanted_rate, front_grip_gap_wanted_rate = wanted[2], wanted[3]
    front_grip_sliding_velocity_1_wanted_rate, front_grip_sliding_velocity_2_wanted_rate = wanted[4], wanted[5]
    cos_heading, sin_heading = revolute_constants_terms(q[2])
    cos_leaning, sin_leaning = revolute_constants_terms(q[4])
    cos_frame, sin_frame = revolute_constants_terms(pitch_angle)
    rear_wheel_angle = pitch_angle + rear_hub_angle
    rear_wheel_turn = rear_wheel_angle - pitch_angle
    cos_rear_wheel_turn, sin_rear_wheel_turn = revolute_constants_terms(rear_wheel_turn)
    cos_fork = ca.cos(steer_angle)
    sin_fork = ca.sin(steer_angle)
    cos_front_wheel = ca.cos(front_hub_angle)
    sin_front_wheel = ca.sin(front_hub_angle)
    leaning_R_x_y = -cos_leaning*sin_heading
    leaning_R_x_z = sin_heading*sin_leaning
    leaning_R_y_y = cos_heading*cos_leaning
    leaning_R_y_z = -cos_heading*sin_leaning
    frame_arm_x = leaning_R_x_z*rear_radius
    frame_arm_y = leaning_R_y_z*rear_radius
    frame_arm_z = cos_leaning*rear_radius
    frame_x_2 = frame_arm_x + path_x
    frame_y = frame_arm_y + path_y
    frame_z_2 = frame_arm_z + height_travel
    frame_R_x_x = cos_frame*cos_heading - leaning_R_x_z*sin_frame
    frame_R_x_z = cos_frame*leaning_R_x_z + cos_heading*sin_frame
    frame_R_y_x = cos_frame*sin_heading - leaning_R_y_z*sin_frame
    frame_R_y_z = cos_frame*leaning_R_y_z + sin_frame*sin_heading
    frame_R_z_x = -cos_leaning*sin_frame
    frame_R_z_z = cos_frame*cos_leaning
    rear_tyre_up_x = -leaning_R_x_y*sin_leaning
    rear_tyre_up_y = -leaning_R_y_y*sin_leaning
    rear_tyre_up_z = 1 - sin_leaning*sin_leaning
    rear_tyre_rise = ca.sqrt(rear_tyre_up_z)
    rear_tyre_rim_x = -rear_tyre_up_x*rear_radius/rear_tyre_rise
    rear_tyre_rim_y = -rear_tyre_up_y*rear_radius/rear_tyre_rise
    rear_tyre_rim_z = -rear_tyre_up_z*rear_radius/rear_tyre_rise
    rear_grip_sliding_velocity_1_on_path_angle = frame_x_2 + rear_tyre_rim_x - path_x
    rear_grip_gap_on_lean = cos_heading*(frame_y + rear_tyre_rim_y - path_y) - sin_heading*rear_grip_sliding_velocity_1_on_path_angle
    rear_grip_gap_on_pitch = leaning_R_x_y*rear_tyre_rim_y - leaning_R_y_y*rear_tyre_rim_x
    x2 = frame_z_2 + rear_tyre_rim_z - height_travel
    rear_grip_sliding_velocity_1_on_lean = -cos_heading*x2
    rear_grip_sliding_velocity_1_on_pitch = rear_tyre_rim_x*sin_leaning - leaning_R_x_y*rear_tyre_rim_z
    rear_grip_sliding_velocity_2_on_path_angle = path_y - frame_y - rear_tyre_rim_y
    rear_grip_sliding_velocity_2_on_lean = sin_heading*x2
    rear_grip_sliding_velocity_2_on_pitch = leaning_R_y_y*rear_tyre_rim_z - rear_tyre_rim_y*sin_leaning
    fork_arm_x = frame_R_x_x*trail_plus_wheel_base - frame_R_x_z*rear_radius
    fork_arm_y = frame_R_y_x*trail_plus_wheel_base - frame_R_y_z*rear_radius
    fork_arm_z = frame_R_z_x*trail_plus_wheel_base - frame_R_z_z*rear_radius
    steer_axis_x = fork_lined_up_x_z*frame_R_x_x + fork_lined_up_z_z*frame_R_x_z
    steer_axis_y = fork_lined_up_x_z*frame_R_y_x + fork_lined_up_z_z*frame_R_y_z
    steer_axis_z = fork_lined_up_x_z*frame_R_z_x + fork_lined_up_z_z*frame_R_z_z
    fork_x_2 = fork_arm_x + frame_x_2
    fork_y = fork_arm_y + frame_y
    fork_z_2 = fork_arm_z + frame_z_2
    fork_lined_up_x_x_times_frame_R_x_x = fork_lined_up_x_x*frame_R_x_x
    fork_lined_up_z_x_times_frame_R_x_z = fork_lined_up_z_x*frame_R_x_z
    x5 = fork_lined_up_x_x_times_frame_R_x_x + fork_lined_up_z_x_times_frame_R_x_z
    fork_R_x_x = cos_fork*x5 + fork_lined_up_y_y*leaning_R_x_y*sin_fork
    fork_R_x_y = cos_fork*fork_lined_up_y_y*leaning_R_x_y - sin_fork*x5
    fork_lined_up_x_x_times_frame_R_y_x = fork_lined_up_x_x*frame_R_y_x
    fork_lined_up_z_x_times_frame_R_y_z = fork_lined_up_z_x*frame_R_y_z
    x8 = fork_lined_up_x_x_times_frame_R_y_x + fork_lined_up_z_x_times_frame_R_y_z
    fork_R_y_x = cos_fork*x8 + fork_lined_up_y_y*leaning_R_y_y*sin_fork
    fork_R_y_y = cos_fork*fork_lined_up_y_y*leaning_R_y_y - sin_fork*x8
    fork_lined_up_x_x_times_frame_R_z_x = fork_lined_up_x_x*frame_R_z_x
    fork_lined_up_z_x_times_frame_R_z_z = fork_lined_up_z_x*frame_R_z_z
    x11 = fork_lined_up_z_x_times_frame_R_z_z + fork_lined_up_x_x_times_frame_R_z_x
    fork_R_z_x = cos_fork*x11 + fork_lined_up_y_y*sin_fork*sin_leaning
    fork_R_z_y = cos_fork*fork_lined_up_y_y*sin_leaning - sin_fork*x11
    front_wheel_arm_x = fork_R_x_x*k2 + k3*steer_axis_x
    front_wheel_arm_y = fork_R_y_x*k2 + k3*steer_axis_y
    front_wheel_arm_z = fork_R_z_x*k2 + k3*steer_axis_z
    front_hub_axis_x = fork_R_x_y*fork_lined_up_y_y
    front_hub_axis_y = fork_R_y_y*fork_lined_up_y_y
    front_hub_axis_z = fork_R_z_y*fork_lined_up_y_y
    front_wheel_x = fork_x_2 + front_wheel_arm_x
    front_wheel_y = fork_y + front_wheel_arm_y
    front_wheel_z = fork_z_2 + front_wheel_arm_z
    front_tyre_up_x = -front_hub_axis_x*front_hub_axis_z
    front_tyre_up_y = -front_hub_axis_y*front_hub_axis_z
    front_tyre_up_z = 1 - front_hub_axis_z*front_hub_axis_z
    front_tyre_rise = ca.sqrt(front_tyre_up_z)
    front_tyre_rim_x = -front_tyre_up_x*front_radius/front_tyre_rise
    front_tyre_rim_y = -front_tyre_up_y*front_radius/front_tyre_rise
    front_tyre_rim_z = -front_tyre_up_z*front_radius/front_tyre_rise
    front_grip_sliding_velocity_1_on_path_angle = front_tyre_rim_x + front_wheel_x - path_x
    front_grip_gap_on_lean = cos_heading*(front_tyre_rim_y + front_wheel_y - path_y) - sin_heading*front_grip_sliding_velocity_1_on_path_angle
    x13 = front_tyre_rim_y + front_wheel_y - frame_y
    x14 = front_tyre_rim_x + front_wheel_x - frame_x_2
    front_grip_gap_on_pitch = leaning_R_x_y*x13 - leaning_R_y_y*x14
    front_tyre_rim_y_plus_front_wheel_y_minus_fork_y = front_tyre_rim_y + front_wheel_y - fork_y
    x16 = front_tyre_rim_x + front_wheel_x - fork_x_2
    front_grip_gap_on_steer = steer_axis_x*front_tyre_rim_y_plus_front_wheel_y_minus_fork_y - steer_axis_y*x16
    front_grip_gap_on_front_hub = front_hub_axis_x*front_tyre_rim_y - front_hub_axis_y*front_tyre_rim_x
    x17 = front_tyre_rim_z + front_wheel_z - height_travel
    front_grip_sliding_velocity_1_on_lean = -cos_heading*x17
    x18 = front_tyre_rim_z + front_wheel_z - frame_z_2
    front_grip_sliding_velocity_1_on_pitch = sin_leaning*x14 - leaning_R_x_y*x18
    x19 = front_tyre_rim_z + front_wheel_z - fork_z_2
    front_grip_sliding_velocity_1_on_steer = steer_axis_z*x16 - steer_axis_x*x19
    front_grip_sliding_velocity_1_on_front_hub = front_hub_axis_z*front_tyre_rim_x - front_hub_axis_x*front_tyre_rim_z
    front_grip_sliding_velocity_2_on_path_angle = path_y - front_tyre_rim_y - front_wheel_y
    front_grip_sliding_velocity_2_on_lean = sin_heading*x17
    front_grip_sliding_velocity_2_on_pitch = leaning_R_y_y*x18 - sin_leaning*x13
    front_grip_sliding_velocity_2_on_steer = steer_axis_y*x19 - steer_axis_z*front_tyre_rim_y_plus_front_wheel_y_minus_fork_y
    front_grip_sliding_velocity_2_on_front_hub = front_hub_axis_y*front_tyre_rim_z - front_hub_axis_z*front_tyre_rim_y
    x20 = cos_fork*fork_h_x_times_fork_lined_up_x_x
    frame_total_moment_x = k5 + x20
    frame_total_moment_y = fork_h_x_times_fork_lined_up_y_y*sin_fork
    x21 = cos_fork*fork_h_x_times_fork_lined_up_z_x
    frame_total_moment_z = k8 + x21
    leaning_total_moment_x = cos_frame*frame_total_moment_x + frame_total_moment_z*sin_frame
    cos_frame_times_frame_total_moment_z = cos_frame*frame_total_moment_z
    minus_frame_total_moment_x_times_sin_frame = -frame_total_moment_x*sin_frame
    leaning_total_moment_z = leaning_h_z + cos_frame_times_frame_total_moment_z + minus_frame_total_moment_x_times_sin_frame
    cos_leaning_times_frame_total_moment_y = cos_leaning*frame_total_moment_y
    minus_leaning_total_moment_z_times_sin_leaning = -leaning_total_moment_z*sin_leaning
    lean_leaning_force_z = cos_leaning_times_frame_total_moment_y + minus_leaning_total_moment_z_times_sin_leaning
    lifted_total_moment_x = cos_heading*leaning_total_moment_x - sin_heading*lean_leaning_force_z
    lifted_total_moment_y = cos_heading*lean_leaning_force_z + leaning_total_moment_x*sin_heading
    rear_wheel_J_swing = rear_wheel_xx_minus_rear_wheel_zz*sin_rear_wheel_turn
    rear_wheel_J_x_x = rear_wheel_xx - rear_wheel_J_swing*sin_rear_wheel_turn
    rear_wheel_J_z_z = rear_wheel_J_swing*sin_rear_wheel_turn + rear_wheel_zz
    rear_wheel_J_x_z = -cos_rear_wheel_turn*rear_wheel_J_swing
    front_wheel_turned_J_swing = front_wheel_xx_minus_front_wheel_zz*sin_front_wheel
    front_wheel_turned_J_x_x = front_wheel_xx - front_wheel_turned_J_swing*sin_front_wheel
    front_wheel_turned_J_x_z = -cos_front_wheel*front_wheel_turned_J_swing
    front_wheel_turned_J_z_z = front_wheel_turned_J_swing*sin_front_wheel + front_wheel_zz
    front_wheel_turned_J_half_x_x = fork_lined_up_x_x*front_wheel_turned_J_x_x + fork_lined_up_z_x*front_wheel_turned_J_x_z
    front_wheel_turned_J_half_x_z = fork_lined_up_x_x*front_wheel_turned_J_x_z + fork_lined_up_z_x*front_wheel_turned_J_z_z
    front_wheel_turned_J_half_z_x = fork_lined_up_x_z*front_wheel_turned_J_x_x + fork_lined_up_z_z*front_wheel_turned_J_x_z
    front_wheel_turned_J_half_z_z = fork_lined_up_x_z*front_wheel_turned_J_x_z + fork_lined_up_z_z*front_wheel_turned_J_z_z
    front_wheel_turned_J_x_x_2 = fork_lined_up_x_x*front_wheel_turned_J_half_x_x + fork_lined_up_z_x*front_wheel_turned_J_half_x_z
    fork_total_J_x_x = fork_I_x_x + front_wheel_turned_J_x_x_2
    fork_turned_J_swing = sin_fork*(fork_total_J_y_y - fork_total_J_x_x)
    fork_turned_J_x_x = fork_total_J_x_x + fork_turned_J_swing*sin_fork
    front_wheel_turned_J_x_z_2 = fork_lined_up_x_z*front_wheel_turned_J_half_x_x + fork_lined_up_z_z*front_wheel_turned_J_half_x_z
    fork_total_J_x_z = fork_I_x_z + front_wheel_turned_J_x_z_2
    fork_turned_J_x_z = cos_fork*fork_total_J_x_z
    fork_turned_J_x_y = -cos_fork*fork_turned_J_swing
    fork_turned_J_y_z = fork_total_J_x_z*sin_fork
    front_wheel_turned_J_z_z_2 = fork_lined_up_x_z*front_wheel_turned_J_half_z_x + fork_lined_up_z_z*front_wheel_turned_J_half_z_z
    fork_total_J_z_z = fork_I_z_z + front_wheel_turned_J_z_z_2
    fork_turned_J_half_x_x = fork_lined_up_x_x*fork_turned_J_x_x + fork_lined_up_x_z*fork_turned_J_x_z
    fork_turned_J_half_x_y = fork_lined_up_x_x*fork_turned_J_x_y + fork_lined_up_x_z*fork_turned_J_y_z
    fork_lined_up_x_z_times_fork_total_J_z_z = fork_lined_up_x_z*fork_total_J_z_z
    fork_turned_J_half_x_z = fork_lined_up_x_z_times_fork_total_J_z_z + fork_lined_up_x_x*fork_turned_J_x_z
    fork_turned_J_y_y = fork_total_J_y_y - fork_turned_J_swing*sin_fork
    fork_turned_J_half_y_x = fork_lined_up_y_y*fork_turned_J_x_y
    fork_turned_J_half_y_y = fork_lined_up_y_y*fork_turned_J_y_y
    fork_turned_J_half_y_z = fork_lined_up_y_y*fork_turned_J_y_z
    fork_turned_J_half_z_x = fork_lined_up_z_x*fork_turned_J_x_x + fork_lined_up_z_z*fork_turned_J_x_z
    fork_lined_up_z_z_times_fork_total_J_z_z = fork_lined_up_z_z*fork_total_J_z_z
    fork_turned_J_half_z_z = fork_lined_up_z_z_times_fork_total_J_z_z + fork_lined_up_z_x*fork_turned_J_x_z
    fork_turned_moment_x = fork_h_z_times_fork_lined_up_x_z + x20
    fork_turned_moment_z = fork_h_z_times_fork_lined_up_z_z + x21
    frame_turned_moment_z = cos_frame_times_frame_total_moment_z + minus_frame_total_moment_x_times_sin_frame
    fork_turned_J_x_y_2 = fork_lined_up_y_y*fork_turned_J_half_x_y
    frame_total_J_x_y = fork_turned_J_x_y_2 - frame_total_moment_y*trail_plus_wheel_base
    fork_turned_J_y_z_2 = fork_lined_up_z_x*fork_turned_J_half_y_x + fork_lined_up_z_z*fork_turned_J_half_y_z
    frame_total_J_y_z = fork_turned_J_y_z_2 + frame_total_moment_y*rear_radius
    frame_turned_J_x_y = cos_frame*frame_total_J_x_y + frame_total_J_y_z*sin_frame
    fork_turned_J_x_z_2 = fork_lined_up_z_x*fork_turned_J_half_x_x + fork_lined_up_z_z*fork_turned_J_half_x_z
    frame_total_J_x_z = fork_turned_J_x_z_2 + frame_I_x_z + rear_wheel_J_x_z + fork_turned_moment_x*rear_radius - fork_turned_moment_z*trail_plus_wheel_base
    fork_turned_J_x_x_2 = fork_lined_up_x_x*fork_turned_J_half_x_x + fork_lined_up_x_z*fork_turned_J_half_x_z
    x29 = -fork_turned_moment_z*twice_rear_radius
    frame_total_J_x_x = fork_turned_J_x_x_2 + frame_I_x_x + rear_wheel_J_x_x + x29
    fork_turned_J_z_z = fork_lined_up_z_x*fork_turned_J_half_z_x + fork_lined_up_z_z*fork_turned_J_half_z_z
    x30 = fork_turned_moment_x*k23
    frame_total_J_z_z = fork_turned_J_z_z + frame_I_z_z + rear_wheel_J_z_z + x30
    frame_turned_J_swing = sin_frame*(frame_total_J_x_x - frame_total_J_z_z) - 2*cos_frame*frame_total_J_x_z
    frame_turned_J_x_z = -frame_total_J_x_z - cos_frame*frame_turned_J_swing
    leaning_total_J_x_z = frame_turned_J_x_z - leaning_total_moment_x*rear_radius
    leaning_turned_J_x_z = cos_leaning*leaning_total_J_x_z + frame_turned_J_x_y*sin_leaning
    frame_turned_J_y_z = cos_frame*frame_total_J_y_z - frame_total_J_x_y*sin_frame
    leaning_total_J_y_z = frame_turned_J_y_z - frame_total_moment_y*rear_radius
    frame_turned_J_z_z = frame_total_J_z_z + frame_turned_J_swing*sin_frame
    fork_turned_J_y_y_2 = fork_lined_up_y_y*fork_turned_J_half_y_y
    frame_total_J_y_y = fork_turned_J_y_y_2 + frame_I_y_y_plus_rear_wheel_yy + x29 + x30
    x31 = frame_turned_moment_z*twice_rear_radius
    leaning_total_J_y_y = frame_total_J_y_y + leaning_I_y_y + x31
    leaning_turned_J_swing = sin_leaning*(frame_turned_J_z_z - leaning_total_J_y_y) - 2*cos_leaning*leaning_total_J_y_z
    leaning_turned_J_z_z = frame_turned_J_z_z - leaning_turned_J_swing*sin_leaning
    frame_turned_J_x_x = frame_total_J_x_x - frame_turned_J_swing*sin_frame
    leaning_total_J_x_x = frame_turned_J_x_x + leaning_I_y_y + x31
    minus_cos_leaning_times_leaning_total_moment_z = -cos_leaning*leaning_total_moment_z
    minus_frame_total_moment_y_times_sin_leaning = -frame_total_moment_y*sin_leaning
    x34 = minus_cos_leaning_times_leaning_total_moment_z + minus_frame_total_moment_y_times_sin_leaning
    lean_leaning_force_x = -sin_heading*x34
    lean_leaning_force_y = cos_heading*x34
    pitch_frame_torque_y = frame_total_J_y_y + frame_turned_moment_z*rear_radius
    pitch_leaning_force_x = cos_heading*frame_turned_moment_z - leaning_total_moment_x*sin_heading*sin_leaning
    pitch_leaning_force_y = frame_turned_moment_z*sin_heading + cos_heading*leaning_total_moment_x*sin_leaning
    pitch_leaning_force_z = -cos_leaning*leaning_total_moment_x
    pitch_leaning_torque_z = cos_leaning*frame_turned_J_y_z + pitch_frame_torque_y*sin_leaning
    rear_hub_leaning_torque_z = sin_leaning*rear_wheel_yy
    steer_fork_force_x = -fork_h_x_times_fork_lined_up_x_x*sin_fork
    steer_fork_force_y = cos_fork*fork_h_x_times_fork_lined_up_y_y
    steer_fork_force_z = -fork_h_x_times_fork_lined_up_z_x*sin_fork
    steer_fork_torque_x = fork_lined_up_x_z_times_fork_total_J_z_z + steer_fork_force_y*rear_radius + cos_fork*fork_lined_up_x_x*fork_total_J_x_z
    steer_fork_torque_y = fork_lined_up_y_y*fork_total_J_x_z*sin_fork - trail_plus_wheel_base*steer_fork_force_z - steer_fork_force_x*rear_radius
    steer_fork_torque_z = fork_lined_up_z_z_times_fork_total_J_z_z + trail_plus_wheel_base*steer_fork_force_y + cos_fork*fork_lined_up_z_x*fork_total_J_x_z
    steer_frame_force_x = cos_frame*steer_fork_force_x + sin_frame*steer_fork_force_z
    steer_frame_force_z = cos_frame*steer_fork_force_z - sin_frame*steer_fork_force_x
    steer_frame_torque_x = cos_frame*steer_fork_torque_x + sin_frame*steer_fork_torque_z - steer_fork_force_y*rear_radius
    steer_frame_torque_y = steer_fork_torque_y + steer_frame_force_x*rear_radius
    steer_frame_torque_z = cos_frame*steer_fork_torque_z - sin_frame*steer_fork_torque_x
    cos_leaning_times_steer_fork_force_y = cos_leaning*steer_fork_force_y
    minus_sin_leaning_times_steer_frame_force_z = -sin_leaning*steer_frame_force_z
    x37 = cos_leaning_times_steer_fork_force_y + minus_sin_leaning_times_steer_frame_force_z
    steer_leaning_force_x = cos_heading*steer_frame_force_x - sin_heading*x37
    steer_leaning_force_y = cos_heading*x37 + sin_heading*steer_frame_force_x
    steer_leaning_force_z = cos_leaning*steer_frame_force_z + sin_leaning*steer_fork_force_y
    steer_leaning_torque_z = cos_leaning*steer_frame_torque_z + sin_leaning*steer_frame_torque_y
    front_hub_fork_torque_x = -k25*sin_fork
    front_hub_fork_torque_y = cos_fork*front_wheel_turned_J_y_y
    front_hub_fork_torque_z = -k26*sin_fork
    front_hub_frame_torque_x = cos_frame*front_hub_fork_torque_x + front_hub_fork_torque_z*sin_frame
    front_hub_frame_torque_z = cos_frame*front_hub_fork_torque_z - front_hub_fork_torque_x*sin_frame
    front_hub_leaning_torque_z = cos_leaning*front_hub_frame_torque_z + front_hub_fork_torque_y*sin_leaning
    l_pitch_front_hub = front_hub_fork_torque_y*inverse_front_wheel_yy
    l_pitch_steer = steer_fork_torque_y/fork_total_J_z_z
    D_pitch = frame_total_J_y_y - rear_wheel_yy - front_hub_fork_torque_y*l_pitch_front_hub - l_pitch_steer*steer_fork_torque_y
    l_lean_front_hub = front_hub_frame_torque_x*inverse_front_wheel_yy
    l_lean_steer = steer_frame_torque_x/fork_total_J_z_z
    L_lean_pitch = frame_turned_J_x_y - front_hub_frame_torque_x*l_pitch_front_hub - l_pitch_steer*steer_frame_torque_x
    l_lean_pitch = L_lean_pitch/D_pitch
    D_lean = leaning_total_J_x_x - L_lean_pitch*l_lean_pitch - front_hub_frame_torque_x*l_lean_front_hub - l_lean_steer*steer_frame_torque_x
    l_height_steer = steer_leaning_force_z/fork_total_J_z_z
    L_height_pitch = pitch_leaning_force_z - l_pitch_steer*steer_leaning_force_z
    l_height_pitch = L_height_pitch/D_pitch
    L_height_lean = lean_leaning_force_z - L_height_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_z
    l_height_lean = L_height_lean/D_lean
    D_height = frame_total_mass - L_height_lean*l_height_lean - L_height_pitch*l_height_pitch - l_height_steer*steer_leaning_force_z
    l_path_angle_front_hub = front_hub_leaning_torque_z*inverse_front_wheel_yy
    l_path_angle_steer = steer_leaning_torque_z/fork_total_J_z_z
    l_path_angle_rear_hub = inverse_rear_wheel_yy*rear_hub_leaning_torque_z
    L_path_angle_pitch = pitch_leaning_torque_z - rear_hub_leaning_torque_z - front_hub_leaning_torque_z*l_pitch_front_hub - l_pitch_steer*steer_leaning_torque_z
    L_path_angle_lean = leaning_turned_J_x_z - L_path_angle_pitch*l_lean_pitch - front_hub_leaning_torque_z*l_lean_front_hub - l_lean_steer*steer_leaning_torque_z
    L_path_angle_height = -L_path_angle_lean*l_height_lean - L_path_angle_pitch*l_height_pitch - l_height_steer*steer_leaning_torque_z
    L_path_x_pitch = pitch_leaning_force_x - l_pitch_steer*steer_leaning_force_x
    L_path_y_pitch = pitch_leaning_force_y - l_pitch_steer*steer_leaning_force_y
    l_path_angle_pitch, l_path_y_pitch, l_path_x_pitch = rolling_without_slip_l_gap_gap(L_path_angle_pitch, L_path_y_pitch, L_path_x_pitch, D_pitch)
    L_path_x_lean = lean_leaning_force_x - L_path_x_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_x
    L_path_y_lean = lean_leaning_force_y - L_path_y_pitch*l_lean_pitch - l_lean_steer*steer_leaning_force_y
    l_path_angle_lean, l_path_y_lean, l_path_x_lean = rolling_without_slip_l_gap_gap(L_path_angle_lean, L_path_y_lean, L_path_x_lean, D_lean)
    L_path_x_height = -L_path_x_lean*l_height_lean - L_path_x_pitch*l_height_pitch - l_height_steer*steer_leaning_force_x
    L_path_y_height = -L_path_y_lean*l_height_lean - L_path_y_pitch*l_height_pitch - l_height_steer*steer_leaning_force_y
    l_path_angle_height, l_path_y_height, l_path_x_height = rolling_without_slip_l_gap_gap(L_path_angle_height, L_path_y_height, L_path_x_height, D_height)
    D_path_angle = leaning_turned_J_z_z - L_path_angle_height*l_path_angle_height - L_path_angle_lean*l_path_angle_lean - L_path_angle_pitch*l_path_angle_pitch - front_hub_leaning_torque_z*l_path_angle_front_hub - l_path_angle_rear_hub*rear_hub_leaning_torque_z - l_path_angle_steer*steer_leaning_torque_z
    l_path_y_steer = steer_leaning_force_y/fork_total_J_z_z
    L_path_y_path_angle = lifted_total_moment_x - L_path_y_height*l_path_angle_height - L_path_y_lean*l_path_angle_lean - L_path_y_pitch*l_path_angle_pitch - l_path_angle_steer*steer_leaning_force_y
    l_path_y_path_angle = L_path_y_path_angle/D_path_angle
    D_path_y = frame_total_mass - L_path_y_height*l_path_y_height - L_path_y_lean*l_path_y_lean - L_path_y_path_angle*l_path_y_path_angle - L_path_y_pitch*l_path_y_pitch - l_path_y_steer*steer_leaning_force_y
    l_path_x_steer = steer_leaning_force_x/fork_total_J_z_z
    L_path_x_path_angle = -lifted_total_moment_y - L_path_x_height*l_path_angle_height - L_path_x_lean*l_path_angle_lean - L_path_x_pitch*l_path_angle_pitch - l_path_angle_steer*steer_leaning_force_x
    l_path_x_path_angle = L_path_x_path_angle/D_path_angle
    L_path_x_path_y = -L_path_x_height*l_path_y_height - L_path_x_lean*l_path_y_lean - L_path_x_path_angle*l_path_y_path_angle - L_path_x_pitch*l_path_y_pitch - l_path_y_steer*steer_leaning_force_x
    l_path_x_path_y = L_path_x_path_y/D_path_y
    D_path_x = frame_total_mass - L_path_x_height*l_path_x_height - L_path_x_lean*l_path_x_lean - L_path_x_path_angle*l_path_x_path_angle - L_path_x_path_y*l_path_x_path_y - L_path_x_pitch*l_path_x_pitch - l_path_x_steer*steer_leaning_force_x
    y_height_2 = 1 - l_height_lean*rear_grip_gap_on_lean
    y_path_angle_2 = -l_path_angle_height*y_height_2 - l_path_angle_lean*rear_grip_gap_on_lean - l_path_angle_rear_hub*rear_grip_gap_on_pitch
    y_path_y_2 = -l_path_y_height*y_height_2 - l_path_y_lean*rear_grip_gap_on_lean - l_path_y_path_angle*y_path_angle_2
    y_path_x_2 = -l_path_x_height*y_height_2 - l_path_x_lean*rear_grip_gap_on_lean - l_path_x_path_angle*y_path_angle_2 - l_path_x_path_y*y_path_y_2
    y_height_4 = -l_height_lean*rear_grip_sliding_velocity_2_on_lean
    y_path_angle_4 = rear_grip_sliding_velocity_2_on_path_angle - l_path_angle_height*y_height_4 - l_path_angle_lean*rear_grip_sliding_velocity_2_on_lean - l_path_angle_rear_hub*rear_grip_sliding_velocity_2_on_pitch
    y_path_y_4 = -l_path_y_height*y_height_4 - l_path_y_lean*rear_grip_sliding_velocity_2_on_lean - l_path_y_path_angle*y_path_angle_4
    y_path_x_4 = 1 - l_path_x_height*y_height_4 - l_path_x_lean*rear_grip_sliding_velocity_2_on_lean - l_path_x_path_angle*y_path_angle_4 - l_path_x_path_y*y_path_y_4
    y_height_3 = -l_height_lean*rear_grip_sliding_velocity_1_on_lean
    y_path_angle_3 = rear_grip_sliding_velocity_1_on_path_angle - l_path_angle_height*y_height_3 - l_path_angle_lean*rear_grip_sliding_velocity_1_on_lean - l_path_angle_rear_hub*rear_grip_sliding_velocity_1_on_pitch
    y_path_y_3 = 1 - l_path_y_height*y_height_3 - l_path_y_lean*rear_grip_sliding_velocity_1_on_lean - l_path_y_path_angle*y_path_angle_3
    y_path_x_3 = -l_path_x_height*y_height_3 - l_path_x_lean*rear_grip_sliding_velocity_1_on_lean - l_path_x_path_angle*y_path_angle_3 - l_path_x_path_y*y_path_y_3
    path_x_by_rear_grip_gap, path_x_by_rear_grip_sliding_velocity_1, path_x_by_rear_grip_sliding_velocity_2 = rolling_without_slip_l_gap_gap(y_path_x_2, y_path_x_3, y_path_x_4, D_path_x)
    path_y_by_rear_grip_gap = y_path_y_2/D_path_y - l_path_x_path_y*path_x_by_rear_grip_gap
    path_angle_by_rear_grip_gap = y_path_angle_2/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_gap - l_path_y_path_angle*path_y_by_rear_grip_gap
    height_by_rear_grip_gap = y_height_2/D_height - l_path_angle_height*path_angle_by_rear_grip_gap - l_path_x_height*path_x_by_rear_grip_gap - l_path_y_height*path_y_by_rear_grip_gap
    lean_by_rear_grip_gap = rear_grip_gap_on_lean/D_lean - height_by_rear_grip_gap*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_gap - l_path_x_lean*path_x_by_rear_grip_gap - l_path_y_lean*path_y_by_rear_grip_gap
    pitch_by_rear_grip_gap = -height_by_rear_grip_gap*l_height_pitch - l_lean_pitch*lean_by_rear_grip_gap - l_path_angle_pitch*path_angle_by_rear_grip_gap - l_path_x_pitch*path_x_by_rear_grip_gap - l_path_y_pitch*path_y_by_rear_grip_gap
    rear_hub_by_rear_grip_gap = inverse_rear_wheel_yy*rear_grip_gap_on_pitch - pitch_by_rear_grip_gap - l_path_angle_rear_hub*path_angle_by_rear_grip_gap
    steer_by_rear_grip_gap = -height_by_rear_grip_gap*l_height_steer - l_lean_steer*lean_by_rear_grip_gap - l_path_angle_steer*path_angle_by_rear_grip_gap - l_path_x_steer*path_x_by_rear_grip_gap - l_path_y_steer*path_y_by_rear_grip_gap - l_pitch_steer*pitch_by_rear_grip_gap
    front_hub_by_rear_grip_gap = -l_lean_front_hub*lean_by_rear_grip_gap - l_path_angle_front_hub*path_angle_by_rear_grip_gap - l_pitch_front_hub*pitch_by_rear_grip_gap
    path_y_by_rear_grip_sliding_velocity_1 = y_path_y_3/D_path_y - l_path_x_path_y*path_x_by_rear_grip_sliding_velocity_1
    path_angle_by_rear_grip_sliding_velocity_1 = y_path_angle_3/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_path_angle*path_y_by_rear_grip_sliding_velocity_1
    height_by_rear_grip_sliding_velocity_1 = y_height_3/D_height - l_path_angle_height*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_height*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_height*path_y_by_rear_grip_sliding_velocity_1
    lean_by_rear_grip_sliding_velocity_1 = rear_grip_sliding_velocity_1_on_lean/D_lean - height_by_rear_grip_sliding_velocity_1*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_lean*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_lean*path_y_by_rear_grip_sliding_velocity_1
    pitch_by_rear_grip_sliding_velocity_1 = -height_by_rear_grip_sliding_velocity_1*l_height_pitch - l_lean_pitch*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_pitch*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_pitch*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_pitch*path_y_by_rear_grip_sliding_velocity_1
    rear_hub_by_rear_grip_sliding_velocity_1 = inverse_rear_wheel_yy*rear_grip_sliding_velocity_1_on_pitch - pitch_by_rear_grip_sliding_velocity_1 - l_path_angle_rear_hub*path_angle_by_rear_grip_sliding_velocity_1
    steer_by_rear_grip_sliding_velocity_1 = -height_by_rear_grip_sliding_velocity_1*l_height_steer - l_lean_steer*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_steer*path_angle_by_rear_grip_sliding_velocity_1 - l_path_x_steer*path_x_by_rear_grip_sliding_velocity_1 - l_path_y_steer*path_y_by_rear_grip_sliding_velocity_1 - l_pitch_steer*pitch_by_rear_grip_sliding_velocity_1
    front_hub_by_rear_grip_sliding_velocity_1 = -l_lean_front_hub*lean_by_rear_grip_sliding_velocity_1 - l_path_angle_front_hub*path_angle_by_rear_grip_sliding_velocity_1 - l_pitch_front_hub*pitch_by_rear_grip_sliding_velocity_1
    path_y_by_rear_grip_sliding_velocity_2 = y_path_y_4/D_path_y - l_path_x_path_y*path_x_by_rear_grip_sliding_velocity_2
    path_angle_by_rear_grip_sliding_velocity_2 = y_path_angle_4/D_path_angle - l_path_x_path_angle*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_path_angle*path_y_by_rear_grip_sliding_velocity_2
    height_by_rear_grip_sliding_velocity_2 = y_height_4/D_height - l_path_angle_height*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_height*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_height*path_y_by_rear_grip_sliding_velocity_2
    lean_by_rear_grip_sliding_velocity_2 = rear_grip_sliding_velocity_2_on_lean/D_lean - height_by_rear_grip_sliding_velocity_2*l_height_lean - l_path_angle_lean*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_lean*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_lean*path_y_by_rear_grip_sliding_velocity_2
    pitch_by_rear_grip_sliding_velocity_2 = -height_by_rear_grip_sliding_velocity_2*l_height_pitch - l_lean_pitch*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_pitch*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_pitch*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_pitch*path_y_by_rear_grip_sliding_velocity_2
    rear_hub_by_rear_grip_sliding_velocity_2 = inverse_rear_wheel_yy*rear_grip_sliding_velocity_2_on_pitch - pitch_by_rear_grip_sliding_velocity_2 - l_path_angle_rear_hub*path_angle_by_rear_grip_sliding_velocity_2
    steer_by_rear_grip_sliding_velocity_2 = -height_by_rear_grip_sliding_velocity_2*l_height_steer - l_lean_steer*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_steer*path_angle_by_rear_grip_sliding_velocity_2 - l_path_x_steer*path_x_by_rear_grip_sliding_velocity_2 - l_path_y_steer*path_y_by_rear_grip_sliding_velocity_2 - l_pitch_steer*pitch_by_rear_grip_sliding_velocity_2
    front_hub_by_rear_grip_sliding_velocity_2 = -l_lean_front_hub*lean_by_rear_grip_sliding_velocity_2 - l_path_angle_front_hub*path_angle_by_rear_grip_sliding_velocity_2 - l_pitch_front_hub*pitch_by_rear_grip_sliding_velocity_2
    y_pitch_2 = front_grip_gap_on_pitch - front_grip_gap_on_front_hub*l_pitch_front_hub - front_grip_gap_on_steer*l_pitch_steer
    y_lean_2 = front_grip_gap_on_lean - front_grip_gap_on_front_hub*l_lean_front_hub - front_grip_gap_on_steer*l_lean_steer - l_lean_pitch*y_pitch_2
    y_height_5 = 1 - front_grip_gap_on_steer*l_height_steer - l_height_lean*y_lean_2 - l_height_pitch*y_pitch_2
    y_path_angle_5 = -front_grip_gap_on_front_hub*l_path_angle_front_hub - front_grip_gap_on_steer*l_path_angle_steer - l_path_angle_height*y_height_5 - l_path_angle_lean*y_lean_2 - l_path_angle_pitch*y_pitch_2
    y_path_y_5 = -front_grip_gap_on_steer*l_path_y_steer - l_path_y_height*y_height_5 - l_path_y_lean*y_lean_2 - l_path_y_path_angle*y_path_angle_5 - l_path_y_pitch*y_pitch_2
    y_path_x_5 = -front_grip_gap_on_steer*l_path_x_steer - l_path_x_height*y_height_5 - l_path_x_lean*y_lean_2 - l_path_x_path_angle*y_path_angle_5 - l_path_x_path_y*y_path_y_5 - l_path_x_pitch*y_pitch_2
    path_x_by_front_grip_gap = y_path_x_5/D_path_x
    path_y_by_front_grip_gap = y_path_y_5/D_path_y - l_path_x_path_y*path_x_by_front_grip_gap
    path_angle_by_front_grip_gap = y_path_angle_5/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_gap - l_path_y_path_angle*path_y_by_front_grip_gap
    height_by_front_grip_gap = y_height_5/D_height - l_path_angle_height*path_angle_by_front_grip_gap - l_path_x_height*path_x_by_front_grip_gap - l_path_y_height*path_y_by_front_grip_gap
    lean_by_front_grip_gap = y_lean_2/D_lean - height_by_front_grip_gap*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_gap - l_path_x_lean*path_x_by_front_grip_gap - l_path_y_lean*path_y_by_front_grip_gap
    pitch_by_front_grip_gap = y_pitch_2/D_pitch - height_by_front_grip_gap*l_height_pitch - l_lean_pitch*lean_by_front_grip_gap - l_path_angle_pitch*path_angle_by_front_grip_gap - l_path_x_pitch*path_x_by_front_grip_gap - l_path_y_pitch*path_y_by_front_grip_gap
    rear_hub_by_front_grip_gap = -pitch_by_front_grip_gap - l_path_angle_rear_hub*path_angle_by_front_grip_gap
    steer_by_front_grip_gap = front_grip_gap_on_steer/fork_total_J_z_z - height_by_front_grip_gap*l_height_steer - l_lean_steer*lean_by_front_grip_gap - l_path_angle_steer*path_angle_by_front_grip_gap - l_path_x_steer*path_x_by_front_grip_gap - l_path_y_steer*path_y_by_front_grip_gap - l_pitch_steer*pitch_by_front_grip_gap
    front_hub_by_front_grip_gap = front_grip_gap_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_gap - l_path_angle_front_hub*path_angle_by_front_grip_gap - l_pitch_front_hub*pitch_by_front_grip_gap
    y_pitch_3 = front_grip_sliding_velocity_1_on_pitch - front_grip_sliding_velocity_1_on_front_hub*l_pitch_front_hub - front_grip_sliding_velocity_1_on_steer*l_pitch_steer
    y_lean_3 = front_grip_sliding_velocity_1_on_lean - front_grip_sliding_velocity_1_on_front_hub*l_lean_front_hub - front_grip_sliding_velocity_1_on_steer*l_lean_steer - l_lean_pitch*y_pitch_3
    y_height_6 = -front_grip_sliding_velocity_1_on_steer*l_height_steer - l_height_lean*y_lean_3 - l_height_pitch*y_pitch_3
    y_path_angle_6 = front_grip_sliding_velocity_1_on_path_angle - front_grip_sliding_velocity_1_on_front_hub*l_path_angle_front_hub - front_grip_sliding_velocity_1_on_steer*l_path_angle_steer - l_path_angle_height*y_height_6 - l_path_angle_lean*y_lean_3 - l_path_angle_pitch*y_pitch_3
    y_path_y_6 = 1 - front_grip_sliding_velocity_1_on_steer*l_path_y_steer - l_path_y_height*y_height_6 - l_path_y_lean*y_lean_3 - l_path_y_path_angle*y_path_angle_6 - l_path_y_pitch*y_pitch_3
    y_path_x_6 = -front_grip_sliding_velocity_1_on_steer*l_path_x_steer - l_path_x_height*y_height_6 - l_path_x_lean*y_lean_3 - l_path_x_path_angle*y_path_angle_6 - l_path_x_path_y*y_path_y_6 - l_path_x_pitch*y_pitch_3
    path_x_by_front_grip_sliding_velocity_1 = y_path_x_6/D_path_x
    path_y_by_front_grip_sliding_velocity_1 = y_path_y_6/D_path_y - l_path_x_path_y*path_x_by_front_grip_sliding_velocity_1
    path_angle_by_front_grip_sliding_velocity_1 = y_path_angle_6/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_sliding_velocity_1 - l_path_y_path_angle*path_y_by_front_grip_sliding_velocity_1
    height_by_front_grip_sliding_velocity_1 = y_height_6/D_height - l_path_angle_height*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_height*path_x_by_front_grip_sliding_velocity_1 - l_path_y_height*path_y_by_front_grip_sliding_velocity_1
    lean_by_front_grip_sliding_velocity_1 = y_lean_3/D_lean - height_by_front_grip_sliding_velocity_1*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_lean*path_x_by_front_grip_sliding_velocity_1 - l_path_y_lean*path_y_by_front_grip_sliding_velocity_1
    pitch_by_front_grip_sliding_velocity_1 = y_pitch_3/D_pitch - height_by_front_grip_sliding_velocity_1*l_height_pitch - l_lean_pitch*lean_by_front_grip_sliding_velocity_1 - l_path_angle_pitch*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_pitch*path_x_by_front_grip_sliding_velocity_1 - l_path_y_pitch*path_y_by_front_grip_sliding_velocity_1
    rear_hub_by_front_grip_sliding_velocity_1 = -pitch_by_front_grip_sliding_velocity_1 - l_path_angle_rear_hub*path_angle_by_front_grip_sliding_velocity_1
    steer_by_front_grip_sliding_velocity_1 = front_grip_sliding_velocity_1_on_steer/fork_total_J_z_z - height_by_front_grip_sliding_velocity_1*l_height_steer - l_lean_steer*lean_by_front_grip_sliding_velocity_1 - l_path_angle_steer*path_angle_by_front_grip_sliding_velocity_1 - l_path_x_steer*path_x_by_front_grip_sliding_velocity_1 - l_path_y_steer*path_y_by_front_grip_sliding_velocity_1 - l_pitch_steer*pitch_by_front_grip_sliding_velocity_1
    front_hub_by_front_grip_sliding_velocity_1 = front_grip_sliding_velocity_1_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_sliding_velocity_1 - l_path_angle_front_hub*path_angle_by_front_grip_sliding_velocity_1 - l_pitch_front_hub*pitch_by_front_grip_sliding_velocity_1
    y_pitch_4 = front_grip_sliding_velocity_2_on_pitch - front_grip_sliding_velocity_2_on_front_hub*l_pitch_front_hub - front_grip_sliding_velocity_2_on_steer*l_pitch_steer
    y_lean_4 = front_grip_sliding_velocity_2_on_lean - front_grip_sliding_velocity_2_on_front_hub*l_lean_front_hub - front_grip_sliding_velocity_2_on_steer*l_lean_steer - l_lean_pitch*y_pitch_4
    y_height_7 = -front_grip_sliding_velocity_2_on_steer*l_height_steer - l_height_lean*y_lean_4 - l_height_pitch*y_pitch_4
    y_path_angle_7 = front_grip_sliding_velocity_2_on_path_angle - front_grip_sliding_velocity_2_on_front_hub*l_path_angle_front_hub - front_grip_sliding_velocity_2_on_steer*l_path_angle_steer - l_path_angle_height*y_height_7 - l_path_angle_lean*y_lean_4 - l_path_angle_pitch*y_pitch_4
    y_path_y_7 = -front_grip_sliding_velocity_2_on_steer*l_path_y_steer - l_path_y_height*y_height_7 - l_path_y_lean*y_lean_4 - l_path_y_path_angle*y_path_angle_7 - l_path_y_pitch*y_pitch_4
    y_path_x_7 = 1 - front_grip_sliding_velocity_2_on_steer*l_path_x_steer - l_path_x_height*y_height_7 - l_path_x_lean*y_lean_4 - l_path_x_path_angle*y_path_angle_7 - l_path_x_path_y*y_path_y_7 - l_path_x_pitch*y_pitch_4
    path_x_by_front_grip_sliding_velocity_2 = y_path_x_7/D_path_x
    path_y_by_front_grip_sliding_velocity_2 = y_path_y_7/D_path_y - l_path_x_path_y*path_x_by_front_grip_sliding_velocity_2
    path_angle_by_front_grip_sliding_velocity_2 = y_path_angle_7/D_path_angle - l_path_x_path_angle*path_x_by_front_grip_sliding_velocity_2 - l_path_y_path_angle*path_y_by_front_grip_sliding_velocity_2
    height_by_front_grip_sliding_velocity_2 = y_height_7/D_height - l_path_angle_height*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_height*path_x_by_front_grip_sliding_velocity_2 - l_path_y_height*path_y_by_front_grip_sliding_velocity_2
    lean_by_front_grip_sliding_velocity_2 = y_lean_4/D_lean - height_by_front_grip_sliding_velocity_2*l_height_lean - l_path_angle_lean*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_lean*path_x_by_front_grip_sliding_velocity_2 - l_path_y_lean*path_y_by_front_grip_sliding_velocity_2
    pitch_by_front_grip_sliding_velocity_2 = y_pitch_4/D_pitch - height_by_front_grip_sliding_velocity_2*l_height_pitch - l_lean_pitch*lean_by_front_grip_sliding_velocity_2 - l_path_angle_pitch*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_pitch*path_x_by_front_grip_sliding_velocity_2 - l_path_y_pitch*path_y_by_front_grip_sliding_velocity_2
    rear_hub_by_front_grip_sliding_velocity_2 = -pitch_by_front_grip_sliding_velocity_2 - l_path_angle_rear_hub*path_angle_by_front_grip_sliding_velocity_2
    steer_by_front_grip_sliding_velocity_2 = front_grip_sliding_velocity_2_on_steer/fork_total_J_z_z - height_by_front_grip_sliding_velocity_2*l_height_steer - l_lean_steer*lean_by_front_grip_sliding_velocity_2 - l_path_angle_steer*path_angle_by_front_grip_sliding_velocity_2 - l_path_x_steer*path_x_by_front_grip_sliding_velocity_2 - l_path_y_steer*path_y_by_front_grip_sliding_velocity_2 - l_pitch_steer*pitch_by_front_grip_sliding_velocity_2
    front_hub_by_front_grip_sliding_velocity_2 = front_grip_sliding_velocity_2_on_front_hub*inverse_front_wheel_yy - l_lean_front_hub*lean_by_front_grip_sliding_velocity_2 - l_path_angle_front_hub*path_angle_by_front_grip_sliding_velocity_2 - l_pitch_front_hub*pitch_by_front_grip_sliding_velocity_2
    W_rear_grip_gap_rear_grip_gap = height_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_gap_on_lean + pitch_by_rear_grip_gap*rear_grip_gap_on_pitch + rear_grip_gap_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_1_rear_grip_gap = path_y_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_lean + path_angle_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_path_angle + pitch_by_rear_grip_gap*rear_grip_sliding_velocity_1_on_pitch + rear_grip_sliding_velocity_1_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = path_y_by_rear_grip_sliding_velocity_1 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_lean + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_path_angle + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_on_pitch + rear_grip_sliding_velocity_1_on_pitch*rear_hub_by_rear_grip_sliding_velocity_1
    W_rear_grip_sliding_velocity_2_rear_grip_gap = path_x_by_rear_grip_gap + lean_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_gap*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_gap
    W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = path_x_by_rear_grip_sliding_velocity_1 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_sliding_velocity_1
    W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = path_x_by_rear_grip_sliding_velocity_2 + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_lean + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_path_angle + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_on_pitch + rear_grip_sliding_velocity_2_on_pitch*rear_hub_by_rear_grip_sliding_velocity_2
    W_front_grip_gap_rear_grip_gap = height_by_rear_grip_gap + front_grip_gap_on_front_hub*front_hub_by_rear_grip_gap + front_grip_gap_on_lean*lean_by_rear_grip_gap + front_grip_gap_on_pitch*pitch_by_rear_grip_gap + front_grip_gap_on_steer*steer_by_rear_grip_gap
    W_front_grip_gap_rear_grip_sliding_velocity_1 = height_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_gap_on_steer*steer_by_rear_grip_sliding_velocity_1
    W_front_grip_gap_rear_grip_sliding_velocity_2 = height_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_gap_on_steer*steer_by_rear_grip_sliding_velocity_2
    W_front_grip_gap_front_grip_gap = height_by_front_grip_gap + front_grip_gap_on_front_hub*front_hub_by_front_grip_gap + front_grip_gap_on_lean*lean_by_front_grip_gap + front_grip_gap_on_pitch*pitch_by_front_grip_gap + front_grip_gap_on_steer*steer_by_front_grip_gap
    W_front_grip_sliding_velocity_1_rear_grip_gap = path_y_by_rear_grip_gap + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_gap + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_gap + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_gap + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_gap + path_angle_by_rear_grip_gap*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = path_y_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_sliding_velocity_1 + path_angle_by_rear_grip_sliding_velocity_1*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 = path_y_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_1_on_steer*steer_by_rear_grip_sliding_velocity_2 + path_angle_by_rear_grip_sliding_velocity_2*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_front_grip_gap = path_y_by_front_grip_gap + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_on_lean*lean_by_front_grip_gap + front_grip_sliding_velocity_1_on_pitch*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_on_steer*steer_by_front_grip_gap + path_angle_by_front_grip_gap*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1 = path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_front_hub*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_lean*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_pitch*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_1_on_steer*steer_by_front_grip_sliding_velocity_1 + path_angle_by_front_grip_sliding_velocity_1*front_grip_sliding_velocity_1_on_path_angle
    W_front_grip_sliding_velocity_2_rear_grip_gap = path_x_by_rear_grip_gap + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_gap + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_gap + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_gap + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_gap + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_gap
    W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = path_x_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_sliding_velocity_1
    W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = path_x_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_lean*lean_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_pitch*pitch_by_rear_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_steer*steer_by_rear_grip_sliding_velocity_2
    W_front_grip_sliding_velocity_2_front_grip_gap = path_x_by_front_grip_gap + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_gap + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_gap + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_gap + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_gap + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_gap
    W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_sliding_velocity_1
    W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2 = path_x_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_front_hub*front_hub_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_lean*lean_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_path_angle*path_angle_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_pitch*pitch_by_front_grip_sliding_velocity_2 + front_grip_sliding_velocity_2_on_steer*steer_by_front_grip_sliding_velocity_2
    W_rear_grip_gap_raised = W_rear_grip_gap_rear_grip_gap + W_rear_grip_gap_rear_grip_gap*rear_grip_gap_softness
    W_rear_grip_sliding_velocity_1_raised = W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 + W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_softness
    W_rear_grip_sliding_velocity_2_raised = W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 + W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_softness
    W_front_grip_gap_raised = W_front_grip_gap_front_grip_gap + W_front_grip_gap_front_grip_gap*front_grip_gap_softness
    W_front_grip_sliding_velocity_1_raised = W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1 + W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1*front_grip_sliding_velocity_1_softness
    W_front_grip_sliding_velocity_2_raised = W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2 + W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2*front_grip_sliding_velocity_2_softness
    l_rear_grip_sliding_velocity_1_rear_grip_gap = W_rear_grip_sliding_velocity_1_rear_grip_gap/W_rear_grip_gap_raised
    D_rear_grip_sliding_velocity_1 = W_rear_grip_sliding_velocity_1_raised - W_rear_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_rear_grip_sliding_velocity_2_rear_grip_gap = W_rear_grip_sliding_velocity_2_rear_grip_gap/W_rear_grip_gap_raised
    L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_rear_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1
    D_rear_grip_sliding_velocity_2 = W_rear_grip_sliding_velocity_2_raised - L_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_rear_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_gap_rear_grip_gap = W_front_grip_gap_rear_grip_gap/W_rear_grip_gap_raised
    L_front_grip_gap_rear_grip_sliding_velocity_1 = W_front_grip_gap_rear_grip_sliding_velocity_1 - W_front_grip_gap_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_gap_rear_grip_sliding_velocity_1 = L_front_grip_gap_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1
    L_front_grip_gap_rear_grip_sliding_velocity_2 = W_front_grip_gap_rear_grip_sliding_velocity_2 - L_front_grip_gap_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_gap_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_gap_rear_grip_sliding_velocity_2 = L_front_grip_gap_rear_grip_sliding_velocity_2/D_rear_grip_sliding_velocity_2
    D_front_grip_gap = W_front_grip_gap_raised - L_front_grip_gap_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_gap_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_gap_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    l_front_grip_sliding_velocity_1_rear_grip_gap = W_front_grip_sliding_velocity_1_rear_grip_gap/W_rear_grip_gap_raised
    L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 = L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1
    L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 = L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2/D_rear_grip_sliding_velocity_2
    L_front_grip_sliding_velocity_1_front_grip_gap = W_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    l_front_grip_sliding_velocity_1_front_grip_gap = L_front_grip_sliding_velocity_1_front_grip_gap/D_front_grip_gap
    D_front_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_1_raised - L_front_grip_sliding_velocity_1_front_grip_gap*l_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_1_rear_grip_gap*l_front_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_sliding_velocity_2_rear_grip_gap = W_front_grip_sliding_velocity_2_rear_grip_gap/W_rear_grip_gap_raised
    L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 = L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1/D_rear_grip_sliding_velocity_1
    L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_rear_grip_sliding_velocity_2_rear_grip_gap
    l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 = L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2/D_rear_grip_sliding_velocity_2
    L_front_grip_sliding_velocity_2_front_grip_gap = W_front_grip_sliding_velocity_2_front_grip_gap - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_gap_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_gap_rear_grip_gap
    l_front_grip_sliding_velocity_2_front_grip_gap = L_front_grip_sliding_velocity_2_front_grip_gap/D_front_grip_gap
    L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_front_grip_gap*l_front_grip_sliding_velocity_1_front_grip_gap - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_sliding_velocity_1_rear_grip_gap
    l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 = L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1/D_front_grip_sliding_velocity_1
    D_front_grip_sliding_velocity_2 = W_front_grip_sliding_velocity_2_raised - L_front_grip_sliding_velocity_2_front_grip_gap*l_front_grip_sliding_velocity_2_front_grip_gap - L_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - L_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2 - W_front_grip_sliding_velocity_2_rear_grip_gap*l_front_grip_sliding_velocity_2_rear_grip_gap
    y_rear_grip_sliding_velocity_7 = rear_grip_sliding_velocity_1_wanted_rate - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_wanted_rate
    y_rear_grip_sliding_velocity_8 = rear_grip_sliding_velocity_2_wanted_rate - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_wanted_rate - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_7
    y_front_grip_gap_4 = front_grip_gap_wanted_rate - l_front_grip_gap_rear_grip_gap*rear_grip_gap_wanted_rate - l_front_grip_gap_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_7 - l_front_grip_gap_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_8
    y_front_grip_sliding_velocity_7 = front_grip_sliding_velocity_1_wanted_rate - l_front_grip_sliding_velocity_1_front_grip_gap*y_front_grip_gap_4 - l_front_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_wanted_rate - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_7 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_8
    y_front_grip_sliding_velocity_8 = front_grip_sliding_velocity_2_wanted_rate - l_front_grip_sliding_velocity_2_front_grip_gap*y_front_grip_gap_4 - l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*y_front_grip_sliding_velocity_7 - l_front_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_wanted_rate - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_7 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_8
    front_grip_sliding_velocity_2_push = y_front_grip_sliding_velocity_8/D_front_grip_sliding_velocity_2
    front_grip_sliding_velocity_1_push = y_front_grip_sliding_velocity_7/D_front_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_push*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1
    front_grip_gap_push = y_front_grip_gap_4/D_front_grip_gap - front_grip_sliding_velocity_1_push*l_front_grip_sliding_velocity_1_front_grip_gap - front_grip_sliding_velocity_2_push*l_front_grip_sliding_velocity_2_front_grip_gap
    rear_grip_sliding_velocity_2_push = y_rear_grip_sliding_velocity_8/D_rear_grip_sliding_velocity_2 - front_grip_gap_push*l_front_grip_gap_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_1_push*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_2_push*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    rear_grip_sliding_velocity_1_push = y_rear_grip_sliding_velocity_7/D_rear_grip_sliding_velocity_1 - front_grip_gap_push*l_front_grip_gap_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_1_push*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_push*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_push
    rear_grip_gap_push = rear_grip_gap_wanted_rate/W_rear_grip_gap_raised - front_grip_gap_push*l_front_grip_gap_rear_grip_gap - front_grip_sliding_velocity_1_push*l_front_grip_sliding_velocity_1_rear_grip_gap - front_grip_sliding_velocity_2_push*l_front_grip_sliding_velocity_2_rear_grip_gap - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_sliding_velocity_1_push - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_sliding_velocity_2_push
    front_hub_push = front_grip_gap_push*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_push*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*front_hub_by_front_grip_sliding_velocity_2 + front_hub_by_rear_grip_gap*rear_grip_gap_push + front_hub_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + front_hub_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    steer_push = front_grip_gap_push*steer_by_front_grip_gap + front_grip_sliding_velocity_1_push*steer_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*steer_by_front_grip_sliding_velocity_2 + rear_grip_gap_push*steer_by_rear_grip_gap + rear_grip_sliding_velocity_1_push*steer_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_push*steer_by_rear_grip_sliding_velocity_2
    rear_hub_push = front_grip_gap_push*rear_hub_by_front_grip_gap + front_grip_sliding_velocity_1_push*rear_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*rear_hub_by_front_grip_sliding_velocity_2 + rear_grip_gap_push*rear_hub_by_rear_grip_gap + rear_grip_sliding_velocity_1_push*rear_hub_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_push*rear_hub_by_rear_grip_sliding_velocity_2
    pitch_push = front_grip_gap_push*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_push*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*pitch_by_front_grip_sliding_velocity_2 + pitch_by_rear_grip_gap*rear_grip_gap_push + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    lean_push = front_grip_gap_push*lean_by_front_grip_gap + front_grip_sliding_velocity_1_push*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*lean_by_front_grip_sliding_velocity_2 + lean_by_rear_grip_gap*rear_grip_gap_push + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    height_push = front_grip_gap_push*height_by_front_grip_gap + front_grip_sliding_velocity_1_push*height_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*height_by_front_grip_sliding_velocity_2 + height_by_rear_grip_gap*rear_grip_gap_push + height_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + height_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    path_angle_push = front_grip_gap_push*path_angle_by_front_grip_gap + front_grip_sliding_velocity_1_push*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*path_angle_by_front_grip_sliding_velocity_2 + path_angle_by_rear_grip_gap*rear_grip_gap_push + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    path_y_push = front_grip_gap_push*path_y_by_front_grip_gap + front_grip_sliding_velocity_1_push*path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*path_y_by_front_grip_sliding_velocity_2 + path_y_by_rear_grip_gap*rear_grip_gap_push + path_y_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + path_y_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    path_x_push = front_grip_gap_push*path_x_by_front_grip_gap + front_grip_sliding_velocity_1_push*path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push*path_x_by_front_grip_sliding_velocity_2 + path_x_by_rear_grip_gap*rear_grip_gap_push + path_x_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push + path_x_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push
    rear_grip_gap_left_4 = rear_grip_gap_wanted_rate - height_push - lean_push*rear_grip_gap_on_lean - pitch_push*rear_grip_gap_on_pitch - rear_grip_gap_on_pitch*rear_hub_push
    rear_grip_sliding_velocity_1_left_4 = rear_grip_sliding_velocity_1_wanted_rate - path_y_push - lean_push*rear_grip_sliding_velocity_1_on_lean - path_angle_push*rear_grip_sliding_velocity_1_on_path_angle - pitch_push*rear_grip_sliding_velocity_1_on_pitch - rear_grip_sliding_velocity_1_on_pitch*rear_hub_push
    rear_grip_sliding_velocity_2_left_4 = rear_grip_sliding_velocity_2_wanted_rate - path_x_push - lean_push*rear_grip_sliding_velocity_2_on_lean - path_angle_push*rear_grip_sliding_velocity_2_on_path_angle - pitch_push*rear_grip_sliding_velocity_2_on_pitch - rear_grip_sliding_velocity_2_on_pitch*rear_hub_push
    front_grip_gap_left_4 = front_grip_gap_wanted_rate - height_push - front_grip_gap_on_front_hub*front_hub_push - front_grip_gap_on_lean*lean_push - front_grip_gap_on_pitch*pitch_push - front_grip_gap_on_steer*steer_push
    front_grip_sliding_velocity_1_left_4 = front_grip_sliding_velocity_1_wanted_rate - path_y_push - front_grip_sliding_velocity_1_on_front_hub*front_hub_push - front_grip_sliding_velocity_1_on_lean*lean_push - front_grip_sliding_velocity_1_on_pitch*pitch_push - front_grip_sliding_velocity_1_on_steer*steer_push - path_angle_push*front_grip_sliding_velocity_1_on_path_angle
    front_grip_sliding_velocity_2_left_4 = front_grip_sliding_velocity_2_wanted_rate - path_x_push - front_grip_sliding_velocity_2_on_front_hub*front_hub_push - front_grip_sliding_velocity_2_on_lean*lean_push - front_grip_sliding_velocity_2_on_path_angle*path_angle_push - front_grip_sliding_velocity_2_on_pitch*pitch_push - front_grip_sliding_velocity_2_on_steer*steer_push
    y_rear_grip_sliding_velocity_9 = rear_grip_sliding_velocity_1_left_4 - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_4
    y_rear_grip_sliding_velocity_10 = rear_grip_sliding_velocity_2_left_4 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_4 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_9
    y_front_grip_gap_5 = front_grip_gap_left_4 - l_front_grip_gap_rear_grip_gap*rear_grip_gap_left_4 - l_front_grip_gap_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_9 - l_front_grip_gap_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_10
    y_front_grip_sliding_velocity_9 = front_grip_sliding_velocity_1_left_4 - l_front_grip_sliding_velocity_1_front_grip_gap*y_front_grip_gap_5 - l_front_grip_sliding_velocity_1_rear_grip_gap*rear_grip_gap_left_4 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_9 - l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_10
    y_front_grip_sliding_velocity_10 = front_grip_sliding_velocity_2_left_4 - l_front_grip_sliding_velocity_2_front_grip_gap*y_front_grip_gap_5 - l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1*y_front_grip_sliding_velocity_9 - l_front_grip_sliding_velocity_2_rear_grip_gap*rear_grip_gap_left_4 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*y_rear_grip_sliding_velocity_9 - l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2*y_rear_grip_sliding_velocity_10
    front_grip_sliding_velocity_2_push_2 = y_front_grip_sliding_velocity_10/D_front_grip_sliding_velocity_2
    front_grip_sliding_velocity_1_push_2 = y_front_grip_sliding_velocity_9/D_front_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_push_2*l_front_grip_sliding_velocity_2_front_grip_sliding_velocity_1
    front_grip_gap_push_2 = y_front_grip_gap_5/D_front_grip_gap - front_grip_sliding_velocity_1_push_2*l_front_grip_sliding_velocity_1_front_grip_gap - front_grip_sliding_velocity_2_push_2*l_front_grip_sliding_velocity_2_front_grip_gap
    rear_grip_sliding_velocity_2_push_2 = y_rear_grip_sliding_velocity_10/D_rear_grip_sliding_velocity_2 - front_grip_gap_push_2*l_front_grip_gap_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_1_push_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_2 - front_grip_sliding_velocity_2_push_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    rear_grip_sliding_velocity_1_push_2 = y_rear_grip_sliding_velocity_9/D_rear_grip_sliding_velocity_1 - front_grip_gap_push_2*l_front_grip_gap_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_1_push_2*l_front_grip_sliding_velocity_1_rear_grip_sliding_velocity_1 - front_grip_sliding_velocity_2_push_2*l_front_grip_sliding_velocity_2_rear_grip_sliding_velocity_1 - l_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_2_push_2
    rear_grip_gap_push_2 = rear_grip_gap_left_4/W_rear_grip_gap_raised - front_grip_gap_push_2*l_front_grip_gap_rear_grip_gap - front_grip_sliding_velocity_1_push_2*l_front_grip_sliding_velocity_1_rear_grip_gap - front_grip_sliding_velocity_2_push_2*l_front_grip_sliding_velocity_2_rear_grip_gap - l_rear_grip_sliding_velocity_1_rear_grip_gap*rear_grip_sliding_velocity_1_push_2 - l_rear_grip_sliding_velocity_2_rear_grip_gap*rear_grip_sliding_velocity_2_push_2
    front_hub_push_2 = front_hub_push + front_grip_gap_push_2*front_hub_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*front_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*front_hub_by_front_grip_sliding_velocity_2 + front_hub_by_rear_grip_gap*rear_grip_gap_push_2 + front_hub_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + front_hub_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    steer_push_2 = steer_push + front_grip_gap_push_2*steer_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*steer_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*steer_by_front_grip_sliding_velocity_2 + rear_grip_gap_push_2*steer_by_rear_grip_gap + rear_grip_sliding_velocity_1_push_2*steer_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_push_2*steer_by_rear_grip_sliding_velocity_2
    rear_hub_push_2 = rear_hub_push + front_grip_gap_push_2*rear_hub_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*rear_hub_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*rear_hub_by_front_grip_sliding_velocity_2 + rear_grip_gap_push_2*rear_hub_by_rear_grip_gap + rear_grip_sliding_velocity_1_push_2*rear_hub_by_rear_grip_sliding_velocity_1 + rear_grip_sliding_velocity_2_push_2*rear_hub_by_rear_grip_sliding_velocity_2
    pitch_push_2 = pitch_push + front_grip_gap_push_2*pitch_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*pitch_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*pitch_by_front_grip_sliding_velocity_2 + pitch_by_rear_grip_gap*rear_grip_gap_push_2 + pitch_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + pitch_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    lean_push_2 = lean_push + front_grip_gap_push_2*lean_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*lean_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*lean_by_front_grip_sliding_velocity_2 + lean_by_rear_grip_gap*rear_grip_gap_push_2 + lean_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + lean_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    height_push_2 = height_push + front_grip_gap_push_2*height_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*height_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*height_by_front_grip_sliding_velocity_2 + height_by_rear_grip_gap*rear_grip_gap_push_2 + height_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + height_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    path_angle_push_2 = path_angle_push + front_grip_gap_push_2*path_angle_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*path_angle_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*path_angle_by_front_grip_sliding_velocity_2 + path_angle_by_rear_grip_gap*rear_grip_gap_push_2 + path_angle_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + path_angle_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    path_y_push_2 = path_y_push + front_grip_gap_push_2*path_y_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*path_y_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*path_y_by_front_grip_sliding_velocity_2 + path_y_by_rear_grip_gap*rear_grip_gap_push_2 + path_y_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + path_y_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    path_x_push_2 = path_x_push + front_grip_gap_push_2*path_x_by_front_grip_gap + front_grip_sliding_velocity_1_push_2*path_x_by_front_grip_sliding_velocity_1 + front_grip_sliding_velocity_2_push_2*path_x_by_front_grip_sliding_velocity_2 + path_x_by_rear_grip_gap*rear_grip_gap_push_2 + path_x_by_rear_grip_sliding_velocity_1*rear_grip_sliding_velocity_1_push_2 + path_x_by_rear_grip_sliding_velocity_2*rear_grip_sliding_velocity_2_push_2
    rear_grip_gap_independence = W_rear_grip_gap_raised/W_rear_grip_gap_rear_grip_gap
    rear_grip_sliding_velocity_1_independence = D_rear_grip_sliding_velocity_1/W_rear_grip_sliding_velocity_1_rear_grip_sliding_velocity_1
    rear_grip_sliding_velocity_2_independence = D_rear_grip_sliding_velocity_2/W_rear_grip_sliding_velocity_2_rear_grip_sliding_velocity_2
    front_grip_gap_independence = D_front_grip_gap/W_front_grip_gap_front_grip_gap
    front_grip_sliding_velocity_1_independence = D_front_grip_sliding_velocity_1/W_front_grip_sliding_velocity_1_front_grip_sliding_velocity_1
    front_grip_sliding_velocity_2_independence = D_front_grip_sliding_velocity_2/W_front_grip_sliding_velocity_2_front_grip_sliding_velocity_2
    return (ca.vertcat(path_x_push_2, path_y_push_2, path_angle_push_2, height_push_2, lean_push_2, pitch_push_2, rear_hub_push_2,
            steer_push_2, front_hub_push_2),
        ca.vertcat(rear_grip_gap_independence, rear_grip_sliding_velocity_1_independence, rear_grip_sliding_velocity_2_independence,
            front_grip_gap_independence, front_grip_sliding_velocity_1_independence, front_grip_sliding_velocity_2_independence))


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
    frame_x, rear_wheel_xx, rear_wheel_zz, rear_radius, fork_lined_up_x_x, fork_lined_up_x_z = c[0], c[1], c[3], c[7], c[10], c[11]
    fork_lined_up_y_y, fork_lined_up_z_x, fork_lined_up_z_z, trail_plus_wheel_base, k2, k3 = c[12], c[13], c[14], c[15], c[16], c[17]
    rear_wheel_xx_minus_rear_wheel_zz, frame_h_x_2, frame_h_z_2, frame_I_x_x_2, frame_I_x_z_2 = c[34], c[60], c[61], c[62], c[63]
    frame_I_z_z_2, fork_h_x_2, fork_h_z_2, fork_I_x_x_2, fork_I_x_z_2, fork_I_z_z_2 = c[64], c[65], c[66], c[67], c[68], c[69]
    half_fork_I_y_y_2, half_frame_I_y_y_2, half_front_wheel_yy, half_front_wheel_xx, half_front_wheel_zz = c[70], c[71], c[72], c[73], c[74]
    half_rear_wheel_yy, half_fork_mass, half_frame_mass, half_rear_wheel_mass, half_front_wheel_mass = c[75], c[76], c[77], c[78], c[79]
    frame_z_minus_rear_radius, k40, k41, gravity_times_rear_wheel_mass, front_wheel_mass_times_gravity = c[80], c[81], c[82], c[83], c[84]
    fork_mass_times_gravity, frame_mass_times_gravity = c[85], c[86]
    path_angle, height_travel, pitch_angle, rear_hub_angle, front_hub_angle = q[2], q[3], q[5], q[6], q[8]
    path_x_speed, path_y_speed, path_angle_speed, height_speed, lean_speed, pitch_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    rear_hub_speed, steer_speed, front_hub_speed = u[6], u[7], u[8]
    cos_heading = ca.cos(path_angle)
    sin_heading = ca.sin(path_angle)
    cos_leaning, sin_leaning = revolute_constants_terms(q[4])
    cos_frame, sin_frame = revolute_constants_terms(pitch_angle)
    rear_wheel_angle = pitch_angle + rear_hub_angle
    rear_wheel_turn = rear_wheel_angle - pitch_angle
    cos_rear_wheel_turn = ca.cos(rear_wheel_turn)
    sin_rear_wheel_turn = ca.sin(rear_wheel_turn)
    cos_fork, sin_fork = revolute_constants_terms(q[7])
    cos_front_wheel = ca.cos(front_hub_angle)
    sin_front_wheel = ca.sin(front_hub_angle)
    frame_arm_z = cos_leaning*rear_radius
    frame_z_2 = frame_arm_z + height_travel
    frame_R_z_x = -cos_leaning*sin_frame
    frame_R_z_z = cos_frame*cos_leaning
    fork_arm_z = frame_R_z_x*trail_plus_wheel_base - frame_R_z_z*rear_radius
    steer_axis_z = fork_lined_up_x_z*frame_R_z_x + fork_lined_up_z_z*frame_R_z_z
    fork_z_2 = fork_arm_z + frame_z_2
    fork_R_z_x = cos_fork*(fork_lined_up_x_x*frame_R_z_x + fork_lined_up_z_x*frame_R_z_z) + fork_lined_up_y_y*sin_fork*sin_leaning
    front_wheel_arm_z = fork_R_z_x*k2 + k3*steer_axis_z
    front_wheel_z = fork_z_2 + front_wheel_arm_z
    leaning_w_y = path_angle_speed*sin_leaning
    leaning_w_z = cos_leaning*path_angle_speed
    frame_w_x = cos_frame*lean_speed - leaning_w_z*sin_frame
    frame_w_z = cos_frame*leaning_w_z + lean_speed*sin_frame
    frame_rate_y_2 = leaning_w_y + pitch_speed
    rear_wheel_rate_y_2 = frame_rate_y_2 + rear_hub_speed
    fork_lined_up_x_x_times_frame_w_x = fork_lined_up_x_x*frame_w_x
    fork_lined_up_z_x_times_frame_w_z = fork_lined_up_z_x*frame_w_z
    x3 = fork_lined_up_x_x_times_frame_w_x + fork_lined_up_z_x_times_frame_w_z
    fork_w_x = cos_fork*x3 + fork_lined_up_y_y*frame_rate_y_2*sin_fork
    fork_w_y = cos_fork*fork_lined_up_y_y*frame_rate_y_2 - sin_fork*x3
    fork_w_z = fork_lined_up_x_z*frame_w_x + fork_lined_up_z_z*frame_w_z
    fork_rate_z_2 = fork_w_z + steer_speed
    fork_lined_up_x_x_times_fork_w_x = fork_lined_up_x_x*fork_w_x
    fork_lined_up_x_z_times_fork_rate_z_2 = fork_lined_up_x_z*fork_rate_z_2
    x6 = fork_lined_up_x_x_times_fork_w_x + fork_lined_up_x_z_times_fork_rate_z_2
    fork_lined_up_z_x_times_fork_w_x = fork_lined_up_z_x*fork_w_x
    fork_lined_up_z_z_times_fork_rate_z_2 = fork_lined_up_z_z*fork_rate_z_2
    x9 = fork_lined_up_z_x_times_fork_w_x + fork_lined_up_z_z_times_fork_rate_z_2
    front_wheel_w_x = cos_front_wheel*x6 - sin_front_wheel*x9
    front_wheel_w_y = fork_lined_up_y_y*fork_w_y
    front_wheel_w_z = cos_front_wheel*x9 + sin_front_wheel*x6
    front_wheel_rate_y_2 = front_hub_speed + front_wheel_w_y
    rear_wheel_J_swing = rear_wheel_xx_minus_rear_wheel_zz*sin_rear_wheel_turn
    rear_wheel_J_x_x = rear_wheel_xx - rear_wheel_J_swing*sin_rear_wheel_turn
    rear_wheel_J_z_z = rear_wheel_J_swing*sin_rear_wheel_turn + rear_wheel_zz
    rear_wheel_J_x_z = -cos_rear_wheel_turn*rear_wheel_J_swing
    leaning_velocity_x = cos_heading*path_x_speed + path_y_speed*sin_heading
    cos_heading_times_path_y_speed = cos_heading*path_y_speed
    minus_path_x_speed_times_sin_heading = -path_x_speed*sin_heading
    x12 = cos_heading_times_path_y_speed + minus_path_x_speed_times_sin_heading
    leaning_velocity_y = cos_leaning*x12 + height_speed*sin_leaning
    leaning_velocity_z = cos_leaning*height_speed - sin_leaning*x12
    leaning_w_y_times_rear_radius = leaning_w_y*rear_radius
    x14 = leaning_velocity_x + leaning_w_y_times_rear_radius
    frame_velocity_x_2 = cos_frame*x14 - leaning_velocity_z*sin_frame
    frame_velocity_y_2 = leaning_velocity_y - lean_speed*rear_radius
    frame_velocity_z_2 = cos_frame*leaning_velocity_z + sin_frame*x14
    minus_frame_rate_y_2_times_rear_radius = -frame_rate_y_2*rear_radius
    x16 = frame_velocity_x_2 + minus_frame_rate_y_2_times_rear_radius
    x17 = fork_lined_up_x_x*x16
    x18 = -frame_rate_y_2*trail_plus_wheel_base
    x19 = frame_velocity_z_2 + x18
    x20 = fork_lined_up_z_x*x19
    x21 = x17 + x20
    frame_w_x_times_rear_radius = frame_w_x*rear_radius
    x23 = frame_w_z*trail_plus_wheel_base
    x24 = frame_velocity_y_2 + frame_w_x_times_rear_radius + x23
    fork_velocity_x_2 = cos_fork*x21 + fork_lined_up_y_y*sin_fork*x24
    fork_velocity_y_2 = cos_fork*fork_lined_up_y_y*x24 - sin_fork*x21
    fork_velocity_z_2 = fork_lined_up_x_z*x16 + fork_lined_up_z_z*x19
    x25 = fork_w_y*k3
    x26 = fork_velocity_x_2 + x25
    x27 = fork_lined_up_x_x*x26
    x28 = -fork_w_y*k2
    x29 = fork_velocity_z_2 + x28
    x30 = fork_lined_up_x_z*x29
    x31 = x27 + x30
    x32 = fork_lined_up_z_x*x26
    x33 = fork_lined_up_z_z*x29
    x34 = x32 + x33
    front_wheel_velocity_x_2 = cos_front_wheel*x31 - sin_front_wheel*x34
    front_wheel_velocity_y_2 = fork_lined_up_y_y*(fork_velocity_y_2 + fork_rate_z_2*k2 - fork_w_x*k3)
    front_wheel_velocity_z_2 = cos_front_wheel*x34 + sin_front_wheel*x31
    frame_velocity_x_2_squared = frame_velocity_x_2*frame_velocity_x_2
    frame_velocity_y_2_squared = frame_velocity_y_2*frame_velocity_y_2
    frame_velocity_z_2_squared = frame_velocity_z_2*frame_velocity_z_2
    x38 = frame_velocity_x_2_squared + frame_velocity_y_2_squared + frame_velocity_z_2_squared
    kinetic = fork_velocity_y_2*(fork_h_x_2*fork_rate_z_2 - fork_h_z_2*fork_w_x) + frame_velocity_y_2*(frame_h_x_2*frame_w_z - frame_h_z_2*frame_w_x) + half_fork_I_y_y_2*fork_w_y*fork_w_y + half_frame_I_y_y_2*frame_rate_y_2*frame_rate_y_2 + half_front_wheel_yy*front_wheel_rate_y_2*front_wheel_rate_y_2 + half_front_wheel_xx*front_wheel_w_x*front_wheel_w_x + half_front_wheel_zz*front_wheel_w_z*front_wheel_w_z + half_rear_wheel_yy*rear_wheel_rate_y_2*rear_wheel_rate_y_2 + half_fork_mass*(fork_velocity_x_2*fork_velocity_x_2 + fork_velocity_y_2*fork_velocity_y_2 + fork_velocity_z_2*fork_velocity_z_2) + half_frame_mass*x38 + half_rear_wheel_mass*x38 + half_front_wheel_mass*(front_wheel_velocity_x_2*front_wheel_velocity_x_2 + front_wheel_velocity_y_2*front_wheel_velocity_y_2 + front_wheel_velocity_z_2*front_wheel_velocity_z_2) + fork_rate_z_2*(fork_I_x_z_2*fork_w_x + fork_I_z_z_2*fork_rate_z_2)/2 + fork_w_x*(fork_I_x_x_2*fork_w_x + fork_I_x_z_2*fork_rate_z_2)/2 + frame_w_x*(frame_I_x_x_2*frame_w_x + frame_I_x_z_2*frame_w_z)/2 + frame_w_x*(frame_w_x*rear_wheel_J_x_x + frame_w_z*rear_wheel_J_x_z)/2 + frame_w_z*(frame_I_x_z_2*frame_w_x + frame_I_z_z_2*frame_w_z)/2 + frame_w_z*(frame_w_x*rear_wheel_J_x_z + frame_w_z*rear_wheel_J_z_z)/2 + fork_h_z_2*fork_velocity_x_2*fork_w_y + frame_h_z_2*frame_rate_y_2*frame_velocity_x_2 - fork_h_x_2*fork_velocity_z_2*fork_w_y - frame_h_x_2*frame_rate_y_2*frame_velocity_z_2
    frame_centre_arm_z = frame_R_z_x*frame_x + frame_R_z_z*frame_z_minus_rear_radius
    fork_centre_arm_z = fork_R_z_x*k40 + k41*steer_axis_z
    potential = frame_z_2*gravity_times_rear_wheel_mass + front_wheel_z*front_wheel_mass_times_gravity + fork_mass_times_gravity*(fork_centre_arm_z + fork_z_2) + frame_mass_times_gravity*(frame_centre_arm_z + frame_z_2)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (21,): heading.x [m], heading.y [m], heading.z [m], lifted.x [m], lifted.y [m], lifted.z [m], leaning.x [m], leaning.y
            [m], leaning.z [m], frame.x [m], frame.y [m], frame.z [m], rear_wheel.x [m], rear_wheel.y [m], rear_wheel.z [m], fork.x [m],
            fork.y [m], fork.z [m], front_wheel.x [m], front_wheel.y [m], front_wheel.z [m]
        rotations (63,): heading.R_xx [1], heading.R_xy [1], heading.R_xz [1], heading.R_yx [1], heading.R_yy [1], heading.R_yz [1],
            heading.R_zx [1], heading.R_zy [1], heading.R_zz [1], lifted.R_xx [1], lifted.R_xy [1], lifted.R_xz [1], lifted.R_yx [1],
            lifted.R_yy [1], lifted.R_yz [1], lifted.R_zx [1], lifted.R_zy [1], lifted.R_zz [1], leaning.R_xx [1], leaning.R_xy [1],
            leaning.R_xz [1], leaning.R_yx [1], leaning.R_yy [1], leaning.R_yz [1], leaning.R_zx [1], leaning.R_zy [1], leaning.R_zz [1],
            frame.R_xx [1], frame.R_xy [1], frame.R_xz [1], frame.R_yx [1], frame.R_yy [1], frame.R_yz [1], frame.R_zx [1], frame.R_zy [1],
            frame.R_zz [1], rear_wheel.R_xx [1], rear_wheel.R_xy [1], rear_wheel.R_xz [1], rear_wheel.R_yx [1], rear_wheel.R_yy [1],
            rear_wheel.R_yz [1], rear_wheel.R_zx [1], rear_wheel.R_zy [1], rear_wheel.R_zz [1], fork.R_xx [1], fork.R_xy [1], fork.R_xz [1],
            fork.R_yx [1], fork.R_yy [1], fork.R_yz [1], fork.R_zx [1], fork.R_zy [1], fork.R_zz [1], front_wheel.R_xx [1], front_wheel.R_xy
            [1], front_wheel.R_xz [1], front_wheel.R_yx [1], front_wheel.R_yy [1], front_wheel.R_yz [1], front_wheel.R_zx [1],
            front_wheel.R_zy [1], front_wheel.R_zz [1]
    """
    rear_radius, fork_lined_up_x_x, fork_lined_up_x_z, fork_lined_up_y_y, fork_lined_up_z_x = c[7], c[10], c[11], c[12], c[13]
    fork_lined_up_z_z, trail_plus_wheel_base, k2, k3, k46, k47 = c[14], c[15], c[16], c[17], c[87], c[88]
    path_x, path_y, height_travel, pitch_angle, rear_hub_angle = q[0], q[1], q[3], q[5], q[6]
    cos_heading, sin_heading = revolute_constants_terms(q[2])
    cos_leaning, sin_leaning = revolute_constants_terms(q[4])
    cos_frame, sin_frame = revolute_constants_terms(pitch_angle)
    rear_wheel_angle = pitch_angle + rear_hub_angle
    cos_rear_wheel, sin_rear_wheel = revolute_constants_terms(rear_wheel_angle)
    cos_fork, sin_fork = revolute_constants_terms(q[7])
    cos_front_wheel, sin_front_wheel = revolute_constants_terms(q[8])
    leaning_R_x_y = -cos_leaning*sin_heading
    leaning_R_x_z = sin_heading*sin_leaning
    leaning_R_y_y = cos_heading*cos_leaning
    leaning_R_y_z = -cos_heading*sin_leaning
    frame_arm_x = leaning_R_x_z*rear_radius
    frame_arm_y = leaning_R_y_z*rear_radius
    frame_arm_z = cos_leaning*rear_radius
    frame_x_2 = frame_arm_x + path_x
    frame_y = frame_arm_y + path_y
    frame_z_2 = frame_arm_z + height_travel
    frame_R_x_x = cos_frame*cos_heading - leaning_R_x_z*sin_frame
    frame_R_x_z = cos_frame*leaning_R_x_z + cos_heading*sin_frame
    frame_R_y_x = cos_frame*sin_heading - leaning_R_y_z*sin_frame
    frame_R_y_z = cos_frame*leaning_R_y_z + sin_frame*sin_heading
    frame_R_z_x = -cos_leaning*sin_frame
    frame_R_z_z = cos_frame*cos_leaning
    rear_wheel_R_x_x = cos_heading*cos_rear_wheel - leaning_R_x_z*sin_rear_wheel
    rear_wheel_R_x_z = cos_heading*sin_rear_wheel + cos_rear_wheel*leaning_R_x_z
    rear_wheel_R_y_x = cos_rear_wheel*sin_heading - leaning_R_y_z*sin_rear_wheel
    rear_wheel_R_y_z = cos_rear_wheel*leaning_R_y_z + sin_heading*sin_rear_wheel
    rear_wheel_R_z_x = -cos_leaning*sin_rear_wheel
    rear_wheel_R_z_z = cos_leaning*cos_rear_wheel
    frame_frame_arm_x = -frame_R_x_z*rear_radius
    fork_arm_x = frame_frame_arm_x + frame_R_x_x*trail_plus_wheel_base
    frame_frame_arm_y = -frame_R_y_z*rear_radius
    fork_arm_y = frame_frame_arm_y + frame_R_y_x*trail_plus_wheel_base
    frame_frame_arm_z = -frame_R_z_z*rear_radius
    fork_arm_z = frame_frame_arm_z + frame_R_z_x*trail_plus_wheel_base
    steer_axis_x = fork_lined_up_x_z*frame_R_x_x + fork_lined_up_z_z*frame_R_x_z
    steer_axis_y = fork_lined_up_x_z*frame_R_y_x + fork_lined_up_z_z*frame_R_y_z
    steer_axis_z = fork_lined_up_x_z*frame_R_z_x + fork_lined_up_z_z*frame_R_z_z
    fork_x_2 = fork_arm_x + frame_x_2
    fork_y = fork_arm_y + frame_y
    fork_z_2 = fork_arm_z + frame_z_2
    fork_lined_up_x_x_times_frame_R_x_x = fork_lined_up_x_x*frame_R_x_x
    fork_lined_up_z_x_times_frame_R_x_z = fork_lined_up_z_x*frame_R_x_z
    x6 = fork_lined_up_x_x_times_frame_R_x_x + fork_lined_up_z_x_times_frame_R_x_z
    fork_R_x_x = cos_fork*x6 + fork_lined_up_y_y*leaning_R_x_y*sin_fork
    fork_R_x_y = cos_fork*fork_lined_up_y_y*leaning_R_x_y - sin_fork*x6
    fork_lined_up_x_x_times_frame_R_y_x = fork_lined_up_x_x*frame_R_y_x
    fork_lined_up_z_x_times_frame_R_y_z = fork_lined_up_z_x*frame_R_y_z
    x9 = fork_lined_up_x_x_times_frame_R_y_x + fork_lined_up_z_x_times_frame_R_y_z
    fork_R_y_x = cos_fork*x9 + fork_lined_up_y_y*leaning_R_y_y*sin_fork
    fork_R_y_y = cos_fork*fork_lined_up_y_y*leaning_R_y_y - sin_fork*x9
    fork_lined_up_x_x_times_frame_R_z_x = fork_lined_up_x_x*frame_R_z_x
    fork_lined_up_z_x_times_frame_R_z_z = fork_lined_up_z_x*frame_R_z_z
    x12 = fork_lined_up_x_x_times_frame_R_z_x + fork_lined_up_z_x_times_frame_R_z_z
    fork_R_z_x = cos_fork*x12 + fork_lined_up_y_y*sin_fork*sin_leaning
    fork_R_z_y = cos_fork*fork_lined_up_y_y*sin_leaning - sin_fork*x12
    front_wheel_arm_x = fork_R_x_x*k2 + k3*steer_axis_x
    front_wheel_arm_y = fork_R_y_x*k2 + k3*steer_axis_y
    front_wheel_arm_z = fork_R_z_x*k2 + k3*steer_axis_z
    front_hub_axis_x = fork_R_x_y*fork_lined_up_y_y
    front_hub_axis_y = fork_R_y_y*fork_lined_up_y_y
    front_hub_axis_z = fork_R_z_y*fork_lined_up_y_y
    front_wheel_x = fork_x_2 + front_wheel_arm_x
    front_wheel_y = fork_y + front_wheel_arm_y
    front_wheel_z = fork_z_2 + front_wheel_arm_z
    fork_R_x_x_times_fork_lined_up_x_x = fork_R_x_x*fork_lined_up_x_x
    fork_lined_up_x_z_times_steer_axis_x = fork_lined_up_x_z*steer_axis_x
    fork_R_x_x_2 = fork_R_x_x_times_fork_lined_up_x_x + fork_lined_up_x_z_times_steer_axis_x
    fork_R_x_x_times_fork_lined_up_z_x = fork_R_x_x*fork_lined_up_z_x
    fork_lined_up_z_z_times_steer_axis_x = fork_lined_up_z_z*steer_axis_x
    fork_R_x_z = fork_R_x_x_times_fork_lined_up_z_x + fork_lined_up_z_z_times_steer_axis_x
    front_wheel_R_x_x = cos_front_wheel*fork_R_x_x_2 - sin_front_wheel*fork_R_x_z
    front_wheel_R_x_z = cos_front_wheel*fork_R_x_z + sin_front_wheel*fork_R_x_x_2
    fork_R_y_x_times_fork_lined_up_x_x = fork_R_y_x*fork_lined_up_x_x
    fork_lined_up_x_z_times_steer_axis_y = fork_lined_up_x_z*steer_axis_y
    fork_R_y_x_2 = fork_R_y_x_times_fork_lined_up_x_x + fork_lined_up_x_z_times_steer_axis_y
    fork_R_y_x_times_fork_lined_up_z_x = fork_R_y_x*fork_lined_up_z_x
    fork_lined_up_z_z_times_steer_axis_y = fork_lined_up_z_z*steer_axis_y
    fork_R_y_z = fork_R_y_x_times_fork_lined_up_z_x + fork_lined_up_z_z_times_steer_axis_y
    front_wheel_R_y_x = cos_front_wheel*fork_R_y_x_2 - sin_front_wheel*fork_R_y_z
    front_wheel_R_y_z = cos_front_wheel*fork_R_y_z + sin_front_wheel*fork_R_y_x_2
    fork_R_z_x_times_fork_lined_up_x_x = fork_R_z_x*fork_lined_up_x_x
    fork_lined_up_x_z_times_steer_axis_z = fork_lined_up_x_z*steer_axis_z
    fork_R_z_x_2 = fork_R_z_x_times_fork_lined_up_x_x + fork_lined_up_x_z_times_steer_axis_z
    fork_R_z_x_times_fork_lined_up_z_x = fork_R_z_x*fork_lined_up_z_x
    fork_lined_up_z_z_times_steer_axis_z = fork_lined_up_z_z*steer_axis_z
    fork_R_z_z = fork_R_z_x_times_fork_lined_up_z_x + fork_lined_up_z_z_times_steer_axis_z
    front_wheel_R_z_x = cos_front_wheel*fork_R_z_x_2 - sin_front_wheel*fork_R_z_z
    front_wheel_R_z_z = cos_front_wheel*fork_R_z_z + sin_front_wheel*fork_R_z_x_2
    fork_frame_arm_x = -fork_R_x_x*k46 - k47*steer_axis_x
    fork_frame_arm_y = -fork_R_y_x*k46 - k47*steer_axis_y
    fork_frame_arm_z = -fork_R_z_x*k46 - k47*steer_axis_z
    return (ca.vertcat(path_x, path_y, 0, path_x, path_y, height_travel, path_x, path_y, height_travel, frame_x_2 + frame_frame_arm_x,
            frame_y + frame_frame_arm_y, frame_z_2 + frame_frame_arm_z, frame_x_2, frame_y, frame_z_2, fork_frame_arm_x + fork_x_2,
            fork_frame_arm_y + fork_y, fork_frame_arm_z + fork_z_2, front_wheel_x, front_wheel_y, front_wheel_z),
        ca.vertcat(cos_heading, -sin_heading, 0, sin_heading, cos_heading, 0, 0, 0, 1, cos_heading, -sin_heading, 0, sin_heading,
            cos_heading, 0, 0, 0, 1, cos_heading, leaning_R_x_y, leaning_R_x_z, sin_heading, leaning_R_y_y, leaning_R_y_z, 0, sin_leaning,
            cos_leaning, frame_R_x_x, leaning_R_x_y, frame_R_x_z, frame_R_y_x, leaning_R_y_y, frame_R_y_z, frame_R_z_x, sin_leaning,
            frame_R_z_z, rear_wheel_R_x_x, leaning_R_x_y, rear_wheel_R_x_z, rear_wheel_R_y_x, leaning_R_y_y, rear_wheel_R_y_z,
            rear_wheel_R_z_x, sin_leaning, rear_wheel_R_z_z, fork_R_x_x_2, front_hub_axis_x, fork_R_x_z, fork_R_y_x_2, front_hub_axis_y,
            fork_R_y_z, fork_R_z_x_2, front_hub_axis_z, fork_R_z_z, front_wheel_R_x_x, front_hub_axis_x, front_wheel_R_x_z,
            front_wheel_R_y_x, front_hub_axis_y, front_wheel_R_y_z, front_wheel_R_z_x, front_hub_axis_z, front_wheel_R_z_z))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (0,): empty
    """
    return ca.vertcat()


def rolling_limits(p):
    """Coefficient of friction that keeps surfaces from slipping, where one is given, see ROLLING.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (0,): empty
    """
    return ca.vertcat()


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        path.parent, path.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        height.parent to front_hub.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        rear_tyre.disc (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        rear_tyre.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        front_tyre.disc (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        front_tyre.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        frame.centre, rear_wheel.centre, fork.centre, front_wheel.centre (3,): x [m], y [m], z [m]
    """
    frame_x, frame_z, fork_x, fork_z, rear_radius, trail, wheel_base, front_radius = p[5], p[6], p[16], p[17], p[22], p[23], p[24], p[26]
    x1 = trail + wheel_base
    cos, sin = revolute_constants_terms(p[25])
    cos_steer_axis_tilt_squared = cos*cos
    sin_steer_axis_tilt_squared = sin*sin
    x6 = cos_steer_axis_tilt_squared + sin_steer_axis_tilt_squared
    x7 = 1/ca.sqrt(x6)
    x8 = -sin*x7
    x9 = cos*x7
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, rear_radius, 0, 1, 0), ca.vertcat(0, 0, rear_radius, 0, 1, 0),
        ca.vertcat(0, 0, rear_radius, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(x1, 0, 0, x8, 0, x9),
        ca.vertcat(x1, 0, 0, x8, 0, x9), ca.vertcat(wheel_base, 0, front_radius, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(0, 0, 0, rear_radius, 0, 1, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, front_radius, 0, 1, 0), ca.vertcat(*[0]*5, 1),
        ca.vertcat(*[0]*5, -1), ca.vertcat(frame_x, 0, frame_z), ca.vertcat(0, 0, 0), ca.vertcat(fork_x, 0, fork_z), ca.vertcat(0, 0, 0))
