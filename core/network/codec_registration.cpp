#include <cmath>

#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {
namespace {

constexpr std::size_t kPickLeast = 4 + fields::kPlaceIdBytes + 5 * 8 + 1;

Pick read_pick(ByteReader& in) {
  Pick pick;
  pick.name = in.text("pick name");
  pick.place = in.place_id("pick place");
  pick.in_place = fields::read_point(in, "pick in place");
  pick.on_plan = fields::read_point(in, "pick on plan");
  pick.sigma_m = fields::read_within(in, "pick sigma", kLeastPickSigma_m, kMostPickSigma_m);
  if (in.flag("pick has heading")) {
    const std::size_t at = in.offset();
    pick.heading = in.f64("pick heading");
    if (!std::isfinite(*pick.heading)) in.corrupt("pick heading", at, "is not finite");
  }
  return pick;
}

Registration read_registration(ByteReader& in) {
  Registration registration;
  registration.plan = in.text("plan");
  registration.plan_hash = in.id<ContentHash>("plan hash");
  registration.picks.resize(in.count("picks", kPickLeast));
  for (Pick& pick : registration.picks) pick = read_pick(in);
  return registration;
}

}  // namespace

Bytes encode(const Registration& registration) {
  return fields::record([&](ByteWriter& out) {
    out.text(registration.plan);
    out.id(registration.plan_hash);
    out.count(registration.picks.size());
    for (const Pick& pick : registration.picks) {
      out.text(pick.name);
      out.id(pick.place);
      fields::write(out, pick.in_place);
      fields::write(out, pick.on_plan);
      out.f64(pick.sigma_m);
      out.flag(pick.heading.has_value());
      if (pick.heading) out.f64(*pick.heading);
    }
  });
}

Result<Registration> decode_registration(ByteView bytes) {
  return fields::whole<Registration>(bytes, "registration", read_registration);
}

}  // namespace weft
