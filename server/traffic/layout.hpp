#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/network/change.hpp"
#include "server/traffic/spread.hpp"

namespace weft::server {

/// Tells where a place lies in the frame of its part of the network. Exact until the layout changes; one that is kept
/// longer tells where the place lay.
struct Spot {
  std::uint32_t at = 0;  ///< the laid place that it is, or hangs on
  std::uint32_t part = 0;
  Pose2 part_from_place;
  Spread spread;
  double sigma_m = 0.0;  ///< the most that its position may be off against any place of the part
  double bend = 0.0;
};

/// Keeps where all places are: each part of the network that hangs together is laid out along the tree of least
/// uncertain relations from one of its places. How two places lie is known by the branches below the place where
/// these part: what comes before moves both alike.
class Layout {
 public:
  /// Makes an empty layout. `least_gain`: the share of its uncertainty that a laid place has to lose to be hung on
  /// another one.
  explicit Layout(double least_gain = 0.05) : keep_share_(1.0 - least_gain) {}

  using Network = std::shared_ptr<const Snapshot>;
  /// Begins anew: nothing is laid out any more, and all of it is to be. Parts begin at `roots`, where they are named.
  void lay(Network network, std::vector<PlaceId> roots = {});
  /// Lays out at once no more than so many places around one: those that are less uncertain from there.
  void lay_around(const Network& network, const PlaceId& root, std::size_t most);
  /// Takes in a batch that has joined the network.
  void joined(Network network, const Batch& batch);
  /// Takes in an edit: something left the network or came back, and the parts that had or have it are laid out anew.
  void edited(Network network, const Snapshot& before);

  /// Does one piece of work, of about as many places. Returns true when something was laid out that can be asked for.
  bool work(std::size_t places);
  bool has_work() const { return network_ != nullptr; }

  /// Returns where the place lies. None: the network does not have it, or its part is not laid out yet.
  std::optional<Spot> spot(const PlaceId& place) const;
  /// Returns the same number for all places of a part; none as of `spot`.
  std::optional<std::uint32_t> part_of(const PlaceId& place) const;
  /// Returns where something lies that hangs on a laid place, `place_from_it` away.
  Spot hung(const Spot& place, const Metric2& place_from_it) const;
  /// Returns the least distance within three standard deviations. The spots are of one part. When the place of a spot
  /// has been taken out of the map, it is not known which branches the two share: then the variance of both counts in
  /// full, and the result may be too small.
  double clearance_m(const Spot& a, const Spot& b) const;
  /// Returns the mean distance.
  static double distance_m(const Spot& a, const Spot& b);
  /// Returns whether they may be as near as `reach_m` or nearer; the same as by `clearance_m`, and cheaper.
  bool are_near(const Spot& a, const Spot& b, double reach_m) const;

  std::uint64_t laid() const { return laid_; }  ///< places that can be asked for
  /// Counts up when places that could be asked for lie elsewhere now.
  std::uint64_t moves() const { return moves_; }
  /// Holds places of a part that cannot be asked for yet.
  std::uint64_t under_way() const { return is_new_ ? size_of(part_) : 0; }
  std::vector<PlaceId> roots() const;

 private:
  using Index = std::uint32_t;
  static constexpr Index kNone = ~Index{0};

  struct Laid {
    Pose2 part_from_place;
    Spread spread;
    double uncertainty = 0.0;  ///< of the whole chain
    Index parent = kNone;
    Index jump = kNone;  ///< an ancestor farther up: any is found in a logarithmic number of steps
    Index depth = 0;
    Index part = kNone;  ///< its root; none: not laid out
    bool operator==(const Laid&) const = default;
  };
  struct Part {
    std::uint64_t places = 0;
    bool is_ready = false;
  };
  /// Holds a way to hang a place on another.
  struct Way {
    double uncertainty = 0.0;
    Index place = kNone;
    Index on = kNone;
    bool operator<(const Way& other) const {  // the least uncertain one is the top of a heap
      return std::tie(other.uncertainty, other.place, other.on) < std::tie(uncertainty, place, on);
    }
  };
  using Seed = std::pair<PlaceId, PlaceId>;

  void start(Network network, std::vector<PlaceId> roots);
  Index find(const PlaceId& place) const;
  Index find_or_add(const PlaceId& place);
  void forget(const PlaceId& place);
  /// Returns whether the spot's place is still laid out in that part.
  bool is_laid(const Spot& spot) const { return spot.at < places_.size() && places_[spot.at].part == spot.part; }
  Index common(Index a, Index b) const;

  // layout_work.cpp
  bool piece(std::size_t& places);
  bool begin_branches();
  bool begin_part(std::size_t& places);
  bool begin_part_at(const PlaceId& place);
  void end_branches();
  void give_up_branches();
  void take_out(const std::set<Index>& parts);
  const Laid& now(Index index) const;
  bool is_of_part(Index index) const { return now(index).part == part_; }
  std::uint64_t size_of(Index part) const;
  Index larger(Index a, Index b) const;
  void push(Index on, Index place, double uncertainty);
  void push_edge(const Seed& seed);
  std::optional<Laid> laid_on(Index index, Index on_index) const;
  void hang(const Way& way);
  void reach(Index from, const Edge& edge);
  void put(Index index, const Laid& laid);

  double keep_share_;
  std::map<ExperienceId, std::vector<Index>> rows_;  ///< by the places' index
  std::deque<Laid> places_;
  std::vector<PlaceId> ids_;
  std::vector<Index> free_;
  std::map<Index, Part> parts_;
  std::uint64_t laid_ = 0;
  std::uint64_t moves_ = 0;

  Network network_;                     ///< null: there is nothing to do
  std::deque<PlaceId> fresh_;           ///< where parts may begin, to be looked at first
  std::optional<PlaceId> looked_till_;  ///< where parts may begin, from there on
  std::vector<Seed> seeds_;             ///< edges over which something may be hung, to be looked at
  // The part that is worked on.
  Index part_ = kNone;
  bool is_new_ = false;          ///< nobody asks for it yet: it is written at once
  std::vector<Seed> under_way_;  ///< seeds that this work began with
  std::vector<Way> heap_;
  std::vector<std::pair<Index, Laid>> branches_;  ///< laid out, to be taken over when all is
  std::vector<Index> branch_of_;                  ///< by index of the place; none: as it is
};

}  // namespace weft::server
