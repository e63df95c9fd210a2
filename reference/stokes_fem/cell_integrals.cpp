#include "reference/stokes_fem/cell_integrals.hpp"

#include <deal.II/base/quadrature_lib.h>

namespace reference::stokes_fem {

namespace {

const auto gradients = dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;

// On straight cells all integrands are polynomials of degree 2; on curved ones they are not polynomials at all.
const dealii::QGaussSimplex<3>& few() {
  static const dealii::QGaussSimplex<3> points(2);
  return points;
}

const dealii::QGaussSimplex<3>& many() {
  static const dealii::QGaussSimplex<3> points(3);
  return points;
}

void integrate(const dealii::FEValues<3>& velocity, const dealii::FEValues<3>& pressure, CellIntegrals& integrals) {
  integrals.stiffness.setZero();
  for (auto& coupling : integrals.coupling)
    coupling.setZero();
  integrals.velocity_volume.setZero();
  integrals.pressure_volume.setZero();
  for (const unsigned q : velocity.quadrature_point_indices()) {
    const double weight = velocity.JxW(q);
    Eigen::Matrix<double, 10, 3> gradient;
    for (unsigned i = 0; i < 10; ++i)
      for (unsigned c = 0; c < 3; ++c)
        gradient(i, c) = velocity.shape_grad(i, q)[c];
    integrals.stiffness += weight * gradient * gradient.transpose();
    for (unsigned k = 0; k < 4; ++k)
      for (unsigned c = 0; c < 3; ++c)
        integrals.coupling[c].row(k) += weight * pressure.shape_value(k, q) * gradient.col(c).transpose();
    for (unsigned i = 0; i < 10; ++i)
      integrals.velocity_volume[i] += weight * velocity.shape_value(i, q);
    for (unsigned k = 0; k < 4; ++k)
      integrals.pressure_volume[k] += weight * pressure.shape_value(k, q);
  }
}

} // namespace

CellIntegrator::CellIntegrator(const CurvedMapping& mapping)
    : mapping_(mapping), straight_mapping_(linear_), straight_(straight_mapping_, quadratic_, few(), gradients),
      straight_pressure_(straight_mapping_, linear_, few(), dealii::update_values),
      curved_(mapping, quadratic_, many(), gradients),
      curved_pressure_(mapping, linear_, many(), dealii::update_values) {}

const CellIntegrals& CellIntegrator::operator()(const Cell& cell) {
  const bool is_curved = mapping_.is_curved(cell);
  dealii::FEValues<3>& velocity = is_curved ? curved_ : straight_;
  dealii::FEValues<3>& pressure = is_curved ? curved_pressure_ : straight_pressure_;
  velocity.reinit(cell);
  pressure.reinit(cell);
  integrate(velocity, pressure, integrals_);
  return integrals_;
}

} // namespace reference::stokes_fem
