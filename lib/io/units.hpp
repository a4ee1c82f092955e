// Quantities with units, "5 m" or "20 kN/m^3", parsed and checked for their dimension by UDUNITS-2.
#pragma once

#include <string>
#include <string_view>

namespace slidezone {

/// The quantity in `unit` (an SI unit as UDUNITS-2 spells it: "m", "Pa", "N m-3", "rad", "s"). One number and one unit, a
/// multiple of that one, which holds no number but exponents and the 1 of "1/s". Throws std::invalid_argument with what was
/// found and what was expected; the caller knows the place.
double parse_quantity(std::string_view text, const std::string& unit);

/// How a quantity in `unit` may be written, for messages: "30 deg" for "rad".
std::string quantity_example(const std::string& unit);

}  // namespace slidezone
