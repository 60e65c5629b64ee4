"""four_bar_clearance: four-bar linkage with one clearance joint. Generated from derive/scenes/four_bar_clearance.py.

Do not edit; regenerate with `hertzwerk derive four_bar_clearance`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    rocker_pin: hertz_point x flores
    rocker_pin_friction: smooth_coulomb at rocker_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 112 assignments and 179 outputs checked, all consistent
Operations: flight 162 (equations of motion and gaps); in contact also contact_rocker_pin 113
"""

import casadi as ca

NAME = "four_bar_clearance"
SOURCE = "derive/scenes/four_bar_clearance.py"
SUMMARY = "four-bar linkage with one clearance joint"
FORMAT = "hertzwerk module 1"
DIGEST = "7d5704877139d1a19e05b0fd2b1791d0"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("rocker_pin", "contact", "hertz_point x flores"), ("rocker_pin_friction", "friction", "smooth_coulomb at rocker_pin"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

ADVICE = (
    "rocker_pin: take a law of line contact (`hertzwerk laws --form line`). At rocker_pin a pin in bush touches along a line, and hertz_point is a law of point contact",
)

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0001, "body crank, inertia"),
    ("coupler_mass", "kg", 0.21, "body coupler, mass"),
    ("coupler_inertia", "kg m^2", 0.00025, "body coupler, inertia"),
    ("coupler_length", "m", 0.12, "point of coupler"),
    ("rocker_mass", "kg", 0.18, "body rocker, mass"),
    ("rocker_inertia", "kg m^2", 0.00015, "body rocker, inertia"),
    ("rocker_length", "m", 0.1, "point of rocker"),
    ("crank_length", "m", 0.05, "point of crank"),
    ("base_length", "m", 0.13, "between the fixed pivots"),
    ("bush_radius", "mm", 10, "pair rocker_pin, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus pin radius"),
    ("crank_speed", "rpm", 1000, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect rocker_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "1", 0.3, "effect rocker_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect rocker_pin, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.1, "effect rocker_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect rocker_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("coupler_mass", "defined", 0, None, True, False, "body coupler, mass"),
    ("coupler_inertia", "defined", 0, None, False, False, "body coupler, inertia"),
    ("rocker_mass", "defined", 0, None, True, False, "body rocker, mass"),
    ("rocker_inertia", "defined", 0, None, False, False, "body rocker, inertia"),
    ("bush_radius", "defined", 0, None, True, False, "pair rocker_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair rocker_pin, clearance"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect rocker_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect rocker_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "defined", 0, None, True, False, "effect rocker_pin, density"),
    ("restitution", "defined", 0, 1, True, False, "effect rocker_pin, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect rocker_pin, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect rocker_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect rocker_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("coupler_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair rocker_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("crank_pin.angle", "rad"), ("rocker_bearing.angle", "rad"))

SPEEDS = (("crank_pin.speed", "rad/s"), ("rocker_bearing.speed", "rad/s"))

MEMORY = (("energy_ledger.input", "J"), ("rocker_pin.dissipated", "J"), ("rocker_pin_friction.dissipated", "J"))

LATCHES = (("rocker_pin.approach_speed", "m/s", 0),)

PAIRS = (("rocker_pin", "pin_in_bush"),)

RELEASES = ("force",)

DISSIPATED = (1,)

GIVEN = ("crank_pin.angle", "crank_pin.speed", "rocker_bearing.angle", "rocker_bearing.speed")

OUTPUTS = (("rocker_pin.eccentricity_x", "m"), ("rocker_pin.eccentricity_y", "m"))

SPEED_LIMITED = ("rocker_pin",)

BODIES = ("crank", "coupler", "rocker")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("crank_pin", "revolute", "parent", "crank", ("axis",)), ("crank_pin", "revolute", "child", "coupler", ("axis",)),
    ("rocker_bearing", "revolute", "parent", "ground", ("axis",)), ("rocker_bearing", "revolute", "child", "rocker", ("axis",)),
    ("rocker_pin", "pin_in_bush", "pin", "coupler", ("radius",)), ("rocker_pin", "pin_in_bush", "bush", "rocker", ("radius", "axis")),
    ("crank_drive", "turn_drive", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("coupler", "body", "centre", "coupler", ()), ("rocker", "body", "centre", "rocker", ()),
)

CONSTANTS = (
    ("coupler_length", "m"), ("rocker_length", "m"), ("crank_length", "m"), ("base_length", "m"), ("clearance", "m"),
    ("crank_speed", "1/s"), ("gravity", "m/s^2"), ("friction_coefficient", "1"), ("clearance_squared", "m^2"),
    ("half_inverse_clearance", "1/m"), ("rocker_pin_R_min", "m"), ("rocker_pin_K", "N/m^1.5"), ("two_fifths_of_rocker_pin_K", "N/m^1.5"),
    ("rocker_pin_hysteresis_factor", "1"), ("inverse_friction_speed", "s/m"), ("coupler_h_x", "kg m"), ("rocker_h_x", "kg m"),
    ("crank_h_x", "kg m"), ("crank_rate_zz", "1/s^2"), ("coupler_I_z_z", "kg m^2"), ("inverse_coupler_I_z_z", "1/(kg m^2)"),
    ("inverse_rocker_I_z_z", "1/(kg m^2)"), ("half_coupler_I_z_z", "kg m^2"), ("half_rocker_I_z_z", "kg m^2"), ("half_coupler_mass", "kg"),
    ("half_crank_speed_squared_times_crank_inertia", "J"), ("half_coupler_length", "m"), ("half_rocker_length", "m"),
    ("gravity_times_rocker_mass", "N"), ("coupler_mass_times_gravity", "N"),
)

OPERATIONS = (
    ("constants", 46), ("start", 48), ("scales", 12), ("coordinate_rates", 0), ("gaps", 45), ("gap_accelerations", 65),
    ("contact_rocker_pin", 113), ("applied", 15), ("accelerations", 37), ("ledger", 1), ("energy", 59), ("poses", 13), ("outputs", 25),
    ("speed_limits", 3), ("period", 3), ("landmarks", 3),
)

UNCHECKED = CONTRADICTIONS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (30,): coupler_length, rocker_length, crank_length, base_length, clearance, crank_speed, gravity, friction_coefficient,
            clearance_squared, half_inverse_clearance, rocker_pin_R_min, rocker_pin_K, two_fifths_of_rocker_pin_K,
            rocker_pin_hysteresis_factor, inverse_friction_speed, coupler_h_x, rocker_h_x, crank_h_x, crank_rate_zz, coupler_I_z_z,
            inverse_coupler_I_z_z, inverse_rocker_I_z_z, half_coupler_I_z_z, half_rocker_I_z_z, half_coupler_mass,
            half_crank_speed_squared_times_crank_inertia, half_coupler_length, half_rocker_length, gravity_times_rocker_mass,
            coupler_mass_times_gravity
    """
    crank_inertia, coupler_mass, coupler_inertia, coupler_length, rocker_mass, rocker_inertia = p[1], p[2], p[3], p[4], p[5], p[6]
    rocker_length, crank_length, base_length, bush_radius, clearance, crank_speed, gravity = p[7], p[8], p[9], p[10], p[11], p[12], p[13]
    youngs_modulus, poissons_ratio, restitution, friction_coefficient, friction_speed = p[14], p[15], p[17], p[19], p[20]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    rocker_pin_R_min = bush_radius - clearance
    rocker_pin_R_eff = rocker_pin_R_min*bush_radius/clearance
    rocker_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    rocker_pin_K = 4*rocker_pin_E_eff*ca.sqrt(rocker_pin_R_eff)/3
    two_fifths_of_rocker_pin_K = 2*rocker_pin_K/5
    rocker_pin_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_friction_speed = 1/friction_speed
    coupler_h_x = coupler_length*coupler_mass/2
    rocker_h_x = rocker_length*rocker_mass/2
    crank_h_x = coupler_mass*crank_length
    crank_rate_zz = crank_speed*crank_speed
    coupler_I_z_z = coupler_length*coupler_length*coupler_mass/4 + coupler_inertia
    rocker_I_z_z = rocker_length*rocker_length*rocker_mass/4 + rocker_inertia
    inverse_coupler_I_z_z = 1/coupler_I_z_z
    inverse_rocker_I_z_z = 1/rocker_I_z_z
    half_coupler_I_z_z = coupler_I_z_z/2
    half_rocker_I_z_z = rocker_I_z_z/2
    half_coupler_mass = coupler_mass/2
    half_crank_speed_squared_times_crank_inertia = crank_rate_zz*crank_inertia/2
    half_coupler_length = coupler_length/2
    half_rocker_length = rocker_length/2
    gravity_times_rocker_mass = gravity*rocker_mass
    coupler_mass_times_gravity = coupler_mass*gravity
    return ca.vertcat(coupler_length, rocker_length, crank_length, base_length, clearance, crank_speed, gravity, friction_coefficient,
        clearance_squared, half_inverse_clearance, rocker_pin_R_min, rocker_pin_K, two_fifths_of_rocker_pin_K, rocker_pin_hysteresis_factor,
        inverse_friction_speed, coupler_h_x, rocker_h_x, crank_h_x, crank_rate_zz, coupler_I_z_z, inverse_coupler_I_z_z,
        inverse_rocker_I_z_z, half_coupler_I_z_z, half_rocker_I_z_z, half_coupler_mass, half_crank_speed_squared_times_crank_inertia,
        half_coupler_length, half_rocker_length, gravity_times_rocker_mass, coupler_mass_times_gravity)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    coupler_length, rocker_length, crank_length, base_length, crank_speed = p[4], p[7], p[8], p[9], p[12]
    base_length_minus_crank_length = base_length - crank_length
    x2 = base_length_minus_crank_length*base_length_minus_crank_length
    coupler_length_squared = coupler_length*coupler_length
    rocker_length_squared = rocker_length*rocker_length
    minus_rocker_length_squared = -rocker_length_squared
    x6 = x2 + coupler_length_squared + minus_rocker_length_squared
    x7 = x6/(2*base_length_minus_crank_length*coupler_length)
    x8 = ca.acos(x7)
    minus_coupler_length_squared = -coupler_length_squared
    x10 = x2 + rocker_length_squared + minus_coupler_length_squared
    x11 = x10/(2*base_length_minus_crank_length*rocker_length)
    x12 = ca.acos(x11)
    x13 = 1/(base_length_minus_crank_length*base_length_minus_crank_length)
    x14 = x12 + x8
    x15 = ca.sin(x14)
    return (ca.vertcat(x8, 3.141592653589793 - x12),
        ca.vertcat(-crank_speed - ca.sqrt(1 - x13*x10*x10/(4*rocker_length*rocker_length))*crank_length*crank_speed/(x15*coupler_length),
            -ca.sqrt(1 - x13*x6*x6/(4*coupler_length*coupler_length))*crank_length*crank_speed/(x15*rocker_length)))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (3,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, coupler_mass, coupler_length, rocker_mass, crank_length, clearance, crank_speed = p[0], p[2], p[4], p[5], p[8], p[11], p[12]
    total_mass = coupler_mass + crank_mass + rocker_mass
    energy_scale = total_mass*crank_length*crank_length*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    clearance_over_coupler_length = clearance/coupler_length
    x2 = crank_length*crank_speed/coupler_length
    return (ca.vertcat(clearance_over_coupler_length, clearance_over_coupler_length), ca.vertcat(x2, x2),
        ca.vertcat(energy_scale, energy_scale, energy_scale), ca.vertcat(clearance, crank_length*crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (2,): COORDINATES [rad/s]
    """
    crank_pin_speed, rocker_bearing_speed = u[0], u[1]
    return ca.vertcat(crank_pin_speed, rocker_bearing_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    coupler_length, rocker_length, crank_length, base_length, crank_speed, clearance_squared = c[0], c[1], c[2], c[3], c[5], c[8]
    half_inverse_clearance = c[9]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_pin_speed, rocker_bearing_speed = u[0], u[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    coupler_arm_rate_x = -coupler_arm_y*crank_speed
    coupler_arm_rate_y = coupler_arm_x*crank_speed
    coupler_rate_z = crank_pin_speed + crank_speed
    rocker_pin_pin_arm_x = cos_coupler*coupler_length
    rocker_pin_pin_arm_y = sin_coupler*coupler_length
    rocker_pin_pin_arm_rate_x = -coupler_rate_z*rocker_pin_pin_arm_y
    rocker_pin_pin_arm_rate_y = coupler_rate_z*rocker_pin_pin_arm_x
    rocker_pin_bush_arm_x = cos_rocker*rocker_length
    rocker_pin_bush_arm_y = sin_rocker*rocker_length
    rocker_pin_bush_arm_rate_x = -rocker_bearing_speed*rocker_pin_bush_arm_y
    rocker_pin_bush_arm_rate_y = rocker_bearing_speed*rocker_pin_bush_arm_x
    rocker_pin_apart_x = coupler_arm_x + rocker_pin_pin_arm_x - rocker_pin_bush_arm_x - base_length
    rocker_pin_apart_y = coupler_arm_y + rocker_pin_pin_arm_y - rocker_pin_bush_arm_y
    rocker_pin_apart_rate_x = coupler_arm_rate_x + rocker_pin_pin_arm_rate_x - rocker_pin_bush_arm_rate_x
    rocker_pin_apart_rate_y = coupler_arm_rate_y + rocker_pin_pin_arm_rate_y - rocker_pin_bush_arm_rate_y
    rocker_pin_apart_squared = rocker_pin_apart_x*rocker_pin_apart_x + rocker_pin_apart_y*rocker_pin_apart_y
    rocker_pin_gap = half_inverse_clearance*(clearance_squared - rocker_pin_apart_squared)
    rocker_pin_apart_squared_rate = 2*rocker_pin_apart_rate_x*rocker_pin_apart_x + 2*rocker_pin_apart_rate_y*rocker_pin_apart_y
    rocker_pin_gap_rate = -half_inverse_clearance*rocker_pin_apart_squared_rate
    return ca.vertcat(rocker_pin_gap), ca.vertcat(rocker_pin_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    coupler_length, rocker_length, crank_length, base_length, crank_speed, half_inverse_clearance = c[0], c[1], c[2], c[3], c[5], c[9]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_pin_speed, rocker_bearing_speed = u[0], u[1]
    crank_pin_acceleration, rocker_bearing_acceleration = a[0], a[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    coupler_arm_rate_x = -coupler_arm_y*crank_speed
    coupler_arm_rate_y = coupler_arm_x*crank_speed
    coupler_rate_z = crank_pin_speed + crank_speed
    coupler_acceleration_x = -coupler_arm_rate_y*crank_speed
    coupler_acceleration_y = coupler_arm_rate_x*crank_speed
    rocker_pin_pin_arm_x = cos_coupler*coupler_length
    rocker_pin_pin_arm_y = sin_coupler*coupler_length
    rocker_pin_pin_arm_rate_x = -coupler_rate_z*rocker_pin_pin_arm_y
    rocker_pin_pin_arm_rate_y = coupler_rate_z*rocker_pin_pin_arm_x
    rocker_pin_bush_arm_x = cos_rocker*rocker_length
    rocker_pin_bush_arm_y = sin_rocker*rocker_length
    rocker_pin_bush_arm_rate_x = -rocker_bearing_speed*rocker_pin_bush_arm_y
    rocker_pin_bush_arm_rate_y = rocker_bearing_speed*rocker_pin_bush_arm_x
    rocker_pin_apart_x = coupler_arm_x + rocker_pin_pin_arm_x - rocker_pin_bush_arm_x - base_length
    rocker_pin_apart_y = coupler_arm_y + rocker_pin_pin_arm_y - rocker_pin_bush_arm_y
    rocker_pin_apart_rate_x = coupler_arm_rate_x + rocker_pin_pin_arm_rate_x - rocker_pin_bush_arm_rate_x
    rocker_pin_apart_rate_y = coupler_arm_rate_y + rocker_pin_pin_arm_rate_y - rocker_pin_bush_arm_rate_y
    rocker_pin_apart_acceleration_x = coupler_acceleration_x + rocker_bearing_acceleration*rocker_pin_bush_arm_y + rocker_bearing_speed*rocker_pin_bush_arm_rate_y - coupler_rate_z*rocker_pin_pin_arm_rate_y - crank_pin_acceleration*rocker_pin_pin_arm_y
    rocker_pin_apart_acceleration_y = coupler_acceleration_y + coupler_rate_z*rocker_pin_pin_arm_rate_x + crank_pin_acceleration*rocker_pin_pin_arm_x - rocker_bearing_acceleration*rocker_pin_bush_arm_x - rocker_bearing_speed*rocker_pin_bush_arm_rate_x
    rocker_pin_apart_squared_rate_rate = 2*rocker_pin_apart_rate_x*rocker_pin_apart_rate_x + 2*rocker_pin_apart_rate_y*rocker_pin_apart_rate_y + 2*rocker_pin_apart_acceleration_x*rocker_pin_apart_x + 2*rocker_pin_apart_acceleration_y*rocker_pin_apart_y
    rocker_pin_gap_rate_rate = -half_inverse_clearance*rocker_pin_apart_squared_rate_rate
    return ca.vertcat(rocker_pin_gap_rate_rate)


def contact_rocker_pin(t, q, u, z, m, c):
    """Forces of rocker_pin: hertz_point x flores, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], rocker_bearing [N m], main_bearing [N m]
        dz (3,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    coupler_length, rocker_length, crank_length, base_length, clearance, crank_speed = c[0], c[1], c[2], c[3], c[4], c[5]
    friction_coefficient, rocker_pin_R_min, rocker_pin_K, rocker_pin_hysteresis_factor = c[7], c[10], c[11], c[13]
    inverse_friction_speed = c[14]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_pin_speed, rocker_bearing_speed = u[0], u[1]
    rocker_pin_approach_speed = m[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    coupler_arm_rate_x = -coupler_arm_y*crank_speed
    coupler_arm_rate_y = coupler_arm_x*crank_speed
    coupler_rate_z = crank_pin_speed + crank_speed
    rocker_pin_pin_arm_x = cos_coupler*coupler_length
    rocker_pin_pin_arm_y = sin_coupler*coupler_length
    rocker_pin_bush_arm_x = cos_rocker*rocker_length
    rocker_pin_bush_arm_y = sin_rocker*rocker_length
    rocker_pin_apart_x = coupler_arm_x + rocker_pin_pin_arm_x - rocker_pin_bush_arm_x - base_length
    rocker_pin_apart_y = coupler_arm_y + rocker_pin_pin_arm_y - rocker_pin_bush_arm_y
    rocker_pin_apart_squared = rocker_pin_apart_x*rocker_pin_apart_x + rocker_pin_apart_y*rocker_pin_apart_y
    rocker_pin_distance = ca.sqrt(rocker_pin_apart_squared)
    rocker_pin_penetration = rocker_pin_distance - clearance
    rocker_pin_elastic_force = ca.if_else(rocker_pin_penetration > 0, rocker_pin_K*rocker_pin_penetration*ca.sqrt(rocker_pin_penetration), 0)
    rocker_pin_normal_x = -rocker_pin_apart_x/rocker_pin_distance
    rocker_pin_normal_y = -rocker_pin_apart_y/rocker_pin_distance
    rocker_pin_relative_rate_x = coupler_arm_rate_x + rocker_bearing_speed*(coupler_arm_y + rocker_pin_pin_arm_y) - coupler_rate_z*rocker_pin_pin_arm_y
    x1 = coupler_arm_x + rocker_pin_pin_arm_x - base_length
    rocker_pin_relative_rate_y = coupler_arm_rate_y + coupler_rate_z*rocker_pin_pin_arm_x - rocker_bearing_speed*x1
    rocker_pin_penetration_rate = -rocker_pin_normal_x*rocker_pin_relative_rate_x - rocker_pin_normal_y*rocker_pin_relative_rate_y
    rocker_pin_resistance = rocker_pin_elastic_force*rocker_pin_hysteresis_factor*rocker_pin_penetration_rate/rocker_pin_approach_speed
    rocker_pin_normal_force = rocker_pin_elastic_force + rocker_pin_resistance
    rocker_pin_normal_power = rocker_pin_penetration_rate*rocker_pin_resistance
    rocker_pin_push_x = rocker_pin_normal_force*rocker_pin_normal_x
    rocker_pin_push_y = rocker_pin_normal_force*rocker_pin_normal_y
    minus_coupler_arm_y_minus_rocker_pin_pin_arm_y = -coupler_arm_y - rocker_pin_pin_arm_y
    rocker_pin_push_on_main_bearing = rocker_pin_push_x*minus_coupler_arm_y_minus_rocker_pin_pin_arm_y + rocker_pin_push_y*(coupler_arm_x + rocker_pin_pin_arm_x)
    rocker_pin_push_on_crank_pin = rocker_pin_pin_arm_x*rocker_pin_push_y - rocker_pin_pin_arm_y*rocker_pin_push_x
    rocker_pin_push_on_rocker_bearing = -rocker_pin_push_x*minus_coupler_arm_y_minus_rocker_pin_pin_arm_y - rocker_pin_push_y*x1
    rocker_pin_sliding_velocity = rocker_pin_normal_x*rocker_pin_relative_rate_y - rocker_pin_R_min*(coupler_rate_z - rocker_bearing_speed) - rocker_pin_normal_y*rocker_pin_relative_rate_x
    rocker_pin_friction_force = rocker_pin_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*rocker_pin_sliding_velocity)
    rocker_pin_friction_power = rocker_pin_friction_force*rocker_pin_sliding_velocity
    rocker_pin_drag_x = rocker_pin_friction_force*rocker_pin_normal_y
    rocker_pin_drag_y = -rocker_pin_friction_force*rocker_pin_normal_x
    rocker_pin_R_min_times_rocker_pin_normal_y = rocker_pin_R_min*rocker_pin_normal_y
    x4 = rocker_pin_R_min_times_rocker_pin_normal_y - coupler_arm_y - rocker_pin_pin_arm_y
    minus_rocker_pin_R_min_times_rocker_pin_normal_x = -rocker_pin_R_min*rocker_pin_normal_x
    rocker_pin_drag_on_main_bearing = rocker_pin_drag_x*x4 + rocker_pin_drag_y*(coupler_arm_x + rocker_pin_pin_arm_x + minus_rocker_pin_R_min_times_rocker_pin_normal_x)
    rocker_pin_drag_on_crank_pin = rocker_pin_drag_x*(rocker_pin_R_min_times_rocker_pin_normal_y - rocker_pin_pin_arm_y) + rocker_pin_drag_y*(rocker_pin_pin_arm_x + minus_rocker_pin_R_min_times_rocker_pin_normal_x)
    rocker_pin_drag_on_rocker_bearing = -rocker_pin_drag_x*x4 - rocker_pin_drag_y*(coupler_arm_x + rocker_pin_pin_arm_x + minus_rocker_pin_R_min_times_rocker_pin_normal_x - base_length)
    rocker_pin_in_range = ca.if_else(rocker_pin_penetration <= rocker_pin_R_min, 1, 0)
    return (ca.vertcat(rocker_pin_drag_on_crank_pin + rocker_pin_push_on_crank_pin, rocker_pin_drag_on_rocker_bearing +
            rocker_pin_push_on_rocker_bearing, rocker_pin_drag_on_main_bearing + rocker_pin_push_on_main_bearing),
        ca.vertcat(0, rocker_pin_normal_power, rocker_pin_friction_power), ca.vertcat(rocker_pin_normal_force),
        ca.vertcat(rocker_pin_sliding_velocity), ca.vertcat(rocker_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], rocker_bearing [N m], main_bearing [N m]
    """
    crank_speed, gravity, coupler_h_x, rocker_h_x, crank_h_x = c[5], c[6], c[15], c[16], c[17]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    coupler_moment_x = cos_coupler*coupler_h_x
    rocker_moment_x = cos_rocker*rocker_h_x
    crank_moment_x = cos_crank*crank_h_x
    crank_total_moment_x = coupler_moment_x + crank_moment_x
    return ca.vertcat(-coupler_moment_x*gravity, -rocker_moment_x*gravity, -crank_total_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): crank_pin.acceleration [rad/s^2], rocker_bearing.acceleration [rad/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    crank_length, crank_speed, coupler_h_x, crank_rate_zz, coupler_I_z_z, inverse_coupler_I_z_z = c[2], c[5], c[15], c[18], c[19], c[20]
    inverse_rocker_I_z_z = c[21]
    crank_pin_angle = q[0]
    crank_pin_speed = u[0]
    crank_pin_force, rocker_bearing_force, main_bearing_force = f[0], f[1], f[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    coupler_rate_z = crank_pin_speed + crank_speed
    coupler_moment_x = cos_coupler*coupler_h_x
    coupler_moment_y = coupler_h_x*sin_coupler
    coupler_rate_zz = coupler_rate_z*coupler_rate_z
    coupler_bias_x = -coupler_arm_x*crank_rate_zz
    coupler_bias_y = -coupler_arm_y*crank_rate_zz
    coupler_torque_z = coupler_bias_y*coupler_moment_x - coupler_bias_x*coupler_moment_y
    crank_pin_net = crank_pin_force - coupler_torque_z
    crank_pin_coupler_torque_z = coupler_I_z_z + coupler_arm_x*coupler_moment_x + coupler_arm_y*coupler_moment_y
    crank_pin_acc = crank_pin_net*inverse_coupler_I_z_z
    rocker_bearing_acc = inverse_rocker_I_z_z*rocker_bearing_force
    coupler_force_x = -coupler_moment_x*coupler_rate_zz
    coupler_force_y = -coupler_moment_y*coupler_rate_zz
    crank_torque_z = coupler_torque_z + coupler_arm_x*coupler_force_y - coupler_arm_y*coupler_force_x
    main_bearing_reaction = crank_torque_z + crank_pin_acc*crank_pin_coupler_torque_z - main_bearing_force
    return ca.vertcat(crank_pin_acc, rocker_bearing_acc), ca.vertcat(main_bearing_reaction)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (3,): MEMORY [W]
    """
    crank_speed = c[5]
    main_bearing_reaction_in = reactions[0]
    return ca.vertcat(main_bearing_reaction_in*crank_speed, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    coupler_length, rocker_length, crank_length, base_length, clearance, crank_speed = c[0], c[1], c[2], c[3], c[4], c[5]
    two_fifths_of_rocker_pin_K, coupler_h_x, half_coupler_I_z_z, half_rocker_I_z_z, half_coupler_mass = c[12], c[15], c[22], c[23], c[24]
    half_crank_speed_squared_times_crank_inertia, half_coupler_length, half_rocker_length = c[25], c[26], c[27]
    gravity_times_rocker_mass, coupler_mass_times_gravity = c[28], c[29]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_pin_speed, rocker_bearing_speed = u[0], u[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    coupler_arm_rate_x = -coupler_arm_y*crank_speed
    coupler_arm_rate_y = coupler_arm_x*crank_speed
    coupler_rate_z = crank_pin_speed + crank_speed
    rocker_pin_pin_arm_x = cos_coupler*coupler_length
    rocker_pin_pin_arm_y = sin_coupler*coupler_length
    rocker_pin_bush_arm_x = cos_rocker*rocker_length
    rocker_pin_bush_arm_y = sin_rocker*rocker_length
    rocker_pin_apart_x = coupler_arm_x + rocker_pin_pin_arm_x - rocker_pin_bush_arm_x - base_length
    rocker_pin_apart_y = coupler_arm_y + rocker_pin_pin_arm_y - rocker_pin_bush_arm_y
    rocker_pin_apart_squared = rocker_pin_apart_x*rocker_pin_apart_x + rocker_pin_apart_y*rocker_pin_apart_y
    rocker_pin_distance = ca.sqrt(rocker_pin_apart_squared)
    rocker_pin_penetration = rocker_pin_distance - clearance
    rocker_pin_stored_energy = ca.if_else(rocker_pin_penetration > 0, two_fifths_of_rocker_pin_K*rocker_pin_penetration*rocker_pin_penetration*ca.sqrt(rocker_pin_penetration), 0)
    coupler_moment_x = cos_coupler*coupler_h_x
    coupler_moment_y = coupler_h_x*sin_coupler
    kinetic = half_crank_speed_squared_times_crank_inertia + half_coupler_mass*(coupler_arm_rate_x*coupler_arm_rate_x + coupler_arm_rate_y*coupler_arm_rate_y) + half_coupler_I_z_z*coupler_rate_z*coupler_rate_z + half_rocker_I_z_z*rocker_bearing_speed*rocker_bearing_speed + coupler_arm_rate_y*coupler_moment_x*coupler_rate_z - coupler_arm_rate_x*coupler_moment_y*coupler_rate_z
    coupler_centre_arm_y = half_coupler_length*sin_coupler
    rocker_centre_arm_y = half_rocker_length*sin_rocker
    potential = gravity_times_rocker_mass*rocker_centre_arm_y + coupler_mass_times_gravity*(coupler_arm_y + coupler_centre_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(rocker_pin_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (9,): crank.x [m], crank.y [m], crank.z [m], coupler.x [m], coupler.y [m], coupler.z [m], rocker.x [m], rocker.y [m],
            rocker.z [m]
        rotations (27,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], coupler.R_xx [1], coupler.R_xy [1], coupler.R_xz [1], coupler.R_yx [1], coupler.R_yy [1],
            coupler.R_yz [1], coupler.R_zx [1], coupler.R_zy [1], coupler.R_zz [1], rocker.R_xx [1], rocker.R_xy [1], rocker.R_xz [1],
            rocker.R_yx [1], rocker.R_yy [1], rocker.R_yz [1], rocker.R_zx [1], rocker.R_zy [1], rocker.R_zz [1]
    """
    crank_length, base_length, crank_speed = c[2], c[3], c[5]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    return (ca.vertcat(0, 0, 0, coupler_arm_x, coupler_arm_y, 0, base_length, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_coupler, -sin_coupler, 0, sin_coupler, cos_coupler, 0, 0,
            0, 1, cos_rocker, -sin_rocker, 0, sin_rocker, cos_rocker, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): OUTPUTS
    """
    coupler_length, rocker_length, crank_length, base_length, crank_speed = c[0], c[1], c[2], c[3], c[5]
    crank_pin_angle, rocker_bearing_angle = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_angle = crank_angle + crank_pin_angle
    cos_coupler = ca.cos(coupler_angle)
    sin_coupler = ca.sin(coupler_angle)
    cos_rocker = ca.cos(rocker_bearing_angle)
    sin_rocker = ca.sin(rocker_bearing_angle)
    coupler_arm_x = cos_crank*crank_length
    coupler_arm_y = sin_crank*crank_length
    rocker_pin_pin_arm_x = cos_coupler*coupler_length
    rocker_pin_pin_arm_y = sin_coupler*coupler_length
    rocker_pin_bush_arm_x = cos_rocker*rocker_length
    rocker_pin_bush_arm_y = sin_rocker*rocker_length
    rocker_pin_apart_x = coupler_arm_x + rocker_pin_pin_arm_x - rocker_pin_bush_arm_x - base_length
    rocker_pin_apart_y = coupler_arm_y + rocker_pin_pin_arm_y - rocker_pin_bush_arm_y
    rocker_pin_eccentricity_x = cos_rocker*rocker_pin_apart_x + rocker_pin_apart_y*sin_rocker
    rocker_pin_eccentricity_y = cos_rocker*rocker_pin_apart_y - rocker_pin_apart_x*sin_rocker
    return ca.vertcat(rocker_pin_eccentricity_x, rocker_pin_eccentricity_y)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (1,): PAIRS [m/s]
    """
    youngs_modulus, density = p[14], p[16]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[12]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent to rocker_bearing.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        rocker_pin.pin (4,): x [m], y [m], z [m], radius [m]
        rocker_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        crank_drive.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, coupler.centre, rocker.centre (3,): x [m], y [m], z [m]
    """
    coupler_length, rocker_length, crank_length, base_length, bush_radius, clearance = p[4], p[7], p[8], p[9], p[10], p[11]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(base_length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(coupler_length, 0, 0, bush_radius - clearance),
        ca.vertcat(rocker_length, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(coupler_length/2, 0, 0), ca.vertcat(rocker_length/2, 0, 0))
