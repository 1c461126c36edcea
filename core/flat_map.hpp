#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace weft {

/// Keeps a sorted map in two rows, keys and values: quick to search, to walk and to copy; slow to change in the
/// middle. Has what we use of std::flat_map (C++23). Any change moves values: pointers to them hold until then.
template <class Key, class Value>
class FlatMap {
  template <class Map, class Held>
  class Iterator {
   public:
    using value_type = std::pair<Key, Value>;
    using reference = std::pair<const Key&, Held&>;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;
    struct Arrow {
      reference entry;
      const reference* operator->() const { return &entry; }
    };

    Iterator() = default;
    Iterator(Map* map, std::size_t at) : map_(map), at_(at) {}
    reference operator*() const { return {map_->keys_[at_], map_->values_[at_]}; }
    Arrow operator->() const { return {**this}; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return std::exchange(*this, Iterator(map_, at_ + 1)); }
    bool operator==(const Iterator&) const = default;

   private:
    Map* map_ = nullptr;
    std::size_t at_ = 0;
  };

 public:
  using iterator = Iterator<FlatMap, Value>;
  using const_iterator = Iterator<const FlatMap, const Value>;

  std::size_t size() const { return keys_.size(); }
  bool empty() const { return keys_.empty(); }
  iterator begin() { return {this, 0}; }
  iterator end() { return {this, size()}; }
  const_iterator begin() const { return {this, 0}; }
  const_iterator end() const { return {this, size()}; }

  const_iterator find(const Key& key) const { return {this, position(key)}; }
  bool contains(const Key& key) const { return position(key) != size(); }
  /// Returns the key's value; null when there is none.
  const Value* value(const Key& key) const {
    const std::size_t at = position(key);
    return at == size() ? nullptr : &values_[at];
  }
  /// Returns the key's position in the order of keys; size() when there is none.
  std::size_t position(const Key& key) const {
    const std::size_t at = lower_bound(key);
    return at < size() && keys_[at] == key ? at : size();
  }
  /// Return the key and the value at a position in the order of keys; `at` < size().
  const Key& key_at(std::size_t at) const { return keys_[at]; }
  const Value& value_at(std::size_t at) const { return values_[at]; }
  bool operator==(const FlatMap&) const = default;

  void reserve(std::size_t count) {
    keys_.reserve(count);
    values_.reserve(count);
  }
  /// Adds an entry. Returns false, with nothing done, when the key is there already.
  bool emplace(const Key& key, Value value) {
    const std::size_t at = lower_bound(key);
    if (at < size() && keys_[at] == key) return false;
    insert(at, key, std::move(value));
    return true;
  }
  void insert_or_assign(const Key& key, Value value) {
    const std::size_t at = lower_bound(key);
    if (at < size() && keys_[at] == key) {
      values_[at] = std::move(value);
    } else {
      insert(at, key, std::move(value));
    }
  }
  /// Erases all at once: linear, however many they are. Keys that are not there do not matter.
  void erase_all(std::vector<Key> keys) {
    if (keys.empty()) return;
    std::sort(keys.begin(), keys.end());
    std::size_t kept = 0;
    for (std::size_t at = 0; at < size(); ++at) {
      if (std::binary_search(keys.begin(), keys.end(), keys_[at])) continue;
      if (kept != at) {
        keys_[kept] = std::move(keys_[at]);
        values_[kept] = std::move(values_[at]);
      }
      ++kept;
    }
    keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(kept), keys_.end());
    values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(kept), values_.end());
  }

 private:
  std::size_t lower_bound(const Key& key) const {
    if (keys_.empty() || keys_.back() < key) return size();  // what comes in order goes to the end
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }
  void insert(std::size_t at, const Key& key, Value&& value) {
    keys_.insert(keys_.begin() + static_cast<std::ptrdiff_t>(at), key);
    values_.insert(values_.begin() + static_cast<std::ptrdiff_t>(at), std::move(value));
  }

  std::vector<Key> keys_;
  std::vector<Value> values_;
};

}  // namespace weft
