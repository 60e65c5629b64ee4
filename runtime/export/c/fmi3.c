#ifndef fmi3Functions_h
#include <stdbool.h>
#include <stdint.h>
typedef void *fmi3Instance, *fmi3InstanceEnvironment, *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8, fmi3Byte;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean, fmi3Clock;
typedef const char *fmi3String;
typedef const fmi3Byte *fmi3Binary;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef enum { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent } fmi3DependencyKind;
typedef enum { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged } fmi3IntervalQualifier;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64, fmi3Boolean, fmi3Boolean, fmi3Boolean,
                                               fmi3Boolean, fmi3Boolean *, fmi3Float64 *);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);
#ifdef FMI3_FUNCTION_PREFIX
#define PASTED(a, b) a##b
#define PREFIXED(a, b) PASTED(a, b)
#define F(name) PREFIXED(FMI3_FUNCTION_PREFIX, name)
#endif
#endif
#ifndef F
#define F(name) name
#endif
#define REFERENCES fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences
#define UNUSED (void)valueReferences, (void)nValueReferences

static void say(void *instance, int status, const char *category, const char *text)
{
    unit *m = instance;
    fmi3LogMessageCallback log;
    memcpy(&log, &m->logger, sizeof log); /* C has no cast from a pointer to data to one to a function */
    log(m->environment, (fmi3Status)status, category, text);
}

static fmi3Status refuse(fmi3Instance instance, const char *what)
{
    return (fmi3Status)fail(instance, ERROR, what);
}

EXPORTED const char *F(fmi3GetVersion)(void) { return "3.0"; }

EXPORTED fmi3Status F(fmi3SetDebugLogging)(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories,
                                           const fmi3String categories[])
{
    return (fmi3Status)set_logging(instance, loggingOn, nCategories, categories);
}

EXPORTED fmi3Instance F(fmi3InstantiateModelExchange)(fmi3String instanceName, fmi3String instantiationToken,
                                                      fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                                      fmi3InstanceEnvironment instanceEnvironment,
                                                      fmi3LogMessageCallback logMessage)
{
    (void)instanceName, (void)instantiationToken, (void)resourcePath, (void)visible, (void)loggingOn;
    (void)instanceEnvironment, (void)logMessage;
    return NULL;
}

EXPORTED fmi3Instance F(fmi3InstantiateScheduledExecution)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
    fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3ClockUpdateCallback clockUpdate, fmi3LockPreemptionCallback lockPreemption,
    fmi3UnlockPreemptionCallback unlockPreemption)
{
    (void)instanceName, (void)instantiationToken, (void)resourcePath, (void)visible, (void)loggingOn;
    (void)instanceEnvironment, (void)logMessage, (void)clockUpdate, (void)lockPreemption, (void)unlockPreemption;
    return NULL;
}

EXPORTED fmi3Instance F(fmi3InstantiateCoSimulation)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible,
    fmi3Boolean loggingOn, fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
    const fmi3ValueReference requiredIntermediateVariables[], size_t nRequiredIntermediateVariables,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3IntermediateUpdateCallback intermediateUpdate)
{
    void *logger;
    unit *m;
    (void)resourcePath, (void)visible, (void)eventModeUsed, (void)requiredIntermediateVariables;
    (void)nRequiredIntermediateVariables, (void)intermediateUpdate;
    memcpy(&logger, &logMessage, sizeof logger);
    m = instantiate(instanceName, instantiationToken, logger, instanceEnvironment, loggingOn);
    if (m) m->early_return = earlyReturnAllowed;
    return m;
}

EXPORTED void F(fmi3FreeInstance)(fmi3Instance instance) { release(instance); }

EXPORTED fmi3Status F(fmi3EnterInitializationMode)(fmi3Instance instance, fmi3Boolean toleranceDefined,
                                                   fmi3Float64 tolerance, fmi3Float64 startTime,
                                                   fmi3Boolean stopTimeDefined, fmi3Float64 stopTime)
{
    return (fmi3Status)set_up(instance, toleranceDefined, tolerance, startTime, stopTimeDefined, stopTime);
}

EXPORTED fmi3Status F(fmi3ExitInitializationMode)(fmi3Instance instance) { return (fmi3Status)current(instance); }

EXPORTED fmi3Status F(fmi3Terminate)(fmi3Instance instance)
{
    (void)instance;
    return fmi3OK;
}

EXPORTED fmi3Status F(fmi3Reset)(fmi3Instance instance)
{
    reset(instance);
    return fmi3OK;
}

EXPORTED fmi3Status F(fmi3GetFloat64)(REFERENCES, fmi3Float64 values[], size_t nValues)
{
    if (nValues != nValueReferences) return refuse(instance, "as many values as variables are expected");
    return (fmi3Status)get(instance, valueReferences, nValueReferences, values);
}

EXPORTED fmi3Status F(fmi3SetFloat64)(REFERENCES, const fmi3Float64 values[], size_t nValues)
{
    if (nValues != nValueReferences) return refuse(instance, "as many values as variables are expected");
    return (fmi3Status)set(instance, valueReferences, nValueReferences, values);
}

