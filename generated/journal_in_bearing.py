"""journal_in_bearing: loaded journal turning in a bush with clearance. Generated from derive/scenes/journal_in_bearing.py.

Do not edit; regenerate with `hertzwerk derive journal_in_bearing`.
Effects:
    motor: constant speed of shaft.angle
    load: force on journal = (0, -load, 0) in axes of ground
    bearing: power x flores
    bearing_friction: smooth_coulomb at bearing
    energy_ledger: work put in, energy dissipated per effect
Units: 42 assignments and 116 outputs checked, all consistent
Operations: flight 29 (equations of motion and gaps); in contact also contact_bearing 43
"""

import casadi as ca

NAME = "journal_in_bearing"
SOURCE = "derive/scenes/journal_in_bearing.py"
SUMMARY = "loaded journal turning in a bush with clearance"
FORMAT = "hertzwerk module 1"
DIGEST = "849a900b2f4e57e6be5871751be3a831"

EFFECTS = (
    ("motor", "drive", "constant speed of shaft.angle"), ("load", "force", "force on journal = (0, -load, 0) in axes of ground"),
    ("bearing", "contact", "power x flores"), ("bearing_friction", "friction", "smooth_coulomb at bearing"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("mass", "kg", 1.0, "of the journal and what it carries"),
    ("inertia", "kg m^2", 0.0001, "body journal, inertia"),
    ("bush_radius", "mm", 10, "pair bearing, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus journal radius"),
    ("speed", "rpm", 100, "of the journal"),
    ("load", "N", 500, "downwards"),
    ("contact_stiffness", "N/m^exponent", 10000000000.0, "effect bearing, stiffness of power"),
    ("exponent", "1", 1.5, "exponent of the force law"),
    ("restitution", "1", 0.5, "effect bearing, coefficient of restitution of flores"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.2, "effect bearing_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect bearing_friction, speed over which the friction force builds up of smooth_coulomb"),
)

LIMITS = (
    ("mass", "defined", 0, None, True, False, "body journal, mass"),
    ("inertia", "defined", 0, None, False, False, "body journal, inertia"),
    ("bush_radius", "defined", 0, None, True, False, "pair bearing, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair bearing, clearance"),
    ("contact_stiffness", "defined", 0, None, True, False, "effect bearing, stiffness of power"),
    ("exponent", "defined", 1, 10, False, False, "effect bearing, exponent of power"),
    ("restitution", "defined", 0, 1, True, False, "effect bearing, coefficient of restitution of flores"),
    ("approach_floor", "defined", 0, None, True, False, "effect bearing, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect bearing_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect bearing_friction, speed over which the friction force builds up of smooth_coulomb"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair bearing, pin radius (bush radius minus clearance)"),
)

COORDINATES = (("shaft.x", "m"), ("shaft.y", "m"))

SPEEDS = (("shaft.x_speed", "m/s"), ("shaft.y_speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("load.input", "J"), ("bearing.dissipated", "J"), ("bearing_friction.dissipated", "J"))

LATCHES = (("bearing.approach_speed", "m/s", 0),)

PAIRS = (("bearing", "pin_in_bush"),)

RELEASES = ("force",)

DISSIPATED = (2,)

OUTPUTS = (("bearing.eccentricity_x", "m"), ("bearing.eccentricity_y", "m"))

BODIES = ("journal",)

LANDMARKS = (
    ("shaft", "planar", "parent", "ground", ("normal",)), ("shaft", "planar", "child", "journal", ("normal",)),
    ("bearing", "pin_in_bush", "pin", "journal", ("radius",)), ("bearing", "pin_in_bush", "bush", "ground", ("radius", "axis")),
    ("motor", "turn_drive", "child", "journal", ("axis",)), ("load", "force", "point", "journal", ()),
    ("load", "force", "axes", "ground", ("force",)), ("journal", "body", "centre", "journal", ()),
)

CONSTANTS = (
    ("clearance", "m"), ("speed", "1/s"), ("load", "N"), ("contact_stiffness", "N/m^exponent"), ("exponent", "1"),
    ("friction_coefficient", "1"), ("clearance_squared", "m^2"), ("half_inverse_clearance", "1/m"), ("k3", "N/m^exponent"),
    ("bearing_hysteresis_factor", "1"), ("k4", "m/s"), ("inverse_friction_speed", "s/m"), ("bush_radius_minus_clearance", "m"),
    ("inverse_mass", "1/kg"), ("half_mass", "kg"), ("half_speed_squared_times_inertia", "J"),
)

OPERATIONS = (
    ("constants", 18), ("start", 0), ("scales", 7), ("coordinate_rates", 0), ("gaps", 12), ("gap_accelerations", 13),
    ("contact_bearing", 43), ("applied", 1), ("accelerations", 3), ("ledger", 3), ("energy", 15), ("poses", 4), ("outputs", 0),
    ("period", 3), ("landmarks", 2),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = GIVEN = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (16,): clearance, speed, load, contact_stiffness, exponent, friction_coefficient, clearance_squared, half_inverse_clearance, k3,
            bearing_hysteresis_factor, k4, inverse_friction_speed, bush_radius_minus_clearance, inverse_mass, half_mass,
            half_speed_squared_times_inertia
    """
    mass, inertia, bush_radius, clearance, speed, load, contact_stiffness, exponent = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    restitution, friction_coefficient, friction_speed = p[8], p[10], p[11]
    clearance_squared = clearance*clearance
    half_inverse_clearance = 1/(2*clearance)
    k3 = contact_stiffness/(1 + exponent)
    bearing_hysteresis_factor = (8 - 8*restitution)/(5*restitution)
    bush_radius_minus_clearance = bush_radius - clearance
    k4 = -bush_radius_minus_clearance*speed
    inverse_friction_speed = 1/friction_speed
    inverse_mass = 1/mass
    half_mass = mass/2
    half_speed_squared_times_inertia = speed*speed*inertia/2
    return ca.vertcat(clearance, speed, load, contact_stiffness, exponent, friction_coefficient, clearance_squared, half_inverse_clearance,
        k3, bearing_hysteresis_factor, k4, inverse_friction_speed, bush_radius_minus_clearance, inverse_mass, half_mass,
        half_speed_squared_times_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (2,): COORDINATES
        u (2,): SPEEDS
    """
    return ca.vertcat(0, 0), ca.vertcat(0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (2,): COORDINATES
        su (2,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    mass, bush_radius, clearance, speed = p[0], p[2], p[3], p[4]
    energy_scale = bush_radius*bush_radius*speed*speed*mass/2
    force_scale = energy_scale/clearance
    bush_radius_times_speed = bush_radius*speed
    return (ca.vertcat(clearance, clearance), ca.vertcat(bush_radius_times_speed, bush_radius_times_speed),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(clearance, bush_radius_times_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (2,): COORDINATES [m/s]
    """
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    return ca.vertcat(shaft_x_speed, shaft_y_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    clearance_squared, half_inverse_clearance = c[6], c[7]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    bearing_apart_squared = shaft_x*shaft_x + shaft_y*shaft_y
    bearing_gap = half_inverse_clearance*(clearance_squared - bearing_apart_squared)
    bearing_apart_squared_rate = 2*shaft_x*shaft_x_speed + 2*shaft_y*shaft_y_speed
    bearing_gap_rate = -bearing_apart_squared_rate*half_inverse_clearance
    return ca.vertcat(bearing_gap), ca.vertcat(bearing_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    half_inverse_clearance = c[7]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    shaft_x_acceleration, shaft_y_acceleration = a[0], a[1]
    bearing_apart_squared_rate_rate = 2*shaft_x_speed*shaft_x_speed + 2*shaft_y_speed*shaft_y_speed + 2*shaft_x*shaft_x_acceleration + 2*shaft_y*shaft_y_acceleration
    bearing_gap_rate_rate = -bearing_apart_squared_rate_rate*half_inverse_clearance
    return ca.vertcat(bearing_gap_rate_rate)


def contact_bearing(t, q, u, z, m, c):
    """Forces of bearing: power x flores, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the contact
    ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): shaft.x [N], shaft.y [N], shaft.angle [N m]
        dz (4,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    clearance, contact_stiffness, exponent, friction_coefficient, bearing_hysteresis_factor, k4 = c[0], c[3], c[4], c[5], c[9], c[10]
    inverse_friction_speed, bush_radius_minus_clearance = c[11], c[12]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    bearing_approach_speed = m[0]
    bearing_apart_squared = shaft_x*shaft_x + shaft_y*shaft_y
    bearing_distance = ca.sqrt(bearing_apart_squared)
    bearing_penetration = bearing_distance - clearance
    bearing_elastic_force = ca.if_else(bearing_penetration > 0, bearing_penetration**exponent*contact_stiffness, 0)
    bearing_normal_x = -shaft_x/bearing_distance
    bearing_normal_y = -shaft_y/bearing_distance
    bearing_penetration_rate = -bearing_normal_x*shaft_x_speed - bearing_normal_y*shaft_y_speed
    bearing_resistance = bearing_elastic_force*bearing_hysteresis_factor*bearing_penetration_rate/bearing_approach_speed
    bearing_normal_force = bearing_elastic_force + bearing_resistance
    bearing_normal_power = bearing_penetration_rate*bearing_resistance
    bearing_push_x = bearing_normal_force*bearing_normal_x
    bearing_push_y = bearing_normal_force*bearing_normal_y
    bearing_sliding_velocity = k4 + bearing_normal_x*shaft_y_speed - bearing_normal_y*shaft_x_speed
    bearing_friction_force = bearing_normal_force*friction_coefficient*ca.tanh(bearing_sliding_velocity*inverse_friction_speed)
    bearing_friction_power = bearing_friction_force*bearing_sliding_velocity
    bearing_drag_x = bearing_friction_force*bearing_normal_y
    bearing_drag_y = -bearing_friction_force*bearing_normal_x
    bearing_drag_on_shaft_angle = bearing_drag_x*bearing_normal_y*bush_radius_minus_clearance - bearing_drag_y*bearing_normal_x*bush_radius_minus_clearance
    return (ca.vertcat(bearing_drag_x + bearing_push_x, bearing_drag_y + bearing_push_y, bearing_drag_on_shaft_angle),
        ca.vertcat(0, 0, bearing_normal_power, bearing_friction_power), ca.vertcat(bearing_normal_force),
        ca.vertcat(bearing_sliding_velocity), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (3,): shaft.x [N], shaft.y [N], shaft.angle [N m]
    """
    load = c[2]
    return ca.vertcat(0, -load, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): shaft.x_acceleration [m/s^2], shaft.y_acceleration [m/s^2]
        reactions (1,): shaft.angle.reaction [N m]
    """
    inverse_mass = c[13]
    shaft_x_force, shaft_y_force, shaft_angle_force = f[0], f[1], f[2]
    shaft_x_acc = inverse_mass*shaft_x_force
    shaft_y_acc = inverse_mass*shaft_y_force
    return ca.vertcat(shaft_x_acc, shaft_y_acc), ca.vertcat(-shaft_angle_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    speed, load = c[1], c[2]
    shaft_y_speed = u[1]
    shaft_angle_reaction_in = reactions[0]
    return ca.vertcat(shaft_angle_reaction_in*speed, -shaft_y_speed*load, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    clearance, exponent, k3, half_mass, half_speed_squared_times_inertia = c[0], c[4], c[8], c[14], c[15]
    shaft_x, shaft_y = q[0], q[1]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    bearing_apart_squared = shaft_x*shaft_x + shaft_y*shaft_y
    bearing_distance = ca.sqrt(bearing_apart_squared)
    bearing_penetration = bearing_distance - clearance
    bearing_stored_energy = ca.if_else(bearing_penetration > 0, k3*bearing_penetration**(1 + exponent), 0)
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
        y (2,): OUTPUTS
    """
    shaft_x, shaft_y = q[0], q[1]
    return ca.vertcat(shaft_x, shaft_y)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    speed = p[4]
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
    bush_radius, clearance, load = p[2], p[3], p[5]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, bush_radius - clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0, 0, -load, 0),
        ca.vertcat(0, 0, 0))
