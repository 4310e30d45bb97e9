#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include "map_view.h"
#include "support/test_registry.h"
#include "theme.h"

using namespace boomwatch;

class TestMapView : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void withoutAModelItSaysSo();
  void theReadoutGivesMetresAndProbability();
  void zoomKeepsTheCellUnderTheCursor();
  void zoomHasLimits();
  void dragMovesTheMapWithTheHand();
  void theMapCannotBeDraggedOutOfSight();
  void fitShowsTheWholeMap();
  void aCellFillsItsPixelsWithoutSmoothing();
  void neverObservedIsHatchedAndFreeIsNot();
  void aSingleCellDoesNotVanishInAMapThatIsShrunk();
  void theCursorReadsTheCellUnderIt();
  void theNearestPointIsDrawnOnTheEnvironmentMapOnly();
  void whatIsTooSmallToCountIsMarkedAndSaid();
  void aRayWithoutASurfaceHasADirection();
};

namespace {

const Bounds bounds{-2, 2, -1, 1, 0, 10};

/// 40 x 20 cells of 0.1 m; one occupied, one free, the rest never observed.
std::shared_ptr<Result> smallResult() {
  auto result = std::make_shared<Result>();
  result->parameters.bounds = bounds;
  auto model = std::make_shared<EnvironmentModel>(GridGeometry(bounds, 0.1));
  model->set(32, 7, 0.62F, 94);
  model->set(10, 10, 0.1F, 0);
  result->model = model;
  return result;
}

QPointF centreOf(const MapView& map, int column, int row) {
  const GridGeometry geometry(bounds, 0.1);
  return map.positionOf(geometry.xOf(column), geometry.yOf(row));
}

struct ShownMap {
  MapView map;
  explicit ShownMap(MapKind kind, const ResultPtr& result = smallResult()) : map(kind) {
    map.resize(410, 240);
    map.setDisplay(makeDisplay(result, {}));
    map.show();
  }
};

}  // namespace

void TestMapView::withoutAModelItSaysSo() {
  MapView map(MapKind::Environment);
  map.resize(300, 200);
  const QImage before = map.grab().toImage();
  map.setDisplay(makeDisplay(std::make_shared<Result>(), {}));
  QVERIFY(!map.cellAt({100, 100}));
  QVERIFY(map.readout({0, 0}).isEmpty());
  QCOMPARE(map.grab().toImage(), before);
  map.zoom(2.0, {10, 10});
  map.fit();
  QTest::keyClick(&map, Qt::Key_Left);
}

void TestMapView::theReadoutGivesMetresAndProbability() {
  ShownMap shown(MapKind::Environment);
  // Cell 32, 7: x = -2 + 32.5 * 0.1, y = -1 + 7.5 * 0.1, z = 94 * 10 / 255.
  QCOMPARE(shown.map.readout({32, 7}), QString("x 1.25 m  y -0.25 m  z 3.69 m  P 0.62  occupied"));
  QCOMPARE(shown.map.readout({10, 10}), QString("x -0.95 m  y 0.05 m  P 0.10  observed, free"));
  QCOMPARE(shown.map.readout({0, 0}), QString("x -1.95 m  y -0.95 m  unobserved"));
  QVERIFY(shown.map.readout({40, 0}).isEmpty());
  QVERIFY(shown.map.readout({0, -1}).isEmpty());
}

