#include "result_json.h"

#include <QJsonDocument>

#include "result_fields.h"

namespace boomwatch {

QByteArray toJsonLine(const Result& result) {
  return QJsonDocument(valuesOf(resultFields(), result)).toJson(QJsonDocument::Compact);
}

std::string resultSchema() {
  QJsonObject schema = resultType();
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Boomwatch result";
  schema["description"] =
      "One line of boomwatch --headless --output FILE, a frame each. What is not known is null. "
      "Lengths are metres in the left camera's frame: x right, y down, z ahead.";
  return QJsonDocument(schema).toJson(QJsonDocument::Indented).toStdString();
}

}  // namespace boomwatch
