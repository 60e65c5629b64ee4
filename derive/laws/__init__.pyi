"""Contact laws, for type checkers and editors. Written by `hertzwerk laws --stub`; do not edit."""

from typing import overload

from hertzwerk.derive.expressions.parameter import Scalar
from hertzwerk.derive.laws.catalogue import LAWS as LAWS
from hertzwerk.derive.laws.law import BoundLaw, DampingLaw, FilmLaw, FrictionLaw, PlasticLaw, StiffnessLaw
from hertzwerk.derive.laws.material import Material

class _StiffnessLaw_E_1_nu_1_E_2_nu_2(StiffnessLaw):
    @overload
    def __call__(self, first: Material, second: Material, /) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar) -> BoundLaw: ...

class _StiffnessLaw_K_n(StiffnessLaw):
    def __call__(self, K: Scalar, n: Scalar) -> BoundLaw: ...

class _StiffnessLaw_E_1_nu_1_E_2_nu_2_k_C(StiffnessLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, k: Scalar, C: Scalar) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, k: Scalar, C: Scalar) -> BoundLaw: ...

class _PlasticLaw_E_1_nu_1_E_2_nu_2_sigma_y_c_p(PlasticLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, sigma_y: Scalar = ..., c_p: Scalar = ...) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, sigma_y: Scalar, c_p: Scalar = ...) -> BoundLaw: ...

class _PlasticLaw_E_1_nu_1_E_2_nu_2_sigma_y(PlasticLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, sigma_y: Scalar = ...) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, sigma_y: Scalar) -> BoundLaw: ...

class _StiffnessLaw_E_1_nu_1_E_2_nu_2_c_b(StiffnessLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, c_b: Scalar = ...) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, c_b: Scalar = ...) -> BoundLaw: ...

class _StiffnessLaw(StiffnessLaw):
    def __call__(self) -> BoundLaw: ...

class _StiffnessLaw_l_ref_F_ref(StiffnessLaw):
    def __call__(self, l_ref: Scalar = ..., F_ref: Scalar = ...) -> BoundLaw: ...

class _StiffnessLaw_E_1_nu_1_E_2_nu_2_l_ref_p_ref(StiffnessLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, l_ref: Scalar = ..., p_ref: Scalar = ...) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, l_ref: Scalar = ..., p_ref: Scalar = ...) -> BoundLaw: ...

class _StiffnessLaw_E_1_nu_1_E_2_nu_2_n(StiffnessLaw):
    @overload
    def __call__(self, first: Material, second: Material, /, n: Scalar) -> BoundLaw: ...
    @overload
    def __call__(self, E_1: Scalar, nu_1: Scalar, E_2: Scalar, nu_2: Scalar, n: Scalar) -> BoundLaw: ...

class _DampingLaw_e(DampingLaw):
    def __call__(self, e: Scalar) -> BoundLaw: ...

class _DampingLaw_chi_m(DampingLaw):
    def __call__(self, chi: Scalar, m: Scalar) -> BoundLaw: ...

class _DampingLaw_gamma(DampingLaw):
    def __call__(self, gamma: Scalar) -> BoundLaw: ...

