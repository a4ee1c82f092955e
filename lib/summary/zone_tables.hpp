// What zoning prints, as tables: boundaries of classes, exceedance curves, classes of structures; of one study or of several.
//
// Of several studies each line stands once for every study and once more for `worst_case`: the largest value, and the largest lower and
// upper end, that any of them has there. Its largest value is biased upward where studies differ by chance alone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ensemble/ensemble.hpp"
#include "io/table.hpp"
#include "zoning/zoning.hpp"

namespace slidezone {

struct NamedEnsemble {
  std::string name;  // empty: the only one, and no column for it
  Ensemble ensemble;
};

struct ZoneOptions {
  Classes classes;
  Band band = Band::exact;
  bool has_tails = false;  // boundaries beyond the tail's threshold by its fit, where there is one
};

struct Structure {
  std::string name;
  bool is_at_toe = true;  // else behind the crest
  double distance = 0;    // m, away from the slope
};

/// The columns name, side and distance_m of "slidezone-structures-input 1". Throws with the place of what is wrong.
std::vector<Structure> parse_structures(std::string_view bytes, const std::string& name);

/// The tail of a reach, if asked for and there is one: nothing where runs are censored, diverged, drawn in blocks or too
/// few.
std::optional<TailFit> tail_of(const ReachOfStudy& reach, const ZoneOptions& options);

/// Threshold, exceedances, scale, shape and distance of a fit in a line.
std::string words_on(const TailFit& fit);

/// Notes on boundaries beyond which less than one run is expected: without a tail, the largest value seen stands in their place.
std::vector<std::string> thin_boundaries(const NamedEnsemble& study, const ZoneOptions& options);

/// [study] quantity class probability distance_m ci_low_m ci_high_m
Table class_table(std::span<const NamedEnsemble> studies, const ZoneOptions& options);

/// [study] quantity distance_m probability ci_low ci_high normal lognormal
Table curve_table(std::span<const NamedEnsemble> studies, const ZoneOptions& options);

/// [study] name side distance_m probability ci_low ci_high class class_low class_high
Table structure_table(std::span<const NamedEnsemble> studies, std::span<const Structure> structures, const ZoneOptions& options);

}  // namespace slidezone