void TestMapView::zoomKeepsTheCellUnderTheCursor() {
  ShownMap shown(MapKind::Environment);
  const QPointF cursor = centreOf(shown.map, 32, 7);
  const double before = shown.map.scale();
  QWheelEvent wheel(cursor, cursor, {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&shown.map, &wheel);
  QVERIFY(shown.map.scale() > 1.4 * before);
  QCOMPARE(shown.map.cellAt(cursor), std::optional(QPoint(32, 7)));
  QVERIFY((centreOf(shown.map, 32, 7) - cursor).manhattanLength() < 1e-6);
}

void TestMapView::zoomHasLimits() {
  ShownMap shown(MapKind::Environment);
  shown.map.zoom(1e9, {200, 100});
  QCOMPARE(shown.map.scale(), 64.0);
  shown.map.zoom(1e-9, {200, 100});
  QVERIFY(shown.map.scale() > 1.0);
  const double before = shown.map.scale();
  shown.map.zoom(0.0, {200, 100});
  shown.map.zoom(-3.0, {200, 100});
  QCOMPARE(shown.map.scale(), before);
}

void TestMapView::dragMovesTheMapWithTheHand() {
  ShownMap shown(MapKind::Probability);
  const QPointF before = shown.map.positionOf(0, 0);
  QTest::mousePress(&shown.map, Qt::LeftButton, {}, {200, 100});
  QMouseEvent move(QEvent::MouseMove, QPointF(230, 90), QPointF(230, 90), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&shown.map, &move);
  QTest::mouseRelease(&shown.map, Qt::LeftButton, {}, {230, 90});
  QCOMPARE(shown.map.positionOf(0, 0) - before, QPointF(30, -10));
}

void TestMapView::theMapCannotBeDraggedOutOfSight() {
  ShownMap shown(MapKind::Probability);
  for (int k = 0; k < 200; ++k) QTest::keyClick(&shown.map, Qt::Key_Left);
  QVERIFY(shown.map.positionOf(bounds.xMin, 0).x() < shown.map.width());
  for (int k = 0; k < 200; ++k) QTest::keyClick(&shown.map, Qt::Key_Right);
  QVERIFY(shown.map.positionOf(bounds.xMax, 0).x() > 0);
}

void TestMapView::fitShowsTheWholeMap() {
  ShownMap shown(MapKind::Environment);
  shown.map.zoom(5.0, {50, 50});
  QTest::keyClick(&shown.map, Qt::Key_F);
  const QRectF whole(shown.map.positionOf(bounds.xMin, bounds.yMin),
                     shown.map.positionOf(bounds.xMax, bounds.yMax));
  QVERIFY(QRectF(shown.map.rect()).contains(whole));
  QVERIFY(whole.width() > 0.95 * shown.map.width() || whole.height() > 0.8 * shown.map.height());
  shown.map.resize(200, 300);
  QVERIFY(shown.map.positionOf(bounds.xMax, 0).x() <= 200.5);
}

void TestMapView::aCellFillsItsPixelsWithoutSmoothing() {
  ShownMap shown(MapKind::Environment);
  shown.map.zoom(3.0, centreOf(shown.map, 32, 7));
  const QImage image = shown.map.grab().toImage();
  const QPointF centre = centreOf(shown.map, 32, 7);
  const auto half = static_cast<int>(shown.map.scale() / 2) - 2;
  const int grey = brightnessOfLevel(94);
  for (const QPoint& by : {QPoint(0, 0), QPoint(half, half), QPoint(-half, -half)}) {
    QCOMPARE(image.pixel(centre.toPoint() + by) | 0xff000000U, qRgb(grey, grey, grey));
  }
}

void TestMapView::neverObservedIsHatchedAndFreeIsNot() {
  ShownMap shown(MapKind::Environment);
  shown.map.zoom(3.0, centreOf(shown.map, 10, 10));
  const QImage image = shown.map.grab().toImage();
  auto coloursIn = [&](int column, int row) {
    QSet<QRgb> colours;
    const QPoint centre = centreOf(shown.map, column, row).toPoint();
    for (int k = -8; k <= 8; ++k) colours << image.pixel(centre + QPoint(k, 0));
    return colours;
  };
  QCOMPARE(coloursIn(10, 10).size(), 1);
  const Theme theme = themeFor(shown.map.palette());
  QCOMPARE(coloursIn(12, 10), QSet<QRgb>({theme.hatchLight.rgb(), theme.hatchDark.rgb()}));
}

void TestMapView::aSingleCellDoesNotVanishInAMapThatIsShrunk() {
  auto result = std::make_shared<Result>();
  auto model = std::make_shared<EnvironmentModel>(GridGeometry({0, 20, 0, 10, 0, 10}, 0.01));
  for (int row = 0; row < 1000; ++row) {
    for (int column = 0; column < 2000; ++column) model->set(column, row, 0.1F, 0);
  }
  model->set(1001, 501, 0.6F, 1);
  result->model = model;
  MapView map(MapKind::Environment);
  map.resize(400, 250);
  map.setDisplay(makeDisplay(result, {}));
  QVERIFY(map.scale() < 0.25);
  const QImage image = map.grab().toImage();
  const QPoint at = map.positionOf(10.015, 5.015).toPoint();
  int brightest = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      brightest = std::max(brightest, qRed(image.pixel(at + QPoint(dx, dy))));
    }
  }
  QVERIFY2(brightest > freeBrightness, qPrintable(QString::number(brightest)));
}

