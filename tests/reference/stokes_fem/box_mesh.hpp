#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <filesystem>
#include <string>

/// Writes an empty box cut into cells[0] x cells[1] x cells[2] bricks of six tetrahedra each, as MSH 2.2 ASCII with one
/// surface group per face of the box, named `groups` in the order of pfv::Face.
void write_box_mesh(const std::filesystem::path& file, const pfv::Box& box, const std::array<int, 3>& cells,
                    const std::array<std::string, 6>& groups);
