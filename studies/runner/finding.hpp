#pragma once

#include "studies/runner/extrapolate.hpp"
#include "studies/runner/row.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace studies {

/// The count of an answer with samples that says that nothing sets the level of its pressures.
inline constexpr const char* free_level_count = "free_pressure_level";

/// What a method finally says about a case, from its runs at all mesh sizes.
struct Finding {
  std::string case_id;
  std::string method;
  std::vector<Row> rows; // coarse to fine, answered or not, at least one
  std::optional<Bounded> permeability;
  std::optional<BoundedField> forces = {};         // N, x y z sphere by sphere
  std::optional<BoundedField> viscous_forces = {}; // N, likewise, the part of the shear in them
  std::optional<BoundedField> pore_pressures = {}; // Pa, at the centres of PFV's pores
  std::optional<BoundedField> throat_fluxes = {};  // m^3/s, through PFV's throats
  std::optional<double> sauter_diameter = {};      // m, of the packing, where the method says it
  std::optional<double> pressure_drop = {};        // Pa, over the box, for pressures to be compared with
  bool free_level = false;                         // of the pressures: nothing sets it, as under a mean gradient alone
  double bridge_error = 0;                         // share of the permeability that its error has for bridges

  /// The finest run that answered, else the finest: size and cost are told of this one.
  const Row& told() const;
  bool answered() const { return told().status == Status::answered; }
  /// Why a run at some mesh size has no answer, the first such reason; empty when all answered.
  std::string trouble() const;
};

/// Extrapolates the answered runs of one case and method (rows in any order, at least one). Forces, samples and what
/// an answer's counts say of its own error come from the answers in `answers`, absent when a run's answer has none or
/// is not there. The permeability's error is that of the extrapolation, noise included, and of the bridges. A run whose
/// answer cannot be read has failed.
Finding find(std::vector<Row> rows, const std::filesystem::path& answers);

/// Where the answer of a run is stored.
std::filesystem::path answer_file(const std::filesystem::path& answers, const std::string& key);

/// Why a stored answer cannot be used: it is missing or not what was written; nothing when it can.
std::optional<std::string> damage_of(const std::filesystem::path& answer_file);

} // namespace studies
