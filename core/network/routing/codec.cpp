#include <algorithm>
#include <cmath>

#include "core/byte_reader.hpp"
#include "core/byte_writer.hpp"
#include "core/network/routing/cells.hpp"
#include "core/network/routing/draft.hpp"
#include "core/network/routing/routing.hpp"
#include "core/network/routing/work.hpp"

namespace weft::routing {
namespace {

constexpr std::uint8_t kFormat = 1;
constexpr std::size_t kMostMethods = 64;
constexpr std::uint32_t kMostSlots = 1U << kSlotBits;
constexpr std::uint32_t kMostCells = 1U << (32 - kSlotBits - 1);

/// Returns a 64-bit FNV-1a of what a base cell's costs were computed from: its places and arcs.
std::uint64_t fingerprint(const BaseCell& cell) {
  ByteWriter out;
  for (const PlaceId& place : cell.places) out.id(place);
  for (const std::uint32_t first : cell.first_arc) out.number(first);
  for (const Arc& arc : cell.arcs) {
    out.number(arc.to);
    out.f64(arc.cost);
  }
  std::uint64_t hash = 14695981039346656037ULL;
  for (const std::uint8_t byte : out.view()) hash = (hash ^ byte) * 1099511628211ULL;
  return hash;
}

void write(ByteWriter& out, const Overlay& overlay) {
  for (const auto* const border : {&overlay.entries, &overlay.exits}) {
    out.count(border->size());
    for (const Node node : *border) out.number(node);
  }
  for (const double cost : overlay.costs) out.f64(cost);
}

std::vector<Node> read_border(ByteReader& in, const char* field) {
  std::vector<Node> border(in.count(field, sizeof(Node)));
  for (Node& node : border) node = in.number<Node>(field);
  return border;
}

Overlay read_overlay(ByteReader& in) {
  Overlay overlay;
  overlay.entries = read_border(in, "entry");
  overlay.exits = read_border(in, "exit");
  const std::size_t at = in.offset();
  const std::uint64_t costs = std::uint64_t{overlay.entries.size()} * overlay.exits.size();
  for (std::uint64_t i = 0; i < costs && in.ok(); ++i) {
    const double cost = in.f64("cost");
    if (!(cost >= 0.0)) in.corrupt("cost", at, "is no cost");
    overlay.costs.push_back(cost);
  }
  overlay.costs.shrink_to_fit();
  return overlay;
}

/// Holds a preparation as the bytes state it, before it is compared with the network.
struct Written {
  Preparation made;
  std::vector<std::uint64_t> fingerprints;
};

void read_base(ByteReader& in, Written& written) {
  const auto cells = in.ranged<std::uint32_t>("base cells", 0, kMostCells);
  for (std::uint32_t cell = 0; cell < cells && in.ok(); ++cell) {
    auto base = std::make_shared<BaseCell>();
    const std::size_t at = in.offset();
    const std::size_t slots = in.count("slots", 12);
    if (slots > kMostSlots) in.corrupt("slots", at, "are more than " + std::to_string(kMostSlots));
    for (std::size_t slot = 0; slot < slots && in.ok(); ++slot) base->places.push_back(in.place_id("place"));
    base->first_arc.push_back(0);
    written.made.base.push_back(std::move(base));
    written.fingerprints.push_back(in.number<std::uint64_t>("fingerprint"));
    std::array<std::uint32_t, kLevels> above{};
    above[0] = cell;
    for (std::size_t level = 1; level < kLevels; ++level) {
      above[level] = in.ranged<std::uint32_t>("cell above", 0, kMostCells);
    }
    written.made.cells.push_back(above);
  }
}

void read_overlays(ByteReader& in, Preparation& made) {
  for (std::size_t level = 0; level < kLevels; ++level) {
    const std::size_t at = in.offset();
    const std::size_t cells = in.count("cells of a level", 8);
    if (level == 0 && cells != made.base.size()) in.corrupt("cells of a level", at, "are not the base cells");
    for (std::size_t cell = 0; cell < cells && in.ok(); ++cell) {
      made.overlays[level].push_back(std::make_shared<const Overlay>(read_overlay(in)));
    }
  }
}

/// Fills in each cell's children. corrupt: a cell that lies in none or in two of the next level, or that is empty.
void nest(ByteReader& in, Preparation& made) {
  for (std::size_t level = 1; level < kLevels && in.ok(); ++level) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> parent(made.overlays[level - 1].size(), kNone);
    for (const auto& cells : made.cells) {
      if (cells[level] >= made.overlays[level].size()) {
        return in.corrupt("cell above", in.offset(), "is not there");
      }
      std::uint32_t& known = parent[cells[level - 1]];
      if (known != kNone && known != cells[level])
        return in.corrupt("cell above", in.offset(), "is not the only one");
      known = cells[level];
    }
    std::vector<std::vector<std::uint32_t>> children(made.overlays[level].size());
    for (std::uint32_t child = 0; child < parent.size(); ++child) {
      if (parent[child] == kNone) return in.corrupt("cell", in.offset(), "has nothing in it");
      children[parent[child]].push_back(child);
    }
    for (std::size_t cell = 0; cell < children.size(); ++cell) {
      if (children[cell].empty()) return in.corrupt("cell", in.offset(), "has nothing in it");
      auto overlay = std::make_shared<Overlay>(*made.overlays[level][cell]);
      overlay->children = std::move(children[cell]);
      made.overlays[level][cell] = std::move(overlay);
    }
  }
}

/// Gives the network's places their nodes; slots of places that it does not have become empty.
void number(ByteReader& in, Preparation& made) {
  FlatMap<ExperienceId, std::shared_ptr<std::vector<Node>>> nodes;
  for (const auto& [id, experience] : made.of.experiences()) {
    auto row = std::make_shared<std::vector<Node>>();
    std::size_t size = 0;
    for (const Place& place : experience->places) size = std::max<std::size_t>(size, place.id.index + 1);
    row->assign(size, kNoNode);
    nodes.emplace(id, std::move(row));
  }
  for (std::uint32_t cell = 0; cell < made.base.size(); ++cell) {
    auto base = std::make_shared<BaseCell>(*made.base[cell]);
    for (std::uint32_t slot = 0; slot < base->places.size(); ++slot) {
      PlaceId& place = base->places[slot];
      if (!place) continue;
      if (made.of.place(place) == nullptr) {
        place = PlaceId{};
        continue;
      }
      Node& node = (*(*nodes.find(place.experience)).second)[place.index];
      if (node != kNoNode) return in.corrupt("place", in.offset(), to_string(place) + " is there twice");
      node = node_at(cell, slot);
    }
    made.base[cell] = std::move(base);
  }
  for (const auto& [id, row] : nodes) made.nodes.emplace(id, row);
}

/// Holds what was written against the network: gives nodes to places that have none, joins all cells, and makes anew
/// what differs.
class Resuming final : public Work {
 public:
  explicit Resuming(Written written)
      : network_(written.made.of),
        next_experience_(network_.experiences().begin()),
        draft_(std::move(written.made)),
        fingerprints_(std::move(written.fingerprints)) {}

