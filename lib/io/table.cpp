#include "io/table.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/text.hpp"
#include "io/file.hpp"

namespace slidezone {

static std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.emplace_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

static std::string join(std::span<const std::string> fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : "\t") + field;
  return line;
}

void Table::add_row(std::vector<std::string> fields, Location where) {
  assert(fields.size() == columns_.size());
  rows_.push_back({std::move(fields), std::move(where)});
}

std::optional<std::size_t> Table::index_of(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string& Table::text(std::size_t row, std::string_view column) const {
  const auto index = index_of(column);
  assert(index);
  return rows_[row].fields[*index];
}

[[noreturn]] static void fail_field(const Table& table, std::size_t row, std::string_view column, const std::string& expected) {
  fail_at(table.where(row), "column '" + std::string(column) + "': found '" + table.text(row, column) + "', expected " + expected);
}

double Table::number(std::size_t row, std::string_view column) const {
  const auto value = parse_real(text(row, column));
  if (!value) fail_field(*this, row, column, "a finite number");
  return *value;
}

double Table::number_or_nan(std::size_t row, std::string_view column) const {
  if (text(row, column) == "nan") return std::numeric_limits<double>::quiet_NaN();
  const auto value = parse_real(text(row, column));
  if (!value) fail_field(*this, row, column, "a finite number or nan");
  return *value;
}

std::uint64_t Table::whole(std::size_t row, std::string_view column) const {
  const auto value = parse_whole(text(row, column));
  if (!value) fail_field(*this, row, column, "a whole number");
  return *value;
}

std::string to_tsv(const Table& table, const Provenance& provenance) {
  std::string bytes = "# schema: " + provenance.schema + "\n# tool: " + provenance.tool + "\n";
  for (const auto& [key, value] : provenance.details) bytes += "# " + key + ": " + value + "\n";
  bytes += join(table.columns()) + "\n";
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    std::vector<std::string> fields;
    for (const std::string& column : table.columns()) fields.push_back(table.text(row, column));
    bytes += join(fields) + "\n";
  }
  return bytes;
}

static void check_schema(std::string_view line, std::string_view schema, const Location& where) {
  constexpr std::string_view key = "# schema: ";
  if (!line.starts_with(key) || line.substr(key.size()) == schema) return;
  fail_at(where, "found schema '" + std::string(line.substr(key.size())) + "', expected '" + std::string(schema) + "'");
}

/// What may be wrong with a header that lacks a column.
static std::string hint_on(const std::string& name, const std::vector<std::string>& columns) {
  if (columns.size() == 1 && columns.front().find_first_of(",; ") != std::string::npos) return "; columns are parted by tabs";
  return nearest_hint(name, columns);
}

static void check_header(const std::vector<std::string>& columns, std::span<const std::string> required, const Location& where) {
  for (const std::string& name : required) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end())
      fail_at(where, "no column '" + name + "' in the header row" + hint_on(name, columns));
  }
  for (auto it = columns.begin(); it != columns.end(); ++it) {
    if (std::find(columns.begin(), it, *it) != it) fail_at(where, "column '" + *it + "' stands twice in the header row");
  }
}

Table parse_tsv(std::string_view bytes, const std::string& name, std::string_view schema, std::span<const std::string> required) {
  refuse_binary(bytes, name, "a table of text");
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  std::optional<Table> table;
  Location where{name, 0, 0};
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++where.line;
    check_schema(line, schema, where);
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> fields = split(line, '\t');
    if (!table) {
      check_header(fields, required, where);
      table.emplace(std::move(fields), where);
    } else if (fields == table->columns()) {
      continue;
    } else if (fields.size() != table->columns().size()) {
      fail_at(where, "found " + std::to_string(fields.size()) + " fields, expected " + std::to_string(table->columns().size()) +
                         " separated by tabs");
    } else {
      table->add_row(std::move(fields), where);
    }
  }
  if (!table) fail_at({name, 0, 0}, "found no table, expected a header row with columns " + join(required));
  return *std::move(table);
}

}  // namespace slidezone
