#include "main_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QtTest>
#include <future>

#include "console.h"
#include "parameter_row.h"
#include "pipeline/pipeline.h"
#include "source_guess.h"
#include "state_text.h"
#include "support/fake_source.h"
#include "support/test_registry.h"
#include "worker.h"

using namespace boomwatch;

class TestMainWindow : public QObject {
  Q_OBJECT

 private:
  static Parameters small() {
    Parameters parameters;
    parameters.bounds = {-2, 2, -2, 2, 0, 5};
    return parameters;
  }
  /// Eight frames of the recording, as fast as they come.
  static bool playsEight(Worker& worker, MainWindow& window) {
    QSignalSpy finished(&window, &MainWindow::finished);
    worker.command(SpeedCommand{Player::unlimited});
    worker.command(StopAfterCommand{8});
    window.openSource("fake");
    return QTest::qWaitFor([&] { return finished.count() == 1; });
  }
  static SourceOpener opening(const test::Script& script) {
    return [script](const std::string&, const SourceOptions&) {
      return std::make_unique<test::FakeSource>(script);
    };
  }
  std::unique_ptr<QSettings> settings() const {
    return std::make_unique<QSettings>(m_folder.filePath("settings.ini"), QSettings::IniFormat);
  }
  static DisplayPtr display(WarningLevel level) {
    auto result = std::make_shared<Result>(noFrameResult(Reason::NoFrame, small()));
    result->level = level;
    return makeDisplay(result, {});
  }

  QTemporaryDir m_folder;

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void init() { QFile::remove(m_folder.filePath("settings.ini")); }

  void theDistanceIsAlwaysThere() {
    MainWindow window(small(), nullptr);
    window.show();
    QVERIFY(window.panes().bar->isVisible());
    for (QDockWidget* dock : window.panes().docks) dock->close();
    QVERIFY(window.panes().bar->isVisible());
    QVERIFY(!window.panes().camera->isVisible());
    window.menus().resetLayout->trigger();
    for (QDockWidget* dock : window.panes().docks) QVERIFY(dock->isVisible());
  }

  void everyPaneKeepsAPlaceInASmallWindow() {
    MainWindow window(small(), nullptr);
    window.show();
    window.resize(900, 600);
    QCoreApplication::processEvents();
    const Panes& panes = window.panes();
    for (const QWidget* pane : std::initializer_list<const QWidget*>{
             panes.cloud, panes.camera, panes.probability, panes.environment, panes.history}) {
      QVERIFY(pane->height() >= 100 && pane->width() >= 160);
    }
    QVERIFY2(window.height() <= 600, "taller than was asked for");
  }

  void layoutThemeAndSourceAreRemembered() {
    {
      Worker worker(small(), opening({}));
      MainWindow window(small(), &worker, settings());
      window.show();
      window.openSource("fake:one", {"rig.yaml"});
      QTRY_COMPARE(window.status().address, QStringLiteral("fake:one"));
      window.panes().docks[1]->hide();
      window.menus().lightTheme->setChecked(true);
      window.menus().mapColours->actions()[1]->trigger();
      window.close();
    }
    MainWindow window(small(), nullptr, settings());
    window.show();
    QVERIFY(!window.panes().docks[1]->isVisible());
    QVERIFY(window.panes().docks[0]->isVisible());
    QVERIFY(window.panes().bar->isVisible());
    QVERIFY(window.menus().lightTheme->isChecked());
    QVERIFY(window.menus().mapColours->actions()[1]->isChecked());
    QCOMPARE(window.lastSource().address, std::string("fake:one"));
    QCOMPARE(window.lastSource().options.calibration, std::string("rig.yaml"));
  }

  void showsWhatTheWorkerPublishesAndSaysWhatItIs() {
    Worker worker(small(), opening({}));
    MainWindow window(small(), &worker);
    QVERIFY(playsEight(worker, window));
    QTRY_COMPARE(window.panes().barCaption->text(), QStringLiteral("PAUSED"));
    QCOMPARE(window.panes().player->positionText(), QStringLiteral("8 / 10"));
    // The wall is at 3 m, the load's back at 1.7 m.
    QVERIFY(window.panes().bar->fill().has_value());
    QVERIFY2(window.panes().bar->numberText().startsWith("1.3"),
             qPrintable(window.panes().bar->numberText()));
    QVERIFY(window.panes().status->validityText().contains("valid"));
    worker.command(PlayCommand{});
    QTRY_COMPARE(window.panes().barCaption->text(), QStringLiteral("END"));
    QVERIFY(window.panes().state->text().contains("not live"));
  }

  void anotherSourceAndAnotherPlaceClearTheHistory() {
    Worker worker(small(), opening({}));
    MainWindow window(small(), &worker);
    QVERIFY(playsEight(worker, window));
    const auto& moments = window.panes().history->history().moments();
    QTRY_VERIFY(!moments.empty());
    emit window.panes().player->seekRequested(2);
    QVERIFY(moments.empty());
    QTRY_COMPARE(moments.size(), std::size_t{1});
    window.openSource("fake:other");
    QTRY_COMPARE(window.status().address, QStringLiteral("fake:other"));
    QTRY_VERIFY(!moments.empty());
    QVERIFY(moments.front().stamp <= 0.5);
  }

