// Where the bytes of an HDF5 file lie, found by letting HDF5 build the file on a file driver of ours.
//
// What HDF5 writes is kept in pages in memory, but for slices of large datasets: of them only the place is kept, and their
// bytes are made when the file is written out from front to back. That works because a slice's size is known beforehand and
// nothing else in the file depends on its bytes. So a file of any size needs memory for one slice, and a pipe will do.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string_view>
#include <vector>

namespace slidezone {

struct Hdf5Layout {
  using Page = std::vector<char>;

  /// A range of the file whose bytes `fill` makes.
  struct Slice {
    std::uint64_t address;
    std::size_t size;
    std::function<void(std::span<std::byte>)> fill;
  };

  std::map<std::uint64_t, Page> pages;  // by number; what no page holds is zero
  std::vector<Slice> slices;
  std::uint64_t allocated = 0;                                     // end of what HDF5 has claimed
  std::uint64_t written = 0;                                       // end of what it has written
  std::function<void(std::span<std::byte>)> next_slice = nullptr;  // set: raw data written now is a slice, not to be kept
};

/// A file access property list for H5Fcreate(). `layout` must outlive the file. The caller closes the list.
hid_t access_to(Hdf5Layout& layout);

/// Hands the whole file to `take`, piece by piece from front to back. The HDF5 file must be closed.
void write_out(const Hdf5Layout& layout, const std::function<void(std::string_view)>& take);

}  // namespace slidezone
