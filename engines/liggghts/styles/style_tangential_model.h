// LIGGGHTS includes this list several times, each time for another macro: no include guard.
#include "tangential_model_no_history.h"
#include "tangential_model_history.h"
