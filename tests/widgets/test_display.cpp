#include <QtTest>
#include <cmath>
#include <limits>

#include "display.h"
#include "support/compare_near.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestDisplay : public QObject {
  Q_OBJECT

 private slots:
  void aDisplayOfNothingIsEmpty();
  void thePictureIsCopiedPixelByPixel();
  void aGreyPictureStaysGrey();
  void aPictureOfAnUnknownKindIsLeftOut();
  void theModelImageShowsEveryCell_data();
  void theModelImageShowsEveryCell();
  void theProbabilityImageGrowsBrighterWithProbability();
  void nearerIsBrighterAndEveryDepthIsBrighterThanFree();
  void theCloudHoldsTheMeasuredPointsInsideTheBounds();
  void theLayersOfTheCloudAreEvenSamples();
  void pointsTakenOutAsDynamicAreNotDrawnTwice();
  void pointsAreColouredByDepth();
  void pointsAreColouredByHeight();
  void pointsAreColouredAsInThePicture();
  void withoutAMatchingPictureColoursAreByDepth();
  void theProjectionIsTheCameraOfTheCloud();
  void aCloudOfNothingButNanIsHarmless();
};

namespace {

ResultPtr shared(const std::shared_ptr<Result>& result) { return result; }

int brightness(const DrawnCloud::Rgba& c) { return c[0] + c[1] + c[2]; }

}  // namespace

void TestDisplay::aDisplayOfNothingIsEmpty() {
  const auto display = makeDisplay(nullptr, {});
  QVERIFY(display);
  QVERIFY(display->camera.isNull() && display->model.isNull() && display->cloud.points.empty());
  const auto empty = makeDisplay(std::make_shared<Result>(), {});
  QVERIFY(empty->camera.isNull() && empty->probability.isNull() && !empty->projection);
}

void TestDisplay::thePictureIsCopiedPixelByPixel() {
  const auto result = testing::makeResult();
  const auto display = makeDisplay(shared(result), {});
  QCOMPARE(display->camera.size(), QSize(768, 576));
  for (const QPoint p : {QPoint(0, 0), QPoint(767, 575), QPoint(31, 402)}) {
    const auto bgr = result->image.at<cv::Vec3b>(p.y(), p.x());
    QCOMPARE(display->camera.pixel(p), qRgb(bgr[2], bgr[1], bgr[0]));
  }
  result->image.setTo(cv::Scalar::all(0));
  QCOMPARE(qRed(display->camera.pixel(0, 0)), 90);
}

void TestDisplay::aGreyPictureStaysGrey() {
  auto result = std::make_shared<Result>();
  result->image = cv::Mat(3, 5, CV_8UC1, cv::Scalar(77));
  QCOMPARE(makeDisplay(result, {})->camera.pixel(4, 2), qRgb(77, 77, 77));
}

void TestDisplay::aPictureOfAnUnknownKindIsLeftOut() {
  auto result = testing::makeResult();
  result->image = cv::Mat(576, 768, CV_16UC1, cv::Scalar(1000));
  DisplayOptions options;
  options.cloud = CloudColouring::Image;
  const auto display = makeDisplay(shared(result), options);
  QVERIFY(display->camera.isNull());
  QCOMPARE(display->cloudColouring, CloudColouring::Depth);
}

void TestDisplay::theModelImageShowsEveryCell_data() {
  QTest::addColumn<int>("colouring");
  QTest::newRow("grey") << static_cast<int>(MapColouring::Grey);
  QTest::newRow("uniform") << static_cast<int>(MapColouring::Uniform);
}

