#pragma once

namespace studies {

// Terzaghi's consolidation of a layer that drains at both ends, loaded at once. Time factor T = c_v t / L^2 with L half
// of the distance between the drained planes and c_v = k / (mu m_v); eq. (12) to (16) of Catalano et al. 2011.

/// Excess pressure over the load, at a depth from a drained plane in units of L, 0 ... 2.
double terzaghi_pressure(double time_factor, double depth);

/// Settlement over the final one.
double terzaghi_settlement(double time_factor);

} // namespace studies
