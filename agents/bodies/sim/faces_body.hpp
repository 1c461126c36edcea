// Included by floor/kernels_plain.cpp and floor/kernels_avx2.cpp inside a namespace of their own, with kFaceLanes as
// many doubles as they work on at once; no include guard on purpose. Real is one double or kFaceLanes of them: what
// stands here for one pixel stands for several.

using Doubles [[gnu::vector_size(kFaceLanes * sizeof(double))]] = double;

template <class Real>
constexpr int kLanesOf = 1;
template <>
constexpr int kLanesOf<Doubles> = kFaceLanes;

[[gnu::always_inline]] inline double lane(const double& x, int) {
  return x;
}
[[gnu::always_inline]] inline double lane(const Doubles& x, int i) {
  return x[i];
}
[[gnu::always_inline]] inline void set_lane(double& x, int, double value) {
  x = value;
}
[[gnu::always_inline]] inline void set_lane(Doubles& x, int i, double value) {
  x[i] = value;
}

template <class Real>
[[gnu::always_inline]] inline Real every(double x) {
  return Real{} + x;
}

template <class Real>
[[gnu::always_inline]] inline Real least(const Real& a, const Real& b) {
  return a < b ? a : b;
}

template <class Real>
[[gnu::always_inline]] inline Real cut(const Real& x, double low, double high) {
  const Real raised = x < low ? every<Real>(low) : x;
  return raised > high ? every<Real>(high) : raised;
}

/// Rounds down as std::floor, within what a site measures: beyond this summand a double has no fraction.
template <class Real>
[[gnu::always_inline]] inline Real floor_of(const Real& x) {
  constexpr double kNoFraction = 6755399441055744.0;  // 1.5 * 2^52
  const Real whole = (x + kNoFraction) - kNoFraction;
  return whole > x ? whole - 1.0 : whole;
}

inline double noise_at(double x, double y, std::int64_t salt) {
  auto h = static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(static_cast<std::int64_t>(y)) * 0xC2B2AE3D27D4EB4FULL ^
           static_cast<std::uint64_t>(salt) * 0x165667B19E3779F9ULL;
  h ^= h >> 31U;
  h *= 0xBF58476D1CE4E5B9ULL;
  h ^= h >> 29U;
  return static_cast<double>(h >> 11U) * 0x1.0p-53;
}

[[gnu::noinline]] inline void look_up(double x, double y, std::int64_t salt, FaceMemo::Cell& cell) {
  cell = {x,
          y,
          salt,
          {noise_at(x, y, salt), noise_at(x + 1, y, salt), noise_at(x, y + 1, salt), noise_at(x + 1, y + 1, salt)}};
}

/// Returns smooth noise in [-1, 1].
template <class Real>
[[gnu::always_inline]] inline Real smooth_noise(const Real& x, const Real& y, std::int64_t salt,
                                                FaceMemo::Cell& cell) {
  const Real fx = floor_of(x);
  const Real fy = floor_of(y);
  Real corners[4] = {};
#pragma GCC unroll 4  // lanes known when compiled stay in registers: through memory they would wait for each other
  for (int i = 0; i < kLanesOf<Real>; ++i) {
    const double cx = lane(fx, i);
    const double cy = lane(fy, i);
    if (cell.x != cx || cell.y != cy || cell.salt != salt) look_up(cx, cy, salt, cell);
    set_lane(corners[0], i, cell.corners[0]);
    set_lane(corners[1], i, cell.corners[1]);
    set_lane(corners[2], i, cell.corners[2]);
    set_lane(corners[3], i, cell.corners[3]);
  }
  const Real u = x - fx;
  const Real v = y - fy;
  const Real top = corners[0] * (1.0 - u) + corners[1] * u;
  const Real bottom = corners[2] * (1.0 - u) + corners[3] * u;
  return 2.0 * (top * (1.0 - v) + bottom * v) - 1.0;
}

/// Returns 1 within [low, high], 0 outside, fading over 1 / per_soft around either bound.
template <class Real>
[[gnu::always_inline]] inline Real band(const Real& x, double low, double high, const Real& per_soft) {
  const Real inside = least<Real>(x - low, high - x);
  return cut<Real>(0.5 + inside * per_soft, 0.0, 1.0);
}

template <class Real>
[[gnu::always_inline]] inline Real mix(const Real& a, const Real& b, const Real& share) {
  return a + share * (b - a);
}

template <class Real>
[[gnu::always_inline]] inline Real load_grey(const Real& along, const Real& shelf, std::int64_t salt,
                                             FaceMemo::Load& load) {
  Real grey = {};
#pragma GCC unroll 4
  for (int i = 0; i < kLanesOf<Real>; ++i) {
    if (load.along != lane(along, i) || load.shelf != lane(shelf, i) || load.salt != salt) {
      load = {lane(along, i), lane(shelf, i), salt, 60.0 + 120.0 * noise_at(lane(along, i), lane(shelf, i), salt)};
    }
    set_lane(grey, i, load.grey);
  }
  return grey;
}

