#pragma once

#include <QImage>
#include <QWidget>

#include "display.h"

class QLabel;

namespace boomwatch {

class Legend;
class VtkCanvas;

/// The cloud in three dimensions: points, bounds (green), load box (violet), points taken out as
/// dynamic (red), and the nearest pair joined by a line. Left drag orbits, middle or shift + drag
/// pans, wheel or right drag zooms; arrows, + - and Home do the same from the keyboard.
///
/// Without OpenGL (platform `offscreen`, no driver) it shows a sentence that says why, and every
/// call does nothing. GUI thread.
class PointCloudView : public QWidget {
  Q_OBJECT

 public:
  explicit PointCloudView(QWidget* parent = nullptr);

  /// Null clears the view. Keeps `display` alive while its arrays are drawn.
  void setDisplay(const DisplayPtr& display);

  bool has3d() const { return m_canvas != nullptr; }
  /// Why there is no 3-D view; empty if there is one.
  QString whyNo3d() const;

  /// What is seen now; null without OpenGL.
  QImage image() const;

  QSize minimumSizeHint() const override { return {160, 120}; }

 public slots:
  /// Looks along the camera's axis from behind it, at the whole of the bounds.
  void resetView();

 private:
  VtkCanvas* m_canvas = nullptr;
  QLabel* m_sentence = nullptr;
  Legend* m_legend = nullptr;
};

}  // namespace boomwatch
