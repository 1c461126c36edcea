#include "clients/evaluate/registration/cloud_file.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "clients/evaluate/files.hpp"
#include "storage/formats/cloud.hpp"

namespace weft::evaluate::registration {
namespace {

constexpr double kRotationWithin = 1e-3;

/// Returns the numbers of a text up to the first thing that is none.
std::vector<double> numbers_in(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace

Result<std::vector<Eigen::Vector3f>> read_points(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file, "cloud");
  if (!text) return fail(text.error());
  const ByteView bytes(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
  const bool is_ply = file.extension() == ".ply";
  if (!is_ply && file.extension() != ".pcd") {
    return fail(ErrorCode::invalid, file.string() + ": clouds end in .pcd or .ply");
  }
  auto read = is_ply ? formats::read_ply(bytes, file.string()) : formats::read_pcd(bytes, file.string());
  if (!read) return fail(read.error());
  std::erase_if(read->value.points, [](const Eigen::Vector3f& point) { return !point.allFinite(); });
  return std::move(read->value.points);
}

Result<Pose3> parse_matrix(std::string_view text, std::string_view what) {
  const std::vector<double> numbers = numbers_in(text);
  if (numbers.size() < 12) {
    return fail(ErrorCode::invalid, std::string(what) + ": " + std::to_string(numbers.size()) +
                                        " numbers, a pose has at least 12: three rows of a 4 x 4 matrix");
  }
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> rows(numbers.data());
  const Eigen::Matrix3d rotation = rows.leftCols<3>();
  if ((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() > kRotationWithin ||
      rotation.determinant() < 0.0) {
    return fail(ErrorCode::invalid, std::string(what) + ": its first three columns are no rotation");
  }
  return Pose3{Eigen::Quaterniond(rotation).normalized(), rows.col(3)};
}

Result<Pose3> parse_guess(std::string_view text) {
  std::string blanks(text);
  for (char& letter : blanks) letter = letter == ',' ? ' ' : letter;
  const std::vector<double> numbers = numbers_in(blanks);
  if (numbers.size() != 4) {
    return fail(ErrorCode::invalid,
                "guess is '" + std::string(text) + "', must be X,Y,Z,HEADING in metres and radians");
  }
  Pose3 guess = lift({numbers[0], numbers[1], numbers[3]});
  guess.translation.z() = numbers[2];
  return guess;
}

}  // namespace weft::evaluate::registration
