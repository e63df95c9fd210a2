#pragma once

#include <mpi.h>
#include <span>

namespace reference::lattice_boltzmann {

/// Every number becomes its sum over all ranks, on all of them.
inline void sum_over_ranks(std::span<double> values) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

} // namespace reference::lattice_boltzmann
