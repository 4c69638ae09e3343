// What a normal law makes of itself for bodies in motion.
#include <catch2/catch.hpp>
#include <ricochet/motion/normal_law.hpp>

using namespace ricochet;

TEST_CASE("Interactions of one degree share a kernel, which is the one that each would make") {
  KernelsMade made;
  const auto error = [&](const NormalLaw& law, KernelsMade* kernels) {
    return law.contacts({.step = 1e-6, .made = kernels})->kernel_error();
  };
  const Fractional law(5000, 0.2, 0.3), stiffer(9000, 0.2, 0.3), other(5000, 0.2, 0.4);
  const FractionalHertz hertz(1e6, 20, 0.3);
  const double first = error(law, &made);
  CHECK(made.size() == 1);
  CHECK(error(stiffer, &made) == first);
  CHECK(made.size() == 1);
  CHECK(error(other, &made) != first);
  CHECK(made.size() == 2);
  error(hertz, &made);
  CHECK(made.size() == (Fractional::Arms::max_kernel_arms == FractionalHertz::Arms::max_kernel_arms ? 2 : 3));
  CHECK(error(law, nullptr) == first);
  CHECK(error(law, &made) == first);
}
