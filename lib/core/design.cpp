#include "core/design.hpp"

#include <algorithm>

namespace slidezone {

const std::vector<std::string>& design_names() {
  static const std::vector<std::string> names = {"plain", "antithetic", "Latin hypercube"};
  return names;
}

std::string to_string(Design design) { return design_names()[static_cast<std::size_t>(design)]; }

std::optional<Design> design_named(std::string_view name) {
  const auto& names = design_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Design>(found - names.begin());
}

}  // namespace slidezone
