#pragma once
#include <compare>
#include <cstddef>
#include <iterator>

namespace weft {

/// Walks a row that has `operator[]` giving `const Row::value_type&`. Holds as long as the row stands where it is.
template <class Row>
class RowIterator {
 public:
  using value_type = typename Row::value_type;
  using reference = const value_type&;
  using pointer = const value_type*;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::random_access_iterator_tag;

  RowIterator() = default;
  RowIterator(const Row* row, std::size_t at) : row_(row), at_(static_cast<difference_type>(at)) {}

  reference operator*() const { return (*row_)[static_cast<std::size_t>(at_)]; }
  pointer operator->() const { return &**this; }
  reference operator[](difference_type by) const { return *(*this + by); }
  RowIterator& operator+=(difference_type by) {
    at_ += by;
    return *this;
  }
  RowIterator& operator-=(difference_type by) { return *this += -by; }
  RowIterator& operator++() { return *this += 1; }
  RowIterator& operator--() { return *this -= 1; }
  RowIterator operator++(int) {
    const RowIterator before = *this;
    ++*this;
    return before;
  }
  RowIterator operator--(int) {
    const RowIterator before = *this;
    --*this;
    return before;
  }
  friend RowIterator operator+(RowIterator at, difference_type by) { return at += by; }
  friend RowIterator operator+(difference_type by, RowIterator at) { return at += by; }
  friend RowIterator operator-(RowIterator at, difference_type by) { return at -= by; }
  friend difference_type operator-(const RowIterator& a, const RowIterator& b) { return a.at_ - b.at_; }
  bool operator==(const RowIterator& other) const { return at_ == other.at_; }
  std::strong_ordering operator<=>(const RowIterator& other) const { return at_ <=> other.at_; }

 private:
  const Row* row_ = nullptr;
  difference_type at_ = 0;
};

}  // namespace weft
