#include "target_rows.hpp"

#include <ricochet/collision/tangential_restitution.hpp>

#include "report.hpp"

#include <console/exit.hpp>
#include <console/harmless.hpp>
#include <console/number.hpp>
#include <console/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <tuple>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using support::append_shortest;

/// The place of a number among `fields`.
constexpr std::size_t place_of(std::optional<double> Asked::*member) {
  std::size_t place = 0;
  while (fields[place].member != member) ++place;
  return place;
}

/// As RFC 4180 quotes it, where it needs to be.
void append_text(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

/// A word of a file as it is, or nothing where a spreadsheet or a terminal would obey it.
std::string_view harmless(std::string_view word) { return console::is_harmless(word) ? word : std::string_view(); }

/// The defaults that go with a row's own scale: what else makes up the same one, and beside a collision time the k to
/// hold.
Asked scale_defaults(const Asked& own, const Asked& defaults) {
  Asked kept = without(defaults, Topic::scale);
  const auto keep = [&](std::initializer_list<std::optional<double> Asked::*> members) {
    for (const auto member : members) kept.*member = defaults.*member;
  };
  if (own.young || own.poisson || own.young2 || own.poisson2 || own.soften)
    keep({&Asked::young, &Asked::poisson, &Asked::young2, &Asked::poisson2, &Asked::soften});
  if (own.timestep || own.steps) keep({&Asked::timestep, &Asked::steps});
  if (own.tcol) keep({&Asked::stiffness});
  return kept;
}

/// What a row says itself goes before the defaults: its own scale and its own loss put theirs away, and its mass their
/// radii or the other way round.
Asked with_defaults(const Asked& own, Asked defaults) {
  if (speaks_of(own, Topic::scale)) defaults = scale_defaults(own, defaults);
  if (speaks_of(own, Topic::loss)) {
    const auto held = defaults.alpha;  // where the law of the row holds one
    defaults = without(defaults, Topic::loss);
    defaults.alpha = held;
  }
  if (own.mass_eff) {
    defaults.radius = defaults.diameter = defaults.density = defaults.radius2 = defaults.diameter2 = defaults.density2 =
        std::nullopt;
    defaults.wall = false;
  }
  if (own.radius || own.diameter) defaults.radius = defaults.diameter = std::nullopt;
  if (own.radius2 || own.diameter2) defaults.radius2 = defaults.diameter2 = std::nullopt;
  if (own.radius || own.diameter || own.density || own.radius2 || own.diameter2 || own.density2)
    defaults.mass_eff = std::nullopt;
  for (const Field& f : fields)
    if (own.*f.member) defaults.*f.member = own.*f.member;
  if (own.stiffness) defaults.spring = own.spring;
  if (own.overlap_share) defaults.overlap_share = own.overlap_share;
  return defaults;
}

}  // namespace

const std::array<console::CsvColumn, TargetRows::count> TargetRows::accepted = [] {
  std::array<console::CsvColumn, count> columns;
  for (std::size_t i = 0; i < fields.size(); ++i)
    columns[i] = {.name = fields[i].name, .unit = fields[i].read_in(), .aliases = fields[i].aliases};
  columns[law].name = "law";
  columns[end].name = "end";
  columns[hertzian] = {.name = "stiffness", .unit = hertzian_unit};
  return columns;
}();

TargetRows::TargetRows(std::string file, const console::CsvHead& head, const TargetDefaults& defaults,
                       const DirectCalibrator& calibrator, std::string_view first_rows)
    : file_(std::move(file)),
      defaults_(defaults),
      columns_(file_, head, accepted, console::Unknown::ignored, first_rows),
      calibrator_(calibrator) {
  for (std::size_t i = 0; i < count; ++i)
    if (columns_.has(i) && i != law && i != end) numeric_.push_back(i);
  Asked but_velocity = defaults_.asked;
  but_velocity.velocity.reset();
  nothing_by_default_ = !defaults_.asked.wall && !speaks_of(but_velocity, Topic::scale) &&
                        !speaks_of(but_velocity, Topic::loss) && !speaks_of(but_velocity, Topic::held) &&
                        !speaks_of(but_velocity, Topic::impact) && !speaks_of(but_velocity, Topic::tangential);
  if (defaults_.asked.form == TangentialForm::mindlin)
    throw BadInput("--tangential", "mindlin", "linear or linear-undamped with --targets");
  for (const auto member : {&Asked::beta0, &Asked::mu})
    tangential_ = tangential_ || defaults_.asked.*member || columns_.has(place_of(member));
  tangential_ = tangential_ || defaults_.asked.form;
  require_topics(head.line);
  const bool any_law = columns_.has(law);
  for (const LawKind l : LawKind::all()) {
    if (!any_law && l != defaults_.law) continue;
    std::size_t i = 0;
    for (const Parameter& p : l.parameters()) {
      const std::string unit = p.unit();
      const std::string column = unit.empty() ? std::string(p.name) : fmt::format("{} [{}]", p.name, unit);
      const auto same = std::find(parameters_.begin(), parameters_.end(), column);
      place_[l.index()][i++] = static_cast<std::size_t>(same - parameters_.begin());
      if (same == parameters_.end()) parameters_.push_back(column);
    }
  }
}

