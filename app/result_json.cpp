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
      {"velocity_m_s", approach ? QJsonValue(point(approach->velocity)) : none},
      {"closing_m_s", approach ? number(approach->closingSpeed) : none},
      {"time_to_contact_s", approach ? number(approach->timeToContact) : none},
      {"observed_share", number(clearance.observedShare)},
      {"fill", result.cloud ? QJsonValue(result.fill) : none},
      {"truth_m",
       result.frame && result.frame->truth ? QJsonValue(result.frame->truth->distance) : none},
      {"row_residue_px", number(result.rowResidue)},
      {"rows_corrected_px", number(result.rowsCorrected)},
      {"message", QString::fromStdString(result.message)},
      {"timings_ms", timings},
  };
  return QJsonDocument(line).toJson(QJsonDocument::Compact);
}

}  // namespace boomwatch
