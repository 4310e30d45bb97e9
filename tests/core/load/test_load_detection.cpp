#include <QtTest>

#include "load/load_detection.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestLoadDetection : public QObject {
  Q_OBJECT
 private slots:
  /// Files and logs hold these names: they never change.
  void faultsHaveStableNames() {
    QCOMPARE(toString(LoadFault::None), std::string_view());
    QCOMPARE(toString(LoadFault::NoToolPoint), std::string_view("no_tool_point"));
    QCOMPARE(toString(LoadFault::NothingAtTool), std::string_view("nothing_at_tool"));
    QCOMPARE(toString(LoadFault::OnSurface), std::string_view("on_surface"));
    QCOMPARE(toString(LoadFault::NoBody), std::string_view("no_body"));
    QCOMPARE(toString(LoadFault::EndOn), std::string_view("end_on"));
    QCOMPARE(toString(LoadFault::EndHidden), std::string_view("end_hidden"));
    QCOMPARE(toString(LoadFault::DepthHidden), std::string_view("depth_hidden"));
    QCOMPARE(toString(LoadFault::FewPoints), std::string_view("few_points"));
    QCOMPARE(toString(LoadFault::PoorFit), std::string_view("poor_fit"));
    QCOMPARE(toString(LoadFault::TooLarge), std::string_view("too_large"));
    QCOMPARE(toString(LoadFault::OutsideBounds), std::string_view("outside_bounds"));
  }

  void aRefusalHasAReasonAndNoBox() {
    const LoadDetection detection = LoadDetection::refused(LoadFault::EndOn);
    QVERIFY(!detection.box && detection.fault == LoadFault::EndOn && !detection.isWhole);
    QVERIFY(LoadDetection().fault == LoadFault::NoToolPoint);
  }
};

BOOMWATCH_TEST(TestLoadDetection)
#include "test_load_detection.moc"
