// Material point method: the motion of bodies, against closed forms and against a textbook.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

// ---- motion of a free body --------------------------------------------------------------------------------------------------

TEST(Simulate, LetsABlockFall) {
  Model model = block(3, 3, 4, 3, elastic);
  throw_all(model, 1, 0);
  const auto x0 = model.points.x;
  const auto y0 = model.points.y;
  const Outcome outcome = simulate(model);
  // Symplectic Euler falls g t (t + dt) / 2; rounding of strains times the stiffness leaves 1e-9 m.
  const double t = outcome.time;
  const double dt = t / static_cast<double>(outcome.steps);
  double worst = 0;
  for (std::size_t p = 0; p < x0.size(); ++p) {
    const double fallen = -9.81 * t * (t + dt) / 2;
    worst = std::max(worst, std::hypot(outcome.points.x[p] - x0[p] - t, outcome.points.y[p] - y0[p] - fallen));
  }
  EXPECT_LT(worst, 1e-9);
  // The extra g t dt / 2 of the fall is what the energy audit sees: dt / (t + dt) of gravity's work.
  EXPECT_NEAR(outcome.energy.error(), dt / (t + dt), 1e-6);
}

TEST(Simulate, KeepsARotatingBlockTurning) {
  Model model = block(4, 4, 16, 16, elastic);
  model.grid = {0.2, 0.2, 60, 60};
  model.gravity.acceleration = {0, 0};
  model.time.end = 2;
  const double omega = 0.5;
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    model.points.velocity[2 * p] = -omega * (model.points.y[p] - 5.6);
    model.points.velocity[2 * p + 1] = omega * (model.points.x[p] - 5.6);
  }
  const auto kinetic = [](const Points& points) {
    double energy = 0;
    for (std::size_t p = 0; p < points.count(); ++p)
      energy += 0.5 * points.mass[p] * (std::pow(points.velocity[2 * p], 2) + std::pow(points.velocity[2 * p + 1], 2));
    return energy;
  };
  const auto momentum = [](const Points& points, std::size_t axis) {
    double sum = 0;
    for (std::size_t p = 0; p < points.count(); ++p) sum += points.mass[p] * points.velocity[2 * p + axis];
    return sum;
  };
  const double before = kinetic(model.points);
  const Outcome outcome = simulate(model);
  // Lumped nodes at the rim move with the points beside them, not with the rim: this strains the rim and takes 12, 8, 1.4 and
  // 0.4 % of the energy within one radian at 4, 8, 16 and 30 cells across.
  EXPECT_NEAR(kinetic(outcome.points) / before, 1, 0.02);
  EXPECT_NEAR(momentum(outcome.points, 0), 0, 1e-8);
  EXPECT_NEAR(momentum(outcome.points, 1), 0, 1e-8);
}

// ---- against a textbook ---------------------------------------------------------------------------------------------------------

/// MUSL with GIMP as a textbook writes it, for a body that touches no boundary: nodes in full arrays, weights by the
/// piecewise formula, one loop a step of the algorithm. Shares no code with the sweeps but the yield surface.
class Textbook {
 public:
  explicit Textbook(const Model& model) : model_(model), p_(model.points), soil_(soil_constants(model.soils[0])) {}

  void step(double dt) {
    const int nx = model_.grid.cells_x + 1;
    const int ny = model_.grid.cells_y + 1;
    const auto size = static_cast<std::size_t>(nx * ny);
    std::vector<double> m(size), px(size), py(size), fx(size), fy(size), ax(size), ay(size), vx(size), vy(size);
    each([&](std::size_t p, std::size_t n, double N, double dNx, double dNy) {
      m[n] += N * p_.mass[p];
      px[n] += N * p_.mass[p] * p_.velocity[2 * p];
      py[n] += N * p_.mass[p] * p_.velocity[2 * p + 1];
      fx[n] -= p_.volume[p] * (p_.xx[p] * dNx + p_.xy[p] * dNy);
      fy[n] -= p_.volume[p] * (p_.xy[p] * dNx + p_.yy[p] * dNy);
    });
    for (std::size_t n = 0; n < size; ++n) {
      if (m[n] <= 1e-9 * p_.mass[0]) continue;
      ax[n] = fx[n] / m[n] + model_.gravity.acceleration.x;
      ay[n] = fy[n] / m[n] + model_.gravity.acceleration.y;
      vx[n] = px[n] / m[n] + dt * ax[n];
      vy[n] = py[n] / m[n] + dt * ay[n];
    }
    std::vector<double> dx(p_.count()), dy(p_.count()), qx(size), qy(size);
    each([&](std::size_t p, std::size_t n, double N, double, double) {
      p_.velocity[2 * p] += dt * N * ax[n];
      p_.velocity[2 * p + 1] += dt * N * ay[n];
      dx[p] += dt * N * vx[n];
      dy[p] += dt * N * vy[n];
    });
    each([&](std::size_t p, std::size_t n, double N, double, double) {
      qx[n] += N * p_.mass[p] * p_.velocity[2 * p];
      qy[n] += N * p_.mass[p] * p_.velocity[2 * p + 1];
    });
    std::vector<double> exx(p_.count()), eyy(p_.count()), xy(p_.count()), yx(p_.count());
    each([&](std::size_t p, std::size_t n, double, double dNx, double dNy) {
      if (m[n] <= 1e-9 * p_.mass[0]) return;
      exx[p] += dt * dNx * qx[n] / m[n];
      eyy[p] += dt * dNy * qy[n] / m[n];
      xy[p] += dt * dNy * qx[n] / m[n];
      yx[p] += dt * dNx * qy[n] / m[n];
    });
    for (std::size_t p = 0; p < p_.count(); ++p) update_stress(p, exx[p], eyy[p], xy[p], yx[p]);
    for (std::size_t p = 0; p < p_.count(); ++p) {
      p_.x[p] += dx[p];
      p_.y[p] += dy[p];
    }
  }
  const Points& points() const { return p_; }

