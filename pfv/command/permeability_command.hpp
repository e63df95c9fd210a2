#pragma once

namespace CLI {
class App;
}

namespace pfv {

/// Adds `pfv permeability FILE`: steady flow through a packing or a case, printed as text or JSON.
/// What it runs throws InputError or SolveError.
void add_permeability_command(CLI::App& app);

} // namespace pfv
