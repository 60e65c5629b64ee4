"""worn_slider_crank: slider-crank, clearance joint that wears. Generated from derive/scenes/worn_slider_crank.py.

Do not edit; regenerate with `hertzwerk derive worn_slider_crank`.
Effects:
    crank_drive: constant speed of main_bearing
    gravity: uniform gravity
    slider_pin: liu_with_length x lankarani_nikravesh
    slider_pin_friction: smooth_coulomb at slider_pin
    wear: Archard's wear at slider_pin
    energy_ledger: work put in, energy dissipated per effect
Units: 195 assignments and 524 outputs checked, all consistent
Operations: flight 994 (equations of motion and gaps); in contact also contact_slider_pin 428
"""

import casadi as ca

NAME = "worn_slider_crank"
SOURCE = "derive/scenes/worn_slider_crank.py"
SUMMARY = "slider-crank, clearance joint that wears"
FORMAT = "hertzwerk module 1"
DIGEST = "74eae1a9a7cd866b1097550215569321"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("gravity", "gravity", "uniform gravity"),
    ("slider_pin", "contact", "liu_with_length x lankarani_nikravesh"), ("slider_pin_friction", "friction", "smooth_coulomb at slider_pin"),
    ("wear", "wear", "Archard's wear at slider_pin"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0001, "body crank, inertia"),
    ("rod_mass", "kg", 0.21, "body rod, mass"),
    ("rod_inertia", "kg m^2", 0.00025, "body rod, inertia"),
    ("rod_mass_centre", "m", 0.06, "crank pin to mass centre"),
    ("slider_mass", "kg", 0.14, "body slider, mass"),
    ("crank_radius", "m", 0.05, "main bearing to crank pin"),
    ("bush_radius", "mm", 10, "pair slider_pin, bush radius"),
    ("clearance", "mm", 0.5, "bush radius minus pin radius"),
    ("bush_length", "mm", 15, "of the slider pin in its bush"),
    ("rod_length", "m", 0.12, "crank pin to slider pin"),
    ("crank_speed", "rpm", 5000, "constant speed of the crank"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("youngs_modulus", "GPa", 207, "effect slider_pin, Young's modulus of the first body of liu_with_length"),
    ("poissons_ratio", "1", 0.3, "effect slider_pin, Poisson's ratio of the first body of liu_with_length"),
    ("density", "kg/m^3", 7800, "of the steel"),
    ("restitution", "1", 0.9, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "m/s", 0.001, "least approach speed a damping law is given; h/v0 is unbounded otherwise"),
    ("friction_coefficient", "1", 0.1, "effect slider_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "m/s", 0.1, "effect slider_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("wear_rate", "mm^3/(N m)", 1e-06, "volume lost for each newton metre of pin and bush"),
    ("repetitions", "1", 10000.0, "revolutions that one of the run stands for"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("rod_mass", "defined", 0, None, True, False, "body rod, mass"),
    ("rod_inertia", "defined", 0, None, False, False, "body rod, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("bush_radius", "defined", 0, None, True, False, "pair slider_pin, bush radius"),
    ("clearance", "defined", 0, None, True, False, "pair slider_pin, clearance"),
    ("bush_length", "defined", 0, None, True, False, "pair slider_pin, length"),
    ("youngs_modulus", "defined", 0, None, True, False, "effect slider_pin, Young's modulus of the first body of liu_with_length"),
    ("poissons_ratio", "defined", -1, 0.5, True, False, "effect slider_pin, Poisson's ratio of the first body of liu_with_length"),
    ("density", "defined", 0, None, True, False, "effect slider_pin, density"),
    ("restitution", "defined", 0, 1, False, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("restitution", "recommended", 0.8, 1, True, False, "effect slider_pin, coefficient of restitution of lankarani_nikravesh"),
    ("approach_floor", "defined", 0, None, True, False, "effect slider_pin, approach floor"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect slider_pin_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect slider_pin_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("wear_rate", "defined", 0, None, False, False, "effect wear, first"),
    ("repetitions", "defined", 0, None, True, False, "effect wear, acceleration"),
    ("rod_length", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("bush_radius", 1.0), ("clearance", -1.0)), "defined", 0, None, True, False, "pair slider_pin, pin radius (bush radius minus clearance)"),
)

COORDINATES = (
    ("crank_pin.angle", "rad"), ("guide.travel", "m"), ("wear.pin_1", "m"), ("wear.pin_2", "m"), ("wear.pin_3", "m"), ("wear.pin_4", "m"),
    ("wear.pin_5", "m"), ("wear.pin_6", "m"), ("wear.pin_7", "m"), ("wear.pin_8", "m"), ("wear.pin_9", "m"), ("wear.pin_10", "m"),
    ("wear.pin_11", "m"), ("wear.pin_12", "m"), ("wear.pin_13", "m"), ("wear.pin_14", "m"), ("wear.pin_15", "m"), ("wear.pin_16", "m"),
    ("wear.pin_17", "m"), ("wear.pin_18", "m"), ("wear.pin_19", "m"), ("wear.pin_20", "m"), ("wear.pin_21", "m"), ("wear.pin_22", "m"),
    ("wear.pin_23", "m"), ("wear.pin_24", "m"), ("wear.pin_25", "m"), ("wear.pin_26", "m"), ("wear.pin_27", "m"), ("wear.pin_28", "m"),
    ("wear.pin_29", "m"), ("wear.pin_30", "m"), ("wear.pin_31", "m"), ("wear.pin_32", "m"), ("wear.bush_1", "m"), ("wear.bush_2", "m"),
    ("wear.bush_3", "m"), ("wear.bush_4", "m"), ("wear.bush_5", "m"), ("wear.bush_6", "m"), ("wear.bush_7", "m"), ("wear.bush_8", "m"),
    ("wear.bush_9", "m"), ("wear.bush_10", "m"), ("wear.bush_11", "m"), ("wear.bush_12", "m"), ("wear.bush_13", "m"), ("wear.bush_14", "m"),
    ("wear.bush_15", "m"), ("wear.bush_16", "m"), ("wear.bush_17", "m"), ("wear.bush_18", "m"), ("wear.bush_19", "m"),
    ("wear.bush_20", "m"), ("wear.bush_21", "m"), ("wear.bush_22", "m"), ("wear.bush_23", "m"), ("wear.bush_24", "m"),
    ("wear.bush_25", "m"), ("wear.bush_26", "m"), ("wear.bush_27", "m"), ("wear.bush_28", "m"), ("wear.bush_29", "m"),
    ("wear.bush_30", "m"), ("wear.bush_31", "m"), ("wear.bush_32", "m"), ("wear.load_path", "N m"),
)

SPEEDS = (("crank_pin.speed", "rad/s"), ("guide.speed", "m/s"))

MEMORY = (("energy_ledger.input", "J"), ("slider_pin.dissipated", "J"), ("slider_pin_friction.dissipated", "J"), ("wear.dissipated", "J"))

LATCHES = (("slider_pin.approach_speed", "m/s", 0),)

PAIRS = (("slider_pin", "pin_in_bush"),)

RELEASES = ("force",)

DISSIPATED = (1,)

GIVEN = (
    "crank_pin.speed", "guide.travel", "wear.pin_1", "wear.pin_2", "wear.pin_3", "wear.pin_4", "wear.pin_5", "wear.pin_6", "wear.pin_7",
    "wear.pin_8", "wear.pin_9", "wear.pin_10", "wear.pin_11", "wear.pin_12", "wear.pin_13", "wear.pin_14", "wear.pin_15", "wear.pin_16",
    "wear.pin_17", "wear.pin_18", "wear.pin_19", "wear.pin_20", "wear.pin_21", "wear.pin_22", "wear.pin_23", "wear.pin_24", "wear.pin_25",
    "wear.pin_26", "wear.pin_27", "wear.pin_28", "wear.pin_29", "wear.pin_30", "wear.pin_31", "wear.pin_32", "wear.bush_1", "wear.bush_2",
    "wear.bush_3", "wear.bush_4", "wear.bush_5", "wear.bush_6", "wear.bush_7", "wear.bush_8", "wear.bush_9", "wear.bush_10", "wear.bush_11",
    "wear.bush_12", "wear.bush_13", "wear.bush_14", "wear.bush_15", "wear.bush_16", "wear.bush_17", "wear.bush_18", "wear.bush_19",
    "wear.bush_20", "wear.bush_21", "wear.bush_22", "wear.bush_23", "wear.bush_24", "wear.bush_25", "wear.bush_26", "wear.bush_27",
    "wear.bush_28", "wear.bush_29", "wear.bush_30", "wear.bush_31", "wear.bush_32", "wear.load_path",
)

OUTPUTS = (("slider_pin.eccentricity_x", "m"), ("slider_pin.eccentricity_y", "m"), ("wear.volume", "m^3"))

SPEED_LIMITED = ("slider_pin",)

BODIES = ("crank", "rod", "slider")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("crank_pin", "revolute", "parent", "crank", ("axis",)), ("crank_pin", "revolute", "child", "rod", ("axis",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "slider", ("axis",)),
    ("slider_pin", "pin_in_bush", "pin", "rod", ("radius",)), ("slider_pin", "pin_in_bush", "bush", "slider", ("radius", "axis")),
    ("crank_drive", "turn_drive", "child", "crank", ("axis",)), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("rod", "body", "centre", "rod", ()), ("slider", "body", "centre", "slider", ()),
)

WORN = (
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
    (34, 35),
    (35, 36),
    (36, 37),
    (37, 38),
    (38, 39),
    (39, 40),
    (40, 41),
    (41, 42),
    (42, 43),
    (43, 44),
    (44, 45),
    (45, 46),
    (46, 47),
    (47, 48),
    (48, 49),
    (49, 50),
    (50, 51),
    (51, 52),
    (52, 53),
    (53, 54),
    (54, 55),
    (55, 56),
    (56, 57),
    (57, 58),
    (58, 59),
    (59, 60),
    (60, 61),
    (61, 62),
    (62, 63),
    (63, 64),
    (64, 65),
    (65, 66),
    (66, 67),
)

CONSTANTS = (
    ("rod_mass_centre", "m"), ("crank_radius", "m"), ("clearance", "m"), ("rod_length", "m"), ("crank_speed", "1/s"), ("gravity", "m/s^2"),
    ("friction_coefficient", "1"), ("wear_pin_sector", "m^2"), ("wear_bush_sector", "m^2"), ("k1", "m^2"),
    ("inverse_clearance_squared", "1/m^2"), ("slider_pin_R_min", "m"), ("twice_clearance", "m"),
    ("half_pi_times_slider_pin_E_eff_times_bush_length", "N/m"), ("k5", "N/m"), ("k6", "N/m"), ("k7", "N/m"), ("k8", "N/m"), ("k9", "N/m"),
    ("k10", "N/m"), ("k11", "N/m"), ("k12", "N/m"), ("k13", "N/m"), ("k14", "N/m"), ("k15", "N/m"), ("k16", "N/m"), ("k17", "N/m"),
    ("k18", "N/m"), ("k19", "N/m"), ("k20", "N/m"), ("slider_pin_hysteresis_factor", "1"), ("inverse_friction_speed", "s/m"),
    ("repetitions_times_wear_rate", "1/Pa"), ("inverse_wear_pin_sector", "1/m^2"), ("inverse_wear_bush_sector", "1/m^2"),
    ("rod_h_x", "kg m"), ("crank_h_x", "kg m"), ("crank_rate_zz", "1/s^2"), ("rod_I_z_z", "kg m^2"), ("inverse_rod_I_z_z", "1/(kg m^2)"),
    ("inverse_slider_mass", "1/kg"), ("half_rod_I_z_z", "kg m^2"), ("half_slider_mass", "kg"), ("half_rod_mass", "kg"),
    ("half_crank_speed_squared_times_crank_inertia", "J"), ("gravity_times_rod_mass", "N"),
)

OPERATIONS = (
    ("constants", 90), ("start", 5), ("scales", 15), ("coordinate_rates", 0), ("gaps", 350), ("gap_accelerations", 596),
    ("contact_slider_pin", 428), ("applied", 11), ("accelerations", 37), ("ledger", 1), ("energy", 289), ("poses", 10), ("outputs", 78),
    ("speed_limits", 3), ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


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
        c (46,): rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, wear_pin_sector,
            wear_bush_sector, k1, inverse_clearance_squared, slider_pin_R_min, twice_clearance,
            half_pi_times_slider_pin_E_eff_times_bush_length, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20,
            slider_pin_hysteresis_factor, inverse_friction_speed, repetitions_times_wear_rate, inverse_wear_pin_sector,
            inverse_wear_bush_sector, rod_h_x, crank_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z,
            half_slider_mass, half_rod_mass, half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass
    """
    crank_inertia, rod_mass, rod_inertia, rod_mass_centre, slider_mass, crank_radius, bush_radius = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    clearance, bush_length, rod_length, crank_speed, gravity, youngs_modulus, poissons_ratio = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    restitution, friction_coefficient, friction_speed, wear_rate, repetitions = p[16], p[18], p[19], p[20], p[21]
    slider_pin_R_min = bush_radius - clearance
    wear_pin_sector = 3.141592653589793*slider_pin_R_min*bush_length/16
    wear_bush_sector = 3.141592653589793*bush_length*bush_radius/16
    k1 = 0.0625*clearance*clearance
    inverse_clearance_squared = 1/(clearance*clearance)
    slider_pin_E_eff = youngs_modulus/(2*(1 - poissons_ratio*poissons_ratio))
    twice_clearance = 2*clearance
    half_pi_times_slider_pin_E_eff_times_bush_length = 3.141592653589793*slider_pin_E_eff*bush_length/2
    k5 = 0.008511818484890769*3.141592653589793*slider_pin_E_eff*bush_length
    k6 = 0.036980925051143414*3.141592653589793*slider_pin_E_eff*bush_length
    k7 = 0.003971150389178378*3.141592653589793*slider_pin_E_eff*bush_length
    k8 = 0.02781715911522491*3.141592653589793*slider_pin_E_eff*bush_length
    k9 = 1.0708519166174077e-11*3.141592653589793*slider_pin_E_eff*bush_length
    k10 = 0.0015199021366491846*3.141592653589793*slider_pin_E_eff*bush_length
    k11 = 1.3940024393033299e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k12 = 0.0004561231689207159*3.141592653589793*slider_pin_E_eff*bush_length
    k13 = 0.015394788440001576*3.141592653589793*slider_pin_E_eff*bush_length
    k14 = 9.693740427487626e-07*3.141592653589793*slider_pin_E_eff*bush_length
    k15 = 0.032029574061236465*3.141592653589793*slider_pin_E_eff*bush_length
    k16 = 0.03602473950753736*3.141592653589793*slider_pin_E_eff*bush_length
    k17 = 1.835845147395182e-08*3.141592653589793*slider_pin_E_eff*bush_length
    k18 = 0.023888498220471448*3.141592653589793*slider_pin_E_eff*bush_length
    k19 = 9.967497150641238e-05*3.141592653589793*slider_pin_E_eff*bush_length
    k20 = 0.013290718685643597*3.141592653589793*slider_pin_E_eff*bush_length
    slider_pin_hysteresis_factor = 3/4 - 3*restitution*restitution/4
    inverse_friction_speed = 1/friction_speed
    repetitions_times_wear_rate = repetitions*wear_rate
    inverse_wear_pin_sector = 1/wear_pin_sector
    inverse_wear_bush_sector = 1/wear_bush_sector
    rod_h_x = rod_mass*rod_mass_centre
    crank_h_x = crank_radius*rod_mass
    crank_rate_zz = crank_speed*crank_speed
    rod_I_z_z = rod_mass_centre*rod_mass_centre*rod_mass + rod_inertia
    inverse_rod_I_z_z = 1/rod_I_z_z
    inverse_slider_mass = 1/slider_mass
    half_rod_I_z_z = rod_I_z_z/2
    half_slider_mass = slider_mass/2
    half_rod_mass = rod_mass/2
    half_crank_speed_squared_times_crank_inertia = crank_rate_zz*crank_inertia/2
    gravity_times_rod_mass = gravity*rod_mass
    return ca.vertcat(rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, gravity, friction_coefficient, wear_pin_sector,
        wear_bush_sector, k1, inverse_clearance_squared, slider_pin_R_min, twice_clearance,
        half_pi_times_slider_pin_E_eff_times_bush_length, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16, k17, k18, k19, k20,
        slider_pin_hysteresis_factor, inverse_friction_speed, repetitions_times_wear_rate, inverse_wear_pin_sector,
        inverse_wear_bush_sector, rod_h_x, crank_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z, inverse_slider_mass, half_rod_I_z_z,
        half_slider_mass, half_rod_mass, half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (67,): COORDINATES
        u (2,): SPEEDS
    """
    crank_radius, rod_length, crank_speed = p[6], p[10], p[11]
    return ca.vertcat(0, crank_radius + rod_length, *[0]*65), ca.vertcat(-(1 + crank_radius/rod_length)*crank_speed, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (67,): COORDINATES
        su (2,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, rod_mass, slider_mass, crank_radius, clearance, rod_length, crank_speed = p[0], p[2], p[5], p[6], p[8], p[10], p[11]
    total_mass = crank_mass + rod_mass + slider_mass
    crank_radius_squared = crank_radius*crank_radius
    crank_speed_squared = crank_speed*crank_speed
    energy_scale = total_mass*crank_radius_squared*crank_speed_squared/2
    force_scale = energy_scale/clearance
    crank_radius_times_crank_speed = crank_radius*crank_speed
    return (ca.vertcat(clearance/rod_length, *[clearance]*65, total_mass*crank_radius_squared*crank_speed_squared/2),
        ca.vertcat(crank_radius*crank_speed/rod_length, crank_radius_times_crank_speed),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(clearance, crank_radius_times_crank_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (67,): crank_pin.angle [rad/s], guide.travel [m/s], wear.pin_1 [m/s], wear.pin_2 [m/s], wear.pin_3 [m/s], wear.pin_4 [m/s],
            wear.pin_5 [m/s], wear.pin_6 [m/s], wear.pin_7 [m/s], wear.pin_8 [m/s], wear.pin_9 [m/s], wear.pin_10 [m/s], wear.pin_11 [m/s],
            wear.pin_12 [m/s], wear.pin_13 [m/s], wear.pin_14 [m/s], wear.pin_15 [m/s], wear.pin_16 [m/s], wear.pin_17 [m/s], wear.pin_18
            [m/s], wear.pin_19 [m/s], wear.pin_20 [m/s], wear.pin_21 [m/s], wear.pin_22 [m/s], wear.pin_23 [m/s], wear.pin_24 [m/s],
            wear.pin_25 [m/s], wear.pin_26 [m/s], wear.pin_27 [m/s], wear.pin_28 [m/s], wear.pin_29 [m/s], wear.pin_30 [m/s], wear.pin_31
            [m/s], wear.pin_32 [m/s], wear.bush_1 [m/s], wear.bush_2 [m/s], wear.bush_3 [m/s], wear.bush_4 [m/s], wear.bush_5 [m/s],
            wear.bush_6 [m/s], wear.bush_7 [m/s], wear.bush_8 [m/s], wear.bush_9 [m/s], wear.bush_10 [m/s], wear.bush_11 [m/s], wear.bush_12
            [m/s], wear.bush_13 [m/s], wear.bush_14 [m/s], wear.bush_15 [m/s], wear.bush_16 [m/s], wear.bush_17 [m/s], wear.bush_18 [m/s],
            wear.bush_19 [m/s], wear.bush_20 [m/s], wear.bush_21 [m/s], wear.bush_22 [m/s], wear.bush_23 [m/s], wear.bush_24 [m/s],
            wear.bush_25 [m/s], wear.bush_26 [m/s], wear.bush_27 [m/s], wear.bush_28 [m/s], wear.bush_29 [m/s], wear.bush_30 [m/s],
            wear.bush_31 [m/s], wear.bush_32 [m/s], wear.load_path [N m/s]
    """
    crank_pin_speed, guide_speed = u[0], u[1]
    return ca.vertcat(crank_pin_speed, guide_speed, *[0]*65)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    crank_radius, clearance, rod_length, crank_speed, k1, inverse_clearance_squared = c[1], c[2], c[3], c[4], c[9], c[10]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7 = q[2], q[3], q[4], q[5], q[6], q[7], q[8]
    wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14 = q[9], q[10], q[11], q[12], q[13], q[14], q[15]
    wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20 = q[16], q[17], q[18], q[19], q[20], q[21]
    wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26 = q[22], q[23], q[24], q[25], q[26], q[27]
    wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32 = q[28], q[29], q[30], q[31], q[32], q[33]
    wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6 = q[34], q[35], q[36], q[37], q[38], q[39]
    wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12 = q[40], q[41], q[42], q[43], q[44], q[45]
    wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18 = q[46], q[47], q[48], q[49], q[50], q[51]
    wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24 = q[52], q[53], q[54], q[55], q[56], q[57]
    wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30 = q[58], q[59], q[60], q[61], q[62], q[63]
    wear_bush_31, wear_bush_32 = q[64], q[65]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_rate_z*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_rate_z*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_arm_rate_x + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_arm_rate_y + slider_pin_pin_arm_rate_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    wear_safe_squared = ca.if_else(slider_pin_apart_squared > 0.0625*clearance*clearance, slider_pin_apart_squared, k1)
    wear_length = ca.sqrt(wear_safe_squared)
    wear_radial_x = slider_pin_apart_x/wear_length
    wear_radial_y = slider_pin_apart_y/wear_length
    wear_pin_x = cos_rod*slider_pin_apart_x + sin_rod*slider_pin_apart_y
    wear_pin_y = cos_rod*slider_pin_apart_y - sin_rod*slider_pin_apart_x
    wear_pin_cosine = wear_pin_x/wear_length
    wear_pin_sine = wear_pin_y/wear_length
    wear_pin_shares = _shares(32, 0, wear_pin_cosine, wear_pin_sine)
    wear_pin_depth = ca.dot(wear_pin_shares, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_pin_shares_slope = _shares(32, 1, wear_pin_cosine, wear_pin_sine)
    wear_pin_slope = ca.dot(wear_pin_shares_slope, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    cos_rod_rate = -rod_rate_z*sin_rod
    sin_rod_rate = cos_rod*rod_rate_z
    wear_pin_x_rate = cos_rod*slider_pin_apart_rate_x + cos_rod_rate*slider_pin_apart_x + sin_rod*slider_pin_apart_rate_y + sin_rod_rate*slider_pin_apart_y
    wear_pin_y_rate = cos_rod*slider_pin_apart_rate_y + cos_rod_rate*slider_pin_apart_y - sin_rod*slider_pin_apart_rate_x - sin_rod_rate*slider_pin_apart_x
    inverse_wear_length_squared = 1/(wear_length*wear_length)
    wear_pin_turning = inverse_wear_length_squared*(wear_pin_x*wear_pin_y_rate - wear_pin_x_rate*wear_pin_y)
    wear_bush_shares = _shares(32, 0, wear_radial_x, wear_radial_y)
    wear_bush_depth = ca.dot(wear_bush_shares, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_bush_shares_slope = _shares(32, 1, wear_radial_x, wear_radial_y)
    wear_bush_slope = ca.dot(wear_bush_shares_slope, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_bush_turning = inverse_wear_length_squared*(slider_pin_apart_rate_y*slider_pin_apart_x - slider_pin_apart_rate_x*slider_pin_apart_y)
    wear_ratio = inverse_clearance_squared*slider_pin_apart_squared
    wear_nearness = 2.2857142857142856*wear_ratio - 0.14285714285714285
    wear_nearness_cubed = wear_nearness*wear_nearness*wear_nearness
    x3 = -15*wear_nearness
    wear_nearness_squared = wear_nearness*wear_nearness
    x5 = 6*wear_nearness_squared
    x6 = 10 + x3 + x5
    wear_counted_share = ca.if_else(wear_ratio < 0.0625, 0, ca.if_else(wear_ratio < 0.5, wear_nearness_cubed*x6, 1))
    wear_depth = wear_bush_depth + wear_pin_depth
    wear_counted = wear_counted_share*wear_depth
    slider_pin_reach = wear_counted + clearance
    slider_pin_reach_squared = slider_pin_reach*slider_pin_reach
    x8 = slider_pin_reach_squared - slider_pin_apart_squared
    slider_pin_gap = x8/(2*slider_pin_reach)
    slider_pin_apart_squared_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_x + 2*slider_pin_apart_rate_y*slider_pin_apart_y
    wear_ratio_rate = inverse_clearance_squared*slider_pin_apart_squared_rate
    wear_nearness_rate = 2.2857142857142856*wear_ratio_rate
    wear_counted_share_rate = wear_nearness_rate*ca.if_else(wear_ratio < 0.0625, 0, ca.if_else(wear_ratio < 0.5, wear_nearness_cubed*(12*wear_nearness - 15) + 3*wear_nearness_squared*x6, 0))
    wear_depth_rate = wear_bush_slope*wear_bush_turning + wear_pin_slope*wear_pin_turning
    wear_counted_rate = wear_counted_share*wear_depth_rate + wear_counted_share_rate*wear_depth
    slider_pin_gap_rate = wear_counted_rate*(1 - x8/(2*slider_pin_reach*slider_pin_reach)) - slider_pin_apart_squared_rate/(2*slider_pin_reach)
    return ca.vertcat(slider_pin_gap), ca.vertcat(slider_pin_gap_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    crank_radius, clearance, rod_length, crank_speed, k1, inverse_clearance_squared = c[1], c[2], c[3], c[4], c[9], c[10]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    crank_pin_acceleration, guide_acceleration = a[0], a[1]
    wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7 = q[2], q[3], q[4], q[5], q[6], q[7], q[8]
    wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14 = q[9], q[10], q[11], q[12], q[13], q[14], q[15]
    wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20 = q[16], q[17], q[18], q[19], q[20], q[21]
    wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26 = q[22], q[23], q[24], q[25], q[26], q[27]
    wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32 = q[28], q[29], q[30], q[31], q[32], q[33]
    wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6 = q[34], q[35], q[36], q[37], q[38], q[39]
    wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12 = q[40], q[41], q[42], q[43], q[44], q[45]
    wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18 = q[46], q[47], q[48], q[49], q[50], q[51]
    wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24 = q[52], q[53], q[54], q[55], q[56], q[57]
    wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30 = q[58], q[59], q[60], q[61], q[62], q[63]
    wear_bush_31, wear_bush_32 = q[64], q[65]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    rod_acceleration_x = -rod_arm_rate_y*crank_speed
    rod_acceleration_y = rod_arm_rate_x*crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_pin_arm_rate_x = -rod_rate_z*slider_pin_pin_arm_y
    slider_pin_pin_arm_rate_y = rod_rate_z*slider_pin_pin_arm_x
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_rate_x = rod_arm_rate_x + slider_pin_pin_arm_rate_x - guide_speed
    slider_pin_apart_rate_y = rod_arm_rate_y + slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_x = rod_acceleration_x - guide_acceleration - crank_pin_acceleration*slider_pin_pin_arm_y - rod_rate_z*slider_pin_pin_arm_rate_y
    slider_pin_apart_acceleration_y = rod_acceleration_y + crank_pin_acceleration*slider_pin_pin_arm_x + rod_rate_z*slider_pin_pin_arm_rate_x
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    clearance_squared = clearance*clearance
    x2 = 0.0625*clearance_squared
    wear_safe_squared = ca.if_else(slider_pin_apart_squared > x2, slider_pin_apart_squared, k1)
    wear_length = ca.sqrt(wear_safe_squared)
    wear_radial_x = slider_pin_apart_x/wear_length
    wear_radial_y = slider_pin_apart_y/wear_length
    wear_pin_x = cos_rod*slider_pin_apart_x + sin_rod*slider_pin_apart_y
    wear_pin_y = cos_rod*slider_pin_apart_y - sin_rod*slider_pin_apart_x
    wear_pin_cosine = wear_pin_x/wear_length
    wear_pin_sine = wear_pin_y/wear_length
    wear_pin_shares = _shares(32, 0, wear_pin_cosine, wear_pin_sine)
    wear_pin_depth = ca.dot(wear_pin_shares, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_pin_shares_slope = _shares(32, 1, wear_pin_cosine, wear_pin_sine)
    wear_pin_slope = ca.dot(wear_pin_shares_slope, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_pin_shares_slope_slope = _shares(32, 2, wear_pin_cosine, wear_pin_sine)
    wear_pin_bend = ca.dot(wear_pin_shares_slope_slope, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    cos_rod_rate = -rod_rate_z*sin_rod
    sin_rod_rate = cos_rod*rod_rate_z
    wear_pin_x_rate = cos_rod*slider_pin_apart_rate_x + cos_rod_rate*slider_pin_apart_x + sin_rod*slider_pin_apart_rate_y + sin_rod_rate*slider_pin_apart_y
    wear_pin_y_rate = cos_rod*slider_pin_apart_rate_y + cos_rod_rate*slider_pin_apart_y - sin_rod*slider_pin_apart_rate_x - sin_rod_rate*slider_pin_apart_x
    inverse_wear_length_squared = 1/(wear_length*wear_length)
    wear_pin_x_times_wear_pin_y_rate = wear_pin_x*wear_pin_y_rate
    minus_wear_pin_x_rate_times_wear_pin_y = -wear_pin_x_rate*wear_pin_y
    x6 = wear_pin_x_times_wear_pin_y_rate + minus_wear_pin_x_rate_times_wear_pin_y
    wear_pin_turning = inverse_wear_length_squared*x6
    wear_bush_shares = _shares(32, 0, wear_radial_x, wear_radial_y)
    wear_bush_depth = ca.dot(wear_bush_shares, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_bush_shares_slope = _shares(32, 1, wear_radial_x, wear_radial_y)
    wear_bush_slope = ca.dot(wear_bush_shares_slope, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_bush_shares_slope_slope = _shares(32, 2, wear_radial_x, wear_radial_y)
    wear_bush_bend = ca.dot(wear_bush_shares_slope_slope, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    slider_pin_apart_rate_y_times_slider_pin_apart_x = slider_pin_apart_rate_y*slider_pin_apart_x
    x8 = -slider_pin_apart_rate_x*slider_pin_apart_y
    x9 = slider_pin_apart_rate_y_times_slider_pin_apart_x + x8
    wear_bush_turning = inverse_wear_length_squared*x9
    wear_ratio = inverse_clearance_squared*slider_pin_apart_squared
    wear_nearness = 2.2857142857142856*wear_ratio - 0.14285714285714285
    wear_nearness_cubed = wear_nearness*wear_nearness*wear_nearness
    x11 = -15*wear_nearness
    wear_nearness_squared = wear_nearness*wear_nearness
    x13 = 6*wear_nearness_squared
    x14 = 10 + x11 + x13
    wear_counted_share = ca.if_else(wear_ratio < 0.0625, 0, ca.if_else(wear_ratio < 0.5, wear_nearness_cubed*x14, 1))
    wear_depth = wear_bush_depth + wear_pin_depth
    wear_counted = wear_counted_share*wear_depth
    slider_pin_reach = wear_counted + clearance
    slider_pin_apart_squared_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_x + 2*slider_pin_apart_rate_y*slider_pin_apart_y
    wear_ratio_rate = inverse_clearance_squared*slider_pin_apart_squared_rate
    wear_nearness_rate = 2.2857142857142856*wear_ratio_rate
    x15 = 12*wear_nearness
    x16 = x15 - 15
    x17 = wear_nearness_cubed*x16
    x18 = 3*wear_nearness_squared*x14
    x19 = x17 + x18
    x20 = ca.if_else(wear_ratio < 0.5, x19, 0)
    x21 = ca.if_else(wear_ratio < 0.0625, 0, x20)
    wear_counted_share_rate = wear_nearness_rate*x21
    wear_depth_rate = wear_bush_slope*wear_bush_turning + wear_pin_slope*wear_pin_turning
    wear_counted_rate = wear_counted_share*wear_depth_rate + wear_counted_share_rate*wear_depth
    wear_safe_squared_rate = slider_pin_apart_squared_rate*ca.if_else(slider_pin_apart_squared > x2, 1, 0)
    wear_length_rate = wear_safe_squared_rate/(2*ca.sqrt(wear_safe_squared))
    inverse_wear_length_cubed = 1/(wear_length*wear_length*wear_length)
    wear_bush_turning_rate = slider_pin_apart_acceleration_y*slider_pin_apart_x*inverse_wear_length_squared - slider_pin_apart_acceleration_x*slider_pin_apart_y*inverse_wear_length_squared - 2*wear_length_rate*inverse_wear_length_cubed*x9
    rod_rate_z_squared = rod_rate_z*rod_rate_z
    cos_rod_rate_rate = -cos_rod*rod_rate_z_squared - crank_pin_acceleration*sin_rod
    sin_rod_rate_rate = cos_rod*crank_pin_acceleration - sin_rod*rod_rate_z_squared
    wear_pin_y_rate_rate = cos_rod*slider_pin_apart_acceleration_y + cos_rod_rate_rate*slider_pin_apart_y + 2*cos_rod_rate*slider_pin_apart_rate_y - sin_rod*slider_pin_apart_acceleration_x - sin_rod_rate_rate*slider_pin_apart_x - 2*sin_rod_rate*slider_pin_apart_rate_x
    wear_pin_x_rate_rate = cos_rod*slider_pin_apart_acceleration_x + cos_rod_rate_rate*slider_pin_apart_x + sin_rod*slider_pin_apart_acceleration_y + sin_rod_rate_rate*slider_pin_apart_y + 2*cos_rod_rate*slider_pin_apart_rate_x + 2*sin_rod_rate*slider_pin_apart_rate_y
    wear_pin_turning_rate = wear_pin_x*wear_pin_y_rate_rate*inverse_wear_length_squared - wear_pin_x_rate_rate*wear_pin_y*inverse_wear_length_squared - 2*wear_length_rate*inverse_wear_length_cubed*x6
    wear_depth_rate_rate = wear_bush_bend*wear_bush_turning*wear_bush_turning + wear_bush_slope*wear_bush_turning_rate + wear_pin_bend*wear_pin_turning*wear_pin_turning + wear_pin_slope*wear_pin_turning_rate
    slider_pin_apart_squared_rate_rate = 2*slider_pin_apart_rate_x*slider_pin_apart_rate_x + 2*slider_pin_apart_rate_y*slider_pin_apart_rate_y + 2*slider_pin_apart_acceleration_x*slider_pin_apart_x + 2*slider_pin_apart_acceleration_y*slider_pin_apart_y
    wear_ratio_rate_rate = inverse_clearance_squared*slider_pin_apart_squared_rate_rate
    wear_nearness_rate_rate = 2.2857142857142856*wear_ratio_rate_rate
    wear_counted_share_rate_rate = wear_nearness_rate_rate*x21 + wear_nearness_rate*wear_nearness_rate*ca.if_else(wear_ratio < 0.0625, 0, ca.if_else(wear_ratio < 0.5, 12*wear_nearness_cubed + 6*wear_nearness*x14 + 6*wear_nearness_squared*x16, 0))
    wear_counted_rate_rate = wear_counted_share*wear_depth_rate_rate + wear_counted_share_rate_rate*wear_depth + 2*wear_counted_share_rate*wear_depth_rate
    slider_pin_reach_squared = slider_pin_reach*slider_pin_reach
    x25 = slider_pin_reach_squared - slider_pin_apart_squared
    inverse_slider_pin_reach_squared = 1/(slider_pin_reach*slider_pin_reach)
    slider_pin_gap_rate_rate = wear_counted_rate*(wear_counted_rate*(x25/(slider_pin_reach*slider_pin_reach*slider_pin_reach) - 1/slider_pin_reach) + slider_pin_apart_squared_rate*inverse_slider_pin_reach_squared/2) + wear_counted_rate_rate*(1 - x25*inverse_slider_pin_reach_squared/2) + slider_pin_apart_squared_rate*wear_counted_rate*inverse_slider_pin_reach_squared/2 - slider_pin_apart_squared_rate_rate/(2*slider_pin_reach)
    return ca.vertcat(slider_pin_gap_rate_rate)


def contact_slider_pin(t, q, u, z, m, c):
    """Forces of slider_pin: liu_with_length x lankarani_nikravesh, smooth_coulomb. The normal force is the laws' own, not clamped: where it
    would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (68,): crank_pin [N m], guide [N], main_bearing [N m], wear.pin_1 [m/s], wear.pin_2 [m/s], wear.pin_3 [m/s], wear.pin_4 [m/s],
            wear.pin_5 [m/s], wear.pin_6 [m/s], wear.pin_7 [m/s], wear.pin_8 [m/s], wear.pin_9 [m/s], wear.pin_10 [m/s], wear.pin_11 [m/s],
            wear.pin_12 [m/s], wear.pin_13 [m/s], wear.pin_14 [m/s], wear.pin_15 [m/s], wear.pin_16 [m/s], wear.pin_17 [m/s], wear.pin_18
            [m/s], wear.pin_19 [m/s], wear.pin_20 [m/s], wear.pin_21 [m/s], wear.pin_22 [m/s], wear.pin_23 [m/s], wear.pin_24 [m/s],
            wear.pin_25 [m/s], wear.pin_26 [m/s], wear.pin_27 [m/s], wear.pin_28 [m/s], wear.pin_29 [m/s], wear.pin_30 [m/s], wear.pin_31
            [m/s], wear.pin_32 [m/s], wear.bush_1 [m/s], wear.bush_2 [m/s], wear.bush_3 [m/s], wear.bush_4 [m/s], wear.bush_5 [m/s],
            wear.bush_6 [m/s], wear.bush_7 [m/s], wear.bush_8 [m/s], wear.bush_9 [m/s], wear.bush_10 [m/s], wear.bush_11 [m/s], wear.bush_12
            [m/s], wear.bush_13 [m/s], wear.bush_14 [m/s], wear.bush_15 [m/s], wear.bush_16 [m/s], wear.bush_17 [m/s], wear.bush_18 [m/s],
            wear.bush_19 [m/s], wear.bush_20 [m/s], wear.bush_21 [m/s], wear.bush_22 [m/s], wear.bush_23 [m/s], wear.bush_24 [m/s],
            wear.bush_25 [m/s], wear.bush_26 [m/s], wear.bush_27 [m/s], wear.bush_28 [m/s], wear.bush_29 [m/s], wear.bush_30 [m/s],
            wear.bush_31 [m/s], wear.bush_32 [m/s], wear.load_path [W]
        dz (4,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (1,): PAIRS [m/s]
        in_range (1,): PAIRS [1]
    """
    crank_radius, clearance, rod_length, crank_speed, friction_coefficient, k1, slider_pin_R_min = c[1], c[2], c[3], c[4], c[6], c[9], c[11]
    twice_clearance, half_pi_times_slider_pin_E_eff_times_bush_length, slider_pin_hysteresis_factor = c[12], c[13], c[30]
    inverse_friction_speed, repetitions_times_wear_rate, inverse_wear_pin_sector, inverse_wear_bush_sector = c[31], c[32], c[33], c[34]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7 = q[2], q[3], q[4], q[5], q[6], q[7], q[8]
    wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14 = q[9], q[10], q[11], q[12], q[13], q[14], q[15]
    wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20 = q[16], q[17], q[18], q[19], q[20], q[21]
    wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26 = q[22], q[23], q[24], q[25], q[26], q[27]
    wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32 = q[28], q[29], q[30], q[31], q[32], q[33]
    wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6 = q[34], q[35], q[36], q[37], q[38], q[39]
    wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12 = q[40], q[41], q[42], q[43], q[44], q[45]
    wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18 = q[46], q[47], q[48], q[49], q[50], q[51]
    wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24 = q[52], q[53], q[54], q[55], q[56], q[57]
    wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30 = q[58], q[59], q[60], q[61], q[62], q[63]
    wear_bush_31, wear_bush_32 = q[64], q[65]
    slider_pin_approach_speed = m[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    wear_safe_squared = ca.if_else(slider_pin_apart_squared > 0.0625*clearance*clearance, slider_pin_apart_squared, k1)
    wear_length = ca.sqrt(wear_safe_squared)
    wear_radial_x = slider_pin_apart_x/wear_length
    wear_radial_y = slider_pin_apart_y/wear_length
    wear_pin_x = cos_rod*slider_pin_apart_x + sin_rod*slider_pin_apart_y
    wear_pin_y = cos_rod*slider_pin_apart_y - sin_rod*slider_pin_apart_x
    wear_pin_cosine = wear_pin_x/wear_length
    wear_pin_sine = wear_pin_y/wear_length
    wear_pin_shares = _shares(32, 0, wear_pin_cosine, wear_pin_sine)
    wear_pin_depth = ca.dot(wear_pin_shares, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_pin_shares_slope = _shares(32, 1, wear_pin_cosine, wear_pin_sine)
    wear_pin_slope = ca.dot(wear_pin_shares_slope, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_bush_shares = _shares(32, 0, wear_radial_x, wear_radial_y)
    wear_bush_depth = ca.dot(wear_bush_shares, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_bush_shares_slope = _shares(32, 1, wear_radial_x, wear_radial_y)
    wear_bush_slope = ca.dot(wear_bush_shares_slope, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_slope = (wear_bush_slope + wear_pin_slope)/wear_length
    base = 1 + wear_slope*wear_slope
    wear_stretch = ca.sqrt(base)
    slider_pin_normal_x = (-wear_radial_x - wear_radial_y*wear_slope)/wear_stretch
    slider_pin_normal_y = (wear_radial_x*wear_slope - wear_radial_y)/wear_stretch
    wear_depth = wear_bush_depth + wear_pin_depth
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - wear_depth - clearance
    base_2 = slider_pin_penetration/(twice_clearance + 2*slider_pin_penetration)
    slider_pin_elastic_force = ca.if_else(slider_pin_penetration > 0, half_pi_times_slider_pin_E_eff_times_bush_length*slider_pin_penetration*ca.sqrt(base_2), 0)
    slider_pin_relative_rate_x = rod_arm_rate_x - guide_speed - rod_rate_z*slider_pin_pin_arm_y
    slider_pin_relative_rate_y = rod_arm_rate_y + rod_rate_z*slider_pin_pin_arm_x
    slider_pin_penetration_rate = rod_rate_z*wear_pin_slope - wear_stretch*(slider_pin_normal_x*slider_pin_relative_rate_x + slider_pin_normal_y*slider_pin_relative_rate_y)
    slider_pin_resistance = slider_pin_elastic_force*slider_pin_hysteresis_factor*slider_pin_penetration_rate/slider_pin_approach_speed
    slider_pin_gradient_force = slider_pin_elastic_force + slider_pin_resistance
    slider_pin_normal_power = slider_pin_penetration_rate*slider_pin_resistance
    slider_pin_normal_force = slider_pin_gradient_force*wear_stretch
    slider_pin_push_x = slider_pin_normal_force*slider_pin_normal_x
    slider_pin_push_y = slider_pin_normal_force*slider_pin_normal_y
    slider_pin_push_on_main_bearing = slider_pin_push_x*(-rod_arm_y - slider_pin_pin_arm_y) + slider_pin_push_y*(rod_arm_x + slider_pin_pin_arm_x)
    slider_pin_push_on_crank_pin = slider_pin_pin_arm_x*slider_pin_push_y - slider_pin_pin_arm_y*slider_pin_push_x
    wear_couple_z = -slider_pin_gradient_force*wear_pin_slope
    slider_pin_sliding_velocity = slider_pin_normal_x*slider_pin_relative_rate_y - rod_rate_z*slider_pin_R_min - slider_pin_normal_y*slider_pin_relative_rate_x
    slider_pin_friction_force = slider_pin_normal_force*friction_coefficient*ca.tanh(inverse_friction_speed*slider_pin_sliding_velocity)
    slider_pin_friction_power = slider_pin_friction_force*slider_pin_sliding_velocity
    slider_pin_drag_x = slider_pin_friction_force*slider_pin_normal_y
    slider_pin_drag_y = -slider_pin_friction_force*slider_pin_normal_x
    slider_pin_R_min_times_slider_pin_normal_y = slider_pin_R_min*slider_pin_normal_y
    minus_slider_pin_R_min_times_slider_pin_normal_x = -slider_pin_R_min*slider_pin_normal_x
    slider_pin_drag_on_main_bearing = slider_pin_drag_x*(slider_pin_R_min_times_slider_pin_normal_y - rod_arm_y - slider_pin_pin_arm_y) + slider_pin_drag_y*(rod_arm_x + slider_pin_pin_arm_x + minus_slider_pin_R_min_times_slider_pin_normal_x)
    slider_pin_drag_on_crank_pin = slider_pin_drag_x*(slider_pin_R_min_times_slider_pin_normal_y - slider_pin_pin_arm_y) + slider_pin_drag_y*(slider_pin_pin_arm_x + minus_slider_pin_R_min_times_slider_pin_normal_x)
    slider_pin_in_range = ca.if_else(slider_pin_penetration <= slider_pin_R_min, 1, 0)
    wear_power = slider_pin_normal_force*ca.fabs(slider_pin_sliding_velocity)
    wear_pin_loss = repetitions_times_wear_rate*wear_power
    wear_pin_pace = inverse_wear_pin_sector*wear_pin_loss
    wear_pin_concentration = ca.dot(wear_pin_shares, ca.vertcat(wear_pin_shares))
    wear_bush_pace = inverse_wear_bush_sector*wear_pin_loss
    wear_bush_concentration = ca.dot(wear_bush_shares, ca.vertcat(wear_bush_shares))
    wear_recession = wear_bush_concentration*wear_bush_pace + wear_pin_concentration*wear_pin_pace
    slider_pin_wear_power = slider_pin_elastic_force*wear_recession
    return (ca.vertcat(slider_pin_drag_on_crank_pin + slider_pin_push_on_crank_pin + wear_couple_z, -slider_pin_drag_x - slider_pin_push_x,
            slider_pin_drag_on_main_bearing + slider_pin_push_on_main_bearing + wear_couple_z, wear_pin_pace*wear_pin_shares[0],
            wear_pin_pace*wear_pin_shares[1], wear_pin_pace*wear_pin_shares[2], wear_pin_pace*wear_pin_shares[3],
            wear_pin_pace*wear_pin_shares[4], wear_pin_pace*wear_pin_shares[5], wear_pin_pace*wear_pin_shares[6],
            wear_pin_pace*wear_pin_shares[7], wear_pin_pace*wear_pin_shares[8], wear_pin_pace*wear_pin_shares[9],
            wear_pin_pace*wear_pin_shares[10], wear_pin_pace*wear_pin_shares[11], wear_pin_pace*wear_pin_shares[12],
            wear_pin_pace*wear_pin_shares[13], wear_pin_pace*wear_pin_shares[14], wear_pin_pace*wear_pin_shares[15],
            wear_pin_pace*wear_pin_shares[16], wear_pin_pace*wear_pin_shares[17], wear_pin_pace*wear_pin_shares[18],
            wear_pin_pace*wear_pin_shares[19], wear_pin_pace*wear_pin_shares[20], wear_pin_pace*wear_pin_shares[21],
            wear_pin_pace*wear_pin_shares[22], wear_pin_pace*wear_pin_shares[23], wear_pin_pace*wear_pin_shares[24],
            wear_pin_pace*wear_pin_shares[25], wear_pin_pace*wear_pin_shares[26], wear_pin_pace*wear_pin_shares[27],
            wear_pin_pace*wear_pin_shares[28], wear_pin_pace*wear_pin_shares[29], wear_pin_pace*wear_pin_shares[30],
            wear_pin_pace*wear_pin_shares[31], wear_bush_pace*wear_bush_shares[0], wear_bush_pace*wear_bush_shares[1],
            wear_bush_pace*wear_bush_shares[2], wear_bush_pace*wear_bush_shares[3], wear_bush_pace*wear_bush_shares[4],
            wear_bush_pace*wear_bush_shares[5], wear_bush_pace*wear_bush_shares[6], wear_bush_pace*wear_bush_shares[7],
            wear_bush_pace*wear_bush_shares[8], wear_bush_pace*wear_bush_shares[9], wear_bush_pace*wear_bush_shares[10],
            wear_bush_pace*wear_bush_shares[11], wear_bush_pace*wear_bush_shares[12], wear_bush_pace*wear_bush_shares[13],
            wear_bush_pace*wear_bush_shares[14], wear_bush_pace*wear_bush_shares[15], wear_bush_pace*wear_bush_shares[16],
            wear_bush_pace*wear_bush_shares[17], wear_bush_pace*wear_bush_shares[18], wear_bush_pace*wear_bush_shares[19],
            wear_bush_pace*wear_bush_shares[20], wear_bush_pace*wear_bush_shares[21], wear_bush_pace*wear_bush_shares[22],
            wear_bush_pace*wear_bush_shares[23], wear_bush_pace*wear_bush_shares[24], wear_bush_pace*wear_bush_shares[25],
            wear_bush_pace*wear_bush_shares[26], wear_bush_pace*wear_bush_shares[27], wear_bush_pace*wear_bush_shares[28],
            wear_bush_pace*wear_bush_shares[29], wear_bush_pace*wear_bush_shares[30], wear_bush_pace*wear_bush_shares[31], wear_power),
        ca.vertcat(0, slider_pin_normal_power, slider_pin_friction_power, slider_pin_wear_power), ca.vertcat(slider_pin_normal_force),
        ca.vertcat(slider_pin_sliding_velocity), ca.vertcat(slider_pin_in_range))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (68,): crank_pin [N m], guide [N], main_bearing [N m], wear.pin_1 [m/s], wear.pin_2 [m/s], wear.pin_3 [m/s], wear.pin_4 [m/s],
            wear.pin_5 [m/s], wear.pin_6 [m/s], wear.pin_7 [m/s], wear.pin_8 [m/s], wear.pin_9 [m/s], wear.pin_10 [m/s], wear.pin_11 [m/s],
            wear.pin_12 [m/s], wear.pin_13 [m/s], wear.pin_14 [m/s], wear.pin_15 [m/s], wear.pin_16 [m/s], wear.pin_17 [m/s], wear.pin_18
            [m/s], wear.pin_19 [m/s], wear.pin_20 [m/s], wear.pin_21 [m/s], wear.pin_22 [m/s], wear.pin_23 [m/s], wear.pin_24 [m/s],
            wear.pin_25 [m/s], wear.pin_26 [m/s], wear.pin_27 [m/s], wear.pin_28 [m/s], wear.pin_29 [m/s], wear.pin_30 [m/s], wear.pin_31
            [m/s], wear.pin_32 [m/s], wear.bush_1 [m/s], wear.bush_2 [m/s], wear.bush_3 [m/s], wear.bush_4 [m/s], wear.bush_5 [m/s],
            wear.bush_6 [m/s], wear.bush_7 [m/s], wear.bush_8 [m/s], wear.bush_9 [m/s], wear.bush_10 [m/s], wear.bush_11 [m/s], wear.bush_12
            [m/s], wear.bush_13 [m/s], wear.bush_14 [m/s], wear.bush_15 [m/s], wear.bush_16 [m/s], wear.bush_17 [m/s], wear.bush_18 [m/s],
            wear.bush_19 [m/s], wear.bush_20 [m/s], wear.bush_21 [m/s], wear.bush_22 [m/s], wear.bush_23 [m/s], wear.bush_24 [m/s],
            wear.bush_25 [m/s], wear.bush_26 [m/s], wear.bush_27 [m/s], wear.bush_28 [m/s], wear.bush_29 [m/s], wear.bush_30 [m/s],
            wear.bush_31 [m/s], wear.bush_32 [m/s], wear.load_path [W]
    """
    crank_speed, gravity, rod_h_x, crank_h_x = c[4], c[5], c[35], c[36]
    crank_pin_angle = q[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    rod_moment_x = cos_rod*rod_h_x
    crank_moment_x = cos_crank*crank_h_x
    crank_total_moment_x = crank_moment_x + rod_moment_x
    return ca.vertcat(-rod_moment_x*gravity, 0, -crank_total_moment_x*gravity, *[0]*65)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (2,): crank_pin.acceleration [rad/s^2], guide.acceleration [m/s^2]
        reactions (1,): main_bearing.reaction [N m]
    """
    crank_radius, crank_speed, rod_h_x, crank_rate_zz, rod_I_z_z, inverse_rod_I_z_z = c[1], c[4], c[35], c[37], c[38], c[39]
    inverse_slider_mass = c[40]
    crank_pin_angle = q[0]
    crank_pin_speed = u[0]
    crank_pin_force, guide_force, main_bearing_force = f[0], f[1], f[2]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_rate_z = crank_pin_speed + crank_speed
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    rod_rate_zz = rod_rate_z*rod_rate_z
    rod_bias_x = -crank_rate_zz*rod_arm_x
    rod_bias_y = -crank_rate_zz*rod_arm_y
    rod_torque_z = rod_bias_y*rod_moment_x - rod_bias_x*rod_moment_y
    crank_pin_net = crank_pin_force - rod_torque_z
    crank_pin_rod_torque_z = rod_I_z_z + rod_arm_x*rod_moment_x + rod_arm_y*rod_moment_y
    crank_pin_acc = crank_pin_net*inverse_rod_I_z_z
    guide_acc = guide_force*inverse_slider_mass
    rod_force_x = -rod_moment_x*rod_rate_zz
    rod_force_y = -rod_moment_y*rod_rate_zz
    crank_torque_z = rod_torque_z + rod_arm_x*rod_force_y - rod_arm_y*rod_force_x
    main_bearing_reaction = crank_torque_z + crank_pin_acc*crank_pin_rod_torque_z - main_bearing_force
    return ca.vertcat(crank_pin_acc, guide_acc), ca.vertcat(main_bearing_reaction)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    crank_speed = c[4]
    main_bearing_reaction_in = reactions[0]
    return ca.vertcat(main_bearing_reaction_in*crank_speed, 0, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    rod_mass_centre, crank_radius, clearance, rod_length, crank_speed, k1, twice_clearance = c[0], c[1], c[2], c[3], c[4], c[9], c[12]
    k5, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15 = c[14], c[15], c[16], c[17], c[18], c[19], c[20], c[21], c[22], c[23], c[24]
    k16, k17, k18, k19, k20, rod_h_x, half_rod_I_z_z, half_slider_mass = c[25], c[26], c[27], c[28], c[29], c[35], c[41], c[42]
    half_rod_mass, half_crank_speed_squared_times_crank_inertia, gravity_times_rod_mass = c[43], c[44], c[45]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_pin_speed, guide_speed = u[0], u[1]
    wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7 = q[2], q[3], q[4], q[5], q[6], q[7], q[8]
    wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14 = q[9], q[10], q[11], q[12], q[13], q[14], q[15]
    wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20 = q[16], q[17], q[18], q[19], q[20], q[21]
    wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26 = q[22], q[23], q[24], q[25], q[26], q[27]
    wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32 = q[28], q[29], q[30], q[31], q[32], q[33]
    wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6 = q[34], q[35], q[36], q[37], q[38], q[39]
    wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12 = q[40], q[41], q[42], q[43], q[44], q[45]
    wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18 = q[46], q[47], q[48], q[49], q[50], q[51]
    wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24 = q[52], q[53], q[54], q[55], q[56], q[57]
    wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30 = q[58], q[59], q[60], q[61], q[62], q[63]
    wear_bush_31, wear_bush_32 = q[64], q[65]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    rod_arm_rate_x = -rod_arm_y*crank_speed
    rod_arm_rate_y = rod_arm_x*crank_speed
    rod_rate_z = crank_pin_speed + crank_speed
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    slider_pin_apart_squared = slider_pin_apart_x*slider_pin_apart_x + slider_pin_apart_y*slider_pin_apart_y
    wear_safe_squared = ca.if_else(slider_pin_apart_squared > 0.0625*clearance*clearance, slider_pin_apart_squared, k1)
    wear_length = ca.sqrt(wear_safe_squared)
    wear_radial_x = slider_pin_apart_x/wear_length
    wear_radial_y = slider_pin_apart_y/wear_length
    wear_pin_x = cos_rod*slider_pin_apart_x + sin_rod*slider_pin_apart_y
    wear_pin_y = cos_rod*slider_pin_apart_y - sin_rod*slider_pin_apart_x
    wear_pin_cosine = wear_pin_x/wear_length
    wear_pin_sine = wear_pin_y/wear_length
    wear_pin_shares = _shares(32, 0, wear_pin_cosine, wear_pin_sine)
    wear_pin_depth = ca.dot(wear_pin_shares, ca.vertcat(wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5, wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12, wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18, wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24, wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30, wear_pin_31, wear_pin_32))
    wear_bush_shares = _shares(32, 0, wear_radial_x, wear_radial_y)
    wear_bush_depth = ca.dot(wear_bush_shares, ca.vertcat(wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4, wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10, wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16, wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22, wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28, wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32))
    wear_depth = wear_bush_depth + wear_pin_depth
    slider_pin_distance = ca.sqrt(slider_pin_apart_squared)
    slider_pin_penetration = slider_pin_distance - wear_depth - clearance
    base_3 = slider_pin_penetration/(twice_clearance + 0.5995261983504611*slider_pin_penetration)
    base_4 = slider_pin_penetration/(twice_clearance + 1.5407223184360892*slider_pin_penetration)
    base_5 = slider_pin_penetration/(twice_clearance + 0.40950117867518615*slider_pin_penetration)
    base_6 = slider_pin_penetration/(twice_clearance + 1.8906860101801315*slider_pin_penetration)
    base_7 = slider_pin_penetration/(twice_clearance + 5.617008952561541e-05*slider_pin_penetration)
    base_8 = slider_pin_penetration/(twice_clearance + 0.2580467291264844*slider_pin_penetration)
    base_9 = slider_pin_penetration/(twice_clearance + 0.029913501726083053*slider_pin_penetration)
    base_10 = slider_pin_penetration/(twice_clearance + 0.14687290665052766*slider_pin_penetration)
    base_11 = slider_pin_penetration/(twice_clearance + 0.8212538306850022*slider_pin_penetration)
    base_12 = slider_pin_penetration/(twice_clearance + 0.009027486885869917*slider_pin_penetration)
    base_13 = slider_pin_penetration/(twice_clearance + 1.3087617711012016*slider_pin_penetration)
    base_14 = slider_pin_penetration/(twice_clearance + 1.7402898916615335*slider_pin_penetration)
    base_15 = slider_pin_penetration/(twice_clearance + 0.0015359640336663506*slider_pin_penetration)
    base_16 = slider_pin_penetration/(twice_clearance + 1.0629064619649824*slider_pin_penetration)
    base_17 = slider_pin_penetration/(twice_clearance + 0.07300928229591402*slider_pin_penetration)
    base_18 = slider_pin_penetration/(twice_clearance + 1.9788580400728255*slider_pin_penetration)
    slider_pin_stored_energy = ca.if_else(slider_pin_penetration > 0, slider_pin_penetration*(k10*slider_pin_penetration*ca.sqrt(base_8) + k11*slider_pin_penetration*ca.sqrt(base_9) + k12*slider_pin_penetration*ca.sqrt(base_10) + k13*slider_pin_penetration*ca.sqrt(base_11) + k14*slider_pin_penetration*ca.sqrt(base_12) + k15*slider_pin_penetration*ca.sqrt(base_13) + k16*slider_pin_penetration*ca.sqrt(base_14) + k17*slider_pin_penetration*ca.sqrt(base_15) + k18*slider_pin_penetration*ca.sqrt(base_16) + k19*slider_pin_penetration*ca.sqrt(base_17) + k20*slider_pin_penetration*ca.sqrt(base_18) + k5*slider_pin_penetration*ca.sqrt(base_3) + k6*slider_pin_penetration*ca.sqrt(base_4) + k7*slider_pin_penetration*ca.sqrt(base_5) + k8*slider_pin_penetration*ca.sqrt(base_6) + k9*slider_pin_penetration*ca.sqrt(base_7)), 0)
    rod_moment_x = cos_rod*rod_h_x
    rod_moment_y = rod_h_x*sin_rod
    kinetic = half_crank_speed_squared_times_crank_inertia + half_rod_I_z_z*rod_rate_z*rod_rate_z + half_slider_mass*guide_speed*guide_speed + half_rod_mass*(rod_arm_rate_x*rod_arm_rate_x + rod_arm_rate_y*rod_arm_rate_y) + rod_arm_rate_y*rod_moment_x*rod_rate_z - rod_arm_rate_x*rod_moment_y*rod_rate_z
    rod_centre_arm_y = sin_rod*rod_mass_centre
    potential = gravity_times_rod_mass*(rod_arm_y + rod_centre_arm_y)
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat(slider_pin_stored_energy)


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
    crank_radius, crank_speed = c[1], c[4]
    crank_pin_angle, guide_travel = q[0], q[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    return (ca.vertcat(0, 0, 0, rod_arm_x, rod_arm_y, 0, guide_travel, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_rod, -sin_rod, 0, sin_rod, cos_rod, 0, 0, 0, 1, 1, 0, 0,
            0, 1, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (3,): OUTPUTS
    """
    crank_radius, rod_length, crank_speed, wear_pin_sector, wear_bush_sector = c[1], c[3], c[4], c[7], c[8]
    crank_pin_angle, guide_travel, wear_pin_1, wear_pin_2, wear_pin_3, wear_pin_4, wear_pin_5 = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    wear_pin_6, wear_pin_7, wear_pin_8, wear_pin_9, wear_pin_10, wear_pin_11, wear_pin_12 = q[7], q[8], q[9], q[10], q[11], q[12], q[13]
    wear_pin_13, wear_pin_14, wear_pin_15, wear_pin_16, wear_pin_17, wear_pin_18 = q[14], q[15], q[16], q[17], q[18], q[19]
    wear_pin_19, wear_pin_20, wear_pin_21, wear_pin_22, wear_pin_23, wear_pin_24 = q[20], q[21], q[22], q[23], q[24], q[25]
    wear_pin_25, wear_pin_26, wear_pin_27, wear_pin_28, wear_pin_29, wear_pin_30 = q[26], q[27], q[28], q[29], q[30], q[31]
    wear_pin_31, wear_pin_32, wear_bush_1, wear_bush_2, wear_bush_3, wear_bush_4 = q[32], q[33], q[34], q[35], q[36], q[37]
    wear_bush_5, wear_bush_6, wear_bush_7, wear_bush_8, wear_bush_9, wear_bush_10 = q[38], q[39], q[40], q[41], q[42], q[43]
    wear_bush_11, wear_bush_12, wear_bush_13, wear_bush_14, wear_bush_15, wear_bush_16 = q[44], q[45], q[46], q[47], q[48], q[49]
    wear_bush_17, wear_bush_18, wear_bush_19, wear_bush_20, wear_bush_21, wear_bush_22 = q[50], q[51], q[52], q[53], q[54], q[55]
    wear_bush_23, wear_bush_24, wear_bush_25, wear_bush_26, wear_bush_27, wear_bush_28 = q[56], q[57], q[58], q[59], q[60], q[61]
    wear_bush_29, wear_bush_30, wear_bush_31, wear_bush_32 = q[62], q[63], q[64], q[65]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    rod_angle = crank_angle + crank_pin_angle
    cos_rod = ca.cos(rod_angle)
    sin_rod = ca.sin(rod_angle)
    rod_arm_x = cos_crank*crank_radius
    rod_arm_y = sin_crank*crank_radius
    slider_pin_pin_arm_x = cos_rod*rod_length
    slider_pin_pin_arm_y = sin_rod*rod_length
    slider_pin_apart_x = rod_arm_x + slider_pin_pin_arm_x - guide_travel
    slider_pin_apart_y = rod_arm_y + slider_pin_pin_arm_y
    return ca.vertcat(slider_pin_apart_x, slider_pin_apart_y, wear_bush_sector*(wear_bush_1 + wear_bush_10 + wear_bush_11 + wear_bush_12 +
        wear_bush_13 + wear_bush_14 + wear_bush_15 + wear_bush_16 + wear_bush_17 + wear_bush_18 + wear_bush_19 + wear_bush_2 + wear_bush_20
        + wear_bush_21 + wear_bush_22 + wear_bush_23 + wear_bush_24 + wear_bush_25 + wear_bush_26 + wear_bush_27 + wear_bush_28 +
        wear_bush_29 + wear_bush_3 + wear_bush_30 + wear_bush_31 + wear_bush_32 + wear_bush_4 + wear_bush_5 + wear_bush_6 + wear_bush_7 +
        wear_bush_8 + wear_bush_9) + wear_pin_sector*(wear_pin_1 + wear_pin_10 + wear_pin_11 + wear_pin_12 + wear_pin_13 + wear_pin_14 +
        wear_pin_15 + wear_pin_16 + wear_pin_17 + wear_pin_18 + wear_pin_19 + wear_pin_2 + wear_pin_20 + wear_pin_21 + wear_pin_22 +
        wear_pin_23 + wear_pin_24 + wear_pin_25 + wear_pin_26 + wear_pin_27 + wear_pin_28 + wear_pin_29 + wear_pin_3 + wear_pin_30 +
        wear_pin_31 + wear_pin_32 + wear_pin_4 + wear_pin_5 + wear_pin_6 + wear_pin_7 + wear_pin_8 + wear_pin_9))


def speed_limits(p):
    """Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        limits (1,): PAIRS [m/s]
    """
    youngs_modulus, density = p[13], p[15]
    return ca.vertcat(1e-05*ca.sqrt(youngs_modulus/density))


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[11]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent to guide.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        slider_pin.pin (4,): x [m], y [m], z [m], radius [m]
        slider_pin.bush (7,): x [m], y [m], z [m], radius [m], axis_x [1], axis_y [1], axis_z [1]
        crank_drive.child, gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, rod.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    rod_mass_centre, crank_radius, bush_radius, clearance, rod_length = p[4], p[6], p[7], p[8], p[10]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_radius, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(rod_length, 0, 0, bush_radius - clearance),
        ca.vertcat(0, 0, 0, bush_radius, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(rod_mass_centre, 0, 0), ca.vertcat(0, 0, 0))
