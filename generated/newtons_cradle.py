"""newtons_cradle: Newton's cradle. Generated from derive/scenes/newtons_cradle.py.

Do not edit; regenerate with `hertzwerk derive newtons_cradle`.
Effects:
    gravity: uniform gravity
    contact_0: power x exact
    contact_1: power x exact
    contact_2: power x exact
    contact_3: power x exact
    energy_ledger: work put in, energy dissipated per effect
Units: 189 assignments and 305 outputs checked, all consistent
Operations: flight 298 (equations of motion and gaps); in contact also contact_contact_0 47, contact_contact_1 47, contact_contact_2 47, contact_contact_3 47
"""

import casadi as ca

NAME = "newtons_cradle"
SOURCE = "derive/scenes/newtons_cradle.py"
SUMMARY = "Newton's cradle"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"),
    ("contact_0", "contact", "power x exact"),
    ("contact_1", "contact", "power x exact"),
    ("contact_2", "contact", "power x exact"),
    ("contact_3", "contact", "power x exact"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

UNCHECKED = ()

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
    ("string_0.angle", "rad"),
    ("string_1.angle", "rad"),
    ("string_2.angle", "rad"),
    ("string_3.angle", "rad"),
    ("string_4.angle", "rad"),
)

SPEEDS = (
    ("string_0.speed", "rad/s"),
    ("string_1.speed", "rad/s"),
    ("string_2.speed", "rad/s"),
    ("string_3.speed", "rad/s"),
    ("string_4.speed", "rad/s"),
)

MEMORY = (
    ("contact_0.dissipated", "J"),
    ("contact_1.dissipated", "J"),
    ("contact_2.dissipated", "J"),
    ("contact_3.dissipated", "J"),
)

LATCHES = (
    ("contact_0.approach_speed", "m/s", 0),
    ("contact_1.approach_speed", "m/s", 1),
    ("contact_2.approach_speed", "m/s", 2),
    ("contact_3.approach_speed", "m/s", 3),
)

PAIRS = (
    ("contact_0", "sphere_on_sphere"),
    ("contact_1", "sphere_on_sphere"),
    ("contact_2", "sphere_on_sphere"),
    ("contact_3", "sphere_on_sphere"),
)

RELEASES = (
    "force",
    "force",
    "force",
    "force",
)

DISSIPATED = (
    0,
    1,
    2,
    3,
)

OUTPUTS = (
    ("contact_0.gap", "m"),
    ("contact_1.gap", "m"),
    ("contact_2.gap", "m"),
    ("contact_3.gap", "m"),
)

BODIES = (
    "ball_0",
    "ball_1",
    "ball_2",
    "ball_3",
    "ball_4",
)

