"""slider_crank_dc_motor: slider-crank, two clearances, controlled DC motor. Generated from derive/scenes/slider_crank_dc_motor.py.

Do not edit; regenerate with `hertzwerk derive slider_crank_dc_motor`.
Effects:
    motor: direct-current motor on main_bearing at the voltage crank_speed*motor_constant + speed_control.command
    speed_control: PI controller that keeps the speed of main_bearing at crank_speed, sampled each sampling_period
    gravity: uniform gravity
    crank_pin, slider_pin: hertz_point x lankarani_nikravesh
    crank_pin_friction: smooth_coulomb at crank_pin
    slider_pin_friction: smooth_coulomb at slider_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 135 assignments and 280 outputs checked, all consistent
Operations: flight 162 (equations of motion and gaps); in contact also contact_crank_pin 85, contact_slider_pin 67
"""

import casadi as ca

NAME = "slider_crank_dc_motor"
SOURCE = "derive/scenes/slider_crank_dc_motor.py"
SUMMARY = "slider-crank, two clearances, controlled DC motor"
FORMAT = "hertzwerk module 1"
DIGEST = "2698edb94f30e1400c3b2f887dc5fada"

EFFECTS = (
    ("motor", "motor", "direct-current motor on main_bearing at the voltage crank_speed*motor_constant + speed_control.command"),
    ("speed_control", "speed_controller", "PI controller that keeps the speed of main_bearing at crank_speed, sampled each sampling_period"),
    ("gravity", "gravity", "uniform gravity"), ("crank_pin", "contact", "hertz_point x lankarani_nikravesh"),
    ("slider_pin", "contact", "hertz_point x lankarani_nikravesh"), ("crank_pin_friction", "friction", "smooth_coulomb at crank_pin"),
    ("slider_pin_friction", "friction", "smooth_coulomb at slider_pin"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

ADVICE = (
    "crank_pin and 1 more: take a law of line contact (`hertzwerk laws --form line`). At crank_pin, slider_pin a pin in bush touches along a line, and hertz_point is a law of point contact",
)

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0001, "body crank, inertia"),
    ("rotor_mass", "kg", 1, "body rotor, mass"),
    ("rotor_inertia", "kg m^2", 0.002, "body rotor, inertia"),
    ("rod_mass", "kg", 0.21, "body rod, mass"),
    ("rod_inertia", "kg m^2", 0.00025, "body rod, inertia"),
    ("rod_mass_centre", "m", 0.06, "crank pin to mass centre"),
    ("slider_mass", "kg", 0.14, "body slider, mass"),
    ("bush_radius", "mm", 10, "pair crank_pin, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus pin radius"),
    ("crank_radius", "m", 0.05, "main bearing to crank pin"),
    ("rod_length", "m", 0.12, "crank pin to slider pin"),
    ("crank_speed", "rpm", 5000, "constant speed of the crank"),
    ("motor_constant", "N m/A", 0.1, "torque for each ampere, back EMF for each rad/s"),
    ("motor_resistance", "ohm", 0.5, "effect motor, resistance"),
    ("motor_inductance", "mH", 1, "effect motor, inductance"),
    ("proportional_gain", "V s/rad", 0.2, "effect speed_control, proportional gain"),
    ("integral_gain", "V/rad", 20, "effect speed_control, integral gain"),
    ("sampling_period", "ms", 0.5, "effect speed_control, period"),
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
    ("rotor_mass", "defined", 0, None, True, False, "body rotor, mass"),
    ("rotor_inertia", "defined", 0, None, False, False, "body rotor, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("bush_radius", "defined", 0, None, True, False, "pair crank_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair crank_pin, clearance"),
    ("motor_resistance", "defined", 0, None, True, False, "effect motor, resistance"),
    ("motor_inductance", "defined", 0, None, True, False, "effect motor, inductance"),
    ("proportional_gain", "defined", 0, None, False, False, "effect speed_control, proportional gain"),
    ("integral_gain", "defined", 0, None, False, False, "effect speed_control, integral gain"),
    ("sampling_period", "defined", 0, None, True, False, "effect speed_control, period"),
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

COORDINATES = (
    ("main_bearing.angle", "rad"), ("rod_plane.x", "m"), ("rod_plane.y", "m"), ("rod_plane.angle", "rad"), ("guide.travel", "m"),
    ("motor.current", "A"), ("speed_control.error", "rad"), ("speed_control.command", "V"), ("speed_control.countdown", "s"),
)

SPEEDS = (
    ("main_bearing.speed", "rad/s"), ("rod_plane.x_speed", "m/s"), ("rod_plane.y_speed", "m/s"), ("rod_plane.angle_speed", "rad/s"),
    ("guide.speed", "m/s"),
)

MEMORY = (
    ("motor.dissipated", "J"), ("motor.input", "J"), ("crank_pin.dissipated", "J"), ("slider_pin.dissipated", "J"),
    ("crank_pin_friction.dissipated", "J"), ("slider_pin_friction.dissipated", "J"),
)

LATCHES = (("crank_pin.approach_speed", "m/s", 0), ("slider_pin.approach_speed", "m/s", 1))

PAIRS = (("crank_pin", "pin_in_bush"), ("slider_pin", "pin_in_bush"))

EVENTS = (("speed_control.sample", (6, 7, 8)),)

RELEASES = ("force", "force")

DISSIPATED = (2, 3)

GIVEN = (
    "main_bearing.speed", "rod_plane.x", "rod_plane.y_speed", "rod_plane.angle_speed", "guide.travel", "motor.current",
    "speed_control.error", "speed_control.command", "speed_control.countdown",
)

OUTPUTS = (
    ("crank_pin.eccentricity_x", "m"), ("crank_pin.eccentricity_y", "m"), ("slider_pin.eccentricity_x", "m"),
    ("slider_pin.eccentricity_y", "m"), ("motor.voltage", "V"), ("motor.torque", "N m"),
)

SPEED_LIMITED = ("crank_pin", "slider_pin")

BODIES = ("crank", "rotor", "rod", "slider")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("shaft", "weld", "parent", "crank", ()), ("shaft", "weld", "child", "rotor", ()),
    ("rod_plane", "planar", "parent", "ground", ("normal",)), ("rod_plane", "planar", "child", "rod", ("normal",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "slider", ("axis",)),
    ("crank_pin", "pin_in_bush", "pin", "crank", ("radius",)), ("crank_pin", "pin_in_bush", "bush", "rod", ("radius", "axis")),
    ("slider_pin", "pin_in_bush", "pin", "rod", ("radius",)), ("slider_pin", "pin_in_bush", "bush", "slider", ("radius", "axis")),
    ("motor", "turn_motor", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("rotor", "body", "centre", "rotor", ()), ("rod", "body", "centre", "rod", ()),
    ("slider", "body", "centre", "slider", ()),
)

CONSTANTS = (
    ("rod_mass", "kg"), ("rod_mass_centre", "m"), ("clearance", "m"), ("crank_radius", "m"), ("rod_length", "m"), ("crank_speed", "1/s"),
    ("motor_constant", "J/A"), ("motor_resistance", "W/A^2"), ("motor_inductance", "J/A^2"), ("proportional_gain", "J/A"),
    ("integral_gain", "W/A"), ("sampling_period", "s"), ("gravity", "m/s^2"), ("friction_coefficient", "1"),
    ("crank_speed_times_motor_constant", "W/A"), ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"), ("crank_pin_R_min", "m"),
    ("crank_pin_K", "N/m^1.5"), ("two_fifths_of_crank_pin_K", "N/m^1.5"), ("crank_pin_hysteresis_factor", "1"),
    ("inverse_friction_speed", "s/m"), ("rod_h_x", "kg m"), ("inverse_rod_I_z_z", "1/(kg m^2)"), ("inverse_crank_I_z_z", "1/(kg m^2)"),
    ("inverse_slider_mass", "1/kg"), ("half_crank_I_z_z", "kg m^2"), ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"),
    ("half_rod_mass", "kg"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 36), ("start", 5), ("scales", 24), ("coordinate_rates", 6), ("gaps", 48), ("gap_accelerations", 68),
    ("contact_crank_pin", 85), ("contact_slider_pin", 67), ("applied", 7), ("accelerations", 39), ("margins", 1), ("jumps", 7),
    ("ledger", 4), ("energy", 63), ("poses", 7), ("outputs", 21), ("speed_limits", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ROLLING = ()
SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (31,): rod_mass, rod_mass_centre, clearance, crank_radius, rod_length, crank_speed, motor_constant, motor_resistance,
            motor_inductance, proportional_gain, integral_gain, sampling_period, gravity, friction_coefficient,
            crank_speed_times_motor_constant, clearance_squared, half_inverse_clearance, crank_pin_R_min, crank_pin_K,
            two_fifths_of_crank_pin_K, crank_pin_hysteresis_factor, inverse_friction_speed, rod_h_x, inverse_rod_I_z_z, inverse_crank_I_z_z,
            inverse_slider_mass, half_crank_I_z_z, half_rod_I_z_z, half_slider_mass, half_rod_mass, gravity_times_rod_mass
    """
    crank_inertia, rotor_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass = p[1], p[3], p[4], p[5], p[6], p[7]
    bush_radius, clearance, crank_radius, rod_length, crank_speed, motor_constant = p[8], p[9], p[10], p[11], p[12], p[13]
    motor_resistance, motor_inductance, proportional_gain, integral_gain, sampling_period = p[14], p[15], p[16], p[17], p[18]
    gravity, youngs_modulus, poissons_ratio, restitution, friction_coefficient, friction_speed = p[19], p[20], p[21], p[23], p[25], p[26]
    crank_speed_times_motor_constant = crank_speed*motor_constant
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
    crank_I_z_z = crank_inertia + rotor_inertia
    rod_I_z_z = rod_mass_centre*rod_mass_centre*rod_mass + rod_inertia
    inverse_rod_I_z_z = 1/rod_I_z_z
    inverse_crank_I_z_z = 1/crank_I_z_z
    inverse_slider_mass = 1/slider_mass
    half_crank_I_z_z = crank_I_z_z/2
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_mass = rod_mass/2
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(rod_mass, rod_mass_centre, clearance, crank_radius, rod_length, crank_speed, motor_constant, motor_resistance,
        motor_inductance, proportional_gain, integral_gain, sampling_period, gravity, friction_coefficient,
        crank_speed_times_motor_constant, clearance_squared, half_inverse_clearance, crank_pin_R_min, crank_pin_K,
        two_fifths_of_crank_pin_K, crank_pin_hysteresis_factor, inverse_friction_speed, rod_h_x, inverse_rod_I_z_z, inverse_crank_I_z_z,
        inverse_slider_mass, half_crank_I_z_z, half_rod_I_z_z, half_slider_mass, half_rod_mass, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (9,): COORDINATES
        u (5,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[10], p[11], p[12]
    return (ca.vertcat(0, crank_radius, 0, 0, crank_radius + rod_length, 0, 0, 0, 0),
        ca.vertcat(crank_speed, 0, crank_radius*crank_speed, -crank_radius*crank_speed/rod_length, 0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (9,): COORDINATES
        su (5,): SPEEDS
        sz (6,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rotor_mass, rod_mass, slider_mass, clearance, crank_radius, rod_length = p[0], p[2], p[4], p[7], p[9], p[10], p[11]
    crank_speed, motor_constant, motor_resistance, proportional_gain, integral_gain = p[12], p[13], p[14], p[16], p[17]
    sampling_period = p[18]
    total_mass = crank_mass + rod_mass + rotor_mass + slider_mass
    energy_scale = total_mass*crank_radius*crank_radius*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    clearance_over_rod_length = clearance/rod_length
    crank_radius_times_crank_speed_over_rod_length = crank_radius*crank_speed/rod_length
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance_over_rod_length, clearance, clearance, clearance_over_rod_length, clearance,
            ca.fabs(motor_constant)*crank_radius*crank_speed/(motor_resistance*rod_length), clearance_over_rod_length,
            clearance*integral_gain/rod_length + crank_radius*crank_speed*proportional_gain/rod_length, sampling_period),
        ca.vertcat(crank_radius_times_crank_speed_over_rod_length, crank_radius_times_crank_speed, crank_radius_times_crank_speed,
            crank_radius_times_crank_speed_over_rod_length, crank_radius_times_crank_speed),
        ca.vertcat(*[energy_scale]*6), ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (9,): main_bearing.angle [rad/s], rod_plane.x [m/s], rod_plane.y [m/s], rod_plane.angle [rad/s], guide.travel [m/s],
            motor.current [A/s], speed_control.error [rad/s], speed_control.command [V/s], speed_control.countdown [s/s]
    """
    motor_constant, motor_resistance, motor_inductance, crank_speed_times_motor_constant = c[6], c[7], c[8], c[14]
    main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    motor_current, speed_control_command = q[5], q[7]
    motor_voltage = crank_speed_times_motor_constant + speed_control_command
    motor_drop = motor_voltage - main_bearing_speed*motor_constant - motor_current*motor_resistance
    return ca.vertcat(main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed,
        motor_drop/motor_inductance, 0, 0, -1)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (2,): PAIRS [m]
        dG (2,): PAIRS [m/s]
    """
    crank_radius, rod_length, clearance_squared, half_inverse_clearance = c[3], c[4], c[15], c[16]
    main_bearing_angle, rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3], q[4]
    main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_pin_arm_rate_x = -crank_pin_pin_arm_y*main_bearing_speed
    crank_pin_pin_arm_rate_y = crank_pin_pin_arm_x*main_bearing_speed
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
    crank_radius, rod_length, half_inverse_clearance = c[3], c[4], c[16]
    main_bearing_angle, rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3], q[4]
    main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    main_bearing_acceleration, rod_plane_x_acceleration, rod_plane_y_acceleration, rod_plane_angle_acceleration = a[0], a[1], a[2], a[3]
    guide_acceleration = a[4]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    crank_pin_pin_arm_x = cos_crank*crank_radius
    crank_pin_pin_arm_y = sin_crank*crank_radius
    crank_pin_pin_arm_rate_x = -crank_pin_pin_arm_y*main_bearing_speed
    crank_pin_pin_arm_rate_y = crank_pin_pin_arm_x*main_bearing_speed
    crank_pin_apart_x = crank_pin_pin_arm_x - rod_plane_x
    crank_pin_apart_y = crank_pin_pin_arm_y - rod_plane_y
    crank_pin_apart_rate_x = crank_pin_pin_arm_rate_x - rod_plane_x_speed
    crank_pin_apart_rate_y = crank_pin_pin_arm_rate_y - rod_plane_y_speed
    crank_pin_apart_acceleration_x = -rod_plane_x_acceleration - crank_pin_pin_arm_rate_y*main_bearing_speed - crank_pin_pin_arm_y*main_bearing_acceleration
    crank_pin_apart_acceleration_y = crank_pin_pin_arm_rate_x*main_bearing_speed + crank_pin_pin_arm_x*main_bearing_acceleration - rod_plane_y_acceleration
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
        f (5,): main_bearing [N m], rod_plane.x [N], rod_plane.y [N], rod_plane.angle [N m], guide [N]
        dz (6,): MEMORY [W]
        normal_force (1,): crank_pin [N]
        sliding_velocity (1,): crank_pin [m/s]
        in_range (1,): crank_pin [1]
    """
    clearance, crank_radius, friction_coefficient, crank_pin_R_min, crank_pin_K = c[2], c[3], c[13], c[17], c[18]
    crank_pin_hysteresis_factor, inverse_friction_speed = c[20], c[21]
    main_bearing_angle, rod_plane_x, rod_plane_y = q[0], q[1], q[2]
    main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed = u[0], u[1], u[2], u[3]
    crank_pin_approach_speed = m[0]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
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
    crank_pin_relative_rate_x = crank_pin_apart_y*rod_plane_angle_speed - rod_plane_x_speed - crank_pin_pin_arm_y*main_bearing_speed
    crank_pin_relative_rate_y = crank_pin_pin_arm_x*main_bearing_speed - rod_plane_y_speed - crank_pin_apart_x*rod_plane_angle_speed
    crank_pin_penetration_rate = -crank_pin_normal_x*crank_pin_relative_rate_x - crank_pin_normal_y*crank_pin_relative_rate_y
    crank_pin_resistance = crank_pin_elastic_force*crank_pin_hysteresis_factor*crank_pin_penetration_rate/crank_pin_approach_speed
    crank_pin_normal_force = crank_pin_elastic_force + crank_pin_resistance
    crank_pin_normal_power = crank_pin_penetration_rate*crank_pin_resistance
    crank_pin_push_x = crank_pin_normal_force*crank_pin_normal_x
    crank_pin_push_y = crank_pin_normal_force*crank_pin_normal_y
    crank_pin_push_on_main_bearing = crank_pin_pin_arm_x*crank_pin_push_y - crank_pin_pin_arm_y*crank_pin_push_x
    crank_pin_push_on_rod_plane_angle = -crank_pin_apart_x*crank_pin_push_y - crank_pin_push_x*(rod_plane_y - crank_pin_pin_arm_y)
    crank_pin_sliding_velocity = crank_pin_normal_x*crank_pin_relative_rate_y - crank_pin_R_min*(main_bearing_speed - rod_plane_angle_speed) - crank_pin_normal_y*crank_pin_relative_rate_x
    crank_pin_friction_force = crank_pin_normal_force*friction_coefficient*ca.tanh(crank_pin_sliding_velocity*inverse_friction_speed)
    crank_pin_friction_power = crank_pin_friction_force*crank_pin_sliding_velocity
    crank_pin_drag_x = crank_pin_friction_force*crank_pin_normal_y
    crank_pin_drag_y = -crank_pin_friction_force*crank_pin_normal_x
    crank_pin_R_min_times_crank_pin_normal_y = crank_pin_R_min*crank_pin_normal_y
    minus_crank_pin_R_min_times_crank_pin_normal_x = -crank_pin_R_min*crank_pin_normal_x
    crank_pin_drag_on_main_bearing = crank_pin_drag_x*(crank_pin_R_min_times_crank_pin_normal_y - crank_pin_pin_arm_y) + crank_pin_drag_y*(crank_pin_pin_arm_x + minus_crank_pin_R_min_times_crank_pin_normal_x)
    crank_pin_drag_on_rod_plane_angle = -crank_pin_drag_x*(rod_plane_y + crank_pin_R_min_times_crank_pin_normal_y - crank_pin_pin_arm_y) - crank_pin_drag_y*(crank_pin_pin_arm_x + minus_crank_pin_R_min_times_crank_pin_normal_x - rod_plane_x)
    crank_pin_in_range = ca.if_else(crank_pin_penetration <= crank_pin_R_min, 1, 0)
    return (ca.vertcat(crank_pin_drag_on_main_bearing + crank_pin_push_on_main_bearing, -crank_pin_drag_x - crank_pin_push_x,
            -crank_pin_drag_y - crank_pin_push_y, crank_pin_drag_on_rod_plane_angle + crank_pin_push_on_rod_plane_angle, 0),
        ca.vertcat(0, 0, crank_pin_normal_power, 0, crank_pin_friction_power, 0), ca.vertcat(crank_pin_normal_force),
        ca.vertcat(crank_pin_sliding_velocity), ca.vertcat(crank_pin_in_range))


def contact_slider_pin(t, q, u, z, m, c):
    """Forces of slider_pin: hertz_point x lankarani_nikravesh, smooth_coulomb; arguments and returns as of contact_crank_pin."""
    clearance, rod_length, friction_coefficient, crank_pin_R_min, crank_pin_K = c[2], c[4], c[13], c[17], c[18]
    crank_pin_hysteresis_factor, inverse_friction_speed = c[20], c[21]
    rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[1], q[2], q[3], q[4]
    rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[1], u[2], u[3], u[4]
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
    return (ca.vertcat(0, slider_pin_drag_x + slider_pin_push_x, slider_pin_drag_y + slider_pin_push_y, slider_pin_drag_on_rod_plane_angle +
            slider_pin_push_on_rod_plane_angle, -slider_pin_drag_x - slider_pin_push_x),
        ca.vertcat(0, 0, 0, slider_pin_normal_power, 0, slider_pin_friction_power), ca.vertcat(slider_pin_normal_force),
        ca.vertcat(slider_pin_sliding_velocity), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): main_bearing [N m], rod_plane.x [N], rod_plane.y [N], rod_plane.angle [N m], guide [N]
    """
    rod_mass, motor_constant, gravity, rod_h_x = c[0], c[6], c[12], c[22]
    rod_plane_angle, motor_current = q[3], q[5]
    cos_rod = ca.cos(rod_plane_angle)
    motor_force = motor_current*motor_constant
    rod_moment_x = cos_rod*rod_h_x
    return ca.vertcat(motor_force, 0, -gravity*rod_mass, -rod_moment_x*gravity, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): main_bearing.acceleration [rad/s^2], rod_plane.x_acceleration [m/s^2], rod_plane.y_acceleration [m/s^2],
            rod_plane.angle_acceleration [rad/s^2], guide.acceleration [m/s^2]
        reactions (0,): empty
    """
    rod_mass, rod_h_x, inverse_rod_I_z_z, inverse_crank_I_z_z, inverse_slider_mass = c[0], c[22], c[23], c[24], c[25]
    rod_plane_angle = q[3]
    rod_plane_angle_speed = u[3]
    main_bearing_force, rod_plane_x_force, rod_plane_y_force, rod_plane_angle_force, guide_force = f[0], f[1], f[2], f[3], f[4]
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
    main_bearing_acc = inverse_crank_I_z_z*main_bearing_force
    rod_plane_x_acc = y_rod_plane_x/D_rod_plane_x
    rod_plane_y_acc = y_rod_plane_y/D_rod_plane_y - l_rod_plane_x_rod_plane_y*rod_plane_x_acc
    rod_plane_angle_acc = inverse_rod_I_z_z*rod_plane_angle_force - l_rod_plane_x_rod_plane_angle*rod_plane_x_acc - l_rod_plane_y_rod_plane_angle*rod_plane_y_acc
    guide_acc = guide_force*inverse_slider_mass
    return ca.vertcat(main_bearing_acc, rod_plane_x_acc, rod_plane_y_acc, rod_plane_angle_acc, guide_acc), ca.vertcat()


def margins(t, q, u, c):
    """Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        margin (1,): speed_control.sample [1]
    """
    sampling_period = c[11]
    speed_control_countdown = q[8]
    return ca.vertcat(speed_control_countdown/sampling_period)


def jumps(t, q, u, c):
    """Values of the states that each event changes, event by event, by the values before it.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        then (3,): speed_control.error [rad], speed_control.command [V], speed_control.countdown [s]
    """
    crank_speed, proportional_gain, integral_gain, sampling_period = c[5], c[9], c[10], c[11]
    main_bearing_speed = u[0]
    speed_control_error, speed_control_countdown = q[6], q[8]
    speed_control_speed_error = crank_speed - main_bearing_speed
    return ca.vertcat(speed_control_error + speed_control_speed_error*sampling_period, speed_control_error*integral_gain +
        speed_control_speed_error*proportional_gain, speed_control_countdown + sampling_period)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (6,): MEMORY [W]
    """
    motor_resistance, crank_speed_times_motor_constant = c[7], c[14]
    motor_current, speed_control_command = q[5], q[7]
    motor_voltage = crank_speed_times_motor_constant + speed_control_command
    return ca.vertcat(motor_current*motor_current*motor_resistance, motor_current*motor_voltage, 0, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (2,): PAIRS [J]
    """
    rod_mass_centre, clearance, crank_radius, rod_length, motor_inductance, two_fifths_of_crank_pin_K = c[1], c[2], c[3], c[4], c[8], c[19]
    rod_h_x, half_crank_I_z_z, half_rod_I_z_z, half_slider_mass, half_rod_mass = c[22], c[26], c[27], c[28], c[29]
    gravity_times_rod_mass = c[30]
    main_bearing_angle, rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3], q[4]
    main_bearing_speed, rod_plane_x_speed, rod_plane_y_speed, rod_plane_angle_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    motor_current = q[5]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
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
    kinetic = half_rod_I_z_z*rod_plane_angle_speed*rod_plane_angle_speed + half_slider_mass*guide_speed*guide_speed + half_rod_mass*(rod_plane_x_speed*rod_plane_x_speed + rod_plane_y_speed*rod_plane_y_speed) + half_crank_I_z_z*main_bearing_speed*main_bearing_speed + rod_moment_x*rod_plane_angle_speed*rod_plane_y_speed - rod_moment_y*rod_plane_angle_speed*rod_plane_x_speed
    rod_centre_arm_y = sin_rod*rod_mass_centre
    potential = gravity_times_rod_mass*(rod_centre_arm_y + rod_plane_y)
    return (ca.vertcat(kinetic), ca.vertcat(potential + motor_current*motor_current*motor_inductance/2),
        ca.vertcat(crank_pin_stored_energy, slider_pin_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (12,): crank.x [m], crank.y [m], crank.z [m], rotor.x [m], rotor.y [m], rotor.z [m], rod.x [m], rod.y [m], rod.z [m],
            slider.x [m], slider.y [m], slider.z [m]
        rotations (36,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], rotor.R_xx [1], rotor.R_xy [1], rotor.R_xz [1], rotor.R_yx [1], rotor.R_yy [1], rotor.R_yz [1],
            rotor.R_zx [1], rotor.R_zy [1], rotor.R_zz [1], rod.R_xx [1], rod.R_xy [1], rod.R_xz [1], rod.R_yx [1], rod.R_yy [1], rod.R_yz
            [1], rod.R_zx [1], rod.R_zy [1], rod.R_zz [1], slider.R_xx [1], slider.R_xy [1], slider.R_xz [1], slider.R_yx [1], slider.R_yy
            [1], slider.R_yz [1], slider.R_zx [1], slider.R_zy [1], slider.R_zz [1]
    """
    main_bearing_angle, rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel = q[0], q[1], q[2], q[3], q[4]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    cos_rod = ca.cos(rod_plane_angle)
    sin_rod = ca.sin(rod_plane_angle)
    return (ca.vertcat(*[0]*6, rod_plane_x, rod_plane_y, 0, guide_travel, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1,
            cos_rod, -sin_rod, 0, sin_rod, cos_rod, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (6,): OUTPUTS
    """
    crank_radius, rod_length, motor_constant, crank_speed_times_motor_constant = c[3], c[4], c[6], c[14]
    main_bearing_angle, rod_plane_x, rod_plane_y, rod_plane_angle, guide_travel, motor_current = q[0], q[1], q[2], q[3], q[4], q[5]
    speed_control_command = q[7]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
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
    motor_voltage = crank_speed_times_motor_constant + speed_control_command
    motor_force = motor_current*motor_constant
    crank_pin_eccentricity_x = cos_rod*crank_pin_apart_x + crank_pin_apart_y*sin_rod
    crank_pin_eccentricity_y = cos_rod*crank_pin_apart_y - crank_pin_apart_x*sin_rod
    return ca.vertcat(crank_pin_eccentricity_x, crank_pin_eccentricity_y, slider_pin_apart_x, slider_pin_apart_y, motor_voltage,
        motor_force)


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (2,): PAIRS [m/s]
    """
    youngs_modulus, density = p[20], p[22]
    youngs_modulus_over_density = youngs_modulus/density
    x2 = ca.sqrt(youngs_modulus_over_density)
    x3 = 1e-05*x2
    return ca.vertcat(x3, x3)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent, main_bearing.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        shaft.parent, shaft.child (3,): x [m], y [m], z [m]
        rod_plane.parent, rod_plane.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        guide.parent, guide.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank_pin.pin (4,): x [m], y [m], z [m], radius [m]
        crank_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        slider_pin.pin (4,): x [m], y [m], z [m], radius [m]
        slider_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        motor.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, rotor.centre, rod.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    rod_mass_centre, bush_radius, clearance, crank_radius, rod_length = p[6], p[8], p[9], p[10], p[11]
    bush_radius_minus_clearance = bush_radius - clearance
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0), ca.vertcat(*[0]*5, 1),
        ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(crank_radius, 0, 0, bush_radius_minus_clearance), ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1),
        ca.vertcat(rod_length, 0, 0, bush_radius_minus_clearance), ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0), ca.vertcat(rod_mass_centre, 0, 0), ca.vertcat(0, 0, 0))
