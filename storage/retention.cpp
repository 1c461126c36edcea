#include "storage/retention.hpp"

#include <algorithm>

namespace weft::storage {

Retention::Retention(Revision floor, const std::map<Revision, Revision>& bases) : floor_(floor) {
  roots_.emplace_back(floor, bases);
  for (auto rollback = bases.upper_bound(floor); rollback != bases.end(); ++rollback) {
    if (rollback->second < floor) roots_.emplace_back(rollback->first, bases);
  }
}

void PlaceRetention::Marks::set(std::uint32_t first, std::uint32_t last, bool value) {
  const std::uint64_t behind = std::uint64_t{last} + 1;
  const auto next = from_.upper_bound(behind);
  const bool after = next != from_.begin() && std::prev(next)->second;
  from_.erase(from_.lower_bound(first), next);
  from_[first] = value;
  from_[behind] = after;
}

bool PlaceRetention::Marks::at(std::uint32_t index) const {
  const auto next = from_.upper_bound(index);
  return next != from_.begin() && std::prev(next)->second;
}

PlaceRetention::PlaceRetention(const Retention& retention, const std::vector<MovedStretch>& moves)
    : retention_(&retention), out_(retention.roots().size()) {
  for (const MovedStretch& move : moves) {
    for (std::size_t root = 0; root < out_.size(); ++root) {
      if (!retention.roots()[root].contains(move.revision)) continue;
      out_[root].set(move.first, move.last, !move.is_back);
    }
    if (move.revision > retention.floor().value) touched_.set(move.first, move.last, true);
  }
}

bool PlaceRetention::keeps(std::uint32_t index, std::uint64_t revision) const {
  if (revision > retention_->floor().value || touched_.at(index)) return true;
  for (std::size_t root = 0; root < out_.size(); ++root) {
    if (retention_->roots()[root].contains(revision) && !out_[root].at(index)) return true;
  }
  return false;
}

bool LatestRetention::keeps(std::uint64_t revision, const std::vector<Moved>& moves) {
  bool is_needed = revision > retention_->floor().value;
  for (std::size_t root = 0; root < is_superseded_.size(); ++root) {
    const Lineage& lineage = retention_->roots()[root];
    if (!lineage.contains(revision)) continue;
    const Moved* last = nullptr;
    for (const Moved& move : moves) {
      if (lineage.contains(move.revision)) last = &move;
    }
    const bool is_out = last != nullptr && !last->is_back && revision <= last->revision;
    is_needed = is_needed || (!is_superseded_[root] && !is_out);
    is_superseded_[root] = true;
  }
  const auto can_come_back = [&](const Moved& move) { return move.revision > retention_->floor().value; };
  return is_needed || std::ranges::any_of(moves, can_come_back);
}

std::vector<Stretch> joined(std::vector<Stretch> stretches) {
  std::ranges::sort(stretches);
  std::vector<Stretch> all;
  for (const Stretch& stretch : stretches) {
    if (!all.empty() && std::uint64_t{stretch.first} <= std::uint64_t{all.back().last} + 1) {
      all.back().last = std::max(all.back().last, stretch.last);
    } else {
      all.push_back(stretch);
    }
  }
  return all;
}

}  // namespace weft::storage
