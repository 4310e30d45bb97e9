#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "lab/experiments/chain_score.h"
#include "lab/experiments/masked_chain.h"
#include "lab/experiments/true_tool.h"
#include "pipeline/pipeline.h"

namespace boomwatch {

/// How much of the chain is at work; what is not is given by the simulation.
enum class ChainKind {
  MaskedCloud,  ///< exact points, crane, tool and load taken out by the truth (MaskedChain)
  MaskedDepth,  ///< the same with the depth of NoisyDepth
  TruthCloud,   ///< exact points, the load and the tool's box given
  NoisyDepth,   ///< depth as demo:yard,as=depth gives it; the load and the tool's box given
  Stereo,       ///< the pair of pictures; the load and the tool's box given
  Everything,   ///< the pair; the tool tracked from its first box, the load detected
};
inline constexpr std::array chainKinds{ChainKind::MaskedCloud, ChainKind::MaskedDepth,
                                       ChainKind::TruthCloud,  ChainKind::NoisyDepth,
                                       ChainKind::Stereo,      ChainKind::Everything};
std::string_view nameOf(ChainKind kind);

/// The truth of a frame of demo:yard; the chain's part is as yet empty. `before`, which may be
/// empty, gives the speed.
ChainFrame truthOf(const YardFrame& shown, const YardFrame& before);

/// One stage of the chain over one sequence of demo:yard,as=stereo.
class ChainStage {
 public:
  /// `seed`: of the yard.
  ChainStage(ChainKind kind, const Parameters& parameters, std::uint64_t seed);

  ChainKind kind() const { return m_kind; }
  /// Frames in their order. `truth` is of the same frame.
  void process(const YardFrame& shown, const ChainFrame& truth);
  const std::vector<ChainFrame>& frames() const { return m_frames; }

 private:
  bool isMasked() const {
    return m_kind == ChainKind::MaskedCloud || m_kind == ChainKind::MaskedDepth;
  }
  FramePtr sensed(const YardFrame& shown) const;
  MaskedChain::Outcome look(const YardFrame& shown);
  void showTool(const YardFrame& shown);

  ChainKind m_kind;
  Parameters m_parameters;
  std::uint64_t m_seed;
  TrueTool m_tool;
  Pipeline m_pipeline;
  MaskedChain m_masked;  ///< in place of m_pipeline where isMasked()
  bool m_begun = false;  ///< the tracker
  std::vector<ChainFrame> m_frames;
};

}  // namespace boomwatch
