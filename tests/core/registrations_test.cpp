#include "core/network/registrations.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"

namespace weft {
namespace {

/// Returns a map of one run with so many places.
Snapshot map_of(std::uint32_t places) {
  Batch batch;
  batch.experience = ExperienceId{1};
  batch.sequence = 1;
  for (std::uint32_t i = 0; i < places; ++i) {
    Place place;
    place.id = {batch.experience, i};
    batch.places.push_back(place);
  }
  return with({}, batch);
}

Registration hall() {
  Registration made{"hall", hash_bytes(Bytes{1}), {{"dock", {{1}, 2}}, {"gate", {{1}, 5}}}};
  made.picks[0].in_place = {0.25, -0.5};
  made.picks[1].on_plan = {12.5, 3.25};
  made.picks[1].heading = -1.5;
  return made;
}

std::string refusal(const Registration& registration) {
  const Result<void> checked = check(map_of(8), registration);
  return checked ? "" : checked.error().message;
}

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(Registrations, AreReadAsTheyWereWritten) {
  const Result<Registration> read = decode_registration(encode(hall()));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, hall());
}

TEST(Registrations, AreNoMoreWhenOneByteIsMissing) {
  const Bytes bytes = encode(hall());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_registration(ByteView(bytes).subspan(0, size))) << size;
  }
}

TEST(Registrations, WithNumbersThatCannotBeAreCorrupt) {
  Registration registration = hall();
  registration.picks[0].sigma_m = 0.0;
  EXPECT_TRUE(says(decode_registration(encode(registration)).error().message, "pick sigma"));
  registration = hall();
  registration.picks[0].on_plan.x() = 1e7;
  EXPECT_TRUE(says(decode_registration(encode(registration)).error().message, "pick on plan"));
}

TEST(Registrations, ThatDoNotFitTheMapAreRefused) {
  EXPECT_EQ(refusal(hall()), "");
  Registration registration = hall();
  registration.picks[1].place.index = 8;
  EXPECT_TRUE(says(refusal(registration), "pick gate: place 0000000000000001:8 is not in the map"));
  registration = hall();
  registration.picks[0].sigma_m = 11.0;
  EXPECT_TRUE(says(refusal(registration), "its sigma is 11 m; it must be from 0.001 to 10 m"));
  registration = hall();
  registration.picks[0].on_plan.y() = -2e6;
  EXPECT_TRUE(says(refusal(registration), "give metres"));
  registration = hall();
  registration.picks[0].name = "dock\nweft: all is well";
  EXPECT_TRUE(says(refusal(registration), "has the character U+000A; a name has"));
  registration.picks[0].name = to_string(registration.picks[0].place);
  EXPECT_EQ(refusal(registration), "") << "an id is a name too";
  registration = hall();
  registration.picks.clear();
  EXPECT_TRUE(says(refusal(registration), "has 0 picks; give from 1 to 100"));
  registration.plan = "a b";
  EXPECT_TRUE(says(refusal(registration), "plan \"a b\" has"));
}

TEST(Registrations, OfOnePlanTooManyIsRefused) {
  Snapshot map = map_of(8);
  for (std::size_t i = 0; i < kMostRegistrations; ++i) {
    Registration registration = hall();
    registration.plan = "hall" + std::to_string(i);
    map = with_registration(map, registration);
  }
  EXPECT_EQ(check(map, hall()).error().code, ErrorCode::invalid);
  Registration known = hall();
  known.plan = "hall7";
  EXPECT_TRUE(check(map, known));
}

TEST(Registrations, AreCarriedAlongByEveryChange) {
  const Snapshot map = with_registration(map_of(8), hall());
  EXPECT_EQ(map.revision(), Revision{2});
  EXPECT_EQ(with_label(map, "dock", {{1}, 2}).registrations(), map.registrations());
  EXPECT_EQ(with_seal(map, {1}, "done").registrations(), map.registrations());
  EXPECT_TRUE(without_registration(map, "hall").registrations().empty());
}

}  // namespace
}  // namespace weft
