#pragma once

#include <ricochet/contact/any_law.hpp>
#include <ricochet/contact/law.hpp>
#include <ricochet/fractional/memory_kernel.hpp>
#include <ricochet/version.hpp>
#include <ricochet/motion/collision.hpp>
