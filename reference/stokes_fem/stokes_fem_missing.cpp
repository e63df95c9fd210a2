#include "reference/stokes_fem/stokes_fem.hpp"
#include "reference/unavailable_method.hpp"

namespace reference {

std::unique_ptr<Method> make_stokes_fem() {
  return make_unavailable(
      "stokes_fem", "Stokes flow by finite elements of order 2/1 (deal.II)",
      "this build has no deal.II or no CHOLMOD (Debian packages libdeal.ii-dev, libsuitesparse-dev)");
}

} // namespace reference
