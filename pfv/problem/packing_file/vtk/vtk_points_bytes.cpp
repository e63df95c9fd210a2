#include "pfv/problem/packing_file/vtk/vtk_points_bytes.hpp"

#include <cassert>
#include <cstring>
#include <span>

namespace pfv {
namespace {

class Writer {
public:
  void put(std::size_t count) { put_raw(&count, sizeof count); }
  void put(std::span<const double> values) {
    put(values.size());
    put_raw(values.data(), values.size_bytes());
  }
  void put(const std::vector<VtkArray>& arrays) {
    put(arrays.size());
    for (const auto& [name, components, values] : arrays) {
      put(name.size());
      put_raw(name.data(), name.size());
      put(static_cast<std::size_t>(components));
      put(std::span(values));
    }
  }
  std::string bytes() && { return std::move(bytes_); }

private:
  void put_raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

class Reader {
public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::size_t count() {
    std::size_t count = 0;
    std::memcpy(&count, raw(sizeof count).data(), sizeof count);
    return count;
  }
  std::vector<double> values() {
    std::vector<double> values(count());
    const std::string_view bytes = raw(values.size() * sizeof(double));
    if (!bytes.empty())
      std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  std::vector<VtkArray> arrays() {
    std::vector<VtkArray> arrays(count());
    for (auto& [name, components, values_of] : arrays) {
      name = raw(count());
      components = static_cast<int>(count());
      values_of = values();
    }
    return arrays;
  }

private:
  std::string_view raw(std::size_t size) {
    assert(size <= rest_.size());
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  std::string_view rest_;
};

} // namespace

std::string bytes_of(const VtkPoints& points) {
  Writer writer;
  writer.put(points.coordinates);
  writer.put(points.of_points);
  writer.put(points.of_file);
  return std::move(writer).bytes();
}

VtkPoints vtk_points_in(std::string_view bytes) {
  Reader reader(bytes);
  VtkPoints points;
  points.coordinates = reader.values();
  points.of_points = reader.arrays();
  points.of_file = reader.arrays();
  return points;
}

} // namespace pfv
