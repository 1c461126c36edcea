#include "clients/cli/text_width.hpp"

#include <algorithm>
#include <memory>

#include "drawing/canvas.hpp"

namespace weft::cli {

WidthOf text_widths() {
  const std::shared_ptr<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1),
                                                 cairo_surface_destroy);
  const std::shared_ptr<cairo_t> pen(cairo_create(surface.get()), cairo_destroy);
  drawing::choose_letters(pen.get());
  return [surface, pen](const std::string& words, double size) {
    cairo_text_extents_t extents{};
    cairo_set_font_size(pen.get(), size);
    cairo_text_extents(pen.get(), words.c_str(), &extents);
    return std::max(extents.x_advance, extents.x_bearing + extents.width);
  };
}

}  // namespace weft::cli
