#include "reference/openfoam/foam_reader.hpp"

#include "pfv/problem/error.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace reference::openfoam {

FoamReader::FoamReader(const std::filesystem::path& file) : file_(file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw pfv::SolveError(fmt::format("OpenFOAM wrote no {}", file.filename().string()));
  text_.assign(std::istreambuf_iterator<char>(in), {});
}

void FoamReader::fail(const std::string& wanted) const {
  throw pfv::SolveError(fmt::format("OpenFOAM's file {} has no {} at byte {} of {}", file_.filename().string(), wanted,
                                    position_, text_.size()));
}

void FoamReader::skip_past(std::string_view word) {
  const auto found = text_.find(word, position_);
  if (found == std::string::npos)
    fail(fmt::format("'{}'", word));
  position_ = found + word.size();
}

void FoamReader::skip_space() {
  while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])))
    ++position_;
}

bool FoamReader::next_is(char character) {
  skip_space();
  return position_ < text_.size() && text_[position_] == character;
}

void FoamReader::expect(char character) {
  if (!next_is(character))
    fail(fmt::format("'{}'", character));
  ++position_;
}

std::string FoamReader::word() {
  skip_space();
  const auto end = std::min(text_.find_first_of(" \t\n\r(){};", position_), text_.size());
  const std::string found = text_.substr(position_, end - position_);
  position_ = end;
  return found;
}

double FoamReader::number() {
  skip_space();
  double value = 0;
  const auto [end, error] = std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
  if (error != std::errc{})
    fail("number");
  position_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

std::size_t FoamReader::count() {
  skip_space();
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
  if (error != std::errc{})
    fail("count");
  position_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

pfv::Vec3 FoamReader::vector() {
  expect('(');
  const double x = number();
  const double y = number();
  const double z = number();
  expect(')');
  return {x, y, z};
}

std::vector<std::size_t> FoamReader::counts() {
  const std::size_t size = count();
  if (next_is('{')) {
    expect('{');
    return std::vector<std::size_t>(size, count());
  }
  expect('(');
  std::vector<std::size_t> values(size);
  for (std::size_t& value : values)
    value = count();
  expect(')');
  return values;
}

template <class Value, class Read>
std::vector<Value> FoamReader::field(std::size_t size, Read read) {
  const std::string kind = word();
  if (kind == "uniform")
    return std::vector<Value>(size, read());
  if (kind != "nonuniform")
    fail("'uniform' or 'nonuniform'");
  word(); // List<scalar> or List<vector>
  if (count() != size)
    fail(fmt::format("list of {}", size));
  std::vector<Value> values(size);
  if (size == 0)
    return values;
  expect('(');
  for (Value& value : values)
    value = read();
  expect(')');
  return values;
}

std::vector<double> FoamReader::scalar_field(std::size_t size) {
  return field<double>(size, [this] { return number(); });
}

std::vector<pfv::Vec3> FoamReader::vector_field(std::size_t size) {
  return field<pfv::Vec3>(size, [this] { return vector(); });
}

} // namespace reference::openfoam
