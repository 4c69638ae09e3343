// What is booked of a step: energies, memories, how contacts ended and what they went through.
#include "contact_rows.hpp"

#include <ricochet/motion/cluster.hpp>

#include <algorithm>

namespace ricochet {

void Cluster::conclude() {
  for (std::size_t k = 0; k < geometries_.size(); ++k) {
    ContactState& c = *present_[k];
    const Motion &i = motions_[c.record.i], &j = motions_[c.record.j];
    const ContactGeometry& g = geometries_[k];
    normals_[k].rate_mid = dot(i.velocity_mid - j.velocity_mid - swept(c, g), g.normal);
    if (models_[c.model].rubs()) state_.lost_friction += friction_loss(k);
    if (options_.records)
      note_phases(c, g,
                  {.rate_mid = normals_[k].rate_mid,
                   .before = slip_before(c, g),
                   .after = slip_motion(c, g, relative_velocity(c.record.i, c.record.j)),
                   .sticks = rows_[k].friction.sticks,
                   .slip_fraction = rows_[k].friction.slip_fraction});
    if (walls_drive_)
      state_.wall_work += wall_work(c, g, normals_[k].impulse, models_[c.model].rubs() ? c.friction : FrictionImpulse{},
                                    motions_[c.record.j].velocity);
  }
  for (const Model& model : models_) model.normal->conclude(batch(model), time() + 0.5 * options_.step);
  for (std::size_t k = 0; k < geometries_.size(); ++k) {
    ContactState& c = *present_[k];
    state_.lost_normal += normals_[k].loss;
    note_end_of_contact(c, geometries_[k], normals_[k]);
  }
}

void Cluster::note_end_of_contact(ContactState& c, const ContactGeometry& g,
                                  const motion::NormalRow& row) const noexcept {
  if (c.record.how == EncounterEnd::permanent_contact) note_breakage(c, row.mobility);
  if (c.record.end != Encounter::never && c.record.how == EncounterEnd::open)
    c.record.how = how_it_ended(c, g, row.rate_mid);
}

EncounterEnd Cluster::how_it_ended(const ContactState& c, const ContactGeometry& g, double rate_mid) const noexcept {
  const double still = 1e-9 * c.speed_scale;
  if (std::abs(rate_mid) > still) return EncounterEnd::deformed_rebound;
  return norm(slip_before(c, g).slip) > still ? EncounterEnd::dynamic_contact : EncounterEnd::static_contact;
}

// What the approach has lost of its energy by t_e is that of the impact, less the share at rest.
void Cluster::note_breakage(ContactState& c, double mobility) const noexcept {
  const double taken = 0.5 * c.impact_rate * c.impact_rate * (1 - at_rest * at_rest) / mobility;
  if (taken >= models_[c.model].breakage_energy) c.record.how = EncounterEnd::breakage;
}

// The work of an impulse is that at the mean of the velocities before and after.
double Cluster::friction_loss(std::size_t contact) {
  ContactState& c = *present_[contact];
  const SlipMotion mean = mean_slip(c, geometries_[contact]);
  const Model& model = models_[c.model];
  if (model.compliant) return conclude_springs(contact, mean);
  const FrictionImpulse& f = rows_[contact].friction.impulse;
  c.friction = f;
  return -(dot(f.sliding, mean.slip) + f.torsion * mean.spin + dot(f.rolling, mean.roll));
}

double Cluster::conclude_springs(std::size_t contact, const SlipMotion& mean) {
  ContactState& c = *present_[contact];
  const TangentialContact& law = models_[c.model].tangential;
  const motion::CompliantRow& row = springs_[contact];
  const motion::CompliantEnd end = motion::compliant_end<true>(law, row, c, mean, c.force);
  const motion::CompliantLoss loss = motion::compliant_loss(row, c.strained - end.stored);
  c.friction = rows_[contact].friction.impulse;
  c.elongation = end.elongation, c.strained = end.stored;
  return motion::lost(loss, law, c.friction, mean);
}

void Cluster::note_phases(ContactState& c, const ContactGeometry& g, const Course& course) const noexcept {
  const auto& [rate_mid, before, after, sticks, slid_for] = course;
  const double h = options_.step, start = std::max(time(), c.record.begin), still = 1e-9 * c.speed_scale;
  const auto enter = [&](Phase phase, double when) {
    double& begin = c.record.phase_begin[static_cast<std::size_t>(phase)];
    begin = std::min(begin, when);
  };
  if (rate_mid < 0) {
    // Between the time of the last approach and the middle of this step the rate went through zero.
    const double middle = time() + 0.5 * h, past = c.approach.rate;
    const bool turned = past > 0 && !c.fresh;
    enter(Phase::decompression, turned ? middle - c.lag * rate_mid / (rate_mid - past) : start);
  }
  const double reach = g.arm_i + g.arm_j;
  if (std::abs(after.spin) * reach > still) enter(Phase::torsion, start);
  // What springs give way by is no sliding.
  const bool slid = !models_[c.model].compliant && norm(before.slip) > still;
  if (!sticks) {
    if (slid || norm(after.slip) > still) enter(Phase::sliding, start);
    return;
  }
  if (slid) enter(Phase::sliding, start);
  const bool rolls = norm(after.roll) * reach > still;
  enter(rolls ? Phase::rolling : Phase::rest, start + slid_for * (time() + h - start));
}

}  // namespace ricochet
