#include "reference/unavailable_method.hpp"

#include "pfv/problem/error.hpp"

#include <utility>

namespace reference {

namespace {

class UnavailableMethod : public Method {
public:
  UnavailableMethod(std::string name, std::string description, std::string reason)
      : name_(std::move(name)), description_(std::move(description)), reason_(std::move(reason)) {}

  std::string name() const override { return name_; }
  std::string description() const override { return description_; }
  std::optional<std::string> unavailable() const override { return reason_; }
  std::optional<std::string> not_covered(const pfv::Case&) const override { return std::nullopt; }
  Estimate estimate(const pfv::Case&, const Request&) const override { return {}; }
  Answer solve(const pfv::Case&, const Request&, pfv::Clock&) const override {
    throw pfv::SolveError(name_ + " is unavailable: " + reason_);
  }

private:
  std::string name_;
  std::string description_;
  std::string reason_;
};

} // namespace

std::unique_ptr<Method> make_unavailable(std::string name, std::string description, std::string reason) {
  return std::make_unique<UnavailableMethod>(std::move(name), std::move(description), std::move(reason));
}

} // namespace reference
