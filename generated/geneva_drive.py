"""geneva_drive: a pin that turns a slotted wheel by a quarter, in closed form within the play. Generated from derive/scenes/geneva_drive.py.

Do not edit; regenerate with `hertzwerk derive geneva_drive`.
Effects:
    motor: constant speed of shaft
    brake: viscous damper of axle
    slot: power x power_damping
    energy_ledger: work put in, energy dissipated per effect
Units: 60 assignments and 132 outputs checked, all consistent
Operations: flight 136 (equations of motion and gaps); in contact also contact_slot 57
"""

import casadi as ca

NAME = "geneva_drive"
SOURCE = "derive/scenes/geneva_drive.py"
SUMMARY = "a pin that turns a slotted wheel by a quarter, in closed form within the play"

EFFECTS = (
    ("motor", "drive", "constant speed of shaft"),
    ("brake", "damper", "viscous damper of axle"),
    ("slot", "contact", "power x power_damping"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

UNCHECKED = ()

PARAMETERS = (
    ("crank_mass", "kg", 0.3, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.0002, "body crank, inertia"),
    ("wheel_mass", "kg", 0.2, "body wheel, mass"),
    ("wheel_inertia", "kg m^2", 0.0001, "body wheel, inertia"),
    ("distance", "mm", 60, "of the axes"),
    ("rim", "mm", 43.5, ""),
    ("pin_radius", "mm", 4, "pair slot, radius"),
    ("play", "mm", 0.01, "half the width of a slot less the pin's radius"),
    ("root", "mm", 13, "curve slots, piece 1, end, x"),
    ("lock_radius", "mm", 30, ""),
    ("crank_speed", "rpm", 120, "effect motor, speed"),
    ("brake_damping", "N m s/rad", 0.02, "effect brake, damping"),
    ("contact_stiffness", "N/m", 100000000.0, "effect slot, stiffness of power"),
    ("contact_damping", "N s/m^2", 1000000000.0, "effect slot, coefficient of the damping of power_damping"),
    ("start_angle", "deg", 45, "start, position of axle"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("wheel_mass", "defined", 0, None, True, False, "body wheel, mass"),
    ("wheel_inertia", "defined", 0, None, False, False, "body wheel, inertia"),
    ("pin_radius", "defined", 0, None, True, False, "pair slot, radius"),
    ("brake_damping", "defined", 0, None, False, False, "effect brake, damping"),
    ("contact_stiffness", "defined", 0, None, True, False, "effect slot, stiffness of power"),
    ("contact_damping", "defined", 0, None, True, False, "effect slot, coefficient of the damping of power_damping"),
    ("play", "defined", 0, None, True, False, "scales, length"),
    ("distance", "defined", 0, None, True, False, "scales, arm"),
)

COORDINATES = (
    ("axle.angle", "rad"),
)

SPEEDS = (
    ("axle.speed", "rad/s"),
)

MEMORY = (
    ("energy_ledger.input", "J"),
    ("brake.dissipated", "J"),
    ("slot.dissipated", "J"),
)

LATCHES = ()

PAIRS = (
    ("slot", "circle_on_curve"),
)

RELEASES = (
    "force",
)

DISSIPATED = (
    2,
)

OUTPUTS = (
    ("slot.gap", "m"),
    ("slot.parameter", "1"),
)

BODIES = (
    "crank",
    "wheel",
)

LANDMARKS = (
    ("shaft", "revolute", "parent", "ground", ("axis",)),
    ("shaft", "revolute", "child", "crank", ("axis",)),
    ("axle", "revolute", "parent", "ground", ("axis",)),
    ("axle", "revolute", "child", "wheel", ("axis",)),
    ("slot", "circle_on_curve", "circle", "crank", ("radius",)),
    ("slot", "circle_on_curve", "fixed", "wheel", ("along", "across", "outline")),
    ("motor", "turn_drive", "child", "crank", ("axis",)),
    ("brake", "turn_damper", "child", "wheel", ("axis",)),
    ("crank", "body", "centre", "crank", ()),
    ("wheel", "body", "centre", "wheel", ()),
)

CONSTANTS = (
    ("distance", "m"),
    ("rim", "m"),
    ("pin_radius", "m"),
    ("play", "m"),
    ("root", "m"),
    ("lock_radius", "m"),
    ("crank_speed", "1/s"),
    ("brake_damping", "J s"),
    ("contact_stiffness", "N/m"),
    ("contact_damping", "Pa s"),
    ("quarter_of_sqrt_2_times_distance", "m"),
    ("quarter_of_sqrt_6_times_distance", "m"),
    ("slots_samples_1", "m"),
    ("slots_samples_2", "m"),
    ("slots_samples_3", "m"),
    ("slots_samples_4", "m"),
    ("slots_samples_5", "m"),
    ("slots_samples_6", "m"),
    ("slots_samples_7", "m"),
    ("slots_samples_8", "m"),
    ("slots_samples_9", "m"),
    ("slots_samples_10", "m"),
    ("slots_samples_11", "m"),
    ("slots_samples_12", "m"),
    ("slots_samples_13", "m"),
    ("slots_samples_14", "m"),
    ("slots_samples_15", "m"),
    ("slots_samples_16", "m"),
    ("slots_samples_17", "m"),
    ("slots_samples_18", "m"),
    ("slots_samples_19", "m"),
    ("slots_samples_20", "m"),
    ("slots_samples_21", "m"),
    ("slots_samples_22", "m"),
    ("slots_samples_23", "m"),
    ("slots_samples_24", "m"),
    ("slots_samples_25", "m"),
    ("slots_samples_26", "m"),
    ("slots_samples_27", "m"),
    ("slots_samples_28", "m"),
    ("slots_samples_29", "m"),
    ("slots_samples_30", "m"),
    ("slots_samples_31", "m"),
    ("slots_samples_32", "m"),
    ("slots_samples_33", "m"),
    ("slots_samples_34", "m"),
    ("slots_samples_35", "m"),
    ("slots_samples_36", "m"),
    ("slots_samples_37", "m"),
    ("slots_samples_38", "m"),
    ("slots_samples_39", "m"),
    ("slots_samples_40", "m"),
    ("slots_samples_41", "m"),
    ("slots_samples_42", "m"),
    ("slots_samples_43", "m"),
    ("slots_samples_44", "m"),
    ("slots_samples_45", "m"),
    ("slots_samples_46", "m"),
    ("slots_samples_47", "m"),
    ("slots_samples_48", "m"),
    ("slots_samples_49", "m"),
    ("slots_samples_50", "m"),
    ("slots_samples_51", "m"),
    ("slots_samples_52", "m"),
    ("slots_samples_53", "m"),
    ("slots_samples_54", "m"),
    ("slots_samples_55", "m"),
    ("slots_samples_56", "m"),
    ("slots_samples_57", "m"),
    ("slots_samples_58", "m"),
    ("slots_samples_59", "m"),
    ("slots_samples_60", "m"),
    ("slots_samples_61", "m"),
    ("slots_samples_62", "m"),
    ("slots_samples_63", "m"),
    ("slots_samples_64", "m"),
    ("slots_samples_65", "m"),
    ("slots_samples_66", "m"),
    ("slots_samples_67", "m"),
    ("slots_samples_68", "m"),
    ("slots_samples_69", "m"),
    ("slots_samples_70", "m"),
    ("slots_samples_71", "m"),
    ("slots_samples_72", "m"),
    ("slots_samples_73", "m"),
    ("slots_samples_74", "m"),
    ("slots_samples_75", "m"),
    ("slots_samples_76", "m"),
    ("slots_samples_77", "m"),
    ("slots_samples_78", "m"),
    ("slots_samples_79", "m"),
    ("slots_samples_80", "m"),
    ("slots_samples_81", "m"),
    ("slots_samples_82", "m"),
    ("slots_samples_83", "m"),
    ("slots_samples_84", "m"),
    ("slots_samples_85", "m"),
    ("slots_samples_86", "m"),
    ("slots_samples_87", "m"),
    ("slots_samples_88", "m"),
    ("slots_samples_89", "m"),
    ("slots_samples_90", "m"),
    ("slots_samples_91", "m"),
    ("slots_samples_92", "m"),
    ("slots_samples_93", "m"),
    ("slots_samples_94", "m"),
    ("slots_samples_95", "m"),
    ("slots_samples_96", "m"),
    ("slots_samples_97", "m"),
    ("slots_samples_98", "m"),
    ("slots_samples_99", "m"),
    ("slots_samples_100", "m"),
    ("slots_samples_101", "m"),
    ("slots_samples_102", "m"),
    ("slots_samples_103", "m"),
    ("slots_samples_104", "m"),
    ("slots_samples_105", "m"),
    ("slots_samples_106", "m"),
    ("slots_samples_107", "m"),
    ("slots_samples_108", "m"),
    ("slots_samples_109", "m"),
    ("slots_samples_110", "m"),
    ("slots_samples_111", "m"),
    ("slots_samples_112", "m"),
    ("slots_samples_113", "m"),
    ("slots_samples_114", "m"),
    ("slots_samples_115", "m"),
    ("slots_samples_116", "m"),
    ("slots_samples_117", "m"),
    ("slots_samples_118", "m"),
    ("slots_samples_119", "m"),
    ("slots_samples_120", "m"),
    ("slots_samples_121", "m"),
    ("slots_samples_122", "m"),
    ("slots_samples_123", "m"),
    ("slots_samples_124", "m"),
    ("slots_samples_125", "m"),
    ("slots_samples_126", "m"),
    ("slots_samples_127", "m"),
    ("slots_samples_128", "m"),
    ("slots_samples_129", "m"),
    ("slots_samples_130", "m"),
    ("slots_samples_131", "m"),
    ("slots_samples_132", "m"),
    ("slots_samples_133", "m"),
    ("slots_samples_134", "m"),
    ("slots_samples_135", "m"),
    ("slots_samples_136", "m"),
    ("slots_samples_137", "m"),
    ("slots_samples_138", "m"),
    ("slots_samples_139", "m"),
    ("slots_samples_140", "m"),
    ("slots_samples_141", "m"),
    ("slots_samples_142", "m"),
    ("slots_samples_143", "m"),
    ("slots_samples_144", "m"),
    ("half_contact_stiffness", "N/m"),
    ("inverse_wheel_inertia", "1/(kg m^2)"),
    ("half_wheel_inertia", "kg m^2"),
    ("half_crank_speed_squared_times_crank_inertia", "J"),
)

OPERATIONS = (
    ("constants", 13),
    ("start", 0),
    ("scales", 14),
    ("coordinate_rates", 0),
    ("gaps", 43),
    ("gap_accelerations", 89),
    ("contact_slot", 57),
    ("applied", 2),
    ("accelerations", 2),
    ("ledger", 5),
    ("energy", 28),
    ("poses", 7),
    ("outputs", 20),
    ("period", 3),
    ("landmarks", 8),
)

SLOTS_CURVE = (
    True,
    False,
    (0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1),
)


def _samples_of_chain(pieces, data, given):
    """Pieces of a chain of arcs and lines: start x, y, end x, y, centre x, y of each."""
    return ca.vertcat(*pieces(*ca.vertsplit(given)))


def _drawn_of_chain(pieces, data, given):
    """Points of a chain of arcs and lines for a picture, first all x, then all y."""
    values, (closed, _, turns) = pieces(*ca.vertsplit(given)), data
    points = []
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        angle = ca.atan2(turn*(ux*vy - uy*vx), ux*vx + uy*vy)
        angle = turn*(angle + 2*ca.pi*(angle <= 0))
        for j in range(25 if turn else 1):
            c, s = ca.cos(angle*j/25), ca.sin(angle*j/25)
            points.append((cx + ux*c - uy*s, cy + ux*s + uy*c) if turn else (ax, ay))
    points.append(values[-4:-2] if not closed else points[0])
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _nearest_of_chain(pieces, data, samples, given, point):
    """Signed distance of a point from a chain of arcs and lines, as of a curve; its parameter is the piece and the part of it.

    The least of the distances of all pieces, where the point is beside them, and of all corners, each in closed form. A
    function of its own, which is called; its derivatives are the results themselves.
    """
    if pieces not in _NEAREST_OF_CHAIN:
        closed, hole, turns = data
        side, count = -1 if hole else 1, len(turns)
        rows, values, p = ca.SX.sym("samples", 6*count), ca.SX.sym("given", given.numel()), ca.SX.sym("point", 2)
        found, ends = [], []
        for k, turn in enumerate(turns):
            a, b, c = rows[6*k : 6*k + 2], rows[6*k + 2 : 6*k + 4], rows[6*k + 4 : 6*k + 6]
            if turn:
                u, v, w = a - c, b - c, p - c
                radius, away = ca.sqrt(u[0]**2 + u[1]**2), ca.sqrt(w[0]**2 + w[1]**2)
                whole, part = (turn*ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (v, w))
                share = (part + 2*ca.pi*(part < 0))/(whole + 2*ca.pi*(whole <= 0))
                least = ca.fmax(away, 1e-12*radius)
                pace = 1/(least*(whole + 2*ca.pi*(whole <= 0)))
                found.append((share <= 1, turn*side*(away - radius), turn*side*w/least, turn*side/least, k + share, pace))
                ends.append((turn*u/radius, turn*v/radius))
            else:
                way, w = b - a, p - a
                length = ca.sqrt(way[0]**2 + way[1]**2)
                n = ca.vertcat(way[1], -way[0])/length
                share = (w[0]*way[0] + w[1]*way[1])/length**2
                beside = ca.logic_and(share >= 0, share <= 1)
                found.append((beside, side*(w[0]*n[0] + w[1]*n[1]), side*n, 0, k + share, 1/length))
                ends.append((n, n))
        for k in range(count + (not closed)):
            corner = rows[6*k : 6*k + 2] if k < count else rows[-4:-2]
            w = p - corner
            away = ca.sqrt(w[0]**2 + w[1]**2)
            least = ca.fmax(away, 1e-300)
            sign = 1
            if closed or 0 < k < count:  # outside by the sum of both normals
                n = ends[k - 1][1] + ends[k][0]
                sign = ca.if_else(side*(w[0]*n[0] + w[1]*n[1]) < 0, -1, 1)
            found.append((1, sign*away, sign*w/least, sign/least, k, 0))
        best, result = 1e300, ca.SX.zeros(6)
        for beside, h, n, bend, s, pace in found:
            here = ca.if_else(beside, ca.fabs(h), 1e300)
            result = ca.if_else(here < best, ca.vertcat(h, n, bend, s, side*pace), result)
            best = ca.fmin(here, best)
        o = ca.SX.sym("o", 6)
        n, t = ca.vertcat(o[1], o[2]), ca.vertcat(-o[2], o[1])
        inputs = [rows, values, p]
        slopes = ca.Function(
            "jac_nearest", [*(ca.SX.sym("i", x.shape) for x in inputs), o],
            [ca.SX(6, rows.numel()), ca.SX(6, given.numel()), ca.vertcat(n.T, o[3]*t@t.T, ca.SX(1, 2), o[5]*t.T, ca.SX(1, 2))],
            ["samples", "given", "point", "out_found"], ["jac_found_samples", "jac_found_given", "jac_found_point"],
        )
        called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
        _NEAREST_OF_CHAIN[pieces] = ca.Function("nearest", inputs, [ca.densify(result)], ["samples", "given", "point"], ["found"], called)
    return _NEAREST_OF_CHAIN[pieces](samples, given, point)


_NEAREST_OF_CHAIN: "dict[object, ca.Function]" = {}


def slots_curve(rim, pin_radius, play, root, distance, lock_radius):
    """Pieces of the chain slots: start x, y, end x, y, centre x, y of each."""
    rim_squared = rim*rim
    pin_radius_plus_play = pin_radius + play
    x3 = pin_radius_plus_play*pin_radius_plus_play
    x4 = -x3
    x5 = rim_squared + x4
    x6 = ca.sqrt(x5)
    minus_pin_radius_minus_play = -pin_radius - play
    sqrt_2 = ca.sqrt(2)
    distance_squared = distance*distance
    lock_radius_squared = lock_radius*lock_radius
    minus_lock_radius_squared = -lock_radius_squared
    x12 = rim_squared + minus_lock_radius_squared + distance_squared
    x13 = x12*x12
    inverse_distance_squared = 1/(distance*distance)
    x15 = -x13*inverse_distance_squared/4
    x16 = rim_squared + x15
    x17 = ca.sqrt(x16)
    x18 = x17*sqrt_2/2
    x19 = x12*sqrt_2/(4*distance)
    x20 = x18 + x19
    x21 = -x17*sqrt_2/2
    x22 = x19 + x21
    half_sqrt_2_times_distance = sqrt_2*distance/2
    x24 = -x12*sqrt_2/(4*distance)
    x25 = x18 + x24
    x26 = x21 + x24
    minus_half_sqrt_2_times_distance = -sqrt_2*distance/2
    x28 = -x6
    return x6, minus_pin_radius_minus_play, root, minus_pin_radius_minus_play, x6, minus_pin_radius_minus_play, root, minus_pin_radius_minus_play, root, pin_radius_plus_play, root, 0, root, pin_radius_plus_play, x6, pin_radius_plus_play, root, pin_radius_plus_play, x6, pin_radius_plus_play, x20, x22, 0, 0, x20, x22, x22, x20, half_sqrt_2_times_distance, half_sqrt_2_times_distance, x22, x20, pin_radius_plus_play, x6, 0, 0, pin_radius_plus_play, x6, pin_radius_plus_play, root, pin_radius_plus_play, x6, pin_radius_plus_play, root, minus_pin_radius_minus_play, root, 0, root, minus_pin_radius_minus_play, root, minus_pin_radius_minus_play, x6, minus_pin_radius_minus_play, root, minus_pin_radius_minus_play, x6, x25, x20, 0, 0, x25, x20, x26, x22, minus_half_sqrt_2_times_distance, half_sqrt_2_times_distance, x26, x22, x28, pin_radius_plus_play, 0, 0, x28, pin_radius_plus_play, -root, pin_radius_plus_play, x28, pin_radius_plus_play, -root, pin_radius_plus_play, -root, minus_pin_radius_minus_play, -root, 0, -root, minus_pin_radius_minus_play, x28, minus_pin_radius_minus_play, -root, minus_pin_radius_minus_play, x28, minus_pin_radius_minus_play, x26, x25, 0, 0, x26, x25, x25, x26, minus_half_sqrt_2_times_distance, minus_half_sqrt_2_times_distance, x25, x26, minus_pin_radius_minus_play, x28, 0, 0, minus_pin_radius_minus_play, x28, minus_pin_radius_minus_play, -root, minus_pin_radius_minus_play, x28, minus_pin_radius_minus_play, -root, pin_radius_plus_play, -root, 0, -root, pin_radius_plus_play, -root, pin_radius_plus_play, x28, pin_radius_plus_play, -root, pin_radius_plus_play, x28, x22, x26, 0, 0, x22, x26, x20, x25, half_sqrt_2_times_distance, minus_half_sqrt_2_times_distance, x20, x25, x6, minus_pin_radius_minus_play, 0, 0


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (17,): distance, rim, pin_radius, play, root, lock_radius, crank_speed, brake_damping, contact_stiffness,
            contact_damping, quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples,
            half_contact_stiffness, inverse_wheel_inertia, half_wheel_inertia,
            half_crank_speed_squared_times_crank_inertia
    """
    crank_inertia = p[1]
    wheel_inertia = p[3]
    distance = p[4]
    rim = p[5]
    pin_radius = p[6]
    play = p[7]
    root = p[8]
    lock_radius = p[9]
    crank_speed = p[10]
    brake_damping = p[11]
    contact_stiffness = p[12]
    contact_damping = p[13]
    quarter_of_sqrt_2_times_distance = ca.sqrt(2)*distance/4
    quarter_of_sqrt_6_times_distance = ca.sqrt(6)*distance/4
    slots_samples = _samples_of_chain(slots_curve, SLOTS_CURVE, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius))
    half_contact_stiffness = contact_stiffness/2
    inverse_wheel_inertia = 1/wheel_inertia
    half_wheel_inertia = wheel_inertia/2
    half_crank_speed_squared_times_crank_inertia = crank_speed*crank_speed*crank_inertia/2
    return ca.vertcat(distance, rim, pin_radius, play, root, lock_radius, crank_speed, brake_damping,
        contact_stiffness, contact_damping, quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance,
        slots_samples, half_contact_stiffness, inverse_wheel_inertia, half_wheel_inertia,
        half_crank_speed_squared_times_crank_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): axle.angle [rad]
        u (1,): axle.speed [rad/s]
    """
    start_angle = p[14]
    return ca.vertcat(start_angle), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): axle.angle [rad]
        su (1,): axle.speed [rad/s]
        sz (3,): energy_ledger.input [J], brake.dissipated [J], slot.dissipated [J]
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass = p[0]
    wheel_mass = p[2]
    distance = p[4]
    play = p[7]
    crank_speed = p[10]
    total_mass = crank_mass + wheel_mass
    energy_scale = total_mass*crank_speed*crank_speed*distance*distance/400
    force_scale = energy_scale/play
    sqrt_2 = ca.sqrt(2)
    return (
        ca.vertcat(play/distance),
        ca.vertcat(sqrt_2*crank_speed/20),
        ca.vertcat(energy_scale, energy_scale, energy_scale),
        ca.vertcat(play, sqrt_2*crank_speed*distance/20, force_scale, energy_scale),
    )


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): axle.angle [rad/s]
    """
    axle_speed = u[0]
    return ca.vertcat(axle_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): slot [m]
        dG (1,): slot [m/s]
    """
    distance = c[0]
    rim = c[1]
    pin_radius = c[2]
    play = c[3]
    root = c[4]
    lock_radius = c[5]
    crank_speed = c[6]
    quarter_of_sqrt_2_times_distance = c[10]
    quarter_of_sqrt_6_times_distance = c[11]
    slots_samples = c[12:156]
    axle_angle = q[0]
    axle_speed = u[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos_crank*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin_crank
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin_crank - cos_crank*quarter_of_sqrt_6_times_distance
    slot_first_arm_rate_x = -slot_first_arm_y*crank_speed
    slot_first_arm_rate_y = slot_first_arm_x*crank_speed
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_normal_x = slot_nearest[1]
    slot_normal_y = slot_nearest[2]
    cos_wheel_rate = -axle_speed*sin_wheel
    sin_wheel_rate = axle_speed*cos_wheel
    slot_local_x_rate = cos_wheel*slot_first_arm_rate_x + cos_wheel_rate*slot_apart_x + sin_wheel*slot_first_arm_rate_y + sin_wheel_rate*slot_first_arm_y
    slot_local_y_rate = cos_wheel*slot_first_arm_rate_y + cos_wheel_rate*slot_first_arm_y - sin_wheel*slot_first_arm_rate_x - sin_wheel_rate*slot_apart_x
    slot_distance_rate = slot_local_x_rate*slot_normal_x + slot_local_y_rate*slot_normal_y
    slot_gap = slot_distance - pin_radius
    return ca.vertcat(slot_gap), ca.vertcat(slot_distance_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): slot [m/s^2]
    """
    distance = c[0]
    rim = c[1]
    pin_radius = c[2]
    play = c[3]
    root = c[4]
    lock_radius = c[5]
    crank_speed = c[6]
    quarter_of_sqrt_2_times_distance = c[10]
    quarter_of_sqrt_6_times_distance = c[11]
    slots_samples = c[12:156]
    axle_angle = q[0]
    axle_speed = u[0]
    axle_acceleration = a[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos_crank*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin_crank
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin_crank - cos_crank*quarter_of_sqrt_6_times_distance
    slot_first_arm_rate_x = -slot_first_arm_y*crank_speed
    slot_first_arm_rate_y = slot_first_arm_x*crank_speed
    slot_apart_x = slot_first_arm_x - distance
    slot_apart_acceleration_x = -slot_first_arm_rate_y*crank_speed
    slot_apart_acceleration_y = slot_first_arm_rate_x*crank_speed
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_normal_x = slot_nearest[1]
    slot_normal_y = slot_nearest[2]
    slot_bend = slot_nearest[3]
    cos_wheel_rate = -axle_speed*sin_wheel
    sin_wheel_rate = axle_speed*cos_wheel
    slot_local_x_rate = cos_wheel*slot_first_arm_rate_x + cos_wheel_rate*slot_apart_x + sin_wheel*slot_first_arm_rate_y + sin_wheel_rate*slot_first_arm_y
    slot_local_y_rate = cos_wheel*slot_first_arm_rate_y + cos_wheel_rate*slot_first_arm_y - sin_wheel*slot_first_arm_rate_x - sin_wheel_rate*slot_apart_x
    slot_along_curve = slot_local_y_rate*slot_normal_x - slot_local_x_rate*slot_normal_y
    slot_turning = slot_along_curve*slot_bend
    axle_speed_squared = axle_speed*axle_speed
    cos_wheel_rate_rate = -axle_acceleration*sin_wheel - cos_wheel*axle_speed_squared
    sin_wheel_rate_rate = axle_acceleration*cos_wheel - sin_wheel*axle_speed_squared
    slot_local_x_rate_rate = cos_wheel*slot_apart_acceleration_x + cos_wheel_rate_rate*slot_apart_x + sin_wheel*slot_apart_acceleration_y + sin_wheel_rate_rate*slot_first_arm_y + 2*cos_wheel_rate*slot_first_arm_rate_x + 2*sin_wheel_rate*slot_first_arm_rate_y
    slot_local_y_rate_rate = cos_wheel*slot_apart_acceleration_y + cos_wheel_rate_rate*slot_first_arm_y + 2*cos_wheel_rate*slot_first_arm_rate_y - sin_wheel*slot_apart_acceleration_x - sin_wheel_rate_rate*slot_apart_x - 2*sin_wheel_rate*slot_first_arm_rate_x
    slot_distance_rate_rate = slot_local_x_rate_rate*slot_normal_x + slot_local_y_rate_rate*slot_normal_y + slot_local_y_rate*slot_normal_x*slot_turning - slot_local_x_rate*slot_normal_y*slot_turning
    return ca.vertcat(slot_distance_rate_rate)


def contact_slot(t, q, u, z, m, c):
    """Forces of slot: power x power_damping. The normal force is the laws' own, not clamped: where it would pull,
    the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): axle [N m], shaft [N m]
        dz (3,): energy_ledger.input [W], brake.dissipated [W], slot.dissipated [W]
        normal_force (1,): slot [N]
        sliding_velocity (0,): empty
        in_range (1,): slot [1]
    """
    distance = c[0]
    rim = c[1]
    pin_radius = c[2]
    play = c[3]
    root = c[4]
    lock_radius = c[5]
    crank_speed = c[6]
    contact_stiffness = c[8]
    contact_damping = c[9]
    quarter_of_sqrt_2_times_distance = c[10]
    quarter_of_sqrt_6_times_distance = c[11]
    slots_samples = c[12:156]
    axle_angle = q[0]
    axle_speed = u[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos_crank*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin_crank
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin_crank - cos_crank*quarter_of_sqrt_6_times_distance
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_normal_x = slot_nearest[1]
    slot_normal_y = slot_nearest[2]
    slot_gap = slot_distance - pin_radius
    slot_elastic_force = ca.if_else(-slot_gap > 0, -slot_gap*contact_stiffness, 0)
    slot_normal_x_2 = cos_wheel*slot_normal_x - sin_wheel*slot_normal_y
    slot_normal_y_2 = cos_wheel*slot_normal_y + sin_wheel*slot_normal_x
    slot_relative_rate_x = axle_speed*slot_first_arm_y - slot_first_arm_y*crank_speed
    slot_relative_rate_y = slot_first_arm_x*crank_speed - axle_speed*slot_apart_x
    slot_penetration_rate = -slot_normal_x_2*slot_relative_rate_x - slot_normal_y_2*slot_relative_rate_y
    slot_resistance = ca.if_else(-slot_gap > 0, -slot_gap*slot_penetration_rate*contact_damping, 0)
    slot_normal_force = slot_elastic_force + slot_resistance
    slot_normal_power = slot_penetration_rate*slot_resistance
    slot_push_x = slot_normal_force*slot_normal_x_2
    slot_push_y = slot_normal_force*slot_normal_y_2
    slot_push_on_shaft = slot_first_arm_x*slot_push_y - slot_first_arm_y*slot_push_x
    slot_push_on_axle = slot_first_arm_y*slot_push_x - slot_apart_x*slot_push_y
    return (
        ca.vertcat(slot_push_on_axle, slot_push_on_shaft),
        ca.vertcat(0, 0, slot_normal_power),
        ca.vertcat(slot_normal_force),
        ca.vertcat(),
        ca.vertcat(1),
    )


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): axle [N m], shaft [N m]
    """
    brake_damping = c[7]
    axle_speed = u[0]
    brake_force = -axle_speed*brake_damping
    return ca.vertcat(brake_force, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): axle.acceleration [rad/s^2]
        reactions (1,): shaft.reaction [N m]
    """
    inverse_wheel_inertia = c[157]
    axle_force = f[0]
    shaft_force = f[1]
    axle_acc = axle_force*inverse_wheel_inertia
    return ca.vertcat(axle_acc), ca.vertcat(-shaft_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (3,): energy_ledger.input [W], brake.dissipated [W], slot.dissipated [W]
    """
    crank_speed = c[6]
    brake_damping = c[7]
    axle_speed = u[0]
    shaft_reaction_in = reactions[0]
    brake_force = -axle_speed*brake_damping
    return ca.vertcat(shaft_reaction_in*crank_speed, -axle_speed*brake_force, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): slot [J]
    """
    distance = c[0]
    rim = c[1]
    pin_radius = c[2]
    play = c[3]
    root = c[4]
    lock_radius = c[5]
    crank_speed = c[6]
    quarter_of_sqrt_2_times_distance = c[10]
    quarter_of_sqrt_6_times_distance = c[11]
    slots_samples = c[12:156]
    half_contact_stiffness = c[156]
    half_wheel_inertia = c[158]
    half_crank_speed_squared_times_crank_inertia = c[159]
    axle_angle = q[0]
    axle_speed = u[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos_crank*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin_crank
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin_crank - cos_crank*quarter_of_sqrt_6_times_distance
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_gap = slot_distance - pin_radius
    slot_stored_energy = ca.if_else(-slot_gap > 0, half_contact_stiffness*slot_gap*slot_gap, 0)
    kinetic = half_crank_speed_squared_times_crank_inertia + half_wheel_inertia*axle_speed*axle_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(slot_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): crank.x [m], crank.y [m], crank.z [m], wheel.x [m], wheel.y [m], wheel.z [m]
        rotations (18,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz
            [1], crank.R_zx [1], crank.R_zy [1], crank.R_zz [1], wheel.R_xx [1], wheel.R_xy [1], wheel.R_xz [1],
            wheel.R_yx [1], wheel.R_yy [1], wheel.R_yz [1], wheel.R_zx [1], wheel.R_zy [1], wheel.R_zz [1]
    """
    distance = c[0]
    crank_speed = c[6]
    axle_angle = q[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    return (
        ca.vertcat(0, 0, 0, distance, 0, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_wheel, -sin_wheel, 0, sin_wheel,
            cos_wheel, 0, 0, 0, 1),
    )


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): slot.gap [m], slot.parameter [1]
    """
    distance = c[0]
    rim = c[1]
    pin_radius = c[2]
    play = c[3]
    root = c[4]
    lock_radius = c[5]
    crank_speed = c[6]
    quarter_of_sqrt_2_times_distance = c[10]
    quarter_of_sqrt_6_times_distance = c[11]
    slots_samples = c[12:156]
    axle_angle = q[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos_crank*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin_crank
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin_crank - cos_crank*quarter_of_sqrt_6_times_distance
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_parameter = slot_nearest[4]
    slot_gap = slot_distance - pin_radius
    return ca.vertcat(slot_gap, slot_parameter)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[10]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        shaft.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        shaft.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        axle.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        axle.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        slot.circle (4,): x [m], y [m], z [m], radius [m]
        slot.fixed (10,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1], across_x [1], across_y [1],
            across_z [1], outline
        motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        brake.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre (3,): x [m], y [m], z [m]
        wheel.centre (3,): x [m], y [m], z [m]
    """
    distance = p[4]
    rim = p[5]
    pin_radius = p[6]
    play = p[7]
    root = p[8]
    lock_radius = p[9]
    return (
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(distance, 0, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(ca.sqrt(2)*distance/4, -ca.sqrt(6)*distance/4, 0, pin_radius),
        ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, _drawn_of_chain(slots_curve, SLOTS_CURVE, ca.vertcat(rim, pin_radius,
            play, root, distance, lock_radius))),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0, 0, 0, 1),
        ca.vertcat(0, 0, 0),
        ca.vertcat(0, 0, 0),
    )
