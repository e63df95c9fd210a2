#pragma once

#include "pfv/problem/vec3.hpp"
#include "pfv/solvers/interpolation.hpp"

#include <Eigen/Core>
#include <vector>

namespace pfv {

/// S = C C', what every row has in common with those that share a block of three columns with it. C is kept twice, by
/// row and by block, so that both C x and C' x are sums that need no scatter.
struct GramTerm {
  struct Entry {
    int index; // block, or row where the entries are by block
    Vec3 value;
  };
  struct Entries {
    std::vector<int> start = {0};
    std::vector<Entry> entry;
  };
  Entries by_row, by_block;

  int rows() const { return static_cast<int>(by_row.start.size()) - 1; }
  int blocks() const { return static_cast<int>(by_block.start.size()) - 1; }
  bool empty() const { return by_row.entry.empty(); }
};

/// From its rows.
GramTerm gram_term(GramTerm::Entries by_row, int blocks);

/// Of S.
Eigen::VectorXd diagonal(const GramTerm& term);

/// P' S P (Galerkin), as a term again.
GramTerm coarse_term(const GramTerm& fine, const Interpolation& interpolation);

/// product = (A + S) x; returns x.product. `of_block` is room for C' x.
double multiply(const FlowMatrix& matrix, const GramTerm& term, const Eigen::VectorXd& x, std::vector<Vec3>& of_block,
                Eigen::VectorXd& product);

} // namespace pfv
