// Included by hall/shade_plain.cpp and hall/shade_avx2.cpp inside a namespace of their own, with kLanes as many rays
// as they work on at once; no include guard on purpose.

using Floats [[gnu::vector_size(kLanes * sizeof(float))]] = float;
using Ints [[gnu::vector_size(kLanes * sizeof(std::int32_t))]] = std::int32_t;

[[gnu::always_inline]] inline Floats load(const float* from) {
  Floats all;
  __builtin_memcpy(&all, from, sizeof all);
  return all;
}

[[gnu::always_inline]] inline Floats as_floats(const Ints& bits) {
  Floats all;
  __builtin_memcpy(&all, &bits, sizeof all);
  return all;
}

[[gnu::always_inline]] inline Ints as_ints(const Floats& floats) {
  Ints all;
  __builtin_memcpy(&all, &floats, sizeof all);
  return all;
}

/// Rounds down; coordinates are far from an int's bounds.
[[gnu::always_inline]] inline Ints whole(const Floats& value) {
  const Ints cut = __builtin_convertvector(value, Ints);
  return cut + (value < __builtin_convertvector(cut, Floats));  // true is -1
}

/// Folds whole texels back into the texture: 0 .. side - 1, then back.
[[gnu::always_inline]] inline Ints mirrored(const Ints& at, const Ints& side) {
  const Ints within = at & (2 * side - 1);
  const Ints back = 2 * side - 1 - within;
  return within < back ? within : back;
}

/// Returns the texels at (x, y), in texels of level 0, from the level whose texels are as large as `texels` of those.
[[gnu::always_inline]] inline Floats texel(const TexelLevels& levels, const Floats& x, const Floats& y,
                                           const Floats& texels) {
  const Floats at_least_one = texels > 1.0F ? texels : Floats{} + 1.0F;
  const Ints wanted = (as_ints(at_least_one) >> 23) - 127;  // the power of two in it
  const Ints level = wanted < levels.top ? wanted : Ints{} + levels.top;
  const Ints side = (Ints{} + 1) << (levels.top - level);
  const Floats scale = as_floats((127 - level) << 23);  // 2^-level
  const Floats column = x * scale - 0.5F;
  const Floats row = y * scale - 0.5F;
  const Ints left = whole(column);
  const Ints top = whole(row);
  const Floats s = column - __builtin_convertvector(left, Floats);
  const Floats t = row - __builtin_convertvector(top, Floats);
  const Ints x0 = mirrored(left, side);
  const Ints x1 = mirrored(left + 1, side);
  const Ints above = mirrored(top, side) * side;
  const Ints below = mirrored(top + 1, side) * side;
  const Ints places[4] = {above + x0, above + x1, below + x0, below + x1};
  std::int32_t texels_at[4][kLanes];
  for (int i = 0; i < kLanes; ++i) {
    const std::uint8_t* const from = levels.texels + levels.from[level[i]];
    for (int k = 0; k < 4; ++k) texels_at[k][i] = from[places[k][i]];
  }
  Ints four[4];
  __builtin_memcpy(four, texels_at, sizeof four);
  const Floats over =
      __builtin_convertvector(four[0], Floats) + s * __builtin_convertvector(four[1] - four[0], Floats);
  const Floats under =
      __builtin_convertvector(four[2], Floats) + s * __builtin_convertvector(four[3] - four[2], Floats);
  return over + t * (under - over);
}

[[gnu::always_inline]] inline Floats seen(const ShadeRays& rays, int at) {
  const ShadedFace& face = *rays.face;
  const Floats length = load(rays.length + at);
  const Floats across =
      face.normal[0] * load(rays.x + at) + face.normal[1] * load(rays.y + at) + face.normal[2] * load(rays.z + at);
  const Floats facing = (across < 0.0F ? -across : across) / length;
  // Four rays share a pixel; at a slant it covers more (about the root of the slant, as across it does not).
  const Floats slant = 1.0F / (0.25F + 0.75F * facing);
  const Floats distance = load(rays.distance + at);
  Floats pixel_m = rays.pixel * distance * slant;
  if (rays.wider != nullptr) pixel_m *= load(rays.wider + at);
  const Floats u = load(rays.u + at);
  const Floats v = load(rays.v + at);
  const Floats lower = face.light[0] + u * (face.light[1] - face.light[0]);
  const Floats upper = face.light[2] + u * (face.light[3] - face.light[2]);
  Floats light = lower + v * (upper - lower);
  if (rays.headlight > 0.0F) {
    const Floats beam = 1.0F / (1.0F + load(rays.off_axis2 + at) / 0.12F);
    const Floats distance_m = distance * length;
    const Floats distance2 = distance_m * distance_m;
    light += rays.headlight * facing * beam * beam * 4.0F / (distance2 > 0.25F ? distance2 : Floats{} + 0.25F);
  }
  const Floats shown =
      texel(face.levels, u * face.per_u + face.at_u, v * face.per_v + face.at_v, pixel_m * face.per_m);
  return (face.ground + face.grey * shown) * light;
}

void shade(const ShadeRays& rays) {
  for (int at = 0; at < kShaded; at += kLanes) {
    const Floats grey = seen(rays, at);
    __builtin_memcpy(rays.grey + at, &grey, sizeof grey);
  }
}
