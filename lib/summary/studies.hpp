// The studies that zones are made of: their rows read, and what a reader must know of them told on stderr and in the result's provenance.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/provenance.hpp"
#include "summary/zone_tables.hpp"

namespace slidezone {

/// Warns of what the runs leave in doubt; adds checksum and number of the rows to `origin`.
NamedEnsemble read_study(const std::string& name, std::span<const std::string> paths, Provenance& origin);

/// Of texts NAME=FILE. Throws Error(ExitCode::usage) for a name that stands twice.
std::vector<NamedEnsemble> read_studies(std::span<const std::string> named_files, Provenance& origin);

/// Tells the notes on thin boundaries, and in `origin` how each tail was fitted; warns where one is asked for and there is none.
void tell_boundaries(Provenance& origin, const NamedEnsemble& study, const ZoneOptions& options);

}  // namespace slidezone
