#pragma once

#include "reference/method.hpp"

namespace reference {

/// A fake with a known answer, to test the harness: never compare physics with it. For any case with a permeability
/// setup it says
///   k = 1 m^2 (1 + 0.05 mesh_size^2),
/// the flux Q = k area pressure_drop / (mu length) that follows, and forces in proportion to the spheres' volumes that
/// add up to pressure_drop times area against the axis. So convergence is of order 2 exactly, to 1 m^2. The environment
/// variable PFV_EXACT makes solve() misbehave:
///   fail   throws pfv::SolveError            throw  throws std::runtime_error
///   crash  ends the process by SIGABRT       slow   sleeps for 60 s, then answers
///   litter ends it too, leaving a file in a temporary folder
/// and any other value is an InputError.
std::unique_ptr<Method> make_exact();

} // namespace reference