void TestDisplay::theModelImageShowsEveryCell() {
  QFETCH(int, colouring);
  DisplayOptions options;
  options.maps = static_cast<MapColouring>(colouring);
  auto result = std::make_shared<Result>();
  auto model = std::make_shared<EnvironmentModel>(GridGeometry({-1, 1, -0.5, 0.5, 0, 10}, 0.05));
  for (int k = 0; k < 255; ++k) {
    model->set(k % 40, k / 40, 0.6F, static_cast<std::uint8_t>(k + 1));
  }
  model->set(0, 10, 0.3F, 0);
  model->set(1, 10, boomwatch::observedFloor, 0);
  result->model = model;
  const auto display = makeDisplay(result, options);
  QCOMPARE(display->model.size(), QSize(40, 20));
  QCOMPARE(display->probability.size(), QSize(40, 20));
  const auto table = colourTable(options.maps);
  const auto& free = table[freeBrightness];
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 40; ++column) {
      const int level = model->levels()[model->geometry().index(column, row)];
      const QRgb seen = display->model.pixel(column, row);
      if (model->state(column, row) == CellState::NeverObserved) {
        QCOMPARE(qAlpha(seen), 0);
        QCOMPARE(qAlpha(display->probability.pixel(column, row)), 0);
      } else if (level == 0) {
        QCOMPARE(seen, qRgb(free[0], free[1], free[2]));
      } else {
        const auto& c = table[brightnessOfLevel(static_cast<std::uint8_t>(level))];
        QCOMPARE(seen, qRgb(c[0], c[1], c[2]));
      }
    }
  }
}

void TestDisplay::theProbabilityImageGrowsBrighterWithProbability() {
  auto result = std::make_shared<Result>();
  auto model = std::make_shared<EnvironmentModel>(GridGeometry({0, 1, 0, 1, 0, 10}, 0.1));
  // The fixed point of Eq. 8 with 0.2 and 0.7 is 2/3: the brightest that can be.
  for (int k = 0; k < 10; ++k) model->set(k, 0, (k + 1) / 15.0F, 0);
  result->model = model;
  const auto display = makeDisplay(result, {});
  for (int k = 1; k < 10; ++k) {
    QVERIFY(qRed(display->probability.pixel(k, 0)) > qRed(display->probability.pixel(k - 1, 0)));
  }
  QCOMPARE(qRed(display->probability.pixel(9, 0)), 255);
}

void TestDisplay::nearerIsBrighterAndEveryDepthIsBrighterThanFree() {
  for (int level = 2; level < 256; ++level) {
    QVERIFY(brightnessOfLevel(static_cast<std::uint8_t>(level)) <=
            brightnessOfLevel(static_cast<std::uint8_t>(level - 1)));
  }
  QCOMPARE(int(brightnessOfLevel(1)), 255);
  QVERIFY(brightnessOfLevel(255) > freeBrightness + 20);
  for (const auto colouring : {MapColouring::Grey, MapColouring::Uniform}) {
    const auto table = colourTable(colouring);
    for (std::size_t k = 16; k < 256; k += 16) {
      QVERIFY(qGray(table[k][0], table[k][1], table[k][2]) >
              qGray(table[k - 16][0], table[k - 16][1], table[k - 16][2]));
    }
  }
}

void TestDisplay::theCloudHoldsTheMeasuredPointsInsideTheBounds() {
  const auto result = testing::makeResult();
  result->scene.removed.clear();
  result->parameters.bounds.xMax = 1.0;
  const auto display = makeDisplay(shared(result), {});
  std::size_t expected = 0;
  for (const auto& p : result->cloud->points) {
    expected += isMeasured(p) && result->parameters.bounds.contains(p);
  }
  QVERIFY(expected > 100000 && expected < result->cloud->size());
  QCOMPARE(display->cloud.points.size(), expected);
  QCOMPARE(display->cloud.colours.size(), expected);
  for (const auto& p : display->cloud.points) QVERIFY(p.allFinite() && p.x() < 1.0F);
}

void TestDisplay::theLayersOfTheCloudAreEvenSamples() {
  const auto display = makeDisplay(shared(testing::makeResult()), {});
  const DrawnCloud& cloud = display->cloud;
  QCOMPARE(cloud.layerEnds.back(), cloud.points.size());
  // Each quadrant of the picture has its share of the first layer.
  std::array<double, 4> all{};
  std::array<double, 4> first{};
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    const auto& p = cloud.points[k];
    const std::size_t quadrant = (p.x() > 0 ? 1U : 0U) + (p.y() > 0 ? 2U : 0U);
    ++all[quadrant];
    if (k < cloud.layerEnds.front()) ++first[quadrant];
  }
  const auto total = static_cast<double>(cloud.points.size());
  const auto sample = static_cast<double>(cloud.layerEnds.front());
  for (std::size_t q = 0; q < 4; ++q) {
    BW_COMPARE_NEAR(first[q] / sample, all[q] / total, 0.005);
  }
}

