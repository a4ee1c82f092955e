#include "field/local_average.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "field/autocorrelation.hpp"

namespace slidezone {

namespace {

struct Integrand {
  Autocorrelation function;
  double smoothness;
  double length;
  double k;
};

double weighted(double u, void* parameters) {
  const auto& [function, smoothness, length, k] = *static_cast<const Integrand*>(parameters);
  return (1 - std::abs(u)) * autocorrelation(function, smoothness, std::abs(k + u) * length);
}

double integral(Integrand integrand, double from, double to) {
  constexpr std::size_t intervals = 200;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  gsl_function function{weighted, &integrand};
  double value = 0, error = 0;
  gsl_integration_qags(&function, from, to, 1e-13, 1e-12, intervals, workspace.get(), &value, &error);
  return value;
}

/// Ends of the parts of [-1, 1]: the weight's kink, the cusp at no lag, the lags where binary noise and the spherical function end, and
/// lags in steps of 4, so that no part is so long that the quadrature overlooks what lies at its end.
std::vector<double> parts(double length, double k) {
  std::vector<double> ends = {-1, 0, 1};
  const auto add = [&](double lag) {
    for (const double u : {lag / length - k, -lag / length - k})
      if (u > -1 && u < 1) ends.push_back(u);
  };
  add(0);
  add(4. / 3);
  for (double lag = 1; lag < (k + 1) * length; lag *= 4) add(lag);
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

double average_covariance(Autocorrelation function, double smoothness, double length, double k) {
  gsl_set_error_handler_off();  // where rounding keeps the quadrature from its goal, it is at its best
  const Integrand integrand{function, smoothness, length, std::abs(k)};
  const std::vector<double> ends = parts(length, integrand.k);
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) sum += integral(integrand, ends[i - 1], ends[i]);
  return sum;
}

}  // namespace slidezone
