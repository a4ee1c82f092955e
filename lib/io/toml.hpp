// Tables of a TOML file, read strictly: unknown and missing keys, wrong types, wrong dimensions and numbers out of range
// are errors with file:line:column, what was found and what was expected.
//
// Range of a number: inclusive bounds unless excluded. Every number is finite.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/vec2.hpp"

namespace slidezone {

/// Accepted values: low <= value <= high, or low < value where `is_low_excluded`, value < high where `is_high_excluded`.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_low_excluded = false;
  bool is_high_excluded = false;
};

inline constexpr Range any_number{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false};

class TomlTable {
 public:
  /// Parses a whole file; `name` is its name in messages.
  static TomlTable parse(std::string_view text, const std::string& name);

  /// Throws for the first key of this table that is not in `known`, with the nearest known key.
  void check_keys(const std::vector<std::string>& known) const;

  bool has(const std::string& key) const;

  /// The sub-table; required. Where it may be absent, ask has() first.
  TomlTable table(const std::string& key) const;

  /// The tables of [[key]], in order; at least one.
  std::vector<TomlTable> tables(const std::string& key) const;

  /// Values of a required key. A quantity is a string with its unit ("5 m"), returned in SI `unit`.
  double quantity(const std::string& key, const std::string& unit, Range range) const;
  double number(const std::string& key, Range range) const;
  std::uint64_t whole(const std::string& key, std::uint64_t least, std::uint64_t most) const;
  std::string text(const std::string& key) const;
  std::string choice(const std::string& key, const std::vector<std::string>& names) const;
  /// One quantity for both axes, "0.2 m", or one for each, ["0.2 m", "0.1 m"] (x, y).
  Vec2 quantity_pair(const std::string& key, const std::string& unit, Range range) const;
  /// A list of quantities; at least `least` of them.
  std::vector<double> quantities(const std::string& key, const std::string& unit, Range range, std::size_t least) const;
  /// A list of texts; at least `least` of them.
  std::vector<std::string> texts(const std::string& key, std::size_t least) const;
  /// [[1, 0.5], [0.5, 1]]: a square matrix, row by row, of at least `least` rows.
  std::vector<std::vector<double>> matrix(const std::string& key, Range range, std::size_t least) const;
  /// [["0 m", "5 m"], ...] as points in metres; at least `least` of them.
  std::vector<Vec2> polyline(const std::string& key, std::size_t least) const;

  /// The same with a default for an absent key.
  double quantity_or(const std::string& key, const std::string& unit, Range range, double absent) const;
  double number_or(const std::string& key, Range range, double absent) const;
  std::uint64_t whole_or(const std::string& key, std::uint64_t least, std::uint64_t most, std::uint64_t absent) const;
  std::string choice_or(const std::string& key, const std::vector<std::string>& names, const std::string& absent) const;

  /// Whether the key is there and its value a list.
  bool is_list(const std::string& key) const;

  /// Place of the key's value, or of the table where the key is absent.
  Location where(const std::string& key) const;
  Location where() const;

  /// Throws at the key's value: "<place>: '<key>' <message>".
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;
  /// The same at item `index` of the key's list.
  [[noreturn]] void fail(const std::string& key, std::size_t index, const std::string& message) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;  // keeps the parsed file alive and points into it
};

}  // namespace slidezone
