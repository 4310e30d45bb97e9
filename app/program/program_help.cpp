#include "program/program_help.h"

#include <sstream>

namespace boomwatch {
namespace {

constexpr std::size_t width = 96;

/// Lines of `text`, each behind `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string lines, line = margin, word;
  std::istringstream words(text);
  while (words >> word) {
    if (line.size() > indent && line.size() + 1 + word.size() > width) {
      lines += line + '\n';
      line = margin;
    }
    if (line.size() > indent) line += ' ';
    line += word;
  }
  return lines + line + '\n';
}

std::string entry(const std::string& term, const std::string& text) {
  return "  " + term + '\n' + wrapped(text, 6);
}

std::string optionsOf(const ProgramCommand& command) {
  std::string text = "\nOptions:\n";
  for (const ProgramOption& option : command.options) {
    text += entry(optionText(option), option.text);
  }
  return text;
}

std::string sectionText(const ProgramSection& section) {
  std::string text = '\n' + section.title + ":\n";
  if (!section.text.empty()) text += wrapped(section.text, 2);
  for (const auto& [term, meaning] : section.entries) text += entry(term, meaning);
  return text + section.table;
}

}  // namespace

std::string optionText(const ProgramOption& option) {
  return "--" + option.name + (option.value.empty() ? "" : " " + option.value);
}

std::string usageText(const Program& program, const ProgramCommand& command) {
  std::string text = program.name;
  for (const std::string& part : {command.name, command.arguments}) {
    if (!part.empty()) text += ' ' + part;
  }
  return text + " [OPTIONS]";
}

std::string helpText(const Program& program, const ProgramCommand& command) {
  return "Usage: " + usageText(program, command) + '\n' + wrapped(command.text, 0) +
         optionsOf(command);
}

std::string helpText(const Program& program) {
  std::string text = helpText(program, program.commands.front());
  if (program.commands.size() > 1) text += "\nCommands (each with its own --help):\n";
  for (const ProgramCommand& command : program.commands) {
    if (!command.name.empty()) text += entry(usageText(program, command), command.text);
  }
  for (const ProgramSection& section : program.sections) text += sectionText(section);
  return text;
}

}  // namespace boomwatch
