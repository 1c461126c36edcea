#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "agents/navigation/candidates.hpp"
#include "agents/navigation/decoded_contents.hpp"

namespace weft::agents {

/// Holds the view by which a robot seems to stand somewhere against every place of the window, some of them at a
/// time: one elsewhere may be as much like it. Places along the same way look alike where things are far off; of them
/// none may be more like it.
template <ComparesRivals M>
class Rivals {
 public:
  using Content = typename M::Content;

  explicit Rivals(const M& method) : method_(&method) {}

  /// Returns whether places are left to be looked at.
  bool is_open() const { return seen_.has_value(); }
  void close() { *this = Rivals(*method_); }

  /// Begins with a view that seems to be of `at`. `left_out`: runs that nobody looks for.
  void begin(const NavigationConfig& config, const Window& map, const PlaceId& at, const Content& seen,
             const std::set<ExperienceId>& left_out) {
    constexpr double near_m = 1.0;
    close();
    seen_ = seen;
    std::map<PlaceId, double> along;  // metres
    const Estimate there{at, AlongPath{}, 0.0};
    for (const Candidate& one : at_any_heading(config, map, there, config.locate.most_hops, config.locate.rival_m))
      if (const double apart_m = distance_m(one.place_from_robot); apart_m <= config.locate.rival_m)
        along.emplace(one.place, apart_m);
    for (const auto& [id, place] : map.places)
      if (!left_out.contains(id.experience) && !along.contains(id)) left_.push_back(id);
    elsewhere_ = left_.size();
    for (const auto& [id, apart_m] : along)
      if (apart_m > near_m) left_.push_back(id);
    not_near_ = left_.size();
    for (const auto& [id, apart_m] : along)
      if (apart_m <= near_m) left_.push_back(id);
  }

  /// Looks at some. Refused, and not open any more: "looks_like_another" (measured and bound: likeness). "weighing"
  /// (how many are left) until all were looked at.
  OrRefusal<void> look(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, std::uint32_t& tries) {
    for (; tries > 0 && !left_.empty(); --tries) {
      const PlaceId id = left_.back();
      left_.pop_back();
      const Place* const place = map.place(id);
      if (place == nullptr) continue;
      if (const auto content = decoded.find(*place, bytes)) {
        const double likeness = method_->likeness(**content, *seen_);
        if (left_.size() >= not_near_) likeness_ = std::max(likeness_, likeness);
        const double bound = most_now();
        if (likeness <= bound) continue;
        close();
        return tl::unexpected(Refusal{"looks_like_another", likeness, bound});
      }
      const bool may_come = left_.size() < elsewhere_ && bytes.find(place->content.hash) == nullptr;
      if (may_come) missing_.push_back(id);
    }
    constexpr std::uint32_t patience = 60;  // samples for contents that have not arrived
    if (left_.empty() && !missing_.empty() && waited_++ < patience) {
      left_.swap(missing_);
      elsewhere_ = not_near_ = left_.size();
    }
    if (!left_.empty()) return tl::unexpected(Refusal{"weighing", static_cast<double>(left_.size()), 0.0});
    close();
    return {};
  }

 private:
  /// Returns the likeness up to which the place that was taken off last is no rival.
  double most_now() const { return left_.size() >= elsewhere_ ? likeness_ : method_->most_of_rival(likeness_); }

  const M* method_;
  std::optional<Content> seen_;
  std::vector<PlaceId> left_;     // the next one last: near, along the way, elsewhere
  std::size_t elsewhere_ = 0;     // of left_, at its beginning
  std::size_t not_near_ = 0;      // likewise
  std::vector<PlaceId> missing_;  // contents that have not arrived
  double likeness_ = 0.0;         // of where it seems to stand, the most
  std::uint32_t waited_ = 0;
};

/// Stands in for methods that do not compare rivals.
struct NoRivals {
  template <class M>
  explicit NoRivals(const M&) {}
  void close() {}
};
template <class M>
struct RivalsOrNone {
  using Type = NoRivals;
};
template <ComparesRivals M>
struct RivalsOrNone<M> {
  using Type = Rivals<M>;
};

}  // namespace weft::agents
