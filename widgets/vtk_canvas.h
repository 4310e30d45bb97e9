#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>
#include <QOpenGLWidget>
#include <QTimer>

#include "vtk_scene.h"

namespace boomwatch {

/// Empty when an OpenGL 3.2 context can be made here; a sentence that says why not otherwise.
/// Asks once; GUI thread, after the QApplication was made.
QString whyNoOpenGl();

/// A VtkScene in Qt's own frame buffer. Draws when there is a new display or the view moves, never
/// otherwise; and only a preview while it moves, so that it follows the hand without a graphics
/// card. GUI thread.
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
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void releaseGl();
  void moved();

  VtkScene m_scene;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> m_window;
  QPointF m_last;
  QTimer m_settle;  ///< after the last movement, everything is drawn again
};

}  // namespace boomwatch
