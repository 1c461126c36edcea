#pragma once
#include <variant>

#include "agents/methods/method.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Returns the view's image. Refusals: not_an_image, wrong_size (its width against the camera's).
inline OrRefusal<const Image*> image_of(const View& view, const CameraModel& camera) {
  const auto* const image = std::get_if<Image>(&view.data);
  if (image == nullptr) return tl::unexpected<Refusal>(Refusal{"not_an_image", 0.0, 1.0});
  if (!is_whole(*image) || image->width != camera.width || image->height != camera.height)
    return tl::unexpected<Refusal>(
        Refusal{"wrong_size", static_cast<double>(image->width), static_cast<double>(camera.width)});
  return image;
}

}  // namespace weft::agents
