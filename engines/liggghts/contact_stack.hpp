#pragma once

#include "liggghts_headers.hpp"

#include <memory>

namespace ricochet::liggghts {

/// The stack of models that LIGGGHTS's pair and wall styles drive, with one of ours as the normal model, and
/// tangential, cohesion and rolling models, chosen at run time. One class serves all combinations: LIGGGHTS would
/// instantiate a template for each, 300 of them twice over.
class ContactStack : public LIGGGHTS::ContactModels::ContactModelBase {
 public:
  ContactStack(LIGGGHTS::LAMMPS* lmp, LIGGGHTS::IContactHistorySetup* history, bool is_wall, std::int64_t code);

  std::int64_t hashcode() const { return code_; }
  void registerSettings(Settings& settings);
  void postSettings(LIGGGHTS::IContactHistorySetup* history);
  void connectToProperties(PropertyRegistry& registry);
  double stressStrainExponent() { return normal_->stressStrainExponent(); }
  bool contact_match(const std::string& kind, const std::string& model) const;
  void tally_pp(double, int, int, int) override {}
  void tally_pw(double, int, int, int) override {}

  using Intersection = LIGGGHTS::ContactModels::SurfacesIntersectData;
  using Nearness = LIGGGHTS::ContactModels::SurfacesCloseData;
  using Forces = LIGGGHTS::ContactModels::ForceData;

  bool checkSurfaceIntersect(Intersection& pair) { return surface_.checkSurfaceIntersect(pair); }
  void beginPass(Intersection& pass, Forces& on_i, Forces& on_j) {
    surface_.beginPass(pass, on_i, on_j);
    normal_->beginPass(pass, on_i, on_j);
    cohesion_->beginPass(pass, on_i, on_j);
    tangential_->beginPass(pass, on_i, on_j);
    rolling_->beginPass(pass, on_i, on_j);
  }
  void endPass(Intersection& pass, Forces& on_i, Forces& on_j) {
    rolling_->endPass(pass, on_i, on_j);
    tangential_->endPass(pass, on_i, on_j);
    cohesion_->endPass(pass, on_i, on_j);
    normal_->endPass(pass, on_i, on_j);
    surface_.endPass(pass, on_i, on_j);
  }
  // In LIGGGHTS's order: friction and rolling take their limit from the normal force, cohesion included.
  void surfacesIntersect(Intersection& pair, Forces& on_i, Forces& on_j) {
    surface_.surfacesIntersect(pair, on_i, on_j);
    normal_->surfacesIntersect(pair, on_i, on_j);
    cohesion_->surfacesIntersect(pair, on_i, on_j);
    tangential_->surfacesIntersect(pair, on_i, on_j);
    rolling_->surfacesIntersect(pair, on_i, on_j);
  }
  void endSurfacesIntersect(Intersection& pair, LAMMPS_NS::TriMesh* mesh, Forces& on_i, Forces& on_j) {
    surface_.endSurfacesIntersect(pair, mesh, on_i.delta_F);
    cohesion_->endSurfacesIntersect(pair, on_i, on_j);
  }
  void surfacesClose(Nearness& pair, Forces& on_i, Forces& on_j) {
    surface_.surfacesClose(pair, on_i, on_j);
    normal_->surfacesClose(pair, on_i, on_j);
    cohesion_->surfacesClose(pair, on_i, on_j);
    tangential_->surfacesClose(pair, on_i, on_j);
    rolling_->surfacesClose(pair, on_i, on_j);
  }

 private:
  std::int64_t code_;
  LIGGGHTS::ContactModels::SurfaceModel<LIGGGHTS::ContactModels::SURFACE_DEFAULT> surface_;
  std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> normal_;
  std::shared_ptr<LIGGGHTS::ContactModels::CohesionModelBase> cohesion_;
  std::shared_ptr<LIGGGHTS::ContactModels::TangentialModelBase> tangential_;
  std::shared_ptr<LIGGGHTS::ContactModels::RollingModelBase> rolling_;
};

}  // namespace ricochet::liggghts
