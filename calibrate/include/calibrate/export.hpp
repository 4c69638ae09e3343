#pragma once

#include <ricochet/contact/laws.hpp>
#include <ricochet/contact/tangential.hpp>
#include <ricochet/collision/collision.hpp>

#include <cstddef>
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
/// Our program that runs the laws with a memory in this engine, "lammps-ricochet"; "" where there is none.
std::string_view driver(Engine engine) noexcept;
/// The engine of this name, or of this driver.
std::optional<Engine> engine_run_by(std::string_view program) noexcept;

/// The tangential part of a contact as engines have it: a spring and dashpot under Coulomb's limit.
struct TangentialPart {
  TangentialLaw law = RigidTangential{};  ///< no engine runs the rigid one
  double mu = 0;                          ///< whether it sticks or slides
};

/// One contact between grains, with what an engine wants to know beside the law's parameters.
struct ExportCase {
  AnyLaw law;
  ContactEnd end;
  double tcol = 0, en = 0;                ///< the target [s], [–]
  Impact impact;                          ///< at which it was calibrated
  std::optional<double> radius_eff = {};  ///< r₁r₂/(r₁+r₂) [m], wall: r₁; the Hertzian laws of most engines need it
  std::optional<double> density = {};  ///< of the grains [kg/m³], where the engine's material carries it
  std::optional<TangentialPart> tangential = {};
};

/// Bodies of one kind: grains of one size and material, or walls.
struct BodyKind {
  std::string name;  ///< letters, digits and _, as engines' own names are
  bool wall = false;
  std::optional<double> density = {};  ///< [kg/m³], where the engine's material carries it
  double poisson = 0.3;                ///< where an engine's material wants it; no influence on these normal forces
};

/// A contact between bodies of two kinds (or of the same) as it was calibrated.
struct PairCase {
  std::size_t a = 0, b = 0;  ///< places in ContactSet::kinds; a wall is never a
  AnyLaw law;
  double tcol = 0, en = 0;                        ///< the target [s], [–]
  Impact impact;                                  ///< at which it was calibrated; against a wall of the grain's mass
  std::optional<double> radius_eff = {};          ///< r₁r₂/(r₁+r₂) [m], wall: r₁
  std::optional<TangentialPart> tangential = {};  ///< without: frictionless
};

/// Every contact that an engine has to know of, all under one kind of law that ends one way, and one kind of tangential
/// law or none.
struct ContactSet {
  ContactEnd end = ContactEnd::force;
  std::vector<BodyKind> kinds = {};  ///< grains first: the engines number their types so
  std::vector<PairCase> pairs = {};  ///< not empty; the first is what was asked for
  /// The same contacts at other sizes of grain, under the law that the first size's numbers make of them: with any, the
  /// numbers are chosen to keep e_n for every size where the engine can, and the time step serves them all.
  std::vector<PairCase> other_sizes = {};
  std::vector<std::string> notes = {};  ///< what else to tell of them, a sentence each
  /// The time step that the contacts were made for [s]; without, the file has the one that keeps their e_n.
  std::optional<double> step = {};
};

enum class Fidelity {
  exact,   ///< the engine runs this very law, at the pairs that it was calibrated for
  close,   ///< it runs another law; Snippet::gives says what comes out along the normal at this impact
  absent,  ///< it can't: the snippet holds comments alone
};
std::string_view text(Fidelity fidelity) noexcept;

/// One law in the language of one engine, SI units, ready to be included.
struct Snippet {
  Engine engine;
  AnyLaw law;  ///< of the first pair
  ContactEnd end;
  Fidelity fidelity;
  std::vector<Collision> gives;      ///< what the engine's law does at each pair's impact; empty when absent
  std::vector<std::string> remarks;  ///< conventions and limits, one sentence each; in `text` as comments
  std::string text;
  double off = 0;  ///< how far `gives` are from what was asked: the greatest share of tcol, difference of en
};

/// Writes the snippet of a set of contacts: the law of every pair of grains and what makes each kind of wall.
/// Throws std::invalid_argument for values outside their domain, laws of several kinds, or no pair.
Snippet export_contacts(Engine engine, const ContactSet& set);

/// The same of one contact between grains of one kind.
Snippet export_law(Engine engine, const ExportCase& what);

/// Whether the engine runs the law of this contact and ends it so; the text of the snippet says no more of it.
bool runs(Engine engine, const ExportCase& what);

/// `sentence` as comment lines of the engine's language.
std::string comment(Engine engine, std::string_view sentence);

/// Several snippets as one file that can be included: the first that is exact stays active, or else that of the close
/// ones that is least off (to 0.1 %, within which the first counts); the others are commented out.
std::string combine(const std::vector<Snippet>& snippets);

}  // namespace ricochet::calibration
