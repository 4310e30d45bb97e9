#include <QPainter>
#include <QtTest>

#include "chart.h"
#include "chart_scale.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr QSize size(640, 400);

Figure with(std::vector<Series> series) {
  Figure figure;
  figure.title = "Something against time";
  figure.x = {"time (s)", false, 0.0, 10.0};
  figure.y = {"distance (m)", false, 0.0, 4.0};
  figure.series = std::move(series);
  return figure;
}

Series level(double y, Series::Kind kind = Series::Kind::Line) {
  Series series{"level", {}, kind};
  for (int k = 0; k <= 10; ++k) series.samples.push_back({static_cast<double>(k), y});
  return series;
}

QImage drawn(const Figure& figure) {
  QImage image(size, QImage::Format_RGB32);
  QPainter painter(&image);
  drawChart(painter, QRectF(image.rect()), figure, ChartColours::print());
  return image;
}

/// The smallest rectangle around everything in which two pictures differ.
QRect changed(const QImage& one, const QImage& other) {
  QRect all;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x) {
      if (one.pixel(x, y) != other.pixel(x, y)) all |= QRect(x, y, 1, 1);
    }
  }
  return all;
}

QRectF plotOf(const Figure& figure) {
  const QImage image(size, QImage::Format_RGB32);
  QPainter painter(const_cast<QImage*>(&image));
  return chartPlot(painter.font(), QRectF(image.rect()), figure);
}

bool isDark(const QImage& image, const QPointF& p) {
  for (int dy = -1; dy <= 1; ++dy) {
    if (qGray(image.pixel(p.toPoint() + QPoint(0, dy))) < 100) return true;
  }
  return false;
}

int tickCount(const std::vector<ChartScale::Tick>& ticks) {
  return static_cast<int>(
      std::ranges::count_if(ticks, [](const auto& tick) { return !tick.text.isEmpty(); }));
}

}  // namespace

