"""slider_crank_frictionless: slider-crank, one clearance, without friction. Generated from derive/scenes/slider_crank_frictionless.py.

Do not edit; regenerate with `hertzwerk derive slider_crank_frictionless`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    slider_pin: hertz_point x lankarani_nikravesh
    energy_ledger: work put in, energy dissipated per effect
Units: 87 assignments and 168 outputs checked, all consistent
Operations: flight 131 (equations of motion and gaps); in contact also contact_slider_pin 59
"""

import casadi as ca

NAME = "slider_crank_frictionless"
SOURCE = "derive/scenes/slider_crank_frictionless.py"
SUMMARY = "slider-crank, one clearance, without friction"
FORMAT = "hertzwerk module 1"
DIGEST = "81ff0dd433b27aa353766c8fe08787c9"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("slider_pin", "contact", "hertz_point x lankarani_nikravesh"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

ADVICE = (
    "slider_pin: take a law of line contact (`hertzwerk laws --form line`). At slider_pin a pin in bush touches along a line, and hertz_point is a law of point contact",
)

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0001, "body crank, inertia"),
    ("rod_mass", "kg", 0.21, "body rod, mass"),
    ("rod_inertia", "kg m^2", 0.00025, "body rod, inertia"),
    ("rod_mass_centre", "m", 0.06, "crank pin to mass centre"),
    ("slider_mass", "kg", 0.14, "body slider, mass"),
    ("crank_radius", "m", 0.05, "main bearing to crank pin"),
    ("bush_radius", "mm", 10, "pair slider_pin, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus pin radius"),
    ("rod_length", "m", 0.12, "crank pin to slider pin"),
    ("crank_speed", "rpm", 5000, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect slider_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "1", 0.3, "effect slider_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("bush_radius", "defined", 0, None, True, False, "pair slider_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair slider_pin, clearance"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect slider_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect slider_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "defined", 0, None, True, False, "effect slider_pin, density"),
    ("restitution", "defined", 0, 1, False, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("restitution", "recommended", 0.8, 1, True, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "defined", 0, None, True, False, "effect slider_pin, approach floor"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair slider_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("crank_pin.angle", "rad"), ("guide.travel", "m"))

SPEEDS = (("crank_pin.speed", "rad/s"), ("guide.speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("slider_pin.dissipated", "J"))

LATCHES = (("slider_pin.approach_speed", "m/s", 0),)

PAIRS = (("slider_pin", "pin_in_bush"),)

RELEASES = ("force",)

DISSIPATED = (1,)

GIVEN = ("crank_pin.speed", "guide.travel")

OUTPUTS = (("slider_pin.eccentricity_x", "m"), ("slider_pin.eccentricity_y", "m"))

SPEED_LIMITED = ("slider_pin",)

BODIES = ("crank", "rod", "slider")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("crank_pin", "revolute", "parent", "crank", ("axis",)), ("crank_pin", "revolute", "child", "rod", ("axis",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "slider", ("axis",)),
    ("slider_pin", "pin_in_bush", "pin", "rod", ("radius",)), ("slider_pin", "pin_in_bush", "bush", "slider", ("radius", "axis")),
    ("crank_drive", "turn_drive", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("rod", "body", "centre", "rod", ()), ("slider", "body", "centre", "slider", ()),
)

CONSTANTS = (
    ("rod_mass_centre", "m"), ("crank_radius", "m"), ("clearance", "m"), ("rod_length", "m"), ("crank_speed", "1/s"), ("gravity", "m/s^2"),
    ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"), ("slider_pin_R_min", "m"), ("slider_pin_K", "N/m^1.5"),
    ("two_fifths_of_slider_pin_K", "N/m^1.5"), ("slider_pin_hysteresis_factor", "1"), ("rod_h_x", "kg m"), ("crank_h_x", "kg m"),
    ("crank_rate_zz", "1/s^2"), ("rod_I_z_z", "kg m^2"), ("inverse_rod_I_z_z", "1/(kg m^2)"), ("inverse_slider_mass", "1/kg"),
    ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"), ("half_rod_mass", "kg"),
    ("half_crank_speed_squared_times_crank_inertia", "J"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 35), ("start", 5), ("scales", 12), ("coordinate_rates", 0), ("gaps", 35), ("gap_accelerations", 48),
    ("contact_slider_pin", 59), ("applied", 11), ("accelerations", 37), ("ledger", 1), ("energy", 50), ("poses", 10), ("outputs", 13),
    ("speed_limits", 3), ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (23,): rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, clearance_squared, half_inverse_clearance,
            slider_pin_R_min, slider_pin_K, two_fifths_of_slider_pin_K, slider_pin_hysteresis_factor, rod_h_x, crank_h_x, crank_rate_zz,
            rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
            half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass
    """
    crank_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass, crank_radius, bush_radius = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    clearance, rod_length, crank_speed, gravity, youngs_modulus, poissons_ratio, restitution = p[8], p[9], p[10], p[11], p[12], p[13], p[15]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    slider_pin_R_min = bush_radius - clearance
    slider_pin_R_eff = slider_pin_R_min*bush_radius/clearance
    slider_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    slider_pin_K = 4*slider_pin_E_eff*ca.sqrt(slider_pin_R_eff)/3
    two_fifths_of_slider_pin_K = 2*slider_pin_K/5
    slider_pin_hysteresis_factor = 3/4 - 3*restitution*restitution/4
    rod_h_x = rod_mass*rod_mass_centre
    crank_h_x = crank_radius*rod_mass
    crank_rate_zz = crank_speed*crank_speed
    rod_I_z_z = rod_mass_centre*rod_mass_centre*rod_mass + rod_inertia
    inverse_rod_I_z_z = 1/rod_I_z_z
    inverse_slider_mass = 1/slider_mass
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_mass = rod_mass/2
    half_crank_speed_squared_times_crank_inertia = crank_rate_zz*crank_inertia/2
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, clearance_squared, half_inverse_clearance,
        slider_pin_R_min, slider_pin_K, two_fifths_of_slider_pin_K, slider_pin_hysteresis_factor, rod_h_x, crank_h_x, crank_rate_zz,
        rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
        half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[6], p[9], p[10]
    return ca.vertcat(0, crank_radius + rod_length), ca.vertcat(-(1 + crank_radius/rod_length)*crank_speed, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rod_mass, slider_mass, crank_radius, clearance, rod_length, crank_speed = p[0], p[2], p[5], p[6], p[8], p[9], p[10]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_radius*crank_radius*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance/rod_length, clearance), ca.vertcat(crank_radius*crank_speed/rod_length, crank_radius_times_crank_speed),
        ca.vertcat(energy_scale, energy_scale), ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (2,): crank_pin.angle [rad/s], guide.travel [m/s]
    """
    crank_pin_speed, guide_speed = u[0], u[1]
    return ca.vertcat(crank_pin_speed, guide_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    crank_radius, rod_length, crank_speed, clearance_squared, half_inverse_clearance = c[1], c[3], c[4], c[6], c[7]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_rate_z*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_rate_z*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_arm_rate_x + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_arm_rate_y + slider_pin_pin_arm_rate_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_gap = half_inverse_clearance*(clearance_squared - slider_pin_apart_squared)
    slider_pin_apart_squared_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_x + 2*slider_pin_apart_rate_y*slider_pin_apart_y
    slider_pin_gap_rate = -half_inverse_clearance*slider_pin_apart_squared_rate
    return ca.vertcat(slider_pin_gap), ca.vertcat(slider_pin_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    crank_radius, rod_length, crank_speed, half_inverse_clearance = c[1], c[3], c[4], c[7]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    crank_pin_acceleration, guide_acceleration = a[0], a[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    rod_acceleration_x = -rod_arm_rate_y*crank_speed
    rod_acceleration_y = rod_arm_rate_x*crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_rate_z*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_rate_z*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_arm_rate_x + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_arm_rate_y + slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_x = rod_acceleration_x - guide_acceleration - crank_pin_acceleration*slider_pin_pin_arm_y - rod_rate_z*slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_y = rod_acceleration_y + crank_pin_acceleration*slider_pin_pin_arm_x + rod_rate_z*slider_pin_pin_arm_rate_x
    slider_pin_apart_squared_rate_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_rate_x + 2*slider_pin_apart_rate_y*slider_pin_apart_rate_y + 2*slider_pin_apart_acceleration_x*slider_pin_apart_x + 2*slider_pin_apart_acceleration_y*slider_pin_apart_y
    slider_pin_gap_rate_rate = -half_inverse_clearance*slider_pin_apart_squared_rate_rate
    return ca.vertcat(slider_pin_gap_rate_rate)


def contact_slider_pin(t, q, u, z, m, c):
    """Forces of slider_pin: hertz_point x lankarani_nikravesh. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
        dz (2,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    crank_radius, clearance, rod_length, crank_speed, slider_pin_R_min, slider_pin_K = c[1], c[2], c[3], c[4], c[8], c[9]
    slider_pin_hysteresis_factor = c[11]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    slider_pin_approach_speed = m[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - clearance
    slider_pin_elastic_force = ca.if_else(slider_pin_penetration > 0, slider_pin_K*slider_pin_penetration*ca.sqrt(slider_pin_penetration), 0)
    slider_pin_normal_x = -slider_pin_apart_x/slider_pin_distance
    slider_pin_normal_y = -slider_pin_apart_y/slider_pin_distance
    slider_pin_relative_rate_x = rod_arm_rate_x - guide_speed - rod_rate_z*slider_pin_pin_arm_y
    slider_pin_relative_rate_y = rod_arm_rate_y + rod_rate_z*slider_pin_pin_arm_x
    slider_pin_penetration_rate = -slider_pin_normal_x*slider_pin_relative_rate_x - slider_pin_normal_y*slider_pin_relative_rate_y
    slider_pin_resistance = slider_pin_elastic_force*slider_pin_hysteresis_factor*slider_pin_penetration_rate/slider_pin_approach_speed
    slider_pin_normal_force = slider_pin_elastic_force + slider_pin_resistance
    slider_pin_normal_power = slider_pin_penetration_rate*slider_pin_resistance
    slider_pin_push_x = slider_pin_normal_force*slider_pin_normal_x
    slider_pin_push_y = slider_pin_normal_force*slider_pin_normal_y
    slider_pin_push_on_main_bearing = slider_pin_push_x*(-rod_arm_y - slider_pin_pin_arm_y) + slider_pin_push_y*(rod_arm_x + slider_pin_pin_arm_x)
    slider_pin_push_on_crank_pin = slider_pin_pin_arm_x*slider_pin_push_y - slider_pin_pin_arm_y*slider_pin_push_x
    slider_pin_in_range = ca.if_else(slider_pin_penetration <= slider_pin_R_min, 1, 0)
    return (ca.vertcat(slider_pin_push_on_crank_pin, -slider_pin_push_x, slider_pin_push_on_main_bearing),
        ca.vertcat(0, slider_pin_normal_power), ca.vertcat(slider_pin_normal_force), ca.vertcat(), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
    """
    crank_speed, gravity, rod_h_x, crank_h_x = c[4], c[5], c[12], c[13]
    crank_pin_angle = q[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    rod_moment_x = cos_rod*rod_h_x
    crank_moment_x = cos_crank*crank_h_x
    crank_total_moment_x = crank_moment_x + rod_moment_x
    return ca.vertcat(-rod_moment_x*gravity, 0, -crank_total_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): crank_pin.acceleration [rad/s^2], guide.acceleration [m/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    crank_radius, crank_speed, rod_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z = c[1], c[4], c[12], c[14], c[15], c[16]
    inverse_slider_mass = c[17]
    crank_pin_angle = q[0]
    crank_pin_speed = u[0]
    crank_pin_force, guide_force, main_bearing_force = f[0], f[1], f[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_rate_z = crank_pin_speed + crank_speed
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    rod_rate_zz = rod_rate_z*rod_rate_z
    rod_bias_x = -crank_rate_zz*rod_arm_x
    rod_bias_y = -crank_rate_zz*rod_arm_y
    rod_torque_z = rod_bias_y*rod_moment_x - rod_bias_x*rod_moment_y
    crank_pin_net = crank_pin_force - rod_torque_z
    crank_pin_rod_torque_z = rod_I_z_z + rod_arm_x*rod_moment_x + rod_arm_y*rod_moment_y
    crank_pin_acc = crank_pin_net*inverse_rod_I_z_z
    guide_acc = guide_force*inverse_slider_mass
    rod_force_x = -rod_moment_x*rod_rate_zz
    rod_force_y = -rod_moment_y*rod_rate_zz
    crank_torque_z = rod_torque_z + rod_arm_x*rod_force_y - rod_arm_y*rod_force_x
    main_bearing_reaction = crank_torque_z + crank_pin_acc*crank_pin_rod_torque_z - main_bearing_force
    return ca.vertcat(crank_pin_acc, guide_acc), ca.vertcat(main_bearing_reaction)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    crank_speed = c[4]
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
    rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, two_fifths_of_slider_pin_K = c[0], c[1], c[2], c[3], c[4], c[10]
    rod_h_x, half_rod_I_z_z, half_slider_mass, half_rod_mass = c[12], c[18], c[19], c[20]
    half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass = c[21], c[22]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - clearance
    slider_pin_stored_energy = ca.if_else(slider_pin_penetration > 0, two_fifths_of_slider_pin_K*slider_pin_penetration*slider_pin_penetration*ca.sqrt(slider_pin_penetration), 0)
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    kinetic = half_crank_speed_squared_times_crank_inertia + half_rod_I_z_z*rod_rate_z*rod_rate_z + half_slider_mass*guide_speed*guide_speed + half_rod_mass*(rod_arm_rate_x*rod_arm_rate_x + rod_arm_rate_y*rod_arm_rate_y) + rod_arm_rate_y*rod_moment_x*rod_rate_z - rod_arm_rate_x*rod_moment_y*rod_rate_z
    rod_centre_arm_y = sin_rod*rod_mass_centre
    potential = gravity_times_rod_mass*(rod_arm_y + rod_centre_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(slider_pin_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (9,): crank.x [m], crank.y [m], crank.z [m], rod.x [m], rod.y [m], rod.z [m], slider.x [m], slider.y [m], slider.z [m]
        rotations (27,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], rod.R_xx [1], rod.R_xy [1], rod.R_xz [1], rod.R_yx [1], rod.R_yy [1], rod.R_yz [1], rod.R_zx
            [1], rod.R_zy [1], rod.R_zz [1], slider.R_xx [1], slider.R_xy [1], slider.R_xz [1], slider.R_yx [1], slider.R_yy [1],
            slider.R_yz [1], slider.R_zx [1], slider.R_zy [1], slider.R_zz [1]
    """
    crank_radius, crank_speed = c[1], c[4]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    return (ca.vertcat(0, 0, 0, rod_arm_x, rod_arm_y, 0, guide_travel, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_rod, -sin_rod, 0, sin_rod, cos_rod, 0, 0, 0, 1, 1, 0, 0,
            0, 1, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): OUTPUTS
    """
    crank_radius, rod_length, crank_speed = c[1], c[3], c[4]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    return ca.vertcat(slider_pin_apart_x, slider_pin_apart_y)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (1,): PAIRS [m/s]
    """
    youngs_modulus, density = p[12], p[14]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[10]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent to guide.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        slider_pin.pin (4,): x [m], y [m], z [m], radius [m]
        slider_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        crank_drive.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, rod.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    rod_mass_centre, crank_radius, bush_radius, clearance, rod_length = p[4], p[6], p[7], p[8], p[9]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_radius, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(rod_length, 0, 0, bush_radius - clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(rod_mass_centre, 0, 0), ca.vertcat(0, 0, 0))
