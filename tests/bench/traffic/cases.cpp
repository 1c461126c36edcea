#include "tests/bench/traffic/cases.hpp"

#include <functional>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/bench/traffic/play.hpp"

namespace weft::bench {
namespace {

constexpr double kPatience_s = 150.0;

using Corners = std::vector<Eigen::Vector2d>;

/// Describes an aisle of 12 m in which both ways lie 0.5 m apart, with a loop to turn on at each end; it goes on over
/// its own beginning.
const Corners kAisle = {{0, 0},   {12, 0},   {14, -2},  {18, -2}, {18, 2.5}, {14, 2.5}, {12, 0.5},
                        {0, 0.5}, {-2, 2.5}, {-6, 2.5}, {-6, -2}, {-2, -2},  {0, 0},    {1.5, 0}};

Corners circle(double length_m) {
  constexpr int corners = 48;
  Corners all;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double radius_m = length_m / (2.0 * std::numbers::pi);
    all.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle));
  }
  return all;
}

void head_on(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  play.label("east", play.near(run, {18, 2}));
  play.label("west", play.near(run, {-6, -1.5}));
  play.put("r1", play.near(run, {3, 0}));
  play.put("r2", play.near(run, {9, 0.5}));
  play.send("r1", "east");
  play.send("r2", "west");
}

void swap(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  play.label("east", play.near(run, {18, 1}));
  play.label("west", play.near(run, {-6, 1}));
  play.put("r1", play.near(run, {-6, 1}));
  play.put("r2", play.near(run, {18, 1}));
  play.send("r1", "east");
  play.send("r2", "west");
}

/// Arranges a ring of places for one robot more than there are; each goes two of them on.
void full_ring(Play& play, int robots) {
  constexpr double berth_m = 2.0;
  const int berths = robots + 1;
  const ExperienceId run = play.teach(circle(berth_m * berths));
  const auto berth = [&](int number) {
    const double angle = 2.0 * std::numbers::pi * number / berths;
    const double radius_m = berth_m * berths / (2.0 * std::numbers::pi);
    return play.near(run, {radius_m * std::cos(angle), radius_m * std::sin(angle)});
  };
  for (int i = 0; i < berths; ++i) play.label("b" + std::to_string(i), berth(i));
  for (int i = 0; i < robots; ++i) play.put("r" + std::to_string(i + 1), berth(i));
  for (int i = 0; i < robots; ++i) play.send("r" + std::to_string(i + 1), "b" + std::to_string((i + 2) % berths));
}

void idle_on_the_way(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  play.label("east", play.near(run, {18, 2}));
  play.put("r1", play.near(run, {1, 0}));
  play.put("r2", play.near(run, {8, 0}));
  play.send("r1", "east");
}

void parked_at_my_goal(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  play.label("east", play.near(run, {18, 1}));
  play.put("r1", play.near(run, {1, 0}));
  play.put("r2", play.near(run, {18, 1}));
  play.send("r1", "east");
}

void dead_end(Play& play) {
  const ExperienceId lane = play.teach({{-10, 0}, {10, 0}});
  const ExperienceId end =
      play.teach({{-4, 0}, {-0.5, 0}, {0, 1}, {0, 8}, {0.4, 8.2}, {0.5, 8}, {0.5, 1}, {1, 0}, {4, 0}});
  play.label("deep", play.near(end, {0, 7.5}));
  play.label("out", play.near(lane, {9, 0}));
  play.put("r1", play.near(lane, {-4, 0}));
  play.put("r2", play.near(end, {0, 7.5}));
  play.send("r1", "deep");
  play.pass(10.0);
  play.send("r2", "out");
}

/// Lays a lane in which two robots cannot pass each other, with a loop at its end that has room for two. A robot that
/// stands in the lane, on its way out, is in the way of one that comes in.
void lane_with_a_loop(Play& play) {
  const ExperienceId lane = play.teach({{-10, 0}, {10, 0}});
  const ExperienceId end = play.teach(
      {{-4, 0}, {-0.5, 0}, {0, 1}, {0, 6}, {-0.9, 7}, {0, 8}, {0.9, 7}, {0.2, 6}, {0.2, 1}, {1, 0}, {4, 0}});
  play.label("bay", play.near(end, {0.2, 4}));
  play.label("out", play.near(lane, {9, 0}));
  play.put("r1", play.near(lane, {-4, 0}));
  play.put("r2", play.near(end, {0.2, 4}));
  play.send("r1", "bay");
}

void inside_a_stretch(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  const ExperienceId aside = play.teach({{4, 0}, {6, 0}, {7, -1}, {7, -6}});
  play.label("east", play.near(run, {18, 2}));
  play.label("aside", play.near(aside, {7, -6}));
  play.put("r1", play.near(run, {0.5, 0}));
  play.send("r1", "east");
  play.pass(1.0);
  play.put("r2", play.near(aside, {6.5, -0.5}));
  play.send("r2", "aside");
}

