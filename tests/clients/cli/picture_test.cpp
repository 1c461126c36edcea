#include "clients/cli/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "clients/cli/run_colour.hpp"
#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

/// Returns a width of nine units a byte at size 15.
double nine_a_byte(const std::string& words, double size) {
  return 0.6 * size * static_cast<double>(words.size());
}

Subject two_loops_subject() {
  Snapshot snapshot;
  for (const Batch& batch : two_loops({0xA1}, {0xB2}, {}, {})) snapshot = with(snapshot, batch);
  Subject subject;
  subject.network = make_window(with_label(snapshot, "dock", {{0xA1}, 30}), WindowDefinition{});
  subject.layout = lay_out(subject.network);
  return subject;
}

/// Makes so many runs of one place more than the last one, beside each other.
Subject many_runs(std::uint64_t count) {
  Subject subject;
  for (std::uint64_t run = 1; run <= count; ++run) {
    for (std::uint32_t i = 0; i <= run; ++i) {
      Place place;
      place.id = {{run}, i};
      subject.network.places.emplace(place.id, place);
      subject.layout.drawing_from_place[place.id] = {0.3 * i, 1.0 * static_cast<double>(run), 0.0};
    }
  }
  return subject;
}

bool has_words(const std::vector<LegendLine>& lines, const std::string& words) {
  return std::ranges::any_of(lines,
                             [&](const LegendLine& line) { return line.words.find(words) != std::string::npos; });
}

const Tag* tag_named(const Picture& picture, const std::string& words) {
  const auto found = std::ranges::find(picture.tags, words, &Tag::words);
  return found == picture.tags.end() ? nullptr : &*found;
}

std::optional<Colour> colour_in_legend(const Subject& subject, const std::string& words) {
  for (const LegendLine& line : compose(subject, nine_a_byte).legend.runs) {
    if (line.words.starts_with(words)) return line.ink;
  }
  return std::nullopt;
}

TEST(Picture, RunsAreNamedOnTheDrawingAndInTheLegend) {
  Subject subject = two_loops_subject();
  subject.run_names[{0xA1}] = "loop-1";
  const Picture picture = compose(subject, nine_a_byte);
  EXPECT_TRUE(has_words(picture.legend.runs, "run loop-1: "));
  EXPECT_TRUE(has_words(picture.legend.runs, "run 00000000: "));
  ASSERT_NE(tag_named(picture, "loop-1"), nullptr);
  EXPECT_EQ(tag_named(picture, "loop-1")->frame, run_colour({0xA1}));
  EXPECT_NE(tag_named(picture, "00000000"), nullptr);
}

TEST(ShownRun, IsItsNameElseTheBeginningOfItsId) {
  const RunNames names = {{{0xA1}, "loop-1"}};
  EXPECT_EQ(shown_run({0xA1}, names), "loop-1");
  EXPECT_EQ(shown_run({0x123456789ABCDEF0}, names), "12345678");
  const RunNames shared = {{{0x123456789ABCDEF0}, "loop"}, {{0xA1}, "loop"}};
  EXPECT_EQ(shown_run({0x123456789ABCDEF0}, shared), "loop (12345678)");
}

TEST(Picture, ARunKeepsItsColourWhateverElseIsDrawn) {
  Subject both = two_loops_subject();
  Subject alone;
  alone.network = make_window(with(Snapshot{}, two_loops({0xA1}, {0xB2}, {}, {}).front()), WindowDefinition{});
  alone.layout = lay_out(alone.network);
  alone.robots.emplace();
  both.run_names[{0xA1}] = alone.run_names[{0xA1}] = "loop-1";
  EXPECT_EQ(colour_in_legend(both, "run loop-1"), run_colour({0xA1}));
  EXPECT_EQ(colour_in_legend(alone, "run loop-1"), run_colour({0xA1}));
  EXPECT_NE(colour_in_legend(both, "run 00000000"), run_colour({0xA1}));
}

TEST(Picture, OfManyRunsTheLongestAreListedAndTheRestCounted) {
  const Picture picture = compose(many_runs(30), nine_a_byte);
  ASSERT_EQ(picture.legend.runs.size(), kMostRunsListed + 1);
  EXPECT_TRUE(has_words({picture.legend.runs.front()}, "31 places"));
  EXPECT_EQ(picture.legend.runs.back().words, "and 18 shorter runs with 189 places");
}

