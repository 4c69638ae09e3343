#include "deck_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace engines {

namespace fs = std::filesystem;

double Grain::mass() const { return 4 * std::numbers::pi / 3 * radius * radius * radius * density; }

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

Workplace::Workplace(const std::string& name)
    : folder_(runs_folder() / (name + "." + std::to_string(static_cast<long>(::getpid())))) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

Workplace::~Workplace() {
  std::error_code left;  // a folder that stays harms nobody
  fs::remove_all(folder_, left);
}

int Workplace::run(const std::string& deck, int ranks) const {
  std::ofstream(file("in.deck")) << deck;
  const std::string command = "cd '" + folder_.string() + "' && " + engine_command(ranks) + " > out.txt 2>&1";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::string Workplace::output() const {
  std::ifstream in(file("out.txt"));
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string Workplace::create(const std::vector<Grain>& grains, const Box& box, const std::string& name) const {
  std::ofstream out(file(name));
  out << "grains\n\n" << grains.size() << " atoms\n" << box.types << " atom types\n";
  const char* axis = "xyz";
  for (int d = 0; d < 3; ++d)
    out << number(box.low[d]) << ' ' << number(box.high[d]) << ' ' << axis[d] << "lo " << axis[d] << "hi\n";
  const auto write = [&out](const Vector& v) { out << number(v[0]) << ' ' << number(v[1]) << ' ' << number(v[2]); };
  out << "\nAtoms\n\n";
  for (std::size_t i = 0; i < grains.size(); ++i) {
    out << i + 1 << ' ' << grains[i].type << ' ' << number(2 * grains[i].radius) << ' ' << number(grains[i].density)
        << ' ';
    write(grains[i].position);
    out << '\n';
  }
  out << "\nVelocities\n\n";
  for (std::size_t i = 0; i < grains.size(); ++i) {
    out << i + 1 << ' ';
    write(grains[i].velocity);
    out << " 0 0 0\n";
  }
  return "read_data " + name + "\n";
}

std::vector<Frame> Workplace::frames(const std::string& dump) const {
  std::ifstream in(file(dump));
  std::vector<Frame> all;
  std::string line;
  while (std::getline(in, line)) {
    if (line != "ITEM: TIMESTEP") continue;
    Frame frame;
    std::size_t count = 0;
    in >> frame.step;
    while (std::getline(in, line) && line != "ITEM: NUMBER OF ATOMS") {
    }
    in >> count;
    while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
    }
    frame.position.resize(count), frame.velocity.resize(count), frame.force.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      long id = 0;
      in >> id;
      for (auto* values : {&frame.position[i], &frame.velocity[i], &frame.force[i]})
        for (double& value : *values) in >> value;
    }
    if (!in) throw std::runtime_error("cannot read the dump " + file(dump).string());
    all.push_back(std::move(frame));
  }
  return all;
}

std::string dump_command(const std::string& file, int every, const std::string& format) {
  std::string text = "dump " + file + " all custom " + std::to_string(every) + ' ' + file +
                     " id x y z vx vy vz fx fy fz\ndump_modify " + file + " sort id " + format + " \"%d";
  for (int i = 0; i < 9; ++i) text += " %.17g";
  return text + "\"\n";
}

double largest_difference(const std::vector<Frame>& a, const std::vector<Frame>& b) {
  if (a.empty() || a.size() != b.size()) throw std::runtime_error("runs of different length");
  double worst = 0;
  for (auto kind : {&Frame::position, &Frame::velocity, &Frame::force}) {
    double difference = 0, largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
      for (std::size_t i = 0; i < (a[n].*kind).size(); ++i)
        for (int d = 0; d < 3; ++d) {
          difference = std::max(difference, std::fabs((a[n].*kind)[i][d] - (b[n].*kind)[i][d]));
          largest = std::max(largest, std::fabs((a[n].*kind)[i][d]));
        }
    if (largest > 0) worst = std::max(worst, difference / largest);
  }
  return worst;
}

}  // namespace engines
