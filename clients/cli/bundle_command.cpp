#include <array>
#include <filesystem>
#include <sstream>
#include <utility>

#include "clients/cli/commands.hpp"
#include "clients/cli/machine_files.hpp"
#include "clients/cli/redact.hpp"
#include "core/text.hpp"
#include "storage/formats/gzip.hpp"
#include "storage/formats/tar.hpp"
#include "storage/spool/durable_file.hpp"

/// Holds `weft bundle`: one archive for a bug report.
namespace weft::cli {
namespace {

using Command = Invocation::Command;

constexpr const char* kSettings = "/etc/weft";
constexpr unsigned kMostEvents = 1000;

/// Describes a file of the archive that a command of weft says, as with --json.
struct Question {
  const char* file;
  Command command;
  Exit (*run)(Session&, const Invocation&, const Output&);
};
constexpr std::array kQuestions{Question{"robots.json", Command::robots, run_robots},
                                Question{"alarms.json", Command::alarms, run_alarms},
                                Question{"events.jsonl", Command::events, run_events},
                                Question{"goals.json", Command::goal_list, run_goals},
                                Question{"map-info.json", Command::map_info, run_map},
                                Question{"map-stats.json", Command::map_stats, run_map_work}};

/// Gathers the files of the archive one after another, and says which.
class Gathering {
 public:
  Gathering(Session& session, const Invocation& invocation, const Output& output)
      : session_(session), invocation_(invocation), output_(output) {}

  /// Gathers everything that can be had. False: it was interrupted.
  bool gather() {
    ask_server();
    add("versions.json", versions());
    add("machine.txt", describe_machine());
    take(read_settings(kSettings, invocation_.settings));
    take(read_logs(invocation_.logs));
    members_.insert(members_.begin(), {"README.txt", readme()});
    for (formats::TarMember& member : members_) member.name = "weft-report/" + member.name;
    return !interrupted();
  }

  const std::vector<formats::TarMember>& members() const { return members_; }
  const std::vector<std::pair<std::string, std::string>>& missing() const { return missing_; }

 private:
  bool interrupted() const { return session_.world().interrupted(); }

  void add(const std::string& file, std::string text) {
    if (interrupted()) return;
    output_.err << "weft: " << file << ", " << text.size() << " bytes" << std::endl;
    members_.push_back({file, std::move(text)});
  }

  void miss(const std::string& what, const std::string& why) {
    if (interrupted()) return;
    output_.err << "weft: without " << what << ": " << one_line(why) << std::endl;
    missing_.emplace_back(what, one_line(why));
  }

  void ask_server() {
    const Result<msg::Hello> server = session_.connect(reach(invocation_));
    if (!server) return miss("all that the server says", server.error().message);
    const auto doctor = [&server](Session& session, const Invocation& asked, const Output& output) {
      return run_doctor(session, *server, asked, output);
    };
    ask("doctor.json", Command::doctor, doctor);
    for (const auto& [file, command, run] : kQuestions) ask(file, command, run);
  }

  template <class Run>
  void ask(const char* file, Command command, const Run& run) {
    if (interrupted()) return;
    Invocation asked = invocation_;
    asked.command = command;
    asked.json = true;
    asked.last = kMostEvents;
    asked.file.clear();
    std::ostringstream out;
    std::ostringstream err;
    const Exit exit = run(session_, asked, Output{out, err});
    const bool tells_by_exit = command == Command::doctor || command == Command::alarms;
    if (exit == Exit::done || (tells_by_exit && exit == Exit::failed && err.str().empty())) {
      add(file, out.str());
    } else {
      miss(file, err.str());
    }
  }

  void take(const std::vector<MachineFile>& files) {
    for (const MachineFile& file : files) {
      if (file.text) {
        add(file.name, without_secrets(*file.text));
      } else {
        miss(file.name, file.text.error().message);
      }
    }
  }

  /// Returns what a file of the archive says; null: it is not there.
  nlohmann::json document(std::string_view file) const {
    for (const formats::TarMember& member : members_) {
      if (member.name == file) return nlohmann::json::parse(member.text, nullptr, false);
    }
    return {};
  }

