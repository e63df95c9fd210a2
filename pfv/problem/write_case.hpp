#pragma once

#include "pfv/problem/case.hpp"

#include <string>

namespace pfv {

/// to_toml(case) without the name: the text of the question, one for each question.
std::string question_text(const Case& problem);

} // namespace pfv
