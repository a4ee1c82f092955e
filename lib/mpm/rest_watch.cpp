#include "mpm/rest_watch.hpp"

#include <algorithm>
#include <numeric>

namespace slidezone {

template <class Real>
void RestWatch::see(double time, double kinetic, const PointsOf<Real>& points) {
  most_kinetic_ = std::max(most_kinetic_, kinetic);
  if (kinetic > rule_.energy_fraction * most_kinetic_) moving_until_ = time;
  if (time < next_look_) return;
  next_look_ = time + 0.1 * rule_.hold;
  const double strain = std::inner_product(points.mass.begin(), points.mass.end(), points.plastic_strain.begin(), 0.0);
  const double growth = strain - strain_;
  strain_ = strain;
  most_growth_ = std::max(most_growth_, growth);
  if (growth > rule_.strain_fraction * most_growth_) moving_until_ = time;
}

template void RestWatch::see(double, double, const PointsOf<double>&);
template void RestWatch::see(double, double, const PointsOf<float>&);

}  // namespace slidezone
