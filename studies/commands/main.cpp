#include "pfv/problem/error.hpp"
#include "studies/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace studies {

namespace {

constexpr int bad_input = 2;

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Asks several methods the same question about flow through sphere packings and compares their answers");
  app.require_subcommand(1);
  Invocation invocation;
  invocation.executable = std::filesystem::read_symlink("/proc/self/exe");
  add_list(app);
  add_methods(app);
  add_run(app, invocation);
  add_compare(app, invocation);
  add_report(app);
  add_index(app);
  add_samples(app);
  add_calibrate(app);
  add_answer(app, invocation);
  add_steps(app, invocation);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const pfv::InputError& error) {
    fmt::print(stderr, "study: {}\n", error.what());
    return bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "study: {}\n", error.what());
    return 1;
  }
  return invocation.exit_code;
}

} // namespace studies
