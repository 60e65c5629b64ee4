"""ball_bearing: ball bearing: cage speed and passing frequency. Generated from derive/scenes/ball_bearing.py.

Do not edit; regenerate with `hertzwerk derive ball_bearing`.
Effects:
    motor: constant speed of shaft.angle
    load: force on ring = (0, -load, 0) in axes of ground
    support_x: viscous damper of shaft.x
    support_y: viscous damper of shaft.y
    inner_0, outer_0, inner_1, outer_1, inner_2, outer_2, inner_3, outer_3, inner_4, outer_4, inner_5, outer_5: power x power_damping
    inner_0_friction: smooth_coulomb at inner_0
    outer_0_friction: smooth_coulomb at outer_0
    inner_1_friction: smooth_coulomb at inner_1
    outer_1_friction: smooth_coulomb at outer_1
    inner_2_friction: smooth_coulomb at inner_2
    outer_2_friction: smooth_coulomb at outer_2
    inner_3_friction: smooth_coulomb at inner_3
    outer_3_friction: smooth_coulomb at outer_3
    inner_4_friction: smooth_coulomb at inner_4
    outer_4_friction: smooth_coulomb at outer_4
    inner_5_friction: smooth_coulomb at inner_5
    outer_5_friction: smooth_coulomb at outer_5
    energy_ledger: work put in, energy dissipated per effect
Units: 615 assignments and 1317 outputs checked, all consistent
Operations: flight 1008 (equations of motion and gaps); in contact also contact_inner_0 100, contact_outer_0 74, contact_inner_1 114, contact_outer_1 88, contact_inner_2 116, contact_outer_2 90, contact_inner_3 104, contact_outer_3 78, contact_inner_4 117, contact_outer_4 91, contact_inner_5 114, contact_outer_5 88
"""

import casadi as ca

NAME = "ball_bearing"
SOURCE = "derive/scenes/ball_bearing.py"
SUMMARY = "ball bearing: cage speed and passing frequency"
FORMAT = "hertzwerk module 1"
DIGEST = "ada5f000d7821ef505bb42fa6354f3c1"

EFFECTS = (
    ("motor", "drive", "constant speed of shaft.angle"), ("load", "force", "force on ring = (0, -load, 0) in axes of ground"),
    ("support_x", "damper", "viscous damper of shaft.x"), ("support_y", "damper", "viscous damper of shaft.y"),
    ("inner_0", "contact", "power x power_damping"), ("inner_0_friction", "friction", "smooth_coulomb at inner_0"),
    ("outer_0", "contact", "power x power_damping"), ("outer_0_friction", "friction", "smooth_coulomb at outer_0"),
    ("inner_1", "contact", "power x power_damping"), ("inner_1_friction", "friction", "smooth_coulomb at inner_1"),
    ("outer_1", "contact", "power x power_damping"), ("outer_1_friction", "friction", "smooth_coulomb at outer_1"),
    ("inner_2", "contact", "power x power_damping"), ("inner_2_friction", "friction", "smooth_coulomb at inner_2"),
    ("outer_2", "contact", "power x power_damping"), ("outer_2_friction", "friction", "smooth_coulomb at outer_2"),
    ("inner_3", "contact", "power x power_damping"), ("inner_3_friction", "friction", "smooth_coulomb at inner_3"),
    ("outer_3", "contact", "power x power_damping"), ("outer_3_friction", "friction", "smooth_coulomb at outer_3"),
    ("inner_4", "contact", "power x power_damping"), ("inner_4_friction", "friction", "smooth_coulomb at inner_4"),
    ("outer_4", "contact", "power x power_damping"), ("outer_4_friction", "friction", "smooth_coulomb at outer_4"),
    ("inner_5", "contact", "power x power_damping"), ("inner_5_friction", "friction", "smooth_coulomb at inner_5"),
    ("outer_5", "contact", "power x power_damping"), ("outer_5_friction", "friction", "smooth_coulomb at outer_5"),
    ("energy_ledger", "ledger", "work put in, energy dissipated per effect"),
)

