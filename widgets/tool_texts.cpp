#include "tool_texts.h"

#include <QCoreApplication>
#include <QLocale>

#include "load/held_tool.h"
#include "tracking/tool_model.h"

namespace boomwatch {
namespace {

class ToolTexts {
  Q_DECLARE_TR_FUNCTIONS(ToolTexts)
};

QString percent(double share) {
  return ToolTexts::tr("%1 %").arg(QLocale().toString(100.0 * share, 'f', 0));
}

QString seconds(double value) {
  return ToolTexts::tr("%1 s").arg(QLocale().toString(value, 'f', 1));
}

/// With a box, but for some time no depth that can be the tool's.
QString unlocatedText(const ToolTrack& tool) {
  const QString text = tool.isDoubted ? ToolTexts::tr("Tool seen, but for %1 where it cannot be")
                                      : ToolTexts::tr("Tool seen, but not its depth for %1");
  return text.arg(seconds(*tool.age));
}

/// While a tracker runs that does not know where the tool is.
QString lostSentence(const ToolTrack& tool) {
  if (tool.hasGivenUp) {
    return ToolTexts::tr(
        "Tool lost and no longer looked for: begin again, or draw a new box. Until then there is "
        "no distance.");
  }
  if (!tool.age && !tool.box) {
    return ToolTexts::tr(
        "Tool not found yet: boom and load are not taken out of the cloud, so there is no "
        "distance.");
  }
  if (!tool.age) {
    return ToolTexts::tr(
        "Tool seen, but not its depth: boom and load are not taken out of the cloud, so there is "
        "no distance.");
  }
  const QString what =
      tool.box ? unlocatedText(tool) : ToolTexts::tr("Tool lost for %1").arg(seconds(*tool.age));
  return ToolTexts::tr(
             "%1: boom and load are no longer taken out of the cloud, so there is no distance.")
      .arg(what);
}

QString knownSentence(const ToolTrack& tool, const TrackingParameters& parameters) {
  if (tool.age == 0.0) {
    return tool.state == TrackState::Refound
               ? ToolTexts::tr("Tool found again, confidence %1.").arg(percent(tool.confidence))
               : ToolTexts::tr("Tool tracked, confidence %1.").arg(percent(tool.confidence));
  }
  const QString what = tool.box ? unlocatedText(tool)
                                : ToolTexts::tr("Tool not seen for %1").arg(seconds(*tool.age));
  if (tool.isHeld) {
    return what +
           ToolTexts::tr(": taken to be at the load, which is seen. At %1 it counts as lost.")
               .arg(seconds(HeldTool::maxHold));
  }
  return what + ToolTexts::tr(": taken to go on as it moved. At %1 it counts as lost.")
                    .arg(seconds(parameters.maxToolAge));
}

}  // namespace

QString trackerText(TrackerKind kind) {
  switch (kind) {
    case TrackerKind::Manual:
      return ToolTexts::tr("manual: the click stays where it is");
    case TrackerKind::Tld:
      return ToolTexts::tr("tld: learns, finds again, can be saved");
    case TrackerKind::Cmt:
      return ToolTexts::tr("cmt: turns and grows with the tool");
    case TrackerKind::Klt:
      return ToolTexts::tr("klt: fast, follows only");
    case TrackerKind::Csrt:
      return ToolTexts::tr("csrt: exact, slow, follows only");
  }
  return {};
}

QString toolLabel(const ToolTrack& tool) {
  if (!tool.box) return {};
  const QString text = tool.state == TrackState::Refound ? ToolTexts::tr("Tool found again %1")
                                                         : ToolTexts::tr("Tool %1");
  QString label = text.arg(percent(tool.confidence));
  if (tool.age == 0.0) return label;
  return label +
         (tool.isDoubted ? ToolTexts::tr(", cannot be there") : ToolTexts::tr(", no depth"));
}

QString toolSentence(const ToolTrack& tool, const TrackingParameters& parameters) {
  if (!tool.running()) {
    return tool.pixel ? ToolTexts::tr("The tool is where it was clicked; nothing follows it.")
                      : ToolTexts::tr("No tool: draw a box around it in the camera picture.");
  }
  return tool.lost() ? lostSentence(tool) : knownSentence(tool, parameters);
}

QString learningSentence(LearningState state) {
  switch (state) {
    case LearningState::None:
      return ToolTexts::tr("Learning: this tracker learns nothing.");
    case LearningState::Off:
      return ToolTexts::tr("Learning is off: only what is known by now counts.");
    case LearningState::On:
      return ToolTexts::tr("Learning from what it sees.");
    case LearningState::Suspended:
      return ToolTexts::tr(
          "Learning is suspended: what is seen is not sure enough to learn from. It goes on by "
          "itself.");
  }
  return {};
}

QString modelText(const ToolModel& model) {
  return ToolTexts::tr("Model: views of the tool %1, of other things %2.")
      .arg(model.positives.size())
      .arg(model.negatives.size());
}

}  // namespace boomwatch
