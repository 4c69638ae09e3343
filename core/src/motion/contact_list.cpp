#include <ricochet/motion/contact_list.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ricochet {

ContactList::ContactList(std::vector<ContactState> contacts) : records_(std::move(contacts)), order_(records_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
}

std::uint32_t ContactList::place_of(NearPair pair) const noexcept {
  const auto before = [this](std::uint32_t record, NearPair other) { return pair_of(records_[record]) < other; };
  return static_cast<std::uint32_t>(std::lower_bound(order_.begin(), order_.end(), pair, before) - order_.begin());
}

// All places are found in the old order, before a record is taken by another contact.
void ContactList::exchange(std::span<const std::uint32_t> gone, std::span<const ContactState> born) {
  next_order_.clear();
  std::vector<std::size_t> places;  // of the born
  places.reserve(born.size());
  std::size_t from = 0;
  auto leaving = gone.begin();
  const auto stay = [&](std::size_t to) {
    next_order_.insert(next_order_.end(), order_.begin() + static_cast<std::ptrdiff_t>(from),
                       order_.begin() + static_cast<std::ptrdiff_t>(to));
    from = to;
  };
  const auto stay_until = [&](std::size_t place) {
    for (; leaving != gone.end() && *leaving < place; ++leaving, ++from) stay(*leaving);
    stay(place);
  };
  for (const ContactState& c : born) {
    stay_until(place_of(pair_of(c)));
    places.push_back(next_order_.size());
    next_order_.emplace_back();
  }
  stay_until(order_.size());
  for (const std::uint32_t place : gone) vacant_.push_back(order_[place]);
  for (std::size_t k = 0; k < born.size(); ++k) next_order_[places[k]] = keep(born[k]);
  std::swap(order_, next_order_);
  born_ += born.size();
  if (born_ > order_.size()) *this = ContactList(in_order());
}

std::uint32_t ContactList::keep(const ContactState& contact) {
  if (vacant_.empty()) {
    records_.push_back(contact);
    return static_cast<std::uint32_t>(records_.size() - 1);
  }
  const std::uint32_t record = vacant_.back();
  vacant_.pop_back();
  records_[record] = contact;
  return record;
}

}  // namespace ricochet
