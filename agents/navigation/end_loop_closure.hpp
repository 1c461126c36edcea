#pragma once
#include <cstdint>
#include <optional>

#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "agents/navigation/localised_around.hpp"
#include "agents/navigation/teacher.hpp"

namespace weft::agents {

/// Finds where the end of a run that measures no poses has come back to. The way there says nothing of it, so every
/// place of the map is held against the last one. Each is then localised around the other, as a path's beginning and
/// end have neighbours on one side only, and what both say is weighed. `map` holds the kept place.
template <ChartsItself M>
class EndLoopClosure {
 public:
  using Content = typename M::Content;

  EndLoopClosure(const M& method, const NavigationConfig& config, const Window& map, const Contents& bytes,
                 DecodedContents<M>& decoded)
      : method_(method), config_(config), map_(map), bytes_(bytes), decoded_(decoded) {}

  /// Finds what the run has come back to at its last place, `kept`. Refused: "nothing_alike", "unsure_how_far"
  /// (measured and bound: sigma, metres), and those of `locate`.
  OrRefusal<Fix> look(const Teacher& teacher, const PlaceId& kept, const Content& content) {
    const std::optional<Fix> likeliest = most_alike(teacher, kept, content);
    if (!likeliest) return tl::unexpected(Refusal{"nothing_alike"});
    OrRefusal<Fix> found = localised({likeliest->place, likeliest->place_from_robot, 0.0}, content);
    if (!found) return found;
    const auto there = decoded_.find(*map_.place(found->place), bytes_);
    if (!there) return tl::unexpected(there.error());
    const OrRefusal<Fix> back = localised({kept, inverse(found->place_from_robot), 0.0}, **there);
    if (back) {
      const auto kept_from_place = between(config_.belief, map_, kept, back->place, config_.locate.most_hops);
      if (kept_from_place) {
        found->place_from_robot =
            fuse(found->place_from_robot, inverse(compose(*kept_from_place, back->place_from_robot)));
        found->evidence.a_from_b = found->place_from_robot;
      }
    }
    const double sigma_m = spread_of(found->place_from_robot).metres;
    if (sigma_m > config_.stitch.sure_m)
      return tl::unexpected(Refusal{"unsure_how_far", sigma_m, config_.stitch.sure_m});
    return found;
  }

 private:
  std::optional<Fix> most_alike(const Teacher& teacher, const PlaceId& kept, const Content& content) {
    std::optional<Fix> likeliest;
    for (const auto& [id, place] : map_.places) {
      const bool is_own = id.experience == kept.experience;
      if (is_own && (id.index >= kept.index || teacher.driven_since_m(id.index) < config_.stitch.own_distance_m))
        continue;
      const auto other = decoded_.find(place, bytes_);
      if (!other) continue;
      const OrRefusal<Related> related = method_.relate(**other, content, std::nullopt);
      if (related && (!likeliest || related->inliers > likeliest->evidence.inliers))
        likeliest = Fix{id, related->a_from_b, *related};
    }
    return likeliest;
  }

  OrRefusal<Fix> localised(const Estimate& at, const Content& content) {
    return localised_around(method_, map_, bytes_, decoded_, at, content);
  }

  const M& method_;
  const NavigationConfig& config_;
  const Window& map_;
  const Contents& bytes_;
  DecodedContents<M>& decoded_;
};

}  // namespace weft::agents