void dead_in_one_of_two(Play& play) {
  const ExperienceId run = play.teach({{0, 0}, {20, 0}});
  play.teach({{0, 0}, {2, 0}, {4, 4}, {16, 4}, {18, 0}, {20, 0}});
  play.label("end", play.near(run, {20, 0}));
  play.put("r1", play.near(run, {0, 0}));
  play.put("r2", play.near(run, {10, 0}));
  play.end("r2");
  play.pass(10.0);
  play.send("r1", "end");
}

/// Closes the straight way beyond what the robots are released; a way round it is left to them.
void closed_ahead_of_two(Play& play) {
  const ExperienceId run = play.teach({{0, 0}, {66, 0}});
  play.teach({{0, 0}, {22, 0}, {24, 4}, {56, 4}, {58, 0}, {60, 0}});
  play.label("end", play.near(run, {66, 0}));
  play.label("before", play.near(run, {62, 0}));
  play.put("r1", play.near(run, {0, 0}));
  play.put("r2", play.near(run, {6, 0}));
  play.send("r2", "end");
  play.send("r1", "before");
  play.pass(5.0);
  play.close("works", play.near(run, {30, 0}), play.near(run, {34, 0}));
}

/// Closes the only way for a while: the robot waits before it until it is open again.
void closed_ahead_for_a_while(Play& play) {
  const ExperienceId run = play.teach({{0, 0}, {60, 0}});
  play.label("end", play.near(run, {60, 0}));
  play.put("r1", play.near(run, {0, 0}));
  play.close("works", play.near(run, {30, 0}), play.near(run, {34, 0}));
  play.send("r1", "end");
  play.pass(60.0);
  play.open("works");
}

/// Closes a stretch while a robot drives in it: that robot may drive on, and out.
void closed_under_a_robot(Play& play) {
  const ExperienceId run = play.teach({{0, 0}, {60, 0}});
  play.label("end", play.near(run, {60, 0}));
  play.put("r1", play.near(run, {8, 0}));
  play.send("r1", "end");
  play.pass(5.0);
  play.close("works", play.near(run, {5, 0}), play.near(run, {20, 0}));
}

void two_at_one_station(Play& play) {
  const ExperienceId run = play.teach(kAisle);
  play.label("east", play.near(run, {18, 1}));
  play.put("r1", play.near(run, {5, 0}));
  play.put("r2", play.near(run, {1, 0}));
  play.send("r1", "east");
  play.send("r2", "east");
}

struct Case {
  std::string name;
  std::function<void(Play&)> arrange;
  bool can_end = true;  ///< by driving; else it is to be named, with what a person has to do
};

std::vector<Case> all_cases() {
  std::vector<Case> all = {{"head-on", head_on, false}, {"swap", swap}};
  for (int robots = 3; robots <= 8; ++robots) {
    all.push_back(
        {"ring of " + std::to_string(robots) + " full but one", [robots](Play& p) { full_ring(p, robots); }, true});
  }
  const std::vector<Case> more = {{"idle on the way", idle_on_the_way},
                                  {"parked at my goal", parked_at_my_goal},
                                  {"dead end with one inside", dead_end},
                                  {"lane with a loop at its end", lane_with_a_loop},
                                  {"inside a stretch", inside_a_stretch},
                                  {"dead robot in one of two aisles", dead_in_one_of_two},
                                  {"closed edge ahead, another way", closed_ahead_of_two},
                                  {"closed edge ahead for a while", closed_ahead_for_a_while},
                                  {"closed edge under a robot", closed_under_a_robot},
                                  {"two goals at one station", two_at_one_station}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

int tell_cases(std::ostream& out, bool json) {
  bool is_as_it_must_be = true;
  for (const Case& one : all_cases()) {
    Play play;
    one.arrange(play);
    const double begin_s = play.now_s();
    const bool is_over = play.play(kPatience_s);
    const std::optional<double> named_s = play.named_after_s();
    const std::string says = named_s ? play.named().front() : "";
    const double took_s = play.now_s() - begin_s;
    is_as_it_must_be = is_as_it_must_be && (one.can_end ? is_over : named_s.has_value());
    if (json) {
      out << nlohmann::json{{"case", one.name},
                            {"ends", is_over},
                            {"after_s", is_over ? nlohmann::json(took_s) : nlohmann::json()},
                            {"named_s", named_s ? nlohmann::json(*named_s) : nlohmann::json()},
                            {"says", says}}
                 .dump()
          << std::endl;
      continue;
    }
    out << std::left << std::setw(34) << one.name << (is_over ? "ends after " : "STANDS after ") << std::fixed
        << std::setprecision(0) << took_s << " s";
    if (named_s) out << ", named " << std::setprecision(1) << *named_s << " s after the last move: " << says;
    if (!named_s && !is_over) {
      for (const std::string& cause : play.open_goals()) out << "; " << cause;
    }
    out << std::endl;
  }
  return is_as_it_must_be ? 0 : 1;
}

}  // namespace weft::bench