PARAMETERS = (
    ("ring_mass", "kg", 0.5, "with its shaft"),
    ("ring_inertia", "kg m^2", 0.0001, "body ring, inertia"),
    ("cage_mass", "g", 10, "body cage, mass"),
    ("cage_inertia", "kg m^2", 4e-06, "body cage, inertia"),
    ("ball_mass", "g", 2.05, "body ball_0, mass"),
    ("ball_inertia", "kg m^2", 1.3e-08, "body ball_0, inertia"),
    ("ball_diameter", "mm", 7.94, ""),
    ("pitch_diameter", "mm", 39.04, "scales, arm"),
    ("clearance", "um", 10, "radial, between balls and rings together"),
    ("speed", "rpm", 3000, "of the inner ring"),
    ("load", "N", 500, ""),
    ("support_damping", "N s/m", 500, "what the shaft's support damps"),
    ("stiffness", "N/m^1.5", 10000000000.0, "effect inner_0, stiffness of power"),
    ("damping", "N s/m^2.5", 100000000000.0, "effect inner_0, coefficient of the damping of power_damping"),
    ("friction_coefficient", "1", 0.1, "effect inner_0_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "mm/s", 10, "effect inner_0_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("pace", "m/s", 1, "scales, speed"),
)

LIMITS = (
    ("ring_mass", "defined", 0, None, True, False, "body ring, mass"),
    ("ring_inertia", "defined", 0, None, False, False, "body ring, inertia"),
    ("cage_mass", "defined", 0, None, True, False, "body cage, mass"),
    ("cage_inertia", "defined", 0, None, False, False, "body cage, inertia"),
    ("ball_mass", "defined", 0, None, True, False, "body ball_0, mass"),
    ("ball_inertia", "defined", 0, None, False, False, "body ball_0, inertia"),
    ("support_damping", "defined", 0, None, False, False, "effect support_x, damping"),
    ("stiffness", "defined", 0, None, True, False, "effect inner_0, stiffness of power"),
    ("damping", "defined", 0, None, True, False, "effect inner_0, coefficient of the damping of power_damping"),
    ("friction_coefficient", "defined", 0, None, False, False, "effect inner_0_friction, coefficient of friction of smooth_coulomb"),
    ("friction_speed", "defined", 0, None, True, False, "effect inner_0_friction, speed over which the friction force builds up of smooth_coulomb"),
    ("clearance", "defined", 0, None, True, False, "scales, length"),
    ("pace", "defined", 0, None, True, False, "scales, speed"),
    ("pitch_diameter", "defined", 0, None, True, False, "scales, arm"),
)

SUM_LIMITS = (
    ((("ball_diameter", -0.5), ("clearance", -0.5), ("pitch_diameter", 0.5)), "defined", 0, None, True, False, "pair inner_0, second radius"),
    ((("ball_diameter", 0.5), ("clearance", 0.5), ("pitch_diameter", 0.5)), "defined", 0, None, True, False, "pair outer_0, socket radius"),
    ((("clearance", 0.5), ("pitch_diameter", 0.5)), "defined", 0, None, True, False, "pair outer_0, clearance"),
)

COORDINATES = (
    ("shaft.x", "m"), ("shaft.y", "m"), ("cage_turn.angle", "rad"), ("way_0.travel", "m"), ("spin_0.angle", "rad"), ("way_1.travel", "m"),
    ("spin_1.angle", "rad"), ("way_2.travel", "m"), ("spin_2.angle", "rad"), ("way_3.travel", "m"), ("spin_3.angle", "rad"),
    ("way_4.travel", "m"), ("spin_4.angle", "rad"), ("way_5.travel", "m"), ("spin_5.angle", "rad"),
)

SPEEDS = (
    ("shaft.x_speed", "m/s"), ("shaft.y_speed", "m/s"), ("cage_turn.speed", "rad/s"), ("way_0.speed", "m/s"), ("spin_0.speed", "rad/s"),
    ("way_1.speed", "m/s"), ("spin_1.speed", "rad/s"), ("way_2.speed", "m/s"), ("spin_2.speed", "rad/s"), ("way_3.speed", "m/s"),
    ("spin_3.speed", "rad/s"), ("way_4.speed", "m/s"), ("spin_4.speed", "rad/s"), ("way_5.speed", "m/s"), ("spin_5.speed", "rad/s"),
)

MEMORY = (
    ("energy_ledger.input", "J"), ("load.input", "J"), ("support_x.dissipated", "J"), ("support_y.dissipated", "J"),
    ("inner_0.dissipated", "J"), ("inner_0_friction.dissipated", "J"), ("outer_0.dissipated", "J"), ("outer_0_friction.dissipated", "J"),
    ("inner_1.dissipated", "J"), ("inner_1_friction.dissipated", "J"), ("outer_1.dissipated", "J"), ("outer_1_friction.dissipated", "J"),
    ("inner_2.dissipated", "J"), ("inner_2_friction.dissipated", "J"), ("outer_2.dissipated", "J"), ("outer_2_friction.dissipated", "J"),
    ("inner_3.dissipated", "J"), ("inner_3_friction.dissipated", "J"), ("outer_3.dissipated", "J"), ("outer_3_friction.dissipated", "J"),
    ("inner_4.dissipated", "J"), ("inner_4_friction.dissipated", "J"), ("outer_4.dissipated", "J"), ("outer_4_friction.dissipated", "J"),
    ("inner_5.dissipated", "J"), ("inner_5_friction.dissipated", "J"), ("outer_5.dissipated", "J"), ("outer_5_friction.dissipated", "J"),
)

PAIRS = (
    ("inner_0", "sphere_on_sphere"), ("outer_0", "ball_in_socket"), ("inner_1", "sphere_on_sphere"), ("outer_1", "ball_in_socket"),
    ("inner_2", "sphere_on_sphere"), ("outer_2", "ball_in_socket"), ("inner_3", "sphere_on_sphere"), ("outer_3", "ball_in_socket"),
    ("inner_4", "sphere_on_sphere"), ("outer_4", "ball_in_socket"), ("inner_5", "sphere_on_sphere"), ("outer_5", "ball_in_socket"),
)

RELEASES = ("force", "force", "force", "force", "force", "force", "force", "force", "force", "force", "force", "force")

DISSIPATED = (4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26)

GIVEN = (
    "shaft.y", "cage_turn.speed", "way_0.travel", "spin_0.speed", "way_1.travel", "spin_1.speed", "way_2.travel", "spin_2.speed",
    "way_3.travel", "spin_3.speed", "way_4.travel", "spin_4.speed", "way_5.travel", "spin_5.speed",
)

OUTPUTS = (
    ("inner_0.gap", "m"), ("outer_0.eccentricity_x", "m"), ("outer_0.eccentricity_y", "m"), ("inner_1.gap", "m"),
    ("outer_1.eccentricity_x", "m"), ("outer_1.eccentricity_y", "m"), ("inner_2.gap", "m"), ("outer_2.eccentricity_x", "m"),
    ("outer_2.eccentricity_y", "m"), ("inner_3.gap", "m"), ("outer_3.eccentricity_x", "m"), ("outer_3.eccentricity_y", "m"),
    ("inner_4.gap", "m"), ("outer_4.eccentricity_x", "m"), ("outer_4.eccentricity_y", "m"), ("inner_5.gap", "m"),
    ("outer_5.eccentricity_x", "m"), ("outer_5.eccentricity_y", "m"),
)

BODIES = (
    "ring", "cage", "pocket_0", "ball_0", "pocket_1", "ball_1", "pocket_2", "ball_2", "pocket_3", "ball_3", "pocket_4", "ball_4",
    "pocket_5", "ball_5",
)

LANDMARKS = (
    ("shaft", "planar", "parent", "ground", ("normal",)), ("shaft", "planar", "child", "ring", ("normal",)),
    ("cage_turn", "revolute", "parent", "ground", ("axis",)), ("cage_turn", "revolute", "child", "cage", ("axis",)),
    ("way_0", "prismatic", "parent", "cage", ("axis",)), ("way_0", "prismatic", "child", "pocket_0", ("axis",)),
    ("spin_0", "revolute", "parent", "pocket_0", ("axis",)), ("spin_0", "revolute", "child", "ball_0", ("axis",)),
    ("way_1", "prismatic", "parent", "cage", ("axis",)), ("way_1", "prismatic", "child", "pocket_1", ("axis",)),
    ("spin_1", "revolute", "parent", "pocket_1", ("axis",)), ("spin_1", "revolute", "child", "ball_1", ("axis",)),
    ("way_2", "prismatic", "parent", "cage", ("axis",)), ("way_2", "prismatic", "child", "pocket_2", ("axis",)),
    ("spin_2", "revolute", "parent", "pocket_2", ("axis",)), ("spin_2", "revolute", "child", "ball_2", ("axis",)),
    ("way_3", "prismatic", "parent", "cage", ("axis",)), ("way_3", "prismatic", "child", "pocket_3", ("axis",)),
    ("spin_3", "revolute", "parent", "pocket_3", ("axis",)), ("spin_3", "revolute", "child", "ball_3", ("axis",)),
    ("way_4", "prismatic", "parent", "cage", ("axis",)), ("way_4", "prismatic", "child", "pocket_4", ("axis",)),
    ("spin_4", "revolute", "parent", "pocket_4", ("axis",)), ("spin_4", "revolute", "child", "ball_4", ("axis",)),
    ("way_5", "prismatic", "parent", "cage", ("axis",)), ("way_5", "prismatic", "child", "pocket_5", ("axis",)),
    ("spin_5", "revolute", "parent", "pocket_5", ("axis",)), ("spin_5", "revolute", "child", "ball_5", ("axis",)),
    ("inner_0", "sphere_on_sphere", "first", "ball_0", ("radius",)), ("inner_0", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_0", "ball_in_socket", "ball", "ball_0", ("radius",)), ("outer_0", "ball_in_socket", "socket", "ground", ("radius",)),
    ("inner_1", "sphere_on_sphere", "first", "ball_1", ("radius",)), ("inner_1", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_1", "ball_in_socket", "ball", "ball_1", ("radius",)), ("outer_1", "ball_in_socket", "socket", "ground", ("radius",)),
    ("inner_2", "sphere_on_sphere", "first", "ball_2", ("radius",)), ("inner_2", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_2", "ball_in_socket", "ball", "ball_2", ("radius",)), ("outer_2", "ball_in_socket", "socket", "ground", ("radius",)),
    ("inner_3", "sphere_on_sphere", "first", "ball_3", ("radius",)), ("inner_3", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_3", "ball_in_socket", "ball", "ball_3", ("radius",)), ("outer_3", "ball_in_socket", "socket", "ground", ("radius",)),
    ("inner_4", "sphere_on_sphere", "first", "ball_4", ("radius",)), ("inner_4", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_4", "ball_in_socket", "ball", "ball_4", ("radius",)), ("outer_4", "ball_in_socket", "socket", "ground", ("radius",)),
    ("inner_5", "sphere_on_sphere", "first", "ball_5", ("radius",)), ("inner_5", "sphere_on_sphere", "second", "ring", ("radius",)),
    ("outer_5", "ball_in_socket", "ball", "ball_5", ("radius",)), ("outer_5", "ball_in_socket", "socket", "ground", ("radius",)),
    ("motor", "turn_drive", "child", "ring", ("axis",)), ("load", "force", "point", "ring", ()),
    ("load", "force", "axes", "ground", ("force",)), ("support_x", "slide_damper", "parent", "ground", ("axis",)),
    ("support_x", "slide_damper", "child", "ring", ()), ("support_y", "slide_damper", "parent", "ground", ("axis",)),
    ("support_y", "slide_damper", "child", "ring", ()), ("ring", "body", "centre", "ring", ()), ("cage", "body", "centre", "cage", ()),
    ("ball_0", "body", "centre", "ball_0", ()), ("ball_1", "body", "centre", "ball_1", ()), ("ball_2", "body", "centre", "ball_2", ()),
    ("ball_3", "body", "centre", "ball_3", ()), ("ball_4", "body", "centre", "ball_4", ()), ("ball_5", "body", "centre", "ball_5", ()),
)

CONSTANTS = (
    ("cage_inertia", "kg m^2"), ("ball_mass", "kg"), ("speed", "1/s"), ("load", "N"), ("support_damping", "N s/m"),
    ("stiffness", "N/m^1.5"), ("damping", "N s/m^2.5"), ("friction_coefficient", "1"), ("way_1_axes_x_y", "1"), ("way_1_axes_y_x", "1"),
    ("inner_0_reach", "m"), ("minus_inner_0_reach_squared", "m^2"), ("half_inverse_inner_0_reach", "1/m"), ("k3", "m^2"), ("k4", "1/m"),
    ("two_fifths_of_stiffness", "N/m^1.5"), ("half_ball_diameter", "m"), ("inverse_friction_speed", "s/m"),
    ("minus_half_clearance_minus_half_pitch_diameter", "m"), ("half_ball_mass", "kg"), ("way_1_axes_y_x_squared", "1"), ("k12", "kg m^2"),
    ("inverse_ring_mass", "1/kg"), ("inverse_ball_inertia", "1/(kg m^2)"), ("half_ball_inertia", "kg m^2"), ("half_cage_inertia", "kg m^2"),
    ("half_ring_mass", "kg"), ("half_speed_squared_times_ring_inertia", "J"),
)

OPERATIONS = (
    ("constants", 34), ("start", 20), ("scales", 9), ("coordinate_rates", 0), ("gaps", 267), ("gap_accelerations", 399),
    ("contact_inner_0", 100), ("contact_outer_0", 74), ("contact_inner_1", 114), ("contact_outer_1", 88), ("contact_inner_2", 116),
    ("contact_outer_2", 90), ("contact_inner_3", 104), ("contact_outer_3", 78), ("contact_inner_4", 117), ("contact_outer_4", 91),
    ("contact_inner_5", 114), ("contact_outer_5", 88), ("applied", 5), ("accelerations", 337), ("ledger", 11), ("energy", 305),
    ("poses", 138), ("outputs", 98), ("period", 3), ("landmarks", 20),
)

UNCHECKED = CONTRADICTIONS = ADVICE = INPUTS = SMOOTH_INPUTS = QUATERNIONS = LATCHES = EVENTS = LOADS = FED = RUBBING = GUIDES = SLIPS = ()
CONSTRAINTS = ROLLING = SEATED = BRISTLES = SPEED_LIMITED = FAMILIES = ()

JOINT_COORDINATES = JOINT_SPEEDS = JOINT_QUATERNIONS = JOINT_CONSTRAINTS = None


def sphere_on_sphere_gap(arm_x, arm_y, velocity_x, velocity_y, x, y, x_speed, y_speed, minus_reach_squared, half_inverse_reach):
    """Return gap [m], gap_rate [m/s]."""
    apart_x = arm_x - x
    apart_y = arm_y - y
    apart_rate_x = velocity_x - x_speed
    apart_rate_y = velocity_y - y_speed
    apart_squared = apart_x*apart_x + apart_y*apart_y
    gap = half_inverse_reach*(minus_reach_squared + apart_squared)
    apart_squared_rate = 2*apart_rate_x*apart_x + 2*apart_rate_y*apart_y
    gap_rate = half_inverse_reach*apart_squared_rate
    return gap, gap_rate


def sphere_on_sphere_gap_rate_rate(arm_x, arm_y, velocity_x, velocity_y, acceleration_x, acceleration_y, x, y, x_speed, y_speed,
        x_acceleration, y_acceleration, half_inverse_reach):
    """Return gap_rate_rate [m/s^2]."""
    apart_x = arm_x - x
    apart_y = arm_y - y
    apart_rate_x = velocity_x - x_speed
    apart_rate_y = velocity_y - y_speed
    apart_acceleration_x = acceleration_x - x_acceleration
    apart_acceleration_y = acceleration_y - y_acceleration
    apart_squared_rate_rate = 2*apart_rate_x*apart_rate_x + 2*apart_rate_y*apart_rate_y + 2*apart_acceleration_x*apart_x + 2*apart_acceleration_y*apart_y
    return half_inverse_reach*apart_squared_rate_rate


def sphere_on_sphere_contact(first_arm_x, second_arm_x, arm_y, axis_x, axis_y, apart_x, apart_y, distance, normal_x, x3, x, y, x_speed,
        y_speed, first_speed, second_speed, third_speed, fourth_speed, stiffness, damping, friction_coefficient, reach, half_ball_diameter,
        inverse_friction_speed):
    """Return normal_force [N], normal_power [W], push_x [N], push_y [N], first_push_on [N m], second_push_on [N], push_on_angle [N m],
    sliding_velocity [m/s], power [W], drag_x [N], drag_y [N], first_drag_on [N m], second_drag_on [N], third_drag_on [N m], drag_on_angle
    [N m]."""
    arm_rate_x = -first_speed*arm_y
    arm_rate_y = first_speed*first_arm_x
    velocity_x = arm_rate_x + second_speed*axis_x
    velocity_y = arm_rate_y + second_speed*axis_y
    rate_z = first_speed + third_speed
    penetration = reach - distance
    x1 = penetration*ca.sqrt(penetration)
    elastic_force = ca.if_else(penetration > 0, stiffness*x1, 0)
    normal_y = apart_y/distance
    relative_rate_x = velocity_x + fourth_speed*apart_y - x_speed
    relative_rate_y = velocity_y - y_speed - fourth_speed*apart_x
    penetration_rate = -normal_x*relative_rate_x - relative_rate_y*normal_y
    resistance = ca.if_else(penetration > 0, x1*penetration_rate*damping, 0)
    normal_force = resistance + elastic_force
    normal_power = penetration_rate*resistance
    push_x = normal_force*normal_x
    push_y = normal_force*normal_y
    first_push_on = push_y*first_arm_x - push_x*arm_y
    second_push_on = push_x*axis_x + push_y*axis_y
    push_on_angle = -apart_x*push_y - push_x*(y - arm_y)
    sliding_velocity = relative_rate_y*normal_x - relative_rate_x*normal_y - half_ball_diameter*(rate_z - fourth_speed)
    force = friction_coefficient*normal_force*ca.tanh(inverse_friction_speed*sliding_velocity)
    power = sliding_velocity*force
    drag_x = force*normal_y
    drag_y = -force*normal_x
    x2 = half_ball_diameter*normal_y
    first_drag_on = drag_x*(x2 - arm_y) + drag_y*(second_arm_x + x3)
    second_drag_on = drag_x*axis_x + axis_y*drag_y
    third_drag_on = drag_x*normal_y*half_ball_diameter - normal_x*drag_y*half_ball_diameter
    drag_on_angle = -drag_x*(y + x2 - arm_y) - drag_y*(second_arm_x + x3 - x)
    return normal_force, normal_power, push_x, push_y, first_push_on, second_push_on, push_on_angle, sliding_velocity, power, drag_x, drag_y, first_drag_on, second_drag_on, third_drag_on, drag_on_angle


def sphere_on_sphere_stored_energy(arm_x, arm_y, x, y, reach, two_fifths_of_stiffness):
    """Return stored_energy [N m]."""
    apart_x = arm_x - x
    apart_y = arm_y - y
    apart_squared = apart_x*apart_x + apart_y*apart_y
    distance = ca.sqrt(apart_squared)
    penetration = reach - distance
    return ca.if_else(penetration > 0, two_fifths_of_stiffness*penetration*penetration*ca.sqrt(penetration), 0)


def ball_in_socket_stored_energy(arm_x, arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter):
    """Return stored_energy [N m]."""
    apart_squared = arm_x*arm_x + arm_y*arm_y
    distance = ca.sqrt(apart_squared)
    penetration = minus_half_clearance_minus_half_pitch_diameter + distance
    return ca.if_else(penetration > 0, two_fifths_of_stiffness*penetration*penetration*ca.sqrt(penetration), 0)


def ball_in_socket_contact(arm_x, arm_y, axis_x, axis_y, first_speed, second_speed, third_speed, stiffness, damping, friction_coefficient,
        half_ball_diameter, inverse_friction_speed, minus_half_clearance_minus_half_pitch_diameter):
    """Return normal_force [N], normal_power [W], first_push_on [N m], second_push_on [N], sliding_velocity [m/s], power [W], first_drag_on
    [N m], second_drag_on [N], third_drag_on [N m]."""
    arm_rate_x = -first_speed*arm_y
    arm_rate_y = first_speed*arm_x
    velocity_x = arm_rate_x + second_speed*axis_x
    velocity_y = arm_rate_y + second_speed*axis_y
    rate_z = first_speed + third_speed
    apart_squared = arm_x*arm_x + arm_y*arm_y
    distance = ca.sqrt(apart_squared)
    penetration = minus_half_clearance_minus_half_pitch_diameter + distance
    x1 = penetration*ca.sqrt(penetration)
    elastic_force = ca.if_else(penetration > 0, stiffness*x1, 0)
    normal_x = -arm_x/distance
    normal_y = -arm_y/distance
    penetration_rate = -normal_x*velocity_x - velocity_y*normal_y
    resistance = ca.if_else(penetration > 0, x1*penetration_rate*damping, 0)
    normal_force = resistance + elastic_force
    normal_power = penetration_rate*resistance
    push_x = normal_force*normal_x
    push_y = normal_force*normal_y
    first_push_on = push_y*arm_x - push_x*arm_y
    second_push_on = push_x*axis_x + push_y*axis_y
    sliding_velocity = velocity_y*normal_x - half_ball_diameter*rate_z - velocity_x*normal_y
    force = friction_coefficient*normal_force*ca.tanh(inverse_friction_speed*sliding_velocity)
    power = sliding_velocity*force
    drag_x = force*normal_y
    drag_y = -force*normal_x
    first_drag_on = drag_x*(half_ball_diameter*normal_y - arm_y) + drag_y*(arm_x - half_ball_diameter*normal_x)
    second_drag_on = drag_x*axis_x + axis_y*drag_y
    third_drag_on = half_ball_diameter*drag_x*normal_y - half_ball_diameter*drag_y*normal_x
    return normal_force, normal_power, first_push_on, second_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on


def sphere_on_sphere_penetration(arm_x, arm_y, x, y, reach):
    """Return penetration [m]."""
    apart_x = arm_x - x
    apart_y = arm_y - y
    apart_squared = apart_x*apart_x + apart_y*apart_y
    distance = ca.sqrt(apart_squared)
    return reach - distance


def ball_in_socket_gap(arm_x, arm_y, velocity_x, velocity_y, k3, k4):
    """Return gap [m], gap_rate [m/s]."""
    apart_squared = arm_x*arm_x + arm_y*arm_y
    gap = k4*(k3 - apart_squared)
    apart_squared_rate = 2*arm_x*velocity_x + 2*arm_y*velocity_y
    gap_rate = -k4*apart_squared_rate
    return gap, gap_rate


def sphere_on_sphere_contact_2(normal_x, normal_y, normal_force, sliding_velocity, friction_coefficient, inverse_friction_speed):
    """Return push_x [N], push_y [N], power [W], drag_x [N], drag_y [N]."""
    push_x = normal_force*normal_x
    push_y = normal_force*normal_y
    force = friction_coefficient*normal_force*ca.tanh(inverse_friction_speed*sliding_velocity)
    power = sliding_velocity*force
    drag_x = force*normal_y
    drag_y = -force*normal_x
    return push_x, push_y, power, drag_x, drag_y


def sphere_on_sphere_contact_3(rate_z, penetration, x1, elastic_force, normal_x, normal_y, relative_rate_x, relative_rate_y, speed, damping,
        half_ball_diameter):
    """Return normal_force [N], normal_power [W], sliding_velocity [m/s]."""
    penetration_rate = -normal_x*relative_rate_x - relative_rate_y*normal_y
    resistance = ca.if_else(penetration > 0, x1*penetration_rate*damping, 0)
    normal_force = resistance + elastic_force
    normal_power = penetration_rate*resistance
    sliding_velocity = relative_rate_y*normal_x - relative_rate_x*normal_y - half_ball_diameter*(rate_z - speed)
    return normal_force, normal_power, sliding_velocity


def ball_in_socket_contact_2(velocity_x, velocity_y, rate_z, penetration, x1, elastic_force, normal_x, normal_y, damping,
        half_ball_diameter):
    """Return normal_force [N], normal_power [W], sliding_velocity [m/s]."""
    penetration_rate = -normal_x*velocity_x - velocity_y*normal_y
    resistance = ca.if_else(penetration > 0, x1*penetration_rate*damping, 0)
    normal_force = resistance + elastic_force
    normal_power = penetration_rate*resistance
    sliding_velocity = velocity_y*normal_x - half_ball_diameter*rate_z - velocity_x*normal_y
    return normal_force, normal_power, sliding_velocity


def constants(p):
    """Quantities that depend on the parameters alone, once per run.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        c (28,): cage_inertia, ball_mass, speed, load, support_damping, stiffness, damping, friction_coefficient, way_1_axes_x_y,
            way_1_axes_y_x, inner_0_reach, minus_inner_0_reach_squared, half_inverse_inner_0_reach, k3, k4, two_fifths_of_stiffness,
            half_ball_diameter, inverse_friction_speed, minus_half_clearance_minus_half_pitch_diameter, half_ball_mass,
            way_1_axes_y_x_squared, k12, inverse_ring_mass, inverse_ball_inertia, half_ball_inertia, half_cage_inertia, half_ring_mass,
            half_speed_squared_times_ring_inertia
    """
    ring_mass, ring_inertia, cage_inertia, ball_mass, ball_inertia, ball_diameter, pitch_diameter = p[0], p[1], p[3], p[4], p[5], p[6], p[7]
    clearance, speed, load, support_damping, stiffness, damping, friction_coefficient = p[8], p[9], p[10], p[11], p[12], p[13], p[14]
    friction_speed = p[15]
    sqrt_3 = ca.sqrt(3)
    way_1_axes_x_y = -sqrt_3/2
    way_1_axes_y_x = sqrt_3/2
    half_pitch_diameter = pitch_diameter/2
    minus_half_clearance = -clearance/2
    inner_0_reach = half_pitch_diameter + minus_half_clearance
    minus_inner_0_reach_squared = -inner_0_reach*inner_0_reach
    half_inverse_inner_0_reach = 1/(2*inner_0_reach)
    k3 = (half_pitch_diameter + clearance/2)**2
    k4 = 1/(clearance + pitch_diameter)
    two_fifths_of_stiffness = 2*stiffness/5
    half_ball_diameter = ball_diameter/2
    inverse_friction_speed = 1/friction_speed
    minus_half_clearance_minus_half_pitch_diameter = minus_half_clearance - pitch_diameter/2
    half_ball_mass = ball_mass/2
    way_1_axes_y_x_squared = way_1_axes_y_x*way_1_axes_y_x
    k12 = 6*ball_inertia
    inverse_ring_mass = 1/ring_mass
    inverse_ball_inertia = 1/ball_inertia
    half_ball_inertia = ball_inertia/2
    half_cage_inertia = cage_inertia/2
    half_ring_mass = ring_mass/2
    half_speed_squared_times_ring_inertia = speed*speed*ring_inertia/2
    return ca.vertcat(cage_inertia, ball_mass, speed, load, support_damping, stiffness, damping, friction_coefficient, way_1_axes_x_y,
        way_1_axes_y_x, inner_0_reach, minus_inner_0_reach_squared, half_inverse_inner_0_reach, k3, k4, two_fifths_of_stiffness,
        half_ball_diameter, inverse_friction_speed, minus_half_clearance_minus_half_pitch_diameter, half_ball_mass, way_1_axes_y_x_squared,
        k12, inverse_ring_mass, inverse_ball_inertia, half_ball_inertia, half_cage_inertia, half_ring_mass,
        half_speed_squared_times_ring_inertia)


def start(p):
    """Coordinates and speeds at t = 0.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        q (15,): COORDINATES
        u (15,): SPEEDS
    """
    ball_diameter, pitch_diameter, clearance, speed = p[6], p[7], p[8], p[9]
    half_pitch_diameter = pitch_diameter/2
    quarter_of_clearance = clearance/4
    x3 = half_pitch_diameter + quarter_of_clearance
    ball_diameter_squared = ball_diameter*ball_diameter
    inverse_pitch_diameter_squared = 1/(pitch_diameter*pitch_diameter)
    x6 = -ball_diameter_squared*inverse_pitch_diameter_squared
    x7 = 1 + x6
    x8 = -x7*pitch_diameter*speed/(2*ball_diameter)
    return ca.vertcat(0, -clearance/2, *[0, x3]*6, 0), ca.vertcat(0, 0, (1 - ball_diameter/pitch_diameter)*speed/2, *[0, x8]*6)


def scales(p):
    """Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        sq (15,): COORDINATES
        su (15,): SPEEDS
        sz (28,): MEMORY
        s (4,): length [m], speed [m/s], force [N], energy [J]
    """
    ring_mass, cage_mass, ball_mass, pitch_diameter, clearance, pace = p[0], p[2], p[4], p[7], p[8], p[16]
    total_mass = 6*ball_mass + cage_mass + ring_mass
    energy_scale = total_mass*pace*pace/2
    force_scale = energy_scale/clearance
    clearance_over_pitch_diameter = clearance/pitch_diameter
    pace_over_pitch_diameter = pace/pitch_diameter
    return (ca.vertcat(clearance, *[clearance, clearance_over_pitch_diameter]*7), ca.vertcat(pace, *[pace, pace_over_pitch_diameter]*7),
        ca.vertcat(*[energy_scale]*28), ca.vertcat(clearance, pace, force_scale, energy_scale))


def coordinate_rates(t, q, u, c):
    """Rates of the coordinates.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        dq (15,): shaft.x [m/s], shaft.y [m/s], cage_turn.angle [rad/s], way_0.travel [m/s], spin_0.angle [rad/s], way_1.travel [m/s],
            spin_1.angle [rad/s], way_2.travel [m/s], spin_2.angle [rad/s], way_3.travel [m/s], spin_3.angle [rad/s], way_4.travel [m/s],
            spin_4.angle [rad/s], way_5.travel [m/s], spin_5.angle [rad/s]
    """
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, spin_0_speed, way_1_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    spin_1_speed, way_2_speed, spin_2_speed, way_3_speed, spin_3_speed, way_4_speed = u[6], u[7], u[8], u[9], u[10], u[11]
    spin_4_speed, way_5_speed, spin_5_speed = u[12], u[13], u[14]
    return ca.vertcat(shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, spin_0_speed, way_1_speed, spin_1_speed, way_2_speed,
        spin_2_speed, way_3_speed, spin_3_speed, way_4_speed, spin_4_speed, way_5_speed, spin_5_speed)


def gaps(t, q, u, c):
    """Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        G (12,): PAIRS [m]
        dG (12,): PAIRS [m/s]
    """
    way_1_axes_y_x, minus_inner_0_reach_squared, half_inverse_inner_0_reach, k3, k4 = c[9], c[11], c[12], c[13], c[14]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel, way_1_travel, way_2_travel, way_3_travel = q[0], q[1], q[2], q[3], q[5], q[7], q[9]
    way_4_travel, way_5_travel = q[11], q[13]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, way_1_speed, way_2_speed = u[0], u[1], u[2], u[3], u[5], u[7]
    way_3_speed, way_4_speed, way_5_speed = u[9], u[11], u[13]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_0_arm_rate_x = -cage_turn_speed*pocket_0_arm_y
    pocket_0_arm_rate_y = cage_turn_speed*pocket_0_arm_x
    pocket_0_velocity_x = pocket_0_arm_rate_x + cos_cage*way_0_speed
    pocket_0_velocity_y = pocket_0_arm_rate_y + sin_cage*way_0_speed
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_rate_x = -cage_turn_speed*pocket_1_arm_y
    pocket_1_arm_rate_y = cage_turn_speed*pocket_1_arm_x
    half_cos_cage = cos_cage/2
    minus_sin_cage_times_way_1_axes_y_x = -sin_cage*way_1_axes_y_x
    way_1_axis_x = half_cos_cage + minus_sin_cage_times_way_1_axes_y_x
    cos_cage_times_way_1_axes_y_x = cos_cage*way_1_axes_y_x
    way_1_axis_y = cos_cage_times_way_1_axes_y_x + sin_cage/2
    pocket_1_velocity_x = pocket_1_arm_rate_x + way_1_axis_x*way_1_speed
    pocket_1_velocity_y = pocket_1_arm_rate_y + way_1_axis_y*way_1_speed
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    pocket_2_arm_rate_x = -cage_turn_speed*pocket_2_arm_y
    pocket_2_arm_rate_y = cage_turn_speed*pocket_2_arm_x
    way_2_axis_x = minus_sin_cage_times_way_1_axes_y_x - cos_cage/2
    way_2_axis_y = cos_cage_times_way_1_axes_y_x - sin_cage/2
    pocket_2_velocity_x = pocket_2_arm_rate_x + way_2_axis_x*way_2_speed
    pocket_2_velocity_y = pocket_2_arm_rate_y + way_2_axis_y*way_2_speed
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_3_arm_rate_x = -cage_turn_speed*pocket_3_arm_y
    pocket_3_arm_rate_y = cage_turn_speed*pocket_3_arm_x
    pocket_3_velocity_x = pocket_3_arm_rate_x - cos_cage*way_3_speed
    pocket_3_velocity_y = pocket_3_arm_rate_y - sin_cage*way_3_speed
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_4_arm_rate_x = -cage_turn_speed*pocket_4_arm_y
    pocket_4_arm_rate_y = cage_turn_speed*pocket_4_arm_x
    pocket_4_velocity_x = pocket_4_arm_rate_x - way_1_axis_x*way_4_speed
    pocket_4_velocity_y = pocket_4_arm_rate_y - way_1_axis_y*way_4_speed
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_rate_x = -cage_turn_speed*pocket_5_arm_y
    pocket_5_arm_rate_y = cage_turn_speed*pocket_5_arm_x
    way_5_axis_x = half_cos_cage + sin_cage*way_1_axes_y_x
    pocket_5_velocity_x = pocket_5_arm_rate_x + way_5_axis_x*way_5_speed
    pocket_5_velocity_y = pocket_5_arm_rate_y - way_2_axis_y*way_5_speed
    inner_0_gap, inner_0_gap_rate = sphere_on_sphere_gap(pocket_0_arm_x, pocket_0_arm_y, pocket_0_velocity_x, pocket_0_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_0_gap, outer_0_gap_rate = ball_in_socket_gap(pocket_0_arm_x, pocket_0_arm_y, pocket_0_velocity_x, pocket_0_velocity_y, k3, k4)
    inner_1_gap, inner_1_gap_rate = sphere_on_sphere_gap(pocket_1_arm_x, pocket_1_arm_y, pocket_1_velocity_x, pocket_1_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_1_gap, outer_1_gap_rate = ball_in_socket_gap(pocket_1_arm_x, pocket_1_arm_y, pocket_1_velocity_x, pocket_1_velocity_y, k3, k4)
    inner_2_gap, inner_2_gap_rate = sphere_on_sphere_gap(pocket_2_arm_x, pocket_2_arm_y, pocket_2_velocity_x, pocket_2_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_2_gap, outer_2_gap_rate = ball_in_socket_gap(pocket_2_arm_x, pocket_2_arm_y, pocket_2_velocity_x, pocket_2_velocity_y, k3, k4)
    inner_3_gap, inner_3_gap_rate = sphere_on_sphere_gap(pocket_3_arm_x, pocket_3_arm_y, pocket_3_velocity_x, pocket_3_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_3_gap, outer_3_gap_rate = ball_in_socket_gap(pocket_3_arm_x, pocket_3_arm_y, pocket_3_velocity_x, pocket_3_velocity_y, k3, k4)
    inner_4_gap, inner_4_gap_rate = sphere_on_sphere_gap(pocket_4_arm_x, pocket_4_arm_y, pocket_4_velocity_x, pocket_4_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_4_gap, outer_4_gap_rate = ball_in_socket_gap(pocket_4_arm_x, pocket_4_arm_y, pocket_4_velocity_x, pocket_4_velocity_y, k3, k4)
    inner_5_gap, inner_5_gap_rate = sphere_on_sphere_gap(pocket_5_arm_x, pocket_5_arm_y, pocket_5_velocity_x, pocket_5_velocity_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, minus_inner_0_reach_squared, half_inverse_inner_0_reach)
    outer_5_gap, outer_5_gap_rate = ball_in_socket_gap(pocket_5_arm_x, pocket_5_arm_y, pocket_5_velocity_x, pocket_5_velocity_y, k3, k4)
    return (ca.vertcat(inner_0_gap, outer_0_gap, inner_1_gap, outer_1_gap, inner_2_gap, outer_2_gap, inner_3_gap, outer_3_gap, inner_4_gap,
            outer_4_gap, inner_5_gap, outer_5_gap),
        ca.vertcat(inner_0_gap_rate, outer_0_gap_rate, inner_1_gap_rate, outer_1_gap_rate, inner_2_gap_rate, outer_2_gap_rate,
            inner_3_gap_rate, outer_3_gap_rate, inner_4_gap_rate, outer_4_gap_rate, inner_5_gap_rate, outer_5_gap_rate))


def gap_accelerations(t, q, u, a, c):
    """Second derivative of every gap.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; a: rates of the speeds; c: CONSTANTS.
    Returns, each a column vector:
        ddG (12,): PAIRS [m/s^2]
    """
    way_1_axes_y_x, half_inverse_inner_0_reach, k4 = c[9], c[12], c[14]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel, way_1_travel, way_2_travel, way_3_travel = q[0], q[1], q[2], q[3], q[5], q[7], q[9]
    way_4_travel, way_5_travel = q[11], q[13]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, way_1_speed, way_2_speed = u[0], u[1], u[2], u[3], u[5], u[7]
    way_3_speed, way_4_speed, way_5_speed = u[9], u[11], u[13]
    shaft_x_acceleration, shaft_y_acceleration, cage_turn_acceleration, way_0_acceleration = a[0], a[1], a[2], a[3]
    way_1_acceleration, way_2_acceleration, way_3_acceleration, way_4_acceleration, way_5_acceleration = a[5], a[7], a[9], a[11], a[13]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_0_arm_rate_x = -cage_turn_speed*pocket_0_arm_y
    pocket_0_arm_rate_y = cage_turn_speed*pocket_0_arm_x
    pocket_0_velocity_x = pocket_0_arm_rate_x + cos_cage*way_0_speed
    pocket_0_velocity_y = pocket_0_arm_rate_y + sin_cage*way_0_speed
    pocket_0_acceleration_x = cos_cage*way_0_acceleration - cage_turn_acceleration*pocket_0_arm_y - cage_turn_speed*pocket_0_arm_rate_y - 2*cage_turn_speed*sin_cage*way_0_speed
    pocket_0_acceleration_y = cage_turn_acceleration*pocket_0_arm_x + cage_turn_speed*pocket_0_arm_rate_x + sin_cage*way_0_acceleration + 2*cage_turn_speed*cos_cage*way_0_speed
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_rate_x = -cage_turn_speed*pocket_1_arm_y
    pocket_1_arm_rate_y = cage_turn_speed*pocket_1_arm_x
    half_cos_cage = cos_cage/2
    minus_sin_cage_times_way_1_axes_y_x = -sin_cage*way_1_axes_y_x
    way_1_axis_x = half_cos_cage + minus_sin_cage_times_way_1_axes_y_x
    cos_cage_times_way_1_axes_y_x = cos_cage*way_1_axes_y_x
    way_1_axis_y = cos_cage_times_way_1_axes_y_x + sin_cage/2
    pocket_1_velocity_x = pocket_1_arm_rate_x + way_1_axis_x*way_1_speed
    pocket_1_velocity_y = pocket_1_arm_rate_y + way_1_axis_y*way_1_speed
    pocket_1_acceleration_x = way_1_acceleration*way_1_axis_x - cage_turn_acceleration*pocket_1_arm_y - cage_turn_speed*pocket_1_arm_rate_y - 2*cage_turn_speed*way_1_axis_y*way_1_speed
    pocket_1_acceleration_y = cage_turn_acceleration*pocket_1_arm_x + cage_turn_speed*pocket_1_arm_rate_x + way_1_acceleration*way_1_axis_y + 2*cage_turn_speed*way_1_axis_x*way_1_speed
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    pocket_2_arm_rate_x = -cage_turn_speed*pocket_2_arm_y
    pocket_2_arm_rate_y = cage_turn_speed*pocket_2_arm_x
    way_2_axis_x = minus_sin_cage_times_way_1_axes_y_x - cos_cage/2
    way_2_axis_y = cos_cage_times_way_1_axes_y_x - sin_cage/2
    pocket_2_velocity_x = pocket_2_arm_rate_x + way_2_axis_x*way_2_speed
    pocket_2_velocity_y = pocket_2_arm_rate_y + way_2_axis_y*way_2_speed
    pocket_2_acceleration_x = way_2_acceleration*way_2_axis_x - cage_turn_acceleration*pocket_2_arm_y - cage_turn_speed*pocket_2_arm_rate_y - 2*cage_turn_speed*way_2_axis_y*way_2_speed
    pocket_2_acceleration_y = cage_turn_acceleration*pocket_2_arm_x + cage_turn_speed*pocket_2_arm_rate_x + way_2_acceleration*way_2_axis_y + 2*cage_turn_speed*way_2_axis_x*way_2_speed
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_3_arm_rate_x = -cage_turn_speed*pocket_3_arm_y
    pocket_3_arm_rate_y = cage_turn_speed*pocket_3_arm_x
    pocket_3_velocity_x = pocket_3_arm_rate_x - cos_cage*way_3_speed
    pocket_3_velocity_y = pocket_3_arm_rate_y - sin_cage*way_3_speed
    pocket_3_acceleration_x = 2*cage_turn_speed*sin_cage*way_3_speed - cage_turn_acceleration*pocket_3_arm_y - cage_turn_speed*pocket_3_arm_rate_y - cos_cage*way_3_acceleration
    pocket_3_acceleration_y = cage_turn_acceleration*pocket_3_arm_x + cage_turn_speed*pocket_3_arm_rate_x - sin_cage*way_3_acceleration - 2*cage_turn_speed*cos_cage*way_3_speed
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_4_arm_rate_x = -cage_turn_speed*pocket_4_arm_y
    pocket_4_arm_rate_y = cage_turn_speed*pocket_4_arm_x
    pocket_4_velocity_x = pocket_4_arm_rate_x - way_1_axis_x*way_4_speed
    pocket_4_velocity_y = pocket_4_arm_rate_y - way_1_axis_y*way_4_speed
    pocket_4_acceleration_x = 2*cage_turn_speed*way_1_axis_y*way_4_speed - cage_turn_acceleration*pocket_4_arm_y - cage_turn_speed*pocket_4_arm_rate_y - way_1_axis_x*way_4_acceleration
    pocket_4_acceleration_y = cage_turn_acceleration*pocket_4_arm_x + cage_turn_speed*pocket_4_arm_rate_x - way_1_axis_y*way_4_acceleration - 2*cage_turn_speed*way_1_axis_x*way_4_speed
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_rate_x = -cage_turn_speed*pocket_5_arm_y
    pocket_5_arm_rate_y = cage_turn_speed*pocket_5_arm_x
    way_5_axis_x = half_cos_cage + sin_cage*way_1_axes_y_x
    pocket_5_velocity_x = pocket_5_arm_rate_x + way_5_axis_x*way_5_speed
    pocket_5_velocity_y = pocket_5_arm_rate_y - way_2_axis_y*way_5_speed
    pocket_5_acceleration_x = way_5_acceleration*way_5_axis_x + 2*cage_turn_speed*way_2_axis_y*way_5_speed - cage_turn_acceleration*pocket_5_arm_y - cage_turn_speed*pocket_5_arm_rate_y
    pocket_5_acceleration_y = cage_turn_acceleration*pocket_5_arm_x + cage_turn_speed*pocket_5_arm_rate_x + 2*cage_turn_speed*way_5_axis_x*way_5_speed - way_2_axis_y*way_5_acceleration
    inner_0_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_0_arm_x, pocket_0_arm_y, pocket_0_velocity_x, pocket_0_velocity_y, pocket_0_acceleration_x, pocket_0_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_0_apart_squared_rate_rate = 2*pocket_0_velocity_x*pocket_0_velocity_x + 2*pocket_0_velocity_y*pocket_0_velocity_y + 2*pocket_0_acceleration_x*pocket_0_arm_x + 2*pocket_0_acceleration_y*pocket_0_arm_y
    outer_0_gap_rate_rate = -k4*outer_0_apart_squared_rate_rate
    inner_1_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_1_arm_x, pocket_1_arm_y, pocket_1_velocity_x, pocket_1_velocity_y, pocket_1_acceleration_x, pocket_1_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_1_apart_squared_rate_rate = 2*pocket_1_velocity_x*pocket_1_velocity_x + 2*pocket_1_velocity_y*pocket_1_velocity_y + 2*pocket_1_acceleration_x*pocket_1_arm_x + 2*pocket_1_acceleration_y*pocket_1_arm_y
    outer_1_gap_rate_rate = -k4*outer_1_apart_squared_rate_rate
    inner_2_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_2_arm_x, pocket_2_arm_y, pocket_2_velocity_x, pocket_2_velocity_y, pocket_2_acceleration_x, pocket_2_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_2_apart_squared_rate_rate = 2*pocket_2_velocity_x*pocket_2_velocity_x + 2*pocket_2_velocity_y*pocket_2_velocity_y + 2*pocket_2_acceleration_x*pocket_2_arm_x + 2*pocket_2_acceleration_y*pocket_2_arm_y
    outer_2_gap_rate_rate = -k4*outer_2_apart_squared_rate_rate
    inner_3_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_3_arm_x, pocket_3_arm_y, pocket_3_velocity_x, pocket_3_velocity_y, pocket_3_acceleration_x, pocket_3_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_3_apart_squared_rate_rate = 2*pocket_3_velocity_x*pocket_3_velocity_x + 2*pocket_3_velocity_y*pocket_3_velocity_y + 2*pocket_3_acceleration_x*pocket_3_arm_x + 2*pocket_3_acceleration_y*pocket_3_arm_y
    outer_3_gap_rate_rate = -k4*outer_3_apart_squared_rate_rate
    inner_4_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_4_arm_x, pocket_4_arm_y, pocket_4_velocity_x, pocket_4_velocity_y, pocket_4_acceleration_x, pocket_4_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_4_apart_squared_rate_rate = 2*pocket_4_velocity_x*pocket_4_velocity_x + 2*pocket_4_velocity_y*pocket_4_velocity_y + 2*pocket_4_acceleration_x*pocket_4_arm_x + 2*pocket_4_acceleration_y*pocket_4_arm_y
    outer_4_gap_rate_rate = -k4*outer_4_apart_squared_rate_rate
    inner_5_gap_rate_rate = sphere_on_sphere_gap_rate_rate(pocket_5_arm_x, pocket_5_arm_y, pocket_5_velocity_x, pocket_5_velocity_y, pocket_5_acceleration_x, pocket_5_acceleration_y, shaft_x, shaft_y, shaft_x_speed, shaft_y_speed, shaft_x_acceleration, shaft_y_acceleration, half_inverse_inner_0_reach)
    outer_5_apart_squared_rate_rate = 2*pocket_5_velocity_x*pocket_5_velocity_x + 2*pocket_5_velocity_y*pocket_5_velocity_y + 2*pocket_5_acceleration_x*pocket_5_arm_x + 2*pocket_5_acceleration_y*pocket_5_arm_y
    outer_5_gap_rate_rate = -k4*outer_5_apart_squared_rate_rate
    return ca.vertcat(inner_0_gap_rate_rate, outer_0_gap_rate_rate, inner_1_gap_rate_rate, outer_1_gap_rate_rate, inner_2_gap_rate_rate,
        outer_2_gap_rate_rate, inner_3_gap_rate_rate, outer_3_gap_rate_rate, inner_4_gap_rate_rate, outer_4_gap_rate_rate,
        inner_5_gap_rate_rate, outer_5_gap_rate_rate)


def contact_inner_0(t, q, u, z, m, c):
    """Forces of inner_0: power x power_damping, smooth_coulomb. The normal force is the laws' own, not clamped: where it would pull, the
    contact ends.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; z: MEMORY; m: LATCHES; c: CONSTANTS.
    Returns, each a column vector:
        f (16,): shaft.x [N], shaft.y [N], cage_turn [N m], way_0 [N], spin_0 [N m], way_1 [N], spin_1 [N m], way_2 [N], spin_2 [N m], way_3
            [N], spin_3 [N m], way_4 [N], spin_4 [N m], way_5 [N], spin_5 [N m], shaft.angle [N m]
        dz (28,): MEMORY [W]
        normal_force (1,): inner_0 [N]
        sliding_velocity (1,): inner_0 [m/s]
        in_range (1,): inner_0 [1]
    """
    speed, stiffness, inner_0_reach, half_ball_diameter = c[2], c[5], c[10], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel = q[0], q[1], q[2], q[3]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, spin_0_speed = u[0], u[1], u[2], u[3], u[4]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_0_arm_rate_x = -cage_turn_speed*pocket_0_arm_y
    pocket_0_arm_rate_y = cage_turn_speed*pocket_0_arm_x
    pocket_0_velocity_x = pocket_0_arm_rate_x + cos_cage*way_0_speed
    pocket_0_velocity_y = pocket_0_arm_rate_y + sin_cage*way_0_speed
    ball_0_rate_z = cage_turn_speed + spin_0_speed
    inner_0_apart_x = pocket_0_arm_x - shaft_x
    inner_0_apart_y = pocket_0_arm_y - shaft_y
    inner_0_apart_squared = inner_0_apart_x*inner_0_apart_x + inner_0_apart_y*inner_0_apart_y
    inner_0_distance = ca.sqrt(inner_0_apart_squared)
    inner_0_penetration = inner_0_reach - inner_0_distance
    x1 = inner_0_penetration*ca.sqrt(inner_0_penetration)
    inner_0_elastic_force = ca.if_else(inner_0_penetration > 0, x1*stiffness, 0)
    inner_0_normal_x = inner_0_apart_x/inner_0_distance
    inner_0_normal_y = inner_0_apart_y/inner_0_distance
    inner_0_relative_rate_x = pocket_0_velocity_x + inner_0_apart_y*speed - shaft_x_speed
    inner_0_relative_rate_y = pocket_0_velocity_y - shaft_y_speed - inner_0_apart_x*speed
    normal_force, normal_power, sliding_velocity = sphere_on_sphere_contact_3(ball_0_rate_z, inner_0_penetration, x1, inner_0_elastic_force, inner_0_normal_x, inner_0_normal_y, inner_0_relative_rate_x, inner_0_relative_rate_y, speed, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(inner_0_normal_x, inner_0_normal_y, normal_force, sliding_velocity, c[7], c[17])
    inner_0_push_on_cage_turn = push_y*pocket_0_arm_x - push_x*pocket_0_arm_y
    inner_0_push_on_way_0 = cos_cage*push_x + push_y*sin_cage
    inner_0_push_on_shaft_angle = -inner_0_apart_x*push_y - push_x*(shaft_y - pocket_0_arm_y)
    x2 = inner_0_normal_y*half_ball_diameter
    x3 = -inner_0_normal_x*half_ball_diameter
    inner_0_drag_on_cage_turn = drag_x*(x2 - pocket_0_arm_y) + drag_y*(pocket_0_arm_x + x3)
    inner_0_drag_on_way_0 = cos_cage*drag_x + drag_y*sin_cage
    inner_0_drag_on_spin_0 = drag_x*inner_0_normal_y*half_ball_diameter - drag_y*inner_0_normal_x*half_ball_diameter
    inner_0_drag_on_shaft_angle = -drag_x*(shaft_y + x2 - pocket_0_arm_y) - drag_y*(pocket_0_arm_x + x3 - shaft_x)
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, inner_0_drag_on_cage_turn + inner_0_push_on_cage_turn, inner_0_drag_on_way_0 +
            inner_0_push_on_way_0, inner_0_drag_on_spin_0, *[0]*10, inner_0_drag_on_shaft_angle + inner_0_push_on_shaft_angle),
        ca.vertcat(0, 0, 0, 0, normal_power, power, *[0]*22), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_0(t, q, u, z, m, c):
    """Forces of outer_0: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    stiffness, half_ball_diameter, minus_half_clearance_minus_half_pitch_diameter = c[5], c[16], c[18]
    cage_turn_angle, way_0_travel = q[2], q[3]
    cage_turn_speed, way_0_speed, spin_0_speed = u[2], u[3], u[4]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_0_arm_rate_x = -cage_turn_speed*pocket_0_arm_y
    pocket_0_arm_rate_y = cage_turn_speed*pocket_0_arm_x
    pocket_0_velocity_x = pocket_0_arm_rate_x + cos_cage*way_0_speed
    pocket_0_velocity_y = pocket_0_arm_rate_y + sin_cage*way_0_speed
    ball_0_rate_z = cage_turn_speed + spin_0_speed
    outer_0_apart_squared = pocket_0_arm_x*pocket_0_arm_x + pocket_0_arm_y*pocket_0_arm_y
    outer_0_distance = ca.sqrt(outer_0_apart_squared)
    outer_0_penetration = minus_half_clearance_minus_half_pitch_diameter + outer_0_distance
    x1 = outer_0_penetration*ca.sqrt(outer_0_penetration)
    outer_0_elastic_force = ca.if_else(outer_0_penetration > 0, x1*stiffness, 0)
    outer_0_normal_x = -pocket_0_arm_x/outer_0_distance
    outer_0_normal_y = -pocket_0_arm_y/outer_0_distance
    normal_force, normal_power, sliding_velocity = ball_in_socket_contact_2(pocket_0_velocity_x, pocket_0_velocity_y, ball_0_rate_z, outer_0_penetration, x1, outer_0_elastic_force, outer_0_normal_x, outer_0_normal_y, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(outer_0_normal_x, outer_0_normal_y, normal_force, sliding_velocity, c[7], c[17])
    outer_0_push_on_cage_turn = push_y*pocket_0_arm_x - push_x*pocket_0_arm_y
    outer_0_push_on_way_0 = cos_cage*push_x + push_y*sin_cage
    outer_0_drag_on_cage_turn = drag_x*(half_ball_diameter*outer_0_normal_y - pocket_0_arm_y) + drag_y*(pocket_0_arm_x - half_ball_diameter*outer_0_normal_x)
    outer_0_drag_on_way_0 = cos_cage*drag_x + drag_y*sin_cage
    outer_0_drag_on_spin_0 = half_ball_diameter*drag_x*outer_0_normal_y - half_ball_diameter*drag_y*outer_0_normal_x
    return (ca.vertcat(0, 0, outer_0_drag_on_cage_turn + outer_0_push_on_cage_turn, outer_0_drag_on_way_0 + outer_0_push_on_way_0,
            outer_0_drag_on_spin_0, *[0]*11),
        ca.vertcat(*[0]*6, normal_power, power, *[0]*20), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_inner_1(t, q, u, z, m, c):
    """Forces of inner_1: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    way_1_axes_y_x, half_ball_diameter = c[9], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_1_travel = q[0], q[1], q[2], q[5]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    way_1_axis_x = cos_cage/2 - sin_cage*way_1_axes_y_x
    way_1_axis_y = sin_cage/2 + cos_cage*way_1_axes_y_x
    inner_1_apart_x = pocket_1_arm_x - shaft_x
    inner_1_apart_y = pocket_1_arm_y - shaft_y
    inner_1_apart_squared = inner_1_apart_x*inner_1_apart_x + inner_1_apart_y*inner_1_apart_y
    inner_1_distance = ca.sqrt(inner_1_apart_squared)
    inner_1_normal_x = inner_1_apart_x/inner_1_distance
    x3 = -inner_1_normal_x*half_ball_diameter
    normal_force, normal_power, push_x, push_y, first_push_on, second_push_on, push_on_angle, sliding_velocity, power, drag_x, drag_y, first_drag_on, second_drag_on, third_drag_on, drag_on_angle = sphere_on_sphere_contact(pocket_1_arm_x, pocket_1_arm_x, pocket_1_arm_y, way_1_axis_x, way_1_axis_y, inner_1_apart_x, inner_1_apart_y, inner_1_distance, inner_1_normal_x, x3, shaft_x, shaft_y, u[0], u[1], u[2], u[5], u[6], c[2], c[5], c[6], c[7], c[10], half_ball_diameter, c[17])
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, first_drag_on + first_push_on, 0, 0, second_drag_on + second_push_on,
            third_drag_on, *[0]*8, drag_on_angle + push_on_angle),
        ca.vertcat(*[0]*8, normal_power, power, *[0]*18), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_1(t, q, u, z, m, c):
    """Forces of outer_1: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    way_1_axes_y_x = c[9]
    cage_turn_angle, way_1_travel = q[2], q[5]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    way_1_axis_x = cos_cage/2 - sin_cage*way_1_axes_y_x
    way_1_axis_y = sin_cage/2 + cos_cage*way_1_axes_y_x
    normal_force, normal_power, first_push_on, second_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on = ball_in_socket_contact(pocket_1_arm_x, pocket_1_arm_y, way_1_axis_x, way_1_axis_y, u[2], u[5], u[6], c[5], c[6], c[7], c[16], c[17], c[18])
    return (ca.vertcat(0, 0, first_drag_on + first_push_on, 0, 0, second_drag_on + second_push_on, third_drag_on, *[0]*9),
        ca.vertcat(*[0]*10, normal_power, power, *[0]*16), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_inner_2(t, q, u, z, m, c):
    """Forces of inner_2: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    way_1_axes_y_x, half_ball_diameter = c[9], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_2_travel = q[0], q[1], q[2], q[7]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    way_2_axis_x = -cos_cage/2 - sin_cage*way_1_axes_y_x
    way_2_axis_y = cos_cage*way_1_axes_y_x - sin_cage/2
    inner_2_apart_x = pocket_2_arm_x - shaft_x
    inner_2_apart_y = pocket_2_arm_y - shaft_y
    inner_2_apart_squared = inner_2_apart_x*inner_2_apart_x + inner_2_apart_y*inner_2_apart_y
    inner_2_distance = ca.sqrt(inner_2_apart_squared)
    inner_2_normal_x = inner_2_apart_x/inner_2_distance
    x3 = -inner_2_normal_x*half_ball_diameter
    normal_force, normal_power, push_x, push_y, first_push_on, second_push_on, push_on_angle, sliding_velocity, power, drag_x, drag_y, first_drag_on, second_drag_on, third_drag_on, drag_on_angle = sphere_on_sphere_contact(pocket_2_arm_x, x3, pocket_2_arm_y, way_2_axis_x, way_2_axis_y, inner_2_apart_x, inner_2_apart_y, inner_2_distance, inner_2_normal_x, pocket_2_arm_x, shaft_x, shaft_y, u[0], u[1], u[2], u[7], u[8], c[2], c[5], c[6], c[7], c[10], half_ball_diameter, c[17])
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, first_drag_on + first_push_on, 0, 0, 0, 0, second_drag_on + second_push_on,
            third_drag_on, *[0]*6, drag_on_angle + push_on_angle),
        ca.vertcat(*[0]*12, normal_power, power, *[0]*14), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_2(t, q, u, z, m, c):
    """Forces of outer_2: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    way_1_axes_y_x = c[9]
    cage_turn_angle, way_2_travel = q[2], q[7]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    way_2_axis_x = -cos_cage/2 - sin_cage*way_1_axes_y_x
    way_2_axis_y = cos_cage*way_1_axes_y_x - sin_cage/2
    normal_force, normal_power, first_push_on, second_push_on, sliding_velocity, power, first_drag_on, second_drag_on, third_drag_on = ball_in_socket_contact(pocket_2_arm_x, pocket_2_arm_y, way_2_axis_x, way_2_axis_y, u[2], u[7], u[8], c[5], c[6], c[7], c[16], c[17], c[18])
    return (ca.vertcat(0, 0, first_drag_on + first_push_on, 0, 0, 0, 0, second_drag_on + second_push_on, third_drag_on, *[0]*7),
        ca.vertcat(*[0]*14, normal_power, power, *[0]*12), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_inner_3(t, q, u, z, m, c):
    """Forces of inner_3: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    speed, stiffness, inner_0_reach, half_ball_diameter = c[2], c[5], c[10], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_3_travel = q[0], q[1], q[2], q[9]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_3_speed, spin_3_speed = u[0], u[1], u[2], u[9], u[10]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_3_arm_rate_x = -cage_turn_speed*pocket_3_arm_y
    pocket_3_arm_rate_y = cage_turn_speed*pocket_3_arm_x
    pocket_3_velocity_x = pocket_3_arm_rate_x - cos_cage*way_3_speed
    pocket_3_velocity_y = pocket_3_arm_rate_y - sin_cage*way_3_speed
    ball_3_rate_z = cage_turn_speed + spin_3_speed
    inner_3_apart_x = pocket_3_arm_x - shaft_x
    inner_3_apart_y = pocket_3_arm_y - shaft_y
    inner_3_apart_squared = inner_3_apart_x*inner_3_apart_x + inner_3_apart_y*inner_3_apart_y
    inner_3_distance = ca.sqrt(inner_3_apart_squared)
    inner_3_penetration = inner_0_reach - inner_3_distance
    x1 = inner_3_penetration*ca.sqrt(inner_3_penetration)
    inner_3_elastic_force = ca.if_else(inner_3_penetration > 0, x1*stiffness, 0)
    inner_3_normal_x = inner_3_apart_x/inner_3_distance
    inner_3_normal_y = inner_3_apart_y/inner_3_distance
    inner_3_relative_rate_x = pocket_3_velocity_x + inner_3_apart_y*speed - shaft_x_speed
    inner_3_relative_rate_y = pocket_3_velocity_y - shaft_y_speed - inner_3_apart_x*speed
    normal_force, normal_power, sliding_velocity = sphere_on_sphere_contact_3(ball_3_rate_z, inner_3_penetration, x1, inner_3_elastic_force, inner_3_normal_x, inner_3_normal_y, inner_3_relative_rate_x, inner_3_relative_rate_y, speed, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(inner_3_normal_x, inner_3_normal_y, normal_force, sliding_velocity, c[7], c[17])
    inner_3_push_on_cage_turn = push_y*pocket_3_arm_x - push_x*pocket_3_arm_y
    inner_3_push_on_way_3 = -cos_cage*push_x - push_y*sin_cage
    inner_3_push_on_shaft_angle = -inner_3_apart_x*push_y - push_x*(shaft_y - pocket_3_arm_y)
    x2 = inner_3_normal_y*half_ball_diameter
    x3 = -inner_3_normal_x*half_ball_diameter
    inner_3_drag_on_cage_turn = drag_x*(x2 - pocket_3_arm_y) + drag_y*(pocket_3_arm_x + x3)
    inner_3_drag_on_way_3 = -cos_cage*drag_x - drag_y*sin_cage
    inner_3_drag_on_spin_3 = drag_x*inner_3_normal_y*half_ball_diameter - drag_y*inner_3_normal_x*half_ball_diameter
    inner_3_drag_on_shaft_angle = -drag_x*(shaft_y + x2 - pocket_3_arm_y) - drag_y*(pocket_3_arm_x + x3 - shaft_x)
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, inner_3_drag_on_cage_turn + inner_3_push_on_cage_turn, *[0]*6,
            inner_3_drag_on_way_3 + inner_3_push_on_way_3, inner_3_drag_on_spin_3, 0, 0, 0, 0, inner_3_drag_on_shaft_angle +
            inner_3_push_on_shaft_angle),
        ca.vertcat(*[0]*16, normal_power, power, *[0]*10), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_3(t, q, u, z, m, c):
    """Forces of outer_3: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    stiffness, half_ball_diameter, minus_half_clearance_minus_half_pitch_diameter = c[5], c[16], c[18]
    cage_turn_angle, way_3_travel = q[2], q[9]
    cage_turn_speed, way_3_speed, spin_3_speed = u[2], u[9], u[10]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_3_arm_rate_x = -cage_turn_speed*pocket_3_arm_y
    pocket_3_arm_rate_y = cage_turn_speed*pocket_3_arm_x
    pocket_3_velocity_x = pocket_3_arm_rate_x - cos_cage*way_3_speed
    pocket_3_velocity_y = pocket_3_arm_rate_y - sin_cage*way_3_speed
    ball_3_rate_z = cage_turn_speed + spin_3_speed
    outer_3_apart_squared = pocket_3_arm_x*pocket_3_arm_x + pocket_3_arm_y*pocket_3_arm_y
    outer_3_distance = ca.sqrt(outer_3_apart_squared)
    outer_3_penetration = minus_half_clearance_minus_half_pitch_diameter + outer_3_distance
    x1 = outer_3_penetration*ca.sqrt(outer_3_penetration)
    outer_3_elastic_force = ca.if_else(outer_3_penetration > 0, x1*stiffness, 0)
    outer_3_normal_x = -pocket_3_arm_x/outer_3_distance
    outer_3_normal_y = -pocket_3_arm_y/outer_3_distance
    normal_force, normal_power, sliding_velocity = ball_in_socket_contact_2(pocket_3_velocity_x, pocket_3_velocity_y, ball_3_rate_z, outer_3_penetration, x1, outer_3_elastic_force, outer_3_normal_x, outer_3_normal_y, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(outer_3_normal_x, outer_3_normal_y, normal_force, sliding_velocity, c[7], c[17])
    outer_3_push_on_cage_turn = push_y*pocket_3_arm_x - push_x*pocket_3_arm_y
    outer_3_push_on_way_3 = -cos_cage*push_x - push_y*sin_cage
    outer_3_drag_on_cage_turn = drag_x*(half_ball_diameter*outer_3_normal_y - pocket_3_arm_y) + drag_y*(pocket_3_arm_x - half_ball_diameter*outer_3_normal_x)
    outer_3_drag_on_way_3 = -cos_cage*drag_x - drag_y*sin_cage
    outer_3_drag_on_spin_3 = half_ball_diameter*drag_x*outer_3_normal_y - half_ball_diameter*drag_y*outer_3_normal_x
    return (ca.vertcat(0, 0, outer_3_drag_on_cage_turn + outer_3_push_on_cage_turn, *[0]*6, outer_3_drag_on_way_3 + outer_3_push_on_way_3,
            outer_3_drag_on_spin_3, *[0]*5),
        ca.vertcat(*[0]*18, normal_power, power, *[0]*8), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_inner_4(t, q, u, z, m, c):
    """Forces of inner_4: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    speed, stiffness, way_1_axes_y_x, inner_0_reach, half_ball_diameter = c[2], c[5], c[9], c[10], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_4_travel = q[0], q[1], q[2], q[11]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_4_speed, spin_4_speed = u[0], u[1], u[2], u[11], u[12]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    way_1_axis_x = cos_cage/2 - sin_cage*way_1_axes_y_x
    way_1_axis_y = sin_cage/2 + cos_cage*way_1_axes_y_x
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_4_arm_rate_x = -cage_turn_speed*pocket_4_arm_y
    pocket_4_arm_rate_y = cage_turn_speed*pocket_4_arm_x
    pocket_4_velocity_x = pocket_4_arm_rate_x - way_1_axis_x*way_4_speed
    pocket_4_velocity_y = pocket_4_arm_rate_y - way_1_axis_y*way_4_speed
    ball_4_rate_z = cage_turn_speed + spin_4_speed
    inner_4_apart_x = pocket_4_arm_x - shaft_x
    inner_4_apart_y = pocket_4_arm_y - shaft_y
    inner_4_apart_squared = inner_4_apart_x*inner_4_apart_x + inner_4_apart_y*inner_4_apart_y
    inner_4_distance = ca.sqrt(inner_4_apart_squared)
    inner_4_penetration = inner_0_reach - inner_4_distance
    x1 = inner_4_penetration*ca.sqrt(inner_4_penetration)
    inner_4_elastic_force = ca.if_else(inner_4_penetration > 0, x1*stiffness, 0)
    inner_4_normal_x = inner_4_apart_x/inner_4_distance
    inner_4_normal_y = inner_4_apart_y/inner_4_distance
    inner_4_relative_rate_x = pocket_4_velocity_x + inner_4_apart_y*speed - shaft_x_speed
    inner_4_relative_rate_y = pocket_4_velocity_y - shaft_y_speed - inner_4_apart_x*speed
    normal_force, normal_power, sliding_velocity = sphere_on_sphere_contact_3(ball_4_rate_z, inner_4_penetration, x1, inner_4_elastic_force, inner_4_normal_x, inner_4_normal_y, inner_4_relative_rate_x, inner_4_relative_rate_y, speed, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(inner_4_normal_x, inner_4_normal_y, normal_force, sliding_velocity, c[7], c[17])
    inner_4_push_on_cage_turn = push_y*pocket_4_arm_x - push_x*pocket_4_arm_y
    inner_4_push_on_way_4 = -push_x*way_1_axis_x - push_y*way_1_axis_y
    inner_4_push_on_shaft_angle = -inner_4_apart_x*push_y - push_x*(shaft_y - pocket_4_arm_y)
    x2 = inner_4_normal_y*half_ball_diameter
    x3 = -inner_4_normal_x*half_ball_diameter
    inner_4_drag_on_cage_turn = drag_x*(x2 - pocket_4_arm_y) + drag_y*(pocket_4_arm_x + x3)
    inner_4_drag_on_way_4 = -drag_x*way_1_axis_x - drag_y*way_1_axis_y
    inner_4_drag_on_spin_4 = drag_x*inner_4_normal_y*half_ball_diameter - drag_y*inner_4_normal_x*half_ball_diameter
    inner_4_drag_on_shaft_angle = -drag_x*(shaft_y + x2 - pocket_4_arm_y) - drag_y*(pocket_4_arm_x + x3 - shaft_x)
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, inner_4_drag_on_cage_turn + inner_4_push_on_cage_turn, *[0]*8,
            inner_4_drag_on_way_4 + inner_4_push_on_way_4, inner_4_drag_on_spin_4, 0, 0, inner_4_drag_on_shaft_angle +
            inner_4_push_on_shaft_angle),
        ca.vertcat(*[0]*20, normal_power, power, *[0]*6), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_4(t, q, u, z, m, c):
    """Forces of outer_4: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    stiffness, way_1_axes_y_x, half_ball_diameter, minus_half_clearance_minus_half_pitch_diameter = c[5], c[9], c[16], c[18]
    cage_turn_angle, way_4_travel = q[2], q[11]
    cage_turn_speed, way_4_speed, spin_4_speed = u[2], u[11], u[12]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    way_1_axis_x = cos_cage/2 - sin_cage*way_1_axes_y_x
    way_1_axis_y = sin_cage/2 + cos_cage*way_1_axes_y_x
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_4_arm_rate_x = -cage_turn_speed*pocket_4_arm_y
    pocket_4_arm_rate_y = cage_turn_speed*pocket_4_arm_x
    pocket_4_velocity_x = pocket_4_arm_rate_x - way_1_axis_x*way_4_speed
    pocket_4_velocity_y = pocket_4_arm_rate_y - way_1_axis_y*way_4_speed
    ball_4_rate_z = cage_turn_speed + spin_4_speed
    outer_4_apart_squared = pocket_4_arm_x*pocket_4_arm_x + pocket_4_arm_y*pocket_4_arm_y
    outer_4_distance = ca.sqrt(outer_4_apart_squared)
    outer_4_penetration = minus_half_clearance_minus_half_pitch_diameter + outer_4_distance
    x1 = outer_4_penetration*ca.sqrt(outer_4_penetration)
    outer_4_elastic_force = ca.if_else(outer_4_penetration > 0, x1*stiffness, 0)
    outer_4_normal_x = -pocket_4_arm_x/outer_4_distance
    outer_4_normal_y = -pocket_4_arm_y/outer_4_distance
    normal_force, normal_power, sliding_velocity = ball_in_socket_contact_2(pocket_4_velocity_x, pocket_4_velocity_y, ball_4_rate_z, outer_4_penetration, x1, outer_4_elastic_force, outer_4_normal_x, outer_4_normal_y, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(outer_4_normal_x, outer_4_normal_y, normal_force, sliding_velocity, c[7], c[17])
    outer_4_push_on_cage_turn = push_y*pocket_4_arm_x - push_x*pocket_4_arm_y
    outer_4_push_on_way_4 = -push_x*way_1_axis_x - push_y*way_1_axis_y
    outer_4_drag_on_cage_turn = drag_x*(half_ball_diameter*outer_4_normal_y - pocket_4_arm_y) + drag_y*(pocket_4_arm_x - half_ball_diameter*outer_4_normal_x)
    outer_4_drag_on_way_4 = -drag_x*way_1_axis_x - drag_y*way_1_axis_y
    outer_4_drag_on_spin_4 = half_ball_diameter*drag_x*outer_4_normal_y - half_ball_diameter*drag_y*outer_4_normal_x
    return (ca.vertcat(0, 0, outer_4_drag_on_cage_turn + outer_4_push_on_cage_turn, *[0]*8, outer_4_drag_on_way_4 + outer_4_push_on_way_4,
            outer_4_drag_on_spin_4, 0, 0, 0),
        ca.vertcat(*[0]*22, normal_power, power, 0, 0, 0, 0), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_inner_5(t, q, u, z, m, c):
    """Forces of inner_5: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    speed, stiffness, way_1_axes_y_x, inner_0_reach, half_ball_diameter = c[2], c[5], c[9], c[10], c[16]
    shaft_x, shaft_y, cage_turn_angle, way_5_travel = q[0], q[1], q[2], q[13]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_5_speed, spin_5_speed = u[0], u[1], u[2], u[13], u[14]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    way_2_axis_y = cos_cage*way_1_axes_y_x - sin_cage/2
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_rate_x = -cage_turn_speed*pocket_5_arm_y
    pocket_5_arm_rate_y = cage_turn_speed*pocket_5_arm_x
    way_5_axis_x = cos_cage/2 + sin_cage*way_1_axes_y_x
    pocket_5_velocity_x = pocket_5_arm_rate_x + way_5_axis_x*way_5_speed
    pocket_5_velocity_y = pocket_5_arm_rate_y - way_2_axis_y*way_5_speed
    ball_5_rate_z = cage_turn_speed + spin_5_speed
    inner_5_apart_x = pocket_5_arm_x - shaft_x
    inner_5_apart_y = pocket_5_arm_y - shaft_y
    inner_5_apart_squared = inner_5_apart_x*inner_5_apart_x + inner_5_apart_y*inner_5_apart_y
    inner_5_distance = ca.sqrt(inner_5_apart_squared)
    inner_5_penetration = inner_0_reach - inner_5_distance
    x1 = inner_5_penetration*ca.sqrt(inner_5_penetration)
    inner_5_elastic_force = ca.if_else(inner_5_penetration > 0, x1*stiffness, 0)
    inner_5_normal_x = inner_5_apart_x/inner_5_distance
    inner_5_normal_y = inner_5_apart_y/inner_5_distance
    inner_5_relative_rate_x = pocket_5_velocity_x + inner_5_apart_y*speed - shaft_x_speed
    inner_5_relative_rate_y = pocket_5_velocity_y - shaft_y_speed - inner_5_apart_x*speed
    normal_force, normal_power, sliding_velocity = sphere_on_sphere_contact_3(ball_5_rate_z, inner_5_penetration, x1, inner_5_elastic_force, inner_5_normal_x, inner_5_normal_y, inner_5_relative_rate_x, inner_5_relative_rate_y, speed, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(inner_5_normal_x, inner_5_normal_y, normal_force, sliding_velocity, c[7], c[17])
    inner_5_push_on_cage_turn = push_y*pocket_5_arm_x - push_x*pocket_5_arm_y
    inner_5_push_on_way_5 = push_x*way_5_axis_x - push_y*way_2_axis_y
    inner_5_push_on_shaft_angle = -inner_5_apart_x*push_y - push_x*(shaft_y - pocket_5_arm_y)
    x2 = inner_5_normal_y*half_ball_diameter
    x3 = -inner_5_normal_x*half_ball_diameter
    inner_5_drag_on_cage_turn = drag_x*(x2 - pocket_5_arm_y) + drag_y*(pocket_5_arm_x + x3)
    inner_5_drag_on_way_5 = drag_x*way_5_axis_x - drag_y*way_2_axis_y
    inner_5_drag_on_spin_5 = drag_x*inner_5_normal_y*half_ball_diameter - drag_y*inner_5_normal_x*half_ball_diameter
    inner_5_drag_on_shaft_angle = -drag_x*(shaft_y + x2 - pocket_5_arm_y) - drag_y*(pocket_5_arm_x + x3 - shaft_x)
    return (ca.vertcat(-drag_x - push_x, -drag_y - push_y, inner_5_drag_on_cage_turn + inner_5_push_on_cage_turn, *[0]*10,
            inner_5_drag_on_way_5 + inner_5_push_on_way_5, inner_5_drag_on_spin_5, inner_5_drag_on_shaft_angle +
            inner_5_push_on_shaft_angle),
        ca.vertcat(*[0]*24, normal_power, power, 0, 0), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def contact_outer_5(t, q, u, z, m, c):
    """Forces of outer_5: power x power_damping, smooth_coulomb; arguments and returns as of contact_inner_0."""
    stiffness, way_1_axes_y_x, half_ball_diameter, minus_half_clearance_minus_half_pitch_diameter = c[5], c[9], c[16], c[18]
    cage_turn_angle, way_5_travel = q[2], q[13]
    cage_turn_speed, way_5_speed, spin_5_speed = u[2], u[13], u[14]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    way_2_axis_y = cos_cage*way_1_axes_y_x - sin_cage/2
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_rate_x = -cage_turn_speed*pocket_5_arm_y
    pocket_5_arm_rate_y = cage_turn_speed*pocket_5_arm_x
    way_5_axis_x = cos_cage/2 + sin_cage*way_1_axes_y_x
    pocket_5_velocity_x = pocket_5_arm_rate_x + way_5_axis_x*way_5_speed
    pocket_5_velocity_y = pocket_5_arm_rate_y - way_2_axis_y*way_5_speed
    ball_5_rate_z = cage_turn_speed + spin_5_speed
    outer_5_apart_squared = pocket_5_arm_x*pocket_5_arm_x + pocket_5_arm_y*pocket_5_arm_y
    outer_5_distance = ca.sqrt(outer_5_apart_squared)
    outer_5_penetration = minus_half_clearance_minus_half_pitch_diameter + outer_5_distance
    x1 = outer_5_penetration*ca.sqrt(outer_5_penetration)
    outer_5_elastic_force = ca.if_else(outer_5_penetration > 0, x1*stiffness, 0)
    outer_5_normal_x = -pocket_5_arm_x/outer_5_distance
    outer_5_normal_y = -pocket_5_arm_y/outer_5_distance
    normal_force, normal_power, sliding_velocity = ball_in_socket_contact_2(pocket_5_velocity_x, pocket_5_velocity_y, ball_5_rate_z, outer_5_penetration, x1, outer_5_elastic_force, outer_5_normal_x, outer_5_normal_y, c[6], half_ball_diameter)
    push_x, push_y, power, drag_x, drag_y = sphere_on_sphere_contact_2(outer_5_normal_x, outer_5_normal_y, normal_force, sliding_velocity, c[7], c[17])
    outer_5_push_on_cage_turn = push_y*pocket_5_arm_x - push_x*pocket_5_arm_y
    outer_5_push_on_way_5 = push_x*way_5_axis_x - push_y*way_2_axis_y
    outer_5_drag_on_cage_turn = drag_x*(half_ball_diameter*outer_5_normal_y - pocket_5_arm_y) + drag_y*(pocket_5_arm_x - half_ball_diameter*outer_5_normal_x)
    outer_5_drag_on_way_5 = drag_x*way_5_axis_x - drag_y*way_2_axis_y
    outer_5_drag_on_spin_5 = half_ball_diameter*drag_x*outer_5_normal_y - half_ball_diameter*drag_y*outer_5_normal_x
    return (ca.vertcat(0, 0, outer_5_drag_on_cage_turn + outer_5_push_on_cage_turn, *[0]*10, outer_5_drag_on_way_5 + outer_5_push_on_way_5,
            outer_5_drag_on_spin_5, 0),
        ca.vertcat(*[0]*26, normal_power, power), ca.vertcat(normal_force), ca.vertcat(sliding_velocity), ca.vertcat(1))


def applied(t, q, u, c):
    """Generalised forces other than contact forces.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        f (16,): shaft.x [N], shaft.y [N], cage_turn [N m], way_0 [N], spin_0 [N m], way_1 [N], spin_1 [N m], way_2 [N], spin_2 [N m], way_3
            [N], spin_3 [N m], way_4 [N], spin_4 [N m], way_5 [N], spin_5 [N m], shaft.angle [N m]
    """
    load, support_damping = c[3], c[4]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    support_x_force = -shaft_x_speed*support_damping
    support_y_force = -shaft_y_speed*support_damping
    return ca.vertcat(support_x_force, support_y_force - load, *[0]*14)


def accelerations(t, q, u, f, c):
    """Generalised accelerations a from M a = f - bias, and the reactions of the drives.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; f: generalised forces; c: CONSTANTS.
    Returns, each a column vector:
        a (15,): shaft.x_acceleration [m/s^2], shaft.y_acceleration [m/s^2], cage_turn.acceleration [rad/s^2], way_0.acceleration [m/s^2],
            spin_0.acceleration [rad/s^2], way_1.acceleration [m/s^2], spin_1.acceleration [rad/s^2], way_2.acceleration [m/s^2],
            spin_2.acceleration [rad/s^2], way_3.acceleration [m/s^2], spin_3.acceleration [rad/s^2], way_4.acceleration [m/s^2],
            spin_4.acceleration [rad/s^2], way_5.acceleration [m/s^2], spin_5.acceleration [rad/s^2]
        reactions (1,): shaft.angle.reaction [N m]
    """
    cage_inertia, ball_mass, way_1_axes_y_x, way_1_axes_y_x_squared, k12, inverse_ring_mass = c[0], c[1], c[9], c[20], c[21], c[22]
    inverse_ball_inertia = c[23]
    cage_turn_angle, way_0_travel, way_1_travel, way_2_travel, way_3_travel, way_4_travel = q[2], q[3], q[5], q[7], q[9], q[11]
    way_5_travel = q[13]
    cage_turn_speed, way_0_speed, way_1_speed, way_2_speed, way_3_speed, way_4_speed = u[2], u[3], u[5], u[7], u[9], u[11]
    way_5_speed = u[13]
    shaft_x_force, shaft_y_force, cage_turn_force, way_0_force, spin_0_force, way_1_force = f[0], f[1], f[2], f[3], f[4], f[5]
    spin_1_force, way_2_force, spin_2_force, way_3_force, spin_3_force, way_4_force = f[6], f[7], f[8], f[9], f[10], f[11]
    spin_4_force, way_5_force, spin_5_force, shaft_angle_force = f[12], f[13], f[14], f[15]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    half_cos_cage = cos_cage/2
    way_1_axis_x = half_cos_cage - sin_cage*way_1_axes_y_x
    cos_cage_times_way_1_axes_y_x = cos_cage*way_1_axes_y_x
    way_1_axis_y = cos_cage_times_way_1_axes_y_x + sin_cage/2
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    way_2_axis_y = cos_cage_times_way_1_axes_y_x - sin_cage/2
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    way_5_axis_x = half_cos_cage + sin_cage*way_1_axes_y_x
    cage_rate_zz = cage_turn_speed*cage_turn_speed
    pocket_0_coriolis_x = -2*cage_turn_speed*sin_cage*way_0_speed
    pocket_0_coriolis_y = 2*cage_turn_speed*cos_cage*way_0_speed
    pocket_0_turned_force_x = pocket_0_coriolis_x*ball_mass
    pocket_0_turned_force_y = pocket_0_coriolis_y*ball_mass
    pocket_0_bias_x = pocket_0_coriolis_x - cage_rate_zz*pocket_0_arm_x
    pocket_0_bias_y = pocket_0_coriolis_y - cage_rate_zz*pocket_0_arm_y
    pocket_1_coriolis_x = -2*cage_turn_speed*way_1_axis_y*way_1_speed
    pocket_1_coriolis_y = 2*cage_turn_speed*way_1_axis_x*way_1_speed
    pocket_1_turned_force_x = pocket_1_coriolis_x*ball_mass
    pocket_1_turned_force_y = pocket_1_coriolis_y*ball_mass
    pocket_1_bias_x = pocket_1_coriolis_x - cage_rate_zz*pocket_1_arm_x
    pocket_1_bias_y = pocket_1_coriolis_y - cage_rate_zz*pocket_1_arm_y
    pocket_2_coriolis_x = -2*cage_turn_speed*way_2_axis_y*way_2_speed
    pocket_2_coriolis_y = -2*cage_turn_speed*way_2_speed*way_5_axis_x
    pocket_2_turned_force_x = pocket_2_coriolis_x*ball_mass
    pocket_2_turned_force_y = pocket_2_coriolis_y*ball_mass
    pocket_2_bias_x = pocket_2_coriolis_x - cage_rate_zz*pocket_2_arm_x
    pocket_2_bias_y = pocket_2_coriolis_y - cage_rate_zz*pocket_2_arm_y
    pocket_3_coriolis_x = 2*cage_turn_speed*sin_cage*way_3_speed
    pocket_3_coriolis_y = -2*cage_turn_speed*cos_cage*way_3_speed
    pocket_3_turned_force_x = pocket_3_coriolis_x*ball_mass
    pocket_3_turned_force_y = pocket_3_coriolis_y*ball_mass
    pocket_3_bias_x = pocket_3_coriolis_x - cage_rate_zz*pocket_3_arm_x
    pocket_3_bias_y = pocket_3_coriolis_y - cage_rate_zz*pocket_3_arm_y
    pocket_4_coriolis_x = 2*cage_turn_speed*way_1_axis_y*way_4_speed
    pocket_4_coriolis_y = -2*cage_turn_speed*way_1_axis_x*way_4_speed
    pocket_4_turned_force_x = pocket_4_coriolis_x*ball_mass
    pocket_4_turned_force_y = pocket_4_coriolis_y*ball_mass
    pocket_4_bias_x = pocket_4_coriolis_x - cage_rate_zz*pocket_4_arm_x
    pocket_4_bias_y = pocket_4_coriolis_y - cage_rate_zz*pocket_4_arm_y
    pocket_5_coriolis_x = 2*cage_turn_speed*way_2_axis_y*way_5_speed
    pocket_5_coriolis_y = 2*cage_turn_speed*way_5_axis_x*way_5_speed
    pocket_5_turned_force_x = pocket_5_coriolis_x*ball_mass
    pocket_5_turned_force_y = pocket_5_coriolis_y*ball_mass
    pocket_5_bias_x = pocket_5_coriolis_x - cage_rate_zz*pocket_5_arm_x
    pocket_5_bias_y = pocket_5_coriolis_y - cage_rate_zz*pocket_5_arm_y
    cage_torque_z = pocket_0_arm_x*pocket_0_turned_force_y + pocket_1_arm_x*pocket_1_turned_force_y + pocket_2_arm_x*pocket_2_turned_force_y + pocket_3_arm_x*pocket_3_turned_force_y + pocket_4_arm_x*pocket_4_turned_force_y + pocket_5_arm_x*pocket_5_turned_force_y - pocket_0_arm_y*pocket_0_turned_force_x - pocket_1_arm_y*pocket_1_turned_force_x - pocket_2_arm_y*pocket_2_turned_force_x - pocket_3_arm_y*pocket_3_turned_force_x - pocket_4_arm_y*pocket_4_turned_force_x - pocket_5_arm_y*pocket_5_turned_force_x
    cage_turn_net = cage_turn_force - cage_torque_z
    way_0_net = way_0_force - cos_cage*pocket_0_bias_x*ball_mass - pocket_0_bias_y*sin_cage*ball_mass
    way_1_net = way_1_force - pocket_1_bias_x*way_1_axis_x*ball_mass - pocket_1_bias_y*way_1_axis_y*ball_mass
    way_2_net = way_2_force + pocket_2_bias_x*way_5_axis_x*ball_mass - pocket_2_bias_y*way_2_axis_y*ball_mass
    way_3_net = way_3_force + cos_cage*pocket_3_bias_x*ball_mass + pocket_3_bias_y*sin_cage*ball_mass
    way_4_net = way_4_force + pocket_4_bias_x*way_1_axis_x*ball_mass + pocket_4_bias_y*way_1_axis_y*ball_mass
    way_5_net = way_5_force + pocket_5_bias_y*way_2_axis_y*ball_mass - pocket_5_bias_x*way_5_axis_x*ball_mass
    way_1_travel_squared = way_1_travel*way_1_travel
    way_2_travel_squared = way_2_travel*way_2_travel
    way_4_travel_squared = way_4_travel*way_4_travel
    way_5_travel_squared = way_5_travel*way_5_travel
    cage_I_z_z = way_0_travel*way_0_travel*ball_mass + way_3_travel*way_3_travel*ball_mass + (way_1_travel_squared/4 + way_1_axes_y_x_squared*way_1_travel_squared)*ball_mass + (way_2_travel_squared/4 + way_1_axes_y_x_squared*way_2_travel_squared)*ball_mass + (way_4_travel_squared/4 + way_1_axes_y_x_squared*way_4_travel_squared)*ball_mass + (way_5_travel_squared/4 + way_1_axes_y_x_squared*way_5_travel_squared)*ball_mass + cage_inertia
    cage_total_J_z_z = cage_I_z_z + k12
    M_way_0_way_0 = cos_cage*cos_cage*ball_mass + sin_cage*sin_cage*ball_mass
    way_0_pocket_0_force_x = cos_cage*ball_mass
    way_0_pocket_0_force_y = sin_cage*ball_mass
    way_0_pocket_0_torque_z = pocket_0_arm_x*way_0_pocket_0_force_y - pocket_0_arm_y*way_0_pocket_0_force_x
    M_way_1_way_1 = way_1_axis_x*way_1_axis_x*ball_mass + way_1_axis_y*way_1_axis_y*ball_mass
    way_1_pocket_1_force_x = way_1_axis_x*ball_mass
    way_1_pocket_1_force_y = way_1_axis_y*ball_mass
    way_1_pocket_1_torque_z = pocket_1_arm_x*way_1_pocket_1_force_y - pocket_1_arm_y*way_1_pocket_1_force_x
    M_way_2_way_2 = way_2_axis_y*way_2_axis_y*ball_mass + way_5_axis_x*way_5_axis_x*ball_mass
    way_2_pocket_2_force_x = -way_5_axis_x*ball_mass
    way_2_pocket_2_force_y = way_2_axis_y*ball_mass
    way_2_pocket_2_torque_z = pocket_2_arm_x*way_2_pocket_2_force_y - pocket_2_arm_y*way_2_pocket_2_force_x
    way_3_pocket_3_torque_z = pocket_3_arm_y*way_0_pocket_0_force_x - pocket_3_arm_x*way_0_pocket_0_force_y
    way_4_pocket_4_torque_z = pocket_4_arm_y*way_1_pocket_1_force_x - pocket_4_arm_x*way_1_pocket_1_force_y
    way_5_pocket_5_force_x = way_5_axis_x*ball_mass
    way_5_pocket_5_torque_z = -pocket_5_arm_x*way_2_pocket_2_force_y - pocket_5_arm_y*way_5_pocket_5_force_x
    l_cage_turn_way_5 = way_5_pocket_5_torque_z/M_way_2_way_2
    l_cage_turn_way_4 = way_4_pocket_4_torque_z/M_way_1_way_1
    l_cage_turn_way_3 = way_3_pocket_3_torque_z/M_way_0_way_0
    l_cage_turn_way_2 = way_2_pocket_2_torque_z/M_way_2_way_2
    l_cage_turn_way_1 = way_1_pocket_1_torque_z/M_way_1_way_1
    l_cage_turn_way_0 = way_0_pocket_0_torque_z/M_way_0_way_0
    D_cage_turn = cage_total_J_z_z - k12 - l_cage_turn_way_0*way_0_pocket_0_torque_z - l_cage_turn_way_1*way_1_pocket_1_torque_z - l_cage_turn_way_2*way_2_pocket_2_torque_z - l_cage_turn_way_3*way_3_pocket_3_torque_z - l_cage_turn_way_4*way_4_pocket_4_torque_z - l_cage_turn_way_5*way_5_pocket_5_torque_z
    y_cage_turn = cage_turn_net - spin_0_force - spin_1_force - spin_2_force - spin_3_force - spin_4_force - spin_5_force - l_cage_turn_way_0*way_0_net - l_cage_turn_way_1*way_1_net - l_cage_turn_way_2*way_2_net - l_cage_turn_way_3*way_3_net - l_cage_turn_way_4*way_4_net - l_cage_turn_way_5*way_5_net
    shaft_x_acc = inverse_ring_mass*shaft_x_force
    shaft_y_acc = inverse_ring_mass*shaft_y_force
    cage_turn_acc = y_cage_turn/D_cage_turn
    way_0_acc = way_0_net/M_way_0_way_0 - cage_turn_acc*l_cage_turn_way_0
    spin_0_acc = inverse_ball_inertia*spin_0_force - cage_turn_acc
    way_1_acc = way_1_net/M_way_1_way_1 - cage_turn_acc*l_cage_turn_way_1
    spin_1_acc = inverse_ball_inertia*spin_1_force - cage_turn_acc
    way_2_acc = way_2_net/M_way_2_way_2 - cage_turn_acc*l_cage_turn_way_2
    spin_2_acc = inverse_ball_inertia*spin_2_force - cage_turn_acc
    way_3_acc = way_3_net/M_way_0_way_0 - cage_turn_acc*l_cage_turn_way_3
    spin_3_acc = inverse_ball_inertia*spin_3_force - cage_turn_acc
    way_4_acc = way_4_net/M_way_1_way_1 - cage_turn_acc*l_cage_turn_way_4
    spin_4_acc = inverse_ball_inertia*spin_4_force - cage_turn_acc
    way_5_acc = way_5_net/M_way_2_way_2 - cage_turn_acc*l_cage_turn_way_5
    spin_5_acc = inverse_ball_inertia*spin_5_force - cage_turn_acc
    return (ca.vertcat(shaft_x_acc, shaft_y_acc, cage_turn_acc, way_0_acc, spin_0_acc, way_1_acc, spin_1_acc, way_2_acc, spin_2_acc,
            way_3_acc, spin_3_acc, way_4_acc, spin_4_acc, way_5_acc, spin_5_acc),
        ca.vertcat(-shaft_angle_force))


def ledger(t, q, u, reactions, c):
    """Power put in by drives, in its row of z; put in and dissipated by force elements, in theirs.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; reactions of the drives; c: CONSTANTS.
    Returns, each a column vector:
        dz (28,): MEMORY [W]
    """
    speed, load, support_damping = c[2], c[3], c[4]
    shaft_x_speed, shaft_y_speed = u[0], u[1]
    shaft_angle_reaction_in = reactions[0]
    support_x_force = -shaft_x_speed*support_damping
    support_y_force = -shaft_y_speed*support_damping
    return ca.vertcat(shaft_angle_reaction_in*speed, -shaft_y_speed*load, -shaft_x_speed*support_x_force, -shaft_y_speed*support_y_force,
        *[0]*24)


def energy(t, q, u, c):
    """Kinetic and potential energy, and the energy stored by each pair's stiffness.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        kinetic (1,): kinetic [J]
        potential (1,): potential [J]
        stored (12,): PAIRS [J]
    """
    way_1_axes_y_x, inner_0_reach, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter = c[9], c[10], c[15], c[18]
    half_ball_mass, half_ball_inertia, half_cage_inertia, half_ring_mass = c[19], c[24], c[25], c[26]
    half_speed_squared_times_ring_inertia = c[27]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel, way_1_travel, way_2_travel, way_3_travel = q[0], q[1], q[2], q[3], q[5], q[7], q[9]
    way_4_travel, way_5_travel = q[11], q[13]
    shaft_x_speed, shaft_y_speed, cage_turn_speed, way_0_speed, spin_0_speed, way_1_speed = u[0], u[1], u[2], u[3], u[4], u[5]
    spin_1_speed, way_2_speed, spin_2_speed, way_3_speed, spin_3_speed, way_4_speed = u[6], u[7], u[8], u[9], u[10], u[11]
    spin_4_speed, way_5_speed, spin_5_speed = u[12], u[13], u[14]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    ball_0_rate_z = cage_turn_speed + spin_0_speed
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    half_cos_cage = cos_cage/2
    way_1_axis_x = half_cos_cage - sin_cage*way_1_axes_y_x
    cos_cage_times_way_1_axes_y_x = cos_cage*way_1_axes_y_x
    way_1_axis_y = cos_cage_times_way_1_axes_y_x + sin_cage/2
    ball_1_rate_z = cage_turn_speed + spin_1_speed
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    way_2_axis_y = cos_cage_times_way_1_axes_y_x - sin_cage/2
    ball_2_rate_z = cage_turn_speed + spin_2_speed
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    ball_3_rate_z = cage_turn_speed + spin_3_speed
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    ball_4_rate_z = cage_turn_speed + spin_4_speed
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    way_5_axis_x = half_cos_cage + sin_cage*way_1_axes_y_x
    ball_5_rate_z = cage_turn_speed + spin_5_speed
    inner_0_stored_energy = sphere_on_sphere_stored_energy(pocket_0_arm_x, pocket_0_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_0_stored_energy = ball_in_socket_stored_energy(pocket_0_arm_x, pocket_0_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    inner_1_stored_energy = sphere_on_sphere_stored_energy(pocket_1_arm_x, pocket_1_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_1_stored_energy = ball_in_socket_stored_energy(pocket_1_arm_x, pocket_1_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    inner_2_stored_energy = sphere_on_sphere_stored_energy(pocket_2_arm_x, pocket_2_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_2_stored_energy = ball_in_socket_stored_energy(pocket_2_arm_x, pocket_2_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    inner_3_stored_energy = sphere_on_sphere_stored_energy(pocket_3_arm_x, pocket_3_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_3_stored_energy = ball_in_socket_stored_energy(pocket_3_arm_x, pocket_3_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    inner_4_stored_energy = sphere_on_sphere_stored_energy(pocket_4_arm_x, pocket_4_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_4_stored_energy = ball_in_socket_stored_energy(pocket_4_arm_x, pocket_4_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    inner_5_stored_energy = sphere_on_sphere_stored_energy(pocket_5_arm_x, pocket_5_arm_y, shaft_x, shaft_y, inner_0_reach, two_fifths_of_stiffness)
    outer_5_stored_energy = ball_in_socket_stored_energy(pocket_5_arm_x, pocket_5_arm_y, two_fifths_of_stiffness, minus_half_clearance_minus_half_pitch_diameter)
    pocket_0_velocity_x_2 = cos_cage*way_0_speed - cage_turn_speed*pocket_0_arm_y
    pocket_0_velocity_y_2 = cage_turn_speed*pocket_0_arm_x + sin_cage*way_0_speed
    pocket_1_velocity_x_2 = way_1_axis_x*way_1_speed - cage_turn_speed*pocket_1_arm_y
    pocket_1_velocity_y_2 = cage_turn_speed*pocket_1_arm_x + way_1_axis_y*way_1_speed
    pocket_2_velocity_x_2 = -cage_turn_speed*pocket_2_arm_y - way_2_speed*way_5_axis_x
    pocket_2_velocity_y_2 = cage_turn_speed*pocket_2_arm_x + way_2_axis_y*way_2_speed
    pocket_3_velocity_x_2 = -cage_turn_speed*pocket_3_arm_y - cos_cage*way_3_speed
    pocket_3_velocity_y_2 = cage_turn_speed*pocket_3_arm_x - sin_cage*way_3_speed
    pocket_4_velocity_x_2 = -cage_turn_speed*pocket_4_arm_y - way_1_axis_x*way_4_speed
    pocket_4_velocity_y_2 = cage_turn_speed*pocket_4_arm_x - way_1_axis_y*way_4_speed
    pocket_5_velocity_x_2 = way_5_axis_x*way_5_speed - cage_turn_speed*pocket_5_arm_y
    pocket_5_velocity_y_2 = cage_turn_speed*pocket_5_arm_x - way_2_axis_y*way_5_speed
    kinetic = half_speed_squared_times_ring_inertia + half_ball_inertia*ball_0_rate_z*ball_0_rate_z + half_ball_inertia*ball_1_rate_z*ball_1_rate_z + half_ball_inertia*ball_2_rate_z*ball_2_rate_z + half_ball_inertia*ball_3_rate_z*ball_3_rate_z + half_ball_inertia*ball_4_rate_z*ball_4_rate_z + half_ball_inertia*ball_5_rate_z*ball_5_rate_z + half_cage_inertia*cage_turn_speed*cage_turn_speed + half_ring_mass*(shaft_x_speed*shaft_x_speed + shaft_y_speed*shaft_y_speed) + half_ball_mass*(pocket_0_velocity_x_2*pocket_0_velocity_x_2 + pocket_0_velocity_y_2*pocket_0_velocity_y_2) + half_ball_mass*(pocket_1_velocity_x_2*pocket_1_velocity_x_2 + pocket_1_velocity_y_2*pocket_1_velocity_y_2) + half_ball_mass*(pocket_2_velocity_x_2*pocket_2_velocity_x_2 + pocket_2_velocity_y_2*pocket_2_velocity_y_2) + half_ball_mass*(pocket_3_velocity_x_2*pocket_3_velocity_x_2 + pocket_3_velocity_y_2*pocket_3_velocity_y_2) + half_ball_mass*(pocket_4_velocity_x_2*pocket_4_velocity_x_2 + pocket_4_velocity_y_2*pocket_4_velocity_y_2) + half_ball_mass*(pocket_5_velocity_x_2*pocket_5_velocity_x_2 + pocket_5_velocity_y_2*pocket_5_velocity_y_2)
    return (ca.vertcat(kinetic), ca.vertcat(0),
        ca.vertcat(inner_0_stored_energy, outer_0_stored_energy, inner_1_stored_energy, outer_1_stored_energy, inner_2_stored_energy,
            outer_2_stored_energy, inner_3_stored_energy, outer_3_stored_energy, inner_4_stored_energy, outer_4_stored_energy,
            inner_5_stored_energy, outer_5_stored_energy))


def poses(t, q, c):
    """Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.

    Arguments: t [s]; q: COORDINATES; c: CONSTANTS.
    Returns, each a column vector:
        positions (42,): ring.x [m], ring.y [m], ring.z [m], cage.x [m], cage.y [m], cage.z [m], pocket_0.x [m], pocket_0.y [m], pocket_0.z
            [m], ball_0.x [m], ball_0.y [m], ball_0.z [m], pocket_1.x [m], pocket_1.y [m], pocket_1.z [m], ball_1.x [m], ball_1.y [m],
            ball_1.z [m], pocket_2.x [m], pocket_2.y [m], pocket_2.z [m], ball_2.x [m], ball_2.y [m], ball_2.z [m], pocket_3.x [m],
            pocket_3.y [m], pocket_3.z [m], ball_3.x [m], ball_3.y [m], ball_3.z [m], pocket_4.x [m], pocket_4.y [m], pocket_4.z [m],
            ball_4.x [m], ball_4.y [m], ball_4.z [m], pocket_5.x [m], pocket_5.y [m], pocket_5.z [m], ball_5.x [m], ball_5.y [m], ball_5.z
            [m]
        rotations (126,): ring.R_xx [1], ring.R_xy [1], ring.R_xz [1], ring.R_yx [1], ring.R_yy [1], ring.R_yz [1], ring.R_zx [1], ring.R_zy
            [1], ring.R_zz [1], cage.R_xx [1], cage.R_xy [1], cage.R_xz [1], cage.R_yx [1], cage.R_yy [1], cage.R_yz [1], cage.R_zx [1],
            cage.R_zy [1], cage.R_zz [1], pocket_0.R_xx [1], pocket_0.R_xy [1], pocket_0.R_xz [1], pocket_0.R_yx [1], pocket_0.R_yy [1],
            pocket_0.R_yz [1], pocket_0.R_zx [1], pocket_0.R_zy [1], pocket_0.R_zz [1], ball_0.R_xx [1], ball_0.R_xy [1], ball_0.R_xz [1],
            ball_0.R_yx [1], ball_0.R_yy [1], ball_0.R_yz [1], ball_0.R_zx [1], ball_0.R_zy [1], ball_0.R_zz [1], pocket_1.R_xx [1],
            pocket_1.R_xy [1], pocket_1.R_xz [1], pocket_1.R_yx [1], pocket_1.R_yy [1], pocket_1.R_yz [1], pocket_1.R_zx [1], pocket_1.R_zy
            [1], pocket_1.R_zz [1], ball_1.R_xx [1], ball_1.R_xy [1], ball_1.R_xz [1], ball_1.R_yx [1], ball_1.R_yy [1], ball_1.R_yz [1],
            ball_1.R_zx [1], ball_1.R_zy [1], ball_1.R_zz [1], pocket_2.R_xx [1], pocket_2.R_xy [1], pocket_2.R_xz [1], pocket_2.R_yx [1],
            pocket_2.R_yy [1], pocket_2.R_yz [1], pocket_2.R_zx [1], pocket_2.R_zy [1], pocket_2.R_zz [1], ball_2.R_xx [1], ball_2.R_xy [1],
            ball_2.R_xz [1], ball_2.R_yx [1], ball_2.R_yy [1], ball_2.R_yz [1], ball_2.R_zx [1], ball_2.R_zy [1], ball_2.R_zz [1],
            pocket_3.R_xx [1], pocket_3.R_xy [1], pocket_3.R_xz [1], pocket_3.R_yx [1], pocket_3.R_yy [1], pocket_3.R_yz [1], pocket_3.R_zx
            [1], pocket_3.R_zy [1], pocket_3.R_zz [1], ball_3.R_xx [1], ball_3.R_xy [1], ball_3.R_xz [1], ball_3.R_yx [1], ball_3.R_yy [1],
            ball_3.R_yz [1], ball_3.R_zx [1], ball_3.R_zy [1], ball_3.R_zz [1], pocket_4.R_xx [1], pocket_4.R_xy [1], pocket_4.R_xz [1],
            pocket_4.R_yx [1], pocket_4.R_yy [1], pocket_4.R_yz [1], pocket_4.R_zx [1], pocket_4.R_zy [1], pocket_4.R_zz [1], ball_4.R_xx
            [1], ball_4.R_xy [1], ball_4.R_xz [1], ball_4.R_yx [1], ball_4.R_yy [1], ball_4.R_yz [1], ball_4.R_zx [1], ball_4.R_zy [1],
            ball_4.R_zz [1], pocket_5.R_xx [1], pocket_5.R_xy [1], pocket_5.R_xz [1], pocket_5.R_yx [1], pocket_5.R_yy [1], pocket_5.R_yz
            [1], pocket_5.R_zx [1], pocket_5.R_zy [1], pocket_5.R_zz [1], ball_5.R_xx [1], ball_5.R_xy [1], ball_5.R_xz [1], ball_5.R_yx
            [1], ball_5.R_yy [1], ball_5.R_yz [1], ball_5.R_zx [1], ball_5.R_zy [1], ball_5.R_zz [1]
    """
    speed, way_1_axes_x_y, way_1_axes_y_x = c[2], c[8], c[9]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel, spin_0_angle, way_1_travel, spin_1_angle = q[0], q[1], q[2], q[3], q[4], q[5], q[6]
    way_2_travel, spin_2_angle, way_3_travel, spin_3_angle, way_4_travel, spin_4_angle = q[7], q[8], q[9], q[10], q[11], q[12]
    way_5_travel, spin_5_angle = q[13], q[14]
    ring_angle = t*speed
    cos_ring = ca.cos(ring_angle)
    sin_ring = ca.sin(ring_angle)
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    ball_0_angle = cage_turn_angle + spin_0_angle
    cos_ball_0 = ca.cos(ball_0_angle)
    sin_ball_0 = ca.sin(ball_0_angle)
    ball_1_angle = cage_turn_angle + spin_1_angle
    cos_ball_1 = ca.cos(ball_1_angle)
    sin_ball_1 = ca.sin(ball_1_angle)
    ball_2_angle = cage_turn_angle + spin_2_angle
    cos_ball_2 = ca.cos(ball_2_angle)
    sin_ball_2 = ca.sin(ball_2_angle)
    ball_3_angle = cage_turn_angle + spin_3_angle
    cos_ball_3 = ca.cos(ball_3_angle)
    sin_ball_3 = ca.sin(ball_3_angle)
    ball_4_angle = cage_turn_angle + spin_4_angle
    cos_ball_4 = ca.cos(ball_4_angle)
    sin_ball_4 = ca.sin(ball_4_angle)
    ball_5_angle = cage_turn_angle + spin_5_angle
    cos_ball_5 = ca.cos(ball_5_angle)
    sin_ball_5 = ca.sin(ball_5_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    half_cos_cage = cos_cage/2
    way_1_axis_x = half_cos_cage - sin_cage*way_1_axes_y_x
    cos_cage_times_way_1_axes_y_x = cos_cage*way_1_axes_y_x
    way_1_axis_y = cos_cage_times_way_1_axes_y_x + sin_cage/2
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    minus_half_sin_cage = -sin_cage/2
    way_2_axis_y = cos_cage_times_way_1_axes_y_x + minus_half_sin_cage
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    way_5_axis_x = half_cos_cage + sin_cage*way_1_axes_y_x
    pocket_1_R_x_y = minus_half_sin_cage + cos_cage*way_1_axes_x_y
    pocket_1_R_y_y = half_cos_cage + sin_cage*way_1_axes_x_y
    half_cos_ball_1 = cos_ball_1/2
    ball_1_R_x_x = half_cos_ball_1 - sin_ball_1*way_1_axes_y_x
    ball_1_R_x_y = cos_ball_1*way_1_axes_x_y - sin_ball_1/2
    ball_1_R_y_x = sin_ball_1/2 + cos_ball_1*way_1_axes_y_x
    ball_1_R_y_y = half_cos_ball_1 + sin_ball_1*way_1_axes_x_y
    ball_2_R_x_x = -cos_ball_2/2 - sin_ball_2*way_1_axes_y_x
    ball_2_R_x_y = sin_ball_2/2 - cos_ball_2*way_1_axes_y_x
    ball_2_R_y_x = cos_ball_2*way_1_axes_y_x - sin_ball_2/2
    ball_4_R_x_x = sin_ball_4*way_1_axes_y_x - cos_ball_4/2
    ball_4_R_x_y = sin_ball_4/2 + cos_ball_4*way_1_axes_y_x
    ball_5_R_x_x = cos_ball_5/2 + sin_ball_5*way_1_axes_y_x
    ball_5_R_x_y = cos_ball_5*way_1_axes_y_x - sin_ball_5/2
    return (ca.vertcat(shaft_x, shaft_y, 0, 0, 0, 0, pocket_0_arm_x, pocket_0_arm_y, 0, pocket_0_arm_x, pocket_0_arm_y, 0, pocket_1_arm_x,
            pocket_1_arm_y, 0, pocket_1_arm_x, pocket_1_arm_y, 0, pocket_2_arm_x, pocket_2_arm_y, 0, pocket_2_arm_x, pocket_2_arm_y, 0,
            pocket_3_arm_x, pocket_3_arm_y, 0, pocket_3_arm_x, pocket_3_arm_y, 0, pocket_4_arm_x, pocket_4_arm_y, 0, pocket_4_arm_x,
            pocket_4_arm_y, 0, pocket_5_arm_x, pocket_5_arm_y, 0, pocket_5_arm_x, pocket_5_arm_y, 0),
        ca.vertcat(cos_ring, -sin_ring, 0, sin_ring, cos_ring, 0, 0, 0, 1, cos_cage, -sin_cage, 0, sin_cage, cos_cage, 0, 0, 0, 1, cos_cage,
            -sin_cage, 0, sin_cage, cos_cage, 0, 0, 0, 1, cos_ball_0, -sin_ball_0, 0, sin_ball_0, cos_ball_0, 0, 0, 0, 1, way_1_axis_x,
            pocket_1_R_x_y, 0, way_1_axis_y, pocket_1_R_y_y, 0, 0, 0, 1, ball_1_R_x_x, ball_1_R_x_y, 0, ball_1_R_y_x, ball_1_R_y_y, 0, 0, 0,
            1, -way_5_axis_x, -way_2_axis_y, 0, way_2_axis_y, -way_5_axis_x, 0, 0, 0, 1, ball_2_R_x_x, ball_2_R_x_y, 0, ball_2_R_y_x,
            ball_2_R_x_x, 0, 0, 0, 1, -cos_cage, sin_cage, 0, -sin_cage, -cos_cage, 0, 0, 0, 1, -cos_ball_3, sin_ball_3, 0, -sin_ball_3,
            -cos_ball_3, 0, 0, 0, 1, -way_1_axis_x, way_1_axis_y, 0, -way_1_axis_y, -way_1_axis_x, 0, 0, 0, 1, ball_4_R_x_x, ball_4_R_x_y,
            0, -ball_4_R_x_y, ball_4_R_x_x, 0, 0, 0, 1, way_5_axis_x, way_2_axis_y, 0, -way_2_axis_y, way_5_axis_x, 0, 0, 0, 1,
            ball_5_R_x_x, ball_5_R_x_y, 0, -ball_5_R_x_y, ball_5_R_x_x, 0, 0, 0, 1))


def outputs(t, q, u, c):
    """Named quantities, see OUTPUTS.

    Arguments: t [s]; q: COORDINATES; u: SPEEDS; c: CONSTANTS.
    Returns, each a column vector:
        y (18,): OUTPUTS
    """
    way_1_axes_y_x, inner_0_reach = c[9], c[10]
    shaft_x, shaft_y, cage_turn_angle, way_0_travel, way_1_travel, way_2_travel, way_3_travel = q[0], q[1], q[2], q[3], q[5], q[7], q[9]
    way_4_travel, way_5_travel = q[11], q[13]
    cos_cage = ca.cos(cage_turn_angle)
    sin_cage = ca.sin(cage_turn_angle)
    pocket_0_arm_x = cos_cage*way_0_travel
    pocket_0_arm_y = sin_cage*way_0_travel
    pocket_1_arm_x = cos_cage*way_1_travel/2 - sin_cage*way_1_axes_y_x*way_1_travel
    pocket_1_arm_y = sin_cage*way_1_travel/2 + cos_cage*way_1_axes_y_x*way_1_travel
    pocket_2_arm_x = -cos_cage*way_2_travel/2 - sin_cage*way_1_axes_y_x*way_2_travel
    pocket_2_arm_y = cos_cage*way_1_axes_y_x*way_2_travel - sin_cage*way_2_travel/2
    pocket_3_arm_x = -cos_cage*way_3_travel
    pocket_3_arm_y = -sin_cage*way_3_travel
    pocket_4_arm_x = sin_cage*way_1_axes_y_x*way_4_travel - cos_cage*way_4_travel/2
    pocket_4_arm_y = -sin_cage*way_4_travel/2 - cos_cage*way_1_axes_y_x*way_4_travel
    pocket_5_arm_x = cos_cage*way_5_travel/2 + sin_cage*way_1_axes_y_x*way_5_travel
    pocket_5_arm_y = sin_cage*way_5_travel/2 - cos_cage*way_1_axes_y_x*way_5_travel
    inner_0_penetration = sphere_on_sphere_penetration(pocket_0_arm_x, pocket_0_arm_y, shaft_x, shaft_y, inner_0_reach)
    inner_1_penetration = sphere_on_sphere_penetration(pocket_1_arm_x, pocket_1_arm_y, shaft_x, shaft_y, inner_0_reach)
    inner_2_penetration = sphere_on_sphere_penetration(pocket_2_arm_x, pocket_2_arm_y, shaft_x, shaft_y, inner_0_reach)
    inner_3_penetration = sphere_on_sphere_penetration(pocket_3_arm_x, pocket_3_arm_y, shaft_x, shaft_y, inner_0_reach)
    inner_4_penetration = sphere_on_sphere_penetration(pocket_4_arm_x, pocket_4_arm_y, shaft_x, shaft_y, inner_0_reach)
    inner_5_penetration = sphere_on_sphere_penetration(pocket_5_arm_x, pocket_5_arm_y, shaft_x, shaft_y, inner_0_reach)
    return ca.vertcat(-inner_0_penetration, pocket_0_arm_x, pocket_0_arm_y, -inner_1_penetration, pocket_1_arm_x, pocket_1_arm_y,
        -inner_2_penetration, pocket_2_arm_x, pocket_2_arm_y, -inner_3_penetration, pocket_3_arm_x, pocket_3_arm_y, -inner_4_penetration,
        pocket_4_arm_x, pocket_4_arm_y, -inner_5_penetration, pocket_5_arm_x, pocket_5_arm_y)


def period(p):
    """Common period of everything that depends on time.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        period (1,): period [s]
    """
    speed = p[9]
    return ca.vertcat(2*3.141592653589793/ca.fabs(speed))


def landmarks(p):
    """Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.

    Arguments: p: PARAMETERS, in SI.
    Returns, each a column vector:
        shaft.parent, shaft.child (6,): x [m], y [m], z [m], normal_x [1], normal_y [1], normal_z [1]
        cage_turn.parent to spin_5.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        inner_0.first to outer_5.socket (4,): x [m], y [m], z [m], radius [m]
        motor.child (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        load.point (3,): x [m], y [m], z [m]
        load.axes (6,): x [m], y [m], z [m], force_x [N], force_y [N], force_z [N]
        support_x.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        support_x.child (3,): x [m], y [m], z [m]
        support_y.parent (6,): x [m], y [m], z [m], axis_x [1], axis_y [1], axis_z [1]
        support_y.child to ball_5.centre (3,): x [m], y [m], z [m]
    """
    ball_diameter, pitch_diameter, clearance, load = p[6], p[7], p[8], p[10]
    sqrt_3 = ca.sqrt(3)
    half_sqrt_3 = sqrt_3/2
    minus_half_sqrt_3 = -sqrt_3/2
    x4 = ball_diameter/2
    half_pitch_diameter = pitch_diameter/2
    minus_half_ball_diameter = -ball_diameter/2
    minus_half_clearance = -clearance/2
    x8 = half_pitch_diameter + minus_half_ball_diameter + minus_half_clearance
    half_clearance = clearance/2
    x10 = x4 + half_pitch_diameter + half_clearance
    return (ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1, 0, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1/2, half_sqrt_3, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, -1/2, half_sqrt_3, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, -1, 0, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, -1/2, minus_half_sqrt_3, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1), ca.vertcat(0, 0, 0, 1/2, minus_half_sqrt_3, 0),
        ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(*[0]*5, 1), ca.vertcat(*[0]*5, 1),
        *[ca.vertcat(0, 0, 0, x4), ca.vertcat(0, 0, 0, x8), ca.vertcat(0, 0, 0, x4), ca.vertcat(0, 0, 0, x10)]*6, ca.vertcat(*[0]*5, 1),
        ca.vertcat(0, 0, 0), ca.vertcat(0, 0, 0, 0, -load, 0), ca.vertcat(0, 0, 0, 1, 0, 0), ca.vertcat(0, 0, 0),
        ca.vertcat(0, 0, 0, 0, 1, 0), *[ca.vertcat(0, 0, 0)]*9)