/// A file that can't say what is wanted is told once, not row by row.
void TargetRows::require_topics(std::size_t line) const {
  const auto known = [&](Topic topic) {
    return speaks_of(defaults_.asked, topic) || std::any_of(numeric_.begin(), numeric_.end(), [&](std::size_t i) {
             return i == hertzian ? topic == Topic::scale : fields[i].topic == topic;
           });
  };
  for (const auto& [topic, name, others] :
       {std::tuple(Topic::loss, "en", "loss_factor, damping_ratio, alpha"),
        std::tuple(Topic::scale, "tcol", "stiffness, young and poisson, max_overlap, timestep and steps")})
    if (!known(topic))
      throw BadInput(fmt::format("{}:{}: column {}: missing: must be given, or one of {}", file_, line, name, others));
}

std::string TargetRows::header() const {
  return fmt::format("tcol [s],en,velocity [m/s],mass_eff [kg],law,end,status,{}{}\n", fmt::join(parameters_, ","),
                     tangential_ ? ",beta0,mu,k_t [kg/s^2],c_t [kg/s]" : "");
}

/// Of which spring it is the head says, or the field itself.
void TargetRows::stiffness(std::size_t column, std::string_view text, Asked& own) const {
  const bool stated = columns_.states_unit(column);
  own.spring = column == hertzian ? Spring::hertzian : stated ? Spring::linear : Spring::any;
  own.stiffness = columns_.number(column, text);
  if (own.stiffness) return;
  if (!columns_.doubt(text).empty() || text.find_first_of(",:") != std::string_view::npos)
    throw BadInput("stiffness", console::excerpt(text), fmt::format("a finite number{}", columns_.doubt(text)));
  try {
    const auto [values, spring] = parse_stiffnesses(text);
    own.stiffness = values.front();
    own.spring = spring;
  } catch (const std::invalid_argument& error) {
    throw BadInput("stiffness", console::excerpt(text), error.what());
  }
}

/// A field with a unit of its own ("20us", "1%") says it whatever the head says.
double TargetRows::number(std::size_t column, std::string_view text, Asked& own) const {
  const Field& field = fields[column];
  if (field.member == &Asked::max_overlap && text.ends_with('%')) {
    own.overlap_share = console::parse_quantity(text, "");
    if (own.overlap_share) return *own.overlap_share;
  }
  auto value = columns_.number(column, text);
  const auto doubt = columns_.doubt(text);
  if (!value && doubt.empty()) value = console::parse_quantity(text, field.read_in());
  if (!value)
    throw BadInput(field.name, console::excerpt(text),
                   fmt::format("{}{}", field.member == &Asked::en ? "in (0, 1]" : "a number in [1e-30, 1e30]", doubt));
  own.*field.member = value;
  return *value;
}

void TargetRows::numbers(const Row& row, Asked& own) const {
  for (const std::size_t column : numeric_)
    if (const auto text = row.text[column]; !text.empty()) {
      if (column == hertzian || fields[column].member == &Asked::stiffness)
        stiffness(column, text, own);
      else
        number(column, text, own);
    }
}

