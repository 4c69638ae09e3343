#include <ricochet/contact/arms_block.hpp>
#include <ricochet/contact/fractional.hpp>
#include <ricochet/contact/mean_force.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace ricochet;

namespace {

constexpr double step = 1e-6;

FractionalArms arms_of(double alpha, double tolerance) {
  return {Fractional(5000, 0.3, alpha), memory_kernel(alpha, step, 1000 * step, tolerance), step};
}

std::size_t slots_of(const FractionalArms& law) {
  return (law.arms() + ArmsBlock::lanes - 1) / ArmsBlock::lanes * ArmsBlock::lanes;
}

/// Contacts whose overlaps wander, and all that their block gives over `steps` steps.
struct Block {
  static constexpr std::size_t contacts = 37;
  std::vector<double> elongation, before, after, held;

  Block(const ArmsBlock& block, std::size_t slots, int steps)
      : elongation(contacts * slots, 0.0), before(contacts, 0.0), after(contacts, 0.0), held(contacts, 0.0) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> draw(-4e-7, 6e-7);
    for (int n = 0; n < steps; ++n) {
      before.swap(after);
      for (std::size_t j = 0; j < contacts; ++j) after[j] = before[j] + draw(random);
      block.advance(contacts, elongation.data(), before.data(), after.data(), held.data());
    }
  }
};

const double tolerances[] = {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10};

}  // namespace

TEST_CASE("A block of contacts steps as advance and mean_force do one by one") {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  for (const double tolerance : tolerances) {
    const FractionalArms law = arms_of(0.3, tolerance);
    const std::size_t slots = slots_of(law);
    const ArmsBlock block(law, step, slots);
    Block many(block, slots, 20);
    // The elongations that the block's last step started from are not kept: go on from here, both ways.
    std::vector<double> next(many.after);
    for (std::size_t j = 0; j < next.size(); ++j) next[j] *= 1.01 + 0.01 * static_cast<double>(j % 5);
    std::vector<FractionalArms::Memory> memory(next.size());
    for (std::size_t j = 0; j < next.size(); ++j)
      for (std::size_t a = 0; a < law.arms(); ++a) memory[j].elongation[a] = many.elongation[j * slots + a];
    block.advance(next.size(), many.elongation.data(), many.after.data(), next.data(), many.held.data());
    for (std::size_t j = 0; j < next.size(); ++j) {
      CAPTURE(law.arms(), j);
      const double rate = (next[j] - many.after[j]) / step, coming = 0.3 - 0.02 * static_cast<double>(j);
      double greatest = std::abs(law.spring() * next[j]) + std::abs(block.slope() * coming);
      law.advance(memory[j], {many.after[j], rate}, {next[j], rate}, step);
      for (std::size_t a = 0; a < law.arms(); ++a) {
        const double q = memory[j].elongation[a];
        // Each side rounds its coefficients, products and sum: some ten roundings of the greater of the terms.
        CHECK(std::abs(many.elongation[j * slots + a] - q) <= 10 * eps * (std::abs(q) + std::abs(rate * step)));
        greatest += law.stiffness(a) * (std::abs(q) + std::abs(rate * step));
      }
      const double mean = mean_force(law, next[j], coming, memory[j], step);
      const double roundings = 20 + static_cast<double>(law.arms());
      CHECK(std::abs(many.held[j] + block.slope() * coming - mean) <= roundings * eps * greatest);
      CHECK(std::abs(block.held(&many.elongation[j * slots], next[j]) - many.held[j]) <= roundings * eps * greatest);
    }
  }
}

TEST_CASE("The instructions that step a block do not change a bit") {
  if (widest_instructions() == Instructions::baseline) {
    WARN("skipped: this machine has the baseline's instructions alone, and nothing to compare with");
    return;
  }
  for (const double tolerance : tolerances) {
    const FractionalArms law = arms_of(0.3, tolerance);
    const std::size_t slots = slots_of(law);
    CAPTURE(slots);
    const Block base(ArmsBlock(law, step, slots, Instructions::baseline), slots, 200);
    const Block avx2(ArmsBlock(law, step, slots, Instructions::avx2), slots, 200);
    CHECK(base.elongation == avx2.elongation);
    CHECK(base.held == avx2.held);
  }
}

TEST_CASE("A block has slots for arms that a law does not have, and none for a law without arms") {
  const FractionalArms law = arms_of(0.3, 1e-4), spring = arms_of(0, 1e-4);
  const std::size_t slots = slots_of(law);
  const Block narrow(ArmsBlock(law, step, slots), slots, 50), wide(ArmsBlock(law, step, slots + 8), slots + 8, 50);
  CHECK(narrow.held == wide.held);
  REQUIRE(spring.arms() == 0);
  const ArmsBlock none(spring, step, 0);
  const Block elastic(none, 0, 5);
  for (std::size_t j = 0; j < Block::contacts; ++j) CHECK(elastic.held[j] == 5000 * elastic.after[j]);
  CHECK(none.slope() == Approx(0.5 * step * 5000).epsilon(1e-15));
}

TEST_CASE("A block refuses steps and slots that it cannot take") {
  const FractionalArms law = arms_of(0.3, 1e-6);
  const std::size_t slots = slots_of(law);
  CHECK_THROWS_WITH(ArmsBlock(law, 0, slots), Catch::Contains("step = 0"));
  CHECK_THROWS_WITH(ArmsBlock(law, step, slots - 4), Catch::Contains("slots = "));
  CHECK_THROWS_WITH(ArmsBlock(law, step, slots + 1), Catch::Contains("slots = "));
  CHECK_THROWS_WITH(ArmsBlock(law, step, 28), Catch::Contains("slots = 28"));
}
