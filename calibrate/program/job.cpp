#include "job.hpp"

#include <console/csv.hpp>
#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::shortest;

std::string joined(std::span<const std::string_view> names) {
  if (names.size() == 1) return std::string(names.front());
  return fmt::format("{} or {}", fmt::join(names.first(names.size() - 1), ", "), names.back());
}

std::vector<LawKind> laws_of(const Options& o) {
  if (const auto all = LawKind::all(); o.law == "all" || o.law.empty()) return {all.begin(), all.end()};
  return {law_named("--law", o.law)};
}

bool alone(const Options& o) { return o.law != "all" && !o.law.empty(); }

/// The asked ends that `law` offers.
std::vector<ContactEnd> ends_of(const Options& o, LawKind law) {
  const bool both = o.end == "both" || (o.end.empty() && law.ends().both_by_default);
  std::vector<ContactEnd> ends;
  for (const auto end : {ContactEnd::overlap, ContactEnd::force}) {
    const bool asked = both || (o.end.empty() ? end == ContactEnd::force : text(end) == o.end);
    if (asked && law.ends().offer(end)) ends.push_back(end);
  }
  return ends;
}

Infeasible left_out(LawKind law, ContactEnd end, const std::string& reason) { return {law, end, reason, "", 0, 0, 0}; }

/// Every law that is asked for under the ends that it offers; one that stands alone and cannot is bad input.
void add_wanted(Job& job, const Options& o, LawKind law) {
  const auto ends = ends_of(o, law);
  if (ends.empty() && alone(o)) throw BadInput("--end", o.end, "force with --law " + o.law);
  if (ends.empty())
    job.left_out.push_back(
        left_out(law, ContactEnd::overlap, "the law is calibrated for a contact ended by force only"));
  for (const auto end : ends) job.wanted.push_back({law, end});
}

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// Why a law has not such a loss.
std::string lack_of(const Loss& loss, LawKind law) {
  if (holds_degree(law) && std::holds_alternative<loss::ConversionDegree>(loss))
    return "its alpha is held beside a loss; give --en as well";
  if (holds_degree(law) && std::holds_alternative<loss::LossFactor>(loss))
    return fmt::format("its loss factor goes with the frequency; {} has one", laws_with(loss));
  return fmt::format("it has no {}; {} has", in_words(name(loss)), laws_with(loss));
}

/// A loss that only some laws have.
bool takes_loss(Job& job, const Options& o, LawKind law) {
  const Loss& loss = job.known.loss;
  if (has_loss(law, loss)) return true;
  const std::string flag = spelled(Spelling::flags, name(loss));
  if (alone(o))
    throw BadInput(holds_degree(law)
                       ? fmt::format("{}: must be left out with --law {}: {}", flag, o.law, lack_of(loss, law))
                       : fmt::format("{}: must be left out with --law {}; {} has one", flag, o.law, laws_with(loss)));
  for (const auto end : ends_of(o, law)) job.left_out.push_back(left_out(law, end, lack_of(loss, law)));
  return false;
}

/// t_col, e_n, k and α are one number too many.
bool takes_degree(Job& job, const Options& o, LawKind law) {
  if (law != kind_of<FractionalKelvinVoigt> || !job.stiffness || !o.asked.alpha) return true;
  if (alone(o))
    throw BadInput("--alpha", shortest(*o.asked.alpha), "left out with --tcol, --en and --stiffness, which set it");
  for (const auto end : ends_of(o, law))
    job.left_out.push_back(left_out(law, end, "--tcol, --en and --stiffness set its alpha; leave --alpha out"));
  return false;
}

