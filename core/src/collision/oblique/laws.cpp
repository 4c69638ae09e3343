// The laws that have paths of their own.

#include <ricochet/collision/oblique.hpp>

#include "normal_path.hpp"

namespace ricochet {
namespace {

template <class Law>
ObliqueCollision by_own_path(const Law& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                             const ObliqueOptions& options) {
  return collision::collide_obliquely(law, tangential, impact, options, [&](const Impact& head_on, const Collision& c) {
    return collision::normal_path(law, head_on, c);
  });
}

}  // namespace

ObliqueCollision collide(const Linear& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const KuwabaraKono& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const Tsuji& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const Hysteretic& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const Fractional& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const FractionalKelvinVoigt& law, const TangentialContact& tangential,
                         const ObliqueImpact& impact, const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const FractionalHertz& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}
ObliqueCollision collide(const FractionalZener& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options) {
  return by_own_path(law, tangential, impact, options);
}

}  // namespace ricochet
