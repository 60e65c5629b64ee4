"""cam_follower: cam whose roller follower lifts off. Generated from derive/scenes/cam_follower.py.

Do not edit; regenerate with `hertzwerk derive cam_follower`.
Effects:
    gravity: uniform gravity
    motor: constant speed of shaft
    spring: linear spring of guide
    roller: power x power_damping
    energy_ledger: work put in, energy dissipated per effect
Units: 52 assignments and 145 outputs checked, all consistent
Operations: flight 70 (equations of motion and gaps); in contact also contact_roller 32
"""

import casadi as ca

NAME = "cam_follower"
SOURCE = "derive/scenes/cam_follower.py"
SUMMARY = "cam whose roller follower lifts off"
FORMAT = "hertzwerk module 1"
DIGEST = "c3d107693182cc12d9f34d53db953a21"

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), ("motor", "drive", "constant speed of shaft"),
    ("spring", "spring", "linear spring of guide"), ("roller", "contact", "power x power_damping"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("cam_mass", "kg", 1, "body cam, mass"),
    ("cam_inertia", "kg m^2", 0.001, "body cam, inertia"),
    ("follower_mass", "kg", 0.5, "body follower, mass"),
    ("roller_radius", "mm", 10, "pair roller, radius"),
    ("lift", "mm", 10, "scales, length"),
    ("base", "mm", 40, "least distance of the roller's centre from the cam's axis"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("cam_speed", "rpm", 1800, "effect motor, speed"),
    ("spring_stiffness", "N/mm", 2, "effect spring, stiffness"),
    ("preload", "N", 50, ""),
    ("contact_stiffness", "N/m", 100000000.0, "effect roller, stiffness of power"),
    ("contact_damping", "N s/m", 2000, "effect roller, coefficient of the damping of power_damping"),
)

LIMITS = (
    ("cam_mass", "defined", 0, None, True, False, "body cam, mass"),
    ("cam_inertia", "defined", 0, None, False, False, "body cam, inertia"),
    ("follower_mass", "defined", 0, None, True, False, "body follower, mass"),
    ("roller_radius", "defined", 0, None, True, False, "pair roller, radius"),
    ("spring_stiffness", "defined", 0, None, False, False, "effect spring, stiffness"),
    ("contact_stiffness", "defined", 0, None, True, False, "effect roller, stiffness of power"),
    ("contact_damping", "defined", 0, None, True, False, "effect roller, coefficient of the damping of power_damping"),
    ("lift", "defined", 0, None, True, False, "scales, length"),
    ("base", "defined", 0, None, True, False, "scales, arm"),
)

COORDINATES = (("guide.travel", "m"),)

SPEEDS = (("guide.speed", "m/s"),)

MEMORY = (("energy_ledger.input", "J"), ("roller.dissipated", "J"))

PAIRS = (("roller", "circle_on_curve"),)

RELEASES = ("force",)

DISSIPATED = (1,)

OUTPUTS = (("roller.gap", "m"), ("roller.parameter", "1"))

BODIES = ("cam", "follower")

LANDMARKS = (
    ("shaft", "revolute", "parent", "ground", ("axis",)), ("shaft", "revolute", "child", "cam", ("axis",)),
    ("guide", "prismatic", "parent", "ground", ("axis",)), ("guide", "prismatic", "child", "follower", ("axis",)),
    ("roller", "circle_on_curve", "circle", "follower", ("radius",)),
    ("roller", "circle_on_curve", "fixed", "cam", ("along", "across", "outline")), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("motor", "turn_drive", "child", "cam", ("axis",)), ("spring", "slide_spring", "parent", "ground", ("axis",)),
    ("spring", "slide_spring", "child", "follower", ()), ("cam", "body", "centre", "cam", ()),
    ("follower", "body", "centre", "follower", ()), ("follower", "solid_rod", "shape_1", "follower", ("axis", "length")),
)

CONSTANTS = (
    ("follower_mass", "kg"), ("roller_radius", "m"), ("lift", "m"), ("base", "m"), ("gravity", "m/s^2"), ("cam_speed", "1/s"),
    ("spring_stiffness", "N/m"), ("contact_stiffness", "N/m"), ("contact_damping", "N s/m"), ("k1", "m"), ("rim_samples_1", "m"),
    ("rim_samples_2", "m"), ("rim_samples_3", "m"), ("rim_samples_4", "m"), ("rim_samples_5", "m"), ("rim_samples_6", "m"),
    ("rim_samples_7", "m"), ("rim_samples_8", "m"), ("rim_samples_9", "m"), ("rim_samples_10", "m"), ("rim_samples_11", "m"),
    ("rim_samples_12", "m"), ("rim_samples_13", "m"), ("rim_samples_14", "m"), ("rim_samples_15", "m"), ("rim_samples_16", "m"),
    ("rim_samples_17", "m"), ("rim_samples_18", "m"), ("rim_samples_19", "m"), ("rim_samples_20", "m"), ("rim_samples_21", "m"),
    ("rim_samples_22", "m"), ("rim_samples_23", "m"), ("rim_samples_24", "m"), ("rim_samples_25", "m"), ("rim_samples_26", "m"),
    ("rim_samples_27", "m"), ("rim_samples_28", "m"), ("rim_samples_29", "m"), ("rim_samples_30", "m"), ("rim_samples_31", "m"),
    ("rim_samples_32", "m"), ("rim_samples_33", "m"), ("rim_samples_34", "m"), ("rim_samples_35", "m"), ("rim_samples_36", "m"),
    ("rim_samples_37", "m"), ("rim_samples_38", "m"), ("rim_samples_39", "m"), ("rim_samples_40", "m"), ("rim_samples_41", "m"),
    ("rim_samples_42", "m"), ("rim_samples_43", "m"), ("rim_samples_44", "m"), ("rim_samples_45", "m"), ("rim_samples_46", "m"),
    ("rim_samples_47", "m"), ("rim_samples_48", "m"), ("rim_samples_49", "m"), ("rim_samples_50", "m"), ("rim_samples_51", "m"),
    ("rim_samples_52", "m"), ("rim_samples_53", "m"), ("rim_samples_54", "m"), ("rim_samples_55", "m"), ("rim_samples_56", "m"),
    ("rim_samples_57", "m"), ("rim_samples_58", "m"), ("rim_samples_59", "m"), ("rim_samples_60", "m"), ("rim_samples_61", "m"),
    ("rim_samples_62", "m"), ("rim_samples_63", "m"), ("rim_samples_64", "m"), ("rim_samples_65", "m"), ("rim_samples_66", "m"),
    ("rim_samples_67", "m"), ("rim_samples_68", "m"), ("rim_samples_69", "m"), ("rim_samples_70", "m"), ("rim_samples_71", "m"),
    ("rim_samples_72", "m"), ("rim_samples_73", "m"), ("rim_samples_74", "m"), ("rim_samples_75", "m"), ("rim_samples_76", "m"),
    ("rim_samples_77", "m"), ("rim_samples_78", "m"), ("rim_samples_79", "m"), ("rim_samples_80", "m"), ("rim_samples_81", "m"),
    ("rim_samples_82", "m"), ("cam_speed_squared", "1/s^2"), ("half_contact_stiffness", "N/m"), ("inverse_follower_mass", "1/kg"),
    ("half_follower_mass", "kg"), ("half_cam_speed_squared_times_cam_inertia", "J"), ("follower_mass_times_gravity", "N"),
)

OPERATIONS = (
    ("constants", 10), ("start", 9), ("scales", 8), ("coordinate_rates", 0), ("gaps", 19), ("gap_accelerations", 44),
    ("contact_roller", 32), ("applied", 5), ("accelerations", 2), ("ledger", 1), ("energy", 21), ("poses", 4), ("outputs", 7),
    ("period", 3), ("landmarks", 4),
)

RIM_CURVE = (
    (0.0, 6.283185307179586),
    True,
    False,
    1,
    1,
    (0.0, 0.15339604207782373, 0.30949007192105793, 0.468449256860779, 0.6303761667373775, 0.7952726525568261, 0.9629802682503042, 1.1331924018451662, 1.3053923642718566, 1.4788899761383716, 1.6528515497621414, 1.8263971401114654, 1.9986908915597823, 2.1690331866928325, 2.3368928711407357, 2.5019464063866628, 2.6640455552134354, 2.823174848854149, 2.9794256280909748, 3.13296264523738, 3.2839961630261985, 3.432760821900031, 3.579485202332103, 3.7244237979075474, 3.867814448644476, 4.009894353886889, 4.1508893952098305, 4.291029942582389, 4.430527342909746, 4.569599288175325, 4.708456505240288, 4.847307406019046, 4.986362501056309, 5.125830388021287, 5.265926209995298, 5.406870570581529, 5.548877814869743, 5.692192438809293, 5.83703105713427, 5.983656604281496, 6.132292865281223),
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


def _samples(curve, data, given):
    """Points of a curve at the parameters of its samples, first all x, then all y."""
    points = [curve(s, *ca.vertsplit(given))[:2] for s in data[-1]]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _drawn(curve, data, given):
    """Points of a curve for a picture, at equal steps of its parameter, first all x, then all y."""
    (start, end), copies = data[0], data[4]
    count = 180 if copies == 1 else 8
    points = [curve(start + (end - start)*k/count, *ca.vertsplit(given))[:2] for k in range(count + 1)]
    turns = [(ca.cos(2*ca.pi*k/copies), ca.sin(2*ca.pi*k/copies)) for k in range(copies)] if copies > 1 else [(1, 0)]
    points = [(c*x - s*y, s*x + c*y) for c, s in turns for x, y in points]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))


