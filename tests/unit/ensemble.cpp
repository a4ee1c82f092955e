#include "ensemble/ensemble.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace slidezone {
namespace {

Row row(std::uint64_t realization, Status status, double influence, double runout) {
  Row made;
  made.realization = realization;
  made.status = status;
  made.influence = influence;
  made.runout = runout;
  return made;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const std::vector<Row> one_of_each = {row(0, Status::slid, 9, 18), row(1, Status::slid, 10, 20), row(2, Status::stable, 0, 0.1),
                                      row(3, Status::left_domain, 12, 30), row(4, Status::diverged, nan, nan)};

TEST(Ensemble, KeepsEveryRandomRunAndTheDeterministicOneApart) {
  const Ensemble ensemble = ensemble_of(one_of_each);
  ASSERT_EQ(ensemble.runout.sample.size(), 4u);
  EXPECT_EQ(ensemble.runout.sample[1].value, 0.1);
  EXPECT_EQ(ensemble.runout.sample[1].knowledge, Knowledge::exact);
  EXPECT_EQ(ensemble.runout.sample[2].knowledge, Knowledge::at_least);
  EXPECT_EQ(ensemble.runout.sample[3].knowledge, Knowledge::unknown);
  EXPECT_EQ(known_values(ensemble.influence.slides), std::vector<double>{10});
  EXPECT_EQ(ensemble.influence.deterministic, 9);
  EXPECT_EQ(count_of(one_of_each, Status::slid), 1u);
}

TEST(Ensemble, CountsFailuresAmongTheRunsThatTell) {
  const Estimate failure = failure_probability(ensemble_of(one_of_each));
  EXPECT_DOUBLE_EQ(failure.value, 2.0 / 3);
  EXPECT_DOUBLE_EQ(failure.interval.low, clopper_pearson(2, 4).low);
  EXPECT_DOUBLE_EQ(failure.interval.high, clopper_pearson(3, 4).high);
}

TEST(Ensemble, CautionsOnlyWhereThereIsDoubt) {
  EXPECT_EQ(cautions(one_of_each).size(), 2u);
  EXPECT_TRUE(cautions(std::vector<Row>{row(0, Status::diverged, 0, 0), row(1, Status::stable, 0, 0), row(2, Status::slid, 1, 1)}).empty());
}

TEST(Ensemble, KnowsTheBlocksOfItsRuns) {
  std::vector<Row> rows = {row(0, Status::slid, 9, 18)};
  for (std::uint64_t k = 1; k <= 39; ++k) {
    rows.push_back(row(k, Status::slid, 10 + static_cast<double>(k), 20 + static_cast<double>(k)));
    rows.back().design = Design::antithetic;
    rows.back().block = (k + 1) / 2;
  }
  EXPECT_EQ(block_count(rows).blocks, 20u);
  EXPECT_EQ(block_count(rows).size, 2u);
  EXPECT_EQ(block_count(rows).incomplete, 1u);
  EXPECT_EQ(cautions(rows).size(), 1u);
  const Ensemble ensemble = ensemble_of(rows);
  EXPECT_EQ(known_blocks(ensemble.runout.sample).size(), 20u);
  EXPECT_EQ(known_blocks(ensemble.influence.slides).size(), 20u);
  for (Row& plain : rows) {
    plain.design = Design::plain;
    plain.block = plain.realization;
  }
  EXPECT_EQ(block_count(rows).size, 1u);
  EXPECT_FALSE(has_blocks(ensemble_of(rows).failure));
}

TEST(Ensemble, CautionsAgainstAReachWithoutSpread) {
  std::vector<Row> rows = {row(1, Status::stable, 0, 0.1), row(2, Status::stable, 0, 0.2)};
  EXPECT_EQ(cautions(rows),
            std::vector<std::string>{"influence_m is 0 in all 2 runs: they tell nothing of its spread, and its mean has no interval"});
  rows.pop_back();
  EXPECT_TRUE(cautions(rows).empty());
}

}  // namespace
}  // namespace slidezone
