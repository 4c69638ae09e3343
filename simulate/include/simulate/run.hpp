#pragma once

#include <simulate/scene.hpp>

#include <array>
#include <functional>
#include <string>

namespace ricochet::simulate {

/// What trajectories are written as: extended XYZ always, VTK beside it.
enum class Format { xyz, vtk };

/// What a run writes into its folder.
inline constexpr std::array run_files{"trajectory.xyz", "contacts.csv", "energy.csv", "state.json"};

/// Runs the scene into `folder` (made if missing): run_files, of which `resume`, by state.json, continues to the same
/// bytes as a run that was never stopped. SIGINT, SIGTERM and SIGHUP stop between two steps, everything written; so
/// does a motion that is no longer finite (console::Failed), but for the steps since the last save. Returns 0 when
/// complete, else the signal that stopped it. Says on stderr where fractional memories are kept less well than to 1e-6
/// and how many steps' impulses did not settle. Throws console::BadInput where the folder already holds a run (without
/// `resume`), holds that of another scene, or cannot be written; console::CannotWrite when the disk is full, whole
/// records left. A run that could not begin leaves nothing. `begun` is called once the folder is ready and the run
/// begins.
int run(
    const Scene& scene, const std::string& folder, bool resume, const std::function<void()>& begun = [] {},
    Format format = Format::xyz);

}  // namespace ricochet::simulate
