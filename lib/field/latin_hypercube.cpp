#include "field/latin_hypercube.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "field/cell_correlation.hpp"
#include "field/karhunen_loeve.hpp"

namespace slidezone {

std::uint64_t block_of(const StudyDesign& design, std::uint64_t sample) {
  switch (design.design) {
    case Design::plain:
      return sample;
    case Design::antithetic:
      return (sample + 1) / 2;
    case Design::latin_hypercube:
      return (sample - 1) / design.block_size + 1;
  }
  return sample;
}

/// Finding modes costs some 10 n^3.
static void check_size(const FieldModel& model) {
  constexpr std::size_t most = 2500;
  const bool is_separable = CellCorrelation(model).is_separable();
  const auto longer = static_cast<std::size_t>(std::max(model.mesh.cells_x, model.mesh.cells_y));
  if ((is_separable ? longer : model.mesh.size()) > most)
    throw Error(ExitCode::data, "a Latin hypercube wants the modes of the field, of at most " + std::to_string(most) + " cells" +
                                    (is_separable ? " along an axis" : " where the correlation is not separable along x and y") +
                                    "; take a coarser mesh or design = \"antithetic\"");
}

/// The sign of a mode is of no consequence but for the numbers of a study: the first entry that is not small is positive.
static void turn(Eigen::Ref<Eigen::VectorXd> mode) {
  const double large = 1e-3 * mode.cwiseAbs().maxCoeff();
  const auto first = std::ranges::find_if(mode, [large](double entry) { return std::abs(entry) > large; });
  if (*first < 0) mode = -mode;
}

LatinHypercube::LatinHypercube(const FieldModel& model, const StudyDesign& design) : block_size_(design.block_size) {
  check_size(model);
  FieldModel all = model;
  if (model.method != Method::karhunen_loeve) all.variance_kept = 1;
  KarhunenLoeve expansion = karhunen_loeve(all);
  modes_x_ = std::move(expansion.modes_x);
  modes_y_ = std::move(expansion.modes_y);
  for (Eigen::Index i = 0; i < modes_x_.cols(); ++i) turn(modes_x_.col(i));
  for (Eigen::Index i = 0; i < modes_y_.cols(); ++i) turn(modes_y_.col(i));
  const double nugget = model.correlation.nugget, variance = CellCorrelation(model)(0, 0);
  for (const KarhunenLoeve::Mode& mode : expansion.modes) {
    constexpr double rounding = 1e-6;  // of an amplitude: smaller ones are not known
    if (modes_.size() == design.modes || mode.amplitude < rounding * expansion.modes.front().amplitude) break;
    const double lambda = (1 - nugget) * mode.amplitude * mode.amplitude + nugget;
    modes_.push_back({mode.x, mode.y, std::sqrt(lambda)});
    variance_share_ += lambda / (static_cast<double>(model.mesh.size()) * ((1 - nugget) * variance + nugget));
  }
}

/// Fisher and Yates' shuffle of 0 ... n - 1 by n random words.
static std::vector<std::size_t> permutation(std::span<const std::uint64_t> words) {
  std::vector<std::size_t> places(words.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  for (std::size_t i = places.size(); i-- > 1;) std::swap(places[i], places[words[i] % (i + 1)]);
  return places;
}

const Eigen::MatrixXd& LatinHypercube::normals_of(RandomStream stream) {
  static const std::uint32_t hypercube = purpose("Latin hypercube");
  stream.sample = static_cast<std::uint32_t>((stream.sample - 1) / block_size_ + 1);
  const auto known = blocks_.find(stream.purpose);
  if (known != blocks_.end() && known->second.stream.sample == stream.sample && known->second.stream.seed == stream.seed)
    return known->second.normals;

  const std::size_t n = block_size_;
  std::vector<std::uint64_t> words(2 * n * modes_.size());
  fill_words(words, {stream.seed, stream.purpose ^ hypercube, stream.sample});
  Eigen::MatrixXd normals(modes_.size(), n);
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
    const std::span<const std::uint64_t> own(&words[2 * n * mode], 2 * n);
    const std::vector<std::size_t> strata = permutation(own.first(n));
    for (std::size_t i = 0; i < n; ++i) {
      const double within = (static_cast<double>(own[n + i] >> 12) + 0.5) * 0x1p-52;
      normals(static_cast<Eigen::Index>(mode), static_cast<Eigen::Index>(i)) =
          gsl_cdf_ugaussian_Pinv((static_cast<double>(strata[i]) + within) / static_cast<double>(n));
    }
  }
  Block& block = blocks_[stream.purpose];
  block = {stream, std::move(normals)};
  return block.normals;
}

void LatinHypercube::apply(std::span<double> values, RandomStream stream) {
  const auto column = static_cast<Eigen::Index>((stream.sample - 1) % block_size_);
  const Eigen::MatrixXd& normals = normals_of(stream);
  Eigen::Map<Eigen::MatrixXd> field(values.data(), modes_x_.rows(), modes_y_.rows());  // a column is a row of cells
  // The modes are orthogonal: amplitudes do not change while others do.
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const auto& [x, y, amplitude] = modes_[k];
    const Eigen::VectorXd across = field.transpose() * modes_x_.col(x);
    const double projection = across.dot(modes_y_.col(y));
    const double change = amplitude * normals(static_cast<Eigen::Index>(k), column) - projection;
    field.noalias() += modes_x_.col(x) * (change * modes_y_.col(y)).transpose();
  }
}

}  // namespace slidezone
