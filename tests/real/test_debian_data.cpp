#include <QDirIterator>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <random>

#include "open_source.h"
#include "pipeline/pipeline.h"
#include "pipeline/scene_motion.h"
#include "sources/frame_source.h"
#include "stereo/calibration.h"
#include "stereo/stereo_stage.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

const QString openCvData = QStringLiteral("/usr/share/doc/opencv-doc/examples/data/");

/// A file below the examples of python3-pcl; empty where there is none.
QString pclExample(const QString& name) {
  QDirIterator files(QStringLiteral("/usr/share/doc/python3-pcl"), {name}, QDir::Files,
                     QDirIterator::Subdirectories);
  return files.hasNext() ? files.next() : QString();
}

float quantile(const Cloud& cloud, int axis, double share) {
  std::vector<float> values;
  for (const auto& p : cloud.points) {
    if (isMeasured(p)) values.push_back(p[axis]);
  }
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

/// All of the cloud but its stray hundredth, and room for a load before it.
Parameters parametersFor(const Cloud& cloud) {
  Parameters parameters;
  Bounds& b = parameters.bounds;
  b.xMin = quantile(cloud, 0, 0.01), b.xMax = quantile(cloud, 0, 0.99);
  b.yMin = quantile(cloud, 1, 0.01), b.yMax = quantile(cloud, 1, 0.99);
  b.zMin = quantile(cloud, 2, 0.01) - 0.6, b.zMax = quantile(cloud, 2, 0.99);
  parameters.model.resolution = 0.02;
  parameters.filter.clusterMinimum = 1;
  parameters.clearance.smallestThing = 0.0;    // as brute force, which knows no pieces
  parameters.validity.identicalFrames = 1000;  // one file stands for a still scene
  parameters.load.source = LoadSource::Manual;
  parameters.load.sizeX = 0.2, parameters.load.sizeY = parameters.load.sizeZ = 0.06;
  return parameters;
}

double bruteForce(const Cloud& cloud, const Bounds& bounds, const OrientedBox& box) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& point : cloud.points) {
    if (!isMeasured(point) || !bounds.contains(point)) continue;
    const Eigen::Vector3d p = point.cast<double>();
    nearest = std::min(nearest, (box.nearestTo(p) - p).norm());
  }
  return nearest;
}

/// A load somewhere before the cloud, turned at random.
void hangBefore(Parameters& parameters, std::mt19937& random) {
  std::uniform_real_distribution<double> along(0.2, 0.8), turn(-180.0, 180.0);
  const Bounds& b = parameters.bounds;
  parameters.load.x = b.xMin + along(random) * (b.xMax - b.xMin);
  parameters.load.y = b.yMin + along(random) * (b.yMax - b.yMin);
  parameters.load.z = b.zMin + 0.3;
  parameters.load.yaw = turn(random) / 12.0;
  parameters.load.roll = turn(random);
}

constexpr int squaresAcross = 9, squaresDown = 6;  // inner corners
constexpr double square = 0.025;                   // metres; only the scale depends on it

std::optional<std::vector<cv::Point2f>> findCorners(const cv::Mat& image) {
  std::vector<cv::Point2f> corners;
  const cv::Size board(squaresAcross, squaresDown);
  if (!cv::findChessboardCorners(image, board, corners)) return std::nullopt;
  cv::cornerSubPix(image, corners, {5, 5}, {-1, -1},
                   {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 30, 0.01});
  return corners;
}

struct BoardPair {
  cv::Mat left, right;
  std::vector<cv::Point2f> leftCorners, rightCorners;
};

