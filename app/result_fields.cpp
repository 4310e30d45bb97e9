#include "result_fields.h"

#include <QJsonArray>

namespace boomwatch {
namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

QJsonArray point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

// What values are taken from, or null.
template <class Value, class Make>
QJsonValue orNull(const Value& value, Make&& make) {
  return value ? QJsonValue(make(*value)) : QJsonValue();
}
QJsonValue orNull(const std::optional<double>& value) {
  return orNull(value, [](double number) { return number; });
}
template <class Make>
QJsonValue ofNearest(const Result& result, Make&& make) {
  return orNull(result.clearance.nearest, make);
}
QJsonValue vectorOrNull(const std::optional<Eigen::Vector3f>& vector) {
  return orNull(vector, [](const Eigen::Vector3f& v) { return point(v.cast<double>()); });
}

// Types as JSON Schema says them.
QJsonObject type(const char* name) { return {{"type", name}}; }
QJsonObject numbers(int count, const char* item = "number") {
  return {{"type", "array"}, {"items", type(item)}, {"minItems", count}, {"maxItems", count}};
}
QJsonObject orNull(QJsonObject type) {
  type["type"] = QJsonArray{type["type"], "null"};
  if (type.contains("enum")) {
    QJsonArray words = type["enum"].toArray();
    words.append(QJsonValue());
    type["enum"] = words;
  }
  return type;
}

/// The words of an enumeration, none of them left out: those that have a name, from 0 on. Only the
/// first may be "".
template <class Enumeration>
QJsonObject words(std::string_view (*name)(Enumeration)) {
  QJsonArray all;
  for (int k = 0; k == 0 || !name(static_cast<Enumeration>(k)).empty(); ++k) {
    all.append(text(name(static_cast<Enumeration>(k))));
  }
  return {{"type", "string"}, {"enum", all}};
}

template <class T>
QJsonObject objectType(const std::vector<ResultField<T>>& fields) {
  QJsonObject properties;
  QJsonArray required;
  for (const ResultField<T>& field : fields) {
    QJsonObject property = field.type;
    property["description"] = QString::fromUtf8(field.meaning) + QLatin1Char('.');
    if (field.unit[0] != '\0') property["unit"] = QString::fromUtf8(field.unit);
    properties.insert(QLatin1String(field.key), property);
    required.append(QLatin1String(field.key));
  }
  return {{"type", "object"}, {"properties", properties}, {"required", required}};
}

const std::vector<ResultField<ToolTrack>>& toolFields() {
  using Field = ResultField<ToolTrack>;
  static const std::vector<Field> fields{
      {"state", words<TrackState>(toString), "", "What the tracker says of this frame",
       [](const ToolTrack& tool) { return QJsonValue(text(toString(tool.state))); }},
      {"box", orNull(numbers(4)), "px",
       "The tool in the left picture: x, y, width, height; null where it is not seen",
       [](const ToolTrack& tool) {
         return orNull(tool.box, [](const cv::Rect2d& box) {
           return QJsonArray{box.x, box.y, box.width, box.height};
         });
       }},
      {"confidence", orNull(type("number")), "", "Of the box, 0 to 1",
       [](const ToolTrack& tool) {
         return orNull(tool.box, [&](const cv::Rect2d&) { return tool.confidence; });
       }},
      {"pixel", orNull(numbers(2, "integer")), "px",
       "The box's centre in the left picture, or the operator's click",
       [](const ToolTrack& tool) {
         return orNull(tool.pixel, [](const cv::Point& pixel) {
           return QJsonArray{pixel.x, pixel.y};
         });
       }},
      {"point", orNull(numbers(3)), "m", "The tool in the camera's frame",
       [](const ToolTrack& tool) { return vectorOrNull(tool.point); }},
      {"velocity", orNull(numbers(3)), "m/s", "How the point moves",
       [](const ToolTrack& tool) { return vectorOrNull(tool.velocity); }},
      {"age_s", orNull(type("number")), "s",
       "Time since the point was last measured; null: it never was",
       [](const ToolTrack& tool) { return orNull(tool.age); }},
      {"doubted", type("boolean"), "",
       "A depth was measured in the box, but the tool cannot be there",
       [](const ToolTrack& tool) { return QJsonValue(tool.isDoubted); }},
      {"held", type("boolean"), "", "The point is taken from the load that the tool holds",
       [](const ToolTrack& tool) { return QJsonValue(tool.isHeld); }},
      {"given_up", type("boolean"), "",
       "The tracker lost the tool and no longer searches: it must be started again",
       [](const ToolTrack& tool) { return QJsonValue(tool.hasGivenUp); }},
      {"learning", words<LearningState>(toString), "", "Whether the tracker learns from this frame",
       [](const ToolTrack& tool) { return QJsonValue(text(toString(tool.learning))); }},
  };
  return fields;
}

const std::vector<ResultField<Evidence>>& evidenceFields() {
  using Field = ResultField<Evidence>;
  static const std::vector<Field> fields{
      {"cells", type("integer"), "", "Occupied cells of the connected component",
       [](const Evidence& evidence) { return QJsonValue(evidence.cells); }},
      {"area_m2", type("number"), "m2", "Area of these cells across the line of sight",
       [](const Evidence& evidence) { return QJsonValue(evidence.area); }},
      {"extent_m", type("number"), "m", "Diagonal of the component's bounding box",
       [](const Evidence& evidence) { return QJsonValue(evidence.extent); }},
      {"probability", type("number"), "", "Mean occupancy probability of these cells, 0 to 1",
       [](const Evidence& evidence) { return QJsonValue(evidence.probability); }},
      {"confidence", type("number"), "",
       "Confidence of a collision there, 0 to 1: grows with probability and area",
       [](const Evidence& evidence) { return QJsonValue(evidence.confidence); }},
  };
  return fields;
}

const std::vector<ResultField<Watched>>& watchedFields() {
  using Field = ResultField<Watched>;
  static const std::vector<Field> fields{
      {"object", words<WatchedObject>(nameOf), "", "What is watched",
       [](const Watched& watched) { return QJsonValue(text(nameOf(watched.object))); }},
      {"segment", type("integer"), "",
       "Of the boom, 1 is the one at the tool; 0 of everything else",
       [](const Watched& watched) { return QJsonValue(watched.segment); }},
      {"state", words<ClearanceState>(toString), "", "As the line's own state, of this object",
       [](const Watched& watched) { return QJsonValue(text(toString(watched.clearance.state))); }},
      {"reason", words<Reason>(toString), "", "Why the state is unknown; empty where it is not",
       [](const Watched& watched) { return QJsonValue(text(toString(watched.clearance.reason))); }},
      {"distance_m", orNull(type("number")), "m", "Distance of this object to the nearest obstacle",
       [](const Watched& watched) {
         return orNull(watched.clearance.nearest, [](const Nearest& one) { return one.distance; });
       }},
      {"centre", orNull(numbers(3)), "m", "Centre of its box in the camera's frame",
       [](const Watched& watched) {
         return orNull(watched.box, [](const OrientedBox& box) { return point(box.centre); });
       }},
  };
  return fields;
}

/// Which frame, and what came of it.
std::vector<ResultField<Result>> stateFields() {
  return {
      {"frame", orNull(type("integer")), "", "Index of the frame in its source, from 0",
       [](const Result& result) {
         return orNull(result.frame,
                       [](const Frame& frame) { return static_cast<qint64>(frame.sequence); });
       }},
      {"stamp", orNull(type("number")), "s", "Time of the frame on the source's own clock",
       [](const Result& result) {
         return orNull(result.frame, [](const Frame& frame) { return frame.stamp; });
       }},
      {"state", words<ClearanceState>(toString), "", "Whether there is a distance",
       [](const Result& result) { return QJsonValue(text(toString(result.clearance.state))); }},
      {"reason", words<Reason>(toString), "", "Why the state is unknown; empty where it is not",
       [](const Result& result) { return QJsonValue(text(toString(result.clearance.reason))); }},
      {"level", words<WarningLevel>(toString), "", "The alarm",
       [](const Result& result) { return QJsonValue(text(toString(result.level))); }},
      {"message", type("string"), "", "English detail of a fault in this frame; empty without one",
       [](const Result& result) { return QJsonValue(QString::fromStdString(result.message)); }},
      {"timings_ms",
       {{"type", "object"}, {"additionalProperties", type("number")}},
       "ms",
       "Time that each stage took, by its name",
       [](const Result& result) {
         QJsonObject timings;
         for (const StageTiming& timing : result.timings) {
           timings[text(timing.stage)] = timing.milliseconds;
         }
         return QJsonValue(timings);
       }},
  };
}

/// The shortest line.
std::vector<ResultField<Result>> distanceFields() {
  return {
      {"distance_m", orNull(type("number")), "m",
       "Distance to the nearest obstacle; 0: it is inside the load's box; null: none is known",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return one.distance; });
       }},
      {"nearest", orNull(numbers(3)), "m", "The nearest point of the environment, camera frame",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return point(one.onEnvironment); });
       }},
      {"on_load", orNull(numbers(3)), "m", "The point of the load that is nearest to it",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return point(one.onLoad); });
       }},
      {"part", orNull(words<LoadPart>(toString)), "", "The part of the load's box that is nearest",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return text(toString(one.part)); });
       }},
      {"uncertainty_m", orNull(type("number")), "m",
       "Maximum error, plus or minus, from the size of a cell and of a depth level",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return one.quantisation; });
       }},
      {"depth_uncertainty_m", orNull(type("number")), "m",
       "Depth error at the nearest point from a quarter of a pixel of disparity; stereo only",
       [](const Result& result) { return orNull(result.depthUncertainty); }},
  };
}