def _nearest(curve, data, samples, given, point):
    """Signed distance of a point from a curve, normal there, curvature of the parallel curve through the point, parameter.

    Newton's method from the nearest sample, and of a curve that is not convex from the nearest in another hollow. A function
    of its own, which is called; its derivatives are the results themselves.
    """
    if curve not in _NEAREST:
        (start, end), closed, hole, tries, _, at = data
        side = -1 if hole else 1
        widest = max(b - a for a, b in zip(at, (*at[1:], at[0] + end - start) if closed else at[1:], strict=False))
        s, at_point, values = ca.SX.sym("s"), ca.SX.sym("point", 2), ca.SX.sym("given", given.numel())

        def refine(count):  # of Newton's method, from a parameter
            found = s
            for k in range(count + 1):
                here = found - (end - start)*ca.floor((found - start)/(end - start)) if closed else found
                x, y, dx, dy, ddx, ddy = curve(here, *ca.vertsplit(values))
                px, py, square = at_point[0] - x, at_point[1] - y, dx**2 + dy**2
                slope = ca.fmax(square - px*ddx - py*ddy, square/1000)
                if k < count:
                    found = here + ca.fmin(ca.fmax((px*dx + py*dy)/slope, -widest), widest)
                    found = found if closed else ca.fmin(ca.fmax(found, start), end)
            speed = ca.sqrt(square)
            nx, ny = side*dy/speed, -side*dx/speed
            h, along = px*nx + py*ny, side*speed/slope
            curvature = side*(dx*ddy - dy*ddx)/(square*speed)
            bend = curvature/(1 + curvature*h)
            apart = ca.sqrt(ca.fmax(px**2 + py**2, 1e-300))
            if not closed:  # beyond an end the end is nearest
                way = px*dx + py*dy
                beyond = ca.logic_or(ca.logic_and(here <= start, way < 0), ca.logic_and(here >= end, way > 0))
                of_end = (px/apart, nx), (py/apart, ny), (apart, h), (1/apart, bend), (0, along)
                nx, ny, h, bend, along = (ca.if_else(beyond, a, b) for a, b in of_end)
            return ca.Function("refined", [s, at_point, values], [ca.vertcat(h, nx, ny, bend, here, along, apart)])

        refined, again = refine(6 if tries > 1 else 5), refine(1)
        at_point, values, table = ca.MX.sym("point", 2), ca.MX.sym("given", given.numel()), ca.MX.sym("samples", samples.numel())
        d = (table[: len(at)] - at_point[0])**2 + (table[len(at) :] - at_point[1])**2
        parameters, least = ca.MX(ca.DM(at)), ca.mmin(d)
        result = refined(parameters[ca.find(d <= least)], at_point, values)
        if tries > 1:
            before = ca.vertcat(d[-1] if closed else 1e300, d[:-1])
            after = ca.vertcat(d[1:], d[0] if closed else 1e300)
            hollow = ca.if_else(ca.logic_and(d <= before, d < after), ca.if_else(d > least, d, 1e300), 1e300)
            other = refined(parameters[ca.find(hollow <= ca.mmin(hollow))], at_point, values)
            result = ca.if_else(other[-1] < result[-1], other, result)

        def slope(_, o):
            t = ca.vertcat(-o[2], o[1])
            return ca.vertcat(o[1:3].T, o[3]*t@t.T, ca.SX(1, 2), o[5]*t.T)

        def shaped(_, values, point, o):
            return None, *(ca.jacobian(again(o[4], point, values)[:5], x) for x in (values, point))

        _NEAREST[curve] = _called("nearest", [table, values, at_point], result[:6], slope, shaped)
    return _NEAREST[curve](samples, given, point)


