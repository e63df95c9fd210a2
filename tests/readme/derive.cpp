#include "readme/derive.hpp"

#include "readme/columns.hpp"
#include "readme/scanner.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace readme {

namespace {

constexpr std::array constants{1.0, 2.0, 60.0, 100.0, 1000.0};

using List = std::vector<double>;

double sum_of(const List& list) {
  return std::accumulate(list.begin(), list.end(), 0.0);
}

double count_of(const List& list) {
  return static_cast<double>(list.size());
}

const std::map<std::string, double (*)(const List&)> functions{
    {"count", count_of},
    {"max", [](const List& list) { return *std::ranges::max_element(list); }},
    {"mean", [](const List& list) { return sum_of(list) / count_of(list); }},
    {"min", [](const List& list) { return *std::ranges::min_element(list); }},
    {"rms",
     [](const List& list) {
       return std::sqrt(std::inner_product(list.begin(), list.end(), list.begin(), 0.0) / count_of(list));
     }},
    {"sum", sum_of}};

class Expression {
public:
  Expression(std::string_view text, const Sources& sources) : scan_(text), sources_(sources) {}

  double value() {
    const double is = sum();
    if (!scan_.done())
      throw std::runtime_error("not understood: " + std::string(scan_.rest()));
    return is;
  }

private:
  bool take(std::string_view sign) {
    while (scan_.take(" ")) {
    }
    return scan_.take(sign);
  }

  double sum() {
    double is = product();
    for (;;) {
      if (take("+"))
        is += product();
      else if (take("-"))
        is -= product();
      else
        return is;
    }
  }

  double product() {
    double is = factor();
    for (;;) {
      if (take("/"))
        is /= factor();
      else if (take("*") || scan_.now() == '(' || digit(scan_.now()) || letter(scan_.now()))
        is *= factor();
      else
        return is;
    }
  }

  double factor() {
    if (take("-"))
      return -factor();
    if (take("(")) {
      const double is = sum();
      if (!take(")"))
        throw std::runtime_error("a ) is missing");
      return is;
    }
    for (const auto& [name, function] : functions)
      if (take(name + "("))
        return function(list());
    const std::string figure = scan_.figure();
    if (figure.empty())
      throw std::runtime_error("not understood: " + std::string(scan_.rest()));
    const double is = std::stod(figure);
    const auto numbers = numbers_in(figure);
    if (std::ranges::find(constants, is) == constants.end() && !sources_.is_known(numbers.at(0)))
      throw std::runtime_error(figure + " is not in the results");
    return is;
  }

  /// What stands in the brackets of a function.
  List list() {
    const std::string_view inside = scan_.rest().substr(0, scan_.rest().find(')'));
    if (inside.find(" of ") != inside.npos) {
      scan_.to(scan_.place() + inside.size() + 1);
      return column_said(std::string(inside));
    }
    List values;
    do
      values.push_back(sum());
    while (take(","));
    if (!take(")"))
      throw std::runtime_error("a ) is missing");
    return values;
  }

  List column_said(const std::string& text) const {
    std::istringstream in(text);
    std::string title, of, file, word;
    in >> title >> of >> file;
    std::vector<std::string> words;
    if (in >> word && word != "for")
      throw std::runtime_error("not understood: " + word);
    while (in >> word)
      words.push_back(word);
    return column(sources_.folder / file, title, words);
  }

  Scanner scan_;
  const Sources& sources_;
};

} // namespace

double derive(std::string_view expression, const Sources& sources) {
  return Expression(expression, sources).value();
}

} // namespace readme
