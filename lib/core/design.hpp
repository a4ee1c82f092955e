// How the realizations of a study are drawn: what is independent of what, and hence what an interval may count.
//
//   plain            each realization by itself
//   antithetic       in pairs: the normal numbers of the second are those of the first with their signs turned
//   Latin hypercube  in blocks: the amplitude of each leading mode of a field falls once into each of as many equally probable strata
//                    as the block has members (field/latin_hypercube.hpp)
// Realizations of one block depend on each other, blocks do not. The block of a plain realization is its own number.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidezone {

enum class Design { plain, antithetic, latin_hypercube };

/// "plain", "antithetic" and "Latin hypercube", in the order of Design: as scenes, HDF5 files and rows spell them.
const std::vector<std::string>& design_names();

std::string to_string(Design design);

/// Nothing for another name.
std::optional<Design> design_named(std::string_view name);

}  // namespace slidezone
