#include "storage/formats/tar.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

#include "core/text.hpp"

/// POSIX.1-1988, "ustar Interchange Format": records of 512 bytes, numbers in octal digits.
namespace weft::formats {
namespace {

constexpr std::size_t kRecord = 512;
constexpr std::size_t kLongestName = 100;
struct Field {
  std::size_t at;
  std::size_t size;
};
constexpr Field kName{0, 100}, kMode{100, 8}, kOwner{108, 8}, kGroup{116, 8}, kSize{124, 12}, kTime{136, 12},
    kChecksum{148, 8}, kType{156, 1}, kMagic{257, 8};

using Header = std::array<std::uint8_t, kRecord>;

void put(Header& header, Field field, std::string_view text) {
  std::ranges::copy(text.substr(0, field.size), header.begin() + static_cast<std::ptrdiff_t>(field.at));
}

/// Writes a number in octal digits that fill the field but for the zero byte behind them.
void put_number(Header& header, Field field, std::uint64_t number) {
  std::string digits(field.size - 1, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, number >>= 3U) {
    *digit = static_cast<char>('0' + (number & 7U));
  }
  put(header, field, digits);
}

Header header_of(const TarMember& member, std::uint64_t time_s) {
  Header header{};
  put(header, kName, member.name);
  put_number(header, kMode, 0644);
  put_number(header, kOwner, 0);
  put_number(header, kGroup, 0);
  put_number(header, kSize, member.text.size());
  put_number(header, kTime, time_s);
  put(header, kType, "0");
  put(header, kMagic, std::string_view("ustar\00000", 8));
  put(header, kChecksum, "        ");
  std::uint64_t sum = 0;
  for (const std::uint8_t byte : header) sum += byte;
  put_number(header, {kChecksum.at, 7}, sum);  // six digits, a zero byte, and the space that stands there
  header[kChecksum.at + 6] = 0;
  return header;
}

}  // namespace

Result<Bytes> tar_of(const std::vector<TarMember>& members, WallTime at) {
  const auto time_s = std::chrono::duration_cast<std::chrono::seconds>(at.time_since_epoch()).count();
  Bytes archive;
  for (const TarMember& member : members) {
    if (member.name.empty() || member.name.size() > kLongestName) {
      return fail(ErrorCode::invalid, "the name " + cited(member.name) + " of a file in an archive has " +
                                          std::to_string(member.name.size()) + " bytes; it must have 1 to 100");
    }
    const Header header = header_of(member, static_cast<std::uint64_t>(std::max<std::int64_t>(time_s, 0)));
    archive.insert(archive.end(), header.begin(), header.end());
    archive.insert(archive.end(), member.text.begin(), member.text.end());
    archive.resize((archive.size() + kRecord - 1) / kRecord * kRecord);
  }
  archive.resize(archive.size() + 2 * kRecord);  // two empty records end it
  return archive;
}

}  // namespace weft::formats