void TestMapView::theCursorReadsTheCellUnderIt() {
  ShownMap shown(MapKind::Probability);
  QSignalSpy spy(&shown.map, &MapView::readoutChanged);
  const QPointF at = centreOf(shown.map, 32, 7);
  QMouseEvent move(QEvent::MouseMove, at, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&shown.map, &move);
  QCOMPARE(spy.last().first().toString(), shown.map.readout({32, 7}));
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&shown.map, &leave);
  QVERIFY(spy.last().first().toString().isEmpty());
}

void TestMapView::theNearestPointIsDrawnOnTheEnvironmentMapOnly() {
  auto result = smallResult();
  Nearest nearest;
  nearest.onLoad = {0.5, 0.0, 3};
  nearest.onEnvironment = {1.25, -0.25, 3.7};
  result->clearance.nearest = nearest;
  result->load = OrientedBox{{0, 0, 3}, {1, 0.4, 0.4}, Eigen::Matrix3d::Identity()};
  result->clearance.rays.push_back({{0, 0, 3}, {0, 0.9, 3}});
  for (const auto kind : {MapKind::Environment, MapKind::Probability}) {
    ShownMap shown(kind, result);
    const QImage image = shown.map.grab().toImage();
    const Theme theme = themeFor(shown.map.palette());
    auto shows = [&](double x, double y, const QColor& colour) {
      const QPoint at = shown.map.positionOf(x, y).toPoint();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const QColor seen = image.pixelColor(at + QPoint(dx, dy));
          if (std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                  std::abs(seen.blue() - colour.blue()) <
              90) {
            return true;
          }
        }
      }
      return false;
    };
    const bool expected = kind == MapKind::Environment;
    const double ring = 8.0 / shown.map.scale() * 0.1;
    QCOMPARE(shows(1.25 + ring, -0.25, theme.nearest), expected);
    QCOMPARE(shows(-0.5, 0.0, theme.load), expected);
    QCOMPARE(shows(0.0, 0.6, theme.rays), expected);
  }
}

void TestMapView::whatIsTooSmallToCountIsMarkedAndSaid() {
  const auto edgeOf = [](const std::shared_ptr<Result>& result) {
    ShownMap shown(MapKind::Environment, result);
    const QPointF edge(shown.map.scale() / 2 + 2, 0);
    const QImage image = shown.map.grab().toImage();
    return image.pixelColor((centreOf(shown.map, 32, 7) - edge).toPoint());
  };
  auto result = smallResult();
  const QColor before = edgeOf(result);
  QVERIFY(!ShownMap(MapKind::Environment, result).map.readout({32, 7}).contains("too small"));
  const std::size_t cell = result->model->geometry().index(32, 7);
  result->suppressed = {cell};
  // The line is smoothed: nearer to the colour of texts than what was there before.
  QVERIFY(qGray(edgeOf(result).rgb()) > qGray(before.rgb()) + 40);
  // Of two, the line goes around both.
  result->suppressed = {cell - 1, cell};
  QCOMPARE(edgeOf(result), before);
  QVERIFY(ShownMap(MapKind::Environment, result).map.readout({32, 7}).contains("too small"));
}

void TestMapView::aRayWithoutASurfaceHasADirection() {
  const GridGeometry rays({-2, 2, -1, 1, 0, 10}, 0.1, ModelProjection::Perspective);
  auto model = std::make_shared<EnvironmentModel>(rays);
  const Eigen::Vector3d p(1.0, 0.5, 8.0);
  const Eigen::Vector2d place = rays.onPlane(p);
  const QPoint cell(rays.columnOf(place.x()), rays.rowOf(place.y()));
  model->set(cell.x(), cell.y(), 0.6F, rays.levelOf(p.z()));
  auto result = std::make_shared<Result>();
  result->model = model;
  ShownMap shown(MapKind::Environment, result);
  QVERIFY(shown.map.readout(cell).contains(QLocale().toString(8.0, 'f', 1)));
  QVERIFY(shown.map.readout(cell).startsWith("x "));
  QVERIFY(shown.map.readout(cell + QPoint(3, 0)).startsWith("x/z "));
}

BOOMWATCH_TEST(TestMapView)
#include "test_map_view.moc"
