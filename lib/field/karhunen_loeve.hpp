// Karhunen-Loeve expansion cut off after the strongest modes: g = sum sqrt(lambda_k) xi_k phi_k, independent standard normals xi_k.
//
// On a mesh the modes are the eigenvectors of the covariance matrix of its cells; of a separable covariance they are products
// of one mode per axis, found at the cost of the axes alone. The modes kept are the fewest that hold the wanted share of the
// variance; the field's variance is that much too small, which is reported and not mended. Normal k belongs to mode k, strongest first.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "field/model.hpp"

namespace slidezone {

struct KarhunenLoeve {
  /// Place of a mode among the modes of the axes.
  struct Mode {
    Eigen::Index x, y;
    double amplitude;  // sqrt(lambda)
  };
  Eigen::MatrixXd modes_x;  // by columns; of one axis that holds all cells where the covariance is not separable
  Eigen::MatrixXd modes_y;
  std::vector<Mode> modes;  // strongest first
  double variance_kept = 0;
  double covariance_error = 0;  // the largest loss of variance at a cell
};

KarhunenLoeve karhunen_loeve(const FieldModel& model);

/// Fills one Gaussian field.
void fill(std::span<double> values, const KarhunenLoeve& expansion, RandomStream stream);

}  // namespace slidezone
