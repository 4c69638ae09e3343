// LIGGGHTS includes this list several times, each time for another macro: no include guard.
#include "cohesion_model_sjkr.h"
#include "cohesion_model_sjkr2.h"
#include "cohesion_model_easo_capillary_viscous.h"
#include "cohesion_model_washino_capillary_viscous.h"
