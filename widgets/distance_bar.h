#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "display.h"

namespace boomwatch {

/// The distance as a glance should meet it: level in a word and a shape, a number readable from two
/// metres, and a red bar that begins at the caution distance and is full at collision
/// (docs/method.md section 8). Hatched, with the reason in words, when there is no distance. Its
/// size never depends on what it shows. GUI thread.
class DistanceBar : public QWidget {
  Q_OBJECT

 public:
  explicit DistanceBar(QWidget* parent = nullptr);

  void setDisplay(const DisplayPtr& display);
  /// Shows `level` in place of the result's own until the next display: for a worse one that
  /// passed while nothing was shown (see WarningLatch).
  void setLatchedLevel(WarningLevel level);

  /// 0 at the caution distance, 1 at collision; absent when there is no distance (hatched).
  std::optional<double> fill() const;
  /// "3.70", "> 10", or a dash when there is no distance.
  QString numberText() const;
  WarningLevel level() const;
  /// What stands below the number: the reason, "nothing within 10 m", or how sure it is.
  QString hintText() const;
  /// That, and everything that is watched, a line each.
  QString detailText() const;

  QSize sizeHint() const override { return {176, 480}; }
  QSize minimumSizeHint() const override { return {176, 260}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// What of what the distance is: a part of the load, the tool, the boom, or unseen space.
  static QString leadText(const Result& result, const Nearest& nearest);
  static QString othersText(const Result& result);
  const Nearest* nearest() const;
  bool nothingInRange() const;
  double searchedRange() const;
  QString nothingWithin() const;
  void announce();

  DisplayPtr m_display;
  std::optional<WarningLevel> m_latched;
};

}  // namespace boomwatch
