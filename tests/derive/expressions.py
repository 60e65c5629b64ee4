"""The table of expressions the audits are held to, from mechanics, tribology, heat and fluid texts; data alone.

Every expression is explicit (a derivative is of something written out), so that it can be evaluated at STATE too, for an audit without symbols.
"""

_UNITS = {
    "N/m^1.5": "K", "N/m^n": "Kn", "N s/m^(n+1)": "chi", "Pa": "E G p p0 tau H", "N": "F F_N F_t F_ref", "N/m": "q c sigma",
    "m": "d R R1 R2 dR L x y z b_w c_R h_f l_ref", "m/s": "v v0 v_s v_S U", "m/s^2": "a g", "s": "t t0 A", "kg": "m m1 m2 m_eff",
    "kg m^2": "J", "1/s": "omega wn", "N m": "M_t", "kg/m^3": "rho", "Pa s": "eta", "m^2/s": "alpha_t", "W/(m K)": "k_t",
    "J/(kg K)": "c_p", "W/(m^2 K)": "h_t", "K": "Th Th0 Th1", "1/Pa": "s_c beta_p", "1": "e mu mu_s mu_k eps nu a_P b_P n k xi",
    "rad": "phi theta", "N s/m": "c_v", "1/m": "s0 kappa", "s/m": "s1", "m^4": "I_a", "m^2": "Ar", "m^3/s": "Q", "1/K": "al",
    "W/(m^2 K^4)": "sb",
}  # fmt: skip
UNITS = {name: unit for unit, names in _UNITS.items() for name in names.split()}
"""Name -> unit."""

STATE = {
    "K": 2e9, "Kn": 3e9, "chi": 4e8, "E": 2e11, "G": 8e10, "p": 3e6, "p0": 2e6, "tau": 4e5, "H": 2e9, "F": 900.0, "F_N": 700.0,
    "F_t": 60.0, "F_ref": 1.0, "q": 2e4, "c": 5e5, "sigma": 0.07, "d": 3e-5, "R": 0.01, "R1": 0.012, "R2": 0.009, "dR": 5e-4, "L": 0.02,
    "x": 0.011, "y": 0.017, "z": 2e-5, "b_w": 0.004, "c_R": 6e-5, "h_f": 2e-5, "l_ref": 1e-3, "v": 0.3, "v0": 0.5, "v_s": 0.1,
    "v_S": 0.01, "U": 1.5, "a": 40.0, "g": 9.81, "t": 0.013, "t0": 0.05, "A": 1e-5, "m": 0.4, "m1": 0.3, "m2": 0.7, "m_eff": 0.2,
    "J": 2e-4, "omega": 30.0, "wn": 90.0, "M_t": 3.0, "rho": 900.0, "eta": 0.05, "alpha_t": 1e-5, "k_t": 40.0, "c_p": 470.0,
    "h_t": 25.0, "Th": 350.0, "Th0": 300.0, "Th1": 320.0, "s_c": 3e-12, "beta_p": 2e-8, "e": 0.8, "mu": 0.1, "mu_s": 0.15,
    "mu_k": 0.09, "eps": 0.4, "nu": 0.3, "a_P": 0.965, "b_P": 0.0965, "n": 1.5, "k": 2.0, "xi": 0.05, "phi": 0.4, "theta": 0.3,
    "c_v": 7.0, "s0": 1e5, "kappa": 40.0, "s1": 0.3, "I_a": 1e-9, "Ar": 4e-4, "Q": 1e-5, "al": 1e-5, "sb": 5.67e-8,
}  # fmt: skip
"""A state (SI) at which every consistent expression is a finite real number."""

