// The panes that only draw, against pictures of them in tests/baselines/. A picture that changed on
// purpose is taken over by `packaging/dev baselines`, and looked at before it is committed.
#include <QApplication>
#include <QFontInfo>
#include <QLocale>
#include <QtTest>

#include "camera_view.h"
#include "chart.h"
#include "distance_bar.h"
#include "distance_plot.h"
#include "map_view.h"
#include "support/baseline.h"
#include "support/enumerators.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"
#include "theme.h"

using namespace boomwatch;

namespace {

/// A font that packaging/packages.txt installs, drawn alike whatever the machine's settings are.
QFont baselineFont() {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(12);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setStyleStrategy(
      static_cast<QFont::StyleStrategy>(QFont::PreferAntialias | QFont::NoSubpixelAntialias));
  return font;
}

std::shared_ptr<Result> measuredAt(double metres) {
  auto result = testing::makeResult();
  result->clearance.nearest->distance = metres;
  result->level = warningLevel(result->clearance, result->parameters.warning);
  return result;
}

std::shared_ptr<Result> unknownBecause(Reason reason) {
  auto result = testing::makeResult();
  result->clearance = Clearance::unknown(reason);
  result->level = WarningLevel::NoDistance;
  return result;
}

std::shared_ptr<Result> nothingInRange() {
  auto result = testing::makeResult();
  result->clearance.state = ClearanceState::NothingInRange;
  result->clearance.nearest.reset();
  result->level = WarningLevel::Clear;
  return result;
}

/// 4 m by 2 m of ground at 6 m with a wall at 4 m on it, an unobserved corner, and a load.
std::shared_ptr<Result> mapResult() {
  auto result = testing::makeResult();
  auto model = std::make_shared<EnvironmentModel>(GridGeometry({-2, 2, -1, 1, 0, 10}, 0.1));
  const GridGeometry& grid = model->geometry();
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      if (column < 8 && row < 6) continue;
      const bool wall = column > 30;
      model->set(column, row, wall ? 0.66F : 0.55F, grid.levelOf(wall ? 4.0 : 6.0));
    }
  }
  result->model = model;
  result->load = OrientedBox{{0, 0, 3}, {1, 0.4, 0.4}, rotationFromYawPitchRoll(0.3, 0.0, 0.0)};
  result->clearance.nearest->onLoad = {0.5, 0.0, 3.0};
  result->clearance.nearest->onEnvironment = {1.15, -0.25, 4.0};
  result->suppressed = {grid.index(20, 4), grid.index(21, 4)};
  return result;
}

void playInto(DistancePlot& plot) {
  for (int k = 0; k < 60 * 10; ++k) {
    const double stamp = k / 10.0;
    const bool hidden = k >= 200 && k < 300;
    auto result =
        hidden ? unknownBecause(Reason::NoLoad) : measuredAt(1.6 + 1.2 * std::sin(stamp / 6.0));
    auto frame = std::make_shared<Frame>();
    frame->stamp = stamp;
    frame->trueDistance = 1.7 + 1.2 * std::sin(stamp / 6.0);
    result->frame = frame;
    plot.setDisplay(makeDisplay(result, {}));
  }
}

}  // namespace

class TestBaselines : public QObject {
  Q_OBJECT

 private:
  QFont m_font;
  QPalette m_palette;

  void compare(QWidget& pane, const QSize& size, const QString& name) {
    pane.resize(size);
    const QString fault = baselineFault(pane.grab().toImage(), name);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
  }

  void compareBar(const std::shared_ptr<Result>& result, const QString& name) {
    DistanceBar bar;
    bar.setDisplay(makeDisplay(result, {}));
    compare(bar, bar.sizeHint(), "bar_" + name);
  }

 private slots:
  void initTestCase() {
    QLocale::setDefault(QLocale::c());
    m_font = QApplication::font();
    m_palette = QApplication::palette();
    QApplication::setFont(baselineFont());
    QApplication::setPalette(paletteOf(ThemeKind::Dark));
    QVERIFY2(QFontInfo(baselineFont()).family() == QStringLiteral("DejaVu Sans"),
             "the pictures need the package fonts-dejavu-core");
  }
  void cleanupTestCase() {
    QApplication::setFont(m_font);
    QApplication::setPalette(m_palette);
  }

  void theBarAtEveryLevel_data() {
    QTest::addColumn<WarningLevel>("level");
    for (const WarningLevel level : every<WarningLevel>())
      QTest::newRow(std::string(toString(level)).c_str()) << level;
  }
  void theBarAtEveryLevel() {
    QFETCH(WarningLevel, level);
    const QString name = QTest::currentDataTag();
    switch (level) {
      case WarningLevel::Clear:
        return compareBar(measuredAt(3.7), name);
      case WarningLevel::Caution:
        return compareBar(measuredAt(1.5), name);
      case WarningLevel::Warning:
        return compareBar(measuredAt(0.7), name);
      case WarningLevel::Collision:
        return compareBar(measuredAt(0.0), name);
      case WarningLevel::NoDistance:
        return compareBar(unknownBecause(Reason::NoLoad), name);
    }
  }

  void theBarWithoutANumber() {
    compareBar(nothingInRange(), QStringLiteral("nothing_in_range"));
    compareBar(nullptr, QStringLiteral("nothing_open"));
  }

  void theBarOnPaper() {
    QApplication::setPalette(paletteOf(ThemeKind::Light));
    compareBar(measuredAt(0.7), QStringLiteral("warning_light"));
    QApplication::setPalette(paletteOf(ThemeKind::Dark));
  }

  void theMaps_data() {
    QTest::addColumn<MapKind>("kind");
    QTest::newRow("environment") << MapKind::Environment;
    QTest::newRow("probability") << MapKind::Probability;
  }
  void theMaps() {
    QFETCH(MapKind, kind);
    MapView map(kind);
    const QString name = QStringLiteral("map_") + QTest::currentDataTag();
    compare(map, map.sizeHint(), name + "_empty");
    map.setDisplay(makeDisplay(mapResult(), {}));
    compare(map, map.sizeHint(), name);
  }

  void thePlot() {
    DistancePlot plot;
    compare(plot, plot.sizeHint(), QStringLiteral("plot_empty"));
    playInto(plot);
    compare(plot, plot.sizeHint(), QStringLiteral("plot"));
  }

  void theCameraView() {
    auto result = testing::makeResult();
    result->image = cv::Mat(288, 384, CV_8UC3, cv::Scalar(90, 110, 120));
    CameraView view;
    view.setDisplay(makeDisplay(result, {}));
    compare(view, {384, 288}, QStringLiteral("camera"));
  }

  // The comparison itself: a bar that shows 0.2 m less than it should does not pass.
  void aBarThatShowsTooLittleIsNoticed() {
    const auto pictureAt = [](double metres) {
      DistanceBar bar;
      bar.setDisplay(makeDisplay(measuredAt(metres), {}));
      bar.resize(bar.sizeHint());
      return bar.grab().toImage().convertToFormat(QImage::Format_RGB32);
    };
    const QImage right = pictureAt(0.7);
    QCOMPARE(differentPixels(right, pictureAt(0.7)), 0);
    QVERIFY(differentPixels(right, pictureAt(0.9)) > allowedPixels(right));
  }
};

BOOMWATCH_TEST(TestBaselines)
#include "test_baselines.moc"
