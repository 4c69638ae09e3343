#pragma once

#include <console/exit.hpp>
#include <simulate/scene.hpp>

#include <regex>
#include <string>

/// What is said of a scene that cannot be, without the place in its file; "accepted" of another.
inline std::string complaint_of(const std::string& scene) {
  try {
    ricochet::simulate::read_scene("s.json", scene);
  } catch (const ricochet::console::BadInput& error) {
    return std::regex_replace(std::string(error.what()), std::regex("^s\\.json:\\d+:\\d+: "), "");
  }
  return "accepted";
}
