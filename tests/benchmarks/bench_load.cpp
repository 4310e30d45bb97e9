// The load detector, and its cylinder against pcl::SACSegmentation's on the same points.
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <numbers>

#include "benchmark.h"
#include "load/load_detector.h"
#include "support/load_scene.h"

using namespace boomwatch;
namespace bench = boomwatch::bench;

namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

/// What the peer is given: the points of the log alone, which the detector has to find by itself.
PclCloud::Ptr pointsOfLog(const load_scene::LoadScene& scene, const Cloud& cloud) {
  PclCloud::Ptr points(new PclCloud);
  const double z2 = scene.log->centre.z() * scene.log->centre.z();
  const double within = 0.02 + 3.0 * scene.depthNoise() * z2;
  for (std::size_t i = 0; i < cloud.size(); i += 4) {
    const Eigen::Vector3f& p = cloud.points[i];
    if (isMeasured(p) && scene.log->distanceTo(p.cast<double>()) < within) {
      points->push_back({p.x(), p.y(), p.z()});
    }
  }
  return points;
}

/// The axis by PCL: normals of the 30 nearest, then RANSAC.
Eigen::Vector3d axisByPcl(const PclCloud::Ptr& points, double threshold) {
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setSearchMethod(
      pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>(false)));
  estimation.setInputCloud(points);
  estimation.setKSearch(30);
  estimation.compute(*normals);
  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setModelType(pcl::SACMODEL_CYLINDER);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setOptimizeCoefficients(true);
  segmentation.setNormalDistanceWeight(0.1);
  segmentation.setMaxIterations(500);
  segmentation.setDistanceThreshold(threshold);
  segmentation.setRadiusLimits(0.05, 0.4);
  segmentation.setInputCloud(points);
  segmentation.setInputNormals(normals);
  pcl::ModelCoefficients found;
  pcl::PointIndices inliers;
  segmentation.segment(inliers, found);
  if (found.values.size() < 7) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(found.values[3], found.values[4], found.values[5]).normalized();
}

double degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::min(1.0, std::abs(a.dot(b)))) * 180.0 / std::numbers::pi;
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace

int main() {
  constexpr int poses = 20;
  const Bounds bounds{-10, 10, -10, 10, 0, 15};
  std::vector<double> own, peer, ownError, peerError;
  for (unsigned seed = 0; own.size() < poses; ++seed) {
    const auto scene = load_scene::logInGrapple(seed);
    const Cloud cloud = load_scene::cloudOf(scene, seed);
    const auto tool = load_scene::toolPointOf(scene, cloud, seed);
    if (!tool) continue;
    LoadDetection found;
    const double milliseconds = bench::medianMilliseconds(
        5, [&] { found = detectLoad(cloud, *tool, scene.depthNoise(), bounds, {}); });
    if (!found.box) continue;
    const auto points = pointsOfLog(scene, cloud);
    const double threshold =
        0.02 + 2.0 * scene.depthNoise() * scene.log->centre.z() * scene.log->centre.z();
    Eigen::Vector3d axis;
    peer.push_back(bench::medianMilliseconds(1, [&] { axis = axisByPcl(points, threshold); }));
    own.push_back(milliseconds);
    ownError.push_back(degreesBetween(found.box->rotation.col(0), scene.log->axis));
    peerError.push_back(degreesBetween(axis, scene.log->axis));
  }
  bench::print("load_time", medianOf(own), "ms", "<=8");
  bench::print("load_pcl_cylinder_over_ours", medianOf(peer) / medianOf(own), "x", ">=1");
  bench::print("load_axis_error", medianOf(ownError), "deg", "<=3");
  bench::print("load_axis_error_pcl_over_ours", medianOf(peerError) / medianOf(ownError), "x",
               ">=1");
  return 0;
}
