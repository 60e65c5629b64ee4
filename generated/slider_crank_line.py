"""slider_crank_line: slider-crank, clearance joint with line contact. Generated from derive/scenes/slider_crank_line.py.

Do not edit; regenerate with `hertzwerk derive slider_crank_line`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    slider_pin: liu_with_length x lankarani_nikravesh
    slider_pin_friction: smooth_coulomb at slider_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 127 assignments and 190 outputs checked, all consistent
Operations: flight 131 (equations of motion and gaps); in contact also contact_slider_pin 93
"""

import casadi as ca

NAME = "slider_crank_line"
SOURCE = "derive/scenes/slider_crank_line.py"
SUMMARY = "slider-crank, clearance joint with line contact"
FORMAT = "hertzwerk module 1"
DIGEST = "85287fc948d212d98033efd549002011"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("slider_pin", "contact", "liu_with_length x lankarani_nikravesh"), ("slider_pin_friction", "friction", "smooth_coulomb at slider_pin"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
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
    ("bush_length", "mm", 15, "of the slider pin in its bush"),
    ("rod_length", "m", 0.12, "crank pin to slider pin"),
    ("crank_speed", "rpm", 5000, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect slider_pin, Young's modulus of the first body of liu_with_length"),
    ("poissons_ratio", "1", 0.3, "effect slider_pin, Poisson's ratio of the first body of liu_with_length"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.1, "effect slider_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect slider_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("bush_radius", "defined", 0, None, True, False, "pair slider_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair slider_pin, clearance"),
    ("bush_length", "defined", 0, None, True, False, "pair slider_pin, length"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect slider_pin, Young's modulus of the first body of liu_with_length"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect slider_pin, Poisson's ratio of the first body of liu_with_length"),
    ("density", "defined", 0, None, True, False, "effect slider_pin, density"),
    ("restitution", "defined", 0, 1, False, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("restitution", "recommended", 0.8, 1, True, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "defined", 0, None, True, False, "effect slider_pin, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect slider_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect slider_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair slider_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("crank_pin.angle", "rad"), ("guide.travel", "m"))

SPEEDS = (("crank_pin.speed", "rad/s"), ("guide.speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("slider_pin.dissipated", "J"), ("slider_pin_friction.dissipated", "J"))

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
    ("friction_coefficient", "1"), ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"), ("slider_pin_R_min", "m"),
    ("twice_clearance", "m"), ("half_pi_times_slider_pin_E_eff_times_bush_length", "N/m"), ("k5", "N/m"), ("k6", "N/m"), ("k7", "N/m"),
    ("k8", "N/m"), ("k9", "N/m"), ("k10", "N/m"), ("k11", "N/m"), ("k12", "N/m"), ("k13", "N/m"), ("k14", "N/m"), ("k15", "N/m"),
    ("k16", "N/m"), ("k17", "N/m"), ("k18", "N/m"), ("k19", "N/m"), ("k20", "N/m"), ("slider_pin_hysteresis_factor", "1"),
    ("inverse_friction_speed", "s/m"), ("rod_h_x", "kg m"), ("crank_h_x", "kg m"), ("crank_rate_zz", "1/s^2"), ("rod_I_z_z", "kg m^2"),
    ("inverse_rod_I_z_z", "1/(kg m^2)"), ("inverse_slider_mass", "1/kg"), ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"),
    ("half_rod_mass", "kg"), ("half_crank_speed_squared_times_crank_inertia", "J"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 80), ("start", 5), ("scales", 12), ("coordinate_rates", 0), ("gaps", 35), ("gap_accelerations", 48),
    ("contact_slider_pin", 93), ("applied", 11), ("accelerations", 37), ("ledger", 1), ("energy", 158), ("poses", 10), ("outputs", 13),
    ("speed_limits", 3), ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (41,): rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, clearance_squared,
            half_inverse_clearance, slider_pin_R_min, twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, k5, k6, k7, k8, k9,
            k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20, slider_pin_hysteresis_factor, inverse_friction_speed, rod_h_x, crank_h_x,
            crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
            half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass
    """
    crank_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass, crank_radius, bush_radius = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    clearance, bush_length, rod_length, crank_speed, gravity, youngs_modulus, poissons_ratio = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    restitution, friction_coefficient, friction_speed = p[16], p[18], p[19]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    slider_pin_R_min = bush_radius - clearance
    slider_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    twice_clearance = 2*clearance
    half_pi_times_slider_pin_E_eff_times_bush_length = 3.141592653589793*slider_pin_E_eff*bush_length/2
    k5 = 0.008511818484890769*3.141592653589793*slider_pin_E_eff*bush_length
    k6 = 0.036980925051143414*3.141592653589793*slider_pin_E_eff*bush_length
    k7 = 0.003971150389178378*3.141592653589793*slider_pin_E_eff*bush_length
    k8 = 0.02781715911522491*3.141592653589793*slider_pin_E_eff*bush_length
    k9 = 1.0708519166174077e-11*3.141592653589793*slider_pin_E_eff*bush_length
    k10 = 0.0015199021366491846*3.141592653589793*slider_pin_E_eff*bush_length
    k11 = 1.3940024393033299e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k12 = 0.0004561231689207159*3.141592653589793*slider_pin_E_eff*bush_length
    k13 = 0.015394788440001576*3.141592653589793*slider_pin_E_eff*bush_length
    k14 = 9.693740427487626e-07*3.141592653589793*slider_pin_E_eff*bush_length
    k15 = 0.032029574061236465*3.141592653589793*slider_pin_E_eff*bush_length
    k16 = 0.03602473950753736*3.141592653589793*slider_pin_E_eff*bush_length
    k17 = 1.835845147395182e-08*3.141592653589793*slider_pin_E_eff*bush_length
    k18 = 0.023888498220471448*3.141592653589793*slider_pin_E_eff*bush_length
    k19 = 9.967497150641238e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k20 = 0.013290718685643597*3.141592653589793*slider_pin_E_eff*bush_length
    slider_pin_hysteresis_factor = 3/4 - 3*restitution*restitution/4
    inverse_friction_speed = 1/friction_speed
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
    return ca.vertcat(rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, clearance_squared,
        half_inverse_clearance, slider_pin_R_min, twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, k5, k6, k7, k8, k9,
        k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20, slider_pin_hysteresis_factor, inverse_friction_speed, rod_h_x, crank_h_x,
        crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
        half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[6], p[10], p[11]
    return ca.vertcat(0, crank_radius + rod_length), ca.vertcat(-(1 + crank_radius/rod_length)*crank_speed, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (3,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rod_mass, slider_mass, crank_radius, clearance, rod_length, crank_speed = p[0], p[2], p[5], p[6], p[8], p[10], p[11]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_radius*crank_radius*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance/rod_length, clearance), ca.vertcat(crank_radius*crank_speed/rod_length, crank_radius_times_crank_speed),
        ca.vertcat(energy_scale, energy_scale, energy_scale),
        ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


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
    crank_radius, rod_length, crank_speed, clearance_squared, half_inverse_clearance = c[1], c[3], c[4], c[7], c[8]
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
    crank_radius, rod_length, crank_speed, half_inverse_clearance = c[1], c[3], c[4], c[8]
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
    """Forces of slider_pin: liu_with_length x lankarani_nikravesh, smooth_coulomb. The normal force is the laws' own, not clamped: where it
    would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
        dz (3,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    crank_radius, clearance, rod_length, crank_speed, friction_coefficient, slider_pin_R_min = c[1], c[2], c[3], c[4], c[6], c[9]
    twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, slider_pin_hysteresis_factor = c[10], c[11], c[28]
    inverse_friction_speed = c[29]
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
    base = slider_pin_penetration/(twice_clearance + 2*slider_pin_penetration)
    slider_pin_elastic_force = ca.if_else(slider_pin_penetration > 0, half_pi_times_slider_pin_E_eff_times_bush_length*slider_pin_penetration*ca.sqrt(base), 0)
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
    slider_pin_sliding_velocity = slider_pin_normal_x*slider_pin_relative_rate_y - rod_rate_z*slider_pin_R_min - slider_pin_normal_y*slider_pin_relative_rate_x
    slider_pin_friction_force = slider_pin_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*slider_pin_sliding_velocity)
    slider_pin_friction_power = slider_pin_friction_force*slider_pin_sliding_velocity
    slider_pin_drag_x = slider_pin_friction_force*slider_pin_normal_y
    slider_pin_drag_y = -slider_pin_friction_force*slider_pin_normal_x
    slider_pin_R_min_times_slider_pin_normal_y = slider_pin_R_min*slider_pin_normal_y
    minus_slider_pin_R_min_times_slider_pin_normal_x = -slider_pin_R_min*slider_pin_normal_x
    slider_pin_drag_on_main_bearing = slider_pin_drag_x*(slider_pin_R_min_times_slider_pin_normal_y - rod_arm_y - slider_pin_pin_arm_y) + slider_pin_drag_y*(rod_arm_x + slider_pin_pin_arm_x + minus_slider_pin_R_min_times_slider_pin_normal_x)
    slider_pin_drag_on_crank_pin = slider_pin_drag_x*(slider_pin_R_min_times_slider_pin_normal_y - slider_pin_pin_arm_y) + slider_pin_drag_y*(slider_pin_pin_arm_x + minus_slider_pin_R_min_times_slider_pin_normal_x)
    slider_pin_in_range = ca.if_else(slider_pin_penetration <= slider_pin_R_min, 1, 0)
    return (ca.vertcat(slider_pin_drag_on_crank_pin + slider_pin_push_on_crank_pin, -slider_pin_drag_x - slider_pin_push_x,
            slider_pin_drag_on_main_bearing + slider_pin_push_on_main_bearing),
        ca.vertcat(0, slider_pin_normal_power, slider_pin_friction_power), ca.vertcat(slider_pin_normal_force),
        ca.vertcat(slider_pin_sliding_velocity), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
    """
    crank_speed, gravity, rod_h_x, crank_h_x = c[4], c[5], c[30], c[31]
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
    crank_radius, crank_speed, rod_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z = c[1], c[4], c[30], c[32], c[33], c[34]
    inverse_slider_mass = c[35]
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
        dz (3,): MEMORY [W]
    """
    crank_speed = c[4]
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
    rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, twice_clearance, k5 = c[0], c[1], c[2], c[3], c[4], c[10], c[12]
    k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16 = c[13], c[14], c[15], c[16], c[17], c[18], c[19], c[20], c[21], c[22], c[23]
    k17, k18, k19, k20, rod_h_x, half_rod_I_z_z, half_slider_mass, half_rod_mass = c[24], c[25], c[26], c[27], c[30], c[36], c[37], c[38]
    half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass = c[39], c[40]
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
    base_2 = slider_pin_penetration/(twice_clearance + 0.5995261983504611*slider_pin_penetration)
    base_3 = slider_pin_penetration/(twice_clearance + 1.5407223184360892*slider_pin_penetration)
    base_4 = slider_pin_penetration/(twice_clearance + 0.40950117867518615*slider_pin_penetration)
    base_5 = slider_pin_penetration/(twice_clearance + 1.8906860101801315*slider_pin_penetration)
    base_6 = slider_pin_penetration/(twice_clearance + 5.617008952561541e-05*slider_pin_penetration)
    base_7 = slider_pin_penetration/(twice_clearance + 0.2580467291264844*slider_pin_penetration)
    base_8 = slider_pin_penetration/(twice_clearance + 0.029913501726083053*slider_pin_penetration)
    base_9 = slider_pin_penetration/(twice_clearance + 0.14687290665052766*slider_pin_penetration)
    base_10 = slider_pin_penetration/(twice_clearance + 0.8212538306850022*slider_pin_penetration)
    base_11 = slider_pin_penetration/(twice_clearance + 0.009027486885869917*slider_pin_penetration)
    base_12 = slider_pin_penetration/(twice_clearance + 1.3087617711012016*slider_pin_penetration)
    base_13 = slider_pin_penetration/(twice_clearance + 1.7402898916615335*slider_pin_penetration)
    base_14 = slider_pin_penetration/(twice_clearance + 0.0015359640336663506*slider_pin_penetration)
    base_15 = slider_pin_penetration/(twice_clearance + 1.0629064619649824*slider_pin_penetration)
    base_16 = slider_pin_penetration/(twice_clearance + 0.07300928229591402*slider_pin_penetration)
    base_17 = slider_pin_penetration/(twice_clearance + 1.9788580400728255*slider_pin_penetration)
    slider_pin_stored_energy = ca.if_else(slider_pin_penetration > 0, slider_pin_penetration*(k10*slider_pin_penetration*ca.sqrt(base_7) + k11*slider_pin_penetration*ca.sqrt(base_8) + k12*slider_pin_penetration*ca.sqrt(base_9) + k13*slider_pin_penetration*ca.sqrt(base_10) + k14*slider_pin_penetration*ca.sqrt(base_11) + k15*slider_pin_penetration*ca.sqrt(base_12) + k16*slider_pin_penetration*ca.sqrt(base_13) + k17*slider_pin_penetration*ca.sqrt(base_14) + k18*slider_pin_penetration*ca.sqrt(base_15) + k19*slider_pin_penetration*ca.sqrt(base_16) + k20*slider_pin_penetration*ca.sqrt(base_17) + k5*slider_pin_penetration*ca.sqrt(base_2) + k6*slider_pin_penetration*ca.sqrt(base_3) + k7*slider_pin_penetration*ca.sqrt(base_4) + k8*slider_pin_penetration*ca.sqrt(base_5) + k9*slider_pin_penetration*ca.sqrt(base_6)), 0)
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
    youngs_modulus, density = p[13], p[15]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[11]
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
    rod_mass_centre, crank_radius, bush_radius, clearance, rod_length = p[4], p[6], p[7], p[8], p[10]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_radius, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(rod_length, 0, 0, bush_radius - clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(rod_mass_centre, 0, 0), ca.vertcat(0, 0, 0))
