"""spheres_in_box: 5 spheres fall into a box. Generated from derive/scenes/spheres_in_box.py.

Do not edit; regenerate with `hertzwerk derive spheres_in_box`.
Effects:
    gravity: uniform gravity
    balls_1_2 to wall_4_5, 35: power x tsuji
    energy_ledger: work put in, energy dissipated per effect
Units: 148 assignments and 714 outputs checked, all consistent
Operations: flight 605 (equations of motion and gaps); in contact also contact_of_balls 1200, contact_of_floor 110, contact_of_wall_1 115, contact_of_wall_2 115, contact_of_wall_3 115, contact_of_wall_4 115
"""

import casadi as ca

NAME = "spheres_in_box"
SOURCE = "derive/scenes/spheres_in_box.py"
SUMMARY = "5 spheres fall into a box"
FORMAT = "hertzwerk module 1"
DIGEST = "96fa209e01643b79d03136652663d078"


def _rows(part, trees):
    """Rows of trees in q (part 0) or in u (part 1)."""
    return [row for tree in trees for row in TREES[tree][part]]


def _of_member(k, rows):
    """Rows of the member at place k in z or in m."""
    return [row[k] for row in rows]


BALL_TREES = tuple((f"ball_{i + 1}", i) for i in range(5))

BALLS_PAIRS = tuple((f"balls_{i + 1}_{j + 1}", i, j) for i in range(5) for j in range(i + 1, 5))

FLOOR_PAIRS = tuple((f"floor_{i + 1}", i) for i in range(5))

WALL_1_PAIRS = tuple((f"wall_1_{i + 1}", i) for i in range(5))

WALL_2_PAIRS = tuple((f"wall_2_{i + 1}", i) for i in range(5))

WALL_3_PAIRS = tuple((f"wall_3_{i + 1}", i) for i in range(5))

WALL_4_PAIRS = tuple((f"wall_4_{i + 1}", i) for i in range(5))

TREES = (*(([*range(7*k, 7*k + 7)], [*range(6*k, 6*k + 6)]) for k in range(5)),)

FAMILIES = tuple(
    (family, tuple((name, _rows(0, trees), _rows(1, trees), _of_member(k, of_z), _of_member(k, of_m))
                   for k, (name, *trees) in enumerate(members)))
    for family, members, of_z, of_m in (
        ("balls", BALLS_PAIRS, (range(10),), ()),
        ("floor", FLOOR_PAIRS, (range(10, 15),), ()),
        ("wall_1", WALL_1_PAIRS, (range(15, 20),), ()),
        ("wall_2", WALL_2_PAIRS, (range(20, 25),), ()),
        ("wall_3", WALL_3_PAIRS, (range(25, 30),), ()),
        ("wall_4", WALL_4_PAIRS, (range(30, 35),), ()),
    )
)

EFFECTS = (
    ("gravity", "gravity", "uniform gravity"), *((name, "contact", "power x tsuji") for name, i, j in BALLS_PAIRS),
    *((name, "contact", "power x tsuji") for name, i in FLOOR_PAIRS), *((name, "contact", "power x tsuji") for name, i in WALL_1_PAIRS),
    *((name, "contact", "power x tsuji") for name, i in WALL_2_PAIRS), *((name, "contact", "power x tsuji") for name, i in WALL_3_PAIRS),
    *((name, "contact", "power x tsuji") for name, i in WALL_4_PAIRS),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("radius", "m", 0.02, "body ball_1, sphere, radius"),
    ("density", "kg/m^3", 1100, ""),
    ("width", "m", 0.1, ""),
    ("gravity", "m/s^2", 9.81, "effect gravity, acceleration"),
    ("stiffness", "N/m^1.5", 100000.0, "effect balls_1_2, stiffness of power"),
    ("restitution", "1", 0.3, "effect balls_1_2, coefficient of restitution of tsuji"),
)

LIMITS = (
    ("radius", "defined", 0, None, True, False, "body ball_1, sphere, radius"),
    ("stiffness", "defined", 0, None, True, False, "effect balls_1_2, stiffness of power"),
    ("restitution", "defined", 0, 1, True, False, "effect balls_1_2, coefficient of restitution of tsuji"),
)

COORDINATES = (
    *(row for name, i in BALL_TREES for row in (
        (f"flight_{i + 1}.x", "m"), (f"flight_{i + 1}.y", "m"), (f"flight_{i + 1}.z", "m"), (f"flight_{i + 1}.q0", "1"),
        (f"flight_{i + 1}.q1", "1"), (f"flight_{i + 1}.q2", "1"), (f"flight_{i + 1}.q3", "1"),
    )),
)

QUATERNIONS = (*range(3, 38, 7),)

SPEEDS = (
    *(row for name, i in BALL_TREES for row in (
        (f"flight_{i + 1}.x_speed", "m/s"), (f"flight_{i + 1}.y_speed", "m/s"), (f"flight_{i + 1}.z_speed", "m/s"),
        (f"flight_{i + 1}.angular_speed_x", "rad/s"), (f"flight_{i + 1}.angular_speed_y", "rad/s"),
        (f"flight_{i + 1}.angular_speed_z", "rad/s"),
    )),
)

MEMORY = (
    *((f"{name}.dissipated", "J") for name, i, j in BALLS_PAIRS), *((f"{name}.dissipated", "J") for name, i in FLOOR_PAIRS),
    *((f"{name}.dissipated", "J") for name, i in WALL_1_PAIRS), *((f"{name}.dissipated", "J") for name, i in WALL_2_PAIRS),
    *((f"{name}.dissipated", "J") for name, i in WALL_3_PAIRS), *((f"{name}.dissipated", "J") for name, i in WALL_4_PAIRS),
)

PAIRS = (
    *((name, "sphere_on_sphere") for name, i, j in BALLS_PAIRS), *((name, "sphere_on_plane") for name, i in FLOOR_PAIRS),
    *((name, "sphere_on_plane") for name, i in WALL_1_PAIRS), *((name, "sphere_on_plane") for name, i in WALL_2_PAIRS),
    *((name, "sphere_on_plane") for name, i in WALL_3_PAIRS), *((name, "sphere_on_plane") for name, i in WALL_4_PAIRS),
)

RELEASES = (*["gap"]*35,)

DISSIPATED = (*range(35),)

OUTPUTS = (
    *((f"{name}.gap", "m") for name, i, j in BALLS_PAIRS), *((f"{name}.gap", "m") for name, i in FLOOR_PAIRS),
    *((f"{name}.gap", "m") for name, i in WALL_1_PAIRS), *((f"{name}.gap", "m") for name, i in WALL_2_PAIRS),
    *((f"{name}.gap", "m") for name, i in WALL_3_PAIRS), *((f"{name}.gap", "m") for name, i in WALL_4_PAIRS),
)

BODIES = (*(name for name, i in BALL_TREES),)

