#pragma once

#include <ricochet/contact/arms_block.hpp>
#include <ricochet/contact/geometry.hpp>
#include <ricochet/motion/bodies.hpp>
#include <ricochet/motion/contact_list.hpp>
#include <ricochet/motion/contact_state.hpp>
#include <ricochet/motion/engine/compliant_contact.hpp>
#include <ricochet/motion/engine/surface.hpp>
#include <ricochet/motion/engine/workers.hpp>
#include <ricochet/motion/linked_cells.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ricochet {

namespace motion {
struct Slides;
}

struct ClusterOptions {
  double step = 0;  ///< Δt [s], > 0
  double skin = 0;  ///< of the neighbour list [m]; 0: a third of the smallest radius
  /// T of the memory kernels of fractional laws [s], at most 5·10⁵ steps with one; 0: 10⁴ steps. In a contact that
  /// lasts longer, what is older than T ceases to fade: after 10⁴ steps the kernel is off by at most 1.2 % at 2T,
  /// then levels off at 0.31 (α → 1; 0.49 at α = 0.5, 0.96 at α = 0.03) of its value at T; after 4·10⁵ steps, which
  /// the arms hold less sharply, by 5.3 % and at 0.40.
  double longest_contact = 0;
  /// Relative error of these kernels, in [1e-12, 0.1]. Wanted, not promised: a contact carries FractionalArms::max_arms
  /// arms, and where they do not suffice for T the tolerance gives way tenfold until they do. `Cluster::kernel_error`
  /// tells.
  double kernel_tolerance = 1e-8;
  Reclosing reclosing = Reclosing::repels;
  double solver_tolerance = 1e-10;  ///< on impulses, relative to the greatest of the step; 1e-6 serves in packings
  int max_sweeps = 100;             ///< over all contacts, a step
  /// Whether contacts note the phases they go through (Encounter::phase_begin) and collisions are kept for
  /// take_finished.
  bool records = true;
  /// That share the steps which need no sweeps, in [1, 256]; no result differs by a bit from that of one.
  int threads = 1;
};

/// The energies of a cluster [J]. `total` is constant up to the scheme's error; `lost_*` are what dashpots, clamped
/// forces and friction have taken since the start.
struct ClusterEnergy {
  double kinetic = 0, gravity = 0, stored = 0, lost_normal = 0, lost_friction = 0, long_range_work = 0;
  double strained = 0;   ///< what springs in the tangent plane hold
  double wall_work = 0;  ///< what moving walls have done on the spheres
  double brought = 0;    ///< with spheres that came, less what those that left took along

  double mechanical() const noexcept { return kinetic + gravity + stored + strained; }
  double total() const noexcept {
    return mechanical() + lost_normal + lost_friction - long_range_work - wall_work - brought;
  }
};

/// What a law remembers of one contact.
struct ContactMemory {
  std::string law;             ///< its name
  std::vector<double> values;  ///< NormalLaw::memory_size() of them
};

/// All that a cluster's future depends on besides its setup and options: restoring it continues to the last bit.
struct ClusterState {
  std::uint64_t steps = 0;
  std::vector<Vec3> half_positions, velocities, spins;
  std::vector<ContactState> contacts;   ///< ordered by their pairs; `model` and `slot` are the cluster's own affair
  std::vector<ContactMemory> memories;  ///< of these contacts
  double lost_normal = 0, lost_friction = 0, long_range_work = 0, wall_work = 0, brought = 0;
  std::uint64_t unconverged = 0;  ///< steps that ended at max_sweeps
  double worst_change = 0;  ///< of their last sweeps' greatest changes, relative to the greatest impulse of the step
  /// By contacts in the last step, of spheres; empty: none.
  std::vector<Vec3> velocity_gains, spin_gains;
};

