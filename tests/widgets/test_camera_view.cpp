#include <QSignalSpy>
#include <QtTest>

#include "camera_view.h"
#include "support/compare_near.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"
#include "theme.h"

using namespace boomwatch;

class TestCameraView : public QObject {
  Q_OBJECT

 private slots:
  void withoutAPictureItSaysSoAndPicksNothing();
  void thePictureKeepsItsAspect();
  void aClickGivesThePixelUnderIt();
  void aClickBesideThePictureGivesNothing();
  void rightClickAndEscapeForgetTheTool();
  void theToolCanBePickedFromTheKeyboard();
  void theKeyboardStaysInsideThePicture();
  void aDragGivesTheBox_data();
  void aDragGivesTheBox();
  void aDragThatLeavesThePictureEndsAtItsEdge();
  void aBoxTooSmallIsNeitherABoxNorAClick();
  void escapeGivesTheDragUpAndNotTheTool();
  void aBoxFromTheKeyboard();
  void aBoxIsGivenUpWhenThePictureChangesItsSize();
  void theToolsBoxIsDrawnSolidWhereItIsMeasured();
  void anUnseenToolIsSaidInWords();
  void theLoadIsDrawnWhereThePinholePutsIt();
  void aLoadAroundTheCameraIsHarmless();
};

namespace {

/// Whether a pixel or one beside it has the colour.
bool shows(const QImage& image, const QPoint& at, const QColor& colour) {
  for (const QPoint& by : {QPoint(0, 0), QPoint(-1, 0), QPoint(0, -1), QPoint(-1, -1)}) {
    const QColor seen = image.pixelColor(at + by);
    if (std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
            std::abs(seen.blue() - colour.blue()) <
        60) {
      return true;
    }
  }
  return false;
}

/// Left button down at `from`, and the mouse moved to `to`.
void drag(QWidget& view, const QPoint& from, const QPoint& to) {
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, (from + to) / 2);
  QTest::mouseMove(&view, to);
}

}  // namespace

void TestCameraView::withoutAPictureItSaysSoAndPicksNothing() {
  CameraView view;
  view.resize(300, 200);
  QSignalSpy picked(&view, &CameraView::toolPicked);
  for (const auto& display : {DisplayPtr(), makeDisplay(std::make_shared<Result>(), {})}) {
    view.setDisplay(display);
    const QImage image = view.grab().toImage();
    const QRgb ground = image.pixel(0, 0);
    bool words = false;
    for (int x = 0; x < 300; ++x) words = words || image.pixel(x, 100) != ground;
    QVERIFY(words);
    QTest::mouseClick(&view, Qt::LeftButton, {}, {150, 100});
    QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_Return);
  }
  QCOMPARE(picked.count(), 0);
  QVERIFY(view.pictureRect().isEmpty());
}

void TestCameraView::thePictureKeepsItsAspect() {
  CameraView view;
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  for (const QSize size : {QSize(400, 200), QSize(200, 400)}) {
    view.resize(size);
    const QRectF area = view.pictureRect();
    QVERIFY(QRectF(view.rect()).contains(area));
    BW_COMPARE_NEAR(area.width() / area.height(), 768.0 / 576.0, 1e-9);
  }
}

void TestCameraView::aClickGivesThePixelUnderIt() {
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy picked(&view, &CameraView::toolPicked);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {120, 340});
  QCOMPARE(picked.last().first().toPoint(), QPoint(120, 340));
  view.resize(384, 500);  // half the size, with bands above and below
  const double top = view.pictureRect().top();
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, static_cast<int>(top) + 50});
  QCOMPARE(picked.last().first().toPoint(), QPoint(200, 100));
}

void TestCameraView::aClickBesideThePictureGivesNothing() {
  CameraView view;
  view.resize(384, 500);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy picked(&view, &CameraView::toolPicked);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 5});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 495});
  QCOMPARE(picked.count(), 0);
}

void TestCameraView::rightClickAndEscapeForgetTheTool() {
  CameraView view;
  view.resize(384, 288);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy cleared(&view, &CameraView::toolCleared);
  QTest::mouseClick(&view, Qt::RightButton, {}, {100, 100});
  QTest::keyClick(&view, Qt::Key_Escape);
  QCOMPARE(cleared.count(), 2);
}

