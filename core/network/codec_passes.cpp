#include <cmath>

#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {
namespace {

double read_not_negative(ByteReader& in, const char* field) {
  const std::size_t at = in.offset();
  const double value = in.f64(field);
  if (!(std::isfinite(value) && value >= 0.0)) in.corrupt(field, at, "is negative or no number");
  return value;
}

std::vector<Pass> read_passes(ByteReader& in) {
  const std::size_t at = in.offset();
  std::vector<Pass> passes(in.count("passes", 3 * sizeof(double)));
  if (passes.size() > kPassesKept) {
    in.corrupt("passes", at, "are more than the " + std::to_string(kPassesKept) + " that are kept");
  }
  for (Pass& pass : passes) {
    pass.length_m = read_not_negative(in, "length");
    pass.drive_s = read_not_negative(in, "driving");
    pass.wait_s = read_not_negative(in, "waiting");
  }
  return passes;
}

}  // namespace

Bytes encode(const std::vector<Pass>& passes) {
  return fields::record([&](ByteWriter& out) {
    out.count(passes.size());
    for (const Pass& pass : passes) {
      out.f64(pass.length_m);
      out.f64(pass.drive_s);
      out.f64(pass.wait_s);
    }
  });
}

Result<std::vector<Pass>> decode_passes(ByteView bytes) {
  return fields::whole<std::vector<Pass>>(bytes, "passes", read_passes);
}

}  // namespace weft
