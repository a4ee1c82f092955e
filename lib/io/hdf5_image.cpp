#include "io/hdf5_image.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "io/hdf5_layout.hpp"

// Exported by the HDF5 library but declared in no public header: the checksum of its Fletcher-32 filter.
extern "C" std::uint32_t H5_checksum_fletcher32(const void* data, std::size_t length);

namespace slidezone {

namespace {

/// An HDF5 identifier that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }
  bool is_valid() const { return id_ >= 0; }
  /// Closes it now; true if that succeeded.
  bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Writing to memory fails only by our mistake or for want of memory.
hid_t must(hid_t id, const char* what) {
  if (id < 0) throw Error(ExitCode::internal, std::string("HDF5 could not build ") + what);
  return id;
}

void use_latest_format(hid_t access) { must(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "a file in memory"); }

/// HDF5 refuses to open two files of one name at a time, also in memory.
std::string next_image_name() {
  static int count = 0;
  return "slidezone-image-" + std::to_string(++count);
}

void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

/// Groups without times.
Handle group_properties(hid_t property_class) {
  Handle properties(H5Pcreate(property_class), H5Pclose);
  must(H5Pset_obj_track_times(properties, 0), "group properties");
  return properties;
}

std::size_t product(std::span<const hsize_t> shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1},
                         [](std::size_t a, hsize_t b) { return a * static_cast<std::size_t>(b); });
}

bool is_empty(std::span<const hsize_t> shape) { return product(shape) == 0; }

constexpr std::size_t checksum_size = 4;

}  // namespace

// ---- writer -----------------------------------------------------------------------------------------------------------

/// A chunk as HDF5's Fletcher-32 filter leaves it: the numbers, then their checksum, least byte first.
template <class Number>
static void fill_slice(const std::function<void(std::size_t, std::span<Number>)>& fill, std::size_t slice, std::size_t numbers,
                       std::span<std::byte> bytes) {
  fill(slice, {reinterpret_cast<Number*>(bytes.data()), numbers});
  const std::size_t size = numbers * sizeof(Number);
  const std::uint32_t sum = H5_checksum_fletcher32(bytes.data(), size);
  for (std::size_t byte = 0; byte < checksum_size; ++byte) bytes[size + byte] = static_cast<std::byte>(sum >> (8 * byte) & 0xff);
}

/// Of a dataset that is made later: one for each item of its first dimension, or one for all of a single dimension.
static std::size_t slices_of(const std::vector<hsize_t>& shape) { return shape.size() > 1 ? shape[0] : 1; }

static Handle new_file(Hdf5Layout& layout) {
  silence_hdf5();
  const Handle access(access_to(layout), H5Pclose);
  use_latest_format(access);
  const Handle creation = group_properties(H5P_FILE_CREATE);
  return Handle(must(H5Fcreate(next_image_name().c_str(), H5F_ACC_TRUNC, creation, access), "a file in memory"), H5Fclose);
}

struct Hdf5Writer::State {
  Hdf5Layout layout;  // before the file, which writes to it until it is closed
  Handle file = new_file(layout);

  Handle object(const std::string& path) const {
    return Handle(must(H5Oopen(file, path.empty() ? "/" : path.c_str(), H5P_DEFAULT), path.c_str()), H5Oclose);
  }
  void attribute(const std::string& path, const std::string& name, hid_t type, hid_t space, const void* value) const {
    const Handle owner = object(path);
    const Handle attribute(must(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), name.c_str()), H5Aclose);
    must(H5Awrite(attribute, type, value), name.c_str());
  }
  Handle new_dataset(const std::string& path, hid_t type, const std::vector<hsize_t>& shape, const std::vector<hsize_t>& chunk) const {
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    must(H5Pset_obj_track_times(properties, 0), path.c_str());
    if (!is_empty(shape)) {
      must(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), path.c_str());
      must(H5Pset_fletcher32(properties), path.c_str());
    }
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    return Handle(must(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), path.c_str()), H5Dclose);
  }
  void dataset(const std::string& path, hid_t type, const void* values, const std::vector<hsize_t>& shape) const {
    const Handle dataset = new_dataset(path, type, shape, shape);
    if (!is_empty(shape)) must(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path.c_str());
  }
  template <class Number>
  void slice_later(hid_t dataset, const std::string& path, const std::vector<hsize_t>& shape, std::size_t slice,
                   const std::function<void(std::size_t, std::span<Number>)>& fill) {
    const std::size_t numbers = product(shape) / slices_of(shape);
    layout.next_slice = [fill, slice, numbers](std::span<std::byte> bytes) { fill_slice(fill, slice, numbers, bytes); };
    std::vector<hsize_t> start(shape.size(), 0);
    if (shape.size() > 1) start[0] = slice;
    const char nothing = 0;  // the driver keeps the place of a slice and leaves the bytes alone
    must(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, start.data(), numbers * sizeof(Number) + checksum_size, &nothing), path.c_str());
  }
  Handle new_sliced_dataset(const std::string& path, hid_t type, const std::vector<hsize_t>& shape) const {
    std::vector<hsize_t> slice_shape = shape;
    if (shape.size() > 1) slice_shape[0] = 1;
    return new_dataset(path, type, shape, slice_shape);
  }
};

