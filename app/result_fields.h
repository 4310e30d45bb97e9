#pragma once

#include <QJsonObject>
#include <QJsonValue>
#include <vector>

#include "pipeline/result.h"

namespace boomwatch {

/// One key of the JSON line: the line and its schema are loops over these rows.
template <class T>
struct ResultField {
  const char* key;
  QJsonObject type;  ///< as JSON Schema says it; "null" is among its types where it can be absent
  const char* unit;  ///< "" if it has none
  const char* meaning;  ///< a sentence without its full stop
  QJsonValue (*value)(const T&);
};

/// Every key of the JSON line, in the order of the documents. Any thread.
const std::vector<ResultField<Result>>& resultFields();

/// The JSON line as JSON Schema says it: an object with these keys.
QJsonObject resultType();

/// An object with every field of `from`.
template <class T>
QJsonObject valuesOf(const std::vector<ResultField<T>>& fields, const T& from) {
  QJsonObject object;
  for (const ResultField<T>& field : fields) {
    object.insert(QLatin1String(field.key), field.value(from));
  }
  return object;
}

}  // namespace boomwatch