LANDMARKS = (
    *(row for name, i, j in BALLS_PAIRS for row in (
        (name, "sphere_on_sphere", "first", f"ball_{i + 1}", ("radius",)),
        (name, "sphere_on_sphere", "second", f"ball_{j + 1}", ("radius",)),
    )),
    *(row for name, i in FLOOR_PAIRS for row in (
        (name, "sphere_on_plane", "sphere", f"ball_{i + 1}", ("radius",)), (name, "sphere_on_plane", "plane", "ground", ("normal",)),
    )),
    *(row for name, i in WALL_1_PAIRS for row in (
        (name, "sphere_on_plane", "sphere", f"ball_{i + 1}", ("radius",)), (name, "sphere_on_plane", "plane", "ground", ("normal",)),
    )),
    *(row for name, i in WALL_2_PAIRS for row in (
        (name, "sphere_on_plane", "sphere", f"ball_{i + 1}", ("radius",)), (name, "sphere_on_plane", "plane", "ground", ("normal",)),
    )),
    *(row for name, i in WALL_3_PAIRS for row in (
        (name, "sphere_on_plane", "sphere", f"ball_{i + 1}", ("radius",)), (name, "sphere_on_plane", "plane", "ground", ("normal",)),
    )),
    *(row for name, i in WALL_4_PAIRS for row in (
        (name, "sphere_on_plane", "sphere", f"ball_{i + 1}", ("radius",)), (name, "sphere_on_plane", "plane", "ground", ("normal",)),
    )),
    ("gravity", "gravity", "direction", "ground", ("axis",)), *((name, "body", "centre", name, ()) for name, i in BALL_TREES),
    *((name, "solid_sphere", "shape_1", name, ("radius",)) for name, i in BALL_TREES),
)

CONSTANTS = (
    ("radius", "m"), ("gravity", "m/s^2"), ("stiffness", "N/m^1.5"), ("wall_1_1_second_arm_x", "m"), ("wall_2_1_second_arm_x", "m"),
    ("balls_1_2_reach", "m"), ("minus_balls_1_2_reach_squared", "m^2"), ("half_inverse_balls_1_2_reach", "1/m"),
    ("ball_1_total_mass", "kg"), ("inverse_ball_1_total_mass", "1/kg"), ("inverse_ball_1_I_z_z", "1/(kg m^2)"),
    ("half_ball_1_I_z_z", "kg m^2"), ("k6", "kg"), ("k7", "N"), ("two_fifths_of_stiffness", "N/m^1.5"), ("balls_1_2_xi", "1"),
)

OPERATIONS = (
    ("constants", 42), ("start", 8), ("scales", 37), ("ledger", 0), ("landmarks", 3), ("coordinate_rates", 120), ("applied", 10),
    ("accelerations", 30), ("energy", 715), ("poses", 120), ("gaps", 285), ("gap_accelerations", 280), ("contact_of_balls", 1200),
    ("outputs", 165), ("contact_of_floor", 110), ("contact_of_wall_1", 115), ("contact_of_wall_2", 115), ("contact_of_wall_3", 115),
    ("contact_of_wall_4", 115),
)

UNCHECKED = CONTRADICTIONS = ADVICE = SUM_LIMITS = INPUTS = SMOOTH_INPUTS = LATCHES = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = ()

