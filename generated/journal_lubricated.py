"""journal_lubricated: loaded journal on the oil film of a short bearing. Generated from derive/scenes/journal_lubricated.py.

Do not edit; regenerate with `hertzwerk derive journal_lubricated`.
Effects:
    motor: constant speed of shaft.angle
    load: force on journal = (0, -load, 0) in axes of ground
    bearing: power x flores
    oil: short_bearing film at bearing
    energy_ledger: work put in, energy dissipated per effect
Units: 78 assignments and 132 outputs checked, all consistent
Operations: flight 135 (equations of motion and gaps); in contact also contact_bearing 25
"""

import casadi as ca

NAME = "journal_lubricated"
SOURCE = "derive/scenes/journal_lubricated.py"
SUMMARY = "loaded journal on the oil film of a short bearing"
FORMAT = "hertzwerk module 1"
DIGEST = "b783e21bcf025530ec3d3c5131b00fee"

EFFECTS = (
    ("motor", "drive", "constant speed of shaft.angle"), ("load", "force", "force on journal = (0, -load, 0) in axes of ground"),
    ("bearing", "contact", "power x flores"), ("oil", "lubrication", "short_bearing film at bearing"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 2.0, "of the journal and what it carries"),
    ("inertia", "kg m^2", 0.0004, "body journal, inertia"),
    ("bush_radius", "mm", 20, "pair bearing, bush radius"),
    ("clearance", "um", 50, "bush radius minus journal radius"),
    ("length", "mm", 10, "pair bearing, length"),
    ("speed", "rpm", 1500, "of the journal"),
    ("load", "N", 300, "downwards"),
    ("contact_stiffness", "N/m^1.5", 10000000000.0, "effect bearing, stiffness of power"),
    ("restitution", "1", 0.5, "effect bearing, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("viscosity", "Pa s", 0.05, "effect oil, dynamic viscosity of short_bearing"),
    ("boundary_layer", "um", 0.5, "effect oil, boundary layer"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body journal, mass"),
    ("inertia", "defined", 0, None, False, False, "body journal, inertia"),
    ("bush_radius", "defined", 0, None, True, False, "pair bearing, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair bearing, clearance"),
    ("length", "defined", 0, None, True, False, "pair bearing, length"),
    ("contact_stiffness", "defined", 0, None, True, False, "effect bearing, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect bearing, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect bearing, approach floor"),
    ("viscosity", "defined", 0, None, True, False, "effect oil, dynamic viscosity of short_bearing"),
    ("boundary_layer", "defined", 0, None, True, False, "effect oil, boundary layer"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair bearing, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("shaft.x", "m"), ("shaft.y", "m"), ("oil.seams", "1"))

SPEEDS = (("shaft.x_speed", "m/s"), ("shaft.y_speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("load.input", "J"), ("bearing.dissipated", "J"), ("oil.dissipated", "J"))

LATCHES = (("bearing.approach_speed", "m/s", 0),)

PAIRS = (("bearing", "pin_in_bush"),)

EVENTS = (("oil.seam", (2,)),)

RELEASES = ("force",)

DISSIPATED = (2,)

GIVEN = ("oil.seams",)

OUTPUTS = (("bearing.eccentricity_x", "m"), ("bearing.eccentricity_y", "m"), ("oil.force", "N"), ("oil.thickness", "m"))

BODIES = ("journal",)

LANDMARKS = (
    ("shaft", "planar", "parent", "ground", ("normal",)), ("shaft", "planar", "child", "journal", ("normal",)),
    ("bearing", "pin_in_bush", "pin", "journal", ("radius",)), ("bearing", "pin_in_bush", "bush", "ground", ("radius", "axis")),
    ("motor", "turn_drive", "child", "journal", ("axis",)), ("load", "force", "point", "journal", ()),
    ("load", "force", "axes", "ground", ("force",)), ("journal", "body", "centre", "journal", ()),
)

CONSTANTS = (
    ("clearance", "m"), ("speed", "1/s"), ("load", "N"), ("contact_stiffness", "N/m^1.5"), ("boundary_layer", "m"), ("half_speed", "1/s"),
    ("oil_free", "1"), ("inverse_clearance_squared", "1/m^2"), ("oil_free_squared", "1"), ("half_clearance_over_boundary_layer", "1"),
    ("twice_boundary_layer_over_clearance", "1"), ("clearance_over_boundary_layer", "1"), ("inverse_clearance", "1/m"),
    ("bush_radius_squared_times_speed_squared", "m^2/s^2"), ("half_pi", "1"), ("k10", "N s/m"), ("k11", "J s"), ("k12", "1"), ("k13", "1"),
    ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"), ("two_fifths_of_contact_stiffness", "N/m^1.5"),
    ("bearing_hysteresis_factor", "1"), ("inverse_mass", "1/kg"), ("half_mass", "kg"), ("half_speed_squared_times_inertia", "J"),
)

OPERATIONS = (
    ("constants", 48), ("start", 0), ("scales", 7), ("coordinate_rates", 0), ("gaps", 12), ("gap_accelerations", 13),
    ("contact_bearing", 25), ("applied", 107), ("accelerations", 3), ("margins", 15), ("jumps", 13), ("ledger", 109), ("energy", 16),
    ("poses", 4), ("outputs", 104), ("period", 3), ("landmarks", 2),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LOADS = FED = RUBBING = GUIDES = SLIPS = CONSTRAINTS = ()
ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (26,): clearance, speed, load, contact_stiffness, boundary_layer, half_speed, oil_free, inverse_clearance_squared,
            oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance, clearance_over_boundary_layer,
            inverse_clearance, bush_radius_squared_times_speed_squared, half_pi, k10, k11, k12, k13, clearance_squared,
            half_inverse_clearance, two_fifths_of_contact_stiffness, bearing_hysteresis_factor, inverse_mass, half_mass,
            half_speed_squared_times_inertia
    """
    mass, inertia, bush_radius, clearance, length, speed, load, contact_stiffness = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    restitution, viscosity, boundary_layer = p[8], p[10], p[11]
    half_speed = speed/2
    minus_twice_boundary_layer_over_clearance = -2*boundary_layer/clearance
    oil_free = 1 + minus_twice_boundary_layer_over_clearance
    inverse_clearance_squared = 1/(clearance*clearance)
    oil_free_squared = oil_free*oil_free
    half_clearance_over_boundary_layer = clearance/(2*boundary_layer)
    twice_boundary_layer_over_clearance = 2*boundary_layer/clearance
    clearance_over_boundary_layer = clearance/boundary_layer
    inverse_clearance = 1/clearance
    speed_squared = speed*speed
    bush_radius_squared_times_speed_squared = speed_squared*bush_radius*bush_radius
    half_pi = 3.141592653589793/2
    bush_radius_minus_clearance = bush_radius - clearance
    k10 = bush_radius_minus_clearance*length*length*length*viscosity/(clearance*clearance*clearance)
    k11 = 2*3.141592653589793*inverse_clearance*bush_radius_minus_clearance*bush_radius_minus_clearance*bush_radius_minus_clearance*length*viscosity
    k12 = 2 + minus_twice_boundary_layer_over_clearance
    k13 = -1 - inverse_clearance*boundary_layer/2
    clearance_squared = clearance*clearance
    half_inverse_clearance = inverse_clearance/2
    two_fifths_of_contact_stiffness = 2*contact_stiffness/5
    bearing_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    inverse_mass = 1/mass
    half_mass = mass/2
    half_speed_squared_times_inertia = speed_squared*inertia/2
    return ca.vertcat(clearance, speed, load, contact_stiffness, boundary_layer, half_speed, oil_free, inverse_clearance_squared,
        oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance, clearance_over_boundary_layer,
        inverse_clearance, bush_radius_squared_times_speed_squared, half_pi, k10, k11, k12, k13, clearance_squared, half_inverse_clearance,
        two_fifths_of_contact_stiffness, bearing_hysteresis_factor, inverse_mass, half_mass, half_speed_squared_times_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (2,): SPEEDS
    """
    return ca.vertcat(0, 0, 0), ca.vertcat(0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (2,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, bush_radius, clearance, speed = p[0], p[2], p[3], p[5]
    energy_scale = bush_radius*bush_radius*speed*speed*mass/2
    force_scale = energy_scale/clearance
    bush_radius_times_speed = bush_radius*speed
    return (ca.vertcat(clearance, clearance, 1), ca.vertcat(bush_radius_times_speed, bush_radius_times_speed),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(clearance, bush_radius_times_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): shaft.x [m/s], shaft.y [m/s], oil.seams [1/s]
    """
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    return ca.vertcat(shaft_x_speed, shaft_y_speed, 0)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    clearance_squared, half_inverse_clearance = c[19], c[20]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    bearing_gap = half_inverse_clearance*(clearance_squared - oil_e_squared)
    oil_e_squared_rate = 2*shaft_x*shaft_x_speed + 2*shaft_y*shaft_y_speed
    bearing_gap_rate = -half_inverse_clearance*oil_e_squared_rate
    return ca.vertcat(bearing_gap), ca.vertcat(bearing_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    half_inverse_clearance = c[20]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    shaft_x_acceleration, shaft_y_acceleration = a[0], a[1]
    oil_e_squared_rate_rate = 2*shaft_x_speed*shaft_x_speed + 2*shaft_y_speed*shaft_y_speed + 2*shaft_x*shaft_x_acceleration + 2*shaft_y*shaft_y_acceleration
    bearing_gap_rate_rate = -half_inverse_clearance*oil_e_squared_rate_rate
    return ca.vertcat(bearing_gap_rate_rate)


def contact_bearing(t, q, u, z, m, c):
    """Forces of bearing: power x flores. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): shaft.x [N], shaft.y [N], shaft.angle [N m]
        dz (4,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    clearance, contact_stiffness, bearing_hysteresis_factor = c[0], c[3], c[22]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    bearing_approach_speed = m[0]
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_e_size = ca.sqrt(oil_e_squared)
    bearing_penetration = oil_e_size - clearance
    bearing_elastic_force = ca.if_else(bearing_penetration > 0, bearing_penetration*ca.sqrt(bearing_penetration)*contact_stiffness, 0)
    bearing_normal_x = -shaft_x/oil_e_size
    bearing_normal_y = -shaft_y/oil_e_size
    bearing_penetration_rate = -bearing_normal_x*shaft_x_speed - bearing_normal_y*shaft_y_speed
    bearing_resistance = bearing_elastic_force*bearing_hysteresis_factor*bearing_penetration_rate/bearing_approach_speed
    bearing_normal_force = bearing_elastic_force + bearing_resistance
    bearing_normal_power = bearing_penetration_rate*bearing_resistance
    bearing_push_x = bearing_normal_force*bearing_normal_x
    bearing_push_y = bearing_normal_force*bearing_normal_y
    return (ca.vertcat(bearing_push_x, bearing_push_y, 0), ca.vertcat(0, 0, bearing_normal_power, 0), ca.vertcat(bearing_normal_force),
        ca.vertcat(), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): shaft.x [N], shaft.y [N], shaft.angle [N m]
    """
    clearance, speed, load, boundary_layer, half_speed, oil_free, inverse_clearance_squared = c[0], c[1], c[2], c[4], c[5], c[6], c[7]
    oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance = c[8], c[9], c[10]
    clearance_over_boundary_layer, inverse_clearance, bush_radius_squared_times_speed_squared, half_pi = c[11], c[12], c[13], c[14]
    k10, k11 = c[15], c[16]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    oil_squeeze_x = shaft_x_speed + half_speed*shaft_y
    oil_squeeze_y = shaft_y_speed - half_speed*shaft_x
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, bush_radius_squared_times_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*shaft_x + oil_squeeze_y*shaft_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*shaft_y - oil_squeeze_y*shaft_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k10*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k10*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_drag_spin = k11/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_couple = -oil_drag_spin*oil_share*speed
    oil_on_shaft_angle = oil_force_x*shaft_y/2 - oil_force_y*shaft_x/2
    return ca.vertcat(oil_force_x, oil_force_y - load, oil_couple + oil_on_shaft_angle)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): shaft.x_acceleration [m/s^2], shaft.y_acceleration [m/s^2]
        reactions (1,): shaft.angle.reaction [N m]
    """
    inverse_mass = c[23]
    shaft_x_force, shaft_y_force, shaft_angle_force = f[0], f[1], f[2]
    shaft_x_acc = inverse_mass*shaft_x_force
    shaft_y_acc = inverse_mass*shaft_y_force
    return ca.vertcat(shaft_x_acc, shaft_y_acc), ca.vertcat(-shaft_angle_force)


def margins(t, q, u, c):
    """Margin of every event of an effect, beside its size: positive until it happens, see EVENTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        margin (1,): oil.seam [1]
    """
    inverse_clearance_squared, half_clearance_over_boundary_layer, k12, k13 = c[7], c[9], c[17], c[18]
    shaft_x, shaft_y, oil_seams = q[0], q[1], q[2]
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    oil_epsilon_squared_minus_one = oil_epsilon_squared - 1
    x2 = half_clearance_over_boundary_layer*oil_epsilon_squared_minus_one
    oil_past_0 = k12 + x2
    oil_past_1 = k13 + x2
    return ca.vertcat(ca.if_else(oil_seams > 0, oil_past_0, -oil_past_0)*ca.if_else(oil_seams > 1, oil_past_1, -oil_past_1))


def jumps(t, q, u, c):
    """Values of the states that each event changes, event by event, by the values before it.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        then (1,): oil.seams [1]
    """
    inverse_clearance_squared, half_clearance_over_boundary_layer, k12, k13 = c[7], c[9], c[17], c[18]
    shaft_x, shaft_y = q[0], q[1]
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    oil_epsilon_squared_minus_one = oil_epsilon_squared - 1
    x2 = half_clearance_over_boundary_layer*oil_epsilon_squared_minus_one
    oil_past_0 = k12 + x2
    oil_past_1 = k13 + x2
    return ca.vertcat(ca.if_else(oil_past_0 >= 0, 1, 0) + ca.if_else(oil_past_1 >= 0, 1, 0))


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    clearance, speed, load, boundary_layer, half_speed, oil_free, inverse_clearance_squared = c[0], c[1], c[2], c[4], c[5], c[6], c[7]
    oil_free_squared, half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance = c[8], c[9], c[10]
    clearance_over_boundary_layer, inverse_clearance, bush_radius_squared_times_speed_squared, half_pi = c[11], c[12], c[13], c[14]
    k10, k11 = c[15], c[16]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    shaft_angle_reaction_in = reactions[0]
    oil_squeeze_x = shaft_x_speed + half_speed*shaft_y
    oil_squeeze_y = shaft_y_speed - half_speed*shaft_x
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, bush_radius_squared_times_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*shaft_x + oil_squeeze_y*shaft_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*shaft_y - oil_squeeze_y*shaft_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k10*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k10*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_drag_spin = k11/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_couple = -oil_drag_spin*oil_share*speed
    oil_power = -oil_couple*speed - oil_force_x*oil_squeeze_x - oil_force_y*oil_squeeze_y
    return ca.vertcat(shaft_angle_reaction_in*speed, -shaft_y_speed*load, 0, oil_power)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    clearance, two_fifths_of_contact_stiffness, half_mass, half_speed_squared_times_inertia = c[0], c[21], c[24], c[25]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_e_size = ca.sqrt(oil_e_squared)
    bearing_penetration = oil_e_size - clearance
    bearing_stored_energy = ca.if_else(bearing_penetration > 0, two_fifths_of_contact_stiffness*bearing_penetration*bearing_penetration*ca.sqrt(bearing_penetration), 0)
    kinetic = half_speed_squared_times_inertia + half_mass*(shaft_x_speed*shaft_x_speed + shaft_y_speed*shaft_y_speed)
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(bearing_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): journal.x [m], journal.y [m], journal.z [m]
        rotations (9,): journal.R_xx [1], journal.R_xy [1], journal.R_xz [1], journal.R_yx [1], journal.R_yy [1], journal.R_yz [1],
            journal.R_zx [1], journal.R_zy [1], journal.R_zz [1]
    """
    speed = c[1]
    shaft_x, shaft_y = q[0], q[1]
    journal_angle = t*speed
    cos_journal = ca.cos(journal_angle)
    sin_journal = ca.sin(journal_angle)
    return ca.vertcat(shaft_x, shaft_y, 0), ca.vertcat(cos_journal, -sin_journal, 0, sin_journal, cos_journal, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (4,): OUTPUTS
    """
    clearance, boundary_layer, half_speed, oil_free, inverse_clearance_squared, oil_free_squared = c[0], c[4], c[5], c[6], c[7], c[8]
    half_clearance_over_boundary_layer, twice_boundary_layer_over_clearance, clearance_over_boundary_layer = c[9], c[10], c[11]
    inverse_clearance, bush_radius_squared_times_speed_squared, half_pi, k10 = c[12], c[13], c[14], c[15]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    oil_squeeze_x = shaft_x_speed + half_speed*shaft_y
    oil_squeeze_y = shaft_y_speed - half_speed*shaft_x
    oil_e_squared = shaft_x*shaft_x + shaft_y*shaft_y
    oil_epsilon_squared = inverse_clearance_squared*oil_e_squared
    base = ca.if_else(oil_epsilon_squared > oil_free*oil_free, oil_epsilon_squared, oil_free_squared)
    oil_epsilon = ca.sqrt(base)
    oil_thinning = ca.if_else(oil_epsilon_squared < 1, half_clearance_over_boundary_layer*(oil_epsilon - oil_free), 1)
    oil_limited = oil_free + twice_boundary_layer_over_clearance*oil_thinning*(1 - oil_thinning*oil_thinning*(1 - oil_thinning/2))
    oil_sinking = ca.if_else(oil_epsilon_squared > 1, clearance_over_boundary_layer*(oil_epsilon - 1), 0)
    oil_per_e = inverse_clearance*oil_limited/oil_epsilon
    oil_share = ca.if_else(oil_epsilon_squared < (1 + boundary_layer/clearance)**2, 1 - oil_sinking*oil_sinking*(3 - 2*oil_sinking), 0)
    oil_squeeze_squared = oil_squeeze_x*oil_squeeze_x + oil_squeeze_y*oil_squeeze_y
    base_2 = ca.if_else(oil_squeeze_squared > 0, oil_squeeze_squared, bush_radius_squared_times_speed_squared)
    oil_squeeze_speed = ca.sqrt(base_2)
    oil_epsilon_w = oil_per_e*(oil_squeeze_x*shaft_x + oil_squeeze_y*shaft_y)/oil_squeeze_speed
    oil_epsilon_c = oil_per_e*(oil_squeeze_x*shaft_y - oil_squeeze_y*shaft_x)/oil_squeeze_speed
    oil_epsilon_w_squared = oil_epsilon_w*oil_epsilon_w
    oil_S = 1 - oil_epsilon_w_squared - oil_epsilon_c*oil_epsilon_c
    oil_q = ca.sqrt(oil_S)
    oil_A = half_pi + ca.atan(oil_epsilon_w/oil_q)
    inverse_oil_S_squared = 1/(oil_S*oil_S)
    oil_drag_along = k10*inverse_oil_S_squared*(oil_A*(oil_S + 3*oil_epsilon_w_squared) + 3*oil_epsilon_w*oil_q)/oil_q
    oil_drag_across = k10*oil_epsilon_c*inverse_oil_S_squared*(oil_q*(2 + oil_epsilon_w_squared/(oil_S + oil_epsilon_w_squared)) + 3*oil_A*oil_epsilon_w)/oil_q
    oil_force_x = -oil_share*(oil_drag_along*oil_squeeze_x - oil_drag_across*oil_squeeze_y)
    oil_force_y = -oil_share*(oil_drag_across*oil_squeeze_x + oil_drag_along*oil_squeeze_y)
    oil_e_size = ca.sqrt(oil_e_squared)
    oil_thickness = (1 - oil_e_size*oil_per_e)*clearance
    base_3 = oil_force_x*oil_force_x + oil_force_y*oil_force_y
    oil_force_size = ca.sqrt(base_3)
    return ca.vertcat(shaft_x, shaft_y, oil_force_size, oil_thickness)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    speed = p[5]
    return ca.vertcat(2*3.141592653589793/ca.fabs(speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        shaft.parent, shaft.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        bearing.pin (4,): x [m], y [m], z [m], radius [m]
        bearing.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        load.point (3,): x [m], y [m], z [m]
        load.axes (6,): x [m], y [m], z [m], force_x [N], force_y [N], force_z [N]
        journal.centre (3,): x [m], y [m], z [m]
    """
    bush_radius, clearance, load = p[2], p[3], p[6]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, bush_radius - clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0, 0, -load, 0),
        ca.vertcat(0, 0, 0))
