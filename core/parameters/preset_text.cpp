#include "parameters/preset_text.h"

#include <yaml-cpp/yaml.h>

#include <set>
#include <sstream>

#include "base/error.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"

namespace boomwatch {
namespace {

std::string place(const std::string& file, const YAML::Mark& mark) {
  return mark.is_null() ? file : file + ", line " + std::to_string(mark.line + 1);
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
  refuseWholeFile(where, [&] {
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

Parameters parsePreset(const std::string& text, const std::string& name, const Parameters& base) {
  const YAML::Node root = parseYaml(name, text);
  if (!root.IsMap()) throw Error(name, "not a preset", "Write 'key: value' lines.");
  Parameters parameters = base;
  std::set<std::string> seen;
  for (const auto& entry : root) readEntry(name, entry.first, entry.second, seen, parameters);
  return parameters;
}

std::string presetText(const Parameters& parameters) {
  std::ostringstream out;
  writeAll(out, parameters);
  return out.str();
}

void refuseWholeFile(const std::string& where, const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    std::string what = error.what();
    if (what.ends_with('.')) what.pop_back();
    throw Error(where, what, "Nothing of this file was loaded.");
  }
}

}  // namespace boomwatch
