#include "pfv/solvers/finest_level.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

namespace pfv {

FinestLevel::FinestLevel(const MatrixView<double>& matrix, double scale) : MultigridLevel(matrix.rows()) {
  follow(matrix, scale);
}

void FinestLevel::follow(const MatrixView<double>& matrix, double scale) {
  matrix_.take(matrix, scale, inverse_diagonal_, row_sum_);
  if (const float least = rows() > 0 ? inverse_diagonal_.minCoeff() : 1; !(least > 0))
    throw SolveError(fmt::format("multigrid: the diagonal of the matrix falls to {} of its largest entry", least));
  inverse_diagonal_ = inverse_diagonal_.cwiseInverse();
}

void FinestLevel::sweep_up_from_zero() {
  matrix_.ascending([this](int i, auto columns, auto values) {
    const float p = right_side[i] * inverse_diagonal_[i];
    pressure[i] = p;
    right_side[i] = 0;
    for (std::size_t k = 0; k < columns.size(); ++k)
      right_side[columns[k]] -= values[k] * p;
  });
}

void FinestLevel::sweep_down() {
  matrix_.descending([this](int i, auto columns, auto values) {
    float rest = right_side[i];
    for (std::size_t k = 0; k < columns.size(); ++k)
      rest -= values[k] * correction_[columns[k]];
    const float correction = rest * inverse_diagonal_[i];
    correction_[i] = correction;
    pressure[i] += correction;
  });
}

double FinestLevel::multiply(const Eigen::VectorXf& x) {
  double power = 0;
  matrix_.ascending([this, &x, &power](int i, auto columns, auto values) {
    float sum = row_sum_[i] * x[i];
    for (std::size_t k = 0; k < columns.size(); ++k)
      sum += values[k] * (x[columns[k]] - x[i]);
    correction_[i] = sum;
    power += static_cast<double>(sum) * x[i];
  });
  return power;
}

} // namespace pfv
