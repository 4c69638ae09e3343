#include <run_watch.hpp>

#include <catch2/catch.hpp>

using ricochet::half_step::RunWatch;

namespace {

constexpr double tcol = 1e-4;

RunWatch in_run() {
  RunWatch watch;
  watch.begin_run(2, 0, 100);
  return watch;
}

bool says(const std::optional<RunWatch::Remark>& remark, const std::string& part) {
  return remark && remark->text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a step above a twentieth of the collision time is warned of once a run, above a quarter refused") {
  RunWatch watch = in_run();
  CHECK_FALSE(watch.look_at_step(0, 1, tcol, tcol / 20.01));
  const auto warned = watch.look_at_step(0, 1, tcol, tcol / 19);
  CHECK(says(warned, "leaves 19 steps"));
  CHECK_FALSE(warned->refuses);
  CHECK_FALSE(watch.look_at_step(1, 1, tcol, tcol / 19));
  const auto refused = watch.look_at_step(0, 1, tcol, tcol / 3.99);
  CHECK(says(refused, "timestep = 2.50627e-05: must be at most 1/4"));
  CHECK(refused->refuses);
  watch.begin_run(2, 100, 200);
  CHECK(watch.look_at_step(0, 1, tcol, tcol / 4.01));
}

TEST_CASE("another step than the kernel's is told of with both") {
  CHECK_FALSE(RunWatch::look_at_kernel(2e-6, 2e-6));
  const auto other = RunWatch::look_at_kernel(2e-6, 1e-6);
  CHECK(says(other, "timestep = 1e-06: the memory kernel stays the one chosen for timestep = 2e-06"));
  CHECK_FALSE(other->refuses);
}

TEST_CASE("the step that is advised is not warned of where the collision time is known to 1e-4 alone") {
  for (const double off : {-1e-4, 0., 1e-4}) {
    RunWatch watch = in_run();
    CHECK_FALSE(watch.look_at_step(0, 1, tcol * (1 + off), tcol / RunWatch::advised_steps));
  }
  RunWatch watch = in_run();
  CHECK(watch.look_at_step(0, 1, tcol, tcol / (0.998 * RunWatch::advised_steps)));
}

TEST_CASE("only pairs lighter than those of their kind before are looked at") {
  RunWatch watch = in_run();
  CHECK(watch.is_lightest(0, 2));
  watch.look_at_step(0, 2, tcol, tcol / 50);
  CHECK_FALSE(watch.is_lightest(0, 2));
  CHECK(watch.is_lightest(0, 1.9));
  CHECK(watch.is_lightest(1, 3));
}

TEST_CASE("an overlap of a tenth of the radius is said once a run") {
  RunWatch watch = in_run();
  CHECK_FALSE(watch.is_soft(0.099, 1));
  CHECK_FALSE(watch.is_soft(0.15, 2));
  REQUIRE(watch.is_soft(0.202, 2));
  CHECK(watch.soft(0.202, 2).text.find("10.1 % of the smaller radius") != std::string::npos);
  CHECK_FALSE(watch.is_soft(0.5, 1));
  watch.begin_run(2, 100, 200);
  CHECK(watch.is_soft(0.5, 1));
}

TEST_CASE("memory lost by a reset of the step is said at the first step after it") {
  RunWatch watch = in_run();
  CHECK_FALSE(watch.look_at_memory(0));
  watch.begin_run(2, 100, 200);
  CHECK_FALSE(watch.look_at_memory(100));
  watch.begin_run(2, 0, 100);
  CHECK(says(watch.look_at_memory(0), "reset_timestep"));
  CHECK_FALSE(watch.look_at_memory(0));
  watch.begin_run(2, 0, 100);
  CHECK_FALSE(watch.look_at_memory(1));
}
