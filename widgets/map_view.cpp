#include "map_view.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "legend.h"
#include "marks.h"
#include "texts.h"

namespace boomwatch {
namespace {

constexpr double maxScale = 64.0;     // pixels a cell
constexpr double stripHeight = 24.0;  // of the legend
constexpr double keptInSight = 32.0;  // pixels of the map, while it is dragged

/// The outline of a box on the model's plane: the hull of its projected corners. Empty when the box
/// reaches behind the camera of a perspective model.
std::vector<cv::Point2f> footprint(const OrientedBox& box, const GridGeometry& geometry) {
  std::vector<cv::Point2f> corners;
  for (const auto& corner : box.corners()) {
    if (geometry.isPerspective() && corner.z() <= 0.0) return {};
    const Eigen::Vector2d c = geometry.onPlane(corner);
    corners.emplace_back(static_cast<float>(c.x()), static_cast<float>(c.y()));
  }
  std::vector<cv::Point2f> hull;
  cv::convexHull(corners, hull);
  return hull;
}

}  // namespace

MapView::MapView(MapKind kind, QWidget* parent) : QWidget(parent), m_kind(kind) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(kind == MapKind::Probability ? tr("Probability map") : tr("Environment model"));
}

void MapView::setDisplay(const DisplayPtr& display) {
  const QSize before = image().size();
  m_display = display;
  if (image().size() != before) m_fitted = true;
  if (m_fitted) fit();
  updateReadout();
  update();
}

const QImage& MapView::image() const {
  static const QImage none;
  if (!m_display) return none;
  return m_kind == MapKind::Probability ? m_display->probability : m_display->model;
}

const EnvironmentModel* MapView::model() const {
  return image().isNull() ? nullptr : m_display->result->model.get();
}

QRectF MapView::mapArea() const { return QRectF(rect()).adjusted(0, 0, 0, -stripHeight); }

double MapView::fittingScale() const {
  const QRectF area = mapArea();
  const QSizeF cells = image().size();
  return std::min(area.width() / cells.width(), area.height() / cells.height());
}

void MapView::fit() {
  m_fitted = true;
  if (image().isNull() || mapArea().isEmpty()) return;
  m_scale = std::min(fittingScale(), maxScale);
  const QSizeF drawn = QSizeF(image().size()) * m_scale;
  m_origin = mapArea().center() - QPointF(drawn.width(), drawn.height()) / 2;
  update();
}

void MapView::zoom(double factor, const QPointF& anchor) {
  if (image().isNull() || mapArea().isEmpty() || !(factor > 0.0)) return;
  const double smallest = std::min(fittingScale() / 2, maxScale);
  const double scale = std::clamp(m_scale * factor, smallest, maxScale);
  m_origin = anchor + (m_origin - anchor) * (scale / m_scale);
  m_scale = scale;
  m_fitted = false;
  updateReadout();
  update();
}

void MapView::pan(const QPointF& by) {
  if (image().isNull()) return;
  const QRectF area = mapArea();
  const QSizeF drawn = QSizeF(image().size()) * m_scale;
  auto kept = [](double at, double low, double high) { return std::max(low, std::min(at, high)); };
  const QPointF moved = m_origin + by;
  m_origin = {
      kept(moved.x(), area.left() + keptInSight - drawn.width(), area.right() - keptInSight),
      kept(moved.y(), area.top() + keptInSight - drawn.height(), area.bottom() - keptInSight)};
  m_fitted = false;
  updateReadout();
  update();
}

std::optional<QPoint> MapView::cellAt(const QPointF& position) const {
  if (!model() || !mapArea().contains(position)) return std::nullopt;
  const QPointF cell = (position - m_origin) / m_scale;
  const QPoint whole(static_cast<int>(std::floor(cell.x())),
                     static_cast<int>(std::floor(cell.y())));
  if (!model()->geometry().contains(whole.x(), whole.y())) return std::nullopt;
  return whole;
}

QPointF MapView::positionOf(double x, double y) const {
  if (!model()) return {};
  const GridGeometry& geometry = model()->geometry();
  const QPointF metres(x - geometry.plane().left, y - geometry.plane().top);
  return m_origin + metres * (m_scale / geometry.resolution());
}

