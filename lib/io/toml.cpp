#include "io/toml.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/text.hpp"
#include "io/file.hpp"
#include "io/units.hpp"

namespace slidezone {

struct TomlTable::Node {
  std::shared_ptr<const toml::table> file;
  const toml::table* table;
  std::string file_name;
  std::string table_name;  // "slope", or "" for the file itself
};

static Location location(const std::string& file, const toml::source_region& source) {
  return {file, static_cast<long>(source.begin.line), static_cast<long>(source.begin.column)};
}

/// A number that TOML takes for a real one: "1000.0" for 1e3, which is no whole number to TOML.
static std::string real_text(double value) {
  const std::string text = format_real(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

/// What a value is, for messages: `"5 kPa"`, `5`, `5.0`, `a list`.
static std::string description(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return '"' + *text + '"';
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto real = node.value_exact<double>()) return real_text(*real);
  if (const auto truth = node.value_exact<bool>()) return *truth ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

static std::string description(Range range) {
  const bool has_low = std::isfinite(range.low);
  const bool has_high = std::isfinite(range.high);
  const std::string low = (range.is_low_excluded ? "above " : "at least ") + format_real(range.low);
  const std::string high = (range.is_high_excluded ? "below " : "at most ") + format_real(range.high);
  if (has_low && has_high) return low + " and " + high;
  return has_low ? low : high;
}

/// The range of a quantity in `unit`; angles in degrees.
static std::string description(Range range, const std::string& unit) {
  if (unit != "rad") return description(range) + " " + unit;
  range.low *= 180 / std::numbers::pi;
  range.high *= 180 / std::numbers::pi;
  return description(range) + " deg";
}

static bool contains(Range range, double value) {
  const bool is_above = range.is_low_excluded ? value > range.low : value >= range.low;
  const bool is_below = range.is_high_excluded ? value < range.high : value <= range.high;
  return std::isfinite(value) && is_above && is_below;
}

TomlTable TomlTable::parse(std::string_view text, const std::string& name) {
  refuse_binary(text, name, "TOML");
  try {
    const auto file = std::make_shared<const toml::table>(toml::parse(text, name));
    return TomlTable(std::make_shared<const Node>(Node{file, file.get(), name, ""}));
  } catch (const toml::parse_error& error) {
    fail_at(location(name, error.source()), std::string(error.description()));
  }
}

void TomlTable::check_keys(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : *node_->table) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string place = node_->table_name.empty() ? "in a scene" : "in [" + node_->table_name + "]";
    const std::string hint = nearest_hint(name, known);
    fail_at(location(node_->file_name, key.source()),
            "unknown key '" + name + "' " + place + (hint.empty() ? "; expected " + list_of(known) : hint));
  }
}

bool TomlTable::has(const std::string& key) const { return node_->table->contains(key); }

Location TomlTable::where() const { return location(node_->file_name, node_->table->source()); }

Location TomlTable::where(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  return node == nullptr ? where() : location(node_->file_name, node->source());
}

void TomlTable::fail(const std::string& key, const std::string& message) const { fail_at(where(key), "'" + key + "' " + message); }

void TomlTable::fail(const std::string& key, std::size_t index, const std::string& message) const {
  const toml::node* item = node_->table->get(key)->as_array()->get(index);
  fail_at(location(node_->file_name, item->source()), "'" + key + "' " + message);
}

/// The node of a required key.
static const toml::node& required(const toml::table& table, const TomlTable& view, const std::string& table_name, const std::string& key) {
  const toml::node* node = table.get(key);
  if (node != nullptr) return *node;
  fail_at(view.where(), table_name.empty() ? "no table [" + key + "] in the scene" : "no key '" + key + "' in [" + table_name + "]");
}

TomlTable TomlTable::table(const std::string& key) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const std::string name = node_->table_name.empty() ? key : node_->table_name + "." + key;
  if (!node.is_table()) fail(key, "wants a table, found " + description(node) + "; write [" + name + "]");
  return TomlTable(std::make_shared<const Node>(Node{node_->file, node.as_table(), node_->file_name, name}));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty() || !list->is_homogeneous<toml::table>())
    fail(key, "wants one or several tables, found " + description(node) + "; write [[" + key + "]]");
  std::vector<TomlTable> tables;
  for (const toml::node& item : *list)
    tables.push_back(TomlTable(std::make_shared<const Node>(Node{node_->file, item.as_table(), node_->file_name, key})));
  return tables;
}

/// The value of a quantity; `key` and `where` are for messages.
static double quantity_of(const toml::node& node, const Location& where, const std::string& key, const std::string& unit, Range range) {
  const auto text = node.value_exact<std::string>();
  if (!text)
    fail_at(where,
            "'" + key + "' wants a text with its unit, found " + description(node) + "; write e.g. \"" + quantity_example(unit) + '"');
  double value = 0;
  try {
    value = parse_quantity(*text, unit);
  } catch (const std::invalid_argument& error) {
    fail_at(where, "'" + key + "' " + error.what());
  }
  if (!contains(range, value)) fail_at(where, "'" + key + "' wants " + description(range, unit) + ", found \"" + *text + '"');
  return value;
}

double TomlTable::quantity(const std::string& key, const std::string& unit, Range range) const {
  return quantity_of(required(*node_->table, *this, node_->table_name, key), where(key), key, unit, range);
}

/// The two items of a list of two; fails for other lists and values.
static const toml::array& pair_of(const toml::node& node, const Location& where, const std::string& key, const std::string& expected) {
  const toml::array* pair = node.as_array();
  if (pair != nullptr && pair->size() == 2) return *pair;
  const std::string found = pair == nullptr ? description(node) : "a list of " + std::to_string(pair->size());
  fail_at(where, "'" + key + "' wants " + expected + ", found " + found);
}

