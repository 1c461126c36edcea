#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "agents/bodies/sim/bent_rays.hpp"
#include "agents/bodies/sim/floor/floor_window.hpp"
#include "agents/bodies/sim/light.hpp"
#include "agents/bodies/sim/pixel_rays.hpp"
#include "agents/bodies/sim/scene.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"

namespace weft::agents::sim {

// Subsamples in time order, at -3/8 ... 3/8 of the exposure. Their places within the pixel are orthogonal to time
// and to each other (the cubic and the quadratic contrast), so that filtering does not depend on the motion.
inline constexpr std::array<double, kSubsamples> kSubsampleTime = {-0.375, -0.125, 0.125, 0.375};
inline constexpr std::array<double, kSubsamples> kSubsampleDown = {-0.125, 0.375, -0.375, 0.125};
inline constexpr std::array<double, kSubsamples> kSubsampleRight = {0.25, -0.25, -0.25, 0.25};

/// Describes the circumstances in which one image is taken.
struct FloorShot {
  std::array<Pose3, kSubsamples> site_from_camera;  ///< in the middle of each quarter of the exposure
  Pose3 site_from_camera_mid;
  ShadowBody body;
  double gain = 1.0;
  std::uint64_t noise_seed = 0;
  double time_s = 0.0;  ///< of the body
  /// Says where the camera is while one row of the image is taken.
  struct Row {
    std::array<Pose3, kSubsamples> site_from_camera;
    Pose3 site_from_camera_mid;
  };
  std::vector<Row> rows;  ///< of a rolling shutter; empty: all rows are taken at once, as said above

  const std::array<Pose3, kSubsamples>& poses_of_row(int v) const {
    return rows.empty() ? site_from_camera : rows[static_cast<std::size_t>(v)].site_from_camera;
  }
  const Pose3& mid_of_row(int v) const {
    return rows.empty() ? site_from_camera_mid : rows[static_cast<std::size_t>(v)].site_from_camera_mid;
  }
};

struct CameraOptions {
  double vignetting = 0.0;  ///< loss in the corners
  double noise_grey = 0.0;
  double shadow = 0.0;
  int lens_spots = 0;  ///< blurred specks on the lens
  double lens_depth = 0.0;
  std::uint64_t lens_seed = 0;
  std::size_t cache_bytes = 160'000'000;
  std::optional<Relief> relief = {};  ///< of the floor; none: it is a plane
};

/// Renders what a camera sees of the site's floor and boxes. Not for several threads.
class Camera {
 public:
  /// Takes the true camera; its width and height are multiples of 8.
  Camera(const CameraModel& camera, const CameraOptions& options, std::shared_ptr<const FloorSource> floor,
         std::shared_ptr<const Scene> scene, const Light& light);
  void set_light(const Light& light) { light_ = light; }

  /// Returns the image, 8-bit grey, row-major.
  Bytes render(const FloorShot& shot);

  const FloorWindow& floor() const { return floor_; }

 private:
  /// Holds the floor points of the light grid, site frame.
  struct Nodes {
    std::vector<float> x, y;
  };
  using RowLevels = std::array<std::uint8_t, kSubsamples>;
  using FloorFromSubsamples = std::array<FloorFromRay, kSubsamples>;
  /// Holds where one pose of the camera looks from, and how it turns directions into the site frame.
  struct Viewpoint {
    Eigen::Vector3d at;
    Eigen::Matrix3f site_from_camera;
    explicit Viewpoint(const Pose3& site_from_camera_pose = {})
        : at(site_from_camera_pose.translation),
          site_from_camera(site_from_camera_pose.rotation.toRotationMatrix().cast<float>()) {}
  };
  /// Describes the surface where a ray hits: its albedo, and where that is (site frame).
  struct Surface {
    float albedo = 0.0F;
    Eigen::Vector3f at = Eigen::Vector3f::Zero();
  };
  /// Holds the light at a pixel: developed grey = floor albedo * gain + add; of anything else, grey * camera_gain.
  struct PixelLight {
    float gain, add, camera_gain;
  };
  /// Holds the same for one row of a cell's pixels, from its first on.
  struct CellLight {
    std::array<float, kShadeCell> gain, add, camera_gain;
  };
  std::vector<RowLevels> levels_of_rows() const;
  std::array<double, kLevels> reach_m() const;
  FloorFromRay floor_from_ray(const Pose3& site_from_camera, double origin_x, double origin_y, double right_px,
                              double down_px) const;
  void look_at_grid(const FloorShot& shot);
  void fetch_floor();
  std::vector<FloorFromSubsamples> floor_from_rows(const FloorShot& shot, TileKey origin) const;
  void sample_floor(const FloorShot& shot);
  void sample_row(RowJob& job, int begin, int end, int v);
  /// Returns the image row of a row of the light grid.
  int row_of_node(int j) const { return std::min(j * kShadeCell, camera_.height - 1); }
  std::size_t pixel(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(u);
  }

