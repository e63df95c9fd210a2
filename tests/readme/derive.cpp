#include "readme/derive.hpp"

#include "readme/scanner.hpp"

#include <array>
#include <stdexcept>

namespace readme {

namespace {

constexpr std::array constants{1.0, 2.0, 60.0, 100.0, 1000.0};

class Expression {
public:
  Expression(std::string_view text, const std::function<bool(const Number&)>& is_known)
      : scan_(text), is_known_(is_known) {}

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
      else if (take("*") || scan_.now() == '(' || digit(scan_.now()))
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
    const std::string figure = scan_.figure();
    if (figure.empty())
      throw std::runtime_error("not understood: " + std::string(scan_.rest()));
    const double is = std::stod(figure);
    const auto numbers = numbers_in(figure);
    if (std::ranges::find(constants, is) == constants.end() && !is_known_(numbers.at(0)))
      throw std::runtime_error(figure + " is not in the results");
    return is;
  }

  Scanner scan_;
  const std::function<bool(const Number&)>& is_known_;
};

} // namespace

double derive(std::string_view expression, const std::function<bool(const Number&)>& is_known) {
  return Expression(expression, is_known).value();
}

} // namespace readme
