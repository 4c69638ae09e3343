#pragma once

#include <ricochet/motion/contact_state.hpp>
#include <ricochet/motion/linked_cells.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace ricochet {

/// Contacts in the order of their pairs (i, j). In a packing some come and go in every step: each stays where it is in
/// memory, and what is written anew is their order, four bytes a contact. Once as many have come as there are, all are
/// put side by side in their order again.
class ContactList {
 public:
  template <class List, class Contact>
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = ContactState;
    using difference_type = std::ptrdiff_t;
    using pointer = Contact*;
    using reference = Contact&;

    Iterator() = default;
    Iterator(List& list, std::size_t place) noexcept : list_(&list), place_(place) {}
    Contact& operator*() const noexcept { return (*list_)[place_]; }
    Contact* operator->() const noexcept { return &(*list_)[place_]; }
    Iterator& operator++() noexcept { return ++place_, *this; }
    // NOLINTNEXTLINE(cert-dcl21-cpp): a value of its own
    Iterator operator++(int) noexcept { return {*list_, place_++}; }
    bool operator==(const Iterator& other) const noexcept { return place_ == other.place_; }

   private:
    List* list_ = nullptr;
    std::size_t place_ = 0;
  };

  ContactList() = default;
  /// `contacts` in the order of their pairs.
  explicit ContactList(std::vector<ContactState> contacts);

  std::size_t size() const noexcept { return order_.size(); }
  bool empty() const noexcept { return order_.empty(); }
  ContactState& operator[](std::size_t place) noexcept { return records_[order_[place]]; }
  const ContactState& operator[](std::size_t place) const noexcept { return records_[order_[place]]; }
  const ContactState& front() const noexcept { return (*this)[0]; }
  auto begin() noexcept { return Iterator<ContactList, ContactState>(*this, 0); }
  auto end() noexcept { return Iterator<ContactList, ContactState>(*this, size()); }
  auto begin() const noexcept { return Iterator<const ContactList, const ContactState>(*this, 0); }
  auto end() const noexcept { return Iterator<const ContactList, const ContactState>(*this, size()); }

  /// The place of the pair's contact, or of the first one after it.
  std::uint32_t place_of(NearPair pair) const noexcept;
  /// One after the other, in a vector.
  std::vector<ContactState> in_order() const { return {begin(), end()}; }

  /// Takes away the contacts at the places `gone`, ascending, and takes in `born`, in the order of their pairs, which
  /// are not there.
  void exchange(std::span<const std::uint32_t> gone, std::span<const ContactState> born);

 private:
  std::uint32_t keep(const ContactState& contact);

  std::vector<ContactState> records_;
  std::vector<std::uint32_t> order_, next_order_;  // of records
  std::vector<std::uint32_t> vacant_;              // records
  std::size_t born_ = 0;                           // since they were side by side
};

inline NearPair pair_of(const ContactState& c) noexcept { return {c.record.i, c.record.j}; }

}  // namespace ricochet
