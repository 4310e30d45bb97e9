#pragma once

#include <optional>
#include <random>
#include <vector>

#include "tracking/tool_classifier.h"
#include "tracking/tool_detector.h"
#include "tracking/tracker.h"

namespace boomwatch {

/// Tracking-Learning-Detection (Kalal, Mikolajczyk, Matas, 2012): median flow follows the tool from
/// image to image, a detector looks for it in the whole of each image, and what both say teaches
/// the detector.
class TldTracker : public Tracker {
 public:
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  void start(const ToolModel& model) override;
  Track track(const cv::Mat& image) override;
  void setLearning(bool on) override { m_learning = on; }
  std::shared_ptr<const ToolModel> model() const override;

 private:
  struct Followed {
    cv::Rect2d box;
    Likeness likeness;
  };
  std::optional<Followed> follow(const cv::Mat& grey) const;
  ScanLevels levelsOf(const cv::Mat& grey) const;
  void integrate(const std::optional<Followed>& followed, const std::vector<Detection>& detections);
  Track result(bool learnt, bool wasSeen) const;
  void learn(const cv::Mat& grey, const std::vector<Candidate>& candidates);
  void learnFerns(const cv::Mat& grey, const cv::Rect2d& box, int warps, double angle);

  std::optional<ToolClassifier> m_tool;
  cv::Mat m_last;  ///< grey, the image before; empty when it does not lead to the next
  std::optional<cv::Rect2d> m_box;
  Likeness m_likeness;
  bool m_trusted = false;  ///< the box has been the tool's without a break since it was sure
  bool m_learning = true;
  std::mt19937 m_random;
  mutable std::shared_ptr<const ToolModel> m_model;  ///< null after the tool learnt
};

}  // namespace boomwatch
