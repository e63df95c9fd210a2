#pragma once

#include "pfv/problem/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace studies {

/// A packing whose permeability, and forces on whose spheres, are known.
struct KnownFlow {
  std::string id;
  pfv::Case problem;
  double permeability;          // m^2
  double error;                 // m^2
  std::vector<pfv::Vec3> force; // N by sphere
};

/// The packings of a study with what its results say of them: permeabilities.csv and forces.csv beside the file. What
/// generators make is kept in `cases`. Throws pfv::InputError with file and line.
std::vector<KnownFlow> known_flows(const std::filesystem::path& study_toml, const std::filesystem::path& cases);

} // namespace studies
