// tests/simulate: lives of a whole fleet in one thread each, two at a time, invariants checked all along.
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <compare>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "tests/simulation/run.hpp"
#include "tests/simulation/site.hpp"

namespace {

struct Options {
  std::vector<std::string> sites;  ///< none: all that have room
  std::string seeds = "1..10";
  std::size_t robots = 4;
  weft::simulation::People people = weft::simulation::People::help;
  weft::simulation::Focus focus = weft::simulation::Focus::none;
  std::optional<weft::simulation::MapFrom> map;
  double hours = 1.0;
  std::size_t jobs = 2;
  bool verbose = false;
  bool keep_going = false;
  bool diary = false;
  std::vector<std::string> told;  ///< invariants that are no failure
};

struct Seeds {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

bool parse(const std::string& text, Seeds& seeds) {
  const auto dots = text.find("..");
  std::istringstream first(text.substr(0, dots));
  std::istringstream last(dots == std::string::npos ? text : text.substr(dots + 2));
  return (first >> seeds.first) && first.eof() && (last >> seeds.last) && last.eof() && seeds.first <= seeds.last;
}

/// Settles what was not given: many robots live on a stored map. Returns what does not fit together; empty: all does.
std::string settle(Options& options) {
  using weft::simulation::MapFrom;
  const bool are_many = options.robots > weft::simulation::kMostTaught;
  if (are_many && options.map == MapFrom::taught) {
    return "--map taught with --robots " + std::to_string(options.robots) + ": a site that is taught has room for " +
           std::to_string(weft::simulation::kMostTaught) + "; leave --map out";
  }
  if (!options.map) options.map = are_many ? MapFrom::stored : MapFrom::taught;
  if (options.map == MapFrom::taught) {
    if (options.sites.empty()) options.sites = weft::simulation::site_names();
    return {};
  }
  for (const std::string& site : options.sites) {
    if (site != "aisles") return "--site " + site + ": a stored map is of aisles; --site aisles, or leave it out";
  }
  options.sites = {"aisles"};
  return {};
}

/// Names one fleet's life: a seed on a site.
struct Life {
  std::string site;
  std::uint64_t seed = 0;

  auto operator<=>(const Life&) const = default;
};

/// Returns the lives of every seed on every site, seed by seed; each begins with another site, so that of two workers
/// not one has all the lives on the site that takes longer.
std::vector<Life> lives_of(const Options& options, const Seeds& seeds) {
  std::vector<Life> lives;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    for (std::size_t i = 0; i < options.sites.size(); ++i) {
      lives.push_back({options.sites[(i + seed) % options.sites.size()], seed});
    }
  }
  return lives;
}

std::string one(const Options& options, const Life& life) {
  const auto result =
      weft::simulation::run({.fleet = {.site = life.site,
                                       .seed = life.seed,
                                       .robots = options.robots,
                                       .map = *options.map,
                                       .checks_waits = options.people == weft::simulation::People::none,
                                       .told = {options.told.begin(), options.told.end()}},
                             .people = options.people,
                             .focus = options.focus,
                             .hours = options.hours});
  std::ostringstream line;
  // First, because at the seed's own line whoever reads may stop.
  for (const auto& entry : result.diary) {
    if (options.diary) line << "! " << entry << '\n';
  }
  for (const auto& violation : result.told)
    line << "! told: seed " << life.seed << " on " << life.site << ": " << violation.invariant << ": "
         << violation.what << '\n';
  for (const auto& violation : result.violations)
    line << "! seed " << life.seed << " on " << life.site << ": " << violation.invariant << ": " << violation.what
         << '\n';
  line << life.seed << ' ' << life.site << ' ' << result.violations.size() << ' ' << result.simulated_hours << ' '
       << result.messages << ' ' << result.faults << ' ' << result.goals_sent << ' ' << result.goals_accepted << ' '
       << result.acknowledged << ' ' << result.ways_made << ' ' << result.stood << ' ' << result.led_back << ' '
       << result.trace;
  for (const auto& [state, count] : result.goals) line << ' ' << state << '=' << count;
  return line.str() + "\n";
}

/// Runs every jobs-th life and writes a line each into the pipe.
void work(const Options& options, const std::vector<Life>& lives, std::size_t worker, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Windows come and go all the time: their memory is kept, not handed back and cleared again.
  constexpr int megabytes = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * megabytes);
  mallopt(M_TRIM_THRESHOLD, 256 * megabytes);
  for (std::size_t at = worker; at < lives.size(); at += options.jobs) {
    const std::string line = one(options, lives[at]);
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t wrote = write(to, line.data() + done, line.size() - done);
      if (wrote <= 0) _exit(1);
      done += static_cast<std::size_t>(wrote);
    }
  }
  _exit(0);
}

struct Totals {
  std::uint64_t lives = 0, broken = 0, messages = 0, faults = 0, sent = 0, accepted = 0, acknowledged = 0;
  std::uint64_t ways_made = 0, stood = 0, led_back = 0;
  double hours = 0.0;
  std::map<std::string, std::uint64_t> goals;
};

/// Holds the totals of each site.
using Tally = std::map<std::string, Totals>;

