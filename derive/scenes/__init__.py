"""The built-in scenes, one module each."""

NAMES = (
    "bouncing_ball",
    "soft_ball",
    "two_spheres",
    "ball_between_walls",
    "slider_crank",
    "slider_crank_frictionless",
    "n_four_bar",
    "bricard",
    "ball_in_socket",
    "translational_clearance",
    "spatial_slider_crank",
)
