#include "program/program_arguments.h"

#include <QCommandLineOption>

#include "base/error.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "pipeline/preset_file.h"
#include "simulation/yard/yard_options.h"

namespace boomwatch {

bool parseArguments(QCommandLineParser& parser, const ProgramCommand& command,
                    const QStringList& arguments) {
  for (const ProgramOption& option : command.options) {
    QStringList names{QString::fromStdString(option.name)};
    if (option.name == "help") names << QStringLiteral("h");
    parser.addOption(QCommandLineOption(names, QString::fromStdString(option.text),
                                        QString::fromStdString(option.value)));
  }
  return parser.parse(arguments);
}

void failOnArguments(const QCommandLineParser& parser) {
  QString fault = parser.errorText();
  while (fault.endsWith(QLatin1Char('.'))) fault.chop(1);
  throw Error("command line", fault.toStdString(), "--help lists the options.");
}

int wholeNumber(const QString& option, const QString& value, int minimum) {
  bool valid = false;
  const int number = value.trimmed().toInt(&valid);
  if (valid && number >= minimum) return number;
  throw Error(option.toStdString(),
              "'" + value.toStdString() + "' is not a whole number from " + std::to_string(minimum),
              "Give one.");
}

std::optional<std::size_t> countOf(const QCommandLineParser& parser, const char* option) {
  const QString name = QString::fromLatin1(option);
  if (!parser.isSet(name)) return std::nullopt;
  return static_cast<std::size_t>(wholeNumber(QStringLiteral("--") + name, parser.value(name), 1));
}

std::vector<ProgramOption> parameterOptions() {
  std::vector<std::string> keys;
  for (const ParameterInfo& info : parameterTable()) keys.push_back(std::string(info.key) + '=');
  return {{"parameters", "FILE", "YAML preset with parameters"},
          {"set", "KEY=VALUE", "Set one parameter; may be given often, after --parameters", keys}};
}

void readPreset(Parameters& parameters, const QCommandLineParser& parser) {
  const QString option = QStringLiteral("parameters");
  if (parser.isSet(option)) parameters = loadPreset(parser.value(option).toStdString(), parameters);
}

void readSettings(Parameters& parameters, const QCommandLineParser& parser) {
  for (const QString& setting : parser.values(QStringLiteral("set"))) {
    const qsizetype equals = setting.indexOf(QLatin1Char('='));
    if (equals < 1) {
      throw Error("--set", "'" + setting.toStdString() + "' is not a key, '=' and a value",
                  "Write --set key=value.");
    }
    setParameter(parameters, setting.left(equals).trimmed().toStdString(),
                 setting.mid(equals + 1).trimmed().toStdString());
  }
}

ProgramOption framesOption() { return {"frames", "N", "Stop after N frames"}; }

ProgramOption helpOption() { return {"help", "", "Show this text"}; }

std::vector<ProgramOption> ownOptions(std::vector<std::string> documents, const std::string& text) {
  return {helpOption(),
          {"version", "", "Show the version"},
          {"print", "DOCUMENT", text, std::move(documents)}};
}

ProgramSection parameterSection() {
  ProgramSection section{"Parameters (key, range, default)", "", {}};
  const Parameters defaults;
  for (const ParameterInfo& info : parameterTable()) {
    std::string term(info.key);
    term += ' ' + rangeText(info) + " [" + formatValue(info, info.get(defaults)) + ']';
    section.entries.emplace_back(std::move(term), info.tooltip);
  }
  return section;
}

ProgramSection yardSection() {
  return {"Options of demo:yard (key, range, default), as in demo:yard,seed=7,rain=0.5",
          "",
          {},
          yardOptionsHelp()};
}

ProgramSection exitSection() {
  return {
      "Exit status", "", {{"0", "Done."}, {"1", "A fault in the run."}, {"2", "Bad arguments."}}};
}

}  // namespace boomwatch
