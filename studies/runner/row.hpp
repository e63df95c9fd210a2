#pragma once

#include "pfv/clock.hpp"
#include "studies/runner/csv.hpp"
#include "studies/runner/status.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace studies {

/// One run, one stored line: what was asked, of whom, with what, on what, what it took and what came out. Forces are
/// too large for it: they are in the answer stored beside it under the same key.
struct Row {
  std::string key; // names the run and its answer file: see run_key
  std::string study;
  std::string case_id;
  std::string case_digest;
  std::size_t spheres = 0;
  std::string method;
  double mesh_size = 1;
  std::optional<double> convergence_order; // of the method; nothing for a method without a mesh
  Status status = Status::failed;
  std::string message;                // why there is no answer
  std::optional<double> permeability; // m^2
  std::optional<double> porosity;
  std::size_t unknowns = 0;
  std::vector<pfv::Stage> stages; // CPU seconds; "mesh" is what the mesh took even when it came from the cache
  double process_cpu_seconds = 0; // of the process that ran it, start-up included, cached meshes not
  double wall_seconds = 0;
  std::size_t peak_memory_bytes = 0; // largest of the processes that ran it, all libraries of this build included
  std::size_t memory_bytes = 0;      // of the method alone: see MemoryMeter
  int repeats = 0;                   // runs of which the one with the median CPU seconds is kept
  double estimated_cpu_seconds = 0;
  double estimated_memory_bytes = 0;
  std::string method_version; // of what the method calls from outside, empty when nothing
  std::string answer_sources; // digest of the sources that can change its answer, compiler and flags included
  std::string commit;
  std::string compiler;
  std::string flags;
  std::string machine;
  std::string started; // UTC, ISO 8601

  bool operator==(const Row&) const = default;
};

const CsvRecord& row_columns();
CsvRecord to_record(const Row& row);

/// Throws pfv::InputError naming the column and the bad value.
Row row_from(const CsvRecord& record);

} // namespace studies
