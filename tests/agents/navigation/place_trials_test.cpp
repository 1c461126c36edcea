#include "agents/navigation/place_trials.hpp"

#include <array>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

/// Records what is asked of the method, in order.
struct AskedOfMarks {
  std::vector<Revisit> revisits;
  int related = 0;
};

/// Thinks marks away: in half light every second one, and on a worn floor all.
class RevisitedMarks : public MarksMethod {
 public:
  static constexpr std::array<std::string_view, 3> conditions = {"as_is", "half_light", "worn"};
  explicit RevisitedMarks(std::shared_ptr<AskedOfMarks> asked) : asked_(std::move(asked)) {}

  OrRefusal<Revisited<Content>> simulate_revisit(const Odometry& odometry, const View& view,
                                                 const Revisit& revisit) const {
    asked_->revisits.push_back(revisit);
    View other = view;
    Marks seen;
    const Marks all = *marks_of(view);
    for (const Marks::Sighting& mark : all.sightings) {
      const bool is_dark = revisit.condition == 1 && mark.mark % 2 == 0;
      if (is_dark || revisit.condition == 2) continue;
      seen.sightings.push_back({mark.mark, revisit.robot_from_other.inverse() * mark.robot_from_mark});
    }
    other.data = seen;
    OrRefusal<Content> content = extract(odometry, other);
    if (!content) return tl::unexpected(content.error());
    return Revisited<Content>{std::move(*content), revisit.robot_from_other};
  }
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const {
    ++asked_->related;
    return MarksMethod::relate(a, b, guess);
  }

 private:
  std::shared_ptr<AskedOfMarks> asked_;
};
static_assert(SimulatesRevisits<RevisitedMarks> && !SimulatesRevisits<MarksMethod>);

class PlaceTrialsOfMarks : public MarksFleet {
 protected:
  TeachReport taught(const std::vector<Pose2>& path) {
    test::MarksRobotConfig config;
    config.base = {0.1, 1, 0.02, 0.02, 0.01};
    test::NavigatedRobot robot(world, config, path.front(), 1, make_navigator(RevisitedMarks(asked), navigation));
    robot.teach(server, first, path, truth);
    const Result<TeachReport> way = robot.navigator().teach_report();
    if (!way) throw std::runtime_error(way.error().message);
    return *way;
  }
  View view_at(const Pose2& at) {
    View view;
    view.data = world.see(at, random);
    return view;
  }

  std::shared_ptr<AskedOfMarks> asked = std::make_shared<AskedOfMarks>();
  Random random{5};
};

TEST_F(PlaceTrialsOfMarks, EachPlaceIsTriedUnderEachCondition) {
  const TeachReport way = taught(test::Course({5, 5, 0}).straight(4.0).poses);
  EXPECT_EQ(way.experience, first);
  EXPECT_NEAR(way.driven_m, 4.0, 0.3);
  EXPECT_EQ(way.places.size(), server.snapshot().experience(first)->places.size());
  std::size_t tried = 0;
  for (const TaughtPlace& place : way.places) {
    if (!place.trials) continue;
    ++tried;
    EXPECT_TRUE((*place.trials)[0].found) << (*place.trials)[0].refused;
    EXPECT_GT((*place.trials)[0].sigma_m, 0.0);
    EXPECT_FALSE((*place.trials)[2].found);
    EXPECT_EQ((*place.trials)[2].refused, "no_marks");
  }
  EXPECT_GE(tried + 3, way.places.size()) << "the last ones have not been seen from further on";
}

TEST_F(PlaceTrialsOfMarks, AllConditionsOfAPlaceAreOfOneRobotAndPlacesOfDifferentOnes) {
  taught(test::Course({5, 5, 0}).straight(3.0).poses);
  std::set<std::uint64_t> seeds;
  ASSERT_GE(asked->revisits.size(), 9U);
  for (std::size_t i = 0; i + 2 < asked->revisits.size(); i += 3) {
    seeds.insert(asked->revisits[i].seed);
    for (const std::size_t k : {i + 1, i + 2}) {
      EXPECT_EQ(asked->revisits[k].seed, asked->revisits[i].seed);
      EXPECT_EQ(asked->revisits[k].robot_from_other, asked->revisits[i].robot_from_other);
      EXPECT_NE(asked->revisits[k].condition, asked->revisits[i].condition);
    }
    EXPECT_GT(std::abs(asked->revisits[i].robot_from_other.y), 0.01);
  }
  EXPECT_EQ(seeds.size(), asked->revisits.size() / 3);
}

