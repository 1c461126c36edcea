#include <algorithm>
#include <utility>

#include "core/network/routing/cells.hpp"
#include "core/network/routing/draft.hpp"
#include "core/network/routing/routing.hpp"
#include "core/network/routing/work.hpp"

namespace weft::routing {
namespace {

constexpr std::size_t kLookedAt = 64;  ///< places in one piece

/// Returns the experiences that one of the snapshots has and the other has not, or not as it is.
std::vector<ExperienceId> differing(const Snapshot& a, const Snapshot& b) {
  std::vector<ExperienceId> ids;
  auto in_a = a.experiences().begin();
  auto in_b = b.experiences().begin();
  while (in_a != a.experiences().end() || in_b != b.experiences().end()) {
    const bool take_a =
        in_b == b.experiences().end() || (in_a != a.experiences().end() && in_a->first <= in_b->first);
    const bool take_b =
        in_a == a.experiences().end() || (in_b != b.experiences().end() && in_b->first <= in_a->first);
    if (!take_a || !take_b || in_a->second != in_b->second) ids.push_back(take_a ? in_a->first : in_b->first);
    if (take_a) ++in_a;
    if (take_b) ++in_b;
  }
  return ids;
}

/// Visits the values of a row but for the chunks that another row shares.
template <class T, class Visit>
void for_each_unshared(const SharedRow<T>& row, const SharedRow<T>& other, Visit&& visit) {
  for (std::size_t first = 0; first < row.size(); first += SharedRow<T>::kChunk) {
    if (first < other.size() && &row[first] == &other[first]) continue;
    const std::size_t end = std::min(row.size(), first + SharedRow<T>::kChunk);
    for (std::size_t at = first; at < end; ++at) visit(row[at]);
  }
}

/// Visits the items that one of two rows, both sorted by id, has and the other has not, or not the same.
template <class Visit>
void for_each_unshared(const SharedItems<Edge>& a, const SharedItems<Edge>& b, Visit&& visit) {
  std::size_t in_a = 0;
  std::size_t in_b = 0;
  while (in_a < a.size() || in_b < b.size()) {
    if (in_a < a.size() && in_b < b.size() && &a[in_a] == &b[in_b]) {
      ++in_a;
      ++in_b;
    } else if (in_b == b.size() || (in_a < a.size() && a[in_a].id <= b[in_b].id)) {
      visit(a[in_a++]);
    } else {
      visit(b[in_b++]);
    }
  }
}

/// Brings a preparation from its network to another revision of it: places that went lose their nodes, new ones get
/// theirs, places whose edges may have changed are looked at, and cells in which something did are made anew.
class Revising final : public Work {
 public:
  Revising(const Preparation& preparation, const Snapshot& snapshot)
      : before_(preparation.of), draft_(turned_to(preparation, snapshot)), ids_(differing(before_, snapshot)) {}

  std::size_t piece() override {
    if (removed_ < ids_.size()) return remove_from(ids_[removed_++]);
    if (added_ < ids_.size()) return add_from(ids_[added_++]);
    if (looked_ < touched_.size()) return look();
    return draft_.step();
  }

  double share_done() const override {
    const double experiences =
        ids_.empty() ? 1.0 : static_cast<double>(removed_ + added_) / (2.0 * static_cast<double>(ids_.size()));
    const double looks =
        touched_.empty() ? experiences : static_cast<double>(looked_) / static_cast<double>(touched_.size());
    return 0.25 * (experiences + looks) + 0.5 / static_cast<double>(1 + draft_.left_to_do());
  }

  Preparation take() override { return draft_.take(); }

 private:
  static Preparation turned_to(Preparation preparation, const Snapshot& snapshot) {
    preparation.of = snapshot;
    return preparation;
  }
  const Snapshot& now() const { return draft_.preparation().of; }
  const Experience& or_none(const Experience* experience) const {
    return experience == nullptr ? none_ : *experience;
  }

  std::size_t remove_from(ExperienceId id) {
    const Experience* const old = before_.experience(id);
    if (old == nullptr) return 1;
    const Experience& left = or_none(now().experience(id));
    std::size_t seen = 1;
    for_each_unshared(old->places, left.places, [&](const Place& place) {
      ++seen;
      if (now().place(place.id) == nullptr) draft_.remove(place.id);
    });
    return seen;
  }

  std::size_t add_from(ExperienceId id) {
    const Experience& old = or_none(before_.experience(id));
    const Experience& here = or_none(now().experience(id));
    std::size_t seen = 1;
    const auto touch = [&](const Edge& edge) {
      ++seen;
      touched_.push_back(edge.id.a);
      touched_.push_back(edge.id.b);
    };
    for_each_unshared(here.places, old.places, [&](const Place& place) {
      ++seen;
      touched_.push_back(place.id);
      if (draft_.preparation().node(place.id) == kNoNode) draft_.add(place.id);
    });
    for_each_unshared(here.chain, old.chain, touch);
    for_each_unshared(old.chain, here.chain, touch);
    for_each_unshared(old.stitches, here.stitches, touch);
    if (added_ == ids_.size()) {
      std::sort(touched_.begin(), touched_.end());
      touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    }
    return seen;
  }

  std::size_t look() {
    const std::size_t end = std::min(touched_.size(), looked_ + kLookedAt);
    for (; looked_ < end; ++looked_) {
      const Node node = draft_.preparation().node(touched_[looked_]);
      if (node != kNoNode && !is_joined(draft_.preparation(), node)) draft_.mark(cell_of(node));
    }
    return kLookedAt;
  }

  const Experience none_{};
  Snapshot before_;
  Draft draft_;
  std::vector<ExperienceId> ids_;
  std::size_t removed_ = 0;
  std::size_t added_ = 0;
  std::vector<PlaceId> touched_;
  std::size_t looked_ = 0;
};

}  // namespace

Builder Builder::to_update(const Preparation& preparation, const Snapshot& snapshot) {
  return Builder(std::make_unique<Revising>(preparation, snapshot));
}

Preparation update(const Preparation& preparation, const Snapshot& snapshot) {
  return Builder::to_update(preparation, snapshot).finish();
}

}  // namespace weft::routing
