#include "vtk_canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>
#include <chrono>
#include <cmath>

namespace boomwatch {
namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double zoomStep = 1.15;
constexpr auto settleTime = std::chrono::milliseconds(200);

/// What VTK needs. No alpha: Qt would blend the view with what lies behind the window.
QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setAlphaBufferSize(0);
  format.setSamples(0);
  return format;
}

bool contextWorks() {
  QOpenGLContext context;
  context.setFormat(surfaceFormat());
  if (!context.create() || !context.isValid()) return false;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return false;
  context.doneCurrent();
  return context.format().version() >= qMakePair(3, 2);
}

}  // namespace

QString whyNoOpenGl() {
  const QString platform = QGuiApplication::platformName();
  for (const char* without : {"offscreen", "minimal", "vnc", "linuxfb"}) {
    if (platform == QLatin1String(without)) {
      return VtkCanvas::tr(
                 "There is no 3-D view: the display platform \"%1\" has no OpenGL. "
                 "Start the program on a desktop to see it.")
          .arg(platform);
    }
  }
  static const bool works = contextWorks();
  if (works) return {};
  return VtkCanvas::tr(
      "There is no 3-D view: OpenGL 3.2 could not be started. Install or update the graphics "
      "driver, or set LIBGL_ALWAYS_SOFTWARE=1 before you start the program.");
}

VtkCanvas::VtkCanvas(QWidget* parent) : QOpenGLWidget(parent), m_scene(themeOf(ThemeKind::Dark)) {
  setFormat(surfaceFormat());
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Point cloud"));
  m_settle.setSingleShot(true);
  m_settle.setInterval(settleTime);
  connect(&m_settle, &QTimer::timeout, this, [this] {
    m_scene.setPreview(false);
    update();
  });
}

VtkCanvas::~VtkCanvas() { releaseGl(); }

void VtkCanvas::setDisplay(const DisplayPtr& display) {
  m_scene.setDisplay(display);
  update();
}

void VtkCanvas::resetView() {
  m_scene.resetView();
  update();
}

void VtkCanvas::initializeGL() {
  // A dock that is torn off gets another context: what VTK holds in the old one goes with it.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkCanvas::releaseGl,
          Qt::UniqueConnection);
  m_window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  m_window->SetOwnContext(false);
  m_window->SetMultiSamples(0);
  m_window->SetMapped(true);
  m_window->SetIsCurrent(true);
  m_window->SetSupportsOpenGL(true);
  m_window->SetIsDirect(true);
  m_window->AddRenderer(m_scene.renderer());
  m_window->OpenGLInitContext();
  m_window->SetFrameBlitModeToBlitToCurrent();
}

void VtkCanvas::releaseGl() {
  if (!m_window) return;
  makeCurrent();
  m_window->Finalize();
  m_window->RemoveRenderer(m_scene.renderer());
  m_scene.renderer()->SetRenderWindow(nullptr);
  m_window = nullptr;
  doneCurrent();
}

void VtkCanvas::resizeGL(int width, int height) {
  const double ratio = devicePixelRatioF();
  m_window->SetSize(static_cast<int>(std::lround(width * ratio)),
                    static_cast<int>(std::lround(height * ratio)));
}

void VtkCanvas::paintGL() {
  if (!m_window) return;
  m_scene.renderer()->ResetCameraClippingRange();
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  state->Push();
  m_window->Render();
  state->Pop();
  // Whatever VTK left in the alpha channel, the window system must not look through it.
  QOpenGLFunctions* gl = context()->functions();
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VtkCanvas::moved() {
  m_scene.setPreview(true);
  m_settle.start();
  update();
}

void VtkCanvas::mousePressEvent(QMouseEvent* event) { m_last = event->position(); }

void VtkCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - m_last;
  m_last = event->position();
  const bool left = event->buttons() & Qt::LeftButton;
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  if ((event->buttons() & Qt::MiddleButton) || (left && shift)) {
    m_scene.pan(by.x(), by.y(), height());
  } else if (left) {
    m_scene.orbit(-by.x() * degreesPerPixel, by.y() * degreesPerPixel);
  } else if (event->buttons() & Qt::RightButton) {
    m_scene.zoom(std::pow(zoomStep, -by.y() / 20.0));
  } else {
    return;
  }
  moved();
}

void VtkCanvas::mouseReleaseEvent(QMouseEvent*) { m_settle.start(); }

void VtkCanvas::wheelEvent(QWheelEvent* event) {
  m_scene.zoom(std::pow(zoomStep, event->angleDelta().y() / 120.0));
  event->accept();
  moved();
}

void VtkCanvas::keyPressEvent(QKeyEvent* event) {
  constexpr double turn = 5.0;
  switch (event->key()) {
    case Qt::Key_Left:
      m_scene.orbit(turn, 0);
      break;
    case Qt::Key_Right:
      m_scene.orbit(-turn, 0);
      break;
    case Qt::Key_Up:
      m_scene.orbit(0, turn);
      break;
    case Qt::Key_Down:
      m_scene.orbit(0, -turn);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      m_scene.zoom(zoomStep);
      break;
    case Qt::Key_Minus:
      m_scene.zoom(1 / zoomStep);
      break;
    case Qt::Key_Home:
      return resetView();
    default:
      return QWidget::keyPressEvent(event);
  }
  moved();
}

}  // namespace boomwatch
