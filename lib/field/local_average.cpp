#include "field/local_average.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

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

}  // namespace

double average_covariance(Autocorrelation function, double smoothness, double length, double k) {
  gsl_set_error_handler_off();  // where rounding keeps the quadrature from its goal, it is at its best
  const Integrand integrand{function, smoothness, length, std::abs(k)};
  return integral(integrand, -1, 0) + integral(integrand, 0, 1);
}

}  // namespace slidezone
