#include "cloud/voxel_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// std::floor without the call that it is on a processor before SSE 4.1.
inline float floorOf(float value) {
  constexpr float allWhole = 8388608.0F;  // 2^23: from here on a float has no fraction
  if (!(std::abs(value) < allWhole)) return value;
  const auto whole = static_cast<float>(static_cast<int>(value));
  return whole > value ? whole - 1.0F : whole;
}

struct Key {
  Vector3f cell;           ///< whole numbers, as floats: they hold any coordinate a float holds
  std::uint64_t hash = 0;  ///< of the cell: its first bits say where to look
};

Key keyOf(const Vector3f& position) {
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio: spreads the bits
  const Vector3f cell(floorOf(position.x()), floorOf(position.y()), floorOf(position.z()));
  std::uint64_t hash = std::bit_cast<std::uint32_t>(cell.x());
  hash = hash * golden + std::bit_cast<std::uint32_t>(cell.y());
  hash = (hash ^ (hash >> 32)) * golden + std::bit_cast<std::uint32_t>(cell.z());
  hash = (hash ^ (hash >> 32)) * golden;
  return {cell, hash};
}

/// In one cache line: most of the time goes by waiting for memory.
struct alignas(64) Voxel {
  Key key;
  Vector3f first;
  Vector3f sum = Vector3f::Zero();  ///< from the first point, where floats are fine enough
  std::uint32_t count = 0;
};

/// Finds voxels by their cell: a hash table with open addressing over a list.
class VoxelTable {
 public:
  explicit VoxelTable(std::size_t points) { resize(std::bit_ceil(points / 2 + 2)); }

  /// Has the slot that `at` will look at brought from memory, meanwhile.
  void prefetchSlot(const Key& key) const { __builtin_prefetch(&m_slots[key.hash >> m_shift]); }
  /// The voxel, once the slot is there.
  void prefetchVoxel(const Key& key) const {
    const std::uint32_t voxel = m_slots[key.hash >> m_shift];
    if (voxel != empty) __builtin_prefetch(&m_voxels[voxel]);
  }

  /// The voxel of the key's cell; one that begins with `point` if there is none yet.
  Voxel& at(const Key& key, const Vector3f& point) {
    // Neighbouring pixels mostly lie in the same voxel.
    if (!m_voxels.empty() && m_voxels[m_last].key.cell == key.cell) return m_voxels[m_last];
    std::size_t slot = slotOf(key);
    if (m_slots[slot] == empty) {
      if (2 * m_voxels.size() >= m_slots.size()) {
        resize(2 * m_slots.size());
        slot = slotOf(key);
      }
      m_slots[slot] = static_cast<std::uint32_t>(m_voxels.size());
      m_voxels.push_back({key, point});
    }
    m_last = m_slots[slot];
    return m_voxels[m_last];
  }

  const std::vector<Voxel>& voxels() const { return m_voxels; }

 private:
  static constexpr std::uint32_t empty = 0xFFFFFFFF;

  /// Where the cell is, or the empty slot where it belongs.
  std::size_t slotOf(const Key& key) const {
    std::size_t slot = key.hash >> m_shift;
    while (m_slots[slot] != empty && m_voxels[m_slots[slot]].key.cell != key.cell) {
      slot = (slot + 1) & (m_slots.size() - 1);
    }
    return slot;
  }

  /// `size`: a power of two.
  void resize(std::size_t size) {
    m_slots.assign(size, empty);
    m_shift = 64 - (static_cast<int>(std::bit_width(size)) - 1);
    for (std::uint32_t k = 0; k < m_voxels.size(); ++k) m_slots[slotOf(m_voxels[k].key)] = k;
  }

  std::vector<std::uint32_t> m_slots;
  std::vector<Voxel> m_voxels;
  std::uint32_t m_last = 0;
  int m_shift = 0;  ///< keeps as many of a hash's best bits, its first, as number the slots
};

}  // namespace

Points voxelCentroids(std::span<const Vector3f> points, double leaf, const Vector3f& origin) {
  // In floats, as PCL: then both put a point on the border of two cubes into the same one.
  const float inverse = 1.0F / static_cast<float>(leaf);
  VoxelTable table(points.size());
  std::array<Key, 32> keys;
  for (; !points.empty(); points = points.subspan(std::min(keys.size(), points.size()))) {
    const auto some = points.first(std::min(keys.size(), points.size()));
    for (std::size_t k = 0; k < some.size(); ++k) {
      keys[k] = keyOf((some[k] - origin) * inverse);
      table.prefetchSlot(keys[k]);
    }
    for (std::size_t k = 0; k < some.size(); ++k) table.prefetchVoxel(keys[k]);
    for (std::size_t k = 0; k < some.size(); ++k) {
      Voxel& voxel = table.at(keys[k], some[k]);
      voxel.sum += some[k] - voxel.first;
      ++voxel.count;
    }
  }
  Points centroids;
  centroids.reserve(table.voxels().size());
  for (const Voxel& voxel : table.voxels()) {
    centroids.push_back(voxel.first + voxel.sum / static_cast<float>(voxel.count));
  }
  return centroids;
}

}  // namespace boomwatch