class _DampingLaw_A(DampingLaw):
    def __call__(self, A: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_k_mu_s(FrictionLaw):
    def __call__(self, mu_k: Scalar, mu_s: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_v_s(FrictionLaw):
    def __call__(self, mu: Scalar, v_s: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_v_a_v_b(FrictionLaw):
    def __call__(self, mu: Scalar, v_a: Scalar, v_b: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_v_r(FrictionLaw):
    def __call__(self, mu: Scalar, v_r: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_k_mu_s_v_S_v_s_c_v(FrictionLaw):
    def __call__(self, mu_k: Scalar, mu_s: Scalar, v_S: Scalar, v_s: Scalar, c_v: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_k_mu_s_v_S_c_v_N_t(FrictionLaw):
    def __call__(self, mu_k: Scalar, mu_s: Scalar, v_S: Scalar, c_v: Scalar, N_t: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_k_mu_s_v_S_xi(FrictionLaw):
    def __call__(self, mu_k: Scalar, mu_s: Scalar, v_S: Scalar, xi: Scalar) -> BoundLaw: ...

class _FrictionLaw_mu_k_mu_s_v_S_s_0_s_1_c_v(FrictionLaw):
    def __call__(self, mu_k: Scalar, mu_s: Scalar, v_S: Scalar, s_0: Scalar, s_1: Scalar, c_v: Scalar) -> BoundLaw: ...

class _FilmLaw_eta(FilmLaw):
    def __call__(self, eta: Scalar) -> BoundLaw: ...

ambrosio: _FrictionLaw_mu_v_a_v_b
"""ambrosio(mu, v_a, v_b): Ambrosio, Coulomb friction with a dead zone and a ramp (friction law, grade B).

mu [1]: coefficient of friction
v_a [m/s]: speed up to which there is no friction
v_b [m/s]: speed from which there is all of it
Source: Ambrosio, Impact of rigid and flexible multibody systems, in: Virtual Nonlinear Multibody Systems (2003)
Kinks at v_a and v_b; without friction below v_a, so nothing stays at rest.
"""
bai_zhao: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""bai_zhao(E_1, nu_1, E_2, nu_2): Bai and Zhao, hybrid law of a revolute joint with clearance, n = 3/2 (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Bai, Zhao, Int. J. Non-Linear Mech. 48 (2013) 15
The stiffness is the derivative of Liu's force per length, so Pa. Its own damping is zhiying_qishao.
"""
bai_zhao_repaired: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""bai_zhao_repaired(E_1, nu_1, E_2, nu_2): Bai and Zhao, hybrid law of a revolute joint with clearance, with a length and n = 1 (stiffness
law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Bai, Zhao, Int. J. Non-Linear Mech. 48 (2013) 15
Units hold, yet a tangent stiffness is used as a secant: 1.5 times too stiff at small d. liu_with_length is the law itself.
"""
bengisu_akay: _FrictionLaw_mu_k_mu_s_v_S_xi
"""bengisu_akay(mu_k, mu_s, v_S, xi): Bengisu and Akay, parabolic rise and exponential fall (friction law, grade C).

mu_k [1]: coefficient of kinetic friction
mu_s [1]: coefficient of static friction
v_S [m/s]: Stribeck speed
xi [s/m]: decay of static friction with speed
Source: Bengisu, Akay, J. Sound Vib. 171 (1994) 557
"""
brenner: _FilmLaw_eta
"""brenner(eta): Drag of a sphere that nears a plane, at any distance (Brenner) (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: Brenner, Chem. Eng. Sci. 16 (1961) 242: a series; fit of ours between its limits, which Cox and Brenner (1967) give
Within 8e-4 of the series at every distance. Reynolds' film where h is small, R/h + ln(R/h)/5 + 0.971264; Stokes' drag where it is large.
"""
brown_mcphee: _FrictionLaw_mu_k_mu_s_v_S_c_v_N_t
"""brown_mcphee(mu_k, mu_s, v_S, c_v, N_t): Brown and McPhee, Stribeck friction in one smooth expression (friction law, grade B).

mu_k [1]: coefficient of kinetic friction
mu_s [1]: coefficient of static friction
v_S [m/s]: Stribeck speed
c_v [N s/m]: viscous coefficient
N_t [N]: normal force over which viscous friction builds up
Source: Brown, McPhee, J. Comput. Nonlinear Dyn. 11 (2016) 054502
"""
carvalho_martins: _DampingLaw_e
"""carvalho_martins(e): Carvalho and Martins (damping law, grade A).

e [1]: coefficient of restitution
Source: Carvalho, Martins, Mech. Mach. Theory 139 (2019) 174
At e = 0 the factor is 33/2: large, not infinite.
"""
coulomb: _FrictionLaw_mu_k_mu_s
"""coulomb(mu_k, mu_s): Coulomb friction, set-valued (friction law, grade A).

mu_k [1]: coefficient of kinetic friction
mu_s [1]: coefficient of static friction
Source: Coulomb 1785
At rest any force up to mu_s N, so that s = 0 holds: stick and slip are modes, and their changes events.
"""
dubowsky_freudenstein: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""dubowsky_freudenstein(E_1, nu_1, E_2, nu_2): Dubowsky and Freudenstein, pin in bush (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Dubowsky, Freudenstein, J. Eng. Ind. 93 (1971) 305; Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
"""
esdu_78035: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""esdu_78035(E_1, nu_1, E_2, nu_2): ESDU 78035, line contact of cylinders (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: ESDU 78035, Contact phenomena I (1978); Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
"""
exact: _DampingLaw_e
"""exact(e): Exact factor: restitution out equals restitution in (damping law, grade A).

e [1]: coefficient of restitution
Source: root of h (1 + e) = ln((1 + h)/(1 - h e)), the relation of F (1 + h v/v0): Hunt, Crossley, J. Appl. Mech. 42 (1975) 440
coth t - 1/t = (1 - e)/(1 + e), h = 2 t/(1 + e): computed once, from the restitution alone.
"""
flores: _DampingLaw_e
"""flores(e): Flores, Machado, Silva and Martins (damping law, grade A).

e [1]: coefficient of restitution
Source: Flores, Machado, Silva, Martins, Multibody Syst. Dyn. 25 (2011) 357, eq. 18; Ye, Li, Zheng, Earthq. Eng. Struct. Dyn. 38 (2009) 1135
"""
galin_sneddon: _StiffnessLaw_E_1_nu_1_E_2_nu_2_k_C
"""galin_sneddon(E_1, nu_1, E_2, nu_2, k, C): Galin and Sneddon, point contact of a rigid axisymmetric profile z = C r^k (stiffness law, grade
A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
k [1]: exponent of the profile C r^k
C [m^(1-k)]: coefficient of the profile C r^k
Source: Sneddon, Int. J. Eng. Sci. 3 (1965) 47
A legitimate n other than 3/2: n = 1 + 1/k, the stiffness following from the profile. k = 2, C = 1/(2 R) is Hertz's law.
"""
gharib_hurmuzlu: _DampingLaw_e
"""gharib_hurmuzlu(e): Gharib and Hurmuzlu (damping law, grade A).

e [1]: coefficient of restitution
Source: Gharib, Hurmuzlu, J. Appl. Mech. 79 (2012) 064506
For small e (the bound 0.2 is where it is 2 % from the exact factor). e = 1 does not give the elastic law.
"""
goldsmith: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""goldsmith(E_1, nu_1, E_2, nu_2): Goldsmith, line contact of cylinders, m = 1 as quoted (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Goldsmith, Impact (1960); Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
"""
goldsmith_m3: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""goldsmith_m3(E_1, nu_1, E_2, nu_2): Goldsmith, line contact of cylinders, repaired with m = 3 (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Goldsmith, Impact (1960); Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
Then it is the law of Dubowsky and Freudenstein, since 1/R = dR/(R1 R2).
"""
gonthier: _DampingLaw_e
"""gonthier(e): Gonthier, McPhee, Lange and Piedboeuf (damping law, grade B).

e [1]: coefficient of restitution
Source: Gonthier, McPhee, Lange, Piedboeuf, Multibody Syst. Dyn. 11 (2004) 209
"""
herbert_mcwhannell: _DampingLaw_e
"""herbert_mcwhannell(e): Herbert and McWhannell (damping law, grade B).

e [1]: coefficient of restitution
Source: Herbert, McWhannell, J. Eng. Ind. 99 (1977) 513
"""
hertz_cylinder: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""hertz_cylinder(E_1, nu_1, E_2, nu_2): Law quoted as Hertz's for cylinders (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: quoted in Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
Hertz's theory of line contact leaves the approach open; this is a law of the literature under his name. It is about twice as compliant as
johnson: with E/(1 - nu^2) of one material for E* the same formula is near it.
"""
hertz_half_width: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""hertz_half_width(E_1, nu_1, E_2, nu_2): Hertz's half-width with the geometry of the chord (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: a^2 = 4 F R/(pi E* L) (Hertz) with a^2 = 2 R d, the chord at depth d
"""
hertz_point: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""hertz_point(E_1, nu_1, E_2, nu_2): Hertz, point contact of two spheres, a sphere and a plane, or a ball in a socket (stiffness law, grade
A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Hertz 1882; Johnson, Contact Mechanics (1985), section 4.2
"""
hu_guo: _DampingLaw_e
"""hu_guo(e): Hu and Guo (damping law, grade A).

e [1]: coefficient of restitution
Source: Hu, Guo, Multibody Syst. Dyn. 35 (2015) 131
Often quoted with half the factor.
"""
hunt_crossley: _DampingLaw_e
"""hunt_crossley(e): Hunt and Crossley (damping law, grade A).

e [1]: coefficient of restitution
Source: Hunt, Crossley, J. Appl. Mech. 42 (1975) 440
Never returns less than e = 0.4877. Often quoted with the 1/e of hu_guo.
"""
jackson_green: _PlasticLaw_E_1_nu_1_E_2_nu_2_sigma_y
"""jackson_green(E_1, nu_1, E_2, nu_2, sigma_y): Jackson and Green, elastic-plastic sphere against a rigid flat, with the residual depth of
Jackson, Chusoipin and Green (stiffness law, grade C).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
sigma_y [Pa]: yield strength in simple tension of the body that yields
Source: Jackson, Green, J. Tribol. 127 (2005) 343; unloading: Jackson, Chusoipin, Green, J. Tribol. 127 (2005) 484, and Jackson, Green,
Marghitu, Nonlinear Dyn. 60 (2010) 217
The first body yields. Fits of finite elements up to a contact radius of 0.41 R; the hardness falls as the contact grows.
"""
jankowski: _DampingLaw_e
"""jankowski(e): Jankowski, damped while approaching only (damping law, grade A).

e [1]: coefficient of restitution
Source: Jankowski, Earthq. Eng. Struct. Dyn. 34 (2005) 595; 35 (2006) 517
Published for K d^1.5, where sqrt(F/d) is sqrt(K) d^(1/4).
"""
johnson: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""johnson(E_1, nu_1, E_2, nu_2): Johnson, line contact of cylinders (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Johnson, Contact Mechanics (1985); Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
Explicit: F = (A/e) exp(W_-1(-e d/(4 dR))), A = 4 pi E* L dR, up to d = (4/e^2) dR = 0.5413 dR.
"""
kelvin_voigt: _DampingLaw_e
"""kelvin_voigt(e): Kelvin and Voigt, in the form of Anagnostopoulos (damping law, grade A).

e [1]: coefficient of restitution
Source: Anagnostopoulos, Earthq. Eng. Struct. Dyn. 16 (1988) 443
Published for K d, where the secant F/d is K: exact e when the contact ends at d = 0. Jumps at the onset, pulls before release.
"""
kogut_etsion: _PlasticLaw_E_1_nu_1_E_2_nu_2_sigma_y
"""kogut_etsion(E_1, nu_1, E_2, nu_2, sigma_y): Kogut and Etsion, elastic-plastic sphere against a rigid flat, with the unloading of Etsion,
Kligerman and Kadin (stiffness law, grade C).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
sigma_y [Pa]: yield strength in simple tension of the body that yields
Source: Kogut, Etsion, J. Appl. Mech. 69 (2002) 657; unloading: Etsion, Kligerman, Kadin, Int. J. Solids Struct. 42 (2005) 3716
The first body yields; its hardness is 2.8 sigma_y. Fits of finite elements up to 110 depths of first yield. Up to 1.1 of them they return
up to 0.05 % more energy than was spent.
"""
kuwabara_kono: _DampingLaw_A
"""kuwabara_kono(A): Kuwabara and Kono (damping law, grade A).

A [s]: material time of the viscous stress
Source: Kuwabara, Kono, Jpn. J. Appl. Phys. 26 (1987) 1230
Published for K d^1.5, where A k_t v is (3/2) A K d^(1/2) v: e = 1 - 1.15345 (3/2) A (K/m_eff)^(2/5) v0^(1/5) + ...
"""
lankarani_nikravesh: _DampingLaw_e
"""lankarani_nikravesh(e): Lankarani and Nikravesh (damping law, grade A).

e [1]: coefficient of restitution
Source: Lankarani, Nikravesh, J. Mech. Des. 112 (1990) 369
For v0 up to 1e-5 sqrt(E/rho). Never returns less than e = 0.6630.
"""
lankarani_nikravesh_cylinders: _StiffnessLaw_E_1_nu_1_E_2_nu_2_n
"""lankarani_nikravesh_cylinders(E_1, nu_1, E_2, nu_2, n): Lankarani-Nikravesh law for cylinders (1994) (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
n [1]: exponent
Source: Lankarani, Nikravesh, Nonlinear Dyn. 5 (1994) 193; used with n in 1..1.5 and no length
Consistent only with n = 3/2, where it is Hertz's point contact; a line contact needs a length.
"""
lee_wang: _DampingLaw_e
"""lee_wang(e): Lee and Wang (damping law, grade B).

e [1]: coefficient of restitution
Source: Lee, Wang, J. Mech. Transm. Autom. Des. 105 (1983) 534
"""
liu: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""liu(E_1, nu_1, E_2, nu_2): Liu, Zhang and Yang, cylindrical joint, as printed (without a length) (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Liu, Zhang, Yang, Mech. Mach. Theory 42 (2007) 183
"""
liu_with_length: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""liu_with_length(E_1, nu_1, E_2, nu_2): Liu, Zhang and Yang, cylindrical joint, with its length (stiffness law, grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Liu, Zhang, Yang, Mech. Mach. Theory 42 (2007) 183
"""
long_bearing: _FilmLaw_eta
"""long_bearing(eta): Long bearing (Sommerfeld), half film, wedge and squeeze (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: Pinkus, Sternlicht, Theory of Hydrodynamic Lubrication (1961); Flores, Lankarani, Ambrosio, Claro, Proc. IMechE K 218 (2004) 183
No flow to the ends: for L of four radii and more. Wedge alone is as in the sources. Where wedge and squeeze act together those fit a factor
(k + 3)/(k + 3/2); here the edges of the half are found instead, where the pressure is the same. The couple is of the whole circumference.
"""
long_bearing_full: _FilmLaw_eta
"""long_bearing_full(eta): Long bearing (Sommerfeld), full film, which pulls where it opens (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: Sommerfeld 1904; Pinkus, Sternlicht, Theory of Hydrodynamic Lubrication (1961)
For a film under a pressure around it that keeps it from cavitation. It is also the limit of Reynolds' condition where oil is supplied at
the ends alone: the pressure is raised until the least is that around, slowly: the force is 12 % lower for 32 radii, 6 % for 64.
"""
lugre: _FrictionLaw_mu_k_mu_s_v_S_s_0_s_1_c_v
"""lugre(mu_k, mu_s, v_S, s_0, s_1, c_v): LuGre bristle friction for varying load (friction law, grade B).

mu_k [1]: coefficient of kinetic friction
mu_s [1]: coefficient of static friction
v_S [m/s]: Stribeck speed
s_0 [1/m]: bristle stiffness per normal force
s_1 [s/m]: bristle damping per normal force
c_v [N s/m]: viscous coefficient
Source: Canudas de Wit, Olsson, Astrom, Lischinsky, IEEE Trans. Autom. Control 40 (1995) 419, the load as a factor
The bristle z is forgotten when the contact ends. The form with constant friction forces is wrong under impact and not offered.
"""
palmgren: _StiffnessLaw
"""palmgren(): Palmgren, steel roller on a raceway, as published (stiffness law, grade C).

Source: Palmgren, Ball and Roller Bearing Engineering (1959)
"""
palmgren_si: _StiffnessLaw_l_ref_F_ref
"""palmgren_si(l_ref, F_ref): Palmgren, steel roller on a raceway, with its reference length and force named (stiffness law, grade C).

l_ref [m]: reference length of the fit, 1 mm
F_ref [N]: reference force of the fit, 1 N
Source: Palmgren, Ball and Roller Bearing Engineering (1959)
For steel only: the modulus is in the constant.
"""
pereira_external: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""pereira_external(E_1, nu_1, E_2, nu_2): Pereira, Ramalho and Ambrosio, cylinders side by side, as published (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681, fitted to Johnson's law
"""
pereira_external_si: _StiffnessLaw_E_1_nu_1_E_2_nu_2_l_ref_p_ref
"""pereira_external_si(E_1, nu_1, E_2, nu_2, l_ref, p_ref): Pereira, Ramalho and Ambrosio, cylinders side by side, with its reference length
and pressure named (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
l_ref [m]: reference length of the fit, 1 mm
p_ref [Pa]: reference pressure of the fit, 1 MPa
Source: Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681, fitted to Johnson's law
"""
pereira_internal: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""pereira_internal(E_1, nu_1, E_2, nu_2): Pereira, Ramalho and Ambrosio, pin in bush, as published (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681, fitted to Johnson's law
"""
pereira_internal_si: _StiffnessLaw_E_1_nu_1_E_2_nu_2_l_ref_p_ref
"""pereira_internal_si(E_1, nu_1, E_2, nu_2, l_ref, p_ref): Pereira, Ramalho and Ambrosio, pin in bush, with its reference length and pressure
named (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
l_ref [m]: reference length of the fit, 1 mm
p_ref [Pa]: reference pressure of the fit, 1 MPa
Source: Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681, fitted to Johnson's law
"""
persson: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""persson(E_1, nu_1, E_2, nu_2): Persson, conforming contact of pin and bush (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Persson, On the stress distribution of cylindrical elastic bodies in contact, Chalmers (1964)
b = tan(eps/2), cos eps = dR/(dR + d). The denominator vanishes at b^2 = 0.835, d = 10.1 dR; the reach is b^2 = 0.8.
"""
popov_line: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""popov_line(E_1, nu_1, E_2, nu_2): Popov, line contact of a cylinder (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: Popov, Contact Mechanics and Friction (2010), chapter 5
"""
power: _StiffnessLaw_K_n
"""power(K, n): Power law, stiffness and exponent given (stiffness law, grade A).

K [N/m^n]: stiffness
n [1]: exponent
Source: Hertz's law with the exponent left open; K carries the unit N/m^n
"""
power_damping: _DampingLaw_chi_m
"""power_damping(chi, m): Power damping, coefficient and exponent given: beside K d^n the general law K d^n + chi d^m v (damping law, grade A).

chi [N s/m^(m+1)]: coefficient of the damping
m [1]: exponent of the penetration
Source: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986, section 2: the form that the laws of its survey share
chi carries the unit N s/m^(m+1). With m = n and chi = h K/v0 a hysteresis law of one approach speed; m = 0 jumps at the onset.
"""
radzimovsky: _StiffnessLaw_E_1_nu_1_E_2_nu_2_c_b
"""radzimovsky(E_1, nu_1, E_2, nu_2, c_b): Radzimovsky, two cylinders pressed together (stiffness law, grade B).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
c_b [1]: whole width of the contact, b/sqrt(F R/(L E*))
Source: Radzimovsky, Univ. Illinois Eng. Exp. Station Bulletin 408 (1953); Pereira, Ramalho, Ambrosio, Nonlinear Dyn. 63 (2011) 681
b is the whole width of the contact, c_b = 4/sqrt(pi) = 2.257; Roark's 1.60 sqrt(p K_D C_E) is the same, of diameters. In circulation are
Hertz's half-width, 1.128, and 1.6 of radii: the force at 1 um is 15 and 8 % lower. The law is the compression of both cylinders to their
centres under a parabola of pressure over b; johnson takes Hertz's ellipse.
"""
ristow: _DampingLaw_gamma
"""ristow(gamma): Ristow; Lee and Herrmann (damping law, grade B).

gamma [1/s]: damping rate
Source: Ristow, J. Phys. I France 2 (1992) 649; Lee, Herrmann, J. Phys. A 26 (1993) 373
Published beside K d^1.5. The force jumps at the onset; the contact ends where it would pull.
"""
safaeifar_farshidianfar: _DampingLaw_e
"""safaeifar_farshidianfar(e): Safaeifar and Farshidianfar (damping law, grade C).

e [1]: coefficient of restitution
Source: Safaeifar, Farshidianfar, Multibody Syst. Dyn. 50 (2020) 233
"""
short_bearing: _FilmLaw_eta
"""short_bearing(eta): Short bearing (Ocvirk), half film, wedge and squeeze (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: DuBois, Ocvirk, NACA Report 1157 (1953); Booker, J. Basic Eng. 87 (1965) 537; Frene et al., Hydrodynamic Lubrication (1997)
Pressure falls parabolically to both ends: for L up to about the radius; by Gümbel's condition as by Reynolds'. The couple is of the whole
circumference. In double precision the drag is exact to 5e-14 at eps = 0.9; while the film opens, where there is little of it, to 2e-11 at
0.99 and 6e-9 at 0.999.
"""
short_bearing_full: _FilmLaw_eta
"""short_bearing_full(eta): Short bearing (Ocvirk), full film, which pulls where it opens (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: Frene et al., Hydrodynamic Lubrication (1997): both halves of the film of DuBois and Ocvirk (1953)
For a film under a pressure around it that keeps it from cavitation.
"""
smooth_coulomb: _FrictionLaw_mu_v_s
"""smooth_coulomb(mu, v_s): Coulomb friction, smoothed by tanh; creeps at v_s atanh(tan(theta)/mu) on an incline (friction law, grade A).

mu [1]: coefficient of friction
v_s [m/s]: speed over which the friction force builds up
Source: Andersson, Soderberg, Bjorklund, Tribology Int. 40 (2007) 580
"""
sphere_film: _FilmLaw_eta
"""sphere_film(eta): Squeeze film of two spheres, or of a sphere and a plane (Reynolds) (film law, grade A).

eta [Pa s]: dynamic viscosity
Source: Reynolds' equation of two paraboloids: Cameron, Basic Lubrication Theory (1976); Cox, Brenner, Chem. Eng. Sci. 22 (1967) 1753
Exact as h goes to 0. Before a plane it is 2 % too low at h = R/100, 13 % at R/10, where `brenner` is not.
"""
stribeck: _FrictionLaw_mu_k_mu_s_v_S_v_s_c_v
"""stribeck(mu_k, mu_s, v_S, v_s, c_v): Stribeck curve with viscous friction, smoothed by tanh (friction law, grade B).

mu_k [1]: coefficient of kinetic friction
mu_s [1]: coefficient of static friction
v_S [m/s]: Stribeck speed
v_s [m/s]: speed over which the friction force builds up
c_v [N s/m]: viscous coefficient
Source: Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30 (1994) 1083
"""
thornton: _PlasticLaw_E_1_nu_1_E_2_nu_2_sigma_y_c_p
"""thornton(E_1, nu_1, E_2, nu_2, sigma_y, c_p): Thornton, elastic-perfectly plastic spheres: Hertz's pressure cut off at p_y (stiffness law,
grade A).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
sigma_y [Pa]: yield strength in simple tension of the body that yields
c_p [1]: pressure that limits the contact over the yield strength
Source: Thornton, J. Appl. Mech. 64 (1997) 383
p_y = 1.6 sigma_y is first yield by Johnson; a contact that has yielded fully bears 2.5 to 3 sigma_y, which suits impacts far above first
yield better. Unloading is Hertz's with the contact radius that is left: (d_m - dent)/d_m = F(d_m)/(K d_m^1.5).
"""
threlfall: _FrictionLaw_mu_v_r
"""threlfall(mu, v_r): Threlfall, exponential rise up to a transition speed (friction law, grade B).

mu [1]: coefficient of friction
v_r [m/s]: speed over which the friction force builds up
Source: Threlfall, Mech. Mach. Theory 13 (1978) 475
Beyond v_r the published 0.95 is taken as 1 - exp(-3) = 0.9502, which leaves a kink and no jump.
"""
tsuji: _DampingLaw_e
"""tsuji(e): Tsuji, Tanaka and Ishida (damping law, grade A).

e [1]: coefficient of restitution
Source: Tsuji, Tanaka, Ishida, Powder Technol. 71 (1992) 239
Published for K d^1.5, where sqrt(F/d) is sqrt(K) d^(1/4): exact e when the contact ends at d = 0. Pulls before release.
"""
wang_liu_external: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""wang_liu_external(E_1, nu_1, E_2, nu_2): Wang and Liu, external contact of cylinders (reconstruction) (stiffness law, grade R).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986
K = (pi/4) E* L, the same force as popov_line: 2.6 to 3.8 times Johnson's at penetrations of micrometres.
"""
wang_liu_half_width: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""wang_liu_half_width(E_1, nu_1, E_2, nu_2): Wang and Liu, external or internal contact, K = (pi/2) E* L (reconstruction, further candidate)
(stiffness law, grade R).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986
The same force as hertz_half_width; inside it is that of wang_liu_internal.
"""
wang_liu_internal: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""wang_liu_internal(E_1, nu_1, E_2, nu_2): Wang and Liu, internal contact of cylinders (reconstruction) (stiffness law, grade R).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986
K = (pi/2) E* L, n = 1 as the paper says: the slope of Persson's law of pin and bush at the onset, the same force as hertz_half_width.
"""
wang_liu_johnson: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""wang_liu_johnson(E_1, nu_1, E_2, nu_2): Wang and Liu, external or internal contact, the secant of Johnson's law (reconstruction, further
candidate) (stiffness law, grade R).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986
K(d) = F(d)/d of Johnson's law, so the same force.
"""
wang_liu_secant: _StiffnessLaw_E_1_nu_1_E_2_nu_2
"""wang_liu_secant(E_1, nu_1, E_2, nu_2): Wang and Liu, internal contact, the secant of Liu's law (reconstruction, further candidate)
(stiffness law, grade R).

E_1 [Pa]: Young's modulus of the first body
nu_1 [1]: Poisson's ratio of the first body
E_2 [Pa]: Young's modulus of the second body
nu_2 [1]: Poisson's ratio of the second body
Source: reconstruction of: Wang, Liu, Mech. Mach. Theory 153 (2020) 103986
K(d) = (pi/2) E* L sqrt(d/(2 (dR + d))), the same force as liu_with_length. Written as K(d) d it has n = 1; its local exponent is 1.5 at
small d, so it is not the default.
"""
zhiying_qishao: _DampingLaw_e
"""zhiying_qishao(e): Qin Zhiying and Lu Qishao (damping law, grade A).

e [1]: coefficient of restitution
Source: Qin, Lu, J. Dyn. Control 4 (2006) 294
"""
