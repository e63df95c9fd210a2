#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pages {

/// A page that says what to do, as one who follows it would. A line that is only "`some/path`:" names the file of the
/// blocks behind it: a diff changes it, any other block is the whole of a new one. Blocks of sh are commands in the
/// project's folder; what a block without a language holds is found, line by line, in what the commands before it
/// print.
struct Step {
  std::string language; // of the block; "" is output to expect
  std::string file;     // "" where none is named
  std::vector<std::string> lines;
};

std::vector<Step> steps_of(const std::filesystem::path& page);

/// The text with the diff's lines: those with - and those with a blank must stand there together, once. A diff of +
/// only is appended. Throws std::runtime_error when they do not.
std::string changed(const std::string& text, const std::vector<std::string>& diff);

/// Makes the file of a step or changes it, below `project`. Throws std::runtime_error when a new one is there already.
void apply(const Step& step, const std::filesystem::path& project);

/// All of a project but for what was built, run or committed.
void copy_project(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace pages
