"""worn_track: ball that wears its track, to and fro. Generated from derive/scenes/worn_track.py.

Do not edit; regenerate with `hertzwerk derive worn_track`.
Effects:
    gravity: uniform gravity
    drive: harmonic motion of along
    plate: power x kelvin_voigt
    plate_friction: smooth_coulomb at plate
    wear: Archard's wear at plate
    energy_ledger: work put in, energy dissipated per effect
Units: 69 assignments and 305 outputs checked, all consistent
Operations: flight 267 (equations of motion and gaps); in contact also contact_plate 226
"""

import casadi as ca

NAME = "worn_track"
SOURCE = "derive/scenes/worn_track.py"
SUMMARY = "ball that wears its track, to and fro"
FORMAT = "hertzwerk module 1"
DIGEST = "b143c2db25bf48d49999424c59f85df1"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("drive", "drive", "harmonic motion of along"), ("plate", "contact", "power x kelvin_voigt"),
    ("plate_friction", "friction", "smooth_coulomb at plate"), ("wear", "wear", "Archard's wear at plate"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("carriage_mass", "kg", 0.5, "body carriage, mass"),
    ("load", "kg", 2.54841997961264, "dead weight on the ball, which moves with it"),
    ("radius", "mm", 4.7625, "of the ball"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stroke", "mm", 10, ""),
    ("pace", "rpm", 300, "strokes to and fro"),
    ("poissons_ratio", "1", 0.4, "of the plate"),
    ("youngs_modulus", "GPa", 0.8, "of the plate"),
    ("restitution", "1", 0.3, "effect plate, coefficient of restitution of kelvin_voigt"),
    ("friction", "1", 0.2, "effect plate_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "mm/s", 1, "effect plate_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("wear_rate", "mm^3/(N m)", 0.0001, "volume lost for each newton metre of the plate"),
    ("repetitions", "1", 1000, "strokes that one of the run stands for"),
    ("track", "mm", 16, "effect wear, track"),
)

LIMITS = (
    ("carriage_mass", "defined", 0, None, True, False, "body carriage, mass"),
    ("load", "defined", 0, None, True, False, "body ball, mass"),
    ("radius", "defined", 0, None, True, False, "pair plate, radius"),
    ("restitution", "defined", 0, 1, True, False, "effect plate, coefficient of restitution of kelvin_voigt"),
    ("friction", "defined", 0, None, False, False, "effect plate_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect plate_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("wear_rate", "defined", 0, None, False, False, "effect wear, second"),
    ("repetitions", "defined", 0, None, True, False, "effect wear, acceleration"),
    ("track", "defined", 0, None, True, False, "effect wear, track"),
)

COORDINATES = (
    ("down.travel", "m"), ("wear.track_1", "m"), ("wear.track_2", "m"), ("wear.track_3", "m"), ("wear.track_4", "m"), ("wear.track_5", "m"),
    ("wear.track_6", "m"), ("wear.track_7", "m"), ("wear.track_8", "m"), ("wear.track_9", "m"), ("wear.track_10", "m"),
    ("wear.track_11", "m"), ("wear.track_12", "m"), ("wear.track_13", "m"), ("wear.track_14", "m"), ("wear.track_15", "m"),
    ("wear.track_16", "m"), ("wear.track_17", "m"), ("wear.track_18", "m"), ("wear.track_19", "m"), ("wear.track_20", "m"),
    ("wear.track_21", "m"), ("wear.track_22", "m"), ("wear.track_23", "m"), ("wear.track_24", "m"), ("wear.track_25", "m"),
    ("wear.track_26", "m"), ("wear.track_27", "m"), ("wear.track_28", "m"), ("wear.track_29", "m"), ("wear.track_30", "m"),
    ("wear.track_31", "m"), ("wear.track_32", "m"), ("wear.load_path", "N m"),
)

SPEEDS = (("down.speed", "m/s"),)

MEMORY = (("energy_ledger.input", "J"), ("plate.dissipated", "J"), ("plate_friction.dissipated", "J"), ("wear.dissipated", "J"))

PAIRS = (("plate", "sphere_on_plane"),)

RELEASES = ("gap",)

DISSIPATED = (1,)

OUTPUTS = (("plate.gap", "m"), ("wear.volume", "m^3"))

BODIES = ("carriage", "ball")

LANDMARKS = (
    ("along", "prismatic", "parent", "ground", ("axis",)), ("along", "prismatic", "child", "carriage", ("axis",)),
    ("down", "prismatic", "parent", "carriage", ("axis",)), ("down", "prismatic", "child", "ball", ("axis",)),
    ("plate", "sphere_on_plane", "sphere", "ball", ("radius",)), ("plate", "sphere_on_plane", "plane", "ground", ("normal",)),
    ("gravity", "gravity", "direction", "ground", ("axis",)), ("drive", "slide_drive", "parent", "ground", ("axis",)),
    ("drive", "slide_drive", "child", "carriage", ()), ("carriage", "body", "centre", "carriage", ()),
    ("ball", "body", "centre", "ball", ()),
)

WORN = (
    (1, 2),
    (2, 3),
    (3, 4),
    (4, 5),
    (5, 6),
    (6, 7),
    (7, 8),
    (8, 9),
    (9, 10),
    (10, 11),
    (11, 12),
    (12, 13),
    (13, 14),
    (14, 15),
    (15, 16),
    (16, 17),
    (17, 18),
    (18, 19),
    (19, 20),
    (20, 21),
    (21, 22),
    (22, 23),
    (23, 24),
    (24, 25),
    (25, 26),
    (26, 27),
    (27, 28),
    (28, 29),
    (29, 30),
    (30, 31),
    (31, 32),
    (32, 33),
    (33, 34),
)

CONSTANTS = (
    ("load", "kg"), ("radius", "m"), ("gravity", "m/s^2"), ("pace", "1/s"), ("friction", "1"), ("wear_rate", "1/Pa"), ("repetitions", "1"),
    ("half_stroke", "m"), ("half_pace_times_stroke", "m/s"), ("half_pace_squared_times_stroke", "m/s^2"), ("twice_pi_over_track", "1/m"),
    ("total_mass", "kg"), ("k5", "N/m^1.5"), ("k6", "N/m^1.5"), ("twice_plate_xi", "1"), ("inverse_friction_speed", "s/m"),
    ("repetitions_times_wear_rate", "1/Pa"), ("k10", "1/m"), ("inverse_load", "1/kg"), ("half_carriage_mass", "kg"), ("half_load", "kg"),
    ("gravity_times_load", "N"),
)

OPERATIONS = (
    ("constants", 36), ("start", 13), ("scales", 34), ("coordinate_rates", 0), ("gaps", 128), ("gap_accelerations", 131),
    ("contact_plate", 226), ("applied", 1), ("accelerations", 7), ("ledger", 4), ("energy", 85), ("poses", 4), ("outputs", 68),
    ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = EVENTS = LOADS = FED = RUBBING = ()
GUIDES = SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def _shares(n, order, x, y):
    """Shares of n sectors, a power of 2, in the direction (x, y) of length 1: smooth, not negative, and 1 in all.

    Jackson's kernel, the fourth power of sin(n a/4)/sin(a/2) by the angle a from a sector's middle: a polynomial of cos(a) whose
    degree is below n, so that its samples have a constant sum. Order 1, 2: derivatives by the direction's angle. Functions of
    vectors, which are called: a loop over the sectors, where scalars would be thousands of operations.
    """
    if n not in _SHARES:
        towards, middles = ca.MX.sym("towards", 2), ca.DM(range(n))*(2*ca.pi/n)
        cosine, sine = ca.cos(middles), ca.sin(middles)
        w, dw = cosine*towards[0] + sine*towards[1], sine*towards[0] - cosine*towards[1]
        value, slope, bend, ddw, half = 1, 0, 0, -w, n//2
        while half > 1:
            f, df, ddf = (1 + w)/2, dw/2, ddw/2
            value, slope, bend = value*f, slope*f + value*df, bend*f + 2*slope*df + value*ddf
            w, dw, ddw, half = 2*w**2 - 1, 4*w*dw, 4*(dw**2 + w*ddw), half//2
        shares = [3/(4 + 8/n**2)*each for each in (value**2, 2*value*slope, 2*(slope**2 + value*bend))]
        _SHARES[n] = [ca.Function("shares", [towards], [each], {"never_inline": True}) for each in shares]
    return _SHARES[n][order](ca.vertcat(x, y))


_SHARES: "dict[int, list[ca.Function]]" = {}


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (22,): load, radius, gravity, pace, friction, wear_rate, repetitions, half_stroke, half_pace_times_stroke,
            half_pace_squared_times_stroke, twice_pi_over_track, total_mass, k5, k6, twice_plate_xi, inverse_friction_speed,
            repetitions_times_wear_rate, k10, inverse_load, half_carriage_mass, half_load, gravity_times_load
    """
    carriage_mass, load, radius, gravity, stroke, pace, poissons_ratio, youngs_modulus = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    restitution, friction, friction_speed, wear_rate, repetitions, track = p[8], p[9], p[10], p[11], p[12], p[13]
    half_stroke = stroke/2
    half_pace_times_stroke = pace*stroke/2
    half_pace_squared_times_stroke = pace*pace*stroke/2
    twice_pi_over_track = 2*3.141592653589793/track
    total_mass = carriage_mass + load
    poissons_ratio_squared = poissons_ratio*poissons_ratio
    minus_poissons_ratio_squared = -poissons_ratio_squared
    x3 = 1 + minus_poissons_ratio_squared
    sqrt_radius = ca.sqrt(radius)
    k5 = 4*sqrt_radius*youngs_modulus/(3*x3)
    k6 = 8*sqrt_radius*youngs_modulus/(15*x3)
    x5 = ca.log(restitution)
    plate_xi = -x5/ca.sqrt(3.141592653589793**2 + x5*x5)
    twice_plate_xi = 2*plate_xi
    inverse_friction_speed = 1/friction_speed
    repetitions_times_wear_rate = repetitions*wear_rate
    k10 = 32/track
    inverse_load = 1/load
    half_carriage_mass = carriage_mass/2
    half_load = load/2
    gravity_times_load = gravity*load
    return ca.vertcat(load, radius, gravity, pace, friction, wear_rate, repetitions, half_stroke, half_pace_times_stroke,
        half_pace_squared_times_stroke, twice_pi_over_track, total_mass, k5, k6, twice_plate_xi, inverse_friction_speed,
        repetitions_times_wear_rate, k10, inverse_load, half_carriage_mass, half_load, gravity_times_load)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (34,): COORDINATES
        u (1,): SPEEDS
    """
    load, radius, gravity, poissons_ratio, youngs_modulus = p[1], p[2], p[3], p[6], p[7]
    return (ca.vertcat(6**(2/3)*((1 - poissons_ratio*poissons_ratio)*gravity*load/(ca.sqrt(radius)*youngs_modulus))**(2/3)/4, *[0]*33),
        ca.vertcat(0))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (34,): COORDINATES
        su (1,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    carriage_mass, load, radius, gravity, stroke, pace, poissons_ratio, youngs_modulus = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    total_mass = carriage_mass + load
    pace_squared = pace*pace
    stroke_squared = stroke*stroke
    energy_scale = total_mass*pace_squared*stroke_squared/8
    inverse_sqrt_radius = 1/ca.sqrt(radius)
    poissons_ratio_squared = poissons_ratio*poissons_ratio
    minus_poissons_ratio_squared = -poissons_ratio_squared
    x6 = 1 + minus_poissons_ratio_squared
    x7 = inverse_sqrt_radius*x6*gravity*load/youngs_modulus
    force_scale = 2*energy_scale*6**(1/3)/(3*x7**(2/3))
    x8 = 6**(2/3)
    x9 = x7**(2/3)
    x10 = x8*x9/4
    x11 = pace*stroke/2
    return (ca.vertcat(*[x10]*33, total_mass*pace_squared*stroke_squared/8), ca.vertcat(x11),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale), ca.vertcat(x10, x11, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (34,): down.travel [m/s], wear.track_1 [m/s], wear.track_2 [m/s], wear.track_3 [m/s], wear.track_4 [m/s], wear.track_5 [m/s],
            wear.track_6 [m/s], wear.track_7 [m/s], wear.track_8 [m/s], wear.track_9 [m/s], wear.track_10 [m/s], wear.track_11 [m/s],
            wear.track_12 [m/s], wear.track_13 [m/s], wear.track_14 [m/s], wear.track_15 [m/s], wear.track_16 [m/s], wear.track_17 [m/s],
            wear.track_18 [m/s], wear.track_19 [m/s], wear.track_20 [m/s], wear.track_21 [m/s], wear.track_22 [m/s], wear.track_23 [m/s],
            wear.track_24 [m/s], wear.track_25 [m/s], wear.track_26 [m/s], wear.track_27 [m/s], wear.track_28 [m/s], wear.track_29 [m/s],
            wear.track_30 [m/s], wear.track_31 [m/s], wear.track_32 [m/s], wear.load_path [N m/s]
    """
    down_speed = u[0]
    return ca.vertcat(down_speed, *[0]*33)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    radius, pace, half_stroke, half_pace_times_stroke, twice_pi_over_track = c[1], c[3], c[7], c[8], c[10]
    down_travel = q[0]
    down_speed = u[0]
    wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6 = q[1], q[2], q[3], q[4], q[5], q[6]
    wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12 = q[7], q[8], q[9], q[10], q[11], q[12]
    wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18 = q[13], q[14], q[15], q[16], q[17], q[18]
    wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24 = q[19], q[20], q[21], q[22], q[23], q[24]
    wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30 = q[25], q[26], q[27], q[28], q[29], q[30]
    wear_track_31, wear_track_32 = q[31], q[32]
    t_times_pace = t*pace
    along_travel = half_stroke*ca.sin(t_times_pace)
    along_speed = half_pace_times_stroke*ca.cos(t_times_pace)
    plate_apart_y = radius - down_travel
    x2 = along_travel*twice_pi_over_track
    wear_track_cosine = ca.cos(x2)
    wear_track_sine = ca.sin(x2)
    wear_track_shares = _shares(32, 0, wear_track_cosine, wear_track_sine)
    wear_track_depth = ca.dot(wear_track_shares, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    wear_track_shares_slope = _shares(32, 1, wear_track_cosine, wear_track_sine)
    wear_track_slope = ca.dot(wear_track_shares_slope, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    wear_track_turning = along_speed*twice_pi_over_track
    plate_gap = plate_apart_y + wear_track_depth - radius
    plate_gap_rate = wear_track_slope*wear_track_turning - down_speed
    return ca.vertcat(plate_gap), ca.vertcat(plate_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    pace, half_stroke, half_pace_times_stroke, half_pace_squared_times_stroke, twice_pi_over_track = c[3], c[7], c[8], c[9], c[10]
    down_acceleration = a[0]
    wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6 = q[1], q[2], q[3], q[4], q[5], q[6]
    wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12 = q[7], q[8], q[9], q[10], q[11], q[12]
    wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18 = q[13], q[14], q[15], q[16], q[17], q[18]
    wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24 = q[19], q[20], q[21], q[22], q[23], q[24]
    wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30 = q[25], q[26], q[27], q[28], q[29], q[30]
    wear_track_31, wear_track_32 = q[31], q[32]
    t_times_pace = t*pace
    x2 = ca.sin(t_times_pace)
    along_travel = half_stroke*x2
    along_speed = half_pace_times_stroke*ca.cos(t_times_pace)
    along_acceleration = -half_pace_squared_times_stroke*x2
    x3 = along_travel*twice_pi_over_track
    wear_track_cosine = ca.cos(x3)
    wear_track_sine = ca.sin(x3)
    wear_track_shares_slope = _shares(32, 1, wear_track_cosine, wear_track_sine)
    wear_track_slope = ca.dot(wear_track_shares_slope, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    wear_track_shares_slope_slope = _shares(32, 2, wear_track_cosine, wear_track_sine)
    wear_track_bend = ca.dot(wear_track_shares_slope_slope, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    wear_track_turning = along_speed*twice_pi_over_track
    wear_track_turning_rate = along_acceleration*twice_pi_over_track
    plate_gap_rate_rate = wear_track_bend*wear_track_turning*wear_track_turning + wear_track_slope*wear_track_turning_rate - down_acceleration
    return ca.vertcat(plate_gap_rate_rate)


def contact_plate(t, q, u, z, m, c):
    """Forces of plate: power x kelvin_voigt, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (35,): down [N], along [N], wear.track_1 [m/s], wear.track_2 [m/s], wear.track_3 [m/s], wear.track_4 [m/s], wear.track_5 [m/s],
            wear.track_6 [m/s], wear.track_7 [m/s], wear.track_8 [m/s], wear.track_9 [m/s], wear.track_10 [m/s], wear.track_11 [m/s],
            wear.track_12 [m/s], wear.track_13 [m/s], wear.track_14 [m/s], wear.track_15 [m/s], wear.track_16 [m/s], wear.track_17 [m/s],
            wear.track_18 [m/s], wear.track_19 [m/s], wear.track_20 [m/s], wear.track_21 [m/s], wear.track_22 [m/s], wear.track_23 [m/s],
            wear.track_24 [m/s], wear.track_25 [m/s], wear.track_26 [m/s], wear.track_27 [m/s], wear.track_28 [m/s], wear.track_29 [m/s],
            wear.track_30 [m/s], wear.track_31 [m/s], wear.track_32 [m/s], wear.load_path [W]
        dz (4,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    load, radius, pace, friction, half_stroke, half_pace_times_stroke, twice_pi_over_track = c[0], c[1], c[3], c[4], c[7], c[8], c[10]
    k5, twice_plate_xi, inverse_friction_speed, repetitions_times_wear_rate, k10 = c[12], c[14], c[15], c[16], c[17]
    down_travel = q[0]
    down_speed = u[0]
    wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6 = q[1], q[2], q[3], q[4], q[5], q[6]
    wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12 = q[7], q[8], q[9], q[10], q[11], q[12]
    wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18 = q[13], q[14], q[15], q[16], q[17], q[18]
    wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24 = q[19], q[20], q[21], q[22], q[23], q[24]
    wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30 = q[25], q[26], q[27], q[28], q[29], q[30]
    wear_track_31, wear_track_32 = q[31], q[32]
    t_times_pace = t*pace
    along_travel = half_stroke*ca.sin(t_times_pace)
    along_speed = half_pace_times_stroke*ca.cos(t_times_pace)
    plate_apart_y = radius - down_travel
    x2 = along_travel*twice_pi_over_track
    wear_track_cosine = ca.cos(x2)
    wear_track_sine = ca.sin(x2)
    wear_track_shares = _shares(32, 0, wear_track_cosine, wear_track_sine)
    wear_track_depth = ca.dot(wear_track_shares, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    wear_track_shares_slope = _shares(32, 1, wear_track_cosine, wear_track_sine)
    wear_track_slope = ca.dot(wear_track_shares_slope, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    plate_gap = plate_apart_y + wear_track_depth - radius
    plate_elastic_force = ca.if_else(-plate_gap > 0, k5*-plate_gap*ca.sqrt(-plate_gap), 0)
    wear_slope = twice_pi_over_track*wear_track_slope
    base = 1 + wear_slope*wear_slope
    wear_stretch = ca.sqrt(base)
    plate_normal_x = wear_slope/wear_stretch
    plate_normal_y = 1/wear_stretch
    plate_penetration_rate = -wear_stretch*(along_speed*plate_normal_x - down_speed*plate_normal_y)
    base_2 = -plate_elastic_force*load/plate_gap
    plate_resistance = ca.if_else(-plate_gap > 0, twice_plate_xi*plate_penetration_rate*ca.sqrt(base_2), 0)
    plate_gradient_force = plate_elastic_force + plate_resistance
    plate_normal_power = plate_penetration_rate*plate_resistance
    plate_normal_force = plate_gradient_force*wear_stretch
    plate_push_x = plate_normal_force*plate_normal_x
    plate_push_y = plate_normal_force*plate_normal_y
    plate_pressing_force = ca.if_else(plate_normal_force > 0, plate_normal_force, 0)
    plate_sliding_velocity = -along_speed*plate_normal_y - down_speed*plate_normal_x
    plate_friction_force = plate_pressing_force*friction*ca.tanh(inverse_friction_speed*plate_sliding_velocity)
    plate_friction_power = plate_friction_force*plate_sliding_velocity
    plate_drag_x = plate_friction_force*plate_normal_y
    plate_drag_y = -plate_friction_force*plate_normal_x
    wear_power = plate_pressing_force*ca.fabs(plate_sliding_velocity)
    wear_track_loss = repetitions_times_wear_rate*wear_power
    wear_deep = ca.if_else(-plate_gap > 0, 2*wear_track_depth - plate_gap, radius)
    base_3 = wear_deep*radius
    wear_breadth = 2*ca.sqrt(base_3)
    wear_track_pace = k10*ca.if_else(-plate_gap > 0, wear_track_loss, 0)/wear_breadth
    wear_track_concentration = ca.dot(wear_track_shares, ca.vertcat(wear_track_shares))
    wear_recession = wear_track_concentration*wear_track_pace
    plate_wear_power = plate_elastic_force*wear_recession
    return (ca.vertcat(-plate_drag_y - plate_push_y, plate_drag_x + plate_push_x, wear_track_pace*wear_track_shares[0],
            wear_track_pace*wear_track_shares[1], wear_track_pace*wear_track_shares[2], wear_track_pace*wear_track_shares[3],
            wear_track_pace*wear_track_shares[4], wear_track_pace*wear_track_shares[5], wear_track_pace*wear_track_shares[6],
            wear_track_pace*wear_track_shares[7], wear_track_pace*wear_track_shares[8], wear_track_pace*wear_track_shares[9],
            wear_track_pace*wear_track_shares[10], wear_track_pace*wear_track_shares[11], wear_track_pace*wear_track_shares[12],
            wear_track_pace*wear_track_shares[13], wear_track_pace*wear_track_shares[14], wear_track_pace*wear_track_shares[15],
            wear_track_pace*wear_track_shares[16], wear_track_pace*wear_track_shares[17], wear_track_pace*wear_track_shares[18],
            wear_track_pace*wear_track_shares[19], wear_track_pace*wear_track_shares[20], wear_track_pace*wear_track_shares[21],
            wear_track_pace*wear_track_shares[22], wear_track_pace*wear_track_shares[23], wear_track_pace*wear_track_shares[24],
            wear_track_pace*wear_track_shares[25], wear_track_pace*wear_track_shares[26], wear_track_pace*wear_track_shares[27],
            wear_track_pace*wear_track_shares[28], wear_track_pace*wear_track_shares[29], wear_track_pace*wear_track_shares[30],
            wear_track_pace*wear_track_shares[31], wear_power),
        ca.vertcat(0, plate_normal_power, plate_friction_power, plate_wear_power), ca.vertcat(plate_normal_force),
        ca.vertcat(plate_sliding_velocity), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (35,): down [N], along [N], wear.track_1 [m/s], wear.track_2 [m/s], wear.track_3 [m/s], wear.track_4 [m/s], wear.track_5 [m/s],
            wear.track_6 [m/s], wear.track_7 [m/s], wear.track_8 [m/s], wear.track_9 [m/s], wear.track_10 [m/s], wear.track_11 [m/s],
            wear.track_12 [m/s], wear.track_13 [m/s], wear.track_14 [m/s], wear.track_15 [m/s], wear.track_16 [m/s], wear.track_17 [m/s],
            wear.track_18 [m/s], wear.track_19 [m/s], wear.track_20 [m/s], wear.track_21 [m/s], wear.track_22 [m/s], wear.track_23 [m/s],
            wear.track_24 [m/s], wear.track_25 [m/s], wear.track_26 [m/s], wear.track_27 [m/s], wear.track_28 [m/s], wear.track_29 [m/s],
            wear.track_30 [m/s], wear.track_31 [m/s], wear.track_32 [m/s], wear.load_path [W]
    """
    load, gravity = c[0], c[2]
    return ca.vertcat(gravity*load, *[0]*34)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): down.acceleration [m/s^2]
        reactions (1,): along.reaction [N]
    """
    pace, half_pace_squared_times_stroke, total_mass, inverse_load = c[3], c[9], c[11], c[18]
    down_force, along_force = f[0], f[1]
    along_acceleration = -half_pace_squared_times_stroke*ca.sin(t*pace)
    down_acc = down_force*inverse_load
    along_reaction = along_acceleration*total_mass - along_force
    return ca.vertcat(down_acc), ca.vertcat(along_reaction)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    pace, half_pace_times_stroke = c[3], c[8]
    along_reaction_in = reactions[0]
    along_speed = half_pace_times_stroke*ca.cos(t*pace)
    return ca.vertcat(along_reaction_in*along_speed, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    radius, pace, half_stroke, half_pace_times_stroke, twice_pi_over_track, k6 = c[1], c[3], c[7], c[8], c[10], c[13]
    half_carriage_mass, half_load, gravity_times_load = c[19], c[20], c[21]
    down_travel = q[0]
    down_speed = u[0]
    wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6 = q[1], q[2], q[3], q[4], q[5], q[6]
    wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12 = q[7], q[8], q[9], q[10], q[11], q[12]
    wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18 = q[13], q[14], q[15], q[16], q[17], q[18]
    wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24 = q[19], q[20], q[21], q[22], q[23], q[24]
    wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30 = q[25], q[26], q[27], q[28], q[29], q[30]
    wear_track_31, wear_track_32 = q[31], q[32]
    t_times_pace = t*pace
    along_travel = half_stroke*ca.sin(t_times_pace)
    along_speed = half_pace_times_stroke*ca.cos(t_times_pace)
    plate_apart_y = radius - down_travel
    x2 = along_travel*twice_pi_over_track
    wear_track_cosine = ca.cos(x2)
    wear_track_sine = ca.sin(x2)
    wear_track_shares = _shares(32, 0, wear_track_cosine, wear_track_sine)
    wear_track_depth = ca.dot(wear_track_shares, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    plate_gap = plate_apart_y + wear_track_depth - radius
    plate_stored_energy = ca.if_else(-plate_gap > 0, k6*(-plate_gap)**2*ca.sqrt(-plate_gap), 0)
    along_speed_squared = along_speed*along_speed
    kinetic = half_carriage_mass*along_speed_squared + half_load*(along_speed_squared + down_speed*down_speed)
    potential = -down_travel*gravity_times_load
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(plate_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): carriage.x [m], carriage.y [m], carriage.z [m], ball.x [m], ball.y [m], ball.z [m]
        rotations (18,): carriage.R_xx [1], carriage.R_xy [1], carriage.R_xz [1], carriage.R_yx [1], carriage.R_yy [1], carriage.R_yz [1],
            carriage.R_zx [1], carriage.R_zy [1], carriage.R_zz [1], ball.R_xx [1], ball.R_xy [1], ball.R_xz [1], ball.R_yx [1], ball.R_yy
            [1], ball.R_yz [1], ball.R_zx [1], ball.R_zy [1], ball.R_zz [1]
    """
    pace, half_stroke = c[3], c[7]
    down_travel = q[0]
    along_travel = half_stroke*ca.sin(t*pace)
    return ca.vertcat(along_travel, 0, 0, along_travel, -down_travel, 0), ca.vertcat(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): OUTPUTS
    """
    radius, pace, wear_rate, repetitions, half_stroke, twice_pi_over_track = c[1], c[3], c[5], c[6], c[7], c[10]
    down_travel, wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5 = q[0], q[1], q[2], q[3], q[4], q[5]
    wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11 = q[6], q[7], q[8], q[9], q[10], q[11]
    wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17 = q[12], q[13], q[14], q[15], q[16], q[17]
    wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23 = q[18], q[19], q[20], q[21], q[22], q[23]
    wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29 = q[24], q[25], q[26], q[27], q[28], q[29]
    wear_track_30, wear_track_31, wear_track_32, wear_load_path = q[30], q[31], q[32], q[33]
    along_travel = half_stroke*ca.sin(t*pace)
    plate_apart_y = radius - down_travel
    x1 = along_travel*twice_pi_over_track
    wear_track_cosine = ca.cos(x1)
    wear_track_sine = ca.sin(x1)
    wear_track_shares = _shares(32, 0, wear_track_cosine, wear_track_sine)
    wear_track_depth = ca.dot(wear_track_shares, ca.vertcat(wear_track_1, wear_track_2, wear_track_3, wear_track_4, wear_track_5, wear_track_6, wear_track_7, wear_track_8, wear_track_9, wear_track_10, wear_track_11, wear_track_12, wear_track_13, wear_track_14, wear_track_15, wear_track_16, wear_track_17, wear_track_18, wear_track_19, wear_track_20, wear_track_21, wear_track_22, wear_track_23, wear_track_24, wear_track_25, wear_track_26, wear_track_27, wear_track_28, wear_track_29, wear_track_30, wear_track_31, wear_track_32))
    plate_gap = plate_apart_y + wear_track_depth - radius
    return ca.vertcat(plate_gap, wear_load_path*repetitions*wear_rate)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    pace = p[5]
    return ca.vertcat(2*3.141592653589793/ca.fabs(pace))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        along.parent, along.child, down.parent, down.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        plate.sphere (4,): x [m], y [m], z [m], radius [m]
        plate.plane (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        gravity.direction, drive.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        drive.child, carriage.centre, ball.centre (3,): x [m], y [m], z [m]
    """
    radius = p[2]
    return (ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0, 0, -1, 0),
        ca.vertcat(0, 0, 0, radius), ca.vertcat(0, -radius, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0))
