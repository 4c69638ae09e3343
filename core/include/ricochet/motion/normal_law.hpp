#pragma once

#include <ricochet/contact/laws.hpp>
#include <ricochet/motion/engine/normal_contacts.hpp>
#include <ricochet/motion/resolved_time.hpp>

#include <concepts>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace ricochet {

/// Kernels that were made, by their degree and the most arms: many pairs of bodies meet by laws of the same memory.
using KernelsMade = std::map<std::pair<double, std::size_t>, MemoryKernel>;

/// What the contacts of one interaction are made for.
struct NormalStepping {
  double step = 0;                     ///< Δt [s]
  ContactEnd end = ContactEnd::force;  ///< which zero ends a contact
  double longest_contact = 0;          ///< T of memory kernels [s]; 0: 10⁴ steps
  double kernel_tolerance = 1e-8;      ///< relative, of these kernels
  KernelsMade* made = nullptr;         ///< those of the same step, longest contact and tolerance; it gains new ones
};

/// Any normal law that bodies can meet with: every ContactLaw converts into it, also one of your own, and so do the
/// fractional laws, which then run on Maxwell arms made for the cluster's steps, and AnyLaw. Immutable; copies share.
class NormalLaw {
 public:
  template <class Law>
  requires(!std::same_as<Law, NormalLaw>) && ContactLaw<Law>  // in this order: a copy asks for no copy
      NormalLaw(const Law& law) : law_(std::make_shared<const Of<Law>>(law)) {}
  template <RemembersAll Law>
  NormalLaw(const Law& law) : law_(std::make_shared<const OnArms<Law>>(law)) {}
  NormalLaw(const AnyLaw& law);

  std::string_view name() const noexcept { return law_->name(); }
  /// Of one contact, in doubles.
  std::size_t memory_size() const noexcept { return law_->memory_size(); }
  /// Throws std::invalid_argument for a law that particles can't be moved by: a fractional one outside 0 ≤ α ≤ 1.
  void require_motion() const { law_->require_motion(); }
  /// The time that a step has to resolve where a mass [kg] meets the law at a speed [m/s], see resolved_time.hpp [s].
  double resolved_time(double mass, double speed) const { return law_->resolved_time(mass, speed); }
  /// All contacts of an interaction with this law, none yet. Throws std::invalid_argument for a kernel that can't be
  /// made.
  std::unique_ptr<motion::NormalContacts> contacts(const NormalStepping& stepping) const {
    return law_->contacts(stepping);
  }

 private:
  struct Description {
    Description() = default;
    Description(const Description&) = delete;
    Description& operator=(const Description&) = delete;
    virtual ~Description() = default;
    virtual std::string_view name() const noexcept = 0;
    virtual std::size_t memory_size() const noexcept = 0;
    virtual void require_motion() const {}
    virtual double resolved_time(double mass, double speed) const = 0;
    virtual std::unique_ptr<motion::NormalContacts> contacts(const NormalStepping& stepping) const = 0;
  };

  template <ContactLaw Law>
  struct Of final : Description {
    explicit Of(const Law& l) : law(l) {}
    std::string_view name() const noexcept override { return Law::name; }
    std::size_t memory_size() const noexcept override { return motion::memory_size<typename Law::Memory>; }
    double resolved_time(double mass, double speed) const override { return motion::resolved_time(law, mass, speed); }
    std::unique_ptr<motion::NormalContacts> contacts(const NormalStepping& s) const override {
      return std::make_unique<motion::NormalContactsOf<Law>>(law, s.step, s.end);
    }
    Law law;
  };
  /// The kernel of α for these steps, of at most that many arms. Throws std::invalid_argument where none can be made.
  static MemoryKernel kernel_for(double alpha, const NormalStepping& stepping, std::size_t most_arms);
  static void require_degree(double alpha);

  template <RemembersAll Law>
  struct OnArms final : Description {
    using Arms = typename Law::Arms;
    explicit OnArms(const Law& l) : law(l) {}
    std::string_view name() const noexcept override { return Law::name; }
    std::size_t memory_size() const noexcept override { return motion::memory_size<typename Arms::Memory>; }
    void require_motion() const override { require_degree(law.alpha()); }
    double resolved_time(double mass, double speed) const override { return motion::resolved_time(law, mass, speed); }
    std::unique_ptr<motion::NormalContacts> contacts(const NormalStepping& s) const override {
      const MemoryKernel kernel = kernel_for(law.alpha(), s, Arms::max_kernel_arms);
      return std::make_unique<motion::NormalContactsOf<Arms>>(Arms(law, kernel, s.step), s.step, s.end, kernel.error());
    }
    Law law;
  };

  std::shared_ptr<const Description> law_;
};

}  // namespace ricochet
