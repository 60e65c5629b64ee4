"""newtons_cradle: Newton's cradle. Generated from derive/scenes/newtons_cradle.py.

Do not edit; regenerate with `hertzwerk derive newtons_cradle`.
Effects:
    gravity: uniform gravity
    contact_0, contact_1, contact_2, contact_3: power x exact
    energy_ledger: work put in, energy dissipated per effect
Units: 189 assignments and 305 outputs checked, all consistent
Operations: flight 298 (equations of motion and gaps); in contact also contact_contact_0 47, contact_contact_1 47, contact_contact_2 47, contact_contact_3 47
"""

import casadi as ca

NAME = "newtons_cradle"
SOURCE = "derive/scenes/newtons_cradle.py"
SUMMARY = "Newton's cradle"
FORMAT = "hertzwerk module 1"
DIGEST = "ff5e89b366955bada68385c5a801c66e"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("contact_0", "contact", "power x exact"), ("contact_1", "contact", "power x exact"),
    ("contact_2", "contact", "power x exact"), ("contact_3", "contact", "power x exact"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("radius", "m", 0.02, "of each sphere"),
    ("density", "kg/m^3", 7800, ""),
    ("length", "m", 0.25, "pivot to the sphere's centre"),
    ("spacing", "1", 1.02, "of the pivots, in diameters"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m", 1000000.0, "effect contact_0, stiffness of power"),
    ("restitution", "1", 1, "effect contact_0, coefficient of restitution of exact"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("start_angle", "deg", -30, "of the first string, from hanging"),
)

LIMITS = (
    ("radius", "defined", 0, None, True, False, "pair contact_0, first radius"),
    ("stiffness", "defined", 0, None, True, False, "effect contact_0, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect contact_0, coefficient of restitution of exact"),
    ("approach_floor", "defined", 0, None, True, False, "effect contact_0, approach floor"),
    ("length", "defined", 0, None, True, False, "scales, arm"),
)

COORDINATES = (
    ("string_0.angle", "rad"), ("string_1.angle", "rad"), ("string_2.angle", "rad"), ("string_3.angle", "rad"), ("string_4.angle", "rad"),
)

SPEEDS = (
    ("string_0.speed", "rad/s"), ("string_1.speed", "rad/s"), ("string_2.speed", "rad/s"), ("string_3.speed", "rad/s"),
    ("string_4.speed", "rad/s"),
)

MEMORY = (("contact_0.dissipated", "J"), ("contact_1.dissipated", "J"), ("contact_2.dissipated", "J"), ("contact_3.dissipated", "J"))

LATCHES = (
    ("contact_0.approach_speed", "m/s", 0), ("contact_1.approach_speed", "m/s", 1), ("contact_2.approach_speed", "m/s", 2),
    ("contact_3.approach_speed", "m/s", 3),
)

PAIRS = (
    ("contact_0", "sphere_on_sphere"), ("contact_1", "sphere_on_sphere"), ("contact_2", "sphere_on_sphere"),
    ("contact_3", "sphere_on_sphere"),
)

RELEASES = ("force", "force", "force", "force")

DISSIPATED = (0, 1, 2, 3)

OUTPUTS = (("contact_0.gap", "m"), ("contact_1.gap", "m"), ("contact_2.gap", "m"), ("contact_3.gap", "m"))

BODIES = ("ball_0", "ball_1", "ball_2", "ball_3", "ball_4")

LANDMARKS = (
    ("string_0", "revolute", "parent", "ground", ("axis",)), ("string_0", "revolute", "child", "ball_0", ("axis",)),
    ("string_1", "revolute", "parent", "ground", ("axis",)), ("string_1", "revolute", "child", "ball_1", ("axis",)),
    ("string_2", "revolute", "parent", "ground", ("axis",)), ("string_2", "revolute", "child", "ball_2", ("axis",)),
    ("string_3", "revolute", "parent", "ground", ("axis",)), ("string_3", "revolute", "child", "ball_3", ("axis",)),
    ("string_4", "revolute", "parent", "ground", ("axis",)), ("string_4", "revolute", "child", "ball_4", ("axis",)),
    ("contact_0", "sphere_on_sphere", "first", "ball_0", ("radius",)), ("contact_0", "sphere_on_sphere", "second", "ball_1", ("radius",)),
    ("contact_1", "sphere_on_sphere", "first", "ball_1", ("radius",)), ("contact_1", "sphere_on_sphere", "second", "ball_2", ("radius",)),
    ("contact_2", "sphere_on_sphere", "first", "ball_2", ("radius",)), ("contact_2", "sphere_on_sphere", "second", "ball_3", ("radius",)),
    ("contact_3", "sphere_on_sphere", "first", "ball_3", ("radius",)), ("contact_3", "sphere_on_sphere", "second", "ball_4", ("radius",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("ball_0", "body", "centre", "ball_0", ()),
    ("ball_1", "body", "centre", "ball_1", ()), ("ball_2", "body", "centre", "ball_2", ()), ("ball_3", "body", "centre", "ball_3", ()),
    ("ball_4", "body", "centre", "ball_4", ()),
)

CONSTANTS = (
    ("length", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m"), ("ball_1_arm_x", "m"), ("ball_2_arm_x", "m"),
    ("ball_1_arm_x_minus_ball_2_arm_x", "m"), ("ball_3_arm_x", "m"), ("ball_2_arm_x_minus_ball_3_arm_x", "m"), ("ball_4_arm_x", "m"),
    ("ball_3_arm_x_minus_ball_4_arm_x", "m"), ("contact_0_reach", "m"), ("minus_contact_0_reach_squared", "m^2"),
    ("half_inverse_contact_0_reach", "1/m"), ("half_stiffness", "N/m"), ("contact_0_hysteresis_factor", "1"), ("ball_0_h_y", "kg m"),
    ("inverse_ball_0_I_z_z", "1/(kg m^2)"), ("half_ball_0_I_z_z", "kg m^2"), ("k9", "N"),
)

OPERATIONS = (
    ("constants", 191), ("start", 0), ("scales", 43), ("coordinate_rates", 0), ("gaps", 104), ("gap_accelerations", 164),
    ("contact_contact_0", 47), ("contact_contact_1", 47), ("contact_contact_2", 47), ("contact_contact_3", 47), ("applied", 25),
    ("accelerations", 5), ("ledger", 0), ("energy", 101), ("poses", 15), ("outputs", 61), ("landmarks", 21),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = ()
SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def sphere_on_sphere_contact(arm_x, apart_x, x1, first_angle, second_angle, first_speed, second_speed, approach_speed, length, stiffness,
        reach, hysteresis_factor):
    """Return normal_force [N], normal_power [W], first_push_on [N m], second_push_on [N m]."""
    first_cos = ca.cos(first_angle)
    second_cos = ca.cos(second_angle)
    first_arm_y = -first_cos*length
    second_arm_y = -second_cos*length
    apart_y = first_arm_y - second_arm_y
    apart_squared = apart_x*apart_x + apart_y*apart_y
    distance = ca.sqrt(apart_squared)
    penetration = reach - distance
    elastic_force = ca.if_else(penetration > 0, stiffness*penetration, 0)
    normal_x = apart_x/distance
    normal_y = apart_y/distance
    relative_rate_x = second_speed*first_arm_y - first_speed*first_arm_y
    relative_rate_y = first_speed*arm_x - second_speed*x1
    penetration_rate = -normal_x*relative_rate_x - relative_rate_y*normal_y
    resistance = hysteresis_factor*elastic_force*penetration_rate/approach_speed
    normal_force = resistance + elastic_force
    normal_power = resistance*penetration_rate
    push_x = normal_force*normal_x
    push_y = normal_force*normal_y
    first_push_on = arm_x*push_y - push_x*first_arm_y
    second_push_on = push_x*first_arm_y - x1*push_y
    return normal_force, normal_power, first_push_on, second_push_on


def sphere_on_sphere_arm(angle, speed, length):
    """Return arm_x [m], arm_y [m], arm_rate_x [m/s], arm_rate_y [m/s]."""
    cos = ca.cos(angle)
    sin = ca.sin(angle)
    arm_x = length*sin
    arm_y = -cos*length
    arm_rate_x = -arm_y*speed
    arm_rate_y = speed*arm_x
    return arm_x, arm_y, arm_rate_x, arm_rate_y


def sphere_on_sphere_arm_2(angle, length):
    """Return arm_x [m], arm_y [m]."""
    cos = ca.cos(angle)
    sin = ca.sin(angle)
    arm_x = length*sin
    arm_y = -cos*length
    return arm_x, arm_y


def sphere_on_sphere_gap(first_arm_y, first_arm_rate_x, first_arm_rate_y, second_arm_y, second_arm_rate_x, second_arm_rate_y, apart_x,
        minus_reach_squared, half_inverse_reach):
    """Return gap [m], gap_rate [m/s]."""
    apart_y = first_arm_y - second_arm_y
    apart_rate_x = first_arm_rate_x - second_arm_rate_x
    apart_rate_y = first_arm_rate_y - second_arm_rate_y
    apart_squared = apart_x*apart_x + apart_y*apart_y
    gap = half_inverse_reach*(minus_reach_squared + apart_squared)
    apart_squared_rate = 2*apart_rate_x*apart_x + 2*apart_rate_y*apart_y
    gap_rate = half_inverse_reach*apart_squared_rate
    return gap, gap_rate


def sphere_on_sphere_gap_rate_rate(first_arm_x, first_arm_y, first_arm_rate_x, first_arm_rate_y, second_arm_x, second_arm_y,
        second_arm_rate_x, second_arm_rate_y, apart_x, first_speed, second_speed, first_acceleration, second_acceleration,
        half_inverse_reach):
    """Return gap_rate_rate [m/s^2]."""
    apart_y = first_arm_y - second_arm_y
    apart_rate_x = first_arm_rate_x - second_arm_rate_x
    apart_rate_y = first_arm_rate_y - second_arm_rate_y
    apart_acceleration_x = second_speed*second_arm_rate_y + second_acceleration*second_arm_y - first_speed*first_arm_rate_y - first_acceleration*first_arm_y
    apart_acceleration_y = first_speed*first_arm_rate_x + first_acceleration*first_arm_x - second_speed*second_arm_rate_x - second_acceleration*second_arm_x
    apart_squared_rate_rate = 2*apart_rate_x*apart_rate_x + 2*apart_rate_y*apart_rate_y + 2*apart_acceleration_x*apart_x + 2*apart_acceleration_y*apart_y
    return half_inverse_reach*apart_squared_rate_rate


def sphere_on_sphere_penetration(first_arm_x, first_arm_y, second_arm_x, second_arm_y, arm_x_minus_arm_x, reach):
    """Return penetration [m]."""
    apart_x = arm_x_minus_arm_x + first_arm_x - second_arm_x
    apart_y = first_arm_y - second_arm_y
    apart_squared = apart_x*apart_x + apart_y*apart_y
    distance = ca.sqrt(apart_squared)
    return reach - distance


def sphere_on_sphere_contact_terms(first_angle, second_angle, length, arm_x_minus_arm_x):
    """Return first_arm_x [m], apart_x [m], x1."""
    first_sin = ca.sin(first_angle)
    second_sin = ca.sin(second_angle)
    first_arm_x = length*first_sin
    second_arm_x = length*second_sin
    apart_x = arm_x_minus_arm_x + first_arm_x - second_arm_x
    x1 = arm_x_minus_arm_x + first_arm_x
    return first_arm_x, apart_x, x1


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (19,): length, gravity, stiffness, ball_1_arm_x, ball_2_arm_x, ball_1_arm_x_minus_ball_2_arm_x, ball_3_arm_x,
            ball_2_arm_x_minus_ball_3_arm_x, ball_4_arm_x, ball_3_arm_x_minus_ball_4_arm_x, contact_0_reach, minus_contact_0_reach_squared,
            half_inverse_contact_0_reach, half_stiffness, contact_0_hysteresis_factor, ball_0_h_y, inverse_ball_0_I_z_z, half_ball_0_I_z_z,
            k9
    """
    radius, density, length, spacing, gravity, stiffness, restitution = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    ball_1_arm_x = 2*radius*spacing
    ball_2_arm_x = 4*radius*spacing
    ball_1_arm_x_minus_ball_2_arm_x = ball_1_arm_x - ball_2_arm_x
    ball_3_arm_x = 6*radius*spacing
    ball_2_arm_x_minus_ball_3_arm_x = ball_2_arm_x - ball_3_arm_x
    ball_4_arm_x = 8*radius*spacing
    ball_3_arm_x_minus_ball_4_arm_x = ball_3_arm_x - ball_4_arm_x
    contact_0_reach = 2*radius
    minus_contact_0_reach_squared = -contact_0_reach*contact_0_reach
    half_inverse_contact_0_reach = 1/(2*contact_0_reach)
    half_stiffness = stiffness/2
    one_plus_restitution = 1 + restitution
    contact_0_y = (1 - restitution)/one_plus_restitution
    contact_0_r = 2*restitution/one_plus_restitution
    contact_0_t_0 = contact_0_y*(3 + 2*contact_0_y**6/5 - 6*contact_0_y*contact_0_y/5 - contact_0_y**4/5)/(contact_0_r*(1 + contact_0_y))
    contact_0_t_0_to_the_6 = contact_0_t_0**6
    contact_0_t_0_to_the_4 = contact_0_t_0**4
    contact_0_t_0_squared = contact_0_t_0*contact_0_t_0
    contact_0_q_0 = (34459425 + contact_0_t_0**8 + 990*contact_0_t_0_to_the_6 + 135135*contact_0_t_0_to_the_4 + 4729725*contact_0_t_0_squared)/(11486475 + 44*contact_0_t_0_to_the_6 + 12870*contact_0_t_0_to_the_4 + 810810*contact_0_t_0_squared)
    contact_0_w_0 = 1/ca.fmax(1, contact_0_t_0)
    contact_0_c_0 = 2/(ca.exp(2/contact_0_w_0) - 1)
    contact_0_t_1 = contact_0_t_0 + ca.if_else(contact_0_t_0 < 1, (contact_0_y - contact_0_t_0/contact_0_q_0)/(1 - 2/contact_0_q_0 - contact_0_t_0_squared/(contact_0_q_0*contact_0_q_0)), (contact_0_w_0 - contact_0_c_0 - contact_0_r)/(contact_0_w_0*contact_0_w_0 - contact_0_c_0*(2 + contact_0_c_0)))
    contact_0_t_1_to_the_6 = contact_0_t_1**6
    contact_0_t_1_to_the_4 = contact_0_t_1**4
    contact_0_t_1_squared = contact_0_t_1*contact_0_t_1
    contact_0_q_1 = (34459425 + contact_0_t_1**8 + 990*contact_0_t_1_to_the_6 + 135135*contact_0_t_1_to_the_4 + 4729725*contact_0_t_1_squared)/(11486475 + 44*contact_0_t_1_to_the_6 + 12870*contact_0_t_1_to_the_4 + 810810*contact_0_t_1_squared)
    contact_0_w_1 = 1/ca.fmax(1, contact_0_t_1)
    contact_0_c_1 = 2/(ca.exp(2/contact_0_w_1) - 1)
    contact_0_t_2 = contact_0_t_1 + ca.if_else(contact_0_t_1 < 1, (contact_0_y - contact_0_t_1/contact_0_q_1)/(1 - 2/contact_0_q_1 - contact_0_t_1_squared/(contact_0_q_1*contact_0_q_1)), (contact_0_w_1 - contact_0_c_1 - contact_0_r)/(contact_0_w_1*contact_0_w_1 - contact_0_c_1*(2 + contact_0_c_1)))
    contact_0_t_2_to_the_6 = contact_0_t_2**6
    contact_0_t_2_to_the_4 = contact_0_t_2**4
    contact_0_t_2_squared = contact_0_t_2*contact_0_t_2
    contact_0_q_2 = (34459425 + contact_0_t_2**8 + 990*contact_0_t_2_to_the_6 + 135135*contact_0_t_2_to_the_4 + 4729725*contact_0_t_2_squared)/(11486475 + 44*contact_0_t_2_to_the_6 + 12870*contact_0_t_2_to_the_4 + 810810*contact_0_t_2_squared)
    contact_0_w_2 = 1/ca.fmax(1, contact_0_t_2)
    contact_0_c_2 = 2/(ca.exp(2/contact_0_w_2) - 1)
    contact_0_t_3 = contact_0_t_2 + ca.if_else(contact_0_t_2 < 1, (contact_0_y - contact_0_t_2/contact_0_q_2)/(1 - 2/contact_0_q_2 - contact_0_t_2_squared/(contact_0_q_2*contact_0_q_2)), (contact_0_w_2 - contact_0_c_2 - contact_0_r)/(contact_0_w_2*contact_0_w_2 - contact_0_c_2*(2 + contact_0_c_2)))
    contact_0_hysteresis_factor = 2*contact_0_t_3/one_plus_restitution
    radius_cubed = radius*radius*radius
    ball_0_h_y = -4*3.141592653589793*radius_cubed*density*length/3
    ball_0_I_z_z = 8*3.141592653589793*radius**5*density/15 + 4*3.141592653589793*radius_cubed*length*length*density/3
    inverse_ball_0_I_z_z = 1/ball_0_I_z_z
    half_ball_0_I_z_z = ball_0_I_z_z/2
    k9 = 4*3.141592653589793*radius_cubed*density*gravity/3
    return ca.vertcat(length, gravity, stiffness, ball_1_arm_x, ball_2_arm_x, ball_1_arm_x_minus_ball_2_arm_x, ball_3_arm_x,
        ball_2_arm_x_minus_ball_3_arm_x, ball_4_arm_x, ball_3_arm_x_minus_ball_4_arm_x, contact_0_reach, minus_contact_0_reach_squared,
        half_inverse_contact_0_reach, half_stiffness, contact_0_hysteresis_factor, ball_0_h_y, inverse_ball_0_I_z_z, half_ball_0_I_z_z, k9)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (5,): COORDINATES
        u (5,): SPEEDS
    """
    start_angle = p[8]
    return ca.vertcat(start_angle, 0, 0, 0, 0), ca.vertcat(*[0]*5)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (5,): COORDINATES
        su (5,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    radius, density, length, gravity, stiffness, start_angle = p[0], p[1], p[2], p[4], p[5], p[8]
    radius_cubed = radius*radius*radius
    total_mass = 20*3.141592653589793*radius_cubed*density/3
    cos_start_angle = ca.cos(start_angle)
    minus_cos_start_angle = -cos_start_angle
    x4 = 1 + minus_cos_start_angle
    energy_scale = total_mass*x4*gravity*length
    sqrt_3 = ca.sqrt(3)
    radius_cubed_times_density_over_stiffness = radius_cubed*density/stiffness
    x7 = x4*gravity*length
    force_scale = energy_scale*sqrt_3/(2*ca.sqrt(3.141592653589793)*ca.sqrt(radius_cubed_times_density_over_stiffness)*ca.sqrt(x7))
    sqrt_pi = ca.sqrt(3.141592653589793)
    x9 = ca.sqrt(radius_cubed_times_density_over_stiffness)
    x10 = ca.sqrt(x7)
    x11 = 2*x10*sqrt_3*sqrt_pi*x9/(3*length)
    sqrt_2 = ca.sqrt(2)
    x13 = x10*sqrt_2/length
    return (ca.vertcat(*[x11]*5), ca.vertcat(*[x13]*5), ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(2*x10*sqrt_3*sqrt_pi*x9/3, x10*sqrt_2, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (5,): COORDINATES [rad/s]
    """
    string_0_speed, string_1_speed, string_2_speed, string_3_speed, string_4_speed = u[0], u[1], u[2], u[3], u[4]
    return ca.vertcat(string_0_speed, string_1_speed, string_2_speed, string_3_speed, string_4_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (4,): PAIRS [m]
        dG (4,): PAIRS [m/s]
    """
    length, ball_1_arm_x, ball_1_arm_x_minus_ball_2_arm_x, ball_2_arm_x_minus_ball_3_arm_x = c[0], c[3], c[5], c[7]
    ball_3_arm_x_minus_ball_4_arm_x, minus_contact_0_reach_squared, half_inverse_contact_0_reach = c[9], c[11], c[12]
    contact_0_first_arm_x, contact_0_first_arm_y, contact_0_first_arm_rate_x, contact_0_first_arm_rate_y = sphere_on_sphere_arm(q[0], u[0], length)
    contact_0_second_arm_x, contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y = sphere_on_sphere_arm(q[1], u[1], length)
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_1_second_arm_x, contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y = sphere_on_sphere_arm(q[2], u[2], length)
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_2_second_arm_x, contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y = sphere_on_sphere_arm(q[3], u[3], length)
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_3_second_arm_x, contact_3_second_arm_y, contact_3_second_arm_rate_x, contact_3_second_arm_rate_y = sphere_on_sphere_arm(q[4], u[4], length)
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_0_gap, contact_0_gap_rate = sphere_on_sphere_gap(contact_0_first_arm_y, contact_0_first_arm_rate_x, contact_0_first_arm_rate_y, contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y, contact_0_apart_x, minus_contact_0_reach_squared, half_inverse_contact_0_reach)
    contact_1_gap, contact_1_gap_rate = sphere_on_sphere_gap(contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y, contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y, contact_1_apart_x, minus_contact_0_reach_squared, half_inverse_contact_0_reach)
    contact_2_gap, contact_2_gap_rate = sphere_on_sphere_gap(contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y, contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y, contact_2_apart_x, minus_contact_0_reach_squared, half_inverse_contact_0_reach)
    contact_3_gap, contact_3_gap_rate = sphere_on_sphere_gap(contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y, contact_3_second_arm_y, contact_3_second_arm_rate_x, contact_3_second_arm_rate_y, contact_3_apart_x, minus_contact_0_reach_squared, half_inverse_contact_0_reach)
    return (ca.vertcat(contact_0_gap, contact_1_gap, contact_2_gap, contact_3_gap),
        ca.vertcat(contact_0_gap_rate, contact_1_gap_rate, contact_2_gap_rate, contact_3_gap_rate))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (4,): PAIRS [m/s^2]
    """
    length, ball_1_arm_x, ball_1_arm_x_minus_ball_2_arm_x, ball_2_arm_x_minus_ball_3_arm_x = c[0], c[3], c[5], c[7]
    ball_3_arm_x_minus_ball_4_arm_x, half_inverse_contact_0_reach = c[9], c[12]
    string_0_speed, string_1_speed, string_2_speed, string_3_speed, string_4_speed = u[0], u[1], u[2], u[3], u[4]
    string_1_acceleration, string_2_acceleration, string_3_acceleration = a[1], a[2], a[3]
    contact_0_first_arm_x, contact_0_first_arm_y, contact_0_first_arm_rate_x, contact_0_first_arm_rate_y = sphere_on_sphere_arm(q[0], string_0_speed, length)
    contact_0_second_arm_x, contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y = sphere_on_sphere_arm(q[1], string_1_speed, length)
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_1_second_arm_x, contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y = sphere_on_sphere_arm(q[2], string_2_speed, length)
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_2_second_arm_x, contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y = sphere_on_sphere_arm(q[3], string_3_speed, length)
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_3_second_arm_x, contact_3_second_arm_y, contact_3_second_arm_rate_x, contact_3_second_arm_rate_y = sphere_on_sphere_arm(q[4], string_4_speed, length)
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_0_gap_rate_rate = sphere_on_sphere_gap_rate_rate(contact_0_first_arm_x, contact_0_first_arm_y, contact_0_first_arm_rate_x, contact_0_first_arm_rate_y, contact_0_second_arm_x, contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y, contact_0_apart_x, string_0_speed, string_1_speed, a[0], string_1_acceleration, half_inverse_contact_0_reach)
    contact_1_gap_rate_rate = sphere_on_sphere_gap_rate_rate(contact_0_second_arm_x, contact_0_second_arm_y, contact_0_second_arm_rate_x, contact_0_second_arm_rate_y, contact_1_second_arm_x, contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y, contact_1_apart_x, string_1_speed, string_2_speed, string_1_acceleration, string_2_acceleration, half_inverse_contact_0_reach)
    contact_2_gap_rate_rate = sphere_on_sphere_gap_rate_rate(contact_1_second_arm_x, contact_1_second_arm_y, contact_1_second_arm_rate_x, contact_1_second_arm_rate_y, contact_2_second_arm_x, contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y, contact_2_apart_x, string_2_speed, string_3_speed, string_2_acceleration, string_3_acceleration, half_inverse_contact_0_reach)
    contact_3_gap_rate_rate = sphere_on_sphere_gap_rate_rate(contact_2_second_arm_x, contact_2_second_arm_y, contact_2_second_arm_rate_x, contact_2_second_arm_rate_y, contact_3_second_arm_x, contact_3_second_arm_y, contact_3_second_arm_rate_x, contact_3_second_arm_rate_y, contact_3_apart_x, string_3_speed, string_4_speed, string_3_acceleration, a[4], half_inverse_contact_0_reach)
    return ca.vertcat(contact_0_gap_rate_rate, contact_1_gap_rate_rate, contact_2_gap_rate_rate, contact_3_gap_rate_rate)


def contact_contact_0(t, q, u, z, m, c):
    """Forces of contact_0: power x exact. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
        dz (4,): MEMORY [W]
        normal_force (1,): contact_0 [N]
        sliding_velocity (0,): empty
        in_range (1,): contact_0 [1]
    """
    length, ball_1_arm_x = c[0], c[3]
    string_0_angle, string_1_angle = q[0], q[1]
    sin_ball_0 = ca.sin(string_0_angle)
    sin_ball_1 = ca.sin(string_1_angle)
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_first_arm_x_minus_ball_1_arm_x = contact_0_first_arm_x - ball_1_arm_x
    normal_force, normal_power, first_push_on, second_push_on = sphere_on_sphere_contact(contact_0_first_arm_x, contact_0_apart_x, contact_0_first_arm_x_minus_ball_1_arm_x, string_0_angle, string_1_angle, u[0], u[1], m[0], length, c[2], c[10], c[14])
    return (ca.vertcat(first_push_on, second_push_on, 0, 0, 0), ca.vertcat(normal_power, 0, 0, 0), ca.vertcat(normal_force), ca.vertcat(),
        ca.vertcat(1))


def contact_contact_1(t, q, u, z, m, c):
    """Forces of contact_1: power x exact; arguments and returns as of contact_contact_0."""
    length = c[0]
    string_1_angle, string_2_angle = q[1], q[2]
    first_arm_x, apart_x, x1 = sphere_on_sphere_contact_terms(string_1_angle, string_2_angle, length, c[5])
    normal_force, normal_power, first_push_on, second_push_on = sphere_on_sphere_contact(first_arm_x, apart_x, x1, string_1_angle, string_2_angle, u[1], u[2], m[1], length, c[2], c[10], c[14])
    return (ca.vertcat(0, first_push_on, second_push_on, 0, 0), ca.vertcat(0, normal_power, 0, 0), ca.vertcat(normal_force), ca.vertcat(),
        ca.vertcat(1))


def contact_contact_2(t, q, u, z, m, c):
    """Forces of contact_2: power x exact; arguments and returns as of contact_contact_0."""
    length = c[0]
    string_2_angle, string_3_angle = q[2], q[3]
    first_arm_x, apart_x, x1 = sphere_on_sphere_contact_terms(string_2_angle, string_3_angle, length, c[7])
    normal_force, normal_power, first_push_on, second_push_on = sphere_on_sphere_contact(first_arm_x, apart_x, x1, string_2_angle, string_3_angle, u[2], u[3], m[2], length, c[2], c[10], c[14])
    return (ca.vertcat(0, 0, first_push_on, second_push_on, 0), ca.vertcat(0, 0, normal_power, 0), ca.vertcat(normal_force), ca.vertcat(),
        ca.vertcat(1))


def contact_contact_3(t, q, u, z, m, c):
    """Forces of contact_3: power x exact; arguments and returns as of contact_contact_0."""
    length = c[0]
    string_3_angle, string_4_angle = q[3], q[4]
    first_arm_x, apart_x, x1 = sphere_on_sphere_contact_terms(string_3_angle, string_4_angle, length, c[9])
    normal_force, normal_power, first_push_on, second_push_on = sphere_on_sphere_contact(first_arm_x, apart_x, x1, string_3_angle, string_4_angle, u[3], u[4], m[3], length, c[2], c[10], c[14])
    return (ca.vertcat(0, 0, 0, first_push_on, second_push_on), ca.vertcat(0, 0, 0, normal_power), ca.vertcat(normal_force), ca.vertcat(),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
    """
    gravity, ball_0_h_y = c[1], c[15]
    string_0_angle, string_1_angle, string_2_angle, string_3_angle, string_4_angle = q[0], q[1], q[2], q[3], q[4]
    sin_ball_0 = ca.sin(string_0_angle)
    sin_ball_1 = ca.sin(string_1_angle)
    sin_ball_2 = ca.sin(string_2_angle)
    sin_ball_3 = ca.sin(string_3_angle)
    sin_ball_4 = ca.sin(string_4_angle)
    ball_0_moment_x = -ball_0_h_y*sin_ball_0
    ball_1_moment_x = -ball_0_h_y*sin_ball_1
    ball_2_moment_x = -ball_0_h_y*sin_ball_2
    ball_3_moment_x = -ball_0_h_y*sin_ball_3
    ball_4_moment_x = -ball_0_h_y*sin_ball_4
    return ca.vertcat(-ball_0_moment_x*gravity, -ball_1_moment_x*gravity, -ball_2_moment_x*gravity, -ball_3_moment_x*gravity,
        -ball_4_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): string_0.acceleration [rad/s^2], string_1.acceleration [rad/s^2], string_2.acceleration [rad/s^2], string_3.acceleration
            [rad/s^2], string_4.acceleration [rad/s^2]
        reactions (0,): empty
    """
    inverse_ball_0_I_z_z = c[16]
    string_0_force, string_1_force, string_2_force, string_3_force, string_4_force = f[0], f[1], f[2], f[3], f[4]
    string_0_acc = inverse_ball_0_I_z_z*string_0_force
    string_1_acc = inverse_ball_0_I_z_z*string_1_force
    string_2_acc = inverse_ball_0_I_z_z*string_2_force
    string_3_acc = inverse_ball_0_I_z_z*string_3_force
    string_4_acc = inverse_ball_0_I_z_z*string_4_force
    return ca.vertcat(string_0_acc, string_1_acc, string_2_acc, string_3_acc, string_4_acc), ca.vertcat()


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    return ca.vertcat(0, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (4,): PAIRS [J]
    """
    length, ball_1_arm_x, contact_0_reach, half_stiffness, half_ball_0_I_z_z, k9 = c[0], c[3], c[10], c[13], c[17], c[18]
    string_0_speed, string_1_speed, string_2_speed, string_3_speed, string_4_speed = u[0], u[1], u[2], u[3], u[4]
    contact_0_first_arm_x, contact_0_first_arm_y = sphere_on_sphere_arm_2(q[0], length)
    contact_0_second_arm_x, contact_0_second_arm_y = sphere_on_sphere_arm_2(q[1], length)
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_1_second_arm_x, contact_1_second_arm_y = sphere_on_sphere_arm_2(q[2], length)
    contact_2_second_arm_x, contact_2_second_arm_y = sphere_on_sphere_arm_2(q[3], length)
    contact_3_second_arm_x, contact_3_second_arm_y = sphere_on_sphere_arm_2(q[4], length)
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_0_distance = ca.sqrt(contact_0_apart_squared)
    contact_0_penetration = contact_0_reach - contact_0_distance
    contact_0_stored_energy = ca.if_else(contact_0_penetration > 0, half_stiffness*contact_0_penetration*contact_0_penetration, 0)
    contact_1_penetration = sphere_on_sphere_penetration(contact_0_second_arm_x, contact_0_second_arm_y, contact_1_second_arm_x, contact_1_second_arm_y, c[5], contact_0_reach)
    contact_1_stored_energy = ca.if_else(contact_1_penetration > 0, half_stiffness*contact_1_penetration*contact_1_penetration, 0)
    contact_2_penetration = sphere_on_sphere_penetration(contact_1_second_arm_x, contact_1_second_arm_y, contact_2_second_arm_x, contact_2_second_arm_y, c[7], contact_0_reach)
    contact_2_stored_energy = ca.if_else(contact_2_penetration > 0, half_stiffness*contact_2_penetration*contact_2_penetration, 0)
    contact_3_penetration = sphere_on_sphere_penetration(contact_2_second_arm_x, contact_2_second_arm_y, contact_3_second_arm_x, contact_3_second_arm_y, c[9], contact_0_reach)
    contact_3_stored_energy = ca.if_else(contact_3_penetration > 0, half_stiffness*contact_3_penetration*contact_3_penetration, 0)
    kinetic = half_ball_0_I_z_z*string_0_speed*string_0_speed + half_ball_0_I_z_z*string_1_speed*string_1_speed + half_ball_0_I_z_z*string_2_speed*string_2_speed + half_ball_0_I_z_z*string_3_speed*string_3_speed + half_ball_0_I_z_z*string_4_speed*string_4_speed
    potential = k9*(contact_0_first_arm_y + length) + k9*(contact_0_second_arm_y + length) + k9*(contact_1_second_arm_y + length) + k9*(contact_2_second_arm_y + length) + k9*(contact_3_second_arm_y + length)
    return (ca.vertcat(kinetic), ca.vertcat(potential),
        ca.vertcat(contact_0_stored_energy, contact_1_stored_energy, contact_2_stored_energy, contact_3_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (15,): ball_0.x [m], ball_0.y [m], ball_0.z [m], ball_1.x [m], ball_1.y [m], ball_1.z [m], ball_2.x [m], ball_2.y [m],
            ball_2.z [m], ball_3.x [m], ball_3.y [m], ball_3.z [m], ball_4.x [m], ball_4.y [m], ball_4.z [m]
        rotations (45,): ball_0.R_xx [1], ball_0.R_xy [1], ball_0.R_xz [1], ball_0.R_yx [1], ball_0.R_yy [1], ball_0.R_yz [1], ball_0.R_zx
            [1], ball_0.R_zy [1], ball_0.R_zz [1], ball_1.R_xx [1], ball_1.R_xy [1], ball_1.R_xz [1], ball_1.R_yx [1], ball_1.R_yy [1],
            ball_1.R_yz [1], ball_1.R_zx [1], ball_1.R_zy [1], ball_1.R_zz [1], ball_2.R_xx [1], ball_2.R_xy [1], ball_2.R_xz [1],
            ball_2.R_yx [1], ball_2.R_yy [1], ball_2.R_yz [1], ball_2.R_zx [1], ball_2.R_zy [1], ball_2.R_zz [1], ball_3.R_xx [1],
            ball_3.R_xy [1], ball_3.R_xz [1], ball_3.R_yx [1], ball_3.R_yy [1], ball_3.R_yz [1], ball_3.R_zx [1], ball_3.R_zy [1],
            ball_3.R_zz [1], ball_4.R_xx [1], ball_4.R_xy [1], ball_4.R_xz [1], ball_4.R_yx [1], ball_4.R_yy [1], ball_4.R_yz [1],
            ball_4.R_zx [1], ball_4.R_zy [1], ball_4.R_zz [1]
    """
    length, ball_1_arm_x, ball_2_arm_x, ball_3_arm_x, ball_4_arm_x = c[0], c[3], c[4], c[6], c[8]
    string_0_angle, string_1_angle, string_2_angle, string_3_angle, string_4_angle = q[0], q[1], q[2], q[3], q[4]
    cos_ball_0 = ca.cos(string_0_angle)
    sin_ball_0 = ca.sin(string_0_angle)
    cos_ball_1 = ca.cos(string_1_angle)
    sin_ball_1 = ca.sin(string_1_angle)
    cos_ball_2 = ca.cos(string_2_angle)
    sin_ball_2 = ca.sin(string_2_angle)
    cos_ball_3 = ca.cos(string_3_angle)
    sin_ball_3 = ca.sin(string_3_angle)
    cos_ball_4 = ca.cos(string_4_angle)
    sin_ball_4 = ca.sin(string_4_angle)
    return (ca.vertcat(0, length, 0, ball_1_arm_x, length, 0, ball_2_arm_x, length, 0, ball_3_arm_x, length, 0, ball_4_arm_x, length, 0),
        ca.vertcat(cos_ball_0, -sin_ball_0, 0, sin_ball_0, cos_ball_0, 0, 0, 0, 1, cos_ball_1, -sin_ball_1, 0, sin_ball_1, cos_ball_1, 0, 0,
            0, 1, cos_ball_2, -sin_ball_2, 0, sin_ball_2, cos_ball_2, 0, 0, 0, 1, cos_ball_3, -sin_ball_3, 0, sin_ball_3, cos_ball_3, 0, 0,
            0, 1, cos_ball_4, -sin_ball_4, 0, sin_ball_4, cos_ball_4, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): OUTPUTS
    """
    length, ball_1_arm_x, contact_0_reach = c[0], c[3], c[10]
    contact_0_first_arm_x, contact_0_first_arm_y = sphere_on_sphere_arm_2(q[0], length)
    contact_0_second_arm_x, contact_0_second_arm_y = sphere_on_sphere_arm_2(q[1], length)
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_1_second_arm_x, contact_1_second_arm_y = sphere_on_sphere_arm_2(q[2], length)
    contact_2_second_arm_x, contact_2_second_arm_y = sphere_on_sphere_arm_2(q[3], length)
    contact_3_second_arm_x, contact_3_second_arm_y = sphere_on_sphere_arm_2(q[4], length)
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_0_distance = ca.sqrt(contact_0_apart_squared)
    contact_0_penetration = contact_0_reach - contact_0_distance
    contact_1_penetration = sphere_on_sphere_penetration(contact_0_second_arm_x, contact_0_second_arm_y, contact_1_second_arm_x, contact_1_second_arm_y, c[5], contact_0_reach)
    contact_2_penetration = sphere_on_sphere_penetration(contact_1_second_arm_x, contact_1_second_arm_y, contact_2_second_arm_x, contact_2_second_arm_y, c[7], contact_0_reach)
    contact_3_penetration = sphere_on_sphere_penetration(contact_2_second_arm_x, contact_2_second_arm_y, contact_3_second_arm_x, contact_3_second_arm_y, c[9], contact_0_reach)
    return ca.vertcat(-contact_0_penetration, -contact_1_penetration, -contact_2_penetration, -contact_3_penetration)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        string_0.parent to string_4.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        contact_0.first to contact_3.second (4,): x [m], y [m], z [m], radius [m]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball_0.centre to ball_4.centre (3,): x [m], y [m], z [m]
    """
    radius, length, spacing = p[0], p[2], p[3]
    return (ca.vertcat(0, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(2*radius*spacing, length, 0, 0, 0, 1), ca.vertcat(*[0]*5,
            1),
        ca.vertcat(4*radius*spacing, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(6*radius*spacing, length, 0, 0, 0, 1),
        ca.vertcat(*[0]*5, 1), ca.vertcat(8*radius*spacing, length, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        *[ca.vertcat(0, -length, 0, radius)]*8, ca.vertcat(0, 0, 0, 0, -1, 0), *[ca.vertcat(0, -length, 0)]*5)
