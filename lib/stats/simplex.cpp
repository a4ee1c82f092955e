#include "stats/simplex.hpp"

#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "stats/gsl_errors.hpp"

namespace slidezone {

namespace {

using Function = std::function<double(std::span<const double>)>;

constexpr double forbidden = 1e300;  // in place of infinity, with which the simplex cannot reckon

double value_at(const gsl_vector* place, void* data) {
  const double value = (*static_cast<const Function*>(data))({place->data, place->size});
  return std::isfinite(value) ? value : forbidden;
}

struct FreeMinimizer {
  void operator()(gsl_multimin_fminimizer* minimizer) const { gsl_multimin_fminimizer_free(minimizer); }
};
struct FreeVector {
  void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};
using Vector = std::unique_ptr<gsl_vector, FreeVector>;

}  // namespace

Minimum minimum_by_simplex(const Function& function, std::span<const double> start, double step) {
  keep_gsl_from_aborting();
  const Vector place(gsl_vector_alloc(start.size()));
  const Vector steps(gsl_vector_alloc(start.size()));
  std::copy(start.begin(), start.end(), place->data);
  gsl_vector_set_all(steps.get(), step);
  gsl_multimin_function problem{value_at, start.size(), const_cast<Function*>(&function)};
  const std::unique_ptr<gsl_multimin_fminimizer, FreeMinimizer> minimizer(
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, start.size()));
  gsl_multimin_fminimizer_set(minimizer.get(), &problem, place.get(), steps.get());
  for (int i = 0; i < 2000 && gsl_multimin_fminimizer_size(minimizer.get()) > 1e-9; ++i) {
    if (gsl_multimin_fminimizer_iterate(minimizer.get()) != GSL_SUCCESS) break;
  }
  const double* found = minimizer->x->data;
  return {{found, found + start.size()}, gsl_multimin_fminimizer_minimum(minimizer.get())};
}

}  // namespace slidezone
