#include <QtTest>

#include "distance_plot.h"
#include "support/compare_near.h"
#include "support/test_registry.h"
#include "texts.h"

using namespace boomwatch;

namespace {

DisplayPtr at(double stamp, std::optional<double> distance, std::optional<double> truth = {},
              Reason reason = Reason::None) {
  auto result = std::make_shared<Result>();
  auto frame = std::make_shared<Frame>();
  frame->stamp = stamp;
  frame->trueDistance = truth;
  result->frame = frame;
  if (reason != Reason::None) {
    result->clearance = Clearance::unknown(reason);
  } else if (distance) {
    result->clearance.state = ClearanceState::Measured;
    result->clearance.reason = Reason::None;
    result->clearance.nearest.emplace().distance = *distance;
  } else {
    result->clearance.state = ClearanceState::NothingInRange;
    result->clearance.reason = Reason::None;
  }
  return makeDisplay(result, {});
}

void play(DistancePlot& plot, double first, double last, double distance) {
  for (double stamp = first; stamp < last; stamp += 0.05) plot.setDisplay(at(stamp, distance));
}

/// Where a moment is in the widget: the middle of its plot is half a minute ago.
QPoint middleOf(const DistancePlot& plot) { return {plot.width() / 2 + 20, plot.height() / 2}; }

}  // namespace

