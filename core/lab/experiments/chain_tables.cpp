#include "lab/experiments/chain_tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "lab/experiments/statistics.h"

namespace boomwatch {
namespace {

struct Band {
  DistanceBand distances;
  const char* name;
};
constexpr std::array bands{Band{{0.0, 0.5}, "0 .. 0.5"}, Band{{0.5, 1.0}, "0.5 .. 1"},
                           Band{{1.0, 2.0}, "1 .. 2"}, Band{{2.0, 4.0}, "2 .. 4"}, Band{{}, "all"}};

/// In the order of the stages.
std::vector<ChainKind> kindsIn(std::span<const ChainRun> runs) {
  std::vector<ChainKind> kinds;
  std::ranges::copy_if(chainKinds, std::back_inserter(kinds), [&](ChainKind kind) {
    return std::ranges::any_of(runs, [&](const ChainRun& run) { return run.kind == kind; });
  });
  return kinds;
}

std::string text(std::string_view view) { return std::string(view); }
std::string kindText(YardKind kind) {
  return kind == YardKind::Nothing ? "nothing" : text(toString(kind));
}

std::vector<double> errorsOf(std::span<const ChainRun> runs, ChainKind kind, const Band& band,
                             bool againstSeen) {
  std::vector<double> errors;
  for (const ChainRun& run : runs) {
    if (run.kind == kind) {
      std::ranges::copy(distanceErrors(run.frames, againstSeen, band.distances),
                        std::back_inserter(errors));
    }
  }
  return errors;
}

double hoursOf(std::span<const ChainRun> runs, ChainKind kind) {
  double seconds = 0.0;
  for (const ChainRun& run : runs) {
    if (run.kind != kind || run.frames.empty()) continue;
    seconds += std::max(0.0, run.frames.back().stamp - run.frames.front().stamp - warmUp);
  }
  return seconds / 3600.0;
}

/// What most of the stretch had at its nearest point.
YardKind blamedIn(std::span<const ChainFrame> stretch) {
  std::map<YardKind, int> counts;
  for (const ChainFrame& frame : stretch) {
    if (frame.reported) ++counts[frame.blamed];
  }
  if (counts.empty()) return YardKind::Nothing;
  return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })
      ->first;
}

Cells faultCells(const ChainRun& run, const char* fault, const AlarmFault& where) {
  const auto stretch = std::span(run.frames).subspan(where.first, where.last - where.first + 1);
  const ChainFrame& worst =
      *std::ranges::min_element(stretch, {}, [](const ChainFrame& f) { return f.nearest(); });
  const double seconds = stretch.back().stamp - stretch.front().stamp;
  return {text(nameOf(run.kind)),
          fault,
          kindText(worst.seen ? worst.seenKind : worst.truthKind),
          where.withoutDistance ? text(toString(worst.reason)) : kindText(blamedIn(stretch)),
          std::to_string(run.seed),
          std::to_string(where.first),
          fixedText(seconds, 2),
          fixedText(worst.nearest(), 2),
          fixedText(worst.seen, 2),
          fixedText(worst.reported, 2)};
}

/// No events in `hours` of work: with 95 % certainty fewer than three divided by it.
std::string ratePerHour(std::size_t count, double hours) {
  if (hours <= 0.0) return "";
  const double rate = static_cast<double>(count) / hours;
  return count > 0 ? fixedText(rate, 1) : "0 (< " + fixedText(3.0 / hours, 1) + ")";
}

std::size_t approachesOf(const ChainRun& run, const WarningParameters& warning) {
  std::size_t approaches = 0;
  bool before = false;
  for (const ChainFrame& frame : run.frames) {
    const bool inside = frame.seen && *frame.seen <= warning.warningDistance;
    approaches += inside && !before;
    before = inside;
  }
  return approaches;
}

}  // namespace

Cells errorCells(const std::vector<double>& errors) {
  std::vector<double> sizes, opposite;
  for (const double error : errors) sizes.push_back(std::abs(error));
  for (const double error : errors) opposite.push_back(-error);
  return {fixedText(meanOf(errors), 3),
          fixedText(quantileOf(sizes, 0.5), 3),
          fixedText(quantileOf(sizes, 0.95), 3),
          fixedText(quantileOf(sizes, 0.99), 3),
          fixedText(shareAbove(errors, 0.1), 1, 100.0),
          fixedText(shareAbove(opposite, 0.1), 1, 100.0)};
}

