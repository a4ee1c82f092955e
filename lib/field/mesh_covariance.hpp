// Covariance matrices of the cells of a mesh, or of one row or column of cells.
#pragma once

#include <Eigen/Dense>

#include "field/model.hpp"

namespace slidezone {

/// Of the cells of one row of a separable model, and of one column over the variance: their products are the covariances.
Eigen::MatrixXd row_covariance(const FieldModel& model);
Eigen::MatrixXd column_covariance(const FieldModel& model);

/// Of all cells.
Eigen::MatrixXd full_covariance(const FieldModel& model);

}  // namespace slidezone
