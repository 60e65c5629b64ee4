"""Published and independently computed numbers of contact laws, `shared/reference/contact-laws.md` sections 1 to 3, typed digit by digit."""

# E [Pa], nu of both bodies, R1, R2, L [m]
STEEL = {"E": "207e9", "nu": "0.3", "R_1": "0.010", "R_2": "0.0095", "L": "0.015"}
ALUMINIUM = {"E": "69e9", "nu": "0.35", "R_1": "2.5e-3", "R_2": "2.45e-3", "L": "1"}

# Force [N] at the penetrations [m]; the last digit printed is rounded.
STEEL_PENETRATIONS = ("1e-7", "1e-6", "1e-5")
STEEL_FORCES = {
    "johnson": ("47.301", "610.964", "8775.02"),
    "wang_liu_johnson": ("47.301", "610.964", "8775.02"),
    "dubowsky_freudenstein": ("41.420", "514.336", "6842.86"),
    "goldsmith_m3": ("41.420", "514.336", "6842.86"),  # the same law, since 1/R = dR/(R1 R2)
    "esdu_78035": ("39.682", "487.304", "6357.79"),
    "pereira_internal_si": ("44.199", "642.661", "9344.46"),
    "liu_with_length": ("2.6796", "84.660", "2653.44"),
    "wang_liu_secant": ("2.6796", "84.660", "2653.44"),
    "hertz_point": ("2.0903", "66.102", "2090.33"),
    "popov_line": ("133.992", "1339.92", "13399.2"),
    "wang_liu_external": ("133.992", "1339.92", "13399.2"),
}

JOHNSON = {"1e-10": "0.7577732440", "1.01e-8": "110.2026993022", "3.951e-7": "6776.8098542335"}  # ALUMINIUM, m -> N

# h that returns e exactly, contact-laws.md section 2
EXACT_FACTORS = {
    "0.95": "0.078927", "0.9": "0.166482", "0.8": "0.373146", "0.7": "0.634828", "0.6": "0.974872", "0.5": "1.432751",
    "0.4": "2.082498", "0.3": "3.087082", "0.2": "4.919167", "0.1": "9.998159",
}  # fmt: skip

# Jankowski: restitution asked for -> returned
JANKOWSKI = {"0.9": "0.8997", "0.7": "0.6977", "0.5": "0.4946", "0.3": "0.2917", "0.1": "0.0933"}

KUWABARA_KONO = "1.15345"  # e = 1 - this (3/2) A (K/m_eff)^(2/5) v0^(1/5) + ...

# Roark's table of line contact, of diameters: b in sqrt(p K_D C_E), in sqrt(p K_D/E) with nu = 0.3, largest stress in sqrt(p/(K_D C_E))
ROARK_LINE = {"b": "1.60", "b of steel": "2.15", "stress": "0.798"}
