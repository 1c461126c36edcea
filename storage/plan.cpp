#include "storage/plan.hpp"

#include "core/network/codec.hpp"

namespace weft::storage {
namespace {

template <class... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

std::string name_of(const Batch& batch) {
  return "batch " + std::to_string(batch.sequence) + " of experience " + to_string(batch.experience);
}

class Planner {
 public:
  Planner(const Transaction& transaction, const Facts& facts) : facts_(facts), contents_(facts.contents) {
    plan_.experiences = facts.experiences;
    for (const auto& change : transaction.changes) {
      if (const auto* put = std::get_if<PutContent>(&change)) offered_.insert(put->hash);
    }
  }

  /// Whether the change is new.
  Result<bool> operator()(const PutContent& put) {
    if (contents_.contains(put.hash)) return false;
    if (hash_bytes(put.bytes) != put.hash) {
      return fail(ErrorCode::invalid, "content " + to_string(put.hash) + " (" + std::to_string(put.bytes.size()) +
                                          " bytes): its bytes have another SHA-256; ask the sender again");
    }
    contents_.insert(put.hash);
    return true;
  }

  Result<bool> operator()(const AppendBatch& append) {
    const Batch& batch = append.batch;
    ExperienceFacts& known = plan_.experiences[batch.experience];
    if (!batch.experience || batch.sequence == 0) {
      return fail(ErrorCode::invalid, name_of(batch) + ": sequences count from 1 and the experience has an id");
    }
    if (batch.sequence <= known.durable_through) return repeat(append);
    if (batch.sequence != known.durable_through + 1) {
      return fail(ErrorCode::conflict, name_of(batch) + ": batch " + std::to_string(known.durable_through + 1) +
                                           " must come first; send from there on");
    }
    if (auto fits = check_places(batch, known); !fits) return fail(fits.error());
    known.durable_through = batch.sequence;
    known.places += batch.places.size();
    batches_[{batch.experience, batch.sequence}] = append.hash;
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutLabel& put) {
    const auto found = plan_.experiences.find(put.place.experience);
    if (found == plan_.experiences.end() || put.place.index >= found->second.places) {
      return fail(ErrorCode::conflict, "label " + put.label + ": place " + to_string(put.place) + " is not stored");
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const SealExperience& seal) {
    const auto found = plan_.experiences.find(seal.experience);
    if (found == plan_.experiences.end() || found->second.durable_through == 0) {
      return fail(ErrorCode::conflict, "seal: experience " + to_string(seal.experience) + " is not stored");
    }
    plan_.changes_network = true;
    return true;
  }

  template <class Other>
  Result<bool> operator()(const Other&) {
    return true;
  }

  Plan take(std::vector<bool> fresh) {
    plan_.fresh = std::move(fresh);
    return std::move(plan_);
  }

 private:
  Result<bool> repeat(const AppendBatch& append) const {
    const BatchKey key{append.batch.experience, append.batch.sequence};
    const auto earlier = batches_.find(key);
    const auto stored = facts_.batches.find(key);
    const bool is_same = earlier != batches_.end()        ? earlier->second == append.hash
                         : stored != facts_.batches.end() ? stored->second == append.hash
                                                          : false;
    if (is_same) return false;
    return fail(
        ErrorCode::conflict,
        name_of(append.batch) + " is already stored with another hash; the robot must start a new experience");
  }

  Result<void> check_places(const Batch& batch, const ExperienceFacts& known) const {
    std::uint64_t next = known.places;
    for (const Place& place : batch.places) {
      if (place.id.experience != batch.experience) {
        return fail(ErrorCode::invalid,
                    name_of(batch) + ": place " + to_string(place.id) + " is of another experience");
      }
      if (place.id.index != next) {
        return fail(ErrorCode::conflict, name_of(batch) + ": place " + to_string(place.id) +
                                             " does not continue the experience; the next index is " +
                                             std::to_string(next));
      }
      if (!contents_.contains(place.content.hash) && !offered_.contains(place.content.hash)) {
        return fail(ErrorCode::conflict, name_of(batch) + ": content " + to_string(place.content.hash) +
                                             " of place " + to_string(place.id) +
                                             " is neither stored nor in the transaction");
      }
      ++next;
    }
    return {};
  }

  const Facts& facts_;
  Plan plan_;
  std::set<ContentHash> contents_;
  std::set<ContentHash> offered_;
  std::map<BatchKey, ContentHash> batches_;
};

}  // namespace

Needs needs_of(const Transaction& transaction) {
  Needs needs;
  const Match collect{
      [&](const PutContent& put) { needs.contents.insert(put.hash); },
      [&](const AppendBatch& append) {
        needs.experiences.insert(append.batch.experience);
        needs.batches.insert({append.batch.experience, append.batch.sequence});
        for (const Place& place : append.batch.places) needs.contents.insert(place.content.hash);
      },
      [&](const PutLabel& put) { needs.experiences.insert(put.place.experience); },
      [&](const SealExperience& seal) { needs.experiences.insert(seal.experience); },
      [](const auto&) {},
  };
  for (const auto& change : transaction.changes) std::visit(collect, change);
  return needs;
}

Result<Plan> make_plan(const Transaction& transaction, const Facts& facts) {
  Planner planner(transaction, facts);
  std::vector<bool> fresh;
  for (const auto& change : transaction.changes) {
    const Result<bool> is_fresh = std::visit(planner, change);
    if (!is_fresh) return fail(is_fresh.error());
    fresh.push_back(*is_fresh);
  }
  return planner.take(std::move(fresh));
}

}  // namespace weft::storage
