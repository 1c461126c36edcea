// Included by semi_global_plain.cpp and semi_global_avx2.cpp inside a namespace of their own, after what works on
// kLanes bytes at once (Bytes); no include guard on purpose.

/// Holds a byte for each disparity of a pixel.
template <int N>
struct Costs {
  Bytes part[N] = {};
};

template <int N>
[[gnu::always_inline]] inline Costs<N> load_costs(const std::uint8_t* from) {
  Costs<N> costs;
  for (int i = 0; i < N; ++i) costs.part[i] = load(from + i * kLanes);
  return costs;
}

template <int N>
[[gnu::always_inline]] inline void store_costs(std::uint8_t* to, const Costs<N>& costs) {
  for (int i = 0; i < N; ++i) store(to + i * kLanes, costs.part[i]);
}

template <int N>
[[gnu::always_inline]] inline Costs<N> sum_of(const Costs<N>& a, const Costs<N>& b) {
  Costs<N> sum;
  for (int i = 0; i < N; ++i) sum.part[i] = plus(a.part[i], b.part[i]);
  return sum;
}

/// Returns the least in every lane.
template <int N>
[[gnu::always_inline]] inline Bytes least_of(const Costs<N>& costs) {
  Bytes least = costs.part[0];
  for (int i = 1; i < N; ++i) least = lesser(least, costs.part[i]);
  return least_lane(least);
}

/// Returns the costs with that of disparity d + 1 in the lane of d; the largest for the last one.
template <int N>
[[gnu::always_inline]] inline Costs<N> moved_down(const Costs<N>& costs) {
  Costs<N> moved;
  for (int i = 0; i < N; ++i)
    moved.part[i] = lanes_down(costs.part[i], i + 1 < N ? costs.part[i + 1] : everywhere(255));
  return moved;
}

/// Goes one pixel further along a path: L(p, d) = C(p, d) + min(L(q, d), L(q, d -+ 1) + P1, min L(q) + P2) - min L(q)
/// (Hirschmueller 2008, eq. 13).
template <int N>
[[gnu::always_inline]] inline Costs<N> next_on_path(const Costs<N>& before, const Bytes& least, const Costs<N>& costs,
                                                    const Bytes& small_penalty, const Bytes& large_penalty) {
  const Bytes jump = plus(least, large_penalty);
  const Costs<N> higher = moved_down(before);
  Costs<N> next;
  for (int i = 0; i < N; ++i) {
    const Bytes lower = lanes_up(before.part[i], i > 0 ? before.part[i - 1] : everywhere(255));
    const Bytes beside = plus(lesser(lower, higher.part[i]), small_penalty);
    const Bytes way = lesser(lesser(before.part[i], jump), beside);
    next.part[i] = plus(costs.part[i], minus(way, least));
  }
  return next;
}

/// Returns how many bits of the census differ at each disparity; 255 beyond the last one.
template <int N>
[[gnu::always_inline]] inline Costs<N> costs_at(const Row& row, const Costs<N>& beyond, int x) {
  Costs<N> costs;
  for (int i = 0; i < N; ++i) costs.part[i] = everywhere(0);
  for (int plane = 0; plane < kCensusPlanes; ++plane) {
    const Bytes left = everywhere(row.left[plane * row.plane_bytes + x]);
    const std::uint8_t* const right = row.right_reversed + plane * row.plane_bytes + row.width - 1 - x;
    for (int i = 0; i < N; ++i) costs.part[i] = plus(costs.part[i], bits_that_differ(left, load(right + i * kLanes)));
  }
  for (int i = 0; i < N; ++i) costs.part[i] = either(costs.part[i], beyond.part[i]);
  return costs;
}

/// Sums the paths that come from the left and from above: ascending, as each overwrites what the row above has left.
template <int N>
[[gnu::always_inline]] inline void match_forward(const Row& row, const std::uint8_t* mask) {
  constexpr int bytes = N * kLanes;
  const Costs<N> beyond = load_costs<N>(mask + kMostDisparities - row.disparities);
  const Bytes small_penalty = everywhere(row.small_penalty);
  const Bytes large_penalty = everywhere(row.large_penalty);
  Costs<N> along;
  for (int i = 0; i < N; ++i) along.part[i] = everywhere(0);
  Costs<N> above_left = along;
  Bytes along_least = everywhere(0);
  Bytes above_left_least = everywhere(0);
  for (int x = 0; x < row.width; ++x) {
    const Costs<N> costs = costs_at<N>(row, beyond, x);
    store_costs(row.costs + x * bytes, costs);
    along = next_on_path(along, along_least, costs, small_penalty, large_penalty);
    along_least = least_of(along);
    const Costs<N> down_right = next_on_path(above_left, above_left_least, costs, small_penalty, large_penalty);
    above_left = load_costs<N>(row.from_left + x * bytes);
    above_left_least = everywhere(row.from_left_least[x]);
    store_costs(row.from_left + x * bytes, down_right);
    row.from_left_least[x] = first_lane(least_of(down_right));
    const Costs<N> above_right = load_costs<N>(row.from_right + (x + 1) * bytes);
    const Costs<N> down_left =
        next_on_path(above_right, everywhere(row.from_right_least[x + 1]), costs, small_penalty, large_penalty);
    store_costs(row.from_right + x * bytes, down_left);
    row.from_right_least[x] = first_lane(least_of(down_left));
    store_costs(row.sums + x * bytes, sum_of(along, sum_of(down_right, down_left)));
  }
}

