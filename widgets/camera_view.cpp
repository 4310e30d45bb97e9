#include "camera_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "marks.h"
#include "tool_overlay.h"

namespace boomwatch {
namespace {

/// Nearer than this to the camera's plane, nothing can be projected.
constexpr double nearPlane = 0.05;
/// Pixels that a box has at first when it is begun from the keyboard.
constexpr int firstSide = 40;

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
      tr("To track the tool, drag a box around it, or press B, the arrow keys and Enter.\nTo set a "
         "fixed tool point, click it, or press the arrow keys and Enter.\nTo remove the tool, "
         "right-click or press Escape."));
}

void CameraView::setDisplay(const DisplayPtr& display) {
  m_display = display;
  const QRect picture({}, pictureSize());
  if (m_cursor && !picture.contains(*m_cursor)) m_cursor.reset();
  if (m_draft && !picture.contains(m_draft->box())) m_draft.reset();
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
  if (pictureRect().isEmpty()) return std::nullopt;
  const QPoint pixel = pixelUnder(position);
  if (!QRect({}, pictureSize()).contains(pixel)) return std::nullopt;
  return pixel;
}

/// Outside the picture it is a pixel that is not there.
QPoint CameraView::pixelUnder(const QPointF& position) const {
  const QRectF area = pictureRect();
  const QPointF inside = (position - area.topLeft()) * (pictureSize().width() / area.width());
  return {static_cast<int>(std::floor(inside.x())), static_cast<int>(std::floor(inside.y()))};
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
  drawWatched(painter);
  drawNearest(painter);
  const auto map = [this](const QPointF& pixel) { return toWidget(pixel); };
  drawTool(painter, *m_display, map, theme);
  drawCursor(painter);
  if (m_draft) drawDraft(painter, m_draft->box(), m_draft->isLargeEnough(), map, theme);
}

void CameraView::drawWatched(QPainter& painter) const {
  const Result& result = *m_display->result;
  if (!m_display->projection) return;
  if (result.load) drawBox(painter, *result.load);
  for (const Watched& watched : result.watched) {
    if (watched.object != WatchedObject::Load && watched.box) drawBox(painter, *watched.box);
  }
}

void CameraView::drawBox(QPainter& painter, const OrientedBox& box) const {
  const auto corners = box.corners();
  const auto project = [this](const Eigen::Vector3d& p) {
    return pixelOf(*m_display->projection, p);
  };
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
  const auto project = [this](const Eigen::Vector3d& p) {
    return pixelOf(*m_display->projection, p);
  };
  drawNearestPair(painter, toWidget(project(line->first)), toWidget(project(line->second)),
                  themeFor(palette()));
}

void CameraView::drawCursor(QPainter& painter) const {
  if (!m_cursor || m_draft || !hasFocus()) return;
  const Theme theme = themeFor(palette());
  drawCrosshair(painter, toWidget(*m_cursor), Qt::white, theme.outline);
}

void CameraView::mousePressEvent(QMouseEvent* event) {
  m_cursor.reset();
  m_pressed.reset();
  update();
  if (event->button() == Qt::RightButton) return giveUp();
  if (event->button() == Qt::LeftButton && pixelAt(event->position())) {
    m_pressed = event->position();
  }
}

void CameraView::mouseMoveEvent(QMouseEvent* event) {
  if (!m_pressed || pictureSize().isEmpty()) return;
  const QPointF way = event->position() - *m_pressed;
  if (!m_draft && way.manhattanLength() < QApplication::startDragDistance()) return;
  if (!m_draft) m_draft.emplace(pixelUnder(*m_pressed), pictureSize());
  m_draft->moveTo(pixelUnder(event->position()));
  update();
}

void CameraView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_pressed) return;
  const auto pixel = pixelAt(*std::exchange(m_pressed, std::nullopt));
  if (m_draft) {
    confirm();
  } else if (pixel) {
    emit toolPicked(*pixel);
  }
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
    case Qt::Key_B:
      return beginBox();
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      return confirm();
    case Qt::Key_Escape:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return giveUp();
    default:
      QWidget::keyPressEvent(event);
  }
}

void CameraView::beginBox() {
  setFocus(Qt::OtherFocusReason);
  const QSize size = pictureSize();
  if (size.isEmpty()) return;
  m_draft.emplace(m_cursor.value_or(QPoint(size.width() / 2, size.height() / 2)), size);
  m_draft->moveBy({firstSide, firstSide});
  update();
}

/// The box that is being drawn or, without one, the cursor's pixel is the tool.
void CameraView::confirm() {
  update();
  if (!m_draft) {
    if (m_cursor) emit toolPicked(*m_cursor);
    return;
  }
  const BoxDraft draft = *std::exchange(m_draft, std::nullopt);
  if (draft.isLargeEnough()) emit boxDrawn(draft.box());
}

/// The box that is being drawn goes or, without one, the tool.
void CameraView::giveUp() {
  update();
  m_pressed.reset();
  if (std::exchange(m_draft, std::nullopt)) return;
  m_cursor.reset();
  emit toolCleared();
}

void CameraView::moveCursor(const QPoint& by) {
  const QSize size = pictureSize();
  if (size.isEmpty()) return;
  update();
  if (m_draft) return m_draft->moveBy(by);
  const QPoint moved = m_cursor.value_or(QPoint(size.width() / 2, size.height() / 2)) + by;
  m_cursor = QPoint(std::clamp(moved.x(), 0, size.width() - 1),
                    std::clamp(moved.y(), 0, size.height() - 1));
}

std::optional<QRect> CameraView::draft() const {
  return m_draft ? std::optional(m_draft->box()) : std::nullopt;
}

void CameraView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace boomwatch
