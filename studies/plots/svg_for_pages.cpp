#include "studies/plots/svg_for_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

namespace studies {

namespace {

// Relative luminance with which the contrast (L1 + 0.05) / (L2 + 0.05) is 3 and more with both papers (WCAG 2.1).
constexpr double least_luminance = 0.14, most_luminance = 0.30;

double linear(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

/// Calls `rewrite` on every match and puts what it returns in its place.
template <class Rewrite>
std::string replaced(const std::string& text, const std::regex& pattern, Rewrite rewrite) {
  std::string result;
  auto last = text.begin();
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    result.append(last, (*it)[0].first).append(rewrite(*it));
    last = (*it)[0].second;
  }
  return result.append(last, text.end());
}

} // namespace

std::string readable_on_both(int red, int green, int blue) {
  std::array<double, 3> c{linear(red / 255.0), linear(green / 255.0), linear(blue / 255.0)};
  const double luminance = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  for (double& value : c) {
    if (luminance > most_luminance) // towards black
      value *= most_luminance / luminance;
    else if (luminance < least_luminance) // towards white
      value += (1 - value) * (least_luminance - luminance) / (1 - luminance);
  }
  const auto byte = [](double value) {
    return std::clamp(static_cast<int>(std::lround(255 * encoded(value))), 0, 255);
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c[0]), byte(c[1]), byte(c[2]));
}

std::string svg_for_pages(std::string_view svg, const std::string& prefix) {
  const auto begin = svg.find("<svg");
  if (begin == std::string_view::npos)
    return "";
  std::string text(svg.substr(begin));
  const auto without = [&](const char* pattern) { text = std::regex_replace(text, std::regex(pattern), ""); };
  const auto instead = [&](const char* pattern, const std::string& by) {
    text = std::regex_replace(text, std::regex(pattern), by);
  };
  // The namespaces are those of HTML's parser anyhow. Titles would be tooltips.
  without("\\s+xmlns(:xlink)?=\"[^\"]*\"");
  without("<title>[^<]*</title>\\s*");
  without("<desc>[^<]*</desc>\\s*");
  without("<filter[^]*?</filter>\\s*");
  without("<g [^>]*>\\s*</g>\\s*");
  without(" font-family=(\"[^\"]*\"|'[^']*')");
  instead("<svg\\s+width=\"(\\d+)\" height=\"(\\d+)\"", "<svg role=\"img\" style=\"width:$1px\"");
  instead("(<rect [^>]*)fill=\"(#ffffff|white)\"/>", "$1fill=\"none\"/>");
  instead("xlink:href='#", "href='#" + prefix);
  instead(" id=(['\"])", " id=$1" + prefix);
  instead("(=['\"])(black|#000000|rgb\\(\\s*0,\\s*0,\\s*0\\))(['\"])", "$1currentColor$3");
  instead(" color=\"currentColor\"", "");
  instead("\n\\s+", "\n");
  return replaced(text, std::regex(R"(rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\))"), [](const std::smatch& match) {
    return readable_on_both(std::stoi(match[1]), std::stoi(match[2]), std::stoi(match[3]));
  });
}

} // namespace studies
