#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace pfv {

/// What work that may go wrong in any way is allowed to take.
struct Allowance {
  std::size_t memory; // bytes on top of what this process has
  std::size_t cpu_seconds;
};

/// The bytes that `work` returns, in a process of its own: a copy of this one that prints nothing and leaves nothing.
/// Nothing when it crashed or took more than it is allowed. Throws InputError when `work` does.
std::optional<std::string> answer_apart(const std::function<std::string()>& work, const Allowance& allowance);

} // namespace pfv
