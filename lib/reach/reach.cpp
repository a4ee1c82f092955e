#include "reach/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slidezone {

namespace {

double displacement(const Displaced& points, std::size_t p) {
  return std::hypot(points.x[p] - points.initial_x[p], points.y[p] - points.initial_y[p]);
}

/// Cells that hold points, and those among them that hang together with the left-most ones.
class Occupancy {
 public:
  Occupancy(const Displaced& points, double cell_x, double cell_y) : cell_x_(cell_x), cell_y_(cell_y) {
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      columns_ = std::max(columns_, column(points.x[p]) + 1);
      rows_ = std::max(rows_, row(points.y[p]) + 1);
    }
    state_.assign(static_cast<std::size_t>(columns_ * rows_), State::empty);
    for (std::size_t p = 0; p < points.x.size(); ++p) at(column(points.x[p]), row(points.y[p])) = State::occupied;
    spread_from_left();
  }

  bool is_in_main_body(double x, double y) const { return state_[index(column(x), row(y))] == State::main_body; }

 private:
  enum class State : char { empty, occupied, main_body };

  int column(double x) const { return std::max(0, static_cast<int>(std::floor(x / cell_x_))); }
  int row(double y) const { return std::max(0, static_cast<int>(std::floor(y / cell_y_))); }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * rows_ + j); }
  State& at(int i, int j) { return state_[index(i, j)]; }

  void spread_from_left() {
    std::vector<std::pair<int, int>> open;
    const auto take = [&](int i, int j) {
      if (i < 0 || i >= columns_ || j < 0 || j >= rows_ || at(i, j) != State::occupied) return;
      at(i, j) = State::main_body;
      open.emplace_back(i, j);
    };
    for (int i = 0; open.empty() && i < columns_; ++i)
      for (int j = 0; j < rows_; ++j) take(i, j);
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj) take(i + di, j + dj);
    }
  }

  double cell_x_;
  double cell_y_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<State> state_;
};

/// To the nanometre, so that distances between edges of cells are the decimals that they look like: a place 3.8 m from the crest is not
/// reached by 3.8000000000000007 m.
double rounded(double length) { return std::round(length * 1e9) / 1e9; }

/// By how much compression of the points that began in the left-most column lowers its top.
double compression_at_left(const Displaced& points, const ReachSettings& settings) {
  double lost = 0;
  for (std::size_t p = 0; p < points.x.size(); ++p)
    if (points.initial_x[p] < settings.cell_x) lost += settings.spacing_x * settings.spacing_y - points.volume[p];
  return lost / settings.cell_x;
}

/// Crest minus the left edge of the first column that dropped by more than `drop` beyond `settlement`.
double influence(const std::vector<double>& before, const std::vector<double>& now, double settlement, double drop,
                 const ReachSettings& settings) {
  for (std::size_t column = 0; column < before.size(); ++column) {
    const double left_edge = static_cast<double>(column) * settings.cell_x;
    if (left_edge >= settings.crest.x) break;
    const bool is_empty = column >= now.size() || std::isnan(now[column]);
    if (is_empty || before[column] - now[column] - settlement > drop) return rounded(settings.crest.x - left_edge);
  }
  return 0;
}

}  // namespace

std::vector<double> column_tops(std::span<const double> x, std::span<const double> y, double width, double spacing_y) {
  std::vector<double> tops;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const auto column = static_cast<std::size_t>(std::max(0.0, std::floor(x[p] / width)));
    if (column >= tops.size()) tops.resize(column + 1, std::numeric_limits<double>::quiet_NaN());
    tops[column] = std::fmax(tops[column], y[p] + 0.5 * spacing_y);
  }
  return tops;
}

ReachOfRun reach(const Displaced& points, const ReachSettings& settings) {
  const Occupancy occupancy(points, settings.cell_x, settings.cell_y);
  ReachOfRun result;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    if (displacement(points, p) <= settings.slid_displacement) continue;
    result.has_slid = true;
    result.displaced_area += settings.spacing_x * settings.spacing_y;
    const double runout = points.x[p] + 0.5 * settings.spacing_x - settings.toe.x;
    result.runout_max = std::max(result.runout_max, runout);
    if (occupancy.is_in_main_body(points.x[p], points.y[p])) result.runout = std::max(result.runout, runout);
  }
  const auto before = column_tops(points.initial_x, points.initial_y, settings.cell_x, settings.spacing_y);
  const auto now = column_tops(points.x, points.y, settings.cell_x, settings.spacing_y);
  const double dropped = before[0] - now[0];  // nan where the left-most column is empty
  const double compression = compression_at_left(points, settings);
  const double most_flow = std::min(0.5 * settings.influence_drop, 0.05 * (settings.crest.y - settings.toe.y));
  const bool is_reference = dropped - compression <= most_flow;
  const double settlement = is_reference ? dropped : compression;
  result.influence = influence(before, now, settlement, settings.influence_drop, settings);
  result.influence_1m = influence(before, now, settlement, 1.0, settings);
  const bool is_close = result.influence > 0 && settings.crest.x - result.influence < settings.held_at_left;
  result.has_reached_left_wall = result.has_slid && (!is_reference || is_close);
  return result;
}

}  // namespace slidezone
