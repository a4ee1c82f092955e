// Material points as a VTKHDF 1.0 UnstructuredGrid of vertices, which VTK 9.1 and ParaView 5.11 open (file name ending .hdf).
//
// Written as VTK 9.1 wants it: three-component points, int64 connectivity and offsets, NumberOfConnectivityIds, and a Type
// attribute of fixed-length ASCII; without any of these it reads zero points without a word.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/provenance.hpp"

namespace slidezone {

/// One value a point under its name, e.g. "plastic_strain".
struct PointData {
  std::string name;
  std::span<const double> values;
};

/// The bytes of the file; x and y in m, z is 0.
std::string vtkhdf_points(std::span<const double> x, std::span<const double> y, const std::vector<PointData>& data,
                          const Provenance& provenance);

/// The bytes of a `.hdf.series` index, which ParaView opens as an animation.
struct Frame {
  std::string file;
  double time;  // s
};
std::string vtkhdf_series(const std::vector<Frame>& frames);

}  // namespace slidezone
