"""geared_hoist: a motor lifts a load by a gear pair and a drum. Generated from derive/scenes/geared_hoist.py.

Do not edit; regenerate with `hertzwerk derive geared_hoist`.
Effects:
    motor: force on pinion_shaft = torque
    mesh: drum_shaft = -pinion_teeth/wheel_teeth pinion_shaft
    rope: rope_end = -drum_radius drum_shaft
    gravity: uniform gravity
    energy_ledger: work put in, energy dissipated per effect
Units: 84 assignments and 207 outputs checked, all consistent
Operations: flight 76 (equations of motion and gaps)
"""

import casadi as ca

NAME = "geared_hoist"
SOURCE = "derive/scenes/geared_hoist.py"
SUMMARY = "a motor lifts a load by a gear pair and a drum"
FORMAT = "hertzwerk module 1"
DIGEST = "3eea6fbe022c04c4ee5ff213c91de59e"

EFFECTS = (
    ("motor", "force", "force on pinion_shaft = torque"), ("mesh", "coupling", "drum_shaft = -pinion_teeth/wheel_teeth pinion_shaft"),
    ("rope", "coupling", "rope_end = -drum_radius drum_shaft"), ("gravity", "gravity", "uniform gravity"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("module", "mm", 4, "of the teeth"),
    ("pinion_teeth", "1", 17, ""),
    ("density", "kg/m^3", 7850, ""),
    ("face_width", "mm", 30, "body pinion, cylinder, length"),
    ("drum_radius", "mm", 80, "body winch, cylinder, radius"),
    ("wheel_teeth", "1", 51, ""),
    ("load_mass", "kg", 80, "body load, mass"),
    ("torque", "N m", 30, "of the motor"),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("speed_scale", "m/s", 1, "scales, speed"),
)

LIMITS = (
    ("face_width", "defined", 0, None, True, False, "body pinion, cylinder, length"),
    ("drum_radius", "defined", 0, None, True, False, "body winch, cylinder, radius"),
    ("load_mass", "defined", 0, None, True, False, "body load, mass"),
    ("speed_scale", "defined", 0, None, True, False, "scales, speed"),
)

COORDINATES = (("pinion_shaft.angle", "rad"), ("drum_shaft.angle", "rad"), ("rope_end.travel", "m"))

SPEEDS = (("pinion_shaft.speed", "rad/s"), ("drum_shaft.speed", "rad/s"), ("rope_end.speed", "m/s"))

MEMORY = (("motor.input", "J"),)

CONSTRAINTS = (("mesh.turned", "1"), ("rope.off", "m"))

BODIES = ("pinion", "winch", "load")

LANDMARKS = (
    ("pinion_shaft", "revolute", "parent", "ground", ("axis",)), ("pinion_shaft", "revolute", "child", "pinion", ("axis",)),
    ("drum_shaft", "revolute", "parent", "ground", ("axis",)), ("drum_shaft", "revolute", "child", "winch", ("axis",)),
    ("rope_end", "prismatic", "parent", "ground", ("axis",)), ("rope_end", "prismatic", "child", "load", ("axis",)),
    ("motor", "turn_force", "child", "pinion", ("axis",)), ("mesh", "mesh", "first", "winch", ("axis", "radius")),
    ("mesh", "mesh", "second", "pinion", ("axis", "radius")), ("rope", "mesh", "first", "load", ("along",)),
    ("rope", "mesh", "second", "winch", ("axis", "radius")), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("pinion", "body", "centre", "pinion", ()), ("winch", "body", "centre", "winch", ()), ("load", "body", "centre", "load", ()),
    ("pinion", "solid_cylinder", "shape_1", "pinion", ("axis", "radius", "length")),
    ("winch", "solid_cylinder", "shape_1", "winch", ("axis", "radius", "length")),
    ("winch", "solid_cylinder", "shape_2", "winch", ("axis", "radius", "length")),
)

CONSTANTS = (
    ("drum_radius", "m"), ("load_mass", "kg"), ("torque", "J"), ("gravity", "m/s^2"), ("mesh_turned_by_pinion_shaft", "1"),
    ("pinion_arm_x", "m"), ("k1", "m"), ("inverse_pinion_I_z_z", "1/(kg m^2)"), ("inverse_winch_I_z_z", "1/(kg m^2)"),
    ("inverse_load_mass", "1/kg"), ("pinion_shaft_by_mesh_turned", "1/(kg m^2)"), ("drum_shaft_by_rope_off", "1/(kg m)"),
    ("W_mesh_turned_mesh_turned", "1/(kg m^2)"), ("W_rope_off_mesh_turned", "1/(kg m)"), ("W_rope_off_rope_off", "1/kg"),
    ("inverse_W_mesh_turned_mesh_turned", "kg m^2"), ("inverse_W_rope_off_rope_off", "kg"), ("half_pinion_I_z_z", "kg m^2"),
    ("half_winch_I_z_z", "kg m^2"), ("half_load_mass", "kg"), ("gravity_times_load_mass", "N"), ("mesh_turned_softness", "1"),
    ("rope_off_softness", "1"),
)

OPERATIONS = (
    ("constants", 43), ("start", 0), ("scales", 26), ("coordinate_rates", 0), ("gaps", 0), ("gap_accelerations", 0), ("applied", 2),
    ("accelerations", 74), ("constraints", 8), ("projection", 40), ("ledger", 1), ("energy", 10), ("poses", 8), ("outputs", 0),
    ("landmarks", 35),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = PAIRS = EVENTS = LOADS = FED = ()
RUBBING = GUIDES = SLIPS = RELEASES = DISSIPATED = ROLLING = GIVEN = SEATED = BRISTLES = OUTPUTS = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (23,): drum_radius, load_mass, torque, gravity, mesh_turned_by_pinion_shaft, pinion_arm_x, k1, inverse_pinion_I_z_z,
            inverse_winch_I_z_z, inverse_load_mass, pinion_shaft_by_mesh_turned, drum_shaft_by_rope_off, W_mesh_turned_mesh_turned,
            W_rope_off_mesh_turned, W_rope_off_rope_off, inverse_W_mesh_turned_mesh_turned, inverse_W_rope_off_rope_off, half_pinion_I_z_z,
            half_winch_I_z_z, half_load_mass, gravity_times_load_mass, mesh_turned_softness, rope_off_softness
    """
    module, pinion_teeth, density, face_width, drum_radius, wheel_teeth, load_mass, torque = p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]
    gravity = p[8]
    mesh_turned_by_pinion_shaft = pinion_teeth/wheel_teeth
    pinion_arm_x = module*pinion_teeth/2 + module*wheel_teeth/2
    k1 = -6*drum_radius
    module_to_the_4 = module**4
    pinion_I_z_z = 3.141592653589793*module_to_the_4*pinion_teeth**4*density*face_width/32
    winch_I_z_z = 3*3.141592653589793*drum_radius**4*density*face_width/2 + 3.141592653589793*module_to_the_4*wheel_teeth**4*density*face_width/32
    inverse_pinion_I_z_z = 1/pinion_I_z_z
    inverse_winch_I_z_z = 1/winch_I_z_z
    inverse_load_mass = 1/load_mass
    pinion_shaft_by_mesh_turned = inverse_pinion_I_z_z*mesh_turned_by_pinion_shaft
    drum_shaft_by_rope_off = inverse_winch_I_z_z*drum_radius
    W_mesh_turned_mesh_turned = inverse_winch_I_z_z + mesh_turned_by_pinion_shaft*pinion_shaft_by_mesh_turned
    W_rope_off_mesh_turned = inverse_winch_I_z_z*drum_radius
    W_rope_off_rope_off = inverse_load_mass + drum_shaft_by_rope_off*drum_radius
    inverse_W_mesh_turned_mesh_turned = 1/W_mesh_turned_mesh_turned
    inverse_W_rope_off_rope_off = 1/W_rope_off_rope_off
    half_pinion_I_z_z = pinion_I_z_z/2
    half_winch_I_z_z = winch_I_z_z/2
    half_load_mass = load_mass/2
    gravity_times_load_mass = gravity*load_mass
    return ca.vertcat(drum_radius, load_mass, torque, gravity, mesh_turned_by_pinion_shaft, pinion_arm_x, k1, inverse_pinion_I_z_z,
        inverse_winch_I_z_z, inverse_load_mass, pinion_shaft_by_mesh_turned, drum_shaft_by_rope_off, W_mesh_turned_mesh_turned,
        W_rope_off_mesh_turned, W_rope_off_rope_off, inverse_W_mesh_turned_mesh_turned, inverse_W_rope_off_rope_off, half_pinion_I_z_z,
        half_winch_I_z_z, half_load_mass, gravity_times_load_mass, 3e-09, 3e-09)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (3,): COORDINATES
        u (3,): SPEEDS
    """
    return ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (3,): COORDINATES
        su (3,): SPEEDS
        sz (1,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    module, pinion_teeth, density, face_width, drum_radius, wheel_teeth, load_mass = p[0], p[1], p[2], p[3], p[4], p[5], p[6]
    speed_scale = p[9]
    module_squared = module*module
    total_mass = 3*3.141592653589793*drum_radius*drum_radius*density*face_width + 3.141592653589793*module_squared*pinion_teeth*pinion_teeth*density*face_width/4 + 3.141592653589793*module_squared*wheel_teeth*wheel_teeth*density*face_width/4 + load_mass
    energy_scale = total_mass*speed_scale*speed_scale/2
    force_scale = energy_scale/drum_radius
    speed_scale_over_drum_radius = speed_scale/drum_radius
    return (ca.vertcat(1, 1, drum_radius), ca.vertcat(speed_scale_over_drum_radius, speed_scale_over_drum_radius, speed_scale),
        ca.vertcat(energy_scale), ca.vertcat(drum_radius, speed_scale, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (3,): pinion_shaft.angle [rad/s], drum_shaft.angle [rad/s], rope_end.travel [m/s]
    """
    pinion_shaft_speed, drum_shaft_speed, rope_end_speed = u[0], u[1], u[2]
    return ca.vertcat(pinion_shaft_speed, drum_shaft_speed, rope_end_speed)


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
        f (3,): pinion_shaft [N m], drum_shaft [N m], rope_end [N]
    """
    load_mass, torque, gravity = c[1], c[2], c[3]
    return ca.vertcat(torque, 0, -gravity*load_mass)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (3,): pinion_shaft.acceleration [rad/s^2], drum_shaft.acceleration [rad/s^2], rope_end.acceleration [m/s^2]
        reactions (0,): empty
        multipliers (2,): mesh.turned [N m], rope.off [N]
    """
    drum_radius, mesh_turned_by_pinion_shaft, inverse_pinion_I_z_z, inverse_winch_I_z_z, inverse_load_mass = c[0], c[4], c[7], c[8], c[9]
    pinion_shaft_by_mesh_turned, drum_shaft_by_rope_off, W_mesh_turned_mesh_turned, W_rope_off_mesh_turned = c[10], c[11], c[12], c[13]
    W_rope_off_rope_off, mesh_turned_softness, rope_off_softness = c[14], c[21], c[22]
    pinion_shaft_force, drum_shaft_force, rope_end_force = f[0], f[1], f[2]
    pinion_shaft_acc = inverse_pinion_I_z_z*pinion_shaft_force
    drum_shaft_acc = drum_shaft_force*inverse_winch_I_z_z
    rope_end_acc = inverse_load_mass*rope_end_force
    W_mesh_turned_raised = W_mesh_turned_mesh_turned + W_mesh_turned_mesh_turned*mesh_turned_softness
    W_rope_off_raised = W_rope_off_rope_off + W_rope_off_rope_off*rope_off_softness
    l_rope_off_mesh_turned = W_rope_off_mesh_turned/W_mesh_turned_raised
    D_rope_off = W_rope_off_raised - W_rope_off_mesh_turned*l_rope_off_mesh_turned
    mesh_turned_left_2 = -drum_shaft_acc - mesh_turned_by_pinion_shaft*pinion_shaft_acc
    rope_off_left_2 = -rope_end_acc - drum_shaft_acc*drum_radius
    y_rope_off = rope_off_left_2 - l_rope_off_mesh_turned*mesh_turned_left_2
    rope_off_acc = y_rope_off/D_rope_off
    mesh_turned_acc = mesh_turned_left_2/W_mesh_turned_raised - l_rope_off_mesh_turned*rope_off_acc
    pinion_shaft_acc_2 = pinion_shaft_acc + mesh_turned_acc*pinion_shaft_by_mesh_turned
    drum_shaft_acc_2 = drum_shaft_acc + drum_shaft_by_rope_off*rope_off_acc + inverse_winch_I_z_z*mesh_turned_acc
    rope_end_acc_2 = rope_end_acc + inverse_load_mass*rope_off_acc
    mesh_turned_left_3 = -drum_shaft_acc_2 - mesh_turned_by_pinion_shaft*pinion_shaft_acc_2
    rope_off_left_3 = -rope_end_acc_2 - drum_shaft_acc_2*drum_radius
    y_rope_off_2 = rope_off_left_3 - l_rope_off_mesh_turned*mesh_turned_left_3
    rope_off_acc_2 = y_rope_off_2/D_rope_off
    mesh_turned_acc_2 = mesh_turned_left_3/W_mesh_turned_raised - l_rope_off_mesh_turned*rope_off_acc_2
    mesh_turned_acc_3 = mesh_turned_acc + mesh_turned_acc_2
    rope_off_acc_3 = rope_off_acc + rope_off_acc_2
    pinion_shaft_acc_3 = pinion_shaft_acc_2 + mesh_turned_acc_2*pinion_shaft_by_mesh_turned
    drum_shaft_acc_3 = drum_shaft_acc_2 + drum_shaft_by_rope_off*rope_off_acc_2 + inverse_winch_I_z_z*mesh_turned_acc_2
    rope_end_acc_3 = rope_end_acc_2 + inverse_load_mass*rope_off_acc_2
    mesh_turned_left_4 = -drum_shaft_acc_3 - mesh_turned_by_pinion_shaft*pinion_shaft_acc_3
    rope_off_left_4 = -rope_end_acc_3 - drum_shaft_acc_3*drum_radius
    y_rope_off_3 = rope_off_left_4 - l_rope_off_mesh_turned*mesh_turned_left_4
    rope_off_acc_4 = y_rope_off_3/D_rope_off
    mesh_turned_acc_4 = mesh_turned_left_4/W_mesh_turned_raised - l_rope_off_mesh_turned*rope_off_acc_4
    mesh_turned_acc_5 = mesh_turned_acc_3 + mesh_turned_acc_4
    rope_off_acc_5 = rope_off_acc_3 + rope_off_acc_4
    pinion_shaft_acc_4 = pinion_shaft_acc_3 + mesh_turned_acc_4*pinion_shaft_by_mesh_turned
    drum_shaft_acc_4 = drum_shaft_acc_3 + drum_shaft_by_rope_off*rope_off_acc_4 + inverse_winch_I_z_z*mesh_turned_acc_4
    rope_end_acc_4 = rope_end_acc_3 + inverse_load_mass*rope_off_acc_4
    return ca.vertcat(pinion_shaft_acc_4, drum_shaft_acc_4, rope_end_acc_4), ca.vertcat(), ca.vertcat(mesh_turned_acc_5, rope_off_acc_5)


def constraints(t, q, u, c):
    """Constraints, zero while the loops are closed, and their rates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        phi (2,): CONSTRAINTS
        dphi (2,): mesh.turned [1/s], rope.off [m/s]
    """
    drum_radius, mesh_turned_by_pinion_shaft = c[0], c[4]
    pinion_shaft_angle, drum_shaft_angle, rope_end_travel = q[0], q[1], q[2]
    pinion_shaft_speed, drum_shaft_speed, rope_end_speed = u[0], u[1], u[2]
    mesh_turned_left = drum_shaft_angle + mesh_turned_by_pinion_shaft*pinion_shaft_angle
    mesh_turned_rate = drum_shaft_speed + mesh_turned_by_pinion_shaft*pinion_shaft_speed
    rope_off_left = rope_end_travel + drum_shaft_angle*drum_radius
    rope_off_rate = rope_end_speed + drum_shaft_speed*drum_radius
    return ca.vertcat(mesh_turned_left, rope_off_left), ca.vertcat(mesh_turned_rate, rope_off_rate)


def projection(t, q, wanted, c):
    """Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.

    Arguments: t [s]; q: COORDINATES; wanted: rates of CONSTRAINTS; c: CONSTANTS.
    Returns, each a column vector:
        v (3,): SPEEDS
        independence (2,): CONSTRAINTS [1]
    """
    drum_radius, mesh_turned_by_pinion_shaft, inverse_winch_I_z_z, inverse_load_mass = c[0], c[4], c[8], c[9]
    pinion_shaft_by_mesh_turned, drum_shaft_by_rope_off, W_mesh_turned_mesh_turned, W_rope_off_mesh_turned = c[10], c[11], c[12], c[13]
    W_rope_off_rope_off, inverse_W_mesh_turned_mesh_turned, inverse_W_rope_off_rope_off, mesh_turned_softness = c[14], c[15], c[16], c[21]
    rope_off_softness = c[22]
    mesh_turned_wanted_rate, rope_off_wanted_rate = wanted[0], wanted[1]
    W_mesh_turned_raised = W_mesh_turned_mesh_turned + W_mesh_turned_mesh_turned*mesh_turned_softness
    W_rope_off_raised = W_rope_off_rope_off + W_rope_off_rope_off*rope_off_softness
    l_rope_off_mesh_turned = W_rope_off_mesh_turned/W_mesh_turned_raised
    D_rope_off = W_rope_off_raised - W_rope_off_mesh_turned*l_rope_off_mesh_turned
    y_rope_off_4 = rope_off_wanted_rate - l_rope_off_mesh_turned*mesh_turned_wanted_rate
    rope_off_push = y_rope_off_4/D_rope_off
    mesh_turned_push = mesh_turned_wanted_rate/W_mesh_turned_raised - l_rope_off_mesh_turned*rope_off_push
    rope_end_push = inverse_load_mass*rope_off_push
    drum_shaft_push = drum_shaft_by_rope_off*rope_off_push + inverse_winch_I_z_z*mesh_turned_push
    pinion_shaft_push = mesh_turned_push*pinion_shaft_by_mesh_turned
    mesh_turned_left_5 = mesh_turned_wanted_rate - drum_shaft_push - mesh_turned_by_pinion_shaft*pinion_shaft_push
    rope_off_left_5 = rope_off_wanted_rate - rope_end_push - drum_shaft_push*drum_radius
    y_rope_off_5 = rope_off_left_5 - l_rope_off_mesh_turned*mesh_turned_left_5
    rope_off_push_2 = y_rope_off_5/D_rope_off
    mesh_turned_push_2 = mesh_turned_left_5/W_mesh_turned_raised - l_rope_off_mesh_turned*rope_off_push_2
    rope_end_push_2 = rope_end_push + inverse_load_mass*rope_off_push_2
    drum_shaft_push_2 = drum_shaft_push + drum_shaft_by_rope_off*rope_off_push_2 + inverse_winch_I_z_z*mesh_turned_push_2
    pinion_shaft_push_2 = pinion_shaft_push + mesh_turned_push_2*pinion_shaft_by_mesh_turned
    mesh_turned_independence = W_mesh_turned_raised*inverse_W_mesh_turned_mesh_turned
    rope_off_independence = D_rope_off*inverse_W_rope_off_rope_off
    return ca.vertcat(pinion_shaft_push_2, drum_shaft_push_2, rope_end_push_2), ca.vertcat(mesh_turned_independence, rope_off_independence)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (1,): MEMORY [W]
    """
    torque = c[2]
    pinion_shaft_speed = u[0]
    return ca.vertcat(pinion_shaft_speed*torque)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (0,): empty
    """
    k1, half_pinion_I_z_z, half_winch_I_z_z, half_load_mass, gravity_times_load_mass = c[6], c[17], c[18], c[19], c[20]
    rope_end_travel = q[2]
    pinion_shaft_speed, drum_shaft_speed, rope_end_speed = u[0], u[1], u[2]
    load_arm_y = k1 + rope_end_travel
    kinetic = half_pinion_I_z_z*pinion_shaft_speed*pinion_shaft_speed + half_winch_I_z_z*drum_shaft_speed*drum_shaft_speed + half_load_mass*rope_end_speed*rope_end_speed
    potential = gravity_times_load_mass*load_arm_y
    return ca.vertcat(kinetic), ca.vertcat(potential), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (9,): pinion.x [m], pinion.y [m], pinion.z [m], winch.x [m], winch.y [m], winch.z [m], load.x [m], load.y [m], load.z [m]
        rotations (27,): pinion.R_xx [1], pinion.R_xy [1], pinion.R_xz [1], pinion.R_yx [1], pinion.R_yy [1], pinion.R_yz [1], pinion.R_zx
            [1], pinion.R_zy [1], pinion.R_zz [1], winch.R_xx [1], winch.R_xy [1], winch.R_xz [1], winch.R_yx [1], winch.R_yy [1],
            winch.R_yz [1], winch.R_zx [1], winch.R_zy [1], winch.R_zz [1], load.R_xx [1], load.R_xy [1], load.R_xz [1], load.R_yx [1],
            load.R_yy [1], load.R_yz [1], load.R_zx [1], load.R_zy [1], load.R_zz [1]
    """
    drum_radius, pinion_arm_x, k1 = c[0], c[5], c[6]
    pinion_shaft_angle, drum_shaft_angle, rope_end_travel = q[0], q[1], q[2]
    cos_pinion = ca.cos(pinion_shaft_angle)
    sin_pinion = ca.sin(pinion_shaft_angle)
    cos_winch = ca.cos(drum_shaft_angle)
    sin_winch = ca.sin(drum_shaft_angle)
    load_arm_y = k1 + rope_end_travel
    return (ca.vertcat(pinion_arm_x, *[0]*5, -drum_radius, load_arm_y, 0),
        ca.vertcat(cos_pinion, -sin_pinion, 0, sin_pinion, cos_pinion, 0, 0, 0, 1, cos_winch, -sin_winch, 0, sin_winch, cos_winch, 0, 0, 0,
            1, 1, 0, 0, 0, 1, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (0,): empty
    """
    return ca.vertcat()


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        pinion_shaft.parent to motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        mesh.first, mesh.second (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], radius [m]
        rope.first (6,): x [m], y [m], z [m], along_x [1], along_y [1], along_z [1]
        rope.second (7,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], radius [m]
        gravity.direction (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        pinion.centre, winch.centre, load.centre (3,): x [m], y [m], z [m]
        pinion.shape_1, winch.shape_1, winch.shape_2 (8,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1], radius [m], length [m]
    """
    module, pinion_teeth, density, face_width, drum_radius, wheel_teeth = p[0], p[1], p[2], p[3], p[4], p[5]
    half_module_times_pinion_teeth = module*pinion_teeth/2
    half_module_times_wheel_teeth = module*wheel_teeth/2
    x3 = half_module_times_pinion_teeth + half_module_times_wheel_teeth
    pinion_teeth_over_wheel_teeth = pinion_teeth/wheel_teeth
    x5 = 1 + pinion_teeth_over_wheel_teeth
    x6 = ca.fabs(x3)
    drum_radius_squared = drum_radius*drum_radius
    return (ca.vertcat(x3, 0, 0, 0, 0, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1),
        ca.vertcat(-drum_radius, -6*drum_radius, 0, 0, 1, 0), ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(*[0]*5, 1),
        ca.vertcat(*[0]*5, 1, x6/x5), ca.vertcat(*[0]*5, 1, x6*pinion_teeth/(x5*wheel_teeth)), ca.vertcat(0, 0, 0, 0, 1, 0),
        ca.vertcat(*[0]*5, 1, drum_radius), ca.vertcat(0, 0, 0, 0, -1, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(0, 0,
            -6*3.141592653589793*drum_radius_squared*face_width*face_width*density/(3*3.141592653589793*drum_radius_squared*density*face_width
            + 3.141592653589793*module*module*wheel_teeth*wheel_teeth*density*face_width/4)),
        ca.vertcat(0, 0, 0), ca.vertcat(*[0]*5, 1, half_module_times_pinion_teeth, face_width),
        ca.vertcat(*[0]*5, 1, half_module_times_wheel_teeth, face_width),
        ca.vertcat(0, 0, -2*face_width, 0, 0, 1, drum_radius, 3*face_width))
