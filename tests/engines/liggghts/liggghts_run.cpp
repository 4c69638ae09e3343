#include "liggghts_run.hpp"

#include <array>
#include <fstream>

namespace engines {

std::vector<Model> our_models() {
  const std::string scalar = "fix velocity all property/global characteristicVelocity scalar 0.5\n";
  return {{"fractional", ""}, {"fractional-kelvin-voigt", ""}, {"fractional-hertz", scalar}, {"fractional-zener", ""}};
}

std::string preamble(const Box& box, const std::string& processors) {
  return "units si\natom_style granular\natom_modify map array\nboundary " + std::string(box.boundary) +
         "\nnewton off\ncommunicate single vel yes\nprocessors " + processors + "\n";
}

std::string pair_property(const std::string& name, const std::vector<std::vector<double>>& matrix) {
  std::string text =
      "fix " + name + " all property/global " + name + " peratomtypepair " + std::to_string(matrix.size());
  for (const auto& row : matrix)
    for (double value : row) text += ' ' + number(value);
  return text + '\n';
}

std::string pair_property(const std::string& name, double value, int types) {
  return pair_property(name, std::vector<std::vector<double>>(types, std::vector<double>(types, value)));
}

std::string dump_command(const std::string& file, int every) { return dump_command(file, every, "format"); }

void write_square(const std::filesystem::path& file, double low, double high) {
  using Corner = std::array<double, 2>;
  const Corner a{low, low}, b{high, low}, c{high, high}, d{low, high};
  std::ofstream out(file);
  out << "solid square\n";
  for (const auto& triangle : {std::array{a, b, c}, std::array{a, c, d}}) {
    out << "facet normal 1 0 0\nouter loop\n";
    for (const Corner& corner : triangle) out << "vertex 0 " << number(corner[0]) << ' ' << number(corner[1]) << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid square\n";
}

}  // namespace engines
