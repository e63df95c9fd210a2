#pragma once

#include "pfv/problem/vec3.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace reference::openfoam {

/// Reads OpenFOAM's ASCII lists from front to back. Everything throws pfv::SolveError, with the file's name, on text
/// that is not what was asked for.
class FoamReader {
public:
  explicit FoamReader(const std::filesystem::path& file);

  /// Moves behind the next occurrence of a word.
  void skip_past(std::string_view word);
  /// Moves behind the file's header.
  void skip_header() { skip_past("// * * "), skip_past("\n"); }

  void expect(char character);
  bool next_is(char character);
  std::string word(); // up to white space, `(`, `)`, `{`, `}` or `;`
  double number();
  std::size_t count();
  pfv::Vec3 vector();

  /// `N (a b ...)` or `N{a}`.
  std::vector<std::size_t> counts();
  /// `uniform a` or `nonuniform List<scalar> N (a b ...)`.
  std::vector<double> scalar_field(std::size_t size);
  std::vector<pfv::Vec3> vector_field(std::size_t size);

private:
  void skip_space();
  [[noreturn]] void fail(const std::string& wanted) const;
  template <class Value, class Read>
  std::vector<Value> field(std::size_t size, Read read);

  std::filesystem::path file_;
  std::string text_;
  std::size_t position_ = 0;
};

} // namespace reference::openfoam
