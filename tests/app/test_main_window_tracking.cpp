#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QtTest>

#include "main_window.h"
#include "parameter_row.h"
#include "parameters/parameter_text.h"
#include "support/fake_source.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"
#include "worker.h"

using namespace boomwatch;

namespace {

Parameters following(TrackerKind kind) {
  Parameters parameters;
  parameters.bounds = {-2, 2, -2, 2, 0, 5};
  parameters.tracking.tracker = kind;
  return parameters;
}

/// A live source that always shows the same wall.
SourceOpener wallSource() {
  test::Script script;
  script.info.live = true;
  script.info.frameCount.reset();
  script.read = [](std::size_t index) {
    return ReadResult{ReadResult::Status::Ok, test::wallFrame(index, 3.0F), {}, 0};
  };
  return [script](const std::string&, const SourceOptions&) {
    return std::make_unique<test::FakeSource>(script);
  };
}

QString shownValue(const MainWindow& window, std::string_view key) {
  const ParameterInfo& info = findParameter(key);
  return QString::fromStdString(
      formatValue(info, info.get(window.panes().parameters->parameters())));
}

void click(const MainWindow& window, const QString& text) {
  for (QPushButton* button : window.panes().tracking->findChildren<QPushButton*>()) {
    if (button->text() == text) return button->click();
  }
  QFAIL(qPrintable("no button " + text));
}

}  // namespace

class TestMainWindowTracking : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void trackerAndLearningAreSaidOnce() {
    MainWindow window(following(TrackerKind::Tld), nullptr);
    auto* tracker = window.panes().tracking->findChild<QComboBox*>();
    auto* learn = window.panes().tracking->findChild<QCheckBox*>();
    learn->click();
    QCOMPARE(shownValue(window, "learn"), QStringLiteral("false"));
    QTest::keyClick(tracker, Qt::Key_Down);  // csrt
    QTest::keyClick(tracker, Qt::Key_Down);
    QCOMPARE(shownValue(window, "tracker"), QStringLiteral("manual"));
    window.panes().parameters->resetAll();
    QVERIFY(tracker->currentText().startsWith("tld"));
    QVERIFY(learn->isChecked());
  }

  void theDockIsInTheViewMenuAndCanBeHidden() {
    MainWindow window(following(TrackerKind::Tld), nullptr);
    window.show();
    QAction* action = window.panes().tracking->toggleViewAction();
    QVERIFY(window.menus().view->actions().contains(action));
    action->trigger();
    QVERIFY(!window.panes().tracking->isVisible());
    window.menus().resetLayout->trigger();
    QVERIFY(window.panes().tracking->isVisible());
  }

  void aBoxDrawnInTheCameraPictureIsFollowed() {
    Worker worker(following(TrackerKind::Klt), wallSource());
    MainWindow window(following(TrackerKind::Klt), &worker);
    window.show();
    window.openSource("fake:one");
    CameraView* camera = window.panes().camera;
    QTRY_VERIFY(!camera->pictureRect().isEmpty());
    const auto at = [&](double x, double y) {
      const QRectF area = camera->pictureRect();
      return (area.topLeft() + QPointF(x * area.width(), y * area.height())).toPoint();
    };
    QTest::mousePress(camera, Qt::LeftButton, {}, at(0.3, 0.25));
    QTest::mouseMove(camera, at(0.5, 0.5));
    QTest::mouseMove(camera, at(0.7, 0.75));
    QVERIFY(camera->draft());
    QTest::mouseRelease(camera, Qt::LeftButton, {}, at(0.7, 0.75));
    TrackingDock* dock = window.panes().tracking;
    QTRY_VERIFY2(dock->stateText().startsWith("Tool tracked"), qPrintable(dock->stateText()));
    QVERIFY(dock->learningText().contains("does not learn"));
    click(window, "Restart");
    QTRY_VERIFY(dock->stateText().startsWith("Tool tracked"));
    click(window, "Remove");
    QTRY_VERIFY(dock->stateText().startsWith("No tool"));
  }

  void aBoxIsBegunFromTheDock() {
    Worker worker(following(TrackerKind::Klt), wallSource());
    MainWindow window(following(TrackerKind::Klt), &worker);
    window.show();
    window.openSource("fake:one");
    CameraView* camera = window.panes().camera;
    QTRY_VERIFY(!camera->pictureRect().isEmpty());
    click(window, "Draw box");
    QVERIFY(camera->draft());
    QTest::keyClick(camera, Qt::Key_Return);
    QTRY_VERIFY(window.panes().tracking->stateText().startsWith("Tool tracked"));
  }

  void aModelThatIsNotThereIsSaidByName() {
    Worker worker(following(TrackerKind::Tld), wallSource());
    MainWindow window(following(TrackerKind::Tld), &worker);
    emit window.panes().tracking->loadWanted({"/there/is/no.tool"});
    QTRY_VERIFY(window.panes().state->text().contains("/there/is/no.tool"));
  }

  void whatALostToolMeansStandsInTheBar() {
    MainWindow window(following(TrackerKind::Tld), nullptr);
    auto result = std::make_shared<Result>();
    result->parameters = following(TrackerKind::Tld);
    result->frame = test::wallFrame(0, 3.0F);
    result->image = result->frame->left;
    result->clearance = Clearance::unknown(Reason::ToolLost);
    result->tool.state = TrackState::Lost;
    result->tool.age = 1.2;
    window.showDisplay(makeDisplay(result, {}));
    QVERIFY(window.panes().bar->hintText().contains("cannot be masked"));
    QVERIFY(window.panes().tracking->stateText().contains("Tool lost for 1.2 s"));
  }
};

BOOMWATCH_TEST(TestMainWindowTracking)
#include "test_main_window_tracking.moc"
