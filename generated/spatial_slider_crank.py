"""spatial_slider_crank: spatial slider-crank, clearance in a ball joint. Generated from derive/scenes/spatial_slider_crank.py.

Do not edit; regenerate with `hertzwerk derive spatial_slider_crank`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    crank_ball: hertz_point x flores
    energy_ledger: work put in, energy dissipated per effect
Units: 130 assignments and 181 outputs checked, all consistent
Operations: flight 220 (equations of motion and gaps); in contact also contact_crank_ball 94
"""

import casadi as ca

NAME = "spatial_slider_crank"
SOURCE = "derive/scenes/spatial_slider_crank.py"
SUMMARY = "spatial slider-crank, clearance in a ball joint"
FORMAT = "hertzwerk module 1"
DIGEST = "74346f25c46db83067b9263b851ecd70"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("crank_ball", "contact", "hertz_point x flores"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("crank_mass", "kg", 0.12, "body crank, mass"),
    ("crank_inertia_x", "kg m^2", 0.0001, "body crank, inertia"),
    ("crank_inertia_y", "kg m^2", 1e-05, "body crank, inertia"),
    ("crank_inertia_z", "kg m^2", 0.0001, "body crank, inertia"),
    ("slider_mass", "kg", 2.0, "body slider, mass"),
    ("rod_mass", "kg", 0.5, "body rod, mass"),
    ("rod_inertia_x", "kg m^2", 0.0004, "body rod, inertia"),
    ("rod_inertia_y", "kg m^2", 0.004, "body rod, inertia"),
    ("rod_inertia_z", "kg m^2", 0.004, "body rod, inertia"),
    ("rod_length", "m", 0.3, "scales, arm"),
    ("bearing_y", "m", 0.1, "point of ground"),
    ("bearing_z", "m", 0.12, "point of ground"),
    ("socket_radius", "mm", 10, "pair crank_ball, socket radius"),
    ("clearance", "mm", 0.2, "socket radius minus ball radius"),
    ("crank_length", "m", 0.08, "point of crank"),
    ("crank_speed", "rad/s", 60, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect crank_ball, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "1", 0.3, "effect crank_ball, Poisson's ratio of the first body of hertz_point"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect crank_ball, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia_x", "defined", 0, None, False, False, "body crank, inertia"),
    ("crank_inertia_y", "defined", 0, None, False, False, "body crank, inertia"),
    ("crank_inertia_z", "defined", 0, None, False, False, "body crank, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia_x", "defined", 0, None, False, False, "body rod, inertia"),
    ("rod_inertia_y", "defined", 0, None, False, False, "body rod, inertia"),
    ("rod_inertia_z", "defined", 0, None, False, False, "body rod, inertia"),
    ("socket_radius", "defined", 0, None, True, False, "pair crank_ball, socket radius"),
    ("clearance", "defined", 0, None, True, False, "pair crank_ball, clearance"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect crank_ball, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect crank_ball, Poisson's ratio of the first body of hertz_point"),
    ("density", "defined", 0, None, True, False, "effect crank_ball, density"),
    ("restitution", "defined", 0, 1, True, False, "effect crank_ball, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect crank_ball, approach floor"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("clearance", -1.0), ("socket_radius", 1.0)), "defined", 0, None, True, False, "pair crank_ball, ball radius (socket radius minus clearance)"),
)

COORDINATES = (("guide.travel", "m"), ("slider_joint.angle_1", "rad"), ("slider_joint.angle_2", "rad"))

SPEEDS = (("guide.speed", "m/s"), ("slider_joint.angle_1_speed", "rad/s"), ("slider_joint.angle_2_speed", "rad/s"))

MEMORY = (("energy_ledger.input", "J"), ("crank_ball.dissipated", "J"))

LATCHES = (("crank_ball.approach_speed", "m/s", 0),)

PAIRS = (("crank_ball", "ball_in_socket"),)

RELEASES = ("force",)

DISSIPATED = (1,)

GIVEN = ("guide.travel", "guide.speed", "slider_joint.angle_1", "slider_joint.angle_1_speed", "slider_joint.angle_2")

OUTPUTS = (("crank_ball.eccentricity_x", "m"), ("crank_ball.eccentricity_y", "m"), ("crank_ball.eccentricity_z", "m"))

SPEED_LIMITED = ("crank_ball",)

BODIES = ("crank", "slider", "rod")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "slider", ("axis",)),
    ("slider_joint", "universal", "parent", "slider", ("axis",)), ("slider_joint", "universal", "child", "rod", ("axis",)),
    ("crank_ball", "ball_in_socket", "ball", "rod", ("radius",)), ("crank_ball", "ball_in_socket", "socket", "crank", ("radius",)),
    ("crank_drive", "turn_drive", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("slider", "body", "centre", "slider", ()), ("rod", "body", "centre", "rod", ()),
)

