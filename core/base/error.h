#pragma once

#include <stdexcept>
#include <string>

namespace boomwatch {

/// A fault in what was set up: a file, a calibration, a device, a parameter.
///
/// The message is one a person can act on: what is wrong, where (file and line, key, device), and
/// what to do. Thrown while something is opened or set; caught once, in main or in the worker.
/// Faults of single frames are values (see ReadResult, Reason), never exceptions.
class Error : public std::runtime_error {
 public:
  /// `where` names the file, key or device; `what` says what is wrong with it; `remedy` what to do.
  Error(const std::string& where, const std::string& what, const std::string& remedy)
      : std::runtime_error(where + ": " + what + ". " + remedy) {}
};

}  // namespace boomwatch
