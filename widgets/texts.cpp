#include "texts.h"

#include <QCoreApplication>
#include <QLocale>

namespace boomwatch {
namespace {

class Texts {
  Q_DECLARE_TR_FUNCTIONS(Texts)
};

}  // namespace

QString reasonTitle(Reason reason) {
  switch (reason) {
    case Reason::None:
      return {};
    case Reason::NoFrame:
      return Texts::tr("No frames arrive");
    case Reason::UnreadableFrame:
      return Texts::tr("Unreadable frame");
    case Reason::IdenticalFrames:
      return Texts::tr("Frozen picture");
    case Reason::FewDepthPixels:
      return Texts::tr("Too little depth");
    case Reason::SceneMoves:
      return Texts::tr("Camera moves");
    case Reason::ToolLost:
      return Texts::tr("Tool lost");
    case Reason::NoTool:
      return Texts::tr("No tool selected");
    case Reason::NoLoad:
      return Texts::tr("No load");
    case Reason::LoadNotSeen:
      return Texts::tr("Load not detected");
    case Reason::LoadOutside:
      return Texts::tr("Load out of bounds");
    case Reason::ToolNotSeen:
      return Texts::tr("Tool not found");
    case Reason::NoModel:
      return Texts::tr("Building the model");
    case Reason::SearchTooShort:
      return Texts::tr("Search too short");
    case Reason::NothingObserved:
      return Texts::tr("Unobserved");
  }
  return {};
}

QString reasonText(Reason reason) {
  switch (reason) {
    case Reason::None:
      return {};
    case Reason::NoFrame:
      return Texts::tr(
          "The source delivers no frames. Check the camera and its cable, or press Play.");
    case Reason::UnreadableFrame:
      return Texts::tr("The source could not read this frame. Check the recording or the camera.");
    case Reason::IdenticalFrames:
      return Texts::tr(
          "The source repeats the same picture. Check the camera, then open it again.");
    case Reason::FewDepthPixels:
      return Texts::tr("Too few pixels have a depth. Check light, lenses and calibration.");
    case Reason::SceneMoves:
      return Texts::tr("The whole picture moves, so the camera moves. Keep it still and wait.");
    case Reason::ToolLost:
      return Texts::tr(
          "Boom and load cannot be masked without the tool. Bring the tool into sight, or draw its "
          "box again.");
    case Reason::NoTool:
      return Texts::tr(
          "The load is found from the tool. Draw a box around the tool in the camera view.");
    case Reason::NoLoad:
      return Texts::tr(
          "The position of the load is not set. Draw a box around the tool that holds it, or enter "
          "the load in the parameters.");
    case Reason::LoadNotSeen:
      return Texts::tr(
          "No load was detected at the tool. Turn the load into view, or enter its sizes and lock "
          "them.");
    case Reason::LoadOutside:
      return Texts::tr("The load is outside the bounds. Move it or widen the bounds.");
    case Reason::ToolNotSeen:
      return Texts::tr(
          "Tool or boom is watched but was not found in the cloud. Track the tool, or watch only "
          "the load.");
    case Reason::NoModel:
      return Texts::tr(
          "The model has too few frames so far. Wait a moment. If this message stays, lower "
          "probtresh.");
    case Reason::SearchTooShort:
      return Texts::tr(
          "No obstacle was found, but the search ends before the caution distance. Raise the ray "
          "length or the search range.");
    case Reason::NothingObserved:
      return Texts::tr(
          "Too little of the space around the load was observed. Turn the camera towards it.");
  }
  return {};
}

QString loadFaultText(LoadFault fault) {
  switch (fault) {
    case LoadFault::None:
      return {};
    case LoadFault::NoToolPoint:
      return Texts::tr("The position of the tool is unknown.");
    case LoadFault::NothingAtTool:
      return Texts::tr("No point was measured at the tool.");
    case LoadFault::OnSurface:
      return Texts::tr("The tool point lies on the ground or a wall.");
    case LoadFault::NoBody:
      return Texts::tr("The tool is empty: no load extends from it.");
    case LoadFault::EndOn:
      return Texts::tr("The load points at the camera, which cannot see its length.");
    case LoadFault::EndHidden:
      return Texts::tr("An end of the load is occluded or outside the picture.");
    case LoadFault::DepthHidden:
      return Texts::tr("Only one face of the load is visible.");
    case LoadFault::FewPoints:
      return Texts::tr("Too few points were measured on the load.");
    case LoadFault::PoorFit:
      return Texts::tr("The body at the tool does not have the shape of a load.");
    case LoadFault::TooLarge:
      return Texts::tr("The body at the tool is too large for a load.");
    case LoadFault::OutsideBounds:
      return Texts::tr("The load is outside the bounds.");
  }
  return {};
}

QString levelText(WarningLevel level) {
  switch (level) {
    case WarningLevel::Clear:
      return Texts::tr("Clear");
    case WarningLevel::Caution:
      return Texts::tr("Caution");
    case WarningLevel::Warning:
      return Texts::tr("Warning");
    case WarningLevel::Collision:
      return Texts::tr("Collision");
    case WarningLevel::NoDistance:
      return Texts::tr("No distance");
  }
  return {};
}

QString stageText(std::string_view stage) {
  if (stage == "stereo") return Texts::tr("stereo");
  if (stage == "checks") return Texts::tr("checks");
  if (stage == "tool") return Texts::tr("tool");
  if (stage == "load") return Texts::tr("load");
  if (stage == "filter") return Texts::tr("filter");
  if (stage == "crane") return Texts::tr("crane");
  if (stage == "model") return Texts::tr("model");
  if (stage == "clearance") return Texts::tr("clearance");
  return QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
}

QString partText(LoadPart part) {
  switch (part) {
    case LoadPart::Inside:
      return Texts::tr("inside the load");
    case LoadPart::Face:
      return Texts::tr("a face of the load");
    case LoadPart::Edge:
      return Texts::tr("an edge of the load");
    case LoadPart::Corner:
      return Texts::tr("a corner of the load");
  }
  return {};
}

QString watchedText(const Watched& watched) {
  switch (watched.object) {
    case WatchedObject::Load:
      return Texts::tr("load");
    case WatchedObject::Tool:
      return Texts::tr("tool");
    case WatchedObject::Boom:
      return watched.segment > 0 ? Texts::tr("boom %1").arg(watched.segment) : Texts::tr("boom");
  }
  return {};
}

QString watchedDistance(const Watched& watched) {
  const QString name = watchedText(watched);
  switch (watched.clearance.state) {
    case ClearanceState::Measured:
      return Texts::tr("%1: %2").arg(name, metresText(watched.clearance.nearest->distance));
    case ClearanceState::NothingInRange:
      return Texts::tr("%1: no obstacle in range").arg(name);
    case ClearanceState::Unknown:
      return Texts::tr("%1: %2").arg(name, reasonTitle(watched.clearance.reason));
  }
  return {};
}

QString cellText(CellState state) {
  switch (state) {
    case CellState::NeverObserved:
      return Texts::tr("unobserved");
    case CellState::ObservedFree:
      return Texts::tr("observed, free");
    case CellState::Occupied:
      return Texts::tr("occupied");
  }
  return {};
}

QString metresText(double metres) {
  return Texts::tr("%1 m").arg(QLocale().toString(metres, 'f', 2));
}

}  // namespace boomwatch
