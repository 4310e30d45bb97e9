#include "vtk_canvas.h"

#include <vtkAutoInit.h>
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
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

// VTK picks its classes for OpenGL at run time; this registers them. CMake's way would compile a
// path of this clone into every file.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace boomwatch {
namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double zoomStep = 1.15;
constexpr auto settleTime = std::chrono::milliseconds(250);

/// Of one drawing while others wait: slower, and there will be fewer points; faster, and more.
constexpr auto slowest = std::chrono::milliseconds(40);
constexpr auto fastest = std::chrono::milliseconds(16);
constexpr std::size_t minPoints = 1U << 15;
constexpr std::size_t everyPoint = std::numeric_limits<std::size_t>::max();

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
  connect(&m_settle, &QTimer::timeout, this, &VtkCanvas::drawAll);
}

VtkCanvas::~VtkCanvas() {
  releaseGl();
  // QOpenGLWidget destroys the context after this part of the object is gone.
  if (context()) disconnect(context(), nullptr, this, nullptr);
}

void VtkCanvas::setDisplay(const DisplayPtr& display) {
  m_scene.setPointLimit(m_liveLimit);
  m_scene.setDisplay(display);
  drawLive();
}

void VtkCanvas::resetView() {
  m_scene.resetView(aspect());
  drawLive();
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
  // A core profile draws thin lines only, whatever it claims; VTK then widens them itself.
  m_window->SetForceMaximumHardwareLineWidth(1.0F);
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
  m_scene.keepBoundsInView(aspect());
}

void VtkCanvas::paintGL() {
  if (!m_window) return;
  const auto start = std::chrono::steady_clock::now();
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
  // Without this the clock would stop before the drawing does.
  gl->glFinish();
  adapt(std::chrono::steady_clock::now() - start);
}

void VtkCanvas::drawLive() {
  m_scene.setPointLimit(m_liveLimit);
  m_settle.start();
  update();
}

void VtkCanvas::drawAll() {
  m_scene.setPointLimit(everyPoint);
  update();
}

void VtkCanvas::adapt(std::chrono::nanoseconds taken) {
  if (m_scene.pointLimit() != m_liveLimit) return;
  if (taken > slowest) m_liveLimit = std::max(m_liveLimit / 2, minPoints);
  if (taken < fastest && !m_scene.everyPointDrawn()) m_liveLimit *= 2;
}

double VtkCanvas::aspect() const { return static_cast<double>(width()) / std::max(1, height()); }

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
  drawLive();
}

void VtkCanvas::wheelEvent(QWheelEvent* event) {
  m_scene.zoom(std::pow(zoomStep, event->angleDelta().y() / 120.0));
  event->accept();
  drawLive();
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
  drawLive();
}

}  // namespace boomwatch
