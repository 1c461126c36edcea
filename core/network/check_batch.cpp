#include <cmath>
#include <set>

#include "core/network/change.hpp"
#include "core/utf8.hpp"

namespace weft {
namespace {

/// Collects what is wrong with one batch; each reason names the entity.
class Checker {
 public:
  Checker(const Snapshot& snapshot, const Batch& batch)
      : snapshot_(snapshot), batch_(batch), known_(snapshot.experience(batch.experience)) {
    if (known_ != nullptr) first_new_ = known_->extent;
  }

  std::vector<Error> run() {
    check_head();
    if (!errors_.empty()) return std::move(errors_);  // sizes are bounded only from here on
    for (std::size_t i = 0; i < batch_.places.size(); ++i) check_place(i);
    for (const Place& place : batch_.learned) check_learned(place);
    for (const Edge& edge : batch_.edges) check_edge(edge);
    check_chain();
    return std::move(errors_);
  }

 private:
  void wrong(ErrorCode code, const std::string& what) { errors_.push_back({code, "batch: " + what}); }

  void check_text(const char* field, const std::string& text, std::size_t fewest, std::size_t most) {
    if (text.size() < fewest || text.size() > most) {
      wrong(ErrorCode::invalid, std::string(field) + " has " + std::to_string(text.size()) + " bytes, must have " +
                                    std::to_string(fewest) + " to " + std::to_string(most));
    }
    const bool is_shown =
        std::none_of(text.begin(), text.end(), [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; });
    if (!is_utf8(text) || !is_shown) {
      wrong(ErrorCode::invalid, std::string(field) + " has a character that is not printable, or no UTF-8");
    }
  }

  void check_most(const char* field, std::size_t count, std::size_t most) {
    if (count > most) {
      wrong(ErrorCode::invalid, "has " + std::to_string(count) + " " + field + ", at most " + std::to_string(most) +
                                    " are allowed; send smaller batches");
    }
  }

  void check_head() {
    if (!batch_.experience) wrong(ErrorCode::invalid, "has no experience id");
    if (!batch_.robot) wrong(ErrorCode::invalid, "has no robot id");
    if (batch_.sequence == 0) wrong(ErrorCode::invalid, "sequence is 0, counts from 1");
    check_text("name", batch_.name, 0, kLongestName);
    check_text("method", batch_.method, 1, kLongestName);
    check_text("seal reason", batch_.seal_reason, 0, kLongestReason);
    check_most("places", batch_.places.size() + batch_.learned.size(), kBatchPlaces);
    check_most("edges", batch_.edges.size(), kBatchEdges);
    if (known_ == nullptr) return;
    if (first_new_ > 0 && known_->place(first_new_ - 1) == nullptr) {
      wrong(ErrorCode::conflict,
            "experience " + to_string(batch_.experience) + " was taken out of the map; begin a new one");
    }
    if (known_->sealed) {
      wrong(ErrorCode::conflict, "experience " + to_string(batch_.experience) + " is sealed: " + known_->seal_reason);
    }
    if (known_->robot != batch_.robot) wrong(ErrorCode::conflict, "the experience belongs to another robot");
    if (known_->method != batch_.method) wrong(ErrorCode::conflict, "the experience has method " + known_->method);
  }

  void check_place(std::size_t position) {
    const Place& place = batch_.places[position];
    const std::string name = "place " + to_string(place.id);
    const std::uint64_t expected = first_new_ + position;
    if (place.id.experience != batch_.experience) wrong(ErrorCode::invalid, name + " is of another experience");
    if (place.id.index != expected) {
      wrong(ErrorCode::invalid, name + " leaves a gap or repeats: index must be " + std::to_string(expected));
    }
    if (place.entity_version == 0) wrong(ErrorCode::invalid, name + ": entity version is 0, counts from 1");
    if (place.method != batch_.method) wrong(ErrorCode::invalid, name + " has another method than its batch");
    check_content(place, name);
  }

  /// Checks a place known anew. Whether it comes in time shows when the batch joins.
  void check_learned(const Place& place) {
    const std::string name = "learned place " + to_string(place.id);
    if (place.id.experience == batch_.experience) {
      return wrong(ErrorCode::invalid, name + " is of the batch's own experience, which is known from its places");
    }
    if (!exists(place.id)) return wrong(ErrorCode::not_found, name + " does not exist");
    if (!learned_.insert(place.id).second) wrong(ErrorCode::invalid, name + " is there twice");
    if (place.entity_version < 2) {
      wrong(ErrorCode::invalid, name + ": entity version is " + std::to_string(place.entity_version) +
                                    "; what is learned is at least the second");
    }
    const Place* const known = snapshot_.place(place.id);
    if (known != nullptr && known->method != place.method) {
      wrong(ErrorCode::invalid, name + " has method " + known->method + ", not " + place.method);
    }
    check_content(place, name);
  }

