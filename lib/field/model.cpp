#include "field/model.hpp"

namespace slidezone {

const std::vector<std::string>& autocorrelation_names() {
  static const std::vector<std::string> names = {"single exponential",
                                                 "squared exponential",
                                                 "second-order Markov",
                                                 "third-order Markov",
                                                 "cosine exponential",
                                                 "binary noise",
                                                 "Matern",
                                                 "spherical"};
  return names;
}

const std::vector<std::string>& lag_shape_names() {
  static const std::vector<std::string> names = {"separable", "elliptical"};
  return names;
}

const std::vector<std::string>& distribution_names() {
  static const std::vector<std::string> names = {"lognormal", "normal",  "truncated normal", "beta",
                                                 "gamma",     "Weibull", "uniform",          "empirical"};
  return names;
}

const std::vector<std::string>& spread_names() {
  static const std::vector<std::string> names = {"constant cov", "constant sd"};
  return names;
}

const std::vector<std::string>& correlation_of_names() {
  static const std::vector<std::string> names = {"Gaussian", "physical"};
  return names;
}

const std::vector<std::string>& average_names() {
  static const std::vector<std::string> names = {"point", "cell"};
  return names;
}

const std::vector<std::string>& interpolation_names() {
  static const std::vector<std::string> names = {"cell", "linear"};
  return names;
}

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"auto", "separable", "circulant", "Cholesky", "Karhunen-Loeve"};
  return names;
}

}  // namespace slidezone
