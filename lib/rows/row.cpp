#include "rows/row.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/file.hpp"
#include "io/table.hpp"

namespace slidezone {

static const std::vector<std::string> row_columns = {
    "realization", "status", "influence_m",  "runout_m", "influence_1m_m", "runout_max_m", "displaced_area_m2",
    "rest_time_s", "steps",  "energy_error", "floored",  "design",         "block"};
static constexpr std::size_t required_columns = 11;  // older tables end here

static const std::array<std::string, 4> status_names = {"slid", "stable", "left_domain", "diverged"};

std::string to_string(Status status) { return status_names[static_cast<std::size_t>(status)]; }

static std::vector<std::string> fields_of(const Row& row) {
  return {std::to_string(row.realization), to_string(row.status),         format_real(row.influence),      format_real(row.runout),
          format_real(row.influence_1m),   format_real(row.runout_max),   format_real(row.displaced_area), format_real(row.rest_time),
          std::to_string(row.steps),       format_real(row.energy_error), std::to_string(row.floored),     to_string(row.design),
          std::to_string(row.block)};
}

static Table table_of(std::span<const Row> rows) {
  Table table(row_columns);
  for (const Row& row : rows) table.add_row(fields_of(row));
  return table;
}

std::string to_tsv(const Row& row, const Provenance& provenance) { return to_tsv(table_of(std::span(&row, 1)), provenance); }

std::string checksum(std::span<const Row> rows) { return checksum(to_tsv(table_of(rows), Provenance{std::string(row_schema), "", {}})); }

namespace {

struct PlacedRow {
  Row row;
  Location where;
};

}  // namespace

static void check_columns(const Table& table) {
  for (const std::string& name : table.columns()) {
    if (std::find(row_columns.begin(), row_columns.end(), name) == row_columns.end())
      fail_at(table.header(), "unknown column '" + name + "'" + nearest_hint(name, row_columns));
  }
  if (table.has_column("design") != table.has_column("block"))
    fail_at(table.header(), "found one of the columns design and block, expected both or neither");
}

static Status status_of(const Table& table, std::size_t index) {
  const std::string& name = table.text(index, "status");
  const auto found = std::find(status_names.begin(), status_names.end(), name);
  if (found == status_names.end())
    fail_at(table.where(index),
            "column 'status': found '" + name + "', expected " + list_of(status_names) + nearest_hint(name, status_names));
  return static_cast<Status>(found - status_names.begin());
}

static Design design_of(const Table& table, std::size_t index) {
  const std::string& name = table.text(index, "design");
  const std::optional<Design> design = design_named(name);
  if (!design)
    fail_at(table.where(index),
            "column 'design': found '" + name + "', expected " + list_of(design_names()) + nearest_hint(name, design_names()));
  return *design;
}

/// The reach of a run exists unless it diverged.
static double reach_of(const Table& table, std::size_t index, std::string_view column, Status status) {
  return status == Status::diverged ? table.number_or_nan(index, column) : table.number(index, column);
}

static Row row_of(const Table& table, std::size_t index) {
  Row row;
  row.realization = table.whole(index, "realization");
  row.status = status_of(table, index);
  row.influence = reach_of(table, index, "influence_m", row.status);
  row.runout = reach_of(table, index, "runout_m", row.status);
  row.influence_1m = table.number_or_nan(index, "influence_1m_m");
  row.runout_max = table.number_or_nan(index, "runout_max_m");
  row.displaced_area = table.number_or_nan(index, "displaced_area_m2");
  row.rest_time = table.number_or_nan(index, "rest_time_s");
  row.steps = table.whole(index, "steps");
  row.energy_error = table.number_or_nan(index, "energy_error");
  row.floored = table.whole(index, "floored");
  row.design = table.has_column("design") ? design_of(table, index) : Design::plain;
  row.block = table.has_column("block") ? table.whole(index, "block") : row.realization;
  return row;
}

static void append_rows(std::vector<PlacedRow>& rows, std::string_view bytes, const std::string& name) {
  const Table table = parse_tsv(bytes, name, row_schema, std::span(row_columns).first(required_columns));
  check_columns(table);
  for (std::size_t i = 0; i < table.row_count(); ++i) rows.push_back({row_of(table, i), table.where(i)});
}

static bool is_random(const PlacedRow& placed) { return placed.row.realization > 0; }

/// Realization 0 is of no design: it is not drawn.
static void check_designs(std::span<const PlacedRow> rows) {
  const auto first = std::find_if(rows.begin(), rows.end(), is_random);
  const auto other =
      std::find_if(first, rows.end(), [&](const PlacedRow& placed) { return is_random(placed) && placed.row.design != first->row.design; });
  if (other != rows.end())
    fail_at(other->where, "realization " + std::to_string(other->row.realization) + " is of the design '" + to_string(other->row.design) +
                              "', realization " + std::to_string(first->row.realization) + " at " + to_string(first->where) + " of '" +
                              to_string(first->row.design) + "'; statistics want one design");
}

/// By realization; throws where a realization stands twice.
static std::vector<Row> sorted(std::vector<PlacedRow> placed) {
  check_designs(placed);
  std::stable_sort(placed.begin(), placed.end(),
                   [](const PlacedRow& a, const PlacedRow& b) { return a.row.realization < b.row.realization; });
  std::vector<Row> rows;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (i > 0 && placed[i].row.realization == placed[i - 1].row.realization) {
      const bool is_equal = fields_of(placed[i].row) == fields_of(placed[i - 1].row);
      fail_at(placed[i].where, "realization " + std::to_string(placed[i].row.realization) + " stands twice" +
                                   (is_equal ? "" : " with different values") + ", first at " + to_string(placed[i - 1].where) +
                                   "; give each realization once");
    }
    rows.push_back(placed[i].row);
  }
  return rows;
}

std::vector<Row> parse_rows(std::string_view bytes, const std::string& name) {
  std::vector<PlacedRow> rows;
  append_rows(rows, bytes, name);
  return sorted(std::move(rows));
}

static void check_count(std::span<const PlacedRow> rows) {
  const auto count = std::count_if(rows.begin(), rows.end(), is_random);
  if (count >= 2) return;
  const auto only = std::find_if(rows.begin(), rows.end(), is_random);
  fail_at((only == rows.end() ? rows.back() : *only).where,
          count == 0 ? "found only realization 0, the deterministic run; statistics want random realizations 1, 2, ..."
                     : "found one random realization, statistics want at least two; mpmrun's row says what there is to say of one");
}

static void check_spread(std::span<const PlacedRow> rows) {
  std::vector<const PlacedRow*> slides;
  for (const PlacedRow& placed : rows) {
    if (is_random(placed) && placed.row.status == Status::slid) slides.push_back(&placed);
  }
  if (slides.size() < 2) return;
  const double first = slides.front()->row.runout;
  if (std::all_of(slides.begin(), slides.end(), [&](const PlacedRow* slide) { return slide->row.runout == first; }))
    fail_at(slides[1]->where, "column 'runout_m': found " + format_real(first) + " in each of the " + std::to_string(slides.size()) +
                                  " runs that slid, expected that they differ; were runs copied, or does the field not vary?");
}

std::vector<Row> read_rows(std::span<const std::string> paths) {
  std::vector<PlacedRow> rows;
  for (const std::string& path : paths) append_rows(rows, read_input(path), input_name(path));
  if (rows.empty()) fail_at({input_name(paths.back())}, "found a header without rows, expected at least two rows of random realizations");
  std::vector<Row> result = sorted(rows);
  check_count(rows);
  check_spread(rows);
  return result;
}

}  // namespace slidezone
