// Loses, delays and reorders the packets of one NFQUEUE, by seed: what tc netem does, where the kernel has none.
// netfault --queue N --seed N --loss SHARE --delay-ms MS --jitter-ms MS --overtake SHARE
// A packet waits for the delay and up to the jitter, and no earlier than the one before it unless it overtakes.
// Prints "passed N lost N overtook N" when it is told to end by SIGTERM or SIGINT.
#include <arpa/inet.h>
#include <libmnl/libmnl.h>
#include <libnetfilter_queue/libnetfilter_queue.h>
#include <linux/netfilter.h>
#include <linux/netfilter/nfnetlink_queue.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
volatile std::sig_atomic_t is_over = 0;

struct Settings {
  std::uint16_t queue = 0;
  std::uint32_t seed = 1;
  double loss = 0.0;
  double delay_ms = 0.0;
  double jitter_ms = 0.0;
  double overtake = 0.0;
};

/// Reads one number within bounds; none: it is none.
std::optional<double> number(const char* text, double low, double high) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || *end != '\0' || !(value >= low) || !(value <= high)) return std::nullopt;
  return value;
}

std::optional<Settings> read(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; i += 2) {
    const std::string flag = argv[i];
    const bool is_share = flag == "--loss" || flag == "--overtake";
    const std::optional<double> value =
        i + 1 < argc ? number(argv[i + 1], 0.0, is_share ? 1.0 : 65535.0) : std::nullopt;
    if (!value) return std::nullopt;
    if (flag == "--queue")
      settings.queue = static_cast<std::uint16_t>(*value);
    else if (flag == "--seed")
      settings.seed = static_cast<std::uint32_t>(*value);
    else if (flag == "--loss")
      settings.loss = *value;
    else if (flag == "--delay-ms")
      settings.delay_ms = *value;
    else if (flag == "--jitter-ms")
      settings.jitter_ms = *value;
    else if (flag == "--overtake")
      settings.overtake = *value;
    else
      return std::nullopt;
  }
  return settings;
}

class Queue {
 public:
  explicit Queue(const Settings& settings) : settings_(settings), random_(settings.seed) {}
  ~Queue() {
    if (socket_ != nullptr) mnl_socket_close(socket_);
  }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  bool open() {
    socket_ = mnl_socket_open(NETLINK_NETFILTER);
    if (socket_ == nullptr || mnl_socket_bind(socket_, 0, MNL_SOCKET_AUTOPID) < 0) return false;
    nlmsghdr* header = begin(NFQNL_MSG_CONFIG);
    nfq_nlmsg_cfg_put_cmd(header, AF_INET, NFQNL_CFG_CMD_BIND);
    if (!send(header)) return false;
    header = begin(NFQNL_MSG_CONFIG);
    nfq_nlmsg_cfg_put_params(header, NFQNL_COPY_META, 0);
    nfq_nlmsg_cfg_put_qmaxlen(header, 20000);
    // Packets that do not fit pass: a loss that was not drawn would not be repeatable.
    mnl_attr_put_u32(header, NFQA_CFG_FLAGS, htonl(NFQA_CFG_F_FAIL_OPEN));
    mnl_attr_put_u32(header, NFQA_CFG_MASK, htonl(NFQA_CFG_F_FAIL_OPEN));
    return send(header);
  }

  bool run() {
    std::vector<char> buffer(1U << 16U);
    while (is_over == 0) {
      release(Clock::now());
      pollfd on{mnl_socket_get_fd(socket_), POLLIN, 0};
      if (poll(&on, 1, wait_ms()) <= 0) continue;
      const auto got = mnl_socket_recvfrom(socket_, buffer.data(), buffer.size());
      if (got < 0 && errno != ENOBUFS && errno != EINTR) return false;
      if (got > 0)
        mnl_cb_run(buffer.data(), static_cast<std::size_t>(got), 0, mnl_socket_get_portid(socket_), take, this);
    }
    release(Clock::time_point::max());
    std::printf("passed %llu lost %llu overtook %llu\n", static_cast<unsigned long long>(passed_),
                static_cast<unsigned long long>(lost_), static_cast<unsigned long long>(overtook_));
    return true;
  }

 private:
  static int take(const nlmsghdr* header, void* self) {
    std::array<nlattr*, NFQA_MAX + 1> attributes{};
    if (nfq_nlmsg_parse(header, attributes.data()) < 0 || attributes[NFQA_PACKET_HDR] == nullptr) return MNL_CB_ERROR;
    const auto* packet = static_cast<const nfqnl_msg_packet_hdr*>(mnl_attr_get_payload(attributes[NFQA_PACKET_HDR]));
    static_cast<Queue*>(self)->judge(ntohl(packet->packet_id), Clock::now());
    return MNL_CB_OK;
  }

  void judge(std::uint32_t packet, Clock::time_point now) {
    std::uniform_real_distribution<double> draw(0.0, 1.0);
    const double fate = draw(random_);
    const double jitter = draw(random_);
    const double hurry = draw(random_);
    if (fate < settings_.loss) {
      ++lost_;
      answer(packet, NF_DROP);
      return;
    }
    Clock::time_point due = now + std::chrono::microseconds(static_cast<std::int64_t>(
                                      (settings_.delay_ms + jitter * settings_.jitter_ms) * 1e3));
    if (hurry < settings_.overtake) {
      ++overtook_;
      due = now;
    } else {
      due = std::max(due, last_due_);
      last_due_ = due;
    }
    waiting_.emplace(due, packet);
  }

  void release(Clock::time_point now) {
    while (!waiting_.empty() && waiting_.begin()->first <= now) {
      answer(waiting_.begin()->second, NF_ACCEPT);
      waiting_.erase(waiting_.begin());
      ++passed_;
    }
  }

  int wait_ms() const {
    if (waiting_.empty()) return 200;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(waiting_.begin()->first - Clock::now()).count();
    return left < 0 ? 0 : static_cast<int>(left > 200 ? 200 : left);
  }

  nlmsghdr* begin(int kind) { return nfq_nlmsg_put(out_.data(), kind, settings_.queue); }
  bool send(const nlmsghdr* header) { return mnl_socket_sendto(socket_, header, header->nlmsg_len) >= 0; }
  void answer(std::uint32_t packet, int verdict) {
    nlmsghdr* const header = begin(NFQNL_MSG_VERDICT);
    nfq_nlmsg_verdict_put(header, static_cast<int>(packet), verdict);
    send(header);
  }

  Settings settings_;
  std::mt19937 random_;
  mnl_socket* socket_ = nullptr;
  std::array<char, 4096> out_{};
  std::multimap<Clock::time_point, std::uint32_t> waiting_;
  Clock::time_point last_due_{};
  std::uint64_t passed_ = 0, lost_ = 0, overtook_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Settings> settings = read(argc, argv);
  if (!settings) {
    std::fputs(
        "netfault: wrong flags; netfault --queue N --seed N --loss 0..1 --delay-ms MS --jitter-ms MS --overtake "
        "0..1\n",
        stderr);
    return 2;
  }
  struct sigaction end {};
  end.sa_handler = [](int) { is_over = 1; };
  sigaction(SIGTERM, &end, nullptr);
  sigaction(SIGINT, &end, nullptr);
  Queue queue(*settings);
  if (!queue.open() || !queue.run()) {
    std::fprintf(stderr, "netfault: queue %u: %s\n", settings->queue, std::strerror(errno));
    return 1;
  }
  return 0;
}
