#ifndef fmi2Functions_h
typedef void *fmi2Component, *fmi2ComponentEnvironment, *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer, fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
typedef struct {
    fmi2CallbackLogger logger;
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;
#ifdef FMI2_FUNCTION_PREFIX
#define PASTED(a, b) a##b
#define PREFIXED(a, b) PASTED(a, b)
#define F(name) PREFIXED(FMI2_FUNCTION_PREFIX, name)
#endif
#endif
#ifndef F
#define F(name) name
#endif
#define REFERENCES fmi2Component c, const fmi2ValueReference vr[], size_t nvr

static void say(void *instance, int status, const char *category, const char *text)
{
    unit *m = instance;
    fmi2CallbackLogger log;
    memcpy(&log, &m->logger, sizeof log); /* C has no cast from a pointer to data to one to a function */
    log(m->environment, m->name, (fmi2Status)status, category, "%s", text);
}

EXPORTED const char *F(fmi2GetTypesPlatform)(void) { return "default"; }
EXPORTED const char *F(fmi2GetVersion)(void) { return "2.0"; }

EXPORTED fmi2Status F(fmi2SetDebugLogging)(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories,
                                           const fmi2String categories[])
{
    return (fmi2Status)set_logging(c, loggingOn, nCategories, categories);
}

EXPORTED fmi2Component F(fmi2Instantiate)(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID,
                                          fmi2String fmuResourceLocation, const fmi2CallbackFunctions *functions,
                                          fmi2Boolean visible, fmi2Boolean loggingOn)
{
    void *logger = NULL;
    (void)fmuResourceLocation, (void)visible;
    if (fmuType != fmi2CoSimulation) return NULL;
    if (functions) memcpy(&logger, &functions->logger, sizeof logger);
    return instantiate(instanceName, fmuGUID, logger, functions ? functions->componentEnvironment : NULL, loggingOn);
}

EXPORTED void F(fmi2FreeInstance)(fmi2Component c) { release(c); }

EXPORTED fmi2Status F(fmi2SetupExperiment)(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance,
                                           fmi2Real startTime, fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    return (fmi2Status)set_up(c, toleranceDefined, tolerance, startTime, stopTimeDefined, stopTime);
}

EXPORTED fmi2Status F(fmi2EnterInitializationMode)(fmi2Component c)
{
    (void)c;
    return fmi2OK;
}

EXPORTED fmi2Status F(fmi2ExitInitializationMode)(fmi2Component c) { return (fmi2Status)current(c); }

EXPORTED fmi2Status F(fmi2Terminate)(fmi2Component c)
{
    (void)c;
    return fmi2OK;
}

EXPORTED fmi2Status F(fmi2Reset)(fmi2Component c)
{
    reset(c);
    return fmi2OK;
}

EXPORTED fmi2Status F(fmi2GetReal)(REFERENCES, fmi2Real value[]) { return (fmi2Status)get(c, vr, nvr, value); }
EXPORTED fmi2Status F(fmi2SetReal)(REFERENCES, const fmi2Real value[]) { return (fmi2Status)set(c, vr, nvr, value); }

#define NONE_OF(type)                                                                                                        \
    EXPORTED fmi2Status F(fmi2Get##type)(REFERENCES, fmi2##type value[])                                                     \
    {                                                                                                                        \
        (void)vr, (void)value;                                                                                               \
        return nvr ? (fmi2Status)fail(c, ERROR, "variables are all of type Real") : fmi2OK;                                  \
    }                                                                                                                        \
    EXPORTED fmi2Status F(fmi2Set##type)(REFERENCES, const fmi2##type value[])                                               \
    {                                                                                                                        \
        (void)vr, (void)value;                                                                                               \
        return nvr ? (fmi2Status)fail(c, ERROR, "variables are all of type Real") : fmi2OK;                                  \
    }
NONE_OF(Integer)
NONE_OF(Boolean)
NONE_OF(String)

EXPORTED fmi2Status F(fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate *FMUstate) { return (fmi2Status)keep(c, FMUstate); }
EXPORTED fmi2Status F(fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate FMUstate) { return (fmi2Status)take_back(c, FMUstate); }

EXPORTED fmi2Status F(fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate *FMUstate)
{
    (void)c;
    return (fmi2Status)release_state(FMUstate);
}

EXPORTED fmi2Status F(fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    (void)c, (void)FMUstate;
    *size = size_of_state();
    return fmi2OK;
}

EXPORTED fmi2Status F(fmi2SerializeFMUstate)(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte serializedState[], size_t size)
{
    return (fmi2Status)serialize(c, FMUstate, serializedState, size);
}

EXPORTED fmi2Status F(fmi2DeSerializeFMUstate)(fmi2Component c, const fmi2Byte serializedState[], size_t size,
                                               fmi2FMUstate *FMUstate)
{
    return (fmi2Status)deserialize(c, serializedState, size, FMUstate);
}

EXPORTED fmi2Status F(fmi2GetDirectionalDerivative)(fmi2Component c, const fmi2ValueReference vUnknown_ref[], size_t nUnknown,
                                                    const fmi2ValueReference vKnown_ref[], size_t nKnown,
                                                    const fmi2Real dvKnown[], fmi2Real dvUnknown[])
{
    return (fmi2Status)derivative(c, vUnknown_ref, nUnknown, vKnown_ref, nKnown, dvKnown, dvUnknown);
}

EXPORTED fmi2Status F(fmi2SetRealInputDerivatives)(REFERENCES, const fmi2Integer order[], const fmi2Real value[])
{
    size_t i;
    for (i = 0; i < nvr; ++i) {
        unsigned rate = vr[i] + @N@_INPUTS;
        if (order[i] != 1 || !within((int)vr[i], AT_INPUTS, AT_RATES))
            return (fmi2Status)fail(c, ERROR, "the first derivative of an input is expected");
        set(c, &rate, 1, value + i);
    }
    return fmi2OK;
}

EXPORTED fmi2Status F(fmi2GetRealOutputDerivatives)(REFERENCES, const fmi2Integer order[], fmi2Real value[])
{
    (void)vr, (void)nvr, (void)order, (void)value;
    return (fmi2Status)fail(c, ERROR, "there are no derivatives of outputs with respect to time");
}

EXPORTED fmi2Status F(fmi2DoStep)(fmi2Component c, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
                                  fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    int early;
    double reached;
    (void)noSetFMUStatePriorToCurrentPoint;
    return (fmi2Status)do_step(c, currentCommunicationPoint, communicationStepSize, &early, &reached);
}

EXPORTED fmi2Status F(fmi2CancelStep)(fmi2Component c)
{
    return (fmi2Status)fail(c, ERROR, "a step that is done cannot be cancelled");
}

EXPORTED fmi2Status F(fmi2GetStatus)(fmi2Component c, const fmi2StatusKind s, fmi2Status *value)
{
    (void)s, (void)value;
    return (fmi2Status)fail(c, DISCARD, "steps are never pending");
}

EXPORTED fmi2Status F(fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind s, fmi2Real *value)
{
    unsigned now = 0;
    if (s != fmi2LastSuccessfulTime) return (fmi2Status)fail(c, DISCARD, "the last successful time alone is a number");
    return (fmi2Status)get(c, &now, 1, value);
}

EXPORTED fmi2Status F(fmi2GetIntegerStatus)(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value)
{
    (void)s, (void)value;
    return (fmi2Status)fail(c, DISCARD, "there is no such status");
}

EXPORTED fmi2Status F(fmi2GetBooleanStatus)(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value)
{
    (void)c;
    *value = 0;
    return s == fmi2Terminated ? fmi2OK : fmi2Discard;
}

EXPORTED fmi2Status F(fmi2GetStringStatus)(fmi2Component c, const fmi2StatusKind s, fmi2String *value)
{
    (void)s, (void)value;
    return (fmi2Status)fail(c, DISCARD, "steps are never pending");
}
