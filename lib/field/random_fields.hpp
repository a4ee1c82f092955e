// Samples of random fields: standard Gaussian fields (field/gaussian_field.hpp), correlated with each other where the scene says so
// (field/cross_correlation.hpp), conditioned on measurements where there are any (field/conditioning.hpp), given their marginal
// distributions and trends (field/cell_transform.hpp) and held within limits.
//
// The random numbers of a field are those of its name: it has the same samples with other fields beside it, but for what its
// correlation with them brings. A sample depends on (seed, name, number) and on the model alone: any of them can be drawn anywhere, with
// or without others, also those of a design (core/design.hpp): antithetic pairs turn the sign of every normal number, a Latin hypercube
// sets those of the leading modes (field/latin_hypercube.hpp), both for each field before fields are mixed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "field/cell_transform.hpp"
#include "field/conditioning.hpp"
#include "field/cross_correlation.hpp"
#include "field/gaussian_field.hpp"
#include "field/latin_hypercube.hpp"
#include "field/model.hpp"

namespace slidezone {

/// What values are held to: those beyond are moved to a limit.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

struct FieldPlan {
  std::string name;
  FieldModel model;
  Limits limits;             // measurements are met unless they lie beyond
  bool is_positive = false;  // a model whose values could fall to 0 or below is an error
  std::vector<Measurement> measurements;
};

class RandomFields {
 public:
  /// Errors name the field. Throws ExitCode::data as the parts do.
  RandomFields(std::vector<FieldPlan> plans, const std::vector<CrossCorrelation>& correlated, std::uint64_t seed,
               const StudyDesign& design = {});

  /// Fills `values`, of the mesh's size, with one sample of a field; returns how many values were moved to a limit. Fields that
  /// are correlated are drawn together: ask for all of one sample before the next.
  std::size_t fill(std::size_t field, std::span<double> values, std::uint32_t sample);

  /// The same in two steps: the standard Gaussian field, and the values made of it.
  void fill_gaussian(std::size_t field, std::span<double> values, std::uint32_t sample);
  std::size_t make_values(std::size_t field, std::span<double> values) const;

  const MethodReport& report(std::size_t field) const { return groups_[places_[field].group].gaussian.report(); }

  const FieldPlan& plan(std::size_t field) const { return plans_[field]; }
  const CellTransform& transform(std::size_t field) const { return transforms_[field]; }

  /// Nothing but for a Latin hypercube.
  const std::optional<LatinHypercube>& hypercube(std::size_t field) const { return groups_[places_[field].group].hypercube; }

 private:
  /// Fields that are drawn together: one, or those of one matrix of correlations.
  struct Group {
    GaussianField gaussian;
    std::optional<LatinHypercube> hypercube;
    std::vector<std::size_t> fields;
    Eigen::MatrixXd mixing;  // Cholesky factor of the correlations
    std::optional<Conditioning> conditioning;
    std::vector<std::vector<double>> drawn;  // Gaussian fields of one sample; empty where there is but one field
    std::uint32_t drawn_sample = 0;          // 0: none
  };
  struct Place {
    std::size_t group;
    std::size_t member;
  };

  void add_group(const std::vector<std::size_t>& fields, const CrossCorrelation* correlated);
  void draw(Group& group, std::span<const std::span<double>> values, std::uint32_t sample) const;

  std::vector<FieldPlan> plans_;
  std::vector<CellTransform> transforms_;
  std::vector<Group> groups_;
  std::vector<Place> places_;  // of each field
  std::uint64_t seed_;
  StudyDesign design_;
};

}  // namespace slidezone
