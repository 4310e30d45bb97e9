#include "console.h"

#include <QApplication>
#include <QIcon>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <cstdio>
#include <limits>

#include "main_window.h"
#include "open_source.h"
#include "theme.h"
#include "worker.h"

namespace boomwatch {
namespace {

constexpr std::size_t wholeRecording = std::numeric_limits<std::size_t>::max();

void complain(const QString& text) {
  std::fprintf(stderr, "boomwatch: %s\n", text.toLocal8Bit().constData());
}

void prepare(QApplication& application) {
  QCoreApplication::setOrganizationName(QStringLiteral("Boomwatch"));
  QCoreApplication::setApplicationName(QStringLiteral("Boomwatch"));
  // By this the desktop finds the name and the icon of the window.
  QGuiApplication::setDesktopFileName(QStringLiteral("boomwatch"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/boomwatch.svg")));
  applyTheme(application, ThemeKind::Dark);
}

void translate(QApplication& application, const QString& name, const QString& folder) {
  auto* translator = new QTranslator(&application);
  if (translator->load(QLocale(), name, QStringLiteral("_"), folder)) {
    QCoreApplication::installTranslator(translator);
  }
}

/// A run from the command line: what to open, when to stop, what came of it.
class ConsoleRun {
 public:
  explicit ConsoleRun(const CommandLine& line)
      : m_line(line),
        m_worker(line.parameters),
        m_window(line.parameters, &m_worker, std::make_unique<QSettings>()) {}

  int run() {
    QObject::connect(&m_window, &MainWindow::faultShown, &m_window, [this](const QString& text) {
      complain(text);
      m_faulty = true;
    });
    QObject::connect(&m_window, &MainWindow::finished, &m_window, [this] { finish(); });
    orderTool();
    if (m_line.frames || !m_line.screenshot.isEmpty()) {
      m_worker.command(StopAfterCommand{m_line.frames.value_or(wholeRecording)});
    }
    open();
    m_window.show();
    const int code = QApplication::exec();
    return code == 0 && m_faulty && !m_line.screenshot.isEmpty() ? 1 : code;
  }

 private:
  void orderTool() {
    if (m_line.tool) m_worker.command(ToolCommand{PickTool{*m_line.tool}});
    if (m_line.track) m_worker.command(ToolCommand{TrackBox{*m_line.track}});
    if (!m_line.trackerModels.empty()) {
      m_worker.command(LoadToolModelCommand{m_line.trackerModels});
    }
  }

  void open() {
    if (!m_line.source.isEmpty()) {
      m_window.openSource(m_line.source, m_line.sourceOptions);
      return;
    }
    const OpenCommand last = m_window.lastSource();
    const bool any = !last.address.empty();
    m_window.openSource(any ? QString::fromStdString(last.address) : "demo:yard",
                        any ? last.options : m_line.sourceOptions);
  }

  void finish() {
    if (m_line.screenshot.isEmpty()) return;
    // The panes paint what they were just given before the picture is taken.
    QTimer::singleShot(0, &m_window, [this] {
      if (!m_window.saveSnapshot(m_line.screenshot)) {
        complain(m_line.screenshot + QStringLiteral(": cannot be written. Name a PNG file in a "
                                                    "folder that can be written."));
        m_faulty = true;
      }
      QApplication::quit();
    });
  }

  const CommandLine& m_line;
  Worker m_worker;
  MainWindow m_window;
  bool m_faulty = false;
};

}  // namespace

int runConsole(QApplication& application, const CommandLine& line) {
  prepare(application);
  translate(application, QStringLiteral("qtbase"),
            QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  translate(application, QStringLiteral("boomwatch"), QStringLiteral(":/i18n"));
  return ConsoleRun(line).run();
}

bool saveWindowScreenshot(const ResultPtr& result, const QString& file) {
  prepare(*qApp);
  MainWindow window(result->parameters, nullptr);
  window.setAttribute(Qt::WA_DontShowOnScreen);
  window.show();
  SourceStatus status;  // the run is over: its last frame is not what is there now
  status.player = PlayerStatus{};
  if (result->frame) status.player->position = result->frame->sequence;
  window.showStatus(status);
  window.showDisplay(makeDisplay(result, {}));
  QCoreApplication::processEvents();
  return window.saveSnapshot(file);
}

}  // namespace boomwatch
