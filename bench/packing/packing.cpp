// Settles a packing and writes it for LIGGGHTS; times the steps of a packing that was written. See bench/packing/run.
#include "../workloads.hpp"

#include <ricochet/motion/cluster.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace ricochet;

// The grains of the table in docs/benchmarks.md: t_col 4e-4 s and e 0.5 between two of them.
constexpr double radius = 0.003, density = 2500, step = 8e-6, tcol = 4e-4, restitution = 0.5, mu = 0.5;

double grain_mass() { return Sphere{.radius = radius, .density = density}.mass(); }

struct Pair {
  double k, c;
};
Pair linear() {
  const double m = 0.5 * grain_mass(), loss = std::log(restitution), pi = std::acos(-1.0);
  return {m * (pi * pi + loss * loss) / (tcol * tcol), -2 * m * loss / tcol};
}

Interaction interaction_of(const std::string& kind) {
  const auto [k, c] = linear();
  const Friction friction(mu, mu, 0);
  const LinearTangential springs(2.0 / 7 * k, 2.0 / 7 * c);
  const std::map<std::string, Interaction> kinds{
      {"smooth", {.law = Linear(k, c)}},
      {"springs", {.law = Linear(k, c), .friction = friction, .tangential = springs}},
      {"fractional", {.law = Fractional(k, c, 0.2), .friction = friction, .tangential = springs}},
      {"rigid", {.law = Linear(k, c), .friction = friction}}};
  if (!kinds.contains(kind)) throw std::runtime_error("no such kind: " + kind);
  return kinds.at(kind);
}

struct Packing {
  std::vector<Vec3> positions;
  double side = 0, height = 0;  // of the box from the origin
};

ClusterSetup setup_of(const Packing& packing, const std::string& kind) {
  ClusterSetup setup;
  setup.gravity = {0, 0, -9.81};
  setup.interactions.insert({{0, 0}, interaction_of(kind)});
  setup.walls = box_walls({0, 0, 0}, {packing.side, packing.side, packing.height});
  for (const Vec3& x : packing.positions) setup.spheres.push_back({radius, density, x});
  return setup;
}

ClusterOptions options_of(double tolerance, int threads = 1, double h = step) {
  // What 12 arms reach over 1000 steps.
  return {.step = h,
          .longest_contact = 1000 * h,
          .kernel_tolerance = 2e-6,
          .solver_tolerance = tolerance,
          .records = false,
          .threads = threads};
}

// Grains thrown together a little apart, in layers as many as a side has.
Packing thrown(int count) {
  const int across = static_cast<int>(std::ceil(std::cbrt(count)));
  const double spacing = 2.15 * radius;
  Packing packing{.positions = {}, .side = across * spacing, .height = 3 * across * spacing};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.07 * radius, 0.07 * radius);
  for (int n = 0; n < count; ++n) {
    const int x = n % across, y = n / across % across, z = n / across / across;
    packing.positions.push_back({(x + 0.5) * spacing + jitter(random), (y + 0.5) * spacing + jitter(random),
                                 (z + 0.5) * spacing + jitter(random)});
  }
  return packing;
}

