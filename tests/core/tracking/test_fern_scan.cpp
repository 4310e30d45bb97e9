#include <QtTest>

#include "support/test_registry.h"
#include "tracking/fern_scan.h"

using boomwatch::FernEnsemble;
using boomwatch::FernScan;
using boomwatch::ToolModel;

namespace {

cv::Mat noise(cv::Size size) {
  cv::Mat image(size, CV_8UC1);
  cv::RNG(1).fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

}  // namespace

/// Windows read side by side have the codes that each has alone.
class TestFernScan : public QObject {
  Q_OBJECT

 private slots:
  void everyWindowHasItsOwnCodes_data() {
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("stride");
    QTest::newRow("every pixel") << 60 << 1;
    QTest::newRow("every second") << 61 << 2;
    QTest::newRow("every third") << 62 << 3;
    QTest::newRow("as wide as one window") << 15 << 2;
  }

  void everyWindowHasItsOwnCodes() {
    QFETCH(int, columns);
    QFETCH(int, stride);
    const cv::Size patch(15, 12);
    const FernEnsemble ferns(
        patch, std::vector<boomwatch::FernLeaf>(ToolModel::ferns * ToolModel::leavesPerFern));
    const cv::Mat image = noise({columns, 20});
    const FernScan scan(ferns, image, stride);
    const int lanes = static_cast<int>(FernScan::lanes);
    int windows = 0;
    FernScan::Codes codes;
    for (int row = 0; row + patch.height <= image.rows; ++row) {
      for (int window = 0; window * stride + patch.width <= image.cols; ++window) {
        if (window % lanes == 0) scan.read(row, window, codes);
        const cv::Rect place({window * stride, row}, patch);
        QVERIFY(codes[static_cast<std::size_t>(window % lanes)] == ferns.codesOf(image(place)));
        ++windows;
      }
    }
    QVERIFY(windows >= 9);
  }
};

BOOMWATCH_TEST(TestFernScan)
#include "test_fern_scan.moc"
