"""andrews_squeezer: seven bodies in three loops, a solver benchmark. Generated from derive/scenes/andrews_squeezer.py.

Do not edit; regenerate with `hertzwerk derive andrews_squeezer`.
Effects:
    motor: force on beta = mom
    spring: linear spring between K3 and ground
    energy_ledger: work put in, energy dissipated per effect
Units: 422 assignments and 373 outputs checked, all consistent
Operations: flight 1014 (equations of motion and gaps)
"""

import casadi as ca

NAME = "andrews_squeezer"
SOURCE = "derive/scenes/andrews_squeezer.py"
SUMMARY = "seven bodies in three loops, a solver benchmark"
FORMAT = "hertzwerk module 1"
DIGEST = "50f65d7340519f6e8c3314d6cc6c7bce"

EFFECTS = (
    ("motor", "force", "force on beta = mom"), ("spring", "spring", "linear spring between K3 and ground"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("m1", "kg", 0.04325, "body K1, mass"),
    ("i1", "kg m^2", 2.194e-06, "body K1, inertia"),
    ("ra", "m", 0.00092, "body K1, mass centre"),
    ("m2", "kg", 0.00365, "body K2, mass"),
    ("i2", "kg m^2", 4.41e-07, "body K2, inertia"),
    ("da", "m", 0.0115, ""),
    ("m3", "kg", 0.02373, "body K3, mass"),
    ("i3", "kg m^2", 5.255e-06, "body K3, inertia"),
    ("sb", "m", 0.01043, "body K3, mass centre"),
    ("sa", "m", 0.01874, ""),
    ("m5", "kg", 0.0705, "body K5, mass"),
    ("i5", "kg m^2", 1.169e-05, "body K5, inertia"),
    ("ta", "m", 0.02308, "body K5, mass centre"),
    ("tb", "m", 0.00916, "body K5, mass centre"),
    ("m4", "kg", 0.00706, "body K4, mass"),
    ("i4", "kg m^2", 5.667e-07, "body K4, inertia"),
    ("e", "m", 0.02, "length of K4"),
    ("ea", "m", 0.01421, ""),
    ("m7", "kg", 0.05498, "body K7, mass"),
    ("i7", "kg m^2", 1.912e-05, "body K7, inertia"),
    ("ua", "m", 0.01228, "body K7, mass centre"),
    ("ub", "m", 0.00449, ""),
    ("m6", "kg", 0.00706, "body K6, mass"),
    ("i6", "kg m^2", 5.667e-07, "body K6, inertia"),
    ("fa", "m", 0.01421, ""),
    ("zf", "m", 0.02, "length of K6"),
    ("rr", "m", 0.007, "length of K1"),
    ("xb", "m", -0.03635, "point of ground"),
    ("yb", "m", 0.03273, "point of ground"),
    ("xa", "m", -0.06934, "point of ground"),
    ("ya", "m", -0.00227, "point of ground"),
    ("zt", "m", 0.04, "length of K5"),
    ("u", "m", 0.04, "length of K7"),
    ("d", "m", 0.028, "length of K2"),
    ("ss", "m", 0.035, "length of K3"),
    ("mom", "N m", 0.033, "torque of the motor"),
    ("sd", "m", 0.02, "point of K3"),
    ("sc", "m", 0.018, ""),
    ("xc", "m", 0.014, "point of ground"),
    ("yc", "m", 0.072, "point of ground"),
    ("c0", "N/m", 4530, "effect spring, stiffness"),
    ("l0", "m", 0.07785, "effect spring, rest length"),
    ("beta_0", "rad", -0.06171389001427645, "start, position of beta"),
    ("Theta_near", "rad", 0.0, "start, position near of Theta"),
    ("gamma_near", "rad", 0.45, "start, position near of gamma"),
    ("delta_near", "rad", 0.49, "start, position near of delta"),
    ("Phi_near", "rad", 0.22, "start, position near of Phi"),
    ("epsilon_near", "rad", 1.23, "start, position near of epsilon"),
    ("Omega_near", "rad", -0.22, "start, position near of Omega"),
    ("speed_scale", "m/s", 7, "scales, speed"),
)

LIMITS = (
    ("m1", "defined", 0, None, True, False, "body K1, mass"),
    ("i1", "defined", 0, None, False, False, "body K1, inertia"),
    ("m2", "defined", 0, None, True, False, "body K2, mass"),
    ("i2", "defined", 0, None, False, False, "body K2, inertia"),
    ("m3", "defined", 0, None, True, False, "body K3, mass"),
    ("i3", "defined", 0, None, False, False, "body K3, inertia"),
    ("m5", "defined", 0, None, True, False, "body K5, mass"),
    ("i5", "defined", 0, None, False, False, "body K5, inertia"),
    ("m4", "defined", 0, None, True, False, "body K4, mass"),
    ("i4", "defined", 0, None, False, False, "body K4, inertia"),
    ("m7", "defined", 0, None, True, False, "body K7, mass"),
    ("i7", "defined", 0, None, False, False, "body K7, inertia"),
    ("m6", "defined", 0, None, True, False, "body K6, mass"),
    ("i6", "defined", 0, None, False, False, "body K6, inertia"),
    ("c0", "defined", 0, None, False, False, "effect spring, stiffness"),
    ("l0", "defined", 0, None, True, False, "effect spring, rest length"),
    ("rr", "defined", 0, None, True, False, "scales, length"),
    ("speed_scale", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (
    ("beta.angle", "rad"), ("Theta.angle", "rad"), ("gamma.angle", "rad"), ("delta.angle", "rad"), ("Phi.angle", "rad"),
    ("epsilon.angle", "rad"), ("Omega.angle", "rad"),
)

SPEEDS = (
    ("beta.speed", "rad/s"), ("Theta.speed", "rad/s"), ("gamma.speed", "rad/s"), ("delta.speed", "rad/s"), ("Phi.speed", "rad/s"),
    ("epsilon.speed", "rad/s"), ("Omega.speed", "rad/s"),
)

MEMORY = (("motor.input", "J"),)

CONSTRAINTS = (
    ("knee_3.apart_x", "m"), ("knee_3.apart_y", "m"), ("knee_4.apart_x", "m"), ("knee_4.apart_y", "m"), ("knee_6.apart_x", "m"),
    ("knee_6.apart_y", "m"),
)

GIVEN = ("beta.angle",)

BODIES = ("K1", "K2", "K3", "K5", "K4", "K7", "K6")

LANDMARKS = (
    ("beta", "revolute", "parent", "ground", ("axis",)), ("beta", "revolute", "child", "K1", ("axis",)),
    ("Theta", "revolute", "parent", "K1", ("axis",)), ("Theta", "revolute", "child", "K2", ("axis",)),
    ("gamma", "revolute", "parent", "ground", ("axis",)), ("gamma", "revolute", "child", "K3", ("axis",)),
    ("delta", "revolute", "parent", "ground", ("axis",)), ("delta", "revolute", "child", "K5", ("axis",)),
    ("Phi", "revolute", "parent", "K5", ("axis",)), ("Phi", "revolute", "child", "K4", ("axis",)),
    ("epsilon", "revolute", "parent", "ground", ("axis",)), ("epsilon", "revolute", "child", "K7", ("axis",)),
    ("Omega", "revolute", "parent", "K7", ("axis",)), ("Omega", "revolute", "child", "K6", ("axis",)),
    ("knee_3", "revolute", "parent", "K2", ("axis",)), ("knee_3", "revolute", "child", "K3", ("axis",)),
    ("knee_4", "revolute", "parent", "K2", ("axis",)), ("knee_4", "revolute", "child", "K4", ("axis",)),
    ("knee_6", "revolute", "parent", "K2", ("axis",)), ("knee_6", "revolute", "child", "K6", ("axis",)),
    ("motor", "turn_force", "child", "K1", ("axis",)), ("spring", "spring", "first", "K3", ()),
    ("spring", "spring", "second", "ground", ()), ("K1", "body", "centre", "K1", ()), ("K2", "body", "centre", "K2", ()),
    ("K3", "body", "centre", "K3", ()), ("K5", "body", "centre", "K5", ()), ("K4", "body", "centre", "K4", ()),
    ("K7", "body", "centre", "K7", ()), ("K6", "body", "centre", "K6", ()),
)

CONSTANTS = (
    ("e", "m"), ("zf", "m"), ("rr", "m"), ("xb", "m"), ("yb", "m"), ("xa", "m"), ("ya", "m"), ("zt", "m"), ("u", "m"), ("d", "m"),
    ("ss", "m"), ("mom", "J"), ("sd", "m"), ("sc", "m"), ("c0", "N/m"), ("l0", "m"), ("xc_minus_xb", "m"), ("yc_minus_yb", "m"),
    ("l0_squared", "m^2"), ("K2_h_x", "kg m"), ("K4_h_y", "kg m"), ("K6_h_x", "kg m"), ("K2_I_z_z", "kg m^2"),
    ("K1_I_z_z_plus_K2_I_z_z", "kg m^2"), ("K4_I_z_z", "kg m^2"), ("K4_I_z_z_plus_K5_I_z_z", "kg m^2"), ("K6_I_z_z", "kg m^2"),
    ("K6_I_z_z_plus_K7_I_z_z", "kg m^2"), ("inverse_K6_I_z_z", "1/(kg m^2)"), ("inverse_K4_I_z_z", "1/(kg m^2)"),
    ("inverse_K2_I_z_z", "1/(kg m^2)"), ("inverse_K3_I_z_z", "1/(kg m^2)"), ("half_K1_I_z_z_2", "kg m^2"), ("half_K2_I_z_z", "kg m^2"),
    ("half_K3_I_z_z", "kg m^2"), ("half_K4_I_z_z", "kg m^2"), ("half_K5_I_z_z_2", "kg m^2"), ("half_K6_I_z_z", "kg m^2"),
    ("half_K7_I_z_z_2", "kg m^2"), ("half_m2", "kg"), ("half_m4", "kg"), ("half_m6", "kg"), ("knee_3_apart_x_softness", "1"),
    ("knee_3_apart_y_softness", "1"), ("knee_4_apart_x_softness", "1"), ("knee_4_apart_y_softness", "1"), ("knee_6_apart_x_softness", "1"),
    ("knee_6_apart_y_softness", "1"),
)

OPERATIONS = (
    ("constants", 65), ("start", 0), ("scales", 11), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 24),
    ("accelerations", 990), ("constraints", 98), ("projection", 632), ("ledger", 1), ("energy", 112), ("poses", 35), ("outputs", 0),
    ("landmarks", 12),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = PAIRS = EVENTS = LOADS = FED = ()
RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def revolute_apart(cos, sin, first_arm_x, first_arm_y, first_arm_rate_x, first_arm_rate_y, parent_arm_x, parent_arm_y, parent_arm_rate_x,
        parent_arm_rate_y, second_arm_y, child_arm_y, first_speed, second_speed, e, xa, ya, zt):
    """Return apart_x [m], apart_y [m], apart_rate_x [m/s], apart_rate_y [m/s]."""
    second_arm_x = zt*cos
    second_arm_rate_x = -second_arm_y*first_speed
    second_arm_rate_y = first_speed*second_arm_x
    rate_z = second_speed + first_speed
    x = xa + second_arm_x
    y = ya + second_arm_y
    child_arm_x = e*sin
    child_arm_rate_x = -rate_z*child_arm_y
    child_arm_rate_y = rate_z*child_arm_x
    apart_x = x + child_arm_x - first_arm_x - parent_arm_x
    apart_y = y + child_arm_y - first_arm_y - parent_arm_y
    apart_rate_x = second_arm_rate_x + child_arm_rate_x - first_arm_rate_x - parent_arm_rate_x
    apart_rate_y = second_arm_rate_y + child_arm_rate_y - first_arm_rate_y - parent_arm_rate_y
    return apart_x, apart_y, apart_rate_x, apart_rate_y


def revolute_apart_apart(W_apart_x_apart_x, y, W_apart_x_raised):
    """Return apart_x_apart_x [1], apart_y_apart [1]."""
    apart_x_apart_x = W_apart_x_apart_x/W_apart_x_raised
    apart_y_apart = y/W_apart_x_raised
    return apart_x_apart_x, apart_y_apart


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (48,): e, zf, rr, xb, yb, xa, ya, zt, u, d, ss, mom, sd, sc, c0, l0, xc_minus_xb, yc_minus_yb, l0_squared, K2_h_x, K4_h_y, K6_h_x,
            K2_I_z_z, K1_I_z_z_plus_K2_I_z_z, K4_I_z_z, K4_I_z_z_plus_K5_I_z_z, K6_I_z_z, K6_I_z_z_plus_K7_I_z_z, inverse_K6_I_z_z,
            inverse_K4_I_z_z, inverse_K2_I_z_z, inverse_K3_I_z_z, half_K1_I_z_z_2, half_K2_I_z_z, half_K3_I_z_z, half_K4_I_z_z,
            half_K5_I_z_z_2, half_K6_I_z_z, half_K7_I_z_z_2, half_m2, half_m4, half_m6, knee_3_apart_x_softness, knee_3_apart_y_softness,
            knee_4_apart_x_softness, knee_4_apart_y_softness, knee_6_apart_x_softness, knee_6_apart_y_softness
    """
    m1, i1, ra, m2, i2, da, m3, i3, sb, sa, m5, i5, ta = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12]
    tb, m4, i4, e, ea, m7, i7, ua, ub, m6, i6, fa = p[13], p[14], p[15], p[16], p[17], p[18], p[19], p[20], p[21], p[22], p[23], p[24]
    zf, rr, xb, yb, xa, ya, zt, u, d, ss, mom, sd = p[25], p[26], p[27], p[28], p[29], p[30], p[31], p[32], p[33], p[34], p[35], p[36]
    sc, xc, yc, c0, l0 = p[37], p[38], p[39], p[40], p[41]
    xc_minus_xb = xc - xb
    yc_minus_yb = yc - yb
    l0_squared = l0*l0
    K2_h_x = -da*m2
    ea_minus_e = ea - e
    K4_h_y = ea_minus_e*m4
    zf_minus_fa = zf - fa
    K6_h_x = zf_minus_fa*m6
    ra_squared = ra*ra
    ra_squared_times_m1 = ra_squared*m1
    K1_I_z_z = ra_squared_times_m1 + rr*rr*m2 + i1
    K2_I_z_z = da*da*m2 + i2
    K1_I_z_z_plus_K2_I_z_z = K1_I_z_z + K2_I_z_z
    K3_I_z_z = (sa*sa + sb*sb)*m3 + i3
    ta_squared = ta*ta
    tb_squared = tb*tb
    ta_squared_plus_tb_squared = ta_squared + tb_squared
    x8 = ta_squared_plus_tb_squared*m5
    K5_I_z_z = x8 + zt*zt*m4 + i5
    K4_I_z_z = ea_minus_e*ea_minus_e*m4 + i4
    K4_I_z_z_plus_K5_I_z_z = K4_I_z_z + K5_I_z_z
    ua_squared = ua*ua
    ub_squared = ub*ub
    ub_squared_plus_ua_squared = ub_squared + ua_squared
    x12 = ub_squared_plus_ua_squared*m7
    K7_I_z_z = x12 + u*u*m6 + i7
    K6_I_z_z = zf_minus_fa*zf_minus_fa*m6 + i6
    K6_I_z_z_plus_K7_I_z_z = K6_I_z_z + K7_I_z_z
    inverse_K6_I_z_z = 1/K6_I_z_z
    inverse_K4_I_z_z = 1/K4_I_z_z
    inverse_K2_I_z_z = 1/K2_I_z_z
    inverse_K3_I_z_z = 1/K3_I_z_z
    K1_I_z_z_2 = ra_squared_times_m1 + i1
    K5_I_z_z_2 = x8 + i5
    K7_I_z_z_2 = x12 + i7
    half_K1_I_z_z_2 = K1_I_z_z_2/2
    half_K2_I_z_z = K2_I_z_z/2
    half_K3_I_z_z = K3_I_z_z/2
    half_K4_I_z_z = K4_I_z_z/2
    half_K5_I_z_z_2 = K5_I_z_z_2/2
    half_K6_I_z_z = K6_I_z_z/2
    half_K7_I_z_z_2 = K7_I_z_z_2/2
    half_m2 = m2/2
    half_m4 = m4/2
    half_m6 = m6/2
    return ca.vertcat(e, zf, rr, xb, yb, xa, ya, zt, u, d, ss, mom, sd, sc, c0, l0, xc_minus_xb, yc_minus_yb, l0_squared, K2_h_x, K4_h_y,
        K6_h_x, K2_I_z_z, K1_I_z_z_plus_K2_I_z_z, K4_I_z_z, K4_I_z_z_plus_K5_I_z_z, K6_I_z_z, K6_I_z_z_plus_K7_I_z_z, inverse_K6_I_z_z,
        inverse_K4_I_z_z, inverse_K2_I_z_z, inverse_K3_I_z_z, half_K1_I_z_z_2, half_K2_I_z_z, half_K3_I_z_z, half_K4_I_z_z, half_K5_I_z_z_2,
        half_K6_I_z_z, half_K7_I_z_z_2, half_m2, half_m4, half_m6, *[3e-09]*6)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (7,): COORDINATES
        u (7,): SPEEDS
    """
    beta_0, Theta_near, gamma_near, delta_near, Phi_near, epsilon_near, Omega_near = p[42], p[43], p[44], p[45], p[46], p[47], p[48]
    return ca.vertcat(beta_0, Theta_near, gamma_near, delta_near, Phi_near, epsilon_near, Omega_near), ca.vertcat(*[0]*7)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (7,): COORDINATES
        su (7,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    m1, m2, m3, m5, m4, m7, m6, rr, speed_scale = p[0], p[3], p[6], p[10], p[14], p[18], p[22], p[26], p[49]
    total_mass = m1 + m2 + m3 + m4 + m5 + m6 + m7
    energy_scale = total_mass*speed_scale*speed_scale/2
    force_scale = energy_scale/rr
    speed_scale_over_rr = speed_scale/rr
    return (ca.vertcat(*[1]*7), ca.vertcat(*[speed_scale_over_rr]*7), ca.vertcat(energy_scale),
        ca.vertcat(rr, speed_scale, force_scale, energy_scale))


def coordinate_rates(t, q, speeds, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (7,): COORDINATES [rad/s]
    """
    beta_speed, Theta_speed, gamma_speed, delta_speed, Phi_speed = speeds[0], speeds[1], speeds[2], speeds[3], speeds[4]
    epsilon_speed, Omega_speed = speeds[5], speeds[6]
    return ca.vertcat(beta_speed, Theta_speed, gamma_speed, delta_speed, Phi_speed, epsilon_speed, Omega_speed)


def gaps(t, q, speeds, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G, dG (0,): empty
    """
    return ca.vertcat(), ca.vertcat()


def gap_accelerations(t, q, speeds, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (0,): empty
    """
    return ca.vertcat()


def applied(t, q, speeds, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (7,): beta [N m], Theta [N m], gamma [N m], delta [N m], Phi [N m], epsilon [N m], Omega [N m]
    """
    mom, sd, sc, c0, l0, xc_minus_xb, yc_minus_yb, l0_squared = c[11], c[12], c[13], c[14], c[15], c[16], c[17], c[18]
    gamma_angle = q[2]
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    spring_first_arm_x = cos_K3*sd + sin_K3*sc
    spring_first_arm_y = sin_K3*sd - cos_K3*sc
    spring_between_x = xc_minus_xb - spring_first_arm_x
    spring_between_y = yc_minus_yb - spring_first_arm_y
    spring_squared = spring_between_x*spring_between_x + spring_between_y*spring_between_y
    base = ca.if_else(spring_squared > 0, spring_squared, l0_squared)
    spring_length = ca.sqrt(base)
    spring_per_length = (1 - l0/spring_length)*c0
    spring_force_x = spring_between_x*spring_per_length
    spring_force_y = spring_between_y*spring_per_length
    spring_on_gamma = spring_first_arm_x*spring_force_y - spring_first_arm_y*spring_force_x
    return ca.vertcat(mom, 0, spring_on_gamma, 0, 0, 0, 0)


def accelerations(t, q, speeds, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (7,): beta.acceleration [rad/s^2], Theta.acceleration [rad/s^2], gamma.acceleration [rad/s^2], delta.acceleration [rad/s^2],
            Phi.acceleration [rad/s^2], epsilon.acceleration [rad/s^2], Omega.acceleration [rad/s^2]
        reactions (0,): empty
        multipliers (6,): CONSTRAINTS [N]
    """
    e, zf, rr, xb, yb, xa, ya, zt, u, d, ss, K2_h_x = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[19]
    K4_h_y, K6_h_x, K2_I_z_z, K1_I_z_z_plus_K2_I_z_z, K4_I_z_z, K4_I_z_z_plus_K5_I_z_z = c[20], c[21], c[22], c[23], c[24], c[25]
    K6_I_z_z, K6_I_z_z_plus_K7_I_z_z, inverse_K6_I_z_z, inverse_K4_I_z_z, inverse_K2_I_z_z = c[26], c[27], c[28], c[29], c[30]
    inverse_K3_I_z_z, knee_3_apart_x_softness, knee_3_apart_y_softness, knee_4_apart_x_softness = c[31], c[42], c[43], c[44]
    knee_4_apart_y_softness, knee_6_apart_x_softness, knee_6_apart_y_softness = c[45], c[46], c[47]
    beta_angle, Theta_angle, gamma_angle, delta_angle, Phi_angle, epsilon_angle, Omega_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    beta_speed, Theta_speed, gamma_speed, delta_speed, Phi_speed = speeds[0], speeds[1], speeds[2], speeds[3], speeds[4]
    epsilon_speed, Omega_speed = speeds[5], speeds[6]
    beta_force, Theta_force, gamma_force, delta_force, Phi_force, epsilon_force, Omega_force = f[0], f[1], f[2], f[3], f[4], f[5], f[6]
    cos_K1 = ca.cos(beta_angle)
    sin_K1 = ca.sin(beta_angle)
    K2_angle = Theta_angle + beta_angle
    cos_K2 = ca.cos(K2_angle)
    sin_K2 = ca.sin(K2_angle)
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    cos_K5 = ca.cos(delta_angle)
    sin_K5 = ca.sin(delta_angle)
    K4_angle = Phi_angle + delta_angle
    cos_K4 = ca.cos(K4_angle)
    sin_K4 = ca.sin(K4_angle)
    cos_K7 = ca.cos(epsilon_angle)
    sin_K7 = ca.sin(epsilon_angle)
    K6_angle = Omega_angle + epsilon_angle
    cos_K6 = ca.cos(K6_angle)
    sin_K6 = ca.sin(K6_angle)
    K2_arm_x = cos_K1*rr
    K2_arm_y = sin_K1*rr
    K2_arm_rate_x = -K2_arm_y*beta_speed
    K2_arm_rate_y = K2_arm_x*beta_speed
    K2_rate_z = Theta_speed + beta_speed
    K2_bias_x = -K2_arm_rate_y*beta_speed
    K2_bias_y = K2_arm_rate_x*beta_speed
    knee_3_child_arm_x = sin_K3*ss
    knee_3_child_arm_y = -cos_K3*ss
    knee_3_child_arm_rate_x = -gamma_speed*knee_3_child_arm_y
    knee_3_child_arm_rate_y = gamma_speed*knee_3_child_arm_x
    knee_3_parent_arm_x = -cos_K2*d
    knee_3_parent_arm_y = -sin_K2*d
    knee_3_parent_arm_rate_x = -K2_rate_z*knee_3_parent_arm_y
    knee_3_parent_arm_rate_y = K2_rate_z*knee_3_parent_arm_x
    K2_rate_z_times_knee_3_parent_arm_rate_y = K2_rate_z*knee_3_parent_arm_rate_y
    knee_3_apart_bias_x = K2_rate_z_times_knee_3_parent_arm_rate_y - K2_bias_x - gamma_speed*knee_3_child_arm_rate_y
    minus_K2_rate_z_times_knee_3_parent_arm_rate_x = -K2_rate_z*knee_3_parent_arm_rate_x
    knee_3_apart_bias_y = minus_K2_rate_z_times_knee_3_parent_arm_rate_x + gamma_speed*knee_3_child_arm_rate_x - K2_bias_y
    knee_3_x_on_beta = knee_3_child_arm_y + yb
    knee_3_x_on_Theta = knee_3_child_arm_y + yb - K2_arm_y
    knee_3_y_on_beta = -knee_3_child_arm_x - xb
    knee_3_y_on_Theta = K2_arm_x - knee_3_child_arm_x - xb
    K4_arm_x = cos_K5*zt
    K4_arm_y = sin_K5*zt
    K4_arm_rate_x = -K4_arm_y*delta_speed
    K4_arm_rate_y = K4_arm_x*delta_speed
    K4_rate_z = Phi_speed + delta_speed
    K4_x = K4_arm_x + xa
    K4_y = K4_arm_y + ya
    K4_bias_x = -K4_arm_rate_y*delta_speed
    K4_bias_y = K4_arm_rate_x*delta_speed
    knee_4_child_arm_x = sin_K4*e
    knee_4_child_arm_y = -cos_K4*e
    knee_4_child_arm_rate_x = -K4_rate_z*knee_4_child_arm_y
    knee_4_child_arm_rate_y = K4_rate_z*knee_4_child_arm_x
    knee_4_apart_bias_x = K4_bias_x + K2_rate_z_times_knee_3_parent_arm_rate_y - K2_bias_x - K4_rate_z*knee_4_child_arm_rate_y
    knee_4_apart_bias_y = K4_bias_y + minus_K2_rate_z_times_knee_3_parent_arm_rate_x + K4_rate_z*knee_4_child_arm_rate_x - K2_bias_y
    knee_4_x_on_delta = ya - K4_y - knee_4_child_arm_y
    knee_4_x_on_beta = K4_y + knee_4_child_arm_y
    knee_4_x_on_Theta = K4_y + knee_4_child_arm_y - K2_arm_y
    knee_4_y_on_delta = K4_x + knee_4_child_arm_x - xa
    knee_4_y_on_beta = -K4_x - knee_4_child_arm_x
    knee_4_y_on_Theta = K2_arm_x - K4_x - knee_4_child_arm_x
    K6_arm_x = sin_K7*u
    K6_arm_y = -cos_K7*u
    K6_arm_rate_x = -K6_arm_y*epsilon_speed
    K6_arm_rate_y = K6_arm_x*epsilon_speed
    K6_rate_z = Omega_speed + epsilon_speed
    K6_x = K6_arm_x + xa
    K6_y = K6_arm_y + ya
    K6_bias_x = -K6_arm_rate_y*epsilon_speed
    K6_bias_y = K6_arm_rate_x*epsilon_speed
    knee_6_child_arm_x = cos_K6*zf
    knee_6_child_arm_y = sin_K6*zf
    knee_6_child_arm_rate_x = -K6_rate_z*knee_6_child_arm_y
    knee_6_child_arm_rate_y = K6_rate_z*knee_6_child_arm_x
    knee_6_apart_bias_x = K6_bias_x + K2_rate_z_times_knee_3_parent_arm_rate_y - K2_bias_x - K6_rate_z*knee_6_child_arm_rate_y
    knee_6_apart_bias_y = K6_bias_y + minus_K2_rate_z_times_knee_3_parent_arm_rate_x + K6_rate_z*knee_6_child_arm_rate_x - K2_bias_y
    knee_6_x_on_epsilon = ya - K6_y - knee_6_child_arm_y
    knee_6_x_on_beta = K6_y + knee_6_child_arm_y
    knee_6_x_on_Theta = K6_y + knee_6_child_arm_y - K2_arm_y
    knee_6_y_on_epsilon = K6_x + knee_6_child_arm_x - xa
    knee_6_y_on_beta = -K6_x - knee_6_child_arm_x
    knee_6_y_on_Theta = K2_arm_x - K6_x - knee_6_child_arm_x
    K2_moment_x = K2_h_x*cos_K2
    K2_moment_y = K2_h_x*sin_K2
    K4_moment_x = -K4_h_y*sin_K4
    K4_moment_y = K4_h_y*cos_K4
    K6_moment_x = K6_h_x*cos_K6
    K6_moment_y = K6_h_x*sin_K6
    K1_rate_zz = beta_speed*beta_speed
    K2_rate_zz = K2_rate_z*K2_rate_z
    K2_force_x = -K2_moment_x*K2_rate_zz
    K2_force_y = -K2_moment_y*K2_rate_zz
    K2_bias_x_2 = -K1_rate_zz*K2_arm_x
    K2_bias_y_2 = -K1_rate_zz*K2_arm_y
    K2_torque_z = K2_bias_y_2*K2_moment_x - K2_bias_x_2*K2_moment_y
    K1_torque_z = K2_torque_z + K2_arm_x*K2_force_y - K2_arm_y*K2_force_x
    beta_net = beta_force - K1_torque_z
    Theta_net = Theta_force - K2_torque_z
    K5_rate_zz = delta_speed*delta_speed
    K4_rate_zz = K4_rate_z*K4_rate_z
    K4_force_x = -K4_moment_x*K4_rate_zz
    K4_force_y = -K4_moment_y*K4_rate_zz
    K4_bias_x_2 = -K4_arm_x*K5_rate_zz
    K4_bias_y_2 = -K4_arm_y*K5_rate_zz
    K4_torque_z = K4_bias_y_2*K4_moment_x - K4_bias_x_2*K4_moment_y
    K5_torque_z = K4_torque_z + K4_arm_x*K4_force_y - K4_arm_y*K4_force_x
    delta_net = delta_force - K5_torque_z
    Phi_net = Phi_force - K4_torque_z
    K7_rate_zz = epsilon_speed*epsilon_speed
    K6_rate_zz = K6_rate_z*K6_rate_z
    K6_force_x = -K6_moment_x*K6_rate_zz
    K6_force_y = -K6_moment_y*K6_rate_zz
    K6_bias_x_2 = -K6_arm_x*K7_rate_zz
    K6_bias_y_2 = -K6_arm_y*K7_rate_zz
    K6_torque_z = K6_bias_y_2*K6_moment_x - K6_bias_x_2*K6_moment_y
    K7_torque_z = K6_torque_z + K6_arm_x*K6_force_y - K6_arm_y*K6_force_x
    epsilon_net = epsilon_force - K7_torque_z
    Omega_net = Omega_force - K6_torque_z
    K1_total_J_z_z = K1_I_z_z_plus_K2_I_z_z + 2*K2_arm_x*K2_moment_x + 2*K2_arm_y*K2_moment_y
    Theta_K2_torque_z = K2_I_z_z + K2_arm_x*K2_moment_x + K2_arm_y*K2_moment_y
    K5_total_J_z_z = K4_I_z_z_plus_K5_I_z_z + 2*K4_arm_x*K4_moment_x + 2*K4_arm_y*K4_moment_y
    Phi_K4_torque_z = K4_I_z_z + K4_arm_x*K4_moment_x + K4_arm_y*K4_moment_y
    K7_total_J_z_z = K6_I_z_z_plus_K7_I_z_z + 2*K6_arm_x*K6_moment_x + 2*K6_arm_y*K6_moment_y
    Omega_K6_torque_z = K6_I_z_z + K6_arm_x*K6_moment_x + K6_arm_y*K6_moment_y
    l_epsilon_Omega = Omega_K6_torque_z*inverse_K6_I_z_z
    D_epsilon = K7_total_J_z_z - Omega_K6_torque_z*l_epsilon_Omega
    l_delta_Phi = Phi_K4_torque_z*inverse_K4_I_z_z
    D_delta = K5_total_J_z_z - Phi_K4_torque_z*l_delta_Phi
    l_beta_Theta = Theta_K2_torque_z*inverse_K2_I_z_z
    D_beta = K1_total_J_z_z - Theta_K2_torque_z*l_beta_Theta
    y_epsilon = epsilon_net - Omega_net*l_epsilon_Omega
    y_delta = delta_net - Phi_net*l_delta_Phi
    y_beta = beta_net - Theta_net*l_beta_Theta
    beta_acc = y_beta/D_beta
    Theta_acc = Theta_net*inverse_K2_I_z_z - beta_acc*l_beta_Theta
    gamma_acc = gamma_force*inverse_K3_I_z_z
    delta_acc = y_delta/D_delta
    Phi_acc = Phi_net*inverse_K4_I_z_z - delta_acc*l_delta_Phi
    epsilon_acc = y_epsilon/D_epsilon
    Omega_acc = Omega_net*inverse_K6_I_z_z - epsilon_acc*l_epsilon_Omega
    y_beta_2 = knee_3_x_on_beta - knee_3_x_on_Theta*l_beta_Theta
    beta_by_knee_3_apart_x = y_beta_2/D_beta
    Theta_by_knee_3_apart_x = inverse_K2_I_z_z*knee_3_x_on_Theta - beta_by_knee_3_apart_x*l_beta_Theta
    gamma_by_knee_3_apart_x = -inverse_K3_I_z_z*knee_3_child_arm_y
    y_beta_3 = knee_3_y_on_beta - knee_3_y_on_Theta*l_beta_Theta
    beta_by_knee_3_apart_y = y_beta_3/D_beta
    Theta_by_knee_3_apart_y = inverse_K2_I_z_z*knee_3_y_on_Theta - beta_by_knee_3_apart_y*l_beta_Theta
    gamma_by_knee_3_apart_y = inverse_K3_I_z_z*knee_3_child_arm_x
    y_delta_2 = knee_4_x_on_delta + knee_4_child_arm_y*l_delta_Phi
    y_beta_4 = knee_4_x_on_beta - knee_4_x_on_Theta*l_beta_Theta
    beta_by_knee_4_apart_x = y_beta_4/D_beta
    Theta_by_knee_4_apart_x = inverse_K2_I_z_z*knee_4_x_on_Theta - beta_by_knee_4_apart_x*l_beta_Theta
    delta_by_knee_4_apart_x = y_delta_2/D_delta
    Phi_by_knee_4_apart_x = -delta_by_knee_4_apart_x*l_delta_Phi - inverse_K4_I_z_z*knee_4_child_arm_y
    y_delta_3 = knee_4_y_on_delta - knee_4_child_arm_x*l_delta_Phi
    y_beta_5 = knee_4_y_on_beta - knee_4_y_on_Theta*l_beta_Theta
    beta_by_knee_4_apart_y = y_beta_5/D_beta
    Theta_by_knee_4_apart_y = inverse_K2_I_z_z*knee_4_y_on_Theta - beta_by_knee_4_apart_y*l_beta_Theta
    delta_by_knee_4_apart_y = y_delta_3/D_delta
    Phi_by_knee_4_apart_y = inverse_K4_I_z_z*knee_4_child_arm_x - delta_by_knee_4_apart_y*l_delta_Phi
    y_epsilon_2 = knee_6_x_on_epsilon + knee_6_child_arm_y*l_epsilon_Omega
    y_beta_6 = knee_6_x_on_beta - knee_6_x_on_Theta*l_beta_Theta
    beta_by_knee_6_apart_x = y_beta_6/D_beta
    Theta_by_knee_6_apart_x = inverse_K2_I_z_z*knee_6_x_on_Theta - beta_by_knee_6_apart_x*l_beta_Theta
    epsilon_by_knee_6_apart_x = y_epsilon_2/D_epsilon
    Omega_by_knee_6_apart_x = -epsilon_by_knee_6_apart_x*l_epsilon_Omega - inverse_K6_I_z_z*knee_6_child_arm_y
    y_epsilon_3 = knee_6_y_on_epsilon - knee_6_child_arm_x*l_epsilon_Omega
    y_beta_7 = knee_6_y_on_beta - knee_6_y_on_Theta*l_beta_Theta
    beta_by_knee_6_apart_y = y_beta_7/D_beta
    Theta_by_knee_6_apart_y = inverse_K2_I_z_z*knee_6_y_on_Theta - beta_by_knee_6_apart_y*l_beta_Theta
    epsilon_by_knee_6_apart_y = y_epsilon_3/D_epsilon
    Omega_by_knee_6_apart_y = inverse_K6_I_z_z*knee_6_child_arm_x - epsilon_by_knee_6_apart_y*l_epsilon_Omega
    W_knee_3_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_3_x_on_Theta + beta_by_knee_3_apart_x*knee_3_x_on_beta - gamma_by_knee_3_apart_x*knee_3_child_arm_y
    W_knee_3_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_3_y_on_Theta + beta_by_knee_3_apart_x*knee_3_y_on_beta + gamma_by_knee_3_apart_x*knee_3_child_arm_x
    W_knee_3_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_3_y_on_Theta + beta_by_knee_3_apart_y*knee_3_y_on_beta + gamma_by_knee_3_apart_y*knee_3_child_arm_x
    W_knee_4_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_4_x_on_Theta + beta_by_knee_3_apart_x*knee_4_x_on_beta
    W_knee_4_apart_x_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_4_x_on_Theta + beta_by_knee_3_apart_y*knee_4_x_on_beta
    W_knee_4_apart_x_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_4_x_on_Theta + beta_by_knee_4_apart_x*knee_4_x_on_beta + delta_by_knee_4_apart_x*knee_4_x_on_delta - Phi_by_knee_4_apart_x*knee_4_child_arm_y
    W_knee_4_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_4_y_on_Theta + beta_by_knee_3_apart_x*knee_4_y_on_beta
    W_knee_4_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_4_y_on_Theta + beta_by_knee_3_apart_y*knee_4_y_on_beta
    W_knee_4_apart_y_knee_4_apart_x = Phi_by_knee_4_apart_x*knee_4_child_arm_x + Theta_by_knee_4_apart_x*knee_4_y_on_Theta + beta_by_knee_4_apart_x*knee_4_y_on_beta + delta_by_knee_4_apart_x*knee_4_y_on_delta
    W_knee_4_apart_y_knee_4_apart_y = Phi_by_knee_4_apart_y*knee_4_child_arm_x + Theta_by_knee_4_apart_y*knee_4_y_on_Theta + beta_by_knee_4_apart_y*knee_4_y_on_beta + delta_by_knee_4_apart_y*knee_4_y_on_delta
    W_knee_6_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_6_x_on_Theta + beta_by_knee_3_apart_x*knee_6_x_on_beta
    W_knee_6_apart_x_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_6_x_on_Theta + beta_by_knee_3_apart_y*knee_6_x_on_beta
    W_knee_6_apart_x_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_6_x_on_Theta + beta_by_knee_4_apart_x*knee_6_x_on_beta
    W_knee_6_apart_x_knee_4_apart_y = Theta_by_knee_4_apart_y*knee_6_x_on_Theta + beta_by_knee_4_apart_y*knee_6_x_on_beta
    W_knee_6_apart_x_knee_6_apart_x = Theta_by_knee_6_apart_x*knee_6_x_on_Theta + beta_by_knee_6_apart_x*knee_6_x_on_beta + epsilon_by_knee_6_apart_x*knee_6_x_on_epsilon - Omega_by_knee_6_apart_x*knee_6_child_arm_y
    W_knee_6_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_6_y_on_Theta + beta_by_knee_3_apart_x*knee_6_y_on_beta
    W_knee_6_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_6_y_on_Theta + beta_by_knee_3_apart_y*knee_6_y_on_beta
    W_knee_6_apart_y_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_6_y_on_Theta + beta_by_knee_4_apart_x*knee_6_y_on_beta
    W_knee_6_apart_y_knee_4_apart_y = Theta_by_knee_4_apart_y*knee_6_y_on_Theta + beta_by_knee_4_apart_y*knee_6_y_on_beta
    W_knee_6_apart_y_knee_6_apart_x = Omega_by_knee_6_apart_x*knee_6_child_arm_x + Theta_by_knee_6_apart_x*knee_6_y_on_Theta + beta_by_knee_6_apart_x*knee_6_y_on_beta + epsilon_by_knee_6_apart_x*knee_6_y_on_epsilon
    W_knee_6_apart_y_knee_6_apart_y = Omega_by_knee_6_apart_y*knee_6_child_arm_x + Theta_by_knee_6_apart_y*knee_6_y_on_Theta + beta_by_knee_6_apart_y*knee_6_y_on_beta + epsilon_by_knee_6_apart_y*knee_6_y_on_epsilon
    knee_3_apart_size = W_knee_3_apart_x_knee_3_apart_x + W_knee_3_apart_y_knee_3_apart_y
    W_knee_3_apart_x_raised = W_knee_3_apart_x_knee_3_apart_x + knee_3_apart_size*knee_3_apart_x_softness
    W_knee_3_apart_y_raised = W_knee_3_apart_y_knee_3_apart_y + knee_3_apart_size*knee_3_apart_y_softness
    knee_4_apart_size = W_knee_4_apart_x_knee_4_apart_x + W_knee_4_apart_y_knee_4_apart_y
    W_knee_4_apart_x_raised = W_knee_4_apart_x_knee_4_apart_x + knee_4_apart_size*knee_4_apart_x_softness
    W_knee_4_apart_y_raised = W_knee_4_apart_y_knee_4_apart_y + knee_4_apart_size*knee_4_apart_y_softness
    knee_6_apart_size = W_knee_6_apart_x_knee_6_apart_x + W_knee_6_apart_y_knee_6_apart_y
    W_knee_6_apart_x_raised = W_knee_6_apart_x_knee_6_apart_x + knee_6_apart_size*knee_6_apart_x_softness
    W_knee_6_apart_y_raised = W_knee_6_apart_y_knee_6_apart_y + knee_6_apart_size*knee_6_apart_y_softness
    l_knee_3_apart_y_knee_3_apart_x = W_knee_3_apart_y_knee_3_apart_x/W_knee_3_apart_x_raised
    D_knee_3_apart_y = W_knee_3_apart_y_raised - W_knee_3_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    L_knee_4_apart_x_knee_3_apart_y = W_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_x_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_4_apart_x_knee_3_apart_x, l_knee_4_apart_y_knee_3_apart_x = revolute_apart_apart(W_knee_4_apart_x_knee_3_apart_x, W_knee_4_apart_y_knee_3_apart_x, W_knee_3_apart_x_raised)
    L_knee_4_apart_y_knee_3_apart_y = W_knee_4_apart_y_knee_3_apart_y - W_knee_4_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_4_apart_x_knee_3_apart_y, l_knee_4_apart_y_knee_3_apart_y = revolute_apart_apart(L_knee_4_apart_x_knee_3_apart_y, L_knee_4_apart_y_knee_3_apart_y, D_knee_3_apart_y)
    D_knee_4_apart_x = W_knee_4_apart_x_raised - L_knee_4_apart_x_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_x_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    L_knee_4_apart_y_knee_4_apart_x = W_knee_4_apart_y_knee_4_apart_x - L_knee_4_apart_y_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_y_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    l_knee_4_apart_y_knee_4_apart_x = L_knee_4_apart_y_knee_4_apart_x/D_knee_4_apart_x
    D_knee_4_apart_y = W_knee_4_apart_y_raised - L_knee_4_apart_y_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_4_apart_y_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_4_apart_y_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    L_knee_6_apart_x_knee_3_apart_y = W_knee_6_apart_x_knee_3_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    L_knee_6_apart_x_knee_4_apart_x = W_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_x_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    L_knee_6_apart_x_knee_4_apart_y = W_knee_6_apart_x_knee_4_apart_y - L_knee_6_apart_x_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_6_apart_x_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_6_apart_x_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    l_knee_6_apart_x_knee_3_apart_x, l_knee_6_apart_y_knee_3_apart_x = revolute_apart_apart(W_knee_6_apart_x_knee_3_apart_x, W_knee_6_apart_y_knee_3_apart_x, W_knee_3_apart_x_raised)
    L_knee_6_apart_y_knee_3_apart_y = W_knee_6_apart_y_knee_3_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    L_knee_6_apart_y_knee_4_apart_x = W_knee_6_apart_y_knee_4_apart_x - L_knee_6_apart_y_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    L_knee_6_apart_y_knee_4_apart_y = W_knee_6_apart_y_knee_4_apart_y - L_knee_6_apart_y_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_6_apart_y_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    l_knee_6_apart_x_knee_4_apart_y, l_knee_6_apart_y_knee_4_apart_y = revolute_apart_apart(L_knee_6_apart_x_knee_4_apart_y, L_knee_6_apart_y_knee_4_apart_y, D_knee_4_apart_y)
    l_knee_6_apart_x_knee_4_apart_x, l_knee_6_apart_y_knee_4_apart_x = revolute_apart_apart(L_knee_6_apart_x_knee_4_apart_x, L_knee_6_apart_y_knee_4_apart_x, D_knee_4_apart_x)
    l_knee_6_apart_x_knee_3_apart_y, l_knee_6_apart_y_knee_3_apart_y = revolute_apart_apart(L_knee_6_apart_x_knee_3_apart_y, L_knee_6_apart_y_knee_3_apart_y, D_knee_3_apart_y)
    D_knee_6_apart_x = W_knee_6_apart_x_raised - L_knee_6_apart_x_knee_3_apart_y*l_knee_6_apart_x_knee_3_apart_y - L_knee_6_apart_x_knee_4_apart_x*l_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_x_knee_4_apart_y*l_knee_6_apart_x_knee_4_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_6_apart_x_knee_3_apart_x
    L_knee_6_apart_y_knee_6_apart_x = W_knee_6_apart_y_knee_6_apart_x - L_knee_6_apart_y_knee_3_apart_y*l_knee_6_apart_x_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_y_knee_4_apart_y*l_knee_6_apart_x_knee_4_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_6_apart_x_knee_3_apart_x
    l_knee_6_apart_y_knee_6_apart_x = L_knee_6_apart_y_knee_6_apart_x/D_knee_6_apart_x
    D_knee_6_apart_y = W_knee_6_apart_y_raised - L_knee_6_apart_y_knee_3_apart_y*l_knee_6_apart_y_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_6_apart_y_knee_4_apart_x - L_knee_6_apart_y_knee_4_apart_y*l_knee_6_apart_y_knee_4_apart_y - L_knee_6_apart_y_knee_6_apart_x*l_knee_6_apart_y_knee_6_apart_x - W_knee_6_apart_y_knee_3_apart_x*l_knee_6_apart_y_knee_3_apart_x
    knee_3_apart_x_left = gamma_acc*knee_3_child_arm_y - knee_3_apart_bias_x - Theta_acc*knee_3_x_on_Theta - beta_acc*knee_3_x_on_beta
    knee_3_apart_y_left = -knee_3_apart_bias_y - Theta_acc*knee_3_y_on_Theta - beta_acc*knee_3_y_on_beta - gamma_acc*knee_3_child_arm_x
    knee_4_apart_x_left = Phi_acc*knee_4_child_arm_y - knee_4_apart_bias_x - Theta_acc*knee_4_x_on_Theta - beta_acc*knee_4_x_on_beta - delta_acc*knee_4_x_on_delta
    knee_4_apart_y_left = -knee_4_apart_bias_y - Phi_acc*knee_4_child_arm_x - Theta_acc*knee_4_y_on_Theta - beta_acc*knee_4_y_on_beta - delta_acc*knee_4_y_on_delta
    knee_6_apart_x_left = Omega_acc*knee_6_child_arm_y - knee_6_apart_bias_x - Theta_acc*knee_6_x_on_Theta - beta_acc*knee_6_x_on_beta - epsilon_acc*knee_6_x_on_epsilon
    knee_6_apart_y_left = -knee_6_apart_bias_y - Omega_acc*knee_6_child_arm_x - Theta_acc*knee_6_y_on_Theta - beta_acc*knee_6_y_on_beta - epsilon_acc*knee_6_y_on_epsilon
    y_knee_3_apart_y = knee_3_apart_y_left - knee_3_apart_x_left*l_knee_3_apart_y_knee_3_apart_x
    y_knee_4_apart_x = knee_4_apart_x_left - knee_3_apart_x_left*l_knee_4_apart_x_knee_3_apart_x - l_knee_4_apart_x_knee_3_apart_y*y_knee_3_apart_y
    y_knee_4_apart_y = knee_4_apart_y_left - knee_3_apart_x_left*l_knee_4_apart_y_knee_3_apart_x - l_knee_4_apart_y_knee_3_apart_y*y_knee_3_apart_y - l_knee_4_apart_y_knee_4_apart_x*y_knee_4_apart_x
    y_knee_6_apart_x = knee_6_apart_x_left - knee_3_apart_x_left*l_knee_6_apart_x_knee_3_apart_x - l_knee_6_apart_x_knee_3_apart_y*y_knee_3_apart_y - l_knee_6_apart_x_knee_4_apart_x*y_knee_4_apart_x - l_knee_6_apart_x_knee_4_apart_y*y_knee_4_apart_y
    y_knee_6_apart_y = knee_6_apart_y_left - knee_3_apart_x_left*l_knee_6_apart_y_knee_3_apart_x - l_knee_6_apart_y_knee_3_apart_y*y_knee_3_apart_y - l_knee_6_apart_y_knee_4_apart_x*y_knee_4_apart_x - l_knee_6_apart_y_knee_4_apart_y*y_knee_4_apart_y - l_knee_6_apart_y_knee_6_apart_x*y_knee_6_apart_x
    knee_6_apart_y_acc = y_knee_6_apart_y/D_knee_6_apart_y
    knee_6_apart_x_acc = y_knee_6_apart_x/D_knee_6_apart_x - knee_6_apart_y_acc*l_knee_6_apart_y_knee_6_apart_x
    knee_4_apart_y_acc = y_knee_4_apart_y/D_knee_4_apart_y - knee_6_apart_x_acc*l_knee_6_apart_x_knee_4_apart_y - knee_6_apart_y_acc*l_knee_6_apart_y_knee_4_apart_y
    knee_4_apart_x_acc = y_knee_4_apart_x/D_knee_4_apart_x - knee_4_apart_y_acc*l_knee_4_apart_y_knee_4_apart_x - knee_6_apart_x_acc*l_knee_6_apart_x_knee_4_apart_x - knee_6_apart_y_acc*l_knee_6_apart_y_knee_4_apart_x
    knee_3_apart_y_acc = y_knee_3_apart_y/D_knee_3_apart_y - knee_4_apart_x_acc*l_knee_4_apart_x_knee_3_apart_y - knee_4_apart_y_acc*l_knee_4_apart_y_knee_3_apart_y - knee_6_apart_x_acc*l_knee_6_apart_x_knee_3_apart_y - knee_6_apart_y_acc*l_knee_6_apart_y_knee_3_apart_y
    knee_3_apart_x_acc = knee_3_apart_x_left/W_knee_3_apart_x_raised - knee_3_apart_y_acc*l_knee_3_apart_y_knee_3_apart_x - knee_4_apart_x_acc*l_knee_4_apart_x_knee_3_apart_x - knee_4_apart_y_acc*l_knee_4_apart_y_knee_3_apart_x - knee_6_apart_x_acc*l_knee_6_apart_x_knee_3_apart_x - knee_6_apart_y_acc*l_knee_6_apart_y_knee_3_apart_x
    beta_acc_2 = beta_acc + beta_by_knee_3_apart_x*knee_3_apart_x_acc + beta_by_knee_3_apart_y*knee_3_apart_y_acc + beta_by_knee_4_apart_x*knee_4_apart_x_acc + beta_by_knee_4_apart_y*knee_4_apart_y_acc + beta_by_knee_6_apart_x*knee_6_apart_x_acc + beta_by_knee_6_apart_y*knee_6_apart_y_acc
    Theta_acc_2 = Theta_acc + Theta_by_knee_3_apart_x*knee_3_apart_x_acc + Theta_by_knee_3_apart_y*knee_3_apart_y_acc + Theta_by_knee_4_apart_x*knee_4_apart_x_acc + Theta_by_knee_4_apart_y*knee_4_apart_y_acc + Theta_by_knee_6_apart_x*knee_6_apart_x_acc + Theta_by_knee_6_apart_y*knee_6_apart_y_acc
    gamma_acc_2 = gamma_acc + gamma_by_knee_3_apart_x*knee_3_apart_x_acc + gamma_by_knee_3_apart_y*knee_3_apart_y_acc
    delta_acc_2 = delta_acc + delta_by_knee_4_apart_x*knee_4_apart_x_acc + delta_by_knee_4_apart_y*knee_4_apart_y_acc
    Phi_acc_2 = Phi_acc + Phi_by_knee_4_apart_x*knee_4_apart_x_acc + Phi_by_knee_4_apart_y*knee_4_apart_y_acc
    epsilon_acc_2 = epsilon_acc + epsilon_by_knee_6_apart_x*knee_6_apart_x_acc + epsilon_by_knee_6_apart_y*knee_6_apart_y_acc
    Omega_acc_2 = Omega_acc + Omega_by_knee_6_apart_x*knee_6_apart_x_acc + Omega_by_knee_6_apart_y*knee_6_apart_y_acc
    knee_3_apart_x_left_2 = gamma_acc_2*knee_3_child_arm_y - knee_3_apart_bias_x - Theta_acc_2*knee_3_x_on_Theta - beta_acc_2*knee_3_x_on_beta
    knee_3_apart_y_left_2 = -knee_3_apart_bias_y - Theta_acc_2*knee_3_y_on_Theta - beta_acc_2*knee_3_y_on_beta - gamma_acc_2*knee_3_child_arm_x
    knee_4_apart_x_left_2 = Phi_acc_2*knee_4_child_arm_y - knee_4_apart_bias_x - Theta_acc_2*knee_4_x_on_Theta - beta_acc_2*knee_4_x_on_beta - delta_acc_2*knee_4_x_on_delta
    knee_4_apart_y_left_2 = -knee_4_apart_bias_y - Phi_acc_2*knee_4_child_arm_x - Theta_acc_2*knee_4_y_on_Theta - beta_acc_2*knee_4_y_on_beta - delta_acc_2*knee_4_y_on_delta
    knee_6_apart_x_left_2 = Omega_acc_2*knee_6_child_arm_y - knee_6_apart_bias_x - Theta_acc_2*knee_6_x_on_Theta - beta_acc_2*knee_6_x_on_beta - epsilon_acc_2*knee_6_x_on_epsilon
    knee_6_apart_y_left_2 = -knee_6_apart_bias_y - Omega_acc_2*knee_6_child_arm_x - Theta_acc_2*knee_6_y_on_Theta - beta_acc_2*knee_6_y_on_beta - epsilon_acc_2*knee_6_y_on_epsilon
    y_knee_3_apart_y_2 = knee_3_apart_y_left_2 - knee_3_apart_x_left_2*l_knee_3_apart_y_knee_3_apart_x
    y_knee_4_apart_x_2 = knee_4_apart_x_left_2 - knee_3_apart_x_left_2*l_knee_4_apart_x_knee_3_apart_x - l_knee_4_apart_x_knee_3_apart_y*y_knee_3_apart_y_2
    y_knee_4_apart_y_2 = knee_4_apart_y_left_2 - knee_3_apart_x_left_2*l_knee_4_apart_y_knee_3_apart_x - l_knee_4_apart_y_knee_3_apart_y*y_knee_3_apart_y_2 - l_knee_4_apart_y_knee_4_apart_x*y_knee_4_apart_x_2
    y_knee_6_apart_x_2 = knee_6_apart_x_left_2 - knee_3_apart_x_left_2*l_knee_6_apart_x_knee_3_apart_x - l_knee_6_apart_x_knee_3_apart_y*y_knee_3_apart_y_2 - l_knee_6_apart_x_knee_4_apart_x*y_knee_4_apart_x_2 - l_knee_6_apart_x_knee_4_apart_y*y_knee_4_apart_y_2
    y_knee_6_apart_y_2 = knee_6_apart_y_left_2 - knee_3_apart_x_left_2*l_knee_6_apart_y_knee_3_apart_x - l_knee_6_apart_y_knee_3_apart_y*y_knee_3_apart_y_2 - l_knee_6_apart_y_knee_4_apart_x*y_knee_4_apart_x_2 - l_knee_6_apart_y_knee_4_apart_y*y_knee_4_apart_y_2 - l_knee_6_apart_y_knee_6_apart_x*y_knee_6_apart_x_2
    knee_6_apart_y_acc_2 = y_knee_6_apart_y_2/D_knee_6_apart_y
    knee_6_apart_x_acc_2 = y_knee_6_apart_x_2/D_knee_6_apart_x - knee_6_apart_y_acc_2*l_knee_6_apart_y_knee_6_apart_x
    knee_4_apart_y_acc_2 = y_knee_4_apart_y_2/D_knee_4_apart_y - knee_6_apart_x_acc_2*l_knee_6_apart_x_knee_4_apart_y - knee_6_apart_y_acc_2*l_knee_6_apart_y_knee_4_apart_y
    knee_4_apart_x_acc_2 = y_knee_4_apart_x_2/D_knee_4_apart_x - knee_4_apart_y_acc_2*l_knee_4_apart_y_knee_4_apart_x - knee_6_apart_x_acc_2*l_knee_6_apart_x_knee_4_apart_x - knee_6_apart_y_acc_2*l_knee_6_apart_y_knee_4_apart_x
    knee_3_apart_y_acc_2 = y_knee_3_apart_y_2/D_knee_3_apart_y - knee_4_apart_x_acc_2*l_knee_4_apart_x_knee_3_apart_y - knee_4_apart_y_acc_2*l_knee_4_apart_y_knee_3_apart_y - knee_6_apart_x_acc_2*l_knee_6_apart_x_knee_3_apart_y - knee_6_apart_y_acc_2*l_knee_6_apart_y_knee_3_apart_y
    knee_3_apart_x_acc_2 = knee_3_apart_x_left_2/W_knee_3_apart_x_raised - knee_3_apart_y_acc_2*l_knee_3_apart_y_knee_3_apart_x - knee_4_apart_x_acc_2*l_knee_4_apart_x_knee_3_apart_x - knee_4_apart_y_acc_2*l_knee_4_apart_y_knee_3_apart_x - knee_6_apart_x_acc_2*l_knee_6_apart_x_knee_3_apart_x - knee_6_apart_y_acc_2*l_knee_6_apart_y_knee_3_apart_x
    knee_3_apart_x_acc_3 = knee_3_apart_x_acc + knee_3_apart_x_acc_2
    knee_3_apart_y_acc_3 = knee_3_apart_y_acc + knee_3_apart_y_acc_2
    knee_4_apart_x_acc_3 = knee_4_apart_x_acc + knee_4_apart_x_acc_2
    knee_4_apart_y_acc_3 = knee_4_apart_y_acc + knee_4_apart_y_acc_2
    knee_6_apart_x_acc_3 = knee_6_apart_x_acc + knee_6_apart_x_acc_2
    knee_6_apart_y_acc_3 = knee_6_apart_y_acc + knee_6_apart_y_acc_2
    beta_acc_3 = beta_acc_2 + beta_by_knee_3_apart_x*knee_3_apart_x_acc_2 + beta_by_knee_3_apart_y*knee_3_apart_y_acc_2 + beta_by_knee_4_apart_x*knee_4_apart_x_acc_2 + beta_by_knee_4_apart_y*knee_4_apart_y_acc_2 + beta_by_knee_6_apart_x*knee_6_apart_x_acc_2 + beta_by_knee_6_apart_y*knee_6_apart_y_acc_2
    Theta_acc_3 = Theta_acc_2 + Theta_by_knee_3_apart_x*knee_3_apart_x_acc_2 + Theta_by_knee_3_apart_y*knee_3_apart_y_acc_2 + Theta_by_knee_4_apart_x*knee_4_apart_x_acc_2 + Theta_by_knee_4_apart_y*knee_4_apart_y_acc_2 + Theta_by_knee_6_apart_x*knee_6_apart_x_acc_2 + Theta_by_knee_6_apart_y*knee_6_apart_y_acc_2
    gamma_acc_3 = gamma_acc_2 + gamma_by_knee_3_apart_x*knee_3_apart_x_acc_2 + gamma_by_knee_3_apart_y*knee_3_apart_y_acc_2
    delta_acc_3 = delta_acc_2 + delta_by_knee_4_apart_x*knee_4_apart_x_acc_2 + delta_by_knee_4_apart_y*knee_4_apart_y_acc_2
    Phi_acc_3 = Phi_acc_2 + Phi_by_knee_4_apart_x*knee_4_apart_x_acc_2 + Phi_by_knee_4_apart_y*knee_4_apart_y_acc_2
    epsilon_acc_3 = epsilon_acc_2 + epsilon_by_knee_6_apart_x*knee_6_apart_x_acc_2 + epsilon_by_knee_6_apart_y*knee_6_apart_y_acc_2
    Omega_acc_3 = Omega_acc_2 + Omega_by_knee_6_apart_x*knee_6_apart_x_acc_2 + Omega_by_knee_6_apart_y*knee_6_apart_y_acc_2
    knee_3_apart_x_left_3 = gamma_acc_3*knee_3_child_arm_y - knee_3_apart_bias_x - Theta_acc_3*knee_3_x_on_Theta - beta_acc_3*knee_3_x_on_beta
    knee_3_apart_y_left_3 = -knee_3_apart_bias_y - Theta_acc_3*knee_3_y_on_Theta - beta_acc_3*knee_3_y_on_beta - gamma_acc_3*knee_3_child_arm_x
    knee_4_apart_x_left_3 = Phi_acc_3*knee_4_child_arm_y - knee_4_apart_bias_x - Theta_acc_3*knee_4_x_on_Theta - beta_acc_3*knee_4_x_on_beta - delta_acc_3*knee_4_x_on_delta
    knee_4_apart_y_left_3 = -knee_4_apart_bias_y - Phi_acc_3*knee_4_child_arm_x - Theta_acc_3*knee_4_y_on_Theta - beta_acc_3*knee_4_y_on_beta - delta_acc_3*knee_4_y_on_delta
    knee_6_apart_x_left_3 = Omega_acc_3*knee_6_child_arm_y - knee_6_apart_bias_x - Theta_acc_3*knee_6_x_on_Theta - beta_acc_3*knee_6_x_on_beta - epsilon_acc_3*knee_6_x_on_epsilon
    knee_6_apart_y_left_3 = -knee_6_apart_bias_y - Omega_acc_3*knee_6_child_arm_x - Theta_acc_3*knee_6_y_on_Theta - beta_acc_3*knee_6_y_on_beta - epsilon_acc_3*knee_6_y_on_epsilon
    y_knee_3_apart_y_3 = knee_3_apart_y_left_3 - knee_3_apart_x_left_3*l_knee_3_apart_y_knee_3_apart_x
    y_knee_4_apart_x_3 = knee_4_apart_x_left_3 - knee_3_apart_x_left_3*l_knee_4_apart_x_knee_3_apart_x - l_knee_4_apart_x_knee_3_apart_y*y_knee_3_apart_y_3
    y_knee_4_apart_y_3 = knee_4_apart_y_left_3 - knee_3_apart_x_left_3*l_knee_4_apart_y_knee_3_apart_x - l_knee_4_apart_y_knee_3_apart_y*y_knee_3_apart_y_3 - l_knee_4_apart_y_knee_4_apart_x*y_knee_4_apart_x_3
    y_knee_6_apart_x_3 = knee_6_apart_x_left_3 - knee_3_apart_x_left_3*l_knee_6_apart_x_knee_3_apart_x - l_knee_6_apart_x_knee_3_apart_y*y_knee_3_apart_y_3 - l_knee_6_apart_x_knee_4_apart_x*y_knee_4_apart_x_3 - l_knee_6_apart_x_knee_4_apart_y*y_knee_4_apart_y_3
    y_knee_6_apart_y_3 = knee_6_apart_y_left_3 - knee_3_apart_x_left_3*l_knee_6_apart_y_knee_3_apart_x - l_knee_6_apart_y_knee_3_apart_y*y_knee_3_apart_y_3 - l_knee_6_apart_y_knee_4_apart_x*y_knee_4_apart_x_3 - l_knee_6_apart_y_knee_4_apart_y*y_knee_4_apart_y_3 - l_knee_6_apart_y_knee_6_apart_x*y_knee_6_apart_x_3
    knee_6_apart_y_acc_4 = y_knee_6_apart_y_3/D_knee_6_apart_y
    knee_6_apart_x_acc_4 = y_knee_6_apart_x_3/D_knee_6_apart_x - knee_6_apart_y_acc_4*l_knee_6_apart_y_knee_6_apart_x
    knee_4_apart_y_acc_4 = y_knee_4_apart_y_3/D_knee_4_apart_y - knee_6_apart_x_acc_4*l_knee_6_apart_x_knee_4_apart_y - knee_6_apart_y_acc_4*l_knee_6_apart_y_knee_4_apart_y
    knee_4_apart_x_acc_4 = y_knee_4_apart_x_3/D_knee_4_apart_x - knee_4_apart_y_acc_4*l_knee_4_apart_y_knee_4_apart_x - knee_6_apart_x_acc_4*l_knee_6_apart_x_knee_4_apart_x - knee_6_apart_y_acc_4*l_knee_6_apart_y_knee_4_apart_x
    knee_3_apart_y_acc_4 = y_knee_3_apart_y_3/D_knee_3_apart_y - knee_4_apart_x_acc_4*l_knee_4_apart_x_knee_3_apart_y - knee_4_apart_y_acc_4*l_knee_4_apart_y_knee_3_apart_y - knee_6_apart_x_acc_4*l_knee_6_apart_x_knee_3_apart_y - knee_6_apart_y_acc_4*l_knee_6_apart_y_knee_3_apart_y
    knee_3_apart_x_acc_4 = knee_3_apart_x_left_3/W_knee_3_apart_x_raised - knee_3_apart_y_acc_4*l_knee_3_apart_y_knee_3_apart_x - knee_4_apart_x_acc_4*l_knee_4_apart_x_knee_3_apart_x - knee_4_apart_y_acc_4*l_knee_4_apart_y_knee_3_apart_x - knee_6_apart_x_acc_4*l_knee_6_apart_x_knee_3_apart_x - knee_6_apart_y_acc_4*l_knee_6_apart_y_knee_3_apart_x
    knee_3_apart_x_acc_5 = knee_3_apart_x_acc_3 + knee_3_apart_x_acc_4
    knee_3_apart_y_acc_5 = knee_3_apart_y_acc_3 + knee_3_apart_y_acc_4
    knee_4_apart_x_acc_5 = knee_4_apart_x_acc_3 + knee_4_apart_x_acc_4
    knee_4_apart_y_acc_5 = knee_4_apart_y_acc_3 + knee_4_apart_y_acc_4
    knee_6_apart_x_acc_5 = knee_6_apart_x_acc_3 + knee_6_apart_x_acc_4
    knee_6_apart_y_acc_5 = knee_6_apart_y_acc_3 + knee_6_apart_y_acc_4
    beta_acc_4 = beta_acc_3 + beta_by_knee_3_apart_x*knee_3_apart_x_acc_4 + beta_by_knee_3_apart_y*knee_3_apart_y_acc_4 + beta_by_knee_4_apart_x*knee_4_apart_x_acc_4 + beta_by_knee_4_apart_y*knee_4_apart_y_acc_4 + beta_by_knee_6_apart_x*knee_6_apart_x_acc_4 + beta_by_knee_6_apart_y*knee_6_apart_y_acc_4
    Theta_acc_4 = Theta_acc_3 + Theta_by_knee_3_apart_x*knee_3_apart_x_acc_4 + Theta_by_knee_3_apart_y*knee_3_apart_y_acc_4 + Theta_by_knee_4_apart_x*knee_4_apart_x_acc_4 + Theta_by_knee_4_apart_y*knee_4_apart_y_acc_4 + Theta_by_knee_6_apart_x*knee_6_apart_x_acc_4 + Theta_by_knee_6_apart_y*knee_6_apart_y_acc_4
    gamma_acc_4 = gamma_acc_3 + gamma_by_knee_3_apart_x*knee_3_apart_x_acc_4 + gamma_by_knee_3_apart_y*knee_3_apart_y_acc_4
    delta_acc_4 = delta_acc_3 + delta_by_knee_4_apart_x*knee_4_apart_x_acc_4 + delta_by_knee_4_apart_y*knee_4_apart_y_acc_4
    Phi_acc_4 = Phi_acc_3 + Phi_by_knee_4_apart_x*knee_4_apart_x_acc_4 + Phi_by_knee_4_apart_y*knee_4_apart_y_acc_4
    epsilon_acc_4 = epsilon_acc_3 + epsilon_by_knee_6_apart_x*knee_6_apart_x_acc_4 + epsilon_by_knee_6_apart_y*knee_6_apart_y_acc_4
    Omega_acc_4 = Omega_acc_3 + Omega_by_knee_6_apart_x*knee_6_apart_x_acc_4 + Omega_by_knee_6_apart_y*knee_6_apart_y_acc_4
    return (ca.vertcat(beta_acc_4, Theta_acc_4, gamma_acc_4, delta_acc_4, Phi_acc_4, epsilon_acc_4, Omega_acc_4), ca.vertcat(),
        ca.vertcat(knee_3_apart_x_acc_5, knee_3_apart_y_acc_5, knee_4_apart_x_acc_5, knee_4_apart_y_acc_5, knee_6_apart_x_acc_5,
            knee_6_apart_y_acc_5))


def constraints(t, q, speeds, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (6,): CONSTRAINTS
        dphi (6,): CONSTRAINTS [m/s]
    """
    e, zf, rr, xb, yb, xa, ya, zt, u, d, ss = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10]
    beta_angle, Theta_angle, gamma_angle, delta_angle, Phi_angle, epsilon_angle, Omega_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    beta_speed, Theta_speed, gamma_speed = speeds[0], speeds[1], speeds[2]
    cos_K1 = ca.cos(beta_angle)
    sin_K1 = ca.sin(beta_angle)
    K2_angle = Theta_angle + beta_angle
    cos_K2 = ca.cos(K2_angle)
    sin_K2 = ca.sin(K2_angle)
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    cos_K5 = ca.cos(delta_angle)
    sin_K5 = ca.sin(delta_angle)
    K4_angle = Phi_angle + delta_angle
    cos_K4 = ca.cos(K4_angle)
    sin_K4 = ca.sin(K4_angle)
    cos_K7 = ca.cos(epsilon_angle)
    sin_K7 = ca.sin(epsilon_angle)
    K6_angle = Omega_angle + epsilon_angle
    cos_K6 = ca.cos(K6_angle)
    sin_K6 = ca.sin(K6_angle)
    K2_arm_x = cos_K1*rr
    K2_arm_y = sin_K1*rr
    K2_arm_rate_x = -K2_arm_y*beta_speed
    K2_arm_rate_y = K2_arm_x*beta_speed
    K2_rate_z = Theta_speed + beta_speed
    knee_3_child_arm_x = sin_K3*ss
    knee_3_child_arm_y = -cos_K3*ss
    knee_3_child_arm_rate_x = -gamma_speed*knee_3_child_arm_y
    knee_3_child_arm_rate_y = gamma_speed*knee_3_child_arm_x
    knee_3_parent_arm_x = -cos_K2*d
    knee_3_parent_arm_y = -sin_K2*d
    knee_3_parent_arm_rate_x = -K2_rate_z*knee_3_parent_arm_y
    knee_3_parent_arm_rate_y = K2_rate_z*knee_3_parent_arm_x
    knee_3_apart_x = knee_3_child_arm_x + xb - K2_arm_x - knee_3_parent_arm_x
    knee_3_apart_y = knee_3_child_arm_y + yb - K2_arm_y - knee_3_parent_arm_y
    knee_3_apart_rate_x = knee_3_child_arm_rate_x - K2_arm_rate_x - knee_3_parent_arm_rate_x
    knee_3_apart_rate_y = knee_3_child_arm_rate_y - K2_arm_rate_y - knee_3_parent_arm_rate_y
    K4_arm_y = sin_K5*zt
    knee_4_child_arm_y = -cos_K4*e
    knee_4_apart_x, knee_4_apart_y, knee_4_apart_rate_x, knee_4_apart_rate_y = revolute_apart(cos_K5, sin_K4, K2_arm_x, K2_arm_y, K2_arm_rate_x, K2_arm_rate_y, knee_3_parent_arm_x, knee_3_parent_arm_y, knee_3_parent_arm_rate_x, knee_3_parent_arm_rate_y, K4_arm_y, knee_4_child_arm_y, speeds[3], speeds[4], e, xa, ya, zt)
    K6_arm_y = -cos_K7*u
    knee_6_child_arm_y = sin_K6*zf
    knee_6_apart_x, knee_6_apart_y, knee_6_apart_rate_x, knee_6_apart_rate_y = revolute_apart(sin_K7, cos_K6, K2_arm_x, K2_arm_y, K2_arm_rate_x, K2_arm_rate_y, knee_3_parent_arm_x, knee_3_parent_arm_y, knee_3_parent_arm_rate_x, knee_3_parent_arm_rate_y, K6_arm_y, knee_6_child_arm_y, speeds[5], speeds[6], zf, xa, ya, u)
    return (ca.vertcat(knee_3_apart_x, knee_3_apart_y, knee_4_apart_x, knee_4_apart_y, knee_6_apart_x, knee_6_apart_y),
        ca.vertcat(knee_3_apart_rate_x, knee_3_apart_rate_y, knee_4_apart_rate_x, knee_4_apart_rate_y, knee_6_apart_rate_x,
            knee_6_apart_rate_y))


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (7,): SPEEDS
        independence (6,): CONSTRAINTS [1]
    """
    e, zf, rr, xb, yb, xa, ya, zt, u, ss, K2_h_x, K4_h_y = c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[10], c[19], c[20]
    K6_h_x, K2_I_z_z, K1_I_z_z_plus_K2_I_z_z, K4_I_z_z, K4_I_z_z_plus_K5_I_z_z, K6_I_z_z = c[21], c[22], c[23], c[24], c[25], c[26]
    K6_I_z_z_plus_K7_I_z_z, inverse_K6_I_z_z, inverse_K4_I_z_z, inverse_K2_I_z_z, inverse_K3_I_z_z = c[27], c[28], c[29], c[30], c[31]
    knee_3_apart_x_softness, knee_3_apart_y_softness, knee_4_apart_x_softness, knee_4_apart_y_softness = c[42], c[43], c[44], c[45]
    knee_6_apart_x_softness, knee_6_apart_y_softness = c[46], c[47]
    beta_angle, Theta_angle, gamma_angle, delta_angle, Phi_angle, epsilon_angle, Omega_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    knee_3_apart_x_wanted_rate, knee_3_apart_y_wanted_rate, knee_4_apart_x_wanted_rate = wanted[0], wanted[1], wanted[2]
    knee_4_apart_y_wanted_rate, knee_6_apart_x_wanted_rate, knee_6_apart_y_wanted_rate = wanted[3], wanted[4], wanted[5]
    cos_K1 = ca.cos(beta_angle)
    sin_K1 = ca.sin(beta_angle)
    K2_angle = Theta_angle + beta_angle
    cos_K2 = ca.cos(K2_angle)
    sin_K2 = ca.sin(K2_angle)
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    cos_K5 = ca.cos(delta_angle)
    sin_K5 = ca.sin(delta_angle)
    K4_angle = Phi_angle + delta_angle
    cos_K4 = ca.cos(K4_angle)
    sin_K4 = ca.sin(K4_angle)
    cos_K7 = ca.cos(epsilon_angle)
    sin_K7 = ca.sin(epsilon_angle)
    K6_angle = Omega_angle + epsilon_angle
    cos_K6 = ca.cos(K6_angle)
    sin_K6 = ca.sin(K6_angle)
    K2_arm_x = cos_K1*rr
    K2_arm_y = sin_K1*rr
    knee_3_child_arm_x = sin_K3*ss
    knee_3_child_arm_y = -cos_K3*ss
    knee_3_x_on_beta = knee_3_child_arm_y + yb
    knee_3_x_on_Theta = knee_3_child_arm_y + yb - K2_arm_y
    knee_3_y_on_beta = -knee_3_child_arm_x - xb
    knee_3_y_on_Theta = K2_arm_x - knee_3_child_arm_x - xb
    K4_arm_x = cos_K5*zt
    K4_arm_y = sin_K5*zt
    K4_x = K4_arm_x + xa
    K4_y = K4_arm_y + ya
    knee_4_child_arm_x = sin_K4*e
    knee_4_child_arm_y = -cos_K4*e
    knee_4_x_on_delta = ya - K4_y - knee_4_child_arm_y
    knee_4_x_on_beta = K4_y + knee_4_child_arm_y
    knee_4_x_on_Theta = K4_y + knee_4_child_arm_y - K2_arm_y
    knee_4_y_on_delta = K4_x + knee_4_child_arm_x - xa
    knee_4_y_on_beta = -K4_x - knee_4_child_arm_x
    knee_4_y_on_Theta = K2_arm_x - K4_x - knee_4_child_arm_x
    K6_arm_x = sin_K7*u
    K6_arm_y = -cos_K7*u
    K6_x = K6_arm_x + xa
    K6_y = K6_arm_y + ya
    knee_6_child_arm_x = cos_K6*zf
    knee_6_child_arm_y = sin_K6*zf
    knee_6_x_on_epsilon = ya - K6_y - knee_6_child_arm_y
    knee_6_x_on_beta = K6_y + knee_6_child_arm_y
    knee_6_x_on_Theta = K6_y + knee_6_child_arm_y - K2_arm_y
    knee_6_y_on_epsilon = K6_x + knee_6_child_arm_x - xa
    knee_6_y_on_beta = -K6_x - knee_6_child_arm_x
    knee_6_y_on_Theta = K2_arm_x - K6_x - knee_6_child_arm_x
    K2_moment_x = K2_h_x*cos_K2
    K2_moment_y = K2_h_x*sin_K2
    K4_moment_x = -K4_h_y*sin_K4
    K4_moment_y = K4_h_y*cos_K4
    K6_moment_x = K6_h_x*cos_K6
    K6_moment_y = K6_h_x*sin_K6
    K1_total_J_z_z = K1_I_z_z_plus_K2_I_z_z + 2*K2_arm_x*K2_moment_x + 2*K2_arm_y*K2_moment_y
    Theta_K2_torque_z = K2_I_z_z + K2_arm_x*K2_moment_x + K2_arm_y*K2_moment_y
    K5_total_J_z_z = K4_I_z_z_plus_K5_I_z_z + 2*K4_arm_x*K4_moment_x + 2*K4_arm_y*K4_moment_y
    Phi_K4_torque_z = K4_I_z_z + K4_arm_x*K4_moment_x + K4_arm_y*K4_moment_y
    K7_total_J_z_z = K6_I_z_z_plus_K7_I_z_z + 2*K6_arm_x*K6_moment_x + 2*K6_arm_y*K6_moment_y
    Omega_K6_torque_z = K6_I_z_z + K6_arm_x*K6_moment_x + K6_arm_y*K6_moment_y
    l_epsilon_Omega = Omega_K6_torque_z*inverse_K6_I_z_z
    D_epsilon = K7_total_J_z_z - Omega_K6_torque_z*l_epsilon_Omega
    l_delta_Phi = Phi_K4_torque_z*inverse_K4_I_z_z
    D_delta = K5_total_J_z_z - Phi_K4_torque_z*l_delta_Phi
    l_beta_Theta = Theta_K2_torque_z*inverse_K2_I_z_z
    D_beta = K1_total_J_z_z - Theta_K2_torque_z*l_beta_Theta
    y_beta_2 = knee_3_x_on_beta - knee_3_x_on_Theta*l_beta_Theta
    y_beta_3 = knee_3_y_on_beta - knee_3_y_on_Theta*l_beta_Theta
    beta_by_knee_3_apart_x, beta_by_knee_3_apart_y = revolute_apart_apart(y_beta_2, y_beta_3, D_beta)
    Theta_by_knee_3_apart_x = inverse_K2_I_z_z*knee_3_x_on_Theta - beta_by_knee_3_apart_x*l_beta_Theta
    gamma_by_knee_3_apart_x = -inverse_K3_I_z_z*knee_3_child_arm_y
    Theta_by_knee_3_apart_y = inverse_K2_I_z_z*knee_3_y_on_Theta - beta_by_knee_3_apart_y*l_beta_Theta
    gamma_by_knee_3_apart_y = inverse_K3_I_z_z*knee_3_child_arm_x
    y_delta_2 = knee_4_x_on_delta + knee_4_child_arm_y*l_delta_Phi
    y_beta_4 = knee_4_x_on_beta - knee_4_x_on_Theta*l_beta_Theta
    y_beta_5 = knee_4_y_on_beta - knee_4_y_on_Theta*l_beta_Theta
    beta_by_knee_4_apart_x, beta_by_knee_4_apart_y = revolute_apart_apart(y_beta_4, y_beta_5, D_beta)
    Theta_by_knee_4_apart_x = inverse_K2_I_z_z*knee_4_x_on_Theta - beta_by_knee_4_apart_x*l_beta_Theta
    y_delta_3 = knee_4_y_on_delta - knee_4_child_arm_x*l_delta_Phi
    delta_by_knee_4_apart_x, delta_by_knee_4_apart_y = revolute_apart_apart(y_delta_2, y_delta_3, D_delta)
    Phi_by_knee_4_apart_x = -delta_by_knee_4_apart_x*l_delta_Phi - inverse_K4_I_z_z*knee_4_child_arm_y
    Theta_by_knee_4_apart_y = inverse_K2_I_z_z*knee_4_y_on_Theta - beta_by_knee_4_apart_y*l_beta_Theta
    Phi_by_knee_4_apart_y = inverse_K4_I_z_z*knee_4_child_arm_x - delta_by_knee_4_apart_y*l_delta_Phi
    y_epsilon_2 = knee_6_x_on_epsilon + knee_6_child_arm_y*l_epsilon_Omega
    y_beta_6 = knee_6_x_on_beta - knee_6_x_on_Theta*l_beta_Theta
    y_beta_7 = knee_6_y_on_beta - knee_6_y_on_Theta*l_beta_Theta
    beta_by_knee_6_apart_x, beta_by_knee_6_apart_y = revolute_apart_apart(y_beta_6, y_beta_7, D_beta)
    Theta_by_knee_6_apart_x = inverse_K2_I_z_z*knee_6_x_on_Theta - beta_by_knee_6_apart_x*l_beta_Theta
    y_epsilon_3 = knee_6_y_on_epsilon - knee_6_child_arm_x*l_epsilon_Omega
    epsilon_by_knee_6_apart_x, epsilon_by_knee_6_apart_y = revolute_apart_apart(y_epsilon_2, y_epsilon_3, D_epsilon)
    Omega_by_knee_6_apart_x = -epsilon_by_knee_6_apart_x*l_epsilon_Omega - inverse_K6_I_z_z*knee_6_child_arm_y
    Theta_by_knee_6_apart_y = inverse_K2_I_z_z*knee_6_y_on_Theta - beta_by_knee_6_apart_y*l_beta_Theta
    Omega_by_knee_6_apart_y = inverse_K6_I_z_z*knee_6_child_arm_x - epsilon_by_knee_6_apart_y*l_epsilon_Omega
    W_knee_3_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_3_x_on_Theta + beta_by_knee_3_apart_x*knee_3_x_on_beta - gamma_by_knee_3_apart_x*knee_3_child_arm_y
    W_knee_3_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_3_y_on_Theta + beta_by_knee_3_apart_x*knee_3_y_on_beta + gamma_by_knee_3_apart_x*knee_3_child_arm_x
    W_knee_3_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_3_y_on_Theta + beta_by_knee_3_apart_y*knee_3_y_on_beta + gamma_by_knee_3_apart_y*knee_3_child_arm_x
    W_knee_4_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_4_x_on_Theta + beta_by_knee_3_apart_x*knee_4_x_on_beta
    W_knee_4_apart_x_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_4_x_on_Theta + beta_by_knee_3_apart_y*knee_4_x_on_beta
    W_knee_4_apart_x_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_4_x_on_Theta + beta_by_knee_4_apart_x*knee_4_x_on_beta + delta_by_knee_4_apart_x*knee_4_x_on_delta - Phi_by_knee_4_apart_x*knee_4_child_arm_y
    W_knee_4_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_4_y_on_Theta + beta_by_knee_3_apart_x*knee_4_y_on_beta
    W_knee_4_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_4_y_on_Theta + beta_by_knee_3_apart_y*knee_4_y_on_beta
    W_knee_4_apart_y_knee_4_apart_x = Phi_by_knee_4_apart_x*knee_4_child_arm_x + Theta_by_knee_4_apart_x*knee_4_y_on_Theta + beta_by_knee_4_apart_x*knee_4_y_on_beta + delta_by_knee_4_apart_x*knee_4_y_on_delta
    W_knee_4_apart_y_knee_4_apart_y = Phi_by_knee_4_apart_y*knee_4_child_arm_x + Theta_by_knee_4_apart_y*knee_4_y_on_Theta + beta_by_knee_4_apart_y*knee_4_y_on_beta + delta_by_knee_4_apart_y*knee_4_y_on_delta
    W_knee_6_apart_x_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_6_x_on_Theta + beta_by_knee_3_apart_x*knee_6_x_on_beta
    W_knee_6_apart_x_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_6_x_on_Theta + beta_by_knee_3_apart_y*knee_6_x_on_beta
    W_knee_6_apart_x_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_6_x_on_Theta + beta_by_knee_4_apart_x*knee_6_x_on_beta
    W_knee_6_apart_x_knee_4_apart_y = Theta_by_knee_4_apart_y*knee_6_x_on_Theta + beta_by_knee_4_apart_y*knee_6_x_on_beta
    W_knee_6_apart_x_knee_6_apart_x = Theta_by_knee_6_apart_x*knee_6_x_on_Theta + beta_by_knee_6_apart_x*knee_6_x_on_beta + epsilon_by_knee_6_apart_x*knee_6_x_on_epsilon - Omega_by_knee_6_apart_x*knee_6_child_arm_y
    W_knee_6_apart_y_knee_3_apart_x = Theta_by_knee_3_apart_x*knee_6_y_on_Theta + beta_by_knee_3_apart_x*knee_6_y_on_beta
    W_knee_6_apart_y_knee_3_apart_y = Theta_by_knee_3_apart_y*knee_6_y_on_Theta + beta_by_knee_3_apart_y*knee_6_y_on_beta
    W_knee_6_apart_y_knee_4_apart_x = Theta_by_knee_4_apart_x*knee_6_y_on_Theta + beta_by_knee_4_apart_x*knee_6_y_on_beta
    W_knee_6_apart_y_knee_4_apart_y = Theta_by_knee_4_apart_y*knee_6_y_on_Theta + beta_by_knee_4_apart_y*knee_6_y_on_beta
    W_knee_6_apart_y_knee_6_apart_x = Omega_by_knee_6_apart_x*knee_6_child_arm_x + Theta_by_knee_6_apart_x*knee_6_y_on_Theta + beta_by_knee_6_apart_x*knee_6_y_on_beta + epsilon_by_knee_6_apart_x*knee_6_y_on_epsilon
    W_knee_6_apart_y_knee_6_apart_y = Omega_by_knee_6_apart_y*knee_6_child_arm_x + Theta_by_knee_6_apart_y*knee_6_y_on_Theta + beta_by_knee_6_apart_y*knee_6_y_on_beta + epsilon_by_knee_6_apart_y*knee_6_y_on_epsilon
    knee_3_apart_size = W_knee_3_apart_x_knee_3_apart_x + W_knee_3_apart_y_knee_3_apart_y
    W_knee_3_apart_x_raised = W_knee_3_apart_x_knee_3_apart_x + knee_3_apart_size*knee_3_apart_x_softness
    W_knee_3_apart_y_raised = W_knee_3_apart_y_knee_3_apart_y + knee_3_apart_size*knee_3_apart_y_softness
    knee_4_apart_size = W_knee_4_apart_x_knee_4_apart_x + W_knee_4_apart_y_knee_4_apart_y
    W_knee_4_apart_x_raised = W_knee_4_apart_x_knee_4_apart_x + knee_4_apart_size*knee_4_apart_x_softness
    W_knee_4_apart_y_raised = W_knee_4_apart_y_knee_4_apart_y + knee_4_apart_size*knee_4_apart_y_softness
    knee_6_apart_size = W_knee_6_apart_x_knee_6_apart_x + W_knee_6_apart_y_knee_6_apart_y
    W_knee_6_apart_x_raised = W_knee_6_apart_x_knee_6_apart_x + knee_6_apart_size*knee_6_apart_x_softness
    W_knee_6_apart_y_raised = W_knee_6_apart_y_knee_6_apart_y + knee_6_apart_size*knee_6_apart_y_softness
    l_knee_3_apart_y_knee_3_apart_x = W_knee_3_apart_y_knee_3_apart_x/W_knee_3_apart_x_raised
    D_knee_3_apart_y = W_knee_3_apart_y_raised - W_knee_3_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_4_apart_x_knee_3_apart_x = W_knee_4_apart_x_knee_3_apart_x/W_knee_3_apart_x_raised
    L_knee_4_apart_x_knee_3_apart_y = W_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_x_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_4_apart_x_knee_3_apart_y = L_knee_4_apart_x_knee_3_apart_y/D_knee_3_apart_y
    D_knee_4_apart_x = W_knee_4_apart_x_raised - L_knee_4_apart_x_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_x_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    l_knee_4_apart_y_knee_3_apart_x = W_knee_4_apart_y_knee_3_apart_x/W_knee_3_apart_x_raised
    L_knee_4_apart_y_knee_3_apart_y = W_knee_4_apart_y_knee_3_apart_y - W_knee_4_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_4_apart_y_knee_3_apart_y = L_knee_4_apart_y_knee_3_apart_y/D_knee_3_apart_y
    L_knee_4_apart_y_knee_4_apart_x = W_knee_4_apart_y_knee_4_apart_x - L_knee_4_apart_y_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_4_apart_y_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    l_knee_4_apart_y_knee_4_apart_x = L_knee_4_apart_y_knee_4_apart_x/D_knee_4_apart_x
    D_knee_4_apart_y = W_knee_4_apart_y_raised - L_knee_4_apart_y_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_4_apart_y_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_4_apart_y_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    l_knee_6_apart_x_knee_3_apart_x = W_knee_6_apart_x_knee_3_apart_x/W_knee_3_apart_x_raised
    L_knee_6_apart_x_knee_3_apart_y = W_knee_6_apart_x_knee_3_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_6_apart_x_knee_3_apart_y = L_knee_6_apart_x_knee_3_apart_y/D_knee_3_apart_y
    L_knee_6_apart_x_knee_4_apart_x = W_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_x_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    l_knee_6_apart_x_knee_4_apart_x = L_knee_6_apart_x_knee_4_apart_x/D_knee_4_apart_x
    L_knee_6_apart_x_knee_4_apart_y = W_knee_6_apart_x_knee_4_apart_y - L_knee_6_apart_x_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_6_apart_x_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_6_apart_x_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    l_knee_6_apart_x_knee_4_apart_y = L_knee_6_apart_x_knee_4_apart_y/D_knee_4_apart_y
    D_knee_6_apart_x = W_knee_6_apart_x_raised - L_knee_6_apart_x_knee_3_apart_y*l_knee_6_apart_x_knee_3_apart_y - L_knee_6_apart_x_knee_4_apart_x*l_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_x_knee_4_apart_y*l_knee_6_apart_x_knee_4_apart_y - W_knee_6_apart_x_knee_3_apart_x*l_knee_6_apart_x_knee_3_apart_x
    l_knee_6_apart_y_knee_3_apart_x = W_knee_6_apart_y_knee_3_apart_x/W_knee_3_apart_x_raised
    L_knee_6_apart_y_knee_3_apart_y = W_knee_6_apart_y_knee_3_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_3_apart_y_knee_3_apart_x
    l_knee_6_apart_y_knee_3_apart_y = L_knee_6_apart_y_knee_3_apart_y/D_knee_3_apart_y
    L_knee_6_apart_y_knee_4_apart_x = W_knee_6_apart_y_knee_4_apart_x - L_knee_6_apart_y_knee_3_apart_y*l_knee_4_apart_x_knee_3_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_4_apart_x_knee_3_apart_x
    l_knee_6_apart_y_knee_4_apart_x = L_knee_6_apart_y_knee_4_apart_x/D_knee_4_apart_x
    L_knee_6_apart_y_knee_4_apart_y = W_knee_6_apart_y_knee_4_apart_y - L_knee_6_apart_y_knee_3_apart_y*l_knee_4_apart_y_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_4_apart_y_knee_4_apart_x - W_knee_6_apart_y_knee_3_apart_x*l_knee_4_apart_y_knee_3_apart_x
    l_knee_6_apart_y_knee_4_apart_y = L_knee_6_apart_y_knee_4_apart_y/D_knee_4_apart_y
    L_knee_6_apart_y_knee_6_apart_x = W_knee_6_apart_y_knee_6_apart_x - L_knee_6_apart_y_knee_3_apart_y*l_knee_6_apart_x_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_6_apart_x_knee_4_apart_x - L_knee_6_apart_y_knee_4_apart_y*l_knee_6_apart_x_knee_4_apart_y - W_knee_6_apart_y_knee_3_apart_x*l_knee_6_apart_x_knee_3_apart_x
    l_knee_6_apart_y_knee_6_apart_x = L_knee_6_apart_y_knee_6_apart_x/D_knee_6_apart_x
    D_knee_6_apart_y = W_knee_6_apart_y_raised - L_knee_6_apart_y_knee_3_apart_y*l_knee_6_apart_y_knee_3_apart_y - L_knee_6_apart_y_knee_4_apart_x*l_knee_6_apart_y_knee_4_apart_x - L_knee_6_apart_y_knee_4_apart_y*l_knee_6_apart_y_knee_4_apart_y - L_knee_6_apart_y_knee_6_apart_x*l_knee_6_apart_y_knee_6_apart_x - W_knee_6_apart_y_knee_3_apart_x*l_knee_6_apart_y_knee_3_apart_x
    y_knee_3_apart_y_4 = knee_3_apart_y_wanted_rate - knee_3_apart_x_wanted_rate*l_knee_3_apart_y_knee_3_apart_x
    y_knee_4_apart_x_4 = knee_4_apart_x_wanted_rate - knee_3_apart_x_wanted_rate*l_knee_4_apart_x_knee_3_apart_x - l_knee_4_apart_x_knee_3_apart_y*y_knee_3_apart_y_4
    y_knee_4_apart_y_4 = knee_4_apart_y_wanted_rate - knee_3_apart_x_wanted_rate*l_knee_4_apart_y_knee_3_apart_x - l_knee_4_apart_y_knee_3_apart_y*y_knee_3_apart_y_4 - l_knee_4_apart_y_knee_4_apart_x*y_knee_4_apart_x_4
    y_knee_6_apart_x_4 = knee_6_apart_x_wanted_rate - knee_3_apart_x_wanted_rate*l_knee_6_apart_x_knee_3_apart_x - l_knee_6_apart_x_knee_3_apart_y*y_knee_3_apart_y_4 - l_knee_6_apart_x_knee_4_apart_x*y_knee_4_apart_x_4 - l_knee_6_apart_x_knee_4_apart_y*y_knee_4_apart_y_4
    y_knee_6_apart_y_4 = knee_6_apart_y_wanted_rate - knee_3_apart_x_wanted_rate*l_knee_6_apart_y_knee_3_apart_x - l_knee_6_apart_y_knee_3_apart_y*y_knee_3_apart_y_4 - l_knee_6_apart_y_knee_4_apart_x*y_knee_4_apart_x_4 - l_knee_6_apart_y_knee_4_apart_y*y_knee_4_apart_y_4 - l_knee_6_apart_y_knee_6_apart_x*y_knee_6_apart_x_4
    knee_6_apart_y_push = y_knee_6_apart_y_4/D_knee_6_apart_y
    knee_6_apart_x_push = y_knee_6_apart_x_4/D_knee_6_apart_x - knee_6_apart_y_push*l_knee_6_apart_y_knee_6_apart_x
    knee_4_apart_y_push = y_knee_4_apart_y_4/D_knee_4_apart_y - knee_6_apart_x_push*l_knee_6_apart_x_knee_4_apart_y - knee_6_apart_y_push*l_knee_6_apart_y_knee_4_apart_y
    knee_4_apart_x_push = y_knee_4_apart_x_4/D_knee_4_apart_x - knee_4_apart_y_push*l_knee_4_apart_y_knee_4_apart_x - knee_6_apart_x_push*l_knee_6_apart_x_knee_4_apart_x - knee_6_apart_y_push*l_knee_6_apart_y_knee_4_apart_x
    knee_3_apart_y_push = y_knee_3_apart_y_4/D_knee_3_apart_y - knee_4_apart_x_push*l_knee_4_apart_x_knee_3_apart_y - knee_4_apart_y_push*l_knee_4_apart_y_knee_3_apart_y - knee_6_apart_x_push*l_knee_6_apart_x_knee_3_apart_y - knee_6_apart_y_push*l_knee_6_apart_y_knee_3_apart_y
    knee_3_apart_x_push = knee_3_apart_x_wanted_rate/W_knee_3_apart_x_raised - knee_3_apart_y_push*l_knee_3_apart_y_knee_3_apart_x - knee_4_apart_x_push*l_knee_4_apart_x_knee_3_apart_x - knee_4_apart_y_push*l_knee_4_apart_y_knee_3_apart_x - knee_6_apart_x_push*l_knee_6_apart_x_knee_3_apart_x - knee_6_apart_y_push*l_knee_6_apart_y_knee_3_apart_x
    Omega_push = Omega_by_knee_6_apart_x*knee_6_apart_x_push + Omega_by_knee_6_apart_y*knee_6_apart_y_push
    epsilon_push = epsilon_by_knee_6_apart_x*knee_6_apart_x_push + epsilon_by_knee_6_apart_y*knee_6_apart_y_push
    Phi_push = Phi_by_knee_4_apart_x*knee_4_apart_x_push + Phi_by_knee_4_apart_y*knee_4_apart_y_push
    delta_push = delta_by_knee_4_apart_x*knee_4_apart_x_push + delta_by_knee_4_apart_y*knee_4_apart_y_push
    gamma_push = gamma_by_knee_3_apart_x*knee_3_apart_x_push + gamma_by_knee_3_apart_y*knee_3_apart_y_push
    Theta_push = Theta_by_knee_3_apart_x*knee_3_apart_x_push + Theta_by_knee_3_apart_y*knee_3_apart_y_push + Theta_by_knee_4_apart_x*knee_4_apart_x_push + Theta_by_knee_4_apart_y*knee_4_apart_y_push + Theta_by_knee_6_apart_x*knee_6_apart_x_push + Theta_by_knee_6_apart_y*knee_6_apart_y_push
    beta_push = beta_by_knee_3_apart_x*knee_3_apart_x_push + beta_by_knee_3_apart_y*knee_3_apart_y_push + beta_by_knee_4_apart_x*knee_4_apart_x_push + beta_by_knee_4_apart_y*knee_4_apart_y_push + beta_by_knee_6_apart_x*knee_6_apart_x_push + beta_by_knee_6_apart_y*knee_6_apart_y_push
    knee_3_apart_x_left_4 = knee_3_apart_x_wanted_rate + gamma_push*knee_3_child_arm_y - Theta_push*knee_3_x_on_Theta - beta_push*knee_3_x_on_beta
    knee_3_apart_y_left_4 = knee_3_apart_y_wanted_rate - Theta_push*knee_3_y_on_Theta - beta_push*knee_3_y_on_beta - gamma_push*knee_3_child_arm_x
    knee_4_apart_x_left_4 = knee_4_apart_x_wanted_rate + Phi_push*knee_4_child_arm_y - Theta_push*knee_4_x_on_Theta - beta_push*knee_4_x_on_beta - delta_push*knee_4_x_on_delta
    knee_4_apart_y_left_4 = knee_4_apart_y_wanted_rate - Phi_push*knee_4_child_arm_x - Theta_push*knee_4_y_on_Theta - beta_push*knee_4_y_on_beta - delta_push*knee_4_y_on_delta
    knee_6_apart_x_left_4 = knee_6_apart_x_wanted_rate + Omega_push*knee_6_child_arm_y - Theta_push*knee_6_x_on_Theta - beta_push*knee_6_x_on_beta - epsilon_push*knee_6_x_on_epsilon
    knee_6_apart_y_left_4 = knee_6_apart_y_wanted_rate - Omega_push*knee_6_child_arm_x - Theta_push*knee_6_y_on_Theta - beta_push*knee_6_y_on_beta - epsilon_push*knee_6_y_on_epsilon
    y_knee_3_apart_y_5 = knee_3_apart_y_left_4 - knee_3_apart_x_left_4*l_knee_3_apart_y_knee_3_apart_x
    y_knee_4_apart_x_5 = knee_4_apart_x_left_4 - knee_3_apart_x_left_4*l_knee_4_apart_x_knee_3_apart_x - l_knee_4_apart_x_knee_3_apart_y*y_knee_3_apart_y_5
    y_knee_4_apart_y_5 = knee_4_apart_y_left_4 - knee_3_apart_x_left_4*l_knee_4_apart_y_knee_3_apart_x - l_knee_4_apart_y_knee_3_apart_y*y_knee_3_apart_y_5 - l_knee_4_apart_y_knee_4_apart_x*y_knee_4_apart_x_5
    y_knee_6_apart_x_5 = knee_6_apart_x_left_4 - knee_3_apart_x_left_4*l_knee_6_apart_x_knee_3_apart_x - l_knee_6_apart_x_knee_3_apart_y*y_knee_3_apart_y_5 - l_knee_6_apart_x_knee_4_apart_x*y_knee_4_apart_x_5 - l_knee_6_apart_x_knee_4_apart_y*y_knee_4_apart_y_5
    y_knee_6_apart_y_5 = knee_6_apart_y_left_4 - knee_3_apart_x_left_4*l_knee_6_apart_y_knee_3_apart_x - l_knee_6_apart_y_knee_3_apart_y*y_knee_3_apart_y_5 - l_knee_6_apart_y_knee_4_apart_x*y_knee_4_apart_x_5 - l_knee_6_apart_y_knee_4_apart_y*y_knee_4_apart_y_5 - l_knee_6_apart_y_knee_6_apart_x*y_knee_6_apart_x_5
    knee_6_apart_y_push_2 = y_knee_6_apart_y_5/D_knee_6_apart_y
    knee_6_apart_x_push_2 = y_knee_6_apart_x_5/D_knee_6_apart_x - knee_6_apart_y_push_2*l_knee_6_apart_y_knee_6_apart_x
    knee_4_apart_y_push_2 = y_knee_4_apart_y_5/D_knee_4_apart_y - knee_6_apart_x_push_2*l_knee_6_apart_x_knee_4_apart_y - knee_6_apart_y_push_2*l_knee_6_apart_y_knee_4_apart_y
    knee_4_apart_x_push_2 = y_knee_4_apart_x_5/D_knee_4_apart_x - knee_4_apart_y_push_2*l_knee_4_apart_y_knee_4_apart_x - knee_6_apart_x_push_2*l_knee_6_apart_x_knee_4_apart_x - knee_6_apart_y_push_2*l_knee_6_apart_y_knee_4_apart_x
    knee_3_apart_y_push_2 = y_knee_3_apart_y_5/D_knee_3_apart_y - knee_4_apart_x_push_2*l_knee_4_apart_x_knee_3_apart_y - knee_4_apart_y_push_2*l_knee_4_apart_y_knee_3_apart_y - knee_6_apart_x_push_2*l_knee_6_apart_x_knee_3_apart_y - knee_6_apart_y_push_2*l_knee_6_apart_y_knee_3_apart_y
    knee_3_apart_x_push_2 = knee_3_apart_x_left_4/W_knee_3_apart_x_raised - knee_3_apart_y_push_2*l_knee_3_apart_y_knee_3_apart_x - knee_4_apart_x_push_2*l_knee_4_apart_x_knee_3_apart_x - knee_4_apart_y_push_2*l_knee_4_apart_y_knee_3_apart_x - knee_6_apart_x_push_2*l_knee_6_apart_x_knee_3_apart_x - knee_6_apart_y_push_2*l_knee_6_apart_y_knee_3_apart_x
    Omega_push_2 = Omega_push + Omega_by_knee_6_apart_x*knee_6_apart_x_push_2 + Omega_by_knee_6_apart_y*knee_6_apart_y_push_2
    epsilon_push_2 = epsilon_push + epsilon_by_knee_6_apart_x*knee_6_apart_x_push_2 + epsilon_by_knee_6_apart_y*knee_6_apart_y_push_2
    Phi_push_2 = Phi_push + Phi_by_knee_4_apart_x*knee_4_apart_x_push_2 + Phi_by_knee_4_apart_y*knee_4_apart_y_push_2
    delta_push_2 = delta_push + delta_by_knee_4_apart_x*knee_4_apart_x_push_2 + delta_by_knee_4_apart_y*knee_4_apart_y_push_2
    gamma_push_2 = gamma_push + gamma_by_knee_3_apart_x*knee_3_apart_x_push_2 + gamma_by_knee_3_apart_y*knee_3_apart_y_push_2
    Theta_push_2 = Theta_push + Theta_by_knee_3_apart_x*knee_3_apart_x_push_2 + Theta_by_knee_3_apart_y*knee_3_apart_y_push_2 + Theta_by_knee_4_apart_x*knee_4_apart_x_push_2 + Theta_by_knee_4_apart_y*knee_4_apart_y_push_2 + Theta_by_knee_6_apart_x*knee_6_apart_x_push_2 + Theta_by_knee_6_apart_y*knee_6_apart_y_push_2
    beta_push_2 = beta_push + beta_by_knee_3_apart_x*knee_3_apart_x_push_2 + beta_by_knee_3_apart_y*knee_3_apart_y_push_2 + beta_by_knee_4_apart_x*knee_4_apart_x_push_2 + beta_by_knee_4_apart_y*knee_4_apart_y_push_2 + beta_by_knee_6_apart_x*knee_6_apart_x_push_2 + beta_by_knee_6_apart_y*knee_6_apart_y_push_2
    knee_3_apart_x_independence, knee_3_apart_y_independence = revolute_apart_apart(W_knee_3_apart_x_raised, D_knee_3_apart_y, knee_3_apart_size)
    knee_4_apart_x_independence, knee_4_apart_y_independence = revolute_apart_apart(D_knee_4_apart_x, D_knee_4_apart_y, knee_4_apart_size)
    knee_6_apart_x_independence, knee_6_apart_y_independence = revolute_apart_apart(D_knee_6_apart_x, D_knee_6_apart_y, knee_6_apart_size)
    return (ca.vertcat(beta_push_2, Theta_push_2, gamma_push_2, delta_push_2, Phi_push_2, epsilon_push_2, Omega_push_2),
        ca.vertcat(knee_3_apart_x_independence, knee_3_apart_y_independence, knee_4_apart_x_independence, knee_4_apart_y_independence,
            knee_6_apart_x_independence, knee_6_apart_y_independence))


def ledger(t, q, speeds, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (1,): MEMORY [W]
    """
    mom = c[11]
    beta_speed = speeds[0]
    return ca.vertcat(beta_speed*mom)


def energy(t, q, speeds, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (0,): empty
    """
    rr, zt, u, sd, sc, c0, l0, xc_minus_xb, yc_minus_yb, K2_h_x = c[2], c[7], c[8], c[12], c[13], c[14], c[15], c[16], c[17], c[19]
    K4_h_y, K6_h_x, half_K1_I_z_z_2, half_K2_I_z_z, half_K3_I_z_z, half_K4_I_z_z = c[20], c[21], c[32], c[33], c[34], c[35]
    half_K5_I_z_z_2, half_K6_I_z_z, half_K7_I_z_z_2, half_m2, half_m4, half_m6 = c[36], c[37], c[38], c[39], c[40], c[41]
    beta_angle, Theta_angle, gamma_angle, delta_angle, Phi_angle, epsilon_angle, Omega_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    beta_speed, Theta_speed, gamma_speed, delta_speed, Phi_speed = speeds[0], speeds[1], speeds[2], speeds[3], speeds[4]
    epsilon_speed, Omega_speed = speeds[5], speeds[6]
    cos_K1 = ca.cos(beta_angle)
    sin_K1 = ca.sin(beta_angle)
    K2_angle = Theta_angle + beta_angle
    cos_K2 = ca.cos(K2_angle)
    sin_K2 = ca.sin(K2_angle)
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    cos_K5 = ca.cos(delta_angle)
    sin_K5 = ca.sin(delta_angle)
    K4_angle = Phi_angle + delta_angle
    cos_K4 = ca.cos(K4_angle)
    sin_K4 = ca.sin(K4_angle)
    cos_K7 = ca.cos(epsilon_angle)
    sin_K7 = ca.sin(epsilon_angle)
    K6_angle = Omega_angle + epsilon_angle
    cos_K6 = ca.cos(K6_angle)
    sin_K6 = ca.sin(K6_angle)
    K2_arm_x = cos_K1*rr
    K2_arm_y = sin_K1*rr
    K2_arm_rate_x = -K2_arm_y*beta_speed
    K2_arm_rate_y = K2_arm_x*beta_speed
    K2_rate_z = Theta_speed + beta_speed
    K4_arm_x = cos_K5*zt
    K4_arm_y = sin_K5*zt
    K4_arm_rate_x = -K4_arm_y*delta_speed
    K4_arm_rate_y = K4_arm_x*delta_speed
    K4_rate_z = Phi_speed + delta_speed
    K6_arm_x = sin_K7*u
    K6_arm_y = -cos_K7*u
    K6_arm_rate_x = -K6_arm_y*epsilon_speed
    K6_arm_rate_y = K6_arm_x*epsilon_speed
    K6_rate_z = Omega_speed + epsilon_speed
    spring_first_arm_x = cos_K3*sd + sin_K3*sc
    spring_first_arm_y = sin_K3*sd - cos_K3*sc
    spring_between_x = xc_minus_xb - spring_first_arm_x
    spring_between_y = yc_minus_yb - spring_first_arm_y
    spring_squared = spring_between_x*spring_between_x + spring_between_y*spring_between_y
    K2_moment_x = K2_h_x*cos_K2
    K2_moment_y = K2_h_x*sin_K2
    K4_moment_x = -K4_h_y*sin_K4
    K4_moment_y = K4_h_y*cos_K4
    K6_moment_x = K6_h_x*cos_K6
    K6_moment_y = K6_h_x*sin_K6
    kinetic = half_K1_I_z_z_2*beta_speed*beta_speed + half_K2_I_z_z*K2_rate_z*K2_rate_z + half_K3_I_z_z*gamma_speed*gamma_speed + half_K4_I_z_z*K4_rate_z*K4_rate_z + half_K5_I_z_z_2*delta_speed*delta_speed + half_K6_I_z_z*K6_rate_z*K6_rate_z + half_K7_I_z_z_2*epsilon_speed*epsilon_speed + half_m2*(K2_arm_rate_x*K2_arm_rate_x + K2_arm_rate_y*K2_arm_rate_y) + half_m4*(K4_arm_rate_x*K4_arm_rate_x + K4_arm_rate_y*K4_arm_rate_y) + half_m6*(K6_arm_rate_x*K6_arm_rate_x + K6_arm_rate_y*K6_arm_rate_y) + K2_arm_rate_y*K2_moment_x*K2_rate_z + K4_arm_rate_y*K4_moment_x*K4_rate_z + K6_arm_rate_y*K6_moment_x*K6_rate_z - K2_arm_rate_x*K2_moment_y*K2_rate_z - K4_arm_rate_x*K4_moment_y*K4_rate_z - K6_arm_rate_x*K6_moment_y*K6_rate_z
    return ca.vertcat(kinetic), ca.vertcat((ca.sqrt(spring_squared) - l0)**2*c0/2), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (21,): K1.x [m], K1.y [m], K1.z [m], K2.x [m], K2.y [m], K2.z [m], K3.x [m], K3.y [m], K3.z [m], K5.x [m], K5.y [m], K5.z
            [m], K4.x [m], K4.y [m], K4.z [m], K7.x [m], K7.y [m], K7.z [m], K6.x [m], K6.y [m], K6.z [m]
        rotations (63,): K1.R_xx [1], K1.R_xy [1], K1.R_xz [1], K1.R_yx [1], K1.R_yy [1], K1.R_yz [1], K1.R_zx [1], K1.R_zy [1], K1.R_zz
            [1], K2.R_xx [1], K2.R_xy [1], K2.R_xz [1], K2.R_yx [1], K2.R_yy [1], K2.R_yz [1], K2.R_zx [1], K2.R_zy [1], K2.R_zz [1],
            K3.R_xx [1], K3.R_xy [1], K3.R_xz [1], K3.R_yx [1], K3.R_yy [1], K3.R_yz [1], K3.R_zx [1], K3.R_zy [1], K3.R_zz [1], K5.R_xx
            [1], K5.R_xy [1], K5.R_xz [1], K5.R_yx [1], K5.R_yy [1], K5.R_yz [1], K5.R_zx [1], K5.R_zy [1], K5.R_zz [1], K4.R_xx [1],
            K4.R_xy [1], K4.R_xz [1], K4.R_yx [1], K4.R_yy [1], K4.R_yz [1], K4.R_zx [1], K4.R_zy [1], K4.R_zz [1], K7.R_xx [1], K7.R_xy
            [1], K7.R_xz [1], K7.R_yx [1], K7.R_yy [1], K7.R_yz [1], K7.R_zx [1], K7.R_zy [1], K7.R_zz [1], K6.R_xx [1], K6.R_xy [1],
            K6.R_xz [1], K6.R_yx [1], K6.R_yy [1], K6.R_yz [1], K6.R_zx [1], K6.R_zy [1], K6.R_zz [1]
    """
    rr, xb, yb, xa, ya, zt, u = c[2], c[3], c[4], c[5], c[6], c[7], c[8]
    beta_angle, Theta_angle, gamma_angle, delta_angle, Phi_angle, epsilon_angle, Omega_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    cos_K1 = ca.cos(beta_angle)
    sin_K1 = ca.sin(beta_angle)
    K2_angle = Theta_angle + beta_angle
    cos_K2 = ca.cos(K2_angle)
    sin_K2 = ca.sin(K2_angle)
    cos_K3 = ca.cos(gamma_angle)
    sin_K3 = ca.sin(gamma_angle)
    cos_K5 = ca.cos(delta_angle)
    sin_K5 = ca.sin(delta_angle)
    K4_angle = Phi_angle + delta_angle
    cos_K4 = ca.cos(K4_angle)
    sin_K4 = ca.sin(K4_angle)
    cos_K7 = ca.cos(epsilon_angle)
    sin_K7 = ca.sin(epsilon_angle)
    K6_angle = Omega_angle + epsilon_angle
    cos_K6 = ca.cos(K6_angle)
    sin_K6 = ca.sin(K6_angle)
    K2_arm_x = cos_K1*rr
    K2_arm_y = sin_K1*rr
    K4_arm_x = cos_K5*zt
    K4_arm_y = sin_K5*zt
    K4_x = K4_arm_x + xa
    K4_y = K4_arm_y + ya
    K6_arm_x = sin_K7*u
    K6_arm_y = -cos_K7*u
    K6_x = K6_arm_x + xa
    K6_y = K6_arm_y + ya
    return (ca.vertcat(0, 0, 0, K2_arm_x, K2_arm_y, 0, xb, yb, 0, xa, ya, 0, K4_x, K4_y, 0, xa, ya, 0, K6_x, K6_y, 0),
        ca.vertcat(cos_K1, -sin_K1, 0, sin_K1, cos_K1, 0, 0, 0, 1, cos_K2, -sin_K2, 0, sin_K2, cos_K2, 0, 0, 0, 1, cos_K3, -sin_K3, 0,
            sin_K3, cos_K3, 0, 0, 0, 1, cos_K5, -sin_K5, 0, sin_K5, cos_K5, 0, 0, 0, 1, cos_K4, -sin_K4, 0, sin_K4, cos_K4, 0, 0, 0, 1,
            cos_K7, -sin_K7, 0, sin_K7, cos_K7, 0, 0, 0, 1, cos_K6, -sin_K6, 0, sin_K6, cos_K6, 0, 0, 0, 1))


def outputs(t, q, speeds, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; speeds: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (0,): empty
    """
    return ca.vertcat()


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        beta.parent to motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        spring.first to K6.centre (3,): x [m], y [m], z [m]
    """
    ra, da, sb, sa, ta, tb, e, ea, ua, ub, fa, zf = p[2], p[5], p[8], p[9], p[12], p[13], p[16], p[17], p[20], p[21], p[24], p[25]
    rr, xb, yb, xa, ya, zt, u, d, ss, sd, sc, xc = p[26], p[27], p[28], p[29], p[30], p[31], p[32], p[33], p[34], p[36], p[37], p[38]
    yc = p[39]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(rr, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(xb, yb, 0, 0, 0,
            1),
        ca.vertcat(*[0]*5, 1), ca.vertcat(xa, ya, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(zt, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(xa, ya, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, -u, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(-d, 0, 0, 0, 0, 1), ca.vertcat(0, -ss, 0, 0, 0, 1), ca.vertcat(-d, 0, 0, 0, 0, 1), ca.vertcat(0, -e, 0, 0, 0, 1),
        ca.vertcat(-d, 0, 0, 0, 0, 1), ca.vertcat(zf, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(sd, -sc, 0), ca.vertcat(xc, yc, 0),
        ca.vertcat(ra, 0, 0), ca.vertcat(-da, 0, 0), ca.vertcat(sb, -sa, 0), ca.vertcat(ta, tb, 0), ca.vertcat(0, ea - e, 0),
        ca.vertcat(ua, -ub, 0), ca.vertcat(zf - fa, 0, 0))
