#include <algorithm>
#include <chrono>
#include <cmath>

#include "clients/cli/session.hpp"

/// Holds what a session does that is more than a question and its answer: uploads, fetches, measures.
namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr Duration kListenMeanwhile = 100ms;

}  // namespace

Result<void> Session::upload(Uploader& uploader, Duration quiet) {
  SteadyTime give_up = world_.now() + quiet;
  std::size_t acknowledged = uploader.acknowledged();
  while (!uploader.done()) {
    for (msg::Message& message : uploader.due(world_.now())) {
      if (auto* const batch = std::get_if<msg::ExperienceBatch>(&message)) batch->header = header();
      if (auto* const chunk = std::get_if<msg::Chunk>(&message)) chunk->header = header();
      // The rest is asked for, or repeated, later: a full queue takes no more.
      std::ignore = link_.send(message);
    }
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const ack = std::get_if<msg::BatchAck>(&*message);
      if (ack == nullptr || ack->to != self_) continue;
      if (const Result<void> heard = uploader.hear(*ack); !heard) return heard;
    }
    if (uploader.acknowledged() > acknowledged) {
      acknowledged = uploader.acknowledged();
      give_up = world_.now() + quiet;
    }
    if (world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server has acknowledged " + std::to_string(acknowledged) +
                                            " batches and no more for " +
                                            std::to_string(std::lround(seconds(quiet))) +
                                            " s: look with `weft doctor`, then import again under the same name");
    }
    if (!uploader.done()) world_.wait(kListenMeanwhile);
  }
  return {};
}

Result<void> Session::fetch(ContentFetcher& fetcher, Duration quiet) {
  SteadyTime give_up = world_.now() + quiet;
  std::uint64_t received = 0;
  while (!fetcher.done()) {
    if (std::optional<msg::ContentRequest> request = fetcher.due(world_.now())) {
      request->header = header();
      std::ignore = link_.send(*request);  // what a full queue does not take is asked for again
    }
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const chunk = std::get_if<msg::Chunk>(&*message);
      if (chunk == nullptr || chunk->to != self_) continue;
      if (const Result<void> heard = fetcher.hear(*chunk, world_.now()); !heard) return heard;
    }
    if (fetcher.received() > received) {
      received = fetcher.received();
      give_up = world_.now() + quiet;
    }
    if (world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server has sent " + std::to_string(fetcher.fetched()) + " of " +
                                            std::to_string(fetcher.wanted()) + " contents and no more for " +
                                            std::to_string(std::lround(seconds(quiet))) +
                                            " s: look with `weft doctor` and `weft map check`, then try again");
    }
    if (!fetcher.done()) world_.wait(kListenMeanwhile);
  }
  return {};
}

Result<EchoReport> Session::measure(Duration at_most) {
  const SteadyTime give_up = world_.now() + at_most;
  EchoProbe probe(random_.next() | 1U, world_.now());
  while (!probe.done(world_.now())) {
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const echo = std::get_if<msg::Echo>(&*message);
      if (echo != nullptr && echo->to == self_) probe.hear(*echo, world_.now());
    }
    if (!probe.reaches() && world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server gave no echo back in " +
                                            std::to_string(std::lround(seconds(at_most))) +
                                            " s: is it of an older version, or measured by others at this moment?");
    }
    if (std::optional<msg::Echo> echo = probe.due(world_.now())) {
      echo->header = header();
      std::ignore = link_.send(*echo);  // what a full queue does not take is lost
    }
    world_.wait(std::clamp(probe.next() - world_.now(), Duration{1ms}, kListenMeanwhile));
  }
  return probe.report();
}

}  // namespace weft::cli
