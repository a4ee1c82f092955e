// Provenance: what every file between tools says of itself, so that equal inputs give equal bytes and a number can be
// traced. No clock time, host, user, path or run time.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slidezone {

/// Version of the suite, e.g. "0.1.0".
std::string_view version();

struct Provenance {
  std::string schema;                                        // name and version, e.g. "slidezone-row 1"
  std::string tool;                                          // name and version, e.g. "mpmrun 0.1.0"
  std::vector<std::pair<std::string, std::string>> details;  // options that change the numbers, seed, input checksums
};

Provenance provenance(const std::string& schema, const std::string& tool);

/// XXH3 checksum of the bytes as 16 hexadecimal digits: `xxhsum -H3 FILE` prints the same.
std::string checksum(std::string_view bytes);

}  // namespace slidezone
