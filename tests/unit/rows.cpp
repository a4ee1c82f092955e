#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "rows/row.hpp"

namespace slidezone {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const std::string columns =
    "realization\tstatus\tinfluence_m\trunout_m\tinfluence_1m_m\trunout_max_m\tdisplaced_area_m2\trest_time_s\tsteps\tenergy_"
    "error\tfloored";
const std::string header = columns + "\n";  // as once written, without design and block

std::string message_of(const std::string& bytes) {
  try {
    parse_rows(bytes, "rows.tsv");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::data);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

Row sample_row(std::uint64_t realization) {
  return {.realization = realization,
          .status = Status::slid,
          .influence = 9.5,
          .runout = 18.25,
          .influence_1m = 9,
          .runout_max = 20.1,
          .displaced_area = 33.3,
          .rest_time = nan,
          .steps = 20000,
          .energy_error = -0.001,
          .floored = 2,
          .design = Design::antithetic,
          .block = 4};
}

TEST(Rows, ReadBackWhatWasWritten) {
  const std::string bytes = to_tsv(sample_row(7), provenance("slidezone-row 1", "mpmrun"));
  EXPECT_NE(bytes.find(columns + "\tdesign\tblock\n7\tslid\t9.5\t18.25\t9\t20.1\t33.3\tnan\t20000\t-0.001\t2\tantithetic\t4\n"),
            std::string::npos)
      << bytes;
  const std::vector<Row> rows = parse_rows(bytes, "rows.tsv");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].realization, 7u);
  EXPECT_EQ(rows[0].runout, 18.25);
  EXPECT_TRUE(std::isnan(rows[0].rest_time));
  EXPECT_EQ(to_tsv(rows[0], provenance("slidezone-row 1", "mpmrun")), bytes);
}

TEST(Rows, ComeByRealizationWhateverTheOrderOfTheTables) {
  const auto bytes = [](std::uint64_t k) { return to_tsv(sample_row(k), provenance("slidezone-row 1", "mpmrun")); };
  const std::vector<Row> rows = parse_rows(bytes(3) + bytes(1) + bytes(2), "rows.tsv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].realization, 1u);
  EXPECT_EQ(rows[2].realization, 3u);
  EXPECT_EQ(checksum(rows), checksum(parse_rows(bytes(2) + bytes(3) + bytes(1), "rows.tsv")));
  EXPECT_NE(checksum(rows), checksum(parse_rows(bytes(2) + bytes(3) + bytes(4), "rows.tsv")));
}

TEST(Rows, ADivergedRunNeedsNoReach) {
  const std::vector<Row> rows = parse_rows(header + "1\tdiverged\tnan\tnan\tnan\tnan\tnan\tnan\t5\tnan\t0\n", "rows.tsv");
  EXPECT_EQ(rows[0].status, Status::diverged);
  EXPECT_EQ(message_of(header + "1\tslid\tnan\t1\t1\t1\t1\t1\t5\t0\t0\n"),
            "rows.tsv:2: column 'influence_m': found 'nan', expected a finite number");
}

TEST(Rows, NameUnknownColumnsAndStatus) {
  EXPECT_EQ(message_of("# schema: slidezone-row 1\n" + header.substr(0, header.size() - 1) + "\tflored\n"),
            "rows.tsv:2: unknown column 'flored'; did you mean 'floored'?");
  EXPECT_EQ(message_of(header + "1\tstabel\t0\t0\t0\t0\t0\t0\t5\t0\t0\n"),
            "rows.tsv:2: column 'status': found 'stabel', expected slid, stable, left_domain or diverged; did you mean 'stable'?");
}

TEST(Rows, RefuseARealizationThatStandsTwice) {
  const std::string row = "1\tslid\t1\t1\t1\t1\t1\t1\t5\t0\t0\n";
  const std::string other = "1\tslid\t2\t1\t1\t1\t1\t1\t5\t0\t0\n";
  EXPECT_EQ(message_of(header + row + other),
            "rows.tsv:3: realization 1 stands twice with different values, first at rows.tsv:2; give each realization once");
  EXPECT_EQ(message_of(header + row + row), "rows.tsv:3: realization 1 stands twice, first at rows.tsv:2; give each realization once");
}

TEST(Rows, WithoutADesignArePlain) {
  const std::vector<Row> rows = parse_rows(header + "7\tslid\t1\t1\t1\t1\t1\t1\t5\t0\t0\n", "rows.tsv");
  EXPECT_EQ(rows[0].design, Design::plain);
  EXPECT_EQ(rows[0].block, 7u);
}

TEST(Rows, RefuseTwoDesignsButForRealization0) {
  const std::string both = columns + "\tdesign\tblock\n";
  const std::string row = "\tslid\t1\t1\t1\t1\t1\t1\t5\t0\t0\t";
  EXPECT_EQ(parse_rows(both + "0" + row + "plain\t0\n1" + row + "Latin hypercube\t1\n", "rows.tsv").size(), 2u);
  EXPECT_EQ(message_of(both + "1" + row + "antithetic\t1\n2" + row + "antithetic\t1\n3" + row + "plain\t3\n"),
            "rows.tsv:4: realization 3 is of the design 'plain', realization 1 at rows.tsv:2 of 'antithetic'; statistics want one design");
  EXPECT_EQ(message_of(both + "1" + row + "antithetical\t1\n"),
            "rows.tsv:2: column 'design': found 'antithetical', expected plain, antithetic or Latin hypercube; did you mean 'antithetic'?");
  EXPECT_EQ(message_of(columns + "\tdesign\n1" + row + "\n"),
            "rows.tsv:1: found one of the columns design and block, expected both or neither");
}

TEST(Rows, RefuseOtherSchemas) {
  EXPECT_EQ(message_of("# schema: slidezone-curve 1\n" + header),
            "rows.tsv:1: found schema 'slidezone-curve 1', expected 'slidezone-row 1'");
}

}  // namespace
}  // namespace slidezone