/// Where a motion says nothing any more: bodies that went into each other by more than 1.5 of the smaller radius (the
/// softest of the paper's own cases goes in by more than 1), on the way to the other side; a centre that went through a
/// surface which ends somewhere; or a sphere (`j` is then `i`) that a single step moves by its radius, so that it could
/// miss whom it meets.
struct Breakthrough {
  static constexpr double share = 1.5;
  std::uint32_t i = 0, j = 0;  ///< bodies; walls count from the number of spheres
  double speed = 0;            ///< at which they approach, or the sphere flies [m/s]
  double depth = share;        ///< that they passed, in smaller radii: 1 of a surface that ends somewhere
};

/// Spheres and walls in motion: any normal law for each pair of materials, also one of your own, friction with torsion
/// and rolling, rigid (Sec. II of the paper) or by springs in the tangent plane, gravity, other forces. Can be moved,
/// not copied: `state` and `restore` carry a motion from one cluster to another.
///
/// Scheme. Velocities live at t_n, positions at t_{n+1/2} (leapfrog). In the middle of a step every contact passes one
/// impulse at its contact point, so momentum and angular momentum are conserved to rounding, whatever the step and the
/// laws. Impulses are implicit in the contact's own velocities: R by the midpoint rule on the step's mean velocity,
/// friction as in friction_impulse, or by springs as in engine/compliant_contact.hpp. Where all contacts are smooth or
/// have springs, and the step resolves their dashpots (½h Σc/m ≤ 1/4 of each sphere), a contact takes of others what
/// they passed in the last step: once through all contacts, linear in their number. Else impulses are found together by
/// sweeps. A contact takes 288 bytes (ContactState), 4 for its place in their order, its law's memory and 8 a pair of
/// the neighbour list; sweeps take some 900 more.
/// Between two middles each sphere flies straight, so t_b is the root of a quadratic; from t_b to the end of that step
/// the pair is integrated by itself on a finer, graded mesh. Where the force falls to zero inside a step, the impulse
/// stops there.
///
/// Order 2 in the step for positions, velocities, energy and t_e, for laws whose force is smooth in time after t_b. A
/// law that starts like t^p, 0 < p < 1 (fractional: p = 1−α; Kuwabara-Kono: 1/2; Tsuji: 1/4), adds an error of order
/// 1+p with a small constant (the graded first step takes most of it).
class Cluster {
 public:
  /// Throws std::invalid_argument for a setup that `check` rejects or an option outside its domain. Bodies that
  /// overlap at the start have touched since time 0: springs and memories begin then, what the overlap stores is there.
  Cluster(const ClusterSetup& setup, const ClusterOptions& options);

  void step();

  /// Spheres that come at time(), numbered on from those that are there. Throws std::invalid_argument, nothing changed,
  /// for one that `check` rejects, or of a material that no sphere of the setup had, now or later.
  void add(std::span<const Sphere> spheres);
  /// Takes spheres away, their contacts with them as they are (Encounter::separation: never); the others move up.
  /// `leaving`: numbers from 0, ascending. Throws std::invalid_argument for others.
  void remove(std::span<const std::uint32_t> leaving);

  /// False as soon as a position or velocity is not finite: the step was far too large.
  bool advance(std::uint64_t steps);

  std::uint64_t steps() const noexcept { return state_.steps; }
  double time() const noexcept { return static_cast<double>(state_.steps) * options_.step; }
  std::size_t size() const noexcept { return radii_.size(); }
  Vec3 position(std::size_t i) const noexcept;  ///< at time()
  Vec3 velocity(std::size_t i) const noexcept { return state_.velocities[i]; }
  Vec3 spin(std::size_t i) const noexcept { return state_.spins[i]; }

  ClusterEnergy energy() const noexcept;
  Vec3 momentum() const noexcept;          ///< [kg m/s]
  Vec3 angular_momentum() const noexcept;  ///< about the origin [kg m²/s]

  /// Pairs in contact, ordered by (i, j).
  const ContactList& contacts() const noexcept { return contacts_; }
  /// Collisions whose pairs have separated since the last call, in the order of their separation.
  std::vector<Encounter> take_finished();