class TestDistancePlot : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void aMinuteIsKept() {
    DistancePlot plot;
    play(plot, 0.0, 100.0, 1.5);
    const auto& moments = plot.history().moments();
    QVERIFY(moments.front().stamp >= 39.8 && moments.front().stamp <= 40.1);
    const Figure figure = plot.figure();
    QCOMPARE(figure.series.size(), std::size_t{1});  // nobody knows the truth
    QCOMPARE(figure.series[0].samples.size(), moments.size());
    QCOMPARE(figure.series[0].samples.back().x, 0.0);
    QCOMPARE(*figure.series[0].samples.back().y, 1.5);
    QCOMPARE(*figure.x.low, -60.0);
  }

  void zonesAreThoseInForce() {
    DistancePlot plot;
    auto result = std::make_shared<Result>(*at(1.0, 0.4)->result);
    result->parameters.warning.cautionDistance = 3.0;
    result->parameters.warning.warningDistance = 1.2;
    plot.setDisplay(makeDisplay(result, {}));
    const Figure figure = plot.figure();
    QCOMPARE(figure.zones.size(), std::size_t{2});
    QCOMPARE(figure.zones[0].high, 3.0);
    QCOMPARE(figure.zones[1].high, 1.2);
    QCOMPARE(*figure.y.high, 4.5);
  }

  void theScaleHoldsEverythingAndSeldomChanges() {
    DistancePlot plot;
    plot.setDisplay(at(1.0, 2.9));
    QCOMPARE(*plot.figure().y.high, 3.0);
    plot.setDisplay(at(1.1, 0.1, 3.1));
    QCOMPARE(*plot.figure().y.high, 6.0);
  }

  void theTruthIsASeriesOfItsOwn() {
    DistancePlot plot;
    plot.setDisplay(at(1.0, 1.5, 1.4));
    plot.setDisplay(at(1.05, 1.6));
    const Figure figure = plot.figure();
    QCOMPARE(figure.series.size(), std::size_t{2});
    QCOMPARE(*figure.series[1].samples[0].y, 1.4);
    QVERIFY(!figure.series[1].samples[1].y);
  }

  void whereThereIsNoDistanceThereIsAGapWithItsReason() {
    DistancePlot plot;
    plot.resize(800, 200);
    play(plot, 0.0, 20.0, 1.5);
    for (double stamp = 20.0; stamp < 40.0; stamp += 0.05) {
      plot.setDisplay(at(stamp, {}, {}, Reason::LoadNotSeen));
    }
    for (double stamp = 40.0; stamp < 50.0; stamp += 0.05) {
      plot.setDisplay(at(stamp, {}, {}, Reason::ToolLost));
    }
    play(plot, 50.0, 60.0, 0.7);
    const Figure figure = plot.figure();
    QCOMPARE(figure.gaps.size(), std::size_t{2});
    BW_COMPARE_NEAR(figure.gaps[0].low, -40.0, 0.1);
    BW_COMPARE_NEAR(figure.gaps[0].high, -20.0, 0.1);
    BW_COMPARE_NEAR(figure.gaps[1].high, -10.0, 0.1);
    QCOMPARE(QString::fromStdString(figure.gaps[0].name), reasonTitle(Reason::LoadNotSeen));
    for (const Sample& sample : figure.series[0].samples) {
      const double stamp = sample.x + plot.history().now();
      if (std::abs(stamp - 20.0) < 0.03 || std::abs(stamp - 50.0) < 0.03) continue;
      QCOMPARE(sample.y.has_value(), stamp < 20.0 || stamp > 50.0);
    }
    QVERIFY(plot.textAt(middleOf(plot)).contains(reasonText(Reason::LoadNotSeen)));
    QVERIFY(plot.textAt({plot.width() - 30, plot.height() / 2}).contains("0.70 m"));
    QVERIFY(plot.textAt({2, 2}).isEmpty());
  }

  void nothingInRangeIsNoGapAndNoNumber() {
    DistancePlot plot;
    plot.resize(800, 200);
    for (double stamp = 0.0; stamp < 60.0; stamp += 0.05) plot.setDisplay(at(stamp, {}));
    QVERIFY(plot.figure().gaps.empty());
    QVERIFY(!plot.figure().series[0].samples[0].y);
    QVERIFY(plot.textAt(middleOf(plot)).contains("no obstacle in range"));
  }

  void windingTheSourceBeginsAnew() {
    DistancePlot plot;
    play(plot, 0.0, 10.0, 1.5);
    plot.setDisplay(at(3.0, 1.0));  // back
    QCOMPARE(plot.history().moments().size(), std::size_t{1});
    play(plot, 3.05, 5.0, 1.0);
    plot.setDisplay(at(20.0, 1.0));  // ahead
    QCOMPARE(plot.history().moments().size(), std::size_t{1});
    plot.setDisplay(at(22.0, 1.0));  // slow, or frames were skipped
    QCOMPARE(plot.history().moments().size(), std::size_t{2});
    plot.clear();
    QVERIFY(plot.history().moments().empty());
  }

  void theSameFrameAgainIsNoSecondMoment() {
    DistancePlot plot;
    play(plot, 0.0, 1.0, 1.5);
    const auto before = plot.history().moments().size();
    plot.setDisplay(at(plot.history().now(), 1.5));
    QCOMPARE(plot.history().moments().size(), before);
  }

  void silenceIsAGapUpToTheNextFrame() {
    DistanceHistory history;
    const auto none = noFrame();
    history.add(none, 3.0);
    QVERIFY(history.moments().empty());
    history.add(*at(10.0, 1.5)->result);
    history.add(none, 1.5);
    QCOMPARE(history.now(), 11.5);
    QVERIFY(history.moments().back().reason == Reason::NoFrame);
    // Played slowly, the next frame may be nearer than the clock on the wall says.
    history.add(*at(10.05, 1.4)->result);
    QCOMPARE(history.now(), 10.05);
    QCOMPARE(history.moments().size(), std::size_t{2});
  }

  void unknownAndKnownLookDifferentWithoutColour() {
    DistancePlot known, unknown;
    for (DistancePlot* plot : {&known, &unknown}) plot->resize(600, 180);
    play(known, 0.0, 60.0, 1.5);
    for (double stamp = 0.0; stamp < 60.0; stamp += 0.05) {
      unknown.setDisplay(at(stamp, {}, {}, Reason::NoLoad));
    }
    // Along a row: stripes where nothing is known, only lines of the grid where a distance is.
    const auto stripes = [](DistancePlot& plot) {
      const QImage image = plot.grab().toImage();
      const QPoint middle = middleOf(plot);
      int changes = 0;
      for (int x = middle.x() - 100; x < middle.x() + 100; ++x) {
        const int step = qGray(image.pixel(x, 40)) - qGray(image.pixel(x + 1, 40));
        changes += std::abs(step) > 10 ? 1 : 0;
      }
      return changes;
    };
    QVERIFY2(stripes(known) < 10, qPrintable(QString::number(stripes(known))));
    QVERIFY2(stripes(unknown) > 20, qPrintable(QString::number(stripes(unknown))));
  }

 private:
  static Result noFrame() {
    Result result;
    result.clearance = Clearance::unknown(Reason::NoFrame);
    return result;
  }
};

BOOMWATCH_TEST(TestDistancePlot)
#include "test_distance_plot.moc"