class TestChart : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void aLineIsWhereItsNumbersAre() {
    const Figure figure = with({level(1.0)});
    const QRectF plot = plotOf(figure);
    const QImage image = drawn(figure);
    for (const double share : {0.13, 0.47, 0.86}) {
      const double x = plot.left() + share * plot.width();
      QVERIFY(isDark(image, {x, plot.bottom() - plot.height() / 4}));
      QVERIFY(!isDark(image, {x, plot.bottom() - plot.height() * 0.4}));
    }
  }

  void whatIsNotKnownIsNotDrawn() {
    Series series = level(1.0);
    for (std::size_t k = 4; k <= 6; ++k) series.samples[k].y.reset();
    const Figure figure = with({series});
    const QRectF plot = plotOf(figure);
    const QImage image = drawn(figure);
    const double y = plot.bottom() - plot.height() / 4;
    QVERIFY(isDark(image, {plot.left() + 0.27 * plot.width(), y}));
    QVERIFY(!isDark(image, {plot.left() + 0.53 * plot.width(), y}));
    QVERIFY(isDark(image, {plot.left() + 0.73 * plot.width(), y}));
  }

  void aGapIsHatchedAndNamed() {
    Figure figure = with({level(1.0)});
    const QImage before = drawn(figure);
    figure.gaps = {{3.0, 7.0, ""}};
    const QImage hatched = drawn(figure);
    figure.gaps[0].name = "No load";
    const QImage named = drawn(figure);
    const QRectF plot = plotOf(figure);
    // The name is drawn, in the gap and nowhere else.
    const QRect name = changed(hatched, named);
    QVERIFY(name.width() > 20 && name.height() > 6);
    QVERIFY(name.left() >= plot.left() + 0.3 * plot.width());
    QVERIFY(name.right() <= plot.left() + 0.7 * plot.width());
    int light = 0, dark = 0, darkBefore = 0;
    for (int x = 0; x < 60; ++x) {
      const QPoint p(static_cast<int>(plot.left() + 0.4 * plot.width()) + x,
                     static_cast<int>(plot.top() + 12));
      (qGray(hatched.pixel(p)) > 230 ? light : dark) += 1;
      darkBefore += qGray(before.pixel(p)) > 230 ? 0 : 1;
    }
    QVERIFY2(darkBefore <= 2, "more than a line of the grid");
    QVERIFY(light > 10 && dark > 10);
  }

  // Printed without colours or seen without telling them apart.
  void everyLineIsToldApartWithoutColour() {
    QList<QImage> pictures;
    for (int style = 0; style < chartStyles; ++style) {
      std::vector<Series> series(static_cast<std::size_t>(style), Series{"empty", {}});
      series.push_back(level(1.3));
      Figure figure = with(series);
      const QRectF plot = plotOf(figure);
      const QRect strip(static_cast<int>(plot.left()) + 5,
                        static_cast<int>(plot.bottom() - plot.height() * 1.3 / 4) - 4, 400, 9);
      const QImage mono = drawn(figure).copy(strip).convertToFormat(
          QImage::Format_Mono, Qt::ThresholdDither | Qt::AvoidDither);
      QVERIFY2(!pictures.contains(mono), qPrintable(QString::number(style)));
      pictures << mono;
    }
  }

  void theWorstZoneIsTheDarkest() {
    Figure figure = with({});
    figure.zones = {{1.0, 2.0, ""}, {0.0, 1.0, ""}};
    const QRectF plot = plotOf(figure);
    const QImage image = drawn(figure);
    const auto grey = [&](double metres) {
      return qGray(image.pixel(static_cast<int>(plot.left() + plot.width() * 0.053),
                               static_cast<int>(plot.bottom() - plot.height() * metres / 4.0)));
    };
    QVERIFY(grey(0.7) < grey(1.7) - 10);
    QVERIFY(grey(1.7) < grey(3.2) - 10);
  }

  void decadesAreEvenlySpaced() {
    const ChartScale scale({"", true, 0.01, 100.0}, 0, 0);
    QCOMPARE(scale.shareOf(0.01), 0.0);
    QCOMPARE(scale.shareOf(0.1), 0.25);
    QCOMPARE(scale.shareOf(1.0), 0.5);
    QCOMPARE(scale.shareOf(100.0), 1.0);
    QStringList named;
    for (const auto& tick : scale.ticks()) {
      if (!tick.text.isEmpty()) named << tick.text;
    }
    QCOMPARE(named, (QStringList{"0.01", "0.1", "1", "10", "100"}));
    QVERIFY(scale.ticks().size() > 30);
  }

  void ticksAreRoundAndFew_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::newRow("a metre") << 0.0 << 1.0;
    QTest::newRow("negative") << -60.0 << 0.0;
    QTest::newRow("small") << 0.00012 << 0.00031;
    QTest::newRow("large") << 0.0 << 54321.0;
    QTest::newRow("nothing") << 3.0 << 3.0;
  }
  void ticksAreRoundAndFew() {
    QFETCH(double, low);
    QFETCH(double, high);
    const ChartScale scale({"", false, {}, {}}, low, high);
    QVERIFY(scale.low() <= low && scale.high() >= high && scale.low() < scale.high());
    const auto ticks = scale.ticks();
    QVERIFY2(tickCount(ticks) >= 3 && tickCount(ticks) <= 10,
             qPrintable(QString::number(tickCount(ticks))));
    for (const auto& tick : ticks) {
      BW_COMPARE_NEAR(tick.text.toDouble(), tick.value, 1e-9 * std::max(1.0, scale.high()));
      QVERIFY(scale.shareOf(tick.value) > -1e-6 && scale.shareOf(tick.value) < 1 + 1e-6);
    }
  }

  void anythingCanBeDrawn() {
    const double nan = std::nan(""), inf = HUGE_VAL;
    Figure figure = with(
        {Series{"odd", {{0, nan}, {1, inf}, {2, -inf}, {3, 1e300}, {4, {}}}}, Series{"empty", {}}});
    QVERIFY(!drawn(figure).isNull());
    figure.x = figure.y = {};
    QVERIFY(!drawn(figure).isNull());
    figure.y.logarithmic = figure.x.logarithmic = true;
    QVERIFY(!drawn(figure).isNull());
    QImage tiny(5, 5, QImage::Format_RGB32);
    QPainter painter(&tiny);
    drawChart(painter, QRectF(tiny.rect()), figure, ChartColours::print());
  }

  void aFileHasNoColour() {
    Figure figure = with({level(1.0), level(2.0, Series::Kind::Marked)});
    figure.zones = {{0.0, 1.5, "warning"}};
    // Words are smoothed with colours on some screens; the lines are not.
    const QImage image = chartImage(figure, size);
    const QRectF plot = plotOf(figure).adjusted(40, 40, -100, -40);
    for (int y = static_cast<int>(plot.top()); y < plot.bottom(); ++y) {
      for (int x = static_cast<int>(plot.left()); x < plot.right(); ++x) {
        const QRgb pixel = image.pixel(x, y);
        QVERIFY(qRed(pixel) == qGreen(pixel) && qGreen(pixel) == qBlue(pixel));
      }
    }
  }
};

BOOMWATCH_TEST(TestChart)
#include "test_chart.moc"
