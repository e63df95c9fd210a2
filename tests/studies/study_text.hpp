#pragma once

#include <string>

/// A study of two cases that only asks the fake.
inline const std::string study_text = R"(
title = "A study"
question = "Does the harness work?"
reference = "exact"

[[method]]
name = "exact"
mesh_sizes = [2.0, 1.0]
quick_mesh_sizes = [4.0, 2.0]

[[case]]
id = "one"
quick = true
packing = { box = [[0, 0, 0], [1, 1, 1]], spheres = [[0.3, 0.4, 0.5, 0.2], [0.7, 0.6, 0.5, 0.1]] }
flow = { axis = "z" }

[[case]]
id = "two"
packing = { box = [[0, 0, 0], [1, 1, 1]], spheres = [[0.3, 0.4, 0.5, 0.2]] }
flow = { axis = "x" }
)";