Asked TargetRows::asked_by(Row& row) const {
  constexpr std::size_t velocity = place_of(&Asked::velocity);
  if (nothing_by_default_) {  // as of most files, whose rows are many
    Asked asked = defaults_.asked;
    numbers(row, asked);
    if (row.text[velocity].empty()) row.taken |= bit(velocity);
    return asked;
  }
  Asked own;
  numbers(row, own);
  const Asked asked = with_defaults(own, defaults_.asked);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (asked.*fields[i].member && !(own.*fields[i].member)) row.taken |= bit(i);
  if (asked.overlap_share && !own.overlap_share) row.taken |= bit(place_of(&Asked::max_overlap));
  if (asked.wall) row.taken |= bit(wall);
  return asked;
}

std::vector<std::string> TargetRows::idle(std::uint64_t taken, const std::vector<std::string>& given) {
  std::vector<std::string> idle;
  const auto look = [&](std::string_view name, std::size_t place) {
    const std::string flag = spelled(Spelling::flags, name);
    if (!(taken & bit(place)) && std::find(given.begin(), given.end(), flag) != given.end()) idle.push_back(flag);
  };
  for (std::size_t i = 0; i < fields.size(); ++i) look(fields[i].name, i);
  for (const auto& [name, place] :
       {std::pair("law", law), {"end", end}, {"match", match}, {"wall", wall}, {"tangential", form}})
    look(name, place);
  return idle;
}

/// By the closed forms, or why the form cannot have this β₀.
std::optional<Infeasible> TargetRows::add_tangential(Row& row, const Scale& scale) const {
  const auto wanted = tangential_of(*row.asked, Spelling::columns, scale);
  if (!wanted) return std::nullopt;
  row.taken |= bit(form);
  const Target& target = row.request.target;
  if (auto missed = out_of_form(wanted->form, *wanted->beta0, row.request.law, row.request.end)) return missed;
  row.tangential =
      tangential_for(*wanted->beta0, target.tcol, target.impact.mass_eff,
                     wanted->form == TangentialForm::linear ? StickingForm::damped : StickingForm::undamped);
  return std::nullopt;
}

/// What is held is for laws that hold it: of the defaults the others leave it, in their row it is a number too many.
void TargetRows::leave_unheld(Row& row, LawKind kind) const {
  Asked& asked = *row.asked;
  const auto own = [&](std::optional<double> Asked::*member) { return !row.text[place_of(member)].empty(); };
  const auto leave = [&](std::optional<double> Asked::*member) {
    (asked.*member).reset();
    row.taken &= ~bit(place_of(member));
  };
  const bool follows = kind == kind_of<FractionalKelvinVoigt> && asked.tcol && asked.stiffness;
  if (holds_alpha(asked) && (follows || !holds_degree(kind))) {
    if (own(&Asked::alpha) && follows)
      throw BadInput("alpha", console::shortest(*asked.alpha), "left out with tcol, en and stiffness, which set it");
    if (own(&Asked::alpha)) refuse_second_loss(asked, Spelling::columns);
    leave(&Asked::alpha);
  }
  if (kind == kind_of<FractionalZener> || !asked.stiffening) return;
  if (own(&Asked::stiffening))
    throw BadInput("stiffening", console::shortest(*asked.stiffening),
                   fmt::format("left out with the law {}", kind.name()));
  leave(&Asked::stiffening);
}

