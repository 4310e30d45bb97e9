#pragma once

#include <optional>
#include <vector>

#include "tracking/cmt_tracker.h"
#include "tracking/colour_layout.h"
#include "tracking/detection.h"
#include "tracking/last_appearance.h"
#include "tracking/median_flow.h"
#include "tracking/scan_levels.h"
#include "tracking/tool_classifier.h"
#include "tracking/tool_learning.h"
#include "tracking/tracker.h"

namespace boomwatch {

/// Tracking-Learning-Detection (Kalal, Mikolajczyk, Matas, PAMI 2012): median flow follows the tool
/// from image to image, a detector looks for it in the whole of each image, and what both agree on
/// teaches the detector. Beside the flow, and against its drift, the keypoints of the first box are
/// looked for around the tool (CmtTracker); that box is taken which looks more like the older half
/// of the model. Where neither is sure, as when the tool has turned, its colours decide
/// (ColourLayout); what comes back from behind something is known by its last look
/// (LastAppearance). A tracker that began with a saved model has no keypoints, and learns the
/// colours when it is first sure of the tool.
///
/// The guard against "explosion", a model that fills with what is not the tool: an image teaches
/// only while the box is trusted and the detector sees the tool nowhere else. Trust begins with the
/// operator's box, ends when the tool is lost, jumped to or no longer recognised, and returns when
/// the followed box looks like the older, surer half of the model.
class TldTracker : public Tracker {
 public:
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  void start(const ToolModel& model) override;
  Track track(const cv::Mat& image) override;
  void reject() override;
  void setLearning(bool on) override { m_learns = on; }
  std::shared_ptr<const ToolModel> model() const override;

 private:
  void begin(ToolClassifier tool);
  Detection judged(const cv::Mat& grey, const cv::Rect2d& box) const;
  std::optional<Detection> flow(const cv::Mat& grey);       // by median flow
  std::optional<Detection> consensus(const cv::Mat& grey);  // by keypoints
  ScanLevels levelsOf(const cv::Mat& grey) const;
  std::vector<Candidate> sharpened(const cv::Mat& grey, std::vector<Candidate> candidates) const;
  std::vector<Detection> detect(const cv::Mat& image, const cv::Mat& grey,
                                const std::vector<Candidate>& candidates) const;
  void integrate(const cv::Mat& grey, const std::optional<Detection>& followed,
                 const std::vector<Detection>& detections);
  bool isDisputed(const std::vector<Detection>& detections) const;
  bool learn(const cv::Mat& grey, const ScanLevels& levels,
             const std::vector<Candidate>& candidates);
  bool isSure() const;
  void askColours(const cv::Mat& image, const cv::Mat& grey,
                  const std::vector<ColourLayout::Place>& places);
  std::optional<Detection> cameBack(const cv::Mat& image, const cv::Mat& grey,
                                    const cv::Rect2d& box) const;
  void lose();

  std::optional<ToolClassifier> m_tool;
  ToolLearning m_learning;
  bool m_learns = true;
  cv::Mat m_before;                  ///< grey, the image before; empty when nothing leads from it
  std::optional<Detection> m_found;  ///< where the tool is; absent while it is lost
  FlowCells m_cells;                 ///< of the tool's box
  CmtTracker m_keypoints{KeypointReach::DensePart};  ///< idle where there were too few
  bool m_trusted = false;                            ///< see the class
  ColourLayout m_colours;
  LastAppearance m_recent;
  int m_images = 0;         ///< since it began
  double m_scale = 1.0;     ///< of the tool when it was last seen, against the model's
  int m_imagesLost = 0;     ///< since it was last seen
  int m_imagesDoubted = 0;  ///< since the followed box last looked like the tool
  mutable std::shared_ptr<const ToolModel> m_model;  ///< null after the tool was learnt from
};

}  // namespace boomwatch
