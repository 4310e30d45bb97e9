#include <QtTest>
#include <algorithm>

#include "support/compare_near.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"
#include "tracking/box_flow.h"
#include "tracking/median_flow.h"

using namespace boomwatch;
using boomwatch::test::TargetScene;

namespace {

constexpr double side = 100.0;  // of the box: a rim of 10 pixels around the target is wall

cv::Mat greyAt(const TargetScene& scene, const cv::Point2d& centre) {
  cv::Mat grey;
  cv::cvtColor(scene.image(centre), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

cv::Rect2d boxAt(const cv::Point2d& centre) {
  return {centre.x - side / 2, centre.y - side / 2, side, side};
}

bool isRim(std::size_t cell) {
  const auto row = cell / FlowCells::side, column = cell % FlowCells::side;
  const std::size_t last = FlowCells::side - 1;
  return row == 0 || column == 0 || row == last || column == last;
}

}  // namespace

/// Which parts of a box move with what is in it.
class TestMedianFlow : public QObject {
  Q_OBJECT
 private slots:
  void whatStandsStillIsToldApart();
  void whoStandsStillTeachesNothing();
  void someAreAlwaysAsked();
  void thePartThatMattersIsInThePicture();

 private:
  const TargetScene m_scene;
};

void TestMedianFlow::whatStandsStillIsToldApart() {
  FlowCells cells;
  cv::Point2d centre(100, 120);
  for (int k = 0; k < 15; ++k) {
    const cv::Point2d next = centre + cv::Point2d(6, 0);
    const auto flow =
        medianFlow(greyAt(m_scene, centre), greyAt(m_scene, next), boxAt(centre), &cells);
    QVERIFY(flow);
    BW_COMPARE_NEAR(flow->box.x, boxAt(next).x, 1.0);
    centre = next;
  }
  const auto reliable = cells.reliable();
  int rim = 0, middle = 0;
  for (std::size_t k = 0; k < FlowCells::count; ++k) (isRim(k) ? rim : middle) += reliable[k];
  QVERIFY2(rim <= 9, qPrintable(QString::number(rim)));         // of 36
  QVERIFY2(middle >= 58, qPrintable(QString::number(middle)));  // of 64
}

void TestMedianFlow::whoStandsStillTeachesNothing() {
  FlowCells cells;
  for (std::size_t k = 0; k < FlowCells::count; ++k) {
    for (int n = 0; n < 20; ++n) cells.note(k, !isRim(k));
  }
  const auto before = cells.reliable();
  const cv::Mat still = greyAt(m_scene, {160, 120});
  for (int n = 0; n < 20; ++n) QVERIFY(medianFlow(still, still, boxAt({160, 120}), &cells));
  QVERIFY(cells.reliable() == before);
}

void TestMedianFlow::someAreAlwaysAsked() {
  FlowCells cells;
  for (std::size_t k = 0; k < FlowCells::count; ++k) {
    for (std::size_t n = 0; n < 20 + k; ++n) cells.note(k, false);
  }
  const auto reliable = cells.reliable();
  QVERIFY(std::ranges::count(reliable, true) >= 25);
}

void TestMedianFlow::thePartThatMattersIsInThePicture() {
  for (const cv::Rect2d& box :
       {boxAt({0, 0}), boxAt({160, 120}), boxAt({330, 250}), cv::Rect2d(-900, 0, 20, 20)}) {
    const cv::Mat grey = greyAt(m_scene, {160, 120});
    const cv::Rect part = flowRegion(box, grey.size());
    QCOMPARE((part & cv::Rect({}, grey.size())).area(), part.area());
    FlowCells cells;
    QCOMPARE(medianFlow(grey, grey, box, &cells).has_value(), !part.empty());
    QVERIFY(!medianFlow(grey, cv::Mat(10, 10, CV_8UC1), box, &cells));
  }
}

BOOMWATCH_TEST(TestMedianFlow)
#include "test_median_flow.moc"
