#include "core/network/registrations.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"

/// Checks registrations of floor plans on every engine, a revision each.
namespace weft::storage {
namespace {

class MapRegistrations : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    commit(sample::transaction(run_.next(8)));
    commit({{PutLabel{"dock", {run_.experience(), 2}}}});
    yard_.picks[0].heading = 1.5;
  }

  Pick pick(std::uint32_t place, double x) const {
    Pick made;
    made.name = "p" + std::to_string(place);
    made.place = {run_.experience(), place};
    made.on_plan = {x, 2.5};
    return made;
  }

  sample::Run run_{0x11, 1};
  Registration hall_{"hall", hash_bytes(Bytes{1, 2}), {pick(1, 0.0), pick(4, 3.0)}};
  Registration yard_{"yard", hash_bytes(Bytes{3}), {pick(2, 7.0)}};
};

using Plans = Snapshot::Registrations;

TEST_P(MapRegistrations, AreARevisionAndSurviveARestart) {
  EXPECT_EQ(commit({{PutRegistration{hall_}}}), Revision{3});
  EXPECT_EQ(commit({{PutRegistration{yard_}}}), Revision{4});
  Registration moved = yard_;
  moved.picks[0].on_plan.x() = 8.0;
  EXPECT_EQ(commit({{PutRegistration{moved}}}), Revision{5});
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(5).registrations(), (Plans{{"hall", hall_}, {"yard", moved}}));
    EXPECT_EQ(at(4).registrations(), (Plans{{"hall", hall_}, {"yard", yard_}}));
    EXPECT_EQ(at(3).registrations(), (Plans{{"hall", hall_}}));
    EXPECT_TRUE(at(2).registrations().empty());
    EXPECT_EQ(at(3, at(5)).registrations(), (Plans{{"hall", hall_}}));
    restart();
    EXPECT_EQ(stored_.snapshot.registrations(), (Plans{{"hall", hall_}, {"yard", moved}}));
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapRegistrations, AreInTheLogAndInTheChangesOfTheirRevision) {
  commit({{PutRegistration{hall_}}});
  commit({{PutRegistration{{.plan = "hall"}, false}}});
  const auto log = store_->log({}, 2).value();
  EXPECT_EQ(log[1].kind, "register");
  EXPECT_EQ(log[1].cause, to_string(hall_));
  EXPECT_EQ(log[0].cause, "plan hall goes");
  EXPECT_EQ(changes(3).registrations, std::set<std::string>{"hall"});
  EXPECT_EQ(changes(4).registrations, std::set<std::string>{"hall"});
  EXPECT_TRUE(changes(2).registrations.empty());
  EXPECT_TRUE(at(4).registrations().empty());
}

TEST_P(MapRegistrations, AreGoneBackOverByARollback) {
  commit({{PutRegistration{hall_}}});
  commit({{PutRegistration{yard_}}});
  commit({{RollBack{{3}}}});
  EXPECT_EQ(at(5).registrations(), (Plans{{"hall", hall_}}));
  restart();
  EXPECT_EQ(stored_.snapshot.registrations(), (Plans{{"hall", hall_}}));
}

TEST_P(MapRegistrations, StayWhateverBecomesOfTheirPlaces) {
  commit({{PutRegistration{hall_}}});
  commit({{TakeOut{{{{run_.experience(), 0, 7}}, {}}}}});
  EXPECT_EQ(at(4).registrations(), (Plans{{"hall", hall_}}));
  EXPECT_TRUE(finish(store_->compact({4})).finished);
  restart();
  EXPECT_EQ(stored_.snapshot.registrations(), (Plans{{"hall", hall_}}));
  EXPECT_TRUE(finish(store_->check()).findings.empty());
}

TEST_P(MapRegistrations, AreKeptByACompactionAsFarAsAMapHasThem) {
  commit({{PutRegistration{hall_}}});         // 3
  commit({{PutRegistration{hall_, false}}});  // 4
  commit({{PutRegistration{hall_}}});         // 5
  commit({{PutRegistration{yard_}}});         // 6
  commit({{PutRegistration{yard_, false}}});  // 7
  EXPECT_TRUE(finish(store_->compact({6})).finished);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(6).registrations(), (Plans{{"hall", hall_}, {"yard", yard_}}));
    EXPECT_EQ(at(7).registrations(), (Plans{{"hall", hall_}}));
    EXPECT_EQ(changes(7).registrations, std::set<std::string>{"yard"}) << "it can still be undone";
    restart();
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapRegistrations, OfPlacesThatAreNotStoredAreRefused) {
  Registration registration = hall_;
  registration.picks[1].place.index = 8;
  EXPECT_EQ(refusal({{PutRegistration{registration}}}), ErrorCode::conflict);
  registration.picks[1].place = {{0x33}, 0};
  EXPECT_EQ(refusal({{PutRegistration{registration}}}), ErrorCode::conflict);
  registration = hall_;
  registration.plan.clear();
  EXPECT_EQ(refusal({{PutRegistration{registration}}}), ErrorCode::invalid);
}

INSTANTIATE_TEST_SUITE_P(Engines, MapRegistrations, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
