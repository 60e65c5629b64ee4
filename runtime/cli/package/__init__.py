"""hertzwerk: `from hertzwerk import Scene, load, simulate`; the rest is in `derive` and `runtime`.

This file is installed as `hertzwerk/__init__.py` (package-dir in pyproject.toml), so no plain folder of that name
shadows the package.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the list of public names
    from hertzwerk.derive.common.faults import InputError as InputError
    from hertzwerk.derive.declare.scene.scene import Scene as Scene
    from hertzwerk.runtime.loading import load as load
    from hertzwerk.runtime.simulation import simulate as simulate
    from hertzwerk.version import __version__ as __version__
else:
    from hertzwerk.names import handed_on

    __all__, __getattr__, __dir__ = handed_on(__name__)
