"""The slider-crank, one clearance, without friction."""

from hertzwerk.derive.scenes.slider_crank import scene as with_friction

scene = with_friction.without("slider_pin_friction").named(
    "slider_crank_frictionless", "slider-crank, one clearance, without friction"
)
