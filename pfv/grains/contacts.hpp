#pragma once

#include "pfv/grains/candidates.hpp"
#include "pfv/grains/contact_law.hpp"
#include "pfv/grains/walls.hpp"

#include <array>
#include <optional>

namespace pfv {

/// Where the energy of the contacts went in a step (J), and the bonds that broke.
struct ContactLosses {
  double friction = 0;
  double damping = 0;
  int broken_bonds = 0;
};

/// The contacts of grains with one another and with the walls, and what their springs remember.
class Contacts {
public:
  Contacts(const ContactLaw& law, double wall_friction, const std::optional<Cohesion>& cohesion, const Grains& grains);

  /// Adds the contact forces where the grains are now to their loads, and to `on_wall` those on the walls (N, along the
  /// axis). The springs are stretched by what has happened since the last call, `step` seconds long. Candidates are
  /// renewed when grains or walls may have moved by half of the margin.
  ContactLosses add_forces(const Grains& grains, double step, std::vector<Load>& loads, std::array<double, 6>& on_wall);

  /// What they remember from step to step: with it a run goes on bit for bit.
  struct Memory {
    CandidatePairs pairs;
    CandidateWalls at_walls;
    std::vector<Vec3> reference;             // m, where grains were when the candidates were found
    std::array<double, 6> reference_walls{}; // m
    double drift = 0;                        // m, no grain or wall has moved farther since
    double grown = 0;                        // m, no radius has grown by more since
  };
  const Memory& memory() const { return memory_; }
  void restore(Memory memory) { memory_ = std::move(memory); }
  /// Finds the candidates anew where the grains are now; forces do not depend on when that is done.
  void renew(const Grains& grains);

  const ContactLaw& law() const { return law_; }
  /// Another law from now on; springs and bonds stay as they are.
  void set_law(const ContactLaw& law, double wall_friction) {
    law_ = law;
    wall_friction_ = wall_friction;
  }
  /// Tells them that no radius has grown by more than this (m) since the last step.
  void note_growth(double most) { memory_.grown += most; }
  /// From now on candidates are all within this share of the smaller radius, for whatever else acts between them.
  void set_reach(double reach, const Grains& grains);

private:
  void renew_if_moved(const Grains& grains, double step);

  ContactLaw law_;
  double wall_friction_;
  std::optional<Cohesion> cohesion_;
  double reach_ = 0;
  double margin_ = 0; // m
  Memory memory_;
};

} // namespace pfv
