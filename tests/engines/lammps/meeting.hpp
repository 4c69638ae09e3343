#pragma once

#include "deck.hpp"

#include <string>
#include <vector>

namespace engines {

/// Two grains that meet head-on 60 steps after the start: decks by which a driver is asked what it says.
namespace meeting {
inline constexpr double tcol = 1e-4, en = 0.5, dt = tcol / 50, speed = 0.5;
inline const Box box{{-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}};
inline const std::vector<Grain> grains{{.position = {-1.53e-3, 0, 0}, .velocity = {speed / 2, 0, 0}},
                                       {.position = {1.53e-3, 0, 0}, .velocity = {-speed / 2, 0, 0}}};

/// The deck as far as its first run.
std::string with(const Workplace& place, const std::string& styles, double step = dt);
/// What is said of it with these last commands; it must end with that code.
std::string said(const std::string& name, const std::string& styles, const std::string& last, int code = 0,
                 double step = dt);
bool contains(const std::string& text, const std::string& part);
}  // namespace meeting

}  // namespace engines
