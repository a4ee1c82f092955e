#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "io/table.hpp"
#include "io/toml.hpp"
#include "io/units.hpp"

namespace slidezone {
namespace {

/// The message of the Error that `act` throws; fails the test if it throws none or with another code.
std::string message_of(const std::function<void()>& act, ExitCode code = ExitCode::data) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

// ---- units ----

TEST(Units, ConvertsToSi) {
  EXPECT_DOUBLE_EQ(parse_quantity("5 m", "m"), 5);
  EXPECT_DOUBLE_EQ(parse_quantity("20 kN/m^3", "N m-3"), 20e3);
  EXPECT_DOUBLE_EQ(parse_quantity("1 MPa", "Pa"), 1e6);
  EXPECT_NEAR(parse_quantity("45 deg", "rad"), std::numbers::pi / 4, 1e-15);
  EXPECT_EQ(parse_quantity("0 deg", "rad"), 0);  // UDUNITS alone refuses a unit scaled by zero
  EXPECT_DOUBLE_EQ(parse_quantity("7.5e-4 s", "s"), 7.5e-4);
}

TEST(Units, TakesExponentsInEverySpelling) {
  for (const char* text : {"2 kN/m^3", "2 kN/m3", "2 kN m-3", "2 kN m^-3", "2 kN.m-3", "2kN/m**3", "2 kN/(m^3)", "2 kN/m\u00b3"})
    EXPECT_DOUBLE_EQ(parse_quantity(text, "N m-3"), 2e3) << text;
  EXPECT_DOUBLE_EQ(parse_quantity("2 1/s", "s-1"), 2);
  EXPECT_EQ(parse_quantity("90 degree", "rad"), std::numbers::pi / 2);
}

TEST(Units, RefusesWhatUdunitsWouldStretchToFit) {
  for (const char* wrong :
       {"5 Hz", "5 1/s", "5 s @ 3", "5 lg(re 1 s)", "1 200 s", "1 000 s", "5 s 2", "5 -1 s", "5 1 s", "5 s/2", "5 2*s", "1,5 s"})
    EXPECT_THROW(parse_quantity(wrong, "s"), std::invalid_argument) << wrong;
  for (const char* wrong : {"45 %", "45 1", "45 sr", "45 rad2"}) EXPECT_THROW(parse_quantity(wrong, "rad"), std::invalid_argument) << wrong;
}

TEST(Units, AgreesWithTheDatabaseOnCommonUnits) {
  // Spelled out, a unit is found in the database of UDUNITS-2 alone. Both round: 1e-15.
  for (const auto& [common, spelled, unit] : std::vector<std::array<const char*, 3>>{{"1 m", "1 meter", "m"},
                                                                                     {"1 cm", "1 centimeter", "m"},
                                                                                     {"1 mm", "1 millimeter", "m"},
                                                                                     {"1 kg/m^3", "1 kilogram/meter^3", "kg m-3"},
                                                                                     {"1 g/cm^3", "1 gram/centimeter^3", "kg m-3"},
                                                                                     {"1 t/m^3", "1 metric_ton/meter^3", "kg m-3"},
                                                                                     {"1 MN/m^3", "1 meganewton/meter^3", "N m-3"},
                                                                                     {"1 GPa", "1 gigapascal", "Pa"},
                                                                                     {"1 ms", "1 millisecond", "s"},
                                                                                     {"1 min", "1 minute", "s"},
                                                                                     {"1 h", "1 hour", "s"},
                                                                                     {"1 rad", "1 radian", "rad"},
                                                                                     {"1 deg", "1 degree", "rad"}}) {
    const double expected = parse_quantity(spelled, unit);
    EXPECT_NEAR(parse_quantity(common, unit), expected, 1e-15 * expected) << common;
  }
}

TEST(Units, KnowsWhatTheDatabaseKnows) {
  EXPECT_DOUBLE_EQ(parse_quantity("10 ft", "m"), 3.048);
  EXPECT_DOUBLE_EQ(parse_quantity("1 bar", "Pa"), 1e5);
  EXPECT_NEAR(parse_quantity("1 lbf/ft^3", "N m-3"), 157.08746, 1e-5);  // 4.4482216152605 N / 0.3048^3 m^3
}

TEST(Units, RefusesWrongDimensionsAndText) {
  for (const char* wrong : {"5", "5 kPa", "m", "", "five m", "nan m", "inf m", "1e999 m", "5 m m", "5 metros", "1e308 km"})
    EXPECT_THROW(parse_quantity(wrong, "m"), std::invalid_argument) << wrong;
}

// ---- TOML ----

TEST(Toml, NamesThePlaceOfAWrongDimension) {
  const TomlTable file = TomlTable::parse("[slope]\n\nheight = \"5 kPa\"\n", "slope.toml");
  EXPECT_EQ(message_of([&] { file.table("slope").quantity("height", "m", positive); }),
            "slope.toml:3:10: 'height' wants a length, found \"5 kPa\"; write e.g. \"5 m\"");
}

TEST(Toml, OffersTheNearestKey) {
  const TomlTable file = TomlTable::parse("[slope]\nhieght = \"5 m\"\n", "s.toml");
  EXPECT_EQ(message_of([&] {
              file.table("slope").check_keys({"height", "length"});
            }),
            "s.toml:2:1: unknown key 'hieght' in [slope]; did you mean 'height'?");
}

TEST(Toml, RefusesNumbersOutOfRangeAndNotFinite) {
  const TomlTable file = TomlTable::parse("a = -1\nb = nan\nc = inf\nd = \"x\"\n", "s.toml");
  EXPECT_EQ(message_of([&] { file.number("a", positive); }), "s.toml:1:5: 'a' wants a number above 0, found -1");
  message_of([&] { file.number("b", any_number); });
  message_of([&] { file.number("c", any_number); });
  message_of([&] { file.number("d", any_number); });
  message_of([&] { file.whole("a", 0, 9); });
}

TEST(Toml, ReportsSyntaxErrorsWithTheirPlace) {
  EXPECT_TRUE(message_of([] { TomlTable::parse("[slope\n", "s.toml"); }).starts_with("s.toml:1:7: "));
}

TEST(Toml, TellsRealNumbersFromWholeOnes) {
  const TomlTable file = TomlTable::parse("a = 1e3\nb = 2.5\nc = nan\n", "s.toml");
  EXPECT_EQ(message_of([&] { file.whole("a", 1, 9); }), "s.toml:1:5: 'a' wants a whole number from 1 to 9, found 1000.0");
  EXPECT_EQ(message_of([&] { file.whole("b", 1, 9); }), "s.toml:2:5: 'b' wants a whole number from 1 to 9, found 2.5");
  EXPECT_EQ(message_of([&] { file.whole("c", 1, 9); }), "s.toml:3:5: 'c' wants a whole number from 1 to 9, found nan");
}

TEST(Toml, KnowsABinaryFile) {
  EXPECT_EQ(message_of([] { TomlTable::parse(std::string_view("\x89HDF\r\n\x1a\n\0", 9), "f.h5"); }),
            "f.h5: found an HDF5 file, expected TOML; are files and arguments in the right order?");
}

TEST(Toml, ReadsPolylines) {
  const TomlTable file = TomlTable::parse("p = [[\"0 m\", \"5 m\"], [\"200 cm\", \"1 m\"]]\nq = [[\"0 m\"]]", "s.toml");
  const auto points = file.polyline("p", 2);
  EXPECT_DOUBLE_EQ(points[1].x, 2);
  message_of([&] { file.polyline("p", 3); });
  message_of([&] { file.polyline("q", 1); });
}

TEST(Toml, ReadsOneQuantityForBothAxesOrOneForEach) {
  const TomlTable file = TomlTable::parse("a = \"2 m\"\nb = [\"1 m\", \"50 cm\"]\nc = [\"1 m\"]\nd = [\"1 m\", \"-1 m\"]\ne = 3", "s.toml");
  EXPECT_EQ(file.quantity_pair("a", "m", positive).y, 2);
  EXPECT_DOUBLE_EQ(file.quantity_pair("b", "m", positive).x, 1);
  EXPECT_DOUBLE_EQ(file.quantity_pair("b", "m", positive).y, 0.5);
  EXPECT_EQ(message_of([&] { file.quantity_pair("c", "m", positive); }),
            "s.toml:3:5: 'c' wants \"5 m\" or [\"5 m\", \"5 m\"] (x, y), found a list of 1");
  EXPECT_EQ(message_of([&] { file.quantity_pair("d", "m", positive); }), "s.toml:4:13: 'd' wants above 0 m, found \"-1 m\"");
  EXPECT_EQ(message_of([&] { file.quantity_pair("e", "m", positive); }),
            "s.toml:5:5: 'e' wants a text with its unit, found 3; write e.g. \"5 m\"");
}

TEST(Toml, GivesRangesOfAnglesInDegrees) {
  const TomlTable file = TomlTable::parse("a = \"90 deg\"\n", "s.toml");
  const Range acute{0, std::numbers::pi / 2, false, true};
  EXPECT_EQ(message_of([&] { file.quantity("a", "rad", acute); }), "s.toml:1:5: 'a' wants at least 0 and below 90 deg, found \"90 deg\"");
}

TEST(Toml, TellsListsFromOtherValues) {
  const TomlTable file = TomlTable::parse("a = [1]\nb = \"1 m\"\n", "s.toml");
  EXPECT_TRUE(file.is_list("a"));
  EXPECT_FALSE(file.is_list("b"));
  EXPECT_FALSE(file.is_list("c"));
}

TEST(Toml, NamesNestedTablesInFull) {
  const TomlTable file = TomlTable::parse("[time]\nrest = 1\n", "s.toml");
  EXPECT_EQ(message_of([&] { file.table("time").table("rest"); }), "s.toml:2:8: 'rest' wants a table, found 1; write [time.rest]");
}

TEST(Toml, NamesThePlaceOfAnItem) {
  const TomlTable file = TomlTable::parse("a = [1,\n  2]\n", "s.toml");
  EXPECT_EQ(message_of([&] { file.fail("a", 1, "is wrong"); }), "s.toml:2:3: 'a' is wrong");
}

// ---- tables ----

TEST(Table, ReadsConcatenatedTables) {
  Table table({"a", "b"});
  table.add_row({"1", "x"});
  const std::string bytes = to_tsv(table, provenance("s 1", "t"));
  const std::vector<std::string> required = {"a"};
  const Table read = parse_tsv(bytes + bytes, "f", "s 1", required);
  ASSERT_EQ(read.row_count(), 2u);
  EXPECT_EQ(read.whole(1, "a"), 1u);
  EXPECT_EQ(read.where(1).line, 8);
}

TEST(Table, ReadsWhatSpreadsheetsOfWindowsWrite) {
  const std::vector<std::string> required = {"a"};
  const Table read = parse_tsv(
      "\xEF\xBB\xBF"
      "a\tb\r\n1\t2\r\n",
      "f.tsv", "s 1", required);
  EXPECT_EQ(read.number(0, "a"), 1);
  EXPECT_EQ(read.number(0, "b"), 2);
}

TEST(Table, NamesFileLineAndColumnOfAWrongField) {
  const std::vector<std::string> required = {"a"};
  const Table read = parse_tsv("a\tb\n1\t2\nnan\t3\n", "f.tsv", "s 1", required);
  EXPECT_EQ(message_of([&] { read.number(1, "a"); }), "f.tsv:3: column 'a': found 'nan', expected a finite number");
  EXPECT_TRUE(std::isnan(read.number_or_nan(1, "a")));
}

TEST(Table, KnowsABinaryFileAndColumnsPartedByCommas) {
  const std::vector<std::string> required = {"name"};
  EXPECT_EQ(message_of([&] { parse_tsv(std::string_view("a\0b", 3), "f", "s 1", required); }),
            "f: found a binary file, expected a table of text; are files and arguments in the right order?");
  EXPECT_EQ(message_of([&] { parse_tsv("name,side\nroad,toe\n", "f", "s 1", required); }),
            "f:1: no column 'name' in the header row; columns are parted by tabs");
}

TEST(Table, RefusesOtherSchemasMissingColumnsAndRaggedRows) {
  const std::vector<std::string> required = {"a"};
  message_of([&] { parse_tsv("# schema: s 2\na\n", "f", "s 1", required); });
  message_of([&] { parse_tsv("b\n1\n", "f", "s 1", required); });
  message_of([&] { parse_tsv("a\tb\n1\n", "f", "s 1", required); });
  message_of([&] { parse_tsv("a\ta\n", "f", "s 1", required); });
  message_of([&] { parse_tsv("", "f", "s 1", required); });
}

// ---- files ----

class Files : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "slidezone-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

TEST_F(Files, ReplacesWholeAndLeavesNoTemporary) {
  const std::string path = folder / "out";
  write_output(path, "first");
  write_output(path, "second");
  EXPECT_EQ(read_input(path), "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(Files, WritesThroughALink) {
  std::ofstream(folder / "real") << "old";
  std::filesystem::create_symlink("real", folder / "link");
  write_output(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_input(folder / "real"), "new");
}

TEST_F(Files, NamesWhatIsMissing) {
  message_of([&] { read_input(folder / "absent"); }, ExitCode::no_input);
  write_output(folder / "real", "new");
  EXPECT_EQ(InputFile(folder / "real").bytes(), "new");
  EXPECT_EQ(InputFile("/dev/null").bytes(), "");
  write_output(folder / "empty", "");
  EXPECT_EQ(InputFile(folder / "empty").bytes(), "");
  message_of([&] { InputFile(folder / "absent"); }, ExitCode::no_input);
  message_of([&] { write_output(folder / "no" / "such", "x"); }, ExitCode::cannot_create);
  message_of([&] { write_output(folder, "x"); }, ExitCode::cannot_create);
}

TEST(File, SaysBeforehandWhatCannotBeCreated) {
  const std::string folder = testing::TempDir() + "slidezone-none/";
  EXPECT_EQ(message_of([&] { check_can_create(folder + "row.tsv"); }, ExitCode::cannot_create),
            folder + "row.tsv: cannot be created: No such file or directory");
  check_can_create(testing::TempDir() + "slidezone-row.tsv");
  EXPECT_FALSE(std::filesystem::exists(testing::TempDir() + "slidezone-row.tsv"));
}

TEST(File, ReportsAFullDisk) {
  message_of([] { write_output("/dev/full", "x"); }, ExitCode::io);
}

// ---- HDF5 ----

std::string sample_image() {
  Hdf5Writer writer;
  writer.provenance(provenance("s 1", "t"));
  writer.group("g");
  writer.attribute("g", "unit", std::string("Pa"));
  std::vector<double> values(600);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) / 7;
  writer.dataset("g/v", values, {2, 300});
  return writer.image();
}

TEST(Hdf5, ReadsBackWhatWasWritten) {
  const std::string image = sample_image();
  const Hdf5Reader reader(image, "f.h5", "s 1");
  EXPECT_EQ(reader.text_attribute("g", "unit"), "Pa");
  EXPECT_EQ(reader.shape("g/v"), (std::vector<std::size_t>{2, 300}));
  EXPECT_EQ(reader.reals("g/v")[301], 301.0 / 7);
  EXPECT_EQ(reader.reals("g/v", 1)[1], 301.0 / 7);
  EXPECT_TRUE(reader.has("g/v"));
  EXPECT_FALSE(reader.has("g/w"));
}

TEST(Hdf5, GivesEqualBytesForEqualContents) { EXPECT_EQ(sample_image(), sample_image()); }

/// A file like sample_image()'s whose numbers are made while it is written.
std::string later_image(std::vector<std::string>& calls) {
  Hdf5Writer writer;
  writer.provenance({"s 1", "t 1", {}});
  std::int64_t sum = 0;
  writer.dataset_later("v", {3, 2, 50}, [&](std::size_t slice, std::span<double> values) {
    calls.push_back("v" + std::to_string(slice));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(slice * 1000 + i) / 7;
    sum += static_cast<std::int64_t>(values.size());
  });
  writer.dataset("before", std::vector<double>{1, 2}, {2});
  writer.dataset_later("sums", 2, [&](std::size_t, std::span<std::int64_t> values) {
    calls.push_back("sums");
    values[0] = values[1] = sum;
  });
  writer.dataset_later("none", 0, [](std::size_t, std::span<std::int64_t>) { ADD_FAILURE(); });
  return writer.image();
}

TEST(Hdf5, MakesSlicesWhileItWrites) {
  std::vector<std::string> calls;
  const std::string image = later_image(calls);
  EXPECT_EQ(calls, (std::vector<std::string>{"v0", "v1", "v2", "sums"}));
  const Hdf5Reader reader(image, "f.h5", "s 1");
  EXPECT_EQ(reader.shape("v"), (std::vector<std::size_t>{3, 2, 50}));
  EXPECT_EQ(reader.reals("v", 2)[99], 2099.0 / 7);
  EXPECT_EQ(reader.reals("before"), (std::vector<double>{1, 2}));
  EXPECT_EQ(reader.integers("sums"), (std::vector<std::int64_t>{300, 300}));
  EXPECT_EQ(later_image(calls), image);
}

TEST(Hdf5, NoticesCorruptionInSlicesMadeLater) {
  std::vector<std::string> calls;
  std::string image = later_image(calls);
  const double marker = 1005.0 / 7;
  const std::size_t place = image.find(std::string_view(reinterpret_cast<const char*>(&marker), sizeof marker));
  ASSERT_NE(place, std::string::npos);
  image[place] = static_cast<char>(image[place] ^ 1);
  const Hdf5Reader reader(image, "f.h5", "s 1");
  EXPECT_EQ(reader.reals("v", 0)[5], 5.0 / 7);
  message_of([&] { reader.reals("v", 1); });
}

TEST(Hdf5, HoldsSeveralFilesOpenAtOnce) {
  const std::string image = sample_image();
  const Hdf5Reader first(image, "f.h5", "s 1");
  const Hdf5Reader second(image, "f.h5", "s 1");
  EXPECT_EQ(first.reals("g/v"), second.reals("g/v"));
  EXPECT_EQ(sample_image(), sample_image());
}

TEST(Hdf5, NamesOtherSchemas) {
  EXPECT_EQ(message_of([] { Hdf5Reader(sample_image(), "f.h5", "s 2"); }), "f.h5: found schema 's 1', expected 's 2'");
  message_of([] { Hdf5Reader("", "f.h5", "s 1"); });
  message_of([] { Hdf5Reader("not HDF5", "f.h5", "s 1"); });
}

TEST(Hdf5, NoticesCorruptionAnywhereInTheNumbers) {
  const std::string whole = sample_image();
  const double marker = 301.0 / 7;
  const std::string_view pattern(reinterpret_cast<const char*>(&marker), sizeof marker);
  const std::size_t place = whole.find(pattern);
  ASSERT_NE(place, std::string::npos);
  for (std::size_t bit = 0; bit < 64; ++bit) {
    std::string damaged = whole;
    damaged[place + bit / 8] = static_cast<char>(damaged[place + bit / 8] ^ (1 << bit % 8));
    message_of([&] { Hdf5Reader(damaged, "f.h5", "s 1").reals("g/v"); });
  }
}

TEST(Hdf5, NoticesATruncatedFile) {
  const std::string whole = sample_image();
  message_of([&] { Hdf5Reader(whole.substr(0, whole.size() / 2), "f.h5", "s 1").reals("g/v"); });
}

}  // namespace
}  // namespace slidezone
