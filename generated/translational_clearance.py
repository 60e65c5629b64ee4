"""translational_clearance: slider-crank, clearance between slider and guide. Generated from derive/scenes/translational_clearance.py.

Do not edit; regenerate with `hertzwerk derive translational_clearance`.
Effects:
    gravity: uniform gravity
    rear_lower, rear_upper, front_lower, front_upper: power x flores
    rear_lower_friction: smooth_coulomb at rear_lower
    rear_upper_friction: smooth_coulomb at rear_upper
    front_lower_friction: smooth_coulomb at front_lower
    front_upper_friction: smooth_coulomb at front_upper
    energy_ledger: work put in, energy dissipated per effect
Units: 252 assignments and 289 outputs checked, all consistent
Operations: flight 356 (equations of motion and gaps); in contact also contact_rear_lower 109, contact_rear_upper 113, contact_front_lower 108, contact_front_upper 112
"""

import casadi as ca

NAME = "translational_clearance"
SOURCE = "derive/scenes/translational_clearance.py"
SUMMARY = "slider-crank, clearance between slider and guide"
FORMAT = "hertzwerk module 1"
DIGEST = "d722aa49094d814bf0b0fbdc8f1ae42f"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("rear_lower", "contact", "power x flores"), ("rear_upper", "contact", "power x flores"),
    ("front_lower", "contact", "power x flores"), ("front_upper", "contact", "power x flores"),
    ("rear_lower_friction", "friction", "smooth_coulomb at rear_lower"),
    ("rear_upper_friction", "friction", "smooth_coulomb at rear_upper"),
    ("front_lower_friction", "friction", "smooth_coulomb at front_lower"),
    ("front_upper_friction", "friction", "smooth_coulomb at front_upper"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("crank_mass", "kg", 0.038, "body crank, mass"),
    ("crank_inertia", "kg m^2", 7.4e-05, "body crank, inertia"),
    ("crank_length", "m", 0.153, "point of crank"),
    ("rod_mass", "kg", 0.038, "body rod, mass"),
    ("rod_inertia", "kg m^2", 0.00059, "body rod, inertia"),
    ("rod_length", "m", 0.306, "point of rod"),
    ("slider_mass", "kg", 0.076, "body slider, mass"),
    ("slider_inertia", "kg m^2", 2.7e-06, "body slider, inertia"),
    ("guide_length", "m", 0.45, "pair rear_lower, length"),
    ("half_length", "m", 0.05, "of the slider"),
    ("half_width", "m", 0.025, "of the slider"),
    ("clearance", "m", 0.001, "of the guide, on each side of the slider"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^1.5", 1000000000.0, "effect rear_lower, stiffness of power"),
    ("restitution", "1", 0.4, "effect rear_lower, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.01, "effect rear_lower_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect rear_lower_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("crank_speed", "rad/s", 150, "start, speed of main_bearing"),
    ("rod_speed", "rad/s", -75, "at the start, against the ground"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("slider_inertia", "defined", 0, None, False, False, "body slider, inertia"),
    ("guide_length", "defined", 0, None, True, False, "pair rear_lower, length"),
    ("stiffness", "defined", 0, None, True, False, "effect rear_lower, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect rear_lower, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect rear_lower, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect rear_lower_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect rear_lower_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("clearance", "defined", 0, None, True, False, "scales, length"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

COORDINATES = (("main_bearing.angle", "rad"), ("crank_pin.angle", "rad"), ("slider_pin.angle", "rad"))

SPEEDS = (("main_bearing.speed", "rad/s"), ("crank_pin.speed", "rad/s"), ("slider_pin.speed", "rad/s"))

MEMORY = (
    ("rear_lower.dissipated", "J"), ("rear_upper.dissipated", "J"), ("front_lower.dissipated", "J"), ("front_upper.dissipated", "J"),
    ("rear_lower_friction.dissipated", "J"), ("rear_upper_friction.dissipated", "J"), ("front_lower_friction.dissipated", "J"),
    ("front_upper_friction.dissipated", "J"),
)

LATCHES = (
    ("rear_lower.approach_speed", "m/s", 0), ("rear_upper.approach_speed", "m/s", 1), ("front_lower.approach_speed", "m/s", 2),
    ("front_upper.approach_speed", "m/s", 3),
)

PAIRS = (
    ("rear_lower", "corner_on_face"), ("rear_upper", "corner_on_face"), ("front_lower", "corner_on_face"),
    ("front_upper", "corner_on_face"),
)

GUIDES = ("rear_lower", "rear_upper", "front_lower", "front_upper")

RELEASES = ("force", "force", "force", "force")

DISSIPATED = (0, 1, 2, 3)

OUTPUTS = (("rear_lower.gap", "m"), ("rear_upper.gap", "m"), ("front_lower.gap", "m"), ("front_upper.gap", "m"))

BODIES = ("crank", "rod", "slider")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("crank_pin", "revolute", "parent", "crank", ("axis",)), ("crank_pin", "revolute", "child", "rod", ("axis",)),
    ("slider_pin", "revolute", "parent", "rod", ("axis",)), ("slider_pin", "revolute", "child", "slider", ("axis",)),
    ("rear_lower", "corner_on_face", "corner", "slider", ()),
    ("rear_lower", "corner_on_face", "face", "ground", ("normal", "along", "length")),
    ("rear_upper", "corner_on_face", "corner", "slider", ()),
    ("rear_upper", "corner_on_face", "face", "ground", ("normal", "along", "length")),
    ("front_lower", "corner_on_face", "corner", "slider", ()),
    ("front_lower", "corner_on_face", "face", "ground", ("normal", "along", "length")),
    ("front_upper", "corner_on_face", "corner", "slider", ()),
    ("front_upper", "corner_on_face", "face", "ground", ("normal", "along", "length")),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("crank", "body", "centre", "crank", ()),
    ("rod", "body", "centre", "rod", ()), ("slider", "body", "centre", "slider", ()),
)

CONSTANTS = (
    ("crank_length", "m"), ("rod_length", "m"), ("slider_inertia", "kg m^2"), ("half_length", "m"), ("half_width", "m"),
    ("gravity", "m/s^2"), ("stiffness", "N/m^1.5"), ("friction_coefficient", "1"), ("rear_lower_second_arm_y", "m"),
    ("rear_upper_second_arm_y", "m"), ("minus_half_guide_length", "m"), ("two_fifths_of_stiffness", "N/m^1.5"),
    ("rear_lower_hysteresis_factor", "1"), ("inverse_friction_speed", "s/m"), ("rod_h_x", "kg m"), ("crank_h_x", "kg m"),
    ("rod_total_J_z_z", "kg m^2"), ("crank_I_z_z_plus_rod_total_J_z_z", "kg m^2"), ("inverse_D_crank_pin", "1/(kg m^2)"),
    ("inverse_slider_inertia", "1/(kg m^2)"), ("rod_h_x_2", "kg m"), ("half_crank_I_z_z_2", "kg m^2"), ("half_rod_I_z_z_2", "kg m^2"),
    ("half_slider_inertia", "kg m^2"), ("half_rod_mass", "kg"), ("half_slider_mass", "kg"), ("half_crank_length", "m"),
    ("half_rod_length", "m"), ("crank_mass_times_gravity", "N"), ("gravity_times_slider_mass", "N"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 50), ("start", 2), ("scales", 12), ("coordinate_rates", 0), ("gaps", 132), ("gap_accelerations", 159),
    ("contact_rear_lower", 109), ("contact_rear_upper", 113), ("contact_front_lower", 108), ("contact_front_upper", 112), ("applied", 10),
    ("accelerations", 55), ("ledger", 0), ("energy", 157), ("poses", 17), ("outputs", 78), ("landmarks", 9),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def corner_on_face_contact(first_arm_x, first_arm_y, x, y, second_arm_x, second_arm_y, gap, normal_x, normal_y, relative_rate_x,
        relative_rate_y, first_penetration_rate, second_penetration_rate, approach_speed, stiffness, friction_coefficient,
        hysteresis_factor, inverse_friction_speed):
    """Return normal_force [N], normal_power [W], first_push_on [N m], second_push_on [N m], third_push_on [N m], sliding_velocity [m/s],
    power [W], first_drag_on [N m], second_drag_on [N m], third_drag_on [N m]."""
    elastic_force = ca.if_else(-gap > 0, -gap*ca.sqrt(-gap)*stiffness, 0)
    resistance = hysteresis_factor*elastic_force*first_penetration_rate/approach_speed
    normal_force = resistance + elastic_force
    normal_power = resistance*second_penetration_rate
    push_x = normal_force*normal_x
    push_y = normal_force*normal_y
    minus_arm_y_minus_y = -second_arm_y - y
    arm_x_plus_x = x + second_arm_x
    first_push_on = push_x*minus_arm_y_minus_y + arm_x_plus_x*push_y
    x3 = first_arm_y - second_arm_y - y
    x4 = x + second_arm_x - first_arm_x
    second_push_on = x3*push_x + x4*push_y
    third_push_on = push_y*second_arm_x - push_x*second_arm_y
    sliding_velocity = relative_rate_y*normal_x - relative_rate_x*normal_y
    force = friction_coefficient*normal_force*ca.tanh(inverse_friction_speed*sliding_velocity)
    power = sliding_velocity*force
    drag_x = force*normal_y
    drag_y = -force*normal_x
    first_drag_on = drag_x*minus_arm_y_minus_y + arm_x_plus_x*drag_y
    second_drag_on = x3*drag_x + x4*drag_y
    third_drag_on = second_arm_x*drag_y - drag_x*second_arm_y
    return normal_force, normal_power, first_push_on, second_push_on, third_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on


def corner_on_face_gap(rate_z, x, y, velocity_x, velocity_y, cos_times_half_length, sin_times_half_length, minus_sin_times_half_width,
        cos_times_half_width, length, second_arm_y, minus_half_guide_length):
    """Return gap [m], gap_rate [m/s]."""
    arm_x = cos_times_half_length + minus_sin_times_half_width
    first_arm_y = cos_times_half_width + sin_times_half_length
    arm_rate_x = -first_arm_y*rate_z
    arm_rate_y = arm_x*rate_z
    apart_x = arm_x + x - length
    apart_y = first_arm_y + y - second_arm_y
    apart_rate_x = velocity_x + arm_rate_x
    apart_rate_y = velocity_y + arm_rate_y
    beyond = minus_half_guide_length + ca.if_else(apart_x > 0, apart_x, -apart_x)
    gap = ca.if_else(-apart_y > beyond, -apart_y, beyond)
    beyond_rate = ca.if_else(apart_x > 0, apart_rate_x, -apart_rate_x)
    gap_rate = ca.if_else(-apart_y > beyond, -apart_rate_y, beyond_rate)
    return gap, gap_rate


def corner_on_face_gap_acceleration(rate_z, angular_acceleration_z, x, y, acceleration_x, acceleration_y, cos_times_half_length,
        sin_times_half_length, minus_sin_times_half_width, cos_times_half_width, length, second_arm_y, minus_half_guide_length):
    """Return gap_acceleration [m/s^2]."""
    arm_x = cos_times_half_length + minus_sin_times_half_width
    first_arm_y = cos_times_half_width + sin_times_half_length
    arm_rate_x = -first_arm_y*rate_z
    arm_rate_y = arm_x*rate_z
    apart_x = arm_x + x - length
    apart_y = first_arm_y + y - second_arm_y
    apart_acceleration_x = acceleration_x - rate_z*arm_rate_y - first_arm_y*angular_acceleration_z
    apart_acceleration_y = acceleration_y + rate_z*arm_rate_x + arm_x*angular_acceleration_z
    beyond = minus_half_guide_length + ca.if_else(apart_x > 0, apart_x, -apart_x)
    beyond_acceleration = ca.if_else(apart_x > 0, apart_acceleration_x, -apart_acceleration_x)
    return ca.if_else(-apart_y > beyond, -apart_acceleration_y, beyond_acceleration)


def body_contact_terms(first_arm_x, first_arm_y, second_arm_x, second_arm_y, second_arm_rate_x, second_arm_rate_y, rate_z, third_arm_x,
        third_arm_y, speed):
    """Return x [m], y [m], relative_rate_x [m/s], relative_rate_y [m/s]."""
    first_arm_rate_x = -speed*first_arm_y
    first_arm_rate_y = speed*first_arm_x
    x = first_arm_x + second_arm_x
    y = first_arm_y + second_arm_y
    velocity_x = first_arm_rate_x + second_arm_rate_x
    velocity_y = first_arm_rate_y + second_arm_rate_y
    relative_rate_x = velocity_x - rate_z*third_arm_y
    relative_rate_y = velocity_y + rate_z*third_arm_x
    return x, y, relative_rate_x, relative_rate_y


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (31,): crank_length, rod_length, slider_inertia, half_length, half_width, gravity, stiffness, friction_coefficient,
            rear_lower_second_arm_y, rear_upper_second_arm_y, minus_half_guide_length, two_fifths_of_stiffness,
            rear_lower_hysteresis_factor, inverse_friction_speed, rod_h_x, crank_h_x, rod_total_J_z_z, crank_I_z_z_plus_rod_total_J_z_z,
            inverse_D_crank_pin, inverse_slider_inertia, rod_h_x_2, half_crank_I_z_z_2, half_rod_I_z_z_2, half_slider_inertia,
            half_rod_mass, half_slider_mass, half_crank_length, half_rod_length, crank_mass_times_gravity, gravity_times_slider_mass,
            gravity_times_rod_mass
    """
    crank_mass, crank_inertia, crank_length, rod_mass, rod_inertia, rod_length, slider_mass = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    slider_inertia, guide_length, half_length, half_width, clearance, gravity, stiffness = p[7], p[8], p[9], p[10], p[11], p[12], p[13]
    restitution, friction_coefficient, friction_speed = p[14], p[16], p[17]
    rear_lower_second_arm_y = -clearance - half_width
    rear_upper_second_arm_y = clearance + half_width
    minus_half_guide_length = -guide_length/2
    two_fifths_of_stiffness = 2*stiffness/5
    rear_lower_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_friction_speed = 1/friction_speed
    rod_h_x_2 = rod_length*rod_mass/2
    rod_h_x = rod_h_x_2 + rod_length*slider_mass
    rod_total_mass = rod_mass + slider_mass
    crank_h_x = rod_total_mass*crank_length + crank_length*crank_mass/2
    crank_length_squared = crank_length*crank_length
    quarter_of_crank_length_squared_times_crank_mass = crank_length_squared*crank_mass/4
    crank_I_z_z = quarter_of_crank_length_squared_times_crank_mass + rod_total_mass*crank_length_squared + crank_inertia
    rod_length_squared = rod_length*rod_length
    quarter_of_rod_length_squared_times_rod_mass = rod_length_squared*rod_mass/4
    rod_I_z_z = quarter_of_rod_length_squared_times_rod_mass + rod_length_squared*slider_mass + rod_inertia
    rod_total_J_z_z = rod_I_z_z + slider_inertia
    crank_I_z_z_plus_rod_total_J_z_z = crank_I_z_z + rod_total_J_z_z
    D_crank_pin = rod_total_J_z_z - slider_inertia
    inverse_D_crank_pin = 1/D_crank_pin
    inverse_slider_inertia = 1/slider_inertia
    crank_I_z_z_2 = quarter_of_crank_length_squared_times_crank_mass + crank_inertia
    rod_I_z_z_2 = quarter_of_rod_length_squared_times_rod_mass + rod_inertia
    half_crank_I_z_z_2 = crank_I_z_z_2/2
    half_rod_I_z_z_2 = rod_I_z_z_2/2
    half_slider_inertia = slider_inertia/2
    half_rod_mass = rod_mass/2
    half_slider_mass = slider_mass/2
    half_crank_length = crank_length/2
    half_rod_length = rod_length/2
    crank_mass_times_gravity = crank_mass*gravity
    gravity_times_slider_mass = gravity*slider_mass
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(crank_length, rod_length, slider_inertia, half_length, half_width, gravity, stiffness, friction_coefficient,
        rear_lower_second_arm_y, rear_upper_second_arm_y, minus_half_guide_length, two_fifths_of_stiffness, rear_lower_hysteresis_factor,
        inverse_friction_speed, rod_h_x, crank_h_x, rod_total_J_z_z, crank_I_z_z_plus_rod_total_J_z_z, inverse_D_crank_pin,
        inverse_slider_inertia, rod_h_x_2, half_crank_I_z_z_2, half_rod_I_z_z_2, half_slider_inertia, half_rod_mass, half_slider_mass,
        half_crank_length, half_rod_length, crank_mass_times_gravity, gravity_times_slider_mass, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (3,): SPEEDS
    """
    crank_speed, rod_speed = p[18], p[19]
    return ca.vertcat(0, 0, 0), ca.vertcat(crank_speed, rod_speed - crank_speed, -rod_speed)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (3,): SPEEDS
        sz (8,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, crank_length, rod_mass, rod_length, slider_mass, clearance, crank_speed = p[0], p[2], p[3], p[5], p[6], p[11], p[18]
    total_mass = crank_mass + rod_mass + slider_mass
    energy_scale = total_mass*crank_length*crank_length*crank_speed*crank_speed/2
    force_scale = energy_scale/clearance
    clearance_over_rod_length = clearance/rod_length
    crank_length_times_crank_speed_over_rod_length = crank_length*crank_speed/rod_length
    return (ca.vertcat(clearance_over_rod_length, clearance_over_rod_length, clearance_over_rod_length),
        ca.vertcat(crank_length_times_crank_speed_over_rod_length, crank_length_times_crank_speed_over_rod_length,
            crank_length_times_crank_speed_over_rod_length),
        ca.vertcat(*[energy_scale]*8), ca.vertcat(clearance, crank_length*crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): COORDINATES [rad/s]
    """
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    return ca.vertcat(main_bearing_speed, crank_pin_speed, slider_pin_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (4,): PAIRS [m]
        dG (4,): PAIRS [m/s]
    """
    crank_length, rod_length, half_length, half_width, rear_lower_second_arm_y, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[8], c[9]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_arm_rate_x = -main_bearing_speed*rod_arm_y
    rod_arm_rate_y = main_bearing_speed*rod_arm_x
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    slider_velocity_x = rod_arm_rate_x + slider_arm_rate_x
    slider_velocity_y = rod_arm_rate_y + slider_arm_rate_y
    sin_slider_times_half_width = sin_slider*half_width
    minus_cos_slider_times_half_length = -cos_slider*half_length
    rear_lower_first_arm_x = sin_slider_times_half_width + minus_cos_slider_times_half_length
    minus_cos_slider_times_half_width = -cos_slider*half_width
    minus_sin_slider_times_half_length = -sin_slider*half_length
    rear_lower_first_arm_y = minus_cos_slider_times_half_width + minus_sin_slider_times_half_length
    rear_lower_first_arm_rate_x = -rear_lower_first_arm_y*slider_rate_z
    rear_lower_first_arm_rate_y = rear_lower_first_arm_x*slider_rate_z
    rear_lower_apart_x = rear_lower_first_arm_x + slider_x - rod_length
    rear_lower_apart_y = rear_lower_first_arm_y + slider_y - rear_lower_second_arm_y
    rear_lower_apart_rate_x = rear_lower_first_arm_rate_x + slider_velocity_x
    rear_lower_apart_rate_y = rear_lower_first_arm_rate_y + slider_velocity_y
    minus_sin_slider_times_half_width = -sin_slider*half_width
    cos_slider_times_half_width = cos_slider*half_width
    cos_slider_times_half_length = cos_slider*half_length
    front_lower_first_arm_x = sin_slider_times_half_width + cos_slider_times_half_length
    sin_slider_times_half_length = sin_slider*half_length
    front_lower_first_arm_y = minus_cos_slider_times_half_width + sin_slider_times_half_length
    front_lower_first_arm_rate_x = -front_lower_first_arm_y*slider_rate_z
    front_lower_first_arm_rate_y = front_lower_first_arm_x*slider_rate_z
    front_lower_apart_x = front_lower_first_arm_x + slider_x - rod_length
    front_lower_apart_y = front_lower_first_arm_y + rear_upper_second_arm_y + slider_y
    front_lower_apart_rate_x = front_lower_first_arm_rate_x + slider_velocity_x
    front_lower_apart_rate_y = front_lower_first_arm_rate_y + slider_velocity_y
    rear_lower_beyond = minus_half_guide_length + ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_x, -rear_lower_apart_x)
    rear_lower_gap = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_y, rear_lower_beyond)
    front_lower_beyond = minus_half_guide_length + ca.if_else(front_lower_apart_x > 0, front_lower_apart_x, -front_lower_apart_x)
    front_lower_gap = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_y, front_lower_beyond)
    rear_lower_beyond_rate = ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_rate_x, -rear_lower_apart_rate_x)
    rear_lower_gap_rate = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_rate_y, rear_lower_beyond_rate)
    rear_upper_gap, rear_upper_gap_rate = corner_on_face_gap(slider_rate_z, slider_x, slider_y, slider_velocity_x, slider_velocity_y, minus_cos_slider_times_half_length, minus_sin_slider_times_half_length, minus_sin_slider_times_half_width, cos_slider_times_half_width, rod_length, rear_upper_second_arm_y, minus_half_guide_length)
    front_lower_beyond_rate = ca.if_else(front_lower_apart_x > 0, front_lower_apart_rate_x, -front_lower_apart_rate_x)
    front_lower_gap_rate = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_rate_y, front_lower_beyond_rate)
    front_upper_gap, front_upper_gap_rate = corner_on_face_gap(slider_rate_z, slider_x, slider_y, slider_velocity_x, slider_velocity_y, cos_slider_times_half_length, sin_slider_times_half_length, minus_sin_slider_times_half_width, cos_slider_times_half_width, rod_length, rear_upper_second_arm_y, minus_half_guide_length)
    return (ca.vertcat(rear_lower_gap, rear_upper_gap, front_lower_gap, front_upper_gap),
        ca.vertcat(rear_lower_gap_rate, rear_upper_gap_rate, front_lower_gap_rate, front_upper_gap_rate))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (4,): PAIRS [m/s^2]
    """
    crank_length, rod_length, half_length, half_width, rear_lower_second_arm_y, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[8], c[9]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    main_bearing_acceleration, crank_pin_acceleration, slider_pin_acceleration = a[0], a[1], a[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_arm_rate_x = -main_bearing_speed*rod_arm_y
    rod_arm_rate_y = main_bearing_speed*rod_arm_x
    rod_rate_z = crank_pin_speed + main_bearing_speed
    rod_angular_acceleration_z = crank_pin_acceleration + main_bearing_acceleration
    rod_acceleration_x = -main_bearing_acceleration*rod_arm_y - main_bearing_speed*rod_arm_rate_y
    rod_acceleration_y = main_bearing_acceleration*rod_arm_x + main_bearing_speed*rod_arm_rate_x
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    slider_angular_acceleration_z = rod_angular_acceleration_z + slider_pin_acceleration
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    slider_acceleration_x = rod_acceleration_x - rod_angular_acceleration_z*slider_arm_y - rod_rate_z*slider_arm_rate_y
    slider_acceleration_y = rod_acceleration_y + rod_angular_acceleration_z*slider_arm_x + rod_rate_z*slider_arm_rate_x
    sin_slider_times_half_width = sin_slider*half_width
    minus_cos_slider_times_half_length = -cos_slider*half_length
    rear_lower_first_arm_x = sin_slider_times_half_width + minus_cos_slider_times_half_length
    minus_cos_slider_times_half_width = -cos_slider*half_width
    minus_sin_slider_times_half_length = -sin_slider*half_length
    rear_lower_first_arm_y = minus_cos_slider_times_half_width + minus_sin_slider_times_half_length
    rear_lower_first_arm_rate_x = -rear_lower_first_arm_y*slider_rate_z
    rear_lower_first_arm_rate_y = rear_lower_first_arm_x*slider_rate_z
    rear_lower_apart_x = rear_lower_first_arm_x + slider_x - rod_length
    rear_lower_apart_y = rear_lower_first_arm_y + slider_y - rear_lower_second_arm_y
    rear_lower_apart_acceleration_x = slider_acceleration_x - rear_lower_first_arm_rate_y*slider_rate_z - rear_lower_first_arm_y*slider_angular_acceleration_z
    rear_lower_apart_acceleration_y = slider_acceleration_y + rear_lower_first_arm_rate_x*slider_rate_z + rear_lower_first_arm_x*slider_angular_acceleration_z
    minus_sin_slider_times_half_width = -sin_slider*half_width
    cos_slider_times_half_width = cos_slider*half_width
    cos_slider_times_half_length = cos_slider*half_length
    front_lower_first_arm_x = sin_slider_times_half_width + cos_slider_times_half_length
    sin_slider_times_half_length = sin_slider*half_length
    front_lower_first_arm_y = minus_cos_slider_times_half_width + sin_slider_times_half_length
    front_lower_first_arm_rate_x = -front_lower_first_arm_y*slider_rate_z
    front_lower_first_arm_rate_y = front_lower_first_arm_x*slider_rate_z
    front_lower_apart_x = front_lower_first_arm_x + slider_x - rod_length
    front_lower_apart_y = front_lower_first_arm_y + rear_upper_second_arm_y + slider_y
    front_lower_apart_acceleration_x = slider_acceleration_x - front_lower_first_arm_rate_y*slider_rate_z - front_lower_first_arm_y*slider_angular_acceleration_z
    front_lower_apart_acceleration_y = slider_acceleration_y + front_lower_first_arm_rate_x*slider_rate_z + front_lower_first_arm_x*slider_angular_acceleration_z
    rear_lower_beyond = minus_half_guide_length + ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_x, -rear_lower_apart_x)
    front_lower_beyond = minus_half_guide_length + ca.if_else(front_lower_apart_x > 0, front_lower_apart_x, -front_lower_apart_x)
    rear_lower_beyond_acceleration = ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_acceleration_x, -rear_lower_apart_acceleration_x)
    rear_lower_gap_acceleration = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_acceleration_y, rear_lower_beyond_acceleration)
    rear_upper_gap_acceleration = corner_on_face_gap_acceleration(slider_rate_z, slider_angular_acceleration_z, slider_x, slider_y, slider_acceleration_x, slider_acceleration_y, minus_cos_slider_times_half_length, minus_sin_slider_times_half_length, minus_sin_slider_times_half_width, cos_slider_times_half_width, rod_length, rear_upper_second_arm_y, minus_half_guide_length)
    front_lower_beyond_acceleration = ca.if_else(front_lower_apart_x > 0, front_lower_apart_acceleration_x, -front_lower_apart_acceleration_x)
    front_lower_gap_acceleration = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_acceleration_y, front_lower_beyond_acceleration)
    front_upper_gap_acceleration = corner_on_face_gap_acceleration(slider_rate_z, slider_angular_acceleration_z, slider_x, slider_y, slider_acceleration_x, slider_acceleration_y, cos_slider_times_half_length, sin_slider_times_half_length, minus_sin_slider_times_half_width, cos_slider_times_half_width, rod_length, rear_upper_second_arm_y, minus_half_guide_length)
    return ca.vertcat(rear_lower_gap_acceleration, rear_upper_gap_acceleration, front_lower_gap_acceleration, front_upper_gap_acceleration)


def contact_rear_lower(t, q, u, z, m, c):
    """Forces of rear_lower: power x flores, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): main_bearing [N m], crank_pin [N m], slider_pin [N m]
        dz (8,): MEMORY [W]
        normal_force (1,): rear_lower [N]
        sliding_velocity (1,): rear_lower [m/s]
        in_range (1,): rear_lower [1]
    """
    crank_length, rod_length, half_length, half_width, rear_lower_second_arm_y = c[0], c[1], c[3], c[4], c[8]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    rear_lower_first_arm_x = sin_slider*half_width - cos_slider*half_length
    rear_lower_first_arm_y = -cos_slider*half_width - sin_slider*half_length
    x, y, relative_rate_x, relative_rate_y = body_contact_terms(rod_arm_x, rod_arm_y, slider_arm_x, slider_arm_y, slider_arm_rate_x, slider_arm_rate_y, slider_rate_z, rear_lower_first_arm_x, rear_lower_first_arm_y, main_bearing_speed)
    rear_lower_apart_x = rear_lower_first_arm_x + x - rod_length
    rear_lower_apart_y = rear_lower_first_arm_y + y - rear_lower_second_arm_y
    rear_lower_beyond = minus_half_guide_length + ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_x, -rear_lower_apart_x)
    rear_lower_gap = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_y, rear_lower_beyond)
    rear_lower_end_x = ca.if_else(rear_lower_apart_x > 0, 1, -1)
    rear_lower_normal_x = ca.if_else(rear_lower_apart_y > rear_lower_beyond, 0, rear_lower_end_x)
    rear_lower_normal_y = ca.if_else(rear_lower_apart_y > rear_lower_beyond, 1, 0)
    rear_lower_penetration_rate = -rear_lower_normal_x*relative_rate_x - rear_lower_normal_y*relative_rate_y
    normal_force, normal_power, first_push_on, second_push_on, third_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on = corner_on_face_contact(rod_arm_x, rod_arm_y, x, y, rear_lower_first_arm_x, rear_lower_first_arm_y, rear_lower_gap, rear_lower_normal_x, rear_lower_normal_y, relative_rate_x, relative_rate_y, rear_lower_penetration_rate, rear_lower_penetration_rate, m[0], c[6], c[7], c[12], c[13])
    return (ca.vertcat(first_drag_on + first_push_on, second_drag_on + second_push_on, third_drag_on + third_push_on),
        ca.vertcat(normal_power, 0, 0, 0, power, 0, 0, 0), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_rear_upper(t, q, u, z, m, c):
    """Forces of rear_upper: power x flores, smooth_coulomb; arguments and returns as of contact_rear_lower."""
    crank_length, rod_length, half_length, half_width, stiffness, friction_coefficient = c[0], c[1], c[3], c[4], c[6], c[7]
    rear_upper_second_arm_y, minus_half_guide_length, rear_lower_hysteresis_factor, inverse_friction_speed = c[9], c[10], c[12], c[13]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    rear_upper_approach_speed = m[1]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_arm_rate_x = -main_bearing_speed*rod_arm_y
    rod_arm_rate_y = main_bearing_speed*rod_arm_x
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    slider_velocity_x = rod_arm_rate_x + slider_arm_rate_x
    slider_velocity_y = rod_arm_rate_y + slider_arm_rate_y
    rear_upper_first_arm_x = -cos_slider*half_length - sin_slider*half_width
    rear_upper_first_arm_y = cos_slider*half_width - sin_slider*half_length
    rear_upper_apart_x = rear_upper_first_arm_x + slider_x - rod_length
    rear_upper_apart_y = rear_upper_first_arm_y + slider_y - rear_upper_second_arm_y
    rear_upper_beyond = minus_half_guide_length + ca.if_else(rear_upper_apart_x > 0, rear_upper_apart_x, -rear_upper_apart_x)
    rear_upper_gap = ca.if_else(-rear_upper_apart_y > rear_upper_beyond, -rear_upper_apart_y, rear_upper_beyond)
    rear_upper_elastic_force = ca.if_else(-rear_upper_gap > 0, -rear_upper_gap*ca.sqrt(-rear_upper_gap)*stiffness, 0)
    rear_upper_end_x = ca.if_else(rear_upper_apart_x > 0, 1, -1)
    rear_upper_normal_x = ca.if_else(-rear_upper_apart_y > rear_upper_beyond, 0, rear_upper_end_x)
    rear_upper_normal_y = ca.if_else(-rear_upper_apart_y > rear_upper_beyond, -1, 0)
    rear_upper_relative_rate_x = slider_velocity_x - rear_upper_first_arm_y*slider_rate_z
    rear_upper_relative_rate_y = slider_velocity_y + rear_upper_first_arm_x*slider_rate_z
    rear_upper_penetration_rate = -rear_upper_normal_x*rear_upper_relative_rate_x - rear_upper_normal_y*rear_upper_relative_rate_y
    rear_upper_resistance = rear_lower_hysteresis_factor*rear_upper_elastic_force*rear_upper_penetration_rate/rear_upper_approach_speed
    rear_upper_normal_force = rear_upper_elastic_force + rear_upper_resistance
    rear_upper_normal_power = rear_upper_penetration_rate*rear_upper_resistance
    rear_upper_push_x = rear_upper_normal_force*rear_upper_normal_x
    rear_upper_push_y = rear_upper_normal_force*rear_upper_normal_y
    minus_rear_upper_first_arm_y_minus_slider_y = -rear_upper_first_arm_y - slider_y
    rear_upper_first_arm_x_plus_slider_x = rear_upper_first_arm_x + slider_x
    rear_upper_push_on_main_bearing = rear_upper_push_x*minus_rear_upper_first_arm_y_minus_slider_y + rear_upper_push_y*rear_upper_first_arm_x_plus_slider_x
    x3 = rod_arm_y - rear_upper_first_arm_y - slider_y
    x4 = rear_upper_first_arm_x + slider_x - rod_arm_x
    rear_upper_push_on_crank_pin = rear_upper_push_x*x3 + rear_upper_push_y*x4
    rear_upper_push_on_slider_pin = rear_upper_first_arm_x*rear_upper_push_y - rear_upper_first_arm_y*rear_upper_push_x
    rear_upper_sliding_velocity = rear_upper_normal_x*rear_upper_relative_rate_y - rear_upper_normal_y*rear_upper_relative_rate_x
    rear_upper_friction_force = rear_upper_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*rear_upper_sliding_velocity)
    rear_upper_friction_power = rear_upper_friction_force*rear_upper_sliding_velocity
    rear_upper_drag_x = rear_upper_friction_force*rear_upper_normal_y
    rear_upper_drag_y = -rear_upper_friction_force*rear_upper_normal_x
    rear_upper_drag_on_main_bearing = rear_upper_drag_x*minus_rear_upper_first_arm_y_minus_slider_y + rear_upper_drag_y*rear_upper_first_arm_x_plus_slider_x
    rear_upper_drag_on_crank_pin = rear_upper_drag_x*x3 + rear_upper_drag_y*x4
    rear_upper_drag_on_slider_pin = rear_upper_drag_y*rear_upper_first_arm_x - rear_upper_drag_x*rear_upper_first_arm_y
    return (ca.vertcat(rear_upper_drag_on_main_bearing + rear_upper_push_on_main_bearing, rear_upper_drag_on_crank_pin +
            rear_upper_push_on_crank_pin, rear_upper_drag_on_slider_pin + rear_upper_push_on_slider_pin),
        ca.vertcat(0, rear_upper_normal_power, 0, 0, 0, rear_upper_friction_power, 0, 0), ca.vertcat(rear_upper_normal_force),
        ca.vertcat(rear_upper_sliding_velocity), ca.vertcat(1))


def contact_front_lower(t, q, u, z, m, c):
    """Forces of front_lower: power x flores, smooth_coulomb; arguments and returns as of contact_rear_lower."""
    crank_length, rod_length, half_length, half_width, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[9]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    front_lower_first_arm_x = cos_slider*half_length + sin_slider*half_width
    front_lower_first_arm_y = sin_slider*half_length - cos_slider*half_width
    x, y, relative_rate_x, relative_rate_y = body_contact_terms(rod_arm_x, rod_arm_y, slider_arm_x, slider_arm_y, slider_arm_rate_x, slider_arm_rate_y, slider_rate_z, front_lower_first_arm_x, front_lower_first_arm_y, main_bearing_speed)
    front_lower_apart_x = front_lower_first_arm_x + x - rod_length
    front_lower_apart_y = front_lower_first_arm_y + rear_upper_second_arm_y + y
    front_lower_beyond = minus_half_guide_length + ca.if_else(front_lower_apart_x > 0, front_lower_apart_x, -front_lower_apart_x)
    front_lower_gap = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_y, front_lower_beyond)
    front_lower_end_x = ca.if_else(front_lower_apart_x > 0, 1, -1)
    front_lower_normal_x = ca.if_else(front_lower_apart_y > front_lower_beyond, 0, front_lower_end_x)
    front_lower_normal_y = ca.if_else(front_lower_apart_y > front_lower_beyond, 1, 0)
    front_lower_penetration_rate = -front_lower_normal_x*relative_rate_x - front_lower_normal_y*relative_rate_y
    normal_force, normal_power, first_push_on, second_push_on, third_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on = corner_on_face_contact(rod_arm_x, rod_arm_y, x, y, front_lower_first_arm_x, front_lower_first_arm_y, front_lower_gap, front_lower_normal_x, front_lower_normal_y, relative_rate_x, relative_rate_y, c[12], front_lower_penetration_rate, m[2], c[6], c[7], front_lower_penetration_rate, c[13])
    return (ca.vertcat(first_drag_on + first_push_on, second_drag_on + second_push_on, third_drag_on + third_push_on),
        ca.vertcat(0, 0, normal_power, 0, 0, 0, power, 0), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_front_upper(t, q, u, z, m, c):
    """Forces of front_upper: power x flores, smooth_coulomb; arguments and returns as of contact_rear_lower."""
    crank_length, rod_length, half_length, half_width, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[9]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_arm_rate_x = -rod_rate_z*slider_arm_y
    slider_arm_rate_y = rod_rate_z*slider_arm_x
    slider_rate_z = rod_rate_z + slider_pin_speed
    front_upper_first_arm_x = cos_slider*half_length - sin_slider*half_width
    front_upper_first_arm_y = cos_slider*half_width + sin_slider*half_length
    x, y, relative_rate_x, relative_rate_y = body_contact_terms(rod_arm_x, rod_arm_y, slider_arm_x, slider_arm_y, slider_arm_rate_x, slider_arm_rate_y, slider_rate_z, front_upper_first_arm_x, front_upper_first_arm_y, main_bearing_speed)
    front_upper_apart_x = front_upper_first_arm_x + x - rod_length
    front_upper_apart_y = front_upper_first_arm_y + y - rear_upper_second_arm_y
    front_upper_beyond = minus_half_guide_length + ca.if_else(front_upper_apart_x > 0, front_upper_apart_x, -front_upper_apart_x)
    front_upper_gap = ca.if_else(-front_upper_apart_y > front_upper_beyond, -front_upper_apart_y, front_upper_beyond)
    front_upper_end_x = ca.if_else(front_upper_apart_x > 0, 1, -1)
    front_upper_normal_x = ca.if_else(-front_upper_apart_y > front_upper_beyond, 0, front_upper_end_x)
    front_upper_normal_y = ca.if_else(-front_upper_apart_y > front_upper_beyond, -1, 0)
    front_upper_penetration_rate = -front_upper_normal_x*relative_rate_x - front_upper_normal_y*relative_rate_y
    normal_force, normal_power, first_push_on, second_push_on, third_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on = corner_on_face_contact(rod_arm_x, rod_arm_y, x, y, front_upper_first_arm_x, front_upper_first_arm_y, front_upper_gap, front_upper_normal_x, front_upper_normal_y, relative_rate_x, relative_rate_y, c[12], front_upper_penetration_rate, m[3], c[6], c[7], front_upper_penetration_rate, c[13])
    return (ca.vertcat(first_drag_on + first_push_on, second_drag_on + second_push_on, third_drag_on + third_push_on),
        ca.vertcat(0, 0, 0, normal_power, 0, 0, 0, power), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): main_bearing [N m], crank_pin [N m], slider_pin [N m]
    """
    gravity, rod_h_x, crank_h_x = c[5], c[14], c[15]
    main_bearing_angle, crank_pin_angle = q[0], q[1]
    cos_crank = ca.cos(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    rod_moment_x = cos_rod*rod_h_x
    crank_moment_x = cos_crank*crank_h_x
    crank_total_moment_x = crank_moment_x + rod_moment_x
    return ca.vertcat(-crank_total_moment_x*gravity, -rod_moment_x*gravity, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (3,): main_bearing.acceleration [rad/s^2], crank_pin.acceleration [rad/s^2], slider_pin.acceleration [rad/s^2]
        reactions (0,): empty
    """
    crank_length, slider_inertia, rod_h_x, rod_total_J_z_z, crank_I_z_z_plus_rod_total_J_z_z = c[0], c[2], c[14], c[16], c[17]
    inverse_D_crank_pin, inverse_slider_inertia = c[18], c[19]
    main_bearing_angle, crank_pin_angle = q[0], q[1]
    main_bearing_speed, crank_pin_speed = u[0], u[1]
    main_bearing_force, crank_pin_force, slider_pin_force = f[0], f[1], f[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_rate_z = crank_pin_speed + main_bearing_speed
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    crank_rate_zz = main_bearing_speed*main_bearing_speed
    rod_rate_zz = rod_rate_z*rod_rate_z
    rod_force_x = -rod_moment_x*rod_rate_zz
    rod_force_y = -rod_moment_y*rod_rate_zz
    rod_bias_x = -crank_rate_zz*rod_arm_x
    rod_bias_y = -crank_rate_zz*rod_arm_y
    rod_torque_z = rod_bias_y*rod_moment_x - rod_bias_x*rod_moment_y
    crank_torque_z = rod_torque_z + rod_arm_x*rod_force_y - rod_arm_y*rod_force_x
    main_bearing_net = main_bearing_force - crank_torque_z
    crank_pin_net = crank_pin_force - rod_torque_z
    crank_total_J_z_z = crank_I_z_z_plus_rod_total_J_z_z + 2*rod_arm_x*rod_moment_x + 2*rod_arm_y*rod_moment_y
    crank_pin_rod_torque_z = rod_total_J_z_z + rod_arm_x*rod_moment_x + rod_arm_y*rod_moment_y
    L_main_bearing_crank_pin = crank_pin_rod_torque_z - slider_inertia
    l_main_bearing_crank_pin = L_main_bearing_crank_pin*inverse_D_crank_pin
    D_main_bearing = crank_total_J_z_z - slider_inertia - L_main_bearing_crank_pin*l_main_bearing_crank_pin
    y_crank_pin = crank_pin_net - slider_pin_force
    y_main_bearing = main_bearing_net - slider_pin_force - l_main_bearing_crank_pin*y_crank_pin
    main_bearing_acc = y_main_bearing/D_main_bearing
    crank_pin_acc = inverse_D_crank_pin*y_crank_pin - l_main_bearing_crank_pin*main_bearing_acc
    slider_pin_acc = inverse_slider_inertia*slider_pin_force - crank_pin_acc - main_bearing_acc
    return ca.vertcat(main_bearing_acc, crank_pin_acc, slider_pin_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (8,): MEMORY [W]
    """
    return ca.vertcat(*[0]*8)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (4,): PAIRS [J]
    """
    crank_length, rod_length, half_length, half_width, rear_lower_second_arm_y, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[8], c[9]
    minus_half_guide_length, two_fifths_of_stiffness, rod_h_x_2, half_crank_I_z_z_2, half_rod_I_z_z_2 = c[10], c[11], c[20], c[21], c[22]
    half_slider_inertia, half_rod_mass, half_slider_mass, half_crank_length, half_rod_length = c[23], c[24], c[25], c[26], c[27]
    crank_mass_times_gravity, gravity_times_slider_mass, gravity_times_rod_mass = c[28], c[29], c[30]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    main_bearing_speed, crank_pin_speed, slider_pin_speed = u[0], u[1], u[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    rod_arm_rate_x = -main_bearing_speed*rod_arm_y
    rod_arm_rate_y = main_bearing_speed*rod_arm_x
    rod_rate_z = crank_pin_speed + main_bearing_speed
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_rate_z = rod_rate_z + slider_pin_speed
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    sin_slider_times_half_width = sin_slider*half_width
    minus_cos_slider_times_half_length = -cos_slider*half_length
    rear_lower_first_arm_x = sin_slider_times_half_width + minus_cos_slider_times_half_length
    minus_cos_slider_times_half_width = -cos_slider*half_width
    minus_sin_slider_times_half_length = -sin_slider*half_length
    rear_lower_first_arm_y = minus_cos_slider_times_half_width + minus_sin_slider_times_half_length
    rear_lower_apart_x = rear_lower_first_arm_x + slider_x - rod_length
    rear_lower_apart_y = rear_lower_first_arm_y + slider_y - rear_lower_second_arm_y
    minus_sin_slider_times_half_width = -sin_slider*half_width
    rear_upper_first_arm_x = minus_cos_slider_times_half_length + minus_sin_slider_times_half_width
    cos_slider_times_half_width = cos_slider*half_width
    rear_upper_first_arm_y = minus_sin_slider_times_half_length + cos_slider_times_half_width
    rear_upper_apart_x = rear_upper_first_arm_x + slider_x - rod_length
    rear_upper_apart_y = rear_upper_first_arm_y + slider_y - rear_upper_second_arm_y
    cos_slider_times_half_length = cos_slider*half_length
    front_lower_first_arm_x = sin_slider_times_half_width + cos_slider_times_half_length
    sin_slider_times_half_length = sin_slider*half_length
    front_lower_first_arm_y = minus_cos_slider_times_half_width + sin_slider_times_half_length
    front_lower_apart_x = front_lower_first_arm_x + slider_x - rod_length
    front_lower_apart_y = front_lower_first_arm_y + rear_upper_second_arm_y + slider_y
    front_upper_first_arm_x = minus_sin_slider_times_half_width + cos_slider_times_half_length
    front_upper_first_arm_y = cos_slider_times_half_width + sin_slider_times_half_length
    front_upper_apart_x = front_upper_first_arm_x + slider_x - rod_length
    front_upper_apart_y = front_upper_first_arm_y + slider_y - rear_upper_second_arm_y
    rear_lower_beyond = minus_half_guide_length + ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_x, -rear_lower_apart_x)
    rear_lower_gap = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_y, rear_lower_beyond)
    rear_upper_beyond = minus_half_guide_length + ca.if_else(rear_upper_apart_x > 0, rear_upper_apart_x, -rear_upper_apart_x)
    rear_upper_gap = ca.if_else(-rear_upper_apart_y > rear_upper_beyond, -rear_upper_apart_y, rear_upper_beyond)
    front_lower_beyond = minus_half_guide_length + ca.if_else(front_lower_apart_x > 0, front_lower_apart_x, -front_lower_apart_x)
    front_lower_gap = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_y, front_lower_beyond)
    front_upper_beyond = minus_half_guide_length + ca.if_else(front_upper_apart_x > 0, front_upper_apart_x, -front_upper_apart_x)
    front_upper_gap = ca.if_else(-front_upper_apart_y > front_upper_beyond, -front_upper_apart_y, front_upper_beyond)
    rear_lower_stored_energy = ca.if_else(-rear_lower_gap > 0, two_fifths_of_stiffness*(-rear_lower_gap)**2*ca.sqrt(-rear_lower_gap), 0)
    rear_upper_stored_energy = ca.if_else(-rear_upper_gap > 0, two_fifths_of_stiffness*(-rear_upper_gap)**2*ca.sqrt(-rear_upper_gap), 0)
    front_lower_stored_energy = ca.if_else(-front_lower_gap > 0, two_fifths_of_stiffness*(-front_lower_gap)**2*ca.sqrt(-front_lower_gap), 0)
    front_upper_stored_energy = ca.if_else(-front_upper_gap > 0, two_fifths_of_stiffness*(-front_upper_gap)**2*ca.sqrt(-front_upper_gap), 0)
    rod_moment_x_2 = cos_rod*rod_h_x_2
    rod_moment_y_2 = rod_h_x_2*sin_rod
    slider_velocity_x_2 = rod_arm_rate_x - rod_rate_z*slider_arm_y
    slider_velocity_y_2 = rod_arm_rate_y + rod_rate_z*slider_arm_x
    kinetic = half_rod_mass*(rod_arm_rate_x*rod_arm_rate_x + rod_arm_rate_y*rod_arm_rate_y) + half_slider_mass*(slider_velocity_x_2*slider_velocity_x_2 + slider_velocity_y_2*slider_velocity_y_2) + half_crank_I_z_z_2*main_bearing_speed*main_bearing_speed + half_rod_I_z_z_2*rod_rate_z*rod_rate_z + half_slider_inertia*slider_rate_z*slider_rate_z + rod_arm_rate_y*rod_moment_x_2*rod_rate_z - rod_arm_rate_x*rod_moment_y_2*rod_rate_z
    crank_centre_arm_y = half_crank_length*sin_crank
    rod_centre_arm_y = half_rod_length*sin_rod
    potential = crank_centre_arm_y*crank_mass_times_gravity + gravity_times_slider_mass*slider_y + gravity_times_rod_mass*(rod_arm_y + rod_centre_arm_y)
    return (ca.vertcat(kinetic), ca.vertcat(potential),
        ca.vertcat(rear_lower_stored_energy, rear_upper_stored_energy, front_lower_stored_energy, front_upper_stored_energy))


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
    crank_length, rod_length = c[0], c[1]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    return (ca.vertcat(0, 0, 0, rod_arm_x, rod_arm_y, 0, slider_x, slider_y, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_rod, -sin_rod, 0, sin_rod, cos_rod, 0, 0, 0, 1,
            cos_slider, -sin_slider, 0, sin_slider, cos_slider, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): OUTPUTS
    """
    crank_length, rod_length, half_length, half_width, rear_lower_second_arm_y, rear_upper_second_arm_y = c[0], c[1], c[3], c[4], c[8], c[9]
    minus_half_guide_length = c[10]
    main_bearing_angle, crank_pin_angle, slider_pin_angle = q[0], q[1], q[2]
    cos_crank = ca.cos(main_bearing_angle)
    sin_crank = ca.sin(main_bearing_angle)
    rod_angle = crank_pin_angle + main_bearing_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    slider_angle = rod_angle + slider_pin_angle
    cos_slider = ca.cos(slider_angle)
    sin_slider = ca.sin(slider_angle)
    rod_arm_x = cos_crank*crank_length
    rod_arm_y = sin_crank*crank_length
    slider_arm_x = cos_rod*rod_length
    slider_arm_y = sin_rod*rod_length
    slider_x = rod_arm_x + slider_arm_x
    slider_y = rod_arm_y + slider_arm_y
    sin_slider_times_half_width = sin_slider*half_width
    minus_cos_slider_times_half_length = -cos_slider*half_length
    rear_lower_first_arm_x = sin_slider_times_half_width + minus_cos_slider_times_half_length
    minus_cos_slider_times_half_width = -cos_slider*half_width
    minus_sin_slider_times_half_length = -sin_slider*half_length
    rear_lower_first_arm_y = minus_cos_slider_times_half_width + minus_sin_slider_times_half_length
    rear_lower_apart_x = rear_lower_first_arm_x + slider_x - rod_length
    rear_lower_apart_y = rear_lower_first_arm_y + slider_y - rear_lower_second_arm_y
    minus_sin_slider_times_half_width = -sin_slider*half_width
    rear_upper_first_arm_x = minus_cos_slider_times_half_length + minus_sin_slider_times_half_width
    cos_slider_times_half_width = cos_slider*half_width
    rear_upper_first_arm_y = minus_sin_slider_times_half_length + cos_slider_times_half_width
    rear_upper_apart_x = rear_upper_first_arm_x + slider_x - rod_length
    rear_upper_apart_y = rear_upper_first_arm_y + slider_y - rear_upper_second_arm_y
    cos_slider_times_half_length = cos_slider*half_length
    front_lower_first_arm_x = sin_slider_times_half_width + cos_slider_times_half_length
    sin_slider_times_half_length = sin_slider*half_length
    front_lower_first_arm_y = minus_cos_slider_times_half_width + sin_slider_times_half_length
    front_lower_apart_x = front_lower_first_arm_x + slider_x - rod_length
    front_lower_apart_y = front_lower_first_arm_y + rear_upper_second_arm_y + slider_y
    front_upper_first_arm_x = minus_sin_slider_times_half_width + cos_slider_times_half_length
    front_upper_first_arm_y = cos_slider_times_half_width + sin_slider_times_half_length
    front_upper_apart_x = front_upper_first_arm_x + slider_x - rod_length
    front_upper_apart_y = front_upper_first_arm_y + slider_y - rear_upper_second_arm_y
    rear_lower_beyond = minus_half_guide_length + ca.if_else(rear_lower_apart_x > 0, rear_lower_apart_x, -rear_lower_apart_x)
    rear_lower_gap = ca.if_else(rear_lower_apart_y > rear_lower_beyond, rear_lower_apart_y, rear_lower_beyond)
    rear_upper_beyond = minus_half_guide_length + ca.if_else(rear_upper_apart_x > 0, rear_upper_apart_x, -rear_upper_apart_x)
    rear_upper_gap = ca.if_else(-rear_upper_apart_y > rear_upper_beyond, -rear_upper_apart_y, rear_upper_beyond)
    front_lower_beyond = minus_half_guide_length + ca.if_else(front_lower_apart_x > 0, front_lower_apart_x, -front_lower_apart_x)
    front_lower_gap = ca.if_else(front_lower_apart_y > front_lower_beyond, front_lower_apart_y, front_lower_beyond)
    front_upper_beyond = minus_half_guide_length + ca.if_else(front_upper_apart_x > 0, front_upper_apart_x, -front_upper_apart_x)
    front_upper_gap = ca.if_else(-front_upper_apart_y > front_upper_beyond, -front_upper_apart_y, front_upper_beyond)
    return ca.vertcat(rear_lower_gap, rear_upper_gap, front_lower_gap, front_upper_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent to slider_pin.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        rear_lower.corner (3,): x [m], y [m], z [m]
        rear_lower.face (10,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1], along_x [1], along_y [1], along_z [1], length
            [m]
        rear_upper.corner (3,): x [m], y [m], z [m]
        rear_upper.face (10,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1], along_x [1], along_y [1], along_z [1], length
            [m]
        front_lower.corner (3,): x [m], y [m], z [m]
        front_lower.face (10,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1], along_x [1], along_y [1], along_z [1], length
            [m]
        front_upper.corner (3,): x [m], y [m], z [m]
        front_upper.face (10,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1], along_x [1], along_y [1], along_z [1], length
            [m]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, rod.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    crank_length, rod_length, guide_length, half_length, half_width, clearance = p[2], p[5], p[8], p[9], p[10], p[11]
    minus_clearance_minus_half_width = -clearance - half_width
    clearance_plus_half_width = clearance + half_width
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(rod_length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(-half_length, -half_width, 0),
        ca.vertcat(rod_length, minus_clearance_minus_half_width, 0, 0, 1, 0, 1, 0, 0, guide_length),
        ca.vertcat(-half_length, half_width, 0), ca.vertcat(rod_length, clearance_plus_half_width, 0, 0, -1, 0, 1, 0, 0, guide_length),
        ca.vertcat(half_length, -half_width, 0),
        ca.vertcat(rod_length, minus_clearance_minus_half_width, 0, 0, 1, 0, 1, 0, 0, guide_length), ca.vertcat(half_length, half_width, 0),
        ca.vertcat(rod_length, clearance_plus_half_width, 0, 0, -1, 0, 1, 0, 0, guide_length), ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(crank_length/2, 0, 0), ca.vertcat(rod_length/2, 0, 0), ca.vertcat(0, 0, 0))
