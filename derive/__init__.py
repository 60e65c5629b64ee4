"""Declaration, derivation and audit: from a scene to the text of a generated module."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the list of public names
    from hertzwerk.derive import laws as laws
    from hertzwerk.derive.expressions.algebra.functions import Where as Where
    from hertzwerk.derive.expressions.algebra.splines import Table as Table
    from hertzwerk.derive.audit.audit import Finding as Finding, InconsistentUnits as InconsistentUnits
    from hertzwerk.derive.equations.contact.pairs.curves_and_gears import (
        CurveOnCurve as CurveOnCurve,
        GearMesh as GearMesh,
        OutlineOnOutline as OutlineOnOutline,
    )
    from hertzwerk.derive.equations.contact.pairs.box_on_plane import BoxOnPlane as BoxOnPlane
    from hertzwerk.derive.equations.contact.pairs.box_on_box import BoxOnBox as BoxOnBox
    from hertzwerk.derive.equations.contact.pairs.corner_on_face import CornerOnFace as CornerOnFace
    from hertzwerk.derive.equations.contact.pairs.on_curve import (
        CircleOnCurve as CircleOnCurve,
        FaceOnCurve as FaceOnCurve,
        PointOnCurve as PointOnCurve,
    )
    from hertzwerk.derive.equations.contact.pairs.custom_pair import CustomPair as CustomPair
    from hertzwerk.derive.equations.contact.pairs.on_plane import (
        CylinderOnPlane as CylinderOnPlane,
        RimOnPlane as RimOnPlane,
        SphereOnPlane as SphereOnPlane,
    )
    from hertzwerk.derive.equations.contact.pairs.every_pair import every_pair as every_pair
    from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import (
        BallInSocket as BallInSocket,
        ParallelCylinders as ParallelCylinders,
        PinInBush as PinInBush,
        SphereOnSphere as SphereOnSphere,
    )
    from hertzwerk.derive.equations.contact.pairs.sphere_on_solid import (
        SphereOnBox as SphereOnBox,
        SphereOnCylinder as SphereOnCylinder,
        SphereOnEdge as SphereOnEdge,
        SphereOnFace as SphereOnFace,
    )
    from hertzwerk.derive.equations.contact.touch import Touch as Touch
    from hertzwerk.derive.declare.scene.scales import Scales as Scales
    from hertzwerk.derive.declare.scene.scene import Scene as Scene
    from hertzwerk.derive.declare.scene.start import Start as Start
    from hertzwerk.derive.equations.derivation import audit_scene as audit_scene, derive as derive, generate as generate
    from hertzwerk.derive.declare.effects.contacts import Contact as Contact, Friction as Friction
    from hertzwerk.derive.declare.effects.controllers import Relay as Relay, SpeedController as SpeedController
    from hertzwerk.derive.declare.effects.couplings import Coupling as Coupling
    from hertzwerk.derive.declare.effects.drives import (
        ConstantSpeed as ConstantSpeed,
        Drive as Drive,
        Harmonic as Harmonic,
        Ramp as Ramp,
    )
    from hertzwerk.derive.declare.effects.effect import (
        Effect as Effect,
        Element as Element,
        Event as Event,
        JointEffect as JointEffect,
        PairEffect as PairEffect,
        State as State,
    )
    from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger as EnergyLedger
    from hertzwerk.derive.declare.effects.state_expression import (
        LENGTH as LENGTH,
        LENGTH_RATE as LENGTH_RATE,
        Input as Input,
        T as T,
        Varying as Varying,
        coordinate_of as coordinate_of,
        normal_force_of as normal_force_of,
        reaction_of as reaction_of,
        speed_of as speed_of,
        state_of as state_of,
    )
    from hertzwerk.derive.declare.effects.forces import (
        BodyTorque as BodyTorque,
        JointForce as JointForce,
        PointForce as PointForce,
        Potential as Potential,
    )
    from hertzwerk.derive.declare.effects.gravity import Gravity as Gravity
    from hertzwerk.derive.declare.effects.tribology.joint_friction import JointFriction as JointFriction
    from hertzwerk.derive.declare.effects.tribology.ball_friction import BallFriction as BallFriction
    from hertzwerk.derive.declare.effects.tribology.belt import BeltOnDrum as BeltOnDrum
    from hertzwerk.derive.declare.effects.bushings import (
        Bushing as Bushing,
        FramePotential as FramePotential,
        SphericalSpring as SphericalSpring,
    )
    from hertzwerk.derive.declare.effects.tribology.patch_friction import PatchFriction as PatchFriction
    from hertzwerk.derive.declare.effects.tribology.rolling_resistance import (
        DrillingResistance as DrillingResistance,
        RollingResistance as RollingResistance,
    )
    from hertzwerk.derive.declare.effects.tribology.lubrication import Lubrication as Lubrication
    from hertzwerk.derive.declare.effects.tribology.wear import Wear as Wear
    from hertzwerk.derive.declare.effects.motors import DCMotor as DCMotor
    from hertzwerk.derive.declare.effects.nonholonomic import (
        KnifeEdge as KnifeEdge,
        RollingWithoutSlip as RollingWithoutSlip,
    )
    from hertzwerk.derive.declare.effects.springs import (
        JointDamper as JointDamper,
        JointSpring as JointSpring,
        LineForce as LineForce,
        PointDamper as PointDamper,
        PointSpring as PointSpring,
    )
    from hertzwerk.derive.declare.effects.tracking import CountedAngle as CountedAngle
    from hertzwerk.derive.exchange.sympy_models.to_sympy import to_sympy as to_sympy
    from hertzwerk.derive.common.faults import Fault as Fault, InputError as InputError
    from hertzwerk.derive.exchange.user_files.audit_files import (
        audit_catalogue as audit_catalogue,
        audit_path as audit_path,
    )
    from hertzwerk.derive.audit.audit_text import audit_expression as audit_expression
    from hertzwerk.derive.exchange.user_files.law_file import laws_from as laws_from
    from hertzwerk.derive.exchange.user_files.urdf import from_urdf as from_urdf
    from hertzwerk.derive.exchange.sympy_models.from_sympy import from_sympy as from_sympy
    from hertzwerk.derive.laws import LAWS as LAWS
    from hertzwerk.derive.laws.law import (
        BoundLaw as BoundLaw,
        DampingLaw as DampingLaw,
        FilmLaw as FilmLaw,
        FrictionLaw as FrictionLaw,
        Quantity as Quantity,
        StiffnessLaw as StiffnessLaw,
    )
    from hertzwerk.derive.declare.mechanism.bodies import (
        GROUND as GROUND,
        Body as Body,
        Direction as Direction,
        Point as Point,
        X as X,
        Y as Y,
        Z as Z,
    )
    from hertzwerk.derive.laws.material import Material as Material
    from hertzwerk.derive.expressions.parameter import Slot as Slot
    from hertzwerk.derive.declare.mechanism.curve import Curve as Curve, S as S, curve_through as curve_through
    from hertzwerk.derive.declare.mechanism.joints.axial import (
        Cylindrical as Cylindrical,
        Prismatic as Prismatic,
        Revolute as Revolute,
    )
    from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod as FlexibleRod
    from hertzwerk.derive.declare.mechanism.joints.free import Free as Free
    from hertzwerk.derive.declare.mechanism.joints.joint import Freedom as Freedom, Joint as Joint
    from hertzwerk.derive.declare.mechanism.joints.planar import Planar as Planar
    from hertzwerk.derive.declare.mechanism.joints.spherical import Spherical as Spherical
    from hertzwerk.derive.declare.mechanism.joints.track import PointInTrack as PointInTrack
    from hertzwerk.derive.declare.mechanism.joints.universal import Universal as Universal
    from hertzwerk.derive.declare.mechanism.joints.weld import Weld as Weld
    from hertzwerk.derive.declare.mechanism.mechanism import Mechanism as Mechanism
    from hertzwerk.derive.declare.mechanism.outline import Arc as Arc, Line as Line, Outline as Outline
    from hertzwerk.derive.declare.mechanism.pair import Pair as Pair
    from hertzwerk.derive.expressions.parameter import Interval as Interval, Parameter as Parameter
    from hertzwerk.derive.declare.mechanism.pose import APART as APART, ROTATION as ROTATION, TURN as TURN
    from hertzwerk.derive.declare.mechanism.teeth import InvoluteTeeth as InvoluteTeeth
else:
    from hertzwerk.names import handed_on

    __all__, __getattr__, __dir__ = handed_on(__name__)