Hdf5Writer::Hdf5Writer() : state_(new State) {}
Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::group(const std::string& path) {
  const Handle properties = group_properties(H5P_GROUP_CREATE);
  const Handle group(must(H5Gcreate2(state_->file, path.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), path.c_str()), H5Gclose);
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, const std::string& value) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(1, value.size()));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  state_->attribute(path, name, type, space, value.c_str());
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  state_->attribute(path, name, H5T_NATIVE_DOUBLE, space, &value);
}

void Hdf5Writer::attribute(const std::string& path, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  state_->attribute(path, name, H5T_NATIVE_INT64, space, values.data());
}

void Hdf5Writer::dataset(const std::string& path, std::span<const double> values, const std::vector<std::size_t>& shape) {
  assert(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) == values.size());
  state_->dataset(path, H5T_NATIVE_DOUBLE, values.data(), {shape.begin(), shape.end()});
}

void Hdf5Writer::dataset(const std::string& path, std::span<const std::int64_t> values) {
  state_->dataset(path, H5T_NATIVE_INT64, values.data(), {values.size()});
}

void Hdf5Writer::dataset(const std::string& path, std::span<const std::uint8_t> values) {
  state_->dataset(path, H5T_NATIVE_UINT8, values.data(), {values.size()});
}

void Hdf5Writer::dataset_later(const std::string& path, const std::vector<std::size_t>& shape,
                               std::function<void(std::size_t, std::span<double>)> fill) {
  datasets_later({{path, shape, std::move(fill)}});
}

void Hdf5Writer::dataset_later(const std::string& path, std::size_t count, std::function<void(std::size_t, std::span<std::int64_t>)> fill) {
  const std::vector<hsize_t> shape = {count};
  const Handle dataset = state_->new_sliced_dataset(path, H5T_NATIVE_INT64, shape);
  if (count > 0) state_->slice_later(dataset, path, shape, 0, fill);
}

void Hdf5Writer::datasets_later(const std::vector<LaterDataset>& datasets) {
  std::vector<Handle> handles;
  std::size_t slices = 0;
  for (const LaterDataset& dataset : datasets) {
    const std::vector<hsize_t> shape(dataset.shape.begin(), dataset.shape.end());
    handles.push_back(state_->new_sliced_dataset(dataset.path, H5T_NATIVE_DOUBLE, shape));
    if (!is_empty(shape)) slices = slices_of(shape);
  }
  for (std::size_t slice = 0; slice < slices; ++slice)
    for (std::size_t i = 0; i < datasets.size(); ++i)
      state_->slice_later(handles[i], datasets[i].path, {datasets[i].shape.begin(), datasets[i].shape.end()}, slice, datasets[i].fill);
}

void Hdf5Writer::provenance(const Provenance& provenance) {
  attribute("", "schema", provenance.schema);
  attribute("", "tool", provenance.tool);
  for (const auto& [key, value] : provenance.details) attribute("", key, value);
}

void Hdf5Writer::write(const std::function<void(std::string_view)>& take) {
  if (!state_->file.close()) throw Error(ExitCode::internal, "HDF5 could not build the file");
  write_out(state_->layout, take);
  state_.reset();
}

std::string Hdf5Writer::image() {
  std::string image;
  write([&](std::string_view bytes) { image += bytes; });
  return image;
}

// ---- reader -----------------------------------------------------------------------------------------------------------

struct Hdf5Reader::State {
  std::string name;
  Handle file;

  [[noreturn]] void fail(const std::string& message) const { throw Error(ExitCode::data, name + ": " + message); }

  Handle object(const std::string& path) const {
    Handle object(H5Oopen(file, path.empty() ? "/" : path.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.is_valid()) fail("no '" + path + "' in the file, or it is damaged");
    return object;
  }
  Handle attribute(const std::string& path, const std::string& attribute_name) const {
    const Handle owner = object(path);
    Handle attribute(H5Aopen(owner, attribute_name.c_str(), H5P_DEFAULT), H5Aclose);
    if (!attribute.is_valid()) fail("no attribute '" + attribute_name + "' at '/" + path + "'");
    return attribute;
  }
  Handle dataset(const std::string& path) const {
    Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset.is_valid()) fail("no dataset '" + path + "' in the file, or it is damaged");
    return dataset;
  }
};

