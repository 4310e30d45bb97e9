#include <QSignalSpy>
#include <QtTest>

#include "camera_view.h"
#include "scene_for_tests.h"
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
    QVERIFY(std::abs(area.width() / area.height() - 768.0 / 576.0) < 1e-9);
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

QTEST_MAIN(TestCameraView)
#include "test_camera_view.moc"
