"""ball_in_socket: ball swinging at the bottom of a socket. Generated from derive/scenes/ball_in_socket.py.

Do not edit; regenerate with `hertzwerk derive ball_in_socket`.
Effects:
    gravity: uniform gravity
    ball_joint: power
    energy_ledger: work put in, energy dissipated per effect
Units: 59 assignments and 110 outputs checked, all consistent
Operations: flight 44 (equations of motion and gaps); in contact also contact_ball_joint 21
"""

import casadi as ca

NAME = "ball_in_socket"
SOURCE = "derive/scenes/ball_in_socket.py"
SUMMARY = "ball swinging at the bottom of a socket"
FORMAT = "hertzwerk module 1"
DIGEST = "226e42c4b37c29931adfde49cbfc416d"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("ball_joint", "contact", "power"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 0.5, "body ball, mass"),
    ("clearance", "mm", 5, "socket radius minus ball radius"),
    ("socket_radius", "mm", 25, "pair ball_joint, socket radius"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^1.5", 10000000.0, "of a soft lining"),
    ("start_angle", "rad", 0.05, "from the lowest position, towards x"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body ball, mass"),
    ("socket_radius", "defined", 0, None, True, False, "pair ball_joint, socket radius"),
    ("clearance", "defined", 0, None, True, False, "pair ball_joint, clearance"),
    ("stiffness", "defined", 0, None, True, False, "effect ball_joint, stiffness of power"),
)

SUM_LIMITS = (
    ((("clearance", -1.0), ("socket_radius", 1.0)), "defined", 0, None, True, False, "pair ball_joint, ball radius (socket radius minus clearance)"),
)

COORDINATES = (
    ("float.x", "m"), ("float.y", "m"), ("float.z", "m"), ("float.q0", "1"), ("float.q1", "1"), ("float.q2", "1"), ("float.q3", "1"),
)

QUATERNIONS = (3,)

SPEEDS = (
    ("float.x_speed", "m/s"), ("float.y_speed", "m/s"), ("float.z_speed", "m/s"), ("float.angular_speed_x", "rad/s"),
    ("float.angular_speed_y", "rad/s"), ("float.angular_speed_z", "rad/s"),
)

MEMORY = (("ball_joint.dissipated", "J"),)

PAIRS = (("ball_joint", "ball_in_socket"),)

RELEASES = ("force",)

DISSIPATED = (0,)

GIVEN = ("float.x", "float.z")

OUTPUTS = (("ball_joint.eccentricity_x", "m"), ("ball_joint.eccentricity_y", "m"), ("ball_joint.eccentricity_z", "m"))

BODIES = ("ball",)

LANDMARKS = (
    ("ball_joint", "ball_in_socket", "ball", "ball", ("radius",)), ("ball_joint", "ball_in_socket", "socket", "ground", ("radius",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("ball", "body", "centre", "ball", ()),
)

CONSTANTS = (
    ("mass", "kg"), ("clearance", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m^1.5"), ("clearance_squared", "m^2"),
    ("half_inverse_clearance", "1/m"), ("two_fifths_of_stiffness", "N/m^1.5"), ("inverse_mass", "1/kg"),
    ("inverse_ball_I_z_z", "1/(kg m^2)"), ("half_ball_I_z_z", "kg m^2"), ("half_mass", "kg"), ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 15), ("start", 11), ("scales", 19), ("coordinate_rates", 24), ("gaps", 17), ("gap_accelerations", 19),
    ("contact_ball_joint", 21), ("applied", 2), ("accelerations", 6), ("ledger", 0), ("energy", 68), ("poses", 24), ("outputs", 0),
    ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = LATCHES = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (12,): mass, clearance, gravity, stiffness, clearance_squared, half_inverse_clearance, two_fifths_of_stiffness, inverse_mass,
            inverse_ball_I_z_z, half_ball_I_z_z, half_mass, gravity_times_mass
    """
    mass, clearance, socket_radius, gravity, stiffness = p[0], p[1], p[2], p[3], p[4]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    two_fifths_of_stiffness = 2*stiffness/5
    ball_I_z_z = 2*(socket_radius - clearance)**2*mass/5
    inverse_mass = 1/mass
    inverse_ball_I_z_z = 1/ball_I_z_z
    half_ball_I_z_z = ball_I_z_z/2
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(mass, clearance, gravity, stiffness, clearance_squared, half_inverse_clearance, two_fifths_of_stiffness, inverse_mass,
        inverse_ball_I_z_z, half_ball_I_z_z, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (7,): COORDINATES
        u (6,): SPEEDS
    """
    mass, clearance, gravity, stiffness, start_angle = p[0], p[1], p[3], p[4], p[5]
    gravity_times_mass_over_stiffness = gravity*mass/stiffness
    x2 = gravity_times_mass_over_stiffness**(2/3)
    return ca.vertcat((x2 + clearance)*ca.sin(start_angle), 0, (-x2 - clearance)*ca.cos(start_angle), 1, 0, 0, 0), ca.vertcat(*[0]*6)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (7,): COORDINATES
        su (6,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, clearance, socket_radius, gravity, stiffness, start_angle = p[0], p[1], p[2], p[3], p[4], p[5]
    energy_scale = start_angle*start_angle*clearance*gravity*mass/2
    gravity_times_mass_over_stiffness = gravity*mass/stiffness
    force_scale = energy_scale/gravity_times_mass_over_stiffness**(2/3)
    x2 = gravity_times_mass_over_stiffness**(2/3)
    x3 = x2/(2*socket_radius)
    clearance_times_gravity = clearance*gravity
    x5 = ca.sqrt(clearance_times_gravity)
    x6 = x5*start_angle
    x7 = x5*start_angle/socket_radius
    return (ca.vertcat(x2, x2, x2, x3, x3, x3, x3), ca.vertcat(x6, x6, x6, x7, x7, x7), ca.vertcat(energy_scale),
        ca.vertcat(x2, x6, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (7,): float.x [m/s], float.y [m/s], float.z [m/s], float.q0 [1/s], float.q1 [1/s], float.q2 [1/s], float.q3 [1/s]
    """
    float_q0, float_q1, float_q2, float_q3 = q[3], q[4], q[5], q[6]
    float_x_speed, float_y_speed, float_z_speed, float_angular_speed_x, float_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    float_angular_speed_z = u[5]
    half_float_angular_speed_x = float_angular_speed_x/2
    half_float_angular_speed_y = float_angular_speed_y/2
    half_float_angular_speed_z = float_angular_speed_z/2
    return ca.vertcat(float_x_speed, float_y_speed, float_z_speed, -float_q1*half_float_angular_speed_x -
        float_q2*half_float_angular_speed_y - float_q3*half_float_angular_speed_z, float_q0*half_float_angular_speed_x +
        float_q2*half_float_angular_speed_z - float_q3*half_float_angular_speed_y, float_q0*half_float_angular_speed_y +
        float_q3*half_float_angular_speed_x - float_q1*half_float_angular_speed_z, float_q0*half_float_angular_speed_z +
        float_q1*half_float_angular_speed_y - float_q2*half_float_angular_speed_x)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    clearance_squared, half_inverse_clearance = c[4], c[5]
    float_x, float_y, float_z = q[0], q[1], q[2]
    float_x_speed, float_y_speed, float_z_speed = u[0], u[1], u[2]
    ball_joint_apart_squared = float_x*float_x + float_y*float_y + float_z*float_z
    ball_joint_gap = half_inverse_clearance*(clearance_squared - ball_joint_apart_squared)
    ball_joint_apart_squared_rate = 2*float_x*float_x_speed + 2*float_y*float_y_speed + 2*float_z*float_z_speed
    ball_joint_gap_rate = -ball_joint_apart_squared_rate*half_inverse_clearance
    return ca.vertcat(ball_joint_gap), ca.vertcat(ball_joint_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    half_inverse_clearance = c[5]
    float_x, float_y, float_z = q[0], q[1], q[2]
    float_x_speed, float_y_speed, float_z_speed = u[0], u[1], u[2]
    float_x_acceleration, float_y_acceleration, float_z_acceleration = a[0], a[1], a[2]
    ball_joint_apart_squared_rate_rate = 2*float_x_speed*float_x_speed + 2*float_y_speed*float_y_speed + 2*float_z_speed*float_z_speed + 2*float_x*float_x_acceleration + 2*float_y*float_y_acceleration + 2*float_z*float_z_acceleration
    ball_joint_gap_rate_rate = -ball_joint_apart_squared_rate_rate*half_inverse_clearance
    return ca.vertcat(ball_joint_gap_rate_rate)


def contact_ball_joint(t, q, u, z, m, c):
    """Forces of ball_joint: power. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): float.x [N], float.y [N], float.z [N], float.moment_x [N m], float.moment_y [N m], float.moment_z [N m]
        dz (1,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    clearance, stiffness = c[1], c[3]
    float_x, float_y, float_z = q[0], q[1], q[2]
    ball_joint_apart_squared = float_x*float_x + float_y*float_y + float_z*float_z
    ball_joint_distance = ca.sqrt(ball_joint_apart_squared)
    ball_joint_penetration = ball_joint_distance - clearance
    ball_joint_elastic_force = ca.if_else(ball_joint_penetration > 0, ball_joint_penetration*ca.sqrt(ball_joint_penetration)*stiffness, 0)
    ball_joint_normal_x = -float_x/ball_joint_distance
    ball_joint_normal_y = -float_y/ball_joint_distance
    ball_joint_normal_z = -float_z/ball_joint_distance
    ball_joint_push_x = ball_joint_elastic_force*ball_joint_normal_x
    ball_joint_push_y = ball_joint_elastic_force*ball_joint_normal_y
    ball_joint_push_z = ball_joint_elastic_force*ball_joint_normal_z
    return (ca.vertcat(ball_joint_push_x, ball_joint_push_y, ball_joint_push_z, 0, 0, 0), ca.vertcat(0),
            ca.vertcat(ball_joint_elastic_force),
        ca.vertcat(), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): float.x [N], float.y [N], float.z [N], float.moment_x [N m], float.moment_y [N m], float.moment_z [N m]
    """
    mass, gravity = c[0], c[2]
    return ca.vertcat(0, 0, -gravity*mass, 0, 0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (6,): float.x_acceleration [m/s^2], float.y_acceleration [m/s^2], float.z_acceleration [m/s^2], float.angular_acceleration_x
            [rad/s^2], float.angular_acceleration_y [rad/s^2], float.angular_acceleration_z [rad/s^2]
        reactions (0,): empty
    """
    inverse_mass, inverse_ball_I_z_z = c[7], c[8]
    float_x_force, float_y_force, float_z_force, float_moment_x_force, float_moment_y_force = f[0], f[1], f[2], f[3], f[4]
    float_moment_z_force = f[5]
    float_x_acc = float_x_force*inverse_mass
    float_y_acc = float_y_force*inverse_mass
    float_z_acc = float_z_force*inverse_mass
    float_moment_x_acc = float_moment_x_force*inverse_ball_I_z_z
    float_moment_y_acc = float_moment_y_force*inverse_ball_I_z_z
    float_moment_z_acc = float_moment_z_force*inverse_ball_I_z_z
    return ca.vertcat(float_x_acc, float_y_acc, float_z_acc, float_moment_x_acc, float_moment_y_acc, float_moment_z_acc), ca.vertcat()


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
    clearance, two_fifths_of_stiffness, half_ball_I_z_z, half_mass, gravity_times_mass = c[1], c[6], c[9], c[10], c[11]
    float_x, float_y, float_z, float_q0, float_q1, float_q2, float_q3 = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    float_x_speed, float_y_speed, float_z_speed, float_angular_speed_x, float_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    float_angular_speed_z = u[5]
    ball_twice_q1 = 2*float_q1
    ball_twice_q2 = 2*float_q2
    ball_twice_q3 = 2*float_q3
    ball_q1q1 = ball_twice_q1*float_q1
    ball_q2q2 = ball_twice_q2*float_q2
    ball_q3q3 = ball_twice_q3*float_q3
    ball_q0q1 = ball_twice_q1*float_q0
    ball_q0q2 = ball_twice_q2*float_q0
    ball_q0q3 = ball_twice_q3*float_q0
    ball_R_x_x = 1 - ball_q2q2 - ball_q3q3
    ball_twice_q1_times_float_q2 = ball_twice_q1*float_q2
    ball_R_x_y = ball_twice_q1_times_float_q2 - ball_q0q3
    ball_twice_q1_times_float_q3 = ball_twice_q1*float_q3
    ball_R_x_z = ball_q0q2 + ball_twice_q1_times_float_q3
    ball_R_y_x = ball_q0q3 + ball_twice_q1_times_float_q2
    ball_R_y_y = 1 - ball_q1q1 - ball_q3q3
    ball_twice_q2_times_float_q3 = ball_twice_q2*float_q3
    ball_R_y_z = ball_twice_q2_times_float_q3 - ball_q0q1
    ball_R_z_x = ball_twice_q1_times_float_q3 - ball_q0q2
    ball_R_z_y = ball_q0q1 + ball_twice_q2_times_float_q3
    ball_R_z_z = 1 - ball_q1q1 - ball_q2q2
    ball_joint_apart_squared = float_x*float_x + float_y*float_y + float_z*float_z
    ball_joint_distance = ca.sqrt(ball_joint_apart_squared)
    ball_joint_penetration = ball_joint_distance - clearance
    ball_joint_stored_energy = ca.if_else(ball_joint_penetration > 0, two_fifths_of_stiffness*ball_joint_penetration*ball_joint_penetration*ca.sqrt(ball_joint_penetration), 0)
    ball_velocity_x = ball_R_x_x*float_x_speed + ball_R_y_x*float_y_speed + ball_R_z_x*float_z_speed
    ball_velocity_y = ball_R_x_y*float_x_speed + ball_R_y_y*float_y_speed + ball_R_z_y*float_z_speed
    ball_velocity_z = ball_R_x_z*float_x_speed + ball_R_y_z*float_y_speed + ball_R_z_z*float_z_speed
    kinetic = half_ball_I_z_z*float_angular_speed_x*float_angular_speed_x + half_ball_I_z_z*float_angular_speed_y*float_angular_speed_y + half_ball_I_z_z*float_angular_speed_z*float_angular_speed_z + half_mass*(ball_velocity_x*ball_velocity_x + ball_velocity_y*ball_velocity_y + ball_velocity_z*ball_velocity_z)
    potential = float_z*gravity_times_mass
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(ball_joint_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball.x [m], ball.y [m], ball.z [m]
        rotations (9,): ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy
            [1], ball.R_zz [1]
    """
    float_x, float_y, float_z, float_q0, float_q1, float_q2, float_q3 = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    ball_twice_q1 = 2*float_q1
    ball_twice_q2 = 2*float_q2
    ball_twice_q3 = 2*float_q3
    ball_q1q1 = ball_twice_q1*float_q1
    ball_q2q2 = ball_twice_q2*float_q2
    ball_q3q3 = ball_twice_q3*float_q3
    ball_q0q1 = ball_twice_q1*float_q0
    ball_q0q2 = ball_twice_q2*float_q0
    ball_q0q3 = ball_twice_q3*float_q0
    ball_R_x_x = 1 - ball_q2q2 - ball_q3q3
    ball_twice_q1_times_float_q2 = ball_twice_q1*float_q2
    ball_R_x_y = ball_twice_q1_times_float_q2 - ball_q0q3
    ball_twice_q1_times_float_q3 = ball_twice_q1*float_q3
    ball_R_x_z = ball_q0q2 + ball_twice_q1_times_float_q3
    ball_R_y_x = ball_q0q3 + ball_twice_q1_times_float_q2
    ball_R_y_y = 1 - ball_q1q1 - ball_q3q3
    ball_twice_q2_times_float_q3 = ball_twice_q2*float_q3
    ball_R_y_z = ball_twice_q2_times_float_q3 - ball_q0q1
    ball_R_z_x = ball_twice_q1_times_float_q3 - ball_q0q2
    ball_R_z_y = ball_q0q1 + ball_twice_q2_times_float_q3
    ball_R_z_z = 1 - ball_q1q1 - ball_q2q2
    return (ca.vertcat(float_x, float_y, float_z),
        ca.vertcat(ball_R_x_x, ball_R_x_y, ball_R_x_z, ball_R_y_x, ball_R_y_y, ball_R_y_z, ball_R_z_x, ball_R_z_y, ball_R_z_z))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (3,): OUTPUTS
    """
    float_x, float_y, float_z = q[0], q[1], q[2]
    return ca.vertcat(float_x, float_y, float_z)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        ball_joint.ball, ball_joint.socket (4,): x [m], y [m], z [m], radius [m]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball.centre (3,): x [m], y [m], z [m]
    """
    clearance, socket_radius = p[1], p[2]
    return ca.vertcat(0, 0, 0, socket_radius - clearance), ca.vertcat(0, 0, 0, socket_radius), ca.vertcat(*[0]*5, -1), ca.vertcat(0, 0, 0)
