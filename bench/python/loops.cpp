// The loops in C++ beside those of loops.py: CPU seconds of a million Mittag-Leffler values and of a million fractional
// laws for a collision time and a restitution, least of three.
#include <calibrate/direct_calibrator.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

namespace {

constexpr std::size_t count = 1'000'000;

/// `first` … `last` in equal steps.
double at(std::size_t i, double first, double last) {
  return first + (last - first) * static_cast<double>(i) / (count - 1);
}

template <class F>
double least_seconds(const F& f) {
  double least = 1e300;
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    f();
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

}  // namespace

int main() {
  using namespace ricochet;
  std::vector<double> values(count);
  const double function = least_seconds([&] {
    for (std::size_t i = 0; i < count; ++i) values[i] = mittag_leffler(1.5, 2, at(i, -16, 2));
  });
  const calibration::DirectCalibrator calibrator;
  std::vector<std::array<double, 3>> parameters(count);
  const double calibration = least_seconds([&] {
    for (std::size_t i = 0; i < count; ++i) {
      const auto law = calibrator({.law = kind_of<Fractional>, .target = {1e-4, at(i, 0.05, 0.99), {0.5, 7.06858e-6}}});
      parameters[i] = std::get<Fractional>(std::get<AnyLaw>(law)).values();
    }
  });
  std::printf("%g %g\n", function, calibration);
}