std::string listed(const std::vector<std::string_view>& names) {
  if (names.size() == 1) return std::string(names.front());
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// What of the laws that are wanted is held, where it is not given; and nothing may be given that none of them holds.
void take_held(Job& job, const Options& o) {
  std::vector<std::string_view> degree, stiffening;
  for (const Wanted& w : job.wanted) {
    const bool follows = w.law == kind_of<FractionalKelvinVoigt> && job.stiffness;
    if (holds_degree(w.law) && !follows && (degree.empty() || degree.back() != w.law.name()))
      degree.push_back(w.law.name());
    if (w.law == kind_of<FractionalZener>) stiffening.push_back(w.law.name());
  }
  if (holds_alpha(o.asked) && degree.empty()) refuse_second_loss(o.asked, Spelling::flags);
  if (o.asked.stiffening && stiffening.empty())
    throw BadInput("--stiffening", shortest(*o.asked.stiffening), "left out without --law fractional-zener or all");
  if (!o.asked.alpha && !degree.empty())
    job.assumptions.push_back(fmt::format("alpha = {} of {} (--alpha)", shortest(Held{}.alpha), listed(degree)));
  if (!o.asked.stiffening && !stiffening.empty())
    job.assumptions.push_back(
        fmt::format("k1/k = {} of {} (--stiffening)", shortest(Held{}.stiffening), listed(stiffening)));
}

/// A stiffness whose unit was stated is one of a spring in ζ or in ζ^{3/2}.
bool takes_stiffness(Job& job, const Options& o, LawKind law) {
  if (fits(job.spring, law)) return true;
  const auto* own = std::get_if<scale::Stiffness>(&job.known.scale);
  if (alone(o)) throw BadInput("--stiffness", stated(own->k, job.spring), spring_of(law));
  for (const auto end : ends_of(o, law))
    job.left_out.push_back(
        left_out(law, end, fmt::format("--stiffness = {}: must be {}", stated(own->k, job.spring), spring_of(law))));
  return false;
}

void take(Job& job, const Reading& reading, bool wall) {
  job.known = reading.known;
  job.stiffness = reading.stiffness;
  job.spring = reading.spring;
  job.step = reading.step;
  job.assumptions = reading.assumptions;
  job.radius_eff = reading.bodies.radius_eff;
  job.density = reading.bodies.density;
  if (reading.bodies.from_radii) job.radius = reading.bodies.smaller_radius;
  job.wall = wall;
}

/// The values of "k=1e9,c=0.6" by name.
std::map<std::string, double, std::less<>> values_with(const std::string& text, LawKind law) {
  std::vector<std::string_view> names;
  for (const Parameter& p : law.parameters()) names.push_back(p.name);
  std::map<std::string, double, std::less<>> values;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view piece = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), piece.size() + 1));
    const auto equals = piece.find('=');
    const std::string_view name = piece.substr(0, equals);
    const auto known = std::find_if(law.parameters().begin(), law.parameters().end(),
                                    [&](const Parameter& p) { return p.name == name; });
    if (equals == std::string_view::npos || known == law.parameters().end())
      throw BadInput("--with", piece, fmt::format("NAME=VALUE, the name {} for {}", joined(names), law.name()));
    const auto value = console::parse_quantity(piece.substr(equals + 1), known->unit());
    if (!value) throw BadInput("--with", piece, fmt::format("a finite number [{}]", known->unit()));
    if (!values.emplace(name, *value).second) throw BadInput(fmt::format("--with: {}: must be given once", name));
  }
  return values;
}

bool has_degree(LawKind law) { return law == kind_of<Fractional> || holds_degree(law); }

AnyLaw law_with(const Options& o) {
  if (!alone(o)) throw BadInput("--law: missing: must be one law with --with");
  const LawKind law = law_named("--law", o.law);
  auto by_name = values_with(o.with, law);
  if (has_degree(law) && o.asked.alpha) {
    if (!by_name.emplace("alpha", *o.asked.alpha).second)
      throw BadInput("--alpha", shortest(*o.asked.alpha), "left out with alpha in --with");
  }
  std::vector<double> values;
  for (const Parameter& p : law.parameters()) {
    const auto found = by_name.find(p.name);
    if (found == by_name.end()) throw BadInput(fmt::format("--with: {} missing: must be given for {}", p.name, o.law));
    values.push_back(found->second);
  }
  try {
    return law.with(values);
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("--with: {}", error.what()));
  }
}

