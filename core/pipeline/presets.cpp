#include "pipeline/presets.h"

#include <yaml-cpp/yaml.h>

#include <set>
#include <sstream>

#include "files/file_bytes.h"
#include "frame/error.h"
#include "pipeline/parameter_table.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxPreset = 1 << 20;

std::string place(const std::string& file, const YAML::Mark& mark) {
  return mark.is_null() ? file : file + ", line " + std::to_string(mark.line + 1);
}

/// Runs `work`; an Error it throws is thrown again with the place put before it.
template <class Work>
void at(const std::string& where, Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    std::string what = error.what();
    if (what.ends_with('.')) what.pop_back();
    throw Error(where, what, "Nothing of this file was loaded.");
  }
}

YAML::Node parseYaml(const std::string& file, const std::string& text) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw Error(place(file, error.mark), "not YAML: " + error.msg, "Write 'key: value' lines.");
  }
}

void readEntry(const std::string& file, const YAML::Node& key, const YAML::Node& value,
               std::set<std::string>& seen, Parameters& parameters) {
  const std::string where = place(file, key.Mark());
  if (!key.IsScalar()) throw Error(where, "a key is not a word", "Write 'key: value' lines.");
  at(where, [&] {
    const ParameterInfo& info = findParameter(key.Scalar());
    if (!seen.insert(key.Scalar()).second) {
      throw Error("parameter '" + key.Scalar() + "'", "it is given twice",
                  "Remove one of the two.");
    }
    if (!value.IsScalar()) {
      throw Error("parameter '" + key.Scalar() + "'",
                  "its value is not one of " + rangeText(info) + " but empty, a list or a map",
                  "Give one value.");
    }
    info.set(parameters, parseValue(info, value.Scalar()));
  });
}

void writeAll(std::ostream& out, const Parameters& parameters) {
  std::string_view group;
  for (const ParameterInfo& info : parameterTable()) {
    if (group != info.group) {
      out << (group.empty() ? "" : "\n") << "# " << info.group << '\n';
      group = info.group;
    }
    out << info.key << ": " << formatValue(info, info.get(parameters)) << '\n';
  }
}

}  // namespace

Parameters loadPreset(const std::filesystem::path& file, const Parameters& base) {
  const std::string name = file.string();
  const YAML::Node root = parseYaml(name, readFileBytes(file, maxPreset));
  if (!root.IsMap()) throw Error(name, "not a preset", "Write 'key: value' lines.");
  Parameters parameters = base;
  std::set<std::string> seen;
  for (const auto& entry : root) readEntry(name, entry.first, entry.second, seen, parameters);
  at(name, [&] { validate(parameters); });
  return parameters;
}

void savePreset(const std::filesystem::path& file, const Parameters& parameters) {
  std::ostringstream out;
  writeAll(out, parameters);
  if (replaceFile(file, out.str())) return;
  throw Error(file.string(), "the preset cannot be written",
              "Check that the folder exists, may be written to and is not full.");
}

}  // namespace boomwatch
