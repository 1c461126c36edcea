#include "agents/agent/process/read_camera_file.hpp"

#include <fstream>
#include <iterator>

namespace weft::agents {

Result<CameraFile> read_camera_file(const std::string& file, const std::string& camera) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail(ErrorCode::not_found, file + ": no such camera file; `weft calibrate camera` writes one");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse_camera_file(text, file, camera);
}

}  // namespace weft::agents
