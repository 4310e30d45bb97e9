#include "display.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "patch_strip.h"

namespace boomwatch {
namespace {

using Rgba = DrawnCloud::Rgba;

QImage cameraImage(const cv::Mat& image) {
  if (image.empty()) return {};
  QImage::Format format = QImage::Format_Invalid;
  if (image.type() == CV_8UC1) format = QImage::Format_Grayscale8;
  if (image.type() == CV_8UC3) format = QImage::Format_BGR888;
  if (format == QImage::Format_Invalid) return {};
  // Another format on purpose: it makes a copy of its own, and it is the one that paints fastest.
  return QImage(image.data, image.cols, image.rows, static_cast<qsizetype>(image.step), format)
      .convertToFormat(QImage::Format_RGB32);
}

QRgb packed(const Rgba& colour) { return qRgb(colour[0], colour[1], colour[2]); }

/// One pixel a cell; cells that were never observed stay transparent, and the map hatches them.
template <class Brightness>
QImage mapImage(const EnvironmentModel& model, MapColouring colouring, Brightness brightness) {
  const GridGeometry& geometry = model.geometry();
  QImage image(geometry.columns(), geometry.rows(), QImage::Format_ARGB32_Premultiplied);
  if (image.isNull()) return image;
  const auto table = colourTable(colouring);
  std::array<QRgb, 256> colours{};
  std::transform(table.begin(), table.end(), colours.begin(), packed);
  for (int row = 0; row < geometry.rows(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    const std::size_t first = geometry.index(0, row);
    const auto probabilities = model.probabilities().subspan(first);
    const auto levels = model.levels().subspan(first);
    for (int column = 0; column < geometry.columns(); ++column) {
      const float probability = probabilities[static_cast<std::size_t>(column)];
      const std::uint8_t level = levels[static_cast<std::size_t>(column)];
      const bool observed = probability > 0.0F || level > 0;
      line[column] = observed ? colours[brightness(probability, level)] : 0U;
    }
  }
  return image;
}

QImage modelImage(const EnvironmentModel& model, MapColouring colouring) {
  return mapImage(model, colouring, [](float, std::uint8_t level) {
    return level > 0 ? brightnessOfLevel(level) : freeBrightness;
  });
}

QImage probabilityImage(const EnvironmentModel& model, const ModelParameters& parameters,
                        MapColouring colouring) {
  const auto full = static_cast<float>(maxProbability(parameters));
  return mapImage(model, colouring, [full](float probability, std::uint8_t) {
    const float share = std::clamp(probability / full, 0.0F, 1.0F);
    return static_cast<std::uint8_t>(freeBrightness + share * (255 - freeBrightness) + 0.5F);
  });
}

/// Gives every point of a cloud its colour.
class Colouring {
 public:
  Colouring(const Result& result, CloudColouring by)
      : m_table(colourTable(MapColouring::Uniform)), m_image(result.image) {
    const Bounds& bounds = result.parameters.bounds;
    const bool height = by == CloudColouring::Height;
    // Nearer is brighter, and so is higher; y points down.
    m_axis = height ? 1 : 2;
    m_far = static_cast<float>(height ? bounds.yMax : bounds.zMax);
    const auto near = static_cast<float>(height ? bounds.yMin : bounds.zMin);
    m_perMetre = static_cast<float>(255 - darkestPointColour) / (m_far - near);
    m_byImage = by == CloudColouring::Image;
  }

  Rgba operator()(std::size_t index, const Eigen::Vector3f& point) const {
    if (m_byImage) return fromImage(index);
    const float brightness =
        static_cast<float>(darkestPointColour) + (m_far - point[m_axis]) * m_perMetre;
    return m_table[static_cast<std::size_t>(std::clamp(brightness, 0.0F, 255.0F))];
  }

 private:
  Rgba fromImage(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(m_image.cols);
    const int row = static_cast<int>(index / columns);
    const int column = static_cast<int>(index % columns);
    const std::uint8_t* pixel = m_image.ptr(row) + column * m_image.channels();
    if (m_image.channels() < 3) return {pixel[0], pixel[0], pixel[0], 255};
    return {pixel[2], pixel[1], pixel[0], 255};
  }

  std::array<Rgba, 256> m_table;
  cv::Mat m_image;
  Eigen::Index m_axis = 2;
  float m_far = 0.0F;
  float m_perMetre = 0.0F;
  bool m_byImage = false;
};

/// Points that are drawn in red as removed are not drawn a second time underneath.
bool drawnAsRemoved(const Result& result, const Eigen::Vector3f& point) {
  if (result.scene.removed.empty()) return false;
  const Eigen::Vector3d p = point.cast<double>();
  return (result.load && result.load->contains(p)) ||
         (result.scene.toolBox && result.scene.toolBox->contains(p));
}

bool pictureMatchesCloud(const Result& result) {
  return result.cloud && !result.image.empty() && result.cloud->width == result.image.cols &&
         result.cloud->height == result.image.rows;
}

DrawnCloud drawnCloud(const Result& result, CloudColouring by) {
  DrawnCloud drawn;
  if (!result.cloud) return drawn;
  const Points& points = result.cloud->points;
  const Colouring colour(result, by);
  drawn.points.reserve(points.size());
  drawn.colours.reserve(points.size());
  auto add = [&](std::size_t k) {
    const Eigen::Vector3f& p = points[k];
    // A point that was not measured is NaN, and no NaN is inside the bounds.
    if (!result.parameters.bounds.contains(p) || drawnAsRemoved(result, p)) return;
    drawn.points.push_back(p);
    drawn.colours.push_back(colour(k, p));
  };
  // A prime number of layers does not fall into step with the usual picture widths; going through
  // them in strides of five spreads the first few.
  constexpr std::size_t layers = DrawnCloud::layerCount;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for (std::size_t k = layer * 5 % layers; k < points.size(); k += layers) add(k);
    drawn.layerEnds[layer] = drawn.points.size();
  }
  return drawn;
}

}  // namespace

std::array<Rgba, 256> colourTable(MapColouring colouring) {
  std::array<Rgba, 256> table{};
  cv::Mat ramp(1, 256, CV_8UC1);
  for (int k = 0; k < 256; ++k) ramp.at<std::uint8_t>(k) = static_cast<std::uint8_t>(k);
  cv::Mat colours;
  if (colouring == MapColouring::Uniform) {
    cv::applyColorMap(ramp, colours, cv::COLORMAP_CIVIDIS);
  } else {
    cv::cvtColor(ramp, colours, cv::COLOR_GRAY2BGR);
  }
  for (int k = 0; k < 256; ++k) {
    const auto& bgr = colours.at<cv::Vec3b>(k);
    table[static_cast<std::size_t>(k)] = {bgr[2], bgr[1], bgr[0], 255};
  }
  return table;
}

std::uint8_t brightnessOfLevel(std::uint8_t level) {
  return static_cast<std::uint8_t>(255 - (level - 1) * (255 - maxBrightness) / 254);
}

DisplayPtr makeDisplay(const ResultPtr& result, const DisplayOptions& options) {
  auto display = std::make_shared<Display>();
  display->result = result;
  display->options = options;
  if (!result) return display;
  display->camera = cameraImage(result->image);
  if (result->model) {
    display->probability = probabilityImage(*result->model, result->parameters.model, options.maps);
    display->model = modelImage(*result->model, options.maps);
  }
  if (result->tool.model) display->patches = patchStrip(*result->tool.model);
  const bool matches = pictureMatchesCloud(*result);
  const bool colourable = matches && !display->camera.isNull();
  const bool byDepth = options.cloud == CloudColouring::Image && !colourable;
  display->cloudColouring = byDepth ? CloudColouring::Depth : options.cloud;
  display->cloud = drawnCloud(*result, display->cloudColouring);
  if (matches) display->projection = result->cloud->camera;
  return display;
}

}  // namespace boomwatch
