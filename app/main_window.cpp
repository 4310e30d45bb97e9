#include "main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPixmap>
#include <QStandardPaths>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>

#include "pipeline/pipeline.h"
#include "save_name.h"
#include "source_dialog.h"
#include "source_guess.h"
#include "state_text.h"
#include "theme.h"
#include "worker.h"

namespace boomwatch {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int layoutVersion = 1;
constexpr QSize firstSize(1600, 1000);

void addMenuButton(QToolBar* bar, QMenu* menu) {
  auto* button = new QToolButton;
  button->setText(menu->title());
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setFocusPolicy(Qt::TabFocus);
  bar->addWidget(button);
}

QToolBar* addBar(QMainWindow* window, const char* name, const QString& title) {
  QToolBar* bar = window->addToolBar(title);
  bar->setObjectName(QLatin1String(name));
  bar->setMovable(false);
  bar->toggleViewAction()->setEnabled(false);
  return bar;
}

void check(QActionGroup* group, int value) {
  for (QAction* action : group->actions()) {
    if (action->data().toInt() == value) action->setChecked(true);
  }
}

}  // namespace

MainWindow::MainWindow(const Parameters& parameters, Worker* worker,
                       std::unique_ptr<QSettings> settings)
    : m_worker(worker),
      m_settings(std::move(settings)),
      m_panes(Panes::make(this)),
      m_menus(WindowMenus::make(this, m_panes.docks)) {
  setWindowTitle(tr("Boomwatch"));
  setAcceptDrops(true);
  // The menu that Qt offers here could hide the bar; View has everything that may be hidden.
  setContextMenuPolicy(Qt::NoContextMenu);
  makeToolBars();
  resize(firstSize);
  m_panes.arrange(this);
  m_panes.parameters->setParameters(parameters);
  m_panes.tracking->setParameters(parameters);
  m_rebuild.want(parameters);
  wire();
  restore();
  applyColours();
  refreshState();
}

MainWindow::~MainWindow() { qApp->removeEventFilter(this); }

void MainWindow::makeToolBars() {
  QToolBar* controls = addBar(this, "controls", tr("Controls"));
  addMenuButton(controls, m_menus.source);
  controls->addSeparator();
  controls->addWidget(m_panes.player);
  controls->addSeparator();
  m_menus.snapshot->setIcon(QIcon(QStringLiteral(":/icons/snapshot.svg")));
  controls->addAction(m_menus.snapshot);
  addMenuButton(controls, m_menus.view);
  controls->addAction(m_menus.help);
  addToolBarBreak();
  addBar(this, "state", tr("State"))->addWidget(m_panes.state);
}

void MainWindow::send(const Command& command) {
  if (m_worker) m_worker->command(command);
}

void MainWindow::openSource(const QString& address, const SourceOptions& options) {
  m_calibrations[address] = QString::fromStdString(options.calibration);
  send(OpenCommand{address.toStdString(), options});
}

OpenCommand MainWindow::lastSource() const {
  if (!m_settings) return {};
  return {m_settings->value("source/address").toString().toStdString(),
          {m_settings->value("source/calibration").toString().toStdString()}};
}

void MainWindow::takeNews() { showNews(m_worker->takeNews()); }

void MainWindow::showNews(const News& news) {
  const auto now = Clock::now();
  if (news.status.address != m_status.address) {
    m_skipped = m_lost = 0;
    m_panes.history->clear();
    // What the last source showed says nothing about this one.
    if (m_display && !news.display) showNothing();
  }
  m_skipped += news.skipped;
  m_lost += news.lost;
  showStatus(news.status);
  if (news.display) {
    WarningLatch levels = news.levels;
    m_hold.note(news.display->result->level, levels.take(), now);
    showDisplay(news.display);
    // As old as its frame, not as its processing: what took too long to compute is not live.
    if (news.display->result->frame) m_aliveAt = news.readAt;
  }
  if (news.display && news.frames > 0) {
    const std::chrono::duration<double, std::milli> latency = Clock::now() - news.readAt;
    m_panes.status->setLatency(latency.count());
    m_panes.status->setRate(playing() ? news.framesPerSecond : 0.0);
  }
  m_panes.status->setDropped(m_skipped, m_lost);
  for (const Notice& notice : news.notices) showNotice(notice);
  watch();
  if (news.finished) emit finished();
}

