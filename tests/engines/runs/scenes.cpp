#include "scenes.hpp"

#include <random>

namespace engines {

namespace crossing {

std::vector<Grain> pair(int axis, double drift) {
  const double gap = 10 * dt * speed;
  Grain a{.radius = radius}, b{.radius = radius};
  const double middle = -drift * (10 * dt + 0.4 * tcol);
  a.position[0] = b.position[0] = middle;
  if (axis == 0) a.position[0] += drift > 0 ? -radius : radius;  // so that one of them crosses while they touch
  if (axis == 0) b.position[0] += drift > 0 ? -radius : radius;
  a.position[axis] -= radius + gap / 2;
  b.position[axis] += radius + gap / 2;
  a.velocity[0] = b.velocity[0] = drift;
  a.velocity[axis] += speed / 2;
  b.velocity[axis] -= speed / 2;
  return {a, b};
}

int crossings_in_contact(const std::vector<Frame>& frames, std::size_t i) {
  int count = 0;
  for (std::size_t n = 1; n < frames.size(); ++n) {
    const Vector& f = frames[n].force[i];
    const bool touching = f[0] != 0 || f[1] != 0 || f[2] != 0;
    count += touching && (frames[n - 1].position[i][0] < 0) != (frames[n].position[i][0] < 0);
  }
  return count;
}

}  // namespace crossing

namespace pouring {

std::vector<Grain> loose_lattice() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1e-4, 1e-4), stir(-0.3, 0.3);
  std::vector<Grain> grains;
  for (int i = 0; i < side * side * side; ++i)
    grains.push_back(
        {.radius = radius,
         .position = {(i % side + 0.5) * spacing + shift(random), (i / side % side + 0.5) * spacing + shift(random),
                      (i / (side * side) + 0.5) * spacing},
         .velocity = {stir(random), stir(random), stir(random)}});
  return grains;
}

}  // namespace pouring

}  // namespace engines
