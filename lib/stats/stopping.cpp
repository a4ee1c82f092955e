#include "stats/stopping.hpp"

#include <cmath>

#include "core/text.hpp"
#include "stats/moments.hpp"

namespace slidezone {

/// The number after `prefix`, if the text is prefix and number.
static std::optional<double> argument_after(std::string_view text, std::string_view prefix) {
  return text.starts_with(prefix) ? parse_real(text.substr(prefix.size())) : std::nullopt;
}

/// Kind and argument from "mean", "sd", "quantile_P" or "exceeds_X".
static bool read_target(StopRule& rule, std::string_view target) {
  if (target == "mean" || target == "sd") {
    rule.kind = target == "mean" ? StopRule::Kind::mean : StopRule::Kind::sd;
    return true;
  }
  if (const auto p = argument_after(target, "quantile_")) {
    rule.kind = StopRule::Kind::quantile;
    rule.argument = *p;
    return *p > 0 && *p < 1;
  }
  if (const auto x = argument_after(target, "exceeds_")) {
    rule.kind = StopRule::Kind::exceedance;
    rule.argument = *x;
    return *x >= 0;
  }
  return false;
}

std::optional<StopRule> parse_stop_rule(std::string_view text) {
  StopRule rule;
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    rule.quantity = text.substr(0, colon);
    if (rule.quantity != "influence_m" && rule.quantity != "runout_m") return std::nullopt;
    text.remove_prefix(colon + 1);
  }
  if (text == "paper") return rule;
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || !read_target(rule, text.substr(0, equals))) return std::nullopt;
  const auto width = parse_real(text.substr(equals + 1));
  if (!width || *width <= 0) return std::nullopt;
  rule.half_width = *width;
  return rule;
}

std::string to_string(const StopRule& rule) {
  const std::string width = "=" + format_real(rule.half_width);
  switch (rule.kind) {
    case StopRule::Kind::paper:
      return "paper";
    case StopRule::Kind::mean:
      return "mean" + width;
    case StopRule::Kind::sd:
      return "sd" + width;
    case StopRule::Kind::quantile:
      return "quantile_" + format_real(rule.argument) + width;
    case StopRule::Kind::exceedance:
      return "exceeds_" + format_real(rule.argument) + width;
  }
  return "";
}

Interval target_interval(const StopRule& rule, const Sample& sample) {
  switch (rule.kind) {
    case StopRule::Kind::paper:
      return {};
    case StopRule::Kind::mean:
      return mean_estimate(sample).interval;
    case StopRule::Kind::sd:
      return root(guarded_variance_estimate(sample)).interval;
    case StopRule::Kind::quantile:
      return quantile_estimate(sample, rule.argument).interval;
    case StopRule::Kind::exceedance:
      return exceedance_estimate(sample, rule.argument).interval;
  }
  return {};
}

double half_width(const StopRule& rule, const Sample& sample) {
  const Interval interval = target_interval(rule, sample);
  const double width = interval.high - interval.low;
  return std::isnan(width) ? std::numeric_limits<double>::infinity() : width / 2;
}

std::size_t next_look(std::size_t runs, std::size_t least_runs) { return runs < least_runs ? least_runs : runs + (runs + 4) / 5; }

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
