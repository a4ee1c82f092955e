#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/large_page_allocator.hpp"
#include "core/provenance.hpp"
#include "core/round_step.hpp"
#include "core/text.hpp"
#include "core/workers.hpp"
#include "core/zeroed_allocator.hpp"

namespace slidezone {
namespace {

TEST(ParseReal, TakesFiniteDecimalsOnly) {
  EXPECT_EQ(parse_real("1e-3"), 1e-3);
  EXPECT_EQ(parse_real("-.5"), -0.5);
  for (const char* wrong : {"", "nan", "inf", "-inf", "1e999", "0x10", " 1", "1 ", "1,5", "+-1", "1e"})
    EXPECT_FALSE(parse_real(wrong)) << wrong;
}

TEST(ParseWhole, RefusesWhatCli11WouldMisread) {
  EXPECT_EQ(parse_whole("0"), 0u);
  EXPECT_EQ(parse_whole("18446744073709551615"), 18446744073709551615u);
  for (const char* wrong : {"", "-3", "010", "18446744073709551616", "1.0", "1e3", "+1"}) EXPECT_FALSE(parse_whole(wrong)) << wrong;
}

TEST(FormatReal, ReadsBackExactly) {
  for (const double value : {0.1, 1.0 / 3, 1e300, 5e-324, -2.5e-7}) EXPECT_EQ(parse_real(format_real(value)), value);
  EXPECT_EQ(format_real(0.1), "0.1");
  EXPECT_EQ(format_real(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(format_limit(0.1), "0.1");
  EXPECT_EQ(format_limit(std::numeric_limits<double>::infinity()), "unbounded");
  EXPECT_EQ(format_brief(9.30000001, 3), "9.3");
}

TEST(RoundStep, IsTheLargestBelowWithDecimalMultiples) {
  EXPECT_EQ(round_step(0.19).multiple(3), 0.3);
  EXPECT_EQ(round_step(0.2).multiple(1), 0.2);
  EXPECT_EQ(round_step(0.07).multiple(6), 0.3);
  EXPECT_EQ(round_step(1).multiple(7), 7);
  EXPECT_EQ(round_step(7300).multiple(2), 10000);
}

TEST(NearestHint, OffersOnlyNearNames) {
  const std::vector<std::string> known = {"height", "length", "angle"};
  EXPECT_EQ(nearest_hint("hieght", known), "; did you mean 'height'?");
  EXPECT_EQ(nearest_hint("porosity", known), "");
}

TEST(Location, NamesWhatIsKnown) {
  EXPECT_EQ(to_string({"a.toml", 4, 10}), "a.toml:4:10");
  EXPECT_EQ(to_string({"a.toml", 4, 0}), "a.toml:4");
  EXPECT_EQ(to_string({"a.toml", 0, 0}), "a.toml");
}

TEST(Checksum, IsXxh3) {
  // `printf '' | xxhsum -H3` prints XXH3_2d06800538d394c2.
  EXPECT_EQ(checksum(""), "2d06800538d394c2");
}

// ---- workers ----

TEST(Workers, DoEachTaskOnce) {
  for (const int threads : {1, 2, 7}) {
    Workers workers(threads);
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
      std::vector<std::atomic<int>> times(count);
      workers.each(count, [&](std::size_t number) { ++times[number]; });
      for (const auto& done : times) EXPECT_EQ(done, 1);
    }
  }
}

/// Pages of memory that this process has in use.
long resident_pages() {
  std::ifstream statm("/proc/self/statm");
  long size = 0, resident = 0;
  statm >> size >> resident;
  return resident;
}

TEST(ZeroedAllocator, TakesNoMemoryForZerosThatAreNotWritten) {
  constexpr std::size_t count = 10'000'000;  // 80 MB, some 20,000 pages
  const long before = resident_pages();
  std::vector<double, ZeroedAllocator<double>> values(count);
  values[count / 2] = 1;
  EXPECT_LT(resident_pages() - before, 100);
  EXPECT_EQ(std::count(values.begin(), values.end(), 0.0), static_cast<long>(count) - 1);
  const auto copy = values;
  EXPECT_EQ(copy[count / 2], 1);
}

/// What the system notes of the memory at an address: the line VmFlags of proc(5), smaps.
std::string flags_of_memory(const void* address) {
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  bool is_here = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) is_here = begin <= place && place < end;
    if (is_here && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

TEST(LargePageAllocator, AsksForLargePagesWhereAnArrayFillsThem) {
  if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "the system has no large pages";
  using Allocator = LargePageAllocator<double>;
  constexpr std::size_t in_a_page = large_page / sizeof(double);
  std::vector<double, Allocator> large(5 * in_a_page / 2, 1.0);
  EXPECT_NE(flags_of_memory(&large[2 * in_a_page - 1]).find(" hg "), std::string::npos);
  std::vector<double, Allocator> small(in_a_page - 1, 2.0);
  EXPECT_EQ(flags_of_memory(&small.back()).find(" hg "), std::string::npos);
  small.insert(small.end(), large.begin(), large.end());
  EXPECT_EQ(std::count(small.begin(), small.end(), 1.0), static_cast<long>(large.size()));
  EXPECT_EQ(std::count(small.begin(), small.end(), 2.0), static_cast<long>(in_a_page - 1));
}

}  // namespace
}  // namespace slidezone
