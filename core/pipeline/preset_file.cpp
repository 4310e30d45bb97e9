#include "pipeline/preset_file.h"

#include "base/error.h"
#include "files/file_bytes.h"
#include "parameters/preset_text.h"
#include "pipeline/parameter_checks.h"

namespace boomwatch {

Parameters loadPreset(const std::filesystem::path& file, const Parameters& base) {
  constexpr std::size_t maxPreset = 1 << 20;
  const std::string name = file.string();
  const Parameters parameters = parsePreset(readFileBytes(file, maxPreset), name, base);
  refuseWholeFile(name, [&] { validate(parameters); });
  return parameters;
}

void savePreset(const std::filesystem::path& file, const Parameters& parameters) {
  if (replaceFile(file, presetText(parameters))) return;
  throw Error(file.string(), "the preset cannot be written",
              "Check that the folder exists, may be written to and is not full.");
}

}  // namespace boomwatch