static std::vector<hsize_t> extent(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

// HDF5 would copy an image twice; these callbacks have it read the caller's bytes in place. H5FDpublic.h states their contract.
static void* lend_image(std::size_t, H5FD_file_image_op_t, void* image) { return image; }
static void* skip_copy(void* target, const void*, std::size_t, H5FD_file_image_op_t, void*) { return target; }
static void* refuse_growth(void*, std::size_t, H5FD_file_image_op_t, void*) { return nullptr; }
static herr_t keep_image(void*, H5FD_file_image_op_t, void*) { return 0; }
static void* same_image(void* image) { return image; }
static herr_t leave_image(void*) { return 0; }

static Handle open_image(std::string_view image) {
  silence_hdf5();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t increment = 1 << 20;
  char* const bytes = const_cast<char*>(image.data());  // opened for reading alone
  H5FD_file_image_callbacks_t callbacks{lend_image, skip_copy, refuse_growth, keep_image, same_image, leave_image, bytes};
  const bool is_set = H5Pset_fapl_core(access, increment, 0) >= 0 && H5Pset_file_image_callbacks(access, &callbacks) >= 0 &&
                      H5Pset_file_image(access, bytes, image.size()) >= 0;
  if (!is_set) return Handle(-1, H5Fclose);
  return Handle(H5Fopen(next_image_name().c_str(), H5F_ACC_RDONLY, access), H5Fclose);
}

Hdf5Reader::Hdf5Reader(std::string_view image, const std::string& name, std::string_view schema)
    : state_(new State{name, image.empty() ? Handle(-1, H5Fclose) : open_image(image)}) {
  if (!state_->file.is_valid())
    state_->fail(image.empty() ? "found an empty file, expected HDF5"
                               : "found no HDF5 file, or a damaged one; expected schema '" + std::string(schema) + "'");
  const std::string found = text_attribute("", "schema");
  if (found != schema) state_->fail("found schema '" + found + "', expected '" + std::string(schema) + "'");
}

Hdf5Reader::~Hdf5Reader() = default;

const std::string& Hdf5Reader::name() const { return state_->name; }

bool Hdf5Reader::has(const std::string& path) const { return H5Lexists(state_->file, path.c_str(), H5P_DEFAULT) > 0; }

std::string Hdf5Reader::text_attribute(const std::string& path, const std::string& name) const {
  const Handle attribute = state_->attribute(path, name);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    state_->fail("attribute '" + name + "' is not a fixed-length text");
  std::string value(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, value.data()) < 0) state_->fail("attribute '" + name + "' is damaged");
  value.resize(std::strlen(value.c_str()));
  return value;
}

double Hdf5Reader::real_attribute(const std::string& path, const std::string& name) const {
  const Handle attribute = state_->attribute(path, name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  double value = 0;
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    state_->fail("attribute '" + name + "' is not a number");
  return value;
}

std::vector<std::size_t> Hdf5Reader::shape(const std::string& path) const {
  const std::vector<hsize_t> shape = extent(state_->dataset(path));
  return {shape.begin(), shape.end()};
}

std::vector<double> Hdf5Reader::reals(const std::string& path) const {
  const Handle dataset = state_->dataset(path);
  std::vector<double> values(product(extent(dataset)));
  if (!values.empty() && H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    state_->fail("dataset '" + path + "' is damaged (checksum) or not of numbers");
  return values;
}

std::vector<double> Hdf5Reader::reals(const std::string& path, std::size_t index) const {
  const Handle dataset = state_->dataset(path);
  std::vector<hsize_t> shape = extent(dataset);
  if (shape.empty() || index >= shape[0]) state_->fail("dataset '" + path + "' has no slice " + std::to_string(index));
  std::vector<hsize_t> start(shape.size(), 0);
  start[0] = index;
  shape[0] = 1;
  const Handle in_file(H5Dget_space(dataset), H5Sclose);
  H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
  const Handle in_memory(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  std::vector<double> values(product(shape));
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, values.data()) < 0)
    state_->fail("dataset '" + path + "' is damaged (checksum) or not of numbers");
  return values;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path) const {
  const Handle dataset = state_->dataset(path);
  std::vector<std::int64_t> values(product(extent(dataset)));
  if (!values.empty() && H5Dread(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    state_->fail("dataset '" + path + "' is damaged (checksum) or not of numbers");
  return values;
}

}  // namespace slidezone
