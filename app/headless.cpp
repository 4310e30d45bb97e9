#include "headless.h"

#include <QFile>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "base/error.h"
#include "open_source.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/pipeline.h"
#include "result_json.h"
#include "stereo/row_alignment.h"
#include "tool_models.h"
#include "tracking/tool_model_file.h"

namespace boomwatch {
namespace {

/// A live source that is silent for this long has ended the run.
constexpr double silenceToGiveUp = 10.0;  // s

void complain(const std::string& message) {
  std::fprintf(stderr, "boomwatch: %s\n", message.c_str());
}

/// Where the lines go: a file or standard output.
class LineWriter {
 public:
  explicit LineWriter(const QString& path) {
    const bool standard = path.isEmpty() || path == QLatin1String("-");
    m_file.setFileName(standard ? QStringLiteral("standard output") : path);
    const bool open = standard ? m_file.open(stdout, QIODevice::WriteOnly)
                               : m_file.open(QIODevice::WriteOnly | QIODevice::Truncate);
    if (!open) {
      throw Error(m_file.fileName().toStdString(), m_file.errorString().toStdString(),
                  "Name a file that can be written with --output.");
    }
  }
  void write(const QByteArray& line) {
    if (m_file.write(line + '\n') >= 0 && m_file.flush()) return;
    throw std::runtime_error(m_file.fileName().toStdString() + ": " +
                             m_file.errorString().toStdString() +
                             ". Free some space or name another file with --output.");
  }

 private:
  QFile m_file;
};

class HeadlessRun {
 public:
  explicit HeadlessRun(const CommandLine& line)
      : m_line(line),
        m_source(openSource(line.source.isEmpty() ? "demo:yard" : line.source.toStdString(),
                            line.sourceOptions)),
        m_writer(line.output) {
    if (line.tool) m_pipeline.order(PickTool{*line.tool});
    if (line.track) m_pipeline.order(TrackBox{*line.track});
    if (!line.trackerModels.empty())
      m_pipeline.order(TrackModel{loadToolModels(line.trackerModels)});
    for (const ParameterWarning& warning : warningsFor(line.parameters)) complain(warning.message);
    if (const SourceInfo info = m_source->info(); !info.note.empty()) {
      complain(info.address + ": " + info.note);
    }
  }

  HeadlessOutcome run() {
    std::size_t frames = 0;
    while (!m_line.frames || frames < *m_line.frames) {
      const ReadResult read = m_source->next(patience());
      if (read.status == ReadResult::Status::End || !take(read)) break;
      ++frames;
    }
    if (!m_last) fault("the source gave no frame");
    if (!m_line.frames) sayIfCutShort(frames);
    keepModel();
    saveTracker();
    return {m_faulty ? 1 : 0, m_last};
  }

 private:
  std::chrono::milliseconds patience() const {
    return std::chrono::milliseconds(std::lround(m_line.parameters.validity.maxFrameAge * 1000));
  }

  /// False when the run is over.
  bool take(const ReadResult& read) {
    switch (read.status) {
      case ReadResult::Status::Ok:
        m_silence = 0.0;
        publish(m_pipeline.process(read.frame, m_line.parameters));
        return true;
      case ReadResult::Status::Bad: {
        fault(read.message);
        Result result = noFrameResult(Reason::UnreadableFrame, m_line.parameters);
        result.message = read.message;
        publish(std::move(result));
        return true;
      }
      case ReadResult::Status::Stalled:
        m_silence += m_line.parameters.validity.maxFrameAge;
        publish(noFrameResult(Reason::NoFrame, m_line.parameters));
        if (m_silence < silenceToGiveUp) return true;
        fault("the source has been silent for " + std::to_string(std::lround(m_silence)) + " s");
        return false;
      case ReadResult::Status::Lost:
        fault(read.message);
        return false;
      case ReadResult::Status::End:
        return false;
    }
    return false;
  }

  void publish(Result result) {
    if (!result.message.empty() && result.frame) fault(result.message);
    if (!result.tool.fault.empty()) fault(result.tool.fault);
    if (result.tool.model) m_toolModel = result.tool.model;
    sayIfRowsDiffer(result);
    m_writer.write(toJsonLine(result));
    m_last = std::make_shared<Result>(std::move(result));
  }

  /// No fault of this run. Once is enough.
  void sayIfRowsDiffer(const Result& result) {
    if (m_rowsTold || result.rowResidue.value_or(0.0) <= maxRowResidue) return;
    m_rowsTold = true;
    complain("the calibration does not fit: the rows of left and right differ by " +
             QString::number(*result.rowResidue, 'f', 1).toStdString() +
             (result.rowsCorrected ? " px. That is corrected; better calibrate anew."
                                   : " px. Calibrate anew, or set stereo_refine where it is off."));
  }

  /// No fault: some containers only estimate how many frames they hold.
  void sayIfCutShort(std::size_t frames) const {
    const SourceInfo info = m_source->info();
    if (info.live || !info.frameCount || frames >= *info.frameCount) return;
    complain(info.address + ": it ended after " + std::to_string(frames) +
             " frames, though it promised " + std::to_string(*info.frameCount) +
             ". If the end is missing, copy the file again.");
  }

  void fault(const std::string& message) {
    complain(message);
    m_faulty = true;
  }

  void keepModel() {
    if (m_last && !m_line.screenshot.isEmpty()) {
      m_last->model = std::make_shared<EnvironmentModel>(m_pipeline.model());
    }
  }

  void saveTracker() {
    if (m_line.saveTrackerModel.empty()) return;
    if (!m_toolModel) {
      fault(m_line.saveTrackerModel +
            ": not written, for no tracker has learnt anything. Give --track or --tracker-model.");
      return;
    }
    try {
      saveToolModel(*m_toolModel, m_line.saveTrackerModel);
    } catch (const Error& error) {
      fault(error.what());
    }
  }

  const CommandLine& m_line;
  std::unique_ptr<FrameSource> m_source;
  LineWriter m_writer;
  Pipeline m_pipeline;
  std::shared_ptr<Result> m_last;
  std::shared_ptr<const ToolModel> m_toolModel;  ///< the last there was
  double m_silence = 0.0;
  bool m_rowsTold = false;
  bool m_faulty = false;
};

}  // namespace

HeadlessOutcome runHeadless(const CommandLine& line) { return HeadlessRun(line).run(); }

}  // namespace boomwatch