void MainWindow::showDisplay(const DisplayPtr& display) {
  m_display = display;
  m_panes.setDisplay(display);
  const auto now = Clock::now();
  if (const auto held = m_hold.held(now)) m_panes.bar->setLatchedLevel(*held);
  m_rebuild.show(*display->result, now);
  refreshState();
}

void MainWindow::showStatus(const SourceStatus& status) {
  const bool begins = status.player && (!playing() || status.address != m_status.address);
  if (begins) m_aliveAt = Clock::now();
  m_status = status;
  if (!playing()) m_panes.status->setRate(0.0);
  m_panes.player->setStatus(status.player);
  const QString title =
      status.address.isEmpty() ? tr("Boomwatch") : tr("%1 - Boomwatch").arg(status.address);
  setWindowTitle(title);
  refreshState();
}

QString MainWindow::sentenceOf(const Notice& notice) {
  switch (notice.kind) {
    case Notice::Kind::Source:
      return tr("Opened. %1").arg(notice.text);
    case Notice::Kind::OpenFailed:
      return tr("Not opened: %1").arg(notice.text);
    case Notice::Kind::Lost:
      return tr("Source lost: %1").arg(notice.text);
    case Notice::Kind::Tool:
      return tr("Tool: %1").arg(notice.text);
    case Notice::Kind::Calibration:
      return tr("The calibration does not fit: the rows of left and right differ by %1 px. "
                "Calibrate again, or switch on Row correction if it is off.")
          .arg(notice.text);
    case Notice::Kind::RowsCorrected:
      return tr("The calibration does not fit: the rows of left and right differ by %1 px. The "
                "program corrects this. Calibrate again soon.")
          .arg(notice.text);
    case Notice::Kind::Parameters:
      return tr("Parameters not applied: %1").arg(notice.text);
    case Notice::Kind::Frame:
      return tr("Frame rejected: %1").arg(notice.text);
  }
  return {};
}

void MainWindow::showNotice(const Notice& notice) {
  const QString sentence = sentenceOf(notice);
  const bool isNoFault =
      notice.kind == Notice::Kind::RowsCorrected || notice.kind == Notice::Kind::Source;
  if (isNoFault) {
    m_panes.state->showNotice(sentence);
    return;
  }
  if (notice.kind == Notice::Kind::Frame) {
    m_panes.state->showNotice(sentence);
  } else {
    m_panes.state->showFault(sentence);
  }
  emit faultShown(sentence);
}

void MainWindow::refreshState() {
  m_panes.barCaption->setText(barCaption(m_status));
  m_panes.state->setState(stateSentence(m_status, m_rebuild.rebuilding(Clock::now())));
}

/// What has to change although nothing arrives.
void MainWindow::watch() {
  const auto now = Clock::now();
  refreshState();
  if (!m_display) return;
  const bool live =
      m_status.player && m_status.player->live && m_status.player->state == PlayState::Playing;
  const Result& shown = *m_display->result;
  // The worker says so itself, unless it hangs in a driver or is behind with its work.
  const std::chrono::duration<double> age = now - m_aliveAt;
  if (live && shown.frame && age.count() > 2.0 * shown.parameters.validity.maxFrameAge) {
    showNothing();
  } else if (!m_hold.held(now) && m_panes.bar->level() != shown.level) {
    m_panes.bar->setDisplay(m_display);
  }
}

