"""double_pendulum: double pendulum. Generated from derive/scenes/double_pendulum.py.

Do not edit; regenerate with `hertzwerk derive double_pendulum`.
Effects:
    gravity: uniform gravity
    energy_ledger: work put in, energy dissipated per effect
Units: 46 assignments and 90 outputs checked, all consistent
Operations: flight 62 (equations of motion and gaps)
"""

import casadi as ca

NAME = "double_pendulum"
SOURCE = "derive/scenes/double_pendulum.py"
SUMMARY = "double pendulum"
FORMAT = "hertzwerk module 1"
DIGEST = "78f9630afe9980f629244edf76c90990"

EFFECTS = (("gravity", "gravity", "uniform gravity"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"))

PARAMETERS = (
    ("mass", "kg", 1.0, "of each bob"),
    ("length", "m", 1.0, "of each rod"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("shoulder_angle", "deg", 120, "of the upper rod at the start, from hanging"),
    ("elbow_angle", "deg", -30, "of the lower rod at the start, from the upper"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body upper, mass"),
    ("length", "defined", 0, None, True, False, "scales, length"),
)

COORDINATES = (("shoulder.angle", "rad"), ("elbow.angle", "rad"))

SPEEDS = (("shoulder.speed", "rad/s"), ("elbow.speed", "rad/s"))

BODIES = ("upper", "lower")

LANDMARKS = (
    ("shoulder", "revolute", "parent", "ground", ("axis",)), ("shoulder", "revolute", "child", "upper", ("axis",)),
    ("elbow", "revolute", "parent", "upper", ("axis",)), ("elbow", "revolute", "child", "lower", ("axis",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("upper", "body", "centre", "upper", ()),
    ("lower", "body", "centre", "lower", ()),
)

CONSTANTS = (
    ("length", "m"), ("gravity", "m/s^2"), ("lower_h_y", "kg m"), ("upper_h_y", "kg m"), ("lower_I_z_z", "kg m^2"),
    ("lower_I_z_z_plus_upper_I_z_z", "kg m^2"), ("inverse_lower_I_z_z", "1/(kg m^2)"), ("half_lower_I_z_z", "kg m^2"), ("half_mass", "kg"),
    ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 13), ("start", 0), ("scales", 8), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 12),
    ("accelerations", 50), ("ledger", 0), ("energy", 37), ("poses", 10), ("outputs", 0), ("landmarks", 3),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = MEMORY = LATCHES = PAIRS = EVENTS = LOADS = ()
FED = RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = CONSTRAINTS = ROLLING = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (10,): length, gravity, lower_h_y, upper_h_y, lower_I_z_z, lower_I_z_z_plus_upper_I_z_z, inverse_lower_I_z_z, half_lower_I_z_z,
            half_mass, gravity_times_mass
    """
    mass, length, gravity = p[0], p[1], p[2]
    lower_h_y = -length*mass
    upper_h_y = -2*length*mass
    length_squared = length*length
    upper_I_z_z = 2*length_squared*mass
    lower_I_z_z = length_squared*mass
    lower_I_z_z_plus_upper_I_z_z = lower_I_z_z + upper_I_z_z
    inverse_lower_I_z_z = 1/lower_I_z_z
    half_lower_I_z_z = lower_I_z_z/2
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(length, gravity, lower_h_y, upper_h_y, lower_I_z_z, lower_I_z_z_plus_upper_I_z_z, inverse_lower_I_z_z,
        half_lower_I_z_z, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    shoulder_angle, elbow_angle = p[3], p[4]
    return ca.vertcat(shoulder_angle, elbow_angle), ca.vertcat(0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (0,): empty
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, length, gravity = p[0], p[1], p[2]
    total_mass = 2*mass
    energy_scale = total_mass*gravity*length/2
    force_scale = energy_scale/length
    gravity_times_length = gravity*length
    x2 = ca.sqrt(gravity_times_length)
    x3 = x2/length
    return ca.vertcat(1, 1), ca.vertcat(x3, x3), ca.vertcat(), ca.vertcat(length, x2, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (2,): COORDINATES [rad/s]
    """
    shoulder_speed, elbow_speed = u[0], u[1]
    return ca.vertcat(shoulder_speed, elbow_speed)


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
        f (2,): shoulder [N m], elbow [N m]
    """
    gravity, lower_h_y, upper_h_y = c[1], c[2], c[3]
    shoulder_angle_2, elbow_angle_2 = q[0], q[1]
    sin_upper = ca.sin(shoulder_angle_2)
    lower_angle = elbow_angle_2 + shoulder_angle_2
    sin_lower = ca.sin(lower_angle)
    lower_moment_x = -lower_h_y*sin_lower
    upper_moment_x = -sin_upper*upper_h_y
    upper_total_moment_x = lower_moment_x + upper_moment_x
    return ca.vertcat(-upper_total_moment_x*gravity, -lower_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): shoulder.acceleration [rad/s^2], elbow.acceleration [rad/s^2]
        reactions (0,): empty
    """
    length, lower_h_y, lower_I_z_z, lower_I_z_z_plus_upper_I_z_z, inverse_lower_I_z_z = c[0], c[2], c[4], c[5], c[6]
    shoulder_angle_2, elbow_angle_2 = q[0], q[1]
    shoulder_speed, elbow_speed = u[0], u[1]
    shoulder_force, elbow_force = f[0], f[1]
    cos_upper = ca.cos(shoulder_angle_2)
    sin_upper = ca.sin(shoulder_angle_2)
    lower_angle = elbow_angle_2 + shoulder_angle_2
    cos_lower = ca.cos(lower_angle)
    sin_lower = ca.sin(lower_angle)
    lower_moment_x = -lower_h_y*sin_lower
    lower_moment_y = cos_lower*lower_h_y
    upper_rate_zz = shoulder_speed*shoulder_speed
    lower_rate_z = elbow_speed + shoulder_speed
    lower_rate_zz = lower_rate_z*lower_rate_z
    lower_force_x = -lower_moment_x*lower_rate_zz
    lower_force_y = -lower_moment_y*lower_rate_zz
    lower_arm_x = sin_upper*length
    lower_arm_y = -cos_upper*length
    lower_bias_x = -lower_arm_x*upper_rate_zz
    lower_bias_y = -lower_arm_y*upper_rate_zz
    lower_torque_z = lower_bias_y*lower_moment_x - lower_bias_x*lower_moment_y
    upper_torque_z = lower_torque_z + lower_arm_x*lower_force_y - lower_arm_y*lower_force_x
    shoulder_net = shoulder_force - upper_torque_z
    elbow_net = elbow_force - lower_torque_z
    upper_total_J_z_z = lower_I_z_z_plus_upper_I_z_z + 2*lower_arm_x*lower_moment_x + 2*lower_arm_y*lower_moment_y
    elbow_lower_torque_z = lower_I_z_z + lower_arm_x*lower_moment_x + lower_arm_y*lower_moment_y
    l_shoulder_elbow = elbow_lower_torque_z*inverse_lower_I_z_z
    D_shoulder = upper_total_J_z_z - elbow_lower_torque_z*l_shoulder_elbow
    y_shoulder = shoulder_net - elbow_net*l_shoulder_elbow
    shoulder_acc = y_shoulder/D_shoulder
    elbow_acc = elbow_net*inverse_lower_I_z_z - l_shoulder_elbow*shoulder_acc
    return ca.vertcat(shoulder_acc, elbow_acc), ca.vertcat()


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
    length, lower_h_y, half_lower_I_z_z, half_mass, gravity_times_mass = c[0], c[2], c[7], c[8], c[9]
    shoulder_angle_2, elbow_angle_2 = q[0], q[1]
    shoulder_speed, elbow_speed = u[0], u[1]
    cos_upper = ca.cos(shoulder_angle_2)
    sin_upper = ca.sin(shoulder_angle_2)
    lower_angle = elbow_angle_2 + shoulder_angle_2
    cos_lower = ca.cos(lower_angle)
    sin_lower = ca.sin(lower_angle)
    lower_moment_x = -lower_h_y*sin_lower
    lower_moment_y = cos_lower*lower_h_y
    lower_rate_z = elbow_speed + shoulder_speed
    lower_arm_x = sin_upper*length
    lower_arm_y = -cos_upper*length
    lower_velocity_x = -lower_arm_y*shoulder_speed
    lower_velocity_y = lower_arm_x*shoulder_speed
    kinetic = half_lower_I_z_z*lower_rate_z*lower_rate_z + half_lower_I_z_z*shoulder_speed*shoulder_speed + half_mass*(lower_velocity_x*lower_velocity_x + lower_velocity_y*lower_velocity_y) + lower_moment_x*lower_rate_z*lower_velocity_y - lower_moment_y*lower_rate_z*lower_velocity_x
    lower_centre_arm_y = -cos_lower*length
    potential = gravity_times_mass*lower_arm_y + gravity_times_mass*(lower_arm_y + lower_centre_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): upper.x [m], upper.y [m], upper.z [m], lower.x [m], lower.y [m], lower.z [m]
        rotations (18,): upper.R_xx [1], upper.R_xy [1], upper.R_xz [1], upper.R_yx [1], upper.R_yy [1], upper.R_yz [1], upper.R_zx [1],
            upper.R_zy [1], upper.R_zz [1], lower.R_xx [1], lower.R_xy [1], lower.R_xz [1], lower.R_yx [1], lower.R_yy [1], lower.R_yz [1],
            lower.R_zx [1], lower.R_zy [1], lower.R_zz [1]
    """
    length = c[0]
    shoulder_angle_2, elbow_angle_2 = q[0], q[1]
    cos_upper = ca.cos(shoulder_angle_2)
    sin_upper = ca.sin(shoulder_angle_2)
    lower_angle = elbow_angle_2 + shoulder_angle_2
    cos_lower = ca.cos(lower_angle)
    sin_lower = ca.sin(lower_angle)
    lower_arm_x = sin_upper*length
    lower_arm_y = -cos_upper*length
    return (ca.vertcat(0, 0, 0, lower_arm_x, lower_arm_y, 0),
        ca.vertcat(cos_upper, -sin_upper, 0, sin_upper, cos_upper, 0, 0, 0, 1, cos_lower, -sin_lower, 0, sin_lower, cos_lower, 0, 0, 0, 1))


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
        shoulder.parent to gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        upper.centre, lower.centre (3,): x [m], y [m], z [m]
    """
    length = p[1]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, -length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, -length, 0), ca.vertcat(0, -length, 0))