TEST(Picture, TheLegendExplainsWhatIsThereAndNothingElse) {
  Subject subject = two_loops_subject();
  const Picture bare = compose(subject, nine_a_byte);
  EXPECT_TRUE(has_words(bare.legend.marks, "stitch"));
  EXPECT_TRUE(has_words(bare.legend.marks, "labelled place"));
  EXPECT_FALSE(has_words(bare.legend.marks, "robot"));
  EXPECT_FALSE(has_words(bare.legend.marks, "odometry alone"));
  subject.robots.emplace();
  EXPECT_TRUE(has_words(compose(subject, nine_a_byte).legend.marks, "no robot is known"));
  RobotMark robot;
  robot.name = robot.words = "r1";
  robot.drawing_from_robot = Pose2{1.0, 1.0, 0.0};
  robot.look = RobotMark::Look::silent;
  robot.held = {{{0xA1}, 3}, {{0xA1}, 4}};
  robot.ahead = {{{0xA1}, 5}};
  subject.robots->drawn = {robot};
  subject.robots->not_drawn = {{"r2", "it does not know where it is"}};
  const Picture full = compose(subject, nine_a_byte);
  for (const char* const words : {"not heard", "held", "not released", "goal", "not drawn: r2"})
    EXPECT_TRUE(has_words(full.legend.marks, words)) << words;
  EXPECT_FALSE(has_words(full.legend.marks, "its tip is ahead"));  // of those that are heard
}

TEST(Picture, AllWordsAreInsideAndApart) {
  Subject subject = two_loops_subject();
  for (int i = 0; i < 50; ++i)
    subject.network.labels[std::string(60, 'w') + std::to_string(i)] = {{0xA1}, static_cast<std::uint32_t>(i % 3)};
  subject.ground = Ground{{}, std::string(500, 'c')};
  const Picture picture = compose(subject, nine_a_byte);
  ASSERT_GE(picture.tags.size(), 50U);
  for (std::size_t i = 0; i < picture.tags.size(); ++i) {
    const Box& box = picture.tags[i].box;
    EXPECT_GE(box.left, 0.0);
    EXPECT_LE(box.right, picture.sheet.width);
    EXPECT_LT(box.bottom, picture.sheet.legend_top);
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(box, picture.tags[j].box));
  }
  EXPECT_LE(nine_a_byte(picture.detail, kDetailWords), picture.sheet.width - 2.0 * kSheetMargin);
  EXPECT_GE(picture.sheet.height, picture.sheet.legend_top + picture.legend_layout.height);
}

TEST(Legend, LongLinesStandBelowEachOther) {
  Legend legend;
  legend.runs = {{LegendLine::Sample::run, "a"}, {LegendLine::Sample::run, "b"}};
  legend.marks = {{LegendLine::Sample::label, "c"}};
  const LegendLayout beside = lay_legend(legend, 400.0, nine_a_byte);
  EXPECT_EQ(beside.lines[2].y, beside.lines[0].y);
  EXPECT_GT(beside.lines[2].x, beside.lines[0].x);
  legend.marks[0].words = std::string(30, 'c');
  const LegendLayout below = lay_legend(legend, 400.0, nine_a_byte);
  EXPECT_GT(below.lines[2].y, below.lines[1].y);
  EXPECT_GT(below.height, beside.height);
}

TEST(Legend, WordsAreCutBetweenCharacters) {
  EXPECT_EQ(elided("short", 15.0, 100.0, nine_a_byte), "short");
  EXPECT_EQ(elided("ééééé", 15.0, 63.0, nine_a_byte), "éé…");
  EXPECT_EQ(elided("ééééé", 15.0, 1.0, nine_a_byte), "…");
}

TEST(RoundMetres, AreTheLongestThatFit) {
  EXPECT_DOUBLE_EQ(round_metres(60.0, 240.0), 2.0);
  EXPECT_DOUBLE_EQ(round_metres(0.01, 240.0), 20'000.0);
  EXPECT_DOUBLE_EQ(round_metres(1480.0, 240.0), 0.1);
}

}  // namespace
}  // namespace weft::cli::test
