#include "agents/bodies/replay/text_file.hpp"

#include <fstream>
#include <sstream>

namespace weft::agents::replay {

Result<std::string> read_text(const std::filesystem::path& path) {
  const std::ifstream file(path, std::ios::binary);
  if (!file) {
    return fail(ErrorCode::not_found,
                path.string() +
                    ": missing; a recording has mav0/CAMERA/data.csv, sensor.yaml and data/, or "
                    "calib.txt, image_l/ and image_r/");
  }
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace weft::agents::replay
