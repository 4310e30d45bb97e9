#include "help_dialog.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace boomwatch {
namespace {

QString shownText() {
  return HelpDialog::tr(
      "<h3>What you see</h3>"
      "<p>The bar on the left is the distance from the load to the nearest thing in the model of "
      "the surroundings. It begins to fill at the caution distance and is full at a collision. "
      "Hatched means that there is no distance; the reason stands beside it.</p>"
      "<p>The point cloud is what the camera measures now: the watched space in green, the load "
      "in violet, points taken out as moving in red, and the nearest pair joined by a line. The "
      "probability map says how sure the model is of each cell; the environment model shows how "
      "far away each one is, nearer being brighter, and hatched where nothing was ever seen.</p>");
}

QString unknownText() {
  return HelpDialog::tr(
      "<h3>What it does not know</h3>"
      "<ul><li>What is behind a surface. Each cell holds the surface that is nearest to the "
      "camera, nothing behind it.</li>"
      "<li>What was never observed: hidden, too dark, too bright or without texture. The share of "
      "the neighbourhood that was observed stands at the bar.</li>"
      "<li>What has only just appeared. A thing must be seen in several frames in a row before it "
      "enters the model.</li>"
      "<li>Where the tool is, when it was lost for too long. Then boom and load cannot be taken "
      "out of the cloud, and there is no distance.</li>"
      "<li>What is taken out with the load and the boom: shown in red, not in the distance.</li>"
      "<li>Anything, when the camera moves: the model is made for one that stands still.</li></ul>"
      "<p>A picture that is paused or ended is not what is there now. The words over the bar say "
      "so.</p>");
}

QString trackersText() {
  return HelpDialog::tr(
      "<h3>Which tracker</h3>"
      "<ul><li><b>tld</b> is the one to begin with: it finds the tool again after it was hidden, "
      "learns new views of it, and what it learnt can be saved.</li>"
      "<li><b>cmt</b> where the tool has much texture, turns in the picture or is partly covered; "
      "not where it is small, blurred or smooth.</li>"
      "<li><b>csrt</b> where the computer has time to spare and the tool stays in sight.</li>"
      "<li><b>klt</b> for a short while and with little time: once lost, it stays lost.</li></ul>");
}

QString keysText() {
  return HelpDialog::tr(
      "<h3>Keys</h3>"
      "<table cellpadding='3'>"
      "<tr><td>Space</td><td>play or pause</td></tr>"
      "<tr><td>. and ,</td><td>one frame on, one frame back</td></tr>"
      "<tr><td>L</td><td>begin again at the end</td></tr>"
      "<tr><td>Ctrl+O</td><td>open a recording</td></tr>"
      "<tr><td>Ctrl+S</td><td>save a picture of the window</td></tr>"
      "<tr><td>R</td><td>reset the 3-D view</td></tr>"
      "<tr><td>F</td><td>fit the maps</td></tr>"
      "<tr><td>Drag in the camera picture</td><td>follow the tool in this box; or B, arrows "
      "and Enter</td></tr>"
      "<tr><td>Click in the camera picture</td><td>the tool is here and stays here; right click: "
      "it is not</td></tr></table>");
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
