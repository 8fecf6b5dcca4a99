// What the examples dem and drum have in common: spheres with linear springs and dashpots, Coulomb
// friction that remembers (P. A. Cundall and O. D. L. Strack, A discrete numerical model for
// granular assemblies, Geotechnique 29, 1979, 47-65), gravity, and walls of triangles that may
// turn.
#pragma once

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace grains {

using Vec = abut::Vector;
using Triangle = std::array<int, 3>;
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(double s, const Vec& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Vec& a) {
  return std::sqrt(dot(a, a));
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr double stiffness = 1e4, tangential = 0.8e4, damping = 10.0, friction = 0.5;

/// What a contact remembers: how far its surfaces are displaced along each other.
struct Spring {
  Vec stretch{};
};

struct Ledger {
  double elastic = 0.0, dissipated = 0.0, work = 0.0;  ///< work: of the walls on the spheres
  double damping_power = 0.0, wall_power = 0.0;        ///< at this instant
};

/// How the first of two surfaces moves along the second where they touch: since the step before,
/// and how fast now.
struct Sliding {
  Vec moved, velocity;
};

inline double energy(const Spring& spring) {
  return 0.5 * tangential * dot(spring.stretch, spring.stretch);
}

/// Two surfaces that press on each other; `normal` points from the first to the second. Returns the
/// force on the first.
inline Vec contact_force(double overlap, const Vec& normal, const Sliding& sliding, Spring& spring,
                         Ledger& ledger) {
  const double approach = dot(sliding.velocity, normal);
  const double pressure = stiffness * overlap + damping * approach;
  // The spring turns with the surfaces, and is as long as before.
  const double before = length(spring.stretch);
  Vec stretch = spring.stretch - dot(spring.stretch, normal) * normal;
  const double flat = length(stretch);
  if (flat > 0.0) stretch = before / flat * stretch;
  stretch = stretch + sliding.moved - dot(sliding.moved, normal) * normal;
  const double wanted = length(stretch);
  const double most = friction * std::max(pressure, 0.0) / tangential;
  if (wanted > most) {
    stretch = most / wanted * stretch;
    ledger.dissipated += tangential * 0.5 * (std::min(before, wanted) + most) * (wanted - most);
  }
  spring.stretch = stretch;
  ledger.elastic += 0.5 * stiffness * overlap * overlap + energy(spring);
  ledger.damping_power += damping * approach * approach;
  return -pressure * normal - tangential * stretch;
}

/// What a step spends its time on; contacts are found and measured in one.
enum Phase { search, history, forces, integration, phases };

/// One thread: the loop over forces has no more.
inline const abut::Options pair_options{.quantities = abut::Quantity::gap | abut::Quantity::normal,
                                        .threads = 1};
inline const abut::Options wall_options{
    .quantities = abut::Quantity::gap | abut::Quantity::normal | abut::Quantity::point,
    .threads = 1};

class Grains {
 public:
  /// The walls turn around the axis x with `turning` radians in a unit of time.
  Grains(double step, Vec gravity, abut::TriangleMesh walls, double turning = 0.0)
      : dt_(step), gravity_(gravity), walls_(std::move(walls)), turning_(turning) {
    detector_.set_skin(abut::Skin::automatic());
  }

  void add(const Vec& x, const Vec& v, double radius) {
    x_.push_back(x);
    v_.push_back(v);
    radius_.push_back(radius);
    mass_.push_back(8.0 * radius * radius * radius);
    spin_.push_back({});
    force_.push_back({});
    torque_.push_back({});
  }

  /// Velocity Verlet.
  void step() {
    last_lap_ = std::clock();
    push();
    for (std::size_t k = 0; k < x_.size(); ++k) x_[k] = x_[k] + dt_ * v_[k];
    ++steps_;
    if (turning_ != 0.0) {
      const double c = std::cos(turning_ * dt_ * steps_), s = std::sin(turning_ * dt_ * steps_);
      walls_.move({{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}, {}});
    }
    lap(integration);
    find_forces(dt_);
    push();
    lap(integration);
  }

  /// Forces where the elements are, `dt` after the last ones: velocities are those of the middle of
  /// the step, and damping sees what they will be at its end. Needed once before the first step.
  void find_forces(double dt = 0.0) {
    last_lap_ = std::clock();
    const abut::ElementView spheres = abut::spheres(x_, radius_);
    const abut::PairList& pairs = detector_.find_contact_pairs(spheres);
    const abut::MeshContactList& walls = wall_detector_.find_mesh_contacts(spheres, walls_);
    lap(search);
    choose(walls);
    history_.update(pairs, spheres);
    wall_history_.update(std::span<const abut::MeshContact>(touching_), spheres, walls_);
    lap(history);
    contacts_ = pairs.size();
    const Ledger before = std::exchange(ledger_, {});
    foretell(dt);
    for (std::size_t k = 0; k < pairs.size(); ++k) press_pair(pairs, k, dt);
    for (std::size_t k = 0; k < touching_.size(); ++k) press_wall(walls, k, dt);
    settle_accounts(before, dt);
    lap(forces);
  }

  /// Prints energies and contacts. The ledger is by how much energies and dissipation differ from
  /// those at the start and the work of the walls, the momentum likewise, as a fraction.
  void print(const char* title) {
    double kinetic = 0.0, potential = 0.0, scale = 0.0;
    Vec momentum{};
    for (std::size_t k = 0; k < x_.size(); ++k) {
      kinetic += 0.5 * mass_[k] * dot(v_[k], v_[k]) + 0.5 * inertia(k) * dot(spin_[k], spin_[k]);
      potential -= mass_[k] * dot(gravity_, x_[k]);
      momentum = momentum + mass_[k] * v_[k];
      scale += mass_[k] * length(v_[k]);
    }
    const double sum = kinetic + potential + ledger_.elastic + ledger_.dissipated - ledger_.work;
    if (steps_ == 0) {
      start_ = sum, start_momentum_ = momentum;
      range_ = std::fabs(kinetic) + std::fabs(potential);
    }
    std::printf(
        "%s step %d: %d contacts, %d on walls, kinetic %.6g, potential %.6g, elastic %.4g, "
        "dissipated %.6g, work %.6g, ledger %.2e, momentum %.1e\n",
        title, steps_, static_cast<int>(contacts_), static_cast<int>(touching_.size()), kinetic,
        potential, ledger_.elastic, ledger_.dissipated, ledger_.work,
        (sum - start_) / std::max(range_, std::fabs(ledger_.work)),
        scale > 0 ? length(momentum - start_momentum_) / scale : 0);
  }

  /// Seconds of processor time that went into each phase.
  [[nodiscard]] const std::array<double, phases>& seconds() const { return seconds_; }
  void forget_seconds() { seconds_ = {}; }

  /// All that a run goes on from; the detector and its skin are no part of it.
  struct State {
    std::vector<Vec> x, v, spin, force, torque;
    std::vector<Spring> springs, wall_springs;
    Ledger ledger;
    int steps;
  };
  [[nodiscard]] State state() const {
    const auto springs = history_.values(), wall_springs = wall_history_.values();
    return {x_,
            v_,
            spin_,
            force_,
            torque_,
            {springs.begin(), springs.end()},
            {wall_springs.begin(), wall_springs.end()},
            ledger_,
            steps_};
  }
  void resume(const State& from) {
    x_ = from.x;
    find_forces();  // for the lists of contacts, in which the springs lie
    v_ = from.v, spin_ = from.spin, force_ = from.force, torque_ = from.torque;
    std::copy(from.springs.begin(), from.springs.end(), history_.values().begin());
    std::copy(from.wall_springs.begin(), from.wall_springs.end(), wall_history_.values().begin());
    ledger_ = from.ledger, steps_ = from.steps;
  }
  [[nodiscard]] bool equals(const Grains& other) const {
    return x_ == other.x_ && v_ == other.v_ && spin_ == other.spin_;
  }

  [[nodiscard]] const std::vector<Vec>& positions() const { return x_; }
  /// Wall contacts that went on to the next feature in the last step.
  [[nodiscard]] std::size_t passed_on() const { return wall_history_.passed_on().size(); }

  void write_frame(const std::string& path) const {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) std::perror(path.c_str()), std::exit(5);
    std::fprintf(
        file,
        "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"%zu\">"
        "<PointData Scalars=\"radius\"><DataArray type=\"Float64\" Name=\"radius\" "
        "format=\"ascii\">\n",
        x_.size());
    for (const double radius : radius_) std::fprintf(file, "%.9g\n", radius);
    std::fprintf(file,
                 "</DataArray></PointData><Points><DataArray type=\"Float64\" "
                 "NumberOfComponents=\"3\" format=\"ascii\">\n");
    for (const Vec& x : x_) std::fprintf(file, "%.9g %.9g %.9g\n", x[0], x[1], x[2]);
    std::fprintf(file, "</DataArray></Points></Piece></PolyData></VTKFile>\n");
    std::fclose(file);
  }

 private:
  void lap(Phase phase) {
    const std::clock_t now = std::clock();
    seconds_[phase] += static_cast<double>(now - last_lap_) / CLOCKS_PER_SEC;
    last_lap_ = now;
  }

  [[nodiscard]] double inertia(std::size_t k) const {
    return 0.4 * mass_[k] * radius_[k] * radius_[k];
  }

  /// Half a step of the velocities.
  void push() {
    for (std::size_t k = 0; k < x_.size(); ++k) {
      v_[k] = v_[k] + 0.5 * dt_ / mass_[k] * force_[k];
      spin_[k] = spin_[k] + 0.5 * dt_ / inertia(k) * torque_[k];
    }
  }

  /// Velocities at the end of the step, as the last forces have them; then forces begin anew.
  void foretell(double dt) {
    foretold_.resize(x_.size()), foretold_spin_.resize(x_.size());
    for (std::size_t k = 0; k < x_.size(); ++k) {
      foretold_[k] = v_[k] + 0.5 * dt / mass_[k] * force_[k];
      foretold_spin_[k] = spin_[k] + 0.5 * dt / inertia(k) * torque_[k];
      force_[k] = mass_[k] * gravity_;
      torque_[k] = {};
    }
  }

  /// In a round wall a sphere touches two facets for a while. Of contacts whose normals nearly
  /// agree the deepest alone counts: then the energy does not jump where the sphere leaves one, and
  /// the spring goes on to the next.
  void choose(const abut::MeshContactList& walls) {
    const auto gaps = walls.gaps();
    const auto normals = walls.normals();
    touching_.clear(), places_.clear();
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const auto hides = [&, k](std::size_t other) {
        return other < walls.size() && walls[other].sphere == walls[k].sphere;
      };
      bool deepest = true;
      std::size_t other = k;
      while (other > 0 && hides(other - 1)) --other;
      for (; hides(other); ++other) {
        if (other == k || dot(normals[k], normals[other]) < 0.5) continue;
        if (gaps[other] < gaps[k] || (gaps[other] == gaps[k] && other < k)) deepest = false;
      }
      if (deepest) touching_.push_back(walls[k]), places_.push_back(k);
    }
  }

  void press_pair(const abut::PairList& pairs, std::size_t k, double dt) {
    const auto [i, j] = pairs[k];
    const Vec& normal = pairs.normals()[k];
    const Vec turn = radius_[i] * spin_[i] + radius_[j] * spin_[j];
    const Vec turn_now = radius_[i] * foretold_spin_[i] + radius_[j] * foretold_spin_[j];
    const Sliding sliding{dt * (v_[i] - v_[j] + cross(turn, normal)),
                          foretold_[i] - foretold_[j] + cross(turn_now, normal)};
    const Vec force =
        contact_force(-pairs.gaps()[k], normal, sliding, history_.values()[k], ledger_);
    force_[i] = force_[i] + force;
    force_[j] = force_[j] - force;
    torque_[i] = torque_[i] + radius_[i] * cross(normal, force);
    torque_[j] = torque_[j] + radius_[j] * cross(normal, force);
  }

  void press_wall(const abut::MeshContactList& walls, std::size_t k, double dt) {
    const abut::ElementIndex i = touching_[k].sphere;
    const Vec& normal = walls.normals()[places_[k]];
    const Vec& point = walls.points()[places_[k]];
    const Vec wall = cross({turning_, 0, 0}, point);  // its velocity there
    const Sliding sliding{dt * (v_[i] - wall + radius_[i] * cross(spin_[i], normal)),
                          foretold_[i] - wall + radius_[i] * cross(foretold_spin_[i], normal)};
    const Vec force = contact_force(-walls.gaps()[places_[k]], normal, sliding,
                                    wall_history_.values()[k], ledger_);
    force_[i] = force_[i] + force;
    torque_[i] = torque_[i] + radius_[i] * cross(normal, force);
    ledger_.wall_power += dot(force, wall);
  }

  /// Adds what was dissipated and done up to now: powers by the trapezoidal rule, and springs that
  /// were left.
  void settle_accounts(const Ledger& before, double dt) {
    ledger_.dissipated += before.dissipated;
    ledger_.dissipated += 0.5 * dt * (before.damping_power + ledger_.damping_power);
    for (const auto& lost : history_.lost()) ledger_.dissipated += energy(lost.value);
    for (const auto& lost : wall_history_.lost()) ledger_.dissipated += energy(lost.value);
    ledger_.work = before.work + 0.5 * dt * (before.wall_power + ledger_.wall_power);
  }

  double dt_;
  Vec gravity_;
  abut::TriangleMesh walls_;
  double turning_;
  std::vector<Vec> x_, v_, spin_, force_, torque_, foretold_, foretold_spin_;
  std::vector<double> radius_, mass_;
  abut::Detector detector_{pair_options}, wall_detector_{wall_options};
  std::vector<abut::MeshContact> touching_;  ///< the deepest contacts with walls
  std::vector<std::size_t> places_;          ///< of each its place in the list of all
  abut::ContactHistory<Spring> history_;
  abut::MeshContactHistory<Spring> wall_history_;
  Ledger ledger_;
  abut::PairCount contacts_ = 0;
  int steps_ = 0;
  Vec start_momentum_{};
  double start_ = 0.0, range_ = 1.0;
  std::array<double, phases> seconds_{};
  std::clock_t last_lap_ = 0;
};

/// Multiples of 2^-31 in [-1, 1), the same everywhere.
inline double noise(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 32) * 0x1p-31 - 1.0;
}

}  // namespace grains
