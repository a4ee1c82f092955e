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

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"auto", "separable", "circulant", "Cholesky", "Karhunen-Loeve"};
  return names;
}

}  // namespace slidezone