  // camera_boxes.cpp
  /// Classes cells of the light grid by what they show of boxes in the middle of the exposure.
  enum class Shows : std::uint8_t {
    floor,   ///< no box
    mixed,   ///< perhaps a box
    face,    ///< one face of one box
    inside,  ///< one face, as the cells around it: no floor and no edge
  };
  /// Holds points on faces and how bright the lamps make them.
  struct WallPoints {
    std::vector<float> x, y, z, gain;
    void clear() {
      x.clear();
      y.clear();
      z.clear();
    }
    void add(const Eigen::Vector3f& p) {
      x.push_back(p.x());
      y.push_back(p.y());
      z.push_back(p.z());
    }
    void look(const Light& light) {
      gain.resize(x.size());
      light.on_wall(x, y, z, gain);
    }
  };
  /// Holds the places to paint, as a FaceJob wants them.
  struct PaintPlaces {
    std::array<double, kShadeCell> along_m{}, up_m{}, pixel_m{};
    void set(std::size_t i, const Eigen::Vector2d& in_face, double pixel_size_m) {
      along_m[i] = in_face.x();
      up_m[i] = in_face.y();
      pixel_m[i] = pixel_size_m;
    }
  };
  struct Pixel {
    int u, v;
  };
  void find_boxes(const FloorShot& shot);
  void forget_boxes();
  void mark_cells(const FloorShot& shot);
  void cast_nodes(const FloorShot& shot);
  void cast_cells(const FloorShot& shot);
  Shows& shows(int u, int v) {
    return shows_[static_cast<std::size_t>((v / kShadeCell) * (columns_ - 1) + u / kShadeCell)];
  }
  /// Returns what the cell's upper left corner shows.
  const BoxHit& corner_hit(int u, int v) const {
    return node_hits_[static_cast<std::size_t>((v / kShadeCell) * columns_ + u / kShadeCell)];
  }
  Eigen::Vector3f direction_of(const Viewpoint& viewpoint, std::size_t at) const {
    return viewpoint.site_from_camera * Eigen::Vector3f(rays_.x[at], rays_.y[at], 1.0F);
  }

  // camera_faces.cpp
  void draw_boxes(const FloorShot& shot);
  void draw_insides(const Viewpoint& viewpoint, double exposure_gain, int v);
  void draw_lone(const FloorShot& shot);
  void draw_edges(const FloorShot& shot);
  /// Writes the grey levels of places on a face, without the lamps, to `out`.
  void paint(const BoxHit& face, const PaintPlaces& places, int count, float* out);
  Surface surface_at(const BoxHit& hit, const Viewpoint& viewpoint, const Eigen::Vector3f& direction);
  bool at_edge(int u, int v);

  // camera_light.cpp
  void make_noise();
  void soil_lens();
  void light_grid(const FloorShot& shot);
  CellLight light_in_cell(int u, int v, double exposure_gain) const;
  PixelLight light_at(int u, int v, double exposure_gain) const;
  Bytes develop(const FloorShot& shot) const;

  CameraModel camera_;
  CameraOptions options_;
  int columns_ = 0, rows_ = 0;  ///< of the light grid
  PixelRays rays_;
  std::vector<RowLevels> levels_;  ///< of each image row
  std::vector<float> vignette_;    ///< of each grid node
  std::vector<float> noise_;
  FloorWindow floor_;
  std::shared_ptr<const Scene> scene_;
  Light light_;

  // Of the image being made.
  Nodes nodes_;
  BentRays bent_;  ///< where the floor is no plane
  std::vector<float> albedo_, gain_, add_;
  std::vector<Shows> shows_;  ///< of each cell; empty: no box is near
  FaceMemo face_memo_;
  WallPoints ends_;                ///< of the pixels being drawn
  std::vector<Pixel> inside_;      ///< first pixels of the cells within faces, of the row being drawn
  std::vector<Pixel> lone_;        ///< other pixels that show one face
  std::vector<Pixel> edges_;       ///< pixels that an edge of a box runs through
  std::vector<BoxHit> node_hits_;  ///< of each grid node that a cell with a box has
  std::vector<BoxHit> hits_;       ///< of each pixel of cells that are not inside; none between images
};

}  // namespace weft::agents::sim
