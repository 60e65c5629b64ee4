"""gears_with_backlash: idle gear that rattles within its backlash. Generated from derive/scenes/gears_with_backlash.py.

Do not edit; regenerate with `hertzwerk derive gears_with_backlash`.
Effects:
    engine: position of input = pinion_speed*t + swing*(1 - cos(firing*t))/firing**2
    oil: force on idler = drag
    mesh_1, mesh_2: power x power_damping
    energy_ledger: work put in, energy dissipated per effect
Units: 113 assignments and 180 outputs checked, all consistent
Operations: flight 178 (equations of motion and gaps); in contact also contact_mesh_1 68, contact_mesh_2 68
"""

import casadi as ca

NAME = "gears_with_backlash"
SOURCE = "derive/scenes/gears_with_backlash.py"
SUMMARY = "idle gear that rattles within its backlash"
FORMAT = "hertzwerk module 1"
DIGEST = "06a6b980b8bcead43c351b10509557dd"

EFFECTS = (
    ("engine", "drive", "position of input = pinion_speed*t + swing*(1 - cos(firing*t))/firing**2"),
    ("oil", "force", "force on idler = drag"), ("mesh_1", "contact", "power x power_damping"),
    ("mesh_2", "contact", "power x power_damping"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("pinion_mass", "kg", 0.5, "body pinion, mass"),
    ("pinion_inertia", "kg m^2", 0.0003, "body pinion, inertia"),
    ("wheel_mass", "kg", 1.5, "body wheel, mass"),
    ("wheel_inertia", "kg m^2", 0.002, "body wheel, inertia"),
    ("module", "mm", 3, "teeth pinion_teeth, module"),
    ("pressure_angle", "deg", 20, "teeth pinion_teeth, pressure angle"),
    ("thinning", "mm", 0.05, "of each tooth: half the backlash on the reference circle"),
    ("pinion_speed", "rpm", 900, ""),
    ("firing", "rad/s", 240, "frequency of that"),
    ("swing", "rad/s^2", 1500, "greatest acceleration of the pinion"),
    ("drag", "N m", 0.8, "effect oil, force"),
    ("mesh_stiffness", "N/m", 140000000.0, "effect mesh_1, stiffness of power"),
    ("mesh_damping", "N s/m^2", 400000000.0, "effect mesh_1, coefficient of the damping of power_damping"),
)

LIMITS = (
    ("pinion_mass", "defined", 0, None, True, False, "body pinion, mass"),
    ("pinion_inertia", "defined", 0, None, False, False, "body pinion, inertia"),
    ("wheel_mass", "defined", 0, None, True, False, "body wheel, mass"),
    ("wheel_inertia", "defined", 0, None, False, False, "body wheel, inertia"),
    ("module", "defined", 0, None, True, False, "teeth pinion_teeth, module"),
    ("pressure_angle", "defined", 0, 0.7853981633974483, False, False, "teeth pinion_teeth, pressure angle"),
    ("mesh_stiffness", "defined", 0, None, True, False, "effect mesh_1, stiffness of power"),
    ("mesh_damping", "defined", 0, None, True, False, "effect mesh_1, coefficient of the damping of power_damping"),
    ("thinning", "defined", 0, None, True, False, "scales, length"),
)

COORDINATES = (("idler.angle", "rad"),)

SPEEDS = (("idler.speed", "rad/s"),)

MEMORY = (("energy_ledger.input", "J"), ("oil.input", "J"), ("mesh_1.dissipated", "J"), ("mesh_2.dissipated", "J"))

PAIRS = (("mesh_1", "curve_on_curve"), ("mesh_2", "curve_on_curve"))

RELEASES = ("force", "force")

DISSIPATED = (2, 3)

OUTPUTS = (
    ("mesh_1.gap", "m"), ("mesh_1.first_parameter", "1"), ("mesh_1.second_parameter", "1"), ("mesh_2.gap", "m"),
    ("mesh_2.first_parameter", "1"), ("mesh_2.second_parameter", "1"),
)

BODIES = ("pinion", "wheel")

LANDMARKS = (
    ("input", "revolute", "parent", "ground", ("axis",)), ("input", "revolute", "child", "pinion", ("axis",)),
    ("idler", "revolute", "parent", "ground", ("axis",)), ("idler", "revolute", "child", "wheel", ("axis",)),
    ("mesh_1", "curve_on_curve", "first", "pinion", ("along", "across", "outline")),
    ("mesh_1", "curve_on_curve", "second", "wheel", ("along", "across", "outline")),
    ("mesh_2", "curve_on_curve", "first", "pinion", ("along", "across", "outline")),
    ("mesh_2", "curve_on_curve", "second", "wheel", ("along", "across", "outline")), ("engine", "turn_drive", "child", "pinion", ("axis",)),
    ("oil", "turn_force", "child", "wheel", ("axis",)), ("pinion", "body", "centre", "pinion", ()),
    ("wheel", "body", "centre", "wheel", ()),
)

CONSTANTS = (
    ("pinion_inertia", "kg m^2"), ("module", "m"), ("pressure_angle", "1"), ("thinning", "m"), ("pinion_speed", "1/s"), ("firing", "1/s"),
    ("swing", "1/s^2"), ("drag", "J"), ("mesh_stiffness", "N/m"), ("mesh_damping", "Pa s"), ("swing_over_firing_squared", "1"),
    ("swing_over_firing", "1/s"), ("wheel_arm_x", "m"), ("wheel_teeth_left_samples_1", "m"), ("wheel_teeth_left_samples_2", "m"),
    ("wheel_teeth_left_samples_3", "m"), ("wheel_teeth_left_samples_4", "m"), ("wheel_teeth_left_samples_5", "m"),
    ("wheel_teeth_left_samples_6", "m"), ("wheel_teeth_left_samples_7", "m"), ("wheel_teeth_left_samples_8", "m"),
    ("wheel_teeth_left_samples_9", "m"), ("wheel_teeth_left_samples_10", "m"), ("wheel_teeth_left_samples_11", "m"),
    ("wheel_teeth_left_samples_12", "m"), ("wheel_teeth_left_samples_13", "m"), ("wheel_teeth_left_samples_14", "m"),
    ("wheel_teeth_left_samples_15", "m"), ("wheel_teeth_left_samples_16", "m"), ("wheel_teeth_left_samples_17", "m"),
    ("wheel_teeth_left_samples_18", "m"), ("wheel_teeth_left_samples_19", "m"), ("wheel_teeth_left_samples_20", "m"),
    ("wheel_teeth_left_samples_21", "m"), ("wheel_teeth_left_samples_22", "m"), ("wheel_teeth_left_samples_23", "m"),
    ("wheel_teeth_left_samples_24", "m"), ("wheel_teeth_left_samples_25", "m"), ("wheel_teeth_left_samples_26", "m"),
    ("wheel_teeth_left_samples_27", "m"), ("wheel_teeth_left_samples_28", "m"), ("wheel_teeth_left_samples_29", "m"),
    ("wheel_teeth_left_samples_30", "m"), ("wheel_teeth_left_samples_31", "m"), ("wheel_teeth_left_samples_32", "m"),
    ("wheel_teeth_left_samples_33", "m"), ("wheel_teeth_left_samples_34", "m"), ("wheel_teeth_left_samples_35", "m"),
    ("wheel_teeth_left_samples_36", "m"), ("wheel_teeth_left_samples_37", "m"), ("wheel_teeth_left_samples_38", "m"),
    ("pinion_teeth_left_samples_1", "m"), ("pinion_teeth_left_samples_2", "m"), ("pinion_teeth_left_samples_3", "m"),
    ("pinion_teeth_left_samples_4", "m"), ("pinion_teeth_left_samples_5", "m"), ("pinion_teeth_left_samples_6", "m"),
    ("pinion_teeth_left_samples_7", "m"), ("pinion_teeth_left_samples_8", "m"), ("pinion_teeth_left_samples_9", "m"),
    ("pinion_teeth_left_samples_10", "m"), ("pinion_teeth_left_samples_11", "m"), ("pinion_teeth_left_samples_12", "m"),
    ("pinion_teeth_left_samples_13", "m"), ("pinion_teeth_left_samples_14", "m"), ("pinion_teeth_left_samples_15", "m"),
    ("pinion_teeth_left_samples_16", "m"), ("pinion_teeth_left_samples_17", "m"), ("pinion_teeth_left_samples_18", "m"),
    ("pinion_teeth_left_samples_19", "m"), ("pinion_teeth_left_samples_20", "m"), ("pinion_teeth_left_samples_21", "m"),
    ("pinion_teeth_left_samples_22", "m"), ("pinion_teeth_left_samples_23", "m"), ("pinion_teeth_left_samples_24", "m"),
    ("pinion_teeth_left_samples_25", "m"), ("pinion_teeth_left_samples_26", "m"), ("pinion_teeth_left_samples_27", "m"),
    ("pinion_teeth_left_samples_28", "m"), ("pinion_teeth_left_samples_29", "m"), ("pinion_teeth_left_samples_30", "m"),
    ("pinion_teeth_left_samples_31", "m"), ("pinion_teeth_left_samples_32", "m"), ("pinion_teeth_left_samples_33", "m"),
    ("pinion_teeth_left_samples_34", "m"), ("pinion_teeth_left_samples_35", "m"), ("pinion_teeth_left_samples_36", "m"),
    ("pinion_teeth_left_samples_37", "m"), ("pinion_teeth_left_samples_38", "m"), ("pinion_teeth_left_samples_39", "m"),
    ("pinion_teeth_left_samples_40", "m"), ("wheel_teeth_right_samples_1", "m"), ("wheel_teeth_right_samples_2", "m"),
    ("wheel_teeth_right_samples_3", "m"), ("wheel_teeth_right_samples_4", "m"), ("wheel_teeth_right_samples_5", "m"),
    ("wheel_teeth_right_samples_6", "m"), ("wheel_teeth_right_samples_7", "m"), ("wheel_teeth_right_samples_8", "m"),
    ("wheel_teeth_right_samples_9", "m"), ("wheel_teeth_right_samples_10", "m"), ("wheel_teeth_right_samples_11", "m"),
    ("wheel_teeth_right_samples_12", "m"), ("wheel_teeth_right_samples_13", "m"), ("wheel_teeth_right_samples_14", "m"),
    ("wheel_teeth_right_samples_15", "m"), ("wheel_teeth_right_samples_16", "m"), ("wheel_teeth_right_samples_17", "m"),
    ("wheel_teeth_right_samples_18", "m"), ("wheel_teeth_right_samples_19", "m"), ("wheel_teeth_right_samples_20", "m"),
    ("wheel_teeth_right_samples_21", "m"), ("wheel_teeth_right_samples_22", "m"), ("wheel_teeth_right_samples_23", "m"),
    ("wheel_teeth_right_samples_24", "m"), ("wheel_teeth_right_samples_25", "m"), ("wheel_teeth_right_samples_26", "m"),
    ("wheel_teeth_right_samples_27", "m"), ("wheel_teeth_right_samples_28", "m"), ("wheel_teeth_right_samples_29", "m"),
    ("wheel_teeth_right_samples_30", "m"), ("wheel_teeth_right_samples_31", "m"), ("wheel_teeth_right_samples_32", "m"),
    ("wheel_teeth_right_samples_33", "m"), ("wheel_teeth_right_samples_34", "m"), ("wheel_teeth_right_samples_35", "m"),
    ("wheel_teeth_right_samples_36", "m"), ("wheel_teeth_right_samples_37", "m"), ("wheel_teeth_right_samples_38", "m"),
    ("pinion_teeth_right_samples_1", "m"), ("pinion_teeth_right_samples_2", "m"), ("pinion_teeth_right_samples_3", "m"),
    ("pinion_teeth_right_samples_4", "m"), ("pinion_teeth_right_samples_5", "m"), ("pinion_teeth_right_samples_6", "m"),
    ("pinion_teeth_right_samples_7", "m"), ("pinion_teeth_right_samples_8", "m"), ("pinion_teeth_right_samples_9", "m"),
    ("pinion_teeth_right_samples_10", "m"), ("pinion_teeth_right_samples_11", "m"), ("pinion_teeth_right_samples_12", "m"),
    ("pinion_teeth_right_samples_13", "m"), ("pinion_teeth_right_samples_14", "m"), ("pinion_teeth_right_samples_15", "m"),
    ("pinion_teeth_right_samples_16", "m"), ("pinion_teeth_right_samples_17", "m"), ("pinion_teeth_right_samples_18", "m"),
    ("pinion_teeth_right_samples_19", "m"), ("pinion_teeth_right_samples_20", "m"), ("pinion_teeth_right_samples_21", "m"),
    ("pinion_teeth_right_samples_22", "m"), ("pinion_teeth_right_samples_23", "m"), ("pinion_teeth_right_samples_24", "m"),
    ("pinion_teeth_right_samples_25", "m"), ("pinion_teeth_right_samples_26", "m"), ("pinion_teeth_right_samples_27", "m"),
    ("pinion_teeth_right_samples_28", "m"), ("pinion_teeth_right_samples_29", "m"), ("pinion_teeth_right_samples_30", "m"),
    ("pinion_teeth_right_samples_31", "m"), ("pinion_teeth_right_samples_32", "m"), ("pinion_teeth_right_samples_33", "m"),
    ("pinion_teeth_right_samples_34", "m"), ("pinion_teeth_right_samples_35", "m"), ("pinion_teeth_right_samples_36", "m"),
    ("pinion_teeth_right_samples_37", "m"), ("pinion_teeth_right_samples_38", "m"), ("pinion_teeth_right_samples_39", "m"),
    ("pinion_teeth_right_samples_40", "m"), ("half_mesh_stiffness", "N/m"), ("inverse_wheel_inertia", "1/(kg m^2)"),
    ("half_wheel_inertia", "kg m^2"), ("half_pinion_inertia", "kg m^2"),
)

OPERATIONS = (
    ("constants", 13), ("start", 18), ("scales", 18), ("coordinate_rates", 0), ("gaps", 49), ("gap_accelerations", 123),
    ("contact_mesh_1", 68), ("contact_mesh_2", 68), ("applied", 0), ("accelerations", 6), ("ledger", 6), ("energy", 39), ("poses", 12),
    ("outputs", 21), ("landmarks", 8),
)

WHEEL_TEETH_LEFT_CURVE = (
    (0.0, 1.0),
    False,
    False,
    2,
    31,
    (0.0, 0.030912787013890417, 0.06273602045272884, 0.09556098274473254, 0.12948677184859644, 0.16463371417246547, 0.20114000144982067, 0.23918024725815076, 0.27896220244638187, 0.3207543808437755, 0.36489701439758976, 0.4118298946588628, 0.46216642791472146, 0.5167751938919869, 0.5769774557562443, 0.6449401497344708, 0.724778838445542, 0.8264397245378218, 1.0),
)

PINION_TEETH_LEFT_CURVE = (
    (0.0, 1.0),
    False,
    False,
    2,
    20,
    (0.0, 0.029465719791189927, 0.0597529250526708, 0.09093156344113047, 0.12308916959974167, 0.15632146233729227, 0.19074429518098532, 0.22649777308823044, 0.2637469383836322, 0.30269821925698587, 0.3436082663242695, 0.3868045636558044, 0.43272268147386633, 0.48195276845940443, 0.5353321883553637, 0.5941302412098282, 0.6604356819977236, 0.7381648246891996, 0.8366655482300812, 0.9999999999999998),
)

WHEEL_TEETH_RIGHT_CURVE = (
    (0.0, 1.0),
    False,
    False,
    2,
    31,
    (0.0, 0.17356027546217762, 0.27522116155445775, 0.35505985026552855, 0.4230225442437552, 0.4832248061080128, 0.5378335720852785, 0.5881701053411378, 0.6351029856024104, 0.6792456191562248, 0.7210377975536183, 0.7608197527418493, 0.7988599985501795, 0.8353662858275348, 0.8705132281514039, 0.9044390172552678, 0.9372639795472715, 0.9690872129861097, 1.0),
)

PINION_TEETH_RIGHT_CURVE = (
    (0.0, 1.0),
    False,
    False,
    2,
    20,
    (0.0, 0.1633344517699191, 0.26183517531080136, 0.33956431800227727, 0.4058697587901724, 0.46466781164463705, 0.5180472315405961, 0.567277318526134, 0.6131954363441965, 0.6563917336757309, 0.6973017807430145, 0.7362530616163685, 0.7735022269117698, 0.8092557048190155, 0.8436785376627078, 0.8769108304002584, 0.9090684365588695, 0.9402470749473292, 0.9705342802088099, 1.0),
)

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


def _samples(curve, data, given):
    """Points of a curve at the parameters of its samples, first all x, then all y."""
    points = [curve(s, *ca.vertsplit(given))[:2] for s in data[-1]]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _drawn_teeth(curve, data, given, root):
    """Points of teeth for a picture: each flank from its root, followed by its mirror image, first all x, then all y."""
    (start, end), copies = data[0], data[4]
    flank = [curve(start + (end - start)*k/8, *ca.vertsplit(given))[:2] for k in range(9)]
    (x, y), deep = flank[0], root/ca.sqrt(flank[0][0]**2 + flank[0][1]**2)
    flank = [(deep*x, deep*y), *flank]
    tooth = [*flank, *((x, -y) for x, y in flank[::-1])]
    turns = [(ca.cos(2*ca.pi*k/copies), ca.sin(2*ca.pi*k/copies)) for k in range(copies)]
    points = [(c*x - s*y, s*x + c*y) for c, s in turns for x, y in tooth]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _between(first, first_data, second, second_data, samples, other_samples, given, other_given, pose, which=1):
    """Signed distance of two curves, normal out of the second, its foot there, coefficients of their motion, both parameters.

    `pose` is x, y, cosine and sine of the first curve's place against the second's. Newton's method on both parameters, until the
    normals are opposite and in line, or at an end, from the nearest samples: in several hollows where a curve is not convex, and
    at the three copies that face the other curve. Of these the least distance, not deeper than samples are apart, or of copies the
    next in this order, `which`. A function of
    its own, which is called; its derivatives are the results themselves.
    """
    if (first, second, which) not in _BETWEEN:
        curves, rows = (first, second), (first_data, second_data)
        at, place = ca.SX.sym("at", 2), ca.SX.sym("pose", 4)
        values = [ca.SX.sym("given", x.numel()) for x in (given, other_given)]
        steps = [max(b - a for a, b in zip(d[5], (*d[5][1:], d[5][0] + d[0][1] - d[0][0]) if d[1] else d[5][1:], strict=False)) for d in rows]
        one_hollow = rows[0][4] > 1 or rows[0][3] == rows[1][3] == 1

        def refine(count):  # of Newton's method, from two parameters
            ox, oy, c, s = ca.vertsplit(place)
            found = ca.vertsplit(at)

            def ends(i, move):  # whether it stands at an end and would go on
                (start, end), closed = rows[i][:2]
                way = move*speeds[i]
                return 0 if closed else ca.logic_or(ca.logic_and(found[i] <= start, way < 0), ca.logic_and(found[i] >= end, way > 0))

            for k in range(count + 1):
                points, ways, bends, speeds = [], [], [], []
                for i, (curve, ((start, end), closed, hole, *_)) in enumerate(zip(curves, rows, strict=True)):
                    if closed:
                        found[i] = found[i] - (end - start)*ca.floor((found[i] - start)/(end - start))
                    x, y, dx, dy, ddx, ddy = curve(found[i], *ca.vertsplit(values[i]))
                    length, side = ca.sqrt(dx**2 + dy**2), -1 if hole else 1
                    way = side*dx/length, side*dy/length
                    points.append((x, y) if i else (ox + c*x - s*y, oy + s*x + c*y))
                    ways.append(way if i else (c*way[0] - s*way[1], s*way[0] + c*way[1]))
                    bends.append(side*(dx*ddy - dy*ddx)/length**3)
                    speeds.append(side*length)
                (ax, ay), (bx, by) = ways
                wx, wy = points[0][0] - points[1][0], points[0][1] - points[1][1]
                h, under = wx*by - wy*bx, wy*ax - wx*ay  # heights over the second and the first
                along, beside = wx*bx + wy*by, wx*ax + wy*ay
                tilt = ca.atan2(by*ax - bx*ay, -ax*bx - ay*by)
                wide, other = ca.fmax(1 + bends[1]*h, 1e-3), ca.fmax(1 + bends[0]*under, 1e-3)
                bent, least = bends[0]*wide + bends[1], 1e-3*(ca.fabs(bends[0]) + ca.fabs(bends[1])) + 1e-300
                newton, bent = bent > least, ca.fmax(bent, least)  # else each goes to where it is nearest to the other's point
                move = ca.if_else(newton, (bends[1]*along - wide*tilt)/bent, -beside/other)
                one = ends(0, move)
                last = ca.if_else(ca.logic_and(newton, ca.logic_not(one)), (bends[0]*along + tilt)/bent, along/wide)
                two = ends(1, last)
                move = ca.if_else(two, -beside/other, move)
                one = ends(0, move)
                for i, (stands, way) in enumerate(((one, move), (two, last)) if k < count else ()):
                    (start, end), closed = rows[i][:2]
                    found[i] = found[i] + ca.if_else(stands, 0, ca.fmin(ca.fmax(way/speeds[i], -steps[i]), steps[i]))
                    found[i] = found[i] if closed else ca.fmin(ca.fmax(found[i], start), end)
            apart = ca.fmax(ca.sqrt(wx**2 + wy**2), 1e-300)
            result = ca.vertcat(h, by, -bx, bends[0]/bent, (1 + bends[0]*h)/bent, bends[0]*bends[1]/bent)
            result = ca.if_else(one, ca.vertcat(h, by, -bx, 1/wide, h/wide, bends[1]/wide), result)
            result = ca.if_else(two, ca.vertcat(under, -ay, ax, 0, 0, bends[0]/other), result)
            result = ca.if_else(ca.logic_and(one, two), ca.vertcat(apart, wx/apart, wy/apart, 0, 0, 1/apart), result)
            met = ca.logic_or(ca.fabs(tilt) < 1e-3, ca.logic_or(one, two))
            result = ca.vertcat(result[:3], *points[1], result[3:], *found, *(1/speed for speed in speeds), met)
            return ca.Function("refined", [at, place, *values], [ca.densify(result)])

        refined, again = refine(6 if one_hollow else 9), refine(1)

        tables = [ca.MX.sym("samples", x.numel()) for x in (samples, other_samples)]
        values, place = [ca.MX.sym("given", x.numel()) for x in (given, other_given)], ca.MX.sym("pose", 4)
        ox, oy, c, s = ca.vertsplit(place)

        def seen(at, angle, how, place, *values):  # what is found from two parameters, of copies that are turned by angles
            ox, oy, c, s = ca.vertsplit(place)
            cos, sin = ca.cos(angle[1]), ca.sin(angle[1])
            turned = ca.atan2(s, c) + angle[0] - angle[1]
            near = ca.vertcat(cos*ox + sin*oy, cos*oy - sin*ox, ca.cos(turned), ca.sin(turned))
            h, nx, ny, px, py, *rest, met = ca.vertsplit(how(at, near, *values))
            return [h, cos*nx - sin*ny, sin*nx + cos*ny, cos*px - sin*py, sin*px + cos*py, *rest], met

        spread = []
        for table, (_, _, _, _, copies, at), (dx, dy) in zip(tables, rows, ((-c*ox - s*oy, s*ox - c*oy), (ox, oy)), strict=True):
            x, y, m = table[: len(at)], table[len(at) :], len(at)
            turns = ca.MX(0)
            if copies > 1:  # the copy towards the other curve, and its neighbours
                facing = ca.floor((ca.atan2(dy, dx) - ca.atan2(ca.sum1(y), ca.sum1(x)))*copies/(2*ca.pi) + 0.5)
                turned = [facing + j for j in (-1, 0, 1)]
                angles = [2*ca.pi*turn/copies for turn in turned]
                x, y = (
                    ca.vertcat(*(ca.cos(a)*x - ca.sin(a)*y for a in angles)), ca.vertcat(*(ca.sin(a)*x + ca.cos(a)*y for a in angles)),
                )
                turns = ca.vertcat(*(turn for turn in turned for _ in at))
            spread.append((x, y, ca.MX(ca.DM(at*3 if copies > 1 else at)), turns))
        (x, y, parameters, turns), (to_x, to_y, to_parameters, to_turns) = spread
        x, y = ox + c*x - s*y, oy + s*x + c*y

        def nearest(some_x, some_y, at_x, at_y):  # of some points
            apart = (some_x - at_x)**2 + (some_y - at_y)**2
            return ca.find(apart <= ca.mmin(apart))

        n, m, starts = x.numel(), to_x.numel(), []
        if one_hollow:  # to and fro
            count = len(rows[0][5])
            for j in range(n//count):
                here = slice(j*count, (j + 1)*count)
                k = nearest(to_x, to_y, ca.sum1(x[here])/count, ca.sum1(y[here])/count)
                starts.append(j*count + nearest(x[here], y[here], to_x[k], to_y[k]))
        else:
            squares = (ca.repmat(x.T, m, 1) - ca.repmat(to_x, 1, n))**2 + (ca.repmat(y.T, m, 1) - ca.repmat(to_y, 1, n))**2
            d = ca.vertcat(*map(ca.mmin, ca.horzsplit(squares)))
            starts.append(ca.find(d <= ca.mmin(d)))
            before, after = ca.vertcat(d[-1] if rows[0][1] else 1e300, d[:-1]), ca.vertcat(d[1:], d[0] if rows[0][1] else 1e300)
            hollow, least = ca.if_else(ca.logic_and(d <= before, d < after), d, 1e300), ca.mmin(d)
            for _ in range(3):
                hollow = ca.if_else(hollow > least, hollow, 1e300)
                least = ca.mmin(hollow)
                starts.append(ca.find(hollow <= least))
        widest = []
        for table, (*_, at) in zip(tables, rows, strict=True):
            all_x, all_y = table[: len(at)], table[len(at) :]
            widest.append(ca.mmax((all_x[1:] - all_x[:-1])**2 + (all_y[1:] - all_y[:-1])**2))
        deepest = -ca.sqrt(ca.fmin(*widest))
        best = []
        for i in starts:
            j = nearest(to_x, to_y, x[i], y[i])
            angle = [2*ca.pi*turn[k if copies > 1 else 0]/copies for turn, k, copies in ((turns, i, rows[0][4]), (to_turns, j, rows[1][4]))]
            (*result, one, two, own, other), met = seen(ca.vertcat(parameters[i], to_parameters[j]), angle, refined, place, *values)
            along = (
                p + (row[0][1] - row[0][0])*(turn[k] - row[4]*ca.floor(turn[k]/row[4])) if row[4] > 1 else p
                for p, turn, k, row in ((one, turns, i, rows[0]), (two, to_turns, j, rows[1]))
            )
            new = ca.vertcat(*result, *along, own, other, one, two, *angle)
            here = ca.if_else(ca.logic_and(met, new[0] >= deepest), new[0], 1e299)
            for k, (old, least) in enumerate(best):  # in order; equal ones, but for rounding, as they come
                first_ = here < least + 1e-10*deepest
                best[k] = ca.if_else(first_, new, old), ca.if_else(first_, here, least)
                new, here = ca.if_else(first_, old, new), ca.if_else(first_, least, here)
            best = [*best, (new, here)][:which]
        result, least = best[-1]
        if which > 1:  # if there is one
            result = ca.vertcat(ca.if_else(least < 1e290, result[0], ca.fabs(result[0]) - deepest), result[1:])

        def shaped(_, __, first_values, second_values, place, o):
            value, _ = seen(o[12:14], ca.vertsplit(o[14:16]), again, place, first_values, second_values)
            return None, None, *(ca.jacobian(ca.vertcat(*value[:10]), x) for x in (first_values, second_values, place))

        _BETWEEN[first, second, which] = _called("between", [*tables, *values, place], result, _slope_between, shaped)
    return _BETWEEN[first, second, which](samples, other_samples, given, other_given, pose)


_BETWEEN: "dict[object, ca.Function]" = {}


def wheel_teeth_left_curve(s, pressure_angle, module, thinning):
    """Point of the curve wheel_teeth_left at its parameter, and derivatives by it: x, y, x', y', x'', y''."""
    cos_pressure_angle = ca.cos(pressure_angle)
    inverse_cos_pressure_angle_squared = 1/(cos_pressure_angle*cos_pressure_angle)
    x3 = 1089*inverse_cos_pressure_angle_squared/961
    x4 = x3 - 1
    x5 = ca.sqrt(x4)
    x6 = -0.96*s
    x7 = 1.0 + x6
    tan_pressure_angle = ca.tan(pressure_angle)
    minus_tan_pressure_angle = -tan_pressure_angle
    x10 = 15*3.141592653589793/31
    x11 = x5*x7
    x12 = thinning/(31*module)
    x13 = x10 + x11 + x12 + minus_tan_pressure_angle + pressure_angle
    x14 = ca.cos(x13)
    x15 = ca.sin(x13)
    x16 = -1.0443521331945889*inverse_cos_pressure_angle_squared
    x17 = 0.9216 + x16
    x18 = 0.96*s
    x19 = x18 - 1.0
    x20 = -x19*x5
    x21 = x10 + x12 + x20 + minus_tan_pressure_angle + pressure_angle
    x22 = ca.sin(x21)
    x23 = -1.08786680541103*inverse_cos_pressure_angle_squared
    x24 = 0.96 + x23
    x25 = ca.cos(x21)
    return 31*cos_pressure_angle*(x15 - x14*x5*x7)*module/2, -31*cos_pressure_angle*(-x14 - x15*x5*x7)*module/2, -14.879999999999999*cos_pressure_angle*x15*x4*x7*module, -14.879999999999999*cos_pressure_angle*x14*x4*x7*module, 31*cos_pressure_angle*(0.96*x19*x24*x25*x5 - x17*x22)*module/2, -31*cos_pressure_angle*(x17*x25 + 0.96*x19*x22*x24*x5)*module/2


def pinion_teeth_left_curve(s, pressure_angle, module, thinning):
    """Point of the curve pinion_teeth_left at its parameter, and derivatives by it: x, y, x', y', x'', y''."""
    cos_pressure_angle = ca.cos(pressure_angle)
    inverse_cos_pressure_angle_squared = 1/(cos_pressure_angle*cos_pressure_angle)
    x3 = 121*inverse_cos_pressure_angle_squared/100
    x4 = x3 - 1
    x5 = ca.sqrt(x4)
    x6 = -0.96*s
    x7 = 1.0 + x6
    tan_pressure_angle = ca.tan(pressure_angle)
    minus_tan_pressure_angle = -tan_pressure_angle
    x10 = 19*3.141592653589793/40
    x11 = x5*x7
    x12 = thinning/(20*module)
    x13 = x10 + x11 + x12 + minus_tan_pressure_angle + pressure_angle
    x14 = ca.cos(x13)
    x15 = ca.sin(x13)
    x16 = -1.115136*inverse_cos_pressure_angle_squared
    x17 = 0.9216 + x16
    x18 = 0.96*s
    x19 = x18 - 1.0
    x20 = -x19*x5
    x21 = x10 + x12 + x20 + minus_tan_pressure_angle + pressure_angle
    x22 = ca.sin(x21)
    x23 = -1.1616*inverse_cos_pressure_angle_squared
    x24 = 0.96 + x23
    x25 = ca.cos(x21)
    return 10*cos_pressure_angle*(x15 - x14*x5*x7)*module, -10*cos_pressure_angle*(-x14 - x15*x5*x7)*module, -9.6*cos_pressure_angle*x15*x4*x7*module, -9.6*cos_pressure_angle*x14*x4*x7*module, 10*cos_pressure_angle*(0.96*x19*x24*x25*x5 - x17*x22)*module, -10*cos_pressure_angle*(x17*x25 + 0.96*x19*x22*x24*x5)*module


def wheel_teeth_right_curve(s, pressure_angle, module, thinning):
    """Point of the curve wheel_teeth_right at its parameter, and derivatives by it: x, y, x', y', x'', y''."""
    cos_pressure_angle = ca.cos(pressure_angle)
    inverse_cos_pressure_angle_squared = 1/(cos_pressure_angle*cos_pressure_angle)
    x3 = 1089*inverse_cos_pressure_angle_squared/961
    x4 = x3 - 1
    x5 = ca.sqrt(x4)
    x6 = 0.96*s
    x7 = 0.04 + x6
    tan_pressure_angle = ca.tan(pressure_angle)
    minus_tan_pressure_angle = -tan_pressure_angle
    x10 = 15*3.141592653589793/31
    x11 = x5*x7
    x12 = thinning/(31*module)
    x13 = x10 + x11 + x12 + minus_tan_pressure_angle + pressure_angle
    x14 = ca.cos(x13)
    x15 = ca.sin(x13)
    x16 = -1.0443521331945889*inverse_cos_pressure_angle_squared
    x17 = 0.9216 + x16
    x18 = -1.08786680541103*inverse_cos_pressure_angle_squared
    x19 = 0.96 + x18
    return 31*cos_pressure_angle*(x15 - x14*x5*x7)*module/2, 31*cos_pressure_angle*(-x14 - x15*x5*x7)*module/2, 14.879999999999999*cos_pressure_angle*x15*x4*x7*module, -14.879999999999999*cos_pressure_angle*x14*x4*x7*module, -31*cos_pressure_angle*(x15*x17 + 0.96*x14*x19*x5*x7)*module/2, -31*cos_pressure_angle*(0.96*x15*x19*x5*x7 - x14*x17)*module/2


def pinion_teeth_right_curve(s, pressure_angle, module, thinning):
    """Point of the curve pinion_teeth_right at its parameter, and derivatives by it: x, y, x', y', x'', y''."""
    cos_pressure_angle = ca.cos(pressure_angle)
    inverse_cos_pressure_angle_squared = 1/(cos_pressure_angle*cos_pressure_angle)
    x3 = 121*inverse_cos_pressure_angle_squared/100
    x4 = x3 - 1
    x5 = ca.sqrt(x4)
    x6 = 0.96*s
    x7 = 0.04 + x6
    tan_pressure_angle = ca.tan(pressure_angle)
    minus_tan_pressure_angle = -tan_pressure_angle
    x10 = 19*3.141592653589793/40
    x11 = x5*x7
    x12 = thinning/(20*module)
    x13 = x10 + x11 + x12 + minus_tan_pressure_angle + pressure_angle
    x14 = ca.cos(x13)
    x15 = ca.sin(x13)
    x16 = -1.115136*inverse_cos_pressure_angle_squared
    x17 = 0.9216 + x16
    x18 = -1.1616*inverse_cos_pressure_angle_squared
    x19 = 0.96 + x18
    return 10*cos_pressure_angle*(x15 - x14*x5*x7)*module, 10*cos_pressure_angle*(-x14 - x15*x5*x7)*module, 9.6*cos_pressure_angle*x15*x4*x7*module, -9.6*cos_pressure_angle*x14*x4*x7*module, -10*cos_pressure_angle*(x15*x17 + 0.96*x14*x19*x5*x7)*module, -10*cos_pressure_angle*(0.96*x15*x19*x5*x7 - x14*x17)*module


def curve_on_curve_contact(t_times_firing, cos, sin, between, second_speed, third_speed, mesh_stiffness, mesh_damping, swing_over_firing,
        arm_x):
    """Return normal_force [N], normal_power [W], first_push_on [N m], second_push_on [N m]."""
    first_speed = swing_over_firing*ca.sin(t_times_firing) + third_speed
    distance = between[0]
    normal_x = between[1]
    normal_y = between[2]
    foot_x = between[3]
    foot_y = between[4]
    elastic_force = ca.if_else(-distance > 0, -distance*mesh_stiffness, 0)
    normal_x_2 = normal_x*cos - normal_y*sin
    normal_y_2 = normal_y*cos + normal_x*sin
    foot_x_2 = foot_x*cos - foot_y*sin
    foot_y_2 = foot_y*cos + foot_x*sin
    contact_x = arm_x + foot_x_2
    relative_rate_x = second_speed*foot_y_2 - foot_y_2*first_speed
    contact_x_minus_arm_x = contact_x - arm_x
    relative_rate_y = contact_x*first_speed - second_speed*contact_x_minus_arm_x
    penetration_rate = -normal_x_2*relative_rate_x - normal_y_2*relative_rate_y
    resistance = ca.if_else(-distance > 0, -distance*penetration_rate*mesh_damping, 0)
    normal_force = resistance + elastic_force
    normal_power = penetration_rate*resistance
    push_x = normal_force*normal_x_2
    push_y = normal_force*normal_y_2
    first_push_on = contact_x*push_y - push_x*foot_y_2
    second_push_on = push_x*foot_y_2 - contact_x_minus_arm_x*push_y
    return normal_force, normal_power, first_push_on, second_push_on


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (21,): pinion_inertia, module, pressure_angle, thinning, pinion_speed, firing, swing, drag, mesh_stiffness, mesh_damping,
            swing_over_firing_squared, swing_over_firing, wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples,
            wheel_teeth_right_samples, pinion_teeth_right_samples, half_mesh_stiffness, inverse_wheel_inertia, half_wheel_inertia,
            half_pinion_inertia
    """
    pinion_inertia, wheel_inertia, module, pressure_angle, thinning, pinion_speed, firing = p[1], p[3], p[4], p[5], p[6], p[7], p[8]
    swing, drag, mesh_stiffness, mesh_damping = p[9], p[10], p[11], p[12]
    swing_over_firing_squared = swing/(firing*firing)
    swing_over_firing = swing/firing
    wheel_arm_x = 51*module/2
    wheel_teeth_left_samples = _samples(wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, ca.vertcat(pressure_angle, module, thinning))
    pinion_teeth_left_samples = _samples(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, ca.vertcat(pressure_angle, module, thinning))
    wheel_teeth_right_samples = _samples(wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, ca.vertcat(pressure_angle, module, thinning))
    pinion_teeth_right_samples = _samples(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, ca.vertcat(pressure_angle, module, thinning))
    half_mesh_stiffness = mesh_stiffness/2
    inverse_wheel_inertia = 1/wheel_inertia
    half_wheel_inertia = wheel_inertia/2
    half_pinion_inertia = pinion_inertia/2
    return ca.vertcat(pinion_inertia, module, pressure_angle, thinning, pinion_speed, firing, swing, drag, mesh_stiffness, mesh_damping,
        swing_over_firing_squared, swing_over_firing, wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples,
        wheel_teeth_right_samples, pinion_teeth_right_samples, half_mesh_stiffness, inverse_wheel_inertia, half_wheel_inertia,
        half_pinion_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    wheel_inertia, module, pressure_angle, thinning, pinion_speed, swing, drag = p[3], p[4], p[5], p[6], p[7], p[9], p[10]
    mesh_stiffness = p[11]
    return (ca.vertcat(2*thinning/(31*module) + 4*(20*swing*wheel_inertia/31 +
            drag)/(961*mesh_stiffness*module*module*ca.cos(pressure_angle)**2)),
        ca.vertcat(-20*pinion_speed/31))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (4,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    pinion_mass, wheel_mass, module, pressure_angle, thinning, pinion_speed = p[0], p[2], p[4], p[5], p[6], p[7]
    total_mass = pinion_mass + wheel_mass
    cos_pressure_angle = ca.cos(pressure_angle)
    energy_scale = total_mass*cos_pressure_angle*cos_pressure_angle*module*module*pinion_speed*pinion_speed/2
    force_scale = energy_scale/thinning
    return (ca.vertcat(2*thinning/(31*cos_pressure_angle*module)), ca.vertcat(2*pinion_speed/31),
        ca.vertcat(energy_scale, energy_scale, energy_scale, energy_scale),
        ca.vertcat(thinning, cos_pressure_angle*module*pinion_speed, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [rad/s]
    """
    idler_speed = u[0]
    return ca.vertcat(idler_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (2,): PAIRS [m]
        dG (2,): PAIRS [m/s]
    """
    module, pressure_angle, thinning, pinion_speed, firing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[10]
    swing_over_firing, wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples = c[11], c[12], c[13:51], c[51:91]
    wheel_teeth_right_samples, pinion_teeth_right_samples = c[91:129], c[129:169]
    idler_angle = q[0]
    idler_speed = u[0]
    t_times_firing = t*firing
    input_angle = swing_over_firing_squared*(1 - ca.cos(t_times_firing)) + t*pinion_speed
    input_speed = swing_over_firing*ca.sin(t_times_firing) + pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_1_relative_turning = input_speed - idler_speed
    mesh_1_between = _between(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, pinion_teeth_left_samples, wheel_teeth_left_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_1_distance = mesh_1_between[0]
    mesh_1_normal_x = mesh_1_between[1]
    mesh_1_normal_y = mesh_1_between[2]
    mesh_1_foot_x = mesh_1_between[3]
    mesh_1_foot_y = mesh_1_between[4]
    cos_wheel_rate = -idler_speed*sin_wheel
    mesh_1_local_x_rate = -cos_wheel_rate*wheel_arm_x
    mesh_1_slip_x = mesh_1_local_x_rate - mesh_1_relative_turning*(mesh_1_foot_y - mesh_1_local_y)
    sin_wheel_rate = cos_wheel*idler_speed
    mesh_1_local_y_rate = sin_wheel_rate*wheel_arm_x
    mesh_1_slip_y = mesh_1_local_y_rate + mesh_1_relative_turning*(mesh_1_foot_x - mesh_1_local_x)
    mesh_1_distance_rate = mesh_1_normal_x*mesh_1_slip_x + mesh_1_normal_y*mesh_1_slip_y
    mesh_2_between = _between(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, pinion_teeth_right_samples, wheel_teeth_right_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_2_distance = mesh_2_between[0]
    mesh_2_normal_x = mesh_2_between[1]
    mesh_2_normal_y = mesh_2_between[2]
    mesh_2_foot_x = mesh_2_between[3]
    mesh_2_foot_y = mesh_2_between[4]
    mesh_2_slip_x = mesh_1_local_x_rate - mesh_1_relative_turning*(mesh_2_foot_y - mesh_1_local_y)
    mesh_2_slip_y = mesh_1_local_y_rate + mesh_1_relative_turning*(mesh_2_foot_x - mesh_1_local_x)
    mesh_2_distance_rate = mesh_2_normal_x*mesh_2_slip_x + mesh_2_normal_y*mesh_2_slip_y
    return ca.vertcat(mesh_1_distance, mesh_2_distance), ca.vertcat(mesh_1_distance_rate, mesh_2_distance_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (2,): PAIRS [m/s^2]
    """
    module, pressure_angle, thinning, pinion_speed, firing, swing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[6], c[10]
    swing_over_firing, wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples = c[11], c[12], c[13:51], c[51:91]
    wheel_teeth_right_samples, pinion_teeth_right_samples = c[91:129], c[129:169]
    idler_angle = q[0]
    idler_speed = u[0]
    idler_acceleration = a[0]
    t_times_firing = t*firing
    x2 = ca.cos(t_times_firing)
    input_angle = swing_over_firing_squared*(1 - x2) + t*pinion_speed
    input_speed = swing_over_firing*ca.sin(t_times_firing) + pinion_speed
    input_acceleration = x2*swing
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_1_relative_turning = input_speed - idler_speed
    mesh_1_between = _between(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, pinion_teeth_left_samples, wheel_teeth_left_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_1_normal_x = mesh_1_between[1]
    mesh_1_normal_y = mesh_1_between[2]
    mesh_1_foot_x = mesh_1_between[3]
    mesh_1_foot_y = mesh_1_between[4]
    mesh_1_share = mesh_1_between[5]
    mesh_1_rolling = mesh_1_between[6]
    mesh_1_bend = mesh_1_between[7]
    cos_wheel_rate = -idler_speed*sin_wheel
    mesh_1_local_x_rate = -cos_wheel_rate*wheel_arm_x
    mesh_1_slip_x = mesh_1_local_x_rate - mesh_1_relative_turning*(mesh_1_foot_y - mesh_1_local_y)
    sin_wheel_rate = cos_wheel*idler_speed
    mesh_1_local_y_rate = sin_wheel_rate*wheel_arm_x
    mesh_1_foot_x_minus_mesh_1_local_x = mesh_1_foot_x - mesh_1_local_x
    mesh_1_slip_y = mesh_1_local_y_rate + mesh_1_relative_turning*mesh_1_foot_x_minus_mesh_1_local_x
    mesh_1_along_curve = mesh_1_normal_x*mesh_1_slip_y - mesh_1_normal_y*mesh_1_slip_x
    mesh_1_turning = mesh_1_along_curve*mesh_1_bend + mesh_1_relative_turning*(1 - mesh_1_share)
    mesh_1_moved = mesh_1_along_curve*mesh_1_share + mesh_1_relative_turning*mesh_1_rolling
    mesh_2_between = _between(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, pinion_teeth_right_samples, wheel_teeth_right_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_2_normal_x = mesh_2_between[1]
    mesh_2_normal_y = mesh_2_between[2]
    mesh_2_foot_x = mesh_2_between[3]
    mesh_2_foot_y = mesh_2_between[4]
    mesh_2_share = mesh_2_between[5]
    mesh_2_rolling = mesh_2_between[6]
    mesh_2_bend = mesh_2_between[7]
    mesh_2_slip_x = mesh_1_local_x_rate - mesh_1_relative_turning*(mesh_2_foot_y - mesh_1_local_y)
    mesh_2_foot_x_minus_mesh_1_local_x = mesh_2_foot_x - mesh_1_local_x
    mesh_2_slip_y = mesh_1_local_y_rate + mesh_1_relative_turning*mesh_2_foot_x_minus_mesh_1_local_x
    mesh_2_along_curve = mesh_2_normal_x*mesh_2_slip_y - mesh_2_normal_y*mesh_2_slip_x
    mesh_2_turning = mesh_1_relative_turning*(1 - mesh_2_share) + mesh_2_along_curve*mesh_2_bend
    mesh_2_moved = mesh_1_relative_turning*mesh_2_rolling + mesh_2_along_curve*mesh_2_share
    idler_speed_squared = idler_speed*idler_speed
    cos_wheel_rate_rate = -cos_wheel*idler_speed_squared - idler_acceleration*sin_wheel
    mesh_1_local_x_rate_rate = -cos_wheel_rate_rate*wheel_arm_x
    mesh_1_relative_turning_rate = input_acceleration - idler_acceleration
    x6 = mesh_1_local_y_rate*mesh_1_relative_turning
    mesh_1_slip_x_rate = mesh_1_local_x_rate_rate + x6 + mesh_1_relative_turning_rate*(mesh_1_local_y - mesh_1_foot_y) - mesh_1_moved*mesh_1_normal_x*mesh_1_relative_turning
    sin_wheel_rate_rate = cos_wheel*idler_acceleration - sin_wheel*idler_speed_squared
    mesh_1_local_y_rate_rate = sin_wheel_rate_rate*wheel_arm_x
    x7 = -mesh_1_local_x_rate*mesh_1_relative_turning
    mesh_1_slip_y_rate = mesh_1_local_y_rate_rate + x7 + mesh_1_relative_turning_rate*mesh_1_foot_x_minus_mesh_1_local_x - mesh_1_moved*mesh_1_normal_y*mesh_1_relative_turning
    mesh_1_distance_rate_rate = mesh_1_normal_x*mesh_1_slip_x_rate + mesh_1_normal_y*mesh_1_slip_y_rate + mesh_1_normal_x*mesh_1_slip_y*mesh_1_turning - mesh_1_normal_y*mesh_1_slip_x*mesh_1_turning
    mesh_2_slip_x_rate = mesh_1_local_x_rate_rate + x6 + mesh_1_relative_turning_rate*(mesh_1_local_y - mesh_2_foot_y) - mesh_1_relative_turning*mesh_2_moved*mesh_2_normal_x
    mesh_2_slip_y_rate = mesh_1_local_y_rate_rate + x7 + mesh_1_relative_turning_rate*mesh_2_foot_x_minus_mesh_1_local_x - mesh_1_relative_turning*mesh_2_moved*mesh_2_normal_y
    mesh_2_distance_rate_rate = mesh_2_normal_x*mesh_2_slip_x_rate + mesh_2_normal_y*mesh_2_slip_y_rate + mesh_2_normal_x*mesh_2_slip_y*mesh_2_turning - mesh_2_normal_y*mesh_2_slip_x*mesh_2_turning
    return ca.vertcat(mesh_1_distance_rate_rate, mesh_2_distance_rate_rate)


def contact_mesh_1(t, q, u, z, m, c):
    """Forces of mesh_1: power x power_damping. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): idler [N m], input [N m]
        dz (4,): MEMORY [W]
        normal_force (1,): mesh_1 [N]
        sliding_velocity (0,): empty
        in_range (1,): mesh_1 [1]
    """
    module, pressure_angle, thinning, pinion_speed, firing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[10]
    wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples = c[12], c[13:51], c[51:91]
    idler_angle = q[0]
    t_times_firing = t*firing
    input_angle = swing_over_firing_squared*(1 - ca.cos(t_times_firing)) + t*pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_1_between = _between(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, pinion_teeth_left_samples, wheel_teeth_left_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    normal_force, normal_power, first_push_on, second_push_on = curve_on_curve_contact(t_times_firing, cos_wheel, sin_wheel, mesh_1_between, u[0], pinion_speed, c[8], c[9], c[11], wheel_arm_x)
    return (ca.vertcat(second_push_on, first_push_on), ca.vertcat(0, 0, normal_power, 0), ca.vertcat(normal_force), ca.vertcat(),
            ca.vertcat(1))


def contact_mesh_2(t, q, u, z, m, c):
    """Forces of mesh_2: power x power_damping; arguments and returns as of contact_mesh_1."""
    module, pressure_angle, thinning, pinion_speed, firing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[10]
    wheel_arm_x, wheel_teeth_right_samples, pinion_teeth_right_samples = c[12], c[91:129], c[129:169]
    idler_angle = q[0]
    t_times_firing = t*firing
    input_angle = swing_over_firing_squared*(1 - ca.cos(t_times_firing)) + t*pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_2_between = _between(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, pinion_teeth_right_samples, wheel_teeth_right_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    normal_force, normal_power, first_push_on, second_push_on = curve_on_curve_contact(t_times_firing, cos_wheel, sin_wheel, mesh_2_between, u[0], pinion_speed, c[8], c[9], c[11], wheel_arm_x)
    return (ca.vertcat(second_push_on, first_push_on), ca.vertcat(0, 0, 0, normal_power), ca.vertcat(normal_force), ca.vertcat(),
            ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): idler [N m], input [N m]
    """
    drag = c[7]
    return ca.vertcat(drag, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): idler.acceleration [rad/s^2]
        reactions (1,): input.reaction [N m]
    """
    pinion_inertia, firing, swing, inverse_wheel_inertia = c[0], c[5], c[6], c[170]
    idler_force, input_force = f[0], f[1]
    input_acceleration = swing*ca.cos(t*firing)
    idler_acc = idler_force*inverse_wheel_inertia
    pinion_torque_z = input_acceleration*pinion_inertia
    input_reaction = pinion_torque_z - input_force
    return ca.vertcat(idler_acc), ca.vertcat(input_reaction)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (4,): MEMORY [W]
    """
    pinion_speed, firing, drag, swing_over_firing = c[4], c[5], c[7], c[11]
    idler_speed = u[0]
    input_reaction_in = reactions[0]
    input_speed = swing_over_firing*ca.sin(t*firing) + pinion_speed
    return ca.vertcat(input_reaction_in*input_speed, idler_speed*drag, 0, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (2,): PAIRS [J]
    """
    module, pressure_angle, thinning, pinion_speed, firing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[10]
    swing_over_firing, wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples = c[11], c[12], c[13:51], c[51:91]
    wheel_teeth_right_samples, pinion_teeth_right_samples, half_mesh_stiffness, half_wheel_inertia = c[91:129], c[129:169], c[169], c[171]
    half_pinion_inertia = c[172]
    idler_angle = q[0]
    idler_speed = u[0]
    t_times_firing = t*firing
    input_angle = swing_over_firing_squared*(1 - ca.cos(t_times_firing)) + t*pinion_speed
    input_speed = swing_over_firing*ca.sin(t_times_firing) + pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_1_between = _between(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, pinion_teeth_left_samples, wheel_teeth_left_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_1_distance = mesh_1_between[0]
    mesh_2_between = _between(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, pinion_teeth_right_samples, wheel_teeth_right_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_2_distance = mesh_2_between[0]
    mesh_1_stored_energy = ca.if_else(-mesh_1_distance > 0, half_mesh_stiffness*mesh_1_distance*mesh_1_distance, 0)
    mesh_2_stored_energy = ca.if_else(-mesh_2_distance > 0, half_mesh_stiffness*mesh_2_distance*mesh_2_distance, 0)
    kinetic = half_wheel_inertia*idler_speed*idler_speed + half_pinion_inertia*input_speed*input_speed
    return ca.vertcat(kinetic), ca.vertcat(0), ca.vertcat(mesh_1_stored_energy, mesh_2_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): pinion.x [m], pinion.y [m], pinion.z [m], wheel.x [m], wheel.y [m], wheel.z [m]
        rotations (18,): pinion.R_xx [1], pinion.R_xy [1], pinion.R_xz [1], pinion.R_yx [1], pinion.R_yy [1], pinion.R_yz [1], pinion.R_zx
            [1], pinion.R_zy [1], pinion.R_zz [1], wheel.R_xx [1], wheel.R_xy [1], wheel.R_xz [1], wheel.R_yx [1], wheel.R_yy [1],
            wheel.R_yz [1], wheel.R_zx [1], wheel.R_zy [1], wheel.R_zz [1]
    """
    pinion_speed, firing, swing_over_firing_squared, wheel_arm_x = c[4], c[5], c[10], c[12]
    idler_angle = q[0]
    input_angle = swing_over_firing_squared*(1 - ca.cos(t*firing)) + t*pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    return (ca.vertcat(0, 0, 0, wheel_arm_x, 0, 0),
        ca.vertcat(cos_pinion, -sin_pinion, 0, sin_pinion, cos_pinion, 0, 0, 0, 1, cos_wheel, -sin_wheel, 0, sin_wheel, cos_wheel, 0, 0, 0,
            1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (6,): OUTPUTS
    """
    module, pressure_angle, thinning, pinion_speed, firing, swing_over_firing_squared = c[1], c[2], c[3], c[4], c[5], c[10]
    wheel_arm_x, wheel_teeth_left_samples, pinion_teeth_left_samples, wheel_teeth_right_samples = c[12], c[13:51], c[51:91], c[91:129]
    pinion_teeth_right_samples = c[129:169]
    idler_angle = q[0]
    input_angle = swing_over_firing_squared*(1 - ca.cos(t*firing)) + t*pinion_speed
    cos_pinion = ca.cos(input_angle)
    sin_pinion = ca.sin(input_angle)
    cos_wheel = ca.cos(idler_angle)
    sin_wheel = ca.sin(idler_angle)
    mesh_1_local_x = -cos_wheel*wheel_arm_x
    mesh_1_local_y = sin_wheel*wheel_arm_x
    mesh_1_turned_x = cos_pinion*cos_wheel + sin_pinion*sin_wheel
    mesh_1_turned_y = cos_wheel*sin_pinion - cos_pinion*sin_wheel
    mesh_1_between = _between(pinion_teeth_left_curve, PINION_TEETH_LEFT_CURVE, wheel_teeth_left_curve, WHEEL_TEETH_LEFT_CURVE, pinion_teeth_left_samples, wheel_teeth_left_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_1_distance = mesh_1_between[0]
    mesh_1_first_parameter = mesh_1_between[8]
    mesh_1_second_parameter = mesh_1_between[9]
    mesh_2_between = _between(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, pinion_teeth_right_samples, wheel_teeth_right_samples, ca.vertcat(pressure_angle, module, thinning), ca.vertcat(pressure_angle, module, thinning), ca.vertcat(mesh_1_local_x, mesh_1_local_y, mesh_1_turned_x, mesh_1_turned_y))
    mesh_2_distance = mesh_2_between[0]
    mesh_2_first_parameter = mesh_2_between[8]
    mesh_2_second_parameter = mesh_2_between[9]
    return ca.vertcat(mesh_1_distance, mesh_1_first_parameter, mesh_1_second_parameter, mesh_2_distance, mesh_2_first_parameter,
        mesh_2_second_parameter)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        input.parent, input.child, idler.parent, idler.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        mesh_1.first, mesh_1.second, mesh_2.first, mesh_2.second (10,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1], across_x
            [1], across_y [1], across_z [1], outline
        engine.child, oil.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        pinion.centre, wheel.centre (3,): x [m], y [m], z [m]
    """
    module, pressure_angle, thinning = p[4], p[5], p[6]
    x1 = 35*module/4
    x2 = _drawn_teeth(pinion_teeth_right_curve, PINION_TEETH_RIGHT_CURVE, ca.vertcat(pressure_angle, module, thinning), x1)
    x3 = 57*module/4
    x4 = _drawn_teeth(wheel_teeth_right_curve, WHEEL_TEETH_RIGHT_CURVE, ca.vertcat(pressure_angle, module, thinning), x3)
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(51*module/2, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x2), ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x4), ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x2),
        ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, x4), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0))
