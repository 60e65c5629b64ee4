"""slider_crank_two_clearances: slider-crank with clearance at both rod pins. Generated from derive/scenes/slider_crank_two_clearances.py.

Do not edit; regenerate with `hertzwerk derive slider_crank_two_clearances`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    crank_pin, slider_pin: hertz_point x lankarani_nikravesh
    crank_pin_friction: smooth_coulomb at crank_pin
    slider_pin_friction: smooth_coulomb at slider_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 128 assignments and 225 outputs checked, all consistent
Operations: flight 159 (equations of motion and gaps); in contact also contact_crank_pin 86, contact_slider_pin 67
"""

import casadi as ca

NAME = "slider_crank_two_clearances"
SOURCE = "derive/scenes/slider_crank_two_clearances.py"
SUMMARY = "slider-crank with clearance at both rod pins"
FORMAT = "hertzwerk module 1"
DIGEST = "048d517eb56bf01b74a3f0f04b4754b0"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("crank_pin", "contact", "hertz_point x lankarani_nikravesh"), ("slider_pin", "contact", "hertz_point x lankarani_nikravesh"),
    ("crank_pin_friction", "friction", "smooth_coulomb at crank_pin"), ("slider_pin_friction", "friction", "smooth_coulomb at slider_pin"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

ADVICE = (
    "crank_pin and 1 more: take a law of line contact (`hertzwerk laws --form line`). At crank_pin, slider_pin a pin in bush touches along a line, and hertz_point is a law of point contact",
)

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0001, "body crank, inertia"),
    ("rod_mass", "kg", 0.21, "body rod, mass"),
    ("rod_inertia", "kg m^2", 0.00025, "body rod, inertia"),
    ("rod_mass_centre", "m", 0.06, "crank pin to mass centre"),
    ("slider_mass", "kg", 0.14, "body slider, mass"),
    ("bush_radius", "mm", 10, "pair crank_pin, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus pin radius"),
    ("crank_radius", "m", 0.05, "main bearing to crank pin"),
    ("rod_length", "m", 0.12, "crank pin to slider pin"),
    ("crank_speed", "rpm", 5000, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect crank_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "1", 0.3, "effect crank_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect crank_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.1, "effect crank_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect crank_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("bush_radius", "defined", 0, None, True, False, "pair crank_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair crank_pin, clearance"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect crank_pin, Young's modulus of the first body of hertz_point"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect crank_pin, Poisson's ratio of the first body of hertz_point"),
    ("density", "defined", 0, None, True, False, "effect crank_pin, density"),
    ("restitution", "defined", 0, 1, False, False, "effect crank_pin, coefficient of restitution of lankarani_nikravesh"),
    ("restitution", "recommended", 0.8, 1, True, False, "effect crank_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "defined", 0, None, True, False, "effect crank_pin, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect crank_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect crank_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair crank_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("rod_plane.x", "m"), ("rod_plane.y", "m"), ("rod_plane.angle", "rad"), ("guide.travel", "m"))

SPEEDS = (("rod_plane.x_speed", "m/s"), ("rod_plane.y_speed", "m/s"), ("rod_plane.angle_speed", "rad/s"), ("guide.speed", "m/s"))

MEMORY = (
    ("energy_ledger.input", "J"), ("crank_pin.dissipated", "J"), ("slider_pin.dissipated", "J"), ("crank_pin_friction.dissipated", "J"),
    ("slider_pin_friction.dissipated", "J"),
)

LATCHES = (("crank_pin.approach_speed", "m/s", 0), ("slider_pin.approach_speed", "m/s", 1))

PAIRS = (("crank_pin", "pin_in_bush"), ("slider_pin", "pin_in_bush"))

RELEASES = ("force", "force")

DISSIPATED = (1, 2)

GIVEN = ("rod_plane.x", "rod_plane.y_speed", "rod_plane.angle_speed", "guide.travel")

OUTPUTS = (
    ("crank_pin.eccentricity_x", "m"), ("crank_pin.eccentricity_y", "m"), ("slider_pin.eccentricity_x", "m"),
    ("slider_pin.eccentricity_y", "m"),
)

SPEED_LIMITED = ("crank_pin", "slider_pin")

BODIES = ("crank", "rod", "slider")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("rod_plane", "planar", "parent", "ground", ("normal",)), ("rod_plane", "planar", "child", "rod", ("normal",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "slider", ("axis",)),
    ("crank_pin", "pin_in_bush", "pin", "crank", ("radius",)), ("crank_pin", "pin_in_bush", "bush", "rod", ("radius", "axis")),
    ("slider_pin", "pin_in_bush", "pin", "rod", ("radius",)), ("slider_pin", "pin_in_bush", "bush", "slider", ("radius", "axis")),
    ("crank_drive", "turn_drive", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("rod", "body", "centre", "rod", ()), ("slider", "body", "centre", "slider", ()),
)

CONSTANTS = (
    ("rod_mass", "kg"), ("rod_mass_centre", "m"), ("clearance", "m"), ("crank_radius", "m"), ("rod_length", "m"), ("crank_speed", "1/s"),
    ("gravity", "m/s^2"), ("friction_coefficient", "1"), ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"),
    ("crank_pin_R_min", "m"), ("crank_pin_K", "N/m^1.5"), ("two_fifths_of_crank_pin_K", "N/m^1.5"), ("crank_pin_hysteresis_factor", "1"),
    ("inverse_friction_speed", "s/m"), ("rod_h_x", "kg m"), ("inverse_rod_I_z_z", "1/(kg m^2)"), ("inverse_slider_mass", "1/kg"),
    ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"), ("half_rod_mass", "kg"),
    ("half_crank_speed_squared_times_crank_inertia", "J"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 35), ("start", 5), ("scales", 12), ("coordinate_rates", 0), ("gaps", 49), ("gap_accelerations", 65),
    ("contact_crank_pin", 86), ("contact_slider_pin", 67), ("applied", 6), ("accelerations", 39), ("ledger", 1), ("energy", 58),
    ("poses", 7), ("outputs", 20), ("speed_limits", 3), ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (23,): rod_mass, rod_mass_centre, clearance, crank_radius, rod_length, crank_speed, gravity, friction_coefficient,
            clearance_squared, half_inverse_clearance, crank_pin_R_min, crank_pin_K, two_fifths_of_crank_pin_K, crank_pin_hysteresis_factor,
            inverse_friction_speed, rod_h_x, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
            half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass
    """
    crank_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass, bush_radius, clearance = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    crank_radius, rod_length, crank_speed, gravity, youngs_modulus, poissons_ratio = p[8], p[9], p[10], p[11], p[12], p[13]
    restitution, friction_coefficient, friction_speed = p[15], p[17], p[18]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    crank_pin_R_min = bush_radius - clearance
    crank_pin_R_eff = crank_pin_R_min*bush_radius/clearance
    crank_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    crank_pin_K = 4*crank_pin_E_eff*ca.sqrt(crank_pin_R_eff)/3
    two_fifths_of_crank_pin_K = 2*crank_pin_K/5
    crank_pin_hysteresis_factor = 3/4 - 3*restitution*restitution/4
    inverse_friction_speed = 1/friction_speed
    rod_h_x = rod_mass*rod_mass_centre
    rod_I_z_z = rod_mass_centre*rod_mass_centre*rod_mass + rod_inertia
    inverse_rod_I_z_z = 1/rod_I_z_z
    inverse_slider_mass = 1/slider_mass
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_mass = rod_mass/2
    half_crank_speed_squared_times_crank_inertia = crank_speed*crank_speed*crank_inertia/2
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(rod_mass, rod_mass_centre, clearance, crank_radius, rod_length, crank_speed, gravity, friction_coefficient,
        clearance_squared, half_inverse_clearance, crank_pin_R_min, crank_pin_K, two_fifths_of_crank_pin_K, crank_pin_hysteresis_factor,
        inverse_friction_speed, rod_h_x, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z, half_slider_mass, half_rod_mass,
        half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (4,): COORDINATES
        u (4,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[8], p[9], p[10]
    return (ca.vertcat(crank_radius, 0, 0, crank_radius + rod_length),
        ca.vertcat(0, crank_radius*crank_speed, -crank_radius*crank_speed/rod_length, 0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (4,): COORDINATES
        su (4,): SPEEDS
        sz (5,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rod_mass, slider_mass, clearance, crank_radius, rod_length, crank_speed = p[0], p[2], p[5], p[7], p[8], p[9], p[10]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_radius*crank_radius*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance, clearance, clearance/rod_length, clearance),
        ca.vertcat(crank_radius_times_crank_speed, crank_radius_times_crank_speed, crank_radius*crank_speed/rod_length,
            crank_radius_times_crank_speed),
        ca.vertcat(*[energy_scale]*5), ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (4,): rod_plane.x [m/s], rod_plane.y [m/s], rod_plane.angle [rad/s], guide.travel [m/s]
    """
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3]
    return ca.vertcat(rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (2,): PAIRS [m]
        dG (2,): PAIRS [m/s]
    """
    crank_radius, rod_length, crank_speed, clearance_squared, half_inverse_clearance = c[3], c[4], c[5], c[8], c[9]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_pin_arm_rate_x = -crank_pin_pin_arm_y*crank_speed
    crank_pin_pin_arm_rate_y = crank_pin_pin_arm_x*crank_speed
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    crank_pin_apart_rate_x = crank_pin_pin_arm_rate_x - rod_plane_x_speed
    crank_pin_apart_rate_y = crank_pin_pin_arm_rate_y - rod_plane_y_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_plane_angle_speed*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_plane_angle_speed*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_plane_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_plane_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_plane_x_speed + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_plane_y_speed + slider_pin_pin_arm_rate_y
    crank_pin_apart_squared = crank_pin_apart_x*crank_pin_apart_x + crank_pin_apart_y*crank_pin_apart_y
    crank_pin_gap = half_inverse_clearance*(clearance_squared - crank_pin_apart_squared)
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_gap = half_inverse_clearance*(clearance_squared - slider_pin_apart_squared)
    crank_pin_apart_squared_rate = 2*crank_pin_apart_rate_x*crank_pin_apart_x + 2*crank_pin_apart_rate_y*crank_pin_apart_y
    crank_pin_gap_rate = -crank_pin_apart_squared_rate*half_inverse_clearance
    slider_pin_apart_squared_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_x + 2*slider_pin_apart_rate_y*slider_pin_apart_y
    slider_pin_gap_rate = -half_inverse_clearance*slider_pin_apart_squared_rate
    return ca.vertcat(crank_pin_gap, slider_pin_gap), ca.vertcat(crank_pin_gap_rate, slider_pin_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (2,): PAIRS [m/s^2]
    """
    crank_radius, rod_length, crank_speed, half_inverse_clearance = c[3], c[4], c[5], c[9]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3]
    rod_plane_x_acceleration, rod_plane_y_acceleration, rod_plane_angle_acceleration, guide_acceleration = a[0], a[1], a[2], a[3]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_pin_arm_rate_x = -crank_pin_pin_arm_y*crank_speed
    crank_pin_pin_arm_rate_y = crank_pin_pin_arm_x*crank_speed
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    crank_pin_apart_rate_x = crank_pin_pin_arm_rate_x - rod_plane_x_speed
    crank_pin_apart_rate_y = crank_pin_pin_arm_rate_y - rod_plane_y_speed
    crank_pin_apart_acceleration_x = -rod_plane_x_acceleration - crank_pin_pin_arm_rate_y*crank_speed
    crank_pin_apart_acceleration_y = crank_pin_pin_arm_rate_x*crank_speed - rod_plane_y_acceleration
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_plane_angle_speed*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_plane_angle_speed*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_plane_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_plane_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_plane_x_speed + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_plane_y_speed + slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_x = rod_plane_x_acceleration - guide_acceleration - rod_plane_angle_acceleration*slider_pin_pin_arm_y - rod_plane_angle_speed*slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_y = rod_plane_y_acceleration + rod_plane_angle_acceleration*slider_pin_pin_arm_x + rod_plane_angle_speed*slider_pin_pin_arm_rate_x
    crank_pin_apart_squared_rate_rate = 2*crank_pin_apart_rate_x*crank_pin_apart_rate_x + 2*crank_pin_apart_rate_y*crank_pin_apart_rate_y + 2*crank_pin_apart_acceleration_x*crank_pin_apart_x + 2*crank_pin_apart_acceleration_y*crank_pin_apart_y
    crank_pin_gap_rate_rate = -crank_pin_apart_squared_rate_rate*half_inverse_clearance
    slider_pin_apart_squared_rate_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_rate_x + 2*slider_pin_apart_rate_y*slider_pin_apart_rate_y + 2*slider_pin_apart_acceleration_x*slider_pin_apart_x + 2*slider_pin_apart_acceleration_y*slider_pin_apart_y
    slider_pin_gap_rate_rate = -half_inverse_clearance*slider_pin_apart_squared_rate_rate
    return ca.vertcat(crank_pin_gap_rate_rate, slider_pin_gap_rate_rate)


def contact_crank_pin(t, q, u, z, m, c):
    """Forces of crank_pin: hertz_point x lankarani_nikravesh, smooth_coulomb. The normal force is the laws' own, not clamped: where it
    would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): rod_plane.x [N], rod_plane.y [N], rod_plane.angle [N m], guide [N], main_bearing [N m]
        dz (5,): MEMORY [W]
        normal_force (1,): crank_pin [N]
        sliding_velocity (1,): crank_pin [m/s]
        in_range (1,): crank_pin [1]
    """
    clearance, crank_radius, crank_speed, friction_coefficient, crank_pin_R_min, crank_pin_K = c[2], c[3], c[5], c[7], c[10], c[11]
    crank_pin_hysteresis_factor, inverse_friction_speed = c[13], c[14]
    rod_plane_x, rod_plane_y = q[0], q[1]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed = u[0], u[1], u[2]
    crank_pin_approach_speed = m[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    crank_pin_apart_squared = crank_pin_apart_x*crank_pin_apart_x + crank_pin_apart_y*crank_pin_apart_y
    crank_pin_distance = ca.sqrt(crank_pin_apart_squared)
    crank_pin_penetration = crank_pin_distance - clearance
    crank_pin_elastic_force = ca.if_else(crank_pin_penetration > 0, crank_pin_K*crank_pin_penetration*ca.sqrt(crank_pin_penetration), 0)
    crank_pin_normal_x = -crank_pin_apart_x/crank_pin_distance
    crank_pin_normal_y = -crank_pin_apart_y/crank_pin_distance
    crank_pin_relative_rate_x = crank_pin_apart_y*rod_plane_angle_speed - rod_plane_x_speed - crank_pin_pin_arm_y*crank_speed
    crank_pin_relative_rate_y = crank_pin_pin_arm_x*crank_speed - rod_plane_y_speed - crank_pin_apart_x*rod_plane_angle_speed
    crank_pin_penetration_rate = -crank_pin_normal_x*crank_pin_relative_rate_x - crank_pin_normal_y*crank_pin_relative_rate_y
    crank_pin_resistance = crank_pin_elastic_force*crank_pin_hysteresis_factor*crank_pin_penetration_rate/crank_pin_approach_speed
    crank_pin_normal_force = crank_pin_elastic_force + crank_pin_resistance
    crank_pin_normal_power = crank_pin_penetration_rate*crank_pin_resistance
    crank_pin_push_x = crank_pin_normal_force*crank_pin_normal_x
    crank_pin_push_y = crank_pin_normal_force*crank_pin_normal_y
    crank_pin_push_on_main_bearing = crank_pin_pin_arm_x*crank_pin_push_y - crank_pin_pin_arm_y*crank_pin_push_x
    crank_pin_push_on_rod_plane_angle = -crank_pin_apart_x*crank_pin_push_y - crank_pin_push_x*(rod_plane_y - crank_pin_pin_arm_y)
    crank_pin_sliding_velocity = crank_pin_normal_x*crank_pin_relative_rate_y - crank_pin_R_min*(crank_speed - rod_plane_angle_speed) - crank_pin_normal_y*crank_pin_relative_rate_x
    crank_pin_friction_force = crank_pin_normal_force*friction_coefficient*ca.tanh(crank_pin_sliding_velocity*inverse_friction_speed)
    crank_pin_friction_power = crank_pin_friction_force*crank_pin_sliding_velocity
    crank_pin_drag_x = crank_pin_friction_force*crank_pin_normal_y
    crank_pin_drag_y = -crank_pin_friction_force*crank_pin_normal_x
    crank_pin_R_min_times_crank_pin_normal_y = crank_pin_R_min*crank_pin_normal_y
    minus_crank_pin_R_min_times_crank_pin_normal_x = -crank_pin_R_min*crank_pin_normal_x
    crank_pin_drag_on_main_bearing = crank_pin_drag_x*(crank_pin_R_min_times_crank_pin_normal_y - crank_pin_pin_arm_y) + crank_pin_drag_y*(crank_pin_pin_arm_x + minus_crank_pin_R_min_times_crank_pin_normal_x)
    crank_pin_drag_on_rod_plane_angle = -crank_pin_drag_x*(rod_plane_y + crank_pin_R_min_times_crank_pin_normal_y - crank_pin_pin_arm_y) - crank_pin_drag_y*(crank_pin_pin_arm_x + minus_crank_pin_R_min_times_crank_pin_normal_x - rod_plane_x)
    crank_pin_in_range = ca.if_else(crank_pin_penetration <= crank_pin_R_min, 1, 0)
    return (ca.vertcat(-crank_pin_drag_x - crank_pin_push_x, -crank_pin_drag_y - crank_pin_push_y, crank_pin_drag_on_rod_plane_angle +
            crank_pin_push_on_rod_plane_angle, 0, crank_pin_drag_on_main_bearing + crank_pin_push_on_main_bearing),
        ca.vertcat(0, crank_pin_normal_power, 0, crank_pin_friction_power, 0), ca.vertcat(crank_pin_normal_force),
        ca.vertcat(crank_pin_sliding_velocity), ca.vertcat(crank_pin_in_range))


def contact_slider_pin(t, q, u, z, m, c):
    """Forces of slider_pin: hertz_point x lankarani_nikravesh, smooth_coulomb; arguments and returns as of contact_crank_pin."""
    clearance, rod_length, friction_coefficient, crank_pin_R_min, crank_pin_K = c[2], c[4], c[7], c[10], c[11]
    crank_pin_hysteresis_factor, inverse_friction_speed = c[13], c[14]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3]
    slider_pin_approach_speed = m[1]
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_plane_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_plane_y + slider_pin_pin_arm_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - clearance
    slider_pin_elastic_force = ca.if_else(slider_pin_penetration > 0, crank_pin_K*slider_pin_penetration*ca.sqrt(slider_pin_penetration), 0)
    slider_pin_normal_x = -slider_pin_apart_x/slider_pin_distance
    slider_pin_normal_y = -slider_pin_apart_y/slider_pin_distance
    slider_pin_relative_rate_x = rod_plane_x_speed - guide_speed - rod_plane_angle_speed*slider_pin_pin_arm_y
    slider_pin_relative_rate_y = rod_plane_y_speed + rod_plane_angle_speed*slider_pin_pin_arm_x
    slider_pin_penetration_rate = -slider_pin_normal_x*slider_pin_relative_rate_x - slider_pin_normal_y*slider_pin_relative_rate_y
    slider_pin_resistance = crank_pin_hysteresis_factor*slider_pin_elastic_force*slider_pin_penetration_rate/slider_pin_approach_speed
    slider_pin_normal_force = slider_pin_elastic_force + slider_pin_resistance
    slider_pin_normal_power = slider_pin_penetration_rate*slider_pin_resistance
    slider_pin_push_x = slider_pin_normal_force*slider_pin_normal_x
    slider_pin_push_y = slider_pin_normal_force*slider_pin_normal_y
    slider_pin_push_on_rod_plane_angle = slider_pin_pin_arm_x*slider_pin_push_y - slider_pin_pin_arm_y*slider_pin_push_x
    slider_pin_sliding_velocity = slider_pin_normal_x*slider_pin_relative_rate_y - crank_pin_R_min*rod_plane_angle_speed - slider_pin_normal_y*slider_pin_relative_rate_x
    slider_pin_friction_force = slider_pin_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*slider_pin_sliding_velocity)
    slider_pin_friction_power = slider_pin_friction_force*slider_pin_sliding_velocity
    slider_pin_drag_x = slider_pin_friction_force*slider_pin_normal_y
    slider_pin_drag_y = -slider_pin_friction_force*slider_pin_normal_x
    slider_pin_drag_on_rod_plane_angle = slider_pin_drag_x*(crank_pin_R_min*slider_pin_normal_y - slider_pin_pin_arm_y) + slider_pin_drag_y*(slider_pin_pin_arm_x - crank_pin_R_min*slider_pin_normal_x)
    slider_pin_in_range = ca.if_else(slider_pin_penetration <= crank_pin_R_min, 1, 0)
    return (ca.vertcat(slider_pin_drag_x + slider_pin_push_x, slider_pin_drag_y + slider_pin_push_y, slider_pin_drag_on_rod_plane_angle +
            slider_pin_push_on_rod_plane_angle, -slider_pin_drag_x - slider_pin_push_x, 0),
        ca.vertcat(0, 0, slider_pin_normal_power, 0, slider_pin_friction_power), ca.vertcat(slider_pin_normal_force),
        ca.vertcat(slider_pin_sliding_velocity), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): rod_plane.x [N], rod_plane.y [N], rod_plane.angle [N m], guide [N], main_bearing [N m]
    """
    rod_mass, gravity, rod_h_x = c[0], c[6], c[15]
    rod_plane_angle = q[2]
    cos_rod = ca.cos(rod_plane_angle)
    rod_moment_x = cos_rod*rod_h_x
    return ca.vertcat(0, -gravity*rod_mass, -rod_moment_x*gravity, 0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (4,): rod_plane.x_acceleration [m/s^2], rod_plane.y_acceleration [m/s^2], rod_plane.angle_acceleration [rad/s^2],
            guide.acceleration [m/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    rod_mass, rod_h_x, inverse_rod_I_z_z, inverse_slider_mass = c[0], c[15], c[16], c[17]
    rod_plane_angle = q[2]
    rod_plane_angle_speed = u[2]
    rod_plane_x_force, rod_plane_y_force, rod_plane_angle_force, guide_force, main_bearing_force = f[0], f[1], f[2], f[3], f[4]
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    rod_rate_zz = rod_plane_angle_speed*rod_plane_angle_speed
    rod_force_x = -rod_moment_x*rod_rate_zz
    rod_force_y = -rod_moment_y*rod_rate_zz
    rod_plane_x_net = rod_plane_x_force - rod_force_x
    rod_plane_y_net = rod_plane_y_force - rod_force_y
    l_rod_plane_y_rod_plane_angle = inverse_rod_I_z_z*rod_moment_x
    D_rod_plane_y = rod_mass - l_rod_plane_y_rod_plane_angle*rod_moment_x
    l_rod_plane_x_rod_plane_angle = -inverse_rod_I_z_z*rod_moment_y
    L_rod_plane_x_rod_plane_y = l_rod_plane_y_rod_plane_angle*rod_moment_y
    l_rod_plane_x_rod_plane_y = L_rod_plane_x_rod_plane_y/D_rod_plane_y
    D_rod_plane_x = l_rod_plane_x_rod_plane_angle*rod_moment_y + rod_mass - L_rod_plane_x_rod_plane_y*l_rod_plane_x_rod_plane_y
    y_rod_plane_y = rod_plane_y_net - l_rod_plane_y_rod_plane_angle*rod_plane_angle_force
    y_rod_plane_x = rod_plane_x_net - l_rod_plane_x_rod_plane_angle*rod_plane_angle_force - l_rod_plane_x_rod_plane_y*y_rod_plane_y
    rod_plane_x_acc = y_rod_plane_x/D_rod_plane_x
    rod_plane_y_acc = y_rod_plane_y/D_rod_plane_y - l_rod_plane_x_rod_plane_y*rod_plane_x_acc
    rod_plane_angle_acc = inverse_rod_I_z_z*rod_plane_angle_force - l_rod_plane_x_rod_plane_angle*rod_plane_x_acc - l_rod_plane_y_rod_plane_angle*rod_plane_y_acc
    guide_acc = guide_force*inverse_slider_mass
    return ca.vertcat(rod_plane_x_acc, rod_plane_y_acc, rod_plane_angle_acc, guide_acc), ca.vertcat(-main_bearing_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (5,): MEMORY [W]
    """
    crank_speed = c[5]
    main_bearing_reaction_in = reactions[0]
    return ca.vertcat(main_bearing_reaction_in*crank_speed, 0, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (2,): PAIRS [J]
    """
    rod_mass_centre, clearance, crank_radius, rod_length, crank_speed, two_fifths_of_crank_pin_K = c[1], c[2], c[3], c[4], c[5], c[12]
    rod_h_x, half_rod_I_z_z, half_slider_mass, half_rod_mass = c[15], c[18], c[19], c[20]
    half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass = c[21], c[22]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_plane_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_plane_y + slider_pin_pin_arm_y
    crank_pin_apart_squared = crank_pin_apart_x*crank_pin_apart_x + crank_pin_apart_y*crank_pin_apart_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    crank_pin_distance = ca.sqrt(crank_pin_apart_squared)
    crank_pin_penetration = crank_pin_distance - clearance
    crank_pin_stored_energy = ca.if_else(crank_pin_penetration > 0, two_fifths_of_crank_pin_K*crank_pin_penetration*crank_pin_penetration*ca.sqrt(crank_pin_penetration), 0)
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - clearance
    slider_pin_stored_energy = ca.if_else(slider_pin_penetration > 0, two_fifths_of_crank_pin_K*slider_pin_penetration*slider_pin_penetration*ca.sqrt(slider_pin_penetration), 0)
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    kinetic = half_crank_speed_squared_times_crank_inertia + half_rod_I_z_z*rod_plane_angle_speed*rod_plane_angle_speed + half_slider_mass*guide_speed*guide_speed + half_rod_mass*(rod_plane_x_speed*rod_plane_x_speed + rod_plane_y_speed*rod_plane_y_speed) + rod_moment_x*rod_plane_angle_speed*rod_plane_y_speed - rod_moment_y*rod_plane_angle_speed*rod_plane_x_speed
    rod_centre_arm_y = sin_rod*rod_mass_centre
    potential = gravity_times_rod_mass*(rod_centre_arm_y + rod_plane_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(crank_pin_stored_energy, slider_pin_stored_energy)


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
    crank_speed = c[5]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    return (ca.vertcat(0, 0, 0, rod_plane_x, rod_plane_y, 0, guide_travel, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_rod, -sin_rod, 0, sin_rod, cos_rod, 0, 0, 0, 1, 1, 0, 0,
            0, 1, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): OUTPUTS
    """
    crank_radius, rod_length, crank_speed = c[3], c[4], c[5]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_plane_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_plane_y + slider_pin_pin_arm_y
    crank_pin_eccentricity_x = cos_rod*crank_pin_apart_x + crank_pin_apart_y*sin_rod
    crank_pin_eccentricity_y = cos_rod*crank_pin_apart_y - crank_pin_apart_x*sin_rod
    return ca.vertcat(crank_pin_eccentricity_x, crank_pin_eccentricity_y, slider_pin_apart_x, slider_pin_apart_y)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (2,): PAIRS [m/s]
    """
    youngs_modulus, density = p[12], p[14]
    youngs_modulus_over_density = youngs_modulus/density
    x2 = ca.sqrt(youngs_modulus_over_density)
    x3 = 1e-05*x2
    return ca.vertcat(x3, x3)


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
        main_bearing.parent, main_bearing.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        rod_plane.parent, rod_plane.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        guide.parent, guide.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank_pin.pin (4,): x [m], y [m], z [m], radius [m]
        crank_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        slider_pin.pin (4,): x [m], y [m], z [m], radius [m]
        slider_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        crank_drive.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, rod.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    rod_mass_centre, bush_radius, clearance, crank_radius, rod_length = p[4], p[6], p[7], p[8], p[9]
    bush_radius_minus_clearance = bush_radius - clearance
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(crank_radius, 0, 0, bush_radius_minus_clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(rod_length, 0, 0, bush_radius_minus_clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(rod_mass_centre, 0, 0), ca.vertcat(0, 0, 0))