  void check_content(const Place& place, const std::string& name) {
    if (place.robot != batch_.robot) wrong(ErrorCode::invalid, name + " is of another robot");
    if (!place.content.hash) wrong(ErrorCode::invalid, name + " has no content hash");
    if (place.content.size == 0 || place.content.size > kLargestContent) {
      wrong(ErrorCode::invalid, name + ": content size " + std::to_string(place.content.size) + " must be in [1, " +
                                    std::to_string(kLargestContent) + "]");
    }
  }

  /// Returns whether the map or the batch has a place, or had it: a robot may not have heard yet that it was taken
  /// out, and what the robot has seen beside it is not to be lost for that.
  bool exists(const PlaceId& id) const {
    const Experience* const known = snapshot_.experience(id.experience);
    if (known != nullptr && id.index < known->extent) return true;
    return id.experience == batch_.experience && id.index >= first_new_ &&
           id.index - first_new_ < batch_.places.size();
  }

  void check_edge(const Edge& edge) {
    const std::string name = "edge " + to_string(edge.id.a) + " - " + to_string(edge.id.b);
    if (edge.id.a == edge.id.b) return wrong(ErrorCode::invalid, name + " joins a place to itself");
    for (const PlaceId& end : {edge.id.a, edge.id.b}) {
      if (!exists(end)) wrong(ErrorCode::not_found, name + ": place " + to_string(end) + " does not exist");
    }
    const EdgeId pair = edge.id.a < edge.id.b ? edge.id : EdgeId{edge.id.b, edge.id.a};
    if (!pairs_.insert(pair).second) wrong(ErrorCode::invalid, name + " is there twice; one edge a pair");
    if (const auto checked = weft::check(edge.a_from_b); !checked) {
      wrong(ErrorCode::invalid, name + ": " + checked.error().message);
    }
    if (!(edge.overlap >= 0.0F && edge.overlap <= 1.0F)) {
      wrong(ErrorCode::invalid, name + ": overlap must be in [0, 1]");
    }
    if (edge.entity_version == 0) wrong(ErrorCode::invalid, name + ": entity version is 0, counts from 1");
    if (edge.drivable > Drivable::both) wrong(ErrorCode::invalid, name + ": unknown drivable");
    check_text("an edge's method", edge.method, 1, kLongestName);
    switch (edge.origin) {
      case Origin::odometry:
      case Origin::blind:
        return check_odometry(edge, name);
      case Origin::stitch:
        return check_stitch(edge, name);
    }
    wrong(ErrorCode::invalid, name + ": unknown origin");
  }

  void check_odometry(const Edge& edge, const std::string& name) {
    if (edge.id.a.experience != batch_.experience || edge.id.b.experience != batch_.experience) {
      return wrong(ErrorCode::invalid, name + ": odometry leaves the experience");
    }
    if (edge.id.b.index <= edge.id.a.index) {
      return wrong(ErrorCode::invalid, name + ": odometry runs backwards, a cycle; b must be the place after a");
    }
    if (edge.id.b.index - edge.id.a.index != 1) {
      return wrong(ErrorCode::invalid, name + ": odometry skips places, a cycle; b must be the place after a");
    }
    if (edge.id.b.index < first_new_) {
      return wrong(ErrorCode::conflict, name + ": both places are joined already");
    }
    chained_.insert(edge.id.b.index);
  }

  void check_stitch(const Edge& edge, const std::string& name) {
    const auto& [a, b] = edge.id;
    if (b.experience != batch_.experience) {
      wrong(ErrorCode::invalid, name + ": a stitch's b must be a place of the batch's experience");
    } else if (a.experience == b.experience && (a.index > b.index || b.index - a.index == 1)) {
      wrong(ErrorCode::invalid, name + ": a stitch's a must be an older place that odometry does not join to b");
    }
    bool there = false;
    snapshot_.for_each_edge(b, [&](const Edge& old) { there = there || old.id.a == a || old.id.b == a; });
    if (there) wrong(ErrorCode::conflict, name + ": both places are joined already");
  }

  /// Checks that every new place but the experience's first hangs on the one before it.
  void check_chain() {
    for (std::size_t i = 0; i < batch_.places.size(); ++i) {
      const std::uint32_t index = first_new_ + static_cast<std::uint32_t>(i);
      if (index > 0 && !chained_.contains(index)) {
        wrong(ErrorCode::invalid, "gap in odometry: no edge joins place " +
                                      to_string(PlaceId{batch_.experience, index}) + " to the one before it");
      }
    }
  }

  const Snapshot& snapshot_;
  const Batch& batch_;
  const Experience* known_;
  std::uint32_t first_new_ = 0;
  std::set<EdgeId> pairs_;
  std::set<std::uint32_t> chained_;
  std::set<PlaceId> learned_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> check(const Snapshot& snapshot, const Batch& batch) {
  return Checker(snapshot, batch).run();
}

}  // namespace weft
