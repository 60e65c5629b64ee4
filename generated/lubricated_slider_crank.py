"""lubricated_slider_crank: slider-crank, pin in oil and in dry contact. Generated from derive/scenes/lubricated_slider_crank.py.

Do not edit; regenerate with `hertzwerk derive lubricated_slider_crank`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    slider_pin: liu_with_length x lankarani_nikravesh
    slider_pin_friction: smooth_coulomb at slider_pin
    oil: short_bearing film at slider_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 172 assignments and 214 outputs checked, all consistent
Operations: flight 263 (equations of motion and gaps); in contact also contact_slider_pin 93
"""

import casadi as ca

NAME = "lubricated_slider_crank"
SOURCE = "derive/scenes/lubricated_slider_crank.py"
SUMMARY = "slider-crank, pin in oil and in dry contact"
FORMAT = "hertzwerk module 1"
DIGEST = "65688dc0c41d8c6bef9fb9cb464a956e"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("slider_pin", "contact", "liu_with_length x lankarani_nikravesh"), ("slider_pin_friction", "friction", "smooth_coulomb at slider_pin"),
    ("oil", "lubrication", "short_bearing film at slider_pin"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
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
    ("viscosity", "mPa s", 5, "effect oil, dynamic viscosity of short_bearing"),
    ("boundary_layer", "um", 5, "effect oil, boundary layer"),
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
    ("viscosity", "defined", 0, None, True, False, "effect oil, dynamic viscosity of short_bearing"),
    ("boundary_layer", "defined", 0, None, True, False, "effect oil, boundary layer"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair slider_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("crank_pin.angle", "rad"), ("guide.travel", "m"), ("oil.seams", "1"))

SPEEDS = (("crank_pin.speed", "rad/s"), ("guide.speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("slider_pin.dissipated", "J"), ("slider_pin_friction.dissipated", "J"), ("oil.dissipated", "J"))

LATCHES = (("slider_pin.approach_speed", "m/s", 0),)

PAIRS = (("slider_pin", "pin_in_bush"),)

EVENTS = (("oil.seam", (2,)),)

RELEASES = ("force",)

DISSIPATED = (1,)

GIVEN = ("crank_pin.speed", "guide.travel", "oil.seams")

OUTPUTS = (("slider_pin.eccentricity_x", "m"), ("slider_pin.eccentricity_y", "m"), ("oil.force", "N"), ("oil.thickness", "m"))

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
    ("friction_coefficient", "1"), ("boundary_layer", "m"), ("oil_free", "1"), ("inverse_clearance_squared", "1/m^2"),
    ("oil_free_squared", "1"), ("half_clearance_over_boundary_layer", "1"), ("twice_boundary_layer_over_clearance", "1"),
    ("clearance_over_boundary_layer", "1"), ("inverse_clearance", "1/m"), ("crank_radius_squared_times_crank_speed_squared", "m^2/s^2"),
    ("half_pi", "1"), ("k9", "N s/m"), ("k10", "J s"), ("k11", "1"), ("k12", "1"), ("clearance_squared", "m^2"),
    ("half_inverse_clearance", "1/m"), ("slider_pin_R_min", "m"), ("twice_clearance", "m"),
    ("half_pi_times_slider_pin_E_eff_times_bush_length", "N/m"), ("k17", "N/m"), ("k18", "N/m"), ("k19", "N/m"), ("k20", "N/m"),
    ("k21", "N/m"), ("k22", "N/m"), ("k23", "N/m"), ("k24", "N/m"), ("k25", "N/m"), ("k26", "N/m"), ("k27", "N/m"), ("k28", "N/m"),
    ("k29", "N/m"), ("k30", "N/m"), ("k31", "N/m"), ("k32", "N/m"), ("slider_pin_hysteresis_factor", "1"),
    ("inverse_friction_speed", "s/m"), ("rod_h_x", "kg m"), ("crank_h_x", "kg m"), ("crank_rate_zz", "1/s^2"), ("rod_I_z_z", "kg m^2"),
    ("inverse_rod_I_z_z", "1/(kg m^2)"), ("inverse_slider_mass", "1/kg"), ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"),
    ("half_rod_mass", "kg"), ("half_crank_speed_squared_times_crank_inertia", "J"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 112), ("start", 5), ("scales", 12), ("coordinate_rates", 0), ("gaps", 35), ("gap_accelerations", 48),
    ("contact_slider_pin", 93), ("applied", 143), ("accelerations", 37), ("margins", 28), ("jumps", 26), ("ledger", 130), ("energy", 158),
    ("poses", 10), ("outputs", 127), ("speed_limits", 3), ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def lubrication_past(t, third_angle, travel, radius, length, speed, inverse_clearance_squared, half_clearance_over_boundary_layer, k11,
        k12):
    """Return past_0 [1], past_1 [1]."""
    first_angle = t*speed
    first_cos = ca.cos(first_angle)
    first_sin = ca.sin(first_angle)
    second_angle = third_angle + first_angle
    second_cos = ca.cos(second_angle)
    second_sin = ca.sin(second_angle)
    arm_x = radius*first_cos
    arm_y = radius*first_sin
    pin_arm_x = length*second_cos
    pin_arm_y = length*second_sin
    apart_x = arm_x + pin_arm_x - travel
    apart_y = arm_y + pin_arm_y
    e_squared = apart_x*apart_x + apart_y*apart_y
    epsilon_squared = inverse_clearance_squared*e_squared
    epsilon_squared_minus_one = epsilon_squared - 1
    x2 = half_clearance_over_boundary_layer*epsilon_squared_minus_one
    past_0 = k11 + x2
    past_1 = k12 + x2
    return past_0, past_1


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (55,): rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, boundary_layer, oil_free,
            inverse_clearance_squared, oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance,
            clearance_over_boundary_layer, inverse_clearance, crank_radius_squared_times_crank_speed_squared, half_pi, k9, k10, k11, k12,
            clearance_squared, half_inverse_clearance, slider_pin_R_min, twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length,
            k17, k18, k19, k20, k21, k22, k23, k24, k25, k26, k27, k28, k29, k30, k31, k32, slider_pin_hysteresis_factor,
            inverse_friction_speed, rod_h_x, crank_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z,
            half_slider_mass, half_rod_mass, half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass
    """
    crank_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass, crank_radius, bush_radius = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    clearance, bush_length, rod_length, crank_speed, gravity, youngs_modulus, poissons_ratio = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    restitution, friction_coefficient, friction_speed, viscosity, boundary_layer = p[16], p[18], p[19], p[20], p[21]
    minus_twice_boundary_layer_over_clearance = -2*boundary_layer/clearance
    oil_free = 1 + minus_twice_boundary_layer_over_clearance
    inverse_clearance_squared = 1/(clearance*clearance)
    oil_free_squared = oil_free*oil_free
    half_clearance_over_boundary_layer = clearance/(2*boundary_layer)
    twice_boundary_layer_over_clearance = 2*boundary_layer/clearance
    clearance_over_boundary_layer = clearance/boundary_layer
    inverse_clearance = 1/clearance
    crank_rate_zz = crank_speed*crank_speed
    crank_radius_squared_times_crank_speed_squared = crank_rate_zz*crank_radius*crank_radius
    half_pi = 3.141592653589793/2
    slider_pin_R_min = bush_radius - clearance
    k9 = slider_pin_R_min*bush_length*bush_length*bush_length*viscosity/(clearance*clearance*clearance)
    k10 = 2*3.141592653589793*inverse_clearance*slider_pin_R_min*slider_pin_R_min*slider_pin_R_min*bush_length*viscosity
    k11 = 2 + minus_twice_boundary_layer_over_clearance
    k12 = -1 - inverse_clearance*boundary_layer/2
    clearance_squared = clearance*clearance
    half_inverse_clearance = inverse_clearance/2
    slider_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    twice_clearance = 2*clearance
    half_pi_times_slider_pin_E_eff_times_bush_length = 3.141592653589793*slider_pin_E_eff*bush_length/2
    k17 = 0.008511818484890769*3.141592653589793*slider_pin_E_eff*bush_length
    k18 = 0.036980925051143414*3.141592653589793*slider_pin_E_eff*bush_length
    k19 = 0.003971150389178378*3.141592653589793*slider_pin_E_eff*bush_length
    k20 = 0.02781715911522491*3.141592653589793*slider_pin_E_eff*bush_length
    k21 = 1.0708519166174077e-11*3.141592653589793*slider_pin_E_eff*bush_length
    k22 = 0.0015199021366491846*3.141592653589793*slider_pin_E_eff*bush_length
    k23 = 1.3940024393033299e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k24 = 0.0004561231689207159*3.141592653589793*slider_pin_E_eff*bush_length
    k25 = 0.015394788440001576*3.141592653589793*slider_pin_E_eff*bush_length
    k26 = 9.693740427487626e-07*3.141592653589793*slider_pin_E_eff*bush_length
    k27 = 0.032029574061236465*3.141592653589793*slider_pin_E_eff*bush_length
    k28 = 0.03602473950753736*3.141592653589793*slider_pin_E_eff*bush_length
    k29 = 1.835845147395182e-08*3.141592653589793*slider_pin_E_eff*bush_length
    k30 = 0.023888498220471448*3.141592653589793*slider_pin_E_eff*bush_length
    k31 = 9.967497150641238e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k32 = 0.013290718685643597*3.141592653589793*slider_pin_E_eff*bush_length
    slider_pin_hysteresis_factor = 3/4 - 3*restitution*restitution/4
    inverse_friction_speed = 1/friction_speed
    rod_h_x = rod_mass*rod_mass_centre
    crank_h_x = crank_radius*rod_mass
    rod_I_z_z = rod_mass_centre*rod_mass_centre*rod_mass + rod_inertia
    inverse_rod_I_z_z = 1/rod_I_z_z
    inverse_slider_mass = 1/slider_mass
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_mass = rod_mass/2
    half_crank_speed_squared_times_crank_inertia = crank_rate_zz*crank_inertia/2
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, boundary_layer,
        oil_free, inverse_clearance_squared, oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance,
        clearance_over_boundary_layer, inverse_clearance, crank_radius_squared_times_crank_speed_squared, half_pi, k9, k10, k11, k12,
        clearance_squared, half_inverse_clearance, slider_pin_R_min, twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, k17,
        k18, k19, k20, k21, k22, k23, k24, k25, k26, k27, k28, k29, k30, k31, k32, slider_pin_hysteresis_factor, inverse_friction_speed,
        rod_h_x, crank_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass,
        half_rod_mass, half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (2,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[6], p[10], p[11]
    return ca.vertcat(0, crank_radius + rod_length, 0), ca.vertcat(-(1 + crank_radius/rod_length)*crank_speed, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (2,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rod_mass, slider_mass, crank_radius, clearance, rod_length, crank_speed = p[0], p[2], p[5], p[6], p[8], p[10], p[11]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_radius*crank_radius*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance/rod_length, clearance, 1), ca.vertcat(crank_radius*crank_speed/rod_length, crank_radius_times_crank_speed),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): crank_pin.angle [rad/s], guide.travel [m/s], oil.seams [1/s]
    """
    crank_pin_speed, guide_speed = u[0], u[1]
    return ca.vertcat(crank_pin_speed, guide_speed, 0)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    crank_radius, rod_length, crank_speed, clearance_squared, half_inverse_clearance = c[1], c[3], c[4], c[21], c[22]
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
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_gap = half_inverse_clearance*(clearance_squared - oil_e_squared)
    oil_e_squared_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_x + 2*slider_pin_apart_rate_y*slider_pin_apart_y
    slider_pin_gap_rate = -half_inverse_clearance*oil_e_squared_rate
    return ca.vertcat(slider_pin_gap), ca.vertcat(slider_pin_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    crank_radius, rod_length, crank_speed, half_inverse_clearance = c[1], c[3], c[4], c[22]
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
    oil_e_squared_rate_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_rate_x + 2*slider_pin_apart_rate_y*slider_pin_apart_rate_y + 2*slider_pin_apart_acceleration_x*slider_pin_apart_x + 2*slider_pin_apart_acceleration_y*slider_pin_apart_y
    slider_pin_gap_rate_rate = -half_inverse_clearance*oil_e_squared_rate_rate
    return ca.vertcat(slider_pin_gap_rate_rate)


def contact_slider_pin(t, q, u, z, m, c):
    """Forces of slider_pin: liu_with_length x lankarani_nikravesh, smooth_coulomb. The normal force is the laws' own, not clamped: where it
    would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
        dz (4,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    crank_radius, clearance, rod_length, crank_speed, friction_coefficient, slider_pin_R_min = c[1], c[2], c[3], c[4], c[6], c[23]
    twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, slider_pin_hysteresis_factor = c[24], c[25], c[42]
    inverse_friction_speed = c[43]
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
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    oil_e_size = ca.sqrt(oil_e_squared)
    slider_pin_penetration = oil_e_size - clearance
    base_4 = slider_pin_penetration/(twice_clearance + 2*slider_pin_penetration)
    slider_pin_elastic_force = ca.if_else(slider_pin_penetration > 0, half_pi_times_slider_pin_E_eff_times_bush_length*slider_pin_penetration*ca.sqrt(base_4), 0)
    slider_pin_normal_x = -slider_pin_apart_x/oil_e_size
    slider_pin_normal_y = -slider_pin_apart_y/oil_e_size
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
        ca.vertcat(0, slider_pin_normal_power, slider_pin_friction_power, 0), ca.vertcat(slider_pin_normal_force),
        ca.vertcat(slider_pin_sliding_velocity), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): crank_pin [N m], guide [N], main_bearing [N m]
    """
    crank_radius, clearance, rod_length, crank_speed, gravity, boundary_layer, oil_free = c[1], c[2], c[3], c[4], c[5], c[7], c[8]
    inverse_clearance_squared, oil_free_squared, half_clearance_over_boundary_layer = c[9], c[10], c[11]
    twice_boundary_layer_over_clearance, clearance_over_boundary_layer, inverse_clearance = c[12], c[13], c[14]
    crank_radius_squared_times_crank_speed_squared, half_pi, k9, k10, rod_h_x, crank_h_x = c[15], c[16], c[17], c[18], c[44], c[45]
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
    oil_squeeze_x = rod_arm_rate_x - guide_speed - rod_rate_z*(slider_pin_apart_y/2 - rod_arm_y)
    half_slider_pin_apart_x = slider_pin_apart_x/2
    x2 = guide_travel + half_slider_pin_apart_x - rod_arm_x
    oil_squeeze_y = rod_arm_rate_y + rod_rate_z*x2
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, crank_radius_squared_times_crank_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*slider_pin_apart_x + oil_squeeze_y*slider_pin_apart_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*slider_pin_apart_y - oil_squeeze_y*slider_pin_apart_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k9*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k9*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_drag_spin = k10/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_couple = -oil_drag_spin*oil_share*rod_rate_z
    oil_on_main_bearing = oil_force_y*(guide_travel + half_slider_pin_apart_x) - oil_force_x*slider_pin_apart_y/2
    oil_on_crank_pin = oil_force_x*(rod_arm_y - slider_pin_apart_y/2) + oil_force_y*x2
    rod_moment_x = cos_rod*rod_h_x
    crank_moment_x = cos_crank*crank_h_x
    crank_total_moment_x = crank_moment_x + rod_moment_x
    return ca.vertcat(oil_couple + oil_on_crank_pin - rod_moment_x*gravity, -oil_force_x, oil_couple + oil_on_main_bearing -
        crank_total_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): crank_pin.acceleration [rad/s^2], guide.acceleration [m/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    crank_radius, crank_speed, rod_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z = c[1], c[4], c[44], c[46], c[47], c[48]
    inverse_slider_mass = c[49]
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


def margins(t, q, u, c):
    """Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        margin (1,): oil.seam [1]
    """
    oil_seams = q[2]
    past_0, past_1 = lubrication_past(t, q[0], q[1], c[1], c[3], c[4], c[9], c[11], c[19], c[20])
    return ca.vertcat(ca.if_else(oil_seams > 0, past_0, -past_0)*ca.if_else(oil_seams > 1, past_1, -past_1))


def jumps(t, q, u, c):
    """Values of the states that each event changes, event by event, by the values before it.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        then (1,): oil.seams [1]
    """
    past_0, past_1 = lubrication_past(t, q[0], q[1], c[1], c[3], c[4], c[9], c[11], c[19], c[20])
    return ca.vertcat(ca.if_else(past_0 >= 0, 1, 0) + ca.if_else(past_1 >= 0, 1, 0))


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    crank_radius, clearance, rod_length, crank_speed, boundary_layer, oil_free = c[1], c[2], c[3], c[4], c[7], c[8]
    inverse_clearance_squared, oil_free_squared, half_clearance_over_boundary_layer = c[9], c[10], c[11]
    twice_boundary_layer_over_clearance, clearance_over_boundary_layer, inverse_clearance = c[12], c[13], c[14]
    crank_radius_squared_times_crank_speed_squared, half_pi, k9, k10 = c[15], c[16], c[17], c[18]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    main_bearing_reaction_in = reactions[0]
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
    oil_squeeze_x = rod_arm_rate_x - guide_speed - rod_rate_z*(slider_pin_apart_y/2 - rod_arm_y)
    oil_squeeze_y = rod_arm_rate_y + rod_rate_z*(guide_travel + slider_pin_apart_x/2 - rod_arm_x)
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, crank_radius_squared_times_crank_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*slider_pin_apart_x + oil_squeeze_y*slider_pin_apart_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*slider_pin_apart_y - oil_squeeze_y*slider_pin_apart_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k9*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k9*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_drag_spin = k10/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_couple = -oil_drag_spin*oil_share*rod_rate_z
    oil_power = -oil_couple*rod_rate_z - oil_force_x*oil_squeeze_x - oil_force_y*oil_squeeze_y
    return ca.vertcat(main_bearing_reaction_in*crank_speed, 0, 0, oil_power)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, twice_clearance, k17 = c[0], c[1], c[2], c[3], c[4], c[24], c[26]
    k18, k19, k20, k21, k22, k23, k24, k25, k26, k27, k28 = c[27], c[28], c[29], c[30], c[31], c[32], c[33], c[34], c[35], c[36], c[37]
    k29, k30, k31, k32, rod_h_x, half_rod_I_z_z, half_slider_mass, half_rod_mass = c[38], c[39], c[40], c[41], c[44], c[50], c[51], c[52]
    half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass = c[53], c[54]
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
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    oil_e_size = ca.sqrt(oil_e_squared)
    slider_pin_penetration = oil_e_size - clearance
    base_5 = slider_pin_penetration/(twice_clearance + 0.5995261983504611*slider_pin_penetration)
    base_6 = slider_pin_penetration/(twice_clearance + 1.5407223184360892*slider_pin_penetration)
    base_7 = slider_pin_penetration/(twice_clearance + 0.40950117867518615*slider_pin_penetration)
    base_8 = slider_pin_penetration/(twice_clearance + 1.8906860101801315*slider_pin_penetration)
    base_9 = slider_pin_penetration/(twice_clearance + 5.617008952561541e-05*slider_pin_penetration)
    base_10 = slider_pin_penetration/(twice_clearance + 0.2580467291264844*slider_pin_penetration)
    base_11 = slider_pin_penetration/(twice_clearance + 0.029913501726083053*slider_pin_penetration)
    base_12 = slider_pin_penetration/(twice_clearance + 0.14687290665052766*slider_pin_penetration)
    base_13 = slider_pin_penetration/(twice_clearance + 0.8212538306850022*slider_pin_penetration)
    base_14 = slider_pin_penetration/(twice_clearance + 0.009027486885869917*slider_pin_penetration)
    base_15 = slider_pin_penetration/(twice_clearance + 1.3087617711012016*slider_pin_penetration)
    base_16 = slider_pin_penetration/(twice_clearance + 1.7402898916615335*slider_pin_penetration)
    base_17 = slider_pin_penetration/(twice_clearance + 0.0015359640336663506*slider_pin_penetration)
    base_18 = slider_pin_penetration/(twice_clearance + 1.0629064619649824*slider_pin_penetration)
    base_19 = slider_pin_penetration/(twice_clearance + 0.07300928229591402*slider_pin_penetration)
    base_20 = slider_pin_penetration/(twice_clearance + 1.9788580400728255*slider_pin_penetration)
    slider_pin_stored_energy = ca.if_else(slider_pin_penetration > 0, slider_pin_penetration*(k17*slider_pin_penetration*ca.sqrt(base_5) + k18*slider_pin_penetration*ca.sqrt(base_6) + k19*slider_pin_penetration*ca.sqrt(base_7) + k20*slider_pin_penetration*ca.sqrt(base_8) + k21*slider_pin_penetration*ca.sqrt(base_9) + k22*slider_pin_penetration*ca.sqrt(base_10) + k23*slider_pin_penetration*ca.sqrt(base_11) + k24*slider_pin_penetration*ca.sqrt(base_12) + k25*slider_pin_penetration*ca.sqrt(base_13) + k26*slider_pin_penetration*ca.sqrt(base_14) + k27*slider_pin_penetration*ca.sqrt(base_15) + k28*slider_pin_penetration*ca.sqrt(base_16) + k29*slider_pin_penetration*ca.sqrt(base_17) + k30*slider_pin_penetration*ca.sqrt(base_18) + k31*slider_pin_penetration*ca.sqrt(base_19) + k32*slider_pin_penetration*ca.sqrt(base_20)), 0)
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
        y (4,): OUTPUTS
    """
    crank_radius, clearance, rod_length, crank_speed, boundary_layer, oil_free = c[1], c[2], c[3], c[4], c[7], c[8]
    inverse_clearance_squared, oil_free_squared, half_clearance_over_boundary_layer = c[9], c[10], c[11]
    twice_boundary_layer_over_clearance, clearance_over_boundary_layer, inverse_clearance = c[12], c[13], c[14]
    crank_radius_squared_times_crank_speed_squared, half_pi, k9 = c[15], c[16], c[17]
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
    oil_squeeze_x = rod_arm_rate_x - guide_speed - rod_rate_z*(slider_pin_apart_y/2 - rod_arm_y)
    oil_squeeze_y = rod_arm_rate_y + rod_rate_z*(guide_travel + slider_pin_apart_x/2 - rod_arm_x)
    oil_e_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, crank_radius_squared_times_crank_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*slider_pin_apart_x + oil_squeeze_y*slider_pin_apart_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*slider_pin_apart_y - oil_squeeze_y*slider_pin_apart_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k9*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k9*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_e_size = ca.sqrt(oil_e_squared)
    oil_thickness = (1 - oil_e_size*oil_per_e)*clearance
    base_3 = oil_force_x*oil_force_x + oil_force_y*oil_force_y
    oil_force_size = ca.sqrt(base_3)
    return ca.vertcat(slider_pin_apart_x, slider_pin_apart_y, oil_force_size, oil_thickness)


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
