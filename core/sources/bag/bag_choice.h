#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sources/bag/bag_camera.h"
#include "sources/bag/bag_file.h"

namespace boomwatch {

enum class BagKind { Stereo, Depth, Cloud };

/// Which topics of a bag are taken: indices into BagFile::topics.
struct BagChoice {
  BagKind kind = BagKind::Cloud;
  std::size_t first = 0;              ///< left pictures, depth, or clouds
  std::optional<std::size_t> second;  ///< right pictures; or colour that lies on the depth's pixels
  std::optional<BagCamera> camera;    ///< of `first`; absent where the bag has none, and of clouds
  std::optional<BagCamera> rightCamera;
};

/// Whether a topic's name says that its pictures are rectified: "rect" or "rectified" is a word of
/// it, as in image_rect_color; not in /direct/image_raw.
bool namesRectified(std::string_view topic);

/// What to write behind the file's name to choose these topics: "left=/a,right=/b".
std::string optionOf(const BagFile& bag, const BagChoice& choice);

/// Every source that the topics of a bag make, by their names, types and first messages. Of one
/// camera's pictures in several forms the best is taken: rectified before raw before compressed.
std::vector<BagChoice> choicesIn(BagFile& bag);

/// The one that `option` names ("left=/a,right=/b", "depth=/a", "depth=/a,colour=/b", "cloud=/a"),
/// or, where it is empty, the only one there is. Throws Error naming `where`: it lists the topics
/// and what can be written when there are none or several.
BagChoice chooseTopics(BagFile& bag, const std::string& option, const std::string& where);

}  // namespace boomwatch
