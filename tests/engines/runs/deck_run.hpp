#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace engines {

using Vector = std::array<double, 3>;

struct Grain {
  int type = 1;
  double radius = 1.5e-3;  ///< [m]
  double density = 1000;   ///< [kg/m³]
  Vector position{}, velocity{};

  double mass() const;
};

/// Where the grains are at one time step, by increasing id; ids count from 1 in the order of the grains.
struct Frame {
  long step = 0;
  std::vector<Vector> position, velocity, force;
};

struct Box {
  Vector low, high;
  const char* boundary = "f f f";
  int types = 1;
};

/// How an engine of the LAMMPS family is called: each test program defines them for its own.
std::string engine_command(int ranks);  ///< that runs in.deck in the present folder
std::filesystem::path runs_folder();

/// A folder of its own in which decks are run by the driver with one of our models: also of its process's own, as two
/// may run the same test. It goes when the workplace does.
class Workplace {
 public:
  explicit Workplace(const std::string& name);
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Runs the deck; returns the exit code. Output is in out.txt.
  int run(const std::string& deck, int ranks = 1) const;
  std::string output() const;
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  /// Writes the grains as the data file `name`, with the commands that read it and set their velocities.
  std::string create(const std::vector<Grain>& grains, const Box& box, const std::string& name = "grains.data") const;

  std::vector<Frame> frames(const std::string& dump) const;

 private:
  std::filesystem::path folder_;
};

/// Positions, velocities and forces at full precision each `every` steps into `file`; `format` is the engine's keyword.
std::string dump_command(const std::string& file, int every, const std::string& format);
std::string number(double value);

/// Largest difference of positions, velocities and forces between two runs, each over the largest of its kind.
double largest_difference(const std::vector<Frame>& a, const std::vector<Frame>& b);

}  // namespace engines
