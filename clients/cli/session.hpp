#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/content_fetcher.hpp"
#include "clients/cli/echo_probe.hpp"
#include "clients/cli/uploader.hpp"
#include "core/network/page.hpp"
#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "idl/bus/link.hpp"

namespace weft::cli {

/// Gives a session the clocks and the wait that it needs of the world; a test gives it virtual ones.
struct World {
  std::function<SteadyTime()> now;
  std::function<WallTime()> wall;
  std::function<void(Duration)> wait;                        ///< at most so long; less when something has come in
  std::function<bool()> interrupted = [] { return false; };  ///< somebody wants this to end
};

/// Holds one operator's conversation with the server: asks, repeats with the same number what is not answered, and
/// puts answers together from their parts. Not for several threads.
class Session {
 public:
  /// Begins a conversation; `name` is the operator, as events will show it.
  Session(bus::Link& link, World world, Random random, PeerId self, std::string name);

  /// Says hello to the server. unavailable: none has answered within `at_most`; refused: it speaks no protocol
  /// version that we do.
  Result<msg::Hello> connect(Duration at_most);
  using Progress = std::function<void(const msg::OperatorReply&)>;
  /// Sends the request and returns the answer. timed_out: there was none within `at_most`, or, of long work, no
  /// progress report for that time; what the request asked for may still happen.
  Result<msg::OperatorReply> ask(msg::OperatorRequest request, Duration at_most, const Progress& under_way = {});
  /// Asks the server, and joins all parts of its answer. timed_out: there was none within `at_most`, or somebody
  /// wants this to end. refused, internal: in the server's words, why it has none.
  Result<msg::QueryReply> query(msg::Query query, Duration at_most);
  struct Wanted {
    Revision at = {};          ///< 0: as it is
    Revision apart_from = {};  ///< only runs that differ from those of that revision; 0: all
  };
  using PageProgress = std::function<void(const PagedNetwork&)>;
  /// Asks for the whole network, page by page, none of which may take longer than `at_most`.
  Result<Window> network(Wanted wanted, Duration at_most, const PageProgress& under_way = {});

  /// Uploads until all of it is on the server's disk. timed_out: nothing new was acknowledged for `quiet`; refused:
  /// in the server's words. What was acknowledged stays.
  Result<void> upload(Uploader& uploader, Duration quiet);

  /// Fetches until all contents are there. timed_out: nothing came for `quiet`, the server's store may be damaged.
  /// Errors of the fetcher.
  Result<void> fetch(ContentFetcher& fetcher, Duration quiet);

  /// Waits for what the server says unasked, until then at most.
  void listen(SteadyTime until);
  /// Returns the events that came since the last time and that the server's store could not keep, oldest first.
  std::vector<msg::Event> take_unkept() { return std::exchange(unkept_, {}); }
  /// Measures the network between here and the server by echoes. timed_out: the server gave none back within
  /// `at_most`.
  Result<EchoReport> measure(Duration at_most);

  GoalId new_goal();
  std::string vendor() const { return link_.bus().vendor(); }
  const World& world() const { return world_; }

 private:
  msg::Header header();
  msg::Hello hello() const;
  void note(const msg::Hello& hello);
  void note(const msg::EventNote& event);
  void note_unasked(const msg::Message& message);
  /// Sends with growing pauses until `heard` says that the answer is whole. Has the link opened anew where nothing is
  /// answered for long.
  Result<void> converse(const msg::Message& question, Duration at_most,
                        const std::function<bool(const msg::Message&)>& heard);

  bus::Link& link_;
  World world_;
  Random random_;
  PeerId self_;
  std::string name_;
  std::uint64_t incarnation_;
  std::uint64_t challenge_;
  std::uint64_t sequence_ = 0;
  bool is_server_heard_ = false;
  std::optional<msg::Hello> server_;  ///< has answered our challenge
  std::vector<msg::Event> unkept_;
};

}  // namespace weft::cli
