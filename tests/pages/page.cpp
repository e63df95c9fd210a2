#include "pages/page.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace pages {

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw std::runtime_error("no " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += line + '\n';
  return text;
}

} // namespace

std::vector<Step> steps_of(const fs::path& page) {
  std::ifstream in(page);
  if (!in)
    throw std::runtime_error("no " + page.string());
  std::vector<Step> steps;
  std::string file;
  bool in_block = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      in_block = !in_block;
      if (in_block)
        steps.push_back({line.substr(3), file, {}});
    } else if (in_block)
      steps.back().lines.push_back(line);
    else if (line.starts_with('`') && line.ends_with("`:") && line.find('`', 1) == line.size() - 2)
      file = line.substr(1, line.size() - 3);
    else if (!line.empty())
      file.clear();
  }
  return steps;
}

std::string changed(const std::string& text, const std::vector<std::string>& diff) {
  std::string before, after;
  for (const std::string& line : diff) {
    const std::string rest = line.empty() ? "" : line.substr(1);
    if (!line.starts_with('+'))
      before += rest + '\n';
    if (!line.starts_with('-'))
      after += rest + '\n';
  }
  if (before.empty())
    return text + after;
  const auto at = ('\n' + text).find('\n' + before);
  if (at == text.npos)
    throw std::runtime_error("this does not stand there:\n" + before);
  if (('\n' + text).find('\n' + before, at + 1) != text.npos)
    throw std::runtime_error("this stands there more than once:\n" + before);
  return text.substr(0, at) + after + text.substr(at + before.size());
}

void apply(const Step& step, const fs::path& project) {
  const fs::path file = project / step.file;
  if (step.language == "diff")
    write(file, changed(read(file), step.lines));
  else if (fs::exists(file))
    throw std::runtime_error(step.file + " is there already");
  else
    write(file, text_of(step.lines));
}

void copy_project(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path name = entry.path().filename();
    if (name == "build" || name == ".git" || name == "work")
      continue;
    if (entry.is_directory())
      copy_project(entry.path(), to / name);
    else
      fs::copy_file(entry.path(), to / name);
  }
}

} // namespace pages