void TestCameraView::theToolCanBePickedFromTheKeyboard() {
  CameraView view;
  view.resize(384, 288);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy picked(&view, &CameraView::toolPicked);
  QTest::keyClick(&view, Qt::Key_Return);
  QCOMPARE(picked.count(), 0);
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
  QTest::keyClick(&view, Qt::Key_Return);
  QCOMPARE(picked.last().first().toPoint(), QPoint(768 / 2 + 10, 576 / 2 - 1));
}

void TestCameraView::theKeyboardStaysInsideThePicture() {
  CameraView view;
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy picked(&view, &CameraView::toolPicked);
  for (int k = 0; k < 100; ++k) QTest::keyClick(&view, Qt::Key_Left);
  for (int k = 0; k < 100; ++k) QTest::keyClick(&view, Qt::Key_Down);
  QTest::keyClick(&view, Qt::Key_Return);
  QCOMPARE(picked.last().first().toPoint(), QPoint(0, 575));
}

void TestCameraView::aDragGivesTheBox_data() {
  QTest::addColumn<QPoint>("from");
  QTest::addColumn<QPoint>("to");
  QTest::newRow("down to the right") << QPoint(100, 120) << QPoint(179, 160);
  QTest::newRow("up to the left") << QPoint(179, 160) << QPoint(100, 120);
  QTest::newRow("up to the right") << QPoint(100, 160) << QPoint(179, 120);
}

void TestCameraView::aDragGivesTheBox() {
  QFETCH(QPoint, from);
  QFETCH(QPoint, to);
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy drawn(&view, &CameraView::boxDrawn);
  QSignalSpy picked(&view, &CameraView::toolPicked);
  drag(view, from, to);
  QCOMPARE(view.draft(), std::optional(QRect(100, 120, 80, 41)));
  QVERIFY(!view.grab().isNull());
  QCOMPARE(drawn.count(), 0);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  QCOMPARE(drawn.last().first().toRect(), QRect(100, 120, 80, 41));
  QVERIFY(!view.draft());
  QCOMPARE(picked.count(), 0);
}

void TestCameraView::aDragThatLeavesThePictureEndsAtItsEdge() {
  CameraView view;
  view.resize(384, 500);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy drawn(&view, &CameraView::boxDrawn);
  const int top = static_cast<int>(view.pictureRect().top());
  drag(view, {300, top + 200}, {900, 2000});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {900, 2000});
  QCOMPARE(drawn.last().first().toRect(), QRect(QPoint(600, 400), QPoint(767, 575)));
  // One that begins beside the picture is none.
  drag(view, {300, 5}, {320, 300});
  QVERIFY(!view.draft());
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {320, 300});
  QCOMPARE(drawn.count(), 1);
}

void TestCameraView::aBoxTooSmallIsNeitherABoxNorAClick() {
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy drawn(&view, &CameraView::boxDrawn);
  QSignalSpy picked(&view, &CameraView::toolPicked);
  drag(view, {100, 100}, {140, 102});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {140, 102});
  QCOMPARE(drawn.count() + picked.count(), 0);
  QVERIFY(!view.draft());
}

void TestCameraView::escapeGivesTheDragUpAndNotTheTool() {
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy drawn(&view, &CameraView::boxDrawn);
  QSignalSpy picked(&view, &CameraView::toolPicked);
  QSignalSpy cleared(&view, &CameraView::toolCleared);
  drag(view, {100, 100}, {200, 200});
  QTest::keyClick(&view, Qt::Key_Escape);
  QVERIFY(!view.draft());
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {200, 200});
  QCOMPARE(drawn.count() + picked.count() + cleared.count(), 0);
}

void TestCameraView::aBoxFromTheKeyboard() {
  CameraView view;
  view.resize(384, 288);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  QSignalSpy drawn(&view, &CameraView::boxDrawn);
  QTest::keyClick(&view, Qt::Key_Left);  // the cursor: (374, 288)
  QTest::keyClick(&view, Qt::Key_B);
  QVERIFY(view.draft());
  const QRect first = *view.draft();
  QCOMPARE(first.topLeft(), QPoint(374, 288));
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(&view, Qt::Key_Return);
  QCOMPARE(drawn.last().first().toRect(), first.adjusted(0, 0, 10, 1));
  QTest::keyClick(&view, Qt::Key_B);
  for (int k = 0; k < 100; ++k) QTest::keyClick(&view, Qt::Key_Right);
  QCOMPARE(view.draft()->right(), 767);
  QTest::keyClick(&view, Qt::Key_Escape);
  QVERIFY(!view.draft());
  QCOMPARE(drawn.count(), 1);
}