LANDMARKS = (
    ("string_0", "revolute", "parent", "ground", ("axis",)),
    ("string_0", "revolute", "child", "ball_0", ("axis",)),
    ("string_1", "revolute", "parent", "ground", ("axis",)),
    ("string_1", "revolute", "child", "ball_1", ("axis",)),
    ("string_2", "revolute", "parent", "ground", ("axis",)),
    ("string_2", "revolute", "child", "ball_2", ("axis",)),
    ("string_3", "revolute", "parent", "ground", ("axis",)),
    ("string_3", "revolute", "child", "ball_3", ("axis",)),
    ("string_4", "revolute", "parent", "ground", ("axis",)),
    ("string_4", "revolute", "child", "ball_4", ("axis",)),
    ("contact_0", "sphere_on_sphere", "first", "ball_0", ("radius",)),
    ("contact_0", "sphere_on_sphere", "second", "ball_1", ("radius",)),
    ("contact_1", "sphere_on_sphere", "first", "ball_1", ("radius",)),
    ("contact_1", "sphere_on_sphere", "second", "ball_2", ("radius",)),
    ("contact_2", "sphere_on_sphere", "first", "ball_2", ("radius",)),
    ("contact_2", "sphere_on_sphere", "second", "ball_3", ("radius",)),
    ("contact_3", "sphere_on_sphere", "first", "ball_3", ("radius",)),
    ("contact_3", "sphere_on_sphere", "second", "ball_4", ("radius",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("ball_0", "body", "centre", "ball_0", ()),
    ("ball_1", "body", "centre", "ball_1", ()),
    ("ball_2", "body", "centre", "ball_2", ()),
    ("ball_3", "body", "centre", "ball_3", ()),
    ("ball_4", "body", "centre", "ball_4", ()),
)

CONSTANTS = (
    ("length", "m"),
    ("gravity", "m/s^2"),
    ("stiffness", "N/m"),
    ("ball_1_arm_x", "m"),
    ("ball_2_arm_x", "m"),
    ("ball_1_arm_x_minus_ball_2_arm_x", "m"),
    ("ball_3_arm_x", "m"),
    ("ball_2_arm_x_minus_ball_3_arm_x", "m"),
    ("ball_4_arm_x", "m"),
    ("ball_3_arm_x_minus_ball_4_arm_x", "m"),
    ("contact_0_reach", "m"),
    ("minus_contact_0_reach_squared", "m^2"),
    ("half_inverse_contact_0_reach", "1/m"),
    ("half_stiffness", "N/m"),
    ("contact_0_hysteresis_factor", "1"),
    ("ball_0_h_y", "kg m"),
    ("inverse_ball_0_I_z_z", "1/(kg m^2)"),
    ("half_ball_0_I_z_z", "kg m^2"),
    ("k9", "N"),
)

OPERATIONS = (
    ("constants", 191),
    ("start", 0),
    ("scales", 43),
    ("coordinate_rates", 0),
    ("gaps", 104),
    ("gap_accelerations", 164),
    ("contact_contact_0", 47),
    ("contact_contact_1", 47),
    ("contact_contact_2", 47),
    ("contact_contact_3", 47),
    ("applied", 25),
    ("accelerations", 5),
    ("ledger", 0),
    ("energy", 101),
    ("poses", 15),
    ("outputs", 61),
    ("landmarks", 21),
)


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (19,): length, gravity, stiffness, ball_1_arm_x, ball_2_arm_x, ball_1_arm_x_minus_ball_2_arm_x,
            ball_3_arm_x, ball_2_arm_x_minus_ball_3_arm_x, ball_4_arm_x, ball_3_arm_x_minus_ball_4_arm_x,
            contact_0_reach, minus_contact_0_reach_squared, half_inverse_contact_0_reach, half_stiffness,
            contact_0_hysteresis_factor, ball_0_h_y, inverse_ball_0_I_z_z, half_ball_0_I_z_z, k9
    """
    radius = p[0]
    density = p[1]
    length = p[2]
    spacing = p[3]
    gravity = p[4]
    stiffness = p[5]
    restitution = p[6]
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
    return ca.vertcat(length, gravity, stiffness, ball_1_arm_x, ball_2_arm_x, ball_1_arm_x_minus_ball_2_arm_x,
        ball_3_arm_x, ball_2_arm_x_minus_ball_3_arm_x, ball_4_arm_x, ball_3_arm_x_minus_ball_4_arm_x,
        contact_0_reach, minus_contact_0_reach_squared, half_inverse_contact_0_reach, half_stiffness,
        contact_0_hysteresis_factor, ball_0_h_y, inverse_ball_0_I_z_z, half_ball_0_I_z_z, k9)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (5,): string_0.angle [rad], string_1.angle [rad], string_2.angle [rad], string_3.angle [rad],
            string_4.angle [rad]
        u (5,): string_0.speed [rad/s], string_1.speed [rad/s], string_2.speed [rad/s], string_3.speed [rad/s],
            string_4.speed [rad/s]
    """
    start_angle = p[8]
    return ca.vertcat(start_angle, 0, 0, 0, 0), ca.vertcat(0, 0, 0, 0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (5,): string_0.angle [rad], string_1.angle [rad], string_2.angle [rad], string_3.angle [rad],
            string_4.angle [rad]
        su (5,): string_0.speed [rad/s], string_1.speed [rad/s], string_2.speed [rad/s], string_3.speed [rad/s],
            string_4.speed [rad/s]
        sz (4,): contact_0.dissipated [J], contact_1.dissipated [J], contact_2.dissipated [J], contact_3.dissipated
            [J]
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    radius = p[0]
    density = p[1]
    length = p[2]
    gravity = p[4]
    stiffness = p[5]
    start_angle = p[8]
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
    return (
        ca.vertcat(x11, x11, x11, x11, x11),
        ca.vertcat(x13, x13, x13, x13, x13),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(2*x10*sqrt_3*sqrt_pi*x9/3, x10*sqrt_2, force_scale, energy_scale),
    )


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (5,): string_0.angle [rad/s], string_1.angle [rad/s], string_2.angle [rad/s], string_3.angle [rad/s],
            string_4.angle [rad/s]
    """
    string_0_speed = u[0]
    string_1_speed = u[1]
    string_2_speed = u[2]
    string_3_speed = u[3]
    string_4_speed = u[4]
    return ca.vertcat(string_0_speed, string_1_speed, string_2_speed, string_3_speed, string_4_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (4,): contact_0 [m], contact_1 [m], contact_2 [m], contact_3 [m]
        dG (4,): contact_0 [m/s], contact_1 [m/s], contact_2 [m/s], contact_3 [m/s]
    """
    length = c[0]
    ball_1_arm_x = c[3]
    ball_1_arm_x_minus_ball_2_arm_x = c[5]
    ball_2_arm_x_minus_ball_3_arm_x = c[7]
    ball_3_arm_x_minus_ball_4_arm_x = c[9]
    minus_contact_0_reach_squared = c[11]
    half_inverse_contact_0_reach = c[12]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
    string_0_speed = u[0]
    string_1_speed = u[1]
    string_2_speed = u[2]
    string_3_speed = u[3]
    string_4_speed = u[4]
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
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_first_arm_y = -cos_ball_0*length
    contact_0_first_arm_rate_x = -contact_0_first_arm_y*string_0_speed
    contact_0_first_arm_rate_y = contact_0_first_arm_x*string_0_speed
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_0_second_arm_rate_x = -contact_0_second_arm_y*string_1_speed
    contact_0_second_arm_rate_y = contact_0_second_arm_x*string_1_speed
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_0_apart_rate_x = contact_0_first_arm_rate_x - contact_0_second_arm_rate_x
    contact_0_apart_rate_y = contact_0_first_arm_rate_y - contact_0_second_arm_rate_y
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_1_second_arm_rate_x = -contact_1_second_arm_y*string_2_speed
    contact_1_second_arm_rate_y = contact_1_second_arm_x*string_2_speed
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_1_apart_y = contact_0_second_arm_y - contact_1_second_arm_y
    contact_1_apart_rate_x = contact_0_second_arm_rate_x - contact_1_second_arm_rate_x
    contact_1_apart_rate_y = contact_0_second_arm_rate_y - contact_1_second_arm_rate_y
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_2_second_arm_rate_x = -contact_2_second_arm_y*string_3_speed
    contact_2_second_arm_rate_y = contact_2_second_arm_x*string_3_speed
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_2_apart_y = contact_1_second_arm_y - contact_2_second_arm_y
    contact_2_apart_rate_x = contact_1_second_arm_rate_x - contact_2_second_arm_rate_x
    contact_2_apart_rate_y = contact_1_second_arm_rate_y - contact_2_second_arm_rate_y
    contact_3_second_arm_x = sin_ball_4*length
    contact_3_second_arm_y = -cos_ball_4*length
    contact_3_second_arm_rate_x = -contact_3_second_arm_y*string_4_speed
    contact_3_second_arm_rate_y = contact_3_second_arm_x*string_4_speed
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_3_apart_y = contact_2_second_arm_y - contact_3_second_arm_y
    contact_3_apart_rate_x = contact_2_second_arm_rate_x - contact_3_second_arm_rate_x
    contact_3_apart_rate_y = contact_2_second_arm_rate_y - contact_3_second_arm_rate_y
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_0_gap = half_inverse_contact_0_reach*(contact_0_apart_squared + minus_contact_0_reach_squared)
    contact_1_apart_squared = contact_1_apart_x*contact_1_apart_x + contact_1_apart_y*contact_1_apart_y
    contact_1_gap = half_inverse_contact_0_reach*(contact_1_apart_squared + minus_contact_0_reach_squared)
    contact_2_apart_squared = contact_2_apart_x*contact_2_apart_x + contact_2_apart_y*contact_2_apart_y
    contact_2_gap = half_inverse_contact_0_reach*(contact_2_apart_squared + minus_contact_0_reach_squared)
    contact_3_apart_squared = contact_3_apart_x*contact_3_apart_x + contact_3_apart_y*contact_3_apart_y
    contact_3_gap = half_inverse_contact_0_reach*(contact_3_apart_squared + minus_contact_0_reach_squared)
    contact_0_apart_squared_rate = 2*contact_0_apart_rate_x*contact_0_apart_x + 2*contact_0_apart_rate_y*contact_0_apart_y
    contact_0_gap_rate = contact_0_apart_squared_rate*half_inverse_contact_0_reach
    contact_1_apart_squared_rate = 2*contact_1_apart_rate_x*contact_1_apart_x + 2*contact_1_apart_rate_y*contact_1_apart_y
    contact_1_gap_rate = contact_1_apart_squared_rate*half_inverse_contact_0_reach
    contact_2_apart_squared_rate = 2*contact_2_apart_rate_x*contact_2_apart_x + 2*contact_2_apart_rate_y*contact_2_apart_y
    contact_2_gap_rate = contact_2_apart_squared_rate*half_inverse_contact_0_reach
    contact_3_apart_squared_rate = 2*contact_3_apart_rate_x*contact_3_apart_x + 2*contact_3_apart_rate_y*contact_3_apart_y
    contact_3_gap_rate = contact_3_apart_squared_rate*half_inverse_contact_0_reach
    return (
        ca.vertcat(contact_0_gap, contact_1_gap, contact_2_gap, contact_3_gap),
        ca.vertcat(contact_0_gap_rate, contact_1_gap_rate, contact_2_gap_rate, contact_3_gap_rate),
    )


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (4,): contact_0 [m/s^2], contact_1 [m/s^2], contact_2 [m/s^2], contact_3 [m/s^2]
    """
    length = c[0]
    ball_1_arm_x = c[3]
    ball_1_arm_x_minus_ball_2_arm_x = c[5]
    ball_2_arm_x_minus_ball_3_arm_x = c[7]
    ball_3_arm_x_minus_ball_4_arm_x = c[9]
    half_inverse_contact_0_reach = c[12]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
    string_0_speed = u[0]
    string_1_speed = u[1]
    string_2_speed = u[2]
    string_3_speed = u[3]
    string_4_speed = u[4]
    string_0_acceleration = a[0]
    string_1_acceleration = a[1]
    string_2_acceleration = a[2]
    string_3_acceleration = a[3]
    string_4_acceleration = a[4]
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
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_first_arm_y = -cos_ball_0*length
    contact_0_first_arm_rate_x = -contact_0_first_arm_y*string_0_speed
    contact_0_first_arm_rate_y = contact_0_first_arm_x*string_0_speed
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_0_second_arm_rate_x = -contact_0_second_arm_y*string_1_speed
    contact_0_second_arm_rate_y = contact_0_second_arm_x*string_1_speed
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_0_apart_rate_x = contact_0_first_arm_rate_x - contact_0_second_arm_rate_x
    contact_0_apart_rate_y = contact_0_first_arm_rate_y - contact_0_second_arm_rate_y
    contact_0_apart_acceleration_x = contact_0_second_arm_rate_y*string_1_speed + contact_0_second_arm_y*string_1_acceleration - contact_0_first_arm_rate_y*string_0_speed - contact_0_first_arm_y*string_0_acceleration
    contact_0_apart_acceleration_y = contact_0_first_arm_rate_x*string_0_speed + contact_0_first_arm_x*string_0_acceleration - contact_0_second_arm_rate_x*string_1_speed - contact_0_second_arm_x*string_1_acceleration
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_1_second_arm_rate_x = -contact_1_second_arm_y*string_2_speed
    contact_1_second_arm_rate_y = contact_1_second_arm_x*string_2_speed
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_1_apart_y = contact_0_second_arm_y - contact_1_second_arm_y
    contact_1_apart_rate_x = contact_0_second_arm_rate_x - contact_1_second_arm_rate_x
    contact_1_apart_rate_y = contact_0_second_arm_rate_y - contact_1_second_arm_rate_y
    contact_1_apart_acceleration_x = contact_1_second_arm_rate_y*string_2_speed + contact_1_second_arm_y*string_2_acceleration - contact_0_second_arm_rate_y*string_1_speed - contact_0_second_arm_y*string_1_acceleration
    contact_1_apart_acceleration_y = contact_0_second_arm_rate_x*string_1_speed + contact_0_second_arm_x*string_1_acceleration - contact_1_second_arm_rate_x*string_2_speed - contact_1_second_arm_x*string_2_acceleration
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_2_second_arm_rate_x = -contact_2_second_arm_y*string_3_speed
    contact_2_second_arm_rate_y = contact_2_second_arm_x*string_3_speed
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_2_apart_y = contact_1_second_arm_y - contact_2_second_arm_y
    contact_2_apart_rate_x = contact_1_second_arm_rate_x - contact_2_second_arm_rate_x
    contact_2_apart_rate_y = contact_1_second_arm_rate_y - contact_2_second_arm_rate_y
    contact_2_apart_acceleration_x = contact_2_second_arm_rate_y*string_3_speed + contact_2_second_arm_y*string_3_acceleration - contact_1_second_arm_rate_y*string_2_speed - contact_1_second_arm_y*string_2_acceleration
    contact_2_apart_acceleration_y = contact_1_second_arm_rate_x*string_2_speed + contact_1_second_arm_x*string_2_acceleration - contact_2_second_arm_rate_x*string_3_speed - contact_2_second_arm_x*string_3_acceleration
    contact_3_second_arm_x = sin_ball_4*length
    contact_3_second_arm_y = -cos_ball_4*length
    contact_3_second_arm_rate_x = -contact_3_second_arm_y*string_4_speed
    contact_3_second_arm_rate_y = contact_3_second_arm_x*string_4_speed
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_3_apart_y = contact_2_second_arm_y - contact_3_second_arm_y
    contact_3_apart_rate_x = contact_2_second_arm_rate_x - contact_3_second_arm_rate_x
    contact_3_apart_rate_y = contact_2_second_arm_rate_y - contact_3_second_arm_rate_y
    contact_3_apart_acceleration_x = contact_3_second_arm_rate_y*string_4_speed + contact_3_second_arm_y*string_4_acceleration - contact_2_second_arm_rate_y*string_3_speed - contact_2_second_arm_y*string_3_acceleration
    contact_3_apart_acceleration_y = contact_2_second_arm_rate_x*string_3_speed + contact_2_second_arm_x*string_3_acceleration - contact_3_second_arm_rate_x*string_4_speed - contact_3_second_arm_x*string_4_acceleration
    contact_0_apart_squared_rate_rate = 2*contact_0_apart_rate_x*contact_0_apart_rate_x + 2*contact_0_apart_rate_y*contact_0_apart_rate_y + 2*contact_0_apart_acceleration_x*contact_0_apart_x + 2*contact_0_apart_acceleration_y*contact_0_apart_y
    contact_0_gap_rate_rate = contact_0_apart_squared_rate_rate*half_inverse_contact_0_reach
    contact_1_apart_squared_rate_rate = 2*contact_1_apart_rate_x*contact_1_apart_rate_x + 2*contact_1_apart_rate_y*contact_1_apart_rate_y + 2*contact_1_apart_acceleration_x*contact_1_apart_x + 2*contact_1_apart_acceleration_y*contact_1_apart_y
    contact_1_gap_rate_rate = contact_1_apart_squared_rate_rate*half_inverse_contact_0_reach
    contact_2_apart_squared_rate_rate = 2*contact_2_apart_rate_x*contact_2_apart_rate_x + 2*contact_2_apart_rate_y*contact_2_apart_rate_y + 2*contact_2_apart_acceleration_x*contact_2_apart_x + 2*contact_2_apart_acceleration_y*contact_2_apart_y
    contact_2_gap_rate_rate = contact_2_apart_squared_rate_rate*half_inverse_contact_0_reach
    contact_3_apart_squared_rate_rate = 2*contact_3_apart_rate_x*contact_3_apart_rate_x + 2*contact_3_apart_rate_y*contact_3_apart_rate_y + 2*contact_3_apart_acceleration_x*contact_3_apart_x + 2*contact_3_apart_acceleration_y*contact_3_apart_y
    contact_3_gap_rate_rate = contact_3_apart_squared_rate_rate*half_inverse_contact_0_reach
    return ca.vertcat(contact_0_gap_rate_rate, contact_1_gap_rate_rate, contact_2_gap_rate_rate,
        contact_3_gap_rate_rate)


def contact_contact_0(t, q, u, z, m, c):
    """Forces of contact_0: power x exact. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
        dz (4,): contact_0.dissipated [W], contact_1.dissipated [W], contact_2.dissipated [W], contact_3.dissipated
            [W]
        normal_force (1,): contact_0 [N]
        sliding_velocity (0,): empty
        in_range (1,): contact_0 [1]
    """
    length = c[0]
    stiffness = c[2]
    ball_1_arm_x = c[3]
    contact_0_reach = c[10]
    contact_0_hysteresis_factor = c[14]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_0_speed = u[0]
    string_1_speed = u[1]
    contact_0_approach_speed = m[0]
    cos_ball_0 = ca.cos(string_0_angle)
    sin_ball_0 = ca.sin(string_0_angle)
    cos_ball_1 = ca.cos(string_1_angle)
    sin_ball_1 = ca.sin(string_1_angle)
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_first_arm_y = -cos_ball_0*length
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_0_distance = ca.sqrt(contact_0_apart_squared)
    contact_0_penetration = contact_0_reach - contact_0_distance
    contact_0_elastic_force = ca.if_else(contact_0_penetration > 0, contact_0_penetration*stiffness, 0)
    contact_0_normal_x = contact_0_apart_x/contact_0_distance
    contact_0_normal_y = contact_0_apart_y/contact_0_distance
    contact_0_relative_rate_x = contact_0_first_arm_y*string_1_speed - contact_0_first_arm_y*string_0_speed
    contact_0_first_arm_x_minus_ball_1_arm_x = contact_0_first_arm_x - ball_1_arm_x
    contact_0_relative_rate_y = contact_0_first_arm_x*string_0_speed - string_1_speed*contact_0_first_arm_x_minus_ball_1_arm_x
    contact_0_penetration_rate = -contact_0_normal_x*contact_0_relative_rate_x - contact_0_normal_y*contact_0_relative_rate_y
    contact_0_resistance = contact_0_elastic_force*contact_0_hysteresis_factor*contact_0_penetration_rate/contact_0_approach_speed
    contact_0_normal_force = contact_0_elastic_force + contact_0_resistance
    contact_0_normal_power = contact_0_penetration_rate*contact_0_resistance
    contact_0_push_x = contact_0_normal_force*contact_0_normal_x
    contact_0_push_y = contact_0_normal_force*contact_0_normal_y
    contact_0_push_on_string_0 = contact_0_first_arm_x*contact_0_push_y - contact_0_first_arm_y*contact_0_push_x
    contact_0_push_on_string_1 = contact_0_first_arm_y*contact_0_push_x - contact_0_push_y*contact_0_first_arm_x_minus_ball_1_arm_x
    return (
        ca.vertcat(contact_0_push_on_string_0, contact_0_push_on_string_1, 0, 0, 0),
        ca.vertcat(contact_0_normal_power, 0, 0, 0),
        ca.vertcat(contact_0_normal_force),
        ca.vertcat(),
        ca.vertcat(1),
    )


def contact_contact_1(t, q, u, z, m, c):
    """Forces of contact_1: power x exact. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
        dz (4,): contact_0.dissipated [W], contact_1.dissipated [W], contact_2.dissipated [W], contact_3.dissipated
            [W]
        normal_force (1,): contact_1 [N]
        sliding_velocity (0,): empty
        in_range (1,): contact_1 [1]
    """
    length = c[0]
    stiffness = c[2]
    ball_1_arm_x_minus_ball_2_arm_x = c[5]
    contact_0_reach = c[10]
    contact_0_hysteresis_factor = c[14]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_1_speed = u[1]
    string_2_speed = u[2]
    contact_1_approach_speed = m[1]
    cos_ball_1 = ca.cos(string_1_angle)
    sin_ball_1 = ca.sin(string_1_angle)
    cos_ball_2 = ca.cos(string_2_angle)
    sin_ball_2 = ca.sin(string_2_angle)
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_1_apart_y = contact_0_second_arm_y - contact_1_second_arm_y
    contact_1_apart_squared = contact_1_apart_x*contact_1_apart_x + contact_1_apart_y*contact_1_apart_y
    contact_1_distance = ca.sqrt(contact_1_apart_squared)
    contact_1_penetration = contact_0_reach - contact_1_distance
    contact_1_elastic_force = ca.if_else(contact_1_penetration > 0, contact_1_penetration*stiffness, 0)
    contact_1_normal_x = contact_1_apart_x/contact_1_distance
    contact_1_normal_y = contact_1_apart_y/contact_1_distance
    contact_1_relative_rate_x = contact_0_second_arm_y*string_2_speed - contact_0_second_arm_y*string_1_speed
    x1 = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x
    contact_1_relative_rate_y = contact_0_second_arm_x*string_1_speed - string_2_speed*x1
    contact_1_penetration_rate = -contact_1_normal_x*contact_1_relative_rate_x - contact_1_normal_y*contact_1_relative_rate_y
    contact_1_resistance = contact_0_hysteresis_factor*contact_1_elastic_force*contact_1_penetration_rate/contact_1_approach_speed
    contact_1_normal_force = contact_1_elastic_force + contact_1_resistance
    contact_1_normal_power = contact_1_penetration_rate*contact_1_resistance
    contact_1_push_x = contact_1_normal_force*contact_1_normal_x
    contact_1_push_y = contact_1_normal_force*contact_1_normal_y
    contact_1_push_on_string_1 = contact_0_second_arm_x*contact_1_push_y - contact_0_second_arm_y*contact_1_push_x
    contact_1_push_on_string_2 = contact_0_second_arm_y*contact_1_push_x - contact_1_push_y*x1
    return (
        ca.vertcat(0, contact_1_push_on_string_1, contact_1_push_on_string_2, 0, 0),
        ca.vertcat(0, contact_1_normal_power, 0, 0),
        ca.vertcat(contact_1_normal_force),
        ca.vertcat(),
        ca.vertcat(1),
    )


def contact_contact_2(t, q, u, z, m, c):
    """Forces of contact_2: power x exact. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
        dz (4,): contact_0.dissipated [W], contact_1.dissipated [W], contact_2.dissipated [W], contact_3.dissipated
            [W]
        normal_force (1,): contact_2 [N]
        sliding_velocity (0,): empty
        in_range (1,): contact_2 [1]
    """
    length = c[0]
    stiffness = c[2]
    ball_2_arm_x_minus_ball_3_arm_x = c[7]
    contact_0_reach = c[10]
    contact_0_hysteresis_factor = c[14]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_2_speed = u[2]
    string_3_speed = u[3]
    contact_2_approach_speed = m[2]
    cos_ball_2 = ca.cos(string_2_angle)
    sin_ball_2 = ca.sin(string_2_angle)
    cos_ball_3 = ca.cos(string_3_angle)
    sin_ball_3 = ca.sin(string_3_angle)
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_2_apart_y = contact_1_second_arm_y - contact_2_second_arm_y
    contact_2_apart_squared = contact_2_apart_x*contact_2_apart_x + contact_2_apart_y*contact_2_apart_y
    contact_2_distance = ca.sqrt(contact_2_apart_squared)
    contact_2_penetration = contact_0_reach - contact_2_distance
    contact_2_elastic_force = ca.if_else(contact_2_penetration > 0, contact_2_penetration*stiffness, 0)
    contact_2_normal_x = contact_2_apart_x/contact_2_distance
    contact_2_normal_y = contact_2_apart_y/contact_2_distance
    contact_2_relative_rate_x = contact_1_second_arm_y*string_3_speed - contact_1_second_arm_y*string_2_speed
    x1 = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x
    contact_2_relative_rate_y = contact_1_second_arm_x*string_2_speed - string_3_speed*x1
    contact_2_penetration_rate = -contact_2_normal_x*contact_2_relative_rate_x - contact_2_normal_y*contact_2_relative_rate_y
    contact_2_resistance = contact_0_hysteresis_factor*contact_2_elastic_force*contact_2_penetration_rate/contact_2_approach_speed
    contact_2_normal_force = contact_2_elastic_force + contact_2_resistance
    contact_2_normal_power = contact_2_penetration_rate*contact_2_resistance
    contact_2_push_x = contact_2_normal_force*contact_2_normal_x
    contact_2_push_y = contact_2_normal_force*contact_2_normal_y
    contact_2_push_on_string_2 = contact_1_second_arm_x*contact_2_push_y - contact_1_second_arm_y*contact_2_push_x
    contact_2_push_on_string_3 = contact_1_second_arm_y*contact_2_push_x - contact_2_push_y*x1
    return (
        ca.vertcat(0, 0, contact_2_push_on_string_2, contact_2_push_on_string_3, 0),
        ca.vertcat(0, 0, contact_2_normal_power, 0),
        ca.vertcat(contact_2_normal_force),
        ca.vertcat(),
        ca.vertcat(1),
    )


def contact_contact_3(t, q, u, z, m, c):
    """Forces of contact_3: power x exact. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
        dz (4,): contact_0.dissipated [W], contact_1.dissipated [W], contact_2.dissipated [W], contact_3.dissipated
            [W]
        normal_force (1,): contact_3 [N]
        sliding_velocity (0,): empty
        in_range (1,): contact_3 [1]
    """
    length = c[0]
    stiffness = c[2]
    ball_3_arm_x_minus_ball_4_arm_x = c[9]
    contact_0_reach = c[10]
    contact_0_hysteresis_factor = c[14]
    string_3_angle = q[3]
    string_4_angle = q[4]
    string_3_speed = u[3]
    string_4_speed = u[4]
    contact_3_approach_speed = m[3]
    cos_ball_3 = ca.cos(string_3_angle)
    sin_ball_3 = ca.sin(string_3_angle)
    cos_ball_4 = ca.cos(string_4_angle)
    sin_ball_4 = ca.sin(string_4_angle)
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_3_second_arm_x = sin_ball_4*length
    contact_3_second_arm_y = -cos_ball_4*length
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_3_apart_y = contact_2_second_arm_y - contact_3_second_arm_y
    contact_3_apart_squared = contact_3_apart_x*contact_3_apart_x + contact_3_apart_y*contact_3_apart_y
    contact_3_distance = ca.sqrt(contact_3_apart_squared)
    contact_3_penetration = contact_0_reach - contact_3_distance
    contact_3_elastic_force = ca.if_else(contact_3_penetration > 0, contact_3_penetration*stiffness, 0)
    contact_3_normal_x = contact_3_apart_x/contact_3_distance
    contact_3_normal_y = contact_3_apart_y/contact_3_distance
    contact_3_relative_rate_x = contact_2_second_arm_y*string_4_speed - contact_2_second_arm_y*string_3_speed
    x1 = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x
    contact_3_relative_rate_y = contact_2_second_arm_x*string_3_speed - string_4_speed*x1
    contact_3_penetration_rate = -contact_3_normal_x*contact_3_relative_rate_x - contact_3_normal_y*contact_3_relative_rate_y
    contact_3_resistance = contact_0_hysteresis_factor*contact_3_elastic_force*contact_3_penetration_rate/contact_3_approach_speed
    contact_3_normal_force = contact_3_elastic_force + contact_3_resistance
    contact_3_normal_power = contact_3_penetration_rate*contact_3_resistance
    contact_3_push_x = contact_3_normal_force*contact_3_normal_x
    contact_3_push_y = contact_3_normal_force*contact_3_normal_y
    contact_3_push_on_string_3 = contact_2_second_arm_x*contact_3_push_y - contact_2_second_arm_y*contact_3_push_x
    contact_3_push_on_string_4 = contact_2_second_arm_y*contact_3_push_x - contact_3_push_y*x1
    return (
        ca.vertcat(0, 0, 0, contact_3_push_on_string_3, contact_3_push_on_string_4),
        ca.vertcat(0, 0, 0, contact_3_normal_power),
        ca.vertcat(contact_3_normal_force),
        ca.vertcat(),
        ca.vertcat(1),
    )


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (5,): string_0 [N m], string_1 [N m], string_2 [N m], string_3 [N m], string_4 [N m]
    """
    gravity = c[1]
    ball_0_h_y = c[15]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
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
    return ca.vertcat(-ball_0_moment_x*gravity, -ball_1_moment_x*gravity, -ball_2_moment_x*gravity,
        -ball_3_moment_x*gravity, -ball_4_moment_x*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): string_0.acceleration [rad/s^2], string_1.acceleration [rad/s^2], string_2.acceleration [rad/s^2],
            string_3.acceleration [rad/s^2], string_4.acceleration [rad/s^2]
        reactions (0,): empty
    """
    inverse_ball_0_I_z_z = c[16]
    string_0_force = f[0]
    string_1_force = f[1]
    string_2_force = f[2]
    string_3_force = f[3]
    string_4_force = f[4]
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
        dz (4,): contact_0.dissipated [W], contact_1.dissipated [W], contact_2.dissipated [W], contact_3.dissipated
            [W]
    """
    return ca.vertcat(0, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (4,): contact_0 [J], contact_1 [J], contact_2 [J], contact_3 [J]
    """
    length = c[0]
    ball_1_arm_x = c[3]
    ball_1_arm_x_minus_ball_2_arm_x = c[5]
    ball_2_arm_x_minus_ball_3_arm_x = c[7]
    ball_3_arm_x_minus_ball_4_arm_x = c[9]
    contact_0_reach = c[10]
    half_stiffness = c[13]
    half_ball_0_I_z_z = c[17]
    k9 = c[18]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
    string_0_speed = u[0]
    string_1_speed = u[1]
    string_2_speed = u[2]
    string_3_speed = u[3]
    string_4_speed = u[4]
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
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_first_arm_y = -cos_ball_0*length
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_1_apart_y = contact_0_second_arm_y - contact_1_second_arm_y
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_2_apart_y = contact_1_second_arm_y - contact_2_second_arm_y
    contact_3_second_arm_x = sin_ball_4*length
    contact_3_second_arm_y = -cos_ball_4*length
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_3_apart_y = contact_2_second_arm_y - contact_3_second_arm_y
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_1_apart_squared = contact_1_apart_x*contact_1_apart_x + contact_1_apart_y*contact_1_apart_y
    contact_2_apart_squared = contact_2_apart_x*contact_2_apart_x + contact_2_apart_y*contact_2_apart_y
    contact_3_apart_squared = contact_3_apart_x*contact_3_apart_x + contact_3_apart_y*contact_3_apart_y
    contact_0_distance = ca.sqrt(contact_0_apart_squared)
    contact_0_penetration = contact_0_reach - contact_0_distance
    contact_0_stored_energy = ca.if_else(contact_0_penetration > 0, half_stiffness*contact_0_penetration*contact_0_penetration, 0)
    contact_1_distance = ca.sqrt(contact_1_apart_squared)
    contact_1_penetration = contact_0_reach - contact_1_distance
    contact_1_stored_energy = ca.if_else(contact_1_penetration > 0, half_stiffness*contact_1_penetration*contact_1_penetration, 0)
    contact_2_distance = ca.sqrt(contact_2_apart_squared)
    contact_2_penetration = contact_0_reach - contact_2_distance
    contact_2_stored_energy = ca.if_else(contact_2_penetration > 0, half_stiffness*contact_2_penetration*contact_2_penetration, 0)
    contact_3_distance = ca.sqrt(contact_3_apart_squared)
    contact_3_penetration = contact_0_reach - contact_3_distance
    contact_3_stored_energy = ca.if_else(contact_3_penetration > 0, half_stiffness*contact_3_penetration*contact_3_penetration, 0)
    kinetic = half_ball_0_I_z_z*string_0_speed*string_0_speed + half_ball_0_I_z_z*string_1_speed*string_1_speed + half_ball_0_I_z_z*string_2_speed*string_2_speed + half_ball_0_I_z_z*string_3_speed*string_3_speed + half_ball_0_I_z_z*string_4_speed*string_4_speed
    potential = k9*(contact_0_first_arm_y + length) + k9*(contact_0_second_arm_y + length) + k9*(contact_1_second_arm_y + length) + k9*(contact_2_second_arm_y + length) + k9*(contact_3_second_arm_y + length)
    return (
        ca.vertcat(kinetic),
        ca.vertcat(potential),
        ca.vertcat(contact_0_stored_energy, contact_1_stored_energy, contact_2_stored_energy,
            contact_3_stored_energy),
    )


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (15,): ball_0.x [m], ball_0.y [m], ball_0.z [m], ball_1.x [m], ball_1.y [m], ball_1.z [m],
            ball_2.x [m], ball_2.y [m], ball_2.z [m], ball_3.x [m], ball_3.y [m], ball_3.z [m], ball_4.x [m],
            ball_4.y [m], ball_4.z [m]
        rotations (45,): ball_0.R_xx [1], ball_0.R_xy [1], ball_0.R_xz [1], ball_0.R_yx [1], ball_0.R_yy [1],
            ball_0.R_yz [1], ball_0.R_zx [1], ball_0.R_zy [1], ball_0.R_zz [1], ball_1.R_xx [1], ball_1.R_xy [1],
            ball_1.R_xz [1], ball_1.R_yx [1], ball_1.R_yy [1], ball_1.R_yz [1], ball_1.R_zx [1], ball_1.R_zy [1],
            ball_1.R_zz [1], ball_2.R_xx [1], ball_2.R_xy [1], ball_2.R_xz [1], ball_2.R_yx [1], ball_2.R_yy [1],
            ball_2.R_yz [1], ball_2.R_zx [1], ball_2.R_zy [1], ball_2.R_zz [1], ball_3.R_xx [1], ball_3.R_xy [1],
            ball_3.R_xz [1], ball_3.R_yx [1], ball_3.R_yy [1], ball_3.R_yz [1], ball_3.R_zx [1], ball_3.R_zy [1],
            ball_3.R_zz [1], ball_4.R_xx [1], ball_4.R_xy [1], ball_4.R_xz [1], ball_4.R_yx [1], ball_4.R_yy [1],
            ball_4.R_yz [1], ball_4.R_zx [1], ball_4.R_zy [1], ball_4.R_zz [1]
    """
    length = c[0]
    ball_1_arm_x = c[3]
    ball_2_arm_x = c[4]
    ball_3_arm_x = c[6]
    ball_4_arm_x = c[8]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
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
    return (
        ca.vertcat(0, length, 0, ball_1_arm_x, length, 0, ball_2_arm_x, length, 0, ball_3_arm_x, length, 0,
            ball_4_arm_x, length, 0),
        ca.vertcat(cos_ball_0, -sin_ball_0, 0, sin_ball_0, cos_ball_0, 0, 0, 0, 1, cos_ball_1, -sin_ball_1, 0,
            sin_ball_1, cos_ball_1, 0, 0, 0, 1, cos_ball_2, -sin_ball_2, 0, sin_ball_2, cos_ball_2, 0, 0, 0, 1,
            cos_ball_3, -sin_ball_3, 0, sin_ball_3, cos_ball_3, 0, 0, 0, 1, cos_ball_4, -sin_ball_4, 0, sin_ball_4,
            cos_ball_4, 0, 0, 0, 1),
    )


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): contact_0.gap [m], contact_1.gap [m], contact_2.gap [m], contact_3.gap [m]
    """
    length = c[0]
    ball_1_arm_x = c[3]
    ball_1_arm_x_minus_ball_2_arm_x = c[5]
    ball_2_arm_x_minus_ball_3_arm_x = c[7]
    ball_3_arm_x_minus_ball_4_arm_x = c[9]
    contact_0_reach = c[10]
    string_0_angle = q[0]
    string_1_angle = q[1]
    string_2_angle = q[2]
    string_3_angle = q[3]
    string_4_angle = q[4]
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
    contact_0_first_arm_x = sin_ball_0*length
    contact_0_first_arm_y = -cos_ball_0*length
    contact_0_second_arm_x = sin_ball_1*length
    contact_0_second_arm_y = -cos_ball_1*length
    contact_0_apart_x = contact_0_first_arm_x - ball_1_arm_x - contact_0_second_arm_x
    contact_0_apart_y = contact_0_first_arm_y - contact_0_second_arm_y
    contact_1_second_arm_x = sin_ball_2*length
    contact_1_second_arm_y = -cos_ball_2*length
    contact_1_apart_x = contact_0_second_arm_x + ball_1_arm_x_minus_ball_2_arm_x - contact_1_second_arm_x
    contact_1_apart_y = contact_0_second_arm_y - contact_1_second_arm_y
    contact_2_second_arm_x = sin_ball_3*length
    contact_2_second_arm_y = -cos_ball_3*length
    contact_2_apart_x = contact_1_second_arm_x + ball_2_arm_x_minus_ball_3_arm_x - contact_2_second_arm_x
    contact_2_apart_y = contact_1_second_arm_y - contact_2_second_arm_y
    contact_3_second_arm_x = sin_ball_4*length
    contact_3_second_arm_y = -cos_ball_4*length
    contact_3_apart_x = contact_2_second_arm_x + ball_3_arm_x_minus_ball_4_arm_x - contact_3_second_arm_x
    contact_3_apart_y = contact_2_second_arm_y - contact_3_second_arm_y
    contact_0_apart_squared = contact_0_apart_x*contact_0_apart_x + contact_0_apart_y*contact_0_apart_y
    contact_1_apart_squared = contact_1_apart_x*contact_1_apart_x + contact_1_apart_y*contact_1_apart_y
    contact_2_apart_squared = contact_2_apart_x*contact_2_apart_x + contact_2_apart_y*contact_2_apart_y
    contact_3_apart_squared = contact_3_apart_x*contact_3_apart_x + contact_3_apart_y*contact_3_apart_y
    contact_0_distance = ca.sqrt(contact_0_apart_squared)
    contact_0_penetration = contact_0_reach - contact_0_distance
    contact_1_distance = ca.sqrt(contact_1_apart_squared)
    contact_1_penetration = contact_0_reach - contact_1_distance
    contact_2_distance = ca.sqrt(contact_2_apart_squared)
    contact_2_penetration = contact_0_reach - contact_2_distance
    contact_3_distance = ca.sqrt(contact_3_apart_squared)
    contact_3_penetration = contact_0_reach - contact_3_distance
    return ca.vertcat(-contact_0_penetration, -contact_1_penetration, -contact_2_penetration,
        -contact_3_penetration)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        string_0.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_0.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_1.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_1.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_2.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_2.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_3.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_3.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_4.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        string_4.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        contact_0.first (4,): x [m], y [m], z [m], radius [m]
        contact_0.second (4,): x [m], y [m], z [m], radius [m]
        contact_1.first (4,): x [m], y [m], z [m], radius [m]
        contact_1.second (4,): x [m], y [m], z [m], radius [m]
        contact_2.first (4,): x [m], y [m], z [m], radius [m]
        contact_2.second (4,): x [m], y [m], z [m], radius [m]
        contact_3.first (4,): x [m], y [m], z [m], radius [m]
        contact_3.second (4,): x [m], y [m], z [m], radius [m]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball_0.centre (3,): x [m], y [m], z [m]
        ball_1.centre (3,): x [m], y [m], z [m]
        ball_2.centre (3,): x [m], y [m], z [m]
        ball_3.centre (3,): x [m], y [m], z [m]
        ball_4.centre (3,): x [m], y [m], z [m]
    """
    radius = p[0]
    length = p[2]
    spacing = p[3]
    return (
        ca.vertcat(0, length, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(2*radius*spacing, length, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(4*radius*spacing, length, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(6*radius*spacing, length, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(8*radius*spacing, length, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, -length, 0, radius),
        ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(0, -length, 0),
        ca.vertcat(0, -length, 0),
        ca.vertcat(0, -length, 0),
        ca.vertcat(0, -length, 0),
        ca.vertcat(0, -length, 0),
    )
