#pragma once

#include <Eigen/SparseCore>

namespace pfv {

/// A symmetric matrix, both triangles stored, compressed, the entries of a row in ascending order. Unlike its base,
/// which copies, it is moved when it can be.
class FlowMatrix : public Eigen::SparseMatrix<double, Eigen::RowMajor, int> {
public:
  using Base = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
  using Base::Base;
  using Base::operator=;
  FlowMatrix() = default;
  FlowMatrix(const FlowMatrix&) = default;
  FlowMatrix& operator=(const FlowMatrix&) = default;
  FlowMatrix(FlowMatrix&& other) noexcept { swap(other); }
  FlowMatrix& operator=(FlowMatrix&& other) noexcept {
    swap(other);
    return *this;
  }
};

} // namespace pfv
