#pragma once

#include "reference/method.hpp"

namespace reference {

/// The original implementation of the model, FlowEngine of YADE, as a peer that is asked when it is installed. Its
/// stages: "network" (triangulation, geometry, conductances), "factor" (matrix and factors), "solve" and "forces" of
/// the first iteration; "repeat: solve" and "repeat: forces" of one more with kept topology, conductances and factors.
/// Its memory is what the flow adds to YADE with the packing loaded; that of the whole process is a count beside it.
std::unique_ptr<Method> make_yade();

} // namespace reference
