#pragma once

#include "studies/runner/row.hpp"

#include <string>

/// An answered run with something in every column.
inline studies::Row example_row(const std::string& method = "exact", double mesh_size = 1) {
  studies::Row row;
  row.key = method + std::to_string(mesh_size);
  row.study = "example";
  row.case_id = "one";
  row.case_digest = "0123456789abcdef";
  row.spheres = 9;
  row.method = method;
  row.mesh_size = mesh_size;
  row.convergence_order = 2;
  row.status = studies::Status::answered;
  row.message = "";
  row.permeability = 0.1 + 0.2; // does not end
  row.porosity = 0.4;
  row.unknowns = 45;
  row.stages = {{"mesh", 1.5}, {"assemble", 0.25}, {"solve", 1e-4 / 3}};
  row.process_cpu_seconds = 2;
  row.wall_seconds = 2.5;
  row.peak_memory_bytes = 123456789;
  row.memory_bytes = 23456789;
  row.repeats = 3;
  row.estimated_cpu_seconds = 1;
  row.estimated_memory_bytes = 1e8;
  row.method_version = "1912";
  row.answer_sources = "fedcba9876543210";
  row.commit = "abc-dirty";
  row.compiler = "GNU 12";
  row.flags = "-O3";
  row.machine = "a processor, 2 cores";
  row.started = "2000-01-01T00:00:00Z";
  return row;
}
