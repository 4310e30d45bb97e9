#include <QLabel>
#include <QtTest>

#include "pipeline/pipeline.h"
#include "status_strip.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestStatusStrip : public QObject {
  Q_OBJECT

  static Result result() {
    Result made = noFrameResult(Reason::NothingObserved, {});
    made.timings = {{"stereo", 12.0}, {"filter", 9.0}, {"tool", 1.0},      {"load", 2.0},
                    {"crane", 1.0},   {"model", 3.0},  {"clearance", 0.1}, {"checks", 0.0}};
    return made;
  }
  static QList<QLabel*> shown(const StatusStrip& strip) {
    QList<QLabel*> labels;
    for (QLabel* label : strip.findChildren<QLabel*>()) {
      if (label->isVisible()) labels << label;
    }
    return labels;
  }

 private slots:
  void stagesAreShownWhereTheyHaveRoom_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<bool>("room");
    QTest::newRow("wide") << 1900 << true;
    QTest::newRow("narrow") << 800 << false;
  }
  void stagesAreShownWhereTheyHaveRoom() {
    QFETCH(int, width);
    QFETCH(bool, room);
    StatusStrip strip;
    strip.resize(width, strip.sizeHint().height());
    strip.show();
    strip.showResult(result());
    QCoreApplication::processEvents();
    const QList<QLabel*> labels = shown(strip);
    QCOMPARE(std::ranges::any_of(labels, [](QLabel* l) { return l->text().contains("crane"); }),
             room);
    for (QLabel* label : labels) {
      const QRect place(label->mapTo(&strip, QPoint()), label->size());
      QVERIFY2(strip.rect().adjusted(0, -20, 0, 20).contains(place), qPrintable(label->text()));
    }
  }

  void itDoesNotKeepTheWindowWide() {
    StatusStrip strip;
    strip.show();
    strip.showResult(result());
    QVERIFY(strip.minimumWidth() < 10);
  }

  void stagesComeBackWithTheRoom() {
    StatusStrip strip;
    strip.resize(800, strip.sizeHint().height());
    strip.show();
    strip.showResult(result());
    QCoreApplication::processEvents();
    const auto narrow = shown(strip).size();
    strip.resize(1900, strip.height());
    QCoreApplication::processEvents();
    QCOMPARE(shown(strip).size(), narrow + 8);
  }
};

BOOMWATCH_TEST(TestStatusStrip)
#include "test_status_strip.moc"