/// What the distance is taken from, and how far it can be trusted.
std::vector<ResultField<Result>> environmentFields() {
  return {
      {"unseen", orNull(type("boolean")), "",
       "The nearest is unobserved space that counts as occupied (unknown_space)",
       [](const Result& result) {
         return ofNearest(result, [](const Nearest& one) { return one.unseen; });
       }},
      {"evidence", orNull(objectType(evidenceFields())), "",
       "The connected component of the model that the nearest point belongs to",
       [](const Result& result) {
         return orNull(result.clearance.evidence, [](const Evidence& evidence) {
           return valuesOf(evidenceFields(), evidence);
         });
       }},
      {"observed_share", orNull(type("number")), "",
       "Share of the searched neighbourhood that was ever observed, 0 to 1",
       [](const Result& result) { return orNull(result.clearance.observedShare); }},
      {"leading", orNull(words<WatchedObject>(nameOf)), "",
       "Of what is watched, the object whose distance this is",
       [](const Result& result) {
         if (result.watched.empty()) return QJsonValue();
         return QJsonValue(text(nameOf(result.watched[result.leading].object)));
       }},
      {"watched",
       {{"type", "array"}, {"items", objectType(watchedFields())}},
       "",
       "All that is watched, the load first; empty where nothing is known",
       [](const Result& result) {
         QJsonArray list;
         for (const Watched& one : result.watched) list.append(valuesOf(watchedFields(), one));
         return QJsonValue(list);
       }},
      {"suppressed_cells", type("integer"), "",
       "Occupied cells of the model that are ignored (smallest_thing, doubtful_thing)",
       [](const Result& result) {
         return QJsonValue(static_cast<qint64>(result.suppressed.size()));
       }},
      {"truth_m", orNull(type("number")), "m", "The true distance, of simulated frames",
       [](const Result& result) {
         return result.frame ? orNull(result.frame->trueDistance) : QJsonValue();
       }},
  };
}

