"""housner_block: block that rocks from corner to corner. Generated from derive/scenes/housner_block.py.

Do not edit; regenerate with `hertzwerk derive housner_block`.
Effects:
    gravity: uniform gravity
    foot_1, foot_2, foot_3, foot_4: power x exact
    foot_friction_1: coulomb at foot_1
    foot_friction_2: coulomb at foot_2
    foot_friction_3: coulomb at foot_3
    foot_friction_4: coulomb at foot_4
    energy_ledger: work put in, energy dissipated per effect
Units: 100 assignments and 253 outputs checked, all consistent
Operations: flight 78 (equations of motion and gaps); in contact also contact_foot_1 31, contact_foot_2 30, contact_foot_3 31, contact_foot_4 30
"""

import casadi as ca

NAME = "housner_block"
SOURCE = "derive/scenes/housner_block.py"
SUMMARY = "block that rocks from corner to corner"
FORMAT = "hertzwerk module 1"
DIGEST = "63cf91772cb2b565eb7c9e7a2113195f"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("foot_1", "contact", "power x exact"), ("foot_2", "contact", "power x exact"),
    ("foot_3", "contact", "power x exact"), ("foot_4", "contact", "power x exact"), ("foot_friction_1", "friction", "coulomb at foot_1"),
    ("foot_friction_2", "friction", "coulomb at foot_2"), ("foot_friction_3", "friction", "coulomb at foot_3"),
    ("foot_friction_4", "friction", "coulomb at foot_4"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 1000, "body block, mass"),
    ("height", "m", 2, "pair foot, y"),
    ("width", "m", 0.5, "pair foot, x"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m", 1000000000.0, "of a corner"),
    ("restitution", "1", 0.001, "effect foot_1, coefficient of restitution of exact"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction", "1", 0.8, "effect foot_friction_1, coefficient of kinetic friction of coulomb"),
    ("tilt", "rad", 0.1, "at the start, on the left corner"),
    ("size", "mm", 1, "scales, length"),
    ("pace", "m/s", 0.1, "scales, speed"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body block, mass"),
    ("width", "defined", 0, None, True, False, "pair foot, x"),
    ("height", "defined", 0, None, True, False, "pair foot, y"),
    ("stiffness", "defined", 0, None, True, False, "effect foot_1, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect foot_1, coefficient of restitution of exact"),
    ("approach_floor", "defined", 0, None, True, False, "effect foot_1, approach floor"),
    ("friction", "defined", 0, None, False, False, "effect foot_friction_1, coefficient of kinetic friction of coulomb"),
    ("size", "defined", 0, None, True, False, "scales, length"),
    ("pace", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("move.x", "m"), ("move.y", "m"), ("move.angle", "rad"))

SPEEDS = (("move.x_speed", "m/s"), ("move.y_speed", "m/s"), ("move.angle_speed", "rad/s"))

MEMORY = (
    ("foot_1.dissipated", "J"), ("foot_2.dissipated", "J"), ("foot_3.dissipated", "J"), ("foot_4.dissipated", "J"),
    ("foot_friction_1.dissipated", "J"), ("foot_friction_2.dissipated", "J"), ("foot_friction_3.dissipated", "J"),
    ("foot_friction_4.dissipated", "J"),
)

LATCHES = (
    ("foot_1.approach_speed", "m/s", 0), ("foot_2.approach_speed", "m/s", 1), ("foot_3.approach_speed", "m/s", 2),
    ("foot_4.approach_speed", "m/s", 3),
)

PAIRS = (("foot_1", "corner_on_face"), ("foot_2", "corner_on_face"), ("foot_3", "corner_on_face"), ("foot_4", "corner_on_face"))

SLIPS = (("foot_1.slip", "1", 0), ("foot_2.slip", "1", 1), ("foot_3.slip", "1", 2), ("foot_4.slip", "1", 3))

RELEASES = ("force", "force", "force", "force")

DISSIPATED = (0, 1, 2, 3)

OUTPUTS = (("foot_1.gap", "m"), ("foot_2.gap", "m"), ("foot_3.gap", "m"), ("foot_4.gap", "m"))

BODIES = ("block",)

LANDMARKS = (
    ("move", "planar", "parent", "ground", ("normal",)), ("move", "planar", "child", "block", ("normal",)),
    ("foot_1", "corner_on_face", "corner", "block", ()), ("foot_1", "corner_on_face", "face", "ground", ("normal",)),
    ("foot_2", "corner_on_face", "corner", "block", ()), ("foot_2", "corner_on_face", "face", "ground", ("normal",)),
    ("foot_3", "corner_on_face", "corner", "block", ()), ("foot_3", "corner_on_face", "face", "ground", ("normal",)),
    ("foot_4", "corner_on_face", "corner", "block", ()), ("foot_4", "corner_on_face", "face", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("block", "body", "centre", "block", ()),
)

CONSTANTS = (
    ("mass", "kg"), ("gravity", "m/s^2"), ("stiffness", "N/m"), ("friction", "1"), ("half_height", "m"), ("half_width", "m"),
    ("half_stiffness", "N/m"), ("foot_1_hysteresis_factor", "1"), ("inverse_mass", "1/kg"), ("inverse_block_I_z_z", "1/(kg m^2)"),
    ("half_block_I_z_z", "kg m^2"), ("half_mass", "kg"), ("gravity_times_mass", "N"),
)

OPERATIONS = (
    ("constants", 161), ("start", 7), ("scales", 6), ("coordinate_rates", 0), ("gaps", 30), ("gap_accelerations", 43),
    ("contact_foot_1", 31), ("contact_foot_2", 30), ("contact_foot_3", 31), ("contact_foot_4", 30), ("applied", 2), ("accelerations", 3),
    ("ledger", 0), ("energy", 44), ("poses", 3), ("outputs", 16), ("landmarks", 6),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (13,): mass, gravity, stiffness, friction, half_height, half_width, half_stiffness, foot_1_hysteresis_factor, inverse_mass,
            inverse_block_I_z_z, half_block_I_z_z, half_mass, gravity_times_mass
    """
    mass, height, width, gravity, stiffness, restitution, friction = p[0], p[1], p[2], p[3], p[4], p[5], p[7]
    half_height = height/2
    half_width = width/2
    half_stiffness = stiffness/2
    one_plus_restitution = 1 + restitution
    foot_1_y = (1 - restitution)/one_plus_restitution
    foot_1_r = 2*restitution/one_plus_restitution
    foot_1_t_0 = foot_1_y*(3 + 2*foot_1_y**6/5 - 6*foot_1_y*foot_1_y/5 - foot_1_y**4/5)/(foot_1_r*(1 + foot_1_y))
    foot_1_t_0_to_the_6 = foot_1_t_0**6
    foot_1_t_0_to_the_4 = foot_1_t_0**4
    foot_1_t_0_squared = foot_1_t_0*foot_1_t_0
    foot_1_q_0 = (34459425 + foot_1_t_0**8 + 990*foot_1_t_0_to_the_6 + 135135*foot_1_t_0_to_the_4 + 4729725*foot_1_t_0_squared)/(11486475 + 44*foot_1_t_0_to_the_6 + 12870*foot_1_t_0_to_the_4 + 810810*foot_1_t_0_squared)
    foot_1_w_0 = 1/ca.fmax(1, foot_1_t_0)
    foot_1_c_0 = 2/(ca.exp(2/foot_1_w_0) - 1)
    foot_1_t_1 = foot_1_t_0 + ca.if_else(foot_1_t_0 < 1, (foot_1_y - foot_1_t_0/foot_1_q_0)/(1 - 2/foot_1_q_0 - foot_1_t_0_squared/(foot_1_q_0*foot_1_q_0)), (foot_1_w_0 - foot_1_c_0 - foot_1_r)/(foot_1_w_0*foot_1_w_0 - foot_1_c_0*(2 + foot_1_c_0)))
    foot_1_t_1_to_the_6 = foot_1_t_1**6
    foot_1_t_1_to_the_4 = foot_1_t_1**4
    foot_1_t_1_squared = foot_1_t_1*foot_1_t_1
    foot_1_q_1 = (34459425 + foot_1_t_1**8 + 990*foot_1_t_1_to_the_6 + 135135*foot_1_t_1_to_the_4 + 4729725*foot_1_t_1_squared)/(11486475 + 44*foot_1_t_1_to_the_6 + 12870*foot_1_t_1_to_the_4 + 810810*foot_1_t_1_squared)
    foot_1_w_1 = 1/ca.fmax(1, foot_1_t_1)
    foot_1_c_1 = 2/(ca.exp(2/foot_1_w_1) - 1)
    foot_1_t_2 = foot_1_t_1 + ca.if_else(foot_1_t_1 < 1, (foot_1_y - foot_1_t_1/foot_1_q_1)/(1 - 2/foot_1_q_1 - foot_1_t_1_squared/(foot_1_q_1*foot_1_q_1)), (foot_1_w_1 - foot_1_c_1 - foot_1_r)/(foot_1_w_1*foot_1_w_1 - foot_1_c_1*(2 + foot_1_c_1)))
    foot_1_t_2_to_the_6 = foot_1_t_2**6
    foot_1_t_2_to_the_4 = foot_1_t_2**4
    foot_1_t_2_squared = foot_1_t_2*foot_1_t_2
    foot_1_q_2 = (34459425 + foot_1_t_2**8 + 990*foot_1_t_2_to_the_6 + 135135*foot_1_t_2_to_the_4 + 4729725*foot_1_t_2_squared)/(11486475 + 44*foot_1_t_2_to_the_6 + 12870*foot_1_t_2_to_the_4 + 810810*foot_1_t_2_squared)
    foot_1_w_2 = 1/ca.fmax(1, foot_1_t_2)
    foot_1_c_2 = 2/(ca.exp(2/foot_1_w_2) - 1)
    foot_1_t_3 = foot_1_t_2 + ca.if_else(foot_1_t_2 < 1, (foot_1_y - foot_1_t_2/foot_1_q_2)/(1 - 2/foot_1_q_2 - foot_1_t_2_squared/(foot_1_q_2*foot_1_q_2)), (foot_1_w_2 - foot_1_c_2 - foot_1_r)/(foot_1_w_2*foot_1_w_2 - foot_1_c_2*(2 + foot_1_c_2)))
    foot_1_hysteresis_factor = 2*foot_1_t_3/one_plus_restitution
    block_I_z_z = (height*height + width*width)*mass/12
    inverse_mass = 1/mass
    inverse_block_I_z_z = 1/block_I_z_z
    half_block_I_z_z = block_I_z_z/2
    half_mass = mass/2
    gravity_times_mass = gravity*mass
    return ca.vertcat(mass, gravity, stiffness, friction, half_height, half_width, half_stiffness, foot_1_hysteresis_factor, inverse_mass,
        inverse_block_I_z_z, half_block_I_z_z, half_mass, gravity_times_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (3,): SPEEDS
    """
    height, width, tilt = p[1], p[2], p[8]
    return ca.vertcat(0, height*ca.cos(tilt)/2 + width*ca.sin(tilt)/2, tilt), ca.vertcat(0, 0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (3,): SPEEDS
        sz (8,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, width, size, pace = p[0], p[2], p[9], p[10]
    energy_scale = pace*pace*mass/2
    force_scale = energy_scale/size
    return (ca.vertcat(size, size, size/width), ca.vertcat(pace, pace, pace/width), ca.vertcat(*[energy_scale]*8),
        ca.vertcat(size, pace, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): move.x [m/s], move.y [m/s], move.angle [rad/s]
    """
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    return ca.vertcat(move_x_speed, move_y_speed, move_angle_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (4,): PAIRS [m]
        dG (4,): PAIRS [m/s]
    """
    half_height, half_width = c[4], c[5]
    move_y, move_angle = q[1], q[2]
    move_y_speed, move_angle_speed = u[1], u[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    x1 = half_height*sin_block
    foot_1_first_arm_x = x1 - cos_block*half_width
    x2 = -cos_block*half_height
    x3 = -half_width*sin_block
    foot_1_first_arm_y = x2 + x3
    foot_1_first_arm_rate_y = foot_1_first_arm_x*move_angle_speed
    foot_1_apart_y = foot_1_first_arm_y + move_y
    foot_1_apart_rate_y = foot_1_first_arm_rate_y + move_y_speed
    x4 = cos_block*half_width
    foot_2_first_arm_x = x1 + x4
    x5 = half_width*sin_block
    foot_2_first_arm_y = x2 + x5
    foot_2_first_arm_rate_y = foot_2_first_arm_x*move_angle_speed
    foot_2_apart_y = foot_2_first_arm_y + move_y
    foot_2_apart_rate_y = foot_2_first_arm_rate_y + move_y_speed
    x6 = cos_block*half_height
    foot_3_first_arm_y = x3 + x6
    foot_3_apart_y = foot_3_first_arm_y + move_y
    foot_3_apart_rate_y = move_y_speed - foot_2_first_arm_rate_y
    foot_4_first_arm_x = x4 - half_height*sin_block
    foot_4_first_arm_y = x5 + x6
    foot_4_first_arm_rate_y = foot_4_first_arm_x*move_angle_speed
    foot_4_apart_y = foot_4_first_arm_y + move_y
    foot_4_apart_rate_y = foot_4_first_arm_rate_y + move_y_speed
    return (ca.vertcat(foot_1_apart_y, foot_2_apart_y, foot_3_apart_y, foot_4_apart_y),
        ca.vertcat(foot_1_apart_rate_y, foot_2_apart_rate_y, foot_3_apart_rate_y, foot_4_apart_rate_y))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (4,): PAIRS [m/s^2]
    """
    half_height, half_width = c[4], c[5]
    move_angle = q[2]
    move_angle_speed = u[2]
    move_y_acceleration, move_angle_acceleration = a[1], a[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    x1 = half_height*sin_block
    foot_1_first_arm_x = x1 - cos_block*half_width
    x2 = -cos_block*half_height
    x3 = -half_width*sin_block
    foot_1_first_arm_y = x2 + x3
    foot_1_first_arm_rate_x = -foot_1_first_arm_y*move_angle_speed
    foot_1_apart_acceleration_y = move_y_acceleration + foot_1_first_arm_rate_x*move_angle_speed + foot_1_first_arm_x*move_angle_acceleration
    x4 = cos_block*half_width
    foot_2_first_arm_x = x1 + x4
    x5 = half_width*sin_block
    foot_2_first_arm_y = x2 + x5
    foot_2_first_arm_rate_x = -foot_2_first_arm_y*move_angle_speed
    foot_2_apart_acceleration_y = move_y_acceleration + foot_2_first_arm_rate_x*move_angle_speed + foot_2_first_arm_x*move_angle_acceleration
    x6 = cos_block*half_height
    foot_3_first_arm_y = x3 + x6
    foot_3_first_arm_rate_x = -foot_3_first_arm_y*move_angle_speed
    foot_3_apart_acceleration_y = move_y_acceleration + foot_3_first_arm_rate_x*move_angle_speed - foot_2_first_arm_x*move_angle_acceleration
    foot_4_first_arm_x = x4 - half_height*sin_block
    foot_4_first_arm_y = x5 + x6
    foot_4_first_arm_rate_x = -foot_4_first_arm_y*move_angle_speed
    foot_4_apart_acceleration_y = move_y_acceleration + foot_4_first_arm_rate_x*move_angle_speed + foot_4_first_arm_x*move_angle_acceleration
    return ca.vertcat(foot_1_apart_acceleration_y, foot_2_apart_acceleration_y, foot_3_apart_acceleration_y, foot_4_apart_acceleration_y)


def contact_foot_1(t, q, u, z, m, c):
    """Forces of foot_1: power x exact, coulomb. The normal force is the laws' own, not clamped: where it would pull, the contact ends.
    Friction comes on top: `along` times its force, which is that of slip or stick.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): move.x [N], move.y [N], move.angle [N m]
        dz (8,): MEMORY [W]
        normal_force (1,): foot_1 [N]
        sliding_velocity (1,): foot_1 [m/s]
        in_range (1,): foot_1 [1]
        along (3,): move.x [1], move.y [1], move.angle [m]
        dz_along (8,): MEMORY [W/N]
        sliding_force, holding_force (1,): foot_1 [N]
    """
    stiffness, friction, half_height, half_width, foot_1_hysteresis_factor = c[2], c[3], c[4], c[5], c[7]
    move_y, move_angle = q[1], q[2]
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    foot_1_approach_speed = m[0]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    foot_1_first_arm_x = half_height*sin_block - cos_block*half_width
    foot_1_first_arm_y = -cos_block*half_height - half_width*sin_block
    foot_1_apart_y = foot_1_first_arm_y + move_y
    foot_1_elastic_force = ca.if_else(-foot_1_apart_y > 0, -foot_1_apart_y*stiffness, 0)
    foot_1_relative_rate_x = move_x_speed - foot_1_first_arm_y*move_angle_speed
    foot_1_relative_rate_y = move_y_speed + foot_1_first_arm_x*move_angle_speed
    foot_1_resistance = -foot_1_elastic_force*foot_1_hysteresis_factor*foot_1_relative_rate_y/foot_1_approach_speed
    foot_1_normal_force = foot_1_elastic_force + foot_1_resistance
    foot_1_normal_power = -foot_1_relative_rate_y*foot_1_resistance
    foot_1_push_on_move_angle = foot_1_first_arm_x*foot_1_normal_force
    foot_1_pressing_force = ca.if_else(foot_1_normal_force > 0, foot_1_normal_force, 0)
    foot_1_sliding_force = foot_1_pressing_force*friction
    return (ca.vertcat(0, foot_1_normal_force, foot_1_push_on_move_angle), ca.vertcat(foot_1_normal_power, *[0]*7),
        ca.vertcat(foot_1_normal_force), ca.vertcat(-foot_1_relative_rate_x), ca.vertcat(1), ca.vertcat(-1, 0, foot_1_first_arm_y),
        ca.vertcat(0, 0, 0, 0, foot_1_relative_rate_x, 0, 0, 0), ca.vertcat(foot_1_sliding_force), ca.vertcat(foot_1_sliding_force))


def contact_foot_2(t, q, u, z, m, c):
    """Forces of foot_2: power x exact, coulomb; arguments and returns as of contact_foot_1."""
    stiffness, friction, half_height, half_width, foot_1_hysteresis_factor = c[2], c[3], c[4], c[5], c[7]
    move_y, move_angle = q[1], q[2]
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    foot_2_approach_speed = m[1]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    foot_2_first_arm_x = cos_block*half_width + half_height*sin_block
    foot_2_first_arm_y = half_width*sin_block - cos_block*half_height
    foot_2_apart_y = foot_2_first_arm_y + move_y
    foot_2_elastic_force = ca.if_else(-foot_2_apart_y > 0, -foot_2_apart_y*stiffness, 0)
    foot_2_relative_rate_x = move_x_speed - foot_2_first_arm_y*move_angle_speed
    foot_2_relative_rate_y = move_y_speed + foot_2_first_arm_x*move_angle_speed
    foot_2_resistance = -foot_1_hysteresis_factor*foot_2_elastic_force*foot_2_relative_rate_y/foot_2_approach_speed
    foot_2_normal_force = foot_2_elastic_force + foot_2_resistance
    foot_2_normal_power = -foot_2_relative_rate_y*foot_2_resistance
    foot_2_push_on_move_angle = foot_2_first_arm_x*foot_2_normal_force
    foot_2_pressing_force = ca.if_else(foot_2_normal_force > 0, foot_2_normal_force, 0)
    foot_2_sliding_force = foot_2_pressing_force*friction
    return (ca.vertcat(0, foot_2_normal_force, foot_2_push_on_move_angle), ca.vertcat(0, foot_2_normal_power, *[0]*6),
        ca.vertcat(foot_2_normal_force), ca.vertcat(-foot_2_relative_rate_x), ca.vertcat(1), ca.vertcat(-1, 0, foot_2_first_arm_y),
        ca.vertcat(*[0]*5, foot_2_relative_rate_x, 0, 0), ca.vertcat(foot_2_sliding_force), ca.vertcat(foot_2_sliding_force))


def contact_foot_3(t, q, u, z, m, c):
    """Forces of foot_3: power x exact, coulomb; arguments and returns as of contact_foot_1."""
    stiffness, friction, half_height, half_width, foot_1_hysteresis_factor = c[2], c[3], c[4], c[5], c[7]
    move_y, move_angle = q[1], q[2]
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    foot_3_approach_speed = m[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    foot_2_first_arm_x = cos_block*half_width + half_height*sin_block
    foot_3_first_arm_y = cos_block*half_height - half_width*sin_block
    foot_3_apart_y = foot_3_first_arm_y + move_y
    foot_3_elastic_force = ca.if_else(-foot_3_apart_y > 0, -foot_3_apart_y*stiffness, 0)
    foot_3_relative_rate_x = move_x_speed - foot_3_first_arm_y*move_angle_speed
    foot_3_relative_rate_y = move_y_speed - foot_2_first_arm_x*move_angle_speed
    foot_3_resistance = -foot_1_hysteresis_factor*foot_3_elastic_force*foot_3_relative_rate_y/foot_3_approach_speed
    foot_3_normal_force = foot_3_elastic_force + foot_3_resistance
    foot_3_normal_power = -foot_3_relative_rate_y*foot_3_resistance
    foot_3_push_on_move_angle = -foot_2_first_arm_x*foot_3_normal_force
    foot_3_pressing_force = ca.if_else(foot_3_normal_force > 0, foot_3_normal_force, 0)
    foot_3_sliding_force = foot_3_pressing_force*friction
    return (ca.vertcat(0, foot_3_normal_force, foot_3_push_on_move_angle), ca.vertcat(0, 0, foot_3_normal_power, *[0]*5),
        ca.vertcat(foot_3_normal_force), ca.vertcat(-foot_3_relative_rate_x), ca.vertcat(1), ca.vertcat(-1, 0, foot_3_first_arm_y),
        ca.vertcat(*[0]*6, foot_3_relative_rate_x, 0), ca.vertcat(foot_3_sliding_force), ca.vertcat(foot_3_sliding_force))


def contact_foot_4(t, q, u, z, m, c):
    """Forces of foot_4: power x exact, coulomb; arguments and returns as of contact_foot_1."""
    stiffness, friction, half_height, half_width, foot_1_hysteresis_factor = c[2], c[3], c[4], c[5], c[7]
    move_y, move_angle = q[1], q[2]
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    foot_4_approach_speed = m[3]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    foot_4_first_arm_x = cos_block*half_width - half_height*sin_block
    foot_4_first_arm_y = cos_block*half_height + half_width*sin_block
    foot_4_apart_y = foot_4_first_arm_y + move_y
    foot_4_elastic_force = ca.if_else(-foot_4_apart_y > 0, -foot_4_apart_y*stiffness, 0)
    foot_4_relative_rate_x = move_x_speed - foot_4_first_arm_y*move_angle_speed
    foot_4_relative_rate_y = move_y_speed + foot_4_first_arm_x*move_angle_speed
    foot_4_resistance = -foot_1_hysteresis_factor*foot_4_elastic_force*foot_4_relative_rate_y/foot_4_approach_speed
    foot_4_normal_force = foot_4_elastic_force + foot_4_resistance
    foot_4_normal_power = -foot_4_relative_rate_y*foot_4_resistance
    foot_4_push_on_move_angle = foot_4_first_arm_x*foot_4_normal_force
    foot_4_pressing_force = ca.if_else(foot_4_normal_force > 0, foot_4_normal_force, 0)
    foot_4_sliding_force = foot_4_pressing_force*friction
    return (ca.vertcat(0, foot_4_normal_force, foot_4_push_on_move_angle), ca.vertcat(0, 0, 0, foot_4_normal_power, 0, 0, 0, 0),
        ca.vertcat(foot_4_normal_force), ca.vertcat(-foot_4_relative_rate_x), ca.vertcat(1), ca.vertcat(-1, 0, foot_4_first_arm_y),
        ca.vertcat(*[0]*7, foot_4_relative_rate_x), ca.vertcat(foot_4_sliding_force), ca.vertcat(foot_4_sliding_force))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): move.x [N], move.y [N], move.angle [N m]
    """
    mass, gravity = c[0], c[1]
    return ca.vertcat(0, -gravity*mass, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (3,): move.x_acceleration [m/s^2], move.y_acceleration [m/s^2], move.angle_acceleration [rad/s^2]
        reactions (0,): empty
    """
    inverse_mass, inverse_block_I_z_z = c[8], c[9]
    move_x_force, move_y_force, move_angle_force = f[0], f[1], f[2]
    move_x_acc = inverse_mass*move_x_force
    move_y_acc = inverse_mass*move_y_force
    move_angle_acc = inverse_block_I_z_z*move_angle_force
    return ca.vertcat(move_x_acc, move_y_acc, move_angle_acc), ca.vertcat()


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
    half_height, half_width, half_stiffness, half_block_I_z_z, half_mass, gravity_times_mass = c[4], c[5], c[6], c[10], c[11], c[12]
    move_y, move_angle = q[1], q[2]
    move_x_speed, move_y_speed, move_angle_speed = u[0], u[1], u[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    x1 = -cos_block*half_height
    x2 = -half_width*sin_block
    foot_1_first_arm_y = x1 + x2
    foot_1_apart_y = foot_1_first_arm_y + move_y
    x3 = half_width*sin_block
    foot_2_first_arm_y = x1 + x3
    foot_2_apart_y = foot_2_first_arm_y + move_y
    x4 = cos_block*half_height
    foot_3_first_arm_y = x2 + x4
    foot_3_apart_y = foot_3_first_arm_y + move_y
    foot_4_first_arm_y = x3 + x4
    foot_4_apart_y = foot_4_first_arm_y + move_y
    foot_1_stored_energy = ca.if_else(-foot_1_apart_y > 0, half_stiffness*foot_1_apart_y*foot_1_apart_y, 0)
    foot_2_stored_energy = ca.if_else(-foot_2_apart_y > 0, half_stiffness*foot_2_apart_y*foot_2_apart_y, 0)
    foot_3_stored_energy = ca.if_else(-foot_3_apart_y > 0, half_stiffness*foot_3_apart_y*foot_3_apart_y, 0)
    foot_4_stored_energy = ca.if_else(-foot_4_apart_y > 0, half_stiffness*foot_4_apart_y*foot_4_apart_y, 0)
    kinetic = half_block_I_z_z*move_angle_speed*move_angle_speed + half_mass*(move_x_speed*move_x_speed + move_y_speed*move_y_speed)
    potential = gravity_times_mass*move_y
    return (ca.vertcat(kinetic), ca.vertcat(potential),
        ca.vertcat(foot_1_stored_energy, foot_2_stored_energy, foot_3_stored_energy, foot_4_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): block.x [m], block.y [m], block.z [m]
        rotations (9,): block.R_xx [1], block.R_xy [1], block.R_xz [1], block.R_yx [1], block.R_yy [1], block.R_yz [1], block.R_zx [1],
            block.R_zy [1], block.R_zz [1]
    """
    move_x, move_y, move_angle = q[0], q[1], q[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    return ca.vertcat(move_x, move_y, 0), ca.vertcat(cos_block, -sin_block, 0, sin_block, cos_block, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): OUTPUTS
    """
    half_height, half_width = c[4], c[5]
    move_y, move_angle = q[1], q[2]
    cos_block = ca.cos(move_angle)
    sin_block = ca.sin(move_angle)
    x1 = -cos_block*half_height
    x2 = -half_width*sin_block
    foot_1_first_arm_y = x1 + x2
    foot_1_apart_y = foot_1_first_arm_y + move_y
    x3 = half_width*sin_block
    foot_2_first_arm_y = x1 + x3
    foot_2_apart_y = foot_2_first_arm_y + move_y
    x4 = cos_block*half_height
    foot_3_first_arm_y = x2 + x4
    foot_3_apart_y = foot_3_first_arm_y + move_y
    foot_4_first_arm_y = x3 + x4
    foot_4_apart_y = foot_4_first_arm_y + move_y
    return ca.vertcat(foot_1_apart_y, foot_2_apart_y, foot_3_apart_y, foot_4_apart_y)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        move.parent, move.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        foot_1.corner (3,): x [m], y [m], z [m]
        foot_1.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        foot_2.corner (3,): x [m], y [m], z [m]
        foot_2.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        foot_3.corner (3,): x [m], y [m], z [m]
        foot_3.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        foot_4.corner (3,): x [m], y [m], z [m]
        foot_4.face (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        block.centre (3,): x [m], y [m], z [m]
    """
    height, width = p[1], p[2]
    minus_half_width = -width/2
    minus_half_height = -height/2
    x3 = width/2
    x4 = height/2
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(minus_half_width, minus_half_height, 0), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(x3, minus_half_height, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(minus_half_width, x4, 0),
        ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(x3, x4, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(0, 0, 0))