# expression, its unit
CONSISTENT = [
    # contact: elastic laws
    ("K*d**1.5", "N"), ("K*d**(3/2)", "N"), ("Kn*d**n", "N"), ("Kn*d**(n + 1)/(n + 1)", "J"), ("((n + 1)*m_eff*v0**2/(2*Kn))**(1/(n + 1))", "m"),
    ("4/3*E*sqrt(R)", "N/m^1.5"), ("4/3*E*sqrt(R1*R2/(R1 + R2))*d**1.5", "N"), ("1/((1 - nu**2)/E + (1 - nu**2)/G)", "Pa"), ("pi/4*E*L*d", "N"),
    ("pi/2*E*L*d*sqrt(d/(2*(dR + d)))", "N"), ("2*E*(k/(k + 1))*d*d**(1/k)*R**(1 - 1/k)", "N"), ("q/(pi*E)*(log(4*pi*E*dR/q) - 1)", "m"),
    ("F*s_c/L*(log(L**3*dR/(F*R1*R2*s_c)) + 1)", "m"), ("F*s_c/L*(log(L**3/(F*R*s_c)) + 1)", "m"), ("F*s_c/L*(log(4*L*dR/(F*s_c)) + 1)", "m"),
    ("(a_P*dR/l_ref + b_P)*L*E/dR*d**1.1*l_ref**0.9", "N"), ("1.51*log(1000*dR/l_ref)**-0.151", "1"), ("sqrt(4*F*R/(pi*E*L))", "m"),
    ("log(x) - log(y)", "1"),  # log(x/y)
    ("log(E) - log(p)", "1"), ("F*log(x) - log(y)*F + F", "N"), ("2*log(d) - log(R) - log(L) + eps", "1"), ("v*(log(x*y) - 2*log(L)) + v", "m/s"),
    ("-d/(s_c/L*LambertW(-exp(1)*d/(40*R), -1))", "N"), ("LambertW(d/R)*R", "m"), ("d/(kappa*R*sqrt(pi)*gamma(1 + k/2)/gamma((1 + k)/2))", "m"),
    ("where(d > 0, K*d**1.5, 0)", "N"), ("where(0 < d < R, K*d**1.5, K*R**1.5)", "N"), ("diff(K*d**1.5, d)", "N/m"),
    ("integrate(Kn*x**n, x, 0, d)", "J"),
    # contact: damping
    ("Kn*d**n + chi*d**n*v", "N"), ("Kn*d**n*(1 + 3*(1 - e**2)/4*v/v0)", "N"), ("K*d**1.5*(1 + 8*(1 - e)/(5*e)*v/max(v0, v_s))", "N"),
    ("-sqrt(5)*log(e)/sqrt(pi**2 + log(e)**2)*sqrt(m_eff*K)*d**0.25*v", "N"), ("2*xi*sqrt(c*m_eff)*v + c*d", "N"), ("3/2*A*K*sqrt(d)*v", "N"),
    ("max(K*d**1.5 - c_v*v, 0)", "N"),
    # friction
    ("mu*F_N*tanh(v/v_s)", "N"), ("mu*F_N*sign(v)", "N"), ("F_N*(mu_k + (mu_s - mu_k)*exp(-(v/v_S)**2)) + c_v*v", "N"),
    ("F_N*(s0*z + s1*(v - s0*abs(v)*z/mu))", "N"), ("min(abs(F_t), mu*F_N)", "N"), ("where(abs(v) < v_S, mu_s, mu_k)*F_N", "N"),
    ("F_N*(mu_k*tanh(4*v/v_S) + (mu_s - mu_k)*(v/v_S)/(0.25*(v/v_S)**2 + 0.75)**2)", "N"), ("v_s*log((1 + tan(theta)/mu/4)/(1 + mu))", "m/s"),
    ("where(v > v_s or F_t > mu*F_N, mu_k, mu_s)", "1"), ("k*F_N*x/H", "m^3"),
    # mechanics
    ("m*v**2/2 + m*g*y + c*x**2/2", "J"), ("J*omega**2/2 + M_t*theta", "J"), ("m*v - m1*v0 + 0*x", "N s"), ("m1*m2/(m1 + m2)", "kg"),
    ("sqrt(c/m)", "1/s"), ("2*pi*sqrt(L/g)", "s"), ("x*cos(wn*t) + v/wn*sin(wn*t)", "m"), ("exp(-xi*wn*t)*x*cos(wn*t*sqrt(1 - xi**2))", "m"),
    ("R*cos(theta) + sqrt(L**2 - R**2*sin(theta)**2)", "m"), ("diff(R*cos(omega*t) + sqrt(L**2 - R**2*sin(omega*t)**2), t, 2)", "m/s^2"),
    ("diff(x*cos(omega*t), t)", "m/s"), ("diff(m*v**2/2, v)", "N s"), ("atan2(y, x)", "1"), ("acos((x**2 + y**2 - L**2)/(2*x*y))", "1"),
    ("asin(R*sin(theta)/L)", "1"), ("atan(x/y) + atan2(v, v0)", "1"), ("F*L**3/(3*E*I_a)", "m"), ("pi**2*E*I_a/L**2", "N"), ("F*exp(mu*phi)", "N"),
    ("m*a == F", "1"), ("F_t <= mu*F_N", "1"), ("L*cosh(x/L) - L", "m"), ("sqrt(m*g/c_v*v)*tanh(sinh(x/L))", "m/s"), ("m - m + m2", "kg"),
    ("x**2/x", "m"), ("d**1 + x", "m"), ("(x**n)**(1/n)", "m"), ("(x/y)**theta", "1"), ("e**(t/t0)", "1"), ("integrate(F*exp(-x/L), x, 0, inf)", "J"),
    ("integrate(m*g, y)", "J"),
    # matrices
    ("[x, y, 0]", "m"), ("[[c, 0], [0, c]] @ [x, y]", "N"), ("det([[x, y], [-y, x]])", "m^2"), ("inv([[c, -c/2], [-c/2, c]]) @ [F, F_t]", "m"),
    ("transpose([v, v0]) @ [[m, 0], [0, m2]] @ [v, v0]/2", "J"), ("[[cos(theta), -sin(theta)], [sin(theta), cos(theta)]] @ [x, y] + [dR, 0]", "m"),
    ("trace([[tau, p], [p, p0]])/3", "Pa"),
    # lubrication and fluids
    ("6*eta*U*L*(R/c_R)**2", "N"), ("diff(h_f**3/(12*eta)*diff(p0*sin(x/L), x), x)", "m/s"), ("eta*exp(beta_p*p)", "Pa s"), ("eta*U/h_f", "Pa"),
    ("2.69*(eta*U/(E*R))**0.67*(beta_p*E)**0.53*R", "m"), ("rho*U*L/eta", "1"), ("p + rho*U**2/2 + rho*g*z", "Pa"), ("8*eta*L*Q/(pi*R**4)", "Pa"),
    ("sigma*(1/R1 + 1/R2)", "Pa"), ("6*pi*eta*R*U", "N"), ("0.316/(rho*U*L/eta)**0.25", "1"), ("Ar*sqrt(2*abs(p - p0)/rho)*sign(p - p0)", "m^3/s"),
    ("integrate(p0*sin(pi*x/L)*b_w, x, 0, L)", "N"),
    # heat
    ("k_t*Ar*(Th - Th0)/L", "W"), ("h_t*Ar*(Th - Th0) + sb*Ar*(Th**4 - Th0**4)", "W"), ("x/sqrt(4*alpha_t*t)", "1"),
    ("((Th - Th0) - (Th1 - Th0))/log((Th - Th0)/(Th1 - Th0))", "K"), ("L*al*(Th - Th0)", "m"), ("0.5*m*v**2/(rho*c_p*Ar*L)", "K"),
    ("k_t/(rho*c_p)", "m^2/s"), ("alpha_t*diff(Th0*exp(-x/L), x, 2)", "K/s"), ("mu*F_N*v/(4*R*k_t)", "K"),
    # zero and numbers
    ("0*d + v", "m/s"), ("0.0", "N"), ("7/3*pi", "1"),
]  # fmt: skip

