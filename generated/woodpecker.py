"""woodpecker: limit cycle of jamming, slipping and pecking. Generated from derive/scenes/woodpecker.py.

Do not edit; regenerate with `hertzwerk derive woodpecker`.
Effects:
    gravity: uniform gravity
    spring: linear spring of spring_hinge
    upper, lower, beak: power x hunt_crossley
    upper_friction: smooth_coulomb at upper
    lower_friction: smooth_coulomb at lower
    beak_friction: smooth_coulomb at beak
    energy_ledger: work put in, energy dissipated per effect
Units: 121 assignments and 283 outputs checked, all consistent
Operations: flight 169 (equations of motion and gaps); in contact also contact_upper 39, contact_lower 39, contact_beak 59
"""

import casadi as ca

NAME = "woodpecker"
SOURCE = "derive/scenes/woodpecker.py"
SUMMARY = "limit cycle of jamming, slipping and pecking"
FORMAT = "hertzwerk module 1"
DIGEST = "b826831832ddb3774583af0a53b75eef"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("spring", "spring", "linear spring of spring_hinge"),
    ("upper", "contact", "power x hunt_crossley"), ("lower", "contact", "power x hunt_crossley"),
    ("beak", "contact", "power x hunt_crossley"), ("upper_friction", "friction", "smooth_coulomb at upper"),
    ("lower_friction", "friction", "smooth_coulomb at lower"), ("beak_friction", "friction", "smooth_coulomb at beak"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("sleeve_mass", "g", 0.3, "body sleeve, mass"),
    ("sleeve_inertia", "kg m^2", 5e-09, "body sleeve, inertia"),
    ("sleeve_radius", "mm", 3.1, "point of sleeve"),
    ("hinge", "mm", 10, "point of sleeve"),
    ("sleeve_half_height", "mm", 5.8, "point of sleeve"),
    ("bird_mass", "g", 4.5, "body bird, mass"),
    ("bird_inertia", "kg m^2", 7e-07, "body bird, inertia"),
    ("bird_centre", "mm", 15, "from the hinge"),
    ("beak_height", "mm", 20, "point of bird"),
    ("beak_back", "mm", 20.1, "from the bird's mass centre"),
    ("bar_radius", "mm", 2.5, "point of ground"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("spring_stiffness", "N m/rad", 0.0056, "effect spring, stiffness"),
    ("stiffness", "N/m^1.5", 1000000.0, "effect upper, stiffness of power"),
    ("sleeve_restitution", "1", 0.05, "effect upper, coefficient of restitution of hunt_crossley"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("beak_restitution", "1", 0.5, "effect beak, coefficient of restitution of hunt_crossley"),
    ("friction_coefficient", "1", 0.3, "effect upper_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 1e-05, "effect upper_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("start_fall", "m/s", -0.3411, "start, speed of fall"),
    ("start_tilt", "rad", -0.1036, "start, position of tilt"),
    ("bent", "rad", -0.1752, "start, position of spring_hinge"),
    ("start_bend", "rad/s", -7.4583, "start, speed of spring_hinge"),
    ("pace", "m/s", 0.3, "scales, speed"),
)

LIMITS = (
    ("sleeve_mass", "defined", 0, None, True, False, "body sleeve, mass"),
    ("sleeve_inertia", "defined", 0, None, False, False, "body sleeve, inertia"),
    ("bird_mass", "defined", 0, None, True, False, "body bird, mass"),
    ("bird_inertia", "defined", 0, None, False, False, "body bird, inertia"),
    ("bird_centre", "defined", 0, None, True, False, "body bird, cylinder, length"),
    ("spring_stiffness", "defined", 0, None, False, False, "effect spring, stiffness"),
    ("stiffness", "defined", 0, None, True, False, "effect upper, stiffness of power"),
    ("sleeve_restitution", "defined", 0, 1, False, False, "effect upper, coefficient of restitution of hunt_crossley"),
    ("sleeve_restitution", "recommended", 0.8, 1, False, False, "effect upper, coefficient of restitution of hunt_crossley"),
    ("approach_floor", "defined", 0, None, True, False, "effect upper, approach floor"),
    ("beak_restitution", "defined", 0, 1, False, False, "effect beak, coefficient of restitution of hunt_crossley"),
    ("beak_restitution", "recommended", 0.8, 1, False, False, "effect beak, coefficient of restitution of hunt_crossley"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect upper_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect upper_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("pace", "defined", 0, None, True, False, "scales, speed"),
    ("sleeve_half_height", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("hinge", 0.25), ("sleeve_radius", -0.25)), "defined", 0, None, True, False, "body sleeve, box, x"),
    ((("hinge", 0.75), ("sleeve_radius", -0.75)), "defined", 0, None, True, False, "body sleeve, rod, length"),
)

COORDINATES = (("fall.travel", "m"), ("tilt.angle", "rad"), ("spring_hinge.angle", "rad"))

SPEEDS = (("fall.speed", "m/s"), ("tilt.speed", "rad/s"), ("spring_hinge.speed", "rad/s"))

MEMORY = (
    ("upper.dissipated", "J"), ("lower.dissipated", "J"), ("beak.dissipated", "J"), ("upper_friction.dissipated", "J"),
    ("lower_friction.dissipated", "J"), ("beak_friction.dissipated", "J"),
)

LATCHES = (("upper.approach_speed", "m/s", 0), ("lower.approach_speed", "m/s", 1), ("beak.approach_speed", "m/s", 2))

PAIRS = (("upper", "corner_on_face"), ("lower", "corner_on_face"), ("beak", "corner_on_face"))

GUIDES = ("upper", "lower", "beak")

RELEASES = ("force", "force", "force")

DISSIPATED = (0, 1, 2)

OUTPUTS = (("upper.gap", "m"), ("lower.gap", "m"), ("beak.gap", "m"))

BODIES = ("carriage", "sleeve", "bird")

LANDMARKS = (
    ("fall", "prismatic", "parent", "ground", ("axis",)), ("fall", "prismatic", "child", "carriage", ("axis",)),
    ("tilt", "revolute", "parent", "carriage", ("axis",)), ("tilt", "revolute", "child", "sleeve", ("axis",)),
    ("spring_hinge", "revolute", "parent", "sleeve", ("axis",)), ("spring_hinge", "revolute", "child", "bird", ("axis",)),
    ("upper", "corner_on_face", "corner", "sleeve", ()), ("upper", "corner_on_face", "face", "ground", ("normal",)),
    ("lower", "corner_on_face", "corner", "sleeve", ()), ("lower", "corner_on_face", "face", "ground", ("normal",)),
    ("beak", "corner_on_face", "corner", "bird", ()), ("beak", "corner_on_face", "face", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("spring", "turn_spring", "child", "bird", ("axis",)),
    ("sleeve", "body", "centre", "sleeve", ()), ("bird", "body", "centre", "bird", ()),
    ("sleeve", "solid_box", "shape_1", "sleeve", ("size",)), ("sleeve", "solid_box", "shape_2", "sleeve", ("size",)),
    ("sleeve", "solid_rod", "shape_3", "sleeve", ("axis", "length")),
    ("bird", "solid_cylinder", "shape_1", "bird", ("axis", "radius", "length")),
    ("bird", "solid_cylinder", "shape_2", "bird", ("axis", "radius", "length")),
    ("bird", "solid_rod", "shape_3", "bird", ("axis", "length")), ("bird", "solid_rod", "shape_4", "bird", ("axis", "length")),
)

CONSTANTS = (
    ("sleeve_radius", "m"), ("hinge", "m"), ("sleeve_half_height", "m"), ("bird_centre", "m"), ("beak_height", "m"), ("bar_radius", "m"),
    ("gravity", "m/s^2"), ("spring_stiffness", "J"), ("stiffness", "N/m^1.5"), ("friction_coefficient", "1"),
    ("beak_back_minus_bird_centre", "m"), ("total_mass", "kg"), ("two_fifths_of_stiffness", "N/m^1.5"), ("upper_hysteresis_factor", "1"),
    ("inverse_friction_speed", "s/m"), ("beak_hysteresis_factor", "1"), ("bird_h_x", "kg m"), ("sleeve_h_x", "kg m"),
    ("bird_I_z_z", "kg m^2"), ("bird_I_z_z_plus_sleeve_I_z_z", "kg m^2"), ("inverse_bird_I_z_z", "1/(kg m^2)"),
    ("half_bird_I_z_z", "kg m^2"), ("half_sleeve_mass", "kg"), ("half_sleeve_inertia", "kg m^2"), ("half_bird_mass", "kg"),
    ("gravity_times_sleeve_mass", "N"), ("bird_mass_times_gravity", "N"),
)

OPERATIONS = (
    ("constants", 29), ("start", 0), ("scales", 8), ("coordinate_rates", 0), ("gaps", 38), ("gap_accelerations", 46), ("contact_upper", 39),
    ("contact_lower", 39), ("contact_beak", 59), ("applied", 14), ("accelerations", 71), ("ledger", 0), ("energy", 83), ("poses", 10),
    ("outputs", 19), ("landmarks", 61),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (27,): sleeve_radius, hinge, sleeve_half_height, bird_centre, beak_height, bar_radius, gravity, spring_stiffness, stiffness,
            friction_coefficient, beak_back_minus_bird_centre, total_mass, two_fifths_of_stiffness, upper_hysteresis_factor,
            inverse_friction_speed, beak_hysteresis_factor, bird_h_x, sleeve_h_x, bird_I_z_z, bird_I_z_z_plus_sleeve_I_z_z,
            inverse_bird_I_z_z, half_bird_I_z_z, half_sleeve_mass, half_sleeve_inertia, half_bird_mass, gravity_times_sleeve_mass,
            bird_mass_times_gravity
    """
    sleeve_mass, sleeve_inertia, sleeve_radius, hinge, sleeve_half_height, bird_mass = p[0], p[1], p[2], p[3], p[4], p[5]
    bird_inertia, bird_centre, beak_height, beak_back, bar_radius, gravity, spring_stiffness = p[6], p[7], p[8], p[9], p[10], p[11], p[12]
    stiffness, sleeve_restitution, beak_restitution, friction_coefficient, friction_speed = p[13], p[14], p[16], p[17], p[18]
    beak_back_minus_bird_centre = beak_back - bird_centre
    total_mass = bird_mass + sleeve_mass
    two_fifths_of_stiffness = 2*stiffness/5
    upper_hysteresis_factor = 3/2 - 3*sleeve_restitution/2
    inverse_friction_speed = 1/friction_speed
    beak_hysteresis_factor = 3/2 - 3*beak_restitution/2
    bird_h_x = bird_centre*bird_mass
    sleeve_h_x = bird_mass*hinge
    sleeve_I_z_z = hinge*hinge*bird_mass + sleeve_inertia
    bird_I_z_z = bird_centre*bird_centre*bird_mass + bird_inertia
    bird_I_z_z_plus_sleeve_I_z_z = bird_I_z_z + sleeve_I_z_z
    inverse_bird_I_z_z = 1/bird_I_z_z
    half_bird_I_z_z = bird_I_z_z/2
    half_sleeve_mass = sleeve_mass/2
    half_sleeve_inertia = sleeve_inertia/2
    half_bird_mass = bird_mass/2
    gravity_times_sleeve_mass = gravity*sleeve_mass
    bird_mass_times_gravity = bird_mass*gravity
    return ca.vertcat(sleeve_radius, hinge, sleeve_half_height, bird_centre, beak_height, bar_radius, gravity, spring_stiffness, stiffness,
        friction_coefficient, beak_back_minus_bird_centre, total_mass, two_fifths_of_stiffness, upper_hysteresis_factor,
        inverse_friction_speed, beak_hysteresis_factor, bird_h_x, sleeve_h_x, bird_I_z_z, bird_I_z_z_plus_sleeve_I_z_z, inverse_bird_I_z_z,
        half_bird_I_z_z, half_sleeve_mass, half_sleeve_inertia, half_bird_mass, gravity_times_sleeve_mass, bird_mass_times_gravity)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (3,): SPEEDS
    """
    start_fall, start_tilt, bent, start_bend = p[19], p[20], p[21], p[22]
    return ca.vertcat(0, start_tilt, bent), ca.vertcat(start_fall, 0, start_bend)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (3,): SPEEDS
        sz (6,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    sleeve_mass, sleeve_radius, sleeve_half_height, bird_mass, bar_radius, pace = p[0], p[2], p[4], p[5], p[10], p[23]
    total_mass = bird_mass + sleeve_mass
    energy_scale = total_mass*pace*pace/2
    sleeve_radius_minus_bar_radius = sleeve_radius - bar_radius
    force_scale = energy_scale/sleeve_radius_minus_bar_radius
    x2 = sleeve_radius_minus_bar_radius/sleeve_half_height
    pace_over_sleeve_half_height = pace/sleeve_half_height
    return (ca.vertcat(sleeve_radius_minus_bar_radius, x2, x2), ca.vertcat(pace, pace_over_sleeve_half_height,
            pace_over_sleeve_half_height),
        ca.vertcat(*[energy_scale]*6), ca.vertcat(sleeve_radius_minus_bar_radius, pace, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): fall.travel [m/s], tilt.angle [rad/s], spring_hinge.angle [rad/s]
    """
    fall_speed, tilt_speed, spring_hinge_speed = u[0], u[1], u[2]
    return ca.vertcat(fall_speed, tilt_speed, spring_hinge_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (3,): PAIRS [m]
        dG (3,): PAIRS [m/s]
    """
    sleeve_radius, hinge, sleeve_half_height, beak_height, bar_radius, beak_back_minus_bird_centre = c[0], c[1], c[2], c[4], c[5], c[10]
    tilt_angle, spring_hinge_angle = q[1], q[2]
    tilt_speed, spring_hinge_speed = u[1], u[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    cos_sleeve_times_sleeve_radius = cos_sleeve*sleeve_radius
    upper_first_arm_x = cos_sleeve_times_sleeve_radius - sin_sleeve*sleeve_half_height
    sin_sleeve_times_sleeve_radius = sin_sleeve*sleeve_radius
    upper_first_arm_y = sin_sleeve_times_sleeve_radius + cos_sleeve*sleeve_half_height
    upper_first_arm_rate_x = -tilt_speed*upper_first_arm_y
    upper_apart_x = upper_first_arm_x - bar_radius
    lower_first_arm_x = cos_sleeve_times_sleeve_radius + sin_sleeve*sleeve_half_height
    lower_first_arm_y = sin_sleeve_times_sleeve_radius - cos_sleeve*sleeve_half_height
    lower_first_arm_rate_x = -lower_first_arm_y*tilt_speed
    lower_apart_x = lower_first_arm_x - bar_radius
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_arm_rate_x = -bird_arm_y*tilt_speed
    bird_rate_z = spring_hinge_speed + tilt_speed
    beak_first_arm_x = -cos_bird*beak_back_minus_bird_centre - sin_bird*beak_height
    beak_first_arm_y = cos_bird*beak_height - beak_back_minus_bird_centre*sin_bird
    beak_first_arm_rate_x = -beak_first_arm_y*bird_rate_z
    beak_apart_x = beak_first_arm_x + bird_arm_x - bar_radius
    beak_apart_rate_x = beak_first_arm_rate_x + bird_arm_rate_x
    return (ca.vertcat(upper_apart_x, lower_apart_x, beak_apart_x),
        ca.vertcat(upper_first_arm_rate_x, lower_first_arm_rate_x, beak_apart_rate_x))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (3,): PAIRS [m/s^2]
    """
    sleeve_radius, hinge, sleeve_half_height, beak_height, beak_back_minus_bird_centre = c[0], c[1], c[2], c[4], c[10]
    tilt_angle, spring_hinge_angle = q[1], q[2]
    tilt_speed, spring_hinge_speed = u[1], u[2]
    tilt_acceleration, spring_hinge_acceleration = a[1], a[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    cos_sleeve_times_sleeve_radius = cos_sleeve*sleeve_radius
    upper_first_arm_x = cos_sleeve_times_sleeve_radius - sin_sleeve*sleeve_half_height
    sin_sleeve_times_sleeve_radius = sin_sleeve*sleeve_radius
    upper_first_arm_y = sin_sleeve_times_sleeve_radius + cos_sleeve*sleeve_half_height
    upper_first_arm_rate_y = tilt_speed*upper_first_arm_x
    upper_apart_acceleration_x = -tilt_acceleration*upper_first_arm_y - tilt_speed*upper_first_arm_rate_y
    lower_first_arm_x = cos_sleeve_times_sleeve_radius + sin_sleeve*sleeve_half_height
    lower_first_arm_y = sin_sleeve_times_sleeve_radius - cos_sleeve*sleeve_half_height
    lower_first_arm_rate_y = lower_first_arm_x*tilt_speed
    lower_apart_acceleration_x = -lower_first_arm_rate_y*tilt_speed - lower_first_arm_y*tilt_acceleration
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_arm_rate_y = bird_arm_x*tilt_speed
    bird_rate_z = spring_hinge_speed + tilt_speed
    bird_angular_acceleration_z = spring_hinge_acceleration + tilt_acceleration
    bird_acceleration_x = -bird_arm_rate_y*tilt_speed - bird_arm_y*tilt_acceleration
    beak_first_arm_x = -cos_bird*beak_back_minus_bird_centre - sin_bird*beak_height
    beak_first_arm_y = cos_bird*beak_height - beak_back_minus_bird_centre*sin_bird
    beak_first_arm_rate_y = beak_first_arm_x*bird_rate_z
    beak_apart_acceleration_x = bird_acceleration_x - beak_first_arm_rate_y*bird_rate_z - beak_first_arm_y*bird_angular_acceleration_z
    return ca.vertcat(upper_apart_acceleration_x, lower_apart_acceleration_x, beak_apart_acceleration_x)


def contact_upper(t, q, u, z, m, c):
    """Forces of upper: power x hunt_crossley, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): fall [N], tilt [N m], spring_hinge [N m]
        dz (6,): MEMORY [W]
        normal_force (1,): upper [N]
        sliding_velocity (1,): upper [m/s]
        in_range (1,): upper [1]
    """
    sleeve_radius, sleeve_half_height, bar_radius, stiffness, friction_coefficient = c[0], c[2], c[5], c[8], c[9]
    upper_hysteresis_factor, inverse_friction_speed = c[13], c[14]
    tilt_angle = q[1]
    fall_speed, tilt_speed = u[0], u[1]
    upper_approach_speed = m[0]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    upper_first_arm_x = cos_sleeve*sleeve_radius - sin_sleeve*sleeve_half_height
    upper_first_arm_y = cos_sleeve*sleeve_half_height + sin_sleeve*sleeve_radius
    upper_first_arm_rate_x = -tilt_speed*upper_first_arm_y
    upper_apart_x = upper_first_arm_x - bar_radius
    upper_elastic_force = ca.if_else(-upper_apart_x > 0, -upper_apart_x*ca.sqrt(-upper_apart_x)*stiffness, 0)
    upper_relative_rate_y = fall_speed + tilt_speed*upper_first_arm_x
    upper_resistance = -upper_elastic_force*upper_first_arm_rate_x*upper_hysteresis_factor/upper_approach_speed
    upper_normal_force = upper_elastic_force + upper_resistance
    upper_normal_power = -upper_first_arm_rate_x*upper_resistance
    upper_push_on_tilt = -upper_first_arm_y*upper_normal_force
    upper_friction_force = upper_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*upper_relative_rate_y)
    upper_friction_power = upper_friction_force*upper_relative_rate_y
    upper_drag_on_tilt = -upper_first_arm_x*upper_friction_force
    return (ca.vertcat(-upper_friction_force, upper_drag_on_tilt + upper_push_on_tilt, 0),
        ca.vertcat(upper_normal_power, 0, 0, upper_friction_power, 0, 0), ca.vertcat(upper_normal_force), ca.vertcat(upper_relative_rate_y),
        ca.vertcat(1))


def contact_lower(t, q, u, z, m, c):
    """Forces of lower: power x hunt_crossley, smooth_coulomb; arguments and returns as of contact_upper."""
    sleeve_radius, sleeve_half_height, bar_radius, stiffness, friction_coefficient = c[0], c[2], c[5], c[8], c[9]
    upper_hysteresis_factor, inverse_friction_speed = c[13], c[14]
    tilt_angle = q[1]
    fall_speed, tilt_speed = u[0], u[1]
    lower_approach_speed = m[1]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    lower_first_arm_x = cos_sleeve*sleeve_radius + sin_sleeve*sleeve_half_height
    lower_first_arm_y = sin_sleeve*sleeve_radius - cos_sleeve*sleeve_half_height
    lower_first_arm_rate_x = -lower_first_arm_y*tilt_speed
    lower_apart_x = lower_first_arm_x - bar_radius
    lower_elastic_force = ca.if_else(-lower_apart_x > 0, -lower_apart_x*ca.sqrt(-lower_apart_x)*stiffness, 0)
    lower_relative_rate_y = fall_speed + lower_first_arm_x*tilt_speed
    lower_resistance = -lower_elastic_force*lower_first_arm_rate_x*upper_hysteresis_factor/lower_approach_speed
    lower_normal_force = lower_elastic_force + lower_resistance
    lower_normal_power = -lower_first_arm_rate_x*lower_resistance
    lower_push_on_tilt = -lower_first_arm_y*lower_normal_force
    lower_friction_force = lower_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*lower_relative_rate_y)
    lower_friction_power = lower_friction_force*lower_relative_rate_y
    lower_drag_on_tilt = -lower_first_arm_x*lower_friction_force
    return (ca.vertcat(-lower_friction_force, lower_drag_on_tilt + lower_push_on_tilt, 0),
        ca.vertcat(0, lower_normal_power, 0, 0, lower_friction_power, 0), ca.vertcat(lower_normal_force), ca.vertcat(lower_relative_rate_y),
        ca.vertcat(1))


def contact_beak(t, q, u, z, m, c):
    """Forces of beak: power x hunt_crossley, smooth_coulomb; arguments and returns as of contact_upper."""
    hinge, beak_height, bar_radius, stiffness, friction_coefficient, beak_back_minus_bird_centre = c[1], c[4], c[5], c[8], c[9], c[10]
    inverse_friction_speed, beak_hysteresis_factor = c[14], c[15]
    fall_travel, tilt_angle, spring_hinge_angle = q[0], q[1], q[2]
    fall_speed, tilt_speed, spring_hinge_speed = u[0], u[1], u[2]
    beak_approach_speed = m[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_arm_rate_x = -bird_arm_y*tilt_speed
    bird_arm_rate_y = bird_arm_x*tilt_speed
    bird_rate_z = spring_hinge_speed + tilt_speed
    bird_y = bird_arm_y + fall_travel
    bird_velocity_y = bird_arm_rate_y + fall_speed
    beak_first_arm_x = -cos_bird*beak_back_minus_bird_centre - sin_bird*beak_height
    beak_first_arm_y = cos_bird*beak_height - beak_back_minus_bird_centre*sin_bird
    beak_apart_x = beak_first_arm_x + bird_arm_x - bar_radius
    beak_elastic_force = ca.if_else(-beak_apart_x > 0, -beak_apart_x*ca.sqrt(-beak_apart_x)*stiffness, 0)
    beak_relative_rate_x = bird_arm_rate_x - beak_first_arm_y*bird_rate_z
    beak_relative_rate_y = bird_velocity_y + beak_first_arm_x*bird_rate_z
    beak_resistance = -beak_elastic_force*beak_hysteresis_factor*beak_relative_rate_x/beak_approach_speed
    beak_normal_force = beak_elastic_force + beak_resistance
    beak_normal_power = -beak_relative_rate_x*beak_resistance
    beak_push_on_tilt = beak_normal_force*(fall_travel - beak_first_arm_y - bird_y)
    beak_push_on_spring_hinge = -beak_first_arm_y*beak_normal_force
    beak_friction_force = beak_normal_force*friction_coefficient*ca.tanh(beak_relative_rate_y*inverse_friction_speed)
    beak_friction_power = beak_friction_force*beak_relative_rate_y
    beak_drag_on_tilt = -beak_friction_force*(beak_first_arm_x + bird_arm_x)
    beak_drag_on_spring_hinge = -beak_first_arm_x*beak_friction_force
    return (ca.vertcat(-beak_friction_force, beak_drag_on_tilt + beak_push_on_tilt, beak_drag_on_spring_hinge + beak_push_on_spring_hinge),
        ca.vertcat(0, 0, beak_normal_power, 0, 0, beak_friction_power), ca.vertcat(beak_normal_force), ca.vertcat(beak_relative_rate_y),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): fall [N], tilt [N m], spring_hinge [N m]
    """
    gravity, spring_stiffness, total_mass, bird_h_x, sleeve_h_x = c[6], c[7], c[11], c[16], c[17]
    tilt_angle, spring_hinge_angle = q[1], q[2]
    cos_sleeve = ca.cos(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    spring_force = -spring_hinge_angle*spring_stiffness
    bird_moment_x = bird_h_x*cos_bird
    sleeve_moment_x = cos_sleeve*sleeve_h_x
    sleeve_total_moment_x = bird_moment_x + sleeve_moment_x
    return ca.vertcat(-total_mass*gravity, -sleeve_total_moment_x*gravity, spring_force - bird_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (3,): fall.acceleration [m/s^2], tilt.acceleration [rad/s^2], spring_hinge.acceleration [rad/s^2]
        reactions (0,): empty
    """
    hinge, total_mass, bird_h_x, sleeve_h_x, bird_I_z_z, bird_I_z_z_plus_sleeve_I_z_z = c[1], c[11], c[16], c[17], c[18], c[19]
    inverse_bird_I_z_z = c[20]
    tilt_angle, spring_hinge_angle = q[1], q[2]
    tilt_speed, spring_hinge_speed = u[1], u[2]
    fall_force, tilt_force, spring_hinge_force = f[0], f[1], f[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_rate_z = spring_hinge_speed + tilt_speed
    bird_moment_x = bird_h_x*cos_bird
    bird_moment_y = bird_h_x*sin_bird
    sleeve_moment_x = cos_sleeve*sleeve_h_x
    sleeve_moment_y = sin_sleeve*sleeve_h_x
    sleeve_total_moment_x = bird_moment_x + sleeve_moment_x
    bird_rate_zz = bird_rate_z*bird_rate_z
    bird_force_x = -bird_moment_x*bird_rate_zz
    bird_force_y = -bird_moment_y*bird_rate_zz
    sleeve_rate_zz = tilt_speed*tilt_speed
    sleeve_force_y = bird_force_y - sleeve_moment_y*sleeve_rate_zz
    fall_net = fall_force - sleeve_force_y
    bird_bias_x = -bird_arm_x*sleeve_rate_zz
    bird_bias_y = -bird_arm_y*sleeve_rate_zz
    bird_torque_z = bird_bias_y*bird_moment_x - bird_bias_x*bird_moment_y
    sleeve_torque_z = bird_torque_z + bird_arm_x*bird_force_y - bird_arm_y*bird_force_x
    tilt_net = tilt_force - sleeve_torque_z
    spring_hinge_net = spring_hinge_force - bird_torque_z
    sleeve_total_J_z_z = bird_I_z_z_plus_sleeve_I_z_z + 2*bird_arm_x*bird_moment_x + 2*bird_arm_y*bird_moment_y
    spring_hinge_bird_torque_z = bird_I_z_z + bird_arm_x*bird_moment_x + bird_arm_y*bird_moment_y
    l_tilt_spring_hinge = inverse_bird_I_z_z*spring_hinge_bird_torque_z
    D_tilt = sleeve_total_J_z_z - l_tilt_spring_hinge*spring_hinge_bird_torque_z
    l_fall_spring_hinge = bird_moment_x*inverse_bird_I_z_z
    L_fall_tilt = sleeve_total_moment_x - bird_moment_x*l_tilt_spring_hinge
    l_fall_tilt = L_fall_tilt/D_tilt
    D_fall = total_mass - L_fall_tilt*l_fall_tilt - bird_moment_x*l_fall_spring_hinge
    y_tilt = tilt_net - l_tilt_spring_hinge*spring_hinge_net
    y_fall = fall_net - l_fall_spring_hinge*spring_hinge_net - l_fall_tilt*y_tilt
    fall_acc = y_fall/D_fall
    tilt_acc = y_tilt/D_tilt - fall_acc*l_fall_tilt
    spring_hinge_acc = inverse_bird_I_z_z*spring_hinge_net - fall_acc*l_fall_spring_hinge - l_tilt_spring_hinge*tilt_acc
    return ca.vertcat(fall_acc, tilt_acc, spring_hinge_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (6,): MEMORY [W]
    """
    return ca.vertcat(*[0]*6)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (3,): PAIRS [J]
    """
    sleeve_radius, hinge, sleeve_half_height, bird_centre, beak_height, bar_radius = c[0], c[1], c[2], c[3], c[4], c[5]
    spring_stiffness, beak_back_minus_bird_centre, two_fifths_of_stiffness, bird_h_x, half_bird_I_z_z = c[7], c[10], c[12], c[16], c[21]
    half_sleeve_mass, half_sleeve_inertia, half_bird_mass, gravity_times_sleeve_mass = c[22], c[23], c[24], c[25]
    bird_mass_times_gravity = c[26]
    fall_travel, tilt_angle, spring_hinge_angle = q[0], q[1], q[2]
    fall_speed, tilt_speed, spring_hinge_speed = u[0], u[1], u[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    cos_sleeve_times_sleeve_radius = cos_sleeve*sleeve_radius
    upper_first_arm_x = cos_sleeve_times_sleeve_radius - sin_sleeve*sleeve_half_height
    upper_apart_x = upper_first_arm_x - bar_radius
    lower_first_arm_x = cos_sleeve_times_sleeve_radius + sin_sleeve*sleeve_half_height
    lower_apart_x = lower_first_arm_x - bar_radius
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_arm_rate_x = -bird_arm_y*tilt_speed
    bird_rate_z = spring_hinge_speed + tilt_speed
    bird_y = bird_arm_y + fall_travel
    beak_first_arm_x = -cos_bird*beak_back_minus_bird_centre - sin_bird*beak_height
    beak_apart_x = beak_first_arm_x + bird_arm_x - bar_radius
    upper_stored_energy = ca.if_else(-upper_apart_x > 0, two_fifths_of_stiffness*(-upper_apart_x)**2*ca.sqrt(-upper_apart_x), 0)
    lower_stored_energy = ca.if_else(-lower_apart_x > 0, two_fifths_of_stiffness*(-lower_apart_x)**2*ca.sqrt(-lower_apart_x), 0)
    beak_stored_energy = ca.if_else(-beak_apart_x > 0, two_fifths_of_stiffness*(-beak_apart_x)**2*ca.sqrt(-beak_apart_x), 0)
    bird_moment_x = bird_h_x*cos_bird
    bird_moment_y = bird_h_x*sin_bird
    bird_velocity_y_2 = fall_speed + bird_arm_x*tilt_speed
    kinetic = half_bird_I_z_z*bird_rate_z*bird_rate_z + half_sleeve_mass*fall_speed*fall_speed + half_sleeve_inertia*tilt_speed*tilt_speed + half_bird_mass*(bird_arm_rate_x*bird_arm_rate_x + bird_velocity_y_2*bird_velocity_y_2) + bird_moment_x*bird_rate_z*bird_velocity_y_2 - bird_arm_rate_x*bird_moment_y*bird_rate_z
    bird_centre_arm_y = sin_bird*bird_centre
    potential = fall_travel*gravity_times_sleeve_mass + bird_mass_times_gravity*(bird_centre_arm_y + bird_y)
    return (ca.vertcat(kinetic), ca.vertcat(potential + spring_hinge_angle*spring_hinge_angle*spring_stiffness/2),
        ca.vertcat(upper_stored_energy, lower_stored_energy, beak_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (9,): carriage.x [m], carriage.y [m], carriage.z [m], sleeve.x [m], sleeve.y [m], sleeve.z [m], bird.x [m], bird.y [m],
            bird.z [m]
        rotations (27,): carriage.R_xx [1], carriage.R_xy [1], carriage.R_xz [1], carriage.R_yx [1], carriage.R_yy [1], carriage.R_yz [1],
            carriage.R_zx [1], carriage.R_zy [1], carriage.R_zz [1], sleeve.R_xx [1], sleeve.R_xy [1], sleeve.R_xz [1], sleeve.R_yx [1],
            sleeve.R_yy [1], sleeve.R_yz [1], sleeve.R_zx [1], sleeve.R_zy [1], sleeve.R_zz [1], bird.R_xx [1], bird.R_xy [1], bird.R_xz
            [1], bird.R_yx [1], bird.R_yy [1], bird.R_yz [1], bird.R_zx [1], bird.R_zy [1], bird.R_zz [1]
    """
    hinge = c[1]
    fall_travel, tilt_angle, spring_hinge_angle = q[0], q[1], q[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    bird_arm_x = cos_sleeve*hinge
    bird_arm_y = sin_sleeve*hinge
    bird_y = bird_arm_y + fall_travel
    return (ca.vertcat(0, fall_travel, 0, 0, fall_travel, 0, bird_arm_x, bird_y, 0),
        ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1, cos_sleeve, -sin_sleeve, 0, sin_sleeve, cos_sleeve, 0, 0, 0, 1, cos_bird, -sin_bird, 0,
            sin_bird, cos_bird, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (3,): OUTPUTS
    """
    sleeve_radius, hinge, sleeve_half_height, beak_height, bar_radius, beak_back_minus_bird_centre = c[0], c[1], c[2], c[4], c[5], c[10]
    tilt_angle, spring_hinge_angle = q[1], q[2]
    cos_sleeve = ca.cos(tilt_angle)
    sin_sleeve = ca.sin(tilt_angle)
    bird_angle = spring_hinge_angle + tilt_angle
    cos_bird = ca.cos(bird_angle)
    sin_bird = ca.sin(bird_angle)
    cos_sleeve_times_sleeve_radius = cos_sleeve*sleeve_radius
    upper_first_arm_x = cos_sleeve_times_sleeve_radius - sin_sleeve*sleeve_half_height
    upper_apart_x = upper_first_arm_x - bar_radius
    lower_first_arm_x = cos_sleeve_times_sleeve_radius + sin_sleeve*sleeve_half_height
    lower_apart_x = lower_first_arm_x - bar_radius
    bird_arm_x = cos_sleeve*hinge
    beak_first_arm_x = -cos_bird*beak_back_minus_bird_centre - sin_bird*beak_height
    beak_apart_x = beak_first_arm_x + bird_arm_x - bar_radius
    return ca.vertcat(upper_apart_x, lower_apart_x, beak_apart_x)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        fall.parent to spring_hinge.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        upper.corner (3,): x [m], y [m], z [m]
        upper.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        lower.corner (3,): x [m], y [m], z [m]
        lower.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        beak.corner (3,): x [m], y [m], z [m]
        beak.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction, spring.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        sleeve.centre, bird.centre (3,): x [m], y [m], z [m]
        sleeve.shape_1, sleeve.shape_2 (6,): x [m], y [m], z [m], size_x [m], size_y [m], size_z [m]
        sleeve.shape_3 (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], length [m]
        bird.shape_1, bird.shape_2 (8,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], radius [m], length [m]
        bird.shape_3, bird.shape_4 (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], length [m]
    """
    sleeve_radius, hinge, sleeve_half_height, bird_centre, beak_height, beak_back, bar_radius = p[2], p[3], p[4], p[7], p[8], p[9], p[10]
    minus_quarter_of_sleeve_radius = -sleeve_radius/4
    quarter_of_hinge = hinge/4
    x3 = minus_quarter_of_sleeve_radius + quarter_of_hinge
    twice_sleeve_half_height = 2*sleeve_half_height
    sqrt_10 = ca.sqrt(10)
    beak_height_squared = beak_height*beak_height
    x7 = beak_height_squared/25
    beak_back_squared = beak_back*beak_back
    x9 = 4*beak_back_squared/9
    x10 = x7 + x9
    x11 = 1/ca.sqrt(x10)
    return (ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(hinge, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(sleeve_radius, sleeve_half_height, 0),
        ca.vertcat(bar_radius, 0, 0, 1, 0, 0), ca.vertcat(sleeve_radius, -sleeve_half_height, 0), ca.vertcat(bar_radius, 0, 0, 1, 0, 0),
        ca.vertcat(bird_centre - beak_back, beak_height, 0), ca.vertcat(bar_radius, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(bird_centre, 0, 0),
        ca.vertcat(hinge/8 + 7*sleeve_radius/8, 0, 0, x3, twice_sleeve_half_height, x3),
        ca.vertcat(-7*sleeve_radius/8 - hinge/8, 0, 0, x3, twice_sleeve_half_height, x3),
        ca.vertcat(3*sleeve_radius/8 + 5*hinge/8, 0, 0, 1, 0, 0, 3*hinge/4 - 3*sleeve_radius/4),
        ca.vertcat(bird_centre, 0, 0, 0, 0, 1, bird_centre/2, bird_centre),
        ca.vertcat(bird_centre - beak_back/3, 4*beak_height/5, 0, 0, 0, 1, bird_centre/4, bird_centre),
        ca.vertcat(bird_centre - beak_back/6, beak_height/2, 0, -sqrt_10/10, 3*sqrt_10/10, 0, 2*beak_height/3),
        ca.vertcat(bird_centre - 2*beak_back/3, 9*beak_height/10, 0, -2*x11*beak_back/3, x11*beak_height/5, 0, 2*beak_back/3))