Job forward_job(const Options& o) {
  Job job;
  job.given = law_with(o);
  Asked asked = o.asked;
  if (has_degree(LawKind::of(*job.given))) asked.alpha.reset();
  for (const Topic topic : {Topic::scale, Topic::loss, Topic::held})
    if (speaks_of(asked, topic))
      for (const Field& f : fields)
        if (f.topic == topic && (asked.*f.member || (f.member == &Asked::max_overlap && asked.overlap_share)))
          throw BadInput(fmt::format("{}: must be left out with --with", spelled(Spelling::flags, f.name)));
  if (was_given(o, "--match")) throw BadInput("--match: must be left out with --with");
  for (const std::string flag : {"--method", "--algorithm", "--tolerance"})
    if (was_given(o, flag)) throw BadInput(fmt::format("{}: must be left out with --with: nothing is searched", flag));
  Reading reading{};
  const double velocity = velocity_of(asked, Spelling::flags, reading.assumptions);
  reading.bodies = bodies_of(asked, Spelling::flags, reading.assumptions);
  reading.known.impact = {velocity, reading.bodies.mass_eff};
  take(job, reading, asked.wall);
  job.tangential = tangential_of(asked, Spelling::flags, job.known.scale);
  add_wanted(job, o, LawKind::of(*job.given));
  return job;
}

std::string text_of(const scale::Moduli& m) {
  const auto solid = [](const ElasticSolid& s) {
    return fmt::format("E = {} Pa, nu = {}", shortest(s.young), shortest(s.poisson));
  };
  const bool same = m.first.young == m.second.young && m.first.poisson == m.second.poisson;
  std::string text = same ? solid(m.first) : fmt::format("{} on {}", solid(m.first), solid(m.second));
  if (m.soften != 1) text += fmt::format(", softened {} times", shortest(m.soften));
  return text;
}

}  // namespace

std::string law_names() { return joined(Laws::names); }

bool holds_stiffness(LawKind law) noexcept {
  return law == kind_of<Fractional> || law == kind_of<FractionalKelvinVoigt>;
}

std::string laws_with(const Loss& loss) {
  std::vector<std::string_view> names;
  for (const LawKind law : LawKind::all())
    if (has_loss(law, loss)) names.push_back(law.name());
  return joined(names);
}

LawKind law_named(std::string_view flag, std::string_view name) {
  const auto law = LawKind::named(name);
  if (!law) throw BadInput(flag, console::excerpt(name), law_names());
  return *law;
}

ContactEnd end_named(std::string_view flag, std::string_view name) {
  if (name == text(ContactEnd::force)) return ContactEnd::force;
  if (name == text(ContactEnd::overlap)) return ContactEnd::overlap;
  throw BadInput(flag, console::excerpt(name), "overlap or force");
}

std::vector<std::string> flags_of(std::initializer_list<Topic> topics, std::vector<std::string> others) {
  for (const Field& f : fields)
    if (std::find(topics.begin(), topics.end(), f.topic) != topics.end())
      others.push_back(spelled(Spelling::flags, f.name));
  return others;
}

bool was_given(const Options& options, std::string_view flag) {
  return std::find(options.given.begin(), options.given.end(), flag) != options.given.end();
}

void require_match_to_matter(const Options& o, const Scale& scale) {
  if (!was_given(o, "--match")) return;
  if (!std::holds_alternative<scale::Moduli>(scale))
    throw BadInput("--match: must be left out without --young and --poisson");
  if (alone(o) && !fits(Spring::linear, law_named("--law", o.law)))
    throw BadInput(fmt::format("--match: must be left out with --law {}, whose k is that of the moduli", o.law));
}

void take_only(const Options& options, std::string_view mode, const std::vector<std::string>& accepted) {
  for (const std::string& name : options.given)
    if (std::find(accepted.begin(), accepted.end(), name) == accepted.end())
      throw BadInput(fmt::format("{}: must be left out with {}", name, mode));
}

TargetDefaults target_defaults(const Options& o) {
  TargetDefaults defaults;
  if (!o.law.empty()) defaults.law = law_named("--law", o.law);
  if (!o.end.empty()) defaults.end = end_named("--end", o.end);
  defaults.asked = o.asked;
  std::vector<std::string> assumptions;
  defaults.asked.velocity = velocity_of(o.asked, Spelling::flags, assumptions);
  return defaults;  // the bodies may be made up of flags and columns: each row tells
}

