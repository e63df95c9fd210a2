#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace studies {

/// What `main` hands to the subcommands and gets back.
struct Invocation {
  std::filesystem::path executable; // this program, to start runs with
  int exit_code = 0;                // 0 done, 1 a run failed, 2 bad input; `answer` has its own
};

/// The whole program: reads the command line, does what it says, returns the exit code. Which methods there are is
/// decided by what it is linked with.
int main(int argc, char** argv);

// Each adds one subcommand to the command line. `invocation` must outlive `app`.
void add_list(CLI::App& app);
void add_methods(CLI::App& app);
void add_run(CLI::App& app, Invocation& invocation);
void add_compare(CLI::App& app, Invocation& invocation);
void add_report(CLI::App& app);
void add_index(CLI::App& app);
void add_samples(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_answer(CLI::App& app, Invocation& invocation);
void add_steps(CLI::App& app, Invocation& invocation);

} // namespace studies
