#include "body.hpp"

#include <calibrate/calibration.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::calibration {

namespace {

struct Language {
  Engine engine;
  std::string_view name, version, comment;
  Body (*write)(const ExportCase&);
};

constexpr std::array<Language, 5> languages{{
    {Engine::liggghts, "liggghts", "LIGGGHTS 3.8.0", "# ", write_liggghts},
    {Engine::lammps, "lammps", "LAMMPS 29 Sep 2021 Update 2", "# ", write_lammps},
    {Engine::yade, "yade", "Yade 2023.02a", "# ", write_yade},
    {Engine::mercurydpm, "mercurydpm", "MercuryDPM, revision of July 2024", "// ", write_mercurydpm},
    {Engine::mfix, "mfix", "MFiX 25.2.1", "! ", write_mfix},
}};

const Language& language(Engine engine) { return languages[std::size_t(engine)]; }

void check(const ExportCase& what) {
  support::require_positive("tcol", what.tcol);
  support::require(what.en > 0 && what.en <= 1, "en", what.en, "in (0, 1]");
  support::require_positive("velocity", what.impact.velocity);
  support::require_positive("mass_eff", what.impact.mass_eff);
  if (what.radius_eff) support::require_positive("radius_eff", *what.radius_eff);
  if (what.density) support::require_positive("density", *what.density);
}

/// "k = 7316 kg/s^2, c = 0.098 kg/s"
std::string in_words(const AnyLaw& law) {
  std::vector<std::string> words;
  for (const NamedValue& p : parameters(law))
    words.push_back(fmt::format("{} = {}{}{}", p.name, shortest(p.value), p.unit.empty() ? "" : " ", p.unit));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// "0.55 (+10 %)": a value beside the one asked for.
std::string beside(double value, double asked) {
  const double percent = 100 * (value / asked - 1);
  return fmt::format("{} ({}{} %)", rounded(value), percent < 0 ? "" : "+", support::significant(percent, 2));
}

/// Breaks a sentence into comment lines of at most 100 columns.
void append_comment(std::string& text, std::string_view mark, std::string_view sentence) {
  constexpr std::size_t width = 100;
  while (!sentence.empty()) {
    std::size_t cut = sentence.size();
    if (mark.size() + cut > width) {
      cut = sentence.rfind(' ', width - mark.size());
      if (cut == std::string_view::npos) cut = std::min(sentence.find(' '), sentence.size());
    }
    text += fmt::format("{}{}\n", mark, sentence.substr(0, cut));
    sentence.remove_prefix(std::min(cut + 1, sentence.size()));
  }
}

std::string heading(const Language& in, const ExportCase& what) {
  std::string lines;
  append_comment(lines, in.comment,
                 fmt::format("Ricochet: {} law, contact ended by {}, for {}, SI units", name(what.law), text(what.end),
                             in.version));
  std::string pair =
      fmt::format("Target: collision time {} s, restitution {} at {} m/s, effective mass {} kg", shortest(what.tcol),
                  shortest(what.en), shortest(what.impact.velocity), shortest(what.impact.mass_eff));
  if (what.radius_eff) pair += fmt::format(", effective radius {} m", shortest(*what.radius_eff));
  append_comment(lines, in.comment, pair);
  append_comment(lines, in.comment, fmt::format("Law: {}", in_words(what.law)));
  return lines;
}

std::string what_it_gives(const Collision& gives, const ExportCase& what) {
  if (!gives.separated()) return "GIVES INSTEAD: a contact that never separates";
  return fmt::format("GIVES INSTEAD: collision time {} s, restitution {}", beside(gives.tcol, what.tcol),
                     beside(gives.en, what.en));
}

}  // namespace

std::span<const Engine> engines() noexcept {
  static constexpr std::array all{Engine::liggghts, Engine::lammps, Engine::yade, Engine::mercurydpm, Engine::mfix};
  return all;
}

std::string_view text(Engine engine) noexcept { return language(engine).name; }
std::string_view version(Engine engine) noexcept { return language(engine).version; }

std::optional<Engine> engine_named(std::string_view word) noexcept {
  for (const Language& l : languages)
    if (l.name == word) return l.engine;
  return std::nullopt;
}

std::string_view text(Fidelity fidelity) noexcept {
  constexpr std::string_view words[] = {"exact", "close", "absent"};
  return words[std::size_t(fidelity)];
}

Snippet export_law(Engine engine, const ExportCase& what) {
  check(what);
  const Language& in = language(engine);
  Body body = in.write(what);
  Snippet snippet{engine, what.law, what.end, body.fidelity, {}, body.remarks, heading(in, what)};
  if (body.fidelity != Fidelity::absent)
    snippet.gives = collide(what.law, what.impact, {.end = body.other_end.value_or(what.end)});
  if (body.other_end) {
    append_comment(snippet.text, in.comment, what_it_gives(snippet.gives, what));
    if (!snippet.gives.separated()) {
      snippet.fidelity = Fidelity::absent;
      body.input.clear();
    }
  }
  for (const std::string& remark : body.remarks) append_comment(snippet.text, in.comment, remark);
  snippet.text += body.input;
  return snippet;
}

std::string comment(Engine engine, std::string_view sentence) {
  std::string text;
  append_comment(text, language(engine).comment, sentence);
  return text;
}

std::string combine(const std::vector<Snippet>& snippets) {
  const auto has = [](Fidelity f) { return [f](const Snippet& s) { return s.fidelity == f; }; };
  auto active = std::find_if(snippets.begin(), snippets.end(), has(Fidelity::exact));
  if (active == snippets.end()) active = std::find_if(snippets.begin(), snippets.end(), has(Fidelity::close));
  std::string all;
  for (auto it = snippets.begin(); it != snippets.end(); ++it) {
    if (it != snippets.begin()) all += "\n";
    const std::string mark(language(it->engine).comment);
    std::size_t from = 0;
    while (from < it->text.size()) {
      const std::size_t to = it->text.find('\n', from) + 1;
      const std::string line = it->text.substr(from, to - from);
      all += (it == active || line.starts_with(mark) ? "" : mark) + line;
      from = to;
    }
  }
  return all;
}

Body absent(std::string why) { return {.remarks = {std::move(why)}}; }

Body no_such_law(std::string_view engine, std::string_view law) {
  return absent(fmt::format("NOT WRITTEN: {} has no {} law.", engine, law));
}

Body no_memory(std::string_view engine) {
  return absent(
      fmt::format("NOT WRITTEN: {} has no law with memory; LIGGGHTS runs it through liggghts-ricochet.", engine));
}

Body needs_radius() {
  return absent(
      "NOT WRITTEN: this law's input depends on the grains' radius here. Give --radius and --density "
      "instead of --mass-eff.");
}

std::string tied_to_pair() {
  return "The numbers hold for pairs of this effective mass and radius; other sizes get another law.";
}

std::string keeps_restitution() {
  return "Pairs of other masses and radii keep the restitution; their collision time follows from the same material.";
}

double effective_modulus(double hertz_stiffness, double radius_eff) {
  return 0.75 * hertz_stiffness / std::sqrt(radius_eff);
}

double youngs_modulus(double modulus, double nu) { return 2 * (1 - nu * nu) * modulus; }

std::optional<double> logarithmic_restitution(double damping_ratio) {
  if (damping_ratio >= 1) return std::nullopt;
  return restitution_of_damping(damping_ratio, ContactEnd::overlap);
}

void end_otherwise(Body& body, const ExportCase& what, ContactEnd engine_end, std::string remark) {
  if (what.end == engine_end) return;
  body.fidelity = Fidelity::close;
  body.other_end = engine_end;
  body.remarks.insert(body.remarks.begin(), std::move(remark));
}

}  // namespace ricochet::calibration
