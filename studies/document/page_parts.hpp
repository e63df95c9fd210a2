#pragma once

#include <string_view>

namespace studies {

// What every page carries in itself: page.css and page.js beside this file.
extern const std::string_view page_style, page_script;

} // namespace studies