/// Load and tool, and how they move.
std::vector<ResultField<Result>> loadFields() {
  return {
      {"velocity_m_s", orNull(numbers(3)), "m/s", "Velocity of the load, camera frame",
       [](const Result& result) {
         return orNull(result.approach, [](const Approach& one) { return point(one.velocity); });
       }},
      {"closing_m_s", orNull(type("number")), "m/s", "Speed towards the nearest point",
       [](const Result& result) {
         return result.approach ? orNull(result.approach->closingSpeed) : QJsonValue();
       }},
      {"time_to_contact_s", orNull(type("number")), "s",
       "Time until the load, as it moves now, touches the environment",
       [](const Result& result) {
         return result.approach ? orNull(result.approach->timeToContact) : QJsonValue();
       }},
      {"load_fault", words<LoadFault>(toString), "",
       "Why this frame does not show the load that is to be detected; empty where it does",
       [](const Result& result) { return QJsonValue(text(toString(result.loadFault))); }},
      {"load_age_s", orNull(type("number")), "s",
       "Time since the load was last seen; null unless it is detected",
       [](const Result& result) { return orNull(result.loadAge); }},
      {"load_centre", orNull(numbers(3)), "m", "Centre of the load's box, camera frame",
       [](const Result& result) {
         return orNull(result.load, [](const OrientedBox& box) { return point(box.centre); });
       }},
      {"load_size", orNull(numbers(3)), "m", "Full sizes along the box's own x, y, z",
       [](const Result& result) {
         return orNull(result.load, [](const OrientedBox& box) { return point(box.size); });
       }},
      {"load_axis", orNull(numbers(3)), "", "The box's own x as a unit vector, camera frame",
       [](const Result& result) {
         return orNull(result.load,
                       [](const OrientedBox& box) { return point(box.rotation.col(0)); });
       }},
      {"tool", orNull(objectType(toolFields())), "", "The tool; null without a frame",
       [](const Result& result) {
         return result.frame ? QJsonValue(valuesOf(toolFields(), result.tool)) : QJsonValue();
       }},
      {"tool_mask", orNull(words<ToolMask>(nameOf)), "", "Whether the tool's points are masked",
       [](const Result& result) {
         return result.cloud ? QJsonValue(text(nameOf(result.scene.toolMask))) : QJsonValue();
       }},
  };
}

