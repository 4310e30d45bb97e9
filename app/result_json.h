#pragma once

#include <QByteArray>
#include <string>

#include "pipeline/result.h"

namespace boomwatch {

/// One JSON object on one line, without the line end. docs/result.schema.json says what its keys
/// mean, from the same table (result_fields.h). What is not known is null.
QByteArray toJsonLine(const Result& result);

/// docs/result.schema.json: the line as JSON Schema.
std::string resultSchema();

}  // namespace boomwatch
