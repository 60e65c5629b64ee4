"""yielding_ball: ball that yields when dropped on a plane. Generated from derive/scenes/yielding_ball.py.

Do not edit; regenerate with `hertzwerk derive yielding_ball`.
Effects:
    gravity: uniform gravity
    floor: thornton
    energy_ledger: work put in, energy dissipated per effect
Units: 37 assignments and 108 outputs checked, all consistent
Operations: flight 5 (equations of motion and gaps); in contact also contact_floor 65
"""

import casadi as ca

NAME = "yielding_ball"
SOURCE = "derive/scenes/yielding_ball.py"
SUMMARY = "ball that yields when dropped on a plane"
FORMAT = "hertzwerk module 1"
DIGEST = "28070fc15d5c8fd88edff1b5110ee62d"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("floor", "contact", "thornton"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("radius", "mm", 25, "body ball, sphere, radius"),
    ("density", "kg/m^3", 7800, "effect floor, density"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect floor, Young's modulus of the first body of thornton"),
    ("poissons_ratio", "1", 0.3, "effect floor, Poisson's ratio of the first body of thornton"),
    ("yield_strength", "MPa", 1000, "of ball and plane"),
    ("limiting_pressure", "1", 1.6, "pressure that limits the contact over the yield strength"),
    ("drop_height", "m", 0.5, "gap at the start"),
)

LIMITS = (
    ("radius", "defined", 0, None, True, False, "body ball, sphere, radius"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect floor, Young's modulus of the first body of thornton"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect floor, Poisson's ratio of the first body of thornton"),
    ("yield_strength", "defined", 0, None, True, False, "effect floor, yield strength in simple tension of the body that yields of thornton"),
    ("limiting_pressure", "defined", 0, None, True, False, "effect floor, pressure that limits the contact over the yield strength of thornton"),
    ("density", "defined", 0, None, True, False, "effect floor, density"),
)

COORDINATES = (("vertical.travel", "m"), ("floor.stage", "1"), ("floor.deepest", "m"), ("floor.dent", "m"))

SPEEDS = (("vertical.speed", "m/s"),)

MEMORY = (("floor.dissipated", "J"),)

PAIRS = (("floor", "sphere_on_plane"),)

EVENTS = (("floor.yields", (1,)), ("floor.unloads", (1, 2, 3)), ("floor.reloads", (1,)), ("floor.parts", (1, 2, 3)))

RELEASES = ("force",)

DISSIPATED = (0,)

OUTPUTS = (("floor.gap", "m"),)

BODIES = ("ball",)

LANDMARKS = (
    ("vertical", "prismatic", "parent", "ground", ("axis",)), ("vertical", "prismatic", "child", "ball", ("axis",)),
    ("floor", "sphere_on_plane", "sphere", "ball", ("radius",)), ("floor", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("ball", "body", "centre", "ball", ()),
    ("ball", "solid_sphere", "shape_1", "ball", ("radius",)),
)

CONSTANTS = (
    ("radius", "m"), ("gravity", "m/s^2"), ("floor_K", "N/m^1.5"), ("floor_p_y", "Pa"), ("floor_d_y", "m"), ("floor_F_y", "N"),
    ("floor_pace", "m/s"), ("total_mass", "kg"), ("pi_times_floor_p_y_times_radius", "N/m"), ("two_fifths_of_floor_K", "N/m^1.5"),
    ("two_fifths_of_inverse_floor_K", "m^1.5/N"), ("k4", "m^1.5/N"), ("k5", "m^0.5"), ("inverse_total_mass", "1/kg"), ("k7", "kg"),
    ("k8", "N"),
)

OPERATIONS = (
    ("constants", 68), ("start", 1), ("scales", 48), ("coordinate_rates", 0), ("gaps", 2), ("gap_accelerations", 0), ("contact_floor", 65),
    ("applied", 2), ("accelerations", 1), ("margins", 20), ("jumps", 20), ("ledger", 0), ("energy", 57), ("poses", 0), ("outputs", 1),
    ("landmarks", 0),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = LOADS = FED = RUBBING = GUIDES = ()
SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (16,): radius, gravity, floor_K, floor_p_y, floor_d_y, floor_F_y, floor_pace, total_mass, pi_times_floor_p_y_times_radius,
            two_fifths_of_floor_K, two_fifths_of_inverse_floor_K, k4, k5, inverse_total_mass, k7, k8
    """
    radius, density, gravity, youngs_modulus, poissons_ratio, yield_strength, limiting_pressure = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    floor_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    floor_K = 4*floor_E_eff*ca.sqrt(radius)/3
    floor_p_y = limiting_pressure*yield_strength
    inverse_floor_E_eff_squared = 1/(floor_E_eff*floor_E_eff)
    floor_d_y = inverse_floor_E_eff_squared*3.141592653589793**2*floor_p_y*floor_p_y*radius/4
    floor_F_y = inverse_floor_E_eff_squared*3.141592653589793**3*floor_p_y*floor_p_y*floor_p_y*radius*radius/6
    floor_pace = ca.sqrt(3)*ca.sqrt(floor_K*floor_d_y*floor_d_y*ca.sqrt(floor_d_y)/(density*radius*radius*radius))/(2*ca.sqrt(3.141592653589793))
    radius_cubed = radius*radius*radius
    total_mass = 4*3.141592653589793*radius_cubed*density/3
    pi_times_floor_p_y_times_radius = 3.141592653589793*floor_p_y*radius
    two_fifths_of_floor_K = 2*floor_K/5
    two_fifths_of_inverse_floor_K = 2/(5*floor_K)
    k4 = 1/(5*floor_K)
    k5 = 4*3.141592653589793*floor_p_y*radius/(5*floor_K)
    inverse_total_mass = 1/total_mass
    k7 = 2*3.141592653589793*radius_cubed*density/3
    k8 = 4*3.141592653589793*radius_cubed*density*gravity/3
    return ca.vertcat(radius, gravity, floor_K, floor_p_y, floor_d_y, floor_F_y, floor_pace, total_mass, pi_times_floor_p_y_times_radius,
        two_fifths_of_floor_K, two_fifths_of_inverse_floor_K, k4, k5, inverse_total_mass, k7, k8)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (4,): COORDINATES
        u (1,): SPEEDS
    """
    radius, drop_height = p[0], p[7]
    return ca.vertcat(drop_height + radius, 0, 0, 0), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (4,): COORDINATES
        su (1,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    radius, density, gravity, youngs_modulus, poissons_ratio, drop_height = p[0], p[1], p[2], p[3], p[4], p[7]
    total_mass = 4*3.141592653589793*radius*radius*radius*density/3
    energy_scale = total_mass*drop_height*gravity
    x1 = radius*radius*ca.sqrt(radius)
    poissons_ratio_squared = poissons_ratio*poissons_ratio
    minus_twice_poissons_ratio_squared = -2*poissons_ratio_squared
    x4 = 2 + minus_twice_poissons_ratio_squared
    x5 = x1*x4*density*drop_height*gravity/youngs_modulus
    force_scale = energy_scale*2**(2/5)*5**(3/5)/(5*3.141592653589793**(2/5)*x5**(2/5))
    x6 = 2**(3/5)
    x7 = 5**(2/5)
    x8 = 3.141592653589793**(2/5)
    x9 = x5**(2/5)
    x10 = x6*x7*x8*x9/2
    sqrt_2 = ca.sqrt(2)
    drop_height_times_gravity = drop_height*gravity
    x13 = ca.sqrt(drop_height_times_gravity)
    x14 = sqrt_2*x13
    return ca.vertcat(x10, 1, x10, x10), ca.vertcat(x14), ca.vertcat(energy_scale), ca.vertcat(x10, x14, force_scale, energy_scale)


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (4,): vertical.travel [m/s], floor.stage [1/s], floor.deepest [m/s], floor.dent [m/s]
    """
    vertical_speed = u[0]
    return ca.vertcat(vertical_speed, 0, 0, 0)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    radius = c[0]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_dent = q[3]
    floor_gap = vertical_travel - radius
    floor_gap_to_dent = floor_dent + floor_gap
    return ca.vertcat(floor_gap_to_dent), ca.vertcat(vertical_speed)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    vertical_acceleration = a[0]
    return ca.vertcat(vertical_acceleration)


def contact_floor(t, q, u, z, m, c):
    """Forces of floor: thornton. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): vertical [N]
        dz (1,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    radius, floor_K, floor_d_y, floor_F_y, pi_times_floor_p_y_times_radius, k4, k5 = c[0], c[2], c[4], c[5], c[8], c[11], c[12]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_stage, floor_deepest, floor_dent = q[1], q[2], q[3]
    floor_gap = vertical_travel - radius
    floor_stage_number = ca.if_else(floor_stage < 0, -floor_stage, floor_stage)
    floor_loaded_depth = ca.if_else(-floor_gap > 0, -floor_gap, floor_d_y)
    floor_turned_depth = ca.if_else(floor_stage < 0, floor_deepest, floor_d_y)
    floor_loaded_depth_minus_floor_d_y = floor_loaded_depth - floor_d_y
    x2 = pi_times_floor_p_y_times_radius*floor_loaded_depth_minus_floor_d_y
    base = floor_F_y + x2
    floor_loading_force = ca.if_else(floor_stage_number < 1, floor_K*floor_loaded_depth*ca.sqrt(floor_loaded_depth), base)
    floor_peak_force = ca.if_else(floor_stage_number < 1, floor_K*floor_turned_depth*ca.sqrt(floor_turned_depth), floor_F_y + pi_times_floor_p_y_times_radius*(floor_turned_depth - floor_d_y))
    floor_lift = ca.if_else(floor_stage < 0, floor_deepest - floor_dent, floor_d_y)
    floor_share = ca.if_else(floor_stage < 0, ca.if_else(-floor_gap > floor_dent, -floor_dent - floor_gap, 0), floor_d_y)/floor_lift
    floor_unloading_force = floor_peak_force*floor_share*ca.sqrt(floor_share)
    floor_elastic_force = ca.if_else(-floor_gap > floor_dent, ca.if_else(floor_stage < 0, floor_unloading_force, floor_loading_force), 0)
    floor_plastic_force = ca.if_else(floor_stage < 0, 0, ca.if_else(floor_stage_number < 1, 0, floor_F_y + x2 + k4*base*base/(floor_loaded_depth*ca.sqrt(floor_loaded_depth)) - k5*base/ca.sqrt(floor_loaded_depth)))
    floor_plastic_power = -floor_plastic_force*vertical_speed
    floor_in_range = ca.if_else(-floor_gap <= radius, 1, 0)
    return (ca.vertcat(floor_elastic_force), ca.vertcat(floor_plastic_power), ca.vertcat(floor_elastic_force), ca.vertcat(),
        ca.vertcat(floor_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (1,): vertical [N]
    """
    gravity, total_mass = c[1], c[7]
    return ca.vertcat(-total_mass*gravity)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): vertical.acceleration [m/s^2]
        reactions (0,): empty
    """
    inverse_total_mass = c[13]
    vertical_force = f[0]
    vertical_acc = inverse_total_mass*vertical_force
    return ca.vertcat(vertical_acc), ca.vertcat()


def margins(t, q, u, c):
    """Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        margin (4,): floor.yields [1], floor.unloads [1], floor.reloads [1], floor.parts [1]
    """
    radius, floor_d_y, floor_pace = c[0], c[4], c[6]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_stage, floor_deepest = q[1], q[2]
    floor_gap = vertical_travel - radius
    return ca.vertcat(ca.if_else(floor_stage < 0, 1, ca.if_else(floor_stage < 1, 1 + floor_gap/floor_d_y, 1)), ca.if_else(floor_stage > 0,
        -vertical_speed/floor_pace, 1), ca.if_else(floor_stage < 0, (floor_gap + 1.000000000001*floor_deepest)/floor_d_y, 1),
        ca.if_else(floor_stage < 0, -floor_gap/floor_d_y, 1))


def jumps(t, q, u, c):
    """Values of the states that each event changes, event by event, by the values before it.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        then (8,): floor.stage [1], floor.stage [1], floor.deepest [m], floor.dent [m], floor.stage [1], floor.stage [1], floor.deepest [m],
            floor.dent [m]
    """
    radius, floor_K, floor_p_y, floor_d_y, floor_F_y = c[0], c[2], c[3], c[4], c[5]
    vertical_travel, floor_stage = q[0], q[1]
    floor_gap = vertical_travel - radius
    floor_yielded_depth = ca.if_else(-floor_gap > floor_d_y, -floor_gap, floor_d_y)
    return ca.vertcat(ca.if_else(floor_stage < 1, 1, 1 + floor_stage), -floor_stage, -floor_gap, floor_yielded_depth - (floor_F_y +
        3.141592653589793*floor_p_y*(floor_yielded_depth - floor_d_y)*radius)/(floor_K*ca.sqrt(floor_yielded_depth)), -floor_stage, 0, 0, 0)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (1,): MEMORY [W]
    """
    return ca.vertcat(0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    radius, floor_K, floor_d_y, floor_F_y, pi_times_floor_p_y_times_radius, two_fifths_of_floor_K = c[0], c[2], c[4], c[5], c[8], c[9]
    two_fifths_of_inverse_floor_K, k7, k8 = c[10], c[14], c[15]
    vertical_travel = q[0]
    vertical_speed = u[0]
    floor_stage, floor_deepest, floor_dent = q[1], q[2], q[3]
    floor_gap = vertical_travel - radius
    floor_stage_number = ca.if_else(floor_stage < 0, -floor_stage, floor_stage)
    floor_loaded_depth = ca.if_else(-floor_gap > 0, -floor_gap, floor_d_y)
    floor_turned_depth = ca.if_else(floor_stage < 0, floor_deepest, floor_d_y)
    floor_peak_force = ca.if_else(floor_stage_number < 1, floor_K*floor_turned_depth*ca.sqrt(floor_turned_depth), floor_F_y + pi_times_floor_p_y_times_radius*(floor_turned_depth - floor_d_y))
    floor_lift = ca.if_else(floor_stage < 0, floor_deepest - floor_dent, floor_d_y)
    floor_share = ca.if_else(floor_stage < 0, ca.if_else(-floor_gap > floor_dent, -floor_dent - floor_gap, 0), floor_d_y)/floor_lift
    floor_unloading_force = floor_peak_force*floor_share*ca.sqrt(floor_share)
    base = floor_F_y + pi_times_floor_p_y_times_radius*(floor_loaded_depth - floor_d_y)
    floor_stored_energy = ca.if_else(-floor_gap > floor_dent, ca.if_else(floor_stage < 0, 2*floor_lift*floor_share*floor_unloading_force/5, ca.if_else(floor_stage_number < 1, two_fifths_of_floor_K*floor_loaded_depth*floor_loaded_depth*ca.sqrt(floor_loaded_depth), two_fifths_of_inverse_floor_K*base*base/ca.sqrt(floor_loaded_depth))), 0)
    kinetic = k7*vertical_speed*vertical_speed
    potential = k8*vertical_travel
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(floor_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball.x [m], ball.y [m], ball.z [m]
        rotations (9,): ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy
            [1], ball.R_zz [1]
    """
    vertical_travel = q[0]
    return ca.vertcat(0, vertical_travel, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (1,): OUTPUTS
    """
    radius = c[0]
    vertical_travel = q[0]
    floor_gap = vertical_travel - radius
    return ca.vertcat(floor_gap)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        vertical.parent, vertical.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        floor.sphere (4,): x [m], y [m], z [m], radius [m]
        floor.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        ball.centre (3,): x [m], y [m], z [m]
        ball.shape_1 (4,): x [m], y [m], z [m], radius [m]
    """
    radius = p[0]
    return (ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0, radius))