  std::size_t piece() override {
    if (next_experience_ != network_.experiences().end()) return look_for_new(*(next_experience_++)->second);
    const Preparation& made = draft_.preparation();
    if (next_cell_ == made.base.size()) return draft_.step();
    const std::uint32_t cell = next_cell_++;
    draft_.join(cell, [&](const BaseCell& joined) {
      return cell < fingerprints_.size() && fingerprint(joined) == fingerprints_[cell];
    });
    return 1 + made.base[cell]->places.size();
  }
  double share_done() const override {
    const auto cells = static_cast<double>(std::max<std::size_t>(1, draft_.preparation().base.size()));
    return 0.5 * next_cell_ / cells + 0.5 / static_cast<double>(1 + draft_.left_to_do());
  }
  Preparation take() override { return draft_.take(); }

 private:
  std::size_t look_for_new(const Experience& experience) {
    for (const Place& place : experience.places) {
      if (draft_.preparation().node(place.id) == kNoNode) draft_.add(place.id);
    }
    return 1 + experience.places.size() / 16;
  }

  Snapshot network_;
  Snapshot::Experiences::const_iterator next_experience_;
  Draft draft_;
  std::vector<std::uint64_t> fingerprints_;
  std::uint32_t next_cell_ = 0;
};

}  // namespace

Bytes encode(const Preparation& preparation) {
  ByteWriter out;
  out.number(kFormat);
  out.number(preparation.of.revision().value);
  out.count(preparation.methods.size());
  for (const std::string& method : preparation.methods) out.text(method);
  out.count(preparation.base.size());
  for (std::size_t cell = 0; cell < preparation.base.size(); ++cell) {
    const BaseCell& base = *preparation.base[cell];
    out.count(base.places.size());
    for (const PlaceId& place : base.places) out.id(place);
    out.number(fingerprint(base));
    for (std::size_t level = 1; level < kLevels; ++level) out.number(preparation.cells[cell][level]);
  }
  for (const auto& level : preparation.overlays) {
    out.count(level.size());
    for (const auto& overlay : level) write(out, *overlay);
  }
  return out.take();
}

Result<Builder> Builder::to_resume(ByteView bytes, const Snapshot& snapshot) {
  ByteReader in(bytes);
  in.ranged<std::uint8_t>("format", kFormat, kFormat);
  in.number<std::uint64_t>("revision");
  Written written;
  const std::size_t methods = in.count("methods", 4);
  if (methods > kMostMethods) in.corrupt("methods", in.offset(), "are more than " + std::to_string(kMostMethods));
  for (std::size_t i = 0; i < methods && in.ok(); ++i) written.made.methods.insert(in.text("method"));
  read_base(in, written);
  read_overlays(in, written.made);
  const Result<void> end = in.finish("prepared routes");
  if (!end) return fail(end.error());
  written.made.of = snapshot;
  nest(in, written.made);
  if (in.ok()) number(in, written.made);
  const Result<void> sound = in.finish("prepared routes");
  if (!sound) return fail(sound.error());
  return Builder(std::make_unique<Resuming>(std::move(written)));
}

Result<Preparation> decode(ByteView bytes, const Snapshot& snapshot) {
  Result<Builder> builder = Builder::to_resume(bytes, snapshot);
  if (!builder) return fail(builder.error());
  return builder->finish();
}

}  // namespace weft::routing
