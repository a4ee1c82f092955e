#include "io/units.hpp"

#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "core/error.hpp"
#include "core/text.hpp"

namespace slidezone {

namespace {

struct FreeSystem {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// What a unit measures, and an example, for messages.
struct Dimension {
  std::string name;
  std::string example;
};

Dimension dimension_of(const std::string& unit) {
  static const std::map<std::string, Dimension> dimensions = {
      {"m", {"a length", "5 m"}},
      {"s", {"a time", "2 s"}},
      {"rad", {"an angle", "30 deg"}},
      {"Pa", {"a stress", "20 kPa"}},
      {"N m-3", {"a unit weight", "20 kN/m^3"}},
      {"kg m-3", {"a density", "2000 kg/m^3"}},
      {"m s-2", {"an acceleration", "9.81 m/s^2"}},
      {"m s-1", {"a velocity", "5 m/s"}},
      {"s-1", {"a rate", "0.5 1/s"}},
  };
  const auto found = dimensions.find(unit);
  return found == dimensions.end() ? Dimension{"a quantity in " + unit, "1 " + unit} : found->second;
}

/// The unit database, to which "deg" is added: UDUNITS-2 knows only "degree" and "arcdeg".
std::unique_ptr<ut_system, FreeSystem> read_unit_system() {
  ut_set_error_message_handler(ut_ignore);
  std::unique_ptr<ut_system, FreeSystem> system(ut_read_xml(nullptr));
  if (!system) throw Error(ExitCode::internal, "the database of UDUNITS-2 could not be read; is libudunits2-data installed?");
  const Unit degree(ut_get_unit_by_name(system.get(), "degree"));
  ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
  return system;
}

/// Read once, when the first quantity is parsed.
ut_system* unit_system() {
  static const std::unique_ptr<ut_system, FreeSystem> system = read_unit_system();
  return system.get();
}

}  // namespace

std::string quantity_example(const std::string& unit) { return dimension_of(unit).example; }

double parse_quantity(std::string_view text, const std::string& unit) {
  const Dimension dimension = dimension_of(unit);
  const std::string expected =
      "wants " + dimension.name + ", found \"" + std::string(text) + "\"; write e.g. \"" + dimension.example + "\"";
  const std::size_t end = text.find_first_not_of("+-.0123456789eE");
  const std::size_t number_size = std::min(end, text.size());
  const auto value = parse_real(text.substr(0, number_size));
  if (!value || number_size == text.size()) throw std::invalid_argument(expected);

  const std::string written(text.substr(std::min(text.find_first_not_of(' ', number_size), text.size())));
  if (written.empty()) throw std::invalid_argument(expected);
  const Unit from(ut_parse(unit_system(), written.c_str(), UT_UTF8));
  const Unit to(ut_parse(unit_system(), unit.c_str(), UT_UTF8));
  if (!from || !ut_are_convertible(from.get(), to.get())) throw std::invalid_argument(expected);
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(from.get(), to.get()));
  const double converted = cv_convert_double(converter.get(), *value);
  if (!std::isfinite(converted)) throw std::invalid_argument(expected);
  return converted;
}

}  // namespace slidezone
