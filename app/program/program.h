#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boomwatch {

/// One option of a program: a row from which --help, the manual page and the completion are made.
struct ProgramOption {
  std::string name;   ///< without the dashes
  std::string value;  ///< what --help calls its value; empty: it takes none
  std::string text;   ///< what it does, a sentence without its full stop
  /// Values that the completion offers. Empty: files, where `value` is FILE, FOLDER or PATH.
  std::vector<std::string> words{};
};

/// What a program does under one name, with the options it takes there.
struct ProgramCommand {
  std::string name;       ///< empty: the program itself
  std::string arguments;  ///< those without dashes, as --help shows them: "FOLDER..."
  std::string text;       ///< what it does, whole sentences
  std::vector<ProgramOption> options;
  std::vector<std::string> words{};  ///< arguments that the completion offers
};

/// A list at the end of --help and of the manual page.
struct ProgramSection {
  std::string title;
  std::string text;                                          ///< before the entries
  std::vector<std::pair<std::string, std::string>> entries;  ///< a term and what it means
  std::string table{};                                       ///< lines that stay as they are
};

/// All that a program says about itself. English, whatever the window speaks.
struct Program {
  std::string name;
  std::string version;
  std::string summary;                   ///< half a line for the manual page
  std::vector<ProgramCommand> commands;  ///< the nameless one first
  std::vector<ProgramSection> sections;
  std::string seeAlso;  ///< another program with a manual page

  const ProgramCommand* find(const std::string& command) const {
    for (const ProgramCommand& one : commands) {
      if (one.name == command) return &one;
    }
    return nullptr;
  }
};

}  // namespace boomwatch
