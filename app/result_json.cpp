#include "result_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace boomwatch {
namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

QJsonValue number(const std::optional<double>& value) {
  return value ? QJsonValue(*value) : QJsonValue();
}

QJsonArray point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

QJsonValue toolObject(const ToolTrack& tool) {
  const QJsonValue none;
  const auto vector = [&](const std::optional<Eigen::Vector3f>& v) {
    return v ? QJsonValue(point(v->cast<double>())) : none;
  };
  const auto& box = tool.box;
  return QJsonObject{
      {"state", text(toString(tool.state))},
      {"box", box ? QJsonValue(QJsonArray{box->x, box->y, box->width, box->height}) : none},
      {"confidence", box ? QJsonValue(tool.confidence) : none},
      {"pixel", tool.pixel ? QJsonValue(QJsonArray{tool.pixel->x, tool.pixel->y}) : none},
      {"point", vector(tool.point)},
      {"velocity", vector(tool.velocity)},
      {"age_s", number(tool.age)},
      {"doubted", tool.isDoubted},
      {"held", tool.isHeld},
      {"given_up", tool.hasGivenUp},
      {"learning", text(toString(tool.learning))},
  };
}

QJsonValue evidenceObject(const std::optional<Evidence>& evidence) {
  if (!evidence) return {};
  return QJsonObject{{"cells", evidence->cells},
                     {"area_m2", evidence->area},
                     {"extent_m", evidence->extent},
                     {"probability", evidence->probability},
                     {"confidence", evidence->confidence}};
}

const Watched& leading(const Result& result) { return result.watched[result.leading]; }

QJsonArray watchedList(const Result& result) {
  QJsonArray list;
  for (const Watched& watched : result.watched) {
    const auto& nearest = watched.clearance.nearest;
    list.append(QJsonObject{
        {"object", text(nameOf(watched.object))},
        {"segment", watched.segment},
        {"state", text(toString(watched.clearance.state))},
        {"reason", text(toString(watched.clearance.reason))},
        {"distance_m", nearest ? QJsonValue(nearest->distance) : QJsonValue()},
        {"centre", watched.box ? QJsonValue(point(watched.box->centre)) : QJsonValue()}});
  }
  return list;
}

}  // namespace

QByteArray toJsonLine(const Result& result) {
  const Clearance& clearance = result.clearance;
  const std::optional<Nearest>& nearest = clearance.nearest;
  const std::optional<Approach>& approach = result.approach;
  QJsonObject timings;
  for (const StageTiming& timing : result.timings) {
    timings[text(timing.stage)] = timing.milliseconds;
  }
  const QJsonValue none;
  const QJsonObject line{
      {"frame", result.frame ? QJsonValue(static_cast<qint64>(result.frame->sequence)) : none},
      {"stamp", result.frame ? QJsonValue(result.frame->stamp) : none},
      {"state", text(toString(clearance.state))},
      {"reason", text(toString(clearance.reason))},
      {"distance_m", nearest ? QJsonValue(nearest->distance) : none},
      {"nearest", nearest ? QJsonValue(point(nearest->onEnvironment)) : none},
      {"on_load", nearest ? QJsonValue(point(nearest->onLoad)) : none},
      {"part", nearest ? QJsonValue(text(toString(nearest->part))) : none},
      {"uncertainty_m", nearest ? QJsonValue(nearest->quantisation) : none},
      {"depth_uncertainty_m", number(result.depthUncertainty)},
      {"level", text(toString(result.level))},
      {"unseen", nearest ? QJsonValue(nearest->unseen) : none},
      {"evidence", evidenceObject(clearance.evidence)},
      {"leading", result.watched.empty() ? none : QJsonValue(text(nameOf(leading(result).object)))},
      {"watched", watchedList(result)},
      {"suppressed_cells", static_cast<qint64>(result.suppressed.size())},
      {"velocity_m_s", approach ? QJsonValue(point(approach->velocity)) : none},
      {"closing_m_s", approach ? number(approach->closingSpeed) : none},
      {"time_to_contact_s", approach ? number(approach->timeToContact) : none},
      {"observed_share", number(clearance.observedShare)},
      {"load_fault", text(toString(result.loadFault))},
      {"load_age_s", number(result.loadAge)},
      {"load_centre", result.load ? QJsonValue(point(result.load->centre)) : none},
      {"load_size", result.load ? QJsonValue(point(result.load->size)) : none},
      {"load_axis", result.load ? QJsonValue(point(result.load->rotation.col(0))) : none},
      {"removed_share", result.cloud ? QJsonValue(result.removedShare) : none},
      {"fill", result.cloud ? QJsonValue(result.fill) : none},
      {"truth_m",
       result.frame && result.frame->truth ? QJsonValue(result.frame->truth->distance) : none},
      {"row_residue_px", number(result.rowResidue)},
      {"rows_corrected_px", number(result.rowsCorrected)},
      {"tool", result.frame ? toolObject(result.tool) : none},
      {"tool_mask", result.cloud ? QJsonValue(text(nameOf(result.scene.toolMask))) : none},
      {"message", QString::fromStdString(result.message)},
      {"timings_ms", timings},
  };
  return QJsonDocument(line).toJson(QJsonDocument::Compact);
}

}  // namespace boomwatch
