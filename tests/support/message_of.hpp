#pragma once

#include <string>

namespace pfv::testing {

/// What the Error that `action` throws says, or "no error".
template <typename Error, typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

} // namespace pfv::testing
