#pragma once

#include <string>
#include <string_view>

namespace studies {

/// An SVG of gnuplot made fit to stand inside of a page: without XML head, fixed size, white ground and fonts of its
/// own; black becomes the colour of the page's text; every other colour keeps its hue and gets a luminance that has
/// a contrast of 3 with white and with black paper; `prefix` leads its ids, which must not meet those of another
/// picture.
std::string svg_for_pages(std::string_view svg, const std::string& prefix);

/// A colour "#rrggbb" with such a luminance.
std::string readable_on_both(int red, int green, int blue);

} // namespace studies