void write(const std::string& file, const Packing& packing) {
  std::ofstream out(file);
  out.precision(17);
  out << "a settled packing, for read_data of atom_style sphere\n\n"
      << packing.positions.size() << " atoms\n1 atom types\n";
  out << "0 " << packing.side << " xlo xhi\n0 " << packing.side << " ylo yhi\n0 " << packing.height
      << " zlo zhi\n\nAtoms\n\n";
  for (std::size_t i = 0; i < packing.positions.size(); ++i) {
    const Vec3 x = packing.positions[i];
    out << i + 1 << " 1 " << 2 * radius << ' ' << density << ' ' << x.x << ' ' << x.y << ' ' << x.z << '\n';
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

Packing read(const std::string& file) {
  std::ifstream in(file);
  std::string line, word;
  std::size_t atoms = 0;
  Packing packing;
  double low = 0;
  std::getline(in, line);
  in >> atoms >> word >> word >> word >> word;
  in >> low >> packing.side >> word >> word >> low >> packing.side >> word >> word >> low >> packing.height >> word >>
      word;
  in >> word;
  for (std::size_t i = 0; i < atoms; ++i) {
    double number = 0, type = 0, diameter = 0, rho = 0;
    Vec3 x;
    in >> number >> type >> diameter >> rho >> x.x >> x.y >> x.z;
    packing.positions.push_back(x);
  }
  if (!in) throw std::runtime_error("cannot read " + file);
  return packing;
}

// The same grains, springs and step in LIGGGHTS. Its hooke takes k from Young's modulus at a characteristic velocity,
// k = (16 a/15)^{4/5} (m v²)^{1/5}, a = sqrt(R*) Y*; k_t is 2/7 k there, c_t 2/7 c.
void deck(const std::string& file, int steps) {
  const Packing packing = read(file);
  constexpr double velocity = 1, poisson = 0.3;
  const double m = 0.5 * grain_mass();
  const double a = 15.0 / 16 * std::pow(linear().k / std::pow(m * velocity * velocity, 0.2), 1.25);
  const double young = 2 * (1 - poisson * poisson) * a / std::sqrt(0.5 * radius);
  std::printf(
      "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\n"
      "units si\nread_data %s\nneighbor %g bin\nneigh_modify delay 0\n"
      "fix m1 all property/global youngsModulus peratomtype %.17g\n"
      "fix m2 all property/global poissonsRatio peratomtype %g\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 1 %g\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 1 %g\n"
      "fix m5 all property/global characteristicVelocity scalar %g\n"
      "pair_style gran model hooke tangential history\npair_coeff * *\n"
      "timestep %g\nfix g all gravity 9.81 vector 0 0 -1\n",
      file.c_str(), radius / 3, young, poisson, restitution, mu, velocity, step);
  const double places[] = {0, packing.side, 0, packing.side, 0, packing.height};
  for (int n = 0; n < 6; ++n)
    std::printf("fix w%d all wall/gran model hooke tangential history primitive type 1 %cplane %.17g\n", n,
                "xyz"[n / 2], places[n]);
  std::printf("fix i all nve/sphere\nthermo %d\nrun %d\nrun %d\n", steps, steps, steps);
}

void settle(int count, const std::string& file, double seconds) {
  Packing packing = thrown(count);
  Cluster cluster(setup_of(packing, "springs"), options_of(1e-10));
  if (!cluster.advance(static_cast<std::uint64_t>(seconds / step))) throw std::runtime_error("diverged");
  for (std::size_t i = 0; i < cluster.size(); ++i) packing.positions[i] = cluster.position(i);
  const ClusterEnergy e = cluster.energy();
  std::fprintf(stderr, "%d grains: %zu contacts, kinetic energy %.2g of the greatest stored\n", count,
               cluster.contacts().size(), e.kinetic / e.stored);
  write(file, packing);
}

void run(const std::string& kind, const std::string& file, int steps, double tolerance, int threads) {
  Cluster cluster(setup_of(read(file), kind), options_of(tolerance, threads));
  cluster.advance(static_cast<std::uint64_t>(steps));  // springs load, sweeps find their first guess
  const std::uint64_t unconverged = cluster.state().unconverged;
  const std::clock_t start = std::clock();
  const auto begun = std::chrono::steady_clock::now();
  double sweeps = 0;
  for (int n = 0; n < steps; ++n) cluster.step(), sweeps += cluster.last_sweeps();
  const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - begun;
  const double taken = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%.4f %.4f %zu %.1f %llu\n", taken / steps, waited.count() / steps, cluster.contacts().size(),
              sweeps / steps, static_cast<unsigned long long>(cluster.state().unconverged - unconverged));
}

// How far from each other spheres are, in radii, by root mean square.
double apart(const Cluster& a, const Cluster& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 d = (a.position(i) - b.position(i)) / radius;
    sum += dot(d, d);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// What halving the step changes in a packing of springs and in one of rigid friction, and what a tolerance of the
// sweeps changes in this.
void accuracy(const std::string& file, double seconds) {
  const Packing packing = read(file);
  const auto after = [&](const std::string& kind, double tolerance, double h) {
    Cluster cluster(setup_of(packing, kind), options_of(tolerance, 1, h));
    cluster.advance(static_cast<std::uint64_t>(std::llround(seconds / h)));
    return cluster;
  };
  constexpr double exact = 1e-10;
  std::printf("springs, half the step %9.2e radii\n",
              apart(after("springs", exact, step / 2), after("springs", exact, step)));
  const Cluster best = after("rigid", exact, step);
  std::printf("rigid, half the step   %9.2e radii\n", apart(after("rigid", exact, step / 2), best));
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5})
    std::printf("rigid, %.0e           %9.2e radii\n", tolerance, apart(after("rigid", tolerance, step), best));
}

// Resident memory of the process [MB].
double resident() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, here = 0;
  statm >> all >> here;
  return here * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// What a grain costs where there are ever more of them: layers that lie on each other, held by springs.
void sizes() {
  std::printf("grains   contacts  ms a step  ns a grain  bytes a grain\n");
  for (const int across : {10, 22, 46, 100}) {
    const double before = resident();
    ClusterSetup setup = workloads::packing(across, across, Linear(1e5, 3), Friction(0.5, 0.5, 0));
    setup.interactions.at({0, 0}).tangential = LinearTangential(3e4, 1);
    ClusterOptions options = workloads::packing_options();
    options.records = false;
    Cluster cluster(setup, options);
    cluster.advance(100);
    constexpr int steps = 50;
    const std::clock_t start = std::clock();
    cluster.advance(steps);
    const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
    const auto grains = static_cast<double>(cluster.size());
    std::printf("%-8zu %8zu %10.4g %11.4g %14.4g\n", cluster.size(), cluster.contacts().size(), ms, 1e6 * ms / grains,
                1e6 * (resident() - before) / grains);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> a(argv + 1, argv + argc);
  try {
    if (a.size() == 4 && a[0] == "settle") {
      settle(std::stoi(a[1]), a[2], std::stod(a[3]));
      return 0;
    }
    if (a.size() == 3 && a[0] == "deck") {
      deck(a[1], std::stoi(a[2]));
      return 0;
    }
    if (a.size() == 6 && a[0] == "run") {
      run(a[1], a[2], std::stoi(a[3]), std::stod(a[4]), std::stoi(a[5]));
      return 0;
    }
    if (a.size() == 1 && a[0] == "sizes") {
      sizes();
      return 0;
    }
    if (a.size() == 3 && a[0] == "accuracy") {
      accuracy(a[1], std::stod(a[2]));
      return 0;
    }
    std::fputs(
        "packing settle COUNT FILE SECONDS | packing deck FILE STEPS | packing run KIND FILE STEPS TOLERANCE THREADS | "
        "packing accuracy FILE SECONDS | packing sizes\n",
        stderr);
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "packing: %s\n", e.what());
    return 4;
  }
}
