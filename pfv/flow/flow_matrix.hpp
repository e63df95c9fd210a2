#pragma once

#include <Eigen/SparseCore>

namespace pfv {

/// A symmetric matrix, both triangles stored, compressed, the entries of a row in ascending order.
using FlowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

} // namespace pfv
