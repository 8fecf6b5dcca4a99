// A small discrete element method on abut's public interface: spheres with linear springs and
// dashpots, Coulomb friction that remembers (P. A. Cundall and O. D. L. Strack, A discrete
// numerical model for granular assemblies, Geotechnique 29, 1979, 47-65), planes and gravity.
//
//   dem settle N STEPS DT [FRAMES]   rain into a box         dem column ...   a column collapses
//   dem fly ...                      a cloud without walls   dem restart ...  settle, halfway anew
//
// Prints energies and contacts; the ledger is by how much energy and dissipation differ from those
// at the start, the momentum likewise, as a fraction. FRAMES: a prefix of VTP files for ParaView.
#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using Vec = std::array<double, 3>;
Vec operator+(const Vec& a, const Vec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec operator-(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec operator*(double s, const Vec& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length(const Vec& a) {
  return std::sqrt(dot(a, a));
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr double stiffness = 1e4, tangential = 0.8e4, damping = 10.0, friction = 0.5;
constexpr double spacing = 1.05;  // of the lattice to begin with; diameters are 0.8 to 1

/// What a contact remembers: how far its surfaces are displaced along each other.
struct Spring {
  Vec stretch{};
};

struct Plane {
  Vec point, normal;  // the normal points to where the spheres are
};

struct Ledger {
  double elastic = 0.0, dissipated = 0.0;
};

/// How the first of two surfaces moves along the second where they touch: since the step before,
/// and how fast now.
struct Sliding {
  Vec moved, velocity;
};

/// Two surfaces that press on each other; `normal` points from the first to the second. Returns the
/// force on the first.
Vec contact_force(double overlap, const Vec& normal, const Sliding& sliding, double dt,
                  Spring& spring, Ledger& ledger) {
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
  ledger.elastic += 0.5 * stiffness * overlap * overlap + 0.5 * tangential * dot(stretch, stretch);
  ledger.dissipated += damping * approach * approach * dt;
  return -pressure * normal - tangential * stretch;
}

class Dem {
 public:
  Dem(double step, Vec gravity) : dt_(step), gravity_(gravity) {
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
  void add(const Plane& plane) { planes_.push_back(plane); }

  /// Velocity Verlet.
  void step() {
    for (std::size_t k = 0; k < x_.size(); ++k) {
      v_[k] = v_[k] + 0.5 * dt_ / mass_[k] * force_[k];
      spin_[k] = spin_[k] + 0.5 * dt_ / inertia(k) * torque_[k];
      x_[k] = x_[k] + dt_ * v_[k];
    }
    find_forces(dt_);
    for (std::size_t k = 0; k < x_.size(); ++k) {
      v_[k] = v_[k] + 0.5 * dt_ / mass_[k] * force_[k];
      spin_[k] = spin_[k] + 0.5 * dt_ / inertia(k) * torque_[k];
    }
    ++steps_;
  }

  /// Forces where the elements are, `dt` after the last ones: velocities are those of the middle of
  /// the step, and damping sees what they will be at its end. Needed once before the first step.
  void find_forces(double dt = 0.0) {
    const abut::ElementView spheres = abut::spheres(x_, radius_);
    const abut::PairList& pairs = detector_.find_contact_pairs(spheres);
    history_.update(pairs, spheres);
    contacts_ = pairs.size();
    ledger_.elastic = 0.0;
    wall_springs_.resize(planes_.size() * x_.size());
    foretold_.resize(x_.size()), foretold_spin_.resize(x_.size());
    for (std::size_t k = 0; k < x_.size(); ++k) {
      foretold_[k] = v_[k] + 0.5 * dt / mass_[k] * force_[k];
      foretold_spin_[k] = spin_[k] + 0.5 * dt / inertia(k) * torque_[k];
      force_[k] = mass_[k] * gravity_;
      torque_[k] = {};
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const Vec apart = x_[j] - x_[i];
      const double distance = length(apart);
      const Vec normal = 1.0 / distance * apart;
      const Vec turn = radius_[i] * spin_[i] + radius_[j] * spin_[j];
      const Vec turn_now = radius_[i] * foretold_spin_[i] + radius_[j] * foretold_spin_[j];
      const Sliding sliding{dt * (v_[i] - v_[j] + cross(turn, normal)),
                            foretold_[i] - foretold_[j] + cross(turn_now, normal)};
      const Vec force = contact_force(radius_[i] + radius_[j] - distance, normal, sliding, dt,
                                      history_.values()[k], ledger_);
      force_[i] = force_[i] + force;
      force_[j] = force_[j] - force;
      torque_[i] = torque_[i] + radius_[i] * cross(normal, force);
      torque_[j] = torque_[j] + radius_[j] * cross(normal, force);
    }
    for (std::size_t p = 0; p < planes_.size(); ++p) push_back(p, dt);
  }

  void print(const char* title) {
    double kinetic = 0.0, potential = 0.0, scale = 0.0;
    Vec momentum{};
    for (std::size_t k = 0; k < x_.size(); ++k) {
      kinetic += 0.5 * mass_[k] * dot(v_[k], v_[k]) + 0.5 * inertia(k) * dot(spin_[k], spin_[k]);
      potential -= mass_[k] * dot(gravity_, x_[k]);
      momentum = momentum + mass_[k] * v_[k];
      scale += mass_[k] * length(v_[k]);
    }
    const double sum = kinetic + potential + ledger_.elastic + ledger_.dissipated;
    if (steps_ == 0) {
      start_ = sum, start_momentum_ = momentum;
      range_ = std::fabs(kinetic) + std::fabs(potential);
    }
    std::printf(
        "%s step %d: %d contacts, kinetic %.6g, potential %.6g, elastic %.4g, dissipated "
        "%.6g, ledger %.2e, momentum %.1e\n",
        title, steps_, static_cast<int>(contacts_), kinetic, potential, ledger_.elastic,
        ledger_.dissipated, (sum - start_) / range_,
        scale > 0 ? length(momentum - start_momentum_) / scale : 0);
  }

  /// All that a run goes on from; the detector and its skin are no part of it.
  struct State {
    std::vector<Vec> x, v, spin, force, torque;
    std::vector<Spring> springs, wall_springs;
    Ledger ledger;
  };
  [[nodiscard]] State state() const {
    const auto springs = history_.values();
    return {x_,     v_, spin_, force_, torque_, {springs.begin(), springs.end()}, wall_springs_,
            ledger_};
  }
  void resume(const State& from) {
    x_ = from.x;
    find_forces();  // for the list of contacts, in which the springs lie
    v_ = from.v, spin_ = from.spin, force_ = from.force, torque_ = from.torque;
    std::copy(from.springs.begin(), from.springs.end(), history_.values().begin());
    wall_springs_ = from.wall_springs, ledger_ = from.ledger;
  }
  [[nodiscard]] bool equals(const Dem& other) const {
    return x_ == other.x_ && v_ == other.v_ && spin_ == other.spin_;
  }

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
  [[nodiscard]] double inertia(std::size_t k) const {
    return 0.4 * mass_[k] * radius_[k] * radius_[k];
  }

  /// A plane on all spheres: few enough to try each.
  void push_back(std::size_t p, double dt) {
    const Plane& plane = planes_[p];
    for (std::size_t k = 0; k < x_.size(); ++k) {
      Spring& spring = wall_springs_[p * x_.size() + k];
      const double overlap = radius_[k] - dot(x_[k] - plane.point, plane.normal);
      if (overlap < 0.0) {
        spring = {};
        continue;
      }
      const Vec normal = -1.0 * plane.normal;
      const Sliding sliding{dt * (v_[k] + radius_[k] * cross(spin_[k], normal)),
                            foretold_[k] + radius_[k] * cross(foretold_spin_[k], normal)};
      const Vec force = contact_force(overlap, normal, sliding, dt, spring, ledger_);
      force_[k] = force_[k] + force;
      torque_[k] = torque_[k] + radius_[k] * cross(normal, force);
    }
  }

  double dt_;
  Vec gravity_;
  std::vector<Vec> x_, v_, spin_, force_, torque_, foretold_, foretold_spin_;
  std::vector<double> radius_, mass_;
  std::vector<Plane> planes_;
  std::vector<Spring> wall_springs_;
  abut::Detector detector_;
  abut::ContactHistory<Spring> history_;
  Ledger ledger_;
  abut::PairCount contacts_ = 0;
  int steps_ = 0;
  Vec start_momentum_{};
  double start_ = 0.0, range_ = 1.0;
};

/// Multiples of 2^-31 in [-1, 1), the same everywhere.
double noise(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 32) * 0x1p-31 - 1.0;
}

/// `count` spheres on a lattice of `side` columns each way, with some disorder.
void fill(Dem& dem, int count, int side, double speed) {
  std::uint64_t state = 1;
  const auto random = [&] { return noise(state); };
  for (int k = 0; k < count; ++k) {
    const Vec cell{0.5 + k % side, 0.5 + k / side % side, 0.5 + k / side / side};
    dem.add(spacing * cell, speed * Vec{random(), random(), random()}, 0.45 + 0.05 * random());
  }
}

Dem make(const std::string& what, int count, double dt) {
  const int side = std::max(2, static_cast<int>(std::cbrt(count / (what == "column" ? 3.0 : 1.5))));
  const double wall = spacing * side;
  Dem dem(dt, what == "fly" ? Vec{} : Vec{0.0, 0.0, -1.0});
  fill(dem, count, side, what == "fly" ? 2.0 : 0.2);
  if (what == "fly") return dem;
  dem.add(Plane{{0, 0, 0}, {0, 0, 1}});
  if (what == "column") return dem;  // nothing holds it
  dem.add(Plane{{0, 0, 0}, {1, 0, 0}});
  dem.add(Plane{{0, 0, 0}, {0, 1, 0}});
  dem.add(Plane{{wall, 0, 0}, {-1, 0, 0}});
  dem.add(Plane{{0, wall, 0}, {0, -1, 0}});
  return dem;
}

/// Stops halfway and goes on in another program's place: both must end with the same bits.
int check_restart(Dem& dem, int count, int steps, double dt) {
  for (int step = 0; step < steps / 2; ++step) dem.step();
  Dem other = make("settle", count, dt);
  other.resume(dem.state());
  for (int step = 0; step < steps / 2; ++step) dem.step(), other.step();
  std::printf("restart: %s\n", dem.equals(other) ? "the same bits" : "DIFFERENT");
  return dem.equals(other) ? 0 : 7;
}

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "settle";
  const int count = argc > 2 ? std::atoi(argv[2]) : 300;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 2000;
  const double dt = argc > 4 ? std::atof(argv[4]) : 5e-4;
  if (count < 1 || steps < 1 || !(dt > 0.0)) {
    std::fprintf(stderr, "usage: dem settle|column|fly|restart N STEPS DT [FRAMES]\n");
    return 2;
  }
  Dem dem = make(what, count, dt);
  dem.find_forces();
  if (what == "restart") return check_restart(dem, count, steps, dt);
  dem.print(what.c_str());
  for (int step = 1; step <= steps; ++step) {
    dem.step();
    if (step % std::max(steps / 5, 1) != 0) continue;
    dem.print(what.c_str());
    if (argc > 5) dem.write_frame(argv[5] + std::to_string(step) + ".vtp");
  }
  return 0;
}