std::vector<BoardPair> readBoards() {
  std::vector<BoardPair> boards;
  for (int k = 1; k <= 14; ++k) {
    const QString number = QStringLiteral("%1.jpg").arg(k, 2, 10, QLatin1Char('0'));
    if (!QFileInfo::exists(openCvData + "left" + number)) continue;
    const auto read = [&](const QString& side) {
      return cv::imread((openCvData + side + number).toStdString(), cv::IMREAD_GRAYSCALE);
    };
    BoardPair pair{read(QStringLiteral("left")), read(QStringLiteral("right")), {}, {}};
    if (pair.left.empty() || pair.right.empty()) continue;
    const auto left = findCorners(pair.left), right = findCorners(pair.right);
    if (!left || !right) continue;
    pair.leftCorners = *left;
    pair.rightCorners = *right;
    boards.push_back(std::move(pair));
  }
  return boards;
}

/// Calibrates with OpenCV and writes the file that its sample writes.
void calibrate(const std::vector<BoardPair>& boards, const std::string& file) {
  std::vector<cv::Point3f> board;
  for (int row = 0; row < squaresDown; ++row) {
    for (int column = 0; column < squaresAcross; ++column) {
      board.emplace_back(static_cast<float>(column * square), static_cast<float>(row * square), 0);
    }
  }
  std::vector<std::vector<cv::Point2f>> left, right;
  for (const BoardPair& pair : boards) {
    left.push_back(pair.leftCorners);
    right.push_back(pair.rightCorners);
  }
  const std::vector<std::vector<cv::Point3f>> objects(boards.size(), board);
  const cv::Size size = boards.front().left.size();
  cv::Mat m1 = cv::initCameraMatrix2D(objects, left, size, 0);
  cv::Mat m2 = cv::initCameraMatrix2D(objects, right, size, 0);
  cv::Mat d1, d2, r, t, e, f;
  cv::stereoCalibrate(objects, left, right, m1, d1, m2, d2, size, r, t, e, f,
                      cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_ASPECT_RATIO |
                          cv::CALIB_ZERO_TANGENT_DIST | cv::CALIB_SAME_FOCAL_LENGTH |
                          cv::CALIB_RATIONAL_MODEL | cv::CALIB_FIX_K3 | cv::CALIB_FIX_K4 |
                          cv::CALIB_FIX_K5);
  cv::FileStorage storage(file, cv::FileStorage::WRITE);
  storage << "M1" << m1 << "D1" << d1 << "M2" << m2 << "D2" << d2 << "R" << r << "T" << t
          << "image_width" << size.width << "image_height" << size.height;
}

/// Where OpenCV puts the corners of the right picture when it rectifies them by themselves.
std::vector<cv::Point2f> rectifiedRight(const StereoRig& rig, const BoardPair& pair) {
  cv::Mat r1, r2, p1, p2, q;
  cv::stereoRectify(rig.leftMatrix, rig.leftDistortion, rig.rightMatrix, rig.rightDistortion,
                    pair.left.size(), rig.rotation, rig.translation, r1, r2, p1, p2, q,
                    cv::CALIB_ZERO_DISPARITY, 0);
  std::vector<cv::Point2f> corners;
  cv::undistortPoints(pair.rightCorners, corners, rig.rightMatrix, rig.rightDistortion, r2, p2);
  return corners;
}

}  // namespace

/// Real input that any Debian has: opencv-doc and python3-pcl.
class TestDebianData : public QObject {
  Q_OBJECT
 private slots:
  void clearanceBeforeARealCloudIsThatOfItsPoints_data();
  void clearanceBeforeARealCloudIsThatOfItsPoints();
  void chessboardsLieOnEqualRowsAfterRectification();
  void streetSeenByAStillCameraDoesNotMoveAsAWhole();
};

void TestDebianData::clearanceBeforeARealCloudIsThatOfItsPoints_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"milk_cartoon_all_small_clorox.pcd", "table_scene_lms400.pcd",
                           "table_scene_mug_stereo_textured.pcd"}) {
    QTest::newRow(name) << QString(name);
  }
}

