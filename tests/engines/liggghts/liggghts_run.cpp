#include "liggghts_run.hpp"

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

}  // namespace engines
