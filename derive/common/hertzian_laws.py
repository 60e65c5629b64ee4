"""Names of the stiffness laws whose surfaces are Hertz's elastic half-spaces."""

POINT = ("hertz_point",)
LINE = (
    *("johnson", "hertz_cylinder", "radzimovsky", "goldsmith", "goldsmith_m3", "dubowsky_freudenstein", "esdu_78035"),
    *("palmgren", "palmgren_si", "pereira_internal", "pereira_internal_si", "pereira_external", "pereira_external_si"),
    *("lankarani_nikravesh_cylinders", "popov_line", "hertz_half_width"),
    *("wang_liu_external", "wang_liu_half_width", "wang_liu_johnson"),
)
