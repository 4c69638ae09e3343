#pragma once

// LIGGGHTS's headers in the one order that compiles: several use what only an earlier one declares.
#include <cmath>
#include <cstring>
#include <string>

#include <mpi.h>

#include "pair.h"
#include "atom.h"
#include "neighbor.h"
#include "neigh_list.h"
#include "domain.h"
#include "comm.h"
#include "force.h"
#include "update.h"
#include "modify.h"
#include "memory.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_insert_stream.h"
#include "granular_pair_style.h"
#include "granular_wall.h"
#include "global_properties.h"
#include "contact_models.h"
#include "pair_gran_base.h"
#include "fix_wall_gran_base.h"