/// A load goes with a collision time and a restitution, or with given parameters, and a contact ended by force.
void take_load(Job& job, const Options& o) {
  if (!o.load) return;
  for (const auto& [flag, text] : {std::pair("--export", o.engine), std::pair("--report", o.page)})
    if (!text.empty()) throw BadInput(fmt::format("{}: must be left out with --load", flag));
  if (job.tangential) throw BadInput("--load", shortest(*o.load), "left out with --beta0, --mu and --tangential");
  if (!job.given && !(std::holds_alternative<scale::CollisionTime>(job.known.scale) &&
                      std::holds_alternative<loss::Restitution>(job.known.loss)))
    throw BadInput("--load", shortest(*o.load), "with --tcol and --en, or with --with");
  if (o.end == text(ContactEnd::overlap)) throw BadInput("--end", o.end, "force with --load");
  const auto follows = [&](const Wanted& w) { return w.law == kind_of<FractionalKelvinVoigt> && job.stiffness; };
  if (alone(o) && !job.wanted.empty() && follows(job.wanted.front()))
    throw BadInput("--stiffness", shortest(*job.stiffness), fmt::format("left out with --load and --law {}", o.law));
  std::erase_if(job.wanted, follows);
  job.load = o.load;
  std::erase_if(job.wanted, [](const Wanted& w) { return w.end == ContactEnd::overlap; });
}

Job job_of(const Options& o) {
  if (!o.with.empty()) {
    Job job = forward_job(o);
    take_load(job, o);
    return job;
  }
  Job job;
  take(job, read(o.asked, Spelling::flags), o.asked.wall);
  require_match_to_matter(o, job.known.scale);
  job.tangential = tangential_of(o.asked, Spelling::flags, job.known.scale);
  if (job.stiffness && !fits(o.asked.spring, kind_of<Linear>))
    throw BadInput("--stiffness", stated(*job.stiffness, o.asked.spring), spring_of(kind_of<Fractional>));
  if (job.stiffness && alone(o) && !holds_stiffness(law_named("--law", o.law)))
    throw BadInput("--stiffness", shortest(*job.stiffness),
                   fmt::format("left out with --law {}; {}", o.law, who_holds_stiffness));
  for (const auto law : laws_of(o))
    if (takes_loss(job, o, law) && takes_stiffness(job, o, law) && takes_degree(job, o, law)) add_wanted(job, o, law);
  take_held(job, o);
  const bool holds = !job.stiffness && !stiffness(kind_of<Fractional>, job.known.scale, job.known.impact);
  if (holds &&
      std::any_of(job.wanted.begin(), job.wanted.end(), [](const Wanted& w) { return w.law == kind_of<Fractional>; }))
    job.assumptions.push_back("the fractional law holds the k of the linear law ended by force (--stiffness)");
  take_load(job, o);
  return job;
}

std::string asked_text(const Job& job) {
  if (!job.title.empty()) return job.title;
  if (job.given) {
    std::vector<std::string> all;
    for (const auto& p : parameters(*job.given))
      all.push_back(fmt::format("{} = {}{}{}", p.name, shortest(p.value), p.unit.empty() ? "" : " ", p.unit));
    return fmt::format("{} with {}", name(*job.given), fmt::join(all, ", "));
  }
  struct ScaleText {
    std::string operator()(const scale::CollisionTime& s) const { return fmt::format("tcol = {} s", shortest(s.tcol)); }
    std::string operator()(const scale::Stiffness& s) const { return fmt::format("stiffness = {}", shortest(s.k)); }
    std::string operator()(const scale::Moduli& s) const { return text_of(s); }
    std::string operator()(const scale::MaxOverlap& s) const {
      return fmt::format("greatest overlap = {} m", shortest(s.length));
    }
  };
  struct LossText {
    std::string operator()(const loss::Restitution& l) const { return fmt::format("en = {}", shortest(l.en)); }
    std::string operator()(const loss::LossFactor& l) const {
      return fmt::format("tan delta = {}", shortest(l.tan_delta));
    }
    std::string operator()(const loss::DampingRatio& l) const {
      return fmt::format("damping ratio = {}", shortest(l.ratio));
    }
    std::string operator()(const loss::ConversionDegree& l) const {
      return fmt::format("alpha = {}", shortest(l.alpha));
    }
  };
  return fmt::format("{}, {}", std::visit(ScaleText{}, job.known.scale), std::visit(LossText{}, job.known.loss));
}

}  // namespace ricochet::calibration