void TestDisplay::pointsTakenOutAsDynamicAreNotDrawnTwice() {
  const auto result = testing::makeResult();
  result->load = OrientedBox{{0, 0, 6}, {1, 1, 1}, Eigen::Matrix3d::Identity()};
  result->scene.toolBox = AxisAlignedBox{{-2, -2, 5.9}, {-1, -1, 6.1}};
  const auto display = makeDisplay(shared(result), {});
  QVERIFY(!display->cloud.points.empty());
  for (const auto& p : display->cloud.points) {
    QVERIFY(!result->load->contains(p.cast<double>()));
    QVERIFY(!result->scene.toolBox->contains(p.cast<double>()));
  }
}

void TestDisplay::pointsAreColouredByDepth() {
  const auto display = makeDisplay(shared(testing::makeResult()), {});
  const DrawnCloud& cloud = display->cloud;
  std::optional<int> post;
  std::optional<int> floor;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    (cloud.points[k].z() < 5 ? post : floor) = brightness(cloud.colours[k]);
    QCOMPARE(int(cloud.colours[k][3]), 255);
  }
  QVERIFY(post && floor && *post > *floor);
}

void TestDisplay::pointsAreColouredByHeight() {
  DisplayOptions options;
  options.cloud = CloudColouring::Height;
  const auto display = makeDisplay(shared(testing::makeResult()), options);
  const DrawnCloud& cloud = display->cloud;
  std::size_t high = 0;
  std::size_t low = 0;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    if (cloud.points[k].y() < cloud.points[high].y()) high = k;
    if (cloud.points[k].y() > cloud.points[low].y()) low = k;
  }
  QVERIFY(brightness(cloud.colours[high]) > brightness(cloud.colours[low]));
}

void TestDisplay::pointsAreColouredAsInThePicture() {
  const auto result = testing::makeResult();
  DisplayOptions options;
  options.cloud = CloudColouring::Image;
  const auto display = makeDisplay(shared(result), options);
  const DrawnCloud& cloud = display->cloud;
  for (std::size_t k = 0; k < cloud.points.size(); k += 997) {
    const auto& p = cloud.points[k];
    const auto column = std::lround(p.x() / p.z() * testing::focal + testing::centreX);
    const auto row = std::lround(p.y() / p.z() * testing::focal + testing::centreY);
    const auto bgr = result->image.at<cv::Vec3b>(static_cast<int>(row), static_cast<int>(column));
    QCOMPARE(int(cloud.colours[k][0]), int(bgr[2]));
    QCOMPARE(int(cloud.colours[k][1]), int(bgr[1]));
    QCOMPARE(int(cloud.colours[k][2]), int(bgr[0]));
  }
}

void TestDisplay::withoutAMatchingPictureColoursAreByDepth() {
  const auto result = testing::makeResult();
  result->image = testing::makeImage(100, 50);
  DisplayOptions options;
  options.cloud = CloudColouring::Image;
  const auto display = makeDisplay(shared(result), options);
  QCOMPARE(display->cloudColouring, CloudColouring::Depth);
  QVERIFY(!display->projection);
  QCOMPARE(display->cloud.colours, makeDisplay(shared(result), {})->cloud.colours);
}

void TestDisplay::theProjectionIsTheCameraOfTheCloud() {
  const auto result = testing::makeResult();
  QCOMPARE(makeDisplay(shared(result), {})->projection, result->cloud->camera);
}

void TestDisplay::aCloudOfNothingButNanIsHarmless() {
  auto result = std::make_shared<Result>();
  auto cloud = std::make_shared<Cloud>();
  cloud->width = 50;
  cloud->height = 40;
  cloud->points.assign(2000, unmeasuredPoint());
  cloud->points[7] = {std::numeric_limits<float>::infinity(), 0.0F, 1.0F};
  result->cloud = cloud;
  result->image = testing::makeImage(50, 40);
  const auto display = makeDisplay(result, {});
  QVERIFY(display->cloud.points.empty());
  QVERIFY(!display->projection);
}

BOOMWATCH_TEST(TestDisplay)
#include "test_display.moc"
