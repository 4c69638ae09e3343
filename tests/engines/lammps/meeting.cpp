#include "meeting.hpp"

#include <catch2/catch.hpp>

namespace engines::meeting {

std::string with(const Workplace& place, const std::string& styles, double step) {
  return preamble(box) + place.create(grains, box) + neighbours() + styles + move(step);
}

std::string said(const std::string& name, const std::string& styles, const std::string& last, int code, double step) {
  const Workplace place(name);
  CHECK(place.run(with(place, styles, step) + last) == code);
  return place.output();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace engines::meeting