/// Returns the disparity of the least sum in sixteenths: between whole ones where two straight lines of one slope
/// through the least and its neighbours meet, as sums of census costs rise evenly. `best` is not the last one.
[[gnu::always_inline]] inline std::int16_t refined(const std::uint8_t* sums, int best) {
  if (best == 0) return 0;
  const int below = sums[best - 1] - sums[best];
  const int above = sums[best + 1] - sums[best];
  const int steeper = below > above ? below : above;
  if (steeper == 0) return static_cast<std::int16_t>(16 * best);
  return static_cast<std::int16_t>(16 * best + 8 * (below - above) / steeper);
}

/// Adds the path from the right, and chooses: descending. Right pixels take part as a window of candidates that moves
/// along, one leaving it a step.
template <int N>
[[gnu::always_inline]] inline void match_backward(const Row& row, const std::uint8_t* mask) {
  constexpr int bytes = N * kLanes;
  const Bytes small_penalty = everywhere(row.small_penalty);
  const Bytes large_penalty = everywhere(row.large_penalty);
  Costs<N> along;
  Costs<N> numbers;
  Costs<N> right;       // least sums of right pixels x, x - 1, ...
  Costs<N> right_best;  // and their disparities
  for (int i = 0; i < N; ++i) {
    along.part[i] = everywhere(0);
    numbers.part[i] = plus(counting(), everywhere(static_cast<std::uint8_t>(i * kLanes)));
    right.part[i] = everywhere(255);
    right_best.part[i] = everywhere(0);
  }
  Bytes along_least = everywhere(0);
  for (int x = row.width - 1; x >= 0; --x) {
    const Costs<N> costs = load_costs<N>(row.costs + x * bytes);
    along = next_on_path(along, along_least, costs, small_penalty, large_penalty);
    along_least = least_of(along);
    const int last = x < row.disparities ? x : row.disparities - 1;
    const Costs<N> beyond = load_costs<N>(mask + kMostDisparities - 1 - last);  // where the right image has ended
    Costs<N> sums = sum_of(load_costs<N>(row.sums + x * bytes), along);
    for (int i = 0; i < N; ++i) sums.part[i] = either(sums.part[i], beyond.part[i]);
    store_costs(row.sums + x * bytes, sums);
    const Bytes least = least_of(sums);
    const Bytes near = everywhere(row.too_near[first_lane(least)]);
    int best = -1;
    std::uint32_t cheap[N];
    for (int i = 0; i < N; ++i) {
      const std::uint32_t here = lanes_equal(sums.part[i], least);
      if (best < 0 && here != 0) best = i * kLanes + __builtin_ctz(here);
      cheap[i] = lanes_equal(lesser(sums.part[i], near), sums.part[i]);
    }
    bool is_ambiguous = false;
    for (int i = 0; i < N; ++i) {
      const int at = best - 1 - i * kLanes;  // where the three that belong together begin
      const std::uint32_t own = at <= -3 || at >= kLanes ? 0U : at >= 0 ? 7U << at : 7U >> -at;
      is_ambiguous |= (cheap[i] & ~own) != 0;
    }
    // The least at the end of what was searched is no minimum: what is nearer was not looked for.
    row.best[x] = is_ambiguous || best == last ? kAmbiguous : refined(row.sums + x * bytes, best);
    for (int i = 0; i < N; ++i) {
      const Bytes lower = lesser(right.part[i], sums.part[i]);
      right_best.part[i] = where_equal(right.part[i], lower, right_best.part[i], numbers.part[i]);
      right.part[i] = lower;
    }
    row.best_right[x] = first_lane(right_best.part[0]);
    right = moved_down(right);
    right_best = moved_down(right_best);
  }
}

/// Holds a mask: read from kMostDisparities - 1 - d, it is 0 up to disparity d, then 255.
struct Beyond {
  std::uint8_t mask[2 * kMostDisparities] = {};
};

[[gnu::always_inline]] inline void match(const Row& row) {
  Beyond beyond;
  for (int i = 0; i < 2 * kMostDisparities; ++i) beyond.mask[i] = i < kMostDisparities ? 0 : 255;
  switch (padded(row.disparities) / kLanes) {
    case 1:
      match_forward<1>(row, beyond.mask);
      return match_backward<1>(row, beyond.mask);
    case 2:
      match_forward<2>(row, beyond.mask);
      return match_backward<2>(row, beyond.mask);
    case 3:
      match_forward<3>(row, beyond.mask);
      return match_backward<3>(row, beyond.mask);
    default:
      match_forward<4>(row, beyond.mask);
      return match_backward<4>(row, beyond.mask);
  }
}
