#pragma once

#include "pfv/problem/case.hpp"
#include "reference/yade/flow_engine.hpp"
#include "studies/motion/stability/trial.hpp"

namespace studies {

// What the original implementation, FlowEngine of YADE, does with a case, in words. It is asked in a process of its
// own, with nothing that is known to be beyond it held back.

/// Its answer, or in words why there is none: "crashed with signal 11 (Segmentation fault)", "nan", "no answer in 60
/// s".
struct OriginalAnswer {
  std::optional<reference::yade::Reply> reply;
  std::string why_not;
};
OriginalAnswer ask_original(const pfv::Case& problem);

/// One steady flow: its permeability, plotted too, or what is wrong with it.
Theirs original_flow(const pfv::Case& problem);

/// False for the sphere nearest to each corner of the box: the original's forces on four of these are wrong.
std::vector<bool> away_from_corners(const pfv::Packing& packing);

/// How a failure of the program reads in a table.
std::string in_words(const std::string& failure);

inline constexpr const char* not_installed = "not installed";
inline constexpr double original_wall_limit = 120; // s

} // namespace studies