TEST_F(PlaceTrialsOfMarks, StretchesOfWhichNothingWasSeenAreNoted) {
  const RevisitedMarks method(asked);
  PlaceTrials<RevisitedMarks> trials(method, navigation, first);
  trials.drive(0.5, {});
  trials.drive(0.6, "no_marks");
  trials.drive(0.8, "no_marks");
  trials.drive(0.8, "blurred");
  trials.drive(0.9, {});
  trials.drive(1.0, "blurred");
  const TeachReport report = *trials.report();
  ASSERT_EQ(report.blind.size(), 2U) << "who stands misses no stretch";
  EXPECT_EQ(report.blind[0].from_m, 0.5);
  EXPECT_EQ(report.blind[0].to_m, 0.8);
  EXPECT_EQ(report.blind[1].from_m, 0.9);
  EXPECT_EQ(report.blind[1].reason, "blurred");
}

TEST_F(PlaceTrialsOfMarks, ASampleDoesNoMoreThanItHasTimeFor) {
  const RevisitedMarks method(asked);
  PlaceTrials<RevisitedMarks> trials(method, navigation, first);
  const RevisitedMarks::Odometry odometry;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const Pose2 at{5.0 + 0.2 * i, 5.0, 0.0};
    trials.kept({first, i}, std::make_shared<const MarksMethod::Content>(*method.extract(odometry, view_at(at))));
    trials.look({{first, i}, Metric2{Pose2{0.02, 0.0, 0.0}}, 0.0}, odometry, view_at(at));
    EXPECT_TRUE(i > 0 || asked->revisits.empty());
    trials.look({{first, i}, Metric2{Pose2{0.12, 0.0, 0.0}}, 0.0}, odometry, view_at(at * Pose2{0.12, 0.0, 0.0}));
  }
  const auto steps = [&] { return static_cast<int>(asked->revisits.size()) + asked->related; };
  trials.work(from_seconds(0.01));
  EXPECT_EQ(steps(), 1);
  trials.work(from_seconds(0.066));
  EXPECT_EQ(steps(), 3);
  const int before = steps();
  trials.work(from_seconds(10.0));
  EXPECT_LE(steps() - before, 4);
  for (int i = 0; i < 100; ++i) trials.work(from_seconds(0.033));
  std::size_t tried = 0;
  const TeachReport way = *trials.report();
  for (const TaughtPlace& place : way.places) tried += place.trials ? 1U : 0U;
  EXPECT_EQ(tried, 6U) << "views wait, but not many: of the others nothing is known";
}

TEST_F(PlaceTrialsOfMarks, AMethodThatCannotSimulateRevisitsRefusesInWords) {
  test::NavigatedRobot robot = robot_at({5, 5, 0}, 1);
  ASSERT_FALSE(robot.navigator().teach_report());
  EXPECT_NE(robot.navigator().teach_report().error().message.find("nothing has been taught"), std::string::npos);
  robot.teach(server, first, test::Course({5, 5, 0}).straight(1.0).poses, truth);
  ASSERT_FALSE(robot.navigator().teach_report());
  EXPECT_NE(robot.navigator().teach_report().error().message.find("marks"), std::string::npos);
}

TEST_F(PlaceTrialsOfMarks, AMetreWithNothingToSeeSaysSo) {
  test::MarksWorldConfig config;
  config.blank = {{7.5, 5.0, 1.0}};
  make_world(config);
  const auto rows = stretches_of(taught(test::Course({5, 5, 0}).straight(5.0).poses), 1000);
  bool is_said = false;
  for (const TaughtStretch& row : rows) is_said = is_said || row.reason == "no place: no_marks";
  EXPECT_TRUE(is_said);
}

}  // namespace
}  // namespace weft::agents