#define NONE_OF(type)                                                                                                        \
    EXPORTED fmi3Status F(fmi3Get##type)(REFERENCES, fmi3##type values[], size_t nValues)                                    \
    {                                                                                                                        \
        UNUSED, (void)values;                                                                                                \
        return nValues ? refuse(instance, "variables are all of type Float64") : fmi3OK;                                     \
    }                                                                                                                        \
    EXPORTED fmi3Status F(fmi3Set##type)(REFERENCES, const fmi3##type values[], size_t nValues)                              \
    {                                                                                                                        \
        UNUSED, (void)values;                                                                                                \
        return nValues ? refuse(instance, "variables are all of type Float64") : fmi3OK;                                     \
    }
NONE_OF(Float32)
NONE_OF(Int8)
NONE_OF(UInt8)
NONE_OF(Int16)
NONE_OF(UInt16)
NONE_OF(Int32)
NONE_OF(UInt32)
NONE_OF(Int64)
NONE_OF(UInt64)
NONE_OF(Boolean)
NONE_OF(String)

EXPORTED fmi3Status F(fmi3GetBinary)(REFERENCES, size_t valueSizes[], fmi3Binary values[], size_t nValues)
{
    UNUSED, (void)valueSizes, (void)values;
    return nValues ? refuse(instance, "variables are all of type Float64") : fmi3OK;
}

EXPORTED fmi3Status F(fmi3SetBinary)(REFERENCES, const size_t valueSizes[], const fmi3Binary values[], size_t nValues)
{
    UNUSED, (void)valueSizes, (void)values;
    return nValues ? refuse(instance, "variables are all of type Float64") : fmi3OK;
}

/* The unit has no clocks, and nothing of these modes. */
#define NOTHING(name, ...)                                                                                                   \
    EXPORTED fmi3Status F(name)(__VA_ARGS__)

NOTHING(fmi3GetClock, REFERENCES, fmi3Clock values[]) { UNUSED, (void)values; return refuse(instance, "there are no clocks"); }
NOTHING(fmi3SetClock, REFERENCES, const fmi3Clock values[]) { UNUSED, (void)values; return refuse(instance, "there are no clocks"); }
NOTHING(fmi3GetIntervalDecimal, REFERENCES, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
{
    UNUSED, (void)intervals, (void)qualifiers;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3GetIntervalFraction, REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
{
    UNUSED, (void)counters, (void)resolutions, (void)qualifiers;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3GetShiftDecimal, REFERENCES, fmi3Float64 shifts[]) { UNUSED, (void)shifts; return refuse(instance, "there are no clocks"); }
NOTHING(fmi3GetShiftFraction, REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
{
    UNUSED, (void)counters, (void)resolutions;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3SetIntervalDecimal, REFERENCES, const fmi3Float64 intervals[])
{
    UNUSED, (void)intervals;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3SetIntervalFraction, REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
{
    UNUSED, (void)counters, (void)resolutions;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3SetShiftDecimal, REFERENCES, const fmi3Float64 shifts[]) { UNUSED, (void)shifts; return refuse(instance, "there are no clocks"); }
NOTHING(fmi3SetShiftFraction, REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
{
    UNUSED, (void)counters, (void)resolutions;
    return refuse(instance, "there are no clocks");
}
NOTHING(fmi3EnterEventMode, fmi3Instance instance) { return refuse(instance, "events stay inside fmi3DoStep: there is no event mode"); }
NOTHING(fmi3EnterStepMode, fmi3Instance instance) { return refuse(instance, "events stay inside fmi3DoStep: there is no event mode"); }
NOTHING(fmi3EnterConfigurationMode, fmi3Instance instance) { return refuse(instance, "there are no structural parameters"); }
NOTHING(fmi3ExitConfigurationMode, fmi3Instance instance) { return refuse(instance, "there are no structural parameters"); }
NOTHING(fmi3EvaluateDiscreteStates, fmi3Instance instance) { return refuse(instance, "there is no event mode"); }
NOTHING(fmi3UpdateDiscreteStates, fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate,
        fmi3Boolean *terminateSimulation, fmi3Boolean *nominalsOfContinuousStatesChanged,
        fmi3Boolean *valuesOfContinuousStatesChanged, fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime)
{
    (void)discreteStatesNeedUpdate, (void)terminateSimulation, (void)nominalsOfContinuousStatesChanged;
    (void)valuesOfContinuousStatesChanged, (void)nextEventTimeDefined, (void)nextEventTime;
    return refuse(instance, "there is no event mode");
}
NOTHING(fmi3GetNumberOfVariableDependencies, fmi3Instance instance, fmi3ValueReference valueReference, size_t *nDependencies)
{
    (void)valueReference, (void)nDependencies;
    return refuse(instance, "dependencies are not listed: every output depends on all inputs");
}
NOTHING(fmi3GetVariableDependencies, fmi3Instance instance, fmi3ValueReference dependent, size_t elementIndicesOfDependent[],
        fmi3ValueReference independents[], size_t elementIndicesOfIndependents[], fmi3DependencyKind dependencyKinds[],
        size_t nDependencies)
{
    (void)dependent, (void)elementIndicesOfDependent, (void)independents, (void)elementIndicesOfIndependents;
    (void)dependencyKinds, (void)nDependencies;
    return refuse(instance, "dependencies are not listed: every output depends on all inputs");
}
NOTHING(fmi3GetOutputDerivatives, REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues)
{
    UNUSED, (void)orders, (void)values, (void)nValues;
    return refuse(instance, "there are no derivatives of outputs with respect to time");
}

EXPORTED fmi3Status F(fmi3GetFMUState)(fmi3Instance instance, fmi3FMUState *FMUState)
{
    return (fmi3Status)keep(instance, FMUState);
}

EXPORTED fmi3Status F(fmi3SetFMUState)(fmi3Instance instance, fmi3FMUState FMUState)
{
    return (fmi3Status)take_back(instance, FMUState);
}

EXPORTED fmi3Status F(fmi3FreeFMUState)(fmi3Instance instance, fmi3FMUState *FMUState)
{
    (void)instance;
    return (fmi3Status)release_state(FMUState);
}

EXPORTED fmi3Status F(fmi3SerializedFMUStateSize)(fmi3Instance instance, fmi3FMUState FMUState, size_t *size)
{
    (void)instance, (void)FMUState;
    *size = size_of_state();
    return fmi3OK;
}

EXPORTED fmi3Status F(fmi3SerializeFMUState)(fmi3Instance instance, fmi3FMUState FMUState, fmi3Byte serializedState[],
                                             size_t size)
{
    return (fmi3Status)serialize(instance, FMUState, serializedState, size);
}

EXPORTED fmi3Status F(fmi3DeserializeFMUState)(fmi3Instance instance, const fmi3Byte serializedState[], size_t size,
                                               fmi3FMUState *FMUState)
{
    return (fmi3Status)deserialize(instance, serializedState, size, FMUState);
}

EXPORTED fmi3Status F(fmi3GetDirectionalDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                    size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
                                                    const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],
                                                    size_t nSensitivity)
{
    if (nSeed != nKnowns || nSensitivity != nUnknowns) return refuse(instance, "as many values as variables are expected");
    return (fmi3Status)derivative(instance, unknowns, nUnknowns, knowns, nKnowns, seed, sensitivity);
}

EXPORTED fmi3Status F(fmi3GetAdjointDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
                                                const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],
                                                size_t nSensitivity)
{
    (void)unknowns, (void)nUnknowns, (void)knowns, (void)nKnowns, (void)seed, (void)nSeed, (void)sensitivity;
    (void)nSensitivity;
    return refuse(instance, "there are directional derivatives, no adjoint ones");
}

EXPORTED fmi3Status F(fmi3DoStep)(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
                                  fmi3Float64 communicationStepSize, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                  fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
                                  fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    int early = 0, status;
    (void)noSetFMUStatePriorToCurrentPoint;
    status = do_step(instance, currentCommunicationPoint, communicationStepSize, &early, lastSuccessfulTime);
    *eventHandlingNeeded = false, *terminateSimulation = false, *earlyReturn = early;
    return (fmi3Status)status;
}

/* Of model exchange and scheduled execution: there is neither, but importers look for the names. */
NOTHING(fmi3EnterContinuousTimeMode, fmi3Instance instance) { return refuse(instance, "there is co-simulation alone"); }
NOTHING(fmi3CompletedIntegratorStep, fmi3Instance instance, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
        fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation)
{
    (void)noSetFMUStatePriorToCurrentPoint, (void)enterEventMode, (void)terminateSimulation;
    return refuse(instance, "there is co-simulation alone");
}
NOTHING(fmi3SetTime, fmi3Instance instance, fmi3Float64 time)
{
    (void)time;
    return refuse(instance, "there is co-simulation alone");
}
#define OF_EXCHANGE(name, constant)                                                                                          \
    EXPORTED fmi3Status F(name)(fmi3Instance instance, constant fmi3Float64 values[], size_t count)                          \
    {                                                                                                                        \
        (void)values, (void)count;                                                                                           \
        return refuse(instance, "there is co-simulation alone");                                                             \
    }
OF_EXCHANGE(fmi3SetContinuousStates, const)
OF_EXCHANGE(fmi3GetContinuousStateDerivatives, )
OF_EXCHANGE(fmi3GetEventIndicators, )
OF_EXCHANGE(fmi3GetContinuousStates, )
OF_EXCHANGE(fmi3GetNominalsOfContinuousStates, )
NOTHING(fmi3GetNumberOfEventIndicators, fmi3Instance instance, size_t *count)
{
    (void)count;
    return refuse(instance, "there is co-simulation alone");
}
NOTHING(fmi3GetNumberOfContinuousStates, fmi3Instance instance, size_t *count)
{
    (void)count;
    return refuse(instance, "there is co-simulation alone");
}
NOTHING(fmi3ActivateModelPartition, fmi3Instance instance, fmi3ValueReference clockReference, fmi3Float64 activationTime)
{
    (void)clockReference, (void)activationTime;
    return refuse(instance, "there is co-simulation alone");
}