QString MapView::readout(const QPoint& cell) const {
  if (!model() || !model()->geometry().contains(cell.x(), cell.y())) return {};
  const GridGeometry& geometry = model()->geometry();
  const std::size_t k = geometry.index(cell.x(), cell.y());
  const CellState state = model()->state(cell.x(), cell.y());
  QStringList words;
  if (state == CellState::Occupied) {
    const Eigen::Vector3d p = geometry.surfacePoint(cell.x(), cell.y(), model()->levels()[k]);
    words << QStringLiteral("x ") + metresText(p.x()) << QStringLiteral("y ") + metresText(p.y())
          << QStringLiteral("z ") + metresText(p.z());
  } else if (geometry.isPerspective()) {
    // Without a surface a ray has a direction, but no position.
    const double z = geometry.bounds().zMax / 2;
    words << QStringLiteral("x/z ") + QLocale().toString(geometry.xOf(cell.x()) / z, 'f', 2)
          << QStringLiteral("y/z ") + QLocale().toString(geometry.yOf(cell.y()) / z, 'f', 2);
  } else {
    words << QStringLiteral("x ") + metresText(geometry.xOf(cell.x()))
          << QStringLiteral("y ") + metresText(geometry.yOf(cell.y()));
  }
  if (state != CellState::NeverObserved) {
    words << QStringLiteral("P ") +
                 QLocale().toString(static_cast<double>(model()->probabilities()[k]), 'f', 2);
  }
  const auto& suppressed = m_display->result->suppressed;
  const bool small = std::binary_search(suppressed.begin(), suppressed.end(), k);
  words << (small ? tr("ignored, too small") : cellText(state));
  return words.join(QStringLiteral("  "));
}

void MapView::updateReadout() {
  const auto cell = m_cursor ? cellAt(*m_cursor) : std::nullopt;
  const QString text = cell ? readout(*cell) : QString();
  if (text == m_readout) return;
  m_readout = text;
  emit readoutChanged(text);
  update();
}

void MapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = themeFor(palette());
  painter.fillRect(rect(), theme.canvas);
  if (!model()) {
    drawSentence(painter, rect(), tr("There is no model yet."), theme);
    return;
  }
  painter.save();
  painter.setClipRect(mapArea());
  drawCells(painter);
  if (m_kind == MapKind::Environment) drawOverlay(painter);
  painter.restore();
  drawStrip(painter);
}

void MapView::drawCells(QPainter& painter) {
  const QRectF map(m_origin, QSizeF(image().size()) * m_scale);
  const QRectF seen = map.intersected(mapArea());
  if (seen.isEmpty()) return;
  painter.fillRect(seen, hatchBrush(themeFor(palette())));
  if (m_scale >= 1.0) {
    const QRectF cells((seen.topLeft() - m_origin) / m_scale, seen.size() / m_scale);
    painter.drawImage(seen, image(), cells);
    return;
  }
  // Averaged, not sampled, when there are more cells than pixels: an object of one cell must stay
  // visible.
  const QSize size = map.size().toSize().expandedTo({1, 1});
  if (m_reducedOf != image().cacheKey() || m_reduced.size() != size) {
    m_reduced = image().scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    m_reducedOf = image().cacheKey();
  }
  painter.drawImage(m_origin, m_reduced);
}

void MapView::drawOverlay(QPainter& painter) const {
  const Result& result = *m_display->result;
  const Theme theme = themeFor(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.rays, 1.5));
  for (const SearchRay& ray : result.clearance.rays) {
    painter.drawLine(positionOf(ray.from.x(), ray.from.y()), positionOf(ray.to.x(), ray.to.y()));
  }
  drawSuppressed(painter);
  const GridGeometry& geometry = model()->geometry();
  const auto drawBox = [&](const OrientedBox& box) {
    QPolygonF outline;
    for (const auto& corner : footprint(box, geometry)) outline << positionOf(corner.x, corner.y);
    if (!outline.isEmpty()) drawMarkedPolygon(painter, outline, theme.load);
  };
  if (result.load) drawBox(*result.load);
  for (const Watched& watched : result.watched) {
    if (watched.object != WatchedObject::Load && watched.box) drawBox(*watched.box);
  }
  if (const auto& nearest = result.clearance.nearest) {
    const auto place = [&](const Eigen::Vector3d& p) {
      const Eigen::Vector2d onPlane = geometry.onPlane(p);
      return positionOf(onPlane.x(), onPlane.y());
    };
    drawNearestPair(painter, place(nearest->onLoad), place(nearest->onEnvironment), theme);
  }
}

