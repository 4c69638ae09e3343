// Any doubles to the numerical interface: an answer that is finite wherever it is called good, or the exception that the
// header names. The first byte chooses the function, the rest are its arguments.

#include <calibrate/calibration.hpp>
#include <ricochet/ricochet.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <stdexcept>

using namespace ricochet;

namespace {

class Arguments {
 public:
  Arguments(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// Any bits; 1 when the input is spent.
  double number() {
    if (size_ < sizeof(double)) return 1;
    double value;
    std::memcpy(&value, data_, sizeof value);
    data_ += sizeof value, size_ -= sizeof value;
    return value;
  }
  /// In [0, 1), so that more inputs get past the first check.
  double share() { return std::fabs(std::fmod(number(), 1.0)); }
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    return --size_, *data_++;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

void expect_finite(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value)) throw std::logic_error("a result marked good is not finite");
}

void expect_good(const Collision& c) {
  expect_finite({c.tcol, c.en, c.max_overlap, c.time_max_overlap, c.max_force, c.time_max_force, c.overlap_end});
  if (c.separated() && !(c.tcol > 0 && c.en >= 0 && c.en <= 1 + 1e-9))
    throw std::logic_error("an impossible collision");
}

void a_collision(Arguments& in) {
  const Impact impact{in.number(), in.number()};
  CollideOptions options;
  const std::uint8_t how = in.byte();
  options.end = how & 1 ? ContactEnd::overlap : ContactEnd::force;
  options.method = how & 2 ? CollideMethod::numerical : CollideMethod::automatic;
  options.max_evaluations = 20000;
  const double p = in.number(), q = in.number();
  switch ((how >> 2) % 5) {
    case 0: return expect_good(collide(Linear(p, q), impact, options));
    case 1: return expect_good(collide(KuwabaraKono(p, q), impact, options));
    case 2: return expect_good(collide(Tsuji(p, q), impact, options));
    case 3: return expect_good(collide(Hysteretic(p, q), impact, options));
    default: return expect_good(collide(Fractional(p, q, in.share()), impact, options));
  }
}

void a_calibration(Arguments& in) {
  calibration::Settings settings;
  settings.method = calibration::Method::direct;
  const auto law = static_cast<calibration::LawName>(in.byte() % 5);
  const auto end = in.byte() & 1 ? ContactEnd::overlap : ContactEnd::force;
  const double tcol = in.number(), en = in.share();
  try {
    const auto outcome = calibration::calibrate({law, end, {tcol, en, {in.number(), in.number()}}}, settings);
    if (const auto* found = std::get_if<calibration::Calibration>(&outcome)) {
      expect_good(found->achieved);
      for (const auto& parameter : calibration::parameters(found->law)) expect_finite({parameter.value});
    }
  } catch (const calibration::NotConverged&) {
  }
}

void a_kernel(Arguments& in) {
  const double shortest = in.number();
  const MemoryKernel kernel = memory_kernel(in.share(), shortest, shortest * (1 + 999 * in.share()), in.number());
  expect_finite({kernel.spring(), kernel.dashpot(), kernel.error()});
  for (const Arm& arm : kernel.arms()) {
    expect_finite({arm.strength, arm.rate});
    if (!(arm.strength > 0 && arm.rate > 0)) throw std::logic_error("an arm that is not passive");
  }
}

void run(Arguments& in) {
  switch (in.byte() % 6) {
    case 0: return expect_finite({mittag_leffler(in.number(), in.number(), in.number())});
    case 1: return expect_finite({MittagLeffler(in.number(), in.number())(in.number())});
    case 2: {
      const FractionalContact c =
          fractional_contact(in.share(), in.byte() & 1 ? ContactEnd::overlap : ContactEnd::force);
      return expect_finite({c.z_star, c.tau, c.en, c.overlap_end, c.max_overlap, c.max_force});
    }
    case 3: return a_collision(in);
    case 4: return a_calibration(in);
    default: return a_kernel(in);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Arguments in(data, size);
  try {
    run(in);
  } catch (const std::invalid_argument&) {
  } catch (const std::overflow_error&) {  // mittag_leffler, where the value is past the largest double
  }
  return 0;
}
