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

/// The tracker has a box, but no accepted depth in it for some time.
QString unlocatedText(const ToolTrack& tool) {
  const QString text = tool.isDoubted ? ToolTexts::tr("Tool position rejected for %1")
                                      : ToolTexts::tr("Tool without depth for %1");
  return text.arg(seconds(*tool.age));
}

/// A tracker runs, and the position of the tool is unknown.
QString lostSentence(const ToolTrack& tool) {
  if (tool.hasGivenUp) {
    return ToolTexts::tr(
        "Tool lost, and the tracker has stopped. Restart it or draw a new box. Until then there is "
        "no distance.");
  }
  if (!tool.age && !tool.box) {
    return ToolTexts::tr(
        "Tool not found yet: boom and load cannot be masked, so there is no distance.");
  }
  if (!tool.age) {
    return ToolTexts::tr(
        "Tool without depth: boom and load cannot be masked, so there is no distance.");
  }
  const QString what =
      tool.box ? unlocatedText(tool) : ToolTexts::tr("Tool lost for %1").arg(seconds(*tool.age));
  return ToolTexts::tr("%1: boom and load cannot be masked, so there is no distance.").arg(what);
}

/// A tracker runs, and the position of the tool is measured, extrapolated or derived.
QString knownSentence(const ToolTrack& tool, const TrackingParameters& parameters) {
  if (tool.age == 0.0) {
    return tool.state == TrackState::Refound
               ? ToolTexts::tr("Tool re-detected, confidence %1.").arg(percent(tool.confidence))
               : ToolTexts::tr("Tool tracked, confidence %1.").arg(percent(tool.confidence));
  }
  const QString what = tool.box ? unlocatedText(tool)
                                : ToolTexts::tr("Tool out of sight for %1").arg(seconds(*tool.age));
  if (tool.isHeld) {
    return what + ToolTexts::tr(": its position is derived from the load. After %1 it is lost.")
                      .arg(seconds(HeldTool::maxHold));
  }
  return what + ToolTexts::tr(": its position is extrapolated. After %1 it is lost.")
                    .arg(seconds(parameters.maxToolAge));
}

}  // namespace

QString trackerText(TrackerKind kind) {
  switch (kind) {
    case TrackerKind::Manual:
      return ToolTexts::tr("manual: the clicked pixel stays");
    case TrackerKind::Tld:
      return ToolTexts::tr("tld: learns, re-detects, can be saved");
    case TrackerKind::Cmt:
      return ToolTexts::tr("cmt: tracks rotation and size");
    case TrackerKind::Klt:
      return ToolTexts::tr("klt: fast, no re-detection");
    case TrackerKind::Csrt:
      return ToolTexts::tr("csrt: accurate, slow, no re-detection");
  }
  return {};
}

QString toolLabel(const ToolTrack& tool) {
  if (!tool.box) return {};
  const QString text = tool.state == TrackState::Refound ? ToolTexts::tr("Tool re-detected %1")
                                                         : ToolTexts::tr("Tool %1");
  QString label = text.arg(percent(tool.confidence));
  if (tool.age == 0.0) return label;
  return label + (tool.isDoubted ? ToolTexts::tr(", rejected") : ToolTexts::tr(", no depth"));
}

QString toolSentence(const ToolTrack& tool, const TrackingParameters& parameters) {
  if (!tool.running()) {
    return tool.pixel ? ToolTexts::tr("The tool stays at the clicked pixel and is not tracked.")
                      : ToolTexts::tr("No tool selected: draw a box around it in the camera view.");
  }
  return tool.lost() ? lostSentence(tool) : knownSentence(tool, parameters);
}

QString learningSentence(LearningState state) {
  switch (state) {
    case LearningState::None:
      return ToolTexts::tr("This tracker does not learn.");
    case LearningState::Off:
      return ToolTexts::tr("Learning is off: the tracker uses only the views learnt so far.");
    case LearningState::On:
      return ToolTexts::tr("Learning new views of the tool.");
    case LearningState::Suspended:
      return ToolTexts::tr(
          "Learning is suspended: the tracker is not sure enough of the tool. It resumes by "
          "itself.");
  }
  return {};
}

QString modelText(const ToolModel& model) {
  return ToolTexts::tr("Model: %1 views of the tool, %2 of the background.")
      .arg(model.positives.size())
      .arg(model.negatives.size());
}

}  // namespace boomwatch
