#pragma once

#include "reference/lattice_boltzmann/wall_links.hpp"

#include <memory>

namespace reference::lattice_boltzmann {

/// What can be measured of a flow at any step.
struct FlowState {
  std::vector<double> section_velocity; // mean over each section across the axis
  double velocity = 0;                  // mean over the box
  double taken_up = 0;                  // of the force on the fluid, by the spheres, along the axis
};

/// Pressure and velocity at the centres of all voxels of the box; zero in solid ones.
struct Fields {
  std::vector<double> pressure;
  std::array<std::vector<double>, 3> velocity;
};

/// The flow on Palabos' lattice, shared between the ranks of MPI; every rank asks everything at the same time and gets
/// the same answers.
///
/// Around the box stands one layer of cells that never collide. What streams into them is what the box's image on the
/// other side would have sent in, up to reflection and sign: so walls and pressure planes lie half-way between them and
/// the first layer, exactly. On spheres the central linear interpolation of Ginzburg, Verhaeghe and d'Humieres 2008
/// (Khirevich, Ginzburg and Tallarek 2015 in sphere packings) puts the wall where the link cuts it:
///   f_-d(x) = f*_d(x) + (1 - 2 q) / (1 + 2 q) (f*_d(x - c_d) - f*_-d(x)),
/// second order and independent of the viscosity; half-way bounce-back where there is no fluid behind x.
class FlowLattice {
public:
  FlowLattice(const FlowQuestion& question, const Voxels& voxels, const std::vector<WallLink>& links);
  ~FlowLattice();
  FlowLattice(const FlowLattice&) = delete;
  FlowLattice& operator=(const FlowLattice&) = delete;

  void step();
  FlowState state() const;
  /// Takes the mean from the pressure, which nothing else fixes where no face is at a pressure.
  void centre_pressure();
  /// By sphere, from what is handed over along the links (Ladd 1994), without the driving gradient.
  std::vector<pfv::Vec3> forces() const;
  Fields fields() const;

private:
  struct Blocks;
  std::unique_ptr<Blocks> blocks_;
};

} // namespace reference::lattice_boltzmann
