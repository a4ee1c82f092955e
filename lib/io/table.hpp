// Text tables: tab-separated values with a header row, units in the column names, '#' lines for provenance.
//
// Reading takes several concatenated tables of the same columns (`cat rows/*.tsv`): repeated headers and '#' lines are
// skipped. Every field keeps its line, so that errors can name it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/provenance.hpp"

namespace slidezone {

class Table {
 public:
  /// `header` is the place of the header row in a file, for messages.
  explicit Table(std::vector<std::string> columns, Location header = {}) : columns_(std::move(columns)), header_(std::move(header)) {}

  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t row_count() const { return rows_.size(); }

  /// Appends a row; it must have one field per column. `where` is its place in a file, for messages.
  void add_row(std::vector<std::string> fields, Location where = {});

  bool has_column(std::string_view name) const { return index_of(name).has_value(); }

  /// The field as text, as a finite number, as a number that may be "nan", as a non-negative whole number.
  /// Throws with file, line, column name and what was found.
  const std::string& text(std::size_t row, std::string_view column) const;
  double number(std::size_t row, std::string_view column) const;
  double number_or_nan(std::size_t row, std::string_view column) const;
  std::uint64_t whole(std::size_t row, std::string_view column) const;

  /// Where the header row and a row stand.
  const Location& header() const { return header_; }
  const Location& where(std::size_t row) const { return rows_[row].where; }

 private:
  struct Row {
    std::vector<std::string> fields;
    Location where;
  };
  std::optional<std::size_t> index_of(std::string_view column) const;

  std::vector<std::string> columns_;
  Location header_;
  std::vector<Row> rows_;
};

/// The table as bytes: provenance as "# key: value" lines, the header row, the rows.
std::string to_tsv(const Table& table, const Provenance& provenance);

/// Parses one table or several concatenated ones. `name` is the file's name in messages; `schema` is what a "# schema:"
/// line must say where there is one; `required` columns must be present (others may be, and all headers must be equal).
/// An empty text is an error, a header without rows is not. Line ends of Windows and its byte-order mark are passed over.
Table parse_tsv(std::string_view bytes, const std::string& name, std::string_view schema, std::span<const std::string> required);

}  // namespace slidezone
