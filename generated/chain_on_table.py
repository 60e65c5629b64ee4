"""chain_on_table: a chain of 6 links falls onto a table. Generated from derive/scenes/chain_on_table.py.

Do not edit; regenerate with `hertzwerk derive chain_on_table`.
Effects:
    gravity: uniform gravity
    ball_0, ball_1, ball_2, ball_3, ball_4, ball_5, ball_6: power x tsuji
    ball_0_friction: smooth_coulomb at ball_0
    ball_1_friction: smooth_coulomb at ball_1
    ball_2_friction: smooth_coulomb at ball_2
    ball_3_friction: smooth_coulomb at ball_3
    ball_4_friction: smooth_coulomb at ball_4
    ball_5_friction: smooth_coulomb at ball_5
    ball_6_friction: smooth_coulomb at ball_6
    energy_ledger: work put in, energy dissipated per effect
Units: 427 assignments and 607 outputs checked, all consistent
Operations: flight 731 (equations of motion and gaps); in contact also contact_ball_0 33, contact_ball_1 45, contact_ball_2 66, contact_ball_3 87, contact_ball_4 108, contact_ball_5 129, contact_ball_6 150
"""

import casadi as ca

NAME = "chain_on_table"
SOURCE = "derive/scenes/chain_on_table.py"
SUMMARY = "a chain of 6 links falls onto a table"
FORMAT = "hertzwerk module 1"
DIGEST = "e3dcdd3c05c6a4293e7c36b7f6dc7672"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("ball_0", "contact", "power x tsuji"), ("ball_1", "contact", "power x tsuji"),
    ("ball_2", "contact", "power x tsuji"), ("ball_3", "contact", "power x tsuji"), ("ball_4", "contact", "power x tsuji"),
    ("ball_5", "contact", "power x tsuji"), ("ball_6", "contact", "power x tsuji"),
    ("ball_0_friction", "friction", "smooth_coulomb at ball_0"), ("ball_1_friction", "friction", "smooth_coulomb at ball_1"),
    ("ball_2_friction", "friction", "smooth_coulomb at ball_2"), ("ball_3_friction", "friction", "smooth_coulomb at ball_3"),
    ("ball_4_friction", "friction", "smooth_coulomb at ball_4"), ("ball_5_friction", "friction", "smooth_coulomb at ball_5"),
    ("ball_6_friction", "friction", "smooth_coulomb at ball_6"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("link_mass", "g", 5, "body link_1, mass"),
    ("link_length", "mm", 20, "body link_1, rod, length"),
    ("ball_radius", "mm", 2, "pair ball_0, radius"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^1.5", 1000000.0, "effect ball_0, stiffness of power"),
    ("restitution", "1", 0.3, "effect ball_0, coefficient of restitution of tsuji"),
    ("friction_coefficient", "1", 0.2, "effect ball_0_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.01, "effect ball_0_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("inclination", "deg", 15, "start, position of flight.angle"),
)

LIMITS = (
    ("link_mass", "defined", 0, None, True, False, "body link_1, mass"),
    ("link_length", "defined", 0, None, True, False, "body link_1, rod, length"),
    ("ball_radius", "defined", 0, None, True, False, "pair ball_0, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect ball_0, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect ball_0, coefficient of restitution of tsuji"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect ball_0_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect ball_0_friction, speed over which the friction force builds up of smooth_coulomb"),
)

COORDINATES = (
    ("flight.x", "m"), ("flight.y", "m"), ("flight.angle", "rad"), ("pin_1.angle", "rad"), ("pin_2.angle", "rad"), ("pin_3.angle", "rad"),
    ("pin_4.angle", "rad"), ("pin_5.angle", "rad"),
)

SPEEDS = (
    ("flight.x_speed", "m/s"), ("flight.y_speed", "m/s"), ("flight.angle_speed", "rad/s"), ("pin_1.speed", "rad/s"),
    ("pin_2.speed", "rad/s"), ("pin_3.speed", "rad/s"), ("pin_4.speed", "rad/s"), ("pin_5.speed", "rad/s"),
)

MEMORY = (
    ("ball_0.dissipated", "J"), ("ball_1.dissipated", "J"), ("ball_2.dissipated", "J"), ("ball_3.dissipated", "J"),
    ("ball_4.dissipated", "J"), ("ball_5.dissipated", "J"), ("ball_6.dissipated", "J"), ("ball_0_friction.dissipated", "J"),
    ("ball_1_friction.dissipated", "J"), ("ball_2_friction.dissipated", "J"), ("ball_3_friction.dissipated", "J"),
    ("ball_4_friction.dissipated", "J"), ("ball_5_friction.dissipated", "J"), ("ball_6_friction.dissipated", "J"),
)

PAIRS = (
    ("ball_0", "sphere_on_plane"), ("ball_1", "sphere_on_plane"), ("ball_2", "sphere_on_plane"), ("ball_3", "sphere_on_plane"),
    ("ball_4", "sphere_on_plane"), ("ball_5", "sphere_on_plane"), ("ball_6", "sphere_on_plane"),
)

RELEASES = ("gap", "gap", "gap", "gap", "gap", "gap", "gap")

DISSIPATED = (0, 1, 2, 3, 4, 5, 6)

OUTPUTS = (
    ("ball_0.gap", "m"), ("ball_1.gap", "m"), ("ball_2.gap", "m"), ("ball_3.gap", "m"), ("ball_4.gap", "m"), ("ball_5.gap", "m"),
    ("ball_6.gap", "m"),
)

BODIES = ("link_1", "link_2", "link_3", "link_4", "link_5", "link_6")

LANDMARKS = (
    ("flight", "planar", "parent", "ground", ("normal",)), ("flight", "planar", "child", "link_1", ("normal",)),
    ("pin_1", "revolute", "parent", "link_1", ("axis",)), ("pin_1", "revolute", "child", "link_2", ("axis",)),
    ("pin_2", "revolute", "parent", "link_2", ("axis",)), ("pin_2", "revolute", "child", "link_3", ("axis",)),
    ("pin_3", "revolute", "parent", "link_3", ("axis",)), ("pin_3", "revolute", "child", "link_4", ("axis",)),
    ("pin_4", "revolute", "parent", "link_4", ("axis",)), ("pin_4", "revolute", "child", "link_5", ("axis",)),
    ("pin_5", "revolute", "parent", "link_5", ("axis",)), ("pin_5", "revolute", "child", "link_6", ("axis",)),
    ("ball_0", "sphere_on_plane", "sphere", "link_1", ("radius",)), ("ball_0", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_1", "sphere_on_plane", "sphere", "link_1", ("radius",)), ("ball_1", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_2", "sphere_on_plane", "sphere", "link_2", ("radius",)), ("ball_2", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_3", "sphere_on_plane", "sphere", "link_3", ("radius",)), ("ball_3", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_4", "sphere_on_plane", "sphere", "link_4", ("radius",)), ("ball_4", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_5", "sphere_on_plane", "sphere", "link_5", ("radius",)), ("ball_5", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("ball_6", "sphere_on_plane", "sphere", "link_6", ("radius",)), ("ball_6", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("link_1", "body", "centre", "link_1", ()),
    ("link_2", "body", "centre", "link_2", ()), ("link_3", "body", "centre", "link_3", ()), ("link_4", "body", "centre", "link_4", ()),
    ("link_5", "body", "centre", "link_5", ()), ("link_6", "body", "centre", "link_6", ()),
    ("link_1", "solid_rod", "shape_1", "link_1", ("axis", "length")), ("link_2", "solid_rod", "shape_1", "link_2", ("axis", "length")),
    ("link_3", "solid_rod", "shape_1", "link_3", ("axis", "length")), ("link_4", "solid_rod", "shape_1", "link_4", ("axis", "length")),
    ("link_5", "solid_rod", "shape_1", "link_5", ("axis", "length")), ("link_6", "solid_rod", "shape_1", "link_6", ("axis", "length")),
)

CONSTANTS = (
    ("link_mass", "kg"), ("link_length", "m"), ("ball_radius", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m^1.5"),
    ("friction_coefficient", "1"), ("two_fifths_of_stiffness", "N/m^1.5"), ("ball_0_xi", "1"), ("inverse_friction_speed", "s/m"),
    ("link_1_total_mass", "kg"), ("link_6_h_x", "kg m"), ("link_5_h_x", "kg m"), ("link_4_h_x", "kg m"), ("link_3_h_x", "kg m"),
    ("link_2_h_x", "kg m"), ("link_1_h_x", "kg m"), ("link_1_I_z_z", "kg m^2"), ("link_2_I_z_z", "kg m^2"), ("link_3_I_z_z", "kg m^2"),
    ("link_4_I_z_z", "kg m^2"), ("link_6_I_z_z", "kg m^2"), ("link_5_I_z_z_plus_link_6_I_z_z", "kg m^2"),
    ("inverse_link_6_I_z_z", "1/(kg m^2)"), ("half_link_6_I_z_z", "kg m^2"), ("half_link_mass", "kg"), ("half_link_length", "m"),
    ("gravity_times_link_mass", "N"),
)

OPERATIONS = (
    ("constants", 50), ("start", 1), ("scales", 14), ("coordinate_rates", 0), ("gaps", 59), ("gap_accelerations", 75),
    ("contact_ball_0", 33), ("contact_ball_1", 45), ("contact_ball_2", 66), ("contact_ball_3", 87), ("contact_ball_4", 108),
    ("contact_ball_5", 129), ("contact_ball_6", 150), ("applied", 36), ("accelerations", 561), ("ledger", 0), ("energy", 247),
    ("poses", 67), ("outputs", 30), ("landmarks", 3),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = EVENTS = LOADS = FED = RUBBING = ()
GUIDES = SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def solid_rod_gaps_terms(first_apart_y, first_apart_rate_y, second_angle, third_angle, first_speed, second_speed, link_length):
    """Return first_angle [1], rate_z [1/s], second_apart_y [m], second_apart_rate_y [m/s]."""
    first_angle = second_angle + third_angle
    cos = ca.cos(first_angle)
    sin = ca.sin(first_angle)
    rate_z = first_speed + second_speed
    arm_x = link_length*cos
    arm_y = link_length*sin
    arm_rate_y = rate_z*arm_x
    second_apart_y = first_apart_y + arm_y
    second_apart_rate_y = first_apart_rate_y + arm_rate_y
    return first_angle, rate_z, second_apart_y, second_apart_rate_y


def solid_rod_gap_accelerations_terms(first_apart_acceleration_y, second_angle, third_angle, first_speed, second_speed, first_acceleration,
        second_acceleration, link_length):
    """Return first_angle [1], rate_z [1/s], angular_acceleration_z [1/s^2], second_apart_acceleration_y [m/s^2]."""
    first_angle = second_angle + third_angle
    cos = ca.cos(first_angle)
    sin = ca.sin(first_angle)
    rate_z = first_speed + second_speed
    angular_acceleration_z = first_acceleration + second_acceleration
    arm_x = link_length*cos
    arm_y = link_length*sin
    arm_rate_x = -arm_y*rate_z
    second_apart_acceleration_y = first_apart_acceleration_y + rate_z*arm_rate_x + angular_acceleration_z*arm_x
    return first_angle, rate_z, angular_acceleration_z, second_apart_acceleration_y


def sphere_on_plane_apart(cos, sin, x, y, link_length):
    """Return apart_x [m], apart_y [m]."""
    arm_x = link_length*cos
    arm_y = link_length*sin
    apart_x = x + arm_x
    apart_y = y + arm_y
    return apart_x, apart_y


def solid_rod_outputs_terms(first_apart_y, second_angle, third_angle, link_length):
    """Return first_angle [1], second_apart_y [m]."""
    first_angle = second_angle + third_angle
    sin = ca.sin(first_angle)
    arm_y = link_length*sin
    second_apart_y = first_apart_y + arm_y
    return first_angle, second_apart_y


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (27,): link_mass, link_length, ball_radius, gravity, stiffness, friction_coefficient, two_fifths_of_stiffness, ball_0_xi,
            inverse_friction_speed, link_1_total_mass, link_6_h_x, link_5_h_x, link_4_h_x, link_3_h_x, link_2_h_x, link_1_h_x, link_1_I_z_z,
            link_2_I_z_z, link_3_I_z_z, link_4_I_z_z, link_6_I_z_z, link_5_I_z_z_plus_link_6_I_z_z, inverse_link_6_I_z_z, half_link_6_I_z_z,
            half_link_mass, half_link_length, gravity_times_link_mass
    """
    link_mass, link_length, ball_radius, gravity, stiffness, restitution, friction_coefficient = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    friction_speed = p[7]
    two_fifths_of_stiffness = 2*stiffness/5
    x1 = ca.log(restitution)
    ball_0_xi = -x1*ca.sqrt(5)/ca.sqrt(3.141592653589793**2 + x1*x1)
    inverse_friction_speed = 1/friction_speed
    link_5_total_mass = 2*link_mass
    link_4_total_mass = link_5_total_mass + link_mass
    link_3_total_mass = link_4_total_mass + link_mass
    link_2_total_mass = link_3_total_mass + link_mass
    link_1_total_mass = link_2_total_mass + link_mass
    link_6_h_x = link_length*link_mass/2
    link_5_h_x = 3*link_length*link_mass/2
    link_4_h_x = link_6_h_x + link_5_total_mass*link_length
    link_3_h_x = link_6_h_x + link_4_total_mass*link_length
    link_2_h_x = link_6_h_x + link_3_total_mass*link_length
    link_1_h_x = link_6_h_x + link_2_total_mass*link_length
    link_length_squared = link_length*link_length
    link_6_I_z_z = link_length_squared*link_mass/3
    link_1_I_z_z = link_6_I_z_z + link_2_total_mass*link_length_squared
    link_2_I_z_z = link_6_I_z_z + link_3_total_mass*link_length_squared
    link_3_I_z_z = link_6_I_z_z + link_4_total_mass*link_length_squared
    link_4_I_z_z = link_6_I_z_z + link_5_total_mass*link_length_squared
    link_5_I_z_z = 4*link_length_squared*link_mass/3
    link_5_I_z_z_plus_link_6_I_z_z = link_5_I_z_z + link_6_I_z_z
    inverse_link_6_I_z_z = 1/link_6_I_z_z
    half_link_6_I_z_z = link_6_I_z_z/2
    half_link_mass = link_mass/2
    half_link_length = link_length/2
    gravity_times_link_mass = gravity*link_mass
    return ca.vertcat(link_mass, link_length, ball_radius, gravity, stiffness, friction_coefficient, two_fifths_of_stiffness, ball_0_xi,
        inverse_friction_speed, link_1_total_mass, link_6_h_x, link_5_h_x, link_4_h_x, link_3_h_x, link_2_h_x, link_1_h_x, link_1_I_z_z,
        link_2_I_z_z, link_3_I_z_z, link_4_I_z_z, link_6_I_z_z, link_5_I_z_z_plus_link_6_I_z_z, inverse_link_6_I_z_z, half_link_6_I_z_z,
        half_link_mass, half_link_length, gravity_times_link_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (8,): COORDINATES
        u (8,): SPEEDS
    """
    ball_radius, inclination = p[2], p[8]
    return ca.vertcat(0, 2*ball_radius, inclination, *[0]*5), ca.vertcat(*[0]*8)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (8,): COORDINATES
        su (8,): SPEEDS
        sz (14,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    link_mass, link_length, ball_radius, gravity = p[0], p[1], p[2], p[3]
    total_mass = 6*link_mass
    energy_scale = total_mass*gravity*link_length
    force_scale = 10*energy_scale/ball_radius
    x1 = ball_radius/10
    x2 = ball_radius/(10*link_length)
    sqrt_2 = ca.sqrt(2)
    gravity_times_link_length = gravity*link_length
    x5 = ca.sqrt(gravity_times_link_length)
    x6 = sqrt_2*x5
    x7 = sqrt_2*x5/link_length
    return (ca.vertcat(x1, x1, *[x2]*6), ca.vertcat(x6, x6, *[x7]*6), ca.vertcat(*[energy_scale]*14),
        ca.vertcat(x1, x6, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (8,): flight.x [m/s], flight.y [m/s], flight.angle [rad/s], pin_1.angle [rad/s], pin_2.angle [rad/s], pin_3.angle [rad/s],
            pin_4.angle [rad/s], pin_5.angle [rad/s]
    """
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    pin_4_speed, pin_5_speed = u[6], u[7]
    return ca.vertcat(flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed, pin_4_speed, pin_5_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (7,): PAIRS [m]
        dG (7,): PAIRS [m/s]
    """
    link_length, ball_radius = c[1], c[2]
    flight_y, flight_angle = q[1], q[2]
    flight_y_speed, flight_angle_speed = u[1], u[2]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_angle, link_2_rate_z, ball_2_apart_y, ball_2_apart_rate_y = solid_rod_gaps_terms(ball_1_apart_y, ball_1_apart_rate_y, flight_angle, q[3], flight_angle_speed, u[3], link_length)
    link_3_angle, link_3_rate_z, ball_3_apart_y, ball_3_apart_rate_y = solid_rod_gaps_terms(ball_2_apart_y, ball_2_apart_rate_y, q[4], link_2_angle, u[4], link_2_rate_z, link_length)
    link_4_angle, link_4_rate_z, ball_4_apart_y, ball_4_apart_rate_y = solid_rod_gaps_terms(ball_3_apart_y, ball_3_apart_rate_y, q[5], link_3_angle, u[5], link_3_rate_z, link_length)
    link_5_angle, link_5_rate_z, ball_5_apart_y, ball_5_apart_rate_y = solid_rod_gaps_terms(ball_4_apart_y, ball_4_apart_rate_y, q[6], link_4_angle, u[6], link_4_rate_z, link_length)
    _, _, ball_6_apart_y, ball_6_apart_rate_y = solid_rod_gaps_terms(ball_5_apart_y, ball_5_apart_rate_y, q[7], link_5_angle, u[7], link_5_rate_z, link_length)
    ball_0_gap = flight_y - ball_radius
    ball_1_gap = ball_1_apart_y - ball_radius
    ball_2_gap = ball_2_apart_y - ball_radius
    ball_3_gap = ball_3_apart_y - ball_radius
    ball_4_gap = ball_4_apart_y - ball_radius
    ball_5_gap = ball_5_apart_y - ball_radius
    ball_6_gap = ball_6_apart_y - ball_radius
    return (ca.vertcat(ball_0_gap, ball_1_gap, ball_2_gap, ball_3_gap, ball_4_gap, ball_5_gap, ball_6_gap),
        ca.vertcat(flight_y_speed, ball_1_apart_rate_y, ball_2_apart_rate_y, ball_3_apart_rate_y, ball_4_apart_rate_y, ball_5_apart_rate_y,
            ball_6_apart_rate_y))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (7,): PAIRS [m/s^2]
    """
    link_length = c[1]
    flight_angle = q[2]
    flight_angle_speed = u[2]
    flight_y_acceleration, flight_angle_acceleration = a[1], a[2]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_apart_acceleration_y = flight_y_acceleration + ball_1_first_arm_rate_x*flight_angle_speed + ball_1_first_arm_x*flight_angle_acceleration
    link_2_angle, link_2_rate_z, link_2_angular_acceleration_z, ball_2_apart_acceleration_y = solid_rod_gap_accelerations_terms(ball_1_apart_acceleration_y, flight_angle, q[3], flight_angle_speed, u[3], flight_angle_acceleration, a[3], link_length)
    link_3_angle, link_3_rate_z, link_3_angular_acceleration_z, ball_3_apart_acceleration_y = solid_rod_gap_accelerations_terms(ball_2_apart_acceleration_y, q[4], link_2_angle, u[4], link_2_rate_z, a[4], link_2_angular_acceleration_z, link_length)
    link_4_angle, link_4_rate_z, link_4_angular_acceleration_z, ball_4_apart_acceleration_y = solid_rod_gap_accelerations_terms(ball_3_apart_acceleration_y, q[5], link_3_angle, u[5], link_3_rate_z, a[5], link_3_angular_acceleration_z, link_length)
    link_5_angle, link_5_rate_z, link_5_angular_acceleration_z, ball_5_apart_acceleration_y = solid_rod_gap_accelerations_terms(ball_4_apart_acceleration_y, q[6], link_4_angle, u[6], link_4_rate_z, a[6], link_4_angular_acceleration_z, link_length)
    _, _, _, ball_6_apart_acceleration_y = solid_rod_gap_accelerations_terms(ball_5_apart_acceleration_y, q[7], link_5_angle, u[7], link_5_rate_z, a[7], link_5_angular_acceleration_z, link_length)
    return ca.vertcat(flight_y_acceleration, ball_1_apart_acceleration_y, ball_2_apart_acceleration_y, ball_3_apart_acceleration_y,
        ball_4_apart_acceleration_y, ball_5_apart_acceleration_y, ball_6_apart_acceleration_y)


def contact_ball_0(t, q, u, z, m, c):
    """Forces of ball_0: power x tsuji, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the contact
    ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (8,): flight.x [N], flight.y [N], flight.angle [N m], pin_1 [N m], pin_2 [N m], pin_3 [N m], pin_4 [N m], pin_5 [N m]
        dz (14,): MEMORY [W]
        normal_force (1,): ball_0 [N]
        sliding_velocity (1,): ball_0 [m/s]
        in_range (1,): ball_0 [1]
    """
    link_mass, ball_radius, stiffness, friction_coefficient, ball_0_xi, inverse_friction_speed = c[0], c[2], c[4], c[5], c[7], c[8]
    flight_y = q[1]
    flight_x_speed, flight_y_speed, flight_angle_speed = u[0], u[1], u[2]
    ball_0_gap = flight_y - ball_radius
    ball_0_elastic_force = ca.if_else(-ball_0_gap > 0, -ball_0_gap*ca.sqrt(-ball_0_gap)*stiffness, 0)
    base = -ball_0_elastic_force*link_mass/ball_0_gap
    ball_0_resistance = ca.if_else(-ball_0_gap > 0, -ball_0_xi*flight_y_speed*ca.sqrt(base), 0)
    ball_0_normal_force = ball_0_elastic_force + ball_0_resistance
    ball_0_normal_power = -ball_0_resistance*flight_y_speed
    ball_0_pressing_force = ca.if_else(ball_0_normal_force > 0, ball_0_normal_force, 0)
    ball_0_sliding_velocity = -flight_x_speed - flight_angle_speed*ball_radius
    ball_0_friction_force = ball_0_pressing_force*friction_coefficient*ca.tanh(ball_0_sliding_velocity*inverse_friction_speed)
    ball_0_friction_power = ball_0_friction_force*ball_0_sliding_velocity
    ball_0_drag_on_flight_angle = ball_0_friction_force*ball_radius
    return (ca.vertcat(ball_0_friction_force, ball_0_normal_force, ball_0_drag_on_flight_angle, *[0]*5),
        ca.vertcat(ball_0_normal_power, *[0]*6, ball_0_friction_power, *[0]*6), ca.vertcat(ball_0_normal_force),
        ca.vertcat(ball_0_sliding_velocity), ca.vertcat(1))


def contact_ball_1(t, q, u, z, m, c):
    """Forces of ball_1: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_y, flight_angle = q[1], q[2]
    flight_x_speed, flight_y_speed, flight_angle_speed = u[0], u[1], u[2]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_gap = ball_1_apart_y - ball_radius
    ball_1_elastic_force = ca.if_else(-ball_1_gap > 0, -ball_1_gap*ca.sqrt(-ball_1_gap)*stiffness, 0)
    ball_1_relative_rate_x = flight_x_speed - ball_1_first_arm_y*flight_angle_speed
    ball_1_relative_rate_y = flight_y_speed + ball_1_first_arm_x*flight_angle_speed
    base_2 = -ball_1_elastic_force*link_mass/ball_1_gap
    ball_1_resistance = ca.if_else(-ball_1_gap > 0, -ball_0_xi*ball_1_relative_rate_y*ca.sqrt(base_2), 0)
    ball_1_normal_force = ball_1_elastic_force + ball_1_resistance
    ball_1_normal_power = -ball_1_relative_rate_y*ball_1_resistance
    ball_1_push_on_flight_angle = ball_1_first_arm_x*ball_1_normal_force
    ball_1_pressing_force = ca.if_else(ball_1_normal_force > 0, ball_1_normal_force, 0)
    ball_1_sliding_velocity = -ball_1_relative_rate_x - flight_angle_speed*ball_radius
    ball_1_friction_force = ball_1_pressing_force*friction_coefficient*ca.tanh(ball_1_sliding_velocity*inverse_friction_speed)
    ball_1_friction_power = ball_1_friction_force*ball_1_sliding_velocity
    ball_1_drag_on_flight_angle = ball_1_friction_force*(ball_radius - ball_1_first_arm_y)
    return (ca.vertcat(ball_1_friction_force, ball_1_normal_force, ball_1_drag_on_flight_angle + ball_1_push_on_flight_angle, *[0]*5),
        ca.vertcat(0, ball_1_normal_power, *[0]*6, ball_1_friction_power, *[0]*5), ca.vertcat(ball_1_normal_force),
        ca.vertcat(ball_1_sliding_velocity), ca.vertcat(1))


def contact_ball_2(t, q, u, z, m, c):
    """Forces of ball_2: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_x, flight_y, flight_angle, pin_1_angle = q[0], q[1], q[2], q[3]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed = u[0], u[1], u[2], u[3]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_x = ball_1_first_arm_x + flight_x
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_x = ball_1_first_arm_rate_x + flight_x_speed
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    ball_2_gap = ball_2_apart_y - ball_radius
    ball_2_elastic_force = ca.if_else(-ball_2_gap > 0, -ball_2_gap*ca.sqrt(-ball_2_gap)*stiffness, 0)
    ball_2_relative_rate_x = ball_1_apart_rate_x - ball_2_first_arm_y*link_2_rate_z
    ball_2_relative_rate_y = ball_1_apart_rate_y + ball_2_first_arm_x*link_2_rate_z
    base_3 = -ball_2_elastic_force*link_mass/ball_2_gap
    ball_2_resistance = ca.if_else(-ball_2_gap > 0, -ball_0_xi*ball_2_relative_rate_y*ca.sqrt(base_3), 0)
    ball_2_normal_force = ball_2_elastic_force + ball_2_resistance
    ball_2_normal_power = -ball_2_relative_rate_y*ball_2_resistance
    ball_2_push_on_flight_angle = ball_2_normal_force*(ball_1_apart_x + ball_2_first_arm_x - flight_x)
    ball_2_push_on_pin_1 = ball_2_first_arm_x*ball_2_normal_force
    ball_2_pressing_force = ca.if_else(ball_2_normal_force > 0, ball_2_normal_force, 0)
    ball_2_sliding_velocity = -ball_2_relative_rate_x - link_2_rate_z*ball_radius
    ball_2_friction_force = ball_2_pressing_force*friction_coefficient*ca.tanh(ball_2_sliding_velocity*inverse_friction_speed)
    ball_2_friction_power = ball_2_friction_force*ball_2_sliding_velocity
    ball_2_drag_on_flight_angle = ball_2_friction_force*(flight_y + ball_radius - ball_1_apart_y - ball_2_first_arm_y)
    ball_2_drag_on_pin_1 = ball_2_friction_force*(ball_radius - ball_2_first_arm_y)
    return (ca.vertcat(ball_2_friction_force, ball_2_normal_force, ball_2_drag_on_flight_angle + ball_2_push_on_flight_angle,
            ball_2_drag_on_pin_1 + ball_2_push_on_pin_1, 0, 0, 0, 0),
        ca.vertcat(0, 0, ball_2_normal_power, *[0]*6, ball_2_friction_power, 0, 0, 0, 0), ca.vertcat(ball_2_normal_force),
        ca.vertcat(ball_2_sliding_velocity), ca.vertcat(1))


def contact_ball_3(t, q, u, z, m, c):
    """Forces of ball_3: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_x, flight_y, flight_angle, pin_1_angle, pin_2_angle = q[0], q[1], q[2], q[3], q[4]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed = u[0], u[1], u[2], u[3], u[4]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_x = ball_1_first_arm_x + flight_x
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_x = ball_1_first_arm_rate_x + flight_x_speed
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_first_arm_rate_x = -ball_2_first_arm_y*link_2_rate_z
    ball_2_first_arm_rate_y = ball_2_first_arm_x*link_2_rate_z
    ball_2_apart_x = ball_1_apart_x + ball_2_first_arm_x
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    ball_2_apart_rate_x = ball_1_apart_rate_x + ball_2_first_arm_rate_x
    ball_2_apart_rate_y = ball_1_apart_rate_y + ball_2_first_arm_rate_y
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    ball_3_apart_y = ball_2_apart_y + ball_3_first_arm_y
    ball_3_gap = ball_3_apart_y - ball_radius
    ball_3_elastic_force = ca.if_else(-ball_3_gap > 0, -ball_3_gap*ca.sqrt(-ball_3_gap)*stiffness, 0)
    ball_3_relative_rate_x = ball_2_apart_rate_x - ball_3_first_arm_y*link_3_rate_z
    ball_3_relative_rate_y = ball_2_apart_rate_y + ball_3_first_arm_x*link_3_rate_z
    base_4 = -ball_3_elastic_force*link_mass/ball_3_gap
    ball_3_resistance = ca.if_else(-ball_3_gap > 0, -ball_0_xi*ball_3_relative_rate_y*ca.sqrt(base_4), 0)
    ball_3_normal_force = ball_3_elastic_force + ball_3_resistance
    ball_3_normal_power = -ball_3_relative_rate_y*ball_3_resistance
    ball_3_push_on_flight_angle = ball_3_normal_force*(ball_2_apart_x + ball_3_first_arm_x - flight_x)
    ball_3_push_on_pin_1 = ball_3_normal_force*(ball_2_apart_x + ball_3_first_arm_x - ball_1_apart_x)
    ball_3_push_on_pin_2 = ball_3_first_arm_x*ball_3_normal_force
    ball_3_pressing_force = ca.if_else(ball_3_normal_force > 0, ball_3_normal_force, 0)
    ball_3_sliding_velocity = -ball_3_relative_rate_x - link_3_rate_z*ball_radius
    ball_3_friction_force = ball_3_pressing_force*friction_coefficient*ca.tanh(ball_3_sliding_velocity*inverse_friction_speed)
    ball_3_friction_power = ball_3_friction_force*ball_3_sliding_velocity
    ball_3_drag_on_flight_angle = ball_3_friction_force*(flight_y + ball_radius - ball_2_apart_y - ball_3_first_arm_y)
    ball_3_drag_on_pin_1 = ball_3_friction_force*(ball_1_apart_y + ball_radius - ball_2_apart_y - ball_3_first_arm_y)
    ball_3_drag_on_pin_2 = ball_3_friction_force*(ball_radius - ball_3_first_arm_y)
    return (ca.vertcat(ball_3_friction_force, ball_3_normal_force, ball_3_drag_on_flight_angle + ball_3_push_on_flight_angle,
            ball_3_drag_on_pin_1 + ball_3_push_on_pin_1, ball_3_drag_on_pin_2 + ball_3_push_on_pin_2, 0, 0, 0),
        ca.vertcat(0, 0, 0, ball_3_normal_power, *[0]*6, ball_3_friction_power, 0, 0, 0), ca.vertcat(ball_3_normal_force),
        ca.vertcat(ball_3_sliding_velocity), ca.vertcat(1))


def contact_ball_4(t, q, u, z, m, c):
    """Forces of ball_4: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_x, flight_y, flight_angle, pin_1_angle, pin_2_angle, pin_3_angle = q[0], q[1], q[2], q[3], q[4], q[5]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_x = ball_1_first_arm_x + flight_x
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_x = ball_1_first_arm_rate_x + flight_x_speed
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_first_arm_rate_x = -ball_2_first_arm_y*link_2_rate_z
    ball_2_first_arm_rate_y = ball_2_first_arm_x*link_2_rate_z
    ball_2_apart_x = ball_1_apart_x + ball_2_first_arm_x
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    ball_2_apart_rate_x = ball_1_apart_rate_x + ball_2_first_arm_rate_x
    ball_2_apart_rate_y = ball_1_apart_rate_y + ball_2_first_arm_rate_y
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    ball_3_first_arm_rate_x = -ball_3_first_arm_y*link_3_rate_z
    ball_3_first_arm_rate_y = ball_3_first_arm_x*link_3_rate_z
    ball_3_apart_x = ball_2_apart_x + ball_3_first_arm_x
    ball_3_apart_y = ball_2_apart_y + ball_3_first_arm_y
    ball_3_apart_rate_x = ball_2_apart_rate_x + ball_3_first_arm_rate_x
    ball_3_apart_rate_y = ball_2_apart_rate_y + ball_3_first_arm_rate_y
    link_4_rate_z = link_3_rate_z + pin_3_speed
    ball_4_first_arm_x = cos_link_4*link_length
    ball_4_first_arm_y = sin_link_4*link_length
    ball_4_apart_y = ball_3_apart_y + ball_4_first_arm_y
    ball_4_gap = ball_4_apart_y - ball_radius
    ball_4_elastic_force = ca.if_else(-ball_4_gap > 0, -ball_4_gap*ca.sqrt(-ball_4_gap)*stiffness, 0)
    ball_4_relative_rate_x = ball_3_apart_rate_x - ball_4_first_arm_y*link_4_rate_z
    ball_4_relative_rate_y = ball_3_apart_rate_y + ball_4_first_arm_x*link_4_rate_z
    base_5 = -ball_4_elastic_force*link_mass/ball_4_gap
    ball_4_resistance = ca.if_else(-ball_4_gap > 0, -ball_0_xi*ball_4_relative_rate_y*ca.sqrt(base_5), 0)
    ball_4_normal_force = ball_4_elastic_force + ball_4_resistance
    ball_4_normal_power = -ball_4_relative_rate_y*ball_4_resistance
    ball_4_push_on_flight_angle = ball_4_normal_force*(ball_3_apart_x + ball_4_first_arm_x - flight_x)
    ball_4_push_on_pin_1 = ball_4_normal_force*(ball_3_apart_x + ball_4_first_arm_x - ball_1_apart_x)
    ball_4_push_on_pin_2 = ball_4_normal_force*(ball_3_apart_x + ball_4_first_arm_x - ball_2_apart_x)
    ball_4_push_on_pin_3 = ball_4_first_arm_x*ball_4_normal_force
    ball_4_pressing_force = ca.if_else(ball_4_normal_force > 0, ball_4_normal_force, 0)
    ball_4_sliding_velocity = -ball_4_relative_rate_x - link_4_rate_z*ball_radius
    ball_4_friction_force = ball_4_pressing_force*friction_coefficient*ca.tanh(ball_4_sliding_velocity*inverse_friction_speed)
    ball_4_friction_power = ball_4_friction_force*ball_4_sliding_velocity
    ball_4_drag_on_flight_angle = ball_4_friction_force*(flight_y + ball_radius - ball_3_apart_y - ball_4_first_arm_y)
    ball_4_drag_on_pin_1 = ball_4_friction_force*(ball_1_apart_y + ball_radius - ball_3_apart_y - ball_4_first_arm_y)
    ball_4_drag_on_pin_2 = ball_4_friction_force*(ball_2_apart_y + ball_radius - ball_3_apart_y - ball_4_first_arm_y)
    ball_4_drag_on_pin_3 = ball_4_friction_force*(ball_radius - ball_4_first_arm_y)
    return (ca.vertcat(ball_4_friction_force, ball_4_normal_force, ball_4_drag_on_flight_angle + ball_4_push_on_flight_angle,
            ball_4_drag_on_pin_1 + ball_4_push_on_pin_1, ball_4_drag_on_pin_2 + ball_4_push_on_pin_2, ball_4_drag_on_pin_3 +
            ball_4_push_on_pin_3, 0, 0),
        ca.vertcat(0, 0, 0, 0, ball_4_normal_power, *[0]*6, ball_4_friction_power, 0, 0), ca.vertcat(ball_4_normal_force),
        ca.vertcat(ball_4_sliding_velocity), ca.vertcat(1))


def contact_ball_5(t, q, u, z, m, c):
    """Forces of ball_5: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_x, flight_y, flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    pin_4_speed = u[6]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    sin_link_5 = ca.sin(link_5_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_x = ball_1_first_arm_x + flight_x
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_x = ball_1_first_arm_rate_x + flight_x_speed
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_first_arm_rate_x = -ball_2_first_arm_y*link_2_rate_z
    ball_2_first_arm_rate_y = ball_2_first_arm_x*link_2_rate_z
    ball_2_apart_x = ball_1_apart_x + ball_2_first_arm_x
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    ball_2_apart_rate_x = ball_1_apart_rate_x + ball_2_first_arm_rate_x
    ball_2_apart_rate_y = ball_1_apart_rate_y + ball_2_first_arm_rate_y
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    ball_3_first_arm_rate_x = -ball_3_first_arm_y*link_3_rate_z
    ball_3_first_arm_rate_y = ball_3_first_arm_x*link_3_rate_z
    ball_3_apart_x = ball_2_apart_x + ball_3_first_arm_x
    ball_3_apart_y = ball_2_apart_y + ball_3_first_arm_y
    ball_3_apart_rate_x = ball_2_apart_rate_x + ball_3_first_arm_rate_x
    ball_3_apart_rate_y = ball_2_apart_rate_y + ball_3_first_arm_rate_y
    link_4_rate_z = link_3_rate_z + pin_3_speed
    ball_4_first_arm_x = cos_link_4*link_length
    ball_4_first_arm_y = sin_link_4*link_length
    ball_4_first_arm_rate_x = -ball_4_first_arm_y*link_4_rate_z
    ball_4_first_arm_rate_y = ball_4_first_arm_x*link_4_rate_z
    ball_4_apart_x = ball_3_apart_x + ball_4_first_arm_x
    ball_4_apart_y = ball_3_apart_y + ball_4_first_arm_y
    ball_4_apart_rate_x = ball_3_apart_rate_x + ball_4_first_arm_rate_x
    ball_4_apart_rate_y = ball_3_apart_rate_y + ball_4_first_arm_rate_y
    link_5_rate_z = link_4_rate_z + pin_4_speed
    ball_5_first_arm_x = cos_link_5*link_length
    ball_5_first_arm_y = sin_link_5*link_length
    ball_5_apart_y = ball_4_apart_y + ball_5_first_arm_y
    ball_5_gap = ball_5_apart_y - ball_radius
    ball_5_elastic_force = ca.if_else(-ball_5_gap > 0, -ball_5_gap*ca.sqrt(-ball_5_gap)*stiffness, 0)
    ball_5_relative_rate_x = ball_4_apart_rate_x - ball_5_first_arm_y*link_5_rate_z
    ball_5_relative_rate_y = ball_4_apart_rate_y + ball_5_first_arm_x*link_5_rate_z
    base_6 = -ball_5_elastic_force*link_mass/ball_5_gap
    ball_5_resistance = ca.if_else(-ball_5_gap > 0, -ball_0_xi*ball_5_relative_rate_y*ca.sqrt(base_6), 0)
    ball_5_normal_force = ball_5_elastic_force + ball_5_resistance
    ball_5_normal_power = -ball_5_relative_rate_y*ball_5_resistance
    ball_5_push_on_flight_angle = ball_5_normal_force*(ball_4_apart_x + ball_5_first_arm_x - flight_x)
    ball_5_push_on_pin_1 = ball_5_normal_force*(ball_4_apart_x + ball_5_first_arm_x - ball_1_apart_x)
    ball_5_push_on_pin_2 = ball_5_normal_force*(ball_4_apart_x + ball_5_first_arm_x - ball_2_apart_x)
    ball_5_push_on_pin_3 = ball_5_normal_force*(ball_4_apart_x + ball_5_first_arm_x - ball_3_apart_x)
    ball_5_push_on_pin_4 = ball_5_first_arm_x*ball_5_normal_force
    ball_5_pressing_force = ca.if_else(ball_5_normal_force > 0, ball_5_normal_force, 0)
    ball_5_sliding_velocity = -ball_5_relative_rate_x - link_5_rate_z*ball_radius
    ball_5_friction_force = ball_5_pressing_force*friction_coefficient*ca.tanh(ball_5_sliding_velocity*inverse_friction_speed)
    ball_5_friction_power = ball_5_friction_force*ball_5_sliding_velocity
    ball_5_drag_on_flight_angle = ball_5_friction_force*(flight_y + ball_radius - ball_4_apart_y - ball_5_first_arm_y)
    ball_5_drag_on_pin_1 = ball_5_friction_force*(ball_1_apart_y + ball_radius - ball_4_apart_y - ball_5_first_arm_y)
    ball_5_drag_on_pin_2 = ball_5_friction_force*(ball_2_apart_y + ball_radius - ball_4_apart_y - ball_5_first_arm_y)
    ball_5_drag_on_pin_3 = ball_5_friction_force*(ball_3_apart_y + ball_radius - ball_4_apart_y - ball_5_first_arm_y)
    ball_5_drag_on_pin_4 = ball_5_friction_force*(ball_radius - ball_5_first_arm_y)
    return (ca.vertcat(ball_5_friction_force, ball_5_normal_force, ball_5_drag_on_flight_angle + ball_5_push_on_flight_angle,
            ball_5_drag_on_pin_1 + ball_5_push_on_pin_1, ball_5_drag_on_pin_2 + ball_5_push_on_pin_2, ball_5_drag_on_pin_3 +
            ball_5_push_on_pin_3, ball_5_drag_on_pin_4 + ball_5_push_on_pin_4, 0),
        ca.vertcat(*[0]*5, ball_5_normal_power, *[0]*6, ball_5_friction_power, 0), ca.vertcat(ball_5_normal_force),
        ca.vertcat(ball_5_sliding_velocity), ca.vertcat(1))


def contact_ball_6(t, q, u, z, m, c):
    """Forces of ball_6: power x tsuji, smooth_coulomb; arguments and returns as of contact_ball_0."""
    link_mass, link_length, ball_radius, stiffness, friction_coefficient, ball_0_xi = c[0], c[1], c[2], c[4], c[5], c[7]
    inverse_friction_speed = c[8]
    flight_x, flight_y, flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    pin_5_angle = q[7]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    pin_4_speed, pin_5_speed = u[6], u[7]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    sin_link_5 = ca.sin(link_5_angle)
    link_6_angle = link_5_angle + pin_5_angle
    cos_link_6 = ca.cos(link_6_angle)
    sin_link_6 = ca.sin(link_6_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_first_arm_rate_x = -ball_1_first_arm_y*flight_angle_speed
    ball_1_first_arm_rate_y = ball_1_first_arm_x*flight_angle_speed
    ball_1_apart_x = ball_1_first_arm_x + flight_x
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    ball_1_apart_rate_x = ball_1_first_arm_rate_x + flight_x_speed
    ball_1_apart_rate_y = ball_1_first_arm_rate_y + flight_y_speed
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_first_arm_rate_x = -ball_2_first_arm_y*link_2_rate_z
    ball_2_first_arm_rate_y = ball_2_first_arm_x*link_2_rate_z
    ball_2_apart_x = ball_1_apart_x + ball_2_first_arm_x
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    ball_2_apart_rate_x = ball_1_apart_rate_x + ball_2_first_arm_rate_x
    ball_2_apart_rate_y = ball_1_apart_rate_y + ball_2_first_arm_rate_y
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    ball_3_first_arm_rate_x = -ball_3_first_arm_y*link_3_rate_z
    ball_3_first_arm_rate_y = ball_3_first_arm_x*link_3_rate_z
    ball_3_apart_x = ball_2_apart_x + ball_3_first_arm_x
    ball_3_apart_y = ball_2_apart_y + ball_3_first_arm_y
    ball_3_apart_rate_x = ball_2_apart_rate_x + ball_3_first_arm_rate_x
    ball_3_apart_rate_y = ball_2_apart_rate_y + ball_3_first_arm_rate_y
    link_4_rate_z = link_3_rate_z + pin_3_speed
    ball_4_first_arm_x = cos_link_4*link_length
    ball_4_first_arm_y = sin_link_4*link_length
    ball_4_first_arm_rate_x = -ball_4_first_arm_y*link_4_rate_z
    ball_4_first_arm_rate_y = ball_4_first_arm_x*link_4_rate_z
    ball_4_apart_x = ball_3_apart_x + ball_4_first_arm_x
    ball_4_apart_y = ball_3_apart_y + ball_4_first_arm_y
    ball_4_apart_rate_x = ball_3_apart_rate_x + ball_4_first_arm_rate_x
    ball_4_apart_rate_y = ball_3_apart_rate_y + ball_4_first_arm_rate_y
    link_5_rate_z = link_4_rate_z + pin_4_speed
    ball_5_first_arm_x = cos_link_5*link_length
    ball_5_first_arm_y = sin_link_5*link_length
    ball_5_first_arm_rate_x = -ball_5_first_arm_y*link_5_rate_z
    ball_5_first_arm_rate_y = ball_5_first_arm_x*link_5_rate_z
    ball_5_apart_x = ball_4_apart_x + ball_5_first_arm_x
    ball_5_apart_y = ball_4_apart_y + ball_5_first_arm_y
    ball_5_apart_rate_x = ball_4_apart_rate_x + ball_5_first_arm_rate_x
    ball_5_apart_rate_y = ball_4_apart_rate_y + ball_5_first_arm_rate_y
    link_6_rate_z = link_5_rate_z + pin_5_speed
    ball_6_first_arm_x = cos_link_6*link_length
    ball_6_first_arm_y = sin_link_6*link_length
    ball_6_apart_y = ball_5_apart_y + ball_6_first_arm_y
    ball_6_gap = ball_6_apart_y - ball_radius
    ball_6_elastic_force = ca.if_else(-ball_6_gap > 0, -ball_6_gap*ca.sqrt(-ball_6_gap)*stiffness, 0)
    ball_6_relative_rate_x = ball_5_apart_rate_x - ball_6_first_arm_y*link_6_rate_z
    ball_6_relative_rate_y = ball_5_apart_rate_y + ball_6_first_arm_x*link_6_rate_z
    base_7 = -ball_6_elastic_force*link_mass/ball_6_gap
    ball_6_resistance = ca.if_else(-ball_6_gap > 0, -ball_0_xi*ball_6_relative_rate_y*ca.sqrt(base_7), 0)
    ball_6_normal_force = ball_6_elastic_force + ball_6_resistance
    ball_6_normal_power = -ball_6_relative_rate_y*ball_6_resistance
    ball_6_push_on_flight_angle = ball_6_normal_force*(ball_5_apart_x + ball_6_first_arm_x - flight_x)
    ball_6_push_on_pin_1 = ball_6_normal_force*(ball_5_apart_x + ball_6_first_arm_x - ball_1_apart_x)
    ball_6_push_on_pin_2 = ball_6_normal_force*(ball_5_apart_x + ball_6_first_arm_x - ball_2_apart_x)
    ball_6_push_on_pin_3 = ball_6_normal_force*(ball_5_apart_x + ball_6_first_arm_x - ball_3_apart_x)
    ball_6_push_on_pin_4 = ball_6_normal_force*(ball_5_apart_x + ball_6_first_arm_x - ball_4_apart_x)
    ball_6_push_on_pin_5 = ball_6_first_arm_x*ball_6_normal_force
    ball_6_pressing_force = ca.if_else(ball_6_normal_force > 0, ball_6_normal_force, 0)
    ball_6_sliding_velocity = -ball_6_relative_rate_x - link_6_rate_z*ball_radius
    ball_6_friction_force = ball_6_pressing_force*friction_coefficient*ca.tanh(ball_6_sliding_velocity*inverse_friction_speed)
    ball_6_friction_power = ball_6_friction_force*ball_6_sliding_velocity
    ball_6_drag_on_flight_angle = ball_6_friction_force*(flight_y + ball_radius - ball_5_apart_y - ball_6_first_arm_y)
    ball_6_drag_on_pin_1 = ball_6_friction_force*(ball_1_apart_y + ball_radius - ball_5_apart_y - ball_6_first_arm_y)
    ball_6_drag_on_pin_2 = ball_6_friction_force*(ball_2_apart_y + ball_radius - ball_5_apart_y - ball_6_first_arm_y)
    ball_6_drag_on_pin_3 = ball_6_friction_force*(ball_3_apart_y + ball_radius - ball_5_apart_y - ball_6_first_arm_y)
    ball_6_drag_on_pin_4 = ball_6_friction_force*(ball_4_apart_y + ball_radius - ball_5_apart_y - ball_6_first_arm_y)
    ball_6_drag_on_pin_5 = ball_6_friction_force*(ball_radius - ball_6_first_arm_y)
    return (ca.vertcat(ball_6_friction_force, ball_6_normal_force, ball_6_drag_on_flight_angle + ball_6_push_on_flight_angle,
            ball_6_drag_on_pin_1 + ball_6_push_on_pin_1, ball_6_drag_on_pin_2 + ball_6_push_on_pin_2, ball_6_drag_on_pin_3 +
            ball_6_push_on_pin_3, ball_6_drag_on_pin_4 + ball_6_push_on_pin_4, ball_6_drag_on_pin_5 + ball_6_push_on_pin_5),
        ca.vertcat(*[0]*6, ball_6_normal_power, *[0]*6, ball_6_friction_power), ca.vertcat(ball_6_normal_force),
        ca.vertcat(ball_6_sliding_velocity), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (8,): flight.x [N], flight.y [N], flight.angle [N m], pin_1 [N m], pin_2 [N m], pin_3 [N m], pin_4 [N m], pin_5 [N m]
    """
    gravity, link_1_total_mass, link_6_h_x, link_5_h_x, link_4_h_x, link_3_h_x, link_2_h_x = c[3], c[9], c[10], c[11], c[12], c[13], c[14]
    link_1_h_x = c[15]
    flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle, pin_5_angle = q[2], q[3], q[4], q[5], q[6], q[7]
    cos_link_1 = ca.cos(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    link_6_angle = link_5_angle + pin_5_angle
    cos_link_6 = ca.cos(link_6_angle)
    link_6_moment_x = cos_link_6*link_6_h_x
    link_5_moment_x = cos_link_5*link_5_h_x
    link_5_total_moment_x = link_5_moment_x + link_6_moment_x
    link_4_moment_x = cos_link_4*link_4_h_x
    link_4_total_moment_x = link_4_moment_x + link_5_total_moment_x
    link_3_moment_x = cos_link_3*link_3_h_x
    link_3_total_moment_x = link_3_moment_x + link_4_total_moment_x
    link_2_moment_x = cos_link_2*link_2_h_x
    link_2_total_moment_x = link_2_moment_x + link_3_total_moment_x
    link_1_moment_x = cos_link_1*link_1_h_x
    link_1_total_moment_x = link_1_moment_x + link_2_total_moment_x
    return ca.vertcat(0, -link_1_total_mass*gravity, -link_1_total_moment_x*gravity, -link_2_total_moment_x*gravity,
        -link_3_total_moment_x*gravity, -link_4_total_moment_x*gravity, -link_5_total_moment_x*gravity, -link_6_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (8,): flight.x_acceleration [m/s^2], flight.y_acceleration [m/s^2], flight.angle_acceleration [rad/s^2], pin_1.acceleration
            [rad/s^2], pin_2.acceleration [rad/s^2], pin_3.acceleration [rad/s^2], pin_4.acceleration [rad/s^2], pin_5.acceleration
            [rad/s^2]
        reactions (0,): empty
    """
    link_length, link_1_total_mass, link_6_h_x, link_5_h_x, link_4_h_x, link_3_h_x = c[1], c[9], c[10], c[11], c[12], c[13]
    link_2_h_x, link_1_h_x, link_1_I_z_z, link_2_I_z_z, link_3_I_z_z, link_4_I_z_z = c[14], c[15], c[16], c[17], c[18], c[19]
    link_6_I_z_z, link_5_I_z_z_plus_link_6_I_z_z, inverse_link_6_I_z_z = c[20], c[21], c[22]
    flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle, pin_5_angle = q[2], q[3], q[4], q[5], q[6], q[7]
    flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed, pin_4_speed, pin_5_speed = u[2], u[3], u[4], u[5], u[6], u[7]
    flight_x_force, flight_y_force, flight_angle_force, pin_1_force, pin_2_force, pin_3_force = f[0], f[1], f[2], f[3], f[4], f[5]
    pin_4_force, pin_5_force = f[6], f[7]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    sin_link_5 = ca.sin(link_5_angle)
    link_6_angle = link_5_angle + pin_5_angle
    cos_link_6 = ca.cos(link_6_angle)
    sin_link_6 = ca.sin(link_6_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    link_4_rate_z = link_3_rate_z + pin_3_speed
    ball_4_first_arm_x = cos_link_4*link_length
    ball_4_first_arm_y = sin_link_4*link_length
    link_5_rate_z = link_4_rate_z + pin_4_speed
    ball_5_first_arm_x = cos_link_5*link_length
    ball_5_first_arm_y = sin_link_5*link_length
    link_6_rate_z = link_5_rate_z + pin_5_speed
    link_6_moment_x = cos_link_6*link_6_h_x
    link_6_moment_y = link_6_h_x*sin_link_6
    link_5_moment_x = cos_link_5*link_5_h_x
    link_5_moment_y = link_5_h_x*sin_link_5
    link_5_total_moment_x = link_5_moment_x + link_6_moment_x
    link_5_total_moment_y = link_5_moment_y + link_6_moment_y
    link_4_moment_x = cos_link_4*link_4_h_x
    link_4_moment_y = link_4_h_x*sin_link_4
    link_4_total_moment_x = link_4_moment_x + link_5_total_moment_x
    link_4_total_moment_y = link_4_moment_y + link_5_total_moment_y
    link_3_moment_x = cos_link_3*link_3_h_x
    link_3_moment_y = link_3_h_x*sin_link_3
    link_3_total_moment_x = link_3_moment_x + link_4_total_moment_x
    link_3_total_moment_y = link_3_moment_y + link_4_total_moment_y
    link_2_moment_x = cos_link_2*link_2_h_x
    link_2_moment_y = link_2_h_x*sin_link_2
    link_2_total_moment_x = link_2_moment_x + link_3_total_moment_x
    link_2_total_moment_y = link_2_moment_y + link_3_total_moment_y
    link_1_moment_x = cos_link_1*link_1_h_x
    link_1_moment_y = link_1_h_x*sin_link_1
    link_1_total_moment_x = link_1_moment_x + link_2_total_moment_x
    link_1_total_moment_y = link_1_moment_y + link_2_total_moment_y
    link_6_rate_zz = link_6_rate_z*link_6_rate_z
    link_6_force_x = -link_6_moment_x*link_6_rate_zz
    link_6_force_y = -link_6_moment_y*link_6_rate_zz
    link_5_rate_zz = link_5_rate_z*link_5_rate_z
    link_5_force_x = link_6_force_x - link_5_moment_x*link_5_rate_zz
    link_5_force_y = link_6_force_y - link_5_moment_y*link_5_rate_zz
    link_4_rate_zz = link_4_rate_z*link_4_rate_z
    link_4_force_x = link_5_force_x - link_4_moment_x*link_4_rate_zz
    link_4_force_y = link_5_force_y - link_4_moment_y*link_4_rate_zz
    link_3_rate_zz = link_3_rate_z*link_3_rate_z
    link_3_force_x = link_4_force_x - link_3_moment_x*link_3_rate_zz
    link_3_force_y = link_4_force_y - link_3_moment_y*link_3_rate_zz
    link_2_rate_zz = link_2_rate_z*link_2_rate_z
    link_2_force_x = link_3_force_x - link_2_moment_x*link_2_rate_zz
    link_2_force_y = link_3_force_y - link_2_moment_y*link_2_rate_zz
    link_1_rate_zz = flight_angle_speed*flight_angle_speed
    link_1_force_x = link_2_force_x - link_1_moment_x*link_1_rate_zz
    link_1_force_y = link_2_force_y - link_1_moment_y*link_1_rate_zz
    flight_x_net = flight_x_force - link_1_force_x
    flight_y_net = flight_y_force - link_1_force_y
    link_2_bias_x = -ball_1_first_arm_x*link_1_rate_zz
    link_2_bias_y = -ball_1_first_arm_y*link_1_rate_zz
    link_3_bias_x = link_2_bias_x - ball_2_first_arm_x*link_2_rate_zz
    link_3_bias_y = link_2_bias_y - ball_2_first_arm_y*link_2_rate_zz
    link_4_bias_x = link_3_bias_x - ball_3_first_arm_x*link_3_rate_zz
    link_4_bias_y = link_3_bias_y - ball_3_first_arm_y*link_3_rate_zz
    link_5_bias_x = link_4_bias_x - ball_4_first_arm_x*link_4_rate_zz
    link_5_bias_y = link_4_bias_y - ball_4_first_arm_y*link_4_rate_zz
    link_6_bias_x = link_5_bias_x - ball_5_first_arm_x*link_5_rate_zz
    link_6_bias_y = link_5_bias_y - ball_5_first_arm_y*link_5_rate_zz
    link_6_torque_z = link_6_bias_y*link_6_moment_x - link_6_bias_x*link_6_moment_y
    link_5_torque_z = link_6_torque_z + ball_5_first_arm_x*link_6_force_y + link_5_bias_y*link_5_moment_x - ball_5_first_arm_y*link_6_force_x - link_5_bias_x*link_5_moment_y
    link_4_torque_z = link_5_torque_z + ball_4_first_arm_x*link_5_force_y + link_4_bias_y*link_4_moment_x - ball_4_first_arm_y*link_5_force_x - link_4_bias_x*link_4_moment_y
    link_3_torque_z = link_4_torque_z + ball_3_first_arm_x*link_4_force_y + link_3_bias_y*link_3_moment_x - ball_3_first_arm_y*link_4_force_x - link_3_bias_x*link_3_moment_y
    link_2_torque_z = link_3_torque_z + ball_2_first_arm_x*link_3_force_y + link_2_bias_y*link_2_moment_x - ball_2_first_arm_y*link_3_force_x - link_2_bias_x*link_2_moment_y
    link_1_torque_z = link_2_torque_z + ball_1_first_arm_x*link_2_force_y - ball_1_first_arm_y*link_2_force_x
    flight_angle_net = flight_angle_force - link_1_torque_z
    pin_1_net = pin_1_force - link_2_torque_z
    pin_2_net = pin_2_force - link_3_torque_z
    pin_3_net = pin_3_force - link_4_torque_z
    pin_4_net = pin_4_force - link_5_torque_z
    pin_5_net = pin_5_force - link_6_torque_z
    link_5_total_J_z_z = link_5_I_z_z_plus_link_6_I_z_z + 2*ball_5_first_arm_x*link_6_moment_x + 2*ball_5_first_arm_y*link_6_moment_y
    link_4_total_J_z_z = link_4_I_z_z + link_5_total_J_z_z + 2*ball_4_first_arm_x*link_5_total_moment_x + 2*ball_4_first_arm_y*link_5_total_moment_y
    link_3_total_J_z_z = link_3_I_z_z + link_4_total_J_z_z + 2*ball_3_first_arm_x*link_4_total_moment_x + 2*ball_3_first_arm_y*link_4_total_moment_y
    link_2_total_J_z_z = link_2_I_z_z + link_3_total_J_z_z + 2*ball_2_first_arm_x*link_3_total_moment_x + 2*ball_2_first_arm_y*link_3_total_moment_y
    link_1_total_J_z_z = link_1_I_z_z + link_2_total_J_z_z + 2*ball_1_first_arm_x*link_2_total_moment_x + 2*ball_1_first_arm_y*link_2_total_moment_y
    pin_1_link_2_torque_z = link_2_total_J_z_z + ball_1_first_arm_x*link_2_total_moment_x + ball_1_first_arm_y*link_2_total_moment_y
    pin_2_link_3_torque_z = link_3_total_J_z_z + ball_2_first_arm_x*link_3_total_moment_x + ball_2_first_arm_y*link_3_total_moment_y
    pin_2_link_2_torque_z = pin_2_link_3_torque_z + ball_1_first_arm_x*link_3_total_moment_x + ball_1_first_arm_y*link_3_total_moment_y
    pin_3_link_4_torque_z = link_4_total_J_z_z + ball_3_first_arm_x*link_4_total_moment_x + ball_3_first_arm_y*link_4_total_moment_y
    pin_3_link_3_torque_z = pin_3_link_4_torque_z + ball_2_first_arm_x*link_4_total_moment_x + ball_2_first_arm_y*link_4_total_moment_y
    pin_3_link_2_torque_z = pin_3_link_3_torque_z + ball_1_first_arm_x*link_4_total_moment_x + ball_1_first_arm_y*link_4_total_moment_y
    pin_4_link_5_torque_z = link_5_total_J_z_z + ball_4_first_arm_x*link_5_total_moment_x + ball_4_first_arm_y*link_5_total_moment_y
    pin_4_link_4_torque_z = pin_4_link_5_torque_z + ball_3_first_arm_x*link_5_total_moment_x + ball_3_first_arm_y*link_5_total_moment_y
    pin_4_link_3_torque_z = pin_4_link_4_torque_z + ball_2_first_arm_x*link_5_total_moment_x + ball_2_first_arm_y*link_5_total_moment_y
    pin_4_link_2_torque_z = pin_4_link_3_torque_z + ball_1_first_arm_x*link_5_total_moment_x + ball_1_first_arm_y*link_5_total_moment_y
    pin_5_link_6_torque_z = link_6_I_z_z + ball_5_first_arm_x*link_6_moment_x + ball_5_first_arm_y*link_6_moment_y
    pin_5_link_5_torque_z = pin_5_link_6_torque_z + ball_4_first_arm_x*link_6_moment_x + ball_4_first_arm_y*link_6_moment_y
    pin_5_link_4_torque_z = pin_5_link_5_torque_z + ball_3_first_arm_x*link_6_moment_x + ball_3_first_arm_y*link_6_moment_y
    pin_5_link_3_torque_z = pin_5_link_4_torque_z + ball_2_first_arm_x*link_6_moment_x + ball_2_first_arm_y*link_6_moment_y
    pin_5_link_2_torque_z = pin_5_link_3_torque_z + ball_1_first_arm_x*link_6_moment_x + ball_1_first_arm_y*link_6_moment_y
    l_pin_4_pin_5 = inverse_link_6_I_z_z*pin_5_link_6_torque_z
    D_pin_4 = link_5_total_J_z_z - l_pin_4_pin_5*pin_5_link_6_torque_z
    l_pin_3_pin_5 = inverse_link_6_I_z_z*pin_5_link_5_torque_z
    L_pin_3_pin_4 = pin_4_link_5_torque_z - l_pin_4_pin_5*pin_5_link_5_torque_z
    l_pin_3_pin_4 = L_pin_3_pin_4/D_pin_4
    D_pin_3 = link_4_total_J_z_z - L_pin_3_pin_4*l_pin_3_pin_4 - l_pin_3_pin_5*pin_5_link_5_torque_z
    l_pin_2_pin_5 = inverse_link_6_I_z_z*pin_5_link_4_torque_z
    L_pin_2_pin_4 = pin_4_link_4_torque_z - l_pin_4_pin_5*pin_5_link_4_torque_z
    l_pin_2_pin_4 = L_pin_2_pin_4/D_pin_4
    L_pin_2_pin_3 = pin_3_link_4_torque_z - L_pin_2_pin_4*l_pin_3_pin_4 - l_pin_3_pin_5*pin_5_link_4_torque_z
    l_pin_2_pin_3 = L_pin_2_pin_3/D_pin_3
    D_pin_2 = link_3_total_J_z_z - L_pin_2_pin_3*l_pin_2_pin_3 - L_pin_2_pin_4*l_pin_2_pin_4 - l_pin_2_pin_5*pin_5_link_4_torque_z
    l_pin_1_pin_5 = inverse_link_6_I_z_z*pin_5_link_3_torque_z
    L_pin_1_pin_4 = pin_4_link_3_torque_z - l_pin_4_pin_5*pin_5_link_3_torque_z
    l_pin_1_pin_4 = L_pin_1_pin_4/D_pin_4
    L_pin_1_pin_3 = pin_3_link_3_torque_z - L_pin_1_pin_4*l_pin_3_pin_4 - l_pin_3_pin_5*pin_5_link_3_torque_z
    l_pin_1_pin_3 = L_pin_1_pin_3/D_pin_3
    L_pin_1_pin_2 = pin_2_link_3_torque_z - L_pin_1_pin_3*l_pin_2_pin_3 - L_pin_1_pin_4*l_pin_2_pin_4 - l_pin_2_pin_5*pin_5_link_3_torque_z
    l_pin_1_pin_2 = L_pin_1_pin_2/D_pin_2
    D_pin_1 = link_2_total_J_z_z - L_pin_1_pin_2*l_pin_1_pin_2 - L_pin_1_pin_3*l_pin_1_pin_3 - L_pin_1_pin_4*l_pin_1_pin_4 - l_pin_1_pin_5*pin_5_link_3_torque_z
    l_flight_angle_pin_5 = inverse_link_6_I_z_z*pin_5_link_2_torque_z
    L_flight_angle_pin_4 = pin_4_link_2_torque_z - l_pin_4_pin_5*pin_5_link_2_torque_z
    l_flight_angle_pin_4 = L_flight_angle_pin_4/D_pin_4
    L_flight_angle_pin_3 = pin_3_link_2_torque_z - L_flight_angle_pin_4*l_pin_3_pin_4 - l_pin_3_pin_5*pin_5_link_2_torque_z
    l_flight_angle_pin_3 = L_flight_angle_pin_3/D_pin_3
    L_flight_angle_pin_2 = pin_2_link_2_torque_z - L_flight_angle_pin_3*l_pin_2_pin_3 - L_flight_angle_pin_4*l_pin_2_pin_4 - l_pin_2_pin_5*pin_5_link_2_torque_z
    l_flight_angle_pin_2 = L_flight_angle_pin_2/D_pin_2
    L_flight_angle_pin_1 = pin_1_link_2_torque_z - L_flight_angle_pin_2*l_pin_1_pin_2 - L_flight_angle_pin_3*l_pin_1_pin_3 - L_flight_angle_pin_4*l_pin_1_pin_4 - l_pin_1_pin_5*pin_5_link_2_torque_z
    l_flight_angle_pin_1 = L_flight_angle_pin_1/D_pin_1
    D_flight_angle = link_1_total_J_z_z - L_flight_angle_pin_1*l_flight_angle_pin_1 - L_flight_angle_pin_2*l_flight_angle_pin_2 - L_flight_angle_pin_3*l_flight_angle_pin_3 - L_flight_angle_pin_4*l_flight_angle_pin_4 - l_flight_angle_pin_5*pin_5_link_2_torque_z
    l_flight_y_pin_5 = inverse_link_6_I_z_z*link_6_moment_x
    L_flight_y_pin_4 = link_5_total_moment_x - l_pin_4_pin_5*link_6_moment_x
    l_flight_y_pin_4 = L_flight_y_pin_4/D_pin_4
    L_flight_y_pin_3 = link_4_total_moment_x - L_flight_y_pin_4*l_pin_3_pin_4 - l_pin_3_pin_5*link_6_moment_x
    l_flight_y_pin_3 = L_flight_y_pin_3/D_pin_3
    L_flight_y_pin_2 = link_3_total_moment_x - L_flight_y_pin_3*l_pin_2_pin_3 - L_flight_y_pin_4*l_pin_2_pin_4 - l_pin_2_pin_5*link_6_moment_x
    l_flight_y_pin_2 = L_flight_y_pin_2/D_pin_2
    L_flight_y_pin_1 = link_2_total_moment_x - L_flight_y_pin_2*l_pin_1_pin_2 - L_flight_y_pin_3*l_pin_1_pin_3 - L_flight_y_pin_4*l_pin_1_pin_4 - l_pin_1_pin_5*link_6_moment_x
    l_flight_y_pin_1 = L_flight_y_pin_1/D_pin_1
    L_flight_y_flight_angle = link_1_total_moment_x - L_flight_y_pin_1*l_flight_angle_pin_1 - L_flight_y_pin_2*l_flight_angle_pin_2 - L_flight_y_pin_3*l_flight_angle_pin_3 - L_flight_y_pin_4*l_flight_angle_pin_4 - l_flight_angle_pin_5*link_6_moment_x
    l_flight_y_flight_angle = L_flight_y_flight_angle/D_flight_angle
    D_flight_y = link_1_total_mass - L_flight_y_flight_angle*l_flight_y_flight_angle - L_flight_y_pin_1*l_flight_y_pin_1 - L_flight_y_pin_2*l_flight_y_pin_2 - L_flight_y_pin_3*l_flight_y_pin_3 - L_flight_y_pin_4*l_flight_y_pin_4 - l_flight_y_pin_5*link_6_moment_x
    l_flight_x_pin_5 = -inverse_link_6_I_z_z*link_6_moment_y
    L_flight_x_pin_4 = l_pin_4_pin_5*link_6_moment_y - link_5_total_moment_y
    l_flight_x_pin_4 = L_flight_x_pin_4/D_pin_4
    L_flight_x_pin_3 = l_pin_3_pin_5*link_6_moment_y - link_4_total_moment_y - L_flight_x_pin_4*l_pin_3_pin_4
    l_flight_x_pin_3 = L_flight_x_pin_3/D_pin_3
    L_flight_x_pin_2 = l_pin_2_pin_5*link_6_moment_y - link_3_total_moment_y - L_flight_x_pin_3*l_pin_2_pin_3 - L_flight_x_pin_4*l_pin_2_pin_4
    l_flight_x_pin_2 = L_flight_x_pin_2/D_pin_2
    L_flight_x_pin_1 = l_pin_1_pin_5*link_6_moment_y - link_2_total_moment_y - L_flight_x_pin_2*l_pin_1_pin_2 - L_flight_x_pin_3*l_pin_1_pin_3 - L_flight_x_pin_4*l_pin_1_pin_4
    l_flight_x_pin_1 = L_flight_x_pin_1/D_pin_1
    L_flight_x_flight_angle = l_flight_angle_pin_5*link_6_moment_y - link_1_total_moment_y - L_flight_x_pin_1*l_flight_angle_pin_1 - L_flight_x_pin_2*l_flight_angle_pin_2 - L_flight_x_pin_3*l_flight_angle_pin_3 - L_flight_x_pin_4*l_flight_angle_pin_4
    l_flight_x_flight_angle = L_flight_x_flight_angle/D_flight_angle
    L_flight_x_flight_y = l_flight_y_pin_5*link_6_moment_y - L_flight_x_flight_angle*l_flight_y_flight_angle - L_flight_x_pin_1*l_flight_y_pin_1 - L_flight_x_pin_2*l_flight_y_pin_2 - L_flight_x_pin_3*l_flight_y_pin_3 - L_flight_x_pin_4*l_flight_y_pin_4
    l_flight_x_flight_y = L_flight_x_flight_y/D_flight_y
    D_flight_x = link_1_total_mass + l_flight_x_pin_5*link_6_moment_y - L_flight_x_flight_angle*l_flight_x_flight_angle - L_flight_x_flight_y*l_flight_x_flight_y - L_flight_x_pin_1*l_flight_x_pin_1 - L_flight_x_pin_2*l_flight_x_pin_2 - L_flight_x_pin_3*l_flight_x_pin_3 - L_flight_x_pin_4*l_flight_x_pin_4
    y_pin_4 = pin_4_net - l_pin_4_pin_5*pin_5_net
    y_pin_3 = pin_3_net - l_pin_3_pin_4*y_pin_4 - l_pin_3_pin_5*pin_5_net
    y_pin_2 = pin_2_net - l_pin_2_pin_3*y_pin_3 - l_pin_2_pin_4*y_pin_4 - l_pin_2_pin_5*pin_5_net
    y_pin_1 = pin_1_net - l_pin_1_pin_2*y_pin_2 - l_pin_1_pin_3*y_pin_3 - l_pin_1_pin_4*y_pin_4 - l_pin_1_pin_5*pin_5_net
    y_flight_angle = flight_angle_net - l_flight_angle_pin_1*y_pin_1 - l_flight_angle_pin_2*y_pin_2 - l_flight_angle_pin_3*y_pin_3 - l_flight_angle_pin_4*y_pin_4 - l_flight_angle_pin_5*pin_5_net
    y_flight_y = flight_y_net - l_flight_y_flight_angle*y_flight_angle - l_flight_y_pin_1*y_pin_1 - l_flight_y_pin_2*y_pin_2 - l_flight_y_pin_3*y_pin_3 - l_flight_y_pin_4*y_pin_4 - l_flight_y_pin_5*pin_5_net
    y_flight_x = flight_x_net - l_flight_x_flight_angle*y_flight_angle - l_flight_x_flight_y*y_flight_y - l_flight_x_pin_1*y_pin_1 - l_flight_x_pin_2*y_pin_2 - l_flight_x_pin_3*y_pin_3 - l_flight_x_pin_4*y_pin_4 - l_flight_x_pin_5*pin_5_net
    flight_x_acc = y_flight_x/D_flight_x
    flight_y_acc = y_flight_y/D_flight_y - flight_x_acc*l_flight_x_flight_y
    flight_angle_acc = y_flight_angle/D_flight_angle - flight_x_acc*l_flight_x_flight_angle - flight_y_acc*l_flight_y_flight_angle
    pin_1_acc = y_pin_1/D_pin_1 - flight_angle_acc*l_flight_angle_pin_1 - flight_x_acc*l_flight_x_pin_1 - flight_y_acc*l_flight_y_pin_1
    pin_2_acc = y_pin_2/D_pin_2 - flight_angle_acc*l_flight_angle_pin_2 - flight_x_acc*l_flight_x_pin_2 - flight_y_acc*l_flight_y_pin_2 - l_pin_1_pin_2*pin_1_acc
    pin_3_acc = y_pin_3/D_pin_3 - flight_angle_acc*l_flight_angle_pin_3 - flight_x_acc*l_flight_x_pin_3 - flight_y_acc*l_flight_y_pin_3 - l_pin_1_pin_3*pin_1_acc - l_pin_2_pin_3*pin_2_acc
    pin_4_acc = y_pin_4/D_pin_4 - flight_angle_acc*l_flight_angle_pin_4 - flight_x_acc*l_flight_x_pin_4 - flight_y_acc*l_flight_y_pin_4 - l_pin_1_pin_4*pin_1_acc - l_pin_2_pin_4*pin_2_acc - l_pin_3_pin_4*pin_3_acc
    pin_5_acc = inverse_link_6_I_z_z*pin_5_net - flight_angle_acc*l_flight_angle_pin_5 - flight_x_acc*l_flight_x_pin_5 - flight_y_acc*l_flight_y_pin_5 - l_pin_1_pin_5*pin_1_acc - l_pin_2_pin_5*pin_2_acc - l_pin_3_pin_5*pin_3_acc - l_pin_4_pin_5*pin_4_acc
    return ca.vertcat(flight_x_acc, flight_y_acc, flight_angle_acc, pin_1_acc, pin_2_acc, pin_3_acc, pin_4_acc, pin_5_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (14,): MEMORY [W]
    """
    return ca.vertcat(*[0]*14)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (7,): PAIRS [J]
    """
    link_length, ball_radius, two_fifths_of_stiffness, link_6_h_x, half_link_6_I_z_z, half_link_mass = c[1], c[2], c[6], c[10], c[23], c[24]
    half_link_length, gravity_times_link_mass = c[25], c[26]
    flight_y, flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle, pin_5_angle = q[1], q[2], q[3], q[4], q[5], q[6], q[7]
    flight_x_speed, flight_y_speed, flight_angle_speed, pin_1_speed, pin_2_speed, pin_3_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    pin_4_speed, pin_5_speed = u[6], u[7]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    sin_link_5 = ca.sin(link_5_angle)
    link_6_angle = link_5_angle + pin_5_angle
    cos_link_6 = ca.cos(link_6_angle)
    sin_link_6 = ca.sin(link_6_angle)
    ball_1_first_arm_x = cos_link_1*link_length
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    link_2_rate_z = flight_angle_speed + pin_1_speed
    ball_2_first_arm_x = cos_link_2*link_length
    ball_2_first_arm_y = sin_link_2*link_length
    ball_2_apart_y = ball_1_apart_y + ball_2_first_arm_y
    link_3_rate_z = link_2_rate_z + pin_2_speed
    ball_3_first_arm_x = cos_link_3*link_length
    ball_3_first_arm_y = sin_link_3*link_length
    ball_3_apart_y = ball_2_apart_y + ball_3_first_arm_y
    link_4_rate_z = link_3_rate_z + pin_3_speed
    ball_4_first_arm_x = cos_link_4*link_length
    ball_4_first_arm_y = sin_link_4*link_length
    ball_4_apart_y = ball_3_apart_y + ball_4_first_arm_y
    link_5_rate_z = link_4_rate_z + pin_4_speed
    ball_5_first_arm_x = cos_link_5*link_length
    ball_5_first_arm_y = sin_link_5*link_length
    ball_5_apart_y = ball_4_apart_y + ball_5_first_arm_y
    link_6_rate_z = link_5_rate_z + pin_5_speed
    ball_6_first_arm_y = sin_link_6*link_length
    ball_6_apart_y = ball_5_apart_y + ball_6_first_arm_y
    ball_0_gap = flight_y - ball_radius
    ball_1_gap = ball_1_apart_y - ball_radius
    ball_2_gap = ball_2_apart_y - ball_radius
    ball_3_gap = ball_3_apart_y - ball_radius
    ball_4_gap = ball_4_apart_y - ball_radius
    ball_5_gap = ball_5_apart_y - ball_radius
    ball_6_gap = ball_6_apart_y - ball_radius
    ball_0_stored_energy = ca.if_else(-ball_0_gap > 0, two_fifths_of_stiffness*(-ball_0_gap)**2*ca.sqrt(-ball_0_gap), 0)
    ball_1_stored_energy = ca.if_else(-ball_1_gap > 0, two_fifths_of_stiffness*(-ball_1_gap)**2*ca.sqrt(-ball_1_gap), 0)
    ball_1_relative_rate_x = flight_x_speed - ball_1_first_arm_y*flight_angle_speed
    ball_1_relative_rate_y = flight_y_speed + ball_1_first_arm_x*flight_angle_speed
    ball_2_stored_energy = ca.if_else(-ball_2_gap > 0, two_fifths_of_stiffness*(-ball_2_gap)**2*ca.sqrt(-ball_2_gap), 0)
    ball_3_stored_energy = ca.if_else(-ball_3_gap > 0, two_fifths_of_stiffness*(-ball_3_gap)**2*ca.sqrt(-ball_3_gap), 0)
    ball_4_stored_energy = ca.if_else(-ball_4_gap > 0, two_fifths_of_stiffness*(-ball_4_gap)**2*ca.sqrt(-ball_4_gap), 0)
    ball_5_stored_energy = ca.if_else(-ball_5_gap > 0, two_fifths_of_stiffness*(-ball_5_gap)**2*ca.sqrt(-ball_5_gap), 0)
    ball_6_stored_energy = ca.if_else(-ball_6_gap > 0, two_fifths_of_stiffness*(-ball_6_gap)**2*ca.sqrt(-ball_6_gap), 0)
    link_6_moment_x = cos_link_6*link_6_h_x
    link_6_moment_y = link_6_h_x*sin_link_6
    link_1_moment_x_2 = cos_link_1*link_6_h_x
    link_1_moment_y_2 = link_6_h_x*sin_link_1
    link_2_moment_x_2 = cos_link_2*link_6_h_x
    link_2_moment_y_2 = link_6_h_x*sin_link_2
    link_3_moment_x_2 = cos_link_3*link_6_h_x
    link_3_moment_y_2 = link_6_h_x*sin_link_3
    link_3_velocity_x = ball_1_relative_rate_x - ball_2_first_arm_y*link_2_rate_z
    link_3_velocity_y = ball_1_relative_rate_y + ball_2_first_arm_x*link_2_rate_z
    link_4_moment_x_2 = cos_link_4*link_6_h_x
    link_4_moment_y_2 = link_6_h_x*sin_link_4
    link_4_velocity_x = link_3_velocity_x - ball_3_first_arm_y*link_3_rate_z
    link_4_velocity_y = link_3_velocity_y + ball_3_first_arm_x*link_3_rate_z
    link_5_moment_x_2 = cos_link_5*link_6_h_x
    link_5_moment_y_2 = link_6_h_x*sin_link_5
    link_5_velocity_x = link_4_velocity_x - ball_4_first_arm_y*link_4_rate_z
    link_5_velocity_y = link_4_velocity_y + ball_4_first_arm_x*link_4_rate_z
    link_6_velocity_x = link_5_velocity_x - ball_5_first_arm_y*link_5_rate_z
    link_6_velocity_y = link_5_velocity_y + ball_5_first_arm_x*link_5_rate_z
    kinetic = half_link_6_I_z_z*flight_angle_speed*flight_angle_speed + half_link_6_I_z_z*link_2_rate_z*link_2_rate_z + half_link_6_I_z_z*link_3_rate_z*link_3_rate_z + half_link_6_I_z_z*link_4_rate_z*link_4_rate_z + half_link_6_I_z_z*link_5_rate_z*link_5_rate_z + half_link_6_I_z_z*link_6_rate_z*link_6_rate_z + half_link_mass*(ball_1_relative_rate_x*ball_1_relative_rate_x + ball_1_relative_rate_y*ball_1_relative_rate_y) + half_link_mass*(flight_x_speed*flight_x_speed + flight_y_speed*flight_y_speed) + half_link_mass*(link_3_velocity_x*link_3_velocity_x + link_3_velocity_y*link_3_velocity_y) + half_link_mass*(link_4_velocity_x*link_4_velocity_x + link_4_velocity_y*link_4_velocity_y) + half_link_mass*(link_5_velocity_x*link_5_velocity_x + link_5_velocity_y*link_5_velocity_y) + half_link_mass*(link_6_velocity_x*link_6_velocity_x + link_6_velocity_y*link_6_velocity_y) + ball_1_relative_rate_y*link_2_moment_x_2*link_2_rate_z + flight_angle_speed*flight_y_speed*link_1_moment_x_2 + link_3_moment_x_2*link_3_rate_z*link_3_velocity_y + link_4_moment_x_2*link_4_rate_z*link_4_velocity_y + link_5_moment_x_2*link_5_rate_z*link_5_velocity_y + link_6_moment_x*link_6_rate_z*link_6_velocity_y - ball_1_relative_rate_x*link_2_moment_y_2*link_2_rate_z - flight_angle_speed*flight_x_speed*link_1_moment_y_2 - link_3_moment_y_2*link_3_rate_z*link_3_velocity_x - link_4_moment_y_2*link_4_rate_z*link_4_velocity_x - link_5_moment_y_2*link_5_rate_z*link_5_velocity_x - link_6_moment_y*link_6_rate_z*link_6_velocity_x
    link_1_centre_arm_y = half_link_length*sin_link_1
    link_2_centre_arm_y = half_link_length*sin_link_2
    link_3_centre_arm_y = half_link_length*sin_link_3
    link_4_centre_arm_y = half_link_length*sin_link_4
    link_5_centre_arm_y = half_link_length*sin_link_5
    link_6_centre_arm_y = half_link_length*sin_link_6
    potential = gravity_times_link_mass*(ball_1_apart_y + link_2_centre_arm_y) + gravity_times_link_mass*(ball_2_apart_y + link_3_centre_arm_y) + gravity_times_link_mass*(ball_3_apart_y + link_4_centre_arm_y) + gravity_times_link_mass*(ball_4_apart_y + link_5_centre_arm_y) + gravity_times_link_mass*(ball_5_apart_y + link_6_centre_arm_y) + gravity_times_link_mass*(flight_y + link_1_centre_arm_y)
    return (ca.vertcat(kinetic), ca.vertcat(potential),
        ca.vertcat(ball_0_stored_energy, ball_1_stored_energy, ball_2_stored_energy, ball_3_stored_energy, ball_4_stored_energy,
            ball_5_stored_energy, ball_6_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (18,): link_1.x [m], link_1.y [m], link_1.z [m], link_2.x [m], link_2.y [m], link_2.z [m], link_3.x [m], link_3.y [m],
            link_3.z [m], link_4.x [m], link_4.y [m], link_4.z [m], link_5.x [m], link_5.y [m], link_5.z [m], link_6.x [m], link_6.y [m],
            link_6.z [m]
        rotations (54,): link_1.R_xx [1], link_1.R_xy [1], link_1.R_xz [1], link_1.R_yx [1], link_1.R_yy [1], link_1.R_yz [1], link_1.R_zx
            [1], link_1.R_zy [1], link_1.R_zz [1], link_2.R_xx [1], link_2.R_xy [1], link_2.R_xz [1], link_2.R_yx [1], link_2.R_yy [1],
            link_2.R_yz [1], link_2.R_zx [1], link_2.R_zy [1], link_2.R_zz [1], link_3.R_xx [1], link_3.R_xy [1], link_3.R_xz [1],
            link_3.R_yx [1], link_3.R_yy [1], link_3.R_yz [1], link_3.R_zx [1], link_3.R_zy [1], link_3.R_zz [1], link_4.R_xx [1],
            link_4.R_xy [1], link_4.R_xz [1], link_4.R_yx [1], link_4.R_yy [1], link_4.R_yz [1], link_4.R_zx [1], link_4.R_zy [1],
            link_4.R_zz [1], link_5.R_xx [1], link_5.R_xy [1], link_5.R_xz [1], link_5.R_yx [1], link_5.R_yy [1], link_5.R_yz [1],
            link_5.R_zx [1], link_5.R_zy [1], link_5.R_zz [1], link_6.R_xx [1], link_6.R_xy [1], link_6.R_xz [1], link_6.R_yx [1],
            link_6.R_yy [1], link_6.R_yz [1], link_6.R_zx [1], link_6.R_zy [1], link_6.R_zz [1]
    """
    link_length, half_link_length = c[1], c[25]
    flight_x, flight_y, flight_angle, pin_1_angle, pin_2_angle, pin_3_angle, pin_4_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    pin_5_angle = q[7]
    cos_link_1 = ca.cos(flight_angle)
    sin_link_1 = ca.sin(flight_angle)
    link_2_angle = flight_angle + pin_1_angle
    cos_link_2 = ca.cos(link_2_angle)
    sin_link_2 = ca.sin(link_2_angle)
    link_3_angle = link_2_angle + pin_2_angle
    cos_link_3 = ca.cos(link_3_angle)
    sin_link_3 = ca.sin(link_3_angle)
    link_4_angle = link_3_angle + pin_3_angle
    cos_link_4 = ca.cos(link_4_angle)
    sin_link_4 = ca.sin(link_4_angle)
    link_5_angle = link_4_angle + pin_4_angle
    cos_link_5 = ca.cos(link_5_angle)
    sin_link_5 = ca.sin(link_5_angle)
    link_6_angle = link_5_angle + pin_5_angle
    cos_link_6 = ca.cos(link_6_angle)
    sin_link_6 = ca.sin(link_6_angle)
    ball_1_apart_x, ball_1_apart_y = sphere_on_plane_apart(cos_link_1, sin_link_1, flight_x, flight_y, link_length)
    ball_2_apart_x, ball_2_apart_y = sphere_on_plane_apart(cos_link_2, sin_link_2, ball_1_apart_x, ball_1_apart_y, link_length)
    ball_3_apart_x, ball_3_apart_y = sphere_on_plane_apart(cos_link_3, sin_link_3, ball_2_apart_x, ball_2_apart_y, link_length)
    ball_4_apart_x, ball_4_apart_y = sphere_on_plane_apart(cos_link_4, sin_link_4, ball_3_apart_x, ball_3_apart_y, link_length)
    ball_5_apart_x, ball_5_apart_y = sphere_on_plane_apart(cos_link_5, sin_link_5, ball_4_apart_x, ball_4_apart_y, link_length)
    link_1_centre_arm_x = cos_link_1*half_link_length
    link_1_centre_arm_y = half_link_length*sin_link_1
    link_2_centre_arm_x = cos_link_2*half_link_length
    link_2_centre_arm_y = half_link_length*sin_link_2
    link_3_centre_arm_x = cos_link_3*half_link_length
    link_3_centre_arm_y = half_link_length*sin_link_3
    link_4_centre_arm_x = cos_link_4*half_link_length
    link_4_centre_arm_y = half_link_length*sin_link_4
    link_5_centre_arm_x = cos_link_5*half_link_length
    link_5_centre_arm_y = half_link_length*sin_link_5
    link_6_centre_arm_x = cos_link_6*half_link_length
    link_6_centre_arm_y = half_link_length*sin_link_6
    return (ca.vertcat(flight_x + link_1_centre_arm_x, flight_y + link_1_centre_arm_y, 0, ball_1_apart_x + link_2_centre_arm_x,
            ball_1_apart_y + link_2_centre_arm_y, 0, ball_2_apart_x + link_3_centre_arm_x, ball_2_apart_y + link_3_centre_arm_y, 0,
            ball_3_apart_x + link_4_centre_arm_x, ball_3_apart_y + link_4_centre_arm_y, 0, ball_4_apart_x + link_5_centre_arm_x,
            ball_4_apart_y + link_5_centre_arm_y, 0, ball_5_apart_x + link_6_centre_arm_x, ball_5_apart_y + link_6_centre_arm_y, 0),
        ca.vertcat(cos_link_1, -sin_link_1, 0, sin_link_1, cos_link_1, 0, 0, 0, 1, cos_link_2, -sin_link_2, 0, sin_link_2, cos_link_2, 0, 0,
            0, 1, cos_link_3, -sin_link_3, 0, sin_link_3, cos_link_3, 0, 0, 0, 1, cos_link_4, -sin_link_4, 0, sin_link_4, cos_link_4, 0, 0,
            0, 1, cos_link_5, -sin_link_5, 0, sin_link_5, cos_link_5, 0, 0, 0, 1, cos_link_6, -sin_link_6, 0, sin_link_6, cos_link_6, 0, 0,
            0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (7,): OUTPUTS
    """
    link_length, ball_radius = c[1], c[2]
    flight_y, flight_angle = q[1], q[2]
    sin_link_1 = ca.sin(flight_angle)
    ball_1_first_arm_y = sin_link_1*link_length
    ball_1_apart_y = ball_1_first_arm_y + flight_y
    link_2_angle, ball_2_apart_y = solid_rod_outputs_terms(ball_1_apart_y, flight_angle, q[3], link_length)
    link_3_angle, ball_3_apart_y = solid_rod_outputs_terms(ball_2_apart_y, q[4], link_2_angle, link_length)
    link_4_angle, ball_4_apart_y = solid_rod_outputs_terms(ball_3_apart_y, q[5], link_3_angle, link_length)
    link_5_angle, ball_5_apart_y = solid_rod_outputs_terms(ball_4_apart_y, q[6], link_4_angle, link_length)
    _, ball_6_apart_y = solid_rod_outputs_terms(ball_5_apart_y, q[7], link_5_angle, link_length)
    ball_0_gap = flight_y - ball_radius
    ball_1_gap = ball_1_apart_y - ball_radius
    ball_2_gap = ball_2_apart_y - ball_radius
    ball_3_gap = ball_3_apart_y - ball_radius
    ball_4_gap = ball_4_apart_y - ball_radius
    ball_5_gap = ball_5_apart_y - ball_radius
    ball_6_gap = ball_6_apart_y - ball_radius
    return ca.vertcat(ball_0_gap, ball_1_gap, ball_2_gap, ball_3_gap, ball_4_gap, ball_5_gap, ball_6_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        flight.parent, flight.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        pin_1.parent to pin_5.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball_0.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_0.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_1.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_1.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_2.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_2.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_3.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_3.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_4.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_4.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_5.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_5.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        ball_6.sphere (4,): x [m], y [m], z [m], radius [m]
        ball_6.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        link_1.centre to link_6.centre (3,): x [m], y [m], z [m]
        link_1.shape_1 to link_6.shape_1 (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], length [m]
    """
    link_length, ball_radius = p[1], p[2]
    minus_half_link_length = -link_length/2
    x2 = link_length/2
    return (ca.vertcat(*[0]*5, 1), *[ca.vertcat(minus_half_link_length, 0, 0, 0, 0, 1), ca.vertcat(x2, 0, 0, 0, 0, 1)]*5,
        ca.vertcat(minus_half_link_length, 0, 0, 0, 0, 1), ca.vertcat(minus_half_link_length, 0, 0, ball_radius),
        *[ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(x2, 0, 0, ball_radius)]*6, ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, -1, 0),
        *[ca.vertcat(0, 0, 0)]*6, *[ca.vertcat(0, 0, 0, 1, 0, 0, link_length)]*6)
