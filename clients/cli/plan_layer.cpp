#include "clients/cli/plan_layer.hpp"

#include <filesystem>

#include "clients/cli/files.hpp"
#include "core/network/codec.hpp"

namespace weft::cli {
namespace {

template <class T>
void say(const formats::Read<T>& read, const std::string& file, std::ostream& err) {
  for (const formats::NotUnderstood& part : read.not_understood) {
    err << "weft: not understood: " << formats::to_string(part, file) << '\n';
  }
}

/// Returns the name of the image that a map_server file names, from where the program runs. invalid: it is of another
/// kind than can be read.
Result<std::string> image_file_of(const formats::MapServerFile& described, const std::string& file) {
  std::string image_file = (std::filesystem::path(file).parent_path() / described.image).lexically_normal().string();
  if (const std::string ending = ending_of(image_file); ending != ".pgm" && ending != ".png") {
    return fail(ErrorCode::invalid, file + ": its image " + image_file + " is neither PGM nor PNG; convert it first");
  }
  return image_file;
}

}  // namespace

Result<formats::FloorPlan> read_floor_plan(const std::string& file, std::ostream& err) {
  const Result<std::string> text = read_text(file);
  if (!text) return fail(text.error());
  const auto described = formats::read_map_server(*text, file);
  if (!described) return fail(described.error());
  say(*described, file, err);
  const Result<std::string> image_file = image_file_of(described->value, file);
  if (!image_file) return fail(image_file.error());
  const Result<Bytes> bytes = read_file(*image_file);
  if (!bytes) return fail(bytes.error());
  const auto image = formats::read_grey_image(*bytes, *image_file);
  if (!image) return fail(image.error());
  say(*image, *image_file, err);
  return formats::floor_plan_from(described->value, image->value);
}

Result<ContentHash> plan_hash(const std::string& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return fail(text.error());
  const auto described = formats::read_map_server(*text, file);
  if (!described) return fail(described.error());
  const Result<std::string> image_file = image_file_of(described->value, file);
  if (!image_file) return fail(image_file.error());
  const Result<Bytes> image = read_file(*image_file);
  if (!image) return fail(image.error());
  Bytes both(text->begin(), text->end());
  both.insert(both.end(), image->begin(), image->end());
  return hash_bytes(both);
}

std::array<Pose2, 4> corners_of(const formats::FloorPlan& plan) {
  const double wide = plan.width * plan.cell_m;
  const double tall = plan.height * plan.cell_m;
  return {plan.plan_from_grid, plan.plan_from_grid * Pose2{wide, 0.0, 0.0},
          plan.plan_from_grid * Pose2{0.0, tall, 0.0}, plan.plan_from_grid * Pose2{wide, tall, 0.0}};
}

}  // namespace weft::cli
