"""geneva_drive: a pin turns a slotted wheel, a disc locks it. Generated from derive/scenes/geneva_drive.py.

Do not edit; regenerate with `hertzwerk derive geneva_drive`.
Effects:
    motor: constant speed of shaft
    slot, lock: power x power_damping
    energy_ledger: work put in, energy dissipated per effect
Units: 107 assignments and 163 outputs checked, all consistent
Operations: flight 228 (equations of motion and gaps); in contact also contact_slot 57, contact_lock 67
"""

import casadi as ca

NAME = "geneva_drive"
SOURCE = "derive/scenes/geneva_drive.py"
SUMMARY = "a pin turns a slotted wheel, a disc locks it"
FORMAT = "hertzwerk module 1"
DIGEST = "47c3c19e3ee494ee78fc9fb1fb471c66"

EFFECTS = (
    ("motor", "drive", "constant speed of shaft"), ("slot", "contact", "power x power_damping"),
    ("lock", "contact", "power x power_damping"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

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
    ("lock_play", "mm", 0.01, "radius of the hollows less that of the locking disc"),
    ("hub", "mm", 5, "from the crank's axis to the bottom of the disc's recess"),
    ("crank_speed", "rpm", 120, "effect motor, speed"),
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
    ("contact_stiffness", "defined", 0, None, True, False, "effect slot, stiffness of power"),
    ("contact_damping", "defined", 0, None, True, False, "effect slot, coefficient of the damping of power_damping"),
    ("play", "defined", 0, None, True, False, "scales, length"),
    ("distance", "defined", 0, None, True, False, "scales, arm"),
)

COORDINATES = (("axle.angle", "rad"),)

SPEEDS = (("axle.speed", "rad/s"),)

MEMORY = (("energy_ledger.input", "J"), ("slot.dissipated", "J"), ("lock.dissipated", "J"))

PAIRS = (("slot", "circle_on_curve"), ("lock", "curve_on_curve"))

RELEASES = ("force", "force")

DISSIPATED = (1, 2)

OUTPUTS = (("slot.gap", "m"), ("slot.parameter", "1"), ("lock.gap", "m"), ("lock.first_parameter", "1"), ("lock.second_parameter", "1"))

BODIES = ("crank", "wheel")

LANDMARKS = (
    ("shaft", "revolute", "parent", "ground", ("axis",)), ("shaft", "revolute", "child", "crank", ("axis",)),
    ("axle", "revolute", "parent", "ground", ("axis",)), ("axle", "revolute", "child", "wheel", ("axis",)),
    ("slot", "circle_on_curve", "circle", "crank", ("radius",)),
    ("slot", "circle_on_curve", "fixed", "wheel", ("along", "across", "outline")),
    ("lock", "curve_on_curve", "first", "crank", ("along", "across", "outline")),
    ("lock", "curve_on_curve", "second", "wheel", ("along", "across", "outline")), ("motor", "turn_drive", "child", "crank", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("wheel", "body", "centre", "wheel", ()),
)

CONSTANTS = (
    ("distance", "m"), ("rim", "m"), ("pin_radius", "m"), ("play", "m"), ("root", "m"), ("lock_radius", "m"), ("lock_play", "m"),
    ("hub", "m"), ("crank_speed", "1/s"), ("contact_stiffness", "N/m"), ("contact_damping", "Pa s"),
    ("quarter_of_sqrt_2_times_distance", "m"), ("quarter_of_sqrt_6_times_distance", "m"), ("slots_samples_1", "m"),
    ("slots_samples_2", "m"), ("slots_samples_3", "m"), ("slots_samples_4", "m"), ("slots_samples_5", "m"), ("slots_samples_6", "m"),
    ("slots_samples_7", "m"), ("slots_samples_8", "m"), ("slots_samples_9", "m"), ("slots_samples_10", "m"), ("slots_samples_11", "m"),
    ("slots_samples_12", "m"), ("slots_samples_13", "m"), ("slots_samples_14", "m"), ("slots_samples_15", "m"), ("slots_samples_16", "m"),
    ("slots_samples_17", "m"), ("slots_samples_18", "m"), ("slots_samples_19", "m"), ("slots_samples_20", "m"), ("slots_samples_21", "m"),
    ("slots_samples_22", "m"), ("slots_samples_23", "m"), ("slots_samples_24", "m"), ("slots_samples_25", "m"), ("slots_samples_26", "m"),
    ("slots_samples_27", "m"), ("slots_samples_28", "m"), ("slots_samples_29", "m"), ("slots_samples_30", "m"), ("slots_samples_31", "m"),
    ("slots_samples_32", "m"), ("slots_samples_33", "m"), ("slots_samples_34", "m"), ("slots_samples_35", "m"), ("slots_samples_36", "m"),
    ("slots_samples_37", "m"), ("slots_samples_38", "m"), ("slots_samples_39", "m"), ("slots_samples_40", "m"), ("slots_samples_41", "m"),
    ("slots_samples_42", "m"), ("slots_samples_43", "m"), ("slots_samples_44", "m"), ("slots_samples_45", "m"), ("slots_samples_46", "m"),
    ("slots_samples_47", "m"), ("slots_samples_48", "m"), ("slots_samples_49", "m"), ("slots_samples_50", "m"), ("slots_samples_51", "m"),
    ("slots_samples_52", "m"), ("slots_samples_53", "m"), ("slots_samples_54", "m"), ("slots_samples_55", "m"), ("slots_samples_56", "m"),
    ("slots_samples_57", "m"), ("slots_samples_58", "m"), ("slots_samples_59", "m"), ("slots_samples_60", "m"), ("slots_samples_61", "m"),
    ("slots_samples_62", "m"), ("slots_samples_63", "m"), ("slots_samples_64", "m"), ("slots_samples_65", "m"), ("slots_samples_66", "m"),
    ("slots_samples_67", "m"), ("slots_samples_68", "m"), ("slots_samples_69", "m"), ("slots_samples_70", "m"), ("slots_samples_71", "m"),
    ("slots_samples_72", "m"), ("slots_samples_73", "m"), ("slots_samples_74", "m"), ("slots_samples_75", "m"), ("slots_samples_76", "m"),
    ("slots_samples_77", "m"), ("slots_samples_78", "m"), ("slots_samples_79", "m"), ("slots_samples_80", "m"), ("slots_samples_81", "m"),
    ("slots_samples_82", "m"), ("slots_samples_83", "m"), ("slots_samples_84", "m"), ("slots_samples_85", "m"), ("slots_samples_86", "m"),
    ("slots_samples_87", "m"), ("slots_samples_88", "m"), ("slots_samples_89", "m"), ("slots_samples_90", "m"), ("slots_samples_91", "m"),
    ("slots_samples_92", "m"), ("slots_samples_93", "m"), ("slots_samples_94", "m"), ("slots_samples_95", "m"), ("slots_samples_96", "m"),
    ("slots_samples_97", "m"), ("slots_samples_98", "m"), ("slots_samples_99", "m"), ("slots_samples_100", "m"), ("slots_samples_101", "m"),
    ("slots_samples_102", "m"), ("slots_samples_103", "m"), ("slots_samples_104", "m"), ("slots_samples_105", "m"),
    ("slots_samples_106", "m"), ("slots_samples_107", "m"), ("slots_samples_108", "m"), ("slots_samples_109", "m"),
    ("slots_samples_110", "m"), ("slots_samples_111", "m"), ("slots_samples_112", "m"), ("slots_samples_113", "m"),
    ("slots_samples_114", "m"), ("slots_samples_115", "m"), ("slots_samples_116", "m"), ("slots_samples_117", "m"),
    ("slots_samples_118", "m"), ("slots_samples_119", "m"), ("slots_samples_120", "m"), ("slots_samples_121", "m"),
    ("slots_samples_122", "m"), ("slots_samples_123", "m"), ("slots_samples_124", "m"), ("slots_samples_125", "m"),
    ("slots_samples_126", "m"), ("slots_samples_127", "m"), ("slots_samples_128", "m"), ("slots_samples_129", "m"),
    ("slots_samples_130", "m"), ("slots_samples_131", "m"), ("slots_samples_132", "m"), ("slots_samples_133", "m"),
    ("slots_samples_134", "m"), ("slots_samples_135", "m"), ("slots_samples_136", "m"), ("slots_samples_137", "m"),
    ("slots_samples_138", "m"), ("slots_samples_139", "m"), ("slots_samples_140", "m"), ("slots_samples_141", "m"),
    ("slots_samples_142", "m"), ("slots_samples_143", "m"), ("slots_samples_144", "m"), ("slots_samples_145", "m"),
    ("slots_samples_146", "m"), ("slots_samples_147", "m"), ("slots_samples_148", "m"), ("slots_samples_149", "m"),
    ("slots_samples_150", "m"), ("slots_samples_151", "m"), ("slots_samples_152", "m"), ("slots_samples_153", "m"),
    ("slots_samples_154", "m"), ("slots_samples_155", "m"), ("slots_samples_156", "m"), ("slots_samples_157", "m"),
    ("slots_samples_158", "m"), ("slots_samples_159", "m"), ("slots_samples_160", "m"), ("slots_samples_161", "m"),
    ("slots_samples_162", "m"), ("slots_samples_163", "m"), ("slots_samples_164", "m"), ("slots_samples_165", "m"),
    ("slots_samples_166", "m"), ("slots_samples_167", "m"), ("slots_samples_168", "m"), ("slots_samples_169", "m"),
    ("slots_samples_170", "m"), ("slots_samples_171", "m"), ("slots_samples_172", "m"), ("slots_samples_173", "m"),
    ("slots_samples_174", "m"), ("slots_samples_175", "m"), ("slots_samples_176", "m"), ("slots_samples_177", "m"),
    ("slots_samples_178", "m"), ("slots_samples_179", "m"), ("slots_samples_180", "m"), ("slots_samples_181", "m"),
    ("slots_samples_182", "m"), ("slots_samples_183", "m"), ("slots_samples_184", "m"), ("slots_samples_185", "m"),
    ("slots_samples_186", "m"), ("slots_samples_187", "m"), ("slots_samples_188", "m"), ("slots_samples_189", "m"),
    ("slots_samples_190", "m"), ("slots_samples_191", "m"), ("slots_samples_192", "m"), ("slots_samples_193", "m"),
    ("slots_samples_194", "m"), ("slots_samples_195", "m"), ("slots_samples_196", "m"), ("slots_samples_197", "m"),
    ("slots_samples_198", "m"), ("slots_samples_199", "m"), ("slots_samples_200", "m"), ("slots_samples_201", "m"),
    ("slots_samples_202", "m"), ("slots_samples_203", "m"), ("slots_samples_204", "m"), ("slots_samples_205", "m"),
    ("slots_samples_206", "m"), ("slots_samples_207", "m"), ("slots_samples_208", "m"), ("slots_samples_209", "m"),
    ("slots_samples_210", "m"), ("slots_samples_211", "m"), ("slots_samples_212", "m"), ("slots_samples_213", "m"),
    ("slots_samples_214", "m"), ("slots_samples_215", "m"), ("slots_samples_216", "m"), ("slots_samples_217", "m"),
    ("slots_samples_218", "m"), ("slots_samples_219", "m"), ("slots_samples_220", "m"), ("slots_samples_221", "m"),
    ("slots_samples_222", "m"), ("slots_samples_223", "m"), ("slots_samples_224", "m"), ("slots_samples_225", "m"),
    ("slots_samples_226", "m"), ("slots_samples_227", "m"), ("slots_samples_228", "m"), ("slots_samples_229", "m"),
    ("slots_samples_230", "m"), ("slots_samples_231", "m"), ("slots_samples_232", "m"), ("slots_samples_233", "m"),
    ("slots_samples_234", "m"), ("slots_samples_235", "m"), ("slots_samples_236", "m"), ("slots_samples_237", "m"),
    ("slots_samples_238", "m"), ("slots_samples_239", "m"), ("slots_samples_240", "m"), ("slots_samples_241", "m"),
    ("slots_samples_242", "m"), ("slots_samples_243", "m"), ("slots_samples_244", "m"), ("slots_samples_245", "m"),
    ("slots_samples_246", "m"), ("slots_samples_247", "m"), ("slots_samples_248", "m"), ("slots_samples_249", "m"),
    ("slots_samples_250", "m"), ("slots_samples_251", "m"), ("slots_samples_252", "m"), ("slots_samples_253", "m"),
    ("slots_samples_254", "m"), ("slots_samples_255", "m"), ("slots_samples_256", "m"), ("slots_samples_257", "m"),
    ("slots_samples_258", "m"), ("slots_samples_259", "m"), ("slots_samples_260", "m"), ("slots_samples_261", "m"),
    ("slots_samples_262", "m"), ("slots_samples_263", "m"), ("slots_samples_264", "m"), ("slots_samples_265", "m"),
    ("slots_samples_266", "m"), ("slots_samples_267", "m"), ("slots_samples_268", "m"), ("slots_samples_269", "m"),
    ("slots_samples_270", "m"), ("slots_samples_271", "m"), ("slots_samples_272", "m"), ("slots_samples_273", "m"),
    ("slots_samples_274", "m"), ("slots_samples_275", "m"), ("slots_samples_276", "m"), ("slots_samples_277", "m"),
    ("slots_samples_278", "m"), ("slots_samples_279", "m"), ("slots_samples_280", "m"), ("slots_samples_281", "m"),
    ("slots_samples_282", "m"), ("slots_samples_283", "m"), ("slots_samples_284", "m"), ("slots_samples_285", "m"),
    ("slots_samples_286", "m"), ("slots_samples_287", "m"), ("slots_samples_288", "m"), ("half_sqrt_3", "1"), ("disc_samples_1", "m"),
    ("disc_samples_2", "m"), ("disc_samples_3", "m"), ("disc_samples_4", "m"), ("disc_samples_5", "m"), ("disc_samples_6", "m"),
    ("disc_samples_7", "m"), ("disc_samples_8", "m"), ("disc_samples_9", "m"), ("disc_samples_10", "m"), ("disc_samples_11", "m"),
    ("disc_samples_12", "m"), ("disc_samples_13", "m"), ("disc_samples_14", "m"), ("disc_samples_15", "m"), ("disc_samples_16", "m"),
    ("disc_samples_17", "m"), ("disc_samples_18", "m"), ("disc_samples_19", "m"), ("disc_samples_20", "m"), ("disc_samples_21", "m"),
    ("disc_samples_22", "m"), ("disc_samples_23", "m"), ("disc_samples_24", "m"), ("disc_samples_25", "m"), ("disc_samples_26", "m"),
    ("disc_samples_27", "m"), ("disc_samples_28", "m"), ("disc_samples_29", "m"), ("disc_samples_30", "m"), ("disc_samples_31", "m"),
    ("disc_samples_32", "m"), ("disc_samples_33", "m"), ("disc_samples_34", "m"), ("disc_samples_35", "m"), ("disc_samples_36", "m"),
    ("half_contact_stiffness", "N/m"), ("inverse_wheel_inertia", "1/(kg m^2)"), ("half_wheel_inertia", "kg m^2"),
    ("half_crank_speed_squared_times_crank_inertia", "J"),
)

OPERATIONS = (
    ("constants", 16), ("start", 0), ("scales", 14), ("coordinate_rates", 0), ("gaps", 73), ("gap_accelerations", 153),
    ("contact_slot", 57), ("contact_lock", 67), ("applied", 0), ("accelerations", 2), ("ledger", 1), ("energy", 50), ("poses", 7),
    ("outputs", 37), ("period", 3), ("landmarks", 15),
)

SLOTS_CURVE = (True, False, (0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1, 0, -1, 0, 1, -1, 1))

DISC_CURVE = (True, False, (1, 0, 0))

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = EVENTS = LOADS = FED = RUBBING = ()
GUIDES = SLIPS = CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def _called(name, inputs, result, slope, shaped):
    """Function that is called, not expanded, with its derivatives: by the last input slope(it, what is found), by others none.

    If _SHAPED they are shaped(all of these), by every input, of the first rows; None by one that only leads to the result.
    These take time, and a run has no use for them.
    """
    *others, last = plain = [ca.SX.sym("i", x.shape) for x in inputs]
    n, names, o = result.numel(), [f"i{k}" for k in range(len(inputs))], ca.SX.sym("o", result.numel())
    blocks = shaped(*plain, o) if _SHAPED else [*(None for _ in others), slope(last, o)]
    slopes = [
        ca.SX(n, x.numel()) if block is None else ca.vertcat(block, ca.SX(n - block.size1(), x.numel()))
        for x, block in zip(plain, blocks, strict=True)
    ]
    slopes = ca.Function(f"jac_{name}", [*plain, o], slopes, [*names, "out_found"], [f"jac_found_{k}" for k in names])
    called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
    return ca.Function(name, inputs, [ca.densify(result)], names, ["found"], called)

_SHAPED = False


def _slope_between(pose, found):
    """Derivative of where two curves are nearest by the pose of the first."""
    h, nx, ny, px, py, share, rolling, bend, _, _, own, other, *_ = ca.vertsplit(found)
    x, y, c, s = ca.vertsplit(pose)
    columns = []
    for vx, vy, turn in ((1, 0, 0), (0, 1, 0), (s*(py - y), s*(x - px), -s), (c*(y - py), c*(px - x), c)):
        slide = nx*vy - ny*vx
        normal, foot = bend*slide + (1 - share)*turn, share*slide + rolling*turn
        parameters = own*(slide + h*turn - foot - h*normal), other*foot
        columns.append(ca.vertcat(nx*vx + ny*vy, -ny*normal, nx*normal, -ny*foot, nx*foot, ca.SX(3, 1), *parameters))
    return ca.horzcat(*columns)


def _samples_of_chain(pieces, data, given):
    """Twelve lengths of each piece of a chain of arcs and lines.

    Its start, end and centre, x and y of each; the way along a line, or from an arc's centre to its middle; the least part along that
    of its points; length of a line, radius of an arc; a way out of the corner at its start.
    """
    values, (closed, _, turns), rows, ends = pieces(*ca.vertsplit(given)), data, [], []
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        if turn:
            whole, size = turn*ca.atan2(ux*vy - uy*vx, ux*vx + uy*vy), ca.sqrt(ux**2 + uy**2)
            half = turn*(whole + 2*ca.pi*(whole <= 0))/2
            way, least = (ux*ca.cos(half) - uy*ca.sin(half), ux*ca.sin(half) + uy*ca.cos(half)), size*(ca.cos(half) - 1e-14)
            ends.append(((turn*ux/size, turn*uy/size), (turn*vx/size, turn*vy/size)))
        else:
            way, least, size = (vx, vy), 0, ca.sqrt(vx**2 + vy**2)
            ends.append(((vy/size, -vx/size),)*2)
        rows.append([ax, ay, bx, by, cx, cy, *way, least, size])
    for k, row in enumerate(rows):
        (mx, my), (nx, ny) = ends[k - 1][1] if k or closed else (0, 0), ends[k][0]
        row += [row[9]*(mx + nx), row[9]*(my + ny)]
    return ca.vertcat(*(x for row in rows for x in row))


def _drawn_of_chain(pieces, data, given):
    """Points of a chain of arcs and lines for a picture, first all x, then all y."""
    values, (closed, _, turns) = pieces(*ca.vertsplit(given)), data
    points, steps = [], max(25, 150//max(sum(map(abs, turns)), 1))
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        angle = ca.atan2(turn*(ux*vy - uy*vx), ux*vx + uy*vy)
        angle = turn*(angle + 2*ca.pi*(angle <= 0))
        for j in range(steps if turn else 1):
            c, s = ca.cos(angle*j/steps), ca.sin(angle*j/steps)
            points.append((cx + ux*c - uy*s, cy + ux*s + uy*c) if turn else (ax, ay))
    points.append(values[-4:-2] if not closed else points[0])
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _heights_of_chain(data, rows, p):
    """Of each piece of a chain, then of each corner: whether a point is beside it, its signed distance, its normal there times a length, that.

    The solid of a corner is on the side of both pieces' normals; the end of an open chain has none.
    """
    closed, hole, turns = data
    side, found, count = -1 if hole else 1, [], len(turns)
    for k, turn in enumerate(turns):
        a, c, m, least, size = (rows[12*k + i : 12*k + j] for i, j in ((0, 2), (4, 6), (6, 8), (8, 9), (9, 10)))
        w = p - (c if turn else a)
        away, along, across = ca.sqrt(w[0]**2 + w[1]**2), w[0]*m[0] + w[1]*m[1], w[0]*m[1] - w[1]*m[0]
        if turn:
            found.append((along >= away*least, turn*side*(away - size), turn*side*w, away))
        else:
            found.append((ca.logic_and(along >= 0, along <= size**2), side*across/size, side*ca.vertcat(m[1], -m[0]), size))
    for k in range(count + (not closed)):
        w = p - (rows[12*k : 12*k + 2] if k < count else rows[-10:-8])
        away, sign = ca.sqrt(w[0]**2 + w[1]**2), 1
        if closed or 0 < k < count:
            sign = 1 - 2*(side*(w[0]*rows[12*k + 10] + w[1]*rows[12*k + 11]) < 0)
        found.append((1, sign*away, sign*w, away))
    return found


def _on_chain(pieces, data):
    """Function of a chain's rows, of one of its pieces or corners, and of a point beside it: what is found of the nearest."""
    if pieces not in _ON_CHAIN:
        closed, hole, turns = data
        side, count = -1 if hole else 1, len(turns)
        row, turn, corner, last, p = (ca.SX.sym("x", n) for n in (12, 1, 1, 1, 2))
        a, b, c, m, size, out = (row[i:j] for i, j in ((0, 2), (2, 4), (4, 6), (6, 8), (9, 10), (10, 12)))
        v = p - ca.if_else(last, b, a)
        sign = 1 - 2*ca.logic_and(side*(v[0]*out[0] + v[1]*out[1]) < 0, ca.logic_not(last))
        away = sign*ca.sqrt(v[0]**2 + v[1]**2)
        least = sign*ca.fmax(ca.fabs(away), 1e-300)
        of_corner = ca.vertcat(away, v/least, 1/least, 0, 0)
        w = p - a
        n = ca.vertcat(m[1], -m[0])/size
        of_line = ca.vertcat(side*(w[0]*n[0] + w[1]*n[1]), side*n, 0, (w[0]*m[0] + w[1]*m[1])/size**2, side/size)
        u, w, away = a - c, p - c, ca.sqrt((p[0] - c[0])**2 + (p[1] - c[1])**2)
        whole, part = (turn*ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (b - c, w))
        whole, least, way = whole + 2*ca.pi*(whole <= 0), ca.fmax(away, 1e-12*size), turn*side
        share = ca.fmin((part + 2*ca.pi*(part < 0))/whole, 1)
        of_arc = ca.vertcat(way*(away - size), way*w/least, way/least, share, side/(least*whole))
        found = ca.if_else(corner, of_corner, ca.if_else(turn, of_arc, of_line))
        one = ca.Function("one", [row, turn, corner, last, p], [ca.densify(found)])
        rows, feature, p = ca.MX.sym("rows", 12*count), ca.MX.sym("feature"), ca.MX.sym("p", 2)
        piece = feature - count*(feature >= count)
        at = ca.fmin(piece, count - 1)
        open_end = 0 if closed else ca.logic_or(feature == count, feature == 2*count)
        found = one(ca.reshape(rows, 12, count)[:, at], ca.MX(ca.DM(turns))[at], feature >= count, piece == count, p)
        if not closed:  # its ends have no normals
            sign = ca.if_else(open_end, ca.sign(found[0]), 1)
            found = ca.vertcat(sign*found[0], sign*found[1], sign*found[2], sign*found[3], found[4:])
        found = ca.vertcat(found[:4], found[4] + piece, found[5])
        _ON_CHAIN[pieces] = ca.Function("on_chain", [rows, feature, p], [found])
    return _ON_CHAIN[pieces]


_ON_CHAIN: "dict[object, ca.Function]" = {}


def _nearest_of_chain(pieces, data, samples, given, point):
    """Signed distance of a point from a chain of arcs and lines, as of a curve; its parameter is the piece and the part of it.

    The least of the distances of all pieces, where the point is beside them, and of all corners, each in closed form. A
    function of its own, which is called; its derivatives are the results themselves.
    """
    if pieces not in _NEAREST_OF_CHAIN:
        rows, p = ca.SX.sym("samples", samples.numel()), ca.SX.sym("point", 2)
        far = (ca.if_else(beside, ca.fabs(h), 1e300) for beside, h, *_ in _heights_of_chain(data, rows, p))
        heights = ca.Function("heights", [rows, p], [ca.vertcat(*far)])
        rows, values, p = (ca.MX.sym("x", x.numel()) for x in (samples, given, point))
        far = heights(rows, p)
        result = _on_chain(pieces, data)(rows, ca.find(far <= ca.mmin(far)), p)

        def slope(_, o):
            t = ca.vertcat(-o[2], o[1])
            return ca.vertcat(o[1:3].T, o[3]*t@t.T, ca.SX(1, 2), o[5]*t.T)

        again = ca.Function("again", [rows, p], [result[:5]], {"never_inline": True})

        def shaped(rows, _, p, __):
            return ca.jacobian(again(rows, p), rows), None, ca.jacobian(again(rows, p), p)

        _NEAREST_OF_CHAIN[pieces] = _called("nearest", [rows, values, p], result, slope, shaped)
    return _NEAREST_OF_CHAIN[pieces](samples, given, point)


_NEAREST_OF_CHAIN: "dict[object, ca.Function]" = {}


def _seen_from_chain(chain, data, rows, other, other_data, other_rows, pose, points, counted):
    """Where corners and round arcs of a chain, which is at a pose against another, are nearest to that.

    `points` are the numbers of the corners and arcs that count, `counted` those of the other that count elsewhere. A corner is as
    far as the nearest piece or corner. An arc is as far as its centre, less the radius, from what it faces, and which it has
    entered by no more than half of how thick that is; of a corner that counts elsewhere it says nothing, as near another corner
    that is less deep. A vector: distance; normal out of the other, distance of the centre,
    curvature of the other's parallel curve through it; the centre and the radius in its chain; both parameters, and their change
    along either.
    """
    (corners, arcs, _), count, other_count = points, len(data[2]), len(other_data[2])
    deep = -counted[2]*sum(ca.vertsplit(other_rows)[9::12])
    o, p, m, bound = (ca.SX.sym("x", n) for n in (other_rows.numel(), 2, 2, 3))  # bound: least part along m, radius, depth

    def to_arc():  # distances of what the arc faces
        for k, (beside, h, n, size) in enumerate(_heights_of_chain(other_data, o, p)):
            if k not in counted[1] and k - other_count not in counted[0]:
                faces = ca.logic_and(-n[0]*m[0] - n[1]*m[1] >= size*bound[0], h > ca.fmax(bound[1] + bound[2], 0))
                yield ca.if_else(ca.logic_and(beside, faces), h, 1e300)
            else:
                yield ca.SX(1e300)

    near = [(ca.if_else(beside, h, 1e300), h) for beside, h, *_ in _heights_of_chain(other_data, o, p)]
    of_corner = ca.Function("of_corner", [o, p], [ca.vertcat(*(ca.fabs(h) for h, _ in near))])
    of_arc = ca.Function("of_arc", [o, p, m, bound], [ca.vertcat(*to_arc())])
    out, within = 1e300, 1e300
    for h, _ in near:
        out, within = ca.fmin(out, ca.if_else(h < 0, 1e300, h)), ca.fmin(within, ca.if_else(h < 0, -h, 1e300))
    corner = ca.Function("corner", [o, p], [ca.if_else(within < out, -within, out)])
    arc = ca.Function("arc", [o, p, m, bound], [ca.mmin(of_arc(o, p, m, bound)) - bound[1]])

    x, y, c, s = ca.vertsplit(pose)
    turn = ca.vertcat(ca.horzcat(c, -s), ca.horzcat(s, c))

    def placed(v):
        return turn@v + ca.vertcat(x, y)

    columns = [ca.vertcat(rows[12*k : 12*k + 2] if k < count else rows[-10:-8], ca.MX.zeros(4)) for k in corners]
    columns += [rows[12*k + 4 : 12*k + 10] for k in arcs]
    far = [corner(other_rows, placed(column[:2])) for column in columns[: len(corners)]]
    far += [arc(other_rows, placed(row[:2]), turn@row[2:4], ca.vertcat(row[4:], deep)) for row in columns[len(corners) :]]
    far = ca.vertcat(*far)
    chosen = ca.find(far <= ca.mmin(far))
    column, number = ca.horzcat(*columns)[:, chosen], ca.MX(ca.DM([*corners, *arcs]))[chosen]
    p, round_ = placed(column[:2]), chosen >= len(corners)
    near = of_corner(other_rows, p)
    if arcs:
        near = ca.if_else(round_, of_arc(other_rows, p, turn@column[2:4], ca.vertcat(column[4:], deep)), near)
    h, nx, ny, bend, at, along = ca.vertsplit(_on_chain(other, other_data)(other_rows, ca.find(near <= ca.mmin(near)), p))
    own = ca.vertcat(number, 0)
    if arcs:
        foot = column[:2] - column[5]*(turn.T@ca.vertcat(nx, ny))
        own = ca.if_else(round_, _on_chain(chain, data)(rows, number, foot)[4:], own)
    gap = h - column[5]
    gap = ca.if_else(ca.mmin(far) < 1e290, gap, ca.fabs(gap))
    return ca.vertcat(gap, nx, ny, h, bend, column[:2], column[5], own[0], at, own[1], along/ca.if_else(along == 0, 1, 1 - h*bend))


def _between_of_chain(first, data, second, other_data, samples, others, given, other_given, pose, points, other_points):
    """Signed distance of two chains of arcs and lines, and what else is found between two curves, in closed form.

    The least distance from the other chain of the corners and round arcs of both that count; no more than half of how thick the
    other's solid is, is an arc within it. A function of its own, which is called; its derivatives are the results themselves.
    """
    key = first, second, points, other_points
    if key not in _BETWEEN_OF_CHAIN:
        rows, other_rows, *values, place = (ca.MX.sym("x", x.numel()) for x in (samples, others, given, other_given, pose))
        x, y, c, s = ca.vertsplit(place)
        found = []
        if points[0] or points[1]:
            h, nx, ny, far, bend, px, py, radius, *parameters = ca.vertsplit(
                _seen_from_chain(first, data, rows, second, other_data, other_rows, place, points, (other_points[0], (), other_points[2]))
            )
            px, py, share = x + c*px - s*py - far*nx, y + s*px + c*py - far*ny, 1 - far*bend
            found.append(ca.vertcat(h, nx, ny, px, py, share, far*share, bend, *parameters))
        if other_points[0] or other_points[1]:
            back = ca.vertcat(-c*x - s*y, s*x - c*y, c, -s)
            h, nx, ny, far, bend, px, py, radius, two, one, other, own = ca.vertsplit(
                _seen_from_chain(second, other_data, other_rows, first, data, rows, back, other_points, points)
            )
            nx, ny, share = s*ny - c*nx, -s*nx - c*ny, radius*bend
            found.append(ca.vertcat(h, nx, ny, px + radius*nx, py + radius*ny, share, radius*(1 - share), bend, one, two, own, other))
        result = found[0] if len(found) == 1 else ca.if_else(found[0][0] <= found[1][0], *found)

        again = ca.Function("again", [rows, other_rows, place], [result[:10]], {"never_inline": True})

        def shaped(rows, other_rows, _, __, place, ___):
            first, second, moved = (ca.jacobian(again(rows, other_rows, place), x) for x in (rows, other_rows, place))
            return first, second, None, None, moved

        _BETWEEN_OF_CHAIN[key] = _called("between", [rows, other_rows, *values, place], result, _slope_between, shaped)
    return _BETWEEN_OF_CHAIN[key](samples, others, given, other_given, pose)


_BETWEEN_OF_CHAIN: "dict[object, ca.Function]" = {}


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


def disc_curve(lock_play, lock_radius, hub):
    """Pieces of the chain disc: start x, y, end x, y, centre x, y of each."""
    sqrt_2 = ca.sqrt(2)
    lock_radius_minus_lock_play = lock_radius - lock_play
    x3 = sqrt_2*lock_radius_minus_lock_play/2
    x4 = -sqrt_2*lock_radius_minus_lock_play/2
    return x3, x3, x3, x4, 0, 0, x3, x4, hub, 0, x3, x4, hub, 0, x3, x3, hub, 0


def body_gaps_terms(t, speed):
    """Return cos [1], sin [1]."""
    angle = t*speed
    cos = ca.cos(angle)
    sin = ca.sin(angle)
    return cos, sin


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (20,): distance, rim, pin_radius, play, root, lock_radius, lock_play, hub, crank_speed, contact_stiffness, contact_damping,
            quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3, disc_samples,
            half_contact_stiffness, inverse_wheel_inertia, half_wheel_inertia, half_crank_speed_squared_times_crank_inertia
    """
    crank_inertia, wheel_inertia, distance, rim, pin_radius, play, root, lock_radius = p[1], p[3], p[4], p[5], p[6], p[7], p[8], p[9]
    lock_play, hub, crank_speed, contact_stiffness, contact_damping = p[10], p[11], p[12], p[13], p[14]
    quarter_of_sqrt_2_times_distance = ca.sqrt(2)*distance/4
    quarter_of_sqrt_6_times_distance = ca.sqrt(6)*distance/4
    slots_samples = _samples_of_chain(slots_curve, SLOTS_CURVE, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius))
    half_sqrt_3 = ca.sqrt(3)/2
    disc_samples = _samples_of_chain(disc_curve, DISC_CURVE, ca.vertcat(lock_play, lock_radius, hub))
    half_contact_stiffness = contact_stiffness/2
    inverse_wheel_inertia = 1/wheel_inertia
    half_wheel_inertia = wheel_inertia/2
    half_crank_speed_squared_times_crank_inertia = crank_speed*crank_speed*crank_inertia/2
    return ca.vertcat(distance, rim, pin_radius, play, root, lock_radius, lock_play, hub, crank_speed, contact_stiffness, contact_damping,
        quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3, disc_samples,
        half_contact_stiffness, inverse_wheel_inertia, half_wheel_inertia, half_crank_speed_squared_times_crank_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    start_angle = p[15]
    return ca.vertcat(start_angle), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (3,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, wheel_mass, distance, play, crank_speed = p[0], p[2], p[4], p[7], p[12]
    total_mass = crank_mass + wheel_mass
    energy_scale = total_mass*crank_speed*crank_speed*distance*distance/400
    force_scale = energy_scale/play
    sqrt_2 = ca.sqrt(2)
    return (ca.vertcat(play/distance), ca.vertcat(sqrt_2*crank_speed/20), ca.vertcat(energy_scale, energy_scale, energy_scale),
        ca.vertcat(play, sqrt_2*crank_speed*distance/20, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [rad/s]
    """
    axle_speed = u[0]
    return ca.vertcat(axle_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (2,): PAIRS [m]
        dG (2,): PAIRS [m/s]
    """
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub, crank_speed = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]
    quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3 = c[11], c[12], c[13:301], c[301]
    disc_samples = c[302:338]
    axle_angle = q[0]
    axle_speed = u[0]
    cos, sin = body_gaps_terms(t, crank_speed)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin - cos*quarter_of_sqrt_6_times_distance
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
    lock_local_x = -cos_wheel*distance
    lock_local_y = sin_wheel*distance
    half_cos_crank = cos/2
    x2 = half_sqrt_3*sin
    x3 = half_cos_crank + x2
    half_sin_crank = sin/2
    x5 = -cos*half_sqrt_3
    x6 = half_sin_crank + x5
    lock_turned_x = cos_wheel*x3 + sin_wheel*x6
    lock_turned_y = cos_wheel*x6 - sin_wheel*x3
    lock_relative_turning = crank_speed - axle_speed
    lock_between = _between_of_chain(disc_curve, DISC_CURVE, slots_curve, SLOTS_CURVE, disc_samples, slots_samples, ca.vertcat(lock_play, lock_radius, hub), ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(lock_local_x, lock_local_y, lock_turned_x, lock_turned_y), ((0, 1), (0,), 0.138602), ((23, 0, 3, 4, 5, 6, 9, 10, 11, 12, 15, 16, 17, 18, 21, 22), (23, 3, 5, 9, 11, 15, 17, 21), 0.00391447))
    lock_distance = lock_between[0]
    lock_normal_x = lock_between[1]
    lock_normal_y = lock_between[2]
    lock_foot_x = lock_between[3]
    lock_foot_y = lock_between[4]
    lock_local_x_rate = -cos_wheel_rate*distance
    lock_slip_x = lock_local_x_rate - lock_relative_turning*(lock_foot_y - lock_local_y)
    lock_local_y_rate = sin_wheel_rate*distance
    lock_slip_y = lock_local_y_rate + lock_relative_turning*(lock_foot_x - lock_local_x)
    lock_distance_rate = lock_normal_x*lock_slip_x + lock_normal_y*lock_slip_y
    return ca.vertcat(slot_gap, lock_distance), ca.vertcat(slot_distance_rate, lock_distance_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (2,): PAIRS [m/s^2]
    """
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub, crank_speed = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]
    quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3 = c[11], c[12], c[13:301], c[301]
    disc_samples = c[302:338]
    axle_angle = q[0]
    axle_speed = u[0]
    axle_acceleration = a[0]
    cos, sin = body_gaps_terms(t, crank_speed)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin - cos*quarter_of_sqrt_6_times_distance
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
    lock_local_x = -cos_wheel*distance
    lock_local_y = sin_wheel*distance
    half_cos_crank = cos/2
    x2 = half_sqrt_3*sin
    x3 = half_cos_crank + x2
    half_sin_crank = sin/2
    x5 = -cos*half_sqrt_3
    x6 = half_sin_crank + x5
    lock_turned_x = cos_wheel*x3 + sin_wheel*x6
    lock_turned_y = cos_wheel*x6 - sin_wheel*x3
    lock_relative_turning = crank_speed - axle_speed
    lock_between = _between_of_chain(disc_curve, DISC_CURVE, slots_curve, SLOTS_CURVE, disc_samples, slots_samples, ca.vertcat(lock_play, lock_radius, hub), ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(lock_local_x, lock_local_y, lock_turned_x, lock_turned_y), ((0, 1), (0,), 0.138602), ((23, 0, 3, 4, 5, 6, 9, 10, 11, 12, 15, 16, 17, 18, 21, 22), (23, 3, 5, 9, 11, 15, 17, 21), 0.00391447))
    lock_normal_x = lock_between[1]
    lock_normal_y = lock_between[2]
    lock_foot_x = lock_between[3]
    lock_foot_y = lock_between[4]
    lock_share = lock_between[5]
    lock_rolling = lock_between[6]
    lock_bend = lock_between[7]
    lock_local_x_rate = -cos_wheel_rate*distance
    lock_slip_x = lock_local_x_rate - lock_relative_turning*(lock_foot_y - lock_local_y)
    lock_local_y_rate = sin_wheel_rate*distance
    lock_foot_x_minus_lock_local_x = lock_foot_x - lock_local_x
    lock_slip_y = lock_local_y_rate + lock_relative_turning*lock_foot_x_minus_lock_local_x
    lock_along_curve = lock_normal_x*lock_slip_y - lock_normal_y*lock_slip_x
    lock_turning = lock_along_curve*lock_bend + lock_relative_turning*(1 - lock_share)
    lock_moved = lock_along_curve*lock_share + lock_relative_turning*lock_rolling
    axle_speed_squared = axle_speed*axle_speed
    cos_wheel_rate_rate = -axle_acceleration*sin_wheel - cos_wheel*axle_speed_squared
    sin_wheel_rate_rate = axle_acceleration*cos_wheel - sin_wheel*axle_speed_squared
    slot_local_x_rate_rate = cos_wheel*slot_apart_acceleration_x + cos_wheel_rate_rate*slot_apart_x + sin_wheel*slot_apart_acceleration_y + sin_wheel_rate_rate*slot_first_arm_y + 2*cos_wheel_rate*slot_first_arm_rate_x + 2*sin_wheel_rate*slot_first_arm_rate_y
    slot_local_y_rate_rate = cos_wheel*slot_apart_acceleration_y + cos_wheel_rate_rate*slot_first_arm_y + 2*cos_wheel_rate*slot_first_arm_rate_y - sin_wheel*slot_apart_acceleration_x - sin_wheel_rate_rate*slot_apart_x - 2*sin_wheel_rate*slot_first_arm_rate_x
    slot_distance_rate_rate = slot_local_x_rate_rate*slot_normal_x + slot_local_y_rate_rate*slot_normal_y + slot_local_y_rate*slot_normal_x*slot_turning - slot_local_x_rate*slot_normal_y*slot_turning
    lock_local_x_rate_rate = -cos_wheel_rate_rate*distance
    lock_slip_x_rate = lock_local_x_rate_rate + lock_local_y_rate*lock_relative_turning - axle_acceleration*(lock_local_y - lock_foot_y) - lock_moved*lock_normal_x*lock_relative_turning
    lock_local_y_rate_rate = sin_wheel_rate_rate*distance
    lock_slip_y_rate = lock_local_y_rate_rate - axle_acceleration*lock_foot_x_minus_lock_local_x - lock_local_x_rate*lock_relative_turning - lock_moved*lock_normal_y*lock_relative_turning
    lock_distance_rate_rate = lock_normal_x*lock_slip_x_rate + lock_normal_y*lock_slip_y_rate + lock_normal_x*lock_slip_y*lock_turning - lock_normal_y*lock_slip_x*lock_turning
    return ca.vertcat(slot_distance_rate_rate, lock_distance_rate_rate)


def contact_slot(t, q, u, z, m, c):
    """Forces of slot: power x power_damping. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): axle [N m], shaft [N m]
        dz (3,): MEMORY [W]
        normal_force (1,): slot [N]
        sliding_velocity (0,): empty
        in_range (1,): slot [1]
    """
    distance, rim, pin_radius, play, root, lock_radius, crank_speed, contact_stiffness = c[0], c[1], c[2], c[3], c[4], c[5], c[8], c[9]
    contact_damping, quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples = c[10], c[11], c[12], c[13:301]
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
    return (ca.vertcat(slot_push_on_axle, slot_push_on_shaft), ca.vertcat(0, slot_normal_power, 0), ca.vertcat(slot_normal_force),
            ca.vertcat(),
        ca.vertcat(1))


def contact_lock(t, q, u, z, m, c):
    """Forces of lock: power x power_damping; arguments and returns as of contact_slot."""
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub, crank_speed = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]
    contact_stiffness, contact_damping, slots_samples, half_sqrt_3, disc_samples = c[9], c[10], c[13:301], c[301], c[302:338]
    axle_angle = q[0]
    axle_speed = u[0]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    lock_local_x = -cos_wheel*distance
    lock_local_y = sin_wheel*distance
    half_cos_crank = cos_crank/2
    x2 = half_sqrt_3*sin_crank
    x3 = half_cos_crank + x2
    half_sin_crank = sin_crank/2
    x5 = -cos_crank*half_sqrt_3
    x6 = half_sin_crank + x5
    lock_turned_x = cos_wheel*x3 + sin_wheel*x6
    lock_turned_y = cos_wheel*x6 - sin_wheel*x3
    lock_between = _between_of_chain(disc_curve, DISC_CURVE, slots_curve, SLOTS_CURVE, disc_samples, slots_samples, ca.vertcat(lock_play, lock_radius, hub), ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(lock_local_x, lock_local_y, lock_turned_x, lock_turned_y), ((0, 1), (0,), 0.138602), ((23, 0, 3, 4, 5, 6, 9, 10, 11, 12, 15, 16, 17, 18, 21, 22), (23, 3, 5, 9, 11, 15, 17, 21), 0.00391447))
    lock_distance = lock_between[0]
    lock_normal_x = lock_between[1]
    lock_normal_y = lock_between[2]
    lock_foot_x = lock_between[3]
    lock_foot_y = lock_between[4]
    lock_elastic_force = ca.if_else(-lock_distance > 0, -lock_distance*contact_stiffness, 0)
    lock_normal_x_2 = cos_wheel*lock_normal_x - lock_normal_y*sin_wheel
    lock_normal_y_2 = cos_wheel*lock_normal_y + lock_normal_x*sin_wheel
    lock_foot_x_2 = cos_wheel*lock_foot_x - lock_foot_y*sin_wheel
    lock_foot_y_2 = cos_wheel*lock_foot_y + lock_foot_x*sin_wheel
    lock_contact_x = lock_foot_x_2 + distance
    lock_relative_rate_x = axle_speed*lock_foot_y_2 - lock_foot_y_2*crank_speed
    lock_contact_x_minus_distance = lock_contact_x - distance
    lock_relative_rate_y = lock_contact_x*crank_speed - axle_speed*lock_contact_x_minus_distance
    lock_penetration_rate = -lock_normal_x_2*lock_relative_rate_x - lock_normal_y_2*lock_relative_rate_y
    lock_resistance = ca.if_else(-lock_distance > 0, -lock_distance*lock_penetration_rate*contact_damping, 0)
    lock_normal_force = lock_elastic_force + lock_resistance
    lock_normal_power = lock_penetration_rate*lock_resistance
    lock_push_x = lock_normal_force*lock_normal_x_2
    lock_push_y = lock_normal_force*lock_normal_y_2
    lock_push_on_shaft = lock_contact_x*lock_push_y - lock_foot_y_2*lock_push_x
    lock_push_on_axle = lock_foot_y_2*lock_push_x - lock_push_y*lock_contact_x_minus_distance
    return (ca.vertcat(lock_push_on_axle, lock_push_on_shaft), ca.vertcat(0, 0, lock_normal_power), ca.vertcat(lock_normal_force),
            ca.vertcat(),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): axle [N m], shaft [N m]
    """
    return ca.vertcat(0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): axle.acceleration [rad/s^2]
        reactions (1,): shaft.reaction [N m]
    """
    inverse_wheel_inertia = c[339]
    axle_force, shaft_force = f[0], f[1]
    axle_acc = axle_force*inverse_wheel_inertia
    return ca.vertcat(axle_acc), ca.vertcat(-shaft_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (3,): MEMORY [W]
    """
    crank_speed = c[8]
    shaft_reaction_in = reactions[0]
    return ca.vertcat(shaft_reaction_in*crank_speed, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (2,): PAIRS [J]
    """
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]
    quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3 = c[11], c[12], c[13:301], c[301]
    disc_samples, half_contact_stiffness, half_wheel_inertia = c[302:338], c[338], c[340]
    half_crank_speed_squared_times_crank_inertia = c[341]
    axle_angle = q[0]
    axle_speed = u[0]
    cos, sin = body_gaps_terms(t, c[8])
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin - cos*quarter_of_sqrt_6_times_distance
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_gap = slot_distance - pin_radius
    lock_local_x = -cos_wheel*distance
    lock_local_y = sin_wheel*distance
    half_cos_crank = cos/2
    x2 = half_sqrt_3*sin
    x3 = half_cos_crank + x2
    half_sin_crank = sin/2
    x5 = -cos*half_sqrt_3
    x6 = half_sin_crank + x5
    lock_turned_x = cos_wheel*x3 + sin_wheel*x6
    lock_turned_y = cos_wheel*x6 - sin_wheel*x3
    lock_between = _between_of_chain(disc_curve, DISC_CURVE, slots_curve, SLOTS_CURVE, disc_samples, slots_samples, ca.vertcat(lock_play, lock_radius, hub), ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(lock_local_x, lock_local_y, lock_turned_x, lock_turned_y), ((0, 1), (0,), 0.138602), ((23, 0, 3, 4, 5, 6, 9, 10, 11, 12, 15, 16, 17, 18, 21, 22), (23, 3, 5, 9, 11, 15, 17, 21), 0.00391447))
    lock_distance = lock_between[0]
    slot_stored_energy = ca.if_else(-slot_gap > 0, half_contact_stiffness*slot_gap*slot_gap, 0)
    lock_stored_energy = ca.if_else(-lock_distance > 0, half_contact_stiffness*lock_distance*lock_distance, 0)
    kinetic = half_crank_speed_squared_times_crank_inertia + half_wheel_inertia*axle_speed*axle_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(slot_stored_energy, lock_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): crank.x [m], crank.y [m], crank.z [m], wheel.x [m], wheel.y [m], wheel.z [m]
        rotations (18,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], wheel.R_xx [1], wheel.R_xy [1], wheel.R_xz [1], wheel.R_yx [1], wheel.R_yy [1], wheel.R_yz [1],
            wheel.R_zx [1], wheel.R_zy [1], wheel.R_zz [1]
    """
    distance = c[0]
    axle_angle = q[0]
    cos, sin = body_gaps_terms(t, c[8])
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    return (ca.vertcat(0, 0, 0, distance, 0, 0),
        ca.vertcat(cos, -sin, 0, sin, cos, 0, 0, 0, 1, cos_wheel, -sin_wheel, 0, sin_wheel, cos_wheel, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (5,): OUTPUTS
    """
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]
    quarter_of_sqrt_2_times_distance, quarter_of_sqrt_6_times_distance, slots_samples, half_sqrt_3 = c[11], c[12], c[13:301], c[301]
    disc_samples = c[302:338]
    axle_angle = q[0]
    cos, sin = body_gaps_terms(t, c[8])
    cos_wheel = ca.cos(axle_angle)
    sin_wheel = ca.sin(axle_angle)
    slot_first_arm_x = cos*quarter_of_sqrt_2_times_distance + quarter_of_sqrt_6_times_distance*sin
    slot_first_arm_y = quarter_of_sqrt_2_times_distance*sin - cos*quarter_of_sqrt_6_times_distance
    slot_apart_x = slot_first_arm_x - distance
    slot_local_x = cos_wheel*slot_apart_x + sin_wheel*slot_first_arm_y
    slot_local_y = cos_wheel*slot_first_arm_y - sin_wheel*slot_apart_x
    slot_nearest = _nearest_of_chain(slots_curve, SLOTS_CURVE, slots_samples, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(slot_local_x, slot_local_y))
    slot_distance = slot_nearest[0]
    slot_parameter = slot_nearest[4]
    slot_gap = slot_distance - pin_radius
    lock_local_x = -cos_wheel*distance
    lock_local_y = sin_wheel*distance
    half_cos_crank = cos/2
    x2 = half_sqrt_3*sin
    x3 = half_cos_crank + x2
    half_sin_crank = sin/2
    x5 = -cos*half_sqrt_3
    x6 = half_sin_crank + x5
    lock_turned_x = cos_wheel*x3 + sin_wheel*x6
    lock_turned_y = cos_wheel*x6 - sin_wheel*x3
    lock_between = _between_of_chain(disc_curve, DISC_CURVE, slots_curve, SLOTS_CURVE, disc_samples, slots_samples, ca.vertcat(lock_play, lock_radius, hub), ca.vertcat(rim, pin_radius, play, root, distance, lock_radius), ca.vertcat(lock_local_x, lock_local_y, lock_turned_x, lock_turned_y), ((0, 1), (0,), 0.138602), ((23, 0, 3, 4, 5, 6, 9, 10, 11, 12, 15, 16, 17, 18, 21, 22), (23, 3, 5, 9, 11, 15, 17, 21), 0.00391447))
    lock_distance = lock_between[0]
    lock_first_parameter = lock_between[8]
    lock_second_parameter = lock_between[9]
    return ca.vertcat(slot_gap, slot_parameter, lock_distance, lock_first_parameter, lock_second_parameter)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[12]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        shaft.parent, shaft.child, axle.parent, axle.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        slot.circle (4,): x [m], y [m], z [m], radius [m]
        slot.fixed, lock.first, lock.second (10,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1], across_x [1], across_y [1],
            across_z [1], outline
        motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, wheel.centre (3,): x [m], y [m], z [m]
    """
    distance, rim, pin_radius, play, root, lock_radius, lock_play, hub = p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11]
    x1 = _drawn_of_chain(slots_curve, SLOTS_CURVE, ca.vertcat(rim, pin_radius, play, root, distance, lock_radius))
    sqrt_3 = ca.sqrt(3)
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(distance, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(ca.sqrt(2)*distance/4, -ca.sqrt(6)*distance/4, 0, pin_radius), ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x1),
        ca.vertcat(0, 0, 0, 1/2, -sqrt_3/2, 0, sqrt_3/2, 1/2, 0, _drawn_of_chain(disc_curve, DISC_CURVE, ca.vertcat(lock_play, lock_radius,
            hub))),
        ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0))
