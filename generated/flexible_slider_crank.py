"""flexible_slider_crank: slider-crank whose coupler bends. Generated from derive/scenes/flexible_slider_crank.py.

Do not edit; regenerate with `hertzwerk derive flexible_slider_crank`.
Effects:
    crank_drive: constant speed of main_bearing
    energy_ledger: work put in, energy dissipated per effect
    coupler_elasticity: elasticity of the rod coupler
Units: 289 assignments and 315 outputs checked, all consistent
Operations: flight 626 (equations of motion and gaps)
"""

import casadi as ca

NAME = "flexible_slider_crank"
SOURCE = "derive/scenes/flexible_slider_crank.py"
SUMMARY = "slider-crank whose coupler bends"
FORMAT = "hertzwerk module 1"
DIGEST = "03c63e4a4938eb58e467b5ad33320fa0"

EFFECTS = (
    ("crank_drive", "drive", "constant speed of main_bearing"), ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
    ("coupler_elasticity", "rod_elasticity", "elasticity of the rod coupler"),
)

PARAMETERS = (
    ("crank_mass", "kg", 0.36, "body crank, mass"),
    ("crank_inertia", "kg m^2", 0.000702, "body crank, inertia"),
    ("crank_length", "m", 0.15, "point of crank"),
    ("coupler_width", "mm", 8, "side of the square section"),
    ("coupler_length", "m", 0.3, "joint coupler, length"),
    ("density", "kg/m^3", 7870, ""),
    ("slider_mass", "kg", 0.075552, "body slider, mass"),
    ("youngs_modulus", "GPa", 200, ""),
    ("damping_ratio", "1", 0, "joint coupler, damping ratio"),
    ("crank_speed", "rad/s", 150, "constant speed of the crank"),
    ("deflection", "mm", 1, "scale of the deflection"),
    ("vibration", "m/s", 1, "scales, speed"),
)

