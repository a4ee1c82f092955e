#include "summary/zone_map.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/text.hpp"

namespace slidezone {

// ---- JSON ----

static std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    if (static_cast<unsigned char>(letter) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(letter));
      result += escape;
    } else {
      result += letter;
    }
  }
  return result + '"';
}

/// A number; null for what JSON has no number for.
static std::string number(double value) { return std::isfinite(value) ? format_real(value) : "null"; }

static std::string millimetres(double value) {
  std::array<char, 64> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 3);
  return {buffer.data(), end};
}

static std::string position(Vec2 place) { return "[" + millimetres(place.x) + ", " + millimetres(place.y) + "]"; }

static std::string feature(const std::string& geometry, const std::string& properties) {
  return "    {\"type\": \"Feature\", \"geometry\": " + geometry + ",\n     \"properties\": {" + properties + "}}";
}

// ---- features ----

static std::string polygon(const MapFrame& frame, Side side, double near, double far) {
  std::string ring;
  for (const Vec2& corner : strip_between(frame, side, near, far)) ring += (ring.empty() ? "" : ", ") + position(corner);
  return "{\"type\": \"Polygon\", \"coordinates\": [[" + ring + "]]}";
}

/// The classes of one side that have a width; a class is empty where one before it ends as far out.
static void add_zones(std::vector<std::string>& features, const ReachOfStudy& reach, Side side, const ZoneOptions& options,
                      const MapFrame& frame) {
  const std::optional<TailFit> tail = tail_of(reach, options);
  const auto found = tail ? boundaries_by_tail(reach.sample, options.classes, *tail) : boundaries(reach.sample, options.classes);
  double near = 0;
  for (const Boundary& boundary : found) {
    const double far = boundary.distance.value;
    if (!(far > near)) continue;
    const Interval& interval = boundary.distance.interval;
    features.push_back(feature(polygon(frame, side, near, far),
                               "\"kind\": \"zone\", \"quantity\": " + quoted(reach.quantity) + ", \"class\": " + quoted(boundary.name) +
                                   ", \"probability\": " + number(boundary.probability) + ", \"near_m\": " + number(near) +
                                   ", \"distance_m\": " + number(far) + ", \"ci_low_m\": " + number(interval.low) +
                                   ", \"ci_high_m\": " + number(interval.high)));
    near = far;
  }
}

static std::string structure_feature(const Structure& structure, const Ensemble& ensemble, const ZoneOptions& options,
                                     const MapFrame& frame) {
  const Side side = structure.is_at_toe ? Side::toe : Side::crest;
  const ReachOfStudy& reach = structure.is_at_toe ? ensemble.runout : ensemble.influence;
  const Estimate hazard = exceedance_estimate(reach.sample, structure.distance, options.band);
  const auto class_at = [&](double probability) { return quoted(class_of(options.classes, probability)); };
  return feature("{\"type\": \"Point\", \"coordinates\": " + position(place_at(frame, side, structure.distance)) + "}",
                 "\"kind\": \"structure\", \"name\": " + quoted(structure.name) +
                     ", \"side\": " + (structure.is_at_toe ? "\"toe\"" : "\"crest\"") + ", \"distance_m\": " + number(structure.distance) +
                     ", \"probability\": " + number(hazard.value) + ", \"ci_low\": " + number(hazard.interval.low) +
                     ", \"ci_high\": " + number(hazard.interval.high) + ", \"class\": " + class_at(hazard.value) +
                     ", \"class_low\": " + class_at(hazard.interval.low) + ", \"class_high\": " + class_at(hazard.interval.high));
}

std::string zone_map(const Ensemble& ensemble, std::span<const Structure> structures, const ZoneOptions& options, const MapFrame& frame,
                     int epsg, const Provenance& provenance) {
  std::vector<std::string> features;
  add_zones(features, ensemble.influence, Side::crest, options, frame);
  add_zones(features, ensemble.runout, Side::toe, options, frame);
  for (const Structure& structure : structures) features.push_back(structure_feature(structure, ensemble, options, frame));

  std::string text =
      "{\n  \"type\": \"FeatureCollection\",\n  \"schema\": " + quoted(provenance.schema) + ",\n  \"tool\": " + quoted(provenance.tool);
  for (const auto& [key, value] : provenance.details) text += ",\n  " + quoted(key) + ": " + quoted(value);
  text += ",\n  \"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::" + std::to_string(epsg) + "\"}}";
  text += ",\n  \"features\": [\n";
  for (std::size_t i = 0; i < features.size(); ++i) text += features[i] + (i + 1 < features.size() ? ",\n" : "\n");
  return text + "  ]\n}\n";
}

}  // namespace slidezone
