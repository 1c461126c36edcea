#include "clients/evaluate/charts/draw.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

extern char** environ;

namespace weft::evaluate {
namespace {

/// Tells how a program ended: its output, and why it is to be taken as failed; empty: it ended with 0.
struct Ran {
  std::string printed;
  std::string failure;
};

std::string read_all(int from) {
  std::string all;
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t count = ::read(from, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return all;
    all.append(part.data(), static_cast<std::size_t>(count));
  }
}

/// Starts the program without a shell, both of its outputs in one pipe, and waits for its end.
Ran run(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {"", std::strerror(errno)};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Ran ran;
  if (error == 0) ran.printed = read_all(ends[0]);
  close(ends[0]);
  if (error != 0) return {"", words.front() + ": " + std::strerror(error)};
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) ran.failure = "it failed without a word";
  return ran;
}

}  // namespace

std::filesystem::path Drawer::script_of_this_build() {
  return WEFT_CHARTS "/draw.py";
}

std::vector<std::string> draw_pictures(const std::string& study, const std::filesystem::path& folder,
                                       const Surroundings& around, const Drawer& drawer) {
  const std::string drawn = "drawn: ";
  Ran ran = run({drawer.python.string(), drawer.script.string(), study, folder.string()});
  std::vector<std::string> pictures;
  std::istringstream lines(ran.printed);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(drawn)) pictures.push_back(line.substr(drawn.size()));
    if (!line.starts_with(drawn) && !ran.failure.empty()) ran.failure = line;
  }
  if (!ran.failure.empty()) {
    around.progress << "weft-evaluate: warning: not all pictures are drawn: " << ran.failure
                    << "; what was measured is kept. Draw them with: " << drawer.python.string() << ' '
                    << drawer.script.string() << ' ' << study << ' ' << folder.string() << '\n';
  }
  return pictures;
}

std::string words_of(const std::vector<std::string>& pictures) {
  if (pictures.empty()) return "no pictures";
  return pictures.size() == 1 ? pictures.front() : std::to_string(pictures.size()) + " pictures";
}

}  // namespace weft::evaluate
