#include <algorithm>

#include "core/network/codec.hpp"
#include "storage/sqlite/check_parts.hpp"
#include "storage/sqlite/rows.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::uint64_t kBytesAStep = 1U << 20U;  // about two milliseconds
constexpr std::size_t kMostContentsAStep = 500;

/// Returns what is wrong with the row; empty: nothing.
std::string damage_of(ContentCoder& coder, const ContentHash& hash, const Query& row) {
  const ContentRow told{hash, row.number(3), row.number(2)};
  const Result<Bytes> bytes = expand_content(coder, told, row.blob(4));
  if (!bytes) return bytes.error().message;
  const bool has_sum = !row.is_null(6);
  return has_sum && row.number(6) != content_sum(told, row.blob(4)) ? "its sum differs" : "";
}

class ContentCheck final : public CheckPart {
 public:
  ContentCheck(Parts& parts, Scan scan, Statement find)
      : parts_(parts), scan_(std::move(scan)), find_(std::move(find)) {}

  Result<bool> step(Findings& findings) override {
    std::vector<ContentHash> damaged;
    const Result<bool> more = read(findings, damaged);
    for (const ContentHash& hash : damaged) quarantine(parts_, hash);
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Result<bool> read(Findings& findings, std::vector<ContentHash>& damaged) {
    const auto reading = ReadTransaction::begin(parts_.database);
    if (!reading) return fail(reading.error());
    std::vector<std::pair<std::uint64_t, ContentHash>> rows;
    std::uint64_t bytes = 0;
    const Result<bool> more = scan_.next(piece_, [&](const Query& row) {
      ++done_;
      bytes += std::min<std::uint64_t>(row.number(3), msg::kContentBytes);  // it may be damaged
      const auto hash = row.id<ContentHash>(1);
      rows.emplace_back(row.number(0), hash);
      const bool is_known = row.number(5) != 0 || parts_.quarantined.contains(hash);
      const std::string damage = is_known ? "it was found damaged before" : damage_of(*parts_.coder, hash, row);
      if (damage.empty()) return;
      findings.push_back("content " + to_string(hash) + ": " + damage + "; quarantined");
      if (!is_known) damaged.push_back(hash);
    });
    if (!more) return fail(more.error());
    // As many as would have been enough this time.
    if (!rows.empty())
      piece_ = std::clamp<std::size_t>(kBytesAStep * rows.size() / (bytes + 1), 1, kMostContentsAStep);
    for (const auto& [id, hash] : rows) {
      Query query(find_);
      query << hash;
      const Result<bool> found = query.step();
      if (!found) return fail(found.error());
      if (!*found || query.number(0) != id) {
        findings.push_back("content " + to_string(hash) + ": it is missing in the table's index");
      }
    }
    return more;
  }

  Parts& parts_;
  Scan scan_;
  Statement find_;
  std::size_t piece_ = 16;
  std::uint64_t done_ = 0;
};

class PreparationCheck final : public CheckPart {
 public:
  explicit PreparationCheck(Scan scan) : scan_(std::move(scan)) {}
  Result<bool> step(Findings& findings) override {
    return scan_.next(1, [&](const Query& row) {
      ++done_;
      if (hash_bytes(row.blob(2)) == row.id<ContentHash>(1)) return;
      findings.push_back("preparation " + row.text(0) + ": its SHA-256 differs; it is made anew");
    });
  }
  std::uint64_t done() const override { return done_; }

 private:
  Scan scan_;
  std::uint64_t done_ = 0;
};

}  // namespace

Result<void> add_content_checks(Parts& parts, CheckParts& to) {
  auto scan = Scan::make(parts.database, "content", {"rowid"}, "hash, coding, size, bytes, quarantined, sum");
  if (!scan) return fail(scan.error());
  auto find = parts.database.prepare("SELECT rowid FROM content WHERE hash = ?");
  if (!find) return fail(find.error());
  to.push_back(std::make_unique<ContentCheck>(parts, std::move(*scan), std::move(*find)));
  auto preparations = Scan::make(parts.database, "preparation", {"methods"}, "hash, bytes");
  if (!preparations) return fail(preparations.error());
  to.push_back(std::make_unique<PreparationCheck>(std::move(*preparations)));
  return {};
}

}  // namespace weft::storage::sqlite
