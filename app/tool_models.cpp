#include "tool_models.h"
#include "tracking/tool_model_file.h"

#include <vector>

namespace boomwatch {

std::shared_ptr<const ToolModel> loadToolModels(std::span<const std::string> files) {
  std::vector<ToolModel> models;
  for (const std::string& file : files) models.push_back(loadToolModel(file));
  if (models.size() == 1) return std::make_shared<const ToolModel>(std::move(models.front()));
  return std::make_shared<const ToolModel>(mergeToolModels(models));
}

}  // namespace boomwatch