LIMITS = (
    ("crank_mass", "defined", 0, None, True, False, "body crank, mass"),
    ("crank_inertia", "defined", 0, None, False, False, "body crank, inertia"),
    ("slider_mass", "defined", 0, None, True, False, "body slider, mass"),
    ("coupler_length", "defined", 0, None, True, False, "joint coupler, length"),
    ("damping_ratio", "defined", 0, None, False, False, "joint coupler, damping ratio"),
    ("deflection", "defined", 0, None, True, False, "scales, length"),
    ("vibration", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("crank_pin.angle", "rad"), ("coupler.bend_1", "m"), ("coupler.bend_2", "m"), ("coupler.bend_3", "m"), ("guide.travel", "m"))

SPEEDS = (
    ("crank_pin.speed", "rad/s"), ("coupler.bend_1_speed", "m/s"), ("coupler.bend_2_speed", "m/s"), ("coupler.bend_3_speed", "m/s"),
    ("guide.speed", "m/s"),
)

MEMORY = (("energy_ledger.input", "J"), ("coupler_elasticity.dissipated", "J"))

CONSTRAINTS = (("slider_pin.apart_x", "m"), ("slider_pin.apart_y", "m"))

GIVEN = ("coupler.bend_1", "coupler.bend_2", "coupler.bend_3", "coupler.bend_1_speed", "coupler.bend_2_speed", "coupler.bend_3_speed")

OUTPUTS = (
    ("coupler.deflection_0", "m"), ("coupler.sag_0", "m"), ("coupler.moment_0", "N m"), ("coupler.stress_0", "Pa"),
    ("coupler.deflection_50", "m"), ("coupler.sag_50", "m"), ("coupler.moment_50", "N m"), ("coupler.stress_50", "Pa"),
    ("coupler.deflection_100", "m"), ("coupler.sag_100", "m"), ("coupler.moment_100", "N m"), ("coupler.stress_100", "Pa"),
)

BODIES = ("crank", "coupler_start", "coupler_end", "slider", "coupler_25", "coupler_50", "coupler_75")

LANDMARKS = (
    ("main_bearing", "revolute", "parent", "ground", ("axis",)), ("main_bearing", "revolute", "child", "crank", ("axis",)),
    ("crank_pin", "revolute", "parent", "crank", ("axis",)), ("crank_pin", "revolute", "child", "coupler_start", ("axis",)),
    ("coupler", "flexible_rod", "parent", "coupler_start", ("along",)), ("coupler", "flexible_rod", "at_25", "coupler_25", ("along",)),
    ("coupler", "flexible_rod", "at_50", "coupler_50", ("along",)), ("coupler", "flexible_rod", "at_75", "coupler_75", ("along",)),
    ("coupler", "flexible_rod", "child", "coupler_end", ("along",)), ("guide", "prismatic", "parent", "ground", ("axis",)),
    ("guide", "prismatic", "child", "slider", ("axis",)), ("slider_pin", "revolute", "parent", "coupler_end", ("axis",)),
    ("slider_pin", "revolute", "child", "slider", ("axis",)), ("crank_drive", "turn_drive", "child", "crank", ("axis",)),
    ("crank", "body", "centre", "crank", ()), ("slider", "body", "centre", "slider", ()),
)

CONSTANTS = (
    ("crank_length", "m"), ("coupler_width", "m"), ("coupler_length", "m"), ("youngs_modulus", "Pa"), ("crank_speed", "1/s"), ("k1", "1/m"),
    ("k2", "1/m"), ("k3", "1/m"), ("k4", "1/m"), ("k5", "1/m"), ("k6", "1/m"), ("k7", "1/m"), ("k8", "N/m"), ("k9", "N/m"), ("k10", "N/m"),
    ("k11", "N s/m"), ("k12", "N s/m"), ("k13", "N s/m"), ("k14", "kg/m"), ("k15", "kg/m"), ("k16", "kg/m"), ("k17", "kg/m"),
    ("k18", "kg/m"), ("k19", "kg/m"), ("k20", "kg"), ("k21", "kg"), ("k22", "kg"), ("k23", "kg"), ("k24", "kg"), ("k25", "kg"),
    ("k26", "kg"), ("k27", "kg"), ("k28", "kg"), ("k29", "kg m"), ("k30", "kg m"), ("k31", "kg m"), ("k32", "kg"), ("k33", "kg"),
    ("k34", "kg"), ("k35", "kg"), ("k36", "kg"), ("k37", "kg"), ("k38", "kg m"), ("crank_rate_zz", "1/s^2"), ("k39", "kg m^2"),
    ("l_coupler_bend_2_coupler_bend_3", "1"), ("l_coupler_bend_1_coupler_bend_3", "1"), ("l_coupler_bend_1_coupler_bend_2", "1"),
    ("l_crank_pin_coupler_bend_3", "m"), ("l_crank_pin_coupler_bend_2", "m"), ("l_crank_pin_coupler_bend_1", "m"), ("k40", "kg m^2"),
    ("inverse_D_coupler_bend_1", "1/kg"), ("inverse_D_coupler_bend_2", "1/kg"), ("k43", "1/kg"), ("inverse_slider_mass", "1/kg"),
    ("half_slider_mass", "kg"), ("k46", "kg"), ("half_crank_I_z_z_2_times_crank_speed_squared", "J"), ("k50", "1/m"), ("k51", "1/m"),
    ("k52", "1/m"), ("k53", "1/m"), ("k54", "1/m"), ("k55", "1/m"), ("k56", "1/m"), ("slider_pin_apart_x_softness", "1"),
    ("slider_pin_apart_y_softness", "1"),
)

OPERATIONS = (
    ("constants", 173), ("start", 0), ("scales", 11), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 12),
    ("accelerations", 614), ("constraints", 76), ("projection", 264), ("ledger", 9), ("energy", 174), ("poses", 153), ("outputs", 27),
    ("period", 3), ("landmarks", 1),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = PAIRS = EVENTS = LOADS = FED = ()
RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (68,): crank_length, coupler_width, coupler_length, youngs_modulus, crank_speed, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11,
            k12, k13, k14, k15, k16, k17, k18, k19, k20, k21, k22, k23, k24, k25, k26, k27, k28, k29, k30, k31, k32, k33, k34, k35, k36,
            k37, k38, crank_rate_zz, k39, l_coupler_bend_2_coupler_bend_3, l_coupler_bend_1_coupler_bend_3, l_coupler_bend_1_coupler_bend_2,
            l_crank_pin_coupler_bend_3, l_crank_pin_coupler_bend_2, l_crank_pin_coupler_bend_1, k40, inverse_D_coupler_bend_1,
            inverse_D_coupler_bend_2, k43, inverse_slider_mass, half_slider_mass, k46, half_crank_I_z_z_2_times_crank_speed_squared, k50,
            k51, k52, k53, k54, k55, k56, slider_pin_apart_x_softness, slider_pin_apart_y_softness
    """
    crank_mass, crank_inertia, crank_length, coupler_width, coupler_length, density, slider_mass = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    youngs_modulus, damping_ratio, crank_speed = p[7], p[8], p[9]
    k1 = 19.739208802178716/coupler_length
    k2 = 14.804406601634039/coupler_length
    k3 = 29.608813203268078/coupler_length
    k4 = 59.217626406536155/coupler_length
    k5 = 133.23965941470635/coupler_length
    k6 = 6.283185307179586/coupler_length
    k7 = 18.84955592153876/coupler_length
    inverse_coupler_length_cubed = 1/(coupler_length*coupler_length*coupler_length)
    coupler_width_to_the_4 = coupler_width**4
    k8 = 4.0587121264167685*inverse_coupler_length_cubed*coupler_width_to_the_4*youngs_modulus
    k9 = 64.9393940226683*inverse_coupler_length_cubed*coupler_width_to_the_4*youngs_modulus
    k10 = 328.75568223975824*inverse_coupler_length_cubed*coupler_width_to_the_4*youngs_modulus
    sqrt_3 = ca.sqrt(3)
    inverse_coupler_length_to_the_4 = 1/coupler_length**4
    x5 = inverse_coupler_length_to_the_4*youngs_modulus/density
    x6 = 1/ca.sqrt(x5)
    x7 = ca.fabs(coupler_width)
    k11 = 1.6449340668482262*inverse_coupler_length_cubed*coupler_width_to_the_4*sqrt_3*x6*damping_ratio*youngs_modulus/x7
    k12 = 6.579736267392905*inverse_coupler_length_cubed*coupler_width_to_the_4*sqrt_3*x6*damping_ratio*youngs_modulus/x7
    k13 = 14.804406601634037*inverse_coupler_length_cubed*coupler_width_to_the_4*sqrt_3*x6*damping_ratio*youngs_modulus/x7
    coupler_width_squared = coupler_width*coupler_width
    k14 = 8.137739934967371*coupler_width_squared*density
    k15 = 8.091826623311581*coupler_width_squared*density
    k16 = 3.402203300817019*coupler_width_squared*density
    k17 = 29.608813203268078*coupler_width_squared*density
    k18 = 34.515479869934744*coupler_width_squared*density
    k19 = 62.61982970735317*coupler_width_squared*density
    k20 = 3.141592653589793*coupler_width_squared*coupler_length*density
    k21 = 4.500182389595496*coupler_width_squared*coupler_length*density
    k22 = 0.9341765544273153*coupler_width_squared*coupler_length*density
    k23 = 6.190847378504017*coupler_width_squared*coupler_length*density
    k24 = 2.8098022005446794*coupler_width_squared*coupler_length*density
    k25 = 6.067521067756025*coupler_width_squared*coupler_length*density
    k26 = 21.614208802178716*coupler_width_squared*coupler_length*density
    k27 = 23.69254213551205*coupler_width_squared*coupler_length*density
    k28 = 42.28821980490211*coupler_width_squared*coupler_length*density
    coupler_length_squared = coupler_length*coupler_length
    k29 = 3.0354893581951963*coupler_width_squared*coupler_length_squared*density
    k30 = 2.253550045485091*coupler_width_squared*coupler_length_squared*density
    k31 = 0.7288876650128071*coupler_width_squared*coupler_length_squared*density
    k32 = 1.7898681336964528*coupler_width_squared*coupler_length*density
    k33 = 5.079736267392906*coupler_width_squared*coupler_length*density
    k34 = 6.536271067756025*coupler_width_squared*coupler_length*density
    k35 = 20.57254213551205*coupler_width_squared*coupler_length*density
    k36 = 15.659472534785811*coupler_width_squared*coupler_length*density
    k37 = 28.108813203268078*coupler_width_squared*coupler_length*density
    k38 = coupler_width_squared*coupler_length_squared*density/2
    crank_rate_zz = crank_speed*crank_speed
    k39 = coupler_width_squared*coupler_length*coupler_length*coupler_length*density/3
    l_coupler_bend_2_coupler_bend_3 = k35/k37
    D_coupler_bend_2 = k36 - k35*l_coupler_bend_2_coupler_bend_3
    l_coupler_bend_1_coupler_bend_3 = k34/k37
    L_coupler_bend_1_coupler_bend_2 = k33 - k34*l_coupler_bend_2_coupler_bend_3
    l_coupler_bend_1_coupler_bend_2 = L_coupler_bend_1_coupler_bend_2/D_coupler_bend_2
    D_coupler_bend_1 = k32 - L_coupler_bend_1_coupler_bend_2*l_coupler_bend_1_coupler_bend_2 - k34*l_coupler_bend_1_coupler_bend_3
    l_crank_pin_coupler_bend_3 = -k29/k37
    L_crank_pin_coupler_bend_2 = k29*l_coupler_bend_2_coupler_bend_3 - k30
    l_crank_pin_coupler_bend_2 = L_crank_pin_coupler_bend_2/D_coupler_bend_2
    L_crank_pin_coupler_bend_1 = k29*l_coupler_bend_1_coupler_bend_3 - k31 - L_crank_pin_coupler_bend_2*l_coupler_bend_1_coupler_bend_2
    l_crank_pin_coupler_bend_1 = L_crank_pin_coupler_bend_1/D_coupler_bend_1
    k40 = k29*l_crank_pin_coupler_bend_3 - L_crank_pin_coupler_bend_1*l_crank_pin_coupler_bend_1 - L_crank_pin_coupler_bend_2*l_crank_pin_coupler_bend_2
    inverse_D_coupler_bend_1 = 1/D_coupler_bend_1
    inverse_D_coupler_bend_2 = 1/D_coupler_bend_2
    k43 = 1/k37
    inverse_slider_mass = 1/slider_mass
    crank_I_z_z_2 = crank_length*crank_length*crank_mass/4 + crank_inertia
    half_slider_mass = slider_mass/2
    k46 = coupler_width_squared*coupler_length*density/2
    half_crank_I_z_z_2_times_crank_speed_squared = crank_I_z_z_2*crank_rate_zz/2
    k50 = 0.9201511845106101/coupler_length
    k51 = 16.08910236800693/coupler_length
    k52 = 3.141592653589793/coupler_length
    k53 = 12.566370614359172/coupler_length
    k54 = 9.42477796076938/coupler_length
    k55 = 2.76045355353183/coupler_length
    k56 = 5.363034122668976/coupler_length
    return ca.vertcat(crank_length, coupler_width, coupler_length, youngs_modulus, crank_speed, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10,
        k11, k12, k13, k14, k15, k16, k17, k18, k19, k20, k21, k22, k23, k24, k25, k26, k27, k28, k29, k30, k31, k32, k33, k34, k35, k36,
        k37, k38, crank_rate_zz, k39, l_coupler_bend_2_coupler_bend_3, l_coupler_bend_1_coupler_bend_3, l_coupler_bend_1_coupler_bend_2,
        l_crank_pin_coupler_bend_3, l_crank_pin_coupler_bend_2, l_crank_pin_coupler_bend_1, k40, inverse_D_coupler_bend_1,
        inverse_D_coupler_bend_2, k43, inverse_slider_mass, half_slider_mass, k46, half_crank_I_z_z_2_times_crank_speed_squared, k50, k51,
        k52, k53, k54, k55, k56, 3e-09, 3e-09)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (5,): COORDINATES
        u (5,): SPEEDS
    """
    return ca.vertcat(*[0]*5), ca.vertcat(*[0]*5)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (5,): COORDINATES
        su (5,): SPEEDS
        sz (2,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    crank_mass, coupler_width, coupler_length, density, slider_mass, deflection, vibration = p[0], p[3], p[4], p[5], p[6], p[10], p[11]
    total_mass = coupler_width*coupler_width*coupler_length*density + crank_mass + slider_mass
    energy_scale = total_mass*vibration*vibration/2
    force_scale = energy_scale/deflection
    return (ca.vertcat(deflection/coupler_length, deflection, deflection, deflection, deflection),
        ca.vertcat(vibration/coupler_length, vibration, vibration, vibration, vibration), ca.vertcat(energy_scale, energy_scale),
        ca.vertcat(deflection, vibration, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (5,): crank_pin.angle [rad/s], coupler.bend_1 [m/s], coupler.bend_2 [m/s], coupler.bend_3 [m/s], guide.travel [m/s]
    """
    crank_pin_speed, coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    return ca.vertcat(crank_pin_speed, coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed, guide_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G, dG (0,): empty
    """
    return ca.vertcat(), ca.vertcat()


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (0,): empty
    """
    return ca.vertcat()


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): crank_pin [N m], coupler.bend_1 [N], coupler.bend_2 [N], coupler.bend_3 [N], guide [N], main_bearing [N m]
    """
    k8, k9, k10, k11, k12, k13 = c[12], c[13], c[14], c[15], c[16], c[17]
    coupler_bend_1, coupler_bend_2, coupler_bend_3 = q[1], q[2], q[3]
    coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed = u[1], u[2], u[3]
    coupler_bent = coupler_bend_1*k8
    coupler_bent_2 = coupler_bend_2*k9
    coupler_bent_3 = coupler_bend_3*k10
    coupler_damped = coupler_bend_1_speed*k11
    coupler_damped_2 = coupler_bend_2_speed*k12
    coupler_damped_3 = coupler_bend_3_speed*k13
    return ca.vertcat(0, -coupler_bent - coupler_damped, -coupler_bent_2 - coupler_damped_2, -coupler_bent_3 - coupler_damped_3, 0, 0)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (5,): crank_pin.acceleration [rad/s^2], coupler.bend_1_acceleration [m/s^2], coupler.bend_2_acceleration [m/s^2],
            coupler.bend_3_acceleration [m/s^2], guide.acceleration [m/s^2]
        reactions (1,): main_bearing.reaction [N m]
        multipliers (2,): CONSTRAINTS [N]
    """
    crank_length, coupler_length, crank_speed, k1, k2, k3, k4, k5, k6, k7 = c[0], c[2], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]
    k14, k15, k16, k17, k18, k19, k20, k21, k22, k23, k24 = c[18], c[19], c[20], c[21], c[22], c[23], c[24], c[25], c[26], c[27], c[28]
    k25, k26, k27, k28, k29, k30, k31, k32, k33, k34, k35 = c[29], c[30], c[31], c[32], c[33], c[34], c[35], c[36], c[37], c[38], c[39]
    k36, k37, k38, crank_rate_zz, k39, l_coupler_bend_2_coupler_bend_3 = c[40], c[41], c[42], c[43], c[44], c[45]
    l_coupler_bend_1_coupler_bend_3, l_coupler_bend_1_coupler_bend_2, l_crank_pin_coupler_bend_3 = c[46], c[47], c[48]
    l_crank_pin_coupler_bend_2, l_crank_pin_coupler_bend_1, k40, inverse_D_coupler_bend_1 = c[49], c[50], c[51], c[52]
    inverse_D_coupler_bend_2, k43, inverse_slider_mass, slider_pin_apart_x_softness = c[53], c[54], c[55], c[66]
    slider_pin_apart_y_softness = c[67]
    crank_pin_angle, coupler_bend_1, coupler_bend_2, coupler_bend_3, guide_travel = q[0], q[1], q[2], q[3], q[4]
    crank_pin_speed, coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed = u[0], u[1], u[2], u[3]
    crank_pin_force, coupler_bend_1_force, coupler_bend_2_force, coupler_bend_3_force, guide_force = f[0], f[1], f[2], f[3], f[4]
    main_bearing_force = f[5]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_start_angle = crank_angle + crank_pin_angle
    cos_coupler_start = ca.cos(coupler_start_angle)
    sin_coupler_start = ca.sin(coupler_start_angle)
    coupler_drawn_in = coupler_bend_1*k2 + coupler_bend_2*k1 + coupler_bend_3*k3
    x1 = coupler_bend_2*k4
    coupler_drawn_in_2 = x1 + coupler_bend_1*k1 + coupler_bend_3*k4
    coupler_drawn_in_3 = x1 + coupler_bend_1*k3 + coupler_bend_3*k5
    coupler_deflection = -3.141592653589793*coupler_bend_1 - 6.283185307179586*coupler_bend_2 - 9.42477796076938*coupler_bend_3
    coupler_tip_x = coupler_length - coupler_bend_1*coupler_drawn_in/2 - coupler_bend_2*coupler_drawn_in_2/2 - coupler_bend_3*coupler_drawn_in_3/2
    coupler_start_arm_x = cos_crank*crank_length
    coupler_start_arm_y = sin_crank*crank_length
    coupler_start_arm_rate_x = -coupler_start_arm_y*crank_speed
    coupler_start_arm_rate_y = coupler_start_arm_x*crank_speed
    coupler_start_rate_z = crank_pin_speed + crank_speed
    coupler_start_acceleration_x = -coupler_start_arm_rate_y*crank_speed
    coupler_start_acceleration_y = coupler_start_arm_rate_x*crank_speed
    coupler_end_arm_x = cos_coupler_start*coupler_tip_x - coupler_deflection*sin_coupler_start
    coupler_end_arm_y = cos_coupler_start*coupler_deflection + coupler_tip_x*sin_coupler_start
    coupler_end_arm_rate_x = -coupler_end_arm_y*coupler_start_rate_z
    coupler_end_arm_rate_y = coupler_end_arm_x*coupler_start_rate_z
    coupler_end_velocity_x = -coupler_bend_1_speed*coupler_drawn_in - coupler_bend_2_speed*coupler_drawn_in_2 - coupler_bend_3_speed*coupler_drawn_in_3
    coupler_end_velocity_y = -3.141592653589793*coupler_bend_1_speed - 6.283185307179586*coupler_bend_2_speed - 9.42477796076938*coupler_bend_3_speed
    coupler_drawing_in = coupler_bend_1_speed*k2 + coupler_bend_2_speed*k1 + coupler_bend_3_speed*k3
    x2 = coupler_bend_2_speed*k4
    coupler_drawing_in_2 = x2 + coupler_bend_1_speed*k1 + coupler_bend_3_speed*k4
    coupler_drawing_in_3 = x2 + coupler_bend_1_speed*k3 + coupler_bend_3_speed*k5
    coupler_end_bias_x = -coupler_bend_1_speed*coupler_drawing_in - coupler_bend_2_speed*coupler_drawing_in_2 - coupler_bend_3_speed*coupler_drawing_in_3
    coupler_end_end_velocity_x = cos_coupler_start*coupler_end_velocity_x - coupler_end_velocity_y*sin_coupler_start
    coupler_end_end_velocity_y = cos_coupler_start*coupler_end_velocity_y + coupler_end_velocity_x*sin_coupler_start
    coupler_end_end_bias_x = cos_coupler_start*coupler_end_bias_x
    coupler_end_end_bias_y = coupler_end_bias_x*sin_coupler_start
    coupler_end_x = coupler_end_arm_x + coupler_start_arm_x
    coupler_end_y = coupler_end_arm_y + coupler_start_arm_y
    coupler_end_bias_x_2 = coupler_end_end_bias_x + coupler_start_acceleration_x - coupler_end_arm_rate_y*coupler_start_rate_z - 2*coupler_end_end_velocity_y*coupler_start_rate_z
    coupler_end_bias_y = coupler_end_end_bias_y + coupler_start_acceleration_y + coupler_end_arm_rate_x*coupler_start_rate_z + 2*coupler_end_end_velocity_x*coupler_start_rate_z
    slider_pin_apart_x = guide_travel - coupler_end_x
    slider_pin_x_on_coupler_bend_1 = cos_coupler_start*coupler_drawn_in + coupler_end_y*k6 - 3.141592653589793*sin_coupler_start
    slider_pin_x_on_coupler_bend_2 = cos_coupler_start*coupler_drawn_in_2 - 6.283185307179586*sin_coupler_start
    slider_pin_x_on_coupler_bend_3 = cos_coupler_start*coupler_drawn_in_3 + coupler_end_y*k7 - 9.42477796076938*sin_coupler_start
    slider_pin_y_on_crank_pin = coupler_start_arm_x - guide_travel
    slider_pin_y_on_coupler_bend_1 = 3.141592653589793*cos_coupler_start + coupler_drawn_in*sin_coupler_start + k6*slider_pin_apart_x
    slider_pin_y_on_coupler_bend_2 = 6.283185307179586*cos_coupler_start + coupler_drawn_in_2*sin_coupler_start
    slider_pin_y_on_coupler_bend_3 = 9.42477796076938*cos_coupler_start + coupler_drawn_in_3*sin_coupler_start + k7*slider_pin_apart_x
    coupler_sunk = coupler_bend_1*k16 + coupler_bend_2*k15 + coupler_bend_3*k14
    coupler_sunk_2 = coupler_bend_1*k15 + coupler_bend_2*k17 + coupler_bend_3*k18
    coupler_sunk_3 = coupler_bend_1*k14 + coupler_bend_2*k18 + coupler_bend_3*k19
    coupler_aside = -coupler_bend_1*k22 - coupler_bend_2*k20 - coupler_bend_3*k21
    coupler_bent_moment_x = -coupler_bend_1*coupler_sunk/2 - coupler_bend_2*coupler_sunk_2/2 - coupler_bend_3*coupler_sunk_3/2
    coupler_stiffened = coupler_bend_1*k24 + coupler_bend_2*k23 + coupler_bend_3*k25
    coupler_stiffened_2 = coupler_bend_1*k23 + coupler_bend_2*k26 + coupler_bend_3*k27
    coupler_stiffened_3 = coupler_bend_1*k25 + coupler_bend_2*k27 + coupler_bend_3*k28
    coupler_weighed = coupler_bend_1*k32 + coupler_bend_2*k33 + coupler_bend_3*k34
    coupler_weighed_2 = coupler_bend_1*k33 + coupler_bend_2*k36 + coupler_bend_3*k35
    coupler_weighed_3 = coupler_bend_1*k34 + coupler_bend_2*k35 + coupler_bend_3*k37
    coupler_bent_inertia_z_z = coupler_bend_1*coupler_weighed + coupler_bend_2*coupler_weighed_2 + coupler_bend_3*coupler_weighed_3 - coupler_bend_1*coupler_stiffened - coupler_bend_2*coupler_stiffened_2 - coupler_bend_3*coupler_stiffened_3
    coupler_start_h_x = coupler_bent_moment_x + k38
    coupler_start_moment_x = cos_coupler_start*coupler_start_h_x - coupler_aside*sin_coupler_start
    coupler_start_moment_y = cos_coupler_start*coupler_aside + coupler_start_h_x*sin_coupler_start
    coupler_start_rate_zz = coupler_start_rate_z*coupler_start_rate_z
    coupler_start_bias_x = -coupler_start_arm_x*crank_rate_zz
    coupler_start_bias_y = -coupler_start_arm_y*crank_rate_zz
    coupler_sinking = coupler_bend_1_speed*k16 + coupler_bend_2_speed*k15 + coupler_bend_3_speed*k14
    coupler_sinking_2 = coupler_bend_1_speed*k15 + coupler_bend_2_speed*k17 + coupler_bend_3_speed*k18
    coupler_sinking_3 = coupler_bend_1_speed*k14 + coupler_bend_2_speed*k18 + coupler_bend_3_speed*k19
    coupler_momentum_x = -coupler_bend_1_speed*coupler_sunk - coupler_bend_2_speed*coupler_sunk_2 - coupler_bend_3_speed*coupler_sunk_3
    coupler_momentum_y = -coupler_bend_1_speed*k22 - coupler_bend_2_speed*k20 - coupler_bend_3_speed*k21
    coupler_bent_inertia_rate_z_z = 2*coupler_bend_1_speed*coupler_weighed + 2*coupler_bend_2_speed*coupler_weighed_2 + 2*coupler_bend_3_speed*coupler_weighed_3 - 2*coupler_bend_1_speed*coupler_stiffened - 2*coupler_bend_2_speed*coupler_stiffened_2 - 2*coupler_bend_3_speed*coupler_stiffened_3
    coupler_bias_x = -coupler_bend_1_speed*coupler_sinking - coupler_bend_2_speed*coupler_sinking_2 - coupler_bend_3_speed*coupler_sinking_3 - 2*coupler_momentum_y*coupler_start_rate_z
    coupler_bias_y = 2*coupler_momentum_x*coupler_start_rate_z
    coupler_twist_z = coupler_bent_inertia_rate_z_z*coupler_start_rate_z
    coupler_passed_bias_x = cos_coupler_start*coupler_bias_x - coupler_bias_y*sin_coupler_start
    coupler_passed_bias_y = cos_coupler_start*coupler_bias_y + coupler_bias_x*sin_coupler_start
    coupler_start_torque_z = coupler_twist_z + coupler_start_bias_y*coupler_start_moment_x - coupler_start_bias_x*coupler_start_moment_y
    crank_pin_net = crank_pin_force - coupler_start_torque_z
    coupler_start_bias_x_2 = cos_coupler_start*coupler_start_bias_x + coupler_start_bias_y*sin_coupler_start
    coupler_start_bias_y_2 = cos_coupler_start*coupler_start_bias_y - coupler_start_bias_x*sin_coupler_start
    coupler_bend_1_net = coupler_bend_1_force + coupler_start_bias_x_2*coupler_sunk + coupler_start_bias_y_2*k22 + coupler_start_rate_zz*coupler_weighed - coupler_start_rate_zz*coupler_stiffened
    coupler_bend_2_net = coupler_bend_2_force + coupler_start_bias_x_2*coupler_sunk_2 + coupler_start_bias_y_2*k20 + coupler_start_rate_zz*coupler_weighed_2 - coupler_start_rate_zz*coupler_stiffened_2
    coupler_bend_3_net = coupler_bend_3_force + coupler_start_bias_x_2*coupler_sunk_3 + coupler_start_bias_y_2*k21 + coupler_start_rate_zz*coupler_weighed_3 - coupler_start_rate_zz*coupler_stiffened_3
    coupler_start_I_z_z = coupler_bent_inertia_z_z + k39
    crank_pin_coupler_start_torque_z = coupler_start_I_z_z + coupler_start_arm_x*coupler_start_moment_x + coupler_start_arm_y*coupler_start_moment_y
    coupler_bend_1_push_x = k22*sin_coupler_start - cos_coupler_start*coupler_sunk
    coupler_bend_1_push_y = -cos_coupler_start*k22 - coupler_sunk*sin_coupler_start
    coupler_bend_1_coupler_start_torque_z = coupler_bend_1_push_y*coupler_start_arm_x - k31 - coupler_bend_1_push_x*coupler_start_arm_y
    coupler_bend_2_push_x = k20*sin_coupler_start - cos_coupler_start*coupler_sunk_2
    coupler_bend_2_push_y = -cos_coupler_start*k20 - coupler_sunk_2*sin_coupler_start
    coupler_bend_2_coupler_start_torque_z = coupler_bend_2_push_y*coupler_start_arm_x - k30 - coupler_bend_2_push_x*coupler_start_arm_y
    coupler_bend_3_push_x = k21*sin_coupler_start - cos_coupler_start*coupler_sunk_3
    coupler_bend_3_push_y = -cos_coupler_start*k21 - coupler_sunk_3*sin_coupler_start
    coupler_bend_3_coupler_start_torque_z = coupler_bend_3_push_y*coupler_start_arm_x - k29 - coupler_bend_3_push_x*coupler_start_arm_y
    D_crank_pin = coupler_start_I_z_z + k40
    y_coupler_bend_2 = coupler_bend_2_net - coupler_bend_3_net*l_coupler_bend_2_coupler_bend_3
    y_coupler_bend_1 = coupler_bend_1_net - coupler_bend_3_net*l_coupler_bend_1_coupler_bend_3 - l_coupler_bend_1_coupler_bend_2*y_coupler_bend_2
    y_crank_pin = crank_pin_net - coupler_bend_3_net*l_crank_pin_coupler_bend_3 - l_crank_pin_coupler_bend_1*y_coupler_bend_1 - l_crank_pin_coupler_bend_2*y_coupler_bend_2
    crank_pin_acc = y_crank_pin/D_crank_pin
    coupler_bend_1_acc = inverse_D_coupler_bend_1*y_coupler_bend_1 - crank_pin_acc*l_crank_pin_coupler_bend_1
    coupler_bend_2_acc = inverse_D_coupler_bend_2*y_coupler_bend_2 - coupler_bend_1_acc*l_coupler_bend_1_coupler_bend_2 - crank_pin_acc*l_crank_pin_coupler_bend_2
    coupler_bend_3_acc = coupler_bend_3_net*k43 - coupler_bend_1_acc*l_coupler_bend_1_coupler_bend_3 - coupler_bend_2_acc*l_coupler_bend_2_coupler_bend_3 - crank_pin_acc*l_crank_pin_coupler_bend_3
    guide_acc = guide_force*inverse_slider_mass
    y_coupler_bend_3 = slider_pin_x_on_coupler_bend_2 - l_coupler_bend_2_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    y_coupler_bend_4 = slider_pin_x_on_coupler_bend_1 - l_coupler_bend_1_coupler_bend_2*y_coupler_bend_3 - l_coupler_bend_1_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    y_crank_pin_2 = -coupler_start_arm_y - l_crank_pin_coupler_bend_1*y_coupler_bend_4 - l_crank_pin_coupler_bend_2*y_coupler_bend_3 - l_crank_pin_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    crank_pin_by_slider_pin_apart_x = y_crank_pin_2/D_crank_pin
    coupler_bend_1_by_slider_pin_apart_x = inverse_D_coupler_bend_1*y_coupler_bend_4 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_1
    coupler_bend_2_by_slider_pin_apart_x = inverse_D_coupler_bend_2*y_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_x*l_coupler_bend_1_coupler_bend_2 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_2
    coupler_bend_3_by_slider_pin_apart_x = k43*slider_pin_x_on_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_x*l_coupler_bend_1_coupler_bend_3 - coupler_bend_2_by_slider_pin_apart_x*l_coupler_bend_2_coupler_bend_3 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_3
    y_coupler_bend_5 = slider_pin_y_on_coupler_bend_2 - l_coupler_bend_2_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    y_coupler_bend_6 = slider_pin_y_on_coupler_bend_1 - l_coupler_bend_1_coupler_bend_2*y_coupler_bend_5 - l_coupler_bend_1_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    y_crank_pin_3 = slider_pin_y_on_crank_pin - l_crank_pin_coupler_bend_1*y_coupler_bend_6 - l_crank_pin_coupler_bend_2*y_coupler_bend_5 - l_crank_pin_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    crank_pin_by_slider_pin_apart_y = y_crank_pin_3/D_crank_pin
    coupler_bend_1_by_slider_pin_apart_y = inverse_D_coupler_bend_1*y_coupler_bend_6 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_1
    coupler_bend_2_by_slider_pin_apart_y = inverse_D_coupler_bend_2*y_coupler_bend_5 - coupler_bend_1_by_slider_pin_apart_y*l_coupler_bend_1_coupler_bend_2 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_2
    coupler_bend_3_by_slider_pin_apart_y = k43*slider_pin_y_on_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_y*l_coupler_bend_1_coupler_bend_3 - coupler_bend_2_by_slider_pin_apart_y*l_coupler_bend_2_coupler_bend_3 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_3
    W_slider_pin_apart_x_slider_pin_apart_x = inverse_slider_mass + coupler_bend_1_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_3 - coupler_start_arm_y*crank_pin_by_slider_pin_apart_x
    W_slider_pin_apart_y_slider_pin_apart_x = coupler_bend_1_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_3 + crank_pin_by_slider_pin_apart_x*slider_pin_y_on_crank_pin
    W_slider_pin_apart_y_slider_pin_apart_y = coupler_bend_1_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_3 + crank_pin_by_slider_pin_apart_y*slider_pin_y_on_crank_pin
    slider_pin_apart_size = W_slider_pin_apart_x_slider_pin_apart_x + W_slider_pin_apart_y_slider_pin_apart_y
    W_slider_pin_apart_x_raised = W_slider_pin_apart_x_slider_pin_apart_x + slider_pin_apart_size*slider_pin_apart_x_softness
    W_slider_pin_apart_y_raised = W_slider_pin_apart_y_slider_pin_apart_y + slider_pin_apart_size*slider_pin_apart_y_softness
    l_slider_pin_apart_y_slider_pin_apart_x = W_slider_pin_apart_y_slider_pin_apart_x/W_slider_pin_apart_x_raised
    D_slider_pin_apart_y = W_slider_pin_apart_y_raised - W_slider_pin_apart_y_slider_pin_apart_x*l_slider_pin_apart_y_slider_pin_apart_x
    slider_pin_apart_x_left = coupler_end_bias_x_2 + coupler_start_arm_y*crank_pin_acc - guide_acc - coupler_bend_1_acc*slider_pin_x_on_coupler_bend_1 - coupler_bend_2_acc*slider_pin_x_on_coupler_bend_2 - coupler_bend_3_acc*slider_pin_x_on_coupler_bend_3
    slider_pin_apart_y_left = coupler_end_bias_y - coupler_bend_1_acc*slider_pin_y_on_coupler_bend_1 - coupler_bend_2_acc*slider_pin_y_on_coupler_bend_2 - coupler_bend_3_acc*slider_pin_y_on_coupler_bend_3 - crank_pin_acc*slider_pin_y_on_crank_pin
    y_slider_pin_apart_y = slider_pin_apart_y_left - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_x_left
    slider_pin_apart_y_acc = y_slider_pin_apart_y/D_slider_pin_apart_y
    slider_pin_apart_x_acc = slider_pin_apart_x_left/W_slider_pin_apart_x_raised - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_y_acc
    crank_pin_acc_2 = crank_pin_acc + crank_pin_by_slider_pin_apart_x*slider_pin_apart_x_acc + crank_pin_by_slider_pin_apart_y*slider_pin_apart_y_acc
    coupler_bend_1_acc_2 = coupler_bend_1_acc + coupler_bend_1_by_slider_pin_apart_x*slider_pin_apart_x_acc + coupler_bend_1_by_slider_pin_apart_y*slider_pin_apart_y_acc
    coupler_bend_2_acc_2 = coupler_bend_2_acc + coupler_bend_2_by_slider_pin_apart_x*slider_pin_apart_x_acc + coupler_bend_2_by_slider_pin_apart_y*slider_pin_apart_y_acc
    coupler_bend_3_acc_2 = coupler_bend_3_acc + coupler_bend_3_by_slider_pin_apart_x*slider_pin_apart_x_acc + coupler_bend_3_by_slider_pin_apart_y*slider_pin_apart_y_acc
    guide_acc_2 = guide_acc + inverse_slider_mass*slider_pin_apart_x_acc
    slider_pin_apart_x_left_2 = coupler_end_bias_x_2 + coupler_start_arm_y*crank_pin_acc_2 - guide_acc_2 - coupler_bend_1_acc_2*slider_pin_x_on_coupler_bend_1 - coupler_bend_2_acc_2*slider_pin_x_on_coupler_bend_2 - coupler_bend_3_acc_2*slider_pin_x_on_coupler_bend_3
    slider_pin_apart_y_left_2 = coupler_end_bias_y - coupler_bend_1_acc_2*slider_pin_y_on_coupler_bend_1 - coupler_bend_2_acc_2*slider_pin_y_on_coupler_bend_2 - coupler_bend_3_acc_2*slider_pin_y_on_coupler_bend_3 - crank_pin_acc_2*slider_pin_y_on_crank_pin
    y_slider_pin_apart_y_2 = slider_pin_apart_y_left_2 - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_x_left_2
    slider_pin_apart_y_acc_2 = y_slider_pin_apart_y_2/D_slider_pin_apart_y
    slider_pin_apart_x_acc_2 = slider_pin_apart_x_left_2/W_slider_pin_apart_x_raised - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_y_acc_2
    slider_pin_apart_x_acc_3 = slider_pin_apart_x_acc + slider_pin_apart_x_acc_2
    slider_pin_apart_y_acc_3 = slider_pin_apart_y_acc + slider_pin_apart_y_acc_2
    crank_pin_acc_3 = crank_pin_acc_2 + crank_pin_by_slider_pin_apart_x*slider_pin_apart_x_acc_2 + crank_pin_by_slider_pin_apart_y*slider_pin_apart_y_acc_2
    coupler_bend_1_acc_3 = coupler_bend_1_acc_2 + coupler_bend_1_by_slider_pin_apart_x*slider_pin_apart_x_acc_2 + coupler_bend_1_by_slider_pin_apart_y*slider_pin_apart_y_acc_2
    coupler_bend_2_acc_3 = coupler_bend_2_acc_2 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_apart_x_acc_2 + coupler_bend_2_by_slider_pin_apart_y*slider_pin_apart_y_acc_2
    coupler_bend_3_acc_3 = coupler_bend_3_acc_2 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_apart_x_acc_2 + coupler_bend_3_by_slider_pin_apart_y*slider_pin_apart_y_acc_2
    guide_acc_3 = guide_acc_2 + inverse_slider_mass*slider_pin_apart_x_acc_2
    slider_pin_apart_x_left_3 = coupler_end_bias_x_2 + coupler_start_arm_y*crank_pin_acc_3 - guide_acc_3 - coupler_bend_1_acc_3*slider_pin_x_on_coupler_bend_1 - coupler_bend_2_acc_3*slider_pin_x_on_coupler_bend_2 - coupler_bend_3_acc_3*slider_pin_x_on_coupler_bend_3
    slider_pin_apart_y_left_3 = coupler_end_bias_y - coupler_bend_1_acc_3*slider_pin_y_on_coupler_bend_1 - coupler_bend_2_acc_3*slider_pin_y_on_coupler_bend_2 - coupler_bend_3_acc_3*slider_pin_y_on_coupler_bend_3 - crank_pin_acc_3*slider_pin_y_on_crank_pin
    y_slider_pin_apart_y_3 = slider_pin_apart_y_left_3 - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_x_left_3
    slider_pin_apart_y_acc_4 = y_slider_pin_apart_y_3/D_slider_pin_apart_y
    slider_pin_apart_x_acc_4 = slider_pin_apart_x_left_3/W_slider_pin_apart_x_raised - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_y_acc_4
    slider_pin_apart_x_acc_5 = slider_pin_apart_x_acc_3 + slider_pin_apart_x_acc_4
    slider_pin_apart_y_acc_5 = slider_pin_apart_y_acc_3 + slider_pin_apart_y_acc_4
    crank_pin_acc_4 = crank_pin_acc_3 + crank_pin_by_slider_pin_apart_x*slider_pin_apart_x_acc_4 + crank_pin_by_slider_pin_apart_y*slider_pin_apart_y_acc_4
    coupler_bend_1_acc_4 = coupler_bend_1_acc_3 + coupler_bend_1_by_slider_pin_apart_x*slider_pin_apart_x_acc_4 + coupler_bend_1_by_slider_pin_apart_y*slider_pin_apart_y_acc_4
    coupler_bend_2_acc_4 = coupler_bend_2_acc_3 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_apart_x_acc_4 + coupler_bend_2_by_slider_pin_apart_y*slider_pin_apart_y_acc_4
    coupler_bend_3_acc_4 = coupler_bend_3_acc_3 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_apart_x_acc_4 + coupler_bend_3_by_slider_pin_apart_y*slider_pin_apart_y_acc_4
    guide_acc_4 = guide_acc_3 + inverse_slider_mass*slider_pin_apart_x_acc_4
    coupler_start_force_x = coupler_passed_bias_x - coupler_start_moment_x*coupler_start_rate_zz
    coupler_start_force_y = coupler_passed_bias_y - coupler_start_moment_y*coupler_start_rate_zz
    crank_torque_z = coupler_start_torque_z + coupler_start_arm_x*coupler_start_force_y - coupler_start_arm_y*coupler_start_force_x
    main_bearing_reaction = crank_torque_z + coupler_bend_1_acc_4*coupler_bend_1_coupler_start_torque_z + coupler_bend_2_acc_4*coupler_bend_2_coupler_start_torque_z + coupler_bend_3_acc_4*coupler_bend_3_coupler_start_torque_z + crank_pin_acc_4*crank_pin_coupler_start_torque_z + guide_travel*slider_pin_apart_y_acc_5 - main_bearing_force
    return (ca.vertcat(crank_pin_acc_4, coupler_bend_1_acc_4, coupler_bend_2_acc_4, coupler_bend_3_acc_4, guide_acc_4),
        ca.vertcat(main_bearing_reaction), ca.vertcat(slider_pin_apart_x_acc_5, slider_pin_apart_y_acc_5))


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (2,): CONSTRAINTS
        dphi (2,): CONSTRAINTS [m/s]
    """
    crank_length, coupler_length, crank_speed, k1, k2, k3, k4, k5 = c[0], c[2], c[4], c[5], c[6], c[7], c[8], c[9]
    crank_pin_angle, coupler_bend_1, coupler_bend_2, coupler_bend_3, guide_travel = q[0], q[1], q[2], q[3], q[4]
    crank_pin_speed, coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_start_angle = crank_angle + crank_pin_angle
    cos_coupler_start = ca.cos(coupler_start_angle)
    sin_coupler_start = ca.sin(coupler_start_angle)
    coupler_drawn_in = coupler_bend_1*k2 + coupler_bend_2*k1 + coupler_bend_3*k3
    x1 = coupler_bend_2*k4
    coupler_drawn_in_2 = x1 + coupler_bend_1*k1 + coupler_bend_3*k4
    coupler_drawn_in_3 = x1 + coupler_bend_1*k3 + coupler_bend_3*k5
    coupler_deflection = -3.141592653589793*coupler_bend_1 - 6.283185307179586*coupler_bend_2 - 9.42477796076938*coupler_bend_3
    coupler_tip_x = coupler_length - coupler_bend_1*coupler_drawn_in/2 - coupler_bend_2*coupler_drawn_in_2/2 - coupler_bend_3*coupler_drawn_in_3/2
    coupler_start_arm_x = cos_crank*crank_length
    coupler_start_arm_y = sin_crank*crank_length
    coupler_start_arm_rate_x = -coupler_start_arm_y*crank_speed
    coupler_start_arm_rate_y = coupler_start_arm_x*crank_speed
    coupler_start_rate_z = crank_pin_speed + crank_speed
    coupler_end_arm_x = cos_coupler_start*coupler_tip_x - coupler_deflection*sin_coupler_start
    coupler_end_arm_y = cos_coupler_start*coupler_deflection + coupler_tip_x*sin_coupler_start
    coupler_end_arm_rate_x = -coupler_end_arm_y*coupler_start_rate_z
    coupler_end_arm_rate_y = coupler_end_arm_x*coupler_start_rate_z
    coupler_end_velocity_x = -coupler_bend_1_speed*coupler_drawn_in - coupler_bend_2_speed*coupler_drawn_in_2 - coupler_bend_3_speed*coupler_drawn_in_3
    coupler_end_velocity_y = -3.141592653589793*coupler_bend_1_speed - 6.283185307179586*coupler_bend_2_speed - 9.42477796076938*coupler_bend_3_speed
    coupler_end_end_velocity_x = cos_coupler_start*coupler_end_velocity_x - coupler_end_velocity_y*sin_coupler_start
    coupler_end_end_velocity_y = cos_coupler_start*coupler_end_velocity_y + coupler_end_velocity_x*sin_coupler_start
    coupler_end_x = coupler_end_arm_x + coupler_start_arm_x
    coupler_end_y = coupler_end_arm_y + coupler_start_arm_y
    coupler_end_velocity_x_2 = coupler_end_arm_rate_x + coupler_end_end_velocity_x + coupler_start_arm_rate_x
    coupler_end_velocity_y_2 = coupler_end_arm_rate_y + coupler_end_end_velocity_y + coupler_start_arm_rate_y
    slider_pin_apart_x = guide_travel - coupler_end_x
    slider_pin_apart_rate_x = guide_speed - coupler_end_velocity_x_2
    return ca.vertcat(slider_pin_apart_x, -coupler_end_y), ca.vertcat(slider_pin_apart_rate_x, -coupler_end_velocity_y_2)


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (5,): SPEEDS
        independence (2,): CONSTRAINTS [1]
    """
    crank_length, coupler_length, crank_speed, k1, k2, k3, k4, k5, k6, k7 = c[0], c[2], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]
    k23, k24, k25, k26, k27, k28, k32, k33, k34, k35, k36 = c[27], c[28], c[29], c[30], c[31], c[32], c[36], c[37], c[38], c[39], c[40]
    k37, k39, l_coupler_bend_2_coupler_bend_3, l_coupler_bend_1_coupler_bend_3 = c[41], c[44], c[45], c[46]
    l_coupler_bend_1_coupler_bend_2, l_crank_pin_coupler_bend_3, l_crank_pin_coupler_bend_2 = c[47], c[48], c[49]
    l_crank_pin_coupler_bend_1, k40, inverse_D_coupler_bend_1, inverse_D_coupler_bend_2, k43 = c[50], c[51], c[52], c[53], c[54]
    inverse_slider_mass, slider_pin_apart_x_softness, slider_pin_apart_y_softness = c[55], c[66], c[67]
    crank_pin_angle, coupler_bend_1, coupler_bend_2, coupler_bend_3, guide_travel = q[0], q[1], q[2], q[3], q[4]
    slider_pin_apart_x_wanted_rate, slider_pin_apart_y_wanted_rate = wanted[0], wanted[1]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_start_angle = crank_angle + crank_pin_angle
    cos_coupler_start = ca.cos(coupler_start_angle)
    sin_coupler_start = ca.sin(coupler_start_angle)
    coupler_drawn_in = coupler_bend_1*k2 + coupler_bend_2*k1 + coupler_bend_3*k3
    x1 = coupler_bend_2*k4
    coupler_drawn_in_2 = x1 + coupler_bend_1*k1 + coupler_bend_3*k4
    coupler_drawn_in_3 = x1 + coupler_bend_1*k3 + coupler_bend_3*k5
    coupler_deflection = -3.141592653589793*coupler_bend_1 - 6.283185307179586*coupler_bend_2 - 9.42477796076938*coupler_bend_3
    coupler_tip_x = coupler_length - coupler_bend_1*coupler_drawn_in/2 - coupler_bend_2*coupler_drawn_in_2/2 - coupler_bend_3*coupler_drawn_in_3/2
    coupler_start_arm_x = cos_crank*crank_length
    coupler_start_arm_y = sin_crank*crank_length
    coupler_end_arm_x = cos_coupler_start*coupler_tip_x - coupler_deflection*sin_coupler_start
    coupler_end_arm_y = cos_coupler_start*coupler_deflection + coupler_tip_x*sin_coupler_start
    coupler_end_x = coupler_end_arm_x + coupler_start_arm_x
    coupler_end_y = coupler_end_arm_y + coupler_start_arm_y
    slider_pin_apart_x = guide_travel - coupler_end_x
    slider_pin_x_on_coupler_bend_1 = cos_coupler_start*coupler_drawn_in + coupler_end_y*k6 - 3.141592653589793*sin_coupler_start
    slider_pin_x_on_coupler_bend_2 = cos_coupler_start*coupler_drawn_in_2 - 6.283185307179586*sin_coupler_start
    slider_pin_x_on_coupler_bend_3 = cos_coupler_start*coupler_drawn_in_3 + coupler_end_y*k7 - 9.42477796076938*sin_coupler_start
    slider_pin_y_on_crank_pin = coupler_start_arm_x - guide_travel
    slider_pin_y_on_coupler_bend_1 = 3.141592653589793*cos_coupler_start + coupler_drawn_in*sin_coupler_start + k6*slider_pin_apart_x
    slider_pin_y_on_coupler_bend_2 = 6.283185307179586*cos_coupler_start + coupler_drawn_in_2*sin_coupler_start
    slider_pin_y_on_coupler_bend_3 = 9.42477796076938*cos_coupler_start + coupler_drawn_in_3*sin_coupler_start + k7*slider_pin_apart_x
    coupler_stiffened = coupler_bend_1*k24 + coupler_bend_2*k23 + coupler_bend_3*k25
    coupler_stiffened_2 = coupler_bend_1*k23 + coupler_bend_2*k26 + coupler_bend_3*k27
    coupler_stiffened_3 = coupler_bend_1*k25 + coupler_bend_2*k27 + coupler_bend_3*k28
    coupler_weighed = coupler_bend_1*k32 + coupler_bend_2*k33 + coupler_bend_3*k34
    coupler_weighed_2 = coupler_bend_1*k33 + coupler_bend_2*k36 + coupler_bend_3*k35
    coupler_weighed_3 = coupler_bend_1*k34 + coupler_bend_2*k35 + coupler_bend_3*k37
    coupler_bent_inertia_z_z = coupler_bend_1*coupler_weighed + coupler_bend_2*coupler_weighed_2 + coupler_bend_3*coupler_weighed_3 - coupler_bend_1*coupler_stiffened - coupler_bend_2*coupler_stiffened_2 - coupler_bend_3*coupler_stiffened_3
    coupler_start_I_z_z = coupler_bent_inertia_z_z + k39
    D_crank_pin = coupler_start_I_z_z + k40
    y_coupler_bend_3 = slider_pin_x_on_coupler_bend_2 - l_coupler_bend_2_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    y_coupler_bend_4 = slider_pin_x_on_coupler_bend_1 - l_coupler_bend_1_coupler_bend_2*y_coupler_bend_3 - l_coupler_bend_1_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    y_crank_pin_2 = -coupler_start_arm_y - l_crank_pin_coupler_bend_1*y_coupler_bend_4 - l_crank_pin_coupler_bend_2*y_coupler_bend_3 - l_crank_pin_coupler_bend_3*slider_pin_x_on_coupler_bend_3
    crank_pin_by_slider_pin_apart_x = y_crank_pin_2/D_crank_pin
    coupler_bend_1_by_slider_pin_apart_x = inverse_D_coupler_bend_1*y_coupler_bend_4 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_1
    coupler_bend_2_by_slider_pin_apart_x = inverse_D_coupler_bend_2*y_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_x*l_coupler_bend_1_coupler_bend_2 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_2
    coupler_bend_3_by_slider_pin_apart_x = k43*slider_pin_x_on_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_x*l_coupler_bend_1_coupler_bend_3 - coupler_bend_2_by_slider_pin_apart_x*l_coupler_bend_2_coupler_bend_3 - crank_pin_by_slider_pin_apart_x*l_crank_pin_coupler_bend_3
    y_coupler_bend_5 = slider_pin_y_on_coupler_bend_2 - l_coupler_bend_2_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    y_coupler_bend_6 = slider_pin_y_on_coupler_bend_1 - l_coupler_bend_1_coupler_bend_2*y_coupler_bend_5 - l_coupler_bend_1_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    y_crank_pin_3 = slider_pin_y_on_crank_pin - l_crank_pin_coupler_bend_1*y_coupler_bend_6 - l_crank_pin_coupler_bend_2*y_coupler_bend_5 - l_crank_pin_coupler_bend_3*slider_pin_y_on_coupler_bend_3
    crank_pin_by_slider_pin_apart_y = y_crank_pin_3/D_crank_pin
    coupler_bend_1_by_slider_pin_apart_y = inverse_D_coupler_bend_1*y_coupler_bend_6 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_1
    coupler_bend_2_by_slider_pin_apart_y = inverse_D_coupler_bend_2*y_coupler_bend_5 - coupler_bend_1_by_slider_pin_apart_y*l_coupler_bend_1_coupler_bend_2 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_2
    coupler_bend_3_by_slider_pin_apart_y = k43*slider_pin_y_on_coupler_bend_3 - coupler_bend_1_by_slider_pin_apart_y*l_coupler_bend_1_coupler_bend_3 - coupler_bend_2_by_slider_pin_apart_y*l_coupler_bend_2_coupler_bend_3 - crank_pin_by_slider_pin_apart_y*l_crank_pin_coupler_bend_3
    W_slider_pin_apart_x_slider_pin_apart_x = inverse_slider_mass + coupler_bend_1_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_x_on_coupler_bend_3 - coupler_start_arm_y*crank_pin_by_slider_pin_apart_x
    W_slider_pin_apart_y_slider_pin_apart_x = coupler_bend_1_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_x*slider_pin_y_on_coupler_bend_3 + crank_pin_by_slider_pin_apart_x*slider_pin_y_on_crank_pin
    W_slider_pin_apart_y_slider_pin_apart_y = coupler_bend_1_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_1 + coupler_bend_2_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_2 + coupler_bend_3_by_slider_pin_apart_y*slider_pin_y_on_coupler_bend_3 + crank_pin_by_slider_pin_apart_y*slider_pin_y_on_crank_pin
    slider_pin_apart_size = W_slider_pin_apart_x_slider_pin_apart_x + W_slider_pin_apart_y_slider_pin_apart_y
    W_slider_pin_apart_x_raised = W_slider_pin_apart_x_slider_pin_apart_x + slider_pin_apart_size*slider_pin_apart_x_softness
    W_slider_pin_apart_y_raised = W_slider_pin_apart_y_slider_pin_apart_y + slider_pin_apart_size*slider_pin_apart_y_softness
    l_slider_pin_apart_y_slider_pin_apart_x = W_slider_pin_apart_y_slider_pin_apart_x/W_slider_pin_apart_x_raised
    D_slider_pin_apart_y = W_slider_pin_apart_y_raised - W_slider_pin_apart_y_slider_pin_apart_x*l_slider_pin_apart_y_slider_pin_apart_x
    y_slider_pin_apart_y_4 = slider_pin_apart_y_wanted_rate - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_x_wanted_rate
    slider_pin_apart_y_push = y_slider_pin_apart_y_4/D_slider_pin_apart_y
    slider_pin_apart_x_push = slider_pin_apart_x_wanted_rate/W_slider_pin_apart_x_raised - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_y_push
    guide_push = inverse_slider_mass*slider_pin_apart_x_push
    coupler_bend_3_push = coupler_bend_3_by_slider_pin_apart_x*slider_pin_apart_x_push + coupler_bend_3_by_slider_pin_apart_y*slider_pin_apart_y_push
    coupler_bend_2_push = coupler_bend_2_by_slider_pin_apart_x*slider_pin_apart_x_push + coupler_bend_2_by_slider_pin_apart_y*slider_pin_apart_y_push
    coupler_bend_1_push = coupler_bend_1_by_slider_pin_apart_x*slider_pin_apart_x_push + coupler_bend_1_by_slider_pin_apart_y*slider_pin_apart_y_push
    crank_pin_push = crank_pin_by_slider_pin_apart_x*slider_pin_apart_x_push + crank_pin_by_slider_pin_apart_y*slider_pin_apart_y_push
    slider_pin_apart_x_left_4 = slider_pin_apart_x_wanted_rate + coupler_start_arm_y*crank_pin_push - guide_push - coupler_bend_1_push*slider_pin_x_on_coupler_bend_1 - coupler_bend_2_push*slider_pin_x_on_coupler_bend_2 - coupler_bend_3_push*slider_pin_x_on_coupler_bend_3
    slider_pin_apart_y_left_4 = slider_pin_apart_y_wanted_rate - coupler_bend_1_push*slider_pin_y_on_coupler_bend_1 - coupler_bend_2_push*slider_pin_y_on_coupler_bend_2 - coupler_bend_3_push*slider_pin_y_on_coupler_bend_3 - crank_pin_push*slider_pin_y_on_crank_pin
    y_slider_pin_apart_y_5 = slider_pin_apart_y_left_4 - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_x_left_4
    slider_pin_apart_y_push_2 = y_slider_pin_apart_y_5/D_slider_pin_apart_y
    slider_pin_apart_x_push_2 = slider_pin_apart_x_left_4/W_slider_pin_apart_x_raised - l_slider_pin_apart_y_slider_pin_apart_x*slider_pin_apart_y_push_2
    guide_push_2 = guide_push + inverse_slider_mass*slider_pin_apart_x_push_2
    coupler_bend_3_push_2 = coupler_bend_3_push + coupler_bend_3_by_slider_pin_apart_x*slider_pin_apart_x_push_2 + coupler_bend_3_by_slider_pin_apart_y*slider_pin_apart_y_push_2
    coupler_bend_2_push_2 = coupler_bend_2_push + coupler_bend_2_by_slider_pin_apart_x*slider_pin_apart_x_push_2 + coupler_bend_2_by_slider_pin_apart_y*slider_pin_apart_y_push_2
    coupler_bend_1_push_2 = coupler_bend_1_push + coupler_bend_1_by_slider_pin_apart_x*slider_pin_apart_x_push_2 + coupler_bend_1_by_slider_pin_apart_y*slider_pin_apart_y_push_2
    crank_pin_push_2 = crank_pin_push + crank_pin_by_slider_pin_apart_x*slider_pin_apart_x_push_2 + crank_pin_by_slider_pin_apart_y*slider_pin_apart_y_push_2
    slider_pin_apart_x_independence = W_slider_pin_apart_x_raised/slider_pin_apart_size
    slider_pin_apart_y_independence = D_slider_pin_apart_y/slider_pin_apart_size
    return (ca.vertcat(crank_pin_push_2, coupler_bend_1_push_2, coupler_bend_2_push_2, coupler_bend_3_push_2, guide_push_2),
        ca.vertcat(slider_pin_apart_x_independence, slider_pin_apart_y_independence))


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (2,): MEMORY [W]
    """
    crank_speed, k11, k12, k13 = c[4], c[15], c[16], c[17]
    coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed = u[1], u[2], u[3]
    main_bearing_reaction_in = reactions[0]
    coupler_damped = coupler_bend_1_speed*k11
    coupler_damped_2 = coupler_bend_2_speed*k12
    coupler_damped_3 = coupler_bend_3_speed*k13
    return ca.vertcat(main_bearing_reaction_in*crank_speed, coupler_bend_1_speed*coupler_damped + coupler_bend_2_speed*coupler_damped_2 +
        coupler_bend_3_speed*coupler_damped_3)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (0,): empty
    """
    crank_length, crank_speed, k8, k9, k10, k14, k15, k16, k17, k18 = c[0], c[4], c[12], c[13], c[14], c[18], c[19], c[20], c[21], c[22]
    k19, k20, k21, k22, k23, k24, k25, k26, k27, k28, k29 = c[23], c[24], c[25], c[26], c[27], c[28], c[29], c[30], c[31], c[32], c[33]
    k30, k31, k32, k33, k34, k35, k36, k37, k38, k39 = c[34], c[35], c[36], c[37], c[38], c[39], c[40], c[41], c[42], c[44]
    half_slider_mass, k46, half_crank_I_z_z_2_times_crank_speed_squared = c[56], c[57], c[58]
    crank_pin_angle, coupler_bend_1, coupler_bend_2, coupler_bend_3 = q[0], q[1], q[2], q[3]
    crank_pin_speed, coupler_bend_1_speed, coupler_bend_2_speed, coupler_bend_3_speed, guide_speed = u[0], u[1], u[2], u[3], u[4]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_start_angle = crank_angle + crank_pin_angle
    cos_coupler_start = ca.cos(coupler_start_angle)
    sin_coupler_start = ca.sin(coupler_start_angle)
    coupler_start_arm_x = cos_crank*crank_length
    coupler_start_arm_y = sin_crank*crank_length
    coupler_start_arm_rate_x = -coupler_start_arm_y*crank_speed
    coupler_start_arm_rate_y = coupler_start_arm_x*crank_speed
    coupler_start_rate_z = crank_pin_speed + crank_speed
    coupler_bent = coupler_bend_1*k8
    coupler_bent_2 = coupler_bend_2*k9
    coupler_bent_3 = coupler_bend_3*k10
    coupler_sunk = coupler_bend_1*k16 + coupler_bend_2*k15 + coupler_bend_3*k14
    coupler_sunk_2 = coupler_bend_1*k15 + coupler_bend_2*k17 + coupler_bend_3*k18
    coupler_sunk_3 = coupler_bend_1*k14 + coupler_bend_2*k18 + coupler_bend_3*k19
    coupler_aside = -coupler_bend_1*k22 - coupler_bend_2*k20 - coupler_bend_3*k21
    coupler_bent_moment_x = -coupler_bend_1*coupler_sunk/2 - coupler_bend_2*coupler_sunk_2/2 - coupler_bend_3*coupler_sunk_3/2
    coupler_stiffened = coupler_bend_1*k24 + coupler_bend_2*k23 + coupler_bend_3*k25
    coupler_stiffened_2 = coupler_bend_1*k23 + coupler_bend_2*k26 + coupler_bend_3*k27
    coupler_stiffened_3 = coupler_bend_1*k25 + coupler_bend_2*k27 + coupler_bend_3*k28
    coupler_weighed = coupler_bend_1*k32 + coupler_bend_2*k33 + coupler_bend_3*k34
    coupler_weighed_2 = coupler_bend_1*k33 + coupler_bend_2*k36 + coupler_bend_3*k35
    coupler_weighed_3 = coupler_bend_1*k34 + coupler_bend_2*k35 + coupler_bend_3*k37
    coupler_bent_inertia_z_z = coupler_bend_1*coupler_weighed + coupler_bend_2*coupler_weighed_2 + coupler_bend_3*coupler_weighed_3 - coupler_bend_1*coupler_stiffened - coupler_bend_2*coupler_stiffened_2 - coupler_bend_3*coupler_stiffened_3
    coupler_start_h_x = coupler_bent_moment_x + k38
    coupler_start_moment_x = cos_coupler_start*coupler_start_h_x - coupler_aside*sin_coupler_start
    coupler_start_moment_y = cos_coupler_start*coupler_aside + coupler_start_h_x*sin_coupler_start
    coupler_momentum_x = -coupler_bend_1_speed*coupler_sunk - coupler_bend_2_speed*coupler_sunk_2 - coupler_bend_3_speed*coupler_sunk_3
    coupler_momentum_y = -coupler_bend_1_speed*k22 - coupler_bend_2_speed*k20 - coupler_bend_3_speed*k21
    coupler_spin_z = -coupler_bend_1_speed*k31 - coupler_bend_2_speed*k30 - coupler_bend_3_speed*k29
    coupler_start_I_z_z = coupler_bent_inertia_z_z + k39
    coupler_weighed_rate = coupler_bend_1_speed*k32 + coupler_bend_2_speed*k33 + coupler_bend_3_speed*k34
    coupler_weighed_rate_2 = coupler_bend_1_speed*k33 + coupler_bend_2_speed*k36 + coupler_bend_3_speed*k35
    coupler_weighed_rate_3 = coupler_bend_1_speed*k34 + coupler_bend_2_speed*k35 + coupler_bend_3_speed*k37
    kinetic = half_crank_I_z_z_2_times_crank_speed_squared + coupler_spin_z*coupler_start_rate_z + coupler_start_arm_rate_x*(cos_coupler_start*coupler_momentum_x - coupler_momentum_y*sin_coupler_start) + coupler_start_arm_rate_y*(cos_coupler_start*coupler_momentum_y + coupler_momentum_x*sin_coupler_start) + half_slider_mass*guide_speed*guide_speed + k46*(coupler_start_arm_rate_x*coupler_start_arm_rate_x + coupler_start_arm_rate_y*coupler_start_arm_rate_y) + coupler_bend_1_speed*coupler_weighed_rate/2 + coupler_bend_2_speed*coupler_weighed_rate_2/2 + coupler_bend_3_speed*coupler_weighed_rate_3/2 + coupler_start_I_z_z*coupler_start_rate_z*coupler_start_rate_z/2 + coupler_start_arm_rate_y*coupler_start_moment_x*coupler_start_rate_z - coupler_start_arm_rate_x*coupler_start_moment_y*coupler_start_rate_z
    return (ca.vertcat(kinetic), ca.vertcat(coupler_bend_1*coupler_bent/2 + coupler_bend_2*coupler_bent_2/2 +
            coupler_bend_3*coupler_bent_3/2),
        ca.vertcat())


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (21,): crank.x [m], crank.y [m], crank.z [m], coupler_start.x [m], coupler_start.y [m], coupler_start.z [m], coupler_end.x
            [m], coupler_end.y [m], coupler_end.z [m], slider.x [m], slider.y [m], slider.z [m], coupler_25.x [m], coupler_25.y [m],
            coupler_25.z [m], coupler_50.x [m], coupler_50.y [m], coupler_50.z [m], coupler_75.x [m], coupler_75.y [m], coupler_75.z [m]
        rotations (63,): crank.R_xx [1], crank.R_xy [1], crank.R_xz [1], crank.R_yx [1], crank.R_yy [1], crank.R_yz [1], crank.R_zx [1],
            crank.R_zy [1], crank.R_zz [1], coupler_start.R_xx [1], coupler_start.R_xy [1], coupler_start.R_xz [1], coupler_start.R_yx [1],
            coupler_start.R_yy [1], coupler_start.R_yz [1], coupler_start.R_zx [1], coupler_start.R_zy [1], coupler_start.R_zz [1],
            coupler_end.R_xx [1], coupler_end.R_xy [1], coupler_end.R_xz [1], coupler_end.R_yx [1], coupler_end.R_yy [1], coupler_end.R_yz
            [1], coupler_end.R_zx [1], coupler_end.R_zy [1], coupler_end.R_zz [1], slider.R_xx [1], slider.R_xy [1], slider.R_xz [1],
            slider.R_yx [1], slider.R_yy [1], slider.R_yz [1], slider.R_zx [1], slider.R_zy [1], slider.R_zz [1], coupler_25.R_xx [1],
            coupler_25.R_xy [1], coupler_25.R_xz [1], coupler_25.R_yx [1], coupler_25.R_yy [1], coupler_25.R_yz [1], coupler_25.R_zx [1],
            coupler_25.R_zy [1], coupler_25.R_zz [1], coupler_50.R_xx [1], coupler_50.R_xy [1], coupler_50.R_xz [1], coupler_50.R_yx [1],
            coupler_50.R_yy [1], coupler_50.R_yz [1], coupler_50.R_zx [1], coupler_50.R_zy [1], coupler_50.R_zz [1], coupler_75.R_xx [1],
            coupler_75.R_xy [1], coupler_75.R_xz [1], coupler_75.R_yx [1], coupler_75.R_yy [1], coupler_75.R_yz [1], coupler_75.R_zx [1],
            coupler_75.R_zy [1], coupler_75.R_zz [1]
    """
    crank_length, coupler_length, crank_speed, k1, k2, k3, k4, k5, k6, k7 = c[0], c[2], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]
    k50, k51, k52, k53, k54, k55, k56 = c[59], c[60], c[61], c[62], c[63], c[64], c[65]
    crank_pin_angle, coupler_bend_1, coupler_bend_2, coupler_bend_3, guide_travel = q[0], q[1], q[2], q[3], q[4]
    crank_angle = t*crank_speed
    cos_crank = ca.cos(crank_angle)
    sin_crank = ca.sin(crank_angle)
    coupler_start_angle = crank_angle + crank_pin_angle
    cos_coupler_start = ca.cos(coupler_start_angle)
    sin_coupler_start = ca.sin(coupler_start_angle)
    coupler_drawn_in = coupler_bend_1*k2 + coupler_bend_2*k1 + coupler_bend_3*k3
    x1 = coupler_bend_2*k4
    coupler_drawn_in_2 = x1 + coupler_bend_1*k1 + coupler_bend_3*k4
    coupler_drawn_in_3 = x1 + coupler_bend_1*k3 + coupler_bend_3*k5
    coupler_deflection = -3.141592653589793*coupler_bend_1 - 6.283185307179586*coupler_bend_2 - 9.42477796076938*coupler_bend_3
    coupler_tip_x = coupler_length - coupler_bend_1*coupler_drawn_in/2 - coupler_bend_2*coupler_drawn_in_2/2 - coupler_bend_3*coupler_drawn_in_3/2
    coupler_slope = -coupler_bend_1*k6 - coupler_bend_3*k7
    coupler_end_angle = coupler_slope + coupler_start_angle
    cos_coupler_end = ca.cos(coupler_end_angle)
    sin_coupler_end = ca.sin(coupler_end_angle)
    coupler_start_arm_x = cos_crank*crank_length
    coupler_start_arm_y = sin_crank*crank_length
    coupler_end_arm_x = cos_coupler_start*coupler_tip_x - coupler_deflection*sin_coupler_start
    coupler_end_arm_y = cos_coupler_start*coupler_deflection + coupler_tip_x*sin_coupler_start
    coupler_end_x = coupler_end_arm_x + coupler_start_arm_x
    coupler_end_y = coupler_end_arm_y + coupler_start_arm_y
    coupler_deflection_25 = -0.07829138221090079*coupler_bend_1 - 1.6490877090057974*coupler_bend_3 - 0.5707963267948967*coupler_bend_2
    x2 = -coupler_bend_2*k6
    coupler_slope_25 = x2 - coupler_bend_1*k50 - coupler_bend_3*k51
    coupler_25_x = coupler_start_arm_x + cos_coupler_start*coupler_tip_x/4 - coupler_deflection_25*sin_coupler_start
    coupler_25_y = coupler_start_arm_y + cos_coupler_start*coupler_deflection_25 + coupler_tip_x*sin_coupler_start/4
    cos_coupler_slope_25 = ca.cos(coupler_slope_25)
    sin_coupler_slope_25 = ca.sin(coupler_slope_25)
    coupler_25_R_x_x = cos_coupler_start*cos_coupler_slope_25 - sin_coupler_start*sin_coupler_slope_25
    coupler_25_R_x_y = -cos_coupler_start*sin_coupler_slope_25 - sin_coupler_start*cos_coupler_slope_25
    coupler_25_R_y_x = cos_coupler_start*sin_coupler_slope_25 + sin_coupler_start*cos_coupler_slope_25
    coupler_deflection_50 = -3.141592653589793*coupler_bend_2 - 5.71238898038469*coupler_bend_3 - 0.5707963267948967*coupler_bend_1
    coupler_slope_50 = -coupler_bend_1*k52 - coupler_bend_2*k53 - coupler_bend_3*k54
    coupler_50_x = coupler_start_arm_x + cos_coupler_start*coupler_tip_x/2 - coupler_deflection_50*sin_coupler_start
    coupler_50_y = coupler_start_arm_y + cos_coupler_start*coupler_deflection_50 + coupler_tip_x*sin_coupler_start/2
    cos_coupler_slope_50 = ca.cos(coupler_slope_50)
    sin_coupler_slope_50 = ca.sin(coupler_slope_50)
    coupler_50_R_x_x = cos_coupler_start*cos_coupler_slope_50 - sin_coupler_start*sin_coupler_slope_50
    coupler_50_R_x_y = -cos_coupler_start*sin_coupler_slope_50 - sin_coupler_start*cos_coupler_slope_50
    coupler_50_R_y_x = cos_coupler_start*sin_coupler_slope_50 + sin_coupler_start*cos_coupler_slope_50
    coupler_deflection_75 = -5.71238898038469*coupler_bend_2 - 6.3614766893904875*coupler_bend_3 - 1.6490877090057974*coupler_bend_1
    coupler_slope_75 = x2 - coupler_bend_1*k56 - coupler_bend_3*k55
    coupler_75_x = coupler_start_arm_x + 3*cos_coupler_start*coupler_tip_x/4 - coupler_deflection_75*sin_coupler_start
    coupler_75_y = coupler_start_arm_y + cos_coupler_start*coupler_deflection_75 + 3*coupler_tip_x*sin_coupler_start/4
    cos_coupler_slope_75 = ca.cos(coupler_slope_75)
    sin_coupler_slope_75 = ca.sin(coupler_slope_75)
    coupler_75_R_x_x = cos_coupler_start*cos_coupler_slope_75 - sin_coupler_start*sin_coupler_slope_75
    coupler_75_R_x_y = -cos_coupler_start*sin_coupler_slope_75 - sin_coupler_start*cos_coupler_slope_75
    coupler_75_R_y_x = cos_coupler_start*sin_coupler_slope_75 + sin_coupler_start*cos_coupler_slope_75
    return (ca.vertcat(0, 0, 0, coupler_start_arm_x, coupler_start_arm_y, 0, coupler_end_x, coupler_end_y, 0, guide_travel, 0, 0,
            coupler_25_x, coupler_25_y, 0, coupler_50_x, coupler_50_y, 0, coupler_75_x, coupler_75_y, 0),
        ca.vertcat(cos_crank, -sin_crank, 0, sin_crank, cos_crank, 0, 0, 0, 1, cos_coupler_start, -sin_coupler_start, 0, sin_coupler_start,
            cos_coupler_start, 0, 0, 0, 1, cos_coupler_end, -sin_coupler_end, 0, sin_coupler_end, cos_coupler_end, 0, 0, 0, 1, 1, 0, 0, 0,
            1, 0, 0, 0, 1, coupler_25_R_x_x, coupler_25_R_x_y, 0, coupler_25_R_y_x, coupler_25_R_x_x, 0, 0, 0, 1, coupler_50_R_x_x,
            coupler_50_R_x_y, 0, coupler_50_R_y_x, coupler_50_R_x_x, 0, 0, 0, 1, coupler_75_R_x_x, coupler_75_R_x_y, 0, coupler_75_R_y_x,
            coupler_75_R_x_x, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (12,): OUTPUTS
    """
    coupler_width, coupler_length, youngs_modulus = c[1], c[2], c[3]
    coupler_bend_1, coupler_bend_2, coupler_bend_3 = q[1], q[2], q[3]
    inverse_coupler_length_squared = 1/(coupler_length*coupler_length)
    x2 = 88.82643960980423*coupler_bend_3
    x3 = -9.869604401089358*coupler_bend_1
    x4 = x2 + x3
    return ca.vertcat(0, 0, 0, 0, -3.141592653589793*coupler_bend_2 - 5.71238898038469*coupler_bend_3 - 0.5707963267948967*coupler_bend_1,
        0.9999999999999999*coupler_bend_1 - 1.0*coupler_bend_3, inverse_coupler_length_squared*x4*coupler_width**4*youngs_modulus/12,
        inverse_coupler_length_squared*x4*coupler_width*youngs_modulus/2, -3.141592653589793*coupler_bend_1 -
        6.283185307179586*coupler_bend_2 - 9.42477796076938*coupler_bend_3, 0, 0, 0)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    crank_speed = p[9]
    return ca.vertcat(2*3.141592653589793/ca.fabs(crank_speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        main_bearing.parent, main_bearing.child, crank_pin.parent, crank_pin.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z
            [1]
        coupler.parent to coupler.child (6,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1]
        guide.parent to crank_drive.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        crank.centre, slider.centre (3,): x [m], y [m], z [m]
    """
    crank_length = p[2]
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(crank_length, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1),
        *[ca.vertcat(0, 0, 0, 1, 0, 0)]*7, ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(crank_length/2, 0, 0), ca.vertcat(0, 0, 0))
