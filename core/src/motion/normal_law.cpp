#include <ricochet/motion/normal_law.hpp>

#include "affordable_kernel.hpp"

#include <ricochet/support/require.hpp>

#include <algorithm>

namespace ricochet {
namespace {

MemoryKernel kernel_for(double alpha, const NormalStepping& s) {
  const double shortest = 0.5 * s.step, longest = s.longest_contact > 0 ? s.longest_contact : 1e4 * s.step;
  support::require(longest <= 1e6 * shortest, "longest_contact", longest, "at most 5e5 steps with a fractional law");
  return motion::affordable_kernel(alpha, shortest, std::max(longest, shortest), s.kernel_tolerance);
}

}  // namespace

struct NormalLaw::OnArms final : Description {
  explicit OnArms(const Fractional& l) : law(l) {}
  std::string_view name() const noexcept override { return Fractional::name; }
  std::size_t memory_size() const noexcept override { return motion::memory_size<FractionalArms::Memory>; }
  void require_motion() const override {
    support::require(law.alpha() >= 0 && law.alpha() <= 1, "alpha", law.alpha(), "in [0, 1] for particles in motion");
  }
  double resolved_time(double mass, double speed) const override { return motion::resolved_time(law, mass, speed); }
  std::unique_ptr<motion::NormalContacts> contacts(const NormalStepping& s) const override {
    const MemoryKernel kernel = kernel_for(law.alpha(), s);
    return std::make_unique<motion::NormalContactsOf<FractionalArms>>(FractionalArms(law, kernel, s.step), s.step,
                                                                      s.end, kernel.error());
  }
  Fractional law;
};

NormalLaw::NormalLaw(const Fractional& law) : law_(std::make_shared<const OnArms>(law)) {}
NormalLaw::NormalLaw(const AnyLaw& law) : law_(std::visit([](const auto& one) { return NormalLaw(one).law_; }, law)) {}

}  // namespace ricochet