/// A line around ignored cells, so that they look different from obstacles.
void MapView::drawSuppressed(QPainter& painter) const {
  constexpr std::size_t maxCells = 2000;  // more would cover the map and draw slowly
  const auto& cells = m_display->result->suppressed;
  const auto columns = static_cast<std::size_t>(model()->geometry().columns());
  const std::size_t count = std::min(cells.size(), maxCells);
  QRegion all;
  for (std::size_t n = 0; n < count;) {
    const std::size_t first = n, column = cells[n] % columns, row = cells[n] / columns;
    // Adjacent cells of a row as one rectangle, because a region is slow with many parts.
    while (++n < count && cells[n] == cells[n - 1] + 1 && cells[n] / columns == row) continue;
    const QPointF cell(static_cast<double>(column), static_cast<double>(row));
    const QRectF run(m_origin + cell * m_scale,
                     QSizeF(static_cast<double>(n - first) * m_scale, m_scale));
    if (run.intersects(mapArea())) all += run.adjusted(-2, -2, 2, 2).toAlignedRect();
  }
  QPainterPath outline;
  outline.addRegion(all);
  painter.setPen(QPen(themeFor(palette()).canvasText, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline.simplified());
}

void MapView::drawStrip(QPainter& painter) const {
  const Theme theme = themeFor(palette());
  Legend::Scale scale;
  scale.colouring = m_display->options.maps;
  if (m_kind == MapKind::Environment) {
    const Bounds& bounds = model()->geometry().bounds();
    scale.darkest = maxBrightness;
    scale.first = metresText(bounds.zMin);
    scale.last = metresText(bounds.zMax);
  } else {
    const double highest = maxProbability(m_display->result->parameters.model);
    scale.brightFirst = false;
    scale.darkest = freeBrightness;
    scale.first = QStringLiteral("P ") + QLocale().toString(0.0, 'f', 2);
    scale.last = QLocale().toString(highest, 'f', 2);
  }
  const QRectF strip(0, mapArea().bottom(), width(), stripHeight);
  Legend::draw(painter, strip.adjusted(8, 0, -8, 0), scale, theme.canvasText);
  if (m_readout.isEmpty()) return;
  const QRectF head(0, 0, width(), stripHeight);
  QColor ground = theme.canvas;
  ground.setAlpha(215);
  painter.fillRect(head, ground);
  painter.setPen(theme.canvasText);
  painter.drawText(head.adjusted(8, 0, -8, 0), Qt::AlignLeft | Qt::AlignVCenter, m_readout);
}

void MapView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (m_fitted) fit();
}

void MapView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(1.2, event->angleDelta().y() / 120.0), event->position());
  event->accept();
}

void MapView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) m_dragFrom = event->position();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  m_cursor = event->position();
  if (m_dragFrom) {
    const QPointF by = event->position() - *m_dragFrom;
    m_dragFrom = event->position();
    pan(by);
  }
  updateReadout();
}

void MapView::mouseReleaseEvent(QMouseEvent*) { m_dragFrom.reset(); }

void MapView::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void MapView::leaveEvent(QEvent*) {
  m_cursor.reset();
  updateReadout();
}

void MapView::keyPressEvent(QKeyEvent* event) {
  constexpr double step = 40.0;
  switch (event->key()) {
    case Qt::Key_Left:
      return pan({step, 0});
    case Qt::Key_Right:
      return pan({-step, 0});
    case Qt::Key_Up:
      return pan({0, step});
    case Qt::Key_Down:
      return pan({0, -step});
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(1.2, mapArea().center());
    case Qt::Key_Minus:
      return zoom(1 / 1.2, mapArea().center());
    case Qt::Key_F:
    case Qt::Key_Home:
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace boomwatch