  void aFaultStaysInSightUntilItIsDismissed() {
    Worker worker(small(),
                  [](const std::string&, const SourceOptions&) -> std::unique_ptr<FrameSource> {
                    throw std::runtime_error("the folder is empty");
                  });
    MainWindow window(small(), &worker);
    QSignalSpy faults(&window, &MainWindow::faultShown);
    window.openSource("fake");
    QTRY_COMPARE(faults.count(), 1);
    QVERIFY(window.panes().state->text().contains("the folder is empty"));
    QCOMPARE(faults[0][0].toString(), QStringLiteral("Not opened: the folder is empty"));
    window.panes().state->dismiss();
    QVERIFY(window.panes().state->text().contains("No source is open"));
  }

  void aChangedParameterReachesTheNextFrameAndTheRebuildIsSaid() {
    test::Script script;
    script.info.frameCount = 1000000;
    Worker worker(small(), opening(script));
    MainWindow window(small(), &worker);
    window.openSource("fake");
    QTRY_VERIFY(window.panes().bar->fill().has_value());
    worker.command(PauseCommand{});
    QTRY_COMPARE(window.panes().barCaption->text(), QStringLiteral("PAUSED"));
    Parameters other = small();
    other.model.resolution = 0.1;
    emit window.panes().parameters->parametersChanged(other);
    QVERIFY(window.panes().state->text().contains("rebuilt with the next frame"));
    worker.command(PlayCommand{});
    QTRY_COMPARE(window.panes().state->text(), QStringLiteral("Rebuilding the model..."));
    QTRY_VERIFY(window.panes().state->text().startsWith("Recording"));
  }

  void aLiveSourceWhoseWorkerHangsLosesItsDistance() {
    Parameters parameters = small();
    parameters.validity.maxFrameAge = 0.1;
    auto gate = std::make_shared<std::promise<void>>();
    const auto open = gate->get_future().share();
    test::Script script;
    script.info.live = true;
    script.info.frameCount.reset();
    script.read = [open](std::size_t i) -> ReadResult {
      if (i == 8) open.wait();
      return {ReadResult::Status::Ok, test::wallFrame(i, 0.1 * static_cast<double>(i)), {}, 0};
    };
    Worker worker(parameters, opening(script));
    // Also when a check fails: the worker's destructor waits for its thread.
    auto release = qScopeGuard([gate] { gate->set_value(); });
    MainWindow window(parameters, &worker);
    window.openSource("fake");
    QTRY_VERIFY(window.panes().status->validityText().contains("no distance: No frames arrive"));
    QVERIFY(!window.panes().bar->fill().has_value());
    release.dismiss();
    gate->set_value();
    QTRY_VERIFY(window.panes().bar->fill().has_value());
  }

  void spaceInACheckBoxDoesNotPlay() {
    test::Script script;
    Worker worker(small(), opening(script));
    MainWindow window(small(), &worker);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QSignalSpy plays(window.panes().player, &PlayerBar::playRequested);
    QSignalSpy changes(window.panes().parameters, &ParameterDock::parametersChanged);
    PlayerStatus paused;
    paused.position = 3;
    paused.count = 5;
    window.showStatus({"fake", {}, paused});
    auto* box = window.panes().parameters->row("low_pass")->findChild<QWidget*>("low_pass");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(plays.count(), 0);
    window.panes().camera->setFocus();
    QTest::keyClick(window.panes().camera, Qt::Key_Space);
    QCOMPARE(plays.count(), 1);
  }