CONSTANTS = (
    ("rod_inertia_x", "kg m^2"), ("rod_length", "m"), ("bearing_y", "m"), ("bearing_z", "m"), ("clearance", "m"), ("crank_length", "m"),
    ("crank_speed", "1/s"), ("gravity", "m/s^2"), ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"),
    ("crank_ball_R_min", "m"), ("crank_ball_K", "N/m^1.5"), ("two_fifths_of_crank_ball_K", "N/m^1.5"),
    ("crank_ball_hysteresis_factor", "1"), ("slider_total_mass", "kg"), ("rod_h_x", "kg m"), ("rod_I_z_z", "kg m^2"),
    ("rod_I_y_y_minus_rod_I_z_z", "kg m^2"), ("rod_inertia_x_minus_rod_I_z_z", "kg m^2"), ("rod_inertia_x_minus_rod_I_y_y", "kg m^2"),
    ("inverse_rod_I_y_y", "1/(kg m^2)"), ("half_rod_I_y_y", "kg m^2"), ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"),
    ("half_rod_inertia_x", "kg m^2"), ("half_rod_mass", "kg"), ("half_crank_speed_squared_times_crank_inertia_x", "J"),
    ("half_rod_length", "m"), ("gravity_times_rod_mass", "N"), ("bearing_z_times_crank_mass_times_gravity", "J"),
)