GIVEN = JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (16,): radius, gravity, stiffness, wall_1_1_second_arm_x, wall_2_1_second_arm_x, balls_1_2_reach, minus_balls_1_2_reach_squared,
            half_inverse_balls_1_2_reach, ball_1_total_mass, inverse_ball_1_total_mass, inverse_ball_1_I_z_z, half_ball_1_I_z_z, k6, k7,
            two_fifths_of_stiffness, balls_1_2_xi
    """
    radius, density, width, gravity, stiffness, restitution = p[0], p[1], p[2], p[3], p[4], p[5]
    wall_1_1_second_arm_x = -width/2
    wall_2_1_second_arm_x = width/2
    balls_1_2_reach = 2*radius
    minus_balls_1_2_reach_squared = -balls_1_2_reach*balls_1_2_reach
    half_inverse_balls_1_2_reach = 1/(2*balls_1_2_reach)
    radius_cubed = radius*radius*radius
    ball_1_total_mass = 4*3.141592653589793*radius_cubed*density/3
    ball_1_I_z_z = 8*3.141592653589793*radius**5*density/15
    inverse_ball_1_total_mass = 1/ball_1_total_mass
    inverse_ball_1_I_z_z = 1/ball_1_I_z_z
    half_ball_1_I_z_z = ball_1_I_z_z/2
    k6 = 2*3.141592653589793*radius_cubed*density/3
    k7 = 4*3.141592653589793*radius_cubed*density*gravity/3
    two_fifths_of_stiffness = 2*stiffness/5
    x2 = ca.log(restitution)
    balls_1_2_xi = -x2*ca.sqrt(5)/ca.sqrt(3.141592653589793**2 + x2*x2)
    return ca.vertcat(radius, gravity, stiffness, wall_1_1_second_arm_x, wall_2_1_second_arm_x, balls_1_2_reach,
        minus_balls_1_2_reach_squared, half_inverse_balls_1_2_reach, ball_1_total_mass, inverse_ball_1_total_mass, inverse_ball_1_I_z_z,
        half_ball_1_I_z_z, k6, k7, two_fifths_of_stiffness, balls_1_2_xi)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (35,): COORDINATES
        u (30,): SPEEDS
    """
    radius = p[0]
    x1 = -23*radius/20
    x2 = 21*radius/20
    x3 = 23*radius/20
    return (ca.vertcat(x1, x2, x1, 1, 0, 0, 0, x3, x2, x1, 1, 0, 0, 0, x1, x2, x3, 1, 0, 0, 0, x3, x2, x3, 1, 0, 0, 0, 0, 71*radius/20, 0,
            1, 0, 0, 0),
        ca.vertcat(*[0]*30))


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (35,): COORDINATES
        su (30,): SPEEDS
        sz (35,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    radius, density, gravity = p[0], p[1], p[3]
    total_mass = 20*3.141592653589793*radius*radius*radius*density/3
    energy_scale = total_mass*gravity*radius
    force_scale = 10*energy_scale/radius
    x1 = radius/10
    sqrt_2 = ca.sqrt(2)
    gravity_times_radius = gravity*radius
    x4 = ca.sqrt(gravity_times_radius)
    x5 = sqrt_2*x4
    x6 = sqrt_2*x4/radius
    return (ca.vertcat(*[x1, x1, x1, 1/20, 1/20, 1/20, 1/20]*5), ca.vertcat(*[x5, x5, x5, x6, x6, x6]*5), ca.vertcat(*[energy_scale]*35),
        ca.vertcat(x1, x5, force_scale, energy_scale))


def coordinate_rates_of_ball(t, q, u, c):
    """Rates of the coordinates of one tree of ball, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (7,): flight_1.x [m/s], flight_1.y [m/s], flight_1.z [m/s], flight_1.q0 [1/s], flight_1.q1 [1/s], flight_1.q2 [1/s], flight_1.q3
            [1/s]
    """
    flight_1_q0, flight_1_q1, flight_1_q2, flight_1_q3 = q[3], q[4], q[5], q[6]
    flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, flight_1_angular_speed_x, flight_1_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    flight_1_angular_speed_z = u[5]
    half_flight_1_angular_speed_x = flight_1_angular_speed_x/2
    half_flight_1_angular_speed_y = flight_1_angular_speed_y/2
    half_flight_1_angular_speed_z = flight_1_angular_speed_z/2
    return ca.vertcat(flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, -flight_1_q1*half_flight_1_angular_speed_x -
        flight_1_q2*half_flight_1_angular_speed_y - flight_1_q3*half_flight_1_angular_speed_z, flight_1_q0*half_flight_1_angular_speed_x +
        flight_1_q2*half_flight_1_angular_speed_z - flight_1_q3*half_flight_1_angular_speed_y, flight_1_q0*half_flight_1_angular_speed_y +
        flight_1_q3*half_flight_1_angular_speed_x - flight_1_q1*half_flight_1_angular_speed_z, flight_1_q0*half_flight_1_angular_speed_z +
        flight_1_q1*half_flight_1_angular_speed_y - flight_1_q2*half_flight_1_angular_speed_x)


def applied_of_ball(t, q, u, c):
    """Generalised forces other than contact forces of one tree of ball, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): flight_1.x [N], flight_1.y [N], flight_1.z [N], flight_1.moment_x [N m], flight_1.moment_y [N m], flight_1.moment_z [N m]
    """
    gravity, ball_1_total_mass = c[1], c[8]
    return ca.vertcat(0, -ball_1_total_mass*gravity, 0, 0, 0, 0)


def accelerations_of_ball(t, q, u, f, c):
    """Generalised accelerations of one tree of ball, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; f: own generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (6,): flight_1.x_acceleration [m/s^2], flight_1.y_acceleration [m/s^2], flight_1.z_acceleration [m/s^2],
            flight_1.angular_acceleration_x [rad/s^2], flight_1.angular_acceleration_y [rad/s^2], flight_1.angular_acceleration_z [rad/s^2]
    """
    inverse_ball_1_total_mass, inverse_ball_1_I_z_z = c[9], c[10]
    flight_1_x_force, flight_1_y_force, flight_1_z_force, flight_1_moment_x_force, flight_1_moment_y_force = f[0], f[1], f[2], f[3], f[4]
    flight_1_moment_z_force = f[5]
    flight_1_x_acc = flight_1_x_force*inverse_ball_1_total_mass
    flight_1_y_acc = flight_1_y_force*inverse_ball_1_total_mass
    flight_1_z_acc = flight_1_z_force*inverse_ball_1_total_mass
    flight_1_moment_x_acc = flight_1_moment_x_force*inverse_ball_1_I_z_z
    flight_1_moment_y_acc = flight_1_moment_y_force*inverse_ball_1_I_z_z
    flight_1_moment_z_acc = flight_1_moment_z_force*inverse_ball_1_I_z_z
    return ca.vertcat(flight_1_x_acc, flight_1_y_acc, flight_1_z_acc, flight_1_moment_x_acc, flight_1_moment_y_acc, flight_1_moment_z_acc)


def energy_of_ball(t, q, u, c):
    """Kinetic and potential energy of one tree of ball, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
    """
    half_ball_1_I_z_z, k6, k7 = c[11], c[12], c[13]
    flight_1_y, flight_1_q0, flight_1_q1, flight_1_q2, flight_1_q3 = q[1], q[3], q[4], q[5], q[6]
    flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, flight_1_angular_speed_x, flight_1_angular_speed_y = u[0], u[1], u[2], u[3], u[4]
    flight_1_angular_speed_z = u[5]
    ball_1_twice_q1 = 2*flight_1_q1
    ball_1_twice_q2 = 2*flight_1_q2
    ball_1_twice_q3 = 2*flight_1_q3
    ball_1_q1q1 = ball_1_twice_q1*flight_1_q1
    ball_1_q2q2 = ball_1_twice_q2*flight_1_q2
    ball_1_q3q3 = ball_1_twice_q3*flight_1_q3
    ball_1_q0q1 = ball_1_twice_q1*flight_1_q0
    ball_1_q0q2 = ball_1_twice_q2*flight_1_q0
    ball_1_q0q3 = ball_1_twice_q3*flight_1_q0
    ball_1_R_x_x = 1 - ball_1_q2q2 - ball_1_q3q3
    ball_1_twice_q1_times_flight_1_q2 = ball_1_twice_q1*flight_1_q2
    ball_1_R_x_y = ball_1_twice_q1_times_flight_1_q2 - ball_1_q0q3
    ball_1_twice_q1_times_flight_1_q3 = ball_1_twice_q1*flight_1_q3
    ball_1_R_x_z = ball_1_q0q2 + ball_1_twice_q1_times_flight_1_q3
    ball_1_R_y_x = ball_1_q0q3 + ball_1_twice_q1_times_flight_1_q2
    ball_1_R_y_y = 1 - ball_1_q1q1 - ball_1_q3q3
    ball_1_twice_q2_times_flight_1_q3 = ball_1_twice_q2*flight_1_q3
    ball_1_R_y_z = ball_1_twice_q2_times_flight_1_q3 - ball_1_q0q1
    ball_1_R_z_x = ball_1_twice_q1_times_flight_1_q3 - ball_1_q0q2
    ball_1_R_z_y = ball_1_q0q1 + ball_1_twice_q2_times_flight_1_q3
    ball_1_R_z_z = 1 - ball_1_q1q1 - ball_1_q2q2
    ball_1_velocity_x = ball_1_R_x_x*flight_1_x_speed + ball_1_R_y_x*flight_1_y_speed + ball_1_R_z_x*flight_1_z_speed
    ball_1_velocity_y = ball_1_R_x_y*flight_1_x_speed + ball_1_R_y_y*flight_1_y_speed + ball_1_R_z_y*flight_1_z_speed
    ball_1_velocity_z = ball_1_R_x_z*flight_1_x_speed + ball_1_R_y_z*flight_1_y_speed + ball_1_R_z_z*flight_1_z_speed
    kinetic = half_ball_1_I_z_z*flight_1_angular_speed_x*flight_1_angular_speed_x + half_ball_1_I_z_z*flight_1_angular_speed_y*flight_1_angular_speed_y + half_ball_1_I_z_z*flight_1_angular_speed_z*flight_1_angular_speed_z + k6*(ball_1_velocity_x*ball_1_velocity_x + ball_1_velocity_y*ball_1_velocity_y + ball_1_velocity_z*ball_1_velocity_z)
    potential = flight_1_y*k7
    return ca.vertcat(kinetic), ca.vertcat(potential)


def poses_of_ball(t, q, c):
    """Origins and rotations of the bodies of one tree of ball, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (3,): ball_1.x [m], ball_1.y [m], ball_1.z [m]
        rotations (9,): ball_1.R_xx [1], ball_1.R_xy [1], ball_1.R_xz [1], ball_1.R_yx [1], ball_1.R_yy [1], ball_1.R_yz [1], ball_1.R_zx
            [1], ball_1.R_zy [1], ball_1.R_zz [1]
    """
    flight_1_x, flight_1_y, flight_1_z, flight_1_q0, flight_1_q1, flight_1_q2, flight_1_q3 = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    ball_1_twice_q1 = 2*flight_1_q1
    ball_1_twice_q2 = 2*flight_1_q2
    ball_1_twice_q3 = 2*flight_1_q3
    ball_1_q1q1 = ball_1_twice_q1*flight_1_q1
    ball_1_q2q2 = ball_1_twice_q2*flight_1_q2
    ball_1_q3q3 = ball_1_twice_q3*flight_1_q3
    ball_1_q0q1 = ball_1_twice_q1*flight_1_q0
    ball_1_q0q2 = ball_1_twice_q2*flight_1_q0
    ball_1_q0q3 = ball_1_twice_q3*flight_1_q0
    ball_1_R_x_x = 1 - ball_1_q2q2 - ball_1_q3q3
    ball_1_twice_q1_times_flight_1_q2 = ball_1_twice_q1*flight_1_q2
    ball_1_R_x_y = ball_1_twice_q1_times_flight_1_q2 - ball_1_q0q3
    ball_1_twice_q1_times_flight_1_q3 = ball_1_twice_q1*flight_1_q3
    ball_1_R_x_z = ball_1_q0q2 + ball_1_twice_q1_times_flight_1_q3
    ball_1_R_y_x = ball_1_q0q3 + ball_1_twice_q1_times_flight_1_q2
    ball_1_R_y_y = 1 - ball_1_q1q1 - ball_1_q3q3
    ball_1_twice_q2_times_flight_1_q3 = ball_1_twice_q2*flight_1_q3
    ball_1_R_y_z = ball_1_twice_q2_times_flight_1_q3 - ball_1_q0q1
    ball_1_R_z_x = ball_1_twice_q1_times_flight_1_q3 - ball_1_q0q2
    ball_1_R_z_y = ball_1_q0q1 + ball_1_twice_q2_times_flight_1_q3
    ball_1_R_z_z = 1 - ball_1_q1q1 - ball_1_q2q2
    return (ca.vertcat(flight_1_x, flight_1_y, flight_1_z),
        ca.vertcat(ball_1_R_x_x, ball_1_R_x_y, ball_1_R_x_z, ball_1_R_y_x, ball_1_R_y_y, ball_1_R_y_z, ball_1_R_z_x, ball_1_R_z_y,
            ball_1_R_z_z))


def gaps_of_balls(t, q, u, c):
    """Gap and its rate of one pair of balls, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (1,): balls_1_2 [m]
        dG (1,): balls_1_2 [m/s]
    """
    minus_balls_1_2_reach_squared, half_inverse_balls_1_2_reach = c[6], c[7]
    flight_1_x, flight_1_y, flight_1_z, flight_2_x, flight_2_y, flight_2_z = q[0], q[1], q[2], q[7], q[8], q[9]
    flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, flight_2_x_speed, flight_2_y_speed = u[0], u[1], u[2], u[6], u[7]
    flight_2_z_speed = u[8]
    balls_1_2_apart_x = flight_1_x - flight_2_x
    balls_1_2_apart_y = flight_1_y - flight_2_y
    balls_1_2_apart_z = flight_1_z - flight_2_z
    balls_1_2_apart_rate_x = flight_1_x_speed - flight_2_x_speed
    balls_1_2_apart_rate_y = flight_1_y_speed - flight_2_y_speed
    balls_1_2_apart_rate_z = flight_1_z_speed - flight_2_z_speed
    balls_1_2_apart_squared = balls_1_2_apart_x*balls_1_2_apart_x + balls_1_2_apart_y*balls_1_2_apart_y + balls_1_2_apart_z*balls_1_2_apart_z
    balls_1_2_gap = half_inverse_balls_1_2_reach*(balls_1_2_apart_squared + minus_balls_1_2_reach_squared)
    balls_1_2_apart_squared_rate = 2*balls_1_2_apart_rate_x*balls_1_2_apart_x + 2*balls_1_2_apart_rate_y*balls_1_2_apart_y + 2*balls_1_2_apart_rate_z*balls_1_2_apart_z
    balls_1_2_gap_rate = balls_1_2_apart_squared_rate*half_inverse_balls_1_2_reach
    return ca.vertcat(balls_1_2_gap), ca.vertcat(balls_1_2_gap_rate)


def gap_accelerations_of_balls(t, q, u, a, c):
    """Second derivative of the gap of one pair of balls, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; a: rates of these; c: CONSTANTS.
    Returns, each a column vector:
        ddG (1,): balls_1_2 [m/s^2]
    """
    half_inverse_balls_1_2_reach = c[7]
    flight_1_x, flight_1_y, flight_1_z, flight_2_x, flight_2_y, flight_2_z = q[0], q[1], q[2], q[7], q[8], q[9]
    flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, flight_2_x_speed, flight_2_y_speed = u[0], u[1], u[2], u[6], u[7]
    flight_2_z_speed = u[8]
    flight_1_x_acceleration, flight_1_y_acceleration, flight_1_z_acceleration, flight_2_x_acceleration = a[0], a[1], a[2], a[6]
    flight_2_y_acceleration, flight_2_z_acceleration = a[7], a[8]
    balls_1_2_apart_x = flight_1_x - flight_2_x
    balls_1_2_apart_y = flight_1_y - flight_2_y
    balls_1_2_apart_z = flight_1_z - flight_2_z
    balls_1_2_apart_rate_x = flight_1_x_speed - flight_2_x_speed
    balls_1_2_apart_rate_y = flight_1_y_speed - flight_2_y_speed
    balls_1_2_apart_rate_z = flight_1_z_speed - flight_2_z_speed
    balls_1_2_apart_acceleration_x = flight_1_x_acceleration - flight_2_x_acceleration
    balls_1_2_apart_acceleration_y = flight_1_y_acceleration - flight_2_y_acceleration
    balls_1_2_apart_acceleration_z = flight_1_z_acceleration - flight_2_z_acceleration
    balls_1_2_apart_squared_rate_rate = 2*balls_1_2_apart_rate_x*balls_1_2_apart_rate_x + 2*balls_1_2_apart_rate_y*balls_1_2_apart_rate_y + 2*balls_1_2_apart_rate_z*balls_1_2_apart_rate_z + 2*balls_1_2_apart_acceleration_x*balls_1_2_apart_x + 2*balls_1_2_apart_acceleration_y*balls_1_2_apart_y + 2*balls_1_2_apart_acceleration_z*balls_1_2_apart_z
    balls_1_2_gap_rate_rate = balls_1_2_apart_squared_rate_rate*half_inverse_balls_1_2_reach
    return ca.vertcat(balls_1_2_gap_rate_rate)


def contact_of_balls(t, q, u, z, m, c):
    """Forces of one pair of balls, by the names of the first: power x tsuji. The normal force is the laws' own, not clamped: where it would
    pull, the contact ends.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; z: own entries of MEMORY; m: own entries of LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (12,): flight_1.x [N], flight_1.y [N], flight_1.z [N], flight_1.moment_x [N m], flight_1.moment_y [N m], flight_1.moment_z [N m],
            flight_2.x [N], flight_2.y [N], flight_2.z [N], flight_2.moment_x [N m], flight_2.moment_y [N m], flight_2.moment_z [N m]
        dz (1,): balls_1_2.dissipated [W]
        normal_force (1,): balls_1_2 [N]
        sliding_velocity (0,): empty
        in_range (1,): balls_1_2 [1]
    """
    stiffness, balls_1_2_reach, k6, balls_1_2_xi = c[2], c[5], c[12], c[15]
    flight_1_x, flight_1_y, flight_1_z, flight_2_x, flight_2_y, flight_2_z, flight_2_q0 = q[0], q[1], q[2], q[7], q[8], q[9], q[10]
    flight_2_q1, flight_2_q2, flight_2_q3 = q[11], q[12], q[13]
    flight_1_x_speed, flight_1_y_speed, flight_1_z_speed, flight_2_x_speed, flight_2_y_speed = u[0], u[1], u[2], u[6], u[7]
    flight_2_z_speed, flight_2_angular_speed_x, flight_2_angular_speed_y, flight_2_angular_speed_z = u[8], u[9], u[10], u[11]
    ball_2_twice_q1 = 2*flight_2_q1
    ball_2_twice_q2 = 2*flight_2_q2
    ball_2_twice_q3 = 2*flight_2_q3
    ball_2_q1q1 = ball_2_twice_q1*flight_2_q1
    ball_2_q2q2 = ball_2_twice_q2*flight_2_q2
    ball_2_q3q3 = ball_2_twice_q3*flight_2_q3
    ball_2_q0q1 = ball_2_twice_q1*flight_2_q0
    ball_2_q0q2 = ball_2_twice_q2*flight_2_q0
    ball_2_q0q3 = ball_2_twice_q3*flight_2_q0
    ball_2_R_x_x = 1 - ball_2_q2q2 - ball_2_q3q3
    ball_2_twice_q1_times_flight_2_q2 = ball_2_twice_q1*flight_2_q2
    ball_2_R_x_y = ball_2_twice_q1_times_flight_2_q2 - ball_2_q0q3
    ball_2_twice_q1_times_flight_2_q3 = ball_2_twice_q1*flight_2_q3
    ball_2_R_x_z = ball_2_q0q2 + ball_2_twice_q1_times_flight_2_q3
    ball_2_R_y_x = ball_2_q0q3 + ball_2_twice_q1_times_flight_2_q2
    ball_2_R_y_y = 1 - ball_2_q1q1 - ball_2_q3q3
    ball_2_twice_q2_times_flight_2_q3 = ball_2_twice_q2*flight_2_q3
    ball_2_R_y_z = ball_2_twice_q2_times_flight_2_q3 - ball_2_q0q1
    ball_2_R_z_x = ball_2_twice_q1_times_flight_2_q3 - ball_2_q0q2
    ball_2_R_z_y = ball_2_q0q1 + ball_2_twice_q2_times_flight_2_q3
    ball_2_R_z_z = 1 - ball_2_q1q1 - ball_2_q2q2
    ball_2_turning_x = ball_2_R_x_x*flight_2_angular_speed_x + ball_2_R_x_y*flight_2_angular_speed_y + ball_2_R_x_z*flight_2_angular_speed_z
    ball_2_turning_y = ball_2_R_y_x*flight_2_angular_speed_x + ball_2_R_y_y*flight_2_angular_speed_y + ball_2_R_y_z*flight_2_angular_speed_z
    ball_2_turning_z = ball_2_R_z_x*flight_2_angular_speed_x + ball_2_R_z_y*flight_2_angular_speed_y + ball_2_R_z_z*flight_2_angular_speed_z
    balls_1_2_apart_x = flight_1_x - flight_2_x
    balls_1_2_apart_y = flight_1_y - flight_2_y
    balls_1_2_apart_z = flight_1_z - flight_2_z
    balls_1_2_apart_squared = balls_1_2_apart_x*balls_1_2_apart_x + balls_1_2_apart_y*balls_1_2_apart_y + balls_1_2_apart_z*balls_1_2_apart_z
    balls_1_2_distance = ca.sqrt(balls_1_2_apart_squared)
    balls_1_2_penetration = balls_1_2_reach - balls_1_2_distance
    balls_1_2_elastic_force = ca.if_else(balls_1_2_penetration > 0, balls_1_2_penetration*ca.sqrt(balls_1_2_penetration)*stiffness, 0)
    balls_1_2_normal_x = balls_1_2_apart_x/balls_1_2_distance
    balls_1_2_normal_y = balls_1_2_apart_y/balls_1_2_distance
    balls_1_2_normal_z = balls_1_2_apart_z/balls_1_2_distance
    balls_1_2_relative_rate_x = flight_1_x_speed + ball_2_turning_z*balls_1_2_apart_y - flight_2_x_speed - ball_2_turning_y*balls_1_2_apart_z
    balls_1_2_relative_rate_y = flight_1_y_speed + ball_2_turning_x*balls_1_2_apart_z - flight_2_y_speed - ball_2_turning_z*balls_1_2_apart_x
    balls_1_2_relative_rate_z = flight_1_z_speed + ball_2_turning_y*balls_1_2_apart_x - flight_2_z_speed - ball_2_turning_x*balls_1_2_apart_y
    balls_1_2_penetration_rate = -balls_1_2_normal_x*balls_1_2_relative_rate_x - balls_1_2_normal_y*balls_1_2_relative_rate_y - balls_1_2_normal_z*balls_1_2_relative_rate_z
    base = balls_1_2_elastic_force*k6/balls_1_2_penetration
    balls_1_2_resistance = ca.if_else(balls_1_2_penetration > 0, balls_1_2_penetration_rate*balls_1_2_xi*ca.sqrt(base), 0)
    balls_1_2_normal_force = balls_1_2_elastic_force + balls_1_2_resistance
    balls_1_2_normal_power = balls_1_2_penetration_rate*balls_1_2_resistance
    balls_1_2_push_x = balls_1_2_normal_force*balls_1_2_normal_x
    balls_1_2_push_y = balls_1_2_normal_force*balls_1_2_normal_y
    balls_1_2_push_z = balls_1_2_normal_force*balls_1_2_normal_z
    ball_2_moment_x = balls_1_2_apart_y*balls_1_2_push_z - balls_1_2_apart_z*balls_1_2_push_y
    ball_2_moment_y = balls_1_2_apart_z*balls_1_2_push_x - balls_1_2_apart_x*balls_1_2_push_z
    ball_2_moment_z = balls_1_2_apart_x*balls_1_2_push_y - balls_1_2_apart_y*balls_1_2_push_x
    balls_1_2_push_on_flight_2_moment_x = -ball_2_R_x_x*ball_2_moment_x - ball_2_R_y_x*ball_2_moment_y - ball_2_R_z_x*ball_2_moment_z
    balls_1_2_push_on_flight_2_moment_y = -ball_2_R_x_y*ball_2_moment_x - ball_2_R_y_y*ball_2_moment_y - ball_2_R_z_y*ball_2_moment_z
    balls_1_2_push_on_flight_2_moment_z = -ball_2_R_x_z*ball_2_moment_x - ball_2_R_y_z*ball_2_moment_y - ball_2_R_z_z*ball_2_moment_z
    return (ca.vertcat(balls_1_2_push_x, balls_1_2_push_y, balls_1_2_push_z, 0, 0, 0, -balls_1_2_push_x, -balls_1_2_push_y,
            -balls_1_2_push_z, balls_1_2_push_on_flight_2_moment_x, balls_1_2_push_on_flight_2_moment_y,
            balls_1_2_push_on_flight_2_moment_z),
        ca.vertcat(balls_1_2_normal_power), ca.vertcat(balls_1_2_normal_force), ca.vertcat(), ca.vertcat(1))


def stored_energy_of_balls(t, q, u, c):
    """Energy stored by the stiffness of one pair of balls, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        stored (1,): balls_1_2 [J]
    """
    balls_1_2_reach, two_fifths_of_stiffness = c[5], c[14]
    flight_1_x, flight_1_y, flight_1_z, flight_2_x, flight_2_y, flight_2_z = q[0], q[1], q[2], q[7], q[8], q[9]
    balls_1_2_apart_x = flight_1_x - flight_2_x
    balls_1_2_apart_y = flight_1_y - flight_2_y
    balls_1_2_apart_z = flight_1_z - flight_2_z
    balls_1_2_apart_squared = balls_1_2_apart_x*balls_1_2_apart_x + balls_1_2_apart_y*balls_1_2_apart_y + balls_1_2_apart_z*balls_1_2_apart_z
    balls_1_2_distance = ca.sqrt(balls_1_2_apart_squared)
    balls_1_2_penetration = balls_1_2_reach - balls_1_2_distance
    balls_1_2_stored_energy = ca.if_else(balls_1_2_penetration > 0, two_fifths_of_stiffness*balls_1_2_penetration*balls_1_2_penetration*ca.sqrt(balls_1_2_penetration), 0)
    return ca.vertcat(balls_1_2_stored_energy)


def outputs_of_balls(t, q, u, c):
    """Named quantities of one pair of balls, by the names of the first.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (1,): balls_1_2.gap [m]
    """
    balls_1_2_reach = c[5]
    flight_1_x, flight_1_y, flight_1_z, flight_2_x, flight_2_y, flight_2_z = q[0], q[1], q[2], q[7], q[8], q[9]
    balls_1_2_apart_x = flight_1_x - flight_2_x
    balls_1_2_apart_y = flight_1_y - flight_2_y
    balls_1_2_apart_z = flight_1_z - flight_2_z
    balls_1_2_apart_squared = balls_1_2_apart_x*balls_1_2_apart_x + balls_1_2_apart_y*balls_1_2_apart_y + balls_1_2_apart_z*balls_1_2_apart_z
    balls_1_2_distance = ca.sqrt(balls_1_2_apart_squared)
    balls_1_2_penetration = balls_1_2_reach - balls_1_2_distance
    return ca.vertcat(-balls_1_2_penetration)


def gaps_of_floor(t, q, u, c):
    """Gap and its rate of one pair of floor, by the names of the first; arguments and returns as of gaps_of_balls."""
    radius = c[0]
    flight_1_y = q[1]
    flight_1_y_speed = u[1]
    floor_1_gap = flight_1_y - radius
    return ca.vertcat(floor_1_gap), ca.vertcat(flight_1_y_speed)


def gap_accelerations_of_floor(t, q, u, a, c):
    """Second derivative of the gap of one pair of floor, by the names of the first; arguments and returns as of gap_accelerations_of_balls."""
    flight_1_y_acceleration = a[1]
    return ca.vertcat(flight_1_y_acceleration)


def contact_of_floor(t, q, u, z, m, c):
    """Forces of one pair of floor, by the names of the first: power x tsuji. The normal force is the laws' own, not clamped: where it would
    pull, the contact ends.

    Arguments: t [s]; q: own entries of COORDINATES; u: own entries of SPEEDS; z: own entries of MEMORY; m: own entries of LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (6,): flight_1.x [N], flight_1.y [N], flight_1.z [N], flight_1.moment_x [N m], flight_1.moment_y [N m], flight_1.moment_z [N m]
        dz (1,): floor_1.dissipated [W]
        normal_force (1,): floor_1 [N]
        sliding_velocity (0,): empty
        in_range (1,): floor_1 [1]
    """
    radius, stiffness, ball_1_total_mass, balls_1_2_xi = c[0], c[2], c[8], c[15]
    flight_1_y = q[1]
    flight_1_y_speed = u[1]
    floor_1_gap = flight_1_y - radius
    floor_1_elastic_force = ca.if_else(-floor_1_gap > 0, -floor_1_gap*ca.sqrt(-floor_1_gap)*stiffness, 0)
    base_2 = -ball_1_total_mass*floor_1_elastic_force/floor_1_gap
    floor_1_resistance = ca.if_else(-floor_1_gap > 0, -balls_1_2_xi*flight_1_y_speed*ca.sqrt(base_2), 0)
    floor_1_normal_force = floor_1_elastic_force + floor_1_resistance
    floor_1_normal_power = -flight_1_y_speed*floor_1_resistance
    return (ca.vertcat(0, floor_1_normal_force, 0, 0, 0, 0), ca.vertcat(floor_1_normal_power), ca.vertcat(floor_1_normal_force),
            ca.vertcat(),
        ca.vertcat(1))


def stored_energy_of_floor(t, q, u, c):
    """Energy stored by the stiffness of one pair of floor, by the names of the first; arguments and returns as of stored_energy_of_balls."""
    radius, two_fifths_of_stiffness = c[0], c[14]
    flight_1_y = q[1]
    floor_1_gap = flight_1_y - radius
    floor_1_stored_energy = ca.if_else(-floor_1_gap > 0, two_fifths_of_stiffness*(-floor_1_gap)**2*ca.sqrt(-floor_1_gap), 0)
    return ca.vertcat(floor_1_stored_energy)


def outputs_of_floor(t, q, u, c):
    """Named quantities of one pair of floor, by the names of the first; arguments and returns as of outputs_of_balls."""
    radius = c[0]
    flight_1_y = q[1]
    floor_1_gap = flight_1_y - radius
    return ca.vertcat(floor_1_gap)


def gaps_of_wall_1(t, q, u, c):
    """Gap and its rate of one pair of wall_1, by the names of the first; arguments and returns as of gaps_of_balls."""
    radius, wall_1_1_second_arm_x = c[0], c[3]
    flight_1_x = q[0]
    flight_1_x_speed = u[0]
    wall_1_1_apart_x = flight_1_x - wall_1_1_second_arm_x
    wall_1_1_gap = wall_1_1_apart_x - radius
    return ca.vertcat(wall_1_1_gap), ca.vertcat(flight_1_x_speed)


def gap_accelerations_of_wall_1(t, q, u, a, c):
    """Second derivative of the gap of one pair of wall_1, by the names of the first; arguments and returns as of
    gap_accelerations_of_balls."""
    flight_1_x_acceleration = a[0]
    return ca.vertcat(flight_1_x_acceleration)


def contact_of_wall_1(t, q, u, z, m, c):
    """Forces of one pair of wall_1, by the names of the first: power x tsuji; arguments and returns as of contact_of_floor."""
    radius, stiffness, wall_1_1_second_arm_x, ball_1_total_mass, balls_1_2_xi = c[0], c[2], c[3], c[8], c[15]
    flight_1_x = q[0]
    flight_1_x_speed = u[0]
    wall_1_1_apart_x = flight_1_x - wall_1_1_second_arm_x
    wall_1_1_gap = wall_1_1_apart_x - radius
    wall_1_1_elastic_force = ca.if_else(-wall_1_1_gap > 0, -wall_1_1_gap*ca.sqrt(-wall_1_1_gap)*stiffness, 0)
    base_3 = -ball_1_total_mass*wall_1_1_elastic_force/wall_1_1_gap
    wall_1_1_resistance = ca.if_else(-wall_1_1_gap > 0, -balls_1_2_xi*flight_1_x_speed*ca.sqrt(base_3), 0)
    wall_1_1_normal_force = wall_1_1_elastic_force + wall_1_1_resistance
    wall_1_1_normal_power = -flight_1_x_speed*wall_1_1_resistance
    return (ca.vertcat(wall_1_1_normal_force, *[0]*5), ca.vertcat(wall_1_1_normal_power), ca.vertcat(wall_1_1_normal_force), ca.vertcat(),
        ca.vertcat(1))


def stored_energy_of_wall_1(t, q, u, c):
    """Energy stored by the stiffness of one pair of wall_1, by the names of the first; arguments and returns as of stored_energy_of_balls."""
    radius, wall_1_1_second_arm_x, two_fifths_of_stiffness = c[0], c[3], c[14]
    flight_1_x = q[0]
    wall_1_1_apart_x = flight_1_x - wall_1_1_second_arm_x
    wall_1_1_gap = wall_1_1_apart_x - radius
    wall_1_1_stored_energy = ca.if_else(-wall_1_1_gap > 0, two_fifths_of_stiffness*(-wall_1_1_gap)**2*ca.sqrt(-wall_1_1_gap), 0)
    return ca.vertcat(wall_1_1_stored_energy)


def outputs_of_wall_1(t, q, u, c):
    """Named quantities of one pair of wall_1, by the names of the first; arguments and returns as of outputs_of_balls."""
    radius, wall_1_1_second_arm_x = c[0], c[3]
    flight_1_x = q[0]
    wall_1_1_apart_x = flight_1_x - wall_1_1_second_arm_x
    wall_1_1_gap = wall_1_1_apart_x - radius
    return ca.vertcat(wall_1_1_gap)


def gaps_of_wall_2(t, q, u, c):
    """Gap and its rate of one pair of wall_2, by the names of the first; arguments and returns as of gaps_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_x = q[0]
    flight_1_x_speed = u[0]
    wall_2_1_apart_x = flight_1_x - wall_2_1_second_arm_x
    wall_2_1_gap = -wall_2_1_apart_x - radius
    return ca.vertcat(wall_2_1_gap), ca.vertcat(-flight_1_x_speed)


def gap_accelerations_of_wall_2(t, q, u, a, c):
    """Second derivative of the gap of one pair of wall_2, by the names of the first; arguments and returns as of
    gap_accelerations_of_balls."""
    flight_1_x_acceleration = a[0]
    return ca.vertcat(-flight_1_x_acceleration)


def contact_of_wall_2(t, q, u, z, m, c):
    """Forces of one pair of wall_2, by the names of the first: power x tsuji; arguments and returns as of contact_of_floor."""
    radius, stiffness, wall_2_1_second_arm_x, ball_1_total_mass, balls_1_2_xi = c[0], c[2], c[4], c[8], c[15]
    flight_1_x = q[0]
    flight_1_x_speed = u[0]
    wall_2_1_apart_x = flight_1_x - wall_2_1_second_arm_x
    wall_2_1_gap = -wall_2_1_apart_x - radius
    wall_2_1_elastic_force = ca.if_else(-wall_2_1_gap > 0, -wall_2_1_gap*ca.sqrt(-wall_2_1_gap)*stiffness, 0)
    base_4 = -ball_1_total_mass*wall_2_1_elastic_force/wall_2_1_gap
    wall_2_1_resistance = ca.if_else(-wall_2_1_gap > 0, balls_1_2_xi*flight_1_x_speed*ca.sqrt(base_4), 0)
    wall_2_1_normal_force = wall_2_1_elastic_force + wall_2_1_resistance
    wall_2_1_normal_power = flight_1_x_speed*wall_2_1_resistance
    return (ca.vertcat(-wall_2_1_normal_force, *[0]*5), ca.vertcat(wall_2_1_normal_power), ca.vertcat(wall_2_1_normal_force), ca.vertcat(),
        ca.vertcat(1))


def stored_energy_of_wall_2(t, q, u, c):
    """Energy stored by the stiffness of one pair of wall_2, by the names of the first; arguments and returns as of stored_energy_of_balls."""
    radius, wall_2_1_second_arm_x, two_fifths_of_stiffness = c[0], c[4], c[14]
    flight_1_x = q[0]
    wall_2_1_apart_x = flight_1_x - wall_2_1_second_arm_x
    wall_2_1_gap = -wall_2_1_apart_x - radius
    wall_2_1_stored_energy = ca.if_else(-wall_2_1_gap > 0, two_fifths_of_stiffness*(-wall_2_1_gap)**2*ca.sqrt(-wall_2_1_gap), 0)
    return ca.vertcat(wall_2_1_stored_energy)


def outputs_of_wall_2(t, q, u, c):
    """Named quantities of one pair of wall_2, by the names of the first; arguments and returns as of outputs_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_x = q[0]
    wall_2_1_apart_x = flight_1_x - wall_2_1_second_arm_x
    wall_2_1_gap = -wall_2_1_apart_x - radius
    return ca.vertcat(wall_2_1_gap)


def gaps_of_wall_3(t, q, u, c):
    """Gap and its rate of one pair of wall_3, by the names of the first; arguments and returns as of gaps_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_z = q[2]
    flight_1_z_speed = u[2]
    wall_3_1_apart_z = flight_1_z + wall_2_1_second_arm_x
    wall_3_1_gap = wall_3_1_apart_z - radius
    return ca.vertcat(wall_3_1_gap), ca.vertcat(flight_1_z_speed)


def gap_accelerations_of_wall_3(t, q, u, a, c):
    """Second derivative of the gap of one pair of wall_3, by the names of the first; arguments and returns as of
    gap_accelerations_of_balls."""
    flight_1_z_acceleration = a[2]
    return ca.vertcat(flight_1_z_acceleration)


def contact_of_wall_3(t, q, u, z, m, c):
    """Forces of one pair of wall_3, by the names of the first: power x tsuji; arguments and returns as of contact_of_floor."""
    radius, stiffness, wall_2_1_second_arm_x, ball_1_total_mass, balls_1_2_xi = c[0], c[2], c[4], c[8], c[15]
    flight_1_z = q[2]
    flight_1_z_speed = u[2]
    wall_3_1_apart_z = flight_1_z + wall_2_1_second_arm_x
    wall_3_1_gap = wall_3_1_apart_z - radius
    wall_3_1_elastic_force = ca.if_else(-wall_3_1_gap > 0, -wall_3_1_gap*ca.sqrt(-wall_3_1_gap)*stiffness, 0)
    base_5 = -ball_1_total_mass*wall_3_1_elastic_force/wall_3_1_gap
    wall_3_1_resistance = ca.if_else(-wall_3_1_gap > 0, -balls_1_2_xi*flight_1_z_speed*ca.sqrt(base_5), 0)
    wall_3_1_normal_force = wall_3_1_elastic_force + wall_3_1_resistance
    wall_3_1_normal_power = -flight_1_z_speed*wall_3_1_resistance
    return (ca.vertcat(0, 0, wall_3_1_normal_force, 0, 0, 0), ca.vertcat(wall_3_1_normal_power), ca.vertcat(wall_3_1_normal_force),
        ca.vertcat(), ca.vertcat(1))


def stored_energy_of_wall_3(t, q, u, c):
    """Energy stored by the stiffness of one pair of wall_3, by the names of the first; arguments and returns as of stored_energy_of_balls."""
    radius, wall_2_1_second_arm_x, two_fifths_of_stiffness = c[0], c[4], c[14]
    flight_1_z = q[2]
    wall_3_1_apart_z = flight_1_z + wall_2_1_second_arm_x
    wall_3_1_gap = wall_3_1_apart_z - radius
    wall_3_1_stored_energy = ca.if_else(-wall_3_1_gap > 0, two_fifths_of_stiffness*(-wall_3_1_gap)**2*ca.sqrt(-wall_3_1_gap), 0)
    return ca.vertcat(wall_3_1_stored_energy)


def outputs_of_wall_3(t, q, u, c):
    """Named quantities of one pair of wall_3, by the names of the first; arguments and returns as of outputs_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_z = q[2]
    wall_3_1_apart_z = flight_1_z + wall_2_1_second_arm_x
    wall_3_1_gap = wall_3_1_apart_z - radius
    return ca.vertcat(wall_3_1_gap)


def gaps_of_wall_4(t, q, u, c):
    """Gap and its rate of one pair of wall_4, by the names of the first; arguments and returns as of gaps_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_z = q[2]
    flight_1_z_speed = u[2]
    wall_4_1_apart_z = flight_1_z - wall_2_1_second_arm_x
    wall_4_1_gap = -wall_4_1_apart_z - radius
    return ca.vertcat(wall_4_1_gap), ca.vertcat(-flight_1_z_speed)


def gap_accelerations_of_wall_4(t, q, u, a, c):
    """Second derivative of the gap of one pair of wall_4, by the names of the first; arguments and returns as of
    gap_accelerations_of_balls."""
    flight_1_z_acceleration = a[2]
    return ca.vertcat(-flight_1_z_acceleration)


def contact_of_wall_4(t, q, u, z, m, c):
    """Forces of one pair of wall_4, by the names of the first: power x tsuji; arguments and returns as of contact_of_floor."""
    radius, stiffness, wall_2_1_second_arm_x, ball_1_total_mass, balls_1_2_xi = c[0], c[2], c[4], c[8], c[15]
    flight_1_z = q[2]
    flight_1_z_speed = u[2]
    wall_4_1_apart_z = flight_1_z - wall_2_1_second_arm_x
    wall_4_1_gap = -wall_4_1_apart_z - radius
    wall_4_1_elastic_force = ca.if_else(-wall_4_1_gap > 0, -wall_4_1_gap*ca.sqrt(-wall_4_1_gap)*stiffness, 0)
    base_6 = -ball_1_total_mass*wall_4_1_elastic_force/wall_4_1_gap
    wall_4_1_resistance = ca.if_else(-wall_4_1_gap > 0, balls_1_2_xi*flight_1_z_speed*ca.sqrt(base_6), 0)
    wall_4_1_normal_force = wall_4_1_elastic_force + wall_4_1_resistance
    wall_4_1_normal_power = flight_1_z_speed*wall_4_1_resistance
    return (ca.vertcat(0, 0, -wall_4_1_normal_force, 0, 0, 0), ca.vertcat(wall_4_1_normal_power), ca.vertcat(wall_4_1_normal_force),
        ca.vertcat(), ca.vertcat(1))


def stored_energy_of_wall_4(t, q, u, c):
    """Energy stored by the stiffness of one pair of wall_4, by the names of the first; arguments and returns as of stored_energy_of_balls."""
    radius, wall_2_1_second_arm_x, two_fifths_of_stiffness = c[0], c[4], c[14]
    flight_1_z = q[2]
    wall_4_1_apart_z = flight_1_z - wall_2_1_second_arm_x
    wall_4_1_gap = -wall_4_1_apart_z - radius
    wall_4_1_stored_energy = ca.if_else(-wall_4_1_gap > 0, two_fifths_of_stiffness*(-wall_4_1_gap)**2*ca.sqrt(-wall_4_1_gap), 0)
    return ca.vertcat(wall_4_1_stored_energy)


def outputs_of_wall_4(t, q, u, c):
    """Named quantities of one pair of wall_4, by the names of the first; arguments and returns as of outputs_of_balls."""
    radius, wall_2_1_second_arm_x = c[0], c[4]
    flight_1_z = q[2]
    wall_4_1_apart_z = flight_1_z - wall_2_1_second_arm_x
    wall_4_1_gap = -wall_4_1_apart_z - radius
    return ca.vertcat(wall_4_1_gap)


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (35,): MEMORY [W]
    """
    return ca.vertcat(*[0]*35)


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns a column vector for each row: the point, then its directions and sizes.
    """
    radius, width = p[0], p[2]
    minus_half_width = -width/2
    half_width = width/2
    return (*[ca.vertcat(0, 0, 0, radius)]*21, *[ca.vertcat(0, 0, 0, 0, 1, 0), ca.vertcat(0, 0, 0, radius)]*5,
        *[ca.vertcat(minus_half_width, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0, radius)]*5,
        *[ca.vertcat(half_width, 0, 0, -1, 0, 0), ca.vertcat(0, 0, 0, radius)]*5,
        *[ca.vertcat(0, 0, minus_half_width, 0, 0, 1), ca.vertcat(0, 0, 0, radius)]*5, ca.vertcat(0, 0, half_width, 0, 0, -1),
        ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, half_width, 0, 0, -1), ca.vertcat(0, 0, 0, radius),
        ca.vertcat(0, 0, half_width, 0, 0, -1), ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, half_width, 0, 0, -1),
        ca.vertcat(0, 0, 0, radius), ca.vertcat(0, 0, half_width, 0, 0, -1), ca.vertcat(0, 0, 0, 0, -1, 0), *[ca.vertcat(0, 0, 0)]*5,
        *[ca.vertcat(0, 0, 0, radius)]*5)


def _of_trees(name, t, q, c, *of_speeds):
    """What a function of one tree returns for each; `of_speeds` are arguments with an entry for each speed."""
    kinds = (("ball", BALL_TREES),)
    return [globals()[f"{name}_of_{kind}"](t, q[of_q], *(x[of_u] for x in of_speeds), c)
            for (of_q, of_u), kind in zip(TREES, (kind for kind, members in kinds for _ in members), strict=True)]


def _of_pairs(name, t, q, c, *of_speeds):
    """What a function of one pair returns for each; `of_speeds` are arguments with an entry for each speed."""
    return [globals()[f"{name}_of_{family}"](t, q[of_q], *(x[of_u] for x in of_speeds), c)
            for family, members in FAMILIES for _, of_q, of_u, *_ in members]


def _spread(x, rows, count, times=1):
    """Vector of zeros but for some rows, a number of times."""
    whole = type(x)(times*count, 1)
    whole[[k*count + row for k in range(times) for row in rows]] = x
    return whole


def _contact(family, of_q, of_u, of_z, of_m):
    """Function of the forces of one pair, of the whole vectors."""
    def contact(t, q, u, z, m, c):
        found = [*globals()[f"contact_of_{family}"](t, q[of_q], u[of_u], z[of_z], m[of_m], c)]
        found[:2] = _spread(found[0], of_u, u.numel()), _spread(found[1], of_z, z.numel())
        if len(found) > 5:  # along and dz_along of friction with modes
            times = found[5].numel()//len(of_u)
            found[5:7] = _spread(found[5], of_u, u.numel(), times), _spread(found[6], of_z, z.numel(), times)
        return tuple(found)
    return contact


globals().update({f"contact_{name}": _contact(family, *rows) for family, members in FAMILIES for name, *rows in members})


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("coordinate_rates", t, q, c, u))


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    G, dG = zip(*_of_pairs("gaps", t, q, c, u), strict=True)
    return ca.vertcat(*G), ca.vertcat(*dG)


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    """
    return ca.vertcat(*_of_pairs("gap_accelerations", t, q, c, u, a))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("applied", t, q, c, u))


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives, of which there are none.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    """
    return ca.vertcat(*_of_trees("accelerations", t, q, c, u, f)), ca.vertcat()


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    """
    positions, rotations = zip(*_of_trees("poses", t, q, c), strict=True)
    return ca.vertcat(*positions), ca.vertcat(*rotations)


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    return ca.vertcat(*_of_pairs("outputs", t, q, c, u))


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    """
    kinetic, potential = zip(*_of_trees("energy", t, q, c, u), strict=True)
    return sum(kinetic), sum(potential), ca.vertcat(*_of_pairs("stored_energy", t, q, c, u))
