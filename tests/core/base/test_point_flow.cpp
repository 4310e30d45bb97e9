#include <QtTest>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/point_flow.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

cv::Mat texture(cv::Size size) {
  cv::Mat image(size, CV_8UC1);
  cv::RNG(5).fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {}, 2.0);
  return image;
}

cv::Mat moved(const cv::Mat& image, const cv::Point2d& by) {
  cv::Mat result;
  const cv::Matx23d shift(1, 0, by.x, 0, 1, by.y);
  cv::warpAffine(image, result, shift, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return result;
}

}  // namespace

class TestPointFlow : public QObject {
  Q_OBJECT
 private slots:
  void pointsGoWhereTheImageWasMoved() {
    const cv::Mat before = texture({200, 160});
    const cv::Point2d motion(3.5, -2.25);
    const std::vector<cv::Point2f> points{{60, 60}, {100, 80}, {140, 100}};
    const auto followed = followPoints(before, moved(before, motion), points, {});
    QCOMPARE(followed.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      QCOMPARE(followed[i].index, i);
      const cv::Point2d off = cv::Point2d(followed[i].position - points[i]) - motion;
      QVERIFY2(cv::norm(off) < 0.1, qPrintable(QString::number(cv::norm(off))));
      QVERIFY(followed[i].error < 0.1);
    }
  }

  void aGuessLeadsToWhatIsTooFarWithoutIt() {
    const cv::Mat before = texture({200, 160});
    const std::vector<cv::Point2f> points{{60, 80}};
    const cv::Mat after = moved(before, {40.0, 0.0});
    const FlowSearch search{{15, 15}, 1};
    const std::vector<cv::Point2f> guess{{99, 81}};
    const auto guided = followPoints(before, after, points, search, guess);
    QCOMPARE(guided.size(), std::size_t{1});
    QVERIFY(cv::norm(guided[0].position - cv::Point2f(100, 80)) < 0.1);
    const auto lost = followPoints(before, after, points, search);
    QVERIFY(lost.empty() || cv::norm(lost[0].position - cv::Point2f(100, 80)) > 5.0);
  }

  void nothingIsFoundWhereAllIsEqual() {
    const cv::Mat flat(100, 100, CV_8UC1, cv::Scalar(80));
    QVERIFY(followPoints(flat, flat, {{50, 50}}, {}).empty());
    QVERIFY(followPoints(flat, flat, {}, {}).empty());
  }
};

BOOMWATCH_TEST(TestPointFlow)
#include "test_point_flow.moc"
