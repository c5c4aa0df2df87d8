#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cuesta {

/// A FIFO of a hardware queue's fixed room: at most `capacity` elements at a time, which its user sees to.
template <class T>
class Ring {
 public:
  explicit Ring(size_t capacity)
      : entries_(std::bit_ceil(capacity)), mask_(static_cast<uint32_t>(entries_.size() - 1)) {}

  bool empty() const { return head_ == tail_; }
  size_t size() const { return tail_ - head_; }
  T& front() { return entries_[head_ & mask_]; }
  const T& front() const { return entries_[head_ & mask_]; }
  /// Element k from the front.
  T& operator[](size_t k) { return entries_[(head_ + static_cast<uint32_t>(k)) & mask_]; }
  const T& operator[](size_t k) const { return entries_[(head_ + static_cast<uint32_t>(k)) & mask_]; }

  void push_back(const T& entry) { entries_[tail_++ & mask_] = entry; }
  void pop_front() { ++head_; }

 private:
  std::vector<T> entries_;
  uint32_t mask_;
  uint32_t head_ = 0, tail_ = 0;  ///< ever popped and pushed, modulo 2^32
};

}  // namespace cuesta
