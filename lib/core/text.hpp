// Numbers as text, both ways: strict when read, shortest exact form when written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slidezone {

/// The whole text as a finite decimal number; nothing for "nan", "inf", "1e999", hexadecimal, blanks or trailing text.
std::optional<double> parse_real(std::string_view text);

/// The whole text as a non-negative decimal integer; nothing for a sign, a leading zero ("010") or overflow.
std::optional<std::uint64_t> parse_whole(std::string_view text);

/// The shortest text that reads back as the same number: "0.1", "2.5e-07", "nan".
std::string format_real(double value);

/// The same, but "unbounded" for an infinite end of an interval.
std::string format_limit(double value);

/// `significant` digits at most, for messages: format_brief(9.30000001, 3) is "9.3".
std::string format_brief(double value, int significant = 4);

}  // namespace slidezone
