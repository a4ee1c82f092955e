// How far a failure reaches, read off the material points of a run by definitions that need no eye.
//
// Runout R: front of the main body, plus half a point, minus the toe. The main body is made of the points in occupied cells
// that hang together (sides or corners) with those farthest left; the front is its front-most point that moved by more than
// `slid_displacement`. runout_max is the same without asking whether the point still hangs together with the body.
// Influence I: crest minus the left edge of the first surface column, from the left, whose top dropped by more than
// `influence_drop` beyond what the left-most column dropped (so that settlement cancels), to the nanometre. 0 if none did.
// Where nothing moved that far all distances are 0. Lengths in m, areas in m^2.
//
// The left-most column is no reference once its soil flows away. Its drop is then more than its soil was compressed,
//   flow = drop - (V_0 - V) / cell_x,   V the volume now of the points that began in it,
// and beyond half of influence_drop or a twentieth of the slope's height, whichever is less, the failure has reached the left wall: what
// the soil was compressed stands for settlement, and the ground ends before the failure does. A wall that holds soil along it (stick)
// keeps the column up: there a failure has reached it that comes closer than `held_at_left`.
#pragma once

#include <span>
#include <vector>

#include "core/vec2.hpp"

namespace slidezone {

/// Positions now and at the start of the same points, and their volumes now, m^3/m.
struct Displaced {
  std::span<const double> x, y, initial_x, initial_y, volume;
};

struct ReachSettings {
  Vec2 crest;
  Vec2 toe;
  double cell_x = 0;  // size of the cells and columns, m
  double cell_y = 0;
  double spacing_x = 0;  // of the initial points, m
  double spacing_y = 0;
  double influence_drop = 0.5;
  double slid_displacement = 1;
  double held_at_left = 0;  // width of the soil that the left wall holds up, m; 0 where soil may slide along it
};

struct ReachOfRun {
  double influence = 0;
  double influence_1m = 0;  // with a drop of 1 m
  double runout = 0;
  double runout_max = 0;
  double displaced_area = 0;  // initial area of the points that moved by more than slid_displacement
  bool has_slid = false;      // some point did
  bool has_reached_left_wall = false;
};

ReachOfRun reach(const Displaced& points, const ReachSettings& settings);

/// Top of the points in each column of cells from the left wall on, plus half a point; nan for an empty column. Columns are
/// `width` wide; as many as the points reach.
std::vector<double> column_tops(std::span<const double> x, std::span<const double> y, double width, double spacing_y);

}  // namespace slidezone
