// Material points as a VTKHDF 1.0 UnstructuredGrid of vertices, which VTK 9.1 and ParaView 5.11 open (file name ending .hdf).
//
// Written as VTK 9.1 wants it: three-component points, int64 connectivity and offsets, NumberOfConnectivityIds, and a Type
// attribute of fixed-length ASCII; without any of these it reads zero points without a word.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/provenance.hpp"

namespace slidezone {

/// One value a point under its name, e.g. "plastic_strain".
struct PointData {
  std::string name;
  std::function<double(std::size_t)> value;  // of a point by its number
};

/// Hands the bytes of the file to `take`, piece by piece from front to back: most of it is never held in memory. x and y in m, z is 0.
void write_vtkhdf_points(std::span<const double> x, std::span<const double> y, const std::vector<PointData>& data,
                         const Provenance& provenance, const std::function<void(std::string_view)>& take);

/// The bytes of a `.hdf.series` index, which ParaView opens as an animation.
struct Frame {
  std::string file;
  double time;  // s
};
std::string vtkhdf_series(const std::vector<Frame>& frames);

}  // namespace slidezone
