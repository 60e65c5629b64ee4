"""Symbols of a lubrication film: LaTeX letter, subscript and meaning by the rest of the name."""

FILM = {
    "axis": ("a", "", "axis of the bush"),
    "squeeze": ("w", "", "velocity of the pin against the bush, midway between their centres, across the axis"),
    "squeeze_speed": ("w", "", "its size; where it is 0, the speed accuracy is measured by"),
    "across": ("w", r"\perp", "the same a quarter turn on about the axis"),
    "spin": (r"\Omega", "", "spin of the pin in the bush"),
    "epsilon": (
        r"\varepsilon",
        "",
        "eccentricity over clearance, or what leaves a film of two boundary layers if that is more",
    ),
    "thinning": ("x", "", "0 up to a film of two boundary layers, 1 from contact on"),
    "limited": (r"\varepsilon", r"\mathrm{lim}", "the same, never less than a film of one boundary layer"),
    "sinking": ("y", "", "0 up to contact, 1 at a penetration of one boundary layer"),
    "per_e": (
        r"\kappa",
        "",
        "what the eccentricity is multiplied by: the reciprocal of the clearance, less where the film is thin",
    ),
    "share": (r"\chi", "", "share of the film that is left in contact"),
    "epsilon_w": (r"\varepsilon", "w", ""),
    "epsilon_c": (r"\varepsilon", r"\perp", ""),
    "drag_along": ("D", "w", "drag of the film along the squeeze velocity"),
    "drag_across": ("D", r"\perp", "drag of the film across the squeeze velocity"),
    "drag_spin": ("D", r"\Omega", "drag of the film against the spin"),
    "force": ("F", r"\mathrm{film}", "force of the film on the pin"),
    "couple": ("T", r"\mathrm{film}", "couple of the film on the pin"),
}
FILM_LANDMARKS = (
    "squeeze",
    "spin",
    "epsilon",
    "thinning",
    "limited",
    "sinking",
    "per_e",
    "share",
    "drag_along",
    "drag_across",
    "force",
    "couple",
)
