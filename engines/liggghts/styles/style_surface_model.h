// LIGGGHTS includes this list several times, each time for another macro: no include guard.
#include "surface_model_default.h"