Table chainErrors(std::span<const ChainRun> runs, bool againstSeen) {
  Table table{againstSeen ? "chain_errors_seen" : "chain_errors_all",
              againstSeen ? "Reported less true distance to what the camera sees, metres."
                          : "Reported less true distance to everything, seen or not, metres.",
              {"stage", "true distance (m)", "frames", "bias", "|e| 50 %", "95 %", "99 %",
               "> 10 cm too far (%)", "> 10 cm too near (%)"},
              {},
              2};
  for (const ChainKind kind : kindsIn(runs)) {
    for (const Band& band : bands) {
      const std::vector<double> errors = errorsOf(runs, kind, band, againstSeen);
      Cells row{text(nameOf(kind)), band.name, std::to_string(errors.size())};
      std::ranges::move(errorCells(errors), std::back_inserter(row));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string alarmDefinitions(const WarningParameters& warning) {
  const auto metres = [](double value) { return fixedText(value, 2) + " m"; };
  return "The first " + fixedText(warmUp, 1) + " s of each sequence are not judged. " +
         "**Missed**: something that has its place and that the camera sees in this frame is at "
         "most " +
         metres(warning.warningDistance) +
         " from the load, and for 150 ms or longer the level is neither warning nor collision; "
         "also when the chain says that it has no distance; those of which less is in "
         "sight there than the smallest thing that may alarm, " +
         metres(minPatch) + " x " + metres(minPatch) +
         ", are counted by themselves as well. **False**: the level is warning or collision "
         "although everything, seen or not, also persons and branches, is and for " +
         fixedText(warning.releaseDelay + promptly, 2) +
         " s (release delay and 150 ms) was farther away than " + metres(warning.warningDistance) +
         " and than the load goes in " + fixedText(warning.warningTime, 1) +
         " s at the fastest speed of the last half second, and the deadband of " +
         metres(warning.deadband) +
         " more. Two less than half a second apart are one. Without a false alarm the number in "
         "brackets is what can be excluded with 95 % certainty: three divided by the hours.";
}

Table chainAlarms(std::span<const ChainRun> runs, const WarningParameters& warning) {
  constexpr double narrow = 0.1, nearZone = 0.25;  // metres
  Table table{
      "chain_alarms",
      "Missed and false alarms.",
      {"stage", "simulated hours", "approaches", "missed", "of these without a distance",
       "of these less than 0.1 m inside the zone", "of these with less in sight than may alarm",
       "false", "of these less than 0.25 m outside it", "false an hour"},
      {},
      1};
  for (const ChainKind kind : kindsIn(runs)) {
    std::size_t approaches = 0, missed = 0, silent = 0, barely = 0, sliver = 0, wrong = 0,
                nearby = 0;
    for (const ChainRun& run : runs) {
      if (run.kind != kind) continue;
      approaches += approachesOf(run, warning);
      for (const AlarmFault& fault : missedAlarms(run.frames, warning)) {
        ++missed;
        silent += fault.withoutDistance;
        sliver += fault.ofSliver;
        const auto stretch =
            std::span(run.frames).subspan(fault.first, fault.last - fault.first + 1);
        barely += std::ranges::all_of(stretch, [&](const ChainFrame& frame) {
          return *frame.seen > warning.warningDistance - narrow;
        });
      }
      for (const AlarmFault& fault : falseAlarms(run.frames, warning)) {
        ++wrong;
        const auto stretch =
            std::span(run.frames).subspan(fault.first, fault.last - fault.first + 1);
        nearby += std::ranges::all_of(stretch, [&](const ChainFrame& frame) {
          return frame.nearest() < warning.warningDistance + nearZone;
        });
      }
    }
    const double hours = hoursOf(runs, kind);
    table.rows.push_back({text(nameOf(kind)), fixedText(hours, 3), std::to_string(approaches),
                          std::to_string(missed), std::to_string(silent), std::to_string(barely),
                          std::to_string(sliver), std::to_string(wrong), std::to_string(nearby),
                          ratePerHour(wrong, hours)});
  }
  return table;
}

Table chainFaults(std::span<const ChainRun> runs, const WarningParameters& warning) {
  Table table{"chain_faults",
              "Every missed and false alarm.",
              {"stage", "fault", "nearest is", "the chain has", "seed", "first frame", "seconds",
               "nearest (m)", "nearest seen (m)", "reported (m)"},
              {},
              4};
  for (const ChainKind kind : kindsIn(runs)) {
    for (const ChainRun& run : runs) {
      if (run.kind != kind) continue;
      for (const auto& fault : missedAlarms(run.frames, warning)) {
        table.rows.push_back(faultCells(run, "missed", fault));
      }
      for (const auto& fault : falseAlarms(run.frames, warning)) {
        table.rows.push_back(faultCells(run, "false", fault));
      }
    }
  }
  constexpr std::size_t readable = 60;
  table.inReport = table.rows.size() <= readable;
  return table;
}

Table chainReasons(std::span<const ChainRun> runs) {
  Table table{"chain_without_distance",
              "Percent of the frames without a distance, by reason.",
              {"stage", "reason", "frames (%)"},
              {},
              2};
  for (const ChainKind kind : kindsIn(runs)) {
    std::map<Reason, std::size_t> counts;
    std::size_t all = 0;
    for (const ChainRun& run : runs) {
      if (run.kind != kind) continue;
      all += run.frames.size();
      for (const ChainFrame& frame : run.frames) ++counts[frame.reason];
    }
    counts.erase(Reason::None);
    for (const auto& [reason, count] : counts) {
      const double share = static_cast<double>(count) / static_cast<double>(all);
      table.rows.push_back(
          {text(nameOf(kind)), text(toString(reason)), fixedText(share, 1, 100.0)});
    }
    if (counts.empty()) table.rows.push_back({text(nameOf(kind)), "", "0.0"});
  }
  return table;
}

Table chainFrames(std::span<const ChainRun> runs) {
  Table table{"chain_frames",
              "Every frame of every stage.",
              {"stage", "seed", "frame", "stamp_s", "truth_m", "truth_kind", "seen_m", "seen_kind",
               "moving_m", "speed_m_s", "reported_m", "reason", "level", "at_nearest_point"},
              {},
              1,
              false};
  for (const ChainRun& run : runs) {
    for (std::size_t k = 0; k < run.frames.size(); ++k) {
      const ChainFrame& frame = run.frames[k];
      table.rows.push_back(
          {text(nameOf(run.kind)), std::to_string(run.seed), std::to_string(k),
           fixedText(frame.stamp, 3), fixedText(frame.truth, 4), kindText(frame.truthKind),
           fixedText(frame.seen, 4), kindText(frame.seenKind), fixedText(frame.moving, 4),
           fixedText(frame.speed, 3), fixedText(frame.reported, 4), text(toString(frame.reason)),
           text(toString(frame.level)), frame.reported ? kindText(frame.blamed) : ""});
    }
  }
  return table;
}

Figure chainFigure(const ChainRun& run, const WarningParameters& warning) {
  Figure figure{
      "",
      "Distance against time: " + text(nameOf(run.kind)) + ", seed " + std::to_string(run.seed),
      {"time (s)", false, {}, {}},
      {"distance (m)", false, 0.0, {}},
      {{"reported", {}, Series::Kind::Line},
       {"truth, everything", {}, Series::Kind::Line},
       {"truth, what is seen", {}, Series::Kind::Line}},
      {{warning.warningDistance, warning.cautionDistance, "caution"},
       {0.0, warning.warningDistance, "warning"}},
      {}};
  for (const ChainFrame& frame : run.frames) {
    figure.series[0].samples.push_back({frame.stamp, frame.reported});
    figure.series[1].samples.push_back({frame.stamp, frame.truth});
    figure.series[2].samples.push_back({frame.stamp, frame.seen});
  }
  return figure;
}

}  // namespace boomwatch