  /// The first of the bodies, by number, of which that is so; costs a look at each contact and sphere.
  std::optional<Breakthrough> breakthrough() const noexcept;

  int last_sweeps() const noexcept { return sweeps_; }  ///< that the last step took
  bool last_converged() const noexcept { return converged_; }
  /// Greatest relative error of the fractional laws' kernels up to longest_contact; 0 without such laws.
  double kernel_error() const noexcept { return kernel_error_; }
  std::size_t rebuilds() const noexcept { return rebuilds_; }  ///< of the neighbour list

  /// To be saved, between two steps.
  ClusterState state() const;
  /// Continues from a state saved with the same setup and options. Throws std::invalid_argument, all left as it was,
  /// for one of other spheres, walls or laws.
  void restore(ClusterState state);

 private:
  // The contacts of one interaction.
  struct Model {
    TangentialContact tangential;
    bool compliant, turns;
    ContactEnd end;
    double breakage_energy;
    std::optional<double> drag;       // of the normal law, where it is one
    double damping, turning_damping;  // of springs in the tangent plane
    std::unique_ptr<motion::NormalContacts> normal;
    std::size_t contacts = 0;            // how many there are
    std::vector<std::uint32_t> members;  // which of all, in a step that is solved by sweeps
    bool rubs() const noexcept {
      return tangential.friction.mu_static() > 0 || tangential.friction.rolling_arm() > 0 || tangential.rolling.mu > 0;
    }
  };
  struct Pulse {  // all that a contact passes
    double normal = 0;
    FrictionImpulse friction;
  };
  // A contact during a step that is solved by sweeps, besides its geometry and NormalRow.
  struct Row {
    SlipMobility mobility;
    SlipMotion before;
    Vec3 turning;
    FrictionSolution friction;
    Pulse before_sweep, direction;
  };
  // What a contact passes in a step that needs no sweeps, and what is to be booked of it.
  struct Passed {
    std::uint32_t i = 0, j = 0;
    Vec3 linear, on_i, on_j;  // impulse on i and torques
    double lost_normal = 0, lost_friction = 0, wall_work = 0;
  };
  // What a range's contact passes to a body.
  struct Gain {
    std::uint32_t body = 0;
    Vec3 linear, turning;
  };
  struct Losses {
    double normal = 0, friction = 0, wall_work = 0;
  };
  // Some of the spheres, with the candidates and contacts whose body i is one of them: what a thread takes.
  struct alignas(128) Range {
    std::uint32_t first = 0, last = 0;  // spheres first … last − 1, whole groups
    std::size_t first_candidate = 0, last_candidate = 0;
    bool listed = false;               // are all whom its spheres touch among the candidates?
    std::vector<std::size_t> changed;  // candidates that have met or parted
    std::vector<Gain> late;            // for bodies that an earlier range may reach, whose gains go first
  };
  // How a contact moved over a step, for its record.
  struct Course {
    double rate_mid = 0;
    SlipMotion before, after;
    bool sticks = false;
    double slip_fraction = 0;
  };
  // A body over a step: all that its contacts ask of it, side by side.
  struct Motion {
    Vec3 velocity, spin;          // at its start
    Vec3 velocity_mid, spin_mid;  // in its middle, foreseen; at last the mean of start and end
    Vec3 position;                // in its middle
    double radius = 0, inverse_mass = 0, inverse_inertia = 0;
  };

