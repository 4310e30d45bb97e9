// How fast demo:yard makes its stereo pairs, beside the matcher that they are made for.
#include "benchmark.h"
#include "frame/stereo_rig.h"
#include "simulation/demo_source.h"
#include "stereo/stereo_stage.h"

namespace bench = boomwatch::bench;

namespace {

/// Milliseconds a pair, at places all over the path.
double millisecondsAPair(const std::string& options) {
  const std::string name = "yard" + options;
  const auto source = boomwatch::openDemoSource(name, "demo:" + name);
  std::size_t index = 0;
  return bench::medianMilliseconds(15, [&] {
    source->seek(index = (index + 41) % 600);
    source->next(std::chrono::milliseconds(0));
  });
}

}  // namespace

int main() {
  const double open =
      bench::medianMilliseconds(1, [] { boomwatch::openDemoSource("yard", "demo:yard"); });
  const double pair = millisecondsAPair("");
  const auto frame = boomwatch::openDemoSource("yard", "demo:yard")->next({}).frame;
  boomwatch::StereoStage stage;
  const double matching = bench::medianMilliseconds(
      7, [&] { stage.process(frame->left, frame->right, *frame->rig, {}); });
  bench::print("yard_open", open, "ms", "-");
  bench::print("yard_pairs_a_second", 1000.0 / pair, "1/s", ">=10");
  bench::print("yard_pair_over_stereo_matching", pair / matching, "x", "-");
  bench::print("yard_all_weather_pairs_a_second",
               1000.0 / millisecondsAPair(",exposure=1,rain=1,blur=0.5"), "1/s", "-");
  return 0;
}
