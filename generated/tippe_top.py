"""tippe_top: a top that turns over, raised by friction. Generated from derive/scenes/tippe_top.py.

Do not edit; regenerate with `hertzwerk derive tippe_top`.
Effects:
    gravity: uniform gravity
    floor: power x kelvin_voigt
    rubbing: smooth_coulomb at floor
    energy_ledger: work put in, energy dissipated per effect
Units: 102 assignments and 121 outputs checked, all consistent
Operations: flight 122 (equations of motion and gaps); in contact also contact_floor 134
"""

import casadi as ca

NAME = "tippe_top"
SOURCE = "derive/scenes/tippe_top.py"
SUMMARY = "a top that turns over, raised by friction"
FORMAT = "hertzwerk module 1"
DIGEST = "011c13fff9419ce8fe8465d1312b98f8"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("floor", "contact", "power x kelvin_voigt"),
    ("rubbing", "friction", "smooth_coulomb at floor"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "g", 6, "body top, mass"),
    ("radius", "mm", 15, "pair floor, radius"),
    ("across_share", "1", 0.396969696969697, "of m r^2: moment of inertia across the axis"),
    ("axial_share", "1", 0.4, "of m r^2: moment of inertia about the axis"),
    ("offset", "mm", 3, "of the mass centre, below the middle of the ball"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m", 2000, "effect floor, stiffness of power"),
    ("restitution", "1", 0.1, "effect floor, coefficient of restitution of kelvin_voigt"),
    ("friction_coefficient", "1", 0.3, "effect rubbing, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "mm/s", 10, "effect rubbing, speed over which the friction force builds up of smooth_coulomb"),
    ("start_tilt", "rad", 0.1, ""),
    ("start_spin", "rad/s", 155, "about the axis"),
    ("depth", "mm", 0.1, "scales, length"),
    ("pace", "m/s", 0.5, "scales, speed"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body top, mass"),
    ("radius", "defined", 0, None, True, False, "pair floor, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect floor, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect floor, coefficient of restitution of kelvin_voigt"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect rubbing, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect rubbing, speed over which the friction force builds up of smooth_coulomb"),
    ("depth", "defined", 0, None, True, False, "scales, length"),
    ("pace", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (
    ("flight.x", "m"), ("flight.y", "m"), ("flight.z", "m"), ("flight.q0", "1"), ("flight.q1", "1"), ("flight.q2", "1"), ("flight.q3", "1"),
)

QUATERNIONS = (3,)

SPEEDS = (
    ("flight.x_speed", "m/s"), ("flight.y_speed", "m/s"), ("flight.z_speed", "m/s"), ("flight.angular_speed_x", "rad/s"),
    ("flight.angular_speed_y", "rad/s"), ("flight.angular_speed_z", "rad/s"),
)

MEMORY = (("floor.dissipated", "J"), ("rubbing.dissipated", "J"))

PAIRS = (("floor", "sphere_on_plane"),)

RELEASES = ("gap",)

DISSIPATED = (0,)

OUTPUTS = (("floor.gap", "m"),)

BODIES = ("top",)

LANDMARKS = (
    ("floor", "sphere_on_plane", "sphere", "top", ("radius",)), ("floor", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("top", "body", "centre", "top", ()),
)

CONSTANTS = (
    ("mass", "kg"), ("radius", "m"), ("offset", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m"), ("friction_coefficient", "1"),
    ("half_stiffness", "N/m"), ("twice_floor_xi", "1"), ("pace_squared", "m^2/s^2"), ("inverse_friction_speed", "s/m"),
    ("friction_coefficient_over_friction_speed", "s/m"), ("top_I_y_y_minus_top_I_z_z", "kg m^2"), ("inverse_mass", "1/kg"),
    ("inverse_top_I_z_z", "1/(kg m^2)"), ("inverse_top_I_y_y", "1/(kg m^2)"), ("half_top_I_y_y", "kg m^2"), ("half_top_I_z_z", "kg m^2"),
    ("half_mass", "kg"), ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 25), ("start", 16), ("scales", 7), ("coordinate_rates", 24), ("gaps", 41), ("gap_accelerations", 66),
    ("contact_floor", 134), ("applied", 2), ("accelerations", 13), ("ledger", 0), ("energy", 63), ("poses", 24), ("outputs", 9),
    ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = LATCHES = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def body_R(flight_q0, flight_q1, flight_q2, flight_q3):
    """Return R_x_x [1], R_x_y [1], R_x_z [1], R_y_x [1], R_y_y [1], R_y_z [1], R_z_x [1], R_z_y [1], R_z_z [1]."""
    twice_q1 = 2*flight_q1
    twice_q2 = 2*flight_q2
    twice_q3 = 2*flight_q3
    q1q1 = flight_q1*twice_q1
    q2q2 = flight_q2*twice_q2
    q3q3 = flight_q3*twice_q3
    q0q1 = flight_q0*twice_q1
    q0q2 = flight_q0*twice_q2
    q0q3 = flight_q0*twice_q3
    R_x_x = 1 - q2q2 - q3q3
    flight_q2_times_twice_q1 = flight_q2*twice_q1
    R_x_y = flight_q2_times_twice_q1 - q0q3
    flight_q3_times_twice_q1 = flight_q3*twice_q1
    R_x_z = q0q2 + flight_q3_times_twice_q1
    R_y_x = q0q3 + flight_q2_times_twice_q1
    R_y_y = 1 - q1q1 - q3q3
    flight_q3_times_twice_q2 = flight_q3*twice_q2
    R_y_z = flight_q3_times_twice_q2 - q0q1
    R_z_x = flight_q3_times_twice_q1 - q0q2
    R_z_y = q0q1 + flight_q3_times_twice_q2
    R_z_z = 1 - q1q1 - q2q2
    return R_x_x, R_x_y, R_x_z, R_y_x, R_y_y, R_y_z, R_z_x, R_z_y, R_z_z


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (19,): mass, radius, offset, gravity, stiffness, friction_coefficient, half_stiffness, twice_floor_xi, pace_squared,
            inverse_friction_speed, friction_coefficient_over_friction_speed, top_I_y_y_minus_top_I_z_z, inverse_mass, inverse_top_I_z_z,
            inverse_top_I_y_y, half_top_I_y_y, half_top_I_z_z, half_mass, gravity_times_mass
    """
    mass, radius, across_share, axial_share, offset, gravity, stiffness, restitution = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    friction_coefficient, friction_speed, pace = p[8], p[9], p[13]
    half_stiffness = stiffness/2
    x1 = ca.log(restitution)
    floor_xi = -x1/ca.sqrt(3.141592653589793**2 + x1*x1)
    twice_floor_xi = 2*floor_xi
    pace_squared = pace*pace
    inverse_friction_speed = 1/friction_speed
    friction_coefficient_over_friction_speed = inverse_friction_speed*friction_coefficient
    radius_squared = radius*radius
    top_I_z_z = radius_squared*across_share*mass
    top_I_y_y = radius_squared*axial_share*mass
    top_I_y_y_minus_top_I_z_z = top_I_y_y - top_I_z_z
    inverse_mass = 1/mass
    inverse_top_I_z_z = 1/top_I_z_z
    inverse_top_I_y_y = 1/top_I_y_y
    half_top_I_y_y = top_I_y_y/2
    half_top_I_z_z = top_I_z_z/2
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(mass, radius, offset, gravity, stiffness, friction_coefficient, half_stiffness, twice_floor_xi, pace_squared,
        inverse_friction_speed, friction_coefficient_over_friction_speed, top_I_y_y_minus_top_I_z_z, inverse_mass, inverse_top_I_z_z,
        inverse_top_I_y_y, half_top_I_y_y, half_top_I_z_z, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (7,): COORDINATES
        u (6,): SPEEDS
    """
    mass, radius, offset, gravity, stiffness, start_tilt, start_spin = p[0], p[1], p[4], p[5], p[6], p[10], p[11]
    half_start_tilt = start_tilt/2
    x2 = ca.cos(half_start_tilt)
    x3 = x2*x2
    x4 = ca.sin(half_start_tilt)
    x5 = x4*x4
    x6 = x3 + x5
    x7 = 1/ca.sqrt(x6)
    return (ca.vertcat(0, radius - offset*ca.cos(start_tilt) - gravity*mass/stiffness, 0, x2*x7, 0, 0, x4*x7),
        ca.vertcat(0, 0, 0, 0, start_spin, 0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (7,): COORDINATES
        su (6,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, radius, depth, pace = p[0], p[1], p[12], p[13]
    energy_scale = pace*pace*mass/2
    force_scale = energy_scale/depth
    half_depth_over_radius = depth/(2*radius)
    pace_over_radius = pace/radius
    return (ca.vertcat(depth, depth, depth, half_depth_over_radius, half_depth_over_radius, half_depth_over_radius, half_depth_over_radius),
        ca.vertcat(pace, pace, pace, pace_over_radius, pace_over_radius, pace_over_radius), ca.vertcat(energy_scale, energy_scale),
        ca.vertcat(depth, pace, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (7,): flight.x [m/s], flight.y [m/s], flight.z [m/s], flight.q0 [1/s], flight.q1 [1/s], flight.q2 [1/s], flight.q3 [1/s]
    """
    flight_q0, flight_q1, flight_q2, flight_q3 = q[3], q[4], q[5], q[6]
    flight_x_speed, flight_y_speed, flight_z_speed, flight_angular_speed_x, flight_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    flight_angular_speed_z = u[5]
    half_flight_angular_speed_x = flight_angular_speed_x/2
    half_flight_angular_speed_y = flight_angular_speed_y/2
    half_flight_angular_speed_z = flight_angular_speed_z/2
    return ca.vertcat(flight_x_speed, flight_y_speed, flight_z_speed, -flight_q1*half_flight_angular_speed_x -
        flight_q2*half_flight_angular_speed_y - flight_q3*half_flight_angular_speed_z, flight_q0*half_flight_angular_speed_x +
        flight_q2*half_flight_angular_speed_z - flight_q3*half_flight_angular_speed_y, flight_q0*half_flight_angular_speed_y +
        flight_q3*half_flight_angular_speed_x - flight_q1*half_flight_angular_speed_z, flight_q0*half_flight_angular_speed_z +
        flight_q1*half_flight_angular_speed_y - flight_q2*half_flight_angular_speed_x)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    radius, offset = c[1], c[2]
    flight_y, flight_q0, flight_q1, flight_q2, flight_q3 = q[1], q[3], q[4], q[5], q[6]
    flight_y_speed, flight_angular_speed_x, flight_angular_speed_y, flight_angular_speed_z = u[1], u[3], u[4], u[5]
    top_twice_q1 = 2*flight_q1
    top_twice_q2 = 2*flight_q2
    top_twice_q3 = 2*flight_q3
    top_q1q1 = flight_q1*top_twice_q1
    top_q2q2 = flight_q2*top_twice_q2
    top_q3q3 = flight_q3*top_twice_q3
    top_q0q1 = flight_q0*top_twice_q1
    top_q0q2 = flight_q0*top_twice_q2
    top_q0q3 = flight_q0*top_twice_q3
    top_R_x_x = 1 - top_q2q2 - top_q3q3
    top_R_x_y = flight_q2*top_twice_q1 - top_q0q3
    flight_q3_times_top_twice_q1 = flight_q3*top_twice_q1
    top_R_x_z = top_q0q2 + flight_q3_times_top_twice_q1
    top_R_y_y = 1 - top_q1q1 - top_q3q3
    top_R_z_x = flight_q3_times_top_twice_q1 - top_q0q2
    top_R_z_y = top_q0q1 + flight_q3*top_twice_q2
    top_R_z_z = 1 - top_q1q1 - top_q2q2
    top_turning_x = flight_angular_speed_x*top_R_x_x + flight_angular_speed_y*top_R_x_y + flight_angular_speed_z*top_R_x_z
    top_turning_z = flight_angular_speed_x*top_R_z_x + flight_angular_speed_y*top_R_z_y + flight_angular_speed_z*top_R_z_z
    floor_first_arm_x = top_R_x_y*offset
    floor_first_arm_y = top_R_y_y*offset
    floor_first_arm_z = top_R_z_y*offset
    floor_first_arm_rate_y = floor_first_arm_x*top_turning_z - floor_first_arm_z*top_turning_x
    floor_apart_y = flight_y + floor_first_arm_y
    floor_apart_rate_y = flight_y_speed + floor_first_arm_rate_y
    floor_gap = floor_apart_y - radius
    return ca.vertcat(floor_gap), ca.vertcat(floor_apart_rate_y)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    offset = c[2]
    flight_angular_speed_x, flight_angular_speed_y, flight_angular_speed_z = u[3], u[4], u[5]
    flight_y_acceleration, flight_angular_acceleration_x, flight_angular_acceleration_y = a[1], a[3], a[4]
    flight_angular_acceleration_z = a[5]
    R_x_x, R_x_y, R_x_z, R_y_x, R_y_y, R_y_z, R_z_x, R_z_y, R_z_z = body_R(q[3], q[4], q[5], q[6])
    top_turning_x = flight_angular_speed_x*R_x_x + flight_angular_speed_y*R_x_y + flight_angular_speed_z*R_x_z
    top_turning_y = flight_angular_speed_x*R_y_x + flight_angular_speed_y*R_y_y + flight_angular_speed_z*R_y_z
    top_turning_z = flight_angular_speed_x*R_z_x + flight_angular_speed_y*R_z_y + flight_angular_speed_z*R_z_z
    top_angular_acceleration_x = flight_angular_acceleration_x*R_x_x + flight_angular_acceleration_y*R_x_y + flight_angular_acceleration_z*R_x_z
    top_angular_acceleration_z = flight_angular_acceleration_x*R_z_x + flight_angular_acceleration_y*R_z_y + flight_angular_acceleration_z*R_z_z
    floor_first_arm_x = R_x_y*offset
    floor_first_arm_y = R_y_y*offset
    floor_first_arm_z = R_z_y*offset
    floor_first_arm_rate_x = floor_first_arm_z*top_turning_y - floor_first_arm_y*top_turning_z
    floor_first_arm_rate_z = floor_first_arm_y*top_turning_x - floor_first_arm_x*top_turning_y
    floor_apart_acceleration_y = flight_y_acceleration + floor_first_arm_rate_x*top_turning_z + floor_first_arm_x*top_angular_acceleration_z - floor_first_arm_rate_z*top_turning_x - floor_first_arm_z*top_angular_acceleration_x
    return ca.vertcat(floor_apart_acceleration_y)


def contact_floor(t, q, u, z, m, c):
    """Forces of floor: power x kelvin_voigt, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): flight.x [N], flight.y [N], flight.z [N], flight.moment_x [N m], flight.moment_y [N m], flight.moment_z [N m]
        dz (2,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    mass, radius, offset, stiffness, friction_coefficient, twice_floor_xi, pace_squared = c[0], c[1], c[2], c[4], c[5], c[7], c[8]
    inverse_friction_speed, friction_coefficient_over_friction_speed = c[9], c[10]
    flight_y = q[1]
    flight_x_speed, flight_y_speed, flight_z_speed, flight_angular_speed_x, flight_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    flight_angular_speed_z = u[5]
    R_x_x, R_x_y, R_x_z, R_y_x, R_y_y, R_y_z, R_z_x, R_z_y, R_z_z = body_R(q[3], q[4], q[5], q[6])
    top_turning_x = flight_angular_speed_x*R_x_x + flight_angular_speed_y*R_x_y + flight_angular_speed_z*R_x_z
    top_turning_y = flight_angular_speed_x*R_y_x + flight_angular_speed_y*R_y_y + flight_angular_speed_z*R_y_z
    top_turning_z = flight_angular_speed_x*R_z_x + flight_angular_speed_y*R_z_y + flight_angular_speed_z*R_z_z
    floor_first_arm_x = R_x_y*offset
    floor_first_arm_y = R_y_y*offset
    floor_first_arm_z = R_z_y*offset
    floor_apart_y = flight_y + floor_first_arm_y
    floor_gap = floor_apart_y - radius
    floor_elastic_force = ca.if_else(-floor_gap > 0, -floor_gap*stiffness, 0)
    floor_relative_rate_y = flight_y_speed + floor_first_arm_x*top_turning_z - floor_first_arm_z*top_turning_x
    base = -floor_elastic_force*mass/floor_gap
    floor_resistance = ca.if_else(-floor_gap > 0, -floor_relative_rate_y*twice_floor_xi*ca.sqrt(base), 0)
    floor_normal_force = floor_elastic_force + floor_resistance
    floor_normal_power = -floor_relative_rate_y*floor_resistance
    top_moment_x = -floor_first_arm_z*floor_normal_force
    top_moment_z = floor_first_arm_x*floor_normal_force
    floor_push_on_flight_moment_x = R_x_x*top_moment_x + R_z_x*top_moment_z
    floor_push_on_flight_moment_y = R_x_y*top_moment_x + R_z_y*top_moment_z
    floor_push_on_flight_moment_z = R_x_z*top_moment_x + R_z_z*top_moment_z
    floor_pressing_force = ca.if_else(floor_normal_force > 0, floor_normal_force, 0)
    floor_first_arm_y_minus_radius = floor_first_arm_y - radius
    floor_sliding_rate_x = flight_x_speed + floor_first_arm_z*top_turning_y - top_turning_z*floor_first_arm_y_minus_radius
    floor_sliding_rate_z = flight_z_speed + top_turning_x*floor_first_arm_y_minus_radius - floor_first_arm_x*top_turning_y
    floor_slip_squared = floor_sliding_rate_x*floor_sliding_rate_x + floor_sliding_rate_z*floor_sliding_rate_z
    base_2 = ca.if_else(floor_slip_squared > 0, floor_slip_squared, pace_squared)
    floor_slip_size = ca.sqrt(base_2)
    floor_sliding_velocity = ca.if_else(floor_slip_squared > 0, floor_slip_size, 0)
    floor_friction_force = floor_pressing_force*friction_coefficient*ca.tanh(floor_sliding_velocity*inverse_friction_speed)
    floor_friction_power = floor_friction_force*floor_sliding_velocity
    floor_friction_slope = floor_pressing_force*friction_coefficient_over_friction_speed
    floor_friction_per_speed = ca.if_else(floor_sliding_velocity > 0, floor_friction_force/floor_slip_size, floor_friction_slope)
    floor_drag_x = -floor_friction_per_speed*floor_sliding_rate_x
    floor_drag_z = -floor_friction_per_speed*floor_sliding_rate_z
    top_moment_x_2 = floor_drag_z*floor_first_arm_y_minus_radius
    top_moment_y = floor_drag_x*floor_first_arm_z - floor_drag_z*floor_first_arm_x
    top_moment_z_2 = -floor_drag_x*floor_first_arm_y_minus_radius
    floor_drag_on_flight_moment_x = R_x_x*top_moment_x_2 + R_y_x*top_moment_y + R_z_x*top_moment_z_2
    floor_drag_on_flight_moment_y = R_x_y*top_moment_x_2 + R_y_y*top_moment_y + R_z_y*top_moment_z_2
    floor_drag_on_flight_moment_z = R_x_z*top_moment_x_2 + R_y_z*top_moment_y + R_z_z*top_moment_z_2
    return (ca.vertcat(floor_drag_x, floor_normal_force, floor_drag_z, floor_drag_on_flight_moment_x + floor_push_on_flight_moment_x,
            floor_drag_on_flight_moment_y + floor_push_on_flight_moment_y, floor_drag_on_flight_moment_z + floor_push_on_flight_moment_z),
        ca.vertcat(floor_normal_power, floor_friction_power), ca.vertcat(floor_normal_force), ca.vertcat(floor_sliding_velocity),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): flight.x [N], flight.y [N], flight.z [N], flight.moment_x [N m], flight.moment_y [N m], flight.moment_z [N m]
    """
    mass, gravity = c[0], c[3]
    return ca.vertcat(0, -gravity*mass, 0, 0, 0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (6,): flight.x_acceleration [m/s^2], flight.y_acceleration [m/s^2], flight.z_acceleration [m/s^2], flight.angular_acceleration_x
            [rad/s^2], flight.angular_acceleration_y [rad/s^2], flight.angular_acceleration_z [rad/s^2]
        reactions (0,): empty
    """
    top_I_y_y_minus_top_I_z_z, inverse_mass, inverse_top_I_z_z, inverse_top_I_y_y = c[11], c[12], c[13], c[14]
    flight_angular_speed_x, flight_angular_speed_y, flight_angular_speed_z = u[3], u[4], u[5]
    flight_x_force, flight_y_force, flight_z_force, flight_moment_x_force, flight_moment_y_force = f[0], f[1], f[2], f[3], f[4]
    flight_moment_z_force = f[5]
    top_rate_yz = flight_angular_speed_y*flight_angular_speed_z
    top_rate_xy = flight_angular_speed_x*flight_angular_speed_y
    top_torque_x = -top_I_y_y_minus_top_I_z_z*top_rate_yz
    top_torque_z = top_I_y_y_minus_top_I_z_z*top_rate_xy
    flight_moment_x_net = flight_moment_x_force - top_torque_x
    flight_moment_z_net = flight_moment_z_force - top_torque_z
    flight_x_acc = flight_x_force*inverse_mass
    flight_y_acc = flight_y_force*inverse_mass
    flight_z_acc = flight_z_force*inverse_mass
    flight_moment_x_acc = flight_moment_x_net*inverse_top_I_z_z
    flight_moment_y_acc = flight_moment_y_force*inverse_top_I_y_y
    flight_moment_z_acc = flight_moment_z_net*inverse_top_I_z_z
    return ca.vertcat(flight_x_acc, flight_y_acc, flight_z_acc, flight_moment_x_acc, flight_moment_y_acc, flight_moment_z_acc), ca.vertcat()


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
        stored (1,): PAIRS [J]
    """
    radius, offset, half_stiffness, half_top_I_y_y, half_top_I_z_z, half_mass = c[1], c[2], c[6], c[15], c[16], c[17]
    gravity_times_mass = c[18]
    flight_y, flight_q0, flight_q1, flight_q2, flight_q3 = q[1], q[3], q[4], q[5], q[6]
    flight_x_speed, flight_y_speed, flight_z_speed, flight_angular_speed_x, flight_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    flight_angular_speed_z = u[5]
    top_twice_q1 = 2*flight_q1
    top_twice_q2 = 2*flight_q2
    top_twice_q3 = 2*flight_q3
    top_q1q1 = flight_q1*top_twice_q1
    top_q2q2 = flight_q2*top_twice_q2
    top_q3q3 = flight_q3*top_twice_q3
    top_q0q1 = flight_q0*top_twice_q1
    top_q0q2 = flight_q0*top_twice_q2
    top_q0q3 = flight_q0*top_twice_q3
    top_R_x_x = 1 - top_q2q2 - top_q3q3
    flight_q2_times_top_twice_q1 = flight_q2*top_twice_q1
    top_R_x_y = flight_q2_times_top_twice_q1 - top_q0q3
    flight_q3_times_top_twice_q1 = flight_q3*top_twice_q1
    top_R_x_z = top_q0q2 + flight_q3_times_top_twice_q1
    top_R_y_x = top_q0q3 + flight_q2_times_top_twice_q1
    top_R_y_y = 1 - top_q1q1 - top_q3q3
    flight_q3_times_top_twice_q2 = flight_q3*top_twice_q2
    top_R_y_z = flight_q3_times_top_twice_q2 - top_q0q1
    top_R_z_x = flight_q3_times_top_twice_q1 - top_q0q2
    top_R_z_y = top_q0q1 + flight_q3_times_top_twice_q2
    top_R_z_z = 1 - top_q1q1 - top_q2q2
    floor_first_arm_y = top_R_y_y*offset
    floor_apart_y = flight_y + floor_first_arm_y
    floor_gap = floor_apart_y - radius
    floor_stored_energy = ca.if_else(-floor_gap > 0, half_stiffness*floor_gap*floor_gap, 0)
    top_velocity_x = flight_x_speed*top_R_x_x + flight_y_speed*top_R_y_x + flight_z_speed*top_R_z_x
    top_velocity_y = flight_x_speed*top_R_x_y + flight_y_speed*top_R_y_y + flight_z_speed*top_R_z_y
    top_velocity_z = flight_x_speed*top_R_x_z + flight_y_speed*top_R_y_z + flight_z_speed*top_R_z_z
    kinetic = half_top_I_y_y*flight_angular_speed_y*flight_angular_speed_y + half_top_I_z_z*flight_angular_speed_x*flight_angular_speed_x + half_top_I_z_z*flight_angular_speed_z*flight_angular_speed_z + half_mass*(top_velocity_x*top_velocity_x + top_velocity_y*top_velocity_y + top_velocity_z*top_velocity_z)
    potential = flight_y*gravity_times_mass
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(floor_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): top.x [m], top.y [m], top.z [m]
        rotations (9,): top.R_xx [1], top.R_xy [1], top.R_xz [1], top.R_yx [1], top.R_yy [1], top.R_yz [1], top.R_zx [1], top.R_zy [1],
            top.R_zz [1]
    """
    flight_x, flight_y, flight_z = q[0], q[1], q[2]
    R_x_x, R_x_y, R_x_z, R_y_x, R_y_y, R_y_z, R_z_x, R_z_y, R_z_z = body_R(q[3], q[4], q[5], q[6])
    return ca.vertcat(flight_x, flight_y, flight_z), ca.vertcat(R_x_x, R_x_y, R_x_z, R_y_x, R_y_y, R_y_z, R_z_x, R_z_y, R_z_z)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (1,): OUTPUTS
    """
    radius, offset = c[1], c[2]
    flight_y, flight_q1, flight_q3 = q[1], q[4], q[6]
    top_twice_q1 = 2*flight_q1
    top_twice_q3 = 2*flight_q3
    top_q1q1 = flight_q1*top_twice_q1
    top_q3q3 = flight_q3*top_twice_q3
    top_R_y_y = 1 - top_q1q1 - top_q3q3
    floor_first_arm_y = top_R_y_y*offset
    floor_apart_y = flight_y + floor_first_arm_y
    floor_gap = floor_apart_y - radius
    return ca.vertcat(floor_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        floor.sphere (4,): x [m], y [m], z [m], radius [m]
        floor.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        top.centre (3,): x [m], y [m], z [m]
    """
    radius, offset = p[1], p[4]
    return ca.vertcat(0, offset, 0, radius), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0)
