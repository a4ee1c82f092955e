#include "io/units.hpp"

#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

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
      {"Pa m-1", {"a stress over a length", "2 kPa/m"}},
      {"rad m-1", {"an angle over a length", "0.5 deg/m"}},
      {"N m-4", {"a unit weight over a length", "0.1 kN/m^4"}},
      {"kg m-4", {"a density over a length", "10 kg/m^4"}},
  };
  const auto found = dimensions.find(unit);
  return found == dimensions.end() ? Dimension{"a quantity in " + unit, "1 " + unit} : found->second;
}

using System = std::unique_ptr<ut_system, FreeSystem>;

void add_symbol(ut_system* system, const char* symbol, const char* definition) {
  const Unit unit(ut_parse(system, definition, UT_ASCII));
  ut_map_symbol_to_unit(symbol, UT_ASCII, unit.get());
}

/// The units that scenes are usually written in, with the symbols and values of the database, which takes 4 ms to read.
System common_units() {
  ut_set_error_message_handler(ut_ignore);
  System system(ut_new_system());
  for (const char* base : {"m", "kg", "s"}) {
    const Unit unit(ut_new_base_unit(system.get()));
    ut_map_symbol_to_unit(base, UT_ASCII, unit.get());
  }
  const Unit radian(ut_new_dimensionless_unit(system.get()));
  ut_map_symbol_to_unit("rad", UT_ASCII, radian.get());
  for (const auto& [symbol, definition] : {std::pair{"g", "0.001 kg"},
                                           {"t", "1000 kg"},
                                           {"N", "kg m s-2"},
                                           {"Pa", "N m-2"},
                                           {"min", "60 s"},
                                           {"h", "3600 s"},
                                           {"deg", "0.017453292519943295 rad"}})
    add_symbol(system.get(), symbol, definition);
  for (const auto& [prefix, factor] : {std::pair{"m", 1e-3}, {"c", 1e-2}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}})
    ut_add_symbol_prefix(system.get(), prefix, factor);
  return system;
}

/// The database of UDUNITS-2 with "deg" added: it knows only "degree" and "arcdeg".
System all_units() {
  System system(ut_read_xml(nullptr));
  if (!system) throw Error(ExitCode::internal, "the database of UDUNITS-2 could not be read; is libudunits2-data installed?");
  add_symbol(system.get(), "deg", "degree");
  return system;
}

/// `value` times the unit `from`, in `to`; nothing where the system does not know a unit or one is no multiple of the other.
/// UDUNITS alone would also convert reciprocals (Hz to s), ratios to angles (%), shifted units (m @ 3) and logarithms.
std::optional<double> converted(ut_system* system, double value, const std::string& from, const std::string& to) {
  const Unit from_unit(ut_parse(system, from.c_str(), UT_UTF8));
  const Unit to_unit(ut_parse(system, to.c_str(), UT_UTF8));
  if (!from_unit || !ut_are_convertible(from_unit.get(), to_unit.get())) return std::nullopt;
  const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(from_unit.get(), to_unit.get()));
  const double factor = cv_convert_double(converter.get(), 1);
  const Unit multiple(ut_scale(factor, to_unit.get()));
  if (!multiple || ut_compare(from_unit.get(), multiple.get()) != 0 || !std::isfinite(value * factor)) return std::nullopt;
  return value * factor;
}

/// The same by the common units or, where those do not serve, by the database.
std::optional<double> converted(double value, const std::string& from, const std::string& to) {
  static const System common = common_units();
  if (const auto result = converted(common.get(), value, from, to)) return result;
  static const System all = all_units();
  return converted(all.get(), value, from, to);
}

/// Whether a unit holds a number that is no exponent, "200 kPa" of "1 200 kPa": more likely a mistake than meant. "1/s" does not.
bool has_factor(std::string_view unit) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = unit.starts_with("1/") ? 2 : 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1]))) continue;
    const std::string_view before = unit.substr(0, i > 0 && (unit[i - 1] == '-' || unit[i - 1] == '+') ? i - 1 : i);
    const bool is_exponent = !before.empty() && std::string_view(" ./(").find(before.back()) == std::string_view::npos;
    if (!is_exponent || (before.back() == '*' && !before.ends_with("**"))) return true;
  }
  return false;
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
  if (written.empty() || has_factor(written)) throw std::invalid_argument(expected);
  const auto result = converted(*value, written, unit);
  if (!result) throw std::invalid_argument(expected);
  return *result;
}

}  // namespace slidezone
