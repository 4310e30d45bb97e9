#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "tracking/tool_model.h"
#include "tracking/tracker.h"

namespace boomwatch::test {

/// What a FakeTracker is told to see, and what was done with it and its like.
struct TrackerScript {
  /// Of the image it is given; the box it was begun with where it is not set.
  std::function<Track(const cv::Mat&)> see;
  bool keepsModel = true;
  std::vector<TrackerKind> made;
  std::vector<cv::Rect2d> boxes;      ///< of each start(image, box)
  std::vector<cv::Mat> startImages;   ///< of each start(image, box)
  std::vector<cv::Size> modelStarts;  ///< the model's size, of each start(model)
  bool learning = true;
  int rejections = 0;
};

/// Does as the script says, and judges boxes as every Tracker has to.
class FakeTracker : public Tracker {
 public:
  explicit FakeTracker(std::shared_ptr<TrackerScript> script) : m_script(std::move(script)) {}

  void start(const cv::Mat& image, const cv::Rect2d& box) override {
    requireStart(image, box);
    m_script->boxes.push_back(box);
    m_script->startImages.push_back(image);
    m_box = box;
  }
  void start(const ToolModel& model) override {
    if (!m_script->keepsModel) Tracker::start(model);
    m_script->modelStarts.push_back(model.size);
  }
  Track track(const cv::Mat& image) override {
    if (!isTrackable(image)) return Track::lost();
    if (m_script->see) return m_script->see(image);
    return {TrackState::Tracked, m_box, 0.8, LearningState::On};
  }
  void reject() override { ++m_script->rejections; }
  void setLearning(bool on) override { m_script->learning = on; }
  std::shared_ptr<const ToolModel> model() const override {
    if (!m_script->keepsModel) return nullptr;
    auto model = std::make_shared<ToolModel>();
    model->size = m_box.size();
    return model;
  }

 private:
  std::shared_ptr<TrackerScript> m_script;
  cv::Rect2d m_box;
};

/// What a ToolTracking or a Pipeline is given: every kind but Manual is a FakeTracker.
inline std::function<std::unique_ptr<Tracker>(TrackerKind)> fakeTrackers(
    const std::shared_ptr<TrackerScript>& script) {
  return [script](TrackerKind kind) -> std::unique_ptr<Tracker> {
    script->made.push_back(kind);
    if (kind == TrackerKind::Manual) return nullptr;
    return std::make_unique<FakeTracker>(script);
  };
}

}  // namespace boomwatch::test
