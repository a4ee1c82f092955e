// Latin hypercube samples of random fields (McKay, Beckman and Conover 1979), on the leading modes of the field.
//
// A mode phi_k of the covariance of the cells, nugget included, has the amplitude a_k = phi_k . g / sqrt(lambda_k) in a Gaussian field g:
// a standard normal, independent of the others and of what is left of g. In its place comes a number x_k of a stratum:
//
//   g + sum_k sqrt(lambda_k) (x_k - a_k) phi_k,   x_k = Phi^-1((p_k + u_k) / n),
//
// p_k the sample's place in a random permutation of the n strata, one for each mode and block of n samples, u_k uniform. Each sample has
// the field's distribution, exactly; those of one block fill every stratum of every mode once, so that means of what the leading modes
// decide scatter less. What other modes decide is as in plain samples.
//
// Modes as in field/karhunen_loeve.hpp: of separable correlations with up to 2,500 cells along an axis, and of others on meshes
// of up to 2,500 cells.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/design.hpp"
#include "core/random.hpp"
#include "field/model.hpp"

namespace slidezone {

/// How the samples of a study are drawn; block_size and modes are those of a Latin hypercube.
struct StudyDesign {
  Design design = Design::plain;
  std::uint64_t block_size = 16;  // samples
  std::uint64_t modes = 20;       // of each field
};

/// The number of the pair or hypercube that a sample belongs to, from 1; plain: the sample's own.
std::uint64_t block_of(const StudyDesign& design, std::uint64_t sample);

class LatinHypercube {
 public:
  /// Throws ExitCode::data where the modes are out of reach.
  LatinHypercube(const FieldModel& model, const StudyDesign& design);

  /// Changes a standard Gaussian field of the model, drawn by `stream`.
  void apply(std::span<double> values, RandomStream stream);

  std::size_t modes() const { return modes_.size(); }
  double variance_share() const { return variance_share_; }  // of these modes in that of the field

 private:
  struct Mode {
    Eigen::Index x, y;  // columns
    double amplitude;   // sqrt(lambda)
  };
  /// The normals of one block, a row a mode and a column a sample.
  struct Block {
    RandomStream stream;
    Eigen::MatrixXd normals;
  };
  const Eigen::MatrixXd& normals_of(RandomStream stream);

  std::uint64_t block_size_;
  Eigen::MatrixXd modes_x_, modes_y_;  // by columns
  std::vector<Mode> modes_;
  double variance_share_ = 0;
  std::map<std::uint32_t, Block> blocks_;  // the last one of each purpose
};

}  // namespace slidezone