_POWER = "a rational exponent, or one of constant parameters"

# expression, expected unit or None, smallest sub-expression at fault, the two units in conflict
INCONSISTENT = [
    ("log(x) - log(t)", "1", "log(x)", "m", "1"), ("2*log(x) - log(y)", "1", "log(x)", "m", "1"), ("log(x) + log(y)", "1", "log(x)", "m", "1"),
    ("F*log(x) - v*log(y)", None, "log(x)", "m", "1"),
    ("log(x) - log(y) + sin(log(x))", "1", "log(x)", "m", "1"),  # one that stands elsewhere is not excused
    ("LambertW(d, -1)", "1", "LambertW(d, -1)", "m", "1"), ("gamma(R)", "1", "gamma(R)", "m", "1"),
    # the mistakes of published formulas and public code (contact-laws.md, section 5)
    ("pi/8*E*sqrt(2*d*(3*dR + 2*d)**2/(dR + d)**3)*d**1.5", "N", "pi/8*E*sqrt(2*d*(3*dR + 2*d)**2/(dR + d)**3)*d**1.5", "N/m^0.5", "N"),
    ("K*d**n", "N", "K*d**n", "N m^(n-1.5)", "N"), ("K*d", "N", "K*d", "N/m^0.5", "N"), ("K*d**1", "N", "K*d**1", "N/m^0.5", "N"),
    ("K*d**1.1*(1 + v/v0)", "N", "K*d**1.1", "N/m^0.4", "N"), ("(a_P*dR + b_P)*L*E/dR*d**n", "N", "a_P*dR + b_P", "1", "m"),
    ("1.51*log(1000*dR)**-0.151", None, "log(1000*dR)", "m", "1"), ("1.51*dR**-0.005", "1", "1.51*dR**-0.005", "1/m^0.005", "1"),
    ("d**(1.51*dR**-0.005)", None, "d**(1.51*dR**-0.005)", "1/m^0.005", "1"),
    ("F*s_c/L*(log(L/(F*R*s_c)) + 1)", "m", "log(L/(F*R*s_c))", "1/m^2", "1"),
    ("pi/2*E*d*sqrt(d/(2*(dR + d)))", "N", "pi/2*E*d*sqrt(d/(2*(dR + d)))", "N/m", "N"),
    ("K*d**1.5 + chi*d**1.5*v", None, "K*d**1.5 + chi*d**1.5*v", "N/m^(n-1.5)", "N"), ("4/3*E*sqrt(d)*d", "N", "4/3*E*sqrt(d)*d", "N/m^0.5", "N"),
    ("4/3*E*sqrt(R)*d", "N", "4/3*E*sqrt(R)*d", "N/m^0.5", "N"),
    ("3*(1 - e)/4*(K/v0)**2*d**1.5*v + K*d**1.5", "N", "3*(1 - e)/4*(K/v0)**2*d**1.5*v", "N^2 s/m^2.5", "N"),
    ("L*E*L/dR*d**1.1*l_ref**0.9", "N", "L*E*L/dR*d**1.1*l_ref**0.9", "J", "N"), ("F_N*mu_k + v_S*v", "N", "v_S*v", "m^2/s^2", "N"),
    ("F_N*(z + s1*(v - s0*abs(v)*z/mu))", None, "z + s1*(v - s0*abs(v)*z/mu)", "m", "1"),
    # constants that hide a unit
    ("mu*F_N*tanh(5*v)", "N", "tanh(5*v)", "m/s", "1"), ("v/(v + 0.001)", None, "v + 0.001", "1", "m/s"),
    ("max(v0, 0.001)", "m/s", "max(v0, 0.001)", "1", "m/s"), ("where(d > 1e-6, K*d**1.5, 0)", "N", "d > 1e-6", "1", "m"),
    ("3.84e-5*F**0.9/L**0.8", "m", "3.84e-5*F**0.9/L**0.8", "N^0.9/m^0.8", "m"), ("exp(-0.05*(Th - 273.15))", "1", "Th - 273.15", "1", "K"),
    ("9.81*m", "N", "9.81*m", "kg", "N"), ("mu_k + (mu_s - mu_k)*exp(-10*abs(v))", "1", "exp(-10*abs(v))", "m/s", "1"),
    # as written: SymPy would have collapsed the fault
    ("m - m + t", None, "m - m + t", "s", "kg"), ("0*(x + v)", None, "x + v", "m/s", "m"), ("(x + t)/(x + t)", None, "x + t", "s", "m"),
    ("sin(omega)**2 + cos(omega)**2", None, "sin(omega)", "1/s", "1"), ("x + v*(1 - 1)", None, "x + v*(1 - 1)", "m/s", "m"),
    ("(x + v)**0", None, "x + v", "m/s", "m"), ("log(exp(x))", None, "exp(x)", "m", "1"), ("d**(n + x - x)", None, "n + x", "1", "m"),
    # sums, comparisons, choices
    ("m*v + F", "N", "m*v", "N s", "N"), ("m*v + F", None, "m*v + F", "N s", "N"), ("x + v*t + a*t", None, "x + v*t + a*t", "m/s", "m"),
    ("sin(theta)*(x + v)/L", None, "x + v", "m/s", "m"), ("x + 1", None, "x + 1", "1", "m"), ("x + y", "m/s", "x + y", "m", "m/s"),
    ("max(F, K*d)", "N", "K*d", "N/m^0.5", "N"), ("max(x, v)", None, "max(x, v)", "m/s", "m"), ("min(F, mu)", None, "min(F, mu)", "1", "N"),
    ("where(d > v, F, F)", None, "d > v", "m/s", "m"), ("where(d > 0, K*d**1.5, E)", None, "where(d > 0, K*d**1.5, E)", "Pa", "N"),
    ("where(d > 0, K*d, 0)", "N", "K*d", "N/m^0.5", "N"), ("where(d > 0 and v > 1, F, 0)", None, "v > 1", "1", "m/s"),
    ("where(not x < t, F, 0)", None, "x < t", "s", "m"), ("0 < x < v", None, "0 < x < v", "m/s", "m"), ("m*a == p", None, "m*a == p", "Pa", "N"),
    ("x != v", None, "x != v", "m/s", "m"), ("atan2(y, v)", None, "atan2(y, v)", "m/s", "m"), ("abs(x - v)", None, "x - v", "m/s", "m"),
    # functions of dimensional arguments
    ("x*sin(omega)", None, "sin(omega)", "1/s", "1"), ("cos(x)*L", None, "cos(x)", "m", "1"), ("tan(L/v)", None, "tan(L/v)", "s", "1"),
    ("atan(y)", None, "atan(y)", "m", "1"), ("asin(F_t)", None, "asin(F_t)", "N", "1"), ("acos(x/y**2)", None, "acos(x/y**2)", "1/m", "1"),
    ("cosh(L*kappa*x)", None, "cosh(L*kappa*x)", "m", "1"), ("sinh(t)", None, "sinh(t)", "s", "1"), ("exp(-t/wn)", None, "exp(-t/wn)", "s^2", "1"),
    ("eta*exp(p)", None, "exp(p)", "Pa", "1"), ("log(Th)", None, "log(Th)", "K", "1"),
    # powers
    ("F**d", None, "F**d", "m", "1"), ("2**t", None, "2**t", "s", "1"), ("x**theta", None, "x**theta", "m to the power theta", _POWER),
    ("d**(n*x/y)", None, "d**(n*x/y)", "m to the power n*x/y", _POWER), ("K*d**(1 + v/v0)", "N", "d**(1 + v/v0)", "m to the power 1 + v/v0", _POWER),
    ("x**pi", None, "x**pi", "m to the power pi", _POWER), ("d**sqrt(2)", None, "d**sqrt(2)", "m to the power sqrt(2)", _POWER),
    ("Kn*d**(2*n - 1)", "N", "Kn*d**(2*n - 1)", "N m^(n-1)", "N"), ("Kn*d**(n + 1)", "N", "Kn*d**(n + 1)", "J", "N"),
    ("Kn*d**k", "N", "Kn*d**k", "N m^(k-n)", "N"), ("sqrt(c*m)", "1/s", "sqrt(c*m)", "N s/m", "1/s"),
    # mechanics
    ("m*v", "J", "m*v", "N s", "J"), ("K*d**1.5 + m*g*d", "N", "m*g*d", "J", "N"), ("J*omega + m*v*R*R", None, "J*omega + m*v*R*R", "N s m^2", "J s"),
    ("M_t + F", None, "M_t + F", "N", "J"), ("F*L**3/(3*E*Ar)", "m", "F*L**3/(3*E*Ar)", "m^3", "m"),
    ("sqrt(L**2 - R*sin(theta)**2)", None, "L**2 - R*sin(theta)**2", "m", "m^2"),
    # derivatives and integrals
    ("diff(x*cos(omega*t), t) + a", None, "diff(x*cos(omega*t), t) + a", "m/s^2", "m/s"),
    ("m*diff(x*cos(omega*t), t)", "N", "m*diff(x*cos(omega*t), t)", "N s", "N"), ("diff(K*d**1.5, d)", "N", "diff(K*d**1.5, d)", "N/m", "N"),
    ("diff(m*v**2/2 + x, v)", None, "m*v**2/2 + x", "m", "J"), ("integrate(F, x, 0, t)", None, "integrate(F, x, 0, t)", "s", "m"),
    ("integrate(K*x**1.5, x, 0, d)", "N", "integrate(K*x**1.5, x, 0, d)", "J", "N"),
    # matrices
    ("[x, theta]", None, "[x, theta]", "1", "m"), ("[[c, 0], [0, c_v]] @ [x, y]", None, "[[c, 0], [0, c_v]]", "N s/m", "N/m"),
    ("[x, y] + [v, v]", None, "[x, y] + [v, v]", "m/s", "m"), ("det([[x, y], [y, x]])", "m", "det([[x, y], [y, x]])", "m^2", "m"),
    ("inv([[c, 0], [0, c]]) @ [x, y]", "m", "inv([[c, 0], [0, c]]) @ [x, y]", "1/Pa", "m"),
    ("[[cos(t), 0], [0, 1]] @ [x, y]", None, "cos(t)", "s", "1"),
    # tribology, fluids, heat
    ("6*eta*U*L*(R/c_R)**2", "Pa", "6*eta*U*L*(R/c_R)**2", "N", "Pa"),
    ("diff(h_f**2/(12*eta)*diff(p0*sin(x/L), x), x)", "m/s", "diff(h_f**2/(12*eta)*diff(p0*sin(x/L), x), x)", "1/s", "m/s"),
    ("p + rho*U/2", None, "p + rho*U/2", "N s/m^3", "Pa"), ("rho*g*z + eta*U/h_f**2", None, "rho*g*z + eta*U/h_f**2", "N/m^3", "Pa"),
    ("rho*U*L/(eta*x)", "1", "rho*U*L/(eta*x)", "1/m", "1"), ("sigma*(1/R1 + 1/Ar)", None, "1/R1 + 1/Ar", "1/m^2", "1/m"),
    ("k*F_N*x/H", "m", "k*F_N*x/H", "m^3", "m"), ("h_t*Ar*(Th - Th0) + sb*Ar*Th**3", None, "h_t*Ar*(Th - Th0) + sb*Ar*Th**3", "W/K", "W"),
    ("x/sqrt(4*alpha_t)", "1", "x/sqrt(4*alpha_t)", "s^0.5", "1"), ("k_t*(Th - Th0)/L", "W", "k_t*(Th - Th0)/L", "W/m^2", "W"),
    ("alpha_t*diff(Th0*exp(-x/L), x)", "K/s", "alpha_t*diff(Th0*exp(-x/L), x)", "m K/s", "K/s"), ("L*al*Th0 + Th", None, "L*al*Th0 + Th", "K", "m"),
]  # fmt: skip
