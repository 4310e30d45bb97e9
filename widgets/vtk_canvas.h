#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>
#include <QOpenGLWidget>
#include <QTimer>
#include <chrono>
#include <cstddef>

#include "vtk_scene.h"

namespace boomwatch {

/// Empty when an OpenGL 3.2 context can be made here; a sentence that says why not otherwise.
/// Asks once; GUI thread, after the QApplication was made.
QString whyNoOpenGl();

/// A VtkScene in Qt's own frame buffer. Draws when there is a new display or the view moves, never
/// otherwise. While frames or the hand keep coming it draws only as many points as this machine
/// draws in time, so that the window answers without a graphics card; all of them once it is still.
/// GUI thread.
class VtkCanvas : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkCanvas(QWidget* parent = nullptr);
  ~VtkCanvas() override;

  void setDisplay(const DisplayPtr& display);

 public slots:
  void resetView();

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void releaseGl();
  /// Draws soon and in time; everything, a little later.
  void drawLive();
  void drawAll();
  void adapt(std::chrono::nanoseconds taken);
  double aspect() const;

  VtkScene m_scene;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> m_window;
  QPointF m_last;
  QTimer m_settle;                   ///< from the last change until everything is drawn
  std::size_t m_liveLimit = 131072;  ///< points that are drawn in time, as far as is known
};

}  // namespace boomwatch
