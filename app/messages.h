#pragma once

#include <QString>
#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "display.h"
#include "parameters/parameters.h"
#include "pipeline/warning_level.h"
#include "sources/player.h"
#include "tracking/tool_tracking.h"

namespace boomwatch {

struct OpenCommand {
  std::string address;
  SourceOptions options;
};
struct PlayCommand {};
struct PauseCommand {};
struct StepCommand {
  int direction = 1;
};
struct SeekCommand {
  std::size_t index = 0;
};
struct LoopCommand {
  bool loop = false;
};
struct SpeedCommand {
  double speed = 1.0;  ///< Player::unlimited: as fast as possible
};
/// Pauses for good after this many frames, and says so (News::finished).
struct StopAfterCommand {
  std::size_t frames = 1;
};
struct ToolCommand {
  ToolOrder order;
};
/// The tracker begins with the model of these files; several are merged.
struct LoadToolModelCommand {
  std::vector<std::string> files;
  bool withCurrent = false;  ///< and merged with what the tracker knows by now
};
/// What the tracker knows by now.
struct SaveToolModelCommand {
  std::string file;
};
using Command = std::variant<OpenCommand, PlayCommand, PauseCommand, StepCommand, SeekCommand,
                             LoopCommand, SpeedCommand, StopAfterCommand, ToolCommand,
                             LoadToolModelCommand, SaveToolModelCommand>;

/// To the worker. Settings: the latest wins. Commands: all of them, in order.
struct Orders {
  bool stop = false;
  std::optional<Parameters> parameters;
  std::optional<DisplayOptions> options;
  std::vector<Command> commands;
};

/// What is open, and what it is doing.
struct SourceStatus {
  QString address;                     ///< empty: nothing is open
  QString opening;                     ///< address that is being opened meanwhile; empty: none
  std::optional<PlayerStatus> player;  ///< absent: nothing is open
  bool operator==(const SourceStatus&) const = default;
};

/// Something to tell the person.
struct Notice {
  enum class Kind {
    Source,         ///< what to know of the source that was opened; no fault
    OpenFailed,     ///< the source named could not be opened; the old one goes on
    Frame,          ///< one frame could not be used
    Lost,           ///< a live source is gone
    Tool,           ///< what was asked of the tracker could not be done
    Calibration,    ///< the rows of the pair differ: the text is by how many pixels
    RowsCorrected,  ///< the same, but it is corrected
    Parameters,     ///< the parameters contradict each other; the last good ones stay in force
  };
  Kind kind = Kind::Frame;
  QString text;
  bool operator==(const Notice&) const = default;
};

/// From the worker. Display, status and figures: the latest wins. Warnings and notices: gathered.
struct News {
  DisplayPtr display;  ///< null: nothing new to draw
  /// When the frame of `display` had been read.
  std::chrono::steady_clock::time_point readAt;
  WarningLatch levels;         ///< every result's, shown or not
  std::size_t frames = 0;      ///< processed since the last news
  std::size_t skipped = 0;     ///< processed, but replaced before anybody could show them
  std::size_t lost = 0;        ///< came and went unread (live)
  double framesPerSecond = 0;  ///< over about the last second
  SourceStatus status;
  std::vector<Notice> notices;
  bool finished = false;  ///< StopAfterCommand: all frames are done, or the source has ended
};

}  // namespace boomwatch
