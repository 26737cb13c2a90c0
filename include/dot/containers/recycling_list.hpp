// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// A short list, of some dozens of elements at most, that keeps dropped elements to reuse their memory. A new element
/// has the contents of a dropped one, or of a new T, and the caller must fill it in. Addresses of elements do not
/// change.
template <typename T>
class RecyclingList {
  using Slots = std::vector<std::unique_ptr<T>>;

  template <typename Item, typename Slot>
  class Iterator {
   public:
    using iterator_category = std::bidirectional_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Item*;
    using reference = Item&;

    Iterator() = default;
    explicit Iterator(Slot slot) : slot_(slot) {}
    Item& operator*() const { return **slot_; }
    Item* operator->() const { return slot_->get(); }
    Iterator& operator++() { return ++slot_, *this; }
    Iterator& operator--() { return --slot_, *this; }
    Iterator operator++(int) { return Iterator(slot_++); }
    Iterator operator--(int) { return Iterator(slot_--); }
    bool operator==(const Iterator& other) const { return slot_ == other.slot_; }
    bool operator!=(const Iterator& other) const { return slot_ != other.slot_; }

   private:
    Slot slot_{};
  };

 public:
  /// Over the elements in their order.
  using iterator = Iterator<T, typename Slots::iterator>;
  /// The same, read only.
  using const_iterator = Iterator<const T, typename Slots::const_iterator>;

  /// Number of elements in the list.
  std::size_t size() const { return size_; }
  /// Whether there are none.
  bool empty() const { return size_ == 0; }
  /// The i-th element, i < size().
  T& operator[](std::size_t i) { return *slots_[i]; }
  /// The i-th element, i < size().
  const T& operator[](std::size_t i) const { return *slots_[i]; }
  /// The first element. @pre not empty
  T& front() { return *slots_.front(); }
  /// The first element. @pre not empty
  const T& front() const { return *slots_.front(); }
  /// The last element. @pre not empty
  T& back() { return *slots_[size_ - 1]; }
  /// The last element. @pre not empty
  const T& back() const { return *slots_[size_ - 1]; }
  /// The first element's place.
  iterator begin() { return iterator(slots_.begin()); }
  /// The place after the last element.
  iterator end() { return iterator(slots_.begin() + length()); }
  /// The first element's place.
  const_iterator begin() const { return const_iterator(slots_.begin()); }
  /// The place after the last element.
  const_iterator end() const { return const_iterator(slots_.begin() + length()); }

  /// Inserts a new element before the i-th.
  T& insert(std::size_t i) {
    if (size_ == slots_.size()) slots_.push_back(std::make_unique<T>());
    const auto place = slots_.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(place, slots_.begin() + length(), slots_.begin() + length() + 1);
    ++size_;
    return **place;
  }
  /// Puts an element at the front. It has the contents of a removed one, or is new.
  T& push_front() { return insert(0); }
  /// Puts an element at the back. It has the contents of a removed one, or is new.
  T& push_back() { return insert(size_); }

  /// Removes the first element and keeps it for later use. @pre not empty
  void pop_front() {
    std::rotate(slots_.begin(), slots_.begin() + 1, slots_.begin() + length());
    --size_;
  }
  /// Removes the last element and keeps it for later use. @pre not empty
  void pop_back() { --size_; }
  /// Removes all elements and keeps them for later use.
  void clear() noexcept { size_ = 0; }

  /// Drops the elements for which `condition` holds; the others keep their order.
  template <typename Condition>
  void drop_if(Condition&& condition) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i)
      if (!condition(std::as_const(*slots_[i]))) std::swap(slots_[kept++], slots_[i]);
    size_ = kept;
  }

 private:
  std::ptrdiff_t length() const { return static_cast<std::ptrdiff_t>(size_); }

  Slots slots_;  ///< the first size_ of them are the list
  std::size_t size_ = 0;
};

/// Keeps a list of past frames short at any frame rate. Call it before a new frame is added: the newest is dropped if
/// the one before it is closer than 1/32 of the time that the list spans.
/// @param newest_first its elements have a `timestamp`, seconds. @param span seconds.
template <typename T>
void thin_newest(RecyclingList<T>& newest_first, double span) {
  constexpr int kMostFrames = 32;
  if (newest_first.size() >= 2 && newest_first[0].timestamp - newest_first[1].timestamp < span / kMostFrames)
    newest_first.pop_front();
}

DOT_END_NAMESPACE
