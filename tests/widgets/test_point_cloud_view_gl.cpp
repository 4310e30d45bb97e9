#include <QMainWindow>
#include <QtTest>

#include "point_cloud_view.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"
#include "theme.h"

using namespace boomwatch;

/// Needs a display with OpenGL 3.2, such as Xvfb with Mesa; skips elsewhere.
class TestPointCloudViewGl : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    PointCloudView view;
    if (!view.has3d()) QSKIP(qPrintable(view.whyNo3d()));
  }
  void everythingIsDrawnInItsColour();
  void clearingLeavesAnEmptyCanvas();
  void anEmptyCloudIsHarmless();
  void dragTurnsAndResetTurnsBack();
  void everyPointIsDrawnOnceTheViewIsStill();
  void theViewSurvivesBeingTornOff();
  void theImageIsOpaque();
};

namespace {

int pixelsOf(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor seen = image.pixelColor(x, y);
      count += std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                   std::abs(seen.blue() - colour.blue()) <
               12;
    }
  }
  return count;
}

int drawnPixels(const QImage& image) {
  const Theme theme = themeOf(ThemeKind::Dark);
  return image.width() * image.height() - pixelsOf(image, theme.canvas);
}

std::shared_ptr<Result> closeResult() {
  auto result = testing::makeResult();
  result->parameters.bounds = {-4, 4, -3, 3, 0, 7};
  return result;
}

struct Shown {
  PointCloudView view;
  Shown() {
    view.resize(640, 480);
    view.setDisplay(makeDisplay(closeResult(), {}));
    view.show();
  }
  bool wait() { return QTest::qWaitForWindowExposed(&view); }
};

}  // namespace

void TestPointCloudViewGl::everythingIsDrawnInItsColour() {
  Shown shown;
  QVERIFY(shown.wait());
  const QImage image = shown.view.image();
  const Theme theme = themeOf(ThemeKind::Dark);
  QVERIFY(pixelsOf(image, theme.canvas) > 10000);
  QVERIFY(pixelsOf(image, theme.bounds) > 300);
  QVERIFY(pixelsOf(image, theme.load) > 50);
  QVERIFY(pixelsOf(image, theme.nearest) > 20);
  QVERIFY(drawnPixels(image) > 20000);
}

void TestPointCloudViewGl::clearingLeavesAnEmptyCanvas() {
  Shown shown;
  QVERIFY(shown.wait());
  shown.view.setDisplay(nullptr);
  QCOMPARE(drawnPixels(shown.view.image()), 0);
}

void TestPointCloudViewGl::anEmptyCloudIsHarmless() {
  Shown shown;
  QVERIFY(shown.wait());
  auto result = std::make_shared<Result>();
  auto cloud = std::make_shared<Cloud>();
  cloud->width = 10;
  cloud->height = 10;
  cloud->points.assign(100, unmeasuredPoint());
  result->cloud = cloud;
  shown.view.setDisplay(makeDisplay(result, {}));
  const QImage image = shown.view.image();
  QVERIFY(pixelsOf(image, themeOf(ThemeKind::Dark).bounds) > 100);
  shown.view.setDisplay(makeDisplay(closeResult(), {}));
  QVERIFY(drawnPixels(shown.view.image()) > 20000);
}

void TestPointCloudViewGl::dragTurnsAndResetTurnsBack() {
  Shown shown;
  QVERIFY(shown.wait());
  // So few points that a busy machine, too, draws all of them in every picture.
  auto result = closeResult();
  result->cloud = testing::makeCloud(192, 144);
  shown.view.setDisplay(makeDisplay(result, {}));
  auto* canvas = shown.view.focusProxy();
  auto drag = [&](Qt::MouseButton button, const QPoint& to) {
    const QPoint from(300, 200);
    QTest::mousePress(canvas, button, {}, from);
    QMouseEvent move(QEvent::MouseMove, QPointF(to), QPointF(to), Qt::NoButton, button,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, button, {}, to);
    return shown.view.image();
  };
  shown.view.resetView();
  const QImage straight = shown.view.image();
  QVERIFY(drag(Qt::LeftButton, {360, 260}) != straight);
  shown.view.resetView();
  QCOMPARE(shown.view.image(), straight);
  QVERIFY(drag(Qt::MiddleButton, {360, 260}) != straight);
  shown.view.resetView();
  const QImage larger = drag(Qt::RightButton, {300, 120});
  QVERIFY(drawnPixels(larger) > drawnPixels(straight));
  // Up and over the pole: the view stops short of it and nothing becomes NaN.
  for (int k = 0; k < 20; ++k) drag(Qt::LeftButton, {300, 400});
  shown.view.resetView();
  QCOMPARE(shown.view.image(), straight);
}

void TestPointCloudViewGl::everyPointIsDrawnOnceTheViewIsStill() {
  Shown shown;
  QVERIFY(shown.wait());
  // The cloud in one plain colour of its own, so that its pixels can be counted.
  auto result = closeResult();
  result->image = cv::Mat(576, 768, CV_8UC3, cv::Scalar(255, 0, 255));
  result->scene.removed.clear();
  DisplayOptions options;
  options.cloud = CloudColouring::Image;
  shown.view.setDisplay(makeDisplay(result, options));
  const double size = [&] {
    const QImage image = shown.view.image();
    return static_cast<double>(image.width()) * image.height();
  }();
  QTRY_VERIFY(pixelsOf(shown.view.image(), QColor(255, 0, 255)) > 0.05 * size);
}

void TestPointCloudViewGl::theViewSurvivesBeingTornOff() {
  QMainWindow window;
  auto* view = new PointCloudView;
  window.setCentralWidget(view);
  window.resize(500, 400);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  view->setDisplay(makeDisplay(closeResult(), {}));
  QVERIFY(drawnPixels(view->image()) > 5000);
  window.takeCentralWidget();
  view->setParent(nullptr);
  view->show();
  QVERIFY(QTest::qWaitForWindowExposed(view));
  QVERIFY(drawnPixels(view->image()) > 5000);
  window.setCentralWidget(view);
  QVERIFY(drawnPixels(view->image()) > 5000);
}

void TestPointCloudViewGl::theImageIsOpaque() {
  Shown shown;
  QVERIFY(shown.wait());
  const QImage image = shown.view.image().convertToFormat(QImage::Format_ARGB32);
  for (int y = 0; y < image.height(); y += 7) {
    for (int x = 0; x < image.width(); x += 7) QCOMPARE(qAlpha(image.pixel(x, y)), 255);
  }
}

BOOMWATCH_TEST(TestPointCloudViewGl)
#include "test_point_cloud_view_gl.moc"
