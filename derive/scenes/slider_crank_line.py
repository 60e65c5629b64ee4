"""The slider-crank with clearance whose pin touches the bush along a line (law of Liu, Zhang, Yang)."""

from hertzwerk.derive.scenes.slider_crank import scene as at_a_point

scene = at_a_point.with_law("slider_pin", "liu_with_length").named(
    "slider_crank_line", "slider-crank, clearance joint with line contact"
)