 private:
  static double value(double d, double l) {
    d = std::abs(d);
    if (d < l) return 1 - (d * d + l * l) / (2 * l);
    if (d <= 1 - l) return 1 - d;
    return d < 1 + l ? std::pow(1 + l - d, 2) / (4 * l) : 0;
  }
  static double slope(double d, double l) {
    const double sign = d < 0 ? -1 : 1;
    d = std::abs(d);
    if (d < l) return -sign * d / l;
    if (d <= 1 - l) return -sign;
    return d < 1 + l ? -sign * (1 + l - d) / (2 * l) : 0;
  }
  template <class Act>
  void each(Act act) const {
    const double h = model_.grid.cell_x;
    const double l = 0.5 * model_.point_spacing_x / h;
    for (std::size_t p = 0; p < p_.count(); ++p)
      for (int i = static_cast<int>(p_.x[p] / h) - 1; i <= static_cast<int>(p_.x[p] / h) + 2; ++i)
        for (int j = static_cast<int>(p_.y[p] / h) - 1; j <= static_cast<int>(p_.y[p] / h) + 2; ++j) {
          const double u = p_.x[p] / h - i;
          const double v = p_.y[p] / h - j;
          act(p, static_cast<std::size_t>(i * (model_.grid.cells_y + 1) + j), value(u, l) * value(v, l), slope(u, l) * value(v, l) / h,
              value(u, l) * slope(v, l) / h);
        }
  }
  void update_stress(std::size_t p, double exx, double eyy, double xy, double yx) {
    const double spin = (xy - yx) / 2;
    const double shear = (xy + yx) / 2;
    const double lambda = soil_.bulk - 2 * soil_.shear / 3;
    Stress s{p_.xx[p] + lambda * (exx + eyy) + 2 * soil_.shear * exx + 2 * spin * p_.xy[p],
             p_.yy[p] + lambda * (exx + eyy) + 2 * soil_.shear * eyy - 2 * spin * p_.xy[p], p_.zz[p] + lambda * (exx + eyy),
             p_.xy[p] + 2 * soil_.shear * shear + spin * (p_.yy[p] - p_.xx[p])};
    constexpr SoilTraits traits{.has_cone = false, .has_softening = true, .has_layers = false};
    p_.plastic_strain[p] += return_to_yield<traits>(s, soil_, yield_surface<traits>(soil_, p_.peak_cohesion[p], p_.plastic_strain[p]));
    p_.xx[p] = s.xx;
    p_.yy[p] = s.yy;
    p_.zz[p] = s.zz;
    p_.xy[p] = s.xy;
    p_.volume[p] *= 1 + exx + eyy;
  }
  Model model_;
  Points p_;
  SoilConstants soil_;
};

TEST(Simulate, AgreesWithATextbookImplementation) {
  const Model model = deforming_block();
  Textbook textbook(model);
  const Outcome outcome = simulate(model);
  for (std::uint64_t step = 0; step < outcome.steps; ++step) textbook.step(time_step(model));
  EXPECT_GT(*std::max_element(outcome.points.plastic_strain.begin(), outcome.points.plastic_strain.end()), 0.2);
  EXPECT_LT(worst_distance(outcome.points, textbook.points()), 1e-11);  // rounding of sums in another order
}

// ---- gravity --------------------------------------------------------------------------------------------------------------------

TEST(Gravity, ColumnSettlesToItsGeostaticStress) {
  Model model = block(0, 0, 2, 10, elastic);
  model.grid = {0.2, 0.2, 2, 14};
  model.boundaries.right = Wall::roller;
  model.gravity = {{0, -9.81}, GravityProtocol::ramp, 10, {}};
  model.time.end = 10.5;
  const Outcome outcome = simulate(model);
  // rho g (H - y) for the mean of the two points of each cell; single points scatter by the quadrature error of a cell's
  // moved points. The ramp of 33 periods leaves 1 % of the greatest stress swinging.
  const double weight = 2000 * 9.81;
  for (std::size_t p = 0; p < 20; p += 2) {
    const double mean = (outcome.points.yy[p] + outcome.points.yy[p + 1]) / 2;
    EXPECT_NEAR(mean, -weight * (2 - (model.points.y[p] + 0.05)), 0.01 * weight * 2) << p;
  }
}

}  // namespace
}  // namespace slidezone
