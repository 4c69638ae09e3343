#pragma once

#include <materials.hpp>

#include <fstream>
#include <iterator>
#include <string>

/// A file of data/materials.
inline ricochet::calibration::Materials materials_of(const std::string& name) {
  const std::string path = RICOCHET_SOURCE_DIR "/data/materials/" + name;
  std::ifstream file(path);
  return ricochet::calibration::read_materials(path, {std::istreambuf_iterator<char>(file), {}});
}
