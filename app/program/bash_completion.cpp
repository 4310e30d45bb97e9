#include "program/bash_completion.h"

#include <algorithm>

namespace boomwatch {
namespace {

bool isPath(const std::string& value) {
  return std::ranges::any_of(std::initializer_list<const char*>{"FILE", "FOLDER", "PATH"},
                             [&](const char* word) { return value.find(word) != value.npos; });
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// What replies with words or files; an option that is neither gets no reply.
std::string reply(const std::vector<std::string>& words, bool path) {
  if (!words.empty()) {
    // A value that goes on, as "key=" does, gets no space behind it.
    const bool goesOn = words.front().back() == '=';
    return std::string(goesOn ? "compopt -o nospace; " : "") +
           "mapfile -t COMPREPLY < <(compgen -W '" + joined(words, " ") + "' -- \"$current\")";
  }
  if (!path) return ":";
  return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$current\")";
}

std::string valueCases(const ProgramCommand& command) {
  std::string text;
  for (const ProgramOption& option : command.options) {
    if (option.value.empty()) continue;
    text += "    '" + command.name + " --" + option.name + "') " +
            reply(option.words, isPath(option.value)) + "; return ;;\n";
  }
  return text;
}

std::string commandCase(const Program& program, const ProgramCommand& command) {
  std::vector<std::string> options;
  for (const ProgramOption& option : command.options) options.push_back("--" + option.name);
  std::vector<std::string> words = command.words;
  if (command.name.empty()) {
    for (const ProgramCommand& other : program.commands) {
      if (!other.name.empty()) words.push_back(other.name);
    }
  }
  const bool path = words.empty() && isPath(command.arguments);
  return "    '" + command.name + "')\n      if [[ $current == -* ]]; then\n        " +
         reply(options, false) + "\n      else\n        " + reply(words, path) + "\n      fi ;;\n";
}

}  // namespace

std::string bashCompletion(const Program& program) {
  std::string function = '_' + program.name;
  std::ranges::replace(function, '-', '_');
  std::vector<std::string> names;
  for (const ProgramCommand& command : program.commands) {
    if (!command.name.empty()) names.push_back(command.name);
  }
  std::string text = "# bash completion for " + program.name + ", made by '" + program.name +
                     " --print completion'\n" + function + "() {\n" +
                     "  local current=${COMP_WORDS[COMP_CWORD]} command=''\n"
                     "  local previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
                     "  COMPREPLY=()\n";
  if (!names.empty()) {
    text += "  if ((COMP_CWORD > 1)); then\n    case ${COMP_WORDS[1]} in\n      " +
            joined(names, " | ") + ") command=${COMP_WORDS[1]} ;;\n    esac\n  fi\n";
  }
  text += "  case \"$command $previous\" in\n";
  for (const ProgramCommand& command : program.commands) text += valueCases(command);
  text += "  esac\n  case $command in\n";
  for (const ProgramCommand& command : program.commands) text += commandCase(program, command);
  return text + "  esac\n}\ncomplete -F " + function + ' ' + program.name + '\n';
}

}  // namespace boomwatch
