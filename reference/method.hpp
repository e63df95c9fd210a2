#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/case.hpp"
#include "reference/answer.hpp"
#include "reference/probes.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reference {

/// How a case is to be answered, and what of the answer is wanted beside the usual.
struct Request {
  double mesh_size = 1; // scales every element length of a method's default mesh: 2 is twice as coarse
  int ranks = 1;        // processes that share the work, by MPI
  Probes probes = {};   // where to sample the flow; nothing is sampled and nothing paid for without
};

/// What a run is expected to take, known before it starts.
struct Estimate {
  double unknowns = 0;
  double cpu_seconds = 0;
  double memory_bytes = 0;
};

/// Anything that answers a Case: ours, brute force or closed form, all behind the same few questions.
class Method {
public:
  virtual ~Method() = default;

  virtual std::string name() const = 0;
  /// One line on what it is, for `study methods`.
  virtual std::string description() const = 0;
  /// Of the programs outside this build it calls, as they name it themselves; empty when there are none. An answer
  /// stored under another version is not taken for this one.
  virtual std::string version() const { return {}; }
  /// Folders of this project whose sources, with all below them, an answer depends on, beside those that lie directly
  /// in pfv/ and reference/. An answer stored under other sources is not taken for this one; those elsewhere may
  /// change.
  virtual std::vector<std::string> built_from() const { return {"pfv", "meshing", "reference"}; }
  /// Why it cannot run on this machine or build; nothing when it can.
  virtual std::optional<std::string> unavailable() const { return std::nullopt; }
  /// Why it does not answer this case; nothing when it does.
  virtual std::optional<std::string> not_covered(const pfv::Case& problem) const = 0;
  /// Expected order of convergence of the permeability in mesh_size; nothing for a method without a mesh.
  virtual std::optional<double> convergence_order() const { return std::nullopt; }
  /// Whether it can share its work between several ranks.
  virtual bool runs_on_ranks() const { return false; }
  virtual Estimate estimate(const pfv::Case& problem, const Request& request) const = 0;
  /// Throws pfv::SolveError with the reason when it cannot answer. Called from one process and one thread, it
  /// starts its ranks itself.
  virtual Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const = 0;
};

/// Every method known to this build, available or not, in the order tables show them.
const std::vector<std::unique_ptr<Method>>& methods();

/// Throws pfv::InputError naming the valid names.
const Method& find_method(const std::string& name);

} // namespace reference