/// The cloud that all this is taken from.
std::vector<ResultField<Result>> cloudFields() {
  return {
      {"removed_share", orNull(type("number")), "",
       "Share of the points inside the bounds that are masked as boom, tool and load, 0 to 1",
       [](const Result& result) {
         return result.cloud ? QJsonValue(result.removedShare) : QJsonValue();
       }},
      {"fill", orNull(type("number")), "", "Share of the pixels that have a depth, 0 to 1",
       [](const Result& result) { return result.cloud ? QJsonValue(result.fill) : QJsonValue(); }},
      {"row_residue_px", orNull(type("number")), "px",
       "Row misalignment of a rectified pair by the calibration",
       [](const Result& result) { return orNull(result.rowResidue); }},
      {"rows_corrected_px", orNull(type("number")), "px",
       "What is left of it where it is corrected",
       [](const Result& result) { return orNull(result.rowsCorrected); }},
  };
}

}  // namespace

const std::vector<ResultField<Result>>& resultFields() {
  static const std::vector<ResultField<Result>> all = [] {
    std::vector<ResultField<Result>> fields = stateFields();
    for (const auto& more : {distanceFields(), environmentFields(), loadFields(), cloudFields()}) {
      fields.insert(fields.end(), more.begin(), more.end());
    }
    return fields;
  }();
  return all;
}

QJsonObject resultType() { return objectType(resultFields()); }

}  // namespace boomwatch
