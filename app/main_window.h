#pragma once

#include <QHash>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>
#include <chrono>
#include <memory>

#include "level_hold.h"
#include "messages.h"
#include "panes.h"
#include "rebuild_watch.h"
#include "window_menus.h"

namespace boomwatch {

class Worker;
enum class SourceKind;

/// The console's window: shows what the worker publishes, and tells it what the person wants.
/// GUI thread; computes nothing.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `worker` may be absent: the window then shows what showDisplay is given. `settings` may be
  /// absent: nothing is remembered. The worker must outlive the window.
  MainWindow(const Parameters& parameters, Worker* worker,
             std::unique_ptr<QSettings> settings = nullptr);
  ~MainWindow() override;

  void openSource(const QString& address, const SourceOptions& options = {});
  /// What was open when the window was last closed; empty: nothing.
  OpenCommand lastSource() const;

  void showDisplay(const DisplayPtr& display);
  void showStatus(const SourceStatus& status);
  /// A picture of the whole window; false if the file cannot be written.
  bool saveSnapshot(const QString& file);

  const Panes& panes() const { return m_panes; }
  const WindowMenus& menus() const { return m_menus; }
  const SourceStatus& status() const { return m_status; }

 signals:
  /// The frames asked for (StopAfterCommand) have been processed and the last one is shown.
  void finished();
  /// For those who run the window from a terminal.
  void faultShown(const QString& text);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeToolBars();
  void restore();
  void wire();
  void wirePlayer();
  void wireMenus();
  void wirePanes();
  void wireTracking();
  void takeNews();
  void showNews(const News& news);
  static QString sentenceOf(const Notice& notice);
  void showNotice(const Notice& notice);
  void watch();
  void showNothing();
  void refreshState();
  void send(const Command& command);
  void askForSource(SourceKind kind);
  void askForSnapshot();
  void setParameters(const Parameters& parameters);
  void orderTool(const ToolOrder& order);
  void applyColours();
  void chooseTheme();
  void resetLayout();
  bool playing() const { return m_status.player && m_status.player->state == PlayState::Playing; }

  Worker* m_worker;
  std::unique_ptr<QSettings> m_settings;
  Panes m_panes;
  WindowMenus m_menus;
  QTimer m_watch;
  SourceStatus m_status;
  DisplayPtr m_display;
  LevelHold m_hold;
  RebuildWatch m_rebuild;
  QHash<QString, QString> m_calibrations;           ///< of the addresses opened
  std::chrono::steady_clock::time_point m_aliveAt;  ///< when a live source last gave a frame
  std::size_t m_skipped = 0;
  std::size_t m_lost = 0;
};

}  // namespace boomwatch
