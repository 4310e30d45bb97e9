#include "parameter_document.h"

#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "report/text_table.h"

namespace boomwatch {

std::string parameterDocument() {
  std::string text =
      "# Parameters\n\n`boomwatch --print parameters` writes this page; `packaging/dev docs` "
      "updates it.\n\nA preset (YAML) holds lines `key: value`, `--parameters FILE` reads it, "
      "`--set key=value` sets one.\n";
  const Parameters defaults;
  std::string group;
  for (const ParameterInfo& info : parameterTable()) {
    if (group != info.group) {
      group = info.group;
      const Cells headings{"Key", "Title", "Range", "Default", "Meaning"};
      text += "\n## " + group + "\n\n" + markdownLine(headings) +
              markdownRule(headings.size(), headings.size());
    }
    std::string key = "`";
    key.append(info.key).append("`");
    text += markdownLine(Cells{key, info.label, rangeText(info),
                               formatValue(info, info.get(defaults)), info.tooltip});
  }
  return text;
}

}  // namespace boomwatch
