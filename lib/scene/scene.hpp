// A scene: one slope and how it is analysed, read from one TOML file. data-schemas/scene.schema.json describes the file.
//
// Origin: where the left wall meets the base; x to the right, y up; SI units throughout. A table that is absent is a feature
// that is not run. Defaults stand in the structs below, in field/model.hpp and in mpm/settings.hpp, nowhere else.
// Errors: ExitCode::data with file:line:column, what was found, what was expected and the nearest known key.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec2.hpp"
#include "field/cross_correlation.hpp"
#include "field/latin_hypercube.hpp"
#include "field/model.hpp"
#include "grid/grid_shape.hpp"
#include "mpm/settings.hpp"
#include "soil/material.hpp"
#include "soil/parameter.hpp"

namespace slidezone {

/// The ground surface as a polyline from the left wall to the base or the right wall; x never falls along it.
struct Slope {
  std::vector<Vec2> surface;
  Vec2 crest;  // right end of the highest part: the last vertex of greatest elevation
  Vec2 toe;    // foot of the face: the first vertex of least elevation right of the crest
};

/// A soil below `top`; later layers lie under earlier ones. The first has no top of its own: the ground surface.
struct Layer {
  std::string name;
  Material material;
  bool residual_cohesion_follows = true;  // the scene gives none: it is the peak, also where that varies
  bool residual_friction_follows = true;
  std::vector<Vec2> top;
};

/// Background grid and how densely it is filled: points_per_cell along each axis.
struct Discretization {
  GridShape grid;
  int points_per_cell = 2;
};

/// [field.<parameter>], in all soils but those that have one of their own, or [soil.field.<parameter>], in its soil alone: a random
/// field in place of a parameter that is the same everywhere in a soil.
struct FieldSpec {
  Parameter parameter = Parameter::cohesion;
  std::string name;                // of its dataset and its random numbers: the parameter's or, in one soil alone, "<parameter>.<soil>"
  std::vector<std::size_t> soils;  // that have it, indices into Scene::layers
  FieldModel model;                // its mesh covers the box of the slope from the origin
  Interpolation interpolation = Interpolation::cell;
  std::string measurements;  // path of a table that samples honour, from the scene's folder; empty: none
};

/// Thresholds of what is measured on the final state.
struct Output {
  double influence_drop = 0.5;     // a surface column has failed when it dropped by more than this, m
  double slid_displacement = 1.0;  // a run slid when some point moved by more than this, m
};

struct Study {
  std::uint64_t seed = 1;
  std::uint64_t realizations = 1000;
  StudyDesign design;
};

/// Where the section stands on the map, in the metres of a projected reference system: x east, y north.
struct Site {
  Vec2 crest;
  Vec2 toe;
  double bearing = 0;  // the way the slope faces, rad clockwise from north
  int epsg = 0;        // code of the reference system
  double width = 20;   // of the zones that are drawn, along the slope, m
};

struct Scene {
  std::string name;      // the file's name, for messages
  std::string checksum;  // of the file's bytes
  std::string title;
  Slope slope;
  Discretization discretization;
  std::vector<Layer> layers;
  Boundaries boundaries;
  Gravity gravity;
  Vec2 initial_velocity;  // of all soil, m/s
  TimeStepping time;
  Scheme method;
  std::optional<NonlocalSoftening> nonlocal_softening;
  std::vector<FieldSpec> fields;  // those of all soils first, each kind in the order of Parameter
  std::vector<CrossCorrelation> cross_correlations;
  Output output;
  Study study;
  std::optional<Site> site;
};

/// What a tool needs of the scene; tables that are present are checked in any case, needed ones must be present.
struct Needs {
  bool grid = false;   // [grid]
  bool soil = false;   // [[soil]]
  bool time = false;   // [time]
  bool field = false;  // at least one random field
  bool site = false;   // [site]
};

/// Parses a scene; `name` is the file's name in messages.
Scene parse_scene(std::string_view text, const std::string& name, Needs needs);

/// Reads and parses the file `path`, or stdin for "-".
Scene read_scene(const std::string& path, Needs needs);

/// Elevation of a polyline at x, linear between vertices, constant beyond its ends; the higher side at a vertical step.
double elevation(const std::vector<Vec2>& polyline, double x);

/// The initial material points: a lattice of grid cells divided by points_per_cell, of which those strictly inside the slope.
struct MaterialPoints {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<int> layer;  // index into Scene::layers
  double spacing_x = 0;    // of the lattice, m
  double spacing_y = 0;
};

/// Column by column from the left, each from the base up. Lattice points on the surface are outside. A point belongs to
/// the last layer whose top lies above it. Throws if no point lies inside, or none in some layer.
MaterialPoints material_points(const Scene& scene);

}  // namespace slidezone
