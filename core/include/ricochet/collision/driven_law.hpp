#pragma once

#include <ricochet/contact/law.hpp>
#include <ricochet/contact/mean_force.hpp>

#include <string_view>

namespace ricochet::collision {

/// A contact law and the memory of one contact, as the generic collision drives them: `force` and `advance` alone.
/// The memory is only ever copied, so that a step can be tried and a stretch of the motion run anew.
class DrivenLaw {
 public:
  virtual ~DrivenLaw() = default;
  DrivenLaw(const DrivenLaw&) = delete;
  DrivenLaw& operator=(const DrivenLaw&) = delete;

  virtual std::string_view name() const noexcept = 0;
  /// The memory of t_b.
  virtual void touch() = 0;
  /// The force [N] with the memory as it is.
  virtual double force(Approach a) const noexcept = 0;
  /// The mean force [N] over the next dt [s] at a constant rate.
  virtual double mean(Approach a, double dt) const noexcept = 0;
  /// The force [N] at the end of a step over dt [s]; the memory stays until the step is accepted.
  virtual double try_step(Approach before, Approach after, double dt) = 0;
  virtual void accept() = 0;
  /// Marks the memory as it is; goes back to the mark.
  virtual void mark() = 0;
  virtual void back() = 0;

 protected:
  DrivenLaw() = default;
};

/// `law` outlives it.
template <ContactLaw Law>
class Driven final : public DrivenLaw {
 public:
  explicit Driven(const Law& law) : law_(law) {}

  std::string_view name() const noexcept override { return Law::name; }
  void touch() override { memory_ = {}; }
  double force(Approach a) const noexcept override { return law_.force(a, memory_); }
  double mean(Approach a, double dt) const noexcept override {
    return mean_force(law_, a.overlap, a.rate, memory_, dt);
  }
  double try_step(Approach before, Approach after, double dt) override {
    tried_ = memory_;
    law_.advance(tried_, before, after, dt);
    return law_.force(after, tried_);
  }
  void accept() override { memory_ = tried_; }
  void mark() override { marked_ = memory_; }
  void back() override { memory_ = marked_; }

 private:
  const Law& law_;
  typename Law::Memory memory_{}, tried_{}, marked_{};
};

}  // namespace ricochet::collision
