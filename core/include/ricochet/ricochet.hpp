#pragma once

#include <ricochet/contact/any_law.hpp>
#include <ricochet/contact/fractional_collocation.hpp>
#include <ricochet/contact/fractional_contact.hpp>
#include <ricochet/contact/friction.hpp>
#include <ricochet/contact/geometry.hpp>
#include <ricochet/contact/law.hpp>
#include <ricochet/contact/vec3.hpp>
#include <ricochet/fractional/collocation.hpp>
#include <ricochet/fractional/memory_kernel.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>
#include <ricochet/motion/collision.hpp>
#include <ricochet/motion/column.hpp>
#include <ricochet/motion/event_driven_column.hpp>
#include <ricochet/motion/linked_cells.hpp>
#include <ricochet/motion/tuned_law.hpp>
#include <ricochet/version.hpp>
