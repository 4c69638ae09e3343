// LIGGGHTS includes this list several times, each time for another macro: no include guard.
#include "normal_model_fractional.h"