Vec2 TomlTable::quantity_pair(const std::string& key, const std::string& unit, Range range) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  if (!is_list(key)) {
    const double both = quantity(key, unit, range);
    return {both, both};
  }
  const std::string example = '"' + quantity_example(unit) + '"';
  const toml::array& pair = pair_of(node, where(key), key, example + " or [" + example + ", " + example + "] (x, y)");
  const auto item = [&](std::size_t i) {
    return quantity_of(*pair.get(i), location(node_->file_name, pair.get(i)->source()), key, unit, range);
  };
  return {item(0), item(1)};
}

std::vector<double> TomlTable::quantities(const std::string& key, const std::string& unit, Range range, std::size_t least) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() < least)
    fail(key, "wants a list of at least " + std::to_string(least) + " like [\"" + quantity_example(unit) + "\", ...], found " +
                  (list == nullptr ? description(node) : std::to_string(list->size())));
  std::vector<double> values;
  for (const toml::node& item : *list) values.push_back(quantity_of(item, location(node_->file_name, item.source()), key, unit, range));
  return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key, std::size_t least) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() < least)
    fail(key, "wants a list of at least " + std::to_string(least) + " texts, found " +
                  (list == nullptr ? description(node) : std::to_string(list->size())));
  std::vector<std::string> texts;
  for (const toml::node& item : *list) {
    const auto text = item.value_exact<std::string>();
    if (!text) fail(key, texts.size(), "wants a text in quotes, found " + description(item));
    texts.push_back(*text);
  }
  return texts;
}

/// The value of a number without unit; `key` and `where` are for messages.
static double number_of(const toml::node& node, const Location& where, const std::string& key, Range range) {
  const auto complain = [&](const std::string& message) {
    fail_at(where, "'" + key + "' wants " + message + ", found " + description(node));
  };
  if (!node.is_number()) complain("a number without unit");
  const double value = *node.value<double>();
  if (!std::isfinite(value)) complain("a finite number");
  if (!contains(range, value)) complain("a number " + description(range));
  return value;
}

double TomlTable::number(const std::string& key, Range range) const {
  return number_of(required(*node_->table, *this, node_->table_name, key), where(key), key, range);
}

std::vector<std::vector<double>> TomlTable::matrix(const std::string& key, Range range, std::size_t least) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const toml::array* rows = node.as_array();
  if (rows == nullptr || rows->size() < least)
    fail(key, "wants a matrix of at least " + std::to_string(least) + " rows like [[1, 0.5], [0.5, 1]], found " +
                  (rows == nullptr ? description(node) : std::to_string(rows->size())));
  std::vector<std::vector<double>> matrix;
  for (const toml::node& row : *rows) {
    const toml::array* numbers = row.as_array();
    if (numbers == nullptr || numbers->size() != rows->size())
      fail(key, matrix.size(),
           "wants rows of " + std::to_string(rows->size()) + " numbers, found " +
               (numbers == nullptr ? description(row) : std::to_string(numbers->size())));
    matrix.emplace_back();
    for (const toml::node& number : *numbers)
      matrix.back().push_back(number_of(number, location(node_->file_name, number.source()), key, range));
  }
  return matrix;
}

std::uint64_t TomlTable::whole(const std::string& key, std::uint64_t least, std::uint64_t most) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const auto value = node.value_exact<std::int64_t>();
  if (!value || *value < 0 || static_cast<std::uint64_t>(*value) < least || static_cast<std::uint64_t>(*value) > most)
    fail(key, "wants a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", found " + description(node));
  return static_cast<std::uint64_t>(*value);
}

std::string TomlTable::text(const std::string& key) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const auto value = node.value_exact<std::string>();
  if (!value) fail(key, "wants a text in quotes, found " + description(node));
  return *value;
}

std::string TomlTable::choice(const std::string& key, const std::vector<std::string>& names) const {
  const std::string value = text(key);
  if (std::find(names.begin(), names.end(), value) != names.end()) return value;
  fail(key, "wants " + list_of(names) + ", found \"" + value + '"' + nearest_hint(value, names));
}

std::vector<Vec2> TomlTable::polyline(const std::string& key, std::size_t least) const {
  const toml::node& node = required(*node_->table, *this, node_->table_name, key);
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() < least)
    fail(key, "wants a list of at least " + std::to_string(least) + " points, e.g. [[\"0 m\", \"5 m\"], ...], found " +
                  (list == nullptr ? description(node) : std::to_string(list->size())));
  std::vector<Vec2> points;
  for (const toml::node& item : *list) {
    const toml::array& pair =
        pair_of(item, location(node_->file_name, item.source()), key, "points of two coordinates like [\"0 m\", \"5 m\"]");
    const auto coordinate = [&](std::size_t i) {
      return quantity_of(*pair.get(i), location(node_->file_name, pair.get(i)->source()), key, "m", any_number);
    };
    points.push_back({coordinate(0), coordinate(1)});
  }
  return points;
}

double TomlTable::quantity_or(const std::string& key, const std::string& unit, Range range, double absent) const {
  return has(key) ? quantity(key, unit, range) : absent;
}

double TomlTable::number_or(const std::string& key, Range range, double absent) const { return has(key) ? number(key, range) : absent; }

std::uint64_t TomlTable::whole_or(const std::string& key, std::uint64_t least, std::uint64_t most, std::uint64_t absent) const {
  return has(key) ? whole(key, least, most) : absent;
}

std::string TomlTable::choice_or(const std::string& key, const std::vector<std::string>& names, const std::string& absent) const {
  return has(key) ? choice(key, names) : absent;
}

bool TomlTable::is_list(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  return node != nullptr && node->is_array();
}

}  // namespace slidezone