_NEAREST: "dict[object, ca.Function]" = {}


def rim_curve(s, lift, base, roller_radius):
    """Point of the curve rim at its parameter, and derivatives by it: x, y, x', y', x'', y''."""
    sin_s = ca.sin(s)
    minus_sin_s = -sin_s
    x3 = 1 + minus_sin_s
    x4 = x3*lift/2
    x5 = x4 + base
    cos_s = ca.cos(s)
    x7 = x5*cos_s
    x8 = x5*x5
    lift_squared = lift*lift
    cos_s_squared = cos_s*cos_s
    quarter_of_cos_s_squared_times_lift_squared = cos_s_squared*lift_squared/4
    x12 = quarter_of_cos_s_squared_times_lift_squared + x8
    x13 = 1/ca.sqrt(x12)
    minus_half_sin_s_times_cos_s_times_lift = -sin_s*cos_s*lift/2
    x15 = minus_half_sin_s_times_cos_s_times_lift + x7
    x16 = sin_s*x5
    half_cos_s_squared_times_lift = cos_s_squared*lift/2
    x18 = x16 + half_cos_s_squared_times_lift
    x19 = -sin_s*x5
    sin_s_squared = sin_s*sin_s
    half_sin_s_squared_times_lift = sin_s_squared*lift/2
    minus_cos_s_squared_times_lift = -cos_s_squared*lift
    x23 = 1/(x12*ca.sqrt(x12))
    x24 = x5*cos_s*lift/2
    quarter_of_sin_s_times_cos_s_times_lift_squared = sin_s*cos_s*lift_squared/4
    x26 = x24 + quarter_of_sin_s_times_cos_s_times_lift_squared
    sin_s_minus_one = sin_s - 1
    twice_base = 2*base
    x29 = -sin_s_minus_one*lift
    x30 = twice_base + x29
    x31 = x30*x30
    cos_s_squared_times_lift_squared = cos_s_squared*lift_squared
    x33 = x31 + cos_s_squared_times_lift_squared
    x34 = 1/ca.sqrt(x33)
    minus_twice_base = -2*base
    x36 = sin_s_minus_one*lift
    x37 = 1/(x33*ca.sqrt(x33))
    sin_s_times_lift = sin_s*lift
    x39 = twice_base + x29 + sin_s_times_lift
    x40 = sin_s*x30
    x41 = minus_twice_base + x36 + sin_s_times_lift
    x42 = 1/(x33*x33*ca.sqrt(x33))
    x43 = x39*x39
    cos_s_squared_times_lift = cos_s_squared*lift
    x45 = x40 + cos_s_squared_times_lift
    return x7 - x13*x15*roller_radius, x16 - x13*x18*roller_radius, x19 - cos_s_squared*lift/2 - x13*(x19 + half_sin_s_squared_times_lift + minus_cos_s_squared_times_lift)*roller_radius - x15*x23*x26*roller_radius, minus_half_sin_s_times_cos_s_times_lift + x7 - x13*(x7 - 3*sin_s*cos_s*lift/2)*roller_radius - x18*x23*x26*roller_radius, cos_s*(sin_s_minus_one*lift/2 + 3*sin_s*lift/2 + 2*x37*x39*(x40 + 2*cos_s_squared*lift - sin_s_squared*lift)*lift*roller_radius + 3*cos_s_squared*x41*x42*x43*lift_squared*roller_radius - base - x34*(minus_twice_base + x36 + 7*sin_s*lift)*roller_radius - sin_s*x37*x39*x41*lift*roller_radius), half_sin_s_squared_times_lift + minus_cos_s_squared_times_lift + x34*(x40 + 4*cos_s_squared*lift - 3*sin_s_squared*lift)*roller_radius + sin_s*x37*x39*x45*lift*roller_radius + 2*cos_s_squared*x37*x39*(minus_twice_base + x36 + 3*sin_s*lift)*lift*roller_radius - sin_s*x30/2 - 3*cos_s_squared*x42*x43*x45*lift_squared*roller_radius


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (17,): follower_mass, roller_radius, lift, base, gravity, cam_speed, spring_stiffness, contact_stiffness, contact_damping, k1,
            rim_samples, cam_speed_squared, half_contact_stiffness, inverse_follower_mass, half_follower_mass,
            half_cam_speed_squared_times_cam_inertia, follower_mass_times_gravity
    """
    cam_inertia, follower_mass, roller_radius, lift, base, gravity, cam_speed = p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    spring_stiffness, preload, contact_stiffness, contact_damping = p[8], p[9], p[10], p[11]
    k1 = preload/spring_stiffness - base
    rim_samples = _samples(rim_curve, RIM_CURVE, ca.vertcat(lift, base, roller_radius))
    cam_speed_squared = cam_speed*cam_speed
    half_contact_stiffness = contact_stiffness/2
    inverse_follower_mass = 1/follower_mass
    half_follower_mass = follower_mass/2
    half_cam_speed_squared_times_cam_inertia = cam_speed_squared*cam_inertia/2
    follower_mass_times_gravity = follower_mass*gravity
    return ca.vertcat(follower_mass, roller_radius, lift, base, gravity, cam_speed, spring_stiffness, contact_stiffness, contact_damping,
        k1, rim_samples, cam_speed_squared, half_contact_stiffness, inverse_follower_mass, half_follower_mass,
        half_cam_speed_squared_times_cam_inertia, follower_mass_times_gravity)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (1,): COORDINATES
        u (1,): SPEEDS
    """
    follower_mass, lift, base, gravity, cam_speed, preload, contact_stiffness = p[2], p[4], p[5], p[6], p[7], p[9], p[10]
    return ca.vertcat(base - (follower_mass*gravity + cam_speed*cam_speed*follower_mass*lift/2 + preload)/contact_stiffness), ca.vertcat(0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (1,): COORDINATES
        su (1,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    cam_mass, follower_mass, lift, cam_speed = p[0], p[2], p[4], p[7]
    total_mass = cam_mass + follower_mass
    energy_scale = total_mass*cam_speed*cam_speed*lift*lift/2
    force_scale = energy_scale/lift
    cam_speed_times_lift = cam_speed*lift
    return (ca.vertcat(lift), ca.vertcat(cam_speed_times_lift), ca.vertcat(energy_scale, energy_scale),
        ca.vertcat(lift, cam_speed_times_lift, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (1,): COORDINATES [m/s]
    """
    guide_speed = u[0]
    return ca.vertcat(guide_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): PAIRS [m]
        dG (1,): PAIRS [m/s]
    """
    roller_radius, lift, base, cam_speed, rim_samples = c[1], c[2], c[3], c[5], c[10:92]
    guide_travel = q[0]
    guide_speed = u[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    roller_local_x = guide_travel*sin_cam
    roller_local_y = cos_cam*guide_travel
    roller_nearest = _nearest(rim_curve, RIM_CURVE, rim_samples, ca.vertcat(lift, base, roller_radius), ca.vertcat(roller_local_x, roller_local_y))
    roller_distance = roller_nearest[0]
    roller_normal_x = roller_nearest[1]
    roller_normal_y = roller_nearest[2]
    sin_cam_rate = cos_cam*cam_speed
    roller_local_x_rate = guide_speed*sin_cam + guide_travel*sin_cam_rate
    cos_cam_rate = -sin_cam*cam_speed
    roller_local_y_rate = cos_cam*guide_speed + cos_cam_rate*guide_travel
    roller_distance_rate = roller_local_x_rate*roller_normal_x + roller_local_y_rate*roller_normal_y
    roller_gap = roller_distance - roller_radius
    return ca.vertcat(roller_gap), ca.vertcat(roller_distance_rate)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): PAIRS [m/s^2]
    """
    roller_radius, lift, base, cam_speed, rim_samples, cam_speed_squared = c[1], c[2], c[3], c[5], c[10:92], c[92]
    guide_travel = q[0]
    guide_speed = u[0]
    guide_acceleration = a[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    roller_local_x = guide_travel*sin_cam
    roller_local_y = cos_cam*guide_travel
    roller_nearest = _nearest(rim_curve, RIM_CURVE, rim_samples, ca.vertcat(lift, base, roller_radius), ca.vertcat(roller_local_x, roller_local_y))
    roller_normal_x = roller_nearest[1]
    roller_normal_y = roller_nearest[2]
    roller_bend = roller_nearest[3]
    sin_cam_rate = cos_cam*cam_speed
    roller_local_x_rate = guide_speed*sin_cam + guide_travel*sin_cam_rate
    cos_cam_rate = -sin_cam*cam_speed
    roller_local_y_rate = cos_cam*guide_speed + cos_cam_rate*guide_travel
    roller_along_curve = roller_local_y_rate*roller_normal_x - roller_local_x_rate*roller_normal_y
    roller_turning = roller_along_curve*roller_bend
    sin_cam_rate_rate = -cam_speed_squared*sin_cam
    roller_local_x_rate_rate = guide_acceleration*sin_cam + guide_travel*sin_cam_rate_rate + 2*guide_speed*sin_cam_rate
    cos_cam_rate_rate = -cos_cam*cam_speed_squared
    roller_local_y_rate_rate = cos_cam*guide_acceleration + cos_cam_rate_rate*guide_travel + 2*cos_cam_rate*guide_speed
    roller_distance_rate_rate = roller_local_x_rate_rate*roller_normal_x + roller_local_y_rate_rate*roller_normal_y + roller_local_y_rate*roller_normal_x*roller_turning - roller_local_x_rate*roller_normal_y*roller_turning
    return ca.vertcat(roller_distance_rate_rate)


def contact_roller(t, q, u, z, m, c):
    """Forces of roller: power x power_damping. The normal force is the laws' own, not clamped: where it would pull, the contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): guide [N], shaft [N m]
        dz (2,): MEMORY [W]
        normal_force (1,): PAIRS [N]
        sliding_velocity (0,): empty
        in_range (1,): PAIRS [1]
    """
    roller_radius, lift, base, cam_speed, contact_stiffness, contact_damping, rim_samples = c[1], c[2], c[3], c[5], c[7], c[8], c[10:92]
    guide_travel = q[0]
    guide_speed = u[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    roller_local_x = guide_travel*sin_cam
    roller_local_y = cos_cam*guide_travel
    roller_nearest = _nearest(rim_curve, RIM_CURVE, rim_samples, ca.vertcat(lift, base, roller_radius), ca.vertcat(roller_local_x, roller_local_y))
    roller_distance = roller_nearest[0]
    roller_normal_x = roller_nearest[1]
    roller_normal_y = roller_nearest[2]
    roller_gap = roller_distance - roller_radius
    roller_elastic_force = ca.if_else(-roller_gap > 0, -roller_gap*contact_stiffness, 0)
    roller_normal_x_2 = cos_cam*roller_normal_x - roller_normal_y*sin_cam
    roller_normal_y_2 = cos_cam*roller_normal_y + roller_normal_x*sin_cam
    roller_relative_rate_x = guide_travel*cam_speed
    roller_penetration_rate = -guide_speed*roller_normal_y_2 - roller_normal_x_2*roller_relative_rate_x
    roller_resistance = ca.if_else(-roller_gap > 0, roller_penetration_rate*contact_damping, 0)
    roller_normal_force = roller_elastic_force + roller_resistance
    roller_normal_power = roller_penetration_rate*roller_resistance
    roller_push_x = roller_normal_force*roller_normal_x_2
    roller_push_y = roller_normal_force*roller_normal_y_2
    roller_push_on_shaft = guide_travel*roller_push_x
    return (ca.vertcat(roller_push_y, roller_push_on_shaft), ca.vertcat(0, roller_normal_power), ca.vertcat(roller_normal_force),
            ca.vertcat(),
        ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (2,): guide [N], shaft [N m]
    """
    follower_mass, gravity, spring_stiffness, k1 = c[0], c[4], c[6], c[9]
    guide_travel = q[0]
    spring_stretch = guide_travel + k1
    spring_force = -spring_stretch*spring_stiffness
    return ca.vertcat(spring_force - follower_mass*gravity, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (1,): guide.acceleration [m/s^2]
        reactions (1,): shaft.reaction [N m]
    """
    inverse_follower_mass = c[94]
    guide_force, shaft_force = f[0], f[1]
    guide_acc = guide_force*inverse_follower_mass
    return ca.vertcat(guide_acc), ca.vertcat(-shaft_force)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    cam_speed = c[5]
    shaft_reaction_in = reactions[0]
    return ca.vertcat(shaft_reaction_in*cam_speed, 0)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (1,): PAIRS [J]
    """
    roller_radius, lift, base, cam_speed, spring_stiffness, k1, rim_samples = c[1], c[2], c[3], c[5], c[6], c[9], c[10:92]
    half_contact_stiffness, half_follower_mass, half_cam_speed_squared_times_cam_inertia = c[93], c[95], c[96]
    follower_mass_times_gravity = c[97]
    guide_travel = q[0]
    guide_speed = u[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    spring_stretch = guide_travel + k1
    roller_local_x = guide_travel*sin_cam
    roller_local_y = cos_cam*guide_travel
    roller_nearest = _nearest(rim_curve, RIM_CURVE, rim_samples, ca.vertcat(lift, base, roller_radius), ca.vertcat(roller_local_x, roller_local_y))
    roller_distance = roller_nearest[0]
    roller_gap = roller_distance - roller_radius
    roller_stored_energy = ca.if_else(-roller_gap > 0, half_contact_stiffness*roller_gap*roller_gap, 0)
    kinetic = half_cam_speed_squared_times_cam_inertia + half_follower_mass*guide_speed*guide_speed
    potential = guide_travel*follower_mass_times_gravity
    return ca.vertcat(kinetic), ca.vertcat(potential + spring_stretch*spring_stretch*spring_stiffness/2), ca.vertcat(roller_stored_energy)


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (6,): cam.x [m], cam.y [m], cam.z [m], follower.x [m], follower.y [m], follower.z [m]
        rotations (18,): cam.R_xx [1], cam.R_xy [1], cam.R_xz [1], cam.R_yx [1], cam.R_yy [1], cam.R_yz [1], cam.R_zx [1], cam.R_zy [1],
            cam.R_zz [1], follower.R_xx [1], follower.R_xy [1], follower.R_xz [1], follower.R_yx [1], follower.R_yy [1], follower.R_yz [1],
            follower.R_zx [1], follower.R_zy [1], follower.R_zz [1]
    """
    cam_speed = c[5]
    guide_travel = q[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    return (ca.vertcat(0, 0, 0, 0, guide_travel, 0), ca.vertcat(cos_cam, -sin_cam, 0, sin_cam, cos_cam, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0,
            1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (2,): OUTPUTS
    """
    roller_radius, lift, base, cam_speed, rim_samples = c[1], c[2], c[3], c[5], c[10:92]
    guide_travel = q[0]
    cam_angle = t*cam_speed
    cos_cam = ca.cos(cam_angle)
    sin_cam = ca.sin(cam_angle)
    roller_local_x = guide_travel*sin_cam
    roller_local_y = cos_cam*guide_travel
    roller_nearest = _nearest(rim_curve, RIM_CURVE, rim_samples, ca.vertcat(lift, base, roller_radius), ca.vertcat(roller_local_x, roller_local_y))
    roller_distance = roller_nearest[0]
    roller_parameter = roller_nearest[4]
    roller_gap = roller_distance - roller_radius
    return ca.vertcat(roller_gap, roller_parameter)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    cam_speed = p[7]
    return ca.vertcat(2*3.141592653589793/ca.fabs(cam_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        shaft.parent, shaft.child, guide.parent, guide.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        roller.circle (4,): x [m], y [m], z [m], radius [m]
        roller.fixed (10,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1], across_x [1], across_y [1], across_z [1], outline
        gravity.direction, motor.child, spring.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        spring.child, cam.centre, follower.centre (3,): x [m], y [m], z [m]
        follower.shape_1 (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], length [m]
    """
    roller_radius, lift, base = p[3], p[4], p[5]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(0, 0, 0, roller_radius),
        ca.vertcat(0, 0, 0, 1, 0, 0, 0, 1, 0, _drawn(rim_curve, RIM_CURVE, ca.vertcat(lift, base, roller_radius))),
        ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(0, 0, 0), ca.vertcat(0, 5*roller_radius/2, 0, 0, 1, 0, 5*roller_radius))