void MainWindow::showNothing() {
  const auto none =
      std::make_shared<const Result>(noFrameResult(Reason::NoFrame, m_display->result->parameters));
  showDisplay(makeDisplay(none, m_display->options));
}

void MainWindow::setParameters(const Parameters& parameters) {
  m_rebuild.want(parameters);
  m_panes.tracking->setParameters(parameters);
  if (m_worker) m_worker->setParameters(parameters);
  refreshState();
}

void MainWindow::orderTool(const ToolOrder& order) {
  send(ToolCommand{order});
  if (m_status.player && !playing()) {
    m_panes.state->showNotice(tr("The tool will be set with the next frame."));
  }
}

void MainWindow::askForSource(SourceKind kind) {
  SourceDialog dialog(kind, this);
  if (dialog.exec() != QDialog::Accepted) return;
  openSource(dialog.address(), {dialog.calibration().toStdString()});
}

void MainWindow::askForSnapshot() {
  const QString suffix = QStringLiteral("png");
  const QString name =
      QDateTime::currentDateTime().toString(QStringLiteral("'boomwatch-'yyyyMMdd-HHmmss'.'")) +
      suffix;
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  // Taken before the dialog covers the window.
  const QPixmap picture = grab();
  const QString file = askSaveName(this, tr("Save a picture of the window"),
                                   QDir(folder).filePath(name), tr("Pictures (*.png)"), suffix);
  if (!file.isEmpty() && !picture.save(file)) {
    m_panes.state->showFault(tr("%1 cannot be written. Choose another folder.").arg(file));
  }
}

bool MainWindow::saveSnapshot(const QString& file) { return grab().save(file); }

void MainWindow::applyColours() {
  const DisplayOptions options{
      static_cast<CloudColouring>(m_menus.cloudColours->checkedAction()->data().toInt()),
      static_cast<MapColouring>(m_menus.mapColours->checkedAction()->data().toInt())};
  if (m_worker) {
    m_worker->setDisplayOptions(options);
  } else if (m_display) {
    showDisplay(makeDisplay(m_display->result, options));
  }
}

void MainWindow::chooseTheme() {
  applyTheme(*qApp, m_menus.lightTheme->isChecked() ? ThemeKind::Light : ThemeKind::Dark);
}

void MainWindow::resetLayout() { m_panes.arrange(this); }

void MainWindow::restore() {
  if (!m_settings) return;
  restoreGeometry(m_settings->value("window/geometry").toByteArray());
  restoreState(m_settings->value("window/layout").toByteArray(), layoutVersion);
  check(m_menus.cloudColours, m_settings->value("view/cloud", 0).toInt());
  check(m_menus.mapColours, m_settings->value("view/maps", 0).toInt());
  m_menus.lightTheme->setChecked(m_settings->value("view/light", false).toBool());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (m_settings) {
    m_settings->setValue("window/geometry", saveGeometry());
    m_settings->setValue("window/layout", saveState(layoutVersion));
    m_settings->setValue("view/cloud", m_menus.cloudColours->checkedAction()->data());
    m_settings->setValue("view/maps", m_menus.mapColours->checkedAction()->data());
    m_settings->setValue("view/light", m_menus.lightTheme->isChecked());
    m_settings->setValue("source/address", m_status.address);
    m_settings->setValue("source/calibration", m_calibrations.value(m_status.address));
  }
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  const QString path = urls.front().toLocalFile();
  if (const auto address = guessAddress(path)) {
    openSource(*address);
    event->acceptProposedAction();
  } else {
    m_panes.state->showFault(tr("%1 is not a known recording. Drop a folder with left and right "
                                "pictures, with depth pictures, or with PCD or PLY files.")
                                 .arg(path));
  }
}

/// Space plays and pauses, but not while a button, a check box or a list that it belongs to has
/// the keyboard.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
      (qobject_cast<QAbstractButton*>(watched) || qobject_cast<QComboBox*>(watched))) {
    event->accept();
    return true;
  }
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace boomwatch
