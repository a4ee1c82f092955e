#include "io/hdf5_layout.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/error.hpp"

namespace slidezone {

namespace {

constexpr std::uint64_t page_size = 1 << 16;

/// Calls act(page, place in it, bytes, place in the range) for each page that the range touches.
template <class Act>
void for_each_page(std::uint64_t address, std::size_t size, Act act) {
  for (std::size_t done = 0; done < size;) {
    const std::uint64_t at = (address + done) % page_size;
    const std::size_t count = std::min<std::size_t>(size - done, page_size - at);
    act((address + done) / page_size, at, count, done);
    done += count;
  }
}

// ---- the driver: functions that HDF5 calls (H5FDpublic.h) -----------------------------------------------------------------

/// HDF5's view of an open file; it knows the first member alone.
struct Driver {
  H5FD_t file;
  Hdf5Layout* layout;
};

Hdf5Layout& layout_of(const H5FD_t* file) { return *reinterpret_cast<const Driver*>(file)->layout; }

H5FD_t* open_layout(const char*, unsigned, hid_t access, haddr_t) {
  auto driver = std::make_unique<Driver>();
  driver->layout = *static_cast<Hdf5Layout* const*>(H5Pget_driver_info(access));
  return &driver.release()->file;  // until close_layout()
}

herr_t close_layout(H5FD_t* file) {
  const std::unique_ptr<Driver> driver(reinterpret_cast<Driver*>(file));
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) { return std::less<>()(a, b) ? -1 : a == b ? 0 : 1; }

haddr_t claimed_end(const H5FD_t* file, H5FD_mem_t) { return layout_of(file).allocated; }

herr_t claim(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  layout_of(file).allocated = end;
  return 0;
}

haddr_t written_end(const H5FD_t* file, H5FD_mem_t) { return layout_of(file).written; }

herr_t read_pages(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  const Hdf5Layout& layout = layout_of(file);
  char* bytes = static_cast<char*>(buffer);
  for_each_page(address, size, [&](std::uint64_t number, std::uint64_t at, std::size_t count, std::size_t done) {
    const auto page = layout.pages.find(number);
    if (page == layout.pages.end())
      std::memset(bytes + done, 0, count);
    else
      std::memcpy(bytes + done, page->second.data() + at, count);
  });
  return 0;
}

herr_t write_pages(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t address, std::size_t size, const void* buffer) {
  Hdf5Layout& layout = layout_of(file);
  layout.written = std::max<std::uint64_t>(layout.written, address + size);
  if (type == H5FD_MEM_DRAW && layout.next_slice) {
    layout.slices.push_back({address, size, std::move(layout.next_slice)});
    layout.next_slice = nullptr;
    return 0;
  }
  const char* bytes = static_cast<const char*>(buffer);
  for_each_page(address, size, [&](std::uint64_t number, std::uint64_t at, std::size_t count, std::size_t done) {
    Hdf5Layout::Page& page = layout.pages[number];
    page.resize(page_size);
    std::memcpy(page.data() + at, bytes + done, count);
  });
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "slidezone";
  driver.maxaddr = std::uint64_t{1} << 62;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Hdf5Layout*);
  driver.open = open_layout;
  driver.close = close_layout;
  driver.cmp = compare;
  driver.get_eoa = claimed_end;
  driver.set_eoa = claim;
  driver.get_eof = written_end;
  driver.read = read_pages;
  driver.write = write_pages;
  const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

void take_pages(const Hdf5Layout& layout, std::uint64_t begin, std::uint64_t end, const std::function<void(std::string_view)>& take) {
  static const Hdf5Layout::Page zeros(page_size);
  for_each_page(begin, end - begin, [&](std::uint64_t number, std::uint64_t at, std::size_t count, std::size_t) {
    const auto page = layout.pages.find(number);
    take({(page == layout.pages.end() ? zeros : page->second).data() + at, count});
  });
}

}  // namespace

hid_t access_to(Hdf5Layout& layout) {
  static const H5FD_class_t driver = driver_class();
  static const hid_t driver_id = H5FDregister(&driver);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  Hdf5Layout* const info = &layout;
  if (access < 0 || driver_id < 0 || H5Pset_driver(access, driver_id, &info) < 0)
    throw Error(ExitCode::internal, "HDF5 refused the file driver");
  return access;
}

void write_out(const Hdf5Layout& layout, const std::function<void(std::string_view)>& take) {
  std::vector<const Hdf5Layout::Slice*> slices;
  for (const Hdf5Layout::Slice& slice : layout.slices) slices.push_back(&slice);
  std::ranges::sort(slices, {}, &Hdf5Layout::Slice::address);
  std::uint64_t done = 0;
  std::vector<std::byte> buffer;
  for (const Hdf5Layout::Slice* slice : slices) {
    take_pages(layout, done, slice->address, take);
    buffer.resize(slice->size);
    slice->fill(buffer);
    take({reinterpret_cast<const char*>(buffer.data()), buffer.size()});
    done = slice->address + slice->size;
  }
  take_pages(layout, done, layout.allocated, take);
}

}  // namespace slidezone
