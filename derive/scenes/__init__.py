"""Built-in scenes, one module each."""

NAMES = (
    "bouncing_ball",
    "soft_ball",
    "two_spheres",
    "ball_between_walls",
    "slider_crank",
    "slider_crank_frictionless",
    "slider_crank_two_clearances",
    "slider_crank_three_clearances",
    "four_bar_clearance",
    "journal_in_bearing",
    "journal_lubricated",
    "newtons_cradle",
    "pendulum",
    "double_pendulum",
    "flyball_governor",
    "n_four_bar",
    "bricard",
    "ball_in_socket",
    "translational_clearance",
    "spatial_slider_crank",
)
