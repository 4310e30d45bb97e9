#include "camera_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "marks.h"

namespace boomwatch {
namespace {

/// Nearer than this to the camera's plane, nothing can be projected.
constexpr double nearPlane = 0.05;

/// The part of a line in front of the near plane.
std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> clipped(Eigen::Vector3d a,
                                                                   Eigen::Vector3d b) {
  if (a.z() < nearPlane && b.z() < nearPlane) return std::nullopt;
  if (a.z() < nearPlane) a = b + (a - b) * ((b.z() - nearPlane) / (b.z() - a.z()));
  if (b.z() < nearPlane) b = a + (b - a) * ((a.z() - nearPlane) / (a.z() - b.z()));
  return std::pair(a, b);
}

}  // namespace

CameraView::CameraView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Camera"));
  setToolTip(
      tr("Click, or arrows and Enter: this is the tool.\nRight click or Escape: forget it."));
}

void CameraView::setDisplay(const DisplayPtr& display) {
  m_display = display;
  if (pictureSize().isEmpty() || (m_cursor && !QRect({}, pictureSize()).contains(*m_cursor))) {
    m_cursor.reset();
  }
  setCursor(pictureSize().isEmpty() ? Qt::ArrowCursor : Qt::CrossCursor);
  update();
}

QSize CameraView::pictureSize() const { return m_display ? m_display->camera.size() : QSize(); }

QRectF CameraView::pictureRect() const {
  if (pictureSize().isEmpty()) return {};
  QRectF area({}, QSizeF(pictureSize()).scaled(size(), Qt::KeepAspectRatio));
  area.moveCenter(QRectF(rect()).center());
  return area;
}

std::optional<QPoint> CameraView::pixelAt(const QPointF& position) const {
  const QRectF area = pictureRect();
  if (area.isEmpty()) return std::nullopt;
  const QPointF inside = (position - area.topLeft()) * (pictureSize().width() / area.width());
  const QPoint pixel(static_cast<int>(std::floor(inside.x())),
                     static_cast<int>(std::floor(inside.y())));
  if (!QRect({}, pictureSize()).contains(pixel)) return std::nullopt;
  return pixel;
}

QPointF CameraView::toWidget(const QPointF& pixel) const {
  const QRectF area = pictureRect();
  // A pixel's coordinates are those of its centre.
  return area.topLeft() + (pixel + QPointF(0.5, 0.5)) * (area.width() / pictureSize().width());
}

void CameraView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = themeFor(palette());
  painter.fillRect(rect(), theme.canvas);
  if (pictureSize().isEmpty()) {
    const bool none = !m_display || !m_display->result || !m_display->result->frame;
    drawSentence(painter, rect(),
                 none ? tr("No picture has arrived.") : tr("This source has no picture."), theme);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(pictureRect(), m_display->camera);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(pictureRect());
  drawLoad(painter);
  drawNearest(painter);
  if (const auto& tool = m_display->result->tool.pixel) {
    drawCrosshair(painter, toWidget(QPointF(tool->x, tool->y)), theme.tool, theme.outline);
  }
  drawCursor(painter);
}

void CameraView::drawLoad(QPainter& painter) const {
  const auto& load = m_display->result->load;
  if (!load || !m_display->projection) return;
  const auto corners = load->corners();
  const auto& project = *m_display->projection;
  QList<QLineF> edges;
  for (unsigned k = 0; k < 8; ++k) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if (k & axis) continue;
      const auto edge = clipped(corners[k], corners[k | axis]);
      if (edge) edges << QLineF(toWidget(project(edge->first)), toWidget(project(edge->second)));
    }
  }
  drawMarkedLines(painter, edges, themeFor(palette()).load, 2.0);
}

void CameraView::drawNearest(QPainter& painter) const {
  const auto& nearest = m_display->result->clearance.nearest;
  if (!nearest || !m_display->projection) return;
  const auto line = clipped(nearest->onLoad, nearest->onEnvironment);
  if (!line) return;
  const auto& project = *m_display->projection;
  drawNearestPair(painter, toWidget(project(line->first)), toWidget(project(line->second)),
                  themeFor(palette()));
}

void CameraView::drawCursor(QPainter& painter) const {
  if (!m_cursor || !hasFocus()) return;
  const Theme theme = themeFor(palette());
  drawCrosshair(painter, toWidget(*m_cursor), Qt::white, theme.outline);
}

void CameraView::mousePressEvent(QMouseEvent* event) {
  m_cursor.reset();
  update();
  if (event->button() == Qt::RightButton) {
    emit toolCleared();
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (const auto pixel = pixelAt(event->position())) emit toolPicked(*pixel);
}

void CameraView::keyPressEvent(QKeyEvent* event) {
  const int step = event->modifiers() & Qt::ShiftModifier ? 1 : 10;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor({-step, 0});
    case Qt::Key_Right:
      return moveCursor({step, 0});
    case Qt::Key_Up:
      return moveCursor({0, -step});
    case Qt::Key_Down:
      return moveCursor({0, step});
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (m_cursor) emit toolPicked(*m_cursor);
      return;
    case Qt::Key_Escape:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      m_cursor.reset();
      update();
      emit toolCleared();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void CameraView::moveCursor(const QPoint& by) {
  const QSize size = pictureSize();
  if (size.isEmpty()) return;
  const QPoint moved = m_cursor.value_or(QPoint(size.width() / 2, size.height() / 2)) + by;
  m_cursor = QPoint(std::clamp(moved.x(), 0, size.width() - 1),
                    std::clamp(moved.y(), 0, size.height() - 1));
  update();
}

void CameraView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace boomwatch
