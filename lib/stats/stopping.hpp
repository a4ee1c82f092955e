// Stopping rules: whether a series of realizations is long enough.
//
// - `paper`: the source paper's rule. Adding one realization changes the running mean by less than 1e-3 m and the running variance
//   by less than 1e-3 m2. What is wrong with it: a change of the mean is (x - m) / n and one of the variance about s^2 / n, so the
//   rule asks for n of some 1e3 s^2 whatever is wanted of the answer (with a variance of 2.24 m2 not before n = 1078), it can be met
//   by one value near the mean, and it says nothing of the error. Given because the paper used it.
// - `mean=W`: the 95 % interval of the mean is at most W m to either side (for a sample without censored values).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace slidezone {

struct StopRule {
  enum class Kind { paper, mean };
  Kind kind = Kind::paper;
  double half_width = 0;  // m, of `mean`
};

inline constexpr double paper_tolerance = 1e-3;  // m of the mean, m2 of the variance

/// "paper" or "mean=0.2"; nothing for another text.
std::optional<StopRule> parse_stop_rule(std::string_view text);

/// The rule as parse_stop_rule() reads it.
std::string to_string(const StopRule& rule);

/// The paper's rule over a series.
struct PaperVerdict {
  double change_of_mean = 0;             // by the last value; nan for fewer than 3 values
  double change_of_variance = 0;         // likewise
  bool is_met = false;                   // by the last value
  std::optional<std::size_t> first_met;  // number of values after which it was met for the first time
};
PaperVerdict paper_verdict(std::span<const double> values);

}  // namespace slidezone
