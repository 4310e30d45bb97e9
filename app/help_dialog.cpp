#include "help_dialog.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace boomwatch {
namespace {

QString shownText() {
  return HelpDialog::tr(
      "<h3>What you see</h3>"
      "<p>The bar on the left shows the distance from the load to the nearest obstacle in the "
      "environment model. It begins to fill at the caution distance and is full at a collision. "
      "A hatched bar means that there is no distance; the reason is beside it.</p>"
      "<p>The point cloud shows what the camera measures now. The watched space is green, the load "
      "is violet, masked points of the crane are red, and a line joins the nearest pair of "
      "points. The probability map shows how certain each cell of the model is. The environment "
      "model shows the depth of each cell: nearer cells are brighter, unobserved cells are "
      "hatched.</p>");
}

QString unknownText() {
  return HelpDialog::tr(
      "<h3>What the program cannot know</h3>"
      "<ul><li><b>Occluded objects.</b> Each cell holds the surface nearest to the camera. "
      "Objects behind it are not in the model.</li>"
      "<li><b>Unobserved space.</b> Occluded, dark, over-exposed or textureless areas have no "
      "depth. The bar shows the observed share of the neighbourhood.</li>"
      "<li><b>Objects that have just appeared.</b> The camera must see an object in several "
      "frames in a row before it enters the model.</li>"
      "<li><b>The distance while the tool is lost.</b> Boom and load cannot be masked without "
      "the tool, so there is no distance.</li>"
      "<li><b>Masked points.</b> Points masked with the crane and its load are red and are not "
      "part of the distance.</li>"
      "<li><b>A moving camera.</b> The model needs a camera that stands still.</li></ul>"
      "<p>A paused or ended recording does not show the present. The caption over the bar says "
      "so.</p>");
}

QString trackersText() {
  return HelpDialog::tr(
      "<h3>Which tracker</h3>"
      "<ul><li><b>tld</b> is the default. It re-detects the tool after an occlusion, learns new "
      "views of it, and can be saved.</li>"
      "<li><b>cmt</b> suits a tool with much texture that rotates in the picture or is partly "
      "occluded. It does not suit a small, blurred or smooth tool.</li>"
      "<li><b>csrt</b> suits a fast computer and a tool that stays in sight.</li>"
      "<li><b>klt</b> suits short runs on a slow computer. It does not re-detect a lost "
      "tool.</li></ul>");
}

QString keysText() {
  return HelpDialog::tr(
      "<h3>Keys</h3>"
      "<table cellpadding='3'>"
      "<tr><td>Space</td><td>play or pause</td></tr>"
      "<tr><td>. and ,</td><td>next frame, previous frame</td></tr>"
      "<tr><td>L</td><td>loop the recording</td></tr>"
      "<tr><td>Ctrl+O</td><td>open a recording</td></tr>"
      "<tr><td>Ctrl+S</td><td>save a picture of the window</td></tr>"
      "<tr><td>R</td><td>reset the 3-D view</td></tr>"
      "<tr><td>F</td><td>fit the maps</td></tr>"
      "<tr><td>Drag in the camera view</td><td>track the tool in this box; or press B, the arrow "
      "keys and Enter</td></tr>"
      "<tr><td>Click in the camera view</td><td>set a fixed tool point</td></tr>"
      "<tr><td>Right-click in the camera view</td><td>remove the tool</td></tr></table>");
}

}  // namespace

HelpDialog::HelpDialog(QWidget* parent) : QDialog(parent) {
  constexpr QSize size(640, 620);
  setWindowTitle(tr("Boomwatch: help"));
  auto* page = new QTextBrowser;
  page->setHtml(shownText() + unknownText() + trackersText() + keysText());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* column = new QVBoxLayout(this);
  column->addWidget(page);
  column->addWidget(buttons);
  resize(size);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace boomwatch