void TestCameraView::aBoxIsGivenUpWhenThePictureChangesItsSize() {
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  drag(view, {500, 400}, {700, 500});
  auto small = std::make_shared<Result>();
  small->image = testing::makeImage(160, 120);
  view.setDisplay(makeDisplay(small, {}));
  QVERIFY(!view.draft());
}

void TestCameraView::theToolsBoxIsDrawnSolidWhereItIsMeasured() {
  auto result = testing::makeResult();
  result->load.reset();
  result->clearance = Clearance::unknown(Reason::NoModel);
  result->tool.state = TrackState::Tracked;
  result->tool.box = cv::Rect2d(200, 300, 120, 100);
  result->tool.confidence = 0.83;
  CameraView view;
  view.resize(768, 576);
  // Along the box's lower edge, which nothing else crosses.
  const auto share = [&](std::optional<double> age) {
    result->tool.age = age;
    view.setDisplay(makeDisplay(result, {}));
    const QImage image = view.grab().toImage();
    const Theme theme = themeFor(view.palette());
    int seen = 0;
    for (int x = 205; x < 315; ++x) seen += shows(image, {x, 400}, theme.tool) ? 1 : 0;
    return seen / 110.0;
  };
  QVERIFY(share(0.0) > 0.95);
  const double broken = share(0.2);
  QVERIFY2(broken > 0.3 && broken < 0.9, qPrintable(QString::number(broken)));
}

void TestCameraView::anUnseenToolIsSaidInWords() {
  auto result = testing::makeResult();
  CameraView view;
  view.resize(768, 576);
  result->tool = {};
  view.setDisplay(makeDisplay(result, {}));
  // The picture is dark in that corner: what is bright there is writing.
  const auto writing = [&view] {
    const QImage image = view.grab().toImage();
    int pixels = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 400; ++x) pixels += qGray(image.pixel(x, y)) > 200 ? 1 : 0;
    }
    return pixels;
  };
  QCOMPARE(writing(), 0);
  result->tool.state = TrackState::Lost;
  result->tool.age = 1.2;
  view.setDisplay(makeDisplay(result, {}));
  QVERIFY(writing() > 100);
}

void TestCameraView::theLoadIsDrawnWhereThePinholePutsIt() {
  auto result = testing::makeResult();
  result->load = OrientedBox{{0, 0, 4}, {2, 1, 0.5}, Eigen::Matrix3d::Identity()};
  result->clearance = Clearance::unknown(Reason::NoModel);
  result->tool.pixel.reset();
  CameraView view;
  view.resize(768, 576);
  view.setDisplay(makeDisplay(result, {}));
  const QImage image = view.grab().toImage();
  const Theme theme = themeFor(view.palette());
  for (const Eigen::Vector3d& corner : result->load->corners()) {
    const QPointF at(testing::focal * corner.x() / corner.z() + testing::centreX + 0.5,
                     testing::focal * corner.y() / corner.z() + testing::centreY + 0.5);
    QVERIFY(shows(image, at.toPoint(), theme.load));
  }
  QVERIFY(!shows(image, {20, 20}, theme.load));
}

void TestCameraView::aLoadAroundTheCameraIsHarmless() {
  auto result = testing::makeResult();
  result->load = OrientedBox{{0, 0, 0}, {4, 3, 2}, Eigen::Matrix3d::Identity()};
  result->clearance.nearest->onLoad = {0, 0, -1};
  result->clearance.nearest->onEnvironment = {0, 0, 0};
  CameraView view;
  view.resize(384, 288);
  view.setDisplay(makeDisplay(result, {}));
  QVERIFY(!view.grab().isNull());
}

BOOMWATCH_TEST(TestCameraView)
#include "test_camera_view.moc"
