// Every connection of the window, in one place.
#include <QApplication>

#include "help_dialog.h"
#include "main_window.h"
#include "source_dialog.h"
#include "worker.h"

namespace boomwatch {

void MainWindow::wire() {
  wirePlayer();
  wireMenus();
  wirePanes();
  wireTracking();
  connect(&m_watch, &QTimer::timeout, this, &MainWindow::watch);
  m_watch.start(std::chrono::milliseconds(200));
  if (m_worker) connect(m_worker, &Worker::newsWaiting, this, &MainWindow::takeNews);
  qApp->installEventFilter(this);
}

void MainWindow::wirePlayer() {
  const PlayerBar* player = m_panes.player;
  connect(player, &PlayerBar::playRequested, this, [this] { send(PlayCommand{}); });
  connect(player, &PlayerBar::pauseRequested, this, [this] { send(PauseCommand{}); });
  connect(player, &PlayerBar::stepRequested, this,
          [this](int direction) { send(StepCommand{direction}); });
  connect(player, &PlayerBar::seekRequested, this,
          [this](std::size_t index) { send(SeekCommand{index}); });
  connect(player, &PlayerBar::seekRequested, m_panes.history, &DistancePlot::clear);
  connect(player, &PlayerBar::loopChanged, this, [this](bool loop) { send(LoopCommand{loop}); });
  connect(player, &PlayerBar::speedChanged, this,
          [this](double speed) { send(SpeedCommand{speed}); });
}

void MainWindow::wireMenus() {
  connect(m_menus.kinds, &QActionGroup::triggered, this, [this](const QAction* action) {
    askForSource(static_cast<SourceKind>(action->data().toInt()));
  });
  connect(m_menus.demos, &QActionGroup::triggered, this,
          [this](const QAction* action) { openSource(action->data().toString()); });
  connect(m_menus.quit, &QAction::triggered, this, &QWidget::close);
  connect(m_menus.cloudColours, &QActionGroup::triggered, this, &MainWindow::applyColours);
  connect(m_menus.mapColours, &QActionGroup::triggered, this, &MainWindow::applyColours);
  connect(m_menus.lightTheme, &QAction::toggled, this, &MainWindow::chooseTheme);
  connect(m_menus.resetView, &QAction::triggered, m_panes.cloud, &PointCloudView::resetView);
  connect(m_menus.fitMaps, &QAction::triggered, m_panes.probability, &MapView::fit);
  connect(m_menus.fitMaps, &QAction::triggered, m_panes.environment, &MapView::fit);
  connect(m_menus.resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
  connect(m_menus.snapshot, &QAction::triggered, this, &MainWindow::askForSnapshot);
  connect(m_menus.help, &QAction::triggered, this, [this] { HelpDialog(this).exec(); });
}

void MainWindow::wirePanes() {
  connect(m_panes.parameters, &ParameterDock::parametersChanged, this, &MainWindow::setParameters);
  connect(m_panes.camera, &CameraView::toolPicked, this, [this](QPoint pixel) {
    orderTool(PickTool{{pixel.x(), pixel.y()}});
  });
  connect(m_panes.camera, &CameraView::toolCleared, this, [this] { orderTool(ForgetTool{}); });
}

void MainWindow::wireTracking() {
  const TrackingDock* dock = m_panes.tracking;
  const auto change = [this](auto field, auto value) {
    Parameters parameters = m_panes.parameters->parameters();
    parameters.tracking.*field = value;
    m_panes.parameters->changeParameters(parameters);
  };
  const auto load = [this](const QStringList& files, bool withCurrent) {
    LoadToolModelCommand command;
    for (const QString& file : files) command.files.push_back(file.toStdString());
    command.withCurrent = withCurrent;
    send(command);
  };
  connect(dock, &TrackingDock::trackerChosen, this,
          [=](TrackerKind kind) { change(&TrackingParameters::tracker, kind); });
  connect(dock, &TrackingDock::learningChosen, this,
          [=](bool on) { change(&TrackingParameters::learn, on); });
  connect(dock, &TrackingDock::boxWanted, m_panes.camera, &CameraView::beginBox);
  connect(dock, &TrackingDock::beginAgainWanted, this, [this] { orderTool(TrackAgain{}); });
  connect(dock, &TrackingDock::forgetWanted, this, [this] { orderTool(ForgetTool{}); });
  connect(dock, &TrackingDock::loadWanted, this, [=](const auto& files) { load(files, false); });
  connect(dock, &TrackingDock::mergeWanted, this, [=](const auto& files) { load(files, true); });
  connect(dock, &TrackingDock::saveWanted, this,
          [this](const QString& file) { send(SaveToolModelCommand{file.toStdString()}); });
  connect(m_panes.camera, &CameraView::boxDrawn, this, [this](const QRect& box) {
    orderTool(TrackBox{cv::Rect2d(box.x(), box.y(), box.width(), box.height())});
  });
}

}  // namespace boomwatch
