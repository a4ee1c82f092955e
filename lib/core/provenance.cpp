#include "core/provenance.hpp"

#include <xxhash.h>

#include <cstdio>

namespace slidezone {

std::string_view version() { return SLIDEZONE_VERSION; }

Provenance provenance(const std::string& schema, const std::string& tool) { return {schema, tool + " " + std::string(version()), {}}; }

std::string checksum(std::string_view bytes) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(XXH3_64bits(bytes.data(), bytes.size())));
  return text;
}

}  // namespace slidezone
