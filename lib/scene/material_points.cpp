#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scene/scene.hpp"
#include "scene/soil_at.hpp"

namespace slidezone {

/// A point is inside when it lies below a boundary by more than this fraction of the spacing: lattice points on a face
/// stay outside whatever rounding does to them.
static constexpr double margin = 1e-6;

/// The lowest elevation of a boundary within the margin of x: at a vertical step, its foot.
static double lowest_elevation(const std::vector<Vec2>& polyline, double x, double room) {
  return std::min(elevation(polyline, x - room), elevation(polyline, x + room));
}

std::size_t soil_at(const std::vector<Layer>& layers, double x, double y) {
  for (std::size_t layer = layers.size(); layer-- > 1;)
    if (y < elevation(layers[layer].top, x)) return layer;
  return 0;
}

/// A soil without a point is a mistake of the scene: a top above the ground, or a layer thinner than the spacing.
static void check_layers(const Scene& scene, const MaterialPoints& points) {
  for (std::size_t layer = 0; layer < scene.layers.size(); ++layer)
    if (std::find(points.layer.begin(), points.layer.end(), static_cast<int>(layer)) == points.layer.end())
      throw Error(ExitCode::data, scene.name + ": no material point lies in soil \"" + scene.layers[layer].name + "\", with points every " +
                                      format_brief(points.spacing_x) + " m by " + format_brief(points.spacing_y) +
                                      " m; move the tops of the soils or refine the grid");
}

MaterialPoints material_points(const Scene& scene) {
  const GridShape& grid = scene.discretization.grid;
  const int per_cell = scene.discretization.points_per_cell;
  MaterialPoints points;
  points.spacing_x = grid.cell_x / per_cell;
  points.spacing_y = grid.cell_y / per_cell;
  for (int i = 0; i < grid.cells_x * per_cell; ++i) {
    const double x = (i + 0.5) * points.spacing_x;
    const double top = lowest_elevation(scene.slope.surface, x, margin * points.spacing_x) - margin * points.spacing_y;
    for (int j = 0; (j + 0.5) * points.spacing_y < top; ++j) {
      const double y = (j + 0.5) * points.spacing_y;
      points.x.push_back(x);
      points.y.push_back(y);
      points.layer.push_back(static_cast<int>(soil_at(scene.layers, x, y + margin * points.spacing_y)));
    }
  }
  if (points.x.empty())
    throw Error(ExitCode::data, scene.name + ": no material point lies inside the slope, with points every " +
                                    format_brief(points.spacing_x) + " m by " + format_brief(points.spacing_y) + " m; refine the grid");
  check_layers(scene, points);
  return points;
}

}  // namespace slidezone