  void add_bodies(const ClusterSetup& setup);
  void add_models(const Interactions& interactions);
  std::uint32_t model_of(std::uint32_t i, std::uint32_t j) const noexcept;
  ContactGeometry geometry(std::uint32_t i, std::uint32_t j, bool disc = true) const noexcept;
  const motion::Surface& wall_of(std::uint32_t j) const noexcept { return walls_[j - size()]; }
  bool curved(std::uint32_t j) const noexcept;
  Vec3 branch(std::uint32_t i, std::uint32_t j) const noexcept;
  double middle() const noexcept { return time() + 0.5 * options_.step; }
  Vec3 wall_velocity(std::uint32_t i, std::uint32_t j) const noexcept;
  Vec3 wall_turning(const ContactState& c, double time_on) const noexcept;
  Vec3 swept(const ContactState& c, const ContactGeometry& g) const noexcept;
  Vec3 turning(const ContactState& c, const ContactGeometry& g, Vec3 velocity) const noexcept;
  void set_wall_velocities(double when) noexcept;
  double wall_work(const ContactState& c, const ContactGeometry& g, double normal, const FrictionImpulse& f,
                   Vec3 before) const noexcept;
  bool walls_moved() noexcept;
  bool crossed(const ContactState& c) const noexcept;
  void add_sphere(const Sphere& s);
  void renumber_walls(std::size_t spheres_before);
  Vec3 relative_velocity(std::uint32_t i, std::uint32_t j) const noexcept;
  SlipMotion slip_motion(const ContactState& c, const ContactGeometry& g, Vec3 velocity) const noexcept;
  SlipMotion slip_before(const ContactState& c, const ContactGeometry& g) const noexcept;
  SlipMotion mean_slip(const ContactState& c, const ContactGeometry& g) const noexcept;

  template <class Part>
  void each_range(const Part& part);
  void note_start(std::size_t first, std::size_t last) noexcept;
  void fall(std::size_t first, std::size_t last) noexcept;
  void kick_by_fields();
  void fly(std::size_t first, std::size_t last) noexcept;
  void note_end();
  void list_candidates();
  void split();
  bool find_changed();
  void find_touching();
  void exchange(const std::vector<ContactState>& born);
  void mark_closed();
  bool touches(std::uint32_t i, std::uint32_t j) const noexcept;
  ContactState begin_contact(std::uint32_t i, std::uint32_t j);
  void count_contacts() noexcept;
  void group_contacts();
  void finish(ContactState& contact, const ContactGeometry& g);
  void prepare_normals();
  void prepare_rows();
  void prepare_friction(std::size_t contact) noexcept;
  SlipMobility slip_mobility(const ContactState& contact, const ContactGeometry& g) const noexcept;
  Friction rigid_friction(const ContactState& contact, const ContactGeometry& g) const;
  double radius_eff(const ContactState& contact) const noexcept;
  template <bool Turns>
  motion::CompliantRow compliant_row(const ContactState& c, const ContactGeometry& g,
                                     double since_touch) const noexcept;
  motion::NormalRow normal_row(const ContactState& c, const ContactGeometry& g) const noexcept;
  void add_drag(const ContactState& c, std::int64_t sign) noexcept;
  void sum_drags() noexcept;
  bool needs_no_sweeps();
  ContactGeometry geometry_of(const ContactState& c) const noexcept;
  void foresee(std::size_t first, std::size_t last) noexcept;
  void begin_step();
  void pass_at_once();
  void end_step(std::size_t first, std::size_t last) noexcept;
  struct Workspace;
  void pass_range(Range& range);
  void pass_block(std::uint32_t first, std::uint32_t last, Workspace& space);
  template <class Act>
  void each_batch(Workspace& space, const Act& act);
  void gather(std::span<const Passed> passed, Range& range);
  void receive(const Gain& gain) noexcept;
  void add_late(std::size_t first, std::size_t last) noexcept;
  void book() noexcept;
  Vec3 pass_normal(const ContactState& c, const ContactGeometry& g, motion::NormalRow& along,
                   Passed& passed) const noexcept;
  void pass_tangential(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 velocity,
                       Passed& passed) const noexcept;
  bool slides_or_holds(const ContactState& c) const noexcept;
  void add_slide(const ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 velocity_mid,
                 motion::Slides& slides) const noexcept;
  void limit_slide(const ContactState& c, motion::Slides& slides, std::size_t lane) const noexcept;
  void pass_slides(Workspace& space) noexcept;
  Vec3 normal_then(const ContactState& c, const ContactGeometry& g, Vec3 velocity) const noexcept;
  template <bool Turns>
  void pass_springs(ContactState& c, const ContactGeometry& g, const motion::NormalRow& along, Vec3 velocity,
                    Passed& passed, Course& course) const noexcept;
  void book_wall(const ContactState& c, const ContactGeometry& g, const motion::NormalRow& along,
                 Passed& passed) const noexcept;
  void note_course(ContactState& c, const ContactGeometry& g, double rate_mid, Course course) const noexcept;
  motion::NormalBatch batch(const Model& model) noexcept;
  void push(const ContactState& c, const ContactGeometry& g, double normal) noexcept;
  void apply(const ContactState& c, const ContactGeometry& g, double normal, const FrictionImpulse& f) noexcept;
  double normal_impulse(const ContactState& contact, const motion::NormalRow& row, double rate_free) const noexcept;
  void pass_by_sweeps();
  double relax(std::size_t contact) noexcept;
  double accelerate(double last, bool restart) noexcept;
  void solve();
  void conclude();
  double friction_loss(std::size_t contact);
  double conclude_springs(std::size_t contact, const SlipMotion& mean);
  void note_phases(ContactState& contact, const ContactGeometry& g, const Course& course) const noexcept;
  void note_end_of_contact(ContactState& c, const ContactGeometry& g, const motion::NormalRow& row) const noexcept;
  EncounterEnd how_it_ended(const ContactState& contact, const ContactGeometry& g, double rate_mid) const noexcept;
  void note_breakage(ContactState& contact, double mobility) const noexcept;
  void check_contacts(const ClusterState& state) const;

