"""Load generated models and run them: `from hertzwerk.runtime import load, simulate`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the list of public names
    from hertzwerk.derive.faults import Fault as Fault, InputError as InputError
    from hertzwerk.runtime.comparing import Comparison as Comparison, compare as compare
    from hertzwerk.runtime.design.correlated import Correlated as Correlated
    from hertzwerk.runtime.design.distributions import (
        LogNormal as LogNormal,
        Normal as Normal,
        Triangular as Triangular,
        TruncatedNormal as TruncatedNormal,
        Uniform as Uniform,
    )
    from hertzwerk.runtime.design.minimisation import minimise as minimise
    from hertzwerk.runtime.design.minimum import Minimum as Minimum
    from hertzwerk.runtime.design.propagated import Propagated as Propagated
    from hertzwerk.runtime.design.propagation import propagate as propagate
    from hertzwerk.runtime.effects.leaving_out import study_effects as study_effects
    from hertzwerk.runtime.fitting.experiment import Experiment as Experiment
    from hertzwerk.runtime.fitting.moments.measured_moments import MeasuredSeries as MeasuredSeries
    from hertzwerk.runtime.inputs.time_series import Samples as Samples
    from hertzwerk.runtime.loading import Model as Model, load as load
    from hertzwerk.runtime.measured.measurement import (
        MeasuredImpacts as MeasuredImpacts,
        Measurement as Measurement,
        read_impacts as read_impacts,
        read_measurement as read_measurement,
    )
    from hertzwerk.runtime.model.model import Bound as Bound
    from hertzwerk.runtime.parameter_fit import (
        Fit as Fit,
        fit as fit,
        fit_laws as fit_laws,
        fit_moments as fit_moments,
    )
    from hertzwerk.runtime.simulation import Solution as Solution, simulate as simulate
    from hertzwerk.runtime.solution.impacts import Impact as Impact
    from hertzwerk.runtime.solution.outcome import Outcome as Outcome
    from hertzwerk.runtime.solution.solution import Statistics as Statistics
    from hertzwerk.runtime.statics.equilibrium import Equilibrium as Equilibrium, equilibrium as equilibrium
    from hertzwerk.runtime.statics.vibrations import Mode as Mode, Modes as Modes, modes as modes
    from hertzwerk.runtime.sweeps.batch import simulate_many as simulate_many
    from hertzwerk.runtime.sweeps.parameter_sweep import sweep as sweep
    from hertzwerk.runtime.sweeps.sweep_table import Sweep as Sweep
else:
    from hertzwerk.names import handed_on

    __all__, __getattr__, __dir__ = handed_on(__name__)
