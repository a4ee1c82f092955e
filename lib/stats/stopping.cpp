#include "stats/stopping.hpp"

#include <cmath>

#include "core/text.hpp"
#include "stats/moments.hpp"

namespace slidezone {

std::optional<StopRule> parse_stop_rule(std::string_view text) {
  if (text == "paper") return StopRule{StopRule::Kind::paper, 0};
  constexpr std::string_view mean = "mean=";
  if (!text.starts_with(mean)) return std::nullopt;
  const auto half_width = parse_real(text.substr(mean.size()));
  if (!half_width || *half_width <= 0) return std::nullopt;
  return StopRule{StopRule::Kind::mean, *half_width};
}

std::string to_string(const StopRule& rule) {
  return rule.kind == StopRule::Kind::paper ? "paper" : "mean=" + format_real(rule.half_width);
}

PaperVerdict paper_verdict(std::span<const double> values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PaperVerdict verdict{nan, nan, false, std::nullopt};
  Moments moments;
  for (const double value : values) {
    const double mean = moments.mean();
    const double variance = moments.variance();
    moments.add(value);
    verdict.change_of_mean = std::abs(moments.mean() - mean);
    verdict.change_of_variance = std::abs(moments.variance() - variance);
    verdict.is_met = verdict.change_of_mean < paper_tolerance && verdict.change_of_variance < paper_tolerance;
    if (verdict.is_met && !verdict.first_met) verdict.first_met = moments.count();
  }
  return verdict;
}

}  // namespace slidezone
