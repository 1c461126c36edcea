#include "agents/adjustment/window.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <map>
#include <memory>

#include "agents/adjustment/costs.hpp"
#include "agents/adjustment/solver_options.hpp"

namespace weft::agents {
namespace {

using Parameters = std::array<double, 3>;
constexpr int kIterations = 6;

Parameters parameters_of(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// Holds what is not known of a place. Ceres eliminates blocks of a group in the order of their addresses: all of
/// them lie in one array, so that the same window gives the same bits.
struct PlaceUnknowns {
  Parameters pose;
  Parameters attitude;
};

/// Holds the unknowns of a window, in one place each.
class Unknowns {
 public:
  Unknowns(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t first, std::uint32_t count)
      : mosaic_(mosaic), first_(first) {
    for (std::uint32_t place = first; place < first + count; ++place) {
      const MosaicPlace& known = mosaic.places[place];
      places.push_back({{known.map_from_place.x, known.map_from_place.y, known.map_from_place.heading},
                        parameters_of(known.attitude.vector())});
      for (const std::uint32_t sighting : index.sightings_from(place))
        by_point_[mosaic.sightings[sighting].point].push_back(sighting);
    }
    std::erase_if(by_point_, [](const auto& entry) { return entry.second.size() < 2; });
    for (const auto& [point, sightings] : by_point_) {
      points.push_back(parameters_of(mosaic.points[point].in_map));
      told.push_back(&mosaic.points[point]);
      seen.push_back(&sightings);
    }
  }
  std::size_t place(const MosaicSighting& sighting) const { return sighting.place - first_; }

  std::vector<PlaceUnknowns> places;
  std::vector<Parameters> points;
  std::vector<const MosaicPoint*> told;                 ///< each of `points` as the mosaic has it
  std::vector<const std::vector<std::uint32_t>*> seen;  ///< the sightings of each of `points`

 private:
  const Mosaic& mosaic_;
  std::uint32_t first_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_point_;
};

/// Returns the links that begin and end within the window.
std::vector<MosaicLink> links_within(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t first,
                                     std::size_t count) {
  std::vector<MosaicLink> within;
  for (std::uint32_t place = first; place < first + count; ++place) {
    for (const std::uint32_t number : index.links_from(place)) {
      const MosaicLink& link = mosaic.links[number];
      if (link.to >= first && link.to < first + count) within.push_back(link);
    }
  }
  return within;
}

void solve(const Mosaic& mosaic, const std::vector<MosaicLink>& links, std::uint32_t first, Unknowns& unknowns) {
  ceres::Problem problem;
  ceres::Solver::Options options = repeatable_options(ceres::DENSE_SCHUR, kIterations);
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (std::size_t i = 0; i < unknowns.points.size(); ++i) {
    double* const point = unknowns.points[i].data();
    problem.AddResidualBlock(HeightCost::make(*unknowns.told[i]), new ceres::HuberLoss(kHuberSigmas), point);
    options.linear_solver_ordering->AddElementToGroup(point, 0);
    for (const std::uint32_t number : *unknowns.seen[i]) {
      const MosaicSighting& sighting = mosaic.sightings[number];
      const std::size_t place = unknowns.place(sighting);
      problem.AddResidualBlock(SightingCost::make(mosaic.robot_from_camera, sighting),
                               new ceres::HuberLoss(kHuberSigmas), unknowns.places[place].pose.data(),
                               unknowns.places[place].attitude.data(), point);
    }
  }
  for (const MosaicLink& link : links)
    problem.AddResidualBlock(LinkCost::make(link), nullptr, unknowns.places[link.from - first].pose.data(),
                             unknowns.places[link.to - first].pose.data());
  for (std::size_t i = 0; i < unknowns.places.size(); ++i) {
    problem.AddResidualBlock(AttitudeCost::make(mosaic.places[first + i]), nullptr,
                             unknowns.places[i].attitude.data());
    problem.AddParameterBlock(unknowns.places[i].pose.data(), 3);
    options.linear_solver_ordering->AddElementToGroup(unknowns.places[i].pose.data(), 1);
    options.linear_solver_ordering->AddElementToGroup(unknowns.places[i].attitude.data(), 1);
  }
  problem.SetParameterBlockConstant(unknowns.places.front().pose.data());
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

/// Adds up the normal equations' matrix of places and attitudes, six rows each (pose, attitude), points eliminated.
class Reduced {
 public:
  explicit Reduced(std::size_t places)
      : matrix_(Eigen::MatrixXd::Zero(6 * static_cast<Eigen::Index>(places), 6 * static_cast<Eigen::Index>(places))) {
  }

  void add_point(const Mosaic& mosaic, const Unknowns& unknowns, std::size_t point) {
    const std::vector<std::uint32_t>& seen = *unknowns.seen[point];
    Eigen::Matrix3d of_point = of_height(*unknowns.told[point], unknowns.points[point]);
    std::vector<std::pair<Eigen::Index, Eigen::Matrix<double, 6, 3>>> mixed;
    for (const std::uint32_t number : seen) {
      const MosaicSighting& sighting = mosaic.sightings[number];
      const std::size_t place = unknowns.place(sighting);
      Rows<6> by_place;
      Rows<3> by_point;
      differentiate(mosaic, sighting, unknowns, place, point, by_place, by_point);
      const Eigen::Index row = 6 * static_cast<Eigen::Index>(place);
      matrix_.block<6, 6>(row, row) += by_place.transpose() * by_place;
      of_point += by_point.transpose() * by_point;
      mixed.emplace_back(row, by_place.transpose() * by_point);
    }
    const Eigen::Matrix3d inverse = of_point.inverse();
    for (const auto& [row, of_row] : mixed)
      for (const auto& [column, of_column] : mixed)
        matrix_.block<6, 6>(row, column) -= of_row * inverse * of_column.transpose();
  }

  void add_attitude(std::size_t place, const Eigen::Vector3d& sigma) {
    const Eigen::Index row = 6 * static_cast<Eigen::Index>(place) + 3;
    matrix_.block<3, 3>(row, row) += sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  }

  void add_link(const MosaicLink& link, const Unknowns& unknowns, std::uint32_t first) {
    const std::unique_ptr<ceres::CostFunction> cost(LinkCost::make(link));
    const std::size_t from = link.from - first;
    const std::size_t to = link.to - first;
    const double* const parameters[] = {unknowns.places[from].pose.data(), unknowns.places[to].pose.data()};
    Eigen::Vector3d residual;
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_from, by_to;
    double* jacobians[] = {by_from.data(), by_to.data()};
    cost->Evaluate(parameters, residual.data(), jacobians);
    const Eigen::Index a = 6 * static_cast<Eigen::Index>(from);
    const Eigen::Index b = 6 * static_cast<Eigen::Index>(to);
    matrix_.block<3, 3>(a, a) += by_from.transpose() * by_from;
    matrix_.block<3, 3>(b, b) += by_to.transpose() * by_to;
    matrix_.block<3, 3>(a, b) += by_from.transpose() * by_to;
    matrix_.block<3, 3>(b, a) += by_to.transpose() * by_from;
  }

  /// Returns the information on the poses but the first one's, attitudes eliminated, by xi.
  Eigen::MatrixXd of_poses(const std::vector<PlaceUnknowns>& unknowns) const {
    const auto places = static_cast<Eigen::Index>(unknowns.size());
    std::vector<Eigen::Index> pose_rows, attitude_rows;
    for (Eigen::Index place = 0; place < places; ++place) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        if (place > 0) pose_rows.push_back(6 * place + i);
        attitude_rows.push_back(6 * place + 3 + i);
      }
    }
    const Eigen::MatrixXd mixed = matrix_(pose_rows, attitude_rows);
    Eigen::MatrixXd left = matrix_(pose_rows, pose_rows);
    left -= mixed * matrix_(attitude_rows, attitude_rows).llt().solve(mixed.transpose());
    Eigen::MatrixXd map_from_xi = Eigen::MatrixXd::Identity(left.rows(), left.cols());
    for (Eigen::Index place = 1; place < places; ++place)
      map_from_xi.block<2, 2>(3 * (place - 1), 3 * (place - 1)) =
          Eigen::Rotation2Dd(unknowns[static_cast<std::size_t>(place)].pose[2]).toRotationMatrix();
    const Eigen::MatrixXd by_xi = map_from_xi.transpose() * left * map_from_xi;
    return 0.5 * (by_xi + by_xi.transpose());
  }

 private:
  template <int Columns>
  using Rows = Eigen::Matrix<double, 2, Columns>;

  /// Returns the information on a point by its told height, as Huber's loss weights it.
  static Eigen::Matrix3d of_height(const MosaicPoint& told, const Parameters& point) {
    const double sigmas = std::abs(point[2] - told.told_m) / told.told_sigma_m;
    const double weight = std::min(1.0, kHuberSigmas / std::max(sigmas, 1e-12));
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    information(2, 2) = weight / (told.told_sigma_m * told.told_sigma_m);
    return information;
  }

  /// Differentiates a sighting by place and point, as Huber's loss weights it.
  static void differentiate(const Mosaic& mosaic, const MosaicSighting& sighting, const Unknowns& unknowns,
                            std::size_t place, std::size_t point, Rows<6>& by_place, Rows<3>& by_point) {
    const std::unique_ptr<ceres::CostFunction> cost(SightingCost::make(mosaic.robot_from_camera, sighting));
    const double* const parameters[] = {unknowns.places[place].pose.data(), unknowns.places[place].attitude.data(),
                                        unknowns.points[point].data()};
    Eigen::Vector2d residual;
    Eigen::Matrix<double, 2, 3, Eigen::RowMajor> by[3];
    double* jacobians[] = {by[0].data(), by[1].data(), by[2].data()};
    cost->Evaluate(parameters, residual.data(), jacobians);
    const double weight = std::sqrt(std::min(1.0, kHuberSigmas / std::max(residual.norm(), 1e-12)));
    by_place << weight * by[0], weight * by[1];
    by_point = weight * by[2];
  }

  Eigen::MatrixXd matrix_;
};

}  // namespace

MosaicIndex::MosaicIndex(const Mosaic& mosaic)
    : of_place_(mosaic.places.size()), of_point_(mosaic.points.size()), links_(mosaic.places.size()) {
  for (std::uint32_t i = 0; i < mosaic.sightings.size(); ++i) {
    of_place_[mosaic.sightings[i].place].push_back(i);
    of_point_[mosaic.sightings[i].point].push_back(i);
  }
  for (std::uint32_t i = 0; i < mosaic.links.size(); ++i)
    if (!mosaic.links[i].is_stitch) links_[mosaic.links[i].from].push_back(i);
}

WindowFit fit_window(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t first, std::uint32_t count) {
  Unknowns unknowns(mosaic, index, first, count);
  const std::vector<MosaicLink> links = links_within(mosaic, index, first, count);
  solve(mosaic, links, first, unknowns);
  Reduced reduced(count);
  for (std::size_t point = 0; point < unknowns.points.size(); ++point) reduced.add_point(mosaic, unknowns, point);
  for (const MosaicLink& link : links) reduced.add_link(link, unknowns, first);
  WindowFit fit;
  fit.first = first;
  const auto pose = [](const Parameters& p) { return Pose2{p[0], p[1], p[2]}; };
  const Pose2 first_from_map = pose(unknowns.places.front().pose).inverse();
  for (std::size_t i = 0; i < count; ++i) {
    reduced.add_attitude(i, mosaic.places[first + i].attitude_sigma);
    fit.first_from_place.push_back(first_from_map * pose(unknowns.places[i].pose));
    const Parameters& attitude = unknowns.places[i].attitude;
    fit.attitudes.push_back({attitude[0], attitude[1], attitude[2]});
  }
  fit.information = reduced.of_poses(unknowns.places);
  return fit;
}

}  // namespace weft::agents
