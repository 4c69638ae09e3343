#include <simulate/run.hpp>

#include "inflow.hpp"
#include "outputs.hpp"
#include "state_file.hpp"
#include "vtk.hpp"

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/progress.hpp>
#include <console/signals.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>

namespace ricochet::simulate {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Below it, what the memory of a fractional contact leaves out is small against what the time steps do.
constexpr double unspoken_kernel_error = 1e-6;

/// Of the first of run_files a state, which is the last, knows the lengths.
constexpr std::size_t growing = run_files.size() - 1;

std::string in(const std::string& folder, std::size_t file) { return folder + "/" + run_files.at(file); }

// Checked before anything is written.
Cluster prepared(const Scene& scene) {
  ClusterOptions options = scene.options;
  double smallest = 0;
  for (std::size_t k = 0; k < scene.sphere_count(); ++k)
    if (const double r = scene.sphere(k).radius; k == 0 || r < smallest) smallest = r;
  if (options.skin == 0) options.skin = smallest / 3;  // also of those that come later
  Cluster cluster(scene.setup, options);
  if (!std::isfinite(cluster.energy().total()))
    throw console::Failed("t = 0: the energy of the spheres is no longer a number; slower or lighter ones are needed");
  return cluster;
}

class Run {
 public:
  Run(const Scene& scene, Cluster cluster, const std::string& folder, const std::optional<Checkpoint>& from,
      Format format)
      : scene_(scene),
        roster_(scene),
        inflow_(scene),
        state_path_(in(folder, growing)),
        cluster_(std::move(cluster)),
        trajectory_(in(folder, 0), from ? from->lengths[0] : 0),
        contacts_(in(folder, 1), from ? from->lengths[1] : 0),
        energy_(in(folder, 2), from ? from->lengths[2] : 0) {
    if (format == Format::vtk)
      vtk_.emplace(folder + "/vtk", scene, from ? from->state.steps / scene.output_every + 1 : 0);
    if (from) {
      take_up(*from);
    } else {
      contacts_.append(contact_header());
      energy_.append(energy_header());
      output();
      save(false);  // whatever comes, what is there can be resumed
    }
  }

  int go(const std::function<void()>& begun) {
    begun();
    report_kernel();
    console::Progress progress("simulate", scene_.steps - cluster_.steps());
    auto saved = Clock::now();
    while (cluster_.steps() < scene_.steps) {
      if (const int signal = console::StopOnSignal::noted()) return save(false), report(), signal;
      step();
      progress.advance();
      if (Clock::now() - saved > std::chrono::seconds(10)) save(false), saved = Clock::now();
    }
    for (const ContactState& c : cluster_.contacts()) contacts_.append(contact_row(roster_, c.record));
    save(true);
    report();
    return 0;
  }

 private:
  // Who is there before what they do.
  void take_up(const Checkpoint& from) {
    Roster now = roster_;
    now.who() = from.present;
    if (now.who() != roster_.who()) {
      std::vector<std::uint32_t> all(cluster_.size());
      std::iota(all.begin(), all.end(), 0u);
      std::vector<Sphere> spheres;
      spheres.reserve(now.size());
      for (std::size_t k = 0; k < now.size(); ++k) spheres.push_back(now.sphere(k));
      cluster_.remove(all);
      cluster_.add(spheres);
      roster_ = now;
    }
    inflow_.set_brought(from.brought);
    cluster_.restore(from.state);
    cluster_.take_finished();
    if (!std::isfinite(cluster_.energy().total()))
      throw console::BadInput(state_path_ + ": the energy of its spheres is no number; start again without --resume");
  }

  void note_finished() {
    for (const Encounter& e : cluster_.take_finished()) contacts_.append(contact_row(roster_, e));
  }

  void come_and_go() {
    if (const auto leaving = inflow_.leaving(cluster_); !leaving.empty()) {
      cluster_.remove(leaving);
      note_finished();  // by the numbers that they had
      Inflow::strike(leaving, roster_);
    }
    inflow_.bring(cluster_, roster_);
  }

  void step() {
    if (!cluster_.advance(1) || !std::isfinite(cluster_.energy().total()))
      throw console::Failed(
          fmt::format("t = {} s: the motion is no longer finite; a smaller \"step\" is needed. All before is written",
                      console::significant(cluster_.time(), 6)));
    if (const auto through = cluster_.breakthrough()) report(*through);
    note_finished();
    if (inflow_.due(cluster_.steps())) come_and_go();
    const std::uint64_t done = cluster_.steps();
    if (done % scene_.output_every == 0 || done == scene_.steps) output();
  }