/// Adds what a life came to, and returns which life it was.
Life add(Tally& tally, const std::string& line) {
  std::istringstream in(line);
  std::uint64_t seed = 0, violations = 0, messages = 0, faults = 0, sent = 0, accepted = 0, acknowledged = 0;
  std::uint64_t ways_made = 0, stood = 0, led_back = 0;
  double hours = 0.0;
  std::string site, trace;
  in >> seed >> site >> violations >> hours >> messages >> faults >> sent >> accepted >> acknowledged >> ways_made >>
      stood >> led_back >> trace;
  Totals& totals = tally[site];
  ++totals.lives;
  totals.broken += violations > 0 ? 1 : 0;
  totals.hours += hours;
  totals.messages += messages;
  totals.faults += faults;
  totals.sent += sent;
  totals.accepted += accepted;
  totals.acknowledged += acknowledged;
  totals.ways_made += ways_made;
  totals.stood += stood;
  totals.led_back += led_back;
  for (std::string word; in >> word;) {
    totals.goals[word.substr(0, word.find('='))] += std::stoull(word.substr(word.find('=') + 1));
  }
  return {site, seed};
}

/// Returns how a worker came to an end before its last life; empty: it did not.
std::string early_end(int status) {
  if (WIFSIGNALED(status))
    return "killed by signal " + std::to_string(WTERMSIG(status)) + ": " + strsignal(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? std::string() : "with exit code " + std::to_string(WEXITSTATUS(status));
}

/// Returns the first of a worker's lives that was not lived to its end, as a clause.
std::string living(const std::vector<Life>& lives, const std::set<Life>& lived, std::size_t worker,
                   std::size_t jobs) {
  for (std::size_t at = worker; at < lives.size(); at += jobs) {
    if (!lived.contains(lives[at])) return ", in seed " + std::to_string(lives[at].seed) + " on " + lives[at].site;
  }
  return {};
}

void say(const std::string& site, const Totals& totals) {
  std::cout << site << ": " << totals.lives << " seeds, " << totals.hours << " robot-hours, " << totals.messages
            << " messages, " << totals.faults << " faults, " << totals.sent << " goals sent, " << totals.accepted
            << " accepted (";
  for (const auto& [state, count] : totals.goals) std::cout << ' ' << state << ' ' << count;
  std::cout << " ), " << totals.acknowledged << " batches acknowledged, " << totals.ways_made << " ways made, "
            << totals.stood << " looks at who stands, " << totals.led_back << " led back, " << totals.broken
            << " seeds broke an invariant\n";
}

/// Returns why the simulations checked too little: robots hardly drove, or were in nobody's way; empty: they did not.
std::string too_quiet(const Options& options, const Totals& totals) {
  constexpr std::size_t crowd = 10;       // robots
  constexpr double hours_each_way = 5.0;  // of a robot
  constexpr double least_share = 0.8;     // of the goals that nobody cancelled
  const auto count = [&](const char* state) {
    const auto found = totals.goals.find(state);
    return found == totals.goals.end() ? 0.0 : static_cast<double>(found->second);
  };
  std::ostringstream why;
  if (static_cast<double>(totals.accepted) < totals.hours) {
    why << totals.accepted << " goals were accepted in " << totals.hours << " robot-hours: less than one each";
    return why.str();
  }
  const bool is_crowd = options.people == weft::simulation::People::none && options.robots >= crowd;
  if (is_crowd && static_cast<double>(totals.ways_made) < totals.hours / hours_each_way) {
    why << totals.ways_made << " ways were made and standstills ended in " << totals.hours
        << " robot-hours: less than one in " << hours_each_way;
    return why.str();
  }
  if (!options.told.empty()) return {};
  double all = 0.0;
  for (const auto& [state, number] : totals.goals) all += static_cast<double>(number);
  const double wanted = all - count("cancelled");
  if (wanted <= 0.0 || count("succeeded") < least_share * wanted) {
    why << "of " << wanted << " goals that nobody cancelled only " << count("succeeded") << " succeeded";
  }
  return why.str();
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  Seeds seeds;
  CLI::App app(
      "Simulates whole fleets under faults, each seed on each site, and checks what must always hold. Prints the "
      "seed of each failure;\n"
      "the same seed gives the same trace.",
      "tests/simulate");
  app.add_option("--seeds", options.seeds, "Seeds A to B, or one")
      ->capture_default_str()
      ->type_name("A..B")
      ->check([&](const std::string& text) {
        return parse(text, seeds) ? std::string() : "'" + text + "' is not A..B with A <= B";
      });
  app.add_option("--site", options.sites,
                 "a site, or several: ring (one way round, sidings), aisles (one driven both\n"
                 "ways, a crossing); all when not given")
      ->delimiter(',')
      ->type_name("NAME")
      ->check(CLI::IsMember(weft::simulation::site_names()).description(""));
  app.add_option("--robots", options.robots,
                 "robots in each fleet, 1 to 200; more than 8 live on larger aisles\n"
                 "whose map is stored at first")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, weft::simulation::kMostStored).description(""));
  app.add_option("--map", options.map,
                 "taught: by the robots themselves; stored: of larger aisles, in the\n"
                 "store at first; taught for up to 8 robots when not given")
      ->type_name("taught|stored")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, weft::simulation::MapFrom>{{"taught", weft::simulation::MapFrom::taught},
                                                                       {"stored", weft::simulation::MapFrom::stored}})
                      .description(""));
  app.add_option("--people", options.people,
                 "help: send away and lead away who stands in others' way; none: only\n"
                 "find lost robots and lead back who stands askew; help when not given")
      ->type_name("none|help")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, weft::simulation::People>{{"none", weft::simulation::People::none},
                                                                      {"help", weft::simulation::People::help}})
                      .description(""));
  app.add_option("--focus", options.focus,
                 "rules, stops or teaching: people lay down rules, press stops, or\n"
                 "teach some more, most of the time, and do something four times\n"
                 "as often")
      ->type_name("rules|stops|teaching")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, weft::simulation::Focus>{{"rules", weft::simulation::Focus::rules},
                                                                     {"stops", weft::simulation::Focus::stops},
                                                                     {"teaching", weft::simulation::Focus::teaching}})
                      .description(""));
  app.add_option("--hours", options.hours, "simulated hours of errands for each seed, 0.05 to 1000")
      ->capture_default_str()
      ->type_name("H")
      ->check(CLI::Range(0.05, 1000.0).description(""));
  app.add_option("--jobs", options.jobs, "seeds at once, 1 to 64")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, 64).description(""));
  app.add_flag("--verbose", options.verbose, "a line for each seed, with its trace hash");
  app.add_option("--tell", options.told,
                 "invariants that are told when they break, and do not end a life or\n"
                 "fail: progress, named, yields, goals; no share of goals has to succeed\n"
                 "then either")
      ->delimiter(',')
      ->type_name("NAME")
      ->check(CLI::IsMember({"progress", "named", "yields", "goals"}).description(""));
  app.add_flag("--keep-going", options.keep_going, "go on after a failure");
  app.add_flag("--diary", options.diary,
               "the server's events of each seed, and how goals and robots stand at its end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "simulate: " << error.what() << "; see tests/simulate --help\n";
    return 2;
  }
  parse(options.seeds, seeds);
  if (const std::string problem = settle(options); !problem.empty()) {
    std::cerr << "simulate: " << problem << "; see tests/simulate --help\n";
    return 2;
  }
  const std::vector<Life> lives = lives_of(options, seeds);

  int ends[2];
  if (pipe(ends) != 0) return 1;
  std::vector<pid_t> children;
  for (std::size_t worker = 0; worker < options.jobs; ++worker) {
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      work(options, lives, worker, ends[1]);
    }
    children.push_back(child);
  }
  close(ends[1]);

  const auto began = std::chrono::steady_clock::now();
  Tally tally;
  std::set<Life> lived;
  std::uint64_t done = 0;
  std::uint64_t broken = 0;
  double hours = 0.0;
  FILE* in = fdopen(ends[0], "r");
  char* buffer = nullptr;
  std::size_t size = 0;
  while (getline(&buffer, &size, in) > 0) {
    const std::string line(buffer);
    if (line[0] == '!') {
      std::cout << line.substr(2) << std::flush;
      continue;
    }
    lived.insert(add(tally, line));
    ++done;
    broken = 0;
    hours = 0.0;
    for (const auto& [site, totals] : tally) {
      broken += totals.broken;
      hours += totals.hours;
    }
    if (options.verbose) std::cout << "seed " << line << std::flush;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (done % 10 == 0 || done == lives.size()) {
      std::cout << done << " of " << lives.size() << " lives, " << static_cast<std::uint64_t>(hours)
                << " robot-hours, " << static_cast<std::uint64_t>(hours * 3600.0 / spent)
                << " robot-seconds a second, "
                << static_cast<std::uint64_t>(spent / static_cast<double>(done) *
                                              static_cast<double>(lives.size() - done))
                << " s remaining\n"
                << std::flush;
    }
    if (broken > 0 && !options.keep_going) {
      for (const pid_t child : children) kill(child, SIGKILL);
      break;
    }
  }
  free(buffer);
  fclose(in);
  bool died = false;
  bool quiet = false;
  for (std::size_t worker = 0; worker < children.size(); ++worker) {
    int status = 0;
    waitpid(children[worker], &status, 0);
    const std::string end = early_end(status);
    if (end.empty()) continue;
    died = true;
    if (broken == 0)
      std::cout << "a worker ended early, " << end << living(lives, lived, worker, options.jobs) << '\n';
  }
  for (const auto& [site, totals] : tally) {
    say(site, totals);
    const std::string why = done == lives.size() ? too_quiet(options, totals) : "";
    quiet = quiet || !why.empty();
    if (!why.empty()) std::cout << site << ": " << why << '\n';
  }
  return broken > 0 || died || done != lives.size() || quiet ? 1 : 0;
} catch (const std::exception& problem) {
  std::fprintf(stderr, "simulate: ended by a defect: %s\n", problem.what());
  return 1;
}
