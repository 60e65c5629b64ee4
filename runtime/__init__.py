"""Load generated models and run them: `from hertzwerk.runtime import load, simulate`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the list of public names
    from hertzwerk.derive.common.faults import Fault as Fault, InputError as InputError
    from hertzwerk.runtime.studies.comparison.compare_run import compare as compare
    from hertzwerk.runtime.studies.comparison.comparison_result import Comparison as Comparison
    from hertzwerk.runtime.studies.uncertainty.correlation import Correlated as Correlated
    from hertzwerk.runtime.studies.uncertainty.distributions import (
        LogNormal as LogNormal,
        Normal as Normal,
        Triangular as Triangular,
        TruncatedNormal as TruncatedNormal,
        Uniform as Uniform,
    )
    from hertzwerk.runtime.studies.minimisation.minimisation import minimise as minimise
    from hertzwerk.runtime.studies.minimisation.minimum import Minimum as Minimum
    from hertzwerk.runtime.studies.uncertainty.propagation_result import Propagated as Propagated
    from hertzwerk.runtime.studies.uncertainty.propagation import propagate as propagate
    from hertzwerk.runtime.analysis.effect_study.leaving_out import study_effects as study_effects
    from hertzwerk.runtime.studies.fitting.experiment import Experiment as Experiment
    from hertzwerk.runtime.studies.fitting.moments.measured_moments import MeasuredSeries as MeasuredSeries
    from hertzwerk.runtime.engine.inputs.time_series import Samples as Samples
    from hertzwerk.runtime.loading import Model as Model, load as load
    from hertzwerk.runtime.engine.inputs.measurement_csv import (
        MeasuredImpacts as MeasuredImpacts,
        Measurement as Measurement,
        read_impacts as read_impacts,
        read_measurement as read_measurement,
    )
    from hertzwerk.runtime.studies.fitting.fit_result import Fit as Fit
    from hertzwerk.runtime.studies.fitting.parameter_fit import (
        fit as fit,
        fit_laws as fit_laws,
        fit_moments as fit_moments,
    )
    from hertzwerk.runtime.simulation import Solution as Solution, simulate as simulate
    from hertzwerk.runtime.engine.solution.impacts import Impact as Impact
    from hertzwerk.runtime.engine.solution.outcome import Outcome as Outcome
    from hertzwerk.runtime.engine.solution.solution import Statistics as Statistics
    from hertzwerk.runtime.analysis.statics.equilibrium import Equilibrium as Equilibrium, equilibrium as equilibrium
    from hertzwerk.runtime.analysis.statics.vibrations import Mode as Mode, Modes as Modes, modes as modes
    from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import RigidImpact as RigidImpact
    from hertzwerk.runtime.analysis.rigid_limit.rigid_limit import RigidLimit as RigidLimit, rigid_limit as rigid_limit
    from hertzwerk.runtime.studies.sweeps.batch import simulate_many as simulate_many
    from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep as sweep
    from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep as Sweep
else:
    from hertzwerk.names import handed_on

    __all__, __getattr__, __dir__ = handed_on(__name__)