  ClusterOptions options_;
  Vec3 gravity_;
  LongRangeForce long_range_;
  std::vector<double> radii_, masses_, inertias_;       // of spheres
  std::vector<double> inverse_mass_, inverse_inertia_;  // of bodies: spheres, then walls (0)
  std::vector<motion::Surface> walls_;
  bool walls_travel_ = false, walls_swing_ = false, walls_drive_ = false;
  double walls_listed_at_ = 0;  // time of the list
  Periodic periodic_;
  std::vector<std::size_t> materials_;  // of bodies
  std::size_t material_count_ = 0;
  std::vector<std::uint32_t> model_table_;
  std::vector<Model> models_;

  ClusterState state_;  // without contacts and memories; velocities and spins of walls follow those of the spheres
  ContactList contacts_;
  NeighbourList neighbours_;
  std::vector<NearPair> candidates_;
  std::vector<char> closed_;                 // whether they are in contact
  std::vector<std::uint32_t> separated_;     // contacts that are to end
  std::vector<Motion> motions_;              // of bodies
  std::vector<ContactState*> present_;       // the contacts of a step that is solved by sweeps
  std::vector<ContactGeometry> geometries_;  // of the same contacts, in the middle of the step
  std::vector<motion::NormalRow> normals_;   // of the same contacts
  std::vector<std::int64_t> drags_;          // of bodies; whole numbers, so that their sums do not depend on the order
  std::int64_t braked_ = 0;                  // bodies with too many
  bool drags_vary_ = false;                  // from step to step in a contact
  std::vector<Row> rows_;                    // of the same contacts, else
  std::vector<motion::CompliantRow> springs_;  // of the same contacts; none where no interaction has any
  bool has_springs_ = false;
  std::vector<Vec3> field_forces_;
  std::vector<Encounter> finished_;
  std::unique_ptr<motion::Workers> workers_;  // where there are several
  std::vector<Range> ranges_;                 // one for each
  std::vector<std::uint32_t> lowest_;         // of spheres, the least i of candidates that have them for j
  std::vector<Losses> losses_;                // of a step, by groups of spheres i, whatever the number of threads
  Instructions instructions_ = widest_instructions();
  std::size_t rebuilds_ = 0;
  int sweeps_ = 0;
  bool converged_ = true;
  double kernel_error_ = 0;
};

}  // namespace ricochet
