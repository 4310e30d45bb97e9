#pragma once

#include <QStatusBar>
#include <map>
#include <string>

#include "pipeline/result.h"

class QHBoxLayout;
class QLabel;

namespace boomwatch {

/// The line of figures at the foot of the window. Every field has a fixed width. In a narrow window
/// the fields of the stages are hidden. GUI thread.
class StatusStrip : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  /// Shows the time of each stage, and whether there is a distance.
  void showResult(const Result& result);
  /// Frames a second; 0: unknown, or the source does not play.
  void setRate(double framesPerSecond);
  /// Milliseconds from reading a frame to showing its distance on the bar.
  void setLatency(double milliseconds);
  /// Frames since the source was opened. `skipped`: processed, not shown. `lost`: never read.
  void setDropped(std::size_t skipped, std::size_t lost);

  QString validityText() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitStages();
  QLabel* addField(const QString& widest);
  QLabel* stageField(std::string_view stage);

  QWidget* m_stageFields = nullptr;
  QHBoxLayout* m_stageRow = nullptr;
  int m_stagesWidth = 0;  ///< of its fields, shown or not
  QLabel* m_rate = nullptr;
  QLabel* m_latency = nullptr;
  QLabel* m_dropped = nullptr;
  QLabel* m_validity = nullptr;
  std::map<std::string, QLabel*, std::less<>> m_stages;
};

}  // namespace boomwatch
