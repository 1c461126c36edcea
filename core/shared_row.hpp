#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/row_iterator.hpp"

namespace weft {

/// Keeps a row of values in chunks that its copies share: cheap to copy and to add to at the end, quick to read
/// anywhere. Values are never changed in place. T can be default-constructed.
template <class T>
class SharedRow {
 public:
  using value_type = T;
  using const_iterator = RowIterator<SharedRow>;
  static constexpr std::size_t kChunk = 256;

  SharedRow() = default;
  explicit SharedRow(std::vector<T> values) { append(std::move(values)); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t at) const { return chunks_[at / kChunk].get()[at % kChunk]; }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size_ - 1]; }
  const_iterator begin() const { return {this, 0}; }
  const_iterator end() const { return {this, size_}; }
  bool operator==(const SharedRow& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

  /// Copies the last chunk, if it is not full, and nothing else.
  void append(std::vector<T> values) {
    std::size_t taken = 0;
    while (taken < values.size()) {
      const std::size_t kept = size_ % kChunk;  // in a last chunk that has room
      const std::size_t more = std::min(kChunk - kept, values.size() - taken);
      auto chunk = std::make_shared<T[]>(kept + more);
      if (kept > 0) {
        std::copy_n(chunks_.back().get(), kept, chunk.get());
        chunks_.pop_back();
      }
      std::move(values.begin() + static_cast<std::ptrdiff_t>(taken),
                values.begin() + static_cast<std::ptrdiff_t>(taken + more), chunk.get() + kept);
      chunks_.push_back(std::move(chunk));
      size_ += more;
      taken += more;
    }
  }
  void push_back(T value) {
    std::vector<T> one;
    one.push_back(std::move(value));
    append(std::move(one));
  }
  /// Puts new `values` at the positions that are their keys, all within the row. Chunks without any stay shared.
  void replace(const std::map<std::size_t, T>& values) {
    for (auto at = values.begin(); at != values.end();) {
      const std::size_t chunk = at->first / kChunk;
      const std::size_t held = std::min(kChunk, size_ - chunk * kChunk);
      auto copy = std::make_shared<T[]>(held);
      std::copy_n(chunks_[chunk].get(), held, copy.get());
      for (; at != values.end() && at->first / kChunk == chunk; ++at) copy[at->first % kChunk] = at->second;
      chunks_[chunk] = std::move(copy);
    }
  }
  /// Erases the values that `goes` holds for. Chunks before the first one that goes stay shared.
  template <class Goes>
  void erase_if(Goes&& goes) {
    const auto first = static_cast<std::size_t>(std::find_if(begin(), end(), goes) - begin());
    if (first == size_) return;
    const std::size_t keep = first / kChunk;
    std::vector<T> rest;
    for (std::size_t at = keep * kChunk; at < size_; ++at) {
      if (!goes((*this)[at])) rest.push_back((*this)[at]);
    }
    chunks_.resize(keep);
    size_ = keep * kChunk;
    append(std::move(rest));
  }

 private:
  std::vector<std::shared_ptr<const T[]>> chunks_;  ///< all full but the last
  std::size_t size_ = 0;
};

/// Keeps a row of values each of which copies share: cheap to put in another order, to thin, and to have in two rows.
template <class T>
class SharedItems {
 public:
  using value_type = T;
  using const_iterator = RowIterator<SharedItems>;
  using Item = std::shared_ptr<const T>;

  std::size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  const T& operator[](std::size_t at) const { return *items_[at]; }
  const_iterator begin() const { return {this, 0}; }
  const_iterator end() const { return {this, size()}; }

  void push_back(Item item) { items_.push_back(std::move(item)); }
  template <class Goes>
  void erase_if(Goes&& goes) {
    std::erase_if(items_, [&](const Item& item) { return goes(*item); });
  }
  template <class Before>
  void sort(Before&& before) {
    const auto in_order = [&](const Item& a, const Item& b) { return before(*a, *b); };
    if (!std::is_sorted(items_.begin(), items_.end(), in_order)) std::sort(items_.begin(), items_.end(), in_order);
  }
  void shrink_to_fit() { items_.shrink_to_fit(); }

 private:
  std::vector<Item> items_;
};

}  // namespace weft
