#pragma once

#include <cstddef>
#include <string>

namespace studies {

/// How often a text has another one in it.
inline std::size_t times(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

} // namespace studies
