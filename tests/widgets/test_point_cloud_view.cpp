#include <QLabel>
#include <QtTest>

#include "point_cloud_view.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"

using namespace boomwatch;

/// On a platform without OpenGL; test_point_cloud_view_gl is its other half.
class TestPointCloudView : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    if (QGuiApplication::platformName() != QLatin1String("offscreen")) QSKIP("not offscreen");
  }
  void withoutOpenGlASentenceSaysWhy();
  void withoutOpenGlEveryCallIsHarmless();
};

void TestPointCloudView::withoutOpenGlASentenceSaysWhy() {
  PointCloudView view;
  QVERIFY(!view.has3d());
  QVERIFY(view.whyNo3d().contains("offscreen"));
  const auto* label = view.findChild<QLabel*>();
  QVERIFY(label);
  QCOMPARE(label->text(), view.whyNo3d());
  view.resize(500, 300);
  view.show();
  QVERIFY(label->isVisible());
}

void TestPointCloudView::withoutOpenGlEveryCallIsHarmless() {
  PointCloudView view;
  view.setDisplay(makeDisplay(testing::makeResult(), {}));
  view.setDisplay(nullptr);
  view.resetView();
  QVERIFY(view.image().isNull());
}

BOOMWATCH_TEST(TestPointCloudView)
#include "test_point_cloud_view.moc"