std::variant<AnyLaw, Infeasible> TargetRows::calibrated(Row& row) const {
  row.asked = asked_by(row);
  for (const std::size_t word : {law, end})
    if (row.text[word].empty()) row.taken |= bit(word);
  std::vector<std::string> unsaid;
  row.mass_eff = bodies_of(*row.asked, Spelling::columns, unsaid).mass_eff;  // told also where the row fails
  const LawKind kind = row.text[law].empty() ? defaults_.law : law_named("law", row.text[law]);
  leave_unheld(row, kind);
  const Reading reading = calibration::read(*row.asked, Spelling::columns);
  const ContactEnd by = row.text[end].empty() ? defaults_.end : end_named("end", row.text[end]);
  if (row.asked->young && fits(Spring::linear, kind)) row.taken |= bit(match);
  if (!kind.ends().offer(by)) throw BadInput("end", text(by), fmt::format("force with the law {}", kind.name()));
  if (reading.stiffness && !defaults_.asked.stiffness && !holds_stiffness(kind))
    throw BadInput("stiffness", console::shortest(*reading.stiffness),
                   fmt::format("left out with tcol and the law {}; {}", kind.name(), who_holds_stiffness));
  if (!fits(reading.stiffness ? row.asked->spring : reading.spring,
            reading.stiffness ? LawKind(kind_of<Fractional>) : kind))
    throw BadInput("stiffness", stated(*row.asked->stiffness, row.asked->spring), spring_of(kind));
  if (!has_loss(kind, reading.known.loss))
    throw BadInput(fmt::format("{}: must be left out with the law {}; {} has one", name(reading.known.loss),
                               kind.name(), laws_with(reading.known.loss)));
  const auto request = request_of(kind, by, reading.known, calibrator_);
  if (const auto* missed = std::get_if<Infeasible>(&request)) return *missed;
  row.request = std::get<Request>(request);
  if (reading.stiffness) row.request.stiffness = reading.stiffness;
  row.solved = true;
  if (tangential_)
    if (auto missed = add_tangential(row, reading.known.scale)) return *missed;
  auto answer = calibrator_(row.request);
  if (const auto* missed = std::get_if<Infeasible>(&answer)) return in_terms_of(*missed, reading.known.loss);
  return answer;
}

void TargetRows::write(std::string& out, const Row& row, std::string_view status, const AnyLaw* found) const {
  static const Asked nothing;
  const Asked& asked = row.asked ? *row.asked : nothing;
  const Target& target = row.request.target;
  for (const auto& number :
       {row.solved ? std::optional(target.tcol) : asked.tcol, row.solved ? std::optional(target.en) : asked.en,
        asked.velocity, row.mass_eff ? row.mass_eff : asked.mass_eff}) {
    if (number) append_shortest(out, *number);
    out += ',';
  }
  append_text(out, found ? row.request.law.name() : harmless(row.text[law]));
  out += ',';
  append_text(out, found ? text(row.request.end) : harmless(row.text[end]));
  out += ',';
  append_text(out, status);
  if (!found) {
    out.append(parameters_.size() + (tangential_ ? 4 : 0), ',');
    out += '\n';
    return;
  }
  std::array<double, Laws::most_parameters> values{};
  const std::size_t known = std::visit(
      [&](const auto& l) {
        const auto own = l.values();
        std::copy(own.begin(), own.end(), values.begin());
        return own.size();
      },
      *found);
  const auto& places = place_[row.request.law.index()];
  for (std::size_t column = 0; column < parameters_.size(); ++column) {
    out += ',';
    for (std::size_t i = 0; i < known; ++i)
      if (places[i] == column) append_shortest(out, values[i]);
  }
  if (tangential_) {
    const auto number = [&](const std::optional<double>& value) {
      out += ',';
      if (value) append_shortest(out, *value);
    };
    const auto& law = row.tangential;
    number(asked.beta0);
    number(asked.mu);
    number(law ? std::optional(law->k_t()) : std::nullopt);
    number(law ? std::optional(law->c_t()) : std::nullopt);
  }
  out += '\n';
}

Answers TargetRows::answer(const console::LineBlocks::Block& block) const {
  Answers answers;
  answers.text.reserve(3 * block.text.size());
  std::string_view text = block.text;
  for (std::size_t line_number = block.first_line; !text.empty(); ++line_number) {
    const std::string_view line = console::take_line(text);
    if (console::is_csv_remark(line)) continue;
    Row row;
    std::string failure;
    ++answers.rows;
    try {
      columns_.split(line, row.text);
      const auto answer = calibrated(row);
      answers.taken |= row.taken;
      if (const auto* found = std::get_if<AnyLaw>(&answer)) {
        write(answers.text, row, "calibrated", found);
        continue;
      }
      failure = fmt::format("infeasible: {}", explained(std::get<Infeasible>(answer), Spelling::columns));
    } catch (const std::exception& error) {
      answers.taken |= row.taken;
      const bool bad = console::exit_code(error) == console::Exit::bad_input;
      failure = fmt::format("{}: {}", bad ? "bad input" : "failed", error.what());
    }
    write(answers.text, row, failure, nullptr);
    if (++answers.failed <= most_complaints)
      answers.complaints.push_back(
          fmt::format("{}:{}: {}", file_, line_number, failure.substr(failure.find(": ") + 2)));
  }
  return answers;
}

}  // namespace ricochet::calibration
