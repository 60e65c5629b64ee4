"""Declaration, derivation and audit: from a scene to the text of a generated module."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the list of public names
    from hertzwerk.derive import laws as laws
    from hertzwerk.derive.algebra.functions import Where as Where
    from hertzwerk.derive.algebra.splines import Table as Table
    from hertzwerk.derive.audit.audit import Finding as Finding, InconsistentUnits as InconsistentUnits
    from hertzwerk.derive.contact.pairs.between_curves import (
        CurveOnCurve as CurveOnCurve,
        GearMesh as GearMesh,
        OutlineOnOutline as OutlineOnOutline,
    )
    from hertzwerk.derive.contact.pairs.box import BoxOnPlane as BoxOnPlane
    from hertzwerk.derive.contact.pairs.boxes import BoxOnBox as BoxOnBox
    from hertzwerk.derive.contact.pairs.corner import CornerOnFace as CornerOnFace
    from hertzwerk.derive.contact.pairs.curved import (
        CircleOnCurve as CircleOnCurve,
        FaceOnCurve as FaceOnCurve,
        PointOnCurve as PointOnCurve,
    )
    from hertzwerk.derive.contact.pairs.custom import CustomPair as CustomPair
    from hertzwerk.derive.contact.pairs.flat import (
        CylinderOnPlane as CylinderOnPlane,
        RimOnPlane as RimOnPlane,
        SphereOnPlane as SphereOnPlane,
    )
    from hertzwerk.derive.contact.pairs.every_pair import every_pair as every_pair
    from hertzwerk.derive.contact.pairs.round import (
        BallInSocket as BallInSocket,
        ParallelCylinders as ParallelCylinders,
        PinInBush as PinInBush,
        SphereOnSphere as SphereOnSphere,
    )
    from hertzwerk.derive.contact.pairs.solid import (
        SphereOnBox as SphereOnBox,
        SphereOnCylinder as SphereOnCylinder,
        SphereOnEdge as SphereOnEdge,
        SphereOnFace as SphereOnFace,
    )
    from hertzwerk.derive.contact.touch import Touch as Touch
    from hertzwerk.derive.declare.scales import Scales as Scales
    from hertzwerk.derive.declare.scene import Scene as Scene
    from hertzwerk.derive.declare.start import Start as Start
    from hertzwerk.derive.derivation import audit_scene as audit_scene, derive as derive, generate as generate
    from hertzwerk.derive.effects.contacts import Contact as Contact, Friction as Friction
    from hertzwerk.derive.effects.controllers import Relay as Relay, SpeedController as SpeedController
    from hertzwerk.derive.effects.couplings import Coupling as Coupling
    from hertzwerk.derive.effects.drives import (
        ConstantSpeed as ConstantSpeed,
        Drive as Drive,
        Harmonic as Harmonic,
        Ramp as Ramp,
    )
    from hertzwerk.derive.effects.effect import (
        Effect as Effect,
        Element as Element,
        Event as Event,
        JointEffect as JointEffect,
        PairEffect as PairEffect,
        State as State,
    )
    from hertzwerk.derive.effects.energy_ledger import EnergyLedger as EnergyLedger
    from hertzwerk.derive.effects.state_expression import (
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
    from hertzwerk.derive.effects.forces import (
        BodyTorque as BodyTorque,
        JointForce as JointForce,
        PointForce as PointForce,
        Potential as Potential,
    )
    from hertzwerk.derive.effects.gravity import Gravity as Gravity
    from hertzwerk.derive.effects.loads.joint_friction import JointFriction as JointFriction
    from hertzwerk.derive.effects.loads.ball_friction import BallFriction as BallFriction
    from hertzwerk.derive.effects.loads.belt import BeltOnDrum as BeltOnDrum
    from hertzwerk.derive.effects.loads.frames import (
        Bushing as Bushing,
        FramePotential as FramePotential,
        SphericalSpring as SphericalSpring,
    )
    from hertzwerk.derive.effects.loads.patch import PatchFriction as PatchFriction
    from hertzwerk.derive.effects.loads.resistances import (
        DrillingResistance as DrillingResistance,
        RollingResistance as RollingResistance,
    )
    from hertzwerk.derive.effects.lubrication import Lubrication as Lubrication
    from hertzwerk.derive.effects.motors import DCMotor as DCMotor
    from hertzwerk.derive.effects.nonholonomic import (
        KnifeEdge as KnifeEdge,
        RollingWithoutSlip as RollingWithoutSlip,
    )
    from hertzwerk.derive.effects.springs import (
        JointDamper as JointDamper,
        JointSpring as JointSpring,
        LineForce as LineForce,
        PointDamper as PointDamper,
        PointSpring as PointSpring,
    )
    from hertzwerk.derive.effects.tracking import CountedAngle as CountedAngle
    from hertzwerk.derive.exported.to_sympy import to_sympy as to_sympy
    from hertzwerk.derive.faults import Fault as Fault, InputError as InputError
    from hertzwerk.derive.files.audit_files import audit_catalogue as audit_catalogue, audit_path as audit_path
    from hertzwerk.derive.files.audit_text import audit_expression as audit_expression
    from hertzwerk.derive.files.lawfile import laws_from as laws_from
    from hertzwerk.derive.files.urdf import from_urdf as from_urdf
    from hertzwerk.derive.imported.from_sympy import from_sympy as from_sympy
    from hertzwerk.derive.laws import LAWS as LAWS
    from hertzwerk.derive.laws.law import (
        BoundLaw as BoundLaw,
        DampingLaw as DampingLaw,
        FilmLaw as FilmLaw,
        FrictionLaw as FrictionLaw,
        Quantity as Quantity,
        StiffnessLaw as StiffnessLaw,
    )
    from hertzwerk.derive.mechanism.bodies import (
        GROUND as GROUND,
        Body as Body,
        Direction as Direction,
        Material as Material,
        Point as Point,
        Slot as Slot,
        X as X,
        Y as Y,
        Z as Z,
    )
    from hertzwerk.derive.mechanism.curve import Curve as Curve, S as S, curve_through as curve_through
    from hertzwerk.derive.mechanism.joints.axial import (
        Cylindrical as Cylindrical,
        Prismatic as Prismatic,
        Revolute as Revolute,
    )
    from hertzwerk.derive.mechanism.joints.free import Free as Free
    from hertzwerk.derive.mechanism.joints.joint import Freedom as Freedom, Joint as Joint
    from hertzwerk.derive.mechanism.joints.planar import Planar as Planar
    from hertzwerk.derive.mechanism.joints.spherical import Spherical as Spherical
    from hertzwerk.derive.mechanism.joints.track import PointInTrack as PointInTrack
    from hertzwerk.derive.mechanism.joints.universal import Universal as Universal
    from hertzwerk.derive.mechanism.joints.weld import Weld as Weld
    from hertzwerk.derive.mechanism.mechanism import Mechanism as Mechanism
    from hertzwerk.derive.mechanism.outline import Arc as Arc, Line as Line, Outline as Outline
    from hertzwerk.derive.mechanism.pair import Pair as Pair
    from hertzwerk.derive.mechanism.parameter import Interval as Interval, Parameter as Parameter
    from hertzwerk.derive.mechanism.pose import APART as APART, ROTATION as ROTATION, TURN as TURN
    from hertzwerk.derive.mechanism.teeth import InvoluteTeeth as InvoluteTeeth
else:
    from hertzwerk.names import handed_on

    __all__, __getattr__, __dir__ = handed_on(__name__)
