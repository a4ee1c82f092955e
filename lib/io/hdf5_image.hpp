// HDF5 files: built by Hdf5Writer, taken apart by Hdf5Reader from an image in memory; io/file.hpp moves the bytes.
//
// HDF5 itself never touches a file: HDF5 1.10.8 crashes at exit after a failed write, and a pipe cannot seek. Written in the
// latest format with Fletcher-32 checksums on chunked datasets, without times, so that equal contents give equal bytes and
// corruption is noticed. Datasets too large for memory are made slice by slice while the file is written.
// Paths name groups and datasets from the root: "points/x". The root is "". Numbers are stored as float64, int64 or uint8.
// Errors: ExitCode::data with the file's name for a file that is not HDF5, damaged, or lacks what is asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/provenance.hpp"

namespace slidezone {

class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Parents must exist.
  void group(const std::string& path);

  /// Text attributes are fixed-length ASCII, as VTK expects.
  void attribute(const std::string& path, const std::string& name, const std::string& value);
  void attribute(const std::string& path, const std::string& name, double value);
  void attribute(const std::string& path, const std::string& name, std::span<const std::int64_t> values);

  /// `shape` is row-major; its product is values.size(). One chunk.
  void dataset(const std::string& path, std::span<const double> values, const std::vector<std::size_t>& shape);
  void dataset(const std::string& path, std::span<const std::int64_t> values);
  void dataset(const std::string& path, std::span<const std::uint8_t> values);

  /// The same, made later: while the file is written, `fill` is called once for each slice of the first dimension, with its
  /// number and the span to fill; for one dimension once, with the whole. One chunk a slice. Datasets are filled in the order of these
  /// calls.
  void dataset_later(const std::string& path, const std::vector<std::size_t>& shape,
                     std::function<void(std::size_t, std::span<double>)> fill);
  void dataset_later(const std::string& path, std::size_t count, std::function<void(std::size_t, std::span<std::int64_t>)> fill);

  /// Several datasets of as many slices each that take turns: slice 0 of each, in their order, then slice 1 of each, and so on.
  struct LaterDataset {
    std::string path;
    std::vector<std::size_t> shape;
    std::function<void(std::size_t, std::span<double>)> fill;
  };
  void datasets_later(const std::vector<LaterDataset>& datasets);

  /// Provenance as attributes of the root: "schema", "tool" and each detail by its key.
  void provenance(const Provenance& provenance);

  /// Hands the bytes of the file to `take`, piece by piece from front to back. The writer is spent afterwards.
  void write(const std::function<void(std::string_view)>& take);

  /// The bytes of the file as one piece. The writer is spent afterwards.
  std::string image();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class Hdf5Reader {
 public:
  /// `name` is the file's name in messages. The schema attribute is checked first. The image must outlive the reader.
  Hdf5Reader(std::string_view image, const std::string& name, std::string_view schema);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  const std::string& name() const;
  bool has(const std::string& path) const;

  std::string text_attribute(const std::string& path, const std::string& name) const;
  double real_attribute(const std::string& path, const std::string& name) const;

  std::vector<std::size_t> shape(const std::string& path) const;
  std::vector<double> reals(const std::string& path) const;
  /// Slice `index` of the first dimension.
  std::vector<double> reals(const std::string& path, std::size_t index) const;
  std::vector<std::int64_t> integers(const std::string& path) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slidezone
