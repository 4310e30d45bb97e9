#include "point_cloud_view.h"

#include <QLabel>
#include <QVBoxLayout>

#include "legend.h"
#include "texts.h"
#include "vtk_canvas.h"

namespace boomwatch {

PointCloudView::PointCloudView(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  const QString why = whyNoOpenGl();
  if (why.isEmpty()) {
    m_canvas = new VtkCanvas(this);
    m_legend = new Legend(this);
    layout->addWidget(m_canvas, 1);
    layout->addWidget(m_legend);
    setFocusProxy(m_canvas);
  } else {
    m_sentence = new QLabel(why, this);
    m_sentence->setAlignment(Qt::AlignCenter);
    m_sentence->setWordWrap(true);
    m_sentence->setMargin(24);
    layout->addWidget(m_sentence);
  }
}

void PointCloudView::setDisplay(const DisplayPtr& display) {
  if (!m_canvas) return;
  m_canvas->setDisplay(display);
  if (!display || !display->result) return;
  const Bounds& bounds = display->result->parameters.bounds;
  Legend::Scale scale;
  scale.darkest = darkestPointColour;
  switch (display->cloudColouring) {
    case CloudColouring::Depth:
      scale.first = tr("depth %1").arg(metresText(bounds.zMin));
      scale.last = metresText(bounds.zMax);
      break;
    case CloudColouring::Height:
      scale.first = tr("height, y = %1").arg(metresText(bounds.yMin));
      scale.last = metresText(bounds.yMax);
      break;
    case CloudColouring::Image:
      return m_legend->setSentence(tr("coloured as in the picture"));
  }
  m_legend->setScale(scale);
}

QString PointCloudView::whyNo3d() const { return m_sentence ? m_sentence->text() : QString(); }

QImage PointCloudView::image() const { return m_canvas ? m_canvas->grabFramebuffer() : QImage(); }

void PointCloudView::resetView() {
  if (m_canvas) m_canvas->resetView();
}

}  // namespace boomwatch
