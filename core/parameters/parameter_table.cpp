#include "parameters/parameter_table.h"

#include "parameters/environment_rows.h"
#include "parameters/load_and_stereo_rows.h"

namespace boomwatch {
namespace {

using namespace table_row;

constexpr auto table = [] {
  std::array<ParameterInfo, environmentRows.size() + loadAndStereoRows.size()> all{};
  std::copy(loadAndStereoRows.begin(), loadAndStereoRows.end(),
            std::copy(environmentRows.begin(), environmentRows.end(), all.begin()));
  return all;
}();

// As many rows as leaves and no key twice, so every field of Parameters has a row.
static_assert(leafCount<Parameters>() == table.size(), "a field of Parameters has no row");
static_assert(keysUnique(table), "two rows have the same key");
static_assert(defaultsInRange(table), "a default lies outside its range");

}  // namespace

std::span<const ParameterInfo> parameterTable() { return table; }

}  // namespace boomwatch
