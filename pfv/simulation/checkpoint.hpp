#pragma once

#include "pfv/simulation/grain_cycle.hpp"
#include "pfv/simulation/pore_fluid.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pfv {

struct Scene;

/// All that a run remembers, from which it goes on bit for bit. Not in it is what both the run that is saved and the
/// one that goes on find anew: candidates for contacts, pores, the length of the step. What a scene names is not in it
/// either.
struct Checkpoint {
  Grains grains;
  std::optional<Cohesion> cohesion;
  Contacts::Memory contacts; // springs and bonds of the candidates
  std::vector<Load> loads;   // of the last step
  std::array<double, 6> on_wall{};
  EnergyBalance energy;
  std::size_t broken_bonds = 0, steps = 0;
  double time = 0; // s
  std::optional<FluidState> fluid;
};

/// Throws InputError unless the grains are those of the scene: as many, of the same radii (before they grew) and
/// density, periodic along the same axes, and cemented in both or in neither. Anything else a scene names may differ
/// from the one that was saved.
void require_same_grains(const Checkpoint& checkpoint, const Scene& scene);

/// Writes a file that is whole or, if that fails, not there: what had its name before stays until then.
///
/// A line "pfv checkpoint VERSION BYTES DIGEST" and then CBOR: fields by name, arrays as the machine holds them.
/// Throws InputError when it cannot be written.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws InputError when a checkpoint could not be written to this file.
void require_writable(const std::filesystem::path& file);

/// Throws InputError, one line that begins with the file, when it is not such a file, or truncated or damaged.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// The CBOR alone.
std::string to_bytes(const Checkpoint& checkpoint);
Checkpoint from_bytes(std::string_view bytes);

} // namespace pfv
