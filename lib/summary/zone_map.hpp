// Zones and structures on the map, as GeoJSON ("slidezone-map 1", data-schemas/map.json) that QGIS and GDAL open.
//
// Polygons: one for each class and side, from the end of the class before it to its own far end. Points: structures, on the section's
// axis. Properties carry what class_table() and structure_table() print; an end that the runs cannot give is null. Coordinates to the
// millimetre in the site's own reference system, which the member "crs" names as GeoJSON of 2008 did (RFC 7946 knows degrees of WGS 84
// alone, in which a metre is hard to read; QGIS and GDAL honour it).
#pragma once

#include <span>
#include <string>

#include "core/provenance.hpp"
#include "summary/zone_tables.hpp"
#include "zoning/map_frame.hpp"

namespace slidezone {

std::string zone_map(const Ensemble& ensemble, std::span<const Structure> structures, const ZoneOptions& options, const MapFrame& frame,
                     int epsg, const Provenance& provenance);

}  // namespace slidezone