  std::string versions() const {
    nlohmann::json versions = {{"weft", {{"software", WEFT_VERSION}, {"vendor", session_.vendor()}}}};
    if (const nlohmann::json info = document("map-info.json"); info.is_object()) {
      for (const char* const what : {"software", "vendor", "engine"}) versions["weft-server"][what] = info[what];
    }
    if (const nlohmann::json robots = document("robots.json"); robots.is_object()) {
      for (const nlohmann::json& robot : robots["robots"]) {
        versions["weft-agent"][robot["name"].get<std::string>()] = {{"software", robot["software"]},
                                                                    {"vendor", robot["vendor"]}};
      }
    }
    return printed(versions) + "\n";
  }

  std::string readme() const {
    std::string text = "What `weft bundle` gathered for a bug report at " + iso_time(session_.world().wall()) +
                       ".\nNo image, content or place of the map is in it; settings and logs are without passwords, "
                       "tokens and keys.\nLook through it before you pass it on: robots, labels, hosts and operators "
                       "are named.\n\n";
    for (const formats::TarMember& member : members_) text += member.name + "\n";
    for (const auto& [what, why] : missing_) text += "without " + what + ": " + why + "\n";
    return text;
  }

  Session& session_;
  const Invocation& invocation_;
  const Output& output_;
  std::vector<formats::TarMember> members_;
  std::vector<std::pair<std::string, std::string>> missing_;
};

/// Checks the archive's name before anything is gathered. invalid: what is wrong with it.
Result<void> check_target(const std::string& file) {
  std::error_code failed;
  if (!file.ends_with(".tar.gz")) {
    return fail(ErrorCode::invalid, file + ": the archive's name must end in .tar.gz");
  }
  if (std::filesystem::exists(std::filesystem::symlink_status(file, failed))) {
    return fail(ErrorCode::invalid, file + ": is there already; give another name, or remove it");
  }
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder, failed)) {
    return fail(ErrorCode::invalid, file + ": there is no folder " + folder.string());
  }
  return {};
}

/// Writes the archive as a whole or not at all.
Result<std::size_t> write(const Gathering& gathered, const std::string& file, WallTime at) {
  const Result<Bytes> archive = formats::tar_of(gathered.members(), at);
  if (!archive) return fail(archive.error());
  const Result<Bytes> packed = formats::gzip(*archive);
  if (!packed) return fail(packed.error());
  if (const Result<void> free = check_target(file); !free) return fail(free.error());  // meanwhile, perhaps
  const Result<void> written = storage::write_durably(std::filesystem::absolute(file), *packed);
  if (!written) return fail(written.error());
  return packed->size();
}

}  // namespace

Exit run_bundle(Session& session, const Invocation& invocation, const Output& output) {
  const std::string& file = invocation.file;
  if (const Result<void> good = check_target(file); !good) {
    return report_offline(good.error(), invocation.json, output);
  }
  Gathering gathering(session, invocation, output);
  if (!gathering.gather()) {
    return report({ErrorCode::internal, "interrupted: " + file + " was not written"}, invocation.json, output);
  }
  const Result<std::size_t> bytes = write(gathering, file, session.world().wall());
  if (!bytes) return report_offline(bytes.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {
        {"file", file}, {"bytes", *bytes}, {"files", nlohmann::json::array()}, {"missing", nlohmann::json::array()}};
    for (const formats::TarMember& member : gathering.members()) document["files"].push_back(member.name);
    for (const auto& [what, why] : gathering.missing()) document["missing"].push_back({{"what", what}, {"why", why}});
    output.out << printed(document) << '\n';
  } else {
    output.out << file << ": " << gathering.members().size() << " files, " << *bytes << " bytes";
    if (!gathering.missing().empty())
      output.out << "; without " << gathering.missing().size() << " that are named above and in README.txt";
    output.out << '\n';
  }
  return Exit::done;
}

}  // namespace weft::cli
