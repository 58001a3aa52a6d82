/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(lb/ibb,FixLbIbb);
// clang-format on
#else

#ifndef LMP_FIX_LB_IBB_H
#define LMP_FIX_LB_IBB_H

#include "fix.h"

#include "lb_ibb_options.h"
#include "lb_ibb_radius.h"
#include "lbm_balance.h"
#include "lbm_units.h"

#include <memory>

namespace lbm {
class MpiNeighbours;
struct Sample;
}    // namespace lbm

namespace LAMMPS_NS {

// The adapter between LAMMPS and the lattice-Boltzmann solver: hands grains in and forces out,
// and holds no lattice arithmetic.
class FixLbIbb : public Fix {
 public:
  FixLbIbb(class LAMMPS *, int, char **);
  ~FixLbIbb() override;
  void post_constructor() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void end_of_step() override;
  void post_run() override;
  void reset_dt() override;

  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;

  void reset_grid() override;
  int get_grid_by_name(const std::string &, int &) override;
  void *get_grid_by_index(int) override;
  int get_griddata_by_name(int, const std::string &, int &) override;
  void *get_griddata_by_index(int) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;

  void write_restart(FILE *) override;
  void write_restart_file(const char *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int maxsize_restart() override;
  int size_restart(int) override;

  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_reverse_comm_size(int, int) override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;

  // for computes; all physical but nodes. profile() is collective, and costs a pass over the fluid.
  bool has_fluid() const { return fluid != nullptr; }
  const lbm::Int3 &lattice_nodes() const { return nodes; }
  double spacing() const { return options.dx; }
  double density() const { return options.rho; }
  double viscosity() const { return options.nu; }
  bool has_wall(int d, int side) const { return options.face[d][side].kind == lbm::FaceKind::WALL; }
  const lbm::Vec3 &face_velocity(int d, int side) const    // of the last fluid step
  {
    return drive.u[d][side];
  }
  bool has_buoyancy() const { return options.has_buoyancy; }
  const lbm::Vec3 &gravity() const { return drive.buoyancy; }    // of the last fluid step
  double hydrodynamic_radius(int i) const;
  bool is_driven(int i) const;         // by forces, from init() on
  double drawn_radius(int i) const;    // of the sphere that the fluid sees, in cells
  std::vector<lbm::Layer> profile(int axis, int width);    // in layers of width nodes

  // for fix lb/ibb/vtk: nodes of this rank, and a field (see get_griddata_by_name()) at some of
  // them; the latter is collective, and stops for what no output may show
  lbm::Part own_nodes() const;
  std::vector<float> sample(int field, const lbm::Sample &which);

 private:
  LBOptions options;
  lbm::Units units;
  lbm::Int3 nodes;                           // of the whole lattice
  std::unique_ptr<class LBFields> fields;    // also decides which nodes are this rank's
  std::unique_ptr<lbm::MpiNeighbours> neighbours;
  std::unique_ptr<lbm::Fluid> fluid;
  std::unique_ptr<LBRadius> radii;    // with radius calibrated
  bigint fluid_steps, first_step, last_step;
  // from then on the fluid is not made anew
  bool has_started() const;
  // a run is timed from its set-up, or from its first fluid step if there is none (run pre no)
  struct Clock {
    bool running = false;
    bigint first = 0;                  // fluid_steps at its start
    double start = 0.0, loop = 0.0;    // wall time; of the whole loop once it is over
    double fluid = 0.0, grains = 0.0;
  } clock;
  void start_clock();
  double speed() const;    // million nodes a second

  // columns of array_atom, which is for all to see, SHARE as in share_nodes(); and of history:
  // force and torque before the last fluid step, those of that step alone, where the grain was
  // then, fluid steps it has seen, the mean density excess around it, the mass it will give back
  // and that it swallowed, and what of its volume counts for others of its clump
  enum { FORCE = 0, TORQUE = 3, SHARE = 6, SHOWN = 7 };
  enum { BEFORE = 0, LAST = 6, PLACE = 12, AGE = 15, EXCESS = 16, REFUND = 17, SWALLOWED = 18 };
  enum { SHARED = 19 };
  static constexpr int COLUMNS = 20;
  double **history;
  // by local and ghost atom; out go place, velocity, spin, EXCESS and REFUND, back come force,
  // torque, the two sums whose ratio is the density excess, and the mass swallowed
  enum { OUT = 11, BACK = 9 };
  double **ghosted;
  int nghosted;
  std::vector<int> sphere_atom;    // atom behind each sphere handed in
  std::vector<lbm::Sphere> spheres;
  std::vector<lbm::Load> loads;
  lbm::Survey survey;
  bigint survey_step;
  // the grain whose surface was fastest in the last fluid step, lattice units
  struct Fastest {
    double speed, id;
    lbm::Vec3 place;
  } fastest;

  // set-up, in fix_lb_ibb_setup.cpp
  void check_box();
  void check_scene();
  void check_cut();
  void check_averages();
  void check_offset();
  void check_order_of_fixes();
  // of two dimensions, in fix_lb_ibb_discs.cpp
  void check_discs();
  void check_disc_masses();
  bool warned_of_masses;
  std::uint64_t grains_known;    // see grains_changed()
  // of spheres in one body, in fix_lb_ibb_clumps.cpp
  bool has_clumps() const;
  std::vector<char> in_bodies() const;
  double displaced_volume(int i) const;
  void share_volumes();
  void find_variables();
  void review_setup();
  void provide_ghosts();
  void create_fluid();
  void print_summary(double smallest, double largest, double pressure_difference);
  std::string expected_errors(double smallest);
  double largest_radius(double &smallest);

  // the step
  // what drives the fluid, from variables and constants; physical
  struct Drive {
    lbm::Vec3 force, gradp, buoyancy;    // force on a volume of fluid, gradp's part included
    lbm::Vec3 u[3][2];                   // at the faces
    double p[3][2];
    double pressure_difference, face_speed;    // largest at the faces, the former from rest as well
  } drive;
  lbm::Vec3 buoyancy_before;
  double evaluate(const LBValue &value);
  Drive evaluate_all();
  lbm::Vec3 driving_force(const Drive &with) const;
  void drive_fluid(const Drive &with);
  void check_faces();
  void add_forces(double **held, const lbm::Vec3 &gravity);
  bool grains_changed();
  void place_grains();
  void give_forces();
  void share_nodes();

  // regions as solids, in fix_lb_ibb_obstacle.cpp: none of this is there without them
  enum { NUMBERS = 30, LOAD = 6 };        // outputs of all scenes, and of each obstacle
  std::vector<lbm::ShapeReview> found;    // of each, when the fluid was made
  std::vector<lbm::Shape> shapes();
  void make_obstacles();
  void check_obstacles();
  std::string describe_obstacles();
  double obstacle_speed() const;
  double obstacle_load(int n);

  // light grains, in fix_lb_ibb_light.cpp: none of this is there without them
  class FixStoreAtom *light;
  // groups of fixes that integrate grains, that hold them where forces do not matter, that replace
  // forces, and that have several or no say in how grains move
  int moving_bits, held_bits, set_bits, tied_bits;
  enum { TOLD = lbm::Response::SIZE + 12 };
  std::vector<std::array<double, TOLD>> told;    // by local and ghost atom, between ranks
  enum { LOADS, RESPONSES } about;               // what ranks exchange now
  // zeta (1 + M^-1 zeta dt)^-1 by local atom, as long as it is that of this grain, step and mass
  struct Yielding {
    bigint grain = -1, fluid_step = -1;
    double per_mass[2] = {};
    std::array<double, 36> less{};
  };
  std::vector<Yielding> yieldings;
  void find_integrators();
  void provide_light();
  void forget_light();
  bool is_light(int i) const;
  double density_ratio(int i) const;
  bool below_limit(int i) const;
  void yield(bool start, bool before);
  void correct_fluid();
  void keep_responses();
  bigint light_grains() const;
  void warn_of_loose();

  // restart files, in fix_lb_ibb_restart.cpp
  struct Saved;             // what LAMMPS's own file holds of the fluid
  struct SavedObstacle {    // follows that, one for each, and a checksum of them
    lbm::ObstacleState state;
    std::uint64_t shape = 0;    // its checksum
  };
  std::vector<SavedObstacle> obstacles_to_go_on;
  std::shared_ptr<const Saved> to_write, to_go_on;    // until the fluid itself is written or read
  bool was_saved;                                     // in the restart file that was read?
  bool starts_anew;                                   // although it was
  void read_fluid();
  void go_on_with_obstacles();

  // momentum where nothing holds fluid and grains, in fix_lb_ibb_balance.cpp; else there is none
  std::unique_ptr<lbm::Balance> balance;
  void provide_balance();
  bool nothing_holds(double &volume) const;
  bool keeps_momentum() const;
  void keep_momentum();

  // mass ledger, in fix_lb_ibb_ledger.cpp; its entries are the last of the global vector
  enum { FIRST_OF_LEDGER = 14, UNACCOUNTED = lbm::Ledger::ACCOUNTS };
  double unaccounted(const lbm::Ledger &ledger);
  double ledger_entry(int n);
  std::string ledger_report() const;

  // watching
  void take_survey();
  lbm::Vec3 total_force();

  // what no run may go on with: grains in fix_lb_ibb_inspect.cpp, fluid in fix_lb_ibb_tripwire.cpp
  bool is_loose(int i) const;
  std::string cause_of_loose() const;
  // gravest thing a rank has found wrong with one of its grains in this fluid step; lattice units
  struct Trouble {
    enum Kind { NONE, SMALL, FAST, MOVED, NO_NUMBER };
    double kind, value, id, radius, density, speed,
        loose;          // loose: see is_loose()
    lbm::Vec3 place;    // physical
  } trouble;
  void inspect_grain(int i, double *place_and_motion);
  void inspect_force(int i, const double *force);
  void note(Trouble::Kind kind, int i, double value);
  void stop_for_trouble();
  struct Neighbour;    // grain nearest to a node
  Neighbour nearest_grain(const lbm::Vec3 &at);
  void check_stability();
  void find_fastest();
  bool warned_of_speed;    // in this run
  void warn_of_speed(const lbm::Int3 &node);
  lbm::Vec3 place_of(const lbm::Int3 &node) const;
  bool near_open_face(const lbm::Int3 &node) const;
  std::string likely_cause(const lbm::Int3 &node, const Neighbour &grain);
  [[noreturn]] void stop(const lbm::Int3 &node, const std::string &what, double drho, double speed);
};

}    // namespace LAMMPS_NS
#endif
#endif
