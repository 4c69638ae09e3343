#pragma once

#include "../runs/deck_run.hpp"

#include <string>
#include <vector>

namespace engines {

/// Settings that every deck starts with.
std::string preamble(const Box& box, const std::string& processors = "* 1 1");
/// Grains as `Workplace::create` wrote them, or any others, with their neighbour list.
std::string neighbours(const std::string& skin = "0.0005", const std::string& rebuilds = "delay 0");
/// `target T_COL E_N`.
std::string target(double tcol, double en);
/// `pair_style fractional` with one law for all.
std::string pair_style(const std::string& law, const std::string& settings = "");
/// Two planes across an axis, "NULL" for one that is not there.
std::string walls(const std::string& axis, const std::string& low, const std::string& high, const std::string& law,
                  const std::string& settings = "");
std::string move(double dt);
std::string dump(const std::string& file, int every = 1);
std::string run(int steps);

}  // namespace engines
