#pragma once

#include <simulate/scene.hpp>

#include <string>

namespace ricochet::simulate {

/// How a run ended.
enum class Outcome { complete, interrupted };

/// Runs the scene into `folder` (made if missing): trajectory.xyz, contacts.csv, energy.csv, and state.json, from which
/// `resume` continues to the same bytes as a run that was never stopped. SIGINT and SIGTERM stop between two steps,
/// everything written. Throws console::BadInput where the folder already holds a run (without `resume`), holds that of
/// another scene, or cannot be written; console::Failed where the motion is no longer finite.
Outcome run(const Scene& scene, const std::string& folder, bool resume);

}  // namespace ricochet::simulate
