// The hot paths, one after the other, for callgrind to count the instructions of. Each is run once before it is
// counted, so that tables are made and symbols bound; what is being counted is told to callgrind by the requests of its
// header.
#include "../../bench/workloads.hpp"
#include "target_rows.hpp"

#include <calibrate/direct_calibrator.hpp>
#include <ricochet/contact/arms_block.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>
#include <ricochet/motion/engine/column_engine.hpp>

#include <valgrind/callgrind.h>

#include <cstdio>
#include <string>

using namespace ricochet;
using namespace ricochet::calibration;
using workloads::PressedColumn;

namespace {

// Whatever is computed goes here, so that it is computed.
volatile double sink;

/// `work` stands for so many operations. The dump is named "<name> <operations>".
template <class Work>
void count(const std::string& name, std::size_t operations, const Work& work) {
  CALLGRIND_TOGGLE_COLLECT;
  work();
  CALLGRIND_TOGGLE_COLLECT;
  const std::string label = name + " " + std::to_string(operations);
  CALLGRIND_DUMP_STATS_AT(label.c_str());
}

template <class Work>
void count_warm(const std::string& name, std::size_t operations, const Work& work) {
  work();
  count(name, operations, work);
}

void mittag_leffler_paths() {
  const auto prepared = [](const std::string& name, double a, double b, double low, double high) {
    const MittagLeffler e(a, b);
    const auto x = workloads::arguments(low, high);
    count_warm(name, x.size(), [&] {
      for (const double value : x) sink = e(value);
    });
  };
  const auto cold = [](const std::string& name, double a, double b, double low, double high) {
    const auto x = workloads::arguments(low, high);
    count_warm(name, x.size(), [&] {
      for (const double value : x) sink = mittag_leffler(a, b, value);
    });
  };
  prepared("mittag_leffler_near", 1.68, 1, -10, 0);
  prepared("mittag_leffler_far", 1.5, 1, -1e4, -16);
  prepared("mittag_leffler_small_a", 0.5, 1, -100, 5);
  cold("mittag_leffler_cold", 1.68, 1, -10, 0);
  cold("mittag_leffler_cold_any_b", 1.3, 0.7, -100, 0);
}

void direct_calibration() {
  const DirectCalibrator calibrator;
  const auto direct = [&](const std::string& name, LawKind law, ContactEnd end) {
    std::vector<Request> requests;
    for (const double en : workloads::arguments(0.01, 0.99, 500))
      requests.push_back({law, end, {1e-5 * (1 + en), en, {0.5, 7.06858e-6}}});
    count_warm(name, requests.size(), [&] {
      for (const Request& r : requests) sink = static_cast<double>(calibrator(r).index());
    });
  };
  direct("direct_linear", kind_of<Linear>, ContactEnd::force);
  direct("direct_hysteretic", kind_of<Hysteretic>, ContactEnd::force);
  direct("direct_kuwabara_kono", kind_of<KuwabaraKono>, ContactEnd::force);
  direct("direct_tsuji", kind_of<Tsuji>, ContactEnd::force);
  direct("direct_fractional", kind_of<Fractional>, ContactEnd::force);
}

void nlopt_calibration() {
  const auto nlopt = [](const std::string& name, LawKind law) {
    count_warm(name, 1, [&] {
      sink = static_cast<double>(
          ricochet::calibration::calibrate({law, ContactEnd::force, {1e-4, 0.5, {0.5, 7.06858e-6}}}).index());
    });
  };
  nlopt("nlopt_kuwabara_kono", kind_of<KuwabaraKono>);
  nlopt("nlopt_fractional", kind_of<Fractional>);
}

void target_rows() {
  const DirectCalibrator calibrator;
  const TargetRows rows("rows.csv", {"tcol,en", 1}, {}, calibrator);
  console::LineBlocks::Block block;
  const auto en = workloads::arguments(0.01, 0.99, 500);
  for (const double value : en) block.text += std::to_string(1e-3 * (1 + value)) + "," + std::to_string(value) + "\n";
  count_warm("targets_row_fractional", en.size(), [&] { sink = static_cast<double>(rows.answer(block).failed); });
}

void memory() {
  constexpr double step = 1e-6;
  count_warm("kernel_construction", 1, [] { sink = memory_kernel(0.3, step, 1000 * step, 1e-6).error(); });
  constexpr std::size_t contacts = 200, arms = 12;
  const FractionalArms law(Fractional(5000, 0.3, 0.3), workloads::kernel_of(arms, 0.3, step), step);
  const ArmsBlock block(law, step, arms, Instructions::baseline);
  const auto before = workloads::arguments(1e-6, 2e-6, contacts), after = workloads::arguments(2e-6, 3e-6, contacts);
  std::vector<double> elongation(contacts * arms), held(contacts);
  count_warm("arms_block_step", contacts,
             [&] { block.advance(contacts, elongation.data(), before.data(), after.data(), held.data()); });
}

template <class Law>
void column(const std::string& name, const Law& plate, const Law& pair) {
  constexpr std::size_t beads = 200;
  ColumnEngine<Law> engine(PressedColumn::of(beads), plate, pair, {.step = PressedColumn::step, .duration = 1});
  for (int i = 0; i < PressedColumn::first_steps; ++i) engine.step();
  count(name, beads * PressedColumn::pressed_steps, [&] {
    for (int i = 0; i < PressedColumn::pressed_steps; ++i) engine.step();
  });
}

void columns() {
  column("column_linear", PressedColumn::plate<Linear>(kind_of<Linear>), PressedColumn::pair<Linear>(kind_of<Linear>));
  const auto on_arms = [&]<class Law>(const std::string& name, std::type_identity<Law>) {
    column(name, workloads::on_12_arms(PressedColumn::plate<Law>(kind_of<Law>), PressedColumn::step),
           workloads::on_12_arms(PressedColumn::pair<Law>(kind_of<Law>), PressedColumn::step));
  };
  on_arms("column_fractional", std::type_identity<Fractional>{});
  on_arms("column_kelvin_voigt", std::type_identity<FractionalKelvinVoigt>{});
  on_arms("column_zener", std::type_identity<FractionalZener>{});
  on_arms("column_hertz", std::type_identity<FractionalHertz>{});
}

void cluster(const std::string& name, const ClusterSetup& setup) {
  Cluster cluster(setup, workloads::packing_options());
  cluster.advance(100);
  constexpr std::size_t steps = 20;
  // The number of contacts may change by one or two meanwhile.
  count(name, steps * cluster.contacts().size(), [&] { cluster.advance(steps); });
}

// As bodies of many sizes are told apart: an interaction for each pair of them, which is the same for all.
ClusterSetup each_of_its_own_material(ClusterSetup setup) {
  const Interaction how = setup.interactions.at({0, 0});
  for (std::size_t i = 0; i < setup.spheres.size(); ++i) {
    setup.spheres[i].material = i;
    for (std::size_t j = 0; j <= i; ++j) setup.interactions.insert({{j, i}, how});
  }
  return setup;
}

void clusters() {
  const auto packed = [](const AnyLaw& law, const Friction& friction,
                         const TangentialLaw& tangential = RigidTangential{}) {
    ClusterSetup setup = workloads::packing(5, 4, law, friction);
    setup.interactions.at({0, 0}).tangential = tangential;
    return setup;
  };
  const Friction smooth, rough(0.5, 0.5, 0, 0.1), sliding(0.5, 0.5, 0);
  const LinearTangential spring(3e4, 1);
  // Dashpots that the step resolves, as in packings that rebound; rigid friction sweeps whatever they are.
  cluster("cluster_linear", packed(Linear(1e5, 3), smooth));
  cluster("cluster_fractional", packed(Fractional(1e5, 3, 0.2), smooth));
  cluster("cluster_linear_friction", packed(Linear(1e5, 15), rough));
  cluster("cluster_linear_springs", packed(Linear(1e5, 3), sliding, spring));
  cluster("cluster_fractional_springs", packed(Fractional(1e5, 3, 0.2), sliding, spring));
  cluster("cluster_many_materials", each_of_its_own_material(packed(Linear(1e5, 3), sliding, spring)));
}

}  // namespace

int main() {
  mittag_leffler_paths();
  direct_calibration();
  nlopt_calibration();
  target_rows();
  memory();
  columns();
  clusters();
}
