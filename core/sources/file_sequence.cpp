#include "sources/file_sequence.h"

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

/// The digits at `position` without leading zeros; moves `position` past them.
std::string_view takeNumber(std::string_view text, std::size_t& position) {
  std::size_t end = position;
  while (end < text.size() && isDigit(text[end])) ++end;
  std::size_t begin = position;
  while (begin + 1 < end && text[begin] == '0') ++begin;
  position = end;
  return text.substr(begin, end - begin);
}

std::optional<double> secondsOfDate(std::string_view text) {
  // YYYYMMDDThhmmss[.fraction]
  if (text.size() < 15 || text[8] != 'T') return std::nullopt;
  const auto part = [&](std::size_t begin, std::size_t length) {
    return toNumber<unsigned>(text.substr(begin, length));
  };
  const auto year = part(0, 4), month = part(4, 2), day = part(6, 2);
  const auto hour = part(9, 2), minute = part(11, 2);
  const auto second = toNumber<double>(text.substr(13));
  if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(*month), std::chrono::day(*day));
  if (!date.ok() || *hour > 23 || *minute > 59 || !(*second >= 0.0 && *second < 61.0)) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * *hour + 60.0 * *minute + *second;
}

}  // namespace

bool naturalOrder(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view x = takeNumber(a, i), y = takeNumber(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
    }
  }
  if (i < a.size() || j < b.size()) return i >= a.size();
  return a < b;  // "f1" and "f01" must not be equal
}

std::vector<std::filesystem::path> listFiles(
    const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& wanted) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code fault;
  for (fs::directory_iterator it(folder, fault), end; !fault && it != end; it.increment(fault)) {
    std::error_code unknown;
    if (it->is_regular_file(unknown) && wanted(it->path())) files.push_back(it->path());
  }
  if (fault) {
    throw Error(folder.string(), "cannot be listed: " + fault.message(), "Check the path.");
  }
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    return naturalOrder(a.filename().native(), b.filename().native());
  });
  return files;
}

std::optional<double> stampFromName(std::string_view stem) {
  if (const auto underscore = stem.rfind('_'); underscore != std::string_view::npos) {
    if (const auto date = secondsOfDate(stem.substr(underscore + 1))) return date;
  }
  if (const auto date = secondsOfDate(stem)) return date;
  if (stem.empty() || !std::ranges::all_of(stem, [](char c) { return isDigit(c) || c == '.'; })) {
    return std::nullopt;
  }
  const auto value = toNumber<double>(stem);
  if (!value) return std::nullopt;
  // Times since 1970 that lie after 2001: 10 digits of seconds.
  const bool hasPoint = stem.find('.') != std::string_view::npos;
  if (hasPoint && *value >= 1e9 && *value < 1e10) return *value;
  if (!hasPoint && stem.size() == 16)
    return *value >= 1e15 ? std::optional(*value * 1e-6) : std::nullopt;
  if (!hasPoint && stem.size() == 19)
    return *value >= 1e18 ? std::optional(*value * 1e-9) : std::nullopt;
  return std::nullopt;
}

std::vector<double> stampsOf(const std::vector<std::filesystem::path>& files, double rate) {
  std::vector<double> stamps;
  for (const auto& file : files) {
    const auto stamp = stampFromName(file.stem().native());
    if (!stamp || (!stamps.empty() && *stamp <= stamps.back())) break;
    stamps.push_back(*stamp);
  }
  if (stamps.size() == files.size()) return stamps;
  stamps.clear();
  for (std::size_t k = 0; k < files.size(); ++k) stamps.push_back(static_cast<double>(k) / rate);
  return stamps;
}

double meanRate(const std::vector<double>& stamps, double otherwise) {
  const double span = stamps.empty() ? 0.0 : stamps.back() - stamps.front();
  return span > 0.0 ? static_cast<double>(stamps.size() - 1) / span : otherwise;
}

}  // namespace boomwatch