/// Returns the grey of a rack: pallets with loads of their own grey, gaps between, under a beam every 1.5 m.
template <class Real>
[[gnu::always_inline]] inline Real rack_grey(std::int64_t salt, const Real& along, const Real& up,
                                             const Real& per_soft, FaceMemo& memo) {
  constexpr double kBay = 2.7;
  constexpr double kLoad = 0.9;
  const Real load = floor_of<Real>(along * (1.0 / kLoad));
  const Real in_load = along - load * kLoad;
  const Real shelf = floor_of<Real>((up - 0.05) * (1.0 / 1.5));
  const Real on_shelf = up - 0.05 - shelf * 1.5;
  const Real loaded = band<Real>(in_load, 0.05, 0.85, per_soft);
  const Real block = in_load - 0.4 * floor_of<Real>(in_load * 2.5);
  const Real gap = block > 0.1 ? every<Real>(1.0) : every<Real>(0.0);
  Real grey = mix<Real>(every<Real>(28.0), load_grey(load, shelf, salt, memo.load), loaded);
  grey = mix<Real>(grey, every<Real>(95.0), band<Real>(on_shelf, 0.12, 0.24, per_soft) * loaded);  // pallet boards
  grey = mix<Real>(grey, every<Real>(40.0), band<Real>(on_shelf, 0.15, 0.21, per_soft) * gap);
  grey = mix<Real>(grey, every<Real>(165.0), band<Real>(on_shelf, 0.0, 0.11, per_soft));  // beam
  const Real in_bay = along - floor_of<Real>(along * (1.0 / kBay)) * kBay;
  grey = mix<Real>(grey, every<Real>(75.0), band<Real>(in_bay, 0.0, 0.09, per_soft));  // post
  return mix<Real>(grey, every<Real>(22.0),
                   band<Real>(up, -1.0, 0.04, per_soft) * band<Real>(in_bay, 0.14, kBay, per_soft));
}

template <class Real>
[[gnu::always_inline]] inline Real pillar_grey(const Real& along, const Real& up, const Real& per_soft) {
  const Real stripe = (along + up) / 0.28;
  const Real yellow = band<Real>(stripe - floor_of<Real>(stripe), 0.0, 0.5, per_soft * 0.28);
  return up < 1.2 ? mix<Real>(every<Real>(35.0), every<Real>(185.0), yellow) : every<Real>(150.0);
}

template <class Real>
[[gnu::always_inline]] inline bool any_finer(const Real& pixel, double than) {
  for (int i = 0; i < kLanesOf<Real>; ++i) {
    if (lane(pixel, i) < than) return true;
  }
  return false;
}

/// Adds dirt of a few sizes, none finer than a pixel.
template <class Real>
[[gnu::always_inline]] inline Real with_dirt(Real grey, const FaceJob& job, const Real& along, const Real& up,
                                             const Real& pixel) {
  constexpr double kSizes[3] = {0.4, 0.08, 0.02};
  constexpr double kPerSize[3] = {2.5, 12.5, 50.0};
  constexpr double kDepths[3] = {7.0, 5.0, 5.0};
  for (int i = 0; i < 3; ++i) {
    if (!any_finer(pixel, kSizes[i] / 2)) continue;
    const Real depth = pixel < kSizes[i] / 2 ? every<Real>(kDepths[i]) : every<Real>(0.0);
    grey += depth * smooth_noise<Real>(along * kPerSize[i], up * kPerSize[i], job.salt + 1000, job.memo->dirt[i]);
  }
  return grey;
}

template <class Real>
[[gnu::always_inline]] inline void paint(const FaceJob& job, int at) {
  Real along;
  Real up;
  Real pixel;
  __builtin_memcpy(&along, job.along_m + at, sizeof along);
  __builtin_memcpy(&up, job.up_m + at, sizeof up);
  __builtin_memcpy(&pixel, job.pixel_m + at, sizeof pixel);
  const Real per_soft = 1.0 / (pixel < 0.002 ? every<Real>(0.002) : pixel);
  Real grey = every<Real>(90.0);
  switch (job.look) {
    case FaceLook::rack:
      grey = rack_grey(job.salt, along, up, per_soft, *job.memo);
      break;
    case FaceLook::plain:
      break;
    case FaceLook::wall:
      grey = mix<Real>(every<Real>(165.0), every<Real>(80.0), band<Real>(up, -1.0, 0.12, per_soft));
      break;
    case FaceLook::pillar:
      grey = pillar_grey(along, up, per_soft);
      break;
  }
  grey = cut<Real>(with_dirt(grey, job, along, up, pixel), 0.0, 255.0);
  for (int i = 0; i < kLanesOf<Real>; ++i) job.out[at + i] = static_cast<float>(lane(grey, i));
}

void face_row(const FaceJob& job) {
  int at = 0;
  for (; at + kFaceLanes <= job.count; at += kFaceLanes) paint<Doubles>(job, at);
  for (; at < job.count; ++at) paint<double>(job, at);
}
