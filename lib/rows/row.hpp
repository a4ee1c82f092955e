// Rows: what one realization leaves behind, as mpmrun writes it and mcstats and zoning read it ("slidezone-row 1").
//
// Distances in m, areas in m2, times in s. A value that does not exist is nan in memory and `nan` in the table: a diverged
// run has no reach, a run that never came to rest has no time of rest. Every other run has a finite influence and runout;
// those of a run that left the domain are lower bounds (it was stopped while it moved, or the ground ended before the failure did).
//
// Design and block say how the realization was drawn (core/design.hpp). Tables of before these two columns are read as plain.
// The random realizations of one reading are of one design: an interval has one unit.
//
// Realization 0 is the deterministic run, random realizations carry 1, 2, ...; each number may stand once. A number that
// stands twice is an error even where both rows are equal: a table given twice would otherwise narrow every interval.
//
// Throws Error(ExitCode::data) with file:line for unknown or missing columns, an unknown status, a number that is missing
// or not finite, numbers that stand twice, and realizations of two designs. A study's rows (read_rows) are refused besides where they
// hold no two random realizations, and where every slide of them runs equally far to the last digit: no two random fields do that, so runs
// were copied, or the field does not vary. The influence distance may: it moves in whole columns of cells. So may stable slopes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/design.hpp"
#include "core/provenance.hpp"

namespace slidezone {

inline constexpr std::string_view row_schema = "slidezone-row 1";

enum class Status {
  slid,         // some point moved more than 1 m, and the slide has its ends inside the grid
  stable,       // no point moved more than 1 m
  left_domain,  // a point reached the end of the grid, or the failure the left wall: the reach is a lower bound
  diverged,     // NaN, instability or a broken energy balance: the reach is unknown
};

/// "slid", "stable", "left_domain" or "diverged".
std::string to_string(Status status);

struct Row {
  std::uint64_t realization = 0;
  Status status = Status::slid;
  double influence = 0;       // influence distance I behind the crest, by a drop of 0.5 m
  double runout = 0;          // runout distance R of the main body in front of the toe
  double influence_1m = 0;    // influence distance by a drop of 1 m
  double runout_max = 0;      // farthest point of all in front of the toe
  double displaced_area = 0;  // area of the section that moved, m2
  double rest_time = 0;       // when the slide came to rest, s
  std::uint64_t steps = 0;
  double energy_error = 0;    // error of the energy balance over the work of gravity or, where soil hardly sinks, over what it started with
  std::uint64_t floored = 0;  // field values that stand at a limit
  Design design = Design::plain;
  std::uint64_t block = 0;  // pair or hypercube that the realization belongs to; its own number where plain
};

/// One row as a whole table with its provenance.
std::string to_tsv(const Row& row, const Provenance& provenance);

/// Checksum of the rows as one table: it does not depend on how they were split into files, nor on their provenance.
std::string checksum(std::span<const Row> rows);

/// All rows of one table or of several concatenated ones, by realization; `name` is the file's name in messages.
std::vector<Row> parse_rows(std::string_view bytes, const std::string& name);

/// The rows of a study from several files ("-" is stdin), by realization; at least two random ones.
std::vector<Row> read_rows(std::span<const std::string> paths);

}  // namespace slidezone