void TestDebianData::clearanceBeforeARealCloudIsThatOfItsPoints() {
  QFETCH(QString, name);
  const QString file = pclExample(name);
  if (file.isEmpty()) QSKIP(qPrintable("python3-pcl does not bring " + name));
  const auto source = openSource("cloud:" + file.toStdString());
  FramePtr frame = source->next(std::chrono::seconds(1)).frame;
  QVERIFY(frame);
  Parameters parameters = parametersFor(*frame->cloud);
  Pipeline pipeline;
  for (int k = 0; k < 6; ++k) pipeline.process(frame, parameters);
  std::mt19937 random(11);
  double worst = 0.0;
  for (int k = 0; k < 10; ++k) {
    hangBefore(parameters, random);
    const Result result = pipeline.process(frame, parameters);
    QVERIFY(result.clearance.nearest);
    const Nearest& nearest = *result.clearance.nearest;
    const double truth = bruteForce(*frame->cloud, parameters.bounds, *result.load);
    const double error = std::abs(nearest.distance - truth);
    worst = std::max(worst, error);
    // Downsampling replaces the points of a cube of side R by their mean, before the cell does.
    QVERIFY2(error <= nearest.quantisation + parameters.model.resolution,
             qPrintable(QStringLiteral("%1 instead of %2").arg(nearest.distance).arg(truth)));
  }
  qInfo("worst error %.4f m at R %.2f m", worst, parameters.model.resolution);
}

void TestDebianData::chessboardsLieOnEqualRowsAfterRectification() {
  if (!QFileInfo::exists(openCvData + "left01.jpg")) QSKIP("opencv-doc is not installed");
  const std::vector<BoardPair> boards = readBoards();
  QVERIFY(boards.size() >= 10);
  const QTemporaryDir folder;
  const std::string file = folder.filePath("calibration.yaml").toStdString();
  calibrate(boards, file);
  const StereoRig rig = readCalibration(file);
  StereoParameters parameters;
  parameters.disparities = 160;
  StereoStage stage;
  std::vector<double> rows, disparities;
  for (const BoardPair& pair : boards) {
    const StereoResult result = stage.process(pair.left, pair.right, rig, parameters);
    const auto left = findCorners(result.left);
    if (!left) continue;
    const std::vector<cv::Point2f> right = rectifiedRight(rig, pair);
    for (std::size_t k = 0; k < right.size(); ++k) {
      rows.push_back(std::abs((*left)[k].y - right[k].y));
      const float found = result.disparity.at<float>(cv::Point((*left)[k]));
      if (std::isfinite(found)) {
        disparities.push_back(std::abs(found - ((*left)[k].x - right[k].x)));
      }
    }
  }
  QVERIFY(rows.size() >= 400 && disparities.size() >= 200);
  std::sort(rows.begin(), rows.end());
  std::sort(disparities.begin(), disparities.end());
  qInfo(
      "%zu corners: row error median %.2f px, 90 %% below %.2f px, worst %.2f px; disparity "
      "error median %.2f px",
      rows.size(), rows[rows.size() / 2], rows[rows.size() * 9 / 10], rows.back(),
      disparities[disparities.size() / 2]);
  QVERIFY(rows[rows.size() * 99 / 100] < 1.0);
  QVERIFY(disparities[disparities.size() / 2] < 1.0);
}

void TestDebianData::streetSeenByAStillCameraDoesNotMoveAsAWhole() {
  const QString file = openCvData + "vtest.avi";
  if (!QFileInfo::exists(file)) QSKIP("opencv-doc does not bring vtest.avi");
  cv::VideoCapture video(file.toStdString(), cv::CAP_FFMPEG);
  SceneMotion motion;
  const double limit = ValidityParameters().sceneMotion;
  double worst = 0.0;
  int compared = 0;
  cv::Mat image;
  for (int k = 0; k < 200 && video.read(image); ++k) {
    const auto share = motion.shareMoved(image);
    if (!share) continue;
    ++compared;
    worst = std::max(worst, *share);
  }
  qInfo("%d pairs of pictures; at most %.0f %% of the corners move", compared, 100 * worst);
  QVERIFY(compared >= 190);
  QVERIFY(worst < limit);
}

BOOMWATCH_TEST(TestDebianData)
#include "test_debian_data.moc"