  void droppingSomethingElseIsSaid() {
    MainWindow window(small(), nullptr);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(m_folder.path())});
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    QVERIFY(window.panes().state->text().contains(m_folder.path()));
  }

  void whatIsDroppedIsGuessedByWhatIsInIt_data() {
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<QString>("kind");
    QTest::newRow("clouds") << QStringList{"a.pcd", "notes.txt"} << "cloud:";
    QTest::newRow("PLY") << QStringList{"b.PLY"} << "cloud:";
    QTest::newRow("videos") << QStringList{"left.mp4", "right.mp4", "README.md"} << "stereo:";
    QTest::newRow("KITTI") << QStringList{"image_0/", "image_1/", "calib.txt"} << "stereo:";
    QTest::newRow("KITTI raw") << QStringList{"image_00/", "image_01/"} << "stereo:";
    QTest::newRow("image_left") << QStringList{"image_left/", "image_right/"} << "stereo:";
    QTest::newRow("KITTI colour") << QStringList{"image_2/", "image_3/"} << "stereo:";
    QTest::newRow("EuRoC") << QStringList{"cam0/", "cam1/"} << "stereo:";
    QTest::newRow("Middlebury") << QStringList{"im0.png", "im1.png", "calib.txt"} << "stereo:";
    QTest::newRow("chessboards") << QStringList{"left01.jpg", "right01.jpg"} << "stereo:";
    QTest::newRow("aloe") << QStringList{"aloeL.jpg", "aloeR.jpg"} << "stereo:";
    QTest::newRow("TUM") << QStringList{"rgb.txt", "depth.txt", "rgb/", "depth/"} << "depth:";
    QTest::newRow("Kinect") << QStringList{"000.jpg", "000_depth.png"} << "depth:";
    QTest::newRow("ROS 2") << QStringList{"run_0.db3", "metadata.yaml"} << "bag:";
    QTest::newRow("view") << QStringList{"view1.png", "view5.png"} << "stereo:";
    QTest::newRow("calibrations") << QStringList{"left.yml", "right.yml"} << "";
    QTest::newRow("one side alone") << QStringList{"left.mp4"} << "";
    QTest::newRow("texts") << QStringList{"letter.txt"} << "";
    QTest::newRow("nothing") << QStringList{} << "";
  }
  void whatIsDroppedIsGuessedByWhatIsInIt() {
    QFETCH(QStringList, names);
    QFETCH(QString, kind);
    const QTemporaryDir folder;
    for (const QString& name : names) {
      if (name.endsWith('/')) {
        QDir(folder.path()).mkdir(name.chopped(1));
      } else {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
      }
    }
    const auto address = guessAddress(folder.path());
    QCOMPARE(address.value_or(QString()), kind.isEmpty() ? QString() : kind + folder.path());
  }

  void aCloudFileIsOpenedAloneAndAPictureStandsForItsFolder() {
    const QTemporaryDir folder;
    for (const char* name : {"left.png", "right.png", "a.pcd"}) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
    }
    QCOMPARE(*guessAddress(folder.filePath("a.pcd")), "cloud:" + folder.filePath("a.pcd"));
    QFile bag(folder.filePath("b.mcap"));
    QVERIFY(bag.open(QIODevice::WriteOnly));
    QCOMPARE(*guessAddress(bag.fileName()), "bag:" + bag.fileName());
    QCOMPARE(*guessAddress(folder.filePath("left.png")), "stereo:" + folder.path());
    QVERIFY(!guessAddress(folder.filePath("missing")));
  }

  void aSwallowedWarningIsHeldLongEnoughToBeSeen() {
    using namespace std::chrono_literals;
    const LevelHold::TimePoint start{1000s};
    LevelHold hold;
    hold.note(WarningLevel::Clear, WarningLevel::Collision, start);
    QVERIFY(hold.held(start) == WarningLevel::Collision);
    hold.note(WarningLevel::Clear, WarningLevel::Clear, start + 1s);
    QVERIFY(hold.held(start + 1s) == WarningLevel::Collision);
    QVERIFY(!hold.held(start + 3s));
    hold.note(WarningLevel::Warning, WarningLevel::Warning, start + 4s);
    QVERIFY(!hold.held(start + 4s));
  }

  void noTwoStatesOfASourceAreCaptionedAlike() {
    QStringList captions{barCaption({})};
    for (const auto state :
         {PlayState::Playing, PlayState::Paused, PlayState::Ended, PlayState::Lost}) {
      PlayerStatus player;
      player.state = state;
      captions << barCaption({"fake", {}, player});
    }
    captions << barCaption({{}, "fake", std::nullopt});
    QCOMPARE(QSet<QString>(captions.begin(), captions.end()).size(), captions.size());
  }

  void nothingMovesWhenTheNumbersChange() {
    MainWindow window(small(), nullptr);
    window.show();
    window.showDisplay(display(WarningLevel::NoDistance));
    const auto geometries = [&] {
      const Panes& p = window.panes();
      return QList<QRect>{p.bar->geometry(), p.cloud->geometry(), p.camera->geometry(),
                          p.barCaption->geometry(), p.state->geometry()};
    };
    const auto before = geometries();
    auto result = std::make_shared<Result>(noFrameResult(Reason::NothingObserved, small()));
    result->timings = {{"stereo", 12345.6}, {"model", 0.1}};
    window.panes().status->setRate(1234.5);
    window.panes().status->setLatency(98765);
    window.panes().state->showFault(QString(500, 'x'));
    window.showDisplay(makeDisplay(result, {}));
    QCoreApplication::processEvents();
    QCOMPARE(geometries(), before);
  }

  void aResultAloneCanBePictured() {
    const QString file = m_folder.filePath("window.png");
    QVERIFY(saveWindowScreenshot(display(WarningLevel::NoDistance)->result, file));
    const QImage picture(file);
    QVERIFY(picture.width() >= 1200 && picture.height() >= 700);
    QVERIFY(!saveWindowScreenshot(display(WarningLevel::NoDistance)->result,
                                  m_folder.filePath("no/such/folder.png")));
  }
};

BOOMWATCH_TEST(TestMainWindow)
#include "test_main_window.moc"
