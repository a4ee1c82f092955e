#include <cmath>
#include <numbers>

#include "scene/read_tables.hpp"

namespace slidezone {

static Vec2 read_place(const TomlTable& table, const std::string& key) {
  if (table.has(key) && !table.is_list(key)) table.fail(key, "wants easting and northing like [\"565000 m\", \"5933000 m\"]");
  return table.quantity_pair(key, "m", any_number);
}

/// Clockwise from north, in [0, 2 pi).
static double bearing_from(Vec2 crest, Vec2 toe) {
  const double bearing = std::atan2(toe.x - crest.x, toe.y - crest.y);
  return bearing < 0 ? bearing + 2 * std::numbers::pi : bearing;
}

Site read_site(const TomlTable& table) {
  table.check_keys({"crest", "toe", "bearing", "epsg", "width"});
  Site site;
  site.crest = read_place(table, "crest");
  site.toe = read_place(table, "toe");
  if (!table.has("bearing") && site.crest.x == site.toe.x && site.crest.y == site.toe.y)
    table.fail("toe", "is where the crest is: say with 'bearing' which way the slope faces");
  site.bearing = table.quantity_or("bearing", "rad", not_negative, bearing_from(site.crest, site.toe));
  site.epsg = static_cast<int>(table.whole("epsg", 1024, 32767));
  site.width = table.quantity_or("width", "m", positive, site.width);
  return site;
}

}  // namespace slidezone