  [[noreturn]] void report(const Breakthrough& through) const {
    const auto& [i, j, speed, depth] = through;
    const std::string what =
        i == j ? fmt::format("body {} moves by more than its radius in a step, at {} m/s: a smaller \"step\" is needed",
                             roster_.name(i), console::significant(speed, 3))
               : fmt::format(
                     "bodies {} and {} have gone into each other by more than {}, at {} m/s: a stiffer law, or slower "
                     "bodies, are needed",
                     roster_.name(i), roster_.name(j), depth == 1 ? "a radius" : fmt::format("{} radii", depth),
                     console::significant(speed, 3));
    throw console::Failed(
        fmt::format("t = {} s: {}. All before is written", console::significant(cluster_.time(), 6), what));
  }

  void report_kernel() const {
    const double error = cluster_.kernel_error();
    if (error <= unspoken_kernel_error) return;
    console::complain(
        "simulate",
        fmt::format("the memory of fractional contacts of up to {} s is kept to {} of its kernel; "
                    "docs/scenes.md says why",
                    console::significant(scene_.options.longest_contact, 3), console::significant(error, 2)));
  }

  void report() const {
    if (const std::uint64_t waiting = inflow_.waiting(cluster_.time()); waiting > 0)
      console::complain("simulate",
                        fmt::format("{} spheres that were to be poured by now have found no room", waiting));
    const ClusterState s = cluster_.state();
    if (s.unconverged == 0) return;
    console::complain(
        "simulate",
        fmt::format("{} of {} steps ended after {} sweeps over the contacts, when impulses still changed "
                    "by up to {} of the greatest, not by {}; docs/scenes.md says what that means",
                    s.unconverged, s.steps, scene_.options.max_sweeps, console::significant(s.worst_change, 2),
                    console::significant(scene_.options.solver_tolerance, 2)));
  }

  void output() {
    trajectory_.append(frame_xyz(scene_, roster_, cluster_));
    if (vtk_) vtk_->add(frame_vtk(scene_, roster_, cluster_), cluster_.time());
    energy_.append(energy_row(cluster_));
  }

  // Outputs first, then the state that says how long they are: whenever the program dies, the state fits.
  void save(bool complete) {
    const Checkpoint c{{trajectory_.flush(), contacts_.flush(), energy_.flush()},
                       complete,
                       vtk_ ? Format::vtk : Format::xyz,
                       roster_.who(),
                       inflow_.brought(),
                       cluster_.state()};
    console::write_atomically(state_path_, write_checkpoint(scene_, c));
    for (GrowingFile* file : {&trajectory_, &contacts_, &energy_}) file->keep();
    if (vtk_) vtk_->keep();
  }

  const Scene& scene_;
  Roster roster_;
  Inflow inflow_;
  std::string state_path_;
  Cluster cluster_;
  GrowingFile trajectory_, contacts_, energy_;
  std::optional<VtkFolder> vtk_;
};

}  // namespace

int run(const Scene& scene, const std::string& folder, bool resume, const std::function<void()>& begun, Format format) {
  const console::StopOnSignal signals;  // from here on: a stop while memory kernels are built leaves a state as well
  const std::string state = in(folder, growing);
  if (!resume) {
    // A link that leads nowhere is there as well.
    const auto there = [&](const std::string& path) {
      std::error_code error;
      return fs::exists(fs::symlink_status(path, error));
    };
    if (there(state))
      throw console::BadInput(
          fmt::format("-o {}: holds a run already; --resume goes on with it, another folder starts anew", folder));
    for (const char* const name : {run_files[0], run_files[1], run_files[2], "vtk"})
      if (there(folder + "/" + name))
        throw console::BadInput(
            fmt::format("-o {}: holds {} without the state.json of a run; another folder keeps it", folder, name));
    Cluster cluster = prepared(scene);
    const console::MadeFolder made(folder);
    return Run(scene, std::move(cluster), folder, {}, format).go(begun);
  }
  const Checkpoint from = read_checkpoint(state, console::read_input(state), scene);
  for (std::size_t k = 0; k < growing; ++k) require_written(in(folder, k), from.lengths[k]);
  if (from.complete) return 0;
  return Run(scene, prepared(scene), folder, from, from.format).go(begun);
}

}  // namespace ricochet::simulate
