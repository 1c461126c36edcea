#include "clients/cli/label_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace weft::cli {
namespace {

constexpr double kBesideMark = 4.0;  // between a mark and a label next to it
constexpr double kRingStep = 14.0;   // farther away, by so much
constexpr int kRings = 24;
constexpr int kDirections = 16;
constexpr double kRingCost = 3.0;     // rather cover so many points than move one ring away
constexpr double kBetweenRows = 4.0;  // below the frame
constexpr double kBucket = 48.0;

/// Knows which parts of the sheet are taken, in buckets.
class Room {
 public:
  explicit Room(const std::vector<Point>& points) {
    for (const Point& point : points) points_[{bucket(point.x), bucket(point.y)}].push_back(point);
  }

  void take(const Box& box) {
    for_each_bucket(box, [&](const Key& key) { boxes_[key].push_back(box); });
  }

  bool is_free(const Box& box) const {
    bool free = true;
    for_each_bucket(box, [&](const Key& key) {
      const auto found = boxes_.find(key);
      if (!free || found == boxes_.end()) return;
      free = std::ranges::none_of(found->second, [&](const Box& taken) { return overlap(taken, box); });
    });
    return free;
  }

  double covered(const Box& box) const {
    std::size_t count = 0;
    for_each_bucket(box, [&](const Key& key) {
      const auto found = points_.find(key);
      if (found == points_.end()) return;
      count += static_cast<std::size_t>(
          std::ranges::count_if(found->second, [&](const Point& at) { return overlap(around(at, 2.0), box); }));
    });
    return static_cast<double>(count);
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;

  static std::int64_t bucket(double at) { return static_cast<std::int64_t>(std::floor(at / kBucket)); }

  template <class Visit>
  static void for_each_bucket(const Box& box, Visit&& visit) {
    for (std::int64_t x = bucket(box.left); x <= bucket(box.right); ++x) {
      for (std::int64_t y = bucket(box.top); y <= bucket(box.bottom); ++y) visit(Key{x, y});
    }
  }

  std::map<Key, std::vector<Box>> boxes_;
  std::map<Key, std::vector<Point>> points_;
};

/// Returns the box whose side or corner that faces the anchor lies `away` from it, in a direction (0: right, y down).
Box beside(const LabelWish& wish, double away, double direction) {
  const double right = std::cos(direction);
  const double down = std::sin(direction);
  const auto start = [&](double at, double toward, double size) {
    constexpr double straight = 0.3;
    if (toward > straight) return at + away * toward;
    return toward < -straight ? at + away * toward - size : at + away * toward - 0.5 * size;
  };
  const double left = start(wish.anchor.x, right, wish.wide);
  const double top = start(wish.anchor.y, down, wish.tall);
  return {left, top, left + wish.wide, top + wish.tall};
}

bool is_in(const Box& box, const Box& frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
}

std::optional<Box> near_anchor(const LabelWish& wish, const Room& room, const Box& frame) {
  // To the right first, as people read.
  static constexpr std::array<int, kDirections> kOrder = {0, 8, 14, 2, 10, 6, 12, 4, 15, 1, 9, 7, 13, 3, 11, 5};
  std::optional<Box> best;
  double least = 1e300;
  for (int ring = 0; ring < kRings && kRingCost * ring < least; ++ring) {
    const double away = wish.clear * std::numbers::sqrt2 + kBesideMark + kRingStep * ring;
    for (const int step : kOrder) {
      const Box box = beside(wish, away, 2.0 * std::numbers::pi * step / kDirections);
      if (!is_in(box, frame) || !room.is_free(box)) continue;
      const double cost = kRingCost * ring + room.covered(box);
      if (cost >= least) continue;
      least = cost;
      best = box;
    }
  }
  return best;
}

/// Places boxes in rows below a frame, filled from left to right.
class Rows {
 public:
  explicit Rows(const Box& frame) : frame_(frame), x_(frame.left), y_(frame.bottom + kBetweenRows) {}

  Box next(const LabelWish& wish, const Room& room) {
    for (;;) {
      const Box box{x_, y_, x_ + wish.wide, y_ + wish.tall};
      const bool is_first = x_ == frame_.left;
      if (!is_first && box.right > frame_.right) {
        x_ = frame_.left;
        y_ += row_ + kBetweenRows;
        row_ = 0.0;
        continue;
      }
      x_ = box.right + kBetweenRows;
      row_ = std::max(row_, wish.tall);
      if (room.is_free(box)) return box;
    }
  }

 private:
  Box frame_;
  double x_;
  double y_;
  double row_ = 0.0;
};

}  // namespace

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Point nearest_in(const Box& box, const Point& at) {
  return {std::clamp(at.x, box.left, box.right), std::clamp(at.y, box.top, box.bottom)};
}

bool needs_leader(const LabelWish& wish, const Box& box) {
  const Point end = nearest_in(box, wish.anchor);
  const double away = std::hypot(end.x - wish.anchor.x, end.y - wish.anchor.y);
  return away > wish.clear * std::numbers::sqrt2 + kBesideMark + 0.5 * kRingStep;
}

LabelPlacement place_labels(const std::vector<LabelWish>& wishes, const std::vector<Box>& marks,
                            const std::vector<Point>& points, const Box& frame) {
  Room room(points);
  for (const Box& mark : marks) room.take(mark);
  for (const LabelWish& wish : wishes) room.take(around(wish.anchor, wish.clear));
  LabelPlacement placed{{}, frame};
  Rows rows(frame);
  for (const LabelWish& wish : wishes) {
    const std::optional<Box> near = near_anchor(wish, room, frame);
    const Box box = near.has_value() ? *near : rows.next(wish, room);
    room.take(box);
    placed.boxes.push_back(box);
    placed.frame.right = std::max(placed.frame.right, box.right);
    placed.frame.bottom = std::max(placed.frame.bottom, box.bottom);
  }
  return placed;
}

}  // namespace weft::cli