OPERATIONS = (
    ("constants", 45), ("start", 21), ("scales", 12), ("coordinate_rates", 0), ("gaps", 57), ("gap_accelerations", 92),
    ("contact_crank_ball", 94), ("applied", 5), ("accelerations", 66), ("ledger", 1), ("energy", 72), ("poses", 14), ("outputs", 28),
    ("speed_limits", 3), ("period", 3), ("landmarks", 4),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (30,): rod_inertia_x, rod_length, bearing_y, bearing_z, clearance, crank_length, crank_speed, gravity, clearance_squared,
            half_inverse_clearance, crank_ball_R_min, crank_ball_K, two_fifths_of_crank_ball_K, crank_ball_hysteresis_factor,
            slider_total_mass, rod_h_x, rod_I_z_z, rod_I_y_y_minus_rod_I_z_z, rod_inertia_x_minus_rod_I_z_z, rod_inertia_x_minus_rod_I_y_y,
            inverse_rod_I_y_y, half_rod_I_y_y, half_rod_I_z_z, half_slider_mass, half_rod_inertia_x, half_rod_mass,
            half_crank_speed_squared_times_crank_inertia_x, half_rod_length, gravity_times_rod_mass,
            bearing_z_times_crank_mass_times_gravity
    """
    crank_mass, crank_inertia_x, slider_mass, rod_mass, rod_inertia_x, rod_inertia_y = p[0], p[1], p[4], p[5], p[6], p[7]
    rod_inertia_z, rod_length, bearing_y, bearing_z, socket_radius, clearance, crank_length = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    crank_speed, gravity, youngs_modulus, poissons_ratio, restitution = p[15], p[16], p[17], p[18], p[20]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    crank_ball_R_min = socket_radius - clearance
    crank_ball_R_eff = crank_ball_R_min*socket_radius/clearance
    crank_ball_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    crank_ball_K = 4*crank_ball_E_eff*ca.sqrt(crank_ball_R_eff)/3
    two_fifths_of_crank_ball_K = 2*crank_ball_K/5
    crank_ball_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    slider_total_mass = rod_mass + slider_mass
    rod_h_x = -rod_length*rod_mass/2
    rod_length_squared = rod_length*rod_length
    quarter_of_rod_length_squared_times_rod_mass = rod_length_squared*rod_mass/4
    rod_I_z_z = quarter_of_rod_length_squared_times_rod_mass + rod_inertia_z
    rod_I_y_y = quarter_of_rod_length_squared_times_rod_mass + rod_inertia_y
    rod_I_y_y_minus_rod_I_z_z = rod_I_y_y - rod_I_z_z
    rod_inertia_x_minus_rod_I_z_z = rod_inertia_x - rod_I_z_z
    rod_inertia_x_minus_rod_I_y_y = rod_inertia_x - rod_I_y_y
    inverse_rod_I_y_y = 1/rod_I_y_y
    half_rod_I_y_y = rod_I_y_y/2
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_inertia_x = rod_inertia_x/2
    half_rod_mass = rod_mass/2
    half_crank_speed_squared_times_crank_inertia_x = crank_speed*crank_speed*crank_inertia_x/2
    half_rod_length = rod_length/2
    gravity_times_rod_mass = gravity*rod_mass
    bearing_z_times_crank_mass_times_gravity = bearing_z*crank_mass*gravity
    return ca.vertcat(rod_inertia_x, rod_length, bearing_y, bearing_z, clearance, crank_length, crank_speed, gravity, clearance_squared,
        half_inverse_clearance, crank_ball_R_min, crank_ball_K, two_fifths_of_crank_ball_K, crank_ball_hysteresis_factor, slider_total_mass,
        rod_h_x, rod_I_z_z, rod_I_y_y_minus_rod_I_z_z, rod_inertia_x_minus_rod_I_z_z, rod_inertia_x_minus_rod_I_y_y, inverse_rod_I_y_y,
        half_rod_I_y_y, half_rod_I_z_z, half_slider_mass, half_rod_inertia_x, half_rod_mass, half_crank_speed_squared_times_crank_inertia_x,
        half_rod_length, gravity_times_rod_mass, bearing_z_times_crank_mass_times_gravity)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (3,): SPEEDS
    """
    rod_length, bearing_y, bearing_z, crank_length, crank_speed = p[9], p[10], p[11], p[14], p[15]
    rod_length_squared = rod_length*rod_length
    bearing_z_plus_crank_length = bearing_z + crank_length
    x3 = bearing_z_plus_crank_length*bearing_z_plus_crank_length
    x4 = -x3
    bearing_y_squared = bearing_y*bearing_y
    minus_bearing_y_squared = -bearing_y_squared
    x7 = rod_length_squared + x4 + minus_bearing_y_squared
    x8 = 1/ca.sqrt(x7)
    return (ca.vertcat(ca.sqrt(x7), -ca.atan(x8*bearing_y), ca.asin(bearing_z_plus_crank_length/rod_length)),
        ca.vertcat(x8*bearing_y*crank_length*crank_speed, x8*crank_length*crank_speed, 0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (3,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, slider_mass, rod_mass, rod_length, clearance, crank_length, crank_speed = p[0], p[4], p[5], p[9], p[13], p[14], p[15]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_length*crank_length*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    clearance_over_rod_length = clearance/rod_length
    crank_length_times_crank_speed = crank_length*crank_speed
    crank_length_times_crank_speed_over_rod_length = crank_length*crank_speed/rod_length
    return (ca.vertcat(clearance, clearance_over_rod_length, clearance_over_rod_length),
        ca.vertcat(crank_length_times_crank_speed, crank_length_times_crank_speed_over_rod_length,
            crank_length_times_crank_speed_over_rod_length),
        ca.vertcat(energy_scale, energy_scale), ca.vertcat(clearance, crank_length_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): guide.travel [m/s], slider_joint.angle_1 [rad/s], slider_joint.angle_2 [rad/s]
    """
    guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[0], u[1], u[2]
    return ca.vertcat(guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    rod_length, bearing_y, bearing_z, crank_length, crank_speed, clearance_squared = c[1], c[2], c[3], c[5], c[6], c[8]
    half_inverse_clearance = c[9]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[0], u[1], u[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_turning_x = -sin_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_turning_y = cos_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    crank_ball_ball_arm_x = -rod_R_x_x*rod_length
    crank_ball_ball_arm_y = -rod_R_y_x*rod_length
    crank_ball_ball_arm_z = sin_rod*rod_length
    crank_ball_ball_arm_rate_x = crank_ball_ball_arm_z*rod_turning_y - crank_ball_ball_arm_y*slider_joint_angle_1_speed
    crank_ball_ball_arm_rate_y = crank_ball_ball_arm_x*slider_joint_angle_1_speed - crank_ball_ball_arm_z*rod_turning_x
    crank_ball_ball_arm_rate_z = crank_ball_ball_arm_y*rod_turning_x - crank_ball_ball_arm_x*rod_turning_y
    crank_ball_socket_arm_y = -sin_crank*crank_length
    crank_ball_socket_arm_z = cos_crank*crank_length
    crank_ball_socket_arm_rate_y = -crank_ball_socket_arm_z*crank_speed
    crank_ball_socket_arm_rate_z = crank_ball_socket_arm_y*crank_speed
    crank_ball_apart_x = crank_ball_ball_arm_x + guide_travel
    crank_ball_apart_y = crank_ball_ball_arm_y - crank_ball_socket_arm_y - bearing_y
    crank_ball_apart_z = crank_ball_ball_arm_z - crank_ball_socket_arm_z - bearing_z
    crank_ball_apart_rate_x = crank_ball_ball_arm_rate_x + guide_speed
    crank_ball_apart_rate_y = crank_ball_ball_arm_rate_y - crank_ball_socket_arm_rate_y
    crank_ball_apart_rate_z = crank_ball_ball_arm_rate_z - crank_ball_socket_arm_rate_z
    crank_ball_apart_squared = crank_ball_apart_x*crank_ball_apart_x + crank_ball_apart_y*crank_ball_apart_y + crank_ball_apart_z*crank_ball_apart_z
    crank_ball_gap = half_inverse_clearance*(clearance_squared - crank_ball_apart_squared)
    crank_ball_apart_squared_rate = 2*crank_ball_apart_rate_x*crank_ball_apart_x + 2*crank_ball_apart_rate_y*crank_ball_apart_y + 2*crank_ball_apart_rate_z*crank_ball_apart_z
    crank_ball_gap_rate = -crank_ball_apart_squared_rate*half_inverse_clearance
    return ca.vertcat(crank_ball_gap), ca.vertcat(crank_ball_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    rod_length, bearing_y, bearing_z, crank_length, crank_speed, half_inverse_clearance = c[1], c[2], c[3], c[5], c[6], c[9]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[0], u[1], u[2]
    guide_acceleration, slider_joint_angle_1_acceleration, slider_joint_angle_2_acceleration = a[0], a[1], a[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_turning_x = -sin_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_turning_y = cos_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_angular_acceleration_x = -rod_turning_y*slider_joint_angle_1_speed - sin_slider_joint_angle_1*slider_joint_angle_2_acceleration
    rod_angular_acceleration_y = cos_slider_joint_angle_1*slider_joint_angle_2_acceleration + rod_turning_x*slider_joint_angle_1_speed
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    crank_ball_ball_arm_x = -rod_R_x_x*rod_length
    crank_ball_ball_arm_y = -rod_R_y_x*rod_length
    crank_ball_ball_arm_z = sin_rod*rod_length
    crank_ball_ball_arm_rate_x = crank_ball_ball_arm_z*rod_turning_y - crank_ball_ball_arm_y*slider_joint_angle_1_speed
    crank_ball_ball_arm_rate_y = crank_ball_ball_arm_x*slider_joint_angle_1_speed - crank_ball_ball_arm_z*rod_turning_x
    crank_ball_ball_arm_rate_z = crank_ball_ball_arm_y*rod_turning_x - crank_ball_ball_arm_x*rod_turning_y
    crank_ball_socket_arm_y = -sin_crank*crank_length
    crank_ball_socket_arm_z = cos_crank*crank_length
    crank_ball_socket_arm_rate_y = -crank_ball_socket_arm_z*crank_speed
    crank_ball_socket_arm_rate_z = crank_ball_socket_arm_y*crank_speed
    crank_ball_apart_x = crank_ball_ball_arm_x + guide_travel
    crank_ball_apart_y = crank_ball_ball_arm_y - crank_ball_socket_arm_y - bearing_y
    crank_ball_apart_z = crank_ball_ball_arm_z - crank_ball_socket_arm_z - bearing_z
    crank_ball_apart_rate_x = crank_ball_ball_arm_rate_x + guide_speed
    crank_ball_apart_rate_y = crank_ball_ball_arm_rate_y - crank_ball_socket_arm_rate_y
    crank_ball_apart_rate_z = crank_ball_ball_arm_rate_z - crank_ball_socket_arm_rate_z
    crank_ball_apart_acceleration_x = guide_acceleration + crank_ball_ball_arm_rate_z*rod_turning_y + crank_ball_ball_arm_z*rod_angular_acceleration_y - crank_ball_ball_arm_rate_y*slider_joint_angle_1_speed - crank_ball_ball_arm_y*slider_joint_angle_1_acceleration
    crank_ball_apart_acceleration_y = crank_ball_ball_arm_rate_x*slider_joint_angle_1_speed + crank_ball_ball_arm_x*slider_joint_angle_1_acceleration + crank_ball_socket_arm_rate_z*crank_speed - crank_ball_ball_arm_rate_z*rod_turning_x - crank_ball_ball_arm_z*rod_angular_acceleration_x
    crank_ball_apart_acceleration_z = crank_ball_ball_arm_rate_y*rod_turning_x + crank_ball_ball_arm_y*rod_angular_acceleration_x - crank_ball_ball_arm_rate_x*rod_turning_y - crank_ball_ball_arm_x*rod_angular_acceleration_y - crank_ball_socket_arm_rate_y*crank_speed
    crank_ball_apart_squared_rate_rate = 2*crank_ball_apart_rate_x*crank_ball_apart_rate_x + 2*crank_ball_apart_rate_y*crank_ball_apart_rate_y + 2*crank_ball_apart_rate_z*crank_ball_apart_rate_z + 2*crank_ball_apart_acceleration_x*crank_ball_apart_x + 2*crank_ball_apart_acceleration_y*crank_ball_apart_y + 2*crank_ball_apart_acceleration_z*crank_ball_apart_z
    crank_ball_gap_rate_rate = -crank_ball_apart_squared_rate_rate*half_inverse_clearance
    return ca.vertcat(crank_ball_gap_rate_rate)


def contact_crank_ball(t, q, u, z, m, c):
    """Forces of crank_ball: hertz_point x flores. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (4,): guide [N], slider_joint.angle_1 [N m], slider_joint.angle_2 [N m], main_bearing [N m]
        dz (2,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    rod_length, bearing_y, bearing_z, clearance, crank_length, crank_speed, crank_ball_R_min = c[1], c[2], c[3], c[4], c[5], c[6], c[10]
    crank_ball_K, crank_ball_hysteresis_factor = c[11], c[13]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[0], u[1], u[2]
    crank_ball_approach_speed = m[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_turning_x = -sin_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_turning_y = cos_slider_joint_angle_1*slider_joint_angle_2_speed
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    crank_ball_ball_arm_x = -rod_R_x_x*rod_length
    crank_ball_ball_arm_y = -rod_R_y_x*rod_length
    crank_ball_ball_arm_z = sin_rod*rod_length
    crank_ball_socket_arm_y = -sin_crank*crank_length
    crank_ball_socket_arm_z = cos_crank*crank_length
    crank_ball_apart_x = crank_ball_ball_arm_x + guide_travel
    crank_ball_apart_y = crank_ball_ball_arm_y - crank_ball_socket_arm_y - bearing_y
    crank_ball_apart_z = crank_ball_ball_arm_z - crank_ball_socket_arm_z - bearing_z
    crank_ball_apart_squared = crank_ball_apart_x*crank_ball_apart_x + crank_ball_apart_y*crank_ball_apart_y + crank_ball_apart_z*crank_ball_apart_z
    crank_ball_distance = ca.sqrt(crank_ball_apart_squared)
    crank_ball_penetration = crank_ball_distance - clearance
    crank_ball_elastic_force = ca.if_else(crank_ball_penetration > 0, crank_ball_K*crank_ball_penetration*ca.sqrt(crank_ball_penetration), 0)
    crank_ball_normal_x = -crank_ball_apart_x/crank_ball_distance
    crank_ball_normal_y = -crank_ball_apart_y/crank_ball_distance
    crank_ball_normal_z = -crank_ball_apart_z/crank_ball_distance
    crank_ball_relative_rate_x = guide_speed + crank_ball_ball_arm_z*rod_turning_y - crank_ball_ball_arm_y*slider_joint_angle_1_speed
    crank_ball_relative_rate_y = crank_ball_ball_arm_x*slider_joint_angle_1_speed + (crank_ball_ball_arm_z - bearing_z)*crank_speed - crank_ball_ball_arm_z*rod_turning_x
    crank_ball_ball_arm_y_minus_bearing_y = crank_ball_ball_arm_y - bearing_y
    crank_ball_relative_rate_z = crank_ball_ball_arm_y*rod_turning_x - crank_ball_ball_arm_x*rod_turning_y - crank_ball_ball_arm_y_minus_bearing_y*crank_speed
    crank_ball_penetration_rate = -crank_ball_normal_x*crank_ball_relative_rate_x - crank_ball_normal_y*crank_ball_relative_rate_y - crank_ball_normal_z*crank_ball_relative_rate_z
    crank_ball_resistance = crank_ball_elastic_force*crank_ball_hysteresis_factor*crank_ball_penetration_rate/crank_ball_approach_speed
    crank_ball_normal_force = crank_ball_elastic_force + crank_ball_resistance
    crank_ball_normal_power = crank_ball_penetration_rate*crank_ball_resistance
    crank_ball_push_x = crank_ball_normal_force*crank_ball_normal_x
    crank_ball_push_y = crank_ball_normal_force*crank_ball_normal_y
    crank_ball_push_z = crank_ball_normal_force*crank_ball_normal_z
    crank_ball_push_on_slider_joint_angle_1 = crank_ball_ball_arm_x*crank_ball_push_y - crank_ball_ball_arm_y*crank_ball_push_x
    crank_ball_push_on_slider_joint_angle_2 = crank_ball_push_z*(-cos_slider_joint_angle_1*crank_ball_ball_arm_x - crank_ball_ball_arm_y*sin_slider_joint_angle_1) + cos_slider_joint_angle_1*crank_ball_ball_arm_z*crank_ball_push_x + crank_ball_ball_arm_z*crank_ball_push_y*sin_slider_joint_angle_1
    crank_ball_push_on_main_bearing = -crank_ball_push_y*(bearing_z - crank_ball_ball_arm_z) - crank_ball_push_z*crank_ball_ball_arm_y_minus_bearing_y
    crank_ball_in_range = ca.if_else(crank_ball_penetration <= crank_ball_R_min, 1, 0)
    return (ca.vertcat(crank_ball_push_x, crank_ball_push_on_slider_joint_angle_1, crank_ball_push_on_slider_joint_angle_2,
            crank_ball_push_on_main_bearing),
        ca.vertcat(0, crank_ball_normal_power), ca.vertcat(crank_ball_normal_force), ca.vertcat(), ca.vertcat(crank_ball_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (4,): guide [N], slider_joint.angle_1 [N m], slider_joint.angle_2 [N m], main_bearing [N m]
    """
    gravity, rod_h_x = c[7], c[15]
    slider_joint_angle_2 = q[2]
    cos_rod = ca.cos(slider_joint_angle_2)
    rod_gravity_z = -cos_rod*gravity
    return ca.vertcat(0, 0, -rod_gravity_z*rod_h_x, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (3,): guide.acceleration [m/s^2], slider_joint.angle_1_acceleration [rad/s^2], slider_joint.angle_2_acceleration [rad/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    rod_inertia_x, slider_total_mass, rod_h_x, rod_I_z_z, rod_I_y_y_minus_rod_I_z_z = c[0], c[14], c[15], c[16], c[17]
    rod_inertia_x_minus_rod_I_z_z, rod_inertia_x_minus_rod_I_y_y, inverse_rod_I_y_y = c[18], c[19], c[20]
    slider_joint_angle_1, slider_joint_angle_2 = q[1], q[2]
    slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[1], u[2]
    guide_force, slider_joint_angle_1_force, slider_joint_angle_2_force, main_bearing_force = f[0], f[1], f[2], f[3]
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    slider_joint_angle_1_total_moment_y = cos_rod*rod_h_x*sin_slider_joint_angle_1
    rod_w_x = -sin_rod*slider_joint_angle_1_speed
    rod_w_z = cos_rod*slider_joint_angle_1_speed
    rod_angular_bias_x = -rod_w_z*slider_joint_angle_2_speed
    rod_angular_bias_z = rod_w_x*slider_joint_angle_2_speed
    rod_rate_yy = slider_joint_angle_2_speed*slider_joint_angle_2_speed
    rod_rate_zz = rod_w_z*rod_w_z
    rod_U_x_x = -rod_rate_yy - rod_rate_zz
    rod_U_y_x = 2*rod_angular_bias_z
    rod_rate_zx = rod_w_x*rod_w_z
    rod_force_x = rod_U_x_x*rod_h_x
    rod_force_y = rod_U_y_x*rod_h_x
    rod_force_z = rod_h_x*rod_rate_zx
    slider_joint_angle_1_force_x = cos_slider_joint_angle_1*(cos_rod*rod_force_x + rod_force_z*sin_rod) - rod_force_y*sin_slider_joint_angle_1
    guide_net = guide_force - slider_joint_angle_1_force_x
    rod_rate_yz = rod_w_z*slider_joint_angle_2_speed
    rod_torque_x = rod_angular_bias_x*rod_inertia_x - rod_I_y_y_minus_rod_I_z_z*rod_rate_yz
    rod_torque_y = rod_inertia_x_minus_rod_I_z_z*rod_rate_zx
    rod_torque_z = rod_I_z_z*rod_angular_bias_z - rod_inertia_x_minus_rod_I_y_y*rod_angular_bias_z
    slider_joint_angle_1_torque_z = cos_rod*rod_torque_z - rod_torque_x*sin_rod
    slider_joint_angle_1_net = slider_joint_angle_1_force - slider_joint_angle_1_torque_z
    slider_joint_angle_2_net = slider_joint_angle_2_force - rod_torque_y
    rod_turned_J_swing = rod_inertia_x_minus_rod_I_z_z*sin_rod
    rod_turned_J_z_z = rod_I_z_z + rod_turned_J_swing*sin_rod
    slider_joint_angle_2_rod_force_x = -cos_slider_joint_angle_1*rod_h_x*sin_rod
    l_guide_slider_joint_angle_2 = inverse_rod_I_y_y*slider_joint_angle_2_rod_force_x
    l_guide_slider_joint_angle_1 = -slider_joint_angle_1_total_moment_y/rod_turned_J_z_z
    D_guide = slider_total_mass + l_guide_slider_joint_angle_1*slider_joint_angle_1_total_moment_y - l_guide_slider_joint_angle_2*slider_joint_angle_2_rod_force_x
    y_guide = guide_net - l_guide_slider_joint_angle_1*slider_joint_angle_1_net - l_guide_slider_joint_angle_2*slider_joint_angle_2_net
    guide_acc = y_guide/D_guide
    slider_joint_angle_1_acc = slider_joint_angle_1_net/rod_turned_J_z_z - guide_acc*l_guide_slider_joint_angle_1
    slider_joint_angle_2_acc = inverse_rod_I_y_y*slider_joint_angle_2_net - guide_acc*l_guide_slider_joint_angle_2
    return ca.vertcat(guide_acc, slider_joint_angle_1_acc, slider_joint_angle_2_acc), ca.vertcat(-main_bearing_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    crank_speed = c[6]
    main_bearing_reaction_in = reactions[0]
    return ca.vertcat(main_bearing_reaction_in*crank_speed, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    rod_length, bearing_y, bearing_z, clearance, crank_length, crank_speed = c[1], c[2], c[3], c[4], c[5], c[6]
    two_fifths_of_crank_ball_K, rod_h_x, half_rod_I_y_y, half_rod_I_z_z, half_slider_mass = c[12], c[15], c[21], c[22], c[23]
    half_rod_inertia_x, half_rod_mass, half_crank_speed_squared_times_crank_inertia_x, half_rod_length = c[24], c[25], c[26], c[27]
    gravity_times_rod_mass, bearing_z_times_crank_mass_times_gravity = c[28], c[29]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    guide_speed, slider_joint_angle_1_speed, slider_joint_angle_2_speed = u[0], u[1], u[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    crank_ball_ball_arm_x = -rod_R_x_x*rod_length
    crank_ball_ball_arm_y = -rod_R_y_x*rod_length
    crank_ball_ball_arm_z = sin_rod*rod_length
    crank_ball_socket_arm_y = -sin_crank*crank_length
    crank_ball_socket_arm_z = cos_crank*crank_length
    crank_ball_apart_x = crank_ball_ball_arm_x + guide_travel
    crank_ball_apart_y = crank_ball_ball_arm_y - crank_ball_socket_arm_y - bearing_y
    crank_ball_apart_z = crank_ball_ball_arm_z - crank_ball_socket_arm_z - bearing_z
    crank_ball_apart_squared = crank_ball_apart_x*crank_ball_apart_x + crank_ball_apart_y*crank_ball_apart_y + crank_ball_apart_z*crank_ball_apart_z
    crank_ball_distance = ca.sqrt(crank_ball_apart_squared)
    crank_ball_penetration = crank_ball_distance - clearance
    crank_ball_stored_energy = ca.if_else(crank_ball_penetration > 0, two_fifths_of_crank_ball_K*crank_ball_penetration*crank_ball_penetration*ca.sqrt(crank_ball_penetration), 0)
    rod_w_x = -sin_rod*slider_joint_angle_1_speed
    rod_w_z = cos_rod*slider_joint_angle_1_speed
    rod_velocity_x = cos_rod*cos_slider_joint_angle_1*guide_speed
    rod_velocity_y = -guide_speed*sin_slider_joint_angle_1
    rod_velocity_z = cos_slider_joint_angle_1*guide_speed*sin_rod
    kinetic = half_crank_speed_squared_times_crank_inertia_x + half_slider_mass*guide_speed*guide_speed + half_rod_inertia_x*rod_w_x*rod_w_x + half_rod_mass*(rod_velocity_x*rod_velocity_x + rod_velocity_y*rod_velocity_y + rod_velocity_z*rod_velocity_z) + half_rod_I_y_y*slider_joint_angle_2_speed*slider_joint_angle_2_speed + half_rod_I_z_z*rod_w_z*rod_w_z + rod_h_x*rod_velocity_y*rod_w_z - rod_h_x*rod_velocity_z*slider_joint_angle_2_speed
    rod_centre_arm_z = half_rod_length*sin_rod
    potential = bearing_z_times_crank_mass_times_gravity + gravity_times_rod_mass*rod_centre_arm_z
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(crank_ball_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (9,): crank.x [m], crank.y [m], crank.z [m], slider.x [m], slider.y [m], slider.z [m], rod.x [m], rod.y [m], rod.z [m]
        rotations (27,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], slider.R_xx [1], slider.R_xy [1], slider.R_xz [1], slider.R_yx [1], slider.R_yy [1], slider.R_yz
            [1], slider.R_zx [1], slider.R_zy [1], slider.R_zz [1], rod.R_xx [1], rod.R_xy [1], rod.R_xz [1], rod.R_yx [1], rod.R_yy [1],
            rod.R_yz [1], rod.R_zx [1], rod.R_zy [1], rod.R_zz [1]
    """
    bearing_y, bearing_z, crank_speed = c[2], c[3], c[6]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_x_z = cos_slider_joint_angle_1*sin_rod
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    rod_R_y_z = sin_rod*sin_slider_joint_angle_1
    return (ca.vertcat(0, bearing_y, bearing_z, guide_travel, 0, 0, guide_travel, 0, 0),
        ca.vertcat(1, 0, 0, 0, cos_crank, -sin_crank, 0, sin_crank, cos_crank, 1, 0, 0, 0, 1, 0, 0, 0, 1, rod_R_x_x,
            -sin_slider_joint_angle_1, rod_R_x_z, rod_R_y_x, cos_slider_joint_angle_1, rod_R_y_z, -sin_rod, 0, cos_rod))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (3,): OUTPUTS
    """
    rod_length, bearing_y, bearing_z, crank_length, crank_speed = c[1], c[2], c[3], c[5], c[6]
    guide_travel, slider_joint_angle_1, slider_joint_angle_2 = q[0], q[1], q[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_slider_joint_angle_1 = ca.cos(slider_joint_angle_1)
    sin_slider_joint_angle_1 = ca.sin(slider_joint_angle_1)
    cos_rod = ca.cos(slider_joint_angle_2)
    sin_rod = ca.sin(slider_joint_angle_2)
    rod_R_x_x = cos_rod*cos_slider_joint_angle_1
    rod_R_y_x = cos_rod*sin_slider_joint_angle_1
    crank_ball_ball_arm_x = -rod_R_x_x*rod_length
    crank_ball_ball_arm_y = -rod_R_y_x*rod_length
    crank_ball_ball_arm_z = sin_rod*rod_length
    crank_ball_socket_arm_y = -sin_crank*crank_length
    crank_ball_socket_arm_z = cos_crank*crank_length
    crank_ball_apart_x = crank_ball_ball_arm_x + guide_travel
    crank_ball_apart_y = crank_ball_ball_arm_y - crank_ball_socket_arm_y - bearing_y
    crank_ball_apart_z = crank_ball_ball_arm_z - crank_ball_socket_arm_z - bearing_z
    crank_ball_eccentricity_y = cos_crank*crank_ball_apart_y + crank_ball_apart_z*sin_crank
    crank_ball_eccentricity_z = cos_crank*crank_ball_apart_z - crank_ball_apart_y*sin_crank
    return ca.vertcat(crank_ball_apart_x, crank_ball_eccentricity_y, crank_ball_eccentricity_z)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (1,): PAIRS [m/s]
    """
    youngs_modulus, density = p[17], p[19]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[15]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent to slider_joint.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank_ball.ball, crank_ball.socket (4,): x [m], y [m], z [m], radius [m]
        crank_drive.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, slider.centre, rod.centre (3,): x [m], y [m], z [m]
    """
    rod_length, bearing_y, bearing_z, socket_radius, clearance, crank_length = p[9], p[10], p[11], p[12], p[13], p[14]
    return (ca.vertcat(0, bearing_y, bearing_z, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(-rod_length, 0, 0, socket_radius - clearance), ca.vertcat(0, 0, crank_length, socket_radius),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, -1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0), ca.vertcat(-rod_length/2, 0, 0))
