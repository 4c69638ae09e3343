#pragma once

#include <verify/study.hpp>

#include <string>

namespace ricochet::verify {

/// Writes a study into the folder (made if missing): <name>.json, each table as <name>.csv, <name>-2.csv, …, and its
/// figures with their data. Each file is whole or absent. Throws as console::write_atomically and console::draw do.
void write_study(const Study& study, const StudyResult& result, const std::string& folder);

}  // namespace ricochet::verify
