#include "program/manual_page.h"

#include <algorithm>
#include <cctype>

#include "program/program_help.h"

namespace boomwatch {
namespace {

/// Text as troff prints it: backslashes and dashes as they are, no line that is taken for a macro.
std::string troff(const std::string& text) {
  std::string result;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && (c == '.' || c == '\'')) result += "\\&";
    lineBegins = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string bold(const std::string& text) { return "\\fB" + troff(text) + "\\fR"; }

std::string heading(const std::string& title) { return ".SH " + troff(upper(title)) + '\n'; }

std::string entry(const std::string& term, const std::string& text) {
  return ".TP\n" + term + '\n' + troff(text) + '\n';
}

std::string optionEntry(const ProgramOption& option) {
  std::string term = bold("--" + option.name);
  if (!option.value.empty()) term += " \\fI" + troff(option.value) + "\\fR";
  return entry(term, option.text + '.');
}

std::string commandText(const ProgramCommand& command) {
  std::string text = ".SS " + troff(command.name + ' ' + command.arguments) + '\n';
  text += troff(command.text) + '\n';
  for (const ProgramOption& option : command.options) text += optionEntry(option);
  return text;
}

std::string sectionText(const ProgramSection& section) {
  std::string text = heading(section.title);
  if (!section.text.empty()) text += troff(section.text) + '\n';
  for (const auto& [term, meaning] : section.entries) text += entry(bold(term), meaning);
  if (!section.table.empty()) text += ".PP\n.nf\n" + troff(section.table) + ".fi\n";
  return text;
}

}  // namespace

std::string manualPage(const Program& program) {
  const ProgramCommand& itself = program.commands.front();
  std::string text = ".TH " + upper(program.name) + " 1 \"\" \"Boomwatch " + program.version +
                     "\" \"User Commands\"\n";
  text += heading("name") + troff(program.name) + " \\- " + troff(program.summary) + '\n';
  text += heading("synopsis");
  const bool hasCommands = program.commands.size() > 1;
  for (const ProgramCommand& command : program.commands) {
    if (hasCommands && command.name.empty()) continue;
    text += bold(usageText(program, command)) + "\n.br\n";
  }
  text += heading("description") + troff(itself.text) + '\n';
  text += heading("options");
  for (const ProgramOption& option : itself.options) text += optionEntry(option);
  if (hasCommands) text += heading("commands");
  for (const ProgramCommand& command : program.commands) {
    if (!command.name.empty()) text += commandText(command);
  }
  for (const ProgramSection& section : program.sections) text += sectionText(section);
  return text + heading("see also") + bold(program.seeAlso) + "(1)\n";
}

}  // namespace boomwatch
