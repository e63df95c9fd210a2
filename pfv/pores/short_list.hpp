#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>

namespace pfv {

/// A vector of at most `capacity` values that are stored in place, so that it never allocates.
template <typename T, std::size_t capacity>
class ShortList {
public:
  ShortList() = default;
  ShortList(std::initializer_list<T> values) {
    for (const T& value : values)
      push_back(value);
  }

  void push_back(const T& value) {
    assert(size_ < capacity);
    values_[size_++] = value;
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t n) { return values_[n]; }
  const T& operator[](std::size_t n) const { return values_[n]; }

private:
  std::array<T, capacity> values_;
  std::size_t size_ = 0;
};

} // namespace pfv
