#include "summary/studies.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/tool.hpp"
#include "rows/row.hpp"

namespace slidezone {

NamedEnsemble read_study(const std::string& name, std::span<const std::string> paths, Provenance& origin) {
  const std::vector<Row> rows = read_rows(paths);
  const std::string prefix = name.empty() ? "" : name + " ";
  for (const std::string& caution : cautions(rows)) warn(prefix + caution);
  NamedEnsemble study{name, ensemble_of(rows)};
  origin.details.emplace_back(prefix + "rows", checksum(rows));
  origin.details.emplace_back(prefix + "realizations", std::to_string(study.ensemble.failure.size()));
  return study;
}

std::vector<NamedEnsemble> read_studies(std::span<const std::string> named_files, Provenance& origin) {
  std::vector<NamedEnsemble> studies;
  for (const std::string& text : named_files) {
    const std::string name = text.substr(0, text.find('='));
    if (std::any_of(studies.begin(), studies.end(), [&](const NamedEnsemble& study) { return study.name == name; }))
      throw Error(ExitCode::usage, "--study: '" + name + "' stands twice");
    const std::string file = text.substr(name.size() + 1);
    studies.push_back(read_study(name, std::span(&file, 1), origin));
  }
  return studies;
}

void tell_boundaries(Provenance& origin, const NamedEnsemble& study, const ZoneOptions& options) {
  for (const std::string& text : thin_boundaries(study, options)) note(text);
  if (!options.has_tails) return;
  for (const ReachOfStudy* reach : {&study.ensemble.influence, &study.ensemble.runout}) {
    const std::string of = (study.name.empty() ? "" : study.name + " ") + reach->quantity;
    const std::optional<TailFit> fit = tail_of(*reach, options);
    if (!fit)
      warn("no tail fitted to " + of +
           ": too few runs, or some left the grid, diverged or depend on each other; boundaries are of order statistics");
    origin.details.emplace_back("tail of " + of, fit ? words_on(*fit) : "none");
  }
}

}  // namespace slidezone
