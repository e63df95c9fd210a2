#include "pfv/command/interruption.hpp"
#include "pfv/command/permeability_command.hpp"
#include "pfv/command/run_command.hpp"
#include "pfv/problem/error.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>

namespace {

enum ExitCode { answered = 0, bad_input = 2, not_solved = 3, by_signal = 128 };

int fail(int code, const std::exception& error) {
  fmt::print(stderr, "pfv: {}\n", error.what());
  return code;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Flow through sphere packings by pore-scale finite volumes, and grains in motion with it", "pfv"};
  app.set_version_flag("--version", PFV_VERSION);
  app.require_subcommand(1);
  pfv::add_permeability_command(app);
  pfv::add_run_command(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "pfv: {}; --help says what is allowed\n", error.what());
    return bad_input;
  } catch (const pfv::InputError& error) {
    return fail(bad_input, error);
  } catch (const pfv::Interrupted& interrupted) {
    return fail(by_signal + interrupted.signal, interrupted);
  } catch (const std::exception& error) {
    return fail(not_solved, error);
  }
  return answered;
}
