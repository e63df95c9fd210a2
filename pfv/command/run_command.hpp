#pragma once

namespace CLI {
class App;
}

namespace pfv {

/// `pfv run`: grains in motion, with fluid or without.
void add_run_command(CLI::App& app);

} // namespace pfv
