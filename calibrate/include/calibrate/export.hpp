#pragma once

#include <ricochet/contact/any_law.hpp>
#include <ricochet/collision/collision.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::calibration {

/// The engines whose input language we write. docs/engines.md has their conventions and where they were read.
enum class Engine { liggghts, lammps, yade, mercurydpm, mfix };

std::span<const Engine> engines() noexcept;
/// "liggghts", "lammps", …: the words of `calibrate --export`.
std::string_view text(Engine engine) noexcept;
std::optional<Engine> engine_named(std::string_view word) noexcept;
/// Name and version whose conventions the snippets follow.
std::string_view version(Engine engine) noexcept;

/// A law as it was calibrated, with what an engine wants to know beside its parameters.
struct ExportCase {
  AnyLaw law;
  ContactEnd end;
  double tcol, en;                        ///< the target [s], [–]
  Impact impact;                          ///< at which it was calibrated
  std::optional<double> radius_eff = {};  ///< r₁r₂/(r₁+r₂) [m], wall: r₁; the Hertzian laws of most engines need it
  std::optional<double> density = {};  ///< of the grains [kg/m³], where the engine's material carries it
};

enum class Fidelity {
  exact,   ///< the engine runs this very law, at the pair that it was calibrated for
  close,   ///< it runs another law; Snippet::gives says what comes out at this impact
  absent,  ///< it can't: the snippet holds comments alone
};
std::string_view text(Fidelity fidelity) noexcept;

/// One law in the language of one engine, SI units, ready to be included.
struct Snippet {
  Engine engine;
  AnyLaw law;
  ContactEnd end;
  Fidelity fidelity;
  Collision gives;                   ///< what the engine's law does at the case's impact; not separated when absent
  std::vector<std::string> remarks;  ///< conventions and limits, one sentence each; in `text` as comments
  std::string text;
};

/// Writes the snippet. Throws std::invalid_argument for values outside their domain.
Snippet export_law(Engine engine, const ExportCase& what);

/// `sentence` as comment lines of the engine's language.
std::string comment(Engine engine, std::string_view sentence);

/// Several snippets as one file that can be included: the first that is exact (or else close) stays active, the
/// others are commented out.
std::string combine(const std::vector<Snippet>& snippets);

}  // namespace ricochet::calibration
