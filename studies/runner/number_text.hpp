#pragma once

#include <optional>
#include <string>

namespace studies {

/// Numbers as tables show them; rows and answers keep all digits.

/// "3.2 %", "-45 %", "0.04 %"; "n.a." when it is not finite.
std::string percent(double fraction);

/// "(1.234 ± 0.012)e-3", two digits of the error and at most six decimals; without an error four digits.
std::string with_error(double value, std::optional<double> error);

/// "45", "11093", "1.2e6": whole below a million, two digits above.
std::string count(double value);

/// "2.2e-4", "0.0046", "0.091", "2.2", "300": two digits, no more.
std::string seconds(double value);

/// "45 MB", "2.1 GB".
std::string bytes(double value);

} // namespace studies
