// Included by kernels_plain.cpp and kernels_avx2.cpp inside a namespace of their own; no include guard on purpose.

inline std::uint32_t hash_of(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  // Two rounds of the lowbias32 mixer (Wellons 2018) over both coordinates.
  std::uint32_t h = x * 0x9E3779B1U + seed;
  h ^= h >> 16U;
  h *= 0x7feb352dU;
  h ^= y * 0x85EBCA77U;
  h ^= h >> 15U;
  h *= 0x846ca68bU;
  h ^= h >> 16U;
  return h;
}

void add_noise_row(std::int32_t x0, std::int32_t y, std::uint32_t seed, int count, float amplitude, float* to) {
  // Four bytes sum to mean 510 and variance 4 * (256^2 - 1) / 12.
  const float scale = amplitude / 147.8F;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t h = hash_of(static_cast<std::uint32_t>(x0 + i), static_cast<std::uint32_t>(y), seed);
    const std::uint32_t pairs = (h & 0x00ff00ffU) + ((h >> 8U) & 0x00ff00ffU);
    const auto sum = static_cast<std::int32_t>((pairs & 0xffffU) + (pairs >> 16U));
    to[i] += scale * static_cast<float>(sum - 510);
  }
}

void double_row(const float* from_near, const float* from_far, int count, float* to) {
  for (int i = 0; i < count / 2; ++i) {
    const float before = 3.0F * from_near[i] + from_far[i];
    const float here = 3.0F * from_near[i + 1] + from_far[i + 1];
    const float after = 3.0F * from_near[i + 2] + from_far[i + 2];
    to[2 * i] = (3.0F * here + before) * (1.0F / 16.0F);
    to[2 * i + 1] = (3.0F * here + after) * (1.0F / 16.0F);
  }
}

void halve(const std::uint8_t* from, int side, std::uint8_t* to) {
  for (int j = 0; j < side; ++j) {
    const std::uint8_t* a = from + static_cast<std::ptrdiff_t>(2 * j) * 2 * side;
    const std::uint8_t* b = a + 2 * side;
    std::uint8_t* row = to + static_cast<std::ptrdiff_t>(j) * side;
    for (int i = 0; i < side; ++i) {
      row[i] = static_cast<std::uint8_t>((a[2 * i] + a[2 * i + 1] + b[2 * i] + b[2 * i + 1] + 2) >> 2);
    }
  }
}
